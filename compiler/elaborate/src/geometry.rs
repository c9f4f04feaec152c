//! Derived geometry of gears and meshes, by the call that created them, for display in the source.

use calyx_gears::derived_quantities::{Quantity, of_gear, of_mesh};
use calyx_gears::host::{MeshRecord, ModelHost};
use calyx_lang::span::Span;

use crate::diagnostics::place;

/// Number of gears or meshes that are stored for each call. A loop may create more; these are
/// counted.
pub const MOST_PER_CALL: usize = 4;

/// All gears and meshes, by the calls that created them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Geometry {
    /// Gears, in order of first execution.
    pub gears: Vec<CreatedAt<GearGeometry>>,
    pub meshes: Vec<CreatedAt<MeshGeometry>>,
    /// Number of meshes on axes that are not parallel, or of gears that are not involute gears.
    pub general_meshes: usize,
}

/// The gears or meshes created by one call, which may run many times.
#[derive(Clone, Debug, PartialEq)]
pub struct CreatedAt<T> {
    /// Source range of the whole call.
    pub span: Span,
    /// Number of objects that the call created.
    pub count: usize,
    /// The first objects, at most [`MOST_PER_CALL`].
    pub first: Vec<T>,
}

/// A gear and its derived data.
#[derive(Clone, Debug, PartialEq)]
pub struct GearGeometry {
    /// Names of the bodies that have this gear.
    pub bodies: Vec<String>,
    pub quantities: Vec<Quantity>,
    /// Its meshes, as far as they are stored.
    pub meshes: Vec<Membership>,
}

/// The role of a gear in a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Membership {
    /// Index of the call in [`Geometry::meshes`], and of the mesh within this call.
    pub call: usize,
    pub index: usize,
    /// 0 for the first gear of the mesh, 1 for the second.
    pub member: usize,
}

/// Two gears in mesh and the derived data of the pair. A pair that cannot run also has a geometry,
/// if its teeth can touch.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshGeometry {
    /// Names of the two bodies.
    pub bodies: [String; 2],
    /// The calls that created the gears.
    pub gears: [Span; 2],
    pub quantities: Vec<Quantity>,
}

impl Geometry {
    /// Returns the innermost gear call that contains an offset of a file.
    pub fn gear_at(&self, file: u32, offset: u32) -> Option<&CreatedAt<GearGeometry>> {
        at(&self.gears, file, offset)
    }

    /// Returns the innermost mesh call that contains an offset of a file.
    pub fn mesh_at(&self, file: u32, offset: u32) -> Option<&CreatedAt<MeshGeometry>> {
        at(&self.meshes, file, offset)
    }

    /// Returns the mesh of a membership.
    pub fn mesh(&self, membership: Membership) -> Option<&MeshGeometry> {
        self.meshes.get(membership.call)?.first.get(membership.index)
    }

    /// Collects what the program created before it ended, whether it succeeded or not.
    pub(crate) fn of(host: &ModelHost) -> Geometry {
        let meshes = host.scene.pairs.iter().filter_map(|pair| pair.mesh.as_ref());
        let general_meshes = meshes.filter(|mesh| mesh.first_contact.is_some()).count();
        let mut geometry = Geometry { general_meshes, ..Geometry::default() };
        // For each gear of the host: its call and its index within the call, if it is stored.
        let mut kept = Vec::with_capacity(host.gears.len());
        for (gear, made_at) in host.gears.iter().zip(&host.gear_places) {
            let quantities = || gear.cylindrical().map_or_else(Vec::new, |gear| of_gear(gear));
            let gear = || GearGeometry { bodies: Vec::new(), quantities: quantities(), meshes: Vec::new() };
            kept.push(add(&mut geometry.gears, place(Some(*made_at)), gear));
        }
        for (body, gear) in host.scene.bodies.iter().zip(&host.body_gears) {
            if let Some(gear) = gear.and_then(|gear| kept.get(gear)).and_then(|kept| geometry.gear_mut(*kept))
            {
                gear.bodies.push(body.name.clone());
            }
        }
        for meeting in &host.mesh_records {
            let Some((mesh, gears)) = mesh(host, meeting) else { continue };
            let Some((call, index)) = add(&mut geometry.meshes, place(Some(meeting.place)), || mesh) else {
                continue;
            };
            for (member, gear) in gears.into_iter().enumerate() {
                if let Some(gear) = kept.get(gear).and_then(|kept| geometry.gear_mut(*kept)) {
                    gear.meshes.push(Membership { call, index, member });
                }
            }
        }
        geometry
    }

    fn gear_mut(&mut self, kept: Option<(usize, usize)>) -> Option<&mut GearGeometry> {
        let (call, index) = kept?;
        self.gears.get_mut(call)?.first.get_mut(index)
    }
}

fn at<T>(calls: &[CreatedAt<T>], file: u32, offset: u32) -> Option<&CreatedAt<T>> {
    let around = |made: &&CreatedAt<T>| {
        let Span { file: of, start, end } = made.span;
        of.0 == file && (start..=end).contains(&offset)
    };
    calls.iter().filter(around).min_by_key(|made| made.span.end - made.span.start)
}

/// Counts one more object of a call and stores it if it is among the first. Returns the index of
/// the call and the index within the call.
fn add<T>(calls: &mut Vec<CreatedAt<T>>, span: Span, make: impl FnOnce() -> T) -> Option<(usize, usize)> {
    // A loop repeats the last few calls, so the search starts at the end.
    let call = calls.iter().rposition(|made| made.span == span).unwrap_or_else(|| {
        calls.push(CreatedAt { span, count: 0, first: Vec::new() });
        calls.len() - 1
    });
    let made = calls.get_mut(call)?;
    made.count += 1;
    (made.first.len() < MOST_PER_CALL).then(|| {
        made.first.push(make());
        (call, made.first.len() - 1)
    })
}

/// Returns the geometry of a mesh between two bodies, and the indices of their gears.
fn mesh(host: &ModelHost, meeting: &MeshRecord) -> Option<(MeshGeometry, [usize; 2])> {
    let [first, second] = meeting.bodies;
    let numbers = [(*host.body_gears.get(first)?)?, (*host.body_gears.get(second)?)?];
    let gears = [host.gears.get(numbers[0])?.cylindrical()?, host.gears.get(numbers[1])?.cylindrical()?];
    let name = |body: usize| host.scene.bodies.get(body).map(|body| body.name.clone());
    let span = |gear: usize| place(host.gear_places.get(gear).copied());
    let mesh = MeshGeometry {
        bodies: [name(first)?, name(second)?],
        gears: numbers.map(span),
        quantities: of_mesh(gears.map(|gear| gear.form()), &meeting.geometry),
    };
    Some((mesh, numbers))
}
