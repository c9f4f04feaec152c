//! Shaft as a solid of revolution, condensed onto the mean motions of its sections.
//!
//! A shaft responds to axial forces and torques in the harmonic 0 around its axis, and to bending
//! in the harmonic 1 ([`RevolutionModel`]). The motion of a station is the mean displacement of its
//! section, weighted so that a force is spread uniformly over the section, a moment and a torque in
//! proportion to the distance from its axis: the definition with which Cowper derived the shear
//! coefficient of beams. Rigid-body motions have exactly these means, and the work of a force is
//! its product with the mean.
//!
//! With `m` columns of mean forms F and balanced unit loads B, the flexibility of the stations
//! relative to the first one is `C = B^T F^T K^-1 F B`, and the stiffness between all stations `B
//! C^-1 B^T`.
//!
//! See `docs/theory/shafts.md`.

use super::Shaft;
use crate::elastic_body::ElasticBodySize;
use crate::fidelity::StructureOptions;
use calyx_fe::{AxialCut, AxialSection, Constraints, ElementOrder, RevolutionModel, Solver, station_name};
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use faer::Mat;
use nalgebra::{Cholesky, DMatrix};
use std::f64::consts::PI;

/// Unknowns of a node: radial, tangential, axial.
const COMPONENTS: usize = 3;
/// Motions of a station in one harmonic: along and about the axis (0), or across it and about the
/// normal of the plane of bending (1).
const MOTIONS: usize = 2;
/// Number of harmonics around the axis.
const HARMONICS: usize = 2;
/// Difference of two radii relative to the wall below which they are equal for the mesh.
const LEAST_STEP: f64 = 1e-5;
/// Factor on the number of elements of solid shafts in each direction, cubic ones. The flexibility
/// that a step to twice the diameter adds is then accurate to 3 %, a thousandth of that of the
/// shaft.
const FINENESS: f64 = 2.0;
/// The same for quadratic elements. Error estimates compare with 1.5 times as many quadratic
/// elements. Stress is singular at steps, so more of these would have the error of the cubic ones.
const QUADRATIC_FINENESS: f64 = 4.0 / 3.0;

/// Mesh of a solid shaft.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SolidShaftMesh {
    /// Order of the displacement interpolation, 2 or 3.
    pub order: u8,
    /// Factor on the number of elements in each direction.
    pub fineness: usize,
}

impl SolidShaftMesh {
    /// Returns the mesh for the options of the structures of an analysis.
    pub fn of(options: &StructureOptions) -> SolidShaftMesh {
        // Linear elements lock in bending.
        let order = if options.order == 2 { 2 } else { 3 };
        let of_order = if order < 3 { QUADRATIC_FINENESS } else { FINENESS };
        let fineness = (of_order * options.refinement).round().max(1.0) as usize;
        SolidShaftMesh { order, fineness }
    }

    /// Cubic elements with a factor on their number in each direction.
    pub fn cubic(fineness: usize) -> SolidShaftMesh {
        SolidShaftMesh { order: 3, fineness }
    }
}

/// Reasons of errors.
const UNSTABLE: &str = "its flexibility is not positive";
const TOO_CLOSE: &str = "positions on the shaft are too close to each other";

impl Shaft {
    /// Returns the section of the shaft that carries load, with cuts at the stations (m,
    /// ascending); `None` if stations or ends of segments coincide to rounding.
    fn axial_section(&self, stations: &[f64]) -> Option<AxialSection> {
        // Noticeable steps only: the lines of the mesh have a tolerance.
        let snapped = |radius: f64, [bore, outside]: [f64; 2]| {
            let slack = LEAST_STEP * (outside - bore);
            [bore, outside].into_iter().find(|known| (radius - known).abs() <= slack).unwrap_or(radius)
        };
        let mut cuts: Vec<AxialCut> = Vec::new();
        for (segment, ends) in self.segments.iter().zip(self.ends.windows(2)) {
            let inner = stations.iter().copied().filter(|&z| ends[0] < z && z < ends[1]);
            for position in [ends[0]].into_iter().chain(inner).chain([ends[1]]) {
                let section = segment.section((position - ends[0]) / segment.length);
                let mut radii = section.carrying_radii();
                if let Some(before) = cuts.last().filter(|before| before.position == position) {
                    radii = radii.map(|radius| snapped(radius, before.radii));
                }
                let cut = AxialCut { position, radii };
                if cuts.last() != Some(&cut) {
                    cuts.push(cut);
                }
            }
        }
        AxialSection::new(cuts)
    }

