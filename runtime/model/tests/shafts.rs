//! Shafts against closed forms of the theory of beams, and against independent solutions of a
//! stepped shaft with two discs.

use calyx_fe::material::Material;
use calyx_model::shaft::{Shaft, ShaftSegment, shear_coefficient};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::PI;

const STEEL: Material = Material { youngs_modulus: 206e9, poissons_ratio: 0.3, density: 7850.0 };
const SHEAR_MODULUS: f64 = 206e9 / 2.6;

fn cylinder(length: f64, diameter: f64, bore: f64) -> ShaftSegment {
    ShaftSegment { length, diameter: [diameter; 2], bore: [bore; 2], stiffness_diameter: None }
}

fn shaft(segments: &[ShaftSegment]) -> Shaft {
    for segment in segments {
        segment.check().expect("a segment");
    }
    Shaft::new(segments.to_vec(), STEEL).expect("a shaft")
}

/// Stations of a shaft with springs and loads on single components.
struct Problem {
    stations: Vec<f64>,
    stiffness: DMatrix<f64>,
    load: DVector<f64>,
}

impl Problem {
    fn new(shaft: &Shaft, stations: &[f64]) -> Problem {
        let size = 6 * stations.len();
        Problem {
            stations: stations.to_vec(),
            stiffness: DMatrix::from_row_slice(size, size, &shaft.stiffness(stations)),
            load: DVector::zeros(size),
        }
    }

    /// Supports components of a station rigidly, or on springs.
    fn support(mut self, station: usize, components: &[usize], stiffness: f64) -> Problem {
        for component in components {
            self.stiffness[(6 * station + component, 6 * station + component)] += stiffness;
        }
        self
    }

    fn load(mut self, station: usize, load: [f64; 6]) -> Problem {
        for (component, load) in load.into_iter().enumerate() {
            self.load[6 * station + component] += load;
        }
        self
    }

    /// Returns the motions of the stations; rigid supports are very stiff springs.
    fn solve(self) -> Vec<[f64; 6]> {
        let solution = self.stiffness.clone().lu().solve(&self.load).expect("it is supported");
        let residual = &self.stiffness * &solution - &self.load;
        let refined = &solution - self.stiffness.lu().solve(&residual).expect("it is supported");
        (0..self.stations.len()).map(|k| std::array::from_fn(|c| refined[6 * k + c])).collect()
    }
}

/// Stiffness of supports that are rigid to within the accuracy of these tests.
const HARD: f64 = 1e20;

fn close(found: f64, expected: f64, tolerance: f64) {
    assert!((found / expected - 1.0).abs() < tolerance, "{found} instead of {expected}");
}

#[test]
fn shear_coefficients_are_those_of_cowper() {
    close(shear_coefficient(0.3, 0.0), 6.0 * 1.3 / (7.0 + 1.8), 1e-15);
    // A thin tube: 2 (1 + nu) / (4 + 3 nu).
    close(shear_coefficient(0.3, 1.0), 2.0 * 1.3 / 4.9, 1e-15);
    close(shear_coefficient(0.0, 0.0), 6.0 / 7.0, 1e-15);
}

#[test]
fn a_cantilever_deflects_by_bending_shear_tension_and_torsion() {
    let (length, diameter, bore) = (0.12, 0.04, 0.016);
    let shaft = shaft(&[cylinder(length, diameter, bore)]);
    let area = 0.25 * PI * (diameter * diameter - bore * bore);
    let inertia = PI / 64.0 * (diameter.powi(4) - bore.powi(4));
    let (e, g, kappa) = (206e9, SHEAR_MODULUS, shear_coefficient(0.3, bore / diameter));
    let end = |load: [f64; 6]| {
        let clamped = Problem::new(&shaft, &[0.0, length]).support(0, &[0, 1, 2, 3, 4, 5], HARD);
        clamped.load(1, load).solve()[1]
    };
    let bent = length.powi(3) / (3.0 * e * inertia) + length / (kappa * g * area);
    let slope = length * length / (2.0 * e * inertia);
    let moved = end([1e3, 0.0, 0.0, 0.0, 0.0, 0.0]);
    close(moved[0], 1e3 * bent, 1e-10);
    close(moved[4], 1e3 * slope, 1e-10);
    // A force along y rotates about -x.
    let moved = end([0.0, 1e3, 0.0, 0.0, 0.0, 0.0]);
    close(moved[1], 1e3 * bent, 1e-10);
    close(moved[3], -1e3 * slope, 1e-10);
    let moved = end([0.0, 0.0, 1e3, 0.0, 50.0, 70.0]);
    close(moved[2], 1e3 * length / (e * area), 1e-10);
    close(moved[0], 50.0 * slope, 1e-10);
    close(moved[4], 50.0 * length / (e * inertia), 1e-10);
    close(moved[5], 70.0 * length / (g * 2.0 * inertia), 1e-10);
}

