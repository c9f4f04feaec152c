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
use crate::fillet::Side;
use crate::gear::ToothForm;
use crate::relief::ReliefRange;
pub(crate) use crate::relief::without_start;
pub use crate::relief::{LARGEST_EXPONENT, LINEAR_BLEND, ReliefShape, ReliefStart, TipRelief};
use crate::table_splines::{NaturalSpline, TensorSpline};
use std::sync::Arc;

/// Flank of a tooth by its position (ISO 1122-1): seen from the end of the face towards +z, with
/// the tip of the tooth upwards.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ToothFlank {
    /// Left flank: counter-clockwise side of an external tooth, clockwise side of an internal one.
    Left,
    /// Right flank.
    Right,
}

impl ToothFlank {
    /// Side of the tooth on which the flank lies.
    pub fn side(self, internal: bool) -> Side {
        match (self == ToothFlank::Left) != internal {
            true => Side::CounterClockwise,
            false => Side::Clockwise,
        }
    }
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
    /// Profile crowning `C_alpha`: a parabola over the roll angle that is zero midway between root
    /// form circle and tip circle and has this amount at both, m.
    ProfileCrown(f64),
    /// End relief. Plane models ignore it.
    EndRelief(EndRelief),
    /// Flank twist: profile slope deviation at the end of the face towards +z minus that at the
    /// other end, m. It is zero at mid-face and midway between root form circle and tip circle.
    /// Plane models ignore it.
    Twist(f64),
    /// Modification of one flank of every tooth.
    OneFlank(ToothFlank, Arc<Modification>),
    /// Deviation of the made flank from its design. Analyses treat it as any modification; charts
    /// compare it with the tolerances.
    Unintended(Arc<Modification>),
}

/// Ends of the face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FaceEnds {
    /// Both ends.
    Both,
    /// End towards +z.
    Positive,
    /// End towards -z.
    Negative,
}

/// Relief at the ends of the face, constant along the profile.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EndRelief {
    /// Amount at the end of the face, m.
    pub depth: f64,
    /// Axial length, m.
    pub length: f64,
    /// Growth from the start to the end of the face.
    pub shape: ReliefShape,
    /// Ends with the relief.
    pub ends: FaceEnds,
}

impl EndRelief {
    /// Checks the relief against the face width (m).
    ///
    /// # Errors
    /// E0938: the relief extends beyond mid-face, or is an arc of at least half its length.
    pub fn check(&self, face_width: f64) -> Result<(), GeometryError> {
        if !(self.length > 0.0 && self.length <= 0.5 * face_width) {
            return Err(GeometryError::error(
                "E0938",
                "length",
                sentence![
                    "the end relief is ", length self.length, " long, but must be between zero and half the face width, ",
                    length 0.5 * face_width
                ],
                sentence![
                    "reduce the length, or use `lead_crown` or `lead_table` for a modification over the whole face"
                ],
            ));
        }
        if self.shape == ReliefShape::Arc && self.depth >= 0.5 * self.length {
            return Err(GeometryError::error(
                "E0938",
                "depth",
                sentence![
                    "the end relief is ", length self.depth, " deep, but an arc of a length of ", length self.length,
                    " can only be half as deep as it is long"
                ],
                sentence!["reduce the depth, or make the relief longer"],
            ));
        }
        Ok(())
    }

    /// Amount (m) at a distance from mid-face (m), and its derivative; `face_width` in m.
    pub fn amount(&self, z: f64, face_width: f64) -> [f64; 2] {
        let start = 0.5 * face_width - self.length;
        let range = ReliefRange { length: self.length, room: start, metres: 1.0 };
        let at = |sign: f64| {
            let [amount, slope, _] = self.shape.amount(self.depth, sign * z - start, &range);
            [amount, sign * slope]
        };
        match self.ends {
            // Up to mid-face, only one of the ends removes material.
            FaceEnds::Both => at(if z < 0.0 { -1.0 } else { 1.0 }),
            FaceEnds::Positive => at(1.0),
            FaceEnds::Negative => at(-1.0),
        }
    }
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
            Modification::ProfileCrown(depth) => profile(ProfilePart::Crown(*depth)),
            Modification::EndRelief(relief) => lead("end_relief", LeadPart::EndRelief(*relief)),
            Modification::Twist(twist) => lead("twist", LeadPart::Twist(*twist)),
            Modification::OneFlank(_, modification) | Modification::Unintended(modification) => {
                modification.parts()
            }
            Modification::Topography(topography) => Parts {
                profile: Some(ProfilePart::Deviation(topography.at_mid_face())),
                lead: Some(("topography", LeadPart::Topography(topography.clone()))),
            },
        }
    }

    /// Creates a tip relief from its amount at the tip circle (m), the roll angle at its start
    /// (rad) and its shape. Whether it lies on the flank is checked with the gear.
    pub fn tip_relief(depth: f64, start_roll: f64, shape: ReliefShape) -> Modification {
        Modification::TipRelief(TipRelief { depth, start: ReliefStart::at_roll(start_roll), shape })
    }

    /// Restricts the modification to one flank of every tooth.
    #[must_use]
    pub fn on(self, flank: ToothFlank) -> Modification {
        Modification::OneFlank(flank, Arc::new(self))
    }

    /// Marks the modification as a deviation of the made flank from its design.
    #[must_use]
    pub fn unintended(self) -> Modification {
        Modification::Unintended(Arc::new(self))
    }

    /// Returns whether the modification is a deviation from the design.
    pub fn is_unintended(&self) -> bool {
        match self {
            Modification::Unintended(_) => true,
            Modification::OneFlank(_, inner) => inner.is_unintended(),
            _ => false,
        }
    }

    /// Returns whether the modification applies to a side of the teeth.
    pub(crate) fn applies_to(&self, side: Side, internal: bool) -> bool {
        match self {
            Modification::OneFlank(flank, inner) => {
                flank.side(internal) == side && inner.applies_to(side, internal)
            }
            Modification::Unintended(inner) => inner.applies_to(side, internal),
            _ => true,
        }
    }

    /// Checks the modification against the face width (m).
    ///
    /// # Errors
    /// E0938: an end relief does not fit.
    pub(crate) fn check_face(&self, face_width: f64) -> Result<(), GeometryError> {
        match self {
            Modification::EndRelief(relief) => relief.check(face_width),
            Modification::OneFlank(_, inner) | Modification::Unintended(inner) => {
                inner.check_face(face_width)
            }
            _ => Ok(()),
        }
    }

    /// Returns all values on which a plane structure of these teeth may depend.
    pub(crate) fn profile_numbers(&self, form: &ToothForm) -> Vec<f64> {
        let Some(profile) = self.parts().profile else { return Vec::new() };
        let sides = [Side::CounterClockwise, Side::Clockwise];
        let applies = sides.map(|side| f64::from(u8::from(self.applies_to(side, form.internal))));
        [profile.numbers(form), applies.to_vec()].concat()
    }
}

