//! Closest approach of two surfaces across a patch, at one y: the slope of the gap along x is
//! monotonic, so its zero is unique, and is bracketed if secant steps do not find it quickly.

use super::height_field::{FootPoint, HeightField};

/// Closest approach at one y.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TransverseApproach {
    /// Points of both surfaces at the same x and y.
    pub feet: [FootPoint; 2],
    /// Body whose surface ends here before the minimum of the gap.
    pub end: Option<usize>,
    /// Second derivative of the gap by x, 1/m, if it was determined: approximate.
    pub bend: Option<f64>,
}

impl TransverseApproach {
    /// Returns the points at surface coordinates, to start a search from. They need not be opposite.
    pub fn start(height_fields: &[HeightField; 2], places: [[f64; 2]; 2]) -> Self {
        let feet = [0, 1].map(|side| height_fields[side].foot_near(places[side]));
        Self { feet, end: None, bend: None }
    }

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
/// Maximum number of secant steps without a bracket.
const QUICK_STEPS: usize = 10;
/// First step of them without a known second derivative, relative to the width of the surfaces.
const PROBE: f64 = 1e-3;
/// Shortest step, relative to the width of the surfaces, from which a second derivative is
/// determined.
const SHORT: f64 = 1e-6;
/// Multiple of the rounding of a position below which steps no longer decrease.
const STALLED: f64 = 64.0;

/// End of the interval of x on which both surfaces exist, and the surface that ends.
#[derive(Clone, Copy, Debug)]
pub struct SurfaceEnd {
    pub x: f64,
    pub side: usize,
}

/// Returns the points of both surfaces over `at`, from known points of these height fields; `None`
/// if a surface ends before.
fn opposite(
    height_fields: &[HeightField; 2],
    at: [f64; 2],
    guess: &[FootPoint; 2],
) -> Option<TransverseApproach> {
    let first = height_fields[0].over(at, &guess[0])?;
    let second = height_fields[1].over(at, &guess[1])?;
    Some(TransverseApproach { feet: [first, second], end: None, bend: None })
}

/// Finds the closest approach at `y`, starting near `guess`. `None` if the surfaces do not face each
/// other there.
pub fn closest_across(
    height_fields: &[HeightField; 2],
    y: f64,
    guess: &TransverseApproach,
) -> Option<TransverseApproach> {
    quickly(height_fields, y, guess).or_else(|| bracketed(height_fields, y, guess))
}

/// Finds the zero of the slope by secant steps without a bracket. `None` if they do not converge
/// quickly, or not between the ends of both surfaces.
fn quickly(
    height_fields: &[HeightField; 2],
    y: f64,
    guess: &TransverseApproach,
) -> Option<TransverseApproach> {
    let widths = [0, 1].map(|side| height_fields[side].width_at(&guess.feet[side]));
    let length = widths[0].min(widths[1]);
    let mut x = guess.at()[0];
    let mut here = opposite(height_fields, [x, y], &guess.feet)?;
    let mut bend = guess.bend;
    let mut previous = length;
    for _ in 0..QUICK_STEPS {
        let slope = here.slope()[0];
        let step = match bend {
            Some(bend) => -slope / bend,
            None => -slope.signum() * PROBE * length,
        };
        if let Some(bend) = bend {
            let settled = 4.0 * f64::EPSILON * (2.0 * length + bend.recip());
            let stalled = step.abs() <= STALLED * settled && step.abs() >= 0.5 * previous;
            if slope == 0.0 || step.abs() <= settled || stalled {
                let inside = (0..2).all(|side| height_fields[side].contains(&here.feet[side]));
                return inside.then_some(TransverseApproach { bend: Some(bend), ..here });
            }
            let converges = step.abs() <= 0.5 * previous;
            if !converges {
                return None;
            }
            previous = step.abs();
        }
        let there = opposite(height_fields, [x + step, y], &here.feet)?;
        // Differences over short steps are rounding.
        if step.abs() > SHORT * length || bend.is_none() {
            bend = Some((there.slope()[0] - slope) / step).filter(|bend| *bend > 0.0);
            bend?;
        }
        x += step;
        here = there;
    }
    None
}

/// Finds the closest approach between the ends of both surfaces: descends until the slope of the gap
/// changes its sign, then narrows this interval.
fn bracketed(
    height_fields: &[HeightField; 2],
    y: f64,
    guess: &TransverseApproach,
) -> Option<TransverseApproach> {
    let [low, high] = limits(height_fields, y, guess.places())?;
    let at = |x: f64, guess: &TransverseApproach| opposite(height_fields, [x, y], &guess.feet);
    let length = high.x - low.x;
    let mut here = guess.at()[0].clamp(low.x, high.x);
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
        let Some(there) = at(next, &closest) else {
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
        let there = at(x, &nearest)?;
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

#[cfg(test)]
mod tests {
    use super::super::placement::{PatchFrame, PlacedSurface, Pose};
    use super::super::test_surfaces::Cap;
    use super::*;
    use calyx_structure::surface::{Surface, SurfacePoint};
    use std::sync::atomic::{AtomicUsize, Ordering};

    /// Cap that counts its evaluations.
    struct Counted(Cap, AtomicUsize);

    impl Surface for Counted {
        fn range(&self) -> [[f64; 2]; 2] {
            self.0.range()
        }

        fn at(&self, u: f64, v: f64) -> SurfacePoint {
            self.1.fetch_add(1, Ordering::Relaxed);
            self.0.at(u, v)
        }
    }

    #[test]
    fn quick_steps_find_the_bracketed_approach_with_few_evaluations() {
        let cap = |faces: f64, radii: [f64; 2]| {
            Counted(Cap { radii, faces, half: [4.0, 6.0], turn: 0.3 }, AtomicUsize::new(0))
        };
        let surfaces = [cap(1.0, [31.0, 90.0]), cap(-1.0, [17.0, 50.0])];
        let frame = PatchFrame {
            point: [0.0; 3],
            normal: [0.0, 0.0, 1.0],
            across: [1.0, 0.0, 0.0],
            along: [0.0, 1.0, 0.0],
        };
        let height_fields = [0, 1].map(|side: usize| {
            let pose = Pose { origin: [0.4 * side as f64, 0.2, 0.0], ..Pose::IDENTITY };
            HeightField::new(PlacedSurface { surface: &surfaces[side], pose }, frame, [0.1, 0.2], true)
        });
        let evaluations =
            || -> usize { surfaces.iter().map(|surface| surface.1.load(Ordering::Relaxed)).sum() };
        let mut guess = TransverseApproach::start(&height_fields, [[0.1, 0.2]; 2]);
        for y in [0.0, 0.3, -1.1, 2.5] {
            let before = evaluations();
            let quick = quickly(&height_fields, y, &guess).expect("no end is near");
            let between = evaluations();
            let slow = bracketed(&height_fields, y, &guess).expect("no end is near");
            assert!((quick.at()[0] - slow.at()[0]).abs() < 1e-13, "{quick:?} {slow:?}");
            assert!((quick.gap() - slow.gap()).abs() < 1e-14 && quick.end.is_none() && slow.end.is_none());
            assert!(2 * (between - before) < evaluations() - between, "{y}: {}", between - before);
            guess = quick;
        }
    }

    #[test]
    fn an_approach_beyond_the_end_of_a_surface_is_found_at_the_end() {
        let cap = |faces: f64, half: f64| Cap { radii: [31.0, 90.0], faces, half: [half, 6.0], turn: 0.0 };
        let surfaces = [cap(1.0, 4.0), cap(-1.0, 1.0)];
        let frame = PatchFrame {
            point: [0.0; 3],
            normal: [0.0, 0.0, 1.0],
            across: [1.0, 0.0, 0.0],
            along: [0.0, 1.0, 0.0],
        };
        // The lowest point is within the extrapolated part of the second surface.
        let height_fields = [0, 1].map(|side: usize| {
            let pose = Pose { origin: [2.06 * side as f64, 0.0, 0.0], ..Pose::IDENTITY };
            HeightField::new(PlacedSurface { surface: &surfaces[side], pose }, frame, [0.1, 0.2], true)
        });
        let guess = TransverseApproach::start(&height_fields, [[1.2, 0.0], [-0.8, 0.0]]);
        assert!(quickly(&height_fields, 0.0, &guess).is_none());
        let closest = closest_across(&height_fields, 0.0, &guess).expect("they face each other");
        assert_eq!(closest.end, Some(1));
        assert!((closest.at()[0] - 1.06).abs() < 1e-12, "{closest:?}");
    }
}
