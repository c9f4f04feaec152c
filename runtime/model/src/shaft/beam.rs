//! Flexibility of a stretch of a beam between two stations, and what follows from it: the forces at
//! its ends and the displacements between them.
//!
//! With the start of the stretch clamped and a force F and a moment M at its end, in the plane of x
//! and z, the section at z has the rotation and displacement
//!
//! ```text
//! theta(z) = int (M + F (L - s)) / EI ds
//! u(z)     = int ((z - s) (M + F (L - s)) / EI + F / kappa GA) ds,    0 <= s <= z,
//! ```
//!
//! which are combinations of the integrals of 1, s and s² over EI and of 1 over kappa GA.

use super::Six;
use super::segment::Section;
use calyx_fe::material::Material;

/// Integrals of the compliances of sections over a part of a stretch that begins at its start.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Integrals {
    /// Integral of `1 / EA`.
    axial: f64,
    /// Integral of `1 / kappa G A`.
    shear: f64,
    /// Integrals of `1 / EI`, `s / EI` and `s² / EI`.
    bending: [f64; 3],
    /// Integral of `1 / GJ`.
    torsion: f64,
}

impl Integrals {
    /// Adds a section at the lever arm `s`, with a weight.
    pub(super) fn plus(self, section: &Section, material: &Material, s: f64, weight: f64) -> Integrals {
        let [axial, shear, bending, torsion] = section.compliances(material).map(|part| weight * part);
        let [zeroth, first, second] = self.bending;
        Integrals {
            axial: self.axial + axial,
            shear: self.shear + shear,
            bending: [zeroth + bending, first + s * bending, second + s * s * bending],
            torsion: self.torsion + torsion,
        }
    }

    /// Returns the coefficients of a plane of bending at `z` of a stretch of length `length`:
    /// displacement by force and by moment, rotation by force and by moment.
    fn bent(&self, z: f64, length: f64) -> [f64; 4] {
        let [zeroth, first, second] = self.bending;
        let displacement = z * length * zeroth - (z + length) * first + second + self.shear;
        [displacement, z * zeroth - first, length * zeroth - first, zeroth]
    }
}

/// Returns the motion of a section at a distance along a rigid shaft.
pub(super) fn carried(distance: f64, &[ux, uy, uz, tx, ty, tz]: &Six) -> Six {
    [ux + distance * ty, uy - distance * tx, uz, tx, ty, tz]
}

/// Returns a force that acts at a distance along the shaft, with its moment about the origin.
pub(super) fn force_moved(distance: f64, &[fx, fy, fz, mx, my, mz]: &Six) -> Six {
    [fx, fy, fz, mx - distance * fy, my + distance * fx, mz]
}

/// Stretch of a shaft between two stations.
pub(super) struct Stretch {
    length: f64,
    flexibility: Integrals,
}

impl Stretch {
    pub(super) fn new(length: f64, flexibility: Integrals) -> Stretch {
        Stretch { length, flexibility }
    }

    /// Returns the force on the end that causes this motion relative to the clamped start.
    fn force(&self, &[ux, uy, uz, tx, ty, tz]: &Six) -> Six {
        let Integrals { axial, torsion, .. } = self.flexibility;
        let [a, b, _, c] = self.flexibility.bent(self.length, self.length);
        let determinant = a * c - b * b;
        let solved = |u: f64, t: f64| [(c * u - b * t) / determinant, (a * t - b * u) / determinant];
        // Rotation about x displaces along -y.
        let ([fx, my], [fy, mx]) = (solved(ux, ty), solved(uy, -tx));
        [fx, fy, uz / axial, -mx, my, tz / torsion]
    }

    /// Returns the forces on both ends of the stretch at motions of these ends.
    pub(super) fn end_forces(&self, start: &Six, end: &Six) -> [Six; 2] {
        let rigid = carried(self.length, start);
        let at_end = self.force(&std::array::from_fn(|k| end[k] - rigid[k]));
        [force_moved(self.length, &at_end).map(|part| -part), at_end]
    }

    /// Returns the motion of the section at a distance from the start, up to which `up_to` are the
    /// integrals, at motions of the ends.
    pub(super) fn within(&self, distance: f64, up_to: &Integrals, start: &Six, end: &Six) -> Six {
        let rigid = carried(self.length, start);
        let [fx, fy, fz, mx, my, mz] = self.force(&std::array::from_fn(|k| end[k] - rigid[k]));
        let [uf, um, tf, tm] = up_to.bent(distance, self.length);
        let bent = [
            uf * fx + um * my,
            uf * fy - um * mx,
            up_to.axial * fz,
            tm * mx - tf * fy,
            tf * fx + tm * my,
            up_to.torsion * mz,
        ];
        let carried = carried(distance, start);
        std::array::from_fn(|k| carried[k] + bent[k])
    }
}

/// Forces in a section of a shaft, along and about its axes, N and N m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SectionForces(pub Six);

impl SectionForces {
    /// Returns the magnitude of the bending moment, N m.
    pub fn bending_moment(&self) -> f64 {
        self.0[3].hypot(self.0[4])
    }

    /// Returns the torque, N m.
    pub fn torque(&self) -> f64 {
        self.0[5]
    }

    /// Returns the axial force, N, positive in tension.
    pub fn axial(&self) -> f64 {
        self.0[2]
    }

    /// Returns the magnitude of the transverse force, N.
    pub fn shear(&self) -> f64 {
        self.0[0].hypot(self.0[1])
    }
}
