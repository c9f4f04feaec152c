//! Tests of half-space contact against Hertz, from surfaces to peak pressure.

use super::test_surfaces::Cap;
use super::*;
use crate::active_set::solve_until;
use crate::problem::{ContactProblem, Solution};
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::vec3::{Vector, cross, unit};
use calyx_structure::Chart;
use calyx_structure::solid::{HalfSpaceBody, Mirror};
use std::f64::consts::PI;

/// Two caps pressed together along their common normal by a force.
struct Press {
    caps: [Cap; 2],
    poses: [Pose; 2],
    mirrors: Vec<Mirror>,
    modulus: f64,
    force: f64,
    half_counts: [usize; 2],
    /// Whether the grid is fitted to the loaded part, as for gears on general axes.
    fitted: bool,
}

struct Pressed {
    grid: Grid,
    pressures: Vec<f64>,
    solution: Solution,
}

/// A flat surface facing upwards, and a cap of these radii on it.
fn press(radii: [f64; 2], modulus: f64, force: f64) -> Press {
    let half = [0.5 * radii[0]; 2];
    let flat = Cap { radii: [f64::INFINITY; 2], faces: 1.0, half, turn: 0.0 };
    Press {
        caps: [flat, Cap { radii, faces: -1.0, half, turn: 0.4 }],
        poses: [Pose::IDENTITY; 2],
        mirrors: Vec::new(),
        modulus,
        force,
        half_counts: [12, 12],
        fitted: false,
    }
}

impl Press {
    fn placed(&self, side: usize) -> PlacedSurface<'_> {
        PlacedSurface { surface: &self.caps[side], pose: self.poses[side] }
    }

    fn contact_line(&self) -> ContactLine {
        find_contact_line(self.placed(0), self.placed(1), true).expect("they face each other")
    }

    fn run(&self) -> Pressed {
        let contact_line = self.contact_line();
        let mut options = GridOptions {
            half_count: self.half_counts[0],
            half_slices: self.half_counts[1],
            size: GridSize::default(),
            force: self.force,
            contact_modulus: self.modulus,
            search_edges: true,
            local_normals: false,
            under_load: false,
        };
        let body = HalfSpaceBody::half_space(Vec::new(), 1, 2.0 * self.modulus).between(self.mirrors.clone());
        for _ in 0..4 {
            let grid =
                build_grid(self.placed(0), self.placed(1), &contact_line, &options, &Interrupt::never())
                    .unwrap();
            let chart = Chart { tooth: 0, surface: 0 };
            let side = |k: usize| Side { body: k, structure: &body, chart, pose: self.poses[k] };
            let patch = PatchCells {
                sides: [side(0), side(1)],
                frame: &grid.frame,
                cells: &grid.cells,
                beside_faces: grid.beside_faces,
            };
            let n = grid.cells.len();
            let problem = ContactProblem {
                compliance: compliance(&[patch], Entries::All, &Interrupt::never()).expect("no interrupt"),
                arms: vec![grid.frame.translation_arm(1, grid.frame.normal); n],
                gaps: grid.cells.iter().map(|cell| cell.gap).collect(),
                stiffness: vec![0.0],
                load: vec![-self.force],
            };
            let never = Interrupt::never();
            let guess = first_guess(&problem, &[&grid], &never);
            let solution = solve_until(&problem, Some(&guess), &never).expect("it is well posed");
            assert!(solution.certificate.largest() <= 1e-12, "{:?}", solution.certificate);
            let pressures = pressures(&grid.cells, &solution.forces);
            let mut recommended = assess(&grid, &pressures).recommended;
            if self.fitted && recommended == GridSize::default() {
                recommended = fitting_size(&grid, &pressures);
            }
            if recommended == GridSize::default() {
                // The start of the search must not change a bit of the solution.
                let cold = solve_until(&problem, None, &never).expect("it is well posed");
                assert_eq!(cold.forces, solution.forces);
                check_entries_in_contact(&patch, &grid, &problem, &solution.active);
                return Pressed { grid, pressures, solution };
            }
            let GridSize { width, along } = options.size;
            options.size = GridSize {
                width: recommended.width.or(width).or(self.fitted.then_some(grid.width)),
                along: recommended.along.or(along).or(self.fitted.then_some(grid.along)),
            };
        }
        panic!("the grid does not settle");
    }
}

