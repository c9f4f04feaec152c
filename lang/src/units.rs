//! Units of measurement and the unit systems of models.

use crate::dimension::{Base, Dimension, Rational, product};
use crate::ir::DisplayUnit;
use std::f64::consts::PI;

/// A unit: SI value = number * `factor`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    pub name: &'static str,
    /// Plurals and alternative spellings.
    pub aliases: &'static [&'static str],
    pub dimension: Dimension,
    pub factor: f64,
}

impl Unit {
    /// Returns the unit with the given name or alias.
    pub fn find(name: &str) -> Option<&'static Unit> {
        UNITS.iter().find(|u| u.name == name || u.aliases.contains(&name))
    }

    /// Returns its dimension, including cycles for Hz and kHz, which have no angle.
    pub fn counted(&self) -> Dimension {
        match self.name {
            "Hz" | "kHz" => self.dimension.of_cycles(),
            _ => self.dimension,
        }
    }

    /// Returns the unit name with the most similar spelling, for "did you mean".
    pub fn similar(name: &str) -> Option<&'static str> {
        Unit::nearest(name).into_iter().next()
    }

    /// Returns the unit names with the most similar spelling, the nearest first. Only names about
    /// as near as the first are included.
    pub fn nearest(name: &str) -> Vec<&'static str> {
        let spellings = UNITS.iter().flat_map(|u| u.aliases.iter().chain([&u.name]));
        let lower = name.to_lowercase();
        let close = |spelling: &str| {
            // A difference in case alone (`MM`, `Psi`) is nearer than any other change.
            if spelling.to_lowercase() == lower {
                return 2.0;
            }
            // Two transposed letters (`rmp`) are one mistake, which the similarity measure
            // overrates in short names.
            let slip = name.len() > 2 && strsim::damerau_levenshtein(spelling, name) == 1;
            strsim::jaro_winkler(spelling, name).max(if slip { 0.85 } else { 0.0 })
        };
        // For missing letters, similarity alone would find `rad` in `breadth`.
        let mut near: Vec<(f64, &'static str)> = spellings
            .filter(|spelling| spelling.chars().count().abs_diff(name.chars().count()) <= 2)
            .map(|s| (close(s), *s))
            .filter(|(similarity, _)| *similarity > 0.8)
            .collect();
        // Aliases precede names; prefer names.
        near.reverse();
        near.sort_by(|a, b| b.0.total_cmp(&a.0));
        let best = near.first().map_or(0.0, |(similarity, _)| *similarity);
        near.into_iter()
            .take_while(|(similarity, _)| best - similarity < 0.05)
            .map(|(_, name)| name)
            .collect()
    }

    /// Returns all units in the order of the reference.
    pub fn all() -> &'static [Unit] {
        UNITS
    }
}

const INCH: f64 = 0.0254;
const FOOT: f64 = 0.3048;
/// International avoirdupois pound, kg, exact.
const POUND_MASS: f64 = 0.453_592_37;
/// Standard acceleration of gravity, m/s², exact.
const GRAVITY: f64 = 9.806_65;
/// Pound-force, N: `POUND_MASS * GRAVITY`, exact in decimal.
const POUND_FORCE: f64 = 4.448_221_615_260_5;
const PSI: f64 = POUND_FORCE / (INCH * INCH);

const NUMBER: Dimension = Dimension::NONE;
const LENGTH: Dimension = Dimension::whole([1, 0, 0, 0, 0]);
const MASS: Dimension = Dimension::whole([0, 1, 0, 0, 0]);
const TIME: Dimension = Dimension::whole([0, 0, 1, 0, 0]);
const ANGLE: Dimension = Dimension::whole([0, 0, 0, 1, 0]);
const TEMPERATURE: Dimension = Dimension::whole([0, 0, 0, 0, 1]);
const FORCE: Dimension = Dimension::whole([1, 1, -2, 0, 0]);
const ENERGY: Dimension = Dimension::whole([2, 1, -2, 0, 0]);
const PRESSURE: Dimension = Dimension::whole([-1, 1, -2, 0, 0]);
const POWER: Dimension = Dimension::whole([2, 1, -3, 0, 0]);
const FREQUENCY: Dimension = Dimension::whole([0, 0, -1, 0, 0]);
const ANGULAR_VELOCITY: Dimension = Dimension::whole([0, 0, -1, 1, 0]);

