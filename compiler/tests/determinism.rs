//! Checks that a model writes identical bytes with any number of threads, in another program, and
//! after any number of kills and resumes: in statics and dynamics, for pairs and planetary sets, in
//! two and three dimensions.
#![cfg(unix)]

use super::results::results;
use calyx::rt::Step;
use calyx::{Engine, EngineConfig, Module};

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

const GEARS: &str = "import gears;
units SI;
var steel = gears.material(youngs_modulus = 206 GPa, poissons_ratio = 0.3, density = 7850 kg/m^3);
var rack = gears.rack(module = 2 mm, tip_radius = 0.5 mm);
function blank(in teeth) {
    return gears.external(teeth = teeth, rack = rack, tooth_thickness = 3.08 mm, face_width = 20 mm,
        outer_diameter = (teeth + 2) * 2 mm, root_diameter = (teeth - 2.5) * 2 mm, material = steel,
        rim = gears.simple_rim((teeth - 4) * 2 mm, (teeth - 8) * 2 mm));
}
";

const PAIR: &str = "
var one = gears.body(\"one\", blank(24), free = [\"theta_z\"], moment = 50 N*m*e3, frame := Rotate(600 rpm*Time, e3));
var two = gears.body(\"two\", blank(24), frame := Rotate(-600 rpm*Time, e3)*Translate(48.1 mm*e1));
var mesh = gears.mesh(one, two, contact_cells = 6, tip_corner_contact = TRUE);
output te := gears.transmission_error(mesh);
output pressure := gears.max_contact_pressure(mesh);
output stress := gears.max_root_stress(one);
";

const STATICS: &str = "analyze(\"quasi_static\", over = gears.mesh_cycle(mesh, 24));";

const DYNAMICS: &str = "gears.spectrum(\"te\");
analyze(\"dynamic\", over = gears.time_ranges([gears.time_range(2 ms, step = 10 us)]));";

const IN_SPACE: &str =
    "analyze(\"quasi_static\", over = gears.mesh_cycle(mesh, 2), fidelity = \"medium\", face_elements = 1,
    displacement_order = 1);";

const PLANETARY: &str = "
var ring = gears.internal(teeth = 72, shaper = gears.shaper(25, module = 2 mm, tip_radius = 0.4 mm), tooth_thickness = 3.08 mm,
    face_width = 20 mm, minor_diameter = 140.8 mm, root_diameter = 149 mm, material = steel, rim = gears.outer_rim(151 mm, 159 mm));
var set = gears.planetary(sun = blank(24), planet = blank(24), ring = ring, center_distance = 48 mm, contact_cells = 6,
    tip_corner_contact = FALSE, planets = 3, sun_speed = 100 rpm, sun_torque = 100 N*m);
output one := gears.mesh_force(set.sun_meshes[0]);
output turn := gears.rotation(set.sun, \"z\");
analyze(\"quasi_static\", over = gears.mesh_cycle(set.sun_meshes[0], 3));";

/// Writes a model into its own directory.
fn model(text: &str) -> (tempfile::TempDir, PathBuf) {
    let directory = tempfile::tempdir().expect("a directory");
    let path = directory.path().join("model.cx");
    fs::write(&path, format!("{GEARS}{text}")).expect("writable");
    (directory, path)
}

fn run(model: &Path, out: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_calyx"));
    command.arg("run").arg(model).arg("--quiet").arg("--out").arg(out).args(arguments);
    command
}

fn ran(command: &mut Command) {
    let output = command.output().expect("it starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

/// Compares structures and positions with one, two and eight threads, and in a program that embeds
/// the model.
fn check_bits(text: &str) {
    let (directory, model) = model(text);
    let out = |threads: &str| directory.path().join(threads);
    for threads in ["1", "2", "8"] {
        ran(&mut run(&model, &out(threads), &["--no-cache", "--threads", threads]));
    }
    let [one, two, eight] = ["1", "2", "8"].map(|threads| results(&out(threads)));
    assert!(
        one == two && one == eight,
        "{:?}",
        one.iter().find(|(name, file)| two[*name] != **file || eight[*name] != **file)
    );

    let engine = Engine::new(EngineConfig { threads: 3, ..EngineConfig::default() });
    let solved =
        Module::from_file(&engine, &model).expect("a model").instantiate().solve().expect("it is solved");
    let row = |step: Step| {
        let values = step.outputs().iter().map(|observed| observed.value.to_string());
        values.collect::<Vec<_>>().join(",")
    };
    let rows: Vec<String> = solved.steps().map(row).collect();
    let outputs = |line: &str| line.split(',').skip(5).collect::<Vec<_>>().join(",");
    let table: Vec<String> = one["steps.csv"].lines().skip(1).map(outputs).collect();
    assert!(table.len() > 2);
    assert_eq!(rows, table);
}

#[test]
fn motion_in_time_has_the_same_bits_everywhere() {
    check_bits(&format!("{PAIR}{}", DYNAMICS.replace("2 ms", "0.3 ms")));
}

#[test]
fn planetary_sets_have_the_same_bits_everywhere() {
    check_bits(PLANETARY);
}

#[test]
fn solid_pairs_have_the_same_bits_everywhere() {
    check_bits(&format!("{PAIR}{IN_SPACE}"));
}

/// Pseudo-random numbers from 0 to 1 (Numerical Recipes, ranqd1).
struct Random(u32);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(self.0) / f64::from(u32::MAX)
    }
}

/// Checks that a run that is killed repeatedly at random moments ends with the files of an
/// undisturbed run, and that `calyx report` accepts the files in between.
fn check_kills(text: &str, arguments: &[&str]) {
    let (directory, model) = model(text);
    let cache = directory.path().join("cache");
    let arguments = &[arguments, &["--cache", cache.to_str().expect("text"), "--resume"]].concat();
    let whole = directory.path().join("whole");
    let started = Instant::now();
    ran(&mut run(&model, &whole, arguments));
    let expected = results(&whole);
    let mut long = started.elapsed();
    let mut kills = 0;
    for seed in [1, 20] {
        let mut random = Random(seed);
        let out = directory.path().join(seed.to_string());
        // The first seed starts without a cache, and is killed while structures are being written
        // to it.
        if seed == 1 {
            fs::remove_dir_all(&cache).expect("it is there");
        }
        for _ in 0..4 {
            let mut killed = run(&model, &out, arguments).stdout(Stdio::null()).spawn().expect("it starts");
            sleep(long.mul_f64(random.next()));
            killed.kill().expect("it is ours");
            if killed.wait().expect("it ends").success() {
                break;
            }
            kills += 1;
            let mut report = Command::new(env!("CARGO_BIN_EXE_calyx"));
            let report = report.arg("report").arg(&out).output().expect("it starts");
            let said = String::from_utf8_lossy(&report.stderr);
            assert!(report.status.success() || said.contains("there is no run in"), "{said}");
        }
        let again = Instant::now();
        ran(&mut run(&model, &out, arguments));
        let results = results(&out);
        assert_eq!(results.keys().collect::<Vec<_>>(), expected.keys().collect::<Vec<_>>());
        assert_eq!(results.iter().find(|(name, file)| expected[*name] != **file), None, "seed {seed}");
        // Later runs with this cache take less time.
        long = long.min(2 * again.elapsed().max(Duration::from_millis(50)));
    }
    assert!(kills > 2, "{kills} kills");
}

/// Long: part of `.ci/full`; `runner.rs` kills such a run once.
#[test]
#[ignore = "long; part of .ci/full"]
fn statics_killed_at_random_moments_write_the_same_bytes() {
    check_kills(&format!("{PAIR}{STATICS}"), &["--fields", "--vtu"]);
}

#[test]
fn motion_killed_at_random_moments_writes_the_same_bytes() {
    check_kills(&format!("{PAIR}{DYNAMICS}"), &[]);
}
