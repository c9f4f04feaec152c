//! Structure whose surfaces have been slightly modified: a relief of micrometres on flanks of
//! millimetres.
//!
//! Contact uses the new curves exactly. The body behind them is the original one: its tables give
//! the compliance at the point of the original curve that corresponds to a point of the new one. A
//! force there acts along the new normal, which the tables resolve into a force into the body and
//! one along its surface. Rotated by an angle `t`, the force bends a tooth of radius `r` with a
//! lever arm that differs by `r t`, so this effect cannot be neglected. The body between the two
//! curves is neglected.

use super::local::{Local, NormalAngle};
use super::{ElasticStructure, Surface};
use crate::profile::Profile;
use crate::raceway::Raceway;
use crate::{Chart, ModifiedSurface, SplineToothForce, StressPoint, Structure, SurfaceLoad};
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use faer::{Mat, MatRef};
use std::sync::Arc;

impl ModifiedSurface {
    /// Returns a point of it in terms of the tables of the surface that it replaces.
    pub(crate) fn local(&self, old: &Surface, s: f64) -> Local {
        let onto = (self.onto)(s);
        // Coordinates beyond the last point of the tables are clamped to that point and its
        // direction.
        let last = self.profile.edge_from().unwrap_or(self.profile.length());
        let own = self.profile.at(s.clamp(0.0, last));
        let local = old.local(onto);
        let old = old.profile.at(local.turned.s);
        let [x, y] = own.normal;
        let into = x * old.normal[0] + y * old.normal[1];
        let along = -(x * old.tangent[0] + y * old.tangent[1]);
        let turned = NormalAngle { angle: local.turned.angle - along.atan2(into), ..local.turned };
        Local { direction: [into, along], turned, ..local }
    }
}

pub(crate) struct ModifiedStructure {
    body: Arc<ElasticStructure>,
    surfaces: Vec<ModifiedSurface>,
}

impl ModifiedStructure {
    /// Builds the structure with one surface for each of the body's.
    pub fn new(body: Arc<ElasticStructure>, surfaces: Vec<ModifiedSurface>) -> Self {
        Self { body, surfaces }
    }

    fn local(&self, chart: Chart, s: f64) -> Option<Local> {
        let (own, old) = (self.surfaces.get(chart.surface as usize)?, self.body.surface(chart)?);
        Some(own.local(old, s))
    }

    fn locals(&self, chart: Chart, s: &[f64]) -> Vec<Local> {
        s.iter().filter_map(|&s| self.local(chart, s)).collect()
    }
}

impl Structure for ModifiedStructure {
    fn profile(&self, surface: u32) -> Arc<dyn Profile> {
        self.surfaces[surface as usize].profile.clone()
    }

    fn teeth(&self) -> u32 {
        self.body.teeth()
    }

    fn surface_modulus(&self) -> f64 {
        self.body.surface_modulus()
    }

    fn reference_length(&self) -> f64 {
        self.body.reference_length()
    }

    fn add_compliance_until(
        &self,
        observe: Chart,
        observe_s: &[f64],
        load: Chart,
        load_s: &[f64],
        block: &mut [f64],
        interrupt: &Interrupt,
    ) -> Result<(), EngineError> {
        let (observers, loads) = (self.locals(observe, observe_s), self.locals(load, load_s));
        self.body.add_between(observe, &observers, load, &loads, block, interrupt)
    }

    fn stresses(&self, tooth: u32, surface: u32, loads: &[SurfaceLoad]) -> Vec<(StressPoint, f64)> {
        let seen =
            loads.iter().filter_map(|load| Some((load.chart, self.local(load.chart, load.s)?, load.force)));
        self.body.stresses_by(tooth, surface, seen)
    }

    fn spline_tooth_forces(&self, loads: &[SurfaceLoad]) -> Vec<SplineToothForce> {
        let seen =
            loads.iter().filter_map(|load| Some((load.chart, self.local(load.chart, load.s)?, load.force)));
        self.body.spline_tooth_forces_by(seen)
    }

    fn interface_compliance(&self) -> Option<MatRef<'_, f64>> {
        self.body.interface_compliance()
    }

    fn raceway(&self) -> Option<Raceway> {
        self.body.raceway()
    }

    fn interface_displacements(&self, load: Chart, load_s: &[f64]) -> Mat<f64> {
        self.body.interface_displacements_by(load, &self.locals(load, load_s))
    }

    fn stresses_by_interface(&self, tooth: u32, surface: u32, forces: &[f64]) -> Vec<f64> {
        self.body.stresses_by_interface(tooth, surface, forces)
    }

    fn bytes(&self) -> usize {
        self.body.bytes()
    }
}
