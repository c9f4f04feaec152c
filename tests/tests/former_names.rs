//! Uses every former name of the Rust crates, which work until version 0.2.

#![allow(deprecated, reason = "the subject of these tests")]

use calyx::{Engine, EngineConfig, Module, Run};
use calyx_gears::assembly::{MeshOptions, add_body, mesh};
use calyx_gears::blank::{GearBlank, Rim};
use calyx_gears::lumped_planetary::LumpedMember;
use calyx_gears::rack::Rack;
use calyx_runtime::motion::SteadyRotation;
use calyx_runtime::observables;
use calyx_runtime::pairs::GridOptions;
use calyx_runtime::plan::Plan;
use calyx_runtime::results::{Attempt, Setting, ToleranceOutcome};
use calyx_runtime::scene::{Body, Fidelity, Scene};
use calyx_runtime::structure::BoreSupport;
use calyx_tests::root;
use std::any::TypeId;
use std::fs;
use std::path::{Path, PathBuf};

fn is_same<A: 'static, B: 'static>() -> bool {
    TypeId::of::<A>() == TypeId::of::<B>()
}

#[test]
fn former_types_are_the_current_ones() {
    assert!(is_same::<calyx::Given, calyx::ParamAssignment>());
    assert!(is_same::<calyx::GivenValue, calyx::AssignedValue>());
    assert!(is_same::<calyx::rt::given::Given, calyx::rt::param_assignment::ParamAssignment>());
    assert!(is_same::<calyx::rt::given::GivenValue, calyx::rt::AssignedValue>());
    assert!(is_same::<calyx::rt::Refused, calyx::rt::InvalidParam>());
    assert!(is_same::<calyx::rt::Seen, calyx::rt::NanLog>());
    assert!(is_same::<calyx::rt::seen::Seen, calyx::rt::nan_log::NanLog>());
    assert!(is_same::<
        calyx::rt::overriding::OverrideArguments,
        calyx::rt::settings_override::OverrideArguments,
    >());
    assert!(is_same::<calyx_runtime::overriding::Override, calyx_runtime::settings_override::Override>());
    assert!(is_same::<calyx_runtime::freedom::Freedom, calyx_runtime::dof::Dof>());
    assert!(is_same::<calyx_runtime::lug_contact::LugContact, calyx_runtime::spline_contact::SplineContact>());
    assert!(is_same::<calyx_runtime::observe::Borne, observables::BearingLoad>());
    assert!(is_same::<calyx_runtime::observe::LugLoad, observables::SplineToothLoad>());
    assert!(is_same::<calyx_runtime::observe::PlaceOf, observables::MaximumLocation>());
    assert!(is_same::<calyx_runtime::observe::KindOfMode, observables::ModeClassification>());
    assert!(is_same::<calyx_runtime::observe::KindShares, observables::ModeEnergyShares>());
    assert!(is_same::<calyx_gears::disc_web::DiscWeb, calyx_gears::web::DiscWeb>());
}

#[test]
fn former_constants_and_functions_are_the_current_ones() {
    assert_eq!(calyx_runtime::freedom::FREEDOMS, calyx_runtime::dof::DOF_NAMES);
    assert_eq!(calyx::ErrorKind::Given, calyx::ErrorKind::InvalidInput);
    let former = calyx_runtime::holding::check as *const ();
    assert_eq!(former, calyx_runtime::restraint_check::check as *const ());
}

#[test]
fn former_methods_of_an_instance_configure_its_run() {
    let engine = Engine::new(EngineConfig::default());
    let module = Module::from_text(&engine, "area.cx", "param side = 2 mm; print(side^2);").expect("a model");
    let mut instance = module.instantiate();
    instance.begin_after(Vec::new());
    instance.tell_fields(3);
    instance.tell_bodies(true);
    let finished = instance.run().and_then(Run::finish);
    assert!(finished.is_ok(), "{:?}", finished.err());
}

