//! Tip, root and end reliefs: the growth of the amount from the start of the relief to its end, and
//! the equivalent ways of stating the start of a profile relief.

use crate::error::{GeometryError, Part, Sentence, sentence};
use crate::gear::ToothForm;
use calyx_abi::math;

/// Growth of a relief from its start to its end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ReliefShape {
    /// Proportional to the distance from the start. The corner at the start is rounded over
    /// [`LINEAR_BLEND`] of the relief's length to both sides, because no tool leaves a sharp
    /// corner.
    Linear,
    /// Proportional to the square of the distance from the start.
    Quadratic,
    /// Circular arc in the profile diagram: tangent to the unmodified flank at the start, with
    /// amount and distance on equal scales.
    Arc,
    /// Proportional to this power of the distance from the start, between 1 and
    /// [`LARGEST_EXPONENT`]. Below 2, a parabola rounds the start, whose curvature would be
    /// unbounded.
    Progressive(f64),
}

/// Half-width of the rounding at the start of a relief, as a fraction of the relief's length.
pub const LINEAR_BLEND: f64 = 0.05;
/// Largest exponent of a progressive relief.
pub const LARGEST_EXPONENT: f64 = 20.0;
/// Largest difference of statements of the start that agree, as roll length in transverse modules:
/// drawings round diameters and angles.
const AGREEMENT: f64 = 0.01;

/// Coordinate along a relief.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ReliefRange {
    /// Distance from start to end.
    pub length: f64,
    /// Distance from the start back to the other end of the flank.
    pub room: f64,
    /// Metres per unit of the coordinate.
    pub metres: f64,
}

impl ReliefShape {
    /// Number that identifies the shape in keys.
    pub(crate) fn number(self) -> f64 {
        match self {
            ReliefShape::Quadratic => 0.0,
            ReliefShape::Linear => 1.0,
            ReliefShape::Arc => -1.0,
            ReliefShape::Progressive(exponent) => 1.0 + exponent,
        }
    }

    /// Distance from the start at which the power law begins, and the distance before the start at
    /// which the parabola that rounds the start begins; both zero without rounding.
    fn rounding(self, range: &ReliefRange) -> [f64; 2] {
        match self {
            ReliefShape::Linear => {
                let blend = (LINEAR_BLEND * range.length).min(range.room);
                [blend, blend]
            }
            // The parabola is tangent to the power law: it begins 2/p times the distance of the
            // tangent point before it.
            ReliefShape::Progressive(exponent) if exponent < 2.0 => {
                let before = 2.0 / exponent - 1.0;
                let blend = (LINEAR_BLEND * range.length).min(range.room / before);
                [blend, blend * before]
            }
            _ => [0.0; 2],
        }
    }

    /// Distances from the start at which the second derivative is discontinuous, ascending.
    pub(crate) fn breaks(self, range: &ReliefRange) -> Vec<f64> {
        match self.rounding(range) {
            [after, before] if after > 0.0 => vec![-before, after],
            _ => vec![0.0],
        }
    }

    /// Amount (m) at a distance from the start, and its first and second derivatives. The amount is
    /// `depth` (m) at the end of the range; beyond it the curve continues.
    pub(crate) fn amount(self, depth: f64, x: f64, range: &ReliefRange) -> [f64; 3] {
        let length = range.length;
        let [after, before] = self.rounding(range);
        if x <= -before {
            return [0.0; 3];
        }
        match self {
            ReliefShape::Quadratic => {
                let part = x / length;
                [depth * part * part, 2.0 * depth * part / length, 2.0 * depth / (length * length)]
            }
            ReliefShape::Linear => {
                let slope = depth / length;
                if x < after {
                    // Parabola tangent to both straight parts.
                    let into = x + after;
                    return [
                        slope * into * into / (4.0 * after),
                        slope * into / (2.0 * after),
                        slope / (2.0 * after),
                    ];
                }
                [slope * x, slope, 0.0]
            }
            ReliefShape::Progressive(exponent) if x < after => {
                let at = depth * math::pow(after / length, exponent);
                let factor = exponent * exponent * at / (4.0 * after * after);
                let into = x + before;
                [factor * into * into, 2.0 * factor * into, 2.0 * factor]
            }
            ReliefShape::Progressive(exponent) => {
                let part = x / length;
                let power = |less: f64| math::pow(part, exponent - less);
                let slope = exponent * depth / length;
                [depth * power(0.0), slope * power(1.0), slope * (exponent - 1.0) / length * power(2.0)]
            }
            ReliefShape::Arc => arc(depth, x, range),
        }
    }
}

