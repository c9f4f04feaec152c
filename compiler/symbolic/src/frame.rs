//! Coordinate frames as chains of translations and rotations, and their velocities and
//! accelerations by rigid-body kinematics.
//!
//! A frame is a coordinate transformation from ground into the frame, in the convention of the
//! report (sections 2.4.1 and 3.1.2). `Translate(v)` transforms into a frame displaced by `v`: `x'
//! = x - v`. `Rotate(a, n)` transforms into a frame rotated by the angle `a` about the unit axis
//! `n`: `x' = Q^T x`, where `Q` is the right-handed rotation matrix. In `A * B` the transformation
//! `B` is applied first, so a chain is read from right to left, starting at ground.
//!
//! The chain is stored as factors. A vector and its time derivatives (a *jet*) are transformed
//! factor by factor. For a rotation with angular velocity `w = a' n` and angular acceleration `e =
//! a'' n`: `(Q x)' = Q (x' + w x x)` and `(Q x)'' = Q (x'' + e x x + w x (2 x' + w x x))`. From tip
//! to base this costs about thirty operations per joint, a third of the cost of differentiated
//! matrix products. Consecutive rotations about the same axis are merged into one rotation by the
//! sum of their angles. Factors of another form (a moving axis, a conditional frame) are
//! differentiated entry by entry.

use crate::graph::{Graph, NodeId, Unary};
use crate::vector::{Matrix3, Vector3, transposed};

/// A coordinate transformation in a [`Frame`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Factor {
    /// Translation: `x' = x - v`.
    Translate(Vector3),
    /// Rotation: `x' = Q(angle, axis)^T x`. The axis has unit length.
    Rotate { angle: NodeId, axis: Vector3 },
    /// Rigid transformation: `x' = R x + t`, where `R` is orthonormal.
    Rigid { rotation: Matrix3, translation: Vector3 },
}

/// Rotation matrix (ground to frame, row by row) and translation: `x' = R x + t`.
pub type Pose = [NodeId; 12];

/// A vector followed by its time derivatives.
type Jet = Vec<Vector3>;

/// A chain of coordinate transformations.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Frame {
    /// Factors in order of application. The first one starts at ground.
    factors: Vec<Factor>,
}

impl Frame {
    /// Returns the ground frame: the identity.
    pub fn ground() -> Self {
        Self::default()
    }

    pub fn translate(v: Vector3) -> Self {
        Frame { factors: vec![Factor::Translate(v)] }
    }

    pub fn rotate(angle: NodeId, axis: Vector3) -> Self {
        Frame { factors: vec![Factor::Rotate { angle, axis }] }
    }

    pub fn rigid(rotation: Matrix3, translation: Vector3) -> Self {
        Frame { factors: vec![Factor::Rigid { rotation, translation }] }
    }

    /// Returns the frame with a given pose, for example a pose of twelve inputs.
    pub fn from_pose(pose: Pose) -> Self {
        let row = |i: usize| [pose[3 * i], pose[3 * i + 1], pose[3 * i + 2]];
        Self::rigid([row(0), row(1), row(2)], row(3))
    }

    /// Returns the factors in order of application from ground.
    pub fn factors(&self) -> &[Factor] {
        &self.factors
    }

    /// Returns the composition `self * first`: `first` is applied first.
    pub fn after(&self, first: &Frame) -> Self {
        Frame { factors: first.factors.iter().chain(&self.factors).copied().collect() }
    }

    /// Returns the inverse transformation, from the frame to ground.
    pub fn inverse(&self, graph: &mut Graph) -> Self {
        let invert = |factor: &Factor| match *factor {
            Factor::Translate(v) => Factor::Translate(graph.negate_vector(v)),
            Factor::Rotate { angle, axis } => Factor::Rotate { angle: graph.negate(angle), axis },
            Factor::Rigid { rotation, translation } => {
                let back = transposed(rotation);
                let moved = graph.transform(back, translation);
                Factor::Rigid { rotation: back, translation: graph.negate_vector(moved) }
            }
        };
        Frame { factors: self.factors.iter().rev().map(invert).collect() }
    }

