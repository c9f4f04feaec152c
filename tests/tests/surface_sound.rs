//! Round trip of surface vibration: the universal files of a run have the sound of the run, and
//! pyuff reads them.

use crate::models::engine;
use crate::radiated_sound::{analysis, pair, plates};
use calyx::Module;
use calyx::rt::{RunOptions, run};
use calyx_runtime::acoustics::SoundMethod;
use calyx_runtime::acoustics::surface_sound::{CaseSound, SoundOptions, Vibration, surface_sound};
use calyx_runtime::acoustics::unv::{LocatedValues, NodalData, UnvDataset, UnvFile, read};
use calyx_runtime::interrupt::Interrupt;
use calyx_tests::python::python_with;
use serde_json::Value;
use std::path::Path;
use std::process::Command;

/// Sounds by all methods, with a point for boundary elements.
const OUTPUTS: &str = "gears.forced_response(mesh, highest_speed = 1600 rpm, lowest_speed = 1400 rpm, speeds = 2, harmonics = 3);
output elements := gears.sound_pressure_level(housing, method = \"boundary_elements\", at = 1 m * e2);
output rayleigh := gears.radiated_power(housing, method = \"rayleigh\");
output equivalent := gears.radiated_power(housing, method = \"erp\");
";
/// Methods in the order of the outputs.
const METHODS: [SoundMethod; 3] =
    [SoundMethod::BoundaryElements, SoundMethod::Rayleigh, SoundMethod::EquivalentPower];

/// Runs the model in a folder.
fn run_with_files(folder: &Path) {
    std::fs::write(folder.join("plates.bdf"), plates("7.85-9", 99)).expect("written");
    let path = folder.join("model.cx");
    std::fs::write(&path, pair(60.0, OUTPUTS, &analysis("2500 Hz"))).expect("written");
    let module = Module::from_file(&engine(), &path).unwrap_or_else(|error| panic!("{error}"));
    let directory = folder.join("run");
    let options = RunOptions { directory, quiet: true, unv: true, ..RunOptions::default() };
    run(module.as_program(), &options).unwrap_or_else(|error| panic!("{error:?}"));
}

fn file(folder: &Path, index: usize) -> UnvFile {
    let path = folder.join(format!("run/unv/sound_surface-{index:02}.unv"));
    read(&std::fs::read(path).expect("written by the run")).expect("valid")
}

/// Returns the sound of a file by a method, with the point of the model.
fn sound(file: &UnvFile, method: SoundMethod) -> Vec<CaseSound> {
    let points = match method {
        SoundMethod::BoundaryElements => vec![[0.0, 1.0, 0.0]],
        _ => Vec::new(),
    };
    let options = SoundOptions { method, points, ..SoundOptions::default() };
    let vibration = Vibration::of_unv(file).expect("a vibration");
    surface_sound(&vibration, &options, &Interrupt::never(), &mut |_, _| {}).expect("solved").cases
}

#[test]
fn files_of_a_run_have_its_sound() {
    let folder = tempfile::tempdir().expect("a folder");
    run_with_files(folder.path());
    let text = std::fs::read_to_string(folder.path().join("run/run.json")).expect("a run");
    let run: Value = serde_json::from_str(&text).expect("JSON");
    for (index, method) in METHODS.into_iter().enumerate() {
        let entry = &run["radiated_sound"][index];
        assert_eq!(entry["method"], method.name());
        let own = file(folder.path(), index);
        let cases = sound(&own, method);
        let lines = entry["lines"].as_array().expect("lines");
        assert_eq!(lines.len(), cases.len());
        // The run interpolates over the frequency with errors of up to 0.5 %, and coarsens for all
        // of its frequencies; 0.1 dB are 2.3 %. Equivalent powers differ by the digits of the file.
        for (line, case) in lines.iter().zip(&cases) {
            let value = |key: &str| line[key].as_f64().expect("a number");
            assert!((case.frequency / value("frequency") - 1.0).abs() < 1e-5);
            assert!((case.equivalent_power / value("equivalent_power") - 1.0).abs() < 1e-4);
            let difference = 10.0 * (case.power / value("power")).log10();
            assert!(difference.abs() < 0.1, "{method:?} at {} Hz: {difference} dB", case.frequency);
        }
        // The pressure of all lines at the point, A-weighted.
        if method == SoundMethod::BoundaryElements {
            let square = |case: &CaseSound| {
                let weight = 10f64.powf(0.1 * calyx_runtime::acoustics::levels::a_weighting(case.frequency));
                0.5 * case.pressures[0].norm_sqr() * weight
            };
            let level = 10.0 * (cases.iter().map(square).sum::<f64>() / 4e-10).log10();
            let expected = entry["points"][0]["a_weighted_level"].as_f64().expect("a level");
            assert!((level - expected).abs() < 0.1, "{level} {expected}");
            let pressures = own.datasets.iter().filter(
                |dataset| matches!(dataset, UnvDataset::AnalysisData(data) if data.kind.quantity == 15),
            );
            assert!(pressures.count() > 0, "surface pressures of the loudest lines");
        }
    }
    check_by_pyuff(&folder.path().join("run/unv/sound_surface-00.unv"), &file(folder.path(), 0));
    // The same model gives the same bytes.
    let again = tempfile::tempdir().expect("a folder");
    run_with_files(again.path());
    let content = |folder: &Path| std::fs::read(folder.join("run/unv/sound_surface-00.unv")).expect("a file");
    assert!(content(folder.path()) == content(again.path()));
}

/// Checks that pyuff reads the same nodes, frequencies and values.
fn check_by_pyuff(path: &Path, file: &UnvFile) {
    let Some(python) = python_with("pyuff") else { return };
    let script = "
import json, sys
import pyuff
sets = pyuff.UFF(sys.argv[1]).read_sets()
part = lambda values: [[value.real, value.imag] for value in values]
json.dump([{
    'type': s['type'],
    'nodes': len(s.get('node_nums', [])),
    'x': list(s.get('x', [])) if s['type'] == 2411 else [],
    'frequency': float(s.get('freq', s.get('frequency', 0))),
    'values': [part(s[key]) for key in {55: ('r1', 'r2', 'r3'), 2414: ('x',)}.get(s['type'], ())],
} for s in sets], sys.stdout)
";
    let output = Command::new(python).args(["-c", script]).arg(path).output().expect("Python starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let found: Vec<Value> = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(found.len(), file.datasets.len());
    for (found, dataset) in found.iter().zip(&file.datasets) {
        assert_eq!(found["type"], dataset.number());
        match dataset {
            UnvDataset::Nodes(nodes) => {
                assert_eq!(found["nodes"], nodes.len());
                assert_eq!(found["x"][3], nodes[3].position[0]);
            }
            UnvDataset::NodalData(NodalData { reals, values, .. }) => {
                same_values(found, reals[0], values);
            }
            UnvDataset::AnalysisData(data) => same_values(found, data.reals[1], &data.values),
            _ => {}
        }
    }
}

/// Checks the frequency and the values of a dataset as read by pyuff.
fn same_values(found: &Value, frequency: f64, values: &[LocatedValues]) {
    assert_eq!(found["nodes"], values.len());
    assert_eq!(found["frequency"], frequency);
    for (node, own) in values.iter().enumerate() {
        for (component, value) in own.values.iter().enumerate() {
            assert_eq!(found["values"][component][node][0], value.re);
            assert_eq!(found["values"][component][node][1], value.im);
        }
    }
}
