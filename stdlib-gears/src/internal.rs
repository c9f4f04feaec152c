//! Internal gears as a shaper cuts them: every radius, roll angle and thickness that follows from the data.
//!
//! A space of the ring is what a tooth of the cutter leaves while their pitch circles roll. The ring's root circle is where the cutter's
//! tips come, so the root radius and the cutter's outer radius give the distance of their axes; at that distance the cutter's tooth
//! is as thick as the space is wide.

use crate::error::{GeometryError, Severity, sentence};
use crate::fillet::{RootFillet, RootGeneration, ShaperRoot, Side};
use crate::involute::{involute, involute_of_roll, radius_at_roll, roll_at_radius, roll_of_involute};
use crate::root_finding::solve_bracketed;
use crate::shaper::Shaper;
use calyx_abi::math;
use std::f64::consts::{FRAC_PI_2, PI};

/// What is given of an internal gear. SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InternalGearData {
    /// Number of teeth, more than the shaper's.
    pub teeth: u32,
    /// What generates the teeth.
    pub shaper: Shaper,
    /// Transverse circular thickness at the pitch circle, m. See [`Shaper::thickness_of_shift`].
    pub tooth_thickness: f64,
    /// Of the circle through the tips, m.
    pub minor_radius: f64,
    /// Of the circle on which the spaces end, the larger one, m.
    pub root_radius: f64,
    /// Rounding of the tip edge, m; `None` takes [`crate::external::DEFAULT_TIP_EDGE`] modules.
    pub tip_edge_radius: Option<f64>,
}

/// A sound internal gear and what follows from its data. SI units; angles in rad, roll angles positive.
#[derive(Clone, Debug, PartialEq)]
pub struct InternalGear {
    /// Number of teeth.
    pub teeth: u32,
    /// What generates the teeth.
    pub shaper: Shaper,
    /// Transverse, along the pitch circle.
    pub tooth_thickness: f64,
    /// Of the circle through the tips.
    pub minor_radius: f64,
    /// Of the circle on which the spaces end.
    pub root_radius: f64,
    /// Rounding of the tip edge.
    pub tip_edge_radius: f64,
    /// `teeth * module / 2`.
    pub pitch_radius: f64,
    /// Of the circle whose involutes the flanks are.
    pub base_radius: f64,
    /// Distance between neighbouring involutes along their common normal.
    pub base_pitch: f64,
    /// Half the angle that the two involutes beside a space enclose at the base circle.
    pub half_base_angle_of_space: f64,
    /// Roll angle at the minor circle, the smallest.
    pub tip_roll: f64,
    /// Where the involute ends and the fillet begins.
    pub form_radius: f64,
    /// Roll angle there, the largest.
    pub form_roll: f64,
    /// Distance of the axes at which the shaper cuts to the root circle.
    pub cutting_distance: f64,
    /// Pressure angle of ring and cutter at that distance.
    pub cutting_pressure_angle: f64,
    /// Transverse thickness of the cutter's teeth at its reference circle.
    pub cutter_thickness: f64,
    /// What an engineer should know of this gear (severity [`Severity::Warning`]).
    pub warnings: Vec<GeometryError>,
    generation: ShaperRoot,
}

