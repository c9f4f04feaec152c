//! The declared functions of the library, and models that call one of them.

use calyx_gears::library::{LibraryModule, MODULES, PRELUDE};
use calyx_lang::ast::{Domain, FunctionDecl, Mode, Parameter, StmtKind, TypeExpr, TypeKind};
use calyx_lang::dimension::Dimension;
use calyx_lang::parser::parse;
use calyx_lang::span::{FileId, Span};

/// Marks the line of the call.
pub const MARK: &str = "/* the call */";

/// A function and its parameters.
#[derive(Clone)]
pub struct Function {
    pub name: String,
    /// The former name, if any.
    pub former: Option<String>,
    /// The path by which a program calls it.
    path: String,
    pub parameters: Vec<Argument>,
    /// `true` if the result has a value only at solved positions.
    is_observable: bool,
}

/// A parameter.
#[derive(Clone)]
pub struct Argument {
    pub name: String,
    /// The former name, if any.
    pub former: Option<String>,
    pub default: Option<String>,
    pub low: Option<String>,
    pub high: Option<String>,
    choices: Vec<String>,
    ty: String,
    /// `true` for numbers, vectors and arrays of them that are not nested.
    pub is_number: bool,
    /// A value that is valid in [`model`].
    pub sample: Option<String>,
}

/// Parameters that accept any dimension and therefore have no range.
const ANY_DIMENSION: [(&str, &str); 4] =
    [("interpolate", "xs"), ("interpolate", "ys"), ("interpolate", "x"), ("column", "unit")];

/// Functions that read tables from files.
const OF_FILES: [&str; 2] = ["read_table", "column"];

/// Modules of formulas in Calyx, as standards print them. They neither change the scene nor request
/// memory in proportion to a number without a limit, so that their numbers need no ranges.
const OF_FORMULAS: [&str; 23] = [
    "iso1328",
    "deviations",
    "inspection",
    "iso6336",
    "iso6336_1",
    "iso6336_2",
    "iso6336_3",
    "iso6336_5",
    "iso6336_6",
    "scuffing",
    "micropitting",
    "agma908",
    "agma2101",
    "envelope",
    "bevel",
    "bevel_checks",
    "bevel_contact",
    "bevel_curve",
    "bevel_form",
    "bevel_gear",
    "bevel_pattern",
    "bevel_section",
    "bevel_tooth",
];

/// Returns every function that programs may call, except those of [`OF_FORMULAS`].
pub fn functions() -> Vec<Function> {
    let mut all = Vec::new();
    for module in [&PRELUDE].into_iter().chain(MODULES) {
        let (tree, problems) = parse(FileId(0), module.text);
        assert!(problems.is_empty(), "{problems:?}");
        if OF_FORMULAS.contains(&module.path) {
            continue;
        }
        for statement in tree.statements.iter().filter(|statement| !statement.private) {
            let StmtKind::Function(decl) = &statement.kind else { continue };
            let name = decl.name.name.to_string();
            if OF_FILES.contains(&name.as_str()) {
                continue;
            }
            let path = match module.path {
                "std" => name.clone(),
                path => format!("{path}.{name}"),
            };
            all.push(function(decl, name, path, module));
        }
    }
    assert!(all.len() > 80, "only {} functions", all.len());
    all
}

fn function(decl: &FunctionDecl, name: String, path: String, module: &LibraryModule) -> Function {
    let parameters = decl.parameters.iter().filter(|parameter| parameter.mode == Mode::In);
    let parameters = parameters.map(|parameter| argument(&name, parameter, module)).collect();
    let result = decl.result.as_ref().map_or("", |ty| slice(module.text, ty.span));
    let former = decl.former.as_ref().map(|former| former.name.to_string());
    Function { is_observable: result.starts_with("Observable"), path, parameters, name, former }
}

fn slice(text: &str, span: Span) -> &str {
    text.get(span.start as usize..span.end as usize).unwrap_or_default()
}

/// Returns a default of a module as a model writes it: records and choices have the module's name.
fn qualified(value: &str, module: &LibraryModule) -> String {
    let word = value.split(|c: char| !c.is_alphanumeric()).next().unwrap_or_default();
    let is_type = word.starts_with(char::is_uppercase) && word.len() < value.len();
    if is_type { format!("{}.{value}", module.path) } else { value.to_owned() }
}

