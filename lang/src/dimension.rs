//! Physical dimensions: products of powers of length, mass, time, angle and temperature.
//!
//! Exponents are rational, so that the `sqrt` of any quantity has a dimension. Angle is *soft*: it
//! is stored for display and conversion, but dimensions that differ only in the exponent of angle
//! are compatible (`v = omega * r`), see [`Dimension::fits`].

use calyx_abi::description::{Exponents, OWN_BASES};
use std::fmt;

/// A reduced fraction with positive denominator: the exponent of one base dimension.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Rational {
    numerator: i32,
    denominator: i32,
}

impl Rational {
    pub const ZERO: Rational = Rational { numerator: 0, denominator: 1 };
    pub const ONE: Rational = Rational { numerator: 1, denominator: 1 };

    pub const fn integer(value: i32) -> Self {
        Rational { numerator: value, denominator: 1 }
    }

    /// Returns the reduced fraction; `None` for a zero denominator or a fraction that does not fit
    /// in 32 bits.
    pub fn new(numerator: i64, denominator: i64) -> Option<Self> {
        if denominator == 0 {
            return None;
        }
        let (above, below) = (numerator.unsigned_abs(), denominator.unsigned_abs());
        // Most exponents are integers.
        let divisor = if below == 1 { 1 } else { greatest_common_divisor(above, below) };
        let above = i64::try_from(above / divisor).ok()?;
        let numerator = if (numerator < 0) == (denominator < 0) { above } else { -above };
        let denominator = i32::try_from(below / divisor).ok()?;
        Some(Rational { numerator: i32::try_from(numerator).ok()?, denominator })
    }

    /// Returns the fraction nearest to `value` with a denominator up to 64, if the difference is
    /// within rounding.
    pub fn from_f64(value: f64) -> Option<Self> {
        (1..=64_i64).find_map(|denominator| {
            let scaled = value * denominator as f64;
            // The cast is faster than `round`, and the test below rejects values beyond its range.
            let numerator = (scaled + 0.5_f64.copysign(scaled)) as i64;
            let near = (scaled - numerator as f64).abs() <= 4.0 * f64::EPSILON * scaled.abs();
            let is_small = numerator.unsigned_abs() < i32::MAX as u64;
            (near && is_small).then(|| Rational::new(numerator, denominator)).flatten()
        })
    }

    pub fn numerator(self) -> i32 {
        self.numerator
    }

    pub fn denominator(self) -> i32 {
        self.denominator
    }

    pub fn is_zero(self) -> bool {
        self.numerator == 0
    }

    /// Returns the negative fraction. The numerator `i32::MIN` has no negative and is returned
    /// unchanged.
    pub fn negated(self) -> Rational {
        Rational { numerator: self.numerator.saturating_neg(), ..self }
    }

    pub fn to_f64(self) -> f64 {
        f64::from(self.numerator) / f64::from(self.denominator)
    }

    /// Returns `self + sign*other`; `None` if it does not fit in 32 bits.
    pub(crate) fn sum(self, other: Rational, sign: i64) -> Option<Rational> {
        if other.is_zero() {
            return Some(self);
        }
        let (a, b) = (i64::from(self.numerator), i64::from(self.denominator));
        let (c, d) = (i64::from(other.numerator), i64::from(other.denominator));
        // Two products below 2^62 each.
        Rational::new(a * d + sign * c * b, b * d)
    }

    /// Returns the product; `None` if it does not fit in 32 bits.
    pub(crate) fn product(self, other: Rational) -> Option<Rational> {
        // Most exponents are zero.
        if self.is_zero() || other.is_zero() {
            return Some(Rational::ZERO);
        }
        Rational::new(
            i64::from(self.numerator) * i64::from(other.numerator),
            i64::from(self.denominator) * i64::from(other.denominator),
        )
    }
}

fn greatest_common_divisor(mut a: u64, mut b: u64) -> u64 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a.max(1)
}

impl fmt::Display for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.denominator == 1 {
            write!(f, "{}", self.numerator)
        } else {
            write!(f, "({}/{})", self.numerator, self.denominator)
        }
    }
}

impl fmt::Debug for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