const fn unit(
    name: &'static str,
    aliases: &'static [&'static str],
    dimension: Dimension,
    factor: f64,
) -> Unit {
    Unit { name, aliases, dimension, factor }
}

const UNITS: &[Unit] = &[
    unit("m", &["meter", "meters", "metre", "metres"], LENGTH, 1.0),
    unit("cm", &[], LENGTH, 0.01),
    unit("mm", &[], LENGTH, 0.001),
    unit("um", &["µm", "μm", "micron", "microns"], LENGTH, 1e-6),
    unit("km", &[], LENGTH, 1000.0),
    unit("inch", &["inches"], LENGTH, INCH),
    unit("ft", &["foot", "feet"], LENGTH, FOOT),
    unit("mil", &["mils"], LENGTH, INCH / 1000.0),
    unit("microinch", &["uinch", "microinches"], LENGTH, INCH / 1e6),
    unit("kg", &[], MASS, 1.0),
    unit("g", &["gram", "grams"], MASS, 0.001),
    unit("tonne", &["tonnes"], MASS, 1000.0),
    unit("lbm", &[], MASS, POUND_MASS),
    unit("slug", &["slugs"], MASS, POUND_FORCE / FOOT),
    unit("s", &["sec", "second", "seconds"], TIME, 1.0),
    unit("ms", &[], TIME, 1e-3),
    unit("us", &["µs", "μs"], TIME, 1e-6),
    unit("min", &["minute", "minutes"], TIME, 60.0),
    unit("hour", &["hours"], TIME, 3600.0),
    unit("rad", &["radian", "radians"], ANGLE, 1.0),
    unit("mrad", &[], ANGLE, 1e-3),
    unit("urad", &["µrad", "μrad"], ANGLE, 1e-6),
    unit("deg", &["degree", "degrees"], ANGLE, PI / 180.0),
    unit("arcmin", &[], ANGLE, PI / 10_800.0),
    unit("arcsec", &[], ANGLE, PI / 648_000.0),
    unit("rev", &["turn", "turns"], ANGLE, 2.0 * PI),
    unit("rpm", &[], ANGULAR_VELOCITY, PI / 30.0),
    unit("Hz", &[], FREQUENCY, 1.0),
    unit("kHz", &[], FREQUENCY, 1000.0),
    unit("N", &["newton", "newtons"], FORCE, 1.0),
    unit("kN", &[], FORCE, 1e3),
    unit("MN", &[], FORCE, 1e6),
    unit("lbf", &[], FORCE, POUND_FORCE),
    unit("kgf", &[], FORCE, GRAVITY),
    unit("Pa", &[], PRESSURE, 1.0),
    unit("kPa", &[], PRESSURE, 1e3),
    unit("MPa", &[], PRESSURE, 1e6),
    unit("GPa", &[], PRESSURE, 1e9),
    unit("bar", &[], PRESSURE, 1e5),
    unit("psi", &[], PRESSURE, PSI),
    unit("ksi", &[], PRESSURE, 1e3 * PSI),
    unit("Msi", &[], PRESSURE, 1e6 * PSI),
    unit("J", &["joule", "joules"], ENERGY, 1.0),
    unit("W", &["watt", "watts"], POWER, 1.0),
    unit("kW", &[], POWER, 1e3),
    // 550 ft lbf/s.
    unit("hp", &[], POWER, 550.0 * FOOT * POUND_FORCE),
    unit("K", &["kelvin"], TEMPERATURE, 1.0),
    unit("%", &["percent"], NUMBER, 0.01),
];

