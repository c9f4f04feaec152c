//! All modes of a ring of sectors up to a frequency: first counted, then found, separately for each
//! number of nodal diameters.

use super::super::StructureError;
use super::harmonic::{Harmonic, HarmonicModes};
use super::sector::{Sector, Shifted};
use calyx_numerics::interrupt::Interrupt;
use rayon::prelude::*;

/// Shift of the iteration: below zero by this share of the highest frequency squared. A free ring
/// has modes at zero.
const BELOW: f64 = 0.05;
/// Relative increments of the highest frequency for the mode count, if the count fails there. The
/// frequency must not be a natural frequency of the sector with fixed cuts.
const NUDGES: [f64; 4] = [0.0, 1e-4, 1.1e-3, 1.3e-2];

/// Finds the modes of a ring with `omega² <= highest²`, by nodal diameters from 0 to half the
/// number of sectors; nodal diameters without modes are omitted. The modes of a free ring include
/// its rigid-body motions.
///
/// # Errors
/// Some modes cannot be found, or the computation is interrupted.
pub(in super::super) fn ring_modes(
    sector: &Sector,
    highest: f64,
    interrupt: &Interrupt,
) -> Result<Vec<HarmonicModes>, StructureError> {
    let massless = sector.mass.val().iter().all(|&value| value == 0.0);
    if highest.is_nan() || highest <= 0.0 || massless {
        return Ok(Vec::new());
    }
    let square = highest * highest;
    if !square.is_finite() {
        return Err(StructureError::Modes("there are infinitely many up to an infinite frequency"));
    }
    let nodal_diameters = || (0..=sector.count / 2).into_par_iter();
    let mut counts = None;
    for nudge in NUDGES {
        let Some(top) = Shifted::new(sector, square * (1.0 + nudge), interrupt)? else { continue };
        let count = |nodal_diameters| {
            interrupt.check().map_err(StructureError::Interrupted)?;
            Ok::<_, StructureError>(Harmonic::new(&top, nodal_diameters)?.below())
        };
        let found: Result<Vec<Option<usize>>, StructureError> = nodal_diameters().map(count).collect();
        counts = found?.into_iter().collect::<Option<Vec<usize>>>();
        if counts.is_some() {
            break;
        }
    }
    let counts = counts.ok_or(StructureError::Modes("they cannot be counted"))?;
    let Some(shifted) = Shifted::new(sector, -BELOW * square, interrupt)? else {
        return Err(StructureError::Modes("the equations of a sector cannot be decomposed"));
    };
    if shifted.negative > 0 {
        return Err(StructureError::Modes("a sector has a stiffness or a mass that is not positive"));
    }
    let columns: usize =
        counts.iter().filter(|&&count| count > 0).map(|&count| Harmonic::columns(count)).sum();
    let bytes = columns * 2 * sector.dofs() * size_of::<f64>();
    let _room = interrupt.reserve_memory(bytes as u64).map_err(StructureError::Interrupted)?;
    let modes = |nodal_diameters: u32| {
        let count = counts.get(nodal_diameters as usize).copied().unwrap_or(0);
        if count == 0 {
            return Ok(None);
        }
        let mut modes = Harmonic::new(&shifted, nodal_diameters)?.lowest(count, interrupt)?;
        let within = modes.squares.iter().filter(|&&omega| omega <= square).count();
        modes.keep(within);
        Ok((within > 0).then_some(modes))
    };
    let found: Result<Vec<Option<HarmonicModes>>, StructureError> = nodal_diameters().map(modes).collect();
    Ok(found?.into_iter().flatten().collect())
}
