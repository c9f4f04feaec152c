//! Plan of an analysis: the modelled part of the scene, the models of its bodies, and the reasons.
//! Parts that no observable depends on are left out.

mod bearings;
mod connections;
mod unsupported_output;

pub use self::connections::ConnectionPlan;
pub use self::unsupported_output::UnsupportedOutput;

use self::bearings::{ignored_bearing_inputs, plan_bearing};
use crate::bearing::Bearing;
use crate::body::Body;
use crate::connection::ElasticConnection;
use crate::dof::DOF_NAMES;
use crate::elastic_body::MassReduction;
use crate::fidelity::{BodyModel, Fidelity, StructureOptions};
use crate::ids::BodyId;
use crate::load::Wrench;
use crate::mechanism::Mechanism;
use crate::motion::{check_in_plane, spatial_pose};
use crate::observed::OutputRequest;
use crate::prototype::{Ignored, Prototype};
use crate::target::{Examined, Target};
use crate::unused_settings::unused_settings;
use calyx_numerics::error::{EngineError, Subject};
use calyx_structure::cache::Key;
use std::sync::Arc;

/// Decisions on the analysis of a scene, before anything is solved.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Fidelity level of the bodies.
    pub fidelity: Fidelity,
    /// True if the model is three-dimensional, false if it is a plane section.
    pub three_dimensional: bool,
    /// Outputs without a value, because they require more than this fidelity provides.
    pub refused: Vec<UnsupportedOutput>,
    /// Plan of each body, in the order of the scene.
    pub bodies: Vec<BodyPlan>,
    /// Plan of each bearing, in the order of the scene.
    pub bearings: Vec<BearingPlan>,
    /// Plan of each elastic connection, in the order of the scene.
    pub connections: Vec<ConnectionPlan>,
    /// Inputs that this fidelity ignores.
    pub ignored: Vec<Ignored>,
}

/// Bearing input that a quasi-static analysis ignores.
const DAMPING: &str = "damping";

/// Plan of a body.
#[derive(Clone, Debug)]
pub struct BodyPlan {
    /// Name in the scene.
    pub name: String,
    /// Discretization of its structure.
    pub options: StructureOptions,
    /// Reason for the model of the body, or for leaving it out.
    pub reason: &'static str,
    /// True if no output depends on the body; it is not modelled.
    pub left_out: bool,
    /// True if the body is in no surface pair: it is a frame on bearings, and its structure is not
    /// built.
    pub rigid: bool,
}

impl BodyPlan {
    /// Returns whether the body has a structure.
    pub fn is_elastic(&self) -> bool {
        !self.left_out && !self.rigid
    }
}

/// Plan of a bearing.
#[derive(Clone, Debug)]
pub struct BearingPlan {
    /// Name in the scene.
    pub name: String,
    /// Reason for modelling the bearing, or for leaving it out.
    pub reason: &'static str,
    /// True if no output depends on the bearing; it is not modelled.
    pub left_out: bool,
}

impl Plan {
    /// Former name of the field [`Plan::three_dimensional`].
    #[deprecated(since = "0.1.0", note = "use the field `three_dimensional`")]
    pub fn in_space(&self) -> bool {
        self.three_dimensional
    }

    /// Plans the equilibrium of a scene at a fidelity with the given discretization; the plan sets
    /// `stresses` and `sharp_edges` itself. Bodies and bearings outside the load paths of the
    /// observables are left out.
    ///
    /// # Errors
    /// The scene requires something that the fidelity does not support.
    pub fn new(
        scene: &dyn Examined,
        fidelity: Fidelity,
        options: StructureOptions,
    ) -> Result<Plan, EngineError> {
        let (mechanism, targets) = (scene.mechanism(), scene.targets());
        let path = load_path(mechanism, &targets, scene.examines_modes());
        Plan::of((mechanism, &targets, scene.examines_modes()), path, fidelity, options)
    }

    /// Plans like [`Plan::new`], but keeps all bodies in surface pairs, whether observables depend
    /// on them or not.
    ///
    /// # Errors
    /// Those of [`Plan::new`].
    pub fn whole(
        scene: &dyn Examined,
        fidelity: Fidelity,
        options: StructureOptions,
    ) -> Result<Plan, EngineError> {
        Plan::of_everything(scene, fidelity, options, scene.examines_modes())
    }

