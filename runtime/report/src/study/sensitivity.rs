//! Params that explain the variation of an output: standardized rank regression coefficients and
//! first-order Sobol indices.

use super::statistics::{Estimate, Z, deviation, mean_of, student};

/// Largest degree of the polynomials for first-order indices.
const HIGHEST_DEGREE: usize = 8;
/// Number of samples for each degree of these polynomials.
const SAMPLES_PER_DEGREE: usize = 15;
/// Number of samples for each param below which the estimates are called uncertain.
const SAMPLES_PER_PARAM: usize = 10;
/// Relative variation below which an output is constant apart from rounding.
const ROUNDING: f64 = 1e-9;

/// Influence of a param on an output.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensitivity {
    /// Standardized rank regression coefficient, from -1 to 1.
    pub rank_coefficient: Estimate,
    /// First-order Sobol index: share of the variance that the param explains alone.
    pub first_order: Estimate,
}

/// Influences of all params on an output.
#[derive(Clone, Debug, PartialEq)]
pub struct Sensitivities {
    /// Sensitivities by param.
    pub params: Vec<Sensitivity>,
    /// Share of the variance of the ranks that the rank regression explains.
    pub rank_r2: f64,
    /// True if the samples are so few that the estimates are uncertain.
    pub uncertain: bool,
}

impl Sensitivities {
    /// Estimates the sensitivities from samples `inputs` by param and values of the output.
    ///
    /// # Errors
    /// The output does not vary, the samples are too few, or params depend on each other.
    pub fn of(inputs: &[Vec<f64>], output: &[f64]) -> Result<Sensitivities, String> {
        let (count, params) = (output.len(), inputs.len());
        if count < params + 3 {
            return Err(format!("{count} samples are too few for {params} params"));
        }
        let largest = output.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
        if deviation(output) <= ROUNDING * largest {
            return Err("the output does not vary".into());
        }
        let (coefficients, rank_r2) = rank_regression(inputs, output)
            .ok_or("a param does not vary, or depends linearly on others in this sample")?;
        let first_order = inputs.iter().map(|input| first_order_index(input, output));
        let params = coefficients.into_iter().zip(first_order);
        Ok(Sensitivities {
            params: params
                .map(|(rank_coefficient, first_order)| Sensitivity { rank_coefficient, first_order })
                .collect(),
            rank_r2,
            uncertain: count < SAMPLES_PER_PARAM * inputs.len().max(3),
        })
    }

    /// Returns the indices of the params, the largest share of the variance first.
    pub fn order(&self) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.params.len()).collect();
        let share = |index: &usize| self.params[*index].first_order.value;
        order.sort_by(|one, other| share(other).total_cmp(&share(one)));
        order
    }
}

/// Returns the first-order index of a param: the adjusted coefficient of determination of a
/// regression of the output on polynomials of the param, which are orthogonal on the sample
/// (Forsythe, J. SIAM 5 (1957), 74-88). Its error is that of the influence function of a ratio of
/// variances, with the variance of R² of an unrelated param added.
fn first_order_index(input: &[f64], output: &[f64]) -> Estimate {
    let count = output.len() as f64;
    let degree = (output.len() / SAMPLES_PER_DEGREE).clamp(1, HIGHEST_DEGREE).min(output.len() - 2);
    let (mean, scale) = (mean_of(input), deviation(input));
    let x: Vec<f64> = input.iter().map(|x| if scale > 0.0 { (x - mean) / scale } else { 0.0 }).collect();
    let centre = mean_of(output);
    let mut residual: Vec<f64> = output.iter().map(|y| y - centre).collect();
    let total: f64 = residual.iter().map(|y| y * y).sum();
    let (mut before, mut current) = (vec![0.0; x.len()], vec![1.0; x.len()]);
    let mut norm_before = f64::INFINITY;
    let mut used = 0.0;
    for k in 0..=degree {
        let norm: f64 = current.iter().map(|p| p * p).sum();
        // The param has no more distinct values.
        if norm <= 1e-12 * count {
            break;
        }
        if k > 0 {
            used += 1.0;
            let weight = residual.iter().zip(&current).map(|(y, p)| y * p).sum::<f64>() / norm;
            residual.iter_mut().zip(&current).for_each(|(y, p)| *y -= weight * p);
        }
        let alpha = x.iter().zip(&current).map(|(x, p)| x * p * p).sum::<f64>() / norm;
        let beta = if norm_before.is_finite() { norm / norm_before } else { 0.0 };
        let next: Vec<f64> = (0..x.len()).map(|i| (x[i] - alpha) * current[i] - beta * before[i]).collect();
        (before, current, norm_before) = (current, next, norm);
    }
    let left: f64 = residual.iter().map(|y| y * y).sum();
    let adjusted = left / (count - used - 1.0).max(1.0) / (total / (count - 1.0));
    let variance = total / count;
    let ratio = left / total;
    let influence =
        output.iter().zip(&residual).map(|(y, e)| (e * e - ratio * (y - centre).powi(2)) / variance);
    let spread: f64 = influence.map(|part| part * part).sum::<f64>() / count;
    let error = (spread / count + 2.0 * used / (count * count)).sqrt();
    let value = 1.0 - adjusted;
    let bound = |sign: f64| Some((value + sign * Z * error).clamp(0.0, 1.0));
    Estimate { value: value.clamp(0.0, 1.0), low: bound(-1.0), high: bound(1.0) }
}

