//! Natural vibrations of a scene about an equilibrium: its bodies as rigid ones, on bearings and on the contact that carries load now.
//!
//! A small motion x of the freedoms finds the stiffness `K = K_bearings + C' A^-1 C`, with C and A the arms and the compliance of the cells and
//! stops that carry load, which stay in contact; what resists it is the inertia of the bodies. So the frequencies are those at one position: as teeth enter and
//! leave, stiffness and frequencies change with them.

use super::{Equilibrium, Observable, Quantity};
use crate::inertia::Inertia;
use crate::results::Observed;
use crate::scene::BodyId;
use crate::system::System;
use nalgebra::{DMatrix, DVector, SymmetricEigen};
use std::f64::consts::TAU;

/// Free vibrations: freedoms by modes.
#[derive(Clone, Debug, PartialEq)]
pub struct Vibrations {
    /// Natural frequencies, rad/s, ascending; those of free rigid motions are 0 but for rounding.
    pub frequencies: Vec<f64>,
    /// A column a mode, of unit modal mass: m and rad by freedom, per square root of kg.
    pub shapes: DMatrix<f64>,
    /// Between freedoms: kg, kg m and kg m².
    pub mass: DMatrix<f64>,
    /// Between freedoms: N/m, N and N m.
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
            let inertia = self.scene.bodies[index].inertia().from(self.axle(index));
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

impl Equilibrium<'_> {
    /// The free vibrations about the equilibrium; `None` if a freedom has no inertia or nothing is free.
    pub fn vibrations(self) -> Option<Vibrations> {
        let (problem, active) = (&self.step.problem, &self.step.active);
        let (n, m, width) = (problem.cells(), self.system.freedoms.len(), self.system.width());
        if m == 0 || problem.stiffness.len() != m * m {
            return None;
        }
        let mut stiffness = DMatrix::from_row_slice(m, m, &problem.stiffness);
        if !active.is_empty() {
            let compliance = DMatrix::from_fn(active.len(), active.len(), |i, j| {
                problem.compliance[active[i] * n + active[j]]
            });
            let arms = DMatrix::from_fn(active.len(), m, |i, k| problem.arms[active[i] * m + k]);
            stiffness += arms.transpose() * compliance.cholesky()?.solve(&arms);
        }
        let stiffness = 0.5 * width * (&stiffness + stiffness.transpose());
        let mass = self.system.mass_matrix(self.step.time);
        // Every freedom in a unit in which its own inertia is 1: metres and radians are alike then.
        let scale = DVector::from_iterator(m, mass.diagonal().iter().map(|own| own.sqrt().recip()));
        if !scale.iter().all(|scale| scale.is_finite()) {
            return None;
        }
        let scaled =
            |matrix: &DMatrix<f64>| DMatrix::from_fn(m, m, |i, j| scale[i] * matrix[(i, j)] * scale[j]);
        let lower = scaled(&mass).cholesky()?.unpack();
        let half = lower.solve_lower_triangular(&scaled(&stiffness))?;
        let whole = lower.solve_lower_triangular(&half.transpose())?;
        let eigen = SymmetricEigen::new(0.5 * (&whole + whole.transpose()));
        let mut order: Vec<usize> = (0..m).collect();
        order.sort_by(|&a, &b| eigen.eigenvalues[a].total_cmp(&eigen.eigenvalues[b]));
        let vectors = lower.tr_solve_lower_triangular(&eigen.eigenvectors)?;
        let shapes = DMatrix::from_fn(m, m, |freedom, mode| scale[freedom] * vectors[(freedom, order[mode])]);
        let frequencies = order.iter().map(|&mode| eigen.eigenvalues[mode].max(0.0).sqrt()).collect();
        Some(Vibrations { frequencies, shapes, mass, stiffness })
    }
}

/// A natural frequency of the scene about its equilibrium: number 0 is the lowest. Hz.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NaturalFrequency(pub usize);

impl Observable for NaturalFrequency {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("natural_frequency", "Hz")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let found = at.vibrations().and_then(|all| all.frequencies.get(self.0).copied());
        Observed::number(found.map_or(f64::NAN, |omega| omega / TAU))
    }
}

/// The part of a mode's kinetic energy in some components of a body's motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ModeShare {
    /// From the lowest frequency up, from 0.
    pub mode: usize,
    /// Whose.
    pub body: BodyId,
    /// Which components count, in the order of [`crate::scene::FREEDOMS`].
    pub components: [bool; 6],
}

impl Observable for ModeShare {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("mode_share", "1")
    }

    fn frame_of(&self) -> Option<BodyId> {
        Some(self.body)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let Some(all) = at.vibrations().filter(|all| self.mode < all.frequencies.len()) else {
            return Observed::number(f64::NAN);
        };
        let shape = all.shapes.column(self.mode);
        let momentum = &all.mass * shape;
        let freedoms = at.system.freedoms.iter().enumerate();
        let own =
            freedoms.filter(|(_, freedom)| freedom.body == self.body.0 && self.components[freedom.component]);
        Observed::number(own.map(|(i, _)| shape[i] * momentum[i]).sum())
    }
}