impl InternalGear {
    /// The gear, or everything that is wrong with it as far as it can be told at once.
    ///
    /// # Errors
    /// E0604, E0605, E0615 to E0619, E0624 to E0629.
    pub fn new(data: InternalGearData) -> Result<Self, Vec<GeometryError>> {
        let errors = check_data(&data);
        if !errors.is_empty() {
            return Err(errors);
        }
        let InternalGearData { teeth, shaper, tooth_thickness, minor_radius, root_radius, tip_edge_radius } =
            data;
        let count = f64::from(teeth);
        let pitch_radius = 0.5 * count * shaper.module;
        let base_radius = pitch_radius * math::cos(shaper.pressure_angle);
        let half_base_angle_of_space =
            0.5 * (shaper.pitch() - tooth_thickness) / pitch_radius + involute(shaper.pressure_angle);

        // The cutter in the ring.
        let cutter_base = shaper.base_radius();
        let (cutting_distance, base_difference) =
            (root_radius - shaper.outer_radius(), base_radius - cutter_base);
        if cutting_distance <= base_difference {
            return Err(vec![reach_error(&data, base_difference)]);
        }
        let offset = ((cutting_distance - base_difference) * (cutting_distance + base_difference)).sqrt();
        let cutting_pressure_angle = math::atan2(offset, base_difference);
        let cutter_count = f64::from(shaper.teeth);
        let ratio = cutter_count / count;
        let cutter_half_base_angle = (count * half_base_angle_of_space
            - (count - cutter_count) * involute(cutting_pressure_angle))
            / cutter_count;
        let cutter_pitch = cutter_base / math::cos(cutting_pressure_angle);
        let corner = Corner {
            outer_radius: shaper.outer_radius(),
            base_radius: cutter_base,
            half_base_angle: cutter_half_base_angle,
        };
        let Some(tip_centre_angle) = corner.centre_angle(shaper.tip_radius).filter(|&angle| angle >= 0.0)
        else {
            return Err(vec![corner.error(&shaper)]);
        };
        let generation = ShaperRoot {
            teeth,
            ratio,
            pitch_radii: [cutting_distance + cutter_pitch, cutter_pitch],
            tip_centre_radius: shaper.outer_radius() - shaper.tip_radius,
            tip_centre_angle,
            tip_radius: shaper.tip_radius,
        };
        // From where the line of action touches the ring's base circle to where the cutter's flank ends.
        let tangent = offset + corner.centre_tangent(shaper.tip_radius).unwrap_or(0.0) + shaper.tip_radius;
        let mut gear = Self {
            teeth,
            shaper,
            tooth_thickness,
            minor_radius,
            root_radius,
            tip_edge_radius: tip_edge_radius.unwrap_or(crate::external::DEFAULT_TIP_EDGE * shaper.module),
            pitch_radius,
            base_radius,
            base_pitch: shaper.pitch() * math::cos(shaper.pressure_angle),
            half_base_angle_of_space,
            tip_roll: roll_at_radius(base_radius, minor_radius),
            form_radius: base_radius.hypot(tangent),
            form_roll: tangent / base_radius,
            cutting_distance,
            cutting_pressure_angle,
            cutter_thickness: 2.0
                * shaper.reference_radius()
                * (cutter_half_base_angle - involute(shaper.pressure_angle)),
            warnings: Vec::new(),
            generation,
        };
        let errors = gear.check(&corner, offset);
        if errors.is_empty() {
            gear.warnings.extend(gear.trimmed_in_feeding(&corner));
            Ok(gear)
        } else {
            Err(errors)
        }
    }

    /// Half the angle that a tooth's involutes enclose at the base circle, rad; negative where they would cross outside of it.
    pub fn half_base_angle(&self) -> f64 {
        PI / f64::from(self.teeth) - self.half_base_angle_of_space
    }

    /// Circular thickness of the tooth at a radius not below the base circle, m.
    pub fn thickness_at(&self, radius: f64) -> f64 {
        2.0 * radius * (self.half_base_angle() + involute_of_roll(self.roll_at_radius(radius)))
    }

    /// Thickness at the minor circle, between the flanks prolonged, m.
    pub fn tip_thickness(&self) -> f64 {
        self.thickness_at(self.minor_radius)
    }

    /// Roll angle at a radius (m); 0 below the base circle.
    pub fn roll_at_radius(&self, radius: f64) -> f64 {
        roll_at_radius(self.base_radius, radius)
    }

    /// Radius at a roll angle, m.
    pub fn radius_at_roll(&self, roll: f64) -> f64 {
        radius_at_roll(self.base_radius, roll)
    }

