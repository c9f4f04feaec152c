//! Unloaded equilibrium of the springs, and the motions that strain no spring. Contact determines
//! these in the rigid-body limit.

use super::dense::dot;
use super::problem::{ContactError, FreeMotion};
use super::rigid_limit::{RigidLimit, rigid_limit};
use calyx_numerics::interrupt::Interrupt;

/// Equilibrium of springs on the DOFs.
#[derive(Clone, Debug, PartialEq)]
pub struct UnloadedEquilibrium {
    /// Position of the DOFs at which the springs balance the load as far as possible.
    pub motion: Vec<f64>,
    /// Basis of the motions that strain no spring; all DOFs if there are no springs.
    pub free: Vec<Vec<f64>>,
    /// True if the load does no work on any of these motions.
    pub balanced: bool,
}

/// A pivot below this fraction of its DOF's stiffness is rounding: the motion strains no spring.
const RANK: f64 = 1e-11;
/// Work of a load on a free motion that counts as rounding, relative to that of its terms.
const NO_WORK: f64 = 1e-11;

/// Computes the equilibrium from `stiffness` (symmetric positive semidefinite, row-major) and
/// `load` (one entry per DOF).
pub fn unloaded_equilibrium(stiffness: &[f64], load: &[f64]) -> UnloadedEquilibrium {
    let m = load.len();
    // Scale each DOF to unit stiffness.
    let scale: Vec<f64> = (0..m)
        .map(|k| stiffness.get(k * m + k).copied().unwrap_or_default())
        .map(|own| if own > 0.0 { own.sqrt().recip() } else { 1.0 })
        .collect();
    let mut a: Vec<Vec<f64>> =
        (0..m).map(|k| (0..m).map(|l| scale[k] * stiffness[k * m + l] * scale[l]).collect()).collect();
    let mut right: Vec<f64> = load.iter().zip(&scale).map(|(f, s)| f * s).collect();
    // Gauss-Jordan elimination with the largest pivot first: pivot rows are solved for the
    // remaining DOFs.
    let mut left: Vec<usize> = (0..m).collect();
    let mut pivots = Vec::new();
    while let Some(position) =
        (0..left.len()).max_by(|&p, &q| a[left[p]][left[p]].total_cmp(&a[left[q]][left[q]]).then(q.cmp(&p)))
    {
        let k = left[position];
        if a[k][k] <= RANK {
            break;
        }
        left.remove(position);
        pivots.push(k);
        let pivot = a[k][k];
        let row: Vec<f64> = a[k].iter().map(|entry| entry / pivot).collect();
        let value = right[k] / pivot;
        for i in (0..m).filter(|&i| i != k) {
            let factor = a[i][k];
            if factor != 0.0 {
                for (entry, of_pivot) in a[i].iter_mut().zip(&row) {
                    *entry -= factor * of_pivot;
                }
                right[i] -= factor * value;
            }
        }
        a[k] = row;
        right[k] = value;
    }
    let mut motion = vec![0.0; m];
    for &k in &pivots {
        motion[k] = right[k] * scale[k];
    }
    let basis = |&of: &usize| {
        let mut free = vec![0.0; m];
        free[of] = 1.0;
        for &k in &pivots {
            free[k] = -a[k][of] * scale[k] / scale[of];
        }
        free
    };
    let free: Vec<Vec<f64>> = left.iter().map(basis).collect();
    let idle = |free: &Vec<f64>| {
        let parts: f64 = free.iter().zip(load).map(|(x, f)| (x * f).abs()).sum();
        dot(free, load).abs() <= NO_WORK * parts
    };
    let balanced = free.iter().all(idle);
    UnloadedEquilibrium { motion, free, balanced }
}

