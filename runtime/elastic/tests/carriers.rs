//! Generated planet carriers: mass, patch test, rigid motions, cyclic symmetry, wind-up against
//! beams between rigid plates, and convergence.

use calyx_elastic::assembly::System;
use calyx_elastic::attachment::{Attachment, Connection, Region, attach};
use calyx_elastic::carrier::{CarrierModel, CarrierShape, HUB, Webs, materials};
use calyx_elastic::condensation::static_condensation;
use calyx_elastic::import::mass_properties;
use calyx_elastic::{ElementKind, FixedComponents, Material, Resources, statics};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::{PI, TAU};

const E: f64 = 2.06e11;
const NU: f64 = 0.3;
const G: f64 = E / (2.0 * (1.0 + NU));

fn steel() -> Material {
    Material {
        youngs_modulus: E,
        poissons_ratio: NU,
        shear_modulus: G,
        density: 7850.0,
        structural_damping: 0.0,
    }
}

fn shape() -> CarrierShape {
    CarrierShape {
        planets: 3,
        pin_circle_diameter: 0.12,
        pin_diameter: 0.02,
        pin_bore: 0.006,
        outside_diameter: 0.18,
        bore_diameter: 0.05,
        thickness: vec![0.016, 0.012],
        gap: 0.04,
        hub_at_negative_z: true,
        webs: Some(Webs { inside_diameter: 0.1, outside_diameter: 0.17, angle: 0.5 }),
        element_size: 0.012,
    }
}

fn one_plate() -> CarrierShape {
    CarrierShape { thickness: vec![0.016], webs: None, ..shape() }
}

fn generated(shape: &CarrierShape) -> CarrierModel {
    shape.check().expect("a carrier");
    shape.model(&steel())
}

/// Stiffness between all pins and the hub, with plates of a multiple of the stiffness of the rest.
fn condensed(shape: &CarrierShape, plates: f64) -> DMatrix<f64> {
    let CarrierModel { mut model, mut pins } = generated(shape);
    let material = &mut model.materials[materials::PLATES];
    material.youngs_modulus *= plates;
    material.shear_modulus *= plates;
    let hub = Attachment {
        name: "attached hub".into(),
        position: Some([0.0; 3]),
        region: Region::Set(HUB.into()),
        connection: Connection::Rigid,
    };
    pins.push(attach(&mut model, &hub).expect("attached")[0]);
    let resources = Resources::default();
    let system = System::new(&model, &resources).expect("valid");
    let body = static_condensation(&system, &pins, &[], &resources).expect("condensed");
    assert_eq!(body.components.len(), 6 * pins.len());
    DMatrix::from_fn(6 * pins.len(), 6 * pins.len(), |i, j| body.stiffness[(i, j)])
}

/// Motions of the pins with the hub fixed, under tangential unit forces on all pins.
fn wound_up(shape: &CarrierShape, plates: f64) -> Vec<[f64; 6]> {
    let whole = condensed(shape, plates);
    let size = 6 * shape.planets;
    let mut load = DVector::zeros(size);
    for pin in 0..shape.planets {
        let angle = TAU * pin as f64 / shape.planets as f64;
        load[6 * pin] = -angle.sin();
        load[6 * pin + 1] = angle.cos();
    }
    let own = whole.view((0, 0), (size, size)).clone_owned();
    let motions = own.cholesky().expect("supported").solve(&load);
    let along = |pin: usize| {
        let (sin, cos) = (TAU * pin as f64 / shape.planets as f64).sin_cos();
        let part = |first: usize| {
            let [x, y, z] = [0, 1, 2].map(|k| motions[6 * pin + first + k]);
            [cos * x + sin * y, cos * y - sin * x, z]
        };
        let ([a, b, c], [d, e, f]) = (part(0), part(3));
        [a, b, c, d, e, f]
    };
    (0..shape.planets).map(along).collect()
}

fn close(what: &str, found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance * expected.abs(), "{what}: {found} instead of {expected}");
}

