//! Surfaces of pictures that are not drawn yet, as array files in a run directory.

use super::{BodyPicture, Surface};
use calyx_view::array_file::{ArrayFile, Arrays, InvalidArrayFile};
use serde_json::{Value, json};

/// Returns the content of the file of a surface and of what its picture shows.
pub fn file_of(picture: &BodyPicture, surface: &Surface) -> Vec<u8> {
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
        "picture": picture,
        "number": surface.number,
        "points": points,
        "displacements": displacements,
        "stresses": stresses,
        "faces": faces,
        "lines": lines,
    }))
}

/// Reads the file of a surface; `None` if it is not one of [`file_of`].
pub fn read(bytes: &[u8]) -> Option<(BodyPicture, Surface)> {
    let file = ArrayFile::read(bytes).ok()?;
    let header = &file.header;
    let picture: BodyPicture = serde_json::from_value(header["picture"].clone()).ok()?;
    let faces = rows::<4>(&file, &header["faces"]).ok()?.into_iter().map(|face| {
        let mut corners = face.map(|corner| corner as usize).to_vec();
        corners.dedup();
        corners
    });
    let lines = rows::<2>(&file, &header["lines"]).ok()?;
    let surface = Surface {
        body: picture.body.clone(),
        number: usize::try_from(header["number"].as_u64()?).ok()?,
        points: rows(&file, &header["points"]).ok()?,
        displacements: rows(&file, &header["displacements"]).ok()?,
        stresses: file.numbers(&header["stresses"]).ok()?,
        faces: faces.collect(),
        lines: lines.into_iter().map(|line| line.map(|point| point as usize)).collect(),
    };
    let count = surface.points.len();
    let mut corners = surface.faces.iter().flatten().chain(surface.lines.iter().flatten());
    let complete = [surface.displacements.len(), surface.stresses.len()] == [count; 2];
    (complete && corners.all(|&point| point < count)).then_some((picture, surface))
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
        let picture = BodyPicture {
            body: "shaft".into(),
            file: "body-003.png".into(),
            position: 5,
            time: 0.25,
            exaggeration: 200.0,
            largest_displacement: 0.3,
            largest_stress: 3.0,
            size: [0; 2],
        };
        let bytes = file_of(&picture, &surface);
        let (shown, found) = read(&bytes).unwrap();
        assert_eq!((shown, found.body.as_str(), found.number), (picture.clone(), "shaft", 3));
        assert_eq!((&found.points, &found.displacements), (&surface.points, &surface.displacements));
        assert_eq!((&found.faces, &found.lines), (&surface.faces, &surface.lines));
        assert!(found.stresses[1].is_nan() && found.stresses[3] == 0.1);
        // An incomplete file, and one that refers to points that it does not have.
        assert!(read(&bytes[..bytes.len() - 8]).is_none());
        let wrong = Surface { lines: vec![[0, 4]], ..surface };
        assert!(read(&file_of(&picture, &wrong)).is_none());
    }
}
