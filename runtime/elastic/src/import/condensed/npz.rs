//! NPZ archives of NumPy: ZIP archives of NPY arrays.
//!
//! | Array | Shape | Content |
//! |---|---|---|
//! | `stiffness` | n × n | stiffness matrix |
//! | `mass` | n × n | mass matrix; optional |
//! | `nodes` | k | labels of the nodes: integers or text |
//! | `components` | n × 2 | index of the node from 0, and component from 1 to 6, of each row; by default six for each node |
//! | `positions` | k × 3 | positions of the nodes; optional |
//!
//! Sources: NumPy documentation, "numpy.lib.format"; PKWARE, "APPNOTE.TXT - .ZIP File Format
//! Specification". The project reads the format itself, because crates for NPZ depend on
//! compression libraries in C.

use super::{CondensedNode, Dof, LARGEST, Parts};
use flate2::Crc;
use flate2::read::DeflateDecoder;
use nalgebra::DMatrix;
use std::collections::BTreeMap;
use std::io::Read;

type Result<T> = std::result::Result<T, (String, String)>;

/// Largest size of an array, bytes: a matrix of the largest body, and its header.
const LARGEST_ARRAY: u64 = (LARGEST * LARGEST * 8 + 65536) as u64;

fn invalid<T>(message: impl Into<String>) -> Result<T> {
    Err((message.into(), "save the arrays again with `numpy.savez`".into()))
}

/// Elements of an array.
enum Values {
    Real(Vec<f64>),
    Integer(Vec<i64>),
    Text(Vec<String>),
}

struct Array {
    shape: Vec<usize>,
    values: Values,
}

/// Reads a condensed body from an NPZ archive.
pub(super) fn read(archive: &[u8]) -> Result<Parts> {
    let arrays = arrays(archive)?;
    let needed = |name: &str| match arrays.get(name) {
        Some(array) => Ok(array),
        None => invalid(format!("the archive has no array `{name}`")),
    };
    let labels = match &needed("nodes")?.values {
        Values::Integer(labels) => labels.iter().map(i64::to_string).collect::<Vec<_>>(),
        Values::Text(labels) => labels.clone(),
        Values::Real(_) => return invalid("the array `nodes` has numbers with fractions instead of labels"),
    };
    let components = components(arrays.get("components"), labels.len())?;
    let n = components.len();
    let matrix = |name: &str, array: &Array| match &array.values {
        Values::Real(values) if array.shape == [n, n] => Ok(DMatrix::from_row_slice(n, n, values)),
        _ => invalid(format!(
            "the array `{name}` has the shape {:?}, but must be real and [{n}, {n}]",
            array.shape
        )),
    };
    let stiffness = matrix("stiffness", needed("stiffness")?)?;
    let mass = arrays.get("mass").map(|array| matrix("mass", array)).transpose()?;
    let positions = match arrays.get("positions") {
        None => None,
        Some(Array { shape, values: Values::Real(values) }) if *shape == [labels.len(), 3] => Some(values),
        Some(array) => {
            let expected = labels.len();
            return invalid(format!(
                "the array `positions` has the shape {:?}, but must be real and [{expected}, 3]",
                array.shape
            ));
        }
    };
    let node = |(at, label): (usize, String)| CondensedNode {
        label,
        position: positions.map(|values| [values[3 * at], values[3 * at + 1], values[3 * at + 2]]),
    };
    Ok(Parts { nodes: labels.into_iter().enumerate().map(node).collect(), components, stiffness, mass })
}

