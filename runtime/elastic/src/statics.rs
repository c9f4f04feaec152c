//! Static displacements and reactions.

use crate::assembly::{System, dot, multiply};
use crate::check::mechanism;
use crate::error::ElasticError;
use crate::factor::{Factor, Pencil};
use crate::model::{Component, NodalLoad};
use crate::resources::Resources;
use faer::Mat;

/// Displacements and reactions of a load case.
#[derive(Clone, Debug, PartialEq)]
pub struct StaticSolution {
    /// Displacement of each node in its displacement axes, m and rad.
    pub displacements: Vec<[f64; 6]>,
    /// Reaction at each prescribed component: index of the node, component, force (N) or moment (N
    /// m) on the body.
    pub reactions: Vec<(usize, Component, f64)>,
    /// Strain energy, J.
    pub strain_energy: f64,
}

/// Solves the load cases of a system; the prescribed displacements act in every one.
///
/// # Errors
/// The body has a mechanism, a load acts on a component without stiffness, memory is insufficient,
/// or the caller ends the computation.
pub fn solve(
    system: &System<'_>,
    cases: &[Vec<NodalLoad>],
    resources: &Resources,
) -> Result<Vec<StaticSolution>, ElasticError> {
    let loads = cases.iter().map(|case| system.loads(case)).collect::<Result<Vec<_>, _>>()?;
    let constrained = system.constrained();
    let factor =
        Factor::new(Pencil::stiffness(&system.stiffness), &system.positions, &constrained, resources)?;
    if !factor.singular.is_empty() {
        return Err(mechanism(system, &factor.singular));
    }
    let mut start = vec![0.0; system.dof_count()];
    system.prescribed.iter().for_each(|(&dof, &value)| start[dof] = value);
    let largest = |values: &[f64]| values.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
    let by_prescribed = largest(&multiply(&system.stiffness, &start));
    let mut displacements: Vec<Vec<f64>> = vec![start; cases.len()];
    // The second pass corrects the first one by its residual.
    for _ in 0..2 {
        let mut residual = Mat::zeros(system.dof_count(), cases.len());
        for (column, (load, moved)) in loads.iter().zip(&displacements).enumerate() {
            let forces = multiply(&system.stiffness, moved);
            for dof in 0..system.dof_count() {
                residual[(dof, column)] = load[dof] - forces[dof];
            }
        }
        factor.solve_in_place(residual.as_mut(), resources)?;
        for (column, moved) in displacements.iter_mut().enumerate() {
            moved.iter_mut().enumerate().for_each(|(dof, value)| *value += residual[(dof, column)]);
        }
    }
    loads
        .iter()
        .zip(&displacements)
        .map(|(load, moved)| {
            let forces = multiply(&system.stiffness, moved);
            let unknowns = (0..system.dof_count()).filter(|&dof| system.is_unknown(dof));
            let residual: Vec<f64> = unknowns.map(|dof| forces[dof] - load[dof]).collect();
            let (error, size) = (largest(&residual), largest(load).max(by_prescribed));
            if error.is_nan() || error > 1e-6 * size {
                return Err(mechanism(system, &factor.singular));
            }
            let all = system.expand(moved);
            let reaction = |&dof: &usize| (dof / 6, dof % 6, forces[dof] - load[dof]);
            Ok(StaticSolution {
                displacements: all.chunks_exact(6).map(|node| std::array::from_fn(|k| node[k])).collect(),
                reactions: system.prescribed.keys().map(reaction).collect(),
                strain_energy: 0.5 * dot(moved, &forces),
            })
        })
        .collect()
}
