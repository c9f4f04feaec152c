//! Roller bearings in two seats of an elastic tube, against the tube without condensation: the
//! displacement of both raceways by the loads of all rollers, the law of each roller, and
//! equilibrium.

use calyx_runtime::bearing::{Bearing, NonlinearLoad, RollingElements, half_space_share};
use calyx_runtime::cache::Key;
use calyx_runtime::connection::{ConnectionState, ElasticConnection};
use calyx_runtime::contact::solid::Pose;
use calyx_runtime::elastic::assembly::System as ElasticSystem;
use calyx_runtime::elastic::attachment::{Attachment, Connection, Region};
use calyx_runtime::elastic::model::SolidShape;
use calyx_runtime::elastic::{
    ElasticModel, Element, ElementKind, FixedComponents, Material as Steel, NodalLoad, Node,
    Resources as ElasticResources, statics,
};
use calyx_runtime::elastic_body::{ElasticBody, FiniteElementBody};
use calyx_runtime::fidelity::{Fidelity, StructureOptions, Template};
use calyx_runtime::ids::BodyId;
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::load::Wrench;
use calyx_runtime::motion::{RelocatedMotion, SteadyRotation};
use calyx_runtime::plan::Plan;
use calyx_runtime::rigid::RigidBody;
use calyx_runtime::rolling::{
    ContactModel, Material, Motion, Profile, RollerGeometry, RollerKind, RollerRow, RollingBearing,
};
use calyx_runtime::scene::{Body, Component, Scene};
use calyx_runtime::step::StepResult;
use calyx_runtime::structure::Raceway;
use calyx_runtime::system::System;
use std::f64::consts::TAU;
use std::sync::Arc;

const RADIUS: f64 = 0.03;
const OUTSIDE: f64 = 0.036;
const LENGTH: f64 = 0.08;
/// Elements around the tube, through its wall and along it.
const COUNTS: [usize; 3] = [48, 2, 8];
/// Axial positions of the ends of the seats.
const SEATS: [[f64; 2]; 2] = [[0.0, 0.02], [0.06, 0.08]];
const HARMONICS: u16 = 8;
const ROLLERS: usize = 14;
const ROLLER: f64 = 0.006;
const FORCE: [f64; 2] = [4e3, -9e3];
const MOMENT: f64 = 60.0;

