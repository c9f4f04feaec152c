//! Bores of gears with tabulated teeth.

use super::boundary::root_end;
use super::section::SectionCones;
use super::solid_mesh::Bore;
use super::tooth::Tooth;
use crate::error::{GeometryError, sentence};
use crate::sector_mesh::THINNEST_RIM;

/// Rim thickness, in equivalent modules, if none is given.
const DEFAULT_RIM: f64 = 1.5;
/// Number of sections at which the rim is checked.
const RIM_SECTIONS: usize = 8;

/// Bore of a tabulated gear, a cone or a cylinder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BoreShape {
    /// Rim of this thickness under the root in the middle section, normal to the pitch cone, m;
    /// `None` selects 1.5 equivalent modules. The generator of the bore has an angle to the axis
    /// (rad), or is parallel to the root.
    Rim {
        /// Thickness.
        thickness: Option<f64>,
        /// Angle of the generator.
        angle: Option<f64>,
    },
    /// Cylinder of this diameter, m.
    Cylinder(f64),
}

/// Lower end of the fillets in a section, m.
fn root_height(tooth: &Tooth, v: f64) -> f64 {
    [0, 1].map(|side| root_end(tooth, side, v)[0]).into_iter().fold(f64::INFINITY, f64::min)
}

/// Computes the bore and checks the rim.
pub(super) fn bore_of(tooth: &Tooth, shape: BoreShape, pitch_angle: f64) -> Result<Bore, GeometryError> {
    let module = tooth.module;
    let [start, end] = tooth.face;
    let cones: &SectionCones = &tooth.cones;
    let (bore, argument) = match shape {
        BoreShape::Cylinder(diameter) => {
            let at = |v: f64| cones.height_at_radius(tooth.along(v), 0.5 * diameter);
            let (Some(from), Some(to)) = (at(start), at(end)) else {
                return Err(GeometryError::error(
                    "E0973",
                    "bore_diameter",
                    sentence![
                        "a crown gear, with a pitch angle of 90 deg, cannot have a cylindrical bore below its teeth"
                    ],
                    sentence!["give `rim_thickness` instead"],
                ));
            };
            let slope = (to - from) / (end - start);
            (Bore { height: from - slope * start, slope }, "bore_diameter")
        }
        BoreShape::Rim { thickness, angle } => {
            let slope = match angle {
                None => (root_height(tooth, end) - root_height(tooth, start)) / (end - start),
                Some(angle) => cones.sense * (angle - pitch_angle).tan(),
            };
            let thickness = thickness.unwrap_or(DEFAULT_RIM * module);
            let argument = if angle.is_some() { "bore_angle" } else { "rim_thickness" };
            (Bore { height: root_height(tooth, 0.0) - thickness, slope }, argument)
        }
    };
    for k in 0..=RIM_SECTIONS {
        let v = start + (end - start) * k as f64 / RIM_SECTIONS as f64;
        let thickness = root_height(tooth, v) - bore.at(v);
        let thinnest = THINNEST_RIM * module;
        // The comparisons are negated so that NaN fails them.
        let thick = thickness >= thinnest * (1.0 - 1e-9);
        if !thick {
            return Err(GeometryError::error(
                "E0973",
                argument,
                sentence![
                    "the rim is ", length thickness, " thick at ", length v, " from the middle of the face and must be ", at_least length thinnest
                ],
                sentence!["give a thicker rim, or a smaller bore"],
            ));
        }
        let radius = cones.radius(tooth.along(v), bore.at(v));
        let outside = radius > 0.0;
        if !outside {
            return Err(GeometryError::error(
                "E0973",
                argument,
                sentence!["the bore reaches beyond the axis at ", length v, " from the middle of the face"],
                sentence!["reduce the thickness of the rim, or give `bore_diameter`"],
            ));
        }
    }
    Ok(bore)
}
