//! Lumped-parameter model of a planetary gear set, and its natural frequencies.
//!
//! J. Lin and R. G. Parker, *Analytical characterization of the unique properties of planetary gear
//! free vibration*, J. Vib. Acoust. 121(3), 1999. Carrier, ring, sun and planets are rigid bodies
//! with plane motion; meshes are springs along their lines of action, bearings are springs in both
//! directions. There are no gyroscopic terms: the frequencies are those of a carrier at rest. With
//! equal, equally spaced planets every mode is a rotational mode, a translational mode (in pairs of
//! equal frequency), or a planet mode with the central members at rest.
//!
//! The model is a list of springs, each a linear form of the degrees of freedom. The circular
//! frequencies are the singular values of these forms, scaled by the square roots of the stiffness
//! and the inverse square roots of the masses. They are accurate to rounding errors of the largest
//! one. The eigenvalues of a stiffness matrix are squared frequencies, which would halve the number
//! of correct digits of the lowest ones.

use calyx_runtime::observables::ModeKind;
use nalgebra::{DMatrix, SVD};
use std::f64::consts::TAU;

/// Rigid body with plane motion: along x, along y, and about its axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LumpedMember {
    /// Mass, kg.
    pub mass: f64,
    /// Moment of inertia about its axis, kg m2.
    pub inertia: f64,
    /// Base radius; for a carrier the radius of its pins, m.
    pub radius: f64,
    /// Translational stiffness to ground in any direction, N/m. Not used for planets, which the
    /// carrier supports.
    pub support_stiffness: f64,
    /// Torsional stiffness to ground about the axis, N m/rad.
    pub torsional_stiffness: f64,
    /// Flags of the constrained degrees of freedom.
    pub fixed: [bool; 3],
}

impl LumpedMember {
    /// Former name of the field [`LumpedMember::fixed`].
    #[deprecated(since = "0.1.0", note = "use the field `fixed`")]
    pub fn held(&self) -> [bool; 3] {
        self.fixed
    }
}

/// Springs between a central gear and each planet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LumpedMesh {
    /// Stiffness along the line of action, N/m.
    pub stiffness: f64,
    /// Operating pressure angle, rad.
    pub pressure_angle: f64,
}

/// Lumped-parameter model, see the module.
#[derive(Clone, Debug, PartialEq)]
pub struct LumpedPlanetary {
    /// Carrier of the planets.
    pub carrier: LumpedMember,
    /// Ring gear around the planets.
    pub ring: LumpedMember,
    /// Sun gear between the planets.
    pub sun: LumpedMember,
    /// One planet; all are equal. Its x axis points outwards, its y axis in the direction of the
    /// carrier's rotation.
    pub planet: LumpedMember,
    /// Stiffness of the planets' bearings in any direction, N/m.
    pub planet_bearing_stiffness: f64,
    /// Angular positions of the planets on the carrier, rad.
    pub planet_angles: Vec<f64>,
    /// Mesh of sun and planets.
    pub sun_mesh: LumpedMesh,
    /// Mesh of ring and planets.
    pub ring_mesh: LumpedMesh,
}

/// Mode of free vibration.
#[derive(Clone, Debug, PartialEq)]
pub struct Mode {
    /// Natural frequency, Hz.
    pub frequency: f64,
    /// Mode type, from the motion of the central members.
    pub kind: ModeKind,
    /// Motions (m, m, rad) of carrier, ring, sun and the planets in their order, 0 if constrained.
    /// The sum of masses and inertias times squared motions is 1 kg m2. Modes of equal frequency
    /// are orthogonal too.
    pub shape: Vec<[f64; 3]>,
    /// Fraction of the kinetic energy in each member.
    pub shares: Vec<f64>,
}

/// Fraction of a mode's energy below which central members count as at rest.
const AT_REST: f64 = 1e-12;

/// Invalid number of the model, with the name of its field.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{what} of the {member} is {value}, and must be {needed}")]
pub struct LumpedError {
    /// Member: "carrier", "ring", "sun", "planet" or "mesh".
    pub member: &'static str,
    /// Name of the number.
    pub what: &'static str,
    /// Its value in SI.
    pub value: f64,
    /// Condition that it violates.
    pub needed: &'static str,
}

/// Angles of equally spaced planets, rad.
pub fn equally_spaced(planets: usize) -> Vec<f64> {
    (0..planets).map(|planet| TAU * planet as f64 / planets as f64).collect()
}

