//! Sensitivities: derivatives of outputs and of their statistics with respect to params.
//!
//! A program that knows the model at other values of its params ([`Neighbours`]) provides the
//! scenes. Their positions are solved in the state of contact of the analysis: the same cells carry
//! force, and so the values are a smooth function of the param, which central differences of two
//! widths differentiate to many digits. Structures that do not depend on the param are shared.
//!
//! See `docs/theory/sensitivities.md`.

mod differences;
mod statistics;

pub use differences::{Derivative, Side};
pub use statistics::StatisticDerivatives;

pub(crate) use differences::Stencil;
pub(crate) use statistics::of as statistics_of;

use crate::scene::Scene;
use calyx_model::observed::{Observed, OutputRequest};
use calyx_model::position::Position;
use calyx_numerics::error::EngineError;
use std::fmt::{self, Debug, Formatter};
use std::io;
use std::sync::Arc;

/// Widths of differences, relative to the scale of the param, in the order in which they are tried.
const WIDTHS: [f64; 4] = [1e-4, 1e-5, 1e-6, 1e-7];
/// The same where noise of the values prevails, as of meshes that are generated again.
const WIDE: f64 = 1e-3;
/// Estimated error, relative to the largest derivative of an output, at which no narrower width is
/// tried.
const ACCURATE: f64 = 1e-6;

/// Ratio of the errors of two widths above which a narrower one is not worth its time.
const WORTHWHILE: f64 = 0.5;

/// Model at other values of its params.
pub struct Neighbour {
    /// The scene.
    pub scene: Scene,
    /// Positions of the analysis.
    pub positions: Vec<Position>,
    /// Requested outputs.
    pub outputs: Vec<OutputRequest>,
}

/// Source of a model at other values of its params.
pub trait Neighbours: Send + Sync {
    /// Builds the model with another value (SI) of the param of an index.
    ///
    /// # Errors
    /// The model cannot be built with this value.
    fn at(&self, param: usize, value: f64) -> Result<Neighbour, EngineError>;
}

/// Storage of derivatives by param, from which an interrupted analysis continues.
pub trait SensitivityStore: Send + Sync {
    /// Returns the stored derivatives with respect to a param at its value; `None` without any. The
    /// derivatives of statistics may be missing.
    fn find(&self, param: &VariedParam) -> Option<Sensitivity>;

    /// Stores the derivatives with respect to a param.
    ///
    /// # Errors
    /// They cannot be written.
    fn store(&self, found: &Sensitivity) -> io::Result<()>;
}

/// Param with respect to which outputs are differentiated.
#[derive(Clone, Debug, PartialEq)]
pub struct VariedParam {
    /// Index for [`Neighbours::at`].
    pub index: usize,
    /// Name.
    pub name: String,
    /// Value in the analysis, SI.
    pub value: f64,
    /// Smallest and largest permitted value, SI; infinite without limits.
    pub range: [f64; 2],
}

impl VariedParam {
    /// Returns the size of changes that are not small: the value or, if it is smaller, the range.
    pub fn scale(&self) -> f64 {
        let width = self.range[1] - self.range[0];
        let sizes = [self.value.abs(), width];
        let known = sizes.into_iter().filter(|size| size.is_finite() && *size > 0.0);
        known.reduce(f64::min).unwrap_or(1e-3)
    }
}

/// Request for the derivatives of outputs with respect to some params.
#[derive(Clone)]
pub struct SensitivityRequest {
    /// Source of the models.
    pub neighbours: Arc<dyn Neighbours>,
    /// The params.
    pub params: Vec<VariedParam>,
    /// Names of the outputs to differentiate, that of an array for all its elements; empty for all
    /// outputs. Derivatives of others may be NaN.
    pub outputs: Vec<String>,
    /// Storage of derivatives, which receives them as soon as they are found.
    pub store: Option<Arc<dyn SensitivityStore>>,
}

impl SensitivityRequest {
    /// Returns for each output of a list whether it is differentiated.
    pub fn differentiated(&self, outputs: &[OutputRequest]) -> Vec<bool> {
        let is_requested =
            |output: &OutputRequest| self.outputs.iter().any(|name| is_named(&output.name, name));
        outputs.iter().map(|output| self.outputs.is_empty() || is_requested(output)).collect()
    }

