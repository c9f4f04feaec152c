//! Tests of models in other programs: many instances, stepwise solution, cancellation, limits,
//! invalid input.

use calyx::rt::directory::Details;
use calyx::rt::{FinishedRun, RunError, RunOptions, run};
use calyx::{
    Cancel, CompileError, Engine, EngineConfig, Error, ErrorKind, Instance, Module, Output, Override, Param,
    ParamAssignment, ParamValue, Progress, Results, Run, Step,
};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, LazyLock, Mutex};
use std::thread;
use std::time::Duration;

fn example() -> PathBuf {
    [env!("CARGO_MANIFEST_DIR"), "../examples/spur_pair.cx"].iter().collect()
}

/// Pair of the report, compiled once; the first test that needs its structures builds them.
static PAIR: LazyLock<Module> = LazyLock::new(|| {
    Module::from_file(&Engine::default(), example()).unwrap_or_else(|error| panic!("{error}"))
});

fn pair() -> Instance {
    let mut pair = PAIR.instantiate();
    pair.set("steps", 2).unwrap();
    pair.set("fidelity", "plane").unwrap();
    pair
}

fn module(text: &str) -> Module {
    Module::from_text(&Engine::default(), "model.cx", text).unwrap_or_else(|error| panic!("{error}"))
}

/// Returns the bits of every output at every position.
fn bits(steps: impl Iterator<Item = Step>) -> Vec<u64> {
    let numbers = |step: Step| -> Vec<u64> {
        let outputs = step.outputs().iter().map(|output| output.value);
        outputs.chain([step.position().time]).map(f64::to_bits).collect()
    };
    steps.flat_map(numbers).collect()
}

#[test]
fn what_may_cross_threads_does() {
    fn sent<T: Send + 'static>() {}
    fn shared<T: Send + Sync + Clone + 'static>() {}
    sent::<Instance>();
    sent::<Run>();
    sent::<Results>();
    sent::<Error>();
    shared::<Engine>();
    shared::<Module>();
    shared::<Step>();
    shared::<Cancel>();
    shared::<Param>();
    shared::<Output>();
}

#[test]
fn fifty_instances_at_once_give_the_bits_of_one_after_another() {
    let torque = PAIR.param("torque").unwrap();
    let solve = |number: usize| {
        let mut pair = pair();
        pair.set(torque, 100.0 + 50.0 * number as f64).unwrap();
        bits(pair.solve().unwrap().steps())
    };
    let serial: Vec<_> = (0..50).map(solve).collect();
    assert!(serial.windows(2).all(|two| two[0] != two[1]), "torque changes the outputs");
    let at_once: Vec<_> = thread::scope(|scope| {
        let threads: Vec<_> = (0..50).map(|number| scope.spawn(move || solve(number))).collect();
        threads.into_iter().map(|thread| thread.join().unwrap()).collect()
    });
    assert_eq!(serial, at_once);
    // Independent of shared engine data and of the number of threads.
    let alone = Engine::new(EngineConfig { threads: 1, kept: 0, ..EngineConfig::default() });
    let mut instance = Instance::new(&alone, PAIR.as_program());
    instance.set("steps", 2).unwrap();
    instance.set("fidelity", "plane").unwrap();
    instance.set_si(torque, number_of(&pair(), "torque")).unwrap();
    assert_eq!(bits(instance.solve().unwrap().steps()), bits(pair().solve().unwrap().steps()));
    assert_eq!(alone.kept().structures, 0);
}

fn number_of(instance: &Instance, param: &str) -> f64 {
    match instance.get(param).unwrap() {
        ParamValue::Number(si) => si,
        other => panic!("{other:?}"),
    }
}

