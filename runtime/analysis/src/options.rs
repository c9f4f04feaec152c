//! Options of an analysis.

use crate::estimate::Estimates;
use crate::rows::Solved;
use calyx_model::fidelity::{Fidelity, StructureOptions};
use calyx_model::resources::Resources;

/// How an analysis is done.
#[derive(Clone, Debug)]
pub struct AnalysisOptions {
    /// How bodies are modelled.
    pub fidelity: Fidelity,
    /// How finely.
    pub structure: StructureOptions,
    /// Natural frequencies of bodies up to which motion in time and the vibrations about an equilibrium see their modes, Hz; 0 takes bodies as
    /// rigid ones on elastic teeth. No equilibrium depends on it.
    pub highest_frequency: f64,
    /// Threads, kept structures, an interrupt: no result depends on them.
    pub resources: Resources,
    /// What an earlier run of the same analysis solved of its first positions; it goes on behind them, and its result is that
    /// of a run that solved them all.
    pub solved: Vec<Solved>,
    /// Of so many positions at most, evenly spread from the first on, tell the observer the fields too: pressures, line loads, stresses.
    /// They take no part in the results.
    pub fields: usize,
    /// Whether the meshes of elastic bodies, deformed, are among these fields: they are decomposed for it once, and each position takes a
    /// back-substitution for every tooth.
    pub bodies: bool,
    /// Which errors of its outputs are estimated, once all positions are solved.
    pub error_estimates: Estimates,
}

impl Default for AnalysisOptions {
    fn default() -> Self {
        AnalysisOptions {
            fidelity: Fidelity::Plane,
            structure: StructureOptions::default(),
            highest_frequency: 0.0,
            resources: Resources::default(),
            solved: Vec::new(),
            fields: 0,
            bodies: false,
            error_estimates: Estimates::None,
        }
    }
}