/// A coherent system of units, for literals without a unit and for displayed results. Because it is
/// coherent, products of displayed numbers need no conversion factors, and a displayed number can
/// be used as a literal.
///
/// Angles are in radians in every system: transmission errors are microradians, and products such
/// as `error * base_radius` are in the system's unit of length.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum UnitSystem {
    #[default]
    Si,
    /// Millimetre, newton, second (therefore tonne and MPa).
    MmNS,
    /// Inch, pound-force, second (therefore lbf*s^2/inch and psi).
    InchLbfS,
}

/// The base units of a system's unit names.
struct Names {
    length: &'static str,
    force: &'static str,
    /// If the coherent unit of mass has no name, masses are displayed in force, time and length.
    mass: Option<&'static str>,
    pressure: &'static str,
    power: Option<&'static str>,
}

impl UnitSystem {
    pub const ALL: [UnitSystem; 3] = [UnitSystem::Si, UnitSystem::MmNS, UnitSystem::InchLbfS];

    /// Returns the name as written in `units ...;`.
    pub fn name(self) -> &'static str {
        match self {
            UnitSystem::Si => "SI",
            UnitSystem::MmNS => "mm_N_s",
            UnitSystem::InchLbfS => "inch_lbf_s",
        }
    }

    pub fn from_name(name: &str) -> Option<UnitSystem> {
        UnitSystem::ALL.into_iter().find(|s| s.name() == name)
    }

    fn names(self) -> Names {
        match self {
            UnitSystem::Si => {
                Names { length: "m", force: "N", mass: Some("kg"), pressure: "Pa", power: Some("W") }
            }
            UnitSystem::MmNS => {
                Names { length: "mm", force: "N", mass: Some("tonne"), pressure: "MPa", power: None }
            }
            UnitSystem::InchLbfS => {
                Names { length: "inch", force: "lbf", mass: None, pressure: "psi", power: None }
            }
        }
    }

    /// Returns the SI values of the units of length and force; time, angle and temperature are in
    /// SI units in every system.
    fn length_and_force(self) -> (f64, f64) {
        match self {
            UnitSystem::Si => (1.0, 1.0),
            UnitSystem::MmNS => (1e-3, 1.0),
            UnitSystem::InchLbfS => (INCH, POUND_FORCE),
        }
    }

    /// Returns the system's unit of a dimension, for literals without a unit and for display.
    /// Angles that result from multiplication are dropped ([`Dimension::tidy`]).
    pub fn unit_of(self, dimension: Dimension) -> DisplayUnit {
        let dimension = dimension.tidy();
        let (length, force) = self.length_and_force();
        // L^l M^m T^t = F^m L^(l-m) T^(t+2m), because the coherent unit of mass is F T^2 / L.
        let (length_exponent, mass_exponent) =
            (dimension.exponent(Base::Length), dimension.exponent(Base::Mass));
        let in_force = force_length_time(dimension);
        let factor = if mass_exponent.is_zero() {
            power(length, length_exponent)
        } else {
            // For integer exponents, a single fraction, so that psi is exactly lbf/inch^2.
            let above = power(force, mass_exponent);
            let lengths = in_force.exponent(Base::Length);
            if lengths.numerator() < 0 {
                above / power(length, lengths.negated())
            } else {
                above * power(length, lengths)
            }
        };
        DisplayUnit { name: self.unit_name(dimension), factor, dimension: dimension.exponents() }
    }

    fn unit_name(self, dimension: Dimension) -> String {
        let names = self.names();
        if dimension.is_none() {
            return String::new();
        }
        if dimension == PRESSURE {
            return names.pressure.to_string();
        }
        if let (Some(name), true) = (names.power, dimension == POWER) {
            return name.to_string();
        }
        let others = |d: Dimension| {
            [
                ("s", d.exponent(Base::Time)),
                ("rad", d.exponent(Base::Angle)),
                ("K", d.exponent(Base::Temperature)),
            ]
        };
        if let (Some(mass), true) = (names.mass, dimension.exponent(Base::Time).is_zero()) {
            let [time, angle, temperature] = others(dimension);
            let first = (mass, dimension.exponent(Base::Mass));
            return product([
                first,
                (names.length, dimension.exponent(Base::Length)),
                time,
                angle,
                temperature,
            ]);
        }
        let in_force = force_length_time(dimension);
        let [time, angle, temperature] = others(in_force);
        let first = (names.force, in_force.exponent(Base::Mass));
        product([first, (names.length, in_force.exponent(Base::Length)), time, angle, temperature])
    }
}

