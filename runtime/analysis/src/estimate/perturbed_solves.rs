//! Perturbed solves of quasi-static analyses: the same positions with one setting changed.

use super::mesh_variants::MeshVariant;
use super::sampling::{Promising, SampledOutput, SamplingContext, divided, most_promising};
use super::{
    Ends, ErrorPart, Estimates, Evidence, Part, Statistics, bounds, ends, is_flank_pressure, is_stress,
    rounding, within,
};
use crate::forced_response::forced_response;
use crate::observables::Observe;
use crate::radiated_sound::{self, SoundTask};
use crate::results::DirectedErrors;
use crate::rows::StepRow;
use crate::scene::Scene;
use crate::summary::is_closed;
use calyx_model::fidelity::{BodyModel, Fidelity, StructureOptions};
use calyx_model::observed::OutputRequest;
use calyx_model::pairs::SurfacePair;
use calyx_model::plan::Plan;
use calyx_model::position::Position;
use calyx_model::resources::Resources;
use calyx_numerics::error::EngineError;
use calyx_solve::system::System;
use std::f64::consts::SQRT_2;
use std::ops::ControlFlow;

/// Factor for contact grids with half as many cells.
pub(super) const OF_GRID: f64 = 0.4;
/// The same for pressures on flanks in three dimensions, which are vertices of parabolas through
/// the pressures of a few cells and hardly converge from one grid to the next: measured, see
/// `docs/theory/error-estimates.md`.
const OF_GRID_PRESSURE: f64 = 0.8;
/// Minimum number of positions that are solved again; of many positions, a fraction.
pub(super) const SAMPLES: usize = 8;
pub(super) const PART_OF_POSITIONS: usize = 4;
/// Number of these spread over all positions, for means.
pub(super) const SPREAD: usize = 4;
/// Values within this fraction of peak-to-peak from an extreme may be the extreme.
const NEAR: f64 = 0.05;
/// Lower bound of the error of an extreme relative to the usual error of all samples, because
/// cancellation at the extreme is a coincidence.
const USUAL: f64 = 0.5;
/// Lower bound of the errors of peak-to-peak and mean relative to the errors at both extremes or
/// over all positions, because the degree of cancellation is unknown.
const OF_SUMS: f64 = 0.2;
/// Number of positions per additional position between two, and the number of additional positions
/// up to which there may be more.
const PER_ADDED: usize = 2;
const FEW_ADDED: usize = 16;
/// Number of positions on plane grids of half the cells that take the time of one position.
const COARSE_PER_POSITION: usize = 4;
/// Maximum number of rounds of division; each uses the results of the previous ones. Fewer rounds
/// of more positions overestimate errors: with at least two positions each, the suite of
/// effectivities misses its goal of 95 %.
const ROUNDS: usize = 8;

/// Finished quasi-static analysis.
pub(crate) struct BaseAnalysis<'a, 's> {
    pub scene: &'a Scene,
    pub system: &'a System<'s>,
    pub plan: &'a Plan,
    pub structure: StructureOptions,
    pub highest_frequency: f64,
    pub resources: &'a Resources,
    pub positions: &'a [Position],
    pub outputs: &'a [OutputRequest],
    pub rows: &'a [StepRow],
}

