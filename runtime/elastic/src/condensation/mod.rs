//! Condensation of a body onto its attachment nodes: static condensation and component mode
//! synthesis.
//!
//! Attachment components are independent degrees of freedom, or combinations of them (reference
//! nodes of weighted averages). The former are retained; the latter are constrained by Lagrange
//! multipliers, so that an average over thousands of nodes causes no dense coupling. See
//! `docs/theory/elastic-bodies.md`.

mod component_modes;
mod interface;

pub use component_modes::{Synthesis, component_modes, guyan};

use crate::assembly::System;
use crate::check::{determinate_support, mechanism_within, parts};
use crate::error::ElasticError;
use crate::model::{Component, NodalLoad};
use crate::resources::Resources;
use calyx_fe::dissection::Dissection;
use calyx_fe::elimination::{eliminate, memory};
use calyx_fe::solve::SolveError;
use calyx_fe::sparse::SparseVector;
use faer::Mat;
use interface::Interface;

/// Body condensed onto its attachment nodes.
#[derive(Clone, Debug)]
pub struct CondensedBody {
    /// Attachment components: index of the node, and component in its displacement axes. They are
    /// the first unknowns.
    pub components: Vec<(usize, Component)>,
    /// Squared angular frequencies of the component modes, (rad/s)^2; modal coordinates are the
    /// last unknowns. Values above the requested highest frequency belong to pseudo-modes.
    pub eigenvalues: Vec<f64>,
    /// Stiffness.
    pub stiffness: Mat<f64>,
    /// Mass; `None` after static condensation.
    pub mass: Option<Mat<f64>>,
    /// Loads on the unknowns, one case per column.
    pub loads: Mat<f64>,
    /// Displacements conjugate to the load cases by unit load cases, with fixed attachments; empty
    /// after a reduction of the mass.
    pub between_loads: Mat<f64>,
    /// Displacements of all independent degrees of freedom by unit unknowns, one per column; `None`
    /// after static condensation.
    pub shapes: Option<Mat<f64>>,
}

impl CondensedBody {
    /// Returns the number of unknowns.
    pub fn unknown_count(&self) -> usize {
        self.components.len() + self.eigenvalues.len()
    }

    /// Returns the displacements of all nodes, in their displacement axes, from the values of the
    /// unknowns; `None` after static condensation.
    pub fn displacements(&self, system: &System<'_>, unknowns: &[f64]) -> Option<Vec<[f64; 6]>> {
        let shapes = self.shapes.as_ref()?;
        let mut independent = vec![0.0; shapes.nrows()];
        for (column, value) in unknowns.iter().enumerate() {
            independent
                .iter_mut()
                .zip(shapes.col(column).iter())
                .for_each(|(sum, shape)| *sum += value * shape);
        }
        let all = system.expand(&independent);
        Some(all.chunks_exact(6).map(|node| std::array::from_fn(|k| node[k])).collect())
    }
}

/// Attachment components with their place in the equations.
pub(crate) struct Attached {
    pub components: Vec<(usize, Component)>,
    /// Retained degrees of freedom.
    pub direct: Vec<usize>,
    /// Forms of the other components.
    pub forms: Vec<SparseVector>,
    /// Index of each component among the retained ones and then the forms.
    pub places: Vec<usize>,
    /// Degrees of freedom that support the body statically determinately while the retained ones
    /// are fixed.
    pub helpers: Vec<usize>,
}

