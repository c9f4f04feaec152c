//! Interpolation of tables by natural cubic splines of one and of two variables.
//!
//! The spline interpolates the measured values exactly, with continuous second derivatives between
//! the points. Beyond its ends it continues straight (de Boor, A Practical Guide to Splines,
//! chapter IV; the second derivative of a natural spline vanishes at its ends).

use crate::error::{GeometryError, sentence};

/// Maximum number of points of a table along one variable.
const MOST_PLACES: usize = 10_000;

/// Natural cubic spline through ascending points.
#[derive(Clone, Debug, PartialEq)]
pub struct NaturalSpline {
    places: Vec<f64>,
    values: Vec<f64>,
    /// Second derivatives at the points.
    bends: Vec<f64>,
}

/// Weights of the values and the second derivatives at both ends of an interval in the value, the
/// first and the second derivative of a natural spline.
struct Weights {
    piece: usize,
    values: [[f64; 2]; 3],
    bends: [[f64; 2]; 3],
}

impl NaturalSpline {
    /// Creates the spline through a table; errors about the points blame `argument`.
    ///
    /// # Errors
    /// E0643: fewer than two points, a different number of values, or points that do not ascend.
    pub fn new(argument: &'static str, places: Vec<f64>, values: Vec<f64>) -> Result<Self, GeometryError> {
        check_places(argument, &places)?;
        check_count("depths", values.len(), places.len())?;
        check_values(&values)?;
        let bends = bends(&places, &values);
        Ok(Self { places, values, bends })
    }

    /// Value, first and second derivative.
    pub fn at(&self, x: f64) -> [f64; 3] {
        let Weights { piece, values, bends } = weights(&self.places, x);
        [0, 1, 2].map(|order| {
            (0..2)
                .map(|end| {
                    values[order][end] * self.values[piece + end]
                        + bends[order][end] * self.bends[piece + end]
                })
                .sum()
        })
    }
}

/// Function of two variables from a table: tensor product of natural splines.
#[derive(Clone, Debug, PartialEq)]
pub struct TensorSpline {
    places: [Vec<f64>; 2],
    /// Values, their second derivatives by the first variable, by the second, and by both, ordered
    /// by the first point, then the second.
    tables: [Vec<f64>; 4],
}

impl TensorSpline {
    /// Creates the function through `values`, which contains one row over `places[1]` for each of
    /// `places[0]`. Errors about the points blame `arguments`.
    ///
    /// # Errors
    /// E0643, as for [`NaturalSpline::new`].
    pub fn new(
        arguments: [&'static str; 2],
        places: [Vec<f64>; 2],
        values: Vec<f64>,
    ) -> Result<Self, GeometryError> {
        for (argument, places) in arguments.into_iter().zip(&places) {
            check_places(argument, places)?;
        }
        let [rows, columns] = [places[0].len(), places[1].len()];
        check_count("depths", values.len(), rows * columns)?;
        check_values(&values)?;
        let along_rows = |table: &[f64]| -> Vec<f64> {
            table.chunks(columns).flat_map(|row| bends(&places[1], row)).collect()
        };
        let across_rows = |table: &[f64]| -> Vec<f64> {
            let mut bent = vec![0.0; table.len()];
            for column in 0..columns {
                let values: Vec<f64> = (0..rows).map(|row| table[row * columns + column]).collect();
                for (row, bend) in bends(&places[0], &values).into_iter().enumerate() {
                    bent[row * columns + column] = bend;
                }
            }
            bent
        };
        let (by_first, by_second) = (across_rows(&values), along_rows(&values));
        let by_both = along_rows(&by_first);
        Ok(Self { places, tables: [values, by_first, by_second, by_both] })
    }

    /// Value, and derivatives by the first and the second variable.
    pub fn at(&self, first: f64, second: f64) -> [f64; 3] {
        let [rows, columns] = [weights(&self.places[0], first), weights(&self.places[1], second)];
        let width = self.places[1].len();
        let sum = |[row_order, column_order]: [usize; 2]| {
            let mut sum = 0.0;
            for (row, column) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                let at = (rows.piece + row) * width + columns.piece + column;
                let (value, bend) = (rows.values[row_order][row], rows.bends[row_order][row]);
                let (along, bent) =
                    (columns.values[column_order][column], columns.bends[column_order][column]);
                let [table, by_first, by_second, by_both] =
                    [0, 1, 2, 3].map(|table: usize| self.tables[table][at]);
                sum +=
                    value * (along * table + bent * by_second) + bend * (along * by_first + bent * by_both);
            }
            sum
        };
        [sum([0, 0]), sum([1, 0]), sum([0, 1])]
    }

