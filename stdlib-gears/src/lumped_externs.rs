//! Functions of the lumped-parameter model of planetary gear sets for programs: the Rust side of
//! the model in `gears.cx`.

use crate::externs::{entry, host, refusal};
use crate::host::keep;
use crate::lumped_planetary::{LumpedError, LumpedMember, LumpedMesh, LumpedPlanetary, Mode, equally_spaced};
use calyx_abi::externs::Handle;
use calyx_abi::{Context, RuntimeError};

/// Degrees of freedom of a member, with the names that bodies use for theirs.
const DOF_NAMES: [&str; 3] = ["u_x", "u_y", "theta_z"];

calyx_abi::externs! {
    Pure fn calyx_gears_lumped_member(
        context, mass: f64, inertia: f64, radius: f64, support_stiffness: f64, torsional_stiffness: f64,
        fixed: Vec<String>,
    ) -> Handle {
        let mut is_fixed = [false; 3];
        for name in &fixed {
            let Some(at) = DOF_NAMES.iter().position(|known| known == name) else {
                return Err(refusal("E0670", "fixed", &format!("\"{name}\" is not a degree of freedom of a lumped member"),
                    "they are \"u_x\", \"u_y\" and \"theta_z\""));
            };
            is_fixed[at] = true;
        }
        let member = LumpedMember { mass, inertia, radius, support_stiffness, torsional_stiffness, fixed: is_fixed };
        Ok(keep(&mut host(context)?.lumped_members, member))
    }

    Pure fn calyx_gears_lumped_planetary(
        context, carrier: Handle, ring: Handle, sun: Handle, planet: Handle, planet_bearing_stiffness: f64,
        sun_mesh_stiffness: f64, ring_mesh_stiffness: f64, sun_pressure_angle: f64, ring_pressure_angle: f64,
        planets: f64, planet_angles: Vec<f64>,
    ) -> Handle {
        if planets.fract() != 0.0 {
            return Err(refusal("E0740", "planets", &format!("there are no {planets} planets"), "give a whole number"));
        }
        let planet_angles = if planet_angles.is_empty() { equally_spaced(planets as usize) } else { planet_angles };
        let host = host(context)?;
        let set = LumpedPlanetary {
            carrier: *entry(&host.lumped_members, carrier)?,
            ring: *entry(&host.lumped_members, ring)?,
            sun: *entry(&host.lumped_members, sun)?,
            planet: *entry(&host.lumped_members, planet)?,
            planet_bearing_stiffness,
            planet_angles,
            sun_mesh: LumpedMesh { stiffness: sun_mesh_stiffness, pressure_angle: sun_pressure_angle },
            ring_mesh: LumpedMesh { stiffness: ring_mesh_stiffness, pressure_angle: ring_pressure_angle },
        };
        let modes = set.modes().map_err(|error| impossible(&error))?;
        Ok(keep(&mut host.modes, modes))
    }

    Pure fn calyx_gears_natural_frequencies(context, modes: Handle) -> Vec<f64> {
        Ok(entry(&host(context)?.modes, modes)?.iter().map(|mode| mode.frequency).collect())
    }

    Pure fn calyx_gears_mode_types(context, modes: Handle) -> Vec<String> {
        Ok(entry(&host(context)?.modes, modes)?.iter().map(|mode| mode.kind.name().to_owned()).collect())
    }

    Pure fn calyx_gears_mode_energy(context, modes: Handle, mode: f64, member: String) -> f64 {
        let mode = self::mode(context, modes, mode)?;
        let shares = match member.as_str() {
            "carrier" => mode.shares.get(..1),
            "ring" => mode.shares.get(1..2),
            "sun" => mode.shares.get(2..3),
            _ => mode.shares.get(3..),
        };
        Ok(shares.unwrap_or_default().iter().sum())
    }
}

/// Reports an invalid number at the argument that contains it.
fn impossible(error: &LumpedError) -> RuntimeError {
    let argument = match (error.what, error.member) {
        ("bearing stiffness", _) => "planet_bearing_stiffness",
        ("mesh stiffness", "sun") => "sun_mesh_stiffness",
        ("mesh stiffness", _) => "ring_mesh_stiffness",
        (_, member) => member,
    };
    refusal(
        "E0740",
        argument,
        &format!("the {} of the {} is {}", error.what, error.member, error.value),
        &format!("it must be {}", error.needed),
    )
}

fn mode(context: &mut Context, modes: Handle, mode: f64) -> Result<Mode, RuntimeError> {
    let modes = entry(&host(context)?.modes, modes)?;
    // A mode number that is not an integer in range selects no mode.
    let found = modes.iter().enumerate().find(|(index, _)| *index as f64 == mode);
    found.map(|(_, mode)| mode.clone()).ok_or_else(|| {
        refusal(
            "E0741",
            "mode",
            &format!("there is no mode {mode}"),
            &format!(
                "modes are counted from 0 to {}, from the lowest frequency up",
                modes.len().saturating_sub(1)
            ),
        )
    })
}
