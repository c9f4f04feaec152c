//! The tool, the diameters and the blank of a gear from the data that a model states, as on a
//! drawing. Data that are not stated have defaults; several statements of one quantity must agree.
//! Tooth thickness is in [`crate::stated_thickness`].

use crate::basic_rack::{RackForm, StatedRack};
use crate::blank::{Rim, Tool};
use crate::error::{GeometryError, sentence};
use crate::helix::Helix;
use crate::rack::{Plane, Rack};
use crate::shaper::Shaper;
use calyx_abi::math;
use calyx_runtime::structure::BoreSupport;

/// Largest difference of two statements of a length that count as equal: the rounding of a drawing,
/// as a fraction of the module.
const SAME_LENGTH: f64 = 1e-4;

/// Section of a statement of the module.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Section {
    Normal,
    Transverse,
    /// Not stated, which suffices for spur gears.
    Unstated,
}

/// Statement of the module by an argument.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ModuleStatement {
    pub argument: &'static str,
    pub section: Section,
    /// Module, m.
    pub module: f64,
}

impl ModuleStatement {
    /// Collects the statements among modules (m) and diametral pitches (1/m), each in the order
    /// unstated, normal and transverse section.
    pub fn all(modules: [Option<f64>; 3], pitches: [Option<f64>; 3]) -> Vec<ModuleStatement> {
        let sections = [Section::Unstated, Section::Normal, Section::Transverse];
        let of_module = ["module", "normal_module", "transverse_module"];
        let of_pitch = ["diametral_pitch", "normal_diametral_pitch", "transverse_diametral_pitch"];
        let stated = |(argument, module): (&'static str, Option<f64>), section| {
            module.map(|module| ModuleStatement { argument, section, module })
        };
        let modules = of_module.into_iter().zip(modules).zip(sections);
        let pitches = of_pitch.into_iter().zip(pitches.map(|pitch| pitch.map(f64::recip))).zip(sections);
        modules.chain(pitches).filter_map(|(argument, section)| stated(argument, section)).collect()
    }

    /// Checks that the module is positive and finite.
    ///
    /// # Errors
    /// E0927.
    fn check_size(&self) -> Result<(), GeometryError> {
        if self.module > 0.0 && self.module.is_finite() {
            return Ok(());
        }
        let pitch = self.argument.ends_with("diametral_pitch");
        Err(GeometryError::error(
            "E0927",
            self.argument,
            sentence!["`", text self.argument, "` is 0: teeth of this size do not exist"],
            match pitch {
                true => sentence![
                    "give the diametral pitch of the drawing, such as `", text self.argument,
                    " = 8 / inch`, or leave it out"
                ],
                false => sentence![
                    "give the module of the drawing, such as `", text self.argument, " = 3 mm`, or leave it out"
                ],
            },
        ))
    }

    /// Normal module, m.
    pub fn normal(&self, helix: &Helix) -> Result<f64, GeometryError> {
        let cosine = math::cos(helix.angle());
        match self.section {
            _ if helix.is_spur() => Ok(self.module),
            Section::Normal => Ok(self.module),
            Section::Transverse => Ok(self.module * cosine),
            Section::Unstated => Err(GeometryError::error(
                "E0912",
                self.argument,
                sentence![
                    "`", text self.argument, "` of this helical gear does not say in which section it is: a transverse module of ",
                    length self.module, " is a normal module of ", length self.module * cosine
                ],
                sentence![
                    "write `normal_", text self.argument, "` for that of the drawing and of the hob, or `transverse_",
                    text self.argument, "`"
                ],
            )),
        }
    }
}

