//! Influence functions of a condensed three-dimensional body, evaluated from its tables:
//! compliances between points of its surfaces, and stresses.
//!
//! A spot is a column of weights on the tables' samples and polynomials ([`super::table_weights`]),
//! averaged along the spot. A compliance is a product of two such columns and a table. Exchanging
//! loads and observers gives the same bits, because the products are the same: of the two
//! orientations always the same one is computed.

use super::elastic::{ElasticSolid, SurfaceTables};
use super::surface_metric::SurfaceMetric;
use super::table_weights::{TablePoints, TransverseWeights};
use super::{Mirror, SegmentLoad, SolidStructure, SurfaceSegment, SurfaceStress};
use crate::bore_coupling::{BoreCoupling, Coupling};
use crate::dense::{mirror_lower, product};
use crate::elastic::NormalAngle;
use crate::far_coupling::FarCoupling;
use crate::raceway::Raceway;
use crate::surface::Surface;
use crate::{Chart, SplineToothForce};
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use faer::{Mat, MatRef};
use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::sync::Arc;

impl ElasticSolid {
    /// Returns the number of sectors ahead, around the ring, from one tooth to another.
    fn sectors_ahead(&self, from: u32, to: u32) -> u32 {
        (to % self.teeth + self.teeth - from % self.teeth) % self.teeth
    }

    /// Returns the couplings of two teeth in addition to their table, or in place of one.
    fn couplings(&self, in_table: bool) -> impl Iterator<Item = &dyn Coupling> {
        let far = self.far.as_ref().filter(|_| !in_table).map(|far| far as &dyn Coupling);
        let bore = self.bore.as_ref().filter(|bore| !bore.is_in_tables());
        far.into_iter().chain(bore.map(|bore| bore as &dyn Coupling))
    }

    fn known(&self, chart: Chart) -> Option<&SurfaceTables> {
        self.surfaces.get(chart.surface as usize)
    }

    /// Returns points on the table of a surface with other surfaces.
    fn points(&self, known: &SurfaceTables, segments: &[SurfaceSegment]) -> TablePoints {
        let across = |u: f64| {
            let splines = known.spline.weights(u.clamp(known.range[0], known.range[1]));
            TransverseWeights { splines, more: None }
        };
        TablePoints::new(&self.modes, known.places(), segments, across)
    }

    /// Returns points on the table of a surface with itself, which has two more entries for each
    /// polynomial: the increment of a point beyond the samples at either end over the outermost
    /// one.
    fn own_points(&self, known: &SurfaceTables, segments: &[SurfaceSegment]) -> TablePoints {
        let across = |u: f64| {
            let t = known.stretch.at(u.clamp(known.range[0], known.range[1]));
            let beyond = known.stretched.beyond(t);
            let more = (beyond != 0.0).then(|| (known.places() + usize::from(beyond > 0.0), beyond));
            TransverseWeights { splines: known.stretched.weights(t - beyond), more }
        };
        TablePoints::new(&self.modes, known.places() + 2, segments, across)
    }

    /// Returns compliances within one surface: one row for each observer of `second`, one column
    /// for each of `first`. If both are the same points, only the entries below the diagonal.
    fn own_compliance(
        &self,
        known: &SurfaceTables,
        table: &Mat<f64>,
        [first, second]: [&[SurfaceSegment]; 2],
        equal: bool,
        interrupt: &Interrupt,
    ) -> Result<Mat<f64>, EngineError> {
        let columns = [first, second].map(|points| self.own_points(known, points));
        let by_second = columns[1].columns(table, interrupt)?;
        let mut block = columns[0].seen(&by_second, interrupt)?;
        // The projection of a point load on the polynomials, along the line through the point.
        let per_length = known.metric.as_ref().map(SurfaceMetric::per_length);
        let lines = columns[0].lines(&columns[1], per_length.as_ref().map(Mat::as_ref));
        let angle = |segment: &SurfaceSegment| known.normal_angle_at(segment.place[0]);
        let others: Vec<NormalAngle> = second.iter().map(angle).collect();
        let mut curved = vec![0.0; second.len()];
        for (column, segment) in first.iter().enumerate() {
            interrupt.check()?;
            let from = if equal { column } else { 0 };
            self.curvature_terms(known, angle(segment), &others[from..], &mut curved[from..]);
            let entries = &mut block.col_as_slice_mut(column)[from..];
            let along = lines.of(column);
            for ((entry, &line), curved) in
                entries.iter_mut().zip(&columns[1].line()[from..]).zip(&curved[from..])
            {
                *entry += along[line] * curved;
            }
        }
        Ok(block)
    }
}