/// Returns the standardized coefficients of the linear regression of the ranks, with intervals of
/// Student's t distribution, and the coefficient of determination. `None` if the correlation matrix
/// is singular.
fn rank_regression(inputs: &[Vec<f64>], output: &[f64]) -> Option<(Vec<Estimate>, f64)> {
    let inputs: Vec<Vec<f64>> = inputs.iter().map(|values| standardized_ranks(values)).collect();
    let output = standardized_ranks(output);
    let dot = |one: &[f64], other: &[f64]| one.iter().zip(other).map(|(a, b)| a * b).sum::<f64>();
    let matrix: Vec<Vec<f64>> =
        inputs.iter().map(|one| inputs.iter().map(|other| dot(one, other)).collect()).collect();
    let right: Vec<f64> = inputs.iter().map(|input| dot(input, &output)).collect();
    let inverse = inverse(matrix)?;
    let coefficients: Vec<f64> = inverse.iter().map(|row| dot(row, &right)).collect();
    let explained = dot(&coefficients, &right).clamp(0.0, 1.0);
    let freedom = output.len() as f64 - inputs.len() as f64 - 1.0;
    let t = student(freedom);
    let estimate = |(j, value): (usize, f64)| {
        let half = t * ((1.0 - explained) * inverse[j][j] / freedom).sqrt();
        Estimate { value, low: Some(value - half), high: Some(value + half) }
    };
    Some((coefficients.into_iter().enumerate().map(estimate).collect(), explained))
}

/// Returns ranks, of equal values their mean, with mean 0 and a sum of squares of 1; zeros if all
/// values are equal.
fn standardized_ranks(values: &[f64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|one, other| values[*one].total_cmp(&values[*other]));
    let mut ranks = vec![0.0; values.len()];
    let mut start = 0;
    while start < order.len() {
        let equal = order[start..].iter().take_while(|&&k| values[k] == values[order[start]]).count();
        let rank = start as f64 + 0.5 * (equal as f64 - 1.0);
        order[start..start + equal].iter().for_each(|&k| ranks[k] = rank);
        start += equal;
    }
    let mean = mean_of(&ranks);
    let norm = ranks.iter().map(|rank| (rank - mean).powi(2)).sum::<f64>().sqrt();
    ranks.iter().map(|rank| if norm > 0.0 { (rank - mean) / norm } else { 0.0 }).collect()
}

/// Returns the inverse of a symmetric positive definite matrix by the algorithm of Gauss and
/// Jordan, which needs no pivoting; `None` if it is nearly singular.
fn inverse(mut matrix: Vec<Vec<f64>>) -> Option<Vec<Vec<f64>>> {
    let size = matrix.len();
    for k in 0..size {
        let pivot = matrix[k][k];
        // The diagonal was 1: the pivot is the part of a param that the others do not explain.
        if pivot.is_nan() || pivot < 1e-10 {
            return None;
        }
        matrix[k][k] = 1.0;
        matrix[k].iter_mut().for_each(|value| *value /= pivot);
        let row = matrix[k].clone();
        for (_, other) in matrix.iter_mut().enumerate().filter(|(i, _)| *i != k) {
            let factor = std::mem::replace(&mut other[k], 0.0);
            other.iter_mut().zip(&row).for_each(|(value, part)| *value -= factor * part);
        }
    }
    Some(matrix)
}
