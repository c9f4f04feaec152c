//! Elastic discs through the whole engine, against closed forms: squeezed between rigid platens, and against each other.
//!
//! Hertz's pressure depends on what is near the contact alone; the approach of the platens sees the whole body.

use calyx_runtime::contact::grid::pressures;
use calyx_runtime::contact::pressure::{half_width, peak};
use calyx_runtime::error::EngineError;
use calyx_runtime::fe::block::uniform;
use calyx_runtime::fe::{Block, Curve, ElementOrder, MeshBuilder, PlaneMesh, PlaneModel, Side};
use calyx_runtime::material::{Material, Plane};
use calyx_runtime::motion::SteadyRotation;
use calyx_runtime::plan::Plan;
use calyx_runtime::profile::{Profile, ProfilePoint};
use calyx_runtime::scene::{
    Body, BodyId, Fidelity, GridOptions, Ignored, Prototype, Scene, StructureOptions, SurfacePair,
};
use calyx_runtime::step::StepResult;
use calyx_runtime::structure::{
    ElasticStructure, Hold, RigidStructure, SplitOptions, Structure, SurfaceSource,
};
use calyx_runtime::system::System;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
use std::sync::Arc;

const STEEL: Material = Material { youngs_modulus: 206e9, poissons_ratio: 0.3, density: 7850.0 };
const FACE_WIDTH: f64 = 0.02;

/// E', here of plane strain.
fn surface_modulus() -> f64 {
    STEEL.surface_modulus(Plane::Strain)
}

/// A quarter of a circle about the origin, its middle at polar angle `middle`.
struct Quarter {
    radius: f64,
    middle: f64,
}

impl Profile for Quarter {
    fn length(&self) -> f64 {
        FRAC_PI_2 * self.radius
    }

    fn at(&self, s: f64) -> ProfilePoint {
        let (sin, cos) = (self.middle - FRAC_PI_4 + s / self.radius).sin_cos();
        ProfilePoint {
            position: [self.radius * cos, self.radius * sin],
            tangent: [-sin, cos],
            normal: [cos, sin],
            curvature: self.radius.recip(),
        }
    }
}

/// A straight line through the origin, facing up or down.
struct Straight {
    length: f64,
    faces: f64,
}

impl Profile for Straight {
    fn length(&self) -> f64 {
        self.length
    }

    fn at(&self, s: f64) -> ProfilePoint {
        ProfilePoint {
            position: [self.faces * (0.5 * self.length - s), 0.0],
            tangent: [-self.faces, 0.0],
            normal: [0.0, self.faces],
            curvature: 0.0,
        }
    }
}

/// A free elastic disc whose surfaces 0 and 1 are its upper and its lower quarter, condensed once for all its scenes.
#[derive(Clone)]
struct Disc {
    radius: f64,
    structure: Arc<ElasticStructure>,
}

/// A rigid plate; surface 0 faces up (+1) or down (-1).
struct Platen {
    length: f64,
    faces: f64,
}

impl Disc {
    fn new(radius: f64) -> Self {
        let model = PlaneModel::new(disc_mesh(radius, 20), STEEL, Plane::Strain);
        let surfaces = [0, 1].map(|surface| SurfaceSource {
            profile: Arc::new(Quarter { radius, middle: [FRAC_PI_2, -FRAC_PI_2][surface] }),
            chain: format!("quarter_{surface}"),
            edges: [None; 2],
            stress_chain: None,
            stress_places_per_edge: 1,
        });
        let structure = ElasticStructure::single(&model, Hold::Free, &surfaces, &SplitOptions::default());
        Self { radius, structure: Arc::new(structure.expect("a sound disc")) }
    }
}

impl Prototype for Disc {
    fn build(&self, _: &StructureOptions) -> Result<Arc<dyn Structure>, EngineError> {
        Ok(self.structure.clone())
    }

    fn enclosing_radius(&self) -> f64 {
        self.radius
    }

