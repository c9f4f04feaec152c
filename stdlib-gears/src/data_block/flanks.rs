//! Profile and helix traces of modified flanks, as an inspection machine draws them (K-charts): the
//! design, the flank of the analysis, and its deviations from the design by ISO 1328-1.
//!
//! Deviations are normal to the flank in the transverse section, and positive for additional
//! material. Traces of profiles extend over the roll length, those of helices over the distance
//! from mid-face.

use crate::flank_tolerances::{Edition, FlankTolerances};
use crate::gear_surface::GearSurface;
use crate::mesh_geometry::MeshGeometry;
use crate::modification::{FaceEnds, Modification, ToothFlank};
use crate::prototype::GearPrototype;
use calyx_runtime::scene::StructureOptions;
use std::sync::Arc;

/// Number of intervals of a trace.
const INTERVALS: usize = 120;
/// Difference of deviations that counts as zero, m.
const SAME: f64 = 1e-12;
/// Largest part of the face width at each end that is not evaluated (ISO 1328-1:2013, 4.4.9).
const FACE_END: f64 = 0.05;

/// Traces of the flanks of a gear.
#[derive(Clone, Debug, PartialEq)]
pub struct FlankCharts {
    /// Characteristic points of the profile, from root to tip.
    pub points: Vec<PointOfProfile>,
    /// Diameter of the helix traces, m.
    pub measuring_diameter: f64,
    /// Evaluation range of the profile in roll lengths, m, ascending.
    pub profile_range: [f64; 2],
    /// Evaluation range of the helix in distances from mid-face, m.
    pub helix_range: [f64; 2],
    /// Tolerances of the stated accuracy grade.
    pub tolerances: Option<FlankTolerances>,
    /// Left and right flanks.
    pub flanks: [FlankTraces; 2],
}

/// Characteristic point of a profile.
#[derive(Clone, Debug, PartialEq)]
pub struct PointOfProfile {
    /// Symbol of the diameter (ISO 21771).
    pub symbol: &'static str,
    /// Term.
    pub name: &'static str,
    /// Diameter, m.
    pub diameter: f64,
    /// Roll length: length of the tangent from the flank to the base circle, m.
    pub roll_length: f64,
    /// Roll angle, rad.
    pub roll_angle: f64,
    /// Name of the mate for the ends of the active profile of a gear with several meshes.
    pub mate: Option<String>,
}

/// Mesh of a gear.
pub(super) struct MeshOfGear<'m> {
    pub geometry: MeshGeometry,
    /// Index of the gear in the mesh.
    pub member: usize,
    /// Name of the body that carries the mate.
    pub mate: &'m str,
}

/// Traces of the left or of the right flanks.
#[derive(Clone, Debug, PartialEq)]
pub struct FlankTraces {
    /// Amounts of the modifications.
    pub amounts: Vec<Amount>,
    /// Profile traces: at mid-face, or at both ends of the evaluation range and at mid-face if the
    /// profile varies along the face.
    pub profiles: Vec<Trace>,
    /// Helix trace at the measuring diameter.
    pub helix: Trace,
}

/// Amount of a modification.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Amount {
    /// Symbol (ISO 21771, ISO 1328-1).
    pub symbol: &'static str,
    /// Term.
    pub name: &'static str,
    /// Amount, m. Reliefs and crowns remove material; slopes have the signs of the library.
    pub value: f64,
    /// True for a deviation, see [`Modification::Unintended`].
    pub unintended: bool,
}

/// Deviations of a flank along a line.
#[derive(Clone, Debug, PartialEq)]
pub struct Trace {
    /// Axial position of a profile, or diameter of a helix, m.
    pub at: f64,
    /// Ascending roll lengths, or distances from mid-face, m.
    pub positions: Vec<f64>,
    /// Design: intended modifications, m.
    pub design: Vec<f64>,
    /// Flank of the analysis: all modifications, m.
    pub flank: Vec<f64>,
    /// Deviations of the flank from the design; zero without unintended modifications.
    pub deviations: Deviations,
}

