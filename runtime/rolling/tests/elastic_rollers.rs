//! Elastic contact of rollers: stiffness, symmetry, equilibrium of the elements, limits.

use crate::sample::{
    check_hostile, check_stiffness, check_symmetry, close, cylindrical, evaluate, spherical, tapered,
};
use calyx_rolling::{
    ContactModel, Displacement, ElasticContact, Motion, RollerGeometry, RollerRow, RollingBearing, Start,
};

const LOADED: Displacement = [22e-6, -6e-6, 25e-6, 3e-4, -2e-4];

fn elastic(geometry: RollerGeometry) -> RollingBearing {
    let row = RollerRow::new(geometry).expect("valid");
    RollingBearing::single(row.with_contact(ContactModel::Elastic(ElasticContact::default())).expect("valid"))
}

/// Cylindrical rollers between an inner raceway that ends with them and a wider outer one.
fn between_narrow_raceways() -> RollerGeometry {
    RollerGeometry { raceway_widths: [Some(10e-3), Some(12e-3)], ..cylindrical() }
}

#[test]
fn stiffness_is_the_derivative_of_the_load() {
    let speed = Motion { inner_speed: 800.0, ..Motion::REST };
    for geometry in [cylindrical(), tapered(), spherical(), between_narrow_raceways()] {
        for motion in [Motion::REST, speed] {
            check_stiffness(&elastic(geometry.clone()), &LOADED, &motion, 1e-5);
        }
    }
}

#[test]
fn stiffness_is_symmetric() {
    for geometry in [cylindrical(), tapered(), spherical(), between_narrow_raceways()] {
        check_symmetry(&elastic(geometry), &LOADED);
    }
}

#[test]
fn hostile_displacements_have_finite_results() {
    let motions = [0.0, 2000.0].map(|inner_speed| Motion { inner_speed, ..Motion::REST });
    for geometry in [cylindrical(), tapered(), spherical()] {
        check_hostile(&elastic(geometry), &motions, (-9..0, 8), -3);
    }
}

/// The loads on each tapered roller balance, with the geometry of the cones written out again.
#[test]
fn elements_are_in_equilibrium() {
    let bearing = elastic(tapered());
    let motion = Motion { roller_force: Some(16.5), ..Motion::REST };
    let [inner, axis, outer] = [10f64, 12.0, 14.0].map(f64::to_radians);
    let sine = 3.2e-3f64 / 0.12;
    let cosine = (1.0 - sine * sine).sqrt();
    let mut loaded = 0;
    for state in bearing.elements(&LOADED, &motion).expect("finite") {
        let roller = state.roller().expect("rollers");
        let (fi, fo, rib) = (roller.inner.load, roller.outer.load, roller.rib);
        let normal = [-axis.sin() * cosine + axis.cos() * sine, axis.cos() * cosine + axis.sin() * sine];
        let radial = fi * inner.cos() - fo * outer.cos() + rib * normal[0] + 16.5;
        let axial = fi * inner.sin() - fo * outer.sin() + rib * normal[1];
        close(radial, 0.0, fi + fo, 1e-12, "radial");
        close(axial, 0.0, fi + fo, 1e-12, "axial");
        let moment = roller.inner.moment - roller.outer.moment - rib * (0.12 - 6.5e-3) * sine;
        close(moment, 0.0, (fi + fo) * 6.5e-3, 1e-11, "moment");
        loaded += usize::from(fi > 100.0);
    }
    assert!(loaded > 3);
}

/// Element forces sum to the load of the ring, and the load turns with the displacement.
#[test]
fn rotated_bearing_has_rotated_loads() {
    let bearing = elastic(tapered());
    let load = evaluate(&bearing, &LOADED, &Motion::REST).load;
    for turn in [0.3, 2.0, 5.5f64] {
        let rotate = |v: [f64; 5]| {
            let (s, c) = turn.sin_cos();
            [c * v[0] - s * v[1], s * v[0] + c * v[1], v[2], c * v[3] - s * v[4], s * v[3] + c * v[4]]
        };
        let motion = Motion { azimuth: turn, ..Motion::REST };
        let (turned, expected) = (evaluate(&bearing, &rotate(LOADED), &motion).load, rotate(load));
        for k in 0..5 {
            let unit = if k < 3 { 1.0 } else { 30e-3 };
            close(turned[k] / unit, expected[k] / unit, load[2].abs(), 1e-10, "load");
        }
    }
}

