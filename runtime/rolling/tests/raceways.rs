//! Raceways that are displaced at each element: loads on them, their derivatives, and rigid
//! motions.

use crate::sample::{
    angular_contact, balls, close, cylindrical, deep_groove, evaluate, four_point, rollers, spherical,
    tapered,
};
use calyx_rolling::bearing::Row;
use calyx_rolling::{
    Arrangement, ContactModel, Displacement, ElasticContact, Elements, Motion, RacewayDisplacement,
    RacewayLoad, Ring, RollingBearing, Start,
};

const LOADED: Displacement = [22e-6, -6e-6, 25e-6, 3e-4, -2e-4];

/// Bearings of all kinds, with laminae and elastic contacts, and mirrored rows.
fn all() -> Vec<(&'static str, RollingBearing)> {
    let elastic = |bearing: RollingBearing| {
        bearing.with_contact(ContactModel::Elastic(ElasticContact::default())).expect("valid")
    };
    let pair = |bearing: RollingBearing| {
        let elements = bearing.rows()[0].elements.clone();
        RollingBearing::pair(elements, Arrangement::BackToBack, 30e-3, 5e-6).expect("valid")
    };
    vec![
        ("deep groove", balls(deep_groove())),
        ("angular contact", balls(angular_contact())),
        ("pair of angular contact", pair(balls(angular_contact()))),
        ("four-point", balls(four_point())),
        ("cylindrical", rollers(cylindrical())),
        ("spherical", rollers(spherical())),
        ("tapered", rollers(tapered())),
        ("pair of tapered", pair(rollers(tapered()))),
        ("elastic cylindrical", elastic(rollers(cylindrical()))),
        ("elastic tapered", elastic(pair(rollers(tapered())))),
    ]
}

/// Displacements of the raceway of a ring that bends, one for each element.
fn bent(bearing: &RollingBearing, ring: Ring) -> Vec<RacewayDisplacement> {
    let of = |row: &Row| -> Vec<RacewayDisplacement> {
        let motions = row.relative_displacements(ring);
        let radial = |at: f64| [3e-6 * (2.0 * at + 0.3).cos(), 2e-4 * (3.0 * at).sin()];
        let moved = |[displacement, slope]: [f64; 2]| {
            motions.map(|[by_displacement, by_slope]| by_displacement * displacement + by_slope * slope)
        };
        row.azimuths(&Motion::REST).map(|at| moved(radial(at))).collect()
    };
    bearing.rows().iter().flat_map(of).collect()
}

fn loads(bearing: &RollingBearing, at: &Displacement, raceway: &[RacewayDisplacement]) -> Vec<RacewayLoad> {
    let found = bearing.evaluate_with(at, raceway, &Motion::REST, &mut Start::default()).expect("finite");
    assert_eq!(found.0.unconverged, 0);
    found.1
}

/// The states of the elements do not depend on the positions from which the search for them starts:
/// those of an evaluation at the same displacement, or at another one.
#[test]
fn states_do_not_depend_on_their_start() {
    for (name, bearing) in all() {
        let raceway = bent(&bearing, Ring::Outer);
        let states = |start: &Start| {
            let found = bearing.elements_with(&LOADED, &raceway, &Motion::REST, start).expect("finite");
            found.iter().map(|state| [state.load(), state.pressure()]).collect::<Vec<_>>()
        };
        let expected = states(&Start::default());
        let largest = [0, 1].map(|k| expected.iter().fold(0.0f64, |most, state| most.max(state[k])));
        for displacement in [LOADED, LOADED.map(|part| 0.3 * part), LOADED.map(|part| -part)] {
            let mut start = Start::default();
            let at = bearing.evaluate_with(&displacement, &raceway, &Motion::REST, &mut start);
            assert_eq!(at.expect("finite").0.unconverged, 0, "{name}");
            for (found, expected) in states(&start).into_iter().zip(&expected) {
                assert_eq!(found[0] > 0.0, expected[0] > 0.0, "{name}: {found:?} {expected:?}");
                for k in [0, 1] {
                    assert!(
                        (found[k] - expected[k]).abs() <= 1e-9 * largest[k],
                        "{name}: {found:?} {expected:?}"
                    );
                }
            }
        }
    }
}

