//! Universal files: round trips, numbers of other writers, hostile input, and pyuff.

use crate::shapes::sphere;
use calyx_acoustics::unv::{
    Abscissae, AnalysisData, Element, Entity, Function, FunctionAxis, FunctionEnd, Header, LocatedValues,
    NodalData, Node, Ordinates, ResultKind, TraceLine, Units, UnvDataset, UnvFile, mesh_datasets,
    pressure_dataset, read, surface_mesh, write,
};
use calyx_acoustics::{Fluid, RadiationModel, Settings};
use calyx_numerics::interrupt::Interrupt;
use faer::c64;
use std::io::Write;
use std::path::PathBuf;
use std::process::Command;

fn function(ordinates: Ordinates, abscissae: Abscissae) -> UnvDataset {
    let axis = |quantity, label: &str, units: &str| FunctionAxis {
        quantity,
        exponents: [0; 3],
        label: label.into(),
        units: units.into(),
    };
    UnvDataset::Function(Box::new(Function {
        names: ["Pressure", "NONE", "01-Nov-26 12:00:00", "NONE", "NONE"].map(String::from).to_vec(),
        kind: 4,
        numbers: [1, 0, 1],
        response: FunctionEnd { entity: "FIELD".into(), node: 17, direction: 0 },
        reference: FunctionEnd { entity: "SKIN".into(), node: 4, direction: -3 },
        abscissae,
        z: 0.0,
        axes: [
            axis(18, "Frequency", "Hz"),
            axis(15, "Pressure", "Pa"),
            axis(11, "Velocity", "m/s"),
            axis(0, "NONE", "NONE"),
        ],
        ordinates,
    }))
}

/// All kinds of datasets, with numbers that their fields represent exactly.
fn datasets() -> Vec<UnvDataset> {
    let real = |count: usize| (0..count).map(|k| 0.125 * k as f64 - 1.0).collect::<Vec<f64>>();
    let complex = |count: usize| real(count).into_iter().map(|x| c64::new(x, 1.0 - x)).collect::<Vec<_>>();
    let values = |labels: &[i64], count: usize| {
        labels.iter().map(|&label| LocatedValues { label, values: complex(count) }).collect::<Vec<_>>()
    };
    let names: Vec<String> = ["First", "", "Third line", "NONE", "NONE"].map(String::from).to_vec();
    let kind = ResultKind { model: 1, analysis: 5, characteristic: 2, quantity: 11 };
    let header = [
        "Housing",
        "",
        "Calyx",
        "01-Nov-26 12:00:00          1         2         3",
        "01-Nov-26 12:00:00",
        "Calyx",
        "01-Nov-26 12:00:00",
    ];
    let header = header.map(String::from).to_vec();
    let node = |label: i64, position| Node { label, attributes: [0, 0, 11], position };
    let element = |label, descriptor, beam, nodes: &[i64]| Element {
        label,
        descriptor,
        attributes: [1, 1, 7],
        beam,
        nodes: nodes.to_vec(),
    };
    let integers: Vec<i64> = (0..16).collect();
    let mut all = vec![
        UnvDataset::Header(Header { lines: header }),
        UnvDataset::Units(Units::si()),
        UnvDataset::Nodes(vec![
            node(1, [0.1, -1e-100, 1.0 / 3.0]),
            node(2, [f64::MAX, f64::MIN_POSITIVE, 0.0]),
            node(99_999_999, [1.0, 2.0, 3.0]),
        ]),
        UnvDataset::Elements(vec![
            element(1, 91, None, &[1, 2, 3]),
            element(2, 21, Some([0, 1, 1]), &[1, 2]),
            element(3, 116, None, &(1..=20).collect::<Vec<i64>>()),
        ]),
        UnvDataset::TraceLine(TraceLine {
            number: 1,
            color: 30,
            name: "Outline".into(),
            nodes: vec![1, 2, 0, 3, 4, 5, 6, 7, 8, 9],
        }),
        UnvDataset::NodalData(NodalData {
            names: names.clone(),
            kind,
            is_complex: true,
            integers: vec![1, 4],
            reals: vec![1250.0],
            values: values(&[1, 2, 5], 3),
        }),
    ];
    // pyuff reads frequency responses at nodes only.
    for (label, entity, analysis) in [(7, Entity::Nodes, 5), (8, Entity::Elements, 1)] {
        all.push(UnvDataset::AnalysisData(Box::new(AnalysisData {
            label,
            name: "Velocity".into(),
            entity,
            names: names.clone(),
            kind: ResultKind { analysis, ..kind },
            is_complex: true,
            integers: integers.clone(),
            reals: real(12),
            values: values(&[3, 4], 3),
        })));
    }
    for double in [false, true] {
        let even = || Abscissae::Even { first: 100.0, increment: 2.5 };
        let uneven = || Abscissae::All(real(7));
        all.extend([
            function(Ordinates::Real(real(7), double), even()),
            function(Ordinates::Complex(complex(7), double), even()),
            function(Ordinates::Real(real(7), double), uneven()),
            function(Ordinates::Complex(complex(7), double), uneven()),
        ]);
    }
    all
}

