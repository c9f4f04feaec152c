//! The chapter 5 pair in three dimensions: its parameters, the scene, and the outputs at roll
//! angles of the pinion.

use crate::common::{INCH, resources};
use calyx_gears::assembly::{MeshOptions, add_body, mesh};
use calyx_gears::blank::{GearBlank, Rim, Thickness};
use calyx_gears::modification::{Modification, ReliefShape};
use calyx_gears::prototype::GearPrototype;
use calyx_gears::rack::Rack;
use calyx_runtime::analysis::{AnalysisOptions, Position, quasi_static};
use calyx_runtime::bearing::{Bearing, axisymmetric};
use calyx_runtime::load::Wrench;
use calyx_runtime::material::Material;
use calyx_runtime::motion::SteadyRotation;
use calyx_runtime::observables::{
    MaxContactPressure, MaxEdgePressure, MaxRootStress, MeshStiffness, TransmissionError,
};
use calyx_runtime::results::OutputRequest;
use calyx_runtime::scene::{Body, Component, Fidelity, GearMesh, Scene, StructureOptions};
use serde_json::Value;
use std::borrow::Cow;
use std::f64::consts::TAU;
use std::sync::Arc;

pub const PSI: f64 = 6894.757293168361;
const LBF: f64 = 4.4482216152605;

/// Parameters of the pair. Inches.
#[derive(Clone, Copy, Debug)]
pub struct Pair {
    pub tip_radius: f64,
    pub thickness: f64,
    /// Amounts of the quadratic tip reliefs, and of the crowns.
    pub relief: f64,
    pub crown: f64,
    pub poissons_ratio: f64,
    /// Contact of the tip edges before and after the nominal path.
    pub tip_corner_contact: bool,
    /// Radial stiffness of the bearing under the pinion, N/m; `None` for a fixed pinion.
    pub bearing: Option<f64>,
    pub face_width: f64,
    /// Inner diameters of the rims.
    pub bores: [f64; 2],
    /// Torque on the pinion, lbf in.
    pub torque: f64,
}

/// Parameters of the report's tables.
pub const CHAPTER_5: Pair = Pair {
    tip_radius: 0.02,
    thickness: 0.15708,
    relief: 0.0005,
    crown: 0.0005,
    poissons_ratio: 0.3,
    tip_corner_contact: false,
    bearing: None,
    face_width: 1.0,
    bores: [1.20, 2.40],
    torque: 1000.0,
};
/// The pair without modifications.
pub const PLAIN: Pair = Pair { relief: 0.0, crown: 0.0, ..CHAPTER_5 };

/// Outputs at a position. Stresses and pressures in psi, transmission error in inches on the gear's
/// base circle.
#[derive(Clone, Copy, Debug)]
pub struct Values {
    pub transmission_error: f64,
    pub mesh_stiffness: f64,
    /// Pressure on flanks, and on patches that lie on tip edges or end at them.
    pub contact_pressure: f64,
    pub edge_pressure: f64,
    pub root_stress: [f64; 2],
    /// Largest residual of the solution, see its certificate.
    pub residual: f64,
}

impl Pair {
    /// The pinion (0) or the wheel.
    pub fn gear(&self, number: usize) -> Arc<GearPrototype> {
        let steel = Material::new(3e7 * PSI, self.poissons_ratio, 7850.0).expect("steel");
        let rack = Rack::new(0.1 * INCH, 20_f64.to_radians(), self.tip_radius * INCH).expect("a rack");
        let (teeth, [outer, root], rim, relief_from) = match number {
            0 => (20, [2.18, 1.76], [1.40, self.bores[0]], 27.25_f64),
            _ => (40, [4.18, 3.78], [3.40, self.bores[1]], 19.60),
        };
        let blank = GearBlank::standard(teeth, rack)
            .diameters(outer * INCH, root * INCH)
            .thickness(Thickness::Circular(self.thickness * INCH))
            .face_width(self.face_width * INCH)
            .material(steel)
            .rim(Rim::new(rim[0] * INCH, rim[1] * INCH).expect("a rim"));
        let relief =
            Modification::tip_relief(self.relief * INCH, relief_from.to_radians(), ReliefShape::Quadratic);
        let crown = Modification::lead_crown(self.crown * INCH).expect("a crown");
        blank.modified(relief).modified(crown).cut().expect("a gear")
    }

