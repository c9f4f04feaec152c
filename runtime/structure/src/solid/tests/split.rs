//! Compliance and stress map against direct solutions on meshes that resolve the load.

use super::bodies::{Ring, TEETH};
use crate::Chart;
use crate::condense::{Assembled, Condensed, Support, condense, match_cuts};
use crate::kernel::Mollifier;
use crate::ring::RingFlexibility;
use crate::solid::axial_modes::AxialModes;
use crate::solid::half_space::ReciprocalMeans;
use crate::solid::screw::Screw;
use crate::solid::{ElasticSolid, SegmentLoad, SolidSplitOptions, SolidStructure, SurfaceSegment};
use crate::tests::bodies::Divisions;
use calyx_fe::SparseVector;
use calyx_fe::material::Plane;
use calyx_fe::solid::{SolidModel, SurfaceStressRecovery};
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::quadrature::gauss_legendre;
use faer::MatRef;
use std::f64::consts::{PI, TAU};

/// Loaded patch, distributed over the profile and over the face.
#[derive(Clone)]
pub(super) struct Patch {
    pub surface: u32,
    pub across: Mollifier,
    pub along: Mollifier,
}

impl Patch {
    /// Builds a patch from the relative centre and half size along the profile, and along the face
    /// from its middle.
    fn new(ring: &Ring, surface: u32, length: f64, [u, across]: [f64; 2], [v, along]: [f64; 2]) -> Self {
        let face = ring.face_width;
        Self {
            surface,
            across: Mollifier::new(u * length, u * length, across * length),
            along: Mollifier::new(v * face, v * face, along * face),
        }
    }

    /// Returns points with their shares of a unit force.
    pub fn points(&self) -> Vec<([f64; 2], f64)> {
        let rule = gauss_legendre(10);
        let mut points = Vec::new();
        for &(x, a) in &rule {
            for &(y, b) in &rule {
                let (u, v) =
                    (self.across.center + self.across.width * x, self.along.center + self.along.width * y);
                let share =
                    a * self.across.width * self.across.value(u) * b * self.along.width * self.along.value(v);
                points.push(([u, v], share));
            }
        }
        points
    }
}

pub(super) fn patches(ring: &Ring, length: f64) -> Vec<Patch> {
    [
        (0, [0.5, 0.2], [0.0, 0.3]),
        (0, [0.5, 0.2], [-0.25, 0.25]),
        (0, [0.8, 0.15], [0.1, 0.3]),
        (0, [0.4, 0.2], [0.2, 0.3]),
        (1, [0.6, 0.2], [0.2, 0.3]),
    ]
    .map(|(surface, across, along)| Patch::new(ring, surface, length, across, along))
    .to_vec()
}

/// Returns the mean of the smooth part of the compliance between patches.
pub(super) fn smooth_mean(structure: &ElasticSolid, observed: (u32, &Patch), loaded: (u32, &Patch)) -> f64 {
    let [observer, load] = [observed, loaded].map(|(tooth, patch)| Chart { tooth, surface: patch.surface });
    let (rows, columns) = (observed.1.points(), loaded.1.points());
    let places = |points: &[([f64; 2], f64)]| {
        points.iter().map(|point| SurfaceSegment::from(point.0)).collect::<Vec<_>>()
    };
    let mut block = vec![0.0; rows.len() * columns.len()];
    structure.add_compliance(observer, &places(&rows), load, &places(&columns), &mut block);
    let mut mean = 0.0;
    for (i, row) in rows.iter().enumerate() {
        for (j, column) in columns.iter().enumerate() {
            mean += row.1 * column.1 * block[i * columns.len() + j];
        }
    }
    mean
}

