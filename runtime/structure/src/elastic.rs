//! Finite-element model of an elastic body, condensed onto its surfaces: a ring of equal sectors,
//! or a single mesh.
//!
//! The compliance between two points of a surface is that of the half-plane plus a smooth part. The
//! smooth part is the difference between the responses of the mesh and of the half-plane to the
//! same mollified loads, observed through the same mollifiers ([`super::kernel`]). It is symmetric
//! by construction.
//!
//! On a curved surface the compliance has weaker singularities than the logarithm of the half-plane
//! where both points coincide. The exact solution for a disc shows them: the Fourier coefficients
//! of its normal displacement are `[k/(n + 1) + 1/(n - 1)]/(4 mu)`, with k Kolosov's constant.
//! Their expansion `[(k + 1)/n + (1 - k)/n² + (k + 1)/n³ ...]/(4 mu)` sums to the logarithm, a kink
//! `(k - 1)/(8 mu) |phi|` in the angle between the normals, and `phi² ln|phi|/(pi E')`. (The kink
//! is the tangential displacement of the half-plane, of constant size away from the load, projected
//! on a rotated normal.) The last two terms are subtracted before interpolation and added again in
//! closed form; the logarithm is left to the code that integrates pressures.
//!
//! Tables are interpolated by splines in both variables. The table of a surface with itself uses a
//! coordinate stretched towards sharp edges ([`super::sampling`]). Only one orientation of each
//! table is stored and it is always summed in the same order, so that exchanging load and observer
//! gives the same bits.
//!
//! See `docs/theory/compliance.md`.

mod influence;
mod local;
mod modified_surface;

pub(crate) use local::{Local, NormalAngle};

use super::bore::{BoreMeans, RequestedMeans};
use super::bore_coupling::BoreCoupling;
use super::bspline::BSpline;
use super::condense::{Assembled, Condensed, Support, condense, match_cuts};
use super::dense::Interruptible;
use super::far_coupling::{FarCoupling, FarResponse};
use super::kernel::{Mollifier, MollifierSamples, PairQuadrature};
use super::ring::{ReleasedMeans, RingFlexibility};
use super::sampling::{EdgeCoordinate, SplitOptions, sample};
use super::{BoreSupport, StructureError};
use crate::profile::Profile;
use calyx_fe::material::{Material, Plane};
use calyx_fe::stress::StressRecovery;
use calyx_fe::{EdgeChain, PlaneModel, SparseVector};
use calyx_numerics::interrupt::Interrupt;
use faer::{Mat, MatRef};
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// Loadable surface of a mesh. Chains are named as in [`calyx_fe::PlaneMesh::chains`].
#[derive(Clone)]
pub struct SurfaceSource {
    /// True curve, in the coordinates of the mesh; the arc length of the chain is that of this
    /// curve.
    pub profile: Arc<dyn Profile>,
    /// Name of the chain of edges along the profile, without a rounded edge of the body.
    pub chain: String,
    /// Rounding (m) of the sharp edges of the body at the start and the end of the chain; `None`
    /// where the body continues smoothly.
    pub edges: [Option<f64>; 2],
    /// Name of a chain of edges of an adjacent free surface along which stress is recovered: the
    /// fillet.
    pub stress_chain: Option<String>,
    /// Number of stress recovery points on each edge of that chain, at least 1.
    pub stress_points_per_edge: usize,
}

/// Support of a single mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshSupport<'a> {
    /// Free body. Its rigid-body motion belongs to the frame. Forces distributed like inertia
    /// balance loads that are not in equilibrium.
    Free,
    /// Fixed nodes of this chain.
    Chain(&'a str),
}

/// Ring of sectors: number, cuts and support.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RingSource<'a> {
    /// Number of equal sectors of the whole ring about the origin, at least 1.
    pub sectors: u32,
    /// Cut to the previous sector (clockwise) and cut to the next one.
    pub cuts: [&'a str; 2],
    /// Chain on which the body's frame supports each sector.
    pub bore: &'a str,
    /// Type of the support on the bore.
    pub support: BoreSupport,
    /// Largest distance of coupled sectors; sectors further apart count as independent.
    pub coupled: u32,
}

