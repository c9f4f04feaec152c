//! Sound of vibrations in universal files: closed forms, quantities and units, openings, solids,
//! modes, functions, and damaged files.

use crate::shapes::sphere;
use crate::special_functions::{legendre, sphere_power};
use calyx_acoustics::Fluid;
use calyx_acoustics::surface_sound::{CaseKind, SoundOptions, SurfaceSound, Vibration, surface_sound};
use calyx_acoustics::unv::{
    Abscissae, Element, Function, FunctionAxis, FunctionEnd, LocatedValues, NodalData, Node, Ordinates,
    ResultKind, Units, UnvDataset, UnvFile, mesh_datasets, read, write,
};
use calyx_acoustics::{Face, RigidPlane, SoundMethod, SurfaceMesh};
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::vec3::Vector;
use faer::c64;
use std::f64::consts::{PI, TAU};

const RADIUS: f64 = 0.1;
/// Amplitude of the velocity of pulsating spheres, m/s.
const VELOCITY: f64 = 2e-3;
/// Quantities of results.
const DISPLACEMENT: i64 = 8;
const ACCELERATION: i64 = 12;
const PRESSURE: i64 = 15;
const SPEED: i64 = 11;

/// Frequency at which a sphere of radius a has the product k a, Hz.
fn frequency(ka: f64) -> f64 {
    ka * Fluid::AIR.speed_of_sound / (TAU * RADIUS)
}

/// Power of a pulsating sphere: ½ρc|v|²S (ka)²/(1 + (ka)²) (Pierce, Acoustics, 4-1).
fn pulsating(ka: f64) -> f64 {
    let area = 4.0 * PI * RADIUS * RADIUS;
    0.5 * Fluid::AIR.impedance() * VELOCITY * VELOCITY * area * ka * ka / (1.0 + ka * ka)
}

/// Results at the nodes of a mesh whose labels are indices plus 1.
fn results(
    mesh: &SurfaceMesh,
    [analysis, quantity]: [i64; 2],
    frequency: f64,
    motion: impl Fn(Vector) -> [c64; 3],
) -> UnvDataset {
    let omega = TAU * frequency;
    let factor = match quantity {
        DISPLACEMENT => c64::new(0.0, -omega.recip()),
        ACCELERATION => c64::new(0.0, omega),
        _ => c64::new(1.0, 0.0),
    };
    let value = |(index, at): (usize, &Vector)| LocatedValues {
        label: index as i64 + 1,
        values: motion(*at).iter().map(|value| value * factor).collect(),
    };
    UnvDataset::NodalData(NodalData {
        names: vec!["motion".into()],
        kind: ResultKind { model: 1, analysis, characteristic: 2, quantity },
        is_complex: true,
        integers: vec![1, 1],
        reals: if analysis == 2 { vec![frequency, 1.0, 0.0, 0.0] } else { vec![frequency] },
        values: mesh.vertices().iter().enumerate().map(value).collect(),
    })
}

fn radial(at: Vector) -> [c64; 3] {
    let size = at.iter().map(|x| x * x).sum::<f64>().sqrt();
    at.map(|x| c64::from_polar(VELOCITY, 0.7) * (x / size))
}

fn file(mesh: &SurfaceMesh, results: impl IntoIterator<Item = UnvDataset>) -> UnvFile {
    let datasets = mesh_datasets(mesh).into_iter().chain(results).collect();
    UnvFile { datasets, ..UnvFile::default() }
}

/// Writes a file, reads it and computes its sound.
fn sound(file: &UnvFile, options: &SoundOptions) -> Result<SurfaceSound, EngineError> {
    let text = write(&file.datasets).expect("valid");
    let file = read(text.as_bytes()).expect("valid");
    surface_sound(&Vibration::of_unv(&file)?, options, &Interrupt::never(), &mut |_, _| {})
}

