//! Reference solution by the full discretised equations (report 2.10 to 2.15). A moment drives a
//! tooth of a toothed ring against a rigid roller. The test compares the engine, with component
//! modes and residual flexibility, with Newmark's method for all unknowns of the whole ring's mesh.
//!
//! Both share the mesh, the contact cells and their static compliance. The reference has its own
//! mass and stiffness matrices, solver and contact algorithm. In a second test the ring rotates, so
//! that its vibration has gyroscopic and centrifugal terms.

use calyx_runtime::analysis::AnalysisOptions;
use calyx_runtime::bearing::{Bearing, axisymmetric};
use calyx_runtime::contact::half_plane::HalfPlane;
use calyx_runtime::dynamics::{DynamicOptions, History, Scheme, Start, TimeRange};
use calyx_runtime::error::EngineError;
use calyx_runtime::fe::{
    Block, Constraints, Curve, ElementOrder, MeshBuilder, PlaneModel, Side, Solver, SparseVector, uniform,
};
use calyx_runtime::inertia::Inertia;
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::load::Wrench;
use calyx_runtime::material::{Material, Plane};
use calyx_runtime::motion::SteadyRotation;
use calyx_runtime::observables::{Displacement, Rotation};
use calyx_runtime::profile::{Profile, ProfilePoint};
use calyx_runtime::results::OutputRequest;
use calyx_runtime::scene::{
    Body, BodyId, Component, GridOptions, PairId, Prototype, Scene, StructureOptions, SurfacePair,
};
use calyx_runtime::structure::{
    BodyModes, BoreSupport, Chart, ElasticStructure, RigidStructure, RingSource, SplitOptions, Structure,
    SurfaceSource,
};
use faer::Mat;
use faer::sparse::{SparseColMat, Triplet};
use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::sync::Arc;

mod rotating;

const TEETH: u32 = 5;
/// Face width, m.
const WIDTH: f64 = 0.01;
const BORE: f64 = 0.0375;
const ROOT: f64 = 0.045;
/// End points of a flank, on the positive y side of the tooth on the x axis, m.
const FLANK: [[f64; 2]; 2] = [[0.0575, 0.012], [0.08, 0.007]];
const ROLLER: f64 = 0.02;
/// Width of the contact grid, m, and its number of cells.
const GRID: f64 = 6e-4;
const CELLS: usize = 17;
/// Stiffness of the bearing, N/m, and added moment of inertia, kg m².
const SUPPORT: f64 = 2e8;
const ADDED: f64 = 1e-4;
/// Moment, N m, and its rise time, s.
const MOMENT: f64 = 120.0;
const RISE: f64 = 1e-4;
/// Mass-proportional damping, 1/s.
const DAMPING: f64 = 1500.0;
const STEP: f64 = 1e-6;
const STEPS: usize = 400;

fn moment(time: f64) -> f64 {
    let passed = (time / RISE).clamp(0.0, 1.0);
    MOMENT * passed * passed * (3.0 - 2.0 * passed)
}

/// Meshes one sector of the ring, or all of them.
fn mesh(sectors: u32) -> PlaneModel {
    let mut builder = MeshBuilder::new();
    let (half_pitch, half_tooth) = (PI / f64::from(TEETH), 0.3);
    for sector in 0..sectors {
        let (sin, cos) = (TAU * f64::from(sector) / f64::from(TEETH)).sin_cos();
        let turned = move |[x, y]: [f64; 2]| [cos * x - sin * y, sin * x + cos * y];
        let mirrored = move |[x, y]: [f64; 2]| turned([x, -y]);
        let arc = move |radius: f64, from: f64, to: f64| {
            Curve::new(move |u| {
                let angle = (1.0 - u) * from + u * to;
                turned([radius * angle.cos(), radius * angle.sin()])
            })
        };
        let polar = move |radius: f64, angle: f64| turned([radius * angle.cos(), radius * angle.sin()]);
        let name = |block: Block, side: Side, chain: &str| match sector {
            0 => block.named(side, chain),
            _ => block,
        };
        let rim = |from: f64, to: f64, count: usize| {
            Block::new(
                arc(BORE, from, to),
                Curve::line(polar(BORE, to), polar(ROOT, to)),
                arc(ROOT, from, to),
                Curve::line(polar(BORE, from), polar(ROOT, from)),
            )
            .divided(uniform(count), uniform(2))
            .named(Side::Bottom, "bore")
        };
        builder.block(name(rim(half_pitch, half_tooth, 2), Side::Left, "cut_last"));
        builder.block(rim(half_tooth, -half_tooth, 4));
        builder.block(name(rim(-half_tooth, -half_pitch, 2), Side::Right, "cut_first"));
        let [lower, upper] = FLANK;
        let feet = [polar(ROOT, half_tooth), polar(ROOT, -half_tooth)];
        let [left, right] = [[turned(lower), turned(upper)], [mirrored(lower), mirrored(upper)]];
        builder.block(
            Block::new(
                arc(ROOT, half_tooth, -half_tooth),
                Curve::line(feet[1], right[0]),
                Curve::line(left[0], right[0]),
                Curve::line(feet[0], left[0]),
            )
            .divided(uniform(4), uniform(3)),
        );
        let head = Block::new(
            Curve::line(left[0], right[0]),
            Curve::line(right[0], right[1]),
            Curve::line(left[1], right[1]),
            Curve::line(left[0], left[1]),
        )
        .divided(uniform(4), uniform(12));
        builder.block(match sector {
            0 => head.on_profile(Side::Left, "flank", [0.0, Flank.length()]),
            _ => head,
        });
    }
    PlaneModel::new(builder.finish(ElementOrder::QUADRATIC).expect("a mesh"), Material::STEEL, Plane::Strain)
}

