//! Rolling bearings from catalogue data: `catalogue_bearing` of `gears.cx`.

use crate::bearing_externs::Mounting;
use crate::bearing_sizes::Boundary;
use crate::externs::{host, refusal};
use crate::rolling_externs::{Operation, add, arranged, rejected, rib, unused};
use calyx_abi::externs::Handle;
use calyx_runtime::rolling::catalogue::{CatalogueData, estimate_balls, estimate_rollers};
use calyx_runtime::rolling::{
    BallKind, BallRow, Elements, Rib, RollerGeometry, RollerKind, RollerRow, RollingError,
};

calyx_abi::externs! {
    Scene fn calyx_gears_catalogue_bearing(
        context, name: String, body: Handle, to: Handle, at: [f64; 3], kind: String, bore: f64,
        outside_diameter: f64, width: f64, dynamic_rating: f64, static_rating: f64, contact_angle: Option<f64>,
        clearance: Option<f64>, thrust: Option<String>, axial_preload: Option<f64>, ring: String, azimuth: f64,
        inner_speed: f64, outer_speed: f64, linearized_at: Option<[f64; 3]>,
    ) -> Handle {
        let mounting = Mounting::new(context, name, body, to, at)?;
        let data = CatalogueData { bore, outside_diameter, width, dynamic_rating, static_rating };
        let angled = ["angular_contact_ball", "tapered_roller"].contains(&kind.as_str());
        let angle = match contact_angle {
            Some(angle) => angle,
            None if angled => {
                let message = format!("the bearing \"{}\" has no contact angle", mounting.name);
                let help = "give `contact_angle`; it is not among the catalogue data that determine the elements";
                return Err(refusal("E0697", "kind", &message, help));
            }
            None => 0.0,
        };
        let given = [
            ("contact_angle", contact_angle.is_some(), !angled),
            ("thrust", thrust.is_some(), !angled),
            ("axial_preload", axial_preload.is_some(), !angled),
            ("clearance", clearance.is_some(), angled),
        ];
        for (argument, is_given, is_unused) in given {
            if is_given && is_unused {
                let reason = if angled { "the axial position of its rings determines its clearance" } else { "it has no contact angle" };
                let other = if angled { "give `axial_preload`, which is negative for clearance" } else { "choose a `kind` with a contact angle" };
                unused(context, &mounting, argument, reason, other)?;
            }
        }
        let found = estimated(&kind, &data, angle, clearance.unwrap_or(0.0)).map_err(rejected)?;
        let message = format!(
            "the internal geometry of \"{}\" is estimated from catalogue data: {}",
            mounting.name, found.description
        );
        let place = context.place;
        host(context)?.warn("E0699", message, "give the internal geometry where the manufacturer states it", place);
        let senses = (thrust.as_deref(), ring.as_str());
        let rows = arranged(found.elements, ("single", None), senses, axial_preload.unwrap_or(0.0))?;
        let cause = if angled { "axial_preload" } else { "clearance" };
        let operation = Operation::new(&ring, azimuth, [inner_speed, outer_speed], cause).linearized(linearized_at);
        let bearing = add(context, mounting, rows, &operation, Some(Boundary { bore, outside_diameter, width }))?;
        host(context)?.bearing_ratings.insert(bearing.0 as usize, [dynamic_rating, static_rating]);
        Ok(bearing)
    }
}

/// Elements with the load ratings of a catalogue.
struct Estimated {
    elements: Elements,
    /// Dimensions and agreement with the load ratings, in words.
    description: String,
}

/// Assumptions of the estimates, in words.
const BALLS: &str = "their diameter relative to the section and the conformity of the grooves";
const ROLLERS: &str = "their diameter relative to the section, their spacing and their profile";

fn estimated(
    kind: &str,
    data: &CatalogueData,
    angle: f64,
    clearance: f64,
) -> Result<Estimated, RollingError> {
    let balls = |kind: BallKind| {
        let found = estimate_balls(data, kind)?;
        let g = &found.geometry;
        let dimensions = format!(
            "{} balls of {:.2} mm on a pitch circle of {:.2} mm",
            g.count,
            1e3 * g.ball_diameter,
            1e3 * g.pitch_diameter
        );
        let description = agreement(&dimensions, data, found.dynamic_deviation, BALLS);
        Ok(Estimated { elements: BallRow::new(found.geometry)?.into(), description })
    };
    let rollers = |kind: RollerKind| {
        let found = estimate_rollers(data, kind)?;
        let g = &found.geometry;
        let dimensions = format!(
            "{} rollers of {:.2} mm diameter and {:.2} mm length on a pitch circle of {:.2} mm",
            g.count,
            1e3 * g.roller_diameter,
            1e3 * g.length,
            1e3 * g.pitch_diameter
        );
        let description = agreement(&dimensions, data, found.dynamic_deviation, ROLLERS);
        // The rib follows from the size of the rollers.
        let kind = match kind {
            RollerKind::Tapered { outer_angle, .. } => RollerKind::Tapered {
                outer_angle,
                rib: rib(g.roller_diameter, g.pitch_diameter, outer_angle),
            },
            other => other,
        };
        let geometry = RollerGeometry { kind, ..found.geometry };
        Ok(Estimated { elements: RollerRow::new(geometry)?.into(), description })
    };
    match kind {
        "deep_groove_ball" => balls(BallKind::DeepGroove { clearance }),
        "angular_contact_ball" => balls(BallKind::AngularContact { angle }),
        "tapered_roller" => {
            // A rib on all diameters that the estimate considers.
            let section = 0.5 * (data.outside_diameter - data.bore);
            let pitch = 0.5 * (data.outside_diameter + data.bore);
            let Rib { end_radius, .. } = rib(0.5 * section, pitch, angle);
            rollers(RollerKind::Tapered {
                outer_angle: angle,
                rib: Rib { end_radius, height: 0.05 * section },
            })
        }
        _ => rollers(RollerKind::Cylindrical { clearance }),
    }
}

/// States what the estimate has in common with the catalogue, and what it assumes.
fn agreement(dimensions: &str, data: &CatalogueData, deviation: f64, assumed: &str) -> String {
    format!(
        "{dimensions}. They have the static load rating C0 = {} kN of the catalogue; {assumed} are usual values. The dynamic load rating that ISO 281 gives for them deviates by {:+.0} % from C = {} kN",
        kilo(data.static_rating),
        1e2 * deviation,
        kilo(data.dynamic_rating)
    )
}

/// Converts a load rating to kN.
fn kilo(newtons: f64) -> f64 {
    (newtons * 1e3).round() / 1e6
}
