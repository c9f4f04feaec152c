//! Builds a model at the other values of its integer, Boolean and choice params, and at the ends of
//! the ranges of its other params.

use crate::check::Checked;
use crate::elaboration::{Cancelled, Lowered, problems_with};
use calyx_abi::description::{ParamDescription, ParamValue};
use calyx_abi::{Cancel, Repr};
use calyx_lang::diagnostic::{Diagnostic, Severity};
use calyx_lang::ir::Program;
use calyx_lang::span::Span;
use calyx_rt::ParamAssignment;
use std::num::NonZero;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::{Builder as Thread, available_parallelism};

/// Limit of the values of one param.
const MOST_VALUES: usize = 32;

/// Limit of the models built with one param varied, and of those with two.
const MOST_MODELS: usize = 256;

/// The same limits for a check that is not asked for ranges.
const MOST_VALUES_BY_DEFAULT: usize = 8;
const MOST_MODELS_BY_DEFAULT: usize = 16;

/// Limit of the gears made by a check that is not asked for ranges; one takes a few milliseconds.
const MOST_GEARS_BY_DEFAULT: u64 = 12;

/// Number of basic blocks that take about as long as a gear.
const BLOCKS_OF_A_GEAR: u64 = 50_000;

/// Number of gears that take about as long as a mesh on general axes, whose first contact is
/// searched on both flanks.
const GEARS_OF_A_GENERAL_MESH: u64 = 12;

/// The code of an assertion of the model: it refuses a value on purpose.
const ASSERTION: &str = "E0705";

/// Values of params that a check of ranges covers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent {
    /// A few values of each param; fewer, and of fewer params, the longer it takes to build the
    /// model.
    Cheap,
    /// Many values of each param, and of pairs of params.
    Pairs,
}

/// The result of [`check_ranges`].
#[derive(Debug, Default, PartialEq)]
pub struct Ranges {
    /// A warning for each problem, with the values that have it.
    pub found: Vec<Diagnostic>,
    /// Number of models built.
    pub models: usize,
    /// The params of which some values were not tried: name, and number of values tried and
    /// allowed.
    pub cut: Vec<(String, usize, usize)>,
    /// Number of combinations of two params tried and allowed, if some were not tried.
    pub cut_pairs: Option<(usize, usize)>,
}

