//! Elastic contact lines: strips of semi-elliptic pressure on half-spaces.
//!
//! Each strip of a contact line has a load per length w ≥ 0 and a half-width b of its pressure
//! (2w/πb) √(1 - y²/b²). Loads and half-widths minimize the complementary energy of the half-spaces
//! among all pressures of this form. On a long line that is Hertz's solution, and near the ends the
//! half-width is its own. The theory manual derives the energy on its page about rolling bearings.

use super::integral::Integral;
use super::near::{Near, Rule};
use crate::linear::{cholesky, product, solve_lower};
use std::f64::consts::PI;

/// Pressure whose half-width defines what is near, Pa.
const LARGEST_PRESSURE: f64 = 4e9;
/// Distance within which half-widths matter, as a multiple of the half-width at
/// [`LARGEST_PRESSURE`].
const NEAR: f64 = 4.0;
/// Distance within which the distribution of pressure across the line matters, likewise.
const CLOSE: f64 = 1.0;

/// Strip of a contact line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strip {
    /// Position of the middle from the middle of the contact line, m.
    pub position: f64,
    /// Length along the contact line, m.
    pub length: f64,
    /// Effective radius in the normal section, m.
    pub radius: f64,
}

/// Contact line between a roller and a raceway.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Strips, from one end of the line to the other without gaps.
    pub strips: Vec<Strip>,
    /// End faces of the roller and side faces of the raceway; none if both bodies extend beyond the
    /// line.
    pub faces: Vec<Face>,
}

/// Free face across a contact line, beyond its strips or at its end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Face {
    /// Position from the middle of the contact line, m.
    pub position: f64,
    /// Deflection by the images of the loads in the face, as a share of the deflection of both
    /// bodies by loads at the same distance.
    pub share: f64,
}

impl Line {
    /// A line with free faces at both ends; `share` is that of [`Face::share`].
    pub fn with_free_ends(strips: Vec<Strip>, share: f64) -> Self {
        let mut line = Self { strips, faces: Vec::new() };
        if let (true, [Some(first), Some(last)]) = (share != 0.0, [line.strips.first(), line.strips.last()]) {
            line.faces = [first.position - 0.5 * first.length, last.position + 0.5 * last.length]
                .map(|position| Face { position, share })
                .to_vec();
        }
        line
    }
}

/// Loads and half-widths of strips.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StripLoads {
    /// Loads per length, N/m.
    pub loads: Vec<f64>,
    /// Squares of the half-widths, m².
    pub(super) squares: Vec<f64>,
}

impl StripLoads {
    /// Returns the half-width of a strip, m.
    pub fn half_width(&self, strip: usize) -> f64 {
        self.squares[strip].sqrt()
    }

    /// Returns the largest pressure of a strip, Pa.
    pub fn pressure(&self, strip: usize) -> f64 {
        2.0 * self.loads[strip] / (PI * self.half_width(strip))
    }
}

/// Part of the length of a contact line that is divided evenly; the rest has strips that are
/// shorter towards the ends.
const EVEN: f64 = 0.1;

/// Divides a contact line into strips that are shorter towards its ends. Their bounds are the means
/// of equal parts of the line and of the projections of equal arcs of a half-circle. `radius`
/// returns the effective radius at a position, m.
pub fn graded_strips(length: f64, count: usize, radius: impl Fn(f64) -> f64) -> Vec<Strip> {
    let bound = |k: usize| {
        let part = k as f64 / count as f64;
        let graded = -libm::cos(PI * part);
        0.5 * length * (EVEN * (2.0 * part - 1.0) + (1.0 - EVEN) * graded)
    };
    let strip = |k| {
        let (start, end) = (bound(k), bound(k + 1));
        let position = 0.5 * (start + end);
        Strip { position, length: end - start, radius: radius(position) }
    };
    (0..count).map(strip).collect()
}