/// A pulsating sphere has the power of the closed form within 1 %, from velocities, displacements
/// and accelerations, and in any unit of length. The pressure decreases like that of a monopole.
#[test]
fn pulsating_spheres_have_the_closed_form() {
    let mesh = sphere(3, RADIUS);
    let kas = [0.3, 1.0, 2.0];
    let points = vec![[0.0, 0.0, 0.5], [1.0, 0.0, 0.0]];
    let options = SoundOptions { points, ..SoundOptions::default() };
    let all = |quantity| kas.map(|ka| results(&mesh, [5, quantity], frequency(ka), radial));
    let expected: Vec<f64> = kas.iter().map(|ka| pulsating(*ka)).collect();
    let found = sound(&file(&mesh, all(SPEED)), &options).expect("solved");
    for (case, expected) in found.cases.iter().zip(&expected) {
        assert_eq!(case.kind, CaseKind::Response(String::new()));
        assert!((case.power / expected - 1.0).abs() < 0.01, "{} {expected}", case.power);
        let [near, far] = case.pressures[..] else { panic!("two points") };
        // The wave has the amplitude of the power, and its phase at both distances.
        let amplitude = (case.power * 2.0 * Fluid::AIR.impedance() / (4.0 * PI)).sqrt();
        assert!((far.norm() / amplitude - 1.0).abs() < 0.01);
        let wavenumber = TAU * case.frequency / Fluid::AIR.speed_of_sound;
        assert!((near / far / c64::from_polar(2.0, 0.5 * wavenumber) - 1.0).norm() < 0.01);
    }
    assert_eq!(found.warnings, Vec::<String>::new());
    for quantity in [DISPLACEMENT, ACCELERATION] {
        let other = sound(&file(&mesh, all(quantity)), &options).expect("solved");
        for (one, other) in found.cases.iter().zip(&other.cases) {
            // Five decimals of the fields of results.
            assert!((one.power / other.power - 1.0).abs() < 1e-4, "{quantity}");
            let difference = (one.pressures[0] - other.pressures[0]).norm();
            assert!(difference < 1e-4 * one.pressures[0].norm(), "{quantity}");
        }
    }
    let mut in_mm = file(&mesh, all(SPEED));
    for dataset in &mut in_mm.datasets {
        match dataset {
            UnvDataset::Units(units) => {
                *units = Units { code: 5, factors: [1000.0, 1.0, 1.0], ..Units::si() }
            }
            UnvDataset::Nodes(nodes) => {
                nodes.iter_mut().for_each(|node| node.position = node.position.map(|x| 1e3 * x))
            }
            UnvDataset::NodalData(data) => {
                data.values.iter_mut().flat_map(|own| &mut own.values).for_each(|value| *value *= 1e3);
            }
            _ => {}
        }
    }
    let other = sound(&in_mm, &options).expect("solved");
    for (one, other) in found.cases.iter().zip(&other.cases) {
        assert!((one.power / other.power - 1.0).abs() < 1e-4);
    }
    assert!(other.notes[0].contains("divided by 1000"), "{:?}", other.notes);
}