    /// Profile shift coefficient that gives this thickness, positive outwards.
    pub fn profile_shift(&self) -> f64 {
        self.shaper.shift_of_thickness(self.tooth_thickness)
    }

    /// Radius of curvature of the fillet where it meets the root circle, m.
    pub fn root_fillet_curvature_radius(&self) -> f64 {
        RootGeneration::Shaper(self.generation).curvature_radius(FRAC_PI_2)
    }

    /// Measurement between two pins, or of helical gears balls, in spaces as nearly opposite as
    /// there are, m. `base_helix` is the base helix angle, rad.
    pub fn between_pins(&self, pin_diameter: f64, base_helix: f64) -> f64 {
        let along_base_circle = 0.5 * pin_diameter / (self.base_radius * math::cos(base_helix));
        let value = self.half_base_angle_of_space - along_base_circle;
        let centre = self.radius_at_roll(roll_of_involute(value));
        let odd = if self.teeth % 2 == 1 { math::cos(FRAC_PI_2 / f64::from(self.teeth)) } else { 1.0 };
        2.0 * centre * odd - pin_diameter
    }

    /// Whether such pins or balls touch the involutes of the flanks beside a space, as a
    /// measurement between them supposes.
    pub fn pin_touches_flanks(&self, pin_diameter: f64, base_helix: f64) -> bool {
        let (half, cosine) = (0.5 * pin_diameter / self.base_radius, math::cos(base_helix));
        let touching = roll_of_involute(self.half_base_angle_of_space - half / cosine) + half * cosine;
        (self.tip_roll..self.form_roll).contains(&touching)
    }

    /// The root of one side of a tooth, from the form circle to the middle of the space.
    pub fn root_fillet(&self, side: Side) -> RootFillet {
        RootFillet::new(RootGeneration::Shaper(self.generation), self.cutting_pressure_angle, side)
    }

    /// What the data alone does not show.
    fn check(&self, corner: &Corner, offset: f64) -> Vec<GeometryError> {
        let mut errors = Vec::new();
        if self.form_radius <= self.minor_radius || self.form_radius > self.root_radius {
            errors.push(GeometryError::error(
                "E0615",
                "minor_diameter",
                sentence![
                    "there is no involute between the minor circle of diameter ", length 2.0 * self.minor_radius,
                    " and the form circle of diameter ", length 2.0 * self.form_radius
                ],
                sentence!["reduce `minor_diameter`, or the shaper's tip radius"],
            ));
            return errors;
        }
        let tip_thickness = self.tip_thickness();
        if tip_thickness <= 0.0 {
            let point = self.radius_at_roll(roll_of_involute(-self.half_base_angle()));
            errors.push(GeometryError::error(
                "E0616",
                "minor_diameter",
                sentence![
                    "the tooth comes to a point at diameter ", length 2.0 * point,
                    ", before the minor diameter of ", length 2.0 * self.minor_radius
                ],
                sentence!["enlarge `minor_diameter`, or `tooth_thickness`"],
            ));
            return errors;
        }
        errors.extend(self.check_tip_edge(tip_thickness));
        // The cutter's flank ends at its base circle; what the ring's tips would need of it below that it cannot cut.
        if self.base_radius * self.tip_roll < offset {
            let least = self.base_radius.hypot(offset);
            errors.push(GeometryError::error(
                "E0628",
                "minor_diameter",
                sentence![
                    "the shaper's involute ends at its base circle, and cuts the ring's only down to diameter ", at_least length 2.0 * least,
                    ": the tips down to ", length 2.0 * self.minor_radius, " would be cut away"
                ],
                sentence![
                    "enlarge `minor_diameter` to at least ", at_least length 2.0 * least, ", or use a shaper with more teeth"
                ],
            ));
        }
        let teeth = [self.shaper.teeth, self.teeth];
        let rolls = [roll_at_radius(corner.base_radius, corner.outer_radius), self.tip_roll];
        let margin = tip_margin(
            teeth,
            rolls,
            [corner.outer_radius, self.minor_radius],
            self.cutting_distance,
            self.cutting_pressure_angle,
        );
        if let Some(margin) = margin.filter(|&margin| margin < 0.0) {
            errors.push(GeometryError::error(
                "E0629",
                "shaper",
                sentence![
                    "the shaper of ", number f64::from(self.shaper.teeth), " teeth cuts ", length -margin * self.minor_radius,
                    " off the tips of a ring of ", number f64::from(self.teeth), " teeth as it rolls"
                ],
                sentence!["use a shaper with fewer teeth, or enlarge `minor_diameter`"],
            ));
        }
        errors
    }

