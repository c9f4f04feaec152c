//! Influence functions of a condensed structure, evaluated from its tables: compliances between
//! points of its surfaces, and stresses.

use super::local::{Local, NormalAngle};
use super::modified_surface::ModifiedStructure;
use super::{ElasticStructure, Surface};
use crate::bore_coupling::{BoreCoupling, Coupling};
use crate::bspline::BSplineWeights;
use crate::dense::{add_product, mirror_lower};
use crate::far_coupling::FarCoupling;
use crate::profile::Profile;
use crate::raceway::Raceway;
use crate::{Chart, ModifiedSurface, SplineToothForce, StressPoint, Structure, SurfaceLoad};
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use faer::{Mat, MatRef};
use std::cmp::Ordering;
use std::f64::consts::PI;
use std::sync::Arc;

impl ElasticStructure {
    /// Returns the non-smooth part of the compliance where `a` and `b` coincide that curvature adds
    /// to the half-plane's logarithm.
    pub(crate) fn curvature_term(&self, surface: &Surface, a: NormalAngle, b: NormalAngle) -> f64 {
        // Convex is positive: the angle increases with the arc length.
        let turn = if a.s >= b.s { a.angle - b.angle } else { b.angle - a.angle };
        // The distance is relative to the length of the surface, so that the term vanishes for a
        // straight one.
        let distance = (a.s - b.s).abs() / surface.profile.length();
        let logarithmic = if distance > 0.0 { turn * turn * distance.ln() } else { 0.0 };
        self.kink * turn + logarithmic / (PI * self.surface_modulus)
    }

    /// Returns the error of linear extrapolation in both variables at the corner of a surface's
    /// table: towards a free edge the compliance of a point grows with the logarithm of the
    /// distance, independently of the neighbouring points.
    fn twist(&self, surface: u32, directions: [usize; 2], a: Local, b: Local) -> f64 {
        if a.beyond * b.beyond <= 0.0 {
            return 0.0;
        }
        let pair = (surface as usize * self.directions + directions[0]) * self.directions + directions[1];
        a.beyond * b.beyond * self.twists[pair][usize::from(a.beyond > 0.0)]
    }

    /// Returns the pairs of directions in which two points are loaded and observed, with the
    /// product of their shares.
    fn shared_directions(&self, a: Local, b: Local) -> impl Iterator<Item = ([usize; 2], f64)> {
        let pairs = (0..self.directions).flat_map(|of_a| (0..self.directions).map(move |of_b| [of_a, of_b]));
        pairs
            .map(move |[of_a, of_b]| ([of_a, of_b], a.direction[of_a] * b.direction[of_b]))
            .filter(|(_, share)| *share != 0.0)
    }

    /// Returns the number of sectors ahead, around the ring, from one tooth to another.
    fn sectors_ahead(&self, from: u32, to: u32) -> u32 {
        (to % self.teeth + self.teeth - from % self.teeth) % self.teeth
    }

