//! Bearings on two seats of an elastic tube, between it and a rigid body or another tube.

use calyx_runtime::bearing::{Bearing, NonlinearLoad, Ring, RollingElements};
use calyx_runtime::cache::Key;
use calyx_runtime::connection::{ConnectionState, ElasticConnection};
use calyx_runtime::contact::solid::Pose;
use calyx_runtime::elastic::attachment::{Attachment, Connection, Region};
use calyx_runtime::elastic::model::SolidShape;
use calyx_runtime::elastic::{ElasticModel, Element, ElementKind, FixedComponents, Material as Steel, Node};
use calyx_runtime::elastic_body::{ElasticBody, FiniteElementBody};
use calyx_runtime::fidelity::{Fidelity, StructureOptions, Template};
use calyx_runtime::ids::BodyId;
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::load::Wrench;
use calyx_runtime::motion::{RelocatedMotion, SteadyRotation};
use calyx_runtime::plan::Plan;
use calyx_runtime::rigid::RigidBody;
use calyx_runtime::rolling::{
    BallGeometry, BallKind, BallRow, Elements, Material, Motion, Profile, Rib, RollerGeometry, RollerKind,
    RollerRow, RollingBearing, Row,
};
use calyx_runtime::scene::{Body, Scene};
use calyx_runtime::step::StepResult;
use calyx_runtime::system::System;
use std::f64::consts::TAU;
use std::sync::Arc;

/// Radii of the tube on which a ring is, inside and outside.
const fn radii(ring: Ring) -> [f64; 2] {
    match ring {
        Ring::Outer => [0.03, 0.036],
        Ring::Inner => [0.012, 0.018],
    }
}

/// Radius of the raceway of a ring.
pub const fn radius(ring: Ring) -> f64 {
    match ring {
        Ring::Outer => radii(ring)[0],
        Ring::Inner => radii(ring)[1],
    }
}

pub const LENGTH: f64 = 0.08;
/// Elements around the tube, through its wall and along it.
pub const COUNTS: [usize; 3] = [48, 2, 8];
/// Axial positions of the ends of the seats.
pub const SEATS: [[f64; 2]; 2] = [[0.0, 0.02], [0.06, 0.08]];
pub const HARMONICS: u16 = 8;
pub const ROLLERS: usize = 14;
pub const ROLLER: f64 = 0.006;
pub const FORCE: [f64; 2] = [4e3, -9e3];
pub const MOMENT: f64 = 60.0;

/// A tube with the seats of a ring about the coordinate axis `axis`, from the two axes that follow
/// it. Its foot, a strip on the other side of its wall, is fixed at a prescribed displacement that
/// bodies of scenes ignore, if there is one.
pub fn tube(ring: Ring, modulus: f64, axis: usize, prescribed: Option<f64>) -> ElasticModel {
    let [inside, outside] = radii(ring);
    let [around, through, along] = COUNTS;
    let index = |i: usize, j: usize, k: usize| (i % around) + around * (j + (through + 1) * k);
    let mut nodes = Vec::new();
    for k in 0..=along {
        for j in 0..=through {
            for i in 0..around {
                let angle = TAU * i as f64 / around as f64;
                let radius = inside + (outside - inside) * j as f64 / through as f64;
                let local = [radius * angle.cos(), radius * angle.sin(), LENGTH * k as f64 / along as f64];
                let position = std::array::from_fn(|component| local[(component + 2 - axis) % 3]);
                nodes.push(Node { label: nodes.len() as u64 + 1, position, axes: Pose::IDENTITY.rotation });
            }
        }
    }
    let mut elements = Vec::new();
    for k in 0..along {
        for j in 0..through {
            for i in 0..around {
                let face = |k: usize| {
                    [index(i, j, k), index(i, j + 1, k), index(i + 1, j + 1, k), index(i + 1, j, k)]
                };
                elements.push(Element {
                    label: elements.len() as u64 + 1,
                    kind: ElementKind::Solid(SolidShape::IncompatibleHexahedron8),
                    nodes: [face(k), face(k + 1)].concat(),
                    material: Some(0),
                });
            }
        }
    }
    let opposite = inside + outside - radius(ring);
    let is_foot = |node: &Node| {
        let [x, y] = [1, 2].map(|after| node.position[(axis + after) % 3]);
        (x.hypot(y) - opposite).abs() < 1e-6 && y < -0.9 * opposite
    };
    let foot = (0..nodes.len()).filter(|&node| is_foot(&nodes[node]));
    let fixed = prescribed.map_or_else(Vec::new, |value| {
        foot.map(|node| FixedComponents { node, components: [true; 6], value }).collect()
    });
    let material = Steel {
        youngs_modulus: modulus,
        poissons_ratio: 0.3,
        shear_modulus: modulus / 2.6,
        density: 7850.0,
        structural_damping: 0.0,
    };
    ElasticModel { nodes, elements, materials: vec![material], fixed, ..ElasticModel::default() }
}

