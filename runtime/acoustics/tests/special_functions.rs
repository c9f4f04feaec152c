//! Spherical Bessel functions, Legendre polynomials and series of spherical waves.

use faer::c64;

/// Spherical Hankel functions of the second kind h_n = j_n - i y_n from 0 to `most`.
///
/// The Bessel functions of the first kind come from downward recurrence (Miller), those of the
/// second kind from upward recurrence.
pub fn hankel(most: usize, x: f64) -> Vec<c64> {
    let start = most + 30 + x as usize;
    let mut first = vec![0.0; start + 2];
    first[start] = 1e-280;
    for n in (0..start).rev() {
        first[n] = (2 * n + 3) as f64 / x * first[n + 1] - first[n + 2];
        if first[n].abs() > 1e200 {
            first.iter_mut().for_each(|value| *value *= 1e-200);
        }
    }
    let scale =
        if x.sin().abs() > 0.1 { x.sin() / x / first[0] } else { (x.sin() / x - x.cos()) / x / first[1] };
    let mut second = vec![-x.cos() / x, (-x.cos() / x - x.sin()) / x];
    for n in 1..most.max(1) {
        second.push((2 * n + 1) as f64 / x * second[n] - second[n - 1]);
    }
    (0..=most).map(|n| c64::new(scale * first[n], -second[n])).collect()
}

/// Derivatives of [`hankel`], from 0 to `most`.
pub fn hankel_slopes(most: usize, x: f64) -> Vec<c64> {
    let h = hankel(most + 1, x);
    (0..=most).map(|n| h[n] * (n as f64 / x) - h[n + 1]).collect()
}

/// Legendre polynomials from 0 to `most`.
pub fn legendre(most: usize, x: f64) -> Vec<f64> {
    let mut values = vec![1.0, x];
    for n in 1..most {
        values.push(((2 * n + 1) as f64 * x * values[n] - n as f64 * values[n - 1]) / (n + 1) as f64);
    }
    values.truncate(most + 1);
    values
}

/// Quotient of numbers whose squares may exceed the range of numbers.
fn quotient(a: c64, b: c64) -> c64 {
    let size = b.norm();
    (a / size) / (b / size)
}

/// Pressure of a sphere of the radius a at the distance r and the polar angle with this cosine,
/// divided by ρc: the normal velocity is the sum of `coefficients` times Legendre polynomials.
pub fn sphere_pressure(coefficients: &[f64], wavenumber: f64, a: f64, r: f64, cosine: f64) -> c64 {
    let most = coefficients.len() - 1;
    let (h, slopes) = (hankel(most, wavenumber * r), hankel_slopes(most, wavenumber * a));
    let p = legendre(most, cosine);
    (0..=most).map(|n| c64::new(0.0, -coefficients[n] * p[n]) * quotient(h[n], slopes[n])).sum()
}

/// Power of this sphere, divided by ρc.
pub fn sphere_power(coefficients: &[f64], wavenumber: f64, a: f64) -> f64 {
    let most = coefficients.len() - 1;
    let x = wavenumber * a;
    let (h, slopes) = (hankel(most, x), hankel_slopes(most, x));
    let part = |n: usize| {
        let impedance = (c64::new(0.0, -1.0) * quotient(h[n], slopes[n])).re;
        0.5 * impedance * coefficients[n].powi(2) * 4.0 * std::f64::consts::PI * a * a / (2 * n + 1) as f64
    };
    (0..=most).map(part).sum()
}

/// Coefficients of a cap that moves with the unit normal velocity within a polar angle.
pub fn cap(half_angle: f64, most: usize) -> Vec<f64> {
    let p = legendre(most + 1, half_angle.cos());
    let coefficient = |n: usize| {
        if n == 0 { 0.5 * (1.0 - half_angle.cos()) } else { 0.5 * (p[n - 1] - p[n + 1]) }
    };
    (0..=most).map(coefficient).collect()
}

#[test]
fn hankel_functions_satisfy_the_wronskian() {
    for x in [0.1, 1.0, std::f64::consts::PI, 10.0] {
        let (h, slopes) = (hankel(8, x), hankel_slopes(8, x));
        for n in 0..=8 {
            // j y' - j' y = 1/x².
            let wronskian = h[n].re * -slopes[n].im - slopes[n].re * -h[n].im;
            assert!((wronskian * x * x - 1.0).abs() < 1e-9, "{x} {n}: {wronskian}");
        }
    }
}
