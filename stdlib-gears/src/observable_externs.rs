//! Observables of bodies and meshes for programs: the Rust side of the observables of `gears.cx`.

use crate::externs::{self, entry, host, refusal, spline_tooth_number, tooth_number};
use crate::lumped_scene::{LumpedFrequency, LumpedSet};
use crate::mesh_externs::on_parallel_axes;
use crate::shaft_externs::{observe_reaction, observe_shaft};
use calyx_abi::externs::Handle;
use calyx_abi::{Context, RuntimeError};
use calyx_runtime::forced_response::ForcedResponseRequest;
use calyx_runtime::motion::angular_velocity;
use calyx_runtime::observables::{
    CampbellRequest, Coordinate, Displacement, DynamicFactor, FaceLoadFactor, HighestContact, LoadShare,
    LoadedFace, LocalQuantity, LowestContact, MaxContactPressure, MaxEdgePressure, MaxLineLoad,
    MaxRootCompression, MaxRootStress, MaxSlidingVelocity, Maximum, MaximumLocation, MeshForce,
    MeshStiffness, Misalignment, MisalignmentComponent, ModeClassification, ModeShare, ModesRequest,
    NaturalFrequency, Observable, PairLoad, PairsInContact, PlanetSet, RootFaceLoadFactor, Rotation,
    SecantStiffness, SlidingVelocity, SplineToothLoad, SupportForce, SupportMoment, ToothLoad,
    TransmissionError, TransverseLoadFactor, UnloadedTransmissionError, WhirlFrequency, WhirlSense,
};
use calyx_runtime::scene::{BodyId, PairId};

