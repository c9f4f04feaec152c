//! The root as the rack's tooth tip cuts it: the envelope of the rounded corner, then the root circle.
//!
//! While the gear turns by `e`, the rack moves along the pitch line by `r e`, where `r` is the pitch radius. In
//! gear coordinates, with `u` the radial direction through the pitch point and `v` the one along the pitch line, the
//! centre of the corner's rounding is at `(r - y) u + t v` with `t = c - r e`; it lies `y` below the pitch line and
//! `c` beside the middle of the rack's tooth. The normal of the envelope passes through the pitch point (Litvin,
//! Gear Geometry and Applied Theory, 6.1), so that the envelope is at `r u + (rho + y / sin g) d` with
//! `d = -sin(g) u - cos(g) v` and `t = -y / tan(g)`. The inclination `g` of the normal runs from the pressure angle,
//! where the straight flank of the rack takes over, to a right angle at the root circle.

use calyx_abi::math;
use calyx_runtime::profile::{Profile, ProfilePoint};
use std::f64::consts::{FRAC_PI_2, PI};

/// Which side of a tooth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The side whose outward normal points counter-clockwise; surface 0.
    CounterClockwise,
    /// Its mirror image; surface 1.
    Clockwise,
}

impl Side {
    /// Number of the surface in a structure's charts.
    pub fn surface(self) -> u32 {
        match self {
            Side::CounterClockwise => 0,
            Side::Clockwise => 1,
        }
    }

    /// Takes a point of the counter-clockwise side to this side: a reflection in the tooth's centreline.
    pub(crate) fn place(self, point: ProfilePoint) -> ProfilePoint {
        match self {
            Side::CounterClockwise => point,
            Side::Clockwise => {
                let mirror = |[x, y]: [f64; 2]| [x, -y];
                ProfilePoint {
                    position: mirror(point.position),
                    tangent: mirror(point.tangent),
                    normal: mirror(point.normal),
                    curvature: point.curvature,
                }
            }
        }
    }
}

/// The geometry of the generating motion, for the counter-clockwise side. SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct RootGeneration {
    pub teeth: u32,
    /// Radius of the circle on which the rack rolls, m.
    pub pitch_radius: f64,
    /// Depth of the centre of the corner's rounding below the pitch line, m.
    pub tip_centre_depth: f64,
    /// Distance of that centre from the middle of the rack's tooth, m.
    pub tip_centre_halfwidth: f64,
    /// Rounding of the corner, m.
    pub tip_radius: f64,
}

impl RootGeneration {
    /// Point where the normal is inclined by `inclination`; arc length grows towards the root.
    pub fn at(&self, inclination: f64) -> ProfilePoint {
        let (sine, cosine) = math::sincos(inclination);
        let turn = (self.tip_centre_depth * cosine / sine - self.tip_centre_halfwidth) / self.pitch_radius;
        let (v_x, v_y) = math::sincos(PI / f64::from(self.teeth) + turn);
        let (u, v) = ([v_y, v_x], [-v_x, v_y]);
        let normal = [sine * u[0] + cosine * v[0], sine * u[1] + cosine * v[1]];
        let reach = self.tip_radius + self.tip_centre_depth / sine;
        ProfilePoint {
            position: [
                self.pitch_radius * u[0] - reach * normal[0],
                self.pitch_radius * u[1] - reach * normal[1],
            ],
            tangent: [-normal[1], normal[0]],
            normal,
            curvature: -1.0 / self.curvature_radius(inclination),
        }
    }

    /// Radius of curvature of the envelope (concave material), m.
    pub fn curvature_radius(&self, inclination: f64) -> f64 {
        let sine = math::sin(inclination);
        let turn_rate = self.tip_centre_depth / (self.pitch_radius * sine * sine);
        self.arc_rate(inclination) / (1.0 + turn_rate)
    }

