//! Tests of transient analyses of rotating bodies against the nonlinear equations of motion of
//! their particles.

use super::*;
use crate::observables::{SupportForce, SupportMoment};
use calyx_fe::inertia::Inertia;
use calyx_fe::material::Material;
use calyx_model::bearing::Bearing;
use calyx_model::body::Body;
use calyx_model::disc::{Disc, Facing, Platen};
use calyx_model::dof::Component;
use calyx_model::fidelity::{Fidelity, StructureOptions};
use calyx_model::ids::BodyId;
use calyx_model::motion::{Motion, SteadyRotation};
use calyx_model::pairs::SurfacePair;
use calyx_model::prototype::Prototype;
use calyx_numerics::interrupt::Interrupt;
use calyx_solve::integration::{Scheme, TimeRange};
use calyx_structure::{BodyModes, Structure};
use faer::Mat;
use nalgebra::{DMatrix, DVector, Vector2};
use std::sync::Arc;

const WIDTH: f64 = 0.02;
const RADIUS: f64 = 0.03;
/// A coarse mesh suffices: there is no contact.
const FEW: StructureOptions = StructureOptions {
    refinement: 0.2,
    order: 1,
    model: calyx_model::fidelity::BodyModel::Elements,
    template: calyx_model::fidelity::Template::Medium,
    face_elements: None,
    axial_order: None,
    matching_depth: 1.0,
    stresses: false,
    sharp_edges: false,
    raceway_degrees: 0,
};

/// Massless disc with prescribed modes.
struct Vibrating {
    disc: Disc,
    modes: Arc<BodyModes>,
}

impl Prototype for Vibrating {
    fn build(
        &self,
        options: &StructureOptions,
        interrupt: &Interrupt,
    ) -> Result<Arc<dyn Structure>, EngineError> {
        self.disc.build(options, interrupt)
    }

    fn modes(
        &self,
        _: &StructureOptions,
        _: f64,
        _: &Interrupt,
    ) -> Result<Option<Arc<BodyModes>>, EngineError> {
        Ok(Some(self.modes.clone()))
    }

    fn enclosing_radius(&self) -> f64 {
        RADIUS
    }

    fn face_width(&self) -> f64 {
        WIDTH
    }
}

/// Orbit with increasing rotational speed.
#[derive(Clone, Copy)]
struct Orbit {
    radius: f64,
    round: f64,
    speed: f64,
    speeding: f64,
}

type Complex = [f64; 2];

fn times([a, b]: Complex, [c, d]: Complex) -> Complex {
    [a * c - b * d, a * d + b * c]
}

impl Orbit {
    /// Angle, angular velocity and acceleration of the frame.
    fn turn(&self, time: f64) -> [f64; 3] {
        [
            self.speed * time + 0.5 * self.speeding * time * time,
            self.speed + self.speeding * time,
            self.speeding,
        ]
    }

    /// Acceleration of the frame's origin.
    fn origin_acceleration(&self, time: f64) -> Vector2<f64> {
        let by = -self.radius * self.round * self.round;
        Vector2::new(by * (self.round * time).cos(), by * (self.round * time).sin())
    }

    /// Frame from the complex numbers of its rotation and translation.
    fn entries([p, q]: Complex, [x, y]: Complex) -> [f64; 12] {
        [p, -q, 0.0, q, p, 0.0, 0.0, 0.0, 0.0, x, y, 0.0]
    }

    fn parts(&self, time: f64) -> (Complex, Complex) {
        let [angle, ..] = self.turn(time);
        let ahead = self.round * time - angle;
        let turned = [angle.cos(), -angle.sin()];
        (turned, [-self.radius * ahead.cos(), -self.radius * ahead.sin()])
    }
}

impl Motion for Orbit {
    fn frame(&self, time: f64) -> [f64; 12] {
        let (turned, moved) = self.parts(time);
        let mut frame = Orbit::entries(turned, moved);
        frame[8] = 1.0;
        frame
    }

    fn rate(&self, time: f64) -> [f64; 12] {
        let (turned, moved) = self.parts(time);
        let [_, speed, _] = self.turn(time);
        Orbit::entries(times([0.0, -speed], turned), times([0.0, self.round - speed], moved))
    }

