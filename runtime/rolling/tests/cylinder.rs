//! Elastic cylinder with free ends under a line load: an independent computation of the table of
//! the roller's body.
//!
//! Displacements are Fourier series around the axis with Legendre polynomials of radius and
//! position, and minimize the potential energy (Ritz). The load is a Gaussian distribution around
//! the line, and both the deflection of the cylinder and that of a half-space with the images of
//! the load in both ends are averages with this distribution. Uniform acceleration balances loads
//! that are not in equilibrium. The radius and Young's modulus are 1.

use calyx_numerics::quadrature::gauss_legendre;
use std::f64::consts::PI;

const POISSON: f64 = 0.3;
/// Standard deviation of the load around the line.
const WIDTH: f64 = 0.06;
/// Largest number of Legendre polynomials of the load.
const ORDERS: usize = 8;

/// Matrix by rows.
#[derive(Clone)]
struct Matrix(usize, Vec<f64>);

impl Matrix {
    fn zero(size: usize) -> Self {
        Self(size, vec![0.0; size * size])
    }

    fn at(&self, i: usize, j: usize) -> f64 {
        self.1[i * self.0 + j]
    }

    fn add(&mut self, i: usize, j: usize, value: f64) {
        self.1[i * self.0 + j] += value;
    }

    fn times(&self, x: &[f64]) -> Vec<f64> {
        self.1.chunks_exact(self.0).map(|row| dot(row, x)).collect()
    }

