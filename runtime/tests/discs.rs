//! Tests of elastic discs with the whole engine against closed forms: between rigid platens, and in
//! contact with each other.
//!
//! Hertz's pressure depends on the contact region only; the approach of the platens depends on the
//! whole body.

use calyx_runtime::analysis::{AnalysisOptions, Event, Observer, Position, quasi_static};
use calyx_runtime::disc::{Disc, Facing, Platen};
use calyx_runtime::error::EngineError;
use calyx_runtime::inertia::Inertia;
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::load::Wrench;
use calyx_runtime::material::{Material, Plane};
use calyx_runtime::motion::SteadyRotation;
use calyx_runtime::observables::{Displacement, Fields, NaturalFrequency};
use calyx_runtime::plan::Plan;
use calyx_runtime::results::OutputRequest;
use calyx_runtime::scene::{
    Body, BodyId, Component, Fidelity, ObservableId, Prototype, Scene, StructureOptions, SurfacePair,
};
use calyx_runtime::step::StepResult;
use calyx_runtime::structure::{BodyModes, Structure};
use calyx_runtime::system::System;
use std::f64::consts::PI;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, OnceLock};

const STEEL: Material = Material::STEEL;
const FACE_WIDTH: f64 = 0.02;

/// Returns E' in plane strain.
fn surface_modulus() -> f64 {
    STEEL.surface_modulus(Plane::Strain)
}

/// Disc that is condensed once for all its scenes.
#[derive(Clone)]
struct Shared {
    disc: Disc,
    structure: Arc<OnceLock<Arc<dyn Structure>>>,
}

impl Shared {
    fn new(radius: f64) -> Arc<Self> {
        Arc::new(Self { disc: Disc::new(radius, FACE_WIDTH, STEEL), structure: Arc::default() })
    }
}

impl Prototype for Shared {
    fn build(
        &self,
        options: &StructureOptions,
        interrupt: &Interrupt,
    ) -> Result<Arc<dyn Structure>, EngineError> {
        Ok(self.structure.get_or_init(|| self.disc.build(options, interrupt).expect("a sound disc")).clone())
    }

    fn enclosing_radius(&self) -> f64 {
        self.disc.enclosing_radius()
    }

    fn face_width(&self) -> f64 {
        self.disc.face_width()
    }
}

/// Creates a body with its origin at height `y`.
fn body(name: &str, prototype: Arc<dyn Prototype>, y: f64) -> Body {
    Body::new(name, prototype, SteadyRotation::at_rest([0.0, y]))
}

fn downwards(force: f64) -> Wrench {
    Wrench::of_force([0.0, -force * FACE_WIDTH, 0.0])
}

fn solve(scene: &Scene) -> StepResult {
    let plan = Plan::new(scene, Fidelity::Plane, StructureOptions::default()).expect("a plan");
    let system = System::new(scene, &plan).expect("a system");
    let step = system.solve(0.0).expect("equilibrium");
    assert!(step.certificate.largest() <= 1e-12, "{:?}", step.certificate);
    assert_eq!(step.warnings, Vec::<String>::new());
    step
}

