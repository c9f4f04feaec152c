//! What an analysis will cost, told before it is done: counts of operations, and how fast this machine does them.
//!
//! Two kinds of work take the time. Condensing structures is products of dense matrices; contact and the near field are evaluations of
//! elementary functions. How fast a machine does each is measured once, in a fraction of a second ([`Rates`]); how much of each there is follows
//! from the plan ([`structure`], [`positions`]). The constants are counts, fitted to runs of examples on one machine (`docs/accuracy.md`), which they
//! give back within a third, but for contact of twisted flanks, which takes half to twice as long as is told. How far off they are elsewhere nothing
//! measures but `calyx tradeoff`, which prints predicted beside measured times. A prediction is for telling seconds from minutes.

mod analysis;

pub use analysis::{AnalysisCost, Meshes, Task};

use calyx_numerics::dense::product;
use calyx_structure::StructureSize;
use faer::Mat;
use serde::{Deserialize, Serialize};
use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

/// How fast a machine works.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rates {
    /// Multiplications a second in products of dense matrices, on one thread.
    pub products: f64,
    /// Logarithms a second, each with the few operations around it, on one thread.
    pub logarithms: f64,
    /// Threads that there are.
    pub threads: usize,
}

/// Size of the matrices of a calibration, and how many products are tried; the fastest counts, for others may have been disturbed.
const TRIED: (usize, usize) = (384, 5);
/// Logarithms of a calibration, and how often they are tried.
const LOGARITHMS: (usize, usize) = (400_000, 5);

impl Rates {
    /// Measures this machine, which takes about a tenth of a second.
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

