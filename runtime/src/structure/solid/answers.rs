//! What a condensed body in space answers: compliances between points of its surfaces, and stresses, off its tables.
//!
//! A spot is a column of weights on the tables' places and polynomials, these averaged along it, so that the compliances between many spots
//! are two products of matrices. Exchanging loads and observers gives the same bits, because it gives the same products: of two orientations always the same
//! one is computed.

use super::elastic::{ElasticSolid, KnownSurface};
use super::{Mirror, SolidStructure, Spot, SpotLoad, SurfaceStress};
use crate::structure::Chart;
use crate::structure::answers::Turned;
use crate::structure::dense::{mirror_lower, product};
use crate::structure::spline::Weights;
use crate::surface::Surface;
use faer::{Mat, MatRef};
use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::sync::Arc;

/// Polynomials along the face, the slowest ones, that are continued towards edges beyond the samples.
const CONTINUED: usize = 3;

impl ElasticSolid {
    /// Places ahead, going round, from one tooth to another.
    fn places_ahead(&self, from: u32, to: u32) -> u32 {
        (to % self.teeth + self.teeth - from % self.teeth) % self.teeth
    }

    fn known(&self, chart: Chart) -> Option<&KnownSurface> {
        self.surfaces.get(chart.surface as usize)
    }

    /// A column a point, by `table_places` places for each polynomial.
    fn columns(
        &self,
        points: &[Spot],
        table_places: usize,
        fill: impl Fn(f64, &mut dyn FnMut(usize, f64)),
    ) -> Mat<f64> {
        let mut columns = Mat::zeros(self.modes.count() * table_places, points.len());
        for (column, &Spot { place: [u, v], length }) in points.iter().enumerate() {
            let modes = self.modes.means(v, length);
            fill(u, &mut |place, weight| {
                for (mode, value) in modes.iter().enumerate() {
                    columns[(mode * table_places + place, column)] = weight * value;
                }
            });
        }
        columns
    }

    /// Weights on the table of a surface to other surfaces.
    fn weights(&self, known: &KnownSurface, points: &[Spot]) -> Mat<f64> {
        self.columns(points, known.places(), |u, put| {
            known.spline.weights(u.clamp(known.range[0], known.range[1])).each(put);
        })
    }

    /// Weights on the table of a surface to itself. Continuing it straight in both variables beyond the samples would add at its corner what it
    /// should not: towards a free edge the compliance of a point grows with the logarithm of the distance, whatever that of its
    /// neighbours. The two more places of each polynomial take it away again. Higher polynomials stay what they are at the outermost
    /// samples: a slope of theirs is not known well enough, and a wrong one outweighs the half-space under a narrow cell.
    fn own_weights(&self, known: &KnownSurface, points: &[Spot]) -> Mat<f64> {
        let places = known.places() + 2;
        let samples = known.stretched.nodes();
        let [first, last] = [samples[0], samples[samples.len() - 1]];
        let mut columns = Mat::zeros(self.modes.count() * places, points.len());
        for (column, &Spot { place: [u, v], length }) in points.iter().enumerate() {
            let t = known.stretch.at(u.clamp(known.range[0], known.range[1]));
            let beyond = known.stretched.beyond(t);
            for (mode, value) in self.modes.means(v, length).iter().enumerate() {
                let continued = mode < CONTINUED;
                let at = if continued { t } else { t.clamp(first, last) };
                known.stretched.weights(at).each(&mut |place, weight| {
                    columns[(mode * places + place, column)] = weight * value;
                });
                if continued && beyond != 0.0 {
                    let place = known.places() + usize::from(beyond > 0.0);
                    columns[(mode * places + place, column)] = beyond.abs() * value;
                }
            }
        }
        columns
    }

    /// Compliances within one surface, `first` by `second`.
    fn own_compliance(
        &self,
        known: &KnownSurface,
        table: &Mat<f64>,
        first: &[Spot],
        second: &[Spot],
    ) -> Mat<f64> {
        let columns = [first, second].map(|points| self.own_weights(known, points));
        let mut block =
            product(columns[0].transpose(), product(table.as_ref(), columns[1].as_ref()).as_ref());
        // A load at a place, as the polynomials see it, is this along the line through it.
        let along = [first, second].map(|points| self.columns(points, 1, |_, put| put(0, 1.0)));
        let lines = product(along[0].transpose(), along[1].as_ref());
        let turned = |points: &[Spot]| {
            points.iter().map(|spot| known.turned_at(spot.place[0])).collect::<Vec<Turned>>()
        };
        let (first, second) = (turned(first), turned(second));
        for (column, &b) in second.iter().enumerate() {
            for (row, &a) in first.iter().enumerate() {
                block[(row, column)] += lines[(row, column)] * self.curved_part(known, a, b);
            }
        }
        block
    }
}

impl Weights {
    fn each(&self, put: &mut dyn FnMut(usize, f64)) {
        for (k, &value) in self.values.iter().enumerate() {
            put(self.first + k, value);
        }
    }
}

/// An order of lists of spots.
fn compare(a: &[Spot], b: &[Spot]) -> Ordering {
    let values = |points: &[Spot]| {
        points.iter().flat_map(|spot| [spot.place[0], spot.place[1], spot.length]).collect::<Vec<f64>>()
    };
    let (a, b) = (values(a), values(b));
    let by_value = || a.iter().zip(&b).map(|(a, b)| a.total_cmp(b)).find(|order| order.is_ne());
    a.len().cmp(&b.len()).then_with(|| by_value().unwrap_or(Ordering::Equal))
}

