//! A gear in space: its template's section swept along the helix, and the surfaces that contact sees.
//!
//! The mesh is that of the gear without modifications. They take off thousandths of a millimetre, which contact sees in full
//! ([`GearSurface`]) and the body behind the flanks does not notice: one structure serves all of them.

use crate::blank::Rim;
use crate::gear_surface::GearSurface;
use crate::modification::{LeadModification, Modification, Topography};
use crate::prototype::{GearPrototype, refined, unmeshable};
use crate::sector_mesh::webbed_sector_mesh;
use crate::template::{along_face, section};
use calyx_abi::math;
use calyx_runtime::cache::Key;
use calyx_runtime::error::EngineError;
use calyx_runtime::fe::solid::{SolidMesh, SolidModel};
use calyx_runtime::fe::{ElementPoint, PlaneMesh};
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::scene::StructureOptions;
use calyx_runtime::structure::solid::{
    ElasticSolid, ModifiedStructure, SolidSplitOptions, SolidStructure, SolidSurfaceSource,
};
use calyx_runtime::structure::{RevolvedWeb, RingSource};
use calyx_runtime::surface::Surface;
use std::sync::Arc;

/// Places of recovered stress along a fillet and along the face, at least: root stress is the largest at any of them.
const STRESS_POINTS: [usize; 2] = [24, 12];
/// Of them on each element's edge along a fillet, at least: recovered stress is not the same polynomial across elements.
const STRESS_POINTS_PER_EDGE: usize = 3;

/// Thinnest layer of elements beside a web over the face width; what is thinner counts as the web's.
const THINNEST_LAYER: f64 = 0.01;
/// By so much of a layer those on either side of a web's ends may be longer together than they would be without the web.
const LONGER_LAYER: f64 = 0.25;

/// Places of recovered stress on each element's edge along a fillet and on each layer of elements.
pub(crate) fn stress_points(mesh: &SolidMesh, options: &StructureOptions) -> [usize; 2] {
    let fillet_elements = refined(section(options.template), options.refinement, options.order).fillet;
    let face_elements = mesh.swept.as_ref().map_or(1, |swept| swept.stations.len() - 1);
    let [along_fillet, along_face] = STRESS_POINTS;
    [along_fillet.div_ceil(fillet_elements).max(STRESS_POINTS_PER_EDGE), along_face.div_ceil(face_elements)]
}

pub(crate) fn split_options(options: &StructureOptions) -> SolidSplitOptions {
    SolidSplitOptions { matching_depth: options.matching_depth, ..SolidSplitOptions::default() }
}

/// A tooth with its sector of the rim in space, how sectors are joined, and the web that they stand on if it has a mesh of its own.
pub(crate) struct SolidSector {
    pub model: SolidModel,
    pub ring: RingSource<'static>,
    pub web: Option<RevolvedWeb>,
}

impl GearPrototype {
    /// The flanks in space, counter-clockwise and clockwise, with these modifications.
    fn surfaces_with(
        &self,
        options: &StructureOptions,
        modifications: &[Modification],
    ) -> Result<[Arc<GearSurface>; 2], EngineError> {
        let [tip, _] = self.roundings(options);
        let plain = self.flanks_with(tip, &[])?;
        let modified = self.flanks_with(tip, modifications)?;
        let lead = LeadModification::of(modifications);
        let topographies: Vec<Arc<Topography>> = modifications
            .iter()
            .filter_map(|modification| match modification {
                Modification::Topography(topography) => Some(topography.clone()),
                _ => None,
            })
            .collect();
        let twist = self.twist_per_length();
        let surface = |side: usize| {
            let (plain, modified) = (plain[side].clone(), modified[side].clone());
            Arc::new(
                GearSurface::new(plain, modified, self.face_width, twist, lead.clone())
                    .with_topographies(topographies.clone()),
            )
        };
        Ok([surface(0), surface(1)])
    }