fn argument(function: &str, parameter: &Parameter, module: &LibraryModule) -> Argument {
    let text = module.text;
    let name = parameter.name.name.to_string();
    let former = parameter.former.as_ref().map(|former| former.name.to_string());
    let default = parameter.default.as_ref().and_then(|(_, value)| value.as_ref());
    let default = default.map(|value| slice(text, value.span).replace("ground()", "gears.ground()"));
    let default = default.map(|value| qualified(&value, module));
    let (mut low, mut high, mut choices) = (None, None, Vec::new());
    match &parameter.domain {
        Some(Domain::Range { low: first, high: last, .. }) => {
            let end = |end: &Option<_>| {
                end.as_ref().map(|e: &calyx_lang::ast::Expr| slice(text, e.span).to_owned())
            };
            (low, high) = (end(first), end(last));
        }
        Some(Domain::Choices { values, .. }) => {
            choices = values.iter().map(|value| slice(text, value.span).to_owned()).collect();
        }
        None => {}
    }
    let generic = ANY_DIMENSION.contains(&(function, name.as_str()));
    let is_number = !generic
        && match &parameter.annotation {
            Some(ty) => is_number(ty),
            None => true,
        };
    let ty = parameter.annotation.as_ref().map_or("", |ty| slice(text, ty.span)).to_owned();
    let known = SAMPLES.iter().find(|(of, sampled, _)| *of == function && *sampled == name);
    let sample = match known {
        Some((_, _, value)) => Some((*value).to_owned()),
        None => default
            .clone()
            .or_else(|| choices.first().cloned())
            .or_else(|| sample_of(&ty))
            .or_else(|| sample_of_gear_data(&name)),
    };
    Argument { sample, name, former, default, low, high, choices, ty, is_number }
}

fn is_number(ty: &TypeExpr) -> bool {
    match &ty.kind {
        TypeKind::Name(name) => name.name == "Number" || Dimension::from_name(&name.name).is_some(),
        TypeKind::Apply(name, parts) => {
            // Elements of nested arrays have no declared range; the function checks them.
            let nested = |part: &TypeExpr| matches!(&part.kind, TypeKind::Apply(of, _) if of.name == "Array");
            name.name == "Vector"
                || name.name == "Array" && parts.iter().all(|part| is_number(part) && !nested(part))
        }
        TypeKind::Product(..) | TypeKind::Quotient(..) | TypeKind::Power(..) => true,
        TypeKind::Member(..) | TypeKind::Function(..) | TypeKind::Error => false,
    }
}

/// Returns a value of a type in [`SCENE`].
fn sample_of(ty: &str) -> Option<String> {
    let known = match ty {
        "Rack" => "rack",
        "Shaper" => "shaper",
        "Material" => "steel",
        "Modification" => "gears.profile_slope(deviation = 5 um)",
        "Rim" => "rim",
        "Gear" | "gears.Gear" => "pinion_gear",
        "Body" => "pinion",
        "Mesh" | "gears.Mesh" => "mesh",
        "Gauge" => "gauge",
        "Lubrication" => "lubrication",
        "Bearing" => "bearing",
        "Positions" => "gears.mesh_cycle(mesh, 2)",
        "Modes" => "modes",
        "LumpedMember" => "member",
        "Array(TimeRange)" => "[gears.time_range(1 ms, step = 0.1 ms)]",
        "Symbolic(Transform)" => "Translate(1 mm * e1)",
        "BasicRack" => "iso21771.BasicRack()",
        "GearData" => "gear_data",
        "PairData" => "pair_data",
        "PinionCutter" => "iso21771.PinionCutter(20, 68 mm)",
        "Limit" => "\"upper\"",
        "Extreme" => "\"maximum\"",
        "Member" => "\"second\"",
        "PathPoint" => "\"B\"",
        "String" => "\"x\"",
        _ => return None,
    };
    Some(known.into())
}

