//! Finite-element model of a body of any shape: nodes, elements, constraints, loads and named sets.
//!
//! All quantities are in one consistent system of units; importers convert them to SI. Positions
//! and vectors are in the basic coordinate system of the model unless stated otherwise. Each node
//! has three translations and three rotations along and about its own displacement axes; components
//! to which no element gives stiffness take no part.

use std::collections::BTreeMap;

/// Component of motion of a node: index 0 to 2 for translations, 3 to 5 for rotations.
pub type Component = usize;

/// Set of components, by [`Component`].
pub type Components = [bool; 6];

/// Elastic body as finite elements.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ElasticModel {
    /// Nodes, in ascending order of their label.
    pub nodes: Vec<Node>,
    /// Materials, referred to by index.
    pub materials: Vec<Material>,
    /// Elements.
    pub elements: Vec<Element>,
    /// Constraints between nodes.
    pub constraints: Vec<Constraint>,
    /// Components of nodes that are fixed or have a prescribed value.
    pub fixed: Vec<FixedComponents>,
    /// Loads on nodes.
    pub loads: Vec<NodalLoad>,
    /// Named sets of nodes, as indices.
    pub sets: BTreeMap<String, Vec<usize>>,
}

/// Node of an [`ElasticModel`].
#[derive(Clone, Debug, PartialEq)]
pub struct Node {
    /// Label in the source file.
    pub label: u64,
    /// Position, m.
    pub position: [f64; 3],
    /// Unit vectors of the displacement axes: components of motion refer to them. Zero for a node
    /// whose components are amplitudes of a deformation, which rigid-body motion leaves at zero.
    pub axes: [[f64; 3]; 3],
}

/// Linear elastic material.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Young's modulus, Pa.
    pub youngs_modulus: f64,
    /// Poisson's ratio.
    pub poissons_ratio: f64,
    /// Shear modulus, Pa: E / 2 (1 + nu) of an isotropic material. It differs only for beams, rods
    /// and transverse shear of shells whose source states it separately.
    pub shear_modulus: f64,
    /// Density, kg/m^3.
    pub density: f64,
    /// Factor of structural damping; 0 if unknown.
    pub structural_damping: f64,
}

/// Element: its kind, nodes and material.
#[derive(Clone, Debug, PartialEq)]
pub struct Element {
    /// Label in the source file.
    pub label: u64,
    /// Kind, with its properties.
    pub kind: ElementKind,
    /// Indices of the nodes, in the order of the kind.
    pub nodes: Vec<usize>,
    /// Index of the material; `None` for springs and masses.
    pub material: Option<usize>,
}

/// Shape of a solid element. Nodes are ordered as in NASTRAN: corners of the first face, corners of
/// the second face in the same sense, then the midside nodes of the first face, of the edges
/// between the faces, and of the second face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SolidShape {
    /// Hexahedron of 8 nodes.
    Hexahedron8,
    /// Hexahedron of 8 nodes with incompatible modes, which make it exact in bending where it is a
    /// parallelepiped.
    IncompatibleHexahedron8,
    /// Hexahedron of 20 nodes.
    Hexahedron20,
    /// Wedge of 6 nodes.
    Wedge6,
    /// Wedge of 15 nodes.
    Wedge15,
    /// Tetrahedron of 4 nodes.
    Tetrahedron4,
    /// Tetrahedron of 10 nodes: corners, midsides 1-2, 2-3, 3-1, 1-4, 2-4, 3-4.
    Tetrahedron10,
}

/// Shape of a shell element: corners counter-clockwise seen against the normal, then midside nodes
/// from the side of the first two corners.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShellShape {
    /// Triangle of 3 nodes.
    Triangle3,
    /// Triangle of 6 nodes.
    Triangle6,
    /// Quadrilateral of 4 nodes.
    Quadrilateral4,
    /// Quadrilateral of 8 nodes.
    Quadrilateral8,
    /// Quadrilateral of 9 nodes: the eighth and a centre node.
    Quadrilateral9,
}

