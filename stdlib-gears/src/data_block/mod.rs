//! Data blocks of gears and meshes for comparison with a drawing or with another program: the
//! symbols of ISO 21771:2007 and DIN 21773:2014, in the order of a drawing.
//!
//! All values come from the geometry that an analysis uses ([`crate::derived_quantities`],
//! [`MeshGeometry`]). The library module `iso21771` computes the same quantities from gear data;
//! tests compare both.

mod entries;
mod flanks;
mod gear;
mod mesh;
mod text;

pub use entries::{DisplayUnit, Entry, EntryKind, GEAR_ENTRIES, MEMBER_ENTRIES, MESH_ENTRIES, Value};
pub use flanks::{Amount, Deviations, FlankCharts, FlankTraces, PointOfProfile, Trace};

pub(crate) use gear::normal_angle;

use crate::flank_tolerances::FlankTolerances;
use crate::host::{LengthUnit, ModelHost};
use crate::mesh_geometry::MeshGeometry;
use crate::prototype::GearPrototype;
use crate::stated_geometry::StatedGeometry;
use std::collections::BTreeMap;
use std::fmt;
use std::sync::Arc;

/// Largest number of gears without a body that have a data block, for models without bodies.
const MOST_UNMOUNTED: usize = 8;
/// Relative difference of centre distances up to which two meshes of the same gears are equal.
const SAME_DISTANCE: f64 = 1e-9;

/// Values by the keys of their entries. A quantity without a value has no entry.
pub type Values = BTreeMap<&'static str, Value>;

/// The part of a drawing's data that the geometry of the teeth does not contain.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StatedData {
    /// Name of the basic rack.
    pub rack: Option<&'static str>,
    /// Coefficients of addendum and dedendum of the basic rack, in modules of the rack.
    pub heights: Option<[f64; 2]>,
    /// Name of the material.
    pub material: Option<&'static str>,
    /// Difference of the transverse tooth thickness from its nominal value, m.
    pub allowance: f64,
    /// Upper and lower allowance of the normal tooth thickness, m.
    pub allowances: [Option<f64>; 2],
    /// Limit of the allowances that the gear has.
    pub thickness_limit: Option<&'static str>,
    /// Number of teeth of the span measurement.
    pub span_teeth: Option<u32>,
    /// Diameter of the measuring balls, m.
    pub ball: Option<f64>,
    /// Tolerances of the accuracy grade.
    pub tolerances: Option<FlankTolerances>,
    /// Geometry as stated, for ratings.
    pub geometry: StatedGeometry,
}

/// Gears and meshes of a model. Their data are computed on request.
#[derive(Clone, Default)]
pub struct DataBlock {
    gears: Vec<MountedGear>,
    meshes: Vec<Meshing>,
    length_unit: LengthUnit,
}

/// Gear with the bodies that carry it.
#[derive(Clone)]
struct MountedGear {
    gear: Arc<GearPrototype>,
    bodies: Vec<String>,
}

/// Mesh of two gears, by their indices in [`DataBlock::gears`].
#[derive(Clone)]
struct Meshing {
    gears: [usize; 2],
    geometry: MeshGeometry,
    bodies: Vec<[String; 2]>,
}

impl Meshing {
    /// Returns the mesh as one of the gear in a column; `None` if the gear does not take part.
    fn of_gear(&self, column: usize) -> Option<flanks::MeshOfGear<'_>> {
        let member = self.gears.iter().position(|gear| *gear == column)?;
        let mate = self.bodies.first().map_or("", |bodies| &bodies[1 - member]);
        Some(flanks::MeshOfGear { geometry: self.geometry, member, mate })
    }
}

/// Data of a gear.
#[derive(Clone, Debug, PartialEq)]
pub struct GearColumn {
    /// Names of the bodies that carry the gear.
    pub bodies: Vec<String>,
    /// Values of [`GEAR_ENTRIES`].
    pub values: Values,
}

/// Data of a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshColumns {
    /// Names of the bodies of each mesh with these data.
    pub bodies: Vec<[String; 2]>,
    /// Values of [`MESH_ENTRIES`].
    pub common: Values,
    /// Values of [`MEMBER_ENTRIES`] for the first and the second gear.
    pub members: [Values; 2],
}

impl fmt::Debug for DataBlock {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let bodies: Vec<_> = self.gears.iter().map(|gear| &gear.bodies).collect();
        f.debug_struct("DataBlock").field("bodies", &bodies).finish_non_exhaustive()
    }
}