    fn acceleration(&self, time: f64) -> [f64; 12] {
        let (turned, moved) = self.parts(time);
        let [_, speed, speeding] = self.turn(time);
        let ahead = self.round - speed;
        Orbit::entries(times([-speed * speed, -speeding], turned), times([-ahead * ahead, -speeding], moved))
    }
}

/// Particle of a body: its mass, its position, and the frequency of its vibration on isotropic
/// springs, if any.
#[derive(Clone, Copy)]
struct Particle {
    mass: f64,
    place: Vector2<f64>,
    natural: Option<f64>,
}

/// Particles on a frame with its own moment of inertia.
#[derive(Clone)]
struct Rotor {
    particles: Vec<Particle>,
    polar: f64,
    motion: Orbit,
    /// Free components: two displacements and the rotation.
    free: [bool; 3],
    /// Springs on these components, and loads along them.
    springs: [f64; 3],
    load: [f64; 3],
    /// True if the inertia forces of the prescribed motion are applied as loads, so that without
    /// other loads nothing deviates from it.
    prestressed: bool,
}

fn across(v: Vector2<f64>) -> Vector2<f64> {
    Vector2::new(-v.y, v.x)
}

impl Rotor {
    fn swinging(&self) -> impl Iterator<Item = (usize, Particle)> + '_ {
        let swinging = self.particles.iter().filter(|particle| particle.natural.is_some());
        swinging.enumerate().map(|(index, particle)| (3 + 2 * index, *particle))
    }

    fn count(&self) -> usize {
        3 + 2 * self.swinging().count()
    }

    /// Exact equations of motion of the particles, except that springs are stiffened by `m omega²`
    /// like a body under tension: the mass matrix, and the forces on all coordinates.
    fn equations(&self, time: f64, x: &DVector<f64>, v: &DVector<f64>) -> (DMatrix<f64>, DVector<f64>) {
        let (count, [angle, speed, speeding]) = (self.count(), self.motion.turn(time));
        let origin = self.motion.origin_acceleration(time);
        let turned = |v: Vector2<f64>, by: f64| v * by.cos() + across(v) * by.sin();
        let mut mass = DMatrix::zeros(count, count);
        let mut acts = DVector::zeros(count);
        mass[(2, 2)] = self.polar;
        acts[2] = if self.prestressed { 0.0 } else { -self.polar * speeding };
        for k in 0..3 {
            acts[k] += self.load[k] - self.springs[k] * x[k];
        }
        let mut at = 3;
        for particle in &self.particles {
            let own = particle.natural.map(|natural| (at, natural));
            let swung = |x: &DVector<f64>| match own {
                Some((at, _)) => Vector2::new(x[at], x[at + 1]),
                None => Vector2::zeros(),
            };
            let place = turned(particle.place + swung(x), angle + x[2]);
            let rate = speed + v[2];
            let drift = origin + across(place) * speeding - place * rate * rate
                + across(turned(swung(v), angle + x[2])) * (2.0 * rate);
            let there = turned(particle.place, angle);
            let meant = match self.prestressed {
                true => (origin + across(there) * speeding - there * speed * speed) * particle.mass,
                false => Vector2::zeros(),
            };
            acts[0] += meant.x;
            acts[1] += meant.y;
            acts[2] += across(there).dot(&meant);
            let mut arms = DMatrix::zeros(2, count);
            arms.fixed_view_mut::<2, 2>(0, 0).fill_with_identity();
            arms.set_column(2, &across(place));
            if let Some((at, natural)) = own {
                arms.set_column(at, &turned(Vector2::x(), angle + x[2]));
                arms.set_column(at + 1, &turned(Vector2::y(), angle + x[2]));
                let stiffness = particle.mass * (natural * natural + speed * speed);
                let mut held = -swung(x) * stiffness;
                held += turned(meant, -angle);
                acts[at] += held.x;
                acts[at + 1] += held.y;
            }
            mass += arms.transpose() * &arms * particle.mass;
            acts -= arms.transpose() * drift * particle.mass;
            at += 2 * usize::from(own.is_some());
        }
        (mass, acts)
    }

    /// Accelerations, and the reactions on the frame.
    fn accelerations(&self, time: f64, x: &DVector<f64>, v: &DVector<f64>) -> (DVector<f64>, [f64; 3]) {
        let (mass, acts) = self.equations(time, x, v);
        let moving: Vec<usize> = (0..self.count()).filter(|&k| k >= 3 || self.free[k]).collect();
        let own = DMatrix::from_fn(moving.len(), moving.len(), |i, j| mass[(moving[i], moving[j])]);
        let found = own.lu().solve(&DVector::from_fn(moving.len(), |i, _| acts[moving[i]])).expect("mass");
        let mut all = DVector::zeros(self.count());
        moving.iter().zip(found.iter()).for_each(|(&k, a)| all[k] = *a);
        let left = &mass * &all - acts;
        (all, [left[0], left[1], left[2]])
    }

    /// Runge-Kutta solution from rest: final coordinates, and final reactions on the frame.
    fn exact(&self, until: f64, steps: usize) -> (DVector<f64>, [f64; 3]) {
        let h = until / steps as f64;
        let (mut x, mut v) = (DVector::zeros(self.count()), DVector::zeros(self.count()));
        for step in 0..steps {
            let t = h * step as f64;
            let a1 = self.accelerations(t, &x, &v).0;
            let (x2, v2) = (&x + &v * (0.5 * h), &v + &a1 * (0.5 * h));
            let a2 = self.accelerations(t + 0.5 * h, &x2, &v2).0;
            let (x3, v3) = (&x + &v2 * (0.5 * h), &v + &a2 * (0.5 * h));
            let a3 = self.accelerations(t + 0.5 * h, &x3, &v3).0;
            let (x4, v4) = (&x + &v3 * h, &v + &a3 * h);
            let a4 = self.accelerations(t + h, &x4, &v4).0;
            x += (&v + &v2 * 2.0 + &v3 * 2.0 + &v4) * (h / 6.0);
            v += (a1 + a2 * 2.0 + a3 * 2.0 + a4) * (h / 6.0);
        }
        let held = self.accelerations(until, &x, &v).1;
        (x, held)
    }

    /// Modes of the particles: each vibrates along both axes.
    fn modes(&self) -> BodyModes {
        let own: Vec<Particle> = self.swinging().map(|(_, particle)| particle).collect();
        let root = |k: usize| (own[k / 2].mass / WIDTH).sqrt();
        let along = |k: usize| if k.is_multiple_of(2) { Vector2::x() } else { Vector2::y() };
        let all = 0..2 * own.len();
        BodyModes::without_surfaces(
            all.clone().map(|k| own[k / 2].natural.unwrap_or(0.0)).collect(),
            all.clone()
                .map(|k| {
                    let about = along(k).dot(&across(own[k / 2].place));
                    [along(k).x, along(k).y, about].map(|part| root(k) * part)
                })
                .collect(),
            Mat::from_fn(all.len(), all.len(), |k, l| match k / 2 == l / 2 {
                true => along(k).dot(&across(along(l))),
                false => 0.0,
            }),
            all.map(|k| root(k) * along(k).dot(&own[k / 2].place)).collect(),
        )
    }

    fn scene(&self) -> Scene {
        let mut scene = Scene::default();
        let platen = Arc::new(Platen::new(0.1, WIDTH, Facing::Up));
        let below = scene.add_body(Body::new("platen", platen, SteadyRotation::at_rest([0.0, -1.0])));
        let disc = Disc::new(RADIUS, WIDTH, Material::STEEL);
        let prototype = Arc::new(Vibrating { disc, modes: Arc::new(self.modes()) });
        let [fx, fy, moment] = self.load;
        let mut inertia = Inertia::axial(0.0, self.polar, 0.0);
        for Particle { mass, place, .. } in &self.particles {
            let point =
                Inertia { moment: [mass * place.x, mass * place.y, 0.0], ..Inertia::axial(*mass, 0.0, 0.0) };
            inertia = inertia + point + Inertia::axial(0.0, mass * place.norm_squared(), 0.0);
        }
        let all = [Component::Ux, Component::Uy, Component::ThetaZ];
        let free: Vec<Component> = all
            .into_iter()
            .zip(self.free)
            .filter(|(_, free)| *free)
            .map(|(component, _)| component)
            .collect();
        let body = Body::new("rotor", prototype, self.motion)
            .free_in(&free)
            .with_added(inertia)
            .loaded(Wrench { force: [fx, fy, 0.0], moment: [0.0, 0.0, moment] });
        let rotor = scene.add_body(body);
        scene.add_pair(SurfacePair::new([below, rotor], [Platen::SURFACE, Disc::BOTTOM]));
        let mut stiffness = [[0.0; 6]; 6];
        [0, 1, 5]
            .into_iter()
            .zip(self.springs)
            .for_each(|(k, spring): (usize, f64)| stiffness[k][k] = spring);
        if self.motion.radius == 0.0 && self.springs != [0.0; 3] {
            scene.add_bearing(Bearing::new("springs", rotor, 0.0, stiffness)).expect("a bearing");
        }
        scene
    }

    /// Final displacements, rotation and vibrations of the particles, and reactions on the frame.
    fn found(&self, until: f64, steps: usize) -> (DVector<f64>, [f64; 3]) {
        let mut scene = self.scene();
        let rotor = BodyId(1);
        let outputs = [
            OutputRequest::observing("x", scene.add_observable(SupportForce(rotor, 0))),
            OutputRequest::observing("y", scene.add_observable(SupportForce(rotor, 1))),
            OutputRequest::observing("turn", scene.add_observable(SupportMoment(rotor, 2))),
        ];
        let range = TimeRange { keep: steps, ..TimeRange::steady(until, steps) };
        let dynamics = DynamicOptions {
            from: 0.0,
            ranges: vec![range],
            scheme: Scheme::AVERAGE,
            rayleigh: [0.0; 2],
            start: Start::Frames,
        };
        let options =
            AnalysisOptions { structure: FEW, highest_frequency: 1e3, ..AnalysisOptions::default() };
        let mut history = History::new(&scene, &outputs, &options, &dynamics, &mut ()).expect("it can begin");
        history.by_ref().for_each(|row| assert!(row.is_ok()));
        let state = history.state().displacement.clone();
        let values = history.solved().last().expect("a row").row.outputs.iter().map(|output| output.value);
        let reactions: Vec<f64> = values.collect();
        let mut all = DVector::zeros(self.count());
        let mut own = state.iter();
        (0..3).filter(|&k| self.free[k]).for_each(|k| all[k] = *own.next().expect("a degree of freedom"));
        for (at, particle) in self.swinging() {
            for k in 0..2 {
                all[at + k] = own.next().expect("a mode") / (particle.mass / WIDTH).sqrt();
            }
        }
        (all, [reactions[0], reactions[1], reactions[2]])
    }

    /// Effect of the load on [`Rotor::found`] and [`Rotor::exact`].
    fn by_load<T>(&self, of: impl Fn(&Rotor) -> (DVector<f64>, T)) -> DVector<f64> {
        let unloaded = Rotor { load: [0.0; 3], ..self.clone() };
        of(self).0 - of(&unloaded).0
    }
}

