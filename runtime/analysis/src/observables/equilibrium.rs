//! Equilibrium of a scene as observables access it: contacts, loads and motions in newtons and
//! metres, for plane and three-dimensional models.

use calyx_contact::pressure::Peak;
use calyx_contact::solid::{self, Grid, slice_peaks_in};
use calyx_contact::zone::Zone;
use calyx_model::dof::Dof;
use calyx_model::ids::{BodyId, PairId};
use calyx_model::mechanism::Mechanism;
use calyx_model::observed::Location;
use calyx_model::pairs::GearMesh;
use calyx_solve::step::{ContactGrid, ContactPatch, StepResult};
use calyx_solve::system::{Bodies, System};
use calyx_structure::solid::SegmentLoad;
use calyx_structure::{Chart, SurfaceLoad};
use std::ops::Range;

/// Scene at a solved position.
#[derive(Clone, Copy)]
pub struct Equilibrium<'a> {
    pub(crate) system: &'a System<'a>,
    pub(crate) step: &'a StepResult,
}

impl<'a> Equilibrium<'a> {
    /// Creates the view of a position that this system has solved.
    pub fn new(system: &'a System<'a>, step: &'a StepResult) -> Self {
        Equilibrium { system, step }
    }

    /// Returns the scene.
    pub fn scene(&self) -> &'a Mechanism {
        self.system.scene
    }

    /// Returns the time, s.
    pub fn time(&self) -> f64 {
        self.step.time
    }

    /// Returns the gear mesh data of a surface pair, and its bodies; `None` for any other pair.
    pub fn mesh(&self, pair: PairId) -> Option<(&'a GearMesh, [BodyId; 2])> {
        let pair = self.system.scene.pairs.get(pair.0)?;
        Some((pair.mesh.as_ref()?, pair.bodies))
    }

    /// Returns the pair of the drive flanks of a mesh: for a pair of coast flanks the other one,
    /// for any other pair itself.
    pub fn front(&self, pair: PairId) -> PairId {
        self.system.scene.pairs.get(pair.0).and_then(|pair| pair.front).unwrap_or(pair)
    }

    /// Returns the contact patches of a whole mesh, on both flanks of its teeth.
    pub fn mesh_contacts(self, pair: PairId) -> impl Iterator<Item = Contact<'a>> {
        let front = self.front(pair);
        self.all_contacts().filter(move |contact| self.front(contact.pair()) == front)
    }

    /// Returns the contact patches of a pair, including those without load.
    pub fn contacts(self, pair: PairId) -> impl Iterator<Item = Contact<'a>> {
        self.all_contacts().filter(move |contact| contact.pair() == pair)
    }

    /// Returns the contact patches of all pairs.
    pub fn all_contacts(self) -> impl Iterator<Item = Contact<'a>> {
        self.step.patches.iter().map(move |patch| Contact { at: self, patch })
    }

    /// Returns the contact patches on a body, each with the body's side.
    pub fn contacts_on(self, body: BodyId) -> impl Iterator<Item = (Contact<'a>, usize)> {
        let sides = move |contact: &Contact<'a>| contact.bodies().iter().position(|other| *other == body);
        self.all_contacts().filter_map(move |contact| Some((contact, sides(&contact)?)))
    }

    /// Returns the sum of the normal forces of a pair over all its patches, N.
    pub fn force(self, pair: PairId) -> f64 {
        self.contacts(pair).map(|contact| contact.force()).sum()
    }

    /// Returns the deviation of a body's frame from its prescribed motion, m or rad; `component` is
    /// an index of [`calyx_model::dof::DOF_NAMES`].
    pub fn deviation(&self, body: BodyId, component: usize) -> f64 {
        let dof = Dof { body: body.0, component };
        let at = self.system.dofs.iter().position(|other| *other == dof);
        at.map_or(0.0, |at| self.step.motion[at])
    }

    /// Returns the position of a body's axis of rotation when the contact grid was created, m: the
    /// prescribed position, corrected for closed backlash and large motions under load.
    pub fn origin(&self, body: BodyId) -> [f64; 3] {
        self.system.displaced_origin(body.0, self.time(), &self.step.start)
    }

    /// Returns the velocity of the material point of a body at a point in ground coordinates (m),
    /// m/s: by the body's prescribed motion at the position where the contact grid was created.
    pub fn velocity(&self, body: BodyId, point: [f64; 3]) -> [f64; 3] {
        self.system.velocity(body.0, self.time(), &self.step.start, point)
    }

    /// Returns the location on a body of a plane model, from its tooth and the point in the body's
    /// coordinates (m).
    pub(crate) fn location(&self, body: BodyId, tooth: u32, [x, y]: [f64; 2]) -> Location {
        let (body, radius) = (&self.system.scene.bodies[body.0], x.hypot(y));
        let roll_angle = body.prototype.roll_angle(radius);
        Location { body: body.name.clone(), tooth, roll_angle, radius, axial: None }
    }

    /// Returns the location on a body of a three-dimensional model, with mid-face at z = 0.
    pub(crate) fn solid_location(&self, body: BodyId, tooth: u32, [x, y, z]: [f64; 3]) -> Location {
        Location { axial: Some(z), ..self.location(body, tooth, [x, y]) }
    }

    /// Returns the cell forces on a body of a three-dimensional model, on its own surfaces.
    pub(crate) fn segment_loads(self, body: BodyId) -> Vec<SegmentLoad> {
        let mut loads = Vec::new();
        for (Contact { patch, .. }, side) in self.contacts_on(body) {
            let ContactGrid::Solid(grid) = &patch.grid else { continue };
            let chart = Chart { tooth: patch.teeth[side], surface: patch.surfaces[side] };
            let loaded = grid.cells.iter().zip(&patch.forces).filter(|(_, force)| **force > 0.0);
            loads.extend(loaded.map(|(cell, &force)| SegmentLoad {
                chart,
                segment: cell.segment(side),
                force,
            }));
        }
        loads
    }

    /// Returns the cell forces on a body of a plane model, on its own surfaces.
    pub(crate) fn surface_loads(self, body: BodyId) -> Vec<SurfaceLoad> {
        let mut loads = Vec::new();
        for (Contact { patch, .. }, side) in self.contacts_on(body) {
            let chart = Chart { tooth: patch.teeth[side], surface: patch.surfaces[side] };
            let loaded = patch.cells().iter().zip(&patch.forces).filter(|(_, force)| **force > 0.0);
            loads.extend(loaded.map(|(cell, &force)| SurfaceLoad { chart, s: cell.loaded_at[side], force }));
        }
        loads
    }
}

