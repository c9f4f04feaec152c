//! Condensed and repeated sectors against the whole ring in one mesh.

use super::bodies::{COARSE, STEEL, ring_source, toothed_ring, toothed_sector};
use crate::condense::{Assembled, Support, condense, match_cuts};
use crate::ring::RingFlexibility;
use crate::{Chart, ElasticStructure, SplitOptions, Structure, StructureError};
use calyx_fe::material::Plane;
use calyx_fe::{Constraints, PlaneModel, Solver, SparseVector};
use calyx_numerics::interrupt::Interrupt;
use std::f64::consts::TAU;

/// Returns the load vector of a unit force at the node nearest to a point, rotated by `angle`.
fn force(model: &PlaneModel, point: [f64; 2], direction: [f64; 2], angle: f64) -> SparseVector {
    let (sin, cos) = angle.sin_cos();
    let turn = |[x, y]: [f64; 2]| [cos * x - sin * y, sin * x + cos * y];
    let ([x, y], [fx, fy]) = (turn(point), turn(direction));
    let distance = |node: usize| (model.mesh.nodes[node][0] - x).hypot(model.mesh.nodes[node][1] - y);
    let nearest = (0..model.mesh.nodes.len()).min_by(|&a, &b| distance(a).total_cmp(&distance(b))).unwrap();
    [(2 * nearest, fx), (2 * nearest + 1, fy)].into_iter().collect()
}

#[test]
fn condensed_sectors_agree_with_the_whole_mesh() {
    let teeth = 7;
    let (sector, _) = toothed_sector(teeth, 1.0, COARSE);
    let nodes = |name: &str| sector.mesh.chain_nodes(sector.mesh.chain(name).unwrap());
    let angle = TAU / f64::from(teeth);
    let bore = nodes("bore");
    let assembled = Assembled::plane(&sector);
    let cuts =
        match_cuts(&assembled.positions, &nodes("cut_first"), &nodes("cut_last"), &bore, angle).unwrap();
    let points = [([1.1, 0.2], [0.3, -1.0]), ([1.3, -0.1], [-0.5, 0.7]), ([0.85, 0.3], [1.0, 0.2])];
    let loads: Vec<_> = points.iter().map(|&(at, along)| force(&sector, at, along, 0.0)).collect();
    let condensed = condense(
        &assembled,
        &Support::Constrained(&assembled.dofs_of(&bore)),
        Some(&cuts),
        &loads,
        &loads,
        &Interrupt::never(),
    )
    .unwrap();
    let ring =
        RingFlexibility::new(condensed.stiffness.as_ref().unwrap(), teeth, 3, &Interrupt::never()).unwrap();

    let whole = PlaneModel::new(toothed_ring(teeth, COARSE), STEEL, Plane::Strain);
    let mut constrained = Constraints::new();
    for (node, [x, y]) in whole.mesh.nodes.iter().enumerate() {
        if (x.hypot(*y) - 0.75).abs() < 1e-9 {
            constrained.fix_node(node);
        }
    }
    // Nodes of the arcs' quadratic edges lie on the circle.
    let solver = Solver::new(&whole.stiffness(), constrained).unwrap();
    for (column, &(at, along)) in points.iter().enumerate() {
        let displacement =
            solver.solve_one(&force(&whole, at, along, 0.0).to_full(whole.dof_count())).unwrap();
        let scale = condensed.own[(column, column)];
        for offset in 0..=3 {
            for (row, &(observed, direction)) in points.iter().enumerate() {
                let direct = force(&whole, observed, direction, angle * f64::from(offset)).dot(&displacement);
                let through = condensed.on_cuts.col(row).transpose()
                    * (ring.at(offset) * condensed.on_cuts.col(column));
                let own = if offset == 0 { condensed.own[(row, column)] } else { 0.0 };
                let by_rows =
                    condensed.rows_cuts.row(row) * (ring.at(offset) * condensed.on_cuts.col(column));
                let error = (through + own - direct).abs() / scale;
                assert!(error < 1e-10, "offset {offset}: {error:.1e}");
                let own = if offset == 0 { condensed.rows_own[(row, column)] } else { 0.0 };
                assert!((by_rows + own - direct).abs() < 1e-10 * scale);
            }
        }
    }
}

