//! Stiffness and mass of shell elements with six degrees of freedom per node.

use super::assumed::{Ties, points, ties};
use super::geometry::{Prepared, ShellElement};
use super::interpolation::{Weighted, square_bubble, square_rule, triangle_rule};
use super::kinematics::{
    Basis, SHEAR_FACTOR, STRAINS, area, contravariant, conversion, elasticity_root, is_positive, lamina,
    squared, volume,
};
use crate::error::ElementError;
use crate::model::ShellShape;
use calyx_numerics::quadrature::gauss_legendre;
use calyx_numerics::vec3::{cross, length, scaled};
use nalgebra::{Cholesky, DMatrix, DVector, Matrix5, SMatrix};

/// Number of enhanced strains of the four-node quadrilateral.
const ENHANCED: usize = 4;

/// Returns the stiffness over six components per node in basic axes (N/m, N, N m).
///
/// # Errors
/// The element is degenerate, folded, or has impossible properties.
pub fn stiffness(element: &ShellElement<'_>) -> Result<DMatrix<f64>, ElementError> {
    let prepared = element.prepared()?;
    let root = elasticity_root(element.material)?;
    let rule = stiffness_rule(element.shape);
    let enhanced = if element.shape == ShellShape::Quadrilateral4 { ENHANCED } else { 0 };
    let nodes = 6 * element.positions.len();
    let internal = prepared.internal.ncols() + enhanced;

    let strains = strain_rows(&prepared, &rule, &root, enhanced)?;
    let drilling = drilling_rows(&prepared, &rule, element.material.shear_modulus, enhanced);
    let bubble = bubble_row(&prepared, &rule, element.material.shear_modulus);
    let parts = [strains, drilling, bubble];
    let mut rows = DMatrix::zeros(parts.iter().map(DMatrix::nrows).sum(), nodes + internal);
    let mut first = 0;
    for part in &parts {
        rows.view_mut((first, 0), part.shape()).copy_from(part);
        first += part.nrows();
    }
    condensed(squared(&rows), nodes)
}

/// Returns the consistent mass over six components per node in basic axes (kg, kg m, kg m^2), with
/// rotary inertia.
///
/// # Errors
/// As for [`stiffness`].
pub fn mass(element: &ShellElement<'_>) -> Result<DMatrix<f64>, ElementError> {
    let prepared = element.prepared()?;
    let nodes = element.positions.len();
    let across = gauss_legendre(2);
    // (u + zeta w)^2 of straight elements of linear thickness is integrated exactly.
    let rule = match element.shape {
        ShellShape::Triangle3 => triangle_rule(4),
        ShellShape::Triangle6 => triangle_rule(7),
        ShellShape::Quadrilateral4 => square_rule(3),
        ShellShape::Quadrilateral8 | ShellShape::Quadrilateral9 => square_rule(5),
    };
    let mut rows = DMatrix::zeros(rule.len() * 9, 6 * prepared.column_nodes());
    for (index, (at, weight)) in rule.into_iter().enumerate() {
        let sample = prepared.sample(at);
        let surface = area(&prepared.middle.base(&sample, 0.0)).0;
        let mut layers = vec![(0.0, element.added_mass * surface * weight)];
        for &(zeta, height) in &across {
            let volume = volume(&prepared.middle.base(&sample, zeta));
            if !is_positive(volume) {
                return Err(too_thick());
            }
            layers.push((zeta, element.material.density * volume * height * weight));
        }
        for (layer, (zeta, mass)) in layers.into_iter().enumerate() {
            for (node, shape) in sample.position.iter().enumerate() {
                for axis in 0..3 {
                    let row = 9 * index + 3 * layer + axis;
                    rows[(row, 6 * node + axis)] = mass.sqrt() * shape[0];
                    rows[(row, 6 * node + 3 + axis)] = mass.sqrt() * shape[0] * zeta;
                }
            }
        }
    }
    // Internal displacements carry no mass: they are bubbles on top of those of the nodes.
    let rows = prepared.to_degrees_of_freedom(&rows);
    Ok(squared(&rows.columns(0, 6 * nodes).into_owned()))
}

