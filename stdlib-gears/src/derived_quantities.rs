//! Quantities that follow from the data of a gear and of a mesh, with the terms and symbols of ISO
//! 1122-1 and ISO 21771, in the usual reading order.
//!
//! Every value comes from the geometry that an analysis uses ([`Gear`], [`MeshGeometry`]).

use crate::external::ExternalGear;
use crate::gear::{Gear, ToothForm};
use crate::helix::{Hand, Helix};
use crate::internal::InternalGear;
use crate::mesh_geometry::MeshGeometry;
use crate::modification::ProfilePart;
use crate::prototype::GearPrototype;
use calyx_abi::math;

/// Diameter of the pins or balls for the dimension over pins, in modules of the tool as given (the
/// usual 1.728 over diametral pitch).
pub const PIN: f64 = 1.728;

/// Physical kind of a quantity.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Kind {
    /// Length, m.
    Length,
    /// Curvature, 1/m.
    Curvature,
    /// Angle, rad.
    Angle,
    /// Dimensionless number.
    #[default]
    Number,
}

/// Quantity derived from the model.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Quantity {
    /// Term of ISO 1122-1, if it has one.
    pub name: &'static str,
    /// Symbol in formulas: `d_b`, `epsilon_alpha`.
    pub symbol: &'static str,
    /// Value in SI.
    pub value: f64,
    /// Physical kind.
    pub kind: Kind,
    /// Condition of the value, or its size in modules; empty if the name is sufficient.
    pub note: String,
    /// True if a short list contains this quantity.
    pub essential: bool,
    /// Member to which a quantity of a mesh belongs, 0 for the first; `None` if it belongs to both.
    pub member: Option<usize>,
}

impl Quantity {
    fn new(name: &'static str, symbol: &'static str, kind: Kind, value: f64) -> Self {
        Quantity { name, symbol, value, kind, note: String::new(), essential: true, member: None }
    }

    fn length(name: &'static str, symbol: &'static str, value: f64) -> Self {
        Self::new(name, symbol, Kind::Length, value)
    }

    fn number(name: &'static str, symbol: &'static str, value: f64) -> Self {
        Self::new(name, symbol, Kind::Number, value)
    }

    fn angle(name: &'static str, symbol: &'static str, value: f64) -> Self {
        Self::new(name, symbol, Kind::Angle, value)
    }

    /// Marks the quantity as part of the full list only.
    fn further(self) -> Self {
        Quantity { essential: false, ..self }
    }

    fn note(self, note: impl Into<String>) -> Self {
        Quantity { note: note.into(), ..self }
    }

    /// Adds the size in modules of the tool as given.
    fn in_modules(self, form: &ToothForm) -> Self {
        let modules = self.value / form.tool_module;
        let unit = modules_of(form);
        if modules.abs() < 0.005 { self } else { self.note(format!("{modules:.2} {unit}")) }
    }

    fn of(self, member: usize) -> Self {
        Quantity { member: Some(member), ..self }
    }
}

/// Returns the quantities of a gear.
pub fn of_gear(prototype: &GearPrototype) -> Vec<Quantity> {
    let form = prototype.form();
    let ToothForm { module, internal, .. } = form;
    let tip = if internal { "tip (minor) diameter" } else { "tip (outside) diameter" };
    let external = prototype.gear.external();
    let form_note = match external {
        Some(gear) if gear.rack.residual_undercut > 0.0 => "the involute begins above the protuberance's cut",
        Some(gear) if gear.undercut => "the involute begins, undercut",
        _ => "the involute begins",
    };
    let base_helix = prototype.helix.base_angle(form.pressure_angle);
    let mut all = vec![
        Quantity::number("number of teeth", "z", f64::from(form.teeth)).note(if internal {
            "internal"
        } else {
            ""
        }),
        Quantity::length("transverse module", "m_t", module),
        Quantity::new("diametral pitch", "P", Kind::Curvature, 1.0 / module).further(),
        Quantity::angle("pressure angle", "alpha_t", form.pressure_angle).further(),
    ];
    all.extend(of_helix(&prototype.helix, &form));
    all.extend([
        Quantity::length("reference (pitch) diameter", "d", 2.0 * form.pitch_radius),
        Quantity::length("base diameter", "d_b", 2.0 * form.base_radius),
        Quantity::length(tip, "d_a", 2.0 * form.tip_radius),
        tip_form_diameter(&form).further(),
        Quantity::length("root diameter", "d_f", 2.0 * form.root_radius),
        Quantity::length("root form diameter", "d_Ff", 2.0 * form.form_radius).note(form_note),
        Quantity::angle("roll angle at the root form diameter", "xi_Ff", form.form_roll.abs()).further(),
        Quantity::angle("roll angle at the tip diameter", "xi_a", form.tip_roll.abs()).further(),
        Quantity::length("base pitch", "p_b", form.base_radius * form.pitch_angle()).further(),
        Quantity::length("tooth thickness at the reference circle", "s_t", form.tooth_thickness),
        Quantity::length("tooth thickness at the tip", "s_a", form.tip_thickness()).in_modules(&form),
        Quantity::length("tooth depth", "h", (form.tip_radius - form.root_radius).abs())
            .in_modules(&form)
            .further(),
    ]);
    match &prototype.gear {
        Gear::External(gear) => all.extend(of_external(gear, base_helix, prototype.face_width)),
        Gear::Internal(gear) => all.extend(of_internal(gear, base_helix)),
    }
    for modification in &prototype.modifications {
        if let Some(ProfilePart::TipRelief(relief)) = modification.parts().profile {
            let Ok(start) = relief.start_roll(&form, false) else { continue };
            let diameter = 2.0 * form.radius_at_roll(start);
            all.push(Quantity::length("diameter at which the tip relief begins", "d_Ca", diameter).further());
        }
    }
    all
}

