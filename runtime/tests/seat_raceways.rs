//! Rolling bearings on two seats of an elastic tube, against the tube without condensation: the
//! displacement of both raceways by the loads of all rollers, the law of each element, and
//! equilibrium. The tube has their outer rings, their inner rings, or there are two tubes.

mod arrangement;

use arrangement::{
    Arrangement, BOTH, FORCE, HARMONICS, INNER, Kind, LENGTH, MOMENT, OUTER, ROLLERS, SEATS, Solved, Tube,
    arrangement, bearing, middle, radius, solved, tube,
};
use calyx_runtime::bearing::{Ring, half_space_share};
use calyx_runtime::elastic::assembly::System as ElasticSystem;
use calyx_runtime::elastic::attachment::Connection;
use calyx_runtime::elastic::{ElasticModel, NodalLoad, Resources as ElasticResources, statics};
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::rolling::{ContactModel, Motion, Row, Start};
use calyx_runtime::structure::Raceway;
use std::f64::consts::TAU;

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
fn surface(model: &ElasticModel, ring: Ring, [from, to]: [f64; 2]) -> Vec<(usize, f64, f64, f64)> {
    let on = model.nodes.iter().enumerate().filter(|(_, node)| {
        let [x, y, z] = node.position;
        (x.hypot(y) - radius(ring)).abs() < 1e-6 && z > from - 1e-6 && z < to + 1e-6
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
    for rings in [OUTER, INNER] {
        let ring = rings[0];
        let model = tube(ring, 206e9, 2, Some(0.0));
        let arrangement = Arrangement { rings, ..arrangement() };
        let mut solved = solved(&arrangement);
        let surfaces = SEATS.map(|seat| surface(&model, ring, seat));

        // All forces of the rollers on the tube, which is not condensed.
        let mut loads = Vec::new();
        for (k, (raceway, surface)) in solved.step.raceways.iter().zip(&surfaces).enumerate() {
            let motions = bearing(Kind::Cylindrical, k).rows()[0].relative_displacements(ring);
            let count = terms(0.0, 0.0).len();
            let mut on_terms = vec![0.0; count];
            for (roller, load) in raceway.loads.chunks(3).enumerate() {
                let [force, moment] = conjugate(&motions, load);
                // The moment acts on the derivative along the axis, in half-widths of 10 mm.
                let linear = (count / 2..count).map(|k| terms(angle(roller), 1.0)[k] * moment / 0.01);
                let mean = terms(angle(roller), 0.0).into_iter().take(count / 2).map(|term| term * force);
                on_terms.iter_mut().zip(mean.chain(linear)).for_each(|(sum, part)| *sum += part);
            }
            let mut squares = vec![0.0; count];
            for &(_, area, angle, zeta) in surface {
                terms(angle, zeta)
                    .iter()
                    .zip(&mut squares)
                    .for_each(|(term, sum)| *sum += area * term * term);
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
        for (found, expected) in solved.tubes[0].displacements.iter().zip(&moved) {
            for axis in 0..3 {
                assert!((found[axis] - expected[axis]).abs() < 1e-8 * scale, "{found:?} {expected:?}");
            }
        }
        solved.tubes[0].displacements = moved.iter().map(|[x, y, z, ..]| [*x, *y, *z]).collect();
        check_elements(&solved, &arrangement);
    }
}

/// Contact angles have contacts away from the middle of the row, axial forces and their moments.
#[test]
fn balls_and_tapered_rollers_displace_both_raceways() {
    for rings in [OUTER, INNER] {
        for kind in [Kind::Tapered, Kind::AngularContact, Kind::DeepGroove] {
            let arrangement = Arrangement { kind, rings, ..arrangement() };
            check_elements(&solved(&arrangement), &arrangement);
        }
    }
}

#[test]
fn elements_between_two_tubes_displace_the_raceways_of_both() {
    for kind in [Kind::Cylindrical, Kind::Tapered, Kind::DeepGroove] {
        let arrangement = Arrangement { kind, rings: BOTH, ..arrangement() };
        check_elements(&solved(&arrangement), &arrangement);
    }
}

/// Returns what is conjugate to the radial displacement of a raceway and its derivative, with the
/// [`calyx_runtime::rolling::bearing::Row::relative_displacements`] of its ring.
fn conjugate(motions: &[[f64; 2]; 3], load: &[f64]) -> [f64; 2] {
    [0, 1].map(|part| (0..3).map(|k| motions[k][part] * load[k]).sum())
}

/// Checks that the displacements of the nodes of the tubes contain those of the raceways, that the
/// loads of the elements are those of a bearing on these raceways, and equilibrium.
fn check_elements(solved: &Solved, arrangement: &Arrangement) {
    let (Solved { step, rigid, tubes }, kind) = (solved, arrangement.kind);
    assert!(step.certificate.largest() < 1e-10, "{:?}", step.certificate);
    assert_eq!(step.raceways.len(), 2);
    let all = tubes.iter().flat_map(|tube| tube.displacements.iter().flatten());
    let scale = all.fold(0.0f64, |most, part| most.max(part.abs()));
    let mut resultant = [0.0; 5];
    for (k, raceway) in step.raceways.iter().enumerate() {
        let laminae = bearing(kind, k);
        let row = &laminae.rows()[0];
        // Displacement of the raceways less that of rigid rings, from the nodes of the tubes.
        let mut expected = vec![[0.0; 3]; ROLLERS];
        for tube in tubes {
            let moved = deformation(tube, k, row, raceway.loads.as_chunks().0);
            let all = expected.iter_mut().flatten().zip(moved.into_iter().flatten());
            all.for_each(|(sum, part)| *sum += part);
        }
        for (element, (found, expected)) in raceway.displacement.iter().zip(&expected).enumerate() {
            for part in 0..3 {
                let unit = if part < 2 { scale } else { scale / 0.01 };
                let what = format!("{:?} {kind:?}, seat {k}, element {element}", arrangement.rings);
                assert!((found[part] - expected[part]).abs() < 1e-8 * unit, "{what}: {found:?} {expected:?}");
            }
        }
        // Law of the elements on rings that are displaced relative to each other.
        let arm = middle(k) - 0.5 * LENGTH;
        let of_rigid = [rigid[0] + arm * rigid[4], rigid[1] - arm * rigid[3], rigid[2], rigid[3], rigid[4]];
        let ring = |wanted: Ring| {
            let tube = tubes.iter().find(|tube| tube.ring == wanted);
            tube.map_or(of_rigid, |tube| std::array::from_fn(|component| tube.seats[k][component]))
        };
        let (inner, outer) = (ring(Ring::Inner), ring(Ring::Outer));
        let between = std::array::from_fn(|component| inner[component] - outer[component]);
        let elastic = laminae.with_contact(ContactModel::Elastic(Default::default())).expect("strips");
        let motion = Motion { azimuth: 0.1, ..Motion::REST };
        let (evaluation, loads) = elastic
            .evaluate_with(&between, &raceway.displacement, &motion, &mut Start::default())
            .expect("finite");
        let largest = raceway.loads.iter().fold(0.0f64, |most, load| most.max(load.abs()));
        assert!(largest > 500.0, "{largest}");
        for (own, load) in loads.iter().zip(raceway.loads.chunks(3)) {
            for part in 0..3 {
                assert!(
                    (own.force[part] - load[part]).abs() < 1e-8 * largest,
                    "{kind:?} {k}: {own:?} {load:?}"
                );
            }
        }
        // Load on the rigid body, or on the inner tube within another one.
        let sign = if arrangement.rings == INNER { -1.0 } else { 1.0 };
        let [x, y, z, about_x, about_y] = evaluation.load.map(|load| sign * load);
        let arm = middle(k) - arrangement.load_position();
        let about_load = [x, y, z, about_x - arm * y, about_y + arm * x];
        resultant.iter_mut().zip(about_load).for_each(|(sum, part)| *sum += part);
    }
    // Equilibrium of the loaded body, which is supported along its axis.
    for (component, expected) in [(0, FORCE[0]), (1, FORCE[1]), (3, MOMENT), (4, 0.0)] {
        let found = resultant[component];
        assert!((found - expected).abs() < 1e-7 * FORCE[1].abs(), "{kind:?}: {found} {expected}");
    }
}

/// Returns the displacement of a raceway at each element, less that of its seat as a rigid ring and
/// of the half-spaces of the loads, from the displacements of all nodes.
fn deformation(tube: &Tube, seat: usize, row: &Row, loads: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let Tube { ring, seats, displacements: moved } = tube;
    let surface = surface(&self::tube(*ring, 206e9, 2, None), *ring, SEATS[seat]);
    // The seat moves as the mean of its nodes does.
    let mean =
        |axis: usize| surface.iter().map(|(node, ..)| moved[*node][axis]).sum::<f64>() / surface.len() as f64;
    for axis in 0..3 {
        assert!((mean(axis) - seats[seat][axis]).abs() < 1e-8 * mean(0).hypot(mean(1)), "{seat} {axis}");
    }
    let coefficients = fit(&surface, moved);
    let (contact, motions) = (row.contact(*ring), row.relative_displacements(*ring));
    let series = Raceway { radius: radius(*ring), ends: [-0.01, 0.01], harmonics: HARMONICS, degree: 1 };
    let shares = half_space_share((row, *ring), (&series, 206e9 / (1.0 - 0.3 * 0.3)), contact.position);
    let [x, y, _, about_x, about_y, _] = seats[seat];
    let of = |(element, load): (usize, &[f64; 3])| {
        let (sine, cosine) = angle(element).sin_cos();
        let at = terms(angle(element), contact.position / 0.01);
        let slopes = terms(angle(element), 1.0);
        let half = at.len() / 2;
        let whole: [f64; 2] = [
            at.iter().zip(&coefficients).map(|(term, coefficient)| term * coefficient).sum(),
            (half..at.len()).map(|k| slopes[k] * coefficients[k] / 0.01).sum(),
        ];
        let tilt = about_y * cosine - about_x * sine;
        let rigid = [x * cosine + y * sine + contact.position * tilt, tilt];
        let on_raceway = conjugate(&motions, load);
        let radial = [0, 1].map(|part| {
            let half_space: f64 = (0..2).map(|by| shares[part][by] * on_raceway[by]).sum();
            whole[part] - rigid[part] - half_space
        });
        motions.map(|[by_displacement, by_slope]| by_displacement * radial[0] + by_slope * radial[1])
    };
    loads.iter().enumerate().map(of).collect()
}

fn loads(solved: &Solved) -> Vec<f64> {
    solved.step.raceways.iter().flat_map(|raceway| raceway.loads.iter().step_by(3).copied()).collect()
}

/// Rotated, with the axis of the tube along x or y of its file, and with supports that have a
/// value.
#[test]
fn the_same_arrangement_has_the_same_loads() {
    for rings in [OUTER, INNER, BOTH] {
        let arrangement = Arrangement { rings, ..arrangement() };
        let own = loads(&solved(&arrangement));
        let largest = own.iter().fold(0.0f64, |most, load| most.max(*load));
        let others = [
            Arrangement { rotated: 0.7, ..arrangement.clone() },
            Arrangement { axis: 0, ..arrangement.clone() },
            Arrangement { axis: 1, rotated: 0.7, ..arrangement.clone() },
            Arrangement { prescribed: 1e-4, ..arrangement.clone() },
        ];
        for other in others {
            for (own, found) in own.iter().zip(&loads(&solved(&other))) {
                assert!((own - found).abs() < 1e-8 * largest, "{other:?}: {own} {found}");
            }
        }
        for kind in [Kind::Tapered, Kind::AngularContact] {
            let [own, rotated] = [0.0, 0.7]
                .map(|rotated| loads(&solved(&Arrangement { kind, rotated, ..arrangement.clone() })));
            for (own, rotated) in own.iter().zip(&rotated) {
                assert!((own - rotated).abs() < 1e-8 * largest, "{kind:?}: {own} {rotated}");
            }
        }
    }
}

/// The half-spaces that are subtracted are softer than the elements where tubes are: the
/// elimination of raceways has a pole between both. Equilibrium is found on either side.
#[test]
fn soft_tubes_have_an_equilibrium() {
    for rings in [INNER, BOTH] {
        for modulus in [100e9, 70e9, 50e9, 30e9, 20e9, 10e9] {
            let connection = Connection::Raceway { harmonics: Some(12), degree: 1 };
            let step = solved(&Arrangement { rings, modulus, connection, ..arrangement() }).step;
            assert!(step.certificate.largest() < 1e-9, "{rings:?} {modulus:e}: {:?}", step.certificate);
        }
    }
}

/// A thin tube changes the largest load of a roller. A stiff one has the loads of rigid rings: the
/// half-space that is subtracted is as stiff, whatever the material of the rings.
#[test]
fn a_stiff_tube_has_the_loads_of_a_rigid_raceway() {
    for rings in [OUTER, INNER, BOTH] {
        let arrangement = Arrangement { rings, ..arrangement() };
        let largest = |modulus: f64| {
            let all = loads(&solved(&Arrangement { modulus, ..arrangement.clone() }));
            all.into_iter().fold(0.0, f64::max)
        };
        let soft = largest(206e9);
        let [stiff, stiffer] = [1e16, 1e17].map(largest);
        assert!((stiff / stiffer - 1.0).abs() < 1e-4, "{rings:?}: {stiff} {stiffer}");
        assert!((soft / stiff - 1.0).abs() > 0.1, "{rings:?}: {soft} {stiff}");
        let average = Arrangement { connection: Connection::Average, modulus: 1e17, ..arrangement.clone() };
        let average = solved(&average);
        assert!(average.step.raceways.is_empty());
        let raceway = solved(&Arrangement { modulus: 1e17, ..arrangement });
        // Motion of the loaded body relative to the seats on the other rings.
        let relative = |solved: &Solved, component: usize| {
            let seats = |tube: &Tube| 0.5 * (tube.seats[0][component] + tube.seats[1][component]);
            match &solved.tubes[..] {
                [outer, inner] => seats(inner) - seats(outer),
                tubes => solved.rigid[component] - tubes.iter().map(seats).sum::<f64>(),
            }
        };
        let [x, y, about_x, about_y] = [0, 1, 3, 4].map(|component| relative(&average, component));
        for (component, expected) in [(0, x), (1, y), (3, about_x), (4, about_y)] {
            let own = relative(&raceway, component);
            let scale = if component < 2 { x.hypot(y) } else { about_x.hypot(about_y) };
            assert!((own - expected).abs() < 1e-4 * scale, "{rings:?} {component}: {own:e} {expected:e}");
        }
    }
}
