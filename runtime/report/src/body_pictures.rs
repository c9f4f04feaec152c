//! Pictures of deformed bodies for the report page: the outer surface of each body with exaggerated
//! displacements, coloured by von Mises stress, at the position with the largest stress, or
//! displacement of beams.
//!
//! The pictures are files of a run directory with a list of what they show, so that the page
//! depends on files only. While positions are solved, the surfaces to be shown are stored: a
//! vibration has a new largest stress at many steps, and a drawing takes long. The
//! pictures are drawn for the page. Shafts are drawn in every run. The meshes of other bodies must
//! be factorized for it, so they are drawn in runs with VTU files only.

mod stored;
mod surface;
mod view;

use calyx_runtime::observables::Fields;
use serde::{Deserialize, Serialize};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
pub(crate) use surface::Surface;
pub(crate) use view::{View, draw_coloured, signed_colour};

pub use view::{colour_scale, signed_colour_scale};

/// Folder of the pictures in a run directory.
pub const FOLDER: &str = "pictures";
/// List of the pictures.
const LIST: &str = "list.json";
/// The list while it is being written.
const UNFINISHED: &str = "list.json.part";
/// Beginning of the names of the pictures.
const PREFIX: &str = "body-";
/// Extensions of surfaces that are not drawn yet, and of those while they are being written.
const STORED: [&str; 2] = ["surface", "surface.part"];
/// Largest exaggerated displacement relative to the size of the body.
const EXAGGERATED: f64 = 0.08;
/// Displacement relative to the size of the body below which it is a rounding error.
const ROUNDING: f64 = 1e-12;

/// Description of a picture.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BodyPicture {
    /// Name of the body.
    pub body: String,
    /// Name of the file.
    pub file: String,
    /// Index of the position.
    pub position: usize,
    /// Time of the position, s.
    pub time: f64,
    /// Factor on the displacements.
    pub exaggeration: f64,
    /// Largest displacement, m.
    pub largest_displacement: f64,
    /// Stress at the end of the colour scale, Pa.
    pub largest_stress: f64,
    /// Width and height, pixels; zero before it is drawn.
    pub size: [u32; 2],
}

/// Returns the names of the files of these fields, relative to the run directory; none without
/// bodies.
pub fn files_of(fields: &Fields) -> Vec<String> {
    let numbers = fields.bodies.iter().map(|body| body.number);
    let numbers = numbers.chain(fields.elastic_bodies.iter().map(|body| body.number));
    let mut files: Vec<String> =
        numbers.map(name).flat_map(|name| [stored(&name), vec![name]].concat()).collect();
    if !files.is_empty() {
        files.extend([LIST.to_owned(), UNFINISHED.to_owned()]);
    }
    files.into_iter().map(|name| format!("{FOLDER}/{name}")).collect()
}

/// Returns true if a run may write a file of this name into [`FOLDER`].
pub fn is_name_of_a_run(name: &str) -> bool {
    let is_picture = name.strip_prefix(PREFIX).and_then(|rest| rest.split_once('.'));
    let is_picture = is_picture.is_some_and(|(number, extension)| {
        number.bytes().all(|digit| digit.is_ascii_digit())
            && (extension == "png" || STORED.contains(&extension))
    });
    is_picture || [LIST, UNFINISHED].contains(&name)
}

fn name(number: usize) -> String {
    format!("{PREFIX}{number:03}.png")
}

/// Returns the names of the files of the surface of a picture.
fn stored(picture: &str) -> Vec<String> {
    let with = |extension: &&str| Path::new(picture).with_extension(extension).to_string_lossy().into_owned();
    STORED.iter().map(with).collect()
}

/// Returns the names of the files that [`draw`] writes or removes, relative to the run directory.
pub fn undrawn(directory: &Path) -> Vec<String> {
    let waiting: Vec<String> = read(directory)
        .into_iter()
        .filter(|picture| path(directory, &stored(&picture.file)[0]).exists())
        .flat_map(|picture| [stored(&picture.file), vec![picture.file]].concat())
        .collect();
    let lists = [LIST, UNFINISHED].map(str::to_owned);
    let lists = lists.into_iter().filter(|_| !waiting.is_empty());
    waiting.iter().cloned().chain(lists).map(|name| format!("{FOLDER}/{name}")).collect()
}

