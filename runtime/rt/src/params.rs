//! Setting a model's params: defaults, given values, ranges.

use crate::program::{ParamFunction, Program};
use calyx_abi::description::{ModelDescription, ParamDescription, ParamValue, UnitDescription};
use calyx_abi::quantity;
use calyx_abi::units::{from_si, to_si};
use calyx_abi::{Context, Repr, RuntimeError, Slot};
use std::path::{Path, PathBuf};

/// Why a param could not be set.
#[derive(Clone, Debug, PartialEq)]
pub enum ParamError {
    /// What the user gave is not usable: message and remedy.
    Given { message: String, help: String },
    /// The model's own expression for a default or a range failed.
    Model(RuntimeError),
}

/// Fills `context.params` and `context.param_slots` from the defaults and from `given` (name and text, the last of a
/// name counts). Defaults are computed in order, so one that uses an earlier param follows its given value.
pub fn apply(
    program: &dyn Program,
    given: &[(String, String)],
    context: &mut Context,
) -> Result<(), ParamError> {
    let description = program.description();
    for (name, _) in given {
        if !description.params.iter().any(|param| param.name == *name) {
            return Err(unknown_param(name, description));
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
        let text = given.iter().rev().find(|(name, _)| *name == param.name).map(|(_, text)| text);
        let ends = range(program, index, param, context)?;
        let slot = match text {
            Some(text) => read(param, text, ends, &description.known_units, context)?,
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
            check_range(param, f64::from_bits(slot), ends)?;
        }
    }
    Ok(())
}

fn given_error(message: String, help: String) -> ParamError {
    ParamError::Given { message, help }
}

/// Splits `NAME=VALUE`; the error says what is wrong with it.
pub fn name_and_value(text: &str) -> Result<(String, String), String> {
    let (name, value) = text.split_once('=').ok_or("there is no `=`; give it like `--set torque=500`")?;
    Ok((name.trim().to_owned(), value.trim().to_owned()))
}

fn unknown_param(name: &str, description: &ModelDescription) -> ParamError {
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
    given_error(format!("the model has no param called `{name}`"), help)
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
        Ok(slot.map(f64::from_bits))
    };
    Ok((end(ParamFunction::Low)?, end(ParamFunction::High)?))
}

fn read(
    param: &ParamDescription,
    text: &str,
    ends: Ends,
    units: &[UnitDescription],
    context: &mut Context,
) -> Result<Slot, ParamError> {
    let name = &param.name;
    match &param.repr {
        Repr::Bool => match text.trim() {
            "TRUE" | "true" => Ok(1),
            "FALSE" | "false" => Ok(0),
            _ => Err(given_error(format!("`{name}` cannot be `{text}`"), takes(param, ends))),
        },
        Repr::String => {
            if !param.choices.is_empty() && !param.choices.iter().any(|choice| choice == text) {
                return Err(given_error(format!("`{name}` cannot be \"{text}\""), takes(param, ends)));
            }
            Ok(context.heap.string(text))
        }
        _ => read_number(param, text, ends, units).map(f64::to_bits),
    }
}

fn read_number(
    param: &ParamDescription,
    text: &str,
    ends: Ends,
    units: &[UnitDescription],
) -> Result<f64, ParamError> {
    let refused =
        |why: &str| given_error(format!("`{}` cannot be `{text}`: {why}", param.name), takes(param, ends));
    let quantity = quantity::parse(text, units).map_err(|why| refused(&why))?;
    // A bare value is in the unit the default is written in.
    let value = if quantity.unit { quantity.value } else { to_si(quantity.value, param.unit.factor) };
    if quantity.unit && !quantity::fits(quantity.dimension, param.unit.dimension) {
        return Err(refused(&match param.unit.name.as_str() {
            "" => "it is a pure number, without a unit".to_owned(),
            unit => format!("its default is in {unit}, and that is another kind of quantity"),
        }));
    }
    if param.integral && value.fract() != 0.0 {
        return Err(refused("it must be a whole number"));
    }
    Ok(value)
}

fn check_range(param: &ParamDescription, value: f64, ends: Ends) -> Result<(), ParamError> {
    if value.is_finite() && ends.0.is_none_or(|low| value >= low) && ends.1.is_none_or(|high| value <= high) {
        return Ok(());
    }
    let message = match domain(param, ends.0, ends.1) {
        range if range.is_empty() => format!("`{}` = {value} is not a finite number", param.name),
        range => format!("`{}` = {} is outside its range, {range}", param.name, shown(param, value)),
    };
    Err(given_error(message, "give a value within the range, or widen the range in the model".into()))
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
