//! Params and outputs of a model by name, or by a handle that spares looking the name up.

use crate::error::Error;
use crate::params::{index_of, output_of};
use calyx_abi::description::{ModelDescription, UnitDescription};
use std::hash::{DefaultHasher, Hash, Hasher};

/// A param of a model. It fits every instance of the model, and of every model with the same params and outputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Param {
    index: usize,
    model: u64,
}

/// An output of a model. It fits the results of every instance of the model, and of every model with the same params and
/// outputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Output {
    index: usize,
    model: u64,
}

impl Param {
    /// # Errors
    /// The model has no such param.
    pub fn named(description: &ModelDescription, name: &str) -> Result<Param, Error> {
        Ok(Param { index: index_of(description, name)?, model: shape(description) })
    }

    /// Its place in [`ModelDescription::params`].
    pub fn index(self) -> usize {
        self.index
    }
}

impl Output {
    /// # Errors
    /// The model has no such output.
    pub fn named(description: &ModelDescription, name: &str) -> Result<Output, Error> {
        Ok(Output { index: output_of(description, name)?, model: shape(description) })
    }

    /// Its place in [`ModelDescription::outputs`].
    pub fn index(self) -> usize {
        self.index
    }
}

/// A model, and what tells its handles from those of others.
#[derive(Clone, Copy)]
pub struct Names<'m> {
    pub(crate) description: &'m ModelDescription,
    pub(crate) shape: u64,
}

/// Names a param: a text, or a [`Param`].
pub trait ParamName: Copy {
    /// Its place in [`ModelDescription::params`].
    ///
    /// # Errors
    /// The model has no such param.
    fn index_in(self, names: Names) -> Result<usize, Error>;
}

/// Names an output: a text, or an [`Output`].
pub trait OutputName: Copy {
    /// Its place in [`ModelDescription::outputs`].
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

/// Names and units of a model's params and outputs as one number: equal where a handle of one model fits another.
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