/// Returns the normal module that the statements and the tool agree on, m; `None` if none states
/// it. `own` is the normal module of the tool with its argument.
///
/// # Errors
/// E0910: two statements contradict each other. E0912: a statement for a helical gear names no
/// section. E0927: a module or a diametral pitch is zero.
fn normal_module(
    own: Option<(&'static str, f64)>,
    statements: &[ModuleStatement],
    helix: &Helix,
) -> Result<Option<f64>, GeometryError> {
    let mut known = own;
    for statement in statements {
        statement.check_size()?;
        let (argument, module) = (statement.argument, statement.normal(helix)?);
        let Some((first, expected)) = known else {
            known = Some((argument, module));
            continue;
        };
        if (module - expected).abs() > SAME_LENGTH * expected {
            return Err(GeometryError::error(
                "E0910",
                argument,
                sentence![
                    "`", text argument, "` contradicts `", text first, "`: it makes the normal module ", length module,
                    ", and `", text first, "` makes it ", length expected
                ],
                sentence!["give one of them only, or correct one"],
            ));
        }
    }
    Ok(known.map(|(_, module)| module))
}

/// Returns the rack of a gear.
///
/// # Errors
/// E0693, E0910, E0912. E0911: the module is not stated.
pub(crate) fn sized_rack(
    rack: &StatedRack,
    statements: &[ModuleStatement],
    helix: &Helix,
) -> Result<Rack, GeometryError> {
    let own = match rack.form {
        RackForm::Basic { .. } => None,
        RackForm::Sized(rack) => {
            rack.check_plane(helix)?;
            let transverse = rack.plane == Plane::Transverse && !helix.is_spur();
            let cosine = if transverse { math::cos(helix.angle()) } else { 1.0 };
            Some(("rack", rack.module * cosine))
        }
    };
    match normal_module(own, statements, helix)? {
        // The statements of the tool are arguments of the rack.
        Some(module) => rack.with_module(module).map_err(|error| GeometryError { argument: "rack", ..error }),
        None => Err(unknown_size(rack.name.unwrap_or_default())),
    }
}

fn unknown_size(rack: &'static str) -> GeometryError {
    GeometryError::error(
        "E0911",
        "normal_module",
        sentence![
            "the size of the teeth is unknown: the basic rack \"", text rack, "\" has proportions only, and no module is given"
        ],
        sentence!["give the module, such as `normal_module = 3 mm`, or `normal_diametral_pitch = 8 / inch`"],
    )
}

/// Ratio of the numbers of teeth of an internal gear and of its default shaper cutter, and the
/// least number of teeth of this cutter.
const DEFAULT_CUTTER_RATIO: f64 = 2.0;
const DEFAULT_CUTTER_LEAST: f64 = 10.0;
/// Tip radius of the default shaper cutter in normal modules.
const DEFAULT_CUTTER_RADIUS: f64 = 0.2;

/// Returns the shaper cutter of an internal gear: as stated, or a cutter with half of its teeth,
/// an addendum of the rack's dedendum and a tip radius of 0.2 normal modules.
///
/// # Errors
/// E0910 to E0912; E0624 for a gear of too few teeth. E0933: the rack has a protuberance.
pub(crate) fn sized_shaper(
    shaper: Option<Shaper>,
    rack: &StatedRack,
    statements: &[ModuleStatement],
    teeth: u32,
    helix: &Helix,
) -> Result<Shaper, GeometryError> {
    let cosine = if helix.is_spur() { 1.0 } else { math::cos(helix.angle()) };
    if rack.has_protuberance() {
        return Err(GeometryError::error(
            "E0933",
            "rack",
            sentence![
                "the rack has a protuberance, which the shaper cutter of an internal gear does not have: the protuberance would be ignored"
            ],
            sentence!["give a rack without protuberance; shaper cutters with protuberance are not supported"],
        ));
    }
    if let Some(shaper) = shaper {
        normal_module(Some(("shaper", shaper.module * cosine)), statements, helix)?;
        return Ok(shaper);
    }
    let rack_in_plane = sized_rack(rack, statements, helix)?;
    let section = rack_in_plane.transverse(helix);
    let normal = section.module * cosine;
    let count = (f64::from(teeth) / DEFAULT_CUTTER_RATIO).round().max(DEFAULT_CUTTER_LEAST);
    Shaper::new(
        count as u32,
        section.module,
        section.pressure_angle,
        rack.dedendum * normal,
        DEFAULT_CUTTER_RADIUS * normal,
    )
}

/// Module and angle of a tool in the plane of its dimensions, in which coefficients of addendum,
/// dedendum and shift count, and the reference diameter of the gear.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Proportions {
    /// Module that coefficients count, m.
    pub module: f64,
    /// Reference diameter, m.
    pub reference_diameter: f64,
    pub addendum: f64,
    pub dedendum: f64,
    /// +1 for an external gear, -1 for an internal gear.
    pub sense: f64,
}

impl Proportions {
    pub fn of(tool: &Tool, rack: &StatedRack, teeth: u32, helix: &Helix, normal: bool) -> Proportions {
        let (teeth, cosine) = (f64::from(teeth), math::cos(helix.angle()));
        let StatedRack { addendum, dedendum, .. } = *rack;
        match tool {
            Tool::Rack(rack) => {
                let whole = teeth * rack.module;
                let inclined = rack.plane == Plane::Normal && !helix.is_spur();
                let reference_diameter = if inclined { whole / cosine } else { whole };
                Proportions { module: rack.module, reference_diameter, addendum, dedendum, sense: 1.0 }
            }
            Tool::Shaper(shaper) => {
                let inclined = normal && !helix.is_spur();
                let module = if inclined { shaper.module * cosine } else { shaper.module };
                let reference_diameter = teeth * shaper.module;
                Proportions { module, reference_diameter, addendum, dedendum, sense: -1.0 }
            }
        }
    }

