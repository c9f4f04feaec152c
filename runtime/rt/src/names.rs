//! Params and outputs of a model by name, or by a handle that avoids the lookup.

use crate::error::Error;
use crate::params::{index_of, output_of};
use calyx_abi::description::{ModelDescription, UnitDescription};
use std::hash::{DefaultHasher, Hash, Hasher};

/// Handle of a param. It is valid for every instance of the model, and for every model with the
/// same params and outputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Param {
    index: usize,
    model: u64,
}

/// Handle of an output. It is valid for the results of every instance of the model, and for every
/// model with the same params and outputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Output {
    index: usize,
    model: u64,
}

impl Param {
    /// Looks up a param by name.
    ///
    /// # Errors
    /// The model has no such param.
    pub fn named(description: &ModelDescription, name: &str) -> Result<Param, Error> {
        Ok(Param { index: index_of(description, name)?, model: shape(description) })
    }

    /// Returns the index into [`ModelDescription::params`].
    pub fn index(self) -> usize {
        self.index
    }
}

impl Output {
    /// Looks up an output by name.
    ///
    /// # Errors
    /// The model has no such output.
    pub fn named(description: &ModelDescription, name: &str) -> Result<Output, Error> {
        Ok(Output { index: output_of(description, name)?, model: shape(description) })
    }

    /// Returns the index into [`ModelDescription::outputs`].
    pub fn index(self) -> usize {
        self.index
    }
}

/// A model with the shape that distinguishes its handles from those of other models.
#[derive(Clone, Copy)]
pub struct Names<'m> {
    pub(crate) description: &'m ModelDescription,
    pub(crate) shape: u64,
}

/// Name of a param: a text or a [`Param`].
pub trait ParamName: Copy {
    /// Returns the index into [`ModelDescription::params`].
    ///
    /// # Errors
    /// The model has no such param.
    fn index_in(self, names: Names) -> Result<usize, Error>;
}

/// Name of an output: a text or an [`Output`].
pub trait OutputName: Copy {
    /// Returns the index into [`ModelDescription::outputs`].
    ///
    /// # Errors
    /// The model has no such output.
    fn index_in(self, names: Names) -> Result<usize, Error>;
}

impl ParamName for &str {
    fn index_in(self, names: Names) -> Result<usize, Error> {
        index_of(names.description, self)
    }
}

impl ParamName for &String {
    fn index_in(self, names: Names) -> Result<usize, Error> {
        index_of(names.description, self)
    }
}

impl ParamName for Param {
    fn index_in(self, names: Names) -> Result<usize, Error> {
        if self.model == names.shape { Ok(self.index) } else { Err(foreign("param", names)) }
    }
}

impl OutputName for &str {
    fn index_in(self, names: Names) -> Result<usize, Error> {
        output_of(names.description, self)
    }
}

impl OutputName for &String {
    fn index_in(self, names: Names) -> Result<usize, Error> {
        output_of(names.description, self)
    }
}

impl OutputName for Output {
    fn index_in(self, names: Names) -> Result<usize, Error> {
        if self.model == names.shape { Ok(self.index) } else { Err(foreign("output", names)) }
    }
}

fn foreign(what: &str, names: Names) -> Error {
    Error::given(
        format!("the {what} is one of another model, and this is `{}`", names.description.name),
        format!("ask this model for the {what} by its name"),
    )
}

/// Hashes the names and units of a model's params and outputs. Handles of one model are valid for
/// another if the hashes are equal.
pub(crate) fn shape(description: &ModelDescription) -> u64 {
    let mut hasher = DefaultHasher::new();
    let mut add = |name: &str, unit: &UnitDescription| {
        (name, &unit.name, unit.factor.to_bits()).hash(&mut hasher);
    };
    description.params.iter().for_each(|param| add(&param.name, &param.unit));
    add("", &UnitDescription::default());
    description.outputs.iter().for_each(|output| add(&output.name, &output.unit));
    hasher.finish()
}
