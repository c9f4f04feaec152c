//! Validation of a requested analysis: everything that can be decided before a structure is built.
//!
//! [`Request::plan`] decides whether a scene can be analysed as requested. A run calls it before it
//! builds anything; a check calls it and stops there. So both accept the same requests, with the
//! same messages. Where a message suggests another fidelity or method, this function has accepted
//! the scene with it, so that no advice leads to a refusal that advises back.

use crate::forced_response;
use crate::method::{Method, QuasiStatic};
use crate::options::AnalysisOptions;
use crate::radiated_sound;
use crate::scene::Scene;
use calyx_fe::inertia::Inertia;
use calyx_model::dof::DOF_NAMES;
use calyx_model::fidelity::{Fidelity, StructureOptions};
use calyx_model::frames::number_dofs;
use calyx_model::motion::axle;
use calyx_model::observed::OutputRequest;
use calyx_model::plan::{Plan, UnsupportedOutput};
use calyx_model::target::Examined;
use calyx_numerics::error::{EngineError, Subject};
use calyx_numerics::interrupt::Interrupt;
use calyx_solve::integration::{check_axis, check_inertia};
use calyx_solve::modal::check_modes;
use calyx_solve::restraint_check;
use calyx_solve::vibration::check_mode_count;
use std::borrow::Cow;

/// An analysis as requested, before anything is known about whether it is possible.
#[derive(Clone, Copy)]
pub struct Request<'a> {
    /// Scene to analyse.
    pub scene: &'a Scene,
    /// Outputs to record.
    pub outputs: &'a [OutputRequest],
    /// Method with its options.
    pub method: &'a dyn Method,
    /// Fidelity level of the bodies.
    pub fidelity: Fidelity,
    /// Discretization of the structures.
    pub structure: StructureOptions,
    /// Natural frequency up to which bodies have modes, Hz; 0 for none.
    pub highest_frequency: f64,
}

/// Codes of errors that another fidelity or another method may avoid.
const AVOIDABLE: [&str; 11] =
    ["E0610", "E0611", "E0623", "E0676", "E0690", "E0756", "E0771", "E0780", "E0781", "E0782", "E0783"];

/// Rejects bearings that no motion of their bodies can load, if outputs depend on these bodies.
fn refuse_idle_bearings(scene: &Scene, plan: &Plan) -> Result<(), EngineError> {
    for (index, bearing) in scene.bearings.iter().enumerate() {
        let observed =
            bearing.bodies().any(|body| plan.bodies.get(body.0).is_some_and(|plan| !plan.left_out));
        let is_rolling = bearing.nonlinear.is_some() || bearing.linearization.is_some();
        let carries_own = !is_rolling && !bearing.is_unloaded_without_motion();
        if !observed || carries_own {
            continue;
        }
        let mobility = bearing.mobility(&scene.bodies)?;
        let resisted = (0..6).filter(|&k| mobility.resists[k]).map(|k| format!("\"{}\"", DOF_NAMES[k]));
        let resisted: Vec<String> = resisted.collect();
        if !mobility.is_idle || resisted.is_empty() {
            continue;
        }
        let names: Vec<String> = bearing
            .bodies()
            .filter_map(|body| Some(format!("\"{}\"", scene.bodies.get(body.0)?.name)))
            .collect();
        let (it, its) =
            if names.len() == 1 { ("is", "its frame carries") } else { ("are", "their frames carry") };
        let message = format!(
            "bearing \"{}\" can never carry load: {} {it} not free in any direction that it resists, and {its} all load",
            bearing.name,
            names.join(" and ")
        );
        let help = format!(
            "let the body move, `free = [{}]`, so that the bearing supports it; or remove the bearing",
            resisted.join(", ")
        );
        return Err(EngineError::new("E0728", message, help).about(Subject::Bearing(index)));
    }
    Ok(())
}