    /// The rounding must leave some of the involute and some of the tip circle.
    fn check_tip_edge(&self, tip_thickness: f64) -> Option<GeometryError> {
        let edge = self.tip_edge_radius;
        let centre_radius = self.minor_radius + edge;
        // The involute's offset into the material is the involute of the same base circle, turned.
        let tangent =
            ((centre_radius - self.base_radius) * (centre_radius + self.base_radius)).max(0.0).sqrt();
        let end_roll = (tangent - edge) / self.base_radius;
        let centre_angle = self.half_base_angle() + end_roll - math::atan2(tangent, self.base_radius);
        let fits = edge > 0.0 && end_roll > 0.0 && end_roll < self.form_roll && centre_angle > 0.0;
        (!fits).then(|| {
            GeometryError::error(
                "E0617",
                "tip_edge_radius",
                sentence![
                    "a tip edge rounded with ", length edge, " does not fit on a tip ", length tip_thickness, " thick"
                ],
                sentence![
                    "give a positive `tip_edge_radius` well below half the tip thickness, or make the tip thicker by a larger `minor_diameter`"
                ],
            )
        })
    }

    /// Whether the cutter, which is fed in along the line of the axes, passes the tips of all teeth on its way.
    fn trimmed_in_feeding(&self, corner: &Corner) -> Option<GeometryError> {
        let half_tip = corner.half_base_angle
            - involute_of_roll(roll_at_radius(corner.base_radius, corner.outer_radius));
        let half_space = PI / f64::from(self.teeth) - 0.5 * self.tip_thickness() / self.minor_radius;
        let pitches = [self.shaper.teeth, self.teeth].map(|teeth| 2.0 * PI / f64::from(teeth));
        let deepest = (0..self.shaper.teeth / 4)
            .filter_map(|tooth| {
                let cutter = f64::from(tooth) * pitches[0] + half_tip;
                let ring = f64::from(tooth) * pitches[1] + half_space;
                let beyond = self.cutting_distance + corner.outer_radius * math::cos(cutter)
                    > self.minor_radius * math::cos(ring);
                let overlap = corner.outer_radius * math::sin(cutter) - self.minor_radius * math::sin(ring);
                beyond.then_some(overlap)
            })
            .fold(0.0, f64::max);
        (deepest > 0.0).then(|| {
            GeometryError::warning(
                "E0629",
                "shaper",
                sentence![
                    "the shaper of ", number f64::from(self.shaper.teeth), " teeth trims the ring's tips by ", length deepest,
                    " where it is fed in radially; the model leaves them whole"
                ],
                sentence!["use a shaper with fewer teeth, or enlarge `minor_diameter`"],
            )
        })
    }
}

/// The tip of the cutter's tooth.
struct Corner {
    outer_radius: f64,
    base_radius: f64,
    half_base_angle: f64,
}

impl Corner {
    /// Length of the tangent from the centre of a rounding of the corner (m) to the base circle, if it lies outside of that, m.
    fn centre_tangent(&self, tip_radius: f64) -> Option<f64> {
        let centre = self.outer_radius - tip_radius;
        (centre >= self.base_radius)
            .then(|| ((centre - self.base_radius) * (centre + self.base_radius)).sqrt())
    }

