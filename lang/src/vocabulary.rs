//! Dimensions and units that a program declares, and the display of quantities with them.

use crate::dimension::{Base, Dimension, Rational, product_of};
use crate::ir::DisplayUnit;
use crate::units::UnitSystem;
use calyx_abi::description::Exponents;

/// The `dimension` and `unit` declarations of a program.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Vocabulary {
    /// New base dimensions, in order of their exponents.
    pub bases: Vec<OwnBase>,
    /// Names for products of dimensions.
    pub named: Vec<(String, Dimension)>,
    pub units: Vec<DisplayUnit>,
}

/// A new base dimension.
#[derive(Clone, Debug, PartialEq)]
pub struct OwnBase {
    pub name: String,
    /// The unit in which its numbers are stored and displayed, once declared.
    pub unit: Option<String>,
}

impl Vocabulary {
    /// Returns every dimension that the program declares, by name: new base dimensions, then names
    /// for products.
    pub fn own_dimensions(&self) -> Vec<(String, Exponents)> {
        let bases = self.bases.iter().enumerate();
        let bases = bases.filter_map(|(at, base)| Some((base.name.clone(), Dimension::own(at)?.exponents())));
        bases.chain(self.named.iter().map(|(name, named)| (name.clone(), named.exponents()))).collect()
    }

    /// Returns the name of a dimension, if it has one.
    pub fn name_of(&self, dimension: Dimension) -> Option<&str> {
        let base = || {
            let own = (0..self.bases.len()).find(|&at| Dimension::own(at) == Some(dimension));
            own.map(|at| self.bases[at].name.as_str())
        };
        let named =
            || self.named.iter().find(|(_, known)| *known == dimension).map(|(name, _)| name.as_str());
        dimension.known_name().or_else(base).or_else(named)
    }

    /// Returns the name of a dimension, or its factors.
    pub fn show(&self, dimension: Dimension) -> String {
        self.name_of(dimension).map_or_else(|| self.in_bases(dimension), str::to_string)
    }

    /// Returns the product of powers of base dimensions; `1` for a pure number.
    pub fn in_bases(&self, dimension: Dimension) -> String {
        let physics = Base::ALL.map(|base| (base.name(), dimension.exponent(base)));
        let own = self.bases.iter().map(|base| base.name.as_str()).zip(dimension.own_exponents());
        product_of(&physics.into_iter().chain(own).collect::<Vec<_>>())
    }

    /// Returns the unit of a system for a dimension, including the program's units for its own
    /// dimensions.
    pub fn unit_of(&self, system: UnitSystem, dimension: Dimension) -> DisplayUnit {
        let own: Vec<(&str, Rational)> = self
            .bases
            .iter()
            .map(|base| base.unit.as_deref().unwrap_or(&base.name))
            .zip(dimension.own_exponents())
            .filter(|(_, exponent)| !exponent.is_zero())
            .collect();
        let physics = system.unit_of(dimension.without_own());
        if own.is_empty() {
            return physics;
        }
        // The physical units follow the program's own units in the numerator and in the
        // denominator.
        let own = product_of(&own);
        let name = match physics.name.as_str() {
            "" => own,
            below if below.starts_with("1/") => format!("{own}{}", &below[1..]),
            above => match own.strip_prefix("1/") {
                Some(below) => format!("{above}/{below}"),
                None => format!("{own}*{above}"),
            },
        };
        DisplayUnit { name, dimension: dimension.exponents(), ..physics }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn own_dimensions_show_beside_those_of_physics() {
        let base = |name: &str, unit: &str| OwnBase { name: name.into(), unit: Some(unit.into()) };
        let cost = Dimension::own(0).unwrap();
        let time = Dimension::of(Base::Time);
        let vocabulary = Vocabulary {
            bases: vec![base("Cost", "euro"), base("Data", "bit")],
            named: vec![("Wage".into(), cost.over(time))],
            units: Vec::new(),
        };
        let data = Dimension::own(1).unwrap();
        for (dimension, name, unit) in [
            (cost, "Cost", "euro"),
            (cost.over(time), "Wage", "euro/s"),
            (cost.times(time), "Time*Cost", "euro*s"),
            (data.over(cost), "Data/Cost", "bit/euro"),
            (time.over(cost), "Time/Cost", "s/euro"),
            (Dimension::NONE.over(cost.times(time)), "1/Time/Cost", "1/euro/s"),
        ] {
            assert_eq!(vocabulary.show(dimension), name);
            assert_eq!(vocabulary.unit_of(UnitSystem::Si, dimension).name, unit);
        }
        assert_eq!(Dimension::own(3), None);
    }
}
