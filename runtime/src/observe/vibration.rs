//! Natural vibrations of a scene about an equilibrium: its bodies on bearings and on the contact that carries load now, as rigid ones or
//! with their own modes.
//!
//! A small motion of the freedoms x and of the modal coordinates q finds the stiffness `K = diag(K_bearings, omega²) + C' A^-1 C`. C are the arms of
//! the cells and stops that carry load, which stay in contact, and A is their compliance less what the modes answer, `sum phi phi' / omega²`: together
//! they give as in statics. What resists is the inertia of the bodies, with `phi' M r` between modes and frames. So frequencies
//! are those at one position: as teeth enter and leave, stiffness and frequencies change with them. What turning does
//! (gyroscopic terms) and damping are left out.

use super::{Equilibrium, Observable, Quantity};
use crate::dense::{
    add_product_lower, cholesky, half_solve, mirror_lower, other_half_solve, symmetric_eigen,
};
use crate::dynamics::{check_inertia, coupling};
use crate::error::EngineError;
use crate::inertia::Inertia;
use crate::results::Observed;
use crate::scene::BodyId;
use crate::scene::Scene;
use crate::step::{PatchGrid, StepResult};
use crate::structure::Chart;
use crate::system::System;
use faer::Mat;
use nalgebra::DMatrix;
use std::f64::consts::TAU;
use std::sync::Arc;

/// Free vibrations: coordinates by modes. Coordinates are the freedoms, then the modal coordinates of the bodies, body after body.
#[derive(Clone, Debug, PartialEq)]
pub struct Vibrations {
    /// Natural frequencies, rad/s, ascending; those of free rigid motions are 0 but for rounding.
    pub frequencies: Vec<f64>,
    /// A column a mode, of unit modal mass: m and rad by freedom, m kg^1/2 per root of a metre by modal coordinate, per square root of kg.
    pub shapes: DMatrix<f64>,
    /// Between coordinates: kg, kg m and kg m² of freedoms.
    pub mass: DMatrix<f64>,
    /// Between coordinates: N/m, N and N m of freedoms.
    pub stiffness: DMatrix<f64>,
}

