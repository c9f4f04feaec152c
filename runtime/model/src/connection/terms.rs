//! Contribution of elastic connections to the equations of the DOFs: stiffness and mass.

use super::connection_state::Six;
use super::{ConnectionState, ElasticConnection};
use crate::body::Body;
use crate::dof::Dof;
use crate::ids::BodyId;
use calyx_numerics::error::EngineError;
use nalgebra::DMatrix;

/// Adds the stiffness of the planned connections of a scene at a time (s) to a matrix of these
/// DOFs, row-major. `width` (m) is that of a body in a plane model, and 1 in three dimensions.
///
/// # Errors
/// Those of [`ConnectionState::at`].
pub fn add_connection_stiffness(
    target: &mut [f64],
    (bodies, connections): (&[Body], &[ElasticConnection]),
    planned: &[usize],
    dofs: &[Dof],
    width: impl Fn(usize) -> f64,
    time: f64,
) -> Result<(), EngineError> {
    for connection in planned.iter().filter_map(|&connection| connections.get(connection)) {
        let state = ConnectionState::at(bodies, connection, time)?;
        add(target, dofs, &state, &connection.stiffness, width(connection.first_body()));
    }
    Ok(())
}

/// Adds the mass of the planned connections to a mass matrix, like [`add_connection_stiffness`].
///
/// # Errors
/// Those of [`ConnectionState::at`].
pub fn add_connection_mass(
    target: &mut [f64],
    (bodies, connections): (&[Body], &[ElasticConnection]),
    planned: &[usize],
    dofs: &[Dof],
    width: impl Fn(usize) -> f64,
    time: f64,
) -> Result<(), EngineError> {
    for connection in planned.iter().filter_map(|&connection| connections.get(connection)) {
        if !connection.mass.is_empty() {
            let state = ConnectionState::at(bodies, connection, time)?;
            add(target, dofs, &state, &connection.mass, width(connection.first_body()));
        }
    }
    Ok(())
}

/// Adds the mass between the DOFs (rows) and the component modes of the planned connections
/// (columns, connection by connection) to a row-major matrix.
///
/// # Errors
/// Those of [`ConnectionState::at`].
pub fn add_mode_coupling(
    target: &mut [f64],
    (bodies, connections): (&[Body], &[ElasticConnection]),
    planned: &[usize],
    dofs: &[Dof],
    time: f64,
) -> Result<(), EngineError> {
    let planned = || planned.iter().filter_map(|&connection| connections.get(connection));
    let columns: usize = planned().map(|connection| connection.modes.count()).sum();
    let mut first = 0;
    for connection in planned().filter(|connection| connection.modes.count() > 0) {
        let state = ConnectionState::at(bodies, connection, time)?;
        let own = connection.modes.count();
        for (k, dof) in dofs.iter().enumerate() {
            for (attachment, unit) in state.moved(dof) {
                for (component, part) in unit.into_iter().enumerate().filter(|(_, part)| *part != 0.0) {
                    let row = (6 * attachment + component) * own;
                    for mode in 0..own {
                        target[k * columns + first + mode] += part * connection.modes.coupling[row + mode];
                    }
                }
            }
        }
        first += own;
    }
    Ok(())
}

/// Adds a matrix of the attachments to one of the DOFs. Each entry and its mirror image are
/// computed once, so that the sum is exactly symmetric.
fn add(target: &mut [f64], dofs: &[Dof], state: &ConnectionState, matrix: &[f64], width: f64) {
    let m = dofs.len();
    let moved: Vec<Vec<(usize, Six)>> = dofs.iter().map(|dof| state.moved(dof)).collect();
    let size = (matrix.len() as f64).sqrt().round() as usize;
    let block = |row: usize, column: usize| matrix[row * size + column];
    for (k, one) in moved.iter().enumerate().filter(|(_, one)| !one.is_empty()) {
        for (l, other) in moved.iter().enumerate().skip(k).filter(|(_, other)| !other.is_empty()) {
            let mut entry = 0.0;
            for (a, x) in one {
                for (b, y) in other {
                    for (i, x) in x.iter().enumerate().filter(|(_, x)| **x != 0.0) {
                        for (j, y) in y.iter().enumerate() {
                            let (row, column) = (6 * a + i, 6 * b + j);
                            entry += x * (0.5 * (block(row, column) + block(column, row))) * y;
                        }
                    }
                }
            }
            target[k * m + l] += entry / width;
            if l > k {
                target[l * m + k] += entry / width;
            }
        }
    }
}

