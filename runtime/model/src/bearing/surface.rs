//! Outer surfaces of bearings, for display: rolling elements of their real size and number, between
//! plain rings.

use super::RollingElements;
use calyx_rolling::bearing::{Elements, Row};
use calyx_structure::outer_surface::OuterSurface;
use std::f64::consts::{PI, TAU};

/// Thickness of a ring relative to the diameter of the rolling elements.
const RING: f64 = 0.45;
/// Width of the rings of a ball bearing relative to the diameter of the balls.
const BALL_RINGS: f64 = 1.6;
/// Width of the rings of a roller bearing relative to the length of the rollers.
const ROLLER_RINGS: f64 = 1.15;
/// Distance between a ring and the pitch circle relative to the diameter of the elements: balls run
/// in grooves.
const TO_BALLS: f64 = 0.3;
const TO_ROLLERS: f64 = 0.5;
/// Outside radius and width of the ring that marks a bearing without rolling elements, relative to
/// its inside radius.
const MARKER: [f64; 2] = [1.3, 0.6];
/// Numbers of points of a rolling element around its axis, and of a ball from pole to pole.
const AROUND: usize = 16;
const ALONG: usize = 9;

/// Returns a ring that marks a bearing at a shaft of this radius, m.
pub fn marker(radius: f64) -> OuterSurface {
    let [outside, width] = MARKER.map(|part| part * radius);
    ring([radius, outside], [0.0, 0.0], width, 0.0)
}

impl RollingElements {
    /// Returns the rings and elements of all rows in the axes of the bearing, and how much each
    /// point moves with the outer ring: by 1 on that ring, by 0 on the inner one, by 1/2 on the
    /// elements.
    pub fn outer_surface(&self) -> (OuterSurface, Vec<f64>) {
        let mut all = OuterSurface { copies: 1, ..OuterSurface::default() };
        let mut with_outer = Vec::new();
        for row in self.bearing.rows() {
            Shape::of(row).add_to((&mut all, &mut with_outer), self.motion.azimuth);
        }
        (all, with_outer)
    }
}

/// Dimensions of a row of rolling elements.
struct Shape {
    count: usize,
    /// Diameter of the elements, m.
    diameter: f64,
    /// Length of rollers, m; `None` for balls.
    length: Option<f64>,
    /// Radius of the pitch circle, m.
    radius: f64,
    /// Axial position, m.
    position: f64,
    /// Inclination of the axes of the rollers, rad.
    angle: f64,
    /// Azimuth of the first element, rad.
    azimuth: f64,
}

impl Shape {
    fn of(row: &Row) -> Shape {
        let (count, diameter, length, pitch, angle) = match &row.elements {
            Elements::Balls(balls) => {
                let own = balls.geometry();
                (own.count, own.ball_diameter, None, own.pitch_diameter, 0.0)
            }
            Elements::Rollers(rollers) => {
                let (own, [inner, outer]) = (rollers.geometry(), rollers.contact_angles());
                (own.count, own.roller_diameter, Some(own.length), own.pitch_diameter, 0.5 * (inner + outer))
            }
        };
        let angle = if row.mirrored { -angle } else { angle };
        let (radius, position, azimuth) = (0.5 * pitch, row.position, row.azimuth);
        Shape { count, diameter, length, radius, position, angle, azimuth }
    }

    fn add_to(&self, (all, with_outer): (&mut OuterSurface, &mut Vec<f64>), azimuth: f64) {
        let (reach, width) = match self.length {
            None => (TO_BALLS * self.diameter, BALL_RINGS * self.diameter),
            Some(length) => (TO_ROLLERS * self.diameter, ROLLER_RINGS * length),
        };
        let (thickness, slope) = (RING * self.diameter, -self.angle.tan());
        for (radii, outer) in [([-reach - thickness, -reach], 0.0), ([reach, reach + thickness], 1.0)] {
            all.add(ring(radii, [self.radius, self.position], width, slope));
            with_outer.resize(all.points.len(), outer);
        }
        let element = self.element();
        for index in 0..self.count {
            let at = azimuth + self.azimuth + TAU * index as f64 / self.count as f64;
            all.add(self.placed(&element, at));
        }
        with_outer.resize(all.points.len(), 0.5);
    }

    /// Returns an element about the z axis.
    fn element(&self) -> OuterSurface {
        let radius = 0.5 * self.diameter;
        let polygon = match self.length {
            Some(length) => {
                let half = 0.5 * length;
                vec![[-half, 0.0], [half, 0.0], [half, radius], [-half, radius]]
            }
            None => (0..ALONG)
                .map(|k| PI * k as f64 / (ALONG - 1) as f64)
                // The poles are exactly on the axis.
                .map(|angle| {
                    [radius * angle.cos(), if angle.sin() < 1e-9 { 0.0 } else { radius * angle.sin() }]
                })
                .collect(),
        };
        OuterSurface { edges: Vec::new(), ..OuterSurface::revolved_in(&polygon, AROUND) }
    }

    /// Returns an element at an azimuth, rad.
    fn placed(&self, element: &OuterSurface, azimuth: f64) -> OuterSurface {
        let ((sine, cosine), (tilt, along)) = (azimuth.sin_cos(), self.angle.sin_cos());
        let place = |&[x, y, z]: &[f64; 3]| {
            let radial = self.radius + along * x - tilt * z;
            [cosine * radial - sine * y, sine * radial + cosine * y, self.position + tilt * x + along * z]
        };
        OuterSurface { points: element.points.iter().map(place).collect(), ..element.clone() }
    }
}

/// Returns a ring between two radii (m) beyond that of its middle, at an axial position, with the
/// slope of its surfaces.
fn ring([inside, outside]: [f64; 2], [radius, position]: [f64; 2], width: f64, slope: f64) -> OuterSurface {
    let at = |z: f64, beyond: f64| [position + z, radius + beyond + slope * z];
    let [start, end] = [-0.5 * width, 0.5 * width];
    OuterSurface::revolved(&[at(start, inside), at(end, inside), at(end, outside), at(start, outside)])
}
