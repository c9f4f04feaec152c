//! The declared functions of the library: every number has a range, and a call with extreme
//! arguments is refused or works. `CALYX_FUZZ=10` makes 120 calls of each function in place of two,
//! `CALYX_FUZZ_ONLY=mode` only those of functions whose name contains the word.

use crate::library::{NOT_IN_SCENE, Random, functions};
use calyx_elaborate::{Cancel, Interpreted, ModelLoader, Params, check_text, elaborate};
use calyx_gears::library::{MODULES, PRELUDE};
use calyx_lang::check_program;
use calyx_lang::diagnostic::Severity;
use calyx_lang::ir::Program;
use calyx_lang::span::FileId;
use calyx_rt::{Engine, Error, Instance};
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

/// A number without a range would let a program request 10^12 cells. A limit may be open if the
/// default is infinite.
#[test]
fn every_numeric_argument_has_a_range() {
    let (mut checked, mut missing) = (0, Vec::new());
    for function in functions() {
        for parameter in function.parameters.iter().filter(|parameter| parameter.is_number) {
            checked += 1;
            let open = parameter.default.as_deref() == Some("inf");
            let [low, high] = [&parameter.low, &parameter.high].map(Option::is_some);
            if !low || !high && !open {
                missing.push(format!("{}.{}", function.name, parameter.name));
            }
        }
    }
    assert!(missing.is_empty(), "no range: {missing:?}");
    assert!(checked > 200, "only {checked} numbers");
}

/// Errors that functions of the library throw say what to do.
#[test]
fn every_error_that_the_library_throws_has_a_help() {
    let mut thrown = 0;
    for module in [&PRELUDE].into_iter().chain(MODULES) {
        for error in module.text.split("throw Error(").skip(1) {
            let (fields, _) = error.split_once(");").expect("the call ends");
            assert!(fields.contains("help = "), "{}: {fields}", module.file);
            thrown += 1;
        }
    }
    assert!(thrown >= 8, "only {thrown} errors");
}

/// Counts determine the amount of computation and memory.
#[test]
fn no_range_of_a_count_is_too_large_to_be_stored() {
    for function in functions() {
        for parameter in function.parameters.iter().filter(|parameter| parameter.is_count()) {
            let high: f64 =
                parameter.high.as_deref().and_then(|end| end.parse().ok()).unwrap_or(f64::INFINITY);
            assert!(high <= 1e6, "{}.{}", function.name, parameter.name);
        }
    }
}