    /// [`Structure::add_compliance_until`] between points as the tables see them.
    pub(crate) fn add_between(
        &self,
        observe: Chart,
        observers: &[Local],
        load: Chart,
        loads: &[Local],
        block: &mut [f64],
        interrupt: &Interrupt,
    ) -> Result<(), EngineError> {
        let Some(observed) = self.surface(observe) else { return Ok(()) };
        let ahead = self.sectors_ahead(load.tooth, observe.tooth);
        let behind = self.sectors_ahead(observe.tooth, load.tooth);
        let same_tooth = ahead == 0;
        let same = same_tooth && observe.surface == load.surface;
        // Use the stored one of the two orientations: the observer ahead, or on the higher surface
        // of the same tooth. Halfway round a ring with an even number of teeth each is ahead of the
        // other; the higher tooth decides.
        let forward = if same_tooth {
            observe.surface >= load.surface
        } else if ahead == behind {
            observe.tooth % self.teeth > load.tooth % self.teeth
        } else {
            ahead < behind
        };
        let sides = if forward { [observe, load] } else { [load, observe] };
        let tables = self.offsets.get(ahead.min(behind) as usize);
        for coupling in self.couplings(tables.is_some()) {
            self.add_through(coupling, forward, (observe, observers), (load, loads), block, interrupt)?;
        }
        let Some(tables) = tables else { return Ok(()) };
        let [rows, columns] = sides.map(|chart| chart.surface as usize * self.directions);
        for (row, &observer) in observers.iter().enumerate() {
            interrupt.check()?;
            for (column, &load) in loads.iter().enumerate() {
                // Within one symmetric table the larger arc length goes first, on whichever side it
                // is.
                let first = if same { observer.is_before(&load) } else { forward };
                let (first, second) = if first { (observer, load) } else { (load, observer) };
                let mut sum =
                    if same { self.curvature_term(observed, first.turned, second.turned) } else { 0.0 };
                for ([of_first, of_second], share) in self.shared_directions(first, second) {
                    let table = &tables.compliance[rows + of_first][columns + of_second];
                    let between = |a: BSplineWeights, b: BSplineWeights| a.sum(|i| b.sum(|j| table[(i, j)]));
                    sum += share
                        * if same {
                            between(first.stretched, second.stretched)
                                - self.twist(observe.surface, [of_first, of_second], first, second)
                        } else {
                            between(first.weights, second.weights)
                        };
                }
                block[row * loads.len() + column] += sum;
            }
        }
        Ok(())
    }

    /// Returns the couplings of two teeth in addition to their table, or in place of one.
    fn couplings(&self, in_table: bool) -> impl Iterator<Item = &dyn Coupling> {
        let far = self.far.as_ref().filter(|_| !in_table).map(|far| far as &dyn Coupling);
        let bore = self.bore.as_ref().filter(|bore| !bore.is_in_tables());
        far.into_iter().chain(bore.map(|bore| bore as &dyn Coupling))
    }

    /// Adds the coupling that [`Self::add_between`] adds to tables, computed in one of two
    /// orientations. `forward` selects it, unless both are on one surface, where the greater list
    /// goes first.
    fn add_through(
        &self,
        coupling: &dyn Coupling,
        forward: bool,
        (observe, observers): (Chart, &[Local]),
        (load, loads): (Chart, &[Local]),
        block: &mut [f64],
        interrupt: &Interrupt,
    ) -> Result<(), EngineError> {
        let teeth = [observe, load].map(|chart| (chart.tooth % self.teeth, chart.surface));
        let order = if teeth[0] == teeth[1] { compare(observers, loads) } else { Ordering::Greater };
        let forward = if teeth[0] == teeth[1] { order.is_ge() } else { forward };
        let [first, second] = if forward {
            [(observe, observers), (load, loads)]
        } else {
            [(load, loads), (observe, observers)]
        };
        let forces_of = |(chart, points): (Chart, &[Local])| {
            self.coupling_forces(coupling, chart.surface, points.iter().copied())
        };
        let [observed, loaded] = [first, second].map(|of| (of.0.tooth, forces_of(of)));
        let [observed, loaded] = [&observed, &loaded].map(|(tooth, forces)| (*tooth, forces));
        let mut values = coupling.compliance(observed, loaded, interrupt)?;
        if order.is_eq() {
            mirror_lower(&mut values);
        }
        for (row, target) in block.chunks_exact_mut(loads.len().max(1)).enumerate() {
            for (column, target) in target.iter_mut().enumerate() {
                *target += if forward { values[(row, column)] } else { values[(column, row)] };
            }
        }
        Ok(())
    }

    /// Returns the forces by which unit loads on a surface act on other sectors.
    fn coupling_forces(
        &self,
        coupling: &dyn Coupling,
        surface: u32,
        loads: impl ExactSizeIterator<Item = Local> + Clone,
    ) -> Mat<f64> {
        let mut forces = Mat::zeros(coupling.count(), loads.len());
        let places = self.surfaces.get(surface as usize).map_or(0, |surface| surface.spline.nodes().len());
        for direction in 0..self.directions {
            let side = surface as usize * self.directions + direction;
            let Some(table) = coupling.by_loads(side) else { continue };
            let mut columns = Mat::zeros(places, loads.len());
            for (column, load) in loads.clone().enumerate() {
                let BSplineWeights { first, values } = load.weights;
                for (k, value) in values.iter().enumerate() {
                    columns[(first + k, column)] = load.direction[direction] * value;
                }
            }
            add_product(forces.as_mut(), 1.0, table.as_ref(), columns.as_ref());
        }
        forces
    }

