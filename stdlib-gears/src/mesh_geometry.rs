//! Geometry of two gears in mesh: operating pressure angle, path of contact, backlash, and the
//! checks that reject impossible pairs. Theory: `docs/theory/gear-geometry.md`.

mod distance;

use self::distance::expected_distance;
use crate::error::{GeometryError, Sentence, sentence};
use crate::external::ExternalGear;
use crate::gear::ToothForm;
use crate::helix::Helix;
use crate::internal::{InternalGear, tip_margin};
use crate::involute::{involute, radius_at_roll, roll_of_involute};
use calyx_abi::math;
use std::f64::consts::PI;

/// Negative backlash and tip clearance up to this fraction of the pitch or module are attributed to
/// rounded input data. For example, half a pitch given as 0.15708 makes a tooth too thick by 3e-6
/// of the pitch.
const ROUNDING_OF_DATA: f64 = 1e-4;
/// Normal backlash above which a warning is issued, in modules. Only coarse gears and gears that
/// are loose on purpose have more.
const WIDE_BACKLASH: f64 = 0.25;

/// Characteristic points of the path of contact as roll angles of the first member, ordered from
/// its root to its tip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathOfContact {
    /// SAP, start of active profile (point A): the tip form circle of the second member enters
    /// contact, or the involute of an undercut first member begins.
    pub start_of_active_profile: f64,
    /// LPSTC, lowest point of single-tooth contact (point B): the preceding pair leaves contact.
    pub lowest_single_tooth: f64,
    /// Pitch point C, where the line of action intersects the line of centres.
    pub pitch_point: f64,
    /// HPSTC, highest point of single-tooth contact (point D): the following pair enters contact.
    pub highest_single_tooth: f64,
    /// EAP, end of active profile (point E): the tip form circle of the first member leaves
    /// contact.
    pub end_of_active_profile: f64,
}

impl PathOfContact {
    /// Returns the points in order: SAP, LPSTC, pitch point, HPSTC, EAP. With a contact ratio above
    /// two, the lowest point of single-tooth contact lies below the start of the profile.
    pub fn points(&self) -> [f64; 5] {
        [
            self.start_of_active_profile,
            self.lowest_single_tooth,
            self.pitch_point,
            self.highest_single_tooth,
            self.end_of_active_profile,
        ]
    }
}

/// Helical teeth over the common face width of two gears.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct HelicalTeeth {
    /// Helix of the first gear.
    pub first: Helix,
    /// Common face width, m.
    pub width: f64,
}

/// Geometry of a pair at a centre distance. SI units; angles in rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshGeometry {
    /// Centre distance, between the axes.
    pub center_distance: f64,
    /// Operating pressure angle, between the line of action and the normal to the line of centres.
    pub operating_pressure_angle: f64,
    /// Base pitch of both members.
    pub base_pitch: f64,
    /// Length of the path of contact between the active tip circles `d_Na`.
    pub line_of_action_length: f64,
    /// Transverse contact ratio: length of the path of contact in base pitches.
    pub contact_ratio: f64,
    /// Overlap ratio: common face width in axial pitches ([`MeshGeometry::across`]); 0 for spur
    /// teeth.
    pub overlap_ratio: f64,
    /// Rotation of the first member's transverse section per length along its axis, rad/m: positive
    /// for a right-hand helix, 0 for spur teeth.
    pub twist: f64,
    /// Base radii of the first and the second member.
    pub base_radius: [f64; 2],
    /// Path of contact in roll angles of the first member.
    pub first_roll: PathOfContact,
    /// Distance of the tangent points of the line of action on the base circles. For external pairs
    /// it is the sum of both members' tangents to a point of contact, for internal pairs their
    /// difference.
    pub tangent_distance: f64,
    /// True if the second member is an internal gear.
    pub internal: bool,
    /// Circumferential backlash along the operating pitch circles.
    pub backlash: f64,
    /// Normal backlash j_bn (ISO 21771), m: the shortest distance between the non-working flanks,
    /// `j_wt cos(alpha_wt) cos(beta_b)`.
    pub normal_backlash: f64,
    /// Centre distance with zero backlash; `None` if the pair always has backlash.
    pub zero_backlash_center_distance: Option<f64>,
}