/// Strips of all contact lines of a roller.
#[derive(Clone, Debug, PartialEq)]
pub struct Strips {
    pub(super) strips: Vec<Strip>,
    /// Number of strips of each line.
    lines: Vec<usize>,
    /// π times the composite modulus, Pa.
    pub(super) modulus: f64,
    /// Interaction of distant strips and compliance of the roller's body, times the modulus.
    far: Vec<f64>,
    near: Vec<Near>,
    /// Squared half-width of Hertz's solution divided by the load per length, m³/N.
    pub(super) widths: Vec<f64>,
    /// Smallest square of a half-width, m².
    pub(super) least: f64,
}

/// Complementary energy of the strips, times the modulus, with its derivatives.
#[derive(Clone, Debug, Default)]
pub(crate) struct Work {
    pub(super) energy: f64,
    /// Derivatives with respect to the loads per length.
    pub(super) gradient: Vec<f64>,
    /// Residual of the half-widths: derivatives with respect to their squares, divided by half of
    /// the load per length.
    pub(super) widening: Vec<f64>,
    /// Second derivatives with respect to the loads, T.
    pub(super) direct: Vec<f64>,
    /// Derivatives of T with respect to the mean square of the half-widths of both strips.
    pub(super) slopes: Vec<f64>,
    /// Second derivatives of T with respect to this mean square.
    pub(super) bends: Vec<f64>,
    /// Indices of the strips that may carry load.
    pub(super) free: Vec<usize>,
    /// Cholesky factor of the energy's second derivatives with respect to the loads of the free
    /// strips, at half-widths that follow.
    pub(super) factor: Vec<f64>,
    /// For each line, its strips with free half-width, the Cholesky factor of the second
    /// derivatives with respect to half-widths, and the columns of T' divided by the factor.
    pub(super) widths: Vec<Widths>,
}

/// Elimination of the half-widths of one line.
#[derive(Clone, Debug, Default)]
pub(crate) struct Widths {
    pub(super) strips: Vec<usize>,
    /// Number of the free strips of the line.
    pub(super) free: usize,
    pub(super) factor: Vec<f64>,
    /// One row for each free strip of the line.
    pub(super) rows: Vec<f64>,
}

impl Strips {
    /// Prepares the contact lines of a roller. `composite_modulus` is E*, Pa; `body` returns the
    /// deflection of a strip by a load on another one beyond that of the half-spaces, m/N.
    pub fn new(lines: &[Line], composite_modulus: f64, body: impl Fn(usize, usize) -> f64) -> Self {
        let strips: Vec<Strip> = lines.iter().flat_map(|line| line.strips.iter().copied()).collect();
        let count = strips.len();
        let modulus = PI * composite_modulus;
        let mut far = vec![0.0; count * count];
        let mut near = Vec::new();
        let rule = Rule::new();
        let mut first = 0;
        for line in lines {
            let own = first..first + line.strips.len();
            first = own.end;
            for i in own.clone() {
                for j in i..own.end {
                    let pair = [i - own.start, j - own.start];
                    let half_width = near_half_width(line, pair, composite_modulus);
                    let (close, sum) = interaction(line, pair, half_width);
                    (far[i * count + j], far[j * count + i]) = (sum, sum);
                    if !close.is_empty() {
                        near.push(Near::new(&rule, [i, j], close, half_width));
                    }
                }
            }
        }
        for i in 0..count {
            for j in 0..count {
                far[i * count + j] += modulus * body(i, j) * strips[i].length * strips[j].length;
            }
        }
        let shortest = strips.iter().map(|strip| strip.length).fold(f64::INFINITY, f64::min);
        Self {
            widths: strips.iter().map(|strip| 4.0 * strip.radius / modulus).collect(),
            lines: lines.iter().map(|line| line.strips.len()).collect(),
            strips,
            modulus,
            far,
            near,
            least: (1e-3 * shortest).powi(2),
        }
    }

    /// Returns the strips.
    pub fn strips(&self) -> &[Strip] {
        &self.strips
    }

    /// Computes the loads at the approaches of the strips, m: the displacement of both bodies
    /// towards each other less the relief, positive where undeformed bodies overlap. `None` without
    /// convergence.
    pub fn loads(&self, approaches: &[f64]) -> Option<StripLoads> {
        let mut loads = StripLoads::default();
        self.solve(approaches, &mut loads, &mut Work::default()).then_some(loads)
    }

