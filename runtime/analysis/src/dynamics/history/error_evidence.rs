//! Data for the error estimates of a transient analysis: the same motion with longer steps, on
//! other meshes and grids, and observed rounding.

use super::History;
use crate::estimate::{self, BaseMotion, Estimates, Evidence};
use crate::options::AnalysisOptions;
use crate::rows::StepRow;
use crate::scene::Scene;
use calyx_model::fidelity::{Fidelity, StructureOptions};
use calyx_model::observed::Observed;
use calyx_model::position::Position;
use calyx_numerics::error::EngineError;
use calyx_solve::integration::{State, doubled_steps};

/// Number of steps over the duration of an impulse that transmits its momentum, exactly if the
/// number is an integer.
const STEPS_PER_IMPULSE: f64 = 2.0;

impl History<'_> {
    /// Collects the data for the error estimates.
    ///
    /// # Errors
    /// Those of the interrupt; other failures leave a part unestimated.
    pub(super) fn evidence(&mut self, rows: &[StepRow]) -> Result<Evidence, EngineError> {
        let dynamics = self.options.clone();
        let longer = match self.with_steps_doubled_twice() {
            Ok(rows) => rows,
            Err(error) => {
                self.resources.interrupt.check()?;
                Err(format!("{}: {}", error.code, error.message))
            }
        };
        let scene = self.scene;
        let turned = |scene: &Scene, fidelity: Fidelity, structure: StructureOptions| {
            let options = AnalysisOptions {
                fidelity,
                structure,
                error_estimates: Estimates::None,
                ..self.analysis.clone()
            };
            let mut history = History::new(scene, self.outputs, &options, &dynamics, &mut ())?;
            history.with_doubled_steps().map(Result::unwrap_or_default)
        };
        let moved = BaseMotion {
            scene,
            fidelity: self.plan.fidelity,
            structure: self.analysis.structure,
            outputs: self.outputs,
            interrupt: &self.resources.interrupt,
            rows,
            second_order: self.options.scheme.gamma == 0.5,
            longer,
            turned: &turned,
        };
        let evidence = moved.perturbed_solves(self.analysis.error_estimates)?;
        Ok(Evidence { rounding: self.rounding.clone().unwrap_or_default(), ..evidence })
    }

    /// Repeats the motion with steps of two and four times the length.
    fn with_steps_doubled_twice(&mut self) -> Result<Result<[Vec<StepRow>; 2], String>, EngineError> {
        let longer = match self.with_doubled_steps()? {
            Ok(rows) => rows,
            Err(reason) => return Ok(Err(reason)),
        };
        Ok(self.with_doubled_steps()?.map(|longest| [longer, longest]))
    }

    /// Restarts with steps of twice the length; returns the rows, or the reason why such steps are
    /// unsuitable.
    fn with_doubled_steps(&mut self) -> Result<Result<Vec<StepRow>, String>, EngineError> {
        let longer = doubled_steps(&self.steps, &self.options.ranges);
        if longer.len() == self.steps.len() {
            return Ok(Err("of single steps no two make one".to_owned()));
        }
        let longest = longer.iter().map(|step| step.length).fold(0.0, f64::max);
        let is_filled = |duration: f64| {
            let steps = duration / longest;
            steps > STEPS_PER_IMPULSE - 1e-6 && (steps - steps.round()).abs() < 1e-6 * steps
        };
        let impulses = self.system.scene.bodies.iter().flat_map(|body| &body.impulses);
        if !impulses.into_iter().all(|impulse| is_filled(impulse.duration)) {
            return Ok(Err("the duration of an impulse is not a multiple of twice the time step".to_owned()));
        }
        let count = self.state.displacement.len();
        let start = Position::at(self.options.from);
        let kept = longer.iter().filter(|step| step.kept).map(|step| Position::at(step.time));
        self.positions = std::iter::once(start).chain(kept).collect();
        self.options.ranges.iter_mut().for_each(|range| range.steps = range.steps.div_ceil(2));
        (self.steps, self.taken, self.failed) = (longer, 0, false);
        (self.state, self.contact) = (State::at_rest(vec![0.0; count]), vec![0.0; count]);
        (self.solved, self.current) = (Vec::new(), None);
        self.rounding = Some(vec![0.0; self.outputs.len()]);
        let rows: Result<Vec<StepRow>, EngineError> = self.map(|solved| Ok(solved?.row)).collect();
        rows.map(Ok)
    }

    /// Records the magnitudes up to which outputs may consist of rounding.
    pub(super) fn note_rounding(&mut self, observed: &[Observed], time: f64) {
        let Some(rounding) = &mut self.rounding else { return };
        let own = estimate::rounding_of(self.scene, self.outputs, observed, time);
        rounding.iter_mut().zip(own).for_each(|(most, own)| *most = most.max(own));
    }
}
