//! Teeth whose section varies along the face, without a mesh: those of bevel, hypoid and face
//! gears.
//!
//! The model is that of [`super::AnalyticSolid`]: slices with the compliance of a cantilever on a
//! ring, coupled in shear along the face, and the half-space near loads. Sections are normal to the
//! pitch cone (back cones), developed into a plane (Tredgold). Each has dimensions of its own;
//! [`super::sections`], [`super::ring_family`] and [`super::face_coupling`] contain the parts that
//! depend on two sections. Flanks need not be mirror images of each other: the centre line of the
//! tooth is inclined to the radius of the ring then.
//!
//! Side faces are the cones of the sections at the ends of the face. The half-space has images in
//! the planes that touch them, as for structures with a mesh.

use super::cantilever::{Flexibility, RootLoad};
use super::face_coupling::{FaceCoupling, Stretch};
use super::ring_family::{Moved, Relation, RingFamily};
use super::sections::{At, BeamFamily, Dimensions, at_position};
use super::solid::mean_inverse;
use super::{RootStation, ToothSection};
use crate::Chart;
use crate::solid::{Mirror, SegmentLoad, SolidStructure, SurfaceSegment, SurfaceStress};
use crate::surface::{Surface, SurfacePoint};
use calyx_fe::material::{Material, Plane};
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::vec3::{Vector, dot, length, minus, plus, scaled, unit};
use std::f64::consts::PI;
use std::sync::Arc;

/// Number of intervals of the table of side faces.
const SIDE_INTERVALS: usize = 16;

/// Point of a surface with its coordinates in a section of the body.
#[derive(Clone, Copy, Debug)]
pub struct SectionPoint {
    /// Point of the surface.
    pub point: SurfacePoint,
    /// Coordinates in the developed section, m.
    pub place: [f64; 2],
    /// Unit vectors along both coordinates, and normal to the section, towards increasing v.
    pub axes: [Vector; 3],
}

/// Surface of a body whose sections are developable: `v` is constant in a section, and the length
/// normal to the sections.
pub trait SectionedSurface: Surface {
    /// Returns the point at `u`, `v`.
    fn in_section(&self, u: f64, v: f64) -> SectionPoint;

    /// Returns the surface without its sections.
    fn as_surface(self: Arc<Self>) -> Arc<dyn Surface>;
}

/// Teeth of varying section around a rim, with closed-form compliances.
pub struct TaperedSolid {
    flanks: [Arc<dyn SectionedSurface>; 2],
    sides: [SideFaces; 2],
    mirrors: Vec<Mirror>,
    face: [f64; 2],
    dimensions: Dimensions,
    beams: BeamFamily,
    rings: RingFamily,
    slices: FaceCoupling,
    stations: Vec<[RootStation; 2]>,
    /// Positions of the sections along the face, as points, and their heights, m.
    at_stations: Vec<(Stretch, f64)>,
    teeth: u32,
    modulus: f64,
    /// Reference length in the half-plane's logarithm as a fraction of the depth beneath a load.
    depth_ratio: f64,
}

/// Side faces along the ends of a flank: points and unit normals into the body, at the start and
/// the end of `v`.
struct SideFaces {
    range: [f64; 2],
    planes: [Vec<[Vector; 2]>; 2],
}

/// Stretch of a flank under a unit inward force, in its section.
struct Place {
    /// Flank.
    side: usize,
    /// Coordinates and length. They and the flank decide the order in which two places are
    /// evaluated.
    key: [f64; 3],
    position: Vector,
    /// Length of the stretch on the flank, m.
    length: f64,
    /// Length on the flank per length along the face.
    stretch: f64,
    /// Distances from both side faces, m.
    heights: [f64; 2],
    at: At,
    along: Stretch,
    /// Cosine of the spiral angle.
    lean: f64,
    /// Load on a ring of unit radius.
    load: RootLoad,
    /// Load on a cantilever of unit length.
    bending: RootLoad,
    /// Fraction of the height up to which the load acts.
    crossing: f64,
    /// Flexibility of the cantilever up to there, by section.
    beam: Vec<Flexibility>,
    /// Length in the half-plane's logarithm of this load, m.
    depth: f64,
}

impl SideFaces {
    fn of(flank: &dyn SectionedSurface) -> SideFaces {
        let [range, ends] = flank.range();
        let plane = |side: usize, k: usize| {
            let u = range[0] + (range[1] - range[0]) * k as f64 / SIDE_INTERVALS as f64;
            let SectionPoint { point, axes, .. } = flank.in_section(u, ends[side]);
            [point.position, scaled(axes[2], [1.0, -1.0][side])]
        };
        SideFaces { range, planes: [0, 1].map(|side| (0..=SIDE_INTERVALS).map(|k| plane(side, k)).collect()) }
    }

