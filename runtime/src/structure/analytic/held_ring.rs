//! What carries a tooth: a ring that is held rigidly on its far side, loaded on an arc of the other by what a tooth passes on at its root.
//!
//! Sainsot, Velex and Duverger (Contribution of Gear Body to Tooth Deflections, J. Mech. Design 126, 2004) take the same ring under the
//! same tractions, evenly spread ones for the two forces and a linear one for the moment, and print polynomials for a range of rings. Here it is
//! solved for each ring: in a Fourier series around, of which each wave is a combination of four powers of the radius (Navier's equations; Michell's
//! solution). Displacements are the means that do the tractions' work, so the answer is symmetric, and what
//! teeth do to each other through the ring comes with it. Forces along the face, which helical teeth have, shear it apart from all else (Laplace's
//! equation).

use super::cantilever::RootLoad;
use crate::material::{Material, Plane};
use nalgebra::{Matrix4, Vector4};
use std::f64::consts::{PI, TAU};

/// Waves are summed up to where so many radians pass over half of the arc: what is left out of a force's own compliance is some 3e-4 of it.
const PHASE: f64 = 30.0;
/// The far side of a ring does not matter to waves that decay to this part of themselves on the way there and back.
const UNFELT: f64 = 1e-16;

/// Answers of a ring to [`RootLoad`]s on its teeth.
#[derive(Clone, Debug, PartialEq)]
pub struct HeldRing {
    /// By how far a tooth is ahead of another: displacements (axial, across, turn) of its root by unit loads on that one's, per unit of width.
    between: Vec<[[f64; 3]; 3]>,
    /// The same along the face.
    along: Vec<f64>,
    sectors: u32,
}

/// Teeth too far apart to feel each other.
const UNCOUPLED: [[f64; 3]; 3] = [[0.0; 3]; 3];

/// Answers of a ring between two of its teeth.
#[derive(Clone, Copy, Debug)]
pub struct Link<'a> {
    between: &'a [[f64; 3]; 3],
    along: f64,
    order: Order,
}

/// Where the other tooth is.
#[derive(Clone, Copy, Debug)]
enum Order {
    Same,
    Ahead,
    Behind,
}

impl Link<'_> {
    /// What a load at the root of the one tooth does along another at the root of the other, m/(N/m). The same with the two and their teeth
    /// exchanged, bit for bit.
    pub fn compliance(&self, one: &RootLoad, other: &RootLoad) -> f64 {
        let along = self.along * (one.along * other.along);
        let parts = |load: &RootLoad| [load.axial, load.shear, load.moment];
        let (first, second) = match self.order {
            Order::Same => {
                let own = self.between;
                let crossed = one.shear * other.moment + one.moment * other.shear;
                return own[0][0] * (one.axial * other.axial)
                    + own[1][1] * (one.shear * other.shear)
                    + own[2][2] * (one.moment * other.moment)
                    + own[1][2] * crossed
                    + along;
            }
            Order::Ahead => (parts(one), parts(other)),
            Order::Behind => (parts(other), parts(one)),
        };
        let of = |row: usize| -> f64 { (0..3).map(|column| self.between[row][column] * first[column]).sum() };
        (0..3).map(|row| second[row] * of(row)).sum::<f64>() + along
    }
}

/// Sizes of a ring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RingShape {
    /// Of its loaded side, m.
    pub radius: f64,
    /// Of the side that is held, m: smaller, or larger inside of which teeth point inwards.
    pub held_radius: f64,
    /// Half of the arc on which a tooth stands, rad.
    pub half_arc: f64,
    /// Number of teeth.
    pub sectors: u32,
}

impl RingShape {
    /// Where the moment of a root load is counted about, m from the axis: the centre of the arc as forces across see it.
    pub fn root(&self) -> f64 {
        self.radius * self.half_arc.sin() / self.half_arc
    }
}