calyx_abi::externs! {
    Scene fn calyx_gears_transmission_error(context, mesh: Handle) -> Handle {
        observe(context, TransmissionError(pair(mesh)))
    }

    Scene fn calyx_gears_unloaded_transmission_error(context, mesh: Handle) -> Handle {
        observe(context, UnloadedTransmissionError(pair(mesh)))
    }

    Scene fn calyx_gears_load_share(context, mesh: Handle) -> Handle {
        observe(context, LoadShare(pair(mesh)))
    }

    Scene fn calyx_gears_mesh_force(context, mesh: Handle) -> Handle {
        observe(context, MeshForce(pair(mesh)))
    }

    Scene fn calyx_gears_pair_load(context, mesh: Handle, pair: f64) -> Handle {
        let pair = pair_number(pair)?;
        observe(context, PairLoad(self::pair(mesh), pair))
    }

    Scene fn calyx_gears_tooth_load(context, body: Handle, tooth: f64) -> Handle {
        let id = self::body(context, body)?;
        let tooth = tooth_number(host(context)?, id, tooth)?;
        observe(context, ToothLoad(id, tooth))
    }

    Scene fn calyx_gears_pairs_in_contact(context, mesh: Handle) -> Handle {
        observe(context, PairsInContact(pair(mesh)))
    }

    Scene fn calyx_gears_mesh_stiffness(context, mesh: Handle) -> Handle {
        observe(context, MeshStiffness(pair(mesh)))
    }

    Scene fn calyx_gears_natural_frequency(context, mode: f64) -> Handle {
        let mode = mode_number(mode)?;
        observe(context, NaturalFrequency(mode))
    }

    Scene fn calyx_gears_whirl_frequency(context, mode: f64) -> Handle {
        let mode = mode_number(mode)?;
        observe(context, WhirlFrequency(mode))
    }

    Scene fn calyx_gears_whirl_sense(context, mode: f64) -> Handle {
        let mode = mode_number(mode)?;
        observe(context, WhirlSense(mode))
    }

    Scene fn calyx_gears_campbell_diagram(
        context, body: Handle, highest_speed: f64, speeds: f64, modes: Option<f64>,
    ) -> () {
        externs::before_analysis(context, "the Campbell diagram")?;
        let id = externs::body(context, "body", body)?;
        let modes = mode_count(modes)?;
        if speeds.fract() != 0.0 || speeds < 2.0 {
            let message = format!("a Campbell diagram cannot have {speeds} speeds");
            return Err(refusal("E0773", "speeds", &message, "give a whole number of at least two"));
        }
        if highest_speed == 0.0 {
            return Err(refusal("E0773", "highest_speed", "a Campbell diagram cannot end at the speed zero",
                "give the highest speed of the body, such as `highest_speed = 12000 rpm`"));
        }
        let scene = &mut host(context)?.scene;
        if scene.campbell_diagram.is_some() {
            return Err(RuntimeError::new("E0773", "the model has a second Campbell diagram, and a run writes one",
                "keep one; the speeds of all bodies are proportional, so it has the modes of all of them"));
        }
        let own = &scene.bodies[id.0];
        if angular_velocity(own.motion.as_ref(), 0.0) == [0.0; 3] {
            let message = format!("the body \"{}\" does not rotate", own.name);
            let help = "give a body whose frame rotates at time 0: all speeds are proportional to its speed";
            return Err(refusal("E0773", "body", &message, help));
        }
        scene.campbell_diagram =
            Some(CampbellRequest { body: id, highest_speed, speeds: speeds as usize, modes });
        Ok(())
    }

    Scene fn calyx_gears_forced_response(
        context, mesh: Handle, highest_speed: f64, lowest_speed: f64, speeds: f64, harmonics: f64, damping_ratio: f64,
    ) -> () {
        externs::before_analysis(context, "the forced response")?;
        let mesh = pair(mesh);
        for (argument, number, least) in [("speeds", speeds, 2.0), ("harmonics", harmonics, 1.0)] {
            if number.fract() != 0.0 || number < least {
                let message = format!("a forced response cannot have {number} {argument}");
                let help = format!("give a whole number of at least {least}");
                return Err(refusal("E0774", argument, &message, &help));
            }
        }
        if highest_speed <= lowest_speed {
            return Err(refusal("E0774", "highest_speed", "the highest speed of the forced response is not above the lowest one",
                "give a range of speeds, such as `highest_speed = 12000 rpm`"));
        }
        let (place, host) = (context.place, host(context)?);
        let scene = &mut host.scene;
        // The coast flanks of a mesh belong to the same cycle.
        let mesh = scene.pairs[mesh.0].front.unwrap_or(mesh);
        if scene.forced_response.is_some() {
            return Err(RuntimeError::new("E0774", "the model has a second forced response, and a run writes one",
                "keep one; it has the motions of all bodies"));
        }
        scene.forced_response = Some(ForcedResponseRequest {
            mesh,
            speeds: [lowest_speed, highest_speed],
            count: speeds as usize,
            harmonics: harmonics as usize,
            damping_ratio,
        });
        host.forced_response_place = Some(place);
        Ok(())
    }

    Scene fn calyx_gears_modal_energy_share(context, body: Handle, mode: f64, motion: String) -> Handle {
        let (id, mode) = (externs::body(context, "body", body)?, mode_number(mode)?);
        let (components, elastic) = match motion.as_str() {
            "translation" => ([true, true, true, false, false, false], false),
            "rotation" => ([false, false, false, true, true, true], false),
            "elastic" => ([false; 6], true),
            _ => ([true; 6], true),
        };
        observe(context, ModeShare { mode, body: id, components, elastic })
    }

    Scene fn calyx_gears_mode_type(context, mode: f64, central: Handle, planets: Vec<Handle>) -> Handle {
        let (mode, set) = (mode_number(mode)?, planet_set(context, central, planets)?);
        observe(context, ModeClassification { mode, set })
    }

    Scene fn calyx_gears_lumped_natural_frequency(
        context, mode: f64, sun: Handle, ring: Handle, carrier: Handle, planets: Vec<Handle>, sun_meshes: Vec<Handle>,
        ring_meshes: Vec<Handle>,
    ) -> Handle {
        let mode = mode_number(mode)?;
        let planets = planet_set(context, carrier, planets)?;
        let count = planets.planets.len();
        let (sun, ring) = (externs::body(context, "sun", sun)?, externs::body(context, "ring", ring)?);
        for (argument, meshes) in [("sun_meshes", &sun_meshes), ("ring_meshes", &ring_meshes)] {
            if meshes.len() != count {
                let message = format!("there are {count} planets and {} of the meshes", meshes.len());
                return Err(refusal("E0772", argument, &message, "give one for each planet, in their order"));
            }
        }
        let [sun_meshes, ring_meshes] = [sun_meshes, ring_meshes].map(|all| all.into_iter().map(pair).collect());
        let PlanetSet { around: carrier, planets } = planets;
        let set = LumpedSet { sun, ring, carrier, planets, sun_meshes, ring_meshes };
        let count = set.mode_count(&host(context)?.scene);
        if mode >= count {
            let message = format!("there is no mode {}: the set has {count}", mode + 1);
            let help = "count modes from 1; rigid bodies on springs have as many as free degrees of freedom in the plane";
            return Err(refusal("E0770", "mode", &message, help));
        }
        observe(context, LumpedFrequency { mode, set })
    }

    Scene fn calyx_gears_modes_table(context, modes: Option<f64>, central: Handle, planets: Vec<Handle>) -> () {
        externs::before_analysis(context, "the table of modes")?;
        let count = mode_count(modes)?;
        let set = match planets.is_empty() {
            true => None,
            false => Some(planet_set(context, central, planets)?),
        };
        if host(context)?.scene.modes_table.is_some() {
            return Err(RuntimeError::new("E0773", "the model has a second table of modes, and a run writes one",
                "keep one `modes_table`"));
        }
        host(context)?.scene.modes_table = Some(ModesRequest { count, set });
        Ok(())
    }

    Scene fn calyx_gears_secant_mesh_stiffness(context, mesh: Handle) -> Handle {
        observe(context, SecantStiffness(pair(mesh)))
    }

    Scene fn calyx_gears_max_contact_pressure(context, mesh: Handle) -> Handle {
        observe(context, MaxContactPressure(pair(mesh)))
    }

    Scene fn calyx_gears_max_edge_pressure(context, mesh: Handle) -> Handle {
        observe(context, MaxEdgePressure(pair(mesh)))
    }

    Scene fn calyx_gears_max_line_load(context, mesh: Handle) -> Handle {
        observe(context, MaxLineLoad(pair(mesh)))
    }

    Scene fn calyx_gears_face_load_factor(context, mesh: Handle) -> Handle {
        on_parallel_axes(context, mesh, INSTEAD_OF_FACTORS)?;
        observe(context, FaceLoadFactor(pair(mesh)))
    }

    Scene fn calyx_gears_face_load_factor_bending(context, mesh: Handle) -> Handle {
        on_parallel_axes(context, mesh, INSTEAD_OF_FACTORS)?;
        let host = host(context)?;
        let mut depth_ratio = 0.0_f64;
        for body in entry(&host.scene.pairs, mesh)?.bodies {
            depth_ratio = depth_ratio.max(host.gear_model_on("mesh", body)?.depth_ratio());
        }
        observe(context, RootFaceLoadFactor::new(pair(mesh), depth_ratio))
    }

    Scene fn calyx_gears_transverse_load_factor(context, mesh: Handle) -> Handle {
        on_parallel_axes(context, mesh, INSTEAD_OF_FACTORS)?;
        observe(context, TransverseLoadFactor(pair(mesh)))
    }

    Scene fn calyx_gears_transverse_load_factor_bending(context, mesh: Handle) -> Handle {
        on_parallel_axes(context, mesh, INSTEAD_OF_FACTORS)?;
        observe(context, TransverseLoadFactor(pair(mesh)))
    }

    Scene fn calyx_gears_dynamic_factor(context, mesh: Handle) -> Handle {
        observe(context, DynamicFactor(pair(mesh)))
    }

    Scene fn calyx_gears_loaded_face_fraction(context, mesh: Handle) -> Handle {
        observe(context, LoadedFace(pair(mesh)))
    }

    Scene fn calyx_gears_min_contact_radius(context, body: Handle) -> Handle {
        let body = gear_body(context, body)?;
        observe(context, LowestContact(body))
    }

    Scene fn calyx_gears_max_contact_radius(context, body: Handle) -> Handle {
        let body = gear_body(context, body)?;
        observe(context, HighestContact(body))
    }

    Scene fn calyx_gears_sliding_velocity(context, mesh: Handle, pair: f64) -> Handle {
        let pair = pair_number(pair)?;
        observe(context, SlidingVelocity(self::pair(mesh), pair))
    }

    Scene fn calyx_gears_misalignment_slope(context, mesh: Handle, plane: String) -> Handle {
        misalignment(context, mesh, match plane.as_str() {
            "action" => MisalignmentComponent::SlopeInPlane,
            _ => MisalignmentComponent::SlopeOutOfPlane,
        })
    }

    Scene fn calyx_gears_misalignment_offset(context, mesh: Handle, plane: String) -> Handle {
        misalignment(context, mesh, match plane.as_str() {
            "action" => MisalignmentComponent::OffsetInPlane,
            _ => MisalignmentComponent::OffsetOutOfPlane,
        })
    }

    Scene fn calyx_gears_alignment_error(context, mesh: Handle, quantity: String) -> Handle {
        misalignment(context, mesh, match quantity.as_str() {
            "offset" => MisalignmentComponent::Offset,
            "first_axial" => MisalignmentComponent::FirstAxial,
            _ => MisalignmentComponent::SecondAxial,
        })
    }

    Scene fn calyx_gears_shaft_angle_error(context, mesh: Handle) -> Handle {
        misalignment(context, mesh, MisalignmentComponent::ShaftAngle)
    }

    Scene fn calyx_gears_max_sliding_velocity(context, mesh: Handle) -> Handle {
        observe(context, MaxSlidingVelocity(pair(mesh)))
    }

    Scene fn calyx_gears_max_root_stress(context, body: Handle) -> Handle {
        let body = gear_body(context, body)?;
        observe(context, MaxRootStress(body))
    }

    Scene fn calyx_gears_max_root_compression(context, body: Handle) -> Handle {
        let body = gear_body(context, body)?;
        observe(context, MaxRootCompression(body))
    }

    Scene fn calyx_gears_tooth_of_max(context, body: Handle, of: String) -> Handle {
        place(context, body, &of, Coordinate::Tooth)
    }

    Scene fn calyx_gears_roll_angle_of_max(context, body: Handle, of: String) -> Handle {
        place(context, body, &of, Coordinate::RollAngle)
    }

    Scene fn calyx_gears_radius_of_max(context, body: Handle, of: String) -> Handle {
        place(context, body, &of, Coordinate::Radius)
    }

    Scene fn calyx_gears_axial_position_of_max(context, body: Handle, of: String) -> Handle {
        place(context, body, &of, Coordinate::Axial)
    }

    Scene fn calyx_gears_support_force(context, body: Handle, axis: String) -> Handle {
        if let Some(of_shaft) = observe_reaction(context, body, axis_number(&axis), false)? {
            return Ok(of_shaft);
        }
        let body = self::body(context, body)?;
        observe(context, SupportForce(body, axis_number(&axis)))
    }

    Scene fn calyx_gears_support_moment(context, body: Handle, axis: String) -> Handle {
        if let Some(of_shaft) = observe_reaction(context, body, axis_number(&axis), true)? {
            return Ok(of_shaft);
        }
        let body = self::body(context, body)?;
        observe(context, SupportMoment(body, axis_number(&axis)))
    }

    Scene fn calyx_gears_spline_tooth_force(context, body: Handle, tooth: f64, direction: String) -> Handle {
        let id = self::body(context, body)?;
        let tooth = spline_tooth_number(host(context)?, id, tooth)?;
        observe(context, SplineToothLoad { body: id, spline_tooth: tooth, radial: direction == "radial" })
    }

    Scene fn calyx_gears_displacement(context, body: Handle, axis: String) -> Handle {
        if let Some(of_shaft) = observe_shaft(context, body, axis_number(&axis), false)? {
            return Ok(of_shaft);
        }
        let body = self::body(context, body)?;
        observe(context, Displacement(body, axis_number(&axis)))
    }

    Scene fn calyx_gears_rotation(context, body: Handle, axis: String) -> Handle {
        if let Some(of_shaft) = observe_shaft(context, body, axis_number(&axis), true)? {
            return Ok(of_shaft);
        }
        let body = self::body(context, body)?;
        observe(context, Rotation(body, axis_number(&axis)))
    }
}

