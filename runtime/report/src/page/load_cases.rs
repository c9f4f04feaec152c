//! Sections "Loads by load case" and "Duty cycle" of the page of a sweep.

use super::prose;
use crate::component_table::{self, ComponentKind, QuantityTable};
use crate::duty_cycle::{self, DutyCycle};
use crate::summary_table::number;
use crate::sweep::SweepTable;
use maud::{Markup, PreEscaped, html};

/// Largest number of cases in a table of the page; the file has all.
const CASES: usize = 12;
/// Number of seconds in an hour.
const HOUR: f64 = 3600.0;

/// Returns the tables of the loads of meshes and bearings; empty for a sweep without load cases.
pub fn section(table: &SweepTable) -> Markup {
    let tables = component_table::tables(table);
    if !table.load_cases || tables.is_empty() {
        return PreEscaped(String::new());
    }
    html! {
        section id="loads" {
            h2 { "Loads by load case" }
            p.note {
                "Statistics over the solved positions of a case, which cover the mesh cycle of one mesh: the mean over time, the largest value, "
                "or the difference of the extremes. The largest magnitude of each row, or the shortest life, is bold. All values are in " code { (component_table::NAME) } "."
                @if table.rows.len() > CASES { " The tables show the first " (CASES) " of " (table.rows.len()) " cases." }
            }
            @for (kind, title) in [(ComponentKind::Mesh, "Meshes"), (ComponentKind::Bearing, "Bearings")] {
                @let own = tables.iter().filter(|quantity| quantity.kind == kind).collect::<Vec<_>>();
                @if !own.is_empty() { h3 { (title) } (by_case(table, &own)) }
            }
        }
    }
}

/// Shows the tables of a kind of component below each other, with a column per case.
fn by_case(table: &SweepTable, quantities: &[&QuantityTable]) -> Markup {
    let shown = table.rows.len().min(CASES);
    html! {
        table.numbers.data {
            thead { tr { th {} @for index in 0..shown { th.value { (table.label(index)) } } } }
            @for quantity in quantities {
                tbody {
                    tr { th.group scope="rowgroup" colspan=(shown + 1) { (quantity.title) ", " (quantity.unit) } }
                    @for (name, values) in &quantity.rows { tr {
                        th scope="row" { (name) }
                        @for value in &values[..shown] { td { (cell(*value, &values[..shown], quantity.is_life())) } }
                    } }
                }
            }
        }
    }
}

/// Shows a value, bold if it has the largest magnitude of several different ones, or is the
/// shortest life.
fn cell(value: Option<f64>, row: &[Option<f64>], is_life: bool) -> Markup {
    let Some(value) = value else { return html! {} };
    let magnitudes = || row.iter().flatten().map(|other| other.abs());
    let (least, largest) =
        magnitudes().fold((f64::INFINITY, 0.0), |(least, most), one| (one.min(least), one.max(most)));
    // A variation by rounding is none.
    let varies = largest - least > 1e-9 * largest;
    let most_severe = if is_life { least } else { largest };
    html! { @if varies && value.abs() == most_severe { b { (number(value)) } } @else { (number(value)) } }
}

/// Returns the section with the values over the duty cycle; empty for cases without durations.
pub fn duty_cycle(table: &SweepTable, cycle: Option<&Result<DutyCycle, String>>) -> Markup {
    let Some(cycle) = cycle else { return PreEscaped(String::new()) };
    html! {
        section id="duty-cycle" {
            h2 { "Duty cycle" }
            @match cycle {
                Err(reason) => p.note { "There are no values over the duty cycle: " (prose(reason)) "." },
                Ok(cycle) => (values(table, cycle)),
            }
        }
    }
}

fn values(table: &SweepTable, cycle: &DutyCycle) -> Markup {
    let total = cycle.total.map(|total| format!(" The total time is {} h.", number(total / HOUR)));
    let percent = |share: f64| format!("{} %", number(100.0 * share));
    html! {
        p { "Share of the time of each case." (total.unwrap_or_default()) }
        table.numbers.data {
            thead { tr { th { "case" } th.value { "share" } @if cycle.total.is_some() { th.value { "hours" } } } }
            tbody { @for (index, share) in cycle.shares.iter().enumerate() { tr {
                th scope="row" { (table.label(index)) }
                td { (percent(*share)) }
                @if let Some(total) = cycle.total { td { (number(share * total / HOUR)) } }
            } } }
        }
        p { "Values over the duty cycle, also in " code { (duty_cycle::NAME) } "." }
        table.numbers.data {
            thead { tr { th { "component" } th.word { "quantity" } th.value { "value" } th.word { "unit" } th.value { "exponent p" } } }
            tbody { @for value in &cycle.values { tr {
                th scope="row" { (value.name) }
                td.word { (value.title) }
                td { (number(value.value)) }
                td.word { (value.unit) }
                td { @if let Some(exponent) = value.exponent { (number(exponent)) } }
            } } }
        }
        (assumptions(cycle))
        @if !cycle.missing.is_empty() {
            h3 { "Not available" }
            ul { @for reason in &cycle.missing { li { (prose(reason)) } } }
        }
    }
}

/// States the formulas and what they assume.
fn assumptions(cycle: &DutyCycle) -> Markup {
    let has = |keys: &[&str]| cycle.values.iter().any(|value| keys.contains(&value.key));
    html! {
        h3 { "Formulas and assumptions" }
        p { "q is the share of the time of a case, n a speed. The load of a case is its mean over the solved positions." }
        ul {
            @if has(&["equivalent_load"]) { li {
                "Equivalent dynamic load of a bearing: (Σ P" sup { "p" } " n q / Σ n q)" sup { "1/p" } ", p = 3 for balls and 10/3 for rollers (ISO 281). P is the dynamic "
                "equivalent reference load of ISO/TS 16281, from the loads of the rolling elements. The load does not rotate relative to the ring on the mounting (" code { "to" } "), unless "
                "the model requests a life of the bearing with another rotating ring."
            } }
            @if has(&["life", "modified_life"]) { li {
                "Life of a bearing: 1 / Σ (q / L), with the lives L of the cases in hours (Palmgren-Miner). The life of a case is the one that the model requests."
            } }
            @if has(&["equivalent_torque"]) { li {
                "Equivalent torque of a mesh: (Σ T" sup { "p" } " n q / Σ n q)" sup { "1/p" } " (ISO 6336-6). n is the speed of the first gear relative to the carrier of the mesh, "
                "so that n q is proportional to the load cycles. The slope p is that of " code { "--damage-slope" } ". No application or load factor and no endurance limit is applied, "
                "and both signs of the torque count alike."
            } }
            @if has(&["efficiency"]) { li { "Efficiency by energy: 1 - Σ q P" sub { "loss" } " / Σ q T ω." } }
            @if has(&["mean_power", "mean_friction_loss"]) { li { "Mean of a power: Σ q P." } }
        }
    }
}
