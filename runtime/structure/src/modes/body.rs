//! Modes of a body from those of its mesh: sorted, and evaluated for contact, frame and stress
//! recovery.

use super::super::bore::{BoreMeans, RequestedMeans};
use super::super::condense::{Assembled, match_cuts};
use super::super::elastic::{MeshSupport, Prepared, RingSource, SurfaceSource, chain, prepare};
use super::super::sampling::SplitOptions;
use super::super::{BoreSupport, StructureError};
use super::complex::under;
use super::cyclic::ring_modes;
use super::harmonic::{HarmonicModes, is_real};
use super::sector::Sector;
use super::{BodyModes, RingMode, SectorFields};
use calyx_fe::{PlaneModel, SparseVector};
use calyx_numerics::interrupt::Interrupt;
use faer::{Mat, c64};
use std::f64::consts::TAU;
use std::sync::Arc;

/// Number of rigid-body motions in the plane.
const MOTIONS: usize = 3;

impl BodyModes {
    /// Computes the modes of a ring of equal sectors up to a frequency (rad/s), supported as by
    /// [`ElasticStructure::ring`](super::super::ElasticStructure::ring). `model` is one sector
    /// about the origin; the surfaces are those of one sector.
    ///
    /// # Errors
    /// Chains are missing or too coarse, the cuts do not conform, spline teeth support the ring,
    /// some modes cannot be found, or the computation is interrupted.
    pub fn ring(
        model: &PlaneModel,
        ring: &RingSource<'_>,
        surfaces: &[SurfaceSource],
        options: &SplitOptions,
        highest: f64,
        interrupt: &Interrupt,
    ) -> Result<Self, StructureError> {
        let sector = ring_sector(model, ring, interrupt)?;
        let modes = ring_modes(&sector, highest, interrupt)?;
        Ok(Self::seen(&sector, modes, prepare(model, surfaces, options, interrupt)?))
    }

    /// Computes the modes of a body of a single mesh. For a free body these are the elastic modes
    /// only: its rigid-body motions belong to its frame.
    ///
    /// # Errors
    /// Chains are missing or too coarse, some modes cannot be found, or the computation is
    /// interrupted.
    pub fn single(
        model: &PlaneModel,
        support: MeshSupport<'_>,
        surfaces: &[SurfaceSource],
        options: &SplitOptions,
        highest: f64,
        interrupt: &Interrupt,
    ) -> Result<Self, StructureError> {
        let constrained = match support {
            MeshSupport::Free => Vec::new(),
            MeshSupport::Chain(name) => model.mesh.chain_nodes(chain(model, name)?),
        };
        let constrained = Assembled::plane(model).dofs_of(&constrained);
        let nodes = model.mesh.nodes.clone();
        let sector = Sector::new((model.stiffness(), model.mass()), nodes, &constrained, 1, None);
        let mut modes = ring_modes(&sector, highest, interrupt)?;
        if support == MeshSupport::Free {
            modes.iter_mut().for_each(|modes| modes.leave_out(MOTIONS));
        }
        Ok(Self::seen(&sector, modes, prepare(model, surfaces, options, interrupt)?))
    }

    fn seen(sector: &Sector, modes: Vec<HarmonicModes>, prepared: Vec<Prepared>) -> Self {
        let ring = RingFields::new(sector, modes);
        let directions = prepared.first().map_or(1, |first| first.loads.len());
        let mut displacements = Vec::new();
        let mut stresses = Vec::new();
        for surface in &prepared {
            for loads in &surface.loads {
                let seen = ring.rows(loads);
                displacements.push(seen.map(|part| surface.surface.spline.coefficients(part.as_ref())));
            }
            stresses.push(ring.rows(&surface.stress_rows));
        }
        let fields = SectorFields {
            teeth: sector.count,
            harmonics: ring.harmonics.clone(),
            modes: ring.modes.clone(),
            surfaces: prepared.into_iter().map(|prepared| prepared.surface).collect(),
            directions,
            displacements,
            stresses,
        };
        let [coupling, centrifugal] = [ring.coupling(&fields), ring.centrifugal()];
        let coupling =
            (0..ring.modes.len()).map(|mode| [0, 1, 2].map(|motion| coupling[(mode, motion)])).collect();
        Self {
            frequencies: ring.squares.iter().map(|square| square.max(0.0).sqrt()).collect(),
            coupling,
            rigid_mass: ring.rigid_mass(),
            gyroscopic: ring.gyroscopic(),
            centrifugal: centrifugal.col(0).iter().copied().collect(),
            fields: Arc::new(fields),
            modified_surfaces: None,
        }
    }
}