pub(crate) fn observe(context: &mut Context, observable: impl Observable) -> Result<Handle, RuntimeError> {
    Ok(Handle(host(context)?.scene.add_observable(observable).0 as u64))
}

fn place(
    context: &mut Context,
    body: Handle,
    of: &str,
    coordinate: Coordinate,
) -> Result<Handle, RuntimeError> {
    let maximum = match of {
        "max_root_stress" => Maximum::RootStress,
        "max_root_compression" => Maximum::RootCompression,
        "max_contact_pressure" => Maximum::ContactPressure,
        "max_edge_pressure" => Maximum::EdgePressure,
        "max_sliding_velocity" => Maximum::SlidingVelocity,
        "max_friction_power_per_length" => Maximum::Lubricated(LocalQuantity::FrictionPower),
        "max_flash_temperature" => Maximum::Lubricated(LocalQuantity::FlashTemperature),
        "max_contact_temperature" => Maximum::Lubricated(LocalQuantity::ContactTemperature),
        "min_film_thickness" => Maximum::Lubricated(LocalQuantity::FilmThickness),
        "min_specific_film_thickness" => Maximum::Lubricated(LocalQuantity::SpecificFilmThickness),
        _ => Maximum::LineLoad,
    };
    let body = gear_body(context, body)?;
    if matches!(maximum, Maximum::Lubricated(_)) {
        let pairs = &host(context)?.scene.pairs;
        if !pairs.iter().any(|pair| pair.bodies.contains(&body) && pair.lubrication.is_some()) {
            return Err(refusal(
                "E0932",
                "of",
                &format!("no mesh of the body has lubrication, so `{of}` has no location"),
                "give `lubrication = gears.lubrication(\"ISO VG 220\", temperature = 80, roughness = 0.6 um)` to `gears.mesh`",
            ));
        }
    }
    observe(context, MaximumLocation { body, maximum, coordinate })
}

