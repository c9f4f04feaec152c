//! All bearings of a scene as the contact problem sees them: a stiffness and loads on the freedoms, and gap equations of their own, behind
//! which those of lugs are added ([`crate::lug_contact`]).

use super::{Bearing, BearingMatrix, Placed};
use crate::body::Body;
use crate::freedom::Freedom;
use calyx_contact::problem::ContactProblem;
use calyx_numerics::error::EngineError;
use faer::MatRef;

/// What bearings, and lugs with clearance, add to a contact problem. Forces are per width of a plane model, as the problem's are.
#[derive(Clone)]
pub struct Springs {
    /// K, freedoms by freedoms, row-major.
    pub stiffness: Vec<f64>,
    /// Generalised forces by unloaded deformations and loads of the bearings themselves.
    pub load: Vec<f64>,
    /// Gaps of the stops, and behind them of the flanks of lugs, m.
    pub gaps: Vec<f64>,
    /// Their growth by each freedom, row by row.
    pub arms: Vec<f64>,
    /// Their growth by the forces on them, row-major.
    compliance: Vec<f64>,
}

/// The planned bearings of a scene at a time (s), on these freedoms; `width` (m) is that of a body in a plane model, and 1 in space.
///
/// # Errors
/// As [`Placed::at`].
pub fn springs(
    bodies: &[Body],
    bearings: &[Bearing],
    planned: &[usize],
    freedoms: &[Freedom],
    width: impl Fn(usize) -> f64,
    time: f64,
) -> Result<Springs, EngineError> {
    let m = freedoms.len();
    let modelled = || planned.iter().filter_map(|&bearing| bearings.get(bearing));
    let walls: usize = modelled().map(Bearing::walls).sum();
    let mut springs = Springs { compliance: vec![0.0; walls * walls], ..Springs::none(m) };
    for bearing in modelled() {
        let placed = Placed::at(bodies, bearing, time)?;
        let width = width(bearing.body.0);
        let columns: Vec<[f64; 6]> = freedoms.iter().map(|freedom| placed.deflection(freedom)).collect();
        let pushed = |x: &[f64; 6]| stiffly(bearing, x);
        let own = bearing.own_load();
        for (k, column) in columns.iter().enumerate() {
            springs.load[k] += dot(column, &own) / width;
            let force = pushed(column);
            // Each entry and its mirror image once: symmetric to the bit.
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

/// The damping of the planned bearings between freedoms, row-major, as [`springs`].
///
/// # Errors
/// As [`Placed::at`].
pub fn damping(
    bodies: &[Body],
    bearings: &[Bearing],
    planned: &[usize],
    freedoms: &[Freedom],
    width: impl Fn(usize) -> f64,
    time: f64,
) -> Result<Vec<f64>, EngineError> {
    let m = freedoms.len();
    let mut damping = vec![0.0; m * m];
    for bearing in planned.iter().filter_map(|&bearing| bearings.get(bearing)) {
        if bearing.damping.iter().flatten().all(|&entry| entry == 0.0) {
            continue;
        }
        let placed = Placed::at(bodies, bearing, time)?;
        let width = width(bearing.body.0);
        let columns: Vec<[f64; 6]> = freedoms.iter().map(|freedom| placed.deflection(freedom)).collect();
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
    /// None, on so many freedoms.
    pub fn none(freedoms: usize) -> Springs {
        Springs {
            stiffness: vec![0.0; freedoms * freedoms],
            load: vec![0.0; freedoms],
            gaps: Vec::new(),
            arms: Vec::new(),
            compliance: Vec::new(),
        }
    }

    /// The same as seen from a position of the freedoms, and what is left of a load there.
    pub fn from(&self, start: &[f64], load: &[f64]) -> (Springs, Vec<f64>) {
        let m = start.len();
        let along = |row: &[f64]| row.iter().zip(start).map(|(entry, moved)| entry * moved).sum::<f64>();
        let left = |(k, load): (usize, &f64)| load - along(&self.stiffness[k * m..(k + 1) * m]);
        let opened = |(wall, gap): (usize, &f64)| gap + along(&self.arms[wall * m..(wall + 1) * m]);
        let gaps = self.gaps.iter().enumerate().map(opened).collect();
        (Springs { gaps, ..self.clone() }, load.iter().enumerate().map(left).collect())
    }

    /// The stops as seen from a position of the freedoms, with another matrix in place of the springs and no loads: for a step in time.
    pub fn stepping(&self, start: &[f64], matrix: Vec<f64>) -> Springs {
        let (seen, _) = self.from(start, &vec![0.0; start.len()]);
        Springs { stiffness: matrix, load: vec![0.0; start.len()], ..seen }
    }

    /// Adds gap equations behind those that there are, with their arms and what they do to each other, both row-major.
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

    /// Adds the gap equations to a problem, behind its cells. `across` is the growth of gaps of cells by forces on the last of these equations,
    /// cells by equations; others do nothing to cells but through the freedoms.
    pub fn behind(&self, cells: ContactProblem, across: MatRef<'_, f64>) -> ContactProblem {
        let (n, more) = (cells.gaps.len(), self.gaps.len());
        if more == 0 {
            return cells;
        }
        let mut problem = cells;
        let mut compliance = vec![0.0; (n + more) * (n + more)];
        for (row, entries) in compliance.chunks_exact_mut(n + more).enumerate() {
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
        problem
    }
}

impl Bearing {
    /// `K x0 + f_ext`: what pushes the first race where nothing has moved.
    fn own_load(&self) -> [f64; 6] {
        let sprung = stiffly(self, &self.unloaded);
        std::array::from_fn(|k| sprung[k] + self.load[k])
    }

    /// What damping takes at a rate of the deflection, along the bearing's axes: N and N m.
    pub fn damping_at(&self, rate: &[f64; 6]) -> [f64; 6] {
        symmetric(&self.damping, rate)
    }

    /// What the springs and the stops do to the first race at a deflection and forces on the walls (N), along the bearing's axes: N and
    /// N m.
    pub fn push(&self, deflection: &[f64; 6], walls: &[f64]) -> [f64; 6] {
        let (own, sprung) = (self.own_load(), stiffly(self, deflection));
        let mut push: [f64; 6] = std::array::from_fn(|k| own[k] - sprung[k]);
        let rows = self.stops.iter().flat_map(|stop| stop.walls().rows);
        for ((_, direction), force) in rows.zip(walls) {
            for (sum, part) in push.iter_mut().zip(direction) {
                *sum += part * force;
            }
        }
        push
    }
}

/// `K x` of a bearing.
fn stiffly(bearing: &Bearing, x: &[f64; 6]) -> [f64; 6] {
    symmetric(&bearing.stiffness, x)
}

/// `K x`, of the symmetric part of K: what printed digits leave of the other one is none.
fn symmetric(matrix: &BearingMatrix, x: &[f64; 6]) -> [f64; 6] {
    std::array::from_fn(|i| (0..6).map(|j| 0.5 * (matrix[i][j] + matrix[j][i]) * x[j]).sum())
}

fn dot(a: &[f64; 6], b: &[f64; 6]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
