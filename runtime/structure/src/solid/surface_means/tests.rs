//! Means of `1/r` on surfaces with a varying metric, against those of helical surfaces and
//! brute-force quadrature.

use super::*;
use crate::solid::Mirror;
use crate::solid::half_space::ReciprocalMeans;
use crate::solid::screw::Screw;
use crate::solid::test_surface::{MappedSurface, ScrewedArc};

const RANGE: [f64; 2] = [-0.02, 0.02];

fn axial() -> [Vector; 2] {
    [[0.0, 0.0, -1.0], [0.0, 0.0, 1.0]]
}

fn mollifiers() -> [Mollifier; 4] {
    [(0.007, 0.001), (0.0065, 0.0012), (0.002, 0.0015), (0.0095, 0.0002)]
        .map(|(at, width)| Mollifier::new(at, at, width))
}

#[test]
fn flanks_of_helical_gears_agree_with_their_own_integral() {
    for tangent in [0.0, 0.5] {
        let surface = ScrewedArc::flank(tangent, RANGE);
        let modes = AxialModes::new(RANGE, 6);
        let screw = Screw::of(&surface, [0.0, 0.01]).unwrap();
        for sides in [None, Some(SideFaces::plane([0.0, 0.01], axial()))] {
            let shorter = ReciprocalMeans::new(screw.clone(), &modes, [sides.is_some(); 2], 2e-4);
            let general = SurfaceMeans::new(&surface, [0.0, 0.01], &modes, sides.as_ref(), 2e-4);
            let mut worst = 0.0_f64;
            for a in &mollifiers() {
                for b in &mollifiers() {
                    let (expected, found) = (shorter.between(a, b), general.between(a, b));
                    for n in 0..6 {
                        for m in 0..6 {
                            let error = (found[(n, m)] - expected[(n, m)]) / expected[(0, 0)];
                            worst = worst.max(error.abs());
                        }
                    }
                }
            }
            assert!(worst < 2e-5, "{tangent} {}: {worst:.1e}", sides.is_some());
        }
    }
}

/// Returns a flank that tapers towards an apex and curves along the face, in coordinates whose
/// lines are neither equally spaced nor normal to each other.
fn tapered() -> MappedSurface<ScrewedArc> {
    MappedSurface {
        base: ScrewedArc::flank(0.3, RANGE),
        range: [[0.0, 0.01], RANGE],
        coordinates: |[u, v]| [u, v + 6.0 * v * v],
        map: |[x, y, z]| {
            let scale = 1.0 + 12.0 * z;
            [scale * x, scale * y + 8.0 * z * z, z + 0.2 * x]
        },
    }
}

/// Returns the side faces of that surface as far as the integral knows them: planes through its
/// ends with some normals.
fn sides() -> SideFaces {
    let normal = |sign: f64| calyx_numerics::vec3::unit([-0.3 * sign, 0.1, sign]);
    SideFaces::plane([0.0, 0.01], [normal(-1.0), normal(1.0)])
}

fn integral(ends: &[f64], points: usize, mut f: impl FnMut(f64) -> f64) -> f64 {
    let rule = gauss_legendre(points);
    ends.windows(2)
        .map(|pair| {
            let half = 0.5 * (pair[1] - pair[0]);
            rule.iter().map(|(x, weight)| half * weight * f(pair[0] + half * (1.0 + x))).sum::<f64>()
        })
        .sum()
}

/// Returns the ends of panels that halve towards a point, down to a length.
fn towards(at: f64, [from, to]: [f64; 2], finest: f64) -> Vec<f64> {
    let mut ends = vec![from, to, at.clamp(from, to)];
    for end in [from, to] {
        let mut distance = end - at;
        while distance.abs() > finest {
            distance *= 0.5;
            ends.extend([at + distance].into_iter().filter(|cut| (from..to).contains(cut)));
        }
    }
    ends.sort_by(f64::total_cmp);
    ends
}

/// Computes the integral directly over all four variables, over the positions of the surface.
fn by_brute_force(
    surface: &MappedSurface<ScrewedArc>,
    sides: Option<&SideFaces>,
    [a, b]: [&Mollifier; 2],
    [n, m]: [usize; 2],
    points: [usize; 2],
    finest: [f64; 2],
) -> f64 {
    let modes = AxialModes::new(RANGE, n.max(m) + 1);
    let ends = [RANGE[0], RANGE[0] + 0.001, 0.0, RANGE[1] - 0.001, RANGE[1]];
    let mut breaks = a.support().to_vec();
    breaks.extend(b.support().into_iter().filter(|u| (a.support()[0]..a.support()[1]).contains(u)));
    breaks.sort_by(f64::total_cmp);
    let apart = |p: Vector, q: Vector| length([p[0] - q[0], p[1] - q[1], p[2] - q[2]]);
    integral(&ends, points[0], |v| {
        let observer = modes.values(v)[n];
        let along = towards(v, RANGE, finest[1]);
        integral(&breaks, points[0], |u| {
            let across = towards(u, b.support(), finest[0]);
            let own = surface.position(u, v);
            integral(&across, points[1], |other| {
                let mirrors: Vec<Mirror> = sides
                    .map(|sides| [0, 1].map(|side| sides.mirror(surface, side, 0.5 * (u + other))).to_vec())
                    .unwrap_or_default();
                let weight = observer * a.value(u) * b.value(other);
                integral(&along, points[1], |at| {
                    let there = surface.position(other, at);
                    let images = mirrors.iter().map(|mirror| 1.0 / apart(own, mirror.image(there)));
                    weight * modes.values(at)[m] * (1.0 / apart(own, there) + images.sum::<f64>())
                })
            })
        })
    })
}

