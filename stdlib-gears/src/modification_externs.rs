//! Flank modifications and deviations for programs: the Rust side of `tip_relief`, `lead_crown` and
//! similar functions in `gears.cx`.

use crate::deviation::Deviation;
use crate::error::GeometryError;
use crate::externs::host;
use crate::host::keep;
use crate::modification::{Modification, ReliefShape, TipRelief};
use calyx_abi::externs::Handle;
use calyx_abi::{Context, RuntimeError};

calyx_abi::externs! {
    Pure fn calyx_gears_tip_relief(context, depth: f64, start_roll_angle: f64, shape: String) -> Handle {
        stored(context, Ok(Modification::TipRelief(relief(depth, start_roll_angle, &shape))))
    }

    Pure fn calyx_gears_root_relief(context, depth: f64, start_roll_angle: f64, shape: String) -> Handle {
        stored(context, Ok(Modification::RootRelief(relief(depth, start_roll_angle, &shape))))
    }

    Pure fn calyx_gears_lead_crown(context, depth: f64) -> Handle {
        stored(context, Modification::lead_crown(depth))
    }

    Pure fn calyx_gears_profile_slope(context, deviation: f64) -> Handle {
        stored(context, Ok(Modification::ProfileSlope(deviation)))
    }

    Pure fn calyx_gears_helix_slope(context, deviation: f64) -> Handle {
        stored(context, Ok(Modification::HelixSlope(deviation)))
    }

    Pure fn calyx_gears_profile_table(context, roll_angles: Vec<f64>, depths: Vec<f64>) -> Handle {
        stored(context, Modification::profile_table(roll_angles, depths))
    }

    Pure fn calyx_gears_lead_table(context, axial_positions: Vec<f64>, depths: Vec<f64>) -> Handle {
        stored(context, Modification::lead_table(axial_positions, depths))
    }

    Pure fn calyx_gears_topography(context, roll_angles: Vec<f64>, axial_positions: Vec<f64>, depths: Vec<f64>) -> Handle {
        stored(context, Modification::topography(roll_angles, axial_positions, depths))
    }

    Pure fn calyx_gears_host_modification(context, name: String) -> Handle {
        let (place, host) = (context.place, host(context)?);
        let deviation = match host.provided.modifications.get(&name) {
            Some(deviation) => deviation.clone(),
            None => {
                host.note_unprovided("name", "flank modification", "the flank stays as it is", &name, place);
                Deviation::new(name, |_| 0.0)
            }
        };
        stored(context, Ok(deviation.into()))
    }
}

fn relief(depth: f64, start_roll: f64, shape: &str) -> TipRelief {
    let shape = if shape == "linear" { ReliefShape::Linear } else { ReliefShape::Quadratic };
    TipRelief { depth, start_roll, shape }
}

fn stored(context: &mut Context, made: Result<Modification, GeometryError>) -> Result<Handle, RuntimeError> {
    let (place, host) = (context.place, host(context)?);
    let modification = made.map_err(|error| host.rejected(error.into(), place))?;
    Ok(keep(&mut host.modifications, modification))
}
