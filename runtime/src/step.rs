//! One position in equilibrium: teeth that may touch are found, grids laid, the contact problem solved.

use crate::contact::approach::{Approach, PlacedProfile, closest_approach};
use crate::contact::assembly::{self, compliance};
use crate::contact::grid::{self, Cell, Grid, GridOptions, Width, assess, lay, pressures};
use crate::contact::pressure::{Peak, half_width, peak};
use crate::contact::problem::{Certificate, ContactError, ContactProblem};
use crate::contact::rigid_limit::rigid_limit;
use crate::contact::{ContactFrame, Placement, active_set};
use crate::error::EngineError;
use crate::holding;
use crate::profile::Profile;
use crate::structure::{Chart, Structure};
use crate::system::{Freedom, System, Teeth, pose};
use std::f64::consts::PI;
use std::sync::Arc;

/// A pair of tooth surfaces in (possible) contact at a position.
#[derive(Clone, Debug)]
pub struct Patch {
    /// Index of the surface pair in the scene.
    pub pair: usize,
    /// One of each body.
    pub teeth: [u32; 2],
    /// One of each body.
    pub surfaces: [u32; 2],
    /// Where it lies, and its common normal.
    pub frame: ContactFrame,
    /// Pieces of the grid, along the tangent; none where nothing is pressed.
    pub cells: Vec<Cell>,
    /// N per metre of face width, one a cell.
    pub forces: Vec<f64>,
    /// The loaded part lies on an edge or is cut off by one.
    pub at_edge: bool,
}

impl Patch {
    /// N per metre of face width.
    pub fn force(&self) -> f64 {
        self.forces.iter().sum()
    }

    /// Mean pressure on each cell, Pa.
    pub fn pressures(&self) -> Vec<f64> {
        pressures(&self.cells, &self.forces)
    }

    /// The largest pressure, by a parabola through the squares of its neighbours as Hertz's pressure is one; `None` where no
    /// cell is loaded.
    pub fn peak(&self) -> Option<Peak> {
        peak(&self.cells, &self.pressures())
    }

    /// Half of the width that carries load, m, by the zeros of such a parabola; `None` with fewer than five loaded cells.
    pub fn half_width(&self) -> Option<f64> {
        half_width(&self.cells, &self.pressures())
    }
}

/// A solved position. Keeps the contact problem and its active cells, from which sensitivities follow.
#[derive(Clone, Debug)]
pub struct StepResult {
    /// s
    pub time: f64,
    /// Pairs of teeth that touch or may.
    pub patches: Vec<Patch>,
    /// Deviation of every freedom from its prescribed motion, m or rad.
    pub motion: Vec<f64>,
    /// What was solved.
    pub problem: ContactProblem,
    /// Cells that carry load, by index in the problem.
    pub active: Vec<usize>,
    /// How well it is solved.
    pub certificate: Certificate,
    /// What should be known about the position, in sentences.
    pub warnings: Vec<String>,
}

/// A pair of teeth that could touch: what is known before anything is solved.
struct Candidate {
    teeth: Teeth,
    profiles: [Arc<dyn Profile>; 2],
    placements: [Placement; 2],
    approach: Approach,
    /// Growth of the gap by each freedom.
    arms: Vec<f64>,
}

/// A grid is first laid where the gap is below this part of the profile's length; gaps that the solution closes beyond
/// are found and added afterwards.
const SEARCH_DEPTH: f64 = 0.01;
/// How often the widths of grids may be mended at a position.
const REGRIDS: usize = 3;

