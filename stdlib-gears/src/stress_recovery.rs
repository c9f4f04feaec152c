//! Stress recovery in nearly incompressible materials.

use calyx_runtime::error::EngineError;
use calyx_runtime::material::Material;
use calyx_runtime::scene::StructureOptions;

/// Largest Poisson's ratio for which elements of order below three recover stress to about one
/// percent. Above, volumetric locking makes the error exceed the stress.
const MOST_LATERAL_STRAIN: f64 = 0.45;

/// Checks that the elements of a mesh can recover the stress of a material.
///
/// # Errors
/// E0661: stress recovery is requested and these elements do not provide it.
pub(crate) fn check_recovery(material: &Material, options: &StructureOptions) -> Result<(), EngineError> {
    let ratio = material.poissons_ratio;
    if !options.stresses || options.order > 2 || ratio <= MOST_LATERAL_STRAIN {
        return Ok(());
    }
    Err(EngineError::new(
        "E0661",
        format!(
            "elements of order {} do not know the stress of a material that keeps its volume: Poisson's ratio {ratio}, and {MOST_LATERAL_STRAIN} at most",
            options.order
        ),
        "take elements of order 3, or ask for no stress in fillets",
    ))
}
