//! Builds a model at the other values of its integer, Boolean and choice params.

use crate::check::Checked;
use crate::elaboration::{Cancelled, Params, elaborate};
use calyx_abi::Cancel;
use calyx_abi::Repr;
use calyx_abi::description::{ParamDescription, ParamValue};
use calyx_lang::diagnostic::{Diagnostic, Severity};
use calyx_lang::ir::Program;
use calyx_rt::{Override, ParamAssignment};

/// Limit of the values of one param.
const MOST_VALUES: usize = 32;

/// Limit of the models built.
const MOST_MODELS: usize = 256;

/// The code of an assertion of the model: it refuses a value on purpose.
const ASSERTION: &str = "E0705";

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
}

/// Builds a model, without solving, at the values of its integer, Boolean and choice params; the
/// other params have their defaults. Ranges with many values are sampled, with both ends. Values
/// that an assertion of the model refuses are no problem.
///
/// # Errors
/// The elaboration was cancelled.
pub fn check_ranges(checked: &Checked, cancel: &Cancel) -> Result<Ranges, Cancelled> {
    let mut ranges = Ranges::default();
    let Some(program) = checked.program.as_ref().filter(|_| !checked.has_errors()) else {
        return Ok(ranges);
    };
    let params = &checked.description.params;
    let discrete: Vec<(usize, Values)> =
        params.iter().enumerate().filter_map(|(index, param)| Some((index, Values::of(param)?))).collect();
    let each = (MOST_MODELS / discrete.len().max(1)).clamp(2, MOST_VALUES);
    for (index, values) in discrete {
        let (Some(param), Some(declared)) = (params.get(index), program.params.get(index)) else { continue };
        let tried = values.at_most(each);
        if tried.len() < values.count() {
            ranges.cut.push((param.name.clone(), tried.len(), values.count()));
        }
        let mut problems: Vec<(Diagnostic, Vec<String>)> = Vec::new();
        for value in tried.into_iter().filter(|value| Some(value) != param.default.as_ref()) {
            ranges.models += 1;
            let shown = shown(&value);
            for problem in problems_at(program, &param.name, value, cancel)? {
                let alike = |(known, _): &&mut (Diagnostic, Vec<String>)| {
                    (&known.code, known.primary.span) == (&problem.code, problem.primary.span)
                };
                match problems.iter_mut().find(alike) {
                    Some((_, values)) => values.push(shown.clone()),
                    None => problems.push((problem, vec![shown.clone()])),
                }
            }
        }
        ranges.found.extend(problems.into_iter().map(|(problem, values)| Diagnostic {
            severity: Severity::Warning,
            code: "W0877".into(),
            message: format!("`{}` = {} is allowed, but {}", param.name, listed(&values), problem.message),
            ..problem.label(declared.span, format!("declares `{}`", param.name))
        }));
    }
    Ok(ranges)
}

/// Builds the model at a value of a param and returns the errors.
fn problems_at(
    program: &Program,
    name: &str,
    value: ParamValue,
    cancel: &Cancel,
) -> Result<Vec<Diagnostic>, Cancelled> {
    let given =
        ParamAssignment { name: name.to_owned(), value: value.into(), origin: None, name_origin: None };
    let elaboration = elaborate(program, Params::Given(&[given], Override::default(), None), cancel)?;
    let mut problems = elaboration.found;
    problems.retain(|found| found.severity == Severity::Error && found.code != ASSERTION);
    Ok(problems)
}

/// The values of a param with finitely many.
enum Values {
    Listed(Vec<ParamValue>),
    /// First and last integer.
    Integers(i64, i64),
}

impl Values {
    fn of(param: &ParamDescription) -> Option<Values> {
        if !param.choices.is_empty() {
            return Some(Values::Listed(param.choices.iter().cloned().map(ParamValue::String).collect()));
        }
        if param.repr == Repr::Bool {
            return Some(Values::Listed(vec![ParamValue::Bool(false), ParamValue::Bool(true)]));
        }
        let (low, high) = (param.low?.ceil(), param.high?.floor());
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
    use crate::check::check_text;

    fn ranges(text: &str) -> Ranges {
        check_ranges(&check_text("model.cx", text), &Cancel::default()).expect("not cancelled")
    }

    #[test]
    fn every_value_of_a_range_is_tried() {
        let found = ranges(
            "param count = 3 in 2 .. 5; param shape = \"a\" in [\"a\", \"b\"]; param on = TRUE;
             var all = [1, 2, 3, 4]; print(all[count - 1], shape, on);",
        );
        assert_eq!(found.models, 3 + 1 + 1);
        assert_eq!(found.found.len(), 1, "{found:?}");
        let warning = &found.found[0];
        assert_eq!((warning.code.as_str(), warning.severity), ("W0877", Severity::Warning));
        assert!(warning.message.starts_with("`count` = 5 is allowed, but "), "{}", warning.message);
        assert!(found.cut.is_empty());
    }

    #[test]
    fn long_ranges_are_sampled_with_both_ends() {
        let found = ranges("param count = 3 in 1 .. 1000; var all = [1]; print(all[0 * count]);");
        assert_eq!(found.cut, [("count".to_owned(), MOST_VALUES, 1000)]);
        let values = Values::Integers(1, 1000).at_most(4);
        assert_eq!(values, [1.0, 334.0, 667.0, 1000.0].map(ParamValue::Number));
    }

    #[test]
    fn an_assertion_refuses_values_on_purpose() {
        let found = ranges("param count = 3 in 1 .. 5; assert(count != 4);");
        assert_eq!((found.models, found.found.len()), (4, 0));
    }
}
