//! Pictures of a radiating surface: normal velocity and sound intensity at the loudest line of the
//! speed of the model, from the front and from behind.

use super::names;
use crate::body_pictures::{FOLDER, Surface, View, draw_coloured, path, signed_colour};
use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use calyx_runtime::forced_response::ForcedResponse;
use calyx_runtime::radiated_sound::{RadiatedSound, Skin, SkinField};
use serde::{Deserialize, Serialize};
use std::path::Path;
use std::{fs, io};

/// List of the pictures.
pub const PICTURES: &str = "sound.json";
/// Beginning of the names of the pictures.
const PREFIX: &str = "sound-";
/// Least cosine of the angle between two triangles of one wall, which have continuous colours.
const SMOOTH: f64 = 0.75;

/// Description of a picture.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SoundPicture {
    /// Name of the sound: the body, with what distinguishes it if it has several.
    pub body: String,
    /// Quantity: "velocity" in m/s, or "intensity" in W/m².
    pub quantity: String,
    /// Direction of the viewer: "front", which is towards +z, to the right and above, or "back",
    /// the opposite one.
    pub view: String,
    /// Name of the file.
    pub file: String,
    /// Frequency of the line, Hz.
    pub frequency: f64,
    /// Least and largest value.
    pub range: [f64; 2],
    /// Width and height, pixels.
    pub size: [u32; 2],
}

/// Values of the triangles of a surface.
type Quantity = fn(&SkinField) -> Vec<f64>;

/// Quantities with their names.
const QUANTITIES: [(&str, Quantity); 2] = [
    ("velocity", |field| field.velocities.iter().map(|velocity| velocity.norm()).collect()),
    ("intensity", |field| field.intensities.clone()),
];

/// Returns the loudest line of the surface of a sound.
fn shown(sound: &RadiatedSound) -> Option<(&Skin, &SkinField)> {
    let skin = sound.skin.as_ref()?;
    Some((skin, skin.fields.first()?))
}

/// Returns the names of the files that pictures of a response have, relative to the run directory.
pub fn picture_files(response: &ForcedResponse) -> Vec<String> {
    let count = QUANTITIES.len() * View::ALL.len() * response.sounds.iter().filter_map(shown).count();
    let mut files: Vec<String> = (0..count).map(name).collect();
    if count > 0 {
        files.push(PICTURES.to_owned());
    }
    files.into_iter().map(|name| format!("{FOLDER}/{name}")).collect()
}

/// Returns true if a run may write a file of this name into the folder of pictures.
pub fn is_picture_of_a_run(name: &str) -> bool {
    name == PICTURES || name.strip_prefix(PREFIX).is_some_and(|rest| rest.ends_with(".png"))
}

fn name(number: usize) -> String {
    format!("{PREFIX}{number:03}.png")
}

/// Draws the surfaces of all sounds into the folder of a run directory.
///
/// # Errors
/// A file cannot be written.
pub fn write_pictures(directory: &Path, response: &ForcedResponse) -> io::Result<()> {
    let mut list: Vec<SoundPicture> = Vec::new();
    for (sound, body) in response.sounds.iter().zip(names(&response.sounds)) {
        let Some((skin, field)) = shown(sound) else { continue };
        let surface = Surface::of_triangles(&body, &skin.vertices, &skin.triangles);
        for (quantity, values) in QUANTITIES {
            let corners = Corners::new(skin, &values(field));
            let [least, largest] = corners.range();
            let size = largest.max(-least);
            let colour = |face: usize, corner: usize| {
                signed_colour(corners.values[face][corner] / size.max(f64::MIN_POSITIVE))
            };
            for view in View::ALL {
                let image = draw_coloured(&surface, 0.0, view, &colour);
                let file = name(list.len());
                fs::create_dir_all(directory.join(FOLDER))?;
                fs::write(path(directory, &file), image.png()?)?;
                list.push(SoundPicture {
                    body: body.clone(),
                    quantity: quantity.to_owned(),
                    view: view.name().to_owned(),
                    file,
                    frequency: sound.frequency(field.line, sound.own.speed),
                    range: [least, largest],
                    size: image.size(),
                });
            }
        }
    }
    if list.is_empty() {
        return Ok(());
    }
    fs::write(path(directory, PICTURES), serde_json::to_vec_pretty(&list)?)
}