/// Entries between the cells in contact and those of the slices at the ends are those of the whole
/// matrix, apart from the interpolation of distant strips, whose ends depend on the cells wanted. Its
/// relative error is up to 1e-9, of entries that are small compared to the diagonal.
fn check_entries_in_contact(patch: &PatchCells, grid: &Grid, problem: &ContactProblem, active: &[usize]) {
    let n = grid.cells.len();
    let mut wanted = vec![false; n];
    active.iter().for_each(|&cell| wanted[cell] = true);
    let ends = [grid.slices.first(), grid.slices.last()].into_iter().flatten();
    ends.for_each(|slice| wanted[slice.cells.clone()].fill(true));
    let some = compliance(&[*patch], Entries::Between(&[wanted.clone()]), &Interrupt::never());
    let some = some.expect("no interrupt");
    for (entry, (some, all)) in some.iter().zip(&problem.compliance).enumerate() {
        if wanted[entry / n] && wanted[entry % n] {
            let diagonal = problem.compliance[entry / n * (n + 1)];
            assert!((some - all).abs() < 1e-10 * diagonal, "{} {}: {some:e} {all:e}", entry / n, entry % n);
        }
    }
}

impl Pressed {
    fn peak(&self) -> f64 {
        peak(&self.grid, &self.pressures).expect("it is loaded").pressure
    }

    fn sink(&self) -> f64 {
        -self.solution.motion[0]
    }
}

/// Hertzian contact ellipse (Johnson, Contact Mechanics, eqs. 4.24 to 4.26).
#[derive(Debug)]
struct Ellipse {
    /// Semi-axes, ascending.
    axes: [f64; 2],
    peak: f64,
    approach: f64,
}

/// Complete elliptic integrals K and E by the arithmetic-geometric mean, for the complementary
/// modulus.
fn elliptic(complement: f64) -> [f64; 2] {
    let (mut a, mut b, mut power) = (1.0, complement, 0.5);
    let mut sum = power * (1.0 - complement * complement);
    while (a - b).abs() > 1e-15 * a {
        let c = 0.5 * (a - b);
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
        power *= 2.0;
        sum += power * c * c;
    }
    let k = PI / (2.0 * a);
    [k, k * (1.0 - sum)]
}

impl Ellipse {
    /// `radii` of the relative curvatures, ascending.
    fn new(radii: [f64; 2], modulus: f64, force: f64) -> Self {
        // Ratio of curvatures for a ratio of axes b / a; both decrease together.
        let curvatures = |ratio: f64| {
            let [k, e] = elliptic(ratio);
            (e / (ratio * ratio) - k) / (k - e)
        };
        let wanted = radii[1] / radii[0];
        let ratio = if wanted - 1.0 < 1e-12 {
            1.0
        } else {
            let (mut low, mut high) = (1e-6f64, 1.0 - 1e-7);
            for _ in 0..200 {
                let middle = (low * high).sqrt();
                if curvatures(middle) > wanted { low = middle } else { high = middle }
            }
            low
        };
        let [k, e] = elliptic(ratio);
        // Curvature along the long axis: p0 / E* b / (a² e²) (K - E), with p0 = 3 F / (2 pi a b).
        let shape = if ratio == 1.0 { PI / 4.0 } else { (k - e) / (1.0 - ratio * ratio) };
        let a = (3.0 * force * shape * radii[1] / (PI * modulus)).cbrt();
        let peak = 3.0 * force / (2.0 * PI * a * a * ratio);
        Ellipse { axes: [ratio * a, a], peak, approach: peak / modulus * ratio * a * k }
    }

    fn assert_like(&self, pressed: &Pressed, tolerance: f64, about: &str) {
        let axes = half_axes(&pressed.grid, &pressed.pressures).expect("it is resolved");
        let errors = [
            pressed.peak() / self.peak - 1.0,
            axes[0] / self.axes[0] - 1.0,
            axes[1] / self.axes[1] - 1.0,
            pressed.sink() / self.approach - 1.0,
        ];
        assert!(errors.iter().all(|error| error.abs() < tolerance), "{about}: {errors:?}");
    }
}

/// F = 1000, E = 3e7, nu = 0.3: radii of relative curvature, semi-axes, peak pressure, approach.
const ELLIPSES: [([f64; 2], [f64; 2], f64, f64); 3] = [
    ([1.0, 1.0], [0.0357001849096078, 0.0357001849096078], 374628.191054424, 0.00127450320258019),
    ([1.0, 5.0], [0.0265508385833375, 0.0767367302653191], 234347.245853456, 0.000941326091920456),
    ([1.0, 100.0], [0.014692848804862, 0.267220354641938], 121609.034585779, 0.000464973492676082),
];
const MODULUS: f64 = 16483516.4835165;

