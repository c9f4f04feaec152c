//! Tests of loads and flank deviations that an embedding program defines as functions, and of their
//! error messages.

use crate::common::pair::{FIRST, MESH, Member, PLAIN, PairOptions, Values, pair, solve_at, steel, system};
use crate::common::{INCH, chapter_5, chapter_5_data};
use calyx_gears::assembly::{MeshOptions, add_body, mesh};
use calyx_gears::blank::{GearBlank, Rim, Thickness};
use calyx_gears::deviation::{Deviation, SAMPLES};
use calyx_gears::error::Refusal;
use calyx_gears::external::ExternalGear;
use calyx_gears::fillet::Side;
use calyx_gears::flank::Flank;
use calyx_gears::modification::{Modification, ReliefShape};
use calyx_gears::prototype::GearPrototype;
use calyx_runtime::disc::Disc;
use calyx_runtime::load::Wrench;
use calyx_runtime::material::Material;
use calyx_runtime::motion::SteadyRotation;
use calyx_runtime::profile::Profile;
use calyx_runtime::scene::{Body, Scene};
use calyx_runtime::structure::BoreSupport;
use std::sync::Arc;

/// Depth of the tip relief at the tip, m.
const DEPTH: f64 = 0.0005 * INCH;
/// Roll angle at which the tip relief starts, rad.
const START: f64 = 0.4756;

/// Returns the tip relief of the library.
fn tip_relief() -> Modification {
    Modification::tip_relief(DEPTH, START, ReliefShape::Quadratic)
}

/// Returns the same tip relief as a function of the roll angle.
fn relief_function(gear: &ExternalGear) -> Modification {
    let range = gear.tip_roll - START;
    Deviation::new("quadratic", move |roll| DEPTH * ((roll - START) / range).max(0.0).powi(2)).into()
}

#[test]
fn a_relief_function_gives_the_flank_of_the_same_relief() {
    let gear = chapter_5(20);
    let flank = |modification| Flank::new(&gear, &[modification], Side::CounterClockwise).expect("a flank");
    let [known, given] = [tip_relief(), relief_function(&gear)].map(flank);
    assert!((known.length() / given.length() - 1.0).abs() < 1e-9);
    // The second derivative of the relief has a jump J at the start. Interpolation with step h
    // then has an error of about J h² / 30.
    let range = gear.tip_roll - START;
    let jump = 2.0 * DEPTH / (range * range);
    let step = (gear.tip_roll - gear.form_roll) / SAMPLES as f64;
    let (mut position_error, mut tangent_error) = (0.0_f64, 0.0_f64);
    for i in 0..=5000 {
        let roll = gear.form_roll + (known.edge_roll() - gear.form_roll) * f64::from(i) / 5000.0;
        let [known, given] = [&known, &given].map(|flank| flank.at(flank.s_at_roll(roll)));
        for axis in 0..2 {
            position_error = position_error.max((known.position[axis] - given.position[axis]).abs());
            tangent_error = tangent_error.max((known.tangent[axis] - given.tangent[axis]).abs());
        }
    }
    assert!(
        position_error < jump * step * step / 25.0 && position_error > jump * step * step / 60.0,
        "{position_error:e} {}",
        jump * step * step
    );
    assert!(tangent_error < 5e-5, "{tangent_error:e}");
}

/// Returns a pinion with this modification and an unmodified wheel.
fn modified_pair(modification: Modification) -> [Member; 2] {
    let rim = Rim { radius: 0.7 * INCH, fixed_radius: 0.6 * INCH, web: None, support: BoreSupport::Rigid };
    let gear = GearPrototype::new(chapter_5(20), vec![modification], steel(), rim, INCH, Vec::new());
    [Member::new(gear.expect("a gear")), PLAIN[1].clone()]
}

#[test]
fn a_relief_function_gives_the_results_of_the_same_relief() {
    let solved =
        |modification| solve_at(&PairOptions::chapter_5(&modified_pair(modification)), &[0.1, 0.45, 0.8]);
    let (known, given) = (solved(tip_relief()), solved(relief_function(&chapter_5(20))));
    for (known, given) in known.iter().zip(&given) {
        assert!(known.difference(given) < 2e-5, "{known:?}\n{given:?}");
    }
    let plain = solve_at(&PairOptions::chapter_5(&PLAIN), &[0.1, 0.45, 0.8]);
    let differences = plain.iter().zip(&known).map(|(plain, known)| plain.difference(known));
    assert!(differences.fold(0.0, f64::max) > 1e-2, "the relief must change the results");
}

