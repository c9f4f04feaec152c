//! Effectivities in three dimensions, at few positions: quadratic elements compared with cubic
//! ones, cubic ones with half as many more of them along every direction, which have three layers
//! along the fillet, and helical teeth, whose error along the face a higher order there shows.
//! `cargo bench -p calyx-gears --bench convergence -- medium` shows the convergence of cubic
//! elements.

use super::*;
use crate::first_day_solid::{BODIES, MESH as TEETH, scene};
use calyx_runtime::observables::{MaxContactPressure, MaxRootStress, MeshStiffness, TransmissionError};

const QUADRATIC: StructureOptions = StructureOptions { order: 2, axial_order: Some(2), ..MESH };
/// The same as in `first_day_solid`.
const CUBIC: StructureOptions = StructureOptions { face_elements: Some(2), axial_order: Some(2), ..MESH };
const SPACE: Setting =
    Setting { fidelity: "medium", structure: QUADRATIC, cells: Some([6, 4]), steps: 2, ..PLANE };

#[test]
fn estimates_of_a_solid_pair() {
    let finer = Setting { structure: MESH, estimates: Estimates::None, ..SPACE };
    let cases = [Case { name: "in space", setting: SPACE, parts: &[Part::Discretization] }];
    let wrong = wrong(&PLAIN, &finer, &cases);
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Pair of equal gears of twenty teeth, compared with a finer mesh.
fn wrong_of_a_pair(name: &str, helix_angle: f64, [own, finer]: [StructureOptions; 2]) -> Vec<String> {
    let mut scene = scene(helix_angle);
    let outputs = vec![
        OutputRequest::observing("te", scene.add_observable(TransmissionError(TEETH))),
        OutputRequest::observing("stiffness", scene.add_observable(MeshStiffness(TEETH))),
        OutputRequest::observing("pressure", scene.add_observable(MaxContactPressure(TEETH))),
        OutputRequest::observing("pinion", scene.add_observable(MaxRootStress(BODIES[0]))),
        OutputRequest::observing("wheel", scene.add_observable(MaxRootStress(BODIES[1]))),
    ];
    let cycle = scene.pairs[TEETH.0].mesh.clone().expect("a mesh");
    let finer = Setting { structure: finer, estimates: Estimates::None, ..SPACE };
    let exact = analyse_scene((scene.clone(), &cycle), &outputs, &finer);
    let (own, _) = analyse_scene((scene, &cycle), &outputs, &Setting { structure: own, ..SPACE });
    effectivities(name, &[Part::Discretization], &own, &exact)
}

#[test]
fn of_cubic_elements() {
    let of = |refinement| StructureOptions { refinement, ..CUBIC };
    let wrong = wrong_of_a_pair("cubic", 0.0, [of(1.0), of(1.5)]);
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn of_helical_teeth() {
    let finer = StructureOptions { axial_order: Some(4), ..CUBIC };
    let wrong = wrong_of_a_pair("helical", 0.35, [StructureOptions { order: 2, ..CUBIC }, finer]);
    assert!(wrong.is_empty(), "{wrong:#?}");
}