/// Spherical modes of a fine mesh, which is coarsened far below six elements per wavelength at low
/// frequencies. The power of the order n varies with the radius to the power 2 n, which coarsening
/// reduces by up to 0.35 %; the bound is twice this and 1 %.
#[test]
fn spherical_modes_have_the_closed_form_on_coarsened_meshes() {
    let mesh = sphere(4, RADIUS);
    let datasets = [0.3, 3.0].into_iter().flat_map(|ka| {
        let mesh = &mesh;
        (0..=3).map(move |order| {
            let motion = |at: Vector| {
                let size = at.iter().map(|x| x * x).sum::<f64>().sqrt();
                let factor = legendre(order, at[2] / size)[order];
                radial(at).map(|value| value * factor)
            };
            let UnvDataset::NodalData(mut data) = results(mesh, [5, SPEED], frequency(ka), motion) else {
                panic!("nodal data")
            };
            data.integers[0] = order as i64;
            UnvDataset::NodalData(data)
        })
    });
    let found = sound(&file(&mesh, datasets), &SoundOptions::default()).expect("solved");
    assert_eq!(found.cases.len(), 8);
    assert!(found.surface.coarse_triangles[1] < mesh.triangles().len());
    for case in &found.cases {
        let CaseKind::Response(load) = &case.kind else { panic!("a response") };
        let order: usize = load.parse().expect("a number");
        let mut coefficients = vec![0.0; order + 1];
        coefficients[order] = VELOCITY;
        let wavenumber = TAU * case.frequency / Fluid::AIR.speed_of_sound;
        let expected = Fluid::AIR.impedance() * sphere_power(&coefficients, wavenumber, RADIUS);
        let (error, bound) = (case.power / expected - 1.0, 0.01 + 2.0 * 2.0 * order as f64 * 0.0035);
        assert!(error.abs() < bound, "order {order}, {} Hz: {error}", case.frequency);
    }
}

/// The radiation efficiency of a mode does not depend on its amplitude, and is that of the closed
/// form. Rigid-body modes at 0 Hz are skipped.
#[test]
fn modes_have_radiation_efficiencies() {
    let mesh = sphere(3, RADIUS);
    let ka = 1.5;
    let scaled = |factor: f64| move |at: Vector| radial(at).map(|value| value * factor);
    let mut all = [0.0, frequency(ka), frequency(ka)].map(|f| results(&mesh, [2, DISPLACEMENT], f, radial));
    for (number, dataset) in all.iter_mut().enumerate() {
        let UnvDataset::NodalData(data) = dataset else { panic!("results") };
        data.integers[1] = number as i64 + 1;
        if number == 0 {
            data.values
                .iter_mut()
                .flat_map(|own| &mut own.values)
                .for_each(|value| *value = c64::new(1.0, 0.0));
        }
    }
    let UnvDataset::NodalData(mut other) = results(&mesh, [2, DISPLACEMENT], frequency(ka), scaled(1e5))
    else {
        panic!("results")
    };
    other.integers[1] = 3;
    all[2] = UnvDataset::NodalData(other);
    let options = SoundOptions { points: vec![[1.0, 0.0, 0.0]], ..SoundOptions::default() };
    let found = sound(&file(&mesh, all), &options).expect("solved");
    let kinds: Vec<&CaseKind> = found.cases.iter().map(|case| &case.kind).collect();
    assert_eq!(kinds, [&CaseKind::Mode(2), &CaseKind::Mode(3)]);
    let efficiency = ka * ka / (1.0 + ka * ka);
    let area = 4.0 * PI * RADIUS * RADIUS;
    for case in &found.cases {
        assert!((case.efficiency() / efficiency - 1.0).abs() < 0.01, "{}", case.efficiency());
        let power = Fluid::AIR.impedance() * area * efficiency;
        assert!((case.power_per_mean_square() / power - 1.0).abs() < 0.01);
        assert!(case.pressures.is_empty());
    }
    assert!((found.cases[0].efficiency() / found.cases[1].efficiency() - 1.0).abs() < 1e-4);
    assert!(found.notes.iter().any(|note| note.contains("mode at 0 Hz")), "{:?}", found.notes);
}

