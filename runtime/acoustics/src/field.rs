//! Field meshes: points at which the pressure is of interest, with the areas that they represent.

use crate::error::AcousticError;
use calyx_numerics::quadrature::gauss_legendre;
use calyx_numerics::vec3::{Vector, cross, dot, length, plus, scaled, unit};

/// Key microphone positions on a hemisphere of unit radius around +z (ISO 3744:2010, annex B).
const ISO_3744: [Vector; 10] = [
    [-0.99, 0.0, 0.15],
    [0.50, -0.86, 0.15],
    [0.50, 0.86, 0.15],
    [-0.45, 0.77, 0.45],
    [-0.45, -0.77, 0.45],
    [0.89, 0.0, 0.45],
    [0.33, 0.57, 0.75],
    [-0.66, 0.0, 0.75],
    [0.33, -0.57, 0.75],
    [0.0, 0.0, 1.0],
];

/// Points of a field with normals and areas.
#[derive(Clone, Debug, PartialEq)]
pub struct FieldMesh {
    /// Positions, m.
    pub points: Vec<Vector>,
    /// Unit normals, away from the source.
    pub normals: Vec<Vector>,
    /// Area that each point represents, m².
    pub areas: Vec<f64>,
    /// Quadrilaterals between the points, for visualization; empty for measurement positions.
    pub faces: Vec<[usize; 4]>,
}

impl FieldMesh {
    /// Creates a sphere with Gauss points along its axis z and `2 * rings` points around it. The
    /// rule integrates spherical harmonics exactly to the degree `2 * rings - 1`.
    ///
    /// # Errors
    /// The radius is not positive and finite, or there are fewer than two rings.
    pub fn sphere(center: Vector, radius: f64, rings: usize) -> Result<Self, AcousticError> {
        check_size(radius, rings)?;
        let rule = gauss_legendre(rings);
        Ok(Self::rings(center, [0.0, 0.0, 1.0], radius, &rule, 2 * rings))
    }

    /// Creates a hemisphere around a normal, with `rings` Gauss points in height and `4 * rings`
    /// points around the normal.
    ///
    /// # Errors
    /// As [`FieldMesh::sphere`], or the normal vanishes.
    pub fn hemisphere(
        center: Vector,
        normal: Vector,
        radius: f64,
        rings: usize,
    ) -> Result<Self, AcousticError> {
        check_size(radius, rings)?;
        let axis = checked_normal(normal)?;
        let rule: Vec<(f64, f64)> =
            gauss_legendre(rings).into_iter().map(|(x, weight)| (0.5 * (x + 1.0), 0.5 * weight)).collect();
        Ok(Self::rings(center, axis, radius, &rule, 4 * rings))
    }

    /// Creates the ten key positions of ISO 3744 on a hemisphere around a normal; all represent the
    /// same area.
    ///
    /// # Errors
    /// The radius is not positive and finite, or the normal vanishes.
    pub fn iso_3744(center: Vector, normal: Vector, radius: f64) -> Result<Self, AcousticError> {
        check_size(radius, 2)?;
        let axis = checked_normal(normal)?;
        let [x, y] = tangents(axis);
        let normals: Vec<Vector> = ISO_3744
            .iter()
            .map(|[a, b, c]| unit(plus(plus(scaled(x, *a), scaled(y, *b)), scaled(axis, *c))))
            .collect();
        let points = normals.iter().map(|normal| plus(center, scaled(*normal, radius))).collect();
        let area = std::f64::consts::TAU * radius * radius / ISO_3744.len() as f64;
        Ok(Self { points, normals, areas: vec![area; ISO_3744.len()], faces: Vec::new() })
    }

    /// Creates the nine key positions of ISO 3744 on a box around a small source: the middles of
    /// the sides and of the top, and the upper corners. The box has this distance from the
    /// reference box with these sides, m, whose base has this centre on the ground; its height is
    /// along the normal, and its other sides along [`tangents`] of the normal. All represent the
    /// same area.
    ///
    /// # Errors
    /// A length is not positive and finite, the normal vanishes, or the reference box is not small:
    /// its sides exceed the distance, or its height twice the distance.
    pub fn iso_3744_box(
        base: Vector,
        normal: Vector,
        [first, second, height]: [f64; 3],
        distance: f64,
    ) -> Result<Self, AcousticError> {
        check_size(distance, 2)?;
        let axis = checked_normal(normal)?;
        let sides = [first, second, height];
        if sides.iter().any(|side| !(*side > 0.0 && side.is_finite())) {
            return Err(AcousticError::input(
                format!("the reference box has the sides {sides:?} m"),
                "state sides that are positive and finite",
            ));
        }
        let least = first.max(second).max(0.5 * height);
        if least > distance {
            return Err(AcousticError::input(
                format!(
                    "nine microphones at a distance of {distance} m are too few for a box of {first:.3} m by {second:.3} m by {height:.3} m"
                ),
                format!("give a distance of at least {:.3} m", 1e-3 * (1e3 * least).ceil()),
            ));
        }
        let [x, y] = tangents(axis);
        let (a, b, c) = (0.5 * first + distance, 0.5 * second + distance, height + distance);
        let h = 0.5 * c;
        let sides = [
            ([a, 0.0, h], x),
            ([0.0, b, h], y),
            ([-a, 0.0, h], scaled(x, -1.0)),
            ([0.0, -b, h], scaled(y, -1.0)),
        ];
        let corners = [[a, b, c], [-a, b, c], [-a, -b, c], [a, -b, c]]
            .map(|at @ [p, q, r]| (at, unit(plus(plus(scaled(x, p), scaled(y, q)), scaled(axis, r)))));
        let all =
            || sides.iter().chain(&corners).chain([&([0.0, 0.0, c], axis)]).copied().collect::<Vec<_>>();
        let point = |([p, q, r], _): &([f64; 3], Vector)| {
            plus(base, plus(plus(scaled(x, *p), scaled(y, *q)), scaled(axis, *r)))
        };
        let points: Vec<Vector> = all().iter().map(point).collect();
        let area = 4.0 * (a * b + b * c + c * a) / points.len() as f64;
        Ok(Self {
            areas: vec![area; points.len()],
            normals: all().iter().map(|(_, normal)| *normal).collect(),
            faces: Vec::new(),
            points,
        })
    }

