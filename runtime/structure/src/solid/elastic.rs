//! Finite-element model of a three-dimensional elastic body, condensed onto its surfaces.
//!
//! As in plane models ([`crate::ElasticStructure`]), the compliance of a surface is that
//! of the half-space plus a smooth part. The smooth part is the difference between the responses of
//! mesh and half-space to the same loads, observed in the same way. Loads and observers are
//! mollifiers across a flank and polynomials along it ([`super::axial_modes`]). For each pair of
//! polynomials the smooth part is a function of two coordinates across the flank and behaves as in
//! a plane model. It has the kink of a curved surface where both points coincide (see the plane
//! module). The kink is subtracted for pairs of equal polynomials and added again in closed form;
//! without this step, compliances between close points of an involute changed by up to 1e-3.
//!
//! The half-space has images of its loads in both side faces. With Poisson's ratio 0, a load that
//! is uniform along the face needs no further terms: there is no stress normal to the face.
//! Otherwise the faces bulge, and the corresponding part of the compliance varies over the load's
//! distance from the face; the polynomials represent as much of it as they resolve.
//!
//! See `docs/theory/compliance.md`.

mod prepared;

use super::Mirror;
use super::axial_modes::AxialModes;
use super::exchange::Sector;
use super::mirror_symmetry::MirrorMap;
use super::responses::{BoreResponse, Responses, whole};
use super::surface_metric::SurfaceMetric;
use crate::bore::{BoreMeans, RequestedMeans};
use crate::bore_coupling::BoreCoupling;
use crate::bspline::BSpline;
use crate::condense::{Support, condense, match_cuts};
use crate::dense::mirror_lower;
use crate::elastic::NormalAngle;
use crate::elastic::{OffsetTables, both_sides, starts};
use crate::far_coupling::FarCoupling;
use crate::kernel::{MollifierSamples, PairQuadrature};
use crate::sampling::EdgeCoordinate;
use crate::surface::Surface;
use crate::{MeshSupport, RevolvedWeb, RingSource, StructureError};
use calyx_fe::material::Plane;
use calyx_fe::solid::{ABSENT, FaceSet, SolidModel};
use calyx_numerics::interrupt::Interrupt;
use faer::{Mat, MatRef};
use prepared::{Prepared, prepare};
use rayon::prelude::*;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;
use wide::f64x4;

/// Numbers of an [`f64x4`].
const LANES: usize = 4;

/// Loadable surface of a solid mesh. Sets of faces are named as in
/// [`calyx_fe::solid::SolidMesh::faces`] and swept from chains of the section.
#[derive(Clone)]
pub struct SolidSurfaceSource {
    /// Surface from which the mesh was generated. Its coordinates are those of the chart of the
    /// faces: `u` is `s`, the arc length of the chain, and `v` the coordinate of the stations, the
    /// axial one of an extruded surface ([`Surface::is_extruded`]).
    pub surface: Arc<dyn Surface>,
    /// Set of its faces, without a rounded edge of the body.
    pub faces: String,
    /// Rounding (m) of the sharp edges of the body at the start and the end of the chain; `None`
    /// where the body continues smoothly.
    pub edges: [Option<f64>; 2],
    /// Set of faces of an adjacent free surface on which stress is recovered: the fillet.
    pub stress_faces: Option<String>,
    /// Number of stress recovery points on each edge of that chain and on each layer of elements,
    /// at least 1; along the face both ends are recovery points too.
    pub stress_points: [usize; 2],
}

/// Number of lowest polynomials along the face that are extrapolated towards edges beyond the
/// samples.
const CONTINUED: usize = 3;

/// Resolution of the compliance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SolidSplitOptions {
    /// Factor on the matching depth, 1 by default. Results should hardly depend on it; varying it
    /// checks this.
    pub matching_depth: f64,
    /// Number of samples across each surface, at least 8.
    pub samples: usize,
    /// Largest number of polynomials along the face; no more are used than the mesh resolves.
    pub axial_modes: usize,
}

