//! Elastic bodies whose seats are raceways in the equilibrium of nonlinear bearings.
//!
//! With the motions `u` of the DOFs, the coefficients of all raceways of a body are `r = A u + s`,
//! and `s` has the elastic energy `s' C^-1 s / 2`. All bearings of the body together determine `s`,
//! and a bearing between two elastic bodies that of both. Between the raceways of gears and of
//! these bodies, the elements of a bearing have the displacement `w = H p + E r` by the forces `p`
//! of teeth and the terms of the series. Their linearized loads are `f = M' (c + B q) - Q w`, with
//! `M` and `Q = K M` of [`calyx_model::bearing::ElasticRaceways`]. Equilibrium of the bodies, `s =
//! C E' f`, gives with `P = E' Q E`, `X u = -E' M' B q`, `l = E' M' c`, `Y = P A + X` and `N =
//! (C^-1 + P)^-1`
//!
//! ```text
//! s = N (l - Y u - G' p),    G = H' Q E .
//! ```
//!
//! So the elimination of `s` adds
//!
//! ```text
//! A' P A + A' X + X' A - Y' N Y    and    A' l - Y' N l
//! ```
//!
//! to stiffness and load of the DOFs, and `r = (A - N Y) u + N l - N G' p`. The gaps of cells on a
//! gear grow by `-G r`, which changes their compliance by `G N G'`.

use super::{Member, NonlinearBearings};
use crate::system::System;
use calyx_contact::problem::ContactProblem;
use calyx_model::bearing::{PlacedRaceway, SeatTerms, Tangent};
use calyx_numerics::error::EngineError;
use nalgebra::{DMatrix, DVector, Dyn, LU};
use std::collections::BTreeMap;

#[cfg(test)]
mod tests;

/// Elastic bodies with bearings in seats that are raceways: one, or several that are joined by
/// bearings.
pub(super) struct SeatedBodies {
    /// `A`: coefficients of all raceways by DOFs.
    motions: DMatrix<f64>,
    /// `L` with `C = L L'`.
    factor: DMatrix<f64>,
    /// First coefficient of each elastic connection.
    first: BTreeMap<usize, usize>,
    /// Bearings by their index among the members.
    members: Vec<usize>,
    /// Width to which forces of a plane model refer, m.
    width: f64,
}

/// Elastic bodies with linearized elements in their seats.
pub(in crate::step) struct SeatResponse {
    /// Stiffness and load of the DOFs in addition to those of the bearings on rigid raceways, per
    /// width of a plane model.
    stiffness: DMatrix<f64>,
    load: DVector<f64>,
    /// Coefficients of the raceways by DOFs, and without motion.
    by_motions: DMatrix<f64>,
    at_rest: DVector<f64>,
    /// `L` and `I + L' P L`, of which `N` is made.
    factor: DMatrix<f64>,
    core: LU<f64, Dyn, Dyn>,
}

impl SeatResponse {
    /// Adds the response to stiffness and load of the DOFs.
    pub fn add_to(&self, stiffness: &mut [f64], load: &mut [f64]) {
        // Symmetric, so that the order does not matter.
        stiffness.iter_mut().zip(self.stiffness.iter()).for_each(|(sum, entry)| *sum += entry);
        load.iter_mut().zip(self.load.iter()).for_each(|(sum, entry)| *sum += entry);
    }

    /// Returns the coefficients of the raceways by forces on them: `N` times the forces.
    fn yielding(&self, forces: &DMatrix<f64>) -> DMatrix<f64> {
        yielding(&self.factor, &self.core, forces)
    }
}

/// Returns `N` times forces on the coefficients, with `L` and `I + L' P L`.
fn yielding(factor: &DMatrix<f64>, core: &LU<f64, Dyn, Dyn>, forces: &DMatrix<f64>) -> DMatrix<f64> {
    let solved = core.solve(&(factor.transpose() * forces));
    solved.map_or_else(|| DMatrix::zeros(forces.nrows(), forces.ncols()), |solved| factor * solved)
}

