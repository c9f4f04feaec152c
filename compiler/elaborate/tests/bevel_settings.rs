//! Bevel and hypoid gears with random machine settings, cutters and blanks: every gear is either
//! refused with a code, a place and a remedy, or has finite points and a positive thickness.
//!
//! `CALYX_FUZZ=20` draws 20 times as many gears, `CALYX_FUZZ_SEED` changes the random seed, and
//! `CALYX_FUZZ_ONLY=spiral` selects the gears whose name contains the word.

use crate::library::Random;
use calyx_abi::Purity;
use calyx_elaborate::{Interpreted, ModelLoader};
use calyx_lang::ir::Program;
use calyx_rt::{AssignedValue, Engine, Error, Instance, ParamAssignment};
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Number of gears, times `CALYX_FUZZ`.
const GEARS: u64 = 100;
/// Longest time of a gear on a busy machine: one that takes longer hangs.
const LONGEST: Duration = Duration::from_secs(120);
/// Codes of defects in Calyx, and of a gear that the model below finds to be nonsense.
const DEFECTS: [&str; 5] = ["E0799", "E0703", "E0708", "E0709", "NONSENSE"];

/// Settings of a cutter and a machine, with their units; all exist once a flank.
const SETTINGS: [(&str, &str); 30] = [
    ("point_radius", "mm"),
    ("blade_angle", "deg"),
    ("edge_radius", "mm"),
    ("blade_groups", ""),
    ("offset_angle", "deg"),
    ("blade_phase", "deg"),
    ("root_angle", "deg"),
    ("center_to_back", "mm"),
    ("radial_setting", "mm"),
    ("cradle_angle", "deg"),
    ("tilt_angle", "deg"),
    ("swivel_angle", "deg"),
    ("blank_offset", "mm"),
    ("sliding_base", "mm"),
    ("ratio_of_roll", ""),
    ("modified_roll_2C", ""),
    ("modified_roll_6D", ""),
    ("modified_roll_24E", ""),
    ("modified_roll_120F", ""),
    ("helical_motion_1", "mm"),
    ("helical_motion_2", "mm"),
    ("helical_motion_3", "mm"),
    ("vertical_motion_1", "mm"),
    ("vertical_motion_2", "mm"),
    ("vertical_motion_3", "mm"),
    ("horizontal_setting", "mm"),
    ("vertical_setting", "mm"),
    // The tooth and its rim.
    ("thickness", "mm"),
    ("rim_thickness", "mm"),
    ("teeth", ""),
];
/// Number of settings of a cutter, and of cutter and machine.
const OF_CUTTER: usize = 6;
const OF_FLANK: usize = 27;
/// Data of the blank.
const BLANK: [(&str, &str); 8] = [
    ("outer_cone_distance", "mm"),
    ("face_width", "mm"),
    ("pitch_angle", "deg"),
    ("face_angle", "deg"),
    ("blank_root_angle", "deg"),
    ("pitch_apex", "mm"),
    ("face_apex", "mm"),
    ("root_apex", "mm"),
];

