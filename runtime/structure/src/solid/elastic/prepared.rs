//! Loads and observers of the surfaces of a three-dimensional mesh, before solution: mollifiers
//! across by polynomials along the face, and rows of stress.

use super::{SolidSplitOptions, SolidSurfaceSource, SurfaceTables, faces};
use crate::StructureError;
use crate::bspline::BSpline;
use crate::kernel::Mollifier;
use crate::sampling::{SplitOptions, sample};
use crate::solid::axial_modes::AxialModes;
use crate::solid::exchange::LoadsAndRows;
use crate::solid::half_space::ReciprocalMeans;
use crate::solid::half_space_means::HalfSpaceMeans;
use crate::solid::mirror_symmetry::images_of;
use crate::solid::screw::Screw;
use crate::solid::side_faces::SideFaces;
use crate::solid::surface_means::SurfaceMeans;
use crate::solid::surface_metric::{SurfaceMetric, normal_angles};
use crate::surface::Surface;
use calyx_fe::solid::{FacePoint, FaceSet, SolidModel, SurfaceStressRecovery};
use calyx_fe::{EdgeChain, SparseVector};
use calyx_numerics::interrupt::{Interrupt, MemoryReservation};
use calyx_numerics::vec3::{Vector, length, minus};
use faer::Mat;
use rayon::prelude::*;

/// Largest distance of a point of a surface from the point of its mesh with the same coordinates,
/// relative to the length of the profile.
const COORDINATES: f64 = 0.02;

/// Surface with its loads and stress rows, before solution.
pub(super) struct Prepared {
    pub known: SurfaceTables,
    pub mollifiers: Vec<Mollifier>,
    pub means: HalfSpaceMeans,
    /// Number of its loads.
    pub loads: usize,
    /// Number of its rows of stress.
    pub stress_rows: usize,
}

/// Loads and stress rows of a surface.
struct Vectors {
    /// Loads by polynomial, then mollifier.
    loads: Vec<SparseVector>,
    /// Stress rows, three for each point.
    rows: Vec<SparseVector>,
    room: MemoryReservation,
}

/// Collects all loads and rows of a sector.
fn gathered(modes: &AxialModes, prepared: &[Prepared], vectors: Vec<Vectors>) -> LoadsAndRows {
    // Every other polynomial along the face is odd.
    let is_odd = |surface: &Prepared| {
        let places = surface.mollifiers.len();
        (0..surface.loads).map(move |load| load / places % 2 == 1).collect::<Vec<_>>()
    };
    let odd = prepared.iter().flat_map(is_odd).collect();
    let (mut loads, mut rows, mut rooms) = (Vec::new(), Vec::new(), Vec::new());
    for of_surface in vectors {
        loads.extend(of_surface.loads);
        rows.extend(of_surface.rows);
        rooms.push(of_surface.room);
    }
    let mut images = Vec::new();
    for surface in prepared {
        let first = images.len();
        let positions: Vec<[f64; 3]> = surface.known.stress_points.iter().map(|&(_, at)| at).collect();
        for image in images_of(&positions, modes.range()) {
            // The mirror image reverses the sign of shear.
            let rows = [1.0, 1.0, -1.0].into_iter().enumerate();
            images.extend(rows.map(|(row, sign)| Some((first + 3 * image? + row, sign))));
        }
    }
    LoadsAndRows { loads, odd, rows, images, rooms }
}

/// Prepares the surfaces, all their loads and rows, and the polynomials along the face that all
/// share.
///
/// # Errors
/// The mesh is not swept or too coarse, faces are missing, or the computation is interrupted.
pub(super) fn prepare(
    model: &SolidModel,
    sources: &[SolidSurfaceSource],
    options: &SolidSplitOptions,
    interrupt: &Interrupt,
) -> Result<(AxialModes, Vec<Prepared>, LoadsAndRows), StructureError> {
    let not_swept = || StructureError::NotSwept {
        faces: sources.first().map_or_else(String::new, |source| source.faces.clone()),
    };
    let swept = model.mesh.swept.as_ref().ok_or_else(not_swept)?;
    let recovery = SurfaceStressRecovery::new(model).ok_or_else(not_swept)?;
    let layers = swept.stations.len() - 1;
    let order = swept.orders.iter().copied().min().map_or(1, usize::from);
    let modes = AxialModes::new(swept.z_range(), options.polynomials(layers, order));
    let prepared = sources
        .iter()
        .map(|source| prepare_surface(model, &recovery, &modes, source, options, interrupt))
        .collect::<Result<Vec<_>, _>>()?;
    let (prepared, vectors): (Vec<Prepared>, _) = prepared.into_iter().unzip();
    let exchange = gathered(&modes, &prepared, vectors);
    Ok((modes, prepared, exchange))
}

