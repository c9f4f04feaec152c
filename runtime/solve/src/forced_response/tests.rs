//! Forced vibration against the closed form of one degree of freedom, against integration in time
//! of a parametrically excited system, and in its limits.

use super::basis::modes;
use super::*;
use std::f64::consts::TAU;

/// Orders of one mesh whose cycle is the period.
fn one_mesh(harmonics: usize) -> Orders {
    Orders::new(&[1], &[], harmonics)
}

/// Returns the smallest number of samples of one mesh.
fn sample_count(harmonics: usize) -> usize {
    one_mesh(harmonics).sampling(0, 1000).expect("a sampling").count()
}

/// Returns the amplitudes of samples at equal distances over the common period.
fn uniform_amplitudes(samples: &[f64], orders: &Orders) -> Amplitudes {
    amplitudes(samples, (&Sampling::Uniform { count: samples.len() }, orders))
}

/// One oscillator with constant stiffness, excited by harmonic static displacement.
pub(super) fn oscillator(damping_ratio: f64, harmonics: usize) -> PeriodicSystem {
    let samples = sample_count(harmonics);
    let statics = |k: usize| 2e-6 + 3e-6 * (TAU * k as f64 / samples as f64).cos();
    PeriodicSystem {
        mass: DMatrix::from_element(1, 1, 2.0),
        gyroscopic: DMatrix::zeros(1, 1),
        damping: DMatrix::zeros(1, 1),
        stiffness: vec![DMatrix::from_element(1, 1, 8e4); samples],
        statics: (0..samples).map(|k| DVector::from_element(1, statics(k))).collect(),
        orders: one_mesh(harmonics),
        sampling: Sampling::Uniform { count: samples },
        frequency: 100.0,
        damping_ratio,
    }
}

/// The coordinates themselves.
pub(super) fn coordinates(system: &PeriodicSystem) -> Vec<LinearQuantity> {
    let size = system.mass.nrows();
    let coordinate = |at: usize| LinearQuantity {
        statics: system.statics.iter().map(|statics| statics[at]).collect(),
        rows: vec![DVector::from_fn(size, |k, _| f64::from(u8::from(k == at)))],
        rates: Vec::new(),
    };
    (0..size).map(coordinate).collect()
}

#[test]
fn one_oscillator_has_the_closed_form() {
    let system = oscillator(0.03, 3);
    let forced = ForcedVibration::new(&system, &coordinates(&system), 4.0).expect("a finite system");
    for speed in [0.0, 0.5, 1.7, 2.0, 2.4, 4.0] {
        let omega = 100.0 * speed;
        let rest = Complex::new(200.0f64.powi(2) - omega * omega, 2.0 * 0.03 * 200.0 * omega);
        let expected = Complex::from(3e-6 * 200.0f64.powi(2)) / rest;
        let found = &forced.at(speed).expect("a finite response")[0];
        assert!((found[0] - 2e-6).norm() < 1e-18);
        assert!((found[1] - expected).norm() < 1e-12 * expected.norm(), "{speed}: {} {expected}", found[1]);
        assert!(found[2].norm() < 1e-18);
    }
}

/// Two coupled rotors with gyroscopic terms and a stiffness that varies by a third.
pub(super) fn parametric(harmonics: usize) -> PeriodicSystem {
    let samples = sample_count(harmonics);
    let phase = |k: usize| TAU * k as f64 / samples as f64;
    let (stiffness, statics): (Vec<_>, Vec<_>) = (0..samples).map(|k| coefficients(phase(k))).unzip();
    PeriodicSystem {
        mass: DMatrix::from_row_slice(2, 2, &[2.0, 0.3, 0.3, 1.0]),
        gyroscopic: DMatrix::from_row_slice(2, 2, &[0.0, 20.0, -20.0, 0.0]),
        damping: DMatrix::from_row_slice(2, 2, &[3.0, -1.0, -1.0, 2.0]),
        stiffness,
        statics,
        orders: one_mesh(harmonics),
        sampling: Sampling::Uniform { count: samples },
        frequency: 150.0,
        damping_ratio: 0.05,
    }
}