/// Returns the quadrature of the stiffness over the surface.
fn stiffness_rule(shape: ShellShape) -> Vec<Weighted> {
    match shape {
        ShellShape::Triangle3 | ShellShape::Triangle6 => triangle_rule(4),
        ShellShape::Quadrilateral4 => square_rule(2),
        ShellShape::Quadrilateral8 | ShellShape::Quadrilateral9 => square_rule(3),
    }
}

/// Returns roots of twice the strain energy: rows for each strain at each quadrature point.
fn strain_rows(
    prepared: &Prepared,
    rule: &[Weighted],
    root: &Matrix5<f64>,
    enhanced: usize,
) -> Result<DMatrix<f64>, ElementError> {
    let middle = &prepared.middle;
    let tying = points(prepared.shape).into_iter().map(|at| prepared.sample(at)).collect::<Vec<_>>();
    let at_middle = tying.iter().map(|sample| middle.covariant(sample, 0.0)).collect::<Vec<_>>();
    let centre = if prepared.shape.is_triangle() { [1.0 / 3.0; 2] } else { [0.0; 2] };
    let centre = middle.base(&prepared.sample(centre), 0.0);
    let columns = 6 * prepared.column_nodes();
    let mut rows = DMatrix::zeros(2 * rule.len() * STRAINS, columns);
    let mut enhancements = DMatrix::zeros(rows.nrows(), enhanced);
    let tied_strains = rule.iter().map(|(at, _)| ties(prepared.shape, *at)).collect::<Vec<_>>();
    // The gradient of the bubble of triangles vanishes at all tying points in the lamina.
    let tied = if prepared.shape.is_triangle() { 6 * prepared.offsets.len() } else { columns };
    // In straight triangles, strains from tying points are those of the displacements.
    let correct = matches!(prepared.shape, ShellShape::Quadrilateral8 | ShellShape::Quadrilateral9);
    let mut first = 0;
    for (zeta, height) in gauss_legendre(2) {
        let layer = tying.iter().map(|sample| middle.covariant(sample, zeta)).collect::<Vec<_>>();
        let start = first;
        let mut total = 0.0;
        // Mean strains of the displacements in the lamina less those from tying points.
        let mut missing = DMatrix::zeros(3, columns);
        let mut factors = Vec::new();
        for ((at, weight), ties) in rule.iter().zip(&tied_strains) {
            let sample = prepared.sample(*at);
            let base = middle.base(&sample, zeta);
            let volume = volume(&base);
            let dual = contravariant(&base).filter(|_| is_positive(volume)).ok_or_else(too_thick)?;
            let local = lamina(&base, centre[0]);
            let convert = conversion(&dual, &local);
            let mut covariant = middle.covariant(&sample, zeta);
            if correct {
                missing += (convert * &covariant).rows(0, 3) * (volume * weight);
                assume(&mut covariant, ties, tied, &layer, &at_middle);
                missing -= (convert * &covariant).rows(0, 3) * (volume * weight);
            } else {
                assume(&mut covariant, ties, tied, &layer, &at_middle);
            }
            total += volume * weight;
            let factor = root * (volume * height * weight).sqrt();
            factors.push(factor);
            rows.rows_mut(first, STRAINS).copy_from(&(convert * covariant));
            if enhanced > 0 {
                let modes = factor * enhancement(&centre, &local, volume, *at);
                enhancements.rows_mut(first, STRAINS).copy_from(&modes);
            }
            first += STRAINS;
        }
        missing /= total;
        for (index, factor) in factors.into_iter().enumerate() {
            let mut strains = rows.rows(start + STRAINS * index, STRAINS).into_owned();
            let mut in_lamina = strains.rows_mut(0, 3);
            in_lamina += &missing;
            rows.rows_mut(start + STRAINS * index, STRAINS).copy_from(&(factor * strains));
        }
    }
    let rows = prepared.to_degrees_of_freedom(&prepared.without_bubbles(rows));
    let mut result = DMatrix::zeros(rows.nrows(), rows.ncols() + enhanced);
    result.columns_mut(0, rows.ncols()).copy_from(&rows);
    result.columns_mut(rows.ncols(), enhanced).copy_from(&enhancements);
    Ok(result)
}

pub(super) fn too_thick() -> ElementError {
    ElementError {
        message: "the thickness of the shell element exceeds its radius of curvature".to_owned(),
        help: "reduce the thickness, or model the part by solid elements".to_owned(),
    }
}

