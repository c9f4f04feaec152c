//! Consistent systems of units, and the conversion of a model to SI.

use crate::model::{Component, Constraint, ElasticModel, ElementKind};

/// Consistent system of units of a model: its units of length, force and time in SI. The unit of
/// mass follows: force times time squared over length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Units {
    /// Unit of length, m.
    pub length: f64,
    /// Unit of force, N.
    pub force: f64,
    /// Unit of time, s.
    pub time: f64,
}

/// International inch, m.
const INCH: f64 = 0.0254;
/// Pound-force, N.
const POUND_FORCE: f64 = 4.448_221_615_260_5;

impl Units {
    /// Newton, metre, second; masses in kilograms.
    pub const N_M_S: Self = Self { length: 1.0, force: 1.0, time: 1.0 };
    /// Newton, millimetre, second; masses in tonnes.
    pub const N_MM_S: Self = Self { length: 1e-3, force: 1.0, time: 1.0 };
    /// Pound-force, inch, second; masses in lbf s²/in.
    pub const LBF_IN_S: Self = Self { length: INCH, force: POUND_FORCE, time: 1.0 };
    /// Pound-force, foot, second; masses in slugs.
    pub const LBF_FT_S: Self = Self { length: 12.0 * INCH, force: POUND_FORCE, time: 1.0 };

    /// Names of the systems that [`Units::named`] accepts.
    pub const NAMES: [&'static str; 4] = ["N-m-s", "N-mm-s", "lbf-in-s", "lbf-ft-s"];

    /// Returns the system with this name, such as "N-mm-s".
    pub fn named(name: &str) -> Option<Self> {
        let systems = [Self::N_M_S, Self::N_MM_S, Self::LBF_IN_S, Self::LBF_FT_S];
        Self::NAMES.iter().position(|known| *known == name).map(|at| systems[at])
    }

    /// Returns the unit of mass, kg.
    pub fn mass(&self) -> f64 {
        self.force * self.time * self.time / self.length
    }

    /// Returns true if all units are positive and finite.
    pub fn is_valid(&self) -> bool {
        [self.length, self.force, self.time, self.mass()].iter().all(|unit| unit.is_finite() && *unit > 0.0)
    }
}

/// Unit of a component of motion: the length for translations, 1 for rotations.
fn motion(component: Component, length: f64) -> f64 {
    if component < 3 { length } else { 1.0 }
}

/// Converts a model to SI. Its masses are also multiplied by `mass_factor`.
pub(super) fn to_si(model: &mut ElasticModel, units: &Units, mass_factor: f64) {
    let Units { length, force, .. } = *units;
    let mass = units.mass() * mass_factor;
    let pressure = force / (length * length);
    let area = length * length;
    for node in &mut model.nodes {
        node.position = node.position.map(|x| x * length);
    }
    for material in &mut model.materials {
        material.youngs_modulus *= pressure;
        material.shear_modulus *= pressure;
        material.density *= mass / (area * length);
    }
    for element in &mut model.elements {
        match &mut element.kind {
            ElementKind::Solid(_) => {}
            ElementKind::Shell { thickness, offset, added_mass, .. } => {
                thickness.iter_mut().for_each(|value| *value *= length);
                *offset *= length;
                *added_mass *= mass / area;
            }
            ElementKind::Beam(beam) => {
                for section in &mut beam.sections {
                    section.area *= area;
                    section.second_moment_z *= area * area;
                    section.second_moment_y *= area * area;
                    section.product_of_inertia *= area * area;
                    section.torsion_constant *= area * area;
                    section.added_mass *= mass / length;
                }
                beam.offsets.iter_mut().flatten().for_each(|value| *value *= length);
            }
            ElementKind::Rod { area: section, torsion_constant, added_mass } => {
                *section *= area;
                *torsion_constant *= area * area;
                *added_mass *= mass / length;
            }
            ElementKind::Spring { components, stiffness } => {
                *stiffness *= if components[0] < 3 { force / length } else { force * length };
            }
            ElementKind::Mass { mass: value, offset, inertia } => {
                *value *= mass;
                offset.iter_mut().for_each(|x| *x *= length);
                inertia.iter_mut().flatten().for_each(|x| *x *= mass * area);
            }
        }
    }
    for constraint in &mut model.constraints {
        if let Constraint::Equation { terms, .. } = constraint {
            // The equation of the source is in its units of length, and is multiplied by them.
            terms
                .iter_mut()
                .for_each(|(_, component, factor)| *factor *= length / motion(*component, length));
        }
    }
    for fixed in &mut model.fixed {
        if fixed.components[..3].contains(&true) {
            fixed.value *= length;
        }
    }
    for load in &mut model.loads {
        for (component, value) in load.load.iter_mut().enumerate() {
            *value *= force * length / motion(component, length);
        }
    }
}