impl MeshGeometry {
    /// Computes the geometry of an external pair. It only checks that the pair can touch; see
    /// [`MeshGeometry::check_external`] for the other checks.
    pub fn external(
        first: &ExternalGear,
        second: &ExternalGear,
        center_distance: f64,
    ) -> Result<Self, GeometryError> {
        check_same_involutes(
            [first.rack.module, second.rack.module],
            [first.rack.pressure_angle, second.rack.pressure_angle],
        )?;
        let base_radius = [first.base_radius, second.base_radius];
        let (base_sum, outer_sum) =
            (base_radius[0] + base_radius[1], first.outer_radius + second.outer_radius);
        let zero_involute = (f64::from(first.teeth) * first.half_base_angle
            + f64::from(second.teeth) * second.half_base_angle
            - PI)
            / f64::from(first.teeth + second.teeth);
        let zero_backlash =
            (zero_involute > 0.0).then(|| radius_at_roll(base_sum, roll_of_involute(zero_involute)));
        let standard = first.pitch_radius + second.pitch_radius;
        if center_distance.is_nan() || center_distance <= base_sum {
            return Err(GeometryError::error(
                "E0631",
                "second",
                sentence![
                    "the axes are ", length center_distance, " apart, less than the base circles need (",
                    length base_sum, "): no line of action exists"
                ],
                expected_distance("farther apart", center_distance, standard, zero_backlash),
            ));
        }
        if center_distance >= outer_sum {
            return Err(GeometryError::error(
                "E0632",
                "second",
                sentence![
                    "the axes are ", length center_distance, " apart, but the outer circles reach only ",
                    length outer_sum, ": the teeth cannot touch"
                ],
                expected_distance("closer together", center_distance, standard, zero_backlash),
            ));
        }
        let tangent_distance = ((center_distance - base_sum) * (center_distance + base_sum)).sqrt();
        let angle = math::atan2(tangent_distance, base_sum);
        // Each tooth is in contact from the point that its mate's tip form circle reaches up to its
        // own tip form circle. An undercut tooth is not in contact below its form circle, where the
        // rack has removed the flank.
        let undercut_start =
            |gear: &ExternalGear| if gear.undercut { gear.form_roll } else { f64::NEG_INFINITY };
        let start = base_radius[0] * undercut_start(first);
        let end = tangent_distance - base_radius[1] * undercut_start(second);
        let normal_backlash = 2.0 * base_sum * (involute(angle) - zero_involute);
        Ok(Self {
            center_distance,
            tangent_distance,
            internal: false,
            normal_backlash,
            zero_backlash_center_distance: zero_backlash,
            ..Self::from_path(
                base_radius,
                first.base_pitch,
                angle,
                [
                    start.max(tangent_distance - base_radius[1] * second.tip_form_roll),
                    end.min(base_radius[0] * first.tip_form_roll),
                ],
                normal_backlash,
            )
        })
    }

