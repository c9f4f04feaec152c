//! Timoshenko beams with offsets, releases and tapered sections, and rods.
//!
//! Stiffness follows from the flexibility of the beam clamped at its first end, integrated along
//! the axis, and from equilibrium. It is exact for every taper. The displacements between the ends
//! in the consistent mass are the exact static ones: for a uniform beam the cubic polynomial with
//! the shear deformation of Timoshenko. See `docs/theory/elastic-bodies.md`.

use crate::error::ElementError;
use crate::model::{BeamProperties, BeamSection, Material};
use calyx_numerics::quadrature::gauss_legendre;
use nalgebra::{DMatrix, Matrix3, Matrix6, SMatrix, Vector3};

/// Number of Gauss points of a uniform beam and of a tapered one. The integrand of the latter is
/// rational; for sections with a ratio of 10, 40 points give all digits.
const POINTS: [usize; 2] = [8, 40];

/// Matrix over both ends of a beam.
type Matrix12 = SMatrix<f64, 12, 12>;
/// Section displacements by the displacements of both ends.
type Interpolation = SMatrix<f64, 6, 12>;

/// Beam in its local axes: x from the first end to the second.
struct Beam<'a> {
    properties: &'a BeamProperties,
    material: &'a Material,
    length: f64,
    /// Local axes, by row.
    axes: Matrix3<f64>,
    rule: Vec<(f64, f64)>,
}

/// Returns a section between both ends; properties vary linearly.
fn section([first, second]: &[BeamSection; 2], at: f64) -> BeamSection {
    let between = |of: fn(&BeamSection) -> f64| {
        let (one, other) = (of(first), of(second));
        if one == other { one } else { (1.0 - at) * one + at * other }
    };
    BeamSection {
        area: between(|s| s.area),
        second_moment_z: between(|s| s.second_moment_z),
        second_moment_y: between(|s| s.second_moment_y),
        product_of_inertia: between(|s| s.product_of_inertia),
        torsion_constant: between(|s| s.torsion_constant),
        shear_factors: [between(|s| s.shear_factors[0]), between(|s| s.shear_factors[1])],
        added_mass: between(|s| s.added_mass),
    }
}

/// Returns the forces and moments of the section at distance `arm` before the point of action of
/// unit forces and moments.
fn section_forces(arm: f64) -> Matrix6<f64> {
    let mut forces = Matrix6::identity();
    forces[(4, 2)] = -arm;
    forces[(5, 1)] = arm;
    forces
}

/// Returns the displacements at distance `arm` behind a point by its rigid-body motion.
fn rigid_motion(arm: f64) -> Matrix6<f64> {
    let mut motion = Matrix6::identity();
    motion[(1, 5)] = arm;
    motion[(2, 4)] = -arm;
    motion
}

/// Returns the components without stiffness of a section: extension, bending in each plane,
/// torsion.
fn absent(section: &BeamSection) -> [bool; 6] {
    let [xy, xz] = [section.second_moment_z == 0.0, section.second_moment_y == 0.0];
    [section.area == 0.0, xy, xz, section.torsion_constant == 0.0, xz, xy]
}

impl<'a> Beam<'a> {
    fn new(
        properties: &'a BeamProperties,
        material: &'a Material,
        positions: [[f64; 3]; 2],
    ) -> Result<Self, ElementError> {
        let end = |k: usize| Vector3::from(positions[k]) + Vector3::from(properties.offsets[k]);
        let along = end(1) - end(0);
        let length = along.norm();
        if !(length.is_finite() && length > 0.0) {
            return Err(ElementError::new("the beam has no length", "place its ends at distinct points"));
        }
        let x = along / length;
        let orientation = Vector3::from(properties.orientation);
        let across = orientation - x * x.dot(&orientation);
        if across.norm() <= 1e-9 * orientation.norm() || orientation.norm() == 0.0 {
            return Err(ElementError::new(
                "the orientation vector is parallel to the beam",
                "state a vector in the plane of the local x and y axes",
            ));
        }
        let y = across.normalize();
        let axes = Matrix3::from_rows(&[x.transpose(), y.transpose(), x.cross(&y).transpose()]);
        for section in &properties.sections {
            check(section, material)?;
        }
        let tapered = properties.sections[0] != properties.sections[1];
        let rule = gauss_legendre(POINTS[usize::from(tapered)]);
        let rule = rule.into_iter().map(|(at, weight)| (0.5 + 0.5 * at, 0.5 * weight)).collect();
        Ok(Self { properties, material, length, axes, rule })
    }

