//! Sample points and matching depths for the smooth part of a surface's compliance.
//!
//! The smooth part varies over the distance to the nearest sharp edge of the body, and over the
//! length of the surface away from edges. A matching depth `w` causes an averaging error of the
//! order of (w / scale)⁴ and, with quadratic elements, a mesh error of (spacing of nodes / w)⁴. It
//! is the geometric mean of scale and spacing, but never finer than a load that the mesh resolves.
//! The sample spacing is a fixed fraction of it: dense towards a sharp edge, sparse elsewhere.

use super::kernel::Mollifier;
use calyx_fe::{EdgeChain, ElementEdge, PlaneMesh};
use serde::{Deserialize, Serialize};

/// Resolution of the split of the compliance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SplitOptions {
    /// Factor on the matching depth, 1 by default. Results should hardly depend on it; varying it
    /// checks this.
    pub matching_depth: f64,
    /// Number of samples on each surface, at least 8.
    pub samples: usize,
    /// Condense forces along the surfaces as well as into them, so that the surfaces can be
    /// modified afterwards ([`super::Structure::with_modified_surfaces`]).
    pub allows_modified_surfaces: bool,
}

impl Default for SplitOptions {
    fn default() -> Self {
        Self { matching_depth: 1.0, samples: 64, allows_modified_surfaces: false }
    }
}

/// Smallest matching depth in node spacings along the surface.
const LEAST_NODE_SPACINGS: f64 = 4.0;
/// A mollifier ends at this fraction of the distance to a sharp edge, at least.
const CLEAR_OF_EDGE: f64 = 0.85;
/// Distance from a sharp edge, relative to the surface's length, below which the logarithm
/// dominates. Beyond it the bending of a tooth dominates, which is smooth in the arc length.
const LOGARITHMIC: f64 = 0.04;
/// Number of intervals of the table that distributes the samples.
const INTERVALS: usize = 2000;

/// Coordinate along a surface in which the smooth part is as smooth near a sharp edge as elsewhere:
/// near the edge it varies with the logarithm of the distance. Linear extrapolation beyond the last
/// sample matches the behaviour of a free corner.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct EdgeCoordinate {
    length: f64,
    /// Sharp edges at the start and the end of the surface, if any.
    edges: [Option<Edge>; 2],
}

#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
struct Edge {
    at: f64,
    /// Distance over which the edge is rounded, on the body or in the mesh, m.
    rounding: f64,
}

impl EdgeCoordinate {
    /// Returns the coordinate at arc length `s`; it increases with `s`.
    pub fn at(&self, s: f64) -> f64 {
        let logarithm = |edge: &Option<Edge>, sign: f64| {
            edge.map_or(0.0, |edge| {
                let distance = (sign * (s - edge.at)).max(0.0) + edge.rounding;
                sign * (distance / self.length).ln()
            })
        };
        s / (LOGARITHMIC * self.length) + logarithm(&self.edges[0], 1.0) + logarithm(&self.edges[1], -1.0)
    }
}

/// Samples of one surface.
#[derive(Clone, Debug)]
pub(super) struct Samples {
    pub stretch: EdgeCoordinate,
    /// Arc lengths, ascending, m.
    pub s: Vec<f64>,
    pub mollifiers: Vec<Mollifier>,
}

/// Distributes samples on a chain of edges. `edges` are the ends of the chain that are sharp edges
/// of the body, with their rounding (m); at the other ends the body continues smoothly. `None` if
/// the chain is empty or too coarse for a matching depth.
pub(super) fn sample(
    mesh: &PlaneMesh,
    chain: &EdgeChain,
    edges: [Option<f64>; 2],
    options: &SplitOptions,
) -> Option<Samples> {
    let [start, end] = chain.range();
    let length = end - start;
    let from_edge = |s: f64| {
        let distance = |edge: Option<f64>, gap: f64| edge.map_or(f64::INFINITY, |_| gap);
        distance(edges[0], s - start).min(distance(edges[1], end - s))
    };
    let spacing = |s: f64| {
        let index = mesh.locate(chain, s)?.0;
        let edge = chain.edges.get(index)?;
        let order = f64::from(mesh.elements.get(edge.element)?.order.sides[edge.side]);
        Some((edge.s[1] - edge.s[0]) / order)
    };
    let depth = |s: f64| {
        let scale = from_edge(s).min(length);
        let spacing = spacing(s)?;
        Some((spacing * scale).sqrt().max(LEAST_NODE_SPACINGS * spacing))
    };
    // A depth larger than the default is reduced near edges and does not change the range.
    let width = |s: f64| {
        let asked = options.matching_depth * depth(s)?;
        Some(asked.min((CLEAR_OF_EDGE * from_edge(s)).max(depth(s)?)).min(0.5 * length))
    };
    // Bisects from the middle towards an end, as far as a mollifier stays clear of the edge.
    let reach = |limit: f64| {
        let least = |s: f64| Some((options.matching_depth.min(1.0) * depth(s)?).min(0.5 * length));
        let clear = |s: f64| least(s).is_some_and(|width| width <= CLEAR_OF_EDGE * from_edge(s));
        let (mut inside, mut outside) = (0.5 * (start + end), limit);
        if clear(limit) {
            return Some(limit);
        }
        if !clear(inside) {
            return None;
        }
        for _ in 0..60 {
            let middle = 0.5 * (inside + outside);
            if clear(middle) {
                inside = middle;
            } else {
                outside = middle;
            }
        }
        Some(inside)
    };
    if length.is_nan() || length <= 0.0 {
        return None;
    }
    let (first, last) = (reach(start)?, reach(end)?);

    // Equal shares of the number of matching depths between the ends.
    let step = (last - first) / INTERVALS as f64;
    let mut passed = vec![0.0];
    for interval in 0..INTERVALS {
        let middle = first + (interval as f64 + 0.5) * step;
        passed.push(passed[interval] + step / depth(middle)?);
    }
    let count = options.samples.max(8);
    let edge = |rounding: Option<f64>, at: f64, element: Option<&ElementEdge>| {
        let (rounding, element) = (rounding?, element?);
        Some(Edge { at, rounding: rounding.max(element.s[1] - element.s[0]) })
    };
    let edges = [edge(edges[0], start, chain.edges.first()), edge(edges[1], end, chain.edges.last())];
    let stretch = EdgeCoordinate { length, edges };
    let mut samples =
        Samples { stretch, s: Vec::with_capacity(count), mollifiers: Vec::with_capacity(count) };
    for index in 0..count {
        let share = passed[INTERVALS] * index as f64 / (count - 1) as f64;
        let interval = passed.partition_point(|&p| p < share).clamp(1, INTERVALS);
        let within = (share - passed[interval - 1]) / (passed[interval] - passed[interval - 1]);
        let s = (first + (interval as f64 - 1.0 + within) * step).clamp(first, last);
        let width = width(s)?;
        let center = s.clamp(start + width, end - width);
        samples.s.push(s);
        samples.mollifiers.push(Mollifier::new(s, center, width));
    }
    samples.s.windows(2).all(|pair| pair[0] < pair[1]).then_some(samples)
}