#[test]
fn stepping_solving_and_the_run_directory_are_one() {
    let pair = pair();
    let solved = pair.solve().unwrap();
    let mut stepping = pair.run().unwrap();
    let steps: Vec<Step> = (&mut stepping).map(|step| step.unwrap()).collect();
    assert!(stepping.next().is_none());
    let finished = stepping.finish().unwrap();
    assert!(steps.len() > 4 && steps.iter().all(|step| step.count() == steps.len()));
    let expected = bits(steps.iter().cloned());
    assert_eq!(expected, bits(solved.steps()));
    assert_eq!(expected, bits(finished.steps()));
    assert_eq!(finished.analysis().unwrap().summaries, solved.analysis().unwrap().summaries);
    // A run that is finished after a few positions returns all of them.
    let mut few = pair.run().unwrap();
    assert_eq!((few.next().unwrap().unwrap().index(), few.next().unwrap().unwrap().index()), (0, 1));
    assert_eq!(bits(few.finish().unwrap().steps()), expected);

    let directory = tempfile::tempdir().unwrap();
    let given = vec![ParamAssignment::text("steps", "2"), ParamAssignment::text("fidelity", "plane")];
    let options =
        RunOptions { directory: directory.path().into(), given, quiet: true, ..RunOptions::default() };
    run(PAIR.as_program(), &options).unwrap();
    let table = std::fs::read_to_string(directory.path().join("steps.csv")).unwrap();
    let written: Vec<Vec<&str>> = table.lines().skip(1).map(|line| line.split(',').collect()).collect();
    assert_eq!(written.len(), steps.len());
    for (line, step) in written.iter().zip(&steps) {
        let outputs: Vec<String> = step.outputs().iter().map(|output| output.value.to_string()).collect();
        assert_eq!(line[5..], outputs);
    }
}

/// Returns the files of a directory that have no durations.
fn saved_files(directory: &Path) -> BTreeMap<String, Vec<u8>> {
    let timed = ["timing.json", "report.html", ".calyx-run"];
    let files = std::fs::read_dir(directory).unwrap().map(|entry| entry.unwrap().path());
    let read = |path: PathBuf| {
        (path.file_name().unwrap().to_string_lossy().into_owned(), std::fs::read(&path).unwrap())
    };
    files.filter(|path| path.is_file()).map(read).filter(|(name, _)| !timed.contains(&&**name)).collect()
}

#[test]
fn a_run_in_memory_is_saved_as_the_runner_writes_it() {
    let written = tempfile::tempdir().unwrap();
    let given = ["steps=2", "fidelity=plane"].map(|text| ParamAssignment::name_and_value(text).unwrap());
    let options = RunOptions {
        directory: written.path().into(),
        given: given.into(),
        quiet: true,
        ..RunOptions::default()
    };
    run(PAIR.as_program(), &options).unwrap();

    for with_fields in [true, false] {
        let mut pair = pair();
        if with_fields {
            pair.request_fields(Details::default().positions());
            pair.request_parts(true);
        }
        let positions = Arc::new(Mutex::new(Vec::new()));
        let kept = positions.clone();
        pair.on_solved(move |_, solved, fields| {
            kept.lock().unwrap().push((solved.clone(), fields.cloned()));
            Ok(())
        });
        let results = pair.solve().unwrap();
        let finished = FinishedRun {
            results: &results,
            overrides: Override::default(),
            positions: &positions.lock().unwrap(),
            details: Details::default(),
            before: Vec::new(),
        };
        let saved = tempfile::tempdir().unwrap();
        finished.save(saved.path(), false).unwrap();
        let mut expected = saved_files(written.path());
        if !with_fields {
            expected.retain(|name, _| ["run.json", "steps.csv"].contains(&&**name));
        }
        assert!(expected.len() > 1 && saved_files(saved.path()) == expected);
        assert_eq!(saved.path().join("view").exists(), with_fields);

        // A saved run is replaced; files of the user are not.
        finished.save(saved.path(), false).unwrap();
        let users = tempfile::tempdir().unwrap();
        std::fs::write(users.path().join("run.json"), "mine").unwrap();
        assert!(matches!(finished.save(users.path(), false), Err(RunError::Directory(_))));
        assert_eq!(std::fs::read(users.path().join("run.json")).unwrap(), b"mine");
    }
}