/// Elements of the bearings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    Cylindrical,
    Tapered,
    AngularContact,
    DeepGroove,
}

/// The bearing in a seat; that in the second one is mirrored.
pub fn bearing(kind: Kind, seat: usize) -> RollingBearing {
    let (pitch_diameter, steel) = (2.0 * radius(Ring::Outer) - ROLLER, Material::STEEL);
    let rollers = |kind: RollerKind| {
        let row = RollerRow::new(RollerGeometry {
            kind,
            count: ROLLERS,
            roller_diameter: ROLLER,
            length: 0.016,
            pitch_diameter,
            profile: Profile::Logarithmic,
            laminae: 21,
            rings: steel,
            rollers: steel,
            raceway_widths: [None; 2],
        });
        Elements::from(row.expect("sound rollers"))
    };
    let balls = |kind: BallKind| {
        let row = BallRow::new(BallGeometry {
            kind,
            count: ROLLERS,
            ball_diameter: ROLLER,
            pitch_diameter,
            inner_conformity: 0.52,
            outer_conformity: 0.53,
            rings: steel,
            balls: steel,
        });
        Elements::from(row.expect("sound balls"))
    };
    let elements = match kind {
        Kind::Cylindrical => rollers(RollerKind::Cylindrical { clearance: 1e-5 }),
        Kind::Tapered => {
            rollers(RollerKind::Tapered { outer_angle: 0.25, rib: Rib { end_radius: 0.1, height: 1.5e-3 } })
        }
        Kind::AngularContact => balls(BallKind::AngularContact { angle: 0.44 }),
        Kind::DeepGroove => balls(BallKind::DeepGroove { clearance: 1e-5 }),
    };
    let row = Row { mirrored: seat == 1, ..Row::new(elements) };
    RollingBearing::new(vec![row]).expect("a row")
}

/// Motions of the seats of a tube, and of all its nodes.
pub struct Tube {
    pub ring: Ring,
    pub seats: [[f64; 6]; 2],
    pub displacements: Vec<[f64; 3]>,
}

pub struct Solved {
    pub step: StepResult,
    /// Motion of the rigid body with the other rings; zero with two tubes.
    pub rigid: [f64; 6],
    pub tubes: Vec<Tube>,
}

/// Bearings between a tube and a rigid body, or between two tubes.
#[derive(Clone, Debug)]
pub struct Arrangement {
    /// Rings with tubes.
    pub rings: &'static [Ring],
    pub connection: Connection,
    pub modulus: f64,
    /// Angle about z by which the whole is rotated.
    pub rotated: f64,
    /// Axis of the tube in its own coordinates, see [`tube`]. That of an inner tube within another
    /// one is z, because a bearing is about the z axis of the body on which it is mounted.
    pub axis: usize,
    pub prescribed: f64,
    pub kind: Kind,
}

pub const OUTER: &[Ring] = &[Ring::Outer];
pub const INNER: &[Ring] = &[Ring::Inner];
pub const BOTH: &[Ring] = &[Ring::Outer, Ring::Inner];

