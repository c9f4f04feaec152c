//! `calyx sound`: sound of the vibration in a universal file, or in results on a NASTRAN deck.

mod input;

use crate::messages::{MODEL_ERROR, MessageFormat, USAGE, beside};
use calyx::rt::console::{eprint, print, println};
use calyx::rt::progress::{Progress, ProgressFormat};
use calyx::rt::run_directory::{DirectoryError, Kind, RunDirectory};
use calyx::rt::{Engine, EngineConfig, InvalidParam, interrupt, surface_sound as tables};
use calyx_abi::description::UnitDescription;
use calyx_abi::quantity;
use calyx_abi::visible::visible;
use calyx_lang::units::Unit;
use calyx_runtime::acoustics::surface_sound::{SoundOptions, SurfaceSound, surface_sound};
use calyx_runtime::acoustics::{Fluid, RigidPlane, SoundMethod};
use calyx_runtime::error::EngineError;
use clap::{Args, ValueEnum};
use input::{File, Refused};
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;

pub const EXAMPLES: &str = "\
Examples:
  calyx sound housing.unv                                results go to housing.unv.sound
  calyx sound housing.unv --at \"0, 1 m, 0\" --at \"1 m, 0, 0\"
  calyx sound shell.unv --close-openings --method rayleigh --out sound
  calyx sound pump.unv --fluid water --plane \"0, -80 mm, 0 / 0, 1, 0\"
  calyx run gearbox.cx --unv && calyx sound gearbox.cx.run/unv/sound_surface-00.unv
  calyx sound housing.bdf --results housing.op2 --length-unit mm
  calyx sound housing.bdf --results modes.pch --close-openings

A universal file has a surface of triangles and quadrilaterals, or solid elements, whose skin is the
surface (datasets 2411 and 2412), and the motion of its nodes:
  frequency response (analysis type 5)  sound at each frequency, from displacements, velocities or
                                        accelerations, real or complex (dataset 55 or 2414)
  normal modes (analysis type 2)        radiation efficiency of each mode
  functions (dataset 58)                spectra or frequency responses by node and direction
Units are those of dataset 164, or SI without it.

A NASTRAN deck has the mesh: shells, or solid elements. Its results are an OP2 file (PARAM,POST,-1)
or a punch file (DISP(PUNCH)=ALL) with displacements, velocities or accelerations of a frequency
response, or normal modes, along the displacement coordinate systems of the deck or along the axes
of the basic system.

Amplitudes are peak values. Results per unit force are sound per unit force.

Exit status: 0 if the results were written, 1 if the file or its sound has errors or after an
interruption, 2 for wrong usage of the command.";

/// Methods by their names.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
#[value(rename_all = "snake_case")]
enum Method {
    /// Equivalent radiated power: plane waves everywhere
    Erp,
    /// Rayleigh integral: each part of the surface radiates as in a baffle
    Rayleigh,
    /// Boundary elements
    #[default]
    BoundaryElements,
}

/// Fluids by their names.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum FluidName {
    /// Air at 20 °C: 1.204 kg/m³, 343.2 m/s
    #[default]
    Air,
    /// Fresh water at 20 °C: 998.2 kg/m³, 1482 m/s
    Water,
}

#[derive(Args)]
pub struct Sound {
    /// The universal file (.unv or .uff), or the NASTRAN deck (.bdf or .dat) of `--results`
    file: PathBuf,
    /// Results on a NASTRAN deck: an OP2 file (.op2) or a punch file (.pch)
    #[arg(long, value_name = "FILE")]
    results: Option<PathBuf>,
    /// Unit of length of the NASTRAN deck, such as mm or inch [default: m]
    #[arg(long, value_name = "UNIT", value_parser = length_unit, requires = "results")]
    length_unit: Option<f64>,
    /// Method from velocities to sound
    #[arg(long, value_enum, default_value_t, value_name = "METHOD")]
    method: Method,
    /// Fluid around the body
    #[arg(long, value_enum, default_value_t, value_name = "FLUID")]
    fluid: FluidName,
    /// Compute the sound pressure at a point of the fluid; may be repeated
    ///
    /// Coordinates are those of the file, in m unless they have units. Needs boundary elements.
    #[arg(long, value_name = "X, Y, Z", allow_hyphen_values = true)]
    at: Vec<String>,
    /// Put a rigid plane, such as the ground, below or next to the body
    ///
    /// Give one of its points and, after a slash, its normal, which points into the fluid. Needs
    /// boundary elements.
    #[arg(long, value_name = "POINT/NORMAL", allow_hyphen_values = true)]
    plane: Option<String>,
    /// Close all openings of the surface by lids that move with their rims
    ///
    /// Without it, an open surface is an error, which lists the openings.
    #[arg(long)]
    close_openings: bool,
    /// Directory for the results [default: the file name with the suffix .sound]
    ///
    /// Contains sound.csv (one row per frequency or mode), sound_pressure.csv with `--at`, and
    /// sound.json.
    #[arg(short, long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Write to a directory that contains other files
    ///
    /// Files with the names of results are replaced; all others are kept.
    #[arg(long)]
    force: bool,
    /// Print the content of sound.json to standard output in place of the table
    #[arg(long)]
    json: bool,
    /// Number of threads [default: number of cores]
    #[arg(long, value_name = "N")]
    threads: Option<NonZeroUsize>,
    /// Print only the table and errors
    #[arg(long)]
    quiet: bool,
    /// Format of progress on standard error
    #[arg(long, value_enum, default_value_t, value_name = "FORMAT")]
    progress: ProgressFormat,
}