impl HeldRing {
    /// `coupled` is how far apart teeth feel each other.
    pub fn new(shape: &RingShape, coupled: u32, material: Material, plane: Plane) -> HeldRing {
        let RingShape { radius, held_radius, half_arc, sectors } = *shape;
        let waves = Waves::new(held_radius / radius, material, plane);
        // Teeth that point inwards see axial forces and moments the other way round.
        let sense = if held_radius > radius { -1.0 } else { 1.0 };
        let coupled = coupled.min(sectors / 2);
        let mut between = vec![[[0.0; 3]; 3]; coupled as usize + 1];
        let mut along = vec![0.0; coupled as usize + 1];
        let shear_modulus = 0.5 * material.youngs_modulus / (1.0 + material.poissons_ratio);
        let last = (PHASE / half_arc).ceil() as u32;
        for n in 0..=last {
            let around = f64::from(n);
            let loads = tractions(around, half_arc);
            let answer = waves.answer(around);
            let mut work = [[0.0; 3]; 3];
            for (one, row) in loads.iter().zip(&mut work) {
                for (other, entry) in loads.iter().zip(row) {
                    let moved = [0, 1].map(|k: usize| answer[k][0] * other[0] + answer[k][1] * other[1]);
                    *entry = if n == 0 { TAU } else { PI } * (one[0] * moved[0] + one[1] * moved[1]);
                }
            }
            let sheared = along_the_face(around, half_arc, held_radius / radius) / shear_modulus;
            for (apart, (sum, along)) in between.iter_mut().zip(&mut along).enumerate() {
                let (sine, cosine) = (TAU * around * apart as f64 / f64::from(sectors)).sin_cos();
                *along += cosine * sheared;
                for (i, row) in sum.iter_mut().enumerate() {
                    for (j, entry) in row.iter_mut().enumerate() {
                        // An axial force is even about its tooth, the others are odd.
                        let phase = match (i == 0, j == 0) {
                            (true, false) => sine,
                            (false, true) => -sine,
                            _ => cosine,
                        };
                        *entry += phase * work[i][j];
                    }
                }
            }
        }
        // Tractions were those of unit loads on a ring of unit radius: a moment acts by its lever.
        let lever = [sense, 1.0, sense / radius];
        for entries in &mut between {
            for (i, row) in entries.iter_mut().enumerate() {
                for (j, entry) in row.iter_mut().enumerate() {
                    *entry *= lever[i] * lever[j];
                }
            }
        }
        HeldRing { between, along, sectors }
    }

    /// How the root of one tooth feels loads on the root of another one, which may be the same.
    pub fn link(&self, one_tooth: u32, other_tooth: u32) -> Link<'_> {
        let ahead = (other_tooth + self.sectors - one_tooth % self.sectors) % self.sectors;
        let behind = self.sectors - ahead;
        let apart = ahead.min(behind) as usize;
        let order = match ahead {
            0 => Order::Same,
            // Of two teeth opposite each other either may be ahead: the one with the smaller number is not.
            _ if behind < ahead || (behind == ahead && other_tooth < one_tooth) => Order::Behind,
            _ => Order::Ahead,
        };
        let (between, along) = match (self.between.get(apart), self.along.get(apart)) {
            (Some(between), Some(&along)) => (between, along),
            _ => (&UNCOUPLED, 0.0),
        };
        Link { between, along, order }
    }

    /// Memory that it takes, in bytes.
    pub fn bytes(&self) -> usize {
        size_of_val(self.between.as_slice()) + size_of_val(self.along.as_slice())
    }
}

/// Fourier coefficients of the tractions of a unit axial force, force across and moment on an arc of a ring of unit radius, at a wave number:
/// radial ones and those around, each as it goes with a radial displacement `cos` and one around `sin` (axial), or `sin` and `-cos`.
///
/// The two forces are spread evenly along the arc; the moment, about [`RingShape::root`], is a force along the tooth in proportion to the angle.
fn tractions(n: f64, half: f64) -> [[f64; 2]; 3] {
    // Integrals over the arc of cos(k x) and of x sin(k x).
    let even = |k: f64| if k == 0.0 { 2.0 * half } else { 2.0 * (k * half).sin() / k };
    let odd = |k: f64| {
        let phase = k * half;
        // Where the two terms are nearly equal their series is exact enough.
        if phase.abs() < 1e-2 {
            2.0 * k * half.powi(3) * (1.0 / 3.0 - phase * phase / 30.0 + phase.powi(4) / 840.0)
        } else {
            2.0 * (phase.sin() - phase * phase.cos()) / (k * k)
        }
    };
    let norm = if n == 0.0 { TAU.recip() } else { PI.recip() };
    let evenly = norm / (2.0 * half);
    let [below, above] = [n - 1.0, n + 1.0];
    let with = 0.5 * evenly * (even(below) + even(above));
    let against = 0.5 * evenly * (even(below) - even(above));
    let slope = -norm / odd(1.0);
    let turning = 0.5 * slope * (odd(above) + odd(below));
    let leaning = 0.5 * slope * (odd(above) - odd(below));
    [[with, -against], [against, -with], [turning, leaning]]
}

