//! Data of a gear as a drawing states them, in the normal section: the Rust side of `gear_data_of`
//! in `iso21771.cx` and of `rated_gear_of` in `iso6336.cx`.
//!
//! A rating of a modelled gear is equal to the last bit to a rating of the same statements, so the
//! numbers are those of the model and not derived from the transverse section.

use crate::basic_rack::{RackForm, StatedRack};
use crate::blank::Tool;
use crate::data_block::normal_angle;
use crate::externs::{defect, host};
use crate::gear::{Gear, ToothForm};
use crate::helix::Helix;
use crate::prototype::GearPrototype;
use crate::rack::Plane;
use crate::roughing::RoughingTool;
use crate::stated_gear::{ModuleStatement, Proportions};
use calyx_abi::externs::Handle;
use calyx_abi::math;

/// Largest difference of a stated root diameter from that of the rack, in normal modules, up to
/// which both are equal.
const SAME_ROOT: f64 = 2e-4;

calyx_abi::externs! {
    Pure fn calyx_iso21771_stated_number(context, gear: Handle, symbol: String) -> f64 {
        let gear = host(context)?.cylindrical("gear", gear)?;
        number(gear, &symbol).ok_or_else(|| defect("a number of a gear is unknown"))
    }

    Pure fn calyx_iso21771_stated_text(context, gear: Handle, name: String) -> String {
        let gear = host(context)?.cylindrical("gear", gear)?;
        Ok(text(gear, &name))
    }

    Pure fn calyx_iso6336_modelled_number(context, gear: Handle, symbol: String) -> f64 {
        let gear = host(context)?.cylindrical("gear", gear)?;
        number(gear, &symbol).ok_or_else(|| defect("a number of a gear is unknown"))
    }

    Pure fn calyx_iso6336_modelled_material(context, gear: Handle) -> String {
        let gear = host(context)?.cylindrical("gear", gear)?;
        Ok(text(gear, "material"))
    }
}

/// Basic rack in the normal section. Coefficients count normal modules; angles in rad.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct NormalRack {
    /// Normal pressure angle.
    pub pressure_angle: f64,
    /// Addendum coefficient `h_aP*`.
    pub addendum: f64,
    /// Dedendum coefficient `h_fP*`.
    pub dedendum: f64,
    /// Fillet radius coefficient `rho_fP*`; of an internal gear, that of its cutter's tip.
    pub fillet_radius: f64,
    /// Protuberance coefficient of the roughing tool.
    pub protuberance: f64,
    /// Grinding allowance coefficient.
    pub grinding_allowance: f64,
    /// Pressure angle of the protuberance's flank.
    pub protuberance_angle: f64,
}

/// Statements of the geometry of a gear. Lengths in m.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StatedGeometry {
    /// Normal module.
    pub normal_module: f64,
    /// Nominal profile shift coefficient of ISO 21771, in normal modules; for an internal gear the
    /// opposite of that of `gears.internal`.
    pub profile_shift: f64,
    /// Tip diameter, unless it follows from rack, profile shift and tip alteration.
    pub tip_diameter: Option<f64>,
    /// Tip alteration coefficient, in normal modules.
    pub tip_alteration: f64,
    /// Root diameter, unless it follows from rack and profile shift.
    pub root_diameter: Option<f64>,
    /// Basic rack.
    pub rack: NormalRack,
    /// True if the rack in the normal section generates the root, so that the root form diameter
    /// follows from it.
    pub generated_by_rack: bool,
}

/// Statements of a gear with the dimensions that follow from them.
pub(crate) struct Resolved<'a> {
    pub tool: &'a Tool,
    pub rack: &'a StatedRack,
    pub helix: &'a Helix,
    pub proportions: &'a Proportions,
    pub modules: &'a [ModuleStatement],
    /// True if coefficients count normal modules although the tool is in the transverse plane.
    pub normal: bool,
    /// Nominal profile shift coefficient, in modules of `proportions`.
    pub shift: f64,
    /// Tip diameter, m, and `true` if a diameter states it.
    pub tip: (f64, bool),
    pub tip_alteration: Option<f64>,
    /// Root diameter, m, and `true` if it is stated.
    pub root: (f64, bool),
}

