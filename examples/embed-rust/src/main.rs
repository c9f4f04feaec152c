//! Finds the tip relief that minimizes the transmission error of the spur pair of the examples: its
//! depth, and the roll angles at which it starts on pinion and gear. The objective is the
//! peak-to-peak transmission error, averaged over a range of torques.
//!
//! `cargo run --release -p embed-rust [EVALUATIONS [POSITIONS]]`

use anyhow::{Context, Result};
use argmin::core::{CostFunction, Executor, State};
use argmin::solver::neldermead::NelderMead;
use calyx::{Engine, ErrorKind, Module, Output, Param};
use rayon::prelude::*;
use std::env;

/// Torques on the pinion, lbf inch.
const TORQUES: [f64; 5] = [250.0, 500.0, 750.0, 1000.0, 1250.0];

/// Relief of the report: depth in mil (thousandths of an inch), starts in degrees of roll.
const REPORT: [f64; 3] = [0.5, 27.25, 19.60];

struct Pair {
    module: Module,
    /// Depth, and start on pinion and gear.
    relief: [Param; 3],
    torque: Param,
    error: Output,
    positions: i32,
}

impl Pair {
    fn new(model: &str, positions: i32) -> Result<Pair> {
        let module = Module::from_file(&Engine::default(), model)?;
        let relief =
            ["tip_relief", "pinion_relief_start", "gear_relief_start"].map(|name| module.param(name));
        let [depth, pinion, gear] = relief;
        let (torque, error) = (module.param("torque")?, module.output("transmission_error")?);
        Ok(Pair { relief: [depth?, pinion?, gear?], torque, error, positions, module })
    }

    /// Returns the peak-to-peak transmission error at every torque, urad, with one instance per
    /// torque on all cores.
    fn peak_to_peak(&self, relief: &[f64]) -> Result<Vec<f64>, calyx::Error> {
        let at = |&torque: &f64| {
            let mut pair = self.module.instantiate();
            pair.set("steps", self.positions)?;
            // Plane model, because hundreds of pairs are solved.
            pair.set("fidelity", "plane")?;
            pair.set(self.torque, torque)?;
            for (param, value) in self.relief.into_iter().zip([1e-3 * relief[0], relief[1], relief[2]]) {
                pair.set(param, value)?;
            }
            Ok(pair.solve()?.summary_in(self.error, "urad")?.peak_to_peak)
        };
        TORQUES.par_iter().map(at).collect()
    }
}

impl CostFunction for &Pair {
    type Param = Vec<f64>;
    type Output = f64;

    fn cost(&self, relief: &Vec<f64>) -> Result<f64> {
        match self.peak_to_peak(relief) {
            Ok(errors) => Ok(errors.iter().sum::<f64>() / errors.len() as f64),
            // Infeasible values, out of range or without a valid gear: the search avoids them.
            Err(error) if matches!(error.kind(), ErrorKind::InvalidInput | ErrorKind::Model) => {
                Ok(f64::INFINITY)
            }
            Err(error) => Err(error.into()),
        }
    }
}

fn main() -> Result<()> {
    let argument = |at: usize, otherwise: u64| env::args().nth(at).map_or(Ok(otherwise), |text| text.parse());
    let (iterations, positions) = (argument(1, 60)?, argument(2, 16)?);
    let model = concat!(env!("CARGO_MANIFEST_DIR"), "/../spur_pair.cx");
    let pair = Pair::new(model, positions.try_into()?)?;

    let step = |k: usize, by: f64| (0..3).map(|i| REPORT[i] + if i == k { by } else { 0.0 }).collect();
    let simplex = vec![REPORT.to_vec(), step(0, 0.2), step(1, -2.0), step(2, 2.0)];
    let search = NelderMead::new(simplex).with_sd_tolerance(0.01)?;
    let found = Executor::new(&pair, search).configure(|state| state.max_iters(iterations)).run()?;
    let best = found.state().get_best_param().context("nothing was tried")?;

    println!("{:<24} {:>10} {:>10}", "", "report", "best");
    let rows = ["depth, 0.001 inch", "start on pinion, deg", "start on gear, deg"];
    for (name, (report, best)) in rows.iter().zip(REPORT.iter().zip(best)) {
        println!("{name:<24} {report:>10.3} {best:>10.3}");
    }
    println!("peak-to-peak transmission error, urad");
    let errors = [pair.peak_to_peak(&REPORT)?, pair.peak_to_peak(best)?];
    for (torque, (report, best)) in TORQUES.iter().zip(errors[0].iter().zip(&errors[1])) {
        println!("{:<24} {report:>10.2} {best:>10.2}", format!("  at {torque} lbf*inch"));
    }
    Ok(())
}