/// Builds a model, without solving, at the values of its integer, Boolean and choice params, and at
/// the ends of the ranges of its other params. One param is varied; the others have their defaults.
/// Ranges with many values are sampled, with both ends. Values
/// that an assertion of the model refuses are no problem.
///
/// # Errors
/// The elaboration was cancelled.
pub fn check_ranges(checked: &Checked, extent: Extent, cancel: &Cancel) -> Result<Ranges, Cancelled> {
    let mut ranges = Ranges::default();
    let Some(program) = checked.program.as_ref().filter(|_| !checked.has_errors()) else {
        return Ok(ranges);
    };
    let params = &checked.description.params;
    let mut discrete: Vec<(usize, Values)> =
        params.iter().enumerate().filter_map(|(index, param)| Some((index, Values::of(param)?))).collect();
    let most_values = match extent {
        // Choices come first, because they differ more than numbers do.
        Extent::Cheap => {
            discrete.sort_by_key(|(_, values)| (values.is_continuous(), values.count()));
            MOST_VALUES_BY_DEFAULT
        }
        Extent::Pairs => MOST_VALUES,
    };
    if discrete.is_empty() {
        return Ok(ranges);
    }
    let Some(lowered) = &checked.lowered else { return Ok(ranges) };
    let builder = Builder { program, lowered, cancel };
    let mut planned: Vec<(Varied<'_>, Vec<ParamValue>)> = Vec::new();
    for (at, (index, values)) in discrete.iter().enumerate() {
        let each = match extent {
            Extent::Cheap => {
                let left = affordable(checked).saturating_sub(ranges.models);
                // The default is tried already.
                (left / (discrete.len() - at)).max(1).min(left) + usize::from(left > 0)
            }
            Extent::Pairs => (MOST_MODELS / discrete.len()).max(2),
        };
        let each = each.min(most_values);
        let (Some(param), Some(declared)) = (params.get(*index), program.params.get(*index)) else {
            continue;
        };
        let mut tried = values.at_most(each);
        if tried.len() < values.count() && !values.is_continuous() {
            ranges.cut.push((param.name.clone(), tried.len(), values.count()));
        }
        tried.retain(|value| Some(value) != param.default.as_ref());
        ranges.models += tried.len();
        let varied = Varied { param, declared: declared.span, values, valid: Vec::new(), refused: 0 };
        planned.push((varied, tried));
    }
    let models: Vec<Vec<Setting<'_>>> = planned
        .iter()
        .flat_map(|(varied, tried)| tried.iter().map(|value| vec![(varied.param, value)]))
        .collect();
    let mut results = builder.problems_of(&models)?.into_iter();
    let mut valid: Vec<Varied<'_>> = Vec::new();
    for (mut varied, tried) in planned {
        let mut problems = Problems::default();
        for (value, found) in tried.into_iter().zip(&mut results) {
            if found.is_empty() {
                varied.valid.push(value);
            } else {
                varied.refused += 1;
                problems.add(found, varied.values.shown(&value));
            }
        }
        let (name, declared) = (&varied.param.name, varied.declared);
        let named = |values: &[String]| format!("`{name}` = {}", listed(values));
        ranges.found.extend(problems.warnings(named, &[(declared, name)]));
        if !varied.values.is_continuous() {
            valid.push(varied);
        }
    }
    if extent == Extent::Pairs {
        check_pairs(&builder, &valid, &mut ranges)?;
    }
    Ok(ranges)
}

/// Returns the number of models that a check builds without being asked for ranges.
fn affordable(checked: &Checked) -> usize {
    let meshes = checked.general_meshes as u64 * GEARS_OF_A_GENERAL_MESH;
    let cost = checked.gears as u64 + meshes + checked.blocks / BLOCKS_OF_A_GEAR;
    match cost {
        0 => MOST_MODELS_BY_DEFAULT,
        _ => MOST_MODELS_BY_DEFAULT.min((MOST_GEARS_BY_DEFAULT / cost) as usize),
    }
}

/// Builds the model at combinations of the values of two params at which it is valid if the other
/// param has its default.
fn check_pairs(builder: &Builder<'_>, valid: &[Varied<'_>], ranges: &mut Ranges) -> Result<(), Cancelled> {
    let pairs: Vec<(&Varied<'_>, &Varied<'_>)> = valid
        .iter()
        .enumerate()
        .flat_map(|(index, first)| valid[index + 1..].iter().map(move |second| (first, second)))
        .filter(|(first, second)| !first.valid.is_empty() && !second.valid.is_empty())
        .collect();
    let each = MOST_MODELS / pairs.len().max(1);
    let (mut tried, mut allowed) = (0, 0);
    for (first, second) in pairs {
        let others = |varied: &Varied<'_>| varied.values.count().saturating_sub(1 + varied.refused);
        allowed += others(first) * others(second);
        // Equal numbers of values of both params, unless one has few.
        let few = first.valid.len().min(second.valid.len()).min(each.isqrt()).max(1);
        let many = (each / few).max(1);
        let (of_first, of_second) = match first.valid.len() <= second.valid.len() {
            true => (spread(&first.valid, few), spread(&second.valid, many)),
            false => (spread(&first.valid, many), spread(&second.valid, few)),
        };
        let models: Vec<Vec<Setting<'_>>> = of_first
            .iter()
            .flat_map(|a| of_second.iter().map(move |b| vec![(first.param, a), (second.param, b)]))
            .collect();
        (tried, ranges.models) = (tried + models.len(), ranges.models + models.len());
        let mut problems = Problems::default();
        for (model, found) in models.iter().zip(builder.problems_of(&models)?) {
            let each = model.iter().map(|(param, value)| format!("`{}` = {}", param.name, shown(value)));
            problems.add(found, each.collect::<Vec<_>>().join(" and "));
        }
        let named = |values: &[String]| match values {
            [only] => only.clone(),
            [first, others @ ..] => format!("{first} (and {} more combinations)", others.len()),
            [] => String::new(),
        };
        let declared = [(first.declared, &first.param.name), (second.declared, &second.param.name)];
        ranges.found.extend(problems.warnings(named, &declared));
    }
    if tried < allowed {
        ranges.cut_pairs = Some((tried, allowed));
    }
    Ok(())
}

/// A param with the values at which the model is valid, other than the default.
struct Varied<'p> {
    param: &'p ParamDescription,
    declared: Span,
    values: &'p Values,
    valid: Vec<ParamValue>,
    /// Number of values at which the model fails.
    refused: usize,
}

