//! Radiated sound for programs: the Rust side of `radiated_power` and its companions, and of the
//! field meshes, in `gears.cx`.

use crate::elastic_externs::as_elastic_body;
use crate::externs::{entry, host, refusal};
use crate::host::keep;
use crate::observable_externs::observe;
use calyx_abi::externs::Handle;
use calyx_abi::{Context, RuntimeError};
use calyx_runtime::acoustics::Fluid;
use calyx_runtime::acoustics::SoundMethod;
use calyx_runtime::error::Subject;
use calyx_runtime::observables::{
    RadiationEfficiency, SoundFieldLevel, SoundLines, SoundPower, SoundPowerLevel, SoundPressureLevel,
};
use calyx_runtime::radiated_sound::{FieldRequest, FieldShape, SoundRequest, Weighting};
use calyx_runtime::scene::AddedSound;
use calyx_runtime::vec3::{cross, length};

/// Normal of a rigid plane for which none is given: `e2`.
const UPWARDS: [f64; 3] = [0.0, 1.0, 0.0];

/// Arguments that all functions share: fluid, method, point of the plane and its normal.
type Surroundings = (String, Option<String>, Option<[f64; 3]>, Option<[f64; 3]>);

calyx_abi::externs! {
    Scene fn calyx_gears_radiated_power(
        context, body: Handle, fluid: String, method: Option<String>, harmonic: Option<f64>,
        panel: Option<String>, plane: Option<[f64; 3]>, plane_normal: Option<[f64; 3]>,
    ) -> Handle {
        let lines = lines(harmonic)?;
        let panel = self::panel(context, body, panel)?;
        let sound = requested(context, body, (fluid, method, plane, plane_normal), Wanted::Nothing)?.sound;
        observe(context, SoundPower { sound, panel, lines })
    }

    Scene fn calyx_gears_sound_power_level(
        context, body: Handle, weighting: String, fluid: String, method: Option<String>, harmonic: Option<f64>,
        panel: Option<String>, plane: Option<[f64; 3]>, plane_normal: Option<[f64; 3]>,
    ) -> Handle {
        let lines = lines(harmonic)?;
        let panel = self::panel(context, body, panel)?;
        let sound = requested(context, body, (fluid, method, plane, plane_normal), Wanted::Nothing)?.sound;
        observe(context, SoundPowerLevel { sound, panel, lines, weighting: self::weighting(&weighting) })
    }

    Scene fn calyx_gears_radiation_efficiency(
        context, body: Handle, fluid: String, method: Option<String>, plane: Option<[f64; 3]>,
        plane_normal: Option<[f64; 3]>,
    ) -> Handle {
        let sound = requested(context, body, (fluid, method, plane, plane_normal), Wanted::Nothing)?.sound;
        observe(context, RadiationEfficiency(sound))
    }

    Scene fn calyx_gears_sound_pressure_level(
        context, body: Handle, at: [f64; 3], weighting: String, fluid: String, method: Option<String>,
        plane: Option<[f64; 3]>, plane_normal: Option<[f64; 3]>,
    ) -> Handle {
        let added = requested(context, body, (fluid, method, plane, plane_normal), Wanted::Point(at))?;
        let point = added.points.first().copied().unwrap_or_default();
        let sound = added.sound;
        observe(context, SoundPressureLevel { sound, point, weighting: self::weighting(&weighting) })
    }

    Scene fn calyx_gears_mean_sound_pressure_level(
        context, body: Handle, field: Handle, weighting: String, fluid: String, method: Option<String>,
        plane: Option<[f64; 3]>, plane_normal: Option<[f64; 3]>,
    ) -> Handle {
        let surroundings = (fluid, method, plane, plane_normal);
        let level = field_level(context, (body, field), surroundings, (&weighting, false))?;
        observe(context, level)
    }

    Scene fn calyx_gears_measured_sound_power_level(
        context, body: Handle, field: Handle, weighting: String, fluid: String, method: Option<String>,
        plane: Option<[f64; 3]>, plane_normal: Option<[f64; 3]>,
    ) -> Handle {
        let surroundings = (fluid, method, plane, plane_normal);
        let level = field_level(context, (body, field), surroundings, (&weighting, true))?;
        observe(context, level)
    }

    Pure fn calyx_gears_sphere_field(
        context, name: String, radius: f64, center: Option<[f64; 3]>, rings: f64,
    ) -> Handle {
        let rings = whole("rings", rings)?;
        field(context, name, FieldShape::Sphere { center, radius, rings })
    }

    Pure fn calyx_gears_hemisphere_field(
        context, name: String, radius: f64, center: Option<[f64; 3]>, rings: Option<f64>,
    ) -> Handle {
        let rings = rings.map(|rings| whole("rings", rings)).transpose()?;
        field(context, name, FieldShape::Hemisphere { center, radius, rings })
    }

    Pure fn calyx_gears_box_field(context, name: String, distance: f64) -> Handle {
        if distance == 0.0 {
            let message = format!("the box \"{name}\" would touch the body");
            return Err(refusal("E0784", "distance", &message, "give a distance such as 1 m"));
        }
        field(context, name, FieldShape::Box { distance })
    }

    Pure fn calyx_gears_plane_field(
        context, name: String, corner: [f64; 3], first_edge: [f64; 3], second_edge: [f64; 3], first_points: f64,
        second_points: f64,
    ) -> Handle {
        if length(cross(first_edge, second_edge)) == 0.0 {
            let message = format!("the edges of the plane \"{name}\" are parallel, or one has no length");
            let help = "give two edges in different directions, such as `2 m * e1` and `1 m * e3`";
            return Err(refusal("E0784", "second_edge", &message, help));
        }
        let counts = [whole("first_points", first_points)?, whole("second_points", second_points)?];
        field(context, name, FieldShape::Plane { corner, edges: [first_edge, second_edge], counts })
    }
}

