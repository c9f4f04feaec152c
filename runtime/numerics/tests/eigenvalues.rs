//! Eigenvalues of dense symmetric and skew-symmetric matrices.

use calyx_numerics::dense::{skew_symmetric_eigen, symmetric_eigen};
use faer::{Mat, c64};

/// State matrix of springs and a skew-symmetric coupling, with frequencies over many decades
/// and in pairs, as those of a rotor.
fn state_matrix(count: usize) -> Mat<f64> {
    let frequency = |k: usize| 1e3 * 1.1_f64.powi((k / 2) as i32 % 90);
    let coupling = |i: usize, j: usize| {
        let pair = 300.0 / (1.0 + (i as f64 - j as f64).powi(2));
        if i / 2 == j / 2 { pair } else { 0.01 * pair }
    };
    Mat::from_fn(2 * count, 2 * count, |i, j| match (i < count, j < count) {
        (true, true) if i < j => coupling(i, j),
        (true, true) if i > j => -coupling(i, j),
        (true, false) if i + count == j => frequency(i),
        (false, true) if i == j + count => -frequency(j),
        _ => 0.0,
    })
}

/// Stiffness of a clamped chain of points with rotations, scaled to unit mass, as that of a
/// beam with short elements: eigenvalues over many decades.
fn beam(count: usize) -> Mat<f64> {
    let length = 1.0 / count as f64;
    let own = [12.0, 6.0 * length, 4.0 * length * length, 2.0 * length * length].map(|k| k / length.powi(3));
    let mut whole = Mat::<f64>::zeros(2 * count + 2, 2 * count + 2);
    for element in 0..count {
        let block = [
            [own[0], own[1], -own[0], own[1]],
            [own[1], own[2], -own[1], own[3]],
            [-own[0], -own[1], own[0], -own[1]],
            [own[1], own[3], -own[1], own[2]],
        ];
        for (i, row) in block.iter().enumerate() {
            for (j, entry) in row.iter().enumerate() {
                whole[(2 * element + i, 2 * element + j)] += entry;
            }
        }
    }
    let mass = |k: usize| if k.is_multiple_of(2) { length } else { length.powi(3) / 12.0 };
    Mat::from_fn(2 * count, 2 * count, |i, j| whole[(i + 2, j + 2)] / (mass(i) * mass(j)).sqrt())
}

#[test]
fn small_eigenvalues_of_a_symmetric_matrix_are_accurate_to_rounding_of_the_largest() {
    for count in [20, 65, 130, 200] {
        let matrix = beam(count);
        let (values, vectors) = symmetric_eigen(matrix.as_ref()).expect("finite");
        let largest = values[values.len() - 1];
        for (k, value) in values.iter().enumerate() {
            for i in 0..2 * count {
                let product: f64 = (0..2 * count).map(|j| matrix[(i, j)] * vectors[(j, k)]).sum();
                let residual = (product - value * vectors[(i, k)]).abs();
                assert!(
                    residual < 1e-12 * largest,
                    "{count} {k}: {:e} {:e}",
                    residual / largest,
                    largest / values[0]
                );
            }
        }
    }
}

#[test]
fn a_skew_symmetric_matrix_has_pairs_of_eigenvalues() {
    for count in [1, 7, 60, 133, 261] {
        let matrix = state_matrix(count);
        let (values, vectors) = skew_symmetric_eigen(matrix.as_ref()).expect("finite");
        let largest = values[values.len() - 1];
        for (value, opposite) in values.iter().zip(values.iter().rev()) {
            assert!((value + opposite).abs() < 1e-13 * largest, "{count}: {value} {opposite}");
        }
        for (k, value) in values.iter().enumerate() {
            for i in 0..2 * count {
                let product: c64 = (0..2 * count).map(|j| vectors[(j, k)] * matrix[(i, j)]).sum();
                // A v = -i w v.
                let residual = product + c64::new(0.0, *value) * vectors[(i, k)];
                assert!(residual.norm() < 1e-12 * largest, "{count} {k}: {residual}");
            }
        }
    }
}
