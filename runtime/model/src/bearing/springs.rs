//! Contribution of all bearings to the contact problem: stiffness and loads on the DOFs, and gap
//! equations of the stops, followed by those of spline teeth ([`crate::spline_contact`]).

use super::{Bearing, BearingMatrix, BearingState, Tangent};
use crate::body::Body;
use crate::dof::Dof;
use calyx_contact::problem::ContactProblem;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use faer::MatRef;

/// Number of rows of a compliance matrix between two checkpoints.
const BATCH: usize = 256;

/// Terms of bearings and of spline teeth with clearance in a contact problem. Forces are per width
/// of a plane model, like those of the problem.
#[derive(Clone)]
pub struct Springs {
    /// K, DOFs by DOFs, row-major.
    pub stiffness: Vec<f64>,
    /// Generalized forces due to unloaded deflections and the bearings' own loads.
    pub load: Vec<f64>,
    /// Gaps of the stops, then those of the flanks of spline teeth, m.
    pub gaps: Vec<f64>,
    /// Derivatives of the gaps by the DOFs, row-major.
    pub arms: Vec<f64>,
    /// Compliance matrix of these gaps, row-major.
    compliance: Vec<f64>,
}

/// Assembles the planned bearings of a scene at a time (s) on these DOFs. `width` (m) is that of a
/// body in a plane model, and 1 in three dimensions. `tangents` has the linearized rolling elements
/// of the bearings of the scene, if their deflections are known.
///
/// # Errors
/// Those of [`BearingState::at`].
pub fn springs(
    bodies: &[Body],
    bearings: &[Bearing],
    planned: &[usize],
    dofs: &[Dof],
    width: impl Fn(usize) -> f64,
    time: f64,
    tangents: &[Option<Tangent>],
) -> Result<Springs, EngineError> {
    let m = dofs.len();
    let modelled = || planned.iter().filter_map(|&bearing| Some((bearing, bearings.get(bearing)?)));
    let walls: usize = modelled().map(|(_, bearing)| bearing.walls()).sum();
    let mut springs = Springs { compliance: vec![0.0; walls * walls], ..Springs::none(m) };
    for (index, bearing) in modelled() {
        let placed = BearingState::at(bodies, bearing, time)?;
        let width = width(bearing.body.0);
        let columns: Vec<[f64; 6]> = dofs.iter().map(|dof| placed.deflection(dof)).collect();
        let typical = bearing.typical_tangent();
        let tangent = tangents.get(index).and_then(Option::as_ref).or(typical.as_ref());
        let pushed = |x: &[f64; 6]| {
            let springs = stiffly(bearing, x);
            let Some(tangent) = tangent else { return springs };
            let rolling = symmetric(&tangent.stiffness, x);
            std::array::from_fn(|k| springs[k] + rolling[k])
        };
        let mut own = bearing.own_load();
        for (own, load) in own.iter_mut().zip(tangent.iter().flat_map(|tangent| tangent.load)) {
            *own += load;
        }
        for (k, column) in columns.iter().enumerate() {
            springs.load[k] += dot(column, &own) / width;
            let force = pushed(column);
            // Compute each entry and its mirror image once, so that the matrix is exactly
            // symmetric.
            for (l, other) in columns.iter().enumerate().skip(k) {
                let entry = dot(&force, other) / width;
                springs.stiffness[k * m + l] += entry;
                if l > k {
                    springs.stiffness[l * m + k] += entry;
                }
            }
        }
        for stop in &bearing.stops {
            let stop = stop.walls();
            let (first, count) = (springs.gaps.len(), stop.rows.len());
            for (clearance, direction) in &stop.rows {
                springs.gaps.push(*clearance);
                springs.arms.extend(columns.iter().map(|column| dot(column, direction)));
            }
            for (entry, compliance) in stop.compliance.iter().enumerate() {
                let (row, column) = (first + entry / count, first + entry % count);
                springs.compliance[row * walls + column] = width * compliance;
            }
        }
    }
    Ok(springs)
}

/// Assembles the damping matrix of the planned bearings, row-major, like [`springs`].
///
/// # Errors
/// Those of [`BearingState::at`].
pub fn damping(
    bodies: &[Body],
    bearings: &[Bearing],
    planned: &[usize],
    dofs: &[Dof],
    width: impl Fn(usize) -> f64,
    time: f64,
) -> Result<Vec<f64>, EngineError> {
    let m = dofs.len();
    let mut damping = vec![0.0; m * m];
    for bearing in planned.iter().filter_map(|&bearing| bearings.get(bearing)) {
        if bearing.damping.iter().flatten().all(|&entry| entry == 0.0) {
            continue;
        }
        let placed = BearingState::at(bodies, bearing, time)?;
        let width = width(bearing.body.0);
        let columns: Vec<[f64; 6]> = dofs.iter().map(|dof| placed.deflection(dof)).collect();
        for (k, column) in columns.iter().enumerate() {
            let force = symmetric(&bearing.damping, column);
            for (l, other) in columns.iter().enumerate().skip(k) {
                let entry = dot(&force, other) / width;
                damping[k * m + l] += entry;
                if l > k {
                    damping[l * m + k] += entry;
                }
            }
        }
    }
    Ok(damping)
}

impl Springs {
    /// Creates the terms of a system without bearings.
    pub fn none(dofs: usize) -> Springs {
        Springs {
            stiffness: vec![0.0; dofs * dofs],
            load: vec![0.0; dofs],
            gaps: Vec::new(),
            arms: Vec::new(),
            compliance: Vec::new(),
        }
    }