/// Influence coefficients of a simply supported beam, including the overhang, with shear.
#[test]
fn a_simply_supported_hollow_shaft_has_textbook_influence_coefficients() {
    let (length, diameter, bore) = (0.3, 0.05, 0.02);
    let shaft = shaft(&[cylinder(length, diameter, bore)]);
    let area = 0.25 * PI * (diameter * diameter - bore * bore);
    let ei = 206e9 * PI / 64.0 * (diameter.powi(4) - bore.powi(4));
    let shear = (shear_coefficient(0.3, bore / diameter) * SHEAR_MODULUS * area).recip();
    let (a, span) = (0.07, 0.24);
    let b = span - a;
    let supported = Problem::new(&shaft, &[0.0, a, span, length]).support(0, &[0, 1, 2, 5], HARD).support(
        2,
        &[0, 1],
        HARD,
    );
    let moved = supported.load(1, [2e3, 0.0, 0.0, 0.0, 0.0, 0.0]).solve();
    // Shear bends the axis of the beam between the supports by P a b / (l kappa G A).
    let deflection = a * a * b * b / (3.0 * ei * span) + a * b / span * shear;
    close(moved[1][0], 2e3 * deflection, 1e-10);
    close(moved[0][4], 2e3 * a * b * (span + b) / (6.0 * ei * span), 1e-10);
    close(moved[2][4], -2e3 * a * b * (span + a) / (6.0 * ei * span), 1e-10);
    close(moved[1][4], 2e3 * a * b * (b - a) / (3.0 * ei * span), 1e-10);
    // The unloaded overhang stays straight.
    close(moved[3][0], moved[2][4] * (length - span), 1e-9);
}

/// The deflection of a stepped cantilever is a sum over its segments.
#[test]
fn steps_add_their_flexibilities() {
    let segments = [cylinder(0.05, 0.06, 0.0), cylinder(0.08, 0.04, 0.01), cylinder(0.03, 0.05, 0.02)];
    let shaft = shaft(&segments);
    let length: f64 = 0.16;
    let (mut deflection, mut slope, mut twist, mut from) = (0.0, 0.0, 0.0, 0.0);
    for segment in &segments {
        let ([d, _], [bore, _]) = (segment.diameter, segment.bore);
        let ei = 206e9 * PI / 64.0 * (d.powi(4) - bore.powi(4));
        let ga = shear_coefficient(0.3, bore / d) * SHEAR_MODULUS * 0.25 * PI * (d * d - bore * bore);
        let to = from + segment.length;
        let arm = |z: f64| length - z;
        deflection += (arm(from).powi(3) - arm(to).powi(3)) / (3.0 * ei) + segment.length / ga;
        slope += (arm(from).powi(2) - arm(to).powi(2)) / (2.0 * ei);
        twist += segment.length / (SHEAR_MODULUS * 2.0 * ei / 206e9);
        from = to;
    }
    let clamped = Problem::new(&shaft, &[0.0, length]).support(0, &[0, 1, 2, 3, 4, 5], HARD);
    let moved = clamped.load(1, [1e3, 0.0, 0.0, 0.0, 0.0, 60.0]).solve()[1];
    close(moved[0], 1e3 * deflection, 1e-10);
    close(moved[4], 1e3 * slope, 1e-10);
    close(moved[5], 60.0 * twist, 1e-10);
    // Additional stations do not change the solution: the condensation is exact.
    let clamped = Problem::new(&shaft, &[0.0, 0.02, 0.05, 0.09, 0.15, length]);
    let clamped = clamped.support(0, &[0, 1, 2, 3, 4, 5], HARD);
    let refined = clamped.load(5, [1e3, 0.0, 0.0, 0.0, 0.0, 60.0]).solve()[5];
    for component in [0, 4, 5] {
        close(refined[component], moved[component], 1e-9);
    }
}

