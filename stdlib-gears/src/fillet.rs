//! The root as the tool's tooth tip cuts it: the envelope of the rounded corner, then the root circle.
//!
//! The normal of the envelope passes through the pitch point (Litvin, Gear Geometry and Applied Theory, 6.1). In gear coordinates, with
//! `u` the radial direction through the pitch point and `v` the one along the pitch line, and for an external gear's tooth side that
//! faces counter-clockwise, the envelope is therefore at `r u - l n`: `r` is the radius of the circle on which the tool rolls,
//! `n = sin(g) u + cos(g) v` the outward normal inclined by `g` against the pitch line, `l` the distance from the pitch point. The inclination runs from the
//! pressure angle, where the flank of the tool takes over, to a right angle at the root circle. Inside a ring it is
//! `n = -sin(g) u + cos(g) v`.
//!
//! A *rack* moves along the pitch line by `r e` while the gear turns by `e`. The centre of its corner's rounding lies `y` below the
//! pitch line and `c` beside the middle of the rack's tooth. A round corner has `l = rho + y / sin g` where the centre stands at
//! `t = -y / tan(g)` along the pitch line. In the transverse section of a rack that is round in its normal section the corner is an ellipse of half-axes
//! `a` along the pitch line and `b` across; with `h(g) = hypot(a cos g, b sin g)`, its support function,
//! `l = b² / h + y / sin g` and `t = -y / tan(g) + (a² - b²) cos(g) / h`.
//!
//! A *shaper*'s pitch circle of radius `p` rolls inside the ring's. The centre of the corner's rounding stands at the distance `d` from
//! the cutter's axis, at the angle `psi` from the middle of the cutter's tooth. With `q = sqrt(d² - p² cos² g)` the centre is
//! `q - p sin g` away from the pitch point, in a direction `theta` seen from the cutter's axis with `d sin(theta + g) = q`; then
//! the pitch point stands at `(theta - psi) N_cutter / N` from the middle of the ring's space, and `d theta / d g = -(q - p sin g) / q`.

use calyx_abi::math;
use calyx_runtime::fe::quadrature::gauss_legendre;
use calyx_runtime::profile::{Profile, ProfilePoint};
use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::LazyLock;

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

/// A rounded corner of a tool as it rolls with the gear, for the counter-clockwise side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum RootGeneration {
    Rack(RackRoot),
    Shaper(ShaperRoot),
}

/// A rack's corner. SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct RackRoot {
    pub teeth: u32,
    /// Radius of the circle on which the rack rolls, m.
    pub pitch_radius: f64,
    /// Depth of the centre of the corner's rounding below the pitch line, m.
    pub tip_centre_depth: f64,
    /// Distance of that centre from the middle of the rack's tooth, m.
    pub tip_centre_halfwidth: f64,
    /// Rounding of the corner across the pitch line, m.
    pub tip_radius: f64,
    /// How many times longer it is along the pitch line.
    pub tip_stretch: f64,
}

/// A shaper's corner. SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ShaperRoot {
    /// Of the ring.
    pub teeth: u32,
    /// Teeth of the cutter over those of the ring.
    pub ratio: f64,
    /// Radii of the circles that roll on each other: the ring's and the cutter's, m.
    pub pitch_radii: [f64; 2],
    /// Distance of the centre of the corner's rounding from the cutter's axis, m.
    pub tip_centre_radius: f64,
    /// Its angle from the middle of the cutter's tooth, rad.
    pub tip_centre_angle: f64,
    /// Rounding of the corner, m.
    pub tip_radius: f64,
}

/// How the gear and the tool stand where the normal has an inclination.
struct Rolling {
    /// Polar angle of the pitch point in tooth coordinates, less half a pitch, rad.
    turn: f64,
    /// Distance of the envelope from the pitch point, m.
    reach: f64,
    /// Angle by which the normal turns per inclination.
    turn_rate: f64,
    /// Length of the envelope per inclination, m.
    arc_rate: f64,
}

impl RackRoot {
    fn rolling(&self, inclination: f64) -> Rolling {
        let (sine, cosine) = math::sincos(inclination);
        let (depth, radius) = (self.tip_centre_depth, self.pitch_radius);
        let turn = (depth * cosine / sine - self.tip_centre_halfwidth) / radius;
        let rate = depth / (radius * sine * sine);
        if self.tip_stretch == 1.0 {
            let reach = self.tip_radius + depth / sine;
            return Rolling { turn, reach, turn_rate: 1.0 + rate, arc_rate: self.tip_radius + reach * rate };
        }
        let [along, across] = self.half_axes();
        let support = (along * cosine).hypot(across * sine);
        let excess = (along - across) * (along + across);
        let reach = across * across / support + depth / sine;
        let rate = rate - excess * across * across * sine / (support * support * support * radius);
        let curvature_radius = (along * across / support) * (along * across / support) / support;
        Rolling {
            turn: turn - excess * cosine / (support * radius),
            reach,
            turn_rate: 1.0 + rate,
            arc_rate: curvature_radius + reach * rate,
        }
    }

    fn half_axes(&self) -> [f64; 2] {
        [self.tip_stretch * self.tip_radius, self.tip_radius]
    }

    /// The integral of the rate of length of a round corner.
    fn round_arc_length(&self, inclination: f64) -> f64 {
        let (sine, cosine) = math::sincos(inclination);
        let cotangent = cosine / sine;
        let depth = self.tip_centre_depth;
        let cubed_cosecant = 0.5 * (math::log(math::tan(0.5 * inclination)) - cotangent / sine);
        self.tip_radius * inclination
            + depth * (depth * cubed_cosecant - self.tip_radius * cotangent) / self.pitch_radius
    }
}

