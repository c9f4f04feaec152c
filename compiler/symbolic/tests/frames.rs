//! Checks the sign convention of frames, and rigid-body kinematics against entry-by-entry
//! differentiation and finite differences.

use crate::support::{Random, assert_close, difference, evaluate};
use calyx_symbolic::{Binary, Frame, Graph, Instruction, Matrix3, NodeId, Pose, Vector3};

const TIME: u32 = 0;

fn constants(g: &mut Graph, values: [f64; 3]) -> Vector3 {
    values.map(|v| g.constant(v))
}

/// `c0 + c1 t + c2 t^2` with random coefficients.
fn quadratic(g: &mut Graph, random: &mut Random) -> NodeId {
    let time = g.symbol(TIME);
    let [c0, c1, c2] = [0; 3].map(|_| random.uniform(-1.0, 1.0));
    let (linear, second) = (g.scale(c1, time), g.scale(c2, time));
    let second = g.multiply(second, time);
    let sum = g.add(linear, second);
    let constant = g.constant(c0);
    g.add(sum, constant)
}

/// Returns a random chain with every kind of factor, and the pose of each factor written entry by
/// entry.
fn random_chain(g: &mut Graph, random: &mut Random, kinds: &[usize]) -> (Frame, Vec<Pose>) {
    let mut frame = Frame::ground();
    let mut poses = Vec::new();
    for &kind in kinds {
        let angle = quadratic(g, random);
        let (next, pose) = match kind {
            0..=2 => {
                let mut axis = [0.0; 3];
                axis[kind] = if random.uniform(0.0, 1.0) < 0.5 { -1.0 } else { 1.0 };
                let axis = constants(g, axis);
                (Frame::rotate(angle, axis), turned(g, angle, axis))
            }
            3 => {
                let axis = constants(g, [0.36, 0.48, 0.8]);
                (Frame::rotate(angle, axis), turned(g, angle, axis))
            }
            4 => {
                let v = [0; 3].map(|_| quadratic(g, random));
                (Frame::translate(v), moved(g, v))
            }
            5 => {
                // A rotating axis.
                let tilt = quadratic(g, random);
                let axis = [g.sin(tilt), g.constant(0.0), g.cos(tilt)];
                (Frame::rotate(angle, axis), turned(g, angle, axis))
            }
            6 => {
                // A pose given as twelve numbers.
                let axis = constants(g, [0.6, 0.0, 0.8]);
                let inner = g.constant(0.7);
                let mut pose = turned(g, inner, axis);
                pose[9..].copy_from_slice(&constants(g, [0.3, -0.2, 0.9]));
                (Frame::from_pose(pose), pose)
            }
            _ => {
                // A conditional choice between a moving frame and one that has no derivative at
                // this time.
                let time = g.symbol(TIME);
                let (early, later) = (g.constant(-5.0), g.sqrt(time));
                let condition = g.binary(Binary::Less, early, time);
                let axis = constants(g, [0.0, 1.0, 0.0]);
                let v = [angle; 3];
                let first = Frame::translate(v).after(&Frame::rotate(angle, axis));
                let second = Frame::rotate(later, axis);
                let (then, otherwise) = (first.pose(g), second.pose(g));
                let mut pose = then;
                for i in 0..12 {
                    pose[i] = g.select(condition, then[i], otherwise[i]);
                }
                (Frame::select(g, condition, &first, &second), pose)
            }
        };
        frame = next.after(&frame);
        poses.push(pose);
    }
    (frame, poses)
}

/// The translation `x' = x - v`, entry by entry.
fn moved(g: &mut Graph, v: Vector3) -> Pose {
    let [[a, b, c], [d, e, f], [h, i, j]] = g.identity_matrix();
    let [x, y, z] = g.negate_vector(v);
    [a, b, c, d, e, f, h, i, j, x, y, z]
}

