//! Values of names after elaboration: of params, and of variables at the end of the top level.

use crate::shown::{in_unit, rounded};
use calyx_abi::description::{ParamDescription, ParamValue};
use calyx_abi::units::from_si;
use calyx_abi::{Context, Repr, Slot};
use calyx_lang::dimension::Dimension;
use calyx_lang::ir::{DisplayUnit, Program};
use calyx_lang::units::UnitSystem;
use std::collections::BTreeMap;

/// The final value of a top-level variable. Numbers are in SI units; the variable's type has the
/// dimension.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    Number(f64),
    Vector([f64; 3]),
    Bool(bool),
    Text(String),
}

impl Value {
    /// Returns the value in the units of a file; `None` if its dimension involves one that the
    /// model declares.
    pub fn shown(&self, dimension: Dimension, system: &str) -> Option<String> {
        let unit = || {
            let system = UnitSystem::from_name(system).unwrap_or(UnitSystem::Si);
            dimension.is_physics().then(|| system.unit_of(dimension))
        };
        Some(match self {
            Value::Number(number) => in_unit(*number, &unit()?),
            Value::Vector(vector) => {
                let unit = unit()?;
                let parts = vector.map(|number| rounded(from_si(number, unit.factor)));
                format!("({}) {}", parts.join(", "), unit.name).trim_end().to_owned()
            }
            Value::Bool(true) => "TRUE".into(),
            Value::Bool(false) => "FALSE".into(),
            Value::Text(text) => format!("{text:?}"),
        })
    }
}

/// Returns the default of a param, in the unit in which the model writes it.
pub fn default_of(param: &ParamDescription) -> Option<String> {
    Some(match param.default.as_ref()? {
        ParamValue::Number(number) => of_param(*number, param),
        ParamValue::Bool(true) => "TRUE".into(),
        ParamValue::Bool(false) => "FALSE".into(),
        ParamValue::String(text) => format!("{text:?}"),
        ParamValue::Numbers(numbers) => {
            let numbers: Vec<String> = numbers.iter().map(|number| of_param(*number, param)).collect();
            format!("[{}]", numbers.join(", "))
        }
    })
}

/// Returns the range of a param in the unit of its default, or its choices; `None` if it has
/// neither.
pub fn range_of(param: &ParamDescription) -> Option<String> {
    if !param.choices.is_empty() {
        let choices: Vec<String> = param.choices.iter().map(|choice| format!("{choice:?}")).collect();
        return Some(choices.join(", "));
    }
    let end = |end: Option<f64>| end.map(|end| of_param(end, param)).unwrap_or_default();
    (param.low.is_some() || param.high.is_some())
        .then(|| format!("{} .. {}", end(param.low), end(param.high)).trim().to_owned())
}

fn of_param(number: f64, param: &ParamDescription) -> String {
    let unit = &param.unit;
    in_unit(number, &DisplayUnit { name: unit.name.clone(), factor: unit.factor, dimension: unit.dimension })
}

/// Returns the top-level variables by name, from the final slots of the top-level function. Omits
/// names of several variables with different values, for example in separate blocks.
pub(crate) fn of_top_level(program: &Program, slots: &[Slot], context: &Context) -> BTreeMap<String, Value> {
    let Some(main) = program.functions.get(program.main.0 as usize) else { return BTreeMap::new() };
    let (mut values, mut at) = (BTreeMap::new(), 0);
    for local in &main.locals {
        let own = slots.get(at..at + local.repr.slots()).unwrap_or_default();
        at += local.repr.slots();
        let value = value(&local.repr, own, context);
        // A value captured by `:=` has the name of the original variable.
        let known = values.entry(local.name.clone()).or_insert_with(|| value.clone());
        if *known != value {
            *known = None;
        }
    }
    values.into_iter().filter_map(|(name, value)| Some((name, value?))).collect()
}

fn value(repr: &Repr, slots: &[Slot], context: &Context) -> Option<Value> {
    let number = |slot: &Slot| f64::from_bits(*slot);
    match (repr, slots) {
        (Repr::Number, [slot]) => Some(Value::Number(number(slot))),
        (Repr::Vector, [x, y, z]) => Some(Value::Vector([x, y, z].map(number))),
        (Repr::Bool, [slot]) => Some(Value::Bool(*slot != 0)),
        (Repr::String, [slot]) => context.heap.str(*slot).map(|text| Value::Text(text.to_owned())),
        _ => None,
    }
}