    /// Returns the frame with every expression replaced.
    pub fn map(&self, mut replace: impl FnMut(NodeId) -> NodeId) -> Self {
        let mapped = |factor: &Factor| match *factor {
            Factor::Translate(v) => Factor::Translate(v.map(&mut replace)),
            Factor::Rotate { angle, axis } => {
                Factor::Rotate { angle: replace(angle), axis: axis.map(&mut replace) }
            }
            Factor::Rigid { rotation, translation } => Factor::Rigid {
                rotation: rotation.map(|row| row.map(&mut replace)),
                translation: translation.map(&mut replace),
            },
        };
        Frame { factors: self.factors.iter().map(mapped).collect() }
    }

    /// Returns the frame that equals `then` if the condition is true and `otherwise` if not.
    pub fn select(graph: &mut Graph, condition: NodeId, then: &Frame, otherwise: &Frame) -> Self {
        if then == otherwise {
            return then.clone();
        }
        let (then, otherwise) = (then.pose(graph), otherwise.pose(graph));
        let mut chosen = then;
        for (entry, other) in chosen.iter_mut().zip(otherwise) {
            *entry = graph.select(condition, *entry, other);
        }
        Self::from_pose(chosen)
    }

    /// Returns the coordinates in this frame of a point given in ground coordinates.
    pub fn apply(&self, graph: &mut Graph, point: Vector3) -> Vector3 {
        self.fused(graph).iter().fold(point, |x, factor| factor.enter(graph, vec![x], None)[0])
    }

    /// Returns the frame's origin in ground coordinates.
    pub fn origin(&self, graph: &mut Graph) -> Vector3 {
        let zero = graph.zero_vector();
        self.point_to_ground(graph, vec![zero], None)[0]
    }

    /// Returns the ground coordinates of a direction given in this frame.
    pub fn direction(&self, graph: &mut Graph, vector: Vector3) -> Vector3 {
        self.turns(graph).iter().rev().fold(vector, |x, factor| factor.turn_out(graph, vec![x], None)[0])
    }

    /// Returns [`Frame::apply`] and its derivatives with respect to a symbol, up to `order` (at
    /// most 2). The derivatives treat the frame as a rigid body.
    pub fn apply_with_derivatives(
        &self,
        graph: &mut Graph,
        point: Vector3,
        symbol: u32,
        order: usize,
    ) -> Vec<Vector3> {
        let point = jet(graph, point, order.min(2) + 1, Some(symbol));
        self.fused(graph).iter().fold(point, |x, factor| factor.enter(graph, x, Some(symbol)))
    }

    /// Returns [`Frame::origin`] and its derivatives with respect to a symbol, up to `order` (at
    /// most 2).
    pub fn origin_with_derivatives(&self, graph: &mut Graph, symbol: u32, order: usize) -> Vec<Vector3> {
        let rest = vec![graph.zero_vector(); order.min(2) + 1];
        self.point_to_ground(graph, rest, Some(symbol))
    }

    /// Returns [`Frame::direction`] and its derivatives with respect to a symbol, up to `order` (at
    /// most 2).
    pub fn direction_with_derivatives(
        &self,
        graph: &mut Graph,
        vector: Vector3,
        symbol: u32,
        order: usize,
    ) -> Vec<Vector3> {
        let order = order.min(2);
        let vector = jet(graph, vector, order + 1, Some(symbol));
        let rests = vector[1..].iter().flatten().all(|&rate| graph.is_zero(rate));
        if !rests || order == 0 {
            let turns = self.turns(graph);
            return turns.iter().rev().fold(vector, |x, factor| factor.turn_out(graph, x, Some(symbol)));
        }
        // All vectors that are fixed in the frame share its angular velocity.
        let spin = self.spin_in_ground(graph, symbol, order);
        let mut turned = vec![self.direction(graph, vector[0])];
        turned.push(graph.cross(spin[0], turned[0]));
        if let Some(&change) = spin.get(1) {
            let (changing, sweeping) = (graph.cross(change, turned[0]), graph.cross(spin[0], turned[1]));
            turned.push(graph.add_vectors(changing, sweeping));
        }
        turned
    }