/// Replaces covariant strains by those interpolated from tying points: in the lamina at the same
/// zeta, across it at the mid-surface. In the lamina, only the first `tied` columns are replaced.
fn assume(
    covariant: &mut DMatrix<f64>,
    ties: &Ties,
    tied: usize,
    layer: &[DMatrix<f64>],
    middle: &[DMatrix<f64>],
) {
    for (strain, ties) in ties.iter().enumerate() {
        let Some(ties) = ties else { continue };
        let (source, columns) = if strain < 3 { (layer, tied) } else { (middle, covariant.ncols()) };
        let mut row = covariant.view_mut((strain, 0), (1, columns));
        row.fill(0.0);
        for &(point, component, coefficient) in ties {
            let value = source[point].view((component, 0), (1, columns));
            row.zip_apply(&value, |sum, value| *sum += coefficient * value);
        }
    }
}

/// Returns the strains of the enhanced modes: covariant strains at the centre xi of 11, eta of 22,
/// xi and eta of 12, whose integral over the element vanishes (Simo and Rifai 1990).
fn enhancement(centre: &Basis, local: &Basis, volume_here: f64, [xi, eta]: [f64; 2]) -> SMatrix<f64, 5, 4> {
    let mut modes = SMatrix::<f64, 5, 4>::zeros();
    let Some(dual) = contravariant(centre) else { return modes };
    modes[(0, 0)] = xi;
    modes[(1, 1)] = eta;
    modes[(2, 2)] = xi;
    modes[(2, 3)] = eta;
    let mut strains = conversion(&dual, local) * modes * (volume(centre) / volume_here);
    // They enhance strains in the lamina only.
    strains.rows_mut(3, 2).fill(0.0);
    strains
}

/// Returns roots of the drilling stiffness: the rotation about the normal less that of the surface,
/// `theta . n - 1/2 n . curl u` (Hughes and Brezzi 1989).
fn drilling_rows(
    prepared: &Prepared,
    rule: &[Weighted],
    shear_modulus: f64,
    enhanced: usize,
) -> DMatrix<f64> {
    let nodes = prepared.offsets.len();
    let mut surface = DMatrix::zeros(rule.len(), 6 * prepared.column_nodes());
    let columns = 6 * nodes + prepared.internal.ncols();
    let mut rotations = DMatrix::zeros(rule.len(), columns + enhanced);
    let (mut total, mut thickness) = (0.0, 0.0);
    for (at, weight) in rule {
        let base = prepared.middle.base(&prepared.sample(*at), 0.0);
        let area = area(&base).0 * weight;
        total += area;
        thickness += 2.0 * length(base[2]) * area;
    }
    thickness /= total;
    let relative = (thickness * thickness / total).min(1.0);
    for (row, (at, weight)) in rule.iter().enumerate() {
        let sample = prepared.sample(*at);
        let mut base = prepared.middle.base(&sample, 0.0);
        let (area, normal) = area(&base);
        base[2] = normal;
        let Some(dual) = contravariant(&base) else { continue };
        let factor = (relative * shear_modulus * thickness * area * weight).sqrt();
        // The rotation of the surface is 1/2 sum of (n x a^k) . u_k.
        let turns = [cross(normal, dual[0]), cross(normal, dual[1])];
        for (node, shape) in sample.translation.iter().enumerate() {
            for axis in 0..3 {
                let rotation = 0.5 * (turns[0][axis] * shape[1] + turns[1][axis] * shape[2]);
                surface[(row, 6 * node + axis)] = -factor * rotation;
            }
        }
        if enhanced > 0 {
            // Enhanced shear strains are parts of a gradient: xi of u_2 by xi, eta of u_1 by eta.
            rotations[(row, columns + 2)] = -0.5 * factor * at[0] / area;
            rotations[(row, columns + 3)] = 0.5 * factor * at[1] / area;
        }
        for (node, shape) in sample.position.iter().enumerate() {
            for axis in 0..3 {
                rotations[(row, 6 * node + 3 + axis)] = factor * shape[0] * normal[axis];
            }
        }
    }
    let surface = prepared.to_degrees_of_freedom(&prepared.without_bubbles(surface));
    let mut of_nodes = rotations.columns_mut(0, columns);
    of_nodes += surface;
    rotations
}

