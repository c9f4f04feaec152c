//! Load factors of ISO 6336-1 from the contact solution.
//!
//! See `docs/theory/observables.md`.

use super::equilibrium::AxialLoad;
use super::mesh_cycle::{CyclePosition, common_face, static_cycle, window};
use super::{Equilibrium, Observable, Quantity};
use calyx_model::ids::PairId;
use calyx_model::observed::Observed;

/// Number of positions on the face per window at which the load is evaluated.
const PER_WINDOW: f64 = 4.0;
/// Distance from an end of the path of contact, in pitches, at which the load sharing is evaluated
/// on both sides of it.
const BESIDE: f64 = 1e-9;

/// Face load factor `K_Hbeta`: largest load per face width over its mean (ISO 6336-1:2019, 7.2.2),
/// with the load summed over all contact lines at each axial position and averaged over the mesh
/// cycle in which the position lies. 1 in a plane model and without load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FaceLoadFactor(pub PairId);

impl Observable for FaceLoadFactor {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("face_load_factor", "1")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        Observed::number(k_h_beta(at, self.0))
    }

    fn pair_of(&self) -> Option<PairId> {
        Some(self.0)
    }

    fn cycle_of(&self) -> Option<PairId> {
        Some(self.0)
    }
}

/// Face load factor of the tooth root `K_Fbeta = K_Hbeta^N_F` (ISO 6336-1:2019, 7.5).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RootFaceLoadFactor {
    pair: PairId,
    exponent: f64,
}

impl RootFaceLoadFactor {
    /// Creates the factor of a mesh from the larger ratio of tooth depth to face width of its
    /// gears, which counts as at most 1/3.
    pub fn new(pair: PairId, depth_ratio: f64) -> RootFaceLoadFactor {
        let ratio = depth_ratio.min(1.0 / 3.0);
        RootFaceLoadFactor { pair, exponent: 1.0 / (1.0 + ratio + ratio * ratio) }
    }
}

impl Observable for RootFaceLoadFactor {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("face_load_factor_bending", "1")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        Observed::number(k_h_beta(at, self.pair).powf(self.exponent))
    }

    fn pair_of(&self) -> Option<PairId> {
        Some(self.pair)
    }

    fn cycle_of(&self) -> Option<PairId> {
        Some(self.pair)
    }
}

/// Transverse load factor `K_Halpha`: largest share of the load on a tooth pair in the mesh cycle,
/// over the largest share with a uniform load on all contact lines of the nominal path of contact
/// (ISO 6336-1:2019, 8.1). 1 without load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TransverseLoadFactor(pub PairId);

impl Observable for TransverseLoadFactor {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("transverse_load_factor", "1")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let Some((mesh, _)) = at.mesh(self.0) else { return Observed::number(f64::NAN) };
        let share = |position: &CyclePosition| position.largest_pair_force / position.force;
        let shares = cycle(at, self.0).iter().map(share).fold(f64::NAN, f64::max);
        let factor = shares / ideal_share(mesh.transverse_contact_ratio(), mesh.overlap_ratio);
        Observed::number(if factor.is_nan() { 1.0 } else { factor })
    }

    fn pair_of(&self) -> Option<PairId> {
        Some(self.0)
    }

    fn cycle_of(&self) -> Option<PairId> {
        Some(self.0)
    }
}

/// Dynamic factor: mesh force over the mean static mesh force of the mesh cycle in which the
/// position lies. Its maximum is `K_v` (ISO 6336-1:2019, 6.1). NaN if the bodies have no static
/// equilibrium, and 1 without load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DynamicFactor(pub PairId);

impl Observable for DynamicFactor {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("dynamic_factor", "1")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let Some(cycle) = static_cycle(at, self.0) else { return Observed::number(f64::NAN) };
        let mean = cycle.iter().map(|position| position.force).sum::<f64>() / cycle.len() as f64;
        Observed::number(if mean > 0.0 { at.force(self.0) / mean } else { 1.0 })
    }

    fn pair_of(&self) -> Option<PairId> {
        Some(self.0)
    }

    fn cycle_of(&self) -> Option<PairId> {
        Some(self.0)
    }
}