    /// Returns the distance of a point at `u` from the plane that touches a side face there, m.
    fn height(&self, side: usize, u: f64, position: Vector) -> f64 {
        let [point, inward] = self.plane(side, u);
        dot(minus(position, point), inward).max(0.0)
    }

    fn plane(&self, side: usize, u: f64) -> [Vector; 2] {
        let [from, to] = self.range;
        let along = ((u - from) / (to - from)).clamp(0.0, 1.0) * SIDE_INTERVALS as f64;
        let index = (along as usize).min(SIDE_INTERVALS - 1);
        let part = along - index as f64;
        let [low, high] = [0, 1].map(|next| self.planes[side][index + next]);
        let [point, normal] = [0, 1].map(|k: usize| plus(scaled(low[k], 1.0 - part), scaled(high[k], part)));
        [point, unit(normal)]
    }

    fn mirror(&self, side: usize, u: f64) -> Mirror {
        let [point, inward] = self.plane(side, u);
        Mirror { point, normal: scaled(inward, -1.0) }
    }
}

impl TaperedSolid {
    /// Builds the body. `flanks` are those of tooth 0, counter-clockwise and clockwise, and
    /// `sections` the sections at equal distances from one end of the face to the other. In the
    /// developed sections all teeth take `part` of the full circle: the cosine of the pitch angle.
    pub fn new(
        flanks: [Arc<dyn SectionedSurface>; 2],
        sections: &[ToothSection],
        part: f64,
        material: Material,
    ) -> TaperedSolid {
        let [_, face] = flanks[0].range();
        let dimensions = Dimensions::new(sections);
        let count = sections.len();
        let along = |v: f64| At::new((v - face[0]) / (face[1] - face[0]), count);
        let plate = (2.0 / 3.0 * (1.0 - material.poissons_ratio)).sqrt();
        let slices = FaceCoupling::new(face, |v| {
            let section = dimensions.at(along(v));
            // Length along the tooth; along the face it is shorter.
            plate * section.height / 1.0f64.hypot(section.rise)
        });
        let v = |k: usize| face[0] + (face[1] - face[0]) * k as f64 / (count - 1).max(1) as f64;
        let at_stations =
            sections.iter().enumerate().map(|(k, of)| (slices.stretch(v(k), 0.0), of.height())).collect();
        let rings: Vec<_> = sections.iter().map(|section| section.ring).collect();
        let sides = [0, 1].map(|side: usize| SideFaces::of(flanks[side].as_ref()));
        let middle = 0.5 * (sides[0].range[0] + sides[0].range[1]);
        TaperedSolid {
            mirrors: [0, 1].map(|side| sides[0].mirror(side, middle)).to_vec(),
            beams: BeamFamily::new(sections, material),
            rings: RingFamily::new(&rings, part, material),
            stations: sections.iter().filter_map(|section| section.critical).collect(),
            teeth: rings.first().map_or(1, |ring| ring.sectors.max(1)),
            modulus: material.surface_modulus(Plane::Strain),
            depth_ratio: (-0.5 / (1.0 - material.poissons_ratio)).exp(),
            flanks,
            sides,
            face,
            dimensions,
            slices,
            at_stations,
        }
    }

    fn places(&self, chart: Chart, segments: &[SurfaceSegment]) -> Vec<Place> {
        segments.iter().filter_map(|segment| self.place(chart.surface as usize, segment)).collect()
    }