    fn of_everything(
        scene: &dyn Examined,
        fidelity: Fidelity,
        options: StructureOptions,
        vibrations: bool,
    ) -> Result<Plan, EngineError> {
        let (mechanism, targets) = (scene.mechanism(), scene.targets());
        let everything =
            connected_bodies(mechanism, observed_bodies(mechanism, &targets).chain(loaded(mechanism)));
        Plan::of((mechanism, &targets, vibrations), everything, fidelity, options)
    }

    fn of(
        (scene, targets, vibrations): (&Mechanism, &[Target], bool),
        wanted: Vec<bool>,
        fidelity: Fidelity,
        options: StructureOptions,
    ) -> Result<Plan, EngineError> {
        let pairs_of = |id: BodyId| scene.pairs.iter().filter(move |pair| pair.bodies.contains(&id));
        let (model, three_dimensional) = (fidelity.body_model(), is_three_dimensional(scene, fidelity));
        let template = match fidelity {
            Fidelity::Solid(template) => template,
            Fidelity::Rigid | Fidelity::Analytic | Fidelity::Plane => options.template,
        };
        let mut bodies = Vec::new();
        let mut ignored: Vec<Ignored> = Vec::new();
        for (index, body) in scene.bodies.iter().enumerate() {
            let id = BodyId(index);
            let stresses = targets.iter().any(|target| target.stresses_of == Some(id));
            let untouched = pairs_of(id).next().is_none();
            let left_out = !wanted[index];
            let rigid = untouched && !left_out;
            let sharp_edges = pairs_of(id).all(|pair| !pair.grid.edges);
            if !untouched {
                ignored.extend(body.prototype.ignored(fidelity));
                // Report what a section cannot represent if something else keeps the scene plane.
                if !three_dimensional && fidelity != Fidelity::Plane && body.prototype.needs_solid_model() {
                    ignored.extend(body.prototype.ignored(Fidelity::Plane));
                }
            }
            if !three_dimensional && !left_out {
                connections::refuse_bending_in_plane(scene, id, body.free)
                    .and_then(|()| refuse_motion_out_of_plane(&body.name, body.free))
                    .and_then(|()| check_in_plane(body.motion.as_ref()))
                    .map_err(|error| error.about(Subject::Body(index)))?;
            }
            if !untouched && !left_out && body.prototype.spline_contact().is_some() {
                reject_spline_with_clearance(&body.name, fidelity, three_dimensional, body.free)
                    .map_err(|error| error.about(Subject::Body(index)))?;
            }
            let options = StructureOptions { stresses, sharp_edges, model, template, ..options };
            if !untouched && !left_out {
                let checked = body.prototype.check(&options, three_dimensional);
                checked.map_err(|error| error.about(Subject::Prototype(index)))?;
            }
            bodies.push(BodyPlan {
                name: body.name.clone(),
                options,
                reason: match (left_out, stresses) {
                    (true, _) if untouched => "left out: it touches nothing",
                    (true, _) => "left out: no load goes through it to a body that an output observes",
                    (false, _) if rigid && connections::is_section(scene, id) => {
                        "section of a shaft, or another part of an elastic connection without contact"
                    }
                    (false, _) if rigid => "rigid: it has no contact, and bearings support its frame",
                    (false, _) if model == BodyModel::Rigid => {
                        "rigid at this fidelity: its surfaces touch others in the limit of vanishing load"
                    }
                    (false, true) => "elastic, with stress recovery: an output asks for its root stress",
                    (false, false) => "elastic, without stress recovery: no output asks for its stress",
                },
                left_out,
                rigid,
            });
        }
        ignored.extend(unused_settings(scene, fidelity, three_dimensional, &options));
        if !three_dimensional {
            ignored.extend(unequal_widths(scene, &bodies));
            ignored.extend(out_of_plane(scene, targets, &bodies));
        }
        let bearings: Vec<BearingPlan> =
            scene.bearings.iter().map(|bearing| plan_bearing(scene, &bodies, bearing)).collect();
        let modelled = scene.bearings.iter().zip(&bearings).filter(|(_, plan)| !plan.left_out);
        ignored.extend(modelled.flat_map(|(bearing, _)| ignored_bearing_inputs(bearing, three_dimensional)));
        let vibrations = targets.iter().any(|target| target.mode.is_some()) || vibrations;
        let treatment = (fidelity, &options, vibrations);
        let connections = connections::plan_connections(scene, &bodies, treatment);
        connections::check_bodies(scene, &connections, fidelity)?;
        ignored.extend(connections::ignored_inputs(scene, &connections));
        ignored.sort();
        ignored.dedup();
        Ok(Plan { fidelity, three_dimensional, refused: Vec::new(), bodies, bearings, connections, ignored })
    }

