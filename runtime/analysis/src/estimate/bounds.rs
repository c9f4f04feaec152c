//! Bounds of outputs: no extreme between positions lies beyond them. The load share of a tooth pair
//! is at most one, for example, so a plateau at one has no error although both sides of it rise.

use super::{Ends, Statistics};
use crate::observables::Observable;
use calyx_model::observed::OutputRequest;
use std::sync::Arc;

/// Deviation from an affine function, relative to its values, that counts as rounding.
const ROUNDING: f64 = 1e-9;

/// Returns the bounds of an output that is an affine function of one observable with bounds, and
/// infinite ones of any other.
pub(super) fn of(request: &OutputRequest, observables: &[Arc<dyn Observable>]) -> [f64; 2] {
    const NONE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];
    let mut seen = request.value.observes().into_iter();
    let (Some(one), None) = (seen.next(), seen.next()) else { return NONE };
    let Some(own) = observables.get(one).map(|seen| seen.bounds()) else { return NONE };
    let at = |value: f64| request.at(0.0, &|_| value);
    let (start, slope) = (at(0.0), at(1.0) - at(0.0));
    let is_affine = |value: f64| {
        let expected = start + slope * value;
        let near = (at(value) - expected).abs() <= ROUNDING * (start.abs() + slope.abs());
        near && request.at(1.0, &|_| value).to_bits() == at(value).to_bits()
    };
    if slope == 0.0 || ![-1.0, 0.25, 3.0].into_iter().all(is_affine) {
        return NONE;
    }
    let [low, high] = own.map(|bound| start + slope * bound);
    if slope > 0.0 { [low, high] } else { [high, low] }
}

/// Limits the errors of extremes due to the variation between positions to the distance of the
/// extremes at the positions from the bounds.
pub(super) fn within(errors: Statistics, ends: &[Ends], [low, high]: [f64; 2]) -> Statistics {
    let most = ends.iter().map(|end| end.high).fold(f64::NEG_INFINITY, f64::max);
    let least = ends.iter().map(|end| end.low).fold(f64::INFINITY, f64::min);
    // A solution exceeds a bound by rounding.
    let [below, above] = [least - low, high - most].map(|room| room.max(0.0));
    let (min, max) = (errors.min.min(below), errors.max.min(above));
    Statistics { min, max, peak_to_peak: errors.peak_to_peak.min(min + max), ..errors }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::observables::LoadShare;
    use calyx_model::ids::{ObservableId, PairId};

    #[test]
    fn no_load_share_exceeds_one() {
        let observables: [Arc<dyn Observable>; 1] = [Arc::new(LoadShare(PairId(0)))];
        let bounds = of(&OutputRequest::observing("share", ObservableId(0)), &observables);
        assert_eq!(bounds, [0.0, 1.0]);
        let ends = [0.25, 1.0, 0.75].map(|value| Ends { value, low: value, high: value });
        let errors = Statistics { min: 0.5, max: 0.125, mean: 0.0625, peak_to_peak: 0.625 };
        let limited = Statistics { min: 0.25, max: 0.0, mean: 0.0625, peak_to_peak: 0.25 };
        assert_eq!(within(errors, &ends, bounds), limited);
    }
}