#[test]
fn results_come_in_the_units_one_asks_for() {
    let results = pair().solve().unwrap();
    let error = results.output("transmission_error_length").unwrap();
    let (si, shown) = (results.summary_si(error).unwrap(), results.summary(error).unwrap());
    let inch = results.summary_in(error, "inch").unwrap();
    assert!(si.max > 0.0);
    assert_eq!((inch.max, inch.peak_to_peak), (si.max / 0.0254, si.peak_to_peak / 0.0254));
    // A transmission error along the line of action is shown in microinches.
    assert_eq!(shown, results.summary_in(error, "microinch").unwrap());
    let step = results.steps().next().unwrap();
    assert_eq!(step.in_unit(error, "um").unwrap(), step.si(error).unwrap() * 1e6);
    assert_eq!(step.value("transmission_error_length").unwrap(), step.in_unit(error, "microinch").unwrap());
    assert!(results.certificate().unwrap().equilibrium < 1e-6);
    assert!(results.plan().is_some() && results.timing().is_some());
    // Names and units that do not match an output of this model.
    let other = module("output twice := 2*Time; print(1);");
    let foreign = other.output("twice").unwrap();
    for (refused, says) in [
        (step.value("transmission_eror").map(|_| ()), "did you mean `transmission_error`"),
        (step.in_unit(error, "N").map(|_| ()), "`transmission_error_length` cannot be shown in `N`"),
        (step.in_unit(error, "furlong").map(|_| ()), "no unit called `furlong`"),
        (step.si(foreign).map(|_| ()), "another model"),
        (results.summary(foreign).map(|_| ()), "another model"),
    ] {
        let error = refused.unwrap_err();
        assert_eq!(error.kind(), ErrorKind::InvalidInput);
        assert!(error.to_string().contains(says), "{error}");
    }
}

/// Runs are ended after any number of positions, from another thread or by dropping the run; later
/// runs of the instance are unaffected.
#[test]
fn a_run_ends_between_any_two_positions() {
    let mut pair = pair();
    let whole = bits(pair.solve().unwrap().steps());
    let count = pair.run().unwrap().next().unwrap().unwrap().count();
    // After the last position a run cannot be cancelled.
    for taken in 0..count - 1 {
        let mut run = pair.run().unwrap();
        let before = run.by_ref().take(taken).filter(Result::is_ok).count();
        assert_eq!(before, taken);
        let cancel = pair.cancel_handle();
        thread::spawn(move || cancel.cancel()).join().unwrap();
        // One position may already be waiting.
        let ended = run.by_ref().find_map(Result::err).expect("it was cancelled");
        assert_eq!((ended.kind(), ended.code()), (ErrorKind::Cancelled, Some("E0704")));
        assert!(run.next().is_none());
        assert_eq!(run.finish().err(), Some(ended));
        // The cancellation flag of an instance remains set.
        assert_eq!(pair.solve().err().map(|error| error.kind()), Some(ErrorKind::Cancelled));
        pair.set_cancel(Cancel::default());
        let mut dropped = pair.run().unwrap();
        assert_eq!(dropped.by_ref().take(taken).count(), taken);
        drop(dropped);
        // The cancellation handle of a run ends this run only.
        let (mut one, mut other) = (pair.run().unwrap(), pair.run().unwrap());
        one.cancel_handle().cancel();
        assert!(one.find_map(Result::err).is_some());
        assert!(other.next().is_some_and(|step| step.is_ok()));
    }
    assert_eq!(bits(pair.solve().unwrap().steps()), whole);
}

/// A program that does not end is cancelled, even if no position is requested.
#[test]
fn what_does_not_end_is_ended() {
    let endless = module("while (TRUE) { }");
    let mut instance = endless.instantiate();
    drop(instance.run().unwrap());
    instance.limit_time(Some(Duration::from_millis(20)));
    let error = instance.solve().err().unwrap();
    assert_eq!((error.kind(), error.code()), (ErrorKind::Limit, Some("E0707")));
    assert!(error.message().contains("0.02 s"), "{error}");
    instance.limit_time(None);
    let cancel = instance.cancel_handle();
    let cancelled = thread::scope(|scope| {
        let solving = scope.spawn(|| instance.solve().err().map(|error| error.kind()));
        cancel.cancel();
        solving.join().unwrap()
    });
    assert_eq!(cancelled, Some(ErrorKind::Cancelled));

    let hungry = module("var all = \"x\"; while (TRUE) { all = \"{all}{all}\"; }");
    let mut instance = hungry.instantiate();
    instance.limit_memory(Some(1_000_000));
    assert_eq!(instance.solve().err().map(|error| error.kind()), Some(ErrorKind::Limit));

    // Limits apply to the analysis too.
    let mut pair = pair();
    pair.limit_memory(Some(1_000));
    let error = pair.solve().err().unwrap();
    assert!(error.kind() == ErrorKind::Limit && error.message().contains("1 kB"), "{error}");
    pair.limit_memory(None);
    pair.limit_time(Some(Duration::ZERO));
    assert_eq!(pair.run().unwrap().next().unwrap().err().map(|error| error.kind()), Some(ErrorKind::Limit));
}