fn particle(mass: f64, x: f64, y: f64, natural: Option<f64>) -> Particle {
    Particle { mass, place: Vector2::new(x, y), natural }
}

/// Eccentric rotor on soft springs that are stiffer along y.
fn eccentric() -> Rotor {
    Rotor {
        particles: vec![particle(3.0, 0.02, -0.01, None)],
        polar: 2e-3,
        motion: Orbit { radius: 0.0, round: 0.0, speed: 60.0, speeding: 0.0 },
        free: [true; 3],
        springs: [3.0 * 150.0 * 150.0, 3.0 * 200.0 * 200.0, 3.5e-3 * 80.0 * 80.0],
        load: [0.02, 0.0, 2e-4],
        prestressed: true,
    }
}

/// Eccentric rotor with two vibrating masses.
fn swinging() -> Rotor {
    let own = [particle(1.0, 0.02, 0.01, Some(400.0)), particle(0.8, -0.01, 0.025, Some(600.0))];
    let Rotor { mut particles, .. } = eccentric();
    particles.extend(own);
    Rotor { particles, ..eccentric() }
}

/// Every first-order term of rotation and displacement: linear response against the particles'
/// exact equations.
fn follows(rotor: &Rotor, until: f64, steps: usize) {
    let exact = rotor.by_load(|rotor| rotor.exact(until, 1000));
    let [coarse, fine] = [steps, 2 * steps].map(|steps| rotor.by_load(|rotor| rotor.found(until, steps)));
    let better = &fine + (&fine - &coarse) / 3.0;
    let size = |from: usize, to: usize| exact.rows(from, to - from).norm();
    for k in 0..rotor.count() {
        let scale = match k {
            0 | 1 => size(0, 2),
            2 => exact[2].abs(),
            _ => size(k - (k - 3) % 2, k - (k - 3) % 2 + 2),
        };
        let error = (better[k] - exact[k]).abs() / scale;
        assert!(error < 1e-3, "{k}: {error:e} of {scale:e}: {exact} {better}");
    }
    let order = ((&coarse - &better).norm() / (&fine - &better).norm()).log2();
    assert!((order - 2.0).abs() < 0.05, "{order}");
}