pub(crate) fn pair(mesh: Handle) -> PairId {
    PairId(mesh.0 as usize)
}

fn body(context: &mut Context, body: Handle) -> Result<BodyId, RuntimeError> {
    externs::body(context, "body", body)
}

fn planet_set(
    context: &mut Context,
    around: Handle,
    planets: Vec<Handle>,
) -> Result<PlanetSet, RuntimeError> {
    let around = externs::body(context, "central", around)?;
    let planets: Vec<BodyId> = planets
        .into_iter()
        .map(|planet| externs::body(context, "planets", planet))
        .collect::<Result<_, _>>()?;
    if planets.contains(&around) || planets.is_empty() {
        let message = "planets are bodies around another one";
        return Err(refusal(
            "E0772",
            "planets",
            message,
            "give the planets, and sun or carrier as `central`",
        ));
    }
    Ok(PlanetSet { around, planets })
}

/// Returns the number of modes of a table, if any.
///
/// # Errors
/// E0770: the number is not a positive whole number.
fn mode_count(modes: Option<f64>) -> Result<Option<usize>, RuntimeError> {
    if let Some(modes) = modes.filter(|modes| modes.fract() != 0.0 || *modes < 1.0) {
        let help = "give a whole number, or leave it out for all";
        return Err(refusal("E0770", "modes", &format!("there are no {modes} modes"), help));
    }
    Ok(modes.map(|modes| modes as usize))
}

