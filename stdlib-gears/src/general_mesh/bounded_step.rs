//! Step to the largest value of a concave quadratic function of two variables within linear bounds.

/// Part of a bound by which a step may exceed it: rounding.
const ROUNDING: f64 = 1e-12;
/// Distance of a bound at which it counts as reached.
const REACHED: f64 = 1e-6;
/// Decrease of the second derivative across a reached bound, by the largest second derivative.
const ACROSS: f64 = 2.0;

/// Bounds of a linear function of a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bound {
    /// Coefficients of the function.
    pub normal: [f64; 2],
    /// Least and largest value.
    pub limits: [f64; 2],
}

/// Bound that is reached without a step and beyond which a function grows.
#[derive(Clone, Copy, Debug)]
pub(super) struct ReachedBound {
    normal: [f64; 2],
    /// Growth of the function per growth of the bounded one (Lagrange multiplier).
    factor: f64,
}

impl Bound {
    /// Returns the bound if it is reached and a function with this slope grows beyond it.
    pub fn reached_by(&self, slope: [f64; 2]) -> Option<ReachedBound> {
        let size = dot(self.normal, self.normal);
        let factor = dot(slope, self.normal) / size;
        let [low, high] = self.limits;
        let is_reached = if factor < 0.0 { low >= -REACHED } else { high <= REACHED };
        (size > 0.0 && is_reached).then_some(ReachedBound { normal: self.normal, factor })
    }
}

/// Quadratic function of a step, zero without a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Quadratic {
    pub slope: [f64; 2],
    /// Second derivatives by the first variable, by both, and by the second one.
    pub second: [f64; 3],
}

/// Step to the largest value within the bounds.
#[derive(Clone, Copy, Debug)]
pub(super) struct BoundedStep {
    pub step: [f64; 2],
    /// True if a bound limits it.
    pub is_limited: bool,
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

impl Quadratic {
    /// Returns the quadratic function with smaller second derivatives, by a part of the largest.
    pub fn damped(self, damping: f64) -> Quadratic {
        let [a, mixed, b] = self.second;
        let less = damping * a.abs().max(b.abs()).max(mixed.abs());
        Quadratic { second: [a - less, mixed, b - less], ..self }
    }

    /// Returns the function on a reached bound that is not linear but has these second derivatives:
    /// the step of a sequential quadratic program (Nocedal and Wright, *Numerical Optimization*,
    /// 2006, chapter 18). Across the bound, the function becomes concave.
    pub fn along(self, bound: ReachedBound, second: [f64; 3]) -> Quadratic {
        let curved = [0, 1, 2].map(|k: usize| self.second[k] - bound.factor * second[k]);
        let [x, y] = bound.normal;
        let largest = curved.iter().fold(0.0_f64, |largest, part| largest.max(part.abs()));
        let across = ACROSS * largest / (x * x + y * y);
        let squares = [x * x, x * y, y * y];
        Quadratic { second: [0, 1, 2].map(|k: usize| curved[k] - across * squares[k]), ..self }
    }

    fn value(&self, step: [f64; 2]) -> f64 {
        let [a, mixed, b] = self.second;
        let [x, y] = step;
        dot(self.slope, step) + 0.5 * (a * x * x + b * y * y) + mixed * x * y
    }

    /// Returns the vector whose product with the second derivatives is this one.
    fn solve(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [a, mixed, b] = self.second;
        let determinant = a * b - mixed * mixed;
        [(b * x - mixed * y) / determinant, (a * y - mixed * x) / determinant]
    }