fn prepare_surface(
    model: &SolidModel,
    recovery: &SurfaceStressRecovery<'_>,
    modes: &AxialModes,
    source: &SolidSurfaceSource,
    options: &SolidSplitOptions,
    interrupt: &Interrupt,
) -> Result<(Prepared, Vectors), StructureError> {
    let checkpoint = || interrupt.check().map_err(StructureError::Interrupted);
    checkpoint()?;
    let not_swept = |faces: &str| StructureError::NotSwept { faces: faces.into() };
    let set = faces(model, &source.faces)?;
    let (chart, swept) =
        set.chart.as_ref().zip(model.mesh.swept.as_ref()).ok_or_else(|| not_swept(&source.faces))?;
    let chain = EdgeChain { edges: chart.edges.clone(), measure: chart.measure };
    let across = SplitOptions {
        matching_depth: options.matching_depth,
        samples: options.samples,
        allows_modified_surfaces: false,
    };
    let samples = sample(&swept.section, &chain, source.edges, &across)
        .ok_or_else(|| StructureError::Coarse { chain: source.faces.clone() })?;
    let range = chain.range();
    let surface = source.surface.as_ref();
    if !surface.is_extruded() && !has_coordinates_of_mesh(surface, model, set, [range, modes.range()]) {
        return Err(StructureError::CoordinatesDiffer { faces: source.faces.clone() });
    }
    let smallest = samples.mollifiers.iter().map(|mollifier| mollifier.width).fold(f64::INFINITY, f64::min);

    let (metric, means) =
        half_space(model, set, surface, modes, smallest).ok_or_else(|| not_swept(&source.faces))?;

    let by_mollifier = samples
        .mollifiers
        .par_iter()
        .map(|mollifier| {
            checkpoint()?;
            let force = |s: f64, point: &FacePoint| point.normal.map(|part| -part * mollifier.value(s));
            let rectangle = [mollifier.support(), modes.range()];
            model
                .face_loads_between(set, rectangle, |s, _, point| force(s, point), |z| modes.values(z))
                .ok_or_else(|| not_swept(&source.faces))
        })
        .collect::<Result<Vec<_>, _>>()?;
    let loads: Vec<SparseVector> = (0..modes.count())
        .flat_map(|mode| by_mollifier.iter().map(move |loads| loads[mode].clone()))
        .collect();

    let mut known = SurfaceTables {
        surface: source.surface.clone(),
        stretched: BSpline::new(samples.s.iter().map(|&s| samples.stretch.at(s)).collect()),
        spline: BSpline::new(samples.s),
        stretch: samples.stretch,
        range,
        turned: Vec::new(),
        stress_points: Vec::new(),
        metric,
    };
    known.turned = normal_angle_coefficients(&known);
    let (mut rows, mut room) = (Vec::new(), MemoryReservation::default());
    if let Some(name) = &source.stress_faces {
        let free = faces(model, name)?;
        let of_section = &free.chart.as_ref().ok_or_else(|| not_swept(name))?.edges;
        let [per_edge, per_layer] = source.stress_points.map(|places| places.max(1));
        let s = of_section.iter().flat_map(|edge| {
            let step = (edge.s[1] - edge.s[0]) / per_edge as f64;
            (0..per_edge).map(move |place| edge.s[0] + step * (place as f64 + 0.5))
        });
        let mut z = vec![swept.stations[0]];
        for layer in swept.stations.windows(2) {
            let step = (layer[1] - layer[0]) / per_layer as f64;
            z.extend((1..=per_layer).map(|place| layer[0] + step * place as f64));
        }
        let places: Vec<[f64; 2]> = s.flat_map(|s| z.iter().map(move |&z| [s, z])).collect();
        let wanted = places.len() as u64 * recovery.memory_per_point();
        room = interrupt.reserve_memory(wanted).map_err(StructureError::Interrupted)?;
        let found = places
            .par_iter()
            .map(|&[s, z]| checkpoint().map(|()| recovery.rows(free, s, z)))
            .collect::<Result<Vec<_>, _>>()?;
        for (place, of_place) in places.into_iter().zip(found) {
            let Some(of_place) = of_place else { continue };
            known.stress_points.push((place, of_place.point.position));
            rows.extend(of_place.rows);
        }
        room.shrink_to(rows.iter().map(SparseVector::memory).sum());
    }
    let (mollifiers, counts) = (samples.mollifiers, [loads.len(), rows.len()]);
    let prepared = Prepared { known, mollifiers, means, loads: counts[0], stress_rows: counts[1] };
    Ok((prepared, Vectors { loads, rows, room }))
}

