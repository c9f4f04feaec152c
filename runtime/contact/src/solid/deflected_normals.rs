//! Lines of action of slices under load: forces act at the centre of pressure, along the normal of
//! the deflected surface between both flanks there.
//!
//! With the elastic energy `U = p' C p / 2` of the forces `p` on a body, whose compliance `C`
//! depends on where the forces act, a motion of the body under fixed points of contact takes the
//! work `p' (dC) p / 2` from the forces. As `C` is symmetric, this is the work of tangential forces
//! `p` times the slope of the deflection `C p`, so the forces are derivatives of the energy if they
//! act normal to the deflected surface. Slopes also move the pressure across the patch, where the
//! flanks have other normals; this is of the same order. In contact both bodies share the deflected
//! surface. A mean of their slopes gives them opposite forces along one line.
//!
//! From the position where the grid is created, a body also rotates about its axis, by 1e-4 to
//! 1e-3 rad: it closes the gap, and the load deflects the teeth. Lines of action are those of the
//! rotated flanks, which touch at another position across the slice. The gap does not change
//! linearly with the angle: its rate changes on the way, and next to the centre of a patch the
//! slopes of both flanks differ, while the rate is that of their mean. Without the difference of
//! the change and its linear part, the load would be distributed along the patch as if the centre
//! of the patch had not moved.
//!
//! The deflections of the half-spaces at their own patch are left out: for equal materials they
//! move the surface between both flanks nowhere, and otherwise their slopes have no resultant,
//! because they depend on distances only.

use super::assembly::{PatchCells, Side, mirrors, softness};
use super::grid::{Cell, Slice};
use super::height_field::{FootPoint, HeightField};
use super::image::Images;
use super::placement::{BodyRotation, PlacedSurface, Pose};
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::vec3::{Vector, dot, minus, plus, scaled};
use calyx_structure::solid::SurfaceSegment;

/// Contact patch under load.
#[derive(Clone, Copy)]
pub struct LoadedPatch<'a> {
    /// Bodies, frame and cells at the creation of the grid.
    pub cells: PatchCells<'a>,
    /// Rotations of the bodies about their axes since the creation of the grid.
    pub rotations: [BodyRotation; 2],
    /// Slices of the grid.
    pub slices: &'a [Slice],
    /// Forces of the cells, N.
    pub forces: &'a [f64],
}

/// Line of action of a slice.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineOfAction {
    /// Point half-way between both flanks, m.
    pub point: Vector,
    /// Slopes along x and y of the deflected surface between both flanks, where their slopes across
    /// the slice are equal.
    pub slope: [f64; 2],
    /// Change of the gap by the rotation of the bodies, less its linear part for undeflected
    /// flanks, m.
    pub gap_correction: f64,
}

/// Half of the distance of two points whose difference is a slope, relative to the length of a
/// slice.
const STEP: f64 = 0.1;

/// Point near the centre of pressure of a slice.
struct Observer {
    segment: SurfaceSegment,
    /// x and y, m.
    at: [f64; 2],
}

/// Resultant of a slice: uniform pressure on a rectangle of the tangent plane.
#[derive(Clone, Copy)]
struct Load {
    center: [f64; 2],
    size: [f64; 2],
    force: f64,
}

