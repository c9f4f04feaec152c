//! Content of universal files.

use faer::c64;

/// Universal file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct UnvFile {
    /// Datasets in the order of the file.
    pub datasets: Vec<UnvDataset>,
    /// Line of the first delimiter of each dataset, from 1; empty if the content was not read.
    pub lines: Vec<usize>,
    /// Datasets of other numbers.
    pub skipped: Vec<SkippedDataset>,
}

impl UnvFile {
    /// Returns where a dataset is, such as `dataset 55 at line 12`; `index` is that of the list.
    pub fn place(&self, index: usize) -> String {
        let number = self.datasets.get(index).map_or(0, UnvDataset::number);
        match self.lines.get(index) {
            Some(line) => format!("dataset {number} at line {line}"),
            None => format!("dataset {number}, number {} of the file", index + 1),
        }
    }

    /// Returns the factor by which lengths of the file are divided to be in m: that of the last
    /// dataset 164, or 1.
    pub fn length_factor(&self) -> f64 {
        self.units().map_or(1.0, |units| units.factors[0])
    }

    /// Returns the factor by which forces of the file are divided to be in N, like
    /// [`UnvFile::length_factor`].
    pub fn force_factor(&self) -> f64 {
        self.units().map_or(1.0, |units| units.factors[1])
    }

    fn units(&self) -> Option<&Units> {
        self.datasets.iter().rev().find_map(|dataset| match dataset {
            UnvDataset::Units(units) => Some(units),
            _ => None,
        })
    }
}

/// Dataset that the reader skipped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SkippedDataset {
    /// Number of the dataset.
    pub number: u32,
    /// Line of its first delimiter, from 1.
    pub line: usize,
}

/// Dataset of a supported number.
#[derive(Clone, Debug, PartialEq)]
pub enum UnvDataset {
    /// 151: header.
    Header(Header),
    /// 164: units.
    Units(Units),
    /// 2411: nodes.
    Nodes(Vec<Node>),
    /// 2412: elements.
    Elements(Vec<Element>),
    /// 82: trace line.
    TraceLine(TraceLine),
    /// 55: results at nodes.
    NodalData(NodalData),
    /// 58: function at a degree of freedom.
    Function(Box<Function>),
    /// 2414: results at nodes or elements.
    AnalysisData(Box<AnalysisData>),
}

impl UnvDataset {
    /// Returns the number of the dataset.
    pub fn number(&self) -> u32 {
        match self {
            Self::Header(_) => 151,
            Self::Units(_) => 164,
            Self::Nodes(_) => 2411,
            Self::Elements(_) => 2412,
            Self::TraceLine(_) => 82,
            Self::NodalData(_) => 55,
            Self::Function(_) => 58,
            Self::AnalysisData(_) => 2414,
        }
    }
}

/// Header of a model file (151).
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Header {
    /// Lines of the dataset: name, description, program, dates and versions, up to 80 characters
    /// each.
    pub lines: Vec<String>,
}

/// Units (164).
#[derive(Clone, Debug, PartialEq)]
pub struct Units {
    /// Code: 1 for SI, 5 for mm and N.
    pub code: i64,
    /// Description, up to 20 characters.
    pub description: String,
    /// Temperature mode: 1 for absolute, 2 for relative.
    pub temperature_mode: i64,
    /// Factors of length, force and temperature: SI quantities times these are in the file's units.
    pub factors: [f64; 3],
    /// Offset of the temperature.
    pub offset: f64,
}

impl Units {
    /// Returns SI units.
    pub fn si() -> Self {
        Self {
            code: 1,
            description: "SI: Meter (newton)".into(),
            temperature_mode: 2,
            factors: [1.0; 3],
            offset: 273.15,
        }
    }
}

/// Node (2411).
#[derive(Clone, Debug, PartialEq)]
pub struct Node {
    /// Label.
    pub label: i64,
    /// Export coordinate system, displacement coordinate system, colour.
    pub attributes: [i64; 3],
    /// Position in the units of the file.
    pub position: [f64; 3],
}

/// Element (2412).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Element {
    /// Label.
    pub label: i64,
    /// Descriptor: 41 and 91 for triangles, 44 and 94 for quadrilaterals, 111 for tetrahedra, 115
    /// for hexahedra.
    pub descriptor: i64,
    /// Physical property table, material property table, colour.
    pub attributes: [i64; 3],
    /// Orientation node and end cross-sections; only for beams.
    pub beam: Option<[i64; 3]>,
    /// Labels of the nodes.
    pub nodes: Vec<i64>,
}

impl Element {
    /// Returns whether elements of a descriptor have a record of beam properties.
    pub fn is_beam(descriptor: i64) -> bool {
        (21..=24).contains(&descriptor)
    }
}

