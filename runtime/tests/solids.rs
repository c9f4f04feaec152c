//! Tests of 3-D bodies from the scene to results: spheres that carry a plate, against Hertz and
//! statics, with bitwise equal results for any number of threads.

use calyx_runtime::analysis::{AnalysisOptions, Position, Steps};
use calyx_runtime::error::EngineError;
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::load::Wrench;
use calyx_runtime::motion::Motion;
use calyx_runtime::observables::Observe;
use calyx_runtime::observables::{MaxContactPressure, MaxLineLoad};
use calyx_runtime::results::OutputRequest;
use calyx_runtime::scene::{
    Body, BodyId, Component, Fidelity, PairId, Prototype, Scene, StructureOptions, SurfacePair, Template,
};
use calyx_runtime::structure::Structure;
use calyx_runtime::structure::solid::{HalfSpaceBody, SolidStructure};
use calyx_runtime::surface::{Surface, SurfacePoint};
use std::f64::consts::PI;
use std::sync::Arc;

/// E' of both bodies, Pa.
const MODULUS: f64 = 2.2e11;
const RADIUS: f64 = 0.02;

/// Top of a sphere, or a pad in the plane z = 0 if its radius is infinite; its normal is along z
/// (`up` 1) or opposite (-1).
#[derive(Clone, Copy)]
struct Top {
    radius: f64,
    half: f64,
    up: f64,
    middle: [f64; 2],
}

impl Surface for Top {
    fn range(&self) -> [[f64; 2]; 2] {
        [[-self.half, self.half]; 2]
    }

    fn at(&self, u: f64, v: f64) -> SurfacePoint {
        let [x, y] = [self.middle[0] + u, self.middle[1] + v];
        if self.radius.is_infinite() {
            return SurfacePoint {
                position: [x, y, 0.0],
                tangents: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
                normal: [0.0, 0.0, self.up],
            };
        }
        let height = (self.radius * self.radius - u * u - v * v).sqrt();
        SurfacePoint {
            position: [x, y, self.up * height],
            tangents: [[1.0, 0.0, -self.up * u / height], [0.0, 1.0, -self.up * v / height]],
            normal: [u / self.radius, v / self.radius, self.up * height / self.radius],
        }
    }
}

/// Half-spaces with such surfaces.
struct Cushion(Vec<Top>);

impl Prototype for Cushion {
    fn build(&self, _: &StructureOptions, _: &Interrupt) -> Result<Arc<dyn Structure>, EngineError> {
        Err(EngineError::new("E0678", "it has no section", ""))
    }

    fn build_solid(
        &self,
        _: &StructureOptions,
        _: &Interrupt,
    ) -> Result<Arc<dyn SolidStructure>, EngineError> {
        let surfaces = self.0.iter().map(|top| Arc::new(*top) as Arc<dyn Surface>).collect();
        Ok(Arc::new(HalfSpaceBody::half_space(surfaces, 1, MODULUS)))
    }

    fn enclosing_radius(&self) -> f64 {
        0.15
    }

    fn face_width(&self) -> f64 {
        0.01
    }
}

/// Motion without rotation: position at time 0, and velocity per second.
struct At([f64; 3], [f64; 3]);

impl Motion for At {
    fn frame(&self, time: f64) -> [f64; 12] {
        let [x, y, z] = [0, 1, 2].map(|k| self.0[k] + self.1[k] * time);
        [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, -x, -y, -z]
    }

    fn rate(&self, _: f64) -> [f64; 12] {
        let [x, y, z] = self.1;
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -x, -y, -z]
    }

    fn acceleration(&self, _: f64) -> [f64; 12] {
        [0.0; 12]
    }
}

/// Positions of the spheres under the plate, m.
const FEET: [[f64; 2]; 3] = [[0.1, 0.0], [-0.05, 0.08], [-0.05, -0.08]];

