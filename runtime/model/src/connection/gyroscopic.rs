//! Gyroscopic terms of elastic connections: those of rotating shafts.

use super::connection_state::Six;
use super::{ConnectionState, ElasticConnection};
use crate::bearing::Support;
use crate::body::Body;
use crate::dof::Dof;
use crate::motion::{Motion, angular_acceleration, angular_velocity};
use crate::whirl::quarter_turn_momentum;
use calyx_numerics::error::EngineError;
use calyx_numerics::vec3::{Vector, dot};

/// Returns the component of an angular velocity or acceleration of a connection about its third
/// reference axis at a time.
fn about_axis(
    bodies: &[Body],
    connection: &ElasticConnection,
    state: &ConnectionState,
    time: f64,
    rate: fn(&dyn Motion, f64) -> Vector,
) -> f64 {
    match connection.attachments.first().map(|attachment| attachment.to) {
        Some(Support::Body(id)) => {
            bodies.get(id.0).map_or(0.0, |body| dot(state.axes[2], rate(body.motion.as_ref(), time)))
        }
        _ => 0.0,
    }
}

/// Rotation of a connection about its third reference axis.
struct Rotation<'c> {
    connection: &'c ElasticConnection,
    state: ConnectionState,
    /// Angular velocity about the axis, rad/s.
    speed: f64,
}

impl<'c> Rotation<'c> {
    fn at(
        bodies: &[Body],
        connection: &'c ElasticConnection,
        time: f64,
    ) -> Result<Rotation<'c>, EngineError> {
        let state = ConnectionState::at(bodies, connection, time)?;
        let speed = about_axis(bodies, connection, &state, time, angular_velocity);
        Ok(Rotation { connection, state, speed })
    }

    /// Adds a skew-symmetric matrix of the attachments, or of these and of the modes that follow
    /// them, to one of the coordinates: DOFs, others, and from `first_mode` the modes of the
    /// connection. Each entry is computed once, so that the sum is exactly skew-symmetric.
    fn add(&self, target: &mut [f64], dofs: &[Dof], first_mode: usize, matrix: &[f64]) {
        let (columns, size) = (target.len().isqrt(), matrix.len().isqrt());
        let of_dof = |(k, dof): (usize, &Dof)| {
            let moved = self.state.moved(dof).into_iter().flat_map(|(attachment, unit)| {
                (0..6).map(move |component| (6 * attachment + component, unit[component]))
            });
            (k, moved.filter(|(_, part)| *part != 0.0).collect::<Vec<_>>())
        };
        let rows = self.connection.size();
        let of_modes = (rows..size).map(|row| (first_mode + row - rows, vec![(row, 1.0)]));
        let moved: Vec<(usize, Vec<(usize, f64)>)> =
            dofs.iter().enumerate().map(of_dof).chain(of_modes).collect();
        for (index, (k, one)) in moved.iter().enumerate().filter(|(_, (_, one))| !one.is_empty()) {
            for (l, other) in &moved[index + 1..] {
                let mut entry = 0.0;
                for (row, x) in one {
                    entry += other.iter().map(|(column, y)| x * y * matrix[row * size + column]).sum::<f64>();
                }
                target[k * columns + l] += entry;
                target[l * columns + k] -= entry;
            }
        }
    }
}

/// Gyroscopic terms of a rotating shaft at a time.
///
/// A section with the polar moment of inertia J has the momentum `J w (e + theta x e)`, whose rate
/// of change by the deviations is `J (w theta' + w' theta) x e`.
pub struct GyroscopicShaft {
    /// Matrix between the attachments, and the component modes if there are any, per angular
    /// velocity, row-major, kg m².
    matrix: Vec<f64>,
    /// Angular velocity, rad/s, and acceleration, rad/s².
    speed: f64,
    acceleration: f64,
}

impl GyroscopicShaft {
    /// Returns the terms of a connection in a state; `None` if it is no elastic shaft or does not
    /// rotate.
    pub fn at(
        bodies: &[Body],
        connection: &ElasticConnection,
        state: &ConnectionState,
        time: f64,
    ) -> Option<GyroscopicShaft> {
        let shaft = connection.shaft.as_ref().filter(|shaft| !shaft.rigid)?;
        let [speed, acceleration] = [angular_velocity, angular_acceleration]
            .map(|rate| about_axis(bodies, connection, state, time, rate));
        let matrix = match &connection.modes.gyroscopic[..] {
            _ if [speed, acceleration] == [0.0; 2] => return None,
            [] => shaft.shaft.gyroscopic(&shaft.stations),
            with_modes => with_modes.to_vec(),
        };
        Some(GyroscopicShaft { matrix, speed, acceleration })
    }

