//! Modified flanks on the structure of the plain gear: shallow ones share it and differ little from
//! results on their own mesh.

use crate::common::INCH;
use crate::common::pair::{Member, PairOptions, Scale, Values, chapter_5_member, pair, system_of};
use calyx_gears::deviation::Deviation;
use calyx_gears::modification::{Modification, ReliefShape};
use calyx_gears::prototype::{DEEPEST_SHARED, GearPrototype};
use calyx_runtime::analysis::mesh_cycle;
use calyx_runtime::scene::{Prototype, StructureOptions};

/// Module of the chapter 5 pair, in inches.
const MODULE: f64 = 0.1;

/// The chapter 5 pair with a quadratic tip relief of this depth in modules, over a cycle on the
/// default mesh.
fn over_a_cycle(relief: f64) -> Vec<Values> {
    let gears =
        [20, 40].map(|teeth| chapter_5_member(teeth, relief * MODULE, Scale { length: 1.0, modulus: 1.0 }));
    let (scene, mesh) = pair(&PairOptions { edges: true, ..PairOptions::chapter_5(&gears) });
    let system = system_of(&scene, StructureOptions::default());
    let positions = mesh_cycle(&mesh, 16);
    let step = |time: f64| system.solve(time).expect("equilibrium");
    positions.iter().map(|position| Values::of(&system, &step(position.time))).collect()
}

fn largest(values: &[Values], of: impl Fn(&Values) -> f64) -> f64 {
    values.iter().map(of).fold(f64::NEG_INFINITY, f64::max)
}

#[test]
fn where_the_mesh_begins_to_follow_reliefs_results_hardly_move() {
    let at_limit = |part: f64| over_a_cycle(DEEPEST_SHARED * part);
    let (shared, own) = (at_limit(1.0 - 1e-9), at_limit(1.0 + 1e-9));
    let peak_to_peak = |values: &[Values]| {
        largest(values, |v| v.transmission_error) + largest(values, |v| -v.transmission_error)
    };
    let off = |what: fn(&Values) -> f64| largest(&shared, what) / largest(&own, what) - 1.0;
    let found = [
        ("transmission error", off(|v| v.transmission_error), 3e-4),
        ("its peak to peak", peak_to_peak(&shared) / peak_to_peak(&own) - 1.0, 3e-4),
        ("mesh stiffness", off(|v| v.mesh_stiffness), 1e-3),
        ("contact pressure", off(|v| v.contact_pressure.max(v.edge_pressure)), 1e-3),
        ("root stress of the pinion", off(|v| v.root_stress[0]), 1e-3),
        ("root stress of the gear", off(|v| v.root_stress[1]), 1e-3),
    ];
    for (name, off, tolerance) in found {
        assert!(off.abs() < tolerance, "{name}: {off:+.2e} of {found:?}");
        assert!(off != 0.0, "{name} is the same: the mesh does not follow");
    }
}

fn key(gear: &GearPrototype) -> calyx_runtime::cache::Key {
    gear.key(&StructureOptions::default()).expect("gears have keys")
}

#[test]
fn shallow_modifications_share_a_structure_and_deep_ones_have_their_own() {
    let plain = chapter_5_member(20, 0.0, Scale { length: 1.0, modulus: 1.0 });
    let with = |modification: Modification| {
        let Member { prototype, .. } = &plain;
        let (gear, rim) = (prototype.gear.clone(), prototype.rim.clone());
        let modified = vec![modification];
        GearPrototype::new(gear, modified, prototype.material, rim, prototype.face_width, Vec::new())
            .expect("a gear")
    };
    let relief =
        |depth: f64, start: f64, shape| Modification::tip_relief(depth * MODULE * INCH, start, shape);
    let shallow = [
        relief(0.002, 0.48, ReliefShape::Quadratic),
        relief(0.019, 0.45, ReliefShape::Linear),
        Deviation::new("wave", |roll| 1e-6 * (50.0 * roll).sin()).into(),
    ];
    let keys = shallow.map(|modification| key(&with(modification)));
    assert!(keys.iter().all(|key| *key == keys[0]));
    let deep = [0.021, 0.1].map(|depth| key(&with(relief(depth, 0.48, ReliefShape::Quadratic))));
    let wave = key(&with(Deviation::new("wave", |roll| 6e-5 * (50.0 * roll).sin()).into()));
    let all = [key(&plain.prototype), keys[0], deep[0], deep[1], wave];
    for (i, a) in all.iter().enumerate() {
        assert!(all.iter().skip(i + 1).all(|b| a != b), "{i}");
    }
}
