//! Error of each setting relative to a reference, output by output, and the Pareto frontier of
//! error and time.
//!
//! Errors are fractions of the largest magnitude of the output in the reference run. Values are
//! compared at the positions that both runs have. For a setting with fewer positions the errors of
//! extremes and mean count too.

use super::measurement::{Measurement, Series};

/// Errors of an output, relative to the largest magnitude of the reference.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Errors {
    /// Largest deviation at a position that both runs have.
    pub deviation: f64,
    /// Error of the maximum.
    pub max: f64,
    /// Error of the minimum.
    pub min: f64,
    /// Error of the mean over time.
    pub mean: f64,
    /// Error of the peak-to-peak value.
    pub peak_to_peak: f64,
}

impl Errors {
    /// Returns the error used for the comparison: the largest deviation or, if positions are
    /// omitted, a larger error of extremes or mean. (For the same positions none of these exceeds
    /// the deviation.)
    pub fn error(&self) -> f64 {
        self.deviation.max(self.max).max(self.min).max(self.mean)
    }

    fn between(
        series: &Series,
        times: &[f64],
        reference: &Series,
        reference_times: &[f64],
    ) -> Option<Errors> {
        let magnitude = reference.magnitude();
        let part = |difference: f64| if difference == 0.0 { 0.0 } else { difference.abs() / magnitude };
        let mut deviation: f64 = 0.0;
        let mut common = 0;
        for (time, value) in times.iter().zip(&series.values) {
            // Both runs take the time from the same list, so it is equal to the bit.
            let Ok(at) = reference_times.binary_search_by(|other| other.total_cmp(time)) else { continue };
            deviation = deviation.max(part(value - reference.values.get(at)?));
            common += 1;
        }
        let errors = Errors {
            deviation,
            max: part(series.max - reference.max),
            min: part(series.min - reference.min),
            mean: part(series.mean - reference.mean),
            peak_to_peak: part(series.peak_to_peak - reference.peak_to_peak),
        };
        let is_defined = !series.values.iter().chain(&reference.values).any(|value| value.is_nan());
        (is_defined && common > 0 && errors.error().is_finite()).then_some(errors)
    }
}

/// Errors of an output at all settings.
#[derive(Clone, Debug)]
pub struct OutputErrors {
    pub name: String,
    /// Largest magnitude in the reference run, SI.
    pub magnitude: f64,
    /// Errors by setting; `None` if its fidelity level lacks the output.
    pub errors: Vec<Option<Errors>>,
    /// Settings on the Pareto frontier, from cheap to expensive.
    pub frontier: Vec<usize>,
}

/// Comparison of all settings with one of them.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// Settings from cheap to expensive.
    pub settings: Vec<Measurement>,
    /// Index of the reference.
    pub reference: usize,
    /// Discretization error by setting: true if the mesh of the reference is finer, so that the
    /// errors include it. Other settings are not recommended.
    pub includes_mesh_error: Vec<bool>,
    pub outputs: Vec<OutputErrors>,
}

/// Tolerances of the recommendations, relative to the largest magnitude.
pub const TOLERANCES: [f64; 5] = [0.1, 0.05, 0.02, 0.01, 0.001];

impl Comparison {
    /// Compares with the setting of this name; `None` if it does not exist.
    pub fn new(mut settings: Vec<Measurement>, reference: &str) -> Option<Comparison> {
        settings
            .sort_by(|a, b| a.time().total_cmp(&b.time()).then_with(|| a.setting.name.cmp(&b.setting.name)));
        let reference = settings.iter().position(|measured| measured.setting.name == reference)?;
        let truth = &settings[reference];
        let finer = |measured: &Measurement| {
            // Settings that are not fidelity levels differ by their names only.
            let known = [truth, measured].iter().all(|one| one.setting.overrides.fidelity.is_some());
            !known || truth.setting.is_finer_than(&measured.setting)
        };
        let includes_mesh_error: Vec<bool> = settings.iter().map(finer).collect();
        let outputs = truth.outputs.iter().map(|output| {
            let errors: Vec<Option<Errors>> = settings
                .iter()
                .map(|measured| {
                    Errors::between(measured.output(&output.name)?, &measured.times, output, &truth.times)
                })
                .collect();
            let frontier = frontier(&errors, reference, &includes_mesh_error);
            OutputErrors { name: output.name.clone(), magnitude: output.magnitude(), errors, frontier }
        });
        let outputs = outputs.collect();
        Some(Comparison { settings, reference, includes_mesh_error, outputs })
    }
}

