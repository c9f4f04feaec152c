//! Whole meshes of loaded rings against one mesh of the whole ring, and against the condensed
//! structures.

use super::bodies::{BORE, COARSE, Divisions, STEEL, ring_source, toothed_ring, toothed_sector};
use super::bore::Direct;
use super::far_stress::turned;
use super::revolved_web::disc;
use super::spline_teeth::FOUR;
use crate::bore::{BoreMeans, RequestedMeans};
use crate::condense::Assembled;
use crate::solid::tests::bodies::{Ring, TEETH};
use crate::solid::{ElasticSolid, SegmentLoad, SolidSplitOptions, SolidStructure, SurfaceSegment};
use crate::{
    BodyLoads, BoreSupport, Chart, DeformedSector, ElasticStructure, MeshedBody, RingSource, SplitOptions,
    Structure, SurfaceLoad,
};
use calyx_fe::material::Plane;
use calyx_fe::{PlaneModel, SparseVector};
use calyx_numerics::interrupt::Interrupt;
use std::f64::consts::TAU;

const SMALL: Divisions = Divisions { rim: 2, tooth_root: 2, flank: 3, thickness: 3, grading: 1.0 };
const SUPPORTS: [BoreSupport; 4] = [
    BoreSupport::Rigid,
    BoreSupport::Means { harmonics: None, degree: 0 },
    BoreSupport::Means { harmonics: Some(2), degree: 0 },
    BoreSupport::SplineTeeth(FOUR),
];

fn flanks() -> [String; 2] {
    [0, 1].map(|flank| format!("flank_{flank}"))
}

fn meshed(teeth: u32, support: BoreSupport, divisions: Divisions) -> MeshedBody {
    let (model, _) = toothed_sector(teeth, 1.0, divisions);
    let source = RingSource { support, ..ring_source(teeth) };
    MeshedBody::ring(model, &source, &flanks(), &Interrupt::never()).unwrap()
}

fn under(body: &MeshedBody, surfaces: &[SurfaceLoad]) -> Vec<DeformedSector> {
    body.deformed(BodyLoads::Plane { surfaces, interface: &[] }, &Interrupt::never()).unwrap()
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|axis| (a[axis] - b[axis]).powi(2)).sum::<f64>().sqrt()
}

fn size(displacement: [f64; 3]) -> f64 {
    distance(displacement, [0.0; 3])
}

/// With loads on two teeth, every output node has the displacement that it has in one mesh of all
/// teeth.
#[test]
fn every_node_moves_as_in_one_mesh_of_the_whole_ring() {
    const SECTORS: u32 = 9;
    let whole = PlaneModel::new(toothed_ring(SECTORS, SMALL), STEEL, Plane::Strain);
    let equations = Assembled::plane(&whole);
    let loads = [(1, 0, 0.04, 3e5), (1, 0, 0.06, -1e5), (2, 1, 0.05, 2e5)]
        .map(|(tooth, surface, s, force)| SurfaceLoad { chart: Chart { tooth, surface }, s, force });
    let mut forces = vec![0.0; whole.dof_count()];
    for SurfaceLoad { chart, s, force } in &loads {
        let chain = whole.mesh.chain(&flanks()[chart.surface as usize]).unwrap();
        let point = whole.mesh.chain_point(chain, *s).unwrap();
        let row: SparseVector = whole.displacement_row(point.place, point.normal.map(|part| -force * part));
        let angle = TAU * f64::from(chart.tooth) / f64::from(SECTORS);
        forces.iter_mut().zip(turned(&whole, &row, angle)).for_each(|(sum, part)| *sum += part);
    }
    let bore = whole.mesh.chain("bore").unwrap();
    for support in &SUPPORTS[..3] {
        let expected = match RequestedMeans::for_ring(*support) {
            None => {
                let mut constrained = calyx_fe::Constraints::new();
                whole.mesh.chain_nodes(bore).into_iter().for_each(|node| {
                    constrained.fix_node(node);
                });
                calyx_fe::Solver::new(&equations.stiffness, constrained).unwrap().solve_one(&forces).unwrap()
            }
            Some(wanted) => {
                let means = BoreMeans::plane(&whole, bore, wanted, &Interrupt::never()).unwrap().unwrap();
                Direct::new(&equations, &whole.rigid_body_modes(), &means.forms).solve(&forces).0
            }
        };
        let found = under(&meshed(SECTORS, *support, SMALL), &loads);
        assert_eq!(
            found.iter().map(|sector| sector.tooth).collect::<Vec<_>>(),
            (0..SECTORS).collect::<Vec<_>>()
        );
        let largest = expected.iter().fold(0.0_f64, |most, part| most.max(part.abs()));
        assert!(found.iter().all(|sector| sector.points.len() == found[0].points.len()));
        for sector in &found {
            for (&point, &moved) in sector.points.iter().zip(&sector.displacements) {
                let same = |&node: &usize| {
                    let [x, y] = whole.mesh.nodes[node];
                    distance([x, y, 0.0], point) < 1e-9
                };
                let node = (0..whole.mesh.nodes.len()).find(same).expect("a node of the whole ring");
                let error = distance([expected[2 * node], expected[2 * node + 1], 0.0], moved) / largest;
                assert!(error < 1e-8, "{support:?}, tooth {}: {error:.1e}", sector.tooth);
            }
        }
    }
}

