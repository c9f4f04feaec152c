//! Observables of a gear mesh: transmission error and mesh stiffness.
//!
//! See `docs/theory/equilibrium.md`.

use super::{Equilibrium, Needs, Observable, Quantity};
use calyx_contact::load_boundary::added_compliances;
use calyx_model::dof::Dof;
use calyx_model::ids::PairId;
use calyx_model::observed::Observed;
use calyx_numerics::dense::Interruptible;
use calyx_solve::step::Participating;
use faer::Mat;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::PI;
use std::ops::Range;

const THETA_Z: usize = 5;

/// Transmission error: lag of the second gear behind the drive flanks of the first gear, `sense
/// (theta_1 N1/N2 + sign theta_2)`, rad. Angles are measured from rigid unmodified contact and
/// relative to the line of centres, which rotates if the axes move. On general axes they are
/// rotations of the bodies about their own axes relative to the carrier of the mesh, measured from
/// rigid contact at time 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TransmissionError(pub PairId);

impl Observable for TransmissionError {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("transmission_error", "rad")
    }

    fn needs(&self) -> Needs {
        Needs::Motions
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let Some((mesh, [first, second])) = at.mesh(at.front(self.0)) else {
            return Observed::number(f64::NAN);
        };
        let ratio = f64::from(mesh.teeth[0]) / f64::from(mesh.teeth[1]);
        let turned = |side| at.system.turned_on_carrier(at.front(self.0).0, side, at.time());
        let kinematic = turned(0) * ratio + mesh.sign * turned(1);
        // Angles are determined modulo whole revolutions, and a mesh repeats with every tooth of
        // the second gear.
        let pitch = 2.0 * PI / f64::from(mesh.teeth[1]);
        let kinematic = kinematic - (kinematic / pitch).round() * pitch;
        let deflection = at.deviation(first, THETA_Z) * ratio + mesh.sign * at.deviation(second, THETA_Z);
        Observed::number(mesh.drive_sense * (kinematic + deflection - mesh.sign * mesh.phase_offset))
    }

    fn pair_of(&self) -> Option<PairId> {
        Some(self.0)
    }
}

/// Transmission error at the same position as the load vanishes: that of rigid teeth with their
/// modifications and deviations, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UnloadedTransmissionError(pub PairId);

impl Observable for UnloadedTransmissionError {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("unloaded_transmission_error", "rad")
    }

    fn needs(&self) -> Needs {
        Needs::Motions
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let Ok(step) = at.system.touch(at.time()) else { return Observed::number(f64::NAN) };
        TransmissionError(self.0).value(&Equilibrium { step: &step, ..*at })
    }

    fn pair_of(&self) -> Option<PairId> {
        Some(self.0)
    }
}

/// Secant stiffness: the force along the line of action divided by the displacement of the mesh
/// along it from unloaded contact, N/m. Zero without load. On general axes the line of action is
/// the common normal at the first contact ([`FirstContact`](calyx_model::pairs::FirstContact)).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SecantStiffness(pub PairId);

impl Observable for SecantStiffness {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("secant_mesh_stiffness", "N/m")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let Some((mesh, _)) = at.mesh(self.0) else { return Observed::number(f64::NAN) };
        let moment: f64 = at.mesh_contacts(self.0).map(|contact| contact.torque(0)).sum();
        let force = moment.abs() / mesh.base_radii[0];
        let moved =
            TransmissionError(self.0).value(at).value - UnloadedTransmissionError(self.0).value(at).value;
        // Contact on coast flanks reverses the sign.
        Observed::number(if force > 0.0 { force / (moved * mesh.base_radii[1]).abs() } else { 0.0 })
    }

    fn pair_of(&self) -> Option<PairId> {
        Some(self.0)
    }
}

/// Mesh stiffness (tangent stiffness): inverse of the displacement along the line of action per
/// added force, N/m, with the present boundary of the load ([`calyx_contact::load_boundary`]). Zero
/// without load. The line of action is that of
/// [`SecantStiffness`].
///
/// For two gears without another mesh, the compliance of bearings is included. Otherwise, as for a
/// planet, the force would pass on to other meshes. Then it is the stiffness of these teeth alone,
/// for a small rotation of one gear with all other forces unchanged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshStiffness(pub PairId);