impl Sound {
    /// Returns the format of warnings; `None` if only errors are printed.
    pub fn warnings(&self) -> Option<MessageFormat> {
        (!self.quiet).then_some(MessageFormat::Human)
    }

    pub fn run(self) -> ExitCode {
        let format = MessageFormat::Human;
        let options = match self.options() {
            Ok(options) => options,
            Err(refused) => {
                format.refused(&refused);
                return ExitCode::from(USAGE);
            }
        };
        let read = |path: &Path, help: &str| {
            std::fs::read(path).map_err(|error| {
                format.failure(&format!("cannot read {}: {error}", path.display()), help);
                ExitCode::from(USAGE)
            })
        };
        let help = match self.results {
            Some(_) => "give the path of a NASTRAN deck, like housing.bdf",
            None => "give the path of a universal file, like housing.unv",
        };
        let content = match read(&self.file, help) {
            Ok(content) => content,
            Err(code) => return code,
        };
        let help = "give the path of an OP2 or a punch file, like housing.op2";
        let results = match self.results.as_deref().map(|path| read(path, help)).transpose() {
            Ok(results) => results,
            Err(code) => return code,
        };
        let directory = self.out.clone().unwrap_or_else(|| beside(&self.file, ".sound"));
        let locked = match RunDirectory::lock(&directory, Kind::Sound, self.force) {
            Ok(locked) => locked,
            Err(error) => return format.directory(&error),
        };
        let sound = match self.solve(&content, results.as_deref(), &options) {
            Ok(sound) => sound,
            Err(refused) => {
                refuse(&refused);
                return ExitCode::from(MODEL_ERROR);
            }
        };
        let name = self.file.display().to_string();
        let written = locked
            .claim_all(tables::files(&sound))
            .and_then(|()| {
                tables::FILES.iter().try_for_each(|file| match tables::files(&sound).contains(file) {
                    true => Ok(()),
                    false => locked.remove_owned(file),
                })
            })
            .map_err(|error| DirectoryError::Io { path: directory.clone(), error });
        if let Err(error) = written {
            return format.directory(&error);
        }
        if let Err(error) = tables::write(&directory, &name, &sound) {
            return format.unwritable(&directory, &error.to_string());
        }
        match self.json {
            true => println!("{:#}", tables::json(&name, &sound)),
            false => print!("{}", tables::text(&sound)),
        }
        if !self.quiet {
            sound.warnings.iter().for_each(|warning| format.warning(warning));
            sound.notes.iter().for_each(|note| format.note(&format!("note: {note}\n")));
            format.note(&format!("the results are in {}\n", directory.join(tables::SOUND).display()));
        }
        ExitCode::SUCCESS
    }

    fn solve(
        &self,
        content: &[u8],
        results: Option<&[u8]>,
        options: &SoundOptions,
    ) -> Result<SurfaceSound, Refused> {
        let progress = Arc::new(Progress::new(self.progress, self.quiet, true));
        progress.stage("reading");
        let file = File { path: &self.file, content };
        let read = match (self.results.as_deref(), results) {
            (Some(path), Some(content)) => {
                input::of_deck(file, File { path, content }, self.length_unit.unwrap_or(1.0))
            }
            _ => input::of_universal_file(file),
        };
        let found = read.and_then(|vibration| {
            progress.stage("frequencies");
            let threads = self.threads.map_or(0, NonZeroUsize::get);
            let engine = Engine::new(EngineConfig { threads, ..EngineConfig::default() });
            let shown = |done: usize, count: usize| progress.step(done.saturating_sub(1), count);
            let solved = engine.work(interrupt::flag(), |interrupt| {
                surface_sound(&vibration, options, interrupt, &mut |done, count| shown(done, count))
            });
            let refused = |error| Refused { file: self.file.display().to_string(), error };
            solved.and_then(|solved| solved).map_err(refused)
        });
        progress.finish();
        found
    }