/// Torsion, tension and bending by a moment of a cone have closed forms.
#[test]
fn a_taper_is_exact() {
    let (length, start, end) = (0.1, 0.03, 0.06);
    let cone = ShaftSegment { diameter: [start, end], ..cylinder(length, start, 0.0) };
    let shaft = shaft(&[cone]);
    let clamped = Problem::new(&shaft, &[0.0, length]).support(0, &[0, 1, 2, 3, 4, 5], HARD);
    let moved = clamped.load(1, [0.0, 0.0, 1e4, 0.0, 30.0, 80.0]).solve()[1];
    // Integral of D^-4 over a cone.
    let fourth = length / (3.0 * (end - start)) * (start.powi(-3) - end.powi(-3));
    close(moved[5], 80.0 * 32.0 / (PI * SHEAR_MODULUS) * fourth, 1e-12);
    close(moved[4], 30.0 * 64.0 / (PI * 206e9) * fourth, 1e-12);
    // The support yields too.
    close(moved[2], 1e4 * 4.0 * length / (PI * 206e9 * start * end) + 1e4 / HARD, 1e-12);
    // Short cylinders approach the cone, with an error that falls with the square of their length.
    let deflection = |shaft: &Shaft| {
        let clamped = Problem::new(shaft, &[0.0, length]).support(0, &[0, 1, 2, 3, 4, 5], HARD);
        clamped.load(1, [1e3, 0.0, 0.0, 0.0, 0.0, 0.0]).solve()[1][0]
    };
    let stepped = |count: usize| {
        let part = |k: usize| {
            let middle = start + (end - start) * (k as f64 + 0.5) / count as f64;
            cylinder(length / count as f64, middle, 0.0)
        };
        deflection(&self::shaft(&(0..count).map(part).collect::<Vec<_>>()))
    };
    let exact = deflection(&shaft);
    let errors = [20, 40].map(|count| (stepped(count) / exact - 1.0).abs());
    assert!(errors[1] < 1e-3 && (errors[0] / errors[1] - 4.0).abs() < 0.1, "{errors:?}");
}

#[test]
fn rigid_body_motions_cause_no_forces() {
    let segments = [cylinder(0.04, 0.03, 0.0), cylinder(0.06, 0.045, 0.01), cylinder(0.03, 0.03, 0.01)];
    let shaft = shaft(&segments);
    let stations = [0.0, 0.031, 0.055, 0.09, 0.13];
    let size = 6 * stations.len();
    let stiffness = DMatrix::from_row_slice(size, size, &shaft.stiffness(&stations));
    assert_eq!(stiffness, stiffness.transpose());
    for motion in 0..6 {
        let rigid = DVector::from_fn(size, |row, _| {
            let (z, component) = (stations[row / 6], row % 6);
            match (motion, component) {
                (one, other) if one == other => 1.0,
                (4, 0) => z,
                (3, 1) => -z,
                _ => 0.0,
            }
        });
        let scale = (0..size).map(|k| stiffness[(k, k)] * rigid[k].abs()).fold(0.0, f64::max);
        assert!((&stiffness * &rigid).amax() < 1e-13 * scale, "{motion}");
    }
}

