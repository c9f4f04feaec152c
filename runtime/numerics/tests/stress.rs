//! Averages of stresses at nodes, and rotated tensors.

use calyx_numerics::stress::{ElementStresses, NodalStresses, rotated, von_mises};

#[test]
fn corners_take_the_difference_of_their_element() {
    let along = |xx: f64| [xx, 0.0, 0.0, 0.0, 0.0, 0.0];
    // Three elements in a row share nodes 1 and 2; the fourth is alone, and node 6 unused.
    let nodes: [&[usize]; 4] = [&[0, 1], &[1, 2], &[2, 3], &[4, 5]];
    let stresses = [[1.0, 2.0], [4.0, 8.0], [8.0, 7.0], [1.0, 3.0]].map(|ends| ends.map(along));
    let elements = nodes.into_iter().zip(&stresses).map(|(nodes, stresses)| ElementStresses {
        nodes,
        stresses,
        quadratic: false,
    });
    let found = NodalStresses::averaged(&[[0.0; 3]; 7], elements);
    assert_eq!(found.stresses[..6], [1.0, 3.0, 8.0, 7.0, 1.0, 3.0].map(along));
    assert!(found.stresses[6].iter().all(|part| part.is_nan()));
    assert_eq!(found.errors[..4], [1.0, 1.0, 1.0, 0.0]);
    assert!(found.errors[4..].iter().all(|error| error.is_nan()));
}

#[test]
fn rotation_keeps_the_von_mises_stress() {
    let (sine, cosine) = 0.7_f64.sin_cos();
    let about_z = [[cosine, sine, 0.0], [-sine, cosine, 0.0], [0.0, 0.0, 1.0]];
    let stress = [3.0, -1.0, 2.0, 0.5, -0.2, 0.9];
    let turned = rotated(&about_z, stress);
    assert!((von_mises(turned) - von_mises(stress)).abs() < 1e-12);
    assert!((turned[0] + turned[1] - 2.0).abs() < 1e-12);
    assert!((von_mises([0.0, 0.0, 0.0, 0.0, 0.0, 2.0]) - 2.0 * 3.0_f64.sqrt()).abs() < 1e-15);
}
