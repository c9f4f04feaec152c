//! Options of an analysis.

use crate::estimate::Estimates;
use crate::rows::Solved;
use crate::sensitivity::SensitivityRequest;
use calyx_model::fidelity::{Fidelity, StructureOptions};
use calyx_model::resources::Resources;

/// Options of an analysis.
#[derive(Clone, Debug)]
pub struct AnalysisOptions {
    /// Fidelity level of the bodies.
    pub fidelity: Fidelity,
    /// Discretization of the structures.
    pub structure: StructureOptions,
    /// Highest natural frequency of body modes in transient analyses and in vibrations about an
    /// equilibrium, Hz; 0 treats bodies as rigid with elastic teeth. Equilibria do not depend on
    /// it.
    pub highest_frequency: f64,
    /// Threads, structure cache and interrupt. No result depends on them.
    pub resources: Resources,
    /// First positions of an earlier run of the same analysis. The analysis resumes after them,
    /// with the same result as a run without interruption.
    pub solved: Vec<Solved>,
    /// Maximum number of positions, evenly spaced from the first, at which the observer also
    /// receives fields: pressures, line loads, stresses. Fields are not part of the results.
    pub fields: usize,
    /// Includes deformed meshes of elastic bodies in the fields. This costs one factorization, and
    /// for each position a back-substitution per tooth.
    pub bodies: bool,
    /// Includes the outer surfaces of all parts, their poses and the forces between them in the
    /// fields. This meshes each gear once, without a factorization.
    pub parts: bool,
    /// Records the loads of all meshes and bearings ([`crate::component_loads`]), unless positions
    /// of an earlier run are given.
    pub component_loads: bool,
    /// Error estimates that are computed after all positions are solved.
    pub error_estimates: Estimates,
    /// Derivatives of all outputs, computed after all positions are solved; only of quasi-static
    /// analyses.
    pub sensitivities: Option<SensitivityRequest>,
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
            parts: false,
            component_loads: false,
            error_estimates: Estimates::None,
            sensitivities: None,
        }
    }
}
