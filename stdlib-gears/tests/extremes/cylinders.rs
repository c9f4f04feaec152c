//! Contact of cylinders, compared with Hertz and with the closed form of a squeezed disc.

use super::case::{Case, Refusal, off, refusal, worst};
use crate::common::resources;
use calyx_runtime::disc::{Disc, Facing, Platen};
use calyx_runtime::error::EngineError;
use calyx_runtime::load::Wrench;
use calyx_runtime::material::{Material, Plane};
use calyx_runtime::motion::SteadyRotation;
use calyx_runtime::plan::Plan;
use calyx_runtime::scene::{
    Body, Component, Fidelity, GridOptions, Prototype, Scene, StructureOptions, SurfacePair,
};
use calyx_runtime::step::StepResult;
use calyx_runtime::system::System;
use std::f64::consts::PI;
use std::sync::Arc;

pub fn cases() -> Vec<Case> {
    vec![
        Case::holds(
            "A cylinder between rigid plates: peak pressure and approach",
            "contact half-widths of 3e-7 and 0.01 radii: loads of 1e-9 and 1 times the nominal one",
            2e-2,
            "Hertz, and Johnson's closed form of the squeezed disc",
            || worst([1e-9, 1.0].map(|part| Squeezed { part, ..NOMINAL }.error())),
        ),
        Case::holds("The same", "radii of 1e-9 m and 1e6 m", 2e-2, "the same", || {
            worst([1e-9, 1e6].map(|radius| Squeezed { radius, ..NOMINAL }.error()))
        }),
        Case::holds(
            "The same",
            "Poisson's ratio 0 and 0.4999",
            2e-2,
            "the same: the elements do not lock",
            || worst([0.0, 0.4999].map(|ratio| Squeezed { ratio, ..NOMINAL }.error())),
        ),
        Case::refused(
            "A material",
            "Poisson's ratio 0.5",
            "E0661",
            "incompressible: the bulk modulus is infinite",
            || refusal(Material::new(2e11, 0.5, 7850.0)),
        ),
        Case::holds(
            "A cylinder between rigid plates: peak pressure and approach",
            "Young's modulus 1 Pa and 1e23 Pa",
            2e-2,
            "Hertz, and Johnson's closed form of the squeezed disc",
            || worst([1.0, 1e23].map(|modulus| Squeezed { modulus, ..NOMINAL }.error())),
        ),
        Case::holds(
            "Two cylinders: peak pressure",
            "one 1e12 times as stiff as the other",
            2e-2,
            "Hertz, with the compliance of the softer one alone",
            || worst([1.0, 1e-3].map(beside_a_stiff_one)),
        ),
        Case::holds(
            "A cylinder between rigid plates: force and approach",
            "grids of 1 cell as wide as the contact, of 3, and of 201",
            0.05,
            "statics and the closed form: the approach depends little on the average over a cell",
            || {
                let grids = [0, 1, 100].map(|half_cells| {
                    let squeezed = Squeezed { half_cells: Some(half_cells), width: Some(1.0), ..NOMINAL };
                    squeezed.approach_error()
                });
                worst(grids)
            },
        ),
        Case::warns(
            "The same",
            "a grid with a tenth of the contact width: all cells carry load",
            "is too narrow",
            "the grid is too narrow",
            || Squeezed { width: Some(0.1), ..NOMINAL }.warnings(),
        ),
        Case::warns(
            "The same",
            "a grid with a thousand times the contact width: one cell carries the load",
            "is too wide",
            "the grid is too wide",
            || Squeezed { width: Some(1e3), ..NOMINAL }.warnings(),
        ),
        Case::refused(
            "The same",
            "1e9 times the nominal load",
            "E0716",
            "the contact is as wide as the surfaces",
            || Squeezed { part: 1e9, ..NOMINAL }.refusal(),
        )
        .saying("touch over all"),
        Case::refused(
            "A cylinder on a plate",
            "a load that lifts the cylinder",
            "E0714",
            "contact transmits no tension",
            || Squeezed { part: -1.0, ..NOMINAL }.refusal(),
        ),
        Case::refused(
            "A cylinder between rigid plates",
            "a NaN load",
            "E0723",
            "there is no equilibrium",
            || Squeezed { part: f64::NAN, ..NOMINAL }.refusal(),
        ),
        Case::refused(
            "A flat rigid plate on another one",
            "exactly parallel: they touch everywhere",
            "E0714",
            "two parallel rigid planes have no unique nearest points",
            flat_on_flat,
        )
        .saying("no surface has a nearest point"),
    ]
}

/// Cylinder between plates. Under the nominal load its contact half-width is a hundredth of its
/// radius.
#[derive(Clone, Copy)]
struct Squeezed {
    radius: f64,
    modulus: f64,
    ratio: f64,
    /// Fraction of the nominal load.
    part: f64,
    half_cells: Option<usize>,
    /// Width of the grid in contact widths.
    width: Option<f64>,
}

const NOMINAL: Squeezed =
    Squeezed { radius: 0.02, modulus: 206e9, ratio: 0.3, part: 1.0, half_cells: None, width: None };
/// Face width of all bodies here, m.
const FACE_WIDTH: f64 = 0.02;
/// Contact half-width under the nominal load, in radii.
const NARROW: f64 = 0.01;
/// Mesh of a cylinder: approaches are accurate to a thousandth.
const MESH: StructureOptions = StructureOptions { refinement: 0.5, order: 2, ..DEFAULT };
const DEFAULT: StructureOptions = StructureOptions {
    refinement: 1.0,
    order: 3,
    model: calyx_runtime::scene::BodyModel::Elements,
    template: calyx_runtime::scene::Template::Medium,
    face_elements: None,
    axial_order: None,
    matching_depth: 1.0,
    stresses: true,
    sharp_edges: false,
    raceway_degrees: 0,
};

