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
use calyx_numerics::vec3::{Vector, plus, scaled};
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, Par, c64};
use rayon::prelude::*;
use wide::f64x4;

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
    let kernel = Kernel::new(triangles, fluid.wavenumber(frequency)?);
    check_velocities(velocities, triangles.len(), 0)?;
    let own = |(triangle, velocity): (usize, &c64)| {
        interrupt.check()?;
        let part =
            |(other, source): (usize, &c64)| (velocity.conj() * source).re * kernel.integral(triangle, other);
        let sum: f64 = velocities.iter().enumerate().map(part).sum();
        Ok(0.5 * fluid.density * frequency * sum)
    };
    velocities.par_iter().enumerate().map(own).collect()
}

/// Kernel sin(kr)/r at sample points of triangles. It is smooth, so three points a triangle suffice
/// at six elements per wavelength.
struct Kernel {
    wavenumber: f64,
    /// Points of each triangle, m, and the area that each represents, m².
    points: Vec<([Vector; 3], f64)>,
    /// The same, with a fourth point of no area.
    packed: Vec<([f64x4; 3], f64x4)>,
}

/// Least product of wavenumber and distance: shorter distances change the kernel by 2e-9.
const LEAST_PHASE: f64 = 1e-4;

impl Kernel {
    fn new(triangles: &[[Vector; 3]], wavenumber: f64) -> Kernel {
        let rule = triangle_rule(3);
        let point = |[a, b, c]: [Vector; 3], k: usize| {
            let [p, q, r] = rule[k].0;
            plus(plus(scaled(a, p), scaled(b, q)), scaled(c, r))
        };
        // The three points have equal weights.
        let points: Vec<([Vector; 3], f64)> = triangles
            .iter()
            .map(|corners| ([0, 1, 2].map(|k| point(*corners, k)), Panel::separate(*corners).area / 3.0))
            .collect();
        let packed = points
            .iter()
            .map(|([a, b, c], area)| {
                let coordinates =
                    [0, 1, 2].map(|axis: usize| f64x4::from([a[axis], b[axis], c[axis], a[axis]]));
                (coordinates, f64x4::from([*area, *area, *area, 0.0]))
            })
            .collect();
        Kernel { wavenumber, points, packed }
    }

    /// Returns the integral over two triangles, m³.
    fn integral(&self, one: usize, other: usize) -> f64 {
        let (points, area) = &self.points[one];
        let (coordinates, areas) = &self.packed[other];
        let least = f64x4::splat(LEAST_PHASE / self.wavenumber);
        let mut sum = f64x4::splat(0.0);
        for at in points {
            let [x, y, z] = [0, 1, 2].map(|axis: usize| coordinates[axis] - f64x4::splat(at[axis]));
            let distance = (x * x + y * y + z * z).sqrt().max(least);
            sum += (distance * f64x4::splat(self.wavenumber)).sin() / distance;
        }
        area * (sum * *areas).reduce_add()
    }
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
    let kernel = Kernel::new(triangles, fluid.wavenumber(frequency)?);
    for (case, pattern) in patterns.iter().enumerate() {
        let velocities: Vec<c64> = pattern.iter().map(|value| c64::new(*value, 0.0)).collect();
        check_velocities(&velocities, triangles.len(), case)?;
    }
    let (count, size) = (triangles.len(), patterns.len());
    let blocks = count.div_ceil(ROWS);
    let threads = rayon::current_num_threads();
    let bytes =
        8 * (count * size + threads * ROWS * (count + 2 * size) + blocks * panels.len() * size * size);
    let _room = interrupt.reserve_memory(bytes as u64)?;
    let velocities = Mat::from_fn(count, size, |triangle, pattern| patterns[pattern][triangle]);
    let multiply = |out: faer::MatMut<'_, f64>, a: faer::MatRef<'_, f64>, b: faer::MatRef<'_, f64>| {
        matmul(out, Accum::Replace, a, b, 1.0, Par::Seq);
    };
    let block = |block: usize| -> Result<Vec<Option<Mat<f64>>>, AcousticError> {
        interrupt.check()?;
        let first = block * ROWS;
        let rows = ROWS.min(count - first);
        let kernel = Mat::from_fn(rows, count, |row, column| kernel.integral(first + row, column));
        let mut product = Mat::zeros(rows, size);
        multiply(product.as_mut(), kernel.as_ref(), velocities.as_ref());
        let form = |panel: &Vec<f64>| {
            let shares = &panel[first..first + rows];
            shares.iter().any(|share| *share != 0.0).then(|| {
                let own =
                    Mat::from_fn(rows, size, |row, pattern| velocities[(first + row, pattern)] * shares[row]);
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
