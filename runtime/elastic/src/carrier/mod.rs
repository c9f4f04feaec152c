//! Planet carriers from a few dimensions: plates, webs between them and pins of the planets, as a
//! finite-element model.
//!
//! A plate is an annulus with a circular seat for each pin. Webs are sectors of a ring between two
//! plates, in the middle between neighbouring planets. Plates and webs share one conforming mesh of
//! hexahedra of 20 nodes: the plane mesh of a plate, extruded ([`plane_mesh`]). Pins are beams
//! between the inner faces of the plates; each end moves rigidly with its seat. All planets are
//! alike and equally spaced, and the mesh of one sector is repeated, so that the body is cyclically
//! symmetric.
//!
//! The coordinates of the body have their origin in the middle of the planets on the axis of the
//! carrier, the z axis along it, and the first planet on the x axis.
//!
//! See `docs/theory/elastic-bodies.md`.

mod extrusion;
mod plane_mesh;
mod planet_room;
mod shape;

pub use planet_room::Planet;
pub use shape::{CarrierShape, Webs};

use crate::model::{
    BeamProperties, BeamSection, Constraint, ElasticModel, Element, ElementKind, Material, Node, SolidShape,
};
use extrusion::Extrusion;
use plane_mesh::PlaneMesh;
use std::f64::consts::{PI, TAU};

/// Name of the set of nodes on the bore of the plate with the hub.
pub const HUB: &str = "hub";

/// Indices of the materials of a carrier in its model, all equal to the material of the carrier.
pub mod materials {
    /// Material of the plates.
    pub const PLATES: usize = 0;
    /// Material of the webs.
    pub const WEBS: usize = 1;
    /// Material of the pins.
    pub const PINS: usize = 2;
}

/// Finite-element model of a carrier.
#[derive(Clone, Debug, PartialEq)]
pub struct CarrierModel {
    /// The model. Its set [`HUB`] is the bore of the plate with the hub.
    pub model: ElasticModel,
    /// Node of each pin in the middle of its planet.
    pub pins: Vec<usize>,
}

/// Unit vectors along the basic axes.
const BASIC: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

impl CarrierShape {
    /// Generates the finite-element model. The shape must be valid ([`CarrierShape::check`]).
    pub fn model(&self, material: &Material) -> CarrierModel {
        let plane = PlaneMesh::new(self);
        let mut model = ElasticModel { materials: vec![material.clone(); 3], ..ElasticModel::default() };
        let mut extrusion = Extrusion::new(&plane, self.layers());
        for (layer, is_plate) in self.layers().iter().map(|layer| layer.plate.is_some()).enumerate() {
            for cell in plane.cells.iter().filter(|cell| is_plate || cell.web) {
                let nodes = extrusion.hexahedron(cell, layer);
                let material = if is_plate { materials::PLATES } else { materials::WEBS };
                model.elements.push(Element {
                    label: model.elements.len() as u64 + 1,
                    kind: ElementKind::Solid(SolidShape::Hexahedron20),
                    nodes,
                    material: Some(material),
                });
            }
        }
        model.nodes = extrusion
            .positions()
            .into_iter()
            .zip(1..)
            .map(|(position, label)| Node { label, position, axes: BASIC })
            .collect();
        model.sets.insert(HUB.into(), extrusion.nodes_of(&plane.bore, self.hub_plate()));
        let pins = (0..self.planets).map(|planet| self.add_pin(&mut model, &extrusion, &plane, planet));
        let pins = pins.collect();
        CarrierModel { model, pins }
    }

    /// Adds the pin of a planet and returns its node in the middle of the planet.
    fn add_pin(
        &self,
        model: &mut ElasticModel,
        extrusion: &Extrusion<'_>,
        plane: &PlaneMesh,
        planet: usize,
    ) -> usize {
        let angle = TAU * planet as f64 / self.planets as f64;
        let radius = 0.5 * self.pin_circle_diameter;
        let node = |model: &mut ElasticModel, z: f64| {
            let position = [radius * angle.cos(), radius * angle.sin(), z];
            model.nodes.push(Node { label: model.nodes.len() as u64 + 1, position, axes: BASIC });
            model.nodes.len() - 1
        };
        let middle = node(model, 0.0);
        for plate in 0..self.thickness.len() {
            let side = self.side(plate);
            let end = node(model, 0.5 * side * self.gap);
            let label = model.elements.len() as u64 + 1;
            model.elements.push(Element {
                label,
                kind: ElementKind::Beam(Box::new(self.pin_beam(model, angle))),
                nodes: vec![middle, end],
                material: Some(materials::PINS),
            });
            model.elements.push(Element {
                label: label + 1,
                kind: self.pin_in_plate(model, plate),
                nodes: vec![end],
                material: None,
            });
            let seat = extrusion.nodes_of(&plane.seats[planet], plate);
            let translations = [true, true, true, false, false, false];
            model.constraints.push(Constraint::Rigid {
                label: model.constraints.len() as u64 + 1,
                reference: end,
                dependents: seat.into_iter().map(|node| (node, translations)).collect(),
            });
        }
        middle
    }

    /// Returns the beam of a pin, whose plane of orientation contains the axis of the carrier.
    fn pin_beam(&self, model: &ElasticModel, angle: f64) -> BeamProperties {
        let [outside, bore] = [self.pin_diameter, self.pin_bore];
        let second_moment = PI / 64.0 * (outside.powi(4) - bore.powi(4));
        let nu = model.materials[materials::PINS].poissons_ratio;
        // Cowper (1966), for a circular section with a bore.
        let (ratio, sum) = ((bore / outside).powi(2), (1.0 + (bore / outside).powi(2)).powi(2));
        let shear = 6.0 * (1.0 + nu) * sum / ((7.0 + 6.0 * nu) * sum + (20.0 + 12.0 * nu) * ratio);
        let section = BeamSection {
            area: self.pin_area(),
            second_moment_z: second_moment,
            second_moment_y: second_moment,
            product_of_inertia: 0.0,
            torsion_constant: 2.0 * second_moment,
            shear_factors: [shear; 2],
            added_mass: 0.0,
        };
        BeamProperties {
            orientation: [angle.cos(), angle.sin(), 0.0],
            sections: [section; 2],
            offsets: [[0.0; 3]; 2],
            released: [[false; 6]; 2],
        }
    }

    fn pin_area(&self) -> f64 {
        0.25 * PI * (self.pin_diameter.powi(2) - self.pin_bore.powi(2))
    }

    /// Returns the mass of the part of a pin within a plate.
    fn pin_in_plate(&self, model: &ElasticModel, plate: usize) -> ElementKind {
        let length = self.thickness[plate];
        let mass = model.materials[materials::PINS].density * self.pin_area() * length;
        let square = (self.pin_diameter.powi(2) + self.pin_bore.powi(2)) / 16.0;
        let across = mass * (square + length * length / 12.0);
        let inertia = [[across, 0.0, 0.0], [0.0, across, 0.0], [0.0, 0.0, 2.0 * mass * square]];
        ElementKind::Mass { mass, offset: [0.0, 0.0, 0.5 * self.side(plate) * length], inertia }
    }
}
