//! Flank modifications (intended) and flank deviations (unintended) from the involute helicoid (ISO
//! 21771, ISO 1328-1).
//!
//! Both are an amount of removed material `a(roll, z)` along the normal of the involute in the
//! transverse plane, with `z` from mid-face. A *profile* part is constant along the face; the plane
//! flank ([`crate::flank::Flank`]) includes it completely. A *lead* part ([`LeadModification`]) is
//! constant along the profile and rotates sections about the axis. A *topography* ([`Topography`])
//! depends on both; it is split into its profile at mid-face and the remainder.

use crate::deviation::Deviation;
use crate::error::{GeometryError, sentence};
use crate::gear::ToothForm;
use crate::table_splines::{NaturalSpline, TensorSpline};
use std::sync::Arc;

/// Growth of a tip relief from its start to the tip circle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReliefShape {
    /// Proportional to the roll angle. The corner at the start is rounded over [`LINEAR_BLEND`] of
    /// its length to both sides, because no tool leaves a sharp corner.
    Linear,
    /// Proportional to the square of the roll angle.
    Quadratic,
}

/// Half-width of the rounding at the start of a linear relief, as a fraction of the relief's roll
/// range.
pub const LINEAR_BLEND: f64 = 0.05;

/// Tip relief. As a root relief, "tip" stands for the form circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TipRelief {
    /// Amount at the tip circle, m.
    pub depth: f64,
    /// Roll angle at the start, rad.
    pub start_roll: f64,
    /// Shape of the relief.
    pub shape: ReliefShape,
}

/// Modification or deviation of the flank.
#[derive(Clone, Debug, PartialEq)]
pub enum Modification {
    /// Tip relief.
    TipRelief(TipRelief),
    /// Root relief, largest at the form circle.
    RootRelief(TipRelief),
    /// Deviation given by a function of the program.
    Deviation(Deviation),
    /// Profile slope deviation: excess material at the tip circle, proportional to the roll angle
    /// from zero at the form circle, m; negative where material is missing.
    ProfileSlope(f64),
    /// Helix slope deviation over the face width, measured along the base tangent, m; positive
    /// towards a right-hand helix.
    HelixSlope(f64),
    /// Table of amounts over the distance from mid-face (m), constant along the profile.
    LeadTable(Arc<NaturalSpline>),
    /// Table of amounts over the roll angle and the distance from mid-face.
    Topography(Arc<Topography>),
    /// Crowning: a parabola along the face with this amount at both ends. Plane models ignore it.
    LeadCrown {
        /// Amount at both ends of the face, m.
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
    /// Creates a crowning with this amount at both ends of the face.
    ///
    /// # Errors
    /// E0666: the amount is negative.
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

    /// Creates a profile modification from a table of amounts (m) over ascending roll angles (rad).
    /// A spline interpolates them and continues straight beyond both ends.
    ///
    /// # Errors
    /// E0643: the table is not valid.
    pub fn profile_table(rolls: Vec<f64>, depths: Vec<f64>) -> Result<Modification, GeometryError> {
        let spline = NaturalSpline::new("roll_angles", rolls, depths)?;
        Ok(Deviation::new("a profile table", move |roll| spline.at(roll)[0]).into())
    }

    /// Creates a lead modification from a table of amounts (m) over ascending distances from
    /// mid-face (m), interpolated by a spline.
    ///
    /// # Errors
    /// E0643: the table is not valid.
    pub fn lead_table(places: Vec<f64>, depths: Vec<f64>) -> Result<Modification, GeometryError> {
        Ok(Modification::LeadTable(Arc::new(NaturalSpline::new("axial_positions", places, depths)?)))
    }

    /// Creates a topography from a table of amounts over the roll angle (rad) and the distance from
    /// mid-face (m). Each roll angle has one row along the face.
    ///
    /// # Errors
    /// E0643: the table is not valid.
    pub fn topography(
        rolls: Vec<f64>,
        places: Vec<f64>,
        depths: Vec<f64>,
    ) -> Result<Modification, GeometryError> {
        let amounts = TensorSpline::new(["roll_angles", "axial_positions"], [rolls, places], depths)?;
        Ok(Modification::Topography(Arc::new(Topography { amounts })))
    }

    /// Splits the modification into its profile part and its part along the face.
    ///
    /// Flanks, keys of structures and reports use the parts alone. So this is the only place that
    /// distinguishes the modifications.
    pub(crate) fn parts(&self) -> Parts {
        let profile = |profile: ProfilePart| Parts { profile: Some(profile), lead: None };
        let lead = |function, lead| Parts { profile: None, lead: Some((function, lead)) };
        match self {
            Modification::TipRelief(relief) => profile(ProfilePart::TipRelief(*relief)),
            Modification::RootRelief(relief) => profile(ProfilePart::RootRelief(*relief)),
            Modification::Deviation(deviation) => profile(ProfilePart::Deviation(deviation.clone())),
            Modification::ProfileSlope(slope) => profile(ProfilePart::Slope(*slope)),
            Modification::HelixSlope(deviation) => lead("helix_slope", LeadPart::HelixSlope(*deviation)),
            Modification::LeadTable(table) => lead("lead_table", LeadPart::Table(table.clone())),
            Modification::LeadCrown { depth } => lead("lead_crown", LeadPart::Crown(*depth)),
            Modification::Topography(topography) => Parts {
                profile: Some(ProfilePart::Deviation(topography.at_mid_face())),
                lead: Some(("topography", LeadPart::Topography(topography.clone()))),
            },
        }
    }

    /// Creates a tip relief from its amount at the tip circle (m), the roll angle at its start
    /// (rad) and its shape. Whether it lies on the flank is checked with the gear.
    pub fn tip_relief(depth: f64, start_roll: f64, shape: ReliefShape) -> Modification {
        Modification::TipRelief(TipRelief { depth, start_roll, shape })
    }
}

/// Returns the library functions of the modifications with a part along the face, which a plane
/// model ignores.
pub(crate) fn along_face(modifications: &[Modification]) -> impl Iterator<Item = &'static str> {
    let leads = modifications.iter().filter_map(|modification| modification.parts().lead);
    leads.filter(|(_, part)| !part.vanishes()).map(|(function, _)| function)
}

