//! The declared functions of the library, and models that call one of them.

mod samples;

use self::samples::{
    GEAR_DATA, MESHLESS, PAIR, ROLLING, SAMPLES, SCENE, SHAFT, sample_of, sample_of_gear_data,
};
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
const OF_FILES: [&str; 16] = [
    "read_table",
    "column",
    "nastran",
    "abaqus",
    "gmsh",
    "condensed_body",
    "attachment",
    "bore_region",
    "opening",
    "radiated_power",
    "sound_power_level",
    "radiation_efficiency",
    "sound_pressure_level",
    "panel",
    "mean_sound_pressure_level",
    "measured_sound_power_level",
];

/// Modules of formulas in Calyx, as standards print them. They neither change the scene nor request
/// memory in proportion to a number without a limit, so that their numbers need no ranges.
const OF_FORMULAS: [&str; 32] = [
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
    "bearing_fits",
    "gear_train",
    "gear_train_equations",
    "linear_equations",
    "stepped_planets",
    "transmission",
    "envelope",
    "bevel",
    "bevel_checks",
    "bevel_contact",
    "bevel_curve",
    "bevel_form",
    "bevel_gear",
    "bevel_mistakes",
    "bevel_pair_checks",
    "bevel_pattern",
    "bevel_section",
    "bevel_settings",
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

/// Functions that need a planetary set, a splined rim, axes that are not parallel, a dynamic
/// analysis, params or bearings on their result; [`samples::SCENE`] has none of them.
pub const NOT_IN_SCENE: [&str; 11] = [
    "alignment_error",
    "shaft_angle_error",
    "shaft",
    "mode_type",
    "lumped_natural_frequency",
    "spline_tooth_force",
    "impulse",
    "spectrogram",
    "order_map",
    "transfer_function",
    "sensitivity",
];

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
    if function.name == "mount" || function.name.starts_with("shaft_") {
        text += SHAFT;
    }
    if function.parameters.iter().any(|parameter| parameter.sample.as_deref() == Some("rolling")) {
        text += ROLLING;
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
