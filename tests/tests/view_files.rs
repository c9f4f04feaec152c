//! Checks the files of the viewer against the scene and the solution: the shapes of gears have the
//! volume of the gears, contacts lie on both gears, pressures and forces are in equilibrium, and
//! meshes have the displacements and stresses of the VTU files.

use calyx::rt::view::array_file::ArrayFile;
use calyx::rt::view::content;
use calyx::{Engine, Module, check_text};
use calyx_rt::Instance;
use calyx_runtime::observables::{Fields, PartOf};
use calyx_runtime::scene::Scene;
use serde_json::Value;
use std::sync::{Arc, Mutex};

type Vector = [f64; 3];

/// Returns the fields of the first position of a model, with the meshes of bodies if requested.
fn fields_of(model: &str, bodies: bool) -> Fields {
    let checked = check_text("model.cx", model);
    assert!(!checked.has_errors(), "{}", checked.render());
    let engine = Engine::default();
    let module = Module::from_checked(&engine, checked).expect("compiled");
    let mut instance = Instance::new(&engine, module.as_program());
    instance.request_fields(1);
    instance.request_parts(true);
    instance.request_bodies(bodies);
    let found = Arc::new(Mutex::new(None));
    let kept = found.clone();
    instance.on_solved(move |_, _, fields| {
        let mut kept = kept.lock().expect("one thread");
        *kept = kept.take().or_else(|| fields.cloned());
        Ok(())
    });
    instance.solve().expect("solved");
    let mut found = found.lock().expect("one thread");
    found.take().expect("fields")
}