impl ElasticConnection {
    /// Returns the index of the first connected body, whose width applies in a plane model.
    fn first_body(&self) -> usize {
        self.bodies().next().map_or(0, |BodyId(body)| body)
    }

    /// Returns the forces of the connection on its attachments at motions of these, along and about
    /// the reference axes, N and N m.
    pub fn push(&self, motions: &[Six]) -> Vec<Six> {
        self.times(&self.stiffness, motions)
    }

    /// Returns the forces of the attachments on the connection at motions of these and forces on
    /// the coefficients of its raceways.
    pub fn forces_on_body(&self, motions: &[Six], on_raceways: &[f64]) -> Vec<Six> {
        let mut forces: Vec<Six> =
            self.push(motions).into_iter().map(|push| push.map(|force| 0.0 - force)).collect();
        for (row, force) in self.raceways.motions.chunks_exact(self.size()).zip(on_raceways) {
            forces.as_flattened_mut().iter_mut().zip(row).for_each(|(sum, part)| *sum -= force * part);
        }
        forces
    }

    /// Returns the coefficients of the raceways by the DOFs at a time (s), without forces on the
    /// raceways: coefficients by DOFs.
    ///
    /// # Errors
    /// Those of [`ConnectionState::at`].
    pub fn raceway_motions(
        &self,
        bodies: &[Body],
        dofs: &[Dof],
        time: f64,
    ) -> Result<DMatrix<f64>, EngineError> {
        let state = ConnectionState::at(bodies, self, time)?;
        let (size, terms) = (self.size(), self.raceways.terms());
        let mut motions = DMatrix::zeros(terms, dofs.len());
        for (column, dof) in dofs.iter().enumerate() {
            for (attachment, unit) in state.moved(dof) {
                for (component, part) in unit.into_iter().enumerate().filter(|(_, part)| *part != 0.0) {
                    for term in 0..terms {
                        let entry = self.raceways.motions[term * size + 6 * attachment + component];
                        motions[(term, column)] += entry * part;
                    }
                }
            }
        }
        Ok(motions)
    }

    /// Returns the inertia forces of the connection on its attachments at accelerations of these;
    /// zero without a mass matrix.
    pub fn inertia_forces(&self, accelerations: &[Six]) -> Vec<Six> {
        if self.mass.is_empty() {
            vec![[0.0; 6]; accelerations.len()]
        } else {
            self.times(&self.mass, accelerations)
        }
    }

    /// Returns the inertia forces on the component modes at accelerations of the attachments.
    pub fn modal_inertia_forces(&self, accelerations: &[Six]) -> Vec<f64> {
        let mut forces = vec![0.0; self.modes.count()];
        for (acceleration, row) in accelerations.iter().flatten().zip(self.coupling_rows()) {
            forces.iter_mut().zip(row).for_each(|(force, entry)| *force -= entry * acceleration);
        }
        forces
    }

    /// Adds to forces on the attachments the inertia forces due to accelerations of the component
    /// modes.
    pub fn add_inertia_of_modes(&self, forces: &mut [Six], accelerations: &[f64]) {
        for (force, row) in forces.iter_mut().flatten().zip(self.coupling_rows()) {
            *force -= row.iter().zip(accelerations).map(|(entry, q)| entry * q).sum::<f64>();
        }
    }

    /// Returns the mass between each component of the attachments and all component modes.
    fn coupling_rows(&self) -> impl Iterator<Item = &[f64]> {
        self.modes.coupling.chunks_exact(self.modes.count().max(1))
    }

    /// Returns the product of a matrix and motions, with opposite sign.
    fn times(&self, matrix: &[f64], motions: &[Six]) -> Vec<Six> {
        let size = self.size();
        let row = |row: usize| {
            let entry = |column: usize| 0.5 * (matrix[row * size + column] + matrix[column * size + row]);
            let sum: f64 = (0..size).map(|column| entry(column) * motions[column / 6][column % 6]).sum();
            0.0 - sum
        };
        (0..motions.len()).map(|attachment| std::array::from_fn(|k| row(6 * attachment + k))).collect()
    }
}
