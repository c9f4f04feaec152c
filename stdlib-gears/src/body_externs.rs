//! Bodies for programs: the functions `body` and `rigid_body` of `gears.cx`, and [`BodyPlacement`],
//! the arguments that all bodies share.

use crate::assembly::add_body;
use crate::dynamics_externs::lumped;
use crate::elastic_externs::elastic_frame;
use crate::externs::{self, entry, host, refusal};
use crate::host::ModelHost;
use calyx_abi::externs::{Handle, Symbolic, SymbolicTransform};
use calyx_abi::{Context, RuntimeError, SymbolicValue};
use calyx_runtime::inertia::Inertia;
use calyx_runtime::load::{Load, Wrench};
use calyx_runtime::motion::Motion;
use calyx_runtime::rigid::RigidBody;
use calyx_runtime::scene::{Body, DOF_NAMES, Prototype};
use std::sync::Arc;

calyx_abi::externs! {
    Scene fn calyx_gears_body(
        context, name: String, blank: Handle, frame: SymbolicTransform, free: Vec<String>, force: [f64; 3],
        moment: [f64; 3], mass: f64, inertia: f64, host_load: Option<String>,
    ) -> Handle {
        let prototype = entry(&host(context)?.gears, blank)?.prototype();
        let added = lumped(mass, inertia)?;
        let frame = BodyPlacement { name, frame, free, load: Wrench { force, moment }, added, host_load };
        frame.add(context, prototype, Some(blank.0 as usize))
    }

    /// `body.frame`
    Pure fn calyx_std_body_frame(context, body: Handle) -> SymbolicTransform {
        if let Some(frame) = elastic_frame(host(context)?, body) {
            return Ok(Symbolic(frame));
        }
        let id = externs::body(context, "body", body)?;
        entry(&host(context)?.body_frames, Handle(id.0 as u64)).cloned().map(Symbolic)
    }

    Scene fn calyx_gears_rigid_body(
        context, name: String, frame: SymbolicTransform, free: Vec<String>, force: [f64; 3], moment: [f64; 3],
        mass: f64, inertia: f64, diametral_inertia: Option<f64>, host_load: Option<String>,
    ) -> Handle {
        lumped(mass, inertia)?;
        let added = Inertia::axial(mass, inertia, diametral_inertia.unwrap_or(0.5 * inertia));
        let frame = BodyPlacement { name, frame, free, load: Wrench { force, moment }, added, host_load };
        frame.add(context, Arc::new(RigidBody), None)
    }
}

/// Position of a body in a model: the properties that bodies with and without teeth share.
pub(crate) struct BodyPlacement {
    /// Name, without the path of an instance.
    pub name: String,
    /// Prescribed motion of the frame.
    pub frame: SymbolicTransform,
    /// Names of the free degrees of freedom.
    pub free: Vec<String>,
    /// Constant load.
    pub load: Wrench,
    /// Lumped masses on the frame.
    pub added: Inertia,
    /// Name of a load from the host program.
    pub host_load: Option<String>,
}

impl BodyPlacement {
    /// Adds the body to the scene; `gear` is the number of its gear, if it carries one.
    pub fn add(
        self,
        context: &mut Context,
        prototype: Arc<dyn Prototype>,
        gear: Option<usize>,
    ) -> Result<Handle, RuntimeError> {
        externs::before_analysis(context, format_args!("the body \"{}\"", self.name))?;
        let free = named_components(&self.free)?;
        let expression = self.frame.0.clone();
        let motion = BodyPlacement::motion(self.frame, context.params.clone());
        let name = context.name_in_instance(self.name);
        let (place, host) = (context.place, host(context)?);
        let load = BodyPlacement::load(host, self.load, self.host_load.as_deref(), place);
        let body =
            Body { name, prototype, motion, phase: 0.0, free, load, impulses: Vec::new(), added: self.added };
        let id = add_body(&mut host.scene, body).map_err(|refusal| host.rejected(refusal, place))?;
        if self.host_load.is_some() {
            host.host_loaded.insert(id.0);
        }
        host.body_gears.push(gear);
        host.body_frames.push(expression);
        host.body_places.push(place);
        Ok(Handle(id.0 as u64))
    }

    /// Compiled frame as a motion, with the params of the model.
    pub fn motion(frame: SymbolicTransform, params: Vec<f64>) -> Arc<dyn Motion> {
        Arc::new(FrameMotion { value: frame.0, params })
    }

    /// Load on a body: the constant part from the model, and the part that the host program
    /// provides under a name, if any.
    pub fn load(
        host: &mut ModelHost,
        constant: Wrench,
        name: Option<&str>,
        place: (u32, u32, u32),
    ) -> Arc<dyn Load> {
        let Some(name) = name else { return Arc::new(constant) };
        match host.provided.loads.get(name) {
            Some(load) => {
                let load = load.clone();
                Arc::new(move |time: f64| constant + load.at(time))
            }
            None => {
                host.note_unprovided("host_load", "load", "none is added", name, place);
                Arc::new(constant)
            }
        }
    }
}

/// Returns which degrees of freedom are named.
///
/// # Errors
/// E0670: a name is not that of a degree of freedom.
pub(crate) fn named_components(names: &[String]) -> Result<[bool; 6], RuntimeError> {
    let mut free = [false; 6];
    for name in names {
        let Some(at) = DOF_NAMES.iter().position(|known| known == name) else {
            return Err(refusal(
                "E0670",
                "free",
                &format!("a frame has no degree of freedom called \"{name}\""),
                "choose from \"u_x\", \"u_y\", \"u_z\", \"theta_x\", \"theta_y\" and \"theta_z\"",
            ));
        };
        free[at] = true;
    }
    Ok(free)
}

/// Compiled frame as a motion.
struct FrameMotion {
    value: Arc<SymbolicValue>,
    params: Vec<f64>,
}

impl FrameMotion {
    /// Frame, velocity and acceleration, 12 numbers each.
    fn eval(&self, time: f64) -> Vec<f64> {
        let mut outputs = self.value.evaluate(time, &self.params, &|_| f64::NAN).unwrap_or_default();
        outputs.resize(outputs.len().max(36), f64::NAN);
        outputs
    }
}

impl Motion for FrameMotion {
    fn frame(&self, time: f64) -> [f64; 12] {
        let outputs = self.eval(time);
        std::array::from_fn(|i| outputs[i])
    }

    fn rate(&self, time: f64) -> [f64; 12] {
        let outputs = self.eval(time);
        std::array::from_fn(|i| outputs[12 + i])
    }

    fn acceleration(&self, time: f64) -> [f64; 12] {
        let outputs = self.eval(time);
        std::array::from_fn(|i| outputs[24 + i])
    }
}
