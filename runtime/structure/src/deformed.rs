//! Displacements and stresses of whole meshes, on demand, for VTU files.
//!
//! A condensed structure stores nothing about the interior of a body. To display it, the sector is
//! meshed and assembled again, and its interior is factorized and kept ([`ring`]); a position then
//! costs a back-substitution for each sector. The ring has the same flexibility as in the
//! structure, so the result is that of the contact problem. Forces of cells become point forces on
//! the mesh, which is coarse in comparison. Stresses are accurate a few nodes away from a contact,
//! in the fillets and in the rim, but not under the contact.

mod elements;
mod ring;

use super::bore::{BoreMeans, RequestedMeans};
use super::condense::{Assembled, match_cuts};
use super::elastic::chain;
use super::solid::SegmentLoad;
use super::{Chart, ModifiedSurface, RevolvedWeb, RingSource, StructureError, SurfaceLoad};
use crate::mesh_cells::Outline;
use calyx_fe::solid::{ABSENT, FaceSet, SolidModel};
use calyx_fe::{EdgeChain, PlaneModel, SparseVector};
use calyx_numerics::interrupt::{Interrupt, MemoryReservation};
use calyx_numerics::stress::{NodalStresses, Stress, rotated};
use calyx_numerics::vec3::dot;
use elements::Elements;
use ring::{ConstrainedSector, SolvedRing};
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::sync::Arc;

/// Largest distance from a loaded sector for output of stresses in three dimensions: sectors further
/// away would make up most of a file.
const SHOWN_SOLID: u32 = 6;
/// Largest number of nodes that the sectors with stresses of a body are output with. If they have
/// more, the corners of their elements are output: all nodes would take megabytes a position. All
/// sectors of a body have the same points, so that neighbours meet at every one of them.
const MOST_NODES: usize = 50_000;
/// Displacements of a sector, relative to the largest one of a cut, that are visible.
const VISIBLE: f64 = 1e-3;
/// Number of sectors without stresses that are computed at a time.
const AT_A_TIME: usize = 16;

/// Finite-element mesh of a body, or the reason why there is none.
pub enum VisualizationMesh {
    /// The mesh.
    Mesh(Arc<MeshedBody>),
    /// Reason in words that follow the body's name.
    Unavailable(&'static str),
}

/// Forces on a body.
#[derive(Clone, Copy, Debug)]
pub enum BodyLoads<'a> {
    /// Loads on a plane body.
    Plane {
        /// Forces on its surfaces.
        surfaces: &'a [SurfaceLoad],
        /// Forces on the displacements of its bore, N/m, see
        /// [`crate::Structure::interface_compliance`]; empty for a body without such.
        interface: &'a [f64],
    },
    /// Loads on a three-dimensional body.
    Solid {
        /// Forces on its surfaces.
        segments: &'a [SegmentLoad],
        /// Forces on the displacements of its bore, N; empty for a body without such.
        interface: &'a [f64],
    },
}

/// Deformed sector of a loaded body, in the body's frame.
#[derive(Clone, Debug)]
pub struct DeformedSector {
    /// Index of the tooth, counted counter-clockwise from 0.
    pub tooth: u32,
    /// Undeformed positions, m; z is 0 in a plane model.
    pub points: Vec<[f64; 3]>,
    /// Corners of each cell as indices of points: four of a quadrilateral, counter-clockwise, or
    /// eight of a hexahedron, in VTK order.
    pub cells: Vec<Vec<usize>>,
    /// Index of the finite element of each cell.
    pub elements: Vec<usize>,
    /// Elastic displacements of the points, m.
    pub displacements: Vec<[f64; 3]>,
    /// Stresses at the points: xx, yy, zz, yz, zx, xy, Pa.
    pub stresses: Vec<Stress>,
    /// Estimated errors of the stresses ([`NodalStresses::errors`]), Pa.
    pub stress_errors: Vec<f64>,
}

/// Sector of a loaded body that is too far from the loads for output of stresses, in the body's
/// frame.
#[derive(Clone, Debug, PartialEq)]
pub struct DisplacedSector {
    /// Index of the tooth, counted counter-clockwise from 0.
    pub tooth: u32,
    /// Elastic displacements, m, of the same points as in a [`DeformedSector`].
    pub displacements: Vec<[f64; 3]>,
}

/// Body with a mesh that can be evaluated. See the module documentation.
pub struct MeshedBody {
    mesh: Arc<Mesh>,
    modified_surfaces: Option<Vec<ModifiedSurface>>,
}

/// Mesh of a sector, and the ring.
struct Mesh {
    ring: SolvedRing,
    nodes: Vec<[f64; 3]>,
    elements: Elements,
    /// Points and cells that are output.
    outline: Outline,
    loadable: Loadable,
}

