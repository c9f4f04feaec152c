//! Observables of vibrations about an equilibrium: natural frequencies and energy fractions of
//! modes.

use super::{Equilibrium, Observable, Quantity};
use calyx_model::ids::BodyId;
use calyx_model::observed::Observed;
use calyx_solve::vibrations::Vibrations;
use std::f64::consts::TAU;
use std::sync::Arc;

impl Equilibrium<'_> {
    /// Returns the free vibrations about the equilibrium, computed once per position; `None` if a
    /// DOF has no inertia or nothing vibrates.
    pub fn vibrations(self) -> Option<Arc<Vibrations>> {
        self.system.vibrations(self.step)
    }
}

/// Natural frequency of the scene about its equilibrium, Hz; number 0 is the lowest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NaturalFrequency(pub usize);

impl Observable for NaturalFrequency {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("natural_frequency", "Hz")
    }

    fn mode(&self) -> Option<usize> {
        Some(self.0)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let found = at.vibrations().and_then(|all| all.frequencies.get(self.0).copied());
        Observed::number(found.map_or(f64::NAN, |omega| omega / TAU))
    }
}

/// Fraction of a mode's kinetic energy in components of a body's motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ModeShare {
    /// Index of the mode, from the lowest frequency, from 0.
    pub mode: usize,
    /// Body whose motion counts.
    pub body: BodyId,
    /// Components of its frame that count, in the order of [`calyx_model::dof::DOF_NAMES`].
    pub components: [bool; 6],
    /// Includes the modes of a gear: vibrations relative to its frame. Component modes of shafts
    /// and housings belong to no frame.
    pub elastic: bool,
}

impl Observable for ModeShare {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("mode_share", "1")
    }

    fn mode(&self) -> Option<usize> {
        Some(self.mode)
    }

    fn frame_of(&self) -> Option<BodyId> {
        Some(self.body)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let Some(all) = at.vibrations().filter(|all| self.mode < all.frequencies.len()) else {
            return Observed::number(f64::NAN);
        };
        let energies = all.energies(self.mode);
        let dofs = &at.system.dofs;
        let own = dofs
            .iter()
            .zip(&energies)
            .filter(|(dof, _)| dof.body == self.body.0 && self.components[dof.component]);
        let rigid: f64 = own.map(|(_, energy)| energy).sum();
        let modal = at.system.modes.of_body(self.body.0).filter(|_| self.elastic);
        let elastic = modal
            .map_or(0.0, |(own, first)| energies[dofs.len() + first..].iter().take(own.count()).sum::<f64>());
        Observed::number(rigid + elastic)
    }
}