/// Compares lists of spots.
fn compare(a: &[SurfaceSegment], b: &[SurfaceSegment]) -> Ordering {
    let values = |points: &[SurfaceSegment]| {
        points
            .iter()
            .flat_map(|segment| [segment.place[0], segment.place[1], segment.length])
            .collect::<Vec<f64>>()
    };
    let (a, b) = (values(a), values(b));
    let by_value = || a.iter().zip(&b).map(|(a, b)| a.total_cmp(b)).find(|order| order.is_ne());
    a.len().cmp(&b.len()).then_with(|| by_value().unwrap_or(Ordering::Equal))
}

impl SolidStructure for ElasticSolid {
    fn surface(&self, surface: u32) -> Arc<dyn Surface> {
        self.surfaces[surface as usize].surface.clone()
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

    fn side_faces(&self, surface: u32, u: [f64; 2]) -> Vec<Mirror> {
        let Some(known) = self.surfaces.get(surface as usize) else { return Vec::new() };
        let Some(metric) = &known.metric else { return self.mirrors.to_vec() };
        let mirror = |side: usize| {
            let u = u[side].clamp(known.range[0], known.range[1]);
            metric.sides.mirror(known.surface.as_ref(), side, u)
        };
        vec![mirror(0), mirror(1)]
    }

    fn add_compliance_until(
        &self,
        observe: Chart,
        observers: &[SurfaceSegment],
        load: Chart,
        loads: &[SurfaceSegment],
        block: &mut [f64],
        interrupt: &Interrupt,
    ) -> Result<(), EngineError> {
        interrupt.check()?;
        let (Some(observed), Some(loaded)) = (self.known(observe), self.known(load)) else { return Ok(()) };
        let ahead = self.sectors_ahead(load.tooth, observe.tooth);
        let behind = self.sectors_ahead(observe.tooth, load.tooth);
        let tables = self.offsets.get(ahead.min(behind) as usize);
        // Use the stored one of the two orientations: the observer ahead, or on the higher surface
        // of the same tooth, or the greater list of the same surface. Halfway round a ring with an
        // even number of teeth each is ahead of the other; the higher tooth decides.
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
        let table = tables.map(|tables| &tables.compliance[first.surface as usize][second.surface as usize]);
        let known = if forward { [observed, loaded] } else { [loaded, observed] };
        // Columns belong to the first.
        let mut values = match table {
            Some(table) if same => {
                let points = [first_points, second_points];
                self.own_compliance(observed, table, points, order.is_eq(), interrupt)?
            }
            Some(table) => {
                let columns = self.points(known[1], second_points).columns(table, interrupt)?;
                self.points(known[0], first_points).seen(&columns, interrupt)?
            }
            None => Mat::zeros(second_points.len(), first_points.len()),
        };
        for coupling in self.couplings(tables.is_some()) {
            let felt = |known: &SurfaceTables, chart: Chart, points: &[SurfaceSegment]| {
                let table = coupling.by_loads(chart.surface as usize);
                table.map(|table| self.points(known, points).columns(table, interrupt)).transpose()
            };
            let felt = felt(known[0], first, first_points)?.zip(felt(known[1], second, second_points)?);
            let Some((by_first, by_second)) = felt else { continue };
            let through =
                coupling.compliance((first.tooth, &by_first), (second.tooth, &by_second), interrupt)?;
            values += through.transpose();
        }
        if same && order.is_eq() {
            mirror_lower(&mut values);
        }
        for (row, target) in block.chunks_exact_mut(loads.len().max(1)).enumerate() {
            if forward {
                target.iter_mut().zip(values.col_as_slice(row)).for_each(|(target, value)| *target += value);
            } else {
                target.iter_mut().enumerate().for_each(|(column, target)| *target += values[(row, column)]);
            }
        }
        Ok(())
    }

    fn stresses(&self, tooth: u32, surface: u32, loads: &[SegmentLoad]) -> Vec<SurfaceStress> {
        let Some(observed) = self.surfaces.get(surface as usize) else { return Vec::new() };
        let mut components = Mat::<f64>::zeros(3 * observed.stress_points.len(), 1);
        let mut by_chart = BTreeMap::<Chart, (Vec<SurfaceSegment>, Vec<f64>)>::new();
        for load in loads {
            let (segments, forces) = by_chart.entry(load.chart).or_default();
            segments.push(load.segment);
            forces.push(load.force);
        }
        for (chart, (segments, forces)) in &by_chart {
            let Some(loaded) = self.known(*chart) else { continue };
            let ahead = self.sectors_ahead(chart.tooth, tooth);
            let behind = self.sectors_ahead(tooth, chart.tooth);
            let tables = self.offsets.get(ahead.min(behind) as usize);
            let forces = self.points(loaded, segments).loads(forces);
            for coupling in self.couplings(tables.is_some()) {
                let through = coupling.by_loads(chart.surface as usize).and_then(|table| {
                    let felt = product(table.as_ref(), forces.as_ref());
                    coupling.stresses(surface as usize, tooth, (chart.tooth, &felt))
                });
                through.iter().for_each(|through| components += through);
            }
            let Some(tables) = tables else { continue };
            let tables = if ahead <= behind { &tables.stress_ahead } else { &tables.stress_behind };
            let table = &tables[surface as usize][chart.surface as usize];
            components += product(table.as_ref(), forces.as_ref());
        }
        let (sin, cos) = self.tooth_angle(tooth).sin_cos();
        let stress = |(index, &(place, [x, y, z])): (usize, &([f64; 2], [f64; 3]))| {
            let components = [0, 1, 2].map(|component| components[(3 * index + component, 0)]);
            let position = [cos * x - sin * y, sin * x + cos * y, z];
            SurfaceStress { tooth, surface, place, position, components }
        };
        observed.stress_points.iter().enumerate().map(stress).collect()
    }

    fn spline_tooth_forces(&self, loads: &[SegmentLoad]) -> Vec<SplineToothForce> {
        let Some(bore) = &self.bore else { return Vec::new() };
        let mut all = Mat::zeros(bore.count(), 1);
        for load in loads {
            let table = self.known(load.chart).zip(bore.loads.get(load.chart.surface as usize));
            let Some((loaded, table)) = table else { continue };
            let forces = self.points(loaded, &[load.segment]).loads(&[load.force]);
            let constrained = product(table.as_ref(), forces.as_ref());
            all += bore.in_body(load.chart.tooth, &constrained);
        }
        bore.spline_tooth_forces(&all)
    }

    fn raceway(&self) -> Option<Raceway> {
        self.bore.as_ref()?.interface.as_ref()?.raceway
    }

    fn interface_compliance(&self) -> Option<MatRef<'_, f64>> {
        Some(self.bore.as_ref()?.interface.as_ref()?.compliance.as_ref())
    }

