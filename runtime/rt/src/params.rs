//! Setting a model's params: defaults, given values, ranges.

use crate::given::{Given, GivenValue, Origin};
use crate::program::{ParamFunction, Program};
use calyx_abi::description::{
    DimensionDescription, Exponents, ModelDescription, ParamDescription, ParamValue,
};
use calyx_abi::quantity::{self, Quantity};
use calyx_abi::units::{from_si, to_si};
use calyx_abi::{Context, Repr, RuntimeError, Slot};
use std::path::{Path, PathBuf};

/// Why a param could not be set.
#[derive(Clone, Debug, PartialEq)]
pub enum ParamError {
    /// What the user gave is not usable.
    Given(Refused),
    /// The model's own expression for a default or a range failed.
    Model(RuntimeError),
}

/// Why a value given for a param from outside cannot be used.
#[derive(Clone, Debug, PartialEq)]
pub struct Refused {
    pub message: String,
    /// What to do about it; empty if nothing can be said.
    pub help: String,
    /// Where it was given, if in a file.
    pub origin: Option<Origin>,
}

impl Refused {
    pub fn new(message: impl Into<String>, help: impl Into<String>) -> Refused {
        Refused { message: message.into(), help: help.into(), origin: None }
    }
}

/// Fills `context.params` and `context.param_slots` from the defaults and from `given` (the last of a name counts).
/// Defaults are computed in order, so one that uses an earlier param follows its given value.
///
/// # Errors
/// A name is not known, a value does not fit its param, or an expression of the model failed.
pub fn apply(program: &dyn Program, given: &[Given], context: &mut Context) -> Result<(), ParamError> {
    let description = program.description();
    for given in given {
        if !description.params.iter().any(|param| param.name == given.name) {
            return Err(ParamError::Given(unknown_param(given, description)));
        }
    }
    context.files = description.files.clone().into();
    context.units = description.known_units.clone().into();
    // Beside the model; a text that came from no file has no place to read from.
    let directory = Path::new(&description.name).parent().map(|parent| match parent.as_os_str().is_empty() {
        true => PathBuf::from("."),
        false => parent.to_owned(),
    });
    context.directory = directory.filter(|_| Path::new(&description.name).is_file());
    context.params = vec![f64::NAN; description.params.len()];
    context.param_slots = vec![0; description.params.len()];
    for (index, param) in description.params.iter().enumerate() {
        let given = given.iter().rev().find(|given| given.name == param.name);
        let ends = range(program, index, param, context)?;
        let placed = |refused: Refused| {
            ParamError::Given(Refused { origin: given.and_then(|given| given.origin.clone()), ..refused })
        };
        let slot = match given {
            Some(given) => read(param, &given.value, ends, description, context).map_err(placed)?,
            None => program
                .param_function(index, ParamFunction::Default, context)
                .map_err(ParamError::Model)?
                .unwrap_or(f64::NAN.to_bits()),
        };
        context.param_slots[index] = slot;
        if param.repr == Repr::Bool {
            context.params[index] = if slot == 0 { 0.0 } else { 1.0 };
        }
        if param.repr == Repr::Number {
            context.params[index] = f64::from_bits(slot);
            check_range(param, f64::from_bits(slot), ends).map_err(placed)?;
        }
    }
    Ok(())
}

fn unknown_param(given: &Given, description: &ModelDescription) -> Refused {
    let name = given.name.as_str();
    let names = || description.params.iter().map(|param| param.name.as_str());
    let near = names()
        .map(|candidate| (strsim::damerau_levenshtein(name, candidate), candidate))
        .filter(|(distance, candidate)| *distance <= (candidate.len() / 3).max(1))
        .min();
    let mut help = match near {
        Some((_, near)) => format!("did you mean `{near}`? "),
        None => String::new(),
    };
    help += &match names().collect::<Vec<_>>().join(", ") {
        all if all.is_empty() => "the model has no params".to_owned(),
        all => format!("its params are {all}"),
    };
    let message = format!("the model has no param called `{name}`");
    Refused { origin: given.origin.clone(), ..Refused::new(message, help) }
}

/// The ends of a number's range, in SI.
type Ends = (Option<f64>, Option<f64>);

fn range(
    program: &dyn Program,
    index: usize,
    param: &ParamDescription,
    context: &mut Context,
) -> Result<Ends, ParamError> {
    if param.repr != Repr::Number {
        return Ok((None, None));
    }
    let mut end = |which| {
        let slot = program.param_function(index, which, context).map_err(ParamError::Model)?;
        Ok::<_, ParamError>(slot.map(f64::from_bits))
    };
    Ok((end(ParamFunction::Low)?, end(ParamFunction::High)?))
}

