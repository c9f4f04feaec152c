//! Tests of sampling errors against functions with known extremes and means, and of sums of parts.

use super::*;
use calyx_model::observed::Observed;
use calyx_model::position::Position;
use std::borrow::Cow;
use std::f64::consts::TAU;

/// Rows of one output at fractions of a cycle, some of them named.
fn rows(at: &[(f64, &'static str)], value: impl Fn(f64) -> f64) -> Vec<StepRow> {
    let row = |&(cycle, name): &(f64, &'static str)| StepRow {
        position: Position { time: 1.0 + 2.0 * cycle, cycle, roll: 0.3 + cycle, name: Cow::Borrowed(name) },
        outputs: vec![Observed::number(value(cycle))],
        warnings: Vec::new(),
    };
    at.iter().map(row).collect()
}

fn uniform(count: usize) -> Vec<(f64, &'static str)> {
    (0..count).map(|k| (k as f64 / count as f64, "")).collect()
}

/// Returns the estimate over a closed cycle, and the true errors of the largest value and of the
/// mean.
fn estimated_and_true(
    at: &[(f64, &'static str)],
    largest: f64,
    mean: f64,
    value: impl Fn(f64) -> f64,
) -> (Statistics, [f64; 2]) {
    let rows = rows(at, value);
    let course = SamplingContext::of(&rows, Some(0)).expect("it goes somewhere");
    let values = ends(&rows, 0);
    let found = values.iter().map(|end| end.high).fold(f64::NEG_INFINITY, f64::max);
    let sum: f64 = (0..at.len())
        .map(|i| {
            let (before, after) = (
                at[(i + at.len() - 1) % at.len()].0 - if i == 0 { 1.0 } else { 0.0 },
                at[(i + 1) % at.len()].0 + if i + 1 == at.len() { 1.0 } else { 0.0 },
            );
            0.5 * (after - before) * values[i].value
        })
        .sum();
    (course.errors(&values, (&course, &values), true).size, [largest - found, (mean - sum).abs()])
}

#[test]
fn a_smooth_extreme_between_positions_is_seen() {
    for (count, shift) in [(16, 0.03), (16, 0.015), (32, 0.0156), (32, 0.007), (64, 0.005)] {
        let wave = |x: f64| 3.0 + (TAU * (x - shift)).cos() + 0.2 * (2.0 * TAU * x).sin();
        let fine = (0..100_000).map(|k| wave(k as f64 / 1e5));
        let largest = fine.fold(f64::NEG_INFINITY, f64::max);
        let (errors, [of_max, _]) = estimated_and_true(&uniform(count), largest, 3.0, wave);
        // The parabola differs slightly from the curve.
        let room = 4.0 / (count * count) as f64;
        assert!(errors.max < 2.5 * of_max + room, "{count}: {} for {of_max}", errors.max);
        assert!(errors.max > 0.4 * of_max - room, "{count}: {} for {of_max}", errors.max);
    }
}

#[test]
fn an_extreme_where_slopes_jump_is_seen() {
    // A tent with a rounded foot, whose tip lies anywhere between two of 20 positions.
    for part in [0.1, 0.3, 0.5, 0.7, 0.9] {
        let tip = (7.0 + part) / 20.0;
        let tent = |x: f64| 1.0 - 4.0 * (x - tip).abs() + 2.0 * (x - tip).powi(2);
        let (errors, [of_max, _]) = estimated_and_true(&uniform(20), 1.0, 0.0, tent);
        let effectivity = errors.max / of_max;
        assert!((0.7..1.3).contains(&effectivity), "{part}: {effectivity}");
    }
}

/// Estimate from the positions, and with `more` positions in the most promising intervals, relative
/// to the true excess over the positions.
fn measured(at: &[(f64, &'static str)], more: usize, course: impl Fn(f64) -> f64 + Copy) -> [f64; 2] {
    let found = rows(at, course);
    let largest = (0..100_000).map(|k| course(k as f64 / 1e5)).fold(f64::NEG_INFINITY, f64::max);
    let own = SamplingContext::of(&found, Some(0)).expect("it goes somewhere");
    let values = ends(&found, 0);
    let most = values.iter().map(|end| end.high).fold(f64::NEG_INFINITY, f64::max);
    let mut all = found.clone();
    for turn in 0..more {
        let course_of = SamplingContext::of(&all, Some(0)).expect("it goes somewhere");
        let bounds = [f64::NEG_INFINITY, f64::INFINITY];
        let known =
            [sampling::SampledOutput { course: &course_of, ends: ends(&all, 0), closed: true, bounds }];
        let promising = sampling::most_promising(&known, own.average(), turn);
        let place = sampling::divided(&all, promising[0]).cycle;
        all.extend(rows(&[(place, "")], course));
        all.sort_by(|a, b| a.position.cycle.total_cmp(&b.position.cycle));
    }
    let finer = SamplingContext::of(&all, Some(0)).expect("it goes somewhere");
    [own.errors(&values, (&own, &values), true), own.errors(&values, (&finer, &ends(&all, 0)), true)]
        .map(|errors| errors.size.max / (largest - most))
}

/// Load is taken up inside an interval and levels off before the next position: extrapolation shows
/// little of it, positions inside the interval do.
#[test]
fn what_begins_and_ends_between_positions_is_measured() {
    let taken_up = |x: f64| ((x - 0.31) / 0.01).max(0.0);
    let wave = |x: f64| 1.0 + 0.2 * (TAU * (x - 0.31)).cos();
    let course = |x: f64| wave(x) + 0.3 * taken_up(x) * (-taken_up(x)).exp();
    let [missed, effectivity] = measured(&uniform(20), 4, course);
    assert!(missed < 0.5, "{missed}");
    assert!((0.8..1.5).contains(&effectivity), "{effectivity}");
}

/// The load share of a tooth pair is one while no other pair carries load. Its maximum has no error
/// if three positions lie on that plateau, although it changes quickly next to it.
#[test]
fn an_extreme_on_a_plateau_has_no_error() {
    for shift in [0.0, 0.03, 0.06, 0.09] {
        let share = |x: f64| {
            let passed = (x + shift).rem_euclid(1.0);
            let entering = 0.45 + 0.1 * (TAU * 2.0 * passed).sin() + 4.0 * (passed - 0.35).max(0.0).powi(2);
            if passed > 0.9 { 9.0 * (1.0 - passed) } else { entering + 4.0 * (passed - 0.5).max(0.0) }
                .min(1.0)
        };
        let (errors, [of_max, _]) = estimated_and_true(&uniform(10), 1.0, 0.0, share);
        assert_eq!(of_max, 0.0);
        assert!(errors.max < 1e-9, "{shift}: {}", errors.max);
        assert!(errors.min > 1e-3, "{shift}: {}", errors.min);
    }
}

/// The largest root stress of a gear rises slowly behind a kink, and another tooth takes over in
/// the next interval. The parabola through the position before the kink would hide the rise.
#[test]
fn a_kink_behind_another_kink_is_seen() {
    let stress = |x: f64| match x {
        x if x < 0.15 => 86.2 - 200.0 * x,
        x if x < 0.775 => (96.0 - 170.0 * (0.775 - x)).max(56.2),
        x if x < 0.93 => 96.0 + 27.0 * (x - 0.775),
        x => 100.185 - 200.0 * (x - 0.93),
    };
    let at = [0.0, 0.1, 0.2, 0.4, 0.55, 0.7143, 0.8214, 0.839, 0.8571, 0.9643].map(|x| (x, ""));
    let (errors, [of_max, _]) = estimated_and_true(&at, 100.185, 0.0, stress);
    let effectivity = errors.max / of_max;
    assert!((0.45..1.5).contains(&effectivity), "{effectivity}");
}

/// Largest root stress of a gear whose most stressed tooth changes between two positions, with
/// another kink close to the next position.
#[test]
fn a_minimum_where_the_most_stressed_tooth_changes_is_measured() {
    const STRESS: [[f64; 2]; 11] = [
        [0.0, 2.384],
        [0.125, 1.80],
        [0.25, 1.478],
        [0.333, 1.46],
        [0.4167, 1.445],
        [0.5, 1.26],
        [0.53, 1.135],
        [0.6, 1.46],
        [0.6667, 1.888],
        [0.683, 1.945],
        [1.0, 2.384],
    ];
    let below = |x: f64| {
        let next = STRESS.iter().position(|point| point[0] >= x).unwrap_or(1).max(1);
        let [[from, one], [to, other]] = [STRESS[next - 1], STRESS[next]];
        -one - (x - from) / (to - from) * (other - one)
    };
    let mut at = uniform(6);
    at.extend([(0.6835, "EAP"), (0.6835 + 2e-6, "LPSTC")]);
    at.sort_by(|a, b| a.0.total_cmp(&b.0));
    for more in [2, 3, 4] {
        let [_, effectivity] = measured(&at, more, below);
        assert!((0.6..1.5).contains(&effectivity), "{more}: {effectivity}");
    }
}

/// A tooth pair takes up load just after a named position, and others lose it as quickly: the
/// middle of the interval is far too late.
#[test]
fn what_happens_close_to_a_name_is_measured() {
    for width in [0.01, 0.02, 0.03] {
        let bump = |x: f64| {
            let passed = x / width;
            if passed < 1.0 { passed } else { 0.8 }
        };
        let course = |x: f64| 1.0 + 0.1 * bump(x) + 0.05 * (TAU * x).sin();
        let mut at = uniform(10);
        at[0] = (1e-6, "A");
        at.push((1.0 - 1e-6, "B"));
        let [_, effectivity] = measured(&at, 5, course);
        assert!((0.5..2.0).contains(&effectivity), "{width}: {effectivity}");
    }
}

/// A closed curve continues after the last position with the first of the next cycle.
#[test]
fn a_cycle_is_halved_round_its_end() {
    let found = rows(&uniform(4), |_| 1.0);
    let middle = sampling::divided(&found, sampling::Promising { interval: 3, kink: None, event: None });
    assert_eq!((middle.cycle, middle.time), (0.875, 2.75));
    assert!((middle.roll - 1.175).abs() < 1e-15);
}

/// Elastic teeth do not jump where rigid ones would: a maximum just after such a pair of positions
/// shows from both sides.
#[test]
fn what_follows_two_positions_at_one_place_is_seen() {
    for part in [0.02, 0.1, 0.2] {
        let tip = 0.5 + part / 8.0;
        let tent = |x: f64| if x < tip { 1.0 - 3.0 * (tip - x) } else { 1.0 - 0.5 * (x - tip) };
        let mut at = uniform(8);
        at.extend([(0.4925, "A"), (0.4925 + 1e-7, "B")]);
        at.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (errors, [of_max, _]) = estimated_and_true(&at, 1.0, 0.0, tent);
        assert!((0.7..1.5).contains(&(errors.max / of_max)), "{part}: {} for {of_max}", errors.max);
    }
}

#[test]
fn jumps_that_positions_enclose_are_no_error() {
    // The output falls from 2 to 1 at 0.3 and back at 0.7, with positions on both sides of each
    // jump.
    let mut at = uniform(10);
    at.retain(|(cycle, _)| ![0.3, 0.7].contains(cycle));
    at.extend([(0.3 - 1e-6, "A"), (0.3 + 1e-6, "B"), (0.7 - 1e-6, "C"), (0.7 + 1e-6, "D")]);
    at.sort_by(|a, b| a.0.total_cmp(&b.0));
    let step = |x: f64| if (0.3..0.7).contains(&x) { 1.0 } else { 2.0 } + 0.1 * x;
    // Open curve: it has risen by 0.1 at the end of the cycle.
    let rows = rows(&at, step);
    let course = SamplingContext::of(&rows, Some(0)).expect("it goes somewhere");
    let values = ends(&rows, 0);
    let errors = course.errors(&values, (&course, &values), false).size;
    assert!(errors.max < 1e-9 && errors.min < 1e-9 && errors.mean < 1e-9, "{errors:?}");
}

#[test]
fn the_mean_of_a_kinked_course_is_seen() {
    for part in [0.0, 0.15, 0.5, 0.85] {
        let kink = (3.0 + part) / 16.0;
        // A rectified sine wave with mean 2 / pi.
        let wave = |x: f64| (0.5 * TAU * (x - kink)).sin().abs();
        let (errors, [_, of_mean]) = estimated_and_true(&uniform(16), 1.0, 2.0 / std::f64::consts::PI, wave);
        let effectivity = errors.mean / of_mean;
        assert!((0.3..6.0).contains(&effectivity), "{part}: {effectivity}");
    }
}

/// Between two kinks, every parabola through positions on one side alone passes a kink and bends
/// away. Both parabolas meet then far from the history, which is smooth there.
#[test]
fn a_smooth_interval_between_two_kinks_has_a_small_error() {
    let top = |x: f64| 1.0 - 2.0 * (x - 0.475).powi(2);
    let history = |x: f64| match x {
        x if (0.4..=0.55).contains(&x) => top(x),
        x if x < 0.4 => top(0.4) - 4.0 * (0.4 - x).min(0.15),
        x => top(0.55) - 4.0 * (x - 0.55).min(0.15),
    };
    let found = rows(&uniform(20), |x| history((1e9 * x).round() / 1e9));
    let values: Vec<f64> = ends(&found, 0).iter().map(|end| end.value).collect();
    let course = SamplingContext::of(&found, Some(0)).expect("it goes somewhere");
    let exact = (0..100_000).map(|k| history(k as f64 / 1e5)).sum::<f64>() / 1e5;
    let (area, above_chords) = (course.area(&values, true), exact - course.chords(&values, true));
    assert!((area - above_chords).abs() < 2.0 * above_chords, "{area} for {above_chords}");
}

#[test]
fn rows_that_go_nowhere_say_nothing_of_what_lies_between() {
    let one = rows(&uniform(1), |_| 1.0);
    assert!(SamplingContext::of(&one, Some(0)).is_none());
    let mut twice = rows(&uniform(2), |_| 1.0);
    twice[1].position = twice[0].position.clone();
    assert!(SamplingContext::of(&twice, Some(0)).is_none());
}

#[test]
fn parts_add_up_but_for_the_mesh_that_the_level_above_includes() {
    let all = |error: f64| -> DirectedErrors {
        Statistics { min: error, max: 2.0 * error, mean: 0.5 * error, peak_to_peak: error }.into()
    };
    let parts = vec![
        (Part::Discretization, all(1.0)),
        (Part::ContactGrid, all(0.25)),
        (Part::Positions, all(0.5)),
        (Part::Level, all(3.0)),
    ];
    let estimate = ErrorEstimate::new(parts, Vec::new(), 0.0);
    assert_eq!(estimate.total, all(3.25).size);
}

/// Errors of opposite directions compensate each other in part, because their sizes are uncertain;
/// those of unknown direction are added in quadrature, but not if both change the solution.
#[test]
fn parts_of_opposite_directions_do_not_add_up() {
    let all = |error: f64| Statistics { min: error, max: error, mean: error, peak_to_peak: error };
    let total = |parts: [(f64, f64); 2]| {
        let parts = [Part::ContactGrid, Part::Positions].into_iter().zip(parts);
        let errors = |(size, directed)| DirectedErrors::new(all(size), all(directed));
        ErrorEstimate::new(parts.map(|(part, own)| (part, errors(own))).collect(), Vec::new(), 0.0).total.max
    };
    // Root mean square of a sum whose terms are uncertain by half of themselves.
    let of_sum =
        |one: f64, other: f64| (((one + other).powi(2) + 0.25 * (one * one + other * other)) / 1.25).sqrt();
    assert_eq!(total([(4.0, 4.0), (1.0, 1.0)]), of_sum(4.0, 1.0));
    assert_eq!(total([(4.0, 4.0), (1.0, -1.0)]), of_sum(4.0, -1.0));
    assert_eq!(total([(4.0, -4.0), (5.0, 5.0)]), 3.0);
    assert_eq!(total([(4.0, 4.0), (0.0, 0.0)]), 4.0);
    assert_eq!(total([(4.0, 0.0), (3.0, -3.0)]), 5.0);
    assert_eq!(total([(4.0, 0.0), (3.0, 0.0)]), 5.0);
    // Most of the error has no direction.
    assert_eq!(total([(4.0, 2.0), (3.0, -3.0)]), 5.0);
    let solution = [Part::Discretization, Part::ContactGrid].map(|part| (part, all(2.0).into()));
    assert_eq!(ErrorEstimate::new(solution.to_vec(), Vec::new(), 0.0).total.max, 4.0);
}

/// A larger error at a position between those of the run replaces the one at them.
#[test]
fn errors_at_added_extremes_replace_smaller_ones() {
    let all = |error: f64| Statistics { min: error, max: error, mean: error, peak_to_peak: error };
    let found = DirectedErrors::new(all(2.0), all(2.0));
    let signed = Statistics { min: -1.0, max: -3.0, mean: 0.0, peak_to_peak: -2.0 };
    let expected = DirectedErrors {
        size: Statistics { max: 3.0, ..all(2.0) },
        direction: Statistics { max: -1.0, ..all(1.0) },
    };
    assert_eq!(found.at_least(signed), expected);
}

/// An output that jumps twice between positions: parabolas through points behind the jumps would
/// hide from the mean how wide the dip is.
#[test]
fn the_mean_of_a_course_that_jumps_is_seen() {
    let dip = |x: f64| if (0.803..0.897).contains(&x) { 2.24 } else { 3.5 - 0.8 * (x - 0.35).powi(2) };
    let at: Vec<(f64, &'static str)> =
        [0.0, 0.04, 0.1667, 0.3333, 0.5, 0.6667, 0.7031, 0.7356, 0.8333, 0.8493, 0.8646, 0.9583]
            .map(|x| (x, ""))
            .to_vec();
    let own: Vec<(f64, &'static str)> = uniform(6);
    let [own, known] = [own, at].map(|at| rows(&at, dip));
    let course = |rows: &[StepRow]| SamplingContext::of(rows, Some(0)).expect("it goes somewhere");
    let errors = course(&own).errors(&ends(&own, 0), (&course(&known), &ends(&known, 0)), true).size;
    let mean = (0..100_000).map(|k| dip(k as f64 / 1e5)).sum::<f64>() / 1e5;
    let found = ends(&own, 0).iter().map(|end| end.value).sum::<f64>() / 6.0;
    let effectivity = errors.mean / (mean - found).abs();
    assert!((0.5..3.0).contains(&effectivity), "{effectivity}");
}

/// A value counts as rounding only if its error does too.
#[test]
fn rounding_has_no_part_that_is_wrong_and_hides_no_error() {
    let of = |value: f64, error: f64| {
        let summary = OutputSummary { min: -value, max: value, mean: 0.0, ..OutputSummary::none() };
        let error = Statistics { min: error, max: error, mean: error, peak_to_peak: error };
        let estimate = ErrorEstimate::new(vec![(Part::ContactGrid, error.into())], Vec::new(), 1e-12);
        (estimate.is_rounding(&summary), estimate.relative(&summary))
    };
    assert_eq!(of(1e-14, 5e-15), (true, None));
    assert_eq!(of(1e-14, 1e-6), (false, None));
    assert_eq!(of(1e-4, 1e-6), (false, Some(1e-6 / 1e-4)));
    assert_eq!(of(0.0, 0.0), (false, Some(0.0)));
    let unknown = ErrorEstimate::new(Vec::new(), Vec::new(), 0.0);
    assert_eq!(unknown.relative(&OutputSummary { min: 1.0, max: 1.0, ..OutputSummary::none() }), None);
}
