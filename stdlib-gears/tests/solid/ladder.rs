//! Three-dimensional fidelity levels without meshes.

use super::pairs::{FIRST, MESH, Options};
use crate::common::built;
use calyx_gears::assembly::Misalignment;
use calyx_gears::helix::Hand;
use calyx_runtime::observables::Observe;
use calyx_runtime::observables::{
    MaxRootStress, MeshStiffness, Observable, TransmissionError, UnloadedTransmissionError,
};
use calyx_runtime::plan::Plan;
use calyx_runtime::scene::{Fidelity, StructureOptions, Template};

const CYCLE: [f64; 3] = [0.1, 0.4, 0.9];

/// Returns whether the scene was three-dimensional, and at fractions of its cycle the transmission
/// error, the unloaded one, the stiffness and the root stress.
fn seen(options: &Options, fidelity: Fidelity) -> (bool, Vec<[f64; 4]>) {
    let structure = StructureOptions::default();
    let (mut scene, mesh) = options.scene();
    scene.add_observable(MaxRootStress(FIRST));
    let plan = Plan::new(&scene, fidelity, structure).expect("a plan");
    let system = built(&scene, fidelity, structure);
    let at = |cycle: &f64| {
        let step = system.solve(mesh.start + cycle * mesh.period).expect("equilibrium");
        let value = |observable: &dyn Observable| system.value(&step, observable).value;
        let elastic = fidelity != Fidelity::Rigid;
        [
            value(&TransmissionError(MESH)),
            value(&UnloadedTransmissionError(MESH)),
            if elastic { value(&MeshStiffness(MESH)) } else { 0.0 },
            if elastic { value(&MaxRootStress(FIRST)) } else { 0.0 },
        ]
    };
    (plan.three_dimensional, CYCLE.iter().map(at).collect())
}

fn elastic(options: Options) -> Options {
    Options { backed: false, ..options }
}

/// A tiny helix angle makes the model three-dimensional with the results of the plane model, except
/// at the ends of the face: there the half-space is more compliant than the plane model by a part
/// of its near field.
#[test]
fn slices_of_straight_teeth_are_the_plane() {
    let (three_dimensional, plane) = seen(&elastic(Options::spur()), Fidelity::Analytic);
    assert!(!three_dimensional);
    let (three_dimensional, space) = seen(&elastic(Options::helical(1e-7, Hand::Right)), Fidelity::Analytic);
    assert!(three_dimensional);
    for ([error, unloaded, stiffness, stress], [of_plane, none, of_mesh, root]) in space.iter().zip(&plane) {
        assert!(((error - unloaded) / (of_plane - none) - 1.0).abs() < 0.02, "{error} {of_plane}");
        assert!((stiffness / of_mesh - 1.0).abs() < 0.02, "{stiffness} {of_mesh}");
        assert!((stress / root - 1.0).abs() < 0.1, "{stress} {root}");
    }
}

/// Helical teeth bend in the normal section, which is thinner than the transverse one. Compared
/// with finite elements whose root stresses are within 1 % of their limit ("fineroot"). The helix
/// adds no error to that of spur teeth, so the limit is that of
/// `ladder::closed_forms_are_near_the_finite_elements` for root stresses; nothing is fitted.
#[test]
fn helical_teeth_give_as_finite_elements() {
    let options = elastic(Options { half_cells: [4, 4], ..Options::helical(0.35, Hand::Right) });
    let (_, given) = seen(&options, Fidelity::Analytic);
    let (_, meshed) = seen(&options, Fidelity::Solid(Template::FineRoot));
    for ([error, _, stiffness, stress], [of_mesh, _, meshed, root]) in given.iter().zip(&meshed) {
        println!("{} {} {}", error / of_mesh, stiffness / meshed, stress / root);
        assert!((error / of_mesh - 1.0).abs() < 0.1, "{error} {of_mesh}");
        assert!((stiffness / meshed - 1.0).abs() < 0.1, "{stiffness} {meshed}");
        assert!((stress / root - 1.0).abs() < 0.1, "{stress} {root}");
    }
}

/// Rigid helical teeth have no transmission error on parallel axes. On other axes they equal
/// elastic teeth without load.
#[test]
fn rigid_helical_teeth() {
    let (three_dimensional, rigid) = seen(&elastic(Options::helical(0.3, Hand::Left)), Fidelity::Rigid);
    assert!(three_dimensional);
    for [error, ..] in rigid {
        assert!(error.abs() < 1e-9, "{error}");
    }
    let leaning = Misalignment { in_action: 1e-3, ..Misalignment::default() };
    let askew = elastic(Options { misalignment: leaning, ..Options::helical(0.3, Hand::Left) });
    let (_, rigid) = seen(&askew, Fidelity::Rigid);
    let (_, given) = seen(&askew, Fidelity::Analytic);
    for ([error, ..], [loaded, unloaded, stiffness, _]) in rigid.into_iter().zip(given) {
        assert_eq!(error.to_bits(), unloaded.to_bits());
        assert!(error.abs() > 1e-6 && loaded > unloaded && stiffness > 0.0, "{error} {loaded} {unloaded}");
    }
}
