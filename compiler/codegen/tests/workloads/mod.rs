//! The kinematic workloads W1 to W4 as graphs, with reproducible inputs: chains of translations and
//! rotations with their derivatives, as they occur in gear models.
//!
//! The workloads multiply active matrices; as coordinate transformations they describe the inverse
//! motion.

use calyx_symbolic::{Frame, Graph, NodeId, Tape, Vector3};

/// The SplitMix64 generator (Steele, Lea and Flood 2014).
pub struct Random(pub u64);

impl Random {
    /// Returns a number uniformly distributed in `low..high`.
    pub fn uniform(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^= z >> 31;
        low + (high - low) * ((z >> 11) as f64 * 2f64.powi(-53))
    }
}

/// A kernel whose inputs are variables, which vary from point to point, followed by parameters.
pub struct Workload {
    pub name: &'static str,
    pub build: fn(&mut Graph) -> Vec<NodeId>,
    /// Range of each variable.
    pub variables: &'static [(f64, f64)],
    pub parameters: &'static [f64],
    pub seed: u64,
}

pub const WORKLOADS: [Workload; 4] = [
    Workload {
        name: "W1",
        build: planet,
        variables: &[(0.0, 0.02)],
        parameters: &[10.0, 2e-6, 1e-6, 1e-6, 2e-6, 0.3, 3300.0, 1100.0],
        seed: 1,
    },
    Workload {
        name: "W2",
        build: generated,
        variables: &GENERATED_RANGES,
        parameters: &GENERATED_PARAMETERS,
        seed: 2,
    },
    Workload {
        name: "W3",
        build: sensitivity,
        variables: &GENERATED_RANGES,
        parameters: &GENERATED_PARAMETERS,
        seed: 2,
    },
    Workload { name: "W4", build: |g| chain(g, 25), variables: &[(0.0, 2.0)], parameters: &[], seed: 5 },
];

const GENERATED_RANGES: [(f64, f64); 3] = [(0.0, 1.0), (-0.8, 0.8), (-0.5, 0.5)];
const GENERATED_PARAMETERS: [f64; 21] = [
    0.32, 0.45, 3.2, 1.05, 0.11, 0.05, 0.35, -0.02, 3.1, 0.02, -0.03, 0.01, 0.004, 0.05, -0.01, 0.002, 0.03,
    0.004, -0.001, 3.0, 0.35,
];

impl Workload {
    pub fn inputs(&self) -> usize {
        self.variables.len() + self.parameters.len()
    }

    pub fn varying(&self) -> Vec<bool> {
        (0..self.inputs()).map(|input| input < self.variables.len()).collect()
    }

    pub fn tape(&self) -> Tape {
        let mut graph = Graph::new();
        let outputs = (self.build)(&mut graph);
        graph.schedule(self.inputs(), &outputs)
    }

    /// Returns the variables at many points, one column each.
    pub fn columns(&self, points: usize) -> Vec<Vec<f64>> {
        let mut random = Random(self.seed);
        let mut columns = vec![Vec::with_capacity(points); self.variables.len()];
        for _ in 0..points {
            for (column, &(low, high)) in columns.iter_mut().zip(self.variables) {
                column.push(random.uniform(low, high));
            }
        }
        columns
    }
}

/// Returns an active translation as a coordinate transformation.
fn translation(g: &mut Graph, v: Vector3) -> Frame {
    Frame::translate(g.negate_vector(v))
}

/// Returns an active rotation about a coordinate axis as a coordinate transformation.
fn rotation(g: &mut Graph, angle: NodeId, axis: usize) -> Frame {
    let (zero, one) = (g.constant(0.0), g.constant(1.0));
    let mut n = [zero; 3];
    n[axis] = one;
    Frame::rotate(g.negate(angle), n)
}

/// `first * second * ...`
fn product(factors: &[Frame]) -> Frame {
    factors.iter().fold(Frame::ground(), |chain, factor| chain.after(factor))
}

/// Returns the polynomial `c0 + c1 x + c2 x^2 + ...`, evaluated by Horner's method.
fn series(g: &mut Graph, x: NodeId, coefficients: &[NodeId]) -> NodeId {
    let zero = g.constant(0.0);
    coefficients.iter().rev().fold(zero, |sum, &coefficient| {
        let product = g.multiply(sum, x);
        g.add(product, coefficient)
    })
}

/// Builds W1: the frame of a planet gear, its first two time derivatives, and derivatives with
/// respect to design parameters.
fn planet(g: &mut Graph) -> Vec<NodeId> {
    let [time, cd, rx, ry, px, py, phase, planet, carrier] = [0, 1, 2, 3, 4, 5, 6, 7, 8].map(|i| g.symbol(i));
    let zero = g.constant(0.0);
    let relative = g.subtract(planet, carrier);
    let turn = g.multiply(relative, time);
    let turn = g.add(turn, phase);
    let carried = g.multiply(carrier, time);
    let across = g.add(cd, py);
    let frame = product(&[
        translation(g, [rx, ry, zero]),
        rotation(g, turn, 2),
        translation(g, [px, across, zero]),
        rotation(g, carried, 2),
    ]);
    let poses = frame.pose_with_derivatives(g, 0, 2);
    let mut outputs: Vec<NodeId> = poses.iter().flat_map(|p| [p[0], p[1], p[9], p[3], p[4], p[10]]).collect();
    for parameter in [1, 4, 5] {
        outputs.extend([poses[0][9], poses[0][10]].map(|entry| g.derivative(entry, parameter)));
    }
    let entries: Vec<NodeId> = outputs[..6].to_vec();
    outputs.extend(entries.into_iter().map(|entry| g.derivative(entry, 6)));
    outputs
}