    /// Restriction to one value of the second variable, as a function of the first.
    pub fn along_first(&self, second: f64) -> NaturalSpline {
        let values: Vec<f64> = self.places[0].iter().map(|&first| self.at(first, second)[0]).collect();
        let bends = bends(&self.places[0], &values);
        NaturalSpline { places: self.places[0].clone(), values, bends }
    }
}

fn check_places(argument: &'static str, places: &[f64]) -> Result<(), GeometryError> {
    let ascending =
        places.windows(2).all(|pair| pair[0] < pair[1]) && places.iter().all(|place| place.is_finite());
    if (2..=MOST_PLACES).contains(&places.len()) && ascending {
        return Ok(());
    }
    Err(GeometryError::error(
        "E0643",
        argument,
        sentence![
            "a table of flank modifications has ", number places.len() as f64,
            " positions, which must be two at least and ascend"
        ],
        sentence!["sort the table and remove duplicates"],
    ))
}

fn check_count(argument: &'static str, found: usize, wanted: usize) -> Result<(), GeometryError> {
    if found == wanted {
        return Ok(());
    }
    Err(GeometryError::error(
        "E0643",
        argument,
        sentence![
            "a table of flank modifications has ", number found as f64, " depths for ", number wanted as f64, " positions"
        ],
        sentence!["give one depth for each place; for a topography one row along the face after the other"],
    ))
}

fn check_values(values: &[f64]) -> Result<(), GeometryError> {
    if values.iter().all(|value| value.is_finite()) {
        return Ok(());
    }
    Err(GeometryError::error(
        "E0643",
        "depths",
        sentence!["a depth in a table of flank modifications is not a finite number"],
        sentence!["look at where the table comes from"],
    ))
}

/// Second derivatives at the points, zero at the ends. Adjacent ones satisfy `h[i-1] b[i-1] + 2
/// (h[i-1] + h[i]) b[i] + h[i] b[i+1] = 6 (difference of slopes)`.
fn bends(places: &[f64], values: &[f64]) -> Vec<f64> {
    let last = places.len() - 1;
    let mut bends = vec![0.0; last + 1];
    let mut ratios = vec![0.0; last + 1];
    let width = |i: usize| places[i + 1] - places[i];
    let slope = |i: usize| (values[i + 1] - values[i]) / width(i);
    for i in 1..last {
        let pivot = 2.0 * (width(i - 1) + width(i)) - width(i - 1) * ratios[i - 1];
        ratios[i] = width(i) / pivot;
        bends[i] = (6.0 * (slope(i) - slope(i - 1)) - width(i - 1) * bends[i - 1]) / pivot;
    }
    for i in (1..last).rev() {
        bends[i] -= ratios[i] * bends[i + 1];
    }
    bends
}

