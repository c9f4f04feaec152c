//! Values of the data block of a mesh.

use super::gear::{nominal_root, normal_angle};
use super::{Value, Values};
use crate::derived_quantities::of_mesh;
use crate::drawing_externs::normal_module;
use crate::internal::tip_margin;
use crate::mesh_geometry::MeshGeometry;
use crate::prototype::GearPrototype;
use calyx_abi::math;

/// Quantities of [`of_mesh`] that are entries of a data block.
const DERIVED: [&str; 14] = [
    "a",
    "a_d",
    "u",
    "alpha_wt",
    "epsilon_alpha",
    "epsilon_beta",
    "epsilon_gamma",
    "g_alpha",
    "j_bn",
    "j_wt",
    "d_w",
    "d_Nf",
    "c_F",
    "c",
];

/// Returns the values that both gears have in common, and those of each gear.
pub(super) fn values(gears: [&GearPrototype; 2], mesh: &MeshGeometry) -> (Values, [Values; 2]) {
    let forms = gears.map(GearPrototype::form);
    let (mut common, mut members) = (Values::new(), [Values::new(), Values::new()]);
    for quantity in of_mesh(forms, mesh) {
        let Some(key) = DERIVED.into_iter().find(|key| *key == quantity.symbol) else { continue };
        let values = quantity.member.and_then(|member| members.get_mut(member)).unwrap_or(&mut common);
        values.insert(key, quantity.value.into());
    }
    for (values, gear) in members.iter_mut().zip(gears) {
        separate_generated(values, gear);
    }
    let [first, second] = forms;
    let teeth = forms.map(|form| f64::from(form.teeth));
    let operating: [f64; 2] = [0, 1].map(|member: usize| {
        2.0 * mesh.center_distance * teeth[member] / (second.sense() * teeth[0] + teeth[1])
    });
    let helix = gears[0].helix.angle_at(0.5 * operating[0], first.pitch_radius);
    common.insert("alpha_wn", normal_angle(mesh.operating_pressure_angle, helix).into());
    if !gears[0].helix.is_spur() {
        common.insert("beta_w", helix.into());
    }
    common.extend(backlash_limits(gears, operating, mesh));
    if second.internal {
        let radii = forms.map(|form| form.tip_radius);
        let counts = forms.map(|form| form.teeth);
        let margin = tip_margin(
            counts,
            [first.tip_roll, -second.tip_roll],
            radii,
            mesh.center_distance,
            mesh.operating_pressure_angle,
        );
        common.extend(margin.map(|margin| ("tip_margin", Value::from(margin))));
    }
    let points = mesh.first_roll;
    let rolls = |roll: f64| [roll, mesh.second_roll(roll)];
    let single = (1.0..2.0).contains(&mesh.contact_ratio);
    for (member, values) in members.iter_mut().enumerate() {
        let diameter = |roll: f64| 2.0 * forms[member].radius_at_roll(rolls(roll)[member].max(0.0));
        // In the order of the path of contact from the root of each gear to its tip.
        let [lowest, highest, end] = match member {
            0 => [points.lowest_single_tooth, points.highest_single_tooth, points.end_of_active_profile],
            _ => [points.highest_single_tooth, points.lowest_single_tooth, points.start_of_active_profile],
        };
        values.insert("d_Na", diameter(end).into());
        if single {
            values
                .extend([("d_LPSTC", Value::from(diameter(lowest))), ("d_HPSTC", diameter(highest).into())]);
        }
        let sliding = [points.start_of_active_profile, points.end_of_active_profile]
            .map(|roll| specific_sliding(rolls(roll), member));
        let [at_start, at_end] = sliding;
        values.insert("zeta_max", if at_start.abs() > at_end.abs() { at_start } else { at_end }.into());
        values.insert("j_phi", (2.0 * mesh.backlash / operating[member]).into());
    }
    (common, members)
}

/// Clearances of a generated root get their own keys, and the nominal tip clearance is added, as in
/// the data of the gear.
fn separate_generated(values: &mut Values, gear: &GearPrototype) {
    if gear.stated.allowance == 0.0 {
        return;
    }
    if let Some(clearance) = values.remove("c_F") {
        values.insert("c_FE", clearance);
    }
    let form = gear.form();
    let Some(root) = nominal_root(gear, normal_module(gear)) else { return };
    if let Some(Value::Number(generated)) = values.get("c").cloned() {
        let nominal = generated - form.sense() * (root - form.root_radius);
        values.extend([("c_E", Value::from(generated)), ("c", nominal.into())]);
    }
}

/// Specific sliding `zeta` of a member at a point of contact with these roll angles of both members
/// (ISO 21771:2007, 5.5): `zeta_1 = 1 - rho_2 z_1 / (rho_1 z_2)`, which is `1 - xi_2 / xi_1`,
/// because the radii of curvature are `rho = r_b xi`.
fn specific_sliding(rolls: [f64; 2], member: usize) -> f64 {
    let [own, mate] = if member == 0 { rolls } else { [rolls[1], rolls[0]] };
    1.0 - mate / own
}

/// Smallest and largest circumferential backlash within the allowances of the tooth thickness. The
/// thickness at the operating circle changes in the ratio of the diameters.
fn backlash_limits(
    gears: [&GearPrototype; 2],
    operating: [f64; 2],
    mesh: &MeshGeometry,
) -> Vec<(&'static str, Value)> {
    if gears.iter().all(|gear| gear.stated.allowances.iter().any(Option::is_none)) {
        return Vec::new();
    }
    let at_limit = |limit: usize| {
        let widening = gears.iter().zip(operating).map(|(gear, operating)| {
            let [Some(upper), Some(lower)] = gear.stated.allowances else { return 0.0 };
            let allowance = [upper, lower][limit] / math::cos(gear.helix.angle());
            (gear.stated.allowance - allowance) * operating / (2.0 * gear.form().pitch_radius)
        });
        mesh.backlash + widening.sum::<f64>()
    };
    vec![("j_wt_min", at_limit(0).into()), ("j_wt_max", at_limit(1).into())]
}
