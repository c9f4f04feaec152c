//! Outer raceway that is displaced at each element, in addition to a rigid ring.
//!
//! Its displacement is radial: `v + s t` at the distance t along z from the middle of the contact of
//! an element. A contact with the angle α to the radial direction sees the normal component
//! `cos α (v + s ξ cos α)` at the distance ξ along the contact line. That is the displacement of a
//! ring that moves radially by v and turns by `s cos² α` about the middle of the contact.

use crate::element::{Local, Response};

/// Displacement of the outer raceway at an element, in addition to that of a rigid ring: radial,
/// outwards, in the middle of the contact ([`OuterContact`]), m; and its derivative along z.
pub type RacewayDisplacement = [f64; 2];

/// Load of an element on a raceway that is displaced.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RacewayLoad {
    /// Force and moment conjugate to [`RacewayDisplacement`], N and N m.
    pub force: [f64; 2],
    /// Decrease of the force by the displacement of the raceway.
    pub stiffness: [[f64; 2]; 2],
    /// Derivatives of the force with respect to the displacement of the inner ring.
    pub coupling: [[f64; 5]; 2],
}

/// Contacts of the elements of a row with the outer raceway, without load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OuterContact {
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

impl OuterContact {
    /// Returns the displacement of a rigid outer ring in the plane of an element that has the same
    /// effect on the contact: columns by [`RacewayDisplacement`]. `side` is the sense of the
    /// bearing's z axis in this plane.
    fn rigid(&self, side: f64) -> [[f64; 2]; 3] {
        let OuterContact { radius, position, angle, width } = *self;
        if width == 0.0 {
            return [[1.0, 0.0], [0.0; 2], [0.0; 2]];
        }
        let turn = side * libm::cos(angle).powi(2);
        [[1.0, -side * position * turn], [0.0, radius * turn], [0.0, turn]]
    }

    /// Subtracts the displacement of the outer raceway from that of the inner ring in the plane of
    /// an element.
    pub(crate) fn displace(&self, side: f64, ring: &mut Local, [radial, slope]: &RacewayDisplacement) {
        for (part, [by_radial, by_slope]) in ring.iter_mut().zip(self.rigid(side)) {
            *part -= by_radial * radial + by_slope * slope;
        }
    }

    /// Returns the load of an element on the outer raceway from its load on the inner ring.
    pub(crate) fn load(&self, side: f64, projection: &[[f64; 5]; 3], response: &Response) -> RacewayLoad {
        let outer = self.rigid(side);
        // Derivatives of the force by the displacement in the plane of the element.
        let by_ring = [0, 1].map(|row| {
            [0, 1, 2].map(|column| (0..3).map(|k| outer[k][row] * response.stiffness[k][column]).sum::<f64>())
        });
        RacewayLoad {
            force: [0, 1].map(|row| (0..3).map(|k| outer[k][row] * response.force[k]).sum()),
            stiffness: by_ring.map(|by| [0, 1].map(|column| (0..3).map(|k| by[k] * outer[k][column]).sum())),
            coupling: by_ring
                .map(|by| std::array::from_fn(|column| (0..3).map(|k| by[k] * projection[k][column]).sum())),
        }
    }
}