/// Creates a plate with three pads on three spheres, loaded eccentrically; the spheres are lowered
/// by `sink` m.
fn tripod(wrench: Wrench, sink: f64) -> (Scene, BodyId, Vec<PairId>) {
    let mut scene = Scene::default();
    let half = 0.25 * RADIUS;
    let sphere = Arc::new(Cushion(vec![Top { radius: RADIUS, half, up: 1.0, middle: [0.0; 2] }]));
    let pads = FEET.map(|middle| Top { radius: f64::INFINITY, half: 1.5 * half, up: -1.0, middle });
    let plate = Arc::new(Cushion(pads.to_vec()));
    let plate = scene.add_body(
        Body::new("plate", plate, At([0.0; 3], [0.0; 3]))
            .free_in(&[Component::Uz, Component::ThetaX, Component::ThetaY])
            .loaded(wrench),
    );
    let pairs = FEET.iter().enumerate().map(|(foot, [x, y])| {
        let at = At([*x, *y, -RADIUS - sink], [0.0; 3]);
        let sphere = scene.add_body(Body::new(format!("sphere {foot}"), sphere.clone(), at));
        let mut pair = SurfacePair::new([sphere, plate], [0, foot as u32]);
        pair.grid.half_cells = Some(12);
        scene.add_pair(pair)
    });
    let pairs = pairs.collect();
    (scene, plate, pairs)
}

fn three_dimensional() -> AnalysisOptions {
    AnalysisOptions { fidelity: Fidelity::Solid(Template::Medium), ..AnalysisOptions::default() }
}

/// Returns Hertz's peak pressure and approach of a sphere on a plane (Johnson, Contact Mechanics,
/// eqs. 4.22 to 4.24).
fn hertz(force: f64) -> [f64; 2] {
    let modulus = 0.5 * MODULUS;
    let half_width = (0.75 * force * RADIUS / modulus).cbrt();
    [1.5 * force / (PI * half_width * half_width), half_width * half_width / RADIUS]
}

#[test]
fn a_plate_on_three_spheres_is_in_equilibrium_and_each_contact_is_hertz_s() {
    let (down, tilt) = (-3000.0, [40.0, -30.0]);
    let wrench = Wrench { force: [0.0, 0.0, down], moment: [tilt[0], tilt[1], 0.0] };
    let sink = 1e-5;
    let (mut scene, plate, pairs) = tripod(wrench, sink);
    let peaks: Vec<_> = pairs.iter().map(|pair| scene.add_observable(MaxContactPressure(*pair))).collect();
    let outputs: Vec<_> = peaks.iter().map(|peak| OutputRequest::observing("peak", *peak)).collect();
    let positions = [Position::at(0.0)];
    let mut steps = Steps::new(&scene, &positions, &outputs, &three_dimensional()).expect("it is held");
    let solved = steps.next().expect("a position").expect("it can be solved");
    assert!(solved.certificate.largest() <= 1e-12, "{:?}", solved.certificate);
    let step = steps.current().expect("it is solved");

    // Three unknown forces, three equations of statics.
    let matrix = nalgebra::Matrix3::from_fn(|row, foot| [1.0, FEET[foot][1], -FEET[foot][0]][row]);
    let forces = matrix.lu().solve(&nalgebra::Vector3::new(-down, -tilt[0], -tilt[1])).expect("three feet");
    let motion = &step.motion;
    for (foot, patch) in step.patches.iter().enumerate() {
        let force = forces[foot];
        // The spheres roll slightly under the tilting plate.
        assert!((patch.force() / force - 1.0).abs() < 1e-5, "{} {force}", patch.force());
        let [pressure, approach] = hertz(force);
        let [x, y] = FEET[foot];
        let sunk = -(motion[0] + y * motion[1] - x * motion[2]) - sink;
        assert!((solved.row.outputs[foot].value / pressure - 1.0).abs() < 0.01, "{foot}");
        assert!((sunk / approach - 1.0).abs() < 0.01, "{sunk} {approach}");
    }
    // The contact forces on the plate balance its load; over all bodies they sum to zero.
    let mut total = [0.0; 6];
    for body in 0..scene.bodies.len() {
        let wrench = steps.system().contact_force(step, BodyId(body));
        let origin =
            if body == 0 { [0.0; 3] } else { [FEET[body - 1][0], FEET[body - 1][1], -RADIUS - sink] };
        let [x, y, z, a, b, c] = wrench;
        let about_ground = [
            a + origin[1] * z - origin[2] * y,
            b + origin[2] * x - origin[0] * z,
            c + origin[0] * y - origin[1] * x,
        ];
        for (sum, part) in total.iter_mut().zip([x, y, z].into_iter().chain(about_ground)) {
            *sum += part;
        }
    }
    assert!(total.iter().all(|part| part.abs() <= 1e-10 * down.abs()), "{total:?}");
    let on_plate = steps.system().contact_force(step, plate);
    for (part, load) in on_plate.into_iter().zip([0.0, 0.0, down, tilt[0], tilt[1], 0.0]).skip(2).take(3) {
        assert!((part + load).abs() <= 1e-10 * down.abs());
    }
}