#[test]
fn a_load_function_is_evaluated_at_the_time_of_each_position() {
    let options = PairOptions::chapter_5(&PLAIN);
    let (mut scene, cycle) = pair(&options);
    let times = [0.2, 0.7].map(|part| cycle.start + part * cycle.period);
    let moment = move |time: f64| options.moment * (1.0 + 0.5 * (time - times[0]) / (times[1] - times[0]));
    scene.bodies[FIRST.0] =
        scene.bodies[FIRST.0].clone().loaded(move |time: f64| Wrench::of_moment([0.0, 0.0, moment(time)]));
    let changing = {
        let system = system(&scene);
        times.map(|time| {
            let step = system.solve(time).expect("equilibrium");
            Values::of(&system, &step)
        })
    };
    for ((part, time), changing) in [0.2, 0.7].into_iter().zip(times).zip(changing) {
        let constant = PairOptions { moment: moment(time), ..PairOptions::chapter_5(&PLAIN) };
        assert_eq!(solve_at(&constant, &[part]), [changing]);
    }
}

#[test]
fn a_nan_load_is_rejected_at_its_position() {
    let (mut scene, cycle) = pair(&PairOptions::chapter_5(&PLAIN));
    let start = cycle.start;
    let undefined = move |time: f64| Wrench::of_moment([0.0, 0.0, if time > start { f64::NAN } else { 1.0 }]);
    scene.bodies[FIRST.0] = scene.bodies[FIRST.0].clone().loaded(undefined);
    let system = system(&scene);
    assert!(system.solve(start).is_ok());
    let error = system.solve(start + 1e-3).expect_err("a NaN load");
    assert_eq!(error.code, "E0723");
    assert!(error.message.contains("\"first\""), "{}", error.message);
}

/// Returns code and message of an error.
fn rejection<T>(result: Result<T, Refusal>) -> (&'static str, String) {
    match result {
        Ok(_) => panic!("it was accepted"),
        Err(refusal) => match &refusal {
            Refusal::Geometry(findings) => (findings[0].code, refusal.to_string()),
            Refusal::Engine(error) => (error.code, refusal.to_string()),
        },
    }
}

fn blank() -> GearBlank {
    let data = chapter_5_data(20, 0.02, 0.15708);
    GearBlank::standard(20, data.rack)
        .diameters(2.0 * data.outer_radius, 2.0 * data.root_radius)
        .thickness(Thickness::Circular(data.tooth_thickness))
        .rim(Rim { radius: 0.7 * INCH, fixed_radius: 0.6 * INCH, web: None, support: BoreSupport::Rigid })
}

#[test]
fn impossible_deviations_are_rejected() {
    for (amount, reason) in [
        (Arc::new(|roll: f64| (roll - 0.3).sqrt()) as Arc<dyn Fn(f64) -> f64 + Send + Sync>, "not a finite"),
        (Arc::new(|roll: f64| if roll > 0.5 { 2e-3 } else { 0.0 }), "half the tooth"),
        (Arc::new(|roll: f64| if roll > 0.5 { -2e-3 } else { 0.0 }), "half the tooth"),
        (Arc::new(|_| 0.9e-3), "radius of curvature"),
    ] {
        let deviation = Deviation::new("measured", move |roll| amount(roll));
        let (code, message) = rejection(blank().modified(deviation.into()).cut());
        assert_eq!(code, "E0642");
        assert!(message.contains(reason), "{message}");
    }
    // A zero function is no modification, and a negative amount adds material.
    let none = Deviation::new("none", |_| 0.0);
    assert!(blank().modified(none.into()).cut().is_ok());
    assert!(blank().modified(Deviation::new("added", |_| -1e-5).into()).cut().is_ok());
}

#[test]
fn a_mesh_requires_two_gears_without_a_mesh() {
    let mut scene = Scene::default();
    let rotating = |x: f64, speed: f64| SteadyRotation { origin: [x, 0.0], start: 0.0, speed };
    let gear = blank().cut().expect("a gear");
    let first = add_body(&mut scene, Body::new("gear", gear.clone(), rotating(0.0, 1.0))).expect("a body");
    let disc = Arc::new(Disc::new(INCH, INCH, Material::STEEL));
    let second = add_body(&mut scene, Body::new("disc", disc, rotating(2.0 * INCH, -1.0))).expect("a body");
    assert_eq!(rejection(mesh(&mut scene, first, second, &MeshOptions::default())).0, "E0653");
    let again = Body::new("gear", gear.clone(), rotating(2.005 * INCH, -1.0));
    assert_eq!(rejection(add_body(&mut scene, again.clone())).0, "E0671");
    let third = add_body(&mut scene, Body { name: "mate".into(), ..again }).expect("a body");
    let meshed = mesh(&mut scene, first, third, &MeshOptions::default()).expect("a mesh");
    assert_eq!(meshed.pair, MESH);
    assert_eq!(rejection(mesh(&mut scene, third, first, &MeshOptions::default())).0, "E0652");
}