    fn options(&self) -> Result<SoundOptions, InvalidParam> {
        let plane = self.plane.as_deref().map(plane).transpose()?;
        let point = |text: &String| vector(text, "--at", true);
        Ok(SoundOptions {
            fluid: match self.fluid {
                FluidName::Air => Fluid::AIR,
                FluidName::Water => Fluid::WATER,
            },
            method: match self.method {
                Method::Erp => SoundMethod::EquivalentPower,
                Method::Rayleigh => SoundMethod::Rayleigh,
                Method::BoundaryElements => SoundMethod::BoundaryElements,
            },
            plane,
            points: self.at.iter().map(point).collect::<Result<_, _>>()?,
            close_openings: self.close_openings,
        })
    }
}

/// Prints an error of a file or its sound.
fn refuse(Refused { file, error }: &Refused) {
    let EngineError { code, message, help, .. } = error;
    let mut text = format!("error[{code}]: {file}: {message}\n");
    if !help.is_empty() {
        text += &format!("  help: {help}\n");
    }
    eprint!("{}", visible(&text));
}

/// Parses a unit of length. Returns it in m.
fn length_unit(text: &str) -> Result<f64, String> {
    match length(&format!("1 {text}"))? {
        (value, true) if value > 0.0 => Ok(value),
        _ => Err(format!("`{text}` is no unit of length")),
    }
}

/// Parses a point and a normal.
fn plane(text: &str) -> Result<RigidPlane, InvalidParam> {
    let refused = |why: String| {
        InvalidParam::new(
            format!("`--plane \"{text}\"`: {why}"),
            "give a point and a normal, like `--plane \"0, -80 mm, 0 / 0, 1, 0\"`",
        )
    };
    let Some((point, normal)) = text.rsplit_once('/') else {
        return Err(refused("there is no `/` between point and normal".into()));
    };
    let (point, normal) = (vector(point, "--plane", true)?, vector(normal, "--plane", false)?);
    RigidPlane::new(point, normal).map_err(|error| refused(error.to_string()))
}

/// Parses a length or a number. Returns it in m, and whether it has a unit.
fn length(text: &str) -> Result<(f64, bool), String> {
    let of_unit = |unit: &Unit| {
        let (factor, dimension) = (unit.factor, unit.dimension.exponents());
        let names = unit.aliases.iter().chain([&unit.name]).map(|name| (*name).to_owned());
        names.map(|name| UnitDescription { name, factor, dimension }).collect::<Vec<_>>()
    };
    let units: Vec<UnitDescription> = Unit::all().iter().flat_map(of_unit).collect();
    let found = quantity::parse(text, &units)?;
    let metre = units.iter().find(|unit| unit.name == "m").map(|unit| unit.dimension);
    match found.unit && Some(found.dimension) != metre {
        true => Err(format!("`{}` is no length", text.trim())),
        false => Ok((found.value, found.unit)),
    }
}

/// Parses three components: lengths in m, if they have no units, or numbers.
fn vector(text: &str, option: &str, is_length: bool) -> Result<[f64; 3], InvalidParam> {
    let refused = |why: String| {
        let (form, unit) = if is_length { ("0.5 m, -200 mm, 0", " as lengths") } else { ("0, 1, 0", "") };
        InvalidParam::new(
            format!("`{option}`, `{}`: {why}", text.trim()),
            format!("give three components{unit}, like \"{form}\""),
        )
    };
    let parts: Vec<&str> = text.split(',').collect();
    let [x, y, z] = parts[..] else {
        return Err(refused(format!("it has {} components", parts.len())));
    };
    let component = |part: &str| match length(part) {
        Ok((value, has_unit)) if value.is_finite() && (is_length || !has_unit) => Ok(value),
        Ok((_, true)) if !is_length => Err(refused(format!("`{}` has a unit", part.trim()))),
        Ok(_) => Err(refused(format!("`{}` is not finite", part.trim()))),
        Err(why) => Err(refused(why)),
    };
    Ok([component(x)?, component(y)?, component(z)?])
}
