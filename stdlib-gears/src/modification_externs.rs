//! Flank modifications and deviations for programs: the Rust side of `tip_relief`, `lead_crown` and
//! similar functions in `gears.cx`.

use crate::deviation::Deviation;
use crate::error::GeometryError;
use crate::externs::{entry, host, refusal};
use crate::host::keep;
use crate::modification::{
    EndRelief, FaceEnds, Modification, ReliefShape, ReliefStart, TipRelief, ToothFlank, without_start,
};
use calyx_abi::externs::Handle;
use calyx_abi::{Context, RuntimeError};
use calyx_runtime::scene::StructureOptions;

calyx_abi::externs! {
    Pure fn calyx_gears_tip_relief(
        context, depth: f64, start_roll_angle: Option<f64>, shape: String, exponent: Option<f64>,
        start_roll_length: Option<f64>, start_diameter: Option<f64>, length: Option<f64>, flank: String,
    ) -> Handle {
        let start = ReliefStart {
            roll_angle: start_roll_angle, roll_length: start_roll_length, diameter: start_diameter, length,
        };
        let relief = TipRelief { depth, start, shape: shape_named(&shape, exponent)? };
        stored(context, stated(relief, false).map(Modification::TipRelief), &flank)
    }

    Pure fn calyx_gears_root_relief(
        context, depth: f64, start_roll_angle: Option<f64>, shape: String, exponent: Option<f64>,
        start_roll_length: Option<f64>, start_diameter: Option<f64>, length: Option<f64>, flank: String,
    ) -> Handle {
        let start = ReliefStart {
            roll_angle: start_roll_angle, roll_length: start_roll_length, diameter: start_diameter, length,
        };
        let relief = TipRelief { depth, start, shape: shape_named(&shape, exponent)? };
        stored(context, stated(relief, true).map(Modification::RootRelief), &flank)
    }

    Pure fn calyx_gears_profile_crown(context, depth: f64, flank: String) -> Handle {
        stored(context, Ok(Modification::ProfileCrown(depth)), &flank)
    }

    Pure fn calyx_gears_lead_crown(context, depth: f64, flank: String) -> Handle {
        stored(context, Modification::lead_crown(depth), &flank)
    }

    Pure fn calyx_gears_end_relief(
        context, depth: f64, length: f64, end: String, shape: String, exponent: Option<f64>, flank: String,
    ) -> Handle {
        let ends = match end.as_str() {
            "+e3" => FaceEnds::Positive,
            "-e3" => FaceEnds::Negative,
            _ => FaceEnds::Both,
        };
        let shape = shape_named(&shape, exponent)?;
        stored(context, Ok(Modification::EndRelief(EndRelief { depth, length, shape, ends })), &flank)
    }

    Pure fn calyx_gears_twist(context, amount: f64, flank: String) -> Handle {
        stored(context, Ok(Modification::Twist(amount)), &flank)
    }

    Pure fn calyx_gears_profile_slope(context, deviation: f64, flank: String) -> Handle {
        stored(context, Ok(Modification::ProfileSlope(deviation)), &flank)
    }

    Pure fn calyx_gears_helix_slope(context, deviation: f64, flank: String) -> Handle {
        stored(context, Ok(Modification::HelixSlope(deviation)), &flank)
    }

    Pure fn calyx_gears_profile_table(context, roll_angles: Vec<f64>, depths: Vec<f64>, flank: String) -> Handle {
        stored(context, Modification::profile_table(roll_angles, depths), &flank)
    }

    Pure fn calyx_gears_lead_table(context, axial_positions: Vec<f64>, depths: Vec<f64>, flank: String) -> Handle {
        stored(context, Modification::lead_table(axial_positions, depths), &flank)
    }

    Pure fn calyx_gears_topography(
        context, roll_angles: Vec<f64>, axial_positions: Vec<f64>, depths: Vec<f64>, flank: String,
    ) -> Handle {
        stored(context, Modification::topography(roll_angles, axial_positions, depths), &flank)
    }

    Pure fn calyx_gears_host_modification(context, name: String, flank: String) -> Handle {
        let (place, host) = (context.place, host(context)?);
        let deviation = match host.provided.modifications.get(&name) {
            Some(deviation) => deviation.clone(),
            None => {
                host.note_unprovided("name", "flank modification", "the flank stays as it is", &name, place);
                Deviation::new(name, |_| 0.0)
            }
        };
        stored(context, Ok(deviation.into()), &flank)
    }

    Pure fn calyx_gears_as_deviation(context, modification: Handle) -> Handle {
        let host = host(context)?;
        let modification = entry(&host.modifications, modification)?.clone().unintended();
        Ok(keep(&mut host.modifications, modification))
    }

    Pure fn calyx_gears_modification_amount(
        context, gear: Handle, roll_angle: f64, axial_position: f64, flank: String,
    ) -> f64 {
        let gear = host(context)?.cylindrical("gear", gear)?;
        let form = gear.form();
        let side = flank_named(&flank).unwrap_or(ToothFlank::Left).side(form.internal);
        let surfaces = gear.surfaces(&StructureOptions::default());
        let surfaces = surfaces.map_err(|error| RuntimeError::new(error.code, error.message, error.help))?;
        Ok(surfaces[side.surface() as usize].amount_at(form.sense() * roll_angle, axial_position))
    }
}

/// Flank to which a modification is restricted; `None` for both.
fn flank_named(name: &str) -> Option<ToothFlank> {
    match name {
        "left" => Some(ToothFlank::Left),
        "right" => Some(ToothFlank::Right),
        _ => None,
    }
}

/// Shape of a relief, from its name and the exponent of a progressive one.
fn shape_named(name: &str, exponent: Option<f64>) -> Result<ReliefShape, RuntimeError> {
    match (name, exponent) {
        ("progressive", Some(exponent)) => Ok(ReliefShape::Progressive(exponent)),
        ("progressive", None) => Err(refusal(
            "E0937",
            "exponent",
            "a progressive relief needs an exponent",
            "give it, like `exponent = 1.5`; an exponent of 2 is the shape \"quadratic\"",
        )),
        (_, Some(exponent)) => Err(refusal(
            "E0937",
            "exponent",
            &format!("the exponent {exponent} has no effect on a relief of the shape \"{name}\""),
            "choose `shape = \"progressive\"`, or leave the exponent out",
        )),
        ("linear", None) => Ok(ReliefShape::Linear),
        ("arc", None) => Ok(ReliefShape::Arc),
        (_, None) => Ok(ReliefShape::Quadratic),
    }
}

/// Checks that the start of a profile relief is stated. Whether it lies on the flank is checked
/// with the gear.
fn stated(relief: TipRelief, at_root: bool) -> Result<TipRelief, GeometryError> {
    if relief.start.is_empty() { Err(without_start(at_root)) } else { Ok(relief) }
}

fn stored(
    context: &mut Context,
    made: Result<Modification, GeometryError>,
    flank: &str,
) -> Result<Handle, RuntimeError> {
    let (place, host) = (context.place, host(context)?);
    let modification = made.map_err(|error| host.rejected(error.into(), place))?;
    let modification = match flank_named(flank) {
        Some(flank) => modification.on(flank),
        None => modification,
    };
    Ok(keep(&mut host.modifications, modification))
}
