//! The engine: plane finite elements and exact contact of bodies on moving frames. A library of its own, which knows nothing of the
//! Calyx language: a scene is built in code, planned, solved and read.
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
//! use calyx_runtime::observe::MaxContactPressure;
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
//! | [`scene`] | what there is: [`scene::Body`], [`scene::SurfacePair`]; [`scene::Prototype`] is how a body is modelled |
//! | [`motion`], [`load`], [`material`], [`inertia`] | where frames are meant to be, what acts on them, what bodies are made of and weigh |
//! | [`bearing`] | what connects bodies to each other and to ground besides contact |
//! | [`disc`] | cylinders and platens; gears are in the crate `calyx-gears` |
//! | [`plan`] | what of the scene is modelled, what is left out, and why |
//! | [`validate`] | whether a requested analysis is possible: the rules that a check and a run share |
//! | [`holding`] | whether contacts can hold what is free, known before anything is solved |
//! | [`system`], [`step`], [`observe`] | the planned scene, built; a position in equilibrium; values read off it, one [`observe::Observable`] each |
//! | [`signal`] | outputs in the frequency domain: spectra, orders, transfer functions |
//! | [`analysis`], [`results`], [`summary`] | a list of positions: [`analysis::Steps`] is the iterator, [`analysis::quasi_static`] tells an observer |
//! | [`overriding`] | knobs of an analysis that somebody outside the model turns |
//! | [`estimate`] | how wrong outputs are: estimates of the errors of their statistics |
//! | [`tolerance`] | the cheapest setting whose estimated error keeps to one |
//! | [`resources`], [`cache`], [`interrupt`] | what an analysis uses and no result depends on: threads, kept structures, a way to end it |
//! | [`structure`], [`fe`], [`profile`] | elastic bodies by their surfaces, the finite elements behind them, the true curves contact sees |
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

pub mod analysis;
pub mod bearing;
mod building;
pub mod cache;
pub mod contact;
pub mod cost;
mod dense;
pub mod disc;
pub mod dynamics;
pub mod error;
pub mod estimate;
pub mod fe;
pub mod holding;
pub mod inertia;
pub mod interrupt;
pub mod load;
pub mod lug_contact;
pub mod material;
pub mod motion;
pub mod observe;
pub mod overriding;
pub mod plan;
pub mod profile;
pub mod resources;
pub mod results;
pub mod rigid;
pub mod scene;
pub mod signal;
pub mod step;
pub mod structure;
pub mod summary;
pub mod surface;
pub mod system;
pub mod tolerance;
pub mod validate;
