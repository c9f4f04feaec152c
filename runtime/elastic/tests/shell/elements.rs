//! Single elements: rigid-body motions, number of zero-energy modes, mass properties, errors.

use super::support::{SHAPES, assert_close, material};
use calyx_elastic::ElementError;
use calyx_elastic::model::{Material, ShellShape};
use calyx_elastic::shell::{ShellElement, mass, pressure_load, stiffness};
use nalgebra::{DMatrix, DVector, Vector3};

/// Positions of a flat distorted element with straight sides.
fn flat(shape: ShellShape) -> Vec<[f64; 3]> {
    let corners = if shape.is_triangle() {
        vec![[0.0, 0.0], [1.3, 0.2], [0.3, 0.9]]
    } else {
        vec![[0.0, 0.0], [1.3, 0.2], [1.1, 1.2], [-0.1, 0.8]]
    };
    let places = shape.node_coordinates();
    let at = |[x, y]: [f64; 2]| {
        let weights = if shape.is_triangle() {
            vec![1.0 - x - y, x, y]
        } else {
            vec![
                0.25 * (1.0 - x) * (1.0 - y),
                0.25 * (1.0 + x) * (1.0 - y),
                0.25 * (1.0 + x) * (1.0 + y),
                0.25 * (1.0 - x) * (1.0 + y),
            ]
        };
        let sum = |axis: usize| corners.iter().zip(&weights).map(|(c, w)| c[axis] * w).sum::<f64>();
        [sum(0), sum(1), 0.0]
    };
    places.into_iter().map(at).collect()
}

/// Rotates a position out of the coordinate planes.
fn turned([x, y, z]: [f64; 3]) -> [f64; 3] {
    let rotation = nalgebra::Rotation3::from_euler_angles(0.4, -0.7, 1.1);
    let at = rotation * Vector3::new(x, y, z);
    [at.x + 3.0, at.y - 1.0, at.z + 2.0]
}

/// Flat, warped and curved variants.
fn variants(shape: ShellShape) -> Vec<(&'static str, Vec<[f64; 3]>)> {
    let bent = |height: &dyn Fn(f64, f64) -> f64| {
        flat(shape).into_iter().map(|[x, y, _]| turned([x, y, height(x, y)])).collect::<Vec<_>>()
    };
    vec![
        ("flat", bent(&|_, _| 0.0)),
        ("twisted", bent(&|x, y| 0.4 * x * y)),
        ("curved", bent(&|x, y| 0.3 * x * x - 0.2 * y * y + 0.1 * x * y)),
    ]
}

/// Rigid-body motions of nodes with rotations, as columns.
fn rigid(positions: &[[f64; 3]]) -> DMatrix<f64> {
    let mut modes = DMatrix::zeros(6 * positions.len(), 6);
    for (node, at) in positions.iter().enumerate() {
        for axis in 0..3 {
            modes[(6 * node + axis, axis)] = 1.0;
            modes[(6 * node + 3 + axis, 3 + axis)] = 1.0;
            let turn = Vector3::ith(axis, 1.0).cross(&Vector3::from(*at));
            (0..3).for_each(|component| modes[(6 * node + component, 3 + axis)] = turn[component]);
        }
    }
    modes
}

/// Returns the eigenvalues of a matrix scaled to a unit diagonal, ascending.
fn scaled_eigenvalues(matrix: &DMatrix<f64>) -> Vec<f64> {
    let scale = matrix.diagonal().map(|x| x.sqrt().recip());
    let scaled =
        DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |r, c| matrix[(r, c)] * scale[r] * scale[c]);
    let mut values = scaled.symmetric_eigenvalues().iter().copied().collect::<Vec<_>>();
    values.sort_by(f64::total_cmp);
    values
}

