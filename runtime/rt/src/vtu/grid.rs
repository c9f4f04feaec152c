//! Unstructured grids as VTK's XML files. They are tags around numbers, written here: the crates that write them read much more, and are not kept
//! up.

use std::fmt::{LowerExp, Write as _};

/// VTK's numbers of the kinds of cells used here.
pub const VERTEX: u8 = 1;
pub const LINE: u8 = 3;
pub const QUADRILATERAL: u8 = 9;
pub const HEXAHEDRON: u8 = 12;

/// Points, cells over them, and values of either.
#[derive(Default)]
pub struct Grid {
    pub points: Vec<[f64; 3]>,
    pub cells: Vec<(u8, Vec<usize>)>,
    pub point_values: Vec<Values>,
    pub cell_values: Vec<Values>,
    /// Half as many digits, for grids of very many points: as good to look at.
    pub short: bool,
}

/// Values by a name.
pub struct Values {
    pub name: &'static str,
    /// Numbers of each point or cell, which follow each other.
    pub components: usize,
    pub numbers: Vec<f64>,
}

impl Values {
    /// One number each.
    pub fn scalars(name: &'static str, numbers: Vec<f64>) -> Values {
        Values { name, components: 1, numbers }
    }
}

impl Grid {
    pub fn text(&self) -> String {
        let mut text = format!(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n\
             <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
            self.points.len(),
            self.cells.len()
        );
        for (tag, values) in [("PointData", &self.point_values), ("CellData", &self.cell_values)] {
            let _ = writeln!(text, "<{tag}>");
            for Values { name, components, numbers } in values {
                let components = match components {
                    1 => String::new(),
                    count => format!(" NumberOfComponents=\"{count}\""),
                };
                self.numbers(&mut text, &format!("Name=\"{name}\"{components}"), numbers);
            }
            let _ = writeln!(text, "</{tag}>");
        }
        text += "<Points>\n";
        self.numbers(&mut text, "NumberOfComponents=\"3\"", self.points.as_flattened());
        text += "</Points>\n<Cells>\n";
        let corners: Vec<usize> = self.cells.iter().flat_map(|(_, corners)| corners).copied().collect();
        array(&mut text, "Int64", "Name=\"connectivity\"", corners.iter());
        let ends = self.cells.iter().scan(0, |end, (_, corners)| {
            *end += corners.len();
            Some(*end)
        });
        array(&mut text, "Int64", "Name=\"offsets\"", ends);
        array(&mut text, "UInt8", "Name=\"types\"", self.cells.iter().map(|(kind, _)| kind));
        text + "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n"
    }

    /// Numbers in their shortest decimals that read back to the same bits, of short grids to the nearest ones of half the digits.
    fn numbers(&self, text: &mut String, attributes: &str, numbers: &[f64]) {
        if self.short {
            array(text, "Float32", attributes, numbers.iter().map(|&number| Exponential(number as f32)));
        } else {
            array(text, "Float64", attributes, numbers.iter());
        }
    }
}

/// A number that is shorter with an exponent, as most that are far from one are; zero, of which there are many, as such.
struct Exponential<T>(T);

impl<T: LowerExp + PartialEq + Default> std::fmt::Display for Exponential<T> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        if self.0 == T::default() { f.write_str("0") } else { write!(f, "{:e}", self.0) }
    }
}

/// Writing to a text cannot fail.
fn array(
    text: &mut String,
    kind: &str,
    attributes: &str,
    numbers: impl Iterator<Item = impl std::fmt::Display>,
) {
    let _ = writeln!(text, "<DataArray type=\"{kind}\" {attributes} format=\"ascii\">");
    for (index, number) in numbers.enumerate() {
        let _ = write!(text, "{number}{}", if index % 9 == 8 { '\n' } else { ' ' });
    }
    text.push_str("\n</DataArray>\n");
}
