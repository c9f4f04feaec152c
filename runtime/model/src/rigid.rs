//! Bodies without surfaces, such as carriers, shafts and housings: frames with bearings and loads.

use crate::fidelity::StructureOptions;
use crate::prototype::Prototype;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use calyx_structure::Structure;
use std::sync::Arc;

/// Rigid body without contact. It has no structure, and the plan never requests one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RigidBody;

/// Radius at which rotations of a rigid body are compared with displacements when a free motion is
/// named, m: a typical size of machines.
const RADIUS: f64 = 0.1;

impl Prototype for RigidBody {
    fn build(&self, _: &StructureOptions, _: &Interrupt) -> Result<Arc<dyn Structure>, EngineError> {
        Err(EngineError::new(
            "E0659",
            "a rigid body has no surfaces, and cannot touch anything",
            "let gears touch, and connect a rigid body with them by bearings",
        ))
    }

    fn enclosing_radius(&self) -> f64 {
        RADIUS
    }

    fn face_width(&self) -> f64 {
        0.0
    }
}
