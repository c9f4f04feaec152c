//! Effectivities in three dimensions, at few positions: quadratic elements compared with cubic
//! ones, cubic ones with more of them, and helical teeth. Other tests condense the same references;
//! finer meshes are too expensive for a test.
//! `cargo bench -p calyx-gears --bench convergence -- medium` shows the convergence of cubic
//! elements.

use super::*;
use crate::first_day_in_space::{BODIES, MESH as TEETH, scene};
use calyx_runtime::observables::{MaxContactPressure, MaxRootStress, MeshStiffness, TransmissionError};

const QUADRATIC: StructureOptions = StructureOptions { order: 2, axial_order: Some(2), ..MESH };
/// The same as in `first_day_in_space`.
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

/// Pair of equal gears of twenty teeth, compared with cubic elements, which other tests condense as
/// well.
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
