//! Tests of the statistics of a sample against closed forms.

use super::group::groups;
use super::sensitivity::Sensitivities;
use super::statistics::{PERCENTILES, mean, percentile, standard_deviation};
use super::{Method, Sample, Statistic, files, text};
use crate::sweep::{Case, Column, Row, Statistics, SweepTable};
use calyx_abi::description::ParamValue;
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// The generator SplitMix64 (Steele, Lea and Flood 2014).
struct Random(u64);

impl Random {
    /// Returns a uniform number between 0 and 1 without both ends.
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (((z ^ (z >> 31)) >> 12) as f64 + 0.5) / 2f64.powi(52)
    }
}

/// Of an exponential distribution, whose percentiles, mean 1 and deviation 1 are known, at least
/// 95 % of the intervals of percentiles contain the true value. Those of mean and deviation are
/// asymptotic and nearly have this probability for a skew distribution.
#[test]
fn intervals_have_their_stated_coverage() {
    const TRIALS: usize = 1000;
    let mut random = Random(1);
    let mut covered = [0; PERCENTILES.len() + 2];
    for _ in 0..TRIALS {
        let mut sample: Vec<f64> = (0..200).map(|_| -random.next().ln()).collect();
        sample.sort_by(f64::total_cmp);
        for (k, percent) in PERCENTILES.into_iter().enumerate() {
            let known = -(1.0 - 0.01 * percent).ln();
            covered[k] += usize::from(percentile(&sample, percent).contains(known));
        }
        covered[PERCENTILES.len()] += usize::from(mean(&sample).contains(1.0));
        covered[PERCENTILES.len() + 1] += usize::from(standard_deviation(&sample).contains(1.0));
    }
    // Three standard deviations of a share of 1000 trials are 2 %.
    let share = covered.map(|count| count as f64 / TRIALS as f64);
    assert!(share[..5].iter().all(|share| *share > 0.93), "{share:?}");
    assert!(share[5] > 0.92 && share[6] > 0.90 && share[6] < 0.99, "{share:?}");
    // The intervals are not wider than necessary.
    assert!(share[1..4].iter().all(|share| *share < 0.985), "{share:?}");
}

fn inputs(random: &mut Random, params: usize, count: usize) -> Vec<Vec<f64>> {
    (0..params).map(|_| (0..count).map(|_| random.next()).collect()).collect()
}

/// y = 3 a + 2 b - c of uniform variables has the indices 9/14, 4/14 and 1/14.
#[test]
fn indices_of_a_linear_function_are_its_squared_coefficients() {
    const TRIALS: usize = 200;
    let mut random = Random(2);
    let mut covered = [0; 3];
    for _ in 0..TRIALS {
        let x = inputs(&mut random, 3, 300);
        let y: Vec<f64> = (0..300).map(|k| 3.0 * x[0][k] + 2.0 * x[1][k] - x[2][k]).collect();
        let all = Sensitivities::of(&x, &y).expect("enough samples");
        for (k, known) in [9.0 / 14.0, 4.0 / 14.0, 1.0 / 14.0].into_iter().enumerate() {
            covered[k] += usize::from(all.params[k].first_order.contains(known));
            assert!((all.params[k].first_order.value - known).abs() < 0.17);
            let rank = all.params[k].rank_coefficient.value;
            assert!((rank.abs() - known.sqrt()).abs() < 0.09, "{rank} {known}");
        }
        assert!(all.params[2].rank_coefficient.high.is_some_and(|high| high < 0.0));
        assert!(all.rank_r2 > 0.95 && !all.uncertain && all.order() == [0, 1, 2]);
    }
    assert!(covered.iter().all(|count| *count as f64 / TRIALS as f64 > 0.91), "{covered:?}");
}

/// The function of Ishigami and Homma (1990) with a = 7 and b = 0.1 has the first-order indices
/// 0.3139, 0.4424 and 0; the rest of the variance is an interaction.
#[test]
fn indices_of_the_ishigami_function_are_those_of_the_literature() {
    let mut random = Random(3);
    let x: Vec<Vec<f64>> = inputs(&mut random, 3, 4000)
        .into_iter()
        .map(|values| values.into_iter().map(|u| PI * (2.0 * u - 1.0)).collect())
        .collect();
    let f = |k: usize| x[0][k].sin() + 7.0 * x[1][k].sin().powi(2) + 0.1 * x[2][k].powi(4) * x[0][k].sin();
    let y: Vec<f64> = (0..4000).map(f).collect();
    let all = Sensitivities::of(&x, &y).expect("enough samples");
    for (param, known) in all.params.iter().zip([0.3139, 0.4424, 0.0]) {
        assert!((param.first_order.value - known).abs() < 0.02, "{:?}", param.first_order);
        assert!(param.first_order.contains(known), "{:?}", param.first_order);
    }
    // Ranks do not show the second one, which is not monotonic.
    assert!(all.params[1].rank_coefficient.value.abs() < 0.05 && all.rank_r2 < 0.5);
}

