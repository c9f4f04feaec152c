//! Equivalent values over a duty cycle: loads and lives of bearings, torques of meshes, mean
//! powers.
//!
//! With the share `q_i` of the time of case i, its speed `n_i` and its load, which is the mean over
//! the positions of the case:
//!
//! - equivalent load `(sum P_i^p n_i q_i / sum n_i q_i)^(1/p)`, with p = 3 for balls and 10/3 for
//!   rollers, the exponents of the life of ISO 281. P is the dynamic equivalent reference load of
//!   ISO/TS 16281;
//! - equivalent torque of a mesh by the same formula, with the slope p of the Woehler damage line
//!   (ISO 6336-6);
//! - life `1 / sum(q_i / L_i)` by linear accumulation of damage (Palmgren 1924, Miner 1945), with
//!   the lives `L_i` in hours;
//! - mean of a power `sum q_i P_i`.
//!
//! See `docs/howto/sweep.md`.

use crate::component_table::{ComponentKind, TableUnit, TableUnits, components, loads_of};
use crate::summary_table::{align, number};
use crate::sweep::{Row, SweepTable, exact};
use calyx_abi::units::from_si;
use calyx_runtime::component_loads::{Component, ComponentLoads, LoadQuantity, RollingKind};
use std::f64::consts::TAU;
use std::io;
use std::path::Path;

/// File name of the equivalent values in the directory of a sweep.
pub const NAME: &str = "duty_cycle.csv";
/// Default slope p of the Woehler damage line: that of the torque for pitting, from the life
/// factors of ISO 6336-2 for through-hardened and case-hardened steels, Z_NT = 1.6 at 1e5 and 1 at
/// 5e7 load cycles: `ln(500) / (2 ln(1.6))`, because the torque grows with the square of the
/// stress.
pub const PITTING_SLOPE: f64 = 6.61;
/// Number of seconds in an hour.
const HOUR: f64 = 3600.0;
/// Key and title of the mean frictional loss of a component.
const MEAN_LOSS: [&str; 2] = ["mean_friction_loss", "Mean friction loss"];

/// Load and speed of a case, with its share of the time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CaseLoad {
    /// Share of the time.
    pub share: f64,
    /// Speed, in any unit; not negative.
    pub speed: f64,
    /// Load, in any unit; not negative.
    pub load: f64,
}

/// Returns the load that has the damage of all cases at every revolution, if damage per revolution
/// grows with the power `exponent` of the load; `None` if nothing rotates.
pub fn equivalent_load(cases: &[CaseLoad], exponent: f64) -> Option<f64> {
    let revolutions: f64 = cases.iter().map(|case| case.share * case.speed).sum();
    if revolutions.is_nan() || revolutions <= 0.0 {
        return None;
    }
    // Relative to the largest load, so that no power overflows.
    let rotating = || cases.iter().filter(|case| case.share * case.speed > 0.0);
    let largest = rotating().map(|case| case.load).fold(0.0, f64::max);
    if largest == 0.0 {
        return Some(0.0);
    }
    let damage: f64 =
        rotating().map(|case| case.share * case.speed * (case.load / largest).powf(exponent)).sum();
    Some(largest * (damage / revolutions).powf(exponent.recip()))
}

/// Returns the time until the damages of all cases, each by its share of the time and its rate,
/// add up to 1; infinite without damage.
pub fn miner_life(shares_and_rates: impl IntoIterator<Item = (f64, f64)>) -> f64 {
    let rate: f64 = shares_and_rates.into_iter().map(|(share, rate)| share * rate).sum();
    rate.recip()
}

/// Value over the duty cycle.
#[derive(Clone, Debug, PartialEq)]
pub struct EquivalentValue {
    /// `mesh`, `bearing` or `output`.
    pub kind: &'static str,
    /// Name of the component or output.
    pub name: String,
    /// Key of the quantity in files.
    pub key: &'static str,
    /// Quantity, in words.
    pub title: &'static str,
    /// Unit of the value.
    pub unit: String,
    pub value: f64,
    /// Exponent of the load.
    pub exponent: Option<f64>,
}

/// Values over a duty cycle.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DutyCycle {
    /// Shares of the time by case, which add up to 1.
    pub shares: Vec<f64>,
    /// Total time, s, if the durations are times.
    pub total: Option<f64>,
    pub values: Vec<EquivalentValue>,
    /// Values that are not available, with the reason; sentences.
    pub missing: Vec<String>,
}