    /// Restricts the plan to an analysis with these outputs.
    ///
    /// # Errors
    /// E0780: the fidelity provides none of the outputs.
    pub fn for_outputs(
        mut self,
        scene: &dyn Examined,
        outputs: &[OutputRequest],
    ) -> Result<Plan, EngineError> {
        self.refused = UnsupportedOutput::of(scene, outputs, self.fidelity);
        match self.refused.first().filter(|_| self.refused.len() == outputs.len()) {
            Some(refused) => Err(refused.error(self.fidelity)),
            None => Ok(self),
        }
    }

    /// Plans a transient analysis, which includes rates, and the inertia of bodies without load.
    ///
    /// # Errors
    /// Those of [`Plan::new`].
    pub fn in_time(
        scene: &dyn Examined,
        fidelity: Fidelity,
        options: StructureOptions,
    ) -> Result<Plan, EngineError> {
        let mut plan = Plan::of_everything(scene, fidelity, options, true)?;
        plan.ignored.retain(|unseen| unseen.input != DAMPING);
        Ok(plan)
    }

    /// Adds the modes of bodies up to a natural frequency (Hz); 0 adds none. In three dimensions
    /// these are the component modes of elastic bodies; gears vibrate as rigid bodies.
    pub fn with_modes(mut self, scene: &Mechanism, highest: f64) -> Plan {
        let in_space = highest > 0.0 && self.three_dimensional;
        for connection in self.connections.iter_mut().filter(|plan| in_space && plan.mass.has_mass()) {
            connection.mass = MassReduction::ComponentModes(highest);
        }
        let in_plane = highest > 0.0 && !self.three_dimensional;
        let modelled =
            scene.bodies.iter().zip(&self.bodies).filter(|(_, plan)| in_plane && plan.is_elastic());
        let rigid =
            |(body, _): (&Body, _)| Some(format!("\"{}\": {}", body.name, body.prototype.without_modes()?));
        let rigid: Vec<String> = modelled.filter_map(rigid).collect();
        if !rigid.is_empty() {
            let bodies = rigid.join("; ");
            let reason = format!("some bodies vibrate as rigid bodies on their elastic teeth, {bodies}");
            self.ignored.push(Ignored { input: "highest_frequency".into(), reason });
        }
        let twisted =
            self.modelled_connections().into_iter().any(|index| scene.connections[index].has_modes());
        if in_plane && twisted {
            let reason = "in a two-dimensional model shafts have the mass of their sections, without modes between them";
            self.ignored.push(Ignored { input: "highest_frequency".into(), reason: reason.into() });
        }
        self.ignored.sort();
        self.ignored.dedup();
        self
    }

    /// Returns the indices of the modelled bearings.
    pub fn modelled_bearings(&self) -> Vec<usize> {
        (0..self.bearings.len()).filter(|&bearing| !self.bearings[bearing].left_out).collect()
    }

    /// Returns the indices of the modelled elastic connections.
    pub fn modelled_connections(&self) -> Vec<usize> {
        (0..self.connections.len()).filter(|&connection| !self.connections[connection].left_out).collect()
    }