/// Mode number, counted from 1.
fn mode_number(mode: f64) -> Result<usize, RuntimeError> {
    match mode.fract() == 0.0 && (1.0..1e6).contains(&mode) {
        true => Ok(mode as usize - 1),
        false => Err(refusal(
            "E0770",
            "mode",
            &format!("there is no mode {mode}"),
            "modes are numbered from 1 for the lowest natural frequency; their number is that of the free degrees of freedom",
        )),
    }
}

/// Help for load factors of meshes that have none.
const INSTEAD_OF_FACTORS: &str =
    "leave the output out; `max_line_load` and `pair_load` report the distribution of the load";

/// Body that carries a gear.
fn gear_body(context: &mut Context, body: Handle) -> Result<BodyId, RuntimeError> {
    let body = self::body(context, body)?;
    host(context)?.gear_model_on("body", body)?;
    Ok(body)
}

/// Axis by its declared name.
fn axis_number(axis: &str) -> usize {
    ["x", "y", "z"].iter().position(|known| *known == axis).unwrap_or_default()
}

/// Registers a component of the misalignment of a mesh.
///
/// # Errors
/// E0888: it is defined for other axes than those of the mesh.
fn misalignment(
    context: &mut Context,
    mesh: Handle,
    component: MisalignmentComponent,
) -> Result<Handle, RuntimeError> {
    let pair_of = entry(&host(context)?.scene.pairs, mesh)?;
    let is_general = pair_of.mesh.as_ref().is_some_and(|mesh| mesh.first_contact.is_some());
    if component.is_of_parallel_axes() {
        on_parallel_axes(context, mesh, "use `alignment_error` and `shaft_angle_error`")?;
    } else if !is_general {
        let message = "this quantity is defined for bevel, hypoid and crossed gears, and the axes of this mesh are parallel";
        let instead = "use `misalignment_slope` and `misalignment_offset`";
        return Err(refusal("E0888", "mesh", message, instead));
    }
    observe(context, Misalignment(pair(mesh), component))
}

pub(crate) fn pair_number(pair: f64) -> Result<i32, RuntimeError> {
    match pair.fract() == 0.0 && pair.abs() < 1e6 {
        true => Ok(pair as i32),
        false => Err(refusal(
            "E0682",
            "pair",
            &format!("there is no pair of teeth {pair}"),
            "0 is the pair that enters contact at the start of the cycle, 1 the next one, -1 the one before",
        )),
    }
}

pub(crate) fn coefficient_of_friction(coefficient: f64) -> Result<f64, RuntimeError> {
    match coefficient.is_finite() && coefficient >= 0.0 {
        true => Ok(coefficient),
        false => Err(refusal(
            "E0683",
            "coefficient",
            &format!("{coefficient} is not a coefficient of friction"),
            "give a number from 0 on; 0.03 to 0.08 is usual for oiled gears",
        )),
    }
}