impl DutyCycle {
    /// Computes the values over the duty cycle of a sweep; `None` if its cases have no durations.
    /// `slopes` are the slopes of the Woehler damage lines of meshes.
    ///
    /// # Errors
    /// The reason why there are no values: a case with a duration failed or is not solved.
    pub fn of(table: &SweepTable, slopes: &[f64]) -> Option<Result<DutyCycle, String>> {
        let durations = table.durations.as_ref()?;
        if table.rows.len() < durations.values.len() {
            let (solved, all) = (table.rows.len(), durations.values.len());
            return Some(Err(format!("{solved} of {all} cases are solved")));
        }
        let shares = durations.shares();
        let fails = |(row, share): (&Row, &f64)| row.failure.is_some() && *share > 0.0;
        if let Some(failed) = table.rows.iter().zip(&shares).position(fails) {
            return Some(Err(format!("{} failed", table.label(failed))));
        }
        let mut cycle = DutyCycle { shares, total: durations.total(), ..DutyCycle::default() };
        let units = TableUnits::of_system(&table.units);
        let mut without_life = Vec::new();
        for component in components(table) {
            cycle.report_absence(table, component);
            match component {
                Component::Mesh(_) => cycle.add_mesh(table, component, (units, slopes)),
                Component::Bearing { name, kind } => {
                    if cycle.add_bearing(table, component, (units, *kind)) {
                        without_life.push(name.as_str());
                    }
                }
            }
        }
        if !without_life.is_empty() {
            cycle.missing.push(format!(
                "No life of {}: the model does not request exactly one `gears.bearing_life` or `gears.modified_bearing_life` of each.",
                without_life.join(", ")
            ));
        }
        cycle.add_powers(table);
        Some(Ok(cycle))
    }

    /// Notes the cases in which the model has no such component.
    fn report_absence(&mut self, table: &SweepTable, component: &Component) {
        let absent =
            |index: &usize| self.shares[*index] > 0.0 && loads_of(&table.rows[*index], component).is_none();
        let absent: Vec<String> =
            (0..table.rows.len()).filter(absent).map(|index| table.label(index)).collect();
        if !absent.is_empty() {
            let (name, cases) = (component.name(), absent.join(", "));
            self.missing.push(format!("{name} has no loads in {cases}, which adds no load cycles to it."));
        }
    }

    /// Returns load and speed of a component in all cases that have it; `None` if one of them lacks
    /// the quantity or the speed.
    fn case_loads(
        &self,
        table: &SweepTable,
        component: &Component,
        [load, speed]: [LoadQuantity; 2],
    ) -> Option<Vec<CaseLoad>> {
        let cases = table.rows.iter().zip(&self.shares).filter(|(_, share)| **share > 0.0);
        let loads = cases.filter_map(|(row, share)| Some((loads_of(row, component)?, *share)));
        let case = |(loads, share): (&ComponentLoads, f64)| {
            let [load, speed] = [load, speed].map(|quantity| loads.of(quantity));
            Some(CaseLoad { share, speed: speed?.mean, load: load?.mean })
        };
        loads.map(case).collect()
    }

