//! Contact problem at one position of the bodies: creates grids, corrects their sizes and solves
//! for the cell forces.

use super::contact_geometry::{Approach, Candidate, ContactGeometry, LoadedCells, Resolution};
use super::contact_layout::{LaidOutContact, MOST_SHIFT, SEARCH_DEPTH, Solver};
use super::contact_state::{GridState, PatchCells};
use super::grid_sizes::GridSizes;
use super::nonlinear_bearings::{NonlinearBearings, NonlinearIteration};
use super::relinearization::ContactReference;
use super::{ContactPatch, StepResult};
use crate::restraint_check::{self, spins_freely};
use crate::system::System;
use calyx_contact::assembly::{Entries, FormerCompliance};
use calyx_contact::friction::{ActiveSet, solve_with_friction};
use calyx_contact::problem::{ContactError, ContactProblem, Solution};
use calyx_contact::unloaded_equilibrium::unloaded_equilibrium;
use calyx_model::dof::Dof;
use calyx_model::ids::BodyId;
use calyx_numerics::error::EngineError;
use calyx_numerics::parallel::try_map;
use faer::Mat;
use std::sync::OnceLock;

/// Gap, relative to the length of the profile, below which rigid surfaces touch: conjugate teeth
/// all do, within rounding.
const TOUCHING: f64 = 1e-7;
/// A patch whose arm on a DOF is below this fraction of the largest leaves the load on it to
/// others.
const WORTH_LOADING: f64 = 0.1;
/// Largest number of matrices of all cells by all cells that exist at a time: the compliance, its
/// blocks or its copy for the next correction of grids, its static part if modes are eliminated,
/// and the factor of the active set.
const MATRICES: u64 = 4;

/// Compliance matrix of the grids before their correction.
pub(super) struct KnownCompliance {
    matrix: Vec<f64>,
    /// Number of cells of each patch.
    sizes: Vec<usize>,
    /// Whether each patch keeps its grid.
    unchanged: Vec<bool>,
}

/// Coupling of modal coordinates, which are eliminated, to the cells of a contact problem.
pub(super) struct Modal {
    /// Derivatives of the gaps, cells by coordinates.
    arms: Mat<f64>,
    /// Compliance and arms of the static problem.
    statics: Option<[Vec<f64>; 2]>,
}

