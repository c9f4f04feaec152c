//! Tooth as a cantilever of varying thickness, after Weber and Banaschek (Formänderung und
//! Profilrücknahme bei gerad- und schrägverzahnten Rädern, 1953; Cornell, Compliance and Stress
//! Sensitivity of Spur Gear Teeth, J. Mech. Design 103, 1981): bending, shear and axial compression
//! of thin sections, each under the loads beyond it.
//!
//! A load acts on sections up to the point where its line of action crosses the centre line of the
//! tooth. The influence coefficient of two loads is the work of one in the strains of the other:
//! with `M = m - t q` the moment at the distance `t` from the root,
//! `integral of M M' / (E' I) + 6/5 q q' / (G h) + n n' / (E' h)`, up to the nearer of the two
//! crossings. This is symmetric, and a Gram matrix.

use calyx_fe::material::{Material, Plane};

/// Shear correction of a rectangular section (Cowper's limit for a section without lateral
/// contraction; Weber's 1.2).
pub(super) const SHEAR: f64 = 1.2;
/// Abscissa of the two-point Gauss rule on half an interval: exact for cubics.
pub(super) const GAUSS: f64 = 0.577_350_269_189_625_8;

/// Cantilever, given by its thickness along the centre line.
#[derive(Clone, Debug, PartialEq)]
pub struct Cantilever {
    stations: Vec<Station>,
    modulus: f64,
    shear_modulus: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Station {
    /// Distance from the root, m.
    at: f64,
    /// Half of the thickness there, m.
    half_depth: f64,
    /// Flexibility from the root up to there.
    up_to: Flexibility,
}

/// Integrals along a cantilever from its root, per unit of width: flexibility to moments, shear and
/// axial forces that act at least that far out.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Flexibility {
    /// Integrals of `t^k / (E' I)`, k from 0 to 2.
    pub(super) bending: [f64; 3],
    /// Integral of `6/5 / (G h)`.
    pub(super) shear: f64,
    /// Integral of `1 / (E' h)`.
    pub(super) axial: f64,
}

/// Resultants of a load at the root of a cantilever, per unit of width.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RootLoad {
    /// Force along the cantilever, outwards, N/m.
    pub axial: f64,
    /// Force across it, N/m.
    pub shear: f64,
    /// Moment about the root, positive with a positive shear farther out, N.
    pub moment: f64,
}

impl Flexibility {
    /// Returns the displacement along one load by another, both acting at least up to this point,
    /// m/(N/m). Exchanging the two gives the same bits.
    pub fn between(&self, one: &RootLoad, other: &RootLoad) -> f64 {
        let crossed = one.moment * other.shear + one.shear * other.moment;
        self.bending[0] * (one.moment * other.moment) - self.bending[1] * crossed
            + (self.bending[2] + self.shear) * (one.shear * other.shear)
            + self.axial * (one.axial * other.axial)
    }

    /// Returns the flexibility multiplied by a factor.
    pub(super) fn scaled(&self, factor: f64) -> Flexibility {
        Flexibility {
            bending: self.bending.map(|part| factor * part),
            shear: factor * self.shear,
            axial: factor * self.axial,
        }
    }

    /// Returns the sum of two flexibilities.
    pub(super) fn plus(&self, other: &Flexibility) -> Flexibility {
        Flexibility {
            bending: [0, 1, 2].map(|k: usize| self.bending[k] + other.bending[k]),
            shear: self.shear + other.shear,
            axial: self.axial + other.axial,
        }
    }
}

impl Cantilever {
    /// Builds a cantilever from distances from the root and half thicknesses there, m. Distances
    /// ascend from 0; the thickness is interpolated linearly. Other entries are ignored.
    pub fn new(depths: &[[f64; 2]], material: Material, plane: Plane) -> Cantilever {
        let modulus = material.surface_modulus(plane);
        let shear_modulus = 0.5 * material.youngs_modulus / (1.0 + material.poissons_ratio);
        let mut cantilever =
            Cantilever { stations: Vec::with_capacity(depths.len()), modulus, shear_modulus };
        for &[at, half_depth] in depths {
            let up_to = match cantilever.stations.last() {
                Some(last) if at <= last.at => continue,
                Some(_) => cantilever.added(cantilever.stations.len() - 1, at, half_depth),
                None => Flexibility::default(),
            };
            cantilever.stations.push(Station { at, half_depth, up_to });
        }
        cantilever
    }

    /// Returns the length, m.
    pub fn length(&self) -> f64 {
        self.stations.last().map_or(0.0, |last| last.at)
    }

