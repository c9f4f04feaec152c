//! Stiffness and load of contact problems with the tangents of nonlinear bearings.

use super::{NonlinearBearings, NonlinearIteration, SeatResponse, dot};
use calyx_contact::problem::ContactProblem;
use calyx_model::bearing::Tangent;

/// Subtracts the forces of a stiffness at motions, by DOF, from a load.
fn strain(load: &mut [f64], stiffness: &[f64], motion: &[f64]) {
    for (load, row) in load.iter_mut().zip(stiffness.chunks_exact(stiffness.len().isqrt().max(1))) {
        *load -= row.iter().zip(motion).map(|(entry, moved)| entry * moved).sum::<f64>();
    }
}

impl NonlinearBearings<'_> {
    /// Replaces stiffness and load of a contact problem, whose motions are relative to `start`.
    pub(super) fn put(
        &self,
        problem: &mut ContactProblem,
        (tangents, responses): (&[Tangent], &[SeatResponse]),
        start: &[f64],
    ) {
        let (mut stiffness, mut load) = (self.base.stiffness.clone(), self.base.load.clone());
        self.add(&mut stiffness, &mut load, tangents);
        responses.iter().for_each(|response| response.add_to(&mut stiffness, &mut load));
        strain(&mut load, &stiffness, start);
        load.iter_mut().zip(&self.load).for_each(|(load, own)| *load += own);
        (problem.stiffness, problem.load) = (stiffness, load);
    }

    /// Replaces stiffness and load of the contact problem of a time step, which are those `besides`
    /// the bearings and refer to its start, as the motions do.
    pub(super) fn put_in_step(
        &self,
        problem: &mut ContactProblem,
        [stiffness, load]: &[Vec<f64>; 2],
        tangents: &[Tangent],
        start: &[f64],
    ) {
        let (mut own_stiffness, mut own_load) = (vec![0.0; stiffness.len()], vec![0.0; load.len()]);
        self.add(&mut own_stiffness, &mut own_load, tangents);
        strain(&mut own_load, &own_stiffness, start);
        let sum = |one: &[f64], other: &[f64]| one.iter().zip(other).map(|(a, b)| a + b).collect();
        (problem.stiffness, problem.load) = (sum(stiffness, &own_stiffness), sum(load, &own_load));
    }

    /// Adds the tangents at an iteration to the contact problem of a time step.
    pub(in crate::step) fn put_tangents(
        &self,
        problem: &mut ContactProblem,
        iteration: &NonlinearIteration,
        start: &[f64],
    ) {
        let step = [problem.stiffness.clone(), problem.load.clone()];
        self.put_in_step(problem, &step, &self.tangents(iteration), start);
    }

    /// Adds the tangents to the stiffness and load of the DOFs.
    fn add(&self, stiffness: &mut [f64], load: &mut [f64], tangents: &[Tangent]) {
        let m = load.len();
        for (own, tangent) in self.members.iter().zip(tangents) {
            for (k, column) in own.arms.iter().enumerate() {
                let pushed: [f64; 6] = tangent.stiffness.map(|row| dot(&row, column));
                load[k] += dot(column, &tangent.load) / own.width;
                // Compute each entry and its mirror image once, so that the matrix is exactly
                // symmetric.
                for (l, other) in own.arms.iter().enumerate().skip(k) {
                    let entry = dot(&pushed, other) / own.width;
                    stiffness[k * m + l] += entry;
                    if l > k {
                        stiffness[l * m + k] += entry;
                    }
                }
            }
        }
    }
}
