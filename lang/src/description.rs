//! The description of a program, derived from the typed program. `--help`, results, executables and
//! embedding programs read it.

use crate::dimension::Dimension;
use crate::ir::{DisplayUnit, HostValue, Program};
use crate::units::Unit;
use calyx_abi::Fingerprint;
use calyx_abi::description::{
    CaptureDescription, DimensionDescription, FileDescription, HostFunctionDescription, HostValueDescription,
    KernelDescription, ModelDescription, OutputDescription, ParamDescription, UnitDescription,
};

/// Describes a program for an engine with this fingerprint. Defaults and ranges of params, tables
/// and calls are empty; elaboration sets them.
pub fn describe(program: &Program, abi: Fingerprint) -> ModelDescription {
    let description = ModelDescription {
        abi,
        name: program.files.first().map(|file| file.name.clone()).unwrap_or_default(),
        doc: program.doc.clone(),
        allowed: program.allowed.clone(),
        units: program.units.clone(),
        params: program
            .params
            .iter()
            .map(|param| ParamDescription {
                name: param.name.clone(),
                doc: param.doc.clone(),
                repr: param.repr.clone(),
                unit: unit(&param.unit),
                integral: param.integral,
                choices: param.choices.clone(),
                default: None,
                low: None,
                high: None,
                independent: false,
            })
            .collect(),
        outputs: program
            .outputs
            .iter()
            .map(|output| OutputDescription {
                name: output.name.clone(),
                doc: output.doc.clone(),
                site: output.site.0 as usize,
                unit: unit(&output.unit),
                si: output.si.clone(),
                is_array: output.is_array,
                choices: output.choices.clone(),
            })
            .collect(),
        declared_outputs: Vec::new(),
        host_functions: program
            .host_functions
            .iter()
            .map(|function| HostFunctionDescription {
                name: function.name.clone(),
                doc: function.doc.clone(),
                parameters: function.parameters.iter().map(host_value).collect(),
                result: host_value(&function.result),
            })
            .collect(),
        kernels: program
            .sites
            .iter()
            .map(|site| KernelDescription {
                name: site.name.clone(),
                repr: site.repr.clone(),
                order: site.order,
                inputs: site.inputs(program),
                outputs: site.outputs(program),
                captures: site
                    .captures
                    .iter()
                    .map(|capture| CaptureDescription {
                        name: capture.name.clone(),
                        repr: capture.repr.clone(),
                        observable: capture.observable,
                    })
                    .collect(),
            })
            .collect(),
        files: program
            .files
            .iter()
            .map(|file| FileDescription { name: file.name.clone(), text: file.text.clone() })
            .collect(),
        known_units: Unit::all()
            .iter()
            .flat_map(|unit| unit.aliases.iter().chain([&unit.name]).map(move |name| (name, unit)))
            .map(|(name, unit)| UnitDescription {
                name: (*name).to_owned(),
                factor: unit.factor,
                dimension: unit.dimension.exponents(),
            })
            .chain(program.own_units.iter().map(unit))
            .collect(),
        known_dimensions: dimensions(program),
        tables: [].into(),
        calls: Vec::new(),
    };
    // Elaboration determines the number of elements of arrays.
    let declared_outputs = match program.outputs.iter().any(|output| output.is_array) {
        true => description.outputs.clone(),
        false => Vec::new(),
    };
    ModelDescription { declared_outputs, ..description }
}

fn dimensions(program: &Program) -> Vec<DimensionDescription> {
    let known = Dimension::named().map(|(name, dimension)| (name.to_owned(), dimension.exponents()));
    let all = known.chain(program.own_dimensions.iter().cloned());
    all.map(|(name, exponents)| DimensionDescription { name, exponents }).collect()
}

fn host_value(value: &HostValue) -> HostValueDescription {
    HostValueDescription {
        name: value.name.clone(),
        repr: value.repr.clone(),
        ty: value.ty.clone(),
        unit: unit(&value.unit),
    }
}

fn unit(unit: &DisplayUnit) -> UnitDescription {
    UnitDescription { name: unit.name.clone(), factor: unit.factor, dimension: unit.dimension }
}

/// Returns the description as JSON.
pub fn to_json(description: &ModelDescription) -> serde_json::Result<String> {
    serde_json::to_string(description)
}

/// Parses the output of [`to_json`].
pub fn from_json(text: &str) -> serde_json::Result<ModelDescription> {
    serde_json::from_str(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An executable converts quantities with the units of its description, so an inexact factor
    /// would change every result.
    #[test]
    fn the_description_comes_back_to_the_last_bit() {
        let described = describe(&Program::default(), Fingerprint::default());
        assert!(described.known_units.len() > 50);
        let json = to_json(&described).unwrap();
        assert_eq!(from_json(&json).unwrap(), described);
        // Numbers that a fast, inexact decimal parser reads incorrectly, and plain ones.
        for number in [6894.757293168361, 1e23, 8.533e68, 0.1 + 0.2, 4.35e-31, f64::MIN_POSITIVE] {
            assert_eq!(
                serde_json::from_str::<f64>(&serde_json::to_string(&number).unwrap()).unwrap(),
                number
            );
        }
        let mut state = 1_u64;
        for _ in 0..10_000 {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            let number = (state >> 11) as f64 / 7.0e12;
            assert_eq!(
                serde_json::from_str::<f64>(&serde_json::to_string(&number).unwrap()).unwrap(),
                number
            );
        }
    }
}
