//! Computing times of examples of planetary systems and of motion in time at realistic lengths,
//! without cached structures: `cargo bench -p calyx --bench examples`. The times depend on the
//! machine; the shares of structures and positions, and the cost of a time step in three dimensions
//! in steps of the plane pair, are comparable between machines.

use calyx::{Engine, Instance, Module};
use std::path::Path;
use std::time::Instant;

fn main() {
    println!(
        "{:<52} {:>8} {:>10} {:>12} {:>10} {:>14}",
        "", "rows", "all, s", "structures", "positions", "us by position"
    );
    measure("planetary.cx, 600 positions in equilibrium", "planetary.cx", 600, |instance| {
        instance.set("cycles", 25)?;
        instance.set("steps", 600)
    });
    measure("the same with 17 cells across each contact", "planetary.cx", 600, |instance| {
        instance.set("cycles", 25)?;
        instance.set("steps", 600)?;
        instance.set("cells", 8)
    });
    measure("the same on 4 times 20 rollers in elastic bores", "planetary.cx", 24, |instance| {
        instance.set("planet_bearings", "rollers")?;
        instance.set("steps", 24)
    });
    let plane = measure("spur_dynamics.cx, 10,000 steps in time", "spur_dynamics.cx", 10_000, |instance| {
        instance.set("run_up", (50.0, "ms"))?;
        instance.set("steps", 10_000)
    });
    for fidelity in ["analytic", "medium"] {
        let what = format!("helical_dynamics.cx, 200 steps in time, {fidelity}");
        let step = measure(&what, "helical_dynamics.cx", 200, |instance| {
            instance.set("fidelity", fidelity)?;
            instance.set("steps", 200)
        });
        println!("{:<52} {:>8.1} steps of spur_dynamics.cx", "a step of this", step / plane);
    }
}

/// Runs an example with some params, which determine the number of positions or steps; returns the
/// time of one, s.
fn measure(
    what: &str,
    example: &str,
    count: usize,
    set: impl Fn(&mut Instance) -> Result<(), calyx::Error>,
) -> f64 {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples").join(example);
    // A separate engine has no stored structures of other runs.
    let engine = Engine::default();
    let begun = Instant::now();
    let module = Module::from_file(&engine, &path).expect("the example compiles");
    let mut instance = module.instantiate();
    set(&mut instance).expect("in range");
    let results = instance.solve().expect("it is solved");
    let whole = begun.elapsed().as_secs_f64();
    let timing = results.timing().expect("an analysis");
    let stage = |name: &str| {
        timing.stages.iter().find(|(known, _)| *known == name).map_or(0.0, |(_, time)| time.as_secs_f64())
    };
    let [structures, positions] = ["structures", "positions"].map(stage);
    println!(
        "{what:<52} {:>8} {whole:>10.2} {:>12.3} {:>10.3} {:>14.1}",
        results.steps().len(),
        structures / whole,
        positions / whole,
        1e6 * positions / count as f64
    );
    positions / count as f64
}
