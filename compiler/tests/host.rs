//! Tests of functions that the embedding program provides, with instances of compiled and of loaded
//! modules.

use calyx::rt::Host;
use calyx::{Engine, Module};
use calyx_runtime::load::Wrench;
use std::sync::{Arc, Mutex};

const MODEL: &str = "units mm_N_s;
/// Friction of the flanks.
host function friction(in sliding: Velocity) -> Number { return 0.05; }
host function names(in count: Number) -> Array(String) { return []; }
param limit = friction(1 m/s) in 0 .. 1;
print(friction(3 m/s), limit, names(2));
assert(friction(0 m/s) < 0.5, \"sticks\");";

fn modules() -> [(&'static str, Module); 2] {
    let engine = Engine::default();
    let compiled = Module::from_text(&engine, "model.cx", MODEL).unwrap();
    let bytes = compiled.serialize().unwrap();
    // SAFETY: this process has just written the bytes.
    let loaded = unsafe { Module::deserialize(&engine, &bytes) }.unwrap();
    [("compiled", compiled), ("loaded", loaded)]
}

/// Returns the lines that a model prints when it runs with this host, or its error.
fn printed(module: &Module, host: &Host) -> Result<Vec<String>, calyx::rt::Error> {
    let mut instance = module.instantiate();
    instance.set_host(host)?;
    let lines = Arc::new(Mutex::new(Vec::new()));
    let sink = lines.clone();
    instance.on_print(move |line| sink.lock().unwrap().push(line.to_owned()));
    instance.solve()?;
    Ok(lines.lock().unwrap().clone())
}

#[test]
fn a_model_calls_what_the_host_provides() {
    let host = Host::new()
        .function("friction", |sliding: f64| 0.1 * sliding)
        .function("names", |count: f64| (0..count as usize).map(|i| format!("n{i}")).collect::<Vec<_>>());
    for (name, module) in modules() {
        let functions = &module.description().host_functions;
        assert_eq!(functions[0].to_string(), "host function friction(in sliding: Velocity) -> Number");
        assert_eq!((functions[0].doc.as_str(), functions.len()), ("Friction of the flanks.", 2));
        assert_eq!(functions[0].parameters[0].unit.name, "mm/s");
        // Without a host, the bodies in the model run. Defaults of params call the host too.
        assert_eq!(printed(&module, &Host::new()).unwrap(), ["0.05 0.05 []"], "{name}");
        assert_eq!(
            printed(&module, &host).unwrap(),
            [format!("{} 0.1 [n0, n1]", calyx_abi::text::number(0.1 * 3.0))],
            "{name}"
        );
    }
}

#[test]
fn what_does_not_fit_is_refused_before_anything_runs() {
    for (_, module) in modules() {
        let refusal = |host: &Host| printed(&module, host).unwrap_err().to_string();
        assert_eq!(
            refusal(&Host::new().function("friction", |a: f64, b: f64| a + b)),
            "`friction` is given as `|f64, f64| -> f64`, and the model declares `host function friction(in sliding: \
             Velocity) -> Number` (give a closure `|f64| -> f64`; numbers are in SI units)"
        );
        assert_eq!(
            refusal(&Host::new().function("fiction", || 1.0)),
            "the model has no host function `fiction` (its host functions are `friction`, `names`)"
        );
    }
}

#[test]
fn errors_of_the_host_are_errors_of_the_model() {
    let fails = Host::new().function("friction", |v: f64| if v > 2.0 { Err("too fast") } else { Ok(0.1) });
    let panics = Host::new().function("friction", |v: f64| if v > 2.0 { panic!("too fast") } else { 0.1 });
    for (_, module) in modules() {
        for host in [&fails, &panics] {
            let error = printed(&module, host).unwrap_err();
            assert_eq!(error.code(), Some("E0725"));
            assert!(error.message().ends_with("too fast"), "{error}");
        }
    }
}

/// One closure serves fifty concurrent instances, each with its own results.
#[test]
fn fifty_instances_share_a_host() {
    let host = Host::new().function("friction", |sliding: f64| sliding / 100.0);
    let (_, module) = &modules()[1];
    std::thread::scope(|scope| {
        for i in 0..50 {
            let host = &host;
            scope.spawn(move || {
                let mut instance = module.instantiate();
                instance.set_host(host).unwrap();
                instance.set("limit", f64::from(i) / 50.0).unwrap();
                instance.solve().unwrap();
                assert_eq!(instance.params().unwrap().len(), 1);
            });
        }
    });
}

/// Returns the outputs of the spur pair of the examples at two uniform positions and the
/// characteristic points, with some of its text replaced.
fn spur_pair(engine: &Engine, replaced: &[(&str, &str)], host: &Host) -> calyx::rt::Results {
    let path =
        [env!("CARGO_MANIFEST_DIR"), "../examples/spur_pair.cx"].iter().collect::<std::path::PathBuf>();
    // Without error estimates, which build structures of their own; the test counts structures.
    let alone = [("    fidelity = fidelity,", "    fidelity = fidelity, error_estimates = \"none\",")];
    let text =
        alone.iter().chain(replaced).fold(std::fs::read_to_string(path).unwrap(), |text, (old, new)| {
            assert!(text.contains(old), "{old}");
            text.replacen(old, new, 1)
        });
    let module = Module::from_text(engine, "spur_pair.cx", &text).unwrap_or_else(|error| panic!("{error}"));
    let mut instance = module.instantiate();
    instance.set("steps", 2).unwrap();
    instance.set("fidelity", "plane").unwrap();
    instance.set_host(host).unwrap();
    instance.solve().unwrap_or_else(|error| panic!("{error}"))
}

fn values(results: &calyx::rt::Results) -> Vec<f64> {
    results
        .steps()
        .flat_map(|step| step.outputs().iter().map(|output| output.value).collect::<Vec<_>>())
        .collect()
}

#[test]
fn loads_and_flanks_of_the_host_are_those_of_the_model() {
    let engine = Engine::default();
    let load = ("moment = torque * e3", "host_load = \"torque\"");
    let relief = (
        "gears.tip_relief(tip_relief, start_roll_angle = pinion_relief_start, shape = \"quadratic\")",
        "gears.host_modification(\"relief\")",
    );
    let torque = 1000.0 * (4.4482216152605 * 0.0254);
    let host = Host::new().load("torque", move |_: f64| Wrench::of_moment([0.0, 0.0, torque])).modification(
        "relief",
        |roll: f64| {
            // 0.0005 inch at the tip circle, at the roll angle of the involute for the base circle
            // of 20 teeth.
            let (start, tip) =
                (27.25_f64.to_radians(), ((1.09 / 20_f64.to_radians().cos()).powi(2) - 1.0).sqrt());
            0.0005 * 0.0254 * ((roll - start) / (tip - start)).max(0.0).powi(2)
        },
    );
    let own = values(&spur_pair(&engine, &[], &Host::new()));
    assert_eq!(values(&spur_pair(&engine, &[load], &host)), own);
    let given = spur_pair(&engine, &[load, relief], &host);
    assert!(given.findings().iter().all(|finding| finding.error.code != "E0681"));
    for (given, own) in values(&given).iter().zip(&own) {
        assert!((given - own).abs() <= 2e-4 * own.abs(), "{given} {own}");
    }
    // All modifications use the structures of the two gears.
    assert_eq!(engine.kept().structures, 2);
    // Without a provider the modification is zero, with a warning.
    let without = spur_pair(&engine, &[relief], &Host::new());
    assert_eq!(without.findings().iter().filter(|finding| finding.error.code == "E0681").count(), 1);
    assert_ne!(values(&without), own);
}
