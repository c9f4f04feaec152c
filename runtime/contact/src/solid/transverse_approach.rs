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
    let at = |x: f64, guess: [[f64; 2]; 2]| -> Option<TransverseApproach> {
        let first = height_fields[0].over([x, y], guess[0])?;
        let second = height_fields[1].over([x, y], guess[1])?;
        Some(TransverseApproach { feet: [first, second], end: None })
    };
    let length = high.x - low.x;
    let middle = 0.5 * (height_fields[0].foot(guess[0]).at[0] + height_fields[1].foot(guess[1]).at[0]);
    let mut here = middle.clamp(low.x, high.x);
    let mut closest = at(here, guess)?;
    // Descend in growing steps until the slope changes its sign or a surface ends.
    let downhill = -closest.slope()[0].signum();
    if closest.slope()[0] == 0.0 {
        return Some(closest);
    }
    let mut stride = length / WALK;
    let mut bracket = loop {
        let limit = if downhill > 0.0 { high } else { low };
        let next = here + downhill * stride;
        let beyond = downhill * (next - limit.x) >= 0.0;
        let next = if beyond { limit.x } else { next };
        let Some(there) = at(next, closest.places()) else {
            // The other coordinate ends before this one.
            stride *= 0.25;
            if stride > LEAST_STRIDE * length {
                continue;
            }
            return Some(TransverseApproach { end: Some(limit.side), ..closest });
        };
        if there.slope()[0] * downhill >= 0.0 {
            break [(here, closest), (next, there)];
        }
        (here, closest) = (next, there);
        if beyond {
            return Some(TransverseApproach { end: Some(limit.side), ..closest });
        }
        stride *= 1.5;
    };
    // Secant steps inside the bracket, bisection if they gain too little.
    for round in 0..BISECTIONS {
        let [(a, at_a), (b, at_b)] = bracket;
        let (slope_a, slope_b) = (at_a.slope()[0], at_b.slope()[0]);
        // Rounding of positions and slopes.
        let settled = 4.0 * f64::EPSILON * (2.0 * length + ((b - a) / (slope_b - slope_a)).abs());
        let (nearest_x, nearest) = if slope_a.abs() < slope_b.abs() { (a, at_a) } else { (b, at_b) };
        if slope_a == 0.0 || slope_b == 0.0 || (b - a).abs() <= settled {
            return Some(nearest);
        }
        let secant = a - slope_a * (b - a) / (slope_b - slope_a);
        let x = if round % 3 == 2 { 0.5 * (a + b) } else { secant };
        if (x - a) * (b - x) <= 0.0 || (secant - nearest_x).abs() <= settled {
            return Some(nearest);
        }
        let there = at(x, nearest.places())?;
        let same_side = there.slope()[0] * downhill < 0.0;
        bracket = if same_side { [(x, there), (b, at_b)] } else { [(a, at_a), (x, there)] };
    }
    let [(_, at_a), (_, at_b)] = bracket;
    Some(if at_a.slope()[0].abs() < at_b.slope()[0].abs() { at_a } else { at_b })
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
    /// Returns x of the surface's ends across the patch at `y`.
    fn ends_across(&self, y: f64, guess: [f64; 2]) -> [f64; 2] {
        let across = self.roles[0];
        self.range[across].map(|end| self.towards(across, end, 1, y, guess[1 - across]).0.at[0])
    }
}