fn coefficients(phase: f64) -> (DMatrix<f64>, DVector<f64>) {
    let tooth = 6e4 * (1.0 + 0.35 * phase.cos() + 0.1 * (2.0 * phase).sin());
    let stiffness = DMatrix::from_row_slice(2, 2, &[4e4 + tooth, -tooth, -tooth, 9e4 + tooth]);
    (stiffness, DVector::from_row_slice(&[1e-5 * phase.cos(), 4e-6 * (phase.sin() - 0.5 * phase.cos())]))
}

/// Integrates to the periodic state with the classical Runge-Kutta method, and returns the samples
/// of the last of some periods. `coefficients` gives stiffness and static equilibrium at a fraction
/// of the period in radians.
fn integrated(
    system: &PeriodicSystem,
    coefficients: impl Fn(f64) -> (DMatrix<f64>, DVector<f64>),
    speed: f64,
    (periods, steps): (usize, usize),
) -> Vec<DVector<f64>> {
    let mean = system.stiffness.iter().sum::<DMatrix<f64>>() / system.stiffness.len() as f64;
    let (frequencies, shapes) = modes(&system.mass, &mean).expect("a finite system");
    let damping = DMatrix::from_diagonal(&DVector::from_fn(frequencies.len(), |k, _| {
        2.0 * system.damping_ratio * frequencies[k]
    }));
    let onto = &system.mass * &shapes;
    let damping = &onto * damping * onto.transpose() + &system.damping + speed * &system.gyroscopic;
    let inverse = system.mass.clone().try_inverse().expect("a positive definite mass");
    let omega = speed * system.frequency;
    let rate = |t: f64, x: &DVector<f64>, v: &DVector<f64>| {
        let (stiffness, statics) = coefficients(omega * t);
        -(&inverse * (&damping * v + stiffness * (x - statics)))
    };
    let h = TAU / omega / steps as f64;
    let size = system.mass.nrows();
    let (mut x, mut v) = (DVector::zeros(size), DVector::zeros(size));
    let mut last = Vec::new();
    for step in 0..periods * steps {
        let t = step as f64 * h;
        if step >= (periods - 1) * steps {
            last.push(x.clone());
        }
        let (k1, l1) = (v.clone(), rate(t, &x, &v));
        let (k2, l2) =
            (&v + &l1 * (h / 2.0), rate(t + h / 2.0, &(&x + &k1 * (h / 2.0)), &(&v + &l1 * (h / 2.0))));
        let (k3, l3) =
            (&v + &l2 * (h / 2.0), rate(t + h / 2.0, &(&x + &k2 * (h / 2.0)), &(&v + &l2 * (h / 2.0))));
        let (k4, l4) = (&v + &l3 * h, rate(t + h, &(&x + &k3 * h), &(&v + &l3 * h)));
        x += (k1 + 2.0 * k2 + 2.0 * k3 + k4) * (h / 6.0);
        v += (l1 + 2.0 * l2 + 2.0 * l3 + l4) * (h / 6.0);
    }
    last
}

#[test]
fn a_parametrically_excited_system_agrees_with_integration_in_time() {
    let system = parametric(10);
    let forced = ForcedVibration::new(&system, &coordinates(&system), 2.0).expect("a finite system");
    for speed in [0.3, 0.8, 1.3, 2.0] {
        let found = forced.at(speed).expect("a finite response");
        let expected = integrated(&system, coefficients, speed, (200, 400));
        for coordinate in 0..2 {
            let samples: Vec<f64> = expected.iter().map(|x| x[coordinate]).collect();
            let expected = uniform_amplitudes(&samples, &one_mesh(10));
            let largest = expected.iter().map(|c| c.norm()).fold(0.0, f64::max);
            for harmonic in 0..=10 {
                let error = (found[coordinate][harmonic] - expected[harmonic]).norm();
                assert!(
                    error < 1e-6 * largest,
                    "{speed}, {coordinate}, {harmonic}: {error:e} of {largest:e}"
                );
            }
        }
    }
}

