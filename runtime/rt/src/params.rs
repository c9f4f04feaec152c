//! Values of the params of a run: defaults, assigned values, ranges.

use crate::error::Error;
use crate::param_assignment::{AssignedValue, Origin, ParamAssignment};
use crate::program::{ParamFunction, Program};
use calyx_abi::description::{
    DimensionDescription, Exponents, ModelDescription, ParamDescription, ParamValue, UnitDescription,
};
use calyx_abi::quantity::{self, Quantity};
use calyx_abi::units::{from_si, shortest, to_si};
use calyx_abi::{Context, Repr, Slot, helpers, stack};

/// Reason why an assigned value is invalid.
#[derive(Clone, Debug, PartialEq)]
pub struct InvalidParam {
    pub message: String,
    /// Remedy; empty if there is none.
    pub help: String,
    /// Location of the assignment, if in a file.
    pub origin: Option<Origin>,
    /// Values that the param takes, for programs without `--set`.
    pub accepted: Option<Box<AcceptedValues>>,
}

/// Values that a param takes.
#[derive(Clone, Debug, PartialEq)]
pub struct AcceptedValues {
    pub name: String,
    /// Their kind and range, like `0 N*m .. 50 N*m`.
    pub domain: String,
    /// Default, SI, if it depends on no other param.
    pub default: Option<ParamValue>,
    pub unit: UnitDescription,
}

impl InvalidParam {
    pub fn new(message: impl Into<String>, help: impl Into<String>) -> InvalidParam {
        InvalidParam { message: message.into(), help: help.into(), origin: None, accepted: None }
    }

    /// Creates the error about a value that a param does not take.
    fn outside(message: String, param: &ParamDescription) -> InvalidParam {
        let accepted = AcceptedValues {
            name: param.name.clone(),
            domain: accepted_domain(param),
            default: param.default.clone(),
            unit: param.unit.clone(),
        };
        let help = takes(param, &accepted.domain);
        InvalidParam { accepted: Some(Box::new(accepted)), ..InvalidParam::new(message, help) }
    }
}

/// Value that a param is set to.
#[derive(Clone, Debug)]
pub(crate) struct Setting {
    pub value: ParamValue,
    origin: Option<Origin>,
}

impl Setting {
    /// Checks a value for the param at an index. A range that depends on other params is checked
    /// later, when those are known.
    ///
    /// # Errors
    /// The param has another kind or dimension, takes whole numbers only, takes other strings, or
    /// excludes this number.
    pub fn new(
        description: &ModelDescription,
        param: usize,
        value: &AssignedValue,
        origin: Option<&Origin>,
    ) -> Result<Setting, Error> {
        let (origin, param) = (origin.cloned(), &description.params[param]);
        let in_range = |value: &ParamValue| match value {
            ParamValue::Number(si) if param.independent => check_range(param, *si, (param.low, param.high)),
            ParamValue::Numbers(all) if param.independent => {
                check_ranges(param, all, (param.low, param.high))
            }
            _ => Ok(()),
        };
        match read(param, value, description).and_then(|value| in_range(&value).map(|()| value)) {
            Ok(value) => Ok(Setting { value, origin }),
            Err(refused) => Err(Error::Given(InvalidParam { origin, ..refused })),
        }
    }
}

/// Checks a value for its param alone: kind, dimension, choices, and a range that does not depend
/// on other params.
///
/// # Errors
/// The name is unknown, or the value is invalid.
pub fn check_assignment(
    description: &ModelDescription,
    assignment: &ParamAssignment,
) -> Result<(), InvalidParam> {
    assigned_value(description, assignment).map(|_| ())
}

/// Returns the value of an assignment, checked as [`check_assignment`] does; numbers are SI.
///
/// # Errors
/// The name is unknown, or the value is invalid.
pub fn assigned_value(
    description: &ModelDescription,
    assignment: &ParamAssignment,
) -> Result<ParamValue, InvalidParam> {
    let checked = index_of(description, &assignment.name)
        .and_then(|index| Setting::new(description, index, &assignment.value, assignment.origin.as_ref()));
    match checked {
        Ok(setting) => Ok(setting.value),
        Err(Error::Given(invalid)) => Err(invalid),
        // No other error arises here.
        Err(_) => Err(InvalidParam::new(format!("`{}` cannot be read", assignment.name), "")),
    }
}

