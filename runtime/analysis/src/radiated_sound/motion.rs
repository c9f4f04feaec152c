//! Motion of the surface of a body: velocity patterns by unit of its coordinates, their amplitudes
//! in a forced response, and the powers that enter and leave the body.

use super::shapes::{BodyShapes, check_modes};
use super::surface::{Surface, SurfacePanel};
use super::{SoundRequest, middle, refused};
use calyx_acoustics::field::FieldMesh;
use calyx_acoustics::radiation::equivalent_impedance;
use calyx_acoustics::skin::Skin;
use calyx_acoustics::{Fluid, RadiationImpedance};
use calyx_model::bearing::{BearingState, Support};
use calyx_model::connection::ConnectionState;
use calyx_model::elastic_body::{MotionShapes, SharedElasticBody};
use calyx_model::ids::{BearingId, BodyId};
use calyx_model::resources::Resources;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::MemoryReservation;
use calyx_numerics::vec3::{Vector, length, minus};
use calyx_solve::forced_response::Motion;
use calyx_solve::system::System;
use faer::c64;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Frequency up to which modes count, relative to that of the highest line.
const MODES: f64 = 1.5;

/// Elastic body whose surface vibrates.
pub(crate) struct Vibrating {
    /// Name.
    pub name: String,
    /// Fluid around it.
    pub fluid: Fluid,
    /// Mass, kg; `None` if it is unknown.
    pub mass: Option<f64>,
    /// Closed surface in the coordinates of the body.
    pub surface: Surface,
    /// Points at which the pressure is requested, and those of the field meshes, in the coordinates
    /// of the body, m.
    pub points: Vec<Vector>,
    /// Distances of the points from the middle of the body, m.
    pub distances: Vec<f64>,
    /// Field meshes in ground coordinates.
    pub fields: Vec<FieldMesh>,
    /// Directions of the far field into the fluid, in the coordinates of the body.
    pub directions: Vec<Vector>,
    /// Middle of the surface in the coordinates of the body, m.
    pub middle: Vector,
    /// Normal velocities of the triangles by unit velocity of each coordinate.
    pub patterns: Vec<Vec<f64>>,
    /// Form of the equivalent radiated power, on the skin of the mesh.
    pub equivalent: RadiationImpedance,
    /// The same of each panel.
    pub equivalent_panels: Vec<RadiationImpedance>,
    /// Indices of these coordinates among those of the system.
    coordinates: Vec<usize>,
    /// Unknowns of the body and their values by unit of each coordinate.
    pub moved: Vec<Vec<(usize, f64)>>,
    /// Bearing forces on the body: bearing, component, and the deflections by unit of each
    /// coordinate.
    bearings: Vec<BearingMotion>,
    /// False if forces act on the attachments other than those of linear bearings.
    input_is_known: bool,
    _room: MemoryReservation,
}

/// Motion of a surface at a speed, by line.
pub(crate) struct SurfaceMotion {
    /// Amplitudes of the velocities of the coordinates, from all positions and from every second
    /// one.
    pub velocities: [Vec<Vec<c64>>; 2],
    /// Power that enters at the bearings, W; NaN if it is unknown.
    pub input: Vec<f64>,
    /// Power that the damping ratio dissipates in the body, W.
    pub dissipated: Vec<f64>,
}

