//! Cost prediction of an analysis: counts of operations, and the speed of this machine.
//!
//! Two kinds of work dominate the time. Condensation of structures consists of products of dense
//! matrices; contact and the near field are evaluations of elementary functions. The speed of a
//! machine at each is measured once, in a fraction of a second ([`Rates`]). The amount of each
//! follows from the plan ([`structure`], [`positions`]). The constants are counts fitted to runs of
//! examples on one machine (`docs/accuracy.md`). They reproduce these runs within a third, except
//! for contact of twisted flanks, where the time is half to twice the prediction. `calyx tradeoff`
//! prints predicted and measured times. A prediction serves to distinguish seconds from minutes.
//!
//! See `docs/theory/fidelity.md`.

mod analysis;

pub use analysis::{AnalysisCost, Meshes, Task};

use calyx_numerics::dense::product;
use calyx_structure::StructureSize;
use faer::Mat;
use serde::{Deserialize, Serialize};
use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

/// Speed of a machine.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rates {
    /// Multiplications per second in products of dense matrices, on one thread.
    pub products: f64,
    /// Logarithms per second, each with the few operations around it, on one thread.
    pub logarithms: f64,
    /// Number of threads.
    pub threads: usize,
}

/// Size of the matrices of a calibration, and number of repetitions; the fastest counts, because
/// others may have been disturbed.
const TRIED: (usize, usize) = (384, 5);
/// Number of logarithms of a calibration, and number of repetitions.
const LOGARITHMS: (usize, usize) = (400_000, 5);

impl Rates {
    /// Measures this machine, in about a tenth of a second.
    pub fn measure() -> Rates {
        let (size, tries) = TRIED;
        let matrix = Mat::from_fn(size, size, |i, j| 1.0 + ((7 * i + 3 * j) % 11) as f64);
        let alone = rayon::ThreadPoolBuilder::new().num_threads(1).build();
        let multiply = || {
            fastest(tries, || {
                black_box(product(black_box(matrix.as_ref()), matrix.as_ref()));
            })
        };
        let products = match &alone {
            Ok(pool) => pool.install(multiply),
            Err(_) => multiply(),
        };
        let (count, tries) = LOGARITHMS;
        let logarithms = fastest(tries, || {
            let sum: f64 = (1..=count).map(|k| (1e-3 * k as f64).ln() * (k as f64).recip()).sum();
            black_box(sum);
        });
        Rates {
            products: (size as f64).powi(3) / products,
            logarithms: count as f64 / logarithms,
            threads: rayon::current_num_threads(),
        }
    }

    /// Returns the rates of this machine from a file. Measures and stores them if the file has none
    /// or if `remeasure` is set. Failure to write the file is ignored.
    pub fn of_this_machine(file: Option<&Path>, remeasure: bool) -> Rates {
        let there = file.and_then(|file| std::fs::read(file).ok());
        let kept = there.as_deref().and_then(|text| serde_json::from_slice::<Rates>(text).ok());
        // Do not overwrite a file of another kind with this name.
        let ours = there.as_deref().is_none_or(<[u8]>::is_empty) || kept.is_some();
        if let Some(rates) = kept.filter(|rates| !remeasure && rates.are_sound()) {
            return rates;
        }
        let rates = Rates::measure();
        if let (Some(file), Ok(text), true) = (file, serde_json::to_vec(&rates), ours) {
            let _ = file.parent().map(std::fs::create_dir_all);
            // Rename atomically: a partial file after a kill would count as a file of another kind.
            let unfinished = file.with_extension(format!("{}.part", std::process::id()));
            let _ = std::fs::write(&unfinished, text).and_then(|()| std::fs::rename(&unfinished, file));
        }
        rates
    }

    fn are_sound(&self) -> bool {
        [self.products, self.logarithms].iter().all(|rate| rate.is_finite() && *rate > 0.0)
            && self.threads == rayon::current_num_threads()
    }
}

/// Returns the shortest time of some repetitions, s.
fn fastest(tries: usize, work: impl Fn()) -> f64 {
    let time = |()| {
        let started = Instant::now();
        work();
        started.elapsed().as_secs_f64()
    };
    (0..tries).map(|_| time(())).fold(f64::INFINITY, f64::min).max(1e-9)
}

/// Cost of a part of an analysis.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cost {
    /// Time, s.
    pub time: f64,
    /// Memory, bytes.
    pub memory: f64,
}

/// Returns the cost of condensing a structure, on all threads.
///
/// The time for a sector's mesh is proportional to its number of DOFs: assembly, elimination with
/// loads and stresses, and in three dimensions the near field. In a plane model the near field
/// takes a time proportional to the number of pairs of loads. Joining the sectors takes products of
/// dense matrices, in three dimensions usually by mirror-symmetric halves.
pub fn structure(size: &StructureSize, in_space: bool, rates: &Rates) -> Cost {
    let dofs = size.dofs as f64;
    let whole = in_space && !size.mirrored;
    let [time_of_whole, memory_of_whole] = if whole { WHOLE } else { [1.0; 2] };
    let logarithms = match in_space {
        true => LOGARITHMS_PER_DOF_IN_SPACE * dofs,
        false => {
            LOGARITHMS_PER_DOF_IN_PLANE * dofs + LOGARITHMS_PER_PAIR_OF_LOADS * (size.loads as f64).powi(2)
        }
    };
    let time = time_of_whole
        * (logarithms / rates.logarithms + PRODUCTS_OF_HALVES * size.operations() / rates.products);
    let bytes = if in_space { BYTES_PER_DOF_IN_SPACE } else { BYTES_PER_DOF_IN_PLANE };
    let bytes = memory_of_whole * bytes;
    Cost {
        time: time / (EFFICIENCY * rates.threads.max(1) as f64),
        memory: bytes * dofs + size.bytes() as f64,
    }
}