impl SolidSplitOptions {
    /// Returns the number of polynomials along the face for a mesh with a number of layers of
    /// elements of some order: those that one layer contains; for several layers, one for each of
    /// their nodes except the first, which was best in tests.
    pub fn polynomials(&self, layers: usize, order: usize) -> usize {
        self.axial_modes.min((order + 1).max(layers * order)).max(1)
    }
}

impl Default for SolidSplitOptions {
    fn default() -> Self {
        Self { matching_depth: 1.0, samples: 14, axial_modes: 12 }
    }
}

/// Three-dimensional elastic body. See the module documentation.
pub struct ElasticSolid {
    pub(super) teeth: u32,
    pub(super) surface_modulus: f64,
    /// Displacement per angle between normals under a line load, m/(N/m).
    pub(super) kink: f64,
    pub(super) mirrors: [Mirror; 2],
    pub(super) modes: AxialModes,
    pub(super) surfaces: Vec<SurfaceTables>,
    /// Tables by offset of the observing sector ahead of the loaded one; a side is a surface. The
    /// compliance of a surface with itself has two additional entries for each polynomial: the
    /// increments of a point beyond the first or the last sample ([`continued`]). Stress has three
    /// rows for each point, Pa/N.
    pub(super) offsets: Vec<OffsetTables>,
    /// Coupling of sectors beyond those offsets.
    pub(super) far: Option<FarCoupling>,
    /// Coupling through what supports the bore: spline teeth or contact outside of the structure.
    pub(super) bore: Option<BoreCoupling>,
}

/// Surface of a condensed body. Its tables are indexed by a sample across and a polynomial along:
/// `polynomial * places + place`.
pub(super) struct SurfaceTables {
    pub surface: Arc<dyn Surface>,
    /// Spline over arc length, for everything but the compliance of the surface with itself.
    pub spline: BSpline,
    pub stretch: EdgeCoordinate,
    /// Spline over the stretched coordinate, for the compliance of the surface with itself.
    pub stretched: BSpline,
    /// Range of arc lengths of the chain. Coordinates beyond it are clamped to its ends.
    pub range: [f64; 2],
    /// Spline coefficients of the angle by which the transverse normal has rotated, positive where
    /// convex, rad.
    pub turned: Vec<f64>,
    /// Stress recovery points: coordinates on the chart of those faces, and position, m.
    pub stress_points: Vec<([f64; 2], [f64; 3])>,
    /// Metric of a surface that is not extruded.
    pub metric: Option<SurfaceMetric>,
}

impl ElasticSolid {
    /// Builds a ring of equal sectors about the z axis. `model` is one sector, the surfaces are
    /// those of one sector; `ring` names sets of faces.
    ///
    /// # Errors
    /// Faces are missing, too coarse or not swept, the cuts do not conform, the ring is not
    /// supported, or the computation is interrupted.
    pub fn ring(
        model: &SolidModel,
        ring: &RingSource<'_>,
        surfaces: &[SolidSurfaceSource],
        options: &SolidSplitOptions,
        interrupt: &Interrupt,
    ) -> Result<Self, StructureError> {
        // Only the polynomials along extruded surfaces are certainly even or odd.
        let is_extruded = surfaces.iter().all(|source| source.surface.is_extruded());
        let mirrored = is_extruded.then(|| MirrorMap::of(&model.mesh)).flatten();
        Self::ring_by(mirrored.as_ref(), model, ring, (surfaces, options), interrupt)
    }

    /// Builds a ring of equal sectors whose bore is supported only by a web with a separate mesh.
    ///
    /// # Errors
    /// As for [`Self::ring`], and the errors of the web.
    pub fn ring_on_web(
        model: &SolidModel,
        ring: &RingSource<'_>,
        web: &RevolvedWeb,
        (surfaces, options): (&[SolidSurfaceSource], &SolidSplitOptions),
        interrupt: &Interrupt,
    ) -> Result<Self, StructureError> {
        let sectors = ring.sectors.max(1);
        let means = BoreMeans::on_web(model, faces(model, ring.bore)?, web, sectors, interrupt)?;
        let means = Some(means.ok_or(StructureError::NoArea)?);
        Self::supported_ring(None, model, ring, (Vec::new(), means), (surfaces, options), interrupt)
    }

