//! Plausibility checks of gear data. They detect values that are possible but probably unintended,
//! mostly quantities in a unit that is a thousand times too small or too large.
//!
//! Values that cannot be intended are errors; unusual values are warnings. Both suggest the value
//! that was probably meant. The limits lie far outside of actual products: materials from
//! elastomers to tungsten carbide, gears from watches to mills.

use crate::blank::Rim;
use crate::error::{GeometryError, Severity, sentence};
use crate::gear::ToothForm;
use crate::host::Finding;
use crate::prototype::GearPrototype;
use calyx_abi::RuntimeError;
use calyx_runtime::material::Material;
use std::f64::consts::PI;
use std::ops::RangeInclusive;

/// Plausible Young's moduli of gear materials, Pa: from soft polyurethane to tungsten carbide.
const YOUNGS_MODULI: RangeInclusive<f64> = 1e9..=1e12;
/// Young's moduli that a warning suggests, Pa.
const USUAL_YOUNGS_MODULI: RangeInclusive<f64> = 1e9..=800e9;
/// Plausible Poisson's ratios other than zero: from cork to rubber.
const POISSONS_RATIOS: RangeInclusive<f64> = 0.1..=0.5;
/// Plausible densities, kg/m³: from foamed plastic to tungsten; zero disables inertia.
const DENSITIES: RangeInclusive<f64> = 500.0..=25e3;
/// Face width in modules: values outside the first range are unusual, outside the second they are
/// mistakes.
const FACE_WIDTHS: RangeInclusive<f64> = 0.2..=150.0;
const POSSIBLE_FACE_WIDTHS: RangeInclusive<f64> = 0.02..=2000.0;
/// Face widths that a message suggests, in modules.
const USUAL_FACE_WIDTHS: RangeInclusive<f64> = 2.0..=50.0;
/// Face width in modules below which a module in inches is questioned.
const NARROW_FACE: f64 = 2.0;
/// Smallest thickness between the tooth spaces and the supported surface, and of the rim alone, in
/// modules.
const THINNEST_METAL: f64 = 0.4;
const THINNEST_RING: f64 = 0.1;
/// Largest single pitch deviation in modules: twice that of the lowest flank tolerance class of ISO
/// 1328-1 for small gears.
const LARGEST_PITCH_DEVIATION: f64 = 0.1;
/// Single pitch deviations that a message suggests, in modules.
const USUAL_PITCH_DEVIATIONS: RangeInclusive<f64> = 1e-4..=5e-2;
/// Largest pitch line velocity, m/s. No gear runs near the speed of sound in air.
const FASTEST: f64 = 300.0;
/// Factors of unit mistakes, the most frequent first.
const SLIPS: [f64; 6] = [1e3, 1e-3, 1e6, 1e-6, 25.4, 1.0 / 25.4];

const INCH: f64 = 25.4e-3;
const MILLIMETRE: f64 = 1e-3;

/// Value in the unit that was probably meant.
pub(crate) fn meant(value: f64, usual: &RangeInclusive<f64>) -> Option<f64> {
    SLIPS.into_iter().map(|factor| factor * value).find(|value| usual.contains(value))
}

/// Rounds a number to three digits for display.
fn shown(value: f64) -> f64 {
    format!("{value:.2e}").parse().unwrap_or(value)
}

