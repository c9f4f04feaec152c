//! Load factors of given load distributions, in closed form.

use super::*;
use calyx_model::pairs::GearMesh;

const FACE: f64 = 0.02;

/// Parallel springs on a face, loaded by a straight misaligned edge: the forces on its parts.
fn misaligned(stiffness: f64, slope: f64, force: f64) -> Vec<AxialLoad> {
    const COUNT: usize = 4000;
    let length = FACE / COUNT as f64;
    let along = |index: usize| (index as f64 + 0.5) * length - 0.5 * FACE;
    let load = |middle: f64| move |index| (stiffness * (middle + slope * along(index))).max(0.0) * length;
    // Bisect the approach until the springs balance the force.
    let (mut high, mut low) = (2.0 * FACE, -2.0 * FACE);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        let total: f64 = (0..COUNT).map(load(middle)).sum();
        if total > force { high = middle } else { low = middle }
    }
    let part = |index: usize| {
        let at = along(index);
        AxialLoad { ends: [at - 0.5 * length, at + 0.5 * length], force: load(low)(index) }
    };
    (0..COUNT).map(part).collect()
}

/// With stiffness c per length, misalignment f and face width b: K_Hbeta = 1 + c f b² / 2F while
/// the whole face carries load, and the root of 2 c f b² / F beyond, from 2 on (ISO 6336-1, method
/// C, with the mean load F/b and the misalignment f b).
#[test]
fn a_misaligned_uniform_stiffness_has_its_face_load_factor_in_closed_form() {
    let (stiffness, force) = (14e9, 5000.0);
    for slope in [0.0, 1e-4, 5e-4, 1.6e-3, 4e-3] {
        let by_load = stiffness * slope * FACE * FACE / force;
        let expected = if by_load <= 2.0 { 1.0 + 0.5 * by_load } else { (2.0 * by_load).sqrt() };
        let found =
            largest_over_mean(&misaligned(stiffness, slope, force), [-0.5 * FACE, 0.5 * FACE], FACE / 16.0);
        assert!((found / expected - 1.0).abs() < 1e-3, "slope {slope}: {found} {expected}");
    }
}

/// Contact lines across the path of contact under a uniform load have K_Hbeta = 1 at any overlap,
/// although the number of lines at an axial position varies over the cycle.
#[test]
fn a_uniform_load_on_oblique_contact_lines_has_a_face_load_factor_of_one() {
    let mesh = |overlap_ratio: f64| GearMesh {
        teeth: [20, 40],
        base_radii: [0.02, 0.04],
        drive_sense: 1.0,
        sign: 1.0,
        entering: [0, 0],
        start: 0.0,
        period: 1.0,
        characteristic: Vec::new(),
        roll: [0.0, 1.0],
        path: [0.0, 1.0],
        overlap_ratio,
        twist: 0.0,
        roll_at_zero: 0.0,
        carrier: [0.0; 3],
        phase_offset: 0.0,
        first_contact: None,
    };
    for (contact_ratio, overlap_ratio) in [(1.4, 0.5), (1.55, 0.83), (1.62, 1.0), (1.3, 2.37)] {
        let mesh = mesh(overlap_ratio);
        let positions = super::super::mesh_cycle::positions_of_cycle(&mesh);
        let parts = 2000;
        let mut loads = Vec::new();
        for position in 0..positions {
            for part in 0..parts {
                let along = (f64::from(part) + 0.5) / f64::from(parts);
                // Pitches since the section entered contact, for the first pair.
                let phase = (position as f64 + 0.5) / positions as f64 - overlap_ratio * along;
                let lines = (-1..8).filter(|k| (0.0..contact_ratio).contains(&(phase + f64::from(*k))));
                let at = (along - 0.5) * FACE;
                let half = 0.5 * FACE / f64::from(parts);
                loads.push(AxialLoad { ends: [at - half, at + half], force: lines.count() as f64 });
            }
        }
        let found = largest_over_mean(&loads, [-0.5 * FACE, 0.5 * FACE], window(&mesh, FACE));
        assert!((found - 1.0).abs() < 2e-3, "{contact_ratio} {overlap_ratio}: {found}");
    }
}

#[test]
fn without_load_the_factor_is_one() {
    assert_eq!(largest_over_mean(&[], [-0.01, 0.01], 1e-3), 1.0);
}

/// Spur pairs: all load on one pair below a contact ratio of 2, half of it below 3. Helical pairs
/// with an integral ratio have a constant length of contact lines, eps_alpha b for all.
#[test]
fn ideal_shares_are_those_of_equal_line_loads() {
    for (contact_ratio, overlap_ratio, expected) in [
        (1.6, 0.0, 1.0),
        (2.0 - 1e-6, 0.0, 1.0),
        (2.4, 0.0, 0.5),
        (1.6, 1.0, 1.0 / 1.6),
        (2.0, 0.7, 0.5),
        (1.5, 2.0, 1.5 / (2.0 * 1.5)),
    ] {
        let found = ideal_share(contact_ratio, overlap_ratio);
        assert!((found - expected).abs() < 1e-6, "{contact_ratio} {overlap_ratio}: {found} {expected}");
    }
}

/// b/h = 4 (ISO 6336-1, 7.5: N_F = 16/21), and the limit b/h = 3.
#[test]
fn the_exponent_of_the_root_depends_on_depth_over_width() {
    let of = |depth_ratio| RootFaceLoadFactor::new(PairId(0), depth_ratio);
    assert!((of(0.25).exponent - 16.0 / 21.0).abs() < 1e-15);
    assert_eq!(of(0.6), of(1.0 / 3.0));
}
