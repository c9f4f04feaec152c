//! Spots of a surface in table coordinates: weights on a few samples across, times all polynomials
//! along.
//!
//! Spots of a grid form lines across the flank; on each line the averages of the polynomials are
//! the same. Table values at many points are therefore summed first over the polynomials, once for
//! each line, and then over the few samples of each point. For a grid of lines this costs a
//! fraction of a product with the matrix of all weights.

use super::SurfaceSegment;
use super::axial_modes::AxialModes;
use crate::bspline::BSplineWeights;
use crate::dense::{add_product, product};
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use faer::reborrow::{IntoConst, ReborrowMut};
use faer::{Mat, MatRef};
use std::collections::BTreeMap;

/// Points of a line may differ by one part of the face in this number: rounding.
const LINE: f64 = (1_u64 << 44) as f64;

/// Position of a point across the surface: samples of a table with their weights.
pub(super) struct TransverseWeights {
    /// Weights of the splines.
    pub splines: BSplineWeights,
    /// An additional sample.
    pub more: Option<(usize, f64)>,
}

impl TransverseWeights {
    fn each(&self) -> impl Iterator<Item = (usize, f64)> {
        let splines = self.splines.values.into_iter().enumerate();
        let first = self.splines.first;
        splines.map(move |(k, value)| (first + k, value)).chain(self.more)
    }
}

/// Points of one surface.
pub(super) struct TablePoints {
    /// Number of samples of the table.
    places: usize,
    across: Vec<TransverseWeights>,
    /// Line of each point.
    line: Vec<usize>,
    /// Averages of the polynomials, one column for each line.
    along: Mat<f64>,
}

/// Sample of a table and the points that have a weight on it.
#[derive(Default)]
struct Place {
    /// Lines of those points, ascending.
    lines: Vec<usize>,
    /// Points with their weights.
    points: Vec<(usize, f64)>,
}

impl TablePoints {
    /// Builds the points from spots, for a table with this number of samples.
    pub fn new(
        modes: &AxialModes,
        places: usize,
        segments: &[SurfaceSegment],
        across: impl Fn(f64) -> TransverseWeights,
    ) -> Self {
        let [start, _] = modes.range();
        let step = modes.length() / LINE;
        let mut lines = BTreeMap::new();
        let mut values = Vec::new();
        let line = segments.iter().map(|segment| {
            let [v, length] =
                [segment.place[1] - start, segment.length].map(|along| step * (along / step).round());
            *lines.entry([v, length].map(f64::to_bits)).or_insert_with(|| {
                values.push(modes.means(start + v, length));
                values.len() - 1
            })
        });
        let line = line.collect();
        let along = Mat::from_fn(modes.count(), values.len(), |mode, line| values[line][mode]);
        Self {
            places,
            across: segments.iter().map(|segment| across(segment.place[0])).collect(),
            line,
            along,
        }
    }

    fn modes(&self) -> usize {
        self.along.nrows()
    }

    /// Returns the lines and points of each sample of the table.
    fn by_place(&self) -> Vec<Place> {
        let mut places: Vec<Place> = (0..self.places).map(|_| Place::default()).collect();
        for (point, across) in self.across.iter().enumerate() {
            for (place, weight) in across.each() {
                places[place].lines.push(self.line[point]);
                places[place].points.push((point, weight));
            }
        }
        for place in &mut places {
            place.lines.sort_unstable();
            place.lines.dedup();
        }
        places
    }