/// Straight flank.
struct Flank;

impl Profile for Flank {
    fn length(&self) -> f64 {
        let [[x, y], [to_x, to_y]] = FLANK;
        (to_x - x).hypot(to_y - y)
    }

    fn at(&self, s: f64) -> ProfilePoint {
        let ([from, to], length) = (FLANK, self.length());
        let tangent = [0, 1].map(|axis: usize| (to[axis] - from[axis]) / length);
        ProfilePoint {
            position: [0, 1].map(|axis: usize| from[axis] + s * tangent[axis]),
            tangent,
            normal: [-tangent[1], tangent[0]],
            curvature: 0.0,
        }
    }
}

/// Quarter of the roller that faces the flank.
struct Round;

impl Profile for Round {
    fn length(&self) -> f64 {
        FRAC_PI_2 * ROLLER
    }

    fn at(&self, s: f64) -> ProfilePoint {
        let [x, y] = Flank.at(0.0).normal;
        let (sin, cos) = ((-y).atan2(-x) + (s - 0.5 * self.length()) / ROLLER).sin_cos();
        let position = [ROLLER * cos, ROLLER * sin];
        ProfilePoint { position, tangent: [-sin, cos], normal: [cos, sin], curvature: ROLLER.recip() }
    }
}

struct Roller;

impl Prototype for Roller {
    fn build(&self, _: &StructureOptions, _: &Interrupt) -> Result<Arc<dyn Structure>, EngineError> {
        Ok(Arc::new(RigidStructure::new(vec![Arc::new(Round)], 1)))
    }

    fn enclosing_radius(&self) -> f64 {
        ROLLER
    }

    fn face_width(&self) -> f64 {
        WIDTH
    }
}

/// Ring, supported at its bore.
struct Toothed {
    inertia: Inertia,
}

const SOURCE: RingSource<'static> = RingSource {
    sectors: TEETH,
    cuts: ["cut_first", "cut_last"],
    bore: "bore",
    support: BoreSupport::Rigid,
    coupled: 2,
};

fn surfaces() -> [SurfaceSource; 1] {
    [SurfaceSource {
        profile: Arc::new(Flank),
        chain: "flank".into(),
        edges: [None, Some(0.0)],
        stress_chain: None,
        stress_points_per_edge: 1,
    }]
}

fn structure() -> ElasticStructure {
    let (options, never) = (SplitOptions::default(), Interrupt::never());
    ElasticStructure::ring(&mesh(1), &SOURCE, &surfaces(), &options, &never).expect("a structure")
}

impl Prototype for Toothed {
    fn build(&self, _: &StructureOptions, _: &Interrupt) -> Result<Arc<dyn Structure>, EngineError> {
        Ok(Arc::new(structure()))
    }

    fn modes(
        &self,
        _: &StructureOptions,
        highest: f64,
        interrupt: &Interrupt,
    ) -> Result<Option<Arc<BodyModes>>, EngineError> {
        let options = SplitOptions::default();
        let modes = BodyModes::ring(&mesh(1), &SOURCE, &surfaces(), &options, highest, interrupt)?;
        Ok(Some(Arc::new(modes)))
    }

