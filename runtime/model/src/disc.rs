//! Cylinders and flat platens as bodies: simple contact partners with closed-form solutions.
//!
//! Both are prisms, extruded normal to the plane. A [`Disc`] is elastic, a [`Platen`] is rigid.
//! Neither has teeth: every chart has tooth 0.
//!
//! ```
//! use calyx_fe::material::Material;
//! use calyx_model::body::Body;
//! use calyx_model::disc::{Disc, Facing, Platen};
//! use calyx_model::dof::Component;
//! use calyx_model::load::Wrench;
//! use calyx_model::mechanism::Mechanism;
//! use calyx_model::motion::SteadyRotation;
//! use calyx_model::pairs::SurfacePair;
//! use std::sync::Arc;
//!
//! // A roller of 40 mm diameter between two plates, loaded by the upper one.
//! let roller = Arc::new(Disc::new(0.02, 0.01, Material::STEEL));
//! let platen = |facing| Arc::new(Platen::new(0.04, 0.01, facing));
//! let mut scene = Mechanism::default();
//! let roller = scene.add_body(
//!     Body::new("roller", roller, SteadyRotation::at_rest([0.0, 0.0])).free_in(&[Component::Uy]),
//! );
//! let below = SteadyRotation::at_rest([0.0, -0.02]);
//! let table = scene.add_body(Body::new("table", platen(Facing::Up), below));
//! let press = scene.add_body(
//!     Body::new("press", platen(Facing::Down), SteadyRotation::at_rest([0.0, 0.02]))
//!         .free_in(&[Component::Uy])
//!         .loaded(Wrench::of_force([0.0, -5e3, 0.0])),
//! );
//! scene.add_pair(SurfacePair::new([roller, press], [Disc::TOP, Platen::SURFACE]));
//! scene.add_pair(SurfacePair::new([roller, table], [Disc::BOTTOM, Platen::SURFACE]));
//! ```

use crate::fidelity::{BodyModel, StructureOptions};
use crate::prototype::{Prototype, no_solid_model};
use calyx_fe::block::uniform;
use calyx_fe::inertia::Inertia;
use calyx_fe::material::{Material, Plane};
use calyx_fe::{Block, Curve, ElementOrder, MeshBuilder, MeshError, PlaneMesh, PlaneModel, Side};
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use calyx_structure::cache::{Key, KeyWriter};
use calyx_structure::outer_surface::OuterSurface;
use calyx_structure::profile::{Profile, ProfilePoint};
use calyx_structure::{
    BodyModes, ElasticStructure, MeshSupport, RigidStructure, SplitOptions, Structure, SurfaceSource,
};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
use std::sync::Arc;

/// Solid elastic cylinder with its axis through the body's origin, in plane strain.
///
/// It is unconstrained in its frame: loads that are not in equilibrium are balanced by forces
/// distributed like its inertia. Hence its frame, contacts, or both can support it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc {
    /// Radius, m.
    pub radius: f64,
    /// Face width, m.
    pub face_width: f64,
    /// Material.
    pub material: Material,
}

/// Rigid flat plate with the middle of its surface at the body's origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Platen {
    /// Length of the surface, m.
    pub length: f64,
    /// Face width, m.
    pub face_width: f64,
    /// Direction of the surface's outward normal in the body's frame.
    pub facing: Facing,
}

/// Outward normal of a platen's surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Facing {
    /// Along +y.
    Up,
    /// Along -y.
    Down,
}

/// Number of elements along each quarter of the rim, and from the core to it, of the default mesh.
const DIVISIONS: f64 = 12.0;
/// Names of the chains of edges along the surfaces of a disc.
const QUARTERS: [&str; 2] = ["top", "bottom"];

impl Disc {
    /// Quarter of the surface around the +y direction of the body's frame.
    pub const TOP: u32 = 0;
    /// Quarter of the surface around the -y direction.
    pub const BOTTOM: u32 = 1;

    /// Creates a cylinder from radius (m), face width (m) and material. Building the structure
    /// rejects sizes that are not positive.
    pub const fn new(radius: f64, face_width: f64, material: Material) -> Disc {
        Disc { radius, face_width, material }
    }

    /// Returns the profiles of its surfaces.
    fn quarters(&self) -> [Arc<dyn Profile>; 2] {
        [FRAC_PI_2, -FRAC_PI_2]
            .map(|middle| Arc::new(Quarter { radius: self.radius, middle }) as Arc<dyn Profile>)
    }