/// The base dimensions, in the order in which exponents are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Base {
    Length,
    Mass,
    Time,
    Angle,
    Temperature,
}

impl Base {
    pub const ALL: [Base; 5] = [Base::Length, Base::Mass, Base::Time, Base::Angle, Base::Temperature];

    pub const fn name(self) -> &'static str {
        match self {
            Base::Length => "Length",
            Base::Mass => "Mass",
            Base::Time => "Time",
            Base::Angle => "Angle",
            Base::Temperature => "Temperature",
        }
    }
}

/// Number of physical base dimensions and of those that a program may declare.
const BASES: usize = Base::ALL.len() + OWN_BASES;

/// A dimension: one exponent per [`Base`], then one per base dimension that the program declares.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Dimension {
    exponents: [Rational; BASES],
    /// The exponent of cycles: 1 in Hz, -1 in a period. It is softer than angle: it is neither
    /// displayed nor compared, and only powers of time have it. The lints use it to find a missing
    /// factor 2 pi between cycles and angles ([`Dimension::lacks_turn`]).
    cycles: Rational,
}

impl Dimension {
    /// The dimension of a pure number.
    pub const NONE: Dimension = Dimension::whole([0, 0, 0, 0, 0]);

    /// Returns the dimension with integer exponents of length, mass, time, angle, temperature.
    pub const fn whole(exponents: [i32; 5]) -> Self {
        let mut all = [Rational::ZERO; BASES];
        let mut base = 0;
        while base < exponents.len() {
            all[base] = Rational::integer(exponents[base]);
            base += 1;
        }
        Dimension { exponents: all, cycles: Rational::ZERO }
    }

    /// Returns the `index`-th base dimension that the program declares; `None` beyond the limit.
    pub fn own(index: usize) -> Option<Self> {
        let mut exponents = [Rational::ZERO; BASES];
        *exponents.get_mut(Base::ALL.len() + index)? = Rational::ONE;
        Some(Dimension { exponents, cycles: Rational::ZERO })
    }

    /// Returns the exponents of the base dimensions that the program declares.
    pub fn own_exponents(self) -> [Rational; OWN_BASES] {
        std::array::from_fn(|index| self.exponents[Base::ALL.len() + index])
    }

    /// Returns the dimension with the given exponents as (numerator, denominator).
    pub fn from_exponents(exponents: Exponents) -> Option<Self> {
        let mut all = [Rational::ZERO; BASES];
        for (to, (n, d)) in all.iter_mut().zip(exponents) {
            *to = Rational::new(i64::from(n), i64::from(d))?;
        }
        Some(Dimension { exponents: all, cycles: Rational::ZERO })
    }

    /// Returns `true` if the exponents of all dimensions that the program declares are zero.
    pub fn is_physics(self) -> bool {
        self == self.without_own()
    }

    /// Returns the physical factors only.
    pub fn without_own(mut self) -> Dimension {
        self.exponents[Base::ALL.len()..].fill(Rational::ZERO);
        self
    }

    pub fn of(base: Base) -> Self {
        let mut exponents = [Rational::ZERO; BASES];
        exponents[base as usize] = Rational::ONE;
        Dimension { exponents, cycles: Rational::ZERO }
    }

    pub fn exponent(self, base: Base) -> Rational {
        self.exponents[base as usize]
    }

    /// Returns all exponents as (numerator, denominator).
    pub fn exponents(self) -> Exponents {
        self.exponents.map(|e| (e.numerator, e.denominator))
    }

    /// Returns `true` if some exponent is not an integer.
    pub fn is_fractional(self) -> bool {
        self.exponents().iter().any(|(_, denominator)| *denominator != 1)
    }

    pub fn is_none(self) -> bool {
        self.without_cycles() == Dimension::NONE
    }

    /// Returns the dimension of a product. Exponents beyond 32 bits keep their old value;
    /// [`Dimension::power`] rejects the exponents that would lead there.
    pub fn times(self, other: Dimension) -> Dimension {
        self.combine(other, 1)
    }

    /// Returns the dimension of a quotient; exponents as in [`Dimension::times`].
    pub fn over(self, other: Dimension) -> Dimension {
        self.combine(other, -1)
    }

