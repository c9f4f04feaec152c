//! Quantities that the axes of a sweep vary: params of the model, and the fidelity level.

use super::axis::refused;
use crate::error::Error;
use crate::param_assignment::{AssignedValue, Origin};
use crate::params::{InvalidParam, Setting, index_of};
use calyx_abi::Repr;
use calyx_abi::description::{ModelDescription, ParamDescription, ParamValue};
use calyx_report::sweep::Column;
use calyx_runtime::scene::Fidelity;

/// Name of the fidelity level as an axis.
pub const FIDELITY: &str = "fidelity";

/// Quantity that an axis varies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Varied {
    /// Param, by its index in the model's description.
    Param(usize),
    /// Fidelity level of the analysis, if the model has no param called `fidelity`.
    Fidelity,
}

impl Varied {
    /// Returns the quantity with a name.
    ///
    /// # Errors
    /// The model has no such param.
    pub fn named(name: &str, description: &ModelDescription) -> Result<Varied, Error> {
        match index_of(description, name) {
            Ok(index) => Ok(Varied::Param(index)),
            Err(_) if name == FIDELITY => Ok(Varied::Fidelity),
            Err(error) => Err(error),
        }
    }

    pub fn name(self, description: &ModelDescription) -> &str {
        self.param(description).map_or(FIDELITY, |param| &param.name)
    }

    /// Returns the description of the param; `None` for the fidelity level.
    pub fn param(self, description: &ModelDescription) -> Option<&ParamDescription> {
        match self {
            Varied::Param(index) => description.params.get(index),
            Varied::Fidelity => None,
        }
    }

    /// Returns the column of the quantity in the table of a sweep.
    pub fn column(self, description: &ModelDescription) -> Column {
        self.param(description).map_or_else(
            || Column { name: FIDELITY.to_owned(), unit: String::new(), factor: 1.0, is_power: false },
            Column::from,
        )
    }

    /// Checks a value for the quantity, see [`Setting::new`].
    ///
    /// # Errors
    /// The value is invalid.
    pub(super) fn value(
        self,
        value: &AssignedValue,
        origin: Option<&Origin>,
        description: &ModelDescription,
    ) -> Result<ParamValue, Error> {
        if let Varied::Param(index) = self {
            return Setting::new(description, index, value, origin).map(|setting| setting.value);
        }
        let text = match value {
            AssignedValue::Text(text) | AssignedValue::String(text) => text.clone(),
            other => other.to_string(),
        };
        if Fidelity::named(&text).is_some() {
            return Ok(ParamValue::String(text));
        }
        let known = Fidelity::ALL.map(Fidelity::name).join(", ");
        let refused = InvalidParam::new(
            format!("there is no fidelity level called `{text}`"),
            format!("choose from {known}"),
        );
        Err(Error::Given(refused).placed(origin))
    }

    /// Returns all values of a text or Boolean param, or all fidelity levels.
    ///
    /// # Errors
    /// The param has no list of choices.
    pub(super) fn all_choices(self, description: &ModelDescription) -> Result<Vec<ParamValue>, Error> {
        let Some(param) = self.param(description) else {
            return Ok(Fidelity::ALL.map(|level| ParamValue::String(level.name().to_owned())).to_vec());
        };
        match param.repr {
            Repr::Bool => Ok(vec![ParamValue::Bool(false), ParamValue::Bool(true)]),
            Repr::String if !param.choices.is_empty() => {
                Ok(param.choices.iter().cloned().map(ParamValue::String).collect())
            }
            _ => Err(refused(
                format!("`{}` has no list of choices for `*`", param.name),
                format!("list its values, like `{}=A,B`, or give a range, `FROM..TO:COUNT`", param.name),
            )),
        }
    }
}
