//! Bodies that are no extruded sections: tapered, curved along the face, with conical side faces,
//! and in coordinates that are neither lengths nor normal to each other.

use super::bodies::{Ring, TEETH};
use super::split::{DIVISIONS, Patch, direct, direct_mean, patches, smooth_mean, with_shares};
use crate::solid::axial_modes::AxialModes;
use crate::solid::side_faces::SideFaces;
use crate::solid::surface_means::SurfaceMeans;
use crate::solid::{ElasticSolid, SolidSplitOptions, SolidStructure, SolidSurfaceSource, SurfaceSegment};
use crate::tests::bodies::{COARSE, Divisions, ring_source};
use crate::{Chart, StructureError};
use calyx_fe::material::Plane;
use calyx_fe::solid::SolidModel;
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::vec3::{dot, minus};
use faer::Mat;
use std::f64::consts::PI;

fn ring(helix: f64) -> Ring {
    Ring { divisions: DIVISIONS, ratio: 0.3, helix, face_width: 1.0, layers: 4, axial_order: 3 }
}

fn coarse() -> Ring {
    Ring { divisions: COARSE, ratio: 0.3, helix: 0.2, face_width: 0.5, layers: 1, axial_order: 2 }
}

fn condensed(
    (model, surfaces): &(SolidModel, Vec<SolidSurfaceSource>),
    options: &SolidSplitOptions,
) -> ElasticSolid {
    ElasticSolid::ring(model, &ring_source(TEETH), surfaces, options, &Interrupt::never()).unwrap()
}

fn same([u, v]: [f64; 2]) -> [f64; 2] {
    [u, v]
}

/// Bevel gear: sections shrink to two thirds from one end to the other, teeth curve along the face,
/// and side faces are cones.
fn bevel([x, y, z]: [f64; 3]) -> [f64; 3] {
    let (scale, angle) = (1.0 + 0.4 * z, 0.4 * z * z);
    let (sin, cos) = angle.sin_cos();
    [scale * (cos * x - sin * y), scale * (sin * x + cos * y), z - 0.3 * scale * x.hypot(y)]
}

/// Returns the means of the half-space's compliance between the patches on each surface.
fn half_space((model, sources): &(SolidModel, Vec<SolidSurfaceSource>), patches: &[Patch]) -> Mat<f64> {
    let smallest = patches.iter().map(|patch| patch.across.width).fold(f64::INFINITY, f64::min);
    let mut all = Mat::zeros(patches.len(), patches.len());
    for (index, source) in sources.iter().enumerate() {
        let set = model.mesh.face_set(&source.faces).unwrap();
        let [range, along] = source.surface.range();
        // Enough polynomials to represent the patches themselves.
        let modes = AxialModes::new(along, 24);
        let sides = SideFaces::of(&model.mesh, set, source.surface.as_ref()).unwrap();
        let means = SurfaceMeans::new(source.surface.as_ref(), range, &modes, Some(&sides), smallest);
        let here = || patches.iter().enumerate().filter(|(_, patch)| patch.surface as usize == index);
        for (row, a) in here() {
            for (column, b) in here() {
                let between = means.between(&a.across, &b.across);
                all[(row, column)] = with_shares(&modes, between.as_ref(), [a, b])
                    / (PI * model.material.surface_modulus(Plane::Strain));
            }
        }
    }
    all
}

#[test]
fn the_split_of_a_bevel_tooth_agrees_with_direct_solutions() {
    let sector = ring(0.3).mapped_sector(same, bevel);
    let structure = condensed(&sector, &SolidSplitOptions::default());
    let patches = patches(&ring(0.3), structure.surface(0).range()[0][1]);
    let half_space = half_space(&sector, &patches);
    let direct = direct(&sector.0, &patches, &[]);
    for offset in 0..=1 {
        for (row, observed) in patches.iter().enumerate() {
            for (column, loaded) in patches.iter().enumerate() {
                let mut split = smooth_mean(&structure, (4 + offset, observed), (4, loaded));
                if offset == 0 {
                    split += half_space[(row, column)];
                }
                let own = |k: usize| direct_mean(&direct, 0, k, k);
                let scale = (own(row) * own(column)).sqrt();
                let error = (split - direct_mean(&direct, offset, row, column)).abs() / scale;
                // The accuracy of the mesh's response of a patch to itself is limited.
                let tolerance = if offset == 0 && row == column { 4e-3 } else { 6e-4 };
                assert!(error < tolerance, "offset {offset}, {row} by {column}: {error:.1e}");
            }
        }
    }
}