impl ShaperRoot {
    fn rolling(&self, inclination: f64) -> Rolling {
        let (sine, cosine) = math::sincos(inclination);
        let [ring, cutter] = self.pitch_radii;
        let across = cutter * cosine;
        let chord = ((self.tip_centre_radius - across) * (self.tip_centre_radius + across)).max(0.0).sqrt();
        let centre = chord - cutter * sine;
        let direction = math::atan2(centre * cosine, cutter + centre * sine);
        let reach = centre + self.tip_radius;
        let turn_rate = 1.0 - self.ratio * centre / chord;
        Rolling {
            turn: (direction - self.tip_centre_angle) * self.ratio,
            reach,
            turn_rate,
            // What the pitch point moves across the normal, and the turn about it.
            arc_rate: reach * turn_rate - ring * sine * self.ratio * centre / chord,
        }
    }
}

impl RootGeneration {
    fn teeth(&self) -> u32 {
        match self {
            RootGeneration::Rack(rack) => rack.teeth,
            RootGeneration::Shaper(shaper) => shaper.teeth,
        }
    }

    /// +1 outside of a gear, -1 inside of a ring.
    fn sense(&self) -> f64 {
        match self {
            RootGeneration::Rack(_) => 1.0,
            RootGeneration::Shaper(_) => -1.0,
        }
    }

    /// Radius of the gear's circle that rolls, m.
    fn pitch_radius(&self) -> f64 {
        match self {
            RootGeneration::Rack(rack) => rack.pitch_radius,
            RootGeneration::Shaper(shaper) => shaper.pitch_radii[0],
        }
    }

    /// Where the fillet ends on the root circle: the circle's radius (m), and half the angle of it between two fillets.
    fn root_circle(&self) -> [f64; 2] {
        match self {
            RootGeneration::Rack(rack) => [
                rack.pitch_radius - rack.tip_centre_depth - rack.tip_radius,
                rack.tip_centre_halfwidth / rack.pitch_radius,
            ],
            RootGeneration::Shaper(shaper) => [
                shaper.pitch_radii[0] - shaper.pitch_radii[1] + shaper.tip_centre_radius + shaper.tip_radius,
                shaper.tip_centre_angle * shaper.ratio,
            ],
        }
    }

    fn rolling(&self, inclination: f64) -> Rolling {
        match self {
            RootGeneration::Rack(rack) => rack.rolling(inclination),
            RootGeneration::Shaper(shaper) => shaper.rolling(inclination),
        }
    }

    /// Point where the normal is inclined by `inclination`; arc length grows towards the root.
    pub fn at(&self, inclination: f64) -> ProfilePoint {
        let (sine, cosine) = math::sincos(inclination);
        let sense = self.sense();
        let Rolling { turn, reach, turn_rate, arc_rate } = self.rolling(inclination);
        let (v_x, v_y) = math::sincos(PI / f64::from(self.teeth()) + turn);
        let (u, v) = ([v_y, v_x], [-v_x, v_y]);
        let normal = [sense * sine * u[0] + cosine * v[0], sense * sine * u[1] + cosine * v[1]];
        let radius = self.pitch_radius();
        ProfilePoint {
            position: [radius * u[0] - reach * normal[0], radius * u[1] - reach * normal[1]],
            tangent: [-sense * normal[1], sense * normal[0]],
            normal,
            curvature: -1.0 / (arc_rate / turn_rate),
        }
    }

    /// Radius of curvature of the envelope (concave material), m.
    pub fn curvature_radius(&self, inclination: f64) -> f64 {
        let rolling = self.rolling(inclination);
        rolling.arc_rate / rolling.turn_rate
    }

    /// Length of the envelope up to an inclination, from an origin of its own.
    fn arc_length(&self, inclination: f64) -> f64 {
        match self {
            RootGeneration::Rack(rack) if rack.tip_stretch == 1.0 => rack.round_arc_length(inclination),
            _ => self.integrated_arc_length(inclination),
        }
    }

    /// The same by quadrature, back from the root circle. What makes the rate steep lies at an inclination of zero, so each part
    /// ends at twice the inclination it begins with.
    fn integrated_arc_length(&self, inclination: f64) -> f64 {
        let mut sum = 0.0;
        let mut from = inclination;
        while from < FRAC_PI_2 {
            let to = if from > 0.55 * FRAC_PI_2 { FRAC_PI_2 } else { (2.0 * from).min(FRAC_PI_2) };
            let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
            let part: f64 =
                POINTS.iter().map(|&(x, weight)| weight * self.rolling(middle + half * x).arc_rate).sum();
            sum += half * part;
            from = to;
        }
        -sum
    }
}

/// Points and weights for lengths of fillets.
static POINTS: LazyLock<Vec<(f64, f64)>> = LazyLock::new(|| gauss_legendre(12));

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
        let [radius, half_angle] = generation.root_circle();
        Self { generation, side, form_inclination, breaks: [fillet], length: fillet + half_angle * radius }
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
            let rate = self.generation.rolling(inclination).arc_rate;
            let next = (inclination - miss / rate).clamp(least, most);
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
            let [radius, _] = self.generation.root_circle();
            let sense = self.generation.sense();
            let (sine, cosine) =
                math::sincos(PI / f64::from(self.generation.teeth()) - (self.length - s) / radius);
            ProfilePoint {
                position: [radius * cosine, radius * sine],
                tangent: [-sine, cosine],
                normal: [sense * cosine, sense * sine],
                curvature: sense / radius,
            }
        };
        self.side.place(point)
    }

    fn breaks(&self) -> &[f64] {
        &self.breaks
    }
}