    /// Returns the step to the largest value; `None` if the function is not concave, or no step is
    /// within the bounds.
    pub fn largest(&self, bounds: &[Bound]) -> Option<BoundedStep> {
        let [a, mixed, b] = self.second;
        if !(a < 0.0 && a * b - mixed * mixed > 0.0) {
            return None;
        }
        let free = self.solve(self.slope.map(|part| -part));
        let within = |step: &[f64; 2]| {
            bounds.iter().all(|bound| {
                let value = dot(bound.normal, *step);
                value >= bound.limits[0] - ROUNDING && value <= bound.limits[1] + ROUNDING
            })
        };
        if within(&free) {
            return Some(BoundedStep { step: free, is_limited: false });
        }
        // The largest value is on one bound or where two of them meet.
        let ends = |bound: &Bound| bound.limits.map(|limit| (bound.normal, limit));
        let limits: Vec<([f64; 2], f64)> = bounds.iter().flat_map(ends).collect();
        let on_one = limits.iter().map(|&(normal, limit)| {
            let across = self.solve(normal);
            let factor = (limit - dot(normal, free)) / dot(normal, across);
            [free[0] + factor * across[0], free[1] + factor * across[1]]
        });
        let on_two = limits.iter().enumerate().flat_map(|(index, &(first, at_first))| {
            limits[index + 1..].iter().map(move |&(second, at_second)| {
                let determinant = first[0] * second[1] - first[1] * second[0];
                [
                    (at_first * second[1] - at_second * first[1]) / determinant,
                    (at_second * first[0] - at_first * second[0]) / determinant,
                ]
            })
        });
        let possible = on_one.chain(on_two).filter(|step| step[0].is_finite() && step[1].is_finite());
        let best = possible.filter(within).max_by(|a, b| self.value(*a).total_cmp(&self.value(*b)))?;
        Some(BoundedStep { step: best, is_limited: true })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_largest_value_is_inside_on_a_bound_or_at_a_corner() {
        let function = Quadratic { slope: [1.0, 2.0], second: [-2.0, 0.5, -3.0] };
        let box_of = |high: [f64; 2]| {
            [
                Bound { normal: [1.0, 0.0], limits: [-1.0, high[0]] },
                Bound { normal: [0.0, 1.0], limits: [-1.0, high[1]] },
            ]
        };
        let free = function.largest(&box_of([9.0, 9.0])).expect("a largest value");
        assert!(!free.is_limited);
        assert!((-2.0 * free.step[0] + 0.5 * free.step[1] + 1.0).abs() < 1e-15);
        for (high, normal) in [
            ([0.3, 9.0], [1.0, 0.0]),
            ([9.0, 0.2], [0.0, 1.0]),
            ([0.1, 0.1], [0.7, 0.7]),
            ([9.0, 9.0], [1.0, -1.0]),
        ] {
            let bounds = [&box_of(high)[..], &[Bound { normal, limits: [-0.05, 0.17] }]].concat();
            let found = function.largest(&bounds).expect("a largest value");
            // No step of a fine grid within the bounds has a larger value.
            let mut largest = f64::NEG_INFINITY;
            for i in -200..200 {
                for j in -200..200 {
                    let step = [f64::from(i) / 200.0, f64::from(j) / 200.0];
                    if bounds.iter().all(|b| (b.limits[0]..=b.limits[1]).contains(&dot(b.normal, step))) {
                        largest = largest.max(function.value(step));
                    }
                }
            }
            let value = function.value(found.step);
            assert!(
                found.is_limited && value >= largest && value < largest + 0.02,
                "{high:?} {value} {largest}"
            );
        }
    }

    /// The distance from a point, with the circle about the origin as a bound: a step of the
    /// iteration is as accurate as that of Newton's method.
    #[test]
    fn steps_along_a_curved_bound_converge_quadratically() {
        let (x, y) = (1.0_f64, 0.02_f64);
        let radius = x.hypot(y);
        let from = [3.0, 0.0];
        let slope = [from[0] - x, from[1] - y];
        let bound = Bound { normal: [x / radius, y / radius], limits: [-radius, 0.0] };
        let second = [y * y / radius.powi(3), -x * y / radius.powi(3), x * x / radius.powi(3)];
        let function = Quadratic { slope, second: [-1.0, 0.0, -1.0] };
        let reached = bound.reached_by(slope).expect("the bound is reached");
        let step = function.along(reached, second).largest(&[bound]).expect("a step");
        assert!(step.is_limited && (y + step.step[1]).abs() < 2.0 * y.powi(3), "{:?}", step.step);
        let plain = function.largest(&[bound]).expect("a step");
        assert!((y + plain.step[1]).abs() > 0.5 * y, "{:?}", plain.step);
        assert!(bound.reached_by([-1.0, 0.0]).is_none());
    }

    #[test]
    fn a_function_that_is_not_concave_and_bounds_without_a_step_have_no_largest_value() {
        let function = Quadratic { slope: [1.0, 0.0], second: [-1.0, 2.0, -1.0] };
        assert!(function.largest(&[]).is_none());
        assert!(function.damped(3.0).largest(&[]).is_some());
        let impossible = [
            Bound { normal: [1.0, 0.0], limits: [1.0, 2.0] },
            Bound { normal: [1.0, 0.0], limits: [-2.0, -1.0] },
        ];
        assert!(function.damped(3.0).largest(&impossible).is_none());
    }
}