    /// Builds the ring by halves, if the mirror is given.
    pub(super) fn ring_by(
        mirrored: Option<&MirrorMap>,
        model: &SolidModel,
        ring: &RingSource<'_>,
        (surfaces, options): (&[SolidSurfaceSource], &SolidSplitOptions),
        interrupt: &Interrupt,
    ) -> Result<Self, StructureError> {
        let bore = faces(model, ring.bore)?;
        let support = match RequestedMeans::for_ring(ring.support) {
            None => (model.mesh.nodes_on(bore), None),
            Some(wanted) => {
                let means = BoreMeans::solid(model, bore, wanted, interrupt)?;
                (Vec::new(), Some(means.ok_or(StructureError::NoArea)?))
            }
        };
        Self::supported_ring(mirrored, model, ring, support, (surfaces, options), interrupt)
    }

    /// Builds the ring from the fixed nodes of the bore and its mean constraints.
    fn supported_ring(
        mirrored: Option<&MirrorMap>,
        model: &SolidModel,
        ring: &RingSource<'_>,
        (mut constrained, means): (Vec<usize>, Option<BoreMeans>),
        (surfaces, options): (&[SolidSurfaceSource], &SolidSplitOptions),
        interrupt: &Interrupt,
    ) -> Result<Self, StructureError> {
        let nodes = |name: &str| Ok::<_, StructureError>(model.mesh.nodes_on(faces(model, name)?));
        let (first, last) = (nodes(ring.cuts[0])?, nodes(ring.cuts[1])?);
        let sectors = ring.sectors.max(1);
        constrained.extend(model.mesh.node_sets.get(ABSENT).into_iter().flatten());
        constrained.sort_unstable();
        constrained.dedup();
        let pitch = TAU / f64::from(sectors);
        let cuts = match_cuts(&model.mesh.nodes, &first, &last, &constrained, pitch)
            .ok_or_else(|| StructureError::CutsDiffer { cuts: ring.cuts.map(String::from) })?;
        let (modes, prepared, exchange) = prepare(model, surfaces, options, interrupt)?;
        let sector = Sector { cuts, constrained, means, sectors, coupled: ring.coupled };
        let mut responses = Responses::for_ring(model, &sector, mirrored, &exchange, interrupt)
            .map_err(|error| ring.support.with_bore_context(error))?;
        let through = responses.bore.take();
        let bore = through.map(|through| bore_coupling(through, &prepared, modes.count(), (sectors, pitch)));
        let far = responses.far.take();
        let by_surface =
            |loads: &Mat<f64>, rows: &Mat<f64>| by_surface(loads, rows, &prepared, modes.count());
        let far = far.map(|far| far.coupling(sectors, by_surface));
        let body = Self::assemble(model, sectors, modes, prepared, &responses, interrupt)?;
        Ok(Self { far, bore, ..body })
    }

    /// Builds a body of a single mesh. `support` names a set of faces.
    ///
    /// # Errors
    /// Faces are missing, too coarse or not swept, the mesh has a mechanism, or the computation is
    /// interrupted.
    pub fn single(
        model: &SolidModel,
        support: MeshSupport<'_>,
        surfaces: &[SolidSurfaceSource],
        options: &SolidSplitOptions,
        interrupt: &Interrupt,
    ) -> Result<Self, StructureError> {
        let (modes, prepared, exchange) = prepare(model, surfaces, options, interrupt)?;
        let assembled = whole(model, interrupt)?;
        let condense =
            |support| condense(&assembled, &support, None, &exchange.loads, &exchange.rows, interrupt);
        let condensed = match support {
            MeshSupport::Free => {
                let mass = model.mass();
                condense(Support::Free { mass: &mass, motions: &model.rigid_body_modes() })?
            }
            MeshSupport::Chain(name) => {
                let mut nodes = model.mesh.nodes_on(faces(model, name)?);
                nodes.extend(model.mesh.node_sets.get(ABSENT).into_iter().flatten());
                condense(Support::Constrained(&assembled.dofs_of(&nodes)))?
            }
        };
        Self::assemble(model, 1, modes, prepared, &Responses::of_body(condensed, &exchange), interrupt)
    }