/// Reads the pictures of a run directory with their content in base 64; those without a file are
/// left out.
pub fn read_pictures(directory: &Path) -> Vec<(SoundPicture, String)> {
    let content = fs::read(path(directory, PICTURES)).ok();
    let list: Vec<SoundPicture> =
        content.and_then(|content| serde_json::from_slice(&content).ok()).unwrap_or_default();
    let loaded = |picture: SoundPicture| {
        // The list may have been edited: it refers to files of its folder only.
        let is_own = is_picture_of_a_run(&picture.file) && !picture.file.contains(['/', '\\']);
        let content = is_own.then(|| fs::read(path(directory, &picture.file)).ok()).flatten()?;
        Some((picture, BASE64_STANDARD.encode(content)))
    };
    list.into_iter().filter_map(loaded).collect()
}

/// Values at the corners of triangles: means over the triangles of the same wall.
struct Corners {
    values: Vec<[f64; 3]>,
}

impl Corners {
    /// Averages values of triangles, weighted by their areas.
    fn new(skin: &Skin, values: &[f64]) -> Corners {
        let products: Vec<[f64; 3]> = skin.triangles.iter().map(|triangle| product(skin, triangle)).collect();
        let mut around: Vec<Vec<usize>> = vec![Vec::new(); skin.vertices.len()];
        for (index, triangle) in skin.triangles.iter().enumerate() {
            triangle.iter().for_each(|&vertex| around[vertex].push(index));
        }
        let size = |product: &[f64; 3]| dot(product, product).sqrt();
        let corner = |own: usize, vertex: usize| {
            let (mut sum, mut area) = (0.0, 0.0);
            for &other in &around[vertex] {
                let (one, two) = (&products[own], &products[other]);
                if dot(one, two) >= SMOOTH * size(one) * size(two) {
                    sum += values[other] * size(two);
                    area += size(two);
                }
            }
            if area > 0.0 { sum / area } else { values[own] }
        };
        let triangles = skin.triangles.iter().enumerate();
        Corners {
            values: triangles.map(|(own, triangle)| triangle.map(|vertex| corner(own, vertex))).collect(),
        }
    }

    /// Returns the least value, or zero if none is negative, and the largest one.
    fn range(&self) -> [f64; 2] {
        let all = self.values.iter().flatten().filter(|value| value.is_finite());
        all.fold([0.0, 0.0], |[least, largest], &value| [value.min(least), value.max(largest)])
    }
}

/// Returns twice the area of a triangle times its normal.
fn product(skin: &Skin, triangle: &[usize; 3]) -> [f64; 3] {
    let [a, b, c] = triangle.map(|vertex| skin.vertices[vertex]);
    let edge = |to: [f64; 3]| -> [f64; 3] { std::array::from_fn(|k| to[k] - a[k]) };
    let (p, q) = (edge(b), edge(c));
    [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
}

fn dot(one: &[f64; 3], other: &[f64; 3]) -> f64 {
    one[0] * other[0] + one[1] * other[1] + one[2] * other[2]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two triangles of a wall and one at a right angle: values are continuous on the wall only.
    #[test]
    fn values_are_continuous_on_a_wall() {
        let skin = Skin {
            vertices: vec![
                [0.0, 0.0, 0.0],
                [1.0, 0.0, 0.0],
                [1.0, 1.0, 0.0],
                [0.0, 1.0, 0.0],
                [1.0, 0.0, 1.0],
            ],
            triangles: vec![[0, 1, 2], [0, 2, 3], [1, 4, 2]],
            fields: Vec::new(),
        };
        let corners = Corners::new(&skin, &[1.0, 3.0, -7.0]);
        assert_eq!(corners.values, [[2.0, 1.0, 2.0], [2.0, 2.0, 3.0], [-7.0; 3]]);
        assert_eq!(corners.range(), [-7.0, 3.0]);
    }

    #[test]
    fn names_of_pictures_are_known() {
        assert!(is_picture_of_a_run("sound-003.png") && is_picture_of_a_run(PICTURES));
        assert!(!is_picture_of_a_run("sound.txt") && !is_picture_of_a_run("holiday.png"));
    }
}
