//! The split compliance and the stress map against direct solutions on meshes that resolve the
//! load, for normal forces and for forces inclined to the surface.

use super::bodies::{COARSE, Divisions, ring_source, toothed_sector};
use crate::condense::{Assembled, Condensed, Support, condense, match_cuts};
use crate::kernel::{Mollifier, PairQuadrature};
use crate::profile::{Profile, ProfilePoint};
use crate::ring::RingFlexibility;
use crate::{Chart, ElasticStructure, ModifiedSurface, SplitOptions, Structure, SurfaceLoad};
use calyx_fe::SparseVector;
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::quadrature::gauss_legendre;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

const TEETH: u32 = 12;

/// Mean compliance between pressed strips on flanks of two teeth, by the split.
fn split_mean(structure: &dyn Structure, observed: (Chart, &Mollifier), loaded: (Chart, &Mollifier)) -> f64 {
    let rule = gauss_legendre(8);
    let points =
        |strip: &Mollifier| rule.iter().map(|(x, _)| strip.center + strip.width * x).collect::<Vec<_>>();
    let (rows, columns) = (points(observed.1), points(loaded.1));
    let mut block = vec![0.0; rows.len() * columns.len()];
    structure.add_compliance(observed.0, &rows, loaded.0, &columns, &mut block);
    let mut mean = 0.0;
    for (i, s) in rows.iter().enumerate() {
        for (j, at) in columns.iter().enumerate() {
            let weight = rule[i].1 * observed.1.width * observed.1.value(*s);
            mean += weight * rule[j].1 * loaded.1.width * loaded.1.value(*at) * block[i * columns.len() + j];
        }
    }
    if observed.0 == loaded.0 {
        let logarithm = PairQuadrature::default().logarithm(observed.1, loaded.1);
        let factor = -2.0 / (PI * structure.surface_modulus());
        mean += factor * (logarithm - structure.reference_length().ln());
    }
    mean
}

/// The same with a mesh that resolves the strips. Their forces are inclined from the normal along
/// the surface, by `tilt` (rad) at the end of the surface. Returns the compliances by offset, and
/// stress rows of the structure's points.
fn direct(divisions: Divisions, strips: &[(u32, Mollifier)], tilt: f64) -> (Condensed, RingFlexibility) {
    let (model, sources) = toothed_sector(TEETH, 1.0, divisions);
    let nodes = |name: &str| model.mesh.chain_nodes(model.mesh.chain(name).unwrap());
    let bore = nodes("bore");
    let angle = TAU / f64::from(TEETH);
    let assembled = Assembled::plane(&model);
    let cuts =
        match_cuts(&assembled.positions, &nodes("cut_first"), &nodes("cut_last"), &bore, angle).unwrap();
    let loads: Vec<SparseVector> = strips
        .iter()
        .map(|(surface, strip)| {
            let flank = model.mesh.chain(&format!("flank_{surface}")).unwrap();
            let profile = &sources[*surface as usize].profile;
            model.edge_load_between(flank, strip.support(), |s, point| {
                let (tangent, tilt) = (profile.at(s).tangent, tilt * s / profile.length());
                [0, 1].map(|axis| {
                    (tilt.sin() * tangent[axis] - tilt.cos() * point.normal[axis]) * strip.value(s)
                })
            })
        })
        .collect();
    let recovery = calyx_fe::stress::StressRecovery::new(&model);
    let root = model.mesh.chain("root_0").unwrap();
    let mut rows = Vec::new();
    for edge in &root.edges {
        for share in [0.25, 0.75] {
            rows.push(recovery.surface_row(root, edge.s[0] + share * (edge.s[1] - edge.s[0])).unwrap());
        }
    }
    let condensed = condense(
        &assembled,
        &Support::Constrained(&assembled.dofs_of(&bore)),
        Some(&cuts),
        &loads,
        &rows,
        &Interrupt::never(),
    )
    .unwrap();
    let ring =
        RingFlexibility::new(condensed.stiffness.as_ref().unwrap(), TEETH, 3, &Interrupt::never()).unwrap();
    (condensed, ring)
}

