//! Crossed helical gears: meshes on general axes whose contact is known in closed form. Involute
//! helicoids are conjugate at any shaft angle and centre distance, and touch at points.

mod hertz;
mod pair;

use crate::common::built;
use calyx_runtime::observables::{Observe, TransmissionError};
use calyx_runtime::scene::{BodyId, Fidelity, PairId, StructureOptions, Template};
use calyx_runtime::step::{ContactPatch, StepResult};
use calyx_runtime::vec3::{dot, length};
use hertz::Ellipse;
use pair::{Options, TEETH, modulus, relative_radii};

const FIRST: BodyId = BodyId(0);
const SECOND: BodyId = BodyId(1);
const MESH: PairId = PairId(0);
const MEDIUM: Fidelity = Fidelity::Solid(Template::Medium);

fn pairs() -> Vec<Options> {
    let plain = Options::default();
    vec![
        plain,
        Options { apart: 0.01, ..plain },
        Options { inclined: 0.03, apart: 0.01, ..plain },
        Options { helix: [0.2, 0.3], ..plain },
        Options { helix: [-0.5, -0.6], apart: 0.02, inclined: -0.02, ..plain },
        Options { torque: -20.0, ..plain },
    ]
}

#[test]
fn crossed_helicoids_are_conjugate() {
    for (index, options) in pairs().into_iter().enumerate() {
        let (scene, mesh) = options.scene();
        // Without load, elastic bodies touch like rigid ones.
        let levels = if index == 0 { vec![Fidelity::Rigid, MEDIUM] } else { vec![Fidelity::Rigid] };
        for fidelity in levels {
            let system = built(&scene, fidelity, StructureOptions::default());
            for part in [0.13, 0.77] {
                let step = system.touch(mesh.start + part * mesh.period).expect("they touch");
                let error = system.value(&step, &TransmissionError(MESH)).value;
                assert!(error.abs() < 1e-9, "{error:e} at {part}, helix {:?}", options.helix);
            }
        }
    }
}

/// The common normal touches both base cylinders at their base helix angles.
#[test]
fn the_normal_of_the_first_contact_touches_both_base_cylinders() {
    for options in pairs() {
        let (_, mesh) = options.scene();
        for member in [0, 1] {
            let arm = options.normal_arm(member);
            assert!((mesh.base_radii[member] / arm - 1.0).abs() < 1e-9, "{:?} {arm}", mesh.base_radii);
        }
    }
}

/// Whether a tip edge carries load, which turns the common normal.
fn on_edge(step: &StepResult) -> bool {
    let loaded = |patch: &ContactPatch| {
        let cells = patch.solid().map(|grid| &grid.cells[..]).unwrap_or_default();
        cells.iter().zip(&patch.forces).any(|(cell, force)| cell.edge && *force > 0.0)
    };
    step.patches.iter().any(loaded)
}

#[test]
fn forces_are_those_of_the_common_normal() {
    for options in pairs() {
        let options = Options { torque: 0.2 * options.torque, ..options };
        let (scene, mesh) = options.scene();
        let system = built(&scene, MEDIUM, StructureOptions::default());
        let normal = mesh.first_contact.expect("general axes").normal;
        let mut compared = 0;
        for part in [0.1, 0.35, 0.6] {
            let step = system.solve(mesh.start + part * mesh.period).expect("it can be solved");
            let force = system.contact_force(&step, FIRST);
            let other = system.contact_force(&step, SECOND);
            let size = options.torque.abs() / options.normal_arm(0);
            // Forces and moments of both bodies are in equilibrium about the origin of ground.
            let distance = options.distance();
            let moments = [
                force[3] + other[3],
                force[4] + other[4] - distance * other[2],
                force[5] + other[5] + distance * other[1],
            ];
            let forces = [0, 1, 2].map(|k: usize| force[k] + other[k]);
            assert!(length(forces) < 1e-9 * size && length(moments) < 1e-9 * size * distance);
            if on_edge(&step) {
                continue;
            }
            compared += 1;
            let error = [0, 1, 2].map(|k: usize| force[k] / size + normal[k]);
            assert!(length(error) < 3e-4, "{error:?}");
            let torque = dot([other[3], other[4], other[5]], options.second_axis());
            let ratio = f64::from(TEETH[1]) / f64::from(TEETH[0]);
            let error = torque / (options.torque * ratio) + 1.0;
            assert!(error.abs() < 3e-5, "{error:e}");
        }
        assert!(compared > 0, "{:?}", options.helix);
    }
}