/// Amount of a circular arc and its derivatives. Beyond its end, its parabola of curvature
/// continues it.
fn arc(depth: f64, x: f64, range: &ReliefRange) -> [f64; 3] {
    let end = range.length * range.metres;
    let on_arc = (x * range.metres).min(end);
    let beyond = x * range.metres - on_arc;
    // Radius through the end of the relief: R = (L^2 + C^2) / (2 C). The amount is R minus the
    // height of the circle, without its cancellation.
    let diameter = end * (end / depth) + depth;
    let radius = 0.5 * diameter;
    let height = math::sqrt((radius - on_arc) * (radius + on_arc));
    let amount = on_arc * on_arc / (radius + height);
    let slope = on_arc / height;
    let bend = radius * radius / (height * height * height);
    [
        amount + beyond * (slope + 0.5 * beyond * bend),
        (slope + beyond * bend) * range.metres,
        bend * range.metres * range.metres,
    ]
}

/// Statement of the start of a relief.
struct Statement {
    /// Argument of the library functions.
    argument: &'static str,
    /// Value of the argument.
    value: Part,
    /// Roll angle of the start, rad, positive.
    roll: f64,
}

/// Start of a tip or root relief, in one or several equivalent forms.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ReliefStart {
    /// Roll angle, rad.
    pub roll_angle: Option<f64>,
    /// Roll length, m: length of the tangent from the base circle.
    pub roll_length: Option<f64>,
    /// Diameter, m.
    pub diameter: Option<f64>,
    /// Length of the relief along the path of contact, m: difference of the roll lengths of its
    /// start and of the tip circle, for a root relief of the root form circle.
    pub length: Option<f64>,
}

impl ReliefStart {
    /// Start at a roll angle, rad.
    pub fn at_roll(roll_angle: f64) -> ReliefStart {
        ReliefStart { roll_angle: Some(roll_angle), ..ReliefStart::default() }
    }

    /// Returns whether no form is stated.
    pub fn is_empty(&self) -> bool {
        *self == ReliefStart::default()
    }

    /// Stated forms as positive roll angles (rad), with their names and the stated values.
    fn statements(&self, form: &ToothForm, at_root: bool) -> Vec<Statement> {
        let base = form.base_radius;
        let end = if at_root { form.form_roll } else { form.tip_roll };
        let inwards = if at_root { 1.0 } else { -1.0 };
        let at = |argument, value, roll| Statement { argument, value, roll };
        let by_diameter = |diameter: f64| form.roll_at_radius(0.5 * diameter).abs();
        let by_length = |length: f64| form.sense() * (end + inwards * length / base);
        [
            self.roll_angle.map(|roll| at("start_roll_angle", Part::Angle(roll), roll)),
            self.roll_length.map(|length| at("start_roll_length", Part::Length(length), length / base)),
            self.diameter.map(|size| at("start_diameter", Part::Length(size), by_diameter(size))),
            self.length.map(|length| at("length", Part::Length(length), by_length(length))),
        ]
        .into_iter()
        .flatten()
        .collect()
    }
}

/// Tip relief. As a root relief, "tip" stands for the root form circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TipRelief {
    /// Amount at the tip circle, m.
    pub depth: f64,
    /// Start of the relief.
    pub start: ReliefStart,
    /// Growth from the start to the tip circle.
    pub shape: ReliefShape,
}

/// Relief on the flank of a gear: a tip relief, or a root relief expressed as the tip relief of the
/// reversed flank, on which roll angles change sign.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PlacedRelief {
    depth: f64,
    shape: ReliefShape,
    /// Roll angle at the start on the flank, or on the reversed flank.
    start: f64,
    range: ReliefRange,
    at_root: bool,
}

impl TipRelief {
    /// Roll angle at the start on a gear, rad, positive. The first stated form determines it.
    ///
    /// # Errors
    /// E0935: no start is stated. E0936: two statements of the start contradict each other.
    pub fn start_roll(&self, form: &ToothForm, at_root: bool) -> Result<f64, GeometryError> {
        let stated = self.start.statements(form, at_root);
        let Some((first, others)) = stated.split_first() else {
            return Err(without_start(at_root));
        };
        let difference = |other: &Statement| (other.roll - first.roll).abs() * form.base_radius;
        match others.iter().find(|other| difference(other) > AGREEMENT * form.module) {
            Some(other) => Err(contradiction(at_root, first, other)),
            None => Ok(first.roll),
        }
    }

