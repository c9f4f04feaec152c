//! Bars of solids, as finite-element models.

use calyx_elastic::model::SolidShape;
use calyx_elastic::{ElasticModel, Element, ElementKind, Material, Node};

const BASIC: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Steel with a multiple of its Young's modulus.
pub fn steel(factor: f64) -> Material {
    let (youngs_modulus, poissons_ratio) = (206e9 * factor, 0.3);
    let shear_modulus = 0.5 * youngs_modulus / (1.0 + poissons_ratio);
    Material { youngs_modulus, poissons_ratio, shear_modulus, density: 7850.0, structural_damping: 0.0 }
}

/// A bar of 0.3 m along x with hexahedra, `count` elements along its axes.
pub fn bar(count: [usize; 3], factor: f64) -> ElasticModel {
    let [nx, ny, nz] = count;
    let index = |i: usize, j: usize, k: usize| (k * (ny + 1) + j) * (nx + 1) + i;
    let mut model = ElasticModel { materials: vec![steel(factor)], ..ElasticModel::default() };
    for k in 0..=nz {
        for j in 0..=ny {
            for i in 0..=nx {
                let part = |at: usize, of: usize, length: f64| length * at as f64 / of as f64;
                let position = [part(i, nx, 0.3), part(j, ny, 0.04), part(k, nz, 0.05)];
                let label = model.nodes.len() as u64 + 1;
                model.nodes.push(Node { label, position, axes: BASIC });
            }
        }
    }
    for k in 0..nz {
        for j in 0..ny {
            for i in 0..nx {
                let face = |k: usize| {
                    [index(i, j, k), index(i + 1, j, k), index(i + 1, j + 1, k), index(i, j + 1, k)]
                };
                model.elements.push(Element {
                    label: model.elements.len() as u64 + 1,
                    kind: ElementKind::Solid(SolidShape::Hexahedron8),
                    nodes: [face(k), face(k + 1)].concat(),
                    material: Some(0),
                });
            }
        }
    }
    model
}
