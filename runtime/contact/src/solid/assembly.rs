//! Compliance matrix of the cells of all patches: half-spaces with image loads where load and
//! observer share a surface, structures where they share a body.
//!
//! Every entry is the same expression with its two cells exchanged, so the matrix is symmetric bit
//! for bit without averaging.

use super::grid::Cell;
use super::half_space::HalfSpace;
use super::image::{Images, PlacedMirror};
use super::interval_pairs::{Intervals, RelationCache};
use super::placement::{PatchFrame, Pose};
use super::strips::{Common, add_influence};
use crate::assembly::{Entries, between, is_symmetric, symmetric_of_blocks};
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use calyx_structure::Chart;
use calyx_structure::solid::SolidStructure;
use std::f64::consts::PI;

/// Body in a patch.
#[derive(Clone, Copy)]
pub struct Side<'a> {
    /// Index of the body. Several bodies may share a structure (equal planets) without coupling of
    /// their displacements.
    pub body: usize,
    /// Structure of the body.
    pub structure: &'a dyn SolidStructure,
    /// Surface of the body.
    pub chart: Chart,
    /// Pose of the tooth: of the coordinates of [`SolidStructure::surface`].
    pub pose: Pose,
}

/// Contact patch: its two different bodies, in the order of its grid's sides, and its cells.
#[derive(Clone, Copy)]
pub struct PatchCells<'a> {
    /// First and second body.
    pub sides: [Side<'a>; 2],
    /// Frame of the grid.
    pub frame: &'a PatchFrame,
    /// Cells of the grid.
    pub cells: &'a [Cell],
    /// Surface coordinates next to the side faces, see [`super::Grid::beside_faces`].
    pub beside_faces: [[f64; 2]; 2],
}

/// Computes A, row-major, with the cells in the order of the patches: growth of a cell's average
/// gap per force on a cell, m/N. Each block has checkpoints.
///
/// # Errors
/// Those of the interrupt.
pub fn compliance(
    patches: &[PatchCells],
    entries: Entries,
    interrupt: &Interrupt,
) -> Result<Vec<f64>, EngineError> {
    let former = match entries {
        Entries::All => None,
        Entries::Changed(former) => Some(former),
        Entries::Between(wanted) => {
            let cells: Vec<&[Cell]> = patches.iter().map(|patch| patch.cells).collect();
            return between(&cells, wanted, |kept| {
                let reduced = patches.iter().zip(kept).map(|(patch, cells)| PatchCells { cells, ..*patch });
                compliance(&reduced.collect::<Vec<_>>(), Entries::All, interrupt)
            });
        }
    };
    let sizes: Vec<usize> = patches.iter().map(|patch| patch.cells.len()).collect();
    symmetric_of_blocks(&sizes, former, interrupt, |p, q| {
        let mut block = structural(&patches[p], &patches[q], interrupt)?;
        debug_assert!(p != q || is_symmetric(&block, sizes[q]), "a structure's compliance is not symmetric");
        if p == q {
            add_half_spaces(&patches[p], &mut block, interrupt)?;
        }
        Ok(block)
    })
}

/// Computes the influence coefficients between the cells of two patches, or of one, by the
/// structures of the bodies they share.
fn structural(
    observing: &PatchCells,
    loaded: &PatchCells,
    interrupt: &Interrupt,
) -> Result<Vec<f64>, EngineError> {
    let mut block = vec![0.0; observing.cells.len() * loaded.cells.len()];
    for (a, observer) in observing.sides.iter().enumerate() {
        for (b, load) in loaded.sides.iter().enumerate() {
            if observer.body != load.body {
                continue;
            }
            let segments = |patch: &PatchCells, side: usize| {
                patch.cells.iter().map(|c| c.segment(side)).collect::<Vec<_>>()
            };
            observer.structure.add_compliance_until(
                observer.chart,
                &segments(observing, a),
                load.chart,
                &segments(loaded, b),
                &mut block,
                interrupt,
            )?;
        }
    }
    Ok(block)
}

/// Returns the displacement of the half-space of a side per unit force over distance, 1/Pa.
pub(super) fn softness(side: &Side) -> f64 {
    let modulus = side.structure.surface_modulus();
    if modulus.is_infinite() { 0.0 } else { (PI * modulus).recip() }
}

/// Returns the mirrors of a side of a patch.
pub(super) fn mirrors(patch: &PatchCells, side: usize) -> Vec<PlacedMirror> {
    let ends = patch.beside_faces[side];
    let side = &patch.sides[side];
    let faces = side.structure.side_faces(side.chart.surface, ends);
    faces.iter().map(|face| PlacedMirror::new(face, &side.pose, softness(side))).collect()
}

/// Adds the half-spaces of both bodies, with their image loads, to the diagonal block of a patch.
fn add_half_spaces(patch: &PatchCells, block: &mut [f64], interrupt: &Interrupt) -> Result<(), EngineError> {
    let n = patch.cells.len();
    let direct: f64 = patch.sides.iter().map(softness).sum();
    if direct == 0.0 {
        return Ok(());
    }
    let mut all: Vec<PlacedMirror> = Vec::new();
    for mirror in [0, 1].iter().flat_map(|&side| mirrors(patch, side)).filter(|mirror| mirror.softness > 0.0)
    {
        match all.iter_mut().find(|known| known.is_same(&mirror, patch.frame.point)) {
            Some(known) => known.softness += mirror.softness,
            None => all.push(mirror),
        }
    }
    let half_space = HalfSpace { softness: direct };
    // The half-space term depends on the difference of two cells' positions. The image term of an
    // upright mirror depends on the difference across and the sum of both positions along the
    // patch, that of a level mirror on the difference across and both positions along.
    let cells = patch.cells;
    let [across, along] = [0, 1].map(|axis| Intervals::of(cells, axis));
    let apart = |one: f64, other: f64| (one - other).abs();
    let mut known = RelationCache::new([across.pairs(apart), along.pairs(apart)], n);
    let given = |i: usize, j: usize, close: &Common<HalfSpace>| {
        known.get(i, j, || half_space.influence(&cells[i], &cells[j], close.get()))
    };
    add_influence(cells, &half_space, given, block, interrupt)?;
    for mirror in all {
        let images = Images::new(mirror, patch.frame);
        let relations = || match images.is_upright() {
            true => along.pairs(|one, other| one + other),
            false => along.each_pair(),
        };
        let alike = images.is_upright() || images.is_level;
        let mut known = alike.then(|| RelationCache::new([across.pairs(apart), relations()], n));
        let find = |i: usize, j: usize| images.influence(&cells[i], &cells[j]);
        let pair = |i: usize, j: usize, _: &Common<Images>| match &mut known {
            Some(known) => known.get(i, j, || find(i, j)),
            None => find(i, j),
        };
        add_influence(cells, &images, pair, block, interrupt)?;
    }
    Ok(())
}