/// The load of every element on a raceway, conjugate to the radial displacement and its derivative,
/// is the radial part of its contact load, and the moment of the radial loads along the contact
/// line.
#[test]
fn loads_on_raceways_are_those_of_the_contacts() {
    for (name, bearing) in all() {
        // The rib of tapered roller bearings is a further contact of the inner ring.
        let rings = if name.contains("tapered") { &[Ring::Outer][..] } else { &[Ring::Outer, Ring::Inner] };
        for &ring in rings {
            let raceway = bent(&bearing, ring);
            let states =
                bearing.elements_with(&LOADED, &raceway, &Motion::REST, &Start::default()).expect("finite");
            let loads = loads(&bearing, &LOADED, &raceway);
            let largest = states.iter().fold(0.0f64, |most, state| most.max(state.load()));
            assert!(largest > 100.0, "{name}");
            for (state, load) in states.iter().zip(&loads) {
                let row = &bearing.rows()[state.row];
                let motions = row.relative_displacements(ring);
                let on_raceway = [0, 1].map(|k| (0..3).map(|i| motions[i][k] * load.force[i]).sum::<f64>());
                let contact = row.contact(ring);
                // Elements press the inner raceway inwards. Positions along the contact line count
                // away from the apex, which is on +z.
                let outwards = if ring == Ring::Outer { 1.0 } else { -1.0 };
                let (side, cosine) = (if row.mirrored { -1.0 } else { 1.0 }, contact.angle.cos());
                let (radial, moment, tolerance) = match (state.ball(), state.roller()) {
                    (Some(ball), _) => {
                        let contacts = if ring == Ring::Outer { &ball.outer } else { &ball.inner };
                        let radial = contacts.iter().map(|contact| contact.load * contact.angle.cos());
                        (radial.sum::<f64>(), 0.0, 1e-10)
                    }
                    (_, Some(roller)) => {
                        let contact = if ring == Ring::Outer { &roller.outer } else { &roller.inner };
                        let moment = -side * cosine * cosine * contact.moment;
                        // The normals of barrel-shaped rollers vary along the contact.
                        let tolerance = if name == "spherical" { 5e-3 } else { 1e-9 };
                        (contact.load * cosine, moment, tolerance)
                    }
                    _ => (0.0, 0.0, 0.0),
                };
                let what = format!("{name}, {ring:?}");
                close(on_raceway[0], outwards * radial, largest, tolerance, &what);
                let arm = contact.width.max(1e-3);
                close(on_raceway[1], outwards * moment, largest * arm, tolerance, &format!("moment, {what}"));
            }
        }
    }
}

#[test]
fn derivatives_are_those_of_the_loads() {
    for (name, bearing) in all() {
        let raceway = bent(&bearing, Ring::Outer);
        let loads = |at: &Displacement, raceway: &[RacewayDisplacement]| loads(&bearing, at, raceway);
        let own = loads(&LOADED, &raceway);
        let stiffest = own.iter().fold(0.0f64, |most, load| most.max(load.stiffness[0][0]));
        let unit = [1.0, 1.0, 5e-3];
        for part in 0..3 {
            let moved = |step: f64| {
                let moved = raceway.iter().map(|&displacement| {
                    let mut moved = displacement;
                    moved[part] += step / unit[part];
                    moved
                });
                loads(&LOADED, &moved.collect::<Vec<_>>())
            };
            let step = 1e-9;
            let ends = [moved(step), moved(-step)];
            for (element, load) in own.iter().enumerate() {
                for row in 0..3 {
                    let change = ends[1][element].force[row] - ends[0][element].force[row];
                    let expected = change / (2.0 * step) / unit[row];
                    let value = load.stiffness[row][part] / unit[row] / unit[part];
                    close(value, expected, stiffest, 3e-4, &format!("{name}: stiffness {row} {part}"));
                }
            }
        }
        let unit_of_ring = [1.0, 1.0, 1.0, 30e-3f64, 30e-3];
        for column in 0..5 {
            let step = 1e-9;
            let ends = [step, -step].map(|step| {
                let mut at = LOADED;
                at[column] += step / unit_of_ring[column];
                loads(&at, &raceway)
            });
            for (element, load) in own.iter().enumerate() {
                for row in 0..3 {
                    let change = ends[0][element].force[row] - ends[1][element].force[row];
                    let expected = change / (2.0 * step) / unit[row];
                    let value = load.coupling[row][column] / unit[row] / unit_of_ring[column];
                    close(value, expected, stiffest, 2e-4, &format!("{name}: coupling {row} {column}"));
                }
            }
        }
    }
}

/// A raceway that moves radially as a rigid ring has the effect of a displacement of the rings: the
/// outer one of the opposite displacement of the inner ring, the inner one of the same.
#[test]
fn a_rigid_motion_of_a_raceway_is_one_of_the_ring() {
    for (name, bearing) in all() {
        for (ring, sign) in [(Ring::Outer, -1.0), (Ring::Inner, 1.0)] {
            let [x, y] = [4e-6, -7e-6];
            let of = |row: &Row| -> Vec<RacewayDisplacement> {
                let motions = row.relative_displacements(ring);
                let radial = |at: f64| x * at.cos() + y * at.sin();
                row.azimuths(&Motion::REST).map(|at| motions.map(|[by, _]| by * radial(at))).collect()
            };
            let moved: Vec<RacewayDisplacement> = bearing.rows().iter().flat_map(of).collect();
            let mut start = Start::default();
            let (found, _) =
                bearing.evaluate_with(&LOADED, &moved, &Motion::REST, &mut start).expect("finite");
            let mut at = LOADED;
            at[0] += sign * x;
            at[1] += sign * y;
            let expected = evaluate(&bearing, &at, &Motion::REST);
            for (found, expected) in found.load.iter().zip(expected.load) {
                close(*found, expected, expected.abs().max(1.0), 1e-8, &format!("{name}, {ring:?}"));
            }
        }
    }
}

