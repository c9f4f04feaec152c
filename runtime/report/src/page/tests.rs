//! Pages of made-up runs: their contents, that they are self-contained, and that they are
//! well-formed HTML.

use super::*;
use serde_json::{Value, json};

/// Tags without an end tag.
const VOID: [&str; 4] = ["meta", "br", "hr", "!DOCTYPE"];

/// Checks that every tag is closed in order, and that the page loads nothing.
fn check(page: &str) {
    let mut open: Vec<&str> = Vec::new();
    let mut rest = page;
    while let Some(at) = rest.find('<') {
        rest = &rest[at + 1..];
        let end = rest.find('>').expect("a tag ends");
        let tag = &rest[..end];
        let name = tag.trim_start_matches('/').split([' ', '\n', '/']).next().unwrap();
        match tag {
            _ if tag.starts_with('/') => {
                assert_eq!(open.pop(), Some(name), "near {}", &rest[..80.min(rest.len())])
            }
            _ if VOID.contains(&name) || tag.ends_with('/') => {}
            _ => open.push(name),
        }
        rest = &rest[end + 1..];
        // Style is no markup.
        if open.last() == Some(&"style") {
            rest = &rest[rest.find("</style").unwrap()..];
        }
    }
    assert!(open.is_empty(), "{open:?}");
    for fetching in ["<script", "<link", "src=", "url(", "@import", "href=\"http"] {
        assert!(!page.contains(fetching), "{fetching}");
    }
    let elsewhere = page.matches("http").count();
    assert_eq!(elsewhere, page.matches("xmlns=\"http://www.w3.org/2000/svg\"").count(), "an address");
}

fn run_json() -> Value {
    let display =
        json!({ "unit": "urad", "factor": 1e-6, "min": 1.0, "max": 3.0, "mean": 2.0, "peak_to_peak": 2.0 });
    json!({
        "calyx": "1.2.3", "abi": "0123", "model": "pair.cx", "units": "inch_lbf_s",
        "doc": "A pair <b>& its</b> gear.\n\nOf two\nlines.",
        "source": { "files": [{ "name": "pair.cx", "sha256": "abc" }], "tables": [] },
        "params": {
            "torque": { "value": 5.0, "display": { "unit": "N*m", "value": 5.0 }, "doc": "How hard.", "at_default": false },
            "edges": { "value": true, "doc": "", "at_default": true },
            "name": { "value": "it's", "doc": "", "at_default": false },
        },
        "fidelity": "plane",
        "overrides": { "fidelity": "plane", "face_elements": 3 },
        "plan": {
            "bodies": { "pinion": { "modelled": true, "reason": "elastic" }, "idle": { "modelled": false, "reason": "left out: it touches nothing" } },
            "bearings": {},
        },
        "outputs": { "te": {
            "doc": "How far it is off.", "unit": "rad", "display": display,
            "min": 1e-6, "max": 3e-6, "mean": 2e-6, "peak_to_peak": 2e-6,
            "harmonics": [{ "order": 1, "amplitude": 1e-6, "phase": 0.0 }, { "order": 2, "amplitude": 1e-7, "phase": 0.0 }],
            "max_at": { "step": 2, "time": 0.2, "roll_angle": 0.4, "point": "LPSTC", "location": { "body": "pinion", "tooth": 3, "radius": 0.02, "axial": null } },
        } },
        "certificate": { "complementarity": 1e-17, "penetration": 2e-16, "tension": 0.0, "equilibrium": 1e-3 },
        "ignored_inputs": { "damping": "nothing moves" },
        "warnings": ["W0715: look here"],
    })
}

fn directory(run: &Value) -> tempfile::TempDir {
    let directory = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| fs::write(directory.path().join(name), text).unwrap();
    write("run.json", &run.to_string());
    write(
        "timing.json",
        r#"{ "total": 2.0, "stages": { "structures": 1.5, "positions": 0.5 }, "structures": { "built": 2, "reused": 0 } }"#,
    );
    write(
        "steps.csv",
        "step,time,cycle,roll_angle,point,te\n0,0,0,0.2,SAP,0.000001\n1,0.1,0.3,0.3,,0.000002\n2,0.2,0.6,0.4,LPSTC,0.000003\n",
    );
    directory
}

fn text(directory: &Path) -> String {
    let page = fs::read_to_string(write(directory).unwrap()).unwrap();
    check(&page);
    page.replace('\u{a0}', " ")
}