/// Force on a part of the face of the first body, uniform along it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct AxialLoad {
    /// Ends along the axis of the first body, ascending, m from the middle of its face.
    pub ends: [f64; 2],
    /// Normal force, N.
    pub force: f64,
}

/// Contact patch of two surfaces, loaded or not.
#[derive(Clone, Copy)]
pub struct Contact<'a> {
    pub(super) at: Equilibrium<'a>,
    pub(super) patch: &'a ContactPatch,
}

/// Slice: part of a patch along the contact line, over its whole width across. A plane model has
/// one, as wide as the face.
#[derive(Clone, Debug, PartialEq)]
pub struct Slice {
    /// Length along the contact line, m.
    pub length: f64,
    /// Normal force, N.
    pub force: f64,
    /// Largest pressure across the slice in the flank zone, Pa; see [`Zone`].
    pub pressure: f64,
    /// Largest pressure across the slice in the edge zone, Pa; 0 if that is unloaded.
    pub edge_pressure: f64,
    /// Location in ground coordinates, m.
    pub point: [f64; 3],
    /// Locations on both bodies.
    pub locations: [Option<Location>; 2],
}

impl Slice {
    /// Returns the line load, N/m.
    pub fn line_load(&self) -> f64 {
        self.force / self.length
    }
}

