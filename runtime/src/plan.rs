//! What will be modelled, and why: the scene, less what no observable depends on.

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
    /// Inputs that this fidelity cannot see.
    pub ignored: Vec<Ignored>,
}

/// How a body is modelled.
#[derive(Clone, Debug)]
pub struct BodyPlan {
    /// How its structure is discretised.
    pub options: StructureOptions,
    /// Why the body is modelled the way it is, or left out.
    pub reason: &'static str,
    /// No surface pair touches the body: it is not instantiated.
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
        let mut bodies = Vec::new();
        let mut ignored: Vec<Ignored> = Vec::new();
        for (index, body) in scene.bodies.iter().enumerate() {
            let id = BodyId(index);
            let stresses = scene.observables.iter().any(|observable| observable.stresses_of() == Some(id));
            let left_out = pairs_of(id).next().is_none();
            let sharp_edges = pairs_of(id).all(|pair| !pair.grid.edges);
            if !left_out {
                ignored.extend(body.prototype.ignored(fidelity));
            }
            if fidelity == Fidelity::Plane && !left_out {
                refuse_motion_out_of_plane(&body.name, body.free)
                    .and_then(|()| check_in_plane(body.motion.as_ref()))
                    .map_err(|error| error.about(Subject::Body(index)))?;
            }
            bodies.push(BodyPlan {
                options: StructureOptions { stresses, sharp_edges, template, ..options },
                reason: match (left_out, stresses) {
                    (true, _) => "left out: it touches nothing",
                    (false, true) => "elastic, with stress recovery: an output asks for its root stress",
                    (false, false) => "elastic, without stress recovery: no output asks for its stress",
                },
                left_out,
            });
        }
        if fidelity == Fidelity::Plane {
            ignored.extend(unequal_widths(scene, &bodies));
        }
        ignored.sort();
        ignored.dedup();
        Ok(Plan { fidelity, bodies, ignored })
    }

    /// Which structure each body has, counted from 0; `None` for a body that is left out. Bodies whose structures would be
    /// equal share one.
    pub fn structures(&self, scene: &Scene) -> Vec<Option<usize>> {
        let mut known: Vec<Identity> = Vec::new();
        let planned = scene.bodies.iter().zip(&self.bodies);
        let number = planned.map(|(body, plan)| {
            let key = Identity::of(&body.prototype, self.fidelity, &plan.options);
            (!plan.left_out).then(|| {
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

/// A plane model spreads every force over one width, the smallest: what is wider is not seen to be.
fn unequal_widths(scene: &Scene, bodies: &[BodyPlan]) -> Option<Ignored> {
    let modelled = scene.bodies.iter().zip(bodies).filter(|(_, plan)| !plan.left_out);
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
