//! Prediction of the time and memory of an analysis.
//!
//! Two kinds of operation dominate the time. Static condensation consists of products of dense
//! matrices; influence coefficients of contact cells consist of logarithms and similar functions.
//! [`Rates`] are the numbers of these operations per second, measured once on each machine.
//! [`structure`] and [`positions`] count the operations of an analysis from its plan. Their
//! constants were fitted to runs of the examples on one machine (`docs/accuracy.md`).
//!
//! Predicted times of structures and positions in three dimensions are between half and twice the
//! measured ones; in the plane those of planetary sets are up to three times too long. `calyx
//! tradeoff` prints both. A prediction is accurate enough to distinguish seconds from minutes.
//!
//! See `docs/theory/fidelity.md`.

mod analysis;
mod sound;

pub use analysis::{AnalysisCost, Meshes, Task};
pub use sound::{SoundSize, sound_size};

use calyx_model::elastic_body::ElasticBodySize;
use calyx_numerics::dense::product;
use calyx_structure::StructureSize;
use faer::Mat;
use serde::{Deserialize, Serialize};
use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

/// Speed of a machine at the two dominant kinds of operation.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rates {
    /// Multiplications per second in products of dense matrices, on one thread.
    pub products: f64,
    /// Logarithms per second, including a few additions and multiplications each, on one thread.
    pub logarithms: f64,
    /// Number of threads.
    pub threads: usize,
}

/// Number of rows of the matrices that a calibration multiplies.
const CALIBRATION_SIZE: usize = 384;
/// Number of logarithms that a calibration evaluates.
const CALIBRATION_LOGARITHMS: usize = 400_000;
/// Number of repetitions of a calibration. The shortest time counts, because other processes may
/// have delayed the others.
const REPETITIONS: usize = 5;

impl Rates {
    /// Measures this machine, in about a tenth of a second.
    pub fn measure() -> Rates {
        let size = CALIBRATION_SIZE;
        let matrix = Mat::from_fn(size, size, |i, j| 1.0 + ((7 * i + 3 * j) % 11) as f64);
        let single_thread = rayon::ThreadPoolBuilder::new().num_threads(1).build();
        let multiply = || {
            shortest_time(|| {
                black_box(product(black_box(matrix.as_ref()), matrix.as_ref()));
            })
        };
        let products = match &single_thread {
            Ok(pool) => pool.install(multiply),
            Err(_) => multiply(),
        };
        let count = CALIBRATION_LOGARITHMS;
        let logarithms = shortest_time(|| {
            let sum: f64 = (1..=count).map(|k| (1e-3 * k as f64).ln() * (k as f64).recip()).sum();
            black_box(sum);
        });
        Rates {
            products: (size as f64).powi(3) / products,
            logarithms: count as f64 / logarithms,
            threads: rayon::current_num_threads(),
        }
    }

    /// Returns the rates of this machine, read from a file. If the file has no valid rates, or if
    /// `remeasure` is set, the rates are measured and stored. A file that cannot be written is
    /// ignored, and a file with other contents is not changed.
    pub fn of_this_machine(file: Option<&Path>, remeasure: bool) -> Rates {
        let text = file.and_then(|file| std::fs::read(file).ok());
        let stored = text.as_deref().and_then(|text| serde_json::from_slice::<Rates>(text).ok());
        let may_write = text.as_deref().is_none_or(<[u8]>::is_empty) || stored.is_some();
        if let Some(rates) = stored.filter(|rates| !remeasure && rates.are_valid()) {
            return rates;
        }
        let rates = Rates::measure();
        if let (Some(file), Ok(text), true) = (file, serde_json::to_vec(&rates), may_write) {
            let _ = file.parent().map(std::fs::create_dir_all);
            // Renamed when complete: a partial file would count as a file with other contents.
            let unfinished = file.with_extension(format!("{}.part", std::process::id()));
            let _ = std::fs::write(&unfinished, text).and_then(|()| std::fs::rename(&unfinished, file));
        }
        rates
    }

    /// Returns true if the rates are positive and were measured with the current number of threads.
    fn are_valid(&self) -> bool {
        [self.products, self.logarithms].iter().all(|rate| rate.is_finite() && *rate > 0.0)
            && self.threads == rayon::current_num_threads()
    }
}

