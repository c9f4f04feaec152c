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
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::vec3::{Vector, length, minus, plus, scaled};
use faer::c64;
use rayon::prelude::*;

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
