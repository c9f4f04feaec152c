//! Strips of contact lines against half-spaces with pressure cells, and against Hertz's solution.

use crate::half_space::{Field, Reference};
use calyx_rolling::hertz::line;
use calyx_rolling::roller::strips::{Line, Strips, graded_strips};
use calyx_rolling::{Material, material::composite_modulus};

const LENGTH: f64 = 10e-3;
const DIAMETER: f64 = 10e-3;
const RADIUS: f64 = 4.2e-3;
const STRIPS: usize = 32;

fn modulus() -> f64 {
    composite_modulus(&Material::STEEL, &Material::STEEL)
}

fn logarithmic(x: f64) -> f64 {
    let relative = 2.0 * x / LENGTH;
    -0.00035 * DIAMETER * (1.0 - relative * relative).ln()
}

/// Mean of a function over an interval, by Gauss's rule.
fn mean(function: &dyn Fn(f64) -> f64, position: f64, length: f64) -> f64 {
    let points = gauss_points();
    points.iter().map(|(x, weight)| weight * function(position + 0.5 * length * x)).sum()
}

fn gauss_points() -> [(f64, f64); 4] {
    let (a, b) = (0.339_981_043_584_856_26, 0.861_136_311_594_052_6);
    let (p, q) = (0.652_145_154_862_546_1 / 2.0, 0.347_854_845_137_453_85 / 2.0);
    [(-b, q), (-a, p), (a, p), (b, q)]
}

fn strips(count: usize, images: f64, approach: &dyn Fn(f64) -> f64) -> Field {
    let line = Line::with_free_ends(graded_strips(LENGTH, count, |_| RADIUS), images);
    let contact = Strips::new(&[line], modulus(), |_, _| 0.0);
    let approaches: Vec<f64> =
        contact.strips().iter().map(|strip| mean(approach, strip.position, strip.length)).collect();
    let found = contact.loads(&approaches).expect("converged");
    let loads = found.loads.clone();
    let strips = contact.strips();
    Field {
        positions: strips.iter().map(|strip| strip.position).collect(),
        pressures: (0..count).map(|k| found.pressure(k)).collect(),
        load: loads.iter().zip(strips).map(|(load, strip)| load * strip.length).sum(),
        moment: loads.iter().zip(strips).map(|(load, strip)| load * strip.length * strip.position).sum(),
        loads,
    }
}

/// Mean of the reference over a strip.
fn over_strip(field: &Field, values: &[f64], position: f64, length: f64) -> f64 {
    let cell = field.positions[1] - field.positions[0];
    let mut sum = 0.0;
    for (x, value) in field.positions.iter().zip(values) {
        let start = (x - 0.5 * cell).max(position - 0.5 * length);
        let end = (x + 0.5 * cell).min(position + 0.5 * length);
        sum += value * (end - start).max(0.0);
    }
    sum / length
}

/// Errors of strips against pressure cells.
struct Errors {
    /// Relative error of the load.
    load: f64,
    /// Error of the position of the load relative to half of the length.
    position: f64,
    /// Largest error of the pressure relative to the largest pressure, at strips that are loaded
    /// over their whole length.
    pressure: f64,
    /// The same at the strips at both ends of the roller.
    ends: f64,
}

fn errors(images: f64, cells: usize, approach: &dyn Fn(f64) -> f64) -> Errors {
    let found = strips(STRIPS, images, approach);
    let most = found.loads.iter().copied().fold(0.0, f64::max);
    let half_width = 1.3 * line::half_width(most, RADIUS, modulus());
    let (radius, cells) = (RADIUS, [cells, 10]);
    let reference =
        Reference { length: LENGTH, radius, modulus: modulus(), images, approach, cells, half_width }.solve();
    let peak = reference.pressures.iter().copied().fold(0.0, f64::max);
    let loaded: Vec<usize> = (0..STRIPS).filter(|&k| found.loads[k] > 0.0).collect();
    let (first, last) = (loaded[0], loaded[loaded.len() - 1]);
    let (mut pressure, mut ends) = (0.0f64, 0.0f64);
    for (k, strip) in graded_strips(LENGTH, STRIPS, |_| RADIUS).iter().enumerate() {
        let mean = over_strip(&reference, &reference.pressures, strip.position, strip.length);
        let error = (found.pressures[k] - mean).abs() / peak;
        if k == 0 || k == STRIPS - 1 {
            ends = ends.max(error);
        } else if k > first + 1 && k + 1 < last {
            pressure = pressure.max(error);
        }
    }
    let arm = |field: &Field| field.moment / field.load;
    Errors {
        load: (found.load / reference.load - 1.0).abs(),
        position: (arm(&found) - arm(&reference)).abs() / (0.5 * LENGTH),
        pressure,
        ends,
    }
}

/// Light and heavy load, parallel and misaligned by 1 mrad, with and without free ends. Where the
/// contact ends within a strip, the pressure of the strip and of its neighbour are means of a steep
/// change, and are not compared.
#[test]
fn logarithmic_profile_has_the_pressure_of_half_spaces() {
    for (delta, tilt, images) in
        [(4e-6, 1e-3, 0.5), (10e-6, 0.0, 0.5), (10e-6, 1e-3, 0.0), (10e-6, 1e-3, 0.5), (25e-6, 1e-3, 0.5)]
    {
        let approach = move |x: f64| delta + tilt * x - logarithmic(x);
        let errors = errors(images, 250, &approach);
        let case =
            format!("{delta} {tilt} {images}: {} {} {}", errors.load, errors.position, errors.pressure);
        assert!(errors.load < 2e-3 && errors.position < 1e-3, "{case}");
        assert!(errors.pressure < 0.02, "{case}");
    }
}