    fn inertia(&self) -> Inertia {
        self.inertia
    }

    fn enclosing_radius(&self) -> f64 {
        0.081
    }

    fn face_width(&self) -> f64 {
        WIDTH
    }
}

/// Returns the position of the roller, which touches the flank at its centre.
fn roller() -> ([f64; 2], f64) {
    let s = 0.55 * Flank.length();
    let ProfilePoint { position, normal, .. } = Flank.at(s);
    ([0, 1].map(|axis: usize| position[axis] + ROLLER * normal[axis]), s)
}

/// Displacement of the ring's frame along x and y (m), its rotation (rad), and the force on the
/// flank (N), step by step.
type Motion = Vec<[f64; 4]>;

/// Solves with the engine, with the modes of the ring up to a frequency (Hz).
fn by_modes(inertia: Inertia, highest_frequency: f64) -> Motion {
    let mut scene = Scene::default();
    let ring = Body::new("ring", Arc::new(Toothed { inertia }), SteadyRotation::at_rest([0.0; 2]))
        .free_in(&[Component::Ux, Component::Uy, Component::ThetaZ])
        .with_added(Inertia::axial(0.0, ADDED, 0.0))
        .loaded(|time: f64| Wrench::of_moment([0.0, 0.0, moment(time)]));
    let ring = scene.add_body(ring);
    let roller = Body::new("roller", Arc::new(Roller), SteadyRotation::at_rest(roller().0));
    let roller = scene.add_body(roller);
    let support = Bearing::new("support", ring, 0.0, axisymmetric(SUPPORT, 0.0, 0.0, 0.0));
    scene.add_bearing(support).expect("a bearing");
    let grid = GridOptions {
        half_cells: Some((CELLS - 1) / 2),
        width: Some(GRID),
        edges: false,
        ..GridOptions::default()
    };
    scene.add_pair(SurfacePair { grid, ..SurfacePair::new([ring, roller], [0, 0]) });
    let outputs = [
        OutputRequest::observing("x", scene.add_observable(Displacement(BodyId(0), 0))),
        OutputRequest::observing("y", scene.add_observable(Displacement(BodyId(0), 1))),
        OutputRequest::observing("turn", scene.add_observable(Rotation(BodyId(0), 2))),
    ];
    let dynamics = DynamicOptions {
        from: 0.0,
        ranges: vec![TimeRange::steady(STEPS as f64 * STEP, STEPS)],
        scheme: Scheme::AVERAGE,
        rayleigh: [DAMPING, 0.0],
        start: Start::Frames,
    };
    let options = AnalysisOptions { highest_frequency, ..AnalysisOptions::default() };
    let mut history = History::new(&scene, &outputs, &options, &dynamics, &mut ()).expect("it can begin");
    let mut motion = Vec::new();
    while let Some(solved) = history.next() {
        let outputs = solved.expect("it goes on").row.outputs;
        let force = history.equilibrium().expect("a step").force(PairId(0));
        motion.push([outputs[0].value, outputs[1].value, outputs[2].value, force]);
    }
    motion
}

/// Unknowns of the whole ring: its nodes except those of the bore, then the motion of the frame,
/// which the bore follows.
struct Whole {
    model: PlaneModel,
    /// Expression of each degree of freedom of the mesh by the unknowns.
    seen: Vec<Vec<(usize, f64)>>,
    count: usize,
}

impl Whole {
    fn new() -> Whole {
        let model = mesh(TEETH);
        let bore = model.mesh.chain_nodes(model.mesh.chain("bore").expect("a bore"));
        let mut constrained = vec![false; model.mesh.nodes.len()];
        bore.iter().for_each(|&node| constrained[node] = true);
        let free = constrained.iter().filter(|constrained| !**constrained).count();
        let (mut seen, mut next) = (Vec::new(), 0);
        for (&[x, y], constrained) in model.mesh.nodes.iter().zip(constrained) {
            if constrained {
                seen.push(vec![(2 * free, 1.0), (2 * free + 2, -y)]);
                seen.push(vec![(2 * free + 1, 1.0), (2 * free + 2, x)]);
            } else {
                seen.extend([vec![(next, 1.0)], vec![(next + 1, 1.0)]]);
                next += 2;
            }
        }
        Whole { model, seen, count: 2 * free + 3 }
    }

