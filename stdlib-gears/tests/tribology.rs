//! Sliding, rolling, friction, temperature and film along contact lines: closed forms of involutes,
//! of external, internal, helical and planetary meshes, and independence of the contact grid.

use crate::common::INCH;
use crate::common::pair::{MESH, PLAIN, PairOptions, pair, system};
use crate::planetary::set::{Set, SetOptions};
use crate::solid::pairs::{self, Options};
use calyx_gears::helix::Hand;
use calyx_gears::mesh_geometry::MeshGeometry;
use calyx_runtime::lubrication::{BaseOil, Lubrication, Oil, RollingContact};
use calyx_runtime::observables::{
    Efficiency, EntrainmentVelocity, Equilibrium, FrictionLoss, LocalQuantity, LubricatedEfficiency,
    LubricatedExtreme, LubricatedLoss, MaxContactPressure, Observe, PairLoad,
};
use calyx_runtime::scene::{PairId, Scene, StructureOptions};
use calyx_runtime::step::StepResult;
use calyx_runtime::system::System;
use std::f64::consts::PI;

/// Speed of the first gear, rad/s.
const SPEED: f64 = 150.0;
const FRICTION: f64 = 0.05;

fn lubrication(friction: Option<f64>) -> Lubrication {
    Lubrication {
        oil: Oil { viscosities: [220e-6, 19e-6], density: 890.0, base: BaseOil::Mineral },
        oil_temperature: 70.0,
        bulk_temperature: 85.0,
        roughness: 0.6e-6,
        friction,
        thermal_contact: [13.8e3, 13.8e3],
    }
}

fn extreme(quantity: LocalQuantity) -> LubricatedExtreme {
    LubricatedExtreme { pair: MESH, quantity }
}

fn close(found: f64, expected: f64, tolerance: f64) -> bool {
    (found - expected).abs() <= tolerance * found.abs().max(expected.abs())
}

/// Rolling contact of spur involutes at a distance from the first gear's tangent point on the line
/// of action.
struct Involutes {
    radii: [f64; 2],
    speeds: [f64; 2],
    internal: bool,
}

impl Involutes {
    fn at(geometry: &MeshGeometry, first_radius: f64, speeds: [f64; 2]) -> Involutes {
        let second = match geometry.internal {
            true => geometry.tangent_distance + first_radius,
            false => geometry.tangent_distance - first_radius,
        };
        Involutes { radii: [first_radius, second], speeds: speeds.map(f64::abs), internal: geometry.internal }
    }

    fn rolling(&self) -> [f64; 2] {
        [0, 1].map(|side: usize| self.speeds[side] * self.radii[side])
    }

    fn curvature(&self) -> f64 {
        let [first, second] = self.radii;
        1.0 / first + if self.internal { -1.0 / second } else { 1.0 / second }
    }

    fn check(&self, contact: &RollingContact, tolerance: f64, what: &str) {
        let [first, second] = self.rolling();
        let found = contact.rolling.map(f64::abs);
        assert!(close(found[0], first, tolerance), "{what}: {contact:?} {first} {second}");
        assert!(close(found[1], second, tolerance), "{what}: {contact:?} {first} {second}");
        // Both surfaces move through the contact in the same direction.
        assert!(contact.rolling[0] * contact.rolling[1] > 0.0, "{what}: {contact:?}");
        let scale = first + second;
        assert!((contact.sliding - (first - second).abs()).abs() < tolerance * scale, "{what}: {contact:?}");
        assert!(close(contact.curvature, self.curvature(), tolerance), "{what}: {contact:?}");
    }
}

