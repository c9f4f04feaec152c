//! Tests of the samples of toleranced params: distributions against closed forms, the evenness of
//! the points, and their repeatability.

use calyx_rt::ParamValue;
use calyx_rt::study::{Method, PERCENTILES, Sample, groups};
use calyx_rt::sweep::sampling::{coordinates, sobol};
use calyx_rt::sweep::{Distribution, standard_normal_quantile};
use calyx_rt::sweep_table::{Case, Column, Row, Statistics, SweepTable};

/// Probabilities and quantiles of the standard normal distribution with 16 digits, from R:
/// `qnorm(p)`.
const NORMAL: [(f64, f64); 6] = [
    (0.5, 0.0),
    (0.841_344_746_068_542_9, 1.0),
    (0.975, 1.959_963_984_540_054),
    (0.99, 2.326_347_874_040_841),
    (1e-6, -4.753_424_308_822_899),
    (1e-20, -9.262_340_089_798_408),
];

#[test]
fn quantiles_are_those_of_closed_forms() {
    let close = |value: f64, known: f64| {
        assert!((value - known).abs() < 1e-13 * known.abs().max(1.0), "{value} {known}")
    };
    for (part, known) in NORMAL {
        close(standard_normal_quantile(part), known);
        let normal = Distribution::Normal { mean: 3.0, standard_deviation: 0.5 };
        close(normal.quantile(part), 3.0 + 0.5 * known);
        // Bounds are three standard deviations from the mean.
        close(Distribution::normal_within(1.5, 4.5).quantile(part), normal.quantile(part));
    }
    for part in [0.01, 0.2, 0.5, 0.77, 0.99] {
        close(Distribution::Uniform { low: 2.0, high: 6.0 }.quantile(part), 2.0 + 4.0 * part);
        let triangular = Distribution::Triangular { low: 1.0, mode: 2.0, high: 5.0 };
        let x = triangular.quantile(part);
        let below = if x < 2.0 { (x - 1.0).powi(2) / 4.0 } else { 1.0 - (5.0 - x).powi(2) / 12.0 };
        close(below, part);
        // The distribution function of a truncated one is linear in that of the whole.
        for (low, high) in [(-1.0, 2.0), (2.0, 3.0), (-3.0, -2.5)] {
            let truncated = Distribution::TruncatedNormal { mean: 0.0, standard_deviation: 1.0, low, high };
            let cdf = |x: f64| 0.5 * libm::erfc(-x / 2f64.sqrt());
            let x = truncated.quantile(part);
            assert!((low..=high).contains(&x));
            assert!(((cdf(x) - cdf(low)) / (cdf(high) - cdf(low)) - part).abs() < 1e-12, "{low} {part}");
        }
    }
    let degenerate = Distribution::Triangular { low: 1.0, mode: 1.0, high: 3.0 };
    assert!(degenerate.quantile(1e-9) >= 1.0 && degenerate.quantile(1.0 - 1e-9) <= 3.0);
}

#[test]
fn a_latin_hypercube_has_one_point_in_each_interval() {
    for count in [2, 7, 200] {
        for dimension in 0..5 {
            let mut strata: Vec<usize> = coordinates(Method::LatinHypercube, 9, dimension, count)
                .into_iter()
                .map(|part| (part * count as f64) as usize)
                .collect();
            strata.sort_unstable();
            assert_eq!(strata, (0..count).collect::<Vec<_>>());
        }
    }
    let [one, other] = [0, 1].map(|dimension| coordinates(Method::LatinHypercube, 9, dimension, 200));
    assert_ne!(one, other);
}

/// The first points are those of the literature (Joe and Kuo 2008), in natural order.
#[test]
fn sobol_points_are_known_and_scrambling_keeps_their_evenness() {
    let known =
        [[0.0, 0.0, 0.0], [0.5, 0.5, 0.5], [0.25, 0.75, 0.75], [0.75, 0.25, 0.25], [0.125, 0.625, 0.375]];
    for (index, point) in known.into_iter().enumerate() {
        assert_eq!([0, 1, 2].map(|dimension| sobol(index as u32, dimension, None)), point, "{index}");
    }
    // In the first two dimensions, each elementary interval of the area 1/64 has one of 64 points.
    for seed in 0..20 {
        let [x, y] = [0, 1].map(|dimension| coordinates(Method::Sobol, seed, dimension, 64));
        for split in 0..=6 {
            let (columns, rows) = (1 << split, 64 >> split);
            let mut cells: Vec<usize> = x
                .iter()
                .zip(&y)
                .map(|(x, y)| (x * columns as f64) as usize * rows + (y * rows as f64) as usize)
                .collect();
            cells.sort_unstable();
            assert_eq!(cells, (0..64).collect::<Vec<_>>(), "seed {seed}, {columns} columns");
        }
    }
}