impl Vibrating {
    /// Finds the velocity patterns of a surface, and coarsens it for sound up to a frequency, Hz.
    ///
    /// # Errors
    /// Those of the condensation of the body and of the interrupt.
    pub fn new(
        system: &System<'_>,
        request: &SoundRequest,
        (surface, highest): (Surface, f64),
        found: &BodyShapes,
        resources: &Resources,
    ) -> Result<Vibrating, EngineError> {
        let scene = system.scene;
        let connection = request.connection(scene)?;
        let lost = || refused(format!("the motion of \"{}\" is unknown", connection.name), "import its mesh");
        let condensed = system.elastic_connections.get(request.body.0).ok_or_else(lost)?;
        let BodyShapes { shapes, places, .. } = found;
        check_modes(&connection.name, shapes, &condensed.modes)?;
        let state = ConnectionState::at(&scene.bodies, connection, 0.0)?;
        let mesh = &surface.original.mesh;
        let triangles = mesh.triangles().len();
        let attached: Vec<BodyId> = connection.bodies().collect();
        let dofs = system.dofs.iter().enumerate().filter(|(_, dof)| attached.contains(&BodyId(dof.body)));
        let (mut coordinates, mut moved): (Vec<usize>, Vec<Vec<(usize, f64)>>) = (Vec::new(), Vec::new());
        for (index, dof) in dofs {
            let of_attachment = |(attachment, six): (usize, [f64; 6])| {
                six.into_iter().enumerate().map(move |(k, part)| (6 * attachment + k, part))
            };
            coordinates.push(index);
            moved.push(state.moved(dof).into_iter().flat_map(of_attachment).collect());
        }
        let first = system.connection_modes().into_iter();
        let first = first.filter(|(other, _)| std::ptr::eq(*other, condensed)).map(|(_, first)| first).next();
        let unknowns = shapes.displacements.len() - shapes.eigenvalues.len();
        let first = match condensed.modes.count() {
            0 => 0,
            _ => first.ok_or_else(lost)?,
        };
        for mode in 0..condensed.modes.count() {
            coordinates.push(system.dofs.len() + system.modes.count() + first + mode);
            moved.push(vec![(unknowns + mode, 1.0)]);
        }
        // Both the skin of the mesh and the coarsened one have patterns.
        let room = resources.interrupt.reserve_memory((16 * triangles * coordinates.len()) as u64)?;
        let pattern = |parts: &Vec<(usize, f64)>| pattern(&surface.original, places, shapes, parts);
        let original: Vec<Vec<f64>> = moved.iter().map(pattern).collect::<Result<_, _>>()?;
        let equivalent = equivalent_impedance(mesh.areas(), &request.fluid, &original);
        let of_panel = |panel: &SurfacePanel| {
            let parts = mesh.areas().iter().zip(&panel.original);
            let areas: Vec<f64> = parts.map(|(area, share)| area * share).collect();
            equivalent_impedance(&areas, &request.fluid, &original)
        };
        let equivalent_panels = surface.panels.iter().map(of_panel).collect();
        // Modes of higher frequencies hardly move at the lines.
        let is_moved = |value: &f64| value.max(0.0).sqrt() <= TAU * MODES * highest;
        let modes = shapes.eigenvalues.iter().take_while(|value| is_moved(value)).count();
        let first = original.len() - condensed.modes.count();
        let wavelength = request.fluid.speed_of_sound / highest;
        let counted: Vec<&[f64]> = original[first..].iter().take(modes).map(Vec::as_slice).collect();
        let surface = surface.coarsened(wavelength, &counted)?;
        let patterns = original.iter().map(|pattern| surface.projected(pattern)).collect();
        let (bearings, input_is_known) = bearings(system, &attached, &coordinates)?;
        let fields = surface.fields(request)?;
        let mut points = surface.points(&request.points);
        points.extend(fields.iter().flat_map(|field| surface.points(&field.points)));
        let middle = middle(surface.skin.mesh.vertices());
        Ok(Vibrating {
            name: connection.name.clone(),
            fluid: request.fluid,
            mass: connection.body.as_ref().and_then(|SharedElasticBody(body)| body.size()?.mass),
            distances: points.iter().map(|point| length(minus(*point, middle))).collect(),
            points,
            fields,
            directions: surface.directions(request).iter().map(|at| surface.vector(at.vector)).collect(),
            middle,
            surface,
            patterns,
            equivalent,
            equivalent_panels,
            coordinates,
            moved,
            bearings,
            input_is_known,
            _room: room,
        })
    }

