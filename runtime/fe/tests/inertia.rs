//! Tests of mass, centre of mass and moments of inertia.

use calyx_fe::inertia::Inertia;

#[test]
fn two_halves_make_a_whole() {
    // A rod of 2 kg and 0.6 m along z from its halves: m l²/12 about transverse axes, zero
    // about its own.
    let half = Inertia::axial(1.0, 0.0, 0.3 * 0.3 / 12.0);
    let whole = half.shifted_along(0.15) + half.shifted_along(-0.15);
    assert_eq!([whole.mass, whole.polar()], [2.0, 0.0]);
    assert_eq!(whole.centre(), [0.0; 3]);
    assert!((whole.about[0][0] - 2.0 * 0.6 * 0.6 / 12.0).abs() < 1e-15);
    assert_eq!(half.shifted_along(0.15).centre(), [0.0, 0.0, 0.15]);
    let seen = half.from([0.0, 0.0, -0.15]);
    assert!((seen.about[0][0] - half.shifted_along(0.15).about[0][0]).abs() < 1e-15);
    let off = half.from([-0.5, 0.2, 0.0]);
    assert!((off.polar() - 0.29).abs() < 1e-15 && (off.about[0][1] - 0.1).abs() < 1e-15);
    let back = off.from([0.5, -0.2, 0.0]);
    assert!((back.about[0][0] - half.about[0][0]).abs() < 1e-15 && back.about[0][1].abs() < 1e-15);
    assert_eq!(2.0 * half, half + half);
    assert_eq!(Inertia::default().centre(), [0.0; 3]);
}
