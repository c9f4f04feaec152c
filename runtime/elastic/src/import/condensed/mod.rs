//! Condensed bodies: stiffness and mass at nodes, from DMIG, CSV and NPZ files.

mod csv;
mod dmig;
mod npz;

use super::Units;
use super::error::ImportError;
use super::origin::Problem;
use super::source::{OpenFile, Place, Sources};
use crate::model::Component;
use faer::linalg::cholesky::llt::factor::LltError;
use faer::{Mat, Side};
use nalgebra::DMatrix;
use std::collections::{BTreeMap, HashMap};

/// Largest number of components of a condensed body.
const LARGEST: usize = 4096;
/// Largest difference of an entry and its transpose, relative to the diagonal entries.
const ASYMMETRY: f64 = 1e-6;
/// Negative eigenvalue of a matrix with a diagonal of ones that is more than rounding.
const INDEFINITE: f64 = 1e-5;

/// Condensed body: stiffness and mass at components of nodes, in SI units and basic coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct CondensedMatrices {
    /// Nodes.
    pub nodes: Vec<CondensedNode>,
    /// Index of the node, and component, of each row.
    pub components: Vec<(usize, Component)>,
    /// Symmetric stiffness matrix, N/m, N and N m.
    pub stiffness: DMatrix<f64>,
    /// Symmetric mass matrix, kg, kg m and kg m²; `None` if the source has none.
    pub mass: Option<DMatrix<f64>>,
}

/// Node of a condensed body.
#[derive(Clone, Debug, PartialEq)]
pub struct CondensedNode {
    /// Label in the source.
    pub label: String,
    /// Position, m; `None` if the source does not state it.
    pub position: Option<[f64; 3]>,
}

/// Arguments of [`read_condensed`].
#[derive(Clone, Debug, PartialEq)]
pub struct CondensedOptions {
    /// Units of the matrices.
    pub units: Units,
    /// Name of the stiffness matrix in a DMIG file; `None` for the only one that begins with K.
    pub stiffness: Option<String>,
    /// Name of the mass matrix in a DMIG file; `None` for the only one that begins with M.
    pub mass: Option<String>,
}

type Result<T> = std::result::Result<T, Problem>;
/// Row or column: index of a node, component.
type Dof = (usize, Component);

/// Entries of a matrix with their locations.
#[derive(Default)]
struct Entries {
    values: HashMap<(Dof, Dof), (f64, Place)>,
    /// True if an entry also states its transpose.
    is_triangle: bool,
}

impl Entries {
    /// Adds an entry of a matrix, which `named` names.
    fn add(
        &mut self,
        named: impl FnOnce() -> String,
        (row, column): (Dof, Dof),
        value: f64,
        place: Place,
    ) -> Result<()> {
        match self.values.insert((row, column), (value, place)) {
            Some((known, other)) if known != value => Err(Problem::new(
                place,
                format!("{} is {value}, but {known} in line {}", named(), other.line),
                "state each entry once",
            )),
            _ => Ok(()),
        }
    }
}

/// Names an entry of a matrix by the labels and components (from 0) of its row and column.
fn entry_name(matrix: &str, row: (&str, Component), column: (&str, Component)) -> String {
    let dof = |(label, component): (&str, Component)| format!("component {} of node {label}", component + 1);
    format!("the entry of {matrix} between {} and {}", dof(row), dof(column))
}

/// Parts of a condensed body in the units of its source.
struct Parts {
    nodes: Vec<CondensedNode>,
    components: Vec<Dof>,
    stiffness: DMatrix<f64>,
    mass: Option<DMatrix<f64>>,
}

