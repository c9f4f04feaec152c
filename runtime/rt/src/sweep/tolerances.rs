//! Toleranced params: their distributions, and the sample that is an axis of a sweep.

use super::axis::{Axis, check_units, refused};
use super::distribution::{Distribution, NAMES};
use super::sampling::{MOST_SOBOL_DIMENSIONS, MOST_SOBOL_POINTS, coordinates};
use super::varied::Varied;
use super::{FIDELITY, MOST_CASES};
use crate::error::Error;
use crate::param_assignment::{AssignedValue, Origin};
use crate::params::{InvalidParam, check_number, index_of, read_number, shown};
use calyx_abi::Repr;
use calyx_abi::description::{ModelDescription, ParamDescription, ParamValue};
use calyx_abi::units::{from_si, to_si};
use calyx_report::study::{Method, Sample};

/// Largest distance between the mean of a truncated normal distribution and its nearer bound, in
/// standard deviations.
const MOST_SIGMAS: f64 = 6.0;

/// Param with a distribution.
#[derive(Clone, Debug, PartialEq)]
pub struct Tolerance {
    /// Index of the param in the model's description.
    pub param: usize,
    pub distribution: Distribution,
    /// Location of the distribution, if in a file.
    pub origin: Option<Origin>,
}

/// Number of a distribution with its location, if in a file.
pub(super) type Quantity<'t> = (&'t AssignedValue, Option<Origin>);

/// Parts of a distribution as they are written.
#[derive(Clone, Debug, Default)]
pub(super) struct Parts<'t> {
    pub mean: Option<Quantity<'t>>,
    pub standard_deviation: Option<Quantity<'t>>,
    pub low: Option<Quantity<'t>>,
    pub high: Option<Quantity<'t>>,
    pub mode: Option<Quantity<'t>>,
}

/// Returns the index of a param that may have a distribution.
///
/// # Errors
/// There is no such param, or it is not a real number.
pub(super) fn toleranced(name: &str, description: &ModelDescription) -> Result<usize, Error> {
    let index = index_of(description, name).map_err(|error| match error {
        Error::Given(_) if name == FIDELITY => refused(
            "the fidelity level has no distribution",
            "vary it as an axis, like `--over fidelity=analytic,plane`",
        ),
        error => error,
    })?;
    let param = &description.params[index];
    let why = match param.repr {
        Repr::Number if param.integral => "takes whole numbers",
        Repr::Number => return Ok(index),
        Repr::Array(_) => "is an array",
        _ => "is not a number",
    };
    Err(refused(
        format!("`{name}` {why}, so it has no distribution"),
        format!("list its values as an axis, like `--over {name}=A,B`"),
    ))
}