/// Runs the perturbed solves of an analysis.
///
/// # Errors
/// Those of the interrupt. A perturbed solve that fails otherwise leaves its part unestimated.
pub(crate) fn quasi_static_perturbed_solves(
    judged: &BaseAnalysis<'_, '_>,
    estimates: Estimates,
) -> Result<Evidence, EngineError> {
    if judged.rows.is_empty() {
        return Ok(Evidence::default());
    }
    let samples = samples(judged.rows, judged.outputs.len());
    let own: Vec<Vec<Ends>> = (0..judged.outputs.len())
        .map(|output| {
            let all = ends(judged.rows, output);
            samples.iter().map(|&row| all[row]).collect()
        })
        .collect();
    let scene = judged.scene;

    // Both meshes are compared on the coarse grid, which is the cheapest.
    let coarse = coarser_grids(scene, judged.plan.three_dimensional);
    let on_coarse = match &coarse {
        Some(coarse) => judged.solve(&judged.system.on(coarse), judged.plan, &judged.at(&samples)),
        None => Err(Failed::Because("the contact grid has too few cells to halve them".into())),
    };
    let on_coarse = part_of(on_coarse)?;
    let rounding = on_coarse.as_ref().map(|found| found.rounding.clone()).unwrap_or_default();
    let on_coarse = on_coarse.map(|found| found.values(judged.outputs.len()));
    let (compared, base) = match (&coarse, &on_coarse) {
        (Some(coarse), Ok(values)) => (coarse, values),
        _ => (scene, &own),
    };
    let fidelity = judged.plan.fidelity;
    let rows = judged.with_some_between()?;
    let mut found = Vec::new();
    // Levels without a mesh have no mesh error, and rigid bodies have no pressure.
    if fidelity.body_model() == BodyModel::Elements {
        let (meshed, other) = judged.on_another_mesh(compared, &samples)?;
        let factor = |output: usize| other.factor(is_stress(&judged.outputs[output], &scene.observables));
        found.push(judged.found(Part::Discretization, &samples, meshed, base, (factor, other.direction)));
    }
    if fidelity != Fidelity::Rigid {
        // The coarse grid deviates in the direction of the error.
        let factor = |output: usize| judged.grid_factor(output);
        let mut part = judged.found(Part::ContactGrid, &samples, on_coarse.clone(), &own, (factor, 1.0));
        if let (Some(coarse), Ok(errors), true) = (&coarse, &mut part.errors, judged.plan.three_dimensional) {
            judged.include_added_extremes(coarse, &rows, errors)?;
        }
        found.push(part);
    }
    let level = match estimates {
        Estimates::Full => judged.level_above(&samples)?,
        _ => Err("error_estimates = \"full\" estimates it, at more than the cost of the run".to_owned()),
    };
    found.push(judged.found(Part::Level, &samples, level, &own, (|_| 1.0, 0.0)));
    Ok(Evidence { found, rows, rounding })
}

/// Returns the refinement of the next fidelity level for the comparison with a mesh of this
/// refinement. In three dimensions twice as many elements along every direction are eight times as
/// many in total, so the refinement of a plane mesh is not applied there.
pub(super) fn refinement_above(own: Fidelity, above: Fidelity, refinement: f64) -> f64 {
    match (own, above) {
        (Fidelity::Solid(_), _) | (_, Fidelity::Rigid | Fidelity::Analytic | Fidelity::Plane) => refinement,
        (_, Fidelity::Solid(_)) => 1.0,
    }
}

/// Returns the number of positions that are solved between those of an analysis.
///
/// The estimates take at most about the time of the analysis, without structures, which may be
/// cached. Few positions are all solved again on grids of half the cells along every direction, and
/// once more on another mesh if there is one: each at a quarter of the time, and in three
/// dimensions at a sixteenth. Plane positions of closed-form models may be more, because they take
/// milliseconds.
pub(super) fn added_positions(positions: usize, fidelity: Fidelity, three_dimensional: bool) -> usize {
    let solved_again = if fidelity.body_model() == BodyModel::Elements { 2 } else { 1 };
    let on_coarse_grids = if three_dimensional {
        0
    } else {
        (solved_again * SAMPLES.min(positions)).div_ceil(COARSE_PER_POSITION)
    };
    let affordable = match (fidelity.body_model(), three_dimensional) {
        // Plane positions without finite elements take milliseconds.
        (BodyModel::Elements, _) | (_, true) => positions - on_coarse_grids,
        _ => FEW_ADDED,
    };
    positions.div_ceil(PER_ADDED).max(affordable.min(FEW_ADDED))
}

/// Reason why there is no perturbed solve.
enum Failed {
    /// The analysis is interrupted.
    Ended(EngineError),
    Because(String),
}

/// Values by output and by sample.
type Values = Vec<Vec<Ends>>;

/// Positions that were solved in addition.
struct AddedPositions {
    rows: Vec<StepRow>,
    /// Magnitude up to which an output may consist of rounding, by output.
    rounding: Vec<f64>,
}

impl AddedPositions {
    fn values(&self, outputs: usize) -> Values {
        (0..outputs).map(|output| ends(&self.rows, output)).collect()
    }
}

