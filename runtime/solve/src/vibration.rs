//! Natural vibrations of a scene about an equilibrium: bodies on bearings and on the active contact
//! cells, rigid or with their own modes.
//!
//! For small motions of the DOFs x and modal coordinates q the stiffness is `K = diag(K_bearings,
//! omega²) + C' A^-1 C`. C contains the arms of the cells and stops that carry load and remain in
//! contact, those at the boundary of the load in part ([`calyx_contact::load_boundary`]). A is
//! their compliance minus that of the modes, `sum phi phi' / omega²`, so that both together have
//! the static compliance. The mass matrix contains the inertia of the bodies, with `phi' M r`
//! between modes and frames. The component modes of elastic bodies follow the modes of gears: they
//! move no cell, and their mass couples them to the attachments. The frequencies are those at one
//! position: stiffness and frequencies change as teeth enter and leave contact. These are the
//! frequencies without rotation and without damping; those with gyroscopic terms follow from them,
//! see [`crate::gyroscopic`].
//!
//! See `docs/theory/modes.md`.

use crate::integration::{check_inertia, coupling};
use crate::step::{ContactGrid, Participating, StepResult};
use crate::system::System;
use crate::vibrations::Vibrations;
use calyx_contact::load_boundary::added_compliances;
use calyx_fe::inertia::Inertia;
use calyx_model::frames::solid_pose;
use calyx_model::target::Examined;
use calyx_numerics::dense::{Interruptible, mirror_lower, symmetric_eigen};
use calyx_numerics::error::EngineError;
use calyx_numerics::vec3::{cross, dot};
use calyx_structure::Chart;
use faer::Mat;
use nalgebra::DMatrix;
use std::sync::{Arc, OnceLock};

impl System<'_> {
    /// Returns the mass matrix of the DOFs at a time (s): rigid bodies about their axes of
    /// rotation, and elastic connections.
    pub fn mass_matrix(&self, time: f64) -> DMatrix<f64> {
        let dofs = &self.dofs;
        let mut mass = DMatrix::zeros(dofs.len(), dofs.len());
        for index in 0..self.scene.bodies.len() {
            let own: Vec<usize> = (0..dofs.len()).filter(|&i| dofs[i].body == index).collect();
            if own.is_empty() {
                continue;
            }
            let of_body = self.body_mass(index, time);
            for &i in &own {
                for &j in &own {
                    mass[(i, j)] = of_body[6 * dofs[i].component + dofs[j].component];
                }
            }
        }
        let mut connected = vec![0.0; dofs.len() * dofs.len()];
        if self.add_connection_mass(&mut connected, |_| 1.0, time).is_err() {
            connected.fill(f64::NAN);
        }
        mass + DMatrix::from_row_slice(dofs.len(), dofs.len(), &connected)
    }

    /// Returns the mass matrix of all six components of a body, by row.
    pub(crate) fn body_mass(&self, body: usize, time: f64) -> Vec<f64> {
        let turned = self.inertia_on_ground(body, time, &self.inertias()[body]);
        let axes = self.axes(body, time);
        (0..36).map(|k| entry(&turned, &axes, k / 6, k % 6)).collect()
    }

    /// Rotates an inertia from a body's axes to those of the ground.
    pub(crate) fn inertia_on_ground(&self, body: usize, time: f64, inertia: &Inertia) -> Inertia {
        let Ok(pose) = solid_pose(self.scene, body, time) else {
            return Inertia { mass: f64::NAN, ..*inertia };
        };
        let r = pose.rotation;
        let about = [0, 1, 2].map(|i: usize| {
            [0, 1, 2].map(|j: usize| {
                let term = |k: usize, l: usize| r[i][k] * inertia.about[k][l] * r[j][l];
                (0..3).map(|k| (0..3).map(|l| term(k, l)).sum::<f64>()).sum()
            })
        });
        Inertia { mass: inertia.mass, moment: pose.direction(inertia.moment), about }
    }
}

/// Returns the entry for two components of one frame: displacements and rotations along and about
/// its axes.
fn entry(inertia: &Inertia, axes: &[[f64; 3]; 3], one: usize, other: usize) -> f64 {
    match (one, other) {
        (0..3, 0..3) => inertia.mass * dot(axes[one], axes[other]),
        (0..3, _) => dot(axes[one], cross(axes[other - 3], inertia.moment)),
        (_, 0..3) => dot(axes[other], cross(axes[one - 3], inertia.moment)),
        _ => {
            let [a, b] = [axes[one - 3], axes[other - 3]];
            dot(a, inertia.about.map(|row| dot(row, b)))
        }
    }
}