fn components(array: Option<&Array>, nodes: usize) -> Result<Vec<Dof>> {
    let rows = match array {
        None => (0..nodes.min(LARGEST)).flat_map(|node| (0..6).map(move |c| (node, c))).collect(),
        Some(Array { shape, values: Values::Integer(values) }) if shape.len() == 2 && shape[1] == 2 => {
            let mut rows = Vec::new();
            for pair in values.chunks_exact(2) {
                let node = usize::try_from(pair[0]).ok().filter(|node| *node < nodes);
                match (node, pair[1]) {
                    (Some(node), component @ 1..=6) => rows.push((node, component as usize - 1)),
                    _ => return invalid(format!("the array `components` has the invalid row {pair:?}")),
                }
            }
            rows
        }
        Some(_) => return invalid("the array `components` is not an array of integers with two columns"),
    };
    let mut sorted = rows.clone();
    sorted.sort_unstable();
    if rows.len() > LARGEST || sorted.windows(2).any(|pair| pair[0] == pair[1]) {
        return invalid(format!("the array `components` repeats a row, or has more than {LARGEST}"));
    }
    Ok(rows)
}

/// Little-endian number of `N` bytes at an offset.
fn number<const N: usize>(data: &[u8], at: usize) -> Result<usize> {
    match data.get(at..).and_then(|rest| rest.first_chunk::<N>()) {
        Some(bytes) => Ok(bytes.iter().rev().fold(0, |value, byte| value << 8 | usize::from(*byte))),
        None => invalid("the archive is not complete"),
    }
}

/// Arrays of an archive by name.
fn arrays(archive: &[u8]) -> Result<BTreeMap<String, Array>> {
    const END: &[u8] = b"PK\x05\x06";
    let Some(end) = archive.windows(END.len()).rposition(|window| window == END) else {
        return invalid("the file is not a ZIP archive");
    };
    let count = number::<2>(archive, end + 10)?;
    let mut at = number::<4>(archive, end + 16)?;
    let mut arrays = BTreeMap::new();
    for _ in 0..count {
        if number::<4>(archive, at)? != 0x0201_4b50 {
            return invalid("the directory of the archive is not valid");
        }
        let method = number::<2>(archive, at + 10)?;
        let checksum = number::<4>(archive, at + 16)?;
        let (packed, size) = (number::<4>(archive, at + 20)?, number::<4>(archive, at + 24)?);
        let lengths = [28, 30, 32].map(|offset| number::<2>(archive, at + offset));
        let [name, extra, comment] = lengths;
        let (name, extra, comment) = (name?, extra?, comment?);
        let local = number::<4>(archive, at + 42)?;
        let label = archive.get(at + 46..at + 46 + name).map(String::from_utf8_lossy).unwrap_or_default();
        let label = label.strip_suffix(".npy").unwrap_or(&label).to_owned();
        at += 46 + name + extra + comment;
        if !matches!(label.as_str(), "stiffness" | "mass" | "nodes" | "components" | "positions") {
            continue;
        }
        // Repeated entries could state an unlimited amount of work.
        if arrays.contains_key(&label) {
            return invalid(format!("the archive has two arrays `{label}`"));
        }
        let start = local + 30 + number::<2>(archive, local + 26)? + number::<2>(archive, local + 28)?;
        let Some(packed) = archive.get(start..start.saturating_add(packed)) else {
            return invalid(format!("the array `{label}` is not complete"));
        };
        let content = unpacked(packed, method, size, &label)?;
        let mut crc = Crc::new();
        crc.update(&content);
        if crc.sum() as usize != checksum {
            return invalid(format!("the checksum of the array `{label}` is wrong"));
        }
        arrays.insert(label.clone(), array(&content, &label)?);
    }
    Ok(arrays)
}

fn unpacked(packed: &[u8], method: usize, size: usize, label: &str) -> Result<Vec<u8>> {
    if size as u64 > LARGEST_ARRAY {
        return Err((format!("the array `{label}` is too large"), "condense the body to fewer nodes".into()));
    }
    let mut content = Vec::new();
    let read = match method {
        0 => packed.take(LARGEST_ARRAY).read_to_end(&mut content),
        8 => DeflateDecoder::new(packed).take(LARGEST_ARRAY).read_to_end(&mut content),
        _ => return invalid(format!("the array `{label}` is compressed by an unknown method")),
    };
    match read {
        Ok(count) if count == size => Ok(content),
        _ => invalid(format!("the array `{label}` cannot be unpacked")),
    }
}