/// The rotation `x' = Q(angle, axis)^T x`, with Rodrigues' formula `Q x = x + s n x x + (1 - c) n x
/// (n x x)` applied to the unit vectors.
fn turned(g: &mut Graph, angle: NodeId, axis: Vector3) -> Pose {
    let (sine, cosine, one) = (g.sin(angle), g.cos(angle), g.constant(1.0));
    let versine = g.subtract(one, cosine);
    let zero = g.constant(0.0);
    let mut pose = [zero; 12];
    for (j, unit) in g.identity_matrix().into_iter().enumerate() {
        let once = g.cross(axis, unit);
        let twice = g.cross(axis, once);
        let (first, second) = (g.scale_vector(sine, once), g.scale_vector(versine, twice));
        let sum = g.add_vectors(first, second);
        // Column j of Q is row j of its transpose.
        pose[3 * j..3 * j + 3].copy_from_slice(&g.add_vectors(unit, sum));
    }
    pose
}

fn rows(pose: &Pose) -> (Matrix3, Vector3) {
    let row = |i: usize| [pose[3 * i], pose[3 * i + 1], pose[3 * i + 2]];
    ([row(0), row(1), row(2)], row(3))
}

/// Returns the composition of poses in order of application, by matrix products.
fn product(g: &mut Graph, poses: &[Pose]) -> Pose {
    let mut rotation = g.identity_matrix();
    let mut translation = g.zero_vector();
    for pose in poses {
        let (r, t) = rows(pose);
        rotation = g.multiply_matrices(r, rotation);
        let turned = g.transform(r, translation);
        translation = g.add_vectors(turned, t);
    }
    let mut result = [translation[0]; 12];
    for i in 0..3 {
        result[3 * i..3 * i + 3].copy_from_slice(&rotation[i]);
    }
    result[9..].copy_from_slice(&translation);
    result
}

/// Returns chains that together have every kind of factor at every position.
fn chains() -> Vec<Vec<usize>> {
    let mut random = Random(3);
    let mut chains: Vec<Vec<usize>> = (0..8).map(|kind| vec![kind]).collect();
    chains.extend([vec![], vec![4, 2, 4, 2], vec![2, 2, 4, 4]]);
    chains.extend((0..20).map(|_| (0..5).map(|_| random.uniform(0.0, 8.0) as usize).collect()));
    chains
}

#[test]
fn coordinates_follow_the_report() {
    let mut g = Graph::new();
    let (e1, e3) = (constants(&mut g, [1.0, 0.0, 0.0]), constants(&mut g, [0.0, 0.0, 1.0]));
    let quarter = g.constant(std::f64::consts::FRAC_PI_2);
    let translate = Frame::translate(constants(&mut g, [2.0, 0.0, 0.0]));
    let rotate = Frame::rotate(quarter, e3);
    let some = |v: [f64; 3]| v.map(Some);
    // In a frame translated to (2, 0, 0), e1 is at (-1, 0, 0); in a frame rotated by a quarter
    // turn, at (0, -1, 0).
    let seen = translate.apply(&mut g, e1);
    let turned = rotate.apply(&mut g, e1);
    // Rotated first, then translated along its own e1, which is ground's e2; and vice versa.
    let own = translate.after(&rotate).origin(&mut g);
    let ground = rotate.after(&translate).origin(&mut g);
    let direction = rotate.after(&translate).direction(&mut g, e1);
    let round =
        |vector: Vector3| vector.map(|id| g.constant_value(id).map(|v| (v * 1e9).round() / 1e9 + 0.0));
    assert_eq!(round(seen), some([-1.0, 0.0, 0.0]));
    assert_eq!(round(turned), some([0.0, -1.0, 0.0]));
    assert_eq!(round(own), some([0.0, 2.0, 0.0]));
    assert_eq!(round(ground), some([2.0, 0.0, 0.0]));
    assert_eq!(round(direction), some([0.0, 1.0, 0.0]));
}

#[test]
fn poses_and_their_derivatives_agree_with_matrix_products_differentiated_entry_by_entry() {
    let mut random = Random(17);
    for kinds in chains() {
        let mut g = Graph::new();
        let (frame, poses) = random_chain(&mut g, &mut random, &kinds);
        let mut expected = vec![product(&mut g, &poses)];
        for order in 0..2 {
            expected.push(expected[order].map(|entry| g.derivative(entry, TIME)));
        }
        let actual = frame.pose_with_derivatives(&mut g, TIME, 2);
        assert_eq!(actual[0], frame.pose(&mut g));
        let at = [random.uniform(-0.8, 0.8)];
        let values = |poses: &[Pose]| evaluate(&g, &poses.concat(), &at);
        for (i, (a, e)) in values(&actual).into_iter().zip(values(&expected)).enumerate() {
            // Up to twenty products of numbers of order one; each derivative is larger by an order
            // of ten.
            assert_close(a, e, 1e-12, &format!("chain {kinds:?}, output {i}"));
        }
    }
}