/// Elastic body from finite elements. See the module documentation.
pub struct ElasticStructure {
    pub(super) teeth: u32,
    pub(super) surface_modulus: f64,
    pub(super) reference_length: f64,
    /// Displacement per angle between normals, m/(N/m).
    pub(super) kink: f64,
    pub(super) surfaces: Vec<Surface>,
    /// Number of directions in which points of a surface are loaded and observed: 1, into the body,
    /// or 2, also along the surface.
    pub(super) directions: usize,
    /// Tables by offset of the observing sector ahead of the loaded one.
    pub(super) offsets: Vec<OffsetTables>,
    /// Mixed derivative of the table of a surface with itself at the first and the last sample, by
    /// surface and pair of directions.
    pub(super) twists: Vec<[f64; 2]>,
    /// Coupling of sectors beyond those offsets.
    pub(super) far: Option<FarCoupling>,
    /// Coupling through what supports the bore: spline teeth or contact outside of the structure.
    pub(super) bore: Option<BoreCoupling>,
}

pub(super) struct Surface {
    pub profile: Arc<dyn Profile>,
    /// Spline over arc length, for everything but the compliance of the surface with itself.
    pub spline: BSpline,
    pub stretch: EdgeCoordinate,
    /// Spline over the stretched coordinate, for the compliance of the surface with itself.
    pub stretched: BSpline,
    /// Range of arc lengths of the chain. Coordinates beyond it are clamped to its ends.
    pub range: [f64; 2],
    /// Spline coefficients of the angle by which the normal has rotated, positive where convex,
    /// rad.
    pub turned: Vec<f64>,
    /// Stress recovery points: arc length on their chain, and position, m.
    pub stress_points: Vec<(f64, [f64; 2])>,
}

/// Spline coefficients between a loaded sector and one at a given offset ahead of it. In a plane
/// model a side is a surface in one of its directions: `surface * directions + direction`.
pub(super) struct OffsetTables {
    /// Compliances `[observed side][loaded side]`, rows by observer.
    pub compliance: Vec<Vec<Mat<f64>>>,
    /// Stress on the sector ahead by loads on this one: `[observed surface][loaded side]`, rows by
    /// stress recovery point, Pa/(N/m).
    pub stress_ahead: Vec<Vec<Mat<f64>>>,
    /// Stress on this sector by loads on the one ahead; empty if both are the same sector.
    pub stress_behind: Vec<Vec<Mat<f64>>>,
}

/// Surface with its loads and stress rows, before solution.
pub(super) struct Prepared {
    pub surface: Surface,
    mollifiers: Vec<Mollifier>,
    /// Loads by direction, one for each mollifier.
    pub loads: Vec<Vec<SparseVector>>,
    pub stress_rows: Vec<SparseVector>,
}

impl ElasticStructure {
    /// Builds a ring of equal sectors. `model` is one sector about the origin; the surfaces are
    /// those of one sector.
    ///
    /// # Errors
    /// Chains are missing or too coarse, the cuts do not conform, the ring is not supported, or the
    /// computation is interrupted.
    pub fn ring(
        model: &PlaneModel,
        ring: &RingSource<'_>,
        surfaces: &[SurfaceSource],
        options: &SplitOptions,
        interrupt: &Interrupt,
    ) -> Result<Self, StructureError> {
        let nodes = |name: &str| Ok::<_, StructureError>(model.mesh.chain_nodes(chain(model, name)?));
        let (first, last, bore) = (nodes(ring.cuts[0])?, nodes(ring.cuts[1])?, nodes(ring.bore)?);
        let sectors = ring.sectors.max(1);
        let (constrained, means) = match RequestedMeans::for_ring(ring.support) {
            None => (bore, None),
            Some(wanted) => {
                let means = BoreMeans::plane(model, chain(model, ring.bore)?, wanted, interrupt)?;
                (Vec::new(), Some(means.ok_or(StructureError::NoArea)?))
            }
        };
        let angle = TAU / f64::from(sectors);
        let room = interrupt.reserve_memory(model.assembly_memory()).map_err(StructureError::Interrupted)?;
        let assembled = Assembled::plane(model);
        drop(room);
        let cuts = match_cuts(&assembled.positions, &first, &last, &constrained, angle)
            .ok_or_else(|| StructureError::CutsDiffer { cuts: ring.cuts.map(String::from) })?;
        let prepared = prepare(model, surfaces, options, interrupt)?;
        let (loads, rows) = gathered(&prepared);
        let constrained = assembled.dofs_of(&constrained);
        let support = Support::for_ring(&constrained, means.as_ref());
        let condensed = condense(&assembled, &support, Some(&cuts), &loads, &rows, interrupt)?;
        let mut flexibility = match &condensed.stiffness {
            Some(stiffness) => {
                let flexibility = RingFlexibility::new(stiffness, sectors, ring.coupled, interrupt);
                Some(flexibility.map_err(|error| ring.support.with_bore_context(error))?)
            }
            None => None,
        };
        let released = match (&mut flexibility, &means) {
            (Some(flexibility), Some(means)) => means.release(flexibility, interrupt)?,
            _ => None,
        };
        let coupling = |released| bore_coupling(released, &condensed, &prepared, (sectors, angle), interrupt);
        let bore = released.map(coupling).transpose()?;
        let far = match &flexibility {
            Some(flexibility) => FarResponse::new(&condensed, flexibility, interrupt)?,
            None => None,
        };
        let far = far.map(|far| far.coupling(sectors, |loads, rows| by_surface(loads, rows, &prepared)));
        let body = Self::assemble(model, sectors, prepared, &condensed, flexibility.as_ref(), interrupt)?;
        Ok(Self { far, bore, ..body })
    }