#[test]
fn an_eccentric_rotor_turns_and_shifts_as_its_particles_do() {
    follows(&eccentric(), 0.06, 700);
}

#[test]
fn masses_that_swing_on_a_turning_frame_follow_their_own_equations() {
    follows(&swinging(), 0.06, 700);
}

#[test]
fn a_frame_that_goes_round_and_turns_faster_and_faster_is_one_too() {
    let motion = Orbit { radius: 0.08, round: 90.0, speed: 60.0, speeding: 700.0 };
    follows(&Rotor { motion, springs: [0.0; 3], ..swinging() }, 0.03, 500);
}

#[test]
fn an_analysis_in_time_sees_what_bearings_damp() {
    let mut scene = eccentric().scene();
    scene.bearings[0].damping[0][0] = 10.0;
    let still = Plan::new(&scene, Fidelity::Plane, FEW).expect("a plan");
    let asked = DynamicOptions {
        from: 0.0,
        ranges: vec![TimeRange::steady(1e-3, 1)],
        scheme: Scheme::AVERAGE,
        rayleigh: [0.0; 2],
        start: Start::Frames,
    };
    let analysis = AnalysisOptions { structure: FEW, ..AnalysisOptions::default() };
    let history = History::new(&scene, &[], &analysis, &asked, &mut ()).expect("it can begin");
    let ignored_dampings =
        |plan: &Plan| plan.ignored.iter().filter(|ignored| ignored.input == "damping").count();
    assert_eq!((ignored_dampings(&still), ignored_dampings(history.plan())), (1, 0));
}