/// Valid gears: name, process, hand, and all values that are not zero. A value without `concave_`
/// or `convex_` is that of both flanks.
const VALID: [(&str, &str, &str, &str); 6] = [
    (
        "spiral pinion",
        "generated",
        "left",
        "teeth=12 thickness=8.128 rim_thickness=4 edge_radius=1.143 root_angle=16.8666
        concave_radial_setting=74.8741708 concave_blank_offset=3.92622786 concave_center_to_back=-1.021857748
        concave_sliding_base=0.296487342 concave_cradle_angle=63.94203 concave_ratio_of_roll=3.242698536
        concave_point_radius=75.3267734 concave_blade_angle=18.04567
        convex_radial_setting=71.1466446 convex_blank_offset=-4.42624464 convex_center_to_back=1.375229914
        convex_sliding_base=-0.399016728 convex_cradle_angle=53.92599 convex_ratio_of_roll=3.105176807
        convex_point_radius=78.0111724 convex_blade_angle=24.33742
        outer_cone_distance=93.7514 face_width=25.4 pitch_angle=18.433 face_angle=22.31667
        blank_root_angle=16.8666",
    ),
    (
        "spiral gear with a spread blade",
        "generated",
        "right",
        "teeth=36 rim_thickness=5 edge_radius=0.0254 root_angle=67.68333 radial_setting=72.64273
        cradle_angle=59.2342023 ratio_of_roll=1.051674445 blade_angle=22
        concave_point_radius=77.0255 convex_point_radius=75.3745
        outer_cone_distance=93.7514 face_width=25.4 pitch_angle=71.5666 face_angle=72.5
        blank_root_angle=67.68333",
    ),
    (
        "hypoid ring",
        "formate",
        "right",
        "teeth=41 rim_thickness=8 edge_radius=1 root_angle=67 center_to_back=-1.25 horizontal_setting=45.1
        vertical_setting=80.9 concave_point_radius=96.45 concave_blade_angle=25 convex_point_radius=94.05
        convex_blade_angle=18 outer_cone_distance=107.90305 face_width=23 pitch_angle=69 face_angle=69.5
        blank_root_angle=67 pitch_apex=4.11276 face_apex=4.92273 root_apex=1.25354",
    ),
    (
        "hypoid pinion",
        "generated",
        "left",
        "teeth=11 thickness=10.4 rim_thickness=4 edge_radius=1 tilt_angle=23 blank_offset=30
        concave_radial_setting=91.09052 concave_swivel_angle=-30.64711 concave_sliding_base=8.89979
        concave_cradle_angle=59.35289 concave_ratio_of_roll=3.709473 concave_modified_roll_2C=0.02
        concave_point_radius=88.19071 concave_blade_angle=18
        convex_radial_setting=94.14665 convex_swivel_angle=-27.53998 convex_sliding_base=7.70016
        convex_cradle_angle=62.46002 convex_ratio_of_roll=3.755222 convex_modified_roll_2C=-0.02
        convex_point_radius=103.53952 convex_blade_angle=25
        outer_cone_distance=100.55613 face_width=22 pitch_angle=20 face_angle=22.5 blank_root_angle=20.9
        pitch_apex=-1.84477 face_apex=-0.0437 root_apex=-13.91617",
    ),
    (
        "face-hobbed ring",
        "formate",
        "right",
        "teeth=41 rim_thickness=8 edge_radius=0.8 root_angle=67 center_to_back=-1.25 horizontal_setting=68.6
        vertical_setting=83.9 blade_groups=13 offset_angle=15.5 concave_point_radius=86.2
        concave_blade_angle=21 convex_point_radius=89.8 convex_blade_angle=20 convex_blade_phase=-13.904
        outer_cone_distance=110.045 face_width=23 pitch_angle=69 face_angle=69.5 blank_root_angle=67
        pitch_apex=4.315 face_apex=5.533 root_apex=0.778",
    ),
    (
        "straight pinion",
        "straight",
        "left",
        "teeth=18 thickness=7 rim_thickness=6 edge_radius=0.8 root_angle=33.69006753 blade_angle=22.5
        ratio_of_roll=1.802775638 outer_cone_distance=81.12493 face_width=14 pitch_angle=33.69006753
        face_angle=36.5147 blank_root_angle=30.16186",
    ),
];

/// Value of a param, with its unit.
#[derive(Clone, Debug, PartialEq)]
struct Value {
    name: String,
    number: f64,
    unit: &'static str,
}

/// Returns all params with the values of a valid gear.
fn values_of(text: &str) -> Vec<Value> {
    let given: BTreeMap<&str, f64> = text
        .split_whitespace()
        .map(|entry| {
            let (name, number) = entry.split_once('=').expect("a name and a number");
            (name, number.parse().expect("a number"))
        })
        .collect();
    let value = |flank: &str, (name, unit): (&str, &'static str)| {
        let own = format!("{flank}{name}");
        let number = given.get(own.as_str()).or(given.get(name)).copied().unwrap_or(0.0);
        Value { name: own, number, unit }
    };
    let flank = |side: &'static str| SETTINGS[..OF_FLANK].iter().map(move |setting| value(side, *setting));
    let others = SETTINGS[OF_FLANK..].iter().chain(&BLANK).map(|setting| value("", *setting));
    flank("concave_").chain(flank("convex_")).chain(others).collect()
}

/// Returns the model: a gear whose data are all params without ranges.
fn model() -> String {
    let mut text = String::from(
        "import bevel;\nimport bevel_gear;\nimport bevel_tooth as teeth_of;\nimport iso21771 as geo;\nunits mm_N_s;\n\
         param process = bevel.Process.generated;\nparam hand = geo.Hand.left;\nparam spread = FALSE;\n",
    );
    // Params with whole defaults take whole numbers only.
    for Value { name, unit, .. } in values_of("") {
        text += &format!("param {name} = 0.5 {unit};\n");
    }
    for side in ["concave", "convex"] {
        let arguments = |settings: &[(&str, &str)]| {
            let named = settings.iter().map(|(name, _)| format!("{name} = {side}_{name}"));
            named.collect::<Vec<_>>().join(", ")
        };
        text += &format!(
            "var {side} = bevel.Settings(bevel.Cutter({}), {});\n",
            arguments(&SETTINGS[..OF_CUTTER]),
            arguments(&SETTINGS[OF_CUTTER..OF_FLANK])
        );
    }
    let blank = BLANK.map(|(name, _)| format!("{} = {name}", name.trim_start_matches("blank_")));
    text + &format!("var blank = bevel.Blank({});\n", blank.join(", ")) + CUT
}

