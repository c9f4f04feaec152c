//! Tests automatic fixes: the changed text, and cases where no fix may be offered.

use crate::library::Library;
use calyx_lang::check_program;

/// Applies the first automatic fix; returns `None` if there is none.
fn fixed(text: &str, library: &Library) -> Option<String> {
    let checked = check_program("model.cx", text, library);
    let fix = checked.diagnostics.iter().find_map(|diagnostic| diagnostic.fix.as_ref())?;
    let mut fixed = text.to_string();
    fixed.replace_range(fix.span.start as usize..fix.span.end as usize, &fix.replacement);
    Some(fixed)
}

#[test]
fn a_fix_keeps_the_dimension_that_is_meant() {
    let library = Library::read();
    for (text, wanted) in [
        ("print(100 Nm);", "print(100 N*m);"),
        ("print(2.5e-3 kNm + 1 N*m);", "print(2.5e-3 kN*m + 1 N*m);"),
        ("print(100 Nmm, 3);", "print(100 N*mm, 3);"),
        ("print(3 Pas);", "print(3 Pa*s);"),
        ("var torque = 1 N*m; print(torque/100 Nm);", "var torque = 1 N*m; print(torque/(100 N*m));"),
        ("var x = 1 N*m; print(\"{x : .3 Nm}\");", "var x = 1 N*m; print(\"{x : .3 N*m}\");"),
        ("print(3 KN, 1 N);", "print(3 kN, 1 N);"),
        ("print(3 inchs);", "print(3 inches);"),
        ("print(30 rmp);", "print(30 rpm);"),
        ("var x = 2,5 mm; print(x);", "var x = 2.5 mm; print(x);"),
        ("print((2,5 mm)/1 mm);", "print((2.5 mm)/1 mm);"),
        ("var x = 100 1/min; print(x);", "var x = 100/min; print(x);"),
    ] {
        assert_eq!(fixed(text, &library).as_deref(), Some(wanted), "{text}");
    }
}

#[test]
fn what_may_mean_two_things_is_not_changed() {
    let library = Library::read();
    for text in [
        // N*ms or N*m*s; 0.001 Pa or MPa; 1e6 m or mm; force or mass; the exponent would apply only
        // to the metre.
        "print(3 Nms);",
        "print(3 mPa);",
        "print(3 Mm);",
        "print(3 lbs);",
        "print(3 lbfs);",
        "print(3 Nm^2);",
        "print(3/100 1/min);",
        "function f(in width, in height) { return width*height; }\nprint(f(width = 1, widht = 2));",
    ] {
        assert_eq!(fixed(text, &library), None, "{text}");
    }
}