/// Parts of a modification by the coordinate on which they depend.
pub(crate) struct Parts {
    /// Part over the roll angle, equal in all transverse sections.
    pub profile: Option<ProfilePart>,
    /// Part that vanishes at mid-face, and the library function that creates it. Plane models
    /// ignore it.
    pub lead: Option<(&'static str, LeadPart)>,
}

/// Modification of the profile.
pub(crate) enum ProfilePart {
    /// Tip relief.
    TipRelief(TipRelief),
    /// Root relief.
    RootRelief(TipRelief),
    /// [`Modification::ProfileSlope`], m.
    Slope(f64),
    /// Amount given by a function of the roll angle.
    Deviation(Deviation),
}

impl ProfilePart {
    /// Returns all values on which a structure of these teeth may depend.
    pub fn numbers(&self, form: &ToothForm) -> Vec<f64> {
        let of_relief = |relief: &TipRelief, at_root: bool| {
            let linear = relief.shape == ReliefShape::Linear;
            vec![relief.depth, relief.start_roll, f64::from(u8::from(linear)), f64::from(u8::from(at_root))]
        };
        match self {
            ProfilePart::TipRelief(relief) => of_relief(relief, false),
            ProfilePart::RootRelief(relief) => of_relief(relief, true),
            ProfilePart::Slope(slope) => vec![*slope],
            ProfilePart::Deviation(deviation) => deviation.samples(form),
        }
    }
}

/// Modification along the face.
pub(crate) enum LeadPart {
    /// Amount of a crowning at both ends of the face, m.
    Crown(f64),
    /// [`Modification::HelixSlope`], m.
    HelixSlope(f64),
    /// Amounts over the distance from mid-face.
    Table(Arc<NaturalSpline>),
    /// Amounts over both coordinates, minus those at mid-face.
    Topography(Arc<Topography>),
}

impl LeadPart {
    /// Returns whether the part removes nothing.
    pub fn vanishes(&self) -> bool {
        match self {
            LeadPart::Crown(amount) | LeadPart::HelixSlope(amount) => *amount == 0.0,
            LeadPart::Table(_) | LeadPart::Topography(_) => false,
        }
    }
}

/// Modification that depends on the roll angle and on the position along the face.
#[derive(Clone, Debug, PartialEq)]
pub struct Topography {
    amounts: TensorSpline,
}

impl Topography {
    /// Material removed at a roll angle (rad, positive) and a distance from mid-face (m) *minus*
    /// that at mid-face, m, and its derivatives by both.
    pub fn beyond_mid_face(&self, roll: f64, z: f64) -> [f64; 3] {
        let (here, middle) = (self.amounts.at(roll, z), self.amounts.at(roll, 0.0));
        [here[0] - middle[0], here[1] - middle[1], here[2]]
    }

