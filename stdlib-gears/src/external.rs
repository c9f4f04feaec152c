//! External gears as a rack cuts them: every radius, roll angle and thickness that follows from the data.

use crate::error::{GeometryError, Severity, sentence};
use crate::fillet::{RackRoot, RootFillet, RootGeneration, Side};
use crate::involute::{involute, involute_of_roll, radius_at_roll, roll_at_radius, roll_of_involute};
use crate::rack::Rack;
use crate::root_finding::solve_bracketed;
use calyx_abi::math;
use std::f64::consts::{FRAC_PI_2, PI};

/// What is given of an external gear. SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExternalGearData {
    /// Number of teeth, 4 at least.
    pub teeth: u32,
    /// What generates the teeth.
    pub rack: Rack,
    /// Transverse circular thickness at the pitch circle, m. See [`Rack::thickness_of_shift`].
    pub tooth_thickness: f64,
    /// m.
    pub outer_radius: f64,
    /// m.
    pub root_radius: f64,
    /// Rounding of the tip edge, m; `None` takes [`DEFAULT_TIP_EDGE`] modules.
    pub tip_edge_radius: Option<f64>,
}

/// Rounding of a tip edge of which nothing is said, in modules.
pub const DEFAULT_TIP_EDGE: f64 = 0.02;

/// Roll angle within which the fillet counts as meeting the involute on the base circle: where an undercut fillet
/// crosses the involute is then beyond rounding, as the two differ by the cube of this.
const AT_BASE_CIRCLE: f64 = 3e-5;

/// A sound external gear and what follows from its data. SI units; angles in rad.
#[derive(Clone, Debug, PartialEq)]
pub struct ExternalGear {
    /// Number of teeth.
    pub teeth: u32,
    /// What generates the teeth.
    pub rack: Rack,
    /// Transverse, along the pitch circle.
    pub tooth_thickness: f64,
    /// Of the circle through the tips.
    pub outer_radius: f64,
    /// Of the circle on which the spaces end.
    pub root_radius: f64,
    /// Rounding of the tip edge.
    pub tip_edge_radius: f64,
    /// Of the circle on which the rack rolls, `teeth * module / 2`.
    pub pitch_radius: f64,
    /// Of the circle whose involutes the flanks are.
    pub base_radius: f64,
    /// Distance between neighbouring involutes along their common normal.
    pub base_pitch: f64,
    /// Half the angle that the tooth's two involutes enclose at the base circle.
    pub half_base_angle: f64,
    /// Roll angle at the outer circle.
    pub tip_roll: f64,
    /// Where the involute begins: where the fillet goes over into it, or cuts it if there is undercut.
    pub form_radius: f64,
    /// Roll angle there.
    pub form_roll: f64,
    /// Whether the rack's tip cuts away part of the involute.
    pub undercut: bool,
    /// Distance of the centre of the rack's rounding from the middle of its tooth.
    pub rack_tip_centre_halfwidth: f64,
    /// What an engineer should know of this gear (severity [`Severity::Warning`]).
    pub warnings: Vec<GeometryError>,
    pub(crate) generation: RackRoot,
    pub(crate) form_inclination: f64,
}