/// The output displacement of an unloaded flank, near the load or far from it, is that of the
/// structure.
#[test]
fn flanks_have_moved_by_what_the_structure_answers() {
    for support in SUPPORTS {
        let (model, surfaces) = toothed_sector(TEETH, 1.0, COARSE);
        let source = RingSource { support, ..ring_source(TEETH) };
        let (options, never) = (SplitOptions::default(), Interrupt::never());
        let structure = ElasticStructure::ring(&model, &source, &surfaces, &options, &never).unwrap();
        let length = surfaces[0].profile.length();
        let load = SurfaceLoad { chart: Chart { tooth: 3, surface: 0 }, s: 0.4 * length, force: 2e5 };
        let found = under(&meshed(TEETH, support, COARSE), &[load]);
        let mut largest = 0.0_f64;
        for tooth in [3_u32, 4, 2, 5, 9] {
            let observe = Chart { tooth, surface: 1 };
            let sector = &found[tooth as usize];
            let (sin, cos) = structure.tooth_angle(tooth).sin_cos();
            let profile = structure.profile(1);
            let along = |&[x, y, _]: &[f64; 3]| {
                let point = profile.at(0.0);
                let own = [cos * x + sin * y - point.position[0], cos * y - sin * x - point.position[1]];
                let [s, off] = [point.tangent, point.normal].map(|by| own[0] * by[0] + own[1] * by[1]);
                (off.abs() < 1e-9 && s > 0.2 * length && s < 0.8 * length).then_some(s)
            };
            let mut seen = 0;
            for (point, moved) in sector.points.iter().zip(&sector.displacements) {
                let Some(s) = along(point) else { continue };
                seen += 1;
                let mut answer = [0.0];
                structure.add_compliance(observe, &[s], load.chart, &[load.s], &mut answer);
                let [nx, ny] = profile.at(s).normal;
                let inwards = -(moved[0] * (cos * nx - sin * ny) + moved[1] * (sin * nx + cos * ny));
                let expected = answer[0] * load.force;
                largest = largest.max(expected.abs());
                let error = (inwards - expected).abs() / largest;
                assert!(
                    error < 2e-3,
                    "{support:?}, tooth {tooth}, {s}: {inwards:e} {expected:e} ({error:.1e})"
                );
            }
            assert!(seen > 3, "tooth {tooth}: {seen} nodes of its flank");
        }
    }
}