/// Functions of a frequency response have the sound of the same motion as results at nodes.
#[test]
fn functions_are_motions() {
    let mesh = sphere(2, RADIUS);
    let frequencies = [0.0, frequency(0.5), frequency(1.0)];
    let axis = |quantity| FunctionAxis { quantity, ..FunctionAxis::default() };
    let mut functions = Vec::new();
    for (index, at) in mesh.vertices().iter().enumerate() {
        for axis_number in 1..=3_usize {
            // The third direction is that of the negative axis.
            let sign = if axis_number == 3 { -1.0 } else { 1.0 };
            let value = radial(*at)[axis_number - 1] * sign;
            functions.push(UnvDataset::Function(Box::new(Function {
                names: vec!["velocity".into()],
                kind: 12,
                numbers: [1, 0, 1],
                response: FunctionEnd {
                    entity: String::new(),
                    node: index as i64 + 1,
                    direction: axis_number as i64 * sign as i64,
                },
                reference: FunctionEnd::default(),
                abscissae: Abscissae::Even { first: 0.0, increment: frequencies[1] },
                z: 0.0,
                axes: [axis(18), axis(SPEED), axis(0), axis(0)],
                ordinates: Ordinates::Complex(vec![value; 3], true),
            })));
        }
    }
    let options = SoundOptions { method: SoundMethod::Rayleigh, ..SoundOptions::default() };
    let found = sound(&file(&mesh, functions), &options).expect("solved");
    let nodal = frequencies[1..].iter().map(|at| results(&mesh, [5, SPEED], *at, radial));
    let expected = sound(&file(&mesh, nodal), &options).expect("solved");
    assert_eq!(found.cases.len(), 2);
    for (found, expected) in found.cases.iter().zip(&expected.cases) {
        assert!((found.power / expected.power - 1.0).abs() < 1e-4);
    }
}

/// Plane box of quadrilaterals without its top: 3 x 2 x 2 elements of 0.1 m.
fn box_without_top() -> (Vec<Node>, Vec<Element>) {
    let counts = [3_i64, 2, 2];
    let label = |[i, j, k]: [i64; 3]| 1 + i + 10 * j + 100 * k;
    let (mut nodes, mut elements) = (Vec::new(), Vec::new());
    for axis in 0..3 {
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        for side in [0, counts[axis]] {
            for (i, j) in (0..counts[u]).flat_map(|i| (0..counts[v]).map(move |j| (i, j))) {
                if axis == 2 && side > 0 {
                    continue;
                }
                let corner = |di: i64, dj: i64| {
                    let mut at = [0; 3];
                    (at[axis], at[u], at[v]) = (side, i + di, j + dj);
                    at
                };
                let corners = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
                nodes.extend(corners);
                elements.push(Element {
                    label: elements.len() as i64 + 1,
                    descriptor: 94,
                    attributes: [1, 1, 7],
                    beam: None,
                    nodes: corners.map(label).to_vec(),
                });
            }
        }
    }
    nodes.sort_unstable();
    nodes.dedup();
    let node = |at: [i64; 3]| Node {
        label: label(at),
        attributes: [1, 1, 11],
        position: at.map(|x| 0.1 * x as f64),
    };
    (nodes.into_iter().map(node).collect(), elements)
}

fn box_file(nodes: &[Node], elements: &[Element]) -> UnvFile {
    let values = |node: &Node| LocatedValues {
        label: node.label,
        values: [1e-3, 2e-3, node.position[0]].map(|value| c64::new(value, 0.0)).to_vec(),
    };
    let results = UnvDataset::NodalData(NodalData {
        names: vec!["motion".into()],
        kind: ResultKind { model: 1, analysis: 5, characteristic: 2, quantity: SPEED },
        is_complex: false,
        integers: vec![1, 1],
        reals: vec![200.0],
        values: nodes.iter().map(values).collect(),
    });
    let datasets = vec![
        UnvDataset::Units(Units::si()),
        UnvDataset::Nodes(nodes.to_vec()),
        UnvDataset::Elements(elements.to_vec()),
        results,
    ];
    UnvFile { datasets, ..UnvFile::default() }
}

