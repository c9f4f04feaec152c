//! Global phase: rounds of local searches, from designs of a sample and then from designs near the
//! best optimum.
//!
//! The first round begins at the initial design and at designs of a Sobol sample that have no better
//! design of the sample nearby, as in multi-level single linkage. If its searches end at different
//! optima, the following rounds begin near the best one, as in monotonic basin hopping, until a
//! round does not improve it.
//!
//! A. H. G. Rinnooy Kan and G. T. Timmer, "Stochastic global optimization methods, part II:
//! multi-level methods", Mathematical Programming 39 (1987), 57-78. R. H. Leary, "Global optimization
//! on funneling landscapes", J. Global Optimization 18 (2000), 367-383.

use super::evaluation::{Evaluator, Stop};
use super::local_search::{self, FIRST_RADIUS};
use super::problem::Problem;
use crate::sweep::sampling::{MOST_SOBOL_DIMENSIONS, coordinates};
use calyx_report::optimization::{
    FEASIBLE, SAME_OBJECTIVE, SAME_VARIABLE, SMALL, Search, Values, Variable, compare,
};
use calyx_report::study::Method;
use rayon::prelude::*;
use std::f64::consts::PI;

/// Number of designs of the sample per search of the first round.
const SAMPLED: usize = 16;
/// Number of designs near the best one per search of a later round.
const SAMPLED_NEARBY: usize = 8;
/// Half the width of the box around the best design, relative to the ranges of the variables.
const NEARBY: f64 = 0.2;
/// Radius of the first trust region of a search from that box.
const NEARBY_RADIUS: f64 = 0.05;
/// Factor σ of the critical distance.
const LINKAGE: f64 = 2.0;

/// Coordinates of a design in the unit cube and its values; `None` if it failed.
type Candidate = (Vec<f64>, Option<Values>);

/// Runs all searches. `initial` is the initial design in the unit cube.
///
/// # Errors
/// The optimization is cancelled, or the journal cannot be written.
pub fn run(evaluator: &Evaluator<'_>, initial: &[f64]) -> Result<Vec<Search>, Stop> {
    let effort = evaluator.problem().effort;
    let starts = first_starts(evaluator, initial)?;
    let values = evaluator.values(0, initial)?;
    evaluator.find_exact_variables(initial)?;
    let initial = values.ok().map(|values| values.objective);
    let mut searches = local_searches(evaluator, 0, &starts, FIRST_RADIUS)?;
    for round in 1..effort.rounds {
        if effort.starts == 1 || agree(evaluator.problem(), &searches, initial) {
            break;
        }
        let Some(best) = best(evaluator.problem(), &searches).cloned() else { break };
        let starts = starts_near(evaluator, &best.0, round)?;
        evaluator.add_searches(starts.len());
        let found = local_searches(evaluator, searches.len(), &starts, NEARBY_RADIUS)?;
        let improved = found.iter().any(|search| {
            search
                .best
                .as_ref()
                .is_some_and(|(_, values)| is_better(evaluator.problem(), values, &best.1, initial))
        });
        searches.extend(found);
        if !improved {
            break;
        }
    }
    Ok(searches)
}

/// Runs local searches from some designs, numbered after those before.
fn local_searches(
    evaluator: &Evaluator<'_>,
    before: usize,
    starts: &[Vec<f64>],
    radius: f64,
) -> Result<Vec<Search>, Stop> {
    let search = |(k, start): (usize, &Vec<f64>)| {
        let found = local_search::run(evaluator, before + k + 1, start, radius)?;
        evaluator.end_search();
        Ok(found)
    };
    starts.par_iter().enumerate().map(search).collect()
}

fn best<'s>(problem: &Problem, searches: &'s [Search]) -> Option<&'s (Vec<f64>, Values)> {
    let known = searches.iter().filter_map(|search| search.best.as_ref());
    known.min_by(|one, other| compare(&problem.objective, &one.1, &other.1))
}

/// Returns whether a design improves on another one by more than searches with the same optimum
/// differ. `initial` is the initial objective, of whose improvement a small part counts as zero.
fn is_better(problem: &Problem, one: &Values, other: &Values, initial: Option<f64>) -> bool {
    let change = (one.objective - other.objective).abs();
    let improvement = initial.map_or(0.0, |initial| (initial - one.objective).abs());
    let scale = one.objective.abs().max(SMALL * improvement);
    compare(&problem.objective, one, other).is_lt()
        && (change > SAME_OBJECTIVE * scale || other.violation > FEASIBLE)
}

/// Returns whether all searches end with the same objective and the same variables.
fn agree(problem: &Problem, searches: &[Search], initial: Option<f64>) -> bool {
    let Some((variables, best)) = best(problem, searches) else { return true };
    let is_near = |(variable, (one, other)): (&Variable, (&f64, &f64))| {
        (one - other).abs() <= SAME_VARIABLE * (variable.high - variable.low)
    };
    let is_same = |(own, values): &(Vec<f64>, Values)| {
        let pairs = own.iter().zip(variables);
        !is_better(problem, best, values, initial) && problem.variables.iter().zip(pairs).all(is_near)
    };
    searches.iter().all(|search| search.best.as_ref().is_some_and(is_same))
}