    /// Meshes a core with curved sides, and a block between each side and the rim.
    fn mesh(&self, divisions: usize, order: ElementOrder) -> Result<PlaneMesh, MeshError> {
        let core = 0.5 * self.radius;
        let on_circle = |radius: f64, angle: f64| [radius * angle.cos(), radius * angle.sin()];
        let corner = |k: usize| FRAC_PI_4 + FRAC_PI_2 * k as f64;
        let side = |from: f64, to: f64| {
            let (start, end) = (on_circle(core, from), on_circle(core, to));
            Curve::new(move |u| {
                let round = on_circle(core, (1.0 - u) * from + u * to);
                [0, 1].map(|axis| 0.5 * (round[axis] + (1.0 - u) * start[axis] + u * end[axis]))
            })
        };
        let mut builder = MeshBuilder::new();
        let core_block = Block::new(
            side(corner(2), corner(3)),
            side(corner(3), corner(4)),
            side(corner(1), corner(0)),
            side(corner(2), corner(1)),
        );
        builder.block(core_block.divided(uniform(divisions), uniform(divisions)));
        let names = [None, Some(QUARTERS[0]), None, Some(QUARTERS[1])];
        for (k, name) in names.into_iter().enumerate() {
            let (first, last) = (corner(k) - FRAC_PI_2, corner(k));
            let ray = |angle: f64| Curve::line(on_circle(core, angle), on_circle(self.radius, angle));
            let rim = Curve::arc([0.0; 2], self.radius, last, first);
            let mut block = Block::new(side(last, first), ray(first), rim, ray(last))
                .divided(uniform(divisions), uniform(divisions));
            if let Some(name) = name {
                block = block.on_profile(Side::Top, name, [FRAC_PI_2 * self.radius, 0.0]);
            }
            builder.block(block);
        }
        builder.finish(order)
    }
}

/// Model with its surfaces and the options of the near field.
type Model = (PlaneModel, [SurfaceSource; 2], SplitOptions);

impl Disc {
    fn model(&self, options: &StructureOptions) -> Result<Model, EngineError> {
        options.check()?;
        let sizes = [self.radius, self.face_width];
        if !sizes.iter().all(|size| size.is_finite() && *size > 0.0) {
            return Err(unmeshed(&format!(
                "a disc of radius {} m and face width {} m",
                self.radius, self.face_width
            )));
        }
        let divisions = (DIVISIONS * options.refinement).round().max(2.0) as usize;
        let mesh = self
            .mesh(divisions, ElementOrder::full(options.order as u8))
            .map_err(|error| unmeshed(&format!("a disc: {error}")))?;
        let model = PlaneModel::new(mesh, self.material, Plane::Strain);
        let surfaces = [0, 1].map(|surface| SurfaceSource {
            profile: self.quarters()[surface].clone(),
            chain: QUARTERS[surface].into(),
            edges: [None; 2],
            stress_chain: None,
            stress_points_per_edge: 1,
        });
        let split = SplitOptions { matching_depth: options.matching_depth, ..SplitOptions::default() };
        Ok((model, surfaces, split))
    }

    fn content(&self, what: &str, options: &StructureOptions) -> KeyWriter {
        let StructureOptions { refinement, order, matching_depth, .. } = *options;
        let Material { youngs_modulus, poissons_ratio, .. } = self.material;
        Key::of(what)
            .text(crate::SOURCE)
            .numbers(&[self.radius, youngs_modulus, poissons_ratio, refinement, matching_depth])
            .count(order as u64)
    }
}

impl Prototype for Disc {
    fn check(&self, options: &StructureOptions, three_dimensional: bool) -> Result<(), EngineError> {
        match options.model {
            _ if three_dimensional => Err(no_solid_model()),
            BodyModel::Analytic => Err(no_closed_form()),
            BodyModel::Rigid | BodyModel::Elements => Ok(()),
        }
    }

    fn build(
        &self,
        options: &StructureOptions,
        interrupt: &Interrupt,
    ) -> Result<Arc<dyn Structure>, EngineError> {
        match options.model {
            BodyModel::Rigid => return Ok(Arc::new(RigidStructure::new(self.quarters().to_vec(), 1))),
            BodyModel::Analytic => return Err(no_closed_form()),
            BodyModel::Elements => {}
        }
        let (model, surfaces, split) = self.model(options)?;
        Ok(Arc::new(ElasticStructure::single(&model, MeshSupport::Free, &surfaces, &split, interrupt)?))
    }

