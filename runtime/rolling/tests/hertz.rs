//! Hertz contact against values of 40 digits (mpmath) and the references.

use crate::sample::close;
use calyx_rolling::hertz::elliptic::Elliptic;
use calyx_rolling::hertz::line;
use calyx_rolling::hertz::point::PointContact;

#[test]
fn elliptic_integrals_and_ellipses_agree_with_40_digits() {
    for row in include_str!("data/hertz.csv").lines().skip(1) {
        let values: Vec<f64> = row.split(',').map(|value| value.parse().expect("a number")).collect();
        let [ratio, axes, first, second, stiffness, unit_x] = values[..] else { panic!("six columns") };
        let integrals = Elliptic::of_complementary_modulus(axes);
        close(integrals.first, first, first, 1e-14, "K");
        close(integrals.second, second, second, 1e-14, "E");
        let contact = PointContact::new(ratio, 1.0, 1.0);
        close(contact.stiffness, stiffness, stiffness, 1e-12, "stiffness");
        close(contact.unit_x, unit_x, unit_x, 1e-12, "long semi-axis");
        close(contact.unit_y, unit_x * axes, unit_x * axes, 1e-12, "short semi-axis");
        let exchanged = PointContact::new(1.0, ratio, 1.0);
        close(exchanged.unit_y, contact.unit_x, contact.unit_x, 0.0, "exchanged semi-axes");
    }
}

#[test]
fn compliance_has_its_derivative() {
    for (a, b) in [(1.0, 1.0), (1.0, 1.001), (1.0, 2.0), (1.0, 30.0), (2.0, 1.0), (50.0, 1.0)] {
        let step = 1e-4 * b;
        let at = |b: f64| PointContact::new(a, b, 1.0).compliance();
        let difference = |step: f64| (at(b + step) - at(b - step)) / (2.0 * step);
        let expected = (4.0 * difference(0.5 * step) - difference(step)) / 3.0;
        let value = PointContact::new(a, b, 1.0).compliance_by_b();
        close(value, expected, expected.abs(), 1e-9, "derivative");
    }
}

#[test]
fn equal_curvatures_give_a_circle() {
    // Johnson (1985), equations 4.22 to 4.24: a³ = 3QR/(4E*), δ = a²/R, with A = B = 1/(2R).
    let (radius, modulus, load) = (5e-3, 113e9, 200.0);
    let contact = PointContact::new(0.5 / radius, 0.5 / radius, modulus);
    let ellipse = contact.ellipse(load);
    let expected = (0.75 * load * radius / modulus).cbrt();
    close(ellipse.x, expected, expected, 1e-14, "semi-axis");
    close(ellipse.y, expected, expected, 1e-14, "semi-axis");
    let approach = (load / contact.stiffness).powf(2.0 / 3.0);
    close(approach, expected * expected / radius, approach, 1e-13, "approach");
    close(contact.load_of_pressure(ellipse.pressure), load, load, 1e-13, "load");
}

#[test]
fn line_contact_has_the_load_of_its_pressure() {
    let (radius, modulus, load) = (4.5e-3, 113e9, 4e5);
    let (half, pressure) = (line::half_width(load, radius, modulus), line::pressure(load, radius, modulus));
    // The pressure is a semi-ellipse over the width.
    let sum = 0.5 * std::f64::consts::PI * half * pressure;
    close(sum, load, load, 1e-14, "load per length");
    close(line::load_of_pressure(pressure, radius, modulus), load, load, 1e-14, "load per length");
    assert_eq!(line::pressure(-1.0, radius, modulus), 0.0);
}