/// Returns the equations of a ring's sector, supported as the ring is.
pub(super) fn ring_sector(
    model: &PlaneModel,
    ring: &RingSource<'_>,
    interrupt: &Interrupt,
) -> Result<Sector, StructureError> {
    let nodes = |name: &str| Ok::<_, StructureError>(model.mesh.chain_nodes(chain(model, name)?));
    let (first, last, bore) = (nodes(ring.cuts[0])?, nodes(ring.cuts[1])?, nodes(ring.bore)?);
    let count = ring.sectors.max(1);
    let constrained = match ring.support {
        BoreSupport::Rigid => bore,
        BoreSupport::Means { .. } | BoreSupport::Raceway { .. } => Vec::new(),
        // Spline teeth couple modes of all nodal diameters.
        BoreSupport::SplineTeeth(_) | BoreSupport::SplineWithClearance { .. } => {
            return Err(StructureError::ModesOnLugs);
        }
    };
    let assembled = Assembled::plane(model);
    let cuts = match_cuts(&assembled.positions, &first, &last, &constrained, TAU / f64::from(count))
        .ok_or_else(|| StructureError::CutsDiffer { cuts: ring.cuts.map(String::from) })?;
    let constrained = assembled.dofs_of(&constrained);
    let matrices = (assembled.stiffness, model.mass());
    let sector = Sector::new(matrices, model.mesh.nodes.clone(), &constrained, count, Some(&cuts));
    let Some(wanted) = RequestedMeans::for_ring(ring.support) else { return Ok(sector) };
    let means = BoreMeans::plane(model, chain(model, ring.bore)?, wanted, interrupt)?;
    let means = means.ok_or(StructureError::NoArea)?;
    Ok(sector.with_mean_constraints(means.forms, means.shared))
}

/// Sorted modes of the ring, as fields on one sector with unit modal mass around the ring.
pub(super) struct RingFields<'s> {
    sector: &'s Sector,
    /// `omega²` of the modes, ascending.
    pub squares: Vec<f64>,
    pub modes: Vec<RingMode>,
    /// Number of nodal diameters of each field.
    pub harmonics: Vec<u32>,
    /// Real and imaginary parts, one column for each field.
    pub parts: [Mat<f64>; 2],
}

impl<'s> RingFields<'s> {
    pub fn new(sector: &'s Sector, found: Vec<HarmonicModes>) -> Self {
        let (mut order, mut columns, mut harmonics) = (Vec::new(), Vec::new(), Vec::new());
        for modes in found {
            let real = is_real(modes.nodal_diameters, sector.count);
            // A real field has the same modal mass on each sector, a complex one the same on half
            // of them.
            let share = if real { 1.0 } else { 2.0 };
            let scale = (share / f64::from(sector.count)).sqrt();
            for (column, &square) in modes.squares.iter().enumerate() {
                for sine in [false, true].into_iter().take(if real { 1 } else { 2 }) {
                    order.push((square, RingMode { field: columns.len(), sine }));
                }
                harmonics.push(modes.nodal_diameters);
                columns.push(
                    modes
                        .fields
                        .column(column)
                        .map(|part| part.into_iter().map(|value| scale * value).collect::<Vec<f64>>()),
                );
            }
        }
        // The sort is stable: among equal frequencies fewer nodal diameters come first, and in a
        // pair the cosine.
        order.sort_by(|a, b| a.0.total_cmp(&b.0));
        let parts =
            [0, 1].map(|part| Mat::from_fn(sector.dofs(), columns.len(), |row, k| columns[k][part][row]));
        let (squares, modes) = order.into_iter().unzip();
        Self { sector, squares, modes, harmonics, parts }
    }

    /// Returns rows of sector 0 applied to the fields.
    fn rows(&self, rows: &[SparseVector]) -> [Mat<f64>; 2] {
        self.parts.each_ref().map(|part| {
            let mut seen = Mat::zeros(rows.len(), part.ncols());
            for (row, form) in rows.iter().enumerate() {
                for column in 0..part.ncols() {
                    let field = part.col(column);
                    seen[(row, column)] = form.entries.iter().map(|&(dof, value)| value * field[dof]).sum();
                }
            }
            seen
        })
    }

    /// Returns the mass matrix times the unit motions of the frame and times the position vector,
    /// on sector 0.
    fn momenta(&self) -> Mat<f64> {
        let nodes = &self.sector.nodes;
        let motions = Mat::from_fn(self.sector.dofs(), MOTIONS + 1, |dof, motion| {
            let [x, y] = nodes[dof / 2];
            let vector = [[1.0, 0.0], [0.0, 1.0], [-y, x], [x, y]][motion];
            vector[dof % 2]
        });
        under(&self.sector.mass, motions.as_ref())
    }