/// Finds the elastic bodies in whose seats members run at a time (s).
pub(super) fn seated_bodies(
    system: &System<'_>,
    members: &[Member],
    time: f64,
) -> Result<Vec<SeatedBodies>, EngineError> {
    // Sets of connections that bearings join, with these bearings.
    let mut sets: Vec<(Vec<usize>, Vec<usize>)> = Vec::new();
    for (member, own) in members.iter().enumerate() {
        let mut joined: Vec<usize> = own.seats().map(|(_, terms)| terms.connection).collect();
        if joined.is_empty() {
            continue;
        }
        let mut bearings = vec![member];
        sets.retain_mut(|(connections, others)| {
            let is_joined = connections.iter().any(|connection| joined.contains(connection));
            if is_joined {
                joined.append(connections);
                bearings.append(others);
            }
            !is_joined
        });
        joined.sort_unstable();
        joined.dedup();
        bearings.sort_unstable();
        sets.push((joined, bearings));
    }
    sets.into_iter()
        .map(|(connections, own)| SeatedBodies::new(system, (members, own), &connections, time))
        .collect()
}

impl SeatedBodies {
    fn new(
        system: &System<'_>,
        (all, members): (&[Member], Vec<usize>),
        connections: &[usize],
        time: f64,
    ) -> Result<Self, EngineError> {
        let of = |&index: &usize| system.elastic_connections[index].raceways.terms();
        let terms: usize = connections.iter().map(of).sum();
        let mut motions = DMatrix::zeros(terms, system.dofs.len());
        let mut factor = DMatrix::zeros(terms, terms);
        let (mut first, mut next) = (BTreeMap::new(), 0);
        for &index in connections {
            let connection = &system.elastic_connections[index];
            let own = connection.raceway_motions(&system.scene.bodies, &system.dofs, time)?;
            motions.rows_mut(next, own.nrows()).copy_from(&own);
            if let Some(own) = system.raceways.factors.get(&index) {
                factor.view_mut((next, next), own.shape()).copy_from(own);
            }
            first.insert(index, next);
            next += own.nrows();
        }
        let width = members.first().map_or(1.0, |&member| all[member].width);
        Ok(Self { motions, factor, first, members, width })
    }

