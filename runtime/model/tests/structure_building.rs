//! Tests of cached body modes.

use calyx_fe::material::Material;
use calyx_model::disc::{Disc, Facing, Platen};
use calyx_model::fidelity::StructureOptions;
use calyx_model::prototype::Prototype;
use calyx_model::resources::Resources;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use calyx_structure::cache::{OperatorCache, Store};
use calyx_structure::{BodyModes, Chart};
use std::sync::Arc;

const HIGHEST: f64 = 1.2e6;
const DISC: Disc = Disc::new(0.02, 0.01, Material::STEEL);

fn modes(disc: &Disc, highest: f64, resources: &Resources) -> Arc<BodyModes> {
    let options = StructureOptions { refinement: 0.5, ..StructureOptions::default() };
    resources.modes(disc, &options, highest).unwrap().unwrap()
}

fn is_same(one: &BodyModes, other: &BodyModes) -> bool {
    let shapes = |modes: &BodyModes| modes.displacements(Chart { tooth: 0, surface: 1 }, &[0.01, 0.02]);
    one.frequencies == other.frequencies
        && one.coupling == other.coupling
        && one.rigid_mass == other.rigid_mass
        && one.gyroscopic == other.gyroscopic
        && one.centrifugal == other.centrifugal
        && shapes(one) == shapes(other)
}

#[test]
fn modes_are_computed_once_and_stored_on_disk() {
    let directory = tempfile::tempdir().unwrap();
    let with_store = || {
        let store = Store::new(directory.path(), 1 << 30);
        Resources {
            cache: Some(Arc::new(OperatorCache::new(1 << 30).with_store(store))),
            ..Resources::default()
        }
    };
    let found = modes(&DISC, HIGHEST, &Resources::default());
    assert!(found.count() > 4, "{}", found.count());
    let resources = with_store();
    let first = modes(&DISC, HIGHEST, &resources);
    assert!(is_same(&found, &first));
    assert!(Arc::ptr_eq(&first, &modes(&DISC, HIGHEST, &resources)));
    // Another limit of the frequency or another density gives other modes.
    assert!(modes(&DISC, 0.7 * HIGHEST, &resources).count() < first.count());
    let heavy =
        Disc { material: Material { density: 4.0 * Material::STEEL.density, ..Material::STEEL }, ..DISC };
    let heavy = modes(&heavy, 0.5 * HIGHEST, &resources);
    assert!((heavy.frequencies[0] / first.frequencies[0] - 0.5).abs() < 1e-9);
    // Another process reads all modes from the disk; the interrupt would stop a computation.
    let again = with_store();
    let stop = || Interrupt::new(|| Err(EngineError::new("E0704", "stopped", "")));
    let again = Resources { interrupt: stop(), ..again };
    assert!(is_same(&first, &modes(&DISC, HIGHEST, &again)));
}

#[test]
fn a_rigid_body_has_no_component_modes() {
    let platen = Platen::new(0.04, 0.01, Facing::Up);
    let none = Resources::default().modes(&platen, &StructureOptions::default(), HIGHEST).unwrap();
    assert!(none.is_none());
}

/// A free disc has three rigid-body motions in its frame, and no mode contains any of them.
#[test]
fn modes_of_a_free_disc_contain_no_rigid_body_motion() {
    let found = modes(&DISC, HIGHEST, &Resources::default());
    let mass = found.rigid_mass[0][0];
    let expected = std::f64::consts::PI * DISC.radius.powi(2) * Material::STEEL.density;
    assert!((mass / expected - 1.0).abs() < 1e-4, "{mass} {expected}");
    let whole = DISC.inertia();
    assert!((mass * DISC.face_width / whole.mass - 1.0).abs() < 1e-4);
    assert!((found.rigid_mass[2][2] * DISC.face_width / whole.polar() - 1.0).abs() < 1e-4);
    for coupling in &found.coupling {
        assert!(coupling[0].hypot(coupling[1]) < 1e-7 * mass.sqrt());
        assert!(coupling[2].abs() < 1e-7 * mass.sqrt() * DISC.radius);
    }
}