impl Contact<'_> {
    /// Returns the surface pair.
    pub fn pair(&self) -> PairId {
        PairId(self.patch.pair)
    }

    /// Returns the two bodies.
    pub fn bodies(&self) -> [BodyId; 2] {
        self.at.system.scene.pairs[self.patch.pair].bodies
    }

    /// Returns the tooth of each body.
    pub fn teeth(&self) -> [u32; 2] {
        self.patch.teeth
    }

    /// Returns the width to which the forces refer, m; 1 in three dimensions.
    pub(super) fn width(&self) -> f64 {
        self.at.system.width(self.bodies()[0].0)
    }

    /// Returns the normal force, N.
    pub fn force(&self) -> f64 {
        self.width() * self.patch.force()
    }

    /// Returns the common normal of the surfaces in ground coordinates, out of the first body.
    pub fn normal(&self) -> [f64; 3] {
        match &self.patch.grid {
            ContactGrid::Plane { frame, .. } => [frame.normal[0], frame.normal[1], 0.0],
            ContactGrid::Solid(grid) => grid.frame.normal,
        }
    }

    /// Returns the force of the patch on the body of a side and its moment about that body's axis
    /// of rotation, along ground axes: N and N m, in the order of [`calyx_model::dof::DOF_NAMES`].
    pub fn wrench(&self, side: usize) -> [f64; 6] {
        let origin = self.at.origin(self.bodies()[side]);
        self.patch.wrench(side, origin, self.width())
    }

    /// Returns the centres of the loaded cells in ground coordinates (m), with their forces (N).
    pub(super) fn centres(&self) -> Vec<([f64; 3], f64)> {
        let centre = |cell: usize| match &self.patch.grid {
            ContactGrid::Plane { frame, cells, .. } => {
                let [low, high] = cells[cell].x;
                let along = 0.5 * (low + high);
                let [x, y] = [0, 1].map(|axis| frame.point[axis] + along * frame.tangent[axis]);
                [x, y, 0.0]
            }
            ContactGrid::Solid(grid) => grid.cells[cell].point,
        };
        let loaded = self.patch.forces.iter().enumerate().filter(|(_, force)| **force > 0.0);
        loaded.map(|(cell, force)| (centre(cell), self.width() * force)).collect()
    }

    /// Returns the moment of the patch on the body of a side about the body's own axis, N m.
    pub fn torque(&self, side: usize) -> f64 {
        let [.., x, y, z] = self.wrench(side);
        let axis = self.at.system.axes(self.bodies()[side].0, self.at.time())[2];
        x * axis[0] + y * axis[1] + z * axis[2]
    }

    /// Returns the slices of the patch along the contact line, including those without load; none
    /// if there is no pressure.
    pub fn slices(&self) -> Vec<Slice> {
        match &self.patch.grid {
            ContactGrid::Plane { frame, .. } => {
                let Some(peak) = self.patch.peak() else { return Vec::new() };
                let [x, y] = frame.point;
                let [pressure, edge_pressure] = [Zone::Flank, Zone::Edge]
                    .map(|zone| self.patch.peak_in(zone).map_or(0.0, |peak| peak.pressure));
                vec![Slice {
                    length: self.width(),
                    force: self.force(),
                    pressure,
                    edge_pressure,
                    point: [x, y, 0.0],
                    locations: [0, 1].map(|side| self.location(side, peak.cell)),
                }]
            }
            ContactGrid::Solid(grid) => {
                let pressures = self.patch.pressures();
                let peaks = [Zone::Flank, Zone::Edge].map(|zone| slice_peaks_in(grid, &pressures, zone));
                let slice = |(index, slice): (usize, &solid::Slice)| {
                    let [pressure, edge_pressure] = [0, 1].map(|zone: usize| peaks[zone][index].pressure);
                    Some(Slice { pressure, edge_pressure, ..self.slice(grid, &slice.cells)? })
                };
                grid.slices.iter().enumerate().filter_map(slice).collect()
            }
        }
    }

    /// Returns the forces of the loaded cells with their extents along the face of the first body;
    /// none in a plane model, where the load is uniform along the face.
    pub(super) fn axial_loads(&self) -> Vec<AxialLoad> {
        let ContactGrid::Solid(grid) = &self.patch.grid else { return Vec::new() };
        let load = |(index, &force): (usize, &f64)| {
            let middle = self.location(0, index)?.axial?;
            let half = 0.5 * grid.cells[index].axial[0];
            Some(AxialLoad { ends: [middle - half, middle + half], force })
        };
        let loaded = self.patch.forces.iter().enumerate().filter(|(_, force)| **force > 0.0);
        loaded.filter_map(load).collect()
    }

    /// Returns the length of the contact line, m, including unloaded parts beyond the slices; the
    /// width in a plane model.
    pub fn line_length(&self) -> f64 {
        let beyond = match &self.patch.grid {
            ContactGrid::Plane { .. } => 0.0,
            ContactGrid::Solid(grid) => (grid.line - (grid.along[1] - grid.along[0])).max(0.0),
        };
        self.slices().iter().map(|slice| slice.length).sum::<f64>() + beyond
    }

    /// Combines neighbouring cells across a three-dimensional patch into a slice, without their
    /// pressures, located at the cell with the largest force; `None` without cells.
    fn slice(&self, grid: &Grid, cells: &Range<usize>) -> Option<Slice> {
        let force = |cell: usize| self.patch.forces[cell];
        let largest = cells.clone().max_by(|&a, &b| force(a).total_cmp(&force(b)).then(b.cmp(&a)))?;
        let total: f64 = cells.clone().map(force).sum();
        // Side faces cut cells at the ends; the loaded cell determines the length of a slice.
        let length = |cell: usize| grid.cells[cell].size[1];
        let length = match total > 0.0 {
            true => cells.clone().map(|cell| force(cell) * length(cell)).sum::<f64>() / total,
            false => cells.clone().map(length).sum::<f64>() / cells.len() as f64,
        };
        let locations = [0, 1].map(|side| self.location(side, largest));
        let (pressure, edge_pressure) = (0.0, 0.0);
        let point = grid.cells[largest].point;
        Some(Slice { length, force: total, pressure, edge_pressure, point, locations })
    }

    /// Returns the largest pressure (Pa) of a zone and its location on the body of a side; `None`
    /// if there is no pressure.
    pub fn peak(&self, side: usize, zone: Zone) -> Option<(f64, Option<Location>)> {
        let Peak { pressure, cell, .. } = self.patch.peak_in(zone)?;
        Some((pressure, self.location(side, cell)))
    }

    /// Returns points at which the patch slides, with their locations on the body of a side: loaded
    /// slices, or contact points of rigid surfaces.
    pub(super) fn sliding_points(&self, side: usize) -> Vec<([f64; 3], Option<Location>)> {
        if self.at.system.rigid {
            return vec![(self.touching_point(), self.touching_location(side))];
        }
        let loaded = self.slices().into_iter().filter(|slice| slice.force > 0.0);
        loaded.map(|Slice { point, locations, .. }| (point, locations[side].clone())).collect()
    }

    /// Returns the locations of the loaded cells on the body of a side, with their pressures, Pa.
    /// Rigid surfaces have one location, without pressure.
    pub fn loaded(&self, side: usize) -> Vec<(Location, f64)> {
        if self.at.system.rigid {
            return self.touching_location(side).map(|place| (place, 0.0)).into_iter().collect();
        }
        let pressures = self.patch.pressures().into_iter().enumerate();
        let loaded = pressures.filter(|(_, pressure)| *pressure > 0.0);
        loaded.filter_map(|(cell, pressure)| Some((self.location(side, cell)?, pressure))).collect()
    }

    /// Returns the sliding velocity of the first body's surface relative to the second's at a point
    /// of the patch (ground coordinates, m), m/s. It follows from the prescribed motions. The rates
    /// of deflections are neglected, which are smaller by a factor of about a thousand.
    pub fn sliding(&self, point: [f64; 3]) -> [f64; 3] {
        let [first, second] = self.bodies().map(|body| self.at.velocity(body, point));
        let relative = [0, 1, 2].map(|axis| first[axis] - second[axis]);
        let normal = self.normal();
        let closing: f64 = relative.iter().zip(normal).map(|(velocity, normal)| velocity * normal).sum();
        [0, 1, 2].map(|axis| relative[axis] - closing * normal[axis])
    }

    /// Returns whether the surfaces are pressed together, or touch in the rigid-body limit.
    pub fn touches(&self) -> bool {
        self.at.system.rigid || self.force() > 0.0
    }

    /// Returns the location, on the body of a side, at which rigid surfaces touch.
    fn touching_location(&self, side: usize) -> Option<Location> {
        let body = self.bodies()[side];
        let (point, origin) = (self.touching_point(), self.at.origin(body));
        let axes = self.at.system.axes(body.0, self.at.time());
        let from: [f64; 3] = [0, 1, 2].map(|k: usize| point[k] - origin[k]);
        let [x, y, z] = axes.map(|axis| (0..3).map(|k| axis[k] * from[k]).sum());
        let tooth = self.patch.teeth[side];
        Some(match &self.patch.grid {
            ContactGrid::Plane { .. } => self.at.location(body, tooth, [x, y]),
            ContactGrid::Solid(_) => self.at.solid_location(body, tooth, [x, y, z]),
        })
    }

    fn touching_point(&self) -> [f64; 3] {
        match &self.patch.grid {
            ContactGrid::Plane { frame, .. } => [frame.point[0], frame.point[1], 0.0],
            ContactGrid::Solid(grid) => grid.frame.point,
        }
    }

    /// Returns the location of a cell on one of its two surfaces.
    pub(super) fn location(&self, side: usize, cell: usize) -> Option<Location> {
        let (body, surface, tooth) = (self.bodies()[side], self.patch.surfaces[side], self.patch.teeth[side]);
        match (&self.at.system.bodies, &self.patch.grid) {
            (Bodies::Plane(bodies), ContactGrid::Plane { cells, .. }) => {
                let profile = bodies.structures[body.0].as_ref()?.profile(surface);
                Some(self.at.location(body, tooth, profile.at(cells[cell].s[side]).position))
            }
            (Bodies::Solid(bodies), ContactGrid::Solid(grid)) => {
                let [u, v] = grid.cells[cell].places[side];
                let surface = bodies.structures[body.0].as_ref()?.surface(surface);
                Some(self.at.solid_location(body, tooth, surface.at(u, v).position))
            }
            _ => None,
        }
    }
}
