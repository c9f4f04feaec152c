//! Deliberate deviations of the flank from the involute. They take material off; amounts are normal to the flank.

use crate::deviation::Deviation;
use crate::error::{GeometryError, sentence};

/// How relief grows from its start to the tip circle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReliefShape {
    /// In proportion to the roll angle, with the corner at the start rounded over [`LINEAR_BLEND`] of its length to
    /// both sides, as no tool leaves a sharp one.
    Linear,
    /// With the square of the roll angle.
    Quadratic,
}

/// Half-width of the rounding of the start of a linear relief, as a part of the relief's range of roll.
pub const LINEAR_BLEND: f64 = 0.05;

/// Material taken off near the tip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TipRelief {
    /// At the tip circle, m.
    pub depth: f64,
    /// Roll angle at which it begins, rad.
    pub start_roll: f64,
    /// How it grows.
    pub shape: ReliefShape,
}

/// A deviation of the flank.
#[derive(Clone, Debug, PartialEq)]
pub enum Modification {
    /// Material taken off near the tip.
    TipRelief(TipRelief),
    /// What a function of the program says.
    Deviation(Deviation),
    /// A parabola along the face with this depth at both ends, m. A plane model cannot see it.
    LeadCrown {
        /// m
        depth: f64,
    },
}

impl From<TipRelief> for Modification {
    fn from(relief: TipRelief) -> Self {
        Modification::TipRelief(relief)
    }
}

impl From<Deviation> for Modification {
    fn from(deviation: Deviation) -> Self {
        Modification::Deviation(deviation)
    }
}

impl Modification {
    /// A crown by its depth at both ends of the face, m.
    ///
    /// # Errors
    /// E0666: the depth is negative.
    pub fn lead_crown(depth: f64) -> Result<Modification, GeometryError> {
        if depth.is_nan() || depth < 0.0 {
            return Err(GeometryError::error(
                "E0666",
                "depth",
                sentence!["a crown cannot be negative"],
                sentence!["it is the depth taken off at the ends of the face"],
            ));
        }
        Ok(Modification::LeadCrown { depth })
    }

    /// A tip relief by its depth at the tip circle (m), the roll angle at which it begins (rad) and its shape. Whether it lies on the
    /// flank is checked with the gear.
    pub fn tip_relief(depth: f64, start_roll: f64, shape: ReliefShape) -> Modification {
        Modification::TipRelief(TipRelief { depth, start_roll, shape })
    }
}

impl TipRelief {
    /// Checks the relief against the flank it is for; rolls in rad.
    pub fn check(&self, form_roll: f64, tip_roll: f64, tip_thickness: f64) -> Result<(), GeometryError> {
        if !(form_roll..tip_roll).contains(&self.start_roll) {
            return Err(GeometryError::error(
                "E0640",
                "start_roll",
                sentence![
                    "the tip relief starts at a roll angle of ", angle self.start_roll,
                    ", but the involute runs from ", angle form_roll, " to ", angle tip_roll
                ],
                sentence![
                    "start the relief on the involute, usually near the highest point of single-tooth contact"
                ],
            ));
        }
        if !(self.depth >= 0.0 && self.depth < 0.5 * tip_thickness) {
            return Err(GeometryError::error(
                "E0641",
                "depth",
                sentence![
                    "the tip relief is ", length self.depth, " deep, but must be between zero and half the tip thickness, ",
                    length 0.5 * tip_thickness
                ],
                sentence![
                    "usual depths are near the deflection of the teeth under load, a few thousandths of a module"
                ],
            ));
        }
        Ok(())
    }

    /// Half-width in roll of the rounding of the start; it never reaches below the form circle.
    fn blend(&self, form_roll: f64, tip_roll: f64) -> f64 {
        match self.shape {
            ReliefShape::Linear => {
                (LINEAR_BLEND * (tip_roll - self.start_roll)).min(self.start_roll - form_roll)
            }
            ReliefShape::Quadratic => 0.0,
        }
    }

    /// Roll angles at which the second derivative of the amount jumps, ascending.
    pub fn breaks(&self, form_roll: f64, tip_roll: f64) -> Vec<f64> {
        let blend = self.blend(form_roll, tip_roll);
        if blend > 0.0 {
            vec![self.start_roll - blend, self.start_roll + blend]
        } else {
            vec![self.start_roll]
        }
    }

    /// Amount (m) at a roll angle, and its first and second derivatives by roll.
    pub fn amount(&self, roll: f64, form_roll: f64, tip_roll: f64) -> [f64; 3] {
        let range = tip_roll - self.start_roll;
        let from_start = roll - self.start_roll;
        match self.shape {
            ReliefShape::Quadratic => {
                if from_start <= 0.0 {
                    return [0.0; 3];
                }
                let part = from_start / range;
                [
                    self.depth * part * part,
                    2.0 * self.depth * part / range,
                    2.0 * self.depth / (range * range),
                ]
            }
            ReliefShape::Linear => {
                let blend = self.blend(form_roll, tip_roll);
                let slope = self.depth / range;
                if from_start <= -blend {
                    [0.0; 3]
                } else if from_start < blend {
                    // The parabola tangent to both straight parts.
                    let into = from_start + blend;
                    [slope * into * into / (4.0 * blend), slope * into / (2.0 * blend), slope / (2.0 * blend)]
                } else {
                    [slope * from_start, slope, 0.0]
                }
            }
        }
    }
}
