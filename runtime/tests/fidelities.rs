//! Tests of fidelity levels and 3-D mesh options: names, ranges, and rejection for bodies without a
//! 3-D model.

use calyx_runtime::disc::Disc;
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::material::Material;
use calyx_runtime::scene::{Fidelity, Prototype, StructureOptions};

#[test]
fn fidelities_are_known_by_their_names() {
    for fidelity in Fidelity::ALL {
        assert_eq!(Fidelity::named(fidelity.name()), Some(fidelity));
    }
    assert_eq!(Fidelity::named("solid"), None);
}

#[test]
fn a_face_has_elements_of_some_order() {
    let with =
        |face_elements, axial_order| StructureOptions { face_elements, axial_order, ..Default::default() };
    assert_eq!(with(None, None).check(), Ok(()));
    assert_eq!(with(Some(1), Some(8)).check(), Ok(()));
    for (options, argument) in [
        (with(Some(0), None), "face_elements"),
        (with(Some(65), None), "face_elements"),
        (with(None, Some(0)), "displacement_order"),
        (with(Some(4), Some(9)), "displacement_order"),
    ] {
        let error = options.check().unwrap_err();
        assert_eq!((error.code, error.argument), ("E0691", Some(argument)));
    }
}

#[test]
fn a_body_with_a_plane_model_only_has_no_solid_model() {
    let disc = Disc::new(0.05, 0.02, Material::STEEL);
    let built = disc.build_solid(&StructureOptions::default(), &Interrupt::never());
    assert_eq!(built.err().map(|error| error.code), Some("E0690"));
}
