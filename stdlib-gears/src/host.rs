//! What the library keeps for a running model: every gear, rack and material the program made, and the scene.

use crate::error::GeometryError;
use crate::modification::Modification;
use crate::prototype::GearPrototype;
use crate::rack::Rack;
use calyx_abi::externs::Handle;
use calyx_runtime::analysis::{Observer, Position};
use calyx_runtime::material::Material;
use calyx_runtime::results::{AnalysisResult, OutputRequest};
use calyx_runtime::scene::Scene;
use std::sync::Arc;

/// A plain ring under the teeth. Radii in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rim {
    pub radius: f64,
    pub inner_radius: f64,
}

/// The state behind a model's handles.
#[derive(Default)]
pub struct ModelHost {
    pub materials: Vec<Material>,
    pub racks: Vec<Rack>,
    pub rims: Vec<Rim>,
    pub modifications: Vec<Modification>,
    pub gears: Vec<Arc<GearPrototype>>,
    /// The gear of each body of the scene, in order.
    pub body_gears: Vec<usize>,
    pub positions: Vec<Vec<Position>>,
    pub scene: Scene,
    pub outputs: Vec<OutputRequest>,
    /// Findings that do not stop the model.
    pub warnings: Vec<Finding>,
    /// Watches the analysis; without one it runs unobserved.
    pub observer: Option<Box<dyn Observer + Send>>,
    /// What the last analysis yielded.
    pub result: Option<AnalysisResult>,
}

/// A warning with the place of the call it arose in.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    pub error: GeometryError,
    /// `(file, start, end)`
    pub place: (u32, u32, u32),
}

/// Puts a thing into its table and hands out its handle.
pub fn keep<T>(table: &mut Vec<T>, thing: T) -> Handle {
    table.push(thing);
    Handle((table.len() - 1) as u64)
}
