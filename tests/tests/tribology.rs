//! Local friction, flash temperature and film thickness against the library modules of ISO/TS
//! 6336-20 and -22, at the same load, radii and velocities.

use calyx_runtime::lubrication::{BaseOil, Lubrication, Oil, RollingContact};
use calyx_tests::printed::printed_numbers;
use std::f64::consts::PI;

const OIL: Oil = Oil { viscosities: [320e-6, 24e-6], density: 890.0, base: BaseOil::Mineral };
const OIL_TEMPERATURE: f64 = 65.0;
const ROUGHNESS: f64 = 0.7e-6;

/// A helical pair with the data of both ratings.
const MODEL: &str = r#"
import iso21771 as geo;
import micropitting;
import scuffing;
var pinion = geo.gear_data(teeth = 21, face_width = 44 mm, normal_module = 4 mm, helix_angle = HELIX, profile_shift = 0.3);
var gear = geo.gear_data(teeth = 65, face_width = 42 mm, normal_module = 4 mm, helix_angle = HELIX, hand = "left", profile_shift = 0.1);
var pair = geo.pair_data(pinion, gear);
var flank = scuffing.ScuffingGear(Ra = 0.7 um);
var oil = scuffing.Lubricant(320 mm^2/s, 24 mm^2/s, temperature = 65);
var torque = 380 N*m, speed = 1480 rpm;
var rating = micropitting.film_thickness(pair, flank, flank, oil, micropitting.MicropittingLoad(torque = torque, speed = speed));
var ends = scuffing.coordinates(pair);
var C = geo.path_position(pair, "C");
var alpha_wt = geo.working_pressure_angle(pair);
var length = geo.line_of_action_length(pair);
function show(in values) { for (value in values) print("{value : .17e}"); }
show([rating.E_r / (1 Pa), rating.theta_M, rating.mu_m, cos(geo.transverse_pressure_angle(pinion)), cos(alpha_wt)]);
show([scuffing.B_M(flank), rating.alpha_thetaM, rating.eta_thetaM]);
var Gammas = [ends[0], (ends[0] + ends[1]) / 2, ends[1], 0, ends[2], (ends[2] + ends[3]) / 2, ends[3]];
var index = 0;
for (Gamma in Gammas) {
    var point = rating.points[index];
    index += 1;
    var rho_1 = C * (1 + Gamma);
    var rho_2 = length - rho_1;
    show([point.rho_n / (1 m), point.p_dyn / (1 Pa), speed * rho_1 / (1 m/s), speed * 21 / 65 * rho_2 / (1 m/s)]);
    show([point.theta_fl, point.h / (1 m)]);
    // Flash temperature of ISO/TS 6336-20 at a unit load of 300 N/mm, and a coefficient of 0.06.
    var angle = scuffing.X_alphabeta(alpha_wt, geo.transverse_pressure_angle(pinion), 20 deg, pinion.helix_angle);
    var v_t = speed * geo.working_diameter(pair, "first") / 2;
    show([0.06 * scuffing.X_M(rating.E_r, scuffing.B_M(flank)) * scuffing.X_G(Gamma, 65 / 21, angle)
        * 300^0.75 * sqrt(v_t / (1 m/s)) / (pair.center_distance / (1 mm))^0.25]);
}
"#;

/// Numbers that the model prints.
fn printed(helix: &str) -> Vec<f64> {
    let text = MODEL.replace("HELIX", helix);
    printed_numbers("points.cx", &text)
}

fn off(found: f64, expected: f64) -> f64 {
    (found / expected - 1.0).abs()
}