    /// Returns the strains of a section by its forces and moments. A property that is zero is
    /// replaced by a unit: its stiffness is removed later.
    fn section_compliance(&self, at: f64) -> Matrix6<f64> {
        let section = section(&self.properties.sections, at);
        let (young, shear) = (self.material.youngs_modulus, self.material.shear_modulus);
        let or_unit = |value: f64| if value == 0.0 { 1.0 } else { value };
        let area = or_unit(section.area);
        let mut compliance = Matrix6::zeros();
        compliance[(0, 0)] = 1.0 / (young * area);
        for (plane, factor) in section.shear_factors.into_iter().enumerate() {
            if factor.is_finite() && factor != 0.0 {
                compliance[(1 + plane, 1 + plane)] = 1.0 / (shear * area * factor);
            }
        }
        compliance[(3, 3)] = 1.0 / (shear * or_unit(section.torsion_constant));
        let (z, y) = (or_unit(section.second_moment_z), or_unit(section.second_moment_y));
        let product = section.product_of_inertia;
        let determinant = young * (z * y - product * product);
        compliance[(4, 4)] = z / determinant;
        compliance[(5, 5)] = y / determinant;
        compliance[(4, 5)] = product / determinant;
        compliance[(5, 4)] = product / determinant;
        compliance
    }

    /// Returns the displacements at a point of the beam, clamped at its first end, by unit forces
    /// and moments at its second end.
    fn flexibility(&self, to: f64) -> Matrix6<f64> {
        let mut sum = Matrix6::zeros();
        for &(at, weight) in &self.rule {
            let at = at * to;
            let there = section_forces((to - at) * self.length);
            let end = section_forces((1.0 - at) * self.length);
            sum += weight * to * self.length * (there.transpose() * self.section_compliance(at) * end);
        }
        sum
    }

    /// Returns the inverse flexibility of the beam clamped at its first end.
    fn clamped_stiffness(&self) -> Result<Matrix6<f64>, ElementError> {
        // The scaled flexibility has entries of one magnitude.
        let flexibility = self.flexibility(1.0);
        let scale = flexibility.diagonal().map(|entry| 1.0 / entry.sqrt());
        let scaled = Matrix6::from_fn(|i, j| flexibility[(i, j)] * scale[i] * scale[j]);
        let inverse = scaled.try_inverse().ok_or_else(|| {
            ElementError::new("the section has no stiffness", "state positive properties of the section")
        })?;
        Ok(Matrix6::from_fn(|i, j| 0.5 * (inverse[(i, j)] + inverse[(j, i)]) * scale[i] * scale[j]))
    }

    /// Returns the stiffness in local axes, without releases.
    fn local_stiffness(&self) -> Result<Matrix12, ElementError> {
        let mut clamped = self.clamped_stiffness()?;
        let [first, second] = self.properties.sections.each_ref().map(absent);
        for component in (0..6).filter(|&component| first[component] && second[component]) {
            clamped.row_mut(component).fill(0.0);
            clamped.column_mut(component).fill(0.0);
        }
        let rigid = rigid_motion(self.length);
        let mut matrix = Matrix12::zeros();
        let coupling = -(clamped * rigid);
        let first = rigid.transpose() * clamped * rigid;
        matrix.fixed_view_mut::<6, 6>(0, 0).copy_from(&(0.5 * (first + first.transpose())));
        matrix.fixed_view_mut::<6, 6>(6, 0).copy_from(&coupling);
        matrix.fixed_view_mut::<6, 6>(0, 6).copy_from(&coupling.transpose());
        matrix.fixed_view_mut::<6, 6>(6, 6).copy_from(&clamped);
        Ok(matrix)
    }