#[test]
fn the_matching_depth_of_a_bevel_tooth_hardly_matters() {
    let divisions = Divisions { flank: 14, thickness: 12, ..COARSE };
    let ring = Ring { divisions, layers: 2, axial_order: 3, ..ring(0.0) };
    let sector = ring.mapped_sector(same, bevel);
    let all = &patches(&ring, sector.1[0].surface.range()[0][1])[..3];
    let half_space = half_space(&sector, all);
    let values = |matching_depth: f64| {
        let options = SolidSplitOptions { matching_depth, ..SolidSplitOptions::default() };
        let structure = condensed(&sector, &options);
        [0, 1, 2].map(|k| half_space[(k, k)] + smooth_mean(&structure, (4, &all[k]), (4, &all[k])))
    };
    for (narrow, wide) in values(0.7).into_iter().zip(values(1.4)) {
        assert!((narrow / wide - 1.0).abs() < 1e-2, "{narrow} {wide}");
    }
}

/// Returns the mean of the smooth part over patches whose points are moved to other coordinates.
fn smooth_mean_at(
    structure: &ElasticSolid,
    coordinates: impl Fn([f64; 2]) -> [f64; 2],
    [observed, loaded]: [&Patch; 2],
) -> f64 {
    let [observer, load] = [observed, loaded].map(|patch| Chart { tooth: 4, surface: patch.surface });
    let [rows, columns] = [observed, loaded].map(Patch::points);
    let segments = |points: &[([f64; 2], f64)]| {
        points.iter().map(|point| SurfaceSegment::from(coordinates(point.0))).collect::<Vec<_>>()
    };
    let mut block = vec![0.0; rows.len() * columns.len()];
    structure.add_compliance(observer, &segments(&rows), load, &segments(&columns), &mut block);
    let product =
        |(k, value): (usize, &f64)| rows[k / columns.len()].1 * columns[k % columns.len()].1 * value;
    block.iter().enumerate().map(product).sum()
}

/// A helical body by the computation for extruded surfaces, by that for any surface, and in other
/// coordinates along the face.
#[test]
fn coordinates_along_the_face_do_not_change_the_compliance() {
    let unequal = |[u, v]: [f64; 2]| [u, v + 0.2 * (v * v - 0.25)];
    let there = |[u, z]: [f64; 2]| [u, ((1.04 + 0.8 * z).sqrt() - 1.0) / 0.4];
    assert!((unequal(there([0.3, 0.17]))[1] - 0.17).abs() < 1e-14);
    let ring = Ring { divisions: COARSE, layers: 6, ..ring(0.3) };
    let options = SolidSplitOptions { samples: 10, ..SolidSplitOptions::default() };
    let extruded = ring.structure(&options);
    let general = condensed(&ring.mapped_sector(same, |at| at), &options);
    let moved = condensed(&ring.mapped_sector(unequal, |at| at), &options);
    let patches = patches(&ring, extruded.surface(0).range()[0][1]);
    for (row, a) in patches.iter().enumerate() {
        for (column, b) in patches.iter().enumerate() {
            let reference = smooth_mean_at(&extruded, same, [a, b]);
            let own = |patch: &Patch| smooth_mean_at(&extruded, same, [patch, patch]);
            let scale = (own(a) * own(b)).sqrt();
            let general = (smooth_mean_at(&general, same, [a, b]) - reference) / scale;
            let moved = (smooth_mean_at(&moved, there, [a, b]) - reference) / scale;
            assert!(general.abs() < 2e-5, "{row} {column}: {general:.1e}");
            // The mesh is coarser at one end. With four layers, the difference is twice as large.
            assert!(moved.abs() < 1.5e-3, "{row} {column}: {moved:.1e}");
        }
    }
}

/// The chart keeps its coordinates: its unit of length is no length on the larger body.
#[test]
fn a_body_of_twice_the_size_has_half_the_compliance() {
    let options = SolidSplitOptions { samples: 8, ..SolidSplitOptions::default() };
    let small = condensed(&coarse().mapped_sector(same, bevel), &options);
    let large = condensed(&coarse().mapped_sector(same, |at| bevel(at).map(|part| 2.0 * part)), &options);
    let [[_, length], [_, end]] = small.surface(0).range();
    let segments: Vec<SurfaceSegment> =
        [[0.9, 0.1], [0.3, -0.9], [0.32, -0.8], [1.0, 0.4]].map(|[u, v]| [u * length, v * end].into()).into();
    let block = |structure: &ElasticSolid, surface: u32| {
        let mut block = vec![0.0; segments.len() * segments.len()];
        let chart = |surface| Chart { tooth: 2, surface };
        structure.add_compliance(chart(0), &segments, chart(surface), &segments, &mut block);
        block
    };
    for surface in [0, 1] {
        let (one, other) = (block(&small, surface), block(&large, surface));
        let scale = one.iter().fold(0.0, |scale: f64, value| scale.max(value.abs()));
        for (one, other) in one.iter().zip(other) {
            assert!((one - 2.0 * other).abs() < 1e-9 * scale, "{one} {other}");
        }
    }
}