/// Reads a distribution from its parts.
///
/// # Errors
/// A part is missing, superfluous or invalid, or the param excludes a value.
pub(super) fn distribution(
    kind: &str,
    index: usize,
    parts: &Parts<'_>,
    description: &ModelDescription,
) -> Result<Distribution, Error> {
    let param = &description.params[index];
    let given = [&parts.mean, &parts.standard_deviation, &parts.low, &parts.high, &parts.mode];
    let names = ["mean", "standard_deviation", "low", "high", "mode"];
    let forms: &[&[usize]] = match kind {
        "normal" => &[&[0, 1], &[2, 3]],
        "truncated_normal" => &[&[0, 1, 2, 3]],
        "uniform" => &[&[2, 3]],
        "triangular" => &[&[2, 3, 4], &[2, 3]],
        _ => {
            return Err(refused(
                format!("there is no distribution called `{kind}`"),
                format!("choose from {}", NAMES.join(", ")),
            ));
        }
    };
    let is_form = |form: &&&[usize]| (0..given.len()).all(|k| given[k].is_some() == form.contains(&k));
    if forms.iter().find(is_form).is_none() {
        let form = |form: &&[usize]| form.iter().map(|&k| names[k]).collect::<Vec<_>>().join(", ");
        let forms: Vec<String> = forms.iter().map(form).collect();
        let own: Vec<&str> = (0..given.len()).filter(|&k| given[k].is_some()).map(|k| names[k]).collect();
        let own = if own.is_empty() { "nothing".to_owned() } else { own.join(", ") };
        return Err(refused(
            format!("the distribution {kind} of `{}` has {own}", param.name),
            format!("give {}", forms.join(" or ")),
        ));
    }
    let texts: Vec<String> = given.iter().filter_map(|part| Some(part.as_ref()?.0.to_string())).collect();
    check_units(Varied::Param(index), &texts, description)?;
    let number = |part: &Option<Quantity<'_>>| match part {
        Some((value, origin)) => read_number(param, value, description)
            .map_err(|refused| Error::Given(refused).placed(origin.as_ref())),
        // Only present parts are used.
        None => Ok(f64::NAN),
    };
    let [mean, deviation, low, high, mode] = [
        number(&parts.mean)?,
        number(&parts.standard_deviation)?,
        number(&parts.low)?,
        number(&parts.high)?,
        number(&parts.mode)?,
    ];
    let at = |part: &Option<Quantity<'_>>, error: Error| {
        error.placed(part.as_ref().and_then(|(_, origin)| origin.as_ref()))
    };
    if deviation.is_finite() && deviation <= 0.0 || deviation.is_infinite() {
        let message = format!("the standard deviation of `{}` is {}", param.name, shown(param, deviation));
        return Err(at(&parts.standard_deviation, refused(message, "give a positive standard deviation")));
    }
    if parts.low.is_some() && low >= high {
        let message = format!("{} is not below {}", shown(param, low), shown(param, high));
        return Err(at(&parts.low, refused(message, "give the lower bound first")));
    }
    if parts.mode.is_some() && !(low..=high).contains(&mode) {
        let range = format!("{} .. {}", shown(param, low), shown(param, high));
        let message = format!("the mode {} is outside of {range}", shown(param, mode));
        return Err(at(&parts.mode, refused(message, "give a mode between the bounds")));
    }
    for part in [&parts.mean, &parts.low, &parts.high] {
        let si = number(part)?;
        if part.is_some() {
            check_number(param, si).map_err(|error| at(part, Error::Given(error)))?;
        }
    }
    Ok(match kind {
        "normal" if parts.low.is_some() => Distribution::normal_within(low, high),
        "normal" => Distribution::Normal { mean, standard_deviation: deviation },
        "truncated_normal" => {
            if (low - mean).max(mean - high) > MOST_SIGMAS * deviation {
                let message = format!(
                    "the bounds of `{}` are more than {MOST_SIGMAS} standard deviations from its mean",
                    param.name
                );
                return Err(at(&parts.mean, refused(message, "give a mean near the bounds")));
            }
            Distribution::TruncatedNormal { mean, standard_deviation: deviation, low, high }
        }
        "uniform" => Distribution::Uniform { low, high },
        _ if parts.mode.is_some() => Distribution::Triangular { low, mode, high },
        _ => Distribution::Triangular { low, mode: 0.5 * (low + high), high },
    })
}

const FORMS: &str = "write normal(MEAN, STANDARD_DEVIATION), normal(LOW..HIGH), uniform(LOW..HIGH), triangular(LOW..HIGH, MODE) or truncated_normal(MEAN, STANDARD_DEVIATION, LOW..HIGH)";

/// Parses a distribution like `normal(0 um, 5 um)`.
///
/// # Errors
/// The text is no distribution, or a value is invalid.
pub(super) fn parse_distribution(
    text: &str,
    index: usize,
    description: &ModelDescription,
) -> Result<Distribution, Error> {
    let whole = text.trim();
    let call = whole.strip_suffix(')').and_then(|rest| rest.split_once('('));
    let Some((kind, arguments)) = call else {
        return Err(refused(format!("`{whole}` is not a distribution"), FORMS));
    };
    let mut plain: Vec<AssignedValue> = Vec::new();
    let mut bounds: Option<[AssignedValue; 2]> = None;
    for argument in arguments.split(',').map(str::trim).filter(|argument| !argument.is_empty()) {
        let value = |text: &str| AssignedValue::Text(text.trim().to_owned());
        match argument.split_once("..") {
            Some((low, high)) if bounds.is_none() => bounds = Some([value(low), value(high)]),
            Some(_) => return Err(refused(format!("`{whole}` has two ranges"), FORMS)),
            None => plain.push(value(argument)),
        }
    }
    let kind = kind.trim();
    let most = if kind == "triangular" { 1 } else { 2 };
    if plain.len() > most {
        return Err(refused(format!("`{whole}` has too many numbers"), FORMS));
    }
    let number = |k: usize| plain.get(k).map(|value| (value, None));
    let (mean, mode) = if kind == "triangular" { (None, number(0)) } else { (number(0), None) };
    let [low, high] = [0, 1].map(|k| bounds.as_ref().map(|bounds| (&bounds[k], None)));
    let parts = Parts { mean, standard_deviation: number(1), low, high, mode };
    distribution(kind, index, &parts, description).map_err(|error| match error {
        Error::Given(refused)
            if refused.help.starts_with("give mean") || refused.help.starts_with("give low") =>
        {
            Error::Given(InvalidParam { help: FORMS.to_owned(), ..refused })
        }
        error => error,
    })
}