    fn combine(self, other: Dimension, sign: i64) -> Dimension {
        if other == Dimension::NONE {
            return self.counting_in_time();
        }
        let sum = |a: Rational, b: Rational| a.sum(b, sign).unwrap_or(a);
        let exponents = std::array::from_fn(|i| sum(self.exponents[i], other.exponents[i]));
        Dimension { exponents, cycles: sum(self.cycles, other.cycles) }.counting_in_time()
    }

    /// Returns the dimension of a power; `None` if an exponent is outside -1000 .. 1000.
    pub fn power(self, exponent: Rational) -> Option<Dimension> {
        if self == Dimension::NONE {
            return Some(self);
        }
        let power =
            |e: Rational| e.product(exponent).filter(|e| e.numerator.abs() <= 1000 && e.denominator <= 1000);
        let mut result = [Rational::ZERO; BASES];
        for (to, from) in result.iter_mut().zip(self.exponents) {
            *to = power(from)?;
        }
        Some(Dimension { exponents: result, cycles: power(self.cycles)? })
    }

    /// Returns the same dimension for quantities that count cycles, such as those in Hz.
    pub fn of_cycles(self) -> Dimension {
        Dimension { cycles: Rational::ONE, ..self }
    }

    pub fn without_cycles(self) -> Dimension {
        Dimension { cycles: Rational::ZERO, ..self }
    }

    /// Removes the cycles from dimensions other than powers of time: a force times a frequency does
    /// not count cycles.
    fn counting_in_time(self) -> Dimension {
        let bases = (0..BASES).filter(|i| *i != Base::Time as usize && *i != Base::Angle as usize);
        let time_alone = bases.into_iter().all(|i| self.exponents[i].is_zero());
        if time_alone { self } else { self.without_cycles() }
    }

    /// Returns `true` if a factor of 2 pi is missing between values of the two dimensions: one
    /// counts cycles and the other angles, such as 50 Hz and 3000 rpm.
    pub fn lacks_turn(self, other: Dimension) -> bool {
        let difference = self.combine(other, -1);
        let (angle, cycles) = (difference.exponent(Base::Angle), difference.cycles);
        difference.without_angle() == Dimension::NONE
            && angle.numerator.signum() * cycles.numerator.signum() < 0
    }

    /// Returns `true` for counts of cycles or angles, either per time or as a pure number.
    pub fn is_turning(self) -> bool {
        let counts = !self.cycles.is_zero() || !self.exponent(Base::Angle).is_zero();
        counts && self.of_cycles().counting_in_time() == self.of_cycles()
    }

    /// Returns the dimension with the exponent of angle set to zero, which unification compares.
    pub fn without_angle(mut self) -> Dimension {
        self.exponents[Base::Angle as usize] = Rational::ZERO;
        self.without_cycles()
    }

    /// Returns `true` if values of the two dimensions may be added or assigned: the dimensions are
    /// equal except for angle.
    pub fn fits(self, other: Dimension) -> bool {
        self.without_angle() == other.without_angle()
    }

    /// Returns the dimension for display. If angle results from a multiplication (`omega * r`),
    /// returns the named dimension without angle.
    pub fn tidy(self) -> Dimension {
        let this = self.without_cycles();
        let exact = |d: &&(&str, Dimension)| d.1 == this;
        let soft = |d: &&(&str, Dimension)| d.1.fits(this);
        NAMES.iter().find(exact).or_else(|| NAMES.iter().find(soft)).map_or(this, |d| d.1)
    }