/// Tip form diameter. A tip edge whose radius is not stated belongs to the contact analysis only.
fn tip_form_diameter(form: &ToothForm) -> Quantity {
    let (diameter, note) = match form.tip_form_roll == form.tip_roll {
        true => (2.0 * form.tip_radius, "the tip circle: no `tip_edge_radius` is stated"),
        false => (2.0 * form.radius_at_roll(form.tip_form_roll), "the rounded tip edge begins"),
    };
    Quantity::length("tip form diameter", "d_Fa", diameter).note(note)
}

/// Quantities of the helix; none for spur teeth.
fn of_helix(helix: &Helix, form: &ToothForm) -> Vec<Quantity> {
    if helix.is_spur() {
        return Vec::new();
    }
    let cosine = math::cos(helix.angle());
    let normal_pressure = math::atan(math::tan(form.pressure_angle) * cosine);
    vec![
        Quantity::angle("helix angle", "beta", helix.angle()).note(match helix.hand() {
            Hand::Right => "right-handed",
            Hand::Left => "left-handed",
        }),
        Quantity::angle("base helix angle", "beta_b", helix.base_angle(form.pressure_angle)).further(),
        Quantity::length("lead", "p_z", helix.lead(form.pitch_radius)).further(),
        Quantity::length("normal module", "m_n", form.module * cosine),
        Quantity::angle("normal pressure angle", "alpha_n", normal_pressure).further(),
        Quantity::length(
            "normal tooth thickness at the reference circle",
            "s_n",
            form.tooth_thickness * cosine,
        ),
    ]
}

/// Unit in which lengths of a gear are counted.
const MODULES: &str = "modules";

/// Unit in which lengths of this gear are counted. A rack from the normal plane has a larger module
/// in the transverse plane.
fn modules_of(form: &ToothForm) -> &'static str {
    if form.tool_module == form.module { MODULES } else { "normal modules" }
}

/// Measuring bodies: pins for spur gears, balls for helical gears.
fn pins(base_helix: f64) -> &'static str {
    if base_helix == 0.0 { "pins" } else { "balls" }
}

fn of_external(gear: &ExternalGear, base_helix: f64, face_width: f64) -> Vec<Quantity> {
    let module = gear.rack.tool_module();
    let modules = modules_of(&gear.into());
    let mut all = vec![
        Quantity::number("profile shift coefficient", "x", gear.profile_shift()).note(
            if modules == MODULES {
                "of its tooth thickness"
            } else {
                "of its tooth thickness, in normal modules"
            },
        ),
        undercut_margin(gear),
        Quantity::number("teeth below which this depth is undercut", "z_min", gear.undercut_teeth())
            .further(),
        fillet_radius(gear.root_fillet_curvature_radius(), &gear.into()),
    ];
    if let Some((teeth, span)) = gear.usual_span(base_helix, face_width) {
        all.push(
            Quantity::length("span measurement", "W_k", span).note(format!("over {teeth} teeth")).further(),
        );
    }
    let pin = PIN * module;
    if gear.pin_touches_flanks(pin, base_helix) {
        let name = if base_helix == 0.0 { "measurement over pins" } else { "measurement over balls" };
        let over = Quantity::length(name, "M_d", gear.over_pins(pin, base_helix));
        all.push(over.note(format!("{} of {PIN} {modules}", pins(base_helix))).further());
    }
    all
}

