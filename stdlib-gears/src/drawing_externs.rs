//! Data of gears and pairs for comparison with a drawing: the Rust side of `center_distance`,
//! `sum_of_shifts` and the diameters of a gear in `gears.cx`.

use crate::error::{GeometryError, sentence};
use crate::externs::host;
use crate::involute::{inverse_involute, involute};
use crate::prototype::GearPrototype;
use calyx_abi::externs::Handle;
use calyx_abi::{Context, RuntimeError, math};

calyx_abi::externs! {
    Pure fn calyx_gears_center_distance(context, first: Handle, second: Handle) -> f64 {
        let found = pair(context, first, second, |pair| pair.center_distance());
        report(context, found?)
    }

    Pure fn calyx_gears_sum_of_shifts(context, first: Handle, second: Handle, center_distance: f64) -> f64 {
        let found = pair(context, first, second, |pair| pair.sum_of_shifts(center_distance));
        report(context, found?)
    }

    Pure fn calyx_gears_profile_shift(context, gear: Handle) -> f64 {
        let gear = host(context)?.cylindrical("gear", gear)?;
        Ok(profile_shift_of(gear, gear.form().tooth_thickness))
    }

    Pure fn calyx_gears_normal_module(context, gear: Handle) -> f64 {
        Ok(normal_module(host(context)?.cylindrical("gear", gear)?))
    }

    Pure fn calyx_gears_transverse_thickness(context, gear: Handle) -> f64 {
        Ok(host(context)?.cylindrical("gear", gear)?.form().tooth_thickness)
    }

    Pure fn calyx_gears_reference_diameter(context, gear: Handle) -> f64 {
        Ok(2.0 * host(context)?.cylindrical("gear", gear)?.form().pitch_radius)
    }

    Pure fn calyx_gears_tip_diameter(context, gear: Handle) -> f64 {
        Ok(2.0 * host(context)?.cylindrical("gear", gear)?.form().tip_radius)
    }

    Pure fn calyx_gears_root_form_diameter(context, gear: Handle) -> f64 {
        Ok(2.0 * host(context)?.cylindrical("gear", gear)?.form().form_radius)
    }

    Pure fn calyx_gears_root_diameter(context, gear: Handle) -> f64 {
        Ok(2.0 * host(context)?.cylindrical("gear", gear)?.form().root_radius)
    }
}

fn report(context: &mut Context, found: Result<f64, GeometryError>) -> Result<f64, RuntimeError> {
    let place = context.place;
    let host = host(context)?;
    found.map_err(|error| host.runtime_error(&error, place))
}

fn pair<T>(
    context: &mut Context,
    first: Handle,
    second: Handle,
    answer: impl FnOnce(&Pair) -> Result<T, GeometryError>,
) -> Result<Result<T, GeometryError>, RuntimeError> {
    let host = host(context)?;
    let (first, second) = (host.cylindrical("first", first)?, host.cylindrical("second", second)?);
    Ok(Pair::new(first, second).and_then(|pair| answer(&pair)))
}

/// Normal module of a gear, m.
pub(crate) fn normal_module(gear: &GearPrototype) -> f64 {
    gear.form().module * math::cos(gear.helix.angle())
}

/// Profile shift coefficient of a transverse tooth thickness (m) in normal modules:
/// `(s_n / m_n - pi/2) / (2 tan alpha_n)`, positive outwards for an internal gear too.
pub(crate) fn profile_shift_of(gear: &GearPrototype, thickness: f64) -> f64 {
    let form = gear.form();
    let cosine = math::cos(gear.helix.angle());
    let widened = thickness / form.module - 0.5 * std::f64::consts::PI;
    form.sense() * widened / (2.0 * math::tan(form.pressure_angle) * cosine)
}

/// Transverse data of two gears without backlash.
struct Pair {
    /// Sum of the reference radii, or their difference for an internal gear, m.
    reference: f64,
    /// Arc by which both gears together exceed a pitch at the reference circles, or the space of
    /// the internal gear exceeds the tooth of its mate, m.
    excess: f64,
    pressure_angle: f64,
    /// Length of excess per unit of the sum of the profile shift coefficients, m.
    per_shift: f64,
}

impl Pair {
    /// # Errors
    /// E0919: the gears do not fit each other.
    fn new(first: &GearPrototype, second: &GearPrototype) -> Result<Pair, GeometryError> {
        let [a, b] = [first.form(), second.form()];
        if a.internal || (b.internal && a.teeth >= b.teeth) {
            return Err(GeometryError::error(
                "E0919",
                "first",
                sentence![
                    "the first gear of a pair is external, with fewer teeth than an internal second one"
                ],
                sentence!["exchange the two gears"],
            ));
        }
        let modules = (a.module - b.module).abs() > 1e-6 * a.module;
        if modules || (a.pressure_angle - b.pressure_angle).abs() > 1e-6 {
            return Err(GeometryError::error(
                "E0919",
                "second",
                sentence![
                    "the gears have transverse modules of ", length a.module, " and ", length b.module,
                    ", and transverse pressure angles of ", angle a.pressure_angle, " and ", angle b.pressure_angle
                ],
                sentence!["give both gears the same normal module, pressure angle and helix angle"],
            ));
        }
        let pitch = std::f64::consts::PI * a.module;
        // Allowances are the backlash at the nominal centre distance.
        let both =
            (a.tooth_thickness - first.stated.allowance) + (b.tooth_thickness - second.stated.allowance);
        let (reference, excess) = match b.internal {
            false => (a.pitch_radius + b.pitch_radius, both - pitch),
            true => (b.pitch_radius - a.pitch_radius, pitch - both),
        };
        let normal = math::cos(first.helix.angle());
        let per_shift = 2.0 * a.module * normal * math::tan(a.pressure_angle);
        Ok(Pair { reference, excess, pressure_angle: a.pressure_angle, per_shift })
    }

    /// `a = a_d cos alpha_t / cos alpha_wt` (ISO 21771:2007, clause 5).
    fn center_distance(&self) -> Result<f64, GeometryError> {
        let value = involute(self.pressure_angle) + 0.5 * self.excess / self.reference;
        if value < 0.0 {
            return Err(GeometryError::error(
                "E0919",
                "second",
                sentence![
                    "these gears have no centre distance without backlash: the teeth would touch inside the base circles"
                ],
                sentence!["increase the sum of the profile shift coefficients"],
            ));
        }
        // Gears without profile shift run at the reference centre distance, exactly.
        if self.excess == 0.0 {
            return Ok(self.reference);
        }
        Ok(self.reference * math::cos(self.pressure_angle) / math::cos(inverse_involute(value)))
    }

    /// `x_1 + x_2 = (z_1 + z_2) (inv alpha_wt - inv alpha_t) / (2 tan alpha_n)`.
    fn sum_of_shifts(&self, center_distance: f64) -> Result<f64, GeometryError> {
        let least = self.reference * math::cos(self.pressure_angle);
        if center_distance < least {
            return Err(GeometryError::error(
                "E0919",
                "center_distance",
                sentence![
                    "the centre distance of ", length center_distance, " is smaller than the base circles allow, ",
                    at_least length least
                ],
                sentence!["give a distance near the reference centre distance of ", length self.reference],
            ));
        }
        let working = math::acos(least / center_distance);
        Ok(2.0 * self.reference * (involute(working) - involute(self.pressure_angle)) / self.per_shift)
    }
}
