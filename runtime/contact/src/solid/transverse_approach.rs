//! Closest approach of two surfaces across a patch, at one y: the slope of the gap along x is
//! monotonic, so its zero is bracketed.

use super::height_field::{FootPoint, HeightField};

/// Closest approach at one y.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TransverseApproach {
    /// Points of both surfaces at the same x and y.
    pub feet: [FootPoint; 2],
    /// Body whose surface ends here before the minimum of the gap.
    pub end: Option<usize>,
    /// Minimum of the gap across the patch; `None` if a surface ends before it.
    minimum: Option<Minimum>,
}

/// Shape of the gap across the patch at its minimum.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Minimum {
    /// Second derivative by x, 1/m.
    curvature: f64,
    /// Length of the interval on which both surfaces exist, there or at a near y, m.
    length: f64,
}

impl TransverseApproach {
    /// Returns x and y, m.
    pub fn at(&self) -> [f64; 2] {
        let [first, second] = self.feet.map(|foot| foot.at);
        [0.5 * (first[0] + second[0]), 0.5 * (first[1] + second[1])]
    }

    /// Returns the gap along the normal of the frame, m; negative for overlap.
    pub fn gap(&self) -> f64 {
        self.feet[1].height - self.feet[0].height
    }

    /// Returns the derivatives of the gap by x and by y.
    pub fn slope(&self) -> [f64; 2] {
        [0, 1].map(|axis| self.feet[1].slope[axis] - self.feet[0].slope[axis])
    }

    /// Returns the slopes along x and y of the surface between both; where one of them ends, of the
    /// other.
    pub fn common_slope(&self) -> [f64; 2] {
        let [first, second] = self.feet.map(|foot| foot.slope);
        match self.end {
            Some(0) => second,
            Some(_) => first,
            None => [0, 1].map(|axis: usize| 0.5 * (first[axis] + second[axis])),
        }
    }

    pub fn places(&self) -> [[f64; 2]; 2] {
        self.feet.map(|foot| foot.place)
    }
}

/// Number of steps across the patch in the search for a sign change of the slope.
const WALK: f64 = 12.0;
/// Smallest step, relative to the interval on which both surfaces exist.
const LEAST_STRIDE: f64 = 1e-5;
const STEPS: usize = 100;
/// Maximum number of secant steps from a near minimum.
const SECANTS: usize = 12;
/// Steps that are smaller than this multiple of their rounding do not determine a curvature.
const ROUNDED: f64 = 1e4;

/// End of the interval of x on which both surfaces exist, and the surface that ends.
#[derive(Clone, Copy, Debug)]
pub struct SurfaceEnd {
    pub x: f64,
    pub side: usize,
}

/// Finds the closest approach at `y`, starting near `guess` (a point on either surface). `None` if
/// the surfaces do not face each other there.
pub fn closest_across(
    height_fields: &[HeightField; 2],
    y: f64,
    guess: [[f64; 2]; 2],
) -> Option<TransverseApproach> {
    let [low, high] = limits(height_fields, y, guess)?;
    let at = |x: f64, near: Option<&[FootPoint; 2]>| -> Option<[FootPoint; 2]> {
        let [first, second] = height_fields;
        Some(match near {
            Some(near) => [first.over_near([x, y], &near[0])?, second.over_near([x, y], &near[1])?],
            None => [first.over([x, y], guess[0])?, second.over([x, y], guess[1])?],
        })
    };
    let length = high.x - low.x;
    let middle = 0.5 * (height_fields[0].foot(guess[0]).at[0] + height_fields[1].foot(guess[1]).at[0]);
    let mut here = middle.clamp(low.x, high.x);
    let mut closest = at(here, None)?;
    // Descend in growing steps until the slope changes its sign or a surface ends.
    let downhill = -slope_across(&closest).signum();
    if slope_across(&closest) == 0.0 {
        return Some(TransverseApproach { feet: closest, end: None, minimum: None });
    }
    let ended = |feet, limit: &SurfaceEnd| TransverseApproach { feet, end: Some(limit.side), minimum: None };
    let mut stride = length / WALK;
    let bracket = loop {
        let limit = if downhill > 0.0 { high } else { low };
        let next = here + downhill * stride;
        let beyond = downhill * (next - limit.x) >= 0.0;
        let next = if beyond { limit.x } else { next };
        let Some(there) = at(next, Some(&closest)) else {
            // The other coordinate ends before this one.
            stride *= 0.25;
            if stride > LEAST_STRIDE * length {
                continue;
            }
            return Some(ended(closest, &limit));
        };
        if slope_across(&there) * downhill >= 0.0 {
            break [(here, closest), (next, there)];
        }
        (here, closest) = (next, there);
        if beyond {
            return Some(ended(closest, &limit));
        }
        stride *= 1.5;
    };
    let (feet, curvature) = zero_of_slope(bracket, length, at)?;
    Some(TransverseApproach { feet, end: None, minimum: Some(Minimum { curvature, length }) })
}