    /// Builds a body from a single mesh.
    ///
    /// # Errors
    /// Chains are missing or too coarse, the mesh has a mechanism, or the computation is
    /// interrupted.
    pub fn single(
        model: &PlaneModel,
        support: MeshSupport<'_>,
        surfaces: &[SurfaceSource],
        options: &SplitOptions,
        interrupt: &Interrupt,
    ) -> Result<Self, StructureError> {
        let prepared = prepare(model, surfaces, options, interrupt)?;
        let (loads, rows) = gathered(&prepared);
        let room = interrupt.reserve_memory(model.assembly_memory()).map_err(StructureError::Interrupted)?;
        let assembled = Assembled::plane(model);
        drop(room);
        let condense = |support| condense(&assembled, &support, None, &loads, &rows, interrupt);
        let condensed = match support {
            MeshSupport::Free => {
                // Any positive density distributes the forces alike.
                let unit = Material { density: 1.0, ..model.material };
                let mass = PlaneModel { material: unit, ..model.clone() }.mass();
                condense(Support::Free { mass: &mass, motions: &model.rigid_body_modes() })?
            }
            MeshSupport::Chain(name) => {
                let nodes = model.mesh.chain_nodes(chain(model, name)?);
                condense(Support::Constrained(&assembled.dofs_of(&nodes)))?
            }
        };
        Self::assemble(model, 1, prepared, &condensed, None, interrupt)
    }

    fn assemble(
        model: &PlaneModel,
        teeth: u32,
        prepared: Vec<Prepared>,
        condensed: &Condensed,
        ring: Option<&RingFlexibility>,
        interrupt: &Interrupt,
    ) -> Result<Self, StructureError> {
        let surface_modulus = model.material.surface_modulus(model.plane);
        let (young, ratio) = (model.material.youngs_modulus, model.material.poissons_ratio);
        let kink = match model.plane {
            Plane::Strain => 0.5 * (1.0 - 2.0 * ratio) * (1.0 + ratio) / young,
            Plane::Stress => 0.5 * (1.0 - ratio) / young,
        };
        let reference_length = prepared.first().map_or(1.0, |first| first.surface.profile.length());
        let mut structure = Self {
            teeth,
            surface_modulus,
            reference_length,
            kink,
            surfaces: Vec::new(),
            directions: prepared.first().map_or(1, |first| first.loads.len()),
            offsets: Vec::new(),
            twists: Vec::new(),
            far: None,
            bore: None,
        };
        for offset in 0..=ring.map_or(0, RingFlexibility::window) {
            let tables = structure.tables(offset, &prepared, condensed, ring, interrupt)?;
            structure.offsets.push(tables);
        }
        let own = &structure.offsets[0].compliance;
        for (p, prepared) in prepared.iter().enumerate() {
            let sides = || p * structure.directions..(p + 1) * structure.directions;
            for (a, b) in sides().flat_map(|a| sides().map(move |b| (a, b))) {
                structure.twists.push([0, 1].map(|end| {
                    let slopes = prepared.surface.stretched.slopes(end);
                    slopes.sum(|i| slopes.sum(|j| own[a][b][(i, j)]))
                }));
            }
        }
        structure.surfaces = prepared.into_iter().map(|prepared| prepared.surface).collect();
        Ok(structure)
    }

