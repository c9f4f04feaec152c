//! Setting a model's params: defaults, given values, ranges.

use crate::program::{ParamFunction, Program};
use crate::quantity;
use calyx_abi::description::{ModelDescription, ParamDescription, UnitDescription};
use calyx_abi::{Context, Repr, RuntimeError, Slot};

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
    context.params = vec![f64::NAN; description.params.len()];
    context.param_slots = vec![0; description.params.len()];
    for (index, param) in description.params.iter().enumerate() {
        let text = given.iter().rev().find(|(name, _)| *name == param.name).map(|(_, text)| text);
        let slot = match text {
            Some(text) => read(param, text, &description.known_units, context)?,
            None => program
                .param_function(index, ParamFunction::Default, context)
                .map_err(ParamError::Model)?
                .unwrap_or(f64::NAN.to_bits()),
        };
        context.param_slots[index] = slot;
        if param.repr == Repr::Number {
            context.params[index] = f64::from_bits(slot);
            check_range(program, index, param, context)?;
        }
    }
    Ok(())
}

fn given_error(message: String, help: String) -> ParamError {
    ParamError::Given { message, help }
}

fn unknown_param(name: &str, description: &ModelDescription) -> ParamError {
    let names: Vec<&str> = description.params.iter().map(|param| param.name.as_str()).collect();
    let help = if names.is_empty() {
        "the model has no params".to_owned()
    } else {
        format!("its params are {}", names.join(", "))
    };
    given_error(format!("the model has no param called `{name}`"), help)
}

fn read(
    param: &ParamDescription,
    text: &str,
    units: &[UnitDescription],
    context: &mut Context,
) -> Result<Slot, ParamError> {
    let name = &param.name;
    match &param.repr {
        Repr::Bool => match text.trim() {
            "TRUE" | "true" => Ok(1),
            "FALSE" | "false" => Ok(0),
            _ => Err(given_error(format!("`{name}` is TRUE or FALSE, not `{text}`"), String::new())),
        },
        Repr::String => {
            if !param.choices.is_empty() && !param.choices.iter().any(|choice| choice == text) {
                let message = format!("`{name}` cannot be \"{text}\"");
                return Err(given_error(message, format!("choose one of {}", quoted(&param.choices))));
            }
            Ok(context.heap.string(text))
        }
        _ => read_number(param, text, units).map(f64::to_bits),
    }
}

fn read_number(param: &ParamDescription, text: &str, units: &[UnitDescription]) -> Result<f64, ParamError> {
    let name = &param.name;
    let quantity = quantity::parse(text, units)
        .map_err(|why| given_error(format!("`{name}` cannot be `{text}`: {why}"), example(param)))?;
    // A bare value is in the unit the default is written in.
    let value = if quantity.unit { quantity.value } else { quantity.value * param.unit.factor };
    if quantity.unit && !quantity::fits(quantity.dimension, param.unit.dimension) {
        return Err(given_error(
            format!(
                "`{name}` cannot be `{text}`: that is not the same kind of quantity as {}",
                kind(&param.unit)
            ),
            example(param),
        ));
    }
    if param.integral && value.fract() != 0.0 {
        return Err(given_error(format!("`{name}` must be a whole number, not `{text}`"), String::new()));
    }
    Ok(value)
}

fn kind(unit: &UnitDescription) -> String {
    if unit.name.is_empty() {
        "a pure number".into()
    } else {
        format!("its default, which is in {}", unit.name)
    }
}

fn example(param: &ParamDescription) -> String {
    let (name, unit) = (&param.name, &param.unit.name);
    if unit.is_empty() {
        format!("give a number, like `--set {name}=2`")
    } else {
        format!("give it like `--set \"{name}=2 {unit}\"`; a bare number is in {unit}")
    }
}

fn quoted(choices: &[String]) -> String {
    choices.iter().map(|choice| format!("\"{choice}\"")).collect::<Vec<_>>().join(", ")
}

fn check_range(
    program: &dyn Program,
    index: usize,
    param: &ParamDescription,
    context: &mut Context,
) -> Result<(), ParamError> {
    let mut end = |which| {
        let slot = program.param_function(index, which, context).map_err(ParamError::Model)?;
        Ok(slot.map(f64::from_bits))
    };
    let (low, high) = (end(ParamFunction::Low)?, end(ParamFunction::High)?);
    let value = context.params[index];
    if !value.is_finite() || low.is_some_and(|low| value < low) || high.is_some_and(|high| value > high) {
        let shown = |si: f64| {
            format!("{} {}", shortest(si / param.unit.factor), param.unit.name).trim_end().to_owned()
        };
        let range = match (low, high) {
            (Some(low), Some(high)) => format!("{} .. {}", shown(low), shown(high)),
            (Some(low), None) => format!("{} or more", shown(low)),
            (None, Some(high)) => format!("{} or less", shown(high)),
            (None, None) => "a finite number".into(),
        };
        return Err(given_error(
            format!("`{}` = {} is outside its range, {range}", param.name, shown(value)),
            "give a value within the range, or widen the range in the model".into(),
        ));
    }
    Ok(())
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
