//! Modal coordinates of bodies in a contact problem. Each is an independent spring and mass, so
//! they are eliminated.
//!
//! A modal coordinate q changes the gap of a cell by the inward displacement of the surface, C_q.
//! It satisfies `d y + S' y_r = g + C_q' p`, with the diagonal d of the step's effective matrix and
//! the mass coupling S to the rigid-body DOFs. So the compliance of the cells contains `C_q d^-1
//! C_q'` in place of the static part `C_q omega^-2 C_q'` of these modes. The static compliance of
//! the omitted modes, the residual flexibility, is unchanged.
//!
//! See `docs/theory/dynamics.md`.

use calyx_contact::grid::Cell;
use calyx_contact::problem::ContactProblem;
use calyx_model::connection::CondensedShaft;
use calyx_model::fidelity::Fidelity;
use calyx_model::mechanism::Mechanism;
use calyx_model::plan::Plan;
use calyx_model::resources::Resources;
use calyx_numerics::error::EngineError;
use calyx_structure::{BodyModes, Chart};
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatMut, MatRef, Par};
use std::f64::consts::TAU;
use std::sync::Arc;

/// Modes of all bodies, and the index of each body's first coordinate.
#[derive(Clone, Default)]
pub struct Modes {
    /// Modes by body.
    pub of: Vec<Option<Arc<BodyModes>>>,
    /// Index of the first coordinate by body.
    first: Vec<usize>,
    /// Squares of all natural frequencies, (rad/s)².
    pub squares: Vec<f64>,
}

impl Modes {
    /// Combines modes in the order of the bodies.
    pub fn new(of: Vec<Option<Arc<BodyModes>>>) -> Modes {
        let (mut first, mut squares) = (Vec::new(), Vec::new());
        for modes in &of {
            first.push(squares.len());
            squares
                .extend(modes.iter().flat_map(|modes| modes.frequencies.iter().map(|omega| omega * omega)));
        }
        Modes { of, first, squares }
    }

    /// Returns the modes with further coordinates that move no cell, by the squares of their
    /// natural frequencies, (rad/s)².
    pub fn followed_by<'s>(&'s self, squares: impl Iterator<Item = &'s f64>) -> Modes {
        let squares = self.squares.iter().chain(squares).copied().collect();
        Modes { squares, ..self.clone() }
    }

    /// Computes the modes of all gears that support them, up to a natural frequency, Hz; none for 0
    /// and in three dimensions.
    ///
    /// # Errors
    /// Those of [`check_modes`] and [`Resources::modes`].
    pub fn find(
        scene: &Mechanism,
        plan: &Plan,
        resources: &Resources,
        highest: f64,
    ) -> Result<Modes, EngineError> {
        check_modes(scene, plan, highest)?;
        if highest == 0.0 || plan.three_dimensional {
            return Ok(Modes::default());
        }
        let bodies = scene.bodies.iter().zip(&plan.bodies);
        let of =
            bodies.map(|(body, plan)| match plan.is_elastic() && body.prototype.without_modes().is_none() {
                true => resources.modes(body.prototype.as_ref(), &plan.options, TAU * highest),
                false => Ok(None),
            });
        Ok(Modes::new(of.collect::<Result<_, _>>()?))
    }

    /// Returns the number of coordinates.
    pub fn count(&self) -> usize {
        self.squares.len()
    }

    /// Returns the modes of a body and the index of its first coordinate.
    pub fn of_body(&self, body: usize) -> Option<(&BodyModes, usize)> {
        Some((self.of.get(body)?.as_deref()?, self.first[body]))
    }

    /// Adds the derivatives of the gaps of a patch's cells by the coordinates of its bodies,
    /// starting at a row of `arms`.
    pub fn add_arms(&self, arms: &mut Mat<f64>, row: usize, sides: [(usize, Chart); 2], cells: &[Cell]) {
        for (side, (body, chart)) in sides.into_iter().enumerate() {
            let Some((own, from)) = self.of_body(body) else { continue };
            let places: Vec<f64> = cells.iter().map(|cell| cell.loaded_at[side]).collect();
            let mut target = arms.as_mut().submatrix_mut(row, from, places.len(), own.count());
            target += own.displacements(chart, &places);
        }
    }
}