    /// Returns the tables of one offset: the smooth part of the mesh response, as spline
    /// coefficients.
    fn tables(
        &self,
        offset: u32,
        prepared: &[Prepared],
        condensed: &Condensed,
        ring: Option<&RingFlexibility>,
        interrupt: &Interrupt,
    ) -> Result<OffsetTables, StructureError> {
        let _room = interrupt.reserve_memory(table_bytes(condensed)).map_err(StructureError::Interrupted)?;
        let response = response(condensed, ring, offset, interrupt)?;
        let directions = self.directions;
        let sides = || (0..prepared.len() * directions).map(|side| (side / directions, side % directions));
        let load_starts = starts(sides().map(|(p, direction)| prepared[p].loads[direction].len()));
        let row_starts = starts(prepared.iter().map(|surface| surface.stress_rows.len()));
        let stress = |all: &Mat<f64>| -> Vec<Vec<Mat<f64>>> {
            let table = |p: usize, side: usize| {
                let (rows, loads) =
                    (row_starts[p]..row_starts[p + 1], load_starts[side]..load_starts[side + 1]);
                let table = all.as_ref().submatrix(rows.start, loads.start, rows.len(), loads.len());
                let spline = &prepared[side / directions].surface.spline;
                spline.coefficients(table.transpose()).transpose().to_owned()
            };
            let loaded = 0..prepared.len() * directions;
            (0..prepared.len()).map(|p| loaded.clone().map(|side| table(p, side)).collect()).collect()
        };
        let compliance = |(p, a): (usize, usize), (q, b): (usize, usize)| {
            let (rows, columns) = (p * directions + a, q * directions + b);
            let (rows, loads) =
                (load_starts[rows]..load_starts[rows + 1], load_starts[columns]..load_starts[columns + 1]);
            let table =
                response.compliance.as_ref().submatrix(rows.start, loads.start, rows.len(), loads.len());
            let (observed, loaded) = (&prepared[p].surface, &prepared[q].surface);
            if offset > 0 || p != q {
                return Ok(both_sides(&observed.spline, &loaded.spline, table));
            }
            let smooth = self.smooth_remainder(&prepared[p], [a, b], table, interrupt)?;
            let mut coefficients = both_sides(&observed.stretched, &loaded.stretched, smooth.as_ref());
            if a == b {
                super::dense::mirror_lower(&mut coefficients);
            }
            Ok(coefficients)
        };
        let row = |observed| sides().map(|loaded| compliance(observed, loaded)).collect();
        Ok(OffsetTables {
            compliance: sides().map(row).collect::<Result<_, StructureError>>()?,
            stress_ahead: stress(&response.stress_ahead),
            stress_behind: response.stress_behind.as_ref().map_or_else(Vec::new, stress),
        })
    }

    /// Returns the response of the mesh on one surface less those of the half-plane and the kink to
    /// the same mollifiers. `directions` are those of the observer and the load. The half-plane
    /// responds alike if both point into the body or both along the surface; between the two
    /// directions its response has a step where both points coincide (Johnson, Contact Mechanics,
    /// eqs. 2.19 and 2.22).
    fn smooth_remainder(
        &self,
        prepared: &Prepared,
        directions: [usize; 2],
        influence: MatRef<'_, f64>,
        interrupt: &Interrupt,
    ) -> Result<Mat<f64>, StructureError> {
        let quadrature = PairQuadrature::default();
        let log_factor = -2.0 / (PI * self.surface_modulus);
        let log_length = self.reference_length.ln();
        let surface = &prepared.surface;
        let place = |s: f64| surface.normal_angle_at(s);
        let turned: Vec<MollifierSamples<NormalAngle>> =
            prepared.mollifiers.iter().map(|mollifier| quadrature.sampled(mollifier, place)).collect();
        let curved = |a: NormalAngle, b: NormalAngle| self.curvature_term(surface, a, b);
        let step = if directions[0] == 0 { self.kink } else { -self.kink };
        let across =
            |a: NormalAngle, b: NormalAngle| if a.s == b.s { 0.0 } else { step * (a.s - b.s).signum() };
        let alike = directions[0] == directions[1];
        let mut smooth = influence.to_owned();
        for k in 0..turned.len() {
            interrupt.check().map_err(StructureError::Interrupted)?;
            let count = if alike { k + 1 } else { turned.len() };
            for l in 0..count {
                smooth[(k, l)] -= if alike {
                    let (observer, load) = (&prepared.mollifiers[k], &prepared.mollifiers[l]);
                    let logarithm = quadrature.logarithm(observer, load) - log_length;
                    log_factor * logarithm + quadrature.mean(&turned[k], &turned[l], place, curved)
                } else {
                    quadrature.mean(&turned[k], &turned[l], place, across)
                };
            }
        }
        if alike {
            super::dense::mirror_lower(&mut smooth);
        }
        Ok(smooth)
    }
}