impl ExternalGear {
    /// The gear, or everything that is wrong with it as far as it can be told at once.
    pub fn new(data: ExternalGearData) -> Result<Self, Vec<GeometryError>> {
        let errors = check_data(&data);
        if !errors.is_empty() {
            return Err(errors);
        }
        let ExternalGearData { teeth, rack, tooth_thickness, outer_radius, root_radius, tip_edge_radius } =
            data;
        let count = f64::from(teeth);
        let pitch_radius = 0.5 * count * rack.module;
        let (sine, cosine) = math::sincos(rack.pressure_angle);
        let base_radius = pitch_radius * cosine;
        let tip_centre_depth = pitch_radius - root_radius - rack.tip_radius;
        let halfwidth = 0.5 * (rack.pitch() - tooth_thickness)
            - tip_centre_depth * sine / cosine
            - rack.tip_support(rack.pressure_angle) / cosine;
        let generation = RackRoot {
            teeth,
            pitch_radius,
            tip_centre_depth,
            tip_centre_halfwidth: halfwidth,
            tip_radius: rack.tip_radius,
            tip_stretch: rack.tip_stretch,
        };
        // Length of the tangent to the base circle where the straight flank of the rack ends its work. Negative
        // where the line of action does not reach so far: then the rack's tip cuts into the involute.
        let tangent =
            pitch_radius * sine - (tip_centre_depth + rack.tip_touch_depth(rack.pressure_angle)) / sine;
        let mut gear = Self {
            teeth,
            rack,
            tooth_thickness,
            outer_radius,
            root_radius,
            tip_edge_radius: tip_edge_radius.unwrap_or(DEFAULT_TIP_EDGE * rack.module),
            pitch_radius,
            base_radius,
            base_pitch: rack.pitch() * cosine,
            half_base_angle: 0.5 * tooth_thickness / pitch_radius + involute(rack.pressure_angle),
            tip_roll: roll_at_radius(base_radius, outer_radius),
            form_radius: base_radius.hypot(tangent),
            form_roll: tangent / base_radius,
            undercut: tangent < 0.0,
            rack_tip_centre_halfwidth: halfwidth,
            warnings: Vec::new(),
            generation,
            form_inclination: rack.pressure_angle,
        };
        let mut errors = Vec::new();
        if halfwidth < 0.0 {
            errors.push(gear.rack_tip_error());
        } else if gear.form_roll.abs() < AT_BASE_CIRCLE {
            // The involute has no direction on the base circle itself.
            gear.form_roll = gear.form_roll.max(1e-6);
            gear.form_radius = gear.radius_at_roll(gear.form_roll);
        } else if gear.undercut {
            match gear.undercut_inclination() {
                Some(inclination) => {
                    let [x, y] = RootGeneration::Rack(generation).at(inclination).position;
                    gear.form_inclination = inclination;
                    gear.form_radius = x.hypot(y);
                    gear.form_roll = roll_at_radius(base_radius, gear.form_radius);
                    gear.warnings.push(gear.undercut_warning());
                }
                None => errors.push(GeometryError { severity: Severity::Error, ..gear.undercut_warning() }),
            }
        }
        let tip_thickness = gear.thickness_at(outer_radius);
        if outer_radius <= base_radius || (errors.is_empty() && gear.form_radius >= outer_radius) {
            errors.push(gear.no_involute_error());
        } else if tip_thickness <= 0.0 {
            errors.push(gear.pointed_error());
        } else if errors.is_empty()
            && let Some(error) = gear.check_tip_edge(tip_thickness)
        {
            errors.push(error);
        }
        if errors.is_empty() { Ok(gear) } else { Err(errors) }
    }

    /// Angle from one tooth to the next.
    pub fn pitch_angle(&self) -> f64 {
        2.0 * PI / f64::from(self.teeth)
    }

    /// Circular thickness of the tooth at a radius not below the base circle, m.
    pub fn thickness_at(&self, radius: f64) -> f64 {
        2.0 * radius * self.half_angle_at_roll(roll_at_radius(self.base_radius, radius))
    }

    /// Thickness at the outer circle, between the flanks prolonged, m.
    pub fn tip_thickness(&self) -> f64 {
        self.thickness_at(self.outer_radius)
    }

    /// Half the angle that the tooth's flanks enclose at a roll angle.
    pub fn half_angle_at_roll(&self, roll: f64) -> f64 {
        self.half_base_angle - involute_of_roll(roll)
    }

    /// Roll angle at a radius (m); 0 below the base circle.
    pub fn roll_at_radius(&self, radius: f64) -> f64 {
        roll_at_radius(self.base_radius, radius)
    }

    /// Radius at a roll angle, m.
    pub fn radius_at_roll(&self, roll: f64) -> f64 {
        radius_at_roll(self.base_radius, roll)
    }

    /// Profile shift coefficient that gives this thickness, in modules of the plane that the rack
    /// was given in ([`Rack::own_module`]).
    pub fn profile_shift(&self) -> f64 {
        self.shift() / self.rack.own_module()
    }

    /// Profile shift as a length, m.
    fn shift(&self) -> f64 {
        self.rack.shift_of_thickness(self.tooth_thickness) * self.rack.module
    }

    /// Radius of curvature of the fillet where it meets the root circle, m.
    pub fn root_fillet_curvature_radius(&self) -> f64 {
        RootGeneration::Rack(self.generation).curvature_radius(FRAC_PI_2)
    }