impl Attached {
    pub fn new(system: &System<'_>, nodes: &[usize]) -> Result<Self, ElasticError> {
        let mut seen = vec![false; system.model.nodes.len()];
        let (mut components, mut direct, mut forms) = (Vec::new(), Vec::new(), Vec::new());
        let mut kinds = Vec::new();
        for &node in nodes {
            let known = system.model.nodes.get(node);
            let label = known.map(|node| node.label).filter(|_| !std::mem::replace(&mut seen[node], true));
            let label = label.ok_or_else(|| {
                ElasticError::model("an attachment node does not exist or is repeated", "name each node once")
            })?;
            let before = components.len();
            for component in 0..6 {
                let dof = 6 * node + component;
                if system.prescribed.contains_key(&dof) {
                    return Err(ElasticError::model(
                        format!("component {} of the attachment node {label} is fixed", component + 1),
                        "release the node: what it is attached to supports it",
                    ));
                }
                if let Some(form) = system.expansion.of(dof) {
                    let moving = |entry: &&(usize, f64)| system.is_unknown(entry.0);
                    let entries: Vec<(usize, f64)> = form.entries.iter().filter(moving).copied().collect();
                    if !entries.is_empty() {
                        kinds.push(Err(forms.len()));
                        forms.push(SparseVector { entries });
                        components.push((node, component));
                    }
                } else if system.is_unknown(dof) {
                    kinds.push(Ok(direct.len()));
                    direct.push(dof);
                    components.push((node, component));
                }
            }
            if components.len() == before {
                return Err(ElasticError::model(
                    format!("the attachment node {label} has no stiffness"),
                    "connect it to elements, rigidly or by a weighted average",
                ));
            }
        }
        let places = kinds.into_iter().map(|kind| kind.unwrap_or_else(|form| direct.len() + form)).collect();
        let helpers = helpers(system, &direct);
        Ok(Self { components, direct, forms, places, helpers })
    }

    /// Returns a matrix over the retained unknowns and forms in the order of the components.
    fn ordered(&self, matrix: &Mat<f64>) -> Mat<f64> {
        let count = self.places.len();
        Mat::from_fn(count, count, |row, column| matrix[(self.places[row], self.places[column])])
    }
}

/// Returns a statically determinate support of the motions that remain free while some degrees of
/// freedom are fixed.
fn helpers(system: &System<'_>, fixed: &[usize]) -> Vec<usize> {
    let mut remaining = Vec::new();
    for part in parts(system) {
        let mut motions = part.free_motions;
        // Removes the combinations that move a fixed degree of freedom, largest first.
        while !motions.is_empty() {
            let size = |dof: usize| motions.iter().map(|motion| motion[dof].powi(2)).sum::<f64>();
            let of_part = motions.iter().flatten().fold(0.0_f64, |largest, value| largest.max(value.abs()));
            let found = fixed.iter().map(|&dof| (dof, size(dof)));
            let Some((dof, moved)) = found.reduce(|best, next| if next.1 > best.1 { next } else { best })
            else {
                break;
            };
            if moved.sqrt() <= 1e-9 * of_part {
                break;
            }
            let pivot = (0..motions.len())
                .reduce(|best, k| if motions[k][dof].abs() > motions[best][dof].abs() { k } else { best })
                .unwrap_or(0);
            let leader = motions.swap_remove(pivot);
            for motion in &mut motions {
                let factor = motion[dof] / leader[dof];
                motion.iter_mut().zip(&leader).for_each(|(value, other)| *value -= factor * other);
            }
        }
        remaining.extend(motions);
    }
    determinate_support(system, &remaining)
}