#[test]
fn what_cannot_be_explained_is_reported() {
    let mut random = Random(4);
    let x = inputs(&mut random, 2, 12);
    assert!(Sensitivities::of(&x, &[3.0; 12]).expect_err("constant").contains("does not vary"));
    let y: Vec<f64> = x[0].clone();
    let few: Vec<Vec<f64>> = x.iter().map(|values| values[..4].to_vec()).collect();
    assert!(Sensitivities::of(&few, &y[..4]).expect_err("few").contains("4 samples are too few"));
    let twice = [x[0].clone(), x[0].clone()];
    assert!(Sensitivities::of(&twice, &y).expect_err("equal").contains("depends linearly"));
    assert!(Sensitivities::of(&x, &y).expect("enough").uncertain);
}

/// A sample at two values of another param, of which one case failed.
fn table() -> SweepTable {
    let column = |name: &str, unit: &str| Column {
        name: name.into(),
        unit: unit.into(),
        factor: 1.0,
        is_power: false,
    };
    let mut random = Random(5);
    let mut table = SweepTable {
        params: vec![column("torque", "N*m"), column("slope", "m")],
        outputs: vec![column("stress", "Pa")],
        sample: Some(Sample {
            method: Method::Random,
            seed: 5,
            count: 40,
            distributions: vec!["uniform(0..1)".into()],
        }),
        ..SweepTable::default()
    };
    for torque in [10.0, 20.0] {
        for _ in 0..40 {
            let slope = random.next();
            let stress = Some(torque * (1.0 + slope));
            let statistics = Statistics { min: stress, mean: stress, max: stress, ..Statistics::default() };
            let case = table.rows.len() + 1;
            let failure = (case == 50).then(|| "too steep".to_owned());
            let outputs = BTreeMap::from([("stress".to_owned(), statistics)]);
            table.rows.push(Row { case, failure, outputs, ..Row::default() });
            let values = [torque, slope].map(ParamValue::Number).to_vec();
            table.cases.push(Case { name: String::new(), values });
        }
    }
    table
}

#[test]
fn each_combination_of_the_other_axes_has_its_statistics() {
    let table = table();
    let groups = groups(&table);
    assert_eq!(
        groups.iter().map(|group| (group.solved, group.failed)).collect::<Vec<_>>(),
        [(40, 0), (39, 1)]
    );
    assert_eq!(groups[1].label(&table), "torque = 20 N*m");
    let largest = groups[1].variations.iter().find(|variation| variation.statistic == Statistic::Max);
    let largest = largest.expect("a variation");
    assert!(largest.mean.contains(30.0) && largest.sorted.len() == 39);
    let explained = largest.sensitivities.as_ref().expect("enough samples");
    assert!(explained.params[0].first_order.value > 0.999, "{explained:?}");
    let shown = text(&table, &groups);
    assert!(shown.contains("torque = 20 N*m: 39 samples, without 1 failed"), "{shown}");
    assert!(shown.contains("slope 100 %"), "{shown}");

    let folder = tempfile::tempdir().expect("a folder");
    let written = |write: fn(&std::path::Path, &SweepTable, &[super::Group]) -> std::io::Result<()>| {
        let path = folder.path().join("file.csv");
        write(&path, &table, &groups).expect("written");
        std::fs::read_to_string(path).expect("a file")
    };
    let statistics = written(files::write_statistics);
    let head = "torque [N*m],output,statistic,unit,quantity,value,low,high,samples,failed\n";
    assert!(statistics.starts_with(head), "{statistics}");
    assert!(statistics.contains("\n20,stress,max,Pa,percentile_1,"), "{statistics}");
    let explained = written(files::write_explained_variation);
    assert!(explained.contains("\n10,stress,mean,slope,"), "{explained}");
}
