//! Where a spectrum has its peaks, between its lines too.

use super::Window;

/// A peak.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// Place, in lines from the first one: times the resolution it is a frequency.
    pub line: f64,
    /// In the unit of the spectrum.
    pub amplitude: f64,
}

/// What a peak is around its line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// A sine seen through a window: its main lobe.
    Sine(Window),
    /// The response of a vibration with little damping that has died down: its inverse square is a parabola.
    Resonance,
}

/// The largest peaks, at most `count`, largest first: lines above both neighbours, placed and sized by the shape that fits the three.
/// The first line, which is the mean, is none, nor are lines below a thousandth of the largest.
pub fn peaks(amplitudes: &[f64], count: usize, shape: Shape) -> Vec<Peak> {
    let largest = amplitudes.iter().skip(1).fold(0.0f64, |most, a| most.max(*a));
    let mut found: Vec<Peak> = (1..amplitudes.len().saturating_sub(1))
        .filter(|&line| {
            let [before, here, after] = [amplitudes[line - 1], amplitudes[line], amplitudes[line + 1]];
            // The mean says nothing of what is beside it.
            here >= 1e-3 * largest && here > 0.0 && (line == 1 || here > before) && here >= after
        })
        .map(|line| match line {
            // Beside the mean nothing is known of what is between lines.
            1 => Peak { line: 1.0, amplitude: amplitudes[1] },
            _ => shape.placed(line, [amplitudes[line - 1], amplitudes[line], amplitudes[line + 1]]),
        })
        .collect();
    found.sort_by(|a, b| b.amplitude.total_cmp(&a.amplitude).then(a.line.total_cmp(&b.line)));
    found.truncate(count);
    found
}

impl Shape {
    /// The peak whose shape passes through three lines, of which the middle one is the highest.
    fn placed(self, line: usize, around: [f64; 3]) -> Peak {
        let here = around[1];
        let (off, amplitude) = match self {
            Shape::Sine(window) => {
                let off = nearest(window, around);
                (off, here / window.response(off))
            }
            Shape::Resonance => {
                let [left, middle, right] = around.map(|value| (here / value).powi(2));
                let bend = left - 2.0 * middle + right;
                // Two lines that are nothing leave the peak where it is.
                let off = if bend.is_finite() && bend > 0.0 { 0.5 * (left - right) / bend } else { 0.0 };
                let least = middle - 0.25 * (left - right) * off;
                (off, if off != 0.0 && least > 0.0 { here / least.sqrt() } else { here })
            }
        };
        Peak { line: line as f64 + off, amplitude }
    }
}

/// How far a sine is from the middle of three lines, in lines: where what the window makes of it is most like them, by the angle between both
/// as vectors. Halving goes on to the digits that a largest value has.
fn nearest(window: Window, around: [f64; 3]) -> f64 {
    let alike = |off: f64| {
        let seen = [off + 1.0, off, off - 1.0].map(|away| window.response(away).abs());
        let product = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        product(seen, around) / product(seen, seen).sqrt()
    };
    // The golden section of an interval that shrinks.
    let part = 0.5 * (5.0_f64.sqrt() - 1.0);
    let [mut low, mut high] = [-0.5, 0.5];
    let mut inner = [high - part * (high - low), low + part * (high - low)];
    let mut value = inner.map(alike);
    while high - low > 1e-8 {
        if value[0] >= value[1] {
            high = inner[1];
            inner = [high - part * (high - low), inner[0]];
            value = [alike(inner[0]), value[0]];
        } else {
            low = inner[0];
            inner = [inner[1], low + part * (high - low)];
            value = [value[1], alike(inner[1])];
        }
    }
    0.5 * (low + high)
}