/// Returns a value of a parameter of `iso21771`, which has the same meaning in every function.
fn sample_of_gear_data(parameter: &str) -> Option<String> {
    let known = match parameter {
        "angle" => "20 deg",
        "value" => "0.01 rad",
        "diameter" => "74 mm",
        "radius" => "10 mm",
        "thickness" => "5 mm",
        "ball" | "pin" => "5.5 mm",
        "center_distance" => "72 mm",
        "face_width" => "30 mm",
        "measured" => "80 mm",
        "teeth" => "24",
        _ => return None,
    };
    Some(known.into())
}

/// Values that do not follow from types, as (function, parameter, value).
const SAMPLES: &[(&str, &str, &str)] = &[
    ("analyze", "method", "\"quasi_static\""),
    ("analyze", "fidelity", "\"analytic\""),
    ("analyze", "error_estimates", "\"none\""),
    ("interpolate", "xs", "[0 mm, 1 mm, 3 mm]"),
    ("interpolate", "ys", "[0, 1, 4]"),
    ("interpolate", "x", "2 mm"),
    ("material", "youngs_modulus", "206 GPa"),
    ("material", "poissons_ratio", "0.3"),
    ("external", "rack", "rack"),
    ("internal", "shaper", "shaper"),
    ("rack", "module", "2 mm"),
    ("rack", "tip_radius", "0.5 mm"),
    ("with_protuberance", "protuberance", "0.1 mm"),
    ("shaper", "teeth", "20"),
    ("shaper", "module", "2 mm"),
    ("shaper", "tip_radius", "0.2 mm"),
    ("simple_rim", "diameter", "30 mm"),
    ("simple_rim", "inner_diameter", "20 mm"),
    ("pair", "torque", "10 N*m"),
    ("outer_rim", "diameter", "130 mm"),
    ("outer_rim", "outer_diameter", "150 mm"),
    ("webbed_rim", "diameter", "30 mm"),
    ("webbed_rim", "inner_diameter", "26 mm"),
    ("webbed_rim", "bore_diameter", "10 mm"),
    ("webbed_rim", "web_thickness", "4 mm"),
    ("disc_web", "diameter", "30 mm"),
    ("disc_web", "inner_diameter", "26 mm"),
    ("disc_web", "bore_diameter", "10 mm"),
    ("disc_web", "web_thickness", "4 mm"),
    ("splined", "teeth", "8"),
    ("tip_relief", "depth", "10 um"),
    ("tip_relief", "start_roll_angle", "0.5 rad"),
    ("root_relief", "depth", "10 um"),
    ("root_relief", "start_roll_angle", "0.2 rad"),
    ("profile_crown", "depth", "5 um"),
    ("lead_crown", "depth", "5 um"),
    ("end_relief", "depth", "5 um"),
    ("end_relief", "length", "2 mm"),
    ("twist", "amount", "5 um"),
    ("modification_amount", "roll_angle", "0.4 rad"),
    ("profile_table", "roll_angles", "[0.1 rad, 0.3 rad, 0.6 rad]"),
    ("profile_table", "depths", "[0 um, 1 um, 5 um]"),
    ("lead_table", "axial_positions", "[-5 mm, 0 mm, 5 mm]"),
    ("lead_table", "depths", "[3 um, 0 um, 3 um]"),
    ("topography", "roll_angles", "[0.1 rad, 0.3 rad, 0.6 rad]"),
    ("topography", "axial_positions", "[-5 mm, 5 mm]"),
    ("topography", "depths", "[0 um, 1 um, 2 um, 3 um, 4 um, 5 um]"),
    ("topography_of_points", "roll_angles", "[0.1 rad, 0.6 rad, 0.1 rad, 0.6 rad]"),
    ("topography_of_points", "axial_positions", "[-5 mm, -5 mm, 5 mm, 5 mm]"),
    ("topography_of_points", "depths", "[0 um, 1 um, 2 um, 3 um]"),
    ("profile_slope", "deviation", "5 um"),
    ("helix_slope", "deviation", "5 um"),
    ("external", "teeth", "20"),
    ("external", "face_width", "10 mm"),
    ("external", "outer_diameter", "44 mm"),
    ("external", "root_diameter", "35 mm"),
    ("internal", "teeth", "60"),
    ("internal", "face_width", "10 mm"),
    ("internal", "minor_diameter", "116.4 mm"),
    ("internal", "root_diameter", "125 mm"),
    ("internal", "rim", "outer_rim"),
    ("tabulated_gear", "teeth", "20"),
    ("tabulated_gear", "flanks", "[flank(1), flank(-1)]"),
    ("tabulated_gear", "fillets", "[fillet(1), fillet(-1)]"),
    ("body", "name", "\"another\""),
    ("rigid_body", "name", "\"another\""),
    ("bearing", "name", "\"another\""),
    ("bearing", "body", "housing"),
    ("bearing", "radial_stiffness", "1e8 N/m"),
    ("mesh", "first", "sun_like"),
    ("mesh", "second", "planet_like"),
    ("mesh_cycle", "steps", "3"),
    ("times", "to", "1 ms"),
    ("times", "count", "3"),
    ("time_range", "duration", "1 ms"),
    ("time_range", "step", "0.1 ms"),
    ("impulse", "at", "1 ms"),
    ("impulse", "duration", "1 ms"),
    ("spectrum", "output", "\"error\""),
    ("spectrogram", "output", "\"error\""),
    ("spectrogram", "segment", "1 ms"),
    ("order_map", "output", "\"error\""),
    ("order_map", "shaft", "pinion"),
    ("transfer_function", "output", "\"error\""),
    ("transfer_function", "from", "0 s"),
    ("transfer_function", "momentum", "1"),
    ("torque_from_power", "power", "1 kW"),
    ("torque_from_power", "speed", "1000 rpm"),
    ("pair", "first_name", "\"a\""),
    ("pair", "second_name", "\"b\""),
    ("planetary", "sun", "pinion_gear"),
    ("planetary", "planet", "pinion_gear"),
    ("planetary", "ring", "ring_gear"),
    ("planetary", "center_distance", "40 mm"),
    ("planetary", "sun_speed", "1000 rpm"),
    ("planetary", "sun_torque", "10 N*m"),
    ("planetary", "planets", "4"),
    ("natural_frequency", "mode", "1"),
    ("modal_energy_share", "mode", "1"),
    ("mode_type", "mode", "1"),
    ("mode_type", "planets", "[wheel]"),
    ("lumped_natural_frequency", "mode", "1"),
    ("lumped_natural_frequency", "planets", "[wheel]"),
    ("lumped_natural_frequency", "sun_meshes", "[mesh]"),
    ("lumped_natural_frequency", "ring_meshes", "[mesh]"),
    ("tooth_load", "tooth", "0"),
    ("lubrication", "oil", "\"ISO VG 220\""),
    ("lubrication", "temperature", "70"),
    ("lubrication", "roughness", "0.6 um"),
    ("friction_loss", "coefficient", "0.05"),
    ("efficiency", "coefficient", "0.05"),
    ("spline_tooth_force", "tooth", "0"),
    ("lumped_member", "mass", "1 kg"),
    ("lumped_member", "inertia", "1e-3 kg*m^2"),
    ("lumped_member", "radius", "20 mm"),
    ("lumped_planetary", "planet", "planet_member"),
    ("lumped_planetary", "planet_bearing_stiffness", "1e8 N/m"),
    ("lumped_planetary", "sun_mesh_stiffness", "1e8 N/m"),
    ("lumped_planetary", "ring_mesh_stiffness", "1e8 N/m"),
    ("lumped_planetary", "sun_pressure_angle", "20 deg"),
    ("lumped_planetary", "ring_pressure_angle", "20 deg"),
    ("mode_energy", "mode", "0"),
    ("gear_data", "normal_module", "3 mm"),
];