/// Finds the zero of the slope in a bracket of two points with their x: by inverse quadratic
/// interpolation, bisection where that gains too little (Chandrupatla, Advances in Engineering
/// Software 28, 1997, 145-149). The slope has kinks where a rounded edge begins. Returns also its
/// derivative there; `None` if a surface has no point in between.
fn zero_of_slope(
    [first, second]: [(f64, [FootPoint; 2]); 2],
    length: f64,
    at: impl Fn(f64, Option<&[FootPoint; 2]>) -> Option<[FootPoint; 2]>,
) -> Option<([FootPoint; 2], f64)> {
    let with_slope = |(x, feet)| (x, slope_across(&feet), feet);
    // The newest point, the other end of the bracket, and the point before.
    let (mut new, mut other) = (with_slope(second), with_slope(first));
    let mut before = other;
    for _ in 0..STEPS {
        let curvature = (other.1 - new.1) / (other.0 - new.0);
        let settled = rounding(length, curvature);
        let nearest = if new.1.abs() < other.1.abs() { new } else { other };
        let size = other.0 - new.0;
        let secant = nearest.1 / curvature;
        if nearest.1 == 0.0 || size.abs() <= settled || secant.abs() <= settled {
            return Some((nearest.2, curvature));
        }
        let share = interpolated(new, other, before).unwrap_or(0.5);
        // A step that is not lost by rounding.
        let least = (settled / size.abs()).min(0.5);
        let x = new.0 + share.clamp(least, 1.0 - least) * size;
        let there = with_slope((x, at(x, Some(&nearest.2))?));
        if (there.1 > 0.0) == (new.1 > 0.0) {
            (before, new) = (new, there);
        } else {
            (before, other, new) = (other, new, there);
        }
    }
    let nearest = if new.1.abs() < other.1.abs() { new } else { other };
    Some((nearest.2, (other.1 - new.1) / (other.0 - new.0)))
}

/// Returns the part of the bracket from its newest point at which the inverse quadratic
/// interpolation of three points with their slopes is zero, or the secant if there are only two;
/// `None` if the inverse is not nearly a parabola.
fn interpolated<T>(new: (f64, f64, T), other: (f64, f64, T), before: (f64, f64, T)) -> Option<f64> {
    let [(a, at_a), (b, at_b), (c, at_c)] = [(new.0, new.1), (other.0, other.1), (before.0, before.1)];
    if c == b {
        return Some(at_a / (at_a - at_b));
    }
    let place = (a - b) / (c - b);
    let value = (at_a - at_b) / (at_c - at_b);
    let is_parabola = value * value < place && (1.0 - value) * (1.0 - value) < 1.0 - place;
    let share = at_a / (at_b - at_a) * at_c / (at_b - at_c)
        + (c - a) / (b - a) * at_a / (at_c - at_a) * at_b / (at_c - at_b);
    is_parabola.then_some(share)
}

/// Finds the closest approach at `y`, starting from that at a near y of the same height fields.
/// The result is that of [`closest_across`].
pub fn closest_near(
    height_fields: &[HeightField; 2],
    y: f64,
    near: &TransverseApproach,
) -> Option<TransverseApproach> {
    let found = match near.end {
        Some(_) => at_near_end(height_fields, y, near),
        None => by_secants(height_fields, y, near),
    };
    found.or_else(|| closest_across(height_fields, y, near.places()))
}

/// Finds the closest approach at `y` where a surface ends before the minimum of the gap, from a
/// near one with such an end. `None` if no surface ends before the minimum at `y`.
fn at_near_end(
    height_fields: &[HeightField; 2],
    y: f64,
    near: &TransverseApproach,
) -> Option<TransverseApproach> {
    let downhill = -slope_across(&near.feet).signum();
    let end = |side: usize| {
        let (field, foot) = (&height_fields[side], &near.feet[side]);
        let [across, along] = field.roles;
        let [low, high] = field.range[across];
        let value = if downhill * field.sense(0, foot) > 0.0 { high } else { low };
        SurfaceEnd { x: field.towards(across, value, 1, y, foot.place[along]).0.at[0], side }
    };
    let [first, second] = [end(0), end(1)];
    let limit = if downhill * (second.x - first.x) < 0.0 { second } else { first };
    let over = |side: usize| height_fields[side].over_near([limit.x, y], &near.feet[side]);
    let feet = [over(0)?, over(1)?];
    let other = 1 - limit.side;
    let is_end = height_fields[other].is_inside_across(&feet[other]) && slope_across(&feet) * downhill < 0.0;
    is_end.then_some(TransverseApproach { feet, end: Some(limit.side), minimum: None })
}