/// Loadable surfaces.
enum Loadable {
    Plane(Box<PlaneModel>, Vec<EdgeChain>),
    Solid(Box<SolidModel>, Vec<FaceSet>),
}

impl MeshedBody {
    /// Builds a ring of plane sectors, as
    /// [`ElasticStructure::ring`](super::ElasticStructure::ring). `surfaces` names the loaded
    /// chains.
    ///
    /// # Errors
    /// Chains are missing, the cuts do not conform, the ring is not supported, memory is
    /// insufficient, or the computation is interrupted.
    pub fn ring(
        model: PlaneModel,
        ring: &RingSource<'_>,
        surfaces: &[String],
        interrupt: &Interrupt,
    ) -> Result<Self, StructureError> {
        let nodes = |name: &str| Ok::<_, StructureError>(model.mesh.chain_nodes(chain(&model, name)?));
        let (first, last, bore) = (nodes(ring.cuts[0])?, nodes(ring.cuts[1])?, nodes(ring.bore)?);
        let sectors = ring.sectors.max(1);
        let (constrained, means) = match RequestedMeans::for_ring(ring.support) {
            None => (bore, None),
            Some(wanted) => {
                let means = BoreMeans::plane(&model, chain(&model, ring.bore)?, wanted, interrupt)?;
                (Vec::new(), Some(means.ok_or(StructureError::NoArea)?))
            }
        };
        let assembled = Assembled::plane(&model);
        let cuts = match_cuts(&assembled.positions, &first, &last, &constrained, TAU / f64::from(sectors))
            .ok_or_else(|| StructureError::CutsDiffer { cuts: ring.cuts.map(String::from) })?;
        let nodes = assembled.positions.clone();
        let sector = ConstrainedSector { sectors, cuts, constrained: assembled.dofs_of(&constrained), means };
        let ring =
            SolvedRing::new(assembled, sector, |error| ring.support.with_bore_context(error), interrupt)?;
        let chains = surfaces.iter().map(|name| chain(&model, name).cloned());
        let chains = chains.collect::<Result<_, StructureError>>()?;
        Ok(Self::of(ring, nodes, Elements::plane(&model), Loadable::Plane(Box::new(model), chains)))
    }

    /// Builds a ring of three-dimensional sectors, as
    /// [`ElasticSolid::ring`](super::solid::ElasticSolid::ring) or, on a web, `ring_on_web`.
    /// `surfaces` names the sets of loaded faces.
    ///
    /// # Errors
    /// As for [`Self::ring`].
    pub fn solid_ring(
        model: SolidModel,
        ring: &RingSource<'_>,
        web: Option<&RevolvedWeb>,
        surfaces: &[String],
        interrupt: &Interrupt,
    ) -> Result<Self, StructureError> {
        let faces = |name: &str| {
            let set = model.mesh.face_set(name);
            set.ok_or_else(|| StructureError::NoFaces { faces: name.into() })
        };
        let sectors = ring.sectors.max(1);
        let bore = faces(ring.bore)?;
        let means = match (web, RequestedMeans::for_ring(ring.support)) {
            (Some(web), _) => Some(BoreMeans::on_web(&model, bore, web, sectors, interrupt)?),
            (None, Some(wanted)) => Some(BoreMeans::solid(&model, bore, wanted, interrupt)?),
            (None, None) => None,
        };
        let means = means.map(|means| means.ok_or(StructureError::NoArea)).transpose()?;
        let mut constrained = if means.is_none() { model.mesh.nodes_on(bore) } else { Vec::new() };
        constrained.extend(model.mesh.node_sets.get(ABSENT).into_iter().flatten());
        constrained.sort_unstable();
        constrained.dedup();
        let [first, last] = [faces(ring.cuts[0])?, faces(ring.cuts[1])?].map(|set| model.mesh.nodes_on(set));
        let cuts = match_cuts(&model.mesh.nodes, &first, &last, &constrained, TAU / f64::from(sectors))
            .ok_or_else(|| StructureError::CutsDiffer { cuts: ring.cuts.map(String::from) })?;
        let assembled =
            Assembled::solid(&model.mesh, interrupt, || model.stiffness_until(|| interrupt.check()))?;
        let nodes = assembled.positions.clone();
        let sector = ConstrainedSector { sectors, cuts, constrained: assembled.dofs_of(&constrained), means };
        let solved =
            SolvedRing::new(assembled, sector, |error| ring.support.with_bore_context(error), interrupt)?;
        let sets = surfaces.iter().map(|name| faces(name).cloned()).collect::<Result<_, StructureError>>()?;
        Ok(Self::of(solved, nodes, Elements::solid(&model), Loadable::Solid(Box::new(model), sets)))
    }

