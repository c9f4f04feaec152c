//! Coupling of slices along a face whose teeth vary in height: the response `K(v, v')` of a row of
//! slices that shear each other, `K - (length² K')' = delta` between free side faces.
//!
//! The length, over which slices distribute a load, is that of [`super::AnalyticSolid`], but varies
//! along the face. The solution is `A(lesser) B(greater)`, where `A` and `B` solve the homogeneous
//! equation and have a free lower or upper end. Both come from linear elements with lumped slices,
//! whose nodal values satisfy the law that a uniform load moves all slices alike, exactly.

/// Number of elements.
const ELEMENTS: usize = 512;
/// Smallest length over which slices distribute a load, relative to the face: the exponentials of
/// longer faces would overflow.
const SHORTEST: f64 = 1.0 / 300.0;
/// Ratio of a stretch to the face below which the stretch is a point.
const POINT: f64 = 1e-5;
/// Abscissas of the two-point Gauss rule on a unit interval: exact for cubics.
const GAUSS: [f64; 2] = [0.5 - 0.5 * super::cantilever::GAUSS, 0.5 + 0.5 * super::cantilever::GAUSS];

/// Green's function of the slices of a face.
#[derive(Clone, Debug)]
pub(super) struct FaceCoupling {
    from: f64,
    step: f64,
    nodes: Vec<Node>,
}

/// Solutions at a node and their integrals up to it.
#[derive(Clone, Copy, Debug, Default)]
struct Node {
    /// Solution with a free lower end; growing.
    a: f64,
    /// Solution with a free upper end, divided by the Wronskian; decaying.
    b: f64,
    /// Integral of `a` from the lower end.
    up_to: f64,
    /// Integral of `b` to the upper end.
    beyond: f64,
    /// Twice the integral of `b` times [`Self::up_to`] from the lower end: that of `K` over a
    /// square.
    square: f64,
}

/// Stretch of a face, over which a load is distributed or a displacement averaged.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stretch {
    ends: [f64; 2],
    /// Values at both ends; of a point, twice at the same.
    at: [Node; 2],
}

impl FaceCoupling {
    /// Builds the row of slices between two positions, by the length over which slices distribute a
    /// load at each position, m.
    pub fn new([from, to]: [f64; 2], length: impl Fn(f64) -> f64) -> FaceCoupling {
        let step = (to - from) / ELEMENTS as f64;
        let shortest = SHORTEST * (to - from);
        let stiffness: Vec<f64> = (0..ELEMENTS)
            .map(|k| length(from + (k as f64 + 0.5) * step).max(shortest).powi(2) / step)
            .collect();
        let slice = |k: usize| if k == 0 || k == ELEMENTS { 0.5 * step } else { step };
        // The force between two slices balances all slices on one side.
        let solved = |order: &dyn Fn(usize) -> usize, spring: &dyn Fn(usize) -> usize| {
            let mut values = vec![1.0; ELEMENTS + 1];
            let mut force = 0.0;
            for k in 0..ELEMENTS {
                force += slice(order(k)) * values[order(k)];
                values[order(k + 1)] = values[order(k)] + force / stiffness[spring(k)];
            }
            values
        };
        let a = solved(&|k| k, &|k| k);
        let b = solved(&|k| ELEMENTS - k, &|k| ELEMENTS - 1 - k);
        let middle = ELEMENTS / 2;
        let wronskian = stiffness[middle] * (a[middle + 1] * b[middle] - a[middle] * b[middle + 1]);
        let mut nodes: Vec<Node> =
            a.iter().zip(&b).map(|(&a, b)| Node { a, b: b / wronskian, ..Node::default() }).collect();
        for k in 0..ELEMENTS {
            nodes[k + 1].up_to = nodes[k].up_to + 0.5 * step * (nodes[k].a + nodes[k + 1].a);
            let k = ELEMENTS - 1 - k;
            nodes[k].beyond = nodes[k + 1].beyond + 0.5 * step * (nodes[k].b + nodes[k + 1].b);
        }
        let mut coupling = FaceCoupling { from, step, nodes };
        for k in 0..ELEMENTS {
            coupling.nodes[k + 1].square = coupling.within(k, 1.0).square;
        }
        coupling
    }