    /// Returns the number of factors that depend on a symbol.
    pub fn moving_factors(&self, graph: &Graph, symbol: u32) -> usize {
        let moves = |factor: &&Factor| {
            let mut nodes = Vec::new();
            Frame { factors: vec![**factor] }.map(|node| {
                nodes.push(node);
                node
            });
            graph.depends_on(&nodes, |found| found == symbol)
        };
        self.factors.iter().filter(moves).count()
    }

    /// Returns the velocity of the origin relative to ground, in ground coordinates. `time` is the
    /// symbol of time.
    pub fn velocity(&self, graph: &mut Graph, time: u32) -> Vector3 {
        let rest = vec![graph.zero_vector(); 2];
        self.point_to_ground(graph, rest, Some(time))[1]
    }

    /// Returns the acceleration of the origin relative to ground, in ground coordinates.
    pub fn acceleration(&self, graph: &mut Graph, time: u32) -> Vector3 {
        let rest = vec![graph.zero_vector(); 3];
        self.point_to_ground(graph, rest, Some(time))[2]
    }

    /// Returns the angular velocity relative to ground, in ground coordinates.
    pub fn angular_velocity(&self, graph: &mut Graph, time: u32) -> Vector3 {
        self.spin_in_ground(graph, time, 1)[0]
    }

    /// Returns the angular acceleration relative to ground, in ground coordinates.
    pub fn angular_acceleration(&self, graph: &mut Graph, time: u32) -> Vector3 {
        self.spin_in_ground(graph, time, 2)[1]
    }

    /// Returns the chain as one rotation matrix and one translation.
    pub fn pose(&self, graph: &mut Graph) -> Pose {
        let rotation = self.rotation(graph);
        let zero = graph.zero_vector();
        let translation = self.apply(graph, zero);
        join(rotation, translation)
    }

    /// Returns the pose followed by its time derivatives up to `order` (at most 2).
    pub fn pose_with_derivatives(&self, graph: &mut Graph, time: u32, order: usize) -> Vec<Pose> {
        let order = order.min(2);
        let mut rotations = vec![self.rotation(graph)];
        if order > 0 {
            let spin = self.spin_in_frame(graph, time, order);
            rotations = turning(graph, rotations[0], &spin);
        }
        // The translation is ground's origin in frame coordinates.
        let mut ground = vec![graph.zero_vector(); order + 1];
        for factor in self.fused(graph) {
            ground = factor.enter(graph, ground, Some(time));
        }
        rotations.into_iter().zip(ground).map(|(rotation, translation)| join(rotation, translation)).collect()
    }

    /// Returns the factors with consecutive rotations about one axis merged, and consecutive
    /// translations merged.
    fn fused(&self, graph: &mut Graph) -> Vec<Factor> {
        fuse(graph, self.factors.iter().copied())
    }

    /// Returns the rotation factors, merged. Translations do not affect directions.
    fn turns(&self, graph: &mut Graph) -> Vec<Factor> {
        fuse(graph, self.factors.iter().copied().filter(|factor| !matches!(factor, Factor::Translate(_))))
    }

    /// Returns the rotation matrix from ground into the frame.
    fn rotation(&self, graph: &mut Graph) -> Matrix3 {
        let mut matrix = graph.identity_matrix();
        for factor in self.turns(graph) {
            matrix = match factor {
                Factor::Translate(_) => continue,
                Factor::Rotate { angle, axis } => {
                    let turn = transposed(rotation_matrix(graph, angle, axis));
                    graph.multiply_matrices(turn, matrix)
                }
                Factor::Rigid { rotation, .. } => graph.multiply_matrices(rotation, matrix),
            };
        }
        matrix
    }

