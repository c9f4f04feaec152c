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
const BISECTIONS: usize = 60;
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
    let mut bracket = loop {
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
    // Secant steps inside the bracket, bisection if they gain too little.
    for round in 0..BISECTIONS {
        let [(a, at_a), (b, at_b)] = bracket;
        let (slope_a, slope_b) = (slope_across(&at_a), slope_across(&at_b));
        let curvature = (slope_b - slope_a) / (b - a);
        let settled = rounding(length, curvature);
        let (nearest_x, nearest) = if slope_a.abs() < slope_b.abs() { (a, at_a) } else { (b, at_b) };
        let found =
            TransverseApproach { feet: nearest, end: None, minimum: Some(Minimum { curvature, length }) };
        if slope_a == 0.0 || slope_b == 0.0 || (b - a).abs() <= settled {
            return Some(found);
        }
        let secant = a - slope_a / curvature;
        let x = if round % 3 == 2 { 0.5 * (a + b) } else { secant };
        if (x - a) * (b - x) <= 0.0 || (secant - nearest_x).abs() <= settled {
            return Some(found);
        }
        let there = at(x, Some(&nearest))?;
        let same_side = slope_across(&there) * downhill < 0.0;
        bracket = if same_side { [(x, there), (b, at_b)] } else { [(a, at_a), (x, there)] };
    }
    let [(_, at_a), (_, at_b)] = bracket;
    let feet = if slope_across(&at_a).abs() < slope_across(&at_b).abs() { at_a } else { at_b };
    Some(TransverseApproach { feet, end: None, minimum: None })
}

/// Finds the closest approach at `y`, starting from that at a near y of the same height fields.
/// The result is that of [`closest_across`].
pub fn closest_near(
    height_fields: &[HeightField; 2],
    y: f64,
    near: &TransverseApproach,
) -> Option<TransverseApproach> {
    by_secants(height_fields, y, near).or_else(|| closest_across(height_fields, y, near.places()))
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
    let mut x = near.at()[0];
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
