//! Bodies of revolution, such as webs, hubs and flanges, meshed in their section.
//!
//! A body of revolution responds to each Fourier harmonic of displacements around its axis
//! independently. With the harmonic `n` these are `u_r = U cos nt, u_t = V sin nt, u_z = W cos nt`,
//! where `U, V, W` are functions of radius and axial coordinate. This is a plane problem with three
//! displacements for each node and for each `n`; the circumference needs no discretization. From
//! the definition of strain in cylindrical coordinates, with `'` by r and `,z` by z,
//!
//! ```text
//!     e_rr = U' cos      e_tt = (U + n V)/r cos      e_zz = W,z cos      g_rz = (U,z + W') cos
//!     g_rt = (V' - (V + n U)/r) sin                  g_tz = (V,z - n W/r) sin
//! ```
//!
//! For `n = 0` the same equations hold with cosines in place of sines: the axisymmetric
//! displacements and torsion, which are then uncoupled. The family of the sines
//! (`sin nt, -cos nt, sin nt`) is the same, rotated by a quarter of a wavelength.
//!
//! See `docs/theory/finite-elements.md`.

use super::block::{Block, Side, uniform};
use super::builder::{MeshBuilder, MeshError};
use super::interpolation::ElementOrder;
use super::mesh::{EdgeChain, Element, PlaneMesh};
use super::model::gradients;
use super::sparse::summed;
use super::strips::{Cell, Cut, cells};
use crate::inertia::Inertia;
use crate::material::Material;
use calyx_numerics::quadrature::gauss_legendre;
use faer::sparse::SparseColMat;
use std::f64::consts::{PI, TAU};

/// Displacement components of a node: radial, tangential, axial.
const COMPONENTS: usize = 3;
/// Quadrature points across an element beyond its order: strains have the radius in the
/// denominator.
const MORE_POINTS: usize = 2;
/// Least number of elements across each strip of a section and along each stretch of it, and the
/// largest number along a stretch.
const ACROSS: usize = 2;
const ALONG: usize = 3;
const MOST_ALONG: usize = 24;

/// Axial extent of a section at a radius, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Station {
    /// Distance from the axis.
    pub radius: f64,
    /// Axial coordinates of the two ends of the section.
    pub ends: [f64; 2],
}

/// Section of a body of revolution, by stations outwards and straight lines between them. Two
/// stations at one radius are a step, for example between a web and a wider hub.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    stations: Vec<Station>,
}

fn between([from, to]: [f64; 2], share: f64) -> f64 {
    (1.0 - share) * from + share * to
}

impl Section {
    /// Builds a section. Returns `None` unless there are at least two stations with positive,
    /// nowhere descending radii and positive widths, steps overlap, and no more than two stations
    /// have the same radius.
    pub fn new(stations: Vec<Station>) -> Option<Self> {
        let finite = |station: &Station| station.ends.iter().all(|end| end.is_finite());
        let sound =
            |station: &Station| station.radius > 0.0 && station.ends[0] < station.ends[1] && finite(station);
        let joins = |pair: &[Station]| match pair {
            [a, b] if a.radius == b.radius => a.ends[0] < b.ends[1] && b.ends[0] < a.ends[1],
            [a, b] => a.radius < b.radius,
            _ => true,
        };
        let ends_step = |pair: Option<&[Station]>| pair.is_some_and(|pair| pair[0].radius == pair[1].radius);
        let steps = |stations: &[Station]| {
            ends_step(stations.get(..2))
                || ends_step(stations.len().checked_sub(2).and_then(|last| stations.get(last..)))
                || stations.windows(3).any(|three| three[0].radius == three[2].radius)
        };
        let good = stations.len() >= 2
            && stations.iter().all(sound)
            && stations.windows(2).all(joins)
            && !steps(&stations);
        good.then_some(Self { stations })
    }

    /// Returns the stations, outwards.
    pub fn stations(&self) -> &[Station] {
        &self.stations
    }

    /// Returns the innermost and the outermost station.
    pub fn outermost(&self) -> [Station; 2] {
        let last = self.stations.len() - 1;
        [self.stations[0], self.stations[last]]
    }