    /// Returns the name of the dimension (`Force`, `Pressure`, ...), ignoring angle if necessary.
    pub fn known_name(self) -> Option<&'static str> {
        let tidy = self.tidy();
        NAMES.iter().find(|d| d.1 == tidy).map(|d| d.0)
    }

    /// Returns the dimension with a name in an annotation, including aliases such as `Torque` and
    /// `Stress`.
    pub fn from_name(name: &str) -> Option<Dimension> {
        NAMES.iter().chain(ALIASES).find(|d| d.0 == name).map(|d| d.1)
    }

    /// Returns every name that [`Dimension::from_name`] accepts, for suggestions and completion.
    pub fn names() -> impl Iterator<Item = &'static str> {
        NAMES.iter().chain(ALIASES).map(|d| d.0)
    }

    /// Returns every named dimension once. Of dimensions that differ only in angle, the preferred
    /// one comes first.
    pub fn named() -> impl Iterator<Item = (&'static str, Dimension)> {
        NAMES.iter().copied()
    }

    /// Returns the product of powers of base dimensions, such as `Length*Mass/Time^2`; `1` for a
    /// pure number.
    pub fn in_bases(self) -> String {
        product(Base::ALL.map(|base| (base.name(), self.exponent(base))))
    }

    /// Returns the product of powers of SI base units, such as `m*kg/s^2`; `1` for a pure number.
    pub fn in_base_units(self) -> String {
        let units = ["m", "kg", "s", "rad", "K"];
        product(Base::ALL.map(|base| (units[base as usize], self.exponent(base))))
    }
}

/// Writes the name if there is one, otherwise the product of base dimensions.
impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.known_name() {
            Some(name) => f.write_str(name),
            None => f.write_str(&self.in_bases()),
        }
    }
}

impl fmt::Debug for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.in_bases())
    }
}

/// Formats `a^2*b/c`: positive powers first, then each negative power after its own `/`. The empty
/// product is `1`.
pub(crate) fn product<const N: usize>(factors: [(&str, Rational); N]) -> String {
    product_of(&factors)
}

/// Formats as [`product`] does, for any number of factors.
pub(crate) fn product_of(factors: &[(&str, Rational)]) -> String {
    let powered =
        |name: &str, e: Rational| if e == Rational::ONE { name.into() } else { format!("{name}^{e}") };
    let above: Vec<String> =
        factors.iter().filter(|f| f.1.numerator > 0).map(|f| powered(f.0, f.1)).collect();
    let mut text = if above.is_empty() { "1".to_string() } else { above.join("*") };
    for &(name, e) in factors.iter().filter(|f| f.1.numerator < 0) {
        text.push('/');
        text.push_str(&powered(name, e.negated()));
    }
    text
}

/// One name per dimension. Of dimensions that differ only in angle, the first entry has priority.
const NAMES: &[(&str, Dimension)] = &[
    ("Number", Dimension::NONE),
    ("Length", Dimension::whole([1, 0, 0, 0, 0])),
    ("Mass", Dimension::whole([0, 1, 0, 0, 0])),
    ("Time", Dimension::whole([0, 0, 1, 0, 0])),
    ("Angle", Dimension::whole([0, 0, 0, 1, 0])),
    ("Temperature", Dimension::whole([0, 0, 0, 0, 1])),
    ("Area", Dimension::whole([2, 0, 0, 0, 0])),
    ("Volume", Dimension::whole([3, 0, 0, 0, 0])),
    ("SecondMomentOfArea", Dimension::whole([4, 0, 0, 0, 0])),
    ("Curvature", Dimension::whole([-1, 0, 0, 0, 0])),
    ("Velocity", Dimension::whole([1, 0, -1, 0, 0])),
    ("Acceleration", Dimension::whole([1, 0, -2, 0, 0])),
    ("AngularVelocity", Dimension::whole([0, 0, -1, 1, 0])),
    ("AngularAcceleration", Dimension::whole([0, 0, -2, 1, 0])),
    ("Frequency", Dimension::whole([0, 0, -1, 0, 0])),
    ("Force", Dimension::whole([1, 1, -2, 0, 0])),
    ("Moment", Dimension::whole([2, 1, -2, 0, 0])),
    ("Pressure", Dimension::whole([-1, 1, -2, 0, 0])),
    ("Stiffness", Dimension::whole([0, 1, -2, 0, 0])),
    ("RotationalStiffness", Dimension::whole([2, 1, -2, -1, 0])),
    ("Compliance", Dimension::whole([0, -1, 2, 0, 0])),
    ("Density", Dimension::whole([-3, 1, 0, 0, 0])),
    ("MomentOfInertia", Dimension::whole([2, 1, 0, 0, 0])),
    ("Damping", Dimension::whole([0, 1, -1, 0, 0])),
    ("RotationalDamping", Dimension::whole([2, 1, -1, -1, 0])),
    ("Viscosity", Dimension::whole([-1, 1, -1, 0, 0])),
    ("KinematicViscosity", Dimension::whole([2, 0, -1, 0, 0])),
    ("Momentum", Dimension::whole([1, 1, -1, 0, 0])),
    ("Power", Dimension::whole([2, 1, -3, 0, 0])),
];