#[test]
fn slow_rotation_is_static() {
    let system = parametric(6);
    let forced = ForcedVibration::new(&system, &coordinates(&system), 1.0).expect("a finite system");
    let found = forced.at(1e-6).expect("a finite response");
    for (found, statics) in found.iter().zip(forced.static_values()) {
        for (found, statics) in found.iter().zip(statics) {
            assert!((found - statics).norm() < 1e-12, "{found} {statics}");
        }
    }
}

#[test]
fn a_row_that_varies_multiplies_the_deviation() {
    // The force of the spring between the coordinates, against the same product sampled in time.
    let system = parametric(8);
    let samples = system.stiffness.len();
    let rows: Vec<_> =
        system.stiffness.iter().map(|k| DVector::from_row_slice(&[-k[(0, 1)], k[(0, 1)]])).collect();
    let force = LinearQuantity { statics: vec![0.0; samples], rows: rows.clone(), rates: Vec::new() };
    let mut quantities = coordinates(&system);
    quantities.push(force);
    let forced = ForcedVibration::new(&system, &quantities, 1.0).expect("a finite system");
    let found = forced.at(0.9).expect("a finite response");
    let at = |harmonics: &Amplitudes, k: usize| {
        let turned = |h: usize| Complex::from_polar(1.0, TAU * (h * k) as f64 / samples as f64);
        harmonics.iter().enumerate().map(|(h, c)| (c * turned(h)).re).sum::<f64>()
    };
    let product: Vec<f64> = (0..samples)
        .map(|k| (0..2).map(|c| rows[k][c] * (at(&found[c], k) - system.statics[k][c])).sum())
        .collect();
    let expected = uniform_amplitudes(&product, &one_mesh(8));
    for harmonic in 0..5 {
        let error = (found[2][harmonic] - expected[harmonic]).norm();
        assert!(error < 1e-5 * expected[1].norm(), "{harmonic}: {error:e}");
    }
}

#[test]
fn a_rate_multiplies_the_velocity() {
    let system = oscillator(0.03, 3);
    let mut quantities = coordinates(&system);
    quantities.push(LinearQuantity {
        statics: vec![0.0; sample_count(3)],
        rows: vec![DVector::zeros(1)],
        rates: vec![DVector::from_element(1, 5.0)],
    });
    let forced = ForcedVibration::new(&system, &quantities, 4.0).expect("a finite system");
    let found = forced.at(1.5).expect("a finite response");
    let expected = found[0][1] * Complex::new(0.0, 5.0 * 150.0);
    assert!((found[1][1] - expected).norm() < 1e-12 * expected.norm());
}

/// Mathieu's equation: at twice the natural frequency a variation of the stiffness by `2 a` grows
/// at the rate `a omega / 2` per time, less the damping, and at other speeds the damping remains.
#[test]
fn disturbances_grow_at_the_principal_parametric_resonance() {
    let samples = sample_count(2);
    let mathieu = |damping_ratio: f64| PeriodicSystem {
        stiffness: (0..samples)
            .map(|k| DMatrix::from_element(1, 1, 8e4 * (1.0 + 0.1 * (TAU * k as f64 / samples as f64).cos())))
            .collect(),
        frequency: 400.0,
        ..oscillator(damping_ratio, 2)
    };
    for damping_ratio in [0.0, 0.01, 0.05] {
        let forced = ForcedVibration::new(&mathieu(damping_ratio), &[], 1.0).expect("a finite system");
        let period = TAU / 400.0;
        let expected = ((0.1 / 4.0 - damping_ratio) * 200.0 * period).exp();
        let found = forced.growth(1.0);
        assert!((found / expected - 1.0).abs() < 3e-3, "{damping_ratio}: {found} {expected}");
        let elsewhere = forced.growth(0.7);
        let expected = (-damping_ratio * 200.0 * period / 0.7).exp();
        assert!((elsewhere / expected - 1.0).abs() < 2e-3, "{damping_ratio}: {elsewhere} {expected}");
    }
}