    /// Returns the products of fields with unit motions on sector 0: motions by fields.
    fn with_motions(&self) -> [Mat<f64>; 2] {
        let momenta = self.momenta();
        self.parts.each_ref().map(|part| calyx_numerics::dense::product(momenta.transpose(), part.as_ref()))
    }

    /// Returns `phi' M r`: modes by motions.
    fn coupling(&self, fields: &SectorFields) -> Mat<f64> {
        let [re, im] = self.with_motions();
        let count = self.sector.count;
        let mut coupling = Mat::zeros(self.modes.len(), MOTIONS);
        for tooth in 0..count {
            let seen =
                fields.at_tooth(tooth, MOTIONS, |motion, field| [re[(motion, field)], im[(motion, field)]]);
            let (sin, cos) = (TAU * f64::from(tooth) / f64::from(count)).sin_cos();
            for (column, mode) in self.modes.iter().enumerate() {
                let nodal_diameters = self.harmonics[mode.field];
                // In the frames of the sectors, translations have one nodal diameter and the
                // rotation none; other terms are rounding.
                if nodal_diameters % count == 1 % count || (nodal_diameters + 1).is_multiple_of(count) {
                    coupling[(column, 0)] += cos * seen[(0, column)] - sin * seen[(1, column)];
                    coupling[(column, 1)] += sin * seen[(0, column)] + cos * seen[(1, column)];
                }
                if nodal_diameters == 0 {
                    coupling[(column, 2)] += seen[(2, column)];
                }
            }
        }
        coupling
    }

    /// Returns `phi' M x`, one column.
    fn centrifugal(&self) -> Mat<f64> {
        let [re, _] = self.with_motions();
        let count = f64::from(self.sector.count);
        Mat::from_fn(self.modes.len(), 1, |row, _| {
            let field = self.modes[row].field;
            if self.harmonics[field] == 0 { count * re[(MOTIONS, field)] } else { 0.0 }
        })
    }

    fn rigid_mass(&self) -> [[f64; 3]; 3] {
        let momenta = self.momenta();
        let (nodes, count) = (&self.sector.nodes, f64::from(self.sector.count));
        let sum = |value: &dyn Fn(usize, [f64; 2]) -> f64| {
            nodes.iter().enumerate().map(|(node, &place)| value(node, place)).sum::<f64>()
        };
        let mass = count * sum(&|node, _| momenta[(2 * node, 0)]);
        let polar = count * sum(&|node, [x, y]| x * momenta[(2 * node + 1, 2)] - y * momenta[(2 * node, 2)]);
        // Over more than one sector the moments cancel.
        let moment = |axis: usize| {
            let own = sum(&|node, [x, y]| momenta[(2 * node + axis, axis)] * [x, y][axis]);
            if self.sector.count > 1 { 0.0 } else { own }
        };
        let [x, y] = [moment(0), moment(1)];
        [[mass, 0.0, -y], [0.0, mass, x], [-y, x, polar]]
    }

    /// Returns `phi_k' M (e3 x phi_l)`.
    fn gyroscopic(&self) -> Mat<f64> {
        let turned = self.parts.each_ref().map(|part| {
            let turned = Mat::from_fn(part.nrows(), part.ncols(), |dof, column| {
                if dof % 2 == 0 { -part[(dof + 1, column)] } else { part[(dof - 1, column)] }
            });
            under(&self.sector.mass, turned.as_ref())
        });
        let [re, im] = &self.parts;
        let between = |k: usize, l: usize| {
            let dot = |a: &Mat<f64>, b: &Mat<f64>| {
                a.col(k).iter().zip(b.col(l).iter()).map(|(a, b)| a * b).sum::<f64>()
            };
            let [of_re, of_im] = &turned;
            c64::new(dot(re, of_re) + dot(im, of_im), dot(re, of_im) - dot(im, of_re))
        };
        let mut gyroscopic = Mat::zeros(self.modes.len(), self.modes.len());
        for (column, other) in self.modes.iter().enumerate() {
            for (row, one) in self.modes.iter().enumerate().take(column) {
                let nodal_diameters = self.harmonics[one.field];
                if nodal_diameters != self.harmonics[other.field] {
                    continue;
                }
                let real = is_real(nodal_diameters, self.sector.count);
                let share = f64::from(self.sector.count) * if real { 1.0 } else { 0.5 };
                let product = between(one.field, other.field);
                let value = share
                    * match (one.sine, other.sine) {
                        (false, false) | (true, true) => product.re,
                        (false, true) => product.im,
                        (true, false) => -product.im,
                    };
                (gyroscopic[(row, column)], gyroscopic[(column, row)]) = (value, -value);
            }
        }
        gyroscopic
    }
}