    /// Returns the number of each body's structure, counted from 0; `None` for a body that is left
    /// out or rigid. Bodies with equal structures share one.
    pub fn structures(&self, scene: &Mechanism) -> Vec<Option<usize>> {
        let mut known: Vec<Identity> = Vec::new();
        let planned = scene.bodies.iter().zip(&self.bodies);
        let number = planned.map(|(body, plan)| {
            let key = Identity::of(&body.prototype, self.three_dimensional, &plan.options);
            plan.is_elastic().then(|| {
                known.iter().position(|other| *other == key).unwrap_or_else(|| {
                    known.push(key);
                    known.len() - 1
                })
            })
        });
        number.collect()
    }
}

/// Identity of a structure, without regard to stresses: a structure with stresses also serves
/// bodies that need none.
#[derive(PartialEq)]
enum Identity {
    Content(Key),
    Prototype(*const (), bool),
}

impl Identity {
    fn of(prototype: &Arc<dyn Prototype>, three_dimensional: bool, options: &StructureOptions) -> Identity {
        let without_stresses = StructureOptions { stresses: false, ..*options };
        let key = match three_dimensional {
            false => prototype.key(&without_stresses),
            true => prototype.solid_key(&without_stresses),
        };
        match key {
            Some(key) => Identity::Content(key),
            None => Identity::Prototype(Arc::as_ptr(prototype).cast::<()>(), options.sharp_edges),
        }
    }
}

/// Returns whether a scene is modelled in three dimensions. If the fidelity permits both, this is
/// so if a section cannot represent the scene.
///
/// Spline teeth with clearance are modelled as plane contact, so such scenes remain plane.
pub fn is_three_dimensional(scene: &Mechanism, fidelity: Fidelity) -> bool {
    let leaves_plane = |body: &Body| {
        body.prototype.needs_solid_model()
            || [2, 3, 4].iter().any(|&dof| body.free[dof])
            || check_in_plane(body.motion.as_ref()).is_err_and(|error| error.code == "E0610")
    };
    match fidelity {
        Fidelity::Plane => false,
        Fidelity::Solid(_) => true,
        Fidelity::Rigid | Fidelity::Analytic => {
            let with_clearance = scene.bodies.iter().any(|body| body.prototype.spline_contact().is_some());
            !with_clearance && scene.bodies.iter().any(leaves_plane)
        }
    }
}

/// Returns the bodies in surface pairs.
fn touching(scene: &Mechanism) -> impl Iterator<Item = BodyId> {
    scene.pairs.iter().flat_map(|pair| pair.bodies)
}

/// Returns the bodies that loads act on: those in surface pairs. A scene without surface pairs is
/// one of bodies on bearings and elastic connections, such as a rotor.
fn loaded(scene: &Mechanism) -> Vec<BodyId> {
    if !scene.pairs.is_empty() {
        return touching(scene).collect();
    }
    let connections = scene.connections.iter().flat_map(ElasticConnection::bodies);
    scene.bearings.iter().flat_map(Bearing::bodies).chain(connections).collect()
}

/// Returns the bodies that an observable names. Bodies without contact and bearings are excluded,
/// because they stay at their prescribed position.
fn named_by(scene: &Mechanism, target: &Target) -> Vec<BodyId> {
    let moves = |body: &BodyId| {
        let borne = scene.bearings.iter().flat_map(Bearing::bodies).any(|other| other == *body);
        borne || scene.connections_of(*body).next().is_some() || touching(scene).any(|other| other == *body)
    };
    let bearing = target.bearing_of.and_then(|bearing| scene.bearings.get(bearing.0));
    let pair = target.pair_of.and_then(|pair| scene.pairs.get(pair.0));
    let alone = target.frame_of.into_iter().chain(target.stresses_of).filter(moves);
    alone
        .chain(bearing.into_iter().flat_map(Bearing::bodies))
        .chain(pair.into_iter().flat_map(|pair| pair.bodies))
        .collect()
}

/// Returns the bodies that an observable depends on: all that loads act on if it names none.
pub fn depends_on(scene: &Mechanism, target: &Target) -> Vec<BodyId> {
    let named = named_by(scene, target);
    if target.is_everything() { named.into_iter().chain(loaded(scene)).collect() } else { named }
}

/// Returns the bodies that the observables of the scene name.
fn observed_bodies(scene: &Mechanism, targets: &[Target]) -> impl Iterator<Item = BodyId> {
    targets.iter().flat_map(|target| named_by(scene, target))
}

