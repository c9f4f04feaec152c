//! The same in space, at few positions: of quadratic elements against cubic ones, of cubic ones against more of them, and of helical teeth. What they are
//! compared with other tests condense as well; finer meshes are too dear for a test. How cubic ones converge
//! `cargo bench -p calyx-gears --bench convergence -- medium` shows.

use super::*;
use crate::first_day_in_space::{BODIES, MESH as TEETH, scene};
use calyx_runtime::observables::{MaxContactPressure, MaxRootStress, MeshStiffness, TransmissionError};

const QUADRATIC: StructureOptions = StructureOptions { order: 2, axial_order: Some(2), ..MESH };
/// As `first_day_in_space` has it.
const CUBIC: StructureOptions = StructureOptions { face_elements: Some(2), axial_order: Some(2), ..MESH };
const SPACE: Setting =
    Setting { fidelity: "medium", structure: QUADRATIC, cells: Some([6, 4]), steps: 2, ..PLANE };

#[test]
fn of_a_pair_in_space() {
    let finer = Setting { structure: MESH, estimates: Estimates::None, ..SPACE };
    let cases = [Case { name: "in space", setting: SPACE, parts: &[Part::Discretization] }];
    let wrong = wrong(&PLAIN, &finer, &cases);
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// A gear of twenty teeth with its like, and what cubic elements say of it, which other tests condense.
fn wrong_of_a_pair(name: &str, helix_angle: f64, own: StructureOptions) -> Vec<String> {
    let mut scene = scene(helix_angle);
    let outputs = vec![
        OutputRequest::observing("te", scene.add_observable(TransmissionError(TEETH))),
        OutputRequest::observing("stiffness", scene.add_observable(MeshStiffness(TEETH))),
        OutputRequest::observing("pressure", scene.add_observable(MaxContactPressure(TEETH))),
        OutputRequest::observing("pinion", scene.add_observable(MaxRootStress(BODIES[0]))),
        OutputRequest::observing("wheel", scene.add_observable(MaxRootStress(BODIES[1]))),
    ];
    let cycle = scene.pairs[TEETH.0].mesh.clone().expect("a mesh");
    let finer = Setting { structure: CUBIC, estimates: Estimates::None, ..SPACE };
    let exact = analyse_scene((scene.clone(), &cycle), &outputs, &finer);
    let (own, _) = analyse_scene((scene, &cycle), &outputs, &Setting { structure: own, ..SPACE });
    effectivities(name, &[Part::Discretization], &own, &exact)
}

#[test]
fn of_cubic_elements() {
    let wrong = wrong_of_a_pair("cubic", 0.0, StructureOptions { refinement: 0.7, ..CUBIC });
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn of_helical_teeth() {
    let wrong = wrong_of_a_pair("helical", 0.3, StructureOptions { order: 2, ..CUBIC });
    assert!(wrong.is_empty(), "{wrong:#?}");
}