    fn add(
        &mut self,
        component: &Component,
        [key, title]: [&'static str; 2],
        (si, unit): (f64, TableUnit),
        exponent: Option<f64>,
    ) {
        self.values.push(EquivalentValue {
            kind: ComponentKind::of(component).name(),
            name: component.name(),
            key,
            title,
            unit: unit.name.to_owned(),
            value: from_si(si, unit.factor),
            exponent,
        });
    }

    fn add_mesh(&mut self, table: &SweepTable, component: &Component, (units, slopes): (TableUnits, &[f64])) {
        let name = component.name();
        let torques = self.case_loads(table, component, [LoadQuantity::Torque, LoadQuantity::MeshSpeed]);
        let Some(torques) = torques else {
            self.missing
                .push(format!("{name} has no torque or no speed in some case: no equivalent torque."));
            return;
        };
        for &slope in slopes {
            match equivalent_load(&torques, slope) {
                Some(torque) => self.add(
                    component,
                    ["equivalent_torque", "Equivalent torque on the first gear"],
                    (torque, units.torque),
                    Some(slope),
                ),
                None => self.missing.push(format!("{name} does not rotate: no equivalent torque.")),
            }
        }
        let losses = [LoadQuantity::FrictionLoss, LoadQuantity::MeshSpeed];
        let Some(losses) = self.case_loads(table, component, losses) else { return };
        let lost: f64 = losses.iter().map(|case| case.share * case.load).sum();
        let power: f64 = torques.iter().map(|case| case.share * case.load * case.speed).sum();
        self.add(component, MEAN_LOSS, (lost, units.power), None);
        if power > 0.0 {
            let pure = TableUnit { name: "", factor: 1.0 };
            let efficiency = 1.0 - lost / power;
            self.add(component, ["efficiency", "Efficiency by energy"], (efficiency, pure), None);
        }
    }

    /// Adds the values of a bearing. Returns true if only its life is missing.
    fn add_bearing(
        &mut self,
        table: &SweepTable,
        component: &Component,
        (units, kind): (TableUnits, Option<RollingKind>),
    ) -> bool {
        let name = component.name();
        let Some(kind) = kind else {
            self.missing.push(format!(
                "{name} has springs instead of rolling elements: no equivalent load and no life."
            ));
            return false;
        };
        let exponent = match kind {
            RollingKind::Balls => 3.0,
            RollingKind::Rollers => 10.0 / 3.0,
        };
        let cases = [LoadQuantity::EquivalentLoad, LoadQuantity::BearingSpeed];
        let Some(loads) = self.case_loads(table, component, cases) else {
            self.missing.push(format!("{name} has no equivalent load or no speed in some case."));
            return false;
        };
        let Some(load) = equivalent_load(&loads, exponent) else {
            self.missing.push(format!("{name} does not rotate: no equivalent load and no life."));
            return false;
        };
        self.add(
            component,
            ["equivalent_load", "Equivalent dynamic load"],
            (load, units.force),
            Some(exponent),
        );
        let speed: f64 = loads.iter().map(|case| case.share * case.speed).sum();
        self.add(component, ["mean_speed", "Mean speed"], (speed, units.speed), None);
        let losses = [LoadQuantity::BearingLoss, LoadQuantity::BearingSpeed];
        if let Some(losses) = self.case_loads(table, component, losses) {
            let lost: f64 = losses.iter().map(|case| case.share * case.load).sum();
            self.add(component, MEAN_LOSS, (lost, units.power), None);
        }
        let mut lives = 0;
        for (damage, key, title) in [
            (LoadQuantity::Damage, "life", "Life by Palmgren-Miner"),
            (LoadQuantity::ModifiedDamage, "modified_life", "Modified life by Palmgren-Miner"),
        ] {
            let Some(damages) = self.case_loads(table, component, [damage, LoadQuantity::BearingSpeed])
            else {
                continue;
            };
            lives += 1;
            // Damage per revolution times revolutions per second.
            let life = miner_life(damages.iter().map(|case| (case.share, case.load * case.speed / TAU)));
            self.add(component, [key, title], (life, TableUnit { name: "hour", factor: HOUR }), None);
        }
        lives == 0
    }

    /// Adds the mean of each output that is a power.
    fn add_powers(&mut self, table: &SweepTable) {
        for output in table.outputs.iter().filter(|output| output.is_power) {
            let mean = |row| table.value(row, output, |all| all.mean);
            let cases = table.rows.iter().zip(&self.shares).filter(|(_, share)| **share > 0.0);
            let mean: f64 = cases.map(|(row, share)| share * mean(row)).sum();
            if mean.is_nan() {
                self.missing.push(format!("`{}` has no value in some case: no mean.", output.name));
                continue;
            }
            self.values.push(EquivalentValue {
                kind: "output",
                name: output.name.clone(),
                key: "mean_power",
                title: "Mean over time",
                unit: output.unit.clone(),
                value: mean,
                exponent: None,
            });
        }
    }

    /// Writes the values as CSV, one line each.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn write(&self, path: &Path) -> io::Result<()> {
        let mut file = csv::Writer::from_path(path)?;
        file.write_record(["kind", "name", "quantity", "unit", "value", "exponent"])?;
        for value in &self.values {
            let exponent = value.exponent.map(exact).unwrap_or_default();
            file.write_record([
                value.kind,
                &value.name,
                value.key,
                &value.unit,
                &exact(value.value),
                &exponent,
            ])?;
        }
        file.flush()
    }

    /// Formats one line per value.
    pub fn text(&self) -> String {
        let mut lines = vec![["duty cycle", "quantity", "value", "unit"].map(String::from).to_vec()];
        for value in &self.values {
            let title = match value.exponent {
                Some(exponent) => format!("{}, p = {}", value.title, number(exponent)),
                None => value.title.to_owned(),
            };
            lines.push(vec![value.name.clone(), title, number(value.value), value.unit.clone()]);
        }
        align(&lines)
    }
}

#[cfg(test)]
mod tests;
