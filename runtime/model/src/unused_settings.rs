//! Settings of an analysis that the model of a fidelity level does not have.

use crate::fidelity::{Fidelity, StructureOptions};
use crate::mechanism::Mechanism;
use crate::pairs::GridOptions;
use crate::prototype::Ignored;

/// Returns the settings of three-dimensional meshes and contact grids that the model does not have.
pub fn unused_settings(
    scene: &Mechanism,
    fidelity: Fidelity,
    three_dimensional: bool,
    options: &StructureOptions,
) -> Vec<Ignored> {
    let reason = match fidelity {
        Fidelity::Rigid => Some("rigid bodies have no elements"),
        Fidelity::Analytic => Some("closed forms of the compliance have no elements"),
        Fidelity::Plane => Some("a two-dimensional model has no elements along the face"),
        Fidelity::Solid(_) => None,
    };
    let elements = [("face_elements", options.face_elements), ("displacement_order", options.axial_order)];
    let given = |(input, count): (&str, Option<usize>)| {
        let (_, reason) = count.zip(reason)?;
        Some(Ignored { input: input.into(), reason: reason.into() })
    };
    let mut found: Vec<Ignored> = elements.into_iter().filter_map(given).collect();
    let slices = GridOptions::default().half_slices;
    if !three_dimensional && scene.pairs.iter().any(|pair| pair.grid.half_slices != slices) {
        let reason = "a two-dimensional model has no slices along the face".into();
        found.push(Ignored { input: "contact_slices".into(), reason });
    }
    found
}