impl Tolerance {
    /// Parses `NAME = DISTRIBUTION`.
    ///
    /// # Errors
    /// The model has no such param, or the distribution is invalid for it.
    pub fn parse(text: &str, description: &ModelDescription) -> Result<Tolerance, Error> {
        let Some((name, distribution)) = text.split_once('=') else {
            return Err(refused(
                format!("`--sample {text}` has no `=`"),
                "give the distribution after the name, like `--sample \"slope = normal(0 um, 5 um)\"`",
            ));
        };
        let param = toleranced(name.trim(), description)?;
        let distribution = parse_distribution(distribution, param, description)?;
        Ok(Tolerance { param, distribution, origin: None })
    }
}

/// Method, number and seed of a sample, as far as they are given.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sampling {
    pub method: Option<Method>,
    pub samples: Option<usize>,
    pub seed: Option<u64>,
}

impl Sampling {
    /// Returns these settings, completed by those of a file.
    pub fn or(self, file: Sampling) -> Sampling {
        Sampling {
            method: self.method.or(file.method),
            samples: self.samples.or(file.samples),
            seed: self.seed.or(file.seed),
        }
    }

    /// Returns the axis of a sample of toleranced params, and its description; `None` without
    /// params. The points do not depend on the order in which the params are given.
    ///
    /// # Errors
    /// The number of samples is missing or too large, a param has two distributions, or a sampled
    /// value is out of range.
    pub fn axis(
        self,
        mut tolerances: Vec<Tolerance>,
        description: &ModelDescription,
    ) -> Result<Option<(Axis, Sample)>, Error> {
        let Some(first) = tolerances.first() else {
            return match self.samples {
                None => Ok(None),
                Some(_) => Err(refused(
                    "no param has a distribution to sample",
                    "give one, like `--sample \"slope = normal(0 um, 5 um)\"`",
                )),
            };
        };
        let name = |tolerance: &Tolerance| description.params[tolerance.param].name.clone();
        let Some(count) = self.samples else {
            return Err(refused(
                format!("the number of samples of `{}` is missing", name(first)),
                "give it, like `--samples 200`, or `samples = 200` in [sampling] of the study file",
            ));
        };
        tolerances.sort_by_key(|tolerance| tolerance.param);
        if let Some(twice) = tolerances.windows(2).find(|pair| pair[0].param == pair[1].param) {
            let error = refused(format!("`{}` has two distributions", name(&twice[1])), "keep one of them");
            return Err(error.placed(twice[1].origin.as_ref()));
        }
        let (method, seed) = (self.method.unwrap_or_default(), self.seed.unwrap_or(0));
        self.check_size(method, count, tolerances.len())?;
        let mut points = vec![Vec::with_capacity(tolerances.len()); count];
        for (dimension, tolerance) in tolerances.iter().enumerate() {
            let param = &description.params[tolerance.param];
            for (point, part) in points.iter_mut().zip(coordinates(method, seed, dimension, count)) {
                let value = rounded(tolerance.distribution.quantile(part), param);
                check_number(param, value).map_err(|error| beyond(error, tolerance))?;
                point.push(ParamValue::Number(value));
            }
        }
        let distributions = tolerances
            .iter()
            .map(|tolerance| tolerance.distribution.shown(&description.params[tolerance.param]));
        let sample = Sample { method, seed, count, distributions: distributions.collect() };
        let params = tolerances.iter().map(|tolerance| Varied::Param(tolerance.param)).collect();
        Ok(Some((Axis { params, names: Vec::new(), points, logarithmic: false }, sample)))
    }

    fn check_size(self, method: Method, count: usize, dimensions: usize) -> Result<(), Error> {
        if !(2..=MOST_CASES).contains(&count) {
            return Err(refused(
                format!("`{count}` is not a number of samples from 2 to {MOST_CASES}"),
                "give a number within these bounds",
            ));
        }
        if method == Method::Sobol && (count > MOST_SOBOL_POINTS || dimensions > MOST_SOBOL_DIMENSIONS) {
            return Err(refused(
                format!(
                    "the method sobol supports {MOST_SOBOL_POINTS} samples of {MOST_SOBOL_DIMENSIONS} params, not {count} of {dimensions}"
                ),
                "choose the method latin_hypercube or random",
            ));
        }
        Ok(())
    }
}

/// Rounds a value to twelve digits in the unit of the param, so that tables are short.
fn rounded(si: f64, param: &ParamDescription) -> f64 {
    let value = from_si(si, param.unit.factor);
    to_si(format!("{value:.11e}").parse().unwrap_or(value), param.unit.factor)
}

/// Adds the remedy to the error about a sampled value that is out of range.
fn beyond(error: InvalidParam, tolerance: &Tolerance) -> Error {
    let message = format!("a sample is out of range: {}", error.message);
    let help = match tolerance.distribution {
        Distribution::Normal { .. } => {
            "use truncated_normal with the bounds of the param, reduce the standard deviation, or widen the range in the model"
        }
        _ => "reduce the bounds, or widen the range in the model",
    };
    Error::Given(InvalidParam::new(message, help)).placed(tolerance.origin.as_ref())
}