fn part_of<T>(values: Result<T, Failed>) -> Result<Result<T, String>, EngineError> {
    match values {
        Ok(values) => Ok(Ok(values)),
        Err(Failed::Because(reason)) => Ok(Err(reason)),
        Err(Failed::Ended(error)) => Err(error),
    }
}

impl BaseAnalysis<'_, '_> {
    /// Distinguishes an error of the perturbed solve from an interrupt.
    fn failed(&self, error: EngineError) -> Failed {
        match self.resources.interrupt.check() {
            Err(ended) => Failed::Ended(ended),
            Ok(()) => Failed::Because(format!("{}: {}", error.code, error.message)),
        }
    }

    /// Returns the factor on the difference of an output from grids with half as many cells.
    fn grid_factor(&self, output: usize) -> f64 {
        let is_pressure = || is_flank_pressure(&self.outputs[output], &self.scene.observables);
        if self.plan.three_dimensional && is_pressure() { OF_GRID_PRESSURE } else { OF_GRID }
    }

    /// Solves the samples with another model or mesh.
    fn perturbed_solve(
        &self,
        scene: &Scene,
        fidelity: Fidelity,
        structure: StructureOptions,
        samples: &[usize],
    ) -> Result<Values, Failed> {
        let build = || {
            let plan = Plan::new(scene, fidelity, structure)?.for_outputs(scene, self.outputs)?;
            let plan = plan.with_modes(scene, self.highest_frequency);
            let system = System::with(scene, &plan, self.resources)?;
            let system = match self.highest_frequency {
                0.0 => system,
                highest => system.with_modes(&plan, self.resources, highest)?,
            };
            Ok((system, plan))
        };
        let (system, plan) = build().map_err(|error| self.failed(error))?;
        Ok(self.solve(&system, &plan, &self.at(samples))?.values(self.outputs.len()))
    }

    /// Solves the samples on the first of the meshes for a comparison that can be condensed. If
    /// there is none, returns the reason why the preferred one cannot.
    fn on_another_mesh(
        &self,
        scene: &Scene,
        samples: &[usize],
    ) -> Result<(Result<Values, String>, MeshVariant), EngineError> {
        let fidelity = self.plan.fidelity;
        let [preferred, other] = MeshVariant::of(fidelity, self.structure);
        let first = part_of(self.perturbed_solve(scene, fidelity, preferred.structure, samples))?;
        if first.is_ok() {
            return Ok((first, preferred));
        }
        match part_of(self.perturbed_solve(scene, fidelity, other.structure, samples))? {
            Ok(values) => Ok((Ok(values), other)),
            Err(_) => Ok((first, preferred)),
        }
    }

    /// Solves the samples at the next level that supports the scene, or returns the reason why
    /// there is none.
    fn level_above(&self, samples: &[usize]) -> Result<Result<Values, String>, EngineError> {
        let own = self.plan.fidelity;
        // The model error of three-dimensional closed-form models shows in three-dimensional finite
        // elements.
        let three_dimensional = own == Fidelity::Analytic && self.plan.three_dimensional;
        let mut refused = None;
        for fidelity in
            own.all_above().filter(|above| !three_dimensional || matches!(above, Fidelity::Solid(_)))
        {
            let refinement = refinement_above(own, fidelity, self.structure.refinement);
            let structure = StructureOptions { refinement, ..self.structure };
            match part_of(self.perturbed_solve(self.scene, fidelity, structure, samples))? {
                Ok(values) => return Ok(Ok(values)),
                Err(reason) => refused = refused.or(Some(reason)),
            }
        }
        Ok(Err(refused.unwrap_or_else(|| "there is no level above this one".to_owned())))
    }

    fn at(&self, samples: &[usize]) -> Vec<Position> {
        samples.iter().map(|&row| self.positions[row].clone()).collect()
    }