    fn assemble(
        model: &SolidModel,
        teeth: u32,
        modes: AxialModes,
        prepared: Vec<Prepared>,
        responses: &Responses,
        interrupt: &Interrupt,
    ) -> Result<Self, StructureError> {
        let (young, ratio) = (model.material.youngs_modulus, model.material.poissons_ratio);
        let mirror = |z: f64| Mirror { point: [0.0, 0.0, z], normal: [0.0, 0.0, 1.0] };
        let mut structure = Self {
            teeth,
            surface_modulus: model.material.surface_modulus(Plane::Strain),
            kink: 0.5 * (1.0 - 2.0 * ratio) * (1.0 + ratio) / young,
            mirrors: modes.range().map(mirror),
            modes,
            surfaces: Vec::new(),
            offsets: Vec::new(),
            far: None,
            bore: None,
        };
        for offset in 0..=responses.window() {
            let tables = structure.tables(offset, &prepared, responses, interrupt)?;
            structure.offsets.push(tables);
        }
        structure.surfaces = prepared.into_iter().map(|prepared| prepared.known).collect();
        Ok(structure)
    }

    /// Returns the tables of one offset: the smooth part of the mesh response, as spline
    /// coefficients.
    fn tables(
        &self,
        offset: u32,
        prepared: &[Prepared],
        responses: &Responses,
        interrupt: &Interrupt,
    ) -> Result<OffsetTables, StructureError> {
        let response = responses.at(offset, interrupt)?;
        let count = self.modes.count();
        let load_starts = starts(prepared.iter().map(|surface| surface.loads));
        let row_starts = starts(prepared.iter().map(|surface| surface.stress_rows));
        let all = 0..prepared.len();
        let stress = |rows: &Mat<f64>| -> Vec<Vec<Mat<f64>>> {
            let table = |p: usize, q: usize| {
                by_unknown(part(rows, [&row_starts, &load_starts], [p, q]), &prepared[q].known.spline, count)
            };
            all.clone().map(|p| all.clone().map(|q| table(p, q)).collect()).collect()
        };
        let compliance = |p: usize, q: usize| {
            let table = part(&response.compliance, [&load_starts, &load_starts], [p, q]);
            if offset == 0 && p == q {
                return self.own_table(&prepared[p], table, interrupt);
            }
            let splines = [p, q].map(|side| &prepared[side].known.spline);
            let places = splines.map(|spline| spline.nodes().len());
            Ok(block_by_block(table, count, places, |_, block| both_sides(splines[0], splines[1], block)))
        };
        let row = |p: usize| all.clone().map(|q| compliance(p, q)).collect();
        Ok(OffsetTables {
            compliance: all.clone().map(row).collect::<Result<_, StructureError>>()?,
            stress_ahead: stress(&response.stress_ahead),
            stress_behind: response.stress_behind.as_ref().map_or_else(Vec::new, stress),
        })
    }

    /// Returns the response of the mesh on one surface less those of the half-space and the kink to
    /// the same loads.
    fn own_table(
        &self,
        prepared: &Prepared,
        influence: MatRef<'_, f64>,
        interrupt: &Interrupt,
    ) -> Result<Mat<f64>, StructureError> {
        let known = &prepared.known;
        let (places, count) = (prepared.mollifiers.len(), self.modes.count());
        let quadrature = PairQuadrature::default();
        let place = |s: f64| known.normal_angle_at(s);
        let turned: Vec<MollifierSamples<NormalAngle>> =
            prepared.mollifiers.iter().map(|mollifier| quadrature.sampled(mollifier, place)).collect();
        let curved = |a: NormalAngle, b: NormalAngle| self.curvature_term(known, a, b);
        let per_length = known.metric.as_ref().map(SurfaceMetric::per_length);
        let pairs: Vec<(usize, usize)> = (0..places).flat_map(|k| (0..=k).map(move |l| (k, l))).collect();
        let taken_out = pairs
            .par_iter()
            .map(|&(k, l)| {
                interrupt.check().map_err(StructureError::Interrupted)?;
                let (observer, load) = (&prepared.mollifiers[k], &prepared.mollifiers[l]);
                let kink = quadrature.mean(&turned[k], &turned[l], place, curved);
                let mut means = prepared.means.between(observer, load);
                for n in 0..count {
                    for m in 0..count {
                        means[(n, m)] /= PI * self.surface_modulus;
                        if let Some(per_length) = &per_length {
                            means[(n, m)] += kink * per_length[(n, m)];
                        }
                    }
                    if per_length.is_none() {
                        means[(n, n)] += kink;
                    }
                }
                Ok(means)
            })
            .collect::<Result<Vec<_>, StructureError>>()?;
        let mut smooth = influence.to_owned();
        for (&(k, l), means) in pairs.iter().zip(&taken_out) {
            for n in 0..count {
                for m in 0..count {
                    smooth[(n * places + k, m * places + l)] -= means[(n, m)];
                    if k != l {
                        smooth[(m * places + l, n * places + k)] -= means[(n, m)];
                    }
                }
            }
        }
        let spline = &known.stretched;
        let mut coefficients = block_by_block(smooth.as_ref(), count, [places, places], |modes, block| {
            continued(spline, both_sides(spline, spline, block).as_ref(), modes)
        });
        mirror_lower(&mut coefficients);
        Ok(coefficients)
    }