fn weights(places: &[f64], x: f64) -> Weights {
    let piece = places.partition_point(|&place| place <= x).clamp(1, places.len() - 1) - 1;
    let h = places[piece + 1] - places[piece];
    let within = ((x - places[piece]) / h).clamp(0.0, 1.0);
    let (before, after) = (1.0 - within, within);
    let third = h * h / 6.0;
    let mut values = [[before, after], [-1.0 / h, 1.0 / h], [0.0; 2]];
    let mut bends = [
        [third * (before.powi(3) - before), third * (after.powi(3) - after)],
        [h / 6.0 * (1.0 - 3.0 * before * before), h / 6.0 * (3.0 * after * after - 1.0)],
        [before, after],
    ];
    // Straight beyond the ends, where the second derivative is zero.
    let beyond = x - places[piece] - within * h;
    for end in 0..2 {
        values[0][end] += beyond * values[1][end];
        bends[0][end] += beyond * bends[1][end];
    }
    Weights { piece, values, bends }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Unequal intervals and the values of a known natural spline: one cubic in each of two
    /// intervals.
    #[test]
    fn tables_are_met_smoothly_and_continue_straight() {
        let places = vec![-1.0, -0.2, 0.5, 0.6, 2.0];
        let values = vec![0.3, -0.4, 0.8, 0.7, 0.1];
        let spline = NaturalSpline::new("roll_angles", places.clone(), values.clone()).expect("a spline");
        for (&place, &value) in places.iter().zip(&values) {
            assert!((spline.at(place)[0] - value).abs() < 1e-14);
            let [before, after] = [place - 1e-9, place + 1e-9].map(|x| spline.at(x));
            for order in 0..3 {
                assert!((before[order] - after[order]).abs() < 1e-6, "{place} {order}");
            }
        }
        for x in [-2.0, -0.6, 0.1, 0.55, 1.3, 2.5] {
            let h = 1e-5;
            let [low, high] = [x - h, x + h].map(|x| spline.at(x));
            let at = spline.at(x);
            assert!((at[1] - (high[0] - low[0]) / (2.0 * h)).abs() < 1e-8);
            assert!((at[2] - (high[1] - low[1]) / (2.0 * h)).abs() < 1e-6);
        }
        assert_eq!(spline.at(3.0)[2], 0.0);
        let straight = spline.at(2.0)[0] + spline.at(2.0)[1];
        assert!((spline.at(3.0)[0] - straight).abs() < 1e-14);
    }

    #[test]
    fn a_product_of_splines_is_their_tensor_spline() {
        let [first, second] = [vec![0.0, 0.4, 1.0, 1.1], vec![-1.0, 0.3, 0.9]];
        let [f, g] = [vec![0.1, -0.3, 0.5, 0.2], vec![1.0, -2.0, 0.7]];
        let values = f.iter().flat_map(|f| g.iter().map(move |g| f * g)).collect();
        let splines = [
            NaturalSpline::new("roll_angles", first.clone(), f.clone()).expect("a spline"),
            NaturalSpline::new("axial_positions", second.clone(), g.clone()).expect("a spline"),
        ];
        let tensor =
            TensorSpline::new(["roll_angles", "axial_positions"], [first, second], values).expect("a spline");
        for x in [-0.2, 0.1, 0.7, 1.05, 1.4] {
            for y in [-1.5, -0.4, 0.5, 1.2] {
                let (f, g) = (splines[0].at(x), splines[1].at(y));
                let found = tensor.at(x, y);
                for (found, known) in found.into_iter().zip([f[0] * g[0], f[1] * g[0], f[0] * g[1]]) {
                    assert!((found - known).abs() < 1e-13, "{x} {y}: {found} {known}");
                }
                let along = tensor.along_first(y).at(x);
                assert!((along[0] - found[0]).abs() < 1e-14 && (along[1] - found[1]).abs() < 1e-13);
            }
        }
    }

    #[test]
    fn tables_that_are_none_are_refused() {
        let refused = |places: Vec<f64>, values: Vec<f64>| {
            let error = NaturalSpline::new("roll_angles", places, values).expect_err("refused");
            (error.code, error.argument)
        };
        assert_eq!(refused(vec![0.0], vec![0.0]), ("E0643", "roll_angles"));
        assert_eq!(refused(vec![0.0, 0.0], vec![0.0, 0.0]), ("E0643", "roll_angles"));
        assert_eq!(refused(vec![0.0, 1.0], vec![0.0]), ("E0643", "depths"));
        assert_eq!(refused(vec![0.0, 1.0], vec![0.0, f64::NAN]), ("E0643", "depths"));
        let places = [vec![0.0, 1.0], vec![1.0, 0.0]];
        let error =
            TensorSpline::new(["roll_angles", "axial_positions"], places, vec![0.0; 4]).expect_err("refused");
        assert_eq!((error.code, error.argument), ("E0643", "axial_positions"));
    }
}