#[test]
fn the_ellipse_of_the_tests_is_hertz_s() {
    for (radii, axes, peak, approach) in ELLIPSES {
        let ellipse = Ellipse::new(radii, MODULUS, 1000.0);
        assert!((ellipse.peak / peak - 1.0).abs() < 1e-6, "{ellipse:?}");
        assert!(
            (ellipse.axes[0] / axes[0] - 1.0).abs() < 1e-6 && (ellipse.axes[1] / axes[1] - 1.0).abs() < 1e-6
        );
        assert!((ellipse.approach / approach - 1.0).abs() < 1e-6);
    }
}

#[test]
fn ellipses_of_contact_are_hertz_s() {
    for (ratio, aspect) in [(1.0, 1.0), (1.5, 1.3), (5.0, 2.9), (30.0, 9.0), (100.0, 18.0), (600.0, 50.0)] {
        let radii = [1.0, ratio];
        let ellipse = Ellipse::new(radii, MODULUS, 1000.0);
        assert!((ellipse.axes[1] / ellipse.axes[0] / aspect - 1.0).abs() < 0.06, "{ellipse:?}");
        let pressed = press(radii, MODULUS, 1000.0).run();
        ellipse.assert_like(&pressed, 0.01, &format!("{radii:?}"));
    }
}

/// The grid of gear meshes, under light and heavy load.
#[test]
fn the_default_grid_is_accurate_for_all_shapes() {
    for ratio in [1.0, 1.5, 5.0, 30.0, 100.0, 600.0] {
        let radii = [1.0, ratio];
        for force in [1.0, 1000.0] {
            let ellipse = Ellipse::new(radii, MODULUS, force);
            let pressed = Press { half_counts: [10, 8], fitted: true, ..press(radii, MODULUS, force) }.run();
            let errors = [pressed.peak() / ellipse.peak - 1.0, pressed.sink() / ellipse.approach - 1.0];
            assert!(errors.iter().all(|error| error.abs() < 4e-3), "{ratio} {force}: {errors:?}");
            ellipse.assert_like(&pressed, 0.02, &format!("{ratio} {force}"));
        }
    }
}

#[test]
fn loads_and_sizes_of_all_magnitudes() {
    // The same contact in other units: radii from a micrometre to a kilometre, forces from 1e-6 to
    // 1e6.
    for (radius, strain) in [(1e-6, 1e-5), (1.0, 1e-12), (1e3, 1e-6), (0.01, 1e-4)] {
        let force = strain * MODULUS * radius * radius;
        let radii = [radius, 3.0 * radius];
        Ellipse::new(radii, MODULUS, force).assert_like(&press(radii, MODULUS, force).run(), 0.01, "sizes");
    }
    for force in [1e-6, 1e-3, 1.0, 1e6] {
        let (radii, modulus) = ([0.05, 0.2], 1.1e14);
        Ellipse::new(radii, modulus, force).assert_like(&press(radii, modulus, force).run(), 0.01, "forces");
    }
}

#[test]
fn units_do_not_matter() {
    // Inches and pounds against metres and newtons, and against millimetres.
    let (inch, pound) = (0.0254, 4.4482216152605);
    let base = press([1.0, 4.0], MODULUS, 1000.0).run();
    for (length, force) in [(inch, pound), (1e3 * inch, pound)] {
        let modulus = MODULUS * force / (length * length);
        let other = press([length, 4.0 * length], modulus, 1000.0 * force).run();
        assert_eq!(other.grid.cells.len(), base.grid.cells.len());
        assert!((other.sink() / (base.sink() * length) - 1.0).abs() < 1e-9);
        for (own, others) in base.solution.forces.iter().zip(&other.solution.forces) {
            assert!((own * force - others).abs() < 1e-9 * force * 10.0, "{own} {others}");
        }
    }
}

/// Rotation whose columns are right-handed unit vectors, the first near `first`.
fn rotation(first: Vector, second: Vector) -> [Vector; 3] {
    let x = unit(first);
    let z = unit(cross(x, second));
    let y = cross(z, x);
    [0, 1, 2].map(|k| [x[k], y[k], z[k]])
}

#[test]
fn neither_place_nor_order_of_the_bodies_matters() {
    let upright = press([1.0, 4.0], MODULUS, 1000.0);
    let base = upright.run();
    let pose = Pose { rotation: rotation([1.0, -2.0, 0.7], [0.3, 0.1, 2.0]), origin: [5.0, -3.0, 1.0] };
    let turned = Press { poses: [pose; 2], ..press([1.0, 4.0], MODULUS, 1000.0) }.run();
    let mut exchanged = press([1.0, 4.0], MODULUS, 1000.0);
    exchanged.caps.reverse();
    for (other, about) in [(turned, "turned"), (exchanged.run(), "exchanged")] {
        assert_eq!(other.grid.cells.len(), base.grid.cells.len(), "{about}");
        assert!(
            (other.peak() / base.peak() - 1.0).abs() < 1e-7,
            "{about}: {}",
            other.peak() / base.peak() - 1.0
        );
        assert!(
            (other.sink() / base.sink() - 1.0).abs() < 1e-8,
            "{about}: {}",
            other.sink() / base.sink() - 1.0
        );
    }
}