    /// Computes [`Structure::stresses`] under loads in table coordinates, N/m.
    pub(crate) fn stresses_by(
        &self,
        tooth: u32,
        surface: u32,
        loads: impl Iterator<Item = (Chart, Local, f64)>,
    ) -> Vec<(StressPoint, f64)> {
        let Some(observed) = self.surfaces.get(surface as usize) else {
            return Vec::new();
        };
        let mut stress = vec![0.0; observed.stress_points.len()];
        for (chart, local, force) in loads {
            let ahead = self.sectors_ahead(chart.tooth, tooth);
            let behind = self.sectors_ahead(tooth, chart.tooth);
            let tables = self.offsets.get(ahead.min(behind) as usize);
            for coupling in self.couplings(tables.is_some()) {
                let felt = self.coupling_forces(coupling, chart.surface, [local].into_iter());
                if let Some(through) = coupling.stresses(surface as usize, tooth, (chart.tooth, &felt)) {
                    let all = stress.iter_mut().zip(through.col(0).iter());
                    all.for_each(|(value, row)| *value += force * row);
                }
            }
            let Some(tables) = tables else { continue };
            let tables = if ahead <= behind { &tables.stress_ahead } else { &tables.stress_behind };
            for direction in (0..self.directions).filter(|&direction| local.direction[direction] != 0.0) {
                let table = &tables[surface as usize][chart.surface as usize * self.directions + direction];
                let force = force * local.direction[direction];
                for (row, value) in stress.iter_mut().enumerate() {
                    *value += force * local.weights.sum(|i| table[(row, i)]);
                }
            }
        }
        let (sin, cos) = self.tooth_angle(tooth).sin_cos();
        let place = |&(s, [x, y]): &(f64, [f64; 2])| StressPoint {
            tooth,
            surface,
            s,
            position: [cos * x - sin * y, sin * x + cos * y],
        };
        observed.stress_points.iter().map(place).zip(stress).collect()
    }

    /// Computes [`Structure::spline_tooth_forces`] under loads in table coordinates, N/m.
    pub(crate) fn spline_tooth_forces_by(
        &self,
        loads: impl Iterator<Item = (Chart, Local, f64)>,
    ) -> Vec<SplineToothForce> {
        let Some(bore) = &self.bore else { return Vec::new() };
        let mut all = Mat::zeros(bore.count(), 1);
        for (chart, local, force) in loads {
            let constrained = self.coupling_forces(bore, chart.surface, [local].into_iter());
            all += bore.in_body(chart.tooth, &constrained) * faer::Scale(force);
        }
        bore.spline_tooth_forces(&all)
    }

    /// Computes [`Structure::interface_displacements`] under loads in table coordinates.
    pub(crate) fn interface_displacements_by(&self, chart: Chart, loads: &[Local]) -> Mat<f64> {
        let Some(bore) = &self.bore else { return Mat::zeros(0, loads.len()) };
        let constrained = self.coupling_forces(bore, chart.surface, loads.iter().copied());
        bore.interface_displacements(chart.tooth, &constrained)
    }

    pub(crate) fn surface(&self, chart: Chart) -> Option<&Surface> {
        self.surfaces.get(chart.surface as usize)
    }
}

/// Compares lists of points of a surface.
fn compare(a: &[Local], b: &[Local]) -> Ordering {
    let values = |points: &[Local]| {
        points.iter().flat_map(|point| [point.turned.s, point.direction[1]]).collect::<Vec<f64>>()
    };
    let (a, b) = (values(a), values(b));
    let by_value = || a.iter().zip(&b).map(|(a, b)| a.total_cmp(b)).find(|order| order.is_ne());
    a.len().cmp(&b.len()).then_with(|| by_value().unwrap_or(Ordering::Equal))
}

