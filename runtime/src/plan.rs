//! What will be modelled, and why: the scene, less what no observable depends on.

use crate::bearing::Bearing;
use crate::cache::Key;
use crate::error::{EngineError, Subject};
use crate::motion::check_in_plane;
use crate::scene::{BodyId, FREEDOMS, Fidelity, Ignored, Prototype, Scene, StructureOptions};
use std::sync::Arc;

/// The decision of how a scene is analysed. Nothing has been solved yet.
#[derive(Clone, Debug)]
pub struct Plan {
    /// How bodies are modelled.
    pub fidelity: Fidelity,
    /// One per body of the scene, in order.
    pub bodies: Vec<BodyPlan>,
    /// One per bearing of the scene, in order.
    pub bearings: Vec<BearingPlan>,
    /// Inputs that this fidelity cannot see.
    pub ignored: Vec<Ignored>,
}

/// What an analysis without rates leaves out of a bearing.
const DAMPING: &str = "damping";

/// How a body is modelled.
#[derive(Clone, Debug)]
pub struct BodyPlan {
    /// How its structure is discretised.
    pub options: StructureOptions,
    /// Why the body is modelled the way it is, or left out.
    pub reason: &'static str,
    /// No output depends on the body: it takes no part.
    pub left_out: bool,
    /// No surface pair touches the body: it is a frame that bearings hold, and its structure is not instantiated.
    pub rigid: bool,
}

impl BodyPlan {
    /// Whether it has a structure.
    pub fn is_elastic(&self) -> bool {
        !self.left_out && !self.rigid
    }
}

/// How a bearing is modelled.
#[derive(Clone, Debug)]
pub struct BearingPlan {
    /// Why the bearing is modelled, or left out.
    pub reason: &'static str,
    /// Nothing depends on what it bears.
    pub left_out: bool,
}

impl Plan {
    /// Plans a scene at a fidelity with the given discretisation (its `stresses` and `sharp_edges` are decided here).
    pub fn new(scene: &Scene, fidelity: Fidelity, options: StructureOptions) -> Result<Plan, EngineError> {
        let pairs_of = |id: BodyId| scene.pairs.iter().filter(move |pair| pair.bodies.contains(&id));
        let template = match fidelity {
            Fidelity::Plane => options.template,
            Fidelity::Solid(template) => template,
        };
        let wanted = wanted_bodies(scene);
        let mut bodies = Vec::new();
        let mut ignored: Vec<Ignored> = Vec::new();
        for (index, body) in scene.bodies.iter().enumerate() {
            let id = BodyId(index);
            let stresses = scene.observables.iter().any(|observable| observable.stresses_of() == Some(id));
            let untouched = pairs_of(id).next().is_none();
            let left_out = !wanted[index];
            let rigid = untouched && !left_out;
            let sharp_edges = pairs_of(id).all(|pair| !pair.grid.edges);
            if !untouched {
                ignored.extend(body.prototype.ignored(fidelity));
            }
            if fidelity == Fidelity::Plane && !left_out {
                refuse_motion_out_of_plane(&body.name, body.free)
                    .and_then(|()| check_in_plane(body.motion.as_ref()))
                    .map_err(|error| error.about(Subject::Body(index)))?;
            }
            if !untouched && !left_out && body.prototype.lug_contact().is_some() {
                refuse_lugs(&body.name, fidelity, body.free)
                    .map_err(|error| error.about(Subject::Body(index)))?;
            }
            bodies.push(BodyPlan {
                options: StructureOptions { stresses, sharp_edges, template, ..options },
                reason: match (left_out, stresses) {
                    (true, _) => "left out: it touches nothing",
                    (false, _) if rigid => {
                        "rigid: no surface of it touches anything, and bearings hold its frame"
                    }
                    (false, true) => "elastic, with stress recovery: an output asks for its root stress",
                    (false, false) => "elastic, without stress recovery: no output asks for its stress",
                },
                left_out,
                rigid,
            });
        }
        if fidelity == Fidelity::Plane {
            ignored.extend(unequal_widths(scene, &bodies));
        }
        let bearings: Vec<BearingPlan> =
            scene.bearings.iter().map(|bearing| plan_bearing(scene, &bodies, bearing)).collect();
        let modelled = scene.bearings.iter().zip(&bearings).filter(|(_, plan)| !plan.left_out);
        ignored.extend(modelled.flat_map(|(bearing, _)| unseen_of(bearing, fidelity)));
        ignored.sort();
        ignored.dedup();
        Ok(Plan { fidelity, bodies, bearings, ignored })
    }

    /// The plan of an analysis in time, which sees rates.
    pub fn in_time(mut self) -> Plan {
        self.ignored.retain(|unseen| unseen.input != DAMPING);
        self
    }

    /// Indices of the bearings that are modelled.
    pub(crate) fn modelled_bearings(&self) -> Vec<usize> {
        (0..self.bearings.len()).filter(|&bearing| !self.bearings[bearing].left_out).collect()
    }

