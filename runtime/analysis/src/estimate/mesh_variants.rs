//! Meshes that error estimates compare with the mesh of an analysis.

use calyx_model::fidelity::{Fidelity, StructureOptions};

/// Ratio of the elements along every direction in the plane mesh of a perturbed solve to those of
/// the analysis.
const COARSER: f64 = 0.45;
/// Plane meshes up to this refinement are compared with one with this ratio of elements along every
/// direction, and at least of this order.
const COARSE: f64 = 0.5;
const FINER: f64 = 2.0;
const FINER_ORDER: usize = 3;
/// Factor on the difference from a finer mesh, whose own error is small.
const OF_FINER_MESH: f64 = 1.1;
/// Factor on the difference from the coarser mesh, for deflections and forces, and for stresses, in
/// plane models. The theoretical value for elements of order three is smaller; corners and integer
/// numbers of elements increase it.
const OF_MESH: [f64; 2] = [0.5, 0.2];

/// Order of displacements along the face of a model that does not prescribe it: that of the
/// templates.
const AXIAL_ORDER: usize = 3;
/// Lowest and highest order along the face of another mesh.
const LEAST_AXIAL_ORDER: usize = 2;
const MOST_AXIAL_ORDER: usize = 8;
/// Elements of this order or more are compared with those of one order less, in three dimensions.
const CUBIC: usize = 3;
/// Factors in three dimensions on the difference between cubic elements and 1.5 times as many
/// quadratic ones along every direction, for the former, and on that from the next higher order,
/// for elements of a lower order.
const OF_LOWER_ORDER: [f64; 2] = [2.0, 1.6];
const OF_HIGHER_ORDER: [f64; 2] = [1.3, 1.6];
/// Ratio of elements along every direction in three dimensions: in whole numbers, templates have
/// more of them then along every direction. Quadratic elements have as many degrees of freedom then
/// as cubic ones.
const FINER_SOLID: f64 = 1.5;
/// Additional degrees of the polynomials along raceways: the next ones of the same symmetry.
const RACEWAY_DEGREES: u8 = 2;

/// Mesh for a comparison.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct MeshVariant {
    pub(super) structure: StructureOptions,
    /// Factors on the difference: deflections and forces, and stresses.
    factors: [f64; 2],
    /// Direction of the error of the analysis relative to the difference of this mesh from it: -1
    /// for a more accurate mesh; 0, unknown, for another one.
    pub(super) direction: f64,
}

impl MeshVariant {
    /// Returns a mesh for the comparison, and the one that replaces it if it cannot be condensed.
    ///
    /// A plane mesh is compared with one of fewer elements, which costs less than the analysis. A
    /// coarse one would have too few elements then: it is compared with a finer one, which is
    /// cheap.
    /// Solid meshes have as few elements as they can, so they are compared with elements of another
    /// order: quadratic ones with cubic ones, and cubic ones with more quadratic ones, which are
    /// equally expensive. The same number of quadratic elements would show no error of the layers
    /// that recovered stress is fitted to. Linear elements lock, so they show no error of quadratic
    /// ones. All have higher polynomials along raceways.
    pub(super) fn of(fidelity: Fidelity, structure: StructureOptions) -> [MeshVariant; 2] {
        match fidelity {
            Fidelity::Solid(_) => {
                let structure = StructureOptions {
                    raceway_degrees: structure.raceway_degrees + RACEWAY_DEGREES,
                    ..structure
                };
                let other = match structure.order < CUBIC {
                    true => MeshVariant {
                        structure: of_order(structure, structure.order + 1),
                        factors: OF_HIGHER_ORDER,
                        direction: -1.0,
                    },
                    false => MeshVariant {
                        structure: with_elements(of_order(structure, structure.order - 1), FINER_SOLID),
                        factors: OF_LOWER_ORDER,
                        direction: 0.0,
                    },
                };
                let finer = MeshVariant {
                    structure: with_elements(structure, FINER_SOLID),
                    factors: OF_HIGHER_ORDER,
                    direction: -1.0,
                };
                [other, finer]
            }
            _ => {
                let order = structure.order.max(FINER_ORDER);
                let finer = MeshVariant {
                    structure: StructureOptions { order, ..with_elements(structure, FINER) },
                    factors: [OF_FINER_MESH; 2],
                    direction: -1.0,
                };
                let coarser = MeshVariant {
                    structure: with_elements(structure, COARSER),
                    factors: OF_MESH,
                    direction: 0.0,
                };
                if structure.refinement <= COARSE { [finer, coarser] } else { [coarser, finer] }
            }
        }
    }

    /// Returns the factor on the difference of an output, depending on whether it is a stress.
    pub(super) fn factor(&self, is_stress: bool) -> f64 {
        self.factors[usize::from(is_stress)]
    }
}

/// Returns a mesh with this ratio of elements along every direction, also along the face if their
/// number there is given.
fn with_elements(structure: StructureOptions, ratio: f64) -> StructureOptions {
    let along = |elements: usize| ((elements as f64 * ratio).round() as usize).max(1);
    StructureOptions {
        refinement: ratio * structure.refinement,
        face_elements: structure.face_elements.map(along),
        ..structure
    }
}

/// Returns a three-dimensional mesh of the same elements with another order in the section, and the
/// order along the face changed by as much, but not to linear displacements: these lock.
fn of_order(structure: StructureOptions, order: usize) -> StructureOptions {
    let own = structure.axial_order.unwrap_or(AXIAL_ORDER);
    let along = (own + order).saturating_sub(structure.order).max(own.min(LEAST_AXIAL_ORDER));
    StructureOptions { order, axial_order: Some(along.min(MOST_AXIAL_ORDER)), ..structure }
}

#[cfg(test)]
mod tests {
    use super::*;
    use calyx_model::fidelity::Template;

    /// Orders in the section and along the face of the mesh for a comparison.
    fn orders(order: usize, axial_order: Option<usize>) -> [Option<usize>; 2] {
        let own = StructureOptions { order, axial_order, ..StructureOptions::default() };
        let [MeshVariant { structure, .. }, finer] = MeshVariant::of(Fidelity::Solid(Template::Medium), own);
        assert_eq!((finer.structure.order, finer.structure.refinement), (order, FINER_SOLID));
        assert_eq!([structure, finer.structure].map(|other| other.raceway_degrees), [RACEWAY_DEGREES; 2]);
        [Some(structure.order), structure.axial_order]
    }

    #[test]
    fn linear_elements_show_no_error_of_others() {
        assert_eq!(orders(3, None), [Some(2), Some(2)]);
        assert_eq!(orders(2, None), [Some(3), Some(4)]);
        assert_eq!(orders(2, Some(1)), [Some(3), Some(2)]);
        assert_eq!(orders(3, Some(2)), [Some(2), Some(2)]);
        assert_eq!(orders(1, Some(8)), [Some(2), Some(8)]);
    }
}
