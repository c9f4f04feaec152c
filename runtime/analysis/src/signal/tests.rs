//! Tests of signals against closed forms.

use super::*;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

fn sampled(count: usize, step: f64, mut value: impl FnMut(f64) -> f64) -> Uniform {
    Uniform { start: 0.0, step, values: (0..count).map(|k| value(k as f64 * step)).collect() }
}

#[test]
fn a_sine_on_a_line_shows_its_amplitude_and_its_phase_by_every_window() {
    let signal =
        sampled(400, 1e-3, |t| 0.7 + 2.5 * (TAU * 50.0 * t + 0.3).cos() + 0.2 * (TAU * 120.0 * t).sin());
    for (_, window) in Window::ALL {
        let spectrum = spectrum(&signal, window);
        assert!((spectrum.resolution - 2.5).abs() < 1e-12);
        assert!((spectrum.amplitudes[0] - 0.7).abs() < 1e-14);
        assert!((spectrum.amplitudes[20] - 2.5).abs() < 1e-12, "{window:?} {}", spectrum.amplitudes[20]);
        assert!((spectrum.phases[20] - 0.3).abs() < 1e-12);
        assert!((spectrum.amplitudes[48] - 0.2).abs() < 1e-12);
        assert!((spectrum.phases[48] + 0.5 * PI).abs() < 1e-11);
        assert!(spectrum.amplitudes[30] < 1e-12);
    }
}

#[test]
fn between_lines_a_flat_top_keeps_the_amplitude_and_peaks_keep_the_place() {
    for off in [0.0, 0.2, 0.5] {
        let frequency = (40.0 + off) * 2.5;
        let signal = sampled(400, 1e-3, |t| 3.0 * (TAU * frequency * t + 1.0).cos());
        let flat = spectrum(&signal, Window::FlatTop);
        let most = flat.amplitudes.iter().fold(0.0f64, |most, a| most.max(*a));
        assert!((most / 3.0 - 1.0).abs() < 2e-3, "{off} {most}");
        for (_, window) in Window::ALL {
            let found = peaks(&spectrum(&signal, window).amplitudes, 1, Shape::Sine(window))[0];
            // Leakage of the sine's negative frequency shifts the peak.
            let leaks = if window == Window::Rectangular { 0.01 } else { 1e-4 };
            assert!((found.line - 40.0 - off).abs() < leaks, "{window:?} {off} {found:?}");
            assert!((found.amplitude / 3.0 - 1.0).abs() < 2.0 * leaks, "{window:?} {off} {found:?}");
        }
    }
}

/// Parseval's theorem: the mean square equals that of the lines.
#[test]
fn no_power_is_lost() {
    for count in [255, 256] {
        let signal = sampled(count, 0.1, |t| (3.0 * t).sin() * (0.3 * t * t).cos() + 0.1 * t);
        let square = signal.values.iter().map(|value| value * value).sum::<f64>() / count as f64;
        let spectrum = spectrum(&signal, Window::Rectangular);
        let last = spectrum.amplitudes.len() - 1;
        let power = |(line, a): (usize, &f64)| match line {
            0 => a * a,
            line if line == last && count % 2 == 0 => a * a,
            _ => 0.5 * a * a,
        };
        let sum: f64 = spectrum.amplitudes.iter().enumerate().map(power).sum();
        assert!((sum / square - 1.0).abs() < 1e-12, "{sum} {square}");
    }
}

#[test]
fn an_average_shows_a_steady_sine_as_one_spectrum_does() {
    let signal = sampled(4000, 1e-3, |t| 2.0 * (TAU * 50.0 * t).sin());
    let averaged = averaged_spectrum(&signal, Window::Hann, 400, &Interrupt::never());
    let averaged = averaged.expect("nobody ends it").expect("it is long enough");
    assert!((averaged.amplitudes[20] - 2.0).abs() < 1e-12 && averaged.amplitudes.len() == 201);
}

#[test]
fn a_spectrogram_follows_a_rising_tone() {
    let signal = sampled(8000, 1e-3, |t| (TAU * (50.0 * t + 10.0 * t * t)).sin());
    let map = spectrogram(&signal, Window::Hann, 500, &Interrupt::never()).expect("nobody ends it");
    for (time, row) in map.times.iter().zip(&map.amplitudes) {
        let found = peaks(row, 1, Shape::Sine(Window::Hann))[0].line * map.frequencies[1];
        assert!((found - (50.0 + 20.0 * time)).abs() < 0.5, "{time} {found}");
    }
    // Pieces of 500 samples, each 62 after the last.
    assert!(map.times.len() == (8000 - 500) / 62 + 1);
}