/// The part of the model that cuts the gear and examines it.
const CUT: &str = r#"
var settings = bevel.BevelGear(process, teeth, hand, concave = concave, convex = convex);
var _gear = bevel_gear.gear(settings, blank, thickness = if (spread) none else thickness, rim_thickness = rim_thickness);
var tooth = teeth_of.tooth_sections(settings, blank, thickness = if (spread) none else thickness);
function fail(in what: String) { throw Error(code = "NONSENSE", message = what, help = "none"); }
if (!(tooth.thickness > 0 mm & tooth.thickness < tooth.pitch)) fail("the thickness is {tooth.thickness}");
for (i in 0 .. len(tooth.distances)) {
    if (!(tooth.tip_thicknesses[i] > 0 mm)) fail("the tip is {tooth.tip_thicknesses[i]} thick");
    if (!(tooth.root_widths[i] >= 0 mm)) fail("the root is {tooth.root_widths[i]} wide");
    for (side in 0 .. 2) {
        for (p in tooth.flanks[side][i]) if (!(norm(p) > 0 mm & norm(p) < 100 m)) fail("a flank point is {p}");
        for (p in tooth.fillets[side][i]) if (!(norm(p) > 0 mm & norm(p) < 100 m)) fail("a fillet point is {p}");
    }
}
"#;

fn setting(name: &str, usual: u64) -> u64 {
    std::env::var(name).ok().and_then(|number| number.parse().ok()).unwrap_or(usual)
}

/// Returns a random number between -1 and 1.
fn signed(random: &mut Random) -> f64 {
    random.below(1 << 20) as f64 / f64::from(1 << 19) - 1.0
}

/// Changes a value at random, as data are mistaken.
fn mistake(value: &mut Value, random: &mut Random) {
    let typical = match value.unit {
        "mm" => 1.0,
        "deg" => 5.0,
        _ => 0.05,
    };
    match random.below(10) {
        0 => value.number = 0.0,
        1 => value.number = -value.number,
        2 => value.number *= 10.0,
        3 => value.number /= 10.0,
        // The number in another unit.
        4 => {
            value.unit = match value.unit {
                "mm" => "inch",
                "deg" => "rad",
                other => other,
            }
        }
        // A unit of another dimension.
        5 => value.unit = if value.unit == "deg" { "mm" } else { "kg" },
        6 => {
            const EXTREMES: [f64; 6] = [1e300, -1e300, 5e-324, 1e12, 1e-9, -1e-9];
            value.number = EXTREMES[random.below(EXTREMES.len())];
        }
        _ if value.number == 0.0 => value.number = typical * signed(random),
        _ => value.number *= 1.0 + 0.2 * signed(random),
    }
}

/// Returns the params of a random gear.
fn drawn(valid: &[Value], random: &mut Random) -> Vec<Value> {
    let mut values = valid.to_vec();
    if random.below(3) == 0 {
        // Tolerances of all settings.
        let size = 10f64.powi(-1 - random.below(4) as i32);
        for value in values.iter_mut().filter(|value| value.name != "teeth" && !value.unit.is_empty()) {
            value.number *= 1.0 + size * signed(random);
        }
        return values;
    }
    for _ in 0..1 + random.below(3) {
        let index = random.below(values.len());
        mistake(&mut values[index], random);
        // A mistake in the settings of a machine usually affects both flanks.
        let (name, number, unit) = (values[index].name.clone(), values[index].number, values[index].unit);
        if let Some(name) = name.strip_prefix("concave_")
            && valid[index].number == valid[index + OF_FLANK].number
        {
            values[index + OF_FLANK] = Value { name: format!("convex_{name}"), number, unit };
        }
    }
    values
}

