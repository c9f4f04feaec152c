//! Samples of toleranced params, and objectives: what a study asks for.

use serde::{Deserialize, Serialize};

/// Method by which toleranced params are sampled.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Method {
    /// Plain Latin hypercube: each of N equally probable intervals of a param has one sample.
    #[default]
    LatinHypercube,
    /// Scrambled Sobol points.
    Sobol,
    /// Independent random points.
    Random,
}

impl Method {
    pub const ALL: [Method; 3] = [Method::LatinHypercube, Method::Sobol, Method::Random];

    pub fn name(self) -> &'static str {
        match self {
            Method::LatinHypercube => "latin_hypercube",
            Method::Sobol => "sobol",
            Method::Random => "random",
        }
    }

    pub fn named(name: &str) -> Option<Method> {
        Method::ALL.into_iter().find(|method| method.name() == name)
    }

    /// Describes the method in a sentence.
    pub fn described(self) -> &'static str {
        match self {
            Method::LatinHypercube => "Latin hypercube",
            Method::Sobol => "scrambled Sobol points",
            Method::Random => "independent random samples",
        }
    }
}

/// Sample of toleranced params. They are the last params of the table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sample {
    pub method: Method,
    pub seed: u64,
    /// Number of samples.
    pub count: usize,
    /// Distributions by param, as text.
    pub distributions: Vec<String>,
}

/// Statistic of an output over the positions of a case.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Statistic {
    Min,
    Mean,
    Max,
    PeakToPeak,
}

impl Statistic {
    pub const ALL: [Statistic; 4] = [Statistic::Min, Statistic::Mean, Statistic::Max, Statistic::PeakToPeak];

    pub fn name(self) -> &'static str {
        match self {
            Statistic::Min => "min",
            Statistic::Mean => "mean",
            Statistic::Max => "max",
            Statistic::PeakToPeak => "peak_to_peak",
        }
    }

    pub fn named(name: &str) -> Option<Statistic> {
        Statistic::ALL.into_iter().find(|statistic| statistic.name() == name)
    }

    /// Returns the name in a sentence.
    pub fn described(self) -> &'static str {
        match self {
            Statistic::Min => "least value",
            Statistic::Mean => "mean value",
            Statistic::Max => "largest value",
            Statistic::PeakToPeak => "peak to peak",
        }
    }
}

/// Objective of a study.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Objective {
    pub output: String,
    pub statistic: Statistic,
    /// True if larger values are better.
    pub maximize: bool,
}