#[test]
fn tapered_surfaces_agree_with_brute_force() {
    let surface = tapered();
    let a = Mollifier::new(0.007, 0.007, 0.001);
    for (b, points, finest, tolerance) in [
        (Mollifier::new(0.002, 0.002, 0.0015), [10, 9], [0.01, 0.001], 5e-6),
        (Mollifier::new(0.0065, 0.0065, 0.0012), [6, 4], [4e-5, 4e-5], 3e-4),
    ] {
        for sides in [None, Some(sides())] {
            let modes = AxialModes::new(RANGE, 3);
            let means = SurfaceMeans::new(&surface, [0.0, 0.01], &modes, sides.as_ref(), 1e-3);
            let found = means.between(&a, &b);
            for pair in [[0, 0], [1, 2]] {
                let expected = by_brute_force(&surface, sides.as_ref(), [&a, &b], pair, points, finest);
                let error = (found[(pair[0], pair[1])] - expected) / found[(0, 0)];
                assert!(error.abs() < tolerance, "{} {pair:?}: {error:.1e}", sides.is_some());
            }
        }
    }
}

#[test]
fn exchanging_load_and_observer_transposes_and_a_larger_body_is_stiffer_by_its_size() {
    let surface = tapered();
    let modes = AxialModes::new(RANGE, 4);
    let means = SurfaceMeans::new(&surface, [0.0, 0.01], &modes, Some(&sides()), 5e-4);
    let (a, b) = (Mollifier::new(0.007, 0.007, 0.0005), Mollifier::new(0.0066, 0.0065, 0.0012));
    let (there, back, own) = (means.between(&a, &b), means.between(&b, &a), means.between(&a, &a));
    let doubled = MappedSurface { map: |at| (tapered().map)(at).map(|part| 2.0 * part), ..tapered() };
    let larger = SurfaceMeans::new(&doubled, [0.0, 0.01], &modes, Some(&sides()), 5e-4).between(&a, &b);
    for n in 0..4 {
        for m in 0..4 {
            assert!((there[(n, m)] - back[(m, n)]).abs() < 1e-13 * there[(0, 0)]);
            assert!((own[(n, m)] - own[(m, n)]).abs() < 1e-13 * own[(0, 0)]);
            assert!((0.5 * there[(n, m)] - larger[(n, m)]).abs() < 1e-13 * there[(0, 0)]);
        }
    }
}

/// The coordinates along the face have another unit and another origin.
#[test]
fn units_of_the_coordinates_do_not_matter() {
    let surface = tapered();
    let scaled = MappedSurface {
        range: [[0.0, 1.0], [0.0, 1.0]],
        coordinates: |[u, v]| (tapered().coordinates)([0.01 * u, 0.04 * v - 0.02]),
        ..tapered()
    };
    let (a, b) = (Mollifier::new(0.007, 0.007, 0.0005), Mollifier::new(0.0066, 0.0065, 0.0012));
    let [c, d] = [&a, &b].map(|of| {
        let s = if of.width < 1e-3 { 0.7 } else { 0.66 };
        Mollifier::new(s, 100.0 * of.center, 100.0 * of.width)
    });
    let count = 4;
    let own = SurfaceMeans::new(&surface, [0.0, 0.01], &AxialModes::new(RANGE, count), Some(&sides()), 5e-4);
    let normals = sides();
    let plane = |side: usize| normals.normal(side, 0.0);
    let others = SideFaces::plane([0.0, 1.0], [plane(0), plane(1)]);
    let other =
        SurfaceMeans::new(&scaled, [0.0, 1.0], &AxialModes::new([0.0, 1.0], count), Some(&others), 0.05);
    let (own, other) = (own.between(&a, &b), other.between(&c, &d));
    for n in 0..count {
        for m in 0..count {
            // The polynomials are normalized over the range.
            let error = own[(n, m)] - 0.04 * other[(n, m)];
            assert!(error.abs() < 1e-7 * own[(0, 0)], "{n} {m}: {error}");
        }
    }
}