/// Loads on other teeth cause the same deformation, rotated.
#[test]
fn loads_a_pitch_further_turn_the_picture() {
    let body = meshed(TEETH, SUPPORTS[1], SMALL);
    let load = |tooth: u32| SurfaceLoad { chart: Chart { tooth, surface: 1 }, s: 0.05, force: 1e5 };
    let [one, next] = [TEETH - 1, 0].map(|tooth| under(&body, &[load(tooth)]));
    let (sin, cos) = (TAU / f64::from(TEETH)).sin_cos();
    let turn = |[x, y, z]: [f64; 3]| [cos * x - sin * y, sin * x + cos * y, z];
    let largest =
        one.iter().flat_map(|sector| &sector.displacements).fold(0.0, |most, &by| size(by).max(most));
    for (tooth, sector) in one.iter().enumerate() {
        let ahead = &next[(tooth + 1) % next.len()];
        assert_eq!(sector.cells, ahead.cells);
        let [moved, there] = [&sector.displacements, &ahead.displacements];
        for (&moved, &there) in moved.iter().zip(there) {
            assert!(distance(turn(moved), there) < 1e-12 * largest);
        }
        // Tensors are compared by invariants under rotation.
        for (a, b) in sector.stresses.iter().zip(&ahead.stresses) {
            let scale = a.iter().fold(1.0_f64, |most, part| most.max(part.abs()));
            assert!((a[0] + a[1] - b[0] - b[1]).abs() < 1e-9 * scale && (a[2] - b[2]).abs() < 1e-9 * scale);
        }
    }
}

/// Maxwell-Betti: the displacement of a flank by the force of a spline tooth with clearance is that
/// of the spline tooth by the same force on the flank. Under forces of gear teeth the displacement
/// is that of the structure on such spline teeth.
#[test]
fn flanks_move_by_splines_with_clearance_as_spline_teeth_by_them() {
    let support = BoreSupport::SplineWithClearance { spline_teeth: FOUR, clearance: 1e-5 };
    let (model, surfaces) = toothed_sector(TEETH, 1.0, COARSE);
    let source = RingSource { support, ..ring_source(TEETH) };
    let (options, never) = (SplitOptions::default(), Interrupt::never());
    let structure = ElasticStructure::ring(&model, &source, &surfaces, &options, &never).unwrap();
    let body = meshed(TEETH, support, COARSE);
    let length = surfaces[1].profile.length();
    let on_tooth = SurfaceLoad { chart: Chart { tooth: 3, surface: 0 }, s: 0.4 * length, force: 2e5 };
    let forces = [1.5e5, 0.0, -0.5e5, 0.0];
    let shown = |surfaces: &[SurfaceLoad], spline_teeth: &[f64]| {
        body.deformed(BodyLoads::Plane { surfaces, interface: spline_teeth }, &never).unwrap()
    };
    let (by_spline_teeth, by_both) = (shown(&[], &forces), shown(&[on_tooth], &forces));
    assert_eq!(by_spline_teeth.len(), TEETH as usize, "all of them, though no tooth is loaded");
    let (mut seen, mut largest) = (0, 0.0_f64);
    for tooth in 0..TEETH {
        let observe = Chart { tooth, surface: 1 };
        let (sin, cos) = structure.tooth_angle(tooth).sin_cos();
        let profile = structure.profile(1);
        let [lugs_only, both] = [&by_spline_teeth, &by_both].map(|all| &all[tooth as usize]);
        // The two outputs may have different numbers of nodes.
        for (sector, tooth_force) in [(lugs_only, 0.0), (both, on_tooth.force)] {
            for (&[x, y, _], moved) in sector.points.iter().zip(&sector.displacements) {
                let point = profile.at(0.0);
                let own = [cos * x + sin * y - point.position[0], cos * y - sin * x - point.position[1]];
                let [s, off] = [point.tangent, point.normal].map(|by| own[0] * by[0] + own[1] * by[1]);
                if off.abs() > 1e-9 || s < 0.2 * length || s > 0.8 * length {
                    continue;
                }
                seen += 1;
                let mut answer = [0.0];
                structure.add_compliance(observe, &[s], on_tooth.chart, &[on_tooth.s], &mut answer);
                let spline_teeth = structure.interface_displacements(observe, &[s]);
                let by_spline_teeth: f64 = forces
                    .iter()
                    .enumerate()
                    .map(|(spline_tooth, force)| spline_teeth[(spline_tooth, 0)] * force)
                    .sum();
                let expected = answer[0] * tooth_force + by_spline_teeth;
                largest = largest.max(by_spline_teeth.abs());
                let [nx, ny] = profile.at(s).normal;
                let inwards = -(moved[0] * (cos * nx - sin * ny) + moved[1] * (sin * nx + cos * ny));
                let error = (inwards - expected).abs() / largest.max(expected.abs());
                assert!(error < 2e-3, "tooth {tooth}, {s}: {inwards:e} {expected:e} ({error:.1e})");
            }
        }
    }
    assert!(seen > 6 * TEETH as usize, "{seen} nodes of flanks");
}

