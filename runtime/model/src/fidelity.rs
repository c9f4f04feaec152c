//! How bodies are modelled, and how finely: the ladder of levels, the meshes in space, and the knobs of a discretisation.

use calyx_numerics::error::EngineError;
use std::iter;

/// How bodies are modelled: the ladder from cheap to exact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Fidelity {
    /// Bodies that do not deform, where they touch as the load vanishes: tooth contact analysis. In the plane if the scene lies in one, else
    /// in space.
    Rigid,
    /// Teeth and what carries them in closed forms, with the near field that all levels have. In the plane if the scene lies in one, else in space.
    Analytic,
    /// Plane finite elements with the semi-analytic near field.
    Plane,
    /// Finite elements in space with the semi-analytic near field, on meshes of this kind.
    Solid(Template),
}

/// Meshes in space by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Template {
    /// For loads, deflections and stresses of usual gears.
    #[default]
    Medium,
    /// Finer in the fillets.
    FineRoot,
    /// Finer everywhere.
    Finest,
    /// For rims not much thicker than the teeth are high, or thinner.
    ThinRim,
}

impl Template {
    /// Its name, which is that of the fidelity.
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
    /// From cheap to exact.
    pub const ALL: [Fidelity; 7] = [
        Fidelity::Rigid,
        Fidelity::Analytic,
        Fidelity::Plane,
        Fidelity::Solid(Template::Medium),
        Fidelity::Solid(Template::ThinRim),
        Fidelity::Solid(Template::FineRoot),
        Fidelity::Solid(Template::Finest),
    ];

    /// The one that sees more.
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

    /// All that see more, from cheap to exact.
    pub fn all_above(self) -> impl Iterator<Item = Fidelity> {
        iter::successors(self.above(), |fidelity| fidelity.above())
    }

    /// A fidelity by its name.
    pub fn named(name: &str) -> Option<Fidelity> {
        Fidelity::ALL.into_iter().find(|fidelity| fidelity.name() == name)
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Fidelity::Rigid => "rigid",
            Fidelity::Analytic => "analytic",
            Fidelity::Plane => "plane",
            Fidelity::Solid(template) => template.name(),
        }
    }

    /// What bodies are made of.
    pub fn body_model(self) -> BodyModel {
        match self {
            Fidelity::Rigid => BodyModel::Rigid,
            Fidelity::Analytic => BodyModel::Analytic,
            Fidelity::Plane | Fidelity::Solid(_) => BodyModel::Elements,
        }
    }

    /// The most that an observable may need.
    pub fn gives(self) -> Needs {
        match self {
            Fidelity::Rigid => Needs::Motions,
            Fidelity::Analytic => Needs::RootStress,
            Fidelity::Plane | Fidelity::Solid(_) => Needs::Stresses,
        }
    }
}

/// What a structure is made of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum BodyModel {
    /// Nothing that deforms.
    Rigid,
    /// Closed forms.
    Analytic,
    /// Finite elements.
    #[default]
    Elements,
}

/// Knobs of a structure's discretisation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StructureOptions {
    /// Multiplies the number of elements along every direction of the mesh; 1 is the default mesh.
    pub refinement: f64,
    /// Order of displacement interpolation in the section, 1 to 3.
    pub order: usize,
    /// What it is made of; without elements all that is said of meshes is idle.
    pub model: BodyModel,
    /// The mesh of a body in space; a plane one has no use for it and for the next two.
    pub template: Template,
    /// Elements along the face, 1 to 64; `None` takes the template's.
    pub face_elements: Option<usize>,
    /// Order of displacement interpolation along the face, 1 to 8; `None` takes the template's.
    pub axial_order: Option<usize>,
    /// Multiplies the matching depth of near and far field; 1 is the default.
    pub matching_depth: f64,
    /// Recover stresses (costs one map per structure).
    pub stresses: bool,
    /// Surfaces run up to their nominal ends, without the rounding of edges: contact is confined to them.
    pub sharp_edges: bool,
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
        }
    }
}

impl StructureOptions {
    /// Whether a mesh can be made by them.
    ///
    /// # Errors
    /// E0675: the order is not 1 to 3, or the refinement is not positive. E0691: nor are elements along the face 1 to 64, or their
    /// order 1 to 8.
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

/// What of bodies an observable needs to be modelled: each of these has the ones before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Needs {
    /// Where bodies and surfaces are, and where they touch.
    Motions,
    /// With which forces bodies press on each other, which follow from how they deform.
    Forces,
    /// The largest stress in the fillet of a loaded tooth.
    RootStress,
    /// Stresses everywhere on the fillets.
    Stresses,
}

impl Needs {
    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Needs::Motions => "motions",
            Needs::Forces => "forces between elastic bodies",
            Needs::RootStress => "root stresses",
            Needs::Stresses => "stresses all over the fillets",
        }
    }
}
