//! Properties of beam sections from their dimensions.
//!
//! Areas and second moments are exact for sections of rectangles without fillets. Torsion
//! constants: solid rectangle by W. C. Young, R. G. Budynas, "Roark's Formulas for Stress and
//! Strain", table of torsion; closed thin-walled sections by Bredt; open thin-walled sections by
//! the sum of b t³ / 3.

use crate::model::BeamSection;
use std::f64::consts::PI;

/// Rectangle of a section: width along z, height along y, centre (y, z), sign of its area.
pub(super) struct Rectangle {
    pub width: f64,
    pub height: f64,
    pub centre: [f64; 2],
    pub sign: f64,
}

pub(super) fn rectangle(width: f64, height: f64, y: f64, z: f64) -> Rectangle {
    Rectangle { width, height, centre: [y, z], sign: 1.0 }
}

pub(super) fn hole(width: f64, height: f64, y: f64, z: f64) -> Rectangle {
    Rectangle { width, height, centre: [y, z], sign: -1.0 }
}

/// Section of rectangles about its centroid.
pub(super) fn composed(parts: &[Rectangle], torsion_constant: f64, shear_factors: [f64; 2]) -> BeamSection {
    let area: f64 = parts.iter().map(|part| part.sign * part.width * part.height).sum();
    let first = |axis: usize| -> f64 {
        parts.iter().map(|part| part.sign * part.width * part.height * part.centre[axis]).sum()
    };
    let centroid = [first(0) / area, first(1) / area];
    let mut section = BeamSection {
        area,
        second_moment_z: 0.0,
        second_moment_y: 0.0,
        product_of_inertia: 0.0,
        torsion_constant,
        shear_factors,
        added_mass: 0.0,
    };
    for part in parts {
        let (width, height) = (part.width, part.height);
        let [y, z] = [part.centre[0] - centroid[0], part.centre[1] - centroid[1]];
        section.second_moment_z += part.sign * width * height * (height * height / 12.0 + y * y);
        section.second_moment_y += part.sign * width * height * (width * width / 12.0 + z * z);
        section.product_of_inertia += part.sign * width * height * y * z;
    }
    section
}

/// Solid circle.
pub(super) fn circle(radius: f64, shear: f64) -> BeamSection {
    tube(radius, 0.0, shear)
}

/// Circular tube.
pub(super) fn tube(outer: f64, inner: f64, shear: f64) -> BeamSection {
    let moment = PI / 4.0 * (outer.powi(4) - inner.powi(4));
    BeamSection {
        area: PI * (outer * outer - inner * inner),
        second_moment_z: moment,
        second_moment_y: moment,
        product_of_inertia: 0.0,
        torsion_constant: 2.0 * moment,
        shear_factors: [shear; 2],
        added_mass: 0.0,
    }
}

/// Torsion constant of a solid rectangle.
pub(super) fn rectangle_torsion(width: f64, height: f64) -> f64 {
    let (long, short) = (width.max(height), width.min(height));
    let ratio = short / long;
    long * short.powi(3) * (1.0 / 3.0 - 0.21 * ratio * (1.0 - ratio.powi(4) / 12.0))
}

/// Torsion constant of a box of four walls: top, bottom, left, right.
pub(super) fn box_torsion(width: f64, height: f64, [top, bottom, left, right]: [f64; 4]) -> f64 {
    let (w, h) = (width - 0.5 * (left + right), height - 0.5 * (top + bottom));
    4.0 * (w * h).powi(2) / (w / top + w / bottom + h / left + h / right)
}

/// Torsion constant of an open thin-walled section of walls (length, thickness).
pub(super) fn open_torsion(walls: &[[f64; 2]]) -> f64 {
    walls.iter().map(|[length, thickness]| length * thickness.powi(3) / 3.0).sum()
}

/// Box about its centre with walls top, bottom, left, right.
pub(super) fn hollow_box(width: f64, height: f64, walls: [f64; 4], shear: Option<[f64; 2]>) -> BeamSection {
    let [top, bottom, left, right] = walls;
    let inner = [width - left - right, height - top - bottom];
    let parts = [
        rectangle(width, height, 0.0, 0.0),
        hole(inner[0], inner[1], 0.5 * (bottom - top), 0.5 * (left - right)),
    ];
    let area = width * height - inner[0] * inner[1];
    let shear = shear.unwrap_or([height * (left + right) / area, width * (top + bottom) / area]);
    composed(&parts, box_torsion(width, height, walls), shear)
}