/// Returns the positions of the mesh cycle; the position alone if the bodies have no static
/// equilibrium.
fn cycle(at: &Equilibrium<'_>, pair: PairId) -> Vec<CyclePosition> {
    static_cycle(at, pair).unwrap_or_else(|| vec![CyclePosition::of(at, pair)])
}

fn k_h_beta(at: &Equilibrium<'_>, pair: PairId) -> f64 {
    let Some((mesh, bodies)) = at.mesh(pair) else { return f64::NAN };
    let face = common_face(at, bodies);
    let positions = cycle(at, pair);
    let loads: Vec<AxialLoad> = positions.into_iter().flat_map(|position| position.loads).collect();
    largest_over_mean(&loads, face, window(mesh, face[1] - face[0]))
}

/// Returns the largest load per face width over its mean, for forces on a face. The load is
/// averaged over windows of a width (m); at the ends of the face, the straight line through the two
/// outermost windows continues it. 1 without load.
fn largest_over_mean(loads: &[AxialLoad], [start, end]: [f64; 2], window: f64) -> f64 {
    let total: f64 = loads.iter().map(|load| load.force).sum();
    let width = end - start;
    if !(total > 0.0 && width > 0.0) {
        return 1.0;
    }
    let load_from = |low: f64| {
        let within = |load: &AxialLoad| {
            // Cells at the end of a face may extend beyond it.
            let [first, last] = load.ends.map(|at| at.clamp(start, end));
            let common = last.min(low + window) - first.max(low);
            match last > first {
                true => load.force * common.max(0.0) / (last - first),
                false if (low..=low + window).contains(&first) => load.force,
                false => 0.0,
            }
        };
        loads.iter().map(within).sum::<f64>() / window
    };
    let count = (PER_WINDOW * (width / window - 1.0)).ceil().max(1.0) as usize;
    let inside = (0..=count).map(|k| load_from(start + (width - window) * k as f64 / count as f64));
    let largest = inside.fold(0.0, f64::max);
    let last = end - window;
    let at_ends = [(start, start + window), (last, last - window)].map(|(outer, inner)| {
        let [outer, inner] = [outer, inner].map(load_from);
        outer + 0.5 * (outer - inner)
    });
    at_ends.into_iter().fold(largest, f64::max) * width / total
}

/// Returns the largest share of a tooth pair in the load of a mesh, if the load per length is equal
/// on all contact lines of the nominal path of contact.
///
/// A pair that entered contact `x` pitches ago is in contact along the sections of the face whose
/// phase is on the path: the fraction `min(1, x/eps_beta, eps_alpha/eps_beta, ...)` of its line.
/// The share is largest at a kink of one of these lengths, because between kinks it is the quotient
/// of two linear functions.
fn ideal_share(contact_ratio: f64, overlap_ratio: f64) -> f64 {
    let total = contact_ratio + overlap_ratio;
    if !(total.is_finite() && total > 0.0) {
        return f64::NAN;
    }
    // Fraction of the face on which the pair that entered `passed` pitches ago has contact.
    let length = |passed: f64| match overlap_ratio > 0.0 {
        true => {
            let [first, last] =
                [passed - contact_ratio, passed].map(|at| (at / overlap_ratio).clamp(0.0, 1.0));
            last - first
        }
        false => f64::from(u8::from((0.0..=contact_ratio).contains(&passed))),
    };
    let share = |passed: f64| {
        let pairs = |passed: f64| (0..=total as usize).map(move |k| passed.rem_euclid(1.0) + k as f64);
        let all: f64 = pairs(passed).map(length).sum();
        pairs(passed).map(length).fold(0.0, f64::max) / all
    };
    let kinks = [0.0, overlap_ratio, contact_ratio, total];
    let beside = kinks.into_iter().flat_map(|kink| [kink - BESIDE, kink + BESIDE]);
    beside.map(share).filter(|share| share.is_finite()).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests;
