//! Peaks of a spectrum, interpolated between its lines.

use super::Window;

/// Peak of a spectrum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// Position in lines from the first one; multiplied by the resolution it is a frequency.
    pub line: f64,
    /// Amplitude, in the unit of the spectrum.
    pub amplitude: f64,
}

/// Shape of a peak around its line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// Sine seen through a window: the main lobe of the window.
    Sine(Window),
    /// Decayed response of a lightly damped mode: its inverse square is a parabola.
    Resonance,
}

/// Returns the largest peaks, at most `count`, in descending order: lines above both neighbours,
/// with position and amplitude interpolated by the shape through the three lines. Excludes the
/// first line, which is the mean, and lines below a thousandth of the largest.
pub fn peaks(amplitudes: &[f64], count: usize, shape: Shape) -> Vec<Peak> {
    let largest = amplitudes.iter().skip(1).fold(0.0f64, |most, a| most.max(*a));
    let mut found: Vec<Peak> = (1..amplitudes.len().saturating_sub(1))
        .filter(|&line| {
            let [before, here, after] = [amplitudes[line - 1], amplitudes[line], amplitudes[line + 1]];
            // The mean does not indicate whether its neighbour is a peak.
            here >= 1e-3 * largest && here > 0.0 && (line == 1 || here > before) && here >= after
        })
        .map(|line| match line {
            // Next to the mean, interpolation between lines is impossible.
            1 => Peak { line: 1.0, amplitude: amplitudes[1] },
            _ => shape.placed(line, [amplitudes[line - 1], amplitudes[line], amplitudes[line + 1]]),
        })
        .collect();
    found.sort_by(|a, b| b.amplitude.total_cmp(&a.amplitude).then(a.line.total_cmp(&b.line)));
    found.truncate(count);
    found
}

impl Shape {
    /// Returns the peak whose shape passes through three lines, of which the middle one is the
    /// highest.
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
                // Two lines of zero leave the peak on its line.
                let off = if bend.is_finite() && bend > 0.0 { 0.5 * (left - right) / bend } else { 0.0 };
                let least = middle - 0.25 * (left - right) * off;
                (off, if off != 0.0 && least > 0.0 { here / least.sqrt() } else { here })
            }
        };
        Peak { line: line as f64 + off, amplitude }
    }
}

/// Returns the distance of a sine from the middle of three lines, in lines: it minimizes the angle
/// between the vectors of the lines and of the window's response. The iteration continues to the
/// accuracy of a maximum.
fn nearest(window: Window, around: [f64; 3]) -> f64 {
    let alike = |off: f64| {
        let seen = [off + 1.0, off, off - 1.0].map(|away| window.response(away).abs());
        let product = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        product(seen, around) / product(seen, seen).sqrt()
    };
    // Golden-section search.
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
