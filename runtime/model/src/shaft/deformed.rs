//! Deformed shaft as a mesh for pictures, from the motions and forces of its stations: sections
//! remain plane and circular, and stresses are the nominal ones.

use super::{SectionForces, Shaft, Six};
use crate::elastic_body::{CellShape, DeformedElasticBody};
use calyx_elastic::model::SolidShape;
use std::f64::consts::TAU;

/// Number of points around a section.
const AROUND: usize = 24;
/// Length of a cell along the shaft relative to the diameter.
const CELL_LENGTH: f64 = 0.25;
/// Maximum number of cells along a stretch without steps and stations.
const MOST_CELLS: usize = 24;

impl Shaft {
    /// Returns the shaft deformed by motions of its stations under forces of gears, bearings and
    /// couplings at them, in its own coordinates. Displacements are without the mean rotation of
    /// the stations about the axis, and stresses are nominal ([`Shaft::section_stress`]).
    pub fn deformed(&self, stations: &[f64], motions: &[Six], forces: &[Six]) -> DeformedElasticBody {
        let mean_rotation = motions.iter().map(|motion| motion[5]).sum::<f64>() / motions.len() as f64;
        let mut found = DeformedElasticBody {
            points: Vec::new(),
            cells: Vec::new(),
            displacements: Vec::new(),
            stresses: Vec::new(),
            stress_errors: Vec::new(),
        };
        for ends in self.stretches(stations).windows(2) {
            let (start, length) = (ends[0], ends[1] - ends[0]);
            let is_solid =
                [(ends[0], true), (ends[1], false)].iter().all(|&at| self.diameters_on(at)[1] == 0.0);
            // A whole number of cells may be larger by rounding.
            let cells = (length / (CELL_LENGTH * self.diameters_at(start)[0]) - 1e-6).ceil();
            let cells = (cells as usize).clamp(1, MOST_CELLS);
            let first = found.points.len();
            for ring in 0..=cells {
                // The last ring is exactly at the end, where another segment may start.
                let z = if ring == cells { ends[1] } else { start + length * (ring as f64 / cells as f64) };
                let at = (z, ring == 0);
                let mut motion = self.motion_at(stations, motions, z);
                motion[5] -= mean_rotation;
                let forces = self.section_forces(stations, forces, at);
                let [outside, bore] = self.diameters_on(at).map(|diameter| 0.5 * diameter);
                let around = |radius: f64| {
                    (0..AROUND).map(move |k| {
                        let (sine, cosine) = (TAU * k as f64 / AROUND as f64).sin_cos();
                        [radius * cosine, radius * sine]
                    })
                };
                let inside = around(bore).take(if is_solid { 1 } else { AROUND });
                for [x, y] in around(outside).chain(inside) {
                    found.points.push([x, y, z]);
                    let [ux, uy, uz, tx, ty, tz] = motion;
                    found.displacements.push([ux - tz * y, uy + tz * x, uz + tx * y - ty * x]);
                    found.stresses.push(self.section_stress(at, &forces, [x, y]));
                }
            }
            let points = if is_solid { AROUND + 1 } else { 2 * AROUND };
            for ring in 0..cells {
                found.cells.extend(cells_between([0, 1].map(|k| first + (ring + k) * points), is_solid));
            }
        }
        found.stress_errors = vec![f64::NAN; found.points.len()];
        found
    }

    /// Returns the ends of the stretches without steps and stations inside, ascending, m.
    fn stretches(&self, stations: &[f64]) -> Vec<f64> {
        let slack = super::SAME_POSITION * self.length();
        let mut all: Vec<f64> = self.ends.clone();
        let is_inside = |z: &&f64| self.ends.iter().all(|end| (**z - end).abs() > slack);
        all.extend(stations.iter().filter(is_inside));
        all.sort_by(f64::total_cmp);
        all
    }

    /// Returns the outside diameter and the bore on one side of a position, m.
    fn diameters_on(&self, (z, after): (f64, bool)) -> [f64; 2] {
        self.section(z, after).diameters()
    }

    /// Returns the outside diameter at a position, m; the smaller one at a step.
    pub fn outside_diameter(&self, at: f64) -> f64 {
        [false, true].map(|after| self.diameters_on((at, after))[0]).into_iter().fold(f64::INFINITY, f64::min)
    }

    /// Returns the nominal stress at a point of a section, xx, yy, zz, yz, zx, xy in Pa: of
    /// bending, axial force and torsion. The part outside of the diameter that carries load has the
    /// stress of that diameter. Stresses of transverse forces are not included.
    pub fn section_stress(
        &self,
        (z, after): (f64, bool),
        forces: &SectionForces,
        [x, y]: [f64; 2],
    ) -> [f64; 6] {
        let section = self.section(z, after);
        let carrying = section.carrying_radii()[1];
        let part = (carrying / x.hypot(y)).min(1.0) / carrying;
        let [x, y] = [x * part, y * part];
        let [_, _, axial, mx, my, torque] = forces.0;
        let normal = axial / section.area() + (mx * y - my * x) / section.bending_modulus();
        let shear = torque / (2.0 * section.bending_modulus());
        [0.0, 0.0, normal, shear * x, -shear * y, 0.0]
    }
}

/// Returns the cells between two neighbouring rings, by their first points: the outside circle,
/// then the bore or the centre.
fn cells_between(rings: [usize; 2], is_solid: bool) -> impl Iterator<Item = (CellShape, Vec<usize>)> {
    (0..AROUND).map(move |k| {
        let next = (k + 1) % AROUND;
        if is_solid {
            let corners = rings.map(|ring| [ring + AROUND, ring + k, ring + next]);
            (CellShape::Solid(SolidShape::Wedge6), corners.concat())
        } else {
            let corners = rings.map(|ring| [ring + AROUND + k, ring + k, ring + next, ring + AROUND + next]);
            (CellShape::Solid(SolidShape::Hexahedron8), corners.concat())
        }
    })
}