/// Checks that the samples varied below are valid, with every default written explicitly.
#[test]
fn samples_of_all_functions_are_accepted() {
    let mut wrong = String::new();
    for function in functions().into_iter().filter(|f| !NOT_IN_SCENE.contains(&f.name.as_str())) {
        let given = function.arguments(|parameter| parameter.sample.clone());
        let text = crate::library::model(&function, &given);
        match verdict(&text, false) {
            Verdict::Accepted | Verdict::Solved => {}
            other => wrong += &format!("{}({}): {other:?}\n", function.name, given.join(", ")),
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
}

/// Calls every renamed function, and every function with renamed arguments, by both names: the
/// programs are equal, and each former name is reported with its fix.
#[test]
fn former_names_of_the_library_mean_the_same() {
    let mut renamed = 0;
    for function in functions() {
        let formers = function.parameters.iter().filter(|parameter| parameter.sample.is_some());
        let formers = formers.filter_map(|parameter| parameter.former.as_deref());
        let mut formers: Vec<&str> = function.former.as_deref().into_iter().chain(formers).collect();
        if formers.is_empty() {
            continue;
        }
        renamed += formers.len();
        let [current, former] = [false, true]
            .map(|is_former| check_program("model.cx", &function.padded(is_former), &ModelLoader::default()));
        let (of_names, others): (Vec<_>, Vec<_>) =
            former.diagnostics.iter().cloned().partition(|found| found.code == "W0840");
        assert_eq!(others, current.diagnostics, "{}", function.name);
        assert!(of_names.iter().all(|found| found.fix.is_some()), "{}: {of_names:?}", function.name);
        let mut reported: Vec<&str> =
            of_names.iter().filter_map(|found| found.message.split('`').nth(1)).collect();
        formers.sort_unstable();
        reported.sort_unstable();
        assert_eq!(reported, formers, "{}", function.name);
        let [current, former] = [current, former].map(|checked| {
            let program = checked.program.expect("a program");
            format!("{:?}", Program { files: Vec::new(), ..program })
        });
        // Programs contain the text of short expressions, for display.
        let former = function.with_current_names(&former);
        assert!(current == former, "{}: the programs differ", function.name);
    }
    assert!(renamed > 40, "only {renamed} former names");
}

/// An error inside a library function is reported at the argument that the program passed.
#[test]
fn errors_inside_library_functions_are_shown_at_the_argument() {
    let planetary = |given: &str| {
        let function = functions().into_iter().find(|f| f.name == "planetary").expect("it exists");
        let name = given.split(' ').next().unwrap_or_default();
        let given = given.split_once(" = ").map(|(_, value)| value.to_owned());
        let arguments = function.arguments(|parameter| match parameter.name == name {
            true => given.clone(),
            false => parameter.sample.clone().filter(|_| parameter.default.is_none()),
        });
        crate::library::model(&function, &arguments)
    };
    let torque = |speed: &str| {
        format!("import gears;\nvar still = 0 rpm;\nprint(gears.torque_from_power(3 kW, {speed}));")
    };
    // Model, code, text at which the error is reported.
    let cases = [
        (planetary("contact_cells = 2.5"), "E0672", "2.5"),
        (planetary("contact_cells = same(1e12)"), "E0314", "same(1e12)"),
        (planetary("planets = same(2.5)"), "E0823", "same(2.5)"),
        (planetary("pin_stiffness = -1 N/m"), "E0314", "-1 N/m"),
        (planetary("ring_free = [\"u_q\"]"), "E0670", "[\"u_q\"]"),
        (torque("still"), "E0822", "still"),
    ];
    for (text, code, blamed) in &cases {
        let found = check_text("model.cx", text).diagnostics;
        let error = found.iter().find(|d| d.severity == Severity::Error);
        let error = error.unwrap_or_else(|| panic!("no error in\n{text}"));
        let span = error.primary.span;
        let shown = text.get(span.start as usize..span.end as usize);
        assert_eq!((error.code.as_str(), shown), (*code, Some(*blamed)), "{error:?}");
        assert_eq!(span.file, FileId(0), "{error:?}");
        if *code != "E0314" {
            assert!(error.labels.iter().any(|label| label.span.file != FileId(0)), "{error:?}");
        }
    }
    // Several arguments contribute, so the error is reported at the call.
    let text = planetary("center_distance = 44 mm");
    let found = check_text("model.cx", &text).diagnostics;
    let errors: Vec<_> = found.iter().filter(|d| d.severity == Severity::Error).collect();
    assert!(!errors.is_empty() && errors.iter().all(|d| d.primary.span.file == FileId(0)), "{found:?}");
}

/// Sun and ring have meshes of their own, so an error of one mesh is not shown at the gear of the
/// other one. Settings of both meshes are shown at their argument.
#[test]
fn an_error_of_one_mesh_of_a_planetary_set_is_not_shown_at_the_gear_of_the_other() {
    let function = functions().into_iter().find(|f| f.name == "planetary").expect("it exists");
    let blamed = |loaded: &str, name: &str, value: &str| {
        let arguments = function.arguments(|parameter| match parameter.name.as_str() {
            own if own == name => Some(value.into()),
            "sun_torque" | "ring_torque" => (parameter.name == loaded).then(|| "20 N*m".into()),
            _ => parameter.sample.clone().filter(|_| parameter.default.is_none()),
        });
        let text = crate::library::model(&function, &arguments);
        let found = check_text("model.cx", &text).diagnostics;
        let errors = found.into_iter().filter(|d| d.severity == Severity::Error);
        let shown = errors.map(|error| {
            let span = error.primary.span;
            assert_eq!(span.file, FileId(0), "{error:?}");
            let shown = text.get(span.start as usize..span.end as usize).expect("a range");
            (error.code, shown.split('(').next().unwrap_or_default().to_owned())
        });
        shown.collect::<Vec<_>>()
    };
    for loaded in ["sun_torque", "ring_torque"] {
        // Neither mesh is possible. With a torque on the sun, the ring alone determines the second
        // gear of its mesh.
        let errors = blamed(loaded, "center_distance", "20 mm");
        assert!(errors.iter().any(|(_, shown)| shown == "gears.planetary"), "{loaded}: {errors:?}");
        let errors = blamed(loaded, "contact_cells", "2.5");
        assert_eq!(errors, [("E0672".to_owned(), "2.5".to_owned())], "{loaded}");
    }
}

/// The modes of rigid bodies on springs are counted by their free DOFs, without a
/// solution.
#[test]
fn a_mode_that_a_lumped_set_does_not_have_is_found_without_solving() {
    let function = functions().into_iter().find(|f| f.name == "lumped_natural_frequency").expect("it exists");
    let errors = |mode: &str| {
        let given = function.arguments(|parameter| match parameter.name.as_str() {
            "mode" => Some(mode.to_owned()),
            "carrier" => Some("housing".into()),
            _ => parameter.sample.clone(),
        });
        let found = check_text("model.cx", &crate::library::model(&function, &given)).diagnostics;
        let errors = found.into_iter().filter(|d| d.severity == Severity::Error);
        errors.map(|d| format!("{} {}", d.code, d.message)).collect::<Vec<_>>()
    };
    // `theta_z` of the pinion, which is both sun and ring, and `u_x` and `u_y` of the housing. The
    // wheel, which is the planet, is constrained.
    assert_eq!(errors("4"), Vec::<String>::new());
    assert_eq!(errors("5"), ["E0770 there is no mode 5: the set has 4"]);
}

/// Number of calls of each function, times `CALYX_FUZZ`, and without it.
const CALLS: usize = 12;
const FEW_CALLS: usize = 2;

#[test]
fn extreme_arguments_are_refused_or_work() {
    let rounds: Option<usize> = std::env::var("CALYX_FUZZ").ok().and_then(|n| n.parse().ok());
    let only = std::env::var("CALYX_FUZZ_ONLY").unwrap_or_default();
    let functions: Vec<_> =
        functions().into_iter().filter(|function| function.name.contains(&only)).collect();
    let mut random = Random(0x5EED_CA11);
    let calls: Vec<(String, bool)> = (0..rounds.map_or(FEW_CALLS, |rounds| CALLS * rounds))
        .flat_map(|call| functions.iter().map(move |function| (call, function)))
        .map(|(call, function)| {
            (crate::library::model(function, &function.extreme(&mut random)), call % 4 == 0)
        })
        .collect();
    let next = AtomicUsize::new(0);
    let tally = Mutex::new(Tally::default());
    thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| {
                while let Some((text, solved)) = calls.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let started = Instant::now();
                    let verdict = verdict(text, *solved);
                    let mut tally = tally.lock().expect("no call panics");
                    tally.add(text, &verdict, started.elapsed());
                    tally.print_progress(calls.len());
                }
            });
        }
    });
    let Tally { counts, wrong, late, longest } = tally.into_inner().expect("no call panics");
    println!("{} calls: {counts:?}, longest {longest:?}\n{late}", calls.len());
    if let Some(peak) = peak_memory() {
        println!("peak memory {} MB", peak >> 20);
        assert!(peak < 4 << 30, "{peak} bytes");
    }
    assert!(wrong.is_empty(), "\n{wrong}");
}