    fn roll_angle(&self, _: f64) -> Option<f64> {
        None
    }

    fn face_width(&self) -> f64 {
        FACE_WIDTH
    }

    fn ignored(&self, _: Fidelity) -> Vec<Ignored> {
        Vec::new()
    }
}

impl Prototype for Platen {
    fn build(&self, _: &StructureOptions) -> Result<Arc<dyn Structure>, EngineError> {
        let surface = Arc::new(Straight { length: self.length, faces: self.faces });
        Ok(Arc::new(RigidStructure::new(vec![surface], 1)))
    }

    fn enclosing_radius(&self) -> f64 {
        0.5 * self.length
    }

    fn roll_angle(&self, _: f64) -> Option<f64> {
        None
    }

    fn face_width(&self) -> f64 {
        FACE_WIDTH
    }

    fn ignored(&self, _: Fidelity) -> Vec<Ignored> {
        Vec::new()
    }
}

/// A core with bulging sides, and a block between each of them and the rim.
fn disc_mesh(radius: f64, divisions: usize) -> PlaneMesh {
    let core = 0.5 * radius;
    let on_circle = |radius: f64, angle: f64| [radius * angle.cos(), radius * angle.sin()];
    let corner = |k: usize| FRAC_PI_4 + FRAC_PI_2 * k as f64;
    let side = |from: f64, to: f64| {
        let (start, end) = (on_circle(core, from), on_circle(core, to));
        Curve::new(move |u| {
            let round = on_circle(core, (1.0 - u) * from + u * to);
            [0, 1].map(|axis| 0.5 * (round[axis] + (1.0 - u) * start[axis] + u * end[axis]))
        })
    };
    let mut builder = MeshBuilder::new();
    let core_block = Block::new(
        side(corner(2), corner(3)),
        side(corner(3), corner(4)),
        side(corner(1), corner(0)),
        side(corner(2), corner(1)),
    );
    builder.block(core_block.divided(uniform(divisions), uniform(divisions)));
    for (k, name) in [None, Some("quarter_0"), None, Some("quarter_1")].into_iter().enumerate() {
        let (first, last) = (corner(k) - FRAC_PI_2, corner(k));
        let ray = |angle: f64| Curve::line(on_circle(core, angle), on_circle(radius, angle));
        let rim = Curve::arc([0.0; 2], radius, last, first);
        let mut block = Block::new(side(last, first), ray(first), rim, ray(last))
            .divided(uniform(divisions), uniform(divisions));
        if let Some(name) = name {
            block = block.on_profile(Side::Top, name, [FRAC_PI_2 * radius, 0.0]);
        }
        builder.block(block);
    }
    builder.finish(ElementOrder::QUADRATIC).expect("a sound mesh")
}

/// A body with its origin at height `y`, free to move up and down or held, with a force (N) upwards.
fn body(name: &str, prototype: impl Prototype + 'static, y: f64, free: bool, force: f64) -> Body {
    Body {
        name: name.into(),
        prototype: Arc::new(prototype),
        motion: Arc::new(SteadyRotation { origin: [0.0, y], start: 0.0, speed: 0.0 }),
        phase: 0.0,
        free: [false, free, false, false, false, false],
        force: [0.0, force, 0.0],
        moment: [0.0; 3],
    }
}

fn touching(bodies: [BodyId; 2], surfaces: [u32; 2], half_cells: usize) -> SurfacePair {
    let grid = GridOptions { half_cells, ..GridOptions::default() };
    SurfacePair { bodies, surfaces, grid, mesh: None }
}

fn solve(scene: &Scene) -> StepResult {
    let plan = Plan::new(scene, Fidelity::Plane, StructureOptions::default()).expect("a plan");
    let mut system = System::new(scene, &plan).expect("a system");
    let step = system.solve(0.0).expect("equilibrium");
    assert!(step.certificate.largest() <= 1e-12, "{:?}", step.certificate);
    assert_eq!(step.warnings, Vec::<String>::new());
    step
}