#[test]
fn params_take_what_fits_them() {
    let model = "units mm_N_s;
        param length = 3 mm in 1 mm .. 4 mm; param twice = 2*length in length .. 0.01 m;
        param count = 5 in 1 .. 9; param long = FALSE; param label = \"a\" in [\"a\", \"b\"]; param any = \"x\";
        print(\"{length} {twice} {count} {long} {label} {any}\");";
    let model = module(model);
    let mut instance = model.instantiate();
    let lines = Arc::new(Mutex::new(Vec::new()));
    let sink = lines.clone();
    instance.on_print(move |line| sink.lock().unwrap().push(line.to_owned()));
    let printed = |instance: &Instance| {
        instance.solve().unwrap();
        lines.lock().unwrap().pop().unwrap()
    };
    assert_eq!(printed(&instance), "3 mm 6 mm 5 FALSE a x");
    instance.set("length", 2.0).unwrap();
    assert_eq!(number_of(&instance, "twice"), 0.004);
    assert_eq!(printed(&instance), "2 mm 4 mm 5 FALSE a x");
    instance.set("length", (0.1, "inch")).unwrap();
    assert_eq!(number_of(&instance, "length"), 0.1 * 0.0254);
    instance.set(model.param("length").unwrap(), "0.25 cm").unwrap();
    instance.set_si("twice", 0.009).unwrap();
    instance.set("count", 7).unwrap();
    instance.set("long", true).unwrap();
    instance.set("label", "b").unwrap();
    assert_eq!(printed(&instance), "2.5 mm 9 mm 7 TRUE b x");
    // A value of one instance can be set in another.
    let mut copy = model.instantiate();
    for (param, value) in model.description().params.iter().zip(instance.params().unwrap()) {
        copy.set(&param.name, value).unwrap();
    }
    assert_eq!(copy.params().unwrap(), instance.params().unwrap());
    instance.reset("twice").unwrap();
    assert_eq!(instance.get("twice").unwrap(), ParamValue::Number(2.0 * 0.0025));

    let foreign = PAIR.param("torque").unwrap();
    let refuse = |refused: Result<(), Error>, says: &[&str]| {
        let error = refused.unwrap_err();
        assert_eq!((error.kind(), error.code()), (ErrorKind::InvalidInput, None));
        for part in says {
            assert!(error.to_string().contains(part), "`{part}` is not in: {error}");
        }
    };
    refuse(instance.set("lenght", 2.0), &["no param called `lenght`", "did you mean `length`"]);
    refuse(instance.set(foreign, 2.0), &["another model", "model.cx"]);
    refuse(instance.set("length", (2.0, "N")), &["`length`", "`2 N`", "mm"]);
    refuse(instance.set("length", (2.0, "furlong")), &["no unit called `furlong`"]);
    refuse(instance.set("length", "2 N"), &["`length`", "`2 N`"]);
    refuse(instance.set("length", 5.0), &["`length` = 5 mm is outside its range, 1 mm .. 4 mm"]);
    refuse(instance.set_si("length", 0.0), &["`length` = 0 mm", "1 mm .. 4 mm"]);
    refuse(instance.set("length", f64::NAN), &["`length` = NaN mm"]);
    refuse(instance.set("length", true), &["`length` cannot be `true`: it is a number"]);
    refuse(instance.set("count", 2.5), &["`count` cannot be `2.5`: it must be a whole number"]);
    refuse(instance.set("long", 1), &["`long` cannot be `1`", "TRUE or FALSE"]);
    refuse(instance.set("label", "c"), &["`label` cannot be \"c\"", "\"a\" or \"b\""]);
    refuse(instance.set("any", 3), &["`any` cannot be `3`: it is a text"]);
    refuse(instance.get("x").map(|_| ()), &["no param called `x`"]);
    // A range that depends on another param is checked when that param is known.
    instance.set("twice", 1.0).unwrap();
    refuse(instance.solve().map(|_| ()), &["`twice` = 1 m is outside its range, 0.0025 m .. 0.01 m"]);
    assert_eq!(
        instance.run().unwrap().next().unwrap().err().map(|error| error.kind()),
        Some(ErrorKind::InvalidInput)
    );
    // A rejected value changes nothing.
    assert_eq!(instance.get("length").unwrap(), ParamValue::Number(0.0025));
}

#[test]
fn errors_are_data() {
    let engine = Engine::default();
    let broken = Module::from_text(&engine, "broken.cx", "var a = 1 mm + 1 s;\nprint(b);\n").err().unwrap();
    let CompileError::Model(diagnostics) = &broken else { panic!("{broken}") };
    let codes: Vec<&str> = diagnostics.list.iter().map(|diagnostic| diagnostic.code.as_str()).collect();
    assert!(["E0401", "E0201"].iter().all(|code| codes.contains(code)), "{codes:?}");
    assert!(broken.to_string().contains("broken.cx:1:"), "{broken}");
    let missing = Module::from_file(&engine, "no/such/model.cx").err().unwrap();
    assert!(
        matches!(missing, CompileError::Unreadable { .. })
            && missing.to_string().contains("no/such/model.cx")
    );

    let text = "param n = 2 in 0 .. 10;\nfunction third(in values, in n) { return values[n]; }\nprint(third([1, 2, 3], n));\n";
    let model = module(text);
    let mut instance = model.instantiate();
    assert!(instance.solve().is_ok());
    instance.set("n", 7).unwrap();
    let error = instance.solve().err().unwrap();
    assert_eq!((error.kind(), error.code()), (ErrorKind::Model, Some("E0701")));
    let Error::Model(failed) = &error else { panic!("{error:?}") };
    let (_, start, end) = failed.place.unwrap();
    assert!(text[start as usize..end as usize].contains('n') && failed.details.calls[0].function == "third");
    let shown = model.render(&error);
    assert!(shown.contains("model.cx:2:") && shown.contains("values[n]"), "{shown}");
    // The instance can run again.
    instance.set("n", 1).unwrap();
    assert!(instance.solve().is_ok());
}

/// The source of a NaN is recorded for each run separately.
#[test]
fn runs_at_once_tell_their_own_causes() {
    let model = module(
        "param x = 1 in -9 .. 9; var angle := sqrt(x)*Time*(1 rad/s); var frame := Rotate(angle, e3);
         var q = origin(frame at Time = 1 s); var n = sqrt(x); assert(n == n, \"not a number\");",
    );
    let said = |x: i32| {
        let mut instance = model.instantiate();
        instance.set("x", x).unwrap();
        instance.solve().map(|_| String::new()).unwrap_or_else(|error| model.render(&error))
    };
    let alone: Vec<String> = (-9..9).map(said).collect();
    let at_once: Vec<String> = thread::scope(|scope| {
        let threads: Vec<_> = (-9..9).map(|x| scope.spawn(move || said(x))).collect();
        threads.into_iter().map(|thread| thread.join().unwrap()).collect()
    });
    assert_eq!(alone, at_once);
    assert!(!alone[0].is_empty() && alone[17].is_empty());
}

#[test]
fn a_run_ends_while_its_structures_are_being_built() {
    // A separate engine: the cache of another may contain the structures.
    let engine = Engine::default();
    let mut pair = Module::from_file(&engine, example()).unwrap().instantiate();
    let cancel = pair.cancel_handle();
    pair.on_progress(move |Progress { stage, .. }| {
        assert_ne!(stage, "positions");
        if stage == "structures" {
            cancel.cancel();
        }
    });
    assert_eq!(pair.solve().err().map(|error| error.kind()), Some(ErrorKind::Cancelled));
    assert_eq!(engine.kept().structures, 0);
}

#[test]
fn progress_is_told_and_may_end_the_run() {
    let mut pair = pair();
    let reported = Arc::new(Mutex::new(Vec::new()));
    let sink = reported.clone();
    pair.on_progress(move |progress| sink.lock().unwrap().push(progress));
    let count = pair.solve().unwrap().steps().len();
    let reported = std::mem::take(&mut *reported.lock().unwrap());
    let stages: Vec<&str> = reported.iter().filter(|p| p.total.is_none()).map(|p| p.stage).collect();
    assert_eq!(stages, ["structures", "positions", "errors"]);
    let done: Vec<usize> = reported.iter().filter(|p| p.total == Some(count)).map(|p| p.done).collect();
    assert_eq!(done, (1..=count).collect::<Vec<_>>());
    let cancel = pair.cancel_handle();
    pair.on_progress(move |Progress { done, .. }| {
        if done == 2 {
            // Following positions are solved meanwhile. They are not reported.
            thread::sleep(Duration::from_millis(100));
            cancel.cancel();
        }
    });
    let mut run = pair.run().unwrap();
    let ended = run.by_ref().map_while(Result::ok).count();
    assert_eq!(ended, 2);
    assert_eq!(run.finish().err().map(|error| error.kind()), Some(ErrorKind::Cancelled));
}

/// A cancelled search returns its best results and reports the missed tolerance.
#[test]
fn a_cancelled_search_for_a_tolerance_has_results() {
    let text = std::fs::read_to_string(example()).unwrap();
    let searched = text.replace("fidelity = fidelity", "fidelity = \"rigid\", tolerance = 0.01 %");
    assert_ne!(searched, text);
    let mut pair = module(&searched).instantiate();
    pair.set("steps", 4).unwrap();
    let cancel = pair.cancel_handle();
    pair.on_choosing(move |choosing| {
        if choosing.best.is_some() {
            cancel.cancel();
        }
    });
    let results = pair.solve().expect("what was found is kept");
    let outcome = results.analysis().unwrap().tolerance_search.as_ref().unwrap();
    assert_eq!(outcome.ended.as_deref(), Some("the run was cancelled"));
    assert!(results.summary("transmission_error").unwrap().max.is_finite());
    let codes: Vec<&str> = results.findings().iter().map(|finding| finding.error.code.as_ref()).collect();
    assert!(codes.contains(&"E0793"), "{codes:?}");
}

/// A panic in a callback is an error of the run.
#[test]
fn panics_end_the_run_that_they_are_in() {
    let model = module("print(\"here\");");
    let mut instance = model.instantiate();
    instance.on_print(|line| panic!("no room for {line}"));
    for error in [instance.solve().err(), instance.run().unwrap().finish().err()] {
        let error = error.unwrap();
        assert_eq!(error.kind(), ErrorKind::Internal);
        assert!(error.message().contains("no room for here"), "{error}");
    }
    instance.on_print(|_| {});
    assert!(instance.solve().is_ok());
}

#[test]
fn a_model_without_an_analysis_has_one_step() {
    let engine = Engine::default();
    let text = "param d = 20 mm; output area := pi * d^2 / 4; output twice := 2 * area;";
    let mut instance = Module::from_text(&engine, "m.cx", text).unwrap().instantiate();
    instance.set("d", 0.01).unwrap();
    let mut run = instance.run().unwrap();
    let steps: Vec<_> = run.by_ref().collect::<Result<_, _>>().unwrap();
    let results = run.finish().unwrap();
    assert!(results.analysis().is_none());
    let [step] = steps.as_slice() else { panic!("{} steps", steps.len()) };
    let area = step.si("area").unwrap();
    assert_eq!((step.count(), step.position().time, step.si("twice").unwrap()), (1, 0.0, 2.0 * area));
    assert_eq!((results.steps().len(), results.summary_si("area").unwrap().mean), (1, area));
}

#[test]
fn instances_outlive_what_they_came_from() {
    let instance = {
        let engine = Engine::default();
        let module =
            Module::from_text(&engine, "m.cx", "param n = 3; var x := n*Time/(1 s); assert(n == 3);")
                .unwrap();
        module.instantiate()
    };
    let run = instance.run().unwrap();
    drop(instance);
    let results = run.finish().unwrap();
    assert_eq!(results.description().name, "m.cx");
    assert!(results.steps().len() == 0 && results.analysis().is_none());
}
