//! Plane implementation of a position: closest approach of profiles, grids along their common
//! tangent.

use super::contact_geometry::{
    Approach, Candidate, ContactGeometry, LoadedCells, Resolution, Search, WidthReport,
};
use super::friction::Action;
use super::{ContactGrid, ContactPatch};
use crate::modal::Modes;
use crate::raceways::dense;
use crate::system::{PlaneBodies, System};
use calyx_contact::approach::{self, PlacedProfile, closest_approach};
use calyx_contact::assembly::{self, Entries, compliance};
use calyx_contact::grid::{self, Grid, GridOptions, Width, assess, build_grid, pressures};
use calyx_contact::zone::ENDLESS;
use calyx_contact::{ContactFrame, Placement};
use calyx_model::dof::Dof;
use calyx_model::frames::pose;
use calyx_model::motion::PlanePose;
use calyx_model::pairs::SurfacePair;
use calyx_numerics::error::EngineError;
use calyx_numerics::vec2::distance;
use calyx_structure::profile::Profile;
use calyx_structure::{Chart, Structure};
use faer::Mat;
use nalgebra::DMatrix;
use std::f64::consts::PI;
use std::sync::Arc;

pub(super) struct Plane<'a> {
    pub(super) system: &'a System<'a>,
    pub(super) bodies: &'a PlaneBodies,
}

/// Closest approach of two profiles.
pub(super) struct Site {
    profiles: [Arc<dyn Profile>; 2],
    placements: [Placement; 2],
    approach: approach::Approach,
}

impl Site {
    fn placed(&self, side: usize) -> PlacedProfile<'_> {
        PlacedProfile { profile: self.profiles[side].as_ref(), placement: self.placements[side] }
    }
}

