//! Compares the spur pair of the examples, described in Calyx and built in Rust: equal scenes with
//! bitwise equal results.

use calyx::rt::{ParamAssignment, Program, apply};
use calyx::{Interpreted, check_text};
use calyx_abi::{Context, Purity};
use calyx_gears::assembly::{MeshOptions, add_body, mesh};
use calyx_gears::blank::{GearBlank, Rim, Thickness};
use calyx_gears::error::Refusal;
use calyx_gears::host::ModelHost;
use calyx_gears::modification::{Modification, ReliefShape};
use calyx_gears::rack::Rack;
use calyx_runtime::analysis::{AnalysisOptions, mesh_cycle, quasi_static};
use calyx_runtime::load::Wrench;
use calyx_runtime::material::Material;
use calyx_runtime::motion::SteadyRotation;
use calyx_runtime::observables::{
    LoadShare, MaxContactPressure, MaxEdgePressure, MaxRootStress, MeshStiffness, TransmissionError,
};
use calyx_runtime::results::{OutputRequest, StepRow};
use calyx_runtime::scene::{Body, Component, PairId, Scene};
use calyx_tests::root;

/// Number of positions of the cycle, uniformly spaced.
const STEPS: usize = 2;

/// Sizes as computed by the compiler: a unit's factor times a literal.
struct Units {
    inch: f64,
    psi: f64,
    lbf: f64,
    degree: f64,
    rpm: f64,
}

fn units() -> Units {
    let factor =
        |name: &str| calyx_lang::units::Unit::find(name).unwrap_or_else(|| panic!("no unit {name}")).factor;
    Units {
        inch: factor("inch"),
        psi: factor("psi"),
        lbf: factor("lbf"),
        degree: factor("deg"),
        rpm: factor("rpm"),
    }
}

/// Builds the scene of `examples/spur_pair.cx` at its defaults.
fn built_in_rust() -> Result<(Scene, PairId), Refusal> {
    let Units { inch, psi, lbf, degree, rpm } = units();
    let steel = Material::new(3e7 * psi, 0.3, 7850.0)?;
    let rack = Rack::new(1.0 / (10.0 / inch), 20.0 * degree, 0.020 * inch)?;
    let gear = |teeth, [outer, root]: [f64; 2], rim: [f64; 2], relief_from: f64| {
        GearBlank::standard(teeth, rack)
            .diameters(outer * inch, root * inch)
            .thickness(Thickness::Circular(0.15708 * inch))
            .face_width(1.0 * inch)
            .material(steel)
            .rim(Rim::new(rim[0] * inch, rim[1] * inch)?)
            .modified(Modification::tip_relief(0.0005 * inch, relief_from * degree, ReliefShape::Quadratic))
            .modified(Modification::lead_crown(0.0005 * inch)?)
            .cut()
    };
    let pinion = gear(20, [2.18, 1.76], [1.40, 1.20], 27.25)?;
    let wheel = gear(40, [4.18, 3.78], [3.40, 2.40], 19.60)?;
    let speed = 3.0 * rpm;
    let mut scene = Scene::default();
    let turning = |x: f64, speed: f64| SteadyRotation { origin: [x, 0.0], start: 0.0, speed };
    let torque = Wrench::of_moment([0.0, 0.0, 1000.0 * (lbf * inch)]);
    let pinion =
        Body::new("pinion", pinion, turning(0.0, speed)).free_in(&[Component::ThetaZ]).loaded(torque);
    let pinion = add_body(&mut scene, pinion)?;
    let wheel = add_body(&mut scene, Body::new("gear", wheel, turning(3.0 * inch, -speed * 20.0 / 40.0)))?;
    let meshed = mesh(&mut scene, pinion, wheel, &MeshOptions::default())?;
    scene.add_observable(TransmissionError(meshed.pair));
    scene.add_observable(LoadShare(meshed.pair));
    scene.add_observable(MeshStiffness(meshed.pair));
    scene.add_observable(MaxContactPressure(meshed.pair));
    scene.add_observable(MaxEdgePressure(meshed.pair));
    scene.add_observable(MaxRootStress(pinion));
    scene.add_observable(MaxRootStress(wheel));
    Ok((scene, meshed.pair))
}

/// Runs the example in the interpreter; returns its context.
fn described_in_calyx() -> Context {
    let path = root().join("examples/spur_pair.cx");
    let text = std::fs::read_to_string(path).unwrap();
    let program = check_text("spur_pair.cx", &text).program.unwrap();
    let interpreted = Interpreted::new(&program, Purity::Effect).unwrap();
    let mut context = Context::new(Box::new(ModelHost::default()));
    context.kernels = interpreted.kernels();
    apply(
        &interpreted,
        &[ParamAssignment::text("steps", STEPS.to_string()), ParamAssignment::text("fidelity", "plane")],
        &mut context,
    )
    .unwrap();
    interpreted.main(&mut context).unwrap();
    context
}

/// Formats values by observable, and the data of each position, with all bits.
fn shown(rows: &[StepRow], outputs: &[&str], names: &[OutputRequest]) -> Vec<String> {
    let at =
        |name: &&str| names.iter().position(|output| output.name == *name).expect("an output of this name");
    let columns: Vec<usize> = outputs.iter().map(at).collect();
    let row = |row: &StepRow| {
        let values: Vec<_> = columns.iter().map(|&column| &row.outputs[column]).collect();
        format!("{:?} {values:?} {:?}", row.position, row.warnings)
    };
    rows.iter().map(row).collect()
}

const OUTPUTS: [&str; 7] = [
    "transmission_error",
    "load_share",
    "mesh_stiffness",
    "max_contact_pressure",
    "max_edge_pressure",
    "max_root_stress_pinion",
    "max_root_stress_gear",
];

#[test]
fn a_pair_built_in_rust_is_the_pair_that_the_language_builds() {
    let (scene, pair) = built_in_rust().unwrap_or_else(|refusal| panic!("{refusal}"));
    let outputs: Vec<OutputRequest> = (0..)
        .zip(OUTPUTS)
        .map(|(index, name)| OutputRequest::observing(name, calyx_runtime::scene::ObservableId(index)))
        .collect();
    let positions = mesh_cycle(scene.pairs[pair.0].mesh.as_ref().unwrap(), STEPS);
    let result = quasi_static(&scene, &positions, &outputs, &AnalysisOptions::default(), &mut ()).unwrap();

    let mut context = described_in_calyx();
    let host = context.host::<ModelHost>().unwrap();
    let described = host.result.as_ref().unwrap();
    assert_eq!(scene.pairs[0].mesh, host.scene.pairs[0].mesh);
    assert_eq!(scene.bodies[1].phase, host.scene.bodies[1].phase);
    assert_eq!(shown(&result.rows, &OUTPUTS, &outputs), shown(&described.rows, &OUTPUTS, &host.outputs));
}