/// Returns the settings from cheap to expensive, each with a smaller error than all cheaper ones.
/// Excludes the reference and settings whose errors omit the discretization error.
fn frontier(errors: &[Option<Errors>], reference: usize, includes_mesh_error: &[bool]) -> Vec<usize> {
    let mut least = f64::INFINITY;
    let mut frontier = Vec::new();
    for (index, errors) in errors.iter().enumerate() {
        let counts = index != reference && includes_mesh_error[index];
        let Some(error) = errors.as_ref().map(Errors::error).filter(|_| counts) else { continue };
        if error < least {
            least = error;
            frontier.push(index);
        }
    }
    frontier
}

impl OutputErrors {
    /// Returns the cheapest setting with an error of at most `tolerance`.
    pub fn cheapest(&self, tolerance: f64) -> Option<usize> {
        let within = |index: &&usize| self.errors[**index].is_some_and(|errors| errors.error() <= tolerance);
        self.frontier.iter().find(within).copied()
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::super::Setting;
    use super::*;
    use calyx_runtime::scene::Fidelity;
    use calyx_runtime::settings_override::Override;

    /// Creates a run with one output per series of values.
    pub(in super::super) fn measured(
        name: &str,
        time: f64,
        times: &[f64],
        outputs: &[(&str, &[f64])],
    ) -> Measurement {
        let series = |(name, values): &(&str, &[f64])| {
            let (min, max) =
                values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(*v), b.max(*v)));
            let mean = values.iter().sum::<f64>() / values.len() as f64;
            let name = (*name).to_owned();
            Series { name, values: values.to_vec(), min, max, mean, peak_to_peak: max - min }
        };
        Measurement {
            setting: Setting { name: name.into(), overrides: Override::default() },
            predicted: None,
            structures: 0.75 * time,
            positions: 0.25 * time,
            memory: 0,
            built: 1,
            times: times.to_vec(),
            outputs: outputs.iter().map(series).collect(),
        }
    }

    const TIMES: [f64; 3] = [0.0, 1.0, 2.0];

    #[test]
    fn errors_are_parts_of_the_largest_magnitude() {
        let all = vec![
            measured("truth", 8.0, &TIMES, &[("a", &[1.0, -4.0, 2.0])]),
            measured("off", 1.0, &TIMES, &[("a", &[1.0, -4.0, 2.4])]),
        ];
        let compared = Comparison::new(all, "truth").unwrap();
        assert_eq!((compared.reference, compared.settings[1].setting.name.as_str()), (1, "truth"));
        let a = &compared.outputs[0];
        let off = a.errors[0].unwrap();
        assert!(
            (off.deviation - 0.1).abs() < 1e-15 && (off.max - 0.1).abs() < 1e-15 && off.min == 0.0,
            "{off:?}"
        );
        assert!((off.mean - 0.1 / 3.0).abs() < 1e-15 && (off.peak_to_peak - 0.1).abs() < 1e-15);
        assert_eq!(a.errors[1].unwrap().error(), 0.0);
        assert_eq!((a.magnitude, a.frontier.as_slice()), (4.0, &[0][..]));
    }

    #[test]
    fn what_is_left_out_is_missed_by_extremes_and_mean() {
        let all = vec![
            measured("truth", 8.0, &TIMES, &[("a", &[0.0, 4.0, 2.0])]),
            measured("thin", 1.0, &[0.0, 2.0], &[("a", &[0.0, 2.0])]),
        ];
        let compared = Comparison::new(all, "truth").unwrap();
        let thin = compared.outputs[0].errors[0].unwrap();
        assert_eq!((thin.deviation, thin.max, thin.error()), (0.0, 0.5, 0.5));
    }

    #[test]
    fn outputs_that_a_level_lacks_are_blank() {
        let all = vec![
            measured("truth", 8.0, &TIMES, &[("a", &[1.0; 3]), ("b", &[0.0; 3])]),
            measured("poor", 1.0, &TIMES, &[("a", &[f64::NAN; 3]), ("b", &[0.0; 3])]),
            measured("poorer", 2.0, &TIMES, &[]),
        ];
        let compared = Comparison::new(all, "truth").unwrap();
        let [a, b] = &compared.outputs[..] else { panic!("two outputs") };
        assert!(a.errors[0].is_none() && a.errors[1].is_none() && a.frontier.is_empty());
        // An output that is zero everywhere has no error.
        assert_eq!((b.errors[0].unwrap().error(), b.errors[1]), (0.0, None));
        assert!(Comparison::new(Vec::new(), "truth").is_none());
    }

    #[test]
    fn the_frontier_is_what_nothing_cheaper_beats() {
        let of =
            |name, time, value: f64| measured(name, time, &TIMES, &[("a", &[100.0, 100.0, 100.0 + value])]);
        let all = vec![
            of("truth", 9.0, 0.0),
            of("dear and bad", 5.0, 30.0),
            of("cheap", 1.0, 20.0),
            of("better", 2.0, 4.0),
            of("worse", 3.0, 8.0),
            of("best", 4.0, 0.5),
        ];
        let compared = Comparison::new(all, "truth").unwrap();
        let a = &compared.outputs[0];
        let name = |index: usize| compared.settings[index].setting.name.as_str();
        let names: Vec<&str> = a.frontier.iter().map(|index| name(*index)).collect();
        assert_eq!(names, ["cheap", "better", "best"]);
        assert_eq!(a.cheapest(0.05).map(name), Some("better"));
        assert_eq!(a.cheapest(0.01).map(name), Some("best"));
        assert_eq!(a.cheapest(0.001), None);
    }

    /// A comparison on the same mesh does not measure the discretization error.
    #[test]
    fn settings_on_the_mesh_of_the_reference_are_not_recommended() {
        let level = |name: &str, refinement: Option<f64>| {
            Setting::new(Override { fidelity: Fidelity::named(name), refinement, ..Override::default() })
        };
        let of = |setting: Setting, time, value: f64| Measurement {
            setting,
            ..measured("", time, &TIMES, &[("a", &[100.0, 100.0, 100.0 + value])])
        };
        let all = vec![
            of(level("plane", None), 1.0, 5.0),
            of(level("medium", None), 2.0, 0.1),
            of(level("medium", Some(0.7)), 1.5, 2.0),
            of(level("finest", Some(0.5)), 1.8, 0.05),
            of(Setting::new(Override { cells: Some(20), ..level("medium", None).overrides }), 4.0, 0.0),
        ];
        let compared = Comparison::new(all, "medium contact_cells=20").unwrap();
        let seen: Vec<(&str, bool)> = compared
            .settings
            .iter()
            .map(|m| m.setting.name.as_str())
            .zip(compared.includes_mesh_error.iter().copied())
            .collect();
        assert_eq!(
            seen,
            [
                ("plane", true),
                ("medium refinement=0.7", true),
                ("finest refinement=0.5", false),
                ("medium", false),
                ("medium contact_cells=20", false)
            ]
        );
        assert_eq!(compared.outputs[0].frontier, [0, 1]);
        assert_eq!(compared.outputs[0].cheapest(0.01), None);
    }
}
