//! Four-sided blocks bounded by curves, from which structured meshes are built.

use super::interpolation::ElementOrder;
use super::memoized::Memoized;
use std::sync::Arc;

/// Plane curve over a parameter in 0 ..= 1.
#[derive(Clone)]
pub struct Curve(Arc<dyn Fn(f64) -> [f64; 2] + Send + Sync>);

impl Curve {
    /// Builds a curve from its points, m, for a parameter from 0 to 1.
    pub fn new(curve: impl Fn(f64) -> [f64; 2] + Send + Sync + 'static) -> Self {
        Self(Arc::new(curve))
    }

    /// Returns a straight line between two points, m.
    pub fn line(from: [f64; 2], to: [f64; 2]) -> Self {
        // This form of the interpolation is exact at both ends.
        Self::new(move |u| [0, 1].map(|axis| (1.0 - u) * from[axis] + u * to[axis]))
    }

    /// Returns a circular arc; angles in radians from the x axis.
    pub fn arc(center: [f64; 2], radius: f64, from: f64, to: f64) -> Self {
        Self::new(move |u| {
            let (sin, cos) = ((1.0 - u) * from + u * to).sin_cos();
            [center[0] + radius * cos, center[1] + radius * sin]
        })
    }

    /// Returns the point at a parameter from 0 to 1, m.
    pub fn at(&self, u: f64) -> [f64; 2] {
        (self.0)(u)
    }

    /// Returns the same curve in the opposite direction.
    pub fn reversed(&self) -> Self {
        self.part(1.0, 0.0)
    }

    /// Returns the part between two parameters, in that direction.
    pub fn part(&self, from: f64, to: f64) -> Self {
        let whole = self.clone();
        Self::new(move |u| whole.at((1.0 - u) * from + u * to))
    }
}

/// Side of a block. Bottom and top run with `u` (left to right), left and right with `v` (bottom to
/// top).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Side at v = 0.
    Bottom,
    /// Side at u = 1.
    Right,
    /// Side at v = 1.
    Top,
    /// Side at u = 0.
    Left,
}

impl Side {
    /// Returns the index of the element side on this side.
    pub fn index(self) -> usize {
        self as usize
    }

    /// Returns true if the side runs against the element side, which is counter-clockwise.
    pub fn opposes_element(self) -> bool {
        matches!(self, Side::Top | Side::Left)
    }
}

/// Name of a side, and the arc lengths of a profile at its start and end if it lies on one.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct NamedSide {
    pub side: Side,
    pub name: String,
    pub profile: Option<[f64; 2]>,
}

type Mapping = Arc<dyn Fn(f64, f64) -> [f64; 2] + Send + Sync>;

/// Right-handed block: bottom to the right and left upwards (in any rotated position).
#[derive(Clone)]
pub struct Block {
    pub(super) sides: [Memoized<[f64; 2]>; 4],
    pub(super) u: Vec<f64>,
    pub(super) v: Vec<f64>,
    pub(super) order: Option<ElementOrder>,
    pub(super) mapping: Option<Mapping>,
    pub(super) names: Vec<NamedSide>,
}

impl Block {
    /// Builds one element between four curves, each in the direction of its side: bottom and top
    /// with `u`, right and left with `v`. They must meet at the corners.
    pub fn new(bottom: Curve, right: Curve, top: Curve, left: Curve) -> Self {
        Self {
            sides: [bottom, right, top, left].map(|curve| Memoized::new(move |u| curve.at(u))),
            u: uniform(1),
            v: uniform(1),
            order: None,
            mapping: None,
            names: Vec::new(),
        }
    }

    /// Builds a straight-sided block: corners counter-clockwise from bottom left.
    pub fn quadrilateral(corners: [[f64; 2]; 4]) -> Self {
        let [a, b, c, d] = corners;
        Self::new(Curve::line(a, b), Curve::line(b, c), Curve::line(d, c), Curve::line(a, d))
    }

    /// Sets the element boundaries along `u` and `v`: ascending from 0 to 1; see [`uniform`],
    /// [`graded`].
    pub fn divided(mut self, u: Vec<f64>, v: Vec<f64>) -> Self {
        (self.u, self.v) = (u, v);
        self
    }

    /// Sets an order that replaces the mesh's. Sides shared by blocks have the higher order.
    pub fn order(mut self, order: ElementOrder) -> Self {
        self.order = Some(order);
        self
    }

    /// Replaces the blending of the four sides inside the block; the mapping must agree with the
    /// curves on the sides.
    pub fn mapped(mut self, mapping: impl Fn(f64, f64) -> [f64; 2] + Send + Sync + 'static) -> Self {
        self.mapping = Some(Arc::new(mapping));
        self
    }

    /// Adds the edges of a side to a named chain, measured along the mesh.
    pub fn named(mut self, side: Side, name: &str) -> Self {
        self.names.push(NamedSide { side, name: name.to_owned(), profile: None });
        self
    }

    /// Adds the edges of a side to a named chain on a true profile: the side's curve, at parameter
    /// 0 ..= 1, is the profile at arc length `s[0]` to `s[1]` (descending if the directions are
    /// opposite), proportionally.
    pub fn on_profile(mut self, side: Side, name: &str, s: [f64; 2]) -> Self {
        self.names.push(NamedSide { side, name: name.to_owned(), profile: Some(s) });
        self
    }

    /// Returns the point at `(u, v)`: blended from the sides (Coons), or from the mapping.
    pub fn at(&self, u: f64, v: f64) -> [f64; 2] {
        // On the sides, use the curves, so that neighbours agree to the bit.
        let [bottom, right, top, left] = &self.sides;
        if v == 0.0 {
            return bottom.at(u);
        }
        if v == 1.0 {
            return top.at(u);
        }
        if u == 0.0 {
            return left.at(v);
        }
        if u == 1.0 {
            return right.at(v);
        }
        if let Some(mapping) = &self.mapping {
            return mapping(u, v);
        }
        let (b, r, t, l) = (bottom.at(u), right.at(v), top.at(u), left.at(v));
        let corners = [bottom.at(0.0), bottom.at(1.0), top.at(1.0), top.at(0.0)];
        [0, 1].map(|axis| {
            let ruled = (1.0 - v) * b[axis] + v * t[axis] + (1.0 - u) * l[axis] + u * r[axis];
            let bilinear = (1.0 - v) * ((1.0 - u) * corners[0][axis] + u * corners[1][axis])
                + v * (u * corners[2][axis] + (1.0 - u) * corners[3][axis]);
            ruled - bilinear
        })
    }
}

/// Returns `count` equal divisions.
pub fn uniform(count: usize) -> Vec<f64> {
    (0..=count).map(|index| index as f64 / count as f64).collect()
}

/// Returns `count` divisions in geometric progression, the last `ratio` times as long as the first.
pub fn graded(count: usize, ratio: f64) -> Vec<f64> {
    let growth = if count > 1 { ratio.powf(1.0 / (count - 1) as f64) } else { 1.0 };
    let mut lengths = vec![0.0];
    let (mut length, mut sum) = (1.0, 0.0);
    for _ in 0..count {
        sum += length;
        length *= growth;
        lengths.push(sum);
    }
    lengths.into_iter().map(|at| at / sum).collect()
}