impl<S: ContactGeometry> Solver<'_, S> {
    pub(super) fn solve_candidates(
        &self,
        time: f64,
        load: &[f64],
        candidates: &[&Candidate<S::Site>],
        solved: &mut Vec<GridState>,
    ) -> Result<LaidOutContact, EngineError> {
        if let Some(laid) = self.touch_without_load(time, load, candidates)? {
            return Ok(laid);
        }
        let largest_forces = self.largest_forces(self.under.sizing.unwrap_or(load), candidates);
        let space = self.space;
        let mut sizes = self.first_sizes(candidates);
        // Several threads build grids unless all are busy with other positions.
        let build_grids = |patches: &[usize], sizes: &GridSizes<S::Size>| {
            let build_grid = |&patch: &usize| {
                let (size, resolution) = (sizes.sizes[patch], sizes.resolutions[patch]);
                space.build_grid(candidates[patch], largest_forces[patch], size, resolution)
            };
            try_map(patches, build_grid)
        };
        let all: Vec<usize> = (0..candidates.len()).collect();
        let mut known: Option<KnownCompliance> = None;
        let initial = |bearings: &NonlinearBearings<'_>| bearings.initial(self.under.start);
        let mut iteration = self.under.nonlinear.map(initial).transpose()?;
        let whole = build_grids(&all, &sizes)?;
        if self.under.one_cell_per_slice {
            return self.solved_by_slices(time, load, candidates, (whole, iteration), &largest_forces);
        }
        let mut reduced = self.reduced_grids(load, candidates, whole, iteration.as_ref())?;
        // Active set of the grids without the rotation of their normals.
        let mut active: Option<Vec<usize>> = None;
        let (drags, problem, modal, solution) = loop {
            let grids = &reduced.grids[..];
            let patches = self.patch_cells(candidates, grids);
            let given = self.given_state(solved.len(), &patches);
            let (problem, modal, of_cells) = self.problem(load, candidates, grids, (known.take(), given))?;
            let (drags, mut works) = self.friction(time, candidates, grids);
            works.resize(problem.arms.len(), 0.0);
            let deflected = active.is_some();
            let former = active.take().or(reduced.estimate.take());
            // Corrected grids start with the bearings of the former grids.
            let laid = (candidates, grids);
            let (problem, solution) = match given {
                Some(given) => {
                    let set = ActiveSet::Given(&given.active);
                    self.solve_problem(problem, &works, set, laid, &mut iteration)?
                }
                None => {
                    let guess = former.unwrap_or_else(|| self.guess(load, candidates, &problem, grids));
                    self.solve_problem(problem, &works, ActiveSet::Estimate(&guess), laid, &mut iteration)?
                }
            };
            if self.extend(candidates, &mut reduced, &solution) {
                continue;
            }
            let grids = &reduced.grids[..];
            solved.push(GridState { patches, active: solution.active.clone() });
            if deflected {
                break (drags, problem, modal, solution);
            }
            // Sizes that are not prescribed follow the forces of the patches.
            let better = self.corrected_grid_sizes(candidates, (grids, &sizes), &solution);
            let changed = sizes.correct(&better);
            let sizes_of_patches = grids.iter().map(|grid| self.space.count(grid)).collect();
            let unchanged = all.iter().map(|patch| !changed.contains(patch)).collect();
            let was_whole = reduced.is_whole();
            if changed.is_empty() {
                let laid: Vec<_> = candidates.iter().copied().zip(grids).collect();
                let Some(rotated) = self.space.with_deflected_normals(&laid, &solution)? else {
                    break (drags, problem, modal, solution);
                };
                (reduced.grids, active) = (rotated, Some(solution.active));
            } else {
                let mut whole = reduced.into_whole();
                let rebuilt = build_grids(&changed, &sizes)?;
                changed.into_iter().zip(rebuilt).for_each(|(patch, grid)| whole[patch] = grid);
                reduced = self.reduced_grids(load, candidates, whole, iteration.as_ref())?;
            }
            // A given state has some of the entries only, and ranges that are estimated again may
            // have other cells.
            let keeps_cells = active.is_some() || was_whole && reduced.is_whole();
            if given.is_none() && keeps_cells {
                let matrix = of_cells.unwrap_or(problem.compliance);
                known = Some(KnownCompliance { matrix, sizes: sizes_of_patches, unchanged });
            }
        };
        let mut laid = self.laid_out(
            time,
            candidates,
            reduced.grids,
            (drags, problem, modal, solution),
            &largest_forces,
        );
        if let (Some(bearings), Some(iteration)) = (self.under.nonlinear, &iteration) {
            laid.step.raceways = bearings.raceways(iteration);
            laid.step.bearings = bearings.states(iteration);
        }
        Ok(laid)
    }

    /// Returns the sizes of grids before their correction.
    fn first_sizes(&self, candidates: &[&Candidate<S::Site>]) -> GridSizes<S::Size> {
        let first_resolution = |candidate: &&Candidate<S::Site>| {
            let halved = !self.under.in_time && self.space.sizes_at_half_resolution(candidate);
            if halved { Resolution::Half } else { Resolution::Full }
        };
        let resolutions = candidates.iter().map(first_resolution).collect();
        GridSizes::new(resolutions, self.space.may_grow())
    }

    /// Assembles the solved position from the friction vectors and the solution on its grids.
    pub(super) fn laid_out(
        &self,
        time: f64,
        candidates: &[&Candidate<S::Site>],
        grids: Vec<S::Grid>,
        (drags, mut problem, modal, solution): (Vec<Vec<[f64; 3]>>, ContactProblem, Modal, Solution),
        largest_forces: &[f64],
    ) -> LaidOutContact {
        let warnings = self.grid_warnings(candidates, &grids, &solution.forces, largest_forces);
        let mut references = Vec::new();
        let mut patches = Vec::with_capacity(grids.len());
        let mut left = &solution.forces[..];
        for ((candidate, grid), friction_vectors) in candidates.iter().zip(grids).zip(drags) {
            let (forces, others) = left.split_at(self.space.count(&grid));
            left = others;
            if forces.iter().any(|&force| force > 0.0) {
                references.push(ContactReference {
                    pair: candidate.teeth.0,
                    action: self.space.action(candidate, &grid),
                    reach: 0.5 * self.space.width(&grid),
                });
            }
            patches.push(ContactPatch {
                friction_vectors,
                ..self.space.patch(candidate, Some((grid, forces.to_vec())))
            });
        }
        let stops = left.to_vec();
        let Modal { arms, statics } = modal;
        let modal =
            self.under.elastic.map(|elastic| elastic.recover(&arms, &solution.forces, &solution.motion));
        // Sensitivities refer to the stiffness of the bodies, without the inertia terms of a step.
        if let Some([compliance, arms]) = statics {
            (problem.compliance, problem.arms) = (compliance, arms);
        }
        let step = StepResult {
            time,
            patches,
            modal: modal.unwrap_or_default(),
            velocity: Vec::new(),
            other_loads: Vec::new(),
            vibrations: OnceLock::new(),
            motion: solution.motion,
            start: Vec::new(),
            problem,
            active: solution.active,
            grids: Vec::new(),
            estimates: 0,
            stops,
            raceways: Vec::new(),
            bearings: Vec::new(),
            certificate: solution.certificate,
            warnings,
        };
        LaidOutContact { step, references }
    }

    /// Solves a contact problem, with nonlinear bearings in equilibrium.
    pub(super) fn solve_problem(
        &self,
        problem: ContactProblem,
        works: &[f64],
        active: ActiveSet<'_>,
        (candidates, grids): (&[&Candidate<S::Site>], &[S::Grid]),
        iteration: &mut Option<NonlinearIteration>,
    ) -> Result<(ContactProblem, Solution), EngineError> {
        let solve = |problem, guess: &[usize]| {
            let active = match active {
                ActiveSet::Given(given) => ActiveSet::Given(given),
                ActiveSet::Estimate(_) => ActiveSet::Estimate(guess),
            };
            let solved = solve_with_friction(problem, works, active, &self.system.interrupt);
            solved.map_err(|error| self.explain_on(candidates, grids, &error))
        };
        let (ActiveSet::Given(first) | ActiveSet::Estimate(first)) = active;
        match (self.under.nonlinear, iteration) {
            (Some(bearings), Some(iteration)) => {
                let laid: Vec<_> = candidates.iter().copied().zip(grids).collect();
                let growths = bearings.growths(|body| self.space.by_raceway(body, &laid))?;
                let under = (&growths[..], self.under.start);
                bearings.equilibrium(iteration, problem, under, first.to_vec(), solve)
            }
            _ => solve(problem, first),
        }
    }

    /// Returns the patches of grids.
    fn patch_cells(&self, candidates: &[&Candidate<S::Site>], grids: &[S::Grid]) -> Vec<PatchCells> {
        let cells = |(candidate, grid): (&&Candidate<S::Site>, &S::Grid)| PatchCells {
            pair: candidate.teeth.0,
            teeth: candidate.teeth.1,
            cells: self.space.count(grid),
        };
        candidates.iter().zip(grids).map(cells).collect()
    }

    /// Returns the state of contact that is given for the grids of an index, if their patches are
    /// the same.
    fn given_state(&self, index: usize, patches: &[PatchCells]) -> Option<&GridState> {
        self.under.state?.grids.get(index).filter(|given| given.patches == patches)
    }

    /// Rigid-body limit as the load that springs do not carry vanishes: rigid contact at the
    /// closest approaches. `None` if bodies press on each other even then, like teeth of a mesh
    /// without backlash on both flanks, and if springs do not carry the load.
    fn touch_without_load(
        &self,
        time: f64,
        load: &[f64],
        candidates: &[&Candidate<S::Site>],
    ) -> Result<Option<LaidOutContact>, EngineError> {
        // Fully constrained or sprung bodies may overlap and press on each other without any load.
        // In a time step inertia balances these forces.
        if self.under.in_time {
            return Ok(None);
        }
        let rest = unloaded_equilibrium(&self.under.springs.stiffness, load);
        if !rest.balanced {
            return Ok(None);
        }
        let (gaps, arms) = self.rigid_contacts(candidates.iter().copied());
        let System { scene, left_out, dofs, .. } = self.system;
        let rotor = gaps.is_empty() && spins_freely(scene, left_out, dofs, &rest.free);
        let motion = match rest.rigid_limit(&gaps, &arms, &self.limit_direction(), &self.system.interrupt) {
            _ if rotor => rest.motion.clone(),
            Ok(Some(limit)) => limit.motion,
            Ok(None) if self.system.rigid => return Err(self.explain(&ContactError::Jammed)),
            Ok(None) => return Ok(None),
            Err(ContactError::Jammed) if self.both_sides() && !self.system.rigid => return Ok(None),
            Err(error) => return Err(self.explain(&error)),
        };
        // The patches of rigid bodies are those that touch.
        let touches = |candidate: &&&Candidate<S::Site>| {
            let touching = |approach: &Approach| approach.gap_growth(&motion) < TOUCHING * candidate.length;
            !self.system.rigid || candidate.approaches().any(touching)
        };
        let touching = candidates.iter().filter(touches);
        let patches = touching.map(|candidate| self.space.patch(candidate, None)).collect();
        let references = candidates.iter().map(|candidate| ContactReference {
            pair: candidate.teeth.0,
            action: self.space.approaching(candidate),
            // There is no grid, but this search depth.
            reach: SEARCH_DEPTH * candidate.length / MOST_SHIFT,
        });
        let problem = ContactProblem {
            compliance: Vec::new(),
            arms: Vec::new(),
            gaps: Vec::new(),
            stiffness: self.under.springs.stiffness.clone(),
            load: load.to_vec(),
        };
        let certificate = problem.certify(&[], &motion);
        let (active, stops, warnings) = (Vec::new(), Vec::new(), Vec::new());
        let start = Vec::new();
        let references = references.collect();
        let (modal, velocity, other_loads) = (Vec::new(), Vec::new(), Vec::new());
        let step = StepResult {
            time,
            patches,
            motion,
            modal,
            velocity,
            other_loads,
            vibrations: OnceLock::new(),
            start,
            problem,
            active,
            grids: Vec::new(),
            estimates: 0,
            stops,
            raceways: Vec::new(),
            bearings: Vec::new(),
            certificate,
            warnings,
        };
        Ok(Some(LaidOutContact { step, references }))
    }

    /// Returns a better size for each patch whose size is not prescribed and is unsuitable.
    fn corrected_grid_sizes(
        &self,
        candidates: &[&Candidate<S::Site>],
        (grids, sizes): (&[S::Grid], &GridSizes<S::Size>),
        solution: &Solution,
    ) -> Vec<Option<S::Size>> {
        let wide = self.under.in_time || sizes.only_grow();
        let mut end = 0;
        let laid = candidates.iter().zip(grids).zip(&sizes.sizes);
        laid.map(|((candidate, grid), &size)| {
            let own = end..end + self.space.count(grid);
            end = own.end;
            let loaded = LoadedCells {
                forces: &solution.forces[own.clone()],
                gaps: &solution.gaps[own],
                motion: &solution.motion,
            };
            self.space.corrected_grid_size(candidate, grid, size, &loaded, wide)
        })
        .collect()
    }

    /// Returns for each patch the force that would balance the whole load alone, or its share if
    /// several meshes carry one load, as planets do. A patch without a direct load passes on the
    /// loads of others.
    fn largest_forces(&self, load: &[f64], candidates: &[&Candidate<S::Site>]) -> Vec<f64> {
        let load = &self.with_torques_of_shafts(load);
        let largest_arm = |dof: usize| {
            candidates.iter().map(|candidate| candidate.nearest.arms[dof].abs()).fold(0.0, f64::max)
        };
        let worth: Vec<f64> = (0..load.len()).map(|dof| WORTH_LOADING * largest_arm(dof)).collect();
        // Meshes, with both flanks of their teeth, that act on a DOF.
        let mesh = |candidate: &&Candidate<S::Site>| {
            let pair = candidate.teeth.0;
            self.system.scene.pairs[pair].front.map_or(pair, |front| front.0)
        };
        let meshes: Vec<f64> = (0..load.len())
            .map(|dof| {
                let bears = |candidate: &&&Candidate<S::Site>| {
                    let arm = candidate.nearest.arms[dof];
                    arm != 0.0 && arm.abs() >= worth[dof]
                };
                let mut bearing: Vec<usize> = candidates.iter().filter(bears).map(mesh).collect();
                bearing.sort_unstable();
                bearing.dedup();
                bearing.len() as f64
            })
            .collect();
        let alone = |candidate: &&Candidate<S::Site>| {
            let all = candidate.nearest.arms.iter().zip(load).zip(worth.iter().zip(&meshes));
            let balancing = all.filter(|((arm, _), (worth, _))| **arm != 0.0 && arm.abs() >= **worth);
            balancing.map(|((arm, load), (_, meshes))| (load / arm).abs() / meshes).fold(0.0, f64::max)
        };
        let mut forces: Vec<f64> = candidates.iter().map(alone).collect();
        // Loads that act on other bodies, such as the carrier of a planet, reach the teeth through
        // bearings; without load, the overlaps determine the size of the forces.
        let pressed = |candidate: &&Candidate<S::Site>| {
            self.space.force_of_overlap(candidate, (-candidate.nearest.gap).max(0.0))
        };
        let largest = match forces.iter().copied().fold(0.0, f64::max) {
            0.0 => candidates.iter().map(pressed).fold(self.transmitted(load, candidates), f64::max),
            loaded => loaded,
        };
        for force in forces.iter_mut().filter(|force| **force == 0.0) {
            *force = largest;
        }
        forces
    }

    /// Returns the force on teeth that the largest load causes, if it acts at their smallest base
    /// radius.
    fn transmitted(&self, load: &[f64], candidates: &[&Candidate<S::Site>]) -> f64 {
        let meshes = candidates.iter().filter_map(|candidate| {
            let (pair, _) = candidate.teeth;
            self.system.scene.pairs[pair].mesh.as_ref()
        });
        let radius = meshes.flat_map(|mesh| mesh.base_radii).fold(f64::INFINITY, f64::min);
        let force = |(dof, load): (&Dof, &f64)| load.abs() / if dof.component < 3 { 1.0 } else { radius };
        self.system.dofs.iter().zip(load).map(force).fold(0.0, f64::max)
    }

    /// Returns the load with the torque on every elastic connection acting on each of its bodies: a
    /// shaft transmits a torque from its coupling to its gears.
    fn with_torques_of_shafts(&self, load: &[f64]) -> Vec<f64> {
        const THETA_Z: usize = 5;
        let (dofs, mut whole) = (&self.system.dofs, load.to_vec());
        for &index in &self.system.connections {
            let bodies: Vec<BodyId> = self.system.scene.connections[index].bodies().collect();
            let about = |dof: &Dof| dof.component == THETA_Z && bodies.contains(&BodyId(dof.body));
            let own = || dofs.iter().enumerate().filter(|(_, dof)| about(dof)).map(|(at, _)| at);
            let torque: f64 = own().map(|at| load[at]).sum();
            own().for_each(|at| whole[at] = torque);
        }
        whole
    }

    /// Creates the contact problem. Also returns the compliance matrix of the cells alone, unless
    /// it is that of the problem.
    pub(super) fn problem(
        &self,
        load: &[f64],
        candidates: &[&Candidate<S::Site>],
        grids: &[S::Grid],
        (known, given): (Option<KnownCompliance>, Option<&GridState>),
    ) -> Result<(ContactProblem, Modal, Option<Vec<f64>>), EngineError> {
        let laid: Vec<(&Candidate<S::Site>, &S::Grid)> = candidates.iter().copied().zip(grids).collect();
        let count: usize = grids.iter().map(|grid| self.space.count(grid)).sum();
        let _room =
            self.system.interrupt.reserve_memory(MATRICES * (count * count * size_of::<f64>()) as u64)?;
        let wanted = given.map(|given| given.wanted(|patch| self.space.observed_cells(&grids[patch])));
        let compliance = match (&wanted, known) {
            (Some(wanted), _) => self.space.compliance(&laid, Entries::Between(wanted))?,
            (None, Some(known)) if !known.unchanged.contains(&false) => known.matrix,
            (None, Some(KnownCompliance { matrix, sizes, unchanged })) => {
                let former = FormerCompliance { matrix: &matrix, sizes: &sizes, unchanged: &unchanged };
                self.space.compliance(&laid, Entries::Changed(former))?
            }
            (None, None) => self.space.compliance(&laid, Entries::All)?,
        };
        let across = self.space.by_spline_teeth(&laid)?;
        let springs = &self.under.springs;
        // Elastic raceways add theirs, see [`NonlinearBearings::equilibrium`].
        let is_changed =
            springs.has_equations() || self.under.elastic.is_some() || self.under.nonlinear.is_some();
        let of_cells = is_changed.then(|| compliance.clone());
        let cells = ContactProblem {
            compliance,
            arms: laid.iter().flat_map(|(candidate, grid)| self.space.arms(candidate, grid)).collect(),
            gaps: grids.iter().flat_map(|grid| self.space.gaps(grid)).collect(),
            stiffness: springs.stiffness.clone(),
            load: load.to_vec(),
        };
        let mut problem = springs.behind(cells, across.as_ref(), &self.system.interrupt)?;
        let Some(elastic) = self.under.elastic else {
            return Ok((problem, Modal { arms: Mat::zeros(0, 0), statics: None }, of_cells));
        };
        let arms = self.space.modal_arms(&laid, elastic.modes);
        let statics = (arms.nrows() > 0).then(|| [problem.compliance.clone(), problem.arms.clone()]);
        let modal = Modal { arms, statics };
        elastic.eliminate(&mut problem, &modal.arms);
        Ok((problem, modal, of_cells))
    }

    /// Returns the initial active set. A spline tooth carries load on one flank at most; starting
    /// with both would start with neither. In equilibrium the initial set contains the contacts
    /// that stop rigid bodies; in a time step it follows from the step.
    fn guess(
        &self,
        load: &[f64],
        candidates: &[&Candidate<S::Site>],
        problem: &ContactProblem,
        grids: &[S::Grid],
    ) -> Vec<usize> {
        let flanks = self.system.flanks();
        if flanks == 0 {
            return self.space.guess(problem, grids);
        }
        let first = problem.cells() - flanks;
        let mut guess: Vec<usize> = (0..first).collect();
        if self.under.sizing.is_none() {
            let (gaps, arms) = self.rigid_contacts(candidates.iter().copied());
            let rest = unloaded_equilibrium(&self.under.springs.stiffness, load);
            if let Ok(Some(limit)) = rest.rigid_limit(&gaps, &arms, load, &self.system.interrupt) {
                let of_flanks = limit.touching.iter().filter_map(|at| at.checked_sub(gaps.len() - flanks));
                guess.extend(of_flanks.map(|flank| first + flank));
            }
        }
        guess
    }

    /// Computes the friction of each patch's cells, see [`ContactPatch::friction_vectors`], and its
    /// generalized forces on the DOFs, see [`solve_with_friction`].
    pub(super) fn friction(
        &self,
        time: f64,
        candidates: &[&Candidate<S::Site>],
        grids: &[S::Grid],
    ) -> (Vec<Vec<[f64; 3]>>, Vec<f64>) {
        let scene = self.system.scene;
        let (mut drags, mut works) = (Vec::with_capacity(grids.len()), Vec::new());
        for (candidate, grid) in candidates.iter().zip(grids) {
            let pair = &scene.pairs[candidate.teeth.0];
            let action = self.space.action(candidate, grid);
            let friction_vectors = action.friction_vectors(self.system, pair, time, self.under.start);
            works.extend(action.works(self.system, pair, time, &friction_vectors, self.under.start));
            drags.push(friction_vectors);
        }
        (drags, works)
    }

    /// Converts an error of the contact solver on these grids into terms of the model.
    fn explain_on(
        &self,
        candidates: &[&Candidate<S::Site>],
        grids: &[S::Grid],
        error: &ContactError,
    ) -> EngineError {
        let scene = self.system.scene;
        let in_a_pair = |dof: usize| {
            let body = self.system.dofs.get(dof).map(|dof| BodyId(dof.body));
            body.is_some_and(|body| scene.pairs.iter().any(|pair| pair.bodies.contains(&body)))
        };
        match error {
            ContactError::Infeasible(motion) if candidates.is_empty() && in_a_pair(motion.dof) => {
                let error = self.explain(error);
                let message =
                    format!("{}, and no surface has a nearest point on the other of its pair", error.message);
                let help = "bring surfaces to face each other; of flat ones that are parallel, which touch everywhere or nowhere, make one round";
                EngineError { message, help: help.into(), ..error }
            }
            ContactError::DependentCells { .. } => {
                let whole = candidates.iter().zip(grids).find(|(_, grid)| self.space.is_cut_off(grid));
                let Some((candidate, grid)) = whole else { return self.explain(error) };
                let [first, second] =
                    scene.pairs[candidate.teeth.0].bodies.map(|body| scene.bodies[body.0].name.as_str());
                let width = 1e3 * self.space.width(grid);
                EngineError::new(
                    "E0716",
                    format!(
                        "under this load \"{first}\" and \"{second}\" touch over all of the {width:.3} mm that their surfaces face each \
                         other: that is no small patch, and pushes on its cells cannot be told apart"
                    ),
                    "check the unit of the load and the dimensions of the bodies; the contact area must be small compared with them",
                )
            }
            error => self.explain(error),
        }
    }

    /// Converts an error of the contact solver into terms of the model, without regard to grids.
    pub(super) fn explain(&self, error: &ContactError) -> EngineError {
        restraint_check::explain(self.system.scene, &self.system.dofs, error)
    }
}