/// A slope of a raceway along the axis, the same at the azimuths of a rotation of a ring about its
/// contacts, has the effect of this rotation on rollers with parallel contact lines.
#[test]
fn a_slope_of_a_raceway_is_a_rotation_of_the_ring() {
    let bearing = rollers(cylindrical());
    let rotation = 2e-4;
    for (ring, sign) in [(Ring::Outer, -1.0), (Ring::Inner, 1.0)] {
        let of = |row: &Row| -> Vec<RacewayDisplacement> {
            let motions = row.relative_displacements(ring);
            // A rotation about y moves a point at the height z by z times the angle along x.
            let slope = |at: f64| rotation * at.cos();
            row.azimuths(&Motion::REST).map(|at| motions.map(|[_, by]| by * slope(at))).collect()
        };
        let moved: Vec<RacewayDisplacement> = bearing.rows().iter().flat_map(of).collect();
        let (found, _) =
            bearing.evaluate_with(&LOADED, &moved, &Motion::REST, &mut Start::default()).expect("finite");
        let mut at = LOADED;
        at[4] += sign * rotation;
        let expected = evaluate(&bearing, &at, &Motion::REST);
        for (found, expected) in found.load.iter().zip(expected.load) {
            close(*found, expected, expected.abs().max(1.0), 1e-8, &format!("{ring:?}"));
        }
    }
}

/// Where contact lines begin and end, and their middle, by the drawing of the bearing.
#[test]
fn contacts_lie_where_the_drawing_has_them() {
    let own = |bearing: &RollingBearing| bearing.rows()[0].contact(Ring::Outer);
    let groove = own(&balls(deep_groove()));
    close(groove.radius, 30e-3 + 5.953e-3, 1.0, 1e-15, "bottom of the groove");
    assert_eq!([groove.position, groove.angle, groove.width], [0.0; 3]);
    let angular = balls(angular_contact());
    let (sine, cosine) = 40f64.to_radians().sin_cos();
    close(own(&angular).radius, 30e-3 + 5.556e-3 * cosine, 1.0, 1e-15, "radius");
    // A force on the inner ring to +z presses balls on the shoulder of the outer ring at +z.
    close(own(&angular).position, 5.556e-3 * sine, 1.0, 1e-15, "position");
    let state = angular.elements(&[0.0, 0.0, 20e-6, 0.0, 0.0], &Motion::REST).expect("finite").remove(0);
    assert!(state.ball().is_some_and(|ball| ball.outer[0].angle > 0.0));
    // The contact line of the cone ends at the pitch circle of the rollers, across their axis.
    let taper = own(&rollers(tapered()));
    let [across, half] = [12f64, 2.0].map(f64::to_radians);
    let slant = 30e-3 / across.sin() * half.cos();
    close(taper.radius, slant * 14f64.to_radians().sin(), 1.0, 1e-15, "radius of the cone");
    let apex = 30e-3 / across.tan();
    close(taper.position, apex - slant * 14f64.to_radians().cos(), 1.0, 1e-15, "position on the cone");
    close(taper.width, 13e-3 * 14f64.to_radians().cos(), 1.0, 1e-15, "width on the cone");
    // The cone of the inner raceway has the same apex, on the other side of the rollers.
    let inner = rollers(tapered()).rows()[0].contact(Ring::Inner);
    close(inner.radius, slant * 10f64.to_radians().sin(), 1.0, 1e-15, "radius of the inner cone");
    close(inner.position, apex - slant * 10f64.to_radians().cos(), 1.0, 1e-15, "position on the inner cone");
    let inner = angular.rows()[0].contact(Ring::Inner);
    close(inner.radius, 30e-3 - 5.556e-3 * cosine, 1.0, 1e-15, "inner radius");
    close(inner.position, -5.556e-3 * sine, 1.0, 1e-15, "inner position");
    // Mirrored rows have their contacts at mirrored positions.
    let Elements::Rollers(elements) = rollers(tapered()).rows()[0].elements.clone() else { return };
    let pair = RollingBearing::pair(*elements, Arrangement::FaceToFace, 30e-3, 0.0).expect("valid");
    let positions = [0, 1].map(|row| pair.rows()[row].contact(Ring::Outer).position);
    assert_eq!(positions, [-taper.position, taper.position]);
}