impl LumpedPlanetary {
    /// Computes all modes in order of ascending frequency. If the set is free to rotate, the first
    /// one has frequency zero.
    ///
    /// # Errors
    /// A mass, inertia or radius is not positive, or a stiffness is negative.
    pub fn modes(&self) -> Result<Vec<Mode>, LumpedError> {
        self.check()?;
        let members = self.members();
        let free: Vec<[usize; 2]> = (0..members.len())
            .flat_map(|member| [0, 1, 2].map(|dof| [member, dof]))
            .filter(|&[member, dof]| !members[member].fixed[dof])
            .collect();
        let root_mass = |[member, dof]: [usize; 2]| {
            let LumpedMember { mass, inertia, .. } = members[member];
            if dof < 2 { mass.sqrt() } else { inertia.sqrt() }
        };
        let springs = self.springs();
        // At least as many rows as columns; zero rows are no springs.
        let mut forms = DMatrix::zeros(springs.len().max(free.len()), free.len());
        for (row, spring) in springs.iter().enumerate() {
            for (column, &dof) in free.iter().enumerate() {
                let form: f64 = spring.form.iter().filter(|(on, _)| *on == dof).map(|(_, by)| by).sum();
                forms[(row, column)] = spring.stiffness.sqrt() * form / root_mass(dof);
            }
        }
        let decomposed = SVD::new(forms, false, true);
        let Some(directions) = decomposed.v_t else { return Ok(Vec::new()) };
        let modes = (0..free.len()).rev().map(|index| {
            let mut shape = vec![[0.0; 3]; members.len()];
            let mut energy = vec![[0.0; 3]; members.len()];
            for (column, &[member, dof]) in free.iter().enumerate() {
                let part: f64 = directions[(index, column)];
                shape[member][dof] = part / root_mass([member, dof]);
                energy[member][dof] = part * part;
            }
            let [moved, turned] = energy[..3]
                .iter()
                .fold([0.0, 0.0], |[moved, turned], &[x, y, turn]| [moved + x + y, turned + turn]);
            let kind = match [moved > AT_REST, turned > AT_REST] {
                [false, true] => ModeKind::Rotational,
                [true, false] => ModeKind::Translational,
                [false, false] => ModeKind::Planet,
                [true, true] => ModeKind::Mixed,
            };
            let shares = energy.iter().map(|parts| parts.iter().sum()).collect();
            Mode { frequency: decomposed.singular_values[index] / TAU, kind, shape, shares }
        });
        Ok(modes.collect())
    }

    fn members(&self) -> Vec<LumpedMember> {
        let planets = self.planet_angles.iter().map(|_| self.planet);
        [self.carrier, self.ring, self.sun].into_iter().chain(planets).collect()
    }

    fn springs(&self) -> Vec<Spring> {
        const CARRIER: usize = 0;
        const RING: usize = 1;
        const SUN: usize = 2;
        let mut springs = Vec::new();
        for (member, of) in [(CARRIER, self.carrier), (RING, self.ring), (SUN, self.sun)] {
            let stiffness = [of.support_stiffness, of.support_stiffness, of.torsional_stiffness];
            for (dof, stiffness) in stiffness.into_iter().enumerate() {
                springs.push(Spring { stiffness, form: vec![([member, dof], 1.0)] });
            }
        }
        for (index, angle) in self.planet_angles.iter().enumerate() {
            let planet = 3 + index;
            let (sine, cosine) = angle.sin_cos();
            let bearing = [
                vec![([CARRIER, 0], cosine), ([CARRIER, 1], sine), ([planet, 0], -1.0)],
                vec![
                    ([CARRIER, 0], -sine),
                    ([CARRIER, 1], cosine),
                    ([CARRIER, 2], self.carrier.radius),
                    ([planet, 1], -1.0),
                ],
            ];
            springs.extend(bearing.map(|form| Spring { stiffness: self.planet_bearing_stiffness, form }));
            // Lines of action are inclined in opposite senses at sun and ring, and load opposite
            // flanks of the planet.
            let meshes = [(SUN, self.sun, self.sun_mesh, -1.0), (RING, self.ring, self.ring_mesh, 1.0)];
            for (member, of, mesh, way) in meshes {
                let (lean_sine, lean_cosine) = mesh.pressure_angle.sin_cos();
                let (sine, cosine) = (angle + way * mesh.pressure_angle).sin_cos();
                let form = vec![
                    ([member, 0], -sine),
                    ([member, 1], cosine),
                    ([member, 2], of.radius),
                    ([planet, 0], way * lean_sine),
                    ([planet, 1], -lean_cosine),
                    ([planet, 2], -way * self.planet.radius),
                ];
                springs.push(Spring { stiffness: mesh.stiffness, form });
            }
        }
        springs
    }

    fn check(&self) -> Result<(), LumpedError> {
        let members =
            [("carrier", self.carrier), ("ring", self.ring), ("sun", self.sun), ("planet", self.planet)];
        for (member, of) in members {
            for (what, value) in [("mass", of.mass), ("inertia", of.inertia), ("radius", of.radius)] {
                if !(value > 0.0 && value.is_finite()) {
                    return Err(LumpedError { member, what, value, needed: "greater than 0" });
                }
            }
            let springs = [
                ("support stiffness", of.support_stiffness),
                ("torsional stiffness", of.torsional_stiffness),
            ];
            for (what, value) in springs {
                positive_or_none(member, what, value)?;
            }
        }
        positive_or_none("planet", "bearing stiffness", self.planet_bearing_stiffness)?;
        positive_or_none("sun", "mesh stiffness", self.sun_mesh.stiffness)?;
        positive_or_none("ring", "mesh stiffness", self.ring_mesh.stiffness)
    }
}

fn positive_or_none(member: &'static str, what: &'static str, value: f64) -> Result<(), LumpedError> {
    if value >= 0.0 && value.is_finite() {
        return Ok(());
    }
    Err(LumpedError { member, what, value, needed: "0 or greater" })
}

/// Spring, and its elongation per degree of freedom (member, DOF).
struct Spring {
    stiffness: f64,
    form: Vec<([usize; 2], f64)>,
}

#[cfg(test)]
mod tests;