/// Returns the starts of the first round: the initial design, unless it fails, and the best distant
/// designs of a sample.
fn first_starts(evaluator: &Evaluator<'_>, initial: &[f64]) -> Result<Vec<Vec<f64>>, Stop> {
    let effort = evaluator.problem().effort;
    if effort.starts == 1 {
        return Ok(vec![initial.to_vec()]);
    }
    let mut points = vec![initial.to_vec()];
    points.extend(sample(initial.len(), effort.seed, SAMPLED * (effort.starts - 1)));
    let mut candidates = evaluated(evaluator, points)?;
    let (first, values) = candidates.remove(0);
    let others = distant(evaluator.problem(), candidates, effort.starts - 1);
    let first = (values.is_some() || others.is_empty()).then_some(first);
    Ok(first.into_iter().chain(others).collect())
}

/// Returns the starts of a later round: the best distant designs of a sample around the best one.
fn starts_near(evaluator: &Evaluator<'_>, best: &[f64], round: usize) -> Result<Vec<Vec<f64>>, Stop> {
    let problem = evaluator.problem();
    let variables = problem.variables.iter().zip(best);
    let centre: Vec<f64> =
        variables.map(|(variable, si)| (si - variable.low) / (variable.high - variable.low)).collect();
    let seed = problem.effort.seed.wrapping_add(round as u64);
    let within = |point: Vec<f64>| -> Vec<f64> {
        let parts = point.iter().zip(&centre);
        parts.map(|(part, centre)| (centre + NEARBY * (2.0 * part - 1.0)).clamp(0.0, 1.0)).collect()
    };
    let points = sample(centre.len(), seed, SAMPLED_NEARBY * problem.effort.starts);
    let candidates = evaluated(evaluator, points.into_iter().map(within).collect())?;
    Ok(distant(problem, candidates, problem.effort.starts))
}

/// Returns points in the unit cube: those of Sobol, or a Latin hypercube in many dimensions.
fn sample(variables: usize, seed: u64, count: usize) -> Vec<Vec<f64>> {
    let method = if variables <= MOST_SOBOL_DIMENSIONS { Method::Sobol } else { Method::LatinHypercube };
    let by_variable: Vec<Vec<f64>> =
        (0..variables).map(|variable| coordinates(method, seed, variable, count)).collect();
    (0..count).map(|point| by_variable.iter().map(|all| all[point]).collect()).collect()
}

fn evaluated(evaluator: &Evaluator<'_>, points: Vec<Vec<f64>>) -> Result<Vec<Candidate>, Stop> {
    points.into_par_iter().map(|at| evaluator.values(0, &at).map(|values| (at, values.ok()))).collect()
}

/// Returns the best designs, of which none is nearer to a better one than the critical distance of
/// multi-level single linkage. If there are too few, the distance is halved.
fn distant(problem: &Problem, candidates: Vec<Candidate>, count: usize) -> Vec<Vec<f64>> {
    let known = candidates.into_iter().filter_map(|(at, values)| Some((at, values?)));
    let mut ranked: Vec<(Vec<f64>, Values)> = known.collect();
    // A stable order: equal designs in the order of the sample.
    ranked.sort_by(|(_, one), (_, other)| compare(&problem.objective, one, other));
    let count = count.min(ranked.len());
    let extent = extent(&ranked);
    let mut radius = critical_distance(extent.len(), ranked.len());
    loop {
        let is_distant = |&k: &usize| {
            let distance = |other: &(Vec<f64>, Values)| {
                let parts = ranked[k].0.iter().zip(&other.0).zip(&extent);
                parts.map(|((one, other), extent)| ((one - other) / extent).powi(2)).sum::<f64>().sqrt()
            };
            ranked[..k].iter().all(|better| distance(better) > radius)
        };
        let chosen: Vec<usize> = (0..ranked.len()).filter(is_distant).take(count).collect();
        if chosen.len() == count || radius < f64::EPSILON {
            return chosen.into_iter().map(|k| ranked[k].0.clone()).collect();
        }
        radius *= 0.5;
    }
}

/// Returns the extent of the designs by variable, at least a small one.
fn extent(designs: &[(Vec<f64>, Values)]) -> Vec<f64> {
    let variables = designs.first().map_or(0, |(at, _)| at.len());
    let of = |variable: usize| {
        let parts = designs.iter().map(|(at, _)| at[variable]);
        let (low, high) = parts
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), part| (low.min(part), high.max(part)));
        (high - low).max(f64::EPSILON)
    };
    (0..variables).map(of).collect()
}

/// Returns the critical distance in the unit cube for a number of points,
/// (Γ(1 + n/2) σ ln N / N)^(1/n) / √π.
fn critical_distance(variables: usize, points: usize) -> f64 {
    let (n, points) = (variables.max(1) as f64, points.max(2) as f64);
    (libm::tgamma(1.0 + 0.5 * n) * LINKAGE * points.ln() / points).powf(1.0 / n) / PI.sqrt()
}
