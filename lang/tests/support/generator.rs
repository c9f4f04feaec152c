//! Generates reproducible models of any length, from repeated typical sections, for benches and for
//! tests of growth.

/// Returns a model of about `lines` lines.
pub fn model(lines: usize) -> String {
    let mut text = String::from(HEAD);
    let mut section = 0;
    while text.lines().count() + SECTION_LINES / 2 < lines.max(HEAD.lines().count()) {
        text += &SECTION.replace("#P", &previous(section)).replace('#', &section.to_string());
        section += 1;
    }
    text
}

/// Returns the model with one number changed in the body of one function, in the first section.
#[allow(dead_code)]
pub fn with_edited_body(text: &str) -> String {
    text.replacen("total = total + step*weight_0(i);", "total = total + step*weight_0(i + 1);", 1)
}

/// Returns a model of a chain of `factors` factors and its first and second time derivatives.
#[allow(dead_code)]
pub fn chain(factors: usize) -> String {
    let mut text = String::from("units mm_N_s;\nparam speed = 3 rad/s;\n");
    for factor in 0..factors {
        let frame = match factor % 3 {
            0 => format!("Rotate({}*speed*Time, e3)", 1 + factor % 5),
            1 => format!("Translate({} mm*e1)", 1 + factor),
            _ => format!("Rotate({} rad + speed*Time, e{})", factor, 1 + factor % 2),
        };
        let before = if factor == 0 { String::new() } else { format!("frame_{} * ", factor - 1) };
        text += &format!("var frame_{factor} := {before}{frame};\n");
    }
    let last = factors.saturating_sub(1);
    text += &format!("var place = origin(frame_{last}) at Time = 0.1 s;\n");
    text += &format!("var pace = velocity(frame_{last}) at Time = 0.1 s;\n");
    text += &format!("var change = acceleration(frame_{last}) at Time = 0.1 s;\n");
    text += "print(place, pace, change);\n";
    text
}

/// Returns a model of `count` components of a hundred lines, each with one instance.
#[allow(dead_code)]
pub fn components(count: usize) -> String {
    let declarations = HEAD.split_once("\nconst").map_or("", |(_, rest)| rest);
    let mut text = format!("import gears;\nunits inch_lbf_s;\nconst{declarations}");
    for component in 0..count {
        text += &format!(
            "component Part_{component}() {{\n\
             param width = 2 inch in 1 inch .. 3 inch;\n\
             param speed = 3 rpm;\n\
             param count = 5 in 1 .. 20;\n"
        );
        for section in 0..2 {
            text += &SECTION.replace("#P", &previous(section)).replace('#', &section.to_string());
        }
        text += "output size := size_1;\n}\n";
    }
    for component in 0..count {
        text += &format!("var part_{component} = Part_{component}();\n");
    }
    text
}

/// Returns the name on which a section builds: a result of the previous section.
fn previous(section: usize) -> String {
    match section {
        0 => "width".into(),
        _ => format!("size_{}", section - 1),
    }
}

const HEAD: &str = "\
/// A model made by the generator.
import gears;
units inch_lbf_s;

/// Width of the first part.
param width = 2 inch in 1 inch .. 3 inch;
/// Speed of the first shaft.
param speed = 3 rpm;
/// How many steps are taken.
param count = 5 in 1 .. 20;

const allowance = 0.002 inch;
record Stage {
    /// Distance between the axes.
    distance: Length = 3 inch;
    ratio: Number = 2;
    label: String = \"stage\";
}
";

const SECTION_LINES: usize = 48;

/// A section; `#` is its number, `#P` the name on which it builds.
const SECTION: &str = "
// Section #.

/// How much step i counts.
function weight_#(in i) {
    if (i == 0) return 1;
    return 1/(i + 1);
}

/// A length summed over steps.
function path_#(in n, in step: Length) {
    var total = 0 inch;
    for (var i = 0; i < n; i = i + 1) {
        total = total + step*weight_#(i);
        if (total > 1000 inch) {
            break;
        }
    }
    return total;
}

/// Works for numbers and vectors of any dimension.
function between_#(in a, in b, in at = 0.5) {
    return a + at*(b - a);
}

function table_#(in n, in stage: Stage) {
    var all = [stage.distance];
    for (var i = 1; i < n; i = i + 1) {
        push(all, between_#(all[i - 1], stage.distance*stage.ratio));
    }
    return all;
}

function moment_#(in force: Force, in arm: Length, inout sum) {
    sum = sum + force*arm;
}

/// A point of a profile.
function profile_#(in u, in th) := u*cos(th)*e1 + u*sin(th)*e2;

var size_# = between_#(#P, path_#(count, width)) + allowance;
var stage_# = Stage(distance = size_#, ratio = 1.5, label = \"stage #\");
var sizes_# = table_#(4, stage_#);
var load_# = 0 lbf*inch;
moment_#(10 lbf, sizes_#[2], load_#);
var frame_# := Rotate(speed*Time/stage_#.ratio, e3)*Translate(size_#*e1);
var point_# = profile_#(size_#, 0.3 rad) + origin(frame_#) at Time = 0.1 s;
var _rack_# = gears.rack(diametral_pitch = 10/inch, pressure_angle = 20 deg, tip_radius = 0.02 inch + allowance);
assert(load_# > 0 lbf*inch, \"section # has a moment\");
print(\"section #: {size_#}, {stage_#.label}, {norm(point_#)}, {len(sizes_#)}\", load_#);
";
