//! Reads the data of the page from the files of a run directory, of a run that is finished,
//! stopped, in progress or killed.

use super::units::{self, Unit, Units};
use crate::bearing_loads::{self, ElementLoad, RollerLamina};
use crate::body_pictures::{self, BodyPicture};
use crate::choices;
use crate::contact_pattern::{self, PathPoint, PressurePoint};
use crate::directory::{CHOICES, SIGNALS, read_run};
use crate::field_tables::{COAST, FORMER_SIDES, LINE_LOAD};
use crate::flank_tables::FlankTables;
use crate::forced_response::{self, ResponseRow};
use crate::former_keys::{self, ResultFile};
use crate::radiated_sound::{self, SoundTables};
use crate::sensitivity::{DerivativeRow, read_table};
use crate::stress_range::{self, StressExtremes};
use crate::{journal, modes_table};
use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use calyx_abi::units::from_si;
use serde::Deserialize;
use serde_json::Value;
use std::fs;
use std::io;
use std::path::Path;

/// Lengths below this are rounding errors, m.
const ROUNDING: f64 = 1e-12;

/// End of a run.
#[derive(Clone, Debug, PartialEq)]
pub enum End {
    Finished,
    /// Stopped; the reason.
    Stopped(String),
    /// In progress, or killed.
    Open,
}

/// A run, read from its files.
pub struct Run {
    /// `run.json`, or the head of the journal.
    pub head: Value,
    pub end: End,
    pub timing: Option<Value>,
    /// Rows of `steps.csv`; empty for a model without an analysis.
    pub positions: Vec<Position>,
    pub outputs: Vec<Output>,
    pub contact: Vec<Loaded>,
    /// Loaded contact of gears on general axes.
    pub contact_pattern: Vec<PressurePoint>,
    pub contact_path: Vec<PathPoint>,
    /// Flanks, unloaded contact and ease-off of gears on general axes.
    pub flanks: FlankTables,
    pub stresses: Vec<StressExtremes>,
    /// Elements of the rolling bearings.
    pub elements: Vec<ElementLoad>,
    /// Laminae of the most loaded rollers.
    pub laminae: Vec<RollerLamina>,
    pub pictures: Vec<Picture>,
    /// Pictures of bodies, with the content of their files in base 64.
    pub bodies: Vec<(BodyPicture, String)>,
    /// Forced response over the speed.
    pub forced_response: Vec<ResponseRow>,
    /// Radiated sound.
    pub radiated_sound: SoundTables,
    /// Natural frequencies of the forced response, Hz.
    pub natural_frequencies: Vec<f64>,
    /// Table of modes with its header.
    pub modes: Vec<Vec<String>>,
    /// Derivatives that the model requests.
    pub sensitivities: Vec<DerivativeRow>,
    /// Results of the trade-off command for this model.
    pub tradeoff: Option<Value>,
    /// Names of the files in the directory.
    pub files: Vec<String>,
}

/// A row of `steps.csv` without its outputs.
#[derive(Clone, Debug, PartialEq)]
pub struct Position {
    /// Time, s.
    pub time: f64,
    /// Fraction of the mesh cycle.
    pub cycle: f64,
    /// Roll angle, rad.
    pub roll: f64,
    /// Name of the characteristic point, or empty.
    pub point: String,
}

/// An output in the unit in which the model shows it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Output {
    pub name: String,
    pub doc: String,
    pub unit: String,
    /// Choices that the values number from 0; empty for other numbers.
    pub choices: Vec<String>,
    /// Values by position.
    pub values: Vec<f64>,
    pub statistics: Statistics,
    /// Description of the location of the maximum.
    pub place: String,
    /// Harmonics of the mesh frequency: order and amplitude.
    pub harmonics: Vec<(u64, f64)>,
    pub error: Option<Estimate>,
}

/// Statistics of an output.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Statistics {
    pub min: f64,
    pub max: f64,
    /// `None` for an unfinished run.
    pub mean: Option<f64>,
    pub peak_to_peak: f64,
}

impl Statistics {
    /// Reads statistics from JSON in SI.
    fn of(json: &Value, factor: f64) -> Option<Statistics> {
        let number = |name: &str| Some(from_si(json[name].as_f64()?, factor));
        Some(Statistics {
            min: number("min")?,
            max: number("max")?,
            mean: number("mean"),
            peak_to_peak: number("peak_to_peak")?,
        })
    }

    /// Computes statistics of the rows that exist.
    fn of_values(values: &[f64]) -> Statistics {
        let finite = || values.iter().copied().filter(|value| value.is_finite());
        let (min, max) = (finite().fold(f64::INFINITY, f64::min), finite().fold(f64::NEG_INFINITY, f64::max));
        let known = |value: f64| if min <= max { value } else { f64::NAN };
        Statistics { min: known(min), max: known(max), mean: None, peak_to_peak: known(max - min) }
    }