#[test]
fn rigid_body_motions_are_exact_and_there_are_no_mechanisms() {
    let steel = material(2e11, 0.3, 7850.0);
    for shape in SHAPES {
        for (name, positions) in variants(shape) {
            let taper = [0.1, 0.12, 0.07, 0.09];
            let element = ShellElement {
                shape,
                positions: &positions,
                thickness: &taper[..shape.corner_count()],
                offset: 0.03,
                material: &steel,
                added_mass: 0.0,
            };
            let matrix = stiffness(&element).unwrap();
            assert_eq!(matrix, matrix.transpose());
            let forces = &matrix * rigid(&positions);
            let ratio = forces.amax() / matrix.amax();
            assert!(ratio < 1e-13, "{shape:?} {name}: {ratio:.1e}");
            let values = scaled_eigenvalues(&matrix);
            let (zero, next) = (values[5] / values.last().unwrap(), values[6] / values.last().unwrap());
            println!("{shape:?} {name}: sixth {zero:.1e}, seventh {next:.1e}");
            assert!(zero.abs() < 1e-12, "{shape:?} {name}: fewer than six rigid-body modes");
            // The triangle of three nodes has little stiffness against one pattern of rotations.
            assert!(next > 1e-7, "{shape:?} {name}: mechanism {next:.1e}");
        }
    }
}

/// Returns the area, first and second moments of a polygon in the plane z = 0.
fn moments(corners: &[[f64; 3]]) -> (f64, [f64; 2], [f64; 3]) {
    let (mut area, mut first, mut second) = (0.0, [0.0; 2], [0.0; 3]);
    for (k, a) in corners.iter().enumerate() {
        let b = corners[(k + 1) % corners.len()];
        let cross = a[0] * b[1] - a[1] * b[0];
        area += 0.5 * cross;
        for axis in 0..2 {
            first[axis] += cross * (a[axis] + b[axis]) / 6.0;
            second[axis] += cross * (a[axis] * a[axis] + a[axis] * b[axis] + b[axis] * b[axis]) / 12.0;
        }
        second[2] += cross * (a[0] * b[1] + 2.0 * a[0] * a[1] + 2.0 * b[0] * b[1] + b[0] * a[1]) / 24.0;
    }
    (area, first, second)
}

#[test]
fn mass_properties_of_flat_elements_are_exact() {
    let (density, thickness, offset, added_mass) = (7850.0, 0.2, 0.3, 400.0);
    let steel = material(2e11, 0.3, density);
    for shape in SHAPES {
        let positions = flat(shape);
        let element = ShellElement {
            shape,
            positions: &positions,
            thickness: &vec![thickness; shape.corner_count()],
            offset,
            material: &steel,
            added_mass,
        };
        let modes = rigid(&positions);
        let matrix = mass(&element).unwrap();
        let inertia = modes.transpose() * &matrix * &modes;
        let (area, [x, y], [xx, yy, xy]) = moments(&positions[..shape.corner_count()]);
        let per_area = density * thickness + added_mass;
        // Second moment of mass per area about the plane of the nodes.
        let zz = density * thickness.powi(3) / 12.0 + per_area * offset * offset;
        let total = per_area * area;
        let expected = [
            ((0, 0), total),
            ((1, 1), total),
            ((2, 2), total),
            ((2, 3), per_area * y),
            ((2, 4), -per_area * x),
            ((1, 3), -total * offset),
            ((0, 4), total * offset),
            ((1, 5), per_area * x),
            ((0, 5), -per_area * y),
            ((3, 3), per_area * yy + zz * area),
            ((4, 4), per_area * xx + zz * area),
            ((5, 5), per_area * (xx + yy)),
            ((3, 4), -per_area * xy),
            ((3, 5), -per_area * x * offset),
            ((4, 5), -per_area * y * offset),
        ];
        for (place, value) in expected {
            let difference = (inertia[place] - value).abs() / total;
            assert!(difference < 1e-13, "{shape:?} {place:?}: {} instead of {value}", inertia[place]);
        }
        // A tapered rectangle has the mean thickness.
        if !shape.is_triangle() {
            let positions = shape.node_coordinates().iter().map(|[x, y]| [*x, *y, 0.0]).collect::<Vec<_>>();
            let taper = ShellElement {
                thickness: &[0.1, 0.2, 0.4, 0.1],
                positions: &positions,
                added_mass: 0.0,
                ..element
            };
            let matrix = mass(&taper).unwrap();
            let modes = rigid(&positions);
            let inertia = modes.transpose() * matrix * modes;
            assert_close(inertia[(0, 0)], 4.0 * 0.2 * density, 1e-13, "mass of a tapered element");
        }
    }
}

