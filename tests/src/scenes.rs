//! Scenes of examples.

use crate::root;
use calyx::rt::{ParamAssignment, Program, apply};
use calyx::{Interpreted, check_file};
use calyx_abi::{Context, Purity};
use calyx_gears::host::ModelHost;
use calyx_runtime::scene::Scene;

/// Returns the scene of an example with these params, such as `("pinion_torque", "10 N*m")`.
///
/// # Panics
/// If the example is not a correct model, or the params are not of it.
pub fn scene_of(example: &str, given: &[(&str, &str)]) -> Scene {
    let checked = check_file(&root().join("examples").join(format!("{example}.cx"))).expect("a model");
    let program = checked.program.expect("a correct model");
    let interpreted = Interpreted::new(&program, Purity::Effect).expect("a program");
    let mut context = Context::new(Box::new(ModelHost { checking: true, ..ModelHost::default() }));
    context.kernels = interpreted.kernels();
    let given: Vec<ParamAssignment> =
        given.iter().map(|(name, value)| ParamAssignment::text(*name, *value)).collect();
    apply(&interpreted, &given, &mut context).expect("params of the example");
    interpreted.main(&mut context).expect("a scene");
    context.host::<ModelHost>().expect("the host of models").scene.clone()
}