    /// Places the relief on the flank of a gear.
    ///
    /// # Errors
    /// E0935, E0936, and E0640 or E0641 if the relief does not fit the flank.
    pub(crate) fn placed(&self, form: &ToothForm, at_root: bool) -> Result<PlacedRelief, GeometryError> {
        let start_roll = self.start_roll(form, at_root)?;
        let end = if at_root { "root" } else { "tip" };
        let start = form.sense() * start_roll;
        if !(form.form_roll..form.tip_roll).contains(&start) {
            return Err(outside_involute(end, start_roll, form));
        }
        check_depth([end, " relief"], self.depth, form)?;
        let (start, far, near) = match at_root {
            false => (start, form.tip_roll, form.form_roll),
            true => (-start, -form.form_roll, -form.tip_roll),
        };
        let range = ReliefRange { length: far - start, room: start - near, metres: form.base_radius };
        let arc = self.shape == ReliefShape::Arc;
        if arc && self.depth > 0.0 && self.depth >= 0.5 * range.length * range.metres {
            return Err(steep_arc(end, self.depth, range.length * range.metres));
        }
        Ok(PlacedRelief { depth: self.depth, shape: self.shape, start, range, at_root })
    }
}

impl PlacedRelief {
    /// Amount (m) at a roll angle of the flank, and its first and second derivatives by the roll
    /// angle.
    pub fn amount(&self, roll: f64) -> [f64; 3] {
        let turned = if self.at_root { -roll } else { roll };
        let [amount, slope, bend] = self.shape.amount(self.depth, turned - self.start, &self.range);
        [amount, if self.at_root { -slope } else { slope }, bend]
    }

    /// Roll angles at which the second derivative of the amount is discontinuous, ascending.
    pub fn breaks(&self) -> Vec<f64> {
        let breaks = self.shape.breaks(&self.range).into_iter().map(|x| self.start + x);
        if self.at_root { breaks.rev().map(|roll| -roll).collect() } else { breaks.collect() }
    }
}

/// Checks the depth of a profile modification that only removes material, with the two words that
/// name it in messages.
///
/// # Errors
/// E0641: the depth is negative or reaches half of the tip thickness.
pub(crate) fn check_depth(
    [kind, noun]: [&'static str; 2],
    depth: f64,
    form: &ToothForm,
) -> Result<(), GeometryError> {
    let most = 0.5 * form.tip_thickness();
    if depth >= 0.0 && depth < most {
        return Ok(());
    }
    Err(GeometryError::error(
        "E0641",
        "depth",
        sentence![
            "the ", text kind, text noun, " is ", length depth,
            " deep, but must be between zero and half the tip thickness, ", length most
        ],
        sentence![
            "usual depths are near the deflection of the teeth under load, a few thousandths of a module"
        ],
    ))
}

fn outside_involute(end: &'static str, start_roll: f64, form: &ToothForm) -> GeometryError {
    GeometryError::error(
        "E0640",
        "start_roll_angle",
        sentence![
            "the ", text end, " relief starts at a roll angle of ", angle start_roll,
            ", but the involute runs from ", angle form.form_roll.abs(), " to ", angle form.tip_roll.abs()
        ],
        sentence![
            "start the relief on the involute, usually near the last point of single-tooth contact towards that end"
        ],
    )
}

fn steep_arc(end: &'static str, depth: f64, length: f64) -> GeometryError {
    GeometryError::error(
        "E0641",
        "depth",
        sentence![
            "the ", text end, " relief is ", length depth, " deep, but an arc of a length of ", length length,
            " can only be half as deep as it is long"
        ],
        sentence!["reduce the depth, or start the relief farther from the ", text end],
    )
}

/// Error for a relief whose start is not stated.
pub(crate) fn without_start(at_root: bool) -> GeometryError {
    let end = if at_root { "root" } else { "tip" };
    GeometryError::error(
        "E0935",
        "start_roll_angle",
        sentence!["the start of the ", text end, " relief is not stated"],
        sentence![
            "give one of `start_roll_angle`, `start_roll_length`, `start_diameter` or `length`, the length of the relief along the path of contact"
        ],
    )
}

/// Error for two statements of the start that differ.
fn contradiction(at_root: bool, first: &Statement, second: &Statement) -> GeometryError {
    let end = if at_root { "root" } else { "tip" };
    let stated = |statement: &Statement| {
        [
            Part::Text(statement.argument),
            Part::Text("` = "),
            statement.value.clone(),
            Part::Text(" is a roll angle of "),
            Part::Angle(statement.roll),
        ]
    };
    let mut message = sentence!["the ", text end, " relief has two different starts: `"].0;
    message.extend(stated(first));
    message.push(Part::Text(", but `"));
    message.extend(stated(second));
    GeometryError::error(
        "E0936",
        second.argument,
        Sentence(message),
        sentence!["give one of them; on this gear they contradict each other"],
    )
}