/// Fills the params of a context from the defaults and from `given` (the last one of a name
/// counts).
///
/// # Errors
/// A name is unknown, a value is invalid for its param, or an expression of the model failed.
pub fn apply(program: &dyn Program, given: &[ParamAssignment], context: &mut Context) -> Result<(), Error> {
    let description = program.description();
    let mut settings = vec![None; description.params.len()];
    for ParamAssignment { name, value, origin, name_origin } in given {
        let index = index_of(description, name).map_err(|error| error.placed(name_origin.as_ref()))?;
        settings[index] = Some(Setting::new(description, index, value, origin.as_ref())?);
    }
    resolve(program, &settings, context)
}

/// Fills the params of a context from the defaults and from `settings`, indexed by param. Defaults
/// are computed in order, so one that depends on an earlier param uses the value set for that.
///
/// # Errors
/// A value is out of range, or an expression of the model failed.
pub(crate) fn resolve(
    program: &dyn Program,
    settings: &[Option<Setting>],
    context: &mut Context,
) -> Result<(), Error> {
    let description = program.description();
    context.files = description.files.clone();
    context.units = description.known_units.clone().into();
    context.tables = program.tables();
    context.directory = program.directory();
    context.allowed = program.description().allowed.clone();
    context.params = vec![f64::NAN; description.params.len()];
    context.param_slots = vec![0; description.params.len()];
    // All functions of the params share one stack.
    stack::with_stack(|| {
        for (index, param) in description.params.iter().enumerate() {
            set(program, index, param, settings.get(index).and_then(Option::as_ref), context)?;
        }
        Ok(())
    })?
}

fn set(
    program: &dyn Program,
    index: usize,
    param: &ParamDescription,
    setting: Option<&Setting>,
    context: &mut Context,
) -> Result<(), Error> {
    let ends = range(program, index, param, context)?;
    let slot = match setting.map(|setting| &setting.value) {
        Some(ParamValue::Bool(value)) => u64::from(*value),
        Some(ParamValue::Number(si)) => si.to_bits(),
        Some(ParamValue::String(text)) => context.heap.string(text),
        Some(ParamValue::Numbers(all)) => {
            let slots = all.iter().map(|si| si.to_bits()).collect();
            helpers::new_array(context, 1, slots)?
        }
        None => {
            let default = program.param_function(index, ParamFunction::Default, context)?;
            default.unwrap_or(f64::NAN.to_bits())
        }
    };
    context.param_slots[index] = slot;
    match param.repr {
        Repr::Bool => context.params[index] = if slot == 0 { 0.0 } else { 1.0 },
        Repr::Number => {
            context.params[index] = f64::from_bits(slot);
            let origin = setting.and_then(|setting| setting.origin.as_ref());
            let checked = check_range(param, f64::from_bits(slot), ends);
            checked.map_err(|refused| Error::Given(refused).placed(origin))?;
        }
        Repr::Array(_) => {
            let origin = setting.and_then(|setting| setting.origin.as_ref());
            let all = context.heap.numbers(slot).unwrap_or_default();
            let checked = check_ranges(param, &all, ends);
            checked.map_err(|refused| Error::Given(refused).placed(origin))?;
        }
        _ => {}
    }
    Ok(())
}

/// Returns the params of a context, in order.
pub(crate) fn values(description: &ModelDescription, context: &Context) -> Vec<ParamValue> {
    let slots = description.params.iter().zip(&context.param_slots);
    slots.map(|(param, &slot)| value_of(param, slot, context)).collect()
}

fn value_of(param: &ParamDescription, slot: Slot, context: &Context) -> ParamValue {
    match param.repr {
        Repr::Bool => ParamValue::Bool(slot != 0),
        Repr::String => ParamValue::String(context.heap.str(slot).unwrap_or_default().to_owned()),
        Repr::Array(_) => ParamValue::Numbers(context.heap.numbers(slot).unwrap_or_default()),
        _ => ParamValue::Number(f64::from_bits(slot)),
    }
}

/// Returns the index of the param with this name.
pub(crate) fn index_of(description: &ModelDescription, name: &str) -> Result<usize, Error> {
    let found = description.params.iter().position(|param| param.name == name);
    found.ok_or_else(|| {
        let names = description.params.iter().map(|param| param.name.as_str());
        unknown("param", name, names)
    })
}

