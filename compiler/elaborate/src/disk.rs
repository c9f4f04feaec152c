//! Predicted disk space of the files that a run writes for each position.

use crate::plan::Planned;
use crate::shown::of_thousands;
use calyx_report::directory::Details;
use calyx_report::view::content::{BYTES_PER_CELL, BYTES_PER_PART};
use calyx_report::view::mesh::{BYTES_PER_PLANE_POINT, BYTES_PER_POINT};

/// Predicted disk space of the files with shapes, poses, contacts and meshes. Measured files of the
/// examples have between half and twice these sizes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PlannedDisk {
    /// Files of the viewer, which every run writes, bytes.
    pub view: f64,
    /// Files of the viewer and of ParaView with the meshes that `--vtu` adds, bytes.
    pub with_meshes: f64,
}

/// Bytes of the shape of a part. Measured: 95 to 150 kB.
const BYTES_PER_SHAPE: f64 = 120e3;
/// Bytes of a position without parts, contacts and meshes.
const BYTES_PER_POSITION: f64 = 1200.0;
/// Bytes of the mesh of an elastic shaft at a position. Measured: 50 kB.
const BYTES_PER_SHAFT: f64 = 50e3;
/// Bytes of the header of a position for each tooth with a mesh.
const BYTES_PER_TOOTH: f64 = 310.0;
/// Fraction of the contact cells that are loaded. Measured: 0.26 to 0.38.
const LOADED: f64 = 0.35;
/// Number of teeth around a contact that have meshes in three dimensions.
const TEETH_PER_CONTACT: usize = 14;
/// Number of points per element of a solid and of a plane model. Measured: 1.54 and 1.07.
const POINTS_PER_ELEMENT: [f64; 2] = [1.54, 1.07];
/// Bytes of a VTU file per point of a solid and of a plane model. Measured: 40 and 69.
const BYTES_OF_VTU: [f64; 2] = [40.0, 69.0];

impl Planned {
    /// Predicts the disk space of a run.
    pub fn disk(&self) -> PlannedDisk {
        let count = self.work.task().positions;
        if count == 0 {
            return PlannedDisk::default();
        }
        let own = |left_out: bool| usize::from(!left_out);
        let gears: usize = self.bodies.iter().map(|body| own(body.left_out || body.section)).sum();
        let bearings = self.bearings.iter().map(|bearing| own(bearing.left_out)).sum::<usize>();
        let shafts: usize = self.shafts.iter().map(|shaft| own(shaft.left_out)).sum();
        let parts = gears + bearings + shafts;
        let is_elastic = !matches!(self.fidelity, "rigid");
        let elastic =
            self.shafts.iter().filter(|shaft| is_elastic && !shaft.left_out && !shaft.rigid).count();
        let position = BYTES_PER_POSITION
            + (BYTES_PER_PART * parts) as f64
            + LOADED * (BYTES_PER_CELL * self.cells_in_contact()) as f64
            + BYTES_PER_SHAFT * elastic as f64;
        let [meshes, vtu] = self.mesh_bytes();
        let shapes = BYTES_PER_SHAPE * (gears + shafts) as f64;
        let recorded = count.min(Details::default().positions()) as f64;
        PlannedDisk {
            view: shapes + recorded * position,
            with_meshes: shapes + count as f64 * (position + meshes + vtu),
        }
    }

    /// Returns the bytes of the meshes of a position, in the files of the viewer and of ParaView.
    fn mesh_bytes(&self) -> [f64; 2] {
        let kind = usize::from(!self.three_dimensional);
        let per_point = if self.three_dimensional { BYTES_PER_POINT } else { BYTES_PER_PLANE_POINT } as f64;
        let mut bytes = [0.0; 2];
        for (bodies, size) in self.sizes() {
            for body in bodies {
                let meshes = self.meshes.iter().filter(|mesh| mesh.bodies.iter().any(|one| one == body));
                let around = TEETH_PER_CONTACT * meshes.filter(|mesh| !mesh.back_sides).count();
                let sectors = size.sectors as usize;
                let teeth = if self.three_dimensional { sectors.min(around) } else { sectors } as f64;
                let points = POINTS_PER_ELEMENT[kind] * size.elements as f64;
                bytes[0] += teeth * (points * per_point + BYTES_PER_TOOTH);
                bytes[1] += teeth * points * BYTES_OF_VTU[kind];
            }
        }
        for body in self.elastic_bodies.iter().filter(|body| body.condensed && !body.left_out) {
            bytes[0] += (body.size.nodes * BYTES_PER_POINT) as f64;
            bytes[1] += body.size.nodes as f64 * BYTES_OF_VTU[0];
        }
        bytes
    }
}

impl PlannedDisk {
    /// Returns the prediction as a line of a plan.
    pub fn text(&self) -> String {
        let [view, with_meshes] =
            [self.view, self.with_meshes].map(|bytes| of_thousands(bytes, [" kB", " MB", " GB", " TB"]));
        format!("disk space of the view about {view}, with --vtu {with_meshes}")
    }
}