/// An open box is rejected with the place of its opening, or closed by a lid that moves with the
/// rim, and then has the sound of the box with such a lid.
#[test]
fn openings_are_listed_or_closed() {
    let (mut nodes, mut elements) = box_without_top();
    let error = sound(&box_file(&nodes, &elements), &SoundOptions::default()).expect_err("open");
    assert_eq!(error.code, "E0785");
    assert!(error.message.contains("opening of 10 nodes around (150, 100, 200) mm"), "{}", error.message);
    assert!(error.help.contains("--close-openings"));
    let options = SoundOptions { close_openings: true, ..SoundOptions::default() };
    let closed = sound(&box_file(&nodes, &elements), &options).expect("closed");
    assert_eq!(closed.surface.lids, 1);
    // The same lid as elements: the mean motion of its rim is that of its middle.
    let middle = Node { label: 999, attributes: [1, 1, 11], position: [0.15, 0.1, 0.2] };
    let top: Vec<i64> = nodes.iter().filter(|node| node.position[2] > 0.19).map(|node| node.label).collect();
    let around = [201, 202, 203, 204, 214, 224, 223, 222, 221, 211];
    assert!(top.iter().all(|label| *label == 212 || *label == 213 || around.contains(label)));
    nodes.push(middle);
    for (at, &from) in around.iter().enumerate() {
        elements.push(Element {
            label: 100 + at as i64,
            descriptor: 91,
            attributes: [1, 1, 7],
            beam: None,
            nodes: vec![from, around[(at + 1) % around.len()], 999],
        });
    }
    let whole = sound(&box_file(&nodes, &elements), &SoundOptions::default()).expect("closed");
    let ratio = closed.cases[0].power / whole.cases[0].power;
    // The triangles of both lids begin at other vertices, which changes the quadrature.
    assert!((ratio - 1.0).abs() < 1e-5, "{ratio}");
    assert!((closed.surface.area / whole.surface.area - 1.0).abs() < 1e-12);
}

/// The skin of solids has the sound of the same skin as quadrilaterals, and inner nodes need no
/// results. Midside nodes are left out.
#[test]
fn skins_of_solids_radiate() {
    let label = |[i, j, k]: [i64; 3]| 1 + i + 10 * j + 100 * k;
    let range = || (0..4_i64).flat_map(|i| (0..4_i64).flat_map(move |j| (0..4_i64).map(move |k| [i, j, k])));
    let nodes: Vec<Node> = range()
        .map(|at| Node { label: label(at), attributes: [1, 1, 11], position: at.map(|x| 0.1 * x as f64) })
        .collect();
    let corners = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]];
    let first = range().filter(|at| at.iter().all(|x| *x < 3));
    let elements: Vec<Element> = first
        .enumerate()
        .map(|(index, at)| Element {
            label: index as i64 + 1,
            descriptor: 115,
            attributes: [1, 1, 7],
            beam: None,
            nodes: corners.iter().map(|corner| label([0, 1, 2].map(|k: usize| at[k] + corner[k]))).collect(),
        })
        .collect();
    let mut file = box_file(&nodes, &elements);
    let UnvDataset::NodalData(data) = &mut file.datasets[3] else { panic!("results") };
    let is_inner =
        |label: i64| [label % 10 - 1, label / 10 % 10, label / 100].iter().all(|x| (1..3).contains(x));
    data.values.retain(|own| !is_inner(own.label));
    let options = SoundOptions { method: SoundMethod::EquivalentPower, ..SoundOptions::default() };
    let found = sound(&file, &options).expect("closed");
    assert_eq!(found.surface.triangles, 6 * 9 * 2);
    // Normal velocities are 1e-3, 2e-3 and x on pairs of sides of 0.09 m²; triangles have their
    // mean, and x has the mean square 0.03 less what the triangles average.
    let mean_square = |values: &[f64]| values.iter().map(|x| x * x).sum::<f64>() / values.len() as f64;
    let thirds: Vec<f64> =
        (0..3).flat_map(|i| [(i as f64 + 1.0 / 3.0) * 0.1, (i as f64 + 2.0 / 3.0) * 0.1]).collect();
    let sum = 2.0 * 0.09 * (1e-6 + 4e-6 + mean_square(&thirds));
    assert!((found.cases[0].power / (0.5 * Fluid::AIR.impedance() * sum) - 1.0).abs() < 1e-4);
    assert!((found.cases[0].efficiency() - 1.0).abs() < 1e-12);
}