impl Structure for ElasticStructure {
    fn profile(&self, surface: u32) -> Arc<dyn Profile> {
        self.surfaces[surface as usize].profile.clone()
    }

    fn teeth(&self) -> u32 {
        self.teeth
    }

    fn surface_modulus(&self) -> f64 {
        self.surface_modulus
    }

    fn reference_length(&self) -> f64 {
        self.reference_length
    }

    fn add_compliance_until(
        &self,
        observe: Chart,
        observe_s: &[f64],
        load: Chart,
        load_s: &[f64],
        block: &mut [f64],
        interrupt: &Interrupt,
    ) -> Result<(), EngineError> {
        let (Some(observed), Some(loaded)) = (self.surface(observe), self.surface(load)) else {
            return Ok(());
        };
        let observers: Vec<Local> = observe_s.iter().map(|&s| observed.local(s)).collect();
        let loads: Vec<Local> = load_s.iter().map(|&s| loaded.local(s)).collect();
        self.add_between(observe, &observers, load, &loads, block, interrupt)
    }

    /// Returns the stress along the surface: on a free surface, the principal stress that is not
    /// zero. It is negative in compression.
    fn stresses(&self, tooth: u32, surface: u32, loads: &[SurfaceLoad]) -> Vec<(StressPoint, f64)> {
        let seen = loads
            .iter()
            .filter_map(|load| Some((load.chart, self.surface(load.chart)?.local(load.s), load.force)));
        self.stresses_by(tooth, surface, seen)
    }

    fn spline_tooth_forces(&self, loads: &[SurfaceLoad]) -> Vec<SplineToothForce> {
        let seen = loads
            .iter()
            .filter_map(|load| Some((load.chart, self.surface(load.chart)?.local(load.s), load.force)));
        self.spline_tooth_forces_by(seen)
    }

    fn interface_compliance(&self) -> Option<MatRef<'_, f64>> {
        Some(self.bore.as_ref()?.interface.as_ref()?.compliance.as_ref())
    }

    fn raceway(&self) -> Option<Raceway> {
        self.bore.as_ref()?.interface.as_ref()?.raceway
    }

    fn interface_displacements(&self, load: Chart, load_s: &[f64]) -> Mat<f64> {
        let local = |&s: &f64| Some(self.surface(load)?.local(s));
        self.interface_displacements_by(load, &load_s.iter().filter_map(local).collect::<Vec<_>>())
    }

    fn stresses_by_interface(&self, tooth: u32, surface: u32, forces: &[f64]) -> Vec<f64> {
        let all = MatRef::from_column_major_slice(forces, forces.len(), 1);
        let stresses = |bore: &BoreCoupling| bore.stresses_by_interface(surface as usize, tooth, all);
        let stresses = self.bore.as_ref().filter(|_| !forces.is_empty()).and_then(stresses);
        stresses.map_or_else(Vec::new, |stresses| stresses.col(0).iter().copied().collect())
    }

    fn with_modified_surfaces(self: Arc<Self>, surfaces: Vec<ModifiedSurface>) -> Option<Arc<dyn Structure>> {
        (self.directions == 2 && surfaces.len() == self.surfaces.len())
            .then(|| Arc::new(ModifiedStructure::new(self, surfaces)) as Arc<dyn Structure>)
    }

    fn bytes(&self) -> usize {
        let tables = self.offsets.iter().flat_map(|tables| {
            [&tables.compliance, &tables.stress_ahead, &tables.stress_behind].into_iter().flatten().flatten()
        });
        let entries: usize = tables.map(|table| table.nrows() * table.ncols()).sum();
        let far = self.bore.as_ref().map_or(0, BoreCoupling::bytes)
            + self.far.as_ref().map_or(0, FarCoupling::bytes);
        self.surfaces.iter().map(Surface::bytes).sum::<usize>() + entries * size_of::<f64>() + far
    }

    fn stored(&self) -> Option<Vec<u8>> {
        self.to_bytes()
    }
}