impl<'a> Request<'a> {
    /// Creates the request of an analysis with these options.
    pub fn new(
        scene: &'a Scene,
        outputs: &'a [OutputRequest],
        method: &'a dyn Method,
        options: &AnalysisOptions,
    ) -> Request<'a> {
        let AnalysisOptions { fidelity, structure, highest_frequency, .. } = *options;
        Request { scene, outputs, method, fidelity, structure, highest_frequency }
    }

    /// Plans the analysis, if it is possible.
    ///
    /// # Errors
    /// The errors that end a run before it builds a structure: E0610, E0611, E0623, E0661, E0676,
    /// E0677, E0690, E0714, E0715, E0723, E0728, E0729, E0755, E0756, E0762 to E0764, E0770, E0771,
    /// E0774, E0780 to E0785. Also those of the interrupt.
    pub fn plan(&self, interrupt: &Interrupt) -> Result<Plan, EngineError> {
        let plan = self.decide().map_err(|error| self.advise(error))?;
        if let Some(time) = self.method.first_equilibrium() {
            restraint_check::check(self.scene, &plan, time, interrupt)?;
        }
        Ok(plan)
    }

    /// Returns the outputs that have no value at the requested fidelity while others have one, as
    /// one error for all outputs with the same requirements.
    pub fn without_value(&self) -> Vec<EngineError> {
        let refused = UnsupportedOutput::of(self.scene, self.outputs, self.fidelity);
        if refused.len() == self.outputs.len() {
            return Vec::new();
        }
        let mut groups: Vec<Vec<&UnsupportedOutput>> = Vec::new();
        for output in &refused {
            match groups.iter_mut().find(|group| group[0].needs == output.needs) {
                Some(group) => group.push(output),
                None => groups.push(vec![output]),
            }
        }
        let report = |group: &Vec<&UnsupportedOutput>| {
            let [first, others @ ..] = &group[..] else { return None };
            let own = self.outputs.get(first.output..=first.output).unwrap_or_default();
            let about_them = Request { outputs: own, ..*self };
            Some(about_them.advise(first.error_with(others, self.fidelity)))
        };
        groups.iter().filter_map(report).collect()
    }

    /// Applies all rules but the restraint check, which depends on neither fidelity nor method.
    fn decide(&self) -> Result<Plan, EngineError> {
        let Request { scene, method, fidelity, structure, highest_frequency, .. } = *self;
        structure.check()?;
        method.check_options(fidelity)?;
        let planned = if method.has_inertia() { Plan::in_time } else { Plan::new };
        let plan = planned(scene, fidelity, structure)?;
        check_modes(scene, &plan, highest_frequency)?;
        let plan = plan.for_outputs(scene, self.outputs)?.with_modes(scene, highest_frequency);
        refuse_idle_bearings(scene, &plan)?;
        if method.has_inertia() && scene.forced_response.is_some() {
            let message =
                "a forced response belongs to a quasi-static analysis, and this one integrates in time";
            let help = "remove `gears.forced_response`, or use `analyze(\"quasi_static\", over = gears.mesh_cycle(mesh, 24))`";
            return Err(EngineError::new("E0774", message, help).blame("method"));
        }
        if let Some(request) = &scene.forced_response {
            let dofs = number_dofs(scene, &plan).len();
            forced_response::check(scene, request, (plan.fidelity, highest_frequency), dofs)?;
        }
        if method.has_inertia() && !scene.sounds.is_empty() {
            let message = "radiated sound is that of a forced response, which belongs to a quasi-static analysis, and this one integrates in time";
            let help = "use `analyze(\"quasi_static\", over = gears.mesh_cycle(mesh, 24))` with `gears.forced_response`";
            return Err(EngineError::new("E0784", message, help).blame("method"));
        }
        let response = scene.forced_response.as_ref();
        let lowest_line = response.map(|request| forced_response::lowest_frequency(scene, request));
        let sounds = (&scene.sounds[..], lowest_line);
        radiated_sound::check(scene, sounds, &plan, highest_frequency)?;
        if let Some(request) = response {
            let observed = scene.observables.iter().filter_map(|observable| observable.harmonic());
            radiated_sound::check_harmonics(request.harmonics, observed)?;
        }
        let modes = scene.observables.iter().any(|observable| observable.mode().is_some());
        if method.has_inertia() {
            let times = method.checked_times();
            for (body, _) in plan.bodies.iter().enumerate().filter(|(_, body)| !body.left_out) {
                times.iter().try_for_each(|&time| check_axis(scene, body, time))?;
            }
        }
        if method.has_inertia() || modes || scene.examines_modes() {
            self.check_vibrations(&plan)?;
        }
        Ok(plan)
    }

    /// Checks that free bodies have inertia and that the scene has the modes that outputs request.
    fn check_vibrations(&self, plan: &Plan) -> Result<(), EngineError> {
        let dofs = number_dofs(self.scene, plan);
        // The inertia of a gear requires its mesh, so only that of free bodies is computed.
        let inertia =
            |(index, body): (usize, &calyx_model::body::Body)| match dofs.iter().any(|dof| dof.body == index)
            {
                true => body.inertia().from(axle(body.motion.as_ref())),
                false => Inertia::default(),
            };
        let inertias: Vec<Inertia> = self.scene.bodies.iter().enumerate().map(inertia).collect();
        check_inertia(self.scene, &dofs, &inertias)?;
        // The number of modes up to a frequency is known only after they are computed.
        match self.highest_frequency > 0.0 {
            true => Ok(()),
            false => check_mode_count(self.scene, dofs.len()),
        }
    }

    /// Replaces the remedy of an error by one that works: first changes of the request that make it
    /// possible, then the remedy of the error itself.
    fn advise(&self, error: EngineError) -> EngineError {
        if !AVOIDABLE.contains(&error.code) {
            return error;
        }
        let help = match self.possible_change() {
            Some(change) if error.help.is_empty() => change,
            Some(change) => format!("{change}, or {}", error.help),
            None => error.help,
        };
        EngineError { help, ..error }
    }

    /// Returns the smallest change of fidelity, modes and method that makes the request possible,
    /// as an imperative.
    fn possible_change(&self) -> Option<String> {
        let possible = |request: &Request<'_>| request.decide().is_ok();
        let elsewhere = |request: Request<'_>| -> Vec<Fidelity> {
            let at = |fidelity: &Fidelity| possible(&Request { fidelity: *fidelity, ..request });
            let elastic = |fidelity: &Fidelity| *fidelity != Fidelity::Rigid && at(fidelity);
            // The nearest with more detail and the nearest with less; rigid bodies only as a last
            // resort.
            let more = self.fidelity.all_above().find(at);
            let named: Vec<Fidelity> = more.into_iter().chain(below(self.fidelity).find(elastic)).collect();
            match named.is_empty() && self.fidelity != Fidelity::Rigid && at(&Fidelity::Rigid) {
                true => vec![Fidelity::Rigid],
                false => named,
            }
        };
        let choice = |named: &[Fidelity]| {
            let names: Vec<String> =
                named.iter().map(|fidelity| format!("\"{}\"", fidelity.name())).collect();
            names.join(" or ")
        };
        let named = elsewhere(*self);
        if !named.is_empty() {
            return Some(format!("choose the fidelity {}", choice(&named)));
        }
        let without_modes = Request { highest_frequency: 0.0, ..*self };
        let quasi_static = QuasiStatic { positions: Cow::Borrowed(&[]) };
        let at_rest = Request { method: &quasi_static, ..*self };
        let both = Request { highest_frequency: 0.0, ..at_rest };
        const NO_MODES: &str = "leave `highest_frequency` at 0";
        const STATICS: &str =
            "choose the method \"quasi_static\" (over positions such as `gears.mesh_cycle(mesh, 32)`)";
        let changes = [
            (self.highest_frequency != 0.0, without_modes, NO_MODES.to_owned()),
            (true, at_rest, STATICS.to_owned()),
            (self.highest_frequency != 0.0, both, format!("{STATICS} and {NO_MODES}")),
        ];
        for (changes, request, words) in changes {
            if !changes {
                continue;
            }
            if possible(&request) {
                return Some(words);
            }
            let named = elsewhere(request);
            if !named.is_empty() {
                return Some(format!("{words} with the fidelity {}", choice(&named)));
            }
        }
        None
    }
}

/// Returns the fidelities with less detail, the nearest first.
fn below(fidelity: Fidelity) -> impl Iterator<Item = Fidelity> {
    let at = Fidelity::ALL.into_iter().position(|known| known == fidelity).unwrap_or(0);
    Fidelity::ALL.into_iter().take(at).rev()
}