    /// Which structure each body has, counted from 0; `None` for a body that is left out or rigid. Bodies whose structures would be
    /// equal share one.
    pub fn structures(&self, scene: &Scene) -> Vec<Option<usize>> {
        let mut known: Vec<Identity> = Vec::new();
        let planned = scene.bodies.iter().zip(&self.bodies);
        let number = planned.map(|(body, plan)| {
            let key = Identity::of(&body.prototype, self.fidelity, &plan.options);
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

/// What tells structures apart, stresses aside: one that has them serves those that need none.
#[derive(PartialEq)]
enum Identity {
    Content(Key),
    Prototype(*const (), bool),
}

impl Identity {
    fn of(prototype: &Arc<dyn Prototype>, fidelity: Fidelity, options: &StructureOptions) -> Identity {
        let without_stresses = StructureOptions { stresses: false, ..*options };
        let key = match fidelity {
            Fidelity::Plane => prototype.key(&without_stresses),
            Fidelity::Solid(_) => prototype.solid_key(&without_stresses),
        };
        match key {
            Some(key) => Identity::Content(key),
            None => Identity::Prototype(Arc::as_ptr(prototype).cast::<()>(), options.sharp_edges),
        }
    }
}

/// Which bodies take part: those that touch or that an output asks for, and what bearings connect with them.
fn wanted_bodies(scene: &Scene) -> Vec<bool> {
    let mut wanted = vec![false; scene.bodies.len()];
    // A body that no bearing holds rests where its frame says.
    let held =
        |body: &BodyId| scene.bearings.iter().any(|bearing| bearing.bodies().any(|other| other == *body));
    let touching = scene.pairs.iter().flat_map(|pair| pair.bodies);
    let looked_at = scene.observables.iter().filter_map(|observable| observable.frame_of()).filter(held);
    let bearings = scene.observables.iter().filter_map(|observable| observable.bearing_of());
    let borne = bearings.filter_map(|bearing| scene.bearings.get(bearing.0)).flat_map(Bearing::bodies);
    let mut more: Vec<BodyId> = touching.chain(looked_at).chain(borne).collect();
    while let Some(body) = more.pop() {
        match wanted.get_mut(body.0) {
            Some(wanted) if !*wanted => *wanted = true,
            _ => continue,
        }
        let of_body = scene.bearings.iter().filter(|bearing| bearing.bodies().any(|other| other == body));
        more.extend(of_body.flat_map(Bearing::bodies));
    }
    wanted
}

fn plan_bearing(scene: &Scene, bodies: &[BodyPlan], bearing: &Bearing) -> BearingPlan {
    let unwanted = bearing.bodies().all(|body| bodies.get(body.0).is_none_or(|plan| plan.left_out));
    let moves = |body: BodyId| scene.bodies.get(body.0).is_some_and(|body| body.free.contains(&true));
    let idle = !bearing.bodies().any(moves) && bearing.is_unloaded_at_rest();
    BearingPlan {
        reason: match (unwanted, idle) {
            (true, _) => "left out: no output depends on what it connects",
            (_, true) => "left out: the frames on both sides are held, and it has no load of its own",
            _ => "a stiffness between the frames of its races",
        },
        left_out: unwanted || idle,
    }
}

/// What of a bearing an analysis cannot see.
fn unseen_of(bearing: &Bearing, fidelity: Fidelity) -> Vec<Ignored> {
    let mut unseen = Vec::new();
    if bearing.damping.iter().flatten().any(|&entry| entry != 0.0) {
        unseen.push(Ignored {
            input: DAMPING.into(),
            reason: "a quasi-static analysis leaves rates out, and with them what bearings damp".into(),
        });
    }
    let out_of_plane = |row: &usize| bearing.stiffness[*row].iter().any(|&entry| entry != 0.0);
    if fidelity == Fidelity::Plane && [2, 3, 4].iter().any(out_of_plane) {
        unseen.push(Ignored {
            input: "bearing".into(),
            reason:
                "in a plane model bearings hold u_x, u_y and theta_z; u_z, theta_x and theta_y do not move"
                    .into(),
        });
    }
    unseen
}

/// A plane model has no forces across the plane, so nothing could hold such a freedom.
fn refuse_motion_out_of_plane(body: &str, free: [bool; 6]) -> Result<(), EngineError> {
    match [2, 3, 4].into_iter().find(|&freedom| free[freedom]) {
        Some(freedom) => Err(EngineError::new(
            "E0611",
            format!(
                "body \"{body}\" is free in {}, and in a plane model nothing can hold it there",
                FREEDOMS[freedom]
            ),
            "remove it from `free`; the plane model has \"u_x\", \"u_y\" and \"theta_z\"",
        )
        .blame("free")),
        None => Ok(()),
    }
}

/// Lugs with clearance carry a body that its frame lets go, and are contact in the plane.
fn refuse_lugs(body: &str, fidelity: Fidelity, free: [bool; 6]) -> Result<(), EngineError> {
    if fidelity != Fidelity::Plane {
        return Err(EngineError::new(
            "E0756",
            format!("the lugs of body \"{body}\" have clearance, and in space they cannot"),
            "choose the fidelity \"plane\", or leave `clearance` out: then lugs bear both ways, without play",
        ));
    }
    if !free[5] {
        return Err(EngineError::new(
            "E0755",
            format!("the lugs of body \"{body}\" have clearance, and its frame cannot turn to use it up"),
            "free it, `free = [\"u_x\", \"u_y\", \"theta_z\"]`: the lugs carry it; or leave `clearance` out: then they hold it as the frame does",
        )
        .blame("free"));
    }
    Ok(())
}

/// A plane model spreads every force over one width, the smallest: what is wider is not seen to be.
fn unequal_widths(scene: &Scene, bodies: &[BodyPlan]) -> Option<Ignored> {
    let modelled = scene.bodies.iter().zip(bodies).filter(|(_, plan)| plan.is_elastic());
    let widths: Vec<f64> = modelled.map(|(body, _)| body.prototype.face_width()).collect();
    let smallest = widths.iter().copied().fold(f64::INFINITY, f64::min);
    let wider = widths.iter().any(|&width| width > smallest * (1.0 + 1e-9));
    wider.then(|| Ignored {
        input: "face_width".into(),
        // To the digits that a conversion of units leaves right.
        reason: format!(
            "a plane model has one width, and all bodies are taken as wide as the narrowest, {} mm",
            (smallest * 1e9).round() / 1e6
        ),
    })
}
