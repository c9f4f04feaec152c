//! Elastic bodies whose seats are raceways in the equilibrium of nonlinear bearings.
//!
//! With the motions `u` of the DOFs, the coefficients of all raceways of a body are `r = A u + s`,
//! and `s` has the elastic energy `s' C^-1 s / 2`. All bearings of the body together determine `s`:
//! their linearized elements have the energy `r' P r / 2 + r' X u - r' l`, in which `P` and `X` are
//! the stiffness of elements between the raceway and itself, and the deflections of the bearings.
//! With `Y = P A + X` and `N = (C^-1 + P)^-1`, the elimination of `s` adds
//!
//! ```text
//! A' P A + A' X + X' A - Y' N Y    and    A' l - Y' N l
//! ```
//!
//! to stiffness and load of the DOFs, and `r = (A - N Y) u + N l`.

use super::{Member, NonlinearBearings};
use crate::system::System;
use calyx_model::bearing::Tangent;
use calyx_numerics::error::EngineError;
use nalgebra::{DMatrix, DVector};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Elastic body with bearings in seats that are raceways.
pub(super) struct SeatedBody {
    /// `A`: coefficients by DOFs.
    motions: DMatrix<f64>,
    /// `L` with `C = L L'`.
    factor: Arc<DMatrix<f64>>,
    /// Bearings by their index among the members, with the first coefficient of the seat.
    members: Vec<(usize, usize)>,
    /// Width to which forces of a plane model refer, m.
    width: f64,
}

/// Elastic body with linearized elements in its seats.
pub(in crate::step) struct SeatResponse {
    /// Stiffness and load of the DOFs in addition to those of the bearings on rigid raceways, per
    /// width of a plane model.
    stiffness: DMatrix<f64>,
    load: DVector<f64>,
    /// Coefficients of the raceways by DOFs, and without motion.
    by_motions: DMatrix<f64>,
    at_rest: DVector<f64>,
}

impl SeatResponse {
    /// Adds the response to stiffness and load of the DOFs.
    pub fn add_to(&self, stiffness: &mut [f64], load: &mut [f64]) {
        // Symmetric, so that the order does not matter.
        stiffness.iter_mut().zip(self.stiffness.iter()).for_each(|(sum, entry)| *sum += entry);
        load.iter_mut().zip(self.load.iter()).for_each(|(sum, entry)| *sum += entry);
    }
}

/// Finds the elastic bodies in whose seats members run at a time (s).
pub(super) fn seated_bodies(
    system: &System<'_>,
    members: &[Member],
    time: f64,
) -> Result<Vec<SeatedBody>, EngineError> {
    let mut by_connection: BTreeMap<usize, Vec<(usize, usize)>> = BTreeMap::new();
    for (member, own) in members.iter().enumerate() {
        if let Some((connection, first)) = own.seat {
            by_connection.entry(connection).or_default().push((member, first));
        }
    }
    let body = |(index, of_members): (usize, Vec<(usize, usize)>)| {
        let connection = &system.elastic_connections[index];
        let factor = system.raceway_factor(index)?;
        let width = of_members.first().map_or(1.0, |(member, _)| members[*member].width);
        let motions = connection.raceway_motions(&system.scene.bodies, &system.dofs, time);
        Some(motions.map(|motions| SeatedBody { motions, factor, members: of_members, width }))
    };
    by_connection.into_iter().filter_map(body).collect()
}

impl SeatedBody {
    fn response(&self, members: &[Member], tangents: &[Tangent]) -> SeatResponse {
        let (terms, dofs) = self.motions.shape();
        let mut stiffness = DMatrix::zeros(terms, terms);
        let mut coupling = DMatrix::zeros(terms, dofs);
        let mut load = DVector::zeros(terms);
        for &(member, first) in &self.members {
            let (own, tangent) = (&members[member], &tangents[member]);
            let (Some(raceway), Some(tangent)) = (&own.raceway, &tangent.raceway) else { continue };
            let by_terms = &raceway.by_terms;
            let count = by_terms.ncols();
            let deflection = DMatrix::from_fn(5, dofs, |k, dof| own.arms[dof][k]);
            let mut block = stiffness.view_mut((first, first), (count, count));
            block += by_terms.transpose() * tangent.stiffness() * by_terms;
            let mut rows = coupling.rows_mut(first, count);
            rows -= by_terms.transpose() * tangent.coupling() * deflection;
            let mut rows = load.rows_mut(first, count);
            rows += by_terms.transpose() * tangent.load();
        }
        let (motions, factor) = (&self.motions, self.factor.as_ref());
        let whole = &stiffness * motions + &coupling;
        let core =
            DMatrix::identity(factor.ncols(), factor.ncols()) + factor.transpose() * &stiffness * factor;
        let core = core.lu();
        let yielding = |right: &DMatrix<f64>| {
            let solved = core.solve(&(factor.transpose() * right));
            solved.map_or_else(|| DMatrix::zeros(right.nrows(), right.ncols()), |solved| factor * solved)
        };
        let by_motions = yielding(&whole);
        let at_rest = yielding(&DMatrix::from_columns(&[load.clone()]));
        let at_rest = DVector::from_column_slice(at_rest.as_slice());
        let cross = motions.transpose() * &coupling;
        let own = motions.transpose() * &stiffness * motions + &cross + cross.transpose()
            - whole.transpose() * &by_motions;
        let on_dofs = motions.transpose() * &load - whole.transpose() * &at_rest;
        SeatResponse {
            stiffness: 0.5 * (&own + own.transpose()) / self.width,
            load: on_dofs / self.width,
            by_motions: motions - by_motions,
            at_rest,
        }
    }
}

impl NonlinearBearings<'_> {
    /// Returns the response of elastic bodies with linearized elements in their seats.
    pub(super) fn seat_responses(&self, tangents: &[Tangent]) -> Vec<SeatResponse> {
        self.seated.iter().map(|body| body.response(&self.members, tangents)).collect()
    }

    /// Adds the displacements of raceways in seats at motions to those of all raceways by forces of
    /// cells, by bearing.
    pub(super) fn move_seats(&self, moved: &mut [Vec<f64>], responses: &[SeatResponse], motion: &[f64]) {
        for (body, response) in self.seated.iter().zip(responses) {
            let motion = DVector::from_row_slice(&motion[..response.by_motions.ncols()]);
            let coefficients = &response.by_motions * motion + &response.at_rest;
            for &(member, first) in &body.members {
                let Some(raceway) = &self.members[member].raceway else { continue };
                let own = coefficients.rows(first, raceway.by_terms.ncols());
                let by_element = &raceway.by_terms * own;
                moved[member].iter_mut().zip(by_element.iter()).for_each(|(sum, part)| *sum += part);
            }
        }
    }
}
