//! Values of the data block of a gear.

use super::{Value, Values};
use crate::derived_quantities::{PIN, of_gear};
use crate::drawing_externs::{normal_module, profile_shift_of};
use crate::flank_tolerances::FlankTolerances;
use crate::gear::{Gear, ToothForm};
use crate::host::LengthUnit;
use crate::involute::{involute, roll_of_involute};
use crate::prototype::GearPrototype;
use calyx_abi::math;
use calyx_runtime::scene::Prototype;
use std::f64::consts::{FRAC_PI_2, PI};

/// Limits of the tooth thickness in the order upper, mean, lower.
const LIMITS: usize = 3;
const NORMAL: [&str; LIMITS] = ["s_ns", "s_nm", "s_ni"];
const TRANSVERSE: [&str; LIMITS] = ["s_ts", "s_tm", "s_ti"];
const SPAN: [&str; LIMITS] = ["W_ks", "W_km", "W_ki"];
const BALLS: [&str; LIMITS] = ["M_dKs", "M_dKm", "M_dKi"];
/// Difference of root radii, in modules, up to which they are equal.
const SAME_ROOT: f64 = 1e-9;
/// Quantities of [`of_gear`] that are entries of a data block.
const DERIVED: [&str; 11] = ["z", "beta", "beta_b", "p_z", "d", "d_b", "d_a", "d_Fa", "d_Ff", "d_f", "h"];

/// Returns the values of a gear.
pub(super) fn values(gear: &GearPrototype, length: LengthUnit) -> Values {
    let form = gear.form();
    let mut values = Values::new();
    for quantity in of_gear(gear) {
        if let Some(key) = DERIVED.into_iter().find(|key| *key == quantity.symbol) {
            values.insert(key, quantity.value.into());
        }
    }
    let module = normal_module(gear);
    values.insert("type", if form.internal { "internal" } else { "external" }.into());
    if length.name != "mm" {
        values.extend([("P_nd", Value::from(1.0 / module)), ("P_td", (1.0 / form.module).into())]);
    }
    values.extend([
        ("m_n", Value::from(module)),
        ("m_t", form.module.into()),
        ("alpha_n", normal_angle(form.pressure_angle, gear.helix.angle()).into()),
        ("alpha_t", form.pressure_angle.into()),
        ("beta", gear.helix.angle().into()),
        ("b", gear.face_width.into()),
    ]);
    if !gear.helix.is_spur() {
        values.insert("hand", gear.helix.hand().name().into());
    }
    add_rack(&mut values, gear, module);
    add_thicknesses(&mut values, gear);
    separate_generated(&mut values, gear, module);
    if let Some(tolerances) = gear.stated.tolerances {
        add_tolerances(&mut values, &tolerances);
    }
    if let Some(material) = gear.stated.material {
        values.insert("material", material.into());
    }
    let inertia = gear.inertia();
    if inertia.mass > 0.0 {
        values.extend([("mass", Value::from(inertia.mass)), ("inertia", inertia.polar().into())]);
    }
    values
}

/// Adds the flank tolerances of the accuracy grade.
fn add_tolerances(values: &mut Values, tolerances: &FlankTolerances) {
    let [profile, profile_form, profile_slope] = tolerances.profile;
    let [helix, helix_form, helix_slope] = tolerances.helix;
    let grade = format!("{} ({})", tolerances.grade, tolerances.edition.standard());
    values.insert("accuracy_grade", Value::Text(grade));
    values.extend([
        ("f_pt", Value::from(tolerances.f_pt)),
        ("F_p", tolerances.total_pitch.into()),
        ("F_alpha", profile.into()),
        ("f_falpha", profile_form.into()),
        ("f_Halpha", profile_slope.into()),
        ("F_beta", helix.into()),
        ("f_fbeta", helix_form.into()),
        ("f_Hbeta", helix_slope.into()),
        ("F_r", tolerances.runout.into()),
    ]);
}

/// Converts a pressure angle from the transverse to the normal section at a helix angle, rad.
pub(crate) fn normal_angle(transverse: f64, helix: f64) -> f64 {
    // atan(tan(x)) can differ from x in the last digit.
    if helix == 0.0 { transverse } else { math::atan(math::tan(transverse) * math::cos(helix)) }
}