    /// Those that a file keeps of this machine; measured and kept there if it has none, or if they are to be measured `anew`. A file that
    /// cannot be written is done without.
    pub fn of_this_machine(file: Option<&Path>, anew: bool) -> Rates {
        let there = file.and_then(|file| std::fs::read(file).ok());
        let kept = there.as_deref().and_then(|text| serde_json::from_slice::<Rates>(text).ok());
        // A file of somebody else with this name stays.
        let ours = there.as_deref().is_none_or(<[u8]>::is_empty) || kept.is_some();
        if let Some(rates) = kept.filter(|rates| !anew && rates.are_sound()) {
            return rates;
        }
        let rates = Rates::measure();
        if let (Some(file), Ok(text), true) = (file, serde_json::to_vec(&rates), ours) {
            let _ = file.parent().map(std::fs::create_dir_all);
            // In one step, so that a kill leaves no part of a file, which would count as somebody else's.
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

/// The least time of some tries, s.
fn fastest(tries: usize, work: impl Fn()) -> f64 {
    let time = |()| {
        let started = Instant::now();
        work();
        started.elapsed().as_secs_f64()
    };
    (0..tries).map(|_| time(())).fold(f64::INFINITY, f64::min).max(1e-9)
}

/// What a part of an analysis takes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cost {
    /// s
    pub time: f64,
    /// Bytes.
    pub memory: f64,
}

/// What condensing a structure costs, on all threads.
///
/// A sector's mesh takes a time in proportion to its degrees of freedom: setting up equations, carrying loads and stresses through the
/// elimination, in space the near field, which in the plane takes a time in proportion to pairs of loads. Sectors are joined by products of dense
/// matrices besides, in space usually by mirror-symmetric halves.
pub fn structure(size: &StructureSize, in_space: bool, rates: &Rates) -> Cost {
    let freedoms = size.freedoms as f64;
    let whole = in_space && !size.mirrored;
    let [time_of_whole, memory_of_whole] = if whole { WHOLE } else { [1.0; 2] };
    let logarithms = match in_space {
        true => LOGARITHMS_PER_FREEDOM_IN_SPACE * freedoms,
        false => {
            LOGARITHMS_PER_FREEDOM_IN_PLANE * freedoms
                + LOGARITHMS_PER_PAIR_OF_LOADS * (size.loads as f64).powi(2)
        }
    };
    let time = time_of_whole
        * (logarithms / rates.logarithms + PRODUCTS_OF_HALVES * size.operations() / rates.products);
    let bytes = if in_space { BYTES_PER_FREEDOM_IN_SPACE } else { BYTES_PER_FREEDOM_IN_PLANE };
    let bytes = memory_of_whole * bytes;
    Cost {
        time: time / (EFFICIENCY * rates.threads.max(1) as f64),
        memory: bytes * freedoms + size.bytes() as f64,
    }
}

/// Time of a degree of freedom of a sector, in logarithms: 41 to 56 microseconds on a machine that takes 3.6 nanoseconds for one, of up to 127,000
/// degrees of freedom in space; 10 microseconds in the plane, of 7,000 to 35,000.
const LOGARITHMS_PER_FREEDOM_IN_SPACE: f64 = 13_000.0;
const LOGARITHMS_PER_FREEDOM_IN_PLANE: f64 = 2_900.0;
/// Time of a pair of loads in the plane: 5 microseconds on the same machine, by meshes of different fineness under 256 loads.
const LOGARITHMS_PER_PAIR_OF_LOADS: f64 = 1_450.0;
/// Of the products that joining sectors whole would take, halves take so many.
const PRODUCTS_OF_HALVES: f64 = 0.25;
/// By how much more time and memory a sector in space takes that has no halves, such as a helical gear's.
const WHOLE: [f64; 2] = [4.6, 5.4];
/// What of its threads an analysis uses.
const EFFICIENCY: f64 = 0.8;
/// Memory while a sector's mesh is eliminated, by its degrees of freedom.
const BYTES_PER_FREEDOM_IN_PLANE: f64 = 1_100.0;
const BYTES_PER_FREEDOM_IN_SPACE: f64 = 3_900.0;

/// What so many positions cost, each a contact problem of so many cells, solved side by side or one after the other.
///
/// What each cell does to each other one takes the time, more than the solution; the same in the plane and in space, more on flanks that are
/// `twisted`, where cells do not lie in rows.
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

/// Time of a pair of cells: 0.3 microseconds on the same machine.
const LOGARITHMS_PER_PAIR_OF_CELLS: f64 = 83.0;
/// On twisted flanks so many times as much.
const TWISTED: f64 = 2.1;
/// Of finding what touches and reading values off.
const LOGARITHMS_PER_POSITION: f64 = 1e5;
/// Matrices of all cells by all cells.
const MATRICES: f64 = 4.0;

#[cfg(test)]
mod tests {
    use super::*;

    const RATES: Rates = Rates { products: 1e10, logarithms: 3e8, threads: 2 };
    const SIZE: StructureSize = StructureSize {
        sectors: 20,
        elements: 424,
        freedoms: 39_078,
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
        let finer = structure(&StructureSize { freedoms: 80_000, cut: 800, ..SIZE }, true, &RATES);
        assert!(finer.time > own.time && finer.memory > own.memory);
        let whole = structure(&StructureSize { mirrored: false, ..SIZE }, true, &RATES);
        assert!(whole.time > own.time && whole.memory > own.memory);
        let faster = Rates { products: 2e10, logarithms: 6e8, ..RATES };
        assert!((structure(&SIZE, true, &faster).time / own.time - 0.5).abs() < 1e-12);
        let [few, many] = [100, 700].map(|cells| positions(cells, false, 32, true, &RATES));
        assert!(many.time > 10.0 * few.time);
        // A motion in time goes step by step.
        assert!(positions(100, false, 32, false, &RATES).time > few.time);
        assert_eq!(positions(100, false, 0, true, &RATES).time, 0.0);
    }

    #[test]
    fn rates_are_kept_until_they_are_measured_anew() {
        let directory = tempfile::tempdir().unwrap();
        let file = directory.path().join("below/rates.json");
        let measured = Rates::of_this_machine(Some(&file), false);
        assert!(measured.are_sound());
        assert_eq!(Rates::of_this_machine(Some(&file), false), measured);
        let kept = Rates { products: 1.0, ..measured };
        std::fs::write(&file, serde_json::to_vec(&kept).unwrap()).unwrap();
        assert_eq!(Rates::of_this_machine(Some(&file), false), kept);
        assert!(Rates::of_this_machine(Some(&file), true).products > 1.0);
        // Neither rates of nothing nor a file that is none are believed.
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