    /// Transforms a point and its time derivatives from frame coordinates to ground coordinates.
    fn point_to_ground(&self, graph: &mut Graph, point: Jet, time: Option<u32>) -> Jet {
        self.fused(graph).iter().rev().fold(point, |x, factor| match *factor {
            Factor::Translate(v) => {
                let v = jet(graph, v, x.len(), time);
                x.into_iter().zip(v).map(|(x, v)| graph.add_vectors(x, v)).collect()
            }
            Factor::Rotate { .. } => factor.turn_out(graph, x, time),
            Factor::Rigid { translation, .. } => {
                let t = jet(graph, translation, x.len(), time);
                let shifted = x.into_iter().zip(t).map(|(x, t)| graph.subtract_vectors(x, t)).collect();
                factor.turn_out(graph, shifted, time)
            }
        })
    }

    /// Returns the angular velocity and its time derivatives, `len` vectors in all, in ground
    /// coordinates.
    fn spin_in_ground(&self, graph: &mut Graph, time: u32, len: usize) -> Jet {
        let rest = vec![graph.zero_vector(); len];
        self.turns(graph).iter().rev().fold(rest, |spin, factor| {
            // A factor's own angular velocity is expressed in the frame that the factor leads to.
            // The angular velocities of the outer factors are expressed in the same frame.
            let Some(own) = factor.spin(graph, time, len) else { return spin };
            let sum = spin.into_iter().zip(own).map(|(a, b)| graph.add_vectors(a, b)).collect();
            factor.turn_out(graph, sum, Some(time))
        })
    }

    /// Returns the angular velocity and its time derivatives in frame coordinates.
    fn spin_in_frame(&self, graph: &mut Graph, time: u32, len: usize) -> Jet {
        let rest = vec![graph.zero_vector(); len];
        self.turns(graph).iter().fold(rest, |spin, factor| {
            let Some(own) = factor.spin(graph, time, len) else { return spin };
            let turned = factor.turn_in(graph, spin, Some(time));
            turned.into_iter().zip(own).map(|(a, b)| graph.add_vectors(a, b)).collect()
        })
    }
}

impl Factor {
    /// Transforms a point and its time derivatives into the frame that this factor leads to.
    fn enter(&self, graph: &mut Graph, x: Jet, time: Option<u32>) -> Jet {
        match *self {
            Factor::Translate(v) => {
                let v = jet(graph, v, x.len(), time);
                x.into_iter().zip(v).map(|(x, v)| graph.subtract_vectors(x, v)).collect()
            }
            Factor::Rotate { .. } => self.turn_in(graph, x, time),
            Factor::Rigid { translation, .. } => {
                let t = jet(graph, translation, x.len(), time);
                let turned = self.turn_in(graph, x, time);
                turned.into_iter().zip(t).map(|(x, t)| graph.add_vectors(x, t)).collect()
            }
        }
    }

    /// Applies the rotation of this factor to a vector and its time derivatives.
    fn turn_in(&self, graph: &mut Graph, x: Jet, time: Option<u32>) -> Jet {
        match *self {
            Factor::Translate(_) => x,
            Factor::Rotate { angle, axis } => {
                let turn = transposed(rotation_matrix(graph, angle, axis));
                let reversed = graph.negate(angle);
                turn_jet(graph, turn, reversed, axis, x, time)
            }
            Factor::Rigid { rotation, .. } => matrix_times_jet(graph, rotation, x, time),
        }
    }