/// Height fields of both flanks of a patch.
struct Flanks<'a> {
    /// At the creation of the grid.
    created: [HeightField<'a>; 2],
    /// After the rotation of the bodies.
    rotated: [HeightField<'a>; 2],
}

/// Loaded slice of a patch.
struct LoadedSlice {
    index: usize,
    load: Load,
    /// Points of both flanks at its centre of pressure, at the creation of the grid.
    created: [FootPoint; 2],
    /// Flanks after the rotation of the bodies; those of the creation of the grid if a flank ends
    /// before the position to which the rotation shifts the load.
    touching: Touching,
    /// Variation of the slopes across the slice.
    variation: SlopeVariation,
    /// Distance over which slopes are differences, m.
    step: f64,
}

/// Flanks of a slice where they touch.
struct Touching {
    feet: [FootPoint; 2],
    /// Mean slopes along x and y of both flanks.
    slopes: [[f64; 2]; 2],
    /// Change of the gap by the rotation of the bodies, m; `None` if it is unknown.
    gap_change: Option<f64>,
}

/// Computes the lines of action of the slices of each patch; `None` for slices without load.
///
/// # Errors
/// Those of the interrupt.
pub fn lines_of_action(
    patches: &[LoadedPatch],
    interrupt: &Interrupt,
) -> Result<Vec<Vec<Option<LineOfAction>>>, EngineError> {
    patches.iter().map(|patch| of_patch(patch, patches, interrupt)).collect()
}

fn of_patch(
    patch: &LoadedPatch,
    patches: &[LoadedPatch],
    interrupt: &Interrupt,
) -> Result<Vec<Option<LineOfAction>>, EngineError> {
    let Some(first) = patch.slices.first() else { return Ok(Vec::new()) };
    let surfaces = patch.cells.sides.map(|Side { structure, chart, .. }| structure.surface(chart.surface));
    let height_fields = |poses: [Pose; 2]| {
        [0, 1].map(|side: usize| {
            let placed = PlacedSurface { surface: surfaces[side].as_ref(), pose: poses[side] };
            HeightField::new(placed, *patch.cells.frame, first.places[side], true)
        })
    };
    let poses = patch.cells.sides.map(|side| side.pose);
    let rotated = [0, 1].map(|side: usize| patch.rotations[side].applied_to(&poses[side]));
    let flanks = Flanks { created: height_fields(poses), rotated: height_fields(rotated) };
    let slices = loaded_slices(patch, &flanks);
    let deflections = [
        deflection_slopes(patch, patches, &slices, 0, interrupt)?,
        deflection_slopes(patch, patches, &slices, 1, interrupt)?,
    ];
    let mut lines = vec![None; patch.slices.len()];
    let frame = patch.cells.frame;
    for (index, slice) in slices.iter().enumerate() {
        let Touching { feet, slopes, gap_change } = &slice.touching;
        let slope = slice.variation.common([0, 1].map(|side: usize| {
            [0, 1].map(|axis: usize| slopes[side][axis] + deflections[side][index][axis])
        }));
        let height = 0.5 * (feet[0].height + feet[1].height);
        let point = plus(frame.at(feet[0].at), scaled(frame.normal, height));
        let displacement = [0, 1].map(|side: usize| patch.rotations[side].displacement(point));
        let action = frame.action(slice.variation.common(*slopes));
        let linear = dot(action, minus(displacement[1], displacement[0]));
        let gap_correction = gap_change.map_or(0.0, |change| change - linear);
        lines[slice.index] = Some(LineOfAction { point, slope, gap_correction });
    }
    Ok(lines)
}

/// Computes the slopes along x and y by which the deflection of a side tilts it at the centres of
/// pressure.
fn deflection_slopes(
    patch: &LoadedPatch,
    patches: &[LoadedPatch],
    slices: &[LoadedSlice],
    side: usize,
    interrupt: &Interrupt,
) -> Result<Vec<[f64; 2]>, EngineError> {
    let observers: Vec<Observer> = slices.iter().flat_map(|slice| observers(patch, side, slice)).collect();
    let mut deflections = structural(patches, &patch.cells.sides[side], &observers, interrupt)?;
    add_images(patch, side, (slices, &observers), &mut deflections);
    // A load presses the first body against the normal of the frame and the second along it.
    let sign = if side == 0 { -1.0 } else { 1.0 };
    let slope = |(slice, ends): (&LoadedSlice, &[f64])| {
        [0, 2].map(|axis| sign * (ends[axis + 1] - ends[axis]) / (2.0 * slice.step))
    };
    Ok(slices.iter().zip(deflections.chunks_exact(4)).map(slope).collect())
}

/// How the slopes of both flanks vary along x near a centre of pressure.
#[derive(Clone, Copy, Debug)]
enum SlopeVariation {
    /// Changes of the slopes along x and y of both flanks per x, 1/m, over a distance of up to
    /// `reach` (m) on both sides.
    Linear { changes: [[f64; 2]; 2], reach: f64 },
    /// The flank of the other side ends there, so contact has the normal of this one.
    OneSided(usize),
    /// Both flanks end there.
    Unknown,
}

impl SlopeVariation {
    /// Measures the changes over the width of a load at its centre of pressure.
    fn measure(height_fields: &[HeightField; 2], load: &Load, feet: &[FootPoint; 2]) -> Self {
        let [x, y] = load.center;
        let reach = 0.5 * load.size[0];
        let change = |side: usize| {
            let at = |x: f64| height_fields[side].over([x, y], feet[side].place);
            let [before, after] = [at(x - reach)?, at(x + reach)?];
            Some([0, 1].map(|axis| (after.slope[axis] - before.slope[axis]) / (2.0 * reach)))
        };
        match (change(0), change(1)) {
            (Some(first), Some(second)) => Self::Linear { changes: [first, second], reach },
            // A flank that ends there is an edge.
            (None, Some(_)) => Self::OneSided(1),
            (Some(_), None) => Self::OneSided(0),
            _ => Self::Unknown,
        }
    }

    /// Returns the common slopes along x and y of two flanks with these slopes at the centre of
    /// pressure. The centre of pressure is accurate to a fraction of a cell. On a sharp edge this
    /// changes the slope by much more than the deflection does, so the slopes are taken at the
    /// nearest x where those along x are equal, as they are where flanks touch.
    fn common(&self, slopes: [[f64; 2]; 2]) -> [f64; 2] {
        let mean =
            |slopes: [[f64; 2]; 2]| [0, 1].map(|axis: usize| 0.5 * (slopes[0][axis] + slopes[1][axis]));
        let (changes, reach) = match *self {
            Self::OneSided(side) => return slopes[side],
            Self::Unknown => return mean(slopes),
            Self::Linear { changes, reach } => (changes, reach),
        };
        let Some(shift) = self.shift(slopes.map(|slope| slope[0])) else { return mean(slopes) };
        let shift = shift.clamp(-reach, reach);
        mean(
            [0, 1].map(|side: usize| {
                [0, 1].map(|axis: usize| slopes[side][axis] + shift * changes[side][axis])
            }),
        )
    }

    /// Returns the distance along x (m) to the position where both slopes along x, which have these
    /// values at the centre of pressure, are equal; `None` if it is unknown.
    fn shift(&self, slopes: [f64; 2]) -> Option<f64> {
        let Self::Linear { changes, .. } = *self else { return None };
        let curvature = changes[1][0] - changes[0][0];
        // A load without width has no curvature.
        (curvature > 0.0).then(|| (slopes[0] - slopes[1]) / curvature)
    }
}

/// Returns the loaded slices of a patch whose centre of pressure is on both surfaces.
fn loaded_slices(patch: &LoadedPatch, flanks: &Flanks) -> Vec<LoadedSlice> {
    let of_slice = |(index, slice): (usize, &Slice)| {
        let load = load_of(patch, slice)?;
        let created = feet_over(&flanks.created, load.center, slice)?;
        let variation = SlopeVariation::measure(&flanks.created, &load, &created);
        let touching =
            after_rotation(patch, slice, flanks, (&load, &created, &variation)).unwrap_or_else(|| {
                let slopes = mean_slopes(patch, slice, (&flanks.created, 0.0));
                let slopes = slopes.unwrap_or(created.map(|foot| foot.slope));
                Touching { feet: created, slopes, gap_change: None }
            });
        let step = STEP * (slice.y[1] - slice.y[0]);
        Some(LoadedSlice { index, load, created, touching, variation, step })
    };
    patch.slices.iter().enumerate().filter_map(of_slice).collect()
}

/// Returns the points of both flanks over x, y of a slice; `None` if one ends before.
fn feet_over(height_fields: &[HeightField; 2], at: [f64; 2], slice: &Slice) -> Option<[FootPoint; 2]> {
    let foot = |side: usize| height_fields[side].over(at, slice.places[side]);
    Some([foot(0)?, foot(1)?])
}

/// Returns the flanks of a slice where they touch after the rotation of the bodies; `None` if one
/// ends before.
fn after_rotation(
    patch: &LoadedPatch,
    slice: &Slice,
    flanks: &Flanks,
    (load, created, variation): (&Load, &[FootPoint; 2], &SlopeVariation),
) -> Option<Touching> {
    let [x, y] = load.center;
    let (of_edge, share) = edge_shift(patch, slice, flanks).unwrap_or((0.0, 0.0));
    let mut shift = share * of_edge;
    if share < 1.0 {
        let rotated = feet_over(&flanks.rotated, load.center, slice)?;
        let tilts = [0, 1].map(|side: usize| rotated[side].slope[0] - created[side].slope[0]);
        shift += (1.0 - share) * variation.shift(tilts).unwrap_or(0.0);
    }
    let feet = feet_over(&flanks.rotated, [x + shift, y], slice)?;
    let slopes = mean_slopes(patch, slice, (&flanks.rotated, shift));
    let gap = |feet: &[FootPoint; 2]| feet[1].height - feet[0].height;
    Some(Touching {
        feet,
        slopes: slopes.unwrap_or(feet.map(|foot| foot.slope)),
        gap_change: Some(gap(&feet) - gap(created)),
    })
}

/// Returns the distance along x (m) by which the rotation of the bodies shifts the rounded edges
/// that carry load of a slice, as a mean by force, and their share of the load; `None` if flanks
/// carry all of it.
fn edge_shift(patch: &LoadedPatch, slice: &Slice, flanks: &Flanks) -> Option<(f64, f64)> {
    let (mut moment, mut on_edges, mut total) = (0.0, 0.0, 0.0);
    for (cell, force) in loaded_cells(patch, slice)? {
        total += force;
        let sides = flanks.created.iter().zip(&flanks.rotated).zip(cell.places);
        // A grid follows edges along y only.
        let edge = sides
            .into_iter()
            .find(|((created, _), place)| created.placed.on_edge(*place) && created.roles[0] == 0);
        if let Some(((created, rotated), place)) = edge {
            let (before, after) = (created.foot(place), rotated.foot(place));
            // The edge may cross the slice obliquely.
            let along = after.x_by_y_along_edge() * (after.at[1] - before.at[1]);
            moment += force * (after.at[0] - before.at[0] - along);
            on_edges += force;
        }
    }
    (on_edges > 0.0).then(|| (moment / on_edges, on_edges / total))
}

/// Returns the cells of a slice that carry load, and their forces, N.
fn loaded_cells<'a>(patch: &LoadedPatch<'a>, slice: &Slice) -> Option<Vec<(&'a Cell, f64)>> {
    let cells = patch.cells.cells.get(slice.cells.clone())?;
    let forces = patch.forces.get(slice.cells.clone())?;
    Some(cells.iter().zip(forces.iter().copied()).filter(|(_, force)| *force > 0.0).collect())
}