/// Returns the index of the output with this name.
pub(crate) fn output_of(description: &ModelDescription, name: &str) -> Result<usize, Error> {
    let found = description.outputs.iter().position(|output| output.name == name);
    found.ok_or_else(|| {
        let names = description.outputs.iter().map(|output| output.name.as_str());
        unknown("output", name, names)
    })
}

/// Largest number of names that a message lists.
const MOST_LISTED: usize = 16;

/// Returns the error for a name of which the model has no param or output. Of many names it lists
/// the most similar ones.
fn unknown<'n>(what: &str, name: &str, names: impl Iterator<Item = &'n str> + Clone) -> Error {
    let message = format!("the model has no {what} called `{name}`");
    if let Some(help) = beyond_array(name, names.clone()) {
        return Error::given(message, help);
    }
    let near = near(name, names.clone());
    let mut helps = Vec::new();
    if !near.is_empty() {
        let shown: Vec<String> = near.iter().map(|near| format!("`{near}`")).collect();
        helps.push(format!("did you mean {}?", shown.join(" or ")));
    }
    let mut all: Vec<&str> = names.collect();
    // A single other name is listed as well.
    let more = all.len().checked_sub(MOST_LISTED).filter(|more| *more > 1).unwrap_or(0);
    if more > 0 {
        let likeness = |candidate: &str| strsim::jaro_winkler(name, candidate);
        all.sort_by(|a, b| likeness(b).total_cmp(&likeness(a)));
    }
    let listed = all[..all.len() - more].join(", ");
    match (all.is_empty(), more) {
        (true, _) => helps.push(format!("the model has no {what}s")),
        (_, 0) => helps.push(format!("its {what}s are {listed}")),
        _ if near.is_empty() => helps.push(format!("its {what}s are {listed}, and {more} others")),
        _ => {}
    }
    Error::given(message, helps.join(" "))
}

/// Returns the number of instances of an array, if a name has a larger index: `stages[3].torque`.
fn beyond_array<'n>(name: &str, names: impl Iterator<Item = &'n str> + Clone) -> Option<String> {
    name.match_indices('[').find_map(|(open, _)| {
        let index = |name: &str| name.get(open + 1..)?.split_once(']')?.0.parse::<usize>().ok();
        let array = &name[..open];
        let known =
            names.clone().filter(|name| name.strip_prefix(array).is_some_and(|rest| rest.starts_with('[')));
        let last = known.filter_map(index).max()?;
        (index(name)? > last).then(|| match last {
            0 => format!("`{array}` has 1 instance, `{array}[0]`"),
            _ => format!("`{array}` has {} instances, from `{array}[0]` to `{array}[{last}]`", last + 1),
        })
    })
}

/// Returns up to three names that may be meant by an unknown one: the nearest spelling, or else
/// the names in instances that end with it, `low.torque` for `torque`.
fn near<'n>(name: &str, names: impl Iterator<Item = &'n str> + Clone) -> Vec<&'n str> {
    let distance = |candidate: &str| {
        let distance = strsim::damerau_levenshtein(name, candidate);
        (distance <= (candidate.len() / 3).max(1)).then_some(distance)
    };
    if let Some((_, whole)) = names.clone().filter_map(|all| Some((distance(all)?, all))).min() {
        return vec![whole];
    }
    // The part of a name from each dot on that has as many parts.
    let parts = name.matches('.').count();
    let end =
        |candidate: &'n str| candidate.rmatch_indices('.').nth(parts).map(|(at, _)| &candidate[at + 1..]);
    let inside: Vec<(usize, &str)> = names.filter_map(|all| Some((distance(end(all)?)?, all))).collect();
    let least = inside.iter().map(|(distance, _)| *distance).min();
    inside
        .into_iter()
        .filter(|(distance, _)| Some(*distance) == least)
        .map(|(_, name)| name)
        .take(3)
        .collect()
}

/// Bounds of a numeric range, in SI.
type Ends = (Option<f64>, Option<f64>);

/// Returns the range of a param at the values of a context.
///
/// # Errors
/// An expression of the model failed.
pub(crate) fn range(
    program: &dyn Program,
    index: usize,
    param: &ParamDescription,
    context: &mut Context,
) -> Result<Ends, Error> {
    if !matches!(param.repr, Repr::Number | Repr::Array(_)) {
        return Ok((None, None));
    }
    let mut end = |which| {
        let slot = program.param_function(index, which, context)?;
        Ok::<_, Error>(slot.map(f64::from_bits))
    };
    Ok((end(ParamFunction::Low)?, end(ParamFunction::High)?))
}