#[test]
fn datasets_survive_writing_and_reading() {
    let datasets = datasets();
    let text = write(&datasets).expect("valid");
    let file = read(text.as_bytes()).expect("valid");
    assert!(file.skipped.is_empty());
    for (found, written) in file.datasets.iter().zip(&datasets) {
        assert_eq!(found, written);
    }
    assert_eq!(file.datasets.len(), datasets.len());
    assert_eq!(write(&file.datasets).expect("valid"), text);
    // Line ends of other systems.
    let other = text.replace('\n', "\r\n");
    assert_eq!(read(other.as_bytes()).expect("valid"), file);
}

#[test]
fn numbers_of_other_writers_are_read() {
    let text = "\
    -1
  2411
 1 1 1 11
 1.0D-01 2.5d+00 -3.0E2
 123456789 0 0 1
  1.0000000000000000D+100  -1.0000000000000000-101   0.0000000000000000D+00
    -1
    -1
  9999
anything
    -1

    -1
    55
NONE
NONE
NONE
NONE
NONE
         1         2         3         8         2         6
         2         4         0         7
  1.20000E+03  1.00000E+00  0.00000E+00  0.00000E+00
        -1
-1.000000E+00-2.000000E+00-3.000000E+00-4.000000E+00-5.000000E+00-6.000000E+00
    -1
";
    let file = read(text.as_bytes()).expect("valid");
    let UnvDataset::Nodes(nodes) = &file.datasets[0] else { panic!("{:?}", file.datasets[0]) };
    assert_eq!((nodes[0].label, nodes[0].position), (1, [0.1, 2.5, -300.0]));
    assert_eq!((nodes[1].label, nodes[1].position), (123_456_789, [1e100, -1e-101, 0.0]));
    assert_eq!((file.skipped[0].number, file.skipped[0].line), (9999, 8));
    let UnvDataset::NodalData(data) = &file.datasets[1] else { panic!("{:?}", file.datasets[1]) };
    assert_eq!((data.integers.as_slice(), data.reals[0], data.values[0].label), (&[0, 7][..], 1200.0, -1));
    assert_eq!(data.values[0].values[5], c64::new(-6.0, 0.0));
}

/// Truncated files, exchanged characters and huge counts give errors with a line, and no panic.
#[test]
fn hostile_files_are_rejected_or_read() {
    let text = write(&datasets()).expect("valid");
    let lines = text.lines().count();
    let check = |content: &[u8]| {
        if let Err(error) = read(content) {
            assert!(error.line <= lines + 1 && !error.help.is_empty(), "{error}");
        }
    };
    for end in (0..text.len()).step_by(7) {
        check(&text.as_bytes()[..end]);
    }
    for (at, byte) in
        (0..text.len()).step_by(3).zip([b'9', b'-', b'x', 0xff, b' ', b'\n', b'E'].iter().cycle())
    {
        let mut content = text.clone().into_bytes();
        content[at] = *byte;
        check(&content);
    }
    let cases: [(&[u8], usize, &str); 10] = [
        (b"text", 1, "text between datasets; `-1` is expected"),
        (b"    -1\n", 1, "the file ends where the number of a dataset is expected"),
        (b"    -1\n  2411\n", 1, "the file ends within the dataset 2411"),
        (b"    -1\n  node\n    -1\n", 2, "`node` is not the number of a dataset"),
        (b"    -1\n   58b     1\n    -1\n", 2, "the dataset 58 is binary"),
        (b"    -1\n\0  58\n", 2, "the file is not text: it contains a zero byte"),
        (
            b"    -1\n  2412\n 1 91 1 1 7 999999999\n 1 2 3\n    -1\n",
            3,
            "the number of nodes of an element is 999999999, but the dataset has 6 characters left",
        ),
        (
            b"    -1\n  2411\n 1 1 1 1\n 1.0 nan 3.0\n    -1\n",
            4,
            "the position of a node has `nan` where a number is expected",
        ),
        (b"    -1\n  2411\n 1 1 1\n    -1\n", 3, "a node has 3 integers instead of 4"),
        (b"    -1\n   164\n         1SI\n 1 0 1\n 0\n    -1\n", 5, "a factor of the units is 0"),
    ];
    for (content, line, message) in cases {
        let error = read(content).expect_err("damaged");
        assert_eq!((error.line, error.message.as_str()), (line, message));
    }
}

#[test]
fn values_that_do_not_fit_are_not_written() {
    let node =
        |label, x| UnvDataset::Nodes(vec![Node { label, attributes: [0; 3], position: [x, 0.0, 0.0] }]);
    let header = |line: &str| UnvDataset::Header(Header { lines: vec![line.into()] });
    for dataset in [
        node(1, f64::NAN),
        node(10_000_000_000, 0.0),
        header(&"x".repeat(81)),
        header("two\nlines"),
        header("    -1"),
        function(Ordinates::Real(vec![1.0; 3], true), Abscissae::All(vec![1.0; 2])),
    ] {
        let error = write(&[UnvDataset::Units(Units::si()), dataset]).expect_err("does not fit");
        assert!(error.line == 2 && !error.help.is_empty(), "{error}");
    }
}

