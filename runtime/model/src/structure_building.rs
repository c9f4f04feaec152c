//! Builds the structures of a planned scene in parallel, each once, or takes them from the
//! structure cache.

use crate::body::Body;
use crate::fidelity::StructureOptions;
use crate::mechanism::Mechanism;
use crate::plan::{BodyPlan, Plan};
use crate::prototype::Prototype;
use crate::resources::Resources;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use calyx_structure::cache::{Answer, Claim, Key, Operator};
use calyx_structure::{AnyStructure, BodyModes};
use rayon::prelude::*;
use std::ops::Add;
use std::sync::Arc;

/// Provenance of the structures of an analysis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StructureCounts {
    /// Number of structures that were built.
    pub built: usize,
    /// Number of structures from a cache, in memory or on disk, or from a parallel build in another
    /// thread.
    pub reused: usize,
}

impl Add for StructureCounts {
    type Output = StructureCounts;

    fn add(self, other: StructureCounts) -> StructureCounts {
        StructureCounts { built: self.built + other.built, reused: self.reused + other.reused }
    }
}

/// Structure that bodies of the scene require.
struct RequestedStructure<'s> {
    prototype: &'s dyn Prototype,
    options: StructureOptions,
    solid: bool,
}

impl RequestedStructure<'_> {
    fn key(&self) -> Option<Key> {
        if self.solid { self.prototype.solid_key(&self.options) } else { self.prototype.key(&self.options) }
    }

    fn build(&self, interrupt: &Interrupt) -> Result<AnyStructure, EngineError> {
        Ok(if self.solid {
            self.prototype.build_solid(&self.options, interrupt)?.into()
        } else {
            self.prototype.build(&self.options, interrupt)?.into()
        })
    }

    /// Restores a structure from the bytes of the disk cache; `None` if they do not describe one.
    fn restore(&self, bytes: &[u8]) -> Option<AnyStructure> {
        if self.solid {
            self.prototype.restore_solid(&self.options, bytes).map(AnyStructure::from)
        } else {
            self.prototype.restore(&self.options, bytes).map(AnyStructure::from)
        }
    }

    /// Returns whether a structure has the required dimension. A prototype may wrongly give plane
    /// and three-dimensional structures the same key.
    fn takes(&self, structure: &AnyStructure) -> bool {
        matches!(structure, AnyStructure::Solid(_)) == self.solid
    }
}

/// Structures by body, all plane or all three-dimensional; `None` for bodies that the plan leaves
/// out.
pub type Structures = Vec<Option<AnyStructure>>;

/// Returns the structure of every body that the plan models, and the number of structures that were
/// built.
pub fn build_structures(
    scene: &Mechanism,
    plan: &Plan,
    resources: &Resources,
) -> Result<(Structures, StructureCounts), EngineError> {
    let numbers = plan.structures(scene);
    let mut wanted: Vec<RequestedStructure<'_>> = Vec::new();
    for ((number, body), planned) in numbers.iter().zip(&scene.bodies).zip(&plan.bodies) {
        let Some(number) = *number else { continue };
        match wanted.get_mut(number) {
            // A structure is built with stresses if any body that shares it needs them.
            Some(RequestedStructure { options, .. }) => options.stresses |= planned.options.stresses,
            None => wanted.push(RequestedStructure {
                prototype: body.prototype.as_ref(),
                options: planned.options,
                solid: plan.three_dimensional,
            }),
        }
    }
    let (structures, counts) = obtain(&wanted, resources)?;
    let bodies = numbers.into_iter().zip(&scene.bodies).zip(&plan.bodies);
    let of_body = |((number, body), planned): ((Option<usize>, &Body), &BodyPlan)| {
        let shared = number.and_then(|number| structures.get(number).cloned());
        let shaped = |shared| {
            Ok::<_, EngineError>(match shared {
                AnyStructure::Plane(shared) => body.prototype.shape(shared, &planned.options)?.into(),
                AnyStructure::Solid(shared) => body.prototype.shape_solid(shared, &planned.options)?.into(),
            })
        };
        shared.map(shaped).transpose()
    };
    Ok((bodies.map(of_body).collect::<Result<_, _>>()?, counts))
}

/// Returns the keys of the structures that the plan requires, by body; `None` for bodies without a
/// structure and for structures that are not stored, such as closed forms.
pub fn structure_keys(scene: &Mechanism, plan: &Plan) -> Vec<Option<Key>> {
    let modelled = plan.structures(scene);
    let key = |((number, body), planned): ((Option<usize>, &Body), &BodyPlan)| {
        let (prototype, solid) = (body.prototype.as_ref(), plan.three_dimensional);
        let requested = RequestedStructure { prototype, options: planned.options, solid };
        number.and_then(|_| requested.key())
    };
    modelled.into_iter().zip(&scene.bodies).zip(&plan.bodies).map(key).collect()
}

