//! Cost of a whole analysis: structures, positions and error estimates.

use super::{Cost, Flanks, Rates, elastic_body, positions, sound_size, structure};
use crate::estimate::{Estimates, PerturbedSolve, perturbed_solves_of};
use crate::forced_response::position_count;
use crate::observables::positions_of_cycle;
use crate::scene::{Component, Scene};
use calyx_model::connection::{CondensedShaft, ElasticConnection};
use calyx_model::elastic_body::ElasticBodySize;
use calyx_model::fidelity::{Fidelity, StructureOptions};
use calyx_model::ids::{BodyId, PairId};
use calyx_model::observed::OutputRequest;
use calyx_model::pairs::{GearMesh, SurfacePair};
use calyx_model::plan::{ConnectionPlan, Plan};
use calyx_numerics::error::EngineError;
use calyx_structure::StructureSize;

/// Analysis whose cost is predicted.
#[derive(Clone, Copy)]
pub struct Task<'a> {
    /// Scene of the analysis.
    pub scene: &'a Scene,
    /// Outputs of the analysis.
    pub outputs: &'a [OutputRequest],
    /// Fidelity level of the bodies.
    pub fidelity: Fidelity,
    /// Discretization of the structures.
    pub structure: StructureOptions,
    /// Number of contact problems: positions or time steps.
    pub positions: usize,
    /// True for a transient analysis, whose steps are solved one after the other.
    pub in_time: bool,
    /// Errors to be estimated.
    pub estimates: Estimates,
    /// Highest frequency of component modes, Hz.
    pub highest_frequency: f64,
    /// Number of params with respect to which outputs are differentiated.
    pub differentiated: usize,
}

/// Costs of the parts of an analysis.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AnalysisCost {
    /// Cost of each structure, with the names of the bodies that share it.
    pub structures: Vec<(Vec<String>, Cost)>,
    /// Cost of all positions or time steps.
    pub positions: Cost,
    /// Number of positions or time steps.
    pub count: usize,
    /// Number of positions that load factors solve over mesh cycles of their own.
    pub of_load_factors: usize,
    /// Number of positions that a forced response solves.
    pub of_forced_response: usize,
    /// Cost of radiated sound, without its forced response, with the names of the bodies.
    pub sounds: Vec<(String, Cost)>,
    /// Cost of the error estimates, including structures of other meshes.
    pub errors: Cost,
    /// Cost of derivatives with respect to params that keep all structures.
    pub derivatives: Cost,
}

impl AnalysisCost {
    /// Returns the total time, s.
    pub fn time(&self) -> f64 {
        let structures = self.structures.iter().map(|(_, cost)| cost.time).sum::<f64>();
        let sounds = self.sounds.iter().map(|(_, cost)| cost.time).sum::<f64>();
        structures + self.positions.time + sounds + self.errors.time + self.derivatives.time
    }

    /// Returns the peak memory, bytes. Structures are condensed in parallel, and positions are
    /// solved with all structures in memory.
    pub fn memory(&self) -> f64 {
        let structures = self.structures.iter().map(|(_, cost)| cost.memory).sum();
        let sounds = self.sounds.iter().map(|(_, cost)| cost.memory).fold(0.0, f64::max);
        self.positions.memory.max(structures).max(sounds).max(self.errors.memory)
    }
}

/// Cost of the error estimates of a transient analysis relative to that of its steps: the motion is
/// repeated with steps of twice the length, and partly on other grids and meshes.
const OF_STEPS: f64 = 0.75;

/// Time of the derivatives with respect to a param relative to that of all positions: four
/// solutions in known states of contact, and more if a second width of differences is needed.
/// Measured: 1.7 to 3.8 for the torque of `spur_pair.cx` and `helical_pair.cx` at several levels.
const OF_DERIVATIVES: f64 = 3.0;