/// The response of a long window to a sine is the window's own transform.
#[test]
fn a_window_answers_a_sine_as_it_does_a_long_one() {
    for (_, window) in Window::ALL {
        let weights = window.weights(20_000);
        let gain: f64 = weights.iter().sum();
        for off in [0.0, 0.3, 0.5, 1.0, 1.4, 2.0, 3.0] {
            // Transform at a distance from its centre.
            let turn = |(k, weight): (usize, &f64)| weight * (TAU * off * (k as f64 / 20_000.0 - 0.5)).cos();
            let seen = weights.iter().enumerate().map(turn).sum::<f64>() / gain;
            assert!((window.response(off).abs() - seen.abs()).abs() < 1e-6, "{window:?} {off}: {seen}");
        }
        let square: f64 = weights.iter().map(|weight| weight * weight).sum();
        assert!((window.noise_width() / (square * 20_000.0 / gain.powi(2)) - 1.0).abs() < 1e-12);
    }
}

/// Parseval's theorem for noise: the integral of the density is the mean square for any window and
/// any segments.
#[test]
fn a_density_of_noise_holds_its_mean_square() {
    let mut state = 1u64;
    let noise = sampled(1 << 14, 1e-3, |_| {
        // Knuth's multiplier.
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    });
    // Uniform between -1/2 and 1/2, all below half of the sampling rate.
    let expected = 1.0 / 12.0 / 500.0;
    for (_, window) in Window::ALL {
        for count in [256, 1025] {
            let spectrum = averaged_spectrum(&noise, window, count, &Interrupt::never());
            let spectrum = spectrum.expect("nobody ends it").expect("it is long enough");
            let density = spectrum.density(window);
            let mean = density[1..].iter().sum::<f64>() / (density.len() - 1) as f64;
            assert!((mean / expected - 1.0).abs() < 0.03, "{window:?} {count}: {mean} {expected}");
        }
    }
    let exact = spectrum(&noise, Window::Rectangular);
    let power: f64 = exact.density(Window::Rectangular).iter().sum::<f64>() * exact.resolution;
    let mean = noise.mean();
    let square = noise.values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / (1 << 14) as f64;
    assert!((power / square - 1.0).abs() < 1e-12, "{power} {square}");
}

/// Order 3.5 of a shaft in run-up remains on its line with its amplitude; over time it is a tone of
/// rising frequency.
#[test]
fn what_follows_a_shaft_stays_on_its_order() {
    let angle = |t: f64| TAU * (8.0 * t + 6.0 * t * t);
    let signal = sampled(12_000, 5e-4, |t| 1.5 * (3.5 * angle(t) + 0.2).cos() + 0.4 * angle(t).sin());
    let angles: Vec<f64> = (0..12_000).map(|k| -angle(k as f64 * 5e-4)).collect();
    let map =
        order_map(&signal, &angles, 8.0, 10.0, Window::Hann, &Interrupt::never()).expect("nobody ends it");
    assert!(map.speeds.len() > 20 && map.speeds.is_sorted(), "{}", map.speeds.len());
    assert!((map.orders[1] - 0.125).abs() < 1e-12 && map.orders.last().is_some_and(|last| *last <= 10.0));
    for row in &map.amplitudes {
        assert!((row[28] - 1.5).abs() < 3e-6 && (row[8] - 0.4).abs() < 3e-6, "{} {}", row[28], row[8]);
        assert!(row[50] < 3e-6);
    }
}

/// For any fraction of a revolution as a segment, integer orders have lines, and a sine on one
/// shows its amplitude.
#[test]
fn every_whole_order_has_a_line() {
    let angle = |t: f64| TAU * (8.0 * t + 6.0 * t * t);
    let signal = sampled(12_000, 5e-4, |t| (7.0 * angle(t)).cos());
    let angles: Vec<f64> = (0..12_000).map(|k| angle(k as f64 * 5e-4)).collect();
    for (revolutions, highest) in
        [(0.5, 10.3), (0.5, 81.0), (1.0, 10.0), (2.5, 33.0), (4.0 / 3.0, 20.0), (3.0, 12.0)]
    {
        let map = order_map(&signal, &angles, revolutions, highest, Window::Hann, &Interrupt::never());
        let map = map.expect("nobody ends it");
        let per_order = revolutions.ceil() as usize;
        for (line, order) in map.orders.iter().enumerate().step_by(per_order) {
            assert!((order - (line / per_order) as f64).abs() < 1e-9, "{revolutions} {highest} {order}");
        }
        assert!((map.orders.last().expect("lines") - highest.floor()).abs() < 1.0, "{revolutions} {highest}");
        for row in &map.amplitudes {
            // With half a revolution, leakage of the mean reaches it.
            let found = row[7 * per_order];
            assert!((found - 1.0).abs() < 2e-3, "{revolutions} {highest}: {found}");
        }
    }
}