#[test]
fn surfaces_are_exchanged() {
    let mesh = sphere(1, 0.1);
    let mut file = UnvFile { datasets: mesh_datasets(&mesh), ..UnvFile::default() };
    let text = write(&file.datasets).expect("valid");
    let read_back = read(text.as_bytes()).expect("valid");
    let (found, labels, elements) = surface_mesh(&read_back, None).expect("closed");
    assert!((found.area() - mesh.area()).abs() < 1e-14 && found.volume() > 0.0);
    assert_eq!((labels.len(), elements.len()), (mesh.vertices().len(), mesh.triangles().len()));

    // The file in mm.
    for dataset in &mut file.datasets {
        match dataset {
            UnvDataset::Units(units) => units.factors[0] = 1000.0,
            UnvDataset::Nodes(nodes) => {
                nodes.iter_mut().for_each(|node| node.position = node.position.map(|x| 1000.0 * x));
            }
            _ => {}
        }
    }
    let (found, ..) = surface_mesh(&file, None).expect("closed");
    assert!((found.area() / mesh.area() - 1.0).abs() < 1e-12);

    let UnvDataset::Elements(elements) = &mut file.datasets[2] else { panic!("elements") };
    elements[4].nodes[1] = 5000;
    let error = surface_mesh(&file, None).expect_err("no node");
    assert_eq!(error.to_string(), "element 5: its node 5000 is not in the file");
    assert!(surface_mesh(&UnvFile::default(), None).is_err());
}

/// Surface pressures are written for pyuff and other programs.
#[test]
fn pressures_are_written() {
    let model = RadiationModel { mesh: sphere(0, 0.1), fluid: Fluid::AIR };
    let interrupt = Interrupt::never();
    let equations = model.equations(300.0, &Settings::default(), &interrupt).expect("assembled");
    let velocities = vec![c64::new(1e-3, 0.0); model.mesh.triangles().len()];
    let radiation = equations.solve(&[velocities], &interrupt).expect("solved").remove(0);
    let text = write(&[pressure_dataset(&radiation, 1)]).expect("valid");
    let file = read(text.as_bytes()).expect("valid");
    let UnvDataset::NodalData(data) = &file.datasets[0] else { panic!("{:?}", file.datasets[0]) };
    assert_eq!((data.reals[0], data.values.len()), (300.0, 12));
    for (found, pressure) in data.values.iter().zip(radiation.pressures()) {
        assert!((found.values[0] - pressure).norm() < 1e-5 * pressure.norm());
    }
}

/// Returns the Python that `.ci/programs` installed pyuff for, or one that has it.
fn python_with_pyuff() -> Option<PathBuf> {
    let installed = std::env::current_exe().ok()?.ancestors().nth(3)?.join("python/bin/python3");
    let has_it = |program: &PathBuf| {
        let asked = Command::new(program).args(["-c", "import pyuff"]).output();
        asked.is_ok_and(|answer| answer.status.success())
    };
    [installed, "python3".into()].into_iter().find(has_it)
}

/// pyuff, a Python reader, finds the same values. Without pyuff, the test is skipped with a
/// message; with `CALYX_CI_STRICT=1`, which `.ci/run` sets after installing it, the test fails.
#[test]
fn pyuff_reads_what_is_written() {
    let Some(python) = python_with_pyuff() else {
        let why = "no Python has pyuff; `.ci/programs` installs it";
        assert!(std::env::var_os("CALYX_CI_STRICT").is_none_or(|strict| strict != "1"), "{why}");
        // The harness captures the output macros of a passing test, but not direct writes to
        // standard error.
        let _ = std::io::stderr().write_all(format!("SKIPPED: {why}\n").as_bytes());
        return;
    };
    let directory = std::env::temp_dir().join(format!("calyx-unv-{}", std::process::id()));
    std::fs::create_dir_all(&directory).expect("a directory");
    let path = directory.join("all.unv");
    let mut datasets = datasets();
    // pyuff has double precision without exponents of three digits.
    if let UnvDataset::Nodes(nodes) = &mut datasets[2] {
        nodes.iter_mut().for_each(|node| node.position = [0.5, -0.25, 2.0]);
    }
    std::fs::write(&path, write(&datasets).expect("valid")).expect("written");
    let script = include_str!("data/read_unv.py");
    let output = Command::new(python).arg("-c").arg(script).arg(&path).output().expect("runs");
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let errors = String::from_utf8_lossy(&output.stderr).into_owned();
    std::fs::remove_dir_all(&directory).expect("removed");
    assert!(output.status.success() && text.trim() == "equal", "{text}{errors}");
}