impl StatedGeometry {
    pub(crate) fn of(given: &Resolved<'_>) -> StatedGeometry {
        let Resolved { tool, helix, proportions, .. } = *given;
        let sense = proportions.sense;
        let in_normal = given.normal || helix.is_spur() || is_normal(tool);
        // Normal modules per module that coefficients count.
        let ratio = if in_normal { 1.0 } else { 1.0 / math::cos(helix.angle()) };
        let normal_module = normal_module(tool, given.modules, helix);
        // The sum is never a negative zero.
        let profile_shift = sense * given.shift * ratio + 0.0;
        let mut basic = normal_rack(given, normal_module, ratio);
        let (root, root_is_stated) = given.root;
        if root_is_stated {
            let depth = sense * (proportions.reference_diameter - root) / (2.0 * normal_module);
            if (depth + profile_shift - basic.dedendum).abs() > SAME_ROOT {
                basic.dedendum = depth + profile_shift;
            }
        }
        let (tip, tip_is_stated) = given.tip;
        StatedGeometry {
            normal_module,
            profile_shift,
            tip_diameter: (tip_is_stated || !in_normal).then_some(tip),
            tip_alteration: given.tip_alteration.unwrap_or(0.0) * ratio,
            root_diameter: (root_is_stated || !in_normal).then_some(root),
            rack: basic,
            generated_by_rack: in_normal && matches!(tool, Tool::Rack(_)),
        }
    }
}

fn is_normal(tool: &Tool) -> bool {
    matches!(tool, Tool::Rack(rack) if rack.plane == Plane::Normal)
}

/// Normal module, to the last bit as stated, m.
fn normal_module(tool: &Tool, modules: &[ModuleStatement], helix: &Helix) -> f64 {
    let own = match tool {
        Tool::Rack(rack) if is_normal(tool) => return rack.module,
        _ if helix.is_spur() => tool.module(),
        _ => tool.module() * math::cos(helix.angle()),
    };
    modules.first().and_then(|stated| stated.normal(helix).ok()).unwrap_or(own)
}

/// Basic rack of a gear in the normal section.
fn normal_rack(given: &Resolved<'_>, normal_module: f64, ratio: f64) -> NormalRack {
    let Resolved { tool, rack, helix, .. } = *given;
    let [addendum, dedendum] = [rack.addendum, rack.dedendum].map(|coefficient| coefficient * ratio);
    match tool {
        Tool::Rack(sized) => {
            let in_normal = ratio == 1.0;
            let angle = |angle| if in_normal { angle } else { normal_angle(angle, helix.angle()) };
            let (fillet_radius, [protuberance, grinding_allowance]) = match rack.form {
                RackForm::Basic { fillet_radius, tool, .. } => {
                    let RoughingTool { protuberance, allowance, .. } = tool;
                    (
                        fillet_radius,
                        [protuberance, allowance].map(|length| length.unwrap_or(0.0) / normal_module),
                    )
                }
                RackForm::Sized(_) => {
                    // Lengths normal to the flank are shorter in the normal section.
                    let cosine =
                        if in_normal { 1.0 } else { math::cos(helix.base_angle(sized.pressure_angle)) };
                    let undercut = sized.residual_undercut * cosine / normal_module;
                    (sized.tip_radius / normal_module, [undercut, 0.0])
                }
            };
            NormalRack {
                pressure_angle: angle(sized.pressure_angle),
                addendum,
                dedendum,
                fillet_radius,
                protuberance,
                grinding_allowance,
                protuberance_angle: angle(sized.protuberance_angle),
            }
        }
        Tool::Shaper(shaper) => {
            let own = match rack.form {
                RackForm::Basic { pressure_angle, .. } => Some(pressure_angle),
                RackForm::Sized(rack) if rack.plane == Plane::Normal || helix.is_spur() => {
                    Some(rack.pressure_angle)
                }
                RackForm::Sized(_) => None,
            };
            let transverse = || normal_angle(shaper.pressure_angle, helix.angle());
            NormalRack {
                pressure_angle: own.filter(|_| given.normal).unwrap_or_else(transverse),
                addendum,
                dedendum,
                fillet_radius: shaper.tip_radius / normal_module,
                ..NormalRack::default()
            }
        }
    }
}

