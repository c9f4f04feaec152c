//! Height field of a surface over the tangent plane of a patch; Newton's method on the surface
//! coordinates solves for x, y.

use super::placement::{PatchFrame, PlacedSurface};
use calyx_numerics::vec3::dot;

/// Point of a surface in the coordinates of the tangent plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FootPoint {
    /// Surface coordinates.
    pub place: [f64; 2],
    /// x, y in the plane, m.
    pub at: [f64; 2],
    /// Height over the plane, along its normal, m.
    pub height: f64,
    /// Derivatives of the height by x and by y.
    pub slope: [f64; 2],
    /// Cosine of the angle between the normals of surface and plane, positive.
    pub cosine: f64,
    /// Derivatives of x and of y (rows) by the surface coordinates.
    tangents: [[f64; 2]; 2],
}

/// Surface over a tangent plane.
pub struct HeightField<'a> {
    pub placed: PlacedSurface<'a>,
    pub frame: PatchFrame,
    /// Range of both coordinates in which contact is searched.
    pub range: [[f64; 2]; 2],
    /// Coordinate that runs across the patch, and the one along it.
    pub roles: [usize; 2],
}

/// Fraction of its range by which a surface may be extrapolated.
const BEYOND: f64 = 0.05;
const NEWTON_STEPS: usize = 60;
/// Cosine of the largest angle between a surface and the tangent plane; beyond it the surface ends
/// for contact. Sections of a helical gear are rotated relative to each other, so the limit is
/// slightly exceeded at some.
const LEAST_COSINE: f64 = 0.3;
/// Number of bisections for this limit, which need not be exact.
const BISECTIONS: usize = 30;
/// Step of a coordinate, relative to its range, that is rounding.
const SETTLED: f64 = 4.0 * f64::EPSILON;
/// Ratio of a step of Newton's method to the square of the one before, for coordinates relative to
/// their ranges: assumed if only one step is known. On rounded edges it is their length divided by
/// their radius.
const FIRST_RATE: f64 = 100.0;
/// Step whose square is rounding.
const NEARLY: f64 = 1e-8;

impl FootPoint {
    /// Returns the surface point at surface coordinates.
    pub fn new(placed: &PlacedSurface, frame: &PatchFrame, place: [f64; 2]) -> FootPoint {
        let point = placed.at(place);
        let [x, y, height] = frame.coordinates(point.position);
        let along = |axis| point.tangents.map(|tangent| dot(tangent, axis));
        let rise = dot(point.normal, frame.normal);
        FootPoint {
            place,
            at: [x, y],
            height,
            slope: [frame.across, frame.along].map(|axis| -dot(point.normal, axis) / rise),
            cosine: rise.abs(),
            tangents: [along(frame.across), along(frame.along)],
        }
    }

    /// Returns the derivatives of the surface coordinates by x (`axis` 0) at constant y, or by y
    /// (1) at constant x.
    pub fn place_by(&self, axis: usize) -> [f64; 2] {
        let [x, y] = self.tangents;
        let determinant = x[0] * y[1] - x[1] * y[0];
        match axis {
            0 => [y[1] / determinant, -y[0] / determinant],
            _ => [-x[1] / determinant, x[0] / determinant],
        }
    }

    /// Returns the derivative of x by y along the line of constant first coordinate, like that of a
    /// rounded edge.
    pub fn x_by_y_along_edge(&self) -> f64 {
        let [[_, x], [_, y]] = self.tangents;
        x / y
    }

    /// Returns Newton's step of the surface coordinates towards `at`, and the remaining distance.
    fn step_to(&self, at: [f64; 2]) -> ([f64; 2], [f64; 2]) {
        let [x, y] = self.tangents;
        let determinant = x[0] * y[1] - x[1] * y[0];
        let short = [at[0] - self.at[0], at[1] - self.at[1]];
        let step = [
            (short[0] * y[1] - short[1] * x[1]) / determinant,
            (short[1] * x[0] - short[0] * y[0]) / determinant,
        ];
        (step, short)
    }
}

impl<'a> HeightField<'a> {
    /// Creates the height field; the tangents at `place` determine which coordinate runs across.
    pub fn new(placed: PlacedSurface<'a>, frame: PatchFrame, place: [f64; 2], search_edges: bool) -> Self {
        let mut height_field = Self { placed, frame, range: placed.range(search_edges), roles: [0, 1] };
        let [x, y] = height_field.foot(place).tangents;
        let turn = |u: usize| x[u].abs() * y[1 - u].abs();
        if turn(1) > turn(0) {
            height_field.roles = [1, 0];
        }
        height_field.cut_off_leaning(place);
        height_field
    }

    /// Limits the range across to the part next to `place` whose inclination to the tangent plane
    /// is small enough.
    fn cut_off_leaning(&mut self, place: [f64; 2]) {
        let across = self.roles[0];
        let faces = |value: f64| {
            let mut at = place;
            at[across] = value;
            self.foot(at).cosine >= LEAST_COSINE
        };
        let [low, high] = self.range[across];
        let inside = place[across].clamp(low, high);
        self.range[across] = [low, high].map(|end| {
            if !faces(inside) || faces(end) {
                return end;
            }
            let (mut near, mut far) = (inside, end);
            for _ in 0..BISECTIONS {
                let middle = 0.5 * (near + far);
                if faces(middle) { near = middle } else { far = middle }
            }
            near
        });
    }