#[test]
fn former_fields_and_methods_of_a_scene_return_the_current_values() {
    let rack = Rack::new(2e-3, 20_f64.to_radians(), 0.5e-3).expect("a rack");
    let blank = |teeth| GearBlank::standard(teeth, rack).cut().expect("a gear");
    let mut scene = Scene::default();
    let mut add = |name, teeth, x| {
        let speed = if x > 0.0 { -20.0 / 30.0 } else { 1.0 };
        let motion = SteadyRotation { origin: [x, 0.0], start: 0.0, speed };
        add_body(&mut scene, Body::new(name, blank(teeth), motion)).expect("a body")
    };
    let bodies = [add("pinion", 20, 0.0), add("wheel", 30, 50e-3)];
    let meshed = mesh(&mut scene, bodies[0], bodies[1], &MeshOptions::default()).expect("a mesh");
    let mut pair = scene.pairs[meshed.pair.0].mesh.clone().expect("gears are in mesh");
    pair.phase_offset = 0.25;
    assert_eq!(pair.center_offset(), 0.25);

    let grid = GridOptions { half_cells: Some(7), ..GridOptions::default() };
    assert_eq!((grid.half_cells_in_plane(), grid.half_cells_in_space()), (7, 7));
    let grid = GridOptions::default();
    let current = (grid.plane_half_cells(), grid.solid_half_cells());
    assert_eq!((grid.half_cells_in_plane(), grid.half_cells_in_space()), current);

    let plan = |three_dimensional| Plan {
        fidelity: Fidelity::Plane,
        three_dimensional,
        refused: Vec::new(),
        bodies: Vec::new(),
        bearings: Vec::new(),
        connections: Vec::new(),
        ignored: Vec::new(),
    };
    assert!(plan(true).in_space() && !plan(false).in_space());

    let support = BoreSupport::Means { harmonics: None, degree: 1 };
    assert_eq!(Rim::new(40e-3, 30e-3).expect("a rim").held(support).hold(), support);

    let fixed = [true, false, true];
    let member = LumpedMember {
        mass: 1.0,
        inertia: 1.0,
        radius: 0.1,
        support_stiffness: 0.0,
        torsional_stiffness: 0.0,
        fixed,
    };
    assert_eq!(member.held(), fixed);
}

#[test]
fn former_names_of_results_return_the_current_values() {
    let engine = Engine::new(EngineConfig::default());
    let module = Module::from_file(&engine, root().join("examples/spur_pair.cx")).expect("a model");
    let mut instance = module.instantiate();
    instance.set("steps", 2).expect("in range");
    instance.set("fidelity", "analytic").expect("a fidelity level");
    let mut run = instance.run().expect("a run");
    let step = run.next().expect("a position").expect("a solution");
    let output = "max_contact_pressure";
    assert_eq!(step.place(output).expect("an output"), step.location(output).expect("an output"));
    for observed in step.outputs() {
        assert_eq!(observed.place(), observed.location.as_ref());
    }
    assert!(step.outputs().iter().any(|observed| observed.place().is_some()));
    let results = run.finish().expect("results");
    let analysis = results.analysis().expect("an analysis");
    assert_eq!(analysis.chosen(), analysis.tolerance_search.as_ref());

    let setting = Setting { fidelity: Fidelity::Plane, refinement: 1.0, cells: 1, positions: 1 };
    let attempt = Attempt { setting, whole: true, worst: ("pressure".into(), 0.01) };
    let outcome = ToleranceOutcome {
        tolerance: 0.02,
        setting,
        attempts: vec![attempt],
        selected: 0,
        ended: None,
        excluded_model_error: None,
    };
    assert_eq!((outcome.tried(), outcome.taken()), (&outcome.attempts[..], outcome.selected));
}

/// Every item of the sources that is marked as deprecated occurs in this file.
#[test]
fn every_former_name_is_used_here() {
    let (mut files, mut names) = (Vec::new(), Vec::new());
    for folder in ["compiler/src", "compiler/elaborate/src", "runtime", "stdlib-gears/src"] {
        collect(&root().join(folder), &mut files);
    }
    for file in files {
        let text = fs::read_to_string(&file).expect("a source file");
        for marked in text.split("#[deprecated(").skip(1) {
            let declared = marked.lines().find_map(|line| line.trim_start().strip_prefix("pub "));
            let words = declared.unwrap_or_default().split(|c: char| !c.is_alphanumeric() && c != '_');
            let keywords = ["const", "fn", "mod", "struct", "enum", "trait", "type"];
            let name = words.into_iter().find(|word| !keywords.contains(word)).unwrap_or_default();
            names.push((name.to_owned(), file.clone()));
        }
    }
    assert!(names.len() > 30, "only {} names", names.len());
    let used = include_str!("former_names.rs");
    for (name, file) in names {
        let is_used = used.split(|c: char| !c.is_alphanumeric() && c != '_').any(|word| word == name);
        assert!(is_used, "no test uses `{name}` of {}", file.display());
    }
}

/// Collects the Rust files below a folder.
fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            collect(&path, files);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
}