/// A rigid plane reflects the sound: far from the plane at low frequencies the power of a monopole
/// has the factor 1 + sin(2kh)/(2kh).
#[test]
fn rigid_planes_reflect() {
    let mesh = sphere(2, RADIUS);
    let height = 0.8;
    let ka = 0.1;
    let nodes = file(&mesh, [results(&mesh, [5, SPEED], frequency(ka), radial)]);
    let free = sound(&nodes, &SoundOptions::default()).expect("solved").cases[0].power;
    let plane = RigidPlane::new([0.0, 0.0, -height], [0.0, 0.0, 1.0]).ok();
    let options = SoundOptions { plane, ..SoundOptions::default() };
    let reflected = sound(&nodes, &options).expect("solved").cases[0].power;
    let way = 2.0 * ka / RADIUS * height;
    // The sphere scatters the reflected sound: an error of the order (a/2h)² ka.
    assert!((reflected / free - (1.0 + way.sin() / way)).abs() < 0.01, "{}", reflected / free);
}

/// Every damaged file has an error with the place and a remedy.
#[test]
fn wrong_files_are_rejected() {
    let mesh = sphere(0, RADIUS);
    let good = || file(&mesh, [results(&mesh, [5, SPEED], 500.0, radial)]);
    let options = SoundOptions { method: SoundMethod::EquivalentPower, ..SoundOptions::default() };
    assert!(sound(&good(), &options).is_ok());
    let check = |change: &dyn Fn(&mut Vec<UnvDataset>), part: &str| {
        let mut file = good();
        change(&mut file.datasets);
        let error = sound(&file, &options).expect_err(part);
        assert_eq!(error.code, "E0784", "{}", error.message);
        assert!(error.message.contains(part) && !error.help.is_empty(), "{part}: {}", error.message);
    };
    fn data(datasets: &mut [UnvDataset]) -> &mut NodalData {
        let Some(UnvDataset::NodalData(data)) = datasets.last_mut() else { panic!("results") };
        data
    }
    fn nodes(datasets: &mut [UnvDataset]) -> &mut Vec<Node> {
        let UnvDataset::Nodes(nodes) = &mut datasets[1] else { panic!("nodes") };
        nodes
    }
    check(
        &|all| nodes(all).retain(|node| node.label != 4),
        "line 32: the node 4 of the element 7 is not in the file",
    );
    check(&|all| nodes(all)[3].label = 5, "has two positions for the node 5");
    check(&|all| drop(all.pop()), "no motion of nodes");
    check(&|all| drop(all.remove(2)), "no surface");
    check(
        &|all| drop(data(all).values.remove(2)),
        "1 nodes of the surface have no result, such as the node 3",
    );
    check(&|all| data(all).values[2].label = 77, "the node 77, which is not in the file");
    check(&|all| data(all).values[2].label = 1, "the node 1 twice");
    check(&|all| data(all).reals[0] = 0.0, "dataset 55 at line");
    check(&|all| data(all).reals[0] = -5.0, "the frequency of the results is -5 Hz");
    check(&|all| data(all).reals.clear(), "the results have no frequency");
    check(&|all| data(all).kind.quantity = PRESSURE, "results of pressure");
    check(&|all| data(all).kind.analysis = 4, "analysis type 4");
    check(
        &|all| data(all).values.iter_mut().for_each(|own| own.values.truncate(1)),
        "fewer than three components",
    );
    check(&|all| data(all).values[0].values[0] = c64::new(1e200, 0.0), "the sound power at 500 Hz is inf W");
    let huge = |all: &mut Vec<UnvDataset>| {
        all[0] = UnvDataset::Units(Units { factors: [1e-200, 1.0, 1.0], ..Units::si() });
        data(all).values[0].values[0] = c64::new(1e200, 0.0);
        nodes(all).iter_mut().for_each(|node| node.position = node.position.map(|x| 1e-200 * x));
    };
    check(&huge, "the velocity of the node 1 is not finite");
    // Requests that the method does not support.
    let points = SoundOptions { points: vec![[1.0, 0.0, 0.0]], ..options.clone() };
    assert!(sound(&good(), &points).expect_err("no pressures").message.contains("no sound pressure"));
    let inside = SoundOptions { points: vec![[0.0; 3]], ..SoundOptions::default() };
    assert!(sound(&good(), &inside).expect_err("inside").message.contains("is inside of the body"));
    let plane = RigidPlane::new([0.0; 3], [0.0, 0.0, 1.0]).ok();
    let behind = SoundOptions { plane, ..SoundOptions::default() };
    let error = sound(&good(), &behind).expect_err("behind");
    assert_eq!(error.code, "E0784", "{}", error.message);
}