    /// Returns the values at a part of an element. Both solutions are interpolated linearly.
    fn within(&self, element: usize, part: f64) -> Node {
        let [low, high] = [self.nodes[element], self.nodes[element + 1]];
        let length = part * self.step;
        let between = |low: f64, high: f64, part: f64| low + part * (high - low);
        let up_to = |part: f64| low.up_to + part * self.step * between(low.a, high.a, 0.5 * part);
        let rest = 1.0 - part;
        let integrand = |x: f64| between(low.b, high.b, x) * up_to(x);
        Node {
            a: between(low.a, high.a, part),
            b: between(low.b, high.b, part),
            up_to: up_to(part),
            beyond: high.beyond + rest * self.step * between(high.b, low.b, 0.5 * rest),
            square: low.square + length * (integrand(part * GAUSS[0]) + integrand(part * GAUSS[1])),
        }
    }

    fn at(&self, v: f64) -> Node {
        let along = ((v - self.from) / self.step).clamp(0.0, ELEMENTS as f64);
        let element = (along as usize).min(ELEMENTS - 1);
        self.within(element, along - element as f64)
    }

    /// Returns the stretch of a length around a position. Parts beyond the face are cut off.
    pub fn stretch(&self, v: f64, length: f64) -> Stretch {
        let to = self.from + self.step * ELEMENTS as f64;
        let v = v.clamp(self.from, to);
        if length <= POINT * (to - self.from) {
            return Stretch { ends: [v, v], at: [self.at(v); 2] };
        }
        let ends = [(v - 0.5 * length).max(self.from), (v + 0.5 * length).min(to)];
        Stretch { ends, at: ends.map(|end| self.at(end)) }
    }

    /// Returns K, averaged over both stretches, 1/m. Exchanging the two gives the same bits.
    pub fn mean(one: &Stretch, other: &Stretch) -> f64 {
        let ascending = one.ends[0].total_cmp(&other.ends[0]).then(one.ends[1].total_cmp(&other.ends[1]));
        let [first, second] = if ascending.is_le() { [one, other] } else { [other, one] };
        if first.ends[1] <= second.ends[0] {
            return first.growing() * second.decaying();
        }
        let [[a, b], [c, d]] = [first.at, second.at];
        if second.length() <= 0.0 {
            // A point within a stretch.
            return (c.b * (c.up_to - a.up_to) + c.a * (c.beyond - b.beyond)) / first.length();
        }
        // Integral of K over the rectangle from the lower end to two positions.
        let corner = |low: Node, high: Node| low.square + low.up_to * (low.beyond - high.beyond);
        let far = if first.ends[1] <= second.ends[1] { corner(b, d) } else { corner(d, b) };
        let near = [corner(a, d), corner(c, b), corner(a, c)];
        (far - near[0] - near[1] + near[2]) / (first.length() * second.length())
    }

    /// Returns the memory, in bytes.
    pub fn bytes(&self) -> usize {
        size_of_val(self.nodes.as_slice())
    }
}

impl Stretch {
    fn length(&self) -> f64 {
        self.ends[1] - self.ends[0]
    }

    /// Mean of the growing solution.
    fn growing(&self) -> f64 {
        let [low, high] = self.at;
        if self.length() > 0.0 { (high.up_to - low.up_to) / self.length() } else { low.a }
    }