    /// Returns the stored derivatives with respect to a param.
    pub(crate) fn find(&self, param: &VariedParam) -> Option<Sensitivity> {
        self.store.as_ref()?.find(param)
    }

    /// Stores the derivatives with respect to a param, unless they failed.
    pub(crate) fn store(&self, found: &Sensitivity) -> Result<(), EngineError> {
        let Some(store) = self.store.as_ref().filter(|_| found.failure.is_none()) else { return Ok(()) };
        store.store(found).map_err(|error| {
            EngineError::new(
                "E0712",
                format!("derivatives cannot be stored: {error}"),
                "free space on the disk",
            )
        })
    }
}

/// Returns whether a name is that of an output, or of the array of which it is an element.
pub fn is_named(output: &str, name: &str) -> bool {
    output.strip_prefix(name).is_some_and(|rest| rest.is_empty() || rest.starts_with('['))
}

impl Debug for SensitivityRequest {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("SensitivityRequest").field("params", &self.params).finish_non_exhaustive()
    }
}

/// How derivatives with respect to a param were computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The param changes no structure, or closed forms only: all stored structures and the state of
    /// contact are kept.
    SameStructures,
    /// The param changes structures, which are built again at each value (semi-analytic).
    ChangedStructures,
}

/// Derivatives of all outputs with respect to a param.
#[derive(Clone, Debug)]
pub struct Sensitivity {
    /// The param.
    pub param: VariedParam,
    /// Half width of the differences, SI.
    pub width: f64,
    /// How the derivatives were computed.
    pub kind: Kind,
    /// By position and output.
    pub positions: Vec<Vec<Derivative>>,
    /// Derivatives of the means over the positions, by output.
    pub means: Vec<Derivative>,
    /// Derivatives of the statistics, by output.
    pub statistics: Vec<StatisticDerivatives>,
    /// Reason why there are no derivatives, E0792; `positions` and `statistics` are empty then.
    pub failure: Option<EngineError>,
}

/// Differentiates the outputs of a model without an analysis with respect to each param. `at`
/// computes the outputs with another value (SI) of the param of an index, `values` are the outputs,
/// of which some are `requested`.
///
/// # Errors
/// Those of `interrupt`.
pub fn of_calculation(
    params: &[VariedParam],
    (values, requested): (&[Observed], &[bool]),
    at: impl Fn(usize, f64) -> Result<Vec<Observed>, EngineError>,
    interrupt: impl Fn() -> Result<(), EngineError>,
) -> Result<Vec<Sensitivity>, EngineError> {
    let of_param = |param: &VariedParam| {
        let differences = |stencil: &Stencil| {
            let beside = stencil.values().into_iter().map(|value| at(param.index, value).map(Some));
            let beside = beside.collect::<Result<Vec<_>, EngineError>>()?;
            let derivatives = stencil.derivatives(values, &beside);
            Ok(Sensitivity {
                param: param.clone(),
                width: stencil.width(),
                kind: Kind::SameStructures,
                means: derivatives.clone(),
                positions: vec![derivatives],
                statistics: Vec::new(),
                failure: None,
            })
        };
        let found = narrowed(param, requested, differences, &interrupt)?;
        let statistics = found.positions.iter().flatten().map(StatisticDerivatives::of_constant).collect();
        Ok(Sensitivity { statistics, ..found })
    };
    params.iter().map(of_param).collect()
}