/// The line load of Hertz's contact with radius a under the force F is 3 F / 4 a at its centre:
/// half an ellipsoid, integrated across.
#[test]
fn line_loads_fields_and_supports_are_those_of_the_pressures() {
    let (down, sink) = (-3000.0, 1e-5);
    let (mut scene, plate, pairs) = tripod(Wrench::of_force([0.0, 0.0, down]), sink);
    let line_load = scene.add_observable(MaxLineLoad(pairs[2]));
    let outputs = [OutputRequest::observing("line load", line_load)];
    let positions = [Position::at(0.0)];
    let mut steps = Steps::new(&scene, &positions, &outputs, &three_dimensional()).expect("it is held");
    let solved = steps.next().expect("a position").expect("it can be solved");
    let at = steps.equilibrium().expect("it is solved");
    let contact = at.contacts(pairs[2]).next().expect("its patch");
    let half_width = (0.75 * contact.force() * RADIUS / (0.5 * MODULUS)).cbrt();
    let expected = 0.75 * contact.force() / half_width;
    let found = solved.row.outputs[0].value;
    assert!((found / expected - 1.0).abs() < 0.01, "{found} {expected}");
    let slices: f64 = contact.slices().iter().map(|slice| slice.force).sum();
    assert!((slices / contact.force() - 1.0).abs() < 1e-12);
    // Cells are rectangles: the sum of pressures times areas is the force.
    let fields = at.fields();
    assert_eq!(fields.contacts.len(), 3);
    let area = |[a, b, _, d]: [[f64; 3]; 4]| {
        let side =
            |from: [f64; 3], to: [f64; 3]| (0..3).map(|k| (to[k] - from[k]).powi(2)).sum::<f64>().sqrt();
        side(a, b) * side(a, d)
    };
    let cells = fields.contacts[2].cells.iter().map(|cell| cell.pressure * area(cell.corners));
    assert!((cells.sum::<f64>() / contact.force() - 1.0).abs() < 1e-9);
    // The support of a sphere carries its contact force; the plate is free in z and has no other
    // load.
    let sphere = contact.bodies()[0];
    assert!((at.support(sphere)[2] / contact.force() - 1.0).abs() < 1e-9);
    assert!(at.support(plate)[2].abs() < 1e-9 * down.abs());
}

#[test]
fn constrained_bodies_that_overlap_press_on_each_other() {
    let (mut scene, plate, pairs) = tripod(Wrench::NONE, -1e-6);
    scene.bodies[plate.0].free = [false; 6];
    let peak = scene.add_observable(MaxContactPressure(pairs[1]));
    let outputs = [OutputRequest::observing("peak", peak)];
    let positions = [Position::at(0.0)];
    let mut steps = Steps::new(&scene, &positions, &outputs, &three_dimensional()).expect("nothing is free");
    let solved = steps.next().expect("a position").expect("it can be solved");
    // Computes the force from the approach, and the approach from the force.
    let force = 4.0 / 3.0 * 0.5 * MODULUS * (RADIUS * 1e-6_f64.powi(3)).sqrt();
    let [pressure, approach] = hertz(force);
    assert!((approach / 1e-6 - 1.0).abs() < 1e-12);
    assert!((solved.row.outputs[0].value / pressure - 1.0).abs() < 0.01);
    let pressed = steps.current().expect("it is solved").patches[1].force();
    assert!((pressed / force - 1.0).abs() < 0.01, "{pressed} {force}");
}
