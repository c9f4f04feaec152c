//! Simulation engine: finite elements and exact contact of bodies on moving frames, as a library
//! for programs that embed it. The engine is independent of the Calyx language: a program builds a
//! scene in code, plans and solves it, and reads the results.
//!
//! This crate is a facade. It re-exports the crates of the engine, each of which depends only on
//! those before it: `calyx-numerics`, `calyx-fe`, `calyx-structure`, `calyx-contact`,
//! `calyx-rolling`, `calyx-acoustics`, `calyx-model`, `calyx-solve`, `calyx-analysis`.
//!
//! # Example: two cylinders
//!
//! Two steel cylinders with radii of 50 and 100 mm and a face width of 20 mm are pressed together
//! with 10 kN. The example compares half-width and peak pressure with Hertz.
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
//! let cylinder = |radius| Arc::new(Disc::new(radius, face_width, Material::STEEL));
//! let [lower, upper] = radii.map(cylinder);
//!
//! // The lower cylinder is fixed; the upper one moves vertically under its load.
//! let mut scene = Scene::default();
//! let at_rest = |y| SteadyRotation::at_rest([0.0, y]);
//! let lower = scene.add_body(Body::new("lower", lower, at_rest(-radii[0])));
//! let upper = scene.add_body(
//!     Body::new("upper", upper, at_rest(radii[1]))
//!         .free_in(&[Component::Uy])
//!         .loaded(Wrench::of_force([0.0, -force, 0.0])),
//! );
//! let contact = scene.add_pair(SurfacePair::new([lower, upper], [Disc::TOP, Disc::BOTTOM]));
//! let peak = scene.add_observable(MaxContactPressure(contact));
//!
//! // One position at time 0; a mechanism would have many.
//! let positions = [Position::at(0.0)];
//! let outputs = [OutputRequest::observing("peak pressure", peak)];
//! let mut steps = Steps::new(&scene, &positions, &outputs, &AnalysisOptions::default())?;
//! let solved = steps.next().expect("there is one position")?;
//! assert!(solved.certificate.largest() < 1e-12);
//! let peak = solved.row.outputs[0].value;
//! let step = steps.current().expect("a solved position");
//! let half_width = step.patches[0].half_width().expect("a loaded patch");
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
//! # From scene to results
//!
//! ```text
//! Scene ──> Plan ──────> System ───────> StepResult ─> Observed ─> AnalysisResult
//!  bodies,   what is      structures,    pressures,    values      rows, summaries,
//!  pairs,    modelled,    condensed;     motions,                  certificate
//!  loads     and why      DOFs           certificate
//! ```
//!
//! | module | contents |
//! |---|---|
//! | [`scene`] | bodies ([`scene::Body`]), surface pairs ([`scene::SurfacePair`]) and observables; [`scene::Prototype`] defines how a body is modelled |
//! | [`mechanism`], [`body`], [`pairs`], [`bearing`], [`dof`], [`ids`] | the simulated parts of a scene, independent of its observables |
//! | [`connection`], [`shaft`], [`elastic_body`] | linear elastic parts between bodies |
//! | [`motion`], [`load`], [`material`], [`inertia`] | prescribed motions of frames, loads, materials, masses |
//! | [`lubrication`] | friction, flash temperature and film thickness at a point of contact |
//! | [`disc`] | cylinders and platens; gears are in the crate `calyx-gears` |
//! | [`fidelity`], [`plan`], [`target`] | fidelity levels of bodies; the parts of the scene that are modelled or omitted, with reasons |
//! | [`validate`], [`method`] | rules of a valid analysis, shared by check and run |
//! | [`analyses`] | the interface of an analysis, implemented by the options of each |
//! | [`restraint_check`] | check before solving that contacts and supports restrain all free components |
//! | [`system`], [`step`], [`integration`], [`vibrations`] | the built mechanism; equilibrium of a position; time step; free vibrations |
//! | [`observables`], [`observed`] | values of a solved position, one [`observables::Observable`] each |
//! | [`signal`] | outputs in the frequency domain: spectra, orders, transfer functions |
//! | [`analysis`], [`dynamics`], [`options`], [`position`], [`rows`], [`results`], [`summary`] | analyses from options to results: [`analysis::Steps`] iterates over a list of positions, [`analysis::quasi_static`] reports to an observer |
//! | [`settings_override`] | settings of an analysis from outside the model |
//! | [`sensitivity`] | derivatives of outputs with respect to params |
//! | [`estimate`] | estimated errors of the statistics of outputs |
//! | [`tolerance`] | search for the cheapest setting whose estimated error meets a tolerance |
//! | [`cost`] | predicted time and memory of an analysis |
//! | [`resources`], [`cache`], [`interrupt`] | resources without influence on results: threads, stored structures, an interrupt |
//! | [`elastic`] | finite-element models of bodies of any shape, and their import |
//! | [`structure`], [`fe`], [`profile`], [`surface`] | elastic bodies with their contact surfaces, finite elements, exact profile curves |
//! | [`rolling`] | rolling bearings |
//! | [`radiated_sound`], [`acoustics`] | sound of elastic bodies in a forced response, and of any vibrating surface |
//! | [`deck_mesh`] | meshes of NASTRAN decks, for the sound of results on them |
//! | [`contact`] | closest approaches, grids, the contact problem and its exact solution |
//! | [`error`] | errors of the engine: code, message, remedy |
//! | [`vec3`] | vectors in three dimensions |
//!
//! # Conventions
//!
//! * SI units: m, rad, s, N, N m, Pa. A plane model uses quantities per metre of face width
//!   internally; loads and results are for the whole width.
//! * Deformations are relative to the body's frame. Rigid-body motion belongs to the frame, whose
//!   free components are unknowns of the contact problem. Bodies with free components are the
//!   normal case.
//! * Every solution has a [`contact::problem::Certificate`]: complementarity, penetration, tension
//!   and equilibrium residuals, relative to the scale of the problem.
//! * Results are bitwise reproducible: they are independent of the number of threads, of earlier
//!   analyses and of the cache contents.
//! * The engine does not panic on any scene; errors are [`error::EngineError`]s.
//!
//! # Further reading
//!
//! The documentation of `calyx-gears` begins with an analysis of a gear pair over its mesh cycle. A
//! new kind of body implements [`scene::Prototype`]; the source of [`disc`] is the shortest
//! example. A new motion of a frame implements [`motion::Motion`]; a load is a closure of time
//! ([`load::Load`]).

#![warn(missing_docs)]

mod former_names;

pub use calyx_acoustics as acoustics;
pub use calyx_analysis::{
    analyses, analysis, component_loads, cost, deck_mesh, dynamic_options, dynamics, estimate,
    forced_response, method, observables, options, radiated_sound, results, rows, scene, sensitivity,
    settings_override, signal, summary, tolerance, validate,
};
pub use calyx_contact as contact;
pub use calyx_elastic as elastic;
pub use calyx_fe as fe;
pub use calyx_fe::{inertia, material};
pub use calyx_model::{
    bearing, body, connection, disc, dof, elastic_body, fidelity, ids, load, lubrication, mechanism,
    mesh_carrier, motion, observed, pairs, plan, position, prototype, resources, rigid, shaft,
    spline_contact, target,
};
pub use calyx_numerics::{error, interrupt, stress, vec3};
pub use calyx_rolling as rolling;
pub use calyx_solve::{integration, restraint_check, step, system, vibrations};
pub use calyx_structure as structure;
pub use calyx_structure::{cache, profile, surface};
#[expect(deprecated, reason = "former names work for one version")]
pub use former_names::{freedom, holding, lug_contact, observe, overriding};
