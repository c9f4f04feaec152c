//! Tooth interpolated from its table: flanks with rounded tip edges, fillets, and the map from
//! developed sections to the body.
//!
//! At each station a spline through the points is divided by arc length in equal proportions, from
//! the fillet to the start of the tip edge, and from the flank to the root. A tensor-product spline
//! through these points gives the curve of any section. Lines of constant `u` therefore divide the
//! profile alike at all stations, whatever the spacing of the points of the table.

use super::section::{Placed, SectionCones};
use super::spline::{Basis, Line, MOST_DEGREE, Sheet};
use super::table::Stations;
use crate::error::{GeometryError, sentence};
use crate::external::DEFAULT_TIP_EDGE;
use crate::root_finding::solve_bracketed;
use calyx_abi::math;
use calyx_runtime::fe::quadrature::gauss_legendre;
use std::f64::consts::PI;

/// Ratio of the height of a tooth of standard proportions to its module.
const HEIGHT_PER_MODULE: f64 = 2.25;
/// Degree of the splines of fillets, whose curvature may jump along the profile and whose ends may
/// turn along the face.
const FILLET_DEGREE: usize = 3;
/// Least and largest number of points into which a profile is divided.
const DIVIDED: [usize; 2] = [33, 129];
/// Largest part of the flank that the rounded tip edge may remove.
const LARGEST_EDGE: f64 = 0.5;

/// Point of a curve of a developed section, and its derivatives by the coordinates of the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurvePoint {
    /// Position, m.
    pub position: [f64; 2],
    /// Derivative along the profile.
    pub by_u: [f64; 2],
    /// Derivative along the face.
    pub by_v: [f64; 2],
}

/// Interpolated tooth. Positions along the face are `v`, the distance from the middle section along
/// the pitch cone, m, increasing towards +e3.
#[derive(Clone, Debug)]
pub struct Tooth {
    /// Number of teeth.
    pub teeth: u32,
    /// Sections.
    pub cones: SectionCones,
    /// Ends of the face.
    pub face: [f64; 2],
    /// Equivalent module: height of the tooth in the middle section divided by 2.25, m.
    pub module: f64,
    middle: f64,
    rotation: Line<1>,
    flanks: [Flank; 2],
    fillets: [Sheet; 2],
}

/// Flank with its rounded tip edge.
#[derive(Clone, Debug)]
struct Flank {
    sheet: Sheet,
    /// Angle by which the normal rotates over the tip edge.
    sweep: Line<1>,
    radius: f64,
    end: f64,
}

/// Spline through the points of a profile at one station, with its arc length.
struct StationCurve {
    line: Line<2>,
    nodes: Vec<f64>,
    /// Arc lengths at the nodes.
    lengths: Vec<f64>,
    rule: Vec<(f64, f64)>,
}

impl StationCurve {
    fn through(points: &[[f64; 2]], degree: usize) -> Option<Self> {
        let mut nodes = vec![0.0];
        for pair in points.windows(2) {
            let chord = (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1]);
            // The comparison is negated so that NaN fails it.
            let apart = chord > 0.0;
            if !apart {
                return None;
            }
            nodes.push(nodes[nodes.len() - 1] + chord);
        }
        let line = Line::through(Basis::new(nodes.clone(), degree), points)?;
        let mut curve = Self { line, lengths: vec![0.0], rule: gauss_legendre(8), nodes };
        for index in 1..curve.nodes.len() {
            let part = curve.between(curve.nodes[index - 1], curve.nodes[index]);
            curve.lengths.push(curve.lengths[index - 1] + part);
        }
        Some(curve)
    }

    fn between(&self, from: f64, to: f64) -> f64 {
        let half = 0.5 * (to - from);
        let speed = |x: f64| {
            let [_, [x, y]] = self.line.at(from + half * (1.0 + x));
            x.hypot(y)
        };
        self.rule.iter().map(|&(x, weight)| weight * half * speed(x)).sum()
    }

    fn length(&self) -> f64 {
        self.lengths[self.lengths.len() - 1]
    }

    fn end(&self) -> f64 {
        self.nodes[self.nodes.len() - 1]
    }

    /// Arc length at a parameter.
    fn length_at(&self, t: f64) -> f64 {
        let index = self.nodes.partition_point(|&node| node <= t).clamp(1, self.nodes.len() - 1) - 1;
        self.lengths[index] + self.between(self.nodes[index], t)
    }

    /// Point at an arc length.
    fn at_length(&self, s: f64) -> [f64; 2] {
        let last = self.lengths.len() - 1;
        let index = self.lengths.partition_point(|&length| length <= s).clamp(1, last) - 1;
        let (from, to) = (self.nodes[index], self.nodes[index + 1]);
        let wanted = s - self.lengths[index];
        let off = |t: f64| self.between(from, t) - wanted;
        let share = (wanted / (self.lengths[index + 1] - self.lengths[index])).clamp(0.0, 1.0);
        let mut t = from + share * (to - from);
        // Newton's method: the parameter is nearly the arc length.
        for _ in 0..20 {
            let [_, [x, y]] = self.line.at(t);
            let step = off(t) / x.hypot(y);
            t = (t - step).clamp(from, to);
            if step.abs() <= 4.0 * f64::EPSILON * to {
                break;
            }
        }
        self.line.at(t)[0]
    }

    /// Points at fractions of a length.
    fn divided(&self, length: f64, fractions: &[f64]) -> Vec<[f64; 2]> {
        fractions.iter().map(|fraction| self.at_length(length * fraction)).collect()
    }
}