/// Warnings about a material.
pub(crate) fn of_material(material: &Material, place: (u32, u32, u32)) -> Vec<Finding> {
    let Material { youngs_modulus, poissons_ratio, density } = *material;
    let mut found = Vec::new();
    let mut warn = |argument: &str, message: String, help: String| {
        let error = RuntimeError::new("E0802", message, help).of_argument(argument);
        let error = RuntimeError { place: Some(place), ..error };
        found.push(Finding { severity: Severity::Warning, error });
    };
    let pressure = |pascals: f64| match pascals {
        pascals if pascals < 1e9 => format!("{} MPa", shown(1e-6 * pascals)),
        pascals => format!("{} GPa", shown(1e-9 * pascals)),
    };
    if !YOUNGS_MODULI.contains(&youngs_modulus) {
        let slip = meant(youngs_modulus, &USUAL_YOUNGS_MODULI);
        let help = match slip {
            Some(meant) => format!("is {} meant? steel has 206 GPa, polyamide about 3 GPa", pressure(meant)),
            None => "steel has 206 GPa, polyamide about 3 GPa".into(),
        };
        let message = format!("a Young's modulus of {} is unusual for a gear", pressure(youngs_modulus));
        warn("youngs_modulus", message, help);
    }
    if poissons_ratio != 0.0 && !POISSONS_RATIOS.contains(&poissons_ratio) {
        let message = format!("a Poisson's ratio of {poissons_ratio} is unusual for a gear");
        warn("poissons_ratio", message, "is a digit wrong? steel has 0.3, plastics have 0.35 to 0.45".into());
    }
    if density != 0.0 && !DENSITIES.contains(&density) {
        let help = match meant(density, &(1e3..=20e3)) {
            Some(meant) => format!("is {} kg/m^3 meant? steel has 7850 kg/m^3", shown(meant)),
            None => "steel has 7850 kg/m^3, polyamide about 1140 kg/m^3".into(),
        };
        let message = format!("a density of {} kg/m^3 is unusual for a gear", shown(density));
        warn("density", message, help);
    }
    found
}