#[test]
fn a_disc_between_platens_gives_as_much_as_the_closed_form_says() {
    let radius = 0.02;
    let squeezed = Shared::new(radius);
    for a_over_r in [0.003_f64, 0.01, 0.03] {
        // a² = 4 q R / (pi E'), Johnson eq. 4.43 with a rigid plane.
        let contact_half_width = a_over_r * radius;
        let force = PI * surface_modulus() * contact_half_width.powi(2) / (4.0 * radius);
        let mut scene = Scene::default();
        let up = &[Component::Uy];
        let disc = scene.add_body(body("disc", squeezed.clone(), 0.0).free_in(up));
        let platen = |facing| Arc::new(Platen::new(2.0 * radius, FACE_WIDTH, facing));
        let lower = scene.add_body(body("lower platen", platen(Facing::Up), -radius));
        let upper = body("upper platen", platen(Facing::Down), radius);
        let upper = scene.add_body(upper.free_in(up).loaded(downwards(force)));
        scene.add_pair(SurfacePair::new([disc, upper], [Disc::TOP, Platen::SURFACE]));
        scene.add_pair(SurfacePair::new([disc, lower], [Disc::BOTTOM, Platen::SURFACE]));
        let step = solve(&scene);

        // The DOFs are the downward displacements of the disc and the upper platen.
        let [disc_moves, approach] = [0, 1].map(|dof| -step.motion[dof]);
        let known = 2.0 * force / (PI * surface_modulus()) * (2.0 * (4.0 / a_over_r).ln() - 1.0);
        assert!((approach / known - 1.0).abs() < 3e-3, "a/R {a_over_r}: {approach} {known}");
        // Both halves have equal compliance.
        assert!((disc_moves / approach - 0.5).abs() < 1e-6, "{disc_moves} {approach}");
        for patch in &step.patches {
            assert!((patch.force() / force - 1.0).abs() < 1e-12);
        }
    }
}

#[test]
fn two_cylinders_converge_to_hertz() {
    // Johnson, eqs. 4.43 to 4.45: steel cylinders of 50 and 100 mm, 500 N/mm
    // (contact_closed_forms.json, "steel pair metric"); a/R is 0.009 and 0.004.
    let radii = [0.05, 0.1];
    let (force, known_half_width, known_peak) = (5e5, 0.000432993640638256, 735137554.710006);
    let discs = radii.map(Shared::new);
    let errors = [12, 24, 48, 96].map(|half_cells| {
        let mut scene = Scene::default();
        let lower = scene.add_body(body("lower", discs[0].clone(), -radii[0]));
        let upper = body("upper", discs[1].clone(), radii[1]);
        let upper = scene.add_body(upper.free_in(&[Component::Uy]).loaded(downwards(force)));
        let mut pair = SurfacePair::new([lower, upper], [Disc::TOP, Disc::BOTTOM]);
        pair.grid.half_cells = Some(half_cells);
        scene.add_pair(pair);
        let step = solve(&scene);
        let patch = &step.patches[0];
        let peak = patch.peak().expect("a loaded patch").pressure;
        let half_width = patch.half_width().expect("a resolved patch");
        [peak / known_peak - 1.0, half_width / known_half_width - 1.0]
    });
    for [peak, half_width] in &errors {
        assert!(peak.abs() < 5e-3 && half_width.abs() < 1e-2, "{errors:?}");
    }
    // The limit differs slightly from Hertz: he neglects that pressure shortens a surface by (1 - 2
    // nu)(1 + nu) p / E. On a curved surface this adds the same fraction to the curvature, and half
    // of it to the peak pressure, here 0.9 thousandths.
    let shortening =
        (1.0 - 2.0 * STEEL.poissons_ratio) * (1.0 + STEEL.poissons_ratio) * known_peak / STEEL.youngs_modulus;
    let [coarsest, _, _, finest] = errors.map(|[peak, _]| (peak - 0.5 * shortening).abs());
    assert!(finest < 2e-4 && finest < 0.5 * coarsest, "{errors:?} {shortening}");
}

/// Creates a disc that is pressed on a platen, with observables.
fn resting(disc: Arc<dyn Prototype>, radius: f64) -> Scene {
    let mut scene = Scene::default();
    let disc = body("disc", disc, 0.0).free_in(&[Component::Uy]).loaded(downwards(5e5));
    let disc = scene.add_body(disc);
    let platen = Arc::new(Platen::new(2.0 * radius, FACE_WIDTH, Facing::Up));
    let platen = scene.add_body(body("platen", platen, -radius));
    scene.add_pair(SurfacePair::new([disc, platen], [Disc::BOTTOM, Platen::SURFACE]));
    scene
}

fn requests(scene: &Scene) -> Vec<OutputRequest> {
    let observing = |index: usize| OutputRequest::observing(index.to_string(), ObservableId(index));
    (0..scene.observables.len()).map(observing).collect()
}