/// Returns the shortest time of [`REPETITIONS`] calls, s.
fn shortest_time(work: impl Fn()) -> f64 {
    let time = |()| {
        let started = Instant::now();
        work();
        started.elapsed().as_secs_f64()
    };
    (0..REPETITIONS).map(|_| time(())).fold(f64::INFINITY, f64::min).max(1e-9)
}

/// Cost of a part of an analysis.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cost {
    /// Time, s.
    pub time: f64,
    /// Memory, bytes.
    pub memory: f64,
}

/// Returns the cost of the static condensation of a structure, on all threads.
///
/// The time of a sector is proportional to its number of degrees of freedom. It includes assembly,
/// elimination, loads, stresses and, in three dimensions, the near field of the loads. In a plane
/// model the time of the near field is proportional to the number of pairs of loads. Coupling of
/// the sectors consists of products of dense matrices; structures with mirror symmetry use half of
/// each matrix.
pub fn structure(size: &StructureSize, three_dimensional: bool, rates: &Rates) -> Cost {
    let dofs = size.dofs as f64;
    let asymmetric = three_dimensional && !size.mirrored;
    let [time_factor, memory_factor] = if asymmetric { WITHOUT_MIRROR_SYMMETRY } else { [1.0; 2] };
    let logarithms = match three_dimensional {
        true => LOGARITHMS_PER_SOLID_DOF * dofs,
        false => LOGARITHMS_PER_PLANE_DOF * dofs + LOGARITHMS_PER_PAIR_OF_LOADS * (size.loads as f64).powi(2),
    };
    let time = time_factor
        * (logarithms / rates.logarithms + MIRROR_SYMMETRIC_PRODUCTS * size.operations() / rates.products);
    let bytes = if three_dimensional { BYTES_PER_SOLID_DOF } else { BYTES_PER_PLANE_DOF };
    let bytes = memory_factor * bytes;
    Cost {
        time: time / (EFFICIENCY * rates.threads.max(1) as f64),
        memory: bytes * dofs + size.bytes() as f64,
    }
}

/// Returns the cost of the static condensation of an elastic body of any shape, on all threads.
pub fn elastic_body(size: &ElasticBodySize, rates: &Rates) -> Cost {
    let time = size.operations() / rates.products;
    Cost { time: time / (EFFICIENCY * rates.threads.max(1) as f64), memory: size.bytes() }
}

/// Time per degree of freedom of a sector of a solid model, in logarithms. Measured: 46 to 60
/// microseconds on a machine with 8.9 nanoseconds per logarithm, for up to 127,000 degrees of
/// freedom.
const LOGARITHMS_PER_SOLID_DOF: f64 = 6_100.0;
/// The same for plane models. Measured: 8 microseconds for 7,000 to 35,000 degrees of freedom.
const LOGARITHMS_PER_PLANE_DOF: f64 = 900.0;
/// Time per pair of loads of a plane model, in logarithms. Measured: 4 microseconds on the same
/// machine, for meshes of different density with 256 loads.
const LOGARITHMS_PER_PAIR_OF_LOADS: f64 = 450.0;
/// Fraction of the multiplications for the coupling of sectors that mirror symmetry leaves.
const MIRROR_SYMMETRIC_PRODUCTS: f64 = 0.25;
/// Factors on time and memory of a solid model without mirror symmetry, such as a helical gear.
/// Measured: 2.0 to 4.0 and 2.4 to 3.0.
const WITHOUT_MIRROR_SYMMETRY: [f64; 2] = [2.8, 2.8];
/// Parallel efficiency of an analysis.
const EFFICIENCY: f64 = 0.8;
/// Memory for the elimination of a sector of a plane model, per degree of freedom.
const BYTES_PER_PLANE_DOF: f64 = 1_100.0;
/// The same for solid models.
const BYTES_PER_SOLID_DOF: f64 = 5_000.0;

/// Flanks in contact, by the work of their influence coefficients.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Flanks {
    /// Profiles in the plane.
    Plane,
    /// Surfaces whose cells form rows with common coefficients.
    Straight,
    /// Surfaces whose cells do not.
    Helical,
    /// Surfaces on general axes, whose contact grids are adapted to the share of each tooth.
    General,
}

