//! The cost of a whole analysis: structures, positions, and the estimates of their errors.

use super::{Cost, Rates, positions, structure};
use crate::estimate::{Estimates, Sibling, siblings_of};
use crate::scene::Scene;
use calyx_model::fidelity::{Fidelity, StructureOptions};
use calyx_model::observed::OutputRequest;
use calyx_model::pairs::{GearMesh, SurfacePair};
use calyx_model::plan::Plan;
use calyx_numerics::error::EngineError;
use calyx_structure::StructureSize;

/// An analysis whose cost is predicted.
#[derive(Clone, Copy)]
pub struct Task<'a> {
    /// What is analysed.
    pub scene: &'a Scene,
    /// What its results are.
    pub outputs: &'a [OutputRequest],
    /// How bodies are modelled.
    pub fidelity: Fidelity,
    /// How finely.
    pub structure: StructureOptions,
    /// Contact problems: positions, or steps in time.
    pub positions: usize,
    /// Whether these follow a motion in time, one after the other.
    pub in_time: bool,
    /// Which errors are estimated.
    pub estimates: Estimates,
}

/// The costs of the parts of an analysis.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AnalysisCost {
    /// Each structure, with the names of the bodies that share it.
    pub structures: Vec<(Vec<String>, Cost)>,
    /// All positions, or steps in time.
    pub positions: Cost,
    /// How many there are.
    pub count: usize,
    /// What the estimates of errors take, structures of other meshes included.
    pub errors: Cost,
}

impl AnalysisCost {
    /// s
    pub fn time(&self) -> f64 {
        let structures = self.structures.iter().map(|(_, cost)| cost.time).sum::<f64>();
        structures + self.positions.time + self.errors.time
    }

    /// The most memory taken at once, bytes: structures are condensed side by side, and positions
    /// solved beside all that is kept.
    pub fn memory(&self) -> f64 {
        let structures = self.structures.iter().map(|(_, cost)| cost.memory).sum();
        self.positions.memory.max(structures).max(self.errors.memory)
    }
}

/// Part of the cost of the steps of a motion in time that their estimates take: the motion is
/// followed once more in steps twice as long, and on other grids and meshes for a part of it.
const OF_STEPS: f64 = 0.75;

impl Task<'_> {
    /// The cost on a machine of known rates, structures condensed anew.
    ///
    /// # Errors
    /// As [`Plan::new`]: the scene cannot be modelled so.
    pub fn cost(&self, rates: &Rates) -> Result<AnalysisCost, EngineError> {
        self.cost_with(&mut Meshes::default(), rates)
    }

    /// As [`Task::cost`], for a scene some of whose meshes have been counted already.
    ///
    /// # Errors
    /// As [`Task::cost`].
    pub fn cost_with(&self, meshes: &mut Meshes, rates: &Rates) -> Result<AnalysisCost, EngineError> {
        let Task { scene, fidelity, structure: options, in_time, .. } = *self;
        let Part { structures, twisted, in_space } = self.condensed(fidelity, options, meshes, rates)?;
        let solve = |fidelity: Fidelity, in_space: bool, twisted: bool, coarse: bool, count: usize| {
            positions(cells_in_contact(scene, fidelity, in_space, coarse), twisted, count, !in_time, rates)
        };
        let own = solve(fidelity, in_space, twisted, false, self.positions);
        let mut errors = Cost::default();
        let mut add = |cost: Cost| {
            errors.time += cost.time;
            errors.memory = errors.memory.max(cost.memory);
        };
        match self.estimates {
            Estimates::None => {}
            _ if in_time => add(Cost { time: OF_STEPS * own.time, memory: own.memory }),
            estimates => {
                for sibling in siblings_of(estimates, fidelity, options, self.positions, self.outputs.len()) {
                    let Some((part, fidelity)) = self.of_sibling(&sibling, in_space, meshes, rates) else {
                        continue;
                    };
                    let Part { structures, twisted, in_space } = part;
                    let memory = structures.iter().map(|(_, cost)| cost.memory).sum();
                    let time = structures.iter().map(|(_, cost)| cost.time).sum();
                    // The structures of the analysis are there already.
                    if sibling.condensed {
                        add(Cost { time, memory });
                    }
                    add(solve(fidelity, in_space, twisted, sibling.coarse_grid, sibling.positions));
                }
            }
        }
        Ok(AnalysisCost { structures, positions: own, count: self.positions, errors })
    }

    /// Structures of a sibling, and its fidelity: the first of those that the scene can be modelled
    /// with. A sibling that cannot be solved costs nothing.
    fn of_sibling(
        &self,
        sibling: &Sibling,
        in_space: bool,
        meshes: &mut Meshes,
        rates: &Rates,
    ) -> Option<(Part, Fidelity)> {
        sibling.models.iter().find_map(|&(fidelity, structure)| {
            // Closed forms in space are compared with elements in space.
            if fidelity == Fidelity::Plane && self.fidelity != Fidelity::Plane && in_space {
                return None;
            }
            Some((self.condensed(fidelity, structure, meshes, rates).ok()?, fidelity))
        })
    }

    /// The structures of the scene at a fidelity.
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
                let plan = planned(self.scene, fidelity, options)?.yielding(self.scene, self.outputs)?;
                let (in_space, sizes) = (plan.in_space, sizes(self.scene, &plan));
                meshes.0.push(Mesh { fidelity, options, in_space, sizes });
                meshes.0.len() - 1
            }
        };
        let Mesh { in_space, sizes, .. } = &meshes.0[counted];
        let twisted = *in_space && sizes.iter().any(|(_, size)| !size.mirrored);
        let cost =
            |(names, size): &(Vec<String>, StructureSize)| (names.clone(), structure(size, *in_space, rates));
        Ok(Part { structures: sizes.iter().map(cost).collect(), twisted, in_space: *in_space })
    }
}