#[test]
fn crossed_cylinders_are_as_long_as_their_relative_curvatures_say() {
    // Cylinders of equal radius, crossed at 2 gamma: relative curvatures (1 ± cos 2 gamma) / R
    // (Johnson, eq. 4.4).
    let radius = 1.0;
    for gamma in [0.25 * PI, 0.6, 0.3] {
        let cylinder =
            |faces: f64, turn: f64| Cap { radii: [radius, f64::INFINITY], faces, half: [0.5; 2], turn };
        let crossed = Press {
            caps: [cylinder(1.0, gamma), cylinder(-1.0, -gamma)],
            ..press([radius, radius], MODULUS, 1000.0)
        };
        let cosine = (2.0 * gamma).cos();
        let radii = [radius / (1.0 + cosine), radius / (1.0 - cosine)];
        let pressed = crossed.run();
        Ellipse::new(radii, MODULUS, 1000.0).assert_like(&pressed, 0.01, &format!("{gamma}"));
        // The contact line bisects the angle between the axes.
        assert!(pressed.grid.frame.along[1].abs() > 0.999 || gamma > 0.78, "{:?}", pressed.grid.frame);
    }
}

#[test]
fn finer_grids_come_nearer() {
    let radii = [1.0, 5.0];
    let ellipse = Ellipse::new(radii, MODULUS, 1000.0);
    let error = |half: usize| {
        let pressed = Press { half_counts: [half; 2], ..press(radii, MODULUS, 1000.0) }.run();
        (pressed.peak() / ellipse.peak - 1.0).abs().max((pressed.sink() / ellipse.approach - 1.0).abs())
    };
    let (coarse, fine) = (error(4), error(18));
    // Convergence is faster than first order for a reduction of the cell size to a quarter.
    assert!(fine < coarse / 6.0 && coarse < 0.03, "{coarse} {fine}");
}

#[test]
fn a_long_cylinder_between_faces_is_a_line_contact() {
    // Image loads in both side faces make the ends of a cylinder behave like its middle, except for
    // images of images.
    let (radius, modulus, half_length, line_load) = (0.02, 1.1e11, 0.01, 3e5);
    let half = [0.5 * radius, half_length];
    let cylinder = |faces: f64, radius: f64| Cap { radii: [radius, f64::INFINITY], faces, half, turn: 0.0 };
    let face = |y: f64| Mirror { point: [0.0, y, 0.0], normal: [0.0, 1.0, 0.0] };
    let between = Press {
        caps: [cylinder(1.0, f64::INFINITY), cylinder(-1.0, radius)],
        mirrors: vec![face(-half_length), face(half_length)],
        half_counts: [10, 8],
        ..press([radius, radius], modulus, 2.0 * half_length * line_load)
    };
    let contact_line = between.contact_line();
    assert!(
        contact_line.gap.abs() < 1e-18 && contact_line.extent() == [-half_length, half_length],
        "{:?}",
        contact_line.extent()
    );
    let pressed = between.run();
    // Hertz (Johnson, eqs. 4.43 to 4.45).
    let half_width = (4.0 * line_load * radius / (PI * modulus)).sqrt();
    let expected = 2.0 * line_load / (PI * half_width);
    let peaks: Vec<f64> = pressed
        .grid
        .slices
        .iter()
        .map(|slice| pressed.pressures[slice.cells.clone()].iter().copied().fold(0.0, f64::max))
        .collect();
    let (least, most) = peaks.iter().fold((f64::INFINITY, 0.0f64), |(l, m), &p| (l.min(p), m.max(p)));
    assert!((pressed.peak() / expected - 1.0).abs() < 0.03, "{} {expected}", pressed.peak());
    assert!(most / least < 1.05, "{peaks:?} {expected}");
    // Without image loads the ends are too stiff: the pressure rises towards them.
    let bare = Press { mirrors: Vec::new(), ..between }.run();
    let ends: f64 = bare.grid.slices[0].cells.clone().map(|cell| bare.pressures[cell]).fold(0.0, f64::max);
    assert!(ends / expected > 1.15, "{ends} {expected}");
}
