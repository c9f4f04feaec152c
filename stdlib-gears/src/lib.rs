//! Involute gears for the engine, in Rust: geometry, tooth meshes, and gear pairs in a scene. The
//! gear library of the Calyx language is part of this crate; its functions wrap those of the crate.
//!
//! # From the rack to the stress
//!
//! | step | item |
//! |---|---|
//! | tool | [`rack::Rack`], for internal gears [`shaper::Shaper`] |
//! | gear blank | [`blank::GearBlank`]: teeth, diameters, [`blank::Rim`], [`modification::Modification`]s, pitch deviations |
//! | checked gear | [`blank::GearBlank::cut`] returns a [`prototype::GearPrototype`], from which a body of the engine's [`Scene`] is made |
//! | bodies on their frames | [`assembly::add_body`] |
//! | mesh | [`assembly::mesh`]: drive flanks, phase, mesh cycle |
//! | positions | [`mesh_cycle`] |
//! | analysis | [`Steps`], or [`quasi_static`] with an observer |
//!
//! All quantities are SI: m, rad, N, N m, Pa. Errors of a gear or a pair are data
//! ([`error::Refusal`]): a stable code, the argument to blame, a reason and a remedy.
//!
//! # Example: a spur pair
//!
//! Gears of 20 and 40 teeth with diametral pitch 10 and a quadratic tip relief, the pair of the
//! design report's chapter 5. It is the model `examples/spur_pair.cx` of the language, with results
//! that are equal to the last bit.
//!
//! ```
//! use calyx_gears::assembly::{MeshOptions, add_body, mesh};
//! use calyx_gears::blank::{GearBlank, Rim, Thickness};
//! use calyx_gears::modification::Modification;
//! use calyx_gears::modification::ReliefShape::Quadratic;
//! use calyx_gears::rack::Rack;
//! use calyx_runtime::analysis::{AnalysisOptions, mesh_cycle, quasi_static};
//! use calyx_runtime::load::Wrench;
//! use calyx_runtime::material::Material;
//! use calyx_runtime::motion::SteadyRotation;
//! use calyx_runtime::observables::{MaxRootStress, TransmissionError};
//! use calyx_runtime::results::OutputRequest;
//! use calyx_runtime::scene::{Body, Component, Scene};
//! use std::f64::consts::TAU;
//!
//! const INCH: f64 = 0.0254;
//! const PSI: f64 = 6894.757293168361;
//!
//! let steel = Material::new(3e7 * PSI, 0.3, 7850.0)?;
//! let rack = Rack::new(0.1 * INCH, 20_f64.to_radians(), 0.02 * INCH)?;
//! let gear = |teeth, [outer, root]: [f64; 2], rim: [f64; 2], relief_from: f64| {
//!     GearBlank::standard(teeth, rack)
//!         .diameters(outer * INCH, root * INCH)
//!         .thickness(Thickness::Circular(0.15708 * INCH))
//!         .face_width(INCH)
//!         .material(steel)
//!         .rim(Rim::new(rim[0] * INCH, rim[1] * INCH)?)
//!         .modified(Modification::tip_relief(0.0005 * INCH, relief_from.to_radians(), Quadratic))
//!         .cut()
//! };
//! let pinion = gear(20, [2.18, 1.76], [1.40, 1.20], 27.25)?;
//! let wheel = gear(40, [4.18, 3.78], [3.40, 2.40], 19.60)?;
//!
//! // The pinion rotates at 3 rpm, is free about its axis and driven by 1000 lbf inch; the wheel is
//! // fixed to its frame.
//! let speed = 3.0 * TAU / 60.0;
//! let torque = 1000.0 * 4.4482216152605 * INCH;
//! let mut scene = Scene::default();
//! let pinion = add_body(
//!     &mut scene,
//!     Body::new("pinion", pinion, SteadyRotation { origin: [0.0; 2], start: 0.0, speed })
//!         .free_in(&[Component::ThetaZ])
//!         .loaded(Wrench::of_moment([0.0, 0.0, torque])),
//! )?;
//! let (origin, speed) = ([3.0 * INCH, 0.0], -speed * 20.0 / 40.0);
//! let motion = SteadyRotation { origin, start: 0.0, speed };
//! let wheel = add_body(&mut scene, Body::new("wheel", wheel, motion))?;
//! let meshed = mesh(&mut scene, pinion, wheel, &MeshOptions::default())?;
//! assert!((meshed.geometry.contact_ratio - 1.6).abs() < 0.2);
//!
//! let error = scene.add_observable(TransmissionError(meshed.pair));
//! let stress = scene.add_observable(MaxRootStress(pinion));
//! let outputs = [
//!     OutputRequest::observing("transmission error", error),
//!     OutputRequest::observing("root stress", stress),
//! ];
//! let cycle = scene.pairs[meshed.pair.0].mesh.as_ref().expect("gears are in mesh");
//! let positions = mesh_cycle(cycle, 4);
//! let result = quasi_static(&scene, &positions, &outputs, &AnalysisOptions::default(), &mut ())?;
//!
//! // The certificate contains the equilibrium residuals of all positions.
//! assert!(result.certificate.largest() < 1e-12);
//! let [error, stress] = [&result.summaries[0], &result.summaries[1]];
//! println!("transmission error {:.1} µrad peak to peak", error.peak_to_peak * 1e6);
//! let roll = positions[stress.at_max].roll.to_degrees();
//! println!("root stress {:.0} MPa at roll {roll:.1} deg", stress.max * 1e-6);
//! assert!(error.peak_to_peak > 0.0 && stress.max > 100e6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Further reading
//!
//! * User-defined loads and flanks: [`calyx_runtime::load::Load`] is a constant or a closure of
//!   time, [`deviation::Deviation`] a closure of the roll angle.
//! * Geometry without an analysis: [`external::ExternalGear`], [`internal::InternalGear`],
//!   [`mesh_geometry::MeshGeometry`], and [`derived_quantities`] with the quantities of ISO 21771
//!   that follow from them.
//! * Models and solvers for a scene: [`calyx_runtime`].
//! * The language's library: [`library`] (its source), [`externs`] (its functions), [`host`] (the
//!   state of a running model), [`tables`].
//!
//! [`Scene`]: calyx_runtime::scene::Scene
//! [`mesh_cycle`]: calyx_runtime::analysis::mesh_cycle
//! [`Steps`]: calyx_runtime::analysis::Steps
//! [`quasi_static`]: calyx_runtime::analysis::quasi_static