/// Returns a point of a generated tooth flank, depending on machine settings. Symbols: u, theta,
/// phi, then 21 settings.
fn generated_point(g: &mut Graph) -> Vector3 {
    let [u, theta, phi] = [0, 1, 2].map(|i| g.symbol(i));
    let setting: Vec<NodeId> = (3..24).map(|i| g.symbol(i)).collect();
    let [i, j, s, q, em, xb, gm, xp, ra] = [0, 1, 2, 3, 4, 5, 6, 7, 8].map(|k: usize| setting[k]);
    let (r0, al) = (setting[19], setting[20]);
    let (zero, quarter) = (g.constant(0.0), g.constant(std::f64::consts::FRAC_PI_2));

    let mut bracket = vec![zero, g.constant(1.0)];
    for (order, &c) in (2..).zip(&setting[9..13]) {
        let factorial: f64 = (1..=order).map(f64::from).product();
        bracket.push(g.scale(-1.0 / factorial, c));
    }
    let bracket = series(g, phi, &bracket);
    let phi1 = g.multiply(ra, bracket);
    let root = g.subtract(quarter, gm);
    let sliding = series(g, phi, &[xb, setting[13], setting[14], setting[15]]);
    let offset = series(g, phi, &[em, setting[16], setting[17], setting[18]]);
    let (back, swivel) = (g.negate(phi), g.subtract(q, quarter));
    let (down, turn) = (g.negate(i), g.negate(j));
    let lower = g.negate(offset);
    let frame = product(&[
        rotation(g, phi1, 2),
        translation(g, [zero, zero, xp]),
        rotation(g, root, 1),
        translation(g, [zero, zero, sliding]),
        translation(g, [zero, lower, zero]),
        rotation(g, back, 2),
        rotation(g, swivel, 2),
        translation(g, [zero, s, zero]),
        rotation(g, turn, 2),
        rotation(g, down, 1),
        rotation(g, theta, 2),
    ]);
    let (sine, cosine) = (g.sin(al), g.cos(al));
    let (across, along) = (g.multiply(u, sine), g.multiply(u, cosine));
    let blade = [g.add(r0, across), zero, g.negate(along)];
    frame.apply(g, blade)
}

/// Builds W2: the point, its first and second derivatives, the function whose zeros define the
/// envelope, and its gradient.
fn generated(g: &mut Graph) -> Vec<NodeId> {
    let x = generated_point(g);
    let firsts = [0, 1, 2].map(|variable| g.vector_derivative(x, variable));
    let normal = g.cross(firsts[0], firsts[1]);
    let envelope = g.dot(normal, firsts[2]);
    let mut outputs = [x, firsts[0], firsts[1], firsts[2]].concat();
    outputs.push(envelope);
    outputs.extend([0, 1, 2].map(|variable| g.derivative(envelope, variable)));
    for (first, second) in [(0, 1), (0, 2), (1, 1), (1, 2), (2, 2)] {
        outputs.extend(g.vector_derivative(firsts[first], second));
    }
    outputs
}

/// Builds W3: the point and its derivatives with respect to all settings, without the constant
/// ones.
fn sensitivity(g: &mut Graph) -> Vec<NodeId> {
    let x = generated_point(g);
    let mut outputs = x.to_vec();
    for setting in 0..21 {
        let derivative = g.vector_derivative(x, setting + 3);
        match setting {
            7 => {}
            4 | 8..=12 | 16..=18 => outputs.extend(&derivative[..2]),
            _ => outputs.extend(derivative),
        }
    }
    outputs
}

/// Returns a polynomial in time with the next random coefficients: multiples of 0.001 from -1 to 1.
fn polynomial(g: &mut Graph, random: &mut Random, degree: usize) -> NodeId {
    let time = g.symbol(0);
    let coefficients: Vec<NodeId> = (0..=degree)
        .map(|_| ((random.uniform(0.0, 1.0) * 2001.0).floor() - 1000.0) / 1000.0)
        .map(|coefficient| g.constant(coefficient))
        .collect();
    series(g, time, &coefficients)
}

/// Builds W4 (25 pairs): alternating translations and rotations, with the first two time
/// derivatives of all entries.
pub fn chain(g: &mut Graph, pairs: usize) -> Vec<NodeId> {
    let mut random = Random(4);
    let mut frame = Frame::ground();
    for pair in 0..pairs {
        let v = [0; 3].map(|_| polynomial(g, &mut random, 2));
        let angle = polynomial(g, &mut random, 3);
        let axis = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.36, 0.48, 0.8]][pair % 4];
        let axis = axis.map(|component| g.constant(component));
        let (v, angle) = (g.negate_vector(v), g.negate(angle));
        frame = frame.after(&Frame::translate(v)).after(&Frame::rotate(angle, axis));
    }
    let rows = |p: [NodeId; 12]| [0, 1, 2].map(|i| [p[3 * i], p[3 * i + 1], p[3 * i + 2], p[9 + i]]).concat();
    frame.pose_with_derivatives(g, 0, 2).into_iter().flat_map(rows).collect()
}
