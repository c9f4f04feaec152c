//! The ring rotates without contact, so that its vibration has gyroscopic and centrifugal terms.

use super::*;

/// Speed of the rotating ring, rad/s, and force on its frame after a rise, N.
const SPEED: f64 = 2500.0;
const FORCE: f64 = 1e4;

fn force(time: f64) -> f64 {
    FORCE / MOMENT * moment(time)
}

/// Returns the path of the frame of a rotating ring without contact in the inertial frame, m,
/// computed with its modes.
fn turning_by_modes(inertia: Inertia, speed: f64) -> Vec<[f64; 2]> {
    let mut scene = Scene::default();
    let motion = SteadyRotation { origin: [0.0; 2], start: 0.0, speed };
    let ring = Body::new("ring", Arc::new(Toothed { inertia }), motion)
        .free_in(&[Component::Ux, Component::Uy])
        .loaded(|time: f64| Wrench::of_force([force(time), 0.0, 0.0]));
    let ring = scene.add_body(ring);
    let roller = scene.add_body(Body::new("roller", Arc::new(Roller), SteadyRotation::at_rest([0.5, 0.0])));
    let support = Bearing::new("support", ring, 0.0, axisymmetric(SUPPORT, 0.0, 0.0, 0.0));
    scene.add_bearing(support).expect("a bearing");
    scene.add_pair(SurfacePair::new([ring, roller], [0, 0]));
    let outputs = [
        OutputRequest::observing("x", scene.add_observable(Displacement(BodyId(0), 0))),
        OutputRequest::observing("y", scene.add_observable(Displacement(BodyId(0), 1))),
    ];
    let dynamics = DynamicOptions {
        from: 0.0,
        ranges: vec![TimeRange::steady(STEPS as f64 * STEP, STEPS)],
        scheme: Scheme::AVERAGE,
        rayleigh: [0.0; 2],
        start: Start::Frames,
    };
    let options = AnalysisOptions { highest_frequency: 100e3, ..AnalysisOptions::default() };
    let history = History::new(&scene, &outputs, &options, &dynamics, &mut ()).expect("it can begin");
    history
        .map(|solved| {
            let outputs = solved.expect("it goes on").row.outputs;
            [outputs[0].value, outputs[1].value]
        })
        .collect()
}

/// Computes the same path with all unknowns in a rotating frame: `M (w'' + 2 W e3 x w' - W² w) + K
/// w = f`. Omits the static centrifugal expansion, which does not move the frame.
fn turning_by_all_unknowns(whole: &Whole, speed: f64) -> Vec<[f64; 2]> {
    let (stiffness, mass) = (whole.model.stiffness(), whole.model.mass());
    let across: Vec<_> = mass
        .triplet_iter()
        .map(|entry| match entry.col % 2 {
            0 => Triplet::new(entry.row, entry.col + 1, -entry.val),
            _ => Triplet::new(entry.row, entry.col - 1, *entry.val),
        })
        .collect();
    let size = whole.model.dof_count();
    let across = SparseColMat::try_new_from_triplets(size, size, &across).expect("a matrix");
    let support = SUPPORT / WIDTH;
    let mut k = whole.reduced(&stiffness, [support, support, 0.0]);
    let m = whole.reduced(&mass, [0.0; 3]);
    for (at, value) in &m {
        *k.entry(*at).or_insert(0.0) -= speed * speed * value;
    }
    let Scheme { beta, gamma } = Scheme::AVERAGE;
    let of_mass = (beta * STEP * STEP).recip();
    let mut step = k.clone();
    for (at, value) in &m {
        *step.entry(*at).or_insert(0.0) += of_mass * value;
    }
    // The rotation is prescribed.
    let mut constrained = Constraints::new();
    constrained.prescribe(whole.count - 1, 0.0);
    let solver = Solver::new(&whole.matrix(&step), constrained).expect("definite");
    let coriolis = whole.matrix(&whole.reduced(&across, [0.0; 3]));
    let (k, count) = (whole.matrix(&k), whole.count);
    let [mut x, mut v, mut a] = [0, 1, 2].map(|_| Mat::<f64>::zeros(count, 1));
    let mut path = vec![[0.0; 2]];
    for number in 1..=STEPS {
        let time = number as f64 * STEP;
        let ahead = &x + STEP * &v + (0.5 - beta) * STEP * STEP * &a;
        let begun = &v + (1.0 - gamma) * STEP * &a;
        let (sin, cos) = (speed * time).sin_cos();
        let mut end = &v + STEP * &a;
        // Fixed-point iteration on the velocities at the end of the step, which determine the
        // gyroscopic forces.
        for _ in 0..4 {
            let mut load = -(&k * &ahead) - 2.0 * speed * (&coriolis * &end);
            load[(count - 3, 0)] += cos * force(time) / WIDTH;
            load[(count - 2, 0)] -= sin * force(time) / WIDTH;
            let y = solver.solve(load.as_ref()).expect("solved");
            a = of_mass * &y;
            end = &begun + gamma * STEP * &a;
            x = &ahead + &y;
        }
        v = end;
        let [along, beside] = [x[(count - 3, 0)], x[(count - 2, 0)]];
        path.push([cos * along - sin * beside, sin * along + cos * beside]);
    }
    path
}

#[test]
fn a_ring_that_turns_feels_it_as_all_unknowns_of_the_mesh_do() {
    let whole = Whole::new();
    let [[by_modes, at_rest], [expected, expected_at_rest]] = [
        [SPEED, 0.0].map(|speed| turning_by_modes(whole.inertia(), speed)),
        [SPEED, 0.0].map(|speed| turning_by_all_unknowns(&whole, speed)),
    ];
    let less = |one: &[[f64; 2]], other: &[[f64; 2]]| -> Vec<[f64; 2]> {
        one.iter().zip(other).map(|(a, b)| [a[0] - b[0], a[1] - b[1]]).collect()
    };
    let most = |path: &[[f64; 2]]| path.iter().map(|[x, y]| x.hypot(*y)).fold(0.0, f64::max);
    let rest = most(&less(&at_rest, &expected_at_rest)) / most(&expected_at_rest);
    assert!(rest < 1e-3, "{rest:e}");
    // Rotation changes the path of such a stiff ring only slightly. This change agrees except for
    // the effects that the modal model omits: centrifugal softening of the modes, and modes above
    // the frequency limit.
    let (felt, meant) = (less(&by_modes, &at_rest), less(&expected, &expected_at_rest));
    let off = most(&less(&felt, &meant)) / most(&meant);
    assert!(off < 0.12, "{off:e}");
}
