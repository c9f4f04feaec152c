//! Statistics of a sample as text.

use super::group::{Group, Variation};
use super::statistics::PERCENTILES;
use crate::sample::Statistic;
use crate::summary_table::{align, number};
use crate::sweep::{PRINTED, SweepTable};

/// Number of params that a line names.
const NAMED: usize = 2;
/// Share of the variance below which a param is not named.
const SMALL: f64 = 0.02;

/// Formats a line for the largest value and the peak-to-peak value of the first outputs.
pub fn text(table: &SweepTable, groups: &[Group]) -> String {
    let mut head: Vec<String> = ["", "unit", "mean", "standard deviation"].map(str::to_owned).to_vec();
    head.extend(PERCENTILES.map(|percent| format!("{percent} %")));
    head.push("explained by".to_owned());
    let mut text = String::new();
    for group in groups {
        let label = group.label(table);
        let samples = if group.solved == 1 { "sample" } else { "samples" };
        let mut title = format!("{} {samples}", group.solved);
        if !label.is_empty() {
            title = format!("{label}: {title}");
        }
        if group.failed > 0 {
            title += &format!(", without {} failed", group.failed);
        }
        let mut lines = vec![head.clone()];
        lines[0][0].clone_from(&title);
        let is_shown = |variation: &&Variation| {
            variation.output < PRINTED
                && match variation.statistic {
                    Statistic::Max => true,
                    Statistic::PeakToPeak => variation.varies(),
                    Statistic::Min | Statistic::Mean => false,
                }
        };
        for variation in group.variations.iter().filter(is_shown) {
            let column = &table.outputs[variation.output];
            let unit = if column.unit == "1" { "" } else { column.unit.as_str() };
            let mut cells = vec![format!("{}.{}", column.name, variation.statistic.name()), unit.to_owned()];
            cells.push(number(variation.mean.value));
            cells.push(number(variation.standard_deviation.value));
            cells.extend(variation.percentiles.iter().map(|estimate| number(estimate.value)));
            cells.push(explained(table, group, variation));
            lines.push(cells);
        }
        text += &align(&lines);
    }
    text
}

/// Names the params that explain the largest shares of the variance.
fn explained(table: &SweepTable, group: &Group, variation: &Variation) -> String {
    let all = match &variation.sensitivities {
        Ok(all) => all,
        Err(reason) => return format!("({reason})"),
    };
    let params = &table.params[group.values.len()..];
    let share = |index: usize| all.params[index].first_order.value;
    let named = all.order().into_iter().filter(|index| share(*index) >= SMALL).take(NAMED);
    let named: Vec<String> =
        named.map(|index| format!("{} {:.0} %", params[index].name, 100.0 * share(index))).collect();
    if named.is_empty() { "no param alone".to_owned() } else { named.join(", ") }
}