/// Normal of a flank: its tangent rotated by a right angle to the side of the tooth.
fn normal_of(side: usize, [x, y]: [f64; 2]) -> [f64; 2] {
    if side == 0 { [-y, x] } else { [y, -x] }
}

fn misfit(station: usize, side: usize) -> GeometryError {
    GeometryError::error(
        "E0970",
        "flanks",
        sentence![
            "two adjacent points of station ", number station as f64, " of the ",
            text if side == 0 { "counter-clockwise" } else { "clockwise" }, " side coincide"
        ],
        sentence!["give each point of a profile once"],
    )
}

impl Tooth {
    /// Interpolates a checked table. `tip_edge_radius` is that of the rounded tip edge, m; `None`
    /// selects [`DEFAULT_TIP_EDGE`] equivalent modules.
    ///
    /// # Errors
    /// E0970: points coincide. E0974: the tip edge does not fit.
    pub fn new(stations: &Stations, tip_edge_radius: Option<f64>) -> Result<Self, GeometryError> {
        let module = stations.tooth_height / HEIGHT_PER_MODULE;
        let radius = tip_edge_radius.unwrap_or(DEFAULT_TIP_EDGE * module);
        let along = Basis::new(stations.along.clone(), MOST_DEGREE);
        let rotation: Vec<[f64; 1]> = stations.rotation.iter().map(|&angle| [angle]).collect();
        let rotation = Line::through(along.clone(), &rotation).ok_or_else(|| misfit(0, 0))?;
        let flanks = [flank(stations, &along, 0, radius)?, flank(stations, &along, 1, radius)?];
        let fillets = [fillet(stations, &along, 0)?, fillet(stations, &along, 1)?];
        let face = along.range();
        let (teeth, cones, middle) = (stations.teeth, stations.cones, stations.middle);
        Ok(Self { teeth, cones, face, module, middle, rotation, flanks, fillets })
    }

    /// Range of `u` of a flank: 0 at the fillet, and the end of the tip edge's arc. The arc begins
    /// at [`Self::edge_from`].
    pub fn flank_end(&self, side: usize) -> f64 {
        self.flanks[side].end
    }

    /// `u` at which the tip edge's arc begins.
    pub fn edge_from(&self, side: usize) -> f64 {
        self.flanks[side].sheet.range()[1]
    }

    /// Radius of the tip edge, m.
    pub fn tip_edge_radius(&self) -> f64 {
        self.flanks[0].radius
    }

    /// Length of a fillet in the middle section: the range of its coordinate from the flank to the
    /// root, m.
    pub fn fillet_length(&self, side: usize) -> f64 {
        self.fillets[side].range()[1]
    }

    /// Coordinate along the pitch cone of a section, see [`super::section::Meridian::along`].
    pub fn along(&self, v: f64) -> f64 {
        self.middle + v
    }

    /// Half of the pitch, rad.
    pub fn half_pitch(&self) -> f64 {
        PI / f64::from(self.teeth)
    }