    /// Returns the gyroscopic forces on the attachments, along and about the reference axes, and on
    /// the component modes, at displacements and rates of both.
    pub fn forces(
        &self,
        [displacements, rates]: [&[Six]; 2],
        [modal_displacements, modal_rates]: [&[f64]; 2],
    ) -> (Vec<Six>, Vec<f64>) {
        let size = self.matrix.len().isqrt();
        let displacements = displacements.iter().flatten().chain(modal_displacements);
        let rates = rates.iter().flatten().chain(modal_rates);
        let of = |(x, v): (&f64, &f64)| self.acceleration * x + self.speed * v;
        let turning: Vec<f64> = displacements.zip(rates).map(of).collect();
        let of = |row: &[f64]| 0.0 - row.iter().zip(&turning).map(|(entry, part)| entry * part).sum::<f64>();
        let forces: Vec<f64> = self.matrix.chunks_exact(size.max(1)).map(of).collect();
        let (on_attachments, on_modes) = forces.split_at(turning.len() - modal_rates.len());
        let six = |part: &[f64]| std::array::from_fn(|k| part[k]);
        (on_attachments.chunks_exact(6).map(six).collect(), on_modes.to_vec())
    }
}

/// Returns the planned connections, each with the index of its first mode among all coordinates of
/// a matrix, of which the component modes are the last ones.
fn numbered<'c>(
    target: &[f64],
    connections: &'c [ElasticConnection],
    planned: &[usize],
) -> Vec<(&'c ElasticConnection, usize)> {
    let own: Vec<&ElasticConnection> = planned.iter().filter_map(|&index| connections.get(index)).collect();
    let modes: usize = own.iter().map(|connection| connection.modes.count()).sum();
    let mut first = target.len().isqrt() - modes;
    let numbered = own.into_iter().map(|connection| {
        first += connection.modes.count();
        (connection, first - connection.modes.count())
    });
    numbered.collect()
}

/// Adds the gyroscopic matrix of the planned connections of a three-dimensional scene at a time (s)
/// to a matrix, row-major, kg m²/s. Its coordinates begin with these DOFs and end with the
/// component modes of all planned connections. Elastic shafts have gyroscopic terms; other
/// connections have none.
///
/// # Errors
/// Those of [`ConnectionState::at`].
pub fn add_connection_gyroscopic(
    target: &mut [f64],
    (bodies, connections): (&[Body], &[ElasticConnection]),
    planned: &[usize],
    dofs: &[Dof],
    time: f64,
) -> Result<(), EngineError> {
    for (connection, first_mode) in numbered(target, connections, planned) {
        let state = ConnectionState::at(bodies, connection, time)?;
        if let Some(GyroscopicShaft { matrix, speed, .. }) =
            GyroscopicShaft::at(bodies, connection, &state, time)
        {
            let matrix: Vec<f64> = matrix.into_iter().map(|entry| speed * entry).collect();
            Rotation { connection, state, speed }.add(target, dofs, first_mode, &matrix);
        }
    }
    Ok(())
}

/// Adds the product of mass matrix and rotation by a right angle in the sense of the prescribed
/// rotation, for the connections that rotate: see [`quarter_turn_momentum`]. The coordinates are
/// those of [`add_connection_gyroscopic`].
///
/// # Errors
/// Those of [`ConnectionState::at`].
pub fn add_connection_whirl_form(
    target: &mut [f64],
    (bodies, connections): (&[Body], &[ElasticConnection]),
    planned: &[usize],
    dofs: &[Dof],
    time: f64,
) -> Result<(), EngineError> {
    for (connection, first_mode) in numbered(target, connections, planned) {
        if connection.mass.is_empty() {
            continue;
        }
        let rotation = Rotation::at(bodies, connection, time)?;
        if rotation.speed != 0.0 {
            let sense = rotation.speed.signum();
            let matrix = match &connection.modes.whirl_form[..] {
                [] => quarter_turn_momentum(&connection.mass, connection.size(), sense),
                with_modes => with_modes.iter().map(|entry| sense * entry).collect(),
            };
            rotation.add(target, dofs, first_mode, &matrix);
        }
    }
    Ok(())
}