/// Two spheres: closed parts may be apart, or one may enclose the other; parts that intersect are
/// rejected at a node, and so are lengths in mm without a unit, before anything is solved.
#[test]
fn intersections_and_long_elements_are_rejected() {
    let one = sphere(1, RADIUS);
    let two = |radius: f64, x: f64| -> UnvFile {
        let other = sphere(1, radius);
        let count = one.vertices().len();
        let moved = other.vertices().iter().map(|at| [at[0] + x, at[1], at[2]]);
        let vertices: Vec<Vector> = one.vertices().iter().copied().chain(moved).collect();
        let triangle = |corners: &[usize; 3]| Face::Triangle(corners.map(|corner| corner + count));
        let faces: Vec<Face> = one
            .triangles()
            .iter()
            .map(|corners| Face::Triangle(*corners))
            .chain(other.triangles().iter().map(triangle))
            .collect();
        let mesh = SurfaceMesh::new(vertices, &faces, None).expect("closed parts");
        file(&mesh, [results(&mesh, [5, SPEED], frequency(0.5), |_| [c64::new(1e-3, 0.0); 3])])
    };
    let options = SoundOptions { method: SoundMethod::Rayleigh, ..SoundOptions::default() };
    assert_eq!(sound(&two(RADIUS, 0.3), &options).expect("apart").surface.triangles, 160);
    assert_eq!(sound(&two(0.5 * RADIUS, 0.0), &options).expect("inside").surface.triangles, 80);
    for (radius, x) in [(RADIUS, 0.1), (RADIUS, 0.19), (0.5 * RADIUS, 0.1)] {
        let error = sound(&two(radius, x), &options).expect_err("they intersect");
        assert_eq!(error.code, "E0785");
        assert!(error.message.contains("intersect, as seen at the node"), "{}", error.message);
    }
    let in_mm = sphere(1, 1e3 * RADIUS);
    let content = file(&in_mm, [results(&in_mm, [5, SPEED], frequency(0.5), radial)]);
    let error = sound(&content, &options).expect_err("longer than the wavelength");
    assert_eq!(error.code, "E0784");
    assert!(error.help.contains("dataset 164"), "{}", error.help);
}

#[test]
fn local_coordinate_systems_have_a_warning() {
    let mesh = sphere(1, RADIUS);
    let mut content = file(&mesh, [results(&mesh, [5, SPEED], frequency(0.5), radial)]);
    let options = SoundOptions { method: SoundMethod::EquivalentPower, ..SoundOptions::default() };
    assert!(sound(&content, &options).expect("global").warnings.is_empty());
    for dataset in &mut content.datasets {
        let UnvDataset::Nodes(nodes) = dataset else { continue };
        nodes.iter_mut().for_each(|node| node.attributes[1] = 3);
    }
    let warnings = sound(&content, &options).expect("solved").warnings;
    assert!(warnings[0].contains("displacement coordinate systems 3"), "{warnings:?}");
}