impl System<'_> {
    /// Returns the derivatives of the gaps of all cells of a solved position by the modal
    /// coordinates.
    fn modal_arms(&self, step: &StepResult) -> Mat<f64> {
        let cells = step.patches.iter().map(|patch| patch.forces.len()).sum();
        let mut arms = Mat::zeros(cells, self.modes.count());
        let mut first = 0;
        for patch in &step.patches {
            if let ContactGrid::Plane { cells, .. } = &patch.grid {
                let bodies = self.scene.pairs[patch.pair].bodies;
                let side = |side: usize| {
                    let chart = Chart { tooth: patch.teeth[side], surface: patch.surfaces[side] };
                    (bodies[side].0, chart)
                };
                self.modes.add_arms(&mut arms, first, [side(0), side(1)], cells);
            }
            first += patch.forces.len();
        }
        arms
    }

    /// Returns the mass matrix of all coordinates at a time (s).
    fn whole_mass(&self, time: f64) -> Option<Mat<f64>> {
        let (own, widths) = (self.mass_matrix(time), self.coordinate_widths());
        let (m, of_gears, count) = (own.nrows(), self.modes.count(), self.mode_count());
        let (by_gears, by_bodies) = (coupling(self, time).ok()?, self.connection_mode_coupling(time).ok()?);
        let between = |dof: usize, mode: usize| match mode.checked_sub(of_gears) {
            None => by_gears[dof * of_gears + mode],
            Some(mode) => by_bodies[dof * (count - of_gears) + mode],
        };
        let entry = |row: usize, column: usize| match (row.checked_sub(m), column.checked_sub(m)) {
            (None, None) => own[(row, column)],
            (None, Some(mode)) => widths[row] * between(row, mode),
            (Some(mode), None) => widths[column] * between(column, mode),
            (Some(one), Some(other)) => {
                if one == other {
                    widths[row]
                } else {
                    0.0
                }
            }
        };
        Some(Mat::from_fn(m + count, m + count, entry))
    }

    /// Returns the width to which forces on each coordinate refer, m: DOFs, then modal coordinates
    /// of gears and of elastic bodies, which exist in three dimensions only. Coupled coordinates
    /// have equal widths.
    fn coordinate_widths(&self) -> Vec<f64> {
        let mut widths: Vec<f64> = self.dofs.iter().map(|dof| self.width(dof.body)).collect();
        for body in 0..self.scene.bodies.len() {
            let modes = self.modes.of_body(body).map_or(0, |(own, _)| own.count());
            widths.extend(std::iter::repeat_n(self.width(body), modes));
        }
        widths.resize(self.dofs.len() + self.mode_count(), 1.0);
        widths
    }
}

