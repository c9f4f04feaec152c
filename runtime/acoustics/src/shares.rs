//! Shares of the triangles of a coarse surface in panels of a finer one.

use crate::mesh::SurfaceMesh;
use crate::nearest::NearestTriangle;
use rayon::prelude::*;

/// Returns the share of each coarse triangle in each panel, from 0 to 1. `panels` has the panel of
/// each fine triangle, from 0 to `count`; `None` for the rest.
///
/// Each fine triangle belongs to the nearest coarse one on the same side of the wall, and shares
/// are ratios of the fine areas. So panels keep their areas, although their rims are no edges of
/// the coarse surface.
pub fn panel_shares(
    fine: &SurfaceMesh,
    panels: &[Option<usize>],
    coarse: &SurfaceMesh,
    count: usize,
) -> Vec<Vec<f64>> {
    let mut shares = vec![vec![0.0; coarse.triangles().len()]; count];
    if fine == coarse {
        for (triangle, panel) in panels.iter().enumerate() {
            panel.iter().for_each(|&panel| shares[panel][triangle] = 1.0);
        }
        return shares;
    }
    let targets = NearestTriangle::new(coarse);
    let owners: Vec<usize> = (0..panels.len())
        .into_par_iter()
        .map(|triangle| targets.find(fine.centroid(triangle), fine.normals()[triangle]))
        .collect();
    let mut areas = vec![0.0; coarse.triangles().len()];
    for ((owner, area), panel) in owners.iter().zip(fine.areas()).zip(panels) {
        areas[*owner] += area;
        panel.iter().for_each(|&panel| shares[panel][*owner] += area);
    }
    let targets = NearestTriangle::new(fine);
    for (triangle, &area) in areas.iter().enumerate() {
        if area > 0.0 {
            shares.iter_mut().for_each(|own| own[triangle] /= area);
            continue;
        }
        // No fine triangle has its centroid here.
        let near = targets.find(coarse.centroid(triangle), coarse.normals()[triangle]);
        panels[near].iter().for_each(|&panel| shares[panel][triangle] = 1.0);
    }
    shares
}
