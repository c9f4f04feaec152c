//! Rows of rolling elements for tests and benchmarks.

use calyx_runtime::rolling::{
    BallGeometry, BallKind, BallRow, Elements, Material, Profile, Rib, RollerGeometry, RollerKind, RollerRow,
};

/// Balls of 6208.
pub fn balls(kind: BallKind) -> Elements {
    let geometry = BallGeometry {
        kind,
        count: 9,
        ball_diameter: 11.906e-3,
        pitch_diameter: 60e-3,
        inner_conformity: 0.52,
        outer_conformity: 0.52,
        rings: Material::STEEL,
        balls: Material::STEEL,
    };
    BallRow::new(geometry).expect("valid").into()
}

pub fn tapered(laminae: usize) -> Elements {
    let geometry = RollerGeometry {
        kind: RollerKind::Tapered { outer_angle: 0.244, rib: Rib { end_radius: 0.12, height: 3.2e-3 } },
        count: 18,
        roller_diameter: 10e-3,
        length: 13e-3,
        raceway_widths: [None; 2],
        pitch_diameter: 60e-3,
        profile: Profile::Logarithmic,
        laminae,
        rings: Material::STEEL,
        rollers: Material::STEEL,
    };
    RollerRow::new(geometry).expect("valid").into()
}
