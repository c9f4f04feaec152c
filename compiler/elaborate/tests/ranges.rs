//! Tests of models at other values of their params.

use calyx_elaborate::{Cancel, Extent, Ranges, check_ranges, check_text};
use calyx_lang::diagnostic::Severity;

/// Limits of the number of values of one param: if ranges are checked, and by default.
const MOST_VALUES: usize = 32;
const MOST_VALUES_BY_DEFAULT: usize = 8;

/// Limit of the number of models by default.
const MOST_MODELS_BY_DEFAULT: usize = 16;

fn ranges(text: &str) -> Ranges {
    check(text, Extent::Pairs)
}

fn check(text: &str, extent: Extent) -> Ranges {
    check_ranges(&check_text("model.cx", text), extent, &Cancel::default()).expect("not cancelled")
}

#[test]
fn every_value_of_a_range_is_tried() {
    let text = "param count = 3 in 2 .. 5; param shape = \"a\" in [\"a\", \"b\"]; param on = TRUE;
         var all = [1, 2, 3, 4]; print(all[count - 1], shape, on);";
    let found = ranges(text);
    // Pairs: two valid counts with a shape and with a truth value, and these two.
    assert_eq!(found.models, 3 + 1 + 1 + 2 + 2 + 1);
    assert_eq!(found.found.len(), 1, "{found:?}");
    let warning = &found.found[0];
    assert_eq!((warning.code.as_str(), warning.severity), ("W0877", Severity::Warning));
    assert!(warning.message.starts_with("`count` = 5 is allowed, but "), "{}", warning.message);
    assert!(found.cut.is_empty());
    let by_default = check(text, Extent::Cheap);
    assert_eq!((by_default.models, by_default.found.len()), (3 + 1 + 1, 1));
}

#[test]
fn pairs_of_params_are_tried() {
    let text = "param rows = 2 in 1 .. 3; param columns = 2 in 1 .. 3;
         var all = [0, 1, 2, 3, 4, 5]; if (rows * columns > 0) print(all[rows * columns - 1]);";
    let found = ranges(text);
    assert_eq!(found.models, 2 + 2 + 4);
    let [warning] = found.found.as_slice() else { panic!("{found:?}") };
    let message = "`rows` = 3 and `columns` = 3 are allowed, but index 8 of an array of 6 elements";
    assert!(warning.message.starts_with(message), "{}", warning.message);
    assert_eq!(check(text, Extent::Cheap).found, []);
}

#[test]
fn long_ranges_are_sampled_with_both_ends() {
    let text = "param count = 3 in 1 .. 1000; var all = [1]; print(all[0 * count]);";
    assert_eq!(ranges(text).cut, [("count".to_owned(), MOST_VALUES, 1000)]);
    assert_eq!(check(text, Extent::Cheap).models, MOST_VALUES_BY_DEFAULT);
    // The values are at equal distances.
    for (index, values) in [
        ("if (count > 400) 1 else 0", "429, 571, 714, 857 or 1000"),
        ("if (count == 3) 0 else if (count < 400) 1 else 0", "1, 143 or 286"),
    ] {
        let text = format!("param count = 3 in 1 .. 1000; var all = [1]; print(all[{index}]);");
        let found = check(&text, Extent::Cheap).found;
        let [warning] = found.as_slice() else { panic!("{found:?}") };
        assert!(warning.message.starts_with(&format!("`count` = {values} ")), "{}", warning.message);
    }
}

/// Problems with the same cause are one warning, with the numbers of the first value; those with
/// another remedy are another one.
#[test]
fn problems_are_distinguished_by_their_texts() {
    let text = r#"param offset = 0 in -3 .. 3;
         if (abs(offset) > 1) throw Error(
             code = "E0001",
             message = "the axes are {abs(offset)} apart",
             help = if (offset > 0) "bring them closer" else "bring them farther apart");"#;
    let found = check(text, Extent::Cheap).found;
    let messages: Vec<&str> = found.iter().map(|found| found.message.as_str()).collect();
    assert_eq!(
        messages,
        [
            "`offset` = -3 or -2 is allowed, but at -3 the axes are 3 apart",
            "`offset` = 2 or 3 is allowed, but at 2 the axes are 2 apart"
        ]
    );
}

#[test]
fn the_longer_a_model_runs_the_fewer_values_are_tried_by_default() {
    let models = |passes: usize| {
        let text = format!(
            "param size = 3 in 1 .. 9; param on = TRUE; var sum = 0;
             for (i in 0 .. {passes}) sum += i * size; print(sum, on);"
        );
        let found = check(&text, Extent::Cheap);
        (found.models, found.cut)
    };
    let cut = |tried: usize| vec![("size".to_owned(), tried, 9)];
    assert_eq!(models(100), (8, cut(8)));
    assert_eq!(models(100_000), (3, cut(2)));
    assert_eq!(models(200_000), (1, cut(0)));
}

#[test]
fn gears_are_made_at_other_values_by_default() {
    let text = "import gears;
         var rack = gears.rack(module = 2 mm, tip_radius = 0.6 mm);
         var rim = gears.simple_rim(48 mm, 20 mm);
         param teeth = 30 in 30 .. 60;
         param ground = TRUE;
         var blank = gears.external(teeth = teeth, rack = rack, face_width = 20 mm,
             outer_diameter = if (ground) 64 mm else 63 mm, root_diameter = 55 mm,
             tooth_thickness = 3.1 mm, material = gears.material(206 GPa, 0.3), rim = rim);
         print(gears.base_radius(blank) > 0 mm);";
    let found = check(text, Extent::Cheap);
    let messages: Vec<&str> = found.found.iter().map(|found| found.message.as_str()).collect();
    assert!(found.models > 4 && found.models <= MOST_MODELS_BY_DEFAULT, "{}", found.models);
    let fails = |message: &&str| message.starts_with("`teeth` = ") && message.contains(" is allowed, but ");
    assert!(messages.iter().any(fails), "{messages:?}");
    assert_eq!(found.cut, [("teeth".to_owned(), MOST_VALUES_BY_DEFAULT, 31)]);
}

#[test]
fn an_assertion_refuses_values_on_purpose() {
    let found = ranges("param count = 3 in 1 .. 5; assert(count != 4);");
    assert_eq!((found.models, found.found.len()), (4, 0));
}