/// What of a unit force along the face, spread evenly on an arc of a ring of unit radius that is held at another one, a wave number adds to its own
/// displacement, by the shear modulus: evenly around `t ln(1 / held)`, and else `t tanh(n ln(1 / held)) / n` under a traction `t`.
fn along_the_face(n: f64, half: f64, held: f64) -> f64 {
    let thickness = held.ln().abs();
    if n == 0.0 {
        return thickness / TAU;
    }
    let traction = (n * half).sin() / (PI * n * half);
    PI * traction * traction * (n * thickness).tanh() / n
}

/// Waves around a ring of unit radius that is held at another one.
struct Waves {
    held: f64,
    /// Lamé's constants; the first one as the plane has it.
    lambda: f64,
    mu: f64,
}

/// A displacement `U cos(n phi)` outwards and `V sin(n phi)` around, with its derivatives by the radius.
#[derive(Clone, Copy)]
struct Wave {
    out: [f64; 2],
    around: [f64; 2],
}

impl Waves {
    fn new(held: f64, material: Material, plane: Plane) -> Waves {
        let Material { youngs_modulus: e, poissons_ratio: nu, .. } = material;
        let mu = 0.5 * e / (1.0 + nu);
        let lambda = match plane {
            Plane::Strain => e * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)),
            Plane::Stress => e * nu / (1.0 - nu * nu),
        };
        Waves { held, lambda, mu }
    }

    /// The solutions of Navier's equations for a wave number at a radius: two that grow outwards, then two that decay, each about 1 at the end of
    /// the ring where it is largest.
    fn solutions(&self, n: f64, radius: f64) -> [Wave; 4] {
        let (inner, outer) = (self.held.min(1.0), self.held.max(1.0));
        let stiffness = (self.lambda + 2.0 * self.mu) / self.mu;
        let power = |exponent: f64, out: f64, around: f64| {
            let unit = if exponent >= 0.0 { outer } else { inner };
            let value = (radius / unit).powf(exponent);
            let slope = exponent * value / radius;
            Wave { out: [out * value, out * slope], around: [around * value, around * slope] }
        };
        if n == 0.0 {
            return [
                power(1.0, 1.0, 0.0),
                power(1.0, 0.0, 1.0),
                power(-1.0, 1.0, 0.0),
                power(-1.0, 0.0, 1.0),
            ];
        }
        let growing = {
            let of = 4.0 * (n + 1.0);
            power(n + 1.0, (n + 2.0 - n * stiffness) / of, ((n + 2.0) * stiffness - n) / of)
        };
        let decaying = if n == 1.0 {
            let (log, rate) = ((radius / outer).ln(), 0.5 * (1.0 + stiffness));
            let (value, slope) = (rate * log, rate / radius);
            Wave { out: [value + 0.5 * (1.0 - stiffness), slope], around: [-value, -slope] }
        } else {
            let of = 4.0 * (1.0 - n);
            power(1.0 - n, (2.0 - n + n * stiffness) / of, ((n - 2.0) * stiffness - n) / of)
        };
        [power(n - 1.0, 1.0, -1.0), growing, power(-n - 1.0, 1.0, 1.0), decaying]
    }

    /// Stresses of a wave across a circle: `cos` outwards, `sin` around.
    fn stress(&self, n: f64, radius: f64, wave: &Wave) -> [f64; 2] {
        let ([out, out_rate], [around, around_rate]) = (wave.out, wave.around);
        let dilatation = out_rate + (out + n * around) / radius;
        [
            self.lambda * dilatation + 2.0 * self.mu * out_rate,
            self.mu * (around_rate - (around + n * out) / radius),
        ]
    }

    /// Displacements of the loaded side by unit tractions on it, outwards and around; symmetric.
    fn answer(&self, n: f64) -> [[f64; 2]; 2] {
        // Seen from the material, a ring around teeth ends inwards.
        let outward = if self.held < 1.0 { 1.0 } else { -1.0 };
        let solutions = self.solutions(n, 1.0);
        let unfelt = self.held.min(1.0 / self.held).powf(2.0 * (n - 1.0)) < UNFELT;
        let used: &[usize] = match (unfelt, outward > 0.0) {
            (false, _) => &[0, 1, 2, 3],
            (true, true) => &[0, 1],
            (true, false) => &[2, 3],
        };
        let at_hold = self.solutions(n, self.held);
        // What is not used stands on its own, at nought.
        let mut rows = Matrix4::<f64>::identity();
        for (column, &number) in used.iter().enumerate() {
            let stress = self.stress(n, 1.0, &solutions[number]);
            let held = [at_hold[number].out[0], at_hold[number].around[0]];
            rows[(0, column)] = outward * stress[0] / self.mu;
            rows[(1, column)] = outward * stress[1] / self.mu;
            if !unfelt {
                rows[(2, column)] = held[0];
                rows[(3, column)] = held[1];
            }
        }
        let rows = rows.lu();
        let moved = |traction: usize| {
            let mut right = Vector4::zeros();
            right[traction] = self.mu.recip();
            // Held on one side, it has one position under any load.
            let parts = rows.solve(&right).unwrap_or_else(|| Vector4::from_element(f64::NAN));
            let total = |of: fn(&Wave) -> f64| -> f64 {
                used.iter().zip(parts.iter()).map(|(&number, part)| part * of(&solutions[number])).sum()
            };
            [total(|wave| wave.out[0]), total(|wave| wave.around[0])]
        };
        let [by_out, by_around] = [moved(0), moved(1)];
        // Equal by Betti's theorem, but for rounding.
        let crossed = by_out[1];
        [[by_out[0], crossed], [crossed, by_around[1]]]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn compliance(ring: &HeldRing, one: (u32, &RootLoad), other: (u32, &RootLoad)) -> f64 {
        ring.link(one.0, other.0).compliance(one.1, other.1)
    }

    const FORCES: [RootLoad; 3] = [
        RootLoad { axial: 1.0, shear: 0.0, moment: 0.0, along: 0.0 },
        RootLoad { axial: 0.0, shear: 1.0, moment: 0.0, along: 0.0 },
        RootLoad { axial: 0.0, shear: 0.0, moment: 1.0, along: 0.0 },
    ];
    /// Of E = 1, so that compliances are numbers.
    const UNIT: Material = Material { youngs_modulus: 1.0, poissons_ratio: 0.3, density: 0.0 };

    fn ring(held: f64, half_arc: f64, coupled: u32) -> HeldRing {
        let shape = RingShape { radius: 1.0, held_radius: held, half_arc, sectors: 24 };
        HeldRing::new(&shape, coupled, UNIT, Plane::Strain)
    }

    /// Compliances times E' of axial force, force across and moment (times the square of the arc), and of force with moment (times the arc).
    fn own(held: f64, half_arc: f64) -> [f64; 4] {
        let (ring, modulus, arc) = (ring(held, half_arc, 0), 1.0 / 0.91, 2.0 * half_arc);
        let of =
            |one: usize, other: usize| modulus * compliance(&ring, (0, &FORCES[one]), (0, &FORCES[other]));
        [of(0, 0), of(1, 1), arc * arc * of(2, 2), arc * of(1, 2)]
    }

    /// Pushed along the face by teeth that stand all around it, a ring shears evenly: by a logarithm.
    #[test]
    fn all_around_a_ring_shears_by_a_logarithm() {
        let push = RootLoad { along: 1.0, ..RootLoad::default() };
        for held in [0.6, 1.7f64] {
            let ring = ring(held, PI / 24.0, 12);
            let sum: f64 = (0..24).map(|tooth| compliance(&ring, (3, &push), (tooth, &push))).sum();
            let exact = 24.0 / TAU * held.ln().abs() * 2.6;
            assert!((sum / exact - 1.0).abs() < 1e-9, "{sum} {exact}");
            let [there, back] =
                [(1, 9), (9, 1)].map(|(one, other)| compliance(&ring, (one, &push), (other, &push)));
            assert_eq!(there.to_bits(), back.to_bits());
        }
    }

    /// On an arc that is short against everything else the ring is a half-plane. Under `12 M x / a³` it is displaced by
    /// `-2 / (pi E') integral of p ln|x - y|`; the work of that is `18 / (pi E') (M / a)²`.
    #[test]
    fn a_short_arc_turns_as_on_a_half_plane() {
        let [.., turn, _] = own(0.5, 0.002);
        let exact = 18.0 / PI;
        assert!((turn / exact - 1.0).abs() < 4e-3, "{turn} {exact}");
        // Teeth inwards are no different there.
        let [.., inwards, _] = own(2.0, 0.002);
        assert!((inwards / exact - 1.0).abs() < 4e-3, "{inwards} {exact}");
        // And the two axial forces, which see the ring as a whole, differ by a logarithm of the arc: 2 / pi for a factor e.
        let difference = own(0.5, 0.002)[0] - own(0.5, 0.004)[0];
        assert!((difference / (2.0 / PI * 2.0f64.ln()) - 1.0).abs() < 2e-2, "{difference}");
    }

    /// Sainsot, Velex and Duverger (2004), table 1: coefficients A to F of `A / theta² + B h² + C h / theta + D / theta + E h + F`, for
    /// M*, P* and Q*. Their means over the arc are those of displacements, not of work, from which they differ by up to an eighth for
    /// forces. Their L* is that of another turn, 6.9 where work has 5.7 and O'Donnell's and Cornell's fixed teeth 5.3.
    #[test]
    fn forces_move_it_as_published() {
        const PUBLISHED: [[f64; 6]; 3] = [
            [60.111e-5, 28.100e-3, -83.431e-4, -9.9256e-3, 0.1624, 0.9086],
            [-50.952e-5, 185.50e-3, 0.0538e-4, 53.300e-3, 0.2895, 0.9236],
            [-6.2042e-5, 9.0889e-3, -4.0964e-4, 7.8297e-3, -0.1472, 0.6904],
        ];
        for ratio in [1.5, 2.0] {
            for half_arc in [0.03, 0.06, 0.09] {
                let [m, p, q] = PUBLISHED.map(|[a, b, c, d, e, f]| {
                    a / (half_arc * half_arc)
                        + b * ratio * ratio
                        + c * ratio / half_arc
                        + d / half_arc
                        + e * ratio
                        + f
                });
                let [axial, shear, turn, crossed] = own(1.0 / ratio, half_arc);
                for (what, given, published) in
                    [("P*", shear, p), ("M*", 2.0 * crossed, m), ("P* Q*", axial, p * q)]
                {
                    assert!(
                        (given / published - 1.0).abs() < 0.2,
                        "{what}: {given} {published} at {ratio}, {half_arc}"
                    );
                }
                assert!((5.3..5.8).contains(&turn), "{turn}");
            }
        }
    }

    /// A ring so thin that it is a layer on a rigid body is loaded along its arc alone: pressed together by `t / M` a traction, M being the
    /// modulus without lateral strain, and sheared by `t / G`.
    #[test]
    fn a_thin_layer_gives_under_its_load_alone() {
        let (half_arc, thickness) = (0.12, 1e-3);
        let [axial, shear, ..] = own(1.0 - thickness, half_arc);
        let (modulus, constrained, g) = (1.0 / 0.91, 0.7 / (1.3 * 0.4), 0.5 / 1.3);
        let layer = |stiffness: f64| modulus * thickness / (2.0 * half_arc * stiffness);
        assert!((axial / layer(constrained) - 1.0).abs() < 0.02, "{axial}");
        assert!((shear / layer(g) - 1.0).abs() < 0.02, "{shear}");
    }

    /// What one tooth does to another is what that does to it, and to the one on its other side the mirror image; less and less.
    #[test]
    fn teeth_feel_each_other_alike() {
        let ring = ring(0.6, 0.08, 12);
        for (i, one) in FORCES.iter().enumerate() {
            for (j, other) in FORCES.iter().enumerate() {
                for apart in 0..24 {
                    let given = compliance(&ring, (3, one), ((3 + apart) % 24, other));
                    let back = compliance(&ring, ((3 + apart) % 24, other), (3, one));
                    assert_eq!(given.to_bits(), back.to_bits(), "{i} {j} {apart}");
                    let mirrored = compliance(&ring, ((3 + apart) % 24, one), (3, other));
                    // The mirror image turns forces across and moments round.
                    let sign = if (i == 0) == (j == 0) { 1.0 } else { -1.0 };
                    assert!((given - sign * mirrored).abs() < 1e-13, "{i} {j} {apart}");
                }
            }
        }
        // What is ahead of a push is raised, and far ones hardly feel it.
        assert!(compliance(&ring, (0, &FORCES[1]), (1, &FORCES[0])) > 0.0);
        let across = |apart: u32| compliance(&ring, (0, &FORCES[1]), (apart, &FORCES[1]));
        // A force across turns the whole ring in its hold, which all teeth feel alike.
        assert!(
            [1, 2, 4, 8].windows(2).all(|pair| across(pair[1]) < across(pair[0])) && across(1) < across(0)
        );
    }

    /// The whole table is positive definite: no loads on any teeth gain work.
    #[test]
    fn no_loads_gain_work() {
        let ring = ring(0.55, 0.1, 12);
        let loads: Vec<(u32, RootLoad)> =
            (0..24).flat_map(|tooth| FORCES.map(|load| (tooth, load))).collect();
        let matrix = nalgebra::DMatrix::from_fn(72, 72, |i, j| {
            compliance(&ring, (loads[i].0, &loads[i].1), (loads[j].0, &loads[j].1))
        });
        assert!(matrix.cholesky().is_some());
    }
}
