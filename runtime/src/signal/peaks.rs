//! Where a spectrum has its peaks, between its lines too.

/// A peak.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// Place, in lines from the first one: times the resolution it is a frequency.
    pub line: f64,
    /// In the unit of the spectrum.
    pub amplitude: f64,
}

/// The largest peaks, at most `count`, largest first: lines above both neighbours, placed by the parabola through a power of the three (Werner and Germain, DAFx
/// 2016: what suits Hann's window).
/// The first line, which is the mean, is none, nor are lines below a thousandth of the largest.
pub fn peaks(amplitudes: &[f64], count: usize) -> Vec<Peak> {
    let largest = amplitudes.iter().skip(1).fold(0.0f64, |most, a| most.max(*a));
    let mut found: Vec<Peak> = (1..amplitudes.len().saturating_sub(1))
        .filter(|&line| {
            let [before, here, after] = [amplitudes[line - 1], amplitudes[line], amplitudes[line + 1]];
            // The mean says nothing of what is beside it.
            here >= 1e-3 * largest && here > 0.0 && (line == 1 || here > before) && here >= after
        })
        .map(|line| placed(line, &amplitudes[line - 1..=line + 1]))
        .collect();
    found.sort_by(|a, b| b.amplitude.total_cmp(&a.amplitude).then(a.line.total_cmp(&b.line)));
    found.truncate(count);
    found
}

/// Raised to this, the main lobe of Hann's window is nearly a parabola.
const POWER: f64 = 0.2308;

fn placed(line: usize, around: &[f64]) -> Peak {
    let [before, here, after] = [0, 1, 2].map(|k: usize| around[k].abs().powf(POWER));
    let bend = before - 2.0 * here + after;
    // Beside the mean nothing is known of what is between lines.
    let off = if line == 1 || bend >= 0.0 { 0.0 } else { 0.5 * (before - after) / bend };
    Peak { line: line as f64 + off, amplitude: (here - 0.25 * (before - after) * off).powf(POWER.recip()) }
}
