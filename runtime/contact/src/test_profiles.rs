//! Profiles and bodies whose contact is known in closed form.

use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use calyx_structure::profile::{Profile, ProfilePoint};
use calyx_structure::{Chart, StressPoint, Structure, SurfaceLoad};
use std::sync::Arc;

/// Circular arcs joined with continuous normals, counter-clockwise; the last may be an edge.
pub struct Arcs {
    /// Start of each arc, its centre, radius and the angle of its normal at the start.
    arcs: Vec<(f64, [f64; 2], f64, f64)>,
    breaks: Vec<f64>,
    length: f64,
    edge_from: Option<f64>,
}

impl Arcs {
    /// Creates arcs of the given radii and angles from the normal's angle `from`; the first centre
    /// is `center`.
    pub fn new(center: [f64; 2], from: f64, pieces: &[(f64, f64)], last_is_edge: bool) -> Self {
        let mut arcs: Vec<(f64, [f64; 2], f64, f64)> = Vec::new();
        let (mut s, mut angle, mut center) = (0.0, from, center);
        for &(radius, turn) in pieces {
            if let Some(&(_, _, before, _)) = arcs.last() {
                let along = before - radius;
                center = [center[0] + along * f64::cos(angle), center[1] + along * f64::sin(angle)];
            }
            arcs.push((s, center, radius, angle));
            s += radius * turn;
            angle += turn;
        }
        let breaks: Vec<f64> = arcs.iter().skip(1).map(|a| a.0).collect();
        let edge_from = breaks.last().copied().filter(|_| last_is_edge);
        Self { arcs, breaks, length: s, edge_from }
    }
}

impl Profile for Arcs {
    fn length(&self) -> f64 {
        self.length
    }

    fn at(&self, s: f64) -> ProfilePoint {
        let piece = self.breaks.iter().take_while(|&&b| s >= b).count();
        let (start, center, radius, from) = self.arcs[piece];
        let (sine, cosine) = (from + (s - start) / radius).sin_cos();
        ProfilePoint {
            position: [center[0] + radius * cosine, center[1] + radius * sine],
            tangent: [-sine, cosine],
            normal: [cosine, sine],
            curvature: radius.recip(),
        }
    }

    fn breaks(&self) -> &[f64] {
        &self.breaks
    }

    fn edge_from(&self) -> Option<f64> {
        self.edge_from
    }
}

/// Involute of a base circle about the origin, between two roll angles.
pub struct Involute {
    pub base_radius: f64,
    pub roll: [f64; 2],
}

impl Profile for Involute {
    fn length(&self) -> f64 {
        0.5 * self.base_radius * (self.roll[1] * self.roll[1] - self.roll[0] * self.roll[0])
    }

    fn at(&self, s: f64) -> ProfilePoint {
        let roll = (self.roll[0] * self.roll[0] + 2.0 * s / self.base_radius).sqrt();
        let (sine, cosine) = roll.sin_cos();
        ProfilePoint {
            position: [self.base_radius * (cosine + roll * sine), self.base_radius * (sine - roll * cosine)],
            tangent: [cosine, sine],
            normal: [sine, -cosine],
            curvature: (self.base_radius * roll).recip(),
        }
    }
}

/// Body whose only compliance is that of the half-plane.
pub struct HalfPlaneBody {
    pub surface_modulus: f64,
}

impl Structure for HalfPlaneBody {
    fn profile(&self, _surface: u32) -> Arc<dyn Profile> {
        Arc::new(Arcs::new([0.0, 0.0], 0.0, &[(1.0, 1.0)], false))
    }

    fn teeth(&self) -> u32 {
        1
    }

    fn surface_modulus(&self) -> f64 {
        self.surface_modulus
    }

    fn reference_length(&self) -> f64 {
        1.0
    }

    fn add_compliance_until(
        &self,
        _: Chart,
        _: &[f64],
        _: Chart,
        _: &[f64],
        _: &mut [f64],
        _: &Interrupt,
    ) -> Result<(), EngineError> {
        Ok(())
    }

    fn stresses(&self, _: u32, _: u32, _: &[SurfaceLoad]) -> Vec<(StressPoint, f64)> {
        Vec::new()
    }

    fn bytes(&self) -> usize {
        0
    }
}