fn solve(scene: &Scene) -> Result<StepResult, EngineError> {
    let plan = Plan::new(scene, Fidelity::Plane, MESH)?;
    let step = System::with(scene, &plan, &resources())?.solve(0.0)?;
    assert!(step.certificate.largest() <= 1e-10, "{:?}", step.certificate);
    Ok(step)
}

fn body(name: &str, prototype: impl Prototype + 'static, y: f64) -> Body {
    Body::new(name, Arc::new(prototype), SteadyRotation::at_rest([0.0, y]))
}

impl Squeezed {
    fn material(&self) -> Material {
        Material { youngs_modulus: self.modulus, poissons_ratio: self.ratio, density: 7850.0 }
    }

    /// Line load, N/m.
    fn load(&self) -> f64 {
        let narrow = NARROW * self.radius;
        self.part * PI * self.material().surface_modulus(Plane::Strain) * narrow * narrow
            / (4.0 * self.radius)
    }

    /// a² = 4 q R / (pi E'), m.
    fn half_width(&self) -> f64 {
        (4.0 * self.load() * self.radius / (PI * self.material().surface_modulus(Plane::Strain))).sqrt()
    }

    fn solved(&self) -> Result<StepResult, EngineError> {
        let radius = self.radius;
        let mut scene = Scene::default();
        let up = &[Component::Uy];
        let disc =
            scene.add_body(body("disc", Disc::new(radius, FACE_WIDTH, self.material()), 0.0).free_in(up));
        let platen = |facing| Platen::new(2.0 * radius, FACE_WIDTH, facing);
        let lower = scene.add_body(body("lower platen", platen(Facing::Up), -radius));
        let load = Wrench::of_force([0.0, -self.load() * FACE_WIDTH, 0.0]);
        let upper =
            scene.add_body(body("upper platen", platen(Facing::Down), radius).free_in(up).loaded(load));
        let grid = GridOptions {
            half_cells: self.half_cells,
            width: self.width.map(|width| 2.0 * width * self.half_width()),
            ..GridOptions::default()
        };
        let pair = |other, surface| SurfacePair {
            grid,
            ..SurfacePair::new([disc, other], [surface, Platen::SURFACE])
        };
        scene.add_pair(pair(upper, Disc::TOP));
        scene.add_pair(pair(lower, Disc::BOTTOM));
        solve(&scene)
    }

    fn refusal(&self) -> Option<Refusal> {
        refusal(self.solved())
    }

    fn warnings(&self) -> Vec<String> {
        self.solved().expect("it is solved").warnings
    }

    fn approach_error(&self) -> f64 {
        let step = self.solved().expect("it is solved");
        let modulus = self.material().surface_modulus(Plane::Strain);
        // Johnson eq. 5.57, for both sides.
        let known =
            2.0 * self.load() / (PI * modulus) * (2.0 * (4.0 * self.radius / self.half_width()).ln() - 1.0);
        let forces = step.patches.iter().map(|patch| off(patch.force(), self.load()));
        worst(forces.chain([off(-step.motion[1], known)]))
    }

    fn error(&self) -> f64 {
        let step = self.solved().expect("it is solved");
        assert_eq!(step.warnings, Vec::<String>::new());
        let peak = 2.0 * self.load() / (PI * self.half_width());
        let peaks = step.patches.iter().map(|patch| off(patch.peak().expect("it is loaded").pressure, peak));
        worst(peaks.chain([self.approach_error()]))
    }
}

/// Ratio of the peak pressure of a steel cylinder on one that is 1e12 times as stiff to Hertz's for
/// the steel cylinder alone, under a fraction of a load.
fn beside_a_stiff_one(part: f64) -> f64 {
    let (soft, radii) = (Material::STEEL, [0.05, 0.1]);
    let stiff = Material { youngs_modulus: 1e12 * soft.youngs_modulus, ..soft };
    let force = 5e5 * part;
    let mut scene = Scene::default();
    let lower = scene.add_body(body("lower", Disc::new(radii[0], FACE_WIDTH, soft), -radii[0]));
    let load = Wrench::of_force([0.0, -force * FACE_WIDTH, 0.0]);
    let upper = body("upper", Disc::new(radii[1], FACE_WIDTH, stiff), radii[1]);
    let upper = scene.add_body(upper.free_in(&[Component::Uy]).loaded(load));
    scene.add_pair(SurfacePair::new([lower, upper], [Disc::TOP, Disc::BOTTOM]));
    let step = solve(&scene).expect("it is solved");
    let (modulus, radius) = (soft.surface_modulus(Plane::Strain), 1.0 / (1.0 / radii[0] + 1.0 / radii[1]));
    let peak = (force * modulus / (PI * radius)).sqrt();
    off(step.patches[0].peak().expect("it is loaded").pressure, peak)
}

/// Rigid plate on another plate.
fn flat_on_flat() -> Option<Refusal> {
    let mut scene = Scene::default();
    let lower = scene.add_body(body("lower", Platen::new(0.1, FACE_WIDTH, Facing::Up), 0.0));
    let load = Wrench::of_force([0.0, -1e3, 0.0]);
    let upper = body("upper", Platen::new(0.1, FACE_WIDTH, Facing::Down), 0.0);
    let upper = scene.add_body(upper.free_in(&[Component::Uy]).loaded(load));
    scene.add_pair(SurfacePair::new([lower, upper], [Platen::SURFACE, Platen::SURFACE]));
    refusal(solve(&scene))
}