/// Deviations of a trace from the design over the evaluation range (ISO 1328-1), m.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Deviations {
    /// Total deviation: `F_alpha`, `F_beta`.
    pub total: f64,
    /// Form deviation.
    pub form: f64,
    /// Slope deviation, positive for additional material towards the tip or towards +e3.
    pub slope: f64,
    /// Middle between the largest and the smallest deviation: the centre of the tolerance band.
    pub middle: f64,
}

impl FlankCharts {
    /// Returns the traces of a gear with modified flanks; `None` without modifications. `meshes`
    /// are the meshes of the gear.
    pub(super) fn of(gear: &GearPrototype, meshes: &[MeshOfGear<'_>]) -> Option<FlankCharts> {
        if gear.modifications.is_empty() {
            return None;
        }
        let intended: Vec<Modification> =
            gear.modifications.iter().filter(|one| !one.is_unintended()).cloned().collect();
        let options = StructureOptions::default();
        let surfaces = gear.surfaces(&options).ok()?;
        let design = gear.surfaces_with(&options, &intended).ok()?;
        let form = gear.form();
        let ranges = Ranges::of(gear, meshes);
        let traces = |flank: ToothFlank| {
            let side = flank.side(form.internal).surface() as usize;
            let lines =
                Lines { gear, ranges: &ranges, surface: surfaces.get(side)?, design: design.get(side)? };
            let amounts = amounts(&gear.modifications, flank, form.internal);
            Some(FlankTraces { amounts, profiles: lines.profiles(), helix: lines.helix() })
        };
        Some(FlankCharts {
            flanks: [traces(ToothFlank::Left)?, traces(ToothFlank::Right)?],
            tolerances: gear.stated.tolerances,
            measuring_diameter: ranges.measuring_diameter,
            profile_range: ranges.profile,
            helix_range: ranges.helix,
            points: ranges.points,
        })
    }
}

/// Positions of traces and evaluation ranges.
struct Ranges {
    points: Vec<PointOfProfile>,
    measuring_diameter: f64,
    /// Ends of the involute in roll lengths, ascending.
    involute: [f64; 2],
    profile: [f64; 2],
    helix: [f64; 2],
    /// Active length of the profile.
    active: f64,
}

impl Ranges {
    fn of(gear: &GearPrototype, meshes: &[MeshOfGear<'_>]) -> Ranges {
        let form = gear.form();
        let base = form.base_radius;
        let point = |symbol, name, roll: f64| PointOfProfile {
            symbol,
            name,
            diameter: 2.0 * base * (1.0 + roll * roll).sqrt(),
            roll_length: base * roll.abs(),
            roll_angle: roll.abs(),
            mate: None,
        };
        let root = point("d_Ff", "root form circle", form.form_roll);
        let tip_form = point("d_Fa", "tip form circle", form.tip_form_roll);
        let tip = point("d_a", "tip circle", form.tip_roll);
        let from_root = |point: &PointOfProfile| (point.roll_length - root.roll_length).abs();
        let mut active_ends = Vec::new();
        for MeshOfGear { geometry, member, mate } in meshes {
            let path = geometry.first_roll;
            let [near_root, near_tip] = match member {
                0 => [path.start_of_active_profile, path.end_of_active_profile],
                _ => [path.end_of_active_profile, path.start_of_active_profile]
                    .map(|roll| geometry.second_roll(roll)),
            };
            // With a single mesh, the mate needs no name.
            let mate = (meshes.len() > 1).then(|| (*mate).to_owned());
            let start = point("d_Nf", "start of active profile (SAP)", near_root);
            let end = point("d_Na", "end of active profile (EAP)", near_tip);
            active_ends.extend([start, end].map(|point| PointOfProfile { mate: mate.clone(), ..point }));
        }
        // The active profiles of all meshes are evaluated.
        let start = active_ends.iter().min_by(|one, other| from_root(one).total_cmp(&from_root(other)));
        let start = start.unwrap_or(&root).roll_length;
        let mut points = vec![root.clone()];
        points.append(&mut active_ends);
        points.extend([tip_form.clone(), tip.clone()]);
        points.sort_by(|one, other| from_root(one).total_cmp(&from_root(other)));
        let edition = gear.stated.tolerances.map_or(Edition::Of2013, |tolerances| tolerances.edition);
        let active = tip_form.roll_length - start;
        let stop = start + edition.profile_share() * active;
        let margin = (FACE_END * gear.face_width).min(crate::drawing_externs::normal_module(gear));
        let half = 0.5 * gear.face_width;
        // The reference circle, unless it is outside of the involute.
        let ends = [root.diameter, tip_form.diameter];
        let measuring_diameter = (2.0 * form.pitch_radius).clamp(ends[0].min(ends[1]), ends[0].max(ends[1]));
        Ranges {
            points,
            measuring_diameter,
            involute: ascending([root.roll_length, tip.roll_length]),
            profile: ascending([start, stop]),
            helix: [margin - half, half - margin],
            active,
        }
    }
}

fn ascending([one, other]: [f64; 2]) -> [f64; 2] {
    [one.min(other), one.max(other)]
}

/// Equidistant positions with the ends of the evaluation range.
fn positions([from, to]: [f64; 2], evaluated: [f64; 2]) -> Vec<f64> {
    let mut all: Vec<f64> =
        (0..=INTERVALS).map(|k| from + (to - from) * k as f64 / INTERVALS as f64).collect();
    all.extend(evaluated.into_iter().filter(|end| (from..=to).contains(end)));
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}

/// Lines on the flanks of one side.
struct Lines<'g> {
    gear: &'g GearPrototype,
    ranges: &'g Ranges,
    surface: &'g Arc<GearSurface>,
    design: &'g Arc<GearSurface>,
}

impl Lines<'_> {
    fn profiles(&self) -> Vec<Trace> {
        let [start, end] = self.ranges.helix;
        let [first, middle, last] = [start, 0.0, end].map(|axial| self.profile(axial));
        match alike(&first, &middle) && alike(&middle, &last) {
            true => vec![middle],
            false => vec![first, middle, last],
        }
    }