    /// Tip diameter `d + 2 (h_aP* + x + k) m`; for an internal gear `d - 2 (h_aP* - x + k) m`,
    /// where a positive shift is outwards (ISO 21771:2007, 4.4.3).
    pub fn tip_diameter(&self, shift: f64, alteration: f64) -> f64 {
        let addendum = self.addendum + self.sense * shift + alteration;
        self.reference_diameter + self.sense * (2.0 * addendum * self.module)
    }

    /// Root diameter `d - 2 (h_fP* - x) m`; for an internal gear `d + 2 (h_fP* + x) m`.
    pub fn root_diameter(&self, shift: f64) -> f64 {
        let dedendum = self.dedendum - self.sense * shift;
        self.reference_diameter - self.sense * (2.0 * dedendum * self.module)
    }
}

/// Statements of the tip diameter, m, and of the tip alteration coefficient `k`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TipStatements {
    /// `outer_diameter` or `minor_diameter` with this name.
    pub diameter: (&'static str, Option<f64>),
    pub tip_diameter: Option<f64>,
    pub alteration: Option<f64>,
}

impl TipStatements {
    /// Argument that states the tip diameter, if any.
    pub fn stated(&self) -> Option<&'static str> {
        let (name, diameter) = self.diameter;
        diameter
            .map(|_| name)
            .or(self.tip_diameter.map(|_| "tip_diameter"))
            .or(self.alteration.map(|_| "tip_alteration"))
    }

    /// Returns true if a diameter is stated, and not only the tip alteration.
    pub fn states_diameter(&self) -> bool {
        self.diameter.1.or(self.tip_diameter).is_some()
    }

    /// Returns the tip diameter of a gear with a nominal profile shift coefficient.
    ///
    /// # Errors
    /// E0913: two statements contradict each other.
    pub fn resolve(&self, proportions: &Proportions, shift: f64) -> Result<f64, GeometryError> {
        let derived = |alteration| proportions.tip_diameter(shift, alteration);
        let (name, diameter) = self.diameter;
        let by_alteration = self.alteration.map(|alteration| ("tip_alteration", derived(alteration)));
        let stated = [
            diameter.map(|diameter| (name, diameter)),
            self.tip_diameter.map(|diameter| ("tip_diameter", diameter)),
            by_alteration,
        ];
        let mut stated = stated.into_iter().flatten();
        let Some((first, diameter)) = stated.next() else { return Ok(derived(0.0)) };
        match stated.find(|(_, other)| (other - diameter).abs() > 2.0 * SAME_LENGTH * proportions.module) {
            None => Ok(diameter),
            Some((argument, other)) => Err(GeometryError::error(
                "E0913",
                argument,
                sentence![
                    "`", text argument, "` contradicts `", text first, "`: it makes the tip diameter ", length other,
                    ", and `", text first, "` makes it ", length diameter
                ],
                sentence!["give one of them only, or correct one"],
            )),
        }
    }
}

/// Checks a stated tip diameter and a stated root diameter, m, against the reference circle and
/// each other. `derived` are the diameters that follow from rack and profile shift. Returns a
/// warning about a tip circle on the wrong side of the reference circle.
///
/// # Errors
/// E0929: tip and root diameter are exchanged.
pub(crate) fn check_sides(
    tip: &TipStatements,
    root_diameter: Option<f64>,
    proportions: &Proportions,
    [derived_tip, derived_root]: [f64; 2],
) -> Result<Option<GeometryError>, GeometryError> {
    let (name, diameter) = tip.diameter;
    let stated = diameter.map(|diameter| (name, diameter));
    let Some((argument, diameter)) = stated.or(tip.tip_diameter.map(|diameter| ("tip_diameter", diameter)))
    else {
        return Ok(None);
    };
    let reference = proportions.reference_diameter;
    let outside = |diameter: f64| proportions.sense * (diameter - reference) > 0.0;
    let (kind, side) =
        if proportions.sense > 0.0 { ("an external", "outside") } else { ("an internal", "inside") };
    // With a large negative addendum modification even a correct tip circle crosses the reference
    // circle.
    if outside(diameter) || !outside(derived_tip) {
        return Ok(None);
    }
    if let Some(root) = root_diameter.filter(|root| outside(*root) && !outside(derived_root)) {
        return Err(GeometryError::error(
            "E0929",
            argument,
            sentence![
                "the tip diameter of ", length diameter, " and the root diameter of ", length root,
                " are exchanged: the teeth of ", text kind, " gear end ", text side, " the reference circle of ",
                length reference
            ],
            sentence!["write `", text argument, " = ", length root, "` and `root_diameter = ", length diameter, "`"],
        ));
    }
    let found = if proportions.sense > 0.0 { "inside" } else { "outside" };
    Ok(Some(GeometryError::warning(
        "W0842",
        argument,
        sentence![
            "the tip diameter of ", length diameter, " is ", text found, " the reference circle of ", length reference,
            ": the teeth of ", text kind, " gear end ", text side, " this circle"
        ],
        sentence![
            "is `", text argument, " = ", length derived_tip,
            "` meant? This is the tip diameter that follows from rack and profile shift"
        ],
    )))
}