#![warn(missing_docs)]

mod accepted_meshes;
pub mod analyses;
mod analytic;
pub mod assembly;
mod axes;
pub mod basic_rack;
pub mod bearing_externs;
mod bearing_sizes;
pub mod blank;
pub mod body_externs;
pub mod calculation;
pub mod carrier_externs;
pub mod carriers;
pub mod cutting_externs;
pub mod data_block;
pub mod derived_quantities;
pub mod deviation;
pub mod drawing_externs;
pub mod dynamics_externs;
pub mod elastic_bodies;
pub mod elastic_externs;
mod elastic_plausibility;
pub mod error;
pub mod external;
pub mod externs;
pub mod files;
pub mod fillet;
pub mod flank;
pub mod flank_tolerances;
pub mod gauge_externs;
pub mod gear;
pub mod gear_surface;
pub mod general_mesh;
pub mod helix;
pub mod host;
mod inertia;
pub mod internal;
pub mod involute;
pub mod library;
mod load_plausibility;
pub mod lubrication_externs;
pub mod lumped_externs;
pub mod lumped_planetary;
pub mod lumped_scene;
pub mod material_names;
pub mod mesh_externs;
pub mod mesh_geometry;
pub mod modification;
pub mod modification_externs;
mod modified_structure;
pub mod mounting;
pub mod observable_externs;
mod outer_surface;
pub(crate) mod phase_check;
mod plausibility;
pub mod power_flow;
pub mod prototype;
mod protuberance;
mod raceway_checks;
pub mod rack;
mod relief;
pub mod rolling_catalogue;
pub mod rolling_externs;
mod root_finding;
pub mod roughing;
pub mod sector_mesh;
pub mod sensitivity_externs;
pub mod shaft_externs;
pub mod shafts;
pub mod shaper;
pub mod signal_externs;
mod size;
pub mod solid_prototype;
pub mod sound_externs;
mod stated_gear;
pub mod stated_geometry;
mod stated_thickness;
mod stress_recovery;
pub mod table_splines;
pub mod tables;
pub mod tabulated;
pub mod tabulated_externs;
pub mod template;
pub mod warning_externs;
pub mod web;

/// Former name of [`web`].
#[deprecated(since = "0.1.0", note = "use `web`")]
pub mod disc_web {
    pub use crate::web::{DiscWeb, Hub};
}