    /// Point of a fillet, with its coordinate from the flank to the root.
    pub fn fillet_at(&self, side: usize, w: f64, v: f64) -> CurvePoint {
        let (at, start) = (self.fillets[side].at(w, v), self.fillets[side].at(0.0, v));
        let flank = self.flanks[side].sheet.at(0.0, v);
        // Splines of different degree along the face differ slightly between the stations. The
        // fillet begins where the flank does.
        let length = self.fillet_length(side);
        let rest = 1.0 - w / length;
        let gap = |flank: [f64; 2], fillet: [f64; 2]| [flank[0] - fillet[0], flank[1] - fillet[1]];
        let (off, off_by_v) = (gap(flank.position, start.position), gap(flank.by_v, start.by_v));
        let faded = |value: [f64; 2], off: [f64; 2], factor: f64| {
            [0, 1].map(|axis: usize| value[axis] + factor * off[axis])
        };
        CurvePoint {
            position: faded(at.position, off, rest * rest),
            by_u: faded(at.by_u, off, -2.0 * rest / length),
            by_v: faded(at.by_v, off_by_v, rest * rest),
        }
    }

    /// Point of a flank or its tip edge. Beyond its ends the surface continues straight.
    pub fn flank_at(&self, side: usize, u: f64, v: f64) -> CurvePoint {
        let flank = &self.flanks[side];
        let start = self.edge_from(side);
        let at = flank.sheet.at(u.min(start), v);
        let point = CurvePoint { position: at.position, by_u: at.by_u, by_v: at.by_v };
        if u <= start {
            return point;
        }
        // The arc begins with the flank's tangent `t` and normal `n`, which rotate together.
        let speed = at.by_u[0].hypot(at.by_u[1]);
        let t = at.by_u.map(|part| part / speed);
        let n = normal_of(side, t);
        let rate = (n[0] * at.by_both[0] + n[1] * at.by_both[1]) / speed;
        let (t_by_v, n_by_v) = (n.map(|part| rate * part), t.map(|part| -rate * part));
        let [[sweep], [sweep_by_v]] = flank.sweep.at(v);
        let inside = u.min(flank.end);
        let share = (inside - start) / (flank.end - start);
        let (sine, cosine) = math::sincos(share * sweep);
        let radius = flank.radius;
        let along = [0, 1].map(|axis: usize| radius * (cosine * t[axis] - sine * n[axis]));
        let by_u = along.map(|part| part * sweep / (flank.end - start));
        // Beyond the arc the tip land continues along its tangent.
        let beyond = u - inside;
        let position = [0, 1].map(|axis: usize| {
            point.position[axis] + radius * (sine * t[axis] - (1.0 - cosine) * n[axis]) + beyond * by_u[axis]
        });
        let by_v = [0, 1].map(|axis: usize| {
            let turned = radius * (sine * t_by_v[axis] - (1.0 - cosine) * n_by_v[axis]);
            let bent = cosine * t_by_v[axis] - sine * n_by_v[axis];
            let slower = -sine * t[axis] - cosine * n[axis];
            let scale = beyond * radius / (flank.end - start);
            point.by_v[axis]
                + turned
                + along[axis] * share * sweep_by_v
                + scale * (sweep_by_v * along[axis] / radius + sweep * (bent + slower * share * sweep_by_v))
        });
        CurvePoint { position, by_u, by_v }
    }

    /// Point of the body at a point of a developed section.
    pub fn placed(&self, v: f64, point: [f64; 2]) -> Placed {
        let [[angle], [rate]] = self.rotation.at(v);
        self.cones.placed(self.along(v), point, [angle, rate])
    }
}

/// Normal's angle to the radial direction at the start of a tip edge: its parameter on the curve,
/// and the sweep of the arc.
fn tip_edge(
    stations: &Stations,
    curve: &StationCurve,
    (station, side): (usize, usize),
    radius: f64,
) -> Option<[f64; 2]> {
    let along = stations.middle + stations.along[station];
    let rolled = |point: [f64; 2]| stations.cones.rolled(along, point);
    let centre_at = |t: f64| {
        let [position, [x, y]] = curve.line.at(t);
        let speed = x.hypot(y);
        let normal = normal_of(side, [x / speed, y / speed]);
        ([0, 1].map(|axis: usize| position[axis] - radius * normal[axis]), normal)
    };
    let tip = rolled(curve.line.at(curve.end())[0])[0];
    let beyond = |t: f64| rolled(centre_at(t).0)[0] - (tip - radius);
    let first = (1.0 - LARGEST_EDGE) * curve.end();
    if !(beyond(first) < 0.0 && beyond(curve.end()) >= 0.0) {
        return None;
    }
    let start = solve_bracketed(beyond, first, curve.end());
    let (centre, normal) = centre_at(start);
    let radial = stations.cones.radial_angle(rolled(centre)[1]);
    let turned = math::atan2(normal[1], normal[0]) - radial;
    let sweep = if side == 0 { turned } else { -turned };
    (sweep > 0.0 && sweep < PI).then_some([start, sweep])
}