    /// Returns the largest magnitude.
    pub fn magnitude(&self) -> f64 {
        self.min.abs().max(self.max.abs())
    }
}

/// Estimated error of an output.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Estimate {
    pub total: Statistics,
    /// Error relative to the largest magnitude; NaN if that is zero.
    pub relative: f64,
    /// True if values and errors are rounding errors only.
    pub is_rounding: bool,
    /// Magnitude up to which a value is a rounding error.
    pub rounding: f64,
    /// Errors by source.
    pub parts: Vec<(String, Statistics)>,
    /// Errors that were not estimated, with the reason; empty for runs that do not report them.
    pub not_estimated: Vec<(String, String)>,
}

impl Estimate {
    /// Returns true if the error of the fidelity level itself is included.
    pub fn includes_level(&self) -> bool {
        self.parts.iter().any(|(part, _)| part == "level")
    }

    fn of(json: &Value, factor: f64) -> Option<Estimate> {
        let parts = json["parts"].as_object().into_iter().flatten();
        let names = json["not_estimated"].as_array().into_iter().flatten();
        Some(Estimate {
            total: Statistics::of(json, factor)?,
            relative: json["relative"].as_f64().unwrap_or(f64::NAN),
            is_rounding: json["is_rounding"].as_bool().unwrap_or(false),
            rounding: from_si(json["rounding"].as_f64().unwrap_or(0.0), factor),
            parts: parts
                .filter_map(|(name, part)| Some((name.clone(), Statistics::of(part, factor)?)))
                .collect(),
            not_estimated: names
                .filter_map(Value::as_str)
                .map(|name| (name.to_owned(), json["reasons"][name].as_str().unwrap_or_default().to_owned()))
                .collect(),
        })
    }
}

/// Row of `line_load.csv`, SI.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub struct Loaded {
    pub step: usize,
    pub first_body: String,
    pub first_tooth: u32,
    pub second_body: String,
    pub second_tooth: u32,
    /// [`DRIVE`](crate::field_tables::DRIVE) or [`COAST`]; empty for runs without the column.
    #[serde(default)]
    pub flank: String,
    /// One of [`FORMER_SIDES`]; empty for runs without the column.
    #[serde(default)]
    pub side: String,
    pub first_radius: f64,
    pub first_roll_angle: Option<f64>,
    pub second_radius: f64,
    pub second_roll_angle: Option<f64>,
    pub axial: Option<f64>,
    pub length: f64,
    pub force: f64,
    pub line_load: f64,
    /// Pressure away from edges.
    pub pressure: f64,
    /// Pressure on and next to edges; zero for runs that did not separate the two.
    #[serde(default)]
    pub edge_pressure: f64,
    #[serde(default)]
    pub sliding_velocity: Option<f64>,
    /// Frictional power per length of the contact line; `None` for a mesh without lubrication.
    #[serde(default)]
    pub friction_power: Option<f64>,
    #[serde(default)]
    pub flash_temperature: Option<f64>,
    #[serde(default)]
    pub film_thickness: Option<f64>,
}

impl Loaded {
    /// Returns true for the coast side of a tooth.
    pub fn is_coast_side(&self) -> bool {
        self.flank == COAST || (self.flank.is_empty() && self.side == FORMER_SIDES[1])
    }
}

/// Plot drawn by the run.
pub struct Picture {
    pub name: String,
    /// SVG text.
    pub svg: String,
}

impl Output {
    /// Returns true if any position has a value: a fidelity level may not support the output.
    pub fn has_values(&self) -> bool {
        self.values.iter().any(|value| value.is_finite())
    }

    /// Returns the choices by position as text; `None` for an output that numbers no choices.
    pub fn shown_choices(&self) -> Option<String> {
        let values = self.values.iter().copied();
        (!self.choices.is_empty()).then(|| choices::described(&choices::counts(&self.choices, values)))
    }

    /// Returns the error of the value of largest magnitude.
    pub fn of_largest(&self, errors: &Statistics) -> f64 {
        let Statistics { min, max, .. } = self.statistics;
        if max.abs() >= min.abs() { errors.max } else { errors.min }
    }
}

