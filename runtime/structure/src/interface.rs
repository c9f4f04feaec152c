//! Interface of a plane body for contact: loadable surfaces, their compliance, recovered stresses.

use crate::profile::Profile;
use crate::raceway::Raceway;
use crate::spline_teeth::SplineToothForce;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use faer::{Mat, MatRef};
use std::f64::consts::TAU;
use std::sync::Arc;

/// A loadable surface of a structure: a flank of one tooth, or the rim of a disc.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Chart {
    /// Index of the tooth (or repeated sector), counted counter-clockwise from 0. 0 where nothing
    /// repeats.
    pub tooth: u32,
    /// Index of the surface on the tooth. Gears: 0 is the flank whose outward normal points
    /// counter-clockwise, 1 the other.
    pub surface: u32,
}

/// A normal force on a surface: positive presses into the material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceLoad {
    /// Surface on which the force acts.
    pub chart: Chart,
    /// Arc length on the chart's profile, m.
    pub s: f64,
    /// Force, N per metre of face width.
    pub force: f64,
}

/// Location of a recovered stress.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StressPoint {
    /// Index of the tooth, counted counter-clockwise from 0.
    pub tooth: u32,
    /// Index of the surface, as in [`Chart::surface`].
    pub surface: u32,
    /// Arc length on the fillet, from the end of the flank, m.
    pub s: f64,
    /// Position in the body's frame, m.
    pub position: [f64; 2],
}

/// Elastic behaviour of a body.
///
/// The compliance of a surface is split: `A(s, s') = G(s - s') + R(s, s')`. `G` is the compliance
/// of the half-plane, `-2 / (pi E') ln(|s - s'| / L)` with `E'` = [`Structure::surface_modulus`]
/// and `L` = [`Structure::reference_length`]. It applies between points of the same chart only and
/// is 0 between different charts. `R` is the smooth remainder, which the structure evaluates.
pub trait Structure: Send + Sync {
    /// Returns the profile of a surface of tooth 0 in the body's frame. In tooth coordinates the
    /// profile is the same for every tooth.
    fn profile(&self, surface: u32) -> Arc<dyn Profile>;

    /// Returns the angle of tooth `tooth` in the body's frame, rad (counter-clockwise).
    fn tooth_angle(&self, tooth: u32) -> f64 {
        let teeth = self.teeth();
        TAU * f64::from(tooth % teeth) / f64::from(teeth)
    }

    /// Returns the number of repeated sectors; 1 where nothing repeats.
    fn teeth(&self) -> u32;

    /// Returns the plane-strain modulus E', Pa. Infinite for a rigid body, whose `G` and `R` are
    /// zero.
    fn surface_modulus(&self) -> f64;

    /// Returns the reference length L in the logarithm of the half-plane, m.
    fn reference_length(&self) -> f64;

    /// Adds `R` to `block`, row-major, `observe_s.len()` rows by `load_s.len()` columns: inward
    /// normal displacement at `observe_s` on `observe` per unit inward normal force at `load_s` on
    /// `load`, m/(N/m). The result is symmetric: exchanging loads and observers transposes it, bit
    /// for bit.
    ///
    /// # Errors
    /// The interrupt's. Many cells take long, so implementations check it.
    fn add_compliance_until(
        &self,
        observe: Chart,
        observe_s: &[f64],
        load: Chart,
        load_s: &[f64],
        block: &mut [f64],
        interrupt: &Interrupt,
    ) -> Result<(), EngineError>;

    /// [`Structure::add_compliance_until`] without an interrupt.
    fn add_compliance(
        &self,
        observe: Chart,
        observe_s: &[f64],
        load: Chart,
        load_s: &[f64],
        block: &mut [f64],
    ) {
        // An interrupt that is never asked ends nothing.
        let _ = self.add_compliance_until(observe, observe_s, load, load_s, block, &Interrupt::never());
    }

    /// Returns the first principal stress (the largest tension, Pa) under the given loads at each
    /// stress recovery point of tooth `tooth`. On a free surface it is the stress along the
    /// surface, negative in compression. Empty if the structure recovers no stress.
    fn stresses(&self, tooth: u32, surface: u32, loads: &[SurfaceLoad]) -> Vec<(StressPoint, f64)>;

    /// Returns the forces of the supporting spline teeth on the body under the given loads, one
    /// entry a spline tooth; empty if spline teeth do not support the body.
    fn spline_tooth_forces(&self, _loads: &[SurfaceLoad]) -> Vec<SplineToothForce> {
        Vec::new()
    }

    /// Returns the compliance matrix of the displacements of the bore on which contact outside of
    /// the structure acts, m/(N/m): those of spline teeth with clearance
    /// ([`crate::BoreSupport::SplineWithClearance`]), positive counter-clockwise, or the terms of a
    /// [`Raceway`]. The matrix is square and symmetric to the bit; `None` for another bore.
    fn interface_compliance(&self) -> Option<MatRef<'_, f64>> {
        None
    }

    /// Returns the raceway in the bore of the body, if any.
    fn raceway(&self) -> Option<Raceway> {
        None
    }

    /// Returns the same displacements by unit inward normal forces at points of a chart,
    /// displacements by points. By reciprocity these are also the inward displacements at the
    /// points by the conjugate forces.
    fn interface_displacements(&self, _load: Chart, load_s: &[f64]) -> Mat<f64> {
        Mat::zeros(0, load_s.len())
    }

    /// Returns the contribution to [`Structure::stresses`] of forces on all these displacements,
    /// Pa. Empty if they contribute nothing.
    fn stresses_by_interface(&self, _tooth: u32, _surface: u32, _forces: &[f64]) -> Vec<f64> {
        Vec::new()
    }

    /// Returns the same body with surfaces that differ slightly from its own, one for each; `None`
    /// if the structure does not support this.
    ///
    /// Contact acts on the new curve, along its own normal; the compliance is that of the old
    /// surface.
    fn with_modified_surfaces(
        self: Arc<Self>,
        _surfaces: Vec<ModifiedSurface>,
    ) -> Option<Arc<dyn Structure>> {
        None
    }

    /// Returns the memory of the structure, in bytes, to within a few percent: the size that a
    /// cache counts.
    fn bytes(&self) -> usize;

    /// Returns everything but the contact surfaces, to be stored on disk for
    /// `Prototype::restore`; `None` if building the structure
    /// is faster than reading it.
    fn stored(&self) -> Option<Vec<u8>> {
        None
    }
}

/// Surface that replaces another one.
#[derive(Clone)]
pub struct ModifiedSurface {
    /// Curve that contact uses.
    pub profile: Arc<dyn Profile>,
    /// Maps its arc lengths to those of the curve it replaces, m; continuous and ascending.
    pub onto: Arc<dyn Fn(f64) -> f64 + Send + Sync>,
}