/// Converts the assigned value to the representation of the param, in SI.
fn read(
    param: &ParamDescription,
    value: &AssignedValue,
    description: &ModelDescription,
) -> Result<ParamValue, InvalidParam> {
    let refused = |value: &str, why: &str| {
        InvalidParam::outside(format!("`{}` cannot be {value}{why}", param.name), param)
    };
    match &param.repr {
        Repr::Bool => match value {
            AssignedValue::Bool(truth) => Ok(ParamValue::Bool(*truth)),
            AssignedValue::Text(text) if matches!(text.trim(), "TRUE" | "true") => Ok(ParamValue::Bool(true)),
            AssignedValue::Text(text) if matches!(text.trim(), "FALSE" | "false") => {
                Ok(ParamValue::Bool(false))
            }
            AssignedValue::String(text) => Err(refused(&format!("\"{text}\""), "")),
            other => Err(refused(&format!("`{other}`"), "")),
        },
        Repr::String => match value {
            AssignedValue::Text(text) | AssignedValue::String(text) => {
                if param.choices.is_empty() || param.choices.iter().any(|choice| choice == text) {
                    return Ok(ParamValue::String(text.clone()));
                }
                Err(refused(&format!("\"{text}\""), ""))
            }
            other => Err(refused(&format!("`{other}`"), ": it is a text")),
        },
        Repr::Array(_) => read_numbers(param, value, description).map(ParamValue::Numbers),
        _ => read_number(param, value, description).map(ParamValue::Number),
    }
}

/// Converts the elements of an array: a list, or a text such as `[1, 2 mm]` or `[1, 2] mm`.
fn read_numbers(
    param: &ParamDescription,
    value: &AssignedValue,
    description: &ModelDescription,
) -> Result<Vec<f64>, InvalidParam> {
    let text = match value {
        AssignedValue::List(elements) => {
            return elements.iter().map(|element| read_number(param, element, description)).collect();
        }
        AssignedValue::Text(text) | AssignedValue::String(text) => text.trim(),
        _ => "",
    };
    let Some((elements, unit)) = text.strip_prefix('[').and_then(|rest| rest.split_once(']')) else {
        let message = format!("`{}` cannot be `{value}`: it is an array", param.name);
        return Err(InvalidParam::outside(message, param));
    };
    let elements = elements.trim().trim_end_matches(',');
    let each = elements.split(',').filter(|_| !elements.is_empty());
    each.map(|element| {
        let written = AssignedValue::Text(format!("{} {}", element.trim(), unit.trim()).trim().to_owned());
        read_number(param, &written, description)
    })
    .collect()
}

/// Returns a text that begins with a number with a decimal comma, such as `1,5 mm`, with a decimal
/// point; `None` for other texts.
pub fn with_decimal_point(text: &str) -> Option<String> {
    let (before, after) = text.trim().split_once(',')?;
    let is_number = before.trim_start_matches(['+', '-']).bytes().all(|byte| byte.is_ascii_digit())
        && before.ends_with(|last: char| last.is_ascii_digit())
        && after.starts_with(|first: char| first.is_ascii_digit())
        && !after.contains(',');
    is_number.then(|| format!("{before}.{after}"))
}

/// Returns a text in units that the language has for other common spellings: `200 N*m` for `200
/// Nm`, `25 deg` for `25°` and `3 inch` for `3"`; `None` for other texts.
fn with_known_units(text: &str, units: &[UnitDescription]) -> Option<String> {
    let text = text.trim();
    let (number, unit) = text.split_at(text.find(|c: char| !"+-.0123456789".contains(c))?);
    let unit = unit.trim();
    let symbol = match unit {
        "°" => Some("deg"),
        "\"" | "″" => Some("inch"),
        "'" | "′" => Some("ft"),
        _ => None,
    };
    // A product without its sign: the shortest first factor that is a unit.
    let product = || {
        let mut parts = unit.char_indices().skip(1).map(|(at, _)| unit.split_at(at));
        let (first, second) =
            parts.find(|(first, second)| [first, second].iter().all(|part| is_unit(part, units)))?;
        Some(format!("{first}*{second}"))
    };
    let unit = symbol.map(str::to_owned).or_else(product)?;
    let written = format!("{} {unit}", number.trim());
    quantity::parse(&written, units).is_ok().then_some(written)
}