    /// Radius of the circle through the centres of balls, or of spur gears pins, that rest in the
    /// spaces, m. `base_helix` is the base helix angle, rad (ISO 21771, 7.5: a ball touches the
    /// flanks of helical teeth at right angles to them).
    pub fn pin_centre_radius(&self, pin_diameter: f64, base_helix: f64) -> f64 {
        let along_base_circle = 0.5 * pin_diameter / (self.base_radius * math::cos(base_helix));
        let value = self.half_base_angle + along_base_circle - PI / f64::from(self.teeth);
        self.radius_at_roll(roll_of_involute(value))
    }

    /// Measurement over two pins or balls in spaces as nearly opposite as there are, m; see
    /// [`Self::pin_centre_radius`].
    pub fn over_pins(&self, pin_diameter: f64, base_helix: f64) -> f64 {
        let odd = if self.teeth % 2 == 1 { math::cos(FRAC_PI_2 / f64::from(self.teeth)) } else { 1.0 };
        2.0 * self.pin_centre_radius(pin_diameter, base_helix) * odd + pin_diameter
    }

    /// Whether such pins or balls touch the involutes of the flanks beside a space, as a
    /// measurement over them supposes.
    pub fn pin_touches_flanks(&self, pin_diameter: f64, base_helix: f64) -> bool {
        let centre = self.roll_at_radius(self.pin_centre_radius(pin_diameter, base_helix));
        let touching = centre - 0.5 * pin_diameter * math::cos(base_helix) / self.base_radius;
        (self.form_roll..self.tip_roll).contains(&touching)
    }

    /// Span measurement (base tangent length) over a number of teeth, m: at right angles to the
    /// teeth, `base_helix` (rad) being the base helix angle.
    pub fn span(&self, teeth: u32, base_helix: f64) -> f64 {
        let transverse =
            (f64::from(teeth) - 1.0) * self.base_pitch + 2.0 * self.base_radius * self.half_base_angle;
        transverse * math::cos(base_helix)
    }

    /// The number of teeth over which the jaws touch nearest to the middle of the flanks, and the span measurement; `None`
    /// if for no number they touch involutes, or if the face is narrower than the span of helical teeth needs (m).
    pub fn usual_span(&self, base_helix: f64, face_width: f64) -> Option<(u32, f64)> {
        let middle = self.roll_at_radius(self.pitch_radius + self.shift());
        // The part of half the span in the transverse section is the tangent from the base circle
        // to where a jaw touches.
        let cosine = math::cos(base_helix);
        let touching = |teeth: u32| 0.5 * cosine * self.span(teeth, base_helix) / self.base_radius;
        let most = (self.teeth / 2).max(2);
        let nearest =
            (middle - touching(1)) * 2.0 * self.base_radius / (self.base_pitch * cosine * cosine) + 1.0;
        let teeth = (nearest.round() as u32).clamp(2, most);
        let span = self.span(teeth, base_helix);
        let reached = (self.form_roll..self.tip_roll).contains(&touching(teeth));
        (reached && span * math::sin(base_helix) < face_width).then_some((teeth, span))
    }

    /// Depth below the pitch circle to which the straight flank of the rack cuts, m.
    fn straight_depth(&self) -> f64 {
        self.generation.tip_centre_depth + self.rack.tip_touch_depth(self.rack.pressure_angle)
    }

    /// The profile shift, in modules of the plane that the rack was given in
    /// ([`Rack::own_module`]), by which this gear lies above the beginning of undercut, if outer
    /// and root diameter shift with it. Negative for a gear that is undercut.
    pub fn undercut_margin(&self) -> f64 {
        self.above_undercut() / self.rack.own_module()
    }

    /// The same as a length, m.
    fn above_undercut(&self) -> f64 {
        let sine = math::sin(self.rack.pressure_angle);
        self.pitch_radius * sine * sine - self.straight_depth()
    }

    /// The number of teeth below which the rack, reaching to the same depth, undercuts; not whole.
    pub fn undercut_teeth(&self) -> f64 {
        let sine = math::sin(self.rack.pressure_angle);
        2.0 * self.straight_depth() / (self.rack.module * sine * sine)
    }