    /// Returns the surface point at surface coordinates.
    pub fn foot(&self, place: [f64; 2]) -> FootPoint {
        FootPoint::new(&self.placed, &self.frame, place)
    }

    /// Returns the point over `at`; `None` if the surface ends before it.
    pub fn over(&self, at: [f64; 2], guess: [f64; 2]) -> Option<FootPoint> {
        self.over_near(at, &self.foot(self.clamped(guess)))
    }

    /// Returns the point over `at`, near a known point; `None` as for [`HeightField::over`].
    pub fn over_near(&self, at: [f64; 2], foot: &FootPoint) -> Option<FootPoint> {
        let mut foot = *foot;
        let mut previous = f64::INFINITY;
        for _ in 0..NEWTON_STEPS {
            let (step, _) = foot.step_to(at);
            let size = self.relative(step);
            if !size.is_finite() {
                return None;
            }
            // Converged, or limited by rounding of the surface.
            if size <= SETTLED || (size <= 1e3 * SETTLED && size >= 0.5 * previous) {
                return Some(foot);
            }
            let target = [foot.place[0] + step[0], foot.place[1] + step[1]];
            let next = self.clamped(target);
            if next == foot.place {
                return None;
            }
            foot = self.foot(next);
            // The next step is known from the last two, so its point needs no confirmation.
            let rate = if previous.is_finite() { (size / previous.powi(2)).max(1.0) } else { FIRST_RATE };
            if rate * size * size <= 0.5 * f64::EPSILON && next == target {
                return Some(foot);
            }
            previous = size;
        }
        None
    }

    /// Returns the height over `at`, near a known point, to rounding; `None` as for
    /// [`HeightField::over`].
    pub fn height_near(&self, foot: &FootPoint, at: [f64; 2]) -> Option<f64> {
        let mut foot = *foot;
        for _ in 0..NEWTON_STEPS {
            let (step, short) = foot.step_to(at);
            let size = self.relative(step);
            // The error of the tangent plane is of second order.
            if size <= NEARLY {
                return Some(foot.height + foot.slope[0] * short[0] + foot.slope[1] * short[1]);
            }
            let next = self.clamped([foot.place[0] + step[0], foot.place[1] + step[1]]);
            if !size.is_finite() || next == foot.place {
                return None;
            }
            foot = self.foot(next);
        }
        None
    }

    /// Returns the point with coordinate `fixed_axis` at `value` whose x (`axis` 0) or y (1) is
    /// `target`; `None` if the surface ends before it.
    pub fn on_line(
        &self,
        fixed_axis: usize,
        value: f64,
        axis: usize,
        target: f64,
        guess: f64,
    ) -> Option<FootPoint> {
        let (foot, reached) = self.towards(fixed_axis, value, axis, target, guess);
        reached.then_some(foot)
    }

    /// Returns the point of [`HeightField::on_line`], or the end of that line if it ends before,
    /// and whether the target was reached.
    pub fn towards(
        &self,
        fixed_axis: usize,
        value: f64,
        axis: usize,
        target: f64,
        guess: f64,
    ) -> (FootPoint, bool) {
        let free = 1 - fixed_axis;
        let place = |t: f64| if fixed_axis == 0 { [value, t] } else { [t, value] };
        let mut foot = self.foot(place(self.clamped_coordinate(free, guess)));
        let mut previous = f64::INFINITY;
        for _ in 0..NEWTON_STEPS {
            let step = (target - foot.at[axis]) / foot.tangents[axis][free];
            let size = step.abs() / self.span(free);
            if size <= SETTLED || (size <= 1e3 * SETTLED && size >= 0.5 * previous) {
                return (foot, true);
            }
            let next = self.clamped_coordinate(free, foot.place[free] + step);
            if !size.is_finite() || next == foot.place[free] {
                break;
            }
            previous = size;
            foot = self.foot(place(next));
        }
        (foot, false)
    }

    /// Returns +1 if the coordinate with this `role` grows with x (role 0) or y (1), -1 if it
    /// decreases.
    pub fn sense(&self, role: usize, foot: &FootPoint) -> f64 {
        foot.tangents[role][self.roles[role]].signum()
    }

    /// Returns the size of a step of both coordinates, relative to their ranges.
    fn relative(&self, step: [f64; 2]) -> f64 {
        let [u, v] = [0, 1].map(|k| step[k].abs() / self.span(k));
        // `max` would ignore NaN.
        if u.is_nan() || v.is_nan() { f64::NAN } else { u.max(v) }
    }

    fn span(&self, coordinate: usize) -> f64 {
        self.range[coordinate][1] - self.range[coordinate][0]
    }

    fn clamped_coordinate(&self, coordinate: usize, value: f64) -> f64 {
        let [low, high] = self.placed.surface.range()[coordinate];
        let beyond = BEYOND * (high - low);
        value.clamp(low - beyond, high + beyond)
    }

    fn clamped(&self, [u, v]: [f64; 2]) -> [f64; 2] {
        [self.clamped_coordinate(0, u), self.clamped_coordinate(1, v)]
    }
}