/// Rigid-body motions have the kinetic energy of the whole shaft.
#[test]
fn the_mass_matrix_has_the_inertia_of_the_shaft() {
    let cone = ShaftSegment { diameter: [0.045, 0.03], bore: [0.01, 0.02], ..cylinder(0.06, 0.045, 0.01) };
    let shaft = shaft(&[cylinder(0.04, 0.03, 0.0), cone]);
    let stations = [0.012, 0.05, 0.08];
    let mass = DMatrix::from_row_slice(18, 18, &shaft.mass(&stations));
    let inertia = shaft.inertia();
    let energy = |of: fn(f64) -> [f64; 6]| {
        let motion = DVector::from_iterator(18, stations.iter().flat_map(|&z| of(z)));
        (motion.transpose() * &mass * motion)[(0, 0)]
    };
    let volume = 0.25 * PI * 0.04 * 0.03 * 0.03
        + PI / 12.0
            * 0.06
            * ((0.045_f64.powi(2) + 0.045 * 0.03 + 0.03 * 0.03) - (0.01 * 0.01 + 0.01 * 0.02 + 0.02 * 0.02));
    close(inertia.mass, 7850.0 * volume, 1e-12);
    close(energy(|_| [1.0, 0.0, 0.0, 0.0, 0.0, 0.0]), inertia.mass, 1e-9);
    close(energy(|_| [0.0, 0.0, 1.0, 0.0, 0.0, 0.0]), inertia.mass, 1e-9);
    close(energy(|_| [0.0, 0.0, 0.0, 0.0, 0.0, 1.0]), inertia.polar(), 1e-9);
    close(energy(|z| [z, 0.0, 0.0, 0.0, 1.0, 0.0]), inertia.about[1][1], 1e-9);
    close(energy(|z| [0.0, -z, 0.0, 1.0, 0.0, 0.0]), inertia.about[0][0], 1e-9);
}

/// A root circle carries the load of a spline; the mass is that of the whole section.
#[test]
fn the_teeth_of_a_spline_have_mass_and_no_stiffness() {
    let splined = ShaftSegment { stiffness_diameter: Some(0.03), ..cylinder(0.05, 0.035, 0.0) };
    let [splined, root, full] =
        [splined, cylinder(0.05, 0.03, 0.0), cylinder(0.05, 0.035, 0.0)].map(|s| shaft(&[s]));
    assert_eq!(splined.stiffness(&[0.0, 0.05]), root.stiffness(&[0.0, 0.05]));
    assert_eq!(splined.inertia(), full.inertia());
}

#[test]
fn impossible_segments_are_rejected() {
    let good = cylinder(0.05, 0.03, 0.01);
    let wrong = [
        (ShaftSegment { length: 0.0, ..good }, "length", "0 mm long"),
        (ShaftSegment { diameter: [-0.03, 0.03], ..good }, "diameter", "-30 mm"),
        (ShaftSegment { diameter: [0.03, f64::NAN], ..good }, "end_diameter", "diameter"),
        (ShaftSegment { bore: [0.03, 0.01], ..good }, "bore", "leaves no wall"),
        (ShaftSegment { bore: [0.01, 0.04], ..good }, "end_bore", "leaves no wall in a segment of 30 mm"),
        (
            ShaftSegment { stiffness_diameter: Some(0.01), ..good },
            "stiffness_diameter",
            "leaves no wall inside the `stiffness_diameter` of 10 mm",
        ),
        (
            ShaftSegment { stiffness_diameter: Some(0.04), ..good },
            "stiffness_diameter",
            "40 mm is larger than the diameter of 30 mm",
        ),
    ];
    for (segment, argument, message) in wrong {
        let error = segment.check().expect_err("an impossible segment");
        assert_eq!((error.code, error.argument), ("E0858", Some(argument)), "{error}");
        assert!(error.message.contains(message), "{error}");
    }
    assert_eq!(Shaft::new(Vec::new(), STEEL).expect_err("no segments").code, "E0858");
}

/// Stepped shaft with two bearings and two discs; its numbers are those of a transfer-matrix
/// solution of the equations of Timoshenko's beam, which shares no code with this one.
const POSITIONS: [f64; 9] = [0.0, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.56, 0.62];
const DIAMETERS: [f64; 8] = [0.03, 0.03, 0.045, 0.045, 0.05, 0.05, 0.035, 0.03];