    /// Solves by Cholesky's method.
    fn solve(mut self, rights: &mut [Vec<f64>]) {
        let n = self.0;
        for i in 0..n {
            let (above, row) = self.1.split_at_mut(i * n);
            for j in 0..i {
                let other = &above[j * n..(j + 1) * n];
                row[j] = (row[j] - dot(&row[..j], &other[..j])) / other[j];
            }
            row[i] = (row[i] - dot(&row[..i], &row[..i])).sqrt();
        }
        for right in rights {
            for i in 0..n {
                right[i] = (right[i] - dot(&self.1[i * n..i * n + i], &right[..i])) / self.at(i, i);
            }
            for i in (0..n).rev() {
                right[i] /= self.at(i, i);
                for j in 0..i {
                    right[j] -= self.at(i, j) * right[i];
                }
            }
        }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// Legendre polynomials and their derivatives.
fn legendre(count: usize, x: f64) -> (Vec<f64>, Vec<f64>) {
    let (mut values, mut slopes) = (vec![1.0, x], vec![0.0, 1.0]);
    for k in 2..count.max(2) {
        let n = k as f64;
        values.push(((2.0 * n - 1.0) * x * values[k - 1] - (n - 1.0) * values[k - 2]) / n);
        slopes.push(slopes[k - 2] + (2.0 * n - 1.0) * values[k - 1]);
    }
    (values, slopes)
}

/// Coefficients of Legendre polynomials of the body: those of a load on the same line less those of
/// the half-space with images, and those of the opposite line. `ratio` is that of length and
/// diameter.
pub fn coefficients(ratio: f64, radial: usize, axial: usize) -> [[[f64; ORDERS]; ORDERS]; 2] {
    let length = 2.0 * ratio;
    let [same, opposite] = cylinder(length, radial, axial);
    let half_space = half_space(length);
    let plane = 1.0 / (1.0 - POISSON * POISSON);
    let mut result = [[[0.0; ORDERS]; ORDERS]; 2];
    for i in 0..ORDERS {
        for j in 0..ORDERS {
            let unit = ((2 * i + 1) * (2 * j + 1)) as f64 / length;
            result[0][i][j] = unit * (PI * plane * same[i][j] - half_space[i][j]);
            result[1][i][j] = unit * PI * plane * opposite[i][j];
        }
    }
    result
}

/// Integrals of the products of the basis functions of one harmonic along the radius or the axis.
struct Products {
    /// Values and slopes at the points, and the weights of the points.
    points: Vec<(Vec<f64>, Vec<f64>, f64)>,
}

impl Products {
    fn of(&self, weight: impl Fn(usize) -> f64, first: bool, second: bool, i: usize, j: usize) -> f64 {
        let side = |point: &(Vec<f64>, Vec<f64>, f64), slope: bool, k: usize| {
            if slope { point.1[k] } else { point.0[k] }
        };
        let term = |(k, point): (usize, &(Vec<f64>, Vec<f64>, f64))| {
            point.2 * weight(k) * side(point, first, i) * side(point, second, j)
        };
        self.points.iter().enumerate().map(term).sum()
    }
}

type Square = [[f64; ORDERS]; ORDERS];

/// Lamé's constants: shear modulus and λ.
const SHEAR: f64 = 0.5 / (1.0 + POISSON);
const LAME: f64 = POISSON / ((1.0 + POISSON) * (1.0 - 2.0 * POISSON));

/// Integrals of products of polynomials along the radius, with powers of the radius as weight, and
/// along the axis. `left` has the slope of the first factor.
struct Integrals {
    mass: Matrix,
    stiff: Matrix,
    inverse: Matrix,
    plain: Matrix,
    left: Matrix,
    left_mass: Matrix,
    z_mass: Matrix,
    z_stiff: Matrix,
    z_left: Matrix,
}

fn integrals(length: f64, radial: usize, axial: usize) -> Integrals {
    let radii: Vec<(f64, f64)> =
        gauss_legendre(radial + 6).into_iter().map(|(x, w)| (0.5 * (x + 1.0), 0.5 * w)).collect();
    let rule = |count: usize, points: Vec<(f64, f64)>, scale: f64| Products {
        points: points
            .into_iter()
            .map(|(x, weight)| {
                let (values, slopes) = legendre(count, x);
                (values, slopes.into_iter().map(|slope| scale * slope).collect(), weight)
            })
            .collect(),
    };
    let along_radius = rule(radial, radii.iter().map(|(r, w)| (2.0 * r - 1.0, *w)).collect(), 2.0);
    let points = gauss_legendre(axial + 6).into_iter().map(|(x, w)| (x, 0.5 * length * w)).collect();
    let along_axis = rule(axial, points, 2.0 / length);
    let table = |products: &Products, count: usize, weight: &dyn Fn(usize) -> f64, first, second| {
        let mut matrix = Matrix::zero(count);
        for i in 0..count {
            for j in 0..count {
                matrix.add(i, j, products.of(weight, first, second, i, j));
            }
        }
        matrix
    };
    let r = |k: usize| radii[k].0;
    let radius =
        |power: i32, first, second| table(&along_radius, radial, &|k| r(k).powi(power), first, second);
    let axis = |first, second| table(&along_axis, axial, &|_| 1.0, first, second);
    let [mass, stiff, inverse] = [radius(1, false, false), radius(1, true, true), radius(-1, false, false)];
    let (plain, left) = (radius(0, false, false), radius(0, true, false));
    let left_mass = radius(1, true, false);
    let (z_mass, z_stiff, z_left) = (axis(false, false), axis(true, true), axis(true, false));
    Integrals { mass, stiff, inverse, plain, left, left_mass, z_mass, z_stiff, z_left }
}

/// Assembles stiffness and inertia of a harmonic; displacements along the radius, around and along
/// the axis begin at `starts`, with the orders `even` and `odd` along the axis.
fn assemble(
    integrals: &Integrals,
    n: f64,
    [even, odd]: [&[usize]; 2],
    starts: [usize; 3],
    size: usize,
) -> [Matrix; 2] {
    let Integrals { mass, stiff, inverse, plain, left, left_mass, z_mass, z_stiff, z_left } = integrals;
    let (shear, lame, radial) = (SHEAR, LAME, mass.0);
    let mut stiffness = Matrix::zero(size);
    let mut inertia = Matrix::zero(size);
    for a in 0..radial {
        for b in 0..radial {
            for (p, &i) in even.iter().enumerate() {
                for (q, &j) in even.iter().enumerate() {
                    let (zz, dd) = (z_mass.at(i, j), z_stiff.at(i, j));
                    let (l, lt) = (left.at(a, b), left.at(b, a));
                    let (inv, m) = (inverse.at(a, b), mass.at(a, b));
                    let full = lame + 2.0 * shear;
                    let uu = full * (stiff.at(a, b) + inv) + lame * (l + lt) + shear * n * n * inv;
                    let uv = n * (lame * (l + inv) + 2.0 * shear * inv - shear * (lt - inv));
                    let vv = full * n * n * inv + shear * (stiff.at(a, b) - l - lt + inv);
                    let (row, column) = (a * even.len() + p, b * even.len() + q);
                    stiffness.add(row, column, uu * zz + shear * m * dd);
                    stiffness.add(row, starts[1] + column, uv * zz);
                    stiffness.add(starts[1] + column, row, uv * zz);
                    stiffness.add(starts[1] + row, starts[1] + column, vv * zz + shear * m * dd);
                    inertia.add(row, column, m * zz);
                    inertia.add(starts[1] + row, starts[1] + column, m * zz);
                }
                for (q, &j) in odd.iter().enumerate() {
                    // Values with slopes, and slopes with values along the axis.
                    let (forward, back) = (z_left.at(j, i), z_left.at(i, j));
                    let uw = lame * (left_mass.at(a, b) + plain.at(a, b)) * forward
                        + shear * left_mass.at(b, a) * back;
                    let vw = n * plain.at(a, b) * (lame * forward - shear * back);
                    let column = starts[2] + b * odd.len() + q;
                    let row = a * even.len() + p;
                    for (row, value) in [(row, uw), (starts[1] + row, vw)] {
                        stiffness.add(row, column, value);
                        stiffness.add(column, row, value);
                    }
                }
            }
            for (p, &i) in odd.iter().enumerate() {
                for (q, &j) in odd.iter().enumerate() {
                    let full = lame + 2.0 * shear;
                    let (row, column) = (starts[2] + a * odd.len() + p, starts[2] + b * odd.len() + q);
                    let strain = shear * (stiff.at(a, b) + n * n * inverse.at(a, b));
                    let value = full * mass.at(a, b) * z_stiff.at(i, j) + strain * z_mass.at(i, j);
                    stiffness.add(row, column, value);
                    inertia.add(row, column, mass.at(a, b) * z_mass.at(i, j));
                }
            }
        }
    }
    [stiffness, inertia]
}

fn cylinder(length: f64, radial: usize, axial: usize) -> [Square; 2] {
    let integrals = integrals(length, radial, axial);
    let z_mass = &integrals.z_mass;
    let mut sums = [[[0.0; ORDERS]; ORDERS]; 2];
    for harmonic in 0..=(5.0 / WIDTH) as usize {
        let n = harmonic as f64;
        for parity in 0..2 {
            let even: Vec<usize> = (parity..axial).step_by(2).collect();
            let odd: Vec<usize> = (1 - parity..axial).step_by(2).collect();
            // Displacements: radial, around the axis, along the axis.
            let starts = [0, radial * even.len(), 2 * radial * even.len()];
            let size = starts[2] + radial * odd.len();
            let [mut stiffness, inertia] = assemble(&integrals, n, [&even, &odd], starts, size);
            let full_turn = if harmonic == 0 { 2.0 * PI } else { PI };
            let trace = (0..size).map(|k| stiffness.at(k, k)).sum::<f64>() / size as f64;
            if harmonic == 0 {
                // Torsion is not loaded.
                for k in starts[1]..starts[2] {
                    stiffness.add(k, k, trace);
                }
            }
            let orders: Vec<usize> = (parity..ORDERS).step_by(2).collect();
            let smooth = (-0.5 * (n * WIDTH).powi(2)).exp();
            let loads: Vec<Vec<f64>> = orders
                .iter()
                .map(|&order| {
                    let mut load = vec![0.0; size];
                    for a in 0..radial {
                        for (p, &i) in even.iter().enumerate() {
                            load[a * even.len() + p] = smooth * z_mass.at(order, i);
                        }
                    }
                    load
                })
                .collect();
            // Rigid translation across the axis, tilt, and translation along the axis; polynomials
            // in 2 r - 1 have r = (1 + P₁)/2.
            let mut rigid = vec![0.0; size];
            let has_rigid = harmonic == 1 || harmonic == 0 && parity == 1;
            if harmonic == 1 {
                let lever = if parity == 0 { 1.0 } else { 0.5 * length };
                (rigid[0], rigid[starts[1]]) = (lever, -lever);
                if parity == 1 {
                    (rigid[starts[2]], rigid[starts[2] + odd.len()]) = (-0.5, -0.5);
                }
            } else if has_rigid {
                rigid[starts[2]] = 1.0;
            }
            let force = inertia.times(&rigid);
            let whole = dot(&force, &rigid);
            let mut solutions = loads.clone();
            if has_rigid {
                for solution in &mut solutions {
                    let share = dot(solution, &rigid) / whole;
                    solution.iter_mut().zip(&force).for_each(|(entry, force)| *entry -= share * force);
                }
                let unit = trace / dot(&force, &force);
                for i in 0..size {
                    for j in 0..size {
                        stiffness.add(i, j, unit * force[i] * force[j]);
                    }
                }
            }
            stiffness.solve(&mut solutions);
            for solution in &mut solutions {
                if has_rigid {
                    let share = dot(solution, &force) / whole;
                    solution.iter_mut().zip(&rigid).for_each(|(entry, rigid)| *entry -= share * rigid);
                }
            }
            for (load, &i) in loads.iter().zip(&orders) {
                for (solution, &j) in solutions.iter().zip(&orders) {
                    let value = dot(load, solution) / full_turn;
                    sums[0][i][j] += value;
                    sums[1][i][j] += if harmonic % 2 == 0 { value } else { -value };
                }
            }
        }
    }
    sums
}

/// Mean of 1/√(d² + s²) with the difference s of two positions around the line.
fn kernel(distance: f64) -> f64 {
    let deviation = WIDTH * 2f64.sqrt();
    let ratio = 0.5 * (distance / deviation).powi(2);
    // The integrand is a bell of this width, or wider.
    let step = (0.3 / (2.0 * ratio).sqrt()).min(0.05);
    let term = |k: usize| (-ratio * (step * k as f64).sinh().powi(2)).exp();
    let mut sum = 0.5;
    for k in 1.. {
        let next = term(k);
        sum += next;
        if next < 1e-18 {
            break;
        }
    }
    2.0 * step * sum / (deviation * (2.0 * PI).sqrt())
}

/// Double integrals of Legendre polynomials with the kernel, and with its images in both ends.
fn half_space(length: f64) -> Square {
    let rule = gauss_legendre(16);
    let inner = gauss_legendre(20);
    let mut result = [[0.0; ORDERS]; ORDERS];
    // Distances by doubling intervals.
    let mut bounds = vec![0.0];
    bounds.extend((0..17).rev().map(|k| length * 0.5f64.powi(k)));
    bounds.push(2.0 * length);
    for ends in bounds.windows(2) {
        for (x, weight) in &rule {
            let distance = 0.5 * (ends[0] + ends[1] + (ends[1] - ends[0]) * x);
            let value = 0.5 * (ends[1] - ends[0]) * weight * kernel(distance);
            let mut add = |from: f64, to: f64, image: bool| {
                for (x, weight) in &inner {
                    let at = 0.5 * (from + to + (to - from) * x);
                    let other = if image { length - distance - at } else { at - distance };
                    let own = legendre(ORDERS, 2.0 * at / length).0;
                    let others = legendre(ORDERS, 2.0 * other / length).0;
                    let value = value * 0.5 * (to - from) * weight;
                    for i in 0..ORDERS {
                        for j in 0..ORDERS {
                            let mirrored = if (i + j) % 2 == 0 { 1.0 } else { 0.0 };
                            let factor = if image { 1.0 + mirrored - (1.0 - mirrored) } else { 1.0 };
                            result[i][j] += factor * value * own[i] * others[j];
                            if !image {
                                result[j][i] += value * own[i] * others[j];
                            }
                        }
                    }
                }
            };
            if distance < length {
                add(distance - 0.5 * length, 0.5 * length, false);
            }
            add(
                (0.5 * length - distance).max(-0.5 * length),
                (1.5 * length - distance).min(0.5 * length),
                true,
            );
        }
    }
    result
}

/// A coarse solution has the low orders of the table within 0.005, a thousandth of the compliance
/// of the cylinder.
#[test]
fn table_of_the_body_agrees_with_a_coarse_solution() {
    let table = include_str!("../src/roller/body.csv");
    let row: Vec<f64> =
        table.lines().nth(3).expect("row").split(',').map(|entry| entry.parse().expect("number")).collect();
    let found = coefficients(row[0], 12, 14);
    let mut column = 1;
    for line in found {
        for parity in 0..2 {
            for i in (parity..ORDERS).step_by(2) {
                for j in (parity..=i).step_by(2) {
                    if i < 4 {
                        let (value, expected) = (line[i][j], row[column]);
                        assert!((value - expected).abs() < 5e-3, "{i} {j}: {value} instead of {expected}");
                    }
                    column += 1;
                }
            }
        }
    }
}

/// Prints the table of the body, and the largest difference of each row from the one in use.
#[test]
#[ignore = "takes minutes: for changes of the table"]
fn print_the_table_of_the_body() {
    for line in include_str!("../src/roller/body.csv").lines() {
        let row: Vec<f64> = line.split(',').map(|entry| entry.parse().expect("number")).collect();
        let mut values = vec![row[0]];
        for of_line in coefficients(row[0], 18, 28) {
            for parity in 0..2 {
                for i in (parity..ORDERS).step_by(2) {
                    values.extend((parity..=i).step_by(2).map(|j| of_line[i][j]));
                }
            }
        }
        let scale = row.iter().fold(1.0f64, |most, entry| most.max(entry.abs()));
        let worst = values.iter().zip(&row).map(|(a, b)| (a - b).abs() / scale).fold(0.0, f64::max);
        println!("{}", values.iter().map(f64::to_string).collect::<Vec<_>>().join(","));
        println!("  largest difference {worst:.1e} of the largest coefficient");
    }
}