fn direct_mean(direct: &(Condensed, RingFlexibility), offset: u32, row: usize, column: usize) -> f64 {
    let (condensed, ring) = direct;
    let through = condensed.on_cuts.col(row).transpose() * (ring.at(offset) * condensed.on_cuts.col(column));
    if offset == 0 { through + condensed.own[(row, column)] } else { through }
}

fn structure(divisions: Divisions, options: SplitOptions) -> ElasticStructure {
    let (model, surfaces) = toothed_sector(TEETH, 1.0, divisions);
    ElasticStructure::ring(&model, &ring_source(TEETH), &surfaces, &options, &Interrupt::never()).unwrap()
}

fn strips(length: f64) -> Vec<(u32, Mollifier)> {
    let strip = |surface: u32, share: f64, width: f64| {
        (surface, Mollifier::new(share * length, share * length, width * length))
    };
    vec![
        strip(0, 0.2, 0.06),
        strip(0, 0.5, 0.03),
        strip(0, 0.53, 0.04),
        strip(0, 0.8, 0.03),
        strip(0, 0.92, 0.015),
        strip(1, 0.5, 0.03),
        strip(1, 0.85, 0.03),
    ]
}

const MEDIUM: Divisions = Divisions { rim: 6, tooth_root: 8, flank: 20, thickness: 20, grading: 8.0 };
/// Three elements or more across each strip: their own error is below that of the split.
const FINE: Divisions = Divisions { rim: 6, tooth_root: 8, flank: 80, thickness: 24, grading: 3.0 };

/// The largest difference of a structure from brute force on own and neighbour teeth.
fn worst_compliance(structure: &dyn Structure, tilt: f64) -> f64 {
    let strips = strips(structure.reference_length());
    let direct = direct(FINE, &strips, tilt);
    let mut worst = 0.0_f64;
    for offset in 0..=2 {
        for (row, (surface, observed)) in strips.iter().enumerate() {
            for (column, (other, loaded)) in strips.iter().enumerate() {
                let observe = Chart { tooth: 4 + offset, surface: *surface };
                let load = Chart { tooth: 4, surface: *other };
                let split = split_mean(structure, (observe, observed), (load, loaded));
                let scale =
                    (direct_mean(&direct, 0, row, row) * direct_mean(&direct, 0, column, column)).sqrt();
                let brute = direct_mean(&direct, offset, row, column);
                worst = worst.max((split - brute).abs() / scale);
            }
        }
    }
    worst
}

#[test]
fn split_agrees_with_brute_force_on_own_and_neighbour_teeth() {
    let worst = worst_compliance(&structure(MEDIUM, SplitOptions::default()), 0.0);
    assert!(worst < 2e-3, "{worst:.1e}");
}

/// A curve whose tangents and normals lean over from their own.
struct Leaning {
    curve: Arc<dyn Profile>,
    /// Inclination at the end, towards growing arc length for the inward normal, rad; proportional
    /// before.
    by: f64,
}

impl Profile for Leaning {
    fn length(&self) -> f64 {
        self.curve.length()
    }

    fn at(&self, s: f64) -> ProfilePoint {
        let point = self.curve.at(s);
        let (sin, cos) = (self.by * s / self.length()).sin_cos();
        let turned =
            |along: [f64; 2], across: [f64; 2]| [0, 1].map(|axis| cos * along[axis] + sin * across[axis]);
        let back = point.tangent.map(|part| -part);
        ProfilePoint {
            normal: turned(point.normal, back),
            tangent: turned(point.tangent, point.normal),
            ..point
        }
    }
}