#[test]
fn a_disc_between_platens_gives_as_much_as_the_closed_form_says() {
    let radius = 0.02;
    let squeezed = Disc::new(radius);
    for a_over_r in [0.003_f64, 0.01, 0.03] {
        // a² = 4 q R / (pi E'), Johnson eq. 4.43 with a rigid plane.
        let contact_half_width = a_over_r * radius;
        let force = PI * surface_modulus() * contact_half_width.powi(2) / (4.0 * radius);
        let mut scene = Scene::default();
        let disc = scene.add_body(body("disc", squeezed.clone(), 0.0, true, 0.0));
        let platen = |faces: f64| Platen { length: 2.0 * radius, faces };
        let lower = scene.add_body(body("lower platen", platen(1.0), -radius, false, 0.0));
        let upper = scene.add_body(body("upper platen", platen(-1.0), radius, true, -force * FACE_WIDTH));
        scene.add_pair(touching([disc, upper], [0, 0], 24));
        scene.add_pair(touching([disc, lower], [1, 0], 24));
        let step = solve(&scene);

        // The freedoms are the disc's and the upper platen's, downwards.
        let [disc_moves, approach] = [0, 1].map(|freedom| -step.motion[freedom]);
        let known = 2.0 * force / (PI * surface_modulus()) * (2.0 * (4.0 / a_over_r).ln() - 1.0);
        assert!((approach / known - 1.0).abs() < 3e-3, "a/R {a_over_r}: {approach} {known}");
        // Both halves give alike.
        assert!((disc_moves / approach - 0.5).abs() < 1e-6, "{disc_moves} {approach}");
        for patch in &step.patches {
            assert!((patch.force() / force - 1.0).abs() < 1e-12);
        }
    }
}

#[test]
fn two_cylinders_converge_to_hertz() {
    // Johnson, eqs. 4.43 to 4.45: steel cylinders of 50 and 100 mm, 500 N/mm (contact_closed_forms.json, "steel pair
    // metric"); a/R is 0.009 and 0.004.
    let radii = [0.05, 0.1];
    let (force, known_half_width, known_peak) = (5e5, 0.000432993640638256, 735137554.710006);
    let discs = radii.map(Disc::new);
    let errors = [12, 24, 48, 96].map(|half_cells| {
        let mut scene = Scene::default();
        let lower = scene.add_body(body("lower", discs[0].clone(), -radii[0], false, 0.0));
        let upper = scene.add_body(body("upper", discs[1].clone(), radii[1], true, -force * FACE_WIDTH));
        scene.add_pair(touching([lower, upper], [0, 1], half_cells));
        let step = solve(&scene);
        let patch = &step.patches[0];
        let pressures = pressures(&patch.cells, &patch.forces);
        let peak = peak(&patch.cells, &pressures).expect("a loaded patch").pressure;
        let half_width = half_width(&patch.cells, &pressures).expect("a resolved patch");
        [peak / known_peak - 1.0, half_width / known_half_width - 1.0]
    });
    for [peak, half_width] in &errors {
        assert!(peak.abs() < 5e-3 && half_width.abs() < 1e-2, "{errors:?}");
    }
    // The limit is not quite Hertz's: he neglects that pressure shortens a surface by (1 - 2 nu)(1 + nu) p / E, which on a
    // curved one adds that part to the curvature, and half of it to the peak, here 0.9 thousandths.
    let shortening =
        (1.0 - 2.0 * STEEL.poissons_ratio) * (1.0 + STEEL.poissons_ratio) * known_peak / STEEL.youngs_modulus;
    let [coarsest, _, _, finest] = errors.map(|[peak, _]| (peak - 0.5 * shortening).abs());
    assert!(finest < 2e-4 && finest < 0.5 * coarsest, "{errors:?} {shortening}");
}
