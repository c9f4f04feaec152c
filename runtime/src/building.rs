//! The structures of a planned scene: taken from the cache or built side by side, each once.

use crate::cache::{Answer, Claim};
use crate::error::EngineError;
use crate::plan::{BodyPlan, Plan};
use crate::resources::Resources;
use crate::results::StructureCounts;
use crate::scene::{Body, Prototype, Scene, StructureOptions};
use crate::structure::Structure;
use rayon::prelude::*;
use std::sync::Arc;

/// A structure that bodies of the scene need.
struct Wanted<'s> {
    prototype: &'s dyn Prototype,
    options: StructureOptions,
}

/// One per body; `None` for a body the plan left out.
pub(crate) type Structures = Vec<Option<Arc<dyn Structure>>>;

/// The structure of every body that the plan models, and how many were built for it.
pub(crate) fn build_structures(
    scene: &Scene,
    plan: &Plan,
    resources: &Resources,
) -> Result<(Structures, StructureCounts), EngineError> {
    let numbers = plan.structures(scene);
    let mut wanted: Vec<Wanted<'_>> = Vec::new();
    for ((number, body), planned) in numbers.iter().zip(&scene.bodies).zip(&plan.bodies) {
        let Some(number) = *number else { continue };
        match wanted.get_mut(number) {
            // One that needs stresses serves all that share it.
            Some(Wanted { options, .. }) => options.stresses |= planned.options.stresses,
            None => wanted.push(Wanted { prototype: body.prototype.as_ref(), options: planned.options }),
        }
    }
    let (structures, counts) = obtain(&wanted, resources)?;
    let bodies = numbers.into_iter().zip(&scene.bodies).zip(&plan.bodies);
    let of_body = |((number, body), planned): ((Option<usize>, &Body), &BodyPlan)| {
        let shared = number.and_then(|number| structures.get(number).cloned());
        shared.map(|shared| body.prototype.shape(shared, &planned.options)).transpose()
    };
    Ok((bodies.map(of_body).collect::<Result<_, _>>()?, counts))
}

/// A structure to be built here, with the duty to hand it to others if it has a key.
type Build<'c> = (usize, Option<Claim<'c>>);
/// By number of what is wanted.
type Built = (usize, Arc<dyn Structure>);

fn obtain(
    wanted: &[Wanted<'_>],
    resources: &Resources,
) -> Result<(Vec<Arc<dyn Structure>>, StructureCounts), EngineError> {
    let mut structures: Structures = vec![None; wanted.len()];
    let mut counts = StructureCounts::default();
    // A thread of a pool must not wait for another one's build; see `OperatorCache::structure`.
    let may_wait = rayon::current_thread_index().is_none();
    while structures.iter().any(Option::is_none) {
        let mut builds: Vec<Build<'_>> = Vec::new();
        let mut waits = Vec::new();
        for (number, wanted) in wanted.iter().enumerate() {
            if structures[number].is_some() {
                continue;
            }
            let cached = resources.cache.as_deref().zip(wanted.prototype.key(&wanted.options));
            match cached.map(|(cache, key)| (cache, key, cache.ask(key))) {
                Some((_, _, Answer::Ready(structure))) => {
                    counts.reused += 1;
                    structures[number] = Some(structure);
                }
                Some((_, _, Answer::Yours(claim))) => builds.push((number, Some(claim))),
                Some((cache, key, Answer::Elsewhere(flight))) if may_wait => {
                    waits.push((number, cache, key, flight));
                }
                Some((_, _, Answer::Elsewhere(_))) | None => builds.push((number, None)),
            }
        }
        counts.built += builds.len();
        for (number, structure) in build(wanted, builds, resources)? {
            structures[number] = Some(structure);
        }
        // Nobody waits for a structure of another thread's with one of its own unbuilt, so no two wait for each other.
        for (number, cache, key, flight) in waits {
            // Should the other build fail, the next round builds it here.
            if let Some(structure) = cache.wait(key, &flight, &resources.interrupt)? {
                counts.reused += 1;
                structures[number] = Some(structure);
            }
        }
    }
    Ok((structures.into_iter().flatten().collect(), counts))
}

/// Builds side by side. Of several errors the first in order is reported.
fn build(
    wanted: &[Wanted<'_>],
    builds: Vec<Build<'_>>,
    resources: &Resources,
) -> Result<Vec<Built>, EngineError> {
    let one = |(number, claim): Build<'_>| {
        let Wanted { prototype, options } = &wanted[number];
        let structure = prototype.build(options, &resources.interrupt)?;
        if let Some(claim) = claim {
            claim.fulfil(&structure);
        }
        Ok((number, structure))
    };
    let built: Vec<Result<Built, EngineError>> =
        resources.install(|| builds.into_par_iter().map(one).collect());
    built.into_iter().collect()
}
