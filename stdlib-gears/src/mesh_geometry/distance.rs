//! Messages about a centre distance at which two gears cannot mesh: the distance without backlash
//! that follows from the data, and mistakes in the unit.

use super::{MeshGeometry, ROUNDING_OF_DATA};
use crate::error::{GeometryError, Sentence, sentence};
use crate::plausibility::meant;

/// Codes of tips that touch a fillet or a root circle.
const INTERFERENCE: [&str; 2] = ["E0634", "E0636"];

/// Largest relative difference of two centre distances that one mistake in the unit explains.
const NEAR_DISTANCE: f64 = 0.1;

impl MeshGeometry {
    /// Replaces interference of tips by the overlap of the teeth that causes it: with negative
    /// backlash, if there is no interference at the centre distance without backlash. `judged`
    /// returns the errors at another centre distance.
    pub(super) fn blame_overlap(
        &self,
        mut errors: Vec<GeometryError>,
        judged: impl FnOnce(f64) -> Option<Vec<GeometryError>>,
    ) -> Vec<GeometryError> {
        let is_interference = |error: &GeometryError| INTERFERENCE.contains(&error.code);
        if self.normal_backlash >= -ROUNDING_OF_DATA * self.base_pitch || !errors.iter().any(is_interference)
        {
            return errors;
        }
        let Some(distance) = self.zero_backlash_center_distance else { return errors };
        if judged(distance).is_none_or(|errors| errors.iter().any(is_interference)) {
            return errors;
        }
        errors.retain(|error| !is_interference(error));
        let apart = if self.internal { "at most" } else { "at least" };
        errors.push(GeometryError::error(
            "E0930",
            "second",
            sentence![
                "the teeth overlap by ", length -self.backlash, " at a centre distance of ", length self.center_distance,
                ": they have no backlash at ", length distance
            ],
            match unit_slip(self.center_distance, distance) {
                Some(meant) => sentence!["is a centre distance of ", length meant, " meant?"],
                None => sentence![
                    "place the frames ", text apart, " ", length distance, " apart, or make the teeth thinner"
                ],
            },
        ));
        errors
    }
}

/// Returns the centre distance in the unit that was probably meant, m, if it is near `expected`.
fn unit_slip(center_distance: f64, expected: f64) -> Option<f64> {
    let near = (1.0 - NEAR_DISTANCE) * expected..=(1.0 + NEAR_DISTANCE) * expected;
    meant(center_distance, &near)
}

/// Help for axes at a distance at which the teeth cannot mesh.
pub(super) fn expected_distance(
    direction: &'static str,
    center_distance: f64,
    standard: f64,
    zero_backlash: Option<f64>,
) -> Sentence {
    let expected = zero_backlash.unwrap_or(standard);
    let slip = match unit_slip(center_distance, expected) {
        Some(meant) => sentence!["is a centre distance of ", length meant, " meant? "],
        None => sentence![],
    };
    let place = match zero_backlash {
        Some(distance) => sentence![
            "place the frames ", text direction, ", near ", length distance, ", the distance without backlash"
        ],
        None => sentence![
            "place the frames ", text direction, ", near the standard distance of ", length standard
        ],
    };
    Sentence(slip.0.into_iter().chain(place.0).collect())
}