impl UnloadedEquilibrium {
    /// [`rigid_limit`] of contacts with the springs in equilibrium: `direction` determines the
    /// motions that strain no spring. `None` if there are none and contacts overlap.
    ///
    /// # Errors
    /// Those of [`rigid_limit`].
    pub fn rigid_limit(
        &self,
        gaps: &[f64],
        arms: &[f64],
        direction: &[f64],
        interrupt: &Interrupt,
    ) -> Result<Option<RigidLimit>, ContactError> {
        let m = self.motion.len();
        let row = |contact: usize| arms.get(contact * m..(contact + 1) * m).unwrap_or_default();
        let gaps: Vec<f64> =
            gaps.iter().enumerate().map(|(contact, gap)| gap + dot(row(contact), &self.motion)).collect();
        if self.free.is_empty() {
            let rests = gaps.iter().all(|&gap| gap >= 0.0);
            return Ok(rests.then(|| RigidLimit { motion: self.motion.clone(), touching: Vec::new() }));
        }
        let seen = |contact: usize| self.free.iter().map(move |free| dot(row(contact), free));
        let arms: Vec<f64> = (0..gaps.len()).flat_map(seen).collect();
        let direction: Vec<f64> = self.free.iter().map(|free| dot(direction, free)).collect();
        let limit = rigid_limit(&gaps, &arms, &direction, interrupt).map_err(|error| self.named(error))?;
        let motion = self.motion.iter().zip(self.of(&limit.motion)).map(|(rest, more)| rest + more).collect();
        Ok(Some(RigidLimit { motion, ..limit }))
    }

    /// Returns a combination of the free motions.
    fn of(&self, parts: &[f64]) -> Vec<f64> {
        let m = self.motion.len();
        (0..m).map(|k| self.free.iter().zip(parts).map(|(free, part)| free[k] * part).sum()).collect()
    }

    /// Transforms an error in terms of free motions to the DOFs.
    fn named(&self, error: ContactError) -> ContactError {
        let expanded = |motion: FreeMotion| {
            let dof = self.free.get(motion.dof).and_then(|free| free.iter().rposition(|&x| x == 1.0));
            let all = self.of(&motion.motion);
            FreeMotion { dof: dof.unwrap_or_default(), motion: all, ..motion }
        };
        match error {
            ContactError::Infeasible(motion) => ContactError::Infeasible(expanded(motion)),
            ContactError::Unconstrained(motion) => ContactError::Unconstrained(expanded(motion)),
            other => other,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_springs_every_dof_is_free() {
        let found = unloaded_equilibrium(&[0.0; 4], &[0.0, 3.0]);
        assert_eq!(found.free, [[1.0, 0.0], [0.0, 1.0]]);
        assert_eq!(found.motion, [0.0, 0.0]);
        assert!(!found.balanced);
        assert!(unloaded_equilibrium(&[0.0; 4], &[0.0; 2]).balanced);
    }

    /// A shaft on one eccentric radial spring rotates about the spring, and a force through the
    /// spring does not rotate it.
    #[test]
    fn what_springs_leave_free_strains_none_and_the_rest_balances_the_load() {
        let (k, at) = (3e8, 0.07);
        // u and a rotation; the deflection of the spring is u + at * rotation.
        let stiffness = [k, k * at, k * at, k * at * at];
        let found = unloaded_equilibrium(&stiffness, &[600.0, 600.0 * at]);
        assert!(found.balanced);
        assert_eq!(found.free.len(), 1);
        let free = &found.free[0];
        assert!((free[0] + at * free[1]).abs() < 1e-15 * free[0].abs().max(1.0), "{free:?}");
        assert!((found.motion[0] + at * found.motion[1] - 600.0 / k).abs() < 1e-20);
        assert!(!unloaded_equilibrium(&stiffness, &[600.0, 0.0]).balanced);
        let constrained = [k, 0.0, 0.0, 5.0];
        let found = unloaded_equilibrium(&constrained, &[600.0, 1.0]);
        assert!(found.balanced && found.free.is_empty());
        assert!((found.motion[0] - 600.0 / k).abs() < 1e-20 && (found.motion[1] - 0.2).abs() < 1e-15);
    }

    /// A body on a spring along y is driven along x against an inclined wall: the wall stops it at
    /// the equilibrium of the spring.
    #[test]
    fn springs_stay_unloaded_while_contact_stops_the_drive() {
        let found = unloaded_equilibrium(&[0.0, 0.0, 0.0, 2e6], &[0.0, 20.0]);
        let limit = found.rigid_limit(&[1e-3], &[-1.0, -0.5], &[1.0, 0.0], &Interrupt::never());
        let limit = limit.unwrap().unwrap();
        assert!((limit.motion[0] - (1e-3 - 0.5e-5)).abs() < 1e-15, "{limit:?}");
        assert!((limit.motion[1] - 1e-5).abs() < 1e-17);
        let error = found.rigid_limit(&[], &[], &[1.0, 0.0], &Interrupt::never()).unwrap_err();
        let ContactError::Infeasible(motion) = error else { panic!("{error}") };
        assert_eq!((motion.dof, motion.motion), (0, vec![1.0, 0.0]));
    }
}