    /// Profile at mid-face.
    fn at_mid_face(&self) -> Deviation {
        let middle = self.amounts.along_first(0.0);
        Deviation::new("a topography", move |roll| middle.at(roll)[0])
    }
}

/// Sum of the parts of modifications along the face.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LeadModification {
    /// Crowning: parabola that is zero at mid-face; its amount at both ends of the face, m.
    pub crown: f64,
    /// [`Modification::HelixSlope`], m.
    pub helix_slope: f64,
    /// Tables of amounts over the distance from mid-face.
    pub tables: Vec<Arc<NaturalSpline>>,
    /// Amounts that depend on the roll angle too.
    pub topographies: Vec<Arc<Topography>>,
}

impl LeadModification {
    /// Sums the lead parts of modifications.
    pub fn of(modifications: &[Modification]) -> LeadModification {
        let mut lead = LeadModification::default();
        for modification in modifications {
            match modification.parts().lead.map(|(_, part)| part) {
                Some(LeadPart::Crown(depth)) => lead.crown += depth,
                Some(LeadPart::HelixSlope(deviation)) => lead.helix_slope += deviation,
                Some(LeadPart::Table(table)) => lead.tables.push(table),
                Some(LeadPart::Topography(topography)) => lead.topographies.push(topography),
                None => {}
            }
        }
        lead
    }

    /// Amount (m) on both flanks at a distance from mid-face (m), and its derivative; `face_width`
    /// in m. It excludes the helix slope deviation, whose sense is opposite on the two flanks, and
    /// topographies, which depend on the roll angle.
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
    /// Relief of one end of the flank expressed for the other end of the reversed flank, where roll
    /// angles change sign.
    pub(crate) fn turned(self) -> TipRelief {
        TipRelief { start_roll: -self.start_roll, ..self }
    }

    /// Checks the relief against the tip or the root of the teeth.
    pub fn check(&self, form: &ToothForm, at_root: bool) -> Result<(), GeometryError> {
        let end = if at_root { "root" } else { "tip" };
        let (form_roll, tip_roll, tip_thickness) = (form.form_roll, form.tip_roll, form.tip_thickness());
        if !(form_roll..tip_roll).contains(&(form.sense() * self.start_roll)) {
            return Err(GeometryError::error(
                "E0640",
                "start_roll_angle",
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

    /// Half-width of the rounding at the start in roll angle; it never extends below the form
    /// circle.
    fn blend(&self, form_roll: f64, tip_roll: f64) -> f64 {
        match self.shape {
            ReliefShape::Linear => {
                (LINEAR_BLEND * (tip_roll - self.start_roll)).min(self.start_roll - form_roll)
            }
            ReliefShape::Quadratic => 0.0,
        }
    }

    /// Roll angles at which the second derivative of the amount is discontinuous, ascending.
    pub fn breaks(&self, form_roll: f64, tip_roll: f64) -> Vec<f64> {
        let blend = self.blend(form_roll, tip_roll);
        if blend > 0.0 {
            vec![self.start_roll - blend, self.start_roll + blend]
        } else {
            vec![self.start_roll]
        }
    }

    /// Amount (m) at a roll angle, and its first and second derivatives by the roll angle.
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
                    // Parabola tangent to both straight parts.
                    let into = from_start + blend;
                    [slope * into * into / (4.0 * blend), slope * into / (2.0 * blend), slope / (2.0 * blend)]
                } else {
                    [slope * from_start, slope, 0.0]
                }
            }
        }
    }
}