impl System<'_> {
    /// Brings the scene into equilibrium at a time (s).
    ///
    /// What was solved before makes no difference, not in a bit.
    ///
    /// # Errors
    /// A load is not a number, nothing holds it, the problem is degenerate, or the interrupt's.
    pub fn solve(&self, time: f64) -> Result<StepResult, EngineError> {
        let load = self.load_at(time)?;
        let candidates = self.candidates(time)?;
        let mut chosen: Vec<bool> = candidates
            .iter()
            .map(|candidate| candidate.approach.gap < SEARCH_DEPTH * candidate.profiles[0].length())
            .collect();
        loop {
            let used: Vec<&Candidate> =
                candidates.iter().zip(&chosen).filter(|(_, used)| **used).map(|(c, _)| c).collect();
            let step = self.solve_candidates(time, &load, &used)?;
            // Teeth that were left out and that the solution would push into each other.
            let mut closed = false;
            for (candidate, used) in candidates.iter().zip(&mut chosen).filter(|(_, used)| !**used) {
                let rigid: f64 =
                    candidate.arms.iter().zip(&step.motion).map(|(arm, motion)| arm * motion).sum();
                if candidate.approach.gap + rigid < 0.0 {
                    *used = true;
                    closed = true;
                }
            }
            if !closed {
                return Ok(step);
            }
        }
    }

    fn solve_candidates(
        &self,
        time: f64,
        load: &[f64],
        candidates: &[&Candidate],
    ) -> Result<StepResult, EngineError> {
        // Bodies that are all held where they overlap press on each other without any load.
        let pressed =
            self.freedoms.is_empty() && candidates.iter().any(|candidate| candidate.approach.gap < 0.0);
        if !pressed && load.iter().all(|&load| load == 0.0) {
            return self.touch_without_load(time, load, candidates);
        }
        let mut widths = vec![None; candidates.len()];
        let largest_forces = self.largest_forces(load, candidates);
        let mut rounds = REGRIDS;
        let (grids, problem, solution) = loop {
            let grids: Vec<Grid> = candidates
                .iter()
                .zip(&largest_forces)
                .zip(&widths)
                .map(|((candidate, &force), &width)| self.grid(candidate, force, width))
                .collect();
            let problem = self.problem(load, candidates, &grids)?;
            let solution = active_set::solve_until(&problem, None, &self.interrupt)
                .map_err(|error| self.explain(&error))?;
            // Widths nobody asked for follow what the patches turn out to carry.
            let better = self.better_widths(candidates, &grids, &solution.forces);
            if rounds == 0 || better.iter().all(Option::is_none) {
                break (grids, problem, solution);
            }
            for (width, better) in widths.iter_mut().zip(better) {
                *width = better.or(*width);
            }
            rounds -= 1;
        };

        let mut warnings = Vec::new();
        let mut patches = Vec::with_capacity(grids.len());
        let mut first = 0;
        for (candidate, grid) in candidates.iter().zip(grids) {
            let last = first + grid.cells.len();
            let forces = solution.forces[first..last].to_vec();
            warnings.extend(self.judge(candidate, &grid, &forces));
            let at_edge = grid.at_edge(&forces);
            patches.push(Patch { cells: grid.cells, forces, at_edge, ..self.empty_patch(candidate) });
            first = last;
        }
        Ok(StepResult {
            time,
            patches,
            motion: solution.motion,
            problem,
            active: solution.active,
            certificate: solution.certificate,
            warnings,
        })
    }

    /// Where bodies come to rest as the load vanishes: rigid contact at the closest approaches.
    fn touch_without_load(
        &self,
        time: f64,
        load: &[f64],
        candidates: &[&Candidate],
    ) -> Result<StepResult, EngineError> {
        let gaps: Vec<f64> = candidates.iter().map(|candidate| candidate.approach.gap).collect();
        let arms: Vec<f64> = candidates.iter().flat_map(|candidate| candidate.arms.iter().copied()).collect();
        let motion = if self.freedoms.is_empty() {
            Vec::new()
        } else {
            let drive = holding::drive_direction(self.scene, &self.freedoms);
            let limit = rigid_limit(&gaps, &arms, &drive, &self.interrupt);
            limit.map_err(|error| self.explain(&error))?.motion
        };
        let patches = candidates.iter().map(|candidate| self.empty_patch(candidate)).collect();
        let problem = ContactProblem {
            compliance: Vec::new(),
            arms: Vec::new(),
            gaps: Vec::new(),
            stiffness: vec![0.0; self.freedoms.len() * self.freedoms.len()],
            load: load.to_vec(),
        };
        let (active, certificate, warnings) = (Vec::new(), Certificate::default(), Vec::new());
        Ok(StepResult { time, patches, motion, problem, active, certificate, warnings })
    }

    /// Every pair of teeth near enough to face each other, in a fixed order.
    fn candidates(&self, time: f64) -> Result<Vec<Candidate>, EngineError> {
        let mut found = Vec::new();
        for (index, pair) in self.scene.pairs.iter().enumerate() {
            let bodies = pair.bodies.map(|body| body.0);
            let placements = [self.placement(bodies[0], time)?, self.placement(bodies[1], time)?];
            let structures = [0, 1].map(|side| self.structures[bodies[side]].clone());
            let [Some(first), Some(second)] = structures else { continue };
            let structures = [first, second];
            let profiles = [0, 1].map(|side: usize| structures[side].profile(pair.surfaces[side]));
            let near = [0, 1].map(|side: usize| {
                let other = 1 - side;
                let reach = self.scene.bodies[bodies[other]].prototype.enclosing_radius();
                let body = (bodies[side], structures[side].as_ref(), profiles[side].as_ref());
                self.teeth_near(body, placements[side], placements[other].origin(), reach)
            });
            let angle = pose(self.scene, bodies[0], time)?.angle + self.scene.bodies[bodies[0]].phase;
            let nominal = pair.mesh.as_ref().filter(|_| !pair.grid.edges);
            let on_path = |tooth: u32| nominal.is_none_or(|mesh| mesh.on_path(tooth, angle));
            let touching = 0.5 * (profiles[0].length() + profiles[1].length());
            for (first, first_place, first_middle) in &near[0] {
                for (second, second_place, second_middle) in &near[1] {
                    if distance(*first_middle, *second_middle) > 1.5 * touching || !on_path(*first) {
                        continue;
                    }
                    let placements = [*first_place, *second_place];
                    let placed = |side: usize| PlacedProfile {
                        profile: profiles[side].as_ref(),
                        placement: placements[side],
                    };
                    let approach = closest_approach(placed(0), placed(1), pair.grid.edges)
                        .filter(|approach| self.faces(bodies, &placements, approach));
                    if let Some(approach) = approach {
                        let arms = self.arms(bodies, &approach.frame, time)?;
                        let teeth = (index, [*first, *second]);
                        found.push(Candidate {
                            teeth,
                            profiles: profiles.clone(),
                            placements,
                            approach,
                            arms,
                        });
                    }
                }
            }
        }
        Ok(found)
    }

    /// Whether surfaces that approach like this belong together. Overlapping by half a pitch of either body's teeth, one
    /// surface has passed the other: each belongs to the other's neighbour.
    fn faces(&self, bodies: [usize; 2], placements: &[Placement; 2], approach: &Approach) -> bool {
        let half_pitch = |side: usize| {
            let teeth = self.structures[bodies[side]].as_ref().map_or(1, |structure| structure.teeth());
            PI / f64::from(teeth) * distance(approach.frame.point, placements[side].origin())
        };
        approach.gap > -half_pitch(0).min(half_pitch(1))
    }

    /// Teeth of a body whose surface comes within `reach` of a point: index, placement, middle of the surface.
    fn teeth_near(
        &self,
        (body, structure, profile): (usize, &dyn Structure, &dyn Profile),
        placement: Placement,
        point: [f64; 2],
        reach: f64,
    ) -> Vec<(u32, Placement, [f64; 2])> {
        let middle = profile.at(0.5 * profile.length()).position;
        (0..structure.teeth())
            .map(|tooth| {
                let placement = placement.turned_first(self.tooth_angle(body, structure, tooth));
                (tooth, placement, placement.point(middle))
            })
            .filter(|(_, _, middle)| distance(*middle, point) < reach + profile.length())
            .collect()
    }

    /// Growth of the gap of a patch by each freedom, m per m or rad.
    fn arms(&self, bodies: [usize; 2], frame: &ContactFrame, time: f64) -> Result<Vec<f64>, EngineError> {
        let origins = [self.placement(bodies[0], time)?.origin(), self.placement(bodies[1], time)?.origin()];
        let arm = |freedom: &Freedom| {
            let sides = (0..2).filter(|&side| bodies[side] == freedom.body);
            sides
                .map(|side| match freedom.component {
                    0 => frame.translation_arm(side, [1.0, 0.0]),
                    1 => frame.translation_arm(side, [0.0, 1.0]),
                    _ => frame.rotation_arm(side, origins[side]),
                })
                .sum()
        };
        Ok(self.freedoms.iter().map(arm).collect())
    }

    /// For each patch whose width was left open and turns out to be unsuitable, a better one.
    fn better_widths(&self, candidates: &[&Candidate], grids: &[Grid], forces: &[f64]) -> Vec<Option<f64>> {
        let mut first = 0;
        candidates
            .iter()
            .zip(grids)
            .map(|(candidate, grid)| {
                let own = &forces[first..first + grid.cells.len()];
                first += grid.cells.len();
                let open = self.scene.pairs[candidate.teeth.0].grid.width.is_none();
                open.then(|| assess(grid, &pressures(&grid.cells, own)).recommended_width).flatten()
            })
            .collect()
    }

    /// Lays the grid of a patch: `width` (m) if it is given, else that of the model, else one that suits `force` (N/m).
    fn grid(&self, candidate: &Candidate, force: f64, width: Option<f64>) -> Grid {
        let pair = &self.scene.pairs[candidate.teeth.0];
        let placed = |side: usize| PlacedProfile {
            profile: candidate.profiles[side].as_ref(),
            placement: candidate.placements[side],
        };
        let width = match width.or(pair.grid.width) {
            Some(width) => Width::Total(width),
            None => {
                let contact_modulus = self.contact_modulus(pair.bodies.map(|body| body.0));
                Width::Hertz { force, contact_modulus }
            }
        };
        let options = GridOptions { half_count: pair.grid.half_cells, width, search_edges: pair.grid.edges };
        lay(placed(0), placed(1), &candidate.approach, &options)
    }

    /// For each patch the force (N/m) that would balance the whole load alone. A patch that no load acts on directly passes
    /// on what others carry.
    fn largest_forces(&self, load: &[f64], candidates: &[&Candidate]) -> Vec<f64> {
        let alone = |candidate: &&Candidate| {
            let balancing = candidate.arms.iter().zip(load).filter(|(arm, _)| **arm != 0.0);
            balancing.map(|(arm, load)| (load / arm).abs()).fold(0.0, f64::max)
        };
        let mut forces: Vec<f64> = candidates.iter().map(alone).collect();
        // Where there is no load, the overlaps tell the size of the forces: a surface gives by about q / E*.
        let overlap = |candidate: &&Candidate| {
            let bodies = self.scene.pairs[candidate.teeth.0].bodies.map(|body| body.0);
            (-candidate.approach.gap).max(0.0) * self.contact_modulus(bodies)
        };
        let largest = match forces.iter().copied().fold(0.0, f64::max) {
            0.0 => candidates.iter().map(overlap).fold(0.0, f64::max),
            loaded => loaded,
        };
        for force in forces.iter_mut().filter(|force| **force == 0.0) {
            *force = largest;
        }
        forces
    }

    fn contact_modulus(&self, bodies: [usize; 2]) -> f64 {
        match bodies.map(|body| self.structures[body].as_deref()) {
            [Some(first), Some(second)] => grid::contact_modulus(first, second),
            _ => f64::INFINITY,
        }
    }

    fn problem(
        &self,
        load: &[f64],
        candidates: &[&Candidate],
        grids: &[Grid],
    ) -> Result<ContactProblem, EngineError> {
        let mut patches = Vec::with_capacity(candidates.len());
        for (candidate, grid) in candidates.iter().zip(grids) {
            let pair = &self.scene.pairs[candidate.teeth.0];
            let side = |side: usize| {
                let body = pair.bodies[side].0;
                let structure = self.structures[body].as_deref()?;
                let chart = Chart { tooth: candidate.teeth.1[side], surface: pair.surfaces[side] };
                Some(assembly::Side { body, structure, chart })
            };
            if let (Some(first), Some(second)) = (side(0), side(1)) {
                patches.push(assembly::Patch { sides: [first, second], cells: &grid.cells });
            }
        }
        let cells = || {
            candidates.iter().zip(grids).flat_map(|(c, grid)| grid.cells.iter().map(move |cell| (c, cell)))
        };
        Ok(ContactProblem {
            compliance: compliance(&patches),
            arms: cells().flat_map(|(candidate, _)| candidate.arms.iter().copied()).collect(),
            gaps: cells().map(|(_, cell)| cell.gap).collect(),
            stiffness: vec![0.0; self.freedoms.len() * self.freedoms.len()],
            load: load.to_vec(),
        })
    }

    fn empty_patch(&self, candidate: &Candidate) -> Patch {
        let (pair, teeth) = candidate.teeth;
        let surfaces = self.scene.pairs[pair].surfaces;
        let (cells, forces) = (Vec::new(), Vec::new());
        Patch { pair, teeth, surfaces, frame: candidate.approach.frame, cells, forces, at_edge: false }
    }

    /// What the solution says against its grid (report figures 3.40 to 3.42).
    fn judge(&self, candidate: &Candidate, grid: &Grid, forces: &[f64]) -> Option<String> {
        let report = assess(grid, &pressures(&grid.cells, forces));
        let better = report.recommended_width?;
        let bodies =
            self.scene.pairs[candidate.teeth.0].bodies.map(|body| self.scene.bodies[body.0].name.as_str());
        let trouble = if report.under_resolved {
            "is too wide: only a few of its cells carry load"
        } else {
            "is too narrow: the pressure does not fall to zero inside it"
        };
        // To two digits, so that the positions of a cycle say the same.
        let better: f64 = format!("{:.1e}", better * 1e3).parse().unwrap_or(better * 1e3);
        Some(format!(
            "the contact grid of \"{}\" and \"{}\" {trouble}; `grid_width = {better} mm` suits it",
            bodies[0], bodies[1]
        ))
    }

    /// A failure of the contact solver in the words of the model.
    fn explain(&self, error: &ContactError) -> EngineError {
        holding::explain(self.scene, &self.freedoms, error)
    }
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}