/// Returns the means of the half-space's compliance between the patches on surface 0, which are the
/// first ones.
fn half_space(ring: &Ring, patches: &[Patch]) -> Vec<Vec<f64>> {
    let (model, sources) = ring.sector();
    // Enough polynomials to represent the patches themselves.
    let modes = AxialModes::new(sources[0].surface.range()[1], 32);
    let smallest = patches.iter().map(|patch| patch.across.width).fold(f64::INFINITY, f64::min);
    let mut means = vec![vec![0.0; patches.len()]; patches.len()];
    for surface in 0..2 {
        let flank = &sources[surface as usize].surface;
        let screw = Screw::of(flank.as_ref(), flank.range()[0]).unwrap();
        let reciprocal = ReciprocalMeans::new(screw, &modes, [true; 2], smallest);
        for (row, a) in patches.iter().enumerate().filter(|(_, patch)| patch.surface == surface) {
            for (column, b) in patches.iter().enumerate().filter(|(_, patch)| patch.surface == surface) {
                let between = reciprocal.between(&a.across, &b.across);
                means[row][column] = with_shares(&modes, between.as_ref(), [a, b]);
                means[row][column] /= PI * model.material.surface_modulus(Plane::Strain);
            }
        }
    }
    means
}

/// Returns the mean over two patches from the means over pairs of polynomials.
pub(super) fn with_shares(modes: &AxialModes, between: MatRef<'_, f64>, patches: [&Patch; 2]) -> f64 {
    let [a, b] = patches.map(|patch| {
        let mut shares = vec![0.0; modes.count()];
        for (v, weight) in modes.quadrature(patch.along.support(), 16) {
            let values = modes.values(v).into_iter();
            shares.iter_mut().zip(values).for_each(|(sum, p)| *sum += weight * p * patch.along.value(v));
        }
        shares
    });
    let mut mean = 0.0;
    for n in 0..modes.count() {
        for m in 0..modes.count() {
            mean += a[n] * between[(n, m)] * b[m];
        }
    }
    mean
}

/// Returns the response of a mesh that resolves the patches, with stress rows on the fillet of
/// flank 0.
pub(super) fn direct(
    model: &SolidModel,
    patches: &[Patch],
    places: &[[f64; 2]],
) -> (Condensed, RingFlexibility) {
    let nodes = |name: &str| model.mesh.nodes_on(model.mesh.face_set(name).unwrap());
    let assembled =
        Assembled::solid(&model.mesh, &Interrupt::never(), || Ok(model.stiffness())).expect("room");
    let bore = nodes("bore");
    let angle = TAU / f64::from(TEETH);
    let cuts =
        match_cuts(&assembled.positions, &nodes("cut_first"), &nodes("cut_last"), &bore, angle).unwrap();
    let loads: Vec<SparseVector> = patches
        .iter()
        .map(|patch| {
            let set = model.mesh.face_set(&format!("flank_{}", patch.surface)).unwrap();
            let range = [patch.across.support(), patch.along.support()];
            let load = model.face_load_between(set, range, |s, z, point| {
                point.normal.map(|part| -part * patch.across.value(s) * patch.along.value(z))
            });
            load.unwrap()
        })
        .collect();
    let recovery = SurfaceStressRecovery::new(model).unwrap();
    let root = model.mesh.face_set("root_0").unwrap();
    let rows: Vec<SparseVector> =
        places.iter().flat_map(|&[s, z]| recovery.rows(root, s, z).unwrap().rows).collect();
    let constrained = assembled.dofs_of(&bore);
    let condensed = condense(
        &assembled,
        &Support::Constrained(&constrained),
        Some(&cuts),
        &loads,
        &rows,
        &Interrupt::never(),
    )
    .unwrap();
    let flexibility =
        RingFlexibility::new(condensed.stiffness.as_ref().unwrap(), TEETH, 3, &Interrupt::never()).unwrap();
    (condensed, flexibility)
}

pub(super) fn direct_mean(
    direct: &(Condensed, RingFlexibility),
    offset: u32,
    row: usize,
    column: usize,
) -> f64 {
    let (condensed, ring) = direct;
    let through = condensed.on_cuts.col(row).transpose() * (ring.at(offset) * condensed.on_cuts.col(column));
    if offset == 0 { through + condensed.own[(row, column)] } else { through }
}