    /// The flanks that contact sees in space, counter-clockwise and clockwise.
    ///
    /// # Errors
    /// The flanks do not reach the tip circle.
    pub fn surfaces(&self, options: &StructureOptions) -> Result<[Arc<GearSurface>; 2], EngineError> {
        self.surfaces_with(options, &self.modifications)
    }

    /// The flanks without modifications: those of the mesh.
    ///
    /// # Errors
    /// The flanks do not reach the tip circle.
    pub fn plain_surfaces(&self, options: &StructureOptions) -> Result<[Arc<GearSurface>; 2], EngineError> {
        self.surfaces_with(options, &[])
    }

    /// Axial ends of the elements, m from mid-face: equal ones, but for a web, which ends between elements.
    fn stations(&self, elements: usize) -> Vec<f64> {
        let half = 0.5 * self.face_width;
        let mut ends = vec![-half, half];
        if let Some(web) = self.rim.web {
            // A sliver beside the web would be an element.
            let apart = THINNEST_LAYER * self.face_width;
            ends.splice(1..1, web.ends().into_iter().filter(|end| end.abs() < half - apart));
        }
        let mut stations = vec![-half];
        for pair in ends.windows(2) {
            let share = (pair[1] - pair[0]) / self.face_width;
            let count = ((elements as f64 * share - LONGER_LAYER).ceil() as usize).max(1);
            stations.extend((1..=count).map(|k| {
                let part = k as f64 / count as f64;
                (1.0 - part) * pair[0] + part * pair[1]
            }));
        }
        stations
    }

    /// Elements along the face, and the order of displacements in them.
    fn along_face(options: &StructureOptions) -> [usize; 2] {
        let [elements, order] = along_face(options.template);
        let refined = ((elements as f64 * options.refinement).round() as usize).max(1);
        [options.face_elements.unwrap_or(refined), options.axial_order.unwrap_or(order)]
    }

    /// The section that the mesh in three dimensions is swept from.
    fn section_mesh(&self, options: &StructureOptions) -> Result<PlaneMesh, EngineError> {
        options.check()?;
        let refinement = refined(section(options.template), options.refinement, options.order);
        let [tip, _] = self.roundings(options);
        let plain = self.flanks_with(tip, &[])?;
        // A web with a mesh of its own is no part of the teeth's.
        let own = self.rim.ring_support().is_some();
        let inside = if own { self.rim.fixed_radius } else { self.rim.ring_radius() };
        webbed_sector_mesh(&self.gear, plain, [self.rim.ring_radius(), inside], &refinement)
            .map_err(unmeshable)
    }

    /// Whether there is such a section.
    ///
    /// # Errors
    /// E0675, E0676, E0691: the options or the gear allow none.
    pub(crate) fn check_section_mesh(&self, options: &StructureOptions) -> Result<(), EngineError> {
        self.section_mesh(options).map(|_| ())
    }

    /// The mesh of tooth 0 with its sector of the rim, mid-face at z = 0. Named sets of faces are
    /// the chains of [`webbed_sector_mesh`].
    ///
    /// # Errors
    /// E0675, E0676, E0691: the options or the gear allow none.
    pub fn solid_mesh(&self, options: &StructureOptions) -> Result<SolidMesh, EngineError> {
        let plane = self.section_mesh(options)?;
        let own = self.rim.ring_support().is_some();
        let [elements, axial_order] = Self::along_face(options);
        let stations = self.stations(elements);
        let twist = self.twist_per_length();
        let place = |[x, y]: [f64; 2], z: f64| {
            let (sine, cosine) = math::sincos(twist * z);
            [cosine * x - sine * y, sine * x + cosine * y, z]
        };
        let mesh = SolidMesh::swept(&plane, &stations, axial_order, &place).map_err(unmeshable)?;
        let Some(web) = self.rim.web.filter(|_| own) else { return Ok(mesh) };
        // Beside the web, its elements have no material.
        let of_web = |element: usize| {
            let [x, y] = plane.position(ElementPoint { element, xi: 0.0, eta: 0.0 });
            let beyond = x.hypot(y) - web.rim_radius;
            beyond * (self.rim.fixed_radius - web.rim_radius) > 0.0
        };
        let of_web: Vec<bool> = (0..plane.elements.len()).map(of_web).collect();
        let [start, end] = web.ends();
        let beside: Vec<bool> = stations
            .windows(2)
            .map(|pair| {
                let middle = 0.5 * (pair[0] + pair[1]);
                middle < start || middle > end
            })
            .collect();
        Ok(mesh.without(|element| beside[element / of_web.len()] && of_web[element % of_web.len()]))
    }