/// Returns the exponents of force (instead of mass), length and time; angle and temperature are
/// unchanged.
fn force_length_time(dimension: Dimension) -> Dimension {
    let per_force = Dimension::whole([1, 0, -2, 0, 0]);
    let mass = dimension.exponent(Base::Mass);
    per_force.power(mass).map_or(dimension, |carried| dimension.over(carried))
}

fn power(base: f64, exponent: Rational) -> f64 {
    if exponent.denominator() == 1 { base.powi(exponent.numerator()) } else { base.powf(exponent.to_f64()) }
}

/// Returns the unit of a pure number.
pub fn pure() -> DisplayUnit {
    DisplayUnit { name: String::new(), factor: 1.0, dimension: Dimension::NONE.exponents() }
}

/// Returns a power of a unit; `None` if an exponent is out of range.
pub fn powered(unit: &DisplayUnit, exponent: i32) -> Option<DisplayUnit> {
    if exponent == 1 {
        return Some(unit.clone());
    }
    let mut dimension = unit.dimension;
    for to in &mut dimension {
        let numerator = i64::from(to.0) * i64::from(exponent);
        let power = Rational::new(numerator, i64::from(to.1)).filter(|e| e.numerator().abs() <= 1000)?;
        *to = (power.numerator(), power.denominator());
    }
    let name = format!("{}^{exponent}", grouped(&unit.name));
    Some(DisplayUnit { name, factor: power(unit.factor, Rational::integer(exponent)), dimension })
}

/// Returns a product or quotient of units, named as it is written.
pub fn combined(left: &DisplayUnit, right: &DisplayUnit, product: bool) -> Option<DisplayUnit> {
    let name = match (left.name.as_str(), right.name.as_str(), product) {
        (left, "", _) => left.to_string(),
        ("", right, true) => right.to_string(),
        ("", right, false) => format!("1/{}", grouped(right)),
        (left, right, true) => format!("{left}*{right}"),
        (left, right, false) => format!("{left}/{}", grouped(right)),
    };
    let mut dimension = left.dimension;
    for (a, b) in dimension.iter_mut().zip(right.dimension) {
        let sign = if product { 1 } else { -1 };
        let numerator = i64::from(a.0) * i64::from(b.1) + sign * i64::from(b.0) * i64::from(a.1);
        let sum = Rational::new(numerator, i64::from(a.1) * i64::from(b.1))?;
        *a = (sum.numerator(), sum.denominator());
    }
    let factor = if product { left.factor * right.factor } else { left.factor / right.factor };
    Some(DisplayUnit { name, factor, dimension })
}