    /// Angle of that centre from the middle of the tooth: it lies on the involute's offset into the tooth.
    fn centre_angle(&self, tip_radius: f64) -> Option<f64> {
        let tangent = self.centre_tangent(tip_radius)?;
        let roll = (tangent + tip_radius) / self.base_radius;
        Some(self.half_base_angle - roll + math::atan(tangent / self.base_radius))
    }

    fn error(&self, shaper: &Shaper) -> GeometryError {
        let angle = |radius: f64| self.centre_angle(radius).unwrap_or(-1.0);
        if angle(0.0) <= 0.0 {
            return GeometryError::error(
                "E0627",
                "shaper",
                sentence![
                    "the shaper's tooth, as thick as the ring's space is wide, comes to a point before its tip circle of diameter ",
                    length 2.0 * self.outer_radius
                ],
                sentence!["reduce the shaper's `addendum` or the ring's `tooth_thickness`"],
            );
        }
        let largest = solve_bracketed(angle, 0.0, self.outer_radius - self.base_radius);
        GeometryError::error(
            "E0626",
            "shaper",
            sentence![
                "the shaper's tip radius of ", length shaper.tip_radius, " does not fit on its tooth: at most ",
                at_most length largest, " does"
            ],
            sentence!["reduce the shaper's `tip_radius` to at most ", at_most length largest, ", or the ring's `tooth_thickness`"],
        )
    }
}

/// How far the tip corners of a pinion stay clear of those of a ring where the pinion's tips pass the ring's minor circle, as an
/// angle about the ring's axis, rad: the least over entering and leaving, on the flanks that touch. `None` where they do not pass it.
/// (After Polder, Overlap interference in internal gears, Mechanism and Machine Theory 19, 1984.)
pub(crate) fn tip_margin(
    teeth: [u32; 2],
    tip_rolls: [f64; 2],
    tip_radii: [f64; 2],
    center_distance: f64,
    pressure_angle: f64,
) -> Option<f64> {
    let [pinion, ring] = tip_radii;
    let ratio = f64::from(teeth[0]) / f64::from(teeth[1]);
    let cosines = [
        (ring * ring - center_distance * center_distance - pinion * pinion)
            / (2.0 * center_distance * pinion),
        (ring * ring + center_distance * center_distance - pinion * pinion) / (2.0 * center_distance * ring),
    ];
    let [own, at_ring] = cosines.map(|cosine| (cosine.abs() < 1.0).then(|| math::acos(cosine)));
    let (own, at_ring) = (own?, at_ring?);
    let [pinion_tip, ring_tip] = tip_rolls.map(involute_of_roll);
    // Both corners' polar angles, were the teeth in contact at the pitch point.
    let apart = involute(pressure_angle) * (1.0 - ratio) + ratio * pinion_tip - ring_tip;
    let passing = at_ring - ratio * own;
    Some(apart + passing.min(-passing))
}

fn reach_error(data: &InternalGearData, base_difference: f64) -> GeometryError {
    GeometryError::error(
        "E0625",
        "shaper",
        sentence![
            "to cut to the root diameter of ", length 2.0 * data.root_radius, " the shaper of outer diameter ",
            length 2.0 * data.shaper.outer_radius(), " would stand ", length data.root_radius - data.shaper.outer_radius(),
            " off the ring's axis; below ", length base_difference, " it generates no involutes"
        ],
        sentence!["reduce the shaper's `addendum` or number of teeth, or enlarge `root_diameter`"],
    )
}