#[test]
fn local_values_are_those_of_the_ratings_at_the_same_point() {
    for helix in ["0 deg", "15 deg"] {
        let numbers = printed(helix);
        let (head, points) = numbers.split_at(8);
        let [modulus, bulk, friction, cos_reference, cos_working, thermal, alpha, eta] = head else {
            panic!()
        };
        let lubrication = Lubrication {
            oil: OIL,
            oil_temperature: OIL_TEMPERATURE,
            bulk_temperature: *bulk,
            roughness: ROUGHNESS,
            friction: Some(*friction),
            thermal_contact: [1e3 * thermal; 2],
        };
        assert!(off(OIL.pressure_viscosity(*bulk), *alpha) < 1e-12);
        assert!(off(OIL.dynamic_viscosity(*bulk), *eta) < 1e-12);
        let mut ratios = Vec::new();
        for point in points.chunks_exact(7) {
            let [radius, pressure, first, second, flash, film, scuffing] = point else { panic!() };
            let contact = RollingContact {
                line_load: 2.0 * PI * radius * pressure.powi(2) / modulus,
                curvature: 1.0 / radius,
                modulus: 0.5 * modulus,
                rolling: [*first, *second],
                along: [0.0; 2],
                sliding: (first - second).abs(),
                length: 42e-3,
            };
            assert!(off(contact.hertz_pressure(), *pressure) < 1e-12);
            assert!(off(lubrication.film_thickness(&contact), *film) < 1e-9, "{helix}: {film}");
            // The pitch point is the middle of the seven.
            if contact.sliding < 1e-9 {
                continue;
            }
            // ISO/TS 6336-22 uses the coefficient of a uniform heat flux, 2/sqrt(pi), for Blok's
            // 1.11.
            let uniform = lubrication.flash_temperature(&contact) * 2.0 / PI.sqrt() / 1.11;
            assert!(off(uniform, *flash) < 1e-9, "{helix}: {uniform} {flash}");
            // The angle factor contains the ratio of normal to transverse unit load, as this mean
            // of the pressure angles of the working and the reference circle.
            let tilt = cos_working.powf(2.0 / 3.0) * cos_reference.powf(1.0 / 3.0);
            let loaded = RollingContact { line_load: 3e5 / tilt, ..contact };
            let blok = Lubrication { friction: Some(0.06), ..lubrication }.flash_temperature(&loaded);
            ratios.push(blok / scuffing);
        }
        assert_eq!(ratios.len(), 6);
        // The constants 0.51 and 1.22 of ISO/TS 6336-20 are rounded, equally for all points.
        for ratio in &ratios {
            assert!((ratio - 1.0).abs() < 5e-3, "{helix}: {ratios:?}");
            assert!(off(*ratio, ratios[0]) < 1e-6, "{helix}: {ratios:?}");
        }
    }
}

/// The local coefficient at the pitch point is the mean one of ISO/TS 6336-22 without its helical
/// load factor.
#[test]
fn the_coefficient_of_friction_is_that_of_the_standard() {
    let lubrication = Lubrication {
        oil: OIL,
        oil_temperature: OIL_TEMPERATURE,
        bulk_temperature: 80.0,
        roughness: ROUGHNESS,
        friction: None,
        thermal_contact: [13.8e3; 2],
    };
    let contact = RollingContact {
        line_load: 2.5e5,
        curvature: 100.0,
        modulus: 1.13e11,
        rolling: [3.0; 2],
        along: [0.0; 2],
        sliding: 0.0,
        length: 42e-3,
    };
    let text = "import micropitting;\nimport scuffing;\n\
        var oil = scuffing.Lubricant(320 mm^2/s, 24 mm^2/s, temperature = 65);\n\
        var eta = scuffing.dynamic_viscosity(oil, 65) / (1 Pa*s);\n\
        var rough = micropitting.X_R(0.7 um, 10 mm);\n\
        var mu = micropitting.mu_m(250 N/mm, 6 m/s, 10 mm, eta, rough);\n\
        print(\"{mu : .17e}\");\n";
    let expected = printed_numbers("mu.cx", text)[0];
    assert!(off(lubrication.friction(&contact), expected) < 1e-12, "{expected}");
}