    /// The root of one side of a tooth, from the form circle to the middle of the space.
    pub fn root_fillet(&self, side: Side) -> RootFillet {
        RootFillet::new(RootGeneration::Rack(self.generation), self.form_inclination, side)
    }

    /// Where the fillet of an undercut tooth crosses the involute: the inclination of its normal there.
    fn undercut_inclination(&self) -> Option<f64> {
        let generation = RootGeneration::Rack(self.generation);
        // Positive where the fillet is outside the tooth that the two involutes enclose.
        let clearance = |inclination: f64| {
            let [x, y] = generation.at(inclination).position;
            let roll = roll_at_radius(self.base_radius, x.hypot(y));
            math::atan2(y, x) - self.half_angle_at_roll(roll)
        };
        let above_base = |inclination: f64| {
            let [x, y] = generation.at(inclination).position;
            x.hypot(y) - self.base_radius
        };
        let start = self.rack.pressure_angle;
        let at_base = solve_bracketed(above_base, start, FRAC_PI_2);
        (clearance(start) > 0.0 && clearance(at_base) < 0.0)
            .then(|| solve_bracketed(clearance, start, at_base))
    }

    fn rack_tip_error(&self) -> GeometryError {
        let (sine, cosine) = math::sincos(self.rack.pressure_angle);
        let dedendum = self.pitch_radius - self.root_radius;
        let land = 0.5 * (self.rack.pitch() - self.tooth_thickness) - dedendum * sine / cosine;
        let per_radius = (self.rack.tip_stretch * cosine).hypot(sine);
        let largest = land * cosine / (per_radius - sine);
        if largest <= 0.0 {
            return GeometryError::error(
                "E0613",
                "root_diameter",
                sentence![
                    "the rack's tooth comes to a point before it reaches the root circle of diameter ",
                    length 2.0 * self.root_radius
                ],
                sentence![
                    "enlarge `root_diameter`, or reduce `tooth_thickness` so that the rack's tooth is thicker"
                ],
            );
        }
        GeometryError::error(
            "E0612",
            "tip_radius",
            sentence![
                "the rack's tip radius of ", length self.rack.tip_radius,
                " does not fit on its tooth: at most ", at_most length largest, " does"
            ],
            sentence!["reduce `tip_radius` to at most ", at_most length largest, ", or enlarge `root_diameter`"],
        )
    }

    fn undercut_warning(&self) -> GeometryError {
        GeometryError::warning(
            "E0614",
            "teeth",
            sentence![
                "the rack's tip undercuts the teeth: the involute begins only at radius ", length self.form_radius,
                " instead of the base circle's ", length self.base_radius
            ],
            sentence![
                "use more teeth, or enlarge `profile_shift` by ", at_least number -self.undercut_margin(),
                " and both `root_diameter` and `outer_diameter` by ", at_least length -2.0 * self.above_undercut(),
                " or more"
            ],
        )
    }

    fn no_involute_error(&self) -> GeometryError {
        GeometryError::error(
            "E0615",
            "outer_diameter",
            sentence![
                "there is no involute between the form circle of diameter ", length 2.0 * self.form_radius,
                " and the outer circle of diameter ", length 2.0 * self.outer_radius
            ],
            sentence!["enlarge `outer_diameter`"],
        )
    }

    fn pointed_error(&self) -> GeometryError {
        let at_point = self.radius_at_roll(roll_of_involute(self.half_base_angle));
        GeometryError::error(
            "E0616",
            "outer_diameter",
            sentence![
                "the tooth comes to a point at diameter ", length 2.0 * at_point,
                ", before the outer diameter of ", length 2.0 * self.outer_radius
            ],
            sentence!["reduce `outer_diameter`, or enlarge `tooth_thickness` (or `profile_shift`)"],
        )
    }

    /// The rounding must leave some of the involute and some of the tip circle.
    fn check_tip_edge(&self, tip_thickness: f64) -> Option<GeometryError> {
        let edge = self.tip_edge_radius;
        let centre_radius = self.outer_radius - edge;
        // The involute's offset inwards is the involute of the same base circle, turned.
        let end_roll = (edge
            + (centre_radius * centre_radius - self.base_radius * self.base_radius).max(0.0).sqrt())
            / self.base_radius;
        let centre_angle = self.half_base_angle - end_roll + math::atan(end_roll - edge / self.base_radius);
        let fits =
            edge > 0.0 && centre_radius > self.form_radius && end_roll > self.form_roll && centre_angle > 0.0;
        (!fits).then(|| {
            GeometryError::error(
                "E0617",
                "tip_edge_radius",
                sentence![
                    "a tip edge rounded with ", length edge, " does not fit on a tip ", length tip_thickness, " thick"
                ],
                sentence![
                    "give a positive `tip_edge_radius` well below half the tip thickness, or make the tip thicker by a smaller `outer_diameter`"
                ],
            )
        })
    }
}