#[test]
fn displacement_balances_the_load() {
    let bearing = elastic(tapered());
    let load = [3000.0, -1000.0, 2500.0, 20.0, -15.0];
    let found = bearing.displacement(&load, &Motion::REST).expect("solved");
    for k in 0..5 {
        let unit = if k < 3 { 1.0 } else { 30e-3 };
        close(found.evaluation.load[k] / unit, load[k] / unit, found.evaluation.scale, 1e-12, "load");
    }
}

/// A former state changes the number of steps and not the result.
#[test]
fn start_does_not_change_the_result() {
    let bearing = elastic(tapered());
    let cold = evaluate(&bearing, &LOADED, &Motion::REST);
    let mut start = Start::default();
    for scale in [-1.0, 4.0, 0.2, 1.0] {
        let warm = bearing.evaluate(&LOADED.map(|x| scale * x), &Motion::REST, &mut start).expect("finite");
        if scale == 1.0 {
            for k in 0..5 {
                close(warm.load[k], cold.load[k], cold.scale, 1e-10, "load");
            }
        }
    }
}

/// Side faces far from the rollers have no effect, and near ones relieve the ends.
#[test]
fn raceways_of_finite_width_relieve_the_ends() {
    let of = |width| {
        let geometry = RollerGeometry { raceway_widths: [width; 2], ..cylindrical() };
        let states = elastic(geometry).elements(&[60e-6, 0.0, 0.0, 0.0, 0.0], &Motion::REST).expect("finite");
        let contact = &states[0].roller().expect("rollers").inner;
        let most = contact.loads.iter().copied().fold(0.0, f64::max);
        (contact.load, contact.loads[4] / most)
    };
    let wide = of(None);
    let far = of(Some(10.0));
    close(far.0, wide.0, wide.0, 1e-5, "load");
    close(far.1, wide.1, 1.0, 1e-5, "load at the end");
    let mut former = wide;
    for width in [20e-3, 13e-3, 11e-3, 10e-3] {
        let found = of(Some(width));
        assert!(found.1 < former.1 && found.1 > 0.0, "{width}: {found:?} {former:?}");
        // The deflection of the raceways as a whole is none of the contacts.
        close(found.0, wide.0, wide.0, 0.03, "load");
        former = found;
    }
}

/// The rating life has the laminae of the standard under the load and moment of each contact.
#[test]
fn laminae_of_the_rating_life_have_the_load_of_the_contact() {
    let bearing = elastic(cylindrical());
    for state in bearing.elements(&[40e-6, 0.0, 0.0, 0.0, 4e-4], &Motion::REST).expect("finite") {
        let roller = state.roller().expect("rollers");
        for contact in [&roller.inner, &roller.outer] {
            let length = 10e-3 / contact.laminae.len() as f64;
            let position = |k: usize| ((k as f64 + 0.5) / 41.0 - 0.5) * 10e-3;
            let sum: f64 = contact.laminae.iter().map(|load| load * length).sum();
            let moment: f64 =
                contact.laminae.iter().enumerate().map(|(k, load)| load * length * position(k)).sum();
            close(sum, contact.load, contact.load.max(1.0), 1e-10, "load");
            close(moment, contact.moment, 5e-3 * contact.load.max(1.0), 1e-10, "moment");
        }
    }
}

#[test]
fn number_of_strips_is_checked() {
    let row = RollerRow::new(cylindrical()).expect("valid");
    let settings = ElasticContact { strips: 3, ..ElasticContact::default() };
    let error = row.with_contact(ContactModel::Elastic(settings)).expect_err("too few");
    assert!(error.to_string().contains("3 strips"));
}