impl SolidStructure for ElasticSolid {
    fn surface(&self, surface: u32) -> Arc<dyn Surface> {
        self.surfaces[surface as usize].surface.clone()
    }

    fn tooth_angle(&self, tooth: u32) -> f64 {
        TAU * f64::from(tooth % self.teeth) / f64::from(self.teeth)
    }

    fn teeth(&self) -> u32 {
        self.teeth
    }

    fn surface_modulus(&self) -> f64 {
        self.surface_modulus
    }

    fn mirrors(&self) -> &[Mirror] {
        &self.mirrors
    }

    fn add_compliance(
        &self,
        observe: Chart,
        observers: &[Spot],
        load: Chart,
        loads: &[Spot],
        block: &mut [f64],
    ) {
        let (Some(observed), Some(loaded)) = (self.known(observe), self.known(load)) else { return };
        let ahead = self.places_ahead(load.tooth, observe.tooth);
        let behind = self.places_ahead(observe.tooth, load.tooth);
        let Some(tables) = self.offsets.get(ahead.min(behind) as usize) else { return };
        // Of the two orientations, the stored one: the observer ahead, or on the higher surface of the same tooth, or the greater list of
        // the same surface. Half way round a ring of even number each is ahead of the other; the higher tooth decides.
        let same = ahead == 0 && observe.surface == load.surface;
        let order = if same {
            compare(observers, loads)
        } else if ahead == 0 {
            observe.surface.cmp(&load.surface)
        } else if ahead == behind {
            (observe.tooth % self.teeth).cmp(&(load.tooth % self.teeth))
        } else {
            behind.cmp(&ahead)
        };
        let forward = order.is_ge();
        let ((first, first_points), (second, second_points)) = if forward {
            ((observe, observers), (load, loads))
        } else {
            ((load, loads), (observe, observers))
        };
        let table = &tables.compliance[first.surface as usize][second.surface as usize];
        let mut values = if same {
            self.own_compliance(observed, table, first_points, second_points)
        } else {
            let (first, second) = if forward { (observed, loaded) } else { (loaded, observed) };
            let [rows, columns] = [(first, first_points), (second, second_points)]
                .map(|(known, points)| self.weights(known, points));
            product(rows.transpose(), product(table.as_ref(), columns.as_ref()).as_ref())
        };
        if same && order.is_eq() {
            mirror_lower(&mut values);
        }
        for (row, target) in block.chunks_exact_mut(loads.len().max(1)).enumerate() {
            for (column, target) in target.iter_mut().enumerate() {
                *target += if forward { values[(row, column)] } else { values[(column, row)] };
            }
        }
    }

    fn stresses(&self, tooth: u32, surface: u32, loads: &[SpotLoad]) -> Vec<SurfaceStress> {
        let Some(observed) = self.surfaces.get(surface as usize) else { return Vec::new() };
        let mut components = Mat::<f64>::zeros(3 * observed.stress_positions.len(), 1);
        let mut by_chart = BTreeMap::<Chart, (Vec<Spot>, Vec<f64>)>::new();
        for load in loads {
            let (spots, forces) = by_chart.entry(load.chart).or_default();
            spots.push(load.spot);
            forces.push(load.force);
        }
        for (chart, (spots, forces)) in &by_chart {
            let Some(loaded) = self.known(*chart) else { continue };
            let ahead = self.places_ahead(chart.tooth, tooth);
            let behind = self.places_ahead(tooth, chart.tooth);
            let Some(tables) = self.offsets.get(ahead.min(behind) as usize) else { continue };
            let tables = if ahead <= behind { &tables.stress_ahead } else { &tables.stress_behind };
            let table = &tables[surface as usize][chart.surface as usize];
            let forces = MatRef::from_column_major_slice(forces, forces.len(), 1);
            components +=
                product(table.as_ref(), product(self.weights(loaded, spots).as_ref(), forces).as_ref());
        }
        let (sin, cos) = self.tooth_angle(tooth).sin_cos();
        let stress = |(place, &[x, y, z]): (usize, &[f64; 3])| {
            let components = [0, 1, 2].map(|component| components[(3 * place + component, 0)]);
            let position = [cos * x - sin * y, sin * x + cos * y, z];
            SurfaceStress { tooth, surface, position, components }
        };
        observed.stress_positions.iter().enumerate().map(stress).collect()
    }

    fn bytes(&self) -> usize {
        let known = |known: &KnownSurface| {
            known.spline.bytes()
                + known.stretched.bytes()
                + size_of_val(known.turned.as_slice())
                + size_of_val(known.stress_positions.as_slice())
        };
        let tables = self.offsets.iter().flat_map(|tables| {
            [&tables.compliance, &tables.stress_ahead, &tables.stress_behind].into_iter().flatten().flatten()
        });
        let entries: usize = tables.map(|table| table.nrows() * table.ncols()).sum();
        self.surfaces.iter().map(known).sum::<usize>() + entries * size_of::<f64>()
    }

    fn stored(&self) -> Option<Vec<u8>> {
        self.to_bytes()
    }
}