    /// Applies the inverse rotation of this factor to a vector and its time derivatives.
    fn turn_out(&self, graph: &mut Graph, x: Jet, time: Option<u32>) -> Jet {
        match *self {
            Factor::Translate(_) => x,
            Factor::Rotate { angle, axis } => {
                let turn = rotation_matrix(graph, angle, axis);
                turn_jet(graph, turn, angle, axis, x, time)
            }
            Factor::Rigid { rotation, .. } => matrix_times_jet(graph, transposed(rotation), x, time),
        }
    }

    /// Returns this factor's contribution to the angular velocity and its time derivatives, in the
    /// frame that the factor leads to. Returns `None` for a translation.
    fn spin(&self, graph: &mut Graph, time: u32, len: usize) -> Option<Jet> {
        let velocity = match *self {
            Factor::Translate(_) => return None,
            Factor::Rotate { angle, axis } if is_at_rest(graph, axis, time) => {
                let rate = graph.derivative(angle, time);
                graph.scale_vector(rate, axis)
            }
            Factor::Rotate { angle, axis } => {
                let rotation = transposed(rotation_matrix(graph, angle, axis));
                spin_of_matrix(graph, rotation, time)
            }
            Factor::Rigid { rotation, .. } => spin_of_matrix(graph, rotation, time),
        };
        Some(jet(graph, velocity, len, Some(time)))
    }
}

/// Merges adjacent rotations about the same axis and adjacent translations.
fn fuse(graph: &mut Graph, factors: impl Iterator<Item = Factor>) -> Vec<Factor> {
    let mut fused: Vec<Factor> = Vec::new();
    for factor in factors {
        let joint = match (fused.last(), factor) {
            (Some(&Factor::Translate(v)), Factor::Translate(w)) => {
                Some(Factor::Translate(graph.add_vectors(v, w)))
            }
            (Some(&Factor::Rotate { angle, axis }), Factor::Rotate { angle: further, axis: same })
                if axis == same =>
            {
                Some(Factor::Rotate { angle: graph.add(angle, further), axis })
            }
            _ => None,
        };
        match (joint, fused.last_mut()) {
            (Some(joint), Some(last)) => *last = joint,
            _ => fused.push(factor),
        }
    }
    fused
}

/// Returns `Q x` and its time derivatives, where `Q` is the rotation by `angle` about `axis`.
fn turn_jet(
    graph: &mut Graph,
    matrix: Matrix3,
    angle: NodeId,
    axis: Vector3,
    x: Jet,
    time: Option<u32>,
) -> Jet {
    let time = match time {
        Some(time) if x.len() > 1 => time,
        _ => return x.into_iter().map(|x| graph.transform(matrix, x)).collect(),
    };
    if !is_at_rest(graph, axis, time) {
        return matrix_times_jet(graph, matrix, x, Some(time));
    }
    let rate = graph.derivative(angle, time);
    let spin = graph.scale_vector(rate, axis);
    let swept = graph.cross(spin, x[0]);
    let first = graph.add_vectors(x[1], swept);
    let mut inside = vec![x[0], first];
    if let Some(&second) = x.get(2) {
        let rate_of_change = graph.derivative(rate, time);
        let change = graph.scale_vector(rate_of_change, axis);
        let changing = graph.cross(change, x[0]);
        let twice = graph.add_vectors(x[1], first);
        let sweeping = graph.cross(spin, twice);
        let sum = graph.add_vectors(second, changing);
        inside.push(graph.add_vectors(sum, sweeping));
    }
    inside.into_iter().map(|x| graph.transform(matrix, x)).collect()
}

/// Returns `M x` and its time derivatives by the Leibniz rule, entry by entry.
fn matrix_times_jet(graph: &mut Graph, matrix: Matrix3, x: Jet, time: Option<u32>) -> Jet {
    let mut matrices = vec![matrix];
    if let Some(time) = time {
        for order in 1..x.len() {
            matrices.push(graph.matrix_derivative(matrices[order - 1], time));
        }
    }
    let mut result = Vec::with_capacity(x.len());
    for order in 0..x.len() {
        let mut binomial = 1.0;
        let mut sum = graph.transform(matrix, x[order]);
        for moved in 1..=order.min(matrices.len() - 1) {
            binomial = binomial * (order + 1 - moved) as f64 / moved as f64;
            let term = graph.transform(matrices[moved], x[order - moved]);
            let factor = graph.constant(binomial);
            let term = graph.scale_vector(factor, term);
            sum = graph.add_vectors(sum, term);
        }
        result.push(sum);
    }
    result
}

