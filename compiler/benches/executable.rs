//! Size and start-up time of an executable built from a model, compared to an empty C program that
//! is linked and started in the same way: `cargo bench -p calyx --bench executable`.
//!
//! Most of the measured time is the start of a process; compare the ratios between the rows.

use calyx::build::{BuildOptions, Linker, build};
use divan::Bencher;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::OnceLock;
use tempfile::TempDir;

/// Executables, in a directory that exists until the process ends.
struct Executables {
    _directory: TempDir,
    empty: PathBuf,
    nothing: PathBuf,
    spur_pair: PathBuf,
}

fn executables() -> &'static Executables {
    static BUILT: OnceLock<Executables> = OnceLock::new();
    BUILT.get_or_init(|| {
        let directory = tempfile::tempdir().expect("a directory");
        let place = |name: &str| directory.path().join(name);
        let source = place("empty.c");
        std::fs::write(&source, "int main(void) { return 0; }\n").expect("the source is written");
        let Linker { program, arguments } = Linker::from_environment();
        let mut compiler = Command::new(program);
        compiler.args(arguments).args(["-O2", "-s", "-o"]).args([&place("empty"), &source]);
        assert!(compiler.status().expect("there is a C compiler").success());

        let model = place("nothing.cx");
        std::fs::write(&model, "/// Computes nothing.\nparam x = 1;\n").expect("the model is written");
        let built = |model: &Path, name: &str| {
            let checked = calyx::check_file(model).expect("the model can be read");
            let built = build(&checked, &BuildOptions::executable(place(name)));
            built.unwrap_or_else(|error| panic!("{error}: {}", error.help()))[0].path.clone()
        };
        let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/spur_pair.cx");
        let made = Executables {
            empty: place("empty"),
            nothing: built(&model, "nothing"),
            spur_pair: built(&example, "spur_pair"),
            _directory: directory,
        };
        for (name, path) in [("empty program in C", &made.empty), ("spur_pair", &made.spur_pair)] {
            let size = std::fs::metadata(path).expect("it was built").len();
            println!("{name}: {:.3} MB stripped", size as f64 / 1e6);
        }
        made
    })
}

fn main() {
    executables();
    divan::main();
}

/// Starts a program and waits for its end.
fn bench_start(bencher: Bencher, program: &Path, arguments: &[&str]) {
    let mut command = Command::new(program);
    command.args(arguments).env_clear().stdout(Stdio::null()).stderr(Stdio::null());
    bencher.bench_local(|| assert!(command.status().expect("it starts").success()));
}

#[divan::bench]
fn empty_program_in_c(bencher: Bencher) {
    bench_start(bencher, &executables().empty, &[]);
}

/// Reads the model's description and prints the usage.
#[divan::bench]
fn spur_pair_help(bencher: Bencher) {
    bench_start(bencher, &executables().spur_pair, &["--help"]);
}

/// Runs a model that computes nothing: params, program and run directory.
#[divan::bench]
fn a_run_of_nothing(bencher: Bencher) {
    let results = tempfile::tempdir().expect("a directory");
    let results = results.path().to_str().expect("a text").to_owned();
    bench_start(bencher, &executables().nothing, &["--quiet", "--out", &results]);
}