impl ContactGeometry for Plane<'_> {
    type Site = Site;
    type Grid = Grid;
    /// Width, m.
    type Size = f64;

    fn candidates(&self, time: f64, moved: &[f64], _: Search) -> Result<Vec<Candidate<Site>>, EngineError> {
        let scene = self.system.scene;
        let mut found = Vec::new();
        for (index, pair) in scene.pairs.iter().enumerate() {
            let bodies = pair.bodies.map(|body| body.0);
            let poses = [self.pose(bodies[0], time, moved)?, self.pose(bodies[1], time, moved)?];
            let placements = [0, 1].map(|side: usize| self.placement(bodies[side], &poses[side]));
            let origins = [0, 1].map(|side: usize| poses[side].point(self.system.axle(bodies[side])));
            let structures = [0, 1].map(|side| self.bodies.structures[bodies[side]].clone());
            let [Some(first), Some(second)] = structures else { continue };
            let structures = [first, second];
            let profiles = [0, 1].map(|side: usize| structures[side].profile(pair.surfaces[side]));
            let near = [0, 1].map(|side: usize| {
                let other = 1 - side;
                let reach = scene.bodies[bodies[other]].prototype.enclosing_radius();
                let body = (bodies[side], structures[side].as_ref(), profiles[side].as_ref());
                self.teeth_near(body, placements[side], placements[other].origin(), reach)
            });
            let angle = poses[0].angle + scene.bodies[bodies[0]].phase
                - self.system.rotated_line_of_centres(index, time);
            let nominal = pair.mesh.as_ref().filter(|_| !pair.grid.edges);
            let on_path = |tooth: u32| nominal.is_none_or(|mesh| mesh.on_path(tooth, angle));
            let touching = 0.5 * (profiles[0].length() + profiles[1].length());
            for (first, first_place, first_middle) in &near[0] {
                for (second, second_place, second_middle) in &near[1] {
                    if distance(*first_middle, *second_middle) > 1.5 * touching || !on_path(*first) {
                        continue;
                    }
                    let placements = [*first_place, *second_place];
                    let placed = |side: usize| PlacedProfile {
                        profile: profiles[side].as_ref(),
                        placement: placements[side],
                    };
                    let approach = closest_approach(placed(0), placed(1), pair.grid.edges)
                        .filter(|approach| self.faces(bodies, &placements, approach));
                    if let Some(approach) = approach {
                        let arms = self.arms_of(bodies, &approach.frame, origins);
                        found.push(Candidate {
                            teeth: (index, [*first, *second]),
                            length: profiles[0].length(),
                            nearest: Approach { gap: approach.gap, arms },
                            others: Vec::new(),
                            site: Site { profiles: profiles.clone(), placements, approach },
                        });
                    }
                }
            }
        }
        Ok(found)
    }

    /// The surface displacement is about q / E*.
    fn force_of_overlap(&self, candidate: &Candidate<Site>, overlap: f64) -> f64 {
        overlap * self.contact_modulus(self.pair(candidate).bodies.map(|body| body.0))
    }

    fn build_grid(
        &self,
        candidate: &Candidate<Site>,
        force: f64,
        width: Option<f64>,
        _: Resolution,
    ) -> Result<Grid, EngineError> {
        let width = width.or(self.pair(candidate).grid.width);
        Ok(self.grid_of_width(candidate, width.map_or(Width::Hertz { force }, Width::Total)))
    }

    fn automatic_width(&self, candidate: &Candidate<Site>, force: f64) -> f64 {
        self.grid_of_width(candidate, Width::Hertz { force }).width
    }

    fn count(&self, grid: &Grid) -> usize {
        grid.cells.len()
    }

    fn width(&self, grid: &Grid) -> f64 {
        grid.cells.iter().map(|cell| cell.width()).sum()
    }

    fn is_cut_off(&self, grid: &Grid) -> bool {
        grid.surface_ends == [true; 2]
    }

    fn gaps(&self, grid: &Grid) -> Vec<f64> {
        grid.cells.iter().map(|cell| cell.gap).collect()
    }

    /// All cells act along one line, see [`ContactFrame`].
    fn arms(&self, candidate: &Candidate<Site>, grid: &Grid) -> Vec<f64> {
        grid.cells.iter().flat_map(|_| candidate.nearest.arms.iter().copied()).collect()
    }

    fn action(&self, candidate: &Candidate<Site>, grid: &Grid) -> Action {
        let action = self.approaching(candidate);
        Action { points: action.points.repeat(grid.cells.len()), ..action }
    }

    fn approaching(&self, candidate: &Candidate<Site>) -> Action {
        let ContactFrame { point: [x, y], normal: [along_x, along_y], .. } = candidate.site.approach.frame;
        let (normal, across) = ([along_x, along_y, 0.0], [along_y, -along_x, 0.0]);
        Action { normal, across, points: vec![[x, y, 0.0]] }
    }

    fn compliance(
        &self,
        laid: &[(&Candidate<Site>, &Grid)],
        entries: Entries,
    ) -> Result<Vec<f64>, EngineError> {
        let mut patches = Vec::with_capacity(laid.len());
        for (candidate, grid) in laid {
            let pair = self.pair(candidate);
            let side = |side: usize| {
                let body = pair.bodies[side].0;
                let structure = self.bodies.structures[body].as_deref()?;
                let chart = Chart { tooth: candidate.teeth.1[side], surface: pair.surfaces[side] };
                Some(assembly::Side { body, structure, chart })
            };
            if let (Some(first), Some(second)) = (side(0), side(1)) {
                patches.push(assembly::PatchCells { sides: [first, second], cells: &grid.cells });
            }
        }
        compliance(&patches, entries, &self.system.interrupt)
    }

    fn by_spline_teeth(&self, laid: &[(&Candidate<Site>, &Grid)]) -> Result<Mat<f64>, EngineError> {
        let cells = laid.iter().map(|(_, grid)| grid.cells.len()).sum();
        let mut growth = Mat::zeros(cells, self.system.flanks());
        let mut from = 0;
        for (body, contact) in &self.system.spline_teeth {
            let Some(structure) = self.bodies.structures[*body].as_deref() else { continue };
            let mut first = 0;
            for (candidate, grid) in laid {
                let pair = self.pair(candidate);
                for side in (0..2).filter(|&side| pair.bodies[side].0 == *body) {
                    let chart = Chart { tooth: candidate.teeth.1[side], surface: pair.surfaces[side] };
                    let places: Vec<f64> = grid.cells.iter().map(|cell| cell.loaded_at[side]).collect();
                    self.system.interrupt.check()?;
                    let moved = structure.interface_displacements(chart, &places);
                    // A rigid body has none.
                    for cell in 0..if moved.nrows() > 0 { places.len() } else { 0 } {
                        for (flank, value) in
                            contact.by_flanks(|spline_tooth| moved[(spline_tooth, cell)]).enumerate()
                        {
                            growth[(first + cell, from + flank)] = value;
                        }
                    }
                }
                first += grid.cells.len();
            }
            from += contact.flanks();
        }
        Ok(growth)
    }

    fn by_raceway(
        &self,
        body: usize,
        laid: &[(&Candidate<Site>, &Grid)],
    ) -> Result<DMatrix<f64>, EngineError> {
        let structure = self.bodies.structures.get(body).and_then(Option::as_deref);
        let Some((structure, raceway)) = structure.and_then(|own| Some((own, own.raceway()?))) else {
            return Ok(DMatrix::zeros(0, 0));
        };
        let cells = laid.iter().map(|(_, grid)| grid.cells.len()).sum();
        let (mut growth, mut first) = (DMatrix::zeros(cells, raceway.terms()), 0);
        for (candidate, grid) in laid {
            let pair = self.pair(candidate);
            for side in (0..2).filter(|&side| pair.bodies[side].0 == body) {
                let chart = Chart { tooth: candidate.teeth.1[side], surface: pair.surfaces[side] };
                let places: Vec<f64> = grid.cells.iter().map(|cell| cell.loaded_at[side]).collect();
                self.system.interrupt.check()?;
                let moved = dense(structure.interface_displacements(chart, &places).transpose());
                growth.rows_mut(first, places.len()).copy_from(&moved);
            }
            first += grid.cells.len();
        }
        Ok(growth)
    }

    fn may_grow(&self) -> bool {
        false
    }

    fn corrected_grid_size(
        &self,
        candidate: &Candidate<Site>,
        grid: &Grid,
        _size: Option<f64>,
        loaded: &LoadedCells,
        wide: bool,
    ) -> Option<f64> {
        let report = assess(grid, &pressures(&grid.cells, loaded.forces));
        let asked = self.pair(candidate).grid.width.is_none() && !(wide && report.under_resolved);
        report.recommended_width.filter(|_| asked)
    }

    fn assess_width(&self, grid: &Grid, forces: &[f64]) -> WidthReport {
        let report = assess(grid, &pressures(&grid.cells, forces));
        WidthReport {
            width: grid.width,
            half_count: grid.half_count,
            truncated: report.truncated != [false; 2],
            under_resolved: report.under_resolved,
            recommended: report.recommended_width,
        }
    }

    fn modal_arms(&self, laid: &[(&Candidate<Site>, &Grid)], modes: &Modes) -> Mat<f64> {
        let cells = laid.iter().map(|(_, grid)| grid.cells.len()).sum();
        let mut arms = Mat::zeros(cells, modes.count());
        let mut first = 0;
        for (candidate, grid) in laid {
            let pair = self.pair(candidate);
            let side = |side: usize| {
                let chart = Chart { tooth: candidate.teeth.1[side], surface: pair.surfaces[side] };
                (pair.bodies[side].0, chart)
            };
            modes.add_arms(&mut arms, first, [side(0), side(1)], &grid.cells);
            first += grid.cells.len();
        }
        arms
    }

    fn patch(&self, candidate: &Candidate<Site>, laid: Option<(Grid, Vec<f64>)>) -> ContactPatch {
        let (pair, teeth) = candidate.teeth;
        let surfaces = self.pair(candidate).surfaces;
        let frame = candidate.site.approach.frame;
        let (grid, forces) = match laid {
            Some((Grid { cells, flank, unit_half_width, .. }, forces)) => {
                (ContactGrid::Plane { frame, cells, flank, unit_half_width }, forces)
            }
            None => {
                let (flank, unit_half_width) = (ENDLESS, 0.0);
                (ContactGrid::Plane { frame, cells: Vec::new(), flank, unit_half_width }, Vec::new())
            }
        };
        ContactPatch { pair, teeth, surfaces, grid, forces, friction_vectors: Vec::new() }
    }
}