/// Problem of a model at some values of its params.
struct Problem {
    /// Error at the first value.
    error: Diagnostic,
    /// Values that have it.
    values: Vec<String>,
    /// True if the message has other numbers at other values.
    varies: bool,
}

/// Problems by code, location and text.
#[derive(Default)]
struct Problems(Vec<Problem>);

impl Problems {
    fn add(&mut self, found: Vec<Diagnostic>, shown: String) {
        for error in found {
            let alike = |known: &&mut Problem| {
                (&known.error.code, known.error.primary.span) == (&error.code, error.primary.span)
                    && without_numbers(&known.error).eq(without_numbers(&error))
            };
            match self.0.iter_mut().find(alike) {
                Some(known) => {
                    known.varies |= known.error.message != error.message;
                    // Several calls on one line may have the same problem.
                    if !known.values.contains(&shown) {
                        known.values.push(shown.clone());
                    }
                }
                None => self.0.push(Problem { error, values: vec![shown.clone()], varies: false }),
            }
        }
    }

    /// Returns the warnings. `named` describes the values; `declared` are the params.
    fn warnings(
        self,
        named: impl Fn(&[String]) -> String,
        declared: &[(Span, &String)],
    ) -> impl Iterator<Item = Diagnostic> {
        self.0.into_iter().map(move |Problem { error, values, varies }| {
            let verb = if declared.len() == 1 { "is" } else { "are" };
            let first = match &values[..] {
                [first, _, ..] if varies => format!(" at {first}"),
                _ => String::new(),
            };
            let warning = Diagnostic {
                severity: Severity::Warning,
                code: "W0877".into(),
                message: format!("{} {verb} allowed, but{first} {}", named(&values), error.message),
                ..error
            };
            declared
                .iter()
                .fold(warning, |warning, (span, name)| warning.label(*span, format!("declares `{name}`")))
        })
    }
}

/// Returns message and remedy of a problem without their numbers: problems with the same cause may
/// need opposite remedies.
fn without_numbers(problem: &Diagnostic) -> impl Iterator<Item = char> {
    let help = problem.help.as_deref().unwrap_or_default();
    let is_part = |c: &char| c.is_ascii_digit() || matches!(c, '.' | '-');
    problem.message.chars().chain(help.chars()).filter(move |c| !is_part(c))
}

/// Builds a program at given values of params.
struct Builder<'p> {
    program: &'p Program,
    lowered: &'p Lowered,
    cancel: &'p Cancel,
}

/// A param and its value.
type Setting<'p> = (&'p ParamDescription, &'p ParamValue);

impl Builder<'_> {
    /// Builds a model for each list of settings, on all cores, and returns the errors of each.
    fn problems_of(&self, models: &[Vec<Setting<'_>>]) -> Result<Vec<Vec<Diagnostic>>, Cancelled> {
        let next = AtomicUsize::new(0);
        let work = || {
            let mut built = Vec::new();
            loop {
                let at = next.fetch_add(1, Ordering::Relaxed);
                let Some(model) = models.get(at) else { return Ok(built) };
                built.push((at, self.problems_at(model)?));
            }
        };
        let threads = available_parallelism().map_or(1, NonZero::get).min(models.len());
        let mut built = std::thread::scope(|scope| {
            // If the system creates no thread, the others do its work.
            let others = (1..threads).filter_map(|_| Thread::new().spawn_scoped(scope, work).ok());
            let others: Vec<_> = others.collect();
            let mut built = work()?;
            for other in others {
                match other.join() {
                    Ok(more) => built.extend(more?),
                    Err(payload) => resume_unwind(payload),
                }
            }
            Ok(built)
        })?;
        built.sort_by_key(|(at, _)| *at);
        Ok(built.into_iter().map(|(_, found)| found).collect())
    }

    /// Builds the model and returns the errors.
    fn problems_at(&self, given: &[Setting<'_>]) -> Result<Vec<Diagnostic>, Cancelled> {
        let assignment = |(param, value): &Setting<'_>| ParamAssignment {
            name: param.name.clone(),
            value: (*value).clone().into(),
            origin: None,
            name_origin: None,
        };
        let given: Vec<ParamAssignment> = given.iter().map(assignment).collect();
        let mut problems = problems_with(self.program, self.lowered, &given, self.cancel)?;
        problems.retain(|found| found.severity == Severity::Error && found.code != ASSERTION);
        Ok(problems)
    }
}