/// Returns which bodies lie on the load paths of the observables: those connected to observed
/// bodies by surface pairs or bearings, transitively. Includes all bodies that loads act on if
/// nothing is observed, no observed body is in contact, or an observable concerns the whole system,
/// such as vibrations.
fn load_path(scene: &Mechanism, targets: &[Target], modes_table: bool) -> Vec<bool> {
    let whole = targets.is_empty() || modes_table || targets.iter().any(Target::is_everything);
    let everything = || connected_bodies(scene, observed_bodies(scene, targets).chain(loaded(scene)));
    if whole {
        return everything();
    }
    let path = connected_bodies(scene, observed_bodies(scene, targets));
    // If the scene has surface pairs, the equilibrium is one of contact: a body on bearings alone
    // takes part only together with bodies in contact.
    let touches = scene.pairs.is_empty() || touching(scene).any(|body| path.get(body.0) == Some(&true));
    if touches { path } else { everything() }
}

/// Returns these bodies and all that surface pairs, bearings or elastic connections connect to
/// them.
fn connected_bodies(scene: &Mechanism, bodies: impl Iterator<Item = BodyId>) -> Vec<bool> {
    let mut wanted = vec![false; scene.bodies.len()];
    let mut more: Vec<BodyId> = bodies.collect();
    while let Some(body) = more.pop() {
        match wanted.get_mut(body.0) {
            Some(wanted) if !*wanted => *wanted = true,
            _ => continue,
        }
        let bearings = scene.bearings.iter().filter(|bearing| bearing.bodies().any(|other| other == body));
        more.extend(bearings.flat_map(Bearing::bodies));
        more.extend(scene.connections_of(body).flat_map(ElasticConnection::bodies));
        let pairs = scene.pairs.iter().filter(|pair| pair.bodies.contains(&body));
        more.extend(pairs.flat_map(|pair| pair.bodies));
    }
    wanted
}

/// Rejects free out-of-plane components in a plane model, which has no forces to resist them.
fn refuse_motion_out_of_plane(body: &str, free: [bool; 6]) -> Result<(), EngineError> {
    match [2, 3, 4].into_iter().find(|&dof| free[dof]) {
        Some(dof) => Err(EngineError::new(
            "E0611",
            format!(
                "body \"{body}\" is free in {}, which a two-dimensional model does not have",
                DOF_NAMES[dof]
            ),
            "remove it from `free`: the degrees of freedom of a plane model are \"u_x\", \"u_y\" and \"theta_z\"",
        )
        .blame("free")),
        None => Ok(()),
    }
}

/// Rejects spline teeth with clearance where they are not supported: in three-dimensional models,
/// in analytic models (no closed-form compliance of the ring), and on a body whose rotation is
/// constrained.
fn reject_spline_with_clearance(
    body: &str,
    fidelity: Fidelity,
    three_dimensional: bool,
    free: [bool; 6],
) -> Result<(), EngineError> {
    if fidelity == Fidelity::Analytic {
        return Err(EngineError::new(
            "E0783",
            format!(
                "body \"{body}\" is on a spline with clearance, and the fidelity level \"analytic\" has no closed form for its compliance"
            ),
            "remove `clearance`: closed forms assume a rim that is supported all around",
        ));
    }
    if three_dimensional {
        return Err(EngineError::new(
            "E0756",
            format!(
                "the spline of body \"{body}\" has clearance, which three-dimensional models do not support"
            ),
            "remove `clearance` for a spline without backlash",
        ));
    }
    if !free[5] {
        return Err(EngineError::new(
            "E0755",
            format!("the spline of body \"{body}\" has clearance, but its frame is constrained in rotation"),
            "free the body, `free = [\"u_x\", \"u_y\", \"theta_z\"]`, so that the spline supports it; or remove `clearance`",
        )
        .blame("free"));
    }
    Ok(())
}

