//! The engine: finite elements and exact contact of bodies on moving frames, as programs that embed it
//! need it. It knows nothing of the Calyx language: a scene is built in code, planned, solved and read.
//!
//! This crate is a facade. It re-exports the crates of which the engine is made, each of which names only
//! those before it: `calyx-numerics`, `calyx-fe`, `calyx-structure`, `calyx-contact`, `calyx-model`,
//! `calyx-solve`, `calyx-analysis`.
//!
//! # Two cylinders
//!
//! Steel, of 50 and 100 mm radius, pressed together with 10 kN on a face of 20 mm: half-width and peak pressure against Hertz.
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
//! // The lower cylinder is held; the upper one may sink, and does so under its load.
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
//! // One position, at time 0; a mechanism would have many.
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
//! # The way through
//!
//! ```text
//! Scene ──> Plan ──────> System ───────> StepResult ─> Observed ─> AnalysisResult
//!  bodies,   what is      structures      pressures,    values      rows, summaries,
//!  pairs,    modelled,    condensed,      motions,                  certificate
//!  loads     and why      freedoms        certificate
//! ```
//!
//! | module | what |
//! |---|---|
//! | [`scene`] | what there is: [`scene::Body`], [`scene::SurfacePair`], and what is observed of it; [`scene::Prototype`] is how a body is modelled |
//! | [`mechanism`], [`body`], [`pairs`], [`bearing`], [`dof`], [`ids`] | the parts of a scene that are simulated, whatever is observed of them |
//! | [`motion`], [`load`], [`material`], [`inertia`] | prescribed motions of frames, loads, materials, masses |
//! | [`disc`] | cylinders and platens; gears are in the crate `calyx-gears` |
//! | [`fidelity`], [`plan`], [`target`] | how bodies are modelled; what of the scene is modelled, what is left out, and why |
//! | [`validate`] | whether a requested analysis is possible: the rules that a check and a run share |
//! | [`restraint_check`] | whether contacts can hold what is free, known before anything is solved |
//! | [`system`], [`step`], [`integration`], [`vibrations`] | the planned mechanism, built; a position in equilibrium; a step in time; free vibrations |
//! | [`observables`], [`observed`] | values read off a solved position, one [`observables::Observable`] each |
//! | [`signal`] | outputs in the frequency domain: spectra, orders, transfer functions |
//! | [`analysis`], [`dynamics`], [`options`], [`position`], [`rows`], [`results`], [`summary`] | an analysis from options to results: [`analysis::Steps`] is the iterator over a list of positions, [`analysis::quasi_static`] reports to an observer |
//! | [`settings_override`] | settings of an analysis that are changed from outside the model |
//! | [`estimate`] | estimated errors of the statistics of outputs |
//! | [`tolerance`] | the cheapest setting whose estimated error meets a tolerance |
//! | [`cost`] | predicted time and memory of an analysis |
//! | [`resources`], [`cache`], [`interrupt`] | what an analysis uses and no result depends on: threads, stored structures, an interrupt |
//! | [`structure`], [`fe`], [`profile`], [`surface`] | elastic bodies by their surfaces, the finite elements behind them, the true curves contact sees |
//! | [`contact`] | closest approaches, grids, the contact problem and its exact solution |
//! | [`error`] | why the engine could not do what was asked: a code, a sentence, a remedy |
//!
//! # What holds everywhere
//!
//! * SI units: m, rad, s, N, N m, Pa. A plane model works per metre of face width inside; loads and results are of the whole width.
//! * A structure deforms relative to its body's frame; rigid motion belongs to the frame, whose free components are unknowns of the
//!   contact problem. Free bodies are normal.
//! * Every solution carries a [`contact::problem::Certificate`]: complementarity, penetration, tension and equilibrium, relative to
//!   the problem's own scale.
//! * The same scene gives the same bits, whatever the number of threads, what was solved before, and what a cache holds.
//! * Nothing panics on what a scene can say; errors are [`error::EngineError`]s.
//!
//! # Where to go next
//!
//! `calyx-gears` opens with a gear pair analysed over its mesh cycle. A body of a kind of your own implements [`scene::Prototype`]:
//! the source of [`disc`] is the shortest example. A frame's own motion implements [`motion::Motion`]; a load is a closure of time
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
