//! Tests of the lubrication of a point of contact against the formulas and their limits.

use calyx_model::lubrication::{BaseOil, Lubrication, Oil, RollingContact};
use std::f64::consts::PI;

const OIL: Oil = Oil { viscosities: [220e-6, 19e-6], density: 890.0, base: BaseOil::Mineral };
const STEEL: f64 = 13800.0;
const LUBRICATION: Lubrication = Lubrication {
    oil: OIL,
    oil_temperature: 70.0,
    bulk_temperature: 90.0,
    roughness: 0.6e-6,
    friction: Some(0.05),
    thermal_contact: [STEEL; 2],
};
const CONTACT: RollingContact = RollingContact {
    line_load: 4e5,
    curvature: 90.0,
    modulus: 1.132e11,
    rolling: [3.0, 5.0],
    along: [0.0; 2],
    sliding: 2.0,
    length: 0.03,
};

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * a.abs().max(b.abs())
}

#[test]
fn viscosities_are_those_given() {
    for (celsius, expected) in [(40.0, 220e-6), (100.0, 19e-6)] {
        assert!((OIL.kinematic_viscosity(celsius) / expected - 1.0).abs() < 1e-12);
    }
    // 890 kg/m³ at 16 degrees (289 K).
    assert!(close(OIL.dynamic_viscosity(16.0), 890.0 * OIL.kinematic_viscosity(16.0)));
}

#[test]
fn the_width_and_the_pressure_are_hertzian() {
    let (half, pressure) = (CONTACT.half_width(), CONTACT.hertz_pressure());
    assert!(close(0.5 * PI * pressure * half, CONTACT.line_load));
    assert!(close(pressure / half, 0.5 * CONTACT.modulus * CONTACT.curvature));
}

/// Mean heat flux of a band, 1.11 q sqrt(2 b / v)/B, halved between two equal surfaces of equal
/// velocity.
#[test]
fn the_flash_temperature_is_that_of_a_band_source() {
    let contact = RollingContact { rolling: [4.0; 2], ..CONTACT };
    let width = 2.0 * contact.half_width();
    let flux = 0.05 * contact.line_load * contact.sliding / width;
    let band = 1.11 * 0.5 * flux * (width / 4.0).sqrt() / STEEL;
    assert!(close(LUBRICATION.flash_temperature(&contact), band));
    assert!(close(LUBRICATION.contact_temperature(&contact), 90.0 + band));
}

#[test]
fn the_roles_of_the_surfaces_are_symmetric() {
    let other = RollingContact { rolling: [5.0, 3.0], ..CONTACT };
    assert_eq!(LUBRICATION.flash_temperature(&other), LUBRICATION.flash_temperature(&CONTACT));
    assert_eq!(LUBRICATION.film_thickness(&other), LUBRICATION.film_thickness(&CONTACT));
    let reverse = RollingContact { rolling: [-3.0, -5.0], ..CONTACT };
    assert_eq!(LUBRICATION.film_thickness(&reverse), LUBRICATION.film_thickness(&CONTACT));
}

/// Surfaces that slide along the contact line without rolling are heated over its length: the
/// flash temperature is that of a band of this width with the same heat flux.
#[test]
fn surfaces_that_only_slide_along_the_line_have_a_finite_temperature() {
    let contact = RollingContact { rolling: [0.0; 2], along: [1.0, -1.0], ..CONTACT };
    let flux = 0.05 * contact.line_load * contact.sliding / (2.0 * contact.half_width());
    let band = 1.11 * 0.5 * flux * contact.length.sqrt() / STEEL;
    assert!(close(LUBRICATION.flash_temperature(&contact), band));
    // One surface stands still: the other one takes all heat.
    let single = RollingContact { along: [2.0, 0.0], ..contact };
    assert!(close(LUBRICATION.flash_temperature(&single), band * 2f64.sqrt()));
    // The velocity along the line is without effect while the surfaces roll.
    let rolling = RollingContact { along: [1.0, -1.0], ..CONTACT };
    assert_eq!(LUBRICATION.flash_temperature(&rolling), LUBRICATION.flash_temperature(&CONTACT));
    // The temperature is continuous: slow rolling does not change it.
    let slow = RollingContact { rolling: [1e-9, 1e-9], ..contact };
    assert_eq!(LUBRICATION.flash_temperature(&slow), LUBRICATION.flash_temperature(&contact));
    assert_eq!(LUBRICATION.film_thickness(&contact), 0.0);
}

#[test]
fn nothing_moves_and_all_is_zero() {
    let still = RollingContact { rolling: [0.0; 2], sliding: 0.0, ..CONTACT };
    for friction in [None, Some(0.05)] {
        let lubrication = Lubrication { friction, ..LUBRICATION };
        let found = [
            lubrication.friction_power(&still),
            lubrication.flash_temperature(&still),
            lubrication.film_thickness(&still),
        ];
        assert_eq!(found, [0.0; 3]);
    }
    // Pure rolling has a film and no heat.
    let rolling = RollingContact { rolling: [3.0; 2], sliding: 0.0, ..CONTACT };
    assert_eq!(LUBRICATION.flash_temperature(&rolling), 0.0);
    assert!(LUBRICATION.film_thickness(&rolling) > 0.0);
}

/// Exponents of the formulas: those of friction, and of the isothermal film.
#[test]
fn load_and_speed_scale_as_published() {
    let local = Lubrication { friction: None, ..LUBRICATION };
    let rolling = RollingContact { rolling: [4.0; 2], sliding: 0.0, ..CONTACT };
    let loaded = RollingContact { line_load: 8e5, ..rolling };
    let fast = RollingContact { rolling: [8.0; 2], ..rolling };
    assert!(close(local.friction(&loaded) / local.friction(&rolling), 2f64.powf(0.2)));
    assert!(close(local.friction(&fast) / local.friction(&rolling), 2f64.powf(-0.2)));
    assert!(close(local.film_thickness(&loaded) / local.film_thickness(&rolling), 2f64.powf(-0.13)));
    assert!(close(local.film_thickness(&fast) / local.film_thickness(&rolling), 2f64.powf(0.7)));
    let rough = Lubrication { roughness: 1.2e-6, ..local };
    assert!(close(rough.friction(&rolling) / local.friction(&rolling), 2f64.powf(0.25)));
    assert!(close(rough.specific_film_thickness(&rolling), rough.film_thickness(&rolling) / 1.2e-6));
}