impl Run {
    /// Reads a run.
    ///
    /// # Errors
    /// There is no run in the directory, or its files are not those of a run.
    pub fn read(directory: &Path) -> io::Result<Run> {
        let (head, end) = match (journal::find(directory)?, read_run(directory)?) {
            (_, Some(run)) if run.get("incomplete").is_some() => {
                let why = run["incomplete"]["message"].as_str().unwrap_or("it was stopped").to_owned();
                (run, End::Stopped(why))
            }
            // The journal is removed last.
            (None, Some(run)) => (run, End::Finished),
            (Some(found), _) => (found.head, End::Open),
            (None, None) => {
                return Err(io::Error::new(
                    io::ErrorKind::NotFound,
                    "there is neither a run.json nor a journal",
                ));
            }
        };
        let timing = match fs::read(directory.join("timing.json")) {
            Ok(text) if end == End::Finished => {
                Some(former_keys::current(ResultFile::Timing, serde_json::from_slice(&text)?))
            }
            _ => None,
        };
        let (positions, columns) = steps(&directory.join("steps.csv"))?;
        let clock = units::clock(positions.iter().map(|position| position.time));
        let has_roll = positions.iter().any(|position| position.roll != 0.0);
        let of = |(name, values)| output(&head, name, values, (clock, has_roll));
        let outputs = columns.into_iter().map(of).collect();
        Ok(Run {
            end,
            timing,
            positions,
            outputs,
            contact: contact(&directory.join(LINE_LOAD))?,
            contact_pattern: contact_pattern::read_pattern(directory)?,
            contact_path: contact_pattern::read_path(directory)?,
            flanks: FlankTables::read(directory)?,
            stresses: stress_range::read(directory)?,
            elements: bearing_loads::read_elements(directory)?,
            laminae: bearing_loads::read_rollers(directory)?,
            pictures: pictures(directory, &head)?,
            bodies: bodies(directory),
            forced_response: forced_response::read(directory)?,
            radiated_sound: radiated_sound::read(directory)?,
            natural_frequencies: forced_response::read_modes(directory)?,
            modes: table(&directory.join(modes_table::NAME))?,
            sensitivities: read_table(directory)?,
            tradeoff: tradeoff(directory),
            files: files(directory)?,
            head,
        })
    }

    /// Returns true for the outputs of a model without an analysis.
    pub fn is_calculation(&self) -> bool {
        self.end == End::Finished && self.head["fidelity"].is_null()
    }

    /// Returns a text of the head; empty if it has none.
    pub fn text(&self, name: &str) -> &str {
        self.head[name].as_str().unwrap_or_default()
    }
}

/// Values by name.
type Columns = Vec<(String, Vec<f64>)>;

/// Reads the pictures of bodies that exist.
fn bodies(directory: &Path) -> Vec<(BodyPicture, String)> {
    let content = |picture: BodyPicture| {
        let content = fs::read(body_pictures::path(directory, &picture.file)).ok()?;
        Some((picture, BASE64_STANDARD.encode(content)))
    };
    body_pictures::read(directory).into_iter().filter_map(content).collect()
}

fn steps(path: &Path) -> io::Result<(Vec<Position>, Columns)> {
    if !path.exists() {
        return Ok((Vec::new(), Vec::new()));
    }
    let mut reader = csv::ReaderBuilder::new().flexible(true).from_path(path)?;
    let names: Vec<String> = reader.headers()?.iter().skip(5).map(str::to_owned).collect();
    let mut columns: Columns = names.into_iter().map(|name| (name, Vec::new())).collect();
    let mut positions = Vec::new();
    for record in reader.records() {
        let record = record?;
        // A row that was incomplete when the run ended.
        if record.len() < 5 + columns.len() {
            break;
        }
        let number = |column: usize| record[column].parse().unwrap_or(f64::NAN);
        let [time, cycle, roll] = [1, 2, 3].map(number);
        positions.push(Position { time, cycle, roll, point: record[4].to_owned() });
        columns.iter_mut().enumerate().for_each(|(index, (_, values))| values.push(number(5 + index)));
    }
    Ok((positions, columns))
}

/// Reads an output from `run.json`, or from the head of an unfinished run.
fn output(head: &Value, name: String, values: Vec<f64>, (clock, has_roll): (Unit, bool)) -> Output {
    let said = match head["outputs"].get(&name) {
        Some(said) => said,
        None => &head["columns"][&name],
    };
    let factor = said["display"]["factor"].as_f64().unwrap_or(1.0);
    let values: Vec<f64> = values.into_iter().map(|value| from_si(value, factor)).collect();
    let text = |value: &Value| value.as_str().unwrap_or_default().to_owned();
    let harmonics = said["harmonics"].as_array().into_iter().flatten();
    let harmonic = |one: &Value| Some((one["order"].as_u64()?, from_si(one["amplitude"].as_f64()?, factor)));
    Output {
        doc: text(&said["doc"]),
        unit: text(&said["display"]["unit"]),
        choices: said[CHOICES].as_array().into_iter().flatten().map(text).collect(),
        statistics: Statistics::of(said, factor).unwrap_or_else(|| Statistics::of_values(&values)),
        place: {
            let units = Units::of_system(head["units"].as_str().unwrap_or_default());
            place(&said["max_at"], units, (clock, has_roll))
        },
        harmonics: harmonics.filter_map(harmonic).collect(),
        error: Estimate::of(&said["error_estimate"], factor),
        values,
        name,
    }
}

