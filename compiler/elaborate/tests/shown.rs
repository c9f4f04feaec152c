//! Tests of the display of quantities.

use calyx_elaborate::shown::{dimension, rounded, value};
use calyx_elaborate::{Kind, Quantity};

#[test]
fn numbers_have_six_digits_and_no_idle_zeros() {
    for (value, text) in [
        (0.0, "0"),
        (20.0, "20"),
        (46.984_631_04, "46.9846"),
        (-0.018_5, "-0.0185"),
        (1.492_529_98, "1.49253"),
        (9.999_999_9, "10"),
        (0.000_012_345_678, "1.23457e-5"),
        (2.06e11, "2.06e11"),
        (123_456.7, "123457"),
        (f64::INFINITY, "inf"),
    ] {
        assert_eq!(rounded(value), text);
    }
}

#[test]
fn lengths_are_in_the_unit_of_messages_about_gears() {
    let quantity = |kind, value| Quantity { kind, value, ..Quantity::default() };
    assert_eq!(value(&quantity(Kind::Length, 0.0254), "inch_lbf_s"), "1 inch");
    assert_eq!(value(&quantity(Kind::Length, 0.0254), "SI"), "25.4 mm");
    assert_eq!(value(&quantity(Kind::Curvature, 1.0 / 0.0025), "mm_N_s"), "0.4 / mm");
    assert_eq!(value(&quantity(Kind::Angle, 20.0_f64.to_radians()), "SI"), "20 deg");
    assert_eq!(dimension(Kind::Curvature).known_name(), Some("Curvature"));
}