    fn place(&self, side: usize, segment: &SurfaceSegment) -> Option<Place> {
        let flank = self.flanks.get(side)?;
        let [u, v] = segment.place;
        let on = flank.in_section(u, v);
        let at = At::new((v - self.face[0]) / (self.face[1] - self.face[0]), self.at_stations.len());
        let section = self.dimensions.at(at);
        let lean = 1.0f64.hypot(section.rise).recip();
        let slant = section.rise * lean;
        // Coordinates relative to the middle of the root with the ring's radius along the first
        // axis, and the outward normal with its component along the face.
        let on_ring = |on: &SectionPoint| {
            let offset =
                rotated([on.place[0] - section.root[0], on.place[1] - section.root[1]], -section.radial);
            let [x, y, along] = on.axes.map(|axis| dot(on.point.normal, axis));
            let [out, across] = rotated([x, y], -section.radial);
            (offset, [out, across, along])
        };
        // The same in the normal section, with the tooth along the first axis.
        let on_tooth = |([x, y], [out, across, along]): ([f64; 2], [f64; 3])| {
            let against = lean * across - slant * along;
            [rotated([x, lean * y], -section.tilt), rotated([out, against], -section.tilt)]
        };
        let (offset, normal) = on_ring(&on);
        let against = lean * normal[1] - slant * normal[2];
        let [offset, [out, across]] = on_tooth((offset, normal));
        let moment = offset[1] * out - offset[0] * across;
        // By tractions on the longer arc of the transverse section.
        let load = RootLoad { axial: -normal[0], shear: -against, moment: moment / (lean * section.radius) };
        let bending = RootLoad { axial: -out, shear: -across, moment: moment / section.height };
        // Around a tip edge the forces enter the tooth where the edge begins, as in the plane.
        let edge = flank.edge_from().filter(|edge| u > *edge);
        let [[x, y], [out, against]] =
            edge.map_or([offset, [out, across]], |edge| on_tooth(on_ring(&flank.in_section(edge, v))));
        let tangent = out / against.abs().max(f64::MIN_POSITIVE);
        let crossing = ((x - y.abs() * tangent) / section.height).clamp(0.0, 1.0);
        let stretch = length(on.point.tangents[1]) / dot(on.point.tangents[1], on.axes[2]).abs();
        let position = on.point.position;
        Some(Place {
            side,
            key: [u, v, segment.length],
            position,
            length: stretch * segment.length,
            stretch,
            heights: [0, 1].map(|end| self.sides[side].height(end, u, position)),
            at,
            along: self.slices.stretch(v, segment.length),
            lean,
            load,
            bending,
            crossing,
            beam: self.beams.up_to(crossing, at),
            depth: self.depth_ratio * y.abs() * 1.0f64.hypot(tangent),
        })
    }

    /// Returns the compliance of the tooth without its ring, m/(N/m).
    fn between(one: &Place, other: &Place) -> f64 {
        let order = one.crossing.total_cmp(&other.crossing).then(one.compare(other));
        let [nearer, farther] = if order.is_le() { [one, other] } else { [other, one] };
        let beam = at_position(&nearer.beam, farther.at);
        (one.lean * other.lean).sqrt() * beam.between(&one.bending, &other.bending)
    }

    /// Returns the contribution of the reference depth beneath the loads, to be subtracted from the
    /// half-space and its images, m/N.
    fn near(&self, one: &Place, other: &Place) -> f64 {
        let stretch = (one.stretch * other.stretch).sqrt();
        let lengths = [one.length, other.length];
        let depths = one.depth * other.depth;
        let offset = minus(one.position, other.position);
        let square = dot(offset, offset);
        let apart = |square: f64, along: f64| {
            let across = (square - along * along).max(0.0);
            mean_inverse((across + depths).sqrt(), along, lengths)
        };
        let image = |side: usize| {
            let [height, beyond] = [one.heights[side], other.heights[side]];
            apart(square + 4.0 * height * beyond, stretch * (height + beyond))
        };
        let direct = apart(square, stretch * (one.key[1] - other.key[1]).abs());
        -(direct + image(0) + image(1)) / (PI * self.modulus)
    }

    /// Returns the displacements of roots by each place of a list.
    fn moved(&self, relation: Relation, places: &[Place]) -> Vec<Moved> {
        places.iter().map(|place| self.rings.moved(relation, &place.load, place.at)).collect()
    }
}

impl Place {
    fn compare(&self, other: &Place) -> std::cmp::Ordering {
        let orders = (0..3).map(|k| self.key[k].total_cmp(&other.key[k]));
        orders.fold(self.side.cmp(&other.side), std::cmp::Ordering::then)
    }
}

/// Returns a vector rotated by an angle, rad.
fn rotated([x, y]: [f64; 2], angle: f64) -> [f64; 2] {
    let (sine, cosine) = angle.sin_cos();
    [cosine * x - sine * y, sine * x + cosine * y]
}

/// Compliance of the ring between places of two teeth.
struct RingBlock {
    relation: Relation,
    observers: Vec<Moved>,
    loads: Vec<Moved>,
}