/// A tube about the coordinate axis `axis`, from the two axes that follow it, whose foot, a strip
/// of its outside, is fixed at a prescribed displacement that bodies of scenes ignore.
fn tube(modulus: f64, axis: usize, prescribed: f64) -> ElasticModel {
    let [around, through, along] = COUNTS;
    let index = |i: usize, j: usize, k: usize| (i % around) + around * (j + (through + 1) * k);
    let mut nodes = Vec::new();
    for k in 0..=along {
        for j in 0..=through {
            for i in 0..around {
                let angle = TAU * i as f64 / around as f64;
                let radius = RADIUS + (OUTSIDE - RADIUS) * j as f64 / through as f64;
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
    let foot = (0..nodes.len()).filter(|&node| {
        let [x, y] = [1, 2].map(|after| nodes[node].position[(axis + after) % 3]);
        x.hypot(y) > OUTSIDE - 1e-6 && y < -0.9 * OUTSIDE
    });
    let fixed = foot.map(|node| FixedComponents { node, components: [true; 6], value: prescribed }).collect();
    let material = Steel {
        youngs_modulus: modulus,
        poissons_ratio: 0.3,
        shear_modulus: modulus / 2.6,
        density: 7850.0,
        structural_damping: 0.0,
    };
    ElasticModel { nodes, elements, materials: vec![material], fixed, ..ElasticModel::default() }
}

fn rollers() -> RollingBearing {
    let row = RollerRow::new(RollerGeometry {
        kind: RollerKind::Cylindrical { clearance: 1e-5 },
        count: ROLLERS,
        roller_diameter: ROLLER,
        length: 0.016,
        pitch_diameter: 2.0 * RADIUS - ROLLER,
        profile: Profile::Logarithmic,
        laminae: 21,
        rings: Material::STEEL,
        rollers: Material::STEEL,
        raceway_widths: [None; 2],
    });
    RollingBearing::single(row.expect("sound rollers"))
}

/// The shaft is body 0, the seats are bodies 1 and 2.
struct Solved {
    step: StepResult,
    shaft: [f64; 6],
    seats: [[f64; 6]; 2],
    /// Displacements of the nodes of the tube.
    displacements: Vec<[f64; 3]>,
}

/// A rigid shaft in the seats of a tube.
#[derive(Clone, Debug)]
struct Arrangement {
    connection: Connection,
    modulus: f64,
    /// Angle about z by which the whole is turned.
    turned: f64,
    /// Axis of the tube in its own coordinates, see [`tube`].
    axis: usize,
    prescribed: f64,
}

fn arrangement() -> Arrangement {
    Arrangement { connection: RACEWAY, modulus: 206e9, turned: 0.0, axis: 2, prescribed: 0.0 }
}

fn solved(arrangement: &Arrangement) -> Solved {
    let Arrangement { connection, modulus, turned, axis, prescribed } = arrangement.clone();
    let content = Key::of("tube").numbers(&[modulus, prescribed]).count(axis as u64).finish();
    let mut body = FiniteElementBody::new(Arc::new(tube(modulus, axis, prescribed)), content);
    for (k, heights) in SEATS.into_iter().enumerate() {
        let region = Region::Cylinder {
            origin: [0.0; 3],
            axis: std::array::from_fn(|component| f64::from(u8::from(component == axis))),
            radius: RADIUS,
            heights,
            tolerance: 1e-6,
        };
        let attachment =
            Attachment { name: format!("seat {k}"), position: None, region, connection: connection.clone() };
        body.attach(&attachment).expect("a seat");
    }
    let mut scene = Scene::default();
    let (sine, cosine) = turned.sin_cos();
    let rotation = [[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]];
    let at = |z: f64| {
        let motion = Arc::new(SteadyRotation::at_rest([0.0; 2]));
        RelocatedMotion { motion, pose: Pose { rotation, origin: [0.0, 0.0, z] } }
    };
    // The axis of the tube is z in the scene: columns are the axes of the body.
    let of_tube = |rotation: [[f64; 3]; 3]| {
        rotation.map(|row| std::array::from_fn(|component| row[(component + 2 - axis) % 3]))
    };
    let of_seat = |z: f64| {
        let placed = at(z);
        RelocatedMotion { pose: Pose { rotation: of_tube(rotation), ..placed.pose }, ..placed }
    };
    let [x, y] = FORCE;
    let force = [cosine * x - sine * y, sine * x + cosine * y, 0.0];
    let load = Wrench { force, moment: [MOMENT * cosine, MOMENT * sine, 0.0] };
    let shaft = Body::new("shaft", Arc::new(RigidBody), at(0.5 * LENGTH));
    let free = [Component::Ux, Component::Uy, Component::ThetaX, Component::ThetaY];
    let shaft = scene.add_body(shaft.free_in(&free).loaded(load));
    let positions: Vec<f64> = body.positions().iter().map(|position| position[axis]).collect();
    let seats: Vec<BodyId> = (0..2)
        .map(|k| {
            let seat = Body::new(format!("seat {k}"), Arc::new(RigidBody), of_seat(positions[k]));
            scene.add_body(Body { free: [true; 6], ..seat })
        })
        .collect();
    let connection = ElasticConnection::of_body("tube".into(), Arc::new(body.clone()), &seats, [0.0; 3]);
    scene.add_connection(connection).expect("a connection");
    for (k, &seat) in seats.iter().enumerate() {
        // Azimuths count from the x axis of the seat, or from y if the tube is along x.
        let first = if axis == 1 { 0.25 * TAU } else { 0.0 };
        let motion = Motion { azimuth: 0.1 - first, ..Motion::REST };
        let elements = RollingElements::new(rollers(), motion).expect("sound rollers");
        let bearing = Bearing::new(format!("rollers {k}"), shaft, positions[k] - 0.5 * LENGTH, [[0.0; 6]; 6]);
        let nonlinear = Some(NonlinearLoad::Rolling(Arc::new(elements)));
        scene.add_bearing(Bearing { nonlinear, ..bearing }.between(seat)).expect("a bearing");
    }
    let mut plan =
        Plan::whole(&scene, Fidelity::Solid(Template::Medium), StructureOptions::default()).expect("a plan");
    plan.bodies.iter_mut().for_each(|body| body.left_out = false);
    plan.connections.iter_mut().for_each(|connection| connection.left_out = false);
    let system = System::new(&scene, &plan).expect("a system");
    let step = system.solve(0.0).expect("equilibrium");
    let [shaft, first, second] = [0, 1, 2].map(|body| system.moved(body, &step.motion));
    let recovery = body.recovery(&Interrupt::never()).expect("solved").expect("a mesh");
    let connection = &system.elastic_connections[0];
    let state = ConnectionState::at(&scene.bodies, connection, 0.0).expect("placed");
    let motions = state.motions(&system.dofs, &step.motion);
    let mut on_raceways = vec![0.0; connection.raceways.terms()];
    for raceway in &step.raceways {
        let (_, first) = system.raceway_in_connection(raceway.bearing).expect("in a seat");
        let placed = system.elastic_raceway(raceway.bearing, 0.0).expect("placed").expect("elastic");
        let forces = placed.on_terms(&raceway.loads);
        on_raceways[first..].iter_mut().zip(forces).for_each(|(sum, force)| *sum += force);
    }
    let forces = connection.forces_on_body(&motions, &on_raceways);
    let displacements = recovery.deformed(&motions, &forces, &on_raceways).expect("valid").displacements;
    Solved { step, shaft, seats: [first, second], displacements }
}

const RACEWAY: Connection = Connection::Raceway { harmonics: Some(HARMONICS), degree: 1 };

/// Terms of the series at an angle and a position relative to the half-width of the seat.
fn terms(angle: f64, zeta: f64) -> Vec<f64> {
    let mut terms = Vec::new();
    for along in [1.0, zeta] {
        terms.push(along);
        for k in 1..=HARMONICS {
            let (sine, cosine) = (f64::from(k) * angle).sin_cos();
            terms.extend([along * cosine, along * sine]);
        }
    }
    terms
}

/// Nodes of a seat with their area, angle and relative position.
fn surface(model: &ElasticModel, [from, to]: [f64; 2]) -> Vec<(usize, f64, f64, f64)> {
    let on = model.nodes.iter().enumerate().filter(|(_, node)| {
        let [x, y, z] = node.position;
        x.hypot(y) < RADIUS + 1e-6 && z > from - 1e-6 && z < to + 1e-6
    });
    on.map(|(index, node)| {
        let [x, y, z] = node.position;
        let zeta = (2.0 * z - from - to) / (to - from);
        (index, if zeta.abs() > 0.9 { 0.5 } else { 1.0 }, y.atan2(x), zeta)
    })
    .collect()
}

/// Coefficients of the radial displacement of a seat.
fn fit(surface: &[(usize, f64, f64, f64)], moved: &[[f64; 6]]) -> Vec<f64> {
    let count = terms(0.0, 0.0).len();
    let (mut sums, mut squares) = (vec![0.0; count], vec![0.0; count]);
    for &(node, area, angle, zeta) in surface {
        let radial = moved[node][0] * angle.cos() + moved[node][1] * angle.sin();
        for (k, term) in terms(angle, zeta).into_iter().enumerate() {
            sums[k] += area * term * radial;
            squares[k] += area * term * term;
        }
    }
    sums.iter().zip(squares).map(|(sum, square)| sum / square).collect()
}

#[test]
fn rollers_displace_both_raceways_as_on_the_whole_tube() {
    let model = tube(206e9, 2, 0.0);
    let Solved { step, shaft, seats, displacements } = solved(&arrangement());
    assert!(step.certificate.largest() < 1e-10, "{:?}", step.certificate);
    let surfaces = SEATS.map(|seat| surface(&model, seat));
    let angle = |roller: usize| 0.1 + TAU * roller as f64 / ROLLERS as f64;
    assert_eq!(step.raceways.len(), 2);

    // All forces of the rollers on the tube, which is not condensed.
    let mut loads = Vec::new();
    for (raceway, surface) in step.raceways.iter().zip(&surfaces) {
        let count = terms(0.0, 0.0).len();
        let mut on_terms = vec![0.0; count];
        for (roller, load) in raceway.loads.chunks(2).enumerate() {
            // The moment acts on the derivative along the axis, in half-widths of 10 mm.
            let linear = (count / 2..count).map(|k| terms(angle(roller), 1.0)[k] * load[1] / 0.01);
            let mean = terms(angle(roller), 0.0).into_iter().take(count / 2).map(|term| term * load[0]);
            on_terms.iter_mut().zip(mean.chain(linear)).for_each(|(sum, part)| *sum += part);
        }
        let mut squares = vec![0.0; count];
        for &(_, area, angle, zeta) in surface {
            terms(angle, zeta).iter().zip(&mut squares).for_each(|(term, sum)| *sum += area * term * term);
        }
        for &(node, area, angle, zeta) in surface {
            let all = terms(angle, zeta).into_iter().zip(&on_terms).zip(&squares);
            let force: f64 = all.map(|((term, on), square)| area * term * on / square).sum();
            let load = [force * angle.cos(), force * angle.sin(), 0.0, 0.0, 0.0, 0.0];
            loads.push(NodalLoad { node, load });
        }
    }
    let resources = ElasticResources { interrupt: Interrupt::never(), ..ElasticResources::default() };
    let whole = ElasticSystem::new(&model, &resources).expect("a sound model");
    let moved = statics::solve(&whole, &[loads], &resources).expect("supported").remove(0).displacements;

    let scale = moved.iter().flatten().fold(0.0f64, |most, part| most.max(part.abs()));
    for (found, expected) in displacements.iter().zip(&moved) {
        for axis in 0..3 {
            assert!((found[axis] - expected[axis]).abs() < 1e-8 * scale, "{found:?} {expected:?}");
        }
    }
    let laminae = rollers();
    let elastic = laminae.with_contact(ContactModel::Elastic(Default::default())).expect("strips");
    let mut resultant = [0.0; 4];
    for (k, (raceway, surface)) in step.raceways.iter().zip(&surfaces).enumerate() {
        // The seat moves as the mean of its nodes does.
        let mean = |axis: usize| {
            surface.iter().map(|(node, ..)| moved[*node][axis]).sum::<f64>() / surface.len() as f64
        };
        for axis in 0..3 {
            assert!((mean(axis) - seats[k][axis]).abs() < 1e-8 * mean(0).hypot(mean(1)), "{k} {axis}");
        }
        let coefficients = fit(surface, &moved);
        let row = &laminae.rows()[0];
        let series = Raceway { radius: RADIUS, ends: [-0.01, 0.01], harmonics: HARMONICS, degree: 1 };
        let shares = half_space_share(row, &series, 0.0);
        let arm = 0.5 * (SEATS[k][0] + SEATS[k][1]) - 0.5 * LENGTH;
        let largest = raceway.loads.iter().fold(0.0f64, |most, load| most.max(load.abs()));
        for roller in 0..ROLLERS {
            let ([sine, cosine], load) =
                ([angle(roller).sin(), angle(roller).cos()], &raceway.loads[2 * roller..]);
            resultant[0] += load[0] * cosine;
            resultant[1] += load[0] * sine;
            // Moments about the middle of the shaft: of the force, and of the rollers themselves.
            resultant[2] -= arm * load[0] * sine + load[1] * sine;
            resultant[3] += arm * load[0] * cosine + load[1] * cosine;
            // Displacement and slope of the raceway.
            let all = terms(angle(roller), 0.0);
            let half = all.len() / 2;
            let at = terms(angle(roller), 1.0);
            let expected: [f64; 2] = [
                (0..half).map(|k| all[k] * coefficients[k]).sum(),
                (half..all.len()).map(|k| at[k] * coefficients[k] / 0.01).sum(),
            ];
            let [x, y, _, about_x, about_y, _] = seats[k];
            let rigid = [x * cosine + y * sine, about_y * cosine - about_x * sine];
            for part in 0..2 {
                let found =
                    rigid[part] + raceway.displacement[roller][part] + shares[part][part] * load[part];
                let unit = if part == 0 { scale } else { scale / 0.01 };
                assert!((found - expected[part]).abs() < 1e-8 * unit, "{k} {roller}: {found:e} {expected:?}");
            }
            // Law of the roller: its load between rigid rings at the local approach.
            let of_shaft = [shaft[0] + arm * shaft[4], shaft[1] - arm * shaft[3]];
            let approach =
                of_shaft[0] * cosine + of_shaft[1] * sine - rigid[0] - raceway.displacement[roller][0];
            let tilt = shaft[4] * cosine - shaft[3] * sine - rigid[1] - raceway.displacement[roller][1];
            let ring = [approach * cosine, approach * sine, 0.0, -tilt * sine, tilt * cosine];
            let states = elastic.elements(&ring, &Motion { azimuth: 0.1, ..Motion::REST }).expect("finite");
            let own = states[roller].roller().expect("a roller").outer.load;
            assert!((own - load[0]).abs() < 1e-8 * largest, "{k} {roller}: {own} {}", load[0]);
        }
    }
    // Equilibrium of the shaft.
    for (found, expected) in resultant.into_iter().zip([FORCE[0], FORCE[1], MOMENT, 0.0]) {
        assert!((found - expected).abs() < 1e-7 * FORCE[1].abs(), "{found} {expected}");
    }
}

fn loads(solved: &Solved) -> Vec<f64> {
    solved.step.raceways.iter().flat_map(|raceway| raceway.loads.iter().step_by(2).copied()).collect()
}

/// Turned, with the axis of the tube along x or y of its file, and with supports that have a value.
#[test]
fn the_same_arrangement_has_the_same_loads() {
    let own = loads(&solved(&arrangement()));
    let largest = own.iter().fold(0.0f64, |most, load| most.max(*load));
    let others = [
        Arrangement { turned: 0.7, ..arrangement() },
        Arrangement { axis: 0, ..arrangement() },
        Arrangement { axis: 1, turned: 0.7, ..arrangement() },
        Arrangement { prescribed: 1e-4, ..arrangement() },
    ];
    for other in others {
        for (own, found) in own.iter().zip(&loads(&solved(&other))) {
            assert!((own - found).abs() < 1e-8 * largest, "{other:?}: {own} {found}");
        }
    }
}

/// The thin tube increases the largest load of a roller; that of a stiff one converges as the
/// compliance vanishes.
#[test]
fn a_stiff_tube_has_the_loads_of_a_rigid_raceway() {
    let largest = |modulus: f64| {
        let all = loads(&solved(&Arrangement { modulus, ..arrangement() }));
        all.into_iter().fold(0.0, f64::max)
    };
    let soft = largest(206e9);
    let [stiff, stiffer] = [1e16, 1e17].map(largest);
    println!("{soft} {stiff} {stiffer}");
    assert!((stiff / stiffer - 1.0).abs() < 2e-3, "{stiff} {stiffer}");
    assert!(soft > 1.2 * stiff, "{soft} {stiff}");
}