    /// Computes the geometry of an external pinion in an internal gear. It only checks that the
    /// pair can touch; see [`MeshGeometry::check_internal`] for the other checks.
    ///
    /// # Errors
    /// E0630 to E0632.
    pub fn internal(
        first: &ExternalGear,
        second: &InternalGear,
        center_distance: f64,
    ) -> Result<Self, GeometryError> {
        check_same_involutes(
            [first.rack.module, second.shaper.module],
            [first.rack.pressure_angle, second.shaper.pressure_angle],
        )?;
        let base_radius = [first.base_radius, second.base_radius];
        let difference = base_radius[1] - base_radius[0];
        let standard = second.pitch_radius - first.pitch_radius;
        // The pinion's tooth in the gear's tooth space, on the operating pitch circles.
        let teeth = [f64::from(first.teeth), f64::from(second.teeth)];
        let zero_involute = (teeth[1] * second.half_base_angle_of_space - teeth[0] * first.half_base_angle)
            / (teeth[1] - teeth[0]);
        let zero_backlash = (difference > 0.0 && zero_involute > 0.0)
            .then(|| radius_at_roll(difference, roll_of_involute(zero_involute)));
        if center_distance.is_nan() || difference <= 0.0 || center_distance <= difference {
            return Err(GeometryError::error(
                "E0631",
                "second",
                sentence![
                    "the axes are ", length center_distance, " apart, less than the base circles need (",
                    length difference, "): no line of action exists"
                ],
                expected_distance("farther apart", center_distance, standard, zero_backlash),
            ));
        }
        let tangent_distance = ((center_distance - difference) * (center_distance + difference)).sqrt();
        let undercut_start =
            if first.undercut { base_radius[0] * first.form_roll } else { f64::NEG_INFINITY };
        let start = (base_radius[1] * second.tip_form_roll - tangent_distance).max(undercut_start);
        let end = base_radius[0] * first.tip_form_roll;
        if end <= start {
            return Err(GeometryError::error(
                "E0632",
                "second",
                sentence![
                    "the axes are ", length center_distance,
                    " apart, and the tip circles leave nothing of the line of action: the teeth cannot touch"
                ],
                expected_distance("at another distance", center_distance, standard, zero_backlash),
            ));
        }
        let angle = math::atan2(tangent_distance, difference);
        let normal_backlash = 2.0 * difference * (zero_involute - involute(angle));
        Ok(Self {
            center_distance,
            tangent_distance,
            internal: true,
            zero_backlash_center_distance: zero_backlash,
            ..Self::from_path(base_radius, first.base_pitch, angle, [start, end], normal_backlash)
        })
    }

    /// Converts tangent lengths of the first member (m) to the path of contact.
    fn from_path(
        base_radius: [f64; 2],
        base_pitch: f64,
        operating_pressure_angle: f64,
        [start, end]: [f64; 2],
        normal_backlash: f64,
    ) -> Self {
        let roll = |tangent: f64| tangent / base_radius[0];
        Self {
            center_distance: 0.0,
            operating_pressure_angle,
            base_pitch,
            line_of_action_length: end - start,
            contact_ratio: (end - start) / base_pitch,
            overlap_ratio: 0.0,
            twist: 0.0,
            base_radius,
            first_roll: PathOfContact {
                start_of_active_profile: roll(start),
                lowest_single_tooth: roll(end - base_pitch),
                pitch_point: math::tan(operating_pressure_angle),
                highest_single_tooth: roll(start + base_pitch),
                end_of_active_profile: roll(end),
            },
            tangent_distance: 0.0,
            internal: false,
            backlash: normal_backlash / math::cos(operating_pressure_angle),
            normal_backlash,
            zero_backlash_center_distance: None,
        }
    }

    /// Returns the geometry of a pair of spur gears, its transverse section, with helical teeth.
    #[must_use]
    pub fn across(self, first: &ExternalGear, wound: &HelicalTeeth) -> Self {
        let twist = wound.first.twist_per_length(first.pitch_radius);
        let twisted = twist.abs() * wound.width;
        let base_helix = wound.first.base_angle(first.rack.pressure_angle);
        Self {
            overlap_ratio: twisted / first.pitch_angle(),
            twist,
            normal_backlash: self.normal_backlash * math::cos(base_helix),
            ..self
        }
    }

    /// Transverse contact ratio plus overlap ratio.
    pub fn total_contact_ratio(&self) -> f64 {
        self.contact_ratio + self.overlap_ratio
    }

    /// Roll angle of the second member at the contact point with this roll angle of the first.
    pub fn second_roll(&self, first_roll: f64) -> f64 {
        let first_tangent = self.base_radius[0] * first_roll;
        let second_tangent = if self.internal {
            self.tangent_distance + first_tangent
        } else {
            self.tangent_distance - first_tangent
        };
        second_tangent / self.base_radius[1]
    }

    /// Radius on the first member at one of its roll angles, m.
    pub fn first_radius(&self, first_roll: f64) -> f64 {
        radius_at_roll(self.base_radius[0], first_roll)
    }

