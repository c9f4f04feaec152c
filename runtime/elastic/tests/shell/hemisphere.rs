//! Hemisphere of the report's table 2.6: membrane forces and bending moments at a clamped edge.

use super::support::{DirectorMesh, Model, assert_close, material, places};
use calyx_elastic::shell::{DirectorNode, DirectorShape, Integration};
use nalgebra::Matrix3;

const RADIUS: f64 = 10.0;
const THICKNESS: f64 = 0.1;
const PRESSURE: f64 = 100.0;

/// Width of the sector around the axis.
const SECTOR: f64 = 0.05;

/// Unit vectors of increasing polar angle and azimuth, and outwards.
fn axes(polar: f64, azimuth: f64) -> Matrix3<f64> {
    let ((s, c), (t, d)) = (polar.sin_cos(), azimuth.sin_cos());
    Matrix3::new(c * d, -t, s * d, c * t, d, s * t, -s, 0.0, c)
}

/// Sector of cubic elements between polar angles in degrees: a triangle at the pole, then
/// quadrilaterals.
fn sector(angles: &[f64]) -> (DirectorMesh, Vec<[f64; 2]>) {
    let (mut keys, mut elements) = (Vec::<[f64; 2]>::new(), Vec::new());
    let mut number = |at: [f64; 2]| {
        let near = |key: &[f64; 2]| (key[0] - at[0]).abs() + (key[1] - at[1]).abs() < 1e-9;
        keys.iter().position(near).unwrap_or_else(|| {
            keys.push(at);
            keys.len() - 1
        })
    };
    for (index, pair) in angles.windows(2).enumerate() {
        let [from, to] = [pair[0].to_radians(), pair[1].to_radians()];
        let shape = if index == 0 { DirectorShape::Triangle(3) } else { DirectorShape::Quadrilateral(3) };
        let place = |[xi, eta]: [f64; 2]| match shape {
            DirectorShape::Triangle(_) => {
                let sum = xi + eta;
                [to * sum, if sum > 0.0 { SECTOR * eta / sum } else { 0.0 }]
            }
            DirectorShape::Quadrilateral(_) => {
                [from + 0.5 * (to - from) * (1.0 + xi), 0.5 * SECTOR * (1.0 + eta)]
            }
        };
        elements.push((shape, places(shape).into_iter().map(|at| number(place(at))).collect()));
    }
    let node = |&[polar, azimuth]: &[f64; 2]| {
        let outwards = axes(polar, azimuth).column(2).into_owned();
        DirectorNode {
            position: (outwards * RADIUS).into(),
            half_thickness: (outwards * (0.5 * THICKNESS)).into(),
            offset: 0.0,
        }
    };
    let nodes = keys.iter().map(node).collect();
    (DirectorMesh { nodes, parameters: keys.clone(), elements }, keys)
}

/// Results of the sector: radial displacements at 84 degrees and the pole, moments per length at
/// angles.
struct Found {
    at_84: f64,
    at_pole: f64,
    moments: Vec<f64>,
}

fn solve(angles: &[f64], integration: Integration, moments: &[f64]) -> Found {
    let steel = material(30e6, 0.3, 0.0);
    let (mesh, places) = sector(angles);
    let mut model = Model::new(mesh.nodes.len());
    for (node, &[polar, azimuth]) in places.iter().enumerate() {
        model.axes[node] = axes(polar, azimuth);
        model.fix(node, &[5]);
        let edge = (polar.to_degrees() - 90.0).abs() < 1e-9;
        let pole = polar < 1e-9;
        let cut = !(1e-9..=SECTOR - 1e-9).contains(&azimuth);
        if edge {
            model.fix(node, &[0, 1, 2, 3, 4]);
        } else if pole {
            model.fix(node, &[0, 1, 3, 4]);
        } else if cut {
            model.fix(node, &[1, 4]);
        }
    }
    mesh.each(&steel, integration, |nodes, element| {
        model.add_stiffness(nodes, element.stiffness().unwrap());
        model.add_load(nodes, &element.pressure_load(0.0, -PRESSURE).unwrap());
    });
    let found = model.solve();
    let radial = |angle: f64| {
        let near = |place: &[f64; 2]| (place[0].to_degrees() - angle).abs() < 1e-6;
        found[6 * places.iter().position(near).unwrap() + 2]
    };
    // The moment at a mesh line is the generalized force there of the elements nearer to the pole.
    let moment = |&angle: &f64| {
        let mut part = Model::new(mesh.nodes.len());
        part.axes = model.axes.clone();
        let mut inner = angles.windows(2).map(|pair| pair[1] <= angle + 1e-9);
        mesh.each(&steel, integration, |nodes, element| {
            if inner.next().unwrap() {
                part.add_stiffness(nodes, element.stiffness().unwrap());
                part.add_load(nodes, &element.pressure_load(0.0, -PRESSURE).unwrap());
            }
        });
        let forces = part.forces(&found);
        let line = (0..places.len()).filter(|node| (places[*node][0].to_degrees() - angle).abs() < 1e-6);
        let total = line.map(|node| forces[6 * node + 3] - part.load[6 * node + 3]).sum::<f64>();
        total * 0.5 * THICKNESS / (RADIUS * angle.to_radians().sin() * SECTOR)
    };
    Found { at_84: radial(84.0), at_pole: radial(0.0), moments: moments.iter().map(moment).collect() }
}

/// Converged solution of Reissner's shell theory with shear factor 5/6.
const AT_84: f64 = 0.0008174832487;
const AT_POLE: f64 = 0.001284023297;
const MOMENTS: [(f64, f64); 3] = [(90.0, -10.517663), (84.0, 2.056843), (88.0, -3.134887)];

#[test]
fn the_clamped_hemisphere_agrees_with_the_shell_solution() {
    let angles =
        [0.0, 10.0, 25.0, 40.0, 52.0, 62.0, 70.0, 76.0, 80.0, 82.0, 84.0, 86.0, 87.0, 88.0, 89.0, 89.5, 90.0];
    for integration in [Integration::Full, Integration::SelectivelyReduced] {
        let found = solve(&angles, integration, &MOMENTS.map(|(angle, _)| angle));
        println!("{integration:?}: {:.2e} {:.2e}", found.at_84 / AT_84 - 1.0, found.at_pole / AT_POLE - 1.0);
        println!("{:?}", found.moments);
        assert_close(found.at_84, AT_84, 2e-3, "displacement at 84 degrees");
        assert_close(found.at_pole, AT_POLE, 2e-3, "displacement of the pole");
        for (found, (angle, moment)) in found.moments.into_iter().zip(MOMENTS) {
            assert_close(found, moment, 2e-3, &format!("{integration:?} moment at {angle} degrees"));
        }
    }
}
