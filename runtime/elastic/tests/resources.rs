//! Limits: memory is refused before it is allocated, computations end on request, and results do
//! not depend on the number of threads.

use crate::meshes::{block, clamped, load};
use calyx_elastic::assembly::System;
use calyx_elastic::condensation::static_condensation;
use calyx_elastic::factor::{Factor, Pencil, memory};
use calyx_elastic::model::SolidShape;
use calyx_elastic::{ElasticError, FixedComponents, Resources, statics};
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

fn model() -> calyx_elastic::ElasticModel {
    let mut model = block(SolidShape::Hexahedron20, [4, 4, 4], |at| at);
    let components = [true, true, true, false, false, false];
    model.fixed.extend((0..25).map(|node| FixedComponents { components, ..clamped(node) }));
    model
}

#[test]
fn memory_beyond_the_limit_is_refused_with_the_size_that_fits() {
    let model = model();
    let open = Resources::default();
    let system = System::new(&model, &open).expect("valid");
    let factor =
        Factor::new(Pencil::stiffness(&system.stiffness), &system.positions, &system.constrained(), &open);
    let (bytes, entries) = memory(factor.expect("regular").dissection());
    assert!(bytes > 8 * entries);
    let tight = Resources { memory: Some(bytes / 2), ..Resources::default() };
    for error in [
        statics::solve(&system, &[vec![]], &tight).expect_err("refused"),
        System::new(&model, &Resources { memory: Some(1000), ..Resources::default() })
            .err()
            .expect("refused"),
    ] {
        let ElasticError::Memory { message, help } = error else { panic!("{error}") };
        assert!(message.contains("the limit is"), "{message}");
        assert!(help.contains("coarsen the mesh to about"), "{help}");
    }
}

#[test]
fn computations_end_on_request() {
    let model = model();
    let system = System::new(&model, &Resources::default()).expect("valid");
    let calls = Arc::new(AtomicUsize::new(0));
    let count = calls.clone();
    let counting = Resources {
        interrupt: Interrupt::new(move || {
            count.fetch_add(1, Ordering::Relaxed);
            Ok(())
        }),
        memory: None,
    };
    statics::solve(&system, &[vec![]], &counting).expect("supported");
    let all = calls.load(Ordering::Relaxed);
    assert!(all > 100, "{all}");
    for stop in [0, all / 2, all - 1] {
        let left = AtomicUsize::new(stop);
        let question = move || {
            let earlier = left.fetch_update(Ordering::Relaxed, Ordering::Relaxed, |left| left.checked_sub(1));
            earlier.map(drop).map_err(|_| EngineError::new("E0700", "stopped", ""))
        };
        let resources = Resources { interrupt: Interrupt::new(question), memory: None };
        let error = statics::solve(&system, &[vec![]], &resources).expect_err("stopped");
        assert!(matches!(error, ElasticError::Interrupted(_)), "{error}");
    }
}

#[test]
fn results_do_not_depend_on_the_number_of_threads() {
    let model = model();
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| {
            let resources = Resources::default();
            let system = System::new(&model, &resources).expect("valid");
            let case = vec![load(124, [1e3, 2e3, 3e3, 0.0, 0.0, 0.0])];
            let solution =
                statics::solve(&system, std::slice::from_ref(&case), &resources).expect("supported");
            let condensed =
                static_condensation(&system, &[124, 120], &[case], &resources).expect("condensed");
            (solution, condensed.stiffness)
        })
    };
    let ((one, first), (other, second)) = (run(1), run(3));
    assert_eq!(one, other);
    assert_eq!(first, second);
}