    /// Shifts the origin to a position of the DOFs; also returns the residual load there.
    pub fn from(&self, start: &[f64], load: &[f64]) -> (Springs, Vec<f64>) {
        let m = start.len();
        let along = |row: &[f64]| row.iter().zip(start).map(|(entry, moved)| entry * moved).sum::<f64>();
        let left = |(k, load): (usize, &f64)| load - along(&self.stiffness[k * m..(k + 1) * m]);
        let opened = |(wall, gap): (usize, &f64)| gap + along(&self.arms[wall * m..(wall + 1) * m]);
        let gaps = self.gaps.iter().enumerate().map(opened).collect();
        (Springs { gaps, ..self.clone() }, load.iter().enumerate().map(left).collect())
    }

    /// Returns the stops relative to a position of the DOFs, with another matrix in place of the
    /// springs and without loads: for a time step.
    pub fn stepping(&self, start: &[f64], matrix: Vec<f64>) -> Springs {
        let (seen, _) = self.from(start, &vec![0.0; start.len()]);
        Springs { stiffness: matrix, load: vec![0.0; start.len()], ..seen }
    }

    /// Appends gap equations with their derivatives by the DOFs and their compliance matrix, both
    /// row-major.
    pub fn add_walls(&mut self, gaps: &[f64], arms: impl Iterator<Item = f64>, compliance: &[f64]) {
        let (first, own) = (self.gaps.len(), gaps.len());
        let all = first + own;
        let mut grown = vec![0.0; all * all];
        for row in 0..all {
            if row < first {
                grown[row * all..row * all + first]
                    .copy_from_slice(&self.compliance[row * first..(row + 1) * first]);
            } else {
                grown[row * all + first..(row + 1) * all]
                    .copy_from_slice(&compliance[(row - first) * own..(row - first + 1) * own]);
            }
        }
        self.compliance = grown;
        self.gaps.extend(gaps);
        self.arms.extend(arms);
    }

    /// Returns whether there are gap equations.
    pub fn has_equations(&self) -> bool {
        !self.gaps.is_empty()
    }

    /// Appends the gap equations to a contact problem, after its cells. `across` is the compliance
    /// of cells to forces on the last of these equations, cells by equations. All other coupling is
    /// through the DOFs. There is a checkpoint before each batch of rows.
    ///
    /// # Errors
    /// The computation is interrupted.
    pub fn behind(
        &self,
        cells: ContactProblem,
        across: MatRef<'_, f64>,
        interrupt: &Interrupt,
    ) -> Result<ContactProblem, EngineError> {
        if !self.has_equations() {
            return Ok(cells);
        }
        let (n, more) = (cells.gaps.len(), self.gaps.len());
        let mut problem = cells;
        let mut compliance = vec![0.0; (n + more) * (n + more)];
        for (row, entries) in compliance.chunks_exact_mut(n + more).enumerate() {
            if row % BATCH == 0 {
                interrupt.check()?;
            }
            if row < n {
                entries[..n].copy_from_slice(&problem.compliance[row * n..(row + 1) * n]);
            } else {
                let own = row - n;
                entries[n..].copy_from_slice(&self.compliance[own * more..(own + 1) * more]);
            }
        }
        let first = n + more - across.ncols();
        for row in 0..across.nrows() {
            for column in 0..across.ncols() {
                compliance[row * (n + more) + first + column] = across[(row, column)];
                compliance[(first + column) * (n + more) + row] = across[(row, column)];
            }
        }
        problem.compliance = compliance;
        problem.gaps.extend(&self.gaps);
        problem.arms.extend(&self.arms);
        Ok(problem)
    }
}

impl Bearing {
    /// Returns `K x0 + f_ext`, the force on the first race at zero deflection.
    fn own_load(&self) -> [f64; 6] {
        let sprung = stiffly(self, &self.unloaded);
        std::array::from_fn(|k| sprung[k] + self.load[k])
    }

    /// Returns the damping force at a rate of the deflection, along the bearing's axes, N and N m.
    pub fn damping_at(&self, rate: &[f64; 6]) -> [f64; 6] {
        symmetric(&self.damping, rate)
    }

    /// Returns the force of springs, stops and the given force of a nonlinear load
    /// ([`NonlinearLoad::push`](super::NonlinearLoad::push)) on the first race at a deflection and
    /// at forces on the walls (N), along the bearing's axes, N and N m.
    pub fn push(&self, deflection: &[f64; 6], walls: &[f64], nonlinear: Option<[f64; 6]>) -> [f64; 6] {
        let (own, sprung) = (self.own_load(), stiffly(self, deflection));
        let mut push: [f64; 6] = std::array::from_fn(|k| own[k] - sprung[k]);
        let rows = self.stops.iter().flat_map(|stop| stop.walls().rows);
        for ((_, direction), force) in rows.zip(walls) {
            for (sum, part) in push.iter_mut().zip(direction) {
                *sum += part * force;
            }
        }
        for (sum, part) in push.iter_mut().zip(nonlinear.into_iter().flatten()) {
            *sum += part;
        }
        push
    }
}

/// Computes `K x` of a bearing.
fn stiffly(bearing: &Bearing, x: &[f64; 6]) -> [f64; 6] {
    symmetric(&bearing.stiffness, x)
}

/// Computes `K x` with the symmetric part of K; its antisymmetric part is rounding of printed
/// digits.
fn symmetric(matrix: &BearingMatrix, x: &[f64; 6]) -> [f64; 6] {
    std::array::from_fn(|i| (0..6).map(|j| 0.5 * (matrix[i][j] + matrix[j][i]) * x[j]).sum())
}

fn dot(a: &[f64; 6], b: &[f64; 6]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