    /// Scene of both gears with contact on the nominal path only, their mesh and the outputs.
    pub fn scene(&self) -> (Scene, GearMesh, Vec<OutputRequest>) {
        let [pinion, wheel] = [0, 1].map(|number| self.gear(number));
        let speed = 0.05 * TAU;
        let torque = self.torque * LBF * INCH;
        let mut scene = Scene::default();
        let turning = |origin, speed| SteadyRotation { origin, start: 0.0, speed };
        let across: &[Component] = if self.bearing.is_some() { &[Component::Ux, Component::Uy] } else { &[] };
        let pinion = add_body(
            &mut scene,
            Body::new("pinion", pinion, turning([0.0; 2], speed))
                .free_in(&[Component::ThetaZ])
                .free_in(across)
                .loaded(Wrench::of_moment([0.0, 0.0, torque])),
        )
        .expect("a body");
        if let Some(radial) = self.bearing {
            let bearing = Bearing::new("bearing", pinion, 0.0, axisymmetric(radial, 0.0, 0.0, 0.0));
            scene.add_bearing(bearing).expect("a bearing");
        }
        let wheel = add_body(&mut scene, Body::new("wheel", wheel, turning([3.0 * INCH, 0.0], -0.5 * speed)))
            .expect("a body");
        let options = MeshOptions { tip_corner_contact: self.tip_corner_contact, ..MeshOptions::default() };
        let pair = mesh(&mut scene, pinion, wheel, &options).expect("a mesh").pair;
        let outputs = vec![
            OutputRequest::observing("te", scene.add_observable(TransmissionError(pair))),
            OutputRequest::observing("stiffness", scene.add_observable(MeshStiffness(pair))),
            OutputRequest::observing("pressure", scene.add_observable(MaxContactPressure(pair))),
            OutputRequest::observing("pinion", scene.add_observable(MaxRootStress(pinion))),
            OutputRequest::observing("wheel", scene.add_observable(MaxRootStress(wheel))),
            OutputRequest::observing("edge", scene.add_observable(MaxEdgePressure(pair))),
        ];
        let cycle = scene.pairs[pair.0].mesh.clone().expect("gears in mesh");
        (scene, cycle, outputs)
    }

    /// Solves positions given by the roll angle of the pinion's entering tooth, degrees.
    pub fn solve(&self, fidelity: &str, structure: StructureOptions, rolls: &[f64]) -> Vec<Values> {
        let (scene, cycle, outputs) = self.scene();
        let position = |roll: &f64| {
            let part = (roll.to_radians() - cycle.roll[0]) / (cycle.roll[1] - cycle.roll[0]);
            Position {
                time: cycle.start + part * cycle.period,
                cycle: part,
                roll: roll.to_radians(),
                name: Cow::Borrowed(""),
            }
        };
        let positions: Vec<Position> = rolls.iter().map(position).collect();
        let options = AnalysisOptions {
            fidelity: Fidelity::named(fidelity).expect("a fidelity"),
            structure,
            resources: resources(),
            ..AnalysisOptions::default()
        };
        let result = quasi_static(&scene, &positions, &outputs, &options, &mut ()).expect("equilibrium");
        let values = result.rows.iter().map(|row| {
            let value = |output: usize| row.outputs[output].value;
            Values {
                transmission_error: value(0) * cycle.base_radii[1] / INCH,
                mesh_stiffness: value(1),
                contact_pressure: value(2) / PSI,
                edge_pressure: value(5) / PSI,
                root_stress: [value(3) / PSI, value(4) / PSI],
                residual: result.certificate.largest(),
            }
        });
        values.collect()
    }

    /// Largest root stress of both members over the cycle, psi.
    pub fn root_stress(&self, fidelity: &str, structure: StructureOptions) -> f64 {
        let values = self.solve(fidelity, structure, &[AT_LOWEST, AT_HIGHEST]);
        values.iter().flat_map(|v| v.root_stress).fold(0.0, f64::max)
    }
}

/// Roll angles of the pinion with the largest root stresses: just after the leaving pair has left,
/// for the gear, and just before the next one enters, for the pinion.
pub const AT_LOWEST: f64 = 15.69;
pub const AT_HIGHEST: f64 = 24.8;

pub fn reference() -> Value {
    serde_json::from_str(include_str!("../data/spur_pair_solid.json")).expect("sound data")
}