/// The reaction on a frame is the rate of the total momentum of all that moves on it.
#[test]
fn a_constrained_frame_feels_what_vibrates_on_it() {
    let stiff = |natural: f64| Some(10.0 * natural);
    let particles =
        swinging().particles.into_iter().map(|p| Particle { natural: p.natural.and_then(stiff), ..p });
    let rotor = Rotor {
        particles: particles.collect(),
        motion: Orbit { radius: 0.08, round: 90.0, speed: 60.0, speeding: 700.0 },
        springs: [0.0; 3],
        load: [0.0; 3],
        prestressed: false,
        ..swinging()
    };
    for free in [[false; 3], [false, true, false], [true, true, false]] {
        let rotor = Rotor { free, ..rotor.clone() };
        let (until, steps) = (0.01, 1000);
        let (_, exact) = rotor.exact(until, 1000);
        let [coarse, fine] = [steps, 2 * steps].map(|steps| rotor.found(until, steps).1);
        let better = [0, 1, 2].map(|k: usize| fine[k] + (fine[k] - coarse[k]) / 3.0);
        // Relative to the force of the particles' circular motion, and its moment.
        let force = 4.8 * 0.08 * 90.0 * 90.0;
        for (k, scale) in [force, force, 0.02 * force].into_iter().enumerate() {
            assert!((better[k] - exact[k]).abs() < 2e-3 * scale, "{free:?} {k}: {exact:?} {better:?}");
        }
    }
}