fn stepped() -> Shaft {
    let ends = POSITIONS.windows(2).zip(DIAMETERS);
    shaft(&ends.map(|(ends, d)| cylinder(ends[1] - ends[0], d, 0.0)).collect::<Vec<_>>())
}

#[test]
fn a_gear_load_deflects_a_stepped_shaft() {
    let shaft = stepped();
    let problem = Problem::new(&shaft, &POSITIONS)
        .support(1, &[0, 1], 5e7)
        .support(7, &[0, 1], 8e7)
        .support(1, &[2], HARD)
        .support(8, &[5], HARD);
    // A force on a gear of pitch radius 60 mm at +x of the shaft, with its moment about the axis.
    let moved = problem.load(3, [-1500.0, 4000.0, 900.0, 0.0, -54.0, 240.0]).solve();
    let x = [
        1.3287881011911851e-05,
        -1.90588235294116e-05,
        -4.994153285843658e-05,
        -9.136949533779879e-05,
        -9.649985288634046e-05,
        -7.256326605208138e-05,
        -3.477709060283432e-05,
        -6.838235294117677e-06,
        2.1912682654000764e-05,
    ];
    let y = [
        -2.430360060139161e-05,
        5.647058823529433e-05,
        0.0001329070134799865,
        0.00022552073455103845,
        0.00022849065148432173,
        0.00016895101060513014,
        7.962730818832984e-05,
        1.4705882352941251e-05,
        -5.1961914749978075e-05,
    ];
    let slope_x = [-0.0006469340908264753, 0.0004791819658019744];
    let slope_y = [0.0016154837767337201, -0.001111129951715323];
    for (k, moved) in moved.iter().enumerate() {
        close(moved[0], x[k], 1e-9);
        close(moved[1], y[k], 1e-9);
    }
    for (end, station) in [(0, 0), (1, 8)] {
        close(moved[station][4], slope_x[end], 1e-9);
        close(-moved[station][3], slope_y[end], 1e-9);
    }
    close(moved[0][5], 0.005258950000809401, 1e-9);
    close(moved[4][5], 0.004506517719166574, 1e-9);
    close(moved[3][2], 5.83739812850533e-07, 1e-9);
    // Reactions follow from the levers: the shaft is statically determinate.
    close(-5e7 * moved[1][0], 952.9411764705883, 1e-9);
    close(-8e7 * moved[7][1], -1176.4705882352944, 1e-9);
    // Forces in the sections, from the forces of gear and bearings on the shaft.
    let stiffness = shaft.stiffness(&POSITIONS);
    let forces: Vec<[f64; 6]> = (0..9)
        .map(|k| {
            let row = |row: usize| (0..54).map(|c| stiffness[row * 54 + c] * moved[c / 6][c % 6]).sum();
            std::array::from_fn(|component| row(6 * k + component))
        })
        .collect();
    let in_span = shaft.section_forces(&POSITIONS, &forces, (0.15, false));
    close(in_span.bending_moment(), (952.9411764705883_f64.hypot(2823.5294117647054)) * 0.1, 1e-7);
    assert!(in_span.torque().abs() < 1e-6);
    close(shaft.section_forces(&POSITIONS, &forces, (0.2, true)).torque(), -240.0, 1e-7);
    // Motions between the stations are those that a station there would have.
    let coarse: Vec<usize> = vec![0, 1, 3, 7, 8];
    let (stations, motions): (Vec<f64>, Vec<[f64; 6]>) =
        coarse.iter().map(|&k| (POSITIONS[k], moved[k])).unzip();
    for k in [2, 4, 5, 6] {
        let between = shaft.motion_at(&stations, &motions, POSITIONS[k]);
        for component in [0, 1, 3, 4] {
            close(between[component], moved[k][component], 1e-8);
        }
    }
}