impl Flanks {
    /// Returns the time per pair of cells, in logarithms. Measured: 0.75 microseconds in the plane,
    /// 0.1 to 0.2 in three dimensions on parallel axes, and 0.5 to 0.7 on general ones.
    fn logarithms_per_pair_of_cells(self) -> f64 {
        match self {
            Flanks::Plane => 83.0,
            Flanks::Straight => 12.0,
            Flanks::Helical => 25.0,
            Flanks::General => 75.0,
        }
    }

    /// Returns the time of the contact search and of the observables per position, in logarithms.
    fn logarithms_per_position(self) -> f64 {
        if self == Flanks::Plane { 1e5 } else { 3.5e6 }
    }
}

/// Returns the cost of solving `count` positions, each a contact problem with `cells` cells, either
/// in `parallel` or one after the other.
///
/// The influence coefficients between cells take more time than the solution of the contact
/// problem.
pub fn positions(cells: usize, flanks: Flanks, count: usize, parallel: bool, rates: &Rates) -> Cost {
    let cells = cells as f64;
    let logarithms = flanks.logarithms_per_pair_of_cells() * cells * cells + flanks.logarithms_per_position();
    let one = logarithms / rates.logarithms + cells.powi(3) / 6.0 / rates.products;
    let threads = if parallel { rates.threads.max(1).min(count.max(1)) as f64 } else { 1.0 };
    let time = one * count as f64 / (EFFICIENCY * threads).max(1.0);
    Cost { time, memory: threads * MATRICES * size_of::<f64>() as f64 * cells * cells }
}

/// Number of matrices, with a row and a column per cell, that a contact problem stores at most.
/// Measured by the peak memory of processes: 7.2 and 7.4.
const MATRICES: f64 = 7.4;

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
        mirrored: true,
    };

    #[test]
    fn costs_grow_with_the_problem_and_shrink_with_the_speed_of_the_machine() {
        let own = structure(&SIZE, true, &RATES);
        assert!(own.time > 0.0 && own.memory > SIZE.bytes() as f64);
        let finer = structure(&StructureSize { dofs: 80_000, cut: 800, ..SIZE }, true, &RATES);
        assert!(finer.time > own.time && finer.memory > own.memory);
        let asymmetric = structure(&StructureSize { mirrored: false, ..SIZE }, true, &RATES);
        assert!(asymmetric.time > own.time && asymmetric.memory > own.memory);
        let faster = Rates { products: 2e10, logarithms: 6e8, ..RATES };
        assert!((structure(&SIZE, true, &faster).time / own.time - 0.5).abs() < 1e-12);
        let [few, many] = [100, 2000].map(|cells| positions(cells, Flanks::Straight, 32, true, &RATES));
        assert!(many.time > 10.0 * few.time);
        // Steps of a transient analysis are solved one after the other.
        assert!(positions(100, Flanks::Straight, 32, false, &RATES).time > few.time);
        assert_eq!(positions(100, Flanks::Straight, 0, true, &RATES).time, 0.0);
    }

    #[test]
    fn rates_are_read_from_the_file_until_they_are_measured_again() {
        let directory = tempfile::tempdir().unwrap();
        let file = directory.path().join("below/rates.json");
        let measured = Rates::of_this_machine(Some(&file), false);
        assert!(measured.are_valid());
        assert_eq!(Rates::of_this_machine(Some(&file), false), measured);
        let stored = Rates { products: 1.0, ..measured };
        std::fs::write(&file, serde_json::to_vec(&stored).unwrap()).unwrap();
        assert_eq!(Rates::of_this_machine(Some(&file), false), stored);
        assert!(Rates::of_this_machine(Some(&file), true).products > 1.0);
        // Files with zero rates or invalid content are rejected.
        for text in ["{", "{\"products\":0.0,\"logarithms\":1.0,\"threads\":1}"] {
            std::fs::write(&file, text).unwrap();
            assert!(Rates::of_this_machine(Some(&file), false).are_valid());
        }
        std::fs::write(&file, "notes").unwrap();
        assert!(Rates::of_this_machine(Some(&file), true).are_valid());
        assert_eq!(std::fs::read_to_string(&file).unwrap(), "notes");
        assert!(Rates::of_this_machine(None, false).are_valid());
    }
}
