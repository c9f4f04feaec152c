//! Memory requests, interruption, bits and rejected arguments.

use crate::shapes::sphere;
use crate::spheres::frequency;
use calyx_acoustics::{AcousticError, Fluid, Method, RadiationModel, Settings, rayleigh};
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use faer::c64;

fn model(level: usize) -> RadiationModel {
    RadiationModel { mesh: sphere(level, 1.0), fluid: Fluid::AIR }
}

fn settings(method: Method) -> Settings {
    Settings { method, ..Settings::default() }
}

#[test]
fn memory_is_requested_before_it_is_allocated() {
    let model = model(2);
    for method in [Method::Dense, Method::Hierarchical] {
        let interrupt = Interrupt::never();
        let equations = model.equations(frequency(1.0), &settings(method), &interrupt).expect("assembled");
        assert!(interrupt.largest_request() > 0, "{method:?}");
        // The triangular factors of the preconditioner are small.
        assert!(interrupt.largest_request() as f64 > 0.8 * equations.memory() as f64, "{method:?}");
        drop(equations);

        let refusing = Interrupt::counting(|request| {
            let refused = EngineError::new("E0711", "not enough memory", "coarsen the mesh");
            if request.bytes + request.promised > 100_000 { Err(refused) } else { Ok(()) }
        });
        let error = model.equations(frequency(1.0), &settings(method), &refusing).expect_err("refused");
        assert!(matches!(&error, AcousticError::Interrupted(_)), "{error}");
        assert_eq!(error.help(), "coarsen the mesh");
    }
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    let model = model(2);
    let velocities: Vec<c64> =
        (0..model.mesh.triangles().len()).map(|t| c64::new((t as f64).sin(), 0.1)).collect();
    for method in [Method::Dense, Method::Hierarchical] {
        let [one, three] = [1, 3].map(|threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
            pool.install(|| {
                let interrupt = Interrupt::never();
                let equations =
                    model.equations(frequency(3.0), &settings(method), &interrupt).expect("assembled");
                equations.solve(std::slice::from_ref(&velocities), &interrupt).expect("solved").remove(0)
            })
        });
        assert_eq!(one, three, "{method:?}");
    }
}

#[test]
fn invalid_arguments_are_rejected() {
    let mut model = model(0);
    let interrupt = Interrupt::never();
    let rejected = |error: AcousticError| {
        assert!(matches!(&error, AcousticError::Input { .. }), "{error:?}");
        assert!(!error.help().is_empty(), "{error}");
    };
    for frequency in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        rejected(model.equations(frequency, &Settings::default(), &interrupt).expect_err("frequency"));
    }
    let inaccurate = Settings { accuracy: 0.5, ..Settings::default() };
    rejected(model.equations(1.0, &inaccurate, &interrupt).expect_err("accuracy"));

    let equations = model.equations(10.0, &Settings::default(), &interrupt).expect("assembled");
    let velocities = vec![c64::new(1.0, 0.0); 20];
    rejected(equations.solve(&[velocities[1..].to_vec()], &interrupt).expect_err("number"));
    let infinite = vec![c64::new(f64::INFINITY, 0.0); 20];
    rejected(equations.solve(&[infinite], &interrupt).expect_err("not finite"));
    let radiation = equations.solve(std::slice::from_ref(&velocities), &interrupt).expect("solved").remove(0);
    for point in [[0.0, 0.1, 0.2], model.mesh.vertices()[3], model.mesh.centroid(2), [f64::NAN; 3]] {
        rejected(
            equations.pressures(&radiation, &[[3.0; 3], point], &interrupt).expect_err("not in the fluid"),
        );
        rejected(equations.transfer_vectors(&[point], &interrupt).expect_err("not in the fluid"));
    }
    let triangle = [[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]];
    let power = rayleigh::power(&triangle, &velocities, &Fluid::AIR, 100.0, &interrupt);
    rejected(power.expect_err("number"));
    drop(equations);
    model.fluid.density = 0.0;
    rejected(model.equations(10.0, &Settings::default(), &interrupt).expect_err("density"));
}
