//! Outer surfaces of gears, for display: those of their finite element meshes.

use crate::prototype::{GearPrototype, unmeshable};
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
            surface.add_without_mesh(OuterSurface::revolved_sector(&polygon, teeth, 0.0));
        }
        if self.solid {
            let (half, radius) = (0.5 * self.face_width, self.rim.fixed_radius);
            let core = [[-half, 0.0], [half, 0.0], [half, radius], [-half, radius]];
            surface.add_without_mesh(OuterSurface::revolved_sector(&core, teeth, 0.0));
        }
        Ok(surface)
    }

    /// Returns the plane mesh of a spur gear, extruded over the face width in one layer.
    fn extruded(&self, options: &StructureOptions) -> Result<SolidMesh, EngineError> {
        self.refuse_helix()?;
        let half = 0.5 * self.face_width;
        let place = |[x, y]: [f64; 2], z: f64| [x, y, z];
        SolidMesh::swept(&self.plane_mesh(options)?, &[-half, half], 1, &place).map_err(unmeshable)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blank::{GearBlank, Rim};
    use crate::rack::Rack;
    use crate::tabulated::test_teeth::cylindrical;
    use crate::web::{DiscWeb, Hub};
    use calyx_runtime::interrupt::Interrupt;
    use calyx_runtime::scene::Prototype;

    const MODULE: f64 = 4e-3;
    /// The mesh follows the profile with polynomials, the surface with straight edges between its
    /// nodes; a circle has at least 96 of them.
    const TOLERANCE: f64 = 2e-3;

    /// Compares the volume that the surface encloses with that of the integrated section.
    fn check(name: &str, gear: &GearPrototype) {
        let expected = gear.inertia().mass / gear.material.density;
        for (model, three_dimensional) in [
            (BodyModel::Elements, true),
            (BodyModel::Elements, false),
            (BodyModel::Analytic, true),
            (BodyModel::Rigid, true),
        ] {
            let plane = model == BodyModel::Elements && !three_dimensional;
            if plane && !gear.helix.is_spur() {
                continue;
            }
            let options = StructureOptions { model, ..StructureOptions::default() };
            let surface = gear.outer_surface(&options, three_dimensional, &Interrupt::never());
            let surface = surface.expect("a mesh").expect("a surface");
            assert_eq!(surface.copies, gear.gear.teeth());
            // A plane mesh contains no web.
            if !plane || gear.rim.web.is_none() {
                let found = surface.volume();
                assert!((found / expected - 1.0).abs() < TOLERANCE, "{name}, {model:?}: {found} {expected}");
            }
        }
    }

    #[test]
    fn surfaces_enclose_the_volume_of_their_gears() {
        let rack = Rack::new(MODULE, 20_f64.to_radians(), 0.3 * MODULE).expect("a rack");
        let plain = GearBlank::standard(24, rack).face_width(5.0 * MODULE);
        check("spur", &plain.clone().cut().expect("a gear"));
        check("solid", &GearBlank { solid: true, ..plain.clone() }.cut().expect("a gear"));
        check("helical", &cylindrical(20.0));
        let (diameter, width) = (plain.root_diameter, plain.face_width);
        let rim = Rim::new(diameter - MODULE, diameter - 6.0 * MODULE).expect("a rim");
        let web = rim.clone().on_web(0.25 * width, 1e-3, 10e-3).expect("a web");
        check("meshed web", &plain.clone().rim(web).cut().expect("a gear"));
        let hub = Hub { radius: 8e-3, width, offset: 0.0 };
        let disc = DiscWeb { hub: Some(hub), ..DiscWeb::plain(0.25 * width, 0.0) };
        let web = rim.on_disc(0.25 * width, 0.0, 10e-3, disc).expect("a disc web");
        check("disc", &plain.rim(web).cut().expect("a gear"));
    }
}