/// Functions that need a planetary set, a splined rim or a dynamic analysis; [`SCENE`] has none of
/// them.
pub const NOT_IN_SCENE: [&str; 7] = [
    "mode_type",
    "lumped_natural_frequency",
    "spline_tooth_force",
    "impulse",
    "spectrogram",
    "order_map",
    "transfer_function",
];

/// A pair of spur gears on their frames, and one object of every other kind.
const SCENE: &str = r#"
import gears;
function same(in x) { return x; }
var rack = gears.rack(module = 2 mm, tip_radius = 0.5 mm);
var shaper = gears.shaper(teeth = 20, module = 2 mm, tip_radius = 0.2 mm);
var steel = gears.material(youngs_modulus = 206 GPa, poissons_ratio = 0.3);
var rim = gears.simple_rim(diameter = 30 mm, inner_diameter = 20 mm);
var outer_rim = gears.outer_rim(diameter = 130 mm, outer_diameter = 150 mm);
var pinion_gear = gears.external(teeth = 20, rack = rack, face_width = 10 mm, outer_diameter = 44 mm,
    root_diameter = 35 mm, material = steel, rim = rim, tooth_thickness = 3.1 mm);
var ring_gear = gears.internal(teeth = 60, shaper = shaper, face_width = 10 mm, minor_diameter = 116.4 mm,
    root_diameter = 125 mm, material = steel, rim = outer_rim, tooth_thickness = 3.1 mm);
