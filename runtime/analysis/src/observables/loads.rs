//! Observables of load sharing: between tooth pairs, and along contact lines.

use super::{Contact, Equilibrium, Needs, Observable, Quantity, Slice};
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

/// The largest line load divided by the mean along the contact line of the most loaded pair; 1
/// without load and in a plane model, where the load is uniform along the face.
///
/// On spur gears this is the face load factor `K_Hbeta` of ISO 6336-1. On helical gears the contact
/// line crosses the profile, so the ratio includes the variation along the profile, which `K_Hbeta`
/// does not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FaceLoadFactor(pub PairId);

impl Observable for FaceLoadFactor {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("face_load_factor", "1")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let factor = |contact: Contact<'_>| face_load_factor(&contact.slices(), contact.line_length());
        Observed::number(most_loaded(at, self.0).map_or(1.0, factor))
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

/// Returns the largest line load divided by the mean, for the slices of a contact line of some
/// length, m.
fn face_load_factor(slices: &[Slice], length: f64) -> f64 {
    let force: f64 = slices.iter().map(|slice| slice.force).sum();
    let largest = slices.iter().map(Slice::line_load).fold(0.0, f64::max);
    largest * length / force
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Parallel springs on a face, loaded by a straight misaligned edge: the loads of their slices.
    fn misaligned(stiffness: f64, slope: f64, face: f64, force: f64) -> Vec<Slice> {
        const COUNT: usize = 4000;
        let length = face / COUNT as f64;
        let along = |index: usize| (index as f64 + 0.5) * length - 0.5 * face;
        let load = |middle: f64| move |index| (stiffness * (middle + slope * along(index))).max(0.0) * length;
        // Bisect the approach until the springs balance the force.
        let (mut high, mut low) = (2.0 * face, -2.0 * face);
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            let total: f64 = (0..COUNT).map(load(middle)).sum();
            if total > force { high = middle } else { low = middle }
        }
        let slice = |force| Slice {
            length,
            force,
            pressure: 0.0,
            edge_pressure: 0.0,
            point: [0.0; 3],
            locations: [None, None],
        };
        (0..COUNT).map(load(low)).map(slice).collect()
    }

    /// With stiffness c per length, misalignment f and face width b: K_Hbeta = 1 + c f b² / 2F
    /// while the whole face carries load, and the root of 2 c f b² / F beyond, from 2 on (ISO
    /// 6336-1 with the mean load F/b and the misalignment f b).
    #[test]
    fn a_misaligned_uniform_stiffness_has_its_face_load_factor_in_closed_form() {
        let (stiffness, face, force) = (14e9, 0.02, 5000.0);
        for slope in [0.0, 1e-4, 5e-4, 1.6e-3, 4e-3] {
            let misaligned = misaligned(stiffness, slope, face, force);
            let by_load = stiffness * slope * face * face / force;
            let expected = if by_load <= 2.0 { 1.0 + 0.5 * by_load } else { (2.0 * by_load).sqrt() };
            let found = face_load_factor(&misaligned, face);
            assert!((found / expected - 1.0).abs() < 1e-3, "slope {slope}: {found} {expected}");
        }
    }
}
