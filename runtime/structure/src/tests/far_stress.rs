//! Stress in the fillets of teeth far from the load, from the condensed tables, against one mesh of
//! the whole ring.

use super::bodies::{COARSE, STEEL, ring_on, ring_source, sector_on};
use super::bore::Direct;
use crate::bore::{BoreMeans, RequestedMeans};
use crate::condense::Assembled;
use crate::elastic::prepare;
use crate::{BoreSupport, Chart, ElasticStructure, RingSource, SplitOptions, Structure, SurfaceLoad};
use calyx_fe::material::Plane;
use calyx_fe::{Constraints, PlaneModel, Solver, SparseVector};
use calyx_numerics::interrupt::Interrupt;
use std::f64::consts::TAU;

/// Returns the load of a mesh on its first tooth, rotated to another tooth.
pub(super) fn turned(model: &PlaneModel, load: &SparseVector, angle: f64) -> Vec<f64> {
    let (sin, cos) = angle.sin_cos();
    let full = load.to_full(model.dof_count());
    let nodes = &model.mesh.nodes;
    let mut there = vec![0.0; full.len()];
    for (node, force) in full.chunks_exact(2).enumerate().filter(|(_, force)| **force != [0.0, 0.0]) {
        let [x, y] = nodes[node];
        let [x, y] = [cos * x - sin * y, sin * x + cos * y];
        let distance = |other: &usize| (nodes[*other][0] - x).hypot(nodes[*other][1] - y);
        let other = (0..nodes.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap();
        assert!(distance(&other) < 1e-9, "the ring is made of equal sectors");
        there[2 * other] += cos * force[0] - sin * force[1];
        there[2 * other + 1] += sin * force[0] + cos * force[1];
    }
    there
}

/// Displacements by a load.
type Solution = Box<dyn Fn(&[f64]) -> Vec<f64>>;

/// Returns the displacements of a whole mesh.
fn solution(whole: &PlaneModel, support: BoreSupport) -> Solution {
    let (equations, bore) = (Assembled::plane(whole), whole.mesh.chain("bore").unwrap());
    let Some(wanted) = RequestedMeans::for_ring(support) else {
        let mut fixed = Constraints::new();
        for dof in equations.dofs_of(&whole.mesh.chain_nodes(bore)) {
            fixed.prescribe(dof, 0.0);
        }
        let solver = Solver::new(&equations.stiffness, fixed).unwrap();
        return Box::new(move |load| solver.solve_one(load).unwrap());
    };
    let means = BoreMeans::plane(whole, bore, wanted, &Interrupt::never()).unwrap().unwrap();
    let direct = Direct::new(&equations, &whole.rigid_body_modes(), &means.forms);
    Box::new(move |load| direct.solve(load).0)
}

/// Compares the stress of some teeth with the whole mesh. On a compliant bore the whole ring
/// becomes oval, which stresses fillets far from the load; on a rigid bore the load also displaces
/// distant teeth as a rigid body. Loads are at the nodes of the tables, where splines are exact.
/// Three teeth on either side have tables; the others are coupled through their cuts.
fn agrees_with_the_whole_mesh(support: BoreSupport, teeth: u32, bore: f64, tested: &[u32]) {
    let (model, surfaces) = sector_on((teeth, bore), 1.0, COARSE);
    let (options, never) = (SplitOptions { samples: 8, ..SplitOptions::default() }, Interrupt::never());
    let source = RingSource { support, ..ring_source(teeth) };
    let structure = ElasticStructure::ring(&model, &source, &surfaces, &options, &never).unwrap();

    let whole = PlaneModel::new(ring_on((teeth, bore), COARSE), STEEL, Plane::Strain);
    let solve = solution(&whole, support);
    let prepared = prepare(&whole, &surfaces, &options, &never).unwrap();
    let (flank, sample) = (1, 5);
    let (load, s) = (&prepared[flank].loads[0][sample], prepared[flank].surface.spline.nodes()[sample]);

    let least = if support == BoreSupport::Rigid { 1e-8 } else { 1e-5 };
    let mut largest = 0.0_f64;
    for &tooth in tested {
        let angle = TAU * f64::from(tooth) / f64::from(teeth);
        let displacement = solve(&turned(&whole, load, angle));
        let loads = [SurfaceLoad { chart: Chart { tooth, surface: flank as u32 }, s, force: 1.0 }];
        if tooth == 0 {
            let own = prepared.iter().flat_map(|prepared| &prepared.stress_rows);
            largest = own.fold(0.0, |most, row| most.max(row.dot(&displacement).abs()));
        }
        for (surface, prepared) in prepared.iter().enumerate() {
            let found = structure.stresses(0, surface as u32, &loads);
            assert!(!found.is_empty() && found.len() == prepared.stress_rows.len());
            for ((place, stress), row) in found.iter().zip(&prepared.stress_rows) {
                let expected = row.dot(&displacement);
                let error = (stress - expected).abs() / largest;
                assert!(
                    error < 1e-7,
                    "{teeth}, load on tooth {tooth}, {place:?}: {stress:e} {expected:e} ({error:.1e})"
                );
            }
            // The stress is large enough for a comparison.
            let far = found.iter().fold(0.0_f64, |most, (_, stress)| most.max(stress.abs()));
            assert!(far > least * largest, "tooth {tooth}: {far:e} {largest:e}");
        }
    }
}

/// From the loaded tooth to the opposite one, and beyond.
#[test]
fn stress_on_teeth_far_from_the_load_is_that_of_the_whole_mesh() {
    let free = BoreSupport::Means { harmonics: None, degree: 0 };
    agrees_with_the_whole_mesh(free, 12, 0.75, &[0, 3, 4, 6, 8]);
    // A rim with a thickness of a fifteenth of its radius, less than half a pitch.
    agrees_with_the_whole_mesh(free, 40, 0.84, &[0, 4, 7, 20, 31]);
    agrees_with_the_whole_mesh(BoreSupport::Rigid, 12, 0.1, &[0, 3, 4, 6, 8]);
}