/// Three dimensions, on a helical ring: the other flanks of the loaded tooth and of its neighbours.
/// Also on a disc web with a separate mesh.
#[test]
fn displacements_of_solid_flanks_equal_the_influence_of_the_structure() {
    let ring = Ring { divisions: COARSE, ratio: 0.3, helix: 0.2, face_width: 0.5, layers: 2, axial_order: 3 };
    let web = disc([0.3 * BORE, BORE], [-0.25, 0.0], BoreSupport::Rigid);
    let free = BoreSupport::Means { harmonics: None, degree: 0 };
    for (support, web) in [(BoreSupport::Rigid, None), (free, None), (free, Some(&web))] {
        let (model, surfaces) = ring.sector();
        let profile = toothed_sector(TEETH, 1.0, COARSE).1[1].profile.clone();
        let source = RingSource { support, coupled: 1, ..ring_source(TEETH) };
        let (options, never) =
            (SolidSplitOptions { samples: 8, ..SolidSplitOptions::default() }, Interrupt::never());
        let structure = match web {
            None => ElasticSolid::ring(&model, &source, &surfaces, &options, &never),
            Some(web) => ElasticSolid::ring_on_web(&model, &source, web, (&surfaces, &options), &never),
        };
        let structure = structure.unwrap();
        let body = MeshedBody::solid_ring(model, &source, web, &flanks(), &never).unwrap();
        // A uniform load along the face, which few polynomials represent.
        let [[_, length], [start, end]] = structure.surface(0).range();
        let chart = Chart { tooth: 0, surface: 0 };
        let count = 40;
        let segments: Vec<SurfaceSegment> = (0..count)
            .map(|k| {
                let z = start + (end - start) * (f64::from(k) + 0.5) / f64::from(count);
                SurfaceSegment { place: [0.4 * length, z], length: (end - start) / f64::from(count) }
            })
            .collect();
        let loads: Vec<SegmentLoad> =
            segments.iter().map(|&segment| SegmentLoad { chart, segment, force: 1e4 }).collect();
        let found = body.deformed(BodyLoads::Solid { segments: &loads, interface: &[] }, &never).unwrap();
        let mut largest = 0.0_f64;
        for tooth in [0, 1, TEETH - 1, 5] {
            let observe = Chart { tooth, surface: 1 };
            let sector = &found[tooth as usize];
            let mut seen = 0;
            for (&[x, y, z], moved) in sector.points.iter().zip(&sector.displacements) {
                let (sin, cos) = (structure.tooth_angle(tooth) + ring.rate() * z).sin_cos();
                let section = [cos * x + sin * y, cos * y - sin * x];
                let from = profile.at(0.0);
                let own = [section[0] - from.position[0], section[1] - from.position[1]];
                let [s, off] = [from.tangent, from.normal].map(|by| own[0] * by[0] + own[1] * by[1]);
                if off.abs() > 1e-9 || s < 0.2 * length || s > 0.8 * length || z.abs() > 0.3 * (end - start) {
                    continue;
                }
                seen += 1;
                let mut responses = vec![0.0; loads.len()];
                structure.add_compliance(
                    observe,
                    &[SurfaceSegment::from([s, z])],
                    chart,
                    &segments,
                    &mut responses,
                );
                let expected: f64 = responses.iter().map(|answer| answer * 1e4).sum();
                let (sin, cos) = structure.tooth_angle(tooth).sin_cos();
                let [nx, ny, nz] = structure.surface(1).at(s, z).normal;
                let normal = [cos * nx - sin * ny, sin * nx + cos * ny, nz];
                let inwards = -moved.iter().zip(normal).map(|(by, along)| by * along).sum::<f64>();
                largest = largest.max(expected.abs());
                let error = (inwards - expected).abs() / largest;
                assert!(
                    error < 1e-2,
                    "{support:?}, {}, tooth {tooth}, {s} {z}: {inwards:e} {expected:e} ({error:.1e})",
                    if web.is_some() { "on a web" } else { "without one" }
                );
            }
            assert!(seen > 3, "tooth {tooth}: {seen} nodes of its flank");
        }
    }
}