    /// Returns the displacements of a section by those of both ends.
    fn interpolation(&self, at: f64, clamped: &Matrix6<f64>) -> Interpolation {
        let of_second = self.flexibility(at) * clamped;
        let of_first = rigid_motion(at * self.length) - of_second * rigid_motion(self.length);
        let mut matrix = Interpolation::zeros();
        matrix.fixed_view_mut::<6, 6>(0, 0).copy_from(&of_first);
        matrix.fixed_view_mut::<6, 6>(0, 6).copy_from(&of_second);
        matrix
    }

    fn local_mass(&self) -> Result<Matrix12, ElementError> {
        let clamped = self.clamped_stiffness()?;
        let mut matrix = Matrix12::zeros();
        for &(at, weight) in &self.rule {
            let section = section(&self.properties.sections, at);
            let density = self.material.density;
            let along = density * section.area + section.added_mass;
            let mut inertia = Matrix6::zeros();
            for axis in 0..3 {
                inertia[(axis, axis)] = along;
            }
            inertia[(3, 3)] = density * (section.second_moment_y + section.second_moment_z);
            inertia[(4, 4)] = density * section.second_moment_y;
            inertia[(5, 5)] = density * section.second_moment_z;
            inertia[(4, 5)] = -density * section.product_of_inertia;
            inertia[(5, 4)] = inertia[(4, 5)];
            let shape = self.interpolation(at, &clamped);
            matrix += weight * self.length * (shape.transpose() * inertia * shape);
        }
        Ok(0.5 * (matrix + matrix.transpose()))
    }

    /// Returns the displacements of the ends, in local axes, by those of the nodes in basic axes.
    fn ends_by_nodes(&self) -> Matrix12 {
        let mut matrix = Matrix12::zeros();
        for end in 0..2 {
            let offset = Vector3::from(self.properties.offsets[end]);
            let first = 6 * end;
            let lever = -(self.axes * offset.cross_matrix());
            matrix.fixed_view_mut::<3, 3>(first, first).copy_from(&self.axes);
            matrix.fixed_view_mut::<3, 3>(first, first + 3).copy_from(&lever);
            matrix.fixed_view_mut::<3, 3>(first + 3, first + 3).copy_from(&self.axes);
        }
        matrix
    }

    /// Returns the displacements of both ends by those of the connected components, with released
    /// ones in static equilibrium.
    fn releases(&self, stiffness: &Matrix12) -> Result<Matrix12, ElementError> {
        let [first, second] = self.properties.released;
        let is_released = |k: usize| if k < 6 { first[k] } else { second[k - 6] };
        let released: Vec<usize> = (0..12).filter(|&k| is_released(k)).collect();
        let mut matrix = Matrix12::identity();
        if released.is_empty() {
            return Ok(matrix);
        }
        let count = released.len();
        let scale = released.iter().map(|&k| stiffness[(k, k)].sqrt().recip()).collect::<Vec<_>>();
        let own = DMatrix::from_fn(count, count, |i, j| {
            stiffness[(released[i], released[j])] * scale[i] * scale[j]
        });
        let mechanism = || {
            ElementError::new(
                "the released components leave the beam a motion without stiffness",
                "release each component at one end only, and at most one end against translation",
            )
        };
        if own.clone().symmetric_eigenvalues().iter().any(|&value| value.is_nan() || value < 1e-10) {
            return Err(mechanism());
        }
        let inverse = own.try_inverse().ok_or_else(mechanism)?;
        for (i, &row) in released.iter().enumerate() {
            for column in 0..12 {
                matrix[(row, column)] = if is_released(column) {
                    0.0
                } else {
                    let terms = (0..count)
                        .map(|j| inverse[(i, j)] * scale[i] * scale[j] * stiffness[(released[j], column)]);
                    -terms.sum::<f64>()
                };
            }
        }
        Ok(matrix)
    }
}

