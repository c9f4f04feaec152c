//! What can be read off a solved position.

use crate::contact::pressure::Peak;
use crate::motion::PlanePose;
use crate::results::{Observed, Place};
use crate::scene::{BodyId, GearMesh, Observable, PairId};
use crate::step::{Patch, StepResult};
use crate::structure::{Chart, StressPlace, Structure, SurfaceLoad};
use crate::system::{Freedom, System};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::PI;

const THETA_Z: usize = 5;

impl System<'_> {
    /// The value of an observable at a solved position.
    pub fn value(&self, step: &StepResult, observable: Observable) -> Observed {
        match observable {
            Observable::TransmissionError(pair) => self.transmission_error(step, pair),
            Observable::LoadShare(pair) => self.load_share(step, pair),
            Observable::MeshStiffness(pair) => self.mesh_stiffness(step, pair),
            Observable::MaxContactPressure(pair) => self.max_pressure(step, pair, false),
            Observable::MaxEdgePressure(pair) => self.max_pressure(step, pair, true),
            Observable::MaxRootStress(body) => self.max_root_stress(step, body),
        }
    }

    /// What contact does to a body's frame, in the order of [`crate::scene::FREEDOMS`]: force (N) and moment about the
    /// frame's origin (N m), along ground axes. Over all bodies forces, and moments about any one point, add up to zero.
    ///
    /// On a free freedom it balances the external load; what holds a held one bears it together with the load.
    pub fn contact_force(&self, step: &StepResult, body: BodyId) -> [f64; 6] {
        let pose = PlanePose::of(self.scene.bodies[body.0].motion.as_ref(), step.time);
        let origin = pose.map_or([f64::NAN; 2], |pose| pose.origin);
        let mut total = [0.0; 6];
        for patch in &step.patches {
            let bodies = self.scene.pairs[patch.pair].bodies;
            let force = self.face_width * patch.force();
            for side in (0..2).filter(|&side| bodies[side] == body) {
                total[0] += force * patch.frame.translation_arm(side, [1.0, 0.0]);
                total[1] += force * patch.frame.translation_arm(side, [0.0, 1.0]);
                total[THETA_Z] += force * patch.frame.rotation_arm(side, origin);
            }
        }
        total
    }

    fn mesh(&self, pair: PairId) -> Option<&GearMesh> {
        self.scene.pairs.get(pair.0)?.mesh.as_ref()
    }

    /// Lag of the second gear: `sense (theta_1 N1/N2 + sign theta_2)`, angles counted from rigid unmodified contact.
    fn transmission_error(&self, step: &StepResult, pair: PairId) -> Observed {
        let Some(mesh) = self.mesh(pair) else { return number(f64::NAN) };
        let [first, second] = self.scene.pairs[pair.0].bodies.map(|body| body.0);
        let ratio = f64::from(mesh.teeth[0]) / f64::from(mesh.teeth[1]);
        let prescribed = |body: usize| {
            let pose = PlanePose::of(self.scene.bodies[body].motion.as_ref(), step.time);
            pose.map_or(f64::NAN, |pose| pose.angle - self.initial[body].angle)
        };
        let kinematic = prescribed(first) * ratio + mesh.sign * prescribed(second);
        // Angles are known up to whole turns, and a mesh repeats with every tooth of the second gear.
        let pitch = 2.0 * PI / f64::from(mesh.teeth[1]);
        let kinematic = kinematic - (kinematic / pitch).round() * pitch;
        let deflection =
            self.motion(step, first, THETA_Z) * ratio + mesh.sign * self.motion(step, second, THETA_Z);
        number(mesh.drive_sense * (kinematic + deflection))
    }

    /// Deviation of a frame from its prescribed motion.
    fn motion(&self, step: &StepResult, body: usize, component: usize) -> f64 {
        let at = self.freedoms.iter().position(|freedom| *freedom == Freedom { body, component });
        at.map_or(0.0, |at| step.motion[at])
    }

    fn load_share(&self, step: &StepResult, pair: PairId) -> Observed {
        let Some(mesh) = self.mesh(pair) else { return number(f64::NAN) };
        let patches = || step.patches.iter().filter(|patch| patch.pair == pair.0);
        let total: f64 = patches().map(Patch::force).sum();
        let own: f64 = patches().filter(|patch| patch.teeth == mesh.entering).map(Patch::force).sum();
        number(if total > 0.0 { own / total } else { 0.0 })
    }

    /// Tangent stiffness: the inverse of how far the mesh gives along the line of action for a small added force, with
    /// the cells that carry load now. Zero without load.
    fn mesh_stiffness(&self, step: &StepResult, pair: PairId) -> Observed {
        let Some(mesh) = self.mesh(pair) else { return number(f64::NAN) };
        let [first, second] = self.scene.pairs[pair.0].bodies.map(|body| body.0);
        let (active, n, m) = (&step.active, step.problem.cells(), self.freedoms.len());
        if active.is_empty() || m == 0 {
            return number(0.0);
        }
        let compliance = DMatrix::from_fn(active.len(), active.len(), |i, j| {
            step.problem.compliance[active[i] * n + active[j]]
        });
        let arms = DMatrix::from_fn(active.len(), m, |i, k| step.problem.arms[active[i] * m + k]);
        let Some(factor) = compliance.cholesky() else { return number(f64::NAN) };
        let stiffness = arms.transpose() * factor.solve(&arms);
        // Work done by a unit force along the line of action on each freedom.
        let along = DVector::from_fn(m, |k, _| match self.freedoms[k] {
            Freedom { body, component: THETA_Z } if body == first => mesh.base_radii[0],
            Freedom { body, component: THETA_Z } if body == second => mesh.sign * mesh.base_radii[1],
            _ => 0.0,
        });
        let gives = stiffness.lu().solve(&along).map_or(f64::NAN, |motion| along.dot(&motion));
        number(self.face_width / gives)
    }

    /// Of the patches that an edge cuts off, or of the others.
    fn max_pressure(&self, step: &StepResult, pair: PairId, at_edge: bool) -> Observed {
        let mut largest = number(0.0);
        for patch in step.patches.iter().filter(|patch| patch.pair == pair.0 && patch.at_edge == at_edge) {
            if let Some(Peak { pressure, cell, .. }) = patch.peak()
                && pressure > largest.value
            {
                let body = self.scene.pairs[pair.0].bodies[0];
                let place = self.place(body, patch.teeth[0], patch.surfaces[0], patch.cells[cell].s[0]);
                largest = Observed { value: pressure, place };
            }
        }
        largest
    }

    /// Where an arc length of a flank is.
    fn place(&self, body: BodyId, tooth: u32, surface: u32, s: f64) -> Option<Place> {
        let [x, y] = self.structures[body.0].as_ref()?.profile(surface).at(s).position;
        Some(self.named_place(body, tooth, x.hypot(y)))
    }

    fn named_place(&self, body: BodyId, tooth: u32, radius: f64) -> Place {
        let body = &self.scene.bodies[body.0];
        Place { body: body.name.clone(), tooth, roll_angle: body.prototype.roll_angle(radius), radius }
    }

    fn max_root_stress(&self, step: &StepResult, body: BodyId) -> Observed {
        let Some(structure) = self.structures.get(body.0).and_then(Option::as_ref) else {
            return number(f64::NAN);
        };
        let loads = self.surface_loads(step, body.0);
        let mut largest = number(0.0);
        for (tooth, surface) in neighbourhood(&loads, structure.as_ref()) {
            for (StressPlace { tooth, position, .. }, stress) in structure.stresses(tooth, surface, &loads) {
                if stress > largest.value {
                    let place = self.named_place(body, tooth, position[0].hypot(position[1]));
                    largest = Observed { value: stress, place: Some(place) };
                }
            }
        }
        largest
    }

    /// The cell forces on a body, on its own surfaces.
    fn surface_loads(&self, step: &StepResult, body: usize) -> Vec<SurfaceLoad> {
        let mut loads = Vec::new();
        for patch in &step.patches {
            let bodies = self.scene.pairs[patch.pair].bodies;
            for side in (0..2).filter(|&side| bodies[side].0 == body) {
                let chart = Chart { tooth: patch.teeth[side], surface: patch.surfaces[side] };
                let loaded = patch.cells.iter().zip(&patch.forces).filter(|(_, force)| **force > 0.0);
                loads.extend(loaded.map(|(cell, &force)| SurfaceLoad { chart, s: cell.s[side], force }));
            }
        }
        loads
    }
}

fn number(value: f64) -> Observed {
    Observed { value, place: None }
}

/// The loaded teeth and their neighbours, on the loaded side: where the largest tension of a fillet can be.
fn neighbourhood(loads: &[SurfaceLoad], structure: &dyn Structure) -> Vec<(u32, u32)> {
    let teeth = structure.teeth();
    let mut near: Vec<(u32, u32)> = loads
        .iter()
        .flat_map(|load| {
            let Chart { tooth, surface } = load.chart;
            [tooth, (tooth + 1) % teeth, (tooth + teeth - 1) % teeth].map(|tooth| (tooth, surface))
        })
        .collect();
    near.sort_unstable();
    near.dedup();
    near
}