impl Task<'_> {
    /// Predicts the cost on a machine of given rates, without cached structures.
    ///
    /// # Errors
    /// Those of [`Plan::new`]: the scene cannot be modelled at this fidelity.
    pub fn cost(&self, rates: &Rates) -> Result<AnalysisCost, EngineError> {
        self.cost_with(&mut Meshes::default(), rates)
    }

    /// Predicts the cost like [`Task::cost`] and reuses counts of meshes.
    ///
    /// # Errors
    /// Those of [`Task::cost`].
    pub fn cost_with(&self, meshes: &mut Meshes, rates: &Rates) -> Result<AnalysisCost, EngineError> {
        let Task { scene, fidelity, structure: options, in_time, .. } = *self;
        let Part { structures, flanks, three_dimensional } =
            self.condensed(fidelity, options, meshes, rates)?;
        let solve =
            |fidelity: Fidelity, three_dimensional: bool, flanks: Flanks, coarse: bool, count: usize| {
                let cells = cells_in_contact(scene, fidelity, three_dimensional, coarse, in_time);
                let cost = positions(cells, flanks, count, !in_time, rates);
                let repeated = if is_displaced(scene) && !in_time { REPEATED } else { 1.0 };
                Cost { time: repeated * cost.time, ..cost }
            };
        let of_load_factors = self.positions_of_load_factors();
        let request = scene.forced_response.as_ref().filter(|_| !in_time);
        let of_forced_response = request.map_or(0, |request| position_count(scene, request));
        // Observed sound is computed for every system.
        let of_sound = if scene.sounds.is_empty() { 0 } else { of_forced_response };
        let own = self.positions + of_load_factors + of_forced_response;
        let own = solve(fidelity, three_dimensional, flanks, false, own);
        let of_params = OF_DERIVATIVES * self.differentiated as f64;
        let derivatives = match self.differentiated {
            0 => Cost::default(),
            _ => solve(fidelity, three_dimensional, flanks, false, self.positions),
        };
        let derivatives = Cost { time: of_params * derivatives.time, ..derivatives };
        let mut errors = Cost::default();
        let mut add = |cost: Cost| {
            errors.time += cost.time;
            errors.memory = errors.memory.max(cost.memory);
        };
        match self.estimates {
            Estimates::None => {}
            _ if in_time => add(Cost { time: OF_STEPS * own.time, memory: own.memory }),
            estimates => {
                let own = (fidelity, three_dimensional);
                let outputs = self.outputs.len();
                for perturbed_solve in perturbed_solves_of(estimates, own, options, self.positions, outputs) {
                    let Some((part, fidelity)) =
                        self.of_perturbed_solve(&perturbed_solve, three_dimensional, meshes, rates)
                    else {
                        continue;
                    };
                    let Part { structures, flanks, three_dimensional } = part;
                    let memory = structures.iter().map(|(_, cost)| cost.memory).sum();
                    let time = structures.iter().map(|(_, cost)| cost.time).sum();
                    // The structures of the analysis are available.
                    if perturbed_solve.condensed {
                        add(Cost { time, memory });
                    }
                    add(solve(
                        fidelity,
                        three_dimensional,
                        flanks,
                        perturbed_solve.coarse_grid,
                        perturbed_solve.positions + of_load_factors + of_sound,
                    ));
                }
            }
        }
        Ok(AnalysisCost {
            structures,
            positions: own,
            count: self.positions,
            of_load_factors,
            of_forced_response,
            sounds: match in_time {
                true => Vec::new(),
                false => sound_size(scene, fidelity, self.highest_frequency)
                    .into_iter()
                    .map(|size| (size.body.clone(), size.cost(rates)))
                    .collect(),
            },
            errors,
            derivatives,
        })
    }

    /// Returns the number of positions that the load factors of the outputs solve over mesh cycles.
    /// The positions of a quasi-static analysis are assumed to be in one cycle of the only mesh, or
    /// in parts of two cycles of each. Those of a transient analysis are not counted: their number
    /// depends on the time.
    fn positions_of_load_factors(&self) -> usize {
        if self.in_time {
            return 0;
        }
        let needed = |pair: &PairId| {
            let needs = |index: usize| {
                self.scene.observables.get(index).is_some_and(|one| one.cycle_of() == Some(*pair))
            };
            self.outputs.iter().any(|output| output.observes(needs))
        };
        let meshes: Vec<&GearMesh> = (0..self.scene.pairs.len())
            .filter(|&pair| needed(&PairId(pair)))
            .filter_map(|pair| self.scene.pairs[pair].mesh.as_ref())
            .collect();
        let cycles = if meshes.len() > 1 { 2 } else { 1 };
        meshes.into_iter().map(|mesh| cycles * positions_of_cycle(mesh)).sum()
    }

    /// Returns the structures of a perturbed solve and its fidelity: the first of those that
    /// support the scene. A perturbed solve that fails costs nothing.
    fn of_perturbed_solve(
        &self,
        perturbed_solve: &PerturbedSolve,
        three_dimensional: bool,
        meshes: &mut Meshes,
        rates: &Rates,
    ) -> Option<(Part, Fidelity)> {
        perturbed_solve.models.iter().find_map(|&(fidelity, structure)| {
            // Three-dimensional closed-form models are compared with three-dimensional finite
            // elements.
            if fidelity == Fidelity::Plane && self.fidelity != Fidelity::Plane && three_dimensional {
                return None;
            }
            Some((self.condensed(fidelity, structure, meshes, rates).ok()?, fidelity))
        })
    }

    /// Returns the structures of the scene at a fidelity.
    fn condensed(
        &self,
        fidelity: Fidelity,
        options: StructureOptions,
        meshes: &mut Meshes,
        rates: &Rates,
    ) -> Result<Part, EngineError> {
        let counted = meshes.0.iter().position(|mesh| (mesh.fidelity, mesh.options) == (fidelity, options));
        let counted = match counted {
            Some(counted) => counted,
            None => {
                let planned = if self.in_time { Plan::in_time } else { Plan::new };
                let plan = planned(self.scene, fidelity, options)?.for_outputs(self.scene, self.outputs)?;
                let (three_dimensional, sizes) = (plan.three_dimensional, sizes(self.scene, &plan));
                let elastic_bodies = elastic_bodies(self.scene, &plan);
                meshes.0.push(Mesh { fidelity, options, three_dimensional, sizes, elastic_bodies });
                meshes.0.len() - 1
            }
        };
        let Mesh { three_dimensional, sizes, elastic_bodies, .. } = &meshes.0[counted];
        let general = self.scene.pairs.iter().any(|pair| pair.mesh.as_ref().is_some_and(is_general));
        let flanks = match *three_dimensional {
            false => Flanks::Plane,
            true if general => Flanks::General,
            true if self.scene.pairs.iter().any(is_helical) => Flanks::Helical,
            true => Flanks::Straight,
        };
        let cost = |(names, size): &(Vec<String>, StructureSize)| {
            (names.clone(), structure(size, *three_dimensional, rates))
        };
        let of_body =
            |(name, size): &(String, ElasticBodySize)| (vec![name.clone()], elastic_body(size, rates));
        Ok(Part {
            structures: sizes.iter().map(cost).chain(elastic_bodies.iter().map(of_body)).collect(),
            flanks,
            three_dimensional: *three_dimensional,
        })
    }
}

