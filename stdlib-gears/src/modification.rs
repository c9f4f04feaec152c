//! What flanks differ by from involutes wound along a helix: modifications that are wanted, deviations that are not.
//!
//! All are one thing: an amount of material taken off, `a(roll, z)`, measured along the normal of the involute in the transverse
//! section, with `z` from mid-face. A *profile* part is the same all along the face: the plane flank ([`crate::flank::Flank`]) has it in full. A *lead*
//! part ([`LeadModification`]) is the same at all heights: it turns sections about the axis. What depends on both ([`Topography`]) is
//! split into the profile that it is in mid-face and the rest.

use crate::deviation::Deviation;
use crate::error::{GeometryError, sentence};
use crate::gear::ToothForm;
use crate::table_splines::{NaturalSpline, TensorSpline};
use std::sync::Arc;

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

/// Material taken off near the tip. As a root relief, near the form circle: "tip" then stands for that.
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
    /// Material taken off near the root, deepest at the form circle.
    RootRelief(TipRelief),
    /// What a function of the program says.
    Deviation(Deviation),
    /// Error of the slope of the profile: material that stands out at the tip circle, in proportion to the roll angle from none at the form
    /// circle, m; negative where it is missing.
    ProfileSlope(f64),
    /// Error of the helix: distance along the base tangent by which the teeth lean too far over the face width, m; positive towards a right-handed
    /// helix.
    HelixSlope(f64),
    /// Amounts by the distance from mid-face (m), the same at all heights.
    LeadTable(Arc<NaturalSpline>),
    /// Amounts by roll angle and distance from mid-face.
    Topography(Arc<Topography>),
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

    /// Amounts in a table by the roll angle, ascending (rad, m): a spline passes through them, which goes on straight beyond its ends.
    ///
    /// # Errors
    /// E0643: this is no table.
    pub fn profile_table(rolls: Vec<f64>, depths: Vec<f64>) -> Result<Modification, GeometryError> {
        let spline = NaturalSpline::new("rolls", rolls, depths)?;
        Ok(Deviation::new("a profile table", move |roll| spline.at(roll)[0]).into())
    }

    /// Amounts in a table by the distance from mid-face, ascending (m, m): a spline passes through them.
    ///
    /// # Errors
    /// E0643: this is no table.
    pub fn lead_table(places: Vec<f64>, depths: Vec<f64>) -> Result<Modification, GeometryError> {
        Ok(Modification::LeadTable(Arc::new(NaturalSpline::new("places", places, depths)?)))
    }

    /// Amounts in a table by roll angle (rad) and distance from mid-face (m): for each roll angle one row along the face.
    ///
    /// # Errors
    /// E0643: this is no table.
    pub fn topography(
        rolls: Vec<f64>,
        places: Vec<f64>,
        depths: Vec<f64>,
    ) -> Result<Modification, GeometryError> {
        let amounts = TensorSpline::new(["rolls", "places"], [rolls, places], depths)?;
        Ok(Modification::Topography(Arc::new(Topography { amounts })))
    }

    /// What this is in the middle of the face as a function of the roll angle, if it depends on both.
    pub(crate) fn at_mid_face(&self) -> Option<Deviation> {
        match self {
            Modification::Topography(topography) => Some(topography.at_mid_face()),
            _ => None,
        }
    }

    /// Whether a plane model, which has no direction along the face, leaves it out, wholly or in part.
    pub(crate) fn varies_along_face(&self) -> Option<&'static str> {
        match self {
            Modification::LeadCrown { depth } if *depth > 0.0 => Some("lead_crown"),
            Modification::HelixSlope(deviation) if *deviation != 0.0 => Some("helix_slope"),
            Modification::LeadTable(_) => Some("lead_table"),
            Modification::Topography(_) => Some("topography"),
            _ => None,
        }
    }

    /// Everything about it that a structure of these teeth may depend on.
    pub(crate) fn numbers(&self, form: &ToothForm) -> Vec<f64> {
        match self {
            Modification::TipRelief(relief) | Modification::RootRelief(relief) => {
                let linear = f64::from(u8::from(relief.shape == ReliefShape::Linear));
                let root = f64::from(u8::from(matches!(self, Modification::RootRelief(_))));
                vec![relief.depth, relief.start_roll, linear, root]
            }
            Modification::Deviation(deviation) => deviation.samples(form),
            Modification::ProfileSlope(slope) => vec![*slope],
            Modification::Topography(topography) => topography.at_mid_face().samples(form),
            // Along the face, which a plane structure does not have.
            Modification::LeadCrown { .. } | Modification::HelixSlope(_) | Modification::LeadTable(_) => {
                Vec::new()
            }
        }
    }

    /// A tip relief by its depth at the tip circle (m), the roll angle at which it begins (rad) and its shape. Whether it lies on the
    /// flank is checked with the gear.
    pub fn tip_relief(depth: f64, start_roll: f64, shape: ReliefShape) -> Modification {
        Modification::TipRelief(TipRelief { depth, start_roll, shape })
    }
}