/// Squared centred L2 discrepancy of points (Hickernell 1998).
fn discrepancy(points: &[Vec<f64>]) -> f64 {
    let count = points[0].len();
    let deviation = |d: usize, i: usize| (points[d][i] - 0.5).abs();
    let product = |of: &dyn Fn(usize) -> f64| (0..points.len()).map(of).product::<f64>();
    let single: f64 =
        (0..count).map(|i| product(&|d| 1.0 + 0.5 * deviation(d, i) - 0.5 * deviation(d, i).powi(2))).sum();
    let double: f64 = (0..count * count)
        .map(|k| (k / count, k % count))
        .map(|(i, j)| {
            product(&|d| {
                let apart = (points[d][i] - points[d][j]).abs();
                1.0 + 0.5 * deviation(d, i) + 0.5 * deviation(d, j) - 0.5 * apart
            })
        })
        .sum();
    (13.0_f64 / 12.0).powi(points.len() as i32) - 2.0 / count as f64 * single
        + double / (count * count) as f64
}

#[test]
fn sobol_points_are_more_even_than_a_latin_hypercube_and_random_points() {
    let mean = |method: Method| {
        let points = |seed| (0..4).map(|d| coordinates(method, seed, d, 256)).collect::<Vec<_>>();
        (0..10).map(|seed| discrepancy(&points(seed))).sum::<f64>() / 10.0
    };
    let [sobol, hypercube, random] = [Method::Sobol, Method::LatinHypercube, Method::Random].map(mean);
    assert!(2.0 * sobol < hypercube && 2.0 * hypercube < random, "{sobol} {hypercube} {random}");
}

#[test]
fn the_same_seed_gives_the_same_points_and_more_samples_keep_the_earlier_ones() {
    for method in Method::ALL {
        let points = coordinates(method, 1, 3, 50);
        assert_eq!(points, coordinates(method, 1, 3, 50));
        assert_ne!(points, coordinates(method, 2, 3, 50));
        assert_ne!(points, coordinates(method, 1, 4, 50));
        assert!(points.iter().all(|part| *part > 0.0 && *part < 1.0));
        let more = coordinates(method, 1, 3, 80);
        assert_eq!(points == more[..50], method != Method::LatinHypercube, "{method:?}");
    }
    // Recorded once: another machine or version must give the same bits.
    let bits = Method::ALL.map(|method| coordinates(method, 1, 0, 4).last().map(|part| part.to_bits()));
    assert_eq!(bits, RECORDED.map(Some));
}

/// Bits of the fourth point of each method with seed 1.
const RECORDED: [u64; 3] = [4600251776070316024, 4599844662572744704, 4597070021082055684];

/// The sum of two standard normal params has known percentiles: the intervals contain them with the
/// stated probability, also for points that are more even than independent ones.
#[test]
fn intervals_of_all_methods_contain_known_percentiles() {
    const TRIALS: u64 = 200;
    let normal = Distribution::Normal { mean: 0.0, standard_deviation: 1.0 };
    let column = |name: &str| Column { name: name.into(), unit: String::new(), factor: 1.0, is_power: false };
    for method in Method::ALL {
        let (mut covered, mut width) = ([0; 3], 0.0);
        for seed in 0..TRIALS {
            let inputs = [0, 1].map(|dimension| coordinates(method, seed, dimension, 128));
            let mut table = SweepTable {
                params: vec![column("a"), column("b")],
                outputs: vec![column("sum")],
                sample: Some(Sample {
                    method,
                    seed,
                    count: 128,
                    distributions: vec![String::new(), String::new()],
                }),
                ..SweepTable::default()
            };
            for (a, b) in inputs[0].iter().zip(&inputs[1]) {
                let values = [normal.quantile(*a), normal.quantile(*b)];
                let statistics = Statistics { max: Some(values[0] + values[1]), ..Statistics::default() };
                let outputs = [("sum".to_owned(), statistics)].into();
                table.rows.push(Row { case: table.rows.len() + 1, outputs, ..Row::default() });
                table
                    .cases
                    .push(Case { name: String::new(), values: values.map(ParamValue::Number).to_vec() });
            }
            let found = groups(&table).swap_remove(0).variations.swap_remove(0);
            for (covered, k) in covered.iter_mut().zip([1, 2, 3]) {
                let known = 2f64.sqrt() * standard_normal_quantile(0.01 * PERCENTILES[k]);
                *covered += usize::from(found.percentiles[k].contains(known));
            }
            width += found.mean.high.unwrap_or(f64::INFINITY) - found.mean.low.unwrap_or(0.0);
        }
        // Three standard deviations of a share of 200 trials are 4.6 %.
        assert!(covered.iter().all(|count| *count as f64 / TRIALS as f64 > 0.9), "{method:?}: {covered:?}");
        assert!((width / TRIALS as f64 - 2.0 * 1.979 * (2.0 / 128.0_f64).sqrt()).abs() < 0.02);
    }
}
