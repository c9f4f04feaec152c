//! Contact surface of a flank that is interpolated from a table.

use super::section::Placed;
use super::tooth::{CurvePoint, Tooth};
use calyx_runtime::structure::analytic::{SectionPoint, SectionedSurface};
use calyx_runtime::surface::{Surface, SurfacePoint};
use calyx_runtime::vec3::{cross, length};
use std::sync::Arc;

/// Flank of tooth 0 in the gear's frame. `u` runs along the profile from the fillet over the
/// rounded tip edge; in the middle section it is the arc length, m. `v` is the distance from the
/// middle section along the pitch cone, m, increasing towards +e3.
#[derive(Clone, Debug)]
pub struct TabulatedSurface {
    tooth: Arc<Tooth>,
    side: usize,
    breaks: [f64; 1],
}

impl TabulatedSurface {
    /// Creates the surface of the counter-clockwise (0) or the clockwise flank (1).
    pub fn new(tooth: Arc<Tooth>, side: usize) -> Self {
        let breaks = [tooth.edge_from(side)];
        Self { tooth, side, breaks }
    }
}

/// Point of the body with its tangents, from a point of a developed section.
pub(super) fn surface_point(tooth: &Tooth, side: usize, v: f64, point: &CurvePoint) -> SurfacePoint {
    placed_point(&tooth.placed(v, point.position), side, point)
}

fn placed_point(placed: &Placed, side: usize, point: &CurvePoint) -> SurfacePoint {
    let [by_x, by_y, along] = placed.derivatives;
    let combined = |[x, y]: [f64; 2], more: f64| {
        [0, 1, 2].map(|axis: usize| x * by_x[axis] + y * by_y[axis] + more * along[axis])
    };
    let tangents = [combined(point.by_u, 0.0), combined(point.by_v, 1.0)];
    let outwards = if side == 0 { cross(tangents[1], tangents[0]) } else { cross(tangents[0], tangents[1]) };
    let size = length(outwards);
    SurfacePoint { position: placed.position, tangents, normal: outwards.map(|part| part / size) }
}

impl Surface for TabulatedSurface {
    fn range(&self) -> [[f64; 2]; 2] {
        [[0.0, self.tooth.flank_end(self.side)], self.tooth.face]
    }

    fn at(&self, u: f64, v: f64) -> SurfacePoint {
        surface_point(&self.tooth, self.side, v, &self.tooth.flank_at(self.side, u, v))
    }

    fn breaks(&self) -> &[f64] {
        &self.breaks
    }

    fn edge_from(&self) -> Option<f64> {
        Some(self.breaks[0])
    }
}

impl SectionedSurface for TabulatedSurface {
    fn in_section(&self, u: f64, v: f64) -> SectionPoint {
        let curve = self.tooth.flank_at(self.side, u, v);
        let placed = self.tooth.placed(v, curve.position);
        // The development is isometric, and the length along the pitch cone is normal to it.
        let [by_x, by_y, _] = placed.derivatives;
        let axes = [by_x, by_y, cross(by_x, by_y)];
        SectionPoint { point: placed_point(&placed, self.side, &curve), place: curve.position, axes }
    }