fn grouped(name: &str) -> String {
    if name.contains(['*', '/']) { format!("({name})") } else { name.to_string() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(system: UnitSystem, dimension: &str) -> (String, f64) {
        let unit = system.unit_of(Dimension::from_name(dimension).expect(dimension));
        (unit.name, unit.factor)
    }

    #[test]
    fn systems_show_the_units_engineers_write() {
        for (dimension, si, mm, inch) in [
            ("Number", "", "", ""),
            ("Length", "m", "mm", "inch"),
            ("Area", "m^2", "mm^2", "inch^2"),
            ("Curvature", "1/m", "1/mm", "1/inch"),
            ("Mass", "kg", "tonne", "lbf*s^2/inch"),
            ("Time", "s", "s", "s"),
            ("Angle", "rad", "rad", "rad"),
            ("AngularVelocity", "rad/s", "rad/s", "rad/s"),
            ("Velocity", "m/s", "mm/s", "inch/s"),
            ("Force", "N", "N", "lbf"),
            ("Moment", "N*m", "N*mm", "lbf*inch"),
            ("Pressure", "Pa", "MPa", "psi"),
            ("Stiffness", "N/m", "N/mm", "lbf/inch"),
            ("RotationalStiffness", "N*m/rad", "N*mm/rad", "lbf*inch/rad"),
            ("Density", "kg/m^3", "tonne/mm^3", "lbf*s^2/inch^4"),
            ("Power", "W", "N*mm/s", "lbf*inch/s"),
        ] {
            let names = UnitSystem::ALL.map(|s| shown(s, dimension).0);
            assert_eq!(names, [si, mm, inch], "{dimension}");
        }
    }

    #[test]
    fn factors_are_those_of_the_named_units() {
        for (system, dimension, unit) in [
            (UnitSystem::InchLbfS, "Length", "inch"),
            (UnitSystem::InchLbfS, "Force", "lbf"),
            (UnitSystem::InchLbfS, "Pressure", "psi"),
            (UnitSystem::MmNS, "Length", "mm"),
            (UnitSystem::Si, "Power", "W"),
        ] {
            assert_eq!(shown(system, dimension).1, Unit::find(unit).unwrap().factor, "{dimension}");
        }
        // These differ by one rounding of the divided powers of 0.001.
        for (dimension, unit) in [("Pressure", "MPa"), ("Mass", "tonne")] {
            let ratio = shown(UnitSystem::MmNS, dimension).1 / Unit::find(unit).unwrap().factor;
            assert!((ratio - 1.0).abs() < 4.0 * f64::EPSILON, "{dimension}: {ratio}");
        }
    }

    #[test]
    fn every_unit_is_found_once() {
        let mut seen = std::collections::HashSet::new();
        for unit in Unit::all() {
            assert!(unit.factor > 0.0 && unit.factor.is_finite());
            for name in unit.aliases.iter().chain([&unit.name]) {
                assert!(seen.insert(name), "{name} stands twice");
                assert_eq!(Unit::find(name), Some(unit));
            }
        }
        assert_eq!(Unit::find("in"), None);
    }

    #[test]
    fn defining_relations_hold() {
        let factor = |name: &str| Unit::find(name).unwrap().factor;
        let close = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 4.0 * f64::EPSILON, "{a} {b}");
        close(factor("lbf"), factor("lbm") * GRAVITY);
        close(factor("slug") * factor("ft"), factor("lbf"));
        close(factor("rpm") * factor("min"), factor("rev"));
        close(factor("hp"), 745.699_871_582_270_2);
        close(factor("arcsec") * 3600.0, factor("deg"));
    }

    #[test]
    fn units_have_whole_powers_products_and_quotients() {
        let named = |name: &str| {
            let unit = Unit::find(name).unwrap();
            DisplayUnit { name: name.into(), factor: unit.factor, dimension: unit.dimension.exponents() }
        };
        let square = powered(&named("inch"), 2).unwrap();
        assert_eq!((square.name.as_str(), square.factor), ("inch^2", INCH * INCH));
        assert_eq!(powered(&named("inch"), i32::MAX), None);
        let moment = combined(&named("lbf"), &named("inch"), true).unwrap();
        assert_eq!(combined(&pure(), &moment, false).unwrap().name, "1/(lbf*inch)");
        assert_eq!(combined(&named("mm"), &moment, false).unwrap().name, "mm/(lbf*inch)");
    }

    #[test]
    fn misspelt_units_are_recognised() {
        assert_eq!(Unit::similar("MM"), Some("mm"));
        assert_eq!(Unit::similar("incs"), Some("inches"));
        assert_eq!(Unit::similar("Psi"), Some("psi"));
        assert_eq!(Unit::similar("furlong"), None);
    }
}