pub fn arrangement() -> Arrangement {
    Arrangement {
        rings: OUTER,
        connection: RACEWAY,
        modulus: 206e9,
        rotated: 0.0,
        axis: 2,
        prescribed: 0.0,
        kind: Kind::Cylindrical,
    }
}

impl Arrangement {
    /// Axial position of the load, m.
    pub fn load_position(&self) -> f64 {
        if self.rings == BOTH { middle(0) } else { 0.5 * LENGTH }
    }

    fn axis(&self, ring: Ring) -> usize {
        if self.rings == BOTH && ring == Ring::Inner { 2 } else { self.axis }
    }

    fn tube(&self, ring: Ring) -> FiniteElementBody {
        let (&Arrangement { modulus, prescribed, .. }, axis) = (self, self.axis(ring));
        // The bearings support an inner tube within another one.
        let foot = (self.rings != BOTH || ring == Ring::Outer).then_some(prescribed);
        let content = Key::of("tube").numbers(&[modulus, prescribed, radius(ring)]).count(axis as u64);
        let content = content.count(self.rings.len() as u64).finish();
        let mut body = FiniteElementBody::new(Arc::new(tube(ring, modulus, axis, foot)), content);
        for (k, heights) in SEATS.into_iter().enumerate() {
            let region = Region::Cylinder {
                origin: [0.0; 3],
                axis: std::array::from_fn(|component| f64::from(u8::from(component == axis))),
                radius: radius(ring),
                heights,
                tolerance: 1e-6,
            };
            let (name, connection) = (format!("{ring:?} seat {k}"), self.connection.clone());
            body.attach(&Attachment { name, position: None, region, connection }).expect("a seat");
        }
        body
    }
}

/// Middle of a seat.
pub fn middle(seat: usize) -> f64 {
    0.5 * (SEATS[seat][0] + SEATS[seat][1])
}