/// Keys of nominal quantities, and of those that the tool generates with the thickness of the
/// analysis. Index `E` stands for quantities that a generating profile shift determines (ISO
/// 21771:2007).
const GENERATED: [(&str, &str); 5] =
    [("d_Ff", "d_FfE"), ("d_f", "d_fE"), ("h", "h_E"), ("s_an", "s_anE"), ("x - x_min", "x_E - x_Emin")];

/// Quantities of the generated gear get their own keys, and nominal values are added, if the
/// analysis uses an allowance of the tooth thickness. The root diameter is nominal if it is stated.
fn separate_generated(values: &mut Values, gear: &GearPrototype, module: f64) {
    if gear.stated.allowance == 0.0 {
        return;
    }
    let root = nominal_root(gear, module);
    for (nominal, generated) in GENERATED {
        if root.is_none() && matches!(nominal, "d_f" | "h") {
            continue;
        }
        if let Some(value) = values.remove(nominal) {
            values.insert(generated, value);
        }
    }
    let form = gear.form();
    if let Some(root) = root {
        values.extend([
            ("d_f", Value::from(2.0 * root)),
            ("h", (form.sense() * (form.tip_radius - root)).into()),
        ]);
    }
    let thinned = gear.stated.allowance * form.tip_radius / form.pitch_radius;
    let tip_helix = gear.helix.angle_at(form.tip_radius, form.pitch_radius);
    values.insert("s_an", ((form.tip_thickness() - thinned) * math::cos(tip_helix)).into());
}

/// Root radius at the nominal profile shift, m, if the root diameter of the gear follows from its
/// rack and its generating profile shift.
pub(super) fn nominal_root(gear: &GearPrototype, module: f64) -> Option<f64> {
    let form = gear.form();
    let [_, dedendum] = gear.stated.heights?;
    let dedendum = match &gear.gear {
        Gear::External(external) => dedendum * external.rack.tool_module(),
        Gear::Internal(_) => dedendum * module,
    };
    let at =
        |thickness| form.pitch_radius + profile_shift_of(gear, thickness) * module - form.sense() * dedendum;
    let follows = (form.root_radius - at(form.tooth_thickness)).abs() < SAME_ROOT * module;
    follows.then(|| at(form.tooth_thickness - gear.stated.allowance))
}

/// Adds the tool and the profile shift.
fn add_rack(values: &mut Values, gear: &GearPrototype, module: f64) {
    let form = gear.form();
    let nominal = profile_shift_of(gear, form.tooth_thickness - gear.stated.allowance);
    values.insert("x", nominal.into());
    if gear.stated.allowance != 0.0 {
        values.insert("x_E", profile_shift_of(gear, form.tooth_thickness).into());
    }
    let stated = &gear.stated;
    values.insert("rack", stated.rack.unwrap_or("custom").into());
    // Normal modules per module of the plane of the rack.
    let mut per_module = 1.0;
    if let Gear::External(external) = &gear.gear {
        let rack = external.rack;
        per_module = rack.tool_module() / module;
        let margin = external.undercut_margin() * per_module;
        values.extend([
            ("rho_fP", Value::from(rack.tip_radius / rack.tool_module())),
            ("x - x_min", margin.into()),
        ]);
        if rack.residual_undercut > 0.0 {
            values.insert("s_pr", rack.residual_undercut.into());
        }
    }
    if let Some([addendum, dedendum]) = stated.heights {
        values.extend([("h_aP", Value::from(addendum)), ("h_fP", dedendum.into())]);
        let from_reference = form.sense() * (form.tip_radius - form.pitch_radius) / module;
        values.insert("k", (from_reference - addendum * per_module - form.sense() * nominal).into());
    }
}

