//! Strain gauges as engineers place them: in a fillet at a radius or where its tangent leans by an angle, along the face, in a direction.
//!
//! The tangent angle is that between the fillet and the tooth's centre line: critical sections of external teeth are sought at 30 degrees, of
//! internal ones at 60 (ISO 6336-3).

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

/// What a gauge is at, along a fillet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FilletLocation {
    /// m
    Radius(f64),
    /// Between the tangent and the tooth's centre line, rad.
    TangentAngle(f64),
}

/// A gauge as it is asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GaugePlacement {
    /// Where its middle is along the fillet.
    pub along: FilletLocation,
    /// And along the axis from mid-face, m.
    pub axial: f64,
    /// From the profile, rootwards, towards the positive axis, rad.
    pub direction: f64,
    /// Over which it averages, m; 0 for a point.
    pub length: f64,
}

impl GaugePlacement {
    /// The middle on the fillet of a gear: along the profile from the form circle, and along the axis, m.
    ///
    /// # Errors
    /// E0689: the gauge is not within the fillet.
    pub fn on(&self, gear: &GearPrototype) -> Result<[f64; 2], GeometryError> {
        let fillet = gear.gear.root_fillet(Side::CounterClockwise);
        let s = on_fillet(&gear.gear, &fillet, self.along)?;
        let point = fillet.at(s);
        let ([x, y], [tx, ty]) = (point.position, point.tangent);
        // A helix leans against the axis both along the profile and across it.
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
                "axial",
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
        // Outside of a gear radii fall towards the root.
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

/// Where a function that grows is zero between two ends, at which it may be off by a tolerance.
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

/// A side of teeth as it is declared. Seen against e3 with the tip up, the counter-clockwise flank, which is number 0, is on the left of a tooth that points
/// outwards.
fn side_named(side: &str, internal: bool) -> FilletSide {
    match side {
        "loaded" => FilletSide::Loaded,
        "other" => FilletSide::Other,
        _ => FilletSide::Flank(u32::from((side == "left") == internal)),
    }
}

calyx_abi::externs! {
    Scene fn calyx_gears_gauge(
        context, body: Handle, radius: f64, tangent_angle: f64, axial: f64, direction: f64, length: f64, side: String,
        tooth: f64,
    ) -> Handle {
        let id = externs::body(context, "body", body)?;
        let tooth = if tooth == -1.0 { None } else { Some(tooth_number(host(context)?, id, tooth)?) };
        let (place, host) = (context.place, host(context)?);
        let gear = host.gear_on("body", id)?.clone();
        let along = if radius == 0.0 { FilletLocation::TangentAngle(tangent_angle) } else { FilletLocation::Radius(radius) };
        let placed = GaugePlacement { along, axial, direction, length }.on(&gear);
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