/// Sizes of the structures of a scene by fidelity and mesh. Each is counted once, because this
/// requires meshing. They do not depend on contact grids.
#[derive(Default)]
pub struct Meshes(Vec<Mesh>);

struct Mesh {
    fidelity: Fidelity,
    options: StructureOptions,
    three_dimensional: bool,
    sizes: Vec<(Vec<String>, StructureSize)>,
    elastic_bodies: Vec<(String, ElasticBodySize)>,
}

struct Part {
    structures: Vec<(Vec<String>, Cost)>,
    flanks: Flanks,
    three_dimensional: bool,
}

/// Returns each structure of a plan with its size and the names of the bodies that share it.
fn sizes(scene: &Scene, plan: &Plan) -> Vec<(Vec<String>, StructureSize)> {
    let numbers = plan.structures(scene);
    let count = numbers.iter().flatten().max().map_or(0, |last| last + 1);
    let of = |number: usize| {
        let bodies = || (0..scene.bodies.len()).filter(|&body| numbers.get(body) == Some(&Some(number)));
        let size = |body: usize| scene.bodies[body].prototype.size(plan.fidelity, &plan.bodies[body].options);
        // Among bodies that share a structure, one with stresses determines the size.
        let largest = bodies().filter_map(size).max_by_key(|size| size.stresses)?;
        Some((bodies().map(|body| scene.bodies[body].name.clone()).collect(), largest))
    };
    (0..count).filter_map(of).collect()
}

