//! Radiating body and its equations at one frequency.

use crate::compressed::CompressedEquations;
use crate::dense::DenseEquations;
use crate::error::AcousticError;
use crate::field::FieldMesh;
use crate::fluid::Fluid;
use crate::mesh::SurfaceMesh;
use crate::operators::Operators;
use crate::pair::PairQuadrature;
use crate::plane::RigidPlane;
use crate::point::{PointQuadrature, distance};
use crate::radiation::Radiation;
use crate::transfer::TransferVectors;
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::vec3::{Vector, length, minus};
use faer::{Mat, c64};
use rayon::prelude::*;

/// Largest number of vertices for which [`Method::Automatic`] selects dense matrices: they take
/// about 0.8 GB.
const DENSE: usize = 4000;
/// Least distance of a field point from the surface, relative to the size of the mesh.
const LEAST_DISTANCE: f64 = 1e-5;

/// Body with a surface in a fluid.
#[derive(Clone, Debug)]
pub struct RadiationModel {
    /// Surface.
    pub mesh: SurfaceMesh,
    /// Fluid.
    pub fluid: Fluid,
}

/// Solution method.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Method {
    /// Dense matrices for meshes of up to 4,000 vertices, hierarchical matrices above.
    #[default]
    Automatic,
    /// Dense matrices and LU factors.
    Dense,
    /// Hierarchical matrices and GMRES.
    Hierarchical,
}

/// Settings of the solution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Solution method.
    pub method: Method,
    /// Relative accuracy of the hierarchical matrices; GMRES stops at a tenth of it.
    pub accuracy: f64,
    /// Uses finer quadrature rules, to estimate the error of the standard ones.
    pub fine_quadrature: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self { method: Method::Automatic, accuracy: 1e-4, fine_quadrature: false }
    }
}

/// Equations of Burton and Miller at one frequency, ready for right-hand sides.
#[derive(Debug)]
pub struct Equations<'m> {
    model: &'m RadiationModel,
    frequency: f64,
    operators: Operators,
    system: System,
    points: PointQuadrature,
}

#[derive(Debug)]
enum System {
    Dense(DenseEquations),
    Compressed(Box<CompressedEquations>),
}

impl RadiationModel {
    /// Assembles the equations at a frequency in Hz, and factorizes or preconditions them.
    ///
    /// # Errors
    /// The frequency, the fluid or a setting is out of range, or the caller interrupts or refuses
    /// the memory.
    pub fn equations(
        &self,
        frequency: f64,
        settings: &Settings,
        interrupt: &Interrupt,
    ) -> Result<Equations<'_>, AcousticError> {
        let wavenumber = self.fluid.wavenumber(frequency)?;
        if !(1e-12..=0.1).contains(&settings.accuracy) {
            return Err(AcousticError::input(
                format!("the accuracy of the hierarchical matrices is {}", settings.accuracy),
                "state an accuracy between 1e-12 and 0.1",
            ));
        }
        let quadrature =
            if settings.fine_quadrature { PairQuadrature::fine() } else { PairQuadrature::standard() };
        let operators = Operators::new(&self.mesh, wavenumber, quadrature);
        let dense = match settings.method {
            Method::Automatic => operators.nodes <= DENSE,
            Method::Dense => true,
            Method::Hierarchical => false,
        };
        let system = if dense {
            System::Dense(DenseEquations::new(&operators, interrupt)?)
        } else {
            let accuracy = settings.accuracy;
            System::Compressed(Box::new(CompressedEquations::new(&operators, accuracy, interrupt)?))
        };
        Ok(Equations { model: self, frequency, operators, system, points: PointQuadrature::new() })
    }

    /// Returns the normal derivative of the pressure for a normal velocity, divided by the
    /// velocity: -iωρ.
    pub(crate) fn inertia(&self, frequency: f64) -> c64 {
        c64::new(0.0, -std::f64::consts::TAU * frequency * self.fluid.density)
    }
}