fn of_internal(gear: &InternalGear, base_helix: f64) -> Vec<Quantity> {
    let module = gear.shaper.module;
    let mut all = vec![
        Quantity::number("profile shift coefficient", "x", gear.profile_shift())
            .note("of its tooth thickness, positive outwards"),
        fillet_radius(gear.root_fillet_curvature_radius(), &gear.into()),
        Quantity::length("centre distance of the shaper", "a_0", gear.cutting_distance).further(),
        Quantity::length("tooth thickness of the shaper", "s_0", gear.cutter_thickness)
            .note("at its reference circle")
            .further(),
    ];
    let pin = PIN * module;
    if gear.pin_touches_flanks(pin, base_helix) {
        let name = if base_helix == 0.0 { "measurement between pins" } else { "measurement between balls" };
        let between = Quantity::length(name, "M_d", gear.between_pins(pin, base_helix));
        all.push(between.note(format!("{} of {PIN} modules", pins(base_helix))).further());
    }
    all
}

fn fillet_radius(radius: f64, form: &ToothForm) -> Quantity {
    Quantity::length("fillet radius at the root circle", "rho_f", radius).in_modules(form).further()
}

fn undercut_margin(gear: &ExternalGear) -> Quantity {
    let margin = gear.undercut_margin();
    Quantity::number("profile shift above undercut", "x - x_min", margin).note(if margin < 0.0 {
        "undercut; this much more profile shift would avoid it"
    } else {
        "undercut begins if the profile shift is smaller by this amount"
    })
}

/// Returns the quantities of a pair of gears. The roll angles of `mesh` belong to the first one,
/// which is external.
pub fn of_mesh(gears: [ToothForm; 2], mesh: &MeshGeometry) -> Vec<Quantity> {
    let [first, second] = gears;
    let distance = mesh.center_distance;
    let teeth = gears.map(|gear| f64::from(gear.teeth));
    let sign = second.sense();
    let reference = first.pitch_radius + sign * second.pitch_radius;
    let mut all = vec![
        Quantity::length("centre distance", "a", distance),
        Quantity::length("reference centre distance", "a_d", reference.abs()).further(),
        Quantity::angle("operating pressure angle", "alpha_wt", mesh.operating_pressure_angle),
        Quantity::number("transverse contact ratio", "epsilon_alpha", mesh.contact_ratio),
    ];
    if mesh.overlap_ratio > 0.0 {
        all.push(Quantity::number("overlap ratio", "epsilon_beta", mesh.overlap_ratio));
        all.push(Quantity::number("total contact ratio", "epsilon_gamma", mesh.total_contact_ratio()));
    }
    all.extend([
        Quantity::length("length of the path of contact", "g_alpha", mesh.line_of_action_length).further(),
        Quantity::number("gear ratio", "u", teeth[1] / teeth[0]).note("second over first"),
        Quantity::length("circumferential backlash", "j_wt", mesh.backlash).in_modules(&first),
        Quantity::length("normal backlash", "j_bn", mesh.normal_backlash).further(),
    ]);
    if let Some(tight) = mesh.zero_backlash_center_distance {
        let symbol = if mesh.internal { "a_max" } else { "a_min" };
        all.push(Quantity::length("centre distance without backlash", symbol, tight).further());
    }
    let points = mesh.first_roll;
    // In the order of the path of contact on each member, from its root to its tip.
    let rolls = [
        [points.start_of_active_profile, points.lowest_single_tooth, points.highest_single_tooth],
        [points.end_of_active_profile, points.highest_single_tooth, points.lowest_single_tooth]
            .map(|roll| mesh.second_roll(roll)),
    ];
    for (member, [start, lowest, highest]) in rolls.into_iter().enumerate() {
        let (gear, mate) = (gears[member], gears[1 - member]);
        let diameter = |roll: f64| 2.0 * gear.radius_at_roll(roll.max(0.0));
        let operating = 2.0 * distance * teeth[member] / (sign * teeth[0] + teeth[1]);
        let mut own = vec![
            Quantity::length("operating pitch diameter", "d_w", operating).further(),
            Quantity::length("tip clearance at the root", "c", mesh.clearance(gear, mate)).in_modules(&gear),
            Quantity::length("start of active profile, diameter", "d_Nf", diameter(start)),
            Quantity::length(
                "active profile above the fillet",
                "c_F",
                gear.sense() * (gear.radius_at_roll(start.max(0.0)) - gear.form_radius),
            )
            .further(),
        ];
        // With a contact ratio above two, at least two pairs are always in contact.
        if (1.0..2.0).contains(&mesh.total_contact_ratio()) {
            own.push(Quantity::length(
                "lowest single-tooth contact (LPSTC), diameter",
                "d_LPSTC",
                diameter(lowest),
            ));
            own.push(Quantity::length(
                "highest single-tooth contact (HPSTC), diameter",
                "d_HPSTC",
                diameter(highest),
            ));
        }
        all.extend(own.into_iter().map(|quantity| quantity.of(member)));
    }
    all
}