/// Data of the last position.
#[derive(Default)]
struct Shown(Option<Fields>);

impl Observer for Shown {
    fn observe(&mut self, event: Event<'_>) -> Result<(), EngineError> {
        if let Event::Step { fields: Some(fields), .. } = event {
            self.0 = Some(fields.clone());
        }
        Ok(())
    }
}

/// Discs and platens have no sectors to write to VTU files: they are reported by name, not skipped
/// silently.
#[test]
fn pictures_name_bodies_that_they_do_not_have() {
    let mut scene = resting(Shared::new(0.02), 0.02);
    scene.add_observable(Displacement(BodyId(0), 1));
    let mut shown = Shown::default();
    let options = AnalysisOptions { fields: 1, bodies: true, ..AnalysisOptions::default() };
    quasi_static(&scene, &[Position::at(0.0)], &requests(&scene), &options, &mut shown).expect("equilibrium");
    let fields = shown.0.expect("fields");
    assert!(fields.bodies.is_empty() && fields.contacts.len() == 1);
    let named: Vec<&str> = fields.without_mesh.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(named, ["disc", "platen"]);
    assert!(
        fields.without_mesh.iter().all(|(_, reason)| *reason == "is of a kind that pictures do not have")
    );
}

/// Disc that counts its meshes: for its structure, its modes, and, as for gears, its inertia.
struct Counted {
    disc: Disc,
    built: Arc<[AtomicUsize; 3]>,
}

impl Counted {
    fn count(&self, what: usize) {
        self.built[what].fetch_add(1, Ordering::Relaxed);
    }
}

impl Prototype for Counted {
    fn build(
        &self,
        options: &StructureOptions,
        interrupt: &Interrupt,
    ) -> Result<Arc<dyn Structure>, EngineError> {
        self.count(0);
        self.disc.build(options, interrupt)
    }

    fn modes(
        &self,
        options: &StructureOptions,
        highest: f64,
        interrupt: &Interrupt,
    ) -> Result<Option<Arc<BodyModes>>, EngineError> {
        self.count(1);
        self.disc.modes(options, highest, interrupt)
    }

    fn inertia(&self) -> Inertia {
        self.count(2);
        self.disc.inertia()
    }

    fn enclosing_radius(&self) -> f64 {
        self.disc.enclosing_radius()
    }

    fn face_width(&self) -> f64 {
        self.disc.face_width()
    }
}

/// Free vibrations about an equilibrium use modes and inertias at every position; their meshes are
/// generated once per analysis.
#[test]
fn natural_frequencies_mesh_nothing_anew_at_a_position() {
    let counts = [1, 6].map(|positions: usize| {
        let built: Arc<[AtomicUsize; 3]> = Arc::default();
        let disc = Counted { disc: Disc::new(0.02, FACE_WIDTH, STEEL), built: built.clone() };
        let mut scene = resting(Arc::new(disc), 0.02);
        scene.add_observable(NaturalFrequency(0));
        scene.add_observable(NaturalFrequency(1));
        let positions: Vec<Position> = (0..positions).map(|k| Position::at(0.1 * k as f64)).collect();
        let structure = StructureOptions { refinement: 0.5, ..StructureOptions::default() };
        let options = AnalysisOptions { structure, highest_frequency: 1.2e5, ..AnalysisOptions::default() };
        let found =
            quasi_static(&scene, &positions, &requests(&scene), &options, &mut ()).expect("equilibrium");
        assert_eq!(found.rows.len(), positions.len());
        for row in &found.rows {
            let [lowest, next] = [0, 1].map(|mode: usize| row.outputs[mode].value);
            assert!(lowest > 1e2 && next > lowest, "{lowest} {next}");
        }
        [0, 1, 2].map(|what: usize| built[what].load(Ordering::Relaxed))
    });
    assert_eq!(counts[0], counts[1], "structures, modes and inertias");
    assert_eq!(counts[0][..2], [1, 1]);
}
