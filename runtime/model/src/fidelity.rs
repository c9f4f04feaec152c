//! Fidelity levels of body models, mesh templates of three-dimensional models, and discretization
//! options.
//!
//! See `docs/theory/fidelity.md`.

use calyx_numerics::error::EngineError;
use std::iter;

/// Model of the bodies, from cheap to exact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Fidelity {
    /// Rigid bodies in contact as the load vanishes: tooth contact analysis (TCA). Plane if the
    /// scene is plane, else three-dimensional.
    Rigid,
    /// Closed-form models of teeth and gear bodies, with the near field that all levels share.
    /// Plane if the scene is plane, else three-dimensional.
    Analytic,
    /// Plane finite elements with the semi-analytic near field.
    Plane,
    /// Three-dimensional finite elements with the semi-analytic near field, on meshes of this
    /// template.
    Solid(Template),
}

/// Templates of three-dimensional meshes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Template {
    /// Default, for loads, deflections and stresses of common gears.
    #[default]
    Medium,
    /// Finer mesh in the fillets.
    FineRoot,
    /// Finer mesh everywhere.
    Finest,
    /// For thin rims, up to about the tooth height.
    ThinRim,
}

impl Template {
    /// Returns the name, which is also that of the fidelity.
    pub fn name(self) -> &'static str {
        match self {
            Template::Medium => "medium",
            Template::FineRoot => "fineroot",
            Template::Finest => "finest",
            Template::ThinRim => "thinrim",
        }
    }
}

impl Fidelity {
    /// All levels, from cheap to exact.
    pub const ALL: [Fidelity; 7] = [
        Fidelity::Rigid,
        Fidelity::Analytic,
        Fidelity::Plane,
        Fidelity::Solid(Template::Medium),
        Fidelity::Solid(Template::ThinRim),
        Fidelity::Solid(Template::FineRoot),
        Fidelity::Solid(Template::Finest),
    ];

    /// Returns the next more exact level.
    pub fn above(self) -> Option<Fidelity> {
        match self {
            Fidelity::Rigid => Some(Fidelity::Analytic),
            Fidelity::Analytic => Some(Fidelity::Plane),
            Fidelity::Plane => Some(Fidelity::Solid(Template::Medium)),
            Fidelity::Solid(Template::Medium | Template::ThinRim) => {
                Some(Fidelity::Solid(Template::FineRoot))
            }
            Fidelity::Solid(Template::FineRoot) => Some(Fidelity::Solid(Template::Finest)),
            Fidelity::Solid(Template::Finest) => None,
        }
    }

    /// Returns all more exact levels, from cheap to exact.
    pub fn all_above(self) -> impl Iterator<Item = Fidelity> {
        iter::successors(self.above(), |fidelity| fidelity.above())
    }

    /// Returns the fidelity of this name.
    pub fn named(name: &str) -> Option<Fidelity> {
        Fidelity::ALL.into_iter().find(|fidelity| fidelity.name() == name)
    }

    /// Returns the name.
    pub fn name(self) -> &'static str {
        match self {
            Fidelity::Rigid => "rigid",
            Fidelity::Analytic => "analytic",
            Fidelity::Plane => "plane",
            Fidelity::Solid(template) => template.name(),
        }
    }

    /// Returns the kind of structure of this level.
    pub fn body_model(self) -> BodyModel {
        match self {
            Fidelity::Rigid => BodyModel::Rigid,
            Fidelity::Analytic => BodyModel::Analytic,
            Fidelity::Plane | Fidelity::Solid(_) => BodyModel::Elements,
        }
    }

    /// Returns whether rollers of bearings have elastic contacts with raceways; those of cheaper
    /// levels have the laminae of ISO/TS 16281.
    pub fn has_elastic_rollers(self) -> bool {
        matches!(self, Fidelity::Plane | Fidelity::Solid(_))
    }

    /// Returns the most that an observable may require at this level.
    pub fn supports(self) -> Needs {
        match self {
            Fidelity::Rigid => Needs::Motions,
            Fidelity::Analytic => Needs::RootStress,
            Fidelity::Plane | Fidelity::Solid(_) => Needs::Stresses,
        }
    }
}