/// Returns `R`, `R'` and `R''` of a rotation matrix from ground into the frame, from the angular
/// velocity in frame coordinates. A direction `r` fixed in ground satisfies `r' = -w x r`.
fn turning(graph: &mut Graph, rotation: Matrix3, spin: &Jet) -> Vec<Matrix3> {
    let columns = transposed(rotation);
    let firsts = columns.map(|r| {
        let swept = graph.cross(r, spin[0]);
        (r, swept)
    });
    let mut result = vec![rotation, transposed(firsts.map(|(_, first)| first))];
    if let Some(&change) = spin.get(1) {
        let seconds = firsts.map(|(r, first)| {
            let (changing, sweeping) = (graph.cross(r, change), graph.cross(first, spin[0]));
            graph.add_vectors(changing, sweeping)
        });
        result.push(transposed(seconds));
    }
    result
}

/// Returns the angular velocity, in frame coordinates, of a rotation matrix from ground into the
/// frame: `R' R^T` is the negative cross-product matrix of the angular velocity.
fn spin_of_matrix(graph: &mut Graph, rotation: Matrix3, time: u32) -> Vector3 {
    let rate = graph.matrix_derivative(rotation, time);
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| graph.dot(rate[i], rotation[j]))
}

/// Returns the right-handed rotation by an angle about a unit axis (Rodrigues' rotation formula).
fn rotation_matrix(graph: &mut Graph, angle: NodeId, axis: Vector3) -> Matrix3 {
    let (sine, cosine) = (graph.unary(Unary::Sin, angle), graph.unary(Unary::Cos, angle));
    let one = graph.constant(1.0);
    let versine = graph.subtract(one, cosine);
    let mut matrix = [[one; 3]; 3];
    for i in 0..3 {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        // For a coordinate axis, the diagonal entry is exactly 1 or the cosine.
        matrix[i][i] = match graph.constant_value(axis[i]) {
            Some(n) if n.abs() == 1.0 => one,
            Some(0.0) => cosine,
            _ => {
                let square = graph.multiply(axis[i], axis[i]);
                let share = graph.multiply(square, versine);
                graph.add(share, cosine)
            }
        };
        let product = graph.multiply(axis[i], axis[j]);
        let symmetric = graph.multiply(product, versine);
        let skew = graph.multiply(axis[k], sine);
        matrix[i][j] = graph.subtract(symmetric, skew);
        matrix[j][i] = graph.add(symmetric, skew);
    }
    matrix
}

/// Returns a vector and its time derivatives, `len` in all; only the vector if there is no symbol
/// of time.
fn jet(graph: &mut Graph, vector: Vector3, len: usize, time: Option<u32>) -> Jet {
    let mut result = vec![vector];
    if let Some(time) = time {
        for order in 1..len {
            result.push(graph.vector_derivative(result[order - 1], time));
        }
    }
    result
}

fn is_at_rest(graph: &mut Graph, vector: Vector3, time: u32) -> bool {
    let rate = graph.vector_derivative(vector, time);
    rate.iter().all(|&component| graph.is_zero(component))
}

fn join(rotation: Matrix3, translation: Vector3) -> Pose {
    let [a, b, c] = rotation;
    let [[a1, a2, a3], [b1, b2, b3], [c1, c2, c3], [t1, t2, t3]] = [a, b, c, translation];
    [a1, a2, a3, b1, b2, b3, c1, c2, c3, t1, t2, t3]
}