    /// Returns the motion of the surface from the vibrations of all coordinates with all positions
    /// and with every second one, the bearing forces by bearing, component and line, and the
    /// angular frequency of each line, rad/s.
    pub fn motion(
        &self,
        [fine, coarse]: [&Motion; 2],
        forces: &dyn Fn(BearingId, usize, usize) -> Option<c64>,
        frequencies: &[f64],
    ) -> SurfaceMotion {
        let velocities = |motion: &Motion| -> Vec<Vec<c64>> {
            let line = |(displacements, &omega): (&nalgebra::DVector<c64>, &f64)| {
                let velocity = |&at: &usize| displacements[at] * c64::new(0.0, omega);
                self.coordinates.iter().map(velocity).collect()
            };
            motion.displacements.iter().zip(frequencies).map(line).collect()
        };
        let all = velocities(fine);
        let power = |force: c64, velocity: c64| 0.5 * (force * velocity.conj()).re;
        let input = |line: usize| -> f64 {
            if !self.input_is_known {
                return f64::NAN;
            }
            let of_bearing = |(bearing, component, deflections): &BearingMotion| {
                let rate: c64 = deflections.iter().map(|(at, unit)| all[line][*at] * *unit).sum();
                forces(*bearing, *component, line).map_or(f64::NAN, |force| power(force, rate))
            };
            self.bearings.iter().map(of_bearing).sum()
        };
        let dissipated = |line: usize| -> f64 {
            let forces = &fine.damping_forces[line];
            self.coordinates.iter().zip(&all[line]).map(|(&at, &velocity)| power(forces[at], velocity)).sum()
        };
        SurfaceMotion {
            input: (0..frequencies.len()).map(input).collect(),
            dissipated: (0..frequencies.len()).map(dissipated).collect(),
            velocities: [all, velocities(coarse)],
        }
    }
}

/// Returns the normal velocities of the triangles of a skin for a combination of unknowns of the
/// body.
fn pattern(
    skin: &Skin,
    places: &BTreeMap<usize, usize>,
    shapes: &MotionShapes,
    parts: &[(usize, f64)],
) -> Result<Vec<f64>, EngineError> {
    let velocity = |place: usize| {
        let mut sum = [0.0; 3];
        for (unknown, part) in parts.iter().filter(|(_, part)| *part != 0.0) {
            let Some(own) = shapes.displacements.get(*unknown).and_then(|own| own.get(place)) else {
                continue;
            };
            (0..3).for_each(|k| sum[k] += part * own[k]);
        }
        sum
    };
    let mean = |nodes: &Vec<usize>| {
        let own = nodes.iter().filter_map(|node| places.get(node)).map(|&place| velocity(place));
        let sum = own.fold([0.0; 3], |sum, own| [0, 1, 2].map(|k: usize| sum[k] + own[k]));
        sum.map(|sum| c64::new(sum / nodes.len() as f64, 0.0))
    };
    let velocities: Vec<[c64; 3]> = skin.nodes.iter().map(mean).collect();
    let normal = skin.mesh.normal_velocities(&velocities).map_err(super::engine_error)?;
    Ok(normal.into_iter().map(|value| value.re).collect())
}

/// Bearing, component along or about its axes, and deflections by unit of coordinates.
type BearingMotion = (BearingId, usize, Vec<(usize, f64)>);

/// Returns the deflections of the bearings on a body by unit of its coordinates, and whether all
/// forces on its attachments are those of bearings with linear forces.
fn bearings(
    system: &System<'_>,
    attached: &[BodyId],
    coordinates: &[usize],
) -> Result<(Vec<BearingMotion>, bool), EngineError> {
    let scene = system.scene;
    let is_attached = |body: BodyId| attached.contains(&body);
    let (mut all, mut known) = (Vec::new(), true);
    for &index in &system.bearings {
        let bearing = &scene.bearings[index];
        let on_second = matches!(bearing.to, Support::Body(body) if is_attached(body));
        if !is_attached(bearing.body) && !on_second {
            continue;
        }
        known &= bearing.walls() == 0;
        let state = BearingState::at(&scene.bodies, bearing, 0.0)?;
        let moved = |&at: &usize| system.dofs.get(at).map(|dof| state.deflection(dof));
        let deflections: Vec<Option<[f64; 6]>> = coordinates.iter().map(moved).collect();
        for component in 0..6 {
            let own =
                deflections.iter().enumerate().filter_map(|(at, six)| Some((at, six.as_ref()?[component])));
            let own: Vec<(usize, f64)> = own.filter(|(_, unit)| *unit != 0.0).collect();
            if bearing.resists(component) && !own.is_empty() {
                all.push((BearingId(index), component, own));
            }
        }
    }
    let in_contact = scene.pairs.iter().any(|pair| pair.bodies.into_iter().any(is_attached));
    let connected = |&body: &BodyId| scene.connections_of(body).count() > 1;
    Ok((all, known && !in_contact && !attached.iter().any(connected)))
}