fn check(section: &BeamSection, material: &Material) -> Result<(), ElementError> {
    let BeamSection { area, second_moment_z: z, second_moment_y: y, product_of_inertia: product, .. } =
        *section;
    let plausible = [area, z, y, section.torsion_constant, section.added_mass, material.density]
        .iter()
        .all(|value| value.is_finite() && *value >= 0.0);
    let stiff = material.youngs_modulus > 0.0 && material.shear_modulus > 0.0;
    if !plausible || !stiff || section.shear_factors.iter().any(|factor| factor.is_nan() || *factor < 0.0) {
        return Err(ElementError::new(
            "a property of the beam's section or material is negative or not finite",
            "state positive moduli, and an area and moments of at least zero",
        ));
    }
    if product * product >= z * y && product != 0.0 {
        return Err(ElementError::new(
            format!("the product of inertia {product:.6e} is too large for the second moments"),
            "reduce its absolute value below the root of the product of both second moments",
        ));
    }
    Ok(())
}

fn dynamic(matrix: &Matrix12) -> DMatrix<f64> {
    DMatrix::from_fn(12, 12, |i, j| 0.5 * (matrix[(i, j)] + matrix[(j, i)]))
}

/// Returns the stiffness of a beam over six components of both nodes along the basic axes.
///
/// # Errors
/// The beam has no length, an invalid section or orientation, or too many released components.
pub fn stiffness(
    properties: &BeamProperties,
    material: &Material,
    positions: [[f64; 3]; 2],
) -> Result<DMatrix<f64>, ElementError> {
    let beam = Beam::new(properties, material, positions)?;
    let local = beam.local_stiffness()?;
    let to_ends = beam.releases(&local)? * beam.ends_by_nodes();
    Ok(dynamic(&(to_ends.transpose() * local * to_ends)))
}

/// Returns the consistent mass of a beam with rotary inertia, over the components of [`stiffness`].
///
/// # Errors
/// As for [`stiffness`].
pub fn mass(
    properties: &BeamProperties,
    material: &Material,
    positions: [[f64; 3]; 2],
) -> Result<DMatrix<f64>, ElementError> {
    let beam = Beam::new(properties, material, positions)?;
    let to_ends = beam.releases(&beam.local_stiffness()?)? * beam.ends_by_nodes();
    Ok(dynamic(&(to_ends.transpose() * beam.local_mass()? * to_ends)))
}

/// Returns the direction and the length of a rod.
fn rod_axis([first, second]: [[f64; 3]; 2]) -> Result<(Vector3<f64>, f64), ElementError> {
    let along = Vector3::from(second) - Vector3::from(first);
    let length = along.norm();
    if length > 0.0 && length.is_finite() {
        Ok((along / length, length))
    } else {
        Err(ElementError::new("the rod has no length", "place its ends at distinct points"))
    }
}

/// Returns the stiffness of a rod with area A (m^2) and torsion constant J (m^4) over six
/// components of both nodes along the basic axes.
///
/// # Errors
/// The rod has no length.
pub fn rod_stiffness(
    [area, torsion_constant]: [f64; 2],
    material: &Material,
    positions: [[f64; 3]; 2],
) -> Result<DMatrix<f64>, ElementError> {
    let (axis, length) = rod_axis(positions)?;
    let rigidities =
        [material.youngs_modulus * area / length, material.shear_modulus * torsion_constant / length];
    let mut matrix = DMatrix::zeros(12, 12);
    for (kind, rigidity) in rigidities.into_iter().enumerate() {
        for (row, column) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let sign = if row == column { 1.0 } else { -1.0 };
            for i in 0..3 {
                for j in 0..3 {
                    matrix[(6 * row + 3 * kind + i, 6 * column + 3 * kind + j)] =
                        sign * rigidity * (axis[i] * axis[j]);
                }
            }
        }
    }
    Ok(matrix)
}

/// Returns the consistent mass of a rod for translations in all directions.
///
/// # Errors
/// The rod has no length.
pub fn rod_mass(
    area: f64,
    added_mass: f64,
    material: &Material,
    positions: [[f64; 3]; 2],
) -> Result<DMatrix<f64>, ElementError> {
    let (_, length) = rod_axis(positions)?;
    let total = (material.density * area + added_mass) * length;
    let mut matrix = DMatrix::zeros(12, 12);
    for axis in 0..3 {
        for (row, column) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            matrix[(6 * row + axis, 6 * column + axis)] = total / if row == column { 3.0 } else { 6.0 };
        }
    }
    Ok(matrix)
}