/// The pressure of a straight profile is singular at the ends. The last strip has the mean pressure
/// over its length.
#[test]
fn straight_profile_has_the_edge_stress_of_half_spaces() {
    for (delta, tilt, images) in [(10e-6, 0.0, 0.0), (10e-6, 1e-3, 0.5), (25e-6, 0.0, 0.5)] {
        let errors = errors(images, 400, &move |x: f64| delta + tilt * x);
        let case = format!("{delta} {tilt} {images}: {} {} {}", errors.load, errors.pressure, errors.ends);
        assert!(errors.load < 3e-3 && errors.position < 1e-3, "{case}");
        assert!(errors.pressure < 0.02 && errors.ends < 0.04, "{case}");
    }
}

#[test]
fn long_line_has_the_half_width_and_pressure_of_hertz() {
    for delta in [2e-6, 20e-6] {
        let line = Line::with_free_ends(graded_strips(0.2, 64, |_| RADIUS), 0.0);
        let contact = Strips::new(&[line], modulus(), |_, _| 0.0);
        let found = contact.loads(&[delta; 64]).expect("converged");
        let load = found.loads[32];
        let (width, pressure) =
            (line::half_width(load, RADIUS, modulus()), line::pressure(load, RADIUS, modulus()));
        assert!((found.half_width(32) / width - 1.0).abs() < 1e-3);
        assert!((found.pressure(32) / pressure - 1.0).abs() < 1e-3);
    }
}

/// Loads converge with the number of strips.
#[test]
fn strips_converge() {
    let approach = |x: f64| 12e-6 + 8e-4 * x - logarithmic(x);
    let [coarse, usual, exact] = [16, 32, 128].map(|count| strips(count, 0.5, &approach).load);
    let errors = [coarse, usual].map(|load| (load / exact - 1.0).abs());
    assert!(errors[1] < 5e-4 && errors[0] < 4e-3, "{errors:?}");
}

/// Approaches through zero: the load vanishes continuously, and separated strips have none.
#[test]
fn contact_closes_continuously() {
    let mut former = 0.0;
    for k in 0..60 {
        let delta = 1e-12 * 1.5f64.powi(k) - 1e-12;
        let found = strips(32, 0.5, &|x| delta - logarithmic(x));
        assert!(found.load >= former && found.load < 1e11 * (delta + 1e-13), "{delta:e}");
        former = found.load;
    }
    assert_eq!(strips(32, 0.5, &|_| -1e-6).load, 0.0);
}

/// Shares and distances across the line of two points under semi-elliptic pressures, as the strips
/// have them.
const DISTANCES: [(f64, f64); 3] =
    [(0.161_448_01, 0.045_630_357_5), (0.515_307_92, 0.388_021_413_3), (0.323_244_07, 1.142_674_334_5)];

/// Double integral of 1/√(x² + s²) over two intervals, by second differences.
fn integral([a, b]: [f64; 2], [c, d]: [f64; 2], s: f64) -> f64 {
    let term = |x: f64| x.abs() * (x.abs() / s).asinh() - x.hypot(s);
    term(b - c) + term(a - d) - term(b - d) - term(a - c)
}

/// The loads deflect their strips by the approaches, with the interaction written out again at the
/// half-widths found: narrow and wide contacts, with and without images. All strips are near each
/// other. Strips within a contact that is much wider than long may be unloaded.
#[test]
fn loads_have_the_deflections_of_their_integrals() {
    let length = 0.14e-3;
    for images in [0.0, 0.5] {
        let strips = graded_strips(length, 8, |_| RADIUS);
        let contact = Strips::new(&[Line::with_free_ends(strips.clone(), images)], modulus(), |_, _| 0.0);
        let ends = |k: usize| {
            let half = 0.5 * strips[k].length;
            [strips[k].position - half, strips[k].position + half]
        };
        let mut widths = Vec::new();
        for delta in [1e-9, 1e-8, 1e-7, 1e-6, 4e-6] {
            let approach = |k: usize| delta * (1.0 + 1e3 * strips[k].position);
            let found = contact.loads(&[0, 1, 2, 3, 4, 5, 6, 7].map(approach)).expect("converged");
            widths.push(found.half_width(4) / strips[0].length);
            for i in (0..8).filter(|&i| found.loads[i] > 0.0) {
                let mut deflection = 0.0;
                for (j, load) in found.loads.iter().enumerate() {
                    let square = 0.5 * (found.half_width(i).powi(2) + found.half_width(j).powi(2));
                    let [start, end] = ends(j);
                    let image = |face: f64| [2.0 * face - end, 2.0 * face - start];
                    for (share, distance) in DISTANCES {
                        let s = distance * square.sqrt();
                        let both = integral(ends(i), image(0.5 * length), s)
                            + integral(ends(i), image(-0.5 * length), s);
                        deflection += share * load * (integral(ends(i), [start, end], s) + images * both);
                    }
                }
                let deflection = deflection / (std::f64::consts::PI * modulus() * strips[i].length);
                // The mean of y²/(2R) under a semi-elliptic pressure.
                let gap = found.half_width(i).powi(2) / (8.0 * RADIUS);
                let error = (deflection + gap - approach(i)).abs() / delta;
                assert!(error < 1e-11, "{delta:e} {images} strip {i}: {error:e}");
            }
        }
        assert!(widths[0] < 0.5 && widths[4] > 10.0, "{widths:?}");
    }
}