pub fn solved(arrangement: &Arrangement) -> Solved {
    let Arrangement { rings, rotated, axis, kind, .. } = arrangement.clone();
    let mut scene = Scene::default();
    let (sine, cosine) = rotated.sin_cos();
    let rotation = [[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]];
    let at = |z: f64| {
        let motion = Arc::new(SteadyRotation::at_rest([0.0; 2]));
        RelocatedMotion { motion, pose: Pose { rotation, origin: [0.0, 0.0, z] } }
    };
    // The axis of a tube is z in the scene: columns are the axes of the body.
    let of_seat = |z: f64, axis: usize| {
        let placed = at(z);
        let of_tube = |row: [f64; 3]| std::array::from_fn(|component| row[(component + 2 - axis) % 3]);
        RelocatedMotion { pose: Pose { rotation: rotation.map(of_tube), ..placed.pose }, ..placed }
    };
    let [x, y] = FORCE;
    let force = [cosine * x - sine * y, sine * x + cosine * y, 0.0];
    let load = Wrench { force, moment: [MOMENT * cosine, MOMENT * sine, 0.0] };
    let supported = [true, true, false, true, true, false];
    let rigid = (rings != BOTH).then(|| {
        let body = Body::new("rigid", Arc::new(RigidBody), at(0.5 * LENGTH)).loaded(load);
        scene.add_body(Body { free: supported, ..body })
    });
    let mut tubes = Vec::new();
    for &ring in rings {
        let (body, axis) = (arrangement.tube(ring), arrangement.axis(ring));
        let positions: Vec<f64> = body.positions().iter().map(|position| position[axis]).collect();
        let seats: Vec<BodyId> = (0..2)
            .map(|k| {
                let seat =
                    Body::new(format!("{ring:?} seat {k}"), Arc::new(RigidBody), of_seat(positions[k], axis));
                let is_loaded = rings == BOTH && ring == Ring::Inner && k == 0;
                scene.add_body(match is_loaded {
                    true => Body { free: supported, ..seat.loaded(load) },
                    false => Body { free: [true; 6], ..seat },
                })
            })
            .collect();
        let connection =
            ElasticConnection::of_body(format!("{ring:?}"), Arc::new(body.clone()), &seats, [0.0; 3]);
        scene.add_connection(connection).expect("a connection");
        tubes.push((ring, body, seats));
    }
    for k in 0..2 {
        let carrier = |wanted: Ring| {
            let tube = tubes.iter().find(|(ring, ..)| *ring == wanted);
            tube.map(|(.., seats)| seats[k])
        };
        // Azimuths count from the x axis of the seat, or from y if the tube is along x.
        let first = if axis == 1 { 0.25 * TAU } else { 0.0 };
        let motion = Motion { azimuth: 0.1 - first, ..Motion::REST };
        let elements = RollingElements::new(bearing(kind, k), motion).expect("sound elements");
        let (elements, bodies, from) = match (carrier(Ring::Inner), carrier(Ring::Outer), rigid) {
            (Some(inner), Some(outer), _) => (elements, [inner, outer], middle(k)),
            (Some(inner), None, Some(rigid)) => (elements.inverted(), [rigid, inner], 0.5 * LENGTH),
            (None, Some(outer), Some(rigid)) => (elements, [rigid, outer], 0.5 * LENGTH),
            _ => unreachable!("a tube"),
        };
        let own = Bearing::new(format!("bearing {k}"), bodies[0], middle(k) - from, [[0.0; 6]; 6]);
        let nonlinear = Some(NonlinearLoad::Rolling(Arc::new(elements)));
        scene.add_bearing(Bearing { nonlinear, ..own }.between(bodies[1])).expect("a bearing");
    }
    let mut plan =
        Plan::whole(&scene, Fidelity::Solid(Template::Medium), StructureOptions::default()).expect("a plan");
    plan.bodies.iter_mut().for_each(|body| body.left_out = false);
    plan.connections.iter_mut().for_each(|connection| connection.left_out = false);
    let system = System::new(&scene, &plan).expect("a system");
    let step = system.solve(0.0).expect("equilibrium");
    let of_tubes = tubes.into_iter().enumerate().map(|(index, (ring, body, seats))| {
        let displacements = displacements(&system, &step, (index, &body));
        let seats = [seats[0], seats[1]].map(|BodyId(body)| system.moved(body, &step.motion));
        Tube { ring, seats, displacements }
    });
    let tubes = of_tubes.collect();
    let rigid = rigid.map_or([0.0; 6], |BodyId(body)| system.moved(body, &step.motion));
    Solved { step, rigid, tubes }
}

/// Displacements of the nodes of the tube of an elastic connection.
fn displacements(
    system: &System<'_>,
    step: &StepResult,
    (index, body): (usize, &FiniteElementBody),
) -> Vec<[f64; 3]> {
    let recovery = body.recovery(&Interrupt::never()).expect("solved").expect("a mesh");
    let connection = &system.elastic_connections[index];
    let state = ConnectionState::at(&system.scene.bodies, connection, 0.0).expect("placed");
    let motions = state.motions(&system.dofs, &step.motion);
    let mut on_raceways = vec![0.0; connection.raceways.terms()];
    for raceway in &step.raceways {
        let placed = system.elastic_raceways(raceway.bearing, 0.0).expect("placed").expect("elastic");
        for own in &placed.raceways {
            let seat = own.seat.expect("a seat");
            if seat.connection == index {
                let forces = own.on_terms(&raceway.loads);
                on_raceways[seat.first..].iter_mut().zip(&forces).for_each(|(sum, force)| *sum += force);
            }
        }
    }
    let forces = connection.forces_on_body(&motions, &on_raceways);
    recovery.deformed(&motions, &forces, &on_raceways).expect("valid").displacements
}

pub const RACEWAY: Connection = Connection::Raceway { harmonics: Some(HARMONICS), degree: 1 };