    /// Tip clearance: smallest distance of the root circle of one member to the tip circle of its
    /// mate, m.
    pub fn clearance(&self, gear: impl Into<ToothForm>, mate: impl Into<ToothForm>) -> f64 {
        let (gear, mate): (ToothForm, ToothForm) = (gear.into(), mate.into());
        if gear.internal {
            gear.root_radius - self.center_distance - mate.tip_radius
        } else if mate.internal {
            mate.tip_radius - self.center_distance - gear.root_radius
        } else {
            self.center_distance - gear.root_radius - mate.tip_radius
        }
    }

    /// Checks an external pair and returns its geometry with warnings, or all of its errors.
    ///
    /// # Errors
    /// E0630 to E0634, E0636, E0930.
    pub fn check_external(
        first: &ExternalGear,
        second: &ExternalGear,
        center_distance: f64,
        wound: &HelicalTeeth,
    ) -> Result<(Self, Vec<GeometryError>), Vec<GeometryError>> {
        let mesh = Self::external(first, second, center_distance).map_err(|error| vec![error])?;
        let mesh = mesh.across(first, wound);
        let undercut = [first.undercut, second.undercut];
        let gears = [first.into(), second.into()];
        let (errors, mut warnings) = mesh.judge(gears, undercut);
        let errors = mesh.blame_overlap(errors, |distance| {
            let fitting = Self::external(first, second, distance).ok()?.across(first, wound);
            Some(fitting.judge(gears, undercut).0)
        });
        let reach = |gear: &ExternalGear, mate: &ExternalGear| {
            (mesh.tangent_distance - mate.base_radius * mate.tip_form_roll) / gear.base_radius
        };
        warnings.extend(shortened_by_protuberance("first", first, reach(first, second)));
        warnings.extend(shortened_by_protuberance("second", second, reach(second, first)));
        if errors.is_empty() { Ok((mesh, warnings)) } else { Err(errors) }
    }

    /// Checks a pair of an external and an internal gear and returns its geometry with warnings, or
    /// all of its errors.
    ///
    /// # Errors
    /// E0630 to E0634, E0636, E0638, E0930.
    pub fn check_internal(
        first: &ExternalGear,
        second: &InternalGear,
        center_distance: f64,
        wound: &HelicalTeeth,
    ) -> Result<(Self, Vec<GeometryError>), Vec<GeometryError>> {
        let mesh = Self::internal(first, second, center_distance).map_err(|error| vec![error])?;
        let mesh = mesh.across(first, wound);
        let (gears, undercut) = ([first.into(), second.into()], [first.undercut, false]);
        let (errors, mut warnings) = mesh.judge(gears, undercut);
        let mut errors = mesh.blame_overlap(errors, |distance| {
            let fitting = Self::internal(first, second, distance).ok()?.across(first, wound);
            Some(fitting.judge(gears, undercut).0)
        });
        let reach = (second.base_radius * second.tip_form_roll - mesh.tangent_distance) / first.base_radius;
        warnings.extend(shortened_by_protuberance("first", first, reach));
        let margin = tip_margin(
            [first.teeth, second.teeth],
            [first.tip_roll, second.tip_roll],
            [first.outer_radius, second.minor_radius],
            center_distance,
            mesh.operating_pressure_angle,
        );
        if let Some(margin) = margin.filter(|&margin| margin < 0.0) {
            errors.push(GeometryError::error(
                "E0638",
                "second",
                sentence![
                    "the tips of the gear and of the ring run into each other by ", length -margin * second.minor_radius,
                    " outside of the mesh: with ", number f64::from(first.teeth), " and ", number f64::from(second.teeth),
                    " teeth they are too nearly of one size"
                ],
                sentence!["use fewer teeth in the ring, reduce `outer_diameter` of the gear, or enlarge `minor_diameter` of the ring"],
            ));
        }
        if errors.is_empty() { Ok((mesh, warnings)) } else { Err(errors) }
    }