/// Both shafts exchange the same work over a mesh cycle.
#[test]
fn the_work_at_both_shafts_is_equal() {
    let options = Options { torque: 2.0, ..Options::default() };
    let (scene, mesh) = options.scene();
    let system = built(&scene, MEDIUM, StructureOptions::default());
    let steps = 12;
    let mut mean = 0.0;
    for index in 0..steps {
        let part = (f64::from(index) + 0.5) / f64::from(steps);
        let step = system.solve(mesh.start + part * mesh.period).expect("it can be solved");
        let [.., x, y, z] = system.contact_force(&step, SECOND);
        mean += dot([x, y, z], options.second_axis()) / f64::from(steps);
    }
    let ratio = f64::from(TEETH[1]) / f64::from(TEETH[0]);
    let error = mean / (options.torque * ratio) + 1.0;
    // The neglected slopes of the flanks within a patch are of second order.
    assert!(error.abs() < 2e-5, "{error:e}");
}

/// State of the pair at a position.
struct State {
    /// Torque on the second gear over that of the ratio of the teeth, minus 1.
    torque_excess: f64,
    /// Strain energy of the contact problem, J.
    energy: f64,
    /// Transmission error, rad.
    transmission_error: f64,
}

/// The powers of both shafts differ by the rate of the strain energy: with the angle `a` of the
/// first gear, the ratio `i` of the teeth, the transmission error `e` and the energy `U`, the
/// torques obey `T2 / (i T1) = 1 + i de/da - dU/(T1 da)`. The error is that of the neglected slopes
/// across a patch, of second order in its half-width, so that it decreases with the power 2/3 of
/// the torque.
#[test]
fn powers_and_strain_energy_are_balanced() {
    for (torque, bound) in [(2.0, 6e-6), (0.1, 1e-6)] {
        let options = Options { torque, ..Options::default() };
        let (scene, mesh) = options.scene();
        let system = built(&scene, MEDIUM, StructureOptions::default());
        let ratio = f64::from(TEETH[1]) / f64::from(TEETH[0]);
        let state = |part: f64| {
            let step = system.solve(mesh.start + part * mesh.period).expect("it can be solved");
            let [.., x, y, z] = system.contact_force(&step, SECOND);
            let transferred = -dot([x, y, z], options.second_axis());
            let forces: Vec<f64> = step.patches.iter().flat_map(|patch| patch.forces.clone()).collect();
            let rows = step.problem.compliance.chunks(forces.len());
            let deflection = |row: &[f64]| row.iter().zip(&forces).map(|(c, force)| c * force).sum::<f64>();
            State {
                torque_excess: transferred / (torque * ratio) - 1.0,
                energy: rows.zip(&forces).map(|(row, force)| 0.5 * force * deflection(row)).sum(),
                transmission_error: system.value(&step, &TransmissionError(MESH)).value,
            }
        };
        for (part, step) in [(0.15, 0.01), (0.5, 0.01)] {
            let [before, middle, after] = [part - step, part, part + step].map(state);
            let angle = 2.0 * step * std::f64::consts::TAU / f64::from(TEETH[0]);
            let lag = ratio * (after.transmission_error - before.transmission_error) / angle;
            let stored = (after.energy - before.energy) / (torque * angle);
            let error = middle.torque_excess - lag + stored;
            assert!(error.abs() < bound, "{torque} N m at {part}: {error:e}");
        }
    }
}

/// Returns the deviations of the peak pressures from Hertz's, for every position, torque and pair.
fn deviations_from_hertz(half_cells: [usize; 2]) -> Vec<f64> {
    let mut deviations = Vec::new();
    for helix in [[0.9, 0.67], [0.3, 0.25]] {
        for torque in [0.5, 20.0] {
            let options = Options { helix, torque, half_cells, ..Options::default() };
            let (scene, mesh) = options.scene();
            let system = built(&scene, MEDIUM, StructureOptions::default());
            for part in [0.3, 0.5] {
                let step = system.solve(mesh.start + part * mesh.period).expect("it can be solved");
                for patch in step.patches.iter().filter(|patch| patch.force() > 0.0) {
                    let grid = patch.solid().expect("it is solid");
                    let radii = relative_radii(&options, grid.frame.point, grid.frame.normal);
                    let ellipse = Ellipse::new(radii, 0.5 * modulus(), patch.force());
                    let peak = patch.peak().expect("it is loaded").pressure;
                    deviations.push(peak / ellipse.peak - 1.0);
                }
            }
        }
    }
    deviations
}

#[test]
fn the_pressure_is_hertz_s() {
    let largest = |half_cells| {
        let deviations = deviations_from_hertz(half_cells);
        println!("{half_cells:?}: {deviations:.5?}");
        deviations.into_iter().map(f64::abs).fold(0.0, f64::max)
    };
    let (usual, twice) = (largest([10, 8]), largest([20, 16]));
    assert!(usual < 4e-3 && twice < 0.5 * usual, "{usual} {twice}");
}