/// Reads a condensed body. The extension of the path selects the format: `pch` (also `bdf`, `dat`)
/// for DMIG, `csv` or `npz`.
///
/// # Errors
/// The file is not valid, or a matrix is not finite or not symmetric.
pub fn read_condensed(
    path: &str,
    options: &CondensedOptions,
    open: &mut OpenFile,
) -> std::result::Result<CondensedMatrices, ImportError> {
    let mut sources = Sources::new(open);
    let start = Place { file: 0, line: 1 };
    let extension = path.rsplit('.').next().unwrap_or_default().to_ascii_lowercase();
    let parts = match extension.as_str() {
        "pch" | "bdf" | "dat" | "nas" => dmig::read(path, options, &mut sources)?,
        "csv" => {
            let (_, text) = sources.text(path, None)?;
            csv::read(&text).map_err(|problem| problem.located(&sources.names))?
        }
        "npz" => {
            let (_, content) = sources.bytes(path, None)?;
            let parts = npz::read(&content).map_err(|(message, help)| Problem::new(start, message, help));
            parts.map_err(|problem| problem.located(&sources.names))?
        }
        _ => {
            return Err(ImportError {
                file: path.to_owned(),
                line: 1,
                message: format!("`{extension}` is no format of condensed bodies"),
                help: "use a file with the extension pch, csv or npz".into(),
            });
        }
    };
    let checked = finish(parts, &options.units).map_err(|(message, help)| Problem::new(start, message, help));
    checked.map_err(|problem| problem.located(&sources.names))
}

/// Checks the matrices, and converts them to SI.
fn finish(parts: Parts, units: &Units) -> std::result::Result<CondensedMatrices, (String, String)> {
    let Parts { mut nodes, components, mut stiffness, mut mass } = parts;
    if !units.is_valid() {
        return Err(("the units are not positive".into(), "state positive units".into()));
    }
    if components.is_empty() {
        return Err(("the body has no stiffness matrix".into(), "state its entries".into()));
    }
    let motion = |at: usize| if components[at].1 < 3 { units.length } else { 1.0 };
    let scaled = |matrix: &mut DMatrix<f64>, unit: f64| {
        for column in 0..matrix.ncols() {
            for row in 0..matrix.nrows() {
                matrix[(row, column)] *= unit / (motion(row) * motion(column));
            }
        }
    };
    scaled(&mut stiffness, units.force * units.length);
    check("stiffness", &mut stiffness, &nodes, &components)?;
    if let Some(mass) = &mut mass {
        scaled(mass, units.mass() * units.length * units.length);
        check("mass", mass, &nodes, &components)?;
    }
    for node in &mut nodes {
        node.position = node.position.map(|position| position.map(|x| x * units.length));
        if node.position.is_some_and(|position| position.iter().any(|x| !x.is_finite())) {
            return Err((format!("the position of node {} is not finite", node.label), "correct it".into()));
        }
    }
    Ok(CondensedMatrices { nodes, components, stiffness, mass })
}

/// Checks that a matrix is finite, symmetric and has no negative diagonal entry. Makes it exactly
/// symmetric.
fn check(
    name: &str,
    matrix: &mut DMatrix<f64>,
    nodes: &[CondensedNode],
    components: &[Dof],
) -> std::result::Result<(), (String, String)> {
    let dof =
        |at: usize| format!("component {} of node {}", components[at].1 + 1, nodes[components[at].0].label);
    let largest = matrix.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
    for column in 0..matrix.ncols() {
        if matrix[(column, column)] < 0.0 {
            let message = format!("{name}: the diagonal entry of {} is negative", dof(column));
            return Err((message, "check the sign of the matrix".into()));
        }
        for row in 0..=column {
            let (a, b) = (matrix[(row, column)], matrix[(column, row)]);
            let pair = || format!("{name}: the entry of {} and {}", dof(row), dof(column));
            if !a.is_finite() || !b.is_finite() {
                return Err((format!("{} is not finite", pair()), "export the matrix again".into()));
            }
            let scale = (matrix[(row, row)].abs() * matrix[(column, column)].abs()).sqrt();
            if (a - b).abs() > ASYMMETRY * scale + 1e-12 * largest {
                let message = format!("{} is {a:e}, but its transpose is {b:e}", pair());
                return Err((message, "export the symmetric matrix".into()));
            }
            let mean = 0.5 * (a + b);
            matrix[(row, column)] = mean;
            matrix[(column, row)] = mean;
        }
    }
    let Some(at) = indefinite(matrix) else { return Ok(()) };
    let message = format!(
        "{name}: the matrix has a negative eigenvalue: moved in {} and others, it gives energy",
        dof(at)
    );
    Err((message, "check the signs of entries off the diagonal, and that no entry is missing".into()))
}