/// Differentiates with narrowing differences until those of the `requested` outputs are accurate.
pub(crate) fn narrowed(
    param: &VariedParam,
    requested: &[bool],
    differences: impl Fn(&Stencil) -> Result<Sensitivity, EngineError>,
    interrupt: impl Fn() -> Result<(), EngineError>,
) -> Result<Sensitivity, EngineError> {
    let mut best: Option<Sensitivity> = None;
    let mut failed = None;
    let mut widths = WIDTHS.into_iter();
    let mut next = widths.next();
    while let Some(relative) = next.take() {
        next = widths.next();
        let Some(stencil) = Stencil::new(param.value, relative * param.scale(), param.range) else {
            continue;
        };
        let found = match differences(&stencil) {
            Ok(found) => found.with_pooled_errors(),
            Err(error) => {
                interrupt()?;
                failed = failed.or(Some(error));
                continue;
            }
        };
        let former = best.as_ref().map(|best| best.largest_relative_error(requested));
        let found = match best.take() {
            Some(best) => best.with_better(found),
            None => found,
        };
        let error = found.largest_relative_error(requested);
        best = Some(found);
        if error <= ACCURATE || relative == WIDE {
            break;
        }
        // A narrower width was hardly better: noise prevails.
        if former.is_some_and(|former| error > WORTHWHILE * former && former.is_finite()) {
            next = Some(WIDE);
        }
    }
    let failure = || failed.map_or_else(|| fixed(param), |error| beside(param, error));
    Ok(best.unwrap_or_else(|| Sensitivity {
        param: param.clone(),
        width: 0.0,
        kind: Kind::SameStructures,
        positions: Vec::new(),
        means: Vec::new(),
        statistics: Vec::new(),
        failure: Some(failure()),
    }))
}

impl Sensitivity {
    /// Raises the estimated errors of each output to the root of their mean square over the
    /// positions: noise may be equal in both differences of a position by chance.
    fn with_pooled_errors(mut self) -> Sensitivity {
        let outputs = self.positions.first().map_or(0, Vec::len);
        for output in 0..outputs {
            let known = self.positions.iter().map(|row| row[output]).filter(|one| one.error.is_finite());
            // Errors at kinks are those of one-sided differences.
            let errors: Vec<f64> = known.filter(|one| !one.is_kink()).map(|one| one.error).collect();
            if errors.is_empty() {
                continue;
            }
            let square = errors.iter().map(|error| error * error).sum::<f64>() / errors.len() as f64;
            for row in &mut self.positions {
                let error = &mut row[output].error;
                // An unknown derivative remains unknown.
                *error = if error.is_nan() { *error } else { error.max(square.sqrt()) };
            }
        }
        self
    }

    /// Returns the largest estimated error of a derivative of the `requested` outputs beyond
    /// rounding, relative to the largest derivative of its output over all positions.
    fn largest_relative_error(&self, requested: &[bool]) -> f64 {
        let of_output = |output: usize| {
            let all = || self.positions.iter().map(move |row| &row[output]);
            let largest = all().map(Derivative::magnitude).fold(0.0, f64::max);
            let beyond = |derivative: &Derivative| derivative.error > 2.0 * derivative.rounding;
            let error = all().filter(|one| beyond(one)).map(|one| one.error).fold(0.0, f64::max);
            // Where the state of contact is lost, the error is unknown.
            if all().any(|one| one.error.is_nan()) {
                return f64::INFINITY;
            }
            if error == 0.0 { 0.0 } else { error / largest }
        };
        let outputs = (0..requested.len()).filter(|&output| requested[output]);
        outputs.map(of_output).fold(0.0, f64::max)
    }

    /// Replaces derivatives by those of another width that have smaller estimated errors.
    fn with_better(mut self, other: Sensitivity) -> Sensitivity {
        let own = self.positions.iter_mut().flatten().chain(&mut self.means);
        for (own, other) in own.zip(other.positions.into_iter().flatten().chain(other.means)) {
            if other.is_better_than(own) {
                *own = other;
            }
        }
        Sensitivity { width: other.width, ..self }
    }
}

/// Derivatives do not exist because the model fails next to the value of the param.
fn beside(param: &VariedParam, error: EngineError) -> EngineError {
    let name = &param.name;
    if error.code == "E0792" {
        return error;
    }
    EngineError::new(
        "E0792",
        format!(
            "next to its value of `{name}` the model has no solution: {} ({})",
            error.message, error.code
        ),
        format!("leave out `{name}`, or choose a value in the interior of its valid range"),
    )
}

fn fixed(param: &VariedParam) -> EngineError {
    let name = &param.name;
    EngineError::new(
        "E0792",
        format!("the range of `{name}` is a single value"),
        format!("leave out `{name}`, or widen its range"),
    )
}

pub(crate) fn other_positions(param: &VariedParam) -> EngineError {
    EngineError::new(
        "E0792",
        format!("the number of positions or outputs depends on `{}`", param.name),
        "leave out this param",
    )
}