function at(in radius: Length, in angle: Number, in z: Length) {
    return radius * cos(angle * rad) * e1 + radius * sin(angle * rad) * e2 + z * e3;
}
function flank(in side) {
    return [[at(18 mm + 0.5 mm * k, side * (0.09 - 0.006 * k), z) for k in 0 .. 9] for z in [-5 mm, 0 mm, 5 mm]];
}
function fillet(in side) {
    return [[at(18 mm - 0.6 mm * sin(k * pi / 16), side * (0.13 - 0.04 * cos(k * pi / 16)), z) for k in 0 .. 9]
        for z in [-5 mm, 0 mm, 5 mm]];
}
var lubrication = gears.lubrication("ISO VG 220", temperature = 70, roughness = 0.6 um);
var speed = 1000 rpm;
var member = gears.lumped_member(1 kg, 1e-3 kg*m^2, 20 mm, 1e8 N/m);
var planet_member = gears.lumped_member(1 kg, 1e-3 kg*m^2, 20 mm);
var modes = gears.lumped_planetary(member, member, member, planet_member, 1e8 N/m, 1e8 N/m, 1e8 N/m, 20 deg, 20 deg);
"#;

/// The scene of functions of `iso21771`.
const GEAR_DATA: &str = r#"
import gears;
import iso21771;
var pinion_gear = gears.external(24, normal_module = 3 mm, face_width = 30 mm);
var mesh = gears.pair(pinion_gear, pinion_gear, center_distance = 72 mm, torque = 10 N*m, speed = 1000 rpm).mesh;
function same(in x) { return x; }
var gear_data = iso21771.gear_data(24, 30 mm, normal_module = 3 mm);
var pair_data = iso21771.pair_data(gear_data, gear_data);
"#;

const PAIR: &str = r#"
var pinion = gears.body("pinion", pinion_gear, free = ["theta_z"], moment = 10 N*m * e3, frame := Rotate(speed * Time, e3));
var wheel = gears.body("wheel", pinion_gear, frame := Rotate(-speed * Time, e3) * Translate(40 mm * e1));
var housing = gears.rigid_body("housing", free = ["u_x", "u_y"], mass = 1 kg, frame := Translate(1 m * e1));
var bearing = gears.bearing("seat", housing, radial_stiffness = 1e8 N/m);
var mesh = gears.mesh(pinion, wheel, coast_side_contact = TRUE, lubrication = lubrication);
var gauge = gears.gauge(pinion);
output error := gears.transmission_error(mesh);
"#;

const MESHLESS: &str = r#"
var sun_like = gears.body("third", pinion_gear, free = ["theta_z"], moment = 10 N*m * e3, frame := Rotate(speed * Time, e3) * Translate(1 m * e2));
var planet_like = gears.body("fourth", pinion_gear, frame := Rotate(-speed * Time, e3) * Translate(40 mm * e1 + 1 m * e2));
"#;