    /// Computes the energy and its derivatives.
    pub(super) fn evaluate(&self, approaches: &[f64], at: &StripLoads, work: &mut Work) {
        let count = self.strips.len();
        let loads = &at.loads;
        work.direct.clone_from(&self.far);
        // Near pairs are the same at all loads, and all other entries stay zero.
        for matrix in [&mut work.slopes, &mut work.bends] {
            matrix.resize(count * count, 0.0);
        }
        for pair in &self.near {
            let (i, j) = (pair.first, pair.second);
            // Separated strips have no effect on each other.
            let separated = |strip: usize| loads[strip] == 0.0 && approaches[strip] <= 0.0;
            if separated(i) && loads[j] == 0.0 || separated(j) && loads[i] == 0.0 {
                continue;
            }
            let square = 0.5 * (at.squares[i] + at.squares[j]);
            let sums = pair.evaluate(square);
            let (upper, lower) = (i * count + j, j * count + i);
            let value = work.direct[upper] + sums[0];
            (work.direct[upper], work.direct[lower]) = (value, value);
            (work.slopes[upper], work.slopes[lower]) = (sums[1], sums[1]);
            (work.bends[upper], work.bends[lower]) = (sums[2], sums[2]);
        }
        work.energy = 0.0;
        work.gradient.clear();
        work.widening.clear();
        for (i, strip) in self.strips.iter().enumerate() {
            let row = i * count..(i + 1) * count;
            let deflection = product(&work.direct[row.clone()], loads);
            let share = strip.length / self.widths[i];
            let rigid = strip.length * self.modulus * approaches[i] - 0.5 * share * at.squares[i];
            work.energy += (0.5 * deflection - rigid) * loads[i];
            work.gradient.push(deflection - rigid);
            work.widening.push(product(&work.slopes[row], loads) + share);
        }
    }

    /// Finds the strips that carry load or would penetrate, and factors the second derivatives of
    /// the energy: T - T' M⁻¹ T' at half-widths that follow the loads.
    pub(super) fn factor(&self, at: &StripLoads, work: &mut Work) {
        let count = self.strips.len();
        let Work { gradient, widening, direct, slopes, bends, free, factor, widths, .. } = work;
        free.clear();
        free.extend((0..count).filter(|&i| at.loads[i] > 0.0 || gradient[i] < 0.0));
        let size = free.len();
        factor.clear();
        for &i in free.iter() {
            factor.extend(free.iter().map(|&j| direct[i * count + j]));
        }
        widths.resize_with(self.lines.len(), Widths::default);
        let (mut first, mut row_of_line) = (0, 0);
        for (line, length) in widths.iter_mut().zip(&self.lines) {
            let own = first..first + length;
            first = own.end;
            let rows: Vec<usize> = free.iter().copied().filter(|i| own.contains(i)).collect();
            line.free = rows.len();
            line.strips.clear();
            line.strips.extend(
                rows.iter()
                    .copied()
                    .filter(|&i| at.loads[i] > 0.0 && (at.squares[i] > self.least || widening[i] < 0.0)),
            );
            let inner = line.strips.len();
            line.factor.clear();
            for &i in &line.strips {
                let row = i * count..(i + 1) * count;
                let own = bends[i * count + i];
                let diagonal = own + product(&bends[row], &at.loads) / at.loads[i];
                line.factor.extend(
                    line.strips.iter().map(|&j| if i == j { diagonal } else { bends[i * count + j] }),
                );
            }
            line.rows.clear();
            if !cholesky(&mut line.factor, inner) {
                line.strips.clear();
                row_of_line += rows.len();
                continue;
            }
            for &i in &rows {
                let start = line.rows.len();
                line.rows.extend(line.strips.iter().map(|&j| slopes[i * count + j]));
                solve_lower(&line.factor, &mut line.rows[start..]);
            }
            for (k, row) in line.rows.chunks_exact(inner.max(1)).enumerate() {
                for (l, other) in line.rows.chunks_exact(inner.max(1)).enumerate().take(k + 1) {
                    factor[(row_of_line + k) * size + row_of_line + l] -= product(row, other);
                }
            }
            row_of_line += rows.len();
        }
        // Far from the solution the energy need not be convex.
        let matrix = factor.clone();
        let mut shift = 0.0;
        while !cholesky(factor, size) && shift < 1e3 {
            shift = 10.0 * f64::max(shift, 1e-3);
            factor.clone_from(&matrix);
            for k in 0..size {
                factor[k * size + k] += shift * direct[free[k] * (count + 1)];
            }
        }
    }