pub(super) const DIVISIONS: Divisions =
    Divisions { rim: 2, tooth_root: 3, flank: 10, thickness: 8, grading: 4.0 };

/// Returns a ring whose mesh resolves the patches, so that the direct solution is as accurate as
/// the split.
fn ring(helix: f64) -> Ring {
    Ring { divisions: DIVISIONS, ratio: 0.3, helix, face_width: 1.0, layers: 4, axial_order: 3 }
}

#[test]
fn split_agrees_with_brute_force_on_own_and_neighbour_teeth() {
    let ring = ring(0.3);
    let structure = ring.structure(&SolidSplitOptions::default());
    let patches = patches(&ring, structure.surface(0).range()[0][1]);
    let half_space = half_space(&ring, &patches);
    let direct = direct(&ring.sector().0, &patches, &[]);
    for offset in 0..=1 {
        for (row, observed) in patches.iter().enumerate() {
            for (column, loaded) in patches.iter().enumerate() {
                let mut split = smooth_mean(&structure, (4 + offset, observed), (4, loaded));
                if offset == 0 {
                    split += half_space[row][column];
                }
                let scale =
                    (direct_mean(&direct, 0, row, row) * direct_mean(&direct, 0, column, column)).sqrt();
                let error = (split - direct_mean(&direct, offset, row, column)).abs() / scale;
                // The accuracy of the mesh's response of a patch to itself is limited.
                let tolerance = if offset == 0 && row == column { 4e-3 } else { 5e-4 };
                assert!(error < tolerance, "offset {offset}, {row} by {column}: {error:.1e}");
            }
        }
    }
}

#[test]
fn stress_map_agrees_with_direct_solution() {
    let ring = ring(0.3);
    let structure = ring.structure(&SolidSplitOptions::default());
    let patches = patches(&ring, structure.surface(0).range()[0][1]);
    let (model, _) = ring.sector();
    let root = &model.mesh.face_set("root_0").unwrap().chart.as_ref().unwrap().edges;
    let mut places = Vec::new();
    for edge in root {
        for share in [0.25, 0.75] {
            let s = edge.s[0] + share * (edge.s[1] - edge.s[0]);
            places.extend((0..9).map(|z| [s, ring.face_width * (f64::from(z) / 8.0 - 0.5)]));
        }
    }
    let (condensed, flexibility) = direct(&model, &patches, &places);
    for offset in 0..=1 {
        for (column, patch) in patches.iter().enumerate() {
            let chart = Chart { tooth: 5, surface: patch.surface };
            let loads: Vec<SegmentLoad> = patch
                .points()
                .into_iter()
                .map(|(place, force)| SegmentLoad { chart, segment: place.into(), force })
                .collect();
            let stress = structure.stresses(5 + offset, 0, &loads);
            let cuts = &condensed.rows_cuts * (flexibility.at(offset) * condensed.on_cuts.col(column));
            let own = condensed.rows_own.col(column);
            let component = |row: usize| cuts[row] + if offset == 0 { own[row] } else { 0.0 };
            assert_eq!(3 * stress.len(), cuts.nrows());
            let direct = |place: usize| {
                let [along, across, shear] = [0, 1, 2].map(|part| component(3 * place + part));
                0.5 * (along + across) + (0.5 * (along - across)).hypot(shear)
            };
            let scale = (0..stress.len()).map(|place| direct(place).abs()).fold(0.0, f64::max);
            let mut worst = 0.0_f64;
            for (place, stress) in stress.iter().enumerate() {
                let error = (stress.principal()[0] - direct(place)).abs() / scale;
                worst = worst.max(error);
            }
            assert!(worst < 6e-3, "offset {offset}, load {column}: {worst:.1e}");
        }
    }
}