#[test]
fn derivatives_agree_with_differences() {
    // With angles up to quadratic, the seventh derivative is below 1e8 and h^6/140 = 7e-18; the
    // rounding error is 2e-16/h.
    const STEP: f64 = 1e-3;
    let mut random = Random(23);
    for kinds in chains().into_iter().filter(|kinds| kinds.len() <= 4) {
        let mut g = Graph::new();
        let (frame, _) = random_chain(&mut g, &mut random, &kinds);
        let outputs = frame.pose_with_derivatives(&mut g, TIME, 2).concat();
        let at = random.uniform(0.2, 0.8);
        let values = evaluate(&g, &outputs, &[at]);
        for i in 0..24 {
            let slope = difference(|t| evaluate(&g, &outputs[i..=i], &[t])[0], at, STEP);
            assert_close(values[i + 12], slope, 1e-9, &format!("chain {kinds:?}, output {}", i + 12));
        }
    }
}

#[test]
fn motion_in_ground_agrees_with_the_pose() {
    let mut random = Random(29);
    for kinds in chains() {
        let mut g = Graph::new();
        let (frame, poses) = random_chain(&mut g, &mut random, &kinds);
        // In ground coordinates, from R and t: origin -R^T t, direction R^T d, cross product with
        // the angular velocity R^T' R.
        let (rotation, translation) = rows(&product(&mut g, &poses));
        let axes = [0, 1, 2].map(|i| [0, 1, 2].map(|j| rotation[j][i]));
        let back = g.transform(axes, translation);
        let origin = g.negate_vector(back);
        let velocity = g.vector_derivative(origin, TIME);
        let acceleration = g.vector_derivative(velocity, TIME);
        let rates = g.matrix_derivative(axes, TIME);
        let spin = [(2, 1), (0, 2), (1, 0)].map(|(i, j)| g.dot(rates[i], axes[j]));
        let change = g.vector_derivative(spin, TIME);
        let vector = constants(&mut g, [0.3, -1.2, 0.5]);
        let direction = g.transform(axes, vector);
        let expected = [origin, velocity, acceleration, spin, change, direction].concat();
        let actual = [
            frame.origin(&mut g),
            frame.velocity(&mut g, TIME),
            frame.acceleration(&mut g, TIME),
            frame.angular_velocity(&mut g, TIME),
            frame.angular_acceleration(&mut g, TIME),
            frame.direction(&mut g, vector),
        ]
        .concat();
        let at = [random.uniform(-0.8, 0.8)];
        let (actual, expected) = (evaluate(&g, &actual, &at), evaluate(&g, &expected, &at));
        for (i, (a, e)) in actual.into_iter().zip(expected).enumerate() {
            assert_close(a, e, 1e-12, &format!("chain {kinds:?}, component {i}"));
        }
    }
}

#[test]
fn a_frame_and_its_inverse_cancel() {
    let mut random = Random(31);
    for kinds in chains() {
        let mut g = Graph::new();
        let (frame, _) = random_chain(&mut g, &mut random, &kinds);
        let closed = frame.inverse(&mut g).after(&frame);
        let outputs = closed.pose_with_derivatives(&mut g, TIME, 2).concat();
        let values = evaluate(&g, &outputs, &[random.uniform(-0.8, 0.8)]);
        for (i, value) in values.into_iter().enumerate() {
            let expected = if [0, 4, 8].contains(&i) { 1.0 } else { 0.0 };
            assert_close(value, expected, 1e-11, &format!("chain {kinds:?}, output {i}"));
        }
    }
}

#[test]
fn replacing_time_in_a_frame_evaluates_it_there() {
    let mut random = Random(37);
    let mut g = Graph::new();
    let (frame, _) = random_chain(&mut g, &mut random, &[4, 2, 3, 6, 7]);
    let later = g.constant(0.4);
    let stopped = frame.map(|node| g.substitute(node, TIME, later));
    let (moving, still) = (frame.pose(&mut g), stopped.pose_with_derivatives(&mut g, TIME, 1));
    assert_eq!(evaluate(&g, &moving, &[0.4]), evaluate(&g, &still[0], &[9.0]));
    assert!(still[1].iter().all(|&entry| g.is_zero(entry)));
}