    fn solve(
        &self,
        system: &System<'_>,
        plan: &Plan,
        positions: &[Position],
    ) -> Result<AddedPositions, Failed> {
        self.prepare_sound(system, plan).map_err(|error| self.failed(error))?;
        let solve = |index: usize| {
            let position: &Position = &positions[index];
            self.resources.interrupt.check()?;
            let step = system.solve(position.time)?;
            let observed = system.values(&step, plan.fidelity, &self.scene.observables);
            let rounding = rounding::of_outputs(self.scene, self.outputs, &observed, position.time);
            Ok((StepRow::new(position.clone(), self.outputs, &observed, Vec::new()), rounding))
        };
        let mut besides = AddedPositions { rows: Vec::new(), rounding: vec![0.0; self.outputs.len()] };
        let mut result = Ok(());
        self.resources.in_order(positions.len(), solve, |_, solved| match solved {
            Ok((row, rounding)) => {
                besides.rows.push(row);
                besides.rounding.iter_mut().zip(rounding).for_each(|(most, own)| *most = most.max(own));
                ControlFlow::Continue(())
            }
            Err(error) => {
                result = Err(self.failed(error));
                ControlFlow::Break(())
            }
        });
        result?;
        // An interrupted observable has no value.
        self.resources.interrupt.check().map_err(Failed::Ended)?;
        Ok(besides)
    }

    /// Computes the sound of a system if outputs are values of it. The bodies in the fluid are
    /// those of the analysis.
    fn prepare_sound(&self, system: &System<'_>, plan: &Plan) -> Result<(), EngineError> {
        let requests = &self.scene.sounds;
        let request = self.scene.forced_response.as_ref().filter(|_| !requests.is_empty());
        let Some(request) = request.filter(|_| radiated_sound::of_system(system).is_none()) else {
            return Ok(());
        };
        let (highest_frequency, shared) = (self.highest_frequency, radiated_sound::of_system(self.system));
        let task = SoundTask { requests, plan, highest_frequency, shared };
        forced_response(system, self.scene, request, &task, self.resources).map(drop)
    }

    /// Returns all rows, and some between them where extremes may lie: intervals are divided
    /// repeatedly.
    fn with_some_between(&self) -> Result<Vec<StepRow>, EngineError> {
        let Some(average) = SamplingContext::of(self.rows, None).map(|course| course.average()) else {
            return Ok(self.rows.to_vec());
        };
        let is_closed = |output| is_closed(self.rows, output, self.scene);
        let closed: Vec<bool> = self.outputs.iter().map(is_closed).collect();
        let bounds = |output| bounds::of(output, &self.scene.observables);
        let bounds: Vec<[f64; 2]> = self.outputs.iter().map(bounds).collect();
        let mut all = self.rows.to_vec();
        let mut left = added_positions(self.rows.len(), self.plan.fidelity, self.plan.three_dimensional);
        for round in 0..ROUNDS {
            let course =
                |(output, &closed)| SamplingContext::of(within(&all, self.rows, closed), Some(output));
            let courses: Vec<Option<SamplingContext>> = closed.iter().enumerate().map(course).collect();
            let known = |(output, &closed): (usize, &bool)| {
                let course = courses[output].as_ref()?;
                let ends = ends(within(&all, self.rows, closed), output);
                Some(SampledOutput { course, ends, closed, bounds: bounds[output] })
            };
            let known: Vec<SampledOutput<'_>> = closed.iter().enumerate().filter_map(known).collect();
            let turn = all.len() - self.rows.len();
            let wanted =
                most_promising(&known, average, turn).into_iter().take(left.div_ceil(ROUNDS - round));
            // In three dimensions a tooth pair takes up load gradually along its contact line.
            let own = |promising: Promising| Promising {
                event: promising.event.filter(|_| !self.plan.three_dimensional),
                ..promising
            };
            let positions: Vec<Position> = wanted.map(|promising| divided(&all, own(promising))).collect();
            if positions.is_empty() {
                break;
            }
            left -= positions.len();
            match part_of(self.solve(self.system, self.plan, &positions))? {
                Ok(besides) => all.extend(besides.rows),
                Err(_) => break,
            }
            let place = |row: &StepRow| [row.position.cycle, row.position.time];
            all.sort_by(|a, b| place(a).partial_cmp(&place(b)).unwrap_or(std::cmp::Ordering::Equal));
        }
        Ok(all)
    }