/// Aliases for dimensions of [`NAMES`].
const ALIASES: &[(&str, Dimension)] = &[
    ("Torque", Dimension::whole([2, 1, -2, 0, 0])),
    ("Energy", Dimension::whole([2, 1, -2, 0, 0])),
    ("Stress", Dimension::whole([-1, 1, -2, 0, 0])),
    ("LineLoad", Dimension::whole([0, 1, -2, 0, 0])),
    ("Duration", Dimension::whole([0, 0, 1, 0, 0])),
];

#[cfg(test)]
mod tests {
    use super::*;

    fn named(name: &str) -> Dimension {
        Dimension::from_name(name).expect(name)
    }

    #[test]
    fn products_have_the_names_of_mechanics() {
        for (left, right, product) in [
            ("Force", "Length", "Moment"),
            ("Stiffness", "Length", "Force"),
            ("Pressure", "Area", "Force"),
            ("Mass", "Acceleration", "Force"),
            ("AngularVelocity", "Length", "Velocity"),
            ("Moment", "AngularVelocity", "Power"),
            ("RotationalStiffness", "Angle", "Moment"),
            ("Curvature", "Length", "Number"),
            ("Angle", "Length", "Length"),
        ] {
            assert_eq!(named(left).times(named(right)).to_string(), product, "{left}*{right}");
            let quotient = named(product).over(named(right));
            assert!(quotient.fits(named(left)), "{product}/{right} is {quotient:?}");
        }
    }

    #[test]
    fn unnamed_dimensions_show_their_factors() {
        let half = Rational::new(1, 2).unwrap();
        let root = named("Length").power(half).unwrap().over(named("Time"));
        assert_eq!(root.to_string(), "Length^(1/2)/Time");
        assert_eq!(named("Force").in_base_units(), "m*kg/s^2");
        assert_eq!(
            root.power(Rational::integer(2)).unwrap(),
            named("Length").over(named("Time").times(named("Time")))
        );
    }

    #[test]
    fn no_exponent_overflows() {
        let huge = Rational::integer(i32::MAX);
        assert_eq!(named("Force").power(huge), None);
        let thousand = named("Length").power(Rational::integer(1000)).unwrap();
        assert!(thousand.power(Rational::integer(2)).is_none());
        assert_eq!(Rational::new(1, 0), None);
        assert_eq!(Rational::new(i64::MIN, -1), None);
    }

    #[test]
    fn cycles_meet_angles_only_in_powers_of_time() {
        let (hertz, speed) = (named("Frequency").of_cycles(), named("AngularVelocity"));
        assert!(hertz.lacks_turn(speed) && speed.lacks_turn(hertz));
        assert!(Dimension::NONE.over(hertz).lacks_turn(Dimension::NONE.over(speed)));
        assert!(hertz.times(named("Time")).lacks_turn(named("Angle")));
        // A radius times a frequency is a velocity, as is a radius times an angular velocity.
        assert!(!hertz.times(named("Length")).lacks_turn(speed.times(named("Length"))));
        // The square root of stiffness by mass does not count cycles; a revolution in each cycle is
        // an angular velocity.
        assert!(!named("Frequency").lacks_turn(speed) && !hertz.lacks_turn(named("Frequency")));
        assert!(!hertz.times(named("Angle")).lacks_turn(speed));
        assert_eq!((hertz.to_string(), hertz.is_none()), ("Frequency".to_string(), false));
    }

    #[test]
    fn decimal_exponents_are_recognised() {
        assert_eq!(Rational::from_f64(0.5), Rational::new(1, 2));
        assert_eq!(Rational::from_f64(-1.0 / 3.0), Rational::new(-1, 3));
        assert_eq!(Rational::from_f64(std::f64::consts::PI), None);
        assert_eq!(Rational::from_f64(f64::NAN), None);
    }
}