/// Circles are approximated by parabolas, so the volume converges with the fourth power of the
/// size.
#[test]
fn a_carrier_has_the_mass_of_its_parts() {
    let shape = shape();
    let [outside, bore, pin, hole] =
        [0.18, 0.05, 0.02, 0.006].map(|diameter: f64| 0.25 * PI * diameter * diameter);
    let plates = (outside - bore - 3.0 * pin) * 0.028;
    let webs = 3.0 * 0.5 / TAU * 0.25 * PI * (0.17_f64.powi(2) - 0.1_f64.powi(2)) * 0.04;
    let pins = 3.0 * (pin - hole) * (0.028 + 0.04);
    let expected = 7850.0 * (plates + webs + pins);
    let error = |size: f64| {
        let model = generated(&CarrierShape { element_size: size, ..shape.clone() }).model;
        let found = mass_properties(&model);
        assert!(found.centre[0].abs() < 1e-12 && found.centre[1].abs() < 1e-12, "{:?}", found.centre);
        (found.mass / expected - 1.0).abs()
    };
    let [coarse, fine] = [0.016, 0.008].map(error);
    assert!(coarse < 2e-4 && fine < coarse / 6.0, "{coarse} {fine}");
}

#[test]
fn a_linear_displacement_is_exact_in_the_mesh() {
    for shape in [shape(), one_plate()] {
        let mut model = generated(&shape).model;
        // Solids alone: the patch test is about their mesh.
        model.constraints.clear();
        model.elements.retain(|element| matches!(element.kind, ElementKind::Solid(_)));
        let gradient = [[1.0, 0.3, -0.2], [0.5, -0.7, 0.4], [0.1, 0.6, 0.9]];
        let field = |at: [f64; 3]| gradient.map(|row| 1e-3 * (0..3).map(|k| row[k] * at[k]).sum::<f64>());
        // Faces of one element only are the boundary.
        let mut faces = std::collections::BTreeMap::<Vec<usize>, (Vec<usize>, usize)>::new();
        const FACES: [[usize; 8]; 6] = [
            [0, 1, 2, 3, 8, 9, 10, 11],
            [4, 5, 6, 7, 16, 17, 18, 19],
            [0, 1, 5, 4, 8, 13, 16, 12],
            [1, 2, 6, 5, 9, 14, 17, 13],
            [2, 3, 7, 6, 10, 15, 18, 14],
            [3, 0, 4, 7, 11, 12, 19, 15],
        ];
        for element in &model.elements {
            for face in FACES {
                let nodes: Vec<usize> = face.iter().map(|&node| element.nodes[node]).collect();
                let mut key = nodes.clone();
                key.sort_unstable();
                faces.entry(key).or_insert((nodes, 0)).1 += 1;
            }
        }
        // The mesh is conforming: no face of three elements.
        assert!(faces.values().all(|(_, count)| *count <= 2));
        let mut outside: Vec<usize> =
            faces.into_values().filter(|(_, count)| *count == 1).flat_map(|(nodes, _)| nodes).collect();
        outside.sort_unstable();
        outside.dedup();
        for &node in &outside {
            for (component, value) in field(model.nodes[node].position).into_iter().enumerate() {
                let components = std::array::from_fn(|k| k == component);
                model.fixed.push(FixedComponents { node, components, value });
            }
        }
        // Nodes of pins and their masses have no elements now.
        let resources = Resources::default();
        let system = System::new(&model, &resources).expect("valid");
        let solution = &statics::solve(&system, &[Vec::new()], &resources).expect("supported")[0];
        let used: std::collections::BTreeSet<usize> =
            model.elements.iter().flat_map(|element| element.nodes.iter().copied()).collect();
        assert!(used.len() > outside.len());
        for node in used {
            let expected = field(model.nodes[node].position);
            for component in 0..3 {
                let error = (solution.displacements[node][component] - expected[component]).abs();
                assert!(error < 1e-14, "{node}: {error:e}");
            }
        }
    }
}