/// Returns the temporary memory for the tables of one offset, bytes: the responses, and spline
/// coefficients in one variable and in both.
fn table_bytes(condensed: &Condensed) -> u64 {
    let (loads, rows, cuts) = (condensed.own.nrows(), condensed.rows_own.nrows(), condensed.on_cuts.nrows());
    let numbers = loads * (4 * loads + 6 * rows + 2 * cuts);
    (size_of::<f64>() * numbers) as u64
}

/// Response of the mesh to unit mollified loads on one sector.
pub(super) struct Response {
    /// Compliance on the sector ahead, rows by observing mollifier.
    pub compliance: Mat<f64>,
    pub stress_ahead: Mat<f64>,
    /// Stress on this sector by loads on the sector ahead; `None` if both are the same sector.
    pub stress_behind: Option<Mat<f64>>,
}

pub(super) fn response(
    condensed: &Condensed,
    ring: Option<&RingFlexibility>,
    offset: u32,
    interrupt: &Interrupt,
) -> Result<Response, StructureError> {
    let Some(ring) = ring else {
        let (compliance, stress_ahead) = (condensed.own.clone(), condensed.rows_own.clone());
        return Ok(Response { compliance, stress_ahead, stress_behind: None });
    };
    let checkpoint = || interrupt.check().map_err(StructureError::Interrupted);
    let dense = Interruptible(&checkpoint);
    let cuts_ahead = dense.product(ring.at(offset), condensed.on_cuts.as_ref())?;
    let mut response = Response {
        compliance: dense.product(condensed.on_cuts.transpose(), cuts_ahead.as_ref())?,
        stress_ahead: dense.product(condensed.rows_cuts.as_ref(), cuts_ahead.as_ref())?,
        stress_behind: None,
    };
    if offset == 0 {
        response.compliance += &condensed.own;
        response.stress_ahead += &condensed.rows_own;
    } else {
        let cuts_behind = dense.product(ring.at(offset).transpose(), condensed.on_cuts.as_ref())?;
        response.stress_behind = Some(dense.product(condensed.rows_cuts.as_ref(), cuts_behind.as_ref())?);
    }
    Ok(response)
}

/// Returns the coupling of the loads and stress recovery points of a sector with the released
/// amplitudes of the bore.
fn bore_coupling(
    released: ReleasedMeans,
    condensed: &Condensed,
    prepared: &[Prepared],
    (sectors, pitch): (u32, f64),
    interrupt: &Interrupt,
) -> Result<BoreCoupling, StructureError> {
    let checkpoint = || interrupt.check().map_err(StructureError::Interrupted);
    let dense = Interruptible(&checkpoint);
    let forces = dense.product(released.constraint_forces.as_ref(), condensed.on_cuts.as_ref())?;
    let stresses = dense.product(condensed.rows_cuts.as_ref(), released.constraint_forces.transpose())?;
    let [loads, stress] = by_surface(&forces, &stresses, prepared);
    Ok(BoreCoupling { loads, stress, ..BoreCoupling::new(released, sectors, pitch) })
}

/// Divides responses to all loads, one column each, and those of all stress rows by surface: the
/// former by the unknowns of the table of each side.
fn by_surface(loads: &Mat<f64>, rows: &Mat<f64>, prepared: &[Prepared]) -> [Vec<Mat<f64>>; 2] {
    let (mut by_unknown, mut stress) = (Vec::new(), Vec::new());
    let (mut load, mut row) = (0, 0);
    for surface in prepared {
        for of_direction in &surface.loads {
            let table = loads.as_ref().subcols(load, of_direction.len());
            by_unknown.push(surface.surface.spline.coefficients(table.transpose()).transpose().to_owned());
            load += of_direction.len();
        }
        let count = surface.stress_rows.len();
        stress.push(rows.as_ref().subrows(row, count).to_owned());
        row += count;
    }
    [by_unknown, stress]
}

/// Returns spline coefficients of a table in both variables.
pub(super) fn both_sides(rows: &BSpline, columns: &BSpline, table: MatRef<'_, f64>) -> Mat<f64> {
    let by_row = rows.coefficients(table);
    columns.coefficients(by_row.transpose()).transpose().to_owned()
}

