//! Tests of the cache: size limit, one build for simultaneous requests, and failed builds.

use super::{Answer, CacheCounts, Key, Operator, OperatorCache};
use crate::profile::Profile;
use crate::{AnyStructure, Chart, RigidStructure, StressPoint, Structure, SurfaceLoad};
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use rayon::prelude::*;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Barrier};
use std::thread;
use std::time::Duration;

/// Structure of a given size.
struct Sized(usize);

impl Structure for Sized {
    fn profile(&self, _: u32) -> Arc<dyn Profile> {
        unreachable!("a structure without surfaces")
    }

    fn teeth(&self) -> u32 {
        1
    }

    fn surface_modulus(&self) -> f64 {
        f64::INFINITY
    }

    fn reference_length(&self) -> f64 {
        1.0
    }

    fn add_compliance_until(
        &self,
        _: Chart,
        _: &[f64],
        _: Chart,
        _: &[f64],
        _: &mut [f64],
        _: &Interrupt,
    ) -> Result<(), EngineError> {
        Ok(())
    }

    fn stresses(&self, _: u32, _: u32, _: &[SurfaceLoad]) -> Vec<(StressPoint, f64)> {
        Vec::new()
    }

    fn bytes(&self) -> usize {
        self.0
    }
}

fn key(number: u64) -> Key {
    Key::of("test").count(number).finish()
}

fn rigid() -> AnyStructure {
    AnyStructure::Plane(Arc::new(RigidStructure::new(Vec::new(), 1)))
}

/// Returns whether both are the same structure.
fn is_same(one: &AnyStructure, other: &AnyStructure) -> bool {
    matches!((one, other), (AnyStructure::Plane(one), AnyStructure::Plane(other)) if Arc::ptr_eq(one, other))
}

fn failure() -> EngineError {
    EngineError::new("E0678", "it cannot be built", "")
}

/// Returns whether the cache contains the structure, without building it.
fn has(cache: &OperatorCache, number: u64) -> bool {
    cache.structure(key(number), &Interrupt::never(), || Err(failure())).is_ok()
}

#[test]
fn keys_differ_by_every_value_and_where_it_stands() {
    let kinds = ["gear", "disc", ""].map(|kind| Key::of(kind).finish());
    let keys = [
        Key::of("disc").number(0.0).finish(),
        Key::of("disc").number(-0.0).finish(),
        Key::of("disc").count(0).finish(),
        Key::of("disc").flag(false).finish(),
        Key::of("disc").flag(true).finish(),
        Key::of("disc").numbers(&[]).finish(),
        Key::of("disc").numbers(&[1.0, 2.0]).numbers(&[]).finish(),
        Key::of("disc").numbers(&[1.0]).numbers(&[2.0]).finish(),
        Key::of("disc").numbers(&[2.0]).numbers(&[1.0]).finish(),
        Key::of("disc").text("ab").text("c").finish(),
        Key::of("disc").text("a").text("bc").finish(),
        Key::of("discab").text("c").finish(),
    ];
    let mut all: Vec<Key> = kinds.into_iter().chain(keys).collect();
    all.sort_unstable();
    all.dedup();
    assert_eq!(all.len(), kinds.len() + keys.len());
    assert_eq!(Key::of("disc").number(1.5).finish(), Key::of("disc").number(1.5).finish());
}

#[test]
fn a_kept_structure_is_the_one_that_was_built() {
    let cache = OperatorCache::new(1000);
    let never = Interrupt::never();
    let built = cache.structure(key(1), &never, || Ok(rigid())).unwrap();
    let again = cache.structure(key(1), &never, || Err(failure())).unwrap();
    assert!(is_same(&built, &again));
    assert!(!has(&cache, 2));
    assert_eq!(cache.counts(), CacheCounts { hits: 1, misses: 2, structures: 1, bytes: 0 });
}

#[test]
fn what_was_used_least_recently_goes_first() {
    let cache = OperatorCache::new(100);
    let put = |number: u64, bytes: usize| {
        let built = cache
            .structure(key(number), &Interrupt::never(), || Ok(AnyStructure::Plane(Arc::new(Sized(bytes)))));
        assert_eq!(built.unwrap().bytes(), bytes);
        assert!(cache.counts().bytes <= 100);
    };
    put(1, 40);
    put(2, 40);
    assert!(has(&cache, 1));
    // 2 was used before 1.
    put(3, 30);
    assert_eq!([1, 2, 3].map(|number| has(&cache, number)), [true, false, true]);
    assert_eq!(cache.counts().bytes, 70);
    // A structure larger than the limit is passed on, and evicts nothing.
    put(4, 101);
    assert_eq!([1, 3, 4].map(|number| has(&cache, number)), [true, true, false]);
    put(5, 100);
    assert_eq!([1, 3, 5].map(|number| has(&cache, number)), [false, false, true]);
}