/// What can be told wrong before anything is computed.
fn check_data(data: &InternalGearData) -> Vec<GeometryError> {
    let mut errors = Vec::new();
    let shaper = &data.shaper;
    if !(4..=100_000).contains(&data.teeth) {
        errors.push(GeometryError::error(
            "E0604",
            "teeth",
            sentence!["a gear of ", number f64::from(data.teeth), " teeth"],
            sentence!["give between 4 and 100000 teeth"],
        ));
        return errors;
    }
    if shaper.teeth >= data.teeth {
        errors.push(GeometryError::error(
            "E0624",
            "shaper",
            sentence![
                "a shaper of ", number f64::from(shaper.teeth), " teeth does not fit into a ring of ", number f64::from(data.teeth)
            ],
            sentence!["use a shaper with fewer teeth than the gear it cuts, about half as many"],
        ));
    }
    if !(data.tooth_thickness > 0.0 && data.tooth_thickness < shaper.pitch()) {
        errors.push(GeometryError::error(
            "E0605",
            "tooth_thickness",
            sentence![
                "a tooth ", length data.tooth_thickness, " thick at the pitch circle leaves no tooth or no space: the pitch is ",
                length shaper.pitch()
            ],
            sentence!["give a thickness near half the pitch, ", length 0.5 * shaper.pitch()],
        ));
    }
    let pitch_radius = 0.5 * f64::from(data.teeth) * shaper.module;
    let base_radius = pitch_radius * math::cos(shaper.pressure_angle);
    if data.minor_radius.is_nan() || data.minor_radius <= base_radius {
        errors.push(GeometryError::error(
            "E0618",
            "minor_diameter",
            sentence![
                "the minor diameter of ", length 2.0 * data.minor_radius,
                " is not above the base diameter of ", length 2.0 * base_radius, ", inside of which there is no involute"
            ],
            sentence!["enlarge `minor_diameter`; usual is the pitch diameter less 1.5 to 2 modules"],
        ));
    }
    if !(data.root_radius.is_finite()
        && data.root_radius > data.minor_radius
        && data.root_radius > pitch_radius)
    {
        errors.push(GeometryError::error(
            "E0619",
            "root_diameter",
            sentence![
                "the root diameter of ", length 2.0 * data.root_radius,
                " is not above the minor diameter of ", length 2.0 * data.minor_radius,
                " and the pitch diameter of ", length 2.0 * pitch_radius
            ],
            sentence![
                "the spaces of an internal gear end outside; usual is the pitch diameter plus 2.5 modules"
            ],
        ));
    }
    if let Some(edge) = data.tip_edge_radius
        && !(edge > 0.0 && edge.is_finite())
    {
        errors.push(GeometryError {
            severity: Severity::Error,
            ..GeometryError::error(
                "E0617",
                "tip_edge_radius",
                sentence!["the tip edge's rounding is ", length edge],
                sentence![
                    "give a positive `tip_edge_radius`, or leave it out for ",
                    length crate::external::DEFAULT_TIP_EDGE * shaper.module
                ],
            )
        });
    }
    errors
}

/// A ring around the teeth: checks its diameters against the gear's root.
///
/// # Errors
/// E0620, E0621.
pub fn check_outer_rim(root_radius: f64, rim_radius: f64, outer_radius: f64) -> Result<(), GeometryError> {
    if rim_radius.is_nan() || rim_radius <= root_radius {
        return Err(GeometryError::error(
            "E0620",
            "diameter",
            sentence![
                "the rim begins at diameter ", length 2.0 * rim_radius,
                ", which is not above the root diameter of ", length 2.0 * root_radius
            ],
            sentence![
                "an internal gear's rim lies around its teeth: take `outer_rim`, and enlarge its `diameter`"
            ],
        ));
    }
    if !(outer_radius.is_finite() && outer_radius > rim_radius) {
        return Err(GeometryError::error(
            "E0621",
            "outer_diameter",
            sentence![
                "the rim's outer diameter of ", length 2.0 * outer_radius,
                " is not larger than the diameter of ", length 2.0 * rim_radius, " at which it begins"
            ],
            sentence!["give an outer diameter larger than the rim's `diameter`"],
        ));
    }
    Ok(())
}
