//! Unstructured grids in VTK's XML format. The format is tags around numeric arrays and is written
//! directly: the available crates also read it, and are unmaintained.
//!
//! Arrays are inline binary: compressed with zlib and encoded in base 64. All readers support this,
//! and it takes a fraction of the size of decimals.

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use flate2::Compression;
use flate2::write::ZlibEncoder;
use std::fmt::Write as _;
use std::io::{self, Write as _};

/// Cell types of VTK.
pub const VERTEX: u8 = 1;
pub const LINE: u8 = 3;
pub const TRIANGLE: u8 = 5;
pub const QUADRILATERAL: u8 = 9;
pub const TETRAHEDRON: u8 = 10;
pub const HEXAHEDRON: u8 = 12;
pub const WEDGE: u8 = 13;
pub const QUADRATIC_TRIANGLE: u8 = 22;
pub const QUADRATIC_QUADRILATERAL: u8 = 23;
pub const QUADRATIC_TETRAHEDRON: u8 = 24;
pub const QUADRATIC_HEXAHEDRON: u8 = 25;
pub const QUADRATIC_WEDGE: u8 = 26;
pub const BIQUADRATIC_QUADRILATERAL: u8 = 28;

/// Size of a compressed block, bytes. Readers decompress blocks separately, so each contains whole
/// numbers of any type.
const BLOCK: usize = 1 << 17;

/// Points, cells, and values on either.
#[derive(Default)]
pub struct Grid {
    pub points: Vec<[f64; 3]>,
    pub cells: Vec<(u8, Vec<usize>)>,
    pub point_values: Vec<Values>,
    pub cell_values: Vec<Values>,
    /// Stores values in single precision, which is accurate enough to display grids of very many
    /// points. Points are always double, because displacements are small compared to them.
    pub short: bool,
}

/// Named values.
pub struct Values {
    pub name: &'static str,
    /// Number of components of each point or cell, stored contiguously.
    pub components: usize,
    pub numbers: Vec<f64>,
}

impl Values {
    /// Creates values with one component.
    pub fn scalars(name: &'static str, numbers: Vec<f64>) -> Values {
        Values { name, components: 1, numbers }
    }
}

impl Grid {
    /// Formats the file.
    pub fn text(&self) -> io::Result<String> {
        let mut text = format!(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\" \
             compressor=\"vtkZLibDataCompressor\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
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
                let attributes = format!("Name=\"{name}\"{components}");
                if self.short {
                    let bytes = numbers.iter().flat_map(|&number| (number as f32).to_le_bytes());
                    array(&mut text, "Float32", &attributes, bytes)?;
                } else {
                    array(&mut text, "Float64", &attributes, doubles(numbers))?;
                }
            }
            let _ = writeln!(text, "</{tag}>");
        }
        text += "<Points>\n";
        array(&mut text, "Float64", "NumberOfComponents=\"3\"", doubles(self.points.as_flattened()))?;
        text += "</Points>\n<Cells>\n";
        let whole = |number: usize| (number as i64).to_le_bytes();
        let corners = self.cells.iter().flat_map(|(_, corners)| corners);
        array(&mut text, "Int64", "Name=\"connectivity\"", corners.flat_map(|&corner| whole(corner)))?;
        let ends = self.cells.iter().scan(0, |end, (_, corners)| {
            *end += corners.len();
            Some(*end)
        });
        array(&mut text, "Int64", "Name=\"offsets\"", ends.flat_map(whole))?;
        array(&mut text, "UInt8", "Name=\"types\"", self.cells.iter().map(|(kind, _)| *kind))?;
        Ok(text + "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n")
    }
}

fn doubles(numbers: &[f64]) -> impl Iterator<Item = u8> + '_ {
    numbers.iter().flat_map(|number| number.to_le_bytes())
}