/// Describes the location of a maximum. `has_roll` is true if positions have roll angles.
fn place(at: &Value, units: Units, (clock, has_roll): (Unit, bool)) -> String {
    let mut words = Vec::new();
    match at["roll_angle"].as_f64() {
        Some(roll) if has_roll || roll != 0.0 => words.push(format!("roll angle {:.2}°", roll.to_degrees())),
        _ => words.extend(
            at["time"].as_f64().map(|time| format!("{} {}", super::number(clock.of(time)), clock.name)),
        ),
    }
    words.extend(at["point"].as_str().filter(|point| !point.is_empty()).map(str::to_owned));
    if let (Some(body), Some(tooth)) = (at["location"]["body"].as_str(), at["location"]["tooth"].as_u64()) {
        words.push(format!("{body}, tooth {tooth}"));
    }
    let length = |si: f64| format!("{} {}", super::number(units.length.of(si)), units.length.name);
    words.extend(at["location"]["radius"].as_f64().map(|radius| format!("radius {}", length(radius))));
    // A rounding error from the middle of a cylindrical gear is the middle.
    let axial =
        at["location"]["axial"].as_f64().map(|axial| if axial.abs() < ROUNDING { 0.0 } else { axial });
    words.extend(axial.map(|axial| format!("axial position {}", length(axial))));
    words.join(", ")
}

fn contact(path: &Path) -> io::Result<Vec<Loaded>> {
    if !path.exists() {
        return Ok(Vec::new());
    }
    let mut reader = csv::ReaderBuilder::new().flexible(true).from_path(path)?;
    // Drops a row that was incomplete when the run ended.
    Ok(reader.deserialize().map_while(Result::ok).collect())
}

fn table(path: &Path) -> io::Result<Vec<Vec<String>>> {
    if !path.exists() {
        return Ok(Vec::new());
    }
    let mut reader = csv::ReaderBuilder::new().has_headers(false).from_path(path)?;
    let cells = |record: csv::StringRecord| record.iter().map(str::to_owned).collect();
    reader.records().map(|record| Ok(cells(record?))).collect()
}

/// Returns the plots that the run lists, in its order.
fn pictures(directory: &Path, head: &Value) -> io::Result<Vec<Picture>> {
    let listed = head["signals"].as_array().into_iter().flatten();
    let named = listed.filter_map(|signal| signal["plot"].as_str());
    let names = named.filter_map(|path| path.strip_prefix(SIGNALS)?.strip_prefix('/')?.strip_suffix(".svg"));
    // Excludes paths outside of the directory.
    let names = names.filter(|name| !name.contains(['/', '\\']));
    names
        .map(|name| {
            let svg = fs::read_to_string(directory.join(SIGNALS).join(format!("{name}.svg")))?;
            Ok(Picture { name: name.replace('_', " "), svg })
        })
        .collect()
}

/// Reads the results of the trade-off command next to the run directory.
fn tradeoff(directory: &Path) -> Option<Value> {
    let name = directory.file_name()?.to_str()?.strip_suffix(".run")?;
    let text = fs::read(directory.with_file_name(format!("{name}.tradeoff")).join("tradeoff.json")).ok()?;
    Some(former_keys::current(ResultFile::Tradeoff, serde_json::from_slice(&text).ok()?))
}

fn files(directory: &Path) -> io::Result<Vec<String>> {
    let mut names = Vec::new();
    for entry in fs::read_dir(directory)? {
        let entry = entry?;
        let slash = if entry.file_type()?.is_dir() { "/" } else { "" };
        names.push(format!("{}{slash}", entry.file_name().to_string_lossy()));
    }
    // Excludes the page itself and temporary files, so that the list is the same for every command.
    let hidden = |name: &str| name.starts_with('.') || name.ends_with(".part");
    names.retain(|name| name != crate::directory::REPORT && !hidden(name));
    names.sort();
    Ok(names)
}

/// Returns the entries of a JSON object; none for another value.
pub fn objects(value: &Value) -> impl Iterator<Item = (&String, &Value)> {
    value.as_object().into_iter().flatten()
}
