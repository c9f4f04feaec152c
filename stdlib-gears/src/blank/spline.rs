//! Supports of a rim by spline teeth.

use crate::error::{GeometryError, sentence};
use calyx_runtime::structure::SplineTeeth;
use std::f64::consts::TAU;

/// Support of a rim by equally spaced spline teeth or keys. They carry load in both directions;
/// without clearance they have no backlash.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SplineSupport {
    /// Number of spline teeth, at least three; it need not be commensurate with the number of gear
    /// teeth.
    pub spline_teeth: u16,
    /// Length of each spline tooth along the bore circle, m; `None` selects half of their pitch.
    pub width: Option<f64>,
    /// Angle from the middle of gear tooth 0 to the middle of the first spline tooth, rad,
    /// counter-clockwise.
    pub first: f64,
    /// Circumferential stiffness per unit of axial length of a spline tooth, N/m²; `None` if rigid.
    pub stiffness: Option<f64>,
    /// Radial constraint of the bore at the spline teeth, as in major-diameter fits; `None` if
    /// there is none.
    pub radial: Option<RadialFit>,
    /// Degree of the polynomials along the bore that the spline teeth constrain: 0 constrains the
    /// mean, 1 also the tilt.
    pub axial_order: u8,
    /// Clearance: width of a space minus thickness of a spline tooth along the bore circle, m. A
    /// centred tooth has half of it on either flank. With clearance, the spline teeth are contact
    /// cells of a two-dimensional model and support a body whose frame is free. 0 constrains them
    /// without backlash.
    pub clearance: f64,
}

/// Radial constraint of a bore by spline teeth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RadialFit {
    /// Radial stiffness per unit of axial length of a spline tooth, N/m²; `None` if rigid.
    pub stiffness: Option<f64>,
}

impl SplineSupport {
    /// Creates rigid spline teeth that support a bore by their flanks.
    pub fn new(spline_teeth: u16) -> SplineSupport {
        SplineSupport {
            spline_teeth,
            width: None,
            first: 0.0,
            stiffness: None,
            radial: None,
            axial_order: 1,
            clearance: 0.0,
        }
    }

    /// Returns the spline teeth at a radius, m.
    pub(super) fn at(&self, radius: f64) -> Result<SplineTeeth, GeometryError> {
        let wrong = |argument, message, help| GeometryError::error("E0655", argument, message, help);
        if self.spline_teeth < 3 {
            return Err(wrong(
                "teeth",
                sentence!["a spline needs at least three teeth to centre a rim; it has ", number f64::from(self.spline_teeth)],
                sentence!["give at least 3"],
            ));
        }
        let pitch = TAU * radius / f64::from(self.spline_teeth);
        let width = self.width.unwrap_or(0.5 * pitch);
        if !(width > 0.0 && width <= pitch * (1.0 + 1e-9)) {
            return Err(wrong(
                "width",
                sentence![
                    "spline teeth of width ", length width, " do not fit around the rim, where the spline pitch is ", length pitch
                ],
                sentence!["reduce `width`, or omit it for half the spline pitch"],
            ));
        }
        let fits = self.clearance > 0.0 && width + self.clearance < pitch;
        if self.clearance != 0.0 && !fits {
            return Err(GeometryError::error(
                "E0754",
                "clearance",
                sentence![
                    "a clearance of ", length self.clearance, " on spline teeth of width ", length width, " does not fit within the spline pitch of ",
                    length pitch
                ],
                sentence![
                    "give the difference of the widths of a space and a spline tooth, or 0 for a spline without backlash"
                ],
            ));
        }
        let compliance = |argument: &'static str, stiffness: Option<f64>| match stiffness {
            None => Ok(0.0),
            Some(stiffness) if stiffness > 0.0 && stiffness.is_finite() => Ok(1.0 / stiffness),
            Some(_) => Err(wrong(
                argument,
                sentence!["the stiffness of spline teeth must be positive"],
                sentence!["omit it for rigid spline teeth"],
            )),
        };
        let radial = match self.radial {
            Some(fit) => Some(compliance("radial_stiffness", fit.stiffness)?),
            None => None,
        };
        Ok(SplineTeeth {
            count: self.spline_teeth,
            first: self.first,
            width: width / radius,
            tangential: compliance("stiffness", self.stiffness)?,
            radial,
            degree: self.axial_order,
        })
    }
}