/// Lowest natural frequencies without rotation, of the same shaft with two discs.
#[test]
fn a_stepped_shaft_with_discs_has_the_natural_frequencies_of_a_continuous_beam() {
    let shaft = stepped();
    let mut stations: Vec<f64> = (0..=62).map(|k| 0.01 * f64::from(k)).collect();
    stations[62] = 0.62;
    let size = 6 * stations.len();
    let mut stiffness = DMatrix::from_row_slice(size, size, &shaft.stiffness(&stations));
    let mut mass = DMatrix::from_row_slice(size, size, &shaft.mass(&stations));
    for (station, k) in [(5, 5e7), (56, 8e7)] {
        for component in 0..2 {
            stiffness[(6 * station + component, 6 * station + component)] += k;
        }
    }
    for (station, m, diametral) in [(20, 8.2, 0.025), (40, 5.5, 0.014)] {
        for (component, inertia) in [m, m, m, diametral, diametral].into_iter().enumerate() {
            mass[(6 * station + component, 6 * station + component)] += inertia;
        }
    }
    // Bending in the plane of x only.
    let plane: Vec<usize> = (0..stations.len()).flat_map(|k| [6 * k, 6 * k + 4]).collect();
    let part = |matrix: &DMatrix<f64>| {
        DMatrix::from_fn(plane.len(), plane.len(), |i, j| matrix[(plane[i], plane[j])])
    };
    let lower = part(&mass).cholesky().expect("positive definite").l().try_inverse().expect("regular");
    let whole = &lower * part(&stiffness) * lower.transpose();
    let mut squares: Vec<f64> = whole.symmetric_eigenvalues().iter().copied().collect();
    squares.sort_by(f64::total_cmp);
    let exact =
        [1036.1269316179591, 3197.4442678492956, 6002.296351904817, 9422.924336101634, 11175.565757603617];
    for (square, exact) in squares.iter().zip(exact) {
        close(square.sqrt(), exact, 1e-4);
    }
}

/// The gyroscopic matrix is skew-symmetric to the bit. Rotations of the whole shaft give its polar
/// moment of inertia, from which displacements and rotations about the axis are free.
#[test]
fn the_gyroscopic_matrix_has_the_polar_inertia_of_the_shaft() {
    let shaft = shaft(&[
        cylinder(0.1, 0.04, 0.01),
        ShaftSegment { length: 0.15, diameter: [0.05, 0.03], bore: [0.01, 0.02], stiffness_diameter: None },
        cylinder(0.05, 0.03, 0.02),
    ]);
    let stations = [0.02, 0.1, 0.17, 0.28];
    let size = 6 * stations.len();
    let matrix = DMatrix::from_row_slice(size, size, &shaft.gyroscopic(&stations));
    assert_eq!(&matrix + matrix.transpose(), DMatrix::zeros(size, size));
    let polar = shaft.inertia().about[2][2];
    let rigid = DMatrix::from_fn(size, 6, |row, motion| {
        let (z, component) = (stations[row / 6], row % 6);
        match (motion, component) {
            (3, 1) => -z,
            (4, 0) => z,
            _ => f64::from(motion == component),
        }
    });
    let whole = rigid.transpose() * matrix * rigid;
    for row in 0..6 {
        for column in 0..6 {
            let expected = match (row, column) {
                (3, 4) => polar,
                (4, 3) => -polar,
                _ => 0.0,
            };
            assert!((whole[(row, column)] - expected).abs() < 1e-12 * polar, "{row} {column} {whole}");
        }
    }
}

/// Volume of a cell with two opposite faces of three or four corners, from tetrahedra around a
/// corner.
fn volume(corners: &[[f64; 3]]) -> f64 {
    let n = corners.len() / 2;
    let mut faces: Vec<Vec<usize>> = vec![(0..n).rev().collect(), (n..2 * n).collect()];
    faces.extend((0..n).map(|k| vec![k, (k + 1) % n, n + (k + 1) % n, n + k]));
    let triangles =
        faces.iter().flat_map(|face| (1..face.len() - 1).map(|k| [face[0], face[k], face[k + 1]]));
    let spanned = |triangle: [usize; 3]| {
        let [a, b, c] = triangle.map(|corner| {
            nalgebra::Vector3::from(std::array::from_fn(|axis| corners[corner][axis] - corners[0][axis]))
        });
        a.dot(&b.cross(&c)) / 6.0
    };
    triangles.map(spanned).sum()
}

