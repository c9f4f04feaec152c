//! Solution of the equations of a three-dimensional sector of the chapter 5 pinion: static
//! condensation by parts to its cuts, and factorization as a whole by this program and by other
//! libraries. CHOLMOD is included if Debian's libsuitesparse-dev and a C compiler are installed.
//! Ratios are comparable between machines, times are not.

use calyx_gears::blank::{GearBlank, Rim};
use calyx_gears::prototype::GearPrototype;
use calyx_gears::rack::Rack;
use calyx_runtime::fe::dissection::Dissection;
use calyx_runtime::fe::elimination::eliminate;
use calyx_runtime::fe::solid::SolidModel;
use calyx_runtime::fe::{Constraints, SolveError, Solver};
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::scene::{Prototype, StructureOptions, Template};
use calyx_runtime::structure::BoreSupport;
use faer::sparse::SparseColMat;
use std::hint::black_box;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Arc;
use std::time::Instant;

const INCH: f64 = 0.0254;

fn main() {
    let gear = pinion(20, BoreSupport::Rigid);
    rings();
    let cholmod = Cholmod::compiled();
    for template in [Template::Medium, Template::FineRoot, Template::Finest] {
        let options = StructureOptions { template, ..StructureOptions::default() };
        let mesh = gear.solid_mesh(&options).expect("a mesh");
        let nodes = |name: &str| mesh.nodes_on(mesh.face_set(name).expect("a set of faces"));
        let of = |node: usize| 3 * node..3 * node + 3;
        let bore = nodes("bore");
        let mut cuts = [nodes("cut_left"), nodes("cut_right")].concat();
        cuts.retain(|node| !bore.contains(node));
        let constrained: Vec<usize> = bore.iter().flat_map(|&node| of(node)).collect();
        let both: Vec<usize> = [&bore, &cuts].into_iter().flatten().flat_map(|&node| of(node)).collect();
        let positions = mesh.nodes.clone();
        let model = SolidModel::new(mesh, gear.material);
        let (assembly, stiffness) = timed(|| model.stiffness());
        println!(
            "{}: {} unknowns, {} entries, {} unknowns on a cut",
            template.name(),
            stiffness.ncols(),
            stiffness.compute_nnz(),
            3 * cuts.len() / 2
        );
        println!("{:>40} {:>10} {:>10} {:>12} {:>12}", "", "seconds", "ratio", "products", "entries");
        let line = |what: &str, time: f64, unit: f64, cost: Option<(f64, f64)>| {
            let cost =
                cost.map_or_else(String::new, |(work, entries)| format!("{work:>12.2e} {entries:>12.2e}"));
            println!("{what:>40} {time:>10.3} {:>10.3} {cost}", time / unit);
        };
        let (order, whole) = timed(|| Dissection::new(&stiffness, &positions, &both, &[]));
        let (unit, _) =
            timed(|| eliminate::<SolveError>(&stiffness, &whole, &[], &[], || Ok(())).expect("held"));
        line("assembly", assembly, unit, None);
        line("nested dissection", order, unit, None);
        line("elimination, cuts held", unit, unit, Some(whole.cost()));
        let dissection = Dissection::new(&stiffness, &positions, &constrained, &cuts);
        let (time, _) =
            timed(|| eliminate::<SolveError>(&stiffness, &dissection, &[], &[], || Ok(())).expect("held"));
        line("elimination down to the cuts", time, unit, Some(dissection.cost()));
        if template != Template::Finest {
            let mut constraints = Constraints::new();
            for &dof in &both {
                constraints.prescribe(dof, 0.0);
            }
            let (time, solver) = timed(|| Solver::new(&stiffness, constraints).expect("held"));
            black_box(solver);
            line("minimum degree, on one core", time, unit, None);
        }
        match &cholmod {
            Ok(cholmod) => {
                let [order, time, entries] = cholmod.run(&stiffness, &whole.order);
                line("CHOLMOD, its order", order, unit, None);
                println!("{:>40} {time:>10.3} {:>10.3} {:>12} {entries:>12.2e}", "CHOLMOD", time / unit, "");
            }
            Err(why) => println!("{:>40} {why}", "CHOLMOD:"),
        }
    }
}