/// Returns the slopes along x and y of both flanks with these height fields, weighted by the forces
/// of the cells of a slice whose load is partly on an edge and shifted along x (m); `None` for
/// others, where the slopes at the centre of pressure are the same.
fn mean_slopes(
    patch: &LoadedPatch,
    slice: &Slice,
    (height_fields, shift): (&[HeightField; 2], f64),
) -> Option<[[f64; 2]; 2]> {
    let loaded = loaded_cells(patch, slice)?;
    if !loaded.iter().any(|(cell, _)| cell.edge) {
        return None;
    }
    let total: f64 = loaded.iter().map(|(_, force)| force).sum();
    let mut slopes = [[0.0; 2]; 2];
    for (cell, force) in loaded {
        for (side, slopes) in slopes.iter_mut().enumerate() {
            let (height_field, [x, y], place) = (&height_fields[side], cell.center, cell.places[side]);
            let foot = height_field.over([x + shift, y], place).unwrap_or_else(|| height_field.foot(place));
            (0..2).for_each(|axis| slopes[axis] += force / total * foot.slope[axis]);
        }
    }
    Some(slopes)
}

/// Returns four points on the surface of a side: at a step before and after the centre of pressure
/// across the slice, then along it. Near a rounded edge they are moved to the flank before it,
/// since the edge's own normals are not those of the force.
fn observers(patch: &LoadedPatch, side: usize, slice: &LoadedSlice) -> [Observer; 4] {
    let foot = &slice.created[side];
    let Side { structure, chart, .. } = &patch.cells.sides[side];
    let last = structure.surface(chart.surface).edge_from().unwrap_or(f64::INFINITY);
    let reach = slice.step * (0..2).map(|axis| foot.place_by(axis)[0].abs()).fold(0.0, f64::max);
    let beyond = (foot.place[0] + reach - last).max(0.0);
    let first = patch.slices[slice.index].cells.start;
    let length = patch.cells.cells.get(first).map_or(0.0, |cell| cell.spans[side]);
    [(0, -slice.step), (0, slice.step), (1, -slice.step), (1, slice.step)].map(|(axis, step)| {
        let (mut at, change) = (foot.at, foot.place_by(axis));
        at[axis] += step;
        let place = [foot.place[0] - beyond + step * change[0], foot.place[1] + step * change[1]];
        Observer { segment: SurfaceSegment { place, length }, at }
    })
}