/// Returns all values, or some of them at equal distances, with the first and the last.
fn spread(values: &[ParamValue], most: usize) -> Vec<ParamValue> {
    let number = values.len().min(most);
    let at = |index: usize| if number < 2 { 0 } else { index * (values.len() - 1) / (number - 1) };
    (0..number).filter_map(|index| values.get(at(index)).cloned()).collect()
}

/// The values of a param with finitely many.
enum Values {
    Listed(Vec<ParamValue>),
    /// First and last integer.
    Integers(i64, i64),
    /// Both ends of a continuous range in SI, and the size of the unit of the param in SI with its
    /// name.
    Ends([f64; 2], f64, String),
}

impl Values {
    fn of(param: &ParamDescription) -> Option<Values> {
        if !param.choices.is_empty() {
            return Some(Values::Listed(param.choices.iter().cloned().map(ParamValue::String).collect()));
        }
        if param.repr == Repr::Bool {
            return Some(Values::Listed(vec![ParamValue::Bool(false), ParamValue::Bool(true)]));
        }
        let (low, high) = (param.low?, param.high?);
        if param.repr == Repr::Number && !param.integral {
            let ends = low < high && low.is_finite() && high.is_finite();
            return ends.then(|| Values::Ends([low, high], param.unit.factor, param.unit.name.clone()));
        }
        let (low, high) = (low.ceil(), high.floor());
        let finite = param.repr == Repr::Number
            && param.integral
            && low.abs() < 1e15
            && high.abs() < 1e15
            && low <= high;
        finite.then_some(Values::Integers(low as i64, high as i64))
    }

    fn count(&self) -> usize {
        match self {
            Values::Listed(values) => values.len(),
            Values::Integers(first, last) => (last - first) as usize + 1,
            Values::Ends(..) => 2,
        }
    }

    /// Returns `true` for a param with more values than those that are tried.
    fn is_continuous(&self) -> bool {
        matches!(self, Values::Ends(..))
    }

    /// Returns a value as text, in the unit of the param.
    fn shown(&self, value: &ParamValue) -> String {
        match (self, value) {
            (Values::Ends(_, factor, unit), ParamValue::Number(number)) => {
                let scaled = number / factor;
                let rounded: f64 = format!("{scaled:.9e}").parse().unwrap_or(scaled);
                format!("{rounded} {unit}").trim_end().to_owned()
            }
            _ => shown(value),
        }
    }

    /// Returns all values, or some of them at equal distances, with the first and the last.
    fn at_most(&self, most: usize) -> Vec<ParamValue> {
        let count = self.count();
        let number = count.min(most);
        let at = |index: usize| if number < 2 { 0 } else { index * (count - 1) / (number - 1) };
        let value = |index: usize| match self {
            Values::Listed(values) => values.get(index).cloned(),
            Values::Integers(first, _) => Some(ParamValue::Number((first + index as i64) as f64)),
            Values::Ends(ends, ..) => ends.get(index).copied().map(ParamValue::Number),
        };
        (0..number).filter_map(|index| value(at(index))).collect()
    }
}

fn shown(value: &ParamValue) -> String {
    match value {
        ParamValue::Number(number) => format!("{number}"),
        ParamValue::Bool(true) => "TRUE".into(),
        ParamValue::Bool(false) => "FALSE".into(),
        ParamValue::String(text) => format!("{text:?}"),
        ParamValue::Numbers(numbers) => format!("{numbers:?}"),
    }
}

/// Number of values that a message lists.
const MOST_LISTED: usize = 6;

fn listed(values: &[String]) -> String {
    match values {
        [only] => only.clone(),
        [most @ .., last] if values.len() <= MOST_LISTED => format!("{} or {last}", most.join(", ")),
        [first, .., last] => format!("{first} ... {last} ({} values)", values.len()),
        [] => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use calyx_lang::span::FileId;

    /// A call that fails for each of three bearings lists a value of the param once.
    #[test]
    fn values_are_listed_once() {
        let span = Span::new(FileId(0), 0, 1);
        let problem = || Diagnostic::error("E0697", "the balls do not fit", span, "this call fails");
        let mut problems = Problems::default();
        problems.add(vec![problem(), problem(), problem()], "1".into());
        problems.add(vec![problem()], "2".into());
        let found: Vec<Diagnostic> =
            problems.warnings(|values| format!("`count` = {}", listed(values)), &[]).collect();
        let messages: Vec<&str> = found.iter().map(|found| found.message.as_str()).collect();
        assert_eq!(messages, ["`count` = 1 or 2 are allowed, but the balls do not fit"]);
    }
}