/// Returns a model with one call.
pub fn model(function: &Function, arguments: &[String]) -> String {
    let call = format!("{}({}) {MARK};", function.path, arguments.join(", "));
    if function.path.starts_with("iso21771.") {
        return format!("{GEAR_DATA}{call}\n");
    }
    let mut text = SCENE.to_owned();
    if function.name != "planetary" {
        text += PAIR;
    }
    if function.name == "mesh" {
        text += MESHLESS;
    }
    match (function.is_observable, function.name.as_str()) {
        (true, _) => text += &format!("output observed := {call}\n"),
        (false, "analyze") => return text + &call + "\n",
        (false, "planetary") => {
            text += &format!(
                "var set = {call}\nvar mesh = set.sun_meshes[0];\noutput error := gears.transmission_error(mesh);\n"
            );
        }
        (false, _) => text += &format!("{call}\n"),
    }
    text + "analyze(\"quasi_static\", over = gears.mesh_cycle(mesh, 2), fidelity = \"analytic\", error_estimates = \"none\");\n"
}

impl Argument {
    /// Returns `true` for a number that is a count.
    pub fn is_count(&self) -> bool {
        const COUNTS: [&str; 12] = [
            "teeth",
            "contact_cells",
            "contact_slices",
            "steps",
            "count",
            "planets",
            "mode",
            "modes",
            "tooth",
            "face_elements",
            "output_every",
            "revolutions",
        ];
        self.is_number && COUNTS.contains(&self.name.as_str())
    }

    /// Returns the unit of its range, as written after a number.
    fn unit(&self) -> &str {
        let written = self.low.as_deref().or(self.high.as_deref()).unwrap_or_default();
        let number = |c: char| c.is_ascii_digit() || matches!(c, '-' | '+' | '.' | 'e' | ' ');
        written.trim_start_matches(number)
    }

    fn number(&self, random: &mut Random) -> String {
        const EXTREME: [&str; 18] = [
            "0", "-0.0", "-1", "1", "0.5", "1e300", "-1e300", "1e-300", "-1e-300", "1e12", "1e9", "65536",
            "1e-9", "17.5", "1e5", "nan", "inf", "-inf",
        ];
        let unit = self.unit();
        let one = if unit.is_empty() { "1".to_owned() } else { format!("(1 {unit})") };
        match random.below(8) {
            0 => self.low.clone().unwrap_or_else(|| format!("0 * {one}")),
            1 => self.high.clone().unwrap_or_else(|| format!("1e300 * {one}")),
            2 => self.high.as_deref().map_or_else(|| one.clone(), |high| format!("0.999 * ({high})")),
            // Any value in the range, uniform in order of magnitude.
            3 => {
                let end = self.high.as_deref().or(self.low.as_deref()).unwrap_or("1");
                format!("1e-{} * ({end})", random.below(16))
            }
            4 => self
                .sample
                .clone()
                .filter(|sample| self.ty.starts_with(char::is_uppercase) && sample != "none")
                .filter(|_| self.is_scalar())
                .map_or_else(
                    || format!("0 * {one}"),
                    |sample| format!("{} * ({sample})", ["1e-6", "-1", "1e3", "1.5"][random.below(4)]),
                ),
            _ => format!("({} * {one})", EXTREME[random.below(EXTREME.len())]),
        }
    }

    fn is_scalar(&self) -> bool {
        !self.ty.starts_with("Array") && !self.ty.starts_with("Vector")
    }

