//! Contour lines of a field on a grid of points of a flank.

/// Point of a grid with its value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// Position on the projection plane.
    pub at: [f64; 2],
    pub value: f64,
}

/// Values by column and row; missing where the field has none.
pub type Field = Vec<Vec<Option<Node>>>;

/// Returns the pieces of a contour line, one in each half of a grid cell.
pub fn contour(field: &Field, level: f64) -> Vec<[[f64; 2]; 2]> {
    let mut pieces = Vec::new();
    for columns in field.windows(2) {
        for row in 1..columns[0].len().min(columns[1].len()) {
            let corners = [columns[0][row - 1], columns[1][row - 1], columns[1][row], columns[0][row]];
            let [Some(a), Some(b), Some(c), Some(d)] = corners else { continue };
            pieces
                .extend([[a, b, c], [a, c, d]].into_iter().filter_map(|triangle| crossing(triangle, level)));
        }
    }
    pieces
}

/// Returns the line at a level across a triangle.
fn crossing(triangle: [Node; 3], level: f64) -> Option<[[f64; 2]; 2]> {
    let ends: Vec<[f64; 2]> = (0..3)
        .filter_map(|k| {
            let (from, to) = (triangle[k], triangle[(k + 1) % 3]);
            let crosses = (from.value < level) != (to.value < level);
            let part = (level - from.value) / (to.value - from.value);
            crosses.then(|| [0, 1].map(|k: usize| from.at[k] + part * (to.at[k] - from.at[k])))
        })
        .collect();
    match ends[..] {
        [from, to] => Some([from, to]),
        _ => None,
    }
}

/// Returns levels at multiples of 1, 2 or 5 times a power of ten, about `count` below the largest
/// value.
pub fn levels(largest: f64, count: usize) -> Vec<f64> {
    let rough = largest / count as f64;
    // The comparison is negated so that NaN fails it.
    if !(rough > 0.0 && rough.is_finite()) {
        return Vec::new();
    }
    let power = 10_f64.powf(rough.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0].into_iter().map(|part| part * power).find(|step| *step >= rough);
    let step = step.unwrap_or(10.0 * power);
    (1..=count).map(|k| k as f64 * step).filter(|level| *level < largest).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn contours_of_a_cone_are_circles() {
        let value = |x: f64, y: f64| x.hypot(y);
        let at = |k: usize| -1.0 + 0.05 * k as f64;
        let field: Field = (0..41)
            .map(|i| {
                let node = |j: usize| Node { at: [at(i), at(j)], value: value(at(i), at(j)) };
                (0..41).map(|j| Some(node(j))).collect()
            })
            .collect();
        let pieces = contour(&field, 0.6);
        let length: f64 = pieces.iter().map(|[a, b]| (a[0] - b[0]).hypot(a[1] - b[1])).sum();
        assert!((length - 1.2 * std::f64::consts::PI).abs() < 0.02, "{length}");
        assert!(pieces.iter().flatten().all(|[x, y]| (value(*x, *y) - 0.6).abs() < 2e-3));
        assert!(contour(&field, 5.0).is_empty());
    }

    #[test]
    fn levels_are_round_and_below_the_largest_value() {
        assert_eq!(levels(87.0, 9), [10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 70.0, 80.0]);
        assert_eq!(levels(0.034, 8), [0.005, 0.01, 0.015, 0.02, 0.025, 0.03]);
        assert!(levels(0.0, 8).is_empty() && levels(f64::NAN, 8).is_empty());
    }
}