/// Writes an array given as bytes: number of blocks, size of a block and of the last one,
/// compressed size of each, then the blocks.
fn array(text: &mut String, kind: &str, attributes: &str, bytes: impl Iterator<Item = u8>) -> io::Result<()> {
    let bytes: Vec<u8> = bytes.collect();
    // Readers disagree about an array of zero blocks.
    if bytes.is_empty() {
        let _ = writeln!(text, "<DataArray type=\"{kind}\" {attributes} format=\"ascii\"></DataArray>");
        return Ok(());
    }
    let blocks: Vec<&[u8]> = bytes.chunks(BLOCK).collect();
    let last = blocks.last().map_or(0, |block| block.len());
    let mut header = vec![blocks.len(), BLOCK, last];
    let mut deflated = Vec::new();
    for block in blocks {
        let before = deflated.len();
        // A higher compression level takes three times as long and reduces the files by only 1 %.
        let mut encoder = ZlibEncoder::new(&mut deflated, Compression::fast());
        encoder.write_all(block)?;
        encoder.finish()?;
        header.push(deflated.len() - before);
    }
    let header: Vec<u8> = header.into_iter().flat_map(|number| (number as u64).to_le_bytes()).collect();
    let _ = write!(text, "<DataArray type=\"{kind}\" {attributes} format=\"binary\">");
    BASE64_STANDARD.encode_string(header, text);
    BASE64_STANDARD.encode_string(deflated, text);
    text.push_str("</DataArray>\n");
    Ok(())
}

/// Parser of the written files, for tests.
#[cfg(test)]
pub mod written {
    use super::{BASE64_STANDARD, BLOCK};
    use base64::Engine as _;
    use std::io::Read as _;

    /// Returns the bytes of the array with an attribute, and the type of its numbers.
    fn bytes<'t>(text: &'t str, attribute: &str) -> (&'t str, Vec<u8>) {
        let at = text.find(attribute).unwrap();
        let tag = &text[text[..at].rfind("<DataArray type=\"").unwrap()..];
        let kind = tag.split('"').nth(1).unwrap();
        let content = &tag[tag.find('>').unwrap() + 1..tag.find("</DataArray>").unwrap()];
        let number = |bytes: &[u8]| u64::from_le_bytes(bytes.try_into().unwrap()) as usize;
        // The first 8 bytes, within 12 characters, are the number of blocks.
        let blocks = number(&BASE64_STANDARD.decode(&content[..12]).unwrap()[..8]);
        let end = (8 * (3 + blocks)).div_ceil(3) * 4;
        let header: Vec<usize> =
            BASE64_STANDARD.decode(&content[..end]).unwrap().chunks(8).map(number).collect();
        let deflated = BASE64_STANDARD.decode(&content[end..]).unwrap();
        let mut rest = &deflated[..];
        let mut all = Vec::new();
        for (index, &length) in header[3..].iter().enumerate() {
            let (block, behind) = rest.split_at(length);
            rest = behind;
            let before = all.len();
            flate2::read::ZlibDecoder::new(block).read_to_end(&mut all).unwrap();
            let expected = if index + 1 < blocks { header[1] } else { header[2] };
            assert_eq!(all.len() - before, expected);
        }
        assert!(rest.is_empty() && header[1] == BLOCK);
        (kind, all)
    }

    /// Returns the numbers of the array with an attribute.
    pub fn numbers(text: &str, attribute: &str) -> Vec<f64> {
        let (kind, bytes) = bytes(text, attribute);
        let of = |size: usize, number: fn(&[u8]) -> f64| bytes.chunks_exact(size).map(number).collect();
        match kind {
            "Float32" => of(4, |bytes| f64::from(f32::from_le_bytes(bytes.try_into().unwrap()))),
            "Float64" => of(8, |bytes| f64::from_le_bytes(bytes.try_into().unwrap())),
            "Int64" => of(8, |bytes| i64::from_le_bytes(bytes.try_into().unwrap()) as f64),
            "UInt8" => of(1, |bytes| f64::from(bytes[0])),
            other => panic!("{other}"),
        }
    }
}
