//! Points of a sample in the unit cube: random, Latin hypercube, or scrambled Sobol points.
//!
//! All of them follow from the seed by integer arithmetic, so they are the same on every machine.
//! The random numbers are those of ChaCha with 8 rounds, with a stream per dimension.
//!
//! See `docs/theory/tolerance-studies.md`.

use calyx_report::study::Method;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{RngCore, SeedableRng};
use sobol_burley::NUM_DIMENSIONS;
use sobol_burley::parts::{owen_scramble_rev, sobol_rev};

/// Largest number of Sobol points: the direction numbers have 16 bits of the index.
pub const MOST_SOBOL_POINTS: usize = 1 << 16;
/// Largest number of dimensions of Sobol points.
pub const MOST_SOBOL_DIMENSIONS: usize = NUM_DIMENSIONS as usize;

/// Returns the coordinates of `count` points in one dimension, between 0 and 1 without both ends.
/// Sobol points have at most [`MOST_SOBOL_DIMENSIONS`] dimensions and [`MOST_SOBOL_POINTS`] points.
pub fn coordinates(method: Method, seed: u64, dimension: usize, count: usize) -> Vec<f64> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    random.set_stream(dimension as u64);
    match method {
        Method::Random => (0..count).map(|_| uniform(&mut random)).collect(),
        Method::LatinHypercube => {
            let strata = permutation(&mut random, count);
            // The largest number below 1, in case of rounding.
            let last = 1.0_f64.next_down();
            let within = |stratum: usize| (stratum as f64 + uniform(&mut random)) / count as f64;
            strata.into_iter().map(within).map(|part| part.min(last)).collect()
        }
        Method::Sobol => {
            let scramble = random.next_u32();
            (0..count).map(|index| sobol(index as u32, dimension as u32, Some(scramble))).collect()
        }
    }
}

/// Returns a coordinate of a Sobol point with the direction numbers of Joe and Kuo, "Constructing
/// Sobol sequences with better two-dimensional projections", SIAM J. Sci. Comput. 30 (2008),
/// 2635-2654; scrambled as of Owen by the hash function of Burley, "Practical hash-based Owen
/// scrambling", Journal of Computer Graphics Techniques 9 (2020), 1-20.
pub fn sobol(index: u32, dimension: u32, scramble: Option<u32>) -> f64 {
    let digits = sobol_rev(index.reverse_bits(), dimension);
    match scramble {
        None => f64::from(digits.reverse_bits()) / 2f64.powi(32),
        // The centre of the interval of all numbers with these digits.
        Some(scramble) => {
            (f64::from(owen_scramble_rev(digits, scramble).reverse_bits()) + 0.5) / 2f64.powi(32)
        }
    }
}

/// Returns a uniform number between 0 and 1 without both ends.
fn uniform(random: &mut ChaCha8Rng) -> f64 {
    ((random.next_u64() >> 12) as f64 + 0.5) / 2f64.powi(52)
}

/// Returns a random permutation by the algorithm of Fisher and Yates.
fn permutation(random: &mut ChaCha8Rng, count: usize) -> Vec<usize> {
    let mut all: Vec<usize> = (0..count).collect();
    for last in (1..count).rev() {
        let choices = last as u128 + 1;
        // The bias is below 1e-13 for a million of choices.
        let choice = (u128::from(random.next_u64()) * choices) >> 64;
        all.swap(last, choice as usize);
    }
    all
}