/// Structure of a gear, from mesh to tables, with an increasing number of teeth of the same size.
/// Sectors are joined by doubling, so the cost grows with the logarithm of their number, for every
/// bore support.
fn rings() {
    println!("{:>40} {:>10} {:>10}", "structure of a gear, medium", "seconds", "ratio");
    for (bore, support) in
        [("rigid", BoreSupport::Rigid), ("free", BoreSupport::Means { harmonics: None, degree: 1 })]
    {
        let mut first = None;
        for teeth in [20, 40, 640] {
            let options = StructureOptions { template: Template::Medium, ..StructureOptions::default() };
            let gear = pinion(teeth, support);
            let (time, structure) =
                timed(|| gear.build_solid(&options, &Interrupt::never()).expect("a structure"));
            let unit = *first.get_or_insert(time);
            let megabytes = structure.bytes() as f64 / f64::from(1 << 20);
            println!(
                "{:>40} {time:>10.3} {:>10.3} {megabytes:>10.1} MB",
                format!("{teeth} teeth, {bore} bore"),
                time / unit
            );
        }
    }
}

fn timed<T>(run: impl FnOnce() -> T) -> (f64, T) {
    let start = Instant::now();
    let result = black_box(run());
    (start.elapsed().as_secs_f64(), result)
}

/// Program that uses the C library, compiled for this run.
struct Cholmod {
    program: PathBuf,
    matrix: PathBuf,
}

impl Cholmod {
    fn compiled() -> Result<Self, &'static str> {
        let directory = std::env::temp_dir();
        let name = |end: &str| directory.join(format!("calyx-bench-{}{end}", std::process::id()));
        let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("benches/peers/cholmod.c");
        let program = name("");
        let compiled = Command::new("cc")
            .args(["-O2", "-I/usr/include/suitesparse", "-o"])
            .args([&program, &source])
            .args(["-lcholmod"])
            .output();
        match compiled {
            Ok(output) if output.status.success() => Ok(Self { program, matrix: name(".matrix") }),
            _ => Err("left out, libsuitesparse-dev or a C compiler is not installed"),
        }
    }

    /// Seconds for ordering and factorization of the free unknowns, and the number of entries of
    /// the factor.
    fn run(&self, stiffness: &SparseColMat<usize, f64>, moves: &[Option<usize>]) -> [f64; 3] {
        let mut numbers = vec![None; moves.len()];
        let mut count = 0_u64;
        for (number, _) in numbers.iter_mut().zip(moves).filter(|(_, moves)| moves.is_some()) {
            *number = Some(count);
            count += 1;
        }
        let (mut starts, mut rows, mut values) = (vec![0], Vec::new(), Vec::new());
        for (column, number) in numbers.iter().enumerate() {
            let Some(number) = number else { continue };
            for (row, value) in stiffness.row_idx_of_col(column).zip(stiffness.val_of_col(column)) {
                if let Some(row) = numbers[row].filter(|row| row >= number) {
                    rows.push(row);
                    values.push(value.to_bits());
                }
            }
            starts.push(rows.len() as u64);
        }
        let mut bytes = Vec::new();
        for list in [&vec![count, rows.len() as u64], &starts, &rows, &values] {
            bytes.extend(list.iter().flat_map(|number| number.to_ne_bytes()));
        }
        let mut file = std::fs::File::create(&self.matrix).expect("a file in the temporary directory");
        file.write_all(&bytes).expect("room in the temporary directory");
        let output = Command::new(&self.program).arg(&self.matrix).output().expect("the program runs");
        let text = String::from_utf8_lossy(&output.stdout);
        let numbers: Vec<f64> = text.split_whitespace().filter_map(|word| word.parse().ok()).collect();
        numbers.try_into().unwrap_or([f64::NAN; 3])
    }
}

impl Drop for Cholmod {
    fn drop(&mut self) {
        for path in [&self.program, &self.matrix] {
            // A remaining file does no harm.
            let _ = std::fs::remove_file(path);
        }
    }
}

/// The chapter 5 pinion, or a gear of the same tooth form and rim with more teeth.
fn pinion(teeth: u32, support: BoreSupport) -> Arc<GearPrototype> {
    let rack = Rack::new(0.1 * INCH, 20.0_f64.to_radians(), 0.02 * INCH).expect("a rack");
    let pitch = 0.1 * INCH * f64::from(teeth);
    GearBlank::standard(teeth, rack)
        .diameters(pitch + 0.18 * INCH, pitch - 0.24 * INCH)
        .face_width(INCH)
        .rim(Rim::new(pitch - 0.6 * INCH, pitch - 0.8 * INCH).expect("a rim").supported_by(support))
        .cut()
        .expect("a gear")
}