    /// Returns the inertia of the mesh about the frame: mass and polar moment of inertia.
    fn inertia(&self) -> Inertia {
        let mass = self.model.mass();
        let [along, _, around] = self.model.rigid_body_modes();
        let of = |motion: &[f64]| {
            let entries = mass.triplet_iter();
            entries.map(|entry| motion[entry.row] * entry.val * motion[entry.col]).sum::<f64>()
        };
        WIDTH * Inertia::axial(of(&along), of(&around), 0.0)
    }

    /// Returns a matrix of the mesh in the unknowns, with additional diagonal entries of the frame.
    fn reduced(&self, matrix: &SparseColMat<usize, f64>, frame: [f64; 3]) -> BTreeMap<(usize, usize), f64> {
        let mut entries = BTreeMap::new();
        for entry in matrix.triplet_iter() {
            for &(row, a) in &self.seen[entry.row] {
                for &(column, b) in &self.seen[entry.col] {
                    *entries.entry((column, row)).or_insert(0.0) += a * b * entry.val;
                }
            }
        }
        for (at, own) in (self.count - 3..).zip(frame) {
            *entries.entry((at, at)).or_insert(0.0) += own;
        }
        entries
    }

    fn matrix(&self, entries: &BTreeMap<(usize, usize), f64>) -> SparseColMat<usize, f64> {
        let triplets: Vec<_> =
            entries.iter().map(|(&(column, row), &value)| Triplet::new(row, column, value)).collect();
        SparseColMat::try_new_from_triplets(self.count, self.count, &triplets).expect("a matrix")
    }
}

/// Returns the columns of displacement rows of the mesh.
fn columns(rows: &[SparseVector], count: usize, seen: impl Fn(usize) -> Vec<(usize, f64)>) -> Mat<f64> {
    let mut columns = Mat::zeros(count, rows.len());
    for (column, row) in rows.iter().enumerate() {
        for &(dof, value) in &row.entries {
            seen(dof).into_iter().for_each(|(at, part)| columns[(at, column)] += part * value);
        }
    }
    columns
}

/// Computes contact forces by the projected Gauss-Seidel method.
fn pressed(compliance: &Mat<f64>, gaps: &[f64], forces: &mut [f64]) {
    for _ in 0..10_000 {
        let mut change = 0.0_f64;
        for i in 0..gaps.len() {
            let gap = gaps[i] + (0..gaps.len()).map(|j| compliance[(i, j)] * forces[j]).sum::<f64>();
            let next = (forces[i] - gap / compliance[(i, i)]).max(0.0);
            change = change.max((next - forces[i]).abs());
            forces[i] = next;
        }
        if change <= 1e-9 * forces.iter().copied().fold(1.0, f64::max) {
            return;
        }
    }
    panic!("cells do not settle");
}