impl RingBlock {
    fn compliance(&self, (i, observer): (usize, &Place), (j, load): (usize, &Place)) -> f64 {
        // The tooth behind moves the one ahead; on one tooth, the place that comes first moves the
        // other one.
        let is_forward = match self.relation.is_same {
            true => observer.compare(load).is_le(),
            false => self.relation.is_ahead,
        };
        match is_forward {
            true => RingFamily::compliance(&self.observers[i], &load.load, load.at),
            false => RingFamily::compliance(&self.loads[j], &observer.load, observer.at),
        }
    }
}

impl SolidStructure for TaperedSolid {
    fn surface(&self, surface: u32) -> Arc<dyn Surface> {
        self.flanks[surface as usize].clone().as_surface()
    }

    fn teeth(&self) -> u32 {
        self.teeth
    }

    fn surface_modulus(&self) -> f64 {
        self.modulus
    }

    fn mirrors(&self) -> &[Mirror] {
        &self.mirrors
    }

    fn side_faces(&self, surface: u32, u: [f64; 2]) -> Vec<Mirror> {
        let Some(sides) = self.sides.get(surface as usize) else { return Vec::new() };
        [0, 1].map(|side| sides.mirror(side, u[side])).to_vec()
    }

    fn add_compliance_until(
        &self,
        observe: Chart,
        observers: &[SurfaceSegment],
        load: Chart,
        loads: &[SurfaceSegment],
        block: &mut [f64],
        interrupt: &Interrupt,
    ) -> Result<(), EngineError> {
        let is_own = observe == load && observers == loads;
        let (observers, loads) = (self.places(observe, observers), self.places(load, loads));
        if loads.is_empty() {
            return Ok(());
        }
        let is_same = observe.tooth % self.teeth == load.tooth % self.teeth;
        let relation = self.rings.relation(observe.tooth, load.tooth);
        let of = |places: &[Place], is_needed: bool| {
            if is_needed { self.moved(relation, places) } else { Vec::new() }
        };
        let ring = RingBlock {
            relation,
            observers: of(&observers, is_same || relation.is_ahead),
            loads: of(&loads, is_same || !relation.is_ahead),
        };
        let columns = loads.len();
        for (i, observer) in observers.iter().enumerate() {
            interrupt.check()?;
            let all = if is_own { i + 1 } else { columns };
            for (j, loaded) in loads[..all].iter().enumerate() {
                let mut slices = ring.compliance((i, observer), (j, loaded));
                if is_same {
                    slices += Self::between(observer, loaded);
                }
                let mut given = slices * FaceCoupling::mean(&observer.along, &loaded.along);
                if observe == load {
                    given += self.near(observer, loaded);
                }
                block[i * columns + j] += given;
                if is_own && j < i {
                    block[j * columns + i] += given;
                }
            }
        }
        Ok(())
    }

    /// Returns the stress of the standard in each section under the force that slices pass on to
    /// it, at the same fractions of the height of the tooth.
    fn stresses(&self, tooth: u32, surface: u32, loads: &[SegmentLoad]) -> Vec<SurfaceStress> {
        let side = if surface == 0 { 1.0 } else { -1.0 };
        let own = loads.iter().filter(|load| load.chart.tooth == tooth);
        let by: Vec<(Place, f64)> = own
            .filter_map(|load| Some((self.place(load.chart.surface as usize, &load.segment)?, load.force)))
            .collect();
        let station = |(both, (here, height)): (&[RootStation; 2], &(Stretch, f64))| {
            let RootStation { section, place, position } = both.get(surface as usize)?;
            let of = |(place, force): &(Place, f64)| {
                let bending = RootLoad { moment: place.bending.moment * height, ..place.bending };
                let spread = FaceCoupling::mean(&place.along, here);
                force * place.lean * section.stress(&bending, side) * spread
            };
            let along = by.iter().map(of).sum();
            let [x, y] = rotated([position[0], position[1]], self.tooth_angle(tooth));
            let (place, position) = (*place, [x, y, position[2]]);
            Some(SurfaceStress { tooth, surface, place, position, components: [along, 0.0, 0.0] })
        };
        self.stations.iter().zip(&self.at_stations).filter_map(station).collect()
    }

    fn bytes(&self) -> usize {
        let sides = self.sides.iter().flat_map(|side| &side.planes);
        size_of::<Self>()
            + self.dimensions.bytes()
            + self.beams.bytes()
            + self.rings.bytes()
            + self.slices.bytes()
            + size_of_val(self.stations.as_slice())
            + size_of_val(self.at_stations.as_slice())
            + sides.map(|planes| size_of_val(planes.as_slice())).sum::<usize>()
    }
}

#[cfg(test)]
mod tests;
