//! Rejected inputs: each with its reason and remedy.

use crate::sample::{angular_contact, cylindrical, deep_groove, spherical, tapered};
use calyx_rolling::ball::BallGeometry;
use calyx_rolling::{
    BallKind, BallRow, Material, Motion, Profile, Rib, RollerGeometry, RollerKind, RollerRow, RollingBearing,
    RollingError, Start,
};

#[track_caller]
fn rejected<T: std::fmt::Debug>(result: Result<T, RollingError>, reason: &str, remedy: &str) {
    let error = result.expect_err("rejected");
    assert!(error.to_string().contains(reason), "{error}");
    assert!(error.help().contains(remedy), "{}", error.help());
}

#[test]
fn impossible_balls() {
    let base = deep_groove();
    let row = BallRow::new;
    rejected(row(BallGeometry { count: 16, ..base }), "do not fit on a pitch circle", "at most 15");
    rejected(row(BallGeometry { count: 0, ..base }), "0 balls", "number of balls");
    rejected(row(BallGeometry { ball_diameter: 60e-3, ..base }), "no space for the inner ring", "reduce");
    rejected(row(BallGeometry { ball_diameter: -1.0, ..base }), "must be positive", "positive ball diameter");
    rejected(row(BallGeometry { pitch_diameter: f64::NAN, ..base }), "must be positive", "pitch diameter");
    rejected(row(BallGeometry { inner_conformity: 0.5, ..base }), "inner groove", "between 0.5 and 1");
    rejected(row(BallGeometry { outer_conformity: 0.49, ..base }), "outer groove", "between 0.5 and 1");
    let kind = |kind| BallGeometry { kind, ..base };
    rejected(row(kind(BallKind::DeepGroove { clearance: 1e-3 })), "cannot touch both grooves", "less than");
    rejected(row(kind(BallKind::DeepGroove { clearance: -0.2e-3 })), "would indent", "at most");
    rejected(
        row(kind(BallKind::DeepGroove { clearance: f64::INFINITY })),
        "must be finite",
        "finite clearance",
    );
    rejected(row(kind(BallKind::AngularContact { angle: 1.6 })), "contact angle", "less than 90°");
    let soft = Material { youngs_modulus: 0.0, ..Material::STEEL };
    rejected(row(BallGeometry { rings: soft, ..base }), "Young's modulus", "positive");
    let odd = Material { poissons_ratio: 0.6, ..Material::STEEL };
    rejected(row(BallGeometry { balls: odd, ..angular_contact() }), "Poisson's ratio", "at most 0.5");
    assert!(row(kind(BallKind::DeepGroove { clearance: -10e-6 })).is_ok());
}

#[test]
fn impossible_rollers() {
    let row = RollerRow::new;
    rejected(row(RollerGeometry { count: 18, ..cylindrical() }), "do not fit", "at most 17");
    rejected(row(RollerGeometry { length: 0.0, ..cylindrical() }), "roller length", "positive");
    rejected(row(RollerGeometry { length: 1e-4, ..cylindrical() }), "are discs", "at least 1.1000 mm");
    rejected(row(RollerGeometry { laminae: 1, ..cylindrical() }), "laminae", "at least 30");
    let widths = |raceway_widths| RollerGeometry { raceway_widths, ..cylindrical() };
    rejected(
        row(widths([Some(9e-3), None])),
        "inner raceway has a width of 9.0000 mm",
        "at least 10.0000 mm",
    );
    rejected(
        row(widths([None, Some(9.9e-3)])),
        "outer raceway has a width of 9.9000 mm",
        "at least 10.0000 mm",
    );
    rejected(row(widths([None, Some(f64::NAN)])), "width of the outer raceway", "positive");
    rejected(row(widths([Some(-1.0), None])), "width of the inner raceway", "positive");
    assert!(row(widths([Some(10e-3), Some(1.0)])).is_ok());
    let kind = |kind| RollerGeometry { kind, ..cylindrical() };
    rejected(row(kind(RollerKind::Cylindrical { clearance: -0.3e-3 })), "would indent", "at most");
    rejected(row(kind(RollerKind::Cylindrical { clearance: f64::NAN })), "must be finite", "clearance");
    let rib = Rib { end_radius: 0.12, height: 3.2e-3 };
    let cone =
        |outer_angle, rib| RollerGeometry { kind: RollerKind::Tapered { outer_angle, rib }, ..tapered() };
    rejected(row(cone(0.0, rib)), "contact angle", "more than 0°");
    rejected(row(cone(0.25, Rib { height: 6e-3, ..rib })), "outside the end", "height");
    rejected(
        row(cone(0.25, Rib { end_radius: 4e-3, ..rib })),
        "less than that of the roller",
        "larger radius",
    );
    let long = RollerGeometry { length: 0.5, ..tapered() };
    rejected(row(long), "beyond the apex", "reduce the roller length");
    let points = vec![[0.0, 0.0], [1e-3, 1e-6]];
    let short = RollerGeometry { profile: Profile::Table { points }, ..cylindrical() };
    rejected(row(short), "table of the roller profile", "pairs of position");
    let RollerKind::Spherical { angle, inner_osculation, clearance, .. } = spherical().kind else {
        panic!("spherical")
    };
    let outer_osculation = 1.0;
    let kind = RollerKind::Spherical { angle, outer_osculation, inner_osculation, clearance };
    rejected(row(RollerGeometry { kind, ..spherical() }), "outer osculation", "between 0.5 and 1");
}

#[test]
fn impossible_bearings() {
    rejected(RollingBearing::new(Vec::new()), "no row", "at least one row");
    let bearing = crate::sample::balls(deep_groove());
    let at = [f64::NAN, 0.0, 0.0, 0.0, 0.0];
    rejected(bearing.evaluate(&at, &Motion::REST, &mut Start::default()), "displacement", "finite");
    let motion = Motion { inner_speed: f64::INFINITY, ..Motion::REST };
    rejected(bearing.evaluate(&[0.0; 5], &motion, &mut Start::default()), "speed", "finite");
}
