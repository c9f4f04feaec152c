//! Vectors that a frame transforms, differentiated by rigid-body kinematics instead of entry by
//! entry.
//!
//! The derivative of `X * p` with respect to any symbol is cheapest from tip to base, factor by
//! factor (see [`calyx_symbolic::Frame`]). A vector that results from a frame is therefore stored
//! together with the frame.

use super::Lowering;
use super::value::Value;
use calyx_symbolic::{Frame, NodeId, Vector3};

/// The frame and the operation from which a vector results.
#[derive(Clone, Debug)]
pub(super) struct Motion {
    carried: TransformedQuantity,
    frame: Frame,
    /// The derivative that was already computed: its symbol and its order.
    taken: Option<(u32, usize)>,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum TransformedQuantity {
    /// A point in frame coordinates.
    Point(Vector3),
    Origin,
    Direction(Vector3),
}

/// The number of moving factors from which rigid-body kinematics is cheaper; shorter chains share
/// more operations entry by entry.
const LONG: usize = 6;

/// Highest order of derivatives by rigid-body kinematics.
const MOST_ORDER: usize = 2;

impl Lowering<'_> {
    /// Transforms a vector by a frame and stores the origin of the result.
    pub(super) fn carried(&mut self, frame: &Frame, carried: TransformedQuantity) -> Vector3 {
        let graph = &mut self.graph;
        let vector = match carried {
            TransformedQuantity::Point(point) => frame.apply(graph, point),
            TransformedQuantity::Origin => frame.origin(graph),
            TransformedQuantity::Direction(vector) => frame.direction(graph, vector),
        };
        self.motions.insert(vector, Motion { carried, frame: frame.clone(), taken: None });
        vector
    }

    pub(super) fn vector_derivative(&mut self, vector: Vector3, symbol: u32) -> Vector3 {
        let motion = self.motions.get(&vector);
        let order = motion.and_then(|motion| match motion.taken {
            None => Some(1),
            Some((by, order)) => (by == symbol && order < MOST_ORDER).then_some(order + 1),
        });
        let order = order.filter(|_| {
            motion.is_some_and(|motion| motion.frame.moving_factors(&self.graph, symbol) >= LONG)
        });
        let (Some(motion), Some(order)) = (motion.cloned(), order) else {
            return self.graph.vector_derivative(vector, symbol);
        };
        let (graph, frame) = (&mut self.graph, &motion.frame);
        let all = match motion.carried {
            TransformedQuantity::Point(point) => frame.apply_with_derivatives(graph, point, symbol, order),
            TransformedQuantity::Origin => frame.origin_with_derivatives(graph, symbol, order),
            TransformedQuantity::Direction(vector) => {
                frame.direction_with_derivatives(graph, vector, symbol, order)
            }
        };
        let Some(&derivative) = all.get(order) else {
            return self.graph.vector_derivative(vector, symbol);
        };
        self.motions.insert(derivative, Motion { taken: Some((symbol, order)), ..motion });
        derivative
    }

    /// Copies the motion of a function's body to the value of a call.
    pub(super) fn carry_motion(&mut self, body: &Value, value: &Value, replacements: &[(u32, NodeId)]) {
        match (body, value) {
            (Value::Brackets(body), Value::Brackets(value)) => {
                body.iter().zip(value).for_each(|(body, value)| self.carry_motion(body, value, replacements));
            }
            (Value::Vector(body), Value::Vector(value)) => {
                let Some(motion) = self.motions.get(body).cloned() else { return };
                // The replacement of the differentiation symbol may be an expression.
                let taken = match motion.taken {
                    Some((by, _)) if replacements.iter().any(|(symbol, _)| *symbol == by) => return,
                    taken => taken,
                };
                let graph = &mut self.graph;
                let frame = Value::Frame(motion.frame).substituted(graph, replacements);
                let mut put_in = |v: Vector3| match Value::Vector(v).substituted(graph, replacements) {
                    Value::Vector(v) => v,
                    _ => v,
                };
                let carried = match motion.carried {
                    TransformedQuantity::Point(v) => TransformedQuantity::Point(put_in(v)),
                    TransformedQuantity::Direction(v) => TransformedQuantity::Direction(put_in(v)),
                    TransformedQuantity::Origin => TransformedQuantity::Origin,
                };
                if let Value::Frame(frame) = frame {
                    self.motions.insert(*value, Motion { carried, frame, taken });
                }
            }
            _ => {}
        }
    }
}