/// Returns the path of a file of the pictures in a run directory.
pub fn path(directory: &Path, file: &str) -> PathBuf {
    directory.join(FOLDER).join(file)
}

/// Returns the list of the pictures in a run directory; empty if there is none.
pub fn read(directory: &Path) -> Vec<BodyPicture> {
    let content = fs::read(path(directory, LIST)).ok();
    let list: Option<Vec<BodyPicture>> = content.and_then(|content| serde_json::from_slice(&content).ok());
    list.unwrap_or_default().into_iter().filter(|picture| is_name_of_a_run(&picture.file)).collect()
}

/// Stores the surfaces of the bodies whose largest stress at this position exceeds that of their
/// picture in the folder of a run directory, and updates the list.
///
/// # Errors
/// A file cannot be written.
pub fn update(directory: &Path, (position, time): (usize, f64), fields: &Fields) -> io::Result<()> {
    let mut list = if position == 0 { Vec::new() } else { read(directory) };
    let mut changed = false;
    for body in surface::all(fields) {
        let (largest_stress, largest_displacement) = (body.largest_stress(), body.largest_displacement());
        let known = list.iter().position(|picture: &BodyPicture| picture.body == body.name());
        // Beams have no stress.
        let is_less = |known: usize| match largest_stress > 0.0 {
            true => list[known].largest_stress >= largest_stress,
            false => list[known].largest_displacement >= largest_displacement,
        };
        if known.is_some_and(is_less) {
            continue;
        }
        let surface = body.surface();
        let file = name(surface.number);
        let picture = BodyPicture {
            body: surface.body.clone(),
            file,
            position,
            time,
            exaggeration: exaggeration(&surface),
            largest_displacement,
            largest_stress,
            size: [0; 2],
        };
        fs::create_dir_all(directory.join(FOLDER))?;
        let [complete, unfinished] = [0, 1].map(|k: usize| path(directory, &stored(&picture.file)[k]));
        fs::write(&unfinished, stored::file_of(&picture, &surface))?;
        fs::rename(unfinished, complete)?;
        match known {
            Some(known) => list[known] = picture,
            None => list.push(picture),
        }
        changed = true;
    }
    if changed { write_list(directory, &list) } else { Ok(()) }
}

/// Draws the stored surfaces of a run directory and removes them. One that another version wrote
/// is left out.
///
/// # Errors
/// A file cannot be read or written.
pub fn draw(directory: &Path) -> io::Result<()> {
    let mut list = read(directory);
    let mut drawn = Vec::new();
    for listed in &mut list {
        let waiting = path(directory, &stored(&listed.file)[0]);
        let bytes = match fs::read(&waiting) {
            Ok(bytes) => bytes,
            // It is drawn already.
            Err(error) if error.kind() == io::ErrorKind::NotFound => continue,
            Err(error) => return Err(error),
        };
        let Some((picture, surface)) = stored::read(&bytes) else { continue };
        let image = view::draw(&surface, picture.exaggeration, picture.largest_stress);
        fs::write(path(directory, &listed.file), image.png()?)?;
        // A run that was killed may have stored the surface and not the list.
        *listed = BodyPicture { size: image.size(), file: listed.file.clone(), ..picture };
        drawn.push(waiting);
    }
    if !drawn.is_empty() {
        write_list(directory, &list)?;
    }
    drawn.into_iter().try_for_each(fs::remove_file)
}

/// Replaces the list. A run that is ended meanwhile keeps its former list.
fn write_list(directory: &Path, list: &[BodyPicture]) -> io::Result<()> {
    let unfinished = path(directory, UNFINISHED);
    fs::write(&unfinished, serde_json::to_vec_pretty(list)?)?;
    fs::rename(unfinished, path(directory, LIST))
}

/// Returns the factor on the displacements: 1, 2 or 5 times a power of ten, not below 1. Those of
/// an unloaded body are rounding errors.
fn exaggeration(surface: &Surface) -> f64 {
    let wanted = EXAGGERATED * surface.diagonal() / surface.largest_displacement();
    if !(1.0..1.0 / ROUNDING).contains(&wanted) {
        return 1.0;
    }
    let power = 10.0_f64.powf(wanted.log10().floor());
    [5.0, 2.0].into_iter().find(|digit| digit * power <= wanted).unwrap_or(1.0) * power
}

