//! The example models with random params, within and outside of their ranges: a check accepts
//! what a run accepts, every run ends, and every output of a run is finite.
//!
//! `CALYX_FUZZ=10` tries ten times as many values, `CALYX_FUZZ_SEED` changes the random seed, and
//! `CALYX_FUZZ_ONLY=planetary` selects the examples whose path contains the word.

use crate::library::Random;
use calyx_abi::Repr;
use calyx_abi::description::ParamDescription;
use calyx_elaborate::{Cancel, Interpreted, ModelLoader, Override, Params, check_file, elaborate};
use calyx_lang::diagnostic::Severity;
use calyx_lang::ir::Program;
use calyx_rt::{AssignedValue, Engine, Error, ErrorKind, Instance, ParamAssignment};
use std::collections::BTreeMap;
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Number of sets of params for each example, times `CALYX_FUZZ`.
const ROUNDS: u64 = 2;
/// Time limit of a run. Only cheap runs end before it; the others show that a run begins.
const RUN: Duration = Duration::from_millis(40);
/// Time limit of a run of a model that the check rejects. Such a run ends while it builds the
/// scene.
const REJECTED_RUN: Duration = Duration::from_secs(60);
/// Longest time that a run may continue beyond its limit, or that a check may take.
const LATE: Duration = Duration::from_secs(30);

/// Errors that only a solution shows; section 16 of the reference lists them.
const ONLY_SOLVED: [&str; 9] =
    ["E0678", "E0714", "E0715", "E0716", "E0717", "E0719", "E0721", "E0758", "E0770"];
/// Codes of defects in Calyx.
const DEFECTS: [&str; 4] = ["E0799", "E0703", "E0708", "E0709"];

fn setting(name: &str, usual: u64) -> u64 {
    std::env::var(name).ok().and_then(|number| number.parse().ok()).unwrap_or(usual)
}

/// An example model with its params.
struct Example {
    path: PathBuf,
    program: &'static Program,
    params: Vec<ParamDescription>,
}

/// Returns the examples that declare params, in the order of their paths.
fn examples() -> Vec<Example> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let only = std::env::var("CALYX_FUZZ_ONLY").unwrap_or_default();
    let mut paths: Vec<PathBuf> = [folder.clone(), folder.join("kinematics")]
        .iter()
        .flat_map(|folder| fs::read_dir(folder).expect("a directory"))
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "cx"))
        .collect();
    paths.sort();
    let example = |path: PathBuf| {
        let params = check_file(&path).expect("readable").description.params;
        let loader = ModelLoader { folder: path.parent().map(Path::to_path_buf), ..ModelLoader::default() };
        let text = fs::read_to_string(&path).expect("readable");
        let checked = calyx_lang::check_program(&path.display().to_string(), &text, &loader);
        // An instance needs a program with static lifetime.
        let program: &'static Program = Box::leak(Box::new(checked.program.expect("a valid example")));
        Example { path, program, params }
    };
    let selected = paths.into_iter().filter(|path| path.to_string_lossy().contains(&only));
    selected.map(example).filter(|example| !example.params.is_empty()).collect()
}

/// Returns a random number between 0 and 1.
fn fraction(random: &mut Random) -> f64 {
    random.below(1 << 20) as f64 / f64::from(1 << 20)
}

