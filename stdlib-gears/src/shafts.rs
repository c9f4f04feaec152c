//! Shafts of a model: their sections, the bodies on them, and the elastic connection in the scene
//! that condenses each shaft onto its sections.
//!
//! A shaft creates a section, a body without teeth, wherever something acts on it: bearings, loads,
//! discs. A gear that is mounted at the position of such a section takes its place. The connection
//! is condensed again whenever a section is added, so the scene is complete at any time.
//!
//! A rigid shaft has one body, on which all bearings and loads act at their distance; its first
//! gear becomes this body, which makes the scene that of a gear on bearings. Further gears are
//! joined to it by the shaft at [`RIGID`] times its stiffness.

use crate::assembly::add_body;
use crate::error::Refusal;
use crate::gear::ToothForm;
use calyx_runtime::bearing::Support;
use calyx_runtime::connection::{Attachment, CondensedShaft, ElasticConnection};
use calyx_runtime::error::EngineError;
use calyx_runtime::inertia::Inertia;
use calyx_runtime::load::{Load, Wrench};
use calyx_runtime::motion::{Motion, Orientation, spatial_pose};
use calyx_runtime::rigid::RigidBody;
use calyx_runtime::scene::{Body, BodyId, Component, ConnectionId, Prototype, Scene};
use calyx_runtime::shaft::{SAME_POSITION, Shaft};
use calyx_runtime::structure::{ComponentModes, RacewayMatrices};
use calyx_runtime::vec3::{cross, length, minus};
use std::sync::Arc;

/// Ratio of the stiffness between the gears of a rigid shaft to that of the elastic shaft.
pub const RIGID: f64 = 1e5;
/// Component that the teeth of a gear drive.
const THETA_Z: usize = Component::ThetaZ as usize;

/// Shaft in a scene.
#[derive(Clone)]
pub struct ModelShaft {
    /// Name in results and messages.
    pub name: String,
    /// The shaft.
    pub shaft: Arc<Shaft>,
    /// True if the shaft is modelled as rigid.
    pub rigid: bool,
    /// Free degrees of freedom of its sections.
    pub free: [bool; 6],
    /// Position at which the rotation is prescribed, m, if any.
    pub prescribed: Option<f64>,
    /// The section at the origin, or the body of a rigid shaft; a gear may have taken its place.
    pub body: BodyId,
    /// Position on the shaft of the origin of that body's frame, m.
    pub origin: f64,
    /// Elastic connection in the scene.
    pub connection: ConnectionId,
    /// Faces of the cylindrical gears on it: name, and positions of both ends, m.
    pub faces: Vec<(String, [f64; 2])>,
}

/// A gear, or another body, to be mounted on a shaft.
pub struct Mounted {
    /// Name in results and messages.
    pub name: String,
    /// Its model.
    pub prototype: Arc<dyn Prototype>,
    /// Position of the origin of its frame, m; that of a bevel gear may be beyond the shaft.
    pub at: f64,
    /// Position at which it is joined to the shaft, m.
    pub joint: f64,
    /// Length along which it constrains the shaft, symmetric to the joint, m; 0 for a point.
    pub hub_width: f64,
    /// Load at the origin of its frame.
    pub load: Arc<dyn Load>,
    /// Additional inertia.
    pub added: Inertia,
}

/// Result of mounting a body on a shaft.
pub struct MountedBody {
    /// The body.
    pub body: BodyId,
    /// True for a new body, false for a section that it has replaced.
    pub new: bool,
}

/// Position of a point relative to a shaft.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointAtShaft {
    /// Position along the axis, from the start of the shaft, m.
    pub position: f64,
    /// Distance from the axis, m.
    pub beside: f64,
}

/// Motion of a frame that is displaced along its own axis.
struct DisplacedAlong {
    motion: Arc<dyn Motion>,
    distance: f64,
}

impl Motion for DisplacedAlong {
    fn frame(&self, time: f64) -> [f64; 12] {
        // x' = R x + t, and the origin moves by the distance along the z axis of the frame.
        let mut frame = self.motion.frame(time);
        frame[11] -= self.distance;
        frame
    }

    fn rate(&self, time: f64) -> [f64; 12] {
        self.motion.rate(time)
    }

    fn acceleration(&self, time: f64) -> [f64; 12] {
        self.motion.acceleration(time)
    }
}