#[test]
fn exchanging_load_and_observer_keeps_every_bit() {
    for teeth in [6_u32, 13] {
        let (model, surfaces) = toothed_sector(teeth, 1.0, COARSE);
        let structure = ElasticStructure::ring(
            &model,
            &ring_source(teeth),
            &surfaces,
            &SplitOptions::default(),
            &Interrupt::never(),
        )
        .unwrap();
        let length = structure.reference_length();
        let points: Vec<f64> = [0.9, 0.1, 0.33, 0.77, 1.02].map(|share| share * length).to_vec();
        let others: Vec<f64> = [0.2, 0.77, 0.5, 0.95].map(|share| share * length).to_vec();
        let charts = || (0..teeth).flat_map(|tooth| [0, 1].map(|surface| Chart { tooth, surface }));
        let (mut near, mut far) = (0.0_f64, 0.0_f64);
        for a in charts() {
            for b in charts() {
                let mut block = vec![0.0; 20];
                let mut exchanged = vec![0.0; 20];
                structure.add_compliance(a, &points, b, &others, &mut block);
                structure.add_compliance(b, &others, a, &points, &mut exchanged);
                for i in 0..5 {
                    for j in 0..4 {
                        assert_eq!(block[i * 4 + j].to_bits(), exchanged[j * 5 + i].to_bits(), "{a:?} {b:?}");
                    }
                }
                let size = block.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
                match (a.tooth + teeth - b.tooth) % teeth {
                    0 => {}
                    apart if apart == 1 || apart + 1 == teeth => near = near.max(size),
                    _ => far = far.max(size),
                }
            }
        }
        assert!(near > 0.0 && far > 0.0 && far <= near);
        // Rotating the ring only renumbers the sectors.
        let block = |a: u32, b: u32| {
            let mut block = vec![0.0; 20];
            let chart = |tooth| Chart { tooth: tooth % teeth, surface: 0 };
            structure.add_compliance(chart(a), &points, chart(b), &others, &mut block);
            block
        };
        for (from, to) in [(0, 1), (1, 0), (0, 2), (2, 0)] {
            assert_eq!(block(from, to), block(from + 3, to + 3));
        }
    }
}

#[test]
fn wrong_meshes_are_named() {
    let (model, surfaces) = toothed_sector(8, 1.0, COARSE);
    let options = SplitOptions::default();
    let ring = |ring, surfaces: &[_]| {
        ElasticStructure::ring(&model, &ring, surfaces, &options, &Interrupt::never()).err()
    };
    let cuts = ["cut_first", "cut_last"].map(String::from);
    assert_eq!(ring(ring_source(9), &surfaces), Some(StructureError::CutsDiffer { cuts }));
    let mut missing = surfaces.clone();
    missing[1].chain = "flank".into();
    assert_eq!(ring(ring_source(8), &missing), Some(StructureError::NoChain { chain: "flank".into() }));
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    let (model, surfaces) = toothed_sector(8, 1.0, COARSE);
    let block = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let structure = pool.install(|| {
            ElasticStructure::ring(
                &model,
                &ring_source(8),
                &surfaces,
                &SplitOptions::default(),
                &Interrupt::never(),
            )
            .unwrap()
        });
        let points: Vec<f64> = [0.1, 0.5, 0.9].map(|share| share * structure.reference_length()).to_vec();
        let mut block = vec![0.0; 9];
        let [observe, load] = [3, 2].map(|tooth| Chart { tooth, surface: 1 });
        structure.add_compliance(observe, &points, load, &points, &mut block);
        structure.add_compliance(load, &points, load, &points, &mut block);
        block.into_iter().map(f64::to_bits).collect::<Vec<_>>()
    };
    assert_eq!(block(1), block(3));
}