    /// Returns the non-smooth part of the compliance to a line load where `a` and `b` coincide that
    /// curvature adds to the half-space's, m/(N/m).
    pub(super) fn curvature_term(&self, surface: &SurfaceTables, a: NormalAngle, b: NormalAngle) -> f64 {
        // Convex is positive: the angle increases with the arc length.
        let turn = if a.s >= b.s { a.angle - b.angle } else { b.angle - a.angle };
        let distance = (a.s - b.s).abs() / (surface.range[1] - surface.range[0]);
        let logarithmic = if distance > 0.0 { turn * turn * distance.ln() } else { 0.0 };
        self.kink * turn + logarithmic / (PI * self.surface_modulus)
    }

    /// Computes [`Self::curvature_term`] of a point with each of several others, four at a time.
    pub(super) fn curvature_terms(
        &self,
        surface: &SurfaceTables,
        own: NormalAngle,
        others: &[NormalAngle],
        terms: &mut [f64],
    ) {
        let length = f64x4::splat(surface.range[1] - surface.range[0]);
        let kink = f64x4::splat(self.kink);
        let stiffness = f64x4::splat(PI * self.surface_modulus);
        let (s, angle) = (f64x4::splat(own.s), f64x4::splat(own.angle));
        for (others, terms) in others.chunks(LANES).zip(terms.chunks_mut(LANES)) {
            let lanes = |value: fn(&NormalAngle) -> f64| {
                f64x4::from(std::array::from_fn::<f64, LANES, _>(|k| others.get(k).map_or(own.s, value)))
            };
            let (other_s, other_angle) = (lanes(|other| other.s), lanes(|other| other.angle));
            let ahead = s - other_s;
            let turn = (angle - other_angle).flip_signs(ahead);
            // The angles are equal where the distance is zero.
            let distance = (ahead.abs() / length).max(f64x4::splat(f64::MIN_POSITIVE));
            let all = kink * turn + turn * turn * distance.ln() / stiffness;
            terms.copy_from_slice(&all.to_array()[..terms.len()]);
        }
    }
}

impl SurfaceTables {
    pub fn normal_angle_at(&self, s: f64) -> NormalAngle {
        let s = s.clamp(self.range[0], self.range[1]);
        NormalAngle { s, angle: self.spline.weights(s).sum(|i| self.turned[i]) }
    }

    /// Returns the number of samples across in its tables.
    pub fn places(&self) -> usize {
        self.spline.nodes().len()
    }
}