/// Solves with all unknowns of the mesh.
fn by_all_unknowns(whole: &Whole) -> Motion {
    let (model, count) = (&whole.model, whole.count);
    let (stiffness, mass) = (model.stiffness(), model.mass());
    let support = SUPPORT / WIDTH;
    let k = whole.reduced(&stiffness, [support, support, 0.0]);
    let m = whole.reduced(&mass, [0.0, 0.0, ADDED / WIDTH]);

    // Cells along the flank with their gaps to the roller and their displacement rows.
    let (center, middle) = roller();
    let cell = |i: usize| [i, i + 1].map(|end| middle + GRID * (end as f64 / CELLS as f64 - 0.5));
    let places: Vec<f64> = (0..CELLS).map(|i| 0.5 * (cell(i)[0] + cell(i)[1])).collect();
    let ProfilePoint { normal, tangent, .. } = Flank.at(middle);
    let apart: Vec<f64> = places
        .iter()
        .map(|&s| {
            let away = [0, 1].map(|axis: usize| center[axis] - Flank.at(s).position[axis]);
            let across = away[0] * tangent[0] + away[1] * tangent[1];
            let along = away[0] * normal[0] + away[1] * normal[1];
            along - (ROLLER * ROLLER - across * across).sqrt()
        })
        .collect();
    let chain = model.mesh.chain("flank").expect("a flank");
    let inward: Vec<SparseVector> = places
        .iter()
        .map(|&s| {
            let place = model.mesh.chain_point(chain, s).expect("a place").place;
            model.displacement_row(place, normal.map(|part| -part))
        })
        .collect();

    // In the compliance between cells, the effective stiffness of a time step replaces the static
    // stiffness of the supported ring. The part that the mesh does not resolve is local to the
    // cells, and static.
    let structure = structure();
    let chart = Chart { tooth: 0, surface: 0 };
    let mut statics = vec![0.0; CELLS * CELLS];
    structure.add_compliance(chart, &places, chart, &places, &mut statics);
    let near = HalfPlane {
        surface_modulus: structure.surface_modulus(),
        reference_length: structure.reference_length(),
    };
    let mut constrained = Constraints::new();
    let bore = model.mesh.chain_nodes(model.mesh.chain("bore").expect("a bore"));
    bore.into_iter().for_each(|node| {
        constrained.fix_node(node);
    });
    let of_mesh = columns(&inward, model.dof_count(), |dof| vec![(dof, 1.0)]);
    let answer = Solver::new(&stiffness, constrained).expect("held").solve(of_mesh.as_ref()).expect("solved");
    let by_mesh = of_mesh.transpose() * &answer;
    let Scheme { beta, gamma } = Scheme::AVERAGE;
    let (of_mass, of_damping) = ((beta * STEP * STEP).recip(), gamma / (beta * STEP));
    let mut step = k.clone();
    for (at, value) in &m {
        *step.entry(*at).or_insert(0.0) += (of_mass + of_damping * DAMPING) * value;
    }
    let solver = Solver::new(&whole.matrix(&step), Constraints::new()).expect("definite");
    let on_cells = columns(&inward, count, |dof| whole.seen[dof].clone());
    let pushed = solver.solve(on_cells.as_ref()).expect("solved");
    let in_step = on_cells.transpose() * &pushed;
    let compliance = Mat::from_fn(CELLS, CELLS, |i, j| {
        statics[i * CELLS + j] + near.cell_compliance(cell(i), cell(j)) - by_mesh[(i, j)] + in_step[(i, j)]
    });

    let (k, m) = (whole.matrix(&k), whole.matrix(&m));
    let [mut x, mut v, mut a] = [0, 1, 2].map(|_| Mat::<f64>::zeros(count, 1));
    let mut forces = vec![0.0; CELLS];
    let mut motion = vec![[0.0; 4]];
    for number in 1..=STEPS {
        let ahead = &x + STEP * &v + (0.5 - beta) * STEP * STEP * &a;
        let speed = &v + (1.0 - gamma) * STEP * &a;
        let mut load = -(&k * &ahead) - DAMPING * (&m * &speed);
        load[(count - 1, 0)] += moment(number as f64 * STEP) / WIDTH;
        let free = solver.solve(load.as_ref()).expect("solved");
        let end = &ahead + &free;
        let opened = on_cells.transpose() * &end;
        let gaps: Vec<f64> = (0..CELLS).map(|i| apart[i] + opened[(i, 0)]).collect();
        pressed(&compliance, &gaps, &mut forces);
        let by = Mat::from_fn(CELLS, 1, |i, _| forces[i]);
        let y = &free + &pushed * &by;
        x = &ahead + &y;
        a = of_mass * &y;
        v = &speed + gamma * STEP * &a;
        let force = WIDTH * forces.iter().sum::<f64>();
        motion.push([x[(count - 3, 0)], x[(count - 2, 0)], x[(count - 1, 0)], force]);
    }
    motion
}

/// Returns the largest difference of each component, relative to its largest value.
fn differences(found: &Motion, expected: &Motion) -> [f64; 4] {
    assert_eq!(found.len(), expected.len());
    std::array::from_fn(|what| {
        let most = expected.iter().map(|values| values[what].abs()).fold(0.0, f64::max);
        let both = found.iter().zip(expected);
        both.map(|(a, b)| (a[what] - b[what]).abs()).fold(0.0, f64::max) / most
    })
}

#[test]
fn modes_and_residual_flexibility_answer_as_all_unknowns_of_the_mesh_do() {
    let whole = Whole::new();
    let expected = by_all_unknowns(&whole);
    let with_modes = differences(&by_modes(whole.inertia(), 100e3), &expected);
    let rigid = differences(&by_modes(whole.inertia(), 0.0), &expected);
    assert!(with_modes.iter().all(|difference| *difference < 0.01), "{with_modes:?}");
    // The vibration of the ring itself is significant.
    assert!(rigid[3] > 0.03, "{rigid:?}");
}
