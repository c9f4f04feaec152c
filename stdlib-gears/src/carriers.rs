//! Planet carriers of a model, and the planets that are mounted on them.

use crate::prototype::GearPrototype;
use calyx_runtime::elastic::carrier::{CarrierShape, Planet};
use calyx_runtime::error::EngineError;
use calyx_runtime::motion::spatial_pose;
use calyx_runtime::scene::{BodyId, Scene};
use calyx_runtime::vec3::{dot, minus};

/// Planet carrier in a model.
#[derive(Clone, Debug)]
pub struct ModelCarrier {
    /// Name in messages.
    pub name: String,
    /// Its dimensions.
    pub shape: CarrierShape,
    /// Body of the hub.
    pub hub: BodyId,
    /// Bodies of the pins; none for a rigid carrier, whose planets are mounted on the hub.
    pub pins: Vec<BodyId>,
}

impl ModelCarrier {
    /// Returns whether planets can be mounted on this body.
    pub fn carries(&self, body: BodyId) -> bool {
        self.pins.contains(&body) || (self.pins.is_empty() && self.hub == body)
    }

    /// Checks that a planet with this gear fits into the carrier at time 0.
    ///
    /// # Errors
    /// E0995: it reaches into a plate or a web. E0710: a frame is NaN.
    pub fn check_planet(
        &self,
        scene: &Scene,
        planet: BodyId,
        gear: &GearPrototype,
    ) -> Result<(), EngineError> {
        if gear.form().internal {
            return Ok(());
        }
        let pose = |body: BodyId| spatial_pose(scene.bodies[body.0].motion.as_ref(), 0.0);
        let (hub, at) = (pose(self.hub)?, pose(planet)?.origin);
        let from = minus(at, hub.origin);
        let position = [0, 1, 2].map(|axis: usize| dot(hub.rotation.map(|row| row[axis]), from));
        let fits = self.shape.check_planet(&Planet {
            position,
            tip_radius: gear.form().tip_radius,
            face_width: gear.face_width,
        });
        fits.map_err(|error| {
            let name = &scene.bodies[planet.0].name;
            let message = format!(
                "the planet \"{name}\" does not fit into the carrier \"{}\": {}",
                self.name, error.message
            );
            EngineError::new("E0995", message, error.help).blame("to")
        })
    }
}