/// Returns the number of operations of a kernel, without constants and inputs.
fn operations(g: &Graph, outputs: &[NodeId]) -> usize {
    let tape = g.schedule(1, outputs);
    tape.instructions
        .iter()
        .filter(|i| !matches!(i, Instruction::Constant(_) | Instruction::Input(_)))
        .count()
}

/// Returns position, velocity and acceleration of the tip of a chain of joints that rotate about
/// e3, e2, e3 ... at constant rates, each with an offset along e1.
fn tip(g: &mut Graph, joints: u32) -> Vec<NodeId> {
    let time = g.symbol(TIME);
    let mut frame = Frame::ground();
    for joint in 0..joints {
        let rate = g.constant(1.0 + f64::from(joint));
        let angle = g.multiply(rate, time);
        let axis = constants(g, if joint % 2 == 0 { [0.0, 0.0, 1.0] } else { [0.0, 1.0, 0.0] });
        let arm = constants(g, [0.5 + 0.1 * f64::from(joint), 0.0, 0.0]);
        frame = Frame::translate(arm).after(&Frame::rotate(angle, axis)).after(&frame);
    }
    [frame.origin(g), frame.velocity(g, TIME), frame.acceleration(g, TIME)].concat()
}

/// The cost of a chain is linear in its length, and less than the 461 operations of differentiating
/// the eight-joint position entry by entry (shared; 37,000 as trees).
#[test]
fn chains_cost_a_fixed_number_of_operations_a_joint() {
    let counts = [4, 8, 16].map(|joints| {
        let mut g = Graph::new();
        let outputs = tip(&mut g, joints);
        operations(&g, &outputs)
    });
    assert!(counts[1] < 461, "{counts:?}");
    assert_eq!(counts[2] - counts[1], 2 * (counts[1] - counts[0]), "{counts:?}");

    let mut g = Graph::new();
    let by_rule = tip(&mut g, 8);
    let position: Vector3 = [by_rule[0], by_rule[1], by_rule[2]];
    let velocity = g.vector_derivative(position, TIME);
    let acceleration = g.vector_derivative(velocity, TIME);
    let by_entry = [position, velocity, acceleration].concat();
    assert!(operations(&g, &by_rule) < operations(&g, &by_entry));
    let values = evaluate(&g, &[by_rule, by_entry].concat(), &[0.37]);
    for i in 0..9 {
        // Accelerations reach 1e3 and result from cancellation of larger terms.
        assert_close(values[i], values[i + 9], 1e-12, "tip of eight joints");
    }
}

/// Consecutive rotations about one axis are merged into one; for directions, also across a
/// translation.
#[test]
fn rotations_about_one_axis_are_one() {
    let mut g = Graph::new();
    let (time, zero, one) = (g.symbol(0), g.constant(0.0), g.constant(1.0));
    let axis = [zero, zero, one];
    let (a, b) = (g.scale(0.7, time), g.multiply(time, time));
    let sum = g.add(a, b);
    let (first, second) = (Frame::rotate(a, axis), Frame::rotate(b, axis));
    let (together, apart) = (Frame::rotate(sum, axis), second.after(&first));
    let point = [one, time, one];
    assert_eq!(apart.apply(&mut g, point), together.apply(&mut g, point));
    assert_eq!(apart.pose_with_derivatives(&mut g, 0, 2), together.pose_with_derivatives(&mut g, 0, 2));
    let arm = Frame::translate([one, time, zero]);
    let with_arm = second.after(&arm).after(&first);
    assert_eq!(with_arm.direction(&mut g, point), together.direction(&mut g, point));
    assert_eq!(with_arm.angular_acceleration(&mut g, 0), together.angular_acceleration(&mut g, 0));
    // Rotations about other axes stay separate, and translations add up.
    let across = Frame::rotate(b, [one, zero, zero]).after(&first);
    assert_ne!(across.apply(&mut g, point), together.apply(&mut g, point));
    let twice = arm.after(&arm).apply(&mut g, point);
    let double = g.add_vectors([one, time, zero], [one, time, zero]);
    assert_eq!(twice, Frame::translate(double).apply(&mut g, point));
}