/// A stiff coordinate next to a soft one: the response does not depend on whether the stiff mode
/// has inertia.
#[test]
fn modes_far_above_the_excitation_follow_statically() {
    let harmonics = 3;
    let samples = sample_count(harmonics);
    let tooth = |k: usize| 5e6 * (1.0 + 0.3 * (TAU * k as f64 / samples as f64).cos());
    let system = PeriodicSystem {
        mass: DMatrix::from_row_slice(2, 2, &[1.0, 0.0, 0.0, 0.01]),
        gyroscopic: DMatrix::zeros(2, 2),
        damping: DMatrix::from_row_slice(2, 2, &[0.5, -0.5, -0.5, 0.5]),
        stiffness: (0..samples)
            .map(|k| DMatrix::from_row_slice(2, 2, &[1e4 + 2e6, -2e6, -2e6, 2e6 + tooth(k)]))
            .collect(),
        statics: (0..samples)
            .map(|k| DVector::from_row_slice(&[1e-5 / tooth(k) * 5e6, 2e-5 / tooth(k) * 5e6]))
            .collect(),
        orders: one_mesh(harmonics),
        sampling: Sampling::Uniform { count: samples },
        frequency: 20.0,
        damping_ratio: 0.0,
    };
    let mut quantities = coordinates(&system);
    quantities.push(LinearQuantity {
        statics: vec![3.0; samples],
        rows: (0..samples).map(|k| DVector::from_row_slice(&[0.0, tooth(k)])).collect(),
        rates: vec![DVector::from_row_slice(&[0.5, -0.5])],
    });
    let all = ForcedVibration::new(&system, &quantities, 1e4).expect("a finite system");
    let soft = ForcedVibration::new(&system, &quantities, 12.0).expect("a finite system");
    assert_eq!((all.unknowns(), soft.unknowns()), (14, 7));
    for speed in [0.1, 1.0, 5.0] {
        let (all, soft) = (all.at(speed).expect("finite"), soft.at(speed).expect("finite"));
        for (all, soft) in all.iter().zip(&soft) {
            let largest = all.iter().map(|value| value.norm()).fold(0.0, f64::max);
            for (all, soft) in all.iter().zip(soft) {
                assert!((all - soft).norm() < 1e-3 * largest, "{speed}: {all} {soft}");
            }
        }
    }
}

/// A rotor that no spring holds keeps its speed: its inertia resists the motion of the mesh.
#[test]
fn a_free_rotor_resists_with_its_inertia() {
    let samples = sample_count(2);
    let wave = |k: usize| (TAU * k as f64 / samples as f64).cos();
    let system = PeriodicSystem {
        mass: DMatrix::from_row_slice(2, 2, &[3.0, 0.0, 0.0, 1.0]),
        gyroscopic: DMatrix::zeros(2, 2),
        damping: DMatrix::zeros(2, 2),
        stiffness: vec![DMatrix::from_row_slice(2, 2, &[1e4, -1e4, -1e4, 1e4]); samples],
        statics: (0..samples).map(|k| DVector::from_row_slice(&[1e-3 * wave(k), 0.0])).collect(),
        orders: one_mesh(2),
        sampling: Sampling::Uniform { count: samples },
        frequency: 1e4,
        damping_ratio: 0.0,
    };
    let forced = ForcedVibration::new(&system, &coordinates(&system), 1.0).expect("a finite system");
    let found = forced.at(1.0).expect("a finite response");
    // Far above the resonance, both masses rest.
    assert!(found[0][1].norm() < 1e-6 && found[1][1].norm() < 1e-6, "{found:?}");
}

/// Samples a system over its common period at the smallest number of samples that tells its orders
/// apart.
fn sampled(
    orders: Orders,
    coefficients: impl Fn(f64) -> (DMatrix<f64>, DVector<f64>),
    frequency: f64,
) -> PeriodicSystem {
    let sampling = orders.sampling(0, 5000).expect("a sampling");
    let (stiffness, statics): (Vec<_>, Vec<_>) =
        (0..sampling.count()).map(|k| coefficients(TAU * sampling.place(k))).unzip();
    PeriodicSystem {
        mass: DMatrix::from_row_slice(2, 2, &[2.0, 0.0, 0.0, 2.0]),
        gyroscopic: DMatrix::from_row_slice(2, 2, &[0.0, 5.0, -5.0, 0.0]),
        damping: DMatrix::from_row_slice(2, 2, &[3.0, -1.0, -1.0, 2.0]),
        stiffness,
        statics,
        orders,
        sampling,
        frequency,
        damping_ratio: 0.04,
    }
}

