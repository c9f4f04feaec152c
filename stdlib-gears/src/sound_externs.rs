//! Radiated sound for programs: the Rust side of `radiated_power` and its companions in `gears.cx`.

use crate::elastic_externs::as_elastic_body;
use crate::externs::{host, refusal};
use crate::observable_externs::observe;
use calyx_abi::externs::Handle;
use calyx_abi::{Context, RuntimeError};
use calyx_runtime::acoustics::Fluid;
use calyx_runtime::observables::{
    RadiationEfficiency, SoundLines, SoundPower, SoundPowerLevel, SoundPressureLevel,
};
use calyx_runtime::radiated_sound::{SoundLevel, SoundRequest, Weighting};

/// Arguments that all functions share: fluid, method, point of the plane and its normal.
type Surroundings = (String, Option<String>, Option<[f64; 3]>, [f64; 3]);

calyx_abi::externs! {
    Scene fn calyx_gears_radiated_power(
        context, body: Handle, fluid: String, method: Option<String>, harmonic: Option<f64>,
        plane: Option<[f64; 3]>, plane_normal: [f64; 3],
    ) -> Handle {
        let lines = lines(harmonic)?;
        let (sound, _) = requested(context, body, (fluid, method, plane, plane_normal), None)?;
        observe(context, SoundPower { sound, lines })
    }

    Scene fn calyx_gears_sound_power_level(
        context, body: Handle, weighting: String, fluid: String, method: Option<String>, harmonic: Option<f64>,
        plane: Option<[f64; 3]>, plane_normal: [f64; 3],
    ) -> Handle {
        let lines = lines(harmonic)?;
        let (sound, _) = requested(context, body, (fluid, method, plane, plane_normal), None)?;
        observe(context, SoundPowerLevel { sound, lines, weighting: self::weighting(&weighting) })
    }

    Scene fn calyx_gears_radiation_efficiency(
        context, body: Handle, fluid: String, method: Option<String>, plane: Option<[f64; 3]>,
        plane_normal: [f64; 3],
    ) -> Handle {
        let (sound, _) = requested(context, body, (fluid, method, plane, plane_normal), None)?;
        observe(context, RadiationEfficiency(sound))
    }

    Scene fn calyx_gears_sound_pressure_level(
        context, body: Handle, at: [f64; 3], weighting: String, fluid: String, method: Option<String>,
        plane: Option<[f64; 3]>, plane_normal: [f64; 3],
    ) -> Handle {
        let (sound, points) = requested(context, body, (fluid, method, plane, plane_normal), Some(at))?;
        let point = points.first().copied().unwrap_or_default();
        observe(context, SoundPressureLevel { sound, point, weighting: self::weighting(&weighting) })
    }
}

fn weighting(name: &str) -> Weighting {
    if name == "A" { Weighting::A } else { Weighting::None }
}

fn lines(harmonic: Option<f64>) -> Result<SoundLines, RuntimeError> {
    match harmonic {
        None => Ok(SoundLines::All),
        Some(number) if number.fract() == 0.0 && number >= 1.0 => Ok(SoundLines::Harmonic(number as usize)),
        Some(number) => {
            let message = format!("there is no harmonic {number} of a mesh frequency");
            Err(refusal(
                "E0784",
                "harmonic",
                &message,
                "give a whole number, such as 1 for the mesh frequency",
            ))
        }
    }
}

/// Adds a request to the scene, and returns its index and that of its point.
fn requested(
    context: &mut Context,
    body: Handle,
    (fluid, method, plane, normal): Surroundings,
    point: Option<[f64; 3]>,
) -> Result<(usize, Vec<usize>), RuntimeError> {
    let host = host(context)?;
    let Some(index) = as_elastic_body(host, body) else {
        return Err(refusal(
            "E0784",
            "body",
            "this body has no walls that radiate sound",
            "give an elastic body with a mesh: what `gears.nastran`, `gears.abaqus` or `gears.gmsh` returned",
        ));
    };
    let own = &host.elastic_bodies[index];
    let Some(connection) = own.connection else {
        let message = format!("nothing is attached to \"{}\", so nothing moves its walls", own.name);
        let help = "attach it by `gears.attachment` and mount bearings on the attachments before";
        return Err(refusal("E0784", "body", &message, help));
    };
    if plane.is_some() && normal == [0.0; 3] {
        let help = "give a vector such as `e2`";
        return Err(refusal("E0784", "plane_normal", "the normal of the plane has no direction", help));
    }
    let request = SoundRequest {
        body: connection,
        fluid: if fluid == "water" { Fluid::WATER } else { Fluid::AIR },
        level: method.as_deref().and_then(SoundLevel::named),
        plane: plane.map(|point| [point, normal]),
        points: point.into_iter().collect(),
    };
    Ok(host.scene.add_sound(request))
}