pub(super) fn starts(counts: impl Iterator<Item = usize>) -> Vec<usize> {
    let mut starts = vec![0];
    for count in counts {
        starts.push(starts[starts.len() - 1] + count);
    }
    starts
}

fn gathered(prepared: &[Prepared]) -> (Vec<SparseVector>, Vec<SparseVector>) {
    let loads = prepared.iter().flat_map(|surface| surface.loads.iter().flatten().cloned()).collect();
    let rows = prepared.iter().flat_map(|surface| surface.stress_rows.iter().cloned()).collect();
    (loads, rows)
}

pub(super) fn chain<'a>(model: &'a PlaneModel, name: &str) -> Result<&'a EdgeChain, StructureError> {
    model.mesh.chain(name).ok_or_else(|| StructureError::NoChain { chain: name.into() })
}

pub(super) fn prepare(
    model: &PlaneModel,
    sources: &[SurfaceSource],
    options: &SplitOptions,
    interrupt: &Interrupt,
) -> Result<Vec<Prepared>, StructureError> {
    let recovery = StressRecovery::new(model);
    sources.iter().map(|source| prepare_surface(model, &recovery, source, options, interrupt)).collect()
}

fn prepare_surface(
    model: &PlaneModel,
    recovery: &StressRecovery<'_>,
    source: &SurfaceSource,
    options: &SplitOptions,
    interrupt: &Interrupt,
) -> Result<Prepared, StructureError> {
    let checkpoint = || interrupt.check().map_err(StructureError::Interrupted);
    checkpoint()?;
    let loaded = chain(model, &source.chain)?;
    let samples = sample(&model.mesh, loaded, source.edges, options)
        .ok_or_else(|| StructureError::Coarse { chain: source.chain.clone() })?;
    let mut loads = Vec::new();
    for direction in 0..if options.allows_modified_surfaces { 2 } else { 1 } {
        let load = |mollifier: &Mollifier| {
            checkpoint()?;
            Ok(model.edge_load_between(loaded, mollifier.support(), |s, point| match direction {
                0 => point.normal.map(|part| -part * mollifier.value(s)),
                _ => source.profile.at(s).tangent.map(|part| part * mollifier.value(s)),
            }))
        };
        loads.push(samples.mollifiers.iter().map(load).collect::<Result<_, StructureError>>()?);
    }

    let mut surface = Surface {
        profile: source.profile.clone(),
        stretched: BSpline::new(samples.s.iter().map(|&s| samples.stretch.at(s)).collect()),
        spline: BSpline::new(samples.s),
        stretch: samples.stretch,
        range: loaded.range(),
        turned: Vec::new(),
        stress_points: Vec::new(),
    };
    surface.turned = normal_angle_coefficients(&surface);
    let mut stress_rows = Vec::new();
    if let Some(name) = &source.stress_chain {
        let free = chain(model, name)?;
        let places = source.stress_points_per_edge.max(1);
        for edge in &free.edges {
            checkpoint()?;
            for place in 0..places {
                let share = (place as f64 + 0.5) / places as f64;
                let s = edge.s[0] + share * (edge.s[1] - edge.s[0]);
                let found = recovery.surface_row(free, s).zip(model.mesh.chain_point(free, s));
                if let Some((row, point)) = found {
                    stress_rows.push(row);
                    surface.stress_points.push((s, point.position));
                }
            }
        }
    }
    Ok(Prepared { surface, mollifiers: samples.mollifiers, loads, stress_rows })
}

/// Returns spline coefficients of the angle by which the normal has rotated since the first sample,
/// positive where convex.
fn normal_angle_coefficients(surface: &Surface) -> Vec<f64> {
    let mut angles = Vec::with_capacity(surface.spline.nodes().len());
    let mut previous: Option<[f64; 2]> = None;
    let mut angle = 0.0;
    for &s in surface.spline.nodes() {
        let point = surface.profile.at(s);
        let [x, y] = point.tangent;
        if let Some([px, py]) = previous {
            // With the material on the left of the tangent, a convex curve bends to the left.
            let left = y * point.normal[0] - x * point.normal[1];
            angle += left.signum() * (px * y - py * x).atan2(px * x + py * y);
        }
        previous = Some(point.tangent);
        angles.push(angle);
    }
    let table = Mat::from_fn(angles.len(), 1, |i, _| angles[i]);
    surface.spline.coefficients(table.as_ref()).col(0).iter().copied().collect()
}
