//! Nominal stress in a fillet by form and stress correction factors: ISO 6336-3, method B, at the
//! section through the points where the tangents of the fillets make 30 degrees with the centre
//! line of the tooth (60 degrees for an internal gear).
//!
//! `Y_F = 6 h_F cos(alpha) / s_F²`, apart from the module and the cosine in its definition by
//! tangential forces, is bending by the transverse force at the height where its line of action
//! crosses the centre line. `Y_S = (1.2 + 0.13 L) q^(1 / (1.21 + 2.3 / L))` with `L = s_F / h_F`
//! and `q = s_F / (2 rho_F)` is empirical. Both depend on the point of load application.

use super::cantilever::RootLoad;

/// Range of `q` for which the stress correction was measured.
const NOTCHES: [f64; 2] = [1.0, 8.0];

/// Critical section of a tooth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CriticalSection {
    /// Distance from the root, m; the same root as for loads.
    pub at: f64,
    /// Chord s_F, m.
    pub chord: f64,
    /// Radius of the fillet there, m.
    pub notch_radius: f64,
    /// Arc length on the fillet, from the end of the flank, m.
    pub s: f64,
    /// Position in tooth coordinates, on the side of surface 0, m.
    pub position: [f64; 2],
}

impl CriticalSection {
    /// Returns the stress along the fillet on the side of positive or of negative coordinates
    /// across the tooth, Pa: `side` is their sign.
    pub fn stress(&self, load: &RootLoad, side: f64) -> f64 {
        let moment = load.moment - self.at * load.shear;
        // A force below the section does not bend it.
        if moment * load.shear <= 0.0 {
            return 0.0;
        }
        let arm = (moment / load.shear).abs();
        let slenderness = self.chord / arm;
        let notch = (0.5 * self.chord / self.notch_radius).clamp(NOTCHES[0], NOTCHES[1]);
        let correction = (1.2 + 0.13 * slenderness) * notch.powf((1.21 + 2.3 / slenderness).recip());
        -side * correction * 6.0 * moment / (self.chord * self.chord)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SECTION: CriticalSection =
        CriticalSection { at: 0.5e-3, chord: 4e-3, notch_radius: 0.8e-3, s: 0.0, position: [0.0; 2] };

    /// `L = 4 / 5`, `q = 2.5`: `Y_S = (1.2 + 0.104) 2.5^(1 / 4.085) = 1.6319`; nominal stress
    /// `6 F h / s² = 1.875e3 F`.
    #[test]
    fn the_factors_of_the_standard() {
        let load = RootLoad { axial: -0.3, shear: -1.0, moment: -5.5e-3 };
        let expected = 1.304 * 2.5f64.powf(1.0 / 4.085) * 6.0 * 5e-3 / 16e-6;
        assert!((SECTION.stress(&load, 1.0) / expected - 1.0).abs() < 1e-12);
        assert_eq!(SECTION.stress(&load, -1.0), -SECTION.stress(&load, 1.0));
        // At and below the section there is no bending.
        let low = RootLoad { moment: -0.4e-3, ..load };
        assert_eq!(SECTION.stress(&low, 1.0), 0.0);
    }
}
