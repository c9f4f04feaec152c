//! Checks that `check` and `run` apply the same rules: for combinations of gears, fidelities and
//! methods, both accept the same models and report the same codes. A setting that a message advises
//! is accepted, or at least not rejected with advice to undo it.

use calyx::{Interpreted, Override, check_run, check_text};
use calyx_abi::{Context, Purity};
use calyx_gears::host::ModelHost;
use calyx_lang::diagnostic::Severity;
use calyx_runtime::analysis::{Event, Observer};
use calyx_runtime::error::EngineError;
use std::fmt::Write;

const KINDS: [&str; 9] =
    ["spur", "helical", "crowned", "internal", "planetary", "web", "bearing", "lugs", "gauge"];
const FIDELITIES: [&str; 7] = ["rigid", "analytic", "plane", "medium", "thinrim", "fineroot", "finest"];

/// Analysis of a set of gears.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Case {
    kind: &'static str,
    fidelity: &'static str,
    dynamic: bool,
    modes: bool,
}

const HEAD: &str = "
import gears;
units mm_N_s;
var steel = gears.material(youngs_modulus = 206 GPa, poissons_ratio = 0.3);
var rack = gears.rack(module = 2 mm, tip_radius = 0.6 mm, plane = \"transverse\");
function blank(in teeth, in rim, in helix, in hand, in modifications) {
    return gears.external(
        teeth, rack, face_width = 10 mm, outer_diameter = (teeth + 2) * 2 mm, root_diameter = teeth * 2 mm - 5 mm, material = steel,
        rim = rim, tooth_thickness = 3.1 mm, modifications = modifications, helix_angle = helix, hand = hand);
}
";

const RING: &str = "
var ring_blank = gears.internal(
    teeth = 60, shaper = gears.shaper(teeth = 20, module = 2 mm, tip_radius = 0.3 mm), face_width = 10 mm, minor_diameter = 116.8 mm,
    root_diameter = 125 mm, material = steel, rim = gears.outer_rim(diameter = 128 mm, outer_diameter = 140 mm),
    tooth_thickness = 3.1 mm);
";

impl Case {
    fn text(&self) -> String {
        let Case { kind, fidelity, dynamic, modes } = *self;
        let mut text = HEAD.to_owned();
        let plain_rim = "gears.simple_rim(diameter = 40 mm, inner_diameter = 30 mm)";
        let rim = match kind {
            "web" => {
                "gears.disc_web(diameter = 40 mm, inner_diameter = 36 mm, bore_diameter = 12 mm, web_thickness = 4 mm)"
            }
            "lugs" => "gears.splined(gears.simple_rim(40 mm, 30 mm), teeth = 6, clearance = 0.05 mm)",
            _ => plain_rim,
        };
        let helix = if kind == "helical" { "10 deg" } else { "0 deg" };
        let crown = if kind == "crowned" { "[gears.lead_crown(5 um)]" } else { "[]" };
        if kind == "planetary" {
            text += RING;
            text += "
var set = gears.planetary(
    sun = blank(24, gears.simple_rim(40 mm, 30 mm), 0 deg, \"right\", []),
    planet = blank(18, gears.simple_rim(28 mm, 20 mm), 0 deg, \"right\", []), ring = ring_blank, center_distance = 42 mm,
    sun_speed = 60 rpm, sun_torque = 20 N*m, pin_stiffness = 1e8 N/m);
var mesh = set.sun_meshes[0];
";
        } else if kind == "internal" {
            text += RING;
            text += "
var pinion = gears.body(
    \"pinion\", blank(18, gears.simple_rim(28 mm, 20 mm), 0 deg, \"right\", []), free = [\"theta_z\"], moment = 20 N*m * e3,
    frame := Rotate(60 rpm * Time, e3));
var gear = gears.body(\"gear\", ring_blank, frame := Rotate(18 rpm * Time, e3) * Translate(42 mm * e1));
var mesh = gears.mesh(pinion, gear);
";
        } else {
            let free = match kind {
                "bearing" => "[\"u_x\", \"u_y\", \"u_z\", \"theta_z\"]",
                "lugs" => "[\"u_x\", \"u_y\", \"theta_z\"]",
                _ => "[\"theta_z\"]",
            };
            let _ = write!(
                text,
                "
var pinion = gears.body(
    \"pinion\", blank(24, {rim}, {helix}, \"right\", {crown}), free = {free}, moment = 20 N*m * e3,
    frame := Rotate(60 rpm * Time, e3));
var gear = gears.body(
    \"gear\", blank(24, {plain_rim}, {helix}, \"left\", []),
    frame := Rotate(-60 rpm * Time, e3) * Translate(48.05 mm * e1));
var mesh = gears.mesh(pinion, gear);
"
            );
            if kind == "bearing" {
                text += "gears.bearing(\"shaft\", pinion, radial_stiffness = 1e8 N/m, axial_stiffness = 1e7 N/m);\n";
            }
        }
        text += match kind {
            "gauge" => "/// Strain.\noutput strain := gears.gauge_strain(gears.gauge(gear));\n",
            _ => "/// Lag.\noutput lag := gears.transmission_error(mesh);\n",
        };
        let modes = if modes { ", highest_frequency = 20000 Hz" } else { "" };
        let how = match dynamic {
            true => "\"dynamic\", over = gears.time_ranges([gears.time_range(1 ms, step = 10 us)])",
            false => "\"quasi_static\", over = gears.mesh_cycle(mesh, 2)",
        };
        let _ =
            writeln!(text, "analyze({how}, fidelity = \"{fidelity}\", error_estimates = \"none\"{modes});");
        text
    }

    /// Returns the case after following advice that names a fidelity, a method or modes; `None` if
    /// it names none of them.
    fn advised(&self, help: &str) -> Option<Case> {
        // The text after this separator is an alternative.
        let first = help.split(", or ").next()?;
        let mut case = *self;
        if first.contains("\"quasi_static\"") {
            case.dynamic = false;
        }
        if first.contains("`highest_frequency` at 0") {
            case.modes = false;
        }
        if let Some((_, names)) = first.split_once("the fidelity \"") {
            let name = names.split('"').next()?;
            case.fidelity = FIDELITIES.into_iter().find(|known| *known == name)?;
        }
        (case != *self).then_some(case)
    }
}

/// Ends an analysis before it builds structures.
struct Ended;

const ACCEPTED: &str = "accepted";

impl Observer for Ended {
    fn observe(&mut self, event: Event<'_>) -> Result<(), EngineError> {
        match event {
            Event::Stage(_) => Err(EngineError::new(ACCEPTED, "accepted", "")),
            _ => Ok(()),
        }
    }
}

/// Returns the codes of the errors that a check finds, and the help of the first.
fn checked(text: &str) -> (Vec<String>, String) {
    let found = check_text("model.cx", text).diagnostics;
    let errors: Vec<_> = found.iter().filter(|found| found.severity == Severity::Error).collect();
    let help = errors.first().and_then(|error| error.help.clone()).unwrap_or_default();
    (errors.iter().map(|error| error.code.clone()).collect(), help)
}

/// Returns the code that a run ends with before it builds a structure; `None` if it would continue.
fn refused(text: &str, overrides: Override) -> Option<String> {
    let program = calyx_lang::check_program("model.cx", text, &calyx::elaborate::ModelLoader::default());
    let program = program.program.unwrap_or_else(|| panic!("{:?}", program.diagnostics));
    let interpreted = Interpreted::new(&program, Purity::Effect).expect("the interpreter");
    let program: &dyn calyx::rt::Program = &interpreted;
    let host = ModelHost { observer: Some(Box::new(Ended)), overrides, ..ModelHost::default() };
    let mut context = Context::new(Box::new(host));
    context.kernels = program.kernels();
    calyx::rt::apply(program, &[], &mut context).expect("defaults");
    let error = program.main(&mut context).expect_err("the observer ends it");
    (error.code != ACCEPTED).then_some(error.code)
}

/// Returns the cases, with one fidelity of each kind of model; finer 3-D meshes follow the same
/// rules.
fn cases() -> impl Iterator<Item = Case> {
    KINDS.into_iter().flat_map(|kind| {
        ["rigid", "analytic", "plane", "medium"].into_iter().flat_map(move |fidelity| {
            [(false, false), (true, false), (false, true), (true, true)].map(|(dynamic, modes)| Case {
                kind,
                fidelity,
                dynamic,
                modes,
            })
        })
    })
}

#[test]
fn a_check_accepts_what_a_run_accepts_and_advises_what_both_accept() {
    let mut wrong = String::new();
    let (mut accepted, mut rejected, mut followed) = (0, 0, 0);
    for case in cases() {
        let text = case.text();
        let (codes, help) = checked(&text);
        let run = refused(&text, Override::default());
        *(if run.is_none() { &mut accepted } else { &mut rejected }) += 1;
        if codes.first() != run.as_ref() {
            let _ = writeln!(wrong, "{case:?}: a check finds {codes:?}, a run ends with {run:?}");
        }
        let Some(advised) = case.advised(&help).filter(|_| !codes.is_empty()) else { continue };
        followed += 1;
        let (after, _) = checked(&advised.text());
        if !after.is_empty() {
            let _ = writeln!(wrong, "{case:?}: {codes:?} advises \"{help}\", and that gives {after:?}");
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
    assert!(accepted > 40 && rejected > 40 && followed > 40, "{accepted} {rejected} {followed}");
}

/// Options of the command change the diagnostics of a check as they change the run.
#[test]
fn options_count_in_a_check_as_in_a_run() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (kind, fidelity) in
        [("helical", "plane"), ("helical", "rigid"), ("gauge", "rigid"), ("bearing", "plane")]
    {
        let text = Case { kind, fidelity: "medium", dynamic: false, modes: false }.text();
        let file = folder.path().join(format!("{kind}.cx"));
        std::fs::write(&file, &text).expect("a temporary file");
        let mut overrides = Override::default();
        overrides.set("fidelity", fidelity).expect("a fidelity");
        let checked = check_run(&file, &[], overrides).expect("a readable file");
        let errors = checked.diagnostics.iter().filter(|found| found.severity == Severity::Error);
        let codes: Vec<&str> = errors.map(|error| error.code.as_str()).collect();
        assert_eq!(codes.first().copied(), refused(&text, overrides).as_deref(), "{kind} at {fidelity}");
    }
}

/// E0808 is a warning: 24 + 60 teeth are a multiple of 3 and of 4, not of 5.
#[test]
fn planets_that_cannot_be_evenly_spaced_are_reported() {
    let three = Case { kind: "planetary", fidelity: "plane", dynamic: false, modes: false }.text();
    let of = |planets: usize| {
        let text = three
            .replace("center_distance = 42 mm", &format!("center_distance = 42 mm, planets = {planets}"));
        let found = check_text("model.cx", &text).diagnostics;
        found.iter().map(|found| found.code.clone()).collect::<Vec<_>>()
    };
    assert_eq!([of(3), of(4)], [vec![], Vec::<String>::new()]);
    assert_eq!(of(5), ["W0808"]);
}