/// Structure to build in this thread, with the obligation to publish it if it has a key.
type Build<'c> = (usize, Option<Claim<'c>>);
/// Number of the required structure, the structure, and whether it was built rather than restored.
type Built = (usize, AnyStructure, bool);

fn obtain(
    wanted: &[RequestedStructure<'_>],
    resources: &Resources,
) -> Result<(Vec<AnyStructure>, StructureCounts), EngineError> {
    let mut structures: Structures = vec![None; wanted.len()];
    let mut counts = StructureCounts::default();
    // A thread of the pool must not wait for a build of another thread; see
    // `OperatorCache::structure`.
    let may_wait = rayon::current_thread_index().is_none();
    while structures.iter().any(Option::is_none) {
        let mut builds: Vec<Build<'_>> = Vec::new();
        let mut waits = Vec::new();
        for (number, wanted) in wanted.iter().enumerate() {
            if structures[number].is_some() {
                continue;
            }
            let cached = resources.cache.as_deref().zip(wanted.key());
            let kept = |operator: Operator| operator.structure().filter(|structure| wanted.takes(structure));
            match cached.map(|(cache, key)| (cache, key, cache.ask(key))) {
                Some((_, _, Answer::Ready(operator))) => match kept(operator) {
                    Some(structure) => {
                        counts.reused += 1;
                        structures[number] = Some(structure);
                    }
                    None => builds.push((number, None)),
                },
                Some((_, _, Answer::Yours(claim))) => builds.push((number, Some(claim))),
                Some((cache, key, Answer::Elsewhere(flight))) if may_wait => {
                    waits.push((number, cache, key, flight));
                }
                Some((_, _, Answer::Elsewhere(_))) | None => builds.push((number, None)),
            }
        }
        for (number, structure, anew) in build(wanted, builds, resources)? {
            structures[number] = Some(structure);
            *if anew { &mut counts.built } else { &mut counts.reused } += 1;
        }
        // No deadlock: a thread waits for others only after it has built its own structures.
        for (number, cache, key, flight) in waits {
            // If the other build fails, the next round builds the structure here.
            if let Some(structure) =
                cache.wait(key, &flight, &resources.interrupt)?.and_then(Operator::structure)
                && wanted[number].takes(&structure)
            {
                counts.reused += 1;
                structures[number] = Some(structure);
            }
        }
    }
    Ok((structures.into_iter().flatten().collect(), counts))
}

/// Restores structures from disk or builds them, in parallel. If several fail, the first error in
/// order is returned.
fn build(
    wanted: &[RequestedStructure<'_>],
    builds: Vec<Build<'_>>,
    resources: &Resources,
) -> Result<Vec<Built>, EngineError> {
    let one = |(number, claim): Build<'_>| {
        let wanted = &wanted[number];
        let on_disk = claim.as_ref().and_then(Claim::on_disk);
        let restored = on_disk.and_then(|(store, key)| wanted.restore(&store.read(&key)?));
        let (structure, anew) = match restored {
            Some(structure) => (structure, false),
            None => (wanted.build(&resources.interrupt)?, true),
        };
        if let Some(claim) = claim {
            claim.fulfil(&structure.clone().into());
        }
        // No thread waits for the disk.
        if anew
            && let Some((store, key)) = on_disk
            && let Some(content) = structure.stored()
        {
            store.write(&key, &content);
        }
        Ok((number, structure, anew))
    };
    let built: Vec<Result<Built, EngineError>> =
        resources.install(|| builds.into_par_iter().map(one).collect());
    built.into_iter().collect()
}

impl Resources {
    /// Returns the modes of a body up to a frequency (rad/s), from the cache if possible; `None`
    /// for a body without modes.
    ///
    /// # Errors
    /// Those of [`Prototype::modes`] and of the interrupt.
    pub fn modes(
        &self,
        prototype: &dyn Prototype,
        options: &StructureOptions,
        highest: f64,
    ) -> Result<Option<Arc<BodyModes>>, EngineError> {
        let found = || self.install(|| prototype.modes(options, highest, &self.interrupt));
        let modes = match (self.cache.as_deref(), prototype.modes_key(options, highest)) {
            (Some(cache), Some(key)) => cache.modes(key, &self.interrupt, |claim| {
                let on_disk = claim.and_then(Claim::on_disk);
                let kept =
                    on_disk.and_then(|(store, key)| prototype.restore_modes(options, &store.read(&key)?));
                if kept.is_some() {
                    return Ok(kept);
                }
                let modes = found()?;
                if let Some((store, key)) = on_disk
                    && let Some(content) = modes.as_ref().and_then(|modes| modes.stored())
                {
                    store.write(&key, &content);
                }
                Ok(modes)
            })?,
            _ => found()?,
        };
        modes.map(|modes| prototype.shape_modes(modes, options)).transpose()
    }
}