#[test]
fn pressure_has_the_resultant_of_the_area() {
    let steel = material(2e11, 0.3, 7850.0);
    for shape in SHAPES {
        let positions = flat(shape);
        let element = ShellElement {
            shape,
            positions: &positions,
            thickness: &vec![0.1; shape.corner_count()],
            offset: 0.0,
            material: &steel,
            added_mass: 0.0,
        };
        let (area, [x, y], _) = moments(&positions[..shape.corner_count()]);
        let load = pressure_load(&element, &vec![2.0; shape.corner_count()]).unwrap();
        let resultant = rigid(&positions).transpose() * load;
        let expected = DVector::from_vec(vec![0.0, 0.0, -2.0 * area, -2.0 * y, 2.0 * x, 0.0]);
        assert!((resultant - expected).amax() < 1e-13, "{shape:?}");
    }
}

/// Data of an element that a case alters.
struct Case {
    positions: Vec<[f64; 3]>,
    thickness: Vec<f64>,
    offset: f64,
    material: Material,
}

/// Returns the error of an altered element.
fn error(alter: impl FnOnce(&mut Case)) -> ElementError {
    let shape = ShellShape::Quadrilateral4;
    let mut case = Case {
        positions: flat(shape),
        thickness: vec![0.1; 4],
        offset: 0.0,
        material: material(2e11, 0.3, 7850.0),
    };
    alter(&mut case);
    let element = ShellElement {
        shape,
        positions: &case.positions,
        thickness: &case.thickness,
        offset: case.offset,
        material: &case.material,
        added_mass: 0.0,
    };
    let error = stiffness(&element).map(|_| ()).unwrap_err();
    assert_eq!(
        mass(&element).map(|_| ()).is_err(),
        !error.message.contains("modul") && !error.message.contains("ratio")
    );
    assert!(!error.help.is_empty());
    error
}

#[test]
fn bad_elements_are_rejected_with_their_reason() {
    let cases = [
        ("no area", error(|case| case.positions.iter_mut().for_each(|at| at[1] = 0.0))),
        ("no area", error(|case| case.positions.fill([1.0; 3]))),
        ("folded at its node 3", error(|case| case.positions[2] = [0.2, 0.2, 0.0])),
        // Crossed sides have opposite normals, which cancel or leave a folded corner.
        ("folded at its node", error(|case| case.positions.swap(1, 2))),
        ("folded at its node", error(|case| case.positions[1] = case.positions[0])),
        ("not finite", error(|case| case.positions[1][0] = f64::NAN)),
        ("has 3 positions", error(|case| case.positions.truncate(3))),
        ("has 1 thicknesses", error(|case| case.thickness.truncate(1))),
        ("thickness at corner 2 of the shell element is 0", error(|case| case.thickness[1] = 0.0)),
        ("thickness at corner 4 of the shell element is -1", error(|case| case.thickness[3] = -1.0)),
        ("offset of the shell element is inf", error(|case| case.offset = f64::INFINITY)),
        ("Young's modulus", error(|case| case.material.youngs_modulus = 0.0)),
        ("Poisson's ratio", error(|case| case.material.poissons_ratio = 1.0)),
        ("shear modulus", error(|case| case.material.shear_modulus = f64::NAN)),
        ("density", error(|case| case.material.density = -1.0)),
    ];
    for (reason, error) in cases {
        assert!(error.message.contains(reason), "{reason}: {}", error.message);
    }
}

#[test]
fn an_offset_beyond_the_curvature_is_rejected() {
    let steel = material(2e11, 0.3, 7850.0);
    let shape = ShellShape::Quadrilateral9;
    // Part of a cylinder of radius 1, normal outwards.
    let at = |[x, y]: [f64; 2]| [(0.5 * x).sin(), y, (0.5 * x).cos()];
    let positions = shape.node_coordinates().into_iter().map(at).collect::<Vec<_>>();
    let element = |offset: f64, thickness: f64| {
        let thickness = [thickness; 4];
        let element = ShellElement {
            shape,
            positions: &positions,
            thickness: &thickness,
            offset,
            material: &steel,
            added_mass: 0.0,
        };
        stiffness(&element).map(|_| ())
    };
    assert_eq!(element(0.5, 0.1), Ok(()));
    assert!(element(-1.5, 0.1).unwrap_err().message.contains("offset -1.5 folds"));
    assert!(element(0.0, 4.0).unwrap_err().message.contains("radius of curvature"));
}