/// What can be told wrong before anything is computed.
fn check_data(data: &ExternalGearData) -> Vec<GeometryError> {
    let mut errors = Vec::new();
    if !(4..=100_000).contains(&data.teeth) {
        errors.push(GeometryError::error(
            "E0604",
            "teeth",
            sentence!["a gear of ", number f64::from(data.teeth), " teeth"],
            sentence!["give between 4 and 100000 teeth"],
        ));
    }
    let pitch = data.rack.pitch();
    if !(data.tooth_thickness > 0.0 && data.tooth_thickness < pitch) {
        // In the plane of the argument.
        let stretch = data.rack.tip_stretch;
        let (given, pitch) = (data.tooth_thickness / stretch, pitch / stretch);
        errors.push(GeometryError::error(
            "E0605",
            "tooth_thickness",
            sentence![
                "a tooth ", length given, " thick at the pitch circle leaves no tooth or no space: the pitch is ",
                length pitch
            ],
            sentence!["give a thickness near half the pitch, ", length 0.5 * pitch],
        ));
    }
    if data.root_radius.is_nan() || data.root_radius <= 0.0 {
        errors.push(GeometryError::error(
            "E0606",
            "root_diameter",
            sentence!["the root diameter is ", length 2.0 * data.root_radius],
            sentence!["give a positive root diameter"],
        ));
    }
    if !(data.outer_radius.is_finite() && data.outer_radius > data.root_radius) {
        errors.push(GeometryError::error(
            "E0607",
            "outer_diameter",
            sentence![
                "the outer diameter of ", length 2.0 * data.outer_radius,
                " is not larger than the root diameter of ", length 2.0 * data.root_radius
            ],
            sentence!["give an outer diameter larger than the root diameter, usually by about 4.5 modules"],
        ));
    }
    let pitch_radius = 0.5 * f64::from(data.teeth) * data.rack.module;
    if data.root_radius >= pitch_radius {
        errors.push(GeometryError::error(
            "E0608",
            "root_diameter",
            sentence![
                "the root diameter of ", length 2.0 * data.root_radius,
                " is not below the pitch diameter of ", length 2.0 * pitch_radius,
                ", so the rack does not reach the gear's teeth in its standard setting"
            ],
            sentence!["check `teeth` and the rack's module, or reduce `root_diameter`"],
        ));
    }
    if let Some(edge) = data.tip_edge_radius
        && !(edge > 0.0 && edge.is_finite())
    {
        errors.push(GeometryError::error(
            "E0617",
            "tip_edge_radius",
            sentence!["the tip edge's rounding is ", length edge],
            sentence!["give a positive `tip_edge_radius`, or leave it out for ", length DEFAULT_TIP_EDGE * data.rack.module],
        ));
    }
    errors
}

/// A ring under the teeth: checks its diameters against the gear's root.
pub fn check_rim(root_radius: f64, rim_radius: f64, inner_radius: f64) -> Result<(), GeometryError> {
    if rim_radius.is_nan() || rim_radius >= root_radius {
        return Err(GeometryError::error(
            "E0620",
            "diameter",
            sentence![
                "the rim begins at diameter ", length 2.0 * rim_radius,
                ", which is not below the root diameter of ", length 2.0 * root_radius
            ],
            sentence!["reduce the rim's `diameter`, or enlarge `root_diameter`"],
        ));
    }
    if !(inner_radius > 0.0 && inner_radius < rim_radius) {
        return Err(GeometryError::error(
            "E0621",
            "inner_diameter",
            sentence![
                "the rim's inner diameter of ", length 2.0 * inner_radius,
                " is not between zero and its outer diameter of ", length 2.0 * rim_radius
            ],
            sentence!["give a positive inner diameter smaller than the rim's `diameter`"],
        ));
    }
    Ok(())
}
