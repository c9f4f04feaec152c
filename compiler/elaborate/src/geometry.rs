//! The geometry that follows from a model, by the calls that made it: what a gear engineer asks of a gear in the source.

use calyx_gears::derived::{Quantity, of_gear, of_mesh};
use calyx_gears::host::{Meeting, ModelHost};
use calyx_lang::span::Span;

use crate::diagnostics::place;

/// Gears or meshes that are kept of one call: what a loop makes is counted, and the first shown.
pub const MOST_PER_CALL: usize = 4;

/// Everything that was made, by the calls that made it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Geometry {
    /// In order of first execution.
    pub gears: Vec<Made<GearGeometry>>,
    pub meshes: Vec<Made<MeshGeometry>>,
}

/// What one call made, which may run many times.
#[derive(Clone, Debug, PartialEq)]
pub struct Made<T> {
    /// The whole call.
    pub span: Span,
    /// How many it made.
    pub count: usize,
    /// The first of them, at most [`MOST_PER_CALL`].
    pub first: Vec<T>,
}

/// A gear and what follows from its data.
#[derive(Clone, Debug, PartialEq)]
pub struct GearGeometry {
    /// Names of the bodies that have this gear.
    pub bodies: Vec<String>,
    pub quantities: Vec<Quantity>,
    /// Its meshes, as far as they are kept.
    pub meshes: Vec<Membership>,
}

/// A gear's place in a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Membership {
    /// Index of the call in [`Geometry::meshes`], and of the mesh among those it made.
    pub call: usize,
    pub index: usize,
    /// 0 for the first gear of the mesh, 1 for the second.
    pub member: usize,
}

/// Two gears in mesh and what follows from that. A pair that cannot run has a geometry too, as long as it can touch.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshGeometry {
    /// Names of the two bodies.
    pub bodies: [String; 2],
    /// Calls that made their gears.
    pub gears: [Span; 2],
    pub quantities: Vec<Quantity>,
}

impl Geometry {
    /// The gear call around a place of a file: the smallest one that holds the offset.
    pub fn gear_at(&self, file: u32, offset: u32) -> Option<&Made<GearGeometry>> {
        at(&self.gears, file, offset)
    }

    /// The mesh call around a place.
    pub fn mesh_at(&self, file: u32, offset: u32) -> Option<&Made<MeshGeometry>> {
        at(&self.meshes, file, offset)
    }

    /// The mesh of a membership.
    pub fn mesh(&self, membership: Membership) -> Option<&MeshGeometry> {
        self.meshes.get(membership.call)?.first.get(membership.index)
    }

    /// What was made until the program ended, however it ended.
    pub(crate) fn of(host: &ModelHost) -> Geometry {
        let mut geometry = Geometry::default();
        // Of each gear of the host: its call and its index there, if it is kept.
        let mut kept = Vec::with_capacity(host.gears.len());
        for (gear, made_at) in host.gears.iter().zip(&host.gear_places) {
            let gear = || GearGeometry { bodies: Vec::new(), quantities: of_gear(gear), meshes: Vec::new() };
            kept.push(add(&mut geometry.gears, place(Some(*made_at)), gear));
        }
        for (body, gear) in host.scene.bodies.iter().zip(&host.body_gears) {
            if let Some(gear) = gear.and_then(|gear| kept.get(gear)).and_then(|kept| geometry.gear_mut(*kept))
            {
                gear.bodies.push(body.name.clone());
            }
        }
        for meeting in &host.meetings {
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

fn at<T>(calls: &[Made<T>], file: u32, offset: u32) -> Option<&Made<T>> {
    let around = |made: &&Made<T>| {
        let Span { file: of, start, end } = made.span;
        of.0 == file && (start..=end).contains(&offset)
    };
    calls.iter().filter(around).min_by_key(|made| made.span.end - made.span.start)
}

/// Counts one more of a call, and keeps it if it is among the first: the index of the call and its own there.
fn add<T>(calls: &mut Vec<Made<T>>, span: Span, make: impl FnOnce() -> T) -> Option<(usize, usize)> {
    // A loop comes back to the same few calls.
    let call = calls.iter().rposition(|made| made.span == span).unwrap_or_else(|| {
        calls.push(Made { span, count: 0, first: Vec::new() });
        calls.len() - 1
    });
    let made = calls.get_mut(call)?;
    made.count += 1;
    (made.first.len() < MOST_PER_CALL).then(|| {
        made.first.push(make());
        (call, made.first.len() - 1)
    })
}

/// A meeting of two bodies, and the numbers of their gears.
fn mesh(host: &ModelHost, meeting: &Meeting) -> Option<(MeshGeometry, [usize; 2])> {
    let [first, second] = meeting.bodies;
    let numbers = [(*host.body_gears.get(first)?)?, (*host.body_gears.get(second)?)?];
    let gears = [host.gears.get(numbers[0])?, host.gears.get(numbers[1])?];
    let name = |body: usize| host.scene.bodies.get(body).map(|body| body.name.clone());
    let span = |gear: usize| place(host.gear_places.get(gear).copied());
    let mesh = MeshGeometry {
        bodies: [name(first)?, name(second)?],
        gears: numbers.map(span),
        quantities: of_mesh(gears.map(|gear| gear.form()), &meeting.geometry),
    };
    Some((mesh, numbers))
}
