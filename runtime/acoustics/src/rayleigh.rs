//! Rayleigh integral: sound of a plane source in a rigid baffle.
//!
//! On other surfaces, every element radiates as if it were in a plane baffle of its own. Shading
//! and diffraction by the body are omitted.

use crate::error::AcousticError;
use crate::fluid::Fluid;
use crate::model::check_velocities;
use crate::panel::Panel;
use crate::point::PointQuadrature;
use crate::quadrature::triangle_rule;
use crate::transfer::RadiationImpedance;
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::vec3::{Vector, length, minus, plus, scaled};
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, Par, c64};
use rayon::prelude::*;

/// Number of rows of the kernel that are computed at a time.
const ROWS: usize = 64;

/// Returns the pressures at points in front of a source, Pa: p = 2iωρ ∫ v G dS. The source is given
/// by the corners of its triangles, m, and their normal velocities, m/s.
///
/// # Errors
/// The frequency or fluid is out of range, the number of velocities differs from that of the
/// triangles, or the caller interrupts.
pub fn pressures(
    triangles: &[[Vector; 3]],
    velocities: &[c64],
    fluid: &Fluid,
    frequency: f64,
    points: &[Vector],
    interrupt: &Interrupt,
) -> Result<Vec<c64>, AcousticError> {
    let wavenumber = fluid.wavenumber(frequency)?;
    check_velocities(velocities, triangles.len(), 0)?;
    let panels: Vec<Panel> = triangles.iter().map(|corners| Panel::separate(*corners)).collect();
    let quadrature = PointQuadrature::new();
    let factor = c64::new(0.0, 2.0 * std::f64::consts::TAU * frequency * fluid.density);
    let at = |point: &Vector| {
        interrupt.check()?;
        let part = |(panel, velocity): (&Panel, &c64)| {
            quadrature.moments(wavenumber, *point, panel).single * velocity
        };
        Ok(factor * panels.iter().zip(velocities).map(part).sum::<c64>())
    };
    points.par_iter().map(at).collect()
}

/// Returns the power of a plane source in a baffle, W:
/// P = ωρ/(4π) ∬ Re(v*(x) v(y)) sin(kr)/r dS dS. Arguments as for [`pressures`].
///
/// # Errors
/// As [`pressures`].
pub fn power(
    triangles: &[[Vector; 3]],
    velocities: &[c64],
    fluid: &Fluid,
    frequency: f64,
    interrupt: &Interrupt,
) -> Result<f64, AcousticError> {
    let wavenumber = fluid.wavenumber(frequency)?;
    check_velocities(velocities, triangles.len(), 0)?;
    // The kernel is smooth, so three points a triangle suffice at six elements per wavelength.
    let rule = triangle_rule(3);
    let points: Vec<(Vector, c64)> = triangles
        .iter()
        .zip(velocities)
        .flat_map(|(corners, velocity)| {
            let area = Panel::separate(*corners).area;
            let [a, b, c] = *corners;
            rule.iter().map(move |([p, q, r], weight)| {
                (plus(plus(scaled(a, *p), scaled(b, *q)), scaled(c, *r)), velocity * (area * weight))
            })
        })
        .collect();
    let row = |(index, (at, own)): (usize, &(Vector, c64))| {
        interrupt.check()?;
        let mut sum = 0.5 * wavenumber * own.norm_sqr();
        for (other, flow) in &points[index + 1..] {
            let distance = length(minus(*at, *other));
            let phase = wavenumber * distance;
            let kernel = if phase < 1e-4 { wavenumber } else { phase.sin() / distance };
            sum += (own.conj() * flow).re * kernel;
        }
        Ok(sum)
    };
    let rows: Result<Vec<f64>, AcousticError> = points.par_iter().enumerate().map(row).collect();
    Ok(fluid.density * frequency * rows?.iter().sum::<f64>())
}

/// Returns the radiation impedance of real velocity patterns, whose power is that of [`power`]: a
/// pattern has the normal velocities of the triangles, m/s.
///
/// # Errors
/// As [`power`], or the caller refuses the memory.
pub fn radiation_impedance(
    triangles: &[[Vector; 3]],
    patterns: &[Vec<f64>],
    fluid: &Fluid,
    frequency: f64,
    interrupt: &Interrupt,
) -> Result<RadiationImpedance, AcousticError> {
    let wavenumber = fluid.wavenumber(frequency)?;
    for (case, pattern) in patterns.iter().enumerate() {
        let velocities: Vec<c64> = pattern.iter().map(|value| c64::new(*value, 0.0)).collect();
        check_velocities(&velocities, triangles.len(), case)?;
    }
    let rule = triangle_rule(3);
    let mut points: Vec<Vector> = Vec::with_capacity(3 * triangles.len());
    let mut weights: Vec<(usize, f64)> = Vec::with_capacity(3 * triangles.len());
    for (index, corners) in triangles.iter().enumerate() {
        let area = Panel::separate(*corners).area;
        let [a, b, c] = *corners;
        for ([p, q, r], weight) in &rule {
            points.push(plus(plus(scaled(a, *p), scaled(b, *q)), scaled(c, *r)));
            weights.push((index, area * weight));
        }
    }
    let (count, size) = (points.len(), patterns.len());
    let blocks = count.div_ceil(ROWS);
    let threads = rayon::current_num_threads();
    let bytes = 8 * (count * size + threads * ROWS * (count + size) + blocks * size * size);
    let _room = interrupt.reserve_memory(bytes as u64)?;
    let flows = Mat::from_fn(count, size, |point, pattern| {
        let (triangle, weight) = weights[point];
        patterns[pattern][triangle] * weight
    });
    let block = |block: usize| -> Result<Mat<f64>, AcousticError> {
        interrupt.check()?;
        let first = block * ROWS;
        let rows = ROWS.min(count - first);
        let kernel = Mat::from_fn(rows, count, |row, column| {
            let distance = length(minus(points[first + row], points[column]));
            let phase = wavenumber * distance;
            if phase < 1e-4 { wavenumber } else { phase.sin() / distance }
        });
        let (mut product, mut form) = (Mat::zeros(rows, size), Mat::zeros(size, size));
        let multiply = |out: faer::MatMut<'_, f64>, a: faer::MatRef<'_, f64>, b: faer::MatRef<'_, f64>| {
            matmul(out, Accum::Replace, a, b, 1.0, Par::Seq);
        };
        multiply(product.as_mut(), kernel.as_ref(), flows.as_ref());
        multiply(form.as_mut(), flows.as_ref().subrows(first, rows).transpose(), product.as_ref());
        Ok(form)
    };
    let forms: Vec<Mat<f64>> = (0..blocks).into_par_iter().map(block).collect::<Result<_, _>>()?;
    let factor = fluid.density * frequency;
    let entry = |i: usize, j: usize| factor * forms.iter().map(|form| form[(i, j)]).sum::<f64>();
    let impedance = Mat::from_fn(size, size, |i, j| c64::new(0.5 * (entry(i, j) + entry(j, i)), 0.0));
    Ok(RadiationImpedance::new(frequency, impedance))
}