fn is_unit(name: &str, units: &[UnitDescription]) -> bool {
    units.iter().any(|unit| unit.name == name)
}

/// Converts an assigned value to a number in SI, for a param of any range.
pub(crate) fn read_number(
    param: &ParamDescription,
    value: &AssignedValue,
    description: &ModelDescription,
) -> Result<f64, InvalidParam> {
    let refused =
        |why: &str| InvalidParam::outside(format!("`{}` cannot be `{value}`: {why}", param.name), param);
    let units = &description.known_units;
    let written = match value {
        AssignedValue::Text(text) | AssignedValue::String(text) => text.as_str(),
        AssignedValue::Quantity(_, unit) => unit.as_str(),
        _ => "",
    };
    let quantity = match value {
        AssignedValue::Text(text) | AssignedValue::String(text) => quantity::parse(text, units),
        AssignedValue::Quantity(number, unit) => quantity::with_unit(*number, unit, units),
        AssignedValue::Number(value) => {
            Ok(Quantity { value: *value, dimension: quantity::PURE, unit: false })
        }
        AssignedValue::Si(si) => Ok(Quantity { value: *si, dimension: param.unit.dimension, unit: true }),
        AssignedValue::Bool(_) | AssignedValue::List(_) => Err("it is a number".into()),
    };
    let quantity = quantity.map_err(|why| match with_decimal_point(written) {
        Some(number) => refused(&format!("write a decimal point in place of the comma, `{number}`")),
        None => match with_known_units(written, units) {
            Some(text) => refused(&format!("{why}; write `{text}`")),
            None => refused(&why),
        },
    })?;
    // A bare number is in the unit of the default.
    let value = if quantity.unit { quantity.value } else { to_si(quantity.value, param.unit.factor) };
    if quantity.unit && !quantity::fits(quantity.dimension, param.unit.dimension) {
        return Err(refused(&other_kind(param, quantity.dimension, &description.known_dimensions)));
    }
    if quantity.unit && lacks_turn((written, quantity.dimension), (&param.unit.name, param.unit.dimension)) {
        return Err(refused("one cycle is 2 pi radians, and the default counts the other of the two"));
    }
    if param.integral && value.fract() != 0.0 {
        return Err(refused("it must be a whole number"));
    }
    Ok(value)
}

/// Reports whether one of two quantities, each with the text of its unit, counts cycles (in Hz) and
/// the other angles.
fn lacks_turn(first: (&str, Exponents), second: (&str, Exponents)) -> bool {
    /// Index of the angle exponent.
    const ANGLE: usize = 3;
    let angles = |(_, dimension): (&str, Exponents)| dimension[ANGLE].0 != 0;
    let cycles = |(text, dimension): (&str, Exponents)| {
        let mut names = text.split(|c: char| !c.is_alphabetic());
        !angles((text, dimension)) && names.any(|name| matches!(name, "Hz" | "kHz"))
    };
    angles(first) && cycles(second) || cycles(first) && angles(second)
}

/// Describes the mismatch between a quantity's dimension and the param's.
fn other_kind(param: &ParamDescription, given: Exponents, known: &[DimensionDescription]) -> String {
    let unit = param.unit.name.as_str();
    match (quantity::kind(given, known), quantity::kind(param.unit.dimension, known)) {
        (Some(given), _) if unit.is_empty() => {
            format!("that is {given}, and it is a pure number, without a unit")
        }
        (None, _) if unit.is_empty() => "it is a pure number, without a unit".into(),
        (Some(given), Some(own)) => format!("that is {given}, and its default is in {unit}, {own}"),
        (Some(given), None) => format!("that is {given}, and its default is in {unit}"),
        (None, Some(own)) => format!("its default is in {unit}, {own}, and that is another kind of quantity"),
        (None, None) => format!("its default is in {unit}, and that is another kind of quantity"),
    }
}

fn check_range(param: &ParamDescription, value: f64, ends: Ends) -> Result<(), InvalidParam> {
    if value.is_finite() && ends.0.is_none_or(|low| value >= low) && ends.1.is_none_or(|high| value <= high) {
        return Ok(());
    }
    let message = match domain(param, ends.0, ends.1) {
        range if range.is_empty() => format!("`{}` = {value} is not a finite number", param.name),
        range => format!("`{}` = {} is outside its range, {range}", param.name, shown(param, value)),
    };
    Err(InvalidParam::new(message, "give a value within the range, or widen the range in the model"))
}

