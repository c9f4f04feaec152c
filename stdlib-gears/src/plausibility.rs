//! Data that a gear may have and that nobody gives on purpose: mostly quantities in a unit that is
//! a thousand times too small or too large.
//!
//! What cannot be meant is an error; what is only unusual is a warning. Both name the value that
//! was probably meant. The limits lie far outside of what is made: materials from elastomers to
//! tungsten carbide, gears from watches to mills.

use crate::blank::{Rim, Thickness};
use crate::error::{GeometryError, Severity, sentence};
use crate::gear::ToothForm;
use crate::host::Finding;
use crate::prototype::GearPrototype;
use calyx_abi::RuntimeError;
use calyx_runtime::material::Material;
use std::ops::RangeInclusive;

/// Young's modulus of materials that gears are made of, Pa: from soft polyurethane to tungsten
/// carbide.
const YOUNGS_MODULI: RangeInclusive<f64> = 1e9..=1e12;
/// The same of what a warning suggests.
const USUAL_YOUNGS_MODULI: RangeInclusive<f64> = 1e9..=800e9;
/// Poisson's ratio, where it is not zero: from cork to rubber.
const POISSONS_RATIOS: RangeInclusive<f64> = 0.1..=0.5;
/// Density, kg/m³: from foamed plastic to tungsten; zero leaves inertia out.
const DENSITIES: RangeInclusive<f64> = 500.0..=25e3;
/// Face width in modules: beyond the first range it is unusual, beyond the second a slip.
const FACE_WIDTHS: RangeInclusive<f64> = 0.2..=150.0;
const POSSIBLE_FACE_WIDTHS: RangeInclusive<f64> = 0.02..=2000.0;
/// The same of what a message suggests.
const USUAL_FACE_WIDTHS: RangeInclusive<f64> = 2.0..=50.0;
/// Thinnest metal between the spaces and where the gear is held, and thinnest ring that a rim adds,
/// in modules.
const THINNEST_METAL: f64 = 0.4;
const THINNEST_RING: f64 = 0.1;
/// Thickness in modules up to which a profile shift and a tooth thickness are the same: more than
/// the rounding of a drawing.
const SAME_THICKNESS: f64 = 1e-3;
/// Fastest pitch line, m/s: beyond the speed of sound in air no gear runs.
const FASTEST: f64 = 300.0;
/// Factors of slips of units, the commonest first.
const SLIPS: [f64; 6] = [1e3, 1e-3, 1e6, 1e-6, 25.4, 1.0 / 25.4];

/// What a value would be in the unit that was probably meant.
fn meant(value: f64, usual: &RangeInclusive<f64>) -> Option<f64> {
    SLIPS.into_iter().map(|factor| factor * value).find(|value| usual.contains(value))
}

/// To three digits.
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

/// What is wrong or unusual about the face and the rim of a gear that has been cut. The module is
/// that of the tool as it was given.
pub(crate) fn of_gear(gear: &GearPrototype, module: f64) -> Vec<GeometryError> {
    let found = [face_width(gear.face_width, module), thin_rim(&gear.form(), &gear.rim, module)];
    found.into_iter().flatten().collect()
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

/// A rim under or around the teeth that leaves hardly any metal there, or is hardly there itself.
fn thin_rim(form: &ToothForm, rim: &Rim, module: f64) -> Option<GeometryError> {
    let metal = (form.root_radius - rim.ring_radius()).abs();
    let ring = (rim.radius - rim.ring_radius()).abs();
    let held = if form.internal { "outer_diameter" } else { "inner_diameter" };
    let usual = form.root_radius - form.sense() * 2.0 * module;
    if metal < THINNEST_METAL * module {
        return Some(GeometryError::warning(
            "E0804",
            "rim",
            sentence![
                "only ", length metal, " of metal is left between the spaces and where the rim ends, ",
                number shown(metal / module), " modules: the teeth bend the rim more than themselves"
            ],
            sentence![
                "check that the rim is given by diameters, not radii; with `", text held, "` of ",
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
                "the mesh of the teeth ends at `diameter`, and the gear is supported at `", text held,
                "`: with ", length 2.0 * usual, " there the rim is two modules thick"
            ],
        )
    })
}

/// The thickness that a tooth thickness and a profile shift coefficient give together, one of which
/// may be zero and then counts as left out. `of_shift` gives the thickness of a shift, and `module`
/// is that of the tool.
///
/// # Errors
/// E0605: the thickness is negative. E0805: they contradict each other.
pub(crate) fn thickness(
    tooth_thickness: f64,
    profile_shift: f64,
    module: f64,
    of_shift: impl Fn(f64) -> f64,
) -> Result<Thickness, GeometryError> {
    if tooth_thickness == 0.0 {
        return Ok(Thickness::ProfileShift(profile_shift));
    }
    let shifted = of_shift(profile_shift);
    if profile_shift == 0.0 || (tooth_thickness - shifted).abs() <= SAME_THICKNESS * module {
        return Ok(Thickness::Circular(tooth_thickness));
    }
    // The thickness is linear in the shift.
    let slope = of_shift(1.0) - of_shift(0.0);
    let shift = (tooth_thickness - of_shift(0.0)) / slope;
    Err(GeometryError::error(
        "E0805",
        "profile_shift",
        sentence![
            "a profile shift of ", number profile_shift, " makes teeth ", length shifted,
            " thick, but `tooth_thickness` is ", length tooth_thickness
        ],
        sentence![
            "leave one of them out; the thickness alone is that of a profile shift of ", number shift
        ],
    ))
}

/// Warns of a speed that no gear runs at: rad/s on a pitch radius in m.
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

/// Warns of planets that cannot be evenly spaced; `teeth` are those of sun and ring together (the
/// assembly condition, see [`crate::phase_check`]).
pub(crate) fn unequal_planet_spacing(planets: f64, teeth: f64) -> Option<GeometryError> {
    if planets < 2.0 || teeth % planets == 0.0 {
        return None;
    }
    // The nearest sum that planets divide; one tooth more on the ring keeps the module.
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
            "; or give the positions of the planets with `places`"
        ],
    ))
}
