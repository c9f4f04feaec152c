//! Carefully optimized hand-written versions of the workloads: uniform values are precomputed,
//! rotations about one axis are merged, velocities follow from rigid-body kinematics, and no
//! product is computed twice. The code is generic over one number or two SIMD lanes. Angles are
//! computed first, so that the sines and cosines of a whole tile can be computed together.

use super::lanes::Number;

/// A hand-written workload.
pub trait ByHand<N: Number> {
    const VARIABLES: usize;
    const ANGLES: usize;
    /// Computes the angles whose sines and cosines are needed.
    fn angles(&self, variables: &[N], angles: &mut [N]);
    /// Computes everything else; `out(k, value)` writes output `k`.
    fn rest(&self, variables: &[N], sines: &[N], cosines: &[N], out: impl FnMut(usize, N));
}

type V<N> = [N; 3];

#[inline(always)]
fn add<N: Number>(a: V<N>, b: V<N>) -> V<N> {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

#[inline(always)]
fn scale<N: Number>(s: N, a: V<N>) -> V<N> {
    [s * a[0], s * a[1], s * a[2]]
}

#[inline(always)]
fn dot<N: Number>(a: V<N>, b: V<N>) -> N {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline(always)]
fn cross<N: Number>(a: V<N>, b: V<N>) -> V<N> {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Writes outputs from `first` on.
#[inline(always)]
fn write<N: Number, const COUNT: usize>(out: &mut impl FnMut(usize, N), first: usize, values: [N; COUNT]) {
    for (k, value) in values.into_iter().enumerate() {
        out(first + k, value);
    }
}

/// Rotates a vector about coordinate axis `AXIS`, right-handed.
#[inline(always)]
fn turn<N: Number, const AXIS: usize>(s: N, c: N, v: V<N>) -> V<N> {
    let (i, j) = ((AXIS + 1) % 3, (AXIS + 2) % 3);
    let mut w = v;
    w[i] = c * v[i] - s * v[j];
    w[j] = s * v[i] + c * v[j];
    w
}

/// Workload W1.
pub struct Planet<N> {
    rx: N,
    ry: N,
    px: N,
    across: N,
    phase: N,
    w: N,
    ww: N,
    relative: N,
    relative_squared: N,
}

impl<N: Number> Planet<N> {
    pub fn new(p: &[f64]) -> Self {
        let relative = p[6] - p[7];
        Planet {
            rx: N::of(p[1]),
            ry: N::of(p[2]),
            px: N::of(p[3]),
            across: N::of(p[0] + p[4]),
            phase: N::of(p[5]),
            w: N::of(p[6]),
            ww: N::of(p[6] * p[6]),
            relative: N::of(relative),
            relative_squared: N::of(relative * relative),
        }
    }
}

impl<N: Number> ByHand<N> for Planet<N> {
    const VARIABLES: usize = 1;
    const ANGLES: usize = 2;

    #[inline(always)]
    fn angles(&self, variables: &[N], angles: &mut [N]) {
        angles[0] = self.relative * variables[0] + self.phase;
        angles[1] = self.w * variables[0] + self.phase;
    }

    #[inline(always)]
    fn rest(&self, _: &[N], sines: &[N], cosines: &[N], mut out: impl FnMut(usize, N)) {
        let (sa, ca, s, c) = (sines[0], cosines[0], sines[1], cosines[1]);
        let x = ca * self.px - sa * self.across;
        let y = sa * self.px + ca * self.across;
        let (ws, wc, wws, wwc) = (self.w * s, self.w * c, self.ww * s, self.ww * c);
        let entries = [c, -s, self.rx + x, s, c, self.ry + y];
        let first = [-ws, -wc, -(self.relative * y), wc, -ws, self.relative * x];
        let second = [-wwc, wws, -(self.relative_squared * x), -wws, -wwc, -(self.relative_squared * y)];
        let design = [-sa, ca, ca, sa, -sa, ca, -s, -c, -y, c, -s, x];
        write(&mut out, 0, entries);
        write(&mut out, 6, first);
        write(&mut out, 12, second);
        write(&mut out, 18, design);
    }
}

/// Machine settings of W2 and W3, and values that depend only on the settings.
pub struct Machine<N> {
    s: N,
    q: N,
    offset: [N; 4],
    sliding: [N; 4],
    /// Polynomial of the generating roll.
    roll: [N; 4],
    ra: N,
    xp: N,
    r0: N,
    /// Sines and cosines of the blade angle, of the complement of the root angle, of tilt and
    /// swivel.
    blade: [N; 2],
    root: [N; 2],
    tilt: [N; 2],
    swivel: [N; 2],
}

impl<N: Number> Machine<N> {
    pub fn new(p: &[f64]) -> Self {
        let pair = |angle: f64| [N::of(angle.sin()), N::of(angle.cos())];
        Machine {
            s: N::of(p[2]),
            q: N::of(p[3] - std::f64::consts::FRAC_PI_2),
            offset: [p[4], p[16], p[17], p[18]].map(N::of),
            sliding: [p[5], p[13], p[14], p[15]].map(N::of),
            roll: [-p[9] / 2.0, -p[10] / 6.0, -p[11] / 24.0, -p[12] / 120.0].map(N::of),
            ra: N::of(p[8]),
            xp: N::of(p[7]),
            r0: N::of(p[19]),
            blade: pair(p[20]),
            root: pair(std::f64::consts::FRAC_PI_2 - p[6]),
            tilt: pair(-p[0]),
            swivel: pair(-p[1]),
        }
    }

    /// Returns the roll angle divided by the ratio.
    #[inline(always)]
    fn bracket(&self, phi: N) -> N {
        let [a, b, c, d] = self.roll;
        phi * (N::of(1.0) + phi * (a + phi * (b + phi * (c + phi * d))))
    }
}

#[inline(always)]
fn cubic<N: Number>(c: [N; 4], x: N) -> N {
    c[0] + x * (c[1] + x * (c[2] + x * c[3]))
}

/// Workload W2.
pub struct Generated<N>(pub Machine<N>);

impl<N: Number> ByHand<N> for Generated<N> {
    const VARIABLES: usize = 3;
    const ANGLES: usize = 3;

    #[inline(always)]
    fn angles(&self, variables: &[N], angles: &mut [N]) {
        let (theta, phi) = (variables[1], variables[2]);
        angles[0] = theta;
        angles[1] = self.0.q - phi;
        angles[2] = self.0.ra * self.0.bracket(phi);
    }

    #[inline(always)]
    fn rest(&self, variables: &[N], sines: &[N], cosines: &[N], mut out: impl FnMut(usize, N)) {
        let m = &self.0;
        let (u, phi) = (variables[0], variables[2]);
        let (zero, one, two) = (N::of(0.0), N::of(1.0), N::of(2.0));
        let [sal, cal] = m.blade;
        let (rho, z) = (m.r0 + u * sal, -(u * cal));
        // Directions of the cutter: radial, its derivative with respect to theta, axial; then
        // tilted and swivelled.
        let (st, ct) = (sines[0], cosines[0]);
        let placed = |v: V<N>| {
            let v = turn::<N, 1>(m.tilt[0], m.tilt[1], v);
            turn::<N, 2>(m.swivel[0], m.swivel[1], v)
        };
        let [e1, e2, axial] = [[one, zero, zero], [zero, one, zero], [zero, zero, one]].map(placed);
        let radial = add(scale(ct, e1), scale(st, e2));
        let along = add(scale(ct, e2), scale(-st, e1));
        // Cradle: rotated by beta, whose derivative with respect to phi is -1.
        let (sb, cb) = (sines[1], cosines[1]);
        let [radial, along, axial] = [radial, along, axial].map(|v| turn::<N, 2>(sb, cb, v));
        let y = add(add(scale(rho, radial), scale(z, axial)), [-(m.s * sb), m.s * cb, zero]);
        let y_u = add(scale(sal, radial), scale(-cal, axial));
        let [_, v1, v2, v3] = m.offset;
        let [_, h1, h2, h3] = m.sliding;
        let d = [zero, -cubic(m.offset, phi), cubic(m.sliding, phi)];
        let three = N::of(3.0);
        let d1 =
            [zero, -(v1 + phi * (two * v2 + phi * (three * v3))), h1 + phi * (two * h2 + phi * (three * h3))];
        let six = N::of(6.0);
        let d2 = [zero, -(two * v2 + phi * (six * v3)), two * h2 + phi * (six * h3)];
        // -e3 x v
        let back = |v: V<N>| [v[1], -v[0], zero];
        let w = add(y, d);
        let w1 = add(back(y), d1);
        let w2 = add([-y[0], -y[1], zero], d2);
        // Rotation by the root angle.
        let lean = |v: V<N>| turn::<N, 1>(m.root[0], m.root[1], v);
        let v = lean(w);
        let v = [v[0], v[1], v[2] + m.xp];
        let (v1, v2) = (lean(w1), lean(w2));
        // Rotation of the blank.
        let [a, b, c, e] = m.roll;
        let rate = m.ra
            * (one + phi * (two * a + phi * (three * b + phi * (N::of(4.0) * c + phi * (N::of(5.0) * e)))));
        let change = m.ra * (two * a + phi * (six * b + phi * (N::of(12.0) * c + phi * (N::of(20.0) * e))));
        let (s1, c1) = (sines[2], cosines[2]);
        let roll = |v: V<N>| turn::<N, 2>(s1, c1, v);
        let moved = |v: V<N>, v1: V<N>| [v1[0] - rate * v[1], v1[1] + rate * v[0], v1[2]];
        let x = roll(v);
        let velocity = moved(v, v1);
        let x_p = roll(velocity);
        // v'' + 2 w x v' + w' x v + w x (w x v) = v'' + w x (v' + velocity) + w' x v
        let both = add(v1, velocity);
        let x_pp =
            roll([v2[0] - rate * both[1] - change * v[1], v2[1] + rate * both[0] + change * v[0], v2[2]]);
        let direction = |y: V<N>| {
            let (v, v1) = (lean(y), lean(back(y)));
            (roll(v), roll(moved(v, v1)))
        };
        let (x_u, x_up) = direction(y_u);
        let (tangent, tangent_p) = direction(along);
        let (x_t, x_tp, x_ut) = (scale(rho, tangent), scale(rho, tangent_p), scale(sal, tangent));
        let x_tt = scale(-rho, roll(lean(radial)));
        let normal = cross(x_u, x_t);
        let f = dot(normal, x_p);
        let f_u = dot(cross(x_u, x_ut), x_p) + dot(normal, x_up);
        let f_t = dot(add(cross(x_ut, x_t), cross(x_u, x_tt)), x_p) + dot(normal, x_tp);
        let f_p = dot(add(cross(x_up, x_t), cross(x_u, x_tp)), x_p) + dot(normal, x_pp);
        for (k, vector) in [x, x_u, x_t, x_p].into_iter().enumerate() {
            write(&mut out, 3 * k, vector);
        }
        write(&mut out, 12, [f, f_u, f_t, f_p]);
        for (k, vector) in [x_ut, x_up, x_tt, x_tp, x_pp].into_iter().enumerate() {
            write(&mut out, 16 + 3 * k, vector);
        }
    }
}

/// Workload W3.
pub struct Sensitivity<N>(pub Machine<N>);

impl<N: Number> ByHand<N> for Sensitivity<N> {
    const VARIABLES: usize = 3;
    const ANGLES: usize = 3;

    #[inline(always)]
    fn angles(&self, variables: &[N], angles: &mut [N]) {
        let (theta, phi) = (variables[1], variables[2]);
        angles[0] = theta;
        angles[1] = self.0.q - phi;
        angles[2] = self.0.ra * self.0.bracket(phi);
    }

    #[inline(always)]
    fn rest(&self, variables: &[N], sines: &[N], cosines: &[N], mut out: impl FnMut(usize, N)) {
        let m = &self.0;
        let (u, phi) = (variables[0], variables[2]);
        let zero = N::of(0.0);
        let [sal, cal] = m.blade;
        let (rho, z) = (m.r0 + u * sal, -(u * cal));
        let (st, ct, sb, cb, s1, c1) = (sines[0], cosines[0], sines[1], cosines[1], sines[2], cosines[2]);
        let lean = |v: V<N>| turn::<N, 1>(m.root[0], m.root[1], v);
        let roll = |v: V<N>| turn::<N, 2>(s1, c1, v);
        let cradle = |v: V<N>| turn::<N, 2>(sb, cb, v);
        let swivel = |v: V<N>| turn::<N, 2>(m.swivel[0], m.swivel[1], v);
        let outwards = |v: V<N>| roll(lean(cradle(v)));
        // Radial and axial direction of the cutter, tilted.
        let tilted = turn::<N, 1>(m.tilt[0], m.tilt[1], [ct, st, zero]);
        let axis = [m.tilt[0], zero, m.tilt[1]];
        let tip = add(scale(rho, tilted), scale(z, axis));
        let swivelled = swivel(tip);
        let y = cradle([swivelled[0], swivelled[1] + m.s, swivelled[2]]);
        let w = [y[0], y[1] - cubic(m.offset, phi), y[2] + cubic(m.sliding, phi)];
        let v = lean(w);
        let x = roll([v[0], v[1], v[2] + m.xp]);
        let by_tilt = outwards(swivel([-tip[2], zero, tip[0]]));
        let by_swivel = outwards([swivelled[1], -swivelled[0], zero]);
        let by_s = roll(lean([-sb, cb, zero]));
        let by_q = roll(lean([-y[1], y[0], zero]));
        let (across, above) = ([s1, -c1], [c1 * m.root[0], s1 * m.root[0]]);
        let by_root = roll([-v[2], zero, v[0]]);
        let turned = [-x[1], x[0]];
        let (p2, p3) = (phi * phi, phi * phi * phi);
        let radial = outwards(swivel(tilted));
        let axial = outwards(swivel(axis));
        let by_blade = add(scale(u * cal, radial), scale(u * sal, axial));
        let mut k = 0;
        let mut write = |values: &[N]| {
            for &value in values {
                out(k, value);
                k += 1;
            }
        };
        write(&x);
        write(&by_tilt);
        write(&by_swivel);
        write(&by_s);
        write(&by_q);
        write(&across);
        write(&[above[0], above[1], m.root[1]]);
        write(&by_root);
        let bracket = m.bracket(phi);
        write(&[bracket * turned[0], bracket * turned[1]]);
        let mut power = p2;
        for divisor in [-0.5, -1.0 / 6.0, -1.0 / 24.0, -1.0 / 120.0] {
            let factor = (m.ra * N::of(divisor)) * power;
            write(&[factor * turned[0], factor * turned[1]]);
            power = power * phi;
        }
        for power in [phi, p2, p3] {
            write(&[power * above[0], power * above[1], power * m.root[1]]);
        }
        for power in [phi, p2, p3] {
            write(&[power * across[0], power * across[1]]);
        }
        write(&radial);
        write(&by_blade);
    }
}

/// Coefficients of one pair of W4, for the translation and for the angle.
#[derive(Clone, Copy)]
struct Link {
    translation: [[f64; 3]; 3],
    angle: [f64; 4],
}

/// Workload W4, with coefficients known at compile time.
pub struct Chain;

const LINKS: [Link; 25] = links();

const fn links() -> [Link; 25] {
    let mut links = [Link { translation: [[0.0; 3]; 3], angle: [0.0; 4] }; 25];
    let mut state = 4_u64;
    let mut k = 0;
    while k < 25 {
        let mut drawn = [0.0; 13];
        let mut i = 0;
        while i < 13 {
            state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
            let mut z = state;
            z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
            z ^= z >> 31;
            let unit = (z >> 11) as f64 / (1_u64 << 53) as f64;
            drawn[i] = ((unit * 2001.0) as i64 - 1000) as f64 / 1000.0;
            i += 1;
        }
        links[k].translation =
            [[drawn[0], drawn[1], drawn[2]], [drawn[3], drawn[4], drawn[5]], [drawn[6], drawn[7], drawn[8]]];
        links[k].angle = [drawn[9], drawn[10], drawn[11], drawn[12]];
        k += 1;
    }
    links
}

/// The state passed from tip to base: axes, angular velocity and origin of the frame, each with
/// derivatives, relative to the link below.
struct Tip<N> {
    axes: [V<N>; 3],
    spin: [V<N>; 2],
    origin: [V<N>; 3],
}

impl Chain {
    #[inline(always)]
    fn pass<N: Number>(tip: &mut Tip<N>, link: &Link, t: N, rotation: impl Fn(V<N>) -> V<N>, axis: [f64; 3]) {
        let [_, a1, a2, a3] = link.angle;
        let rate = N::of(a1) + t * (N::of(2.0 * a2) + t * N::of(3.0 * a3));
        let change = N::of(2.0 * a2) + t * N::of(6.0 * a3);
        let multiple = |factor: N| {
            axis.map(|n| {
                if n == 0.0 {
                    N::of(0.0)
                } else if n == 1.0 {
                    factor
                } else {
                    N::of(n) * factor
                }
            })
        };
        // The cross product with a coordinate axis has one zero component and needs two products.
        let about = |factor: N, v: V<N>| match axis {
            [1.0, 0.0, 0.0] => [N::of(0.0), -(factor * v[2]), factor * v[1]],
            [0.0, 1.0, 0.0] => [factor * v[2], N::of(0.0), -(factor * v[0])],
            [0.0, 0.0, 1.0] => [-(factor * v[1]), factor * v[0], N::of(0.0)],
            _ => cross(multiple(factor), v),
        };
        let plus = |a: V<N>, b: V<N>| {
            let mut sum = a;
            for i in 0..3 {
                let idle = axis[i] == 1.0;
                if !idle {
                    sum[i] = a[i] + b[i];
                }
            }
            sum
        };
        // Angular velocities are added in the frame before the rotation, where the axis is the
        // same.
        let [spin, spinning] = tip.spin;
        let spinning = plus(spinning, about(rate, spin));
        let add_along = |v: V<N>, factor: N| {
            let along = multiple(factor);
            let mut sum = v;
            for i in 0..3 {
                if axis[i] != 0.0 {
                    sum[i] = v[i] + along[i];
                }
            }
            sum
        };
        tip.spin = [rotation(add_along(spin, rate)), rotation(add_along(spinning, change))];
        let [x, x1, x2] = tip.origin;
        let first = plus(x1, about(rate, x));
        let second = plus(plus(x2, about(change, x)), about(rate, add(x1, first)));
        let [x, x1, x2] = [rotation(x), rotation(first), rotation(second)];
        let [p, p1, p2] = [0, 1, 2].map(|order| {
            link.translation.map(|[c0, c1, c2]| match order {
                0 => N::of(c0) + t * (N::of(c1) + t * N::of(c2)),
                1 => N::of(c1) + t * N::of(2.0 * c2),
                _ => N::of(2.0 * c2),
            })
        });
        tip.origin = [add(x, p), add(x1, p1), add(x2, p2)];
        tip.axes = tip.axes.map(rotation);
    }
}

impl<N: Number> ByHand<N> for Chain {
    const VARIABLES: usize = 1;
    const ANGLES: usize = 25;

    #[inline(always)]
    fn angles(&self, variables: &[N], angles: &mut [N]) {
        let t = variables[0];
        for (angle, link) in angles.iter_mut().zip(&LINKS) {
            let [a0, a1, a2, a3] = link.angle.map(N::of);
            *angle = a0 + t * (a1 + t * (a2 + t * a3));
        }
    }

    #[inline(always)]
    fn rest(&self, variables: &[N], sines: &[N], cosines: &[N], mut out: impl FnMut(usize, N)) {
        let t = variables[0];
        let (zero, one) = (N::of(0.0), N::of(1.0));
        let mut tip = Tip {
            axes: [[one, zero, zero], [zero, one, zero], [zero, zero, one]],
            spin: [[zero; 3]; 2],
            origin: [[zero; 3]; 3],
        };
        for k in (0..25).rev() {
            let (s, c, link) = (sines[k], cosines[k], &LINKS[k]);
            match k % 4 {
                0 => Self::pass(&mut tip, link, t, |v| turn::<N, 0>(s, c, v), [1.0, 0.0, 0.0]),
                1 => Self::pass(&mut tip, link, t, |v| turn::<N, 1>(s, c, v), [0.0, 1.0, 0.0]),
                2 => Self::pass(&mut tip, link, t, |v| turn::<N, 2>(s, c, v), [0.0, 0.0, 1.0]),
                _ => {
                    let n = [0.36, 0.48, 0.8];
                    let versine = one - c;
                    let mut r = [[zero; 3]; 3];
                    for i in 0..3 {
                        let (j, l) = ((i + 1) % 3, (i + 2) % 3);
                        r[i][i] = N::of(n[i] * n[i]) * versine + c;
                        let (symmetric, skew) = (N::of(n[i] * n[j]) * versine, N::of(n[l]) * s);
                        r[i][j] = symmetric - skew;
                        r[j][i] = symmetric + skew;
                    }
                    Self::pass(&mut tip, link, t, |v| r.map(|row| dot(row, v)), n);
                }
            }
        }
        // The axes rotate with the angular velocity.
        let [w, change] = tip.spin;
        let first = tip.axes.map(|axis| cross(w, axis));
        let second = [0, 1, 2].map(|i| add(cross(change, tip.axes[i]), cross(w, first[i])));
        for (order, axes) in [tip.axes, first, second].into_iter().enumerate() {
            for row in 0..3 {
                let at = 12 * order + 4 * row;
                out(at, axes[0][row]);
                out(at + 1, axes[1][row]);
                out(at + 2, axes[2][row]);
                out(at + 3, tip.origin[order][row]);
            }
        }
    }
}