/// Checks a number for a param whose range does not depend on other params; others are checked
/// later.
#[cfg(feature = "command")]
pub(crate) fn check_number(param: &ParamDescription, si: f64) -> Result<(), InvalidParam> {
    let ends = if param.independent { (param.low, param.high) } else { (None, None) };
    check_range(param, si, ends)
}

fn check_ranges(param: &ParamDescription, values: &[f64], ends: Ends) -> Result<(), InvalidParam> {
    values.iter().try_for_each(|value| check_range(param, *value, ends))
}

/// Describes the accepted values, with the other params at their defaults.
fn accepted_domain(param: &ParamDescription) -> String {
    let unit = &param.unit.name;
    let domain = match domain(param, param.low, param.high) {
        domain if domain.is_empty() && unit.is_empty() => "any number".to_owned(),
        domain if domain.is_empty() => format!("any value in {unit}"),
        domain => domain,
    };
    match &param.repr {
        Repr::Array(_) => format!("an array, each element {domain}"),
        _ => domain,
    }
}

/// Describes the accepted values and the syntax of the assignment.
fn takes(param: &ParamDescription, domain: &str) -> String {
    let (name, unit) = (&param.name, &param.unit.name);
    let example = match &param.default {
        Some(ParamValue::Bool(value)) => (if *value { "TRUE" } else { "FALSE" }).to_owned(),
        Some(ParamValue::String(value)) => value.clone(),
        Some(ParamValue::Number(si)) => shortest(from_si(*si, param.unit.factor)),
        Some(ParamValue::Numbers(all)) => {
            let all: Vec<String> = all.iter().map(|si| shortest(from_si(*si, param.unit.factor))).collect();
            format!("[{}]", all.join(","))
        }
        None => return format!("`{name}` takes {domain}"),
    };
    let bare = if unit.is_empty() { String::new() } else { format!(", in {unit} if no unit is given") };
    // Shells interpret brackets.
    let quote = if name.contains('[') { "\"" } else { "" };
    format!("`{name}` takes {domain}, like `--set {quote}{name}={example}{quote}`{bare}")
}

/// Describes the range of a param, in the unit of its default; empty if it is unlimited.
pub fn domain(param: &ParamDescription, low: Option<f64>, high: Option<f64>) -> String {
    let whole = if param.integral { "whole numbers " } else { "" };
    match (&param.repr, low, high) {
        (Repr::Bool, ..) => "TRUE or FALSE".into(),
        (Repr::String, ..) => {
            param.choices.iter().map(|choice| format!("\"{choice}\"")).collect::<Vec<_>>().join(" or ")
        }
        (_, Some(low), Some(high)) => format!("{whole}{} .. {}", shown(param, low), shown(param, high)),
        (_, Some(low), None) => format!("{whole}{} or more", shown(param, low)),
        (_, None, Some(high)) => format!("{whole}{} or less", shown(param, high)),
        (_, None, None) => whole.trim_end().into(),
    }
}

/// Formats a number in the unit of the param's default.
pub fn shown(param: &ParamDescription, si: f64) -> String {
    format!("{} {}", shortest(from_si(si, param.unit.factor)), param.unit.name).trim_end().to_owned()
}

/// Formats an array of numbers in the unit of the param's default: `[1, 2] mm`.
pub fn shown_list(param: &ParamDescription, si: &[f64]) -> String {
    let all: Vec<String> = si.iter().map(|si| shortest(from_si(*si, param.unit.factor))).collect();
    format!("[{}] {}", all.join(", "), param.unit.name).trim_end().to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn help(name: &str, names: &[String]) -> String {
        unknown("param", name, names.iter().map(String::as_str)).help().to_owned()
    }

    #[test]
    fn few_of_many_names_are_listed() {
        let mut names: Vec<String> = (0..80).map(|number| format!("setting_{number}")).collect();
        names.push("pinion_torque".to_owned());
        assert_eq!(help("pinion_torqe", &names), "did you mean `pinion_torque`?");
        let listed = help("torque_of_the_pinion", &names);
        assert!(listed.contains("pinion_torque, ") && listed.ends_with(", and 65 others"), "{listed}");
        assert_eq!(help("torque", &names[..2]), "its params are setting_0, setting_1");
        assert_eq!(help("torque", &[]), "the model has no params");
    }
}