impl Plane<'_> {
    fn pair(&self, candidate: &Candidate<Site>) -> &SurfacePair {
        &self.system.scene.pairs[candidate.teeth.0]
    }

    fn grid_of_width(&self, candidate: &Candidate<Site>, width: Width) -> Grid {
        let pair = self.pair(candidate);
        let options = GridOptions {
            half_count: pair.grid.plane_half_cells(),
            width,
            contact_modulus: self.contact_modulus(pair.bodies.map(|body| body.0)),
            search_edges: pair.grid.edges,
        };
        let site = &candidate.site;
        build_grid(site.placed(0), site.placed(1), &site.approach, &options)
    }

    /// Returns the pose of a body's frame at a time, with the deviations `moved` from its
    /// prescribed motion.
    fn pose(&self, body: usize, time: f64, moved: &[f64]) -> Result<PlanePose, EngineError> {
        let meant = pose(self.system.scene, body, time)?;
        let (by, axle) = (self.system.moved(body, moved), self.system.axle(body));
        let turned = PlanePose { angle: meant.angle + by[5], ..meant };
        // The body rotates about its axis.
        let (from, to) = (meant.point(axle), turned.point(axle));
        let at = |k: usize| meant.origin[k] + by[k] + (from[k] - to[k]);
        Ok(PlanePose { origin: [at(0), at(1)], ..turned })
    }

    /// Returns the placement of the coordinates of a body's teeth from the pose of its frame, with
    /// the body's phase.
    fn placement(&self, body: usize, pose: &PlanePose) -> Placement {
        Placement::new(pose.angle + self.system.scene.bodies[body].phase, pose.origin)
    }

    /// Returns whether surfaces with this approach face each other. If they overlap by half a pitch
    /// of either body, one has passed the other and belongs to its neighbour.
    fn faces(&self, bodies: [usize; 2], placements: &[Placement; 2], approach: &approach::Approach) -> bool {
        let half_pitch = |side: usize| {
            let structure = self.bodies.structures[bodies[side]].as_ref();
            match structure.map_or(1, |structure| structure.teeth()) {
                // A single tooth has no neighbour, and the contact may be at its origin.
                1 => f64::INFINITY,
                teeth => PI / f64::from(teeth) * distance(approach.frame.point, placements[side].origin()),
            }
        };
        approach.gap > -half_pitch(0).min(half_pitch(1))
    }

    /// Returns the teeth of a body whose surface comes within `reach` of a point: index, placement,
    /// middle of the surface.
    fn teeth_near(
        &self,
        (body, structure, profile): (usize, &dyn Structure, &dyn Profile),
        placement: Placement,
        point: [f64; 2],
        reach: f64,
    ) -> Vec<(u32, Placement, [f64; 2])> {
        let middle = profile.at(0.5 * profile.length()).position;
        (0..structure.teeth())
            .map(|tooth| {
                let angle = structure.tooth_angle(tooth) + self.system.pitch_error(body, tooth);
                let placement = placement.rotated_first(angle);
                (tooth, placement, placement.point(middle))
            })
            .filter(|(_, _, middle)| distance(*middle, point) < reach + profile.length())
            .collect()
    }

    /// Returns the growth of the gap of a patch by each DOF, m per m or rad.
    fn arms_of(&self, bodies: [usize; 2], frame: &ContactFrame, origins: [[f64; 2]; 2]) -> Vec<f64> {
        let arm = |dof: &Dof| {
            let sides = (0..2).filter(|&side| bodies[side] == dof.body);
            sides
                .map(|side| match dof.component {
                    0 => frame.translation_arm(side, [1.0, 0.0]),
                    1 => frame.translation_arm(side, [0.0, 1.0]),
                    _ => frame.rotation_arm(side, origins[side]),
                })
                .sum()
        };
        self.system.dofs.iter().map(arm).collect()
    }

    fn contact_modulus(&self, bodies: [usize; 2]) -> f64 {
        match bodies.map(|body| self.bodies.structures[body].as_deref()) {
            [Some(first), Some(second)] => grid::contact_modulus(first, second),
            _ => f64::INFINITY,
        }
    }
}