    fn as_surface(self: Arc<Self>) -> Arc<dyn Surface> {
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tabulated::test_teeth::{Conical, cylindrical, sampled};
    use calyx_runtime::scene::StructureOptions;

    #[test]
    fn a_sampled_helical_gear_has_its_own_surface() {
        for helix in [0.0, 20.0] {
            let gear = cylindrical(helix);
            let stations = sampled(&gear, 7, 33).stations().expect("a table");
            let radius = gear.form().tip_edge_radius;
            let tooth = Arc::new(Tooth::new(&stations, Some(radius)).expect("a tooth"));
            for (side, exact) in
                gear.surfaces(&StructureOptions::default()).expect("flanks").iter().enumerate()
            {
                let found = TabulatedSurface::new(tooth.clone(), side);
                let [[_, end], [from, to]] = exact.range();
                let off = found.range()[0][1] - end;
                assert!(off.abs() < 2e-9, "{off:e}");
                let off = found.edge_from().unwrap() - exact.edge_from().unwrap();
                assert!(off.abs() < 2e-9, "{off:e}");
                for k in 0..=40 {
                    let u = end * f64::from(k) / 40.0;
                    for v in [from, 0.31 * from, 0.0, 0.7 * to, to, 1.02 * to] {
                        let (found, exact) = (found.at(u, v), exact.at(u, v));
                        for axis in 0..3 {
                            let off = (found.position[axis] - exact.position[axis]).abs();
                            assert!(off < 1e-9, "helix {helix}, u {u}, v {v}: {off}");
                            let turned = (found.normal[axis] - exact.normal[axis]).abs();
                            assert!(turned < 5e-5, "helix {helix}, u {u}, v {v}: {turned}");
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn tangents_are_derivatives_and_normals_point_outwards() {
        for upwards in [false, true] {
            for conical in [Conical::PINION, Conical::GEAR] {
                let table = Conical { upwards, ..conical }.table(9, 17);
                let stations = table.stations().expect("a table");
                let tooth = Arc::new(Tooth::new(&stations, None).expect("a tooth"));
                for side in 0..2 {
                    let surface = TabulatedSurface::new(tooth.clone(), side);
                    let [[_, end], [from, to]] = surface.range();
                    let edge = surface.edge_from().expect("an edge");
                    let h = 1e-7;
                    for u in [0.1 * edge, 0.8 * edge, edge + 0.3 * (end - edge), end + 0.2 * (end - edge)] {
                        for v in [from - 1e-4, 0.2 * to, 0.9 * to] {
                            let at = surface.at(u, v);
                            let moved = [
                                [surface.at(u - h, v), surface.at(u + h, v)],
                                [surface.at(u, v - h), surface.at(u, v + h)],
                            ];
                            for (k, [low, high]) in moved.into_iter().enumerate() {
                                for axis in 0..3 {
                                    let slope = (high.position[axis] - low.position[axis]) / (2.0 * h);
                                    let off = (at.tangents[k][axis] - slope).abs();
                                    // The step is a noticeable part of the tip edge's radius.
                                    let bound = if u > edge { 2e-4 } else { 2e-7 };
                                    assert!(off < bound, "{side} {u} {v} {k} {axis}: {off}");
                                }
                            }
                            let [x, y, _] = at.position;
                            let around = x * at.normal[1] - y * at.normal[0];
                            assert!(u > edge || (around > 0.0) == (side == 0));
                        }
                    }
                    // The normal is continuous at the tip edge.
                    let [below, above] = [surface.at(edge - 1e-12, 0.0), surface.at(edge + 1e-12, 0.0)];
                    for axis in 0..3 {
                        assert!((below.normal[axis] - above.normal[axis]).abs() < 1e-6);
                    }
                }
            }
        }
    }

    #[test]
    fn a_conical_tooth_is_interpolated_between_its_points() {
        // The involute of the pinion begins near its base circle, where the curvature is singular.
        for (conical, bound) in [(Conical::PINION, 2e-7), (Conical::GEAR, 1e-9)] {
            let [coarse, fine] = [(9, 17), (33, 65)].map(|(stations, points)| {
                let stations = conical.table(stations, points).stations().expect("a table");
                Arc::new(Tooth::new(&stations, None).expect("a tooth"))
            });
            for side in 0..2 {
                let [coarse, fine] = [&coarse, &fine].map(|tooth| TabulatedSurface::new(tooth.clone(), side));
                let edge = fine.edge_from().expect("an edge");
                let [_, [from, to]] = fine.range();
                let mut largest = 0.0_f64;
                for k in 0..=20 {
                    for l in 0..=10 {
                        let u = edge * f64::from(k) / 20.0;
                        let v = from + (to - from) * f64::from(l) / 10.0;
                        let (a, b) = (coarse.at(u, v), fine.at(u, v));
                        let off = |axis: usize| (a.position[axis] - b.position[axis]) * b.normal[axis];
                        largest = largest.max((0..3).map(off).sum::<f64>().abs());
                    }
                }
                assert!(largest < bound, "{conical:?} {side}: {largest:e}");
            }
        }
    }
}
