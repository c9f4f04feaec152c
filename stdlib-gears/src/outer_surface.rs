//! Outer surfaces of gears, for display: those of their finite element meshes.

use crate::prototype::{GearPrototype, unmeshable};
use calyx_abi::math;
use calyx_runtime::error::EngineError;
use calyx_runtime::fe::solid::SolidMesh;
use calyx_runtime::scene::{BodyModel, StructureOptions};
use calyx_runtime::structure::outer_surface::OuterSurface;

/// Names of the two faces between a sector of a gear and its neighbours.
pub(crate) const CUTS: [&str; 2] = ["cut_right", "cut_left"];
/// Number of elements along the face, and their order, to display gears that have no
/// three-dimensional mesh.
const SHOWN: [usize; 2] = [6, 1];

/// Returns the options of the mesh that displays a gear: its own, or that of a gear without finite
/// elements.
pub(crate) fn display_options(options: &StructureOptions) -> StructureOptions {
    match options.model {
        BodyModel::Elements => *options,
        BodyModel::Rigid | BodyModel::Analytic => {
            let [elements, order] = SHOWN;
            StructureOptions { face_elements: Some(elements), axial_order: Some(order), ..*options }
        }
    }
}

impl GearPrototype {
    /// Returns the outer surface of a sector; a plane mesh is extruded over the face width.
    ///
    /// # Errors
    /// Those of [`GearPrototype::solid_mesh`].
    pub(crate) fn displayed(
        &self,
        options: &StructureOptions,
        three_dimensional: bool,
    ) -> Result<OuterSurface, EngineError> {
        let teeth = self.gear.teeth();
        let plane = options.model == BodyModel::Elements && !three_dimensional;
        let mesh = if plane { self.extruded(options)? } else { self.solid_mesh(&display_options(options))? };
        let mut surface = OuterSurface::of_sector(&mesh, CUTS, teeth);
        // A web with its own mesh is not part of the sector.
        if let Some(web) = self.rim.web.as_ref().filter(|_| self.rim.ring_support().is_none() && !plane) {
            let stations = web.section().stations();
            let start = stations.iter().map(|at| [at.ends[0], at.radius]);
            let end = stations.iter().rev().map(|at| [at.ends[1], at.radius]);
            let polygon: Vec<[f64; 2]> = start.chain(end).collect();
            surface.add(OuterSurface::revolved_sector(&polygon, teeth, 0.0));
        }
        Ok(surface)
    }

    /// Returns the plane mesh, extruded over the face width in one layer.
    fn extruded(&self, options: &StructureOptions) -> Result<SolidMesh, EngineError> {
        let half = 0.5 * self.face_width;
        let twist = self.twist_per_length();
        let place = |[x, y]: [f64; 2], z: f64| {
            let (sine, cosine) = math::sincos(twist * z);
            [cosine * x - sine * y, sine * x + cosine * y, z]
        };
        SolidMesh::swept(&self.plane_mesh(options)?, &[-half, half], 1, &place).map_err(unmeshable)
    }
}
