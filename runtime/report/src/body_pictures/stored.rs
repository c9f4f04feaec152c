//! Surfaces of pictures that are not drawn yet, as array files in a run directory.

use super::Surface;
use calyx_view::array_file::{ArrayFile, Arrays, InvalidArrayFile};
use serde_json::{Value, json};

/// Returns the content of the file of a surface.
pub fn file_of(surface: &Surface) -> Vec<u8> {
    let index = |index: usize| u32::try_from(index).unwrap_or(u32::MAX);
    // A triangle repeats its last corner.
    let face =
        |face: &Vec<usize>| [0, 1, 2, 3].map(|k: usize| index(face[k.min(face.len().saturating_sub(1))]));
    let mut arrays = Arrays::default();
    let points = arrays.double(surface.points.iter().copied());
    let displacements = arrays.double(surface.displacements.iter().copied());
    let stresses = arrays.double(surface.stresses.iter().map(|&stress| [stress]));
    let faces = arrays.indices(surface.faces.iter().filter(|face| !face.is_empty()).map(face));
    let lines = arrays.indices(surface.lines.iter().map(|line| line.map(index)));
    arrays.file(&json!({
        "body": surface.body,
        "number": surface.number,
        "points": points,
        "displacements": displacements,
        "stresses": stresses,
        "faces": faces,
        "lines": lines,
    }))
}

/// Reads the file of a surface.
///
/// # Errors
/// The bytes are not those of [`file_of`].
pub fn read(bytes: &[u8]) -> Result<Surface, InvalidArrayFile> {
    let file = ArrayFile::read(bytes)?;
    let header = &file.header;
    let number = header["number"].as_u64().and_then(|number| usize::try_from(number).ok());
    let faces = rows::<4>(&file, &header["faces"])?.into_iter().map(|face| {
        let mut corners = face.map(|corner| corner as usize).to_vec();
        corners.dedup();
        corners
    });
    let lines = rows::<2>(&file, &header["lines"])?;
    Ok(Surface {
        body: header["body"].as_str().unwrap_or_default().to_owned(),
        number: number.unwrap_or_default(),
        points: rows(&file, &header["points"])?,
        displacements: rows(&file, &header["displacements"])?,
        stresses: file.numbers(&header["stresses"])?,
        faces: faces.collect(),
        lines: lines.into_iter().map(|line| line.map(|point| point as usize)).collect(),
    })
}

fn rows<const N: usize>(file: &ArrayFile<'_>, reference: &Value) -> Result<Vec<[f64; N]>, InvalidArrayFile> {
    Ok(file.numbers(reference)?.as_chunks().0.to_vec())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn surfaces_are_read_as_written() {
        let surface = Surface {
            body: "shaft".into(),
            number: 3,
            points: vec![[0.0, 0.1, 0.2], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]],
            displacements: vec![[1e-7, 0.0, 0.3]; 4],
            stresses: vec![1.0, f64::NAN, 3.0, 0.1],
            faces: vec![vec![0, 1, 2], vec![0, 1, 3, 2]],
            lines: vec![[0, 3]],
        };
        let found = read(&file_of(&surface)).unwrap();
        assert_eq!((found.body.as_str(), found.number), ("shaft", 3));
        assert_eq!((&found.points, &found.displacements), (&surface.points, &surface.displacements));
        assert_eq!((&found.faces, &found.lines), (&surface.faces, &surface.lines));
        assert!(found.stresses[1].is_nan() && found.stresses[3] == 0.1);
        assert!(read(b"nothing").is_err());
    }
}