    /// Returns the integrals up to a distance from the root, m; clamped to the length.
    pub fn up_to(&self, at: f64) -> Flexibility {
        let at = at.clamp(0.0, self.length());
        let next = self.stations.partition_point(|station| station.at <= at);
        match (next.checked_sub(1), self.stations.get(next)) {
            (Some(last), None) => self.stations[last].up_to,
            (Some(from), Some(to)) => {
                let start = &self.stations[from];
                let part = (at - start.at) / (to.at - start.at);
                self.added(from, at, start.half_depth + part * (to.half_depth - start.half_depth))
            }
            (None, _) => Flexibility::default(),
        }
    }

    /// Returns the memory, in bytes.
    pub fn bytes(&self) -> usize {
        size_of_val(self.stations.as_slice())
    }

    /// Returns the integrals up to a point behind a station, with the half thickness at that point.
    fn added(&self, from: usize, at: f64, half_depth: f64) -> Flexibility {
        let start = &self.stations[from];
        let mut sum = start.up_to;
        let weight = 0.5 * (at - start.at);
        for part in [0.5 - 0.5 * GAUSS, 0.5 + 0.5 * GAUSS] {
            let t = start.at + part * (at - start.at);
            let depth = 2.0 * (start.half_depth + part * (half_depth - start.half_depth));
            let bending = weight * 12.0 / (self.modulus * depth * depth * depth);
            sum.bending[0] += bending;
            sum.bending[1] += bending * t;
            sum.bending[2] += bending * t * t;
            sum.shear += weight * SHEAR / (self.shear_modulus * depth);
            sum.axial += weight / (self.modulus * depth);
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Timoshenko cantilever: the tip deflection under a tip force is
    /// `F L³ / (3 E I) + F L / (k G A)`, the tip deflection by a force at another point follows by
    /// Maxwell's theorem, and the axial displacement is `F L / (E A)`.
    #[test]
    fn of_even_depth_it_is_timoshenkos() {
        let steel = Material::STEEL;
        let (length, half) = (0.03, 0.004);
        let depths: Vec<[f64; 2]> = (0..=7).map(|k| [length * f64::from(k) / 7.0, half]).collect();
        let beam = Cantilever::new(&depths, steel, Plane::Stress);
        let (area, inertia) = (2.0 * half, (2.0 * half).powi(3) / 12.0);
        let [e, g] = [206e9, 206e9 / 2.6];
        let across = |at: f64| RootLoad { shear: 1.0, moment: at, ..RootLoad::default() };
        for near in [0.011, length] {
            let given = beam.up_to(near).between(&across(near), &across(length));
            let bent = near * near * (3.0 * length - near) / (6.0 * e * inertia);
            let expected = bent + 1.2 * near / (g * area);
            assert!((given - expected).abs() < 1e-14 * expected, "{given} {expected}");
            let back = beam.up_to(near).between(&across(length), &across(near));
            assert_eq!(given.to_bits(), back.to_bits());
        }
        let along = RootLoad { axial: 1.0, ..RootLoad::default() };
        let given = beam.up_to(length).between(&along, &along);
        assert!((given - length / (e * area)).abs() < 1e-14 * given);
        // In plane strain a plate bends and stretches less, and shears as much.
        let wide = Cantilever::new(&depths, steel, Plane::Strain).up_to(length);
        assert!((wide.between(&along, &along) / given - 0.91).abs() < 1e-14);
    }

    /// Wedge under a tip force, with a thickness proportional to the distance from the tip: without
    /// shear `integral x² 12 / (E h³)` with `h = H x / L` is `12 L³ / (E H³) ln(L / a)` for a tip
    /// cut off at `a`.
    #[test]
    fn a_wedge_bends_by_a_logarithm() {
        let material = Material { youngs_modulus: 1.0, poissons_ratio: 0.0, density: 0.0 };
        let (length, root, cut) = (1.0, 0.2, 0.25);
        let depth = |t: f64| 0.5 * root * (length - t) / length;
        let depths: Vec<[f64; 2]> =
            (0..=64).map(|k| (length - cut) * f64::from(k) / 64.0).map(|t| [t, depth(t)]).collect();
        let wedge = Cantilever::new(&depths, material, Plane::Stress);
        let force = RootLoad { shear: 1.0, moment: length, ..RootLoad::default() };
        let given = wedge.up_to(length).between(&force, &force);
        let logarithm = (length / cut).ln();
        let expected = 12.0 * (length / root).powi(3) * logarithm + 1.2 * 2.0 * length / root * logarithm;
        assert!((given / expected - 1.0).abs() < 1e-6, "{given} {expected}");
    }
}