impl System<'_> {
    /// Mass matrix of the freedoms at a time (s), of rigid bodies about their axles.
    pub fn mass_matrix(&self, time: f64) -> DMatrix<f64> {
        let freedoms = &self.freedoms;
        let mut mass = DMatrix::zeros(freedoms.len(), freedoms.len());
        for index in 0..self.scene.bodies.len() {
            let own: Vec<usize> = (0..freedoms.len()).filter(|&i| freedoms[i].body == index).collect();
            if own.is_empty() {
                continue;
            }
            let inertia = self.inertias()[index];
            let turned = self.inertia_on_ground(index, time, &inertia);
            let axes = self.axes(index, time);
            for &i in &own {
                for &j in &own {
                    mass[(i, j)] = entry(&turned, &axes, freedoms[i].component, freedoms[j].component);
                }
            }
        }
        mass
    }

    /// An inertia in a body's axes, along those of the ground.
    fn inertia_on_ground(&self, body: usize, time: f64, inertia: &Inertia) -> Inertia {
        let Ok(pose) = crate::system::solid_pose(self.scene, body, time) else {
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

/// Of two components of one frame: of displacements and turns along and about its axes.
fn entry(inertia: &Inertia, axes: &[[f64; 3]; 3], one: usize, other: usize) -> f64 {
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
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
    /// Growth of the gaps of all cells of a solved position by the modal coordinates of the bodies.
    fn modal_arms(&self, step: &StepResult) -> Mat<f64> {
        let cells = step.patches.iter().map(|patch| patch.forces.len()).sum();
        let mut arms = Mat::zeros(cells, self.modes.count());
        let mut first = 0;
        for patch in &step.patches {
            if let PatchGrid::Plane { cells, .. } = &patch.grid {
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

    /// Mass matrix of all coordinates at a time (s).
    fn whole_mass(&self, time: f64) -> Option<Mat<f64>> {
        let (own, widths) = (self.mass_matrix(time), self.coordinate_widths());
        let (m, count) = (own.nrows(), self.modes.count());
        let between = coupling(self, time).ok()?;
        let entry = |row: usize, column: usize| match (row.checked_sub(m), column.checked_sub(m)) {
            (None, None) => own[(row, column)],
            (None, Some(mode)) => widths[row] * between[row * count + mode],
            (Some(mode), None) => widths[column] * between[column * count + mode],
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

    /// What forces on each coordinate are per, m: on freedoms, then on modal coordinates. Coordinates that have to do with each other have one.
    fn coordinate_widths(&self) -> Vec<f64> {
        let mut widths: Vec<f64> = self.freedoms.iter().map(|freedom| self.width(freedom.body)).collect();
        for body in 0..self.scene.bodies.len() {
            let modes = self.modes.of_body(body).map_or(0, |(own, _)| own.count());
            widths.extend(std::iter::repeat_n(self.width(body), modes));
        }
        widths
    }
}

impl Equilibrium<'_> {
    /// The free vibrations about the equilibrium; `None` if a freedom has no inertia or nothing vibrates. They are found once a position.
    pub fn vibrations(self) -> Option<Arc<Vibrations>> {
        self.step.vibrations.get_or_init(|| self.find_vibrations().map(Arc::new)).clone()
    }

    /// Stiffness between coordinates, per width of the model.
    fn stiffness(self) -> Option<Mat<f64>> {
        let (problem, active, modes) = (&self.step.problem, &self.step.active, &self.system.modes);
        let (n, m, count) = (problem.cells(), self.system.freedoms.len(), modes.count());
        if problem.stiffness.len() != m * m {
            return None;
        }
        let bearings = |i: usize, j: usize| problem.stiffness[i * m + j];
        let mut stiffness = Mat::from_fn(m + count, m + count, |i, j| match (i.max(j) < m, i == j) {
            (true, _) => 0.5 * (bearings(i, j) + bearings(j, i)),
            (false, true) => modes.squares[i - m],
            (false, false) => 0.0,
        });
        if active.is_empty() {
            return Some(stiffness);
        }
        let own = self.system.modal_arms(self.step);
        // Stops of bearings come behind the cells.
        let modal = |cell: usize, k: usize| if cell < own.nrows() { own[(cell, k)] } else { 0.0 };
        let mut residual =
            Mat::from_fn(active.len(), active.len(), |i, j| problem.compliance[active[i] * n + active[j]]);
        let answered =
            Mat::from_fn(active.len(), count, |i, k| modal(active[i], k) / modes.squares[k].sqrt());
        add_product_lower(residual.as_mut(), -1.0, answered.as_ref(), answered.transpose());
        let arms = Mat::from_fn(active.len(), m + count, |i, k| match k.checked_sub(m) {
            None => problem.arms[active[i] * m + k],
            Some(mode) => modal(active[i], mode),
        });
        let pressed = half_solve(cholesky(residual)?.as_ref(), arms);
        add_product_lower(stiffness.as_mut(), 1.0, pressed.transpose(), pressed.as_ref());
        mirror_lower(&mut stiffness);
        Some(stiffness)
    }

    fn find_vibrations(self) -> Option<Vibrations> {
        let (mass, stiffness) = (self.system.whole_mass(self.step.time)?, self.stiffness()?);
        let (size, widths) = (mass.nrows(), self.system.coordinate_widths());
        // Every coordinate in a unit in which its own inertia is 1: metres and radians are alike then.
        let scale: Vec<f64> = (0..size).map(|k| mass[(k, k)].sqrt().recip()).collect();
        if size == 0 || !scale.iter().all(|scale| scale.is_finite()) {
            return None;
        }
        let stiffness = Mat::from_fn(size, size, |i, j| widths[i] * stiffness[(i, j)]);
        let scaled =
            |matrix: &Mat<f64>| Mat::from_fn(size, size, |i, j| scale[i] * matrix[(i, j)] * scale[j]);
        let lower = cholesky(scaled(&mass))?;
        let half = half_solve(lower.as_ref(), scaled(&stiffness));
        let mut whole = half_solve(lower.as_ref(), half.transpose().to_owned());
        whole = Mat::from_fn(size, size, |i, j| 0.5 * (whole[(i, j)] + whole[(j, i)]));
        let (squares, vectors) = symmetric_eigen(whole.as_ref())?;
        let vectors = other_half_solve(lower.as_ref(), vectors);
        Some(Vibrations {
            frequencies: squares.iter().map(|square| square.max(0.0).sqrt()).collect(),
            shapes: DMatrix::from_fn(size, size, |i, mode| scale[i] * vectors[(i, mode)]),
            mass: DMatrix::from_fn(size, size, |i, j| mass[(i, j)]),
            stiffness: DMatrix::from_fn(size, size, |i, j| stiffness[(i, j)]),
        })
    }
}

/// That a system whose vibrations are asked for has inertia where it is free, and as many modes as are asked for.
///
/// # Errors
/// E0762: a free freedom has no inertia. E0770: there are fewer modes.
pub(crate) fn check_vibrations(system: &System<'_>) -> Result<(), EngineError> {
    let scene = system.scene;
    let highest = scene.observables.iter().filter_map(|observable| observable.mode()).max();
    if highest.is_none() && scene.modes_table.is_none() {
        return Ok(());
    }
    check_inertia(scene, &system.freedoms, system.inertias())?;
    check_mode_count(scene, system.freedoms.len() + system.modes.count())
}

/// That a scene with so many modes has all that are asked for.
///
/// # Errors
/// E0770: there are fewer.
pub(crate) fn check_mode_count(scene: &Scene, count: usize) -> Result<(), EngineError> {
    match scene.observables.iter().filter_map(|observable| observable.mode()).max() {
        Some(mode) if mode >= count => Err(EngineError::new(
            "E0770",
            format!("there is no mode {}: the scene has {count}", mode + 1),
            "the number of modes is that of the free degrees of freedom plus the elastic modes of bodies up to `highest_frequency`",
        )),
        _ => Ok(()),
    }
}

/// A natural frequency of the scene about its equilibrium: number 0 is the lowest. Hz.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NaturalFrequency(pub usize);

impl Observable for NaturalFrequency {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("natural_frequency", "Hz")
    }

    fn mode(&self) -> Option<usize> {
        Some(self.0)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let found = at.vibrations().and_then(|all| all.frequencies.get(self.0).copied());
        Observed::number(found.map_or(f64::NAN, |omega| omega / TAU))
    }
}

/// The part of a mode's kinetic energy in some of a body's motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ModeShare {
    /// From the lowest frequency up, from 0.
    pub mode: usize,
    /// Whose.
    pub body: BodyId,
    /// Which components of its frame count, in the order of [`crate::scene::FREEDOMS`].
    pub components: [bool; 6],
    /// Whether its modal coordinates do: what it vibrates against its frame.
    pub elastic: bool,
}

impl Observable for ModeShare {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("mode_share", "1")
    }

    fn mode(&self) -> Option<usize> {
        Some(self.mode)
    }

    fn frame_of(&self) -> Option<BodyId> {
        Some(self.body)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let Some(all) = at.vibrations().filter(|all| self.mode < all.frequencies.len()) else {
            return Observed::number(f64::NAN);
        };
        let energies = all.energies(self.mode);
        let freedoms = &at.system.freedoms;
        let own = freedoms
            .iter()
            .zip(&energies)
            .filter(|(freedom, _)| freedom.body == self.body.0 && self.components[freedom.component]);
        let rigid: f64 = own.map(|(_, energy)| energy).sum();
        let modal = at.system.modes.of_body(self.body.0).filter(|_| self.elastic);
        let elastic = modal.map_or(0.0, |(own, first)| {
            energies[freedoms.len() + first..].iter().take(own.count()).sum::<f64>()
        });
        Observed::number(rigid + elastic)
    }
}

impl Vibrations {
    /// What each coordinate has of a mode's kinetic energy, the whole being 1.
    pub fn energies(&self, mode: usize) -> Vec<f64> {
        let shape = self.shapes.column(mode);
        let momentum = &self.mass * shape;
        shape.iter().zip(momentum.iter()).map(|(moved, momentum)| moved * momentum).collect()
    }
}
