//! Strain gauges in tooth fillets. A gauge has a radius or a tangent angle on the fillet, an axial
//! position and a direction.
//!
//! The tangent angle is the angle between the fillet's tangent and the tooth's centreline. The
//! critical section is at 30 degrees for external teeth and at 60 degrees for internal teeth (ISO
//! 6336-3).

use crate::error::{GeometryError, Refusal, sentence};
use crate::externs::{self, entry, host, tooth_number};
use crate::fillet::{RootFillet, Side};
use crate::gear::Gear;
use crate::host::keep;
use crate::observable_externs::observe;
use crate::prototype::GearPrototype;
use calyx_abi::externs::Handle;
use calyx_runtime::observables::{FilletSide, Gauge, GaugeReading, Reading};
use calyx_runtime::profile::Profile;

/// Position of a gauge along a fillet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FilletLocation {
    /// Radius, m.
    Radius(f64),
    /// Angle between the tangent and the tooth's centreline, rad.
    TangentAngle(f64),
}

/// Requested strain gauge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GaugePlacement {
    /// Position of its middle along the fillet.
    pub along: FilletLocation,
    /// Axial position of its middle from mid-face, m.
    pub axial: f64,
    /// Direction, from the profile (towards the root) to the positive axis, rad.
    pub direction: f64,
    /// Gauge length over which the strain is averaged, m; 0 for a point.
    pub length: f64,
}

impl GaugePlacement {
    /// Middle of the gauge on the fillet of a gear: arc length along the profile from the form
    /// circle, and axial position, m.
    ///
    /// # Errors
    /// E0689: the gauge is not within the fillet.
    pub fn on(&self, gear: &GearPrototype) -> Result<[f64; 2], GeometryError> {
        let fillet = gear.gear.root_fillet(Side::CounterClockwise);
        let s = on_fillet(&gear.gear, &fillet, self.along)?;
        let point = fillet.at(s);
        let ([x, y], [tx, ty]) = (point.position, point.tangent);
        // The axial line of a helical fillet is inclined to the axis both along the profile and
        // across it.
        let twist = gear.twist_per_length();
        let (leans, bulges) = (twist * (x * ty - y * tx), twist * (x * tx + y * ty));
        let across = 1.0_f64.hypot(bulges);
        let half = 0.5 * self.length;
        let (sine, cosine) = self.direction.sin_cos();
        let reach = [half * (cosine.abs() + (leans * sine / across).abs()), half * (sine / across).abs()];
        let off = |argument, message| {
            let help = sentence!["place it within the fillet, or give it a smaller `length`"];
            Err(GeometryError::error("E0689", argument, message, help))
        };
        let half_face = 0.5 * gear.face_width;
        let end = self.axial.abs() + reach[1];
        if end.is_nan() || end > half_face * (1.0 + 1e-12) {
            return off(
                "axial_position",
                sentence![
                    "a gauge that reaches to ", length end,
                    " from mid-face is not on a face that ends at ", length half_face
                ],
            );
        }
        if !(self.length >= 0.0 && s - reach[0] >= -1e-12 && s + reach[0] <= fillet.length() + 1e-12) {
            return off(
                "length",
                sentence![
                    "a gauge of length ", length self.length, " does not fit into the fillet, of which ", length s,
                    " are above its middle and ", length fillet.length() - s, " below"
                ],
            );
        }
        Ok([s, self.axial])
    }
}

/// Arc length from the form circle, m.
fn on_fillet(gear: &Gear, fillet: &RootFillet, along: FilletLocation) -> Result<f64, GeometryError> {
    let form = gear.form();
    let radius = |s: f64| {
        let [x, y] = fillet.at(s).position;
        x.hypot(y)
    };
    let leaning = |s: f64| {
        let [x, y] = fillet.at(s).tangent;
        y.abs().atan2(x.abs())
    };
    let end = fillet.fillet_length();
    let found = match along {
        // On an external gear the radius decreases towards the root.
        FilletLocation::Radius(wanted) => {
            crossing(|s| form.sense() * (wanted - radius(s)), [0.0, end], 1e-9 * form.pitch_radius)
        }
        FilletLocation::TangentAngle(wanted) => crossing(|s| leaning(s) - wanted, [0.0, end], 1e-9),
    };
    found.ok_or_else(|| match along {
        FilletLocation::Radius(wanted) => GeometryError::error(
            "E0689",
            "radius",
            sentence!["the fillet does not reach the radius ", length wanted],
            sentence!["it lies between the radii ", length radius(0.0), " and ", length radius(end)],
        ),
        FilletLocation::TangentAngle(wanted) => GeometryError::error(
            "E0689",
            "tangent_angle",
            sentence!["the fillet is nowhere inclined by ", angle wanted, " to the tooth's centre line"],
            sentence!["its tangents lean by ", angle leaning(0.0), " to ", angle leaning(end)],
        ),
    })
}

/// Zero of an increasing function between two ends; a zero outside of the ends by at most a
/// tolerance counts as well.
fn crossing(value: impl Fn(f64) -> f64, [mut low, mut high]: [f64; 2], tolerance: f64) -> Option<f64> {
    if !(value(low) <= tolerance && value(high) >= -tolerance) {
        return None;
    }
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if value(middle) < 0.0 { low = middle } else { high = middle }
    }
    Some(0.5 * (low + high))
}

/// Side of the teeth by its declared name. Seen against e3 with the tip up, the counter-clockwise
/// flank, number 0, is on the left of an external tooth.
fn side_named(side: &str, internal: bool) -> FilletSide {
    match side {
        "loaded" => FilletSide::Loaded,
        "other" => FilletSide::Other,
        _ => FilletSide::Flank(u32::from((side == "left") == internal)),
    }
}

calyx_abi::externs! {
    Scene fn calyx_gears_gauge(
        context, body: Handle, radius: Option<f64>, tangent_angle: f64, axial_position: f64, direction: f64,
        length: f64, side: String, tooth: Option<f64>,
    ) -> Handle {
        let id = externs::body(context, "body", body)?;
        let tooth = tooth.map(|tooth| tooth_number(host(context)?, id, tooth)).transpose()?;
        let (place, host) = (context.place, host(context)?);
        let gear = host.gear_on("body", id)?.clone();
        let along = radius.map_or(FilletLocation::TangentAngle(tangent_angle), FilletLocation::Radius);
        let placed = GaugePlacement { along, axial: axial_position, direction, length }.on(&gear);
        let placed = placed.map_err(|error| host.rejected(Refusal::from(error), place))?;
        let gauge = Gauge {
            body: id, place: placed, direction, length, side: side_named(&side, gear.form().internal), tooth,
            material: gear.material,
        };
        Ok(keep(&mut host.gauges, gauge))
    }

    Scene fn calyx_gears_gauge_strain(context, gauge: Handle) -> Handle {
        let gauge = *entry(&host(context)?.gauges, gauge)?;
        observe(context, GaugeReading(gauge, Reading::Strain))
    }

    Scene fn calyx_gears_gauge_stress(context, gauge: Handle) -> Handle {
        let gauge = *entry(&host(context)?.gauges, gauge)?;
        observe(context, GaugeReading(gauge, Reading::Stress))
    }

    Scene fn calyx_gears_gauge_principal_stress(context, gauge: Handle, which: String) -> Handle {
        let gauge = *entry(&host(context)?.gauges, gauge)?;
        let reading = if which == "largest" { Reading::LargestPrincipal } else { Reading::SmallestPrincipal };
        observe(context, GaugeReading(gauge, reading))
    }
}
