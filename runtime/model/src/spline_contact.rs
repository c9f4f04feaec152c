//! Splines with clearance: spline teeth or keys that support a body by contact with its
//! surroundings.
//!
//! Every spline tooth is in a space of the housing that is wider by the clearance. Each of its two
//! flanks is a cell of the contact problem ([`calyx_contact::problem`]), like those of gear teeth:
//! its gap is half the clearance at the prescribed position of the body, and its compressive force
//! is distributed uniformly over the tooth. The compliance of a flank consists of that of the
//! spline tooth and that of the bore under the forces of all spline and gear teeth
//! ([`calyx_structure::BoreSupport::SplineWithClearance`]). The body moves with its frame, which
//! must be free. The counterpart is rigid and moves with the prescribed motion of the frame: it is
//! ground for a frame at rest.
//!
//! Gaps are linear in the motion of the frame from its prescribed position. A rotation by the
//! clearance divided by the radius has an error of the clearance times half of that angle.
//!
//! See `docs/theory/bearings.md`.

use calyx_structure::SplineTeeth;
use faer::MatRef;

/// Spline teeth with clearance of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SplineContact {
    /// Spline teeth; each flank has their tangential compliance.
    pub spline_teeth: SplineTeeth,
    /// Clearance: space width minus tooth thickness along the circle of the bore, m. Half of it is
    /// on either flank of a centred tooth.
    pub clearance: f64,
    /// Radius of the bore, m.
    pub radius: f64,
}

/// Sense in which a spline tooth closes the gap of each of its flanks, counter-clockwise first.
pub const SENSES: [f64; 2] = [1.0, -1.0];

impl SplineContact {
    /// Returns the number of gap equations: two per spline tooth, one after the other.
    pub fn flanks(&self) -> usize {
        SENSES.len() * usize::from(self.spline_teeth.count)
    }

    /// Returns spline tooth and sense of every flank.
    fn senses(&self) -> impl Iterator<Item = (u16, f64)> {
        (0..self.spline_teeth.count).flat_map(|spline_tooth| SENSES.map(|sense| (spline_tooth, sense)))
    }

    /// Returns the derivatives of the gap of each flank by a displacement of the body along x and y
    /// and by its rotation about its axis; these are also the force and the moment on the body per
    /// unit of force on the flank. `angle` is the rotation of the body's teeth, `off` the position
    /// of the centre of its bore relative to its axis (m), both along ground axes.
    pub fn arms(&self, angle: f64, [x, y]: [f64; 2]) -> Vec<[f64; 3]> {
        // Mean of a uniform transverse displacement over an arc.
        let half = 0.5 * self.spline_teeth.width;
        let chord = if half == 0.0 { 1.0 } else { half.sin() / half };
        self.senses()
            .map(|(spline_tooth, sense)| {
                let (sin, cos) = (angle + self.spline_teeth.angle(spline_tooth)).sin_cos();
                [chord * sin, -chord * cos, -(self.radius + chord * (x * cos + y * sin))]
                    .map(|arm| sense * arm)
            })
            .collect()
    }

    /// Returns the forces of the spline teeth on the body, counter-clockwise, from those on their
    /// flanks.
    pub fn around(&self, flanks: &[f64]) -> Vec<f64> {
        let pair = |pair: &[f64]| pair.iter().zip(SENSES).map(|(force, sense)| -sense * force).sum();
        flanks.chunks(SENSES.len()).map(pair).collect()
    }

    /// Transforms a row of displacements by spline tooth, counter-clockwise, to flanks: the growth
    /// of their gaps.
    pub fn by_flanks<'a>(&'a self, of_lug: impl Fn(usize) -> f64 + 'a) -> impl Iterator<Item = f64> + 'a {
        self.senses().map(move |(spline_tooth, sense)| -sense * of_lug(usize::from(spline_tooth)))
    }

    /// Returns the compliance matrix of the flanks, row-major. `between` contains the displacements
    /// at spline teeth under forces on them; `None` for a rigid body.
    pub fn compliance(&self, between: Option<MatRef<'_, f64>>) -> Vec<f64> {
        let flanks: Vec<(usize, f64)> =
            self.senses().map(|(spline_tooth, sense)| (usize::from(spline_tooth), sense)).collect();
        let entry = |(row, &(spline_tooth, sense)): (usize, &(usize, f64))| {
            let through = move |other: usize| between.map_or(0.0, |between| between[(spline_tooth, other)]);
            let own = self.spline_teeth.tangential;
            let of = move |(column, &(other, against)): (usize, &(usize, f64))| {
                sense * against * through(other) + if row == column { own } else { 0.0 }
            };
            flanks.iter().enumerate().map(of).collect::<Vec<f64>>()
        };
        flanks.iter().enumerate().flat_map(entry).collect()
    }
}