#[test]
fn rigid_motions_cause_no_forces_and_sectors_are_equal() {
    for shape in [shape(), one_plate(), CarrierShape { planets: 4, ..shape() }] {
        let stiffness = condensed(&shape, 1.0);
        let size = stiffness.nrows();
        let values = stiffness.clone().symmetric_eigenvalues();
        let zeros = values.iter().filter(|value| value.abs() < 1e-9 * values.amax()).count();
        assert_eq!(zeros, 6, "{values}");
        // Rotation by one planet: pins take the place of the next ones, the hub stays.
        let (sin, cos) = (TAU / shape.planets as f64).sin_cos();
        let rotation = DMatrix::from_row_slice(3, 3, &[cos, -sin, 0.0, sin, cos, 0.0, 0.0, 0.0, 1.0]);
        let mut step = DMatrix::zeros(size, size);
        for body in 0..=shape.planets {
            let next = if body == shape.planets { body } else { (body + 1) % shape.planets };
            for part in 0..2 {
                step.view_mut((6 * next + 3 * part, 6 * body + 3 * part), (3, 3)).copy_from(&rotation);
            }
        }
        let rotated = &step * &stiffness * step.transpose();
        for row in 0..size {
            for column in 0..size {
                let scale = (stiffness[(row, row)] * stiffness[(column, column)]).sqrt();
                let difference = (rotated[(row, column)] - stiffness[(row, column)]).abs();
                assert!(difference < 1e-9 * scale, "{row} {column}: {:e}", difference / scale);
            }
        }
    }
}

/// Stiff plates: webs and pins are beams that connect both plates, and each plate carries half of
/// the load on a pin. The end of a web, where its section cannot contract, makes it stiffer than a
/// beam; this difference decreases with its slenderness.
#[test]
fn the_wind_up_is_that_of_beams_between_rigid_plates() {
    let error = |gap: f64| {
        let webs = Webs { inside_diameter: 0.156, outside_diameter: 0.17, angle: 0.16 };
        let shape = CarrierShape {
            gap,
            webs: Some(webs),
            bore_diameter: 0.06,
            element_size: 0.01,
            thickness: vec![0.016; 2],
            ..shape()
        };
        let found = wound_up(&shape, 1e5);
        let (outer, inner, half) = (0.085_f64, 0.078_f64, 0.08_f64);
        // A sector of a ring: area, distance of the centroid, second moment across the radius.
        let area = half * (outer * outer - inner * inner);
        let centroid = 2.0 / 3.0 * half.sin() * (outer.powi(3) - inner.powi(3)) / area;
        let second = 0.25 * (outer.powi(4) - inner.powi(4)) * (half - half.sin() * half.cos());
        let (a, b) = (2.0 * half * 0.0815, outer - inner);
        // Torsion constant of a rectangle with a > b.
        let ratio = b / a;
        let torsion = a * b.powi(3) * (1.0 / 3.0 - 0.21 * ratio * (1.0 - ratio.powi(4) / 12.0));
        let swayed = |second: f64, area: f64, shear: f64| {
            1.0 / (gap.powi(3) / (12.0 * E * second) + gap / (shear * G * area))
        };
        let shear = 10.0 * (1.0 + NU) / (12.0 + 11.0 * NU);
        let web = swayed(second, area, shear) * centroid * centroid + G * torsion / gap;
        let pin_second = PI / 64.0 * (0.02_f64.powi(4) - 0.006_f64.powi(4));
        let pin_area = 0.25 * PI * (0.02_f64.powi(2) - 0.006_f64.powi(2));
        let m2 = 0.3_f64 * 0.3;
        let kappa = 6.0 * (1.0 + NU) * (1.0 + m2).powi(2)
            / ((7.0 + 6.0 * NU) * (1.0 + m2).powi(2) + (20.0 + 12.0 * NU) * m2);
        let pin = swayed(pin_second, pin_area, kappa) * 0.06 * 0.06 + 2.0 * G * pin_second / gap;
        let angle = 3.0 * 0.06 / 2.0 / (3.0 * (web + pin));
        let middle = gap.powi(3) / (192.0 * E * pin_second) + gap / (4.0 * kappa * G * pin_area);
        // Slope of the pin in its middle: that of a clamped beam whose ends sway.
        let phi = 12.0 * E * pin_second / (kappa * G * pin_area * gap * gap);
        let slope = 1.5 * 0.06 * angle / gap / (1.0 + phi);
        for pin in &found {
            close("equal pins", pin[1], found[0][1], 1e-6);
        }
        let deflection = found[0][1] - middle;
        let errors = [deflection / (0.5 * 0.06 * angle) - 1.0, found[0][3].abs() / slope - 1.0];
        println!("gap {gap}: {errors:?}");
        errors
    };
    let [short, long] = [0.05, 0.1].map(error);
    for k in 0..2 {
        assert!(long[k].abs() < 0.02, "{short:?} {long:?}");
        assert!(long[k].abs() < 0.7 * short[k].abs(), "{short:?} {long:?}");
    }
}

