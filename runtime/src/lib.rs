//! Finite element and contact engine for gear systems: elastic bodies on moving frames, coupled by
//! exact contact conditions.
//!
//! The engine does not depend on the Calyx language. A program builds a scene, plans the analysis,
//! solves it and reads the results.
//!
//! This crate is a facade. It re-exports the crates of the engine, each of which depends only on
//! those before it: `calyx-numerics`, `calyx-fe`, `calyx-structure`, `calyx-contact`,
//! `calyx-model`, `calyx-solve`, `calyx-analysis`.
//!
//! # Two cylinders
//!
//! Two steel cylinders of 50 and 100 mm radius and 20 mm face width are pressed together with
//! 10 kN. The example compares the contact half-width and the maximum pressure with Hertz.
//!
//! ```
//! use calyx_runtime::analysis::{AnalysisOptions, Position, Steps};
//! use calyx_runtime::disc::Disc;
//! use calyx_runtime::load::Wrench;
//! use calyx_runtime::material::{Material, Plane};
//! use calyx_runtime::motion::SteadyRotation;
//! use calyx_runtime::observables::MaxContactPressure;
//! use calyx_runtime::results::OutputRequest;
//! use calyx_runtime::scene::{Body, Component, Scene, SurfacePair};
//! use std::f64::consts::PI;
//! use std::sync::Arc;
//!
//! let (radii, face_width, force) = ([0.05, 0.1], 0.02, 10e3);
//! let [lower, upper] = radii.map(|radius| Arc::new(Disc::new(radius, face_width, Material::STEEL)));
//!
//! // The lower cylinder is fixed; the upper one is free to move along y and is loaded.
//! let mut scene = Scene::default();
//! let lower = scene.add_body(Body::new("lower", lower, SteadyRotation::at_rest([0.0, -radii[0]])));
//! let upper = scene.add_body(
//!     Body::new("upper", upper, SteadyRotation::at_rest([0.0, radii[1]]))
//!         .free_in(&[Component::Uy])
//!         .loaded(Wrench::of_force([0.0, -force, 0.0])),
//! );
//! let contact = scene.add_pair(SurfacePair::new([lower, upper], [Disc::TOP, Disc::BOTTOM]));
//! let peak = scene.observe(MaxContactPressure(contact));
//!
//! // One position, at time 0. A mechanism is solved at many positions.
//! let positions = [Position::at(0.0)];
//! let outputs = [OutputRequest::observing("peak pressure", peak)];
//! let mut steps = Steps::new(&scene, &positions, &outputs, &AnalysisOptions::default())?;
//! let solved = steps.next().expect("there is one position")?;
//! assert!(solved.certificate.largest() < 1e-12);
//! let peak = solved.row.outputs[0].value;
//! let half_width = steps.current().and_then(|step| step.patches[0].half_width()).expect("it is solved");
//!
//! // Hertz (Johnson, Contact Mechanics, eqs. 4.43 to 4.45): a² = 4 q R / (π E*), p = 2 q / (π a).
//! let line_load = force / face_width;
//! let radius = radii[0] * radii[1] / (radii[0] + radii[1]);
//! let modulus = 0.5 * Material::STEEL.surface_modulus(Plane::Strain);
//! let expected = (4.0 * line_load * radius / (PI * modulus)).sqrt();
//! assert!((half_width / expected - 1.0).abs() < 0.01);
//! assert!((peak / (2.0 * line_load / (PI * expected)) - 1.0).abs() < 0.005);
//! # Ok::<(), calyx_runtime::error::EngineError>(())
//! ```
//!
//! # Data flow
//!
//! ```text
//! Scene ──> Plan ──────> System ───────> StepResult ─> Observed ─> AnalysisResult
//!  bodies,   models of    condensed       pressures,    values      rows, summaries,
//!  pairs,    the bodies,  structures,     motions,                  certificate
//!  loads     reasons      DOFs            certificate
//! ```
//!
//! | module | contents |
//! |---|---|
//! | [`scene`] | model: [`scene::Body`], [`scene::SurfacePair`], observables; [`scene::Prototype`] builds the structure of a body |
//! | [`mechanism`], [`body`], [`pairs`], [`bearing`], [`dof`], [`ids`] | simulated parts of a scene, without observables |
//! | [`motion`], [`load`], [`material`], [`inertia`] | prescribed motions, external loads, materials, masses |
//! | [`disc`] | cylinders and platens; gears are in the crate `calyx-gears` |
//! | [`fidelity`], [`plan`], [`target`] | fidelity levels; parts of the scene that are modelled or left out, with reasons |
//! | [`validate`] | checks of a requested analysis, shared by the language server and by runs |
//! | [`restraint_check`] | restraint check: rejects free motions without resistance before anything is solved |
//! | [`system`], [`step`], [`integration`], [`vibrations`] | system of the planned mechanism; equilibrium at one position; time step; free vibrations |
//! | [`observables`], [`observed`] | evaluation of each [`observables::Observable`] at a solved position |
//! | [`signal`] | outputs in the frequency domain: spectra, orders, transfer functions |
//! | [`analysis`], [`dynamics`], [`options`], [`position`], [`rows`], [`results`], [`summary`] | an analysis from options to results: [`analysis::Steps`] is the iterator over a list of positions, [`analysis::quasi_static`] reports to an observer |
//! | [`settings_override`] | settings overrides from outside the model |
//! | [`estimate`] | error estimates of the statistics of outputs |
//! | [`tolerance`] | search for the cheapest setting whose estimated error satisfies a tolerance |
//! | [`cost`] | predicted time and memory of an analysis |
//! | [`resources`], [`cache`], [`interrupt`] | threads, structure cache and cancellation; no result depends on them |
//! | [`structure`], [`fe`], [`profile`], [`surface`] | elastic bodies with their surfaces, finite elements, exact profiles and surfaces for contact |
//! | [`contact`] | closest approach, contact grids, contact problem and its exact solution |
//! | [`error`] | errors with a code, a message and a remedy |
//!
//! # Conventions
//!
//! * Quantities are in SI units: m, rad, s, N, N m, Pa. Internally a plane model works per metre of
//!   face width; loads and results refer to the whole face width.
//! * A structure deforms relative to the frame of its body. The frame carries the rigid-body
//!   motion, and its free components are unknowns of the contact problem. Unconstrained bodies are
//!   allowed.
//! * Every solution has a [`contact::problem::Certificate`]: residuals of complementarity,
//!   penetration, tension and equilibrium, relative to the scale of the problem.
//! * The same scene gives bitwise equal results for any number of threads, any earlier analyses and
//!   any content of the cache.
//! * No scene makes the engine panic; errors are [`error::EngineError`]s.
//!
//! # Where to start
//!
//! The documentation of `calyx-gears` starts with the analysis of a gear pair over its mesh cycle.
//! New kinds of bodies implement [`scene::Prototype`]; the source of [`disc`] is the shortest
//! example. New prescribed motions implement [`motion::Motion`]. A load is a closure of time
//! ([`load::Load`]).

#![warn(missing_docs)]

pub use calyx_analysis::{
    analysis, cost, dynamic_options, dynamics, estimate, observables, options, results, rows, scene,
    settings_override, signal, summary, tolerance, validate,
};
pub use calyx_contact as contact;
pub use calyx_fe as fe;
pub use calyx_fe::{inertia, material};
pub use calyx_model::{
    bearing, body, disc, dof, fidelity, ids, load, mechanism, motion, observed, pairs, plan, position,
    prototype, resources, rigid, spline_contact, target,
};
pub use calyx_numerics::{error, interrupt};
pub use calyx_solve::{integration, restraint_check, step, system, vibrations};
pub use calyx_structure as structure;
pub use calyx_structure::{cache, profile, surface};
