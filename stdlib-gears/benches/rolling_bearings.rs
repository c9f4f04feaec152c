//! Time of a position of a helical pair on rolling bearings, as a ratio to the time of the same
//! pair on springs in the same run.
//!
//! `cargo bench -p calyx-gears --bench rolling_bearings`

#[path = "../tests/common/mod.rs"]
mod common;
#[path = "../tests/solid/pairs.rs"]
#[expect(dead_code, reason = "the tests use the rest")]
mod pairs;

use calyx_gears::helix::Hand;
use calyx_runtime::bearing::{Bearing, NonlinearLoad, RollingElements};
use calyx_runtime::rolling::{BallKind, Elements, Motion, RollingBearing, Row};
use calyx_runtime::scene::{Component, Fidelity, StructureOptions};
use common::built;
use common::rolling::{balls, tapered};
use pairs::{FIRST, Options};
use std::hint::black_box;
use std::sync::Arc;
use std::time::Instant;

const FREE: [Component; 5] =
    [Component::Ux, Component::Uy, Component::Uz, Component::ThetaX, Component::ThetaY];

/// Least time of a position over a mesh cycle, s.
fn position(elements: &Elements, springs: bool) -> f64 {
    let options = Options { free: FREE.to_vec(), backed: false, ..Options::helical(0.35, Hand::Right) };
    let (mut scene, mesh) = options.scene();
    for (name, at, mirrored) in [("near", 0.03, false), ("far", 0.075, true)] {
        let row = Row { mirrored, ..Row::new(elements.clone()) };
        let rows = RollingBearing::new(vec![row]).expect("valid");
        let elements = RollingElements::new(rows, Motion::REST).expect("valid");
        let typical = *elements.typical_stiffness();
        let bearing = match springs {
            true => Bearing::new(name, FIRST, at, typical),
            false => Bearing {
                nonlinear: Some(NonlinearLoad::Rolling(Arc::new(elements))),
                ..Bearing::new(name, FIRST, at, [[0.0; 6]; 6])
            },
        };
        scene.add_bearing(bearing).expect("a bearing");
    }
    let system = built(&scene, Fidelity::Analytic, StructureOptions::default());
    let mut best = f64::INFINITY;
    for k in 0..12 {
        let start = Instant::now();
        black_box(system.solve(mesh.start + f64::from(k) / 12.0 * mesh.period).expect("solved"));
        best = best.min(start.elapsed().as_secs_f64());
    }
    best
}

fn main() {
    println!("helical pair on {:>28} {:>16} {:>8}", "bearings", "ms per position", "ratio");
    for (name, elements) in [
        ("9 balls", balls(BallKind::DeepGroove { clearance: 12e-6 })),
        ("18 tapered rollers, 31 laminae", tapered(31)),
        ("18 tapered rollers, 101 laminae", tapered(101)),
    ] {
        let [springs, rolling] = [true, false].map(|springs| position(&elements, springs));
        println!("{name:>44} {:>16.2} {:>8.2}", 1e3 * rolling, rolling / springs);
    }
}
