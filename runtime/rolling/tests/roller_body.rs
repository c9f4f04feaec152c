//! Compliance of a roller's body: long rollers against the plane disc, and the displacement of
//! rollers between raceways.

use crate::sample::{close, cylindrical};
use calyx_rolling::hertz::line;
use calyx_rolling::{
    ContactModel, ElasticContact, Material, Motion, Profile, RollerGeometry, RollerKind, RollerRow,
    RollingBearing,
};
use std::f64::consts::PI;

/// Three rollers between nearly rigid raceways with a large radius.
fn between_rigid_planes(ratio: f64, settings: ElasticContact) -> RollingBearing {
    let diameter = 10e-3;
    let geometry = RollerGeometry {
        kind: RollerKind::Cylindrical { clearance: 0.0 },
        count: 3,
        roller_diameter: diameter,
        length: ratio * diameter,
        pitch_diameter: 100.0,
        profile: Profile::Straight,
        rings: Material { youngs_modulus: 206e15, ..Material::STEEL },
        ..cylindrical()
    };
    let row = RollerRow::new(geometry).expect("valid");
    RollingBearing::single(row.with_contact(ContactModel::Elastic(settings)).expect("valid"))
}

/// A plane disc between two loads w has the approach w/(πE') (2 ln(4R/b) - 1) of each contact to
/// its centre (Johnson, Contact Mechanics, section 5.6), and without axial force along the roller 2
/// ν² w/(πE) more.
#[test]
fn long_roller_has_the_approach_of_a_disc() {
    let steel = Material::STEEL;
    let plane = steel.youngs_modulus / (1.0 - steel.poissons_ratio.powi(2));
    for ratio in [3.2, 4.5, 6.4, 9.0] {
        let bearing = between_rigid_planes(ratio, ElasticContact::default());
        let at = [30e-6, 0.0, 0.0, 0.0, 0.0];
        let states = bearing.elements(&at, &Motion::REST).expect("finite");
        let roller = states[0].roller().expect("roller");
        let middle = roller.inner.loads.len() / 2;
        let load = roller.inner.loads[middle];
        let half_width = line::half_width(load, 5e-3, plane);
        let bracket = 2.0 * (4.0 * 5e-3 / half_width).ln() - 1.0;
        let free = 2.0 * steel.poissons_ratio.powi(2) / (1.0 - steel.poissons_ratio.powi(2));
        let expected = 2.0 * load / (PI * plane) * (bracket + free);
        close(at[0], expected, expected, if ratio < 4.0 { 3e-3 } else { 2e-3 }, "approach of both contacts");
    }
}
