//! Pairs with their finite elements, on coarse meshes.

use super::pairs::{FIRST, MESH, Options, SECOND, TORQUE, system};
use calyx_runtime::observables::Observe;
use calyx_runtime::observables::{
    LoadShare, MaxContactPressure, MaxRootStress, MeshStiffness, Observable, TransmissionError,
};
use calyx_runtime::scene::StructureOptions;

#[test]
fn a_pair_of_elastic_gears_is_in_equilibrium() {
    let structure = StructureOptions {
        refinement: 0.5,
        order: 2,
        face_elements: Some(2),
        axial_order: Some(2),
        ..StructureOptions::default()
    };
    let options = Options { backed: false, ..Options::spur() };
    let (mut scene, mesh) = options.scene();
    for body in [FIRST, SECOND] {
        scene.add_observable(MaxRootStress(body));
    }
    let system = system(&scene, structure);
    // Two tooth pairs share the load, then one carries it alone.
    for (part, pairs) in [(0.1, 2), (0.8, 1)] {
        let step = system.solve(mesh.start + part * mesh.period).expect("it can be solved");
        assert!(step.certificate.largest() <= 1e-12, "{:?}", step.certificate);
        assert!((system.contact_force(&step, FIRST)[5] / TORQUE + 1.0).abs() < 1e-10);
        assert_eq!(step.patches.iter().filter(|patch| patch.force() > 0.0).count(), pairs);
        let value = |observable: &dyn Observable| system.value(&step, observable).value;
        // The stiffness of a steel spur pair is about 14 N/(mm um) for one tooth pair and 20 for
        // two (ISO 6336-1, clause 9); mean and tangent stiffness are slightly above the first.
        let per_width = value(&MeshStiffness(MESH)) / options.face_width * 1e-9;
        assert!((pairs as f64 * 10.0..pairs as f64 * 20.0).contains(&per_width), "{per_width}");
        assert!(value(&TransmissionError(MESH)) > 0.0);
        assert!((value(&LoadShare(MESH)) - 1.0 / pairs as f64).abs() < 0.15);
        assert!((0.8e9..1.6e9).contains(&value(&MaxContactPressure(MESH))));
        for body in [FIRST, SECOND] {
            let stress = system.value(&step, &MaxRootStress(body));
            assert!((80e6..300e6).contains(&stress.value), "{}", stress.value);
            assert!(stress.location.is_some());
        }
    }
}