/// Diameter at which a solid gear is supported, as a fraction of its root diameter. See
/// `docs/theory/gear-geometry.md`.
pub(crate) const SOLID_SUPPORT: f64 = 0.5;
/// Default thickness of the rim of an internal gear, in normal modules.
const DEFAULT_RIM: f64 = 4.0;

/// Statements of the blank.
#[derive(Clone, Debug)]
pub(crate) struct BlankStatements {
    pub rim: Option<Rim>,
    /// Diameter of the bore with its argument, or the outer diameter of an internal gear, m.
    pub far: (&'static str, Option<f64>),
    /// Thickness of the rim from the root circle, m.
    pub rim_thickness: Option<f64>,
}

impl BlankStatements {
    /// Argument that states the blank in place of a rim, if any.
    pub fn stated(&self) -> Option<&'static str> {
        let (far, diameter) = self.far;
        diameter.map(|_| far).or(self.rim_thickness.map(|_| "rim_thickness"))
    }

    /// Returns the rim, and `true` for a gear that is solid to its axis. `root` is the root
    /// diameter, m.
    ///
    /// # Errors
    /// E0914: two statements contradict each other. E0915: the bore or the outer diameter is on the
    /// wrong side of the root circle.
    pub fn resolve(self, proportions: &Proportions, root: f64) -> Result<(Rim, bool), GeometryError> {
        let sense = proportions.sense;
        let (far_name, far) = self.far;
        let by_thickness = self.rim_thickness.map(|thickness| root - sense * 2.0 * thickness);
        if let Some(rim) = self.rim {
            let other = far.map(|_| far_name).or(by_thickness.map(|_| "rim_thickness"));
            return match other {
                None => Ok((rim, false)),
                Some(other) => Err(GeometryError::error(
                    "E0914",
                    other,
                    sentence![
                        "`", text other, "` and `rim` both state the blank: the rim is supported at a diameter of ",
                        length 2.0 * rim.fixed_radius
                    ],
                    sentence!["leave out `", text other, "`, or `rim`"],
                )),
            };
        }
        if let (Some(far), Some(other)) = (far, by_thickness)
            && (far - other).abs() > 2.0 * SAME_LENGTH * proportions.module
        {
            return Err(GeometryError::error(
                "E0914",
                "rim_thickness",
                sentence![
                    "`rim_thickness` contradicts `", text far_name, "`: it ends the rim at a diameter of ", length other, ", and `",
                    text far_name, "` at ", length far
                ],
                sentence!["give one of them only, or correct one"],
            ));
        }
        let named = far.map(|far| (far_name, far)).or(by_thickness.map(|far| ("rim_thickness", far)));
        let default =
            if sense > 0.0 { SOLID_SUPPORT * root } else { root + 2.0 * DEFAULT_RIM * proportions.module };
        let solid = named.is_none() && sense > 0.0;
        let (argument, end) = named.unwrap_or((far_name, default));
        if end.is_nan() || sense * (root - end) <= 0.0 || end <= 0.0 {
            return Err(wrong_side(argument, end, root, sense));
        }
        // The radius at which the rim begins has no effect on a model without a web.
        let radius = 0.25 * (root + end);
        let rim = Rim { radius, fixed_radius: 0.5 * end, web: None, support: BoreSupport::Rigid };
        Ok((rim, solid))
    }
}

fn wrong_side(argument: &'static str, end: f64, root: f64, sense: f64) -> GeometryError {
    let message = match argument {
        "rim_thickness" => sentence![
            "a rim of this thickness does not fit under a root diameter of ", length root, ": it would end at a diameter of ",
            length end
        ],
        _ if end <= 0.0 => sentence!["`", text argument, "` is 0, which is not a diameter"],
        _ if sense > 0.0 => sentence![
            "the bore of ", length end, " is not smaller than the root diameter of ", length root
        ],
        _ => sentence![
            "the rim of this internal gear ends at a diameter of ", length end, ", inside the root diameter of ", length root
        ],
    };
    let help = match argument {
        "rim_thickness" => {
            sentence!["give a thickness below ", length 0.5 * root, ", the radius of the root circle"]
        }
        _ if sense > 0.0 && end <= 0.0 => sentence!["leave `", text argument, "` out for a solid gear"],
        _ if sense > 0.0 => {
            sentence!["check the unit, and that it is a diameter; leave it out for a solid gear"]
        }
        _ => sentence!["give the outer diameter of the gear, above its root diameter"],
    };
    GeometryError::error("E0915", argument, message, help)
}