/// Returns the elastic bodies and solid shafts that a plan condenses, with their sizes.
fn elastic_bodies(scene: &Scene, plan: &Plan) -> Vec<(String, ElasticBodySize)> {
    let condensed = scene.connections.iter().zip(&plan.connections);
    let condensed = condensed.filter(|(_, planned)| !planned.left_out && plan.fidelity != Fidelity::Rigid);
    let size = |(connection, planned): (&ElasticConnection, &ConnectionPlan)| {
        let size = match connection.solid_shaft(plan.fidelity) {
            Some(CondensedShaft { shaft, stations, .. }) => shaft.solid_size(stations, planned.shaft_mesh),
            None => connection.body.as_ref()?.0.size(),
        };
        Some((connection.name.clone(), size?))
    };
    condensed.filter_map(size).collect()
}

/// Returns the number of contact cells of a position or time step, on the grids of the scene or
/// with half their cells in every direction. A step has grids where teeth are near each other: on
/// one side of teeth with backlash.
fn cells_in_contact(
    scene: &Scene,
    fidelity: Fidelity,
    three_dimensional: bool,
    coarse: bool,
    in_time: bool,
) -> usize {
    let halved = |count: usize| if coarse { count.div_ceil(2) } else { count };
    let cells = |half: usize| 2 * halved(half) + 1;
    let of = |pair: &SurfacePair| {
        let grid = &pair.grid;
        let cells = match three_dimensional {
            _ if fidelity == Fidelity::Rigid => 0,
            _ if in_time && pair.front.is_some() => 0,
            false => cells(grid.plane_half_cells()),
            true => cells(grid.solid_half_cells()) * cells(grid.half_slices),
        };
        let mesh = pair.mesh.as_ref().or_else(|| scene.pairs.get(pair.front?.0)?.mesh.as_ref());
        cells * mesh.map_or(1, pairs_of_teeth)
    };
    scene.pairs.iter().map(of).sum()
}

/// Factor on the time of positions whose gears move on their supports: contact grids are laid out
/// again where the load has moved the gears. Measured: 1.4 to 3.
const REPEATED: f64 = 1.9;

/// Returns whether gears in mesh can move other than by rotating about their axes.
fn is_displaced(scene: &Scene) -> bool {
    let moves = |body: &BodyId| {
        let free = scene.bodies[body.0].free;
        free.iter().enumerate().any(|(component, free)| *free && component != Component::ThetaZ as usize)
    };
    scene.pairs.iter().any(|pair| pair.bodies.iter().any(moves))
}

/// Returns whether the teeth of a mesh are helical.
fn is_helical(pair: &SurfacePair) -> bool {
    pair.mesh.as_ref().is_some_and(|mesh| mesh.twist != 0.0)
}

/// Returns whether the axes of a mesh are not parallel.
fn is_general(mesh: &GearMesh) -> bool {
    mesh.first_contact.is_some()
}

/// Returns the largest number of tooth pairs in contact: the contact ratio rounded up; two on
/// general axes, where it depends on the load.
fn pairs_of_teeth(mesh: &GearMesh) -> usize {
    if is_general(mesh) {
        return 2;
    }
    let [pitch, path] = [mesh.roll, mesh.path].map(|[from, to]| (to - from).abs());
    if pitch > 0.0 { (path / pitch).ceil().clamp(1.0, f64::from(mesh.teeth[0])) as usize } else { 1 }
}