/// Kind of a structure.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum BodyModel {
    /// Rigid body.
    Rigid,
    /// Closed-form compliance.
    Analytic,
    /// Finite element model.
    #[default]
    Elements,
}

/// Options of the discretization of a structure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StructureOptions {
    /// Factor on the number of elements along every direction of the mesh; 1 is the default mesh.
    pub refinement: f64,
    /// Order of the displacement interpolation in the section, 1 to 3.
    pub order: usize,
    /// Kind of structure. Without finite elements the mesh options have no effect.
    pub model: BodyModel,
    /// Template of a three-dimensional mesh. Plane models ignore it and the next two options.
    pub template: Template,
    /// Number of elements along the face, 1 to 64; `None` uses that of the template.
    pub face_elements: Option<usize>,
    /// Order of the displacement interpolation along the face, 1 to 8; `None` uses that of the
    /// template.
    pub axial_order: Option<usize>,
    /// Factor on the matching depth of near and far field; 1 is the default.
    pub matching_depth: f64,
    /// Enables stress recovery, which costs one map per structure.
    pub stresses: bool,
    /// Makes surfaces end sharply at their nominal ends, without rounded edges; contact is confined
    /// to them.
    pub sharp_edges: bool,
    /// Additional degrees of the polynomials along elastic raceways, for error estimates.
    pub raceway_degrees: u8,
}

impl Default for StructureOptions {
    fn default() -> Self {
        StructureOptions {
            refinement: 1.0,
            order: 3,
            model: BodyModel::default(),
            template: Template::default(),
            face_elements: None,
            axial_order: None,
            matching_depth: 1.0,
            stresses: true,
            sharp_edges: false,
            raceway_degrees: 0,
        }
    }
}

impl StructureOptions {
    /// Checks whether these options define a mesh.
    ///
    /// # Errors
    /// E0675: the order is not 1 to 3, or the refinement is not positive. E0691: the number of
    /// elements along the face is not 1 to 64, or their order is not 1 to 8.
    pub fn check(&self) -> Result<(), EngineError> {
        if !((1..=3).contains(&self.order) && self.refinement.is_finite() && self.refinement > 0.0) {
            return Err(EngineError::new(
                "E0675",
                "a mesh needs elements of order 1 to 3 and a positive refinement",
                "order 3 and refinement 1 are the defaults",
            ));
        }
        let refuse = |argument, what: &str, given: usize, most: usize| {
            Err(EngineError::new(
                "E0691",
                format!("{what} cannot be {given}"),
                format!("give a whole number from 1 to {most}, or leave it to the fidelity"),
            )
            .blame(argument))
        };
        match (self.face_elements, self.axial_order) {
            (Some(count), _) if !(1..=64).contains(&count) => {
                refuse("face_elements", "the number of elements along the face", count, 64)
            }
            (_, Some(order)) if !(1..=8).contains(&order) => {
                refuse("displacement_order", "the order of displacements along the face", order, 8)
            }
            _ => Ok(()),
        }
    }
}

/// Model requirements of an observable; each level includes the ones before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Needs {
    /// Positions of bodies and surfaces, and contact points.
    Motions,
    /// Contact forces, which depend on the deformation of bodies.
    Forces,
    /// Largest stress in the fillet of a loaded tooth.
    RootStress,
    /// Stresses everywhere on the fillets.
    Stresses,
}

impl Needs {
    /// Returns a description.
    pub fn name(self) -> &'static str {
        match self {
            Needs::Motions => "motions",
            Needs::Forces => "forces between elastic bodies",
            Needs::RootStress => "root stresses",
            Needs::Stresses => "stresses all over the fillets",
        }
    }
}