    fn extreme(&self, random: &mut Random) -> String {
        if self.is_number {
            let elements = random.below(3);
            let mut number = || {
                let text = self.number(random);
                // The result of a function is not constant, so its range is checked at run time.
                if random.below(2) == 0 { text } else { format!("same({text})") }
            };
            let vector = |x: String| format!("({x}) * e1");
            return match self.ty.as_str() {
                ty if ty.starts_with("Vector") => vector(number()),
                ty if ty.starts_with("Array(Vector") => {
                    format!("[{}, {}, {}]", vector(number()), vector(number()), vector(number()))
                }
                ty if ty.starts_with("Array") => match elements {
                    0 => format!("[{}]", number()),
                    1 => format!("[{}, {}]", number(), number()),
                    _ => format!("[{}, {}, {}]", number(), number(), number()),
                },
                _ => number(),
            };
        }
        match self.ty.as_str() {
            "String" => {
                let long = "é".repeat(300);
                let own = ["", "x", "\\n", "../../x", "nan", "0", long.as_str()];
                let text = match random.below(2) {
                    0 => format!("\"{}\"", own[random.below(own.len())]),
                    _ if self.choices.is_empty() => "\"pinion\"".into(),
                    _ => self.choices[random.below(self.choices.len())].clone(),
                };
                if random.below(2) == 0 { text } else { format!("same({text})") }
            }
            "Bool" => ["TRUE", "FALSE"][random.below(2)].into(),
            "Array(String)" => {
                ["[]", "[\"\"]", "[\"u_x\", \"u_x\"]", "[\"theta_x\", \"u_z\"]", "[same(\"u_q\")]"]
                    [random.below(5)]
                .into()
            }
            "Symbolic(Transform)" => {
                let one = ["0", "1e300", "1e-300", "-1", "1e12"][random.below(5)];
                [
                    format!("Translate({one} * (1 m) * e1)"),
                    format!("Rotate({one} * (1 rad), e3)"),
                    format!("Rotate({one} * (1 rpm) * Time, e1)"),
                    format!("Translate({one} * (1 m/s) * Time * e3)"),
                ][random.below(4)]
                .clone()
            }
            "Body" => {
                ["ground()", "pinion", "wheel", "housing"][random.below(4)].replace("ground", "gears.ground")
            }
            ty if ty.starts_with("Array(") => "[]".into(),
            _ => self.sample.clone().unwrap_or_default(),
        }
    }
}

impl Function {
    /// Returns named arguments; those without a value are omitted.
    pub fn arguments(&self, mut value: impl FnMut(&Argument) -> Option<String>) -> Vec<String> {
        let given = self.parameters.iter().filter_map(|parameter| Some((parameter, value(parameter)?)));
        given
            .map(|(parameter, value)| {
                let bind = if parameter.ty.starts_with("Symbolic") { ":=" } else { "=" };
                format!("{} {bind} {value}", parameter.name)
            })
            .collect()
    }

    /// Returns the sample with every name, current or former, padded with blanks to the length of
    /// the longer one, so that two programs that differ in names only have equal locations.
    pub fn padded(&self, is_former: bool) -> String {
        let chosen = |names: [String; 2]| {
            let [current, former] = names;
            if is_former { former } else { current }
        };
        let mut renamed = Function { path: String::new(), ..self.clone() };
        for parameter in &mut renamed.parameters {
            parameter.name = chosen(both(&parameter.name, &parameter.former));
        }
        let prefix = self.path.strip_suffix(&self.name).unwrap_or_default();
        renamed.path = format!("{prefix}{}", chosen(both(&self.name, &self.former)));
        model(&renamed, &renamed.arguments(|parameter| parameter.sample.clone()))
    }

    /// Replaces padded former names in a text by padded current names.
    pub fn with_current_names(&self, text: &str) -> String {
        let own = [(&self.name, &self.former)];
        let parameters = self.parameters.iter().map(|parameter| (&parameter.name, &parameter.former));
        own.into_iter().chain(parameters).fold(text.to_owned(), |text, (name, former)| {
            let [current, former] = both(name, former);
            text.replace(&former, &current)
        })
    }

    /// Returns the sample with one to three arguments replaced by extreme values.
    pub fn extreme(&self, random: &mut Random) -> Vec<String> {
        let count = 1 + random.below(3);
        let chosen: Vec<usize> = (0..count).map(|_| random.below(self.parameters.len().max(1))).collect();
        let mut index = 0;
        self.arguments(|parameter| {
            index += 1;
            if chosen.contains(&(index - 1)) {
                Some(parameter.extreme(random))
            } else {
                parameter.sample.clone()
            }
        })
    }
}

/// Returns the current and the former name, padded with blanks to equal lengths; the current name
/// twice if there is no former one.
fn both(name: &str, former: &Option<String>) -> [String; 2] {
    let former = former.as_deref().unwrap_or(name);
    let width = name.len().max(former.len());
    [name, former].map(|name| format!("{name:width$}"))
}

/// A linear congruential generator, so that random numbers are the same on every machine.
pub struct Random(pub u64);

impl Random {
    /// Returns a number below `end`.
    pub fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) % end.max(1) as u64) as usize
    }
}
