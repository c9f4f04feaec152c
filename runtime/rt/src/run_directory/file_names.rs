//! Names of files in directories of results.

use crate::sensitivity_journal::SENSITIVITY_JOURNAL;
use calyx_report::directory::REPORT;
use calyx_report::optimization::{DESIGNS, OPTIMUM};
use calyx_report::sensitivity::{SENSITIVITIES, SENSITIVITIES_BY_POSITION};
use calyx_report::study::{EXPLAINED_VARIATION, SAMPLE_STATISTICS};
use calyx_report::sweep::PRINTED_TEXT;
use calyx_report::{component_table, duty_cycle, page, view};

/// Files of a sweep.
pub const FILES_OF_A_SWEEP: [&str; 16] = [
    "plan.json",
    "plan.json.part",
    "model.json",
    "cases.json",
    "job.sh",
    "job.json",
    "sweep.csv",
    "sweep.parquet",
    "sweep.parquet.part",
    "sweep.html",
    "cases.jsonl",
    component_table::NAME,
    duty_cycle::NAME,
    PRINTED_TEXT,
    SAMPLE_STATISTICS,
    EXPLAINED_VARIATION,
];

/// Files of an optimization.
pub(super) const FILES_OF_AN_OPTIMIZATION: [&str; 4] =
    [OPTIMUM, DESIGNS, "evaluations.jsonl", page::optimization::NAME];

/// Files of sensitivities.
pub(super) const FILES_OF_SENSITIVITIES: [&str; 4] =
    [SENSITIVITIES, SENSITIVITIES_BY_POSITION, SENSITIVITY_JOURNAL, page::sensitivity::NAME];

/// Files at the top level of a run directory. Those that end in `.part` are renamed when they are
/// complete.
pub(super) const FILES_OF_A_RUN: [&str; 42] = [
    view::page::NAME,
    "run.json",
    "journal.jsonl",
    SENSITIVITY_JOURNAL,
    "run.json.part",
    "timing.json",
    "timing.json.part",
    "steps.csv",
    "line_load.csv",
    "pressure.csv",
    "root_stress.csv",
    "max_locations.csv",
    "places.csv",
    "root_stress_range.csv",
    "root_stress_range.csv.part",
    "contact_pattern.csv",
    "contact_pattern.csv.part",
    "contact_path.csv",
    "contact_path.csv.part",
    "rolling_elements.csv",
    "rolling_elements.csv.part",
    "roller_pressure.csv",
    "roller_pressure.csv.part",
    "tooth_flanks.csv",
    "tooth_flanks.csv.part",
    "unloaded_contact.csv",
    "unloaded_contact.csv.part",
    "ease_off.csv",
    "ease_off.csv.part",
    "campbell.csv",
    "forced_response.csv",
    "forced_response_modes.csv",
    "modes.csv",
    SENSITIVITIES,
    SENSITIVITIES_BY_POSITION,
    "radiated_sound.csv",
    "sound_pressure.csv",
    "panel_power.csv",
    "sound_field.csv",
    "directivity.csv",
    REPORT,
    "report.html.part",
];