/// Returns whether the unit of a value has the dimension of its param.
fn is_of_its_dimension(value: &Value) -> bool {
    let name = value.name.trim_start_matches("concave_").trim_start_matches("convex_");
    let usual = SETTINGS.iter().chain(&BLANK).find(|(known, _)| *known == name).map(|(_, unit)| *unit);
    let [given, usual] = [Some(value.unit), usual].map(|unit| match unit {
        Some("inch") => Some("mm"),
        Some("rad") => Some("deg"),
        unit => unit,
    });
    given == usual
}

/// Cuts a gear. Returns the code of its refusal, or "valid"; the error describes a defect.
fn cut(
    program: &Arc<Interpreted<'static>>,
    (process, hand, spread): (&str, &str, bool),
    values: &[Value],
) -> Result<String, String> {
    let mut instance = Instance::new(&Engine::default(), program.clone());
    instance.limit_time(Some(LONGEST));
    let text = |name: &str, text: String| ParamAssignment::text(name, text);
    let mut given = vec![
        text("process", process.into()),
        text("hand", hand.into()),
        ParamAssignment::value("spread", AssignedValue::Bool(spread)),
    ];
    given.extend(
        values
            .iter()
            .map(|value| text(&value.name, format!("{:?} {}", value.number, value.unit).trim().into())),
    );
    let solved = given.iter().try_for_each(|given| instance.give(given)).and_then(|()| instance.solve());
    match solved {
        Ok(_) => Ok("valid".into()),
        Err(Error::Given(invalid)) => {
            let named = invalid.message.contains('`') && !invalid.help.is_empty();
            match named && values.iter().any(|value| !is_of_its_dimension(value)) {
                true => Ok("invalid unit".into()),
                false => Err(format!("{invalid:?}")),
            }
        }
        Err(Error::Model(error)) => {
            let complete = error.place.is_some() && !error.help.is_empty();
            match complete && error.code.starts_with('E') && !DEFECTS.contains(&error.code.as_str()) {
                true => Ok(error.code),
                false => Err(format!("{error:?}")),
            }
        }
    }
}

#[test]
fn random_machine_settings_are_refused_or_cut_a_gear() {
    let text = model();
    let checked = calyx_lang::check_program("model.cx", &text, &ModelLoader::default());
    let program = checked.program.unwrap_or_else(|| panic!("{:?}\n{text}", checked.diagnostics));
    // An instance needs a program with static lifetime.
    let program: &'static Program = Box::leak(Box::new(program));
    let program = Arc::new(Interpreted::new(program, Purity::Effect).expect("a program with kernels"));
    let mut random = Random(0xBE7E_15ED ^ setting("CALYX_FUZZ_SEED", 0).wrapping_mul(0xD134_2543_DE82_EF95));
    let only = std::env::var("CALYX_FUZZ_ONLY").unwrap_or_default();
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    let (mut defects, mut longest, since) = (String::new(), Duration::ZERO, Instant::now());
    let mut examine = |name: &str, kind, values: &[Value], valid: &[Value], must_be_valid: bool| {
        let start = Instant::now();
        let outcome = catch_unwind(AssertUnwindSafe(|| cut(&program, kind, values)));
        longest = longest.max(start.elapsed());
        let outcome = match outcome.unwrap_or_else(|_| Err("a panic".into())) {
            Ok(code) if must_be_valid && code != "valid" => Err(format!("it is refused with {code}")),
            outcome => outcome,
        };
        match outcome {
            Ok(code) => *counts.entry(code).or_default() += 1,
            Err(why) => {
                let changed = values.iter().zip(valid).filter(|(value, valid)| value != valid);
                let changed =
                    changed.map(|(value, _)| format!(" {}={:?} {}", value.name, value.number, value.unit));
                defects += &format!("{name}:{}\n    {why}\n", changed.collect::<String>());
            }
        }
    };
    let bases = VALID.map(|(name, process, hand, text)| {
        let valid = values_of(text);
        let spread = valid.iter().any(|value| value.name == "thickness" && value.number == 0.0);
        (name, (process, hand, spread), valid)
    });
    for (name, kind, valid) in bases.iter().filter(|(name, ..)| name.contains(&only)) {
        examine(name, *kind, valid, valid, true);
    }
    for _ in 0..GEARS * setting("CALYX_FUZZ", 1) {
        let (name, kind, valid) = &bases[random.below(bases.len())];
        let values = drawn(valid, &mut random);
        if name.contains(&only) {
            examine(name, *kind, &values, valid, false);
        }
    }
    println!("longest {longest:?} of {:?}: {counts:#?}", since.elapsed());
    assert!(defects.is_empty(), "\n{defects}");
    assert!(counts.len() > 5 && counts["valid"] > VALID.len(), "the gears are too similar: {counts:?}");
}
