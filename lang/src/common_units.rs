//! The common engineering units of each quantity, offered in addition to the unit of the file's
//! system.

use crate::dimension::Dimension;
use crate::ir::DisplayUnit;
use crate::units::{Unit, UnitSystem, combined, powered, pure};

/// Units of physical quantities, the most common first. Quantities that are not listed use the
/// units of the systems.
const USUAL: &[(&str, &[&str])] = &[
    ("Number", &["%"]),
    ("Length", &["mm", "inch", "m", "um", "mil"]),
    ("Area", &["mm^2", "inch^2", "m^2"]),
    ("Volume", &["mm^3", "inch^3", "m^3"]),
    ("SecondMomentOfArea", &["mm^4", "inch^4"]),
    ("Curvature", &["1/mm", "1/inch", "1/m"]),
    ("Mass", &["kg", "g", "lbm", "tonne"]),
    ("Time", &["s", "ms", "min", "hour"]),
    ("Angle", &["deg", "rad", "arcmin", "urad"]),
    ("Velocity", &["m/s", "mm/s", "inch/s"]),
    ("Acceleration", &["m/s^2", "mm/s^2", "inch/s^2"]),
    ("AngularVelocity", &["rpm", "rad/s", "deg/s"]),
    ("AngularAcceleration", &["rad/s^2", "deg/s^2"]),
    ("Frequency", &["Hz", "kHz"]),
    ("Force", &["N", "kN", "lbf"]),
    ("Moment", &["N*m", "N*mm", "kN*m", "lbf*inch", "lbf*ft"]),
    ("Pressure", &["MPa", "GPa", "psi", "ksi", "bar"]),
    ("Stiffness", &["N/mm", "N/um", "lbf/inch"]),
    ("RotationalStiffness", &["N*m/rad", "lbf*inch/rad"]),
    ("Density", &["kg/m^3", "g/cm^3", "lbm/inch^3"]),
    ("MomentOfInertia", &["kg*m^2", "kg*mm^2", "lbm*inch^2"]),
    ("Damping", &["N*s/m", "N*s/mm", "lbf*s/inch"]),
    ("Viscosity", &["Pa*s"]),
    ("KinematicViscosity", &["mm^2/s"]),
    ("Power", &["kW", "W", "hp"]),
    ("Temperature", &["K"]),
];

/// Returns the unit of a system for a dimension, followed by the other common units. For a pure
/// number this is only `%`.
pub fn usual(dimension: Dimension, system: UnitSystem) -> Vec<DisplayUnit> {
    let own = system.unit_of(dimension);
    let others = UnitSystem::ALL.map(|system| system.unit_of(dimension));
    let listed = USUAL.iter().find(|(name, _)| Dimension::from_name(name) == Some(dimension));
    let usual: Vec<DisplayUnit> = match listed {
        Some((_, names)) => names.iter().filter_map(|name| named(name)).collect(),
        None => others.to_vec(),
    };
    let mut found: Vec<DisplayUnit> = Vec::new();
    for unit in [own].into_iter().chain(usual) {
        if !unit.name.is_empty() && found.iter().all(|known| known.name != unit.name) {
            found.push(unit);
        }
    }
    found
}

/// Returns the unit in which outputs of a dimension are shown, if it is not that of the system:
/// watts for power in millimetres and newtons.
pub fn of_output(dimension: Dimension, system: UnitSystem) -> Option<DisplayUnit> {
    // A moment times an angular velocity has the dimension of power and of an angle.
    let is_power = |power: Dimension| power.without_angle() == dimension.without_angle();
    if Dimension::from_name("Power").is_some_and(is_power) && system == UnitSystem::MmNS {
        named("W")
    } else {
        None
    }
}

/// Returns the unit of a library function in a system of units: microinches in place of
/// micrometres in inches and pounds.
pub fn in_system(unit: DisplayUnit, system: UnitSystem) -> DisplayUnit {
    match (unit.name.as_str(), system) {
        ("um", UnitSystem::InchLbfS) => named("microinch").unwrap_or(unit),
        _ => unit,
    }
}

/// Returns the unit for a product of built-in units, such as `lbf*inch^2/s`.
pub fn named(product: &str) -> Option<DisplayUnit> {
    let mut found = pure();
    let mut above = true;
    let mut rest = product;
    loop {
        let end = rest.find(['*', '/']).unwrap_or(rest.len());
        let (name, exponent) = match rest[..end].trim().split_once('^') {
            Some((name, exponent)) => (name.trim(), exponent.trim().parse().ok()?),
            None => (rest[..end].trim(), 1),
        };
        if name != "1" {
            let unit = Unit::find(name)?;
            let dimension = unit.dimension.exponents();
            let unit = DisplayUnit { name: name.into(), factor: unit.factor, dimension };
            found = combined(&found, &powered(&unit, exponent)?, above)?;
        }
        let Some(operator) = rest[end..].chars().next() else { break };
        above = operator == '*';
        rest = &rest[end + 1..];
    }
    Some(DisplayUnit { name: product.into(), ..found })
}

/// Formats a number with a unit as written in a program: `3 mm`, `1000 lbf*inch`, `10 / inch`.
pub fn written(number: &str, unit: &str) -> String {
    match unit.strip_prefix("1/") {
        _ if unit.is_empty() => number.to_string(),
        Some(below) => format!("{number} / {below}"),
        None => format!("{number} {unit}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn usual_units_are_of_their_dimension() {
        for (name, units) in USUAL {
            let dimension = Dimension::from_name(name).expect(name);
            for unit in *units {
                let found = named(unit).unwrap_or_else(|| panic!("{unit}"));
                let found = Dimension::from_exponents(found.dimension).expect(unit);
                assert_eq!(found.without_angle(), dimension.without_angle(), "{unit} of {name}");
            }
        }
    }

    #[test]
    fn the_unit_of_the_system_comes_first() {
        let names = |dimension: &str, system| -> Vec<String> {
            let dimension = Dimension::from_name(dimension).expect(dimension);
            usual(dimension, system).into_iter().map(|unit| unit.name).collect()
        };
        assert_eq!(names("Length", UnitSystem::InchLbfS), ["inch", "mm", "m", "um", "mil"]);
        assert_eq!(names("Moment", UnitSystem::InchLbfS), ["lbf*inch", "N*m", "N*mm", "kN*m", "lbf*ft"]);
        assert_eq!(names("Compliance", UnitSystem::Si), ["m/N", "mm/N", "inch/lbf"]);
        assert_eq!(names("Number", UnitSystem::Si), ["%"]);
    }

    #[test]
    fn outputs_of_power_are_in_watts() {
        let of = |name: &str| Dimension::from_name(name).expect(name);
        let name = |dimension, system| of_output(dimension, system).map(|unit| unit.name);
        for power in [of("Power"), of("Moment").times(of("AngularVelocity"))] {
            assert_eq!(name(power, UnitSystem::MmNS).as_deref(), Some("W"));
            assert_eq!(name(power, UnitSystem::InchLbfS), None);
        }
        assert_eq!(name(of("Moment"), UnitSystem::MmNS), None);
    }

    #[test]
    fn quantities_are_written_as_programs_write_them() {
        assert_eq!(written("3", "mm"), "3 mm");
        assert_eq!(written("10", "1/inch"), "10 / inch");
        assert_eq!(written("2", ""), "2");
        let moment = named("lbf*ft").unwrap();
        assert!((moment.factor / 1.355_817_948_331_400_4 - 1.0).abs() < 1e-15);
        assert!(named("furlong").is_none());
    }
}