fn whole(argument: &str, number: f64) -> Result<usize, RuntimeError> {
    match number.fract() == 0.0 {
        true => Ok(number as usize),
        false => {
            let message = format!("`{argument}` cannot be {number}");
            Err(refusal("E0784", argument, &message, "give a whole number"))
        }
    }
}

fn field(context: &mut Context, name: String, shape: FieldShape) -> Result<Handle, RuntimeError> {
    let name = context.name_in_instance(name);
    Ok(keep(&mut host(context)?.sound_fields, FieldRequest { name, shape }))
}

/// Requests the pressure on a field mesh, and returns its mean level, or the sound power level that
/// this gives.
fn field_level(
    context: &mut Context,
    (body, field): (Handle, Handle),
    surroundings: Surroundings,
    (weighting, is_power): (&str, bool),
) -> Result<SoundFieldLevel, RuntimeError> {
    let wanted = entry(&host(context)?.sound_fields, field)?.clone();
    if is_power && !wanted.shape.encloses() {
        return Err(refusal(
            "E0784",
            "field",
            &format!("the plane \"{}\" does not enclose the body, so it gives no sound power", wanted.name),
            "give a sphere, a hemisphere or a box, or observe `mean_sound_pressure_level`",
        ));
    }
    let AddedSound { sound, fields, .. } = requested(context, body, surroundings, Wanted::Field(wanted))?;
    let field = fields.first().copied().unwrap_or_default();
    Ok(SoundFieldLevel { sound, field, weighting: self::weighting(weighting), is_power })
}

/// Returns the index of a panel of a body by its name.
fn panel(context: &mut Context, body: Handle, name: Option<String>) -> Result<Option<usize>, RuntimeError> {
    let Some(name) = name else { return Ok(None) };
    let in_instance = context.name_in_instance(name.clone());
    let host = host(context)?;
    let Some(index) = as_elastic_body(host, body) else { return Ok(None) };
    let panels = host.elastic_bodies[index].panels();
    let find = |name: &String| panels.iter().position(|panel| panel == name);
    if let Some(found) = find(&name).or_else(|| find(&in_instance)) {
        return Ok(Some(found));
    }
    let quoted: Vec<String> = panels.iter().map(|panel| format!("\"{panel}\"")).collect();
    let help = match quoted.is_empty() {
        true => format!("add it before by `gears.panel(\"{name}\", housing, region)`"),
        false => format!("give one of its panels: {}", quoted.join(", ")),
    };
    Err(refusal("E0784", "panel", &format!("the body has no panel \"{name}\""), &help))
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

/// Pressure that is requested.
enum Wanted {
    Nothing,
    Point([f64; 3]),
    Field(FieldRequest),
}

/// Adds a request to the scene, and returns its index and that of its point or field mesh.
fn requested(
    context: &mut Context,
    body: Handle,
    (fluid, method, plane, normal): Surroundings,
    wanted: Wanted,
) -> Result<AddedSound, RuntimeError> {
    let (place, host) = (context.place, host(context)?);
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
    if plane.is_none() && normal.is_some() {
        let help = "give a point of the plane as `plane`, or leave `plane_normal` out";
        return Err(refusal("E0784", "plane_normal", "a normal without a plane has no effect", help));
    }
    let normal = normal.unwrap_or(UPWARDS);
    if normal == [0.0; 3] {
        let help = "give a vector such as `e2`";
        return Err(refusal("E0784", "plane_normal", "the normal of the plane has no direction", help));
    }
    let request = SoundRequest {
        body: connection,
        fluid: if fluid == "water" { Fluid::WATER } else { Fluid::AIR },
        method: method.as_deref().and_then(SoundMethod::named),
        plane: plane.map(|point| [point, normal]),
        points: if let Wanted::Point(at) = wanted { vec![at] } else { Vec::new() },
        fields: if let Wanted::Field(field) = wanted { vec![field] } else { Vec::new() },
    };
    let added = host.scene.add_sound(request);
    let AddedSound { sound, points, fields } = &added;
    let points = points.iter().map(|&point| Subject::SoundPoint(*sound as u32, point as u32));
    let fields = fields.iter().map(|&field| Subject::SoundField(*sound as u32, field as u32));
    for subject in points.chain(fields).chain([Subject::Sound(*sound)]) {
        host.sound_places.entry(subject).or_insert(place);
    }
    Ok(added)
}