    /// Returns the raceways of a member in the seats, with the first of their coefficients.
    fn seats<'a>(&'a self, member: &'a Member) -> impl Iterator<Item = (usize, &'a PlacedRaceway)> + Clone {
        member.seats().filter_map(|(raceway, SeatTerms { connection, first })| {
            Some((self.first.get(&connection)? + first, raceway))
        })
    }

    fn response(&self, members: &[Member], tangents: &[Tangent]) -> SeatResponse {
        let (terms, dofs) = self.motions.shape();
        let mut stiffness = DMatrix::zeros(terms, terms);
        let mut coupling = DMatrix::zeros(terms, dofs);
        let mut load = DVector::zeros(terms);
        for &member in &self.members {
            let (own, Some(tangent)) = (&members[member], &tangents[member].raceway) else { continue };
            let deflection = DMatrix::from_fn(5, dofs, |k, dof| own.arms[dof][k]);
            for (first, PlacedRaceway { by_terms, .. }) in self.seats(own) {
                let pressed = by_terms.transpose() * tangent.stiffness();
                for (other, raceway) in self.seats(own) {
                    let shape = (by_terms.ncols(), raceway.by_terms.ncols());
                    let mut block = stiffness.view_mut((first, other), shape);
                    block += &pressed * &raceway.by_terms;
                }
                let mut rows = coupling.rows_mut(first, by_terms.ncols());
                rows -= by_terms.transpose() * tangent.coupling() * &deflection;
                let mut rows = load.rows_mut(first, by_terms.ncols());
                rows += by_terms.transpose() * tangent.load();
            }
        }
        let (motions, factor) = (&self.motions, &self.factor);
        let whole = &stiffness * motions + &coupling;
        let core = DMatrix::identity(terms, terms) + factor.transpose() * &stiffness * factor;
        let core = core.lu();
        let by_motions = yielding(factor, &core, &whole);
        let at_rest = yielding(factor, &core, &DMatrix::from_columns(&[load.clone()]));
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
            factor: factor.clone(),
            core,
        }
    }

    /// Returns `G'`, the forces on the coefficients by unit forces on cells, from the growths of
    /// their gaps by member; `None` without a bearing between a seat and a gear.
    fn on_terms(
        &self,
        members: &[Member],
        tangents: &[Tangent],
        growths: &[Option<DMatrix<f64>>],
    ) -> Option<DMatrix<f64>> {
        let mut on_terms: Option<DMatrix<f64>> = None;
        for &member in &self.members {
            let (Some(growth), Some(tangent)) = (growths.get(member)?, &tangents[member].raceway) else {
                continue;
            };
            let on_raceways = tangent.stiffness() * growth.transpose();
            let whole =
                on_terms.get_or_insert_with(|| DMatrix::zeros(self.motions.nrows(), on_raceways.ncols()));
            for (first, raceway) in self.seats(&members[member]) {
                let mut rows = whole.rows_mut(first, raceway.by_terms.ncols());
                rows += raceway.by_terms.transpose() * &on_raceways;
            }
        }
        on_terms
    }

    /// Adds the bodies to the cells of a contact problem on gears with elastic raceways, of which
    /// `growths` are those of [`SeatedBodies::on_terms`]. Motions are relative to `start`.
    pub fn put(
        &self,
        problem: &mut ContactProblem,
        (members, tangents, response): (&[Member], &[Tangent], &SeatResponse),
        growths: &[Option<DMatrix<f64>>],
        start: &[f64],
    ) {
        let Some(on_terms) = self.on_terms(members, tangents, growths) else { return };
        let (all, dofs) = (problem.cells(), problem.dofs());
        let cells = on_terms.ncols().min(all);
        let gaps = on_terms.tr_mul(&response.at_rest) / self.width;
        let arms = on_terms.tr_mul(&response.by_motions) / self.width;
        let between = on_terms.tr_mul(&response.yielding(&on_terms)) / self.width;
        for row in 0..cells {
            problem.gaps[row] -= gaps[row];
            for dof in 0..dofs.min(arms.ncols()) {
                problem.arms[row * dofs + dof] -= arms[(row, dof)];
                problem.gaps[row] -= arms[(row, dof)] * start.get(dof).copied().unwrap_or(0.0);
            }
            for column in 0..=row {
                let part = 0.5 * (between[(row, column)] + between[(column, row)]);
                let entry = problem.compliance[row * all + column] + part;
                problem.compliance[row * all + column] = entry;
                problem.compliance[column * all + row] = entry;
            }
        }
    }

    /// Adds the displacements of the raceways on the seats at motions to those of raceways in gears
    /// by forces of cells, by member.
    pub fn displace(
        &self,
        moved: &mut [Vec<f64>],
        (members, tangents, response): (&[Member], &[Tangent], &SeatResponse),
        motion: &[f64],
    ) {
        // The displacements H' p take the place of H', and G' p that of G'.
        let on_gears = members.iter().zip(moved.iter()).map(|(own, moved)| {
            let bore = own.raceways.as_ref()?.bore();
            bore.map(|_| DMatrix::from_row_slice(1, moved.len(), moved))
        });
        let on_gears: Vec<Option<DMatrix<f64>>> = on_gears.collect();
        let motion = DVector::from_row_slice(&motion[..response.by_motions.ncols()]);
        let mut coefficients = &response.by_motions * motion + &response.at_rest;
        if let Some(on_terms) = self.on_terms(members, tangents, &on_gears) {
            coefficients -= response.yielding(&on_terms).column(0);
        }
        for &member in &self.members {
            for (first, raceway) in self.seats(&members[member]) {
                let own = coefficients.rows(first, raceway.by_terms.ncols());
                let by_element = &raceway.by_terms * own;
                moved[member].iter_mut().zip(by_element.iter()).for_each(|(sum, part)| *sum += part);
            }
        }
    }
}

impl NonlinearBearings<'_> {
    /// Returns the response of elastic bodies with linearized elements in their seats.
    pub(super) fn seat_responses(&self, tangents: &[Tangent]) -> Vec<SeatResponse> {
        self.seated.iter().map(|bodies| bodies.response(&self.members, tangents)).collect()
    }

    /// Adds elastic bodies with elements on their seats to the cells of a contact problem, see
    /// [`SeatedBodies::put`].
    pub(super) fn put_seats(
        &self,
        problem: &mut ContactProblem,
        (tangents, responses): (&[Tangent], &[SeatResponse]),
        growths: &[Option<DMatrix<f64>>],
        start: &[f64],
    ) {
        for (bodies, response) in self.seated.iter().zip(responses) {
            bodies.put(problem, (&self.members, tangents, response), growths, start);
        }
    }

    /// Adds the displacements of raceways on seats at motions to those of raceways in gears by
    /// forces of cells, by bearing.
    pub(super) fn move_seats(
        &self,
        moved: &mut [Vec<f64>],
        (tangents, responses): (&[Tangent], &[SeatResponse]),
        motion: &[f64],
    ) {
        for (bodies, response) in self.seated.iter().zip(responses) {
            bodies.displace(moved, (&self.members, tangents, response), motion);
        }
    }
}
