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
//! The deflections of the half-spaces at their own patch are left out: for equal materials they
//! move the surface between both flanks nowhere, and otherwise their slopes have no resultant,
//! because they depend on distances only.

use super::assembly::{PatchCells, Side, mirrors, softness};
use super::grid::Slice;
use super::height_field::{FootPoint, HeightField};
use super::image::Images;
use super::placement::PlacedSurface;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::vec3::{Vector, plus, scaled};
use calyx_structure::solid::SurfaceSegment;

/// Contact patch under load.
#[derive(Clone, Copy)]
pub struct LoadedPatch<'a> {
    /// Bodies, frame and cells.
    pub cells: PatchCells<'a>,
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
    /// Slopes along x and y of the deflected surface between both flanks, a weighted mean.
    pub slope: [f64; 2],
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

/// Loaded slice of a patch, with the points of both flanks at its centre of pressure.
struct LoadedSlice {
    index: usize,
    load: Load,
    feet: [FootPoint; 2],
    /// Shares of both flanks in the common slopes along x and y.
    shares: [[f64; 2]; 2],
    /// Distance over which slopes are differences, m.
    step: f64,
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
    let height_fields = [0, 1].map(|side: usize| {
        let placed = PlacedSurface { surface: surfaces[side].as_ref(), pose: patch.cells.sides[side].pose };
        HeightField::new(placed, *patch.cells.frame, first.places[side], true)
    });
    let slices = loaded_slices(patch, &height_fields);
    let deflections = [
        deflection_slopes(patch, patches, &slices, 0, interrupt)?,
        deflection_slopes(patch, patches, &slices, 1, interrupt)?,
    ];
    let mut lines = vec![None; patch.slices.len()];
    let frame = patch.cells.frame;
    for (index, slice) in slices.iter().enumerate() {
        let feet = &slice.feet;
        let slope = [0, 1].map(|axis| {
            let of = |side: usize| {
                slice.shares[axis][side] * (feet[side].slope[axis] + deflections[side][index][axis])
            };
            of(0) + of(1)
        });
        let height = 0.5 * (feet[0].height + feet[1].height);
        let point = plus(frame.at(slice.load.center), scaled(frame.normal, height));
        lines[slice.index] = Some(LineOfAction { point, slope });
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

/// Returns the shares of both flanks in their common slope across the patch. An error of the centre
/// of pressure changes the slope of a flank in proportion to its curvature, so each counts with the
/// curvature of the other: the direction of a force on a sharp edge is that of the flank that it
/// touches.
fn shares_across(height_fields: &[HeightField; 2], load: &Load, feet: &[FootPoint; 2]) -> [f64; 2] {
    let [x, y] = load.center;
    let half = 0.5 * load.size[0];
    let change = |side: usize| {
        let at = |x: f64| height_fields[side].over([x, y], feet[side].place);
        Some((at(x + half)?.slope[0] - at(x - half)?.slope[0]).abs())
    };
    match (change(0), change(1)) {
        (Some(first), Some(second)) if first + second > 0.0 => {
            [second / (first + second), first / (first + second)]
        }
        // A flank that ends there is an edge.
        (None, Some(_)) => [0.0, 1.0],
        (Some(_), None) => [1.0, 0.0],
        _ => [0.5; 2],
    }
}

/// Returns the loaded slices of a patch whose centre of pressure is on both surfaces.
fn loaded_slices(patch: &LoadedPatch, height_fields: &[HeightField; 2]) -> Vec<LoadedSlice> {
    let of_slice = |(index, slice): (usize, &Slice)| {
        let load = load_of(patch, slice)?;
        let foot = |side: usize| height_fields[side].over(load.center, slice.places[side]);
        let feet = [foot(0)?, foot(1)?];
        let shares = [shares_across(height_fields, &load, &feet), [0.5; 2]];
        Some(LoadedSlice { index, load, feet, shares, step: STEP * (slice.y[1] - slice.y[0]) })
    };
    patch.slices.iter().enumerate().filter_map(of_slice).collect()
}

/// Returns four points on the surface of a side: at a step before and behind the centre of pressure
/// across the slice, then along it.
fn observers(patch: &LoadedPatch, side: usize, slice: &LoadedSlice) -> [Observer; 4] {
    let foot = &slice.feet[side];
    let first = patch.slices[slice.index].cells.start;
    let length = patch.cells.cells.get(first).map_or(0.0, |cell| cell.spans[side]);
    [(0, -slice.step), (0, slice.step), (1, -slice.step), (1, slice.step)].map(|(axis, step)| {
        let (mut at, change) = (foot.at, foot.place_by(axis));
        at[axis] += step;
        let place = [0, 1].map(|k| foot.place[k] + step * change[k]);
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
    let cells = patch.cells.cells.get(slice.cells.clone())?;
    let forces = patch.forces.get(slice.cells.clone())?;
    let loaded = || cells.iter().zip(forces).filter(|(_, force)| **force > 0.0);
    let force: f64 = loaded().map(|(_, force)| force).sum();
    let ends = |axis: usize| {
        let each = loaded().map(|(cell, _)| cell.ends(axis));
        each.reduce(|[low, high], [from, to]| [low.min(from), high.max(to)])
    };
    let mean = |axis: usize| loaded().map(|(cell, part)| part / force * cell.center[axis]).sum::<f64>();
    let size = [ends(0)?, ends(1)?].map(|[low, high]| high - low);
    Some(Load { center: [mean(0), mean(1)], size, force })
}