    /// Mean of the decaying solution.
    fn decaying(&self) -> f64 {
        let [low, high] = self.at;
        if self.length() > 0.0 { (low.beyond - high.beyond) / self.length() } else { low.b }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FACE: [f64; 2] = [-3e-3, 5e-3];

    fn mean(coupling: &FaceCoupling, [v, length]: [f64; 2], [w, other]: [f64; 2]) -> f64 {
        FaceCoupling::mean(&coupling.stretch(v, length), &coupling.stretch(w, other))
    }

    /// Between free ends `K = cosh(lower) cosh(upper) / (l sinh(width))` with the distances from
    /// both ends in lengths `l`.
    #[test]
    fn with_a_constant_length_it_is_a_product_of_hyperbolic_cosines() {
        let length = 0.8e-3;
        let coupling = FaceCoupling::new(FACE, |_| length);
        let [from, to] = FACE;
        let exact = |v: f64, w: f64| {
            let [low, high] = [(v.min(w) - from) / length, (to - v.max(w)) / length];
            low.cosh() * high.cosh() / (length * ((to - from) / length).sinh())
        };
        for (v, w) in [(-3e-3, -3e-3), (-3e-3, -2.1e-3), (0.4e-3, 0.1e-3), (5e-3, 4.2e-3), (1.1e-3, 1.1e-3)] {
            let found = mean(&coupling, [v, 0.0], [w, 0.0]);
            assert!((found / exact(v, w) - 1.0).abs() < 2e-4, "{v} {w}: {found} {}", exact(v, w));
        }
    }

    /// A uniform load moves all slices alike, for every stretch of slices and for any length; the
    /// mean over stretches that overlap, touch or contain each other is the one of their parts.
    #[test]
    fn stretches_add_up() {
        let taper = |v: f64| 0.7e-3 + 0.1 * v;
        let coupling = FaceCoupling::new(FACE, taper);
        let cuts = [-3e-3, -2.9e-3, -1.4e-3, 0.2e-3, 0.21e-3, 3.3e-3, 5e-3];
        let parts: Vec<[f64; 2]> =
            cuts.windows(2).map(|pair| [0.5 * (pair[0] + pair[1]), pair[1] - pair[0]]).collect();
        for observer in [[-2.95e-3, 0.0], [0.2e-3, 0.0], [0.3e-3, 2e-3], [1e-3, 8e-3], [-2e-3, 1.9e-3]] {
            let sum: f64 = parts.iter().map(|part| part[1] * mean(&coupling, observer, *part)).sum();
            assert!((sum - 1.0).abs() < 3e-4, "{observer:?}: {sum}");
            for pair in parts.windows(2) {
                let whole = [
                    0.5 * (pair[0][0] + pair[1][0] + 0.5 * (pair[1][1] - pair[0][1])),
                    pair[0][1] + pair[1][1],
                ];
                let of = |part: [f64; 2]| part[1] * mean(&coupling, observer, part);
                let (once, twice) = (of(whole), of(pair[0]) + of(pair[1]));
                assert!((once / twice - 1.0).abs() < 1e-9, "{observer:?} {pair:?}: {once} {twice}");
            }
        }
    }

    #[test]
    fn it_is_symmetric_to_the_bit_and_positive() {
        let coupling = FaceCoupling::new(FACE, |v| 0.7e-3 + 0.1 * v);
        let mut stretches = Vec::new();
        for k in 0..=20 {
            let v = FACE[0] + (FACE[1] - FACE[0]) * f64::from(k) / 20.0;
            stretches.extend([0.0, 0.1e-3, 1e-3].map(|length| coupling.stretch(v, length)));
        }
        let matrix = nalgebra::DMatrix::from_fn(stretches.len(), stretches.len(), |i, j| {
            FaceCoupling::mean(&stretches[i], &stretches[j])
        });
        for i in 0..stretches.len() {
            for j in 0..i {
                assert_eq!(matrix[(i, j)].to_bits(), matrix[(j, i)].to_bits());
            }
        }
        assert!(matrix.iter().all(|value| *value > 0.0));
        let least = matrix.clone().symmetric_eigenvalues().min();
        assert!(least > -1e-9 * matrix.amax(), "{least}");
    }

    /// In a cone the length is proportional to the distance from the apex and `K` is a sum of
    /// powers: `p (p + 1) = 1 / slope²`.
    #[test]
    fn in_a_cone_it_is_eulers() {
        let (slope, from, to) = (0.15_f64, 6e-3, 10e-3);
        let coupling = FaceCoupling::new([from, to], |v| slope * v);
        let root = (0.25 + 1.0 / (slope * slope)).sqrt();
        let [grows, decays] = [root - 0.5, -root - 0.5];
        // Solutions with a free end at `end`.
        let free = |end: f64, v: f64| {
            let x = v / end;
            (x.powf(grows) * -decays + x.powf(decays) * grows, (x.powf(grows) - x.powf(decays)) / v)
        };
        let at = 8.5e-3;
        let [(a, a_by), (b, b_by)] = [free(from, at), free(to, at)];
        // Derivatives: grows * -decays is common to both powers.
        let common = -grows * decays;
        let wronskian = (slope * at).powi(2) * common * (a_by * b - a * b_by);
        let exact = a * b / wronskian;
        let found = mean(&coupling, [at, 0.0], [at, 0.0]);
        assert!((found / exact - 1.0).abs() < 2e-4, "{found} {exact}");
    }
}
