//! Outer raceways that are displaced at each element: loads on them, their derivatives, and rigid
//! motions.

use crate::sample::{
    angular_contact, balls, close, cylindrical, deep_groove, evaluate, four_point, rollers, spherical,
    tapered,
};
use calyx_rolling::{
    Arrangement, ContactModel, Displacement, ElasticContact, Elements, Motion, RacewayDisplacement,
    RacewayLoad, RollingBearing, Start,
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

/// Displacements of a raceway that bends, one for each element.
fn bent(bearing: &RollingBearing) -> Vec<RacewayDisplacement> {
    let azimuths = bearing.rows().iter().flat_map(|row| row.azimuths(&Motion::REST));
    azimuths.map(|at| [3e-6 * (2.0 * at + 0.3).cos(), 2e-4 * (3.0 * at).sin()]).collect()
}

fn loads(bearing: &RollingBearing, at: &Displacement, raceway: &[RacewayDisplacement]) -> Vec<RacewayLoad> {
    let found = bearing.evaluate_with(at, raceway, &Motion::REST, &mut Start::default()).expect("finite");
    assert_eq!(found.0.unconverged, 0);
    found.1
}

/// The radial load of every element is the radial part of its load on the outer raceway, and its
/// moment that of the radial loads along the contact line.
#[test]
fn loads_on_the_raceway_are_those_of_the_outer_contacts() {
    for (name, bearing) in all() {
        let raceway = bent(&bearing);
        let states = bearing.elements_with(&LOADED, &raceway, &Motion::REST).expect("finite");
        let loads = loads(&bearing, &LOADED, &raceway);
        let largest = states.iter().fold(0.0f64, |most, state| most.max(state.load()));
        assert!(largest > 100.0, "{name}");
        for (state, load) in states.iter().zip(&loads) {
            let row = &bearing.rows()[state.row];
            let contact = row.outer_contact();
            // Positions along the contact line count away from the apex, which is on +z.
            let (side, cosine) = (if row.mirrored { -1.0 } else { 1.0 }, contact.angle.cos());
            let (radial, moment, tolerance) = match (state.ball(), state.roller()) {
                (Some(ball), _) => {
                    (ball.outer.iter().map(|contact| contact.load * contact.angle.cos()).sum(), 0.0, 1e-10)
                }
                (_, Some(roller)) => {
                    let moment = -side * cosine * cosine * roller.outer.moment;
                    // The normals of barrel-shaped rollers vary along the contact.
                    let tolerance = if name == "spherical" { 5e-3 } else { 1e-9 };
                    (roller.outer.load * cosine, moment, tolerance)
                }
                _ => (0.0, 0.0, 0.0),
            };
            close(load.force[0], radial, largest, tolerance, name);
            let arm = contact.width.max(1e-3);
            close(load.force[1], moment, largest * arm, tolerance, &format!("moment, {name}"));
        }
    }
}

#[test]
fn derivatives_are_those_of_the_loads() {
    for (name, bearing) in all() {
        let raceway = bent(&bearing);
        let loads = |at: &Displacement, raceway: &[RacewayDisplacement]| loads(&bearing, at, raceway);
        let own = loads(&LOADED, &raceway);
        let stiffest = own.iter().fold(0.0f64, |most, load| most.max(load.stiffness[0][0]));
        let unit = [1.0, 5e-3];
        for part in 0..2 {
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
                for row in 0..2 {
                    let change = ends[1][element].force[row] - ends[0][element].force[row];
                    let expected = change / (2.0 * step) / unit[row];
                    let value = load.stiffness[row][part] / unit[row] / unit[part];
                    close(value, expected, stiffest, 2e-4, &format!("{name}: stiffness {row} {part}"));
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
                for row in 0..2 {
                    let change = ends[0][element].force[row] - ends[1][element].force[row];
                    let expected = change / (2.0 * step) / unit[row];
                    let value = load.coupling[row][column] / unit[row] / unit_of_ring[column];
                    close(value, expected, stiffest, 2e-4, &format!("{name}: coupling {row} {column}"));
                }
            }
        }
    }
}

/// A raceway that moves radially as a rigid ring has the effect of the opposite displacement of the
/// inner ring.
#[test]
fn a_rigid_motion_of_the_raceway_is_one_of_the_ring() {
    for (name, bearing) in all() {
        let [x, y] = [4e-6, -7e-6];
        let azimuths = bearing.rows().iter().flat_map(|row| row.azimuths(&Motion::REST));
        let moved: Vec<RacewayDisplacement> = azimuths.map(|at| [x * at.cos() + y * at.sin(), 0.0]).collect();
        let mut start = Start::default();
        let (found, _) = bearing.evaluate_with(&LOADED, &moved, &Motion::REST, &mut start).expect("finite");
        let mut ring = LOADED;
        ring[0] -= x;
        ring[1] -= y;
        let expected = evaluate(&bearing, &ring, &Motion::REST);
        for (found, expected) in found.load.iter().zip(expected.load) {
            close(*found, expected, expected.abs().max(1.0), 1e-8, name);
        }
    }
}

/// Where contact lines begin and end, and their middle, by the drawing of the bearing.
#[test]
fn contacts_lie_where_the_drawing_has_them() {
    let own = |bearing: &RollingBearing| bearing.rows()[0].outer_contact();
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
    // Mirrored rows have their contacts at mirrored positions.
    let Elements::Rollers(elements) = rollers(tapered()).rows()[0].elements.clone() else { return };
    let pair = RollingBearing::pair(*elements, Arrangement::FaceToFace, 30e-3, 0.0).expect("valid");
    let positions = [0, 1].map(|row| pair.rows()[row].outer_contact().position);
    assert_eq!(positions, [-taper.position, taper.position]);
}
