//! Tests that a run's results are read from its directory and shown as text.

use calyx_elaborate::results::RunSummary;

const FINISHED: &str = r#"{
  "calyx": "0.1.0", "model": "pair.cx", "source": { "sha256": "a948904f2f0f479b8f8197694b30184b0d2ed1c1cd2a1ec0fb85d299a192a447" },
  "params": {}, "fidelity": "plane", "positions": 36,
  "outputs": {
    "transmission_error": {
      "doc": "", "unit": "rad", "min": 1.0, "max": 2.0, "mean": 1.5, "peak_to_peak": 1.0,
      "display": { "unit": "inch", "min": 0.000231239, "max": 0.00024461, "mean": 0.00024, "peak_to_peak": 0.000013371 },
      "max_at": { "step": 3, "time": 0.1, "roll_angle": 0.35, "point": "HPSTC", "place": null },
      "error_estimate": { "relative": 0.00071, "includes_level": false, "parts": {} }
    },
    "share": {
      "doc": "", "unit": "", "min": 1.0, "max": 1.0, "mean": 1.0, "peak_to_peak": 0.0,
      "display": { "unit": "", "min": 1.0, "max": 1.0, "mean": 1.0, "peak_to_peak": 0.0 },
      "max_at": { "step": 0, "time": 0.0, "roll_angle": 0.1, "point": "", "place": null },
      "error_estimate": { "relative": 0.02, "includes_level": true }
    },
    "wild": {
      "doc": "", "unit": "", "min": 1.0, "max": null, "mean": null, "peak_to_peak": null,
      "display": { "unit": "psi", "min": 1.0, "max": null, "mean": null, "peak_to_peak": null },
      "max_at": { "step": 0, "time": 0.0, "roll_angle": 0.1, "point": "", "place": null }
    }
  },
  "warnings": ["a warning"]
}"#;

#[test]
fn a_finished_run_has_a_line_for_each_output() {
    let run = RunSummary::from_text(FINISHED).expect("a run");
    assert_eq!((run.positions, run.incomplete.is_none(), run.warnings.len()), (36, true, 1));
    let [error, share, wild] = ["transmission_error", "share", "wild"].map(|name| &run.outputs[name]);
    assert_eq!(error.line(), "0.0002312 .. 0.0002446 inch, mean 0.00024, peak to peak 1.337e-5");
    assert_eq!(
        [error.mean(), error.min(), error.max(), error.peak_to_peak()],
        ["0.00024 inch", "0.0002312 inch", "0.0002446 inch", "1.337e-5 inch"]
    );
    assert_eq!(error.place_of_maximum().as_deref(), Some("at HPSTC, roll angle 20.05 deg"));
    assert_eq!(share.line(), "1");
    assert_eq!(share.place_of_maximum().as_deref(), Some("at roll angle 5.73 deg"));
    assert_eq!(wild.line(), "1 .. inf psi, mean inf, peak to peak inf");
}

#[test]
fn an_error_without_that_of_the_level_says_so() {
    let run = RunSummary::from_text(FINISHED).expect("a run");
    let error = |output: &str| run.outputs[output].error();
    let numerical = "numerical error 0.071 %, the error of the fidelity level itself not included";
    assert_eq!(error("transmission_error").as_deref(), Some(numerical));
    assert_eq!(error("share").as_deref(), Some("estimated error 2 %"));
    assert_eq!(error("wild"), None);
}

#[test]
fn a_run_knows_the_text_it_is_of() {
    let run = RunSummary::from_text(FINISHED).expect("a run");
    assert!(run.is_of("hello world\n"));
    assert!(!run.is_of("hello world"));
}

#[test]
fn a_run_that_was_ended_says_so_and_what_is_no_run_is_refused() {
    let run = RunSummary::from_text(
        r#"{ "incomplete": { "code": "E0704", "message": "the run was cancelled" }, "positions": 7 }"#,
    )
    .expect("a run");
    assert_eq!(run.incomplete.map(|incomplete| incomplete.code).as_deref(), Some("E0704"));
    assert_eq!((run.positions, run.outputs.len()), (7, 0));
    assert!(RunSummary::from_text("[1, 2").is_err());
    assert!(RunSummary::from_text(r#"{ "outputs": [] }"#).is_err());
    assert!(RunSummary::read("/nowhere".as_ref()).is_err());
}