    fn of(ring: SolvedRing, nodes: Vec<[f64; 3]>, elements: Elements, loadable: Loadable) -> Self {
        let sectors = match loadable {
            Loadable::Plane(..) => ring.sectors,
            Loadable::Solid(..) => ring.sectors.min(2 * SHOWN_SOLID + 1),
        };
        let [all, corners] = elements.outlines();
        let outline = if all.nodes.len() * sectors as usize <= MOST_NODES { all } else { corners };
        Self { mesh: Arc::new(Mesh { ring, nodes, elements, outline, loadable }), modified_surfaces: None }
    }

    /// Returns the same body with surfaces that differ slightly from its own, one for each;
    /// coordinates of loads refer to these.
    #[must_use]
    pub fn with_modified_surfaces(&self, surfaces: Vec<ModifiedSurface>) -> Self {
        Self { mesh: self.mesh.clone(), modified_surfaces: Some(surfaces) }
    }

    /// Returns the sectors of the body under loads with their stresses, in order: all of them in a
    /// plane model, those around loaded ones in three dimensions.
    ///
    /// # Errors
    /// Memory is insufficient, or the computation is interrupted.
    pub fn deformed(
        &self,
        loads: BodyLoads<'_>,
        interrupt: &Interrupt,
    ) -> Result<Vec<DeformedSector>, StructureError> {
        let (by_tooth, on_bore) = self.forces(loads);
        let shown: Vec<u32> = self.with_stresses(&by_tooth).0;
        let _room = self.reserve(shown.len(), by_tooth.len(), interrupt)?;
        let solution = self.mesh.ring.under(&by_tooth, on_bore, interrupt)?;
        let moved = self.mesh.ring.displacements(&solution, &shown)?;
        let sector = |(&tooth, column): (&u32, faer::ColRef<'_, f64>)| {
            interrupt.check().map_err(StructureError::Interrupted)?;
            let moved: Vec<f64> = column.iter().copied().collect();
            Ok(self.mesh.sector(tooth, &moved))
        };
        shown.iter().zip(moved.col_iter()).map(sector).collect()
    }

    /// Returns the other sectors of the body that move visibly, in order.
    ///
    /// # Errors
    /// As for [`Self::deformed`].
    pub fn displaced(
        &self,
        loads: BodyLoads<'_>,
        interrupt: &Interrupt,
    ) -> Result<Vec<DisplacedSector>, StructureError> {
        let (by_tooth, on_bore) = self.forces(loads);
        let others = self.with_stresses(&by_tooth).1;
        let _room = self.reserve(AT_A_TIME.min(others.len()), by_tooth.len(), interrupt)?;
        let solution = self.mesh.ring.under(&by_tooth, on_bore, interrupt)?;
        let mut all = Vec::new();
        for some in others.chunks(AT_A_TIME) {
            interrupt.check().map_err(StructureError::Interrupted)?;
            let moved = self.mesh.ring.displacements(&solution, some)?;
            let moving = some.iter().zip(moved.col_iter());
            let moving = moving.filter(|(_, column)| column.norm_max() > VISIBLE * solution.largest);
            all.extend(moving.map(|(&tooth, column)| {
                let moved: Vec<f64> = column.iter().copied().collect();
                DisplacedSector { tooth, displacements: self.mesh.displacements(tooth, &moved) }
            }));
        }
        Ok(all)
    }

    /// Divides the sectors into those that are output with stresses, and the others.
    fn with_stresses(&self, by_tooth: &[(u32, Vec<f64>)]) -> (Vec<u32>, Vec<u32>) {
        let sectors = self.mesh.ring.sectors;
        let apart = |one: u32, other: u32| {
            let ahead = (one + sectors - other) % sectors;
            ahead.min(sectors - ahead)
        };
        let near = |tooth: u32| by_tooth.iter().any(|(loaded, _)| apart(tooth, *loaded) <= SHOWN_SOLID);
        let everywhere = matches!(self.mesh.loadable, Loadable::Plane(..)) || by_tooth.is_empty();
        (0..sectors).partition(|&tooth| everywhere || near(tooth))
    }

    /// Reserves the memory for the displacements of sectors under loads.
    fn reserve(
        &self,
        sectors: usize,
        loads: usize,
        interrupt: &Interrupt,
    ) -> Result<MemoryReservation, StructureError> {
        let columns = 4 * sectors + 2 * loads;
        let bytes = columns * self.mesh.nodes.len() * 3 * size_of::<f64>();
        interrupt.reserve_memory(bytes as u64).map_err(StructureError::Interrupted)
    }