/// A pin on a rigid plate is a cantilever from its face to the middle of the planet.
#[test]
fn a_pin_on_one_stiff_plate_is_a_cantilever() {
    let found = wound_up(&one_plate(), 1e6);
    let (length, m2) = (0.02_f64, 0.3_f64 * 0.3);
    let second = PI / 64.0 * (0.02_f64.powi(4) - 0.006_f64.powi(4));
    let area = 0.25 * PI * (0.02_f64.powi(2) - 0.006_f64.powi(2));
    let kappa = 6.0 * (1.0 + NU) * (1.0 + m2).powi(2)
        / ((7.0 + 6.0 * NU) * (1.0 + m2).powi(2) + (20.0 + 12.0 * NU) * m2);
    for pin in found {
        close("deflection", pin[1], length.powi(3) / (3.0 * E * second) + length / (kappa * G * area), 1e-4);
        close("slope", pin[3].abs(), length * length / (2.0 * E * second), 1e-4);
    }
}

/// The compliance grows with refinement, by less each time.
#[test]
fn the_wind_up_converges() {
    let of = |size: f64| wound_up(&CarrierShape { element_size: size, ..shape() }, 1.0)[0][1];
    let [coarse, middle, fine] = [0.024, 0.012, 0.006].map(of);
    println!("{coarse:e} {middle:e} {fine:e}");
    assert!(coarse < middle && middle < fine, "{coarse} {middle} {fine}");
    assert!(
        fine - middle < 0.6 * (middle - coarse) && fine / middle - 1.0 < 0.01,
        "{coarse} {middle} {fine}"
    );
}

#[test]
fn impossible_carriers_are_rejected() {
    let webs = shape().webs.expect("webs");
    let cases = [
        (CarrierShape { planets: 1, ..shape() }, "cannot have 1 planets"),
        (CarrierShape { pin_diameter: -0.01, ..shape() }, "the pins cannot measure -10 mm"),
        (CarrierShape { pin_bore: 0.02, ..shape() }, "leaves no wall in the pins"),
        (CarrierShape { bore_diameter: 0.099, ..shape() }, "the pins reach the bore of 99 mm"),
        (CarrierShape { outside_diameter: 0.141, ..shape() }, "the pins reach the outside diameter"),
        (CarrierShape { planets: 12, ..shape() }, "overlap"),
        (CarrierShape { webs: None, ..shape() }, "two plates have no webs"),
        (CarrierShape { thickness: vec![0.01], ..shape() }, "webs need two plates"),
        (CarrierShape { thickness: vec![0.01; 3], ..shape() }, "cannot have 3 plates"),
        (CarrierShape { element_size: f64::NAN, ..shape() }, "the size of the elements"),
        (CarrierShape { element_size: 1e-9, ..shape() }, "too small"),
        (CarrierShape { element_size: 1e-3, ..shape() }, "more than 100000"),
        (CarrierShape { webs: Some(Webs { angle: -0.1, ..webs }), ..shape() }, "cannot have an angle"),
        (
            CarrierShape { webs: Some(Webs { outside_diameter: 0.2, ..webs }), ..shape() },
            "are not on the plates",
        ),
    ];
    for (shape, message) in cases {
        let (_, error) = shape.check().expect_err(message);
        assert!(error.message.contains(message), "{message}: {}", error.message);
        assert!(!error.help.is_empty());
    }
}