impl Observable for MeshStiffness {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("mesh_stiffness", "N/m")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let Some((mesh, [first, second])) = at.mesh(self.0) else { return Observed::number(f64::NAN) };
        let (step, dofs) = (at.step, &at.system.dofs);
        let m = dofs.len();
        let alone = at.is_alone(self.0);
        let own = (!alone).then(|| at.cells_of(self.0));
        let active = step
            .participating(|cell| own.as_ref().is_none_or(|own| own.iter().any(|own| own.contains(&cell))));
        if active.cells.is_empty() || m == 0 {
            return Observed::number(0.0);
        }
        let Some(teeth) = contact_stiffness(at, &active) else { return Observed::number(f64::NAN) };
        // Work of a unit force along the line of action on each DOF.
        let along = DVector::from_fn(m, |k, _| match dofs[k] {
            Dof { body, component: THETA_Z } if body == first.0 => mesh.base_radii[0],
            Dof { body, component: THETA_Z } if body == second.0 => mesh.sign * mesh.base_radii[1],
            _ => 0.0,
        });
        if !alone {
            // Rotation of one gear alone with the same displacement along the line of action.
            let turned = (0..m).find(|&k| along[k] != 0.0);
            return Observed::number(
                turned.map_or(0.0, |k| at.system.width(first.0) * teeth[(k, k)] / along[k].powi(2)),
            );
        }
        let stiffness = teeth + DMatrix::from_row_slice(m, m, &step.problem.stiffness);
        let compliance = stiffness.lu().solve(&along).map_or(f64::NAN, |motion| along.dot(&motion));
        Observed::number(at.system.width(first.0) / compliance)
    }

    fn pair_of(&self) -> Option<PairId> {
        Some(self.0)
    }
}

/// Returns the stiffness of the participating cells about the DOFs, `C' A^-1 C`; `None` if their
/// compliance is not positive definite, or if the interrupt ends the factorization, whose caller
/// reports it.
fn contact_stiffness(
    at: &Equilibrium<'_>,
    Participating { cells, participations }: &Participating,
) -> Option<DMatrix<f64>> {
    let (problem, m) = (&at.step.problem, at.system.dofs.len());
    let arms = Mat::from_fn(cells.len(), m, |i, k| problem.arms[cells[i] * m + k]);
    let checkpoint = || at.system.interrupt.check();
    let dense = Interruptible(&checkpoint);
    let mut compliance = at.step.compliance_of(cells);
    for (cell, added) in added_compliances(&compliance, participations, dense).ok()??.into_iter().enumerate()
    {
        compliance[(cell, cell)] += added;
    }
    let factor = dense.cholesky(compliance).ok()??;
    let solved = dense.solve_lower(factor.as_ref(), arms).ok()?;
    let stiffness = dense.product(solved.transpose(), solved.as_ref()).ok()?;
    Some(DMatrix::from_fn(m, m, |i, k| stiffness[(i, k)]))
}

impl Equilibrium<'_> {
    /// Returns whether the two bodies of a mesh have no other mesh.
    fn is_alone(&self, pair: PairId) -> bool {
        let front = self.front(pair);
        let Some((_, bodies)) = self.mesh(front) else { return true };
        let others =
            (0..self.system.scene.pairs.len()).map(PairId).filter(|&other| self.front(other) != front);
        let shares =
            |other| self.mesh(other).is_some_and(|(_, own)| own.iter().any(|body| bodies.contains(body)));
        !others.into_iter().any(shares)
    }

    /// Returns the ranges of the cells of a mesh, on both flanks of its teeth.
    fn cells_of(&self, pair: PairId) -> Vec<Range<usize>> {
        let front = self.front(pair);
        let mut cells = Vec::new();
        let mut first = 0;
        for patch in &self.step.patches {
            let own = first..first + patch.forces.len();
            first = own.end;
            if self.front(PairId(patch.pair)) == front {
                cells.push(own);
            }
        }
        cells
    }
}