/// Condenses the stiffness and load cases onto attachment nodes. The result is exact for statics.
///
/// # Errors
/// An attachment node is fixed or without stiffness, the body has a mechanism, memory is
/// insufficient, or the caller ends the computation.
pub fn static_condensation(
    system: &System<'_>,
    attachments: &[usize],
    cases: &[Vec<NodalLoad>],
    resources: &Resources,
) -> Result<CondensedBody, ElasticError> {
    let attached = Attached::new(system, attachments)?;
    let mut loads = attached.forms.clone();
    for case in cases {
        let full = system.loads(case)?;
        let by_prescribed = prescribed_forces(system);
        let entries = full.into_iter().zip(by_prescribed).map(|(load, force)| load - force).enumerate();
        let entries = entries.filter(|&(dof, value)| value != 0.0 && system.is_unknown(dof));
        loads.push(SparseVector { entries: entries.collect() });
    }
    let mut kept: Vec<usize> = Vec::new();
    for dof in attached.direct.iter().chain(&attached.helpers) {
        if !kept.contains(&(dof / 6)) {
            kept.push(dof / 6);
        }
    }
    let constrained = system.constrained();
    let checkpoint = || resources.check();
    let dissection =
        Dissection::new_until(&system.stiffness, &system.positions, &constrained, &kept, &checkpoint)?;
    let unknowns = dissection.order.iter().flatten().count();
    let bytes = memory(&dissection, &loads, &[]);
    let _room = resources.reserve("the condensation", bytes, unknowns, 4.0 / 3.0)?;
    let complement =
        eliminate(&system.stiffness, &dissection, &loads, &[], || Ok::<(), Ended>(checkpoint()?));
    let square = complement.map_err(|ended| match ended {
        Ended::Solve(SolveError::Singular) => singular(system, &constrained, &attached, resources),
        Ended::Solve(error) => {
            ElasticError::Memory { message: error.to_string(), help: "coarsen the mesh".into() }
        }
        Ended::Caller(error) => error,
    })?;
    let square = square.square;

    let eliminated = unknowns - (square.nrows() - loads.len());
    let retained = square.nrows() - loads.len();
    let mut order: Vec<Option<usize>> = vec![None; retained];
    for (place, &dof) in attached.direct.iter().enumerate() {
        if let Some(slot) = dissection.order[dof] {
            order[slot - eliminated] = Some(place);
        }
    }
    let mut slots = vec![0; attached.direct.len()];
    order.iter().enumerate().for_each(|(slot, place)| {
        if let Some(place) = place {
            slots[*place] = slot;
        }
    });
    // Retained unknowns that are no attachments become helpers.
    slots.extend((0..retained).filter(|&slot| order[slot].is_none()));
    let entry = |row: usize, column: usize| square[(row.max(column), row.min(column))];
    let forms = attached.forms.len();
    let interface = Interface {
        attached: attached.direct.len(),
        stiffness: Mat::from_fn(retained, retained, |row, column| entry(slots[row], slots[column])),
        forms: Mat::from_fn(forms, retained, |form, column| entry(retained + form, slots[column])),
        compliance: Mat::from_fn(forms, forms, |row, column| -entry(retained + row, retained + column)),
        loads: Mat::from_fn(retained, cases.len(), |row, case| entry(retained + forms + case, slots[row])),
        form_loads: Mat::from_fn(forms, cases.len(), |form, case| {
            -entry(retained + form, retained + forms + case)
        }),
        between_loads: Mat::from_fn(cases.len(), cases.len(), |row, column| {
            -entry(retained + forms + row, retained + forms + column)
        }),
    };
    let relaxed = interface.relax()?;
    let count = attached.components.len();
    Ok(CondensedBody {
        stiffness: attached.ordered(&relaxed.stiffness),
        mass: None,
        loads: Mat::from_fn(count, cases.len(), |row, case| relaxed.loads[(attached.places[row], case)]),
        between_loads: relaxed.between_loads,
        eigenvalues: Vec::new(),
        shapes: None,
        components: attached.components,
    })
}

/// Returns the forces by the prescribed displacements.
fn prescribed_forces(system: &System<'_>) -> Vec<f64> {
    let mut moved = vec![0.0; system.dof_count()];
    system.prescribed.iter().for_each(|(&dof, &value)| moved[dof] = value);
    crate::assembly::multiply(&system.stiffness, &moved)
}

/// Returns the error of a body that is singular although its attachments are fixed.
fn singular(
    system: &System<'_>,
    constrained: &[usize],
    attached: &Attached,
    resources: &Resources,
) -> ElasticError {
    let fixed: Vec<usize> =
        constrained.iter().chain(&attached.direct).chain(&attached.helpers).copied().collect();
    let pencil = crate::factor::Pencil::stiffness(&system.stiffness);
    match crate::factor::Factor::new(pencil, &system.positions, &fixed, resources) {
        Ok(factor) => mechanism_within(system, &factor.singular),
        Err(error) => error,
    }
}

/// Reasons why an elimination ends.
enum Ended {
    Solve(SolveError),
    Caller(ElasticError),
}

impl From<SolveError> for Ended {
    fn from(error: SolveError) -> Self {
        Self::Solve(error)
    }
}

impl From<ElasticError> for Ended {
    fn from(error: ElasticError) -> Self {
        Self::Caller(error)
    }
}