/// Asserts that the response of all coordinates agrees with integration in time to a fraction of
/// the largest amplitude.
fn assert_integrated(
    system: &PeriodicSystem,
    coefficients: impl Fn(f64) -> (DMatrix<f64>, DVector<f64>),
    effort: (usize, usize),
    tolerance: f64,
) {
    let forced = ForcedVibration::new(system, &coordinates(system), 2.0).expect("a finite system");
    for speed in [0.7, 1.6] {
        let found = forced.at(speed).expect("a finite response");
        let expected = integrated(system, &coefficients, speed, effort);
        for coordinate in 0..system.mass.nrows() {
            let samples: Vec<f64> = expected.iter().map(|x| x[coordinate]).collect();
            let expected = uniform_amplitudes(&samples, &system.orders);
            let largest = expected.iter().map(|c| c.norm()).fold(0.0, f64::max);
            for (line, (found, expected)) in found[coordinate].iter().zip(&expected).enumerate() {
                let error = (found - expected).norm();
                assert!(
                    error < tolerance * largest,
                    "{speed}, {coordinate}, {line}: {error:e} of {largest:e}"
                );
            }
        }
    }
}

/// A rotor on two springs that rotate with a carrier, and a mesh of 21 cycles in a revolution that
/// acts along one of them and on a rotation: in axes that rotate with the carrier, the springs are
/// constant, so displacements have sidebands of the mesh frequency, and the rotation has none.
#[test]
fn springs_on_a_carrier_give_sidebands() {
    let coefficients = |turn: f64| {
        let mesh = 21.0 * turn;
        let tooth = 1.0 + 0.2 * mesh.cos();
        let (sine, cosine) = turn.sin_cos();
        let axis = DVector::from_row_slice(&[cosine, sine, 0.0]);
        let across = DVector::from_row_slice(&[-sine, cosine, 0.0]);
        let normal = DVector::from_row_slice(&[cosine, sine, 1.0]);
        let mut stiffness = &normal * normal.transpose() * 8e4 * tooth + &across * across.transpose() * 3e4;
        stiffness += DMatrix::from_diagonal(&DVector::from_row_slice(&[2e4, 2e4, 5e4]));
        let statics = &axis * (4e-6 + 3e-6 * mesh.cos()) + &across * 2e-6 * (2.0 * mesh).sin();
        (stiffness, statics + DVector::from_row_slice(&[0.0, 0.0, 2e-6 * mesh.sin()]))
    };
    // Isotropic dampers: others would excite sidebands of higher orders.
    let system = sampled(Orders::new(&[21], &[1], 5), coefficients, 8.0);
    let system = PeriodicSystem {
        mass: DMatrix::identity(3, 3) * 2.0,
        gyroscopic: DMatrix::zeros(3, 3),
        damping: DMatrix::identity(3, 3) * 3.0,
        damping_ratio: 0.0,
        ..system
    };
    assert_integrated(&system, coefficients, (60, 21 * 200), 1e-6);
}

/// Isotropic springs do not rotate with a carrier, and their damping ratio is that of a system
/// without it.
#[test]
fn the_damping_ratio_holds_with_carriers() {
    let coefficients = |turn: f64| {
        let statics = DVector::from_row_slice(&[3e-6 * (21.0 * turn).cos(), 0.0]);
        (DMatrix::identity(2, 2) * 8e4, statics)
    };
    let system = sampled(Orders::new(&[21], &[1], 2), coefficients, 8.0);
    let system = PeriodicSystem {
        gyroscopic: DMatrix::zeros(2, 2),
        damping: DMatrix::zeros(2, 2),
        damping_ratio: 0.03,
        ..system
    };
    let forced = ForcedVibration::new(&system, &coordinates(&system), 2.0).expect("a finite system");
    let line = system.orders.lines().position(|(order, _)| order == 21).expect("the mesh frequency");
    for speed in [0.5, 1.19, 1.6] {
        let omega = 21.0 * 8.0 * speed;
        let rest = Complex::new(200.0f64.powi(2) - omega * omega, 2.0 * 0.03 * 200.0 * omega);
        let expected = Complex::from(3e-6 * 200.0f64.powi(2)) / rest;
        let found = forced.at(speed).expect("a finite response")[0][line];
        assert!((found - expected).norm() < 1e-10 * expected.norm(), "{speed}: {found} {expected}");
    }
}