    fn interface_displacements(
        &self,
        load: Chart,
        loads: &[SurfaceSegment],
        interrupt: &Interrupt,
    ) -> Result<Mat<f64>, EngineError> {
        let none = || Ok(Mat::zeros(0, loads.len()));
        let (Some(bore), Some(known)) = (&self.bore, self.known(load)) else { return none() };
        let Some(table) = bore.loads.get(load.surface as usize) else { return none() };
        let constrained = self.points(known, loads).columns(table, interrupt)?;
        Ok(bore.interface_displacements(load.tooth, &constrained))
    }

    fn stresses_by_interface(&self, tooth: u32, surface: u32, forces: &[f64]) -> Vec<[f64; 3]> {
        let all = MatRef::from_column_major_slice(forces, forces.len(), 1);
        let stresses = |bore: &BoreCoupling| bore.stresses_by_interface(surface as usize, tooth, all);
        let stresses = self.bore.as_ref().filter(|_| !forces.is_empty()).and_then(stresses);
        let by_point = |stresses: Mat<f64>| {
            let three = |point: usize| [0, 1, 2].map(|component| stresses[(3 * point + component, 0)]);
            (0..stresses.nrows() / 3).map(three).collect()
        };
        stresses.map_or_else(Vec::new, by_point)
    }

    fn bytes(&self) -> usize {
        let known = |known: &SurfaceTables| {
            known.spline.bytes()
                + known.stretched.bytes()
                + size_of_val(known.turned.as_slice())
                + size_of_val(known.stress_points.as_slice())
                + known.metric.as_ref().map_or(0, SurfaceMetric::bytes)
        };
        let tables = self.offsets.iter().flat_map(|tables| {
            [&tables.compliance, &tables.stress_ahead, &tables.stress_behind].into_iter().flatten().flatten()
        });
        let entries: usize = tables.map(|table| table.nrows() * table.ncols()).sum();
        let couplings = self.bore.as_ref().map_or(0, BoreCoupling::bytes)
            + self.far.as_ref().map_or(0, FarCoupling::bytes);
        self.surfaces.iter().map(known).sum::<usize>() + entries * size_of::<f64>() + couplings
    }

    fn stored(&self) -> Option<Vec<u8>> {
        self.to_bytes()
    }
}