    /// Length of the envelope per unit of inclination, m.
    fn arc_rate(&self, inclination: f64) -> f64 {
        let sine = math::sin(inclination);
        let turn_rate = self.tip_centre_depth / (self.pitch_radius * sine * sine);
        self.tip_radius + (self.tip_radius + self.tip_centre_depth / sine) * turn_rate
    }

    /// Length of the envelope up to an inclination, from an origin of its own.
    fn arc_length(&self, inclination: f64) -> f64 {
        // The integral of the rate.
        let (sine, cosine) = math::sincos(inclination);
        let cotangent = cosine / sine;
        let depth = self.tip_centre_depth;
        let cubed_cosecant = 0.5 * (math::log(math::tan(0.5 * inclination)) - cotangent / sine);
        self.tip_radius * inclination
            + depth * (depth * cubed_cosecant - self.tip_radius * cotangent) / self.pitch_radius
    }
}

/// The root of one side of a tooth: from the form circle along the fillet and the root circle to the middle of the
/// space. In tooth coordinates (centreline along +x), metres.
#[derive(Clone, Debug)]
pub struct RootFillet {
    generation: RootGeneration,
    side: Side,
    form_inclination: f64,
    /// Where the fillet meets the root circle, m.
    breaks: [f64; 1],
    length: f64,
}

impl RootFillet {
    pub(crate) fn new(generation: RootGeneration, form_inclination: f64, side: Side) -> Self {
        let fillet = generation.arc_length(FRAC_PI_2) - generation.arc_length(form_inclination);
        let root_radius = generation.pitch_radius - generation.tip_centre_depth - generation.tip_radius;
        let root_arc = generation.tip_centre_halfwidth * root_radius / generation.pitch_radius;
        Self { generation, side, form_inclination, breaks: [fillet], length: fillet + root_arc }
    }

    /// Length of the fillet proper, up to the root circle, m.
    pub fn fillet_length(&self) -> f64 {
        self.breaks[0]
    }

    /// Arc length at which the normal has turned by a part (0 to 1) of its way from the form circle to the root circle.
    pub fn at_turned_normal(&self, part: f64) -> f64 {
        let inclination = self.form_inclination + part * (FRAC_PI_2 - self.form_inclination);
        self.generation.arc_length(inclination) - self.generation.arc_length(self.form_inclination)
    }

    fn inclination_at(&self, s: f64) -> f64 {
        let target = self.generation.arc_length(self.form_inclination) + s;
        let (least, most) = (0.5 * self.form_inclination, FRAC_PI_2);
        let mut inclination =
            self.form_inclination + s / self.fillet_length() * (FRAC_PI_2 - self.form_inclination);
        // Newton's method: the length grows steadily with the inclination.
        for _ in 0..50 {
            let miss = self.generation.arc_length(inclination) - target;
            let next = (inclination - miss / self.generation.arc_rate(inclination)).clamp(least, most);
            let step = (next - inclination).abs();
            inclination = next;
            if step <= 4.0 * f64::EPSILON {
                break;
            }
        }
        inclination
    }
}

impl Profile for RootFillet {
    fn length(&self) -> f64 {
        self.length
    }

    /// Arc length grows from the form circle towards the root.
    fn at(&self, s: f64) -> ProfilePoint {
        let fillet = self.fillet_length();
        let point = if s < fillet {
            self.generation.at(self.inclination_at(s))
        } else {
            let radius =
                self.generation.pitch_radius - self.generation.tip_centre_depth - self.generation.tip_radius;
            let (sine, cosine) =
                math::sincos(PI / f64::from(self.generation.teeth) - (self.length - s) / radius);
            ProfilePoint {
                position: [radius * cosine, radius * sine],
                tangent: [-sine, cosine],
                normal: [cosine, sine],
                curvature: 1.0 / radius,
            }
        };
        self.side.place(point)
    }

    fn breaks(&self) -> &[f64] {
        &self.breaks
    }
}
