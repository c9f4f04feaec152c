//! Rolling bearings from catalogue data: `catalogue_bearing` of `gears.cx`.

use crate::bearing_externs::Mounting;
use crate::externs::{host, refusal};
use crate::rolling_externs::{add, arranged, rejected, rib};
use calyx_abi::externs::Handle;
use calyx_runtime::rolling::catalogue::{CatalogueData, estimate_balls, estimate_rollers};
use calyx_runtime::rolling::{
    BallKind, BallRow, Elements, Motion, Rib, RollerGeometry, RollerKind, RollerRow, RollingError,
};

calyx_abi::externs! {
    Scene fn calyx_gears_catalogue_bearing(
        context, name: String, body: Handle, to: Handle, at: [f64; 3], kind: String, bore: f64,
        outside_diameter: f64, width: f64, dynamic_rating: f64, static_rating: f64, contact_angle: Option<f64>,
        clearance: f64, thrust: String, axial_preload: f64, ring: String, azimuth: f64, inner_speed: f64,
        outer_speed: f64,
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
        let found = estimated(&kind, &data, angle, clearance).map_err(rejected)?;
        let message = format!(
            "the internal geometry of \"{}\" is estimated from catalogue data: {}",
            mounting.name, found.description
        );
        let place = context.place;
        host(context)?.warn("E0699", message, "give the internal geometry where the manufacturer states it", place);
        let rows = arranged(found.elements, ("single", None), (&thrust, &ring), axial_preload)?;
        let motion = Motion { inner_speed, outer_speed, azimuth, ..Motion::REST };
        add(context, mounting, rows, (motion, &ring), if angled { "axial_preload" } else { "clearance" })
    }
}

/// Elements with the load ratings of a catalogue.
struct Estimated {
    elements: Elements,
    /// Dimensions and agreement with the load ratings, in words.
    description: String,
}

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
            "{} balls of {:.3} mm on a pitch circle of {:.3} mm",
            g.count,
            1e3 * g.ball_diameter,
            1e3 * g.pitch_diameter
        );
        let description = agreement(&dimensions, [found.dynamic_deviation, found.static_deviation]);
        Ok(Estimated { elements: BallRow::new(found.geometry)?.into(), description })
    };
    let rollers = |kind: RollerKind| {
        let found = estimate_rollers(data, kind)?;
        let g = &found.geometry;
        let dimensions = format!(
            "{} rollers of {:.3} mm diameter and {:.3} mm length on a pitch circle of {:.3} mm",
            g.count,
            1e3 * g.roller_diameter,
            1e3 * g.length,
            1e3 * g.pitch_diameter
        );
        let description = agreement(&dimensions, [found.dynamic_deviation, found.static_deviation]);
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

fn agreement(dimensions: &str, [dynamic, fixed]: [f64; 2]) -> String {
    format!(
        "{dimensions}; their load ratings are within {:.1} % of C and {:.1} % of C0",
        1e2 * dynamic.abs(),
        1e2 * fixed.abs()
    )
}