impl DataBlock {
    /// Collects the gears of all bodies and their meshes. Bodies with the same gear share a column,
    /// as do meshes of the same gears at the same centre distance. If no body carries a gear, the
    /// gears of the model are listed in the order of their creation.
    pub fn of(host: &ModelHost) -> DataBlock {
        let mut block = DataBlock { length_unit: host.length_unit, ..DataBlock::default() };
        // Column of each gear of the host.
        let mut columns: BTreeMap<usize, usize> = BTreeMap::new();
        for (body, gear) in host.scene.bodies.iter().zip(&host.body_gears) {
            let Some((index, gear)) =
                gear.and_then(|gear| Some((gear, host.gears.get(gear)?.cylindrical()?)))
            else {
                continue;
            };
            let column = *columns.entry(index).or_insert_with(|| {
                block.gears.push(MountedGear { gear: gear.clone(), bodies: Vec::new() });
                block.gears.len() - 1
            });
            if let Some(column) = block.gears.get_mut(column) {
                column.bodies.push(body.name.clone());
            }
        }
        if block.gears.is_empty() {
            let cylindrical =
                host.gears.iter().enumerate().filter_map(|(index, gear)| Some((index, gear.cylindrical()?)));
            let unmounted = cylindrical.take(MOST_UNMOUNTED);
            block.gears = unmounted
                .map(|(index, gear)| MountedGear {
                    gear: gear.clone(),
                    bodies: vec![format!("gear {}", index + 1)],
                })
                .collect();
        }
        for mesh in &host.mesh_records {
            let column = |body: usize| columns.get(&(*host.body_gears.get(body)?)?).copied();
            let name = |body: usize| host.scene.bodies.get(body).map(|body| body.name.clone());
            let [first, second] = mesh.bodies;
            if let (Some(a), Some(b), Some(first), Some(second)) =
                (column(first), column(second), name(first), name(second))
            {
                block.add_mesh([a, b], mesh.geometry, [first, second]);
            }
        }
        block
    }

    fn add_mesh(&mut self, gears: [usize; 2], geometry: MeshGeometry, bodies: [String; 2]) {
        let same = |mesh: &&mut Meshing| {
            let [a, b] = [mesh.geometry.center_distance, geometry.center_distance];
            mesh.gears == gears && (a - b).abs() <= SAME_DISTANCE * a.abs()
        };
        match self.meshes.iter_mut().find(same) {
            Some(mesh) if mesh.bodies.contains(&bodies) => {}
            Some(mesh) => mesh.bodies.push(bodies),
            None => self.meshes.push(Meshing { gears, geometry, bodies: vec![bodies] }),
        }
    }

    /// Returns true if the model has no gears.
    pub fn is_empty(&self) -> bool {
        self.gears.is_empty()
    }

    /// Returns the unit of lengths for display.
    pub fn length_unit(&self) -> LengthUnit {
        self.length_unit
    }

    /// Computes the data of the gears. Mass and inertia require the mesh of a section.
    pub fn gears(&self) -> Vec<GearColumn> {
        let column = |mounted: &MountedGear| GearColumn {
            bodies: mounted.bodies.clone(),
            values: gear::values(&mounted.gear, self.length_unit),
        };
        self.gears.iter().map(column).collect()
    }

    /// Computes the traces of modified flanks: one entry per gear, `None` without modifications.
    pub fn flank_charts(&self) -> Vec<Option<FlankCharts>> {
        let charts = |(column, mounted): (usize, &MountedGear)| {
            let meshes: Vec<_> = self.meshes.iter().filter_map(|mesh| mesh.of_gear(column)).collect();
            FlankCharts::of(&mounted.gear, &meshes)
        };
        self.gears.iter().enumerate().map(charts).collect()
    }

    /// Computes the data of the meshes.
    pub fn meshes(&self) -> Vec<MeshColumns> {
        let columns = |mesh: &Meshing| {
            let [first, second] = mesh.gears.map(|gear| self.gears.get(gear));
            let (common, members) = mesh::values([&first?.gear, &second?.gear], &mesh.geometry);
            Some(MeshColumns { bodies: mesh.bodies.clone(), common, members })
        };
        self.meshes.iter().filter_map(columns).collect()
    }

    /// Returns true if an internal gear is among the gears. Its profile shift coefficient has the
    /// sign of `profile_shift` of `gears.internal`.
    pub fn has_internal_gears(&self) -> bool {
        self.gears.iter().any(|mounted| mounted.gear.form().internal)
    }

    /// Returns the data as text: a table of all gears with a column each, and a table of each mesh.
    /// The text is empty if the model has no gears.
    pub fn text(&self) -> String {
        text::text(self)
    }
}

/// Remark about the sign of the profile shift of internal gears.
pub const INTERNAL_SHIFT: &str =
    "x of an internal gear is positive outwards, as in `gears.internal`; ISO 21771 has the opposite sign";
