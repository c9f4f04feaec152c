//! Tests of several crates together, one module per subject. They are one program: it is linked
//! once, and its tests run in parallel.

mod architecture;
mod bearing_curves;
mod bevel_analytic;
mod bevel_pair;
mod carriers;
mod data_block;
mod derived_quantities;
mod docs;
mod drive_sense;
mod dynamics_in_space;
mod elastic_bodies;
mod examples;
mod face_gear;
mod flank_charts;
mod forced_response;
mod former_names;
mod gear_data;
mod language;
mod library;
mod mesh_work;
mod microgeometry;
mod models;
mod pair_form;
mod published_blocks;
mod ratings;
mod reference;
mod report;
mod rolling_bearings;
mod rust_scene;
mod same_scene;
mod shafts;
mod theory;
mod tooth_contact;
mod tribology;
mod whirl;