#[test]
fn a_restored_body_has_the_same_bits_and_reciprocity_is_exact() {
    let options = SolidSplitOptions { samples: 8, ..SolidSplitOptions::default() };
    let structure = condensed(&coarse().mapped_sector(same, bevel), &options);
    let surfaces = [0, 1].map(|surface| structure.surface(surface)).to_vec();
    let bytes = structure.stored().unwrap();
    let restored = ElasticSolid::restored(&bytes, surfaces.clone()).unwrap();
    let [[_, length], [_, end]] = structure.surface(0).range();
    let places = |shares: [[f64; 2]; 3]| {
        shares.map(|[u, v]| SurfaceSegment { place: [u * length, v * end], length: 0.2 * end })
    };
    let (some, others) =
        (places([[0.9, 0.1], [0.1, -0.9], [0.5, 0.0]]), places([[0.2, 0.5], [0.51, 0.02], [1.0, 0.9]]));
    let block = |structure: &ElasticSolid, charts: [Chart; 2], points: [&[SurfaceSegment]; 2]| {
        let mut block = vec![0.0; 9];
        structure.add_compliance(charts[0], points[0], charts[1], points[1], &mut block);
        block
    };
    let chart = |tooth, surface| Chart { tooth, surface };
    for (a, b) in [(chart(0, 0), chart(0, 0)), (chart(0, 0), chart(0, 1)), (chart(3, 1), chart(4, 1))] {
        let there = block(&structure, [a, b], [&some, &others]);
        let back = block(&structure, [b, a], [&others, &some]);
        for (k, value) in there.iter().enumerate() {
            assert_eq!(value.to_bits(), back[k % 3 * 3 + k / 3].to_bits());
        }
        assert_eq!(there, block(&restored, [a, b], [&some, &others]));
        assert_eq!(structure.side_faces(a.surface, [0.1, 0.2]), restored.side_faces(a.surface, [0.1, 0.2]));
    }
    assert!(ElasticSolid::restored(&bytes[..bytes.len() / 2], surfaces).is_none());
}

/// The cones of the bevel gear: normals along the pitch cone.
#[test]
fn side_faces_touch_the_body_at_its_ends() {
    let ring = ring(0.3);
    let sector = ring.mapped_sector(same, bevel);
    let surface = sector.1[0].surface.clone();
    let sides =
        SideFaces::of(&sector.0.mesh, sector.0.mesh.face_set("flank_0").unwrap(), surface.as_ref()).unwrap();
    let [[_, length], ends] = surface.range();
    for (side, sign) in [(0, -1.0), (1, 1.0)] {
        for share in [0.0, 0.4, 1.0] {
            let mirror = sides.mirror(surface.as_ref(), side, share * length);
            // The side face is z + 0.3 r = constant.
            let [x, y, _] = mirror.point;
            let normal =
                [0.3 * x / x.hypot(y), 0.3 * y / x.hypot(y), 1.0].map(|part| sign * part / 1.09_f64.sqrt());
            let off = minus(normal, mirror.normal);
            assert!(dot(off, off).sqrt() < 2e-3, "{side} {share}: {off:?}");
            let near = surface.at((share * 0.99 + 0.005) * length, ends[side]).position;
            assert!(dot(minus(near, mirror.point), mirror.normal).abs() < 1e-4 * length);
        }
    }
}

#[test]
fn a_surface_in_other_coordinates_than_its_mesh_is_an_error() {
    let (model, _) = coarse().mapped_sector(same, bevel);
    let reversed: fn([f64; 2]) -> [f64; 2] = |[u, v]| [u, -v];
    for (coordinates, map) in [(reversed, bevel as fn([f64; 3]) -> [f64; 3]), (same, |at| at)] {
        let (_, surfaces) = coarse().mapped_sector(same, bevel);
        let other = coarse().mapped_surfaces(coordinates, map);
        let sources: Vec<SolidSurfaceSource> = surfaces
            .into_iter()
            .zip(other)
            .map(|(source, other)| SolidSurfaceSource { surface: other.surface, ..source })
            .collect();
        let options = SolidSplitOptions { samples: 8, ..SolidSplitOptions::default() };
        let found = ElasticSolid::ring(&model, &ring_source(TEETH), &sources, &options, &Interrupt::never());
        let expected = StructureError::CoordinatesDiffer { faces: "flank_0".into() };
        assert_eq!(found.err().map(|error| error.to_string()), Some(expected.to_string()));
    }
}