/// Checks whether modes of bodies up to this natural frequency, Hz, are supported: those of gears
/// in two dimensions, and those of elastic bodies such as housings in three.
///
/// # Errors
/// E0764: it is negative or NaN. E0771: the model is three-dimensional and has no elastic body.
/// E0782: its bodies have no meshes. E0858: a shaft has too many modes.
pub fn check_modes(scene: &Mechanism, plan: &Plan, highest: f64) -> Result<(), EngineError> {
    let fidelity = plan.fidelity;
    let mut modelled = plan.modelled_connections().into_iter();
    let elastic = plan.three_dimensional
        && fidelity != Fidelity::Rigid
        && modelled.any(|connection| scene.connections[connection].has_modes());
    if elastic && highest > 0.0 && highest.is_finite() {
        for connection in plan.modelled_connections().into_iter().map(|index| &scene.connections[index]) {
            if let Some(CondensedShaft { shaft, stations, rigid: false }) = &connection.shaft
                && !stations.is_empty()
            {
                shaft.check_modes(stations, highest).map_err(|error| connection.about_shaft(error))?;
            }
        }
    }
    let (code, message, help) = match fidelity {
        _ if !(highest.is_finite() && highest >= 0.0) => (
            "E0764",
            format!("modes up to {highest} Hz cannot be found"),
            "give a positive frequency, or 0 for no modes",
        ),
        _ if elastic => return Ok(()),
        Fidelity::Rigid | Fidelity::Analytic if highest > 0.0 => (
            "E0782",
            format!(
                "the modes of bodies are those of their meshes, and the fidelity \"{}\" has none",
                fidelity.name()
            ),
            "leave `highest_frequency` at 0: bodies then vibrate as rigid ones",
        ),
        Fidelity::Solid(_) if highest > 0.0 => (
            "E0771",
            "the elastic modes of gears are two-dimensional, and this three-dimensional model has no shaft, housing or other elastic body".into(),
            "leave `highest_frequency` at 0: gears then vibrate as rigid bodies on their elastic teeth",
        ),
        _ => return Ok(()),
    };
    Err(EngineError::new(code, message, help).blame("highest_frequency"))
}

/// Terms of the modal coordinates in a time step or an equilibrium.
pub struct ModalElimination<'a> {
    /// Modes of the bodies.
    pub modes: &'a Modes,
    /// d, diagonal by coordinate.
    pub stiffness: Vec<f64>,
    /// S, DOFs by coordinates, row-major.
    pub coupling: Vec<f64>,
    /// g, load by coordinate.
    pub load: Vec<f64>,
    /// Coordinates at the origin of the gaps.
    pub start: Vec<f64>,
}

impl ModalElimination<'_> {
    /// Eliminates the coordinates from a problem; `arms` is C_q, cells by coordinates, without rows
    /// if no coordinate moves a cell. Bearing stops are not coupled to them.
    pub fn eliminate(&self, problem: &mut ContactProblem, arms: &Mat<f64>) {
        let (n, m, count) = (problem.cells(), problem.dofs(), self.modes.count());
        let given: Vec<f64> = self.load.iter().zip(&self.stiffness).map(|(g, d)| g / d).collect();
        let weight = |k: usize| self.stiffness[k].recip() - self.modes.squares[k].recip();
        let cells = arms.nrows();
        let weighted = Mat::from_fn(cells, count, |cell, k| arms[(cell, k)] * weight(k));
        let mut more = Mat::zeros(cells, cells);
        // Modes of elastic connections move no cell.
        if cells > 0 {
            product(more.as_mut(), weighted.as_ref(), arms.transpose());
        }
        for row in 0..cells {
            for column in 0..cells {
                // Use the same of both entries, so that the matrix is exactly symmetric.
                problem.compliance[row * n + column] += more[(row.max(column), row.min(column))];
            }
            let at = |k: usize| arms[(row, k)] * (self.start[k] + given[k]);
            problem.gaps[row] += (0..count).map(at).sum::<f64>();
            for dof in 0..m {
                let through = |k: usize| arms[(row, k)] * self.coupling[dof * count + k] / self.stiffness[k];
                problem.arms[row * m + dof] -= (0..count).map(through).sum::<f64>();
            }
        }
        for i in 0..m {
            let own = &self.coupling[i * count..(i + 1) * count];
            problem.load[i] -= own.iter().zip(&given).map(|(s, y)| s * y).sum::<f64>();
            for j in 0..m {
                let (low, high) = (i.min(j), i.max(j));
                let through = |k: usize| {
                    self.coupling[low * count + k] * self.coupling[high * count + k] / self.stiffness[k]
                };
                problem.stiffness[i * m + j] -= (0..count).map(through).sum::<f64>();
            }
        }
    }

    /// Returns the coordinates relative to `start`, from the forces on the cells and the motion of
    /// the DOFs.
    pub fn recover(&self, arms: &Mat<f64>, forces: &[f64], motion: &[f64]) -> Vec<f64> {
        let count = self.modes.count();
        let of = |k: usize| {
            let pushed: f64 = (0..arms.nrows()).map(|cell| arms[(cell, k)] * forces[cell]).sum();
            let carried: f64 = motion.iter().enumerate().map(|(i, y)| self.coupling[i * count + k] * y).sum();
            (self.load[k] + pushed - carried) / self.stiffness[k]
        };
        (0..count).map(of).collect()
    }
}

/// Computes `out = a b` on one thread: the bits do not depend on the number of threads.
fn product(out: MatMut<'_, f64>, a: MatRef<'_, f64>, b: MatRef<'_, f64>) {
    matmul(out, Accum::Replace, a, b, 1.0, Par::Seq);
}