/// Returns the width of each body in a plane model, m. Loads pass between bodies, so connected
/// bodies share one width, the smallest of those in contact, or of all if none is in contact.
/// Leaving a part out does not change a width, because everything that loads it is left out too.
pub fn face_widths(scene: &Mechanism) -> Vec<f64> {
    let touching: Vec<BodyId> = touching(scene).collect();
    let narrowest = |among: &dyn Fn(&BodyId) -> bool| {
        let widths = touching.iter().filter(|body| among(body));
        widths
            .filter_map(|body| Some(scene.bodies.get(body.0)?.prototype.face_width()))
            .fold(f64::INFINITY, f64::min)
    };
    // Without surface pairs there are no line loads, and any width has the same result.
    let all = Some(narrowest(&|_| true)).filter(|width| width.is_finite()).unwrap_or(1.0);
    let mut widths = vec![None; scene.bodies.len()];
    for body in 0..scene.bodies.len() {
        if widths[body].is_none() {
            let together = connected_bodies(scene, std::iter::once(BodyId(body)));
            let width = narrowest(&|body| together.get(body.0) == Some(&true));
            let known = Some(if width.is_finite() { width } else { all });
            widths.iter_mut().zip(together).filter(|(_, along)| *along).for_each(|(width, _)| *width = known);
        }
    }
    widths.into_iter().map(|width| width.unwrap_or(all)).collect()
}

/// Returns the face widths that a plane model ignores.
fn unequal_widths(scene: &Mechanism, bodies: &[BodyPlan]) -> Vec<Ignored> {
    let modelled = scene.bodies.iter().zip(bodies).zip(face_widths(scene));
    let wider = modelled.filter(|((body, plan), width)| {
        plan.is_elastic() && body.prototype.face_width() > width * (1.0 + 1e-9)
    });
    let ignored = wider.map(|(_, width)| Ignored {
        input: "face_width".into(),
        reason: format!(
            "a plane model has one face width for all connected bodies, the smallest one: {} mm",
            rounded_mm(width)
        ),
    });
    ignored.collect()
}

/// Returns the out-of-plane components of loads, frames and probes that a plane model ignores.
fn out_of_plane(scene: &Mechanism, targets: &[Target], bodies: &[BodyPlan]) -> Vec<Ignored> {
    let ignored = |input: &str, reason: String| Ignored { input: input.into(), reason };
    let mut found = Vec::new();
    let modelled = scene.bodies.iter().zip(bodies).filter(|(_, plan)| !plan.left_out);
    for (body, _) in modelled {
        let Wrench { force, moment } = body.load.at(0.0);
        let about = "a plane model has no face-width direction (e3), so the support of body";
        if force[2] != 0.0 {
            found.push(ignored("force", format!("{about} \"{}\" carries its force along e3", body.name)));
        }
        if moment[0] != 0.0 || moment[1] != 0.0 {
            found.push(ignored(
                "moment",
                format!("{about} \"{}\" carries its moment about e1 and e2", body.name),
            ));
        }
    }
    for pair in scene.pairs.iter().filter(|pair| pair.front.is_none()) {
        let members = pair.bodies.map(|body| (&scene.bodies[body.0], &bodies[body.0]));
        if members.iter().any(|(_, plan)| plan.left_out) {
            continue;
        }
        let [first, second] = members.map(|(body, _)| {
            let middle = spatial_pose(body.motion.as_ref(), 0.0).map_or(0.0, |pose| pose.origin[2]);
            let half = 0.5 * body.prototype.face_width();
            [middle - half, middle + half]
        });
        let common = first[1].min(second[1]) - first[0].max(second[0]);
        let narrowest = (first[1] - first[0]).min(second[1] - second[0]);
        if common < narrowest * (1.0 - 1e-9) {
            let [one, other] = members.map(|(body, _)| &body.name);
            found.push(ignored(
                "frame",
                format!(
                    "a plane model has no face-width direction (e3): the faces of \"{one}\" and \"{other}\" overlap by {} mm, and the model assumes contact over {} mm",
                    rounded_mm(common),
                    rounded_mm(narrowest)
                ),
            ));
        }
    }
    if targets.iter().any(|target| target.off_middle) {
        found.push(ignored(
            "axial",
            "a plane model does not vary along the face, so the axial position of a gauge has no effect"
                .into(),
        ));
    }
    found
}

/// Rounds a length in mm to the digits that are exact after a conversion of units.
fn rounded_mm(length: f64) -> f64 {
    (length * 1e9).round() / 1e6
}