/// Checks modifications against the face width (m).
///
/// # Errors
/// E0938: an end relief does not fit.
pub(crate) fn check_faces(modifications: &[Modification], face_width: f64) -> Result<(), Vec<GeometryError>> {
    let wrong = modifications.iter().filter_map(|one| one.check_face(face_width).err());
    let wrong: Vec<GeometryError> = wrong.collect();
    if wrong.is_empty() { Ok(()) } else { Err(wrong) }
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
    /// [`Modification::ProfileCrown`], m.
    Crown(f64),
    /// Amount given by a function of the roll angle.
    Deviation(Deviation),
}

impl ProfilePart {
    /// Returns all values on which a structure of these teeth may depend.
    pub fn numbers(&self, form: &ToothForm) -> Vec<f64> {
        let of_relief = |relief: &TipRelief, at_root: bool| {
            let start = relief.start_roll(form, at_root).unwrap_or(f64::NAN);
            vec![relief.depth, start, relief.shape.number(), f64::from(u8::from(at_root))]
        };
        match self {
            ProfilePart::TipRelief(relief) => of_relief(relief, false),
            ProfilePart::RootRelief(relief) => of_relief(relief, true),
            ProfilePart::Slope(slope) => vec![*slope],
            ProfilePart::Crown(depth) => vec![*depth, 1.0],
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
    /// End relief.
    EndRelief(EndRelief),
    /// [`Modification::Twist`], m.
    Twist(f64),
}

impl LeadPart {
    /// Returns whether the part removes nothing.
    pub fn vanishes(&self) -> bool {
        match self {
            LeadPart::Crown(amount) | LeadPart::HelixSlope(amount) | LeadPart::Twist(amount) => {
                *amount == 0.0
            }
            LeadPart::EndRelief(relief) => relief.depth == 0.0,
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
    /// End reliefs.
    pub end_reliefs: Vec<EndRelief>,
    /// Amounts that depend on the roll angle too.
    pub topographies: Vec<Arc<Topography>>,
    /// [`Modification::Twist`], m.
    pub flank_twist: f64,
}

impl LeadModification {
    /// Sums the lead parts of modifications on one side of the teeth.
    pub fn of(modifications: &[Modification], side: Side, internal: bool) -> LeadModification {
        let mut lead = LeadModification::default();
        for modification in modifications.iter().filter(|one| one.applies_to(side, internal)) {
            match modification.parts().lead.map(|(_, part)| part) {
                Some(LeadPart::Crown(depth)) => lead.crown += depth,
                Some(LeadPart::HelixSlope(deviation)) => lead.helix_slope += deviation,
                Some(LeadPart::Table(table)) => lead.tables.push(table),
                Some(LeadPart::Topography(topography)) => lead.topographies.push(topography),
                Some(LeadPart::EndRelief(relief)) => lead.end_reliefs.push(relief),
                Some(LeadPart::Twist(twist)) => lead.flank_twist += twist,
                None => {}
            }
        }
        lead
    }

    /// Amount (m) at a distance from mid-face (m), and its derivative; `face_width` in m. It
    /// excludes the helix slope deviation, whose sense is opposite on the two flanks, and
    /// topographies and twist, which depend on the roll angle.
    pub fn amount(&self, z: f64, face_width: f64) -> [f64; 2] {
        let part = 2.0 * z / face_width;
        let crown = [self.crown * part * part, 4.0 * self.crown * part / face_width];
        let tables = self.tables.iter().map(|table| {
            let [value, rate, _] = table.at(z);
            [value, rate]
        });
        let reliefs = self.end_reliefs.iter().map(|relief| relief.amount(z, face_width));
        tables.chain(reliefs).fold(crown, |[amount, slope], [value, rate]| [amount + value, slope + rate])
    }

    /// Returns whether some amount depends on the roll angle and on the position along the face.
    pub(crate) fn varies_over_both(&self) -> bool {
        self.flank_twist != 0.0 || !self.topographies.is_empty()
    }
}