impl<'m> Equations<'m> {
    /// Returns the model.
    pub fn model(&self) -> &'m RadiationModel {
        self.model
    }

    /// Returns the frequency, Hz.
    pub fn frequency(&self) -> f64 {
        self.frequency
    }

    /// Returns the memory of the matrices that are stored, bytes.
    pub fn memory(&self) -> u64 {
        match &self.system {
            System::Dense(_) => crate::dense::memory(self.operators.nodes, self.operators.panels.len()),
            System::Compressed(equations) => equations.memory(),
        }
    }

    /// Solves for the surface pressure of normal velocities, m/s, one per triangle in each case.
    /// Amplitudes are complex, with the time factor exp(iωt).
    ///
    /// # Errors
    /// A case has another number of velocities or one that is not finite, the iteration does not
    /// converge, or the caller interrupts.
    pub fn solve(
        &self,
        velocities: &[Vec<c64>],
        interrupt: &Interrupt,
    ) -> Result<Vec<Radiation>, AcousticError> {
        let triangles = self.operators.panels.len();
        for (case, velocity) in velocities.iter().enumerate() {
            check_velocities(velocity, triangles, case)?;
        }
        let inertia = self.model.inertia(self.frequency);
        let derivatives = Mat::from_fn(triangles, velocities.len(), |i, j| velocities[j][i] * inertia);
        let pressure = match &self.system {
            System::Dense(equations) => {
                interrupt.check()?;
                equations.solve(derivatives.as_ref())
            }
            System::Compressed(equations) => equations.solve(derivatives.as_ref(), interrupt)?,
        };
        velocities
            .iter()
            .enumerate()
            .map(|(case, velocity)| {
                let pressure: Vec<c64> = (0..pressure.nrows()).map(|i| pressure[(i, case)]).collect();
                if pressure.iter().any(|value| !(value.re.is_finite() && value.im.is_finite())) {
                    return Err(AcousticError::convergence(
                        format!("the equations at {} Hz are singular", self.frequency),
                        "refine the mesh where its elements are distorted",
                    ));
                }
                Ok(Radiation::new(self.frequency, self.model.fluid, pressure, velocity.clone()))
            })
            .collect()
    }

    /// Returns the pressures at points in the fluid for a solution, Pa.
    ///
    /// # Errors
    /// A point is inside of the body, behind the rigid plane, or on the surface.
    pub fn pressures(
        &self,
        radiation: &Radiation,
        points: &[Vector],
        interrupt: &Interrupt,
    ) -> Result<Vec<c64>, AcousticError> {
        self.check_points(points)?;
        let inertia = self.model.inertia(self.frequency);
        let at = |point: &Vector| {
            interrupt.check()?;
            let (pressure, derivative) = self.points.row(&self.operators, *point);
            let surface: c64 = pressure.iter().zip(radiation.pressures()).map(|(a, b)| a * b).sum();
            let source: c64 = derivative.iter().zip(radiation.velocities()).map(|(a, b)| a * b).sum();
            Ok(surface + inertia * source)
        };
        points.par_iter().map(at).collect()
    }

    /// Returns the power in the far field, W, from Gauss points of `rings` polar angles and
    /// `2 * rings` azimuths; twice the number of wavelengths across the body and ten more suffice.
    ///
    /// It agrees with [`Radiation::power`] up to the error of discretization, and is more accurate
    /// for weak radiators: their power on the surface is a small difference, because the pressure
    /// is almost in quadrature with the velocity.
    ///
    /// # Errors
    /// There are fewer than two rings, or the caller interrupts.
    pub fn far_field_power(
        &self,
        radiation: &Radiation,
        rings: usize,
        interrupt: &Interrupt,
    ) -> Result<f64, AcousticError> {
        let directions = self.directions(rings)?;
        let inertia = self.model.inertia(self.frequency);
        let at = |direction: &Vector| {
            interrupt.check()?;
            let (pressure, derivative) = self.points.far_row(&self.operators, *direction);
            let surface: c64 = pressure.iter().zip(radiation.pressures()).map(|(a, b)| a * b).sum();
            let source: c64 = derivative.iter().zip(radiation.velocities()).map(|(a, b)| a * b).sum();
            Ok(surface + inertia * source)
        };
        let amplitudes: Result<Vec<c64>, AcousticError> = directions.points.par_iter().map(at).collect();
        Ok(directions.far_field_power(&amplitudes?, self.model.fluid.impedance()))
    }

    /// Computes the acoustic transfer vectors of points in the fluid: the pressure there per normal
    /// velocity of each triangle. By reciprocity, each point takes one solution with the transposed
    /// equations.
    ///
    /// # Errors
    /// A point is not in the fluid, the iteration does not converge, or the caller interrupts.
    pub fn transfer_vectors(
        &self,
        points: &[Vector],
        interrupt: &Interrupt,
    ) -> Result<TransferVectors, AcousticError> {
        self.check_points(points)?;
        let rows: Vec<(Vec<c64>, Vec<c64>)> =
            points.par_iter().map(|point| self.points.row(&self.operators, *point)).collect();
        interrupt.check()?;
        let weights = Mat::from_fn(self.operators.nodes, points.len(), |i, j| rows[j].0[i]);
        let mut transfer = match &self.system {
            System::Dense(equations) => equations.solve_transpose(weights),
            System::Compressed(equations) => equations.solve_transpose(weights.as_ref(), interrupt)?,
        };
        let inertia = self.model.inertia(self.frequency);
        for (j, (_, derivative)) in rows.iter().enumerate() {
            for i in 0..transfer.nrows() {
                transfer[(i, j)] = (transfer[(i, j)] + derivative[i]) * inertia;
            }
        }
        Ok(TransferVectors::new(self.frequency, points.to_vec(), transfer))
    }

    /// Returns the Gauss points of all directions into the fluid.
    pub(crate) fn directions(&self, rings: usize) -> Result<FieldMesh, AcousticError> {
        let center = [0.0; 3];
        match self.model.mesh.plane() {
            Some(plane) => FieldMesh::hemisphere(center, plane.normal(), 1.0, rings),
            None => FieldMesh::sphere(center, 1.0, rings),
        }
    }

    /// Returns the row of the far field in a direction, for the pressures of the vertices and the
    /// normal derivatives of the triangles.
    pub(crate) fn far_row(&self, direction: Vector) -> (Vec<c64>, Vec<c64>) {
        self.points.far_row(&self.operators, direction)
    }

    /// Returns the row of the representation formula for a point in the fluid.
    pub(crate) fn point_row(&self, point: Vector) -> (Vec<c64>, Vec<c64>) {
        self.points.row(&self.operators, point)
    }

    /// Checks that points are in the fluid.
    pub(crate) fn check_points(&self, points: &[Vector]) -> Result<(), AcousticError> {
        let mesh = &self.model.mesh;
        let least = LEAST_DISTANCE * mesh.size();
        let check = |(index, point): (usize, &Vector)| {
            let rejected = |message: &str, help: &str| {
                Err(AcousticError::input(format!("field point {index} at {point:?} {message}"), help))
            };
            if !point.iter().all(|x| x.is_finite()) {
                return rejected("is not finite", "correct its coordinates");
            }
            if mesh.plane().is_some_and(|plane: &RigidPlane| plane.distance(*point) < 0.0) {
                return rejected("is behind the rigid plane", "move it to the side of the fluid");
            }
            for (triangle, panel) in self.operators.panels.iter().enumerate() {
                let near = length(minus(*point, panel.centroid)) <= panel.radius + least;
                if near && distance(*point, panel.corners) < least {
                    let message = format!("is on element {}", mesh.faces()[triangle]);
                    return rejected(&message, "use the pressure of the surface, or move it into the fluid");
                }
            }
            if mesh.enclosure(*point) > 0.5 {
                return rejected("is inside of the body", "move it into the fluid");
            }
            Ok(())
        };
        points.par_iter().enumerate().map(check).collect::<Result<Vec<()>, _>>().map(drop)
    }
}

/// Checks the number of the velocities of a case, and that they are finite.
pub(crate) fn check_velocities(
    velocities: &[c64],
    triangles: usize,
    case: usize,
) -> Result<(), AcousticError> {
    if velocities.len() != triangles {
        return Err(AcousticError::input(
            format!("case {case} has {} velocities for {triangles} triangles", velocities.len()),
            "pass one normal velocity for each triangle",
        ));
    }
    match velocities.iter().position(|value| !(value.re.is_finite() && value.im.is_finite())) {
        Some(triangle) => Err(AcousticError::input(
            format!("the velocity of triangle {triangle} in case {case} is not finite"),
            "pass finite velocities",
        )),
        None => Ok(()),
    }
}