    /// Returns the section with its cuts, and its mesh.
    fn revolved(
        &self,
        stations: &[f64],
        SolidShaftMesh { order, fineness }: SolidShaftMesh,
    ) -> Result<(AxialSection, RevolutionModel), EngineError> {
        let on_shaft: Option<Vec<f64>> = stations.iter().map(|&station| self.on_shaft(station)).collect();
        let stations = &on_shaft.ok_or_else(|| unsolved(TOO_CLOSE))?;
        let section = self.axial_section(stations).ok_or_else(|| unsolved(TOO_CLOSE))?;
        let mesh = section
            .mesh(ElementOrder::full(order), fineness, stations)
            .map_err(|error| unsolved(&error.to_string()))?;
        if (0..stations.len()).any(|station| mesh.chain(&station_name(station)).is_none()) {
            return Err(unsolved(TOO_CLOSE));
        }
        Ok((section, RevolutionModel { mesh, material: self.material }))
    }

    /// Checks whether the shaft with these stations (m, ascending) can be a solid.
    ///
    /// # Errors
    /// E0858: the section cannot be meshed.
    pub fn check_solid(&self, stations: &[f64]) -> Result<(), EngineError> {
        self.revolved(stations, SolidShaftMesh::cubic(1)).map(|_| ())
    }

    /// Returns the size of the solid shaft with these stations; `None` if it cannot be meshed.
    pub fn solid_size(&self, stations: &[f64], mesh: SolidShaftMesh) -> Option<ElasticBodySize> {
        let (_, model) = self.revolved(stations, mesh).ok()?;
        let inertia = self.inertia();
        Some(ElasticBodySize {
            elements: model.mesh.elements.len(),
            nodes: model.mesh.nodes.len(),
            dofs: HARMONICS * model.dof_count(),
            retained: 6 * stations.len(),
            revolved: true,
            mass: Some(inertia.mass),
            centre: inertia.moment.map(|moment| moment / inertia.mass),
        })
    }

    /// Returns the stiffness matrix of the solid shaft between stations at these ascending
    /// positions (m), six rows a station, row-major. Rigid-body motions of the shaft cause no
    /// forces.
    ///
    /// # Errors
    /// E0858: the section cannot be meshed. Those of the interrupt.
    pub fn solid_stiffness(
        &self,
        stations: &[f64],
        mesh: SolidShaftMesh,
        interrupt: &Interrupt,
    ) -> Result<Vec<f64>, EngineError> {
        let size = 6 * stations.len();
        let mut matrix = vec![0.0; size * size];
        if stations.len() < 2 {
            return Ok(matrix);
        }
        let (section, model) = self.revolved(stations, mesh)?;
        let radii_of = |&station: &f64| section.radii_at(self.on_shaft(station)?);
        let radii: Option<Vec<[f64; 2]>> = stations.iter().map(radii_of).collect();
        let radii = radii.ok_or_else(|| unsolved(TOO_CLOSE))?;
        // Components of a station by harmonic, and the sign of each motion there: bending about the
        // x axis moves the shaft along -y.
        let places: [(u16, [(usize, f64); MOTIONS]); 3] =
            [(0, [(2, 1.0), (5, 1.0)]), (1, [(0, 1.0), (4, 1.0)]), (1, [(1, 1.0), (3, -1.0)])];
        let between = [
            stiffness_of_harmonic(&model, 0, stations, &radii, interrupt)?,
            stiffness_of_harmonic(&model, 1, stations, &radii, interrupt)?,
        ];
        for (harmonic, components) in places {
            let block = &between[usize::from(harmonic)];
            for row in 0..block.nrows() {
                for column in 0..block.ncols() {
                    let of = |index: usize| {
                        let (component, sign) = components[index % MOTIONS];
                        (6 * (index / MOTIONS) + component, sign)
                    };
                    let ((at_row, sign), (at_column, other)) = (of(row), of(column));
                    matrix[at_row * size + at_column] = sign * other * block[(row, column)];
                }
            }
        }
        Ok(matrix)
    }
}