/// Finds the closest approach at `y`, which lies between `inside`, a minimum of the gap, and
/// `outside`, where a surface may end before the minimum. The result is that of [`closest_near`]
/// from `inside`.
pub fn closest_between(
    height_fields: &[HeightField; 2],
    y: f64,
    [inside, outside]: [&TransverseApproach; 2],
) -> Option<TransverseApproach> {
    let ended = || outside.end.and_then(|_| at_near_end(height_fields, y, outside));
    by_secants(height_fields, y, inside)
        .or_else(ended)
        .or_else(|| closest_across(height_fields, y, inside.places()))
}

/// Finds a minimum of the gap that both surfaces have inside their ends, by secant steps from that
/// at a near y. `None` unless each step reduces the slope to less than half, as it does near the
/// minimum.
fn by_secants(
    height_fields: &[HeightField; 2],
    y: f64,
    near: &TransverseApproach,
) -> Option<TransverseApproach> {
    let Minimum { curvature, length } = near.minimum?;
    let at = |x: f64, near: &[FootPoint; 2]| -> Option<[FootPoint; 2]> {
        let [first, second] = height_fields;
        let feet = [first.over_near([x, y], &near[0])?, second.over_near([x, y], &near[1])?];
        let inside = height_fields.iter().zip(&feet).all(|(field, foot)| field.is_inside_across(foot));
        inside.then_some(feet)
    };
    // On a rounded edge the contact line follows the edge.
    let on_edge = (0..2).find(|&side| height_fields[side].placed.on_edge(near.feet[side].place));
    let mut x = match on_edge {
        Some(side) => {
            let (field, place) = (&height_fields[side], near.feet[side].place);
            let [across, along] = field.roles;
            field.on_line(across, place[across], 1, y, place[along])?.at[0]
        }
        None => near.at()[0],
    };
    let mut feet = at(x, &near.feet)?;
    let mut minimum = Minimum { curvature, length };
    for _ in 0..SECANTS {
        let slope = slope_across(&feet);
        let step = -slope / minimum.curvature;
        let settled = rounding(length, minimum.curvature);
        if step.abs() <= settled {
            return Some(TransverseApproach { feet, end: None, minimum: Some(minimum) });
        }
        let next = at(x + step, &feet)?;
        let slope_there = slope_across(&next);
        let curvature = (slope_there - slope) / step;
        // Near the end of the iteration rounding determines the slope.
        let is_rounding = step.abs() <= ROUNDED * settled;
        if is_rounding && slope_there.abs() >= 0.5 * slope.abs() {
            let feet = if slope_there.abs() < slope.abs() { next } else { feet };
            return Some(TransverseApproach { feet, end: None, minimum: Some(minimum) });
        }
        if slope_there.abs() >= 0.5 * slope.abs() || curvature <= 0.0 {
            return None;
        }
        if !is_rounding {
            minimum.curvature = curvature;
        }
        (x, feet) = (x + step, next);
    }
    None
}

/// Returns the derivative of the gap by x.
fn slope_across(feet: &[FootPoint; 2]) -> f64 {
    feet[1].slope[0] - feet[0].slope[0]
}

/// Returns the rounding of x at a zero of the slope, m: that of positions and of slopes.
fn rounding(length: f64, curvature: f64) -> f64 {
    4.0 * f64::EPSILON * (2.0 * length + curvature.abs().recip())
}

/// Returns the interval of x at `y` on which both surfaces exist; `None` if it is empty.
pub fn limits(height_fields: &[HeightField; 2], y: f64, guess: [[f64; 2]; 2]) -> Option<[SurfaceEnd; 2]> {
    let mut low = SurfaceEnd { x: f64::NEG_INFINITY, side: 0 };
    let mut high = SurfaceEnd { x: f64::INFINITY, side: 0 };
    for (side, height_field) in height_fields.iter().enumerate() {
        let ends = height_field.ends_across(y, guess[side]);
        let (least, most) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        if least > low.x {
            low = SurfaceEnd { x: least, side };
        }
        if most < high.x {
            high = SurfaceEnd { x: most, side };
        }
    }
    (low.x < high.x).then_some([low, high])
}

impl HeightField<'_> {
    /// Returns whether a point is between the surface's ends across the patch.
    fn is_inside_across(&self, foot: &FootPoint) -> bool {
        let across = self.roles[0];
        let [low, high] = self.range[across];
        (low..=high).contains(&foot.place[across])
    }

    /// Returns x of the surface's ends across the patch at `y`.
    fn ends_across(&self, y: f64, guess: [f64; 2]) -> [f64; 2] {
        let across = self.roles[0];
        self.range[across].map(|end| self.towards(across, end, 1, y, guess[1 - across]).0.at[0])
    }
}