/// Computes the inward deflections of a body by its structure under the forces of all patches, m.
fn structural(
    patches: &[LoadedPatch],
    observed: &Side,
    observers: &[Observer],
    interrupt: &Interrupt,
) -> Result<Vec<f64>, EngineError> {
    let segments: Vec<SurfaceSegment> = observers.iter().map(|observer| observer.segment).collect();
    let mut deflections = vec![0.0; observers.len()];
    for patch in patches {
        for (number, side) in
            patch.cells.sides.iter().enumerate().filter(|(_, side)| side.body == observed.body)
        {
            let loaded = || patch.cells.cells.iter().zip(patch.forces).filter(|(_, force)| **force != 0.0);
            let loads: Vec<SurfaceSegment> = loaded().map(|(cell, _)| cell.segment(number)).collect();
            let mut block = vec![0.0; observers.len() * loads.len()];
            let chart = observed.chart;
            observed
                .structure
                .add_compliance_until(chart, &segments, side.chart, &loads, &mut block, interrupt)?;
            for (deflection, row) in deflections.iter_mut().zip(block.chunks_exact(loads.len().max(1))) {
                *deflection +=
                    row.iter().zip(loaded()).map(|(compliance, (_, force))| compliance * force).sum::<f64>();
            }
        }
    }
    Ok(deflections)
}