/// Returns the traction of a unit force or moment on a section with these radii: radial, tangential
/// and axial amplitude at a radius.
fn traction(harmonic: u16, motion: usize, [bore, outside]: [f64; 2]) -> impl Fn([f64; 2]) -> [f64; 3] {
    let area = PI * (outside * outside - bore * bore);
    let second_moment = 0.25 * PI * (outside.powi(4) - bore.powi(4));
    move |[r, _]| match (harmonic, motion) {
        (0, 0) => [0.0, 0.0, area.recip()],
        (0, _) => [0.0, r / (2.0 * second_moment), 0.0],
        (_, 0) => [area.recip(), -area.recip(), 0.0],
        (_, _) => [0.0, 0.0, -r / second_moment],
    }
}

/// Returns the stiffness between the motions of the stations in one harmonic.
fn stiffness_of_harmonic(
    model: &RevolutionModel,
    harmonic: u16,
    stations: &[f64],
    radii: &[[f64; 2]],
    interrupt: &Interrupt,
) -> Result<DMatrix<f64>, EngineError> {
    interrupt.check()?;
    let mut forms: Vec<Vec<f64>> = Vec::with_capacity(MOTIONS * stations.len());
    for (station, &radii) in radii.iter().enumerate() {
        let Some(chain) = model.mesh.chain(&station_name(station)) else { return Err(unsolved(TOO_CLOSE)) };
        forms.extend(
            (0..MOTIONS).map(|motion| model.edge_load(chain, harmonic, traction(harmonic, motion, radii))),
        );
    }
    // Balanced unit loads: at a station, and their reaction at the first one.
    let count = forms.len();
    let balanced = DMatrix::from_fn(count, count - MOTIONS, |row, column| {
        let (station, motion) = (column / MOTIONS + 1, column % MOTIONS);
        let arm = if harmonic == 1 { stations[station] - stations[0] } else { 0.0 };
        match (row / MOTIONS, row % MOTIONS) {
            (0, own) if own == motion => -1.0,
            // A force across the shaft has a moment about the first station.
            (0, 1) => -arm,
            (other, own) if other == station && own == motion => 1.0,
            _ => 0.0,
        }
    });
    let loads = Mat::from_fn(model.dof_count(), balanced.ncols(), |dof, column| {
        forms.iter().enumerate().map(|(k, form)| form[dof] * balanced[(k, column)]).sum()
    });
    // The loads are in equilibrium, so a statically determinate support carries nothing. It needs a
    // distance from the axis.
    let far = |a: &&[f64; 2], b: &&[f64; 2]| a[0].total_cmp(&b[0]);
    let farthest =
        model.mesh.nodes.iter().max_by(far).and_then(|far| model.mesh.nodes.iter().position(|n| n == far));
    let node = farthest.unwrap_or(0);
    let mut support = Constraints::new();
    support.prescribe(COMPONENTS * node + if harmonic == 0 { 1 } else { 0 }, 0.0);
    support.prescribe(COMPONENTS * node + 2, 0.0);
    let solver =
        Solver::new(&model.stiffness(harmonic), support).map_err(|error| unsolved(&error.to_string()))?;
    let moved = solver.solve(loads.as_ref()).map_err(|error| unsolved(&error.to_string()))?;
    let flexibility = loads.transpose() * &moved;
    let n = balanced.ncols();
    let flexibility =
        DMatrix::from_fn(n, n, |row, column| 0.5 * (flexibility[(row, column)] + flexibility[(column, row)]));
    let inverse = Cholesky::new(flexibility).ok_or_else(|| unsolved(UNSTABLE))?.inverse();
    let stiffness = &balanced * inverse * balanced.transpose();
    Ok(DMatrix::from_fn(count, count, |row, column| {
        0.5 * (stiffness[(row, column)] + stiffness[(column, row)])
    }))
}

fn unsolved(reason: &str) -> EngineError {
    EngineError::new(
        "E0858",
        format!("it cannot be modelled as a solid: {reason}"),
        "leave out segments, distances and steps that are much smaller than the others, or choose the fidelity \"analytic\"",
    )
    .blame("segments")
}