    /// Returns the inertia of the body for a density of 1 kg/m³, exactly.
    pub fn inertia(&self) -> Inertia {
        // The integrand has degree 4 at most.
        let rule = gauss_legendre(3);
        let mut inertia = Inertia::default();
        for pair in self.stations.windows(2) {
            let half = 0.5 * (pair[1].radius - pair[0].radius);
            for (x, weight) in &rule {
                let share = 0.5 * (1.0 + x);
                let radius = between([pair[0].radius, pair[1].radius], share);
                let [from, to] = [0, 1].map(|end| between([pair[0].ends[end], pair[1].ends[end]], share));
                let (around, width) = (TAU * radius * half * weight, to - from);
                // Thin tube.
                let (mass, square) = (around * width, radius * radius);
                let tube = Inertia::axial(mass, mass * square, mass * (0.5 * square + width * width / 12.0));
                inertia = inertia + tube.shifted_along(0.5 * (from + to));
            }
        }
        inertia
    }

    /// Meshes the section, radius as x and axial coordinate as y, with the chains `bore` and `rim`.
    /// `fineness` is a factor on the number of elements in each direction.
    ///
    /// # Errors
    /// The stations leave no room for elements.
    pub fn mesh(&self, order: ElementOrder, fineness: usize) -> Result<PlaneMesh, MeshError> {
        let mut builder = MeshBuilder::new();
        let [inside, outside] = self.outermost();
        let cuts: Vec<Cut> =
            self.stations.iter().map(|station| Cut { at: station.radius, ends: station.ends }).collect();
        for Cell { cut, lines: [inner, outer] } in cells(&cuts) {
            let pair = [self.stations[cut], self.stations[cut + 1]];
            let (length, width) =
                (pair[1].radius - pair[0].radius, |station: Station| station.ends[1] - station.ends[0]);
            let squares = 2.0 * length / (width(pair[0]) + width(pair[1]));
            let along = (squares.ceil() as usize).clamp(ALONG, MOST_ALONG) * fineness;
            let corners = [
                [pair[0].radius, inner[0]],
                [pair[1].radius, outer[0]],
                [pair[1].radius, outer[1]],
                [pair[0].radius, inner[1]],
            ];
            let mut block = Block::quadrilateral(corners).divided(uniform(along), uniform(ACROSS * fineness));
            if pair[0].radius == inside.radius {
                block = block.named(Side::Left, "bore");
            }
            if pair[1].radius == outside.radius {
                block = block.named(Side::Right, "rim");
            }
            builder.block(block);
        }
        builder.finish(order)
    }
}

/// Body of revolution by the mesh of its section.
#[derive(Clone, Debug, PartialEq)]
pub struct RevolutionModel {
    /// Mesh of the section: x is the radius, y the axial coordinate, m. There are three degrees of
    /// freedom for each node: radial, tangential, axial.
    pub mesh: PlaneMesh,
    /// Material of the body.
    pub material: Material,
}

impl RevolutionModel {
    /// Returns the number of displacements of the section.
    pub fn dof_count(&self) -> usize {
        COMPONENTS * self.mesh.nodes.len()
    }

    /// Returns the integral of the square of a harmonic over the circumference.
    pub fn around(harmonic: u16) -> f64 {
        if harmonic == 0 { TAU } else { PI }
    }

    /// Assembles the stiffness of one harmonic, N/m; symmetric bit for bit, both triangles stored.
    pub fn stiffness(&self, harmonic: u16) -> SparseColMat<usize, f64> {
        let mut entries = Vec::new();
        for element in &self.mesh.elements {
            let dofs: Vec<usize> =
                element.nodes.iter().flat_map(|&node| COMPONENTS * node..COMPONENTS * (node + 1)).collect();
            let matrix = self.element_stiffness(element, harmonic);
            for (&row, values) in dofs.iter().zip(matrix.chunks(dofs.len())) {
                entries.extend(dofs.iter().zip(values).map(|(&column, &value)| (column, row, value)));
            }
        }
        summed(self.dof_count(), entries)
    }

