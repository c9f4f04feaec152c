//! The same in space, at few positions: of quadratic elements against cubic ones, which other tests condense as well. How cubic ones converge
//! `cargo bench -p calyx-gears --bench convergence -- medium` shows; finer meshes than theirs are too dear for a test.

use super::*;

const QUADRATIC: StructureOptions = StructureOptions { order: 2, axial_order: Some(2), ..MESH };
const SPACE: Setting =
    Setting { fidelity: "medium", structure: QUADRATIC, cells: Some([6, 4]), steps: 2, ..PLANE };

#[test]
fn of_a_pair_in_space() {
    let finer = Setting { structure: MESH, estimates: Estimates::None, ..SPACE };
    let cases = [Case { name: "in space", setting: SPACE, parts: &[Part::Discretization] }];
    let wrong = wrong(&PLAIN, &finer, &cases);
    assert!(wrong.is_empty(), "{wrong:#?}");
}