/// Returns a load that acts at a distance along the axis of a frame, about the origin of the frame.
fn load_at(load: Arc<dyn Load>, motion: Arc<dyn Motion>, distance: f64) -> Arc<dyn Load> {
    if distance == 0.0 {
        return load;
    }
    let moved = move |time: f64| {
        let Wrench { force, moment } = load.at(time);
        let axis = spatial_pose(motion.as_ref(), time)
            .map_or([f64::NAN; 3], |pose| Orientation::of(&pose).axis().map(|part| distance * part));
        let turned = cross(axis, force);
        Wrench { force, moment: std::array::from_fn(|k| moment[k] + turned[k]) }
    };
    // A moment alone does not depend on the position, and remains constant.
    Arc::new(moved)
}

/// Adds a load to a body.
fn add_load(body: &mut Body, load: Arc<dyn Load>) {
    let old = body.load.clone();
    body.load = match (old.is_constant(), load.is_constant()) {
        (true, true) => Arc::new(old.at(0.0) + load.at(0.0)),
        _ => Arc::new(move |time: f64| old.at(time) + load.at(time)),
    };
}

/// Returns a position on a shaft, without rounding errors at its ends; `shown` formats lengths.
///
/// # Errors
/// E0859: the position is off the shaft.
pub(crate) fn position_on(
    shaft: &Shaft,
    name: &str,
    (argument, at): (&'static str, f64),
    shown: impl Fn(f64) -> String,
) -> Result<f64, EngineError> {
    shaft.on_shaft(at).ok_or_else(|| {
        let (position, length) = (shown(at), shown(shaft.length()));
        let message = format!("the position {position} is off the shaft \"{name}\", which is {length} long");
        let help = "give a distance from the start of the first segment, between 0 and the sum of the lengths of the segments";
        EngineError::new("E0859", message, help).blame(argument)
    })
}

impl ModelShaft {
    /// Adds a shaft to a scene, with a section at its origin and one where its rotation is
    /// prescribed. The connection is called like the shaft.
    ///
    /// # Errors
    /// Those of [`add_body`] and of
    /// [`Scene::add_connection`](calyx_runtime::mechanism::Mechanism::add_connection).
    pub fn add(
        scene: &mut Scene,
        name: String,
        (shaft, rigid): (Arc<Shaft>, bool),
        motion: Arc<dyn Motion>,
        (free, prescribed): ([bool; 6], Option<f64>),
    ) -> Result<ModelShaft, Refusal> {
        let mut own = free;
        own[THETA_Z] &= prescribed.is_none_or(|at| !rigid && at != 0.0);
        let added = if rigid { shaft.inertia() } else { Inertia::default() };
        let body = Body {
            motion,
            free: own,
            added,
            ..Body::new(
                name.clone(),
                Arc::new(RigidBody),
                calyx_runtime::motion::SteadyRotation::at_rest([0.0; 2]),
            )
        };
        let body = add_body(scene, body)?;
        let connection = ElasticConnection {
            name: name.clone(),
            attachments: vec![Attachment { to: Support::Body(body), at: [0.0; 3] }],
            stiffness: vec![0.0; 36],
            mass: if rigid { Vec::new() } else { shaft.mass(&[0.0]) },
            modes: ComponentModes::default(),
            shaft: Some(CondensedShaft { shaft: shaft.clone(), stations: vec![0.0], rigid }),
            body: None,
            raceways: RacewayMatrices::default(),
        };
        let connection = scene.add_connection(connection)?;
        let own = ModelShaft {
            name,
            shaft,
            rigid,
            free,
            prescribed,
            body,
            origin: 0.0,
            connection,
            faces: Vec::new(),
        };
        if let Some(at) = prescribed {
            own.section(scene, at, |_| String::new())?;
        }
        Ok(own)
    }

    /// Adds the face of a gear of a form at a position, m; `shown` formats lengths.
    ///
    /// # Errors
    /// E0859: it overlaps that of another gear, or the shaft is thicker than the gear.
    pub fn add_face(
        &mut self,
        (name, form): (&str, &ToothForm),
        (at, width): (f64, f64),
        shown: impl Fn(f64) -> String,
    ) -> Result<(), EngineError> {
        let diameter = self.shaft.outside_diameter(at);
        let tip_diameter = 2.0 * form.tip_radius;
        if !form.internal && diameter > tip_diameter {
            let message = format!(
                "the shaft \"{}\" has a diameter of {} where it carries \"{name}\", whose tip diameter is {}",
                self.name,
                shown(diameter),
                shown(tip_diameter)
            );
            let help =
                "compare the diameters of the segments and their units with the drawing, or correct `at`";
            return Err(EngineError::new("E0859", message, help).blame("at"));
        }
        let [from, to] = [at - 0.5 * width, at + 0.5 * width];
        let slack = SAME_POSITION * self.shaft.length();
        let other = self.faces.iter().find(|(_, [start, end])| from < end - slack && *start < to - slack);
        if let Some((other, [start, end])) = other {
            let message = format!(
                "the face of \"{name}\", {} to {} of the shaft \"{}\", overlaps that of \"{other}\", {} to {}",
                shown(from),
                shown(to),
                self.name,
                shown(*start),
                shown(*end)
            );
            let help = "`at` is the middle of the face: mount the gears farther apart";
            return Err(EngineError::new("E0859", message, help).blame("at"));
        }
        self.faces.push((name.to_owned(), [from, to]));
        Ok(())
    }

    /// Returns the position on the shaft, without rounding errors at its ends.
    ///
    /// # Errors
    /// E0859: the position is off the shaft.
    pub fn position(
        &self,
        argument: &'static str,
        at: f64,
        shown: impl Fn(f64) -> String,
    ) -> Result<f64, EngineError> {
        position_on(&self.shaft, &self.name, (argument, at), shown)
    }

    fn condensed<'s>(&self, scene: &'s Scene) -> (&'s [f64], &'s [Attachment]) {
        let connection = &scene.connections[self.connection.0];
        let stations = connection.shaft.as_ref().map_or(&[][..], |shaft| &shaft.stations);
        (stations, &connection.attachments)
    }

    /// Returns the body that carries the section at a position (m), and the position in the
    /// coordinates of its frame along the axis; adds a section to an elastic shaft if there is
    /// none.
    /// `named` names the position.
    ///
    /// # Errors
    /// Those of [`add_body`].
    pub fn section(
        &self,
        scene: &mut Scene,
        at: f64,
        named: impl Fn(f64) -> String,
    ) -> Result<(BodyId, f64), Refusal> {
        if self.rigid {
            return Ok((self.body, at - self.origin));
        }
        if let Some(found) = self.carrier(scene, at) {
            return Ok(found);
        }
        let motion = self.motion_at(scene, at);
        let mut free = self.free;
        free[THETA_Z] &= self.prescribed.is_none_or(|prescribed| !self.same(prescribed, at));
        let position = named(at);
        let name = match position.is_empty() {
            true => format!("{} coupling", self.name),
            false => format!("{} at {position}", self.name),
        };
        let section = Body {
            motion,
            free,
            ..Body::new(name, Arc::new(RigidBody), calyx_runtime::motion::SteadyRotation::at_rest([0.0; 2]))
        };
        let body = add_body(scene, section)?;
        self.attach(scene, &[(at, body, 0.0)], None)?;
        Ok((body, 0.0))
    }

    fn same(&self, one: f64, other: f64) -> bool {
        (one - other).abs() <= SAME_POSITION * self.shaft.length()
    }

    /// Returns the body at a position of an elastic shaft, if there is one: at a station or within
    /// a hub.
    fn carrier(&self, scene: &Scene, at: f64) -> Option<(BodyId, f64)> {
        let (stations, attachments) = self.condensed(scene);
        let body = |index: usize| match attachments[index].to {
            Support::Body(body) => Some(body),
            Support::Ground => None,
        };
        if let Some(index) = stations.iter().position(|&station| self.same(station, at)) {
            return Some((body(index)?, attachments[index].at[2]));
        }
        let within = (1..stations.len()).find(|&k| {
            stations[k - 1] < at && at < stations[k] && attachments[k - 1].to == attachments[k].to
        })?;
        Some((body(within)?, attachments[within].at[2] + at - stations[within]))
    }

    /// Motion of the section at a position: that of the shaft's body, which a misalignment may have
    /// displaced, along the axis.
    fn motion_at(&self, scene: &Scene, at: f64) -> Arc<dyn Motion> {
        let motion = scene.bodies[self.body.0].motion.clone();
        match at - self.origin {
            0.0 => motion,
            distance => Arc::new(DisplacedAlong { motion, distance }),
        }
    }

    /// Adds attachments (position, body, position in the body's frame), in place of those of a
    /// body, and condenses the shaft.
    fn attach(
        &self,
        scene: &mut Scene,
        more: &[(f64, BodyId, f64)],
        in_place_of: Option<BodyId>,
    ) -> Result<(), EngineError> {
        let (stations, attachments) = self.condensed(scene);
        let replaced = in_place_of.map(Support::Body);
        let mut all: Vec<(f64, Attachment)> =
            stations.iter().copied().zip(attachments.iter().copied()).collect();
        all.retain(|(_, attachment)| Some(attachment.to) != replaced);
        all.extend(
            more.iter().map(|&(at, body, offset)| {
                (at, Attachment { to: Support::Body(body), at: [0.0, 0.0, offset] })
            }),
        );
        all.sort_by(|(one, _), (other, _)| one.total_cmp(other));
        let (stations, attachments): (Vec<f64>, Vec<Attachment>) = all.into_iter().unzip();
        let factor = if self.rigid { RIGID } else { 1.0 };
        let connection = ElasticConnection {
            name: self.name.clone(),
            stiffness: self.shaft.stiffness(&stations).into_iter().map(|entry| factor * entry).collect(),
            mass: if self.rigid { Vec::new() } else { self.shaft.mass(&stations) },
            attachments,
            modes: ComponentModes::default(),
            shaft: Some(CondensedShaft { shaft: self.shaft.clone(), stations, rigid: self.rigid }),
            body: None,
            raceways: RacewayMatrices::default(),
        };
        connection.check(&scene.bodies)?;
        scene.connections[self.connection.0] = connection;
        Ok(())
    }

    /// Adds a load at a position of the shaft.
    ///
    /// # Errors
    /// Those of [`ModelShaft::section`].
    pub fn load(
        &self,
        scene: &mut Scene,
        (at, load): (f64, Arc<dyn Load>),
        named: impl Fn(f64) -> String,
    ) -> Result<BodyId, Refusal> {
        let (id, offset) = self.section(scene, at, named)?;
        let body = &mut scene.bodies[id.0];
        let constant = load.is_constant().then(|| load.at(0.0)).filter(|load| load.force == [0.0; 3]);
        let load = match constant {
            Some(moment) => Arc::new(moment),
            None => load_at(load, body.motion.clone(), offset),
        };
        add_load(body, load);
        Ok(id)
    }

    /// Adds a disc at a position of the shaft: its inertia about its centre.
    ///
    /// # Errors
    /// Those of [`ModelShaft::section`].
    pub fn disc(
        &self,
        scene: &mut Scene,
        (at, inertia): (f64, Inertia),
        named: impl Fn(f64) -> String,
    ) -> Result<(), Refusal> {
        let (id, offset) = self.section(scene, at, named)?;
        let body = &mut scene.bodies[id.0];
        body.added = body.added + inertia.shifted_along(offset);
        Ok(())
    }

    /// Mounts a body on the shaft. It takes the place of a section without teeth at its position,
    /// or within its hub. `toothed` returns whether a body carries a gear.
    ///
    /// # Errors
    /// E0859: the hub reaches beyond the shaft, or another gear or several sections are within it.
    /// Otherwise those of [`add_body`].
    pub fn mount(
        &mut self,
        scene: &mut Scene,
        mounted: Mounted,
        toothed: impl Fn(BodyId) -> bool,
        mm: impl Fn(f64) -> String + Copy,
    ) -> Result<MountedBody, Refusal> {
        let joint = self.joint(&mounted, mm)?;
        // The position without rounding errors at the ends of the shaft.
        let at = if mounted.at == mounted.joint { joint } else { mounted.at };
        let ends = match mounted.hub_width {
            // A rigid shaft does not deform within a hub.
            width if width == 0.0 || self.rigid => vec![joint],
            width => vec![
                self.position("hub_width", joint - 0.5 * width, mm)?,
                self.position("hub_width", joint + 0.5 * width, mm)?,
            ],
        };
        let inside: Vec<BodyId> = self.bodies_between(scene, ends[0], ends[ends.len() - 1]);
        if let Some(gear) = inside.iter().copied().find(|body| toothed(*body)) {
            let message = format!(
                "\"{}\" and \"{}\" are at the same position of the shaft \"{}\", {}",
                mounted.name,
                scene.bodies[gear.0].name,
                self.name,
                mm(joint)
            );
            return Err(EngineError::new(
                "E0859",
                message,
                "mount them at different positions, or reduce `hub_width`",
            )
            .blame("at")
            .into());
        }
        let place_of = match inside[..] {
            _ if self.rigid => Some(self.body).filter(|body| !toothed(*body)),
            [] => None,
            [section] => Some(section),
            _ => {
                let message = format!(
                    "the hub of \"{}\" encloses several sections of the shaft \"{}\" with bearings, loads or discs",
                    mounted.name, self.name
                );
                let help = "mount the gear before them, or reduce `hub_width`";
                return Err(EngineError::new("E0859", message, help).blame("hub_width").into());
            }
        };
        let attachments = |body: BodyId| -> Vec<(f64, BodyId, f64)> {
            ends.iter().map(|&end| (end, body, end - at)).collect()
        };
        let Some(section) = place_of else {
            let motion = self.motion_at(scene, at);
            let free = self.free;
            let body = Body {
                name: mounted.name,
                prototype: mounted.prototype,
                motion,
                phase: 0.0,
                free,
                load: mounted.load,
                impulses: Vec::new(),
                added: mounted.added,
            };
            let body = add_body(scene, body)?;
            self.attach(scene, &attachments(body), None)?;
            return Ok(MountedBody { body, new: true });
        };
        self.check_name(scene, section, &mounted.name)?;
        self.move_origin(scene, section, at);
        let body = &mut scene.bodies[section.0];
        body.name = mounted.name;
        body.prototype = mounted.prototype;
        body.added = body.added + mounted.added;
        add_load(body, mounted.load);
        self.attach(scene, &attachments(section), Some(section))?;
        Ok(MountedBody { body: section, new: false })
    }

    /// Returns the position of a joint on the shaft.
    ///
    /// # Errors
    /// E0859: it is off the shaft.
    fn joint(&self, mounted: &Mounted, mm: impl Fn(f64) -> String) -> Result<f64, EngineError> {
        self.shaft.on_shaft(mounted.joint).map_or_else(
            || match mounted.joint == mounted.at {
                true => self.position("at", mounted.at, &mm),
                false => Err(EngineError::new(
                    "E0859",
                    format!(
                        "the middle of the bore of \"{}\" is at {}, off the shaft \"{}\", which is {} long",
                        mounted.name,
                        mm(mounted.joint),
                        self.name,
                        mm(self.shaft.length())
                    ),
                    format!(
                        "`at` is the origin of the gear, the crossing point of the axes; its teeth are {} from there along e3 of the shaft. Correct `at`, or exchange the ends of the shaft",
                        mm(mounted.joint - mounted.at)
                    ),
                )
                .blame("at")),
            },
            Ok,
        )
    }

    fn check_name(&self, scene: &Scene, section: BodyId, name: &str) -> Result<(), EngineError> {
        let taken =
            scene.bodies.iter().enumerate().any(|(index, body)| index != section.0 && body.name == name);
        if !taken {
            return Ok(());
        }
        let message = format!("there are two bodies called \"{name}\"");
        let help = "give each body a name of its own: results refer to bodies by name";
        Err(EngineError::new("E0671", message, help).blame("name"))
    }

    fn bodies_between(&self, scene: &Scene, from: f64, to: f64) -> Vec<BodyId> {
        let slack = SAME_POSITION * self.shaft.length();
        let (stations, attachments) = self.condensed(scene);
        let mut bodies = Vec::new();
        for (&station, attachment) in stations.iter().zip(attachments) {
            if let Support::Body(body) = attachment.to
                && station >= from - slack
                && station <= to + slack
                && !bodies.contains(&body)
            {
                bodies.push(body);
            }
        }
        bodies
    }

    /// Moves the origin of a section's frame along the shaft, with all that refers to it.
    fn move_origin(&mut self, scene: &mut Scene, section: BodyId, at: f64) {
        let old = match section == self.body {
            true => self.origin,
            false => {
                let (stations, attachments) = self.condensed(scene);
                let own = attachments.iter().position(|to| to.to == Support::Body(section));
                own.map_or(at, |index| stations[index] - attachments[index].at[2])
            }
        };
        let distance = at - old;
        if section == self.body {
            self.origin = at;
        }
        if distance == 0.0 {
            return;
        }
        let body = &mut scene.bodies[section.0];
        body.motion = Arc::new(DisplacedAlong { motion: body.motion.clone(), distance });
        body.added = body.added.from([0.0, 0.0, distance]);
        let constant =
            body.load.is_constant().then(|| body.load.at(0.0)).filter(|load| load.force == [0.0; 3]);
        if constant.is_none() {
            body.load = load_at(body.load.clone(), body.motion.clone(), -distance);
        }
        for bearing in scene.bearings.iter_mut().filter(|bearing| bearing.body == section) {
            bearing.at[2] -= distance;
        }
    }

    /// Returns the position relative to the shaft of a point in ground coordinates (m) at time 0.
    ///
    /// # Errors
    /// E0710: the frame is NaN.
    pub fn position_of(&self, scene: &Scene, point: [f64; 3]) -> Result<PointAtShaft, EngineError> {
        let pose = spatial_pose(scene.bodies[self.body.0].motion.as_ref(), 0.0)?;
        let (from, axis) = (minus(point, pose.origin), pose.direction([0.0, 0.0, 1.0]));
        let along = (0..3).map(|k| axis[k] * from[k]).sum::<f64>();
        let beside = length([0, 1, 2].map(|k: usize| from[k] - along * axis[k]));
        Ok(PointAtShaft { position: self.origin + along, beside })
    }
}