/// Kind of an element with its properties.
#[derive(Clone, Debug, PartialEq)]
pub enum ElementKind {
    /// Solid; its nodes have no rotational stiffness.
    Solid(SolidShape),
    /// Shell with transverse shear.
    Shell {
        /// Shape.
        shape: ShellShape,
        /// Thickness at the corner nodes, m.
        thickness: Vec<f64>,
        /// Offset of the mid-surface from the nodes along the normal, m.
        offset: f64,
        /// Mass per area in addition to that of the material, kg/m^2.
        added_mass: f64,
    },
    /// Straight beam between two nodes with shear deformation (Timoshenko).
    Beam(Box<BeamProperties>),
    /// Bar that carries axial force and torque only.
    Rod {
        /// Cross-sectional area, m^2.
        area: f64,
        /// Torsion constant J, m^4.
        torsion_constant: f64,
        /// Mass per length in addition to that of the material, kg/m.
        added_mass: f64,
    },
    /// Spring between a component of the first node and one of the second node or ground.
    Spring {
        /// Components at the first and the second node; the second node is ground if the element
        /// has only one.
        components: [Component; 2],
        /// Stiffness, N/m or N m/rad.
        stiffness: f64,
    },
    /// Mass at a node.
    Mass {
        /// Mass, kg.
        mass: f64,
        /// Centre of mass relative to the node, m.
        offset: [f64; 3],
        /// Inertia tensor about the centre of mass, kg m^2.
        inertia: [[f64; 3]; 3],
    },
}

/// Cross-section and orientation of a beam. The local x axis runs from the first end to the second.
#[derive(Clone, Debug, PartialEq)]
pub struct BeamProperties {
    /// Vector in the plane of the local x and y axes.
    pub orientation: [f64; 3],
    /// Properties of the section at both ends; equal for a uniform beam.
    pub sections: [BeamSection; 2],
    /// Offsets of the ends from the nodes, m.
    pub offsets: [[f64; 3]; 2],
    /// Components, along and about the local axes, without connection at each end.
    pub released: [Components; 2],
}

/// Cross-section of a beam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BeamSection {
    /// Area A, m^2.
    pub area: f64,
    /// Second moment of area about the local z axis (bending in the x-y plane), m^4.
    pub second_moment_z: f64,
    /// Second moment of area about the local y axis (bending in the x-z plane), m^4.
    pub second_moment_y: f64,
    /// Product of inertia I_yz, m^4.
    pub product_of_inertia: f64,
    /// Torsion constant J, m^4.
    pub torsion_constant: f64,
    /// Shear factors of the x-y and x-z planes: effective shear area over A; infinite for a beam
    /// without shear deformation.
    pub shear_factors: [f64; 2],
    /// Mass per length in addition to that of the material, kg/m.
    pub added_mass: f64,
}

/// Constraint between nodes.
#[derive(Clone, Debug, PartialEq)]
pub enum Constraint {
    /// The stated components of the dependent nodes follow the reference node as a rigid body
    /// (RBE2).
    Rigid {
        /// Label in the source file.
        label: u64,
        /// Index of the reference node.
        reference: usize,
        /// Dependent nodes and their components.
        dependents: Vec<(usize, Components)>,
    },
    /// The reference node follows the weighted average motion of other nodes, and a load on it is
    /// distributed over them (RBE3).
    WeightedAverage {
        /// Label in the source file.
        label: u64,
        /// Index of the reference node.
        reference: usize,
        /// Components of the reference node that follow.
        components: Components,
        /// Weight, node and components of each other node.
        terms: Vec<(f64, usize, Components)>,
    },
    /// Sum of coefficients times components is zero (MPC); the first term is the dependent one.
    Equation {
        /// Label in the source file.
        label: u64,
        /// Node, component and coefficient.
        terms: Vec<(usize, Component, f64)>,
    },
}

/// Prescribed components of a node.
#[derive(Clone, Debug, PartialEq)]
pub struct FixedComponents {
    /// Index of the node.
    pub node: usize,
    /// Components that are prescribed.
    pub components: Components,
    /// Their value, m or rad: zero for a fixed one.
    pub value: f64,
}

/// Load on a node, along and about the axes of the basic coordinate system.
#[derive(Clone, Debug, PartialEq)]
pub struct NodalLoad {
    /// Index of the node.
    pub node: usize,
    /// Forces, N, and moments, N m.
    pub load: [f64; 6],
}