/// Returns a number of a gear by its symbol, in SI units; NaN if the gear does not have it, and
/// `None` for an unknown symbol.
fn number(gear: &GearPrototype, symbol: &str) -> Option<f64> {
    let stated = gear.stated.geometry;
    let StatedGeometry { rack, .. } = stated;
    let form = gear.form();
    let or_nan = |value: Option<f64>| value.unwrap_or(f64::NAN);
    Some(match symbol {
        "z" => f64::from(form.teeth),
        "internal" => f64::from(u8::from(form.internal)),
        "m_n" => stated.normal_module,
        "beta" => gear.helix.angle(),
        "x" => stated.profile_shift,
        "b" => gear.face_width,
        "d_a" => or_nan(stated.tip_diameter),
        "k" => stated.tip_alteration,
        "h_K" => tip_chamfer(&form),
        "d_f" => or_nan(stated.root_diameter),
        "d_Ff" => or_nan((!stated.generated_by_rack).then_some(2.0 * form.form_radius)),
        "E_sns" => allowances(gear)[0],
        "E_sni" => allowances(gear)[1],
        "bore" => or_nan(rim_radius(gear).map(|radius| 2.0 * radius)),
        "alpha_n" => rack.pressure_angle,
        "h_aP" => rack.addendum,
        "h_fP" => rack.dedendum,
        "rho_fP" => rack.fillet_radius,
        "pr" => rack.protuberance,
        "q" => rack.grinding_allowance,
        "alpha_pr" => rack.protuberance_angle,
        "s_R" => or_nan(rim_radius(gear).map(|radius| (form.root_radius - radius).abs())),
        "b_s" => or_nan(gear.rim.web.as_ref().map(|web| web.ends()[1] - web.ends()[0])),
        "z_0" => or_nan(gear.gear.internal().map(|gear| f64::from(gear.shaper.teeth))),
        "x_0" => or_nan(cutter_shift(gear)),
        "grade" => or_nan(gear.stated.tolerances.map(|tolerances| f64::from(tolerances.grade))),
        "edition" => or_nan(gear.stated.tolerances.map(|tolerances| tolerances.edition.year())),
        _ => return None,
    })
}

/// Radial height `h_K` of a stated tip edge, m: distance of the tip form circle from the tip
/// circle.
fn tip_chamfer(form: &ToothForm) -> f64 {
    match form.tip_form_roll == form.tip_roll {
        true => 0.0,
        false => (form.tip_radius - form.radius_at_roll(form.tip_form_roll)).abs(),
    }
}

/// Returns a text of a gear by the name of the quantity; empty if the gear has none.
fn text(gear: &GearPrototype, name: &str) -> String {
    let text = match name {
        "rack" => gear.stated.rack.unwrap_or("custom"),
        "material" => gear.stated.material.unwrap_or_default(),
        "hand" => gear.helix.hand().name(),
        _ => "",
    };
    text.to_owned()
}

/// Upper and lower allowance of the normal tooth thickness, m. If only one is stated, both are
/// equal.
fn allowances(gear: &GearPrototype) -> [f64; 2] {
    let [upper, lower] = gear.stated.allowances;
    [upper.or(lower), lower.or(upper)].map(|allowance| allowance.unwrap_or(0.0))
}

/// Inner radius of the rim of an external gear, or outer radius of an internal one, m; `None` for a
/// solid gear.
fn rim_radius(gear: &GearPrototype) -> Option<f64> {
    let radius = gear.rim.web.as_ref().map_or(gear.rim.fixed_radius, |web| web.rim_radius());
    (!gear.solid).then_some(radius)
}

/// Profile shift coefficient of the shaper cutter of an internal gear, in normal modules.
fn cutter_shift(gear: &GearPrototype) -> Option<f64> {
    let Gear::Internal(internal) = &gear.gear else { return None };
    let shaper = &internal.shaper;
    // Teeth of the cutter are thicker with a positive shift, those of the gear thinner.
    let shift = -shaper.shift_of_thickness(internal.cutter_thickness);
    Some(shift * shaper.module / gear.stated.geometry.normal_module)
}