/// Argument that states the size of the teeth, with its value.
#[derive(Clone, Copy, Debug)]
pub(crate) enum StatedModule {
    /// Module, m.
    Module(&'static str, f64),
    /// Diametral pitch, 1/m.
    Pitch(&'static str, f64),
}

/// Errors and warnings about the face width, the rim and the pitch deviations of a generated gear.
/// `module` is the tool's module as given, and `stated` the argument that states it with its value,
/// a length or a diametral pitch, if any. `far` is the argument that states the blank in place of
/// `rim`, if any.
pub(crate) fn of_gear(
    gear: &GearPrototype,
    module: f64,
    stated: Option<StatedModule>,
    far: Option<&'static str>,
) -> Vec<GeometryError> {
    let slip = stated.and_then(|stated| match stated {
        StatedModule::Pitch(argument, pitch) => metric_pitch(gear.face_width, module, (argument, pitch)),
        StatedModule::Module(argument, module) => module_in_inches(gear.face_width, argument, module),
    });
    let found = [
        slip.or_else(|| face_width(gear.face_width, module)),
        thin_rim(&gear.form(), &gear.rim, module, far),
        pitch_deviations(&gear.form(), &gear.pitch_errors),
    ];
    found.into_iter().flatten().collect()
}

/// Detects more pitch deviations than teeth, and deviations that teeth next to each other cannot
/// have. `cumulative` contains the angle of each tooth, rad.
fn pitch_deviations(form: &ToothForm, cumulative: &[f64]) -> Option<GeometryError> {
    let teeth = form.teeth as usize;
    if cumulative.len() > teeth {
        return Some(GeometryError::error(
            "E0695",
            "pitch_errors",
            sentence!["there are ", number cumulative.len() as f64, " pitch deviations for ", number teeth as f64, " teeth"],
            sentence!["give one deviation for each tooth; teeth beyond the list have none"],
        ));
    }
    let at = |tooth: usize| form.pitch_radius * cumulative.get(tooth % teeth).copied().unwrap_or(0.0);
    let single = |tooth: &usize| (at(tooth + 1) - at(*tooth)).abs();
    let worst = (0..teeth).max_by(|a, b| single(a).total_cmp(&single(b)).then(b.cmp(a)))?;
    let deviation = single(&worst);
    let modules = deviation / form.module;
    if modules <= LARGEST_PITCH_DEVIATION {
        return None;
    }
    let message = sentence![
        "the single pitch deviation between teeth ", number worst as f64, " and ",
        number ((worst + 1) % teeth) as f64, " is ", length deviation, ", ", number shown(modules), " modules"
    ];
    let help = match meant(modules, &USUAL_PITCH_DEVIATIONS) {
        Some(meant) => {
            sentence!["is ", length meant * form.module, " meant? that of rough gears is below 0.1 modules"]
        }
        None => sentence!["the single pitch deviation of rough gears is below 0.1 modules"],
    };
    // Half a pitch moves a tooth into its neighbour.
    Some(match modules < 0.5 * PI {
        true => GeometryError::warning("E0695", "pitch_errors", message, help),
        false => GeometryError::error("E0695", "pitch_errors", message, help),
    })
}

/// Detects a diametral pitch in teeth per inch that is stated per millimetre: the face width is
/// unusual, and usual with a module of as many inches.
pub(crate) fn metric_pitch(
    face_width: f64,
    module: f64,
    (argument, pitch): (&'static str, f64),
) -> Option<GeometryError> {
    let per_inch = INCH / MILLIMETRE * module;
    if FACE_WIDTHS.contains(&(face_width / module)) || !FACE_WIDTHS.contains(&(face_width / per_inch)) {
        return None;
    }
    Some(GeometryError::warning(
        "E0803",
        argument,
        sentence![
            "a diametral pitch of ", number pitch * MILLIMETRE, " / mm is a module of ", length 1.0 / pitch,
            ", and the face is ", number shown(face_width / module), " modules wide"
        ],
        sentence![
            "is `", text argument, " = ", number pitch * MILLIMETRE, " / inch` meant? That is a module of ",
            length INCH / (pitch * MILLIMETRE)
        ],
    ))
}

/// Smallest module of a gear, m: that of the smallest watches.
const SMALLEST_MODULE: f64 = 0.04e-3;

/// Detects a module that no gear has and that is usual for the face width in a larger unit.
pub(crate) fn tiny_module(face_width: f64, (argument, module): (&'static str, f64)) -> Option<GeometryError> {
    if module >= SMALLEST_MODULE || USUAL_FACE_WIDTHS.contains(&(face_width / module)) {
        return None;
    }
    let larger = SLIPS.into_iter().filter(|factor| *factor > 1.0).map(|factor| factor * module);
    let mut usual = larger.filter(|module| USUAL_FACE_WIDTHS.contains(&(face_width / module)));
    let meant = usual.next()?;
    Some(GeometryError::warning(
        "E0803",
        argument,
        sentence![
            "a module of ", length module, " is smaller than that of any gear, and the face is ",
            number shown(face_width / module), " modules wide"
        ],
        sentence!["is `", text argument, " = ", length meant, "` meant?"],
    ))
}

/// Detects a module in inches that is probably in millimetres: the face is narrower than the teeth
/// are high, and usual with a module of as many millimetres.
fn module_in_inches(face_width: f64, argument: &'static str, module: f64) -> Option<GeometryError> {
    let inches = module / INCH;
    let digits = (1e3 * inches).round() / 1e3;
    let metric = face_width / (inches * MILLIMETRE);
    let is_written = (inches - digits).abs() <= 1e-9 * inches;
    if face_width >= NARROW_FACE * module || !is_written || !USUAL_FACE_WIDTHS.contains(&metric) {
        return None;
    }
    Some(GeometryError::warning(
        "E0803",
        argument,
        sentence![
            "a module of ", number digits, " inch is ", length module, ", and the face is only ",
            number shown(face_width / module), " modules wide"
        ],
        sentence![
            "is `", text argument, " = ", number digits, " mm` meant? Modules are in millimetres; gears in inches have a diametral pitch"
        ],
    ))
}

fn face_width(face_width: f64, module: f64) -> Option<GeometryError> {
    let modules = face_width / module;
    if FACE_WIDTHS.contains(&modules) {
        return None;
    }
    let message = sentence![
        "a face width of ", length face_width, " is ", number shown(modules), " times the module"
    ];
    let help = match meant(modules, &USUAL_FACE_WIDTHS) {
        Some(meant) => {
            sentence!["is ", length meant * module, " meant? usual faces are 5 to 20 modules wide"]
        }
        None => sentence!["usual faces are 5 to 20 modules wide; here that is ", length 10.0 * module],
    };
    Some(match POSSIBLE_FACE_WIDTHS.contains(&modules) {
        true => GeometryError::warning("E0803", "face_width", message, help),
        false => GeometryError::error("E0803", "face_width", message, help),
    })
}

/// Detects a rim that leaves hardly any material under or around the teeth, or that is itself very
/// thin.
fn thin_rim(form: &ToothForm, rim: &Rim, module: f64, far: Option<&'static str>) -> Option<GeometryError> {
    let metal = (form.root_radius - rim.ring_radius()).abs();
    let ring = (rim.radius - rim.ring_radius()).abs();
    let constrained = if form.internal { "outer_diameter" } else { "inner_diameter" };
    let usual = form.root_radius - form.sense() * 2.0 * module;
    if let (Some(argument), true) = (far, metal < THINNEST_METAL * module) {
        let (value, example) = match argument {
            "rim_thickness" => (metal, 2.0 * module),
            _ => (2.0 * rim.fixed_radius, 2.0 * usual),
        };
        return Some(GeometryError::warning(
            "E0804",
            argument,
            sentence![
                "`", text argument, "` of ", length value, " leaves only ", length metal,
                " of metal at the tooth spaces, ", number shown(metal / module),
                " modules: the teeth bend the rim more than themselves"
            ],
            sentence![
                "check the unit, and diameter or radius; with `", text argument, " = ", length example,
                "` the rim is two modules thick"
            ],
        ));
    }
    if metal < THINNEST_METAL * module {
        return Some(GeometryError::warning(
            "E0804",
            "rim",
            sentence![
                "only ", length metal, " of metal is left between the spaces and where the rim ends, ",
                number shown(metal / module), " modules: the teeth bend the rim more than themselves"
            ],
            sentence![
                "check that the rim is given by diameters, not radii; with `", text constrained, "` of ",
                length 2.0 * usual, " it is two modules thick"
            ],
        ));
    }
    (ring < THINNEST_RING * module).then(|| {
        GeometryError::warning(
            "E0804",
            "rim",
            sentence!["the ring between the two diameters of the rim is only ", length ring, " thick"],
            sentence![
                "the mesh of the teeth ends at `diameter`, and the gear is supported at `", text constrained,
                "`: with ", length 2.0 * usual, " there the rim is two modules thick"
            ],
        )
    })
}

/// Warns of an implausible pitch line velocity, from rad/s and the pitch radius in m.
pub(crate) fn pitch_line(speed: f64, pitch_radius: f64) -> Option<GeometryError> {
    let velocity = (speed * pitch_radius).abs();
    (velocity > FASTEST).then(|| {
        GeometryError::warning(
            "E0809",
            "first",
            sentence!["the pitch circle of this gear moves at ", number shown(velocity), " m/s"],
            sentence![
                "check the unit of the speed in its frame: 3000 rpm is 314.16 rad/s, 3000 rad/s is 28648 rpm"
            ],
        )
    })
}

/// Warns of planets that cannot be equally spaced; `teeth` is the sum of the teeth of sun and ring
/// (the assembly condition, see [`crate::phase_check`]).
pub(crate) fn unequal_planet_spacing(planets: f64, teeth: f64) -> Option<GeometryError> {
    if planets < 2.0 || teeth % planets == 0.0 {
        return None;
    }
    // Nearest sum that is a multiple of the number of planets; a change of the ring's number of
    // teeth preserves the module.
    let fitting = (teeth / planets).round() * planets;
    Some(GeometryError::warning(
        "E0808",
        "planets",
        sentence![
            number planets, " planets cannot be evenly spaced: sun and ring have ", number teeth,
            " teeth together, and ", number teeth, " / ", number planets, " is not an integer. They carry unequal shares of the load"
        ],
        sentence![
            "choose teeth of sun and ring that add up to a multiple of ", number planets, ", such as ", number fitting,
            "; or give the positions of the planets with `planet_angles`"
        ],
    ))
}