    /// Includes the grid errors of extremes that lie at added positions: a narrow peak between the
    /// positions may be far less accurate than the extremes at them. In three dimensions the coarse
    /// grid takes a sixteenth of the time.
    fn include_added_extremes(
        &self,
        coarse: &Scene,
        rows: &[StepRow],
        errors: &mut [DirectedErrors],
    ) -> Result<(), EngineError> {
        let is_added = |row: usize| self.rows.iter().all(|own| own.position != rows[row].position);
        let extremes = |output: usize| {
            let closed = is_closed(self.rows, &self.outputs[output], self.scene);
            let ends = ends(within(rows, self.rows, closed), output);
            let least = (0..ends.len()).min_by(|&a, &b| ends[a].low.total_cmp(&ends[b].low));
            let most = (0..ends.len()).max_by(|&a, &b| ends[a].high.total_cmp(&ends[b].high));
            [least, most].map(|row| row.filter(|&row| is_added(row)))
        };
        let extremes: Vec<[Option<usize>; 2]> = (0..errors.len()).map(extremes).collect();
        let mut added: Vec<usize> = extremes.iter().flatten().flatten().copied().collect();
        added.sort_unstable();
        added.dedup();
        let positions: Vec<Position> = added.iter().map(|&row| rows[row].position.clone()).collect();
        let solved = self.solve(&self.system.on(coarse), self.plan, &positions);
        let Ok(solved) = part_of(solved)? else { return Ok(()) };
        for (output, (error, [least, most])) in errors.iter_mut().zip(extremes).enumerate() {
            let (own, coarse) = (ends(rows, output), ends(&solved.rows, output));
            let factor = self.grid_factor(output);
            let difference = |row: Option<usize>, of: fn(&Ends) -> f64| {
                let found = row.and_then(|row| added.iter().position(|&one| one == row));
                let signed = found.map(|index| factor * (of(&coarse[index]) - of(&own[added[index]])));
                signed.filter(|signed| signed.is_finite()).unwrap_or(0.0)
            };
            let (min, max) = (difference(least, |end| end.low), difference(most, |end| end.high));
            *error = error.at_least(Statistics { min, max, mean: 0.0, peak_to_peak: max - min });
        }
        Ok(())
    }

    /// Returns the samples that represent their neighbourhood; a sample next to a jump represents
    /// only itself.
    fn between(&self, samples: &[usize]) -> Vec<usize> {
        let all = 0..samples.len();
        let unnamed: Vec<usize> =
            all.clone().filter(|&sample| self.rows[samples[sample]].position.name.is_empty()).collect();
        if unnamed.is_empty() { all.collect() } else { unnamed }
    }

    /// Computes a part of the error from samples with and without its setting changed. The
    /// direction is 1 if the changed setting has an error of the same direction as the analysis, -1
    /// if its error is small, and 0 if directions are unknown.
    fn found(
        &self,
        part: Part,
        samples: &[usize],
        turned: Result<Values, String>,
        base: &Values,
        (factor, direction): (impl Fn(usize) -> f64, f64),
    ) -> ErrorPart {
        let error = |output: usize, turned: &[Ends]| {
            let rows = ends(self.rows, output);
            differences(&rows, samples, &self.between(samples), turned, &base[output])
                .times(factor(output), direction)
        };
        let of_outputs = |turned: Values| turned.iter().enumerate().map(|(o, t)| error(o, t)).collect();
        ErrorPart { part, errors: turned.map(of_outputs) }
    }
}

/// Returns the scene with half as many cells across and along every patch; `None` if no number can
/// be halved.
pub(super) fn coarser_grids(scene: &Scene, three_dimensional: bool) -> Option<Scene> {
    let half = |count: usize| if count > 1 { Some(count.div_ceil(2)) } else { None };
    let mut coarse = scene.clone();
    for SurfacePair { grid, .. } in &mut coarse.pairs {
        grid.half_cells = half(match three_dimensional {
            false => grid.plane_half_cells(),
            true => {
                grid.half_slices = half(grid.half_slices)?;
                grid.solid_half_cells()
            }
        });
        grid.half_cells?;
    }
    Some(coarse)
}

