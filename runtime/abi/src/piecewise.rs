//! Piecewise cubic polynomials: the single definition of interpolation tables.
//!
//! A table is a list of numbers: the number `n` of points, the ascending points, and four
//! coefficients for each of `n + 1` pieces. Piece `k` applies from point `k - 1` up to point `k`;
//! the first piece lies before all points, the last one after them. The polynomial of a piece is
//! `((c3 t + c2) t + c1) t + c0`, where `t` is the distance from the first point of the piece; for
//! the first piece, from the first point of the table.
//!
//! The tables of constant points are data of the compiled kernels. Tables of points that a program
//! computes are registered when it runs; kernels receive their numbers as inputs.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::sync::{PoisonError, RwLock};

/// Returns the value of a table at `x`; NaN for a NaN. A malformed table gives NaN.
pub fn piecewise(table: &[f64], x: f64) -> f64 {
    let Some((points, coefficients)) = parts(table) else { return f64::NAN };
    // The number of points at or before `x`.
    let piece = points.partition_point(|point| *point <= x);
    let (Some(origin), Some(&[c0, c1, c2, c3])) =
        (points.get(piece.saturating_sub(1)), coefficients.as_chunks::<4>().0.get(piece))
    else {
        return f64::NAN;
    };
    let t = x - origin;
    ((c3 * t + c2) * t + c1) * t + c0
}

/// Returns `true` if a list of numbers is a table with finite, strictly ascending points.
pub fn is_table(table: &[f64]) -> bool {
    parts(table).is_some_and(|(points, _)| {
        points.iter().all(|point| point.is_finite()) && points.is_sorted_by(|a, b| a < b)
    })
}

/// Returns the points and the coefficients.
fn parts(table: &[f64]) -> Option<(&[f64], &[f64])> {
    let (count, rest) = table.split_first()?;
    let count = *count as usize;
    (count > 0 && rest.len() == count + 4 * (count + 1)).then(|| rest.split_at(count))
}

/// Returns the table of the derivative.
pub fn derivative(table: &[f64]) -> Vec<f64> {
    let Some((points, coefficients)) = parts(table) else { return Vec::new() };
    let mut result = table[..=points.len()].to_vec();
    for [_, c1, c2, c3] in coefficients.as_chunks::<4>().0 {
        result.extend([*c1, 2.0 * c2, 3.0 * c3, 0.0]);
    }
    result
}

/// Returns the natural cubic spline through points with strictly ascending abscissas: the second
/// derivative is continuous everywhere and zero at both ends, and the spline continues as a
/// straight line outside (de Boor, *A Practical Guide to Splines*, 2001, chapter IV). `None` if
/// there are fewer than two points, the numbers of coordinates differ, or an abscissa is not
/// finite or not greater than the one before it.
pub fn natural_spline(xs: &[f64], ys: &[f64]) -> Option<Vec<f64>> {
    let count = xs.len();
    let sound = count >= 2
        && ys.len() == count
        && xs.iter().chain(ys).all(|number| number.is_finite())
        && xs.is_sorted_by(|a, b| a < b);
    if !sound {
        return None;
    }
    let widths: Vec<f64> = xs.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let slopes: Vec<f64> = ys.windows(2).zip(&widths).map(|(pair, h)| (pair[1] - pair[0]) / h).collect();
    // Second derivatives by the Thomas algorithm; the matrix is diagonally dominant.
    let mut second = vec![0.0; count];
    let mut above = vec![0.0; count];
    for i in 1..count - 1 {
        let pivot = 2.0 * (widths[i - 1] + widths[i]) - widths[i - 1] * above[i - 1];
        above[i] = widths[i] / pivot;
        second[i] = (6.0 * (slopes[i] - slopes[i - 1]) - widths[i - 1] * second[i - 1]) / pivot;
    }
    for i in (1..count - 1).rev() {
        second[i] -= above[i] * second[i + 1];
    }
    let start = |i: usize| slopes[i] - widths[i] * (2.0 * second[i] + second[i + 1]) / 6.0;
    let last = count - 2;
    let end = slopes[last] + widths[last] * (second[last] + 2.0 * second[last + 1]) / 6.0;
    let mut table = vec![count as f64];
    table.extend(xs);
    table.extend([ys[0], start(0), 0.0, 0.0]);
    for (i, (y, width)) in ys.iter().zip(&widths).enumerate() {
        table.extend([*y, start(i), second[i] / 2.0, (second[i + 1] - second[i]) / (6.0 * width)]);
    }
    table.extend([ys[count - 1], end, 0.0, 0.0]);
    Some(table)
}

/// Returns the reason why there is no [`natural_spline`] through points.
pub fn refusal(xs: &[f64], ys: &[f64]) -> String {
    if xs.len() != ys.len() {
        return format!("the spline has {} abscissas and {} ordinates", xs.len(), ys.len());
    }
    if xs.len() < 2 {
        return "a spline needs at least two points".to_string();
    }
    if !xs.iter().chain(ys).all(|number| number.is_finite()) {
        return "the points of a spline must be finite".to_string();
    }
    match xs.windows(2).position(|pair| pair[0] >= pair[1]) {
        Some(at) => format!("the abscissas of a spline must ascend, and number {} does not", at + 2),
        None => "the spline is too large".to_string(),
    }
}

/// Tables that a program computed while it ran, by number. Equal tables are stored once, and a
/// table remains for the life of the process, because kernels refer to it by its number.
static TABLES: RwLock<Registered> = RwLock::new(Registered { tables: Vec::new(), ids: BTreeMap::new() });

struct Registered {
    /// Each table with its three derivatives.
    tables: Vec<&'static [Vec<f64>; 4]>,
    ids: BTreeMap<Vec<u64>, usize>,
}

