//! Three-dimensional gears: the mesh of the section swept along the helix, and the contact
//! surfaces.
//!
//! The mesh is that of the gear without modifications. Modifications remove a few thousandths of a
//! millimetre. The contact problem includes them in full ([`GearSurface`]), and their effect on the
//! body is negligible, so one structure serves all of them.

use crate::blank::Rim;
use crate::gear_surface::GearSurface;
use crate::modification::{LeadModification, Modification};
use crate::outer_surface::CUTS;
use crate::prototype::{GearPrototype, unmeshable};
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

/// Minimum number of sampling points of recovered stress along a fillet and along the face. The
/// root stress is the largest value of all points.
const STRESS_POINTS: [usize; 2] = [24, 12];
/// Minimum number of these points on each element edge along a fillet: recovered stress is not one
/// polynomial across elements.
const STRESS_POINTS_PER_EDGE: usize = 3;

/// Smallest ratio of a layer of elements next to a web to the face width; a thinner layer is
/// counted as part of the web.
const THINNEST_LAYER: f64 = 0.01;
/// Fraction of a regular element by which a part of the face width between web ends may exceed a
/// whole number of elements without receiving one more.
const LONGER_LAYER: f64 = 0.25;

/// Sampling points of recovered stress on each element edge along a fillet and on each layer of
/// elements.
pub(crate) fn stress_points(mesh: &SolidMesh, options: &StructureOptions) -> [usize; 2] {
    let fillet_elements = section(options.template).refined(options.refinement, options.order).fillet;
    let face_elements = mesh.swept.as_ref().map_or(1, |swept| swept.stations.len() - 1);
    let [along_fillet, along_face] = STRESS_POINTS;
    [along_fillet.div_ceil(fillet_elements).max(STRESS_POINTS_PER_EDGE), along_face.div_ceil(face_elements)]
}

pub(crate) fn split_options(options: &StructureOptions) -> SolidSplitOptions {
    SolidSplitOptions { matching_depth: options.matching_depth, ..SolidSplitOptions::default() }
}

/// Three-dimensional tooth with its sector of the rim, the coupling of the sectors, and the web
/// that carries them if it has its own mesh.
pub(crate) struct SolidSector {
    pub model: SolidModel,
    pub ring: RingSource<'static>,
    pub web: Option<RevolvedWeb>,
}

impl GearPrototype {
    /// Three-dimensional flanks with these modifications, counter-clockwise and clockwise.
    pub(crate) fn surfaces_with(
        &self,
        options: &StructureOptions,
        modifications: &[Modification],
    ) -> Result<[Arc<GearSurface>; 2], EngineError> {
        let [tip, _] = self.roundings(options);
        let plain = self.flanks_with(tip, &[])?;
        let modified = self.flanks_with(tip, modifications)?;
        let internal = self.form().internal;
        let twist = self.twist_per_length();
        let surface = |side: usize| {
            let (plain, modified) = (plain[side].clone(), modified[side].clone());
            let lead = LeadModification::of(modifications, plain.side(), internal);
            Arc::new(GearSurface::new(plain, modified, self.face_width, twist, lead))
        };
        Ok([surface(0), surface(1)])
    }

    /// Contact surfaces of the flanks in three dimensions, counter-clockwise and clockwise.
    ///
    /// # Errors
    /// The flanks do not reach the tip circle.
    pub fn surfaces(&self, options: &StructureOptions) -> Result<[Arc<GearSurface>; 2], EngineError> {
        self.surfaces_with(options, &self.modifications)
    }

    /// Flanks without modifications, as in the mesh.
    ///
    /// # Errors
    /// The flanks do not reach the tip circle.
    pub fn plain_surfaces(&self, options: &StructureOptions) -> Result<[Arc<GearSurface>; 2], EngineError> {
        self.surfaces_with(options, &[])
    }

    /// Axial boundaries of the elements, m from mid-face. The elements are equal, except that the
    /// ends of a web are element boundaries.
    fn stations(&self, elements: usize) -> Vec<f64> {
        let half = 0.5 * self.face_width;
        let mut ends = vec![-half, half];
        if let Some(web) = &self.rim.web {
            // A sliver next to the web would become an element of its own.
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

    /// Number of elements along the face, and their order.
    pub(crate) fn along_face(options: &StructureOptions) -> [usize; 2] {
        let [elements, order] = along_face(options.template);
        let refined = ((elements as f64 * options.refinement).round() as usize).max(1);
        [options.face_elements.unwrap_or(refined), options.axial_order.unwrap_or(order)]
    }

    /// Plane mesh of the section that is swept into the three-dimensional mesh.
    fn section_mesh(&self, options: &StructureOptions) -> Result<PlaneMesh, EngineError> {
        options.check()?;
        let refinement = section(options.template).refined(options.refinement, options.order);
        let [tip, _] = self.roundings(options);
        let plain = self.flanks_with(tip, &[])?;
        // A separately meshed web is not part of the mesh of the teeth.
        let own = self.rim.ring_support().is_some();
        let inside = if own { self.rim.fixed_radius } else { self.rim.ring_radius() };
        webbed_sector_mesh(&self.gear, plain, [self.rim.ring_radius(), inside], &refinement)
            .map_err(unmeshable)
    }

    /// Checks that this section can be meshed.
    ///
    /// # Errors
    /// E0675, E0676, E0691: the options or the gear do not permit it.
    pub(crate) fn check_section_mesh(&self, options: &StructureOptions) -> Result<(), EngineError> {
        self.section_mesh(options).map(|_| ())
    }

    /// Three-dimensional mesh of tooth 0 with its sector of the rim, with mid-face at z = 0. Its
    /// named face sets are the chains of [`webbed_sector_mesh`].
    ///
    /// # Errors
    /// E0675, E0676, E0691: the options or the gear do not permit it.
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
        let Some(web) = self.rim.web.as_ref().filter(|_| own) else { return Ok(mesh) };
        let rim_radius = web.rim_radius();
        // Elements next to the web are removed.
        let of_web = |element: usize| {
            let [x, y] = plane.position(ElementPoint { element, xi: 0.0, eta: 0.0 });
            let beyond = x.hypot(y) - rim_radius;
            beyond * (self.rim.fixed_radius - rim_radius) > 0.0
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

    /// Three-dimensional sector of the gear without modifications, and the coupling of the sectors.
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
            cuts: CUTS,
            bore: "bore",
            support: self.rim.support_in_space(options),
            coupled: self.coupled_teeth(),
        };
        let web = self.rim.revolved_web(self.gear.teeth(), self.material);
        Ok(SolidSector { model: SolidModel::new(mesh, self.material), ring, web })
    }

    /// Three-dimensional structure of the gear without modifications.
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

    /// Modified flanks on the body without modifications.
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

    /// Key of all inputs of the three-dimensional structure. It excludes modifications and pitch
    /// deviations.
    pub(crate) fn solid_content(&self, options: &StructureOptions) -> Key {
        let [elements, axial_order] = Self::along_face(options);
        // Spur teeth of either hand are the same gear, so the sum removes a negative zero.
        let twist = self.twist_per_length() + 0.0;
        self.teeth_and_tool("solid gear on a rim")
            .numbers(&[self.material.youngs_modulus, self.material.poissons_ratio, self.rim.fixed_radius])
            .numbers(&self.rim.web_numbers())
            .numbers(&Rim::support_numbers(self.rim.support_in_space(options)))
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
