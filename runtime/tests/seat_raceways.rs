//! Rolling bearings in two seats of an elastic tube, against the tube without condensation: the
//! displacement of both raceways by the loads of all rollers, the law of each element, and
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
    BallGeometry, BallKind, BallRow, ContactModel, Elements, Material, Motion, Profile, Rib, RollerGeometry,
    RollerKind, RollerRow, RollingBearing, Row, Start,
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

/// Elements of the bearings.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Cylindrical,
    Tapered,
    AngularContact,
    DeepGroove,
}

/// The bearing in a seat; that in the second one is mirrored.
fn bearing(kind: Kind, seat: usize) -> RollingBearing {
    let (pitch_diameter, steel) = (2.0 * RADIUS - ROLLER, Material::STEEL);
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
    kind: Kind,
}

fn arrangement() -> Arrangement {
    let kind = Kind::Cylindrical;
    Arrangement { connection: RACEWAY, modulus: 206e9, turned: 0.0, axis: 2, prescribed: 0.0, kind }
}

fn solved(arrangement: &Arrangement) -> Solved {
    let Arrangement { connection, modulus, turned, axis, prescribed, kind } = arrangement.clone();
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
        let elements = RollingElements::new(bearing(kind, k), motion).expect("sound elements");
        let own = Bearing::new(format!("bearing {k}"), shaft, positions[k] - 0.5 * LENGTH, [[0.0; 6]; 6]);
        let nonlinear = Some(NonlinearLoad::Rolling(Arc::new(elements)));
        scene.add_bearing(Bearing { nonlinear, ..own }.between(seat)).expect("a bearing");
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
fn fit(surface: &[(usize, f64, f64, f64)], moved: &[[f64; 3]]) -> Vec<f64> {
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

/// Angle of an element.
fn angle(element: usize) -> f64 {
    0.1 + TAU * element as f64 / ROLLERS as f64
}

#[test]
fn rollers_displace_both_raceways_as_on_the_whole_tube() {
    let model = tube(206e9, 2, 0.0);
    let solved = solved(&arrangement());
    let surfaces = SEATS.map(|seat| surface(&model, seat));

    // All forces of the rollers on the tube, which is not condensed.
    let mut loads = Vec::new();
    for (raceway, surface) in solved.step.raceways.iter().zip(&surfaces) {
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
    for (found, expected) in solved.displacements.iter().zip(&moved) {
        for axis in 0..3 {
            assert!((found[axis] - expected[axis]).abs() < 1e-8 * scale, "{found:?} {expected:?}");
        }
    }
    check_elements(
        &solved,
        &moved.iter().map(|[x, y, z, ..]| [*x, *y, *z]).collect::<Vec<_>>(),
        Kind::Cylindrical,
    );
}

/// Contact angles have contacts away from the middle of the row, axial forces and their moments.
#[test]
fn balls_and_tapered_rollers_displace_both_raceways() {
    for kind in [Kind::Tapered, Kind::AngularContact, Kind::DeepGroove] {
        let solved = solved(&Arrangement { kind, ..arrangement() });
        check_elements(&solved, &solved.displacements, kind);
    }
}

/// Checks that the displacements of the nodes of the tube contain those of the raceways, that the
/// loads of the elements are those of a bearing on these raceways, and equilibrium.
fn check_elements(solved: &Solved, moved: &[[f64; 3]], kind: Kind) {
    let Solved { step, shaft, seats, .. } = solved;
    assert!(step.certificate.largest() < 1e-10, "{:?}", step.certificate);
    assert_eq!(step.raceways.len(), 2);
    let model = tube(206e9, 2, 0.0);
    let scale = moved.iter().flatten().fold(0.0f64, |most, part| most.max(part.abs()));
    let mut resultant = [0.0; 5];
    for (k, raceway) in step.raceways.iter().enumerate() {
        let surface = surface(&model, SEATS[k]);
        // The seat moves as the mean of its nodes does.
        let mean = |axis: usize| {
            surface.iter().map(|(node, ..)| moved[*node][axis]).sum::<f64>() / surface.len() as f64
        };
        for axis in 0..3 {
            assert!((mean(axis) - seats[k][axis]).abs() < 1e-8 * mean(0).hypot(mean(1)), "{k} {axis}");
        }
        let coefficients = fit(&surface, moved);
        let laminae = bearing(kind, k);
        let row = &laminae.rows()[0];
        let contact = row.outer_contact();
        let series = Raceway { radius: RADIUS, ends: [-0.01, 0.01], harmonics: HARMONICS, degree: 1 };
        let shares = half_space_share(row, (&series, 206e9 / (1.0 - 0.3 * 0.3)), contact.position);
        let [x, y, _, about_x, about_y, _] = seats[k];
        for (roller, load) in raceway.loads.chunks(2).enumerate() {
            let (sine, cosine) = angle(roller).sin_cos();
            // Displacement and slope of the raceway.
            let at = terms(angle(roller), contact.position / 0.01);
            let slopes = terms(angle(roller), 1.0);
            let half = at.len() / 2;
            let expected: [f64; 2] = [
                at.iter().zip(&coefficients).map(|(term, coefficient)| term * coefficient).sum(),
                (half..at.len()).map(|k| slopes[k] * coefficients[k] / 0.01).sum(),
            ];
            let tilt = about_y * cosine - about_x * sine;
            let rigid = [x * cosine + y * sine + contact.position * tilt, tilt];
            // A ball sees no slope.
            for part in 0..if contact.width > 0.0 { 2 } else { 1 } {
                let by_half_space: f64 = (0..2).map(|by| shares[part][by] * load[by]).sum();
                let found = rigid[part] + raceway.displacement[roller][part] + by_half_space;
                let unit = if part == 0 { scale } else { scale / 0.01 };
                let what = format!("{kind:?}, seat {k}, element {roller}");
                assert!((found - expected[part]).abs() < 1e-8 * unit, "{what}: {found:e} {expected:?}");
            }
        }
        // Law of the elements on rings that are displaced relative to each other.
        let arm = 0.5 * (SEATS[k][0] + SEATS[k][1]) - 0.5 * LENGTH;
        let of_shaft = [shaft[0] + arm * shaft[4], shaft[1] - arm * shaft[3], shaft[2], shaft[3], shaft[4]];
        let between = std::array::from_fn(|component| of_shaft[component] - seats[k][component]);
        let elastic = laminae.with_contact(ContactModel::Elastic(Default::default())).expect("strips");
        let motion = Motion { azimuth: 0.1, ..Motion::REST };
        let (evaluation, loads) = elastic
            .evaluate_with(&between, &raceway.displacement, &motion, &mut Start::default())
            .expect("finite");
        let largest = raceway.loads.iter().fold(0.0f64, |most, load| most.max(load.abs()));
        assert!(largest > 1000.0, "{largest}");
        for (own, load) in loads.iter().zip(raceway.loads.chunks(2)) {
            for part in 0..2 {
                assert!(
                    (own.force[part] - load[part]).abs() < 1e-8 * largest,
                    "{kind:?} {k}: {own:?} {load:?}"
                );
            }
        }
        let [x, y, z, about_x, about_y] = evaluation.load;
        let moments = [about_x - arm * y, about_y + arm * x];
        let about_middle = [x, y, z, moments[0], moments[1]];
        resultant.iter_mut().zip(about_middle).for_each(|(sum, part)| *sum += part);
    }
    // Equilibrium of the shaft, which is held along its axis.
    for (component, expected) in [(0, FORCE[0]), (1, FORCE[1]), (3, MOMENT), (4, 0.0)] {
        let found = resultant[component];
        assert!((found - expected).abs() < 1e-7 * FORCE[1].abs(), "{kind:?}: {found} {expected}");
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
    for kind in [Kind::Tapered, Kind::AngularContact] {
        let [own, turned] =
            [0.0, 0.7].map(|turned| loads(&solved(&Arrangement { kind, turned, ..arrangement() })));
        for (own, turned) in own.iter().zip(&turned) {
            assert!((own - turned).abs() < 1e-8 * largest, "{kind:?}: {own} {turned}");
        }
    }
}

/// The thin tube increases the largest load of a roller. A stiff one has the loads of rigid rings:
/// the half-space that is subtracted is as stiff, whatever the material of the rings.
#[test]
fn a_stiff_tube_has_the_loads_of_a_rigid_raceway() {
    let largest = |modulus: f64| {
        let all = loads(&solved(&Arrangement { modulus, ..arrangement() }));
        all.into_iter().fold(0.0, f64::max)
    };
    let soft = largest(206e9);
    let [stiff, stiffer] = [1e16, 1e17].map(largest);
    assert!((stiff / stiffer - 1.0).abs() < 1e-4, "{stiff} {stiffer}");
    assert!(soft > 1.2 * stiff, "{soft} {stiff}");
    let average = Arrangement { connection: Connection::Average, modulus: 1e17, ..arrangement() };
    let Solved { step, shaft, seats, .. } = solved(&average);
    assert!(step.raceways.is_empty());
    let raceway = solved(&Arrangement { modulus: 1e17, ..arrangement() });
    for component in [0, 1, 3, 4] {
        let [own, rigid] = [(&raceway.shaft, &raceway.seats), (&shaft, &seats)]
            .map(|(shaft, seats)| shaft[component] - 0.5 * (seats[0][component] + seats[1][component]));
        let scale = if component < 2 { shaft[0].hypot(shaft[1]) } else { shaft[3].hypot(shaft[4]) };
        assert!((own - rigid).abs() < 1e-4 * scale, "{component}: {own:e} {rigid:e}");
    }
}