    fn restore(&self, _: &StructureOptions, stored: &[u8]) -> Option<Arc<dyn Structure>> {
        Some(Arc::new(ElasticStructure::restored(stored, &self.quarters())?))
    }

    fn key(&self, options: &StructureOptions) -> Option<Key> {
        (options.model == BodyModel::Elements).then(|| self.content("disc", options).finish())
    }

    fn modes(
        &self,
        options: &StructureOptions,
        highest: f64,
        interrupt: &Interrupt,
    ) -> Result<Option<Arc<BodyModes>>, EngineError> {
        let (model, surfaces, split) = self.model(options)?;
        Ok(Some(Arc::new(BodyModes::single(
            &model,
            MeshSupport::Free,
            &surfaces,
            &split,
            highest,
            interrupt,
        )?)))
    }

    fn inertia(&self) -> Inertia {
        let Disc { radius, face_width, material } = *self;
        let mass = material.density * PI * radius * radius * face_width;
        let across = mass * (0.25 * radius * radius + face_width * face_width / 12.0);
        Inertia::axial(mass, 0.5 * mass * radius * radius, across)
    }

    fn modes_key(&self, options: &StructureOptions, highest: f64) -> Option<Key> {
        Some(self.content("modes of a disc", options).numbers(&[self.material.density, highest]).finish())
    }

    fn restore_modes(&self, _: &StructureOptions, stored: &[u8]) -> Option<Arc<BodyModes>> {
        Some(Arc::new(BodyModes::restored(stored, &self.quarters())?))
    }

    fn outer_surface(
        &self,
        _: &StructureOptions,
        _: bool,
        _: &Interrupt,
    ) -> Result<Option<OuterSurface>, EngineError> {
        let half = 0.5 * self.face_width;
        let section = [[-half, 0.0], [half, 0.0], [half, self.radius], [-half, self.radius]];
        Ok(Some(OuterSurface::revolved(&section)))
    }

    fn enclosing_radius(&self) -> f64 {
        self.radius
    }

    fn face_width(&self) -> f64 {
        self.face_width
    }
}

fn no_closed_form() -> EngineError {
    EngineError::new("E0783", "a disc has no closed form among those of the fidelity \"analytic\"", "")
}

fn unmeshed(what: &str) -> EngineError {
    EngineError::new("E0676", format!("the body cannot be meshed: {what}"), "give positive sizes")
}

impl Platen {
    /// Index of its only surface.
    pub const SURFACE: u32 = 0;

    /// Creates a plate from the length of its surface (m), face width (m) and direction.
    pub const fn new(length: f64, face_width: f64, facing: Facing) -> Platen {
        Platen { length, face_width, facing }
    }
}

impl Prototype for Platen {
    fn check(&self, _: &StructureOptions, three_dimensional: bool) -> Result<(), EngineError> {
        if three_dimensional { Err(no_solid_model()) } else { Ok(()) }
    }

    fn build(&self, _: &StructureOptions, _: &Interrupt) -> Result<Arc<dyn Structure>, EngineError> {
        let up = match self.facing {
            Facing::Up => 1.0,
            Facing::Down => -1.0,
        };
        let surface = Arc::new(Straight { length: self.length, up });
        Ok(Arc::new(RigidStructure::new(vec![surface], 1)))
    }

    fn enclosing_radius(&self) -> f64 {
        0.5 * self.length
    }

    fn face_width(&self) -> f64 {
        self.face_width
    }
}

/// Quarter of a circle about the origin, centred at polar angle `middle`.
struct Quarter {
    radius: f64,
    middle: f64,
}

impl Profile for Quarter {
    fn length(&self) -> f64 {
        FRAC_PI_2 * self.radius
    }

    fn at(&self, s: f64) -> ProfilePoint {
        let (sin, cos) = (self.middle - FRAC_PI_4 + s / self.radius).sin_cos();
        ProfilePoint {
            position: [self.radius * cos, self.radius * sin],
            tangent: [-sin, cos],
            normal: [cos, sin],
            curvature: self.radius.recip(),
        }
    }
}

/// Straight line centred at the origin, facing +y (`up` 1) or -y (-1).
struct Straight {
    length: f64,
    up: f64,
}

impl Profile for Straight {
    fn length(&self) -> f64 {
        self.length
    }

    fn at(&self, s: f64) -> ProfilePoint {
        ProfilePoint {
            position: [self.up * (0.5 * self.length - s), 0.0],
            tangent: [-self.up, 0.0],
            normal: [0.0, self.up],
            curvature: 0.0,
        }
    }
}