/// Amounts that depend on the roll angle and on the place along the face.
#[derive(Clone, Debug, PartialEq)]
pub struct Topography {
    amounts: TensorSpline,
}

impl Topography {
    /// Material taken off at a roll angle (rad, positive) and a distance from mid-face (m) *beyond* what is in mid-face, m, and its
    /// derivatives by both.
    pub fn beyond_mid_face(&self, roll: f64, z: f64) -> [f64; 3] {
        let (here, middle) = (self.amounts.at(roll, z), self.amounts.at(roll, 0.0));
        [here[0] - middle[0], here[1] - middle[1], here[2]]
    }

    /// The profile that it is in mid-face.
    fn at_mid_face(&self) -> Deviation {
        let middle = self.amounts.along_first(0.0);
        Deviation::new("a topography", move |roll| middle.at(roll)[0])
    }
}

/// What is taken off along the face alike at all heights of the flank.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LeadModification {
    /// A parabola that is zero in mid-face: its depth at both ends of the face, m.
    pub crown: f64,
    /// [`Modification::HelixSlope`], m.
    pub helix_slope: f64,
    /// Amounts by the distance from mid-face.
    pub tables: Vec<Arc<NaturalSpline>>,
}

impl LeadModification {
    /// The lead parts of modifications together.
    pub fn of(modifications: &[Modification]) -> LeadModification {
        let mut lead = LeadModification::default();
        for modification in modifications {
            match modification {
                Modification::LeadCrown { depth } => lead.crown += depth,
                Modification::HelixSlope(deviation) => lead.helix_slope += deviation,
                Modification::LeadTable(table) => lead.tables.push(table.clone()),
                _ => {}
            }
        }
        lead
    }

    /// Amount (m) on both flanks at a distance from mid-face (m), and its derivative; `face_width` in m. Without the slope, which is of
    /// opposite sense on the two.
    pub fn amount(&self, z: f64, face_width: f64) -> [f64; 2] {
        let part = 2.0 * z / face_width;
        let crown = [self.crown * part * part, 4.0 * self.crown * part / face_width];
        self.tables.iter().fold(crown, |[amount, slope], table| {
            let [value, rate, _] = table.at(z);
            [amount + value, slope + rate]
        })
    }
}

impl TipRelief {
    /// The relief of one end of the flank as the other end's of the flank turned round, where roll angles have the other sign.
    pub(crate) fn turned(self) -> TipRelief {
        TipRelief { start_roll: -self.start_roll, ..self }
    }

    /// Checks the relief against the teeth it is for, at their tip or their root.
    pub fn check(&self, form: &ToothForm, at_root: bool) -> Result<(), GeometryError> {
        let end = if at_root { "root" } else { "tip" };
        let (form_roll, tip_roll, tip_thickness) = (form.form_roll, form.tip_roll, form.tip_thickness());
        if !(form_roll..tip_roll).contains(&(form.sense() * self.start_roll)) {
            return Err(GeometryError::error(
                "E0640",
                "start_roll",
                sentence![
                    "the ", text end, " relief starts at a roll angle of ", angle self.start_roll,
                    ", but the involute runs from ", angle form_roll.abs(), " to ", angle tip_roll.abs()
                ],
                sentence![
                    "start the relief on the involute, usually near the last point of single-tooth contact towards that end"
                ],
            ));
        }
        if !(self.depth >= 0.0 && self.depth < 0.5 * tip_thickness) {
            return Err(GeometryError::error(
                "E0641",
                "depth",
                sentence![
                    "the ", text end, " relief is ", length self.depth, " deep, but must be between zero and half the tip thickness, ",
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