fn read(
    param: &ParamDescription,
    value: &GivenValue,
    ends: Ends,
    description: &ModelDescription,
    context: &mut Context,
) -> Result<Slot, Refused> {
    let name = &param.name;
    match &param.repr {
        Repr::Bool => match value {
            GivenValue::Bool(truth) => Ok(u64::from(*truth)),
            GivenValue::Text(text) if matches!(text.trim(), "TRUE" | "true") => Ok(1),
            GivenValue::Text(text) if matches!(text.trim(), "FALSE" | "false") => Ok(0),
            GivenValue::String(text) => {
                Err(Refused::new(format!("`{name}` cannot be \"{text}\""), takes(param, ends)))
            }
            other => Err(Refused::new(format!("`{name}` cannot be `{other}`"), takes(param, ends))),
        },
        Repr::String => match value {
            GivenValue::Text(text) | GivenValue::String(text) => {
                if param.choices.is_empty() || param.choices.iter().any(|choice| choice == text) {
                    return Ok(context.heap.string(text));
                }
                Err(Refused::new(format!("`{name}` cannot be \"{text}\""), takes(param, ends)))
            }
            other => {
                let message = format!("`{name}` cannot be `{other}`: it is a text");
                Err(Refused::new(message, takes(param, ends)))
            }
        },
        _ => read_number(param, value, ends, description).map(f64::to_bits),
    }
}

fn read_number(
    param: &ParamDescription,
    value: &GivenValue,
    ends: Ends,
    description: &ModelDescription,
) -> Result<f64, Refused> {
    let refused =
        |why: &str| Refused::new(format!("`{}` cannot be `{value}`: {why}", param.name), takes(param, ends));
    let quantity = match value {
        GivenValue::Text(text) | GivenValue::String(text) => {
            quantity::parse(text, &description.known_units).map_err(|why| refused(&why))?
        }
        GivenValue::Number(value) => Quantity { value: *value, dimension: quantity::PURE, unit: false },
        GivenValue::Bool(_) => return Err(refused("it is a number")),
    };
    // A bare value is in the unit the default is written in.
    let value = if quantity.unit { quantity.value } else { to_si(quantity.value, param.unit.factor) };
    if quantity.unit && !quantity::fits(quantity.dimension, param.unit.dimension) {
        return Err(refused(&other_kind(param, quantity.dimension, &description.known_dimensions)));
    }
    if param.integral && value.fract() != 0.0 {
        return Err(refused("it must be a whole number"));
    }
    Ok(value)
}

/// Why a quantity of another dimension is not one of the param's.
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

fn check_range(param: &ParamDescription, value: f64, ends: Ends) -> Result<(), Refused> {
    if value.is_finite() && ends.0.is_none_or(|low| value >= low) && ends.1.is_none_or(|high| value <= high) {
        return Ok(());
    }
    let message = match domain(param, ends.0, ends.1) {
        range if range.is_empty() => format!("`{}` = {value} is not a finite number", param.name),
        range => format!("`{}` = {} is outside its range, {range}", param.name, shown(param, value)),
    };
    Err(Refused::new(message, "give a value within the range, or widen the range in the model"))
}

/// What a param takes, and how to give it.
fn takes(param: &ParamDescription, (low, high): Ends) -> String {
    let (name, unit) = (&param.name, &param.unit.name);
    let domain = match domain(param, low, high) {
        domain if domain.is_empty() && unit.is_empty() => "any number".to_owned(),
        domain if domain.is_empty() => format!("any value in {unit}"),
        domain => domain,
    };
    let example = match &param.default {
        Some(ParamValue::Bool(value)) => (if *value { "TRUE" } else { "FALSE" }).to_owned(),
        Some(ParamValue::String(value)) => value.clone(),
        Some(ParamValue::Number(si)) => shortest(from_si(*si, param.unit.factor)),
        None => return format!("`{name}` takes {domain}"),
    };
    let bare = if unit.is_empty() { String::new() } else { format!(", in {unit} if no unit is given") };
    format!("`{name}` takes {domain}, like `--set {name}={example}`{bare}")
}

/// The values a param allows, in the unit of its default; empty if any will do.
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

/// A number in the unit of the param's default.
pub fn shown(param: &ParamDescription, si: f64) -> String {
    format!("{} {}", shortest(from_si(si, param.unit.factor)), param.unit.name).trim_end().to_owned()
}

/// A number for people: what a conversion adds in the sixteenth digit is not shown.
pub fn shortest(value: f64) -> String {
    let rounded: f64 = format!("{value:.12e}").parse().unwrap_or(value);
    if rounded != 0.0 && !(1e-4..1e7).contains(&rounded.abs()) {
        format!("{rounded:e}")
    } else {
        format!("{rounded}")
    }
}
