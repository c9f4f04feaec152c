//! Observables of load sharing: between tooth pairs, and along contact lines.

use super::{Contact, Equilibrium, Needs, Observable, Quantity};
use calyx_model::ids::PairId;
use calyx_model::observed::Observed;
use calyx_model::pairs::GearMesh;
use std::ops::Add;

/// Load share of the pair of teeth that enters contact at the start of the mesh cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoadShare(pub PairId);

impl Observable for LoadShare {
    fn quantity(&self) -> Quantity {
        Quantity::passing("load_share", "1")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let Some((mesh, _)) = at.mesh(self.0) else { return Observed::number(f64::NAN) };
        let total = at.force(self.0);
        let own = at.contacts(self.0).filter(|contact| contact.teeth() == mesh.entering);
        let own: f64 = own.map(|contact| contact.force()).sum();
        Observed::number(if total > 0.0 { own / total } else { 0.0 })
    }

    fn bounds(&self) -> [f64; 2] {
        [0.0, 1.0]
    }

    fn pair_of(&self) -> Option<PairId> {
        Some(self.0)
    }
}

/// Sum of the normal forces of a mesh over all tooth pairs, on the flanks of the surface pair, N.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshForce(pub PairId);

impl Observable for MeshForce {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("mesh_force", "N")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        Observed::number(at.contacts(self.0).map(|contact| contact.force()).fold(0.0, Add::add))
    }

    fn pair_of(&self) -> Option<PairId> {
        Some(self.0)
    }
}

/// Normal force on a tooth pair: that which enters contact at the start of the mesh cycle (0), one
/// that enters later (1, 2, ...) or has entered before (-1, -2, ...), N.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairLoad(pub PairId, pub i32);

impl Observable for PairLoad {
    fn quantity(&self) -> Quantity {
        Quantity::passing("pair_load", "N")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        Observed::number(pairs_teeth(at, self.0, self.1).map(|contact| contact.force()).fold(0.0, Add::add))
    }

    fn pair_of(&self) -> Option<PairId> {
        Some(self.0)
    }
}

/// Returns the contact patches of a tooth pair of a mesh, numbered as by [`PairLoad`].
pub(super) fn pairs_teeth<'a>(
    at: &Equilibrium<'a>,
    pair: PairId,
    count: i32,
) -> impl Iterator<Item = Contact<'a>> {
    let teeth = at.mesh(pair).map(|(mesh, _)| teeth_of(mesh, count));
    at.contacts(pair).filter(move |contact| Some(contact.teeth()) == teeth)
}

/// Returns the teeth of the pair that enters `count` pitches after the first.
fn teeth_of(mesh: &GearMesh, count: i32) -> [u32; 2] {
    let [first, second] = mesh.entering;
    // The roll angle grows over a mesh cycle if the first gear rotates in its drive sense. The
    // following tooth is behind in the sense of rotation.
    let behind = -f64::from(count) * mesh.drive_sense * (mesh.roll[1] - mesh.roll[0]).signum();
    let tooth =
        |tooth: u32, step: f64, teeth: u32| (f64::from(tooth) + step).rem_euclid(f64::from(teeth)) as u32;
    [tooth(first, behind, mesh.teeth[0]), tooth(second, -mesh.sign * behind, mesh.teeth[1])]
}

/// Number of tooth pairs that carry load; its mean over a mesh cycle is the contact ratio under
/// load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairsInContact(pub PairId);

impl Observable for PairsInContact {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("pairs_in_contact", "1")
    }

    fn needs(&self) -> Needs {
        Needs::Motions
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let mut loaded: Vec<[u32; 2]> =
            at.contacts(self.0).filter(Contact::touches).map(|contact| contact.teeth()).collect();
        loaded.sort_unstable();
        loaded.dedup();
        Observed::number(loaded.len() as f64)
    }

    fn pair_of(&self) -> Option<PairId> {
        Some(self.0)
    }
}

/// Largest line load: force per length of contact line, N/m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaxLineLoad(pub PairId);

impl Observable for MaxLineLoad {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("max_line_load", "N/m")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let slices = at.contacts(self.0).flat_map(|contact| contact.slices());
        let largest = slices.max_by(|a, b| a.line_load().total_cmp(&b.line_load()));
        largest.map_or(Observed::number(0.0), |slice| {
            let value = slice.line_load();
            let [location, _] = slice.locations;
            Observed { value, least: None, location }
        })
    }

    fn pair_of(&self) -> Option<PairId> {
        Some(self.0)
    }
}

/// Loaded fraction of the contact line of the most loaded pair; 1 in a plane model, 0 without load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoadedFace(pub PairId);

impl Observable for LoadedFace {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("loaded_face", "1")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let loaded = |contact: &Contact<'_>| -> f64 {
            contact.slices().iter().filter(|slice| slice.force > 0.0).map(|slice| slice.length).sum()
        };
        let part = most_loaded(at, self.0).map(|contact| loaded(&contact) / contact.line_length());
        Observed::number(part.unwrap_or(0.0))
    }

    fn pair_of(&self) -> Option<PairId> {
        Some(self.0)
    }
}

/// Returns the patch with the largest force; `None` without load.
fn most_loaded<'a>(at: &Equilibrium<'a>, pair: PairId) -> Option<Contact<'a>> {
    let loaded = at.contacts(pair).filter(|contact| contact.force() > 0.0);
    loaded.max_by(|a, b| a.force().total_cmp(&b.force()))
}