/// Returns the rows that perturbed solves repeat: some spread over all rows, and the extremes of
/// the outputs.
fn samples(rows: &[StepRow], outputs: usize) -> Vec<usize> {
    let most = SAMPLES.max(rows.len().div_ceil(PART_OF_POSITIONS)).min(rows.len());
    let mut chosen: Vec<usize> = (0..SPREAD).map(|k| (2 * k + 1) * rows.len() / (2 * SPREAD)).collect();
    chosen.dedup();
    let mut later = Vec::new();
    for output in 0..outputs {
        let ends = ends(rows, output);
        let extreme = |better: &dyn Fn(&Ends, &Ends) -> bool| {
            (1..ends.len()).fold(0, |best, row| if better(&ends[row], &ends[best]) { row } else { best })
        };
        let (max, min) = (extreme(&|a, b| a.high > b.high), extreme(&|a, b| a.low < b.low));
        let in_order = if ends[max].high.abs() >= ends[min].low.abs() { [max, min] } else { [min, max] };
        chosen.push(in_order[0]);
        later.push(in_order[1]);
    }
    let mut samples: Vec<usize> = Vec::new();
    for row in chosen.into_iter().chain(later) {
        if samples.len() < most && !samples.contains(&row) {
            samples.push(row);
        }
    }
    samples.sort_unstable();
    samples
}

/// Returns the differences of the statistics over `rows` between two solutions of samples; the
/// directions are those of their averages.
fn differences(
    rows: &[Ends],
    samples: &[usize],
    between: &[usize],
    one: &[Ends],
    other: &[Ends],
) -> DirectedErrors {
    // `max` ignores NaN.
    let values = rows.iter().chain(one).chain(other);
    if !values.into_iter().all(|end| (end.value + end.low + end.high).is_finite()) {
        return DirectedErrors::NONE;
    }
    let most = rows.iter().map(|end| end.high).fold(f64::NEG_INFINITY, f64::max);
    let least = rows.iter().map(|end| end.low).fold(f64::INFINITY, f64::min);
    // Samples that may be the extreme; if the extreme is not sampled, those with the nearest
    // values.
    let near = |off: &dyn Fn(&Ends) -> f64| {
        let offs: Vec<f64> = samples.iter().map(|&row| off(&rows[row])).collect();
        let nearest = offs.iter().copied().fold(f64::INFINITY, f64::min);
        let reach = nearest.max(NEAR * (most - least));
        (0..samples.len()).filter(|&sample| offs[sample] <= reach).collect::<Vec<_>>()
    };
    let (at_most, at_least) = (near(&|end| most - end.high), near(&|end| end.low - least));
    let high = |sample: usize| one[sample].high - other[sample].high;
    let low = |sample: usize| one[sample].low - other[sample].low;
    let rms = |values: &mut dyn Iterator<Item = f64>| {
        let (sum, count) = values.fold((0.0, 0), |(sum, count), value: f64| (sum + value * value, count + 1));
        if count == 0 { 0.0 } else { (sum / f64::from(count)).sqrt() }
    };
    let all = || 0..samples.len();
    let middle = all().map(high).sum::<f64>() / samples.len() as f64;
    // Usual error of the difference of two samples.
    let usual_apart = USUAL * SQRT_2 * rms(&mut all().map(|sample| high(sample) - middle));
    let apart = at_most.iter().flat_map(|&most| at_least.iter().map(move |&least| (most, least)));
    let min = rms(&mut at_least.iter().map(|&sample| low(sample))).max(USUAL * rms(&mut all().map(low)));
    let max = rms(&mut at_most.iter().map(|&sample| high(sample))).max(USUAL * rms(&mut all().map(high)));
    let peak_to_peak = rms(&mut apart.map(|(most, least)| high(most) - low(least))).max(usual_apart);
    // A single position has no peak-to-peak value.
    let of_both = if rows.len() > 1 { OF_SUMS * min.max(max) } else { 0.0 };
    let value = |sample: usize| one[sample].value - other[sample].value;
    let mut mean = 0.0;
    for row in 0..rows.len() {
        // Each row has the error of the nearest sample.
        let nearest =
            between.iter().copied().min_by_key(|&sample| samples[sample].abs_diff(row)).unwrap_or(0);
        mean += value(nearest) / rows.len() as f64;
    }
    let size = Statistics {
        min,
        max,
        mean: mean.abs().max(OF_SUMS * rms(&mut all().map(value))),
        peak_to_peak: peak_to_peak.max(of_both),
    };
    let average = |samples: &[usize], of: &dyn Fn(usize) -> f64| {
        samples.iter().map(|&sample| of(sample)).sum::<f64>() / samples.len() as f64
    };
    let (min, max) = (average(&at_least, &low), average(&at_most, &high));
    DirectedErrors::new(size, Statistics { min, max, mean, peak_to_peak: max - min })
}