#[cfg(test)]
mod tests {
    use super::*;
    use calyx_runtime::elastic::model::SolidShape;
    use calyx_runtime::elastic_body::CellShape;
    use calyx_runtime::observables::ElasticBodyField;

    /// A unit cube that is stretched along x; its stress grows with x to this value.
    pub(super) fn cube(number: usize, stress: f64) -> ElasticBodyField {
        let corner = |k: usize| [[0.0, 1.0, 1.0, 0.0][k % 4], [0.0, 0.0, 1.0, 1.0][k % 4], (k / 4) as f64];
        let points: Vec<[f64; 3]> = (0..8).map(corner).collect();
        ElasticBodyField {
            body: format!("cube {number}"),
            number,
            displacements: points.iter().map(|point| [1e-5 * point[0], 0.0, 0.0]).collect(),
            stresses: points.iter().map(|point| [stress * point[0], 0.0, 0.0, 0.0, 0.0, 0.0]).collect(),
            stress_errors: vec![0.0; points.len()],
            cells: vec![(CellShape::Solid(SolidShape::Hexahedron8), (0..8).collect())],
            points,
        }
    }

    fn fields(stress: f64) -> Fields {
        Fields { elastic_bodies: vec![cube(4, stress), cube(7, 2.0 * stress)], ..Fields::default() }
    }

    #[test]
    fn the_picture_is_that_of_the_position_with_the_largest_stress() {
        let directory = tempfile::tempdir().unwrap();
        for (position, stress) in [(0, 1e6), (1, 3e6), (2, 2e6)] {
            update(directory.path(), (position, 0.1 * position as f64), &fields(stress)).unwrap();
            // A drawn picture is replaced as well as one that is not drawn yet.
            if position != 1 {
                draw(directory.path()).unwrap();
            }
        }
        let list = read(directory.path());
        assert_eq!(list.len(), 2);
        let picture = &list[1];
        assert_eq!(
            (picture.body.as_str(), picture.file.as_str(), picture.position),
            ("cube 7", "body-007.png", 1)
        );
        assert_eq!((picture.largest_stress, picture.largest_displacement), (6e6, 1e-5));
        // 8 % of the diagonal are 13856 times the displacement.
        assert_eq!(picture.exaggeration, 1e4);
        for name in files_of(&fields(1.0)) {
            let own = name.strip_prefix("pictures/").unwrap();
            let remains = own == LIST || own.ends_with(".png");
            assert_eq!(directory.path().join(&name).exists(), remains, "{name}");
            assert!(is_name_of_a_run(own), "{name}");
        }
        assert!(files_of(&Fields::default()).is_empty() && undrawn(directory.path()).is_empty());
        for foreign in ["notes.txt", "body-000.svg", "../body-000.png", "body-/../000.png"] {
            assert!(!is_name_of_a_run(foreign), "{foreign}");
        }
        let file = fs::File::open(path(directory.path(), &picture.file)).unwrap();
        let reader = png::Decoder::new(io::BufReader::new(file)).read_info().unwrap();
        assert_eq!([reader.info().width, reader.info().height], picture.size);
        // A list of somebody else does not lead to other files.
        let foreign = [BodyPicture { file: "../run.json".into(), ..picture.clone() }];
        write_list(directory.path(), &foreign).unwrap();
        assert!(read(directory.path()).is_empty());
        // A new run replaces the pictures.
        update(directory.path(), (0, 0.0), &fields(1e5)).unwrap();
        assert_eq!(read(directory.path())[1].largest_stress, 2e5);
    }

    #[test]
    fn a_body_at_rest_is_not_exaggerated() {
        let mut field = cube(0, 0.0);
        field.displacements = vec![[0.0; 3]; 8];
        let all = Fields { elastic_bodies: vec![field], ..Fields::default() };
        let body = surface::all(&all).next().unwrap();
        assert_eq!((exaggeration(&body.surface()), body.largest_stress()), (1.0, 0.0));
    }
}