/// Returns a value of a param; one that its range contains, unless it is `wild`.
fn value(param: &ParamDescription, wild: bool, random: &mut Random) -> AssignedValue {
    const TEXTS: [&str; 10] = ["", "x", "1 kg", "2 m", "1e400", "-1e-320", "0", "1,5", "\u{1b}[31m", "TRUE"];
    if wild && random.below(8) == 0 {
        return AssignedValue::Text(TEXTS[random.below(TEXTS.len())].into());
    }
    if !param.choices.is_empty() {
        // Meshes in three dimensions cost more than the rest of the test.
        let cheap = ["rigid", "analytic"];
        let is_cheap = |choice: &&String| cheap.contains(&choice.as_str());
        let wanted: Vec<&String> = match param.choices.iter().any(|choice| is_cheap(&choice)) {
            true if random.below(8) > 0 => param.choices.iter().filter(is_cheap).collect(),
            _ => param.choices.iter().collect(),
        };
        return AssignedValue::String(wanted[random.below(wanted.len())].clone());
    }
    if param.repr == Repr::Bool {
        return AssignedValue::Bool(random.below(2) == 0);
    }
    let low = param.low.filter(|low| low.is_finite()).unwrap_or(-1.0);
    let high = param.high.filter(|high| high.is_finite()).unwrap_or(1.0);
    let number = match random.below(if wild { 9 } else { 6 }) {
        0 => low,
        1 => high,
        // Near the lower end, by orders of magnitude.
        2 => low + (high - low) * 10.0_f64.powi(-(random.below(16) as i32)),
        6 => {
            const OUTSIDE: [f64; 9] =
                [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -0.0, 1e300, -1e300, 5e-324, 1e12, -1.0];
            OUTSIDE[random.below(OUTSIDE.len())]
        }
        7 => high + (high - low) * 10.0_f64.powi(-(random.below(16) as i32)),
        8 => low - (high - low) * 10.0_f64.powi(-(random.below(16) as i32)),
        _ => low + (high - low) * fraction(random),
    };
    let rounded = param.integral && !(wild && random.below(4) == 0);
    AssignedValue::Si(if rounded { number.round() } else { number })
}

/// Returns random values of some params, and of every fidelity.
fn values(params: &[ParamDescription], random: &mut Random) -> Vec<ParamAssignment> {
    let count = 1 + random.below(4);
    let chosen: Vec<usize> = (0..count).map(|_| random.below(params.len())).collect();
    let wild = random.below(3) == 0;
    let all = params.iter().enumerate();
    all.filter(|(index, param)| chosen.contains(index) || param.name == "fidelity")
        .map(|(_, param)| ParamAssignment::value(&param.name, value(param, wild, random)))
        .collect()
}

/// The reason why a check or a run ends.
#[derive(Debug)]
enum Outcome {
    Accepted,
    /// The value of a param is invalid, with the message.
    Invalid(String),
    /// Codes of errors of the model.
    Errors(Vec<String>),
    /// The run reached a limit of time or memory.
    Limit,
}

fn checked(example: &Example, given: &[ParamAssignment]) -> Result<Outcome, String> {
    let params = Params::Given(given, Override::default(), None);
    let elaborated = elaborate(example.program, params, &Cancel::default()).map_err(|e| e.to_string())?;
    if let Some(invalid) = elaborated.refused {
        return Ok(Outcome::Invalid(invalid.message));
    }
    let errors = elaborated.found.into_iter().filter(|found| found.severity == Severity::Error);
    let (codes, texts): (Vec<String>, Vec<String>) =
        errors.map(|error| (error.code.clone(), format!("{}: {}", error.code, error.message))).unzip();
    match codes.iter().any(|code| DEFECTS.contains(&code.as_str())) {
        true => Err(format!("the check reports {texts:?}")),
        false if codes.is_empty() => Ok(Outcome::Accepted),
        false => Ok(Outcome::Errors(codes)),
    }
}