/// Adds the tooth thickness and its measurements, nominal and at the limits of the allowances.
fn add_thicknesses(values: &mut Values, gear: &GearPrototype) {
    let form = gear.form();
    let cosine = math::cos(gear.helix.angle());
    let base_helix = gear.helix.base_angle(form.pressure_angle);
    let nominal = form.tooth_thickness - gear.stated.allowance;
    values.extend([("s_t", Value::from(nominal)), ("s_n", (nominal * cosine).into())]);
    let tip_helix = gear.helix.angle_at(form.tip_radius, form.pitch_radius);
    values.insert("s_an", (form.tip_thickness() * math::cos(tip_helix)).into());
    let teeth = |thickness| Measured { form, thickness, base_helix };
    let at = teeth(nominal);
    let span = span_teeth(gear, &at);
    if let Some(count) = span {
        values.extend([("span_teeth", Value::from(f64::from(count))), ("W_k", at.span(count).into())]);
    }
    let ball = gear.stated.ball.unwrap_or(PIN * form.tool_module);
    let ball = Some(ball).filter(|ball| at.ball_touches(*ball));
    if let Some(ball) = ball {
        values.extend([("D_M", Value::from(ball)), ("M_dK", at.over_balls(ball).into())]);
    }
    let [upper, lower] = gear.stated.allowances;
    let mean = upper.zip(lower).map(|(upper, lower)| 0.5 * (upper + lower));
    if upper.or(lower).is_some() {
        values.insert("thickness_limit", gear.stated.thickness_limit.unwrap_or("nominal").into());
    }
    for (limit, allowance) in [upper, mean, lower].into_iter().enumerate() {
        let Some(allowance) = allowance else { continue };
        let at = teeth(nominal + allowance / cosine);
        values.insert(TRANSVERSE[limit], at.thickness.into());
        values.insert(NORMAL[limit], (at.thickness * cosine).into());
        // Thicker teeth of an internal gear have smaller spaces, so a span over spaces is shorter.
        let measured = if form.internal { LIMITS - 1 - limit } else { limit };
        if let Some(count) = span {
            values.insert(SPAN[measured], at.span(count).into());
        }
        if let Some(ball) = ball {
            values.insert(BALLS[measured], at.over_balls(ball).into());
        }
    }
}

/// Number of teeth of the span measurement: the stated one, or the usual one of an external gear if
/// an instrument can span it.
fn span_teeth(gear: &GearPrototype, nominal: &Measured) -> Option<u32> {
    let usual = || gear.gear.external()?.usual_span(nominal.base_helix, gear.face_width);
    match gear.stated.span_teeth {
        Some(count) => Some(count),
        None => usual().map(|(count, _)| count),
    }
}

/// Teeth of another thickness, to be measured (DIN 21773:2014).
struct Measured {
    form: ToothForm,
    /// Transverse tooth thickness at the reference circle, m.
    thickness: f64,
    base_helix: f64,
}

impl Measured {
    /// Half the angle between the involutes of a tooth at the base circle, or of a space of an
    /// internal gear.
    fn half_base_angle(&self) -> f64 {
        let ToothForm { internal, pitch_radius, pressure_angle, module, .. } = self.form;
        let arc = if internal { PI * module - self.thickness } else { self.thickness };
        0.5 * arc / pitch_radius + involute(pressure_angle)
    }

    fn span(&self, count: u32) -> f64 {
        let base_pitch = self.form.base_radius * self.form.pitch_angle();
        let transverse =
            (f64::from(count) - 1.0) * base_pitch + 2.0 * self.form.base_radius * self.half_base_angle();
        transverse * math::cos(self.base_helix)
    }

    /// Roll angle at the centre of a ball; NaN if the centre would be inside the base circle.
    fn center_roll(&self, ball: f64) -> f64 {
        let along_base = 0.5 * ball / (self.form.base_radius * math::cos(self.base_helix));
        let half_pitch = PI / f64::from(self.form.teeth);
        let value = match self.form.internal {
            false => self.half_base_angle() + along_base - half_pitch,
            true => self.half_base_angle() - along_base,
        };
        if value > 0.0 { roll_of_involute(value) } else { f64::NAN }
    }

    /// Returns whether a ball touches the involute part of both flanks and is not below the tip
    /// circle.
    fn ball_touches(&self, ball: f64) -> bool {
        let sense = self.form.sense();
        let center = self.center_roll(ball);
        let touching = sense * center - 0.5 * ball * math::cos(self.base_helix) / self.form.base_radius;
        let reaches = sense * (self.form.radius_at_roll(center) - self.form.tip_radius) + 0.5 * ball > 0.0;
        (self.form.form_roll..self.form.tip_roll).contains(&touching) && reaches
    }

    fn over_balls(&self, ball: f64) -> f64 {
        let teeth = self.form.teeth;
        let odd = if teeth % 2 == 1 { math::cos(FRAC_PI_2 / f64::from(teeth)) } else { 1.0 };
        2.0 * self.form.radius_at_roll(self.center_roll(ball)) * odd + self.form.sense() * ball
    }
}