/// The mesh of a picture fills a hollow and a solid segment, its stresses are the nominal ones, and
/// its displacements are those of the sections without the mean rotation.
#[test]
fn a_deformed_shaft_has_the_motions_and_the_nominal_stresses_of_its_sections() {
    let shaft = shaft(&[cylinder(0.05, 0.04, 0.016), cylinder(0.08, 0.03, 0.0)]);
    let stations = [0.0, 0.13];
    let load = [0.0, 900.0, 4e3, 0.0, 0.0, 50.0];
    let clamped = Problem::new(&shaft, &stations).support(0, &[0, 1, 2, 3, 4, 5], HARD);
    let motions = clamped.load(1, load).solve();
    // The moment of the force about the clamped end is about -x.
    let reaction = [0.0, -900.0, -4e3, 900.0 * 0.13, 0.0, -50.0];
    let forces = [reaction, load];
    let found = shaft.deformed(&stations, &motions, &forces);

    let around = 24.0 / (2.0 * PI) * (2.0 * PI / 24.0_f64).sin();
    let expected =
        around * 0.25 * PI * (0.05 * (0.04_f64.powi(2) - 0.016_f64.powi(2)) + 0.08 * 0.03_f64.powi(2));
    let volumes = found
        .cells
        .iter()
        .map(|(_, nodes)| volume(&nodes.iter().map(|&node| found.points[node]).collect::<Vec<_>>()));
    assert!(volumes.clone().all(|volume| volume > 0.0));
    close(volumes.sum(), expected, 1e-12);

    let von_mises = |[_, _, zz, yz, zx, _]: [f64; 6]| (zz * zz + 3.0 * (yz * yz + zx * zx)).sqrt();
    for (z, after) in [(0.0, true), (0.05, false), (0.05, true)] {
        let section = shaft.section_forces(&stations, &forces, (z, after));
        let [.., equivalent] = shaft.nominal_stress((z, after), &section);
        let radius = 0.5 * if after && z > 0.0 { 0.03 } else { 0.04 };
        let there = |point: &[f64; 3]| {
            (point[2] - z).abs() < 1e-12 && (point[0].hypot(point[1]) - radius).abs() < 1e-12
        };
        let largest = found.points.iter().zip(&found.stresses).filter(|(point, _)| there(point));
        close(largest.map(|(_, &stress)| von_mises(stress)).fold(0.0, f64::max), equivalent, 1e-12);
    }

    // The shaft bends towards +y, so +y is compressed, less than without the tension; the torque
    // shears +x towards +y.
    let stress_at = |x: f64, y: f64| {
        let section = shaft.section_forces(&stations, &forces, (0.0, true));
        shaft.section_stress((0.0, true), &section, [x, y])
    };
    let (bending, tension) = (
        900.0 * 0.13 * 0.02 / (PI / 64.0 * (0.04_f64.powi(4) - 0.016_f64.powi(4))),
        4e3 / (0.25 * PI * (0.04_f64.powi(2) - 0.016_f64.powi(2))),
    );
    close(stress_at(0.0, 0.02)[2], tension - bending, 1e-12);
    close(stress_at(0.0, -0.02)[2], tension + bending, 1e-12);
    let torsion = 50.0 * 0.02 / (PI / 32.0 * (0.04_f64.powi(4) - 0.016_f64.powi(4)));
    close(stress_at(0.02, 0.0)[3], torsion, 1e-12);
    close(stress_at(0.0, 0.02)[4], -torsion, 1e-12);

    let mean_rotation = 0.5 * (motions[0][5] + motions[1][5]);
    for ([x, y, z], displacement) in found.points.iter().zip(&found.displacements) {
        let [ux, uy, uz, tx, ty, tz] = shaft.motion_at(&stations, &motions, *z);
        let tz = tz - mean_rotation;
        let section = [ux - tz * y, uy + tz * x, uz + tx * y - ty * x];
        assert!(section.iter().zip(displacement).all(|(one, other)| (one - other).abs() < 1e-15));
    }
}