fn run(example: &Example, given: &[ParamAssignment], limit: Duration) -> Result<Outcome, String> {
    let interpreted = Interpreted::new(example.program, calyx_abi::Purity::Effect);
    let interpreted = interpreted.map_err(|found| found.message)?;
    let mut instance = Instance::new(&Engine::default(), Arc::new(interpreted));
    instance.limit_time(Some(limit));
    let solved = given.iter().try_for_each(|given| instance.give(given)).and_then(|()| instance.solve());
    let results = match solved {
        Ok(results) => results,
        Err(Error::Given(invalid)) => return Ok(Outcome::Invalid(invalid.message)),
        Err(error) if error.kind() == ErrorKind::Limit => return Ok(Outcome::Limit),
        Err(Error::Model(error)) if DEFECTS.contains(&error.code.as_str()) => {
            return Err(format!("the run reports {}: {}", error.code, error.message));
        }
        Err(Error::Model(error)) => return Ok(Outcome::Errors(vec![error.code])),
    };
    // The plan reports outputs that the fidelity does not support; they are NaN.
    let refused = results.plan().map_or(&[][..], |plan| &plan.refused);
    let is_refused = |index: usize| refused.iter().any(|refused| refused.output == index);
    for step in results.steps() {
        let outputs = results.description().outputs.iter().zip(step.outputs()).enumerate();
        for (_, (output, observed)) in outputs.filter(|(index, _)| !is_refused(*index)) {
            if !observed.value.is_finite() {
                return Err(format!("{} is {} at {} s", output.name, observed.value, step.position().time));
            }
        }
    }
    if let Some(certificate) = results.certificate().filter(|residuals| residuals.largest() > 1e-6) {
        return Err(format!("residuals: {certificate:?}"));
    }
    Ok(Outcome::Accepted)
}

/// Checks and runs an example with some params. Returns the kind of agreement; the error describes
/// a defect.
fn compare(example: &Example, given: &[ParamAssignment]) -> Result<&'static str, String> {
    let started = Instant::now();
    let check = checked(example, given)?;
    let accepted = matches!(check, Outcome::Accepted);
    let limit = if accepted { RUN } else { REJECTED_RUN };
    let taken = started.elapsed();
    if taken > LATE {
        return Err(format!("the check takes {taken:?}"));
    }
    let started = Instant::now();
    let run = run(example, given, limit)?;
    let taken = started.elapsed();
    if taken > limit + LATE {
        return Err(format!("a run that is limited to {limit:?} takes {taken:?}"));
    }
    let solved = |codes: &[String]| codes.iter().all(|code| ONLY_SOLVED.contains(&code.as_str()));
    match (&check, &run) {
        (Outcome::Accepted, Outcome::Accepted) => Ok("accepted and solved"),
        (Outcome::Accepted, Outcome::Limit) => Ok("accepted, and the run reached its time limit"),
        (Outcome::Accepted, Outcome::Errors(codes)) if solved(codes) => Ok("rejected by the solution"),
        (Outcome::Errors(found), Outcome::Errors(codes)) if codes.iter().all(|code| found.contains(code)) => {
            Ok("rejected")
        }
        // If several values are invalid, either of them may be reported.
        (Outcome::Invalid(first), Outcome::Invalid(second)) if first == second || given.len() > 1 => {
            Ok("invalid value")
        }
        _ => Err(format!("the check ends with {check:?}, the run with {run:?}")),
    }
}

/// Returns the arguments of a command that gives the params.
fn shown(given: &[ParamAssignment]) -> String {
    given.iter().map(|given| format!(" --set {}={:?}", given.name, given.value)).collect()
}

#[test]
fn a_check_with_random_params_accepts_what_a_run_accepts() {
    let rounds = ROUNDS * setting("CALYX_FUZZ", 1);
    let mut random = Random(0x9A7A_5EED ^ setting("CALYX_FUZZ_SEED", 0).wrapping_mul(0xD134_2543_DE82_EF95));
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    let mut defects = String::new();
    let (started, mut longest) = (Instant::now(), Duration::ZERO);
    let examples = examples();
    for _ in 0..rounds {
        for example in &examples {
            let given = values(&example.params, &mut random);
            let since = Instant::now();
            let compared = catch_unwind(AssertUnwindSafe(|| compare(example, &given)));
            longest = longest.max(since.elapsed());
            match compared.unwrap_or_else(|_| Err("a panic".into())) {
                Ok(kind) => *counts.entry(kind).or_default() += 1,
                Err(why) => {
                    defects += &format!("{}{}\n    {why}\n", example.path.display(), shown(&given));
                }
            }
        }
    }
    let cases = rounds as usize * examples.len();
    println!("{cases} cases in {:?}, longest {longest:?}: {counts:#?}", started.elapsed());
    assert!(defects.is_empty(), "\n{defects}");
}