thread_local! {
    /// A copy of the list, so that evaluation takes no lock.
    static SEEN: RefCell<Vec<&'static [Vec<f64>; 4]>> = const { RefCell::new(Vec::new()) };
}

/// Registers a table, and returns its number.
pub fn register(table: Vec<f64>) -> f64 {
    let bits: Vec<u64> = table.iter().map(|number| number.to_bits()).collect();
    let mut registered = TABLES.write().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = registered.ids.get(&bits) {
        return *known as f64;
    }
    let first = derivative(&table);
    let second = derivative(&first);
    let third = derivative(&second);
    let number = registered.tables.len();
    registered.tables.push(Box::leak(Box::new([table, first, second, third])));
    registered.ids.insert(bits, number);
    number as f64
}

/// Returns the value at `x` of a registered table, or of one of its first three derivatives. NaN if
/// there is no such table.
pub fn registered(table: f64, order: f64, x: f64) -> f64 {
    let number = table as usize;
    if table != number as f64 {
        return f64::NAN;
    }
    let found = SEEN.with_borrow_mut(|seen| {
        if number >= seen.len() {
            let registered = TABLES.read().unwrap_or_else(PoisonError::into_inner);
            seen.extend_from_slice(registered.tables.get(seen.len()..).unwrap_or_default());
        }
        seen.get(number).copied()
    });
    match found.and_then(|orders| orders.get(order as usize)) {
        Some(table) => piecewise(table, x),
        None => f64::NAN,
    }
}

/// [`registered`] for machine code.
#[unsafe(no_mangle)]
pub extern "C" fn calyx_math_spline(table: f64, order: f64, x: f64) -> f64 {
    registered(table, order, x)
}

/// [`piecewise`] for machine code.
///
/// # Safety
/// `table` must point to a table ([`is_table`]).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_math_piecewise(table: *const f64, x: f64) -> f64 {
    // SAFETY: guaranteed by the caller; the first number determines the length.
    let table = unsafe {
        let count = table.read() as usize;
        std::slice::from_raw_parts(table, 1 + count + 4 * (count + 1))
    };
    piecewise(table, x)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_spline_passes_through_its_points_and_is_twice_continuous() {
        let (xs, ys) = ([0.0, 0.7, 1.5, 2.0, 4.0], [1.0, -0.5, 2.0, 2.5, 0.0]);
        let table = natural_spline(&xs, &ys).unwrap();
        assert!(is_table(&table));
        let (first, second) = (derivative(&table), derivative(&derivative(&table)));
        for (x, y) in xs.iter().zip(ys) {
            assert!((piecewise(&table, *x) - y).abs() < 1e-15);
            for table in [&table, &first, &second] {
                let (before, after) = (piecewise(table, x.next_down()), piecewise(table, *x));
                assert!((before - after).abs() < 1e-13, "at {x}: {before} and {after}");
            }
        }
        assert_eq!((piecewise(&second, -1.0), piecewise(&second, 5.0)), (0.0, 0.0));
        assert!(piecewise(&second, 0.0).abs() < 1e-15 && piecewise(&table, f64::NAN).is_nan());
        assert!((piecewise(&table, -1.0) - (1.0 - piecewise(&first, 0.0))).abs() < 1e-15);
        // SAFETY: this is a table.
        assert_eq!(unsafe { calyx_math_piecewise(table.as_ptr(), 0.3) }, piecewise(&table, 0.3));
    }

    #[test]
    fn registered_tables_have_three_derivatives() {
        let table = natural_spline(&[0.0, 0.7, 1.5, 2.0], &[1.0, -0.5, 2.0, 2.5]).unwrap();
        let number = register(table.clone());
        assert_eq!(register(table.clone()), number);
        let mut of_order = table;
        for order in 0..4 {
            assert_eq!(registered(number, f64::from(order), 0.9), piecewise(&of_order, 0.9));
            of_order = derivative(&of_order);
        }
        let other = std::thread::spawn(move || calyx_math_spline(number, 0.0, 0.9)).join().unwrap();
        assert_eq!(other, registered(number, 0.0, 0.9));
        for wrong in [-1.0, 0.5, f64::NAN, 1e300] {
            assert!(registered(wrong, 0.0, 0.9).is_nan());
        }
        assert!(registered(number, 4.0, 0.9).is_nan());
    }

    #[test]
    fn a_straight_line_is_reproduced() {
        let xs = [-1.0, 0.0, 0.25, 3.0];
        let table = natural_spline(&xs, &xs.map(|x| 2.0 * x + 1.0)).unwrap();
        for x in [-5.0, -1.0, -0.3, 0.1, 2.9, 3.0, 10.0] {
            assert!((piecewise(&table, x) - (2.0 * x + 1.0)).abs() < 4e-15);
        }
        assert!(natural_spline(&[0.0, 1.0], &[1.0, 3.0]).is_some());
    }

    #[test]
    fn invalid_points_are_refused() {
        assert!(natural_spline(&[0.0], &[1.0]).is_none());
        assert!(natural_spline(&[0.0, 0.0], &[1.0, 2.0]).is_none());
        assert!(natural_spline(&[1.0, 0.0], &[1.0, 2.0]).is_none());
        assert!(natural_spline(&[0.0, 1.0], &[1.0]).is_none());
        assert!(natural_spline(&[0.0, f64::NAN], &[1.0, 2.0]).is_none());
        assert!(natural_spline(&[0.0, 1.0], &[1.0, f64::INFINITY]).is_none());
        assert!(!is_table(&[]) && !is_table(&[2.0, 0.0]) && piecewise(&[3.0], 1.0).is_nan());
    }
}
