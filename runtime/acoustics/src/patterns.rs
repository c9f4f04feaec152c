//! Sound of velocity patterns: powers, far fields and pressures of all their combinations from one
//! solution per pattern.

use crate::error::AcousticError;
use crate::field::FieldMesh;
use crate::model::Equations;
use crate::radiation::Radiation;
use crate::transfer::RadiationImpedance;
use calyx_numerics::interrupt::{Interrupt, MemoryReservation};
use calyx_numerics::vec3::Vector;
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, Par, c64};
use rayon::prelude::*;

/// Number of points whose rows are multiplied together.
const BLOCK: usize = 32;

/// Solutions of the equations for velocity patterns, such as those of the modes of a housing.
#[derive(Debug)]
pub struct SolvedPatterns<'e, 'm> {
    equations: &'e Equations<'m>,
    solutions: Vec<Radiation>,
    /// Pressures of the vertices and normal derivatives of the triangles, a column per pattern.
    sources: Mat<c64>,
    _memory: MemoryReservation,
}

impl<'e, 'm> SolvedPatterns<'e, 'm> {
    /// Solves the equations for patterns: normal velocities of the triangles, m/s.
    ///
    /// # Errors
    /// As [`Equations::solve`], or the caller refuses the memory.
    pub fn new(
        equations: &'e Equations<'m>,
        patterns: &[Vec<c64>],
        interrupt: &Interrupt,
    ) -> Result<Self, AcousticError> {
        let mesh = &equations.model().mesh;
        let (nodes, triangles) = (mesh.vertices().len(), mesh.triangles().len());
        // Pressures and velocities are in the solutions and in the sources.
        let bytes = 32 * patterns.len() * (nodes + triangles);
        let memory = interrupt.reserve_memory(bytes as u64)?;
        let solutions = equations.solve(patterns, interrupt)?;
        let inertia = equations.model().inertia(equations.frequency());
        let sources =
            Mat::from_fn(nodes + triangles, patterns.len(), |row, pattern| match row.checked_sub(nodes) {
                None => solutions[pattern].pressures()[row],
                Some(triangle) => inertia * patterns[pattern][triangle],
            });
        Ok(Self { equations, solutions, sources, _memory: memory })
    }

    /// Returns the radiation impedance: the power of any combination of the patterns on the
    /// surface.
    pub fn impedance(&self) -> RadiationImpedance {
        self.panel_impedance(&vec![1.0; self.equations.model().mesh.triangles().len()])
    }

    /// Returns the radiation impedance of a part of the surface, from the share of each triangle
    /// that belongs to it. Impedances of parts sum to that of the surface.
    pub fn panel_impedance(&self, shares: &[f64]) -> RadiationImpedance {
        let mesh = &self.equations.model().mesh;
        let members: Vec<usize> = (0..shares.len()).filter(|&triangle| shares[triangle] != 0.0).collect();
        let (rows, count) = (members.len(), self.solutions.len());
        let velocities = Mat::from_fn(rows, count, |row, i| {
            let triangle = members[row];
            self.solutions[i].velocities()[triangle] * (mesh.areas()[triangle] * shares[triangle])
        });
        let pressures =
            Mat::from_fn(rows, count, |row, j| self.solutions[j].mean_pressure(mesh, members[row]));
        let mut product = Mat::zeros(count, count);
        let one = c64::new(1.0, 0.0);
        matmul(product.as_mut(), Accum::Replace, velocities.adjoint(), pressures.as_ref(), one, Par::Seq);
        RadiationImpedance::new(self.equations.frequency(), product)
    }

    /// Returns the radiation impedance of the far field, with Gauss points as in
    /// [`Equations::far_field_power`]. It is a sum of squares, so that no power is negative, and
    /// insensitive to errors of phase.
    ///
    /// # Errors
    /// There are fewer than two rings, or the caller interrupts or refuses the memory.
    pub fn far_impedance(
        &self,
        rings: usize,
        interrupt: &Interrupt,
    ) -> Result<RadiationImpedance, AcousticError> {
        let directions: FieldMesh = self.equations.directions(rings)?;
        let mut far = self.far_field(&directions.points, interrupt)?;
        let impedance = self.equations.model().fluid.impedance();
        for (row, area) in directions.areas.iter().enumerate() {
            let weight = (area / impedance).sqrt();
            (0..far.ncols()).for_each(|pattern| far[(row, pattern)] *= weight);
        }
        let mut product = Mat::zeros(far.ncols(), far.ncols());
        let one = c64::new(1.0, 0.0);
        matmul(product.as_mut(), Accum::Replace, far.adjoint(), far.as_ref(), one, Par::Seq);
        Ok(RadiationImpedance::new(self.equations.frequency(), product))
    }

    /// Returns the amplitudes of the far field in directions (unit vectors), Pa·m: the limit of the
    /// pressure at the distance r from the origin, times r exp(ikr). A row per direction, a column
    /// per pattern.
    ///
    /// # Errors
    /// The caller interrupts or refuses the memory.
    pub fn far_field(&self, directions: &[Vector], interrupt: &Interrupt) -> Result<Mat<c64>, AcousticError> {
        self.rows(directions, &|direction| self.equations.far_row(direction), interrupt)
    }

    /// Returns the pressures at points in the fluid, Pa: a row per point, a column per pattern.
    ///
    /// # Errors
    /// A point is inside of the body, behind the rigid plane, or on the surface; or the caller
    /// interrupts or refuses the memory.
    pub fn pressures(&self, points: &[Vector], interrupt: &Interrupt) -> Result<Mat<c64>, AcousticError> {
        self.equations.check_points(points)?;
        self.rows(points, &|point| self.equations.point_row(point), interrupt)
    }

    /// Returns the products of rows with the sources of all patterns.
    fn rows(
        &self,
        at: &[Vector],
        row: &(dyn Fn(Vector) -> (Vec<c64>, Vec<c64>) + Sync),
        interrupt: &Interrupt,
    ) -> Result<Mat<c64>, AcousticError> {
        let (count, sources) = (self.solutions.len(), self.sources.nrows());
        let blocks = rayon::current_num_threads();
        let _room =
            interrupt.reserve_memory((32 * at.len() * count + 16 * blocks * BLOCK * sources) as u64)?;
        let product = |points: &[Vector]| -> Result<Mat<c64>, AcousticError> {
            let mut rows = Mat::zeros(sources, points.len());
            for (&point, column) in points.iter().zip(rows.col_iter_mut()) {
                interrupt.check()?;
                let (pressure, derivative) = row(point);
                let parts = pressure.into_iter().chain(derivative);
                column.iter_mut().zip(parts).for_each(|(entry, part)| *entry = part);
            }
            let mut block = Mat::zeros(points.len(), count);
            let (one, rows) = (c64::new(1.0, 0.0), rows.transpose());
            matmul(block.as_mut(), Accum::Replace, rows, self.sources.as_ref(), one, Par::Seq);
            Ok(block)
        };
        let blocks: Vec<Mat<c64>> = at.par_chunks(BLOCK).map(product).collect::<Result<_, _>>()?;
        Ok(Mat::from_fn(at.len(), count, |row, pattern| blocks[row / BLOCK][(row % BLOCK, pattern)]))
    }
}