/// Returns the coefficients of a surface with itself for a pair of polynomials, with two more
/// columns: the increment of a point beyond the first or the last sample over that of the sample,
/// by its distance.
///
/// The increment is linear extrapolation, but not in both variables beyond the same end. At the
/// table's corner the product term would be wrong, because towards a free edge the compliance of a
/// point grows with the logarithm of the distance, independently of neighbouring points. Higher
/// polynomials are constant beyond the outermost samples: their slope is not accurate enough, and
/// an incorrect one outweighs the half-space under a narrow cell.
fn continued(spline: &BSpline, inner: MatRef<'_, f64>, modes: [usize; 2]) -> Mat<f64> {
    let places = inner.nrows();
    let [rows_go_on, columns_go_on] = modes.map(|mode| mode < CONTINUED);
    let slopes = [0, 1].map(|end| spline.slopes(end));
    let mut all = Mat::zeros(places + 2, places + 2);
    all.as_mut().submatrix_mut(0, 0, places, places).copy_from(inner);
    for end in 0..2 {
        for other in 0..places {
            if rows_go_on {
                all[(places + end, other)] = slopes[end].sum(|i| inner[(i, other)]);
            }
            if columns_go_on {
                all[(other, places + end)] = slopes[end].sum(|j| inner[(other, j)]);
            }
        }
        if rows_go_on && columns_go_on {
            all[(places + end, places + 1 - end)] =
                slopes[end].sum(|i| slopes[1 - end].sum(|j| inner[(i, j)]));
        }
    }
    all
}

/// Returns the block of a matrix for a pair of surfaces.
fn part<'a>(all: &'a Mat<f64>, starts: [&[usize]; 2], [p, q]: [usize; 2]) -> MatRef<'a, f64> {
    let [rows, columns] = starts;
    all.as_ref().submatrix(rows[p], columns[q], rows[p + 1] - rows[p], columns[q + 1] - columns[q])
}

/// Converts columns by loads to columns by spline coefficients, polynomial by polynomial.
fn by_unknown(table: MatRef<'_, f64>, spline: &BSpline, count: usize) -> Mat<f64> {
    let places = spline.nodes().len();
    let mut coefficients = Mat::zeros(table.nrows(), table.ncols());
    for mode in 0..count {
        let values = table.subcols(mode * places, places).transpose();
        let target = coefficients.as_mut().subcols_mut(mode * places, places);
        target.transpose_mut().copy_from(spline.coefficients(values));
    }
    coefficients
}

/// Returns the coupling of the loads and stress recovery points of a sector with the released
/// amplitudes of the bore.
fn bore_coupling(
    through: BoreResponse,
    prepared: &[Prepared],
    modes: usize,
    (sectors, pitch): (u32, f64),
) -> BoreCoupling {
    let BoreResponse { released, forces, stresses } = through;
    let [loads, stress] = by_surface(&forces, &stresses, prepared, modes);
    BoreCoupling { loads, stress, ..BoreCoupling::new(released, sectors, pitch) }
}

/// Divides responses to all loads, one column each, and those of all stress rows by surface: the
/// former by the unknowns of its table.
fn by_surface(loads: &Mat<f64>, rows: &Mat<f64>, prepared: &[Prepared], modes: usize) -> [Vec<Mat<f64>>; 2] {
    let (mut of_loads, mut stress) = (Vec::new(), Vec::new());
    let (mut load, mut row) = (0, 0);
    for surface in prepared {
        let own = loads.as_ref().subcols(load, surface.loads);
        of_loads.push(by_unknown(own, &surface.known.spline, modes));
        stress.push(rows.as_ref().subrows(row, surface.stress_rows).to_owned());
        (load, row) = (load + surface.loads, row + surface.stress_rows);
    }
    [of_loads, stress]
}

/// Applies a map to the block of each pair of polynomials.
fn block_by_block(
    table: MatRef<'_, f64>,
    count: usize,
    [rows, columns]: [usize; 2],
    map: impl Fn([usize; 2], MatRef<'_, f64>) -> Mat<f64>,
) -> Mat<f64> {
    let mut mapped = Mat::zeros(0, 0);
    for n in 0..count {
        for m in 0..count {
            let block = map([n, m], table.submatrix(n * rows, m * columns, rows, columns));
            let (height, width) = (block.nrows(), block.ncols());
            if mapped.nrows() == 0 {
                mapped = Mat::zeros(count * height, count * width);
            }
            mapped.as_mut().submatrix_mut(n * height, m * width, height, width).copy_from(block);
        }
    }
    mapped
}

fn faces<'a>(model: &'a SolidModel, name: &str) -> Result<&'a FaceSet, StructureError> {
    model.mesh.face_set(name).ok_or_else(|| StructureError::NoFaces { faces: name.into() })
}