    /// Returns the sums over the polynomials of table values at a sample, one column for each of
    /// some lines, in `room` for all lines.
    fn by_line<'r>(
        &self,
        lines: &[usize],
        at_place: MatRef<'_, f64>,
        room: &'r mut Mat<f64>,
    ) -> MatRef<'r, f64> {
        let along = Mat::from_fn(self.modes(), lines.len(), |mode, line| self.along[(mode, lines[line])]);
        let mut by_line = room.as_mut().subcols_mut(0, lines.len());
        by_line.fill(0.0);
        add_product(by_line.rb_mut(), 1.0, at_place, along.as_ref());
        by_line.into_const()
    }

    /// Returns columns of a table for loads at the points: one column for each point. There is a
    /// checkpoint before each place of the table.
    pub fn columns(&self, table: &Mat<f64>, interrupt: &Interrupt) -> Result<Mat<f64>, EngineError> {
        let mut columns = Mat::<f64>::zeros(table.nrows(), self.across.len());
        let mut at_place = Mat::<f64>::zeros(table.nrows(), self.modes());
        let mut by_all_lines = Mat::<f64>::zeros(table.nrows(), self.along.ncols());
        for (place, of) in self.by_place().iter().enumerate().filter(|(_, of)| !of.points.is_empty()) {
            interrupt.check()?;
            for mode in 0..self.modes() {
                let column = table.col_as_slice(mode * self.places + place);
                at_place.col_as_slice_mut(mode).copy_from_slice(column);
            }
            let by_line = self.by_line(&of.lines, at_place.as_ref(), &mut by_all_lines);
            for &(point, weight) in &of.points {
                let line = of.lines.partition_point(|&line| line < self.line[point]);
                add(columns.as_mut().col_mut(point), weight, by_line.col(line));
            }
        }
        Ok(columns)
    }

    /// Evaluates columns of a table at the points as observers: rows by column, one column for each
    /// observer. There is a checkpoint before each place of the table.
    pub fn seen(&self, columns: &Mat<f64>, interrupt: &Interrupt) -> Result<Mat<f64>, EngineError> {
        let mut seen = Mat::<f64>::zeros(columns.ncols(), self.across.len());
        let mut at_place = Mat::<f64>::zeros(self.modes(), columns.ncols());
        let mut by_all_lines = Mat::<f64>::zeros(columns.ncols(), self.along.ncols());
        for (place, of) in self.by_place().iter().enumerate().filter(|(_, of)| !of.points.is_empty()) {
            interrupt.check()?;
            for column in 0..columns.ncols() {
                let by_mode = columns.col_as_slice(column).iter().skip(place).step_by(self.places);
                at_place
                    .col_as_slice_mut(column)
                    .iter_mut()
                    .zip(by_mode)
                    .for_each(|(at, value)| *at = *value);
            }
            let by_line = self.by_line(&of.lines, at_place.transpose(), &mut by_all_lines);
            for &(point, weight) in &of.points {
                let line = of.lines.partition_point(|&line| line < self.line[point]);
                add(seen.as_mut().col_mut(point), weight, by_line.col(line));
            }
        }
        Ok(seen)
    }

    /// Returns forces at the points as loads of the table.
    pub fn loads(&self, forces: &[f64]) -> Mat<f64> {
        let mut loads = Mat::zeros(self.modes() * self.places, 1);
        for ((across, &line), force) in self.across.iter().zip(&self.line).zip(forces) {
            for (place, weight) in across.each() {
                for mode in 0..self.modes() {
                    loads[(mode * self.places + place, 0)] += force * weight * self.along[(mode, line)];
                }
            }
        }
        loads
    }

    /// Line of each point.
    pub fn line(&self) -> &[usize] {
        &self.line
    }

    /// Returns the projection of a load on the polynomials, at these points and others: sums of
    /// products of polynomials, with a matrix between them where lengths vary along the face.
    pub fn lines(&self, others: &TablePoints, between: Option<MatRef<'_, f64>>) -> LineProducts<'_> {
        let weighted = between.map(|between| product(between, others.along.as_ref()));
        let others = weighted.as_ref().unwrap_or(&others.along);
        LineProducts { line: &self.line, products: product(others.transpose(), self.along.as_ref()) }
    }
}

/// Projections of loads on the polynomials, by line.
pub(super) struct LineProducts<'a> {
    line: &'a [usize],
    products: Mat<f64>,
}

impl LineProducts<'_> {
    /// Returns the projections at a point, by line of the others.
    pub fn of(&self, point: usize) -> &[f64] {
        self.products.col_as_slice(self.line[point])
    }
}

fn add(target: faer::ColMut<'_, f64>, weight: f64, column: faer::ColRef<'_, f64>) {
    for (target, value) in target.iter_mut().zip(column.iter()) {
        *target += weight * value;
    }
}
