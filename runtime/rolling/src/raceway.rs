//! Raceways that are displaced at each element, in addition to rigid rings.
//!
//! The displacement of a raceway is radial: `v + s t` at the distance t along z from the middle of
//! the contact of an element. A contact with the angle α to the radial direction sees the normal
//! component `cos α (v + s ξ cos α)` at the distance ξ along the contact line. That is the
//! displacement of a ring that moves radially by v and rotates by `s cos² α` about the middle of
//! the contact. An element sees only the displacement of both rings relative to each other, so
//! those of both raceways add up.

use crate::element::{Local, Response};

/// Ring of a rolling bearing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ring {
    /// Inner ring, whose raceway is inside of the elements.
    Inner,
    /// Outer ring, whose raceway is around the elements.
    Outer,
}

/// Displacement of the outer relative to the inner raceway at an element, in addition to that of
/// rigid rings, in the axial plane of the element: radial, m; axial, m, positive along the z axis
/// of a row that is not mirrored; rotation from axial to radial, rad.
/// [`Row::relative_displacements`](crate::bearing::Row::relative_displacements) converts radial
/// displacements of raceways to it.
pub type RacewayDisplacement = [f64; 3];

/// Load of an element between raceways that are displaced.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RacewayLoad {
    /// Forces and moment conjugate to [`RacewayDisplacement`], N and N m.
    pub force: [f64; 3],
    /// Decrease of the force by the displacement of the raceways.
    pub stiffness: [[f64; 3]; 3],
    /// Derivatives of the force with respect to the displacement of the inner ring.
    pub coupling: [[f64; 5]; 3],
}

/// Contacts of the elements of a row with a raceway, without load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RacewayContact {
    /// Radius of the middle of the contact, m: of the bottom of the groove of deep groove and
    /// four-point bearings.
    pub radius: f64,
    /// Position of the middle from the centres of the elements along the axis of the bearing, m.
    pub position: f64,
    /// Contact angle, rad.
    pub angle: f64,
    /// Length of the contact line along the axis, m; 0 for balls.
    pub width: f64,
}

impl RacewayContact {
    /// Returns the displacement of a rigid ring in the plane of an element that has the same effect
    /// on the contact as a radial displacement of its raceway and the derivative of this along z
    /// (columns). `side` is the sense of the bearing's z axis in this plane.
    pub(crate) fn rigid_motions(&self, side: f64) -> [[f64; 2]; 3] {
        let RacewayContact { radius, position, angle, width } = *self;
        if width == 0.0 {
            return [[1.0, 0.0], [0.0; 2], [0.0; 2]];
        }
        let rotation = side * libm::cos(angle).powi(2);
        [[1.0, -side * position * rotation], [0.0, radius * rotation], [0.0, rotation]]
    }
}

/// Subtracts a displacement of the outer relative to the inner raceway from that of the inner ring
/// in the plane of an element.
pub(crate) fn displace(ring: &mut Local, displacement: &RacewayDisplacement) {
    ring.iter_mut().zip(displacement).for_each(|(part, moved)| *part -= moved);
}

impl RacewayLoad {
    /// Returns the load conjugate to the displacement of the raceways from the load on the inner
    /// ring, which has no part of the centrifugal force.
    pub(crate) fn of(projection: &[[f64; 5]; 3], response: &Response) -> Self {
        let by_ring = |row: &[f64; 3], column: usize| -> f64 {
            row.iter().zip(projection).map(|(entry, projection)| entry * projection[column]).sum()
        };
        let coupling = response.stiffness.map(|row| std::array::from_fn(|column| by_ring(&row, column)));
        Self { force: response.force, stiffness: response.stiffness, coupling }
    }
}