/// Returns the first row, if any, up to which a symmetric matrix with a diagonal of at least zero
/// is not positive semidefinite. Rounding of printed digits is accepted.
fn indefinite(matrix: &DMatrix<f64>) -> Option<usize> {
    let count = matrix.nrows();
    let scale: Vec<f64> = (0..count).map(|k| matrix[(k, k)].sqrt()).collect();
    let unscaled = |row: &usize| scale[*row] == 0.0 && (0..count).any(|column| matrix[(*row, column)] != 0.0);
    if let Some(row) = (0..count).find(unscaled) {
        return Some(row);
    }
    let rows: Vec<usize> = (0..count).filter(|&row| scale[row] > 0.0).collect();
    let entry = |i: usize, j: usize| {
        let shift = if i == j { INDEFINITE } else { 0.0 };
        matrix[(rows[i], rows[j])] / (scale[rows[i]] * scale[rows[j]]) + shift
    };
    let scaled = Mat::from_fn(rows.len(), rows.len(), entry);
    match scaled.llt(Side::Lower) {
        Ok(_) => None,
        Err(LltError::NonPositivePivot { index }) => rows.get(index).or(rows.last()).copied(),
    }
}

/// Error for the first entry that contradicts its transpose in an earlier line.
fn contradiction(name: &str, nodes: &[CondensedNode], entries: &Entries) -> Option<Problem> {
    let contradicts = |((row, column), (value, place)): (&(Dof, Dof), &(f64, Place))| {
        let (other, first) = entries.values.get(&(*column, *row))?;
        let differs = (value - other).abs() > ASYMMETRY * value.abs().max(other.abs());
        let terms = (*place, *value, *other, first.line, (*row, *column));
        (first.line < place.line && differs).then_some((place.line, terms))
    };
    let (_, (place, value, other, first, (row, column))) =
        entries.values.iter().filter_map(contradicts).min_by_key(|found| found.0)?;
    let dof = |(node, component): Dof| (nodes[node].label.as_str(), component);
    let entry = entry_name(name, dof(row), dof(column));
    let message = format!("{entry} is {value:e}, but its transpose in line {first} is {other:e}");
    Some(Problem::new(place, message, "state one of the two"))
}

/// Matrices of entries: rows are in the order of nodes and components.
fn assemble(nodes: Vec<CondensedNode>, stiffness: &Entries, mass: Option<&Entries>) -> Result<Parts> {
    let mut rows: BTreeMap<Dof, usize> = BTreeMap::new();
    for entries in [Some(stiffness), mass].into_iter().flatten() {
        for (row, column) in entries.values.keys() {
            rows.insert(*row, 0);
            rows.insert(*column, 0);
            if rows.len() > LARGEST {
                let message = format!("the body has more than {LARGEST} components");
                let place = Place { file: 0, line: 1 };
                return Err(Problem::new(place, message, "condense the body to fewer nodes"));
            }
        }
    }
    rows.values_mut().enumerate().for_each(|(at, row)| *row = at);
    let named = [("the stiffness", Some(stiffness)), ("the mass", mass)];
    for (name, entries) in named.into_iter().filter_map(|(name, entries)| Some((name, entries?))) {
        if let Some(problem) = entries.is_triangle.then(|| contradiction(name, &nodes, entries)).flatten() {
            return Err(problem);
        }
    }
    let matrix = |entries: &Entries| {
        let mut matrix = DMatrix::zeros(rows.len(), rows.len());
        for ((row, column), (value, _)) in &entries.values {
            let (i, j) = (rows[row], rows[column]);
            matrix[(i, j)] = *value;
            if entries.is_triangle && !entries.values.contains_key(&(*column, *row)) {
                matrix[(j, i)] = *value;
            }
        }
        matrix
    };
    let (stiffness, mass) = (matrix(stiffness), mass.map(matrix));
    Ok(Parts { nodes, components: rows.into_keys().collect(), stiffness, mass })
}