/// Fractions at which a profile of a number of points is divided.
fn equal_parts(points: usize) -> Vec<f64> {
    let count = (2 * points + 1).clamp(DIVIDED[0], DIVIDED[1]);
    (0..count).map(|k| k as f64 / (count - 1) as f64).collect()
}

/// The same number of fractions, dense at both ends (Chebyshev points): the curvature of an
/// involute grows towards its base circle, and the spline is least accurate at its ends.
fn dense_at_ends(points: usize) -> Vec<f64> {
    equal_parts(points).into_iter().map(|part| 0.5 * (1.0 - math::cos(PI * part))).collect()
}

/// Length in the middle section, from those of the stations.
fn middle_length(along: &Basis, lengths: &[f64]) -> Option<f64> {
    let lengths: Vec<[f64; 1]> = lengths.iter().map(|&length| [length]).collect();
    Some(Line::through(along.clone(), &lengths)?.at(0.0)[0][0])
}

fn sheet(
    along: Basis,
    rows: &[Vec<[f64; 2]>],
    (length, fractions): (f64, &[f64]),
    degree: usize,
) -> Option<Sheet> {
    let nodes = fractions.iter().map(|fraction| length * fraction).collect();
    Sheet::through([Basis::new(nodes, degree), along], rows)
}

fn flank(stations: &Stations, along: &Basis, side: usize, radius: f64) -> Result<Flank, GeometryError> {
    let fractions = dense_at_ends(stations.flanks[side][0].len());
    let (mut rows, mut lengths, mut sweeps) = (Vec::new(), Vec::new(), Vec::new());
    for (station, points) in stations.flanks[side].iter().enumerate() {
        let curve = StationCurve::through(points, MOST_DEGREE).ok_or_else(|| misfit(station, side))?;
        let edge = tip_edge(stations, &curve, (station, side), radius).ok_or_else(|| {
            GeometryError::error(
                "E0974",
                "tip_edge_radius",
                sentence![
                    "a tip edge with a radius of ", length radius, " does not fit the ",
                    text if side == 0 { "counter-clockwise" } else { "clockwise" }, " flank at station ", number station as f64
                ],
                sentence!["give a positive radius that is small compared with the height of the tooth"],
            )
        })?;
        let length = curve.length_at(edge[0]);
        rows.push(curve.divided(length, &fractions));
        lengths.push(length);
        sweeps.push([edge[1]]);
    }
    let build = || {
        let length = middle_length(along, &lengths)?;
        let sweep = Line::through(along.clone(), &sweeps)?;
        let end = length + radius * sweep.at(0.0)[0][0];
        Some(Flank {
            sheet: sheet(along.clone(), &rows, (length, &fractions), MOST_DEGREE)?,
            sweep,
            radius,
            end,
        })
    };
    build().ok_or_else(|| misfit(0, side))
}

fn fillet(stations: &Stations, along: &Basis, side: usize) -> Result<Sheet, GeometryError> {
    let fractions = equal_parts(stations.fillets[side][0].len());
    let (mut rows, mut lengths) = (Vec::new(), Vec::new());
    for (station, points) in stations.fillets[side].iter().enumerate() {
        let mut points = points.clone();
        // The common point of flank and fillet.
        points[0] = stations.flanks[side][station][0];
        let curve = StationCurve::through(&points, FILLET_DEGREE).ok_or_else(|| misfit(station, side))?;
        rows.push(curve.divided(curve.length(), &fractions));
        lengths.push(curve.length());
    }
    let length = middle_length(along, &lengths).ok_or_else(|| misfit(0, side))?;
    let along = Basis::new(along.nodes().to_vec(), FILLET_DEGREE);
    sheet(along, &rows, (length, &fractions), FILLET_DEGREE).ok_or_else(|| misfit(0, side))
}
