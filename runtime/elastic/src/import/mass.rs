//! Mass, centre of mass and inertia of a model, by quadrature over its elements.

use super::geometry::{
    Vector, add, interpolate, norm, scale, shell_corners, shell_table, solid_table, sub, unit,
};
use crate::model::{ElasticModel, Element, ElementKind, ShellShape};

/// Mass, centre of mass and inertia about the origin.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MassProperties {
    /// Mass, kg.
    pub mass: f64,
    /// Centre of mass, m; zero for a body without mass.
    pub centre: [f64; 3],
    /// Inertia tensor about the origin, kg m².
    pub inertia: [[f64; 3]; 3],
}

/// Sums of mass, first moments and second moments.
#[derive(Default)]
struct Moments {
    mass: f64,
    first: Vector,
    second: [[f64; 3]; 3],
    /// Inertia of parts about their own centre of mass.
    own: [[f64; 3]; 3],
}

impl Moments {
    fn point(&mut self, mass: f64, at: Vector) {
        self.mass += mass;
        self.first = add(self.first, scale(at, mass));
        for i in 0..3 {
            for j in 0..3 {
                self.second[i][j] += mass * at[i] * at[j];
            }
        }
    }

    fn finish(self) -> MassProperties {
        let trace = self.second[0][0] + self.second[1][1] + self.second[2][2];
        let inertia = std::array::from_fn(|i| {
            std::array::from_fn(|j| if i == j { trace } else { 0.0 } - self.second[i][j] + self.own[i][j])
        });
        let centre = if self.mass == 0.0 { [0.0; 3] } else { scale(self.first, 1.0 / self.mass) };
        MassProperties { mass: self.mass, centre, inertia }
    }
}

/// Returns the mass properties of a model.
pub fn mass_properties(model: &ElasticModel) -> MassProperties {
    let mut moments = Moments::default();
    model.elements.iter().for_each(|element| accumulate(model, element, &mut moments));
    moments.finish()
}

/// Returns the mass properties of one element of a model.
pub fn element_mass_properties(model: &ElasticModel, element: &Element) -> MassProperties {
    let mut moments = Moments::default();
    accumulate(model, element, &mut moments);
    moments.finish()
}

fn accumulate(model: &ElasticModel, element: &Element, moments: &mut Moments) {
    let positions: Vec<Vector> = element.nodes.iter().map(|node| model.nodes[*node].position).collect();
    let density = element.material.map_or(0.0, |material| model.materials[material].density);
    match &element.kind {
        ElementKind::Solid(shape) => {
            for point in solid_table(*shape) {
                let volume = point.weight * point.jacobian(&positions);
                moments.point(density * volume, interpolate(&point.shapes, &positions));
            }
        }
        ElementKind::Shell { shape, thickness, offset, added_mass } => {
            let corners = match shell_corners(*shape) {
                3 => ShellShape::Triangle3,
                _ => ShellShape::Quadrilateral4,
            };
            for (point, corner) in shell_table(*shape).iter().zip(shell_table(corners)) {
                let normal = point.normal(&positions);
                let local: f64 =
                    corner.shapes.iter().zip(thickness).map(|(shape, value)| shape * value).sum();
                let middle = scale(unit(normal).unwrap_or_default(), *offset);
                let mass = point.weight * norm(normal) * (density * local + added_mass);
                moments.point(mass, add(interpolate(&point.shapes, &positions), middle));
            }
        }
        ElementKind::Beam(beam) => {
            let ends = [0, 1].map(|i| add(positions[i], beam.offsets[i]));
            let mass = beam.sections.map(|section| density * section.area + section.added_mass);
            slender(ends, mass, moments);
        }
        ElementKind::Rod { area, added_mass, .. } => {
            slender([positions[0], positions[1]], [density * area + added_mass; 2], moments);
        }
        ElementKind::Spring { .. } => {}
        ElementKind::Mass { mass, offset, inertia } => {
            moments.point(*mass, add(positions[0], *offset));
            for i in 0..3 {
                for j in 0..3 {
                    moments.own[i][j] += inertia[i][j];
                }
            }
        }
    }
}

/// Adds a line with a mass per length that varies linearly, by quadrature at three points
/// (Simpson): exact for the mass and the centre, and for the inertia of a uniform line.
fn slender(ends: [Vector; 2], mass: [f64; 2], moments: &mut Moments) {
    let length = norm(sub(ends[1], ends[0]));
    for (at, weight) in [(0.0, 1.0 / 6.0), (0.5, 4.0 / 6.0), (1.0, 1.0 / 6.0)] {
        let local = mass[0] + (mass[1] - mass[0]) * at;
        moments.point(weight * length * local, add(ends[0], scale(sub(ends[1], ends[0]), at)));
    }
}