#[test]
fn samples_at_angles_are_those_of_a_band_limited_signal() {
    let (angle, value) = (|t: f64| 30.0 * t + 0.5 * (3.0 * t).sin(), |t: f64| (TAU * 350.0 * t).sin());
    let signal = sampled(3000, 1e-3, value);
    let angles: Vec<f64> = (0..3000).map(|k| angle(k as f64 * 1e-3)).collect();
    let (by_angle, times) = resample_by_angle(&signal, &angles, 8.0, 1.0).expect("it turns");
    for (k, (sample, &time)) in by_angle.values.iter().zip(&times).enumerate() {
        let meant = by_angle.start + k as f64 * by_angle.step;
        assert!((angle(time) - meant).abs() < 1e-10, "{k}");
        assert!((sample - value(time)).abs() < 1e-6, "{k} {sample} {}", value(time));
    }
}

/// The impulse response of a damped oscillator is x = e^{-d t} sin(w t) / (m w), and its transfer
/// function is 1 / (m (w0² - W² + 2 i d W)).
#[test]
fn a_impulse_shows_the_transfer_function_of_an_oscillator() {
    let (mass, natural, damping) = (2.0, TAU * 100.0, 20.0);
    let damped = f64::sqrt(natural * natural - damping * damping);
    let momentum = -0.3;
    let signal = sampled(1 << 15, 2.5e-5, |t| {
        0.01 + momentum * (-damping * t).exp() * (damped * t).sin() / (mass * damped)
    });
    let found = transfer_function(&signal, 0.01, momentum);
    for line in [0, 40, 80, 100, 200, 500] {
        let at = TAU * found.frequency(line);
        let (real, imaginary) = (mass * (natural * natural - at * at), 2.0 * mass * damping * at);
        let (magnitude, phase) = (real.hypot(imaginary).recip(), -imaginary.atan2(real));
        // The sum over samples is an integral of second order in the step.
        let order = 0.1 * (at.max(natural) * signal.step).powi(2) + 1e-6;
        let ratio = found.magnitudes[line] / magnitude;
        assert!((ratio - 1.0).abs() < order, "{line} {ratio}");
        assert!((found.phases[line] - phase).abs() < order, "{line} {} {phase}", found.phases[line]);
    }
    let peak = peaks(&found.magnitudes, 1, Shape::Resonance)[0].line * found.resolution;
    assert!((peak - 100.0).abs() < 0.1 * found.resolution, "{peak}");
}

#[test]
fn what_is_not_uniform_is_refused() {
    let error = Uniform::of(&[0.0, 1.0, 2.0, 3.1], &[0.0; 4]).expect_err("refused");
    assert_eq!(error.code, "E0777");
    assert_eq!(Uniform::of(&[0.0, 1.0, 2.0], &[0.0; 3]).expect_err("refused").code, "E0776");
    assert!(Uniform::of(&[1e5, 1e5 + 1e-6, 1e5 + 2e-6, 1e5 + 3e-6], &[0.0; 4]).is_ok());
}

/// Evaluations of a signal of many segments, and of one whose lines exceed the memory, end with the
/// error of the interrupt.
#[test]
fn signals_end_when_somebody_asks_for_it() {
    let (count, step) = (4096, 1e-3);
    let values = (0..count).map(|k| (0.3 * k as f64).sin()).collect();
    let signal = Uniform { start: 0.0, step, values };
    let asked = Arc::new(AtomicUsize::new(0));
    // Fails at the third call.
    let interrupt = || {
        let asked = asked.clone();
        asked.store(0, Ordering::Relaxed);
        Interrupt::new(move || match asked.fetch_add(1, Ordering::Relaxed) {
            0 | 1 => Ok(()),
            _ => Err(EngineError::new("E0704", "it is enough", "")),
        })
    };
    let code = |error: EngineError| error.code;
    let spectrum = averaged_spectrum(&signal, Window::Hann, 8, &interrupt());
    assert_eq!(spectrum.map_err(code), Err("E0704"));
    assert_eq!(asked.load(Ordering::Relaxed), 3);
    assert_eq!(spectrogram(&signal, Window::Hann, 8, &interrupt()).map_err(code), Err("E0704"));
    assert_eq!(asked.load(Ordering::Relaxed), 3);
    // The shaft rotates by a thousandth of a revolution in total, so a revolution has very many
    // lines.
    let angles: Vec<f64> = (0..count).map(|k| 1e-3 * TAU * k as f64 / count as f64).collect();
    let small = Interrupt::counting(|wanted| match wanted.bytes {
        bytes if bytes > 100_000_000 => Err(EngineError::new("E0707", "it is too much", "")),
        _ => Ok(()),
    });
    let map = order_map(&signal, &angles, 1e-5, 1e6, Window::Hann, &small);
    assert_eq!(map.map(|map| map.speeds.len()).map_err(code), Err("E0707"));
}