    fn profile(&self, axial: f64) -> Trace {
        let form = self.gear.form();
        let positions = positions(self.ranges.involute, self.ranges.profile);
        let of = |surface: &GearSurface| {
            let amount = |length: &f64| -surface.amount_at(form.sense() * length / form.base_radius, axial);
            positions.iter().map(amount).collect::<Vec<f64>>()
        };
        let (design, flank) = (of(self.design), of(self.surface));
        // From root to tip, also where roll lengths decrease towards the tip.
        let slope_length = self.ranges.active;
        let deviations = deviations(&positions, [&design, &flank], self.ranges.profile, slope_length);
        Trace { at: axial, positions, design, flank, deviations }
    }

    fn helix(&self) -> Trace {
        let form = self.gear.form();
        let roll = form.sense() * form.roll_at_radius(0.5 * self.ranges.measuring_diameter).abs();
        let half = 0.5 * self.gear.face_width;
        let positions = positions([-half, half], self.ranges.helix);
        let of = |surface: &GearSurface| {
            positions.iter().map(|axial| -surface.amount_at(roll, *axial)).collect::<Vec<f64>>()
        };
        let (design, flank) = (of(self.design), of(self.surface));
        let deviations = deviations(&positions, [&design, &flank], self.ranges.helix, self.gear.face_width);
        Trace { at: self.ranges.measuring_diameter, positions, design, flank, deviations }
    }
}

/// Returns true if two profiles differ by a constant.
fn alike(one: &Trace, other: &Trace) -> bool {
    let same = |one: &[f64], other: &[f64]| {
        let apart = || one.iter().zip(other).map(|(one, other)| one - other);
        let (low, high) = apart()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), gap| (low.min(gap), high.max(gap)));
        high - low <= SAME
    };
    same(&one.design, &other.design) && same(&one.flank, &other.flank)
}