impl System<'_> {
    /// Returns the free vibrations about the equilibrium, computed once per position; `None` if a
    /// DOF has no inertia, if nothing vibrates, or if the analysis was interrupted, which the next
    /// checkpoint reports.
    pub fn vibrations(&self, step: &StepResult) -> Option<Arc<Vibrations>> {
        step.vibrations.get_or_init(|| self.find_vibrations(step).map(Arc::new)).clone()
    }

    /// Returns the part of the stiffness matrix of [`System::vibrations`] that is not due to
    /// contact: bearings, elastic connections and modes, N/m, N and N m for DOFs. `None` in a
    /// rigid-body limit.
    pub fn spring_stiffness(&self, step: &StepResult) -> Option<DMatrix<f64>> {
        let springs = self.springs_about(step)?;
        let widths = self.coordinate_widths();
        Some(DMatrix::from_fn(widths.len(), widths.len(), |i, j| widths[i] * springs[(i, j)]))
    }

    /// Returns the stiffness matrix without contact, per width of the model.
    fn springs_about(&self, step: &StepResult) -> Option<Mat<f64>> {
        let (problem, m) = (&step.problem, self.dofs.len());
        let connections = self.connection_modes();
        let of_bodies = connections.iter().flat_map(|(connection, _)| &connection.modes.eigenvalues);
        let squares: Vec<f64> = self.modes.squares.iter().chain(of_bodies).copied().collect();
        if problem.stiffness.len() != m * m {
            return None;
        }
        let bearings = |i: usize, j: usize| problem.stiffness[i * m + j];
        let all = m + self.mode_count();
        Some(Mat::from_fn(all, all, |i, j| match (i.max(j) < m, i == j) {
            (true, _) => 0.5 * (bearings(i, j) + bearings(j, i)),
            (false, true) => squares[i - m],
            (false, false) => 0.0,
        }))
    }

    /// Returns the stiffness matrix, per width of the model.
    fn stiffness_about(&self, step: &StepResult) -> Option<Mat<f64>> {
        let (problem, modes) = (&step.problem, &self.modes);
        let (m, of_gears, count) = (self.dofs.len(), modes.count(), self.mode_count());
        let mut stiffness = self.springs_about(step)?;
        let Participating { cells: active, participations } = step.participating(|_| true);
        if active.is_empty() {
            return Some(stiffness);
        }
        let own = self.modal_arms(step);
        // Stops of bearings follow the cells.
        let modal = |cell: usize, k: usize| match cell < own.nrows() && k < of_gears {
            true => own[(cell, k)],
            false => 0.0,
        };
        let mut residual = step.compliance_of(&active);
        let answered =
            Mat::from_fn(active.len(), of_gears, |i, k| modal(active[i], k) / modes.squares[k].sqrt());
        let checkpoint = || self.interrupt.check();
        let dense = Interruptible(&checkpoint);
        // Static compliance with and without modes is the same.
        for (cell, added) in
            added_compliances(&residual, &participations, dense).ok()??.into_iter().enumerate()
        {
            residual[(cell, cell)] += added;
        }
        dense.add_product_lower(residual.as_mut(), -1.0, answered.as_ref(), answered.transpose()).ok()?;
        let arms = Mat::from_fn(active.len(), m + count, |i, k| match k.checked_sub(m) {
            None => problem.arms[active[i] * m + k],
            Some(mode) => modal(active[i], mode),
        });
        let factor = dense.cholesky(residual).ok()??;
        let pressed = dense.solve_lower(factor.as_ref(), arms).ok()?;
        dense.add_product_lower(stiffness.as_mut(), 1.0, pressed.transpose(), pressed.as_ref()).ok()?;
        mirror_lower(&mut stiffness);
        Some(stiffness)
    }

    fn find_vibrations(&self, step: &StepResult) -> Option<Vibrations> {
        let (mass, stiffness) = (self.whole_mass(step.time)?, self.stiffness_about(step)?);
        let (size, widths) = (mass.nrows(), self.coordinate_widths());
        // Scale each coordinate to unit inertia, so that metres and radians are comparable.
        let scale: Vec<f64> = (0..size).map(|k| mass[(k, k)].sqrt().recip()).collect();
        if size == 0 || !scale.iter().all(|scale| scale.is_finite()) {
            return None;
        }
        let stiffness = Mat::from_fn(size, size, |i, j| widths[i] * stiffness[(i, j)]);
        let scaled =
            |matrix: &Mat<f64>| Mat::from_fn(size, size, |i, j| scale[i] * matrix[(i, j)] * scale[j]);
        let checkpoint = || self.interrupt.check();
        let dense = Interruptible(&checkpoint);
        let lower = dense.cholesky(scaled(&mass)).ok()??;
        let half = dense.solve_lower(lower.as_ref(), scaled(&stiffness)).ok()?;
        let mut whole = dense.solve_lower(lower.as_ref(), half.transpose().to_owned()).ok()?;
        whole = Mat::from_fn(size, size, |i, j| 0.5 * (whole[(i, j)] + whole[(j, i)]));
        // The decomposition is one operation without checkpoints.
        let (squares, vectors) = symmetric_eigen(whole.as_ref())?;
        let vectors = dense.solve_upper(lower.as_ref(), vectors).ok()?;
        Some(Vibrations {
            frequencies: squares.iter().map(|square| square.max(0.0).sqrt()).collect(),
            shapes: DMatrix::from_fn(size, size, |i, mode| scale[i] * vectors[(i, mode)]),
            mass: DMatrix::from_fn(size, size, |i, j| mass[(i, j)]),
            stiffness: DMatrix::from_fn(size, size, |i, j| stiffness[(i, j)]),
            gyroscopic: self.gyroscopic_matrix(step.time),
            whirl_form: self.whirl_form(step.time),
            whirl: OnceLock::new(),
        })
    }
}

/// Checks that a system whose vibrations are requested has inertia along its DOFs, and enough
/// modes.
///
/// # Errors
/// E0762: a free DOF has no inertia. E0770: there are fewer modes than requested.
pub fn check_vibrations(system: &System<'_>, examined: &dyn Examined) -> Result<(), EngineError> {
    let modes = examined.targets().iter().any(|target| target.mode.is_some());
    if !modes && !examined.examines_modes() {
        return Ok(());
    }
    check_inertia(system.scene, &system.dofs, system.inertias())?;
    check_mode_count(examined, system.dofs.len() + system.mode_count())
}

/// Checks that a scene with this number of modes has all that are requested.
///
/// # Errors
/// E0770: there are fewer.
pub fn check_mode_count(examined: &dyn Examined, count: usize) -> Result<(), EngineError> {
    let highest = examined.targets().iter().filter_map(|target| target.mode).max();
    let highest = highest.map(|mode| mode + 1).max(examined.tabulated_modes());
    match highest {
        Some(mode) if mode > count => {
            let help = match count {
                0 => {
                    "mount a body on bearings and free it (`free`): a scene has as many modes as free degrees of freedom"
                }
                _ => {
                    "the number of modes is that of the free degrees of freedom plus the elastic modes of bodies up to `highest_frequency`"
                }
            };
            Err(EngineError::new("E0770", format!("there is no mode {mode}: the scene has {count}"), help))
        }
        _ => Ok(()),
    }
}