/// Time per DOF of a sector, in logarithms: 41 to 56 microseconds on a machine that takes 3.6
/// nanoseconds per logarithm, for up to 127,000 DOFs in three dimensions; 10 microseconds in plane
/// models of 7,000 to 35,000 DOFs.
const LOGARITHMS_PER_DOF_IN_SPACE: f64 = 13_000.0;
const LOGARITHMS_PER_DOF_IN_PLANE: f64 = 2_900.0;
/// Time per pair of loads in a plane model: 5 microseconds on the same machine, for meshes of
/// different density with 256 loads.
const LOGARITHMS_PER_PAIR_OF_LOADS: f64 = 1_450.0;
/// Fraction of the products of joining whole sectors that mirror-symmetric halves take.
const PRODUCTS_OF_HALVES: f64 = 0.25;
/// Factors of time and memory of a three-dimensional sector without mirror symmetry, such as a
/// helical gear's.
const WHOLE: [f64; 2] = [4.6, 5.4];
/// Parallel efficiency of an analysis.
const EFFICIENCY: f64 = 0.8;
/// Memory for the elimination of a sector's mesh, per DOF.
const BYTES_PER_DOF_IN_PLANE: f64 = 1_100.0;
const BYTES_PER_DOF_IN_SPACE: f64 = 3_900.0;

/// Returns the cost of a number of positions, each a contact problem of so many cells, solved in
/// parallel or one after the other.
///
/// The influence coefficients between cells take more time than the solution. The time is equal in
/// plane and three-dimensional models, and longer on `twisted` flanks, whose cells do not lie in
/// rows.
pub fn positions(cells: usize, twisted: bool, count: usize, side_by_side: bool, rates: &Rates) -> Cost {
    let cells = cells as f64;
    let pair = LOGARITHMS_PER_PAIR_OF_CELLS * if twisted { TWISTED } else { 1.0 };
    let one = pair * cells * cells / rates.logarithms
        + cells.powi(3) / 6.0 / rates.products
        + LOGARITHMS_PER_POSITION / rates.logarithms;
    let threads = if side_by_side { rates.threads.max(1).min(count.max(1)) as f64 } else { 1.0 };
    let time = one * count as f64 / (EFFICIENCY * threads).max(1.0);
    Cost { time, memory: threads * MATRICES * size_of::<f64>() as f64 * cells * cells }
}

/// Time per pair of cells: 0.3 microseconds on the same machine.
const LOGARITHMS_PER_PAIR_OF_CELLS: f64 = 83.0;
/// Factor for twisted flanks.
const TWISTED: f64 = 2.1;
/// Time of the search for contact and of observables per position.
const LOGARITHMS_PER_POSITION: f64 = 1e5;
/// Number of matrices of all cells by all cells.
const MATRICES: f64 = 4.0;

#[cfg(test)]
mod tests {
    use super::*;

    const RATES: Rates = Rates { products: 1e10, logarithms: 3e8, threads: 2 };
    const SIZE: StructureSize = StructureSize {
        sectors: 20,
        elements: 424,
        dofs: 39_078,
        cut: 585,
        means: 0,
        loads: 336,
        stresses: 936,
        components: 3,
        window: 3,
        far: 0,
        mirrored: true,
    };

    #[test]
    fn costs_grow_with_what_is_computed_and_shrink_with_the_machine() {
        let own = structure(&SIZE, true, &RATES);
        assert!(own.time > 0.0 && own.memory > SIZE.bytes() as f64);
        let finer = structure(&StructureSize { dofs: 80_000, cut: 800, ..SIZE }, true, &RATES);
        assert!(finer.time > own.time && finer.memory > own.memory);
        let whole = structure(&StructureSize { mirrored: false, ..SIZE }, true, &RATES);
        assert!(whole.time > own.time && whole.memory > own.memory);
        let faster = Rates { products: 2e10, logarithms: 6e8, ..RATES };
        assert!((structure(&SIZE, true, &faster).time / own.time - 0.5).abs() < 1e-12);
        let [few, many] = [100, 700].map(|cells| positions(cells, false, 32, true, &RATES));
        assert!(many.time > 10.0 * few.time);
        // Steps of a transient analysis are solved one after the other.
        assert!(positions(100, false, 32, false, &RATES).time > few.time);
        assert_eq!(positions(100, false, 0, true, &RATES).time, 0.0);
    }

    #[test]
    fn rates_are_kept_until_they_are_measured_again() {
        let directory = tempfile::tempdir().unwrap();
        let file = directory.path().join("below/rates.json");
        let measured = Rates::of_this_machine(Some(&file), false);
        assert!(measured.are_sound());
        assert_eq!(Rates::of_this_machine(Some(&file), false), measured);
        let kept = Rates { products: 1.0, ..measured };
        std::fs::write(&file, serde_json::to_vec(&kept).unwrap()).unwrap();
        assert_eq!(Rates::of_this_machine(Some(&file), false), kept);
        assert!(Rates::of_this_machine(Some(&file), true).products > 1.0);
        // Files with zero rates or invalid content are rejected.
        for text in ["{", "{\"products\":0.0,\"logarithms\":1.0,\"threads\":1}"] {
            std::fs::write(&file, text).unwrap();
            assert!(Rates::of_this_machine(Some(&file), false).are_sound());
        }
        std::fs::write(&file, "notes").unwrap();
        assert!(Rates::of_this_machine(Some(&file), true).are_sound());
        assert_eq!(std::fs::read_to_string(&file).unwrap(), "notes");
        assert!(Rates::of_this_machine(None, false).are_sound());
    }
}