#[test]
fn forces_that_lean_over_agree_with_brute_force() {
    let allows_modified_surfaces = SplitOptions { allows_modified_surfaces: true, ..SplitOptions::default() };
    for by in [0.0, 0.4, -0.2] {
        let structure = Arc::new(structure(MEDIUM, allows_modified_surfaces));
        let surfaces = [0, 1].map(|surface| ModifiedSurface {
            profile: Arc::new(Leaning { curve: structure.profile(surface), by }),
            onto: Arc::new(|s| s),
        });
        let modified =
            structure.clone().with_modified_surfaces(surfaces.into()).expect("it was made for that");
        let worst = worst_compliance(modified.as_ref(), by);
        assert!(worst < 2e-3, "{by}: {worst:.1e}");
        // Without inclination the result is the same to the bit.
        if by == 0.0 {
            let (chart, s) =
                (Chart { tooth: 0, surface: 0 }, [0.3, 0.7].map(|part| part * structure.reference_length()));
            let mut blocks = [vec![0.0; 4], vec![0.0; 4]];
            structure.add_compliance(chart, &s, chart, &s, &mut blocks[0]);
            modified.add_compliance(chart, &s, chart, &s, &mut blocks[1]);
            assert_eq!(blocks[0], blocks[1]);
        }
    }
    let plain = Arc::new(structure(MEDIUM, SplitOptions::default()));
    let surface = |surface| ModifiedSurface { profile: plain.profile(surface), onto: Arc::new(|s| s) };
    assert!(
        plain.clone().with_modified_surfaces(vec![surface(0), surface(1)]).is_none(),
        "it does not know of other directions"
    );
}

#[test]
fn matching_depth_hardly_matters_and_less_on_finer_meshes() {
    let change = |divisions: Divisions| {
        let mean = |depth: f64| {
            let structure =
                structure(divisions, SplitOptions { matching_depth: depth, ..Default::default() });
            let chart = Chart { tooth: 0, surface: 0 };
            let strips = strips(structure.reference_length());
            [1, 3, 4].map(|k| split_mean(&structure, (chart, &strips[k].1), (chart, &strips[k].1)))
        };
        let reference = mean(1.0);
        let mut worst = 0.0_f64;
        for depth in [0.7, 1.4] {
            for (value, reference) in mean(depth).iter().zip(&reference) {
                worst = worst.max((value / reference - 1.0).abs());
            }
        }
        worst
    };
    let coarse = change(Divisions { flank: 14, thickness: 12, ..COARSE });
    let fine = change(Divisions { rim: 4, tooth_root: 5, flank: 20, thickness: 16, grading: 5.0 });
    // With fewer elements along the flank, those could not resolve the strip at the tip.
    assert!(coarse < 6e-3 && fine < 2e-3, "{coarse:.1e} {fine:.1e}");
}

#[test]
fn stress_map_agrees_with_direct_solution() {
    let structure = structure(COARSE, SplitOptions::default());
    // Wide strips, which the same mesh resolves as well.
    let length = structure.reference_length();
    let wide: Vec<(u32, Mollifier)> = [(0, 0.4, 0.25), (0, 0.6, 0.25), (1, 0.5, 0.25)]
        .map(|(surface, share, width)| {
            (surface, Mollifier::new(share * length, share * length, width * length))
        })
        .to_vec();
    let (condensed, ring) = direct(COARSE, &wide, 0.0);
    for (offset, tooth) in [(0, 5), (1, 6), (2, 7)] {
        for (column, (surface, strip)) in wide.iter().enumerate() {
            let loads: Vec<SurfaceLoad> = gauss_legendre(24)
                .into_iter()
                .map(|(x, weight)| {
                    let s = strip.center + strip.width * x;
                    let force = weight * strip.width * strip.value(s);
                    SurfaceLoad { chart: Chart { tooth: 5, surface: *surface }, s, force }
                })
                .collect();
            let stress = structure.stresses(tooth, 0, &loads);
            let direct = &condensed.rows_cuts * (ring.at(offset) * condensed.on_cuts.col(column));
            let own = condensed.rows_own.col(column);
            let value = |i: usize| direct[i] + if offset == 0 { own[i] } else { 0.0 };
            assert_eq!(stress.len(), direct.nrows());
            let scale = (0..stress.len()).map(|i| value(i).abs()).fold(0.0, f64::max);
            for (i, (place, stress)) in stress.iter().enumerate() {
                let error = (stress - value(i)).abs() / scale;
                assert!(error < 2e-3, "offset {offset}, {place:?}: {stress:e} {:e}", value(i));
            }
        }
    }
}
