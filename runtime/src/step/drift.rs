//! How far a load moves surfaces along each other. Gaps are linear in the motions of frames about where the frames are without load;
//! what slides across a patch by more than the patch reaches is no longer where its grid was laid.

use super::drag::{Action, work};
use crate::scene::{Scene, SurfacePair};
use crate::system::System;

/// How far the second surface of a patch has moved across against the first (m), in the transverse plane, by the motions of the
/// freedoms at a time (s).
pub(super) fn drift(system: &System, pair: &SurfacePair, time: f64, action: &Action, motion: &[f64]) -> f64 {
    let [x, y, _] = action.normal;
    let size = x.hypot(y);
    let Some(point) = action.points.get(action.points.len() / 2).filter(|_| size > 0.0) else { return 0.0 };
    let across = [y / size, -x / size, 0.0];
    let mut moved = 0.0;
    for (freedom, motion) in system.freedoms.iter().zip(motion) {
        for side in (0..2).filter(|&side| pair.bodies[side].0 == freedom.body) {
            let (origin, axes) = (system.origin(freedom.body, time), system.axes(freedom.body, time));
            moved -= motion * work(across, side, freedom.component, &axes, origin, *point);
        }
    }
    moved
}

/// That a patch has drifted by more than half of its grid (widths in m).
pub(super) fn drifted(scene: &Scene, pair: &SurfacePair, drift: f64, width: f64) -> Option<String> {
    let [first, second] = pair.bodies.map(|body| scene.bodies[body.0].name.as_str());
    (drift.abs() > 0.5 * width).then(|| {
        // To two digits, so that the positions of a cycle say the same.
        let drift = format!("{:.1e}", drift.abs() * 1e3).parse().unwrap_or(drift.abs() * 1e3);
        format!(
            "the load moves \"{first}\" and \"{second}\" by {drift} mm along each other, more than half of their contact grid, which lies \
             where the frames put them without load; stiffen what holds them, or put the frames where the load takes them"
        )
    })
}