/// Value of a key in the header of an NPY array.
fn entry<'h>(header: &'h str, key: &str) -> Option<&'h str> {
    let rest = header.split_once(&format!("'{key}':"))?.1.trim_start();
    match rest.as_bytes().first()? {
        b'\'' => rest[1..].split_once('\'').map(|(value, _)| value),
        b'(' => rest[1..].split_once(')').map(|(value, _)| value),
        _ => rest.split([',', '}']).next().map(str::trim),
    }
}

fn array(content: &[u8], label: &str) -> Result<Array> {
    let header_size = match content.get(..8) {
        Some([0x93, b'N', b'U', b'M', b'P', b'Y', 1, _]) => (10, number::<2>(content, 8)?),
        Some([0x93, b'N', b'U', b'M', b'P', b'Y', 2 | 3, _]) => (12, number::<4>(content, 8)?),
        _ => return invalid(format!("`{label}` is not an NPY array")),
    };
    let start = header_size.0 + header_size.1;
    let header = content.get(header_size.0..start).and_then(|header| std::str::from_utf8(header).ok());
    let parsed = header.and_then(|header| {
        let shape: Option<Vec<usize>> = entry(header, "shape")?
            .split(',')
            .map(str::trim)
            .filter(|size| !size.is_empty())
            .map(|size| size.parse().ok())
            .collect();
        Some((entry(header, "descr")?, entry(header, "fortran_order")?, shape?))
    });
    let Some((kind, order, shape)) = parsed else {
        return invalid(format!("the header of the array `{label}` is not valid"));
    };
    let Some(count) = shape.iter().try_fold(1_usize, |count, size| count.checked_mul(*size)) else {
        return invalid(format!("the array `{label}` is too large"));
    };
    let data = &content[start..];
    let width = match kind {
        "<f8" | "<i8" => 8,
        "<f4" | "<i4" => 4,
        _ => match kind.strip_prefix("<U").and_then(|size| size.parse::<usize>().ok()) {
            Some(size @ 1..=1024) => 4 * size,
            _ => {
                return invalid(format!(
                    "the array `{label}` has elements of type {kind}, which is not supported"
                ));
            }
        },
    };
    if count.checked_mul(width) != Some(data.len()) {
        return invalid(format!("the array `{label}` has {} bytes instead of {count} elements", data.len()));
    }
    let values = match kind {
        "<f8" => Values::Real(chunks(data, f64::from_le_bytes)),
        "<f4" => Values::Real(chunks(data, |bytes| f64::from(f32::from_le_bytes(bytes)))),
        "<i8" => Values::Integer(chunks(data, i64::from_le_bytes)),
        "<i4" => Values::Integer(chunks(data, |bytes| i64::from(i32::from_le_bytes(bytes)))),
        _ => Values::Text(data.chunks_exact(width).map(text).collect()),
    };
    Ok(Array { values: if order == "True" { row_major(values, &shape) } else { values }, shape })
}

fn chunks<T, const N: usize>(data: &[u8], convert: impl Fn([u8; N]) -> T) -> Vec<T> {
    data.as_chunks::<N>().0.iter().map(|chunk| convert(*chunk)).collect()
}

/// Text of code points of four bytes, padded with zeros.
fn text(data: &[u8]) -> String {
    chunks(data, u32::from_le_bytes)
        .into_iter()
        .take_while(|point| *point != 0)
        .map(|point| char::from_u32(point).unwrap_or(char::REPLACEMENT_CHARACTER))
        .collect()
}

/// Reorders the elements of a matrix that is stored by columns.
fn row_major(values: Values, shape: &[usize]) -> Values {
    let [rows, columns] = shape[..] else { return values };
    fn reordered<T: Copy>(values: &[T], rows: usize, columns: usize) -> Vec<T> {
        (0..rows).flat_map(|row| (0..columns).map(move |column| values[column * rows + row])).collect()
    }
    match values {
        Values::Real(values) => Values::Real(reordered(&values, rows, columns)),
        Values::Integer(values) => Values::Integer(reordered(&values, rows, columns)),
        text => text,
    }
}