/// Counts of verdicts, and the calls behind them.
#[derive(Default)]
struct Tally {
    counts: BTreeMap<&'static str, usize>,
    /// Calls with a defect.
    wrong: String,
    /// Calls that only the run refuses.
    late: String,
    longest: Duration,
}

impl Tally {
    fn add(&mut self, text: &str, verdict: &Verdict, elapsed: Duration) {
        let line =
            text.lines().find(|line| line.contains(crate::library::MARK)).unwrap_or_default().to_owned();
        let (name, problem) = match verdict {
            Verdict::Refused => ("refused", None),
            Verdict::Accepted => ("accepted", None),
            Verdict::Solved => ("accepted and solved", None),
            Verdict::RefusedLate(why) => {
                self.late += &format!("{line}\n    {why}\n");
                let known = ONLY_SOLVED.iter().any(|code| why.starts_with(code));
                ("refused by the run alone", (!known).then_some(why))
            }
            Verdict::Defect(why) => ("defects", Some(why)),
        };
        *self.counts.entry(name).or_default() += 1;
        self.longest = self.longest.max(elapsed);
        if let Some(why) = problem {
            println!("{line}\n    {why}");
            self.wrong += &format!("{line}\n    {why}\n");
        }
    }

    /// Prints the counts after each twentieth of the calls: all calls of a long test take an hour.
    fn print_progress(&self, all: usize) {
        let done: usize = self.counts.values().sum();
        if done.is_multiple_of((all / 20).max(1)) {
            println!("{done} of {all} calls: {:?}", self.counts);
        }
    }
}

