//! Latency of an interrupt: the longest time between two checkpoints of an analysis on one thread,
//! compared with the whole analysis. On Linux it is processor time, which other programs on the
//! machine hardly affect, with a resolution of 10 ms.

#[path = "../tests/common/mod.rs"]
mod common;

use calyx_runtime::analysis::{AnalysisOptions, Steps, mesh_cycle};
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::resources::Resources;
use calyx_runtime::scene::{Fidelity, Template};
use common::pair::{Member, PairOptions, RELIEVED, member, pair};
use common::standard_data;
use std::sync::{Arc, LazyLock, Mutex};
use std::time::{Duration, Instant};

fn main() {
    println!(
        "{:>24} {:>12} {:>12} {:>8} {:>12} {:>12}",
        "longest interval, ms", "structures", "positions", "whole", "its part", "checkpoints"
    );
    let usual = PairOptions { edges: true, ..PairOptions::chapter_5(&RELIEVED) };
    let plane = Fidelity::Plane;
    measure("20 and 40 teeth", &usual, 16, None, plane);
    for teeth in [640, 10_000] {
        let gears = [20, teeth].map(|teeth| member(standard_data(teeth, 0.0, 0.25), 0.01));
        let center_distance = 0.5e-3 * f64::from(20 + teeth);
        let large =
            PairOptions { center_distance, moment: 20.0, edges: true, ..PairOptions::chapter_5(&gears) };
        measure(&format!("20 and {teeth} teeth"), &large, 16, None, plane);
    }
    // The maximum numbers of cells and positions that the library permits.
    measure("801 cells", &usual, 2, Some([400, 0]), plane);
    measure("10000 positions", &usual, 10_000, Some([1, 0]), plane);
    // In three dimensions memory limits the number of cells.
    let solid = Fidelity::Solid(Template::Medium);
    measure("11 x 11 cells, 3-D", &usual, 2, Some([5, 5]), solid);
    measure("81 x 41 cells, 3-D", &usual, 1, Some([40, 20]), solid);
}

/// Returns the processor time of this process on Linux, else the time since the first call.
fn now() -> Duration {
    static FIRST: LazyLock<Instant> = LazyLock::new(Instant::now);
    let processor = || {
        let stat = std::fs::read_to_string("/proc/self/stat").ok()?;
        // The name of the program, in parentheses, may contain blanks; `utime` and `stime` are the
        // 12th and 13th fields after it, in hundredths of a second.
        let mut fields = stat.rsplit_once(')')?.1.split_whitespace().skip(11);
        let mut ticks = || fields.next()?.parse::<u64>().ok();
        Some(Duration::from_millis(10 * (ticks()? + ticks()?)))
    };
    processor().unwrap_or_else(|| FIRST.elapsed())
}

/// Statistics of the checkpoints: their number, the last one, and the longest interval.
struct Watch {
    checkpoints: usize,
    last: Duration,
    longest: Duration,
}

impl Watch {
    fn look(&mut self) -> Duration {
        let now = now();
        self.longest = self.longest.max(now - self.last);
        self.last = now;
        self.longest
    }
}

/// Measures an analysis with this number of uniform positions, and this number of cells across and
/// along on each side of the middle.
fn measure(
    name: &str,
    options: &PairOptions,
    steps: usize,
    half_cells: Option<[usize; 2]>,
    fidelity: Fidelity,
) {
    let (mut scene, mesh) = pair(options);
    for (body, Member { prototype, .. }) in scene.bodies.iter_mut().zip(&options.gears) {
        body.prototype = prototype.clone();
    }
    for pair in &mut scene.pairs {
        if let Some([across, along]) = half_cells {
            pair.grid.half_cells = Some(across);
            pair.grid.half_slices = along;
        }
    }
    let positions = mesh_cycle(&mesh, steps);
    let watch = Arc::new(Mutex::new(Watch { checkpoints: 0, last: now(), longest: Duration::ZERO }));
    let question = {
        let watch = watch.clone();
        move || {
            let mut watch = watch.lock().expect("no panic");
            watch.checkpoints += 1;
            watch.look();
            Ok(())
        }
    };
    // With one thread, the time between two checkpoints is that of the work between them.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread");
    let resources =
        Resources { interrupt: Interrupt::new(question), pool: Some(Arc::new(pool)), ..Resources::default() };
    let options = AnalysisOptions { resources, fidelity, ..AnalysisOptions::default() };
    let longest = || std::mem::take(&mut watch.lock().expect("no panic").longest);
    let started = now();
    watch.lock().expect("no panic").last = started;
    let steps = Steps::new(&scene, &positions, &[], &options).expect("structures");
    let structures = longest();
    let result = steps.finish().expect("equilibrium");
    let whole = now() - started;
    let positions = longest();
    let checkpoints = watch.lock().expect("no panic").checkpoints;
    let ms = |time: Duration| 1e3 * time.as_secs_f64();
    println!(
        "{name:>24} {:>12.1} {:>12.1} {:>8.0} {:>12.4} {checkpoints:>12}",
        ms(structures),
        ms(positions),
        ms(whole),
        structures.max(positions).as_secs_f64() / whole.as_secs_f64(),
    );
    for (stage, time) in result.timing.stages {
        println!("{:>24} {stage:>12} {:>12.1}", "", ms(time));
    }
}
