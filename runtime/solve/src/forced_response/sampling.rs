//! Places of a common period at which a system is sampled, and the weights that give its Fourier
//! coefficients.

use nalgebra::{Complex, DMatrix};
use std::f64::consts::TAU;

/// Number of revolution phases of a carrier at which each phase of a mesh cycle is sampled: the
/// sidebands -2 to 2.
const TURNS: i64 = 5;

/// Places at which a system is sampled.
#[derive(Clone, Debug, PartialEq)]
pub enum Sampling {
    /// Equal distances over the common period.
    Uniform {
        /// Number of samples.
        count: usize,
    },
    /// Equal distances over one cycle of the only mesh, repeated in some of its cycles, which are
    /// spread over a revolution of the only carrier. The variation with the rotation of the carrier
    /// is thus separated exactly from that over the mesh cycle.
    Cycles {
        /// Number of samples in a cycle.
        count: usize,
        /// Numbers of the sampled cycles.
        cycles: Vec<i64>,
        /// Cycles of the mesh and revolutions of the carrier in the common period.
        of_period: [i64; 2],
        /// Inverse of the values of the sidebands -2 to 2, by sideband and sampled cycle.
        sidebands: DMatrix<Complex<f64>>,
    },
}

impl Sampling {
    /// Samples cycles of a mesh for some cycles of the mesh and revolutions of a carrier in the
    /// common period, with a number of samples in a cycle. `None` if too few cycles are in a
    /// revolution.
    pub(super) fn of_cycles(of_period: [i64; 2], count: usize) -> Option<Sampling> {
        let [mesh, carrier] = of_period;
        let cycles: Vec<i64> = (0..TURNS).map(|turn| turn * mesh / (TURNS * carrier)).collect();
        let value = |cycle: usize, sideband: usize| {
            let turned = (sideband as i64 - TURNS / 2) * carrier * cycles[cycle];
            Complex::from_polar(1.0, TAU * turned as f64 / mesh as f64)
        };
        let values = DMatrix::from_fn(cycles.len(), cycles.len(), value);
        // Cycles that coincide do not determine the sidebands.
        let sidebands = (mesh >= 2 * TURNS * carrier).then(|| values.try_inverse())??;
        Some(Sampling::Cycles { count, cycles, of_period, sidebands })
    }

    /// Returns the number of samples.
    pub fn count(&self) -> usize {
        match self {
            Sampling::Uniform { count } => *count,
            Sampling::Cycles { count, cycles, .. } => count * cycles.len(),
        }
    }

    /// Returns the place of a sample as a fraction of the common period.
    pub fn place(&self, sample: usize) -> f64 {
        match self {
            Sampling::Uniform { count } => sample as f64 / *count as f64,
            Sampling::Cycles { count, cycles, of_period, .. } => {
                let cycle = cycles[sample % cycles.len()] as f64;
                ((sample / cycles.len()) as f64 / *count as f64 + cycle) / of_period[0] as f64
            }
        }
    }

    /// Returns half the distance of two samples as a fraction of the common period.
    pub fn half_step(&self) -> f64 {
        match self {
            Sampling::Uniform { count } => 0.5 / *count as f64,
            Sampling::Cycles { count, of_period, .. } => 0.5 / (*count as f64 * of_period[0] as f64),
        }
    }

    /// Returns every second place, and the indices of its samples.
    pub fn every_second(&self) -> (Sampling, Vec<usize>) {
        match self {
            Sampling::Uniform { count } => {
                (Sampling::Uniform { count: count / 2 }, (0..*count).step_by(2).collect())
            }
            Sampling::Cycles { count, cycles, of_period, sidebands } => {
                let kept = (0..self.count()).filter(|sample| (sample / cycles.len()).is_multiple_of(2));
                let (cycles, sidebands) = (cycles.clone(), sidebands.clone());
                let coarse = Sampling::Cycles { count: count / 2, cycles, of_period: *of_period, sidebands };
                (coarse, kept.collect())
            }
        }
    }

    /// Returns the weights of all samples in the Fourier coefficient of an order.
    pub(super) fn weights(&self, order: i64) -> Vec<Complex<f64>> {
        match self {
            Sampling::Uniform { count } => {
                let order = order.rem_euclid((*count).max(1) as i64) as usize;
                let weight = |k: usize| {
                    let angle = -TAU * ((order * k) % count) as f64 / *count as f64;
                    Complex::new(angle.cos(), angle.sin()) / *count as f64
                };
                (0..*count).map(weight).collect()
            }
            Sampling::Cycles { count, cycles, of_period: [mesh, carrier], sidebands } => {
                let half = TURNS / 2;
                let belongs = |sideband: &i64| (order - sideband * carrier) % mesh == 0;
                let Some(sideband) = [0, -1, 1, -half, half].into_iter().find(belongs) else {
                    return vec![Complex::new(0.0, 0.0); self.count()];
                };
                let weight = |sample: usize| {
                    let phase = (sample / cycles.len()) as f64 / *count as f64;
                    let own = sidebands[((sideband + half) as usize, sample % cycles.len())];
                    own * Complex::from_polar(1.0, -TAU * order as f64 * phase / *mesh as f64) / *count as f64
                };
                (0..self.count()).map(weight).collect()
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the coefficient of samples of a function of the fraction of the period.
    fn coefficient(sampling: &Sampling, order: i64, value: impl Fn(f64) -> f64) -> Complex<f64> {
        let weights = sampling.weights(order);
        weights.iter().enumerate().map(|(k, weight)| weight * value(sampling.place(k))).sum()
    }

    /// A wave of a high harmonic does not reach the sidebands of others, and those of every second
    /// sample agree.
    #[test]
    fn cycles_separate_sidebands_of_all_harmonics() {
        let sampling = Sampling::of_cycles([71, 1], 24).expect("enough cycles");
        let wave = |place: f64| {
            let [mesh, turn] = [71.0, 1.0].map(|cycles: f64| TAU * cycles * place);
            0.3 + (3.0 * mesh + turn).cos() + 0.5 * (mesh - 2.0 * turn).sin() + (24.0 * mesh).cos()
        };
        for sampling in [sampling.clone(), sampling.every_second().0] {
            for (order, expected) in [
                (0, Complex::new(1.3, 0.0)),
                (1, Complex::new(0.0, 0.0)),
                (3 * 71 + 1, Complex::new(0.5, 0.0)),
                (3 * 71 - 1, Complex::new(0.0, 0.0)),
                (71 - 2, Complex::new(0.0, -0.25)),
                (2 * 71, Complex::new(0.0, 0.0)),
            ] {
                let found = coefficient(&sampling, order, wave);
                assert!((found - expected).norm() < 1e-13, "{order}: {found} {expected}");
            }
        }
        assert!(Sampling::of_cycles([8, 1], 24).is_none());
    }

    #[test]
    fn every_second_sample_is_where_it_was() {
        for sampling in
            [Sampling::Uniform { count: 12 }, Sampling::of_cycles([99, 2], 12).expect("enough cycles")]
        {
            let (coarse, kept) = sampling.every_second();
            assert_eq!(kept.len(), coarse.count());
            for (index, sample) in kept.into_iter().enumerate() {
                assert!((coarse.place(index) - sampling.place(sample)).abs() < 1e-15);
            }
            let step = sampling.place(sampling.count() / 12) - sampling.place(0);
            assert!((step - 2.0 * sampling.half_step()).abs() < 1e-15);
        }
    }
}