/// Sizes of the structures of a scene by fidelity and mesh, which are counted once: they take the
/// making of a mesh. They do not depend on contact grids.
#[derive(Default)]
pub struct Meshes(Vec<Mesh>);

struct Mesh {
    fidelity: Fidelity,
    options: StructureOptions,
    in_space: bool,
    sizes: Vec<(Vec<String>, StructureSize)>,
}

struct Part {
    structures: Vec<(Vec<String>, Cost)>,
    twisted: bool,
    in_space: bool,
}

/// Each structure of a plan with the names of the bodies that share it, and its size.
fn sizes(scene: &Scene, plan: &Plan) -> Vec<(Vec<String>, StructureSize)> {
    let numbers = plan.structures(scene);
    let count = numbers.iter().flatten().max().map_or(0, |last| last + 1);
    let of = |number: usize| {
        let bodies = || (0..scene.bodies.len()).filter(|&body| numbers.get(body) == Some(&Some(number)));
        let size = |body: usize| scene.bodies[body].prototype.size(plan.fidelity, &plan.bodies[body].options);
        // Of bodies that share one, the one with stresses decides.
        let largest = bodies().filter_map(size).max_by_key(|size| size.stresses)?;
        Some((bodies().map(|body| scene.bodies[body].name.clone()).collect(), largest))
    };
    (0..count).filter_map(of).collect()
}

/// Contact pressures of a position, on grids of the scene or of half their cells in every direction.
fn cells_in_contact(scene: &Scene, fidelity: Fidelity, in_space: bool, coarse: bool) -> usize {
    let halved = |count: usize| if coarse { count.div_ceil(2) } else { count };
    let cells = |half: usize| 2 * halved(half) + 1;
    let of = |pair: &SurfacePair| {
        let grid = &pair.grid;
        let cells = match in_space {
            _ if fidelity == Fidelity::Rigid => 0,
            false => cells(grid.half_cells_in_plane()),
            true => cells(grid.half_cells_in_space()) * cells(grid.half_slices),
        };
        let mesh = pair.mesh.as_ref().or_else(|| scene.pairs.get(pair.front?.0)?.mesh.as_ref());
        cells * mesh.map_or(1, pairs_of_teeth)
    };
    scene.pairs.iter().map(of).sum()
}

/// The most pairs of teeth in contact at a time: the next whole number above the contact ratio.
fn pairs_of_teeth(mesh: &GearMesh) -> usize {
    let [pitch, path] = [mesh.roll, mesh.path].map(|[from, to]| (to - from).abs());
    if pitch > 0.0 { (path / pitch).ceil().clamp(1.0, f64::from(mesh.teeth[0])) as usize } else { 1 }
}