/// Trace line (82): polyline through nodes for display.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TraceLine {
    /// Number.
    pub number: i64,
    /// Colour.
    pub color: i64,
    /// Identification.
    pub name: String,
    /// Labels of the nodes; 0 lifts the pen.
    pub nodes: Vec<i64>,
}

/// Kind of a result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ResultKind {
    /// Model type: 1 for structural.
    pub model: i64,
    /// Analysis type: 1 static, 2 normal modes, 4 transient, 5 frequency response.
    pub analysis: i64,
    /// Data characteristic: 1 scalar, 2 vector, 3 vector of six components.
    pub characteristic: i64,
    /// Result type or specific data type: 8 displacement, 11 velocity, 12 acceleration, 15
    /// pressure.
    pub quantity: i64,
}

/// Values at a node or an element: real or complex.
#[derive(Clone, Debug, PartialEq)]
pub struct LocatedValues {
    /// Label of the node or element.
    pub label: i64,
    /// Values.
    pub values: Vec<c64>,
}

/// Results at nodes (55).
#[derive(Clone, Debug, PartialEq)]
pub struct NodalData {
    /// Five lines of identification.
    pub names: Vec<String>,
    /// Kind.
    pub kind: ResultKind,
    /// Whether the values are complex.
    pub is_complex: bool,
    /// Integers that depend on the analysis type: load case and step or mode.
    pub integers: Vec<i64>,
    /// Numbers that depend on the analysis type, such as the frequency in Hz.
    pub reals: Vec<f64>,
    /// Values of each node.
    pub values: Vec<LocatedValues>,
}

/// Entities that have the values of a dataset 2414.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Entity {
    /// Nodes.
    Nodes,
    /// Elements.
    Elements,
}

/// Results at nodes or elements (2414).
#[derive(Clone, Debug, PartialEq)]
pub struct AnalysisData {
    /// Label.
    pub label: i64,
    /// Name.
    pub name: String,
    /// Entities.
    pub entity: Entity,
    /// Five lines of identification.
    pub names: Vec<String>,
    /// Kind.
    pub kind: ResultKind,
    /// Whether the values are complex.
    pub is_complex: bool,
    /// 16 integers: design set, iteration, solution set, boundary condition, load set, mode, step,
    /// frequency number and others.
    pub integers: Vec<i64>,
    /// 12 numbers: time, frequency, eigenvalue, modal mass, damping and others.
    pub reals: Vec<f64>,
    /// Values of each node or element.
    pub values: Vec<LocatedValues>,
}

/// Function at a degree of freedom (58).
#[derive(Clone, Debug, PartialEq)]
pub struct Function {
    /// Five lines of identification.
    pub names: Vec<String>,
    /// Function type: 1 time response, 2 auto spectrum, 4 frequency response, 12 spectrum.
    pub kind: i64,
    /// Function number, version, load case.
    pub numbers: [i64; 3],
    /// Response.
    pub response: FunctionEnd,
    /// Reference.
    pub reference: FunctionEnd,
    /// Abscissae.
    pub abscissae: Abscissae,
    /// Value of the z axis.
    pub z: f64,
    /// Abscissa, ordinate, denominator of the ordinate, z axis.
    pub axes: [FunctionAxis; 4],
    /// Ordinates.
    pub ordinates: Ordinates,
}

/// Abscissae of a function.
#[derive(Clone, Debug, PartialEq)]
pub enum Abscissae {
    /// Evenly spaced values.
    Even {
        /// First value.
        first: f64,
        /// Increment.
        increment: f64,
    },
    /// All values.
    All(Vec<f64>),
}

/// Ordinates of a function, with their precision in the file.
#[derive(Clone, Debug, PartialEq)]
pub enum Ordinates {
    /// Real numbers; true in double precision.
    Real(Vec<f64>, bool),
    /// Complex numbers; true in double precision.
    Complex(Vec<c64>, bool),
}

/// Degree of freedom of a function.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FunctionEnd {
    /// Entity name, up to 10 characters without spaces.
    pub entity: String,
    /// Label of the node.
    pub node: i64,
    /// Direction: 0 scalar, ±1 to ±3 translations, ±4 to ±6 rotations.
    pub direction: i64,
}

/// Axis of a function.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FunctionAxis {
    /// Specific data type: 18 frequency, 17 time, 11 velocity, 15 pressure, 0 unknown.
    pub quantity: i64,
    /// Exponents of length, force and temperature units.
    pub exponents: [i64; 3],
    /// Label, up to 20 characters.
    pub label: String,
    /// Units, up to 20 characters.
    pub units: String,
}