/// Adds the deflections of a side by the images of its half-space in side faces. Distant from a
/// side face, the images of the cells of a slice act like one of uniform pressure.
fn add_images(
    patch: &LoadedPatch,
    side: usize,
    (slices, observers): (&[LoadedSlice], &[Observer]),
    deflections: &mut [f64],
) {
    if softness(&patch.cells.sides[side]) == 0.0 {
        return;
    }
    for mirror in mirrors(&patch.cells, side) {
        let images = Images::new(mirror, patch.cells.frame);
        for (deflection, observer) in deflections.iter_mut().zip(observers) {
            let by = |slice: &LoadedSlice| {
                let Load { center, size, force } = slice.load;
                force * images.influence_at(observer.at, center, size)
            };
            *deflection += slices.iter().map(by).sum::<f64>();
        }
    }
}

/// Returns the resultant of a slice, over its loaded cells; `None` without load.
fn load_of(patch: &LoadedPatch, slice: &Slice) -> Option<Load> {
    let loaded = loaded_cells(patch, slice)?;
    let force: f64 = loaded.iter().map(|(_, force)| force).sum();
    let ends = |axis: usize| {
        let each = loaded.iter().map(|(cell, _)| cell.ends(axis));
        each.reduce(|[low, high], [from, to]| [low.min(from), high.max(to)])
    };
    let mean = |axis: usize| loaded.iter().map(|(cell, part)| part / force * cell.center[axis]).sum::<f64>();
    let size = [ends(0)?, ends(1)?].map(|[low, high]| high - low);
    Some(Load { center: [mean(0), mean(1)], size, force })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Slopes of two flanks `offset` (m) before the place where they touch with the slopes `at`,
    /// and their common slopes.
    fn common(changes: [[f64; 2]; 2], at: [f64; 2], offset: f64) -> [f64; 2] {
        let slopes =
            [0, 1].map(|side: usize| [0, 1].map(|axis: usize| at[axis] - offset * changes[side][axis]));
        SlopeVariation::Linear { changes, reach: 1e-4 }.common(slopes)
    }

    /// Convex flanks, a convex and a concave one, and a rounded edge that crosses the slice
    /// obliquely.
    const CHANGES: [[[f64; 2]; 2]; 3] =
        [[[-20.0, 0.0], [30.0, 1.0]], [[20.0, 3.0], [50.0, 0.0]], [[-9000.0, 4000.0], [30.0, 0.0]]];

    #[test]
    fn the_common_slope_is_that_where_flanks_touch() {
        let at = [2e-3, -1e-3];
        for changes in CHANGES {
            for offset in [-5e-5, 0.0, 5e-5] {
                let found = common(changes, at, offset);
                assert!((0..2).all(|axis| (found[axis] - at[axis]).abs() < 1e-12), "{changes:?}: {found:?}");
            }
        }
    }

    #[test]
    fn slopes_are_not_taken_beyond_the_load() {
        let slopes = [[1e-2, 0.0], [0.0, 2e-3]];
        let variation = SlopeVariation::Linear { changes: [[-20.0, 0.0], [30.0, 0.0]], reach: 1e-4 };
        // At 1e-4 the slopes along x are 8e-3 and 3e-3.
        let [x, y] = variation.common(slopes);
        assert!((x - 5.5e-3).abs() < 1e-12 && (y - 1e-3).abs() < 1e-12, "{x} {y}");
    }

    #[test]
    fn an_end_of_a_flank_has_the_slope_of_the_other_flank() {
        let slopes = [[1e-2, 1e-3], [0.0, 2e-3]];
        assert_eq!(SlopeVariation::OneSided(1).common(slopes), slopes[1]);
        let without_width = SlopeVariation::Linear { changes: [[f64::NAN; 2]; 2], reach: 0.0 };
        for variation in [SlopeVariation::Unknown, without_width] {
            assert_eq!(variation.common(slopes), [5e-3, 1.5e-3]);
        }
    }
}
