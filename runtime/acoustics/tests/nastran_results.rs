//! Sound of results of NASTRAN: the motion in OP2 and punch files is that of universal files, and
//! damaged files have errors.

use crate::op2_writer::{
    Complex, Form, Layout, Op2, Quantity, Word, Written, by_frequency, by_point, identification, punch,
};
use crate::shapes::sphere;
use calyx_acoustics::nastran_results::{
    FileKind, NastranResults, VectorAxes, read_op2, read_punch, recognize,
};
use calyx_acoustics::surface_sound::{CaseKind, DeckMesh, GridPoint, SoundOptions, Vibration, surface_sound};
use calyx_acoustics::unv::{LocatedValues, NodalData, ResultKind, UnvDataset, mesh_datasets, read, write};
use calyx_acoustics::{Face, Fluid, SurfaceMesh};
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::vec3::{Vector, cross, scaled, unit};
use faer::c64;
use std::f64::consts::{PI, TAU};

const RADIUS: f64 = 0.1;
/// Quantities, with their numbers in universal files.
const QUANTITIES: [(Quantity, i64); 3] =
    [(Quantity::Displacement, 8), (Quantity::Velocity, 11), (Quantity::Acceleration, 12)];

/// Axes of a node: basic, rotated, or those of a cylindrical system about z, by its index.
fn axes(index: usize, at: Vector) -> [Vector; 3] {
    let radial = unit([at[0], at[1], 0.0]);
    match index % 3 {
        1 => {
            let x = unit([1.0, 2.0, -0.5]);
            let y = unit(cross([0.0, 0.3, 1.0], x));
            [x, y, cross(x, y)]
        }
        2 if radial.iter().all(|x| x.is_finite()) => {
            [radial, cross([0.0, 0.0, 1.0], radial), [0.0, 0.0, 1.0]]
        }
        _ => [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
    }
}

/// Mesh of a deck in mm, with labels that are indices plus 1.
fn deck(mesh: &SurfaceMesh) -> DeckMesh {
    let point = |(index, at): (usize, &Vector)| GridPoint {
        label: index as i64 + 1,
        position: scaled(*at, 1e3),
        axes: axes(index, *at),
    };
    DeckMesh {
        points: mesh.vertices().iter().enumerate().map(point).collect(),
        shells: mesh.triangles().iter().map(|corners| Face::Triangle(*corners)).collect(),
        length: 1e-3,
        ..DeckMesh::default()
    }
}

/// Motion in basic coordinates, SI, of a node at a frequency.
type Field<'f> = &'f dyn Fn(Vector, f64) -> [c64; 3];

/// Some motion without symmetry.
fn waves(at: Vector, frequency: f64) -> [c64; 3] {
    [0, 1, 2].map(|k: usize| {
        let phase = 30.0 * at[k] + 20.0 * at[(k + 1) % 3] + frequency;
        c64::from_polar(1e-3 * (1.0 + k as f64 + 4.0 * at[0]), phase)
    })
}

/// Real motion without symmetry.
fn real_waves(at: Vector, frequency: f64) -> [c64; 3] {
    waves(at, frequency).map(|value| c64::new(value.re, 0.0))
}

/// Values in mm, along the axes of the nodes or the basic ones.
fn values(mesh: &SurfaceMesh, own_axes: bool, frequency: f64, field: Field) -> Vec<(i64, [Complex; 3])> {
    let value = |(index, at): (usize, &Vector)| {
        let basic = field(*at, frequency).map(|value| 1e3 * value);
        let along = |axis: Vector| (0..3).fold(c64::new(0.0, 0.0), |sum, k| sum + basic[k] * axis[k]);
        let own = if own_axes { axes(index, *at).map(along) } else { basic };
        (index as i64 + 1, own.map(|value| [value.re, value.im]))
    };
    mesh.vertices().iter().enumerate().map(value).collect()
}

/// The same motion in a universal file, as the program reads it.
fn from_unv(mesh: &SurfaceMesh, quantity: i64, all: &[Written], field: Field) -> Vibration {
    let dataset = |vectors: &Written| {
        let value = |(index, at): (usize, &Vector)| LocatedValues {
            label: index as i64 + 1,
            values: field(*at, vectors.frequency).to_vec(),
        };
        let (analysis, number, reals) = match vectors.mode {
            Some((number, _)) => (2, number, vec![vectors.frequency, 1.0, 0.0, 0.0]),
            None => (5, 1, vec![vectors.frequency]),
        };
        UnvDataset::NodalData(NodalData {
            names: vec!["motion".into()],
            kind: ResultKind { model: 1, analysis, characteristic: 2, quantity },
            is_complex: true,
            integers: vec![vectors.subcase, number],
            reals,
            values: mesh.vertices().iter().enumerate().map(value).collect(),
        })
    };
    let datasets: Vec<UnvDataset> = mesh_datasets(mesh).into_iter().chain(all.iter().map(dataset)).collect();
    let text = write(&datasets).expect("valid");
    Vibration::of_unv(&read(text.as_bytes()).expect("valid")).expect("a vibration")
}

/// Compares vibrations within the digits of universal files and of single precision: six.
fn assert_same(found: &Vibration, expected: &Vibration, what: &str) {
    assert_eq!(found.labels, expected.labels, "{what}");
    assert_eq!((&found.shells, &found.solids), (&expected.shells, &expected.solids), "{what}");
    for (one, other) in found.nodes.iter().zip(&expected.nodes) {
        assert!((0..3).all(|k| (one[k] - other[k]).abs() < 1e-9), "{what}: {one:?} {other:?}");
    }
    assert_eq!(found.cases.len(), expected.cases.len(), "{what}");
    for (one, other) in found.cases.iter().zip(&expected.cases) {
        assert_eq!(one.kind, other.kind, "{what}");
        assert!((one.frequency / other.frequency - 1.0).abs() < 2e-6, "{what}: {}", one.frequency);
        let largest = other.velocities.iter().flatten().map(|value| value.norm()).fold(0.0, f64::max);
        for (own, expected) in one.velocities.iter().flatten().zip(other.velocities.iter().flatten()) {
            assert!((own - expected).norm() < 1e-5 * largest, "{what}: {own} {expected}");
        }
    }
}

fn responses(mesh: &SurfaceMesh, quantity: Quantity, form: Form, own_axes: bool) -> Vec<Written> {
    let written = |frequency: f64| Written {
        subcase: 3,
        mode: None,
        frequency,
        quantity,
        form,
        values: values(mesh, own_axes, frequency, &waves),
    };
    [100.0, 250.5, 1000.0].map(written).to_vec()
}

fn modes(mesh: &SurfaceMesh) -> Vec<Written> {
    let written = |number: i64| {
        let frequency = 150.0 * number as f64;
        Written {
            subcase: 1,
            mode: Some((number, (TAU * frequency).powi(2))),
            frequency,
            quantity: Quantity::Displacement,
            form: Form::Real,
            values: values(mesh, true, frequency, &real_waves),
        }
    };
    [1, 2, 3].map(written).to_vec()
}

fn op2(layout: Layout, table: &str, records: &[Vec<Word>]) -> Vec<u8> {
    let mut file = Op2::new(layout);
    file.block("GEOM1", 0, &[vec![Word::I(5); 1500], vec![Word::I(6); 3]]);
    file.block(table, 0, records);
    file.key(0);
    assert_eq!(recognize(&file.bytes), FileKind::Op2);
    file.bytes
}

fn vibration(mesh: &SurfaceMesh, results: &NastranResults) -> Vibration {
    Vibration::of_nastran(&deck(mesh), results).expect("a vibration")
}

/// OP2 files of all layouts, quantities and forms have the motion of universal files, sorted by
/// frequency and by point, along the axes of the nodes and in basic coordinates.
#[test]
fn op2_files_have_the_motion_of_universal_files() {
    let mesh = sphere(1, RADIUS);
    for layout in Layout::ALL {
        for (quantity, number) in QUANTITIES {
            for form in [Form::Cartesian, Form::Polar] {
                for (table, own_axes) in [("OUGV1", true), ("OUG1", true), ("BOUGV1", false)] {
                    let written = responses(&mesh, quantity, form, own_axes);
                    let expected = from_unv(&mesh, number, &written, &waves);
                    for (sort, records) in [(1, by_frequency(&written)), (2, by_point(&written))] {
                        let what = format!("{layout:?} {quantity:?} {form:?} {table} SORT{sort}");
                        let results = read_op2(&op2(layout, table, &records)).expect(&what);
                        let axes = if own_axes { VectorAxes::Displacement } else { VectorAxes::Basic };
                        assert!(results.vectors.iter().all(|vectors| vectors.axes == axes), "{what}");
                        assert_same(&vibration(&mesh, &results), &expected, &what);
                    }
                }
            }
        }
        let written = modes(&mesh);
        let expected = from_unv(&mesh, 8, &written, &real_waves);
        let what = format!("modes, {layout:?}");
        let results = read_op2(&op2(layout, "OUGV1", &by_frequency(&written))).expect(&what);
        assert_same(&vibration(&mesh, &results), &expected, &what);
        assert_eq!(results.skipped["values of scalar points"], 3);
    }
}

/// Punch files have the same motion.
#[test]
fn punch_files_have_the_motion_of_universal_files() {
    let mesh = sphere(1, RADIUS);
    let read = |text: &str, what: &str| {
        assert_eq!(recognize(text.as_bytes()), FileKind::Punch, "{what}");
        read_punch(text).expect(what)
    };
    for (quantity, number) in QUANTITIES {
        for form in [Form::Cartesian, Form::Polar] {
            let written = responses(&mesh, quantity, form, true);
            let expected = from_unv(&mesh, number, &written, &waves);
            for is_by_point in [false, true] {
                let what = format!("{quantity:?} {form:?} {is_by_point}");
                let results = read(&punch(&written, is_by_point), &what);
                assert_same(&vibration(&mesh, &results), &expected, &what);
            }
        }
    }
    let written = modes(&mesh);
    let results = read(&punch(&written, false), "modes");
    assert_same(&vibration(&mesh, &results), &from_unv(&mesh, 8, &written, &real_waves), "modes");
    assert_eq!(results.skipped["values of scalar points"], 3);
}

/// A pulsating sphere in a deck in mm has the power of the closed form (Pierce, Acoustics, 4-1)
/// within 1 %, and its rigid-body modes and responses at 0 Hz have none.
#[test]
fn pulsating_spheres_have_the_closed_form() {
    let mesh = sphere(3, RADIUS);
    let velocity = 2e-3;
    let radial = |at: Vector, _: f64| unit(at).map(|x| c64::from_polar(velocity * x, 0.7));
    let kas = [0.3, 1.0, 2.0];
    let frequency = |ka: f64| ka * Fluid::AIR.speed_of_sound / (TAU * RADIUS);
    let written = |frequency: f64| Written {
        subcase: 1,
        mode: None,
        frequency,
        quantity: Quantity::Velocity,
        form: Form::Polar,
        values: values(&mesh, true, frequency, &radial),
    };
    let mut all = kas.map(|ka| written(frequency(ka))).to_vec();
    all.push(written(0.0));
    let mut rigid = Written { mode: Some((1, -1e-6)), form: Form::Real, ..written(1.0) };
    rigid.quantity = Quantity::Displacement;
    all.extend([rigid.clone(), Written { mode: Some((2, 1e-4)), ..rigid }]);
    let results = read_op2(&op2(Layout::LITTLE, "OUGV1", &by_frequency(&all))).expect("valid");
    let vibration = vibration(&mesh, &results);
    let notes = vibration.notes.join("\n");
    assert!(notes.contains("multiplied by 0.001 to be in m"), "{notes}");
    assert!(notes.contains("2 times mode below 0.1 Hz") && notes.contains("response at 0 Hz"), "{notes}");
    let options = SoundOptions::default();
    let found = surface_sound(&vibration, &options, &Interrupt::never(), &mut |_, _| {}).expect("solved");
    assert_eq!(found.cases.len(), 3);
    for (case, ka) in found.cases.iter().zip(kas) {
        let area = 4.0 * PI * RADIUS * RADIUS;
        let power = 0.5 * Fluid::AIR.impedance() * velocity.powi(2) * area * ka * ka / (1.0 + ka * ka);
        assert_eq!(case.kind, CaseKind::Response(String::new()));
        assert!((case.power / power - 1.0).abs() < 0.01, "{} {power}", case.power);
    }
}

/// Subcases are load cases; velocities are preferred to displacements; and other tables and results
/// are skipped and counted.
#[test]
fn other_results_are_skipped() {
    let mesh = sphere(0, RADIUS);
    let written = |subcase: i64, quantity: Quantity| Written {
        subcase,
        mode: None,
        frequency: 300.0,
        quantity,
        form: Form::Cartesian,
        values: values(&mesh, true, 300.0, &waves),
    };
    let good = [
        written(1, Quantity::Displacement),
        written(2, Quantity::Displacement),
        written(2, Quantity::Velocity),
    ];
    let mut records = by_frequency(&good);
    for (word, value) in [(0, 12), (0, 62), (0, 92), (1, 5001), (1, 1003), (22, 1)] {
        let mut words = identification(&good[0], None);
        words[word] = Word::I(value);
        records.extend([words, vec![Word::I(1); 28]]);
    }
    let mut file = Op2::new(Layout::LITTLE);
    file.block("OUGV1", 0, &records);
    file.block("OES1X1", 0, &[vec![Word::I(1); 146], vec![Word::I(1); 17]]);
    file.block("OUGPSD2", 0, &by_frequency(&good));
    // Records of matrices have one word more than their keys announce.
    file.block("KELM", 1, &[]);
    file.bytes.truncate(file.bytes.len() - 12 * 3 - 12);
    file.key(-3);
    file.data(&[Word::I(1)]);
    file.key(2);
    file.record(&[0; 12]);
    file.key(-4);
    file.data(&[Word::I(1)]);
    file.key(0);
    file.block("ROUGV1", 0, &by_frequency(&good));
    file.key(0);
    let results = read_op2(&file.bytes).expect("valid");
    assert_eq!(results.vectors.len(), 3);
    let counts: Vec<(&str, usize)> =
        results.skipped.iter().map(|(reason, count)| (reason.as_str(), *count)).collect();
    let expected = [
        ("complex modes", 1),
        ("random results", 1),
        ("result of the table code 1003", 1),
        ("static results", 1),
        ("table OUGPSD2", 1),
        ("table ROUGV1 of motion relative to the base", 1),
        ("table of other quantities", 2),
        ("temperatures", 1),
        ("transient results", 1),
        ("values of scalar points", 3),
    ];
    assert_eq!(counts, expected);
    let cases = vibration(&mesh, &results).cases;
    let kinds: Vec<&CaseKind> = cases.iter().map(|case| &case.kind).collect();
    assert_eq!(kinds, [&CaseKind::Response("1".into()), &CaseKind::Response("2".into())]);
    let speeds = [0, 1].map(|case: usize| cases[case].velocities[0][0].norm());
    assert!((speeds[0] / speeds[1] / (TAU * 300.0) - 1.0).abs() < 1e-5, "{speeds:?}");
    // Sections of a punch file.
    let text = punch(&good[..1], false);
    let of = |old: &str, new: &str| text.replace(old, new);
    let other = [
        of("$DISPLACEMENTS", "$SPCF"),
        of("$FREQUENCY =", "$TIME ="),
        of("$FREQUENCY =", "$LABEL   ="),
        of("$FREQUENCY =", "$EIGENVALUE = (1.0, 2.0) MODE = 1 "),
    ];
    let results = read_punch(&other.concat()).expect("valid");
    assert!(results.vectors.is_empty(), "{:?}", results.vectors);
    let error = Vibration::of_nastran(&deck(&mesh), &results).expect_err("no motion");
    for part in ["no motion", "complex modes", "results of spcf", "static results", "transient results"] {
        assert!(error.message.contains(part), "{part}: {}", error.message);
    }
    assert_eq!(error.code, "E0784");
}

/// Wrong contents have errors with their place.
#[test]
fn wrong_results_are_rejected() {
    let mesh = sphere(0, RADIUS);
    let good = responses(&mesh, Quantity::Velocity, Form::Cartesian, true);
    let records = by_frequency(&good);
    let rejected = |change: &dyn Fn(&mut Vec<Vec<Word>>), part: &str| {
        let mut records = records.clone();
        change(&mut records);
        let read = read_op2(&op2(Layout::LITTLE, "OUGV1", &records));
        let message = match read {
            Err(error) => error.to_string(),
            Ok(results) => Vibration::of_nastran(&deck(&mesh), &results).map(drop).expect_err(part).message,
        };
        assert!(message.contains(part) && message.contains("table OUGV1 at byte"), "{part}: {message}");
    };
    rejected(&|all| all[1].truncate(20), "the values have 20 words, and entries have 14 words");
    rejected(&|all| all[0].truncate(10), "an identification has 10 words instead of 146");
    rejected(&|all| all[0][9] = Word::I(9), "entries have 9 words, which is neither 8 nor 14");
    rejected(&|all| all[0][4] = Word::R(-2.0), "the frequency of the results is -2 Hz");
    rejected(&|all| all[1][0] = Word::I(7772), "the results have the node 777, which is not in the deck");
    rejected(&|all| all[1][0] = Word::I(22), "the results have the node 2 twice");
    rejected(&|all| all[1][2] = Word::R(f64::NAN), "is not finite");
    // Points with larger labels than decks permit are those of connectors.
    let mut generated = records.clone();
    generated[1].extend(records[1][..14].to_vec());
    let last = generated[1].len() - 14;
    generated[1][last] = Word::I(1_010_000_012);
    let results = read_op2(&op2(Layout::LITTLE, "OUGV1", &generated)).expect("valid");
    let notes = vibration(&mesh, &results).notes.join("\n");
    assert!(notes.contains("values of generated grid points"), "{notes}");
    let still = Vibration::of_nastran(&deck(&mesh), &NastranResults::default()).expect_err("no motion");
    assert!(still.message.contains("no motion"), "{}", still.message);
    let results = read_op2(&op2(Layout::LITTLE, "OUGV1", &records)).expect("valid");
    let error = |mesh: DeckMesh| Vibration::of_nastran(&mesh, &results).expect_err("no mesh").message;
    assert!(error(DeckMesh { shells: Vec::new(), ..deck(&mesh) }).contains("no surface"));
    assert!(error(DeckMesh { length: 0.0, ..deck(&mesh) }).contains("unit of length"));
    let mut lacking = deck(&mesh);
    lacking.points.pop();
    assert!(error(lacking).contains("does not exist"));
    let text = punch(&good, false);
    let punched = |old: &str, new: &str| {
        assert!(text.contains(old), "{old}");
        read_punch(&text.replacen(old, new, 1)).expect_err(new)
    };
    assert_eq!(punched("$REAL-IMAGINARY OUTPUT", "$NONE").place, "line 8");
    assert!(punched("$SUBCASE ID =", "$SUBCASE ID = x").message.contains("`X`"));
    assert!(punched("       G", "       G     x").message.contains("where a number is expected"));
    assert!(punched("         2       G", "         y       G").message.contains("`y`"));
    let cut = read_punch(&text[..81 * 9]).expect_err("truncated");
    assert_eq!((cut.place.as_str(), cut.message.as_str()), ("line 9", "a point lacks its last lines"));
}

/// Files that end anywhere, or have wrong bits anywhere, have an error or results, but no panic.
#[test]
fn damaged_files_do_not_panic() {
    let mesh = sphere(0, RADIUS);
    let written = responses(&mesh, Quantity::Velocity, Form::Cartesian, true);
    let deck = deck(&mesh);
    for (layout, sorted) in Layout::ALL.into_iter().zip([false, true].into_iter().cycle()) {
        let records = if sorted { by_point(&written) } else { by_frequency(&written) };
        let good = op2(layout, "OUGV1", &records);
        for end in (4..good.len()).step_by(7).chain(good.len() - 50..good.len()) {
            // A file may end after a table.
            match read_op2(&good[..end]) {
                Ok(results) => assert!(!results.is_complete, "{end}"),
                Err(error) => assert!(error.message.contains("ends within a table"), "{error}"),
            }
        }
        for at in (0..good.len()).step_by(3) {
            let mut bad = good.clone();
            bad[at] ^= 1 << (at % 8);
            bad[(at * 31) % good.len()] ^= 0x80;
            if let Ok(results) = read_op2(&bad) {
                let _ = Vibration::of_nastran(&deck, &results);
            }
        }
    }
    let good = punch(&written, true).into_bytes();
    for at in (0..good.len()).step_by(11) {
        let mut bad = good.clone();
        bad[at] ^= 1 << (at % 8);
        for bytes in [&bad[..], &good[..at]] {
            if let Ok(results) = read_punch(&String::from_utf8_lossy(bytes)) {
                let _ = Vibration::of_nastran(&deck, &results);
            }
        }
    }
}

/// Files are recognized by their content.
#[test]
fn files_are_recognized() {
    let cases: [(&[u8], FileKind); 9] = [
        (b"\x89HDF\r\n\x1a\n\0\0\0", FileKind::Hdf5),
        (b"1\n\n     * *      M S C . N a s t r a n      * *\n", FileKind::Printed),
        (b"1    HOUSING      MSC.NASTRAN\n      R E A L   E I G E N V A L U E S\n", FileKind::Printed),
        (b"SOL 103\nCEND\nBEGIN BULK\nENDDATA\n", FileKind::Deck),
        (b"$ mesh\nGRID,1,,0.,0.,0.\n", FileKind::Deck),
        (b"\n    -1\n   164\n", FileKind::Universal),
        (b"X 0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ$/+-()'=.*\n", FileKind::FormattedOp2),
        (b"\x07\0\0\0binary", FileKind::Other),
        (b"", FileKind::Other),
    ];
    for (content, kind) in cases {
        assert_eq!(recognize(content), kind, "{}", String::from_utf8_lossy(content));
    }
}