    /// A sector in space of the gear without modifications, and how sectors are joined.
    pub(crate) fn solid_sector(
        &self,
        options: &StructureOptions,
        interrupt: &Interrupt,
    ) -> Result<SolidSector, EngineError> {
        self.check_recovery(options)?;
        let mesh = self.solid_mesh(options)?;
        interrupt.check()?;
        let ring = RingSource {
            sectors: self.gear.teeth(),
            cuts: ["cut_right", "cut_left"],
            bore: "bore",
            hold: self.rim.hold,
            coupled: self.coupled_teeth(),
        };
        let web = self.rim.revolved_web(self.gear.teeth(), self.material);
        Ok(SolidSector { model: SolidModel::new(mesh, self.material), ring, web })
    }

    /// The structure in space of the gear without modifications.
    pub(crate) fn condensed_solid(
        &self,
        options: &StructureOptions,
        interrupt: &Interrupt,
    ) -> Result<ElasticSolid, EngineError> {
        let SolidSector { model, ring, web } = self.solid_sector(options, interrupt)?;
        let stress_points = stress_points(&model.mesh, options);
        let [tip, _] = self.roundings(options);
        let surfaces = self.plain_surfaces(options)?.into_iter().enumerate().map(|(index, surface)| {
            SolidSurfaceSource {
                surface,
                faces: format!("flank_{index}"),
                edges: [None, Some(tip)],
                stress_faces: options.stresses.then(|| format!("fillet_{index}")),
                stress_points,
            }
        });
        let split = split_options(options);
        let surfaces: Vec<SolidSurfaceSource> = surfaces.collect();
        Ok(match web {
            Some(web) => ElasticSolid::ring_on_web(&model, &ring, &web, (&surfaces, &split), interrupt)?,
            None => ElasticSolid::ring(&model, &ring, &surfaces, &split, interrupt)?,
        })
    }

    /// The modified flanks on the body without modifications.
    pub(crate) fn modified_solid(
        &self,
        shared: Arc<dyn SolidStructure>,
        options: &StructureOptions,
    ) -> Result<Arc<dyn SolidStructure>, EngineError> {
        if self.modifications.is_empty() {
            return Ok(shared);
        }
        let surfaces = self.surfaces(options)?.map(|surface| surface as Arc<dyn Surface>);
        Ok(Arc::new(ModifiedStructure::new(shared, surfaces.to_vec())))
    }

    /// All that the structure in space depends on: neither modifications nor pitch errors.
    pub(crate) fn solid_content(&self, options: &StructureOptions) -> Key {
        let [elements, axial_order] = Self::along_face(options);
        // Straight teeth of either hand are one gear: no zero is negative.
        let twist = self.twist_per_length() + 0.0;
        self.teeth_and_tool("solid gear on a rim")
            .numbers(&[self.material.youngs_modulus, self.material.poissons_ratio, self.rim.fixed_radius])
            .numbers(&self.rim.web_numbers())
            .numbers(&Rim::support_numbers(self.rim.hold))
            .numbers(&[self.face_width, twist])
            .text(options.template.name())
            .numbers(&[options.refinement, options.matching_depth])
            .count(options.order as u64)
            .count(elements as u64)
            .count(axial_order as u64)
            .flag(options.stresses)
            .flag(options.sharp_edges)
            .finish()
    }
}