/// Returns the root of the stiffness that ties the deflection of the inner node of quadratic
/// quadrilaterals, whose gradient has no assumed shear strain: the part of the transverse shear
/// strain of the displacements that this gradient has.
fn bubble_row(prepared: &Prepared, rule: &[Weighted], shear_modulus: f64) -> DMatrix<f64> {
    let columns = prepared.offsets.len() * 6 + prepared.internal.ncols();
    if !matches!(prepared.shape, ShellShape::Quadrilateral8 | ShellShape::Quadrilateral9) {
        return DMatrix::zeros(0, columns);
    }
    let mut row = DMatrix::zeros(1, 6 * prepared.column_nodes());
    let (mut norm, mut total, mut thickness) = (0.0, 0.0, 0.0);
    for (at, weight) in rule {
        let sample = prepared.sample(*at);
        let base = prepared.middle.base(&sample, 0.0);
        let area = area(&base).0 * weight;
        let half = length(base[2]);
        let strains = prepared.middle.covariant(&sample, 0.0);
        let [_, by_xi, by_eta] = square_bubble(*at);
        // Twice the covariant strain of a bubble is its gradient times half of the thickness.
        row += (strains.row(3) * by_xi + strains.row(4) * by_eta) * (weight / half);
        norm += (by_xi * by_xi + by_eta * by_eta) * weight;
        total += area;
        thickness += 2.0 * half * area;
    }
    // The row over the norm is the height of a bubble. The energy is that of its gradient.
    let factor = (SHEAR_FACTOR * shear_modulus * thickness / (total * norm)).sqrt();
    prepared.to_degrees_of_freedom(&prepared.without_bubbles(row * factor))
}

/// Eliminates all degrees of freedom after the first `kept`.
fn condensed(matrix: DMatrix<f64>, kept: usize) -> Result<DMatrix<f64>, ElementError> {
    let internal = matrix.nrows() - kept;
    if internal == 0 {
        return Ok(matrix);
    }
    let own = matrix.view((kept, kept), (internal, internal)).into_owned();
    let coupling = matrix.view((kept, 0), (internal, kept)).into_owned();
    let factor = Cholesky::new(own).ok_or_else(|| ElementError {
        message: "the shell element is too distorted: its internal stiffness is singular".to_owned(),
        help: "improve the shape of the element".to_owned(),
    })?;
    let mut eliminated = coupling;
    factor.l_dirty().solve_lower_triangular_mut(&mut eliminated);
    let mut result = matrix.view((0, 0), (kept, kept)).into_owned() - squared(&eliminated);
    result.fill_upper_triangle_with_lower_triangle();
    Ok(result)
}

/// Returns the consistent load of a pressure on the mid-surface against the normal, given at the
/// corners in Pa, over six components per node in basic axes (N, N m).
///
/// # Errors
/// As for [`stiffness`], or the number of pressures is not that of the corners.
pub fn pressure_load(element: &ShellElement<'_>, pressure: &[f64]) -> Result<DVector<f64>, ElementError> {
    let prepared = element.prepared()?;
    let (nodes, corners) = (element.positions.len(), element.shape.corner_count());
    if pressure.len() != corners {
        return Err(ElementError {
            message: format!("a shell element of {corners} corners has {} pressures", pressure.len()),
            help: "state the pressure at each corner".to_owned(),
        });
    }
    let rule = if element.shape.is_triangle() { triangle_rule(6) } else { square_rule(4) };
    let mut row = DMatrix::zeros(1, 6 * prepared.column_nodes());
    for (at, weight) in rule {
        let sample = prepared.sample(at);
        let base = prepared.middle.base(&sample, 0.0);
        let corners = element.shape.corner_shapes(at);
        let here = corners.iter().zip(pressure).map(|(shape, value)| shape[0] * value).sum::<f64>();
        let force = scaled(cross(base[0], base[1]), -here * weight);
        for (node, shape) in sample.position.iter().enumerate() {
            for axis in 0..3 {
                row[6 * node + axis] += shape[0] * force[axis];
            }
        }
    }
    Ok(prepared.to_degrees_of_freedom(&row).columns(0, 6 * nodes).transpose().column(0).into_owned())
}
