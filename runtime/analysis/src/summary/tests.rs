//! Tests of summaries of known signals.

use super::*;
use crate::observables::{Equilibrium, Observable, Quantity};
use crate::scene::Scene;
use calyx_model::observed::Observed;
use calyx_model::position::Position;
use std::borrow::Cow;
use std::f64::consts::PI;

/// Observable without an engine.
#[derive(Debug, PartialEq)]
struct Signal(Quantity);

impl Observable for Signal {
    fn quantity(&self) -> Quantity {
        self.0
    }

    fn value(&self, _: &Equilibrium<'_>) -> Observed {
        Observed::number(f64::NAN)
    }
}

/// Positions of a mesh cycle: uniform ones, and both sides of two jumps.
fn cycle() -> Vec<f64> {
    let mut at: Vec<f64> = (1..24).map(|i| f64::from(i) / 24.0).collect();
    at.extend([1e-6, 0.61 - 1e-6, 0.61 + 1e-6, 1.0 - 1e-6]);
    at.sort_by(f64::total_cmp);
    at
}

fn summary(quantity: Quantity, at: &[f64], signal: impl Fn(f64) -> Observed) -> OutputSummary {
    let mut scene = Scene::default();
    let request = OutputRequest::observing("signal", scene.add_observable(Signal(quantity)));
    let row = |&cycle: &f64| StepRow {
        position: Position { time: 3.0 + 0.2 * cycle, cycle, roll: 0.0, name: Cow::Borrowed("") },
        outputs: vec![signal(cycle)],
        warnings: Vec::new(),
    };
    let rows: Vec<StepRow> = at.iter().map(row).collect();
    summarize(&rows, &[request], &scene).remove(0)
}

#[test]
fn harmonics_of_a_known_signal_are_found() {
    let waves = [(1, 0.7, 0.4), (2, 0.2, -2.9), (4, 0.05, 1.7)];
    let signal = |cycle: f64| {
        let wave = |&(order, amplitude, phase): &(i32, f64, f64)| {
            amplitude * (TAU * f64::from(order) * cycle + phase).cos()
        };
        Observed::number(5.0 + waves.iter().map(wave).sum::<f64>())
    };
    for at in [cycle(), (0..11).map(|i| f64::from(i) / 11.0).collect()] {
        let found = summary(Quantity::repeating("signal", "m"), &at, signal);
        assert_eq!(found.harmonics.len(), 5);
        for harmonic in &found.harmonics {
            let expected = waves.iter().find(|wave| wave.0 as usize == harmonic.order);
            let (_, amplitude, phase) = expected.copied().unwrap_or((0, 0.0, harmonic.phase));
            assert!((harmonic.amplitude - amplitude).abs() < 1e-12, "{harmonic:?}");
            assert!((harmonic.phase - phase).abs() < 1e-11, "{harmonic:?}");
        }
        // The mean of a wave over uniform positions is exact; the positions next to the jump have
        // weights by their distances.
        assert!((found.mean - 5.0).abs() < 2e-3, "{}", found.mean);
    }
}

#[test]
fn as_many_harmonics_are_told_as_positions_can_tell() {
    let of = |count: i32| {
        let at: Vec<f64> = (0..count).map(|i| f64::from(i) / f64::from(count)).collect();
        summary(Quantity::repeating("signal", "m"), &at, |cycle| Observed::number((TAU * cycle).sin()))
    };
    assert_eq!([2, 3, 4, 5, 10, 11, 12].map(|count| of(count).harmonics.len()), [0, 1, 1, 2, 4, 5, 5]);
    let [first, ..] = of(3).harmonics[..] else { panic!("there is a first harmonic") };
    assert!((first.amplitude - 1.0).abs() < 1e-14 && (first.phase + 0.5 * PI).abs() < 1e-14);
}

/// Few positions, most of them close together: harmonics through all of them would be many times
/// too large.
#[test]
fn positions_that_stand_together_tell_fewer_harmonics() {
    let at = [0.0, 0.03, 0.06, 0.5, 0.53];
    let found = summary(Quantity::repeating("signal", "m"), &at, |cycle| {
        Observed::number((TAU * cycle).cos() + 0.3 * (TAU * 11.0 * cycle).sin())
    });
    for harmonic in &found.harmonics {
        assert!(harmonic.amplitude < found.peak_to_peak, "{harmonic:?} of {}", found.peak_to_peak);
    }
}

#[test]
fn means_are_over_the_closed_cycle_where_it_repeats() {
    // A ramp: a repeating quantity returns between the last position and the next cycle, a passing
    // one does not.
    let at = [0.0, 0.25, 0.5, 0.75];
    let of = |quantity| summary(quantity, &at, Observed::number);
    let repeating = of(Quantity::repeating("signal", "m"));
    assert!((repeating.mean - 0.375).abs() < 1e-15);
    let passing = of(Quantity::passing("signal", "m"));
    assert!((passing.mean - 0.375).abs() < 1e-15 && passing.harmonics.is_empty());
    // Weighted by the fractions that the positions represent: three quarters of the cycle belong to
    // 0 and 0.5.
    let uneven = summary(Quantity::repeating("signal", "m"), &[0.0, 0.5, 0.75], Observed::number);
    assert!((uneven.mean - (0.375 * 0.0 + 0.375 * 0.5 + 0.25 * 0.75)).abs() < 1e-15);
    let passing = summary(Quantity::passing("signal", "m"), &[0.0, 0.5, 0.75], Observed::number);
    assert!((passing.mean - 0.375).abs() < 1e-15);
}

#[test]
fn a_range_reaches_from_the_least_of_all_to_the_largest_of_all() {
    let found = summary(Quantity::repeating("signal", "Pa"), &cycle(), |cycle| Observed {
        least: Some(-2.0 - cycle),
        ..Observed::number(1.0 + (TAU * cycle).sin())
    });
    assert!((found.min + 3.0).abs() < 1e-5 && (found.max - 2.0).abs() < 1e-12);
    assert_eq!(found.peak_to_peak, found.max - found.min);
}

#[test]
fn positions_that_are_no_cycle_have_no_harmonics() {
    let quantity = Quantity::repeating("signal", "m");
    for at in [&[0.0][..], &[0.0, 0.0, 0.0], &[0.0, 0.1, 0.2], &[]] {
        assert!(summary(quantity, at, Observed::number).harmonics.is_empty(), "{at:?}");
    }
}
