//! Cost of a case of a sweep of 1,000 cases that differ in loads and flanks only: the time per case
//! less that of the analysis, the speed-up of two threads, and the number of structures that were
//! built: `cargo bench -p calyx --bench sweep`. The first model has two equal gears and few
//! positions at the fidelity "rigid", so that the overhead shows; the second one is
//! `examples/spur_pair.cx` at the fidelity "plane".

use calyx::rt::sweep::{Axis, Sweep};
use calyx::rt::{Override, ParamAssignment};
use calyx::{Engine, EngineConfig, Instance, Module};
use calyx_runtime::estimate::Estimates;
use std::path::Path;
use std::time::Instant;

/// Number of cases.
const CASES: usize = 1000;

const MODEL: &str = "import gears;
units mm_N_s;
param torque = 20 N*m in 0 N*m .. 50 N*m;
var blank = gears.external(24, module = 2 mm, face_width = 10 mm, tooth_thickness = 3.1 mm);
var pinion = gears.body(
    \"pinion\", blank, free = [\"theta_z\"], moment = torque * e3, frame := Rotate(60 rpm * Time, e3));
var gear = gears.body(\"gear\", blank, frame := Rotate(-60 rpm * Time, e3) * Translate(48.05 mm * e1));
var mesh = gears.mesh(pinion, gear, tip_corner_contact = FALSE);
output transmission_error := gears.transmission_error(mesh);
analyze(
    \"quasi_static\", over = gears.mesh_cycle(mesh, 4), fidelity = \"rigid\", error_estimates = \"none\");
";

/// A model and the cases that are solved.
struct Measured {
    name: &'static str,
    module: Module,
    given: Vec<ParamAssignment>,
    axes: [&'static str; 2],
    /// Number of repetitions, of which the shortest counts.
    repetitions: usize,
    /// Number of structures that are built.
    structures: u64,
}

fn main() {
    let engine = Engine::default();
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/spur_pair.cx");
    let measured = [
        Measured {
            name: "rigid pair, 1,000 torques",
            module: Module::from_text(&engine, "pair.cx", MODEL).expect("it compiles"),
            given: Vec::new(),
            axes: ["torque=10..30:1000", ""],
            repetitions: 3,
            structures: 0,
        },
        Measured {
            name: "spur_pair.cx in the plane, 20 torques and 50 amounts of tip relief",
            module: Module::from_file(&engine, example).expect("it compiles"),
            given: vec![ParamAssignment::text("fidelity", "plane"), ParamAssignment::text("steps", "4")],
            axes: ["torque=500..1500:20", "tip_relief=0.00002..0.001:50"],
            repetitions: 1,
            structures: 2,
        },
    ];
    for measured in &measured {
        measured.print();
    }
}

impl Measured {
    fn print(&self) {
        let sweeps = [1, 2]
            .map(|threads| (0..self.repetitions).map(|_| self.sweep(threads)).fold(f64::INFINITY, f64::min));
        let [one, two] = sweeps;
        let analysis = self.analysis();
        println!("{}", self.name);
        println!("{:<44} {:>10} {:>10}", "", "ms", "ratio");
        let row =
            |name: &str, time: f64| println!("{name:<44} {:>10.3} {:>10.2}", 1e3 * time, time / analysis);
        row("analysis", analysis);
        row("case, one thread", one);
        row("overhead", one - analysis);
        row("case, two threads", two);
        println!("speed-up of two threads: {:.2}", one / two);
        println!("structures built: {}\n", self.structures);
    }

    fn of(&self, threads: usize, directory: &Path) -> Sweep {
        let axes = self.axes.iter().filter(|axis| !axis.is_empty());
        let axis = |text: &&str| Axis::parse(text, self.module.description()).expect("an axis");
        Sweep {
            given: self.given.clone(),
            overrides: overrides(),
            axes: axes.map(axis).collect(),
            engine: Engine::new(EngineConfig { threads, ..EngineConfig::default() }),
            workers: threads,
            ..Sweep::new(self.module.as_program(), directory.to_owned())
        }
    }

    /// Returns the time of the analyses alone, in seconds per case.
    fn analysis(&self) -> f64 {
        let directory = tempfile::tempdir().expect("a folder");
        let (_, cases) = self.of(1, directory.path()).cases().expect("cases");
        let engine = Engine::new(EngineConfig { threads: 1, ..EngineConfig::default() });
        let mut instance = Instance::new(&engine, self.module.as_program());
        instance.override_analysis(overrides());
        for given in &self.given {
            instance.give(given).expect("in range");
        }
        let names = self.axes.iter().filter_map(|axis| Some(axis.split_once('=')?.0));
        let names: Vec<&str> = names.collect();
        let mut time = 0.0;
        for case in &cases {
            for (name, value) in names.iter().zip(&case.values) {
                instance.set(*name, value.clone()).expect("in range");
            }
            let results = instance.solve().expect("it is solved");
            let timing = &results.analysis().expect("an analysis").timing;
            time += timing.stages.iter().map(|(_, time)| time.as_secs_f64()).sum::<f64>();
        }
        time / cases.len() as f64
    }

    /// Solves all cases in a new directory; returns seconds per case.
    fn sweep(&self, threads: usize) -> f64 {
        let directory = tempfile::tempdir().expect("a folder");
        let sweep = self.of(threads, directory.path());
        let started = Instant::now();
        let outcome = sweep.run(|_, _| {}).expect("it is solved");
        let time = started.elapsed().as_secs_f64();
        assert_eq!((outcome.table.rows.len(), outcome.table.failures()), (CASES, 0));
        assert_eq!(sweep.engine.kept().misses, self.structures);
        time / CASES as f64
    }
}

fn overrides() -> Override {
    Override { error_estimates: Some(Estimates::None), ..Override::default() }
}
