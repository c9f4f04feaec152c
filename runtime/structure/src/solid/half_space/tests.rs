//! Means of 1/r over mollified loads, against closed forms and brute-force quadrature.

use super::*;
use crate::kernel::PairQuadrature;
use crate::solid::test_surface::ScrewedArc;
use std::f64::consts::PI;

fn modes(count: usize) -> AxialModes {
    AxialModes::new([-0.02, 0.02], count)
}

fn means(surface: &ScrewedArc, count: usize, mirrored: [bool; 2], smallest: f64) -> ReciprocalMeans {
    let screw = Screw::of(surface, [0.0, 0.01]).unwrap();
    ReciprocalMeans::new(screw, &modes(count), mirrored, smallest)
}

/// On a plane the mean over the axial range has a closed form, and the remaining integral is one of
/// logarithms.
#[test]
fn uniform_loads_on_a_plane_agree_with_closed_forms() {
    let surface = ScrewedArc::straight([-0.02, 0.02]);
    let pairs = [
        (Mollifier::new(0.004, 0.004, 0.001), Mollifier::new(0.004, 0.004, 0.001)),
        (Mollifier::new(0.004, 0.004, 0.001), Mollifier::new(0.0045, 0.0045, 0.0007)),
        (Mollifier::new(0.009, 0.009, 0.0001), Mollifier::new(0.0088, 0.0088, 0.00015)),
        (Mollifier::new(0.009, 0.009, 0.0001), Mollifier::new(0.002, 0.002, 0.0015)),
    ];
    let quadrature = PairQuadrature::default();
    let length: f64 = 0.04;
    for mirrored in [[false; 2], [true, false], [true; 2]] {
        let means = means(&surface, 3, mirrored, 1e-4);
        for (a, b) in &pairs {
            let smooth = |u: f64, other: f64| {
                let s = (u - other).abs();
                let root = |t: f64| s.hypot(t);
                // asinh(t / s) without its -ln s.
                let asinh = |t: f64| (t + root(t)).ln();
                let own = 2.0 * (length * asinh(length) - root(length) + s);
                let image = root(length) - s + 2.0 * length * (asinh(2.0 * length) - asinh(length))
                    - (root(2.0 * length) - root(length));
                own + image * f64::from(mirrored.map(u8::from).iter().sum::<u8>())
            };
            let sampled = |mollifier: &Mollifier| quadrature.sampled(mollifier, |u| u);
            let expected = (quadrature.mean(&sampled(a), &sampled(b), |u| u, smooth)
                - 2.0 * length * quadrature.logarithm(a, b))
                / length;
            let found = means.between(a, b)[(0, 0)];
            assert!((found / expected - 1.0).abs() < 5e-8, "{mirrored:?}: {found} against {expected}");
        }
    }
}

/// Returns panels that halve towards a point, down to a length.
fn towards(at: f64, [from, to]: [f64; 2], finest: f64) -> Vec<f64> {
    let mut ends = vec![from, to];
    for end in [from, to] {
        let mut distance = end - at;
        while distance.abs() > finest {
            distance *= 0.5;
            let cut = at + distance;
            if cut > from && cut < to {
                ends.push(cut);
            }
        }
    }
    if at > from && at < to {
        ends.push(at);
    }
    ends.sort_by(f64::total_cmp);
    ends
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

/// Computes the integral directly over all four variables, with panels that halve towards the
/// singularity.
fn by_brute_force(
    surface: &ScrewedArc,
    mirrored: [bool; 2],
    [a, b]: [&Mollifier; 2],
    [n, m]: [usize; 2],
    points: [usize; 2],
    finest: [f64; 2],
) -> f64 {
    let modes = modes(n.max(m) + 1);
    let [start, end] = modes.range();
    let distance = |u: f64, v: f64, other: f64, at: f64, mirror: Option<f64>| {
        let (p, mut q) = (surface.position(u, v), surface.position(other, at));
        if let Some(mirror) = mirror {
            q[2] = 2.0 * mirror - q[2];
        }
        (0..3).map(|axis| (p[axis] - q[axis]).powi(2)).sum::<f64>().sqrt()
    };
    let outer = [start, start + 0.001, 0.0, end - 0.001, end];
    let support = a.support();
    let mut breaks = support.to_vec();
    breaks.extend(b.support().into_iter().filter(|&u| u > support[0] && u < support[1]));
    breaks.sort_by(f64::total_cmp);
    integral(&outer, points[0], |v| {
        let observer = modes.values(v)[n];
        let along = towards(v, [start, end], finest[1]);
        integral(&breaks, points[0], |u| {
            let across = towards(u, b.support(), finest[0]);
            let weight = observer * a.value(u);
            integral(&along, points[1], |at| {
                let load = modes.values(at)[m];
                integral(&across, points[1], |other| {
                    let mut sum = 1.0 / distance(u, v, other, at, None);
                    for (mirror, there) in [start, end].into_iter().zip(mirrored) {
                        if there {
                            sum += 1.0 / distance(u, v, other, at, Some(mirror));
                        }
                    }
                    weight * load * b.value(other) * sum
                })
            })
        })
    })
}

#[test]
fn twisted_surfaces_agree_with_brute_force() {
    let surface = ScrewedArc::flank(0.3, [-0.02, 0.02]);
    let a = Mollifier::new(0.007, 0.007, 0.001);
    for (b, points, finest, tolerance) in [
        (Mollifier::new(0.002, 0.002, 0.0015), [10, 9], [0.01, 0.001], 2e-8),
        (Mollifier::new(0.0065, 0.0065, 0.0012), [7, 5], [2e-5, 2e-5], 1e-4),
    ] {
        for mirrored in [[false; 2], [true; 2], [false, true]] {
            let found = means(&surface, 3, mirrored, 1e-3).between(&a, &b);
            let scale = found[(0, 0)].abs();
            for pair in [[0, 0], [1, 2], [2, 1]] {
                if tolerance > 1e-6 && pair == [2, 1] {
                    continue;
                }
                let expected = by_brute_force(&surface, mirrored, [&a, &b], pair, points, finest);
                let error = (found[(pair[0], pair[1])] - expected) / scale;
                // Between the sampling points of the direction, the distance to images is
                // interpolated.
                let tolerance = if mirrored == [false; 2] { tolerance } else { f64::max(tolerance, 5e-7) };
                assert!(error.abs() < tolerance, "{mirrored:?} {pair:?}: {error:.1e}");
            }
        }
    }
}

#[test]
fn exchanging_load_and_observer_transposes() {
    let surface = ScrewedArc::flank(-0.4, [-0.02, 0.02]);
    let means = means(&surface, 4, [true; 2], 5e-4);
    let (a, b) = (Mollifier::new(0.007, 0.007, 0.0005), Mollifier::new(0.0066, 0.0065, 0.0012));
    let (there, back) = (means.between(&a, &b), means.between(&b, &a));
    let own = means.between(&a, &a);
    for n in 0..4 {
        for m in 0..4 {
            assert!((there[(n, m)] - back[(m, n)]).abs() < 1e-9 * there[(0, 0)]);
            assert!((own[(n, m)] - own[(m, n)]).abs() < 1e-9 * own[(0, 0)]);
        }
    }
    assert!(PI * own[(0, 0)] > 0.0);
}