/// Deviations of a flank from its design over an evaluation range. The mean line minimizes the
/// integral of the squared distance from the trace, which is linear between its points.
fn deviations(
    positions: &[f64],
    [design, flank]: [&[f64]; 2],
    [from, to]: [f64; 2],
    slope_length: f64,
) -> Deviations {
    let points: Vec<(f64, f64)> = positions
        .iter()
        .zip(design.iter().zip(flank))
        .filter(|(position, _)| (from..=to).contains(*position))
        .map(|(position, (design, flank))| (position - 0.5 * (from + to), flank - design))
        .collect();
    let extent = |values: &dyn Fn(&(f64, f64)) -> f64| {
        let values = points.iter().map(values);
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| (low.min(at), high.max(at)))
    };
    let (low, high) = extent(&|point| point.1);
    if points.len() < 2 || high - low <= SAME {
        return Deviations::default();
    }
    let (mut mean, mut moment) = (0.0, 0.0);
    for pair in points.windows(2) {
        let [(a, first), (b, second)] = [pair[0], pair[1]];
        mean += (b - a) * (first + second) / 2.0;
        moment += (b - a) * (a * (2.0 * first + second) + b * (first + 2.0 * second)) / 6.0;
    }
    let length = to - from;
    let (mean, gradient) = (mean / length, 12.0 * moment / (length * length * length));
    let (least, most) = extent(&|point| point.1 - mean - gradient * point.0);
    Deviations {
        total: high - low,
        form: most - least,
        slope: gradient * slope_length,
        middle: 0.5 * (low + high),
    }
}

/// Amounts of the modifications of one flank; equal kinds are added.
fn amounts(modifications: &[Modification], flank: ToothFlank, internal: bool) -> Vec<Amount> {
    let mut all: Vec<Amount> = Vec::new();
    let side = flank.side(internal);
    for modification in modifications.iter().filter(|one| one.applies_to(side, internal)) {
        let unintended = modification.is_unintended();
        for (symbol, name, value) in stated(modification, unintended) {
            match all.iter_mut().find(|amount| amount.symbol == symbol && amount.unintended == unintended) {
                Some(amount) => amount.value += value,
                None => all.push(Amount { symbol, name, value, unintended }),
            }
        }
    }
    all.retain(|amount| amount.value != 0.0);
    all
}

/// Symbol, term and amount (m) of a modification; tables and functions have none. The end of the
/// face towards +e3, from which left and right are seen, is the reference face I.
fn stated(modification: &Modification, unintended: bool) -> Vec<(&'static str, &'static str, f64)> {
    match modification {
        Modification::TipRelief(relief) => vec![("C_alphaa", "tip relief", relief.depth)],
        Modification::RootRelief(relief) => vec![("C_alphaf", "root relief", relief.depth)],
        Modification::ProfileCrown(depth) => vec![("C_alpha", "profile crowning", *depth)],
        Modification::LeadCrown { depth } => vec![("C_beta", "lead crowning", *depth)],
        Modification::ProfileSlope(slope) if unintended => {
            vec![("f_Halpha", "profile slope deviation", *slope)]
        }
        Modification::ProfileSlope(slope) => vec![("C_Halpha", "profile slope", *slope)],
        Modification::HelixSlope(slope) if unintended => vec![("f_Hbeta", "helix slope deviation", *slope)],
        Modification::HelixSlope(slope) => vec![("C_Hbeta", "helix slope", *slope)],
        Modification::Twist(twist) => vec![("S_alpha", "twist", *twist)],
        Modification::EndRelief(relief) => {
            let ends = [("C_betaI", "end relief at +e3"), ("C_betaII", "end relief at -e3")];
            let ends = match relief.ends {
                FaceEnds::Both => &ends[..],
                FaceEnds::Positive => &ends[..1],
                FaceEnds::Negative => &ends[1..],
            };
            ends.iter().map(|(symbol, name)| (*symbol, *name, relief.depth)).collect()
        }
        Modification::OneFlank(_, inner) | Modification::Unintended(inner) => stated(inner, unintended),
        Modification::Deviation(_) | Modification::LeadTable(_) | Modification::Topography(_) => Vec::new(),
    }
}