/// The chapter 5 pair at a fraction of its mesh cycle. Only pair 0 is in contact from 0.4925 on.
fn at(scene: &Scene, part: f64, mut look: impl FnMut(&System<'_>, &StepResult)) {
    let mesh = scene.pairs[MESH.0].mesh.as_ref().expect("a mesh");
    let system = system(scene);
    let step = system.solve(mesh.start + part * mesh.period).expect("equilibrium");
    look(&system, &step);
}

fn chapter_5(friction: Option<f64>) -> (Scene, MeshGeometry) {
    let options = PairOptions { speed: SPEED, ..PairOptions::chapter_5(&PLAIN) };
    let (mut scene, _) = pair(&options);
    scene.pairs[MESH.0].lubrication = Some(lubrication(friction));
    let [first, second] = options.gears.each_ref().map(|member| member.gear());
    (scene, MeshGeometry::external(first, second, 3.0 * INCH).expect("they mesh"))
}

#[test]
fn a_spur_pair_rolls_and_slides_as_involutes_do() {
    let (scene, geometry) = chapter_5(Some(FRICTION));
    let mesh = scene.pairs[MESH.0].mesh.clone().expect("a mesh");
    for part in [0.6, 0.8, 0.95] {
        at(&scene, part, |system, step| {
            let view = Equilibrium::new(system, step);
            let roll = mesh.roll[0] + part * (mesh.roll[1] - mesh.roll[0]);
            let ideal = Involutes::at(&geometry, geometry.base_radius[0] * roll, [SPEED, 0.5 * SPEED]);
            let all: Vec<_> = view.contacts(MESH).flat_map(|contact| contact.rolling_contacts()).collect();
            let [(_, contact)] = &all[..] else { panic!("{}: {all:?}", part) };
            ideal.check(contact, 1e-6, &part.to_string());
            let value = |observable: &dyn calyx_runtime::observables::Observable| {
                system.value(step, observable).value
            };
            let force = value(&PairLoad(MESH, 0));
            assert!(close(contact.line_load, force / INCH, 1e-12));
            let [first, second] = ideal.rolling();
            assert!(close(value(&EntrainmentVelocity(MESH, 0)), 0.5 * (first + second), 1e-6));
            // The Hertzian pressure of the line load is that of the solution.
            let pressure = value(&MaxContactPressure(MESH));
            assert!(
                close(contact.hertz_pressure(), pressure, 5e-3),
                "{pressure} {}",
                contact.hertz_pressure()
            );
            // Blok's formula with this pressure, as ISO/TS 6336-22 writes it for a uniform heat
            // flux.
            let uniform = 0.5 * PI.sqrt() * FRICTION * contact.hertz_pressure() * contact.sliding
                / (13.8e3 * (first.sqrt() + second.sqrt()))
                * (2.0 * contact.half_width()).sqrt();
            let flash = value(&extreme(LocalQuantity::FlashTemperature));
            assert!(close(flash, uniform * 1.11 * 0.5 * PI.sqrt(), 1e-6), "{flash} {uniform}");
            assert!(close(value(&extreme(LocalQuantity::ContactTemperature)), 85.0 + flash, 1e-12));
            let heat = FRICTION * force / INCH * (first - second).abs();
            assert!(close(value(&extreme(LocalQuantity::FrictionPower)), heat, 1e-4));
            let film = value(&extreme(LocalQuantity::FilmThickness));
            assert!((1e-8..1e-5).contains(&film), "{film}");
            assert_eq!(value(&extreme(LocalQuantity::SpecificFilmThickness)), film / 0.6e-6);
        });
    }
}

/// A constant coefficient has the same loss as without lubrication; the local one is of the usual
/// size.
#[test]
fn the_loss_is_friction_times_force_times_sliding() {
    for part in [0.1, 0.3, 0.7] {
        let (scene, _) = chapter_5(Some(FRICTION));
        at(&scene, part, |system, step| {
            let value = |observable: &dyn calyx_runtime::observables::Observable| {
                system.value(step, observable).value
            };
            let [loss, efficiency] =
                [value(&FrictionLoss(MESH, FRICTION)), value(&Efficiency(MESH, FRICTION))];
            assert!(close(value(&LubricatedLoss(MESH)), loss, 1e-12));
            assert!(close(value(&LubricatedEfficiency(MESH)), efficiency, 1e-12));
        });
        let (scene, _) = chapter_5(None);
        at(&scene, part, |system, step| {
            let unit = system.value(step, &FrictionLoss(MESH, 1.0)).value;
            let mean = system.value(step, &LubricatedLoss(MESH)).value / unit;
            assert!((0.02..0.12).contains(&mean), "{mean}");
        });
    }
}

#[test]
fn nothing_slides_or_heats_at_the_pitch_point() {
    let (scene, geometry) = chapter_5(None);
    let mesh = scene.pairs[MESH.0].mesh.clone().expect("a mesh");
    let part = (geometry.first_roll.pitch_point - mesh.roll[0]) / (mesh.roll[1] - mesh.roll[0]);
    let value = |part: f64, quantity| {
        let mut found = f64::NAN;
        at(&scene, part, |system, step| found = system.value(step, &extreme(quantity)).value);
        found
    };
    let [here, beside] = [part, part + 0.1].map(|part| value(part, LocalQuantity::FlashTemperature));
    assert!(here < 1e-4 * beside, "{here} {beside}");
    assert!(value(part, LocalQuantity::FilmThickness) > 0.0);
}

#[test]
fn without_motion_or_lubrication_there_is_no_heat() {
    let (mut scene, _) = chapter_5(None);
    for body in &mut scene.bodies {
        let frame = body.motion.frame(0.0);
        body.motion = std::sync::Arc::new(Still(frame));
    }
    for (lubricated, expected) in [(true, 0.0), (false, f64::NAN)] {
        scene.pairs[MESH.0].lubrication = lubricated.then(|| lubrication(None));
        let system = system(&scene);
        let step = system.solve(0.0).expect("equilibrium");
        for quantity in [
            LocalQuantity::FrictionPower,
            LocalQuantity::FlashTemperature,
            LocalQuantity::FilmThickness,
            LocalQuantity::SpecificFilmThickness,
        ] {
            let found = system.value(&step, &extreme(quantity)).value;
            assert!(found == expected || (found.is_nan() && expected.is_nan()), "{quantity:?}: {found}");
        }
        if lubricated {
            assert_eq!(system.value(&step, &LubricatedLoss(MESH)).value, 0.0);
            assert_eq!(system.value(&step, &LubricatedEfficiency(MESH)).value, 1.0);
        }
    }
}

/// Frame at rest.
struct Still([f64; 12]);

impl calyx_runtime::motion::Motion for Still {
    fn frame(&self, _: f64) -> [f64; 12] {
        self.0
    }

    fn rate(&self, _: f64) -> [f64; 12] {
        [0.0; 12]
    }

    fn acceleration(&self, _: f64) -> [f64; 12] {
        [0.0; 12]
    }
}

/// The line load is an integral over the grid, and the other quantities follow from it.
#[test]
fn maxima_do_not_depend_on_the_contact_grid() {
    let found = |half_cells: usize| {
        let (mut scene, _) = chapter_5(None);
        scene.pairs[MESH.0].grid.half_cells = Some(half_cells);
        let mut values = [0.0; 2];
        at(&scene, 0.2, |system, step| {
            values = [LocalQuantity::FlashTemperature, LocalQuantity::FilmThickness]
                .map(|quantity| system.value(step, &extreme(quantity)).value);
        });
        values
    };
    let [coarse, fine] = [8, 48].map(found);
    for (coarse, fine) in coarse.into_iter().zip(fine) {
        assert!(close(coarse, fine, 1e-3), "{coarse} {fine}");
    }
}

/// In the frame of a line of centres, spur or helical, the rolling radii are the tangents from the
/// base cylinders to the contact point.
fn check_by_tangents(
    view: Equilibrium<'_>,
    pair: PairId,
    speeds: [f64; 2],
    base_helix: f64,
    tolerance: f64,
) -> usize {
    let (mesh, bodies) = view.mesh(pair).expect("a mesh");
    let mut count = 0;
    for (slice, contact) in view.contacts(pair).flat_map(|contact| contact.rolling_contacts()) {
        let radii = [0, 1].map(|side: usize| {
            let [x, y, _] = view.origin(bodies[side]);
            let radius = (slice.point[0] - x).hypot(slice.point[1] - y);
            (radius.powi(2) - mesh.base_radii[side].powi(2)).sqrt()
        });
        let ideal = Involutes { radii, speeds: speeds.map(f64::abs), internal: mesh.sign < 0.0 };
        let transverse = RollingContact { curvature: contact.curvature / base_helix.cos(), ..contact };
        ideal.check(&transverse, tolerance, &format!("{pair:?} {slice:?}"));
        count += 1;
    }
    count
}

#[test]
fn a_helical_pair_rolls_in_its_transverse_section() {
    let angle: f64 = 0.35;
    let options = Options::helical(angle, Hand::Right);
    let (scene, mesh) = options.scene();
    let system = pairs::system(&scene, StructureOptions::default());
    // The rack is transverse.
    let base_helix = (angle.tan() * 20_f64.to_radians().cos()).atan();
    let speed = std::f64::consts::TAU;
    let speeds = [speed, speed * f64::from(pairs::TEETH[0]) / f64::from(pairs::TEETH[1])];
    for part in [0.1, 0.45, 0.8] {
        let step = system.solve(mesh.start + part * mesh.period).expect("equilibrium");
        let view = Equilibrium::new(&system, &step);
        assert!(check_by_tangents(view, pairs::MESH, speeds, base_helix, 2e-3) > 5);
    }
}

/// Speeds count relative to the carrier, from any frame, with the sun and with the ring.
#[test]
fn planets_roll_relative_to_the_carrier() {
    for seen_from in [0.0, 23.0] {
        let options = SetOptions { seen_from, ..SetOptions::three() };
        let set = Set::of(&options).expect("it goes together");
        let system = set.system();
        let step = system.solve(0.2 * set.mesh(set.sun_meshes[0]).period).expect("equilibrium");
        let view = Equilibrium::new(&system, &step);
        for pair in set.sun_meshes.iter().chain(&set.ring_meshes) {
            let mesh = set.mesh(*pair);
            // One tooth of the first gear passes per period, relative to the line of centres.
            let speeds = mesh.teeth.map(|teeth| std::f64::consts::TAU / (f64::from(teeth) * mesh.period));
            assert!(check_by_tangents(view, *pair, speeds, 0.0, 2e-3) > 0);
        }
    }
}
