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
    Ok(triangle_powers(triangles, velocities, fluid, frequency, interrupt)?.iter().sum())
}

/// Returns the contribution of each triangle to [`power`], W: the integral over x is that over the
/// triangle.
///
/// # Errors
/// As [`pressures`].
pub fn triangle_powers(
    triangles: &[[Vector; 3]],
    velocities: &[c64],
    fluid: &Fluid,
    frequency: f64,
    interrupt: &Interrupt,
) -> Result<Vec<f64>, AcousticError> {
    let wavenumber = fluid.wavenumber(frequency)?;
    check_velocities(velocities, triangles.len(), 0)?;
    let samples = Samples::new(triangles);
    let flows: Vec<c64> =
        samples.weights.iter().map(|&(triangle, weight)| velocities[triangle] * weight).collect();
    let own = |(at, flow): (&Vector, &c64)| {
        interrupt.check()?;
        let parts = samples.points.iter().zip(&flows);
        Ok(parts.map(|(other, source)| (flow.conj() * source).re * kernel(wavenumber, *at, *other)).sum())
    };
    let found: Result<Vec<f64>, AcousticError> = samples.points.par_iter().zip(&flows).map(own).collect();
    let mut powers = vec![0.0; triangles.len()];
    for ((triangle, _), value) in samples.weights.iter().zip(found?) {
        powers[*triangle] += 0.5 * fluid.density * frequency * value;
    }
    Ok(powers)
}

/// Sample points of triangles. The kernel is smooth, so three points a triangle suffice at six
/// elements per wavelength.
struct Samples {
    points: Vec<Vector>,
    /// Triangle of each point, and the area that the point represents, m².
    weights: Vec<(usize, f64)>,
}

impl Samples {
    fn new(triangles: &[[Vector; 3]]) -> Samples {
        let rule = triangle_rule(3);
        let (mut points, mut weights) = (Vec::new(), Vec::new());
        for (index, corners) in triangles.iter().enumerate() {
            let area = Panel::separate(*corners).area;
            let [a, b, c] = *corners;
            for ([p, q, r], weight) in &rule {
                points.push(plus(plus(scaled(a, *p), scaled(b, *q)), scaled(c, *r)));
                weights.push((index, area * weight));
            }
        }
        Samples { points, weights }
    }
}

/// Returns sin(kr)/r of the distance of two points.
fn kernel(wavenumber: f64, at: Vector, other: Vector) -> f64 {
    let distance = length(minus(at, other));
    let phase = wavenumber * distance;
    if phase < 1e-4 { wavenumber } else { phase.sin() / distance }
}

/// Returns the radiation impedances of panels for real velocity patterns; that of one panel with
/// all triangles has the power of [`power`]. A pattern has the normal velocities of the triangles,
/// m/s, and a panel has the share of each triangle that belongs to it. Impedances of panels sum to
/// that of the surface.
///
/// # Errors
/// As [`power`], or the caller refuses the memory.
pub fn panel_impedances(
    triangles: &[[Vector; 3]],
    patterns: &[Vec<f64>],
    panels: &[Vec<f64>],
    (fluid, frequency): (&Fluid, f64),
    interrupt: &Interrupt,
) -> Result<Vec<RadiationImpedance>, AcousticError> {
    let wavenumber = fluid.wavenumber(frequency)?;
    for (case, pattern) in patterns.iter().enumerate() {
        let velocities: Vec<c64> = pattern.iter().map(|value| c64::new(*value, 0.0)).collect();
        check_velocities(&velocities, triangles.len(), case)?;
    }
    let Samples { points, weights } = Samples::new(triangles);
    let (count, size) = (points.len(), patterns.len());
    let blocks = count.div_ceil(ROWS);
    let threads = rayon::current_num_threads();
    let bytes =
        8 * (count * size + threads * ROWS * (count + 2 * size) + blocks * panels.len() * size * size);
    let _room = interrupt.reserve_memory(bytes as u64)?;
    let flows = Mat::from_fn(count, size, |point, pattern| {
        let (triangle, weight) = weights[point];
        patterns[pattern][triangle] * weight
    });
    let multiply = |out: faer::MatMut<'_, f64>, a: faer::MatRef<'_, f64>, b: faer::MatRef<'_, f64>| {
        matmul(out, Accum::Replace, a, b, 1.0, Par::Seq);
    };
    let block = |block: usize| -> Result<Vec<Option<Mat<f64>>>, AcousticError> {
        interrupt.check()?;
        let first = block * ROWS;
        let rows = ROWS.min(count - first);
        let kernel =
            Mat::from_fn(rows, count, |row, column| kernel(wavenumber, points[first + row], points[column]));
        let mut product = Mat::zeros(rows, size);
        multiply(product.as_mut(), kernel.as_ref(), flows.as_ref());
        let form = |panel: &Vec<f64>| {
            let share = |row: usize| panel[weights[first + row].0];
            (0..rows).any(|row| share(row) != 0.0).then(|| {
                let own = Mat::from_fn(rows, size, |row, pattern| flows[(first + row, pattern)] * share(row));
                let mut form = Mat::zeros(size, size);
                multiply(form.as_mut(), own.transpose(), product.as_ref());
                form
            })
        };
        Ok(panels.iter().map(form).collect())
    };
    let forms: Vec<Vec<Option<Mat<f64>>>> =
        (0..blocks).into_par_iter().map(block).collect::<Result<_, _>>()?;
    let factor = fluid.density * frequency;
    let impedance = |panel: usize| {
        let mut sum = Mat::<f64>::zeros(size, size);
        forms.iter().filter_map(|block| block[panel].as_ref()).for_each(|form| sum += form);
        let entry = |i: usize, j: usize| c64::new(0.5 * factor * (sum[(i, j)] + sum[(j, i)]), 0.0);
        RadiationImpedance::new(frequency, Mat::from_fn(size, size, entry))
    };
    Ok((0..panels.len()).map(impedance).collect())
}