#[test]
fn a_page_says_what_the_run_was() {
    let directory = directory(&run_json());
    let page = text(directory.path());
    for said in [
        "<h1>A pair &lt;b&gt;&amp; its&lt;/b&gt; gear</h1>",
        "<p>Of two lines.</p>",
        "How hard.",
        "it touches nothing",
        "nothing moves",
        "W0715: look here",
        "rounding error",
        "too large",
        "roll angle 22.92°, LPSTC, pinion, tooth 3, radius 0.7874 inch",
        "calyx run pair.cx --set 'torque=5 N*m' --set 'name=it'\\''s'",
        "This run has no error estimates",
        "calyx tradeoff pair.cx",
        " --fidelity plane --face-elements 3",
        "Settings of the model overridden on the command line: <code>--fidelity plane --face-elements 3</code>.",
        "2 substructures were condensed",
        "harmonics of te",
    ] {
        assert!(page.contains(said), "{said}");
    }
    assert!(!page.contains("not complete") && !page.contains("id=\"stress\""));
    // The same files yield the same page, except for durations.
    assert_eq!(text(directory.path()), page);
    fs::write(directory.path().join("timing.json"), r#"{ "total": 9.0, "stages": { "positions": 9.0 } }"#)
        .unwrap();
    let other = text(directory.path());
    let without_time = |page: &str| {
        let (before, rest) = page.split_once("<section id=\"time\">").unwrap();
        before.to_owned() + rest.split_once("</section>").unwrap().1
    };
    assert!(other != page && without_time(&other) == without_time(&page));
}

#[test]
fn errors_stand_beside_what_they_are_of() {
    let mut run = run_json();
    let of = |x: f64| json!({ "min": x, "max": x, "mean": x, "peak_to_peak": x });
    let mut estimate = of(6e-8);
    estimate["relative"] = json!(0.02);
    estimate["parts"] = json!({ "discretization": of(1e-8), "positions": of(5e-8) });
    estimate["not_estimated"] = json!(["level"]);
    estimate["reasons"] = json!({ "level": "it costs more than the run" });
    run["outputs"]["te"]["error_estimate"] = estimate;
    let page = text(directory(&run).path());
    for said in [
        "± 0.06",
        "2 %",
        "<b>1.7 %</b>",
        "0.33 %",
        "1.4 times as many positions",
        "<th>numerical error</th>",
        "The model error of fidelity level <q>plane</q> is not included",
        "Errors that are not estimated:</p><ul class=\"note\"><li>fidelity level: it costs more than the run</li>",
        // Halving the dominant source halves the error approximately.
        "Estimated numerical error: <b>± 0.06 urad</b> at the value of largest magnitude (2 %), ± 0.06 urad at the minimum, ± 0.06 urad for the mean.",
        "Contributions: positions 1.7 %, mesh 0.33 %. <a href=\"#accuracy\">To halve it</a>: positions (positions take 1.4 times as long).",
        "<td class=\"word\">positions</td><td class=\"word\">about <b>2.2 s</b>, now 2 s</td>",
        " --fidelity plane --face-elements 3 --error-estimates full</code>",
        "<polygon",
    ] {
        assert!(page.contains(said), "{said}");
    }
    assert!(!page.contains("This run has no error estimates"));
}

/// The terminal names the settings that reduce large errors by the sources that the page shows.
#[test]
fn settings_are_named_for_large_errors() {
    let of = |x: f64| json!({ "min": x, "max": x, "mean": x, "peak_to_peak": x });
    let advice = |relative: f64| {
        let mut run = run_json();
        let mut estimate = of(6e-8);
        estimate["relative"] = json!(relative);
        estimate["parts"] =
            json!({ "discretization": of(1e-9), "contact_grid": of(3e-8), "positions": of(2.9e-8) });
        estimate["not_estimated"] = json!(["level"]);
        run["outputs"]["te"]["error_estimate"] = estimate;
        accuracy::advice(&Run::read(directory(&run).path()).unwrap().outputs)
    };
    assert_eq!(advice(0.099), None);
    assert_eq!(
        advice(0.11).as_deref(),
        Some("to reduce the errors above 10 %: a finer contact grid (--contact-cells), more positions")
    );
}

/// Errors of maximum and minimum differ: each is shown with its own value. All sources with similar
/// contributions must be halved, but only one of the mesh and the next fidelity level, which has
/// another mesh.
#[test]
fn all_that_weighs_is_to_be_halved() {
    let mut run = run_json();
    let of = |min: f64, max: f64| json!({ "min": min, "max": max, "mean": max, "peak_to_peak": max });
    let parts = json!({
        "discretization": of(1e-8, 3e-8), "level": of(1e-8, 2e-8), "contact_grid": of(9e-8, 2e-8), "positions": of(0.0, 1e-9),
    });
    let mut estimate = of(1e-7, 5.1e-8);
    estimate["relative"] = json!(0.017);
    estimate["parts"] = parts;
    estimate["not_estimated"] = json!([]);
    run["outputs"]["te"]["error_estimate"] = estimate;
    let page = text(directory(&run).path());
    for said in [
        "Estimated error: <b>± 0.051 urad</b> at the value of largest magnitude (1.7 %), ± 0.1 urad at the minimum,",
        "Contributions: mesh 1 %, fidelity level 0.67 %, contact grid 0.67 %, positions 0.033 %.",
        "To halve it</a>: fidelity level, contact grid (positions take 2 times as long, the next fidelity level).",
        "that of the next fidelity level, as predicted by <code>calyx explain</code>",
    ] {
        assert!(page.contains(said), "{said}\n{page}");
    }
    assert!(
        !page.contains("not estimated")
            && !page.contains("not included")
            && page.contains("<th>estimated error</th>")
    );
}

/// A load share of 1 is certain, unlike its other values.
#[test]
fn what_is_sure_at_its_largest_has_an_error_in_the_mean() {
    let mut run = run_json();
    let of = |mean: f64| json!({ "min": 2e-8, "max": 4e-22, "mean": mean, "peak_to_peak": 2e-8 });
    let mut estimate = of(3e-8);
    estimate["relative"] = json!(1.3e-16);
    estimate["parts"] = json!({ "discretization": of(2.5e-8), "positions": of(0.5e-8) });
    estimate["not_estimated"] = json!([]);
    run["outputs"]["te"]["error_estimate"] = estimate;
    let page = text(directory(&run).path());
    for said in [
        "The value of largest magnitude is exact. Estimated error: ± 0.02 urad at the minimum, ± 0.03 urad for the mean.",
        "0.83 %</b><small> of the mean</small>",
        "Contributions to the error of the mean: mesh 0.83 %, positions 0.17 %. <a href=\"#accuracy\">To halve it</a>: mesh (structures take 2 times as long).",
        "<td class=\"main\">± 0</td><td class=\"main\">0 %</td>",
    ] {
        assert!(page.contains(said), "{said}\n{page}");
    }
}

/// In a dynamic analysis the values between rows are known: storing more steps costs next to
/// nothing.
#[test]
fn between_kept_steps_all_is_known() {
    let mut run = run_json();
    let of = |x: f64| json!({ "min": x, "max": x, "mean": x, "peak_to_peak": x });
    let mut estimate = of(6e-8);
    estimate["relative"] = json!(0.02);
    estimate["parts"] = json!({ "positions": of(5.5e-8), "time_step": of(5e-9) });
    estimate["not_estimated"] = json!([]);
    run["outputs"]["te"]["error_estimate"] = estimate;
    let page = text(directory(&run).path());
    for said in [
        "To halve it</a>: stored steps (little more time).",
        "1.4 times as many stored steps",
        "<td class=\"word\">little more time</td>",
        "about <b>2 s</b>, now 2 s",
    ] {
        assert!(page.contains(said), "{said}\n{page}");
    }
    assert!(!page.contains("1.4 times as many positions"));
}

/// A single position and a constant output have no plot.
#[test]
fn what_has_no_course_has_no_plot() {
    let mut run = run_json();
    run["outputs"]["te"]["peak_to_peak"] = json!(0.0);
    run["outputs"]["te"]["min"] = json!(3e-6);
    run["doc"] = json!("A pair of `pair.cx`.");
    let directory = directory(&run);
    let page = text(directory.path());
    assert!(
        page.contains("<p><b>3 urad</b> at all positions.</p>") && !page.contains("te in urad"),
        "{page}"
    );
    assert!(
        page.contains("<h1>A pair of <code>pair.cx</code></h1>")
            && page.contains("<title>A pair of pair.cx</title>")
    );
    fs::write(directory.path().join("steps.csv"), "step,time,cycle,roll_angle,point,te\n0,0,0,0,,0.000003\n")
        .unwrap();
    let page = text(directory.path());
    assert!(page.contains("<h2>Positions</h2>") && page.contains("<p><b>3 urad</b></p>"), "{page}");
}

/// A maximum at the roll angle 0 has this angle, if other positions have roll angles.
#[test]
fn a_maximum_at_the_roll_angle_zero_has_an_angle() {
    let mut run = run_json();
    run["outputs"]["te"]["max_at"] = json!({ "step": 0, "time": 0.0, "roll_angle": 0.0, "point": "" });
    let directory = directory(&run);
    let rows = "step,time,cycle,roll_angle,point,te\n0,0,0,0,,0.000003\n1,0.001,0.5,0.1,,0.000002\n";
    fs::write(directory.path().join("steps.csv"), rows).unwrap();
    let page = text(directory.path());
    assert!(page.contains("roll angle 0.00°</td>"), "{page}");
}

/// Titles are one sentence; names between backticks are code; short times are in small units.
#[test]
fn sentences_code_and_times_are_as_people_write_them() {
    let mut run = run_json();
    run["doc"] = json!("A set of 5 mm. in all. It turns, as `speed` says, fast.\nFor ever.");
    run["outputs"]["te"]["max_at"] = json!({ "step": 2, "time": 0.0025, "roll_angle": 0.0, "point": "" });
    let directory = directory(&run);
    let rows = "step,time,cycle,roll_angle,point,te\n0,0,0,0,,0.000001\n1,0.001,0,0,,0.000002\n2,0.0025,0,0,,0.000003\n";
    fs::write(directory.path().join("steps.csv"), rows).unwrap();
    let page = text(directory.path());
    for said in ["<p>It turns, as <code>speed</code> says, fast. For ever.</p>", "2.5 ms</td>", "time [ms]"] {
        assert!(page.contains(said), "{said}\n{page}");
    }
}

/// Rounding errors are stated and not plotted.
#[test]
fn what_is_rounding_is_said_and_not_drawn() {
    let mut run = run_json();
    run["outputs"]["te"]["error_estimate"] = json!({ "min": 1e-7, "max": 1e-7, "mean": 1e-7, "peak_to_peak": 1e-7, "relative": null, "is_rounding": true, "parts": {}, "not_estimated": [] });
    let page = text(directory(&run).path());
    assert!(page.contains("Rounding only") && !page.contains("te in urad"), "{page}");
}

/// Outputs without values are listed once, with neither plot nor anchor.
#[test]
fn outputs_without_values_are_named_once() {
    let mut run = run_json();
    let nothing = json!({ "min": null, "max": null, "mean": null, "peak_to_peak": null });
    run["outputs"]["stress"] = nothing;
    run["refused_outputs"] = json!({ "stress": "root stresses" });
    run["warnings"] = json!(["E0780: output `stress` has no value", "W0715: look here"]);
    let directory = directory(&run);
    let rows = fs::read_to_string(directory.path().join("steps.csv")).unwrap();
    let rows: Vec<String> = rows
        .lines()
        .map(|row| format!("{row},{}\n", if row.starts_with("step") { "stress" } else { "NaN" }))
        .collect();
    fs::write(directory.path().join("steps.csv"), rows.concat()).unwrap();
    let page = text(directory.path());
    assert_eq!(page.matches("<code>stress</code>").count(), 2, "in the list and in the table");
    for said in ["requires root stresses", "no value</td>", "W0715: look here"] {
        assert!(page.contains(said), "{said}");
    }
    assert!(!page.contains("output-stress") && !page.contains("E0780"));
}

/// The trade-off results next to the run directory provide the cost of half the error.
#[test]
fn a_measured_trade_off_is_shown() {
    let mut run = run_json();
    run["outputs"]["te"]["error_estimate"] = json!({ "min": 6e-8, "max": 6e-8, "mean": 6e-8, "peak_to_peak": 6e-8, "relative": 0.02, "parts": {}, "not_estimated": [] });
    let setting = |name: &str, time: f64, error: f64| json!({ "name": name, "time": { "structures": time, "positions": 0.5 }, "errors": { "te": { "error": error } } });
    let document = json!({
        "reference": "finest",
        "settings": [setting("fine", 7.5, 0.004), setting("coarse", 0.5, 0.03), setting("middle", 2.5, 0.008)],
        "outputs": { "te": { "frontier": ["coarse", "middle", "fine"] } },
    });
    let folder = tempfile::tempdir().unwrap();
    let (own, beside) = (folder.path().join("pair.cx.run"), folder.path().join("pair.cx.tradeoff"));
    fs::rename(directory(&run).keep(), &own).unwrap();
    fs::create_dir(&beside).unwrap();
    fs::write(beside.join("tradeoff.json"), document.to_string()).unwrap();
    let page = text(&own);
    for said in [
        "coarse, 1 s: 3 %<br>middle, 3 s: 0.8 %<br>fine, 8 s: 0.4 %",
        "<td class=\"word\">middle, 3 s: 0.8 %</td>",
        "compared with <b>finest</b>",
    ] {
        assert!(page.contains(said), "{said}");
    }
    assert!(!page.contains("calyx tradeoff"));
}

/// A journal without `run.json` is a run that was killed; `incomplete` one that was stopped.
#[test]
fn runs_that_are_not_whole_say_so() {
    let mut run = run_json();
    run.as_object_mut()
        .unwrap()
        .retain(|name, _| !["outputs", "certificate", "plan", "fidelity"].contains(&name.as_str()));
    run["columns"] =
        json!({ "te": { "doc": "How far.", "unit": "rad", "display": { "unit": "urad", "factor": 1e-6 } } });
    let killed = directory(&run);
    let journal = format!("{{\"journal\":2,\"run\":{run}}}\n");
    fs::write(killed.path().join("journal.jsonl"), journal).unwrap();
    fs::remove_file(killed.path().join("run.json")).unwrap();
    let rows = fs::read_to_string(killed.path().join("steps.csv")).unwrap();
    fs::write(killed.path().join("steps.csv"), rows + "3,0.3,0.").unwrap();
    let page = text(killed.path());
    for said in [
        "it is in progress or was interrupted",
        "the 3 positions",
        "--resume",
        "How far.",
        "te in urad: 1 to 3",
    ] {
        assert!(page.contains(said), "{said}");
    }
    assert!(!page.contains("id=\"time\""), "the time of another run");

    run["incomplete"] = json!({ "code": "E0704", "message": "the run was cancelled" });
    let page = text(directory(&run).path());
    assert!(page.contains("This run is not complete: the run was cancelled."), "{page}");

    let nothing = tempfile::tempdir().unwrap();
    assert_eq!(write(nothing.path()).unwrap_err().kind(), io::ErrorKind::NotFound);
}

#[test]
fn gear_data_have_a_column_per_gear() {
    let entry = |name: &str, symbol: &str, unit: &str, text: &str, starts: bool| json!({ "name": name, "symbol": symbol, "value": 1.0, "unit": "m", "display": { "unit": unit, "text": text }, "starts_group": starts });
    let gear = |body: &str, teeth: &str| {
        json!({ "bodies": [body], "data": {
            "z": entry("number of teeth", "z", "", teeth, true),
            "d_a": entry("tip diameter", "d_a", "mm", "66.2450", true),
        } })
    };
    let mut wheel = gear("wheel", "47");
    wheel["data"]["beta"] = entry("helix angle", "beta", "deg", "14.0000", false);
    let mut run = run_json();
    run["gear_data"] = json!({
        "gears": [gear("pinion", "19"), wheel],
        "meshes": [{
            "bodies": [["pinion", "wheel"], ["pinion", "other"]],
            "data": { "epsilon_alpha": entry("transverse contact ratio", "epsilon_alpha", "", "1.5173", true) },
            "members": [
                { "d_Nf": entry("start of active profile", "d_Nf", "mm", "55.7870", true) },
                { "d_Nf": entry("start of active profile", "d_Nf", "mm", "141.0623", true) },
            ],
        }],
        "note": "x is positive outwards",
    });
    let page = text(directory(&run).path());
    for said in [
        "<h2>Gear data</h2>",
        "<th class=\"value\">pinion</th><th class=\"value\">wheel</th>",
        "<td>19</td><td>47</td>",
        "d<sub>a</sub>",
        "<td>–</td><td>14.0000</td>",
        "ε<sub>α</sub>",
        "Mesh of pinion and wheel (2 equal meshes)",
        "<td>55.7870</td><td>141.0623</td>",
        "x is positive outwards",
    ] {
        assert!(page.contains(said), "{said} is not in {page}");
    }
    assert!(page.find("<h2>Gear data</h2>") < page.find("<h2>Outputs</h2>"), "{page}");
    assert!(!text(directory(&run_json()).path()).contains("Gear data"));
}

/// Flanks of a gear with deviations on the left flank, in the form of `run.json`.
fn flanks() -> Value {
    let trace =
        |at: f64, flank: [f64; 3]| json!({ "at": at, "positions": [0.01, 0.02, 0.03], "flank": flank });
    let mut slipped = trace(0.0, [0.0, 4e-6, -1e-6]);
    slipped["design"] = json!([0.0, 0.0, -9e-6]);
    slipped["deviations"] = json!({ "total": 8e-6, "form": 1e-6, "slope": 7.25e-6, "middle": 4e-6 });
    let side = |profile: Value, amounts: Value| json!({ "amounts": amounts, "profiles": [profile], "helix": trace(0.05, [1e-6, 0.0, 1e-6]) });
    let relief = |value: f64| json!({ "symbol": "C_alphaa", "name": "tip relief", "value": value, "deviation": false });
    let point = |symbol: &str, name: &str, at: f64| json!({ "symbol": symbol, "name": name, "diameter": 0.05, "roll_length": at, "roll_angle": 0.5 });
    let tolerance = json!({ "total": 12e-6, "form": 9.5e-6, "slope": 7.5e-6 });
    json!({
        "points": [point("d_Nf", "start of active profile (SAP)", 0.011), point("d_a", "tip circle", 0.03)],
        "measuring_diameter": 0.05, "profile_range": [0.01, 0.02], "helix_range": [0.01, 0.03],
        "tolerances": { "grade": 6, "standard": "ISO 1328-1:2013", "profile": tolerance, "helix": tolerance },
        "left": side(slipped, json!([relief(9e-6)])),
        "right": side(trace(0.0, [0.0, 0.0, -9e-6]), json!([relief(9e-6), { "symbol": "C_beta", "name": "lead crowning", "value": 3e-6 }])),
    })
}

#[test]
fn modified_flanks_have_k_charts() {
    let mut run = run_json();
    run["units"] = json!("mm_N_s");
    run["gear_data"] =
        json!({ "gears": [{ "bodies": ["pinion"], "data": {}, "flanks": flanks() }], "meshes": [] });
    let page = text(directory(&run).path());
    for said in [
        "<h2>Flanks</h2>",
        "C<sub>αa</sub>",
        "<td>9</td><td>9</td>",
        "<td>–</td><td>3</td>",
        "f<sub>Hα</sub>",
        "<td>7.5</td><td>7.3</td><td>0</td>",
        "grade 6 of ISO 1328-1:2013",
        "<span class=\"c2\">tolerance band</span>",
        "left flanks",
        "right flanks",
        ">\nSAP\n<",
        "<td>50.000</td><td>11.000</td><td>28.648</td>",
    ] {
        assert!(page.contains(said), "{said} is not in {page}");
    }
    // The band covers the evaluation range only, and is shifted to the middle of the deviations.
    assert_eq!(page.matches("<polygon").count(), 4, "a band in each panel");
    // Without a grade there are no bands, and plain gears have no section.
    run["gear_data"]["gears"][0]["flanks"].as_object_mut().unwrap().remove("tolerances");
    let page = text(directory(&run).path());
    assert!(
        page.contains("<h2>Flanks</h2>") && !page.contains("<polygon") && !page.contains("tolerance band")
    );
    assert!(!text(directory(&run_json()).path()).contains("<h2>Flanks</h2>"));
}

#[test]
fn ends_of_the_active_profile_name_the_mate() {
    let mut run = run_json();
    let mut traces = flanks();
    traces["points"][0]["mate"] = json!("sun");
    run["gear_data"] =
        json!({ "gears": [{ "bodies": ["planet"], "data": {}, "flanks": traces }], "meshes": [] });
    let page = text(directory(&run).path());
    assert!(page.contains("SAP (sun)") && page.contains("(SAP), mesh with sun"), "{page}");
}

#[test]
fn choices_are_shown_by_name() {
    let mut run = run_json();
    run["outputs"]["te"]["choices"] = json!(["mixed", "rotational", "translational", "planet"]);
    run["outputs"]["te"]["display"]["factor"] = json!(1.0);
    run["outputs"]["te"]["display"]["unit"] = json!("");
    let at = directory(&run);
    let table =
        "step,time,cycle,roll_angle,point,te\n0,0,0,0.2,SAP,0\n1,0.1,0.3,0.3,,2\n2,0.2,0.6,0.4,LPSTC,2\n";
    fs::write(at.path().join("steps.csv"), table).unwrap();
    let page = text(at.path());
    assert!(page.contains("translational at 2 positions, mixed at 1"), "{page}");
    assert!(!page.contains("te: 0 to 2"), "there is no curve over choices");
    fs::write(at.path().join("steps.csv"), table.replace(",0\n", ",2\n")).unwrap();
    assert!(text(at.path()).contains("<b>translational</b> at all positions."));
}
