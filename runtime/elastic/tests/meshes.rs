//! Meshes and materials of the tests.

use calyx_elastic::model::{BeamProperties, BeamSection, SolidShape};
use calyx_elastic::{ElasticModel, Element, ElementKind, FixedComponents, Material, NodalLoad, Node};
use std::collections::BTreeMap;

/// Basic axes.
pub const BASIC: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// All shapes of solids.
pub const SHAPES: [SolidShape; 7] = [
    SolidShape::Hexahedron8,
    SolidShape::IncompatibleHexahedron8,
    SolidShape::Hexahedron20,
    SolidShape::Wedge6,
    SolidShape::Wedge15,
    SolidShape::Tetrahedron4,
    SolidShape::Tetrahedron10,
];

/// Returns steel.
pub fn steel() -> Material {
    let (youngs_modulus, poissons_ratio) = (206e9, 0.3);
    Material {
        youngs_modulus,
        poissons_ratio,
        shear_modulus: 0.5 * youngs_modulus / (1.0 + poissons_ratio),
        density: 7850.0,
        structural_damping: 0.0,
    }
}

/// Returns a solid circular section by its diameter, with Cowper's shear factor.
pub fn circular(diameter: f64) -> BeamSection {
    let area = 0.25 * std::f64::consts::PI * diameter * diameter;
    let moment = area * diameter * diameter / 16.0;
    let factor = 6.0 * 1.3 / (7.0 + 6.0 * 0.3);
    BeamSection {
        area,
        second_moment_z: moment,
        second_moment_y: moment,
        product_of_inertia: 0.0,
        torsion_constant: 2.0 * moment,
        shear_factors: [factor; 2],
        added_mass: 0.0,
    }
}

/// Returns a beam of one section with its y axis in the plane of the vector `orientation`.
pub fn beam(section: BeamSection, orientation: [f64; 3]) -> BeamProperties {
    BeamProperties { orientation, sections: [section; 2], offsets: [[0.0; 3]; 2], released: [[false; 6]; 2] }
}

/// Returns nodes at positions, with labels from 1.
pub fn nodes(positions: &[[f64; 3]]) -> Vec<Node> {
    let node =
        |(index, &position): (usize, &[f64; 3])| Node { label: index as u64 + 1, position, axes: BASIC };
    positions.iter().enumerate().map(node).collect()
}

/// Returns a model with a chain of equal beams along x.
pub fn chain(properties: &BeamProperties, length: f64, count: usize) -> ElasticModel {
    let positions: Vec<[f64; 3]> =
        (0..=count).map(|k| [length * k as f64 / count as f64, 0.0, 0.0]).collect();
    let element = |k: usize| Element {
        label: k as u64 + 1,
        kind: ElementKind::Beam(Box::new(properties.clone())),
        nodes: vec![k, k + 1],
        material: Some(0),
    };
    ElasticModel {
        nodes: nodes(&positions),
        materials: vec![steel()],
        elements: (0..count).map(element).collect(),
        ..ElasticModel::default()
    }
}

/// Returns a fixed node.
pub fn clamped(node: usize) -> FixedComponents {
    FixedComponents { node, components: [true; 6], value: 0.0 }
}

/// Returns a load.
pub fn load(node: usize, load: [f64; 6]) -> NodalLoad {
    NodalLoad { node, load }
}

/// Returns a block of `counts` cells of unit edge, divided into solids of a shape. `place` moves
/// the corners.
pub fn block(shape: SolidShape, counts: [usize; 3], place: impl Fn([f64; 3]) -> [f64; 3]) -> ElasticModel {
    let [nx, ny, nz] = counts;
    let index = |i: usize, j: usize, k: usize| i + (nx + 1) * (j + (ny + 1) * k);
    let mut positions = Vec::new();
    for k in 0..=nz {
        for j in 0..=ny {
            positions.extend((0..=nx).map(|i| place([i as f64, j as f64, k as f64])));
        }
    }
    let mut cells: Vec<Vec<usize>> = Vec::new();
    for k in 0..nz {
        for j in 0..ny {
            for i in 0..nx {
                let base = [[0, 0], [1, 0], [1, 1], [0, 1]];
                let corner = |n: usize| {
                    let [di, dj] = base[n % 4];
                    index(i + di, j + dj, k + n / 4)
                };
                let of = |corners: &[usize]| corners.iter().map(|&n| corner(n)).collect::<Vec<_>>();
                match shape {
                    SolidShape::Hexahedron8
                    | SolidShape::IncompatibleHexahedron8
                    | SolidShape::Hexahedron20 => cells.push(of(&[0, 1, 2, 3, 4, 5, 6, 7])),
                    SolidShape::Wedge6 | SolidShape::Wedge15 => {
                        cells.extend([of(&[0, 1, 2, 4, 5, 6]), of(&[0, 2, 3, 4, 6, 7])]);
                    }
                    SolidShape::Tetrahedron4 | SolidShape::Tetrahedron10 => {
                        let six = [[1, 2], [2, 3], [3, 7], [7, 4], [4, 5], [5, 1]];
                        cells.extend(six.map(|[a, b]| of(&[0, a, b, 6])));
                    }
                }
            }
        }
    }
    let mut midsides: BTreeMap<[usize; 2], usize> = BTreeMap::new();
    let mut elements = Vec::new();
    for (number, corners) in cells.into_iter().enumerate() {
        let mut of_element = corners.clone();
        for &[from, to] in shape.midside_edges() {
            let key = [corners[from].min(corners[to]), corners[from].max(corners[to])];
            let node = *midsides.entry(key).or_insert_with(|| {
                let [a, b] = key.map(|corner| positions[corner]);
                positions.push([0, 1, 2].map(|axis| 0.5 * (a[axis] + b[axis])));
                positions.len() - 1
            });
            of_element.push(node);
        }
        let (label, kind) = (number as u64 + 1, ElementKind::Solid(shape));
        elements.push(Element { label, kind, nodes: of_element, material: Some(0) });
    }
    ElasticModel { nodes: nodes(&positions), materials: vec![steel()], elements, ..ElasticModel::default() }
}

/// Compares with a tolerance relative to the expected value.
#[track_caller]
pub fn assert_close(found: f64, expected: f64, tolerance: f64) {
    let difference = (found - expected).abs();
    assert!(difference <= tolerance * expected.abs(), "{found:.12e} instead of {expected:.12e}");
}

/// Rotates a vector about the axis (1, 2, 3) by 1.1 rad.
pub fn rotated(vector: [f64; 3]) -> [f64; 3] {
    let axis = nalgebra::Unit::new_normalize(nalgebra::Vector3::new(1.0, 2.0, 3.0));
    (nalgebra::Rotation3::from_axis_angle(&axis, 1.1) * nalgebra::Vector3::from(vector)).into()
}
