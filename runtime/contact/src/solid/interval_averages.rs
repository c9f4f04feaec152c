//! Averages of a function of `x - x'` over two intervals, as second differences of its second
//! integral and by Gauss rules.

/// Distance from a singular point, in sums of both half-sizes, beyond which the Gauss rule of three
/// points is exact to about 1e-12.
pub(super) const SHORT_RULE_FROM: f64 = 80.0;

/// Two intervals of one direction, described by the distribution of the differences of their
/// points; invariant under exchange.
#[derive(Clone, Copy)]
pub(super) struct Sides {
    /// Distance of the centres, positive.
    pub distance: f64,
    /// Half-sizes, ascending; their sum, difference and product.
    pub halves: [f64; 2],
    pub sum: f64,
    difference: f64,
    pub product: f64,
}

impl Sides {
    pub fn new(offset: f64, first: f64, second: f64) -> Self {
        let (sum, difference) = (first + second, (first - second).abs());
        let halves = [first.min(second), first.max(second)];
        Self { distance: offset.abs(), halves, sum, difference, product: first * second }
    }

    /// Returns a Gauss rule for x - x' that is exact to rounding for functions with a singularity
    /// at this distance.
    pub fn rule(&self, reach: f64) -> Rule {
        let parts = self.halves.map(|half| half / self.sum);
        let moments = Moments::new(parts);
        let rule = if reach > SHORT_RULE_FROM * self.sum { moments.short_rule() } else { moments.rule() };
        Rule { pairs: rule.pairs.map(|(node, weight)| (node * self.sum, weight)), ..rule }
    }

    /// Averages a function over x - x' by a rule.
    pub fn average(&self, rule: &Rule, f: impl Fn(f64) -> f64) -> f64 {
        let pair = |(node, weight): &(f64, f64)| weight * (f(self.distance + node) + f(self.distance - node));
        rule.pairs[..rule.count].iter().map(pair).sum::<f64>() + rule.center * f(self.distance)
    }

    pub fn scaled(&self, factor: f64) -> Self {
        Self {
            distance: self.distance * factor,
            halves: self.halves.map(|half| half * factor),
            sum: self.sum * factor,
            difference: self.difference * factor,
            product: self.product * factor * factor,
        }
    }

    /// Returns the distances of the ends of both intervals, whose signs in a second difference
    /// alternate, beginning with a plus.
    pub fn ends(&self) -> [f64; 4] {
        [
            self.distance + self.sum,
            self.distance + self.difference,
            (self.distance - self.sum).abs(),
            (self.distance - self.difference).abs(),
        ]
    }

    /// Returns the average of f'' over both intervals, for an even function f.
    pub fn second_difference(&self, f: impl Fn(f64) -> f64) -> f64 {
        let ends = self.ends();
        let inner = f(ends[1]);
        let other = if self.difference == 0.0 { inner } else { f(ends[3]) };
        ((f(ends[0]) - inner) + (f(ends[2]) - other)) / (4.0 * self.product)
    }
}

/// Quadrature rule for a symmetric distribution.
#[derive(Clone, Copy)]
pub(super) struct Rule {
    /// Weight of the centre.
    center: f64,
    /// Distances from the centre with their weights on either side; the first `count` are used.
    pairs: [(f64, f64); 2],
    count: usize,
}

impl Rule {
    /// Returns points about `x` with their weights, of which some may be zero.
    pub fn points(&self, x: f64) -> [(f64, f64); 5] {
        let [(inner, inner_weight), (outer, outer_weight)] = self.pairs;
        [
            (x, self.center),
            (x + inner, inner_weight),
            (x - inner, inner_weight),
            (x + outer, outer_weight),
            (x - outer, outer_weight),
        ]
    }
}

/// Even moments of the sum of variables uniform over ±a and ±b, a + b = 1, from the symmetric
/// functions of a² and b².
struct Moments {
    square: f64,
    product: f64,
    quartic: f64,
    second: f64,
    fourth: f64,
}

impl Moments {
    fn new([a, b]: [f64; 2]) -> Self {
        let (square, product) = (a * a + b * b, (a * b) * (a * b));
        let quartic = square * square - 2.0 * product;
        let (second, fourth) = (square / 3.0, quartic / 5.0 + product * (2.0 / 3.0));
        Self { square, product, quartic, second, fourth }
    }

    /// Returns the Gauss rule of three points.
    fn short_rule(&self) -> Rule {
        let node = self.fourth / self.second;
        let weight = 0.5 * self.second / node;
        Rule { center: 1.0 - 2.0 * weight, pairs: [(node.sqrt(), weight), (0.0, 0.0)], count: 1 }
    }

    /// Returns the Gauss rule of five points.
    fn rule(&self) -> Rule {
        let Self { square, product, quartic, second, fourth } = *self;
        let sixth = (square * quartic - square * product) / 7.0 + product * square;
        let eighth = (quartic * quartic - 2.0 * product * product) / 9.0
            + product * (quartic * (4.0 / 3.0) + product * (14.0 / 5.0));
        // x (x⁴ + p x² + q) is orthogonal to x and x³.
        let determinant = fourth * fourth - second * sixth;
        let p = (second * eighth - fourth * sixth) / determinant;
        let q = (sixth * sixth - fourth * eighth) / determinant;
        let root = (p * p - 4.0 * q).sqrt();
        let (outer, inner) = (0.5 * (root - p), 2.0 * q / (root - p));
        let outer_weight = 0.5 * (fourth - inner * second) / (outer * (outer - inner));
        let inner_weight = 0.5 * (outer * second - fourth) / (inner * (outer - inner));
        let center = 1.0 - 2.0 * (outer_weight + inner_weight);
        Rule { center, pairs: [(inner.sqrt(), inner_weight), (outer.sqrt(), outer_weight)], count: 2 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_short_rule_takes_over_where_it_is_exact() {
        for [a, b] in [[0.5, 0.5], [0.7, 0.3], [0.95, 0.05]] {
            let sides = Sides::new(0.2, a, b);
            let reach = 1.001 * SHORT_RULE_FROM;
            let [short, long] = [sides.rule(reach), sides.rule(0.0)];
            assert_eq!([short.count, long.count], [1, 2]);
            // The inverse distance and its integral across, whose second difference over short
            // intervals along is required.
            let inverse = |rule: &Rule| sides.average(rule, |x| x.hypot(reach).recip());
            assert!((inverse(&short) / inverse(&long) - 1.0).abs() < 1e-12);
            let error = |y: f64| {
                let smooth = |x: f64| y * (y + x.hypot(y)).ln() - x.hypot(y);
                sides.average(&short, smooth) - sides.average(&long, smooth)
            };
            let second = error(reach + 1.0) - 2.0 * error(reach) + error(reach - 1.0);
            assert!(second.abs() * reach < 5e-11, "{second:e}");
        }
    }
}