/// Two meshes, of 8 and 5 cycles in the common period, each with a rotor of its own: exact, as no
/// mesh acts on the rotor of the other. A spring between the rotors causes interactions of all
/// orders, of which the lowest are solved.
#[test]
fn two_mesh_frequencies_agree_with_integration_in_time() {
    let with = |coupling: f64| {
        move |turn: f64| {
            let [one, other] = [8.0 * turn, 5.0 * turn];
            let [first, second] = [9e4 * (1.0 + 0.2 * one.cos()), 1.2e5 * (1.0 + 0.1 * other.sin())];
            let stiffness = [first + coupling, -coupling, -coupling, second + coupling];
            let statics = [1e-5 * one.cos(), 6e-6 * (other.cos() + (2.0 * other).sin())];
            (DMatrix::from_row_slice(2, 2, &stiffness), DVector::from_row_slice(&statics))
        }
    };
    let orders = Orders::new(&[8, 5], &[], 6);
    for (coupling, tolerance) in [(0.0, 1e-6), (1e4, 5e-3)] {
        let mut system = sampled(orders.clone(), with(coupling), 20.0);
        system.gyroscopic.fill(0.0);
        system.damping = DMatrix::identity(2, 2) * 3.0;
        assert_integrated(&system, with(coupling), (100, 2000), tolerance);
    }
}

/// A system whose number of unknowns requires iteration, against the same one with every order in
/// one harmonic's system.
#[test]
fn the_iteration_gives_the_direct_solution() {
    let size = 9;
    let orders = one_mesh(7);
    let samples = sample_count(7);
    let spring = |k: usize, i: usize| {
        let phase = TAU * (k as f64 / samples as f64 + 0.1 * i as f64);
        1e5 * (1.0 + i as f64) * (1.0 + 0.25 * phase.cos() + 0.1 * (2.0 * phase).sin())
    };
    let chain = |k: usize| {
        DMatrix::from_fn(size, size, |i, j| match i.abs_diff(j) {
            0 => spring(k, i) + spring(k, i + 1),
            1 => -spring(k, i.max(j)),
            _ => 0.0,
        })
    };
    let system = PeriodicSystem {
        mass: DMatrix::identity(size, size),
        gyroscopic: DMatrix::zeros(size, size),
        damping: DMatrix::identity(size, size),
        stiffness: (0..samples).map(chain).collect(),
        statics: (0..samples)
            .map(|k| DVector::from_fn(size, |i, _| 1e-6 * (TAU * k as f64 / samples as f64 + i as f64).sin()))
            .collect(),
        orders,
        sampling: Sampling::Uniform { count: samples },
        frequency: 300.0,
        damping_ratio: 0.02,
    };
    let forced = ForcedVibration::new(&system, &coordinates(&system), 3.0).expect("a finite system");
    assert!(forced.unknowns() > 120, "{}", forced.unknowns());
    let together = PeriodicSystem { orders: system.orders.clone().in_one_cluster(), ..system.clone() };
    let direct = ForcedVibration::new(&together, &coordinates(&system), 3.0).expect("a finite system");
    for speed in [0.3, 1.0, 2.2] {
        let (found, expected) = (forced.at(speed).expect("finite"), direct.at(speed).expect("finite"));
        for (found, expected) in found.iter().zip(&expected) {
            let largest = expected.iter().map(|value| value.norm()).fold(0.0, f64::max);
            for (found, expected) in found.iter().zip(expected) {
                assert!((found - expected).norm() < 1e-9 * largest, "{speed}: {found} {expected}");
            }
        }
    }
}