    /// Finds the errors and warnings of a pair. An undercut gear ends the path of contact at its
    /// form circle, so the tips of its mate do not touch below it.
    fn judge(&self, gears: [ToothForm; 2], undercut: [bool; 2]) -> (Vec<GeometryError>, Vec<GeometryError>) {
        let (mut errors, mut warnings) = (Vec::new(), Vec::new());
        if self.total_contact_ratio() < 1.0 {
            errors.push(GeometryError::error(
                "E0633",
                "second",
                sentence![
                    "the contact ratio is ", number self.total_contact_ratio(),
                    ", below 1: a pair of teeth leaves contact before the next one has come"
                ],
                if self.internal {
                    sentence![
                        "enlarge the outer diameter of the gear, or reduce the minor diameter of the ring"
                    ]
                } else {
                    let closer = match self
                        .zero_backlash_center_distance
                        .filter(|zero| *zero < self.center_distance)
                    {
                        Some(zero) => sentence!["; without backlash the distance is ", length zero],
                        None => sentence![],
                    };
                    let help = sentence![
                        "place the axes closer together than ", length self.center_distance,
                        ", or enlarge the outer diameters"
                    ];
                    Sentence(help.0.into_iter().chain(closer.0).collect())
                },
            ));
        }
        let second_start = gears[1].sense() * self.second_roll(self.first_roll.end_of_active_profile);
        let starts = [self.first_roll.start_of_active_profile, second_start];
        let members = ["first", "second"];
        for member in [0, 1] {
            if starts[member] < gears[member].form_roll && !undercut[member] {
                let limit = self.tip_limit(member, gears[member].form_roll.abs());
                let mate = gears[1 - member];
                errors.push(fillet_interference(
                    members[member],
                    &gears[member],
                    starts[member],
                    (&mate, limit),
                ));
            }
        }
        if self.normal_backlash > WIDE_BACKLASH * gears[0].tool_module {
            warnings.push(self.wide_backlash(gears[0].tool_module));
        }
        if self.normal_backlash < -ROUNDING_OF_DATA * self.base_pitch {
            warnings.push(GeometryError::warning(
                "E0635",
                "second",
                sentence![
                    "the backlash is negative, ", length self.backlash, ": the teeth are thicker than the spaces at a centre distance of ",
                    length self.center_distance, ". Contact is searched on the driving flanks only"
                ],
                match (self.zero_backlash_center_distance, self.internal) {
                    (Some(distance), false) => sentence![
                        "place the axes at least ", at_least length distance, " apart, or reduce `tooth_thickness`"
                    ],
                    (Some(distance), true) => sentence![
                        "place the axes at most ", at_most length distance, " apart, or reduce `tooth_thickness`"
                    ],
                    (None, _) => sentence!["reduce `tooth_thickness`"],
                },
            ));
        }
        for member in [0, 1] {
            let (gear, mate) = (gears[member], gears[1 - member]);
            let clearance = self.clearance(gear, mate);
            if clearance < -ROUNDING_OF_DATA * gear.module {
                errors.push(GeometryError::error(
                    "E0636",
                    members[member],
                    sentence![
                        "the mate's tips reach ", length -clearance, " into the root circle of this gear (diameter ",
                        length 2.0 * gear.root_radius, ")"
                    ],
                    sentence![
                        "deepen this gear's spaces by its `root_diameter`, shorten the mate's teeth, or move the axes"
                    ],
                ));
            } else if clearance < 0.05 * gear.tool_module {
                warnings.push(GeometryError::warning(
                    "E0637",
                    members[member],
                    sentence![
                        "the mate's tips clear the root circle of this gear by only ", length clearance.max(0.0)
                    ],
                    sentence!["a clearance of ", length 0.25 * gear.tool_module, " (0.25 modules) is usual"],
                ));
            }
        }
        (errors, warnings)
    }

    /// Tip radius of the mate of a member at which contact on the member starts at a roll angle, m.
    fn tip_limit(&self, member: usize, roll: f64) -> Option<f64> {
        let tangent = match (member, self.internal) {
            (0, _) => return Some(radius_at_roll(self.base_radius[1], self.second_roll(roll))),
            (_, true) => self.base_radius[1] * roll - self.tangent_distance,
            (_, false) => self.tangent_distance - self.base_radius[1] * roll,
        };
        (tangent > 0.0).then(|| self.base_radius[0].hypot(tangent))
    }