#[test]
fn threads_that_ask_at_once_build_once() {
    let cache = OperatorCache::new(1000);
    let (start, builds) = (Barrier::new(8), AtomicUsize::new(0));
    let structures: Vec<_> = thread::scope(|scope| {
        let ask = || {
            start.wait();
            cache.structure(key(1), &Interrupt::never(), || {
                builds.fetch_add(1, Ordering::Relaxed);
                thread::sleep(Duration::from_millis(50));
                Ok(AnyStructure::Plane(Arc::new(Sized(500))))
            })
        };
        let threads: Vec<_> = (0..8).map(|_| scope.spawn(ask)).collect();
        threads.into_iter().map(|thread| thread.join().unwrap().unwrap()).collect()
    });
    assert_eq!(builds.load(Ordering::Relaxed), 1);
    assert!(structures.iter().all(|structure| is_same(structure, &structures[0])));
    assert_eq!(cache.counts(), CacheCounts { hits: 7, misses: 1, structures: 1, bytes: 500 });
}

#[test]
fn who_waits_gets_the_structure_even_if_it_cannot_be_kept() {
    let cache = OperatorCache::new(0);
    let Answer::Yours(claim) = cache.ask(key(1)) else { panic!("nobody has it") };
    let Answer::Elsewhere(flight) = cache.ask(key(1)) else { panic!("it is being built") };
    let built = AnyStructure::Plane(Arc::new(Sized(500)));
    claim.fulfil(&built.clone().into());
    let waited = cache
        .wait(key(1), &flight, &Interrupt::never())
        .unwrap()
        .and_then(Operator::structure)
        .expect("it was built");
    assert!(is_same(&waited, &built));
    assert_eq!(cache.counts(), CacheCounts { hits: 1, misses: 1, structures: 0, bytes: 0 });
}

#[test]
fn a_build_that_fails_or_panics_leaves_nothing_and_the_next_one_builds() {
    let cache = OperatorCache::new(1000);
    let never = Interrupt::never();
    assert_eq!(cache.structure(key(1), &never, || Err(failure())).err(), Some(failure()));
    let panics = || cache.structure(key(1), &never, || panic!("a defect of the prototype"));
    assert!(catch_unwind(AssertUnwindSafe(panics)).is_err());
    assert_eq!(cache.counts(), CacheCounts { misses: 2, ..CacheCounts::default() });

    // A thread waits for a build that fails, and then builds the structure itself.
    let (first_builds, second_builds) = (Barrier::new(2), AtomicUsize::new(0));
    thread::scope(|scope| {
        let first = scope.spawn(|| {
            cache.structure(key(1), &never, || {
                first_builds.wait();
                thread::sleep(Duration::from_millis(50));
                Err(failure())
            })
        });
        let second = scope.spawn(|| {
            first_builds.wait();
            cache.structure(key(1), &never, || {
                second_builds.fetch_add(1, Ordering::Relaxed);
                Ok(rigid())
            })
        });
        assert_eq!(first.join().unwrap().err(), Some(failure()));
        assert!(second.join().unwrap().is_ok());
    });
    assert_eq!(second_builds.load(Ordering::Relaxed), 1);
    assert!(has(&cache, 1));
}

#[test]
fn who_waits_can_be_interrupted() {
    let cache = OperatorCache::new(1000);
    let (building, done) = (Barrier::new(2), Barrier::new(2));
    let enough = EngineError::new("E0704", "the run was cancelled", "");
    thread::scope(|scope| {
        let builder = scope.spawn(|| {
            cache.structure(key(1), &Interrupt::never(), || {
                building.wait();
                done.wait();
                Ok(rigid())
            })
        });
        building.wait();
        let asked = Arc::new(AtomicUsize::new(0));
        let question = {
            let enough = enough.clone();
            move || if asked.fetch_add(1, Ordering::Relaxed) < 3 { Ok(()) } else { Err(enough.clone()) }
        };
        let waited = cache.structure(key(1), &Interrupt::new(question), || Ok(rigid()));
        assert_eq!(waited.err(), Some(enough));
        done.wait();
        assert!(builder.join().unwrap().is_ok());
    });
    assert!(has(&cache, 1));
}

#[test]
fn builds_that_share_their_threads_do_not_wait_for_each_other() {
    // While a build waits for its own parallel work, its thread may receive another job that needs
    // the same structure. If that job waited, both would deadlock.
    let cache = OperatorCache::new(1000);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().unwrap();
    let built = pool.install(|| {
        let one = |job: u64| {
            cache.structure(key(job % 3), &Interrupt::never(), || {
                let work: u64 = (0..64_u64)
                    .into_par_iter()
                    .map(|part| (0..2000).fold(part, |sum, i: u64| sum.rotate_left(3) ^ i))
                    .reduce(|| 0, u64::wrapping_add);
                Ok(AnyStructure::Plane(Arc::new(Sized(usize::from(work == 1)))))
            })
        };
        (0..200).into_par_iter().map(one).filter(Result::is_ok).count()
    });
    assert_eq!(built, 200);
}