    /// Returns full vectors of forces by tooth, ascending, and forces on the bore.
    fn forces<'a>(&self, loads: BodyLoads<'a>) -> (Vec<(u32, Vec<f64>)>, &'a [f64]) {
        let mut by_tooth = BTreeMap::new();
        let dofs = |model: &Loadable| match model {
            Loadable::Plane(model, _) => model.dof_count(),
            Loadable::Solid(model, _) => model.dof_count(),
        };
        let dofs = dofs(&self.mesh.loadable);
        let mut add = |chart: Chart, force: f64, row: Option<SparseVector>| {
            let tooth = chart.tooth % self.mesh.ring.sectors;
            let sum = by_tooth.entry(tooth).or_insert_with(|| vec![0.0; dofs]);
            if let Some(row) = row {
                row.add_to(force, sum);
            }
        };
        let on_bore = match loads {
            BodyLoads::Plane { surfaces, interface } => {
                surfaces
                    .iter()
                    .for_each(|load| add(load.chart, load.force, self.pressed(load.chart.surface, load.s)));
                interface
            }
            BodyLoads::Solid { segments, interface } => {
                segments.iter().for_each(|load| {
                    add(load.chart, load.force, self.pressed_at(load.chart.surface, load.segment.place));
                });
                interface
            }
        };
        (by_tooth.into_iter().collect(), on_bore)
    }

    /// Returns the load vector of a unit force into the body at a point on a surface of a plane
    /// sector; coordinates are clamped to its ends.
    fn pressed(&self, surface: u32, s: f64) -> Option<SparseVector> {
        let Loadable::Plane(model, chains) = &self.mesh.loadable else { return None };
        let chain = chains.get(surface as usize)?;
        let own = self.modified_surfaces.as_ref().and_then(|surfaces| surfaces.get(surface as usize));
        let [start, end] = chain.range();
        let onto = own.map_or(s, |own| (own.onto)(s)).clamp(start, end);
        let point = model.mesh.chain_point(chain, onto)?;
        let normal = own.map_or(point.normal, |own| {
            let last = own.profile.edge_from().unwrap_or(own.profile.length());
            own.profile.at(s.clamp(0.0, last)).normal
        });
        Some(model.displacement_row(point.place, normal.map(|part| -part)))
    }

    /// Returns the load vector on a three-dimensional sector.
    fn pressed_at(&self, surface: u32, [s, z]: [f64; 2]) -> Option<SparseVector> {
        let Loadable::Solid(model, sets) = &self.mesh.loadable else { return None };
        let set = sets.get(surface as usize)?;
        let [start, end] = set.chart.as_ref()?.s_range();
        let [low, high] = model.mesh.swept.as_ref()?.z_range();
        let point = model.mesh.surface_point(set, s.clamp(start, end), z.clamp(low, high))?;
        Some(model.displacement_row(point.place, point.normal.map(|part| -part)))
    }
}

impl Mesh {
    /// Returns the rotation from the frame of a sector to that of the body.
    fn rotation(&self, tooth: u32) -> [[f64; 3]; 3] {
        let (sin, cos) = (TAU * f64::from(tooth) / f64::from(self.ring.sectors)).sin_cos();
        [[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]]
    }

    /// Returns the displacements of the output points of a sector in the body's frame from those of
    /// all degrees of freedom in its own frame.
    fn displacements(&self, tooth: u32, moved: &[f64]) -> Vec<[f64; 3]> {
        let rotation = self.rotation(tooth);
        let axes = moved.len() / self.nodes.len().max(1);
        let displacement = |&node: &usize| {
            let at = |axis: usize| if axis < axes { moved[axes * node + axis] } else { 0.0 };
            let own = [at(0), at(1), at(2)];
            rotation.map(|row| dot(row, own))
        };
        self.outline.nodes.iter().map(displacement).collect()
    }

    /// Returns a sector in the body's frame from displacements in its own frame.
    fn sector(&self, tooth: u32, moved: &[f64]) -> DeformedSector {
        let rotation = self.rotation(tooth);
        let outline = &self.outline;
        let nodes = || outline.nodes.iter().copied();
        let NodalStresses { stresses, errors } = if moved.iter().any(|&moved| moved != 0.0) {
            self.elements.stresses(moved)
        } else {
            let count = self.nodes.len();
            NodalStresses { stresses: vec![[0.0; 6]; count], errors: vec![0.0; count] }
        };
        DeformedSector {
            tooth,
            points: nodes().map(|node| rotation.map(|row| dot(row, self.nodes[node]))).collect(),
            cells: outline.cells.clone(),
            elements: outline.elements.clone(),
            displacements: self.displacements(tooth, moved),
            stresses: nodes().map(|node| rotated(&rotation, stresses[node])).collect(),
            stress_errors: nodes().map(|node| errors[node]).collect(),
        }
    }
}