/// Errors that only a solution shows; section 16 of the reference lists them.
const ONLY_SOLVED: [&str; 8] = ["E0678", "E0714", "E0715", "E0716", "E0717", "E0719", "E0721", "E0758"];

/// The result of checking and solving a model.
#[derive(Debug)]
enum Verdict {
    /// Checking reports an error.
    Refused,
    Accepted,
    Solved,
    /// Checking accepts it, and the run reports an error.
    RefusedLate(String),
    /// A panic, an internal error, or a call that does not end.
    Defect(String),
}

/// Time limit for checking; a run is limited to a tenth of it.
const PATIENCE: Duration = Duration::from_secs(120);

fn verdict(text: &str, solved: bool) -> Verdict {
    let (sender, heard) = channel();
    let text = text.to_owned();
    let cancel = Cancel::default();
    let switch = cancel.clone();
    thread::spawn(move || {
        let judged = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| judge(&text, solved, &cancel)));
        let judged = judged.unwrap_or_else(|_| Verdict::Defect("a panic".into()));
        let _ = sender.send(judged);
    });
    match heard.recv_timeout(PATIENCE) {
        Ok(verdict) => verdict,
        Err(RecvTimeoutError::Disconnected) => Verdict::Defect("the thread died".into()),
        Err(RecvTimeoutError::Timeout) => {
            switch.cancel();
            let stops = heard.recv_timeout(PATIENCE / 4).is_ok();
            let how = if stops { "stops when cancelled" } else { "cannot be cancelled" };
            Verdict::Defect(format!("takes longer than {PATIENCE:?}, and {how}"))
        }
    }
}

fn judge(text: &str, solved: bool, cancel: &Cancel) -> Verdict {
    let checked = check_program("model.cx", text, &ModelLoader::default());
    let errors: Vec<String> = checked
        .diagnostics
        .iter()
        .filter(|d| d.severity == Severity::Error)
        .map(|d| d.code.clone())
        .collect();
    let Some(program) = checked.program.filter(|_| errors.is_empty()) else {
        return match errors.as_slice() {
            [] => Verdict::Defect("no program and no error".into()),
            // Any other error is a mistake of the test generator.
            all if all.iter().all(|code| code == "E0314") => Verdict::Refused,
            _ => {
                let errors = checked.diagnostics.iter().filter(|d| d.severity == Severity::Error);
                Verdict::Defect(errors.map(|d| format!("{}: {}; ", d.code, d.message)).collect())
            }
        };
    };
    let Ok(elaborated) = elaborate(&program, Params::Defaults, cancel) else {
        return Verdict::Defect("cancelled".into());
    };
    let errors: Vec<_> = elaborated.found.iter().filter(|d| d.severity == Severity::Error).collect();
    if let Some(defect) = errors.iter().find(|d| is_defect(&d.code)) {
        return Verdict::Defect(format!("{}: {}", defect.code, defect.message));
    }
    match (errors.is_empty(), solved) {
        (false, _) => Verdict::Refused,
        (true, false) => Verdict::Accepted,
        (true, true) => solve(program),
    }
}

/// Returns `true` for codes of defects in Calyx, and of limits that no sensible call reaches.
fn is_defect(code: &str) -> bool {
    matches!(code, "E0799" | "E0703" | "E0707" | "E0708" | "E0709")
}

fn solve(program: Program) -> Verdict {
    // An instance needs a program with static lifetime.
    let program: &'static Program = Box::leak(Box::new(program));
    let interpreted = match Interpreted::new(program, calyx_abi::Purity::Effect) {
        Ok(interpreted) => interpreted,
        Err(found) => return Verdict::Defect(found.message),
    };
    let mut instance = Instance::new(&Engine::default(), Arc::new(interpreted));
    instance.limit_time(Some(PATIENCE / 10));
    match instance.solve() {
        Ok(_) => Verdict::Solved,
        // A long computation is allowed, because it can be stopped.
        Err(Error::Model(error)) if error.code == "E0707" => Verdict::Solved,
        Err(Error::Model(error)) if is_defect(&error.code) => {
            Verdict::Defect(format!("the run: {}: {}", error.code, error.message))
        }
        Err(Error::Model(error)) => Verdict::RefusedLate(format!("{}: {}", error.code, error.message)),
        Err(other) => Verdict::Defect(format!("the run: {other:?}")),
    }
}

/// Peak resident memory of this process, bytes; `None` on systems other than Linux.
fn peak_memory() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    Some(line.split_whitespace().next()?.parse::<u64>().ok()? << 10)
}