    /// Warning about an unusually large backlash of gears of this module (m).
    fn wide_backlash(&self, module: f64) -> GeometryError {
        let modules = (100.0 * self.normal_backlash / module).round() / 100.0;
        let mut message = sentence![
            "the normal backlash is ", length self.normal_backlash, " (", number modules,
            " modules) at a centre distance of ", length self.center_distance
        ];
        let usual = "; 0.02 to 0.1 modules are usual";
        let help = match (self.zero_backlash_center_distance, self.internal) {
            (Some(distance), internal) => {
                message.0.extend(sentence!["; without backlash it is ", length distance].0);
                let nearer = if internal { "farther apart" } else { "closer together" };
                sentence![
                    "check the distance of the frames and `tooth_thickness`: place the axes ", text nearer,
                    ", or make the teeth thicker", text usual
                ]
            }
            (None, _) => sentence!["check `tooth_thickness`, and make the teeth thicker", text usual],
        };
        GeometryError::warning("E0694", "second", message, help)
    }
}

fn check_same_involutes(module: [f64; 2], pressure_angle: [f64; 2]) -> Result<(), GeometryError> {
    // Conjugate action requires only equal base pitches.
    let base_pitch = [0, 1].map(|member| PI * module[member] * math::cos(pressure_angle[member]));
    if (base_pitch[0] - base_pitch[1]).abs() <= 1e-9 * base_pitch[0] {
        return Ok(());
    }
    Err(GeometryError::error(
        "E0630",
        "second",
        sentence![
            "the gears have different base pitches, ", length base_pitch[0], " and ", length base_pitch[1],
            ": their teeth cannot mesh smoothly"
        ],
        sentence![
            "give both gears the same module, in the same section, and the same pressure angle: their transverse modules are ",
            length module[0], " and ", length module[1], ", the transverse pressure angles ", angle pressure_angle[0],
            " and ", angle pressure_angle[1]
        ],
    ))
}

/// Warning about a tool with protuberance that removes a part of the flank of `gear` that its mate
/// reaches. `reach` is the roll angle of the innermost point that the tips of the mate reach.
fn shortened_by_protuberance(member: &'static str, gear: &ExternalGear, reach: f64) -> Option<GeometryError> {
    if gear.rack.residual_undercut == 0.0 || reach >= gear.form_roll {
        return None;
    }
    Some(GeometryError::warning(
        "W0849",
        member,
        sentence![
            "the protuberance of this gear's tool shortens the path of contact: the mate's tips reach down to the diameter ",
            length 2.0 * gear.radius_at_roll(reach.max(0.0)), ", but the flank begins at ", length 2.0 * gear.form_radius
        ],
        sentence![
            "reduce `protuberance` of the rack, enlarge its `dedendum` or `protuberance_angle`, or shorten the mate's teeth"
        ],
    ))
}

/// Error for tips that reach the fillets of `gear` at a roll angle. `limit` is the tip radius of
/// the mate that would end there, m.
fn fillet_interference(
    argument: &'static str,
    gear: &ToothForm,
    reach_roll: f64,
    (mate, limit): (&ToothForm, Option<f64>),
) -> GeometryError {
    let below_base = !gear.internal && reach_roll <= 0.0;
    let reach = if below_base { gear.base_radius } else { gear.radius_at_roll(reach_roll) };
    GeometryError::error(
        "E0634",
        argument,
        sentence![
            "the mate's tips reach to radius ", length reach, " on this gear, but its involute begins only at ",
            length gear.form_radius, ": the tips would run into the fillets"
        ],
        match (limit.filter(|limit| *limit > mate.base_radius), mate.internal) {
            (Some(limit), true) => sentence![
                "enlarge `minor_diameter` of the internal gear to at least ", at_least length 2.0 * limit,
                ", reduce `tip_radius` of this gear's tool, or move the axes"
            ],
            (Some(limit), false) => sentence![
                "reduce the tip diameter of the mate to at most ", at_most length 2.0 * limit,
                ", reduce `tip_radius` of this gear's tool, or move the axes"
            ],
            (None, _) => {
                sentence![
                    "shorten the mate's teeth, reduce `tip_radius` of this gear's tool, or move the axes"
                ]
            }
        },
    )
}