    /// Returns the stiffness of an element, row-major.
    fn element_stiffness(&self, element: &Element, harmonic: u16) -> Vec<f64> {
        let (young, ratio) = (self.material.youngs_modulus, self.material.poissons_ratio);
        let shear = 0.5 * young / (1.0 + ratio);
        let lame = young * ratio / ((1.0 + ratio) * (1.0 - 2.0 * ratio));
        let n = f64::from(harmonic);
        let size = COMPONENTS * element.nodes.len();
        let mut stiffness = vec![0.0; size * size];
        let points = gauss_legendre(
            usize::from(element.order.highest().max(element.coordinate_order.highest())) + MORE_POINTS,
        );
        for &(xi, along) in &points {
            for &(eta, across) in &points {
                let shapes = element.order.shapes(xi, eta);
                let coordinates = element.coordinate_order.shapes(xi, eta);
                let ([radius, _], jacobian) = self.mesh.map_with(element, &coordinates);
                let (gradients, area) = gradients(&shapes, jacobian);
                let weight = along * across * area * radius * Self::around(harmonic);
                // Strains rr, tt, zz, rz, rt, tz by node and displacement.
                let strains: Vec<[f64; 6]> = shapes
                    .iter()
                    .zip(&gradients)
                    .flat_map(|(shape, [by_r, by_z])| {
                        let over = shape[0] / radius;
                        [
                            [*by_r, over, 0.0, *by_z, -n * over, 0.0],
                            [0.0, n * over, 0.0, 0.0, by_r - over, *by_z],
                            [0.0, 0.0, *by_z, *by_r, 0.0, -n * over],
                        ]
                    })
                    .collect();
                for (row, a) in strains.iter().enumerate() {
                    let volume = lame * (a[0] + a[1] + a[2]);
                    let direct = [0, 1, 2].map(|k| volume + 2.0 * shear * a[k]);
                    for (column, b) in strains.iter().enumerate().skip(row) {
                        let work = direct[0] * b[0]
                            + direct[1] * b[1]
                            + direct[2] * b[2]
                            + shear * (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]);
                        stiffness[row * size + column] += weight * work;
                    }
                }
            }
        }
        for row in 0..size {
            for column in 0..row {
                stiffness[row * size + column] = stiffness[column * size + row];
            }
        }
        stiffness
    }

    /// Returns the load vector of a traction of one harmonic on the surface of a chain of edges.
    /// `traction` is its radial, tangential and axial amplitude at a radius and an axial
    /// coordinate.
    pub fn edge_load(
        &self,
        chain: &EdgeChain,
        harmonic: u16,
        traction: impl Fn([f64; 2]) -> [f64; 3],
    ) -> Vec<f64> {
        let mut load = vec![0.0; self.dof_count()];
        for edge in &chain.edges {
            let element = &self.mesh.elements[edge.element];
            let order = element.order.highest().max(element.coordinate_order.highest());
            for (t, weight) in gauss_legendre(usize::from(order) + MORE_POINTS) {
                let point = self.mesh.edge_point(edge, t);
                let area = weight * point.speed * point.position[0] * Self::around(harmonic);
                let traction = traction(point.position);
                for (&node, shape) in
                    element.nodes.iter().zip(element.order.shapes(point.place.xi, point.place.eta))
                {
                    for (component, part) in traction.iter().enumerate() {
                        load[COMPONENTS * node + component] += area * shape[0] * part;
                    }
                }
            }
        }
        load
    }

    /// Returns the rigid-body motions of one harmonic as displacements of all nodes: axial
    /// translation and rotation for harmonic zero, transverse translation and rotation about a
    /// transverse axis (through the origin) for harmonic one, none for higher ones.
    pub fn rigid_motions(&self, harmonic: u16) -> Vec<Vec<f64>> {
        let motion =
            |at: &dyn Fn([f64; 2]) -> [f64; 3]| self.mesh.nodes.iter().flat_map(|&place| at(place)).collect();
        match harmonic {
            0 => vec![motion(&|_| [0.0, 0.0, 1.0]), motion(&|[r, _]| [0.0, r, 0.0])],
            1 => vec![motion(&|_| [1.0, -1.0, 0.0]), motion(&|[r, z]| [z, -z, -r])],
            _ => Vec::new(),
        }
    }
}