/// Returns whether a surface and a set of faces have the same points at the same coordinates, to
/// within the error of a coarse mesh.
fn has_coordinates_of_mesh(
    surface: &dyn Surface,
    model: &SolidModel,
    set: &FaceSet,
    [u, v]: [[f64; 2]; 2],
) -> bool {
    let at = |[from, to]: [f64; 2], share: f64| from + share * (to - from);
    let apart = |a: Vector, b: Vector| length(minus(a, b));
    let size = apart(surface.at(u[0], at(v, 0.5)).position, surface.at(u[1], at(v, 0.5)).position);
    let same = |u: f64, v: f64| {
        let point = model.mesh.surface_point(set, u, v);
        point.is_some_and(|point| apart(point.position, surface.at(u, v).position) < COORDINATES * size)
    };
    [0.0, 0.5, 1.0].into_iter().all(|i| [0.0, 0.5, 1.0].into_iter().all(|j| same(at(u, i), at(v, j))))
}

/// Prepares the half-space's responses, and the metric of a surface that is not extruded. `None` if
/// the faces have no chart, or the surface is no screw although it is declared as extruded.
fn half_space(
    model: &SolidModel,
    set: &FaceSet,
    surface: &dyn Surface,
    modes: &AxialModes,
    smallest: f64,
) -> Option<(Option<SurfaceMetric>, HalfSpaceMeans)> {
    let range = set.chart.as_ref()?.s_range();
    if surface.is_extruded() {
        let screw = Screw::of(surface, range)?;
        return Some((None, HalfSpaceMeans::Screw(ReciprocalMeans::new(screw, modes, [true; 2], smallest))));
    }
    let sides = SideFaces::of(&model.mesh, set, surface)?;
    let means = SurfaceMeans::new(surface, range, modes, Some(&sides), smallest);
    Some((Some(SurfaceMetric::new(surface, sides, modes)), HalfSpaceMeans::Surface(means)))
}

/// Returns spline coefficients of the angle by which the transverse normal has rotated since the
/// first sample, positive where convex.
fn normal_angle_coefficients(known: &SurfaceTables) -> Vec<f64> {
    let [_, [start, end]] = known.surface.range();
    let middle = 0.5 * (start + end);
    if !known.surface.is_extruded() {
        let angles = normal_angles(known.surface.as_ref(), known.spline.nodes(), middle);
        return coefficients(known, &angles);
    }
    let mut angles = Vec::with_capacity(known.places());
    let mut previous: Option<[f64; 2]> = None;
    let mut angle = 0.0;
    for &s in known.spline.nodes() {
        let point = known.surface.at(s, middle);
        let [x, y, _] = point.tangents[0];
        if let Some([px, py]) = previous {
            // With the material on the left of the tangent, a convex curve bends to the left.
            let left = y * point.normal[0] - x * point.normal[1];
            angle += left.signum() * (px * y - py * x).atan2(px * x + py * y);
        }
        previous = Some([x, y]);
        angles.push(angle);
    }
    coefficients(known, &angles)
}

fn coefficients(known: &SurfaceTables, values: &[f64]) -> Vec<f64> {
    let table = Mat::from_fn(values.len(), 1, |i, _| values[i]);
    known.spline.coefficients(table.as_ref()).col(0).iter().copied().collect()
}
