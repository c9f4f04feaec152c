//! Equilibria over a whole mesh cycle, for observables that are defined over the cycle.
//!
//! Load factors compare loads at different times of a mesh cycle, but an observable is evaluated at
//! one position. It therefore solves positions of its own, spread uniformly over the cycle in which
//! its position lies. Their number depends on the mesh only, so the value does not depend on the
//! positions of the analysis, and a perturbed solve has a value that can be compared.

use super::Equilibrium;
use super::equilibrium::AxialLoad;
use calyx_model::ids::{BodyId, PairId};
use calyx_model::pairs::GearMesh;
use calyx_solve::step::StepResult;
use calyx_solve::system::System;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, OnceLock};

/// Smallest and largest number of positions over a cycle.
const POSITIONS: [usize; 2] = [8, 24];
/// Number of positions of helical teeth, multiplied by the overlap ratio, at which the windows of
/// [`window`] are narrow enough.
const POSITIONS_OF_OVERLAP: f64 = 6.0;
/// Width of a window of the face relative to the face, as far as the positions permit.
const NARROW: f64 = 1.0 / 16.0;
/// Widest window of the face, relative to the face.
const WIDE: f64 = 1.0 / POSITIONS_OF_OVERLAP;
/// Distance of positions from the end of a cycle, in cycles, that counts as rounding.
const ROUNDING: f64 = 1e-9;

/// Static equilibrium at a position of a mesh cycle.
#[derive(Clone, Debug)]
pub(super) struct CyclePosition {
    /// Normal force of the mesh, N.
    pub force: f64,
    /// Largest normal force on a tooth pair, N.
    pub largest_pair_force: f64,
    /// Forces along the face.
    pub loads: Vec<AxialLoad>,
}

impl CyclePosition {
    pub(super) fn of(at: &Equilibrium<'_>, pair: PairId) -> CyclePosition {
        let mut pairs: Vec<([u32; 2], f64)> = Vec::new();
        for contact in at.contacts(pair) {
            match pairs.iter_mut().find(|(teeth, _)| *teeth == contact.teeth()) {
                Some((_, force)) => *force += contact.force(),
                None => pairs.push((contact.teeth(), contact.force())),
            }
        }
        CyclePosition {
            force: pairs.iter().map(|(_, force)| force).sum(),
            largest_pair_force: pairs.iter().map(|(_, force)| *force).fold(0.0, f64::max),
            loads: at.contacts(pair).flat_map(|contact| contact.axial_loads()).collect(),
        }
    }
}

/// Positions of a cycle, solved on request and shared by all observables of a system.
struct Solutions {
    /// Number of the next position that nobody solves yet.
    next: AtomicUsize,
    /// `None` for a position without static equilibrium.
    positions: Vec<OnceLock<Option<CyclePosition>>>,
}

/// Returns the static equilibria of the mesh cycle in which a position lies; `None` if the bodies
/// have no static equilibrium at one of them, as free bodies that only their inertia holds.
pub(super) fn static_cycle(at: &Equilibrium<'_>, pair: PairId) -> Option<Vec<CyclePosition>> {
    let (mesh, _) = at.mesh(pair)?;
    let system = at.system;
    let passed = (at.time() - mesh.start) / mesh.period;
    if !passed.is_finite() {
        return None;
    }
    let cycle = (passed + ROUNDING).floor();
    let count = positions_of_cycle(mesh);
    let create =
        || Solutions { next: AtomicUsize::new(0), positions: (0..count).map(|_| OnceLock::new()).collect() };
    let solutions: Arc<Solutions> = system.derived.get_or_create((pair.0, cycle as i64), create)?;
    // Uniform positions off the ends of the cycle, where the load on rigid teeth jumps.
    let time = |index: usize| mesh.start + (cycle + (index as f64 + 0.5) / count as f64) * mesh.period;
    let solve = |index: usize| {
        let step: StepResult = system.solve(time(index)).ok()?;
        Some(CyclePosition::of(&Equilibrium::new(system as &System<'_>, &step), pair))
    };
    // Threads that arrive together divide the positions among them. None waits for another one:
    // what it would wait for may be below it on its own stack.
    loop {
        let index = solutions.next.fetch_add(1, Ordering::Relaxed);
        let Some(position) = solutions.positions.get(index) else { break };
        let _ = position.set(solve(index));
    }
    let solved = |(index, position): (usize, &OnceLock<Option<CyclePosition>>)| match position.get() {
        Some(found) => found.clone(),
        None => solve(index),
    };
    solutions.positions.iter().enumerate().map(solved).collect()
}

/// Returns the number of positions over the cycle of a mesh that load factors solve.
pub fn positions_of_cycle(mesh: &GearMesh) -> usize {
    let [fewest, most] = POSITIONS;
    match mesh.overlap_ratio > 0.0 {
        true => ((POSITIONS_OF_OVERLAP / mesh.overlap_ratio).ceil() as usize).clamp(fewest, most),
        false => fewest,
    }
}

/// Returns the width over which the load along a face of some width (m) is averaged, m.
///
/// The contact lines of helical teeth cross a section of the face at all phases of the cycle, and
/// the positions are a sample of these phases. A window of a whole number of axial pitches divided
/// by the number of positions contains each phase equally often, so the ends of the path of contact
/// leave no pattern on the face.
pub(super) fn window(mesh: &GearMesh, face: f64) -> f64 {
    if mesh.overlap_ratio <= 0.0 {
        return NARROW * face;
    }
    let spacing = face / (mesh.overlap_ratio * positions_of_cycle(mesh) as f64);
    let wide = (NARROW * face / spacing - ROUNDING).ceil().max(1.0) * spacing;
    if wide <= (WIDE + ROUNDING) * face { wide } else { NARROW * face }
}

/// Returns the ends of the common face of a mesh along the axis of its first body, m from the
/// middle of that body's face.
pub(super) fn common_face(at: &Equilibrium<'_>, bodies: [BodyId; 2]) -> [f64; 2] {
    let system = at.system;
    let half = bodies.map(|body| 0.5 * system.scene.bodies[body.0].prototype.face_width());
    let axis = system.axes(bodies[0].0, at.time())[2];
    let [first, second] = bodies.map(|body| system.origin(body.0, at.time()));
    let apart: f64 = (0..3).map(|k| (second[k] - first[k]) * axis[k]).sum();
    [f64::max(-half[0], apart - half[1]), f64::min(half[0], apart + half[1])]
}