    /// Creates a parallelogram from a corner and two edges, m, with the points in the centres of
    /// `counts` cells along each edge.
    ///
    /// # Errors
    /// The edges are parallel or not finite, or a count is zero.
    pub fn plane(corner: Vector, edges: [Vector; 2], counts: [usize; 2]) -> Result<Self, AcousticError> {
        let product = cross(edges[0], edges[1]);
        let area = length(product);
        if !(area > 0.0 && area.is_finite()) || counts.contains(&0) {
            return Err(AcousticError::input(
                format!("the plane has the edges {edges:?} with {counts:?} points"),
                "state two edges that are not parallel, and at least one point along each",
            ));
        }
        let [m, n] = counts;
        let at = |k: usize, count: usize| (k as f64 + 0.5) / count as f64;
        let point =
            |i: usize, j: usize| plus(corner, plus(scaled(edges[0], at(i, m)), scaled(edges[1], at(j, n))));
        let points: Vec<Vector> = (0..n).flat_map(|j| (0..m).map(move |i| point(i, j))).collect();
        let faces = (1..n).flat_map(|j| (1..m).map(move |i| (i, j)));
        let faces = faces.map(|(i, j)| {
            let at = |i: usize, j: usize| j * m + i;
            [at(i - 1, j - 1), at(i, j - 1), at(i, j), at(i - 1, j)]
        });
        Ok(Self {
            normals: vec![unit(product); points.len()],
            areas: vec![area / points.len() as f64; points.len()],
            faces: faces.collect(),
            points,
        })
    }

    /// Creates rings at heights (relative to the radius, with weights) around an axis.
    fn rings(center: Vector, axis: Vector, radius: f64, heights: &[(f64, f64)], count: usize) -> Self {
        let [x, y] = tangents(axis);
        let mut mesh = Self { points: vec![], normals: vec![], areas: vec![], faces: vec![] };
        for (ring, &(height, weight)) in heights.iter().enumerate() {
            let width = (1.0 - height * height).sqrt();
            for k in 0..count {
                let (sine, cosine) = (std::f64::consts::TAU * k as f64 / count as f64).sin_cos();
                let across = plus(scaled(x, width * cosine), scaled(y, width * sine));
                let normal = plus(across, scaled(axis, height));
                mesh.points.push(plus(center, scaled(normal, radius)));
                mesh.normals.push(normal);
                mesh.areas.push(std::f64::consts::TAU * radius * radius * weight / count as f64);
                if ring > 0 {
                    let (next, row) = ((k + 1) % count, ring * count);
                    mesh.faces.push([row - count + k, row - count + next, row + next, row + k]);
                }
            }
        }
        mesh
    }

    /// Returns the area, m².
    pub fn area(&self) -> f64 {
        self.areas.iter().sum()
    }

    /// Returns the mean over the area of values at the points.
    pub fn mean(&self, values: impl IntoIterator<Item = f64>) -> f64 {
        values.into_iter().zip(&self.areas).map(|(value, area)| value * area).sum::<f64>() / self.area()
    }

    /// Returns the power through the field mesh in the far field, W: ∫ |p|²/(2ρc) dS, from the
    /// pressures at its points and the impedance ρc.
    pub fn far_field_power(&self, pressures: &[faer::c64], impedance: f64) -> f64 {
        let sum: f64 = pressures.iter().zip(&self.areas).map(|(p, area)| p.norm_sqr() * area).sum();
        sum / (2.0 * impedance)
    }
}

fn check_size(radius: f64, rings: usize) -> Result<(), AcousticError> {
    if !(radius > 0.0 && radius.is_finite()) || rings < 2 {
        return Err(AcousticError::input(
            format!("the field mesh has the radius {radius} m and {rings} rings"),
            "state a radius that is positive and finite, and at least two rings",
        ));
    }
    Ok(())
}

fn checked_normal(normal: Vector) -> Result<Vector, AcousticError> {
    let size = length(normal);
    if !(size > 0.0 && size.is_finite()) {
        return Err(AcousticError::input(
            format!("the normal of the field mesh is {normal:?}"),
            "state a normal that is finite and not zero",
        ));
    }
    Ok(unit(normal))
}

/// Returns two unit vectors normal to an axis and to each other, which form a right-handed system
/// with it. They are x and y if the axis is z.
pub fn tangents(axis: Vector) -> [Vector; 2] {
    let helper = if axis[0].abs() < 0.9 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
    let x = unit(plus(helper, scaled(axis, -dot(helper, axis))));
    [x, cross(axis, x)]
}