    /// Returns the potential energy of the contact, N m: the work of the loads at the approaches
    /// less the complementary energy.
    pub(crate) fn potential(&self, work: &Work) -> f64 {
        -work.energy / self.modulus
    }

    /// Returns π times the composite modulus, Pa.
    pub(super) fn modulus(&self) -> f64 {
        self.modulus
    }

    /// Returns columns of forces on the free strips divided by the Cholesky factor, one after the
    /// other.
    pub(super) fn columns<const N: usize>(
        &self,
        work: &Work,
        column: impl Fn(usize) -> [f64; N],
    ) -> Vec<f64> {
        let size = work.free.len();
        let mut rows = vec![0.0; N * size];
        for (k, &i) in work.free.iter().enumerate() {
            for (n, entry) in column(i).into_iter().enumerate() {
                rows[n * size + k] = self.strips[i].length * entry;
            }
        }
        for row in rows.chunks_exact_mut(size.max(1)) {
            solve_lower(&work.factor, row);
        }
        rows
    }

    /// Computes the derivatives of the sums of loads, weighted by the columns, with respect to
    /// approaches along the columns. `column` returns the columns of a strip. `work` is that of the
    /// solution.
    pub(crate) fn stiffness<const N: usize>(
        &self,
        at: &StripLoads,
        work: &mut Work,
        column: impl Fn(usize) -> [f64; N],
    ) -> [[f64; N]; N] {
        self.factor(at, work);
        let size = work.free.len();
        let rows = self.columns(work, column);
        let mut result = [[0.0; N]; N];
        for i in 0..N {
            for j in 0..=i {
                let sum = product(&rows[i * size..(i + 1) * size], &rows[j * size..(j + 1) * size]);
                (result[i][j], result[j][i]) = (self.modulus * sum, self.modulus * sum);
            }
        }
        result
    }
}

/// Returns the half-width of two strips of a line at [`LARGEST_PRESSURE`], m.
fn near_half_width(line: &Line, [i, j]: [usize; 2], composite_modulus: f64) -> f64 {
    2.0 * LARGEST_PRESSURE * line.strips[i].radius.max(line.strips[j].radius) / composite_modulus
}

/// Returns the interaction of two strips of a line: the integrals that depend on their half-widths,
/// and the sum of all others.
fn interaction(line: &Line, [i, j]: [usize; 2], half_width: f64) -> (Vec<Integral>, f64) {
    let (a, b) = (&line.strips[i], &line.strips[j]);
    let ends = |strip: &Strip| [strip.position - 0.5 * strip.length, strip.position + 0.5 * strip.length];
    // A quarter of the largest pressure is typical.
    let typical = (0.25 * half_width).powi(2);
    let mut near = Vec::new();
    let mut sum = 0.0;
    let mut add = |other: [f64; 2], weight: f64| {
        let distance = (a.position - 0.5 * (other[0] + other[1])).abs();
        let gap = distance - 0.5 * (a.length + b.length);
        let integral = Integral::new(ends(a), other, weight, gap < CLOSE * half_width);
        if gap < NEAR * half_width {
            near.push(integral);
        } else {
            sum += integral.evaluate(typical)[0];
        }
    };
    add(ends(b), 1.0);
    let [start, end] = ends(b);
    for Face { position, share } in &line.faces {
        add([2.0 * position - end, 2.0 * position - start], *share);
    }
    (near, sum)
}
