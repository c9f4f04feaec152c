//! Study files, `--study FILE.toml`: axes, toleranced params and objectives of a sweep, with their
//! locations, so that errors point into the file.

use super::axis::{Axis, check_not_array, check_units, number, refused, spaced};
use super::case_file::CaseFile;
use super::tolerances::{Parts, Quantity, Sampling, Tolerance, distribution, parse_distribution, toleranced};
use super::varied::Varied;
use super::{MOST_CASES, objective};
use crate::error::Error;
use crate::param_assignment::{AssignedValue, Origin, ParamAssignment};
use crate::params::{InvalidParam, index_of};
use crate::params_file::{toml_assignments, toml_value};
use calyx_abi::description::{FileDescription, ModelDescription, ParamValue};
use calyx_report::study::{Method, Objective};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Keys of a study file.
const KEYS: [&str; 6] = ["cases", "objectives", "params", "axes", "tolerances", "sampling"];
/// Keys of an optimization, which a sweep refuses.
const OF_AN_OPTIMIZATION: [&str; 5] = ["objective", "constraints", "variables", "deviations", "optimization"];
/// Keys of a range.
const RANGE_KEYS: [&str; 4] = ["from", "to", "count", "scale"];
/// Keys of a distribution.
const DISTRIBUTION_KEYS: [&str; 6] = ["distribution", "mean", "standard_deviation", "low", "high", "mode"];
/// Keys of the table `sampling`.
const SAMPLING_KEYS: [&str; 3] = ["method", "samples", "seed"];
/// Remedy for a value that is no axis.
const AXIS_FORMS: &str = "write a list, a range like `{ from = \"50 N*m\", to = \"500 N*m\", count = 10 }`, or a text as after `--over`, like \"50..500:10\" or \"*\"";
/// Remedy for a value that is no distribution.
const DISTRIBUTION_FORMS: &str = "write a text like \"normal(0 um, 5 um)\", or a table like `{ distribution = \"normal\", mean = \"0 um\", standard_deviation = \"5 um\" }`";

pub(crate) type Table<'t> = DeTable<'t>;
pub(crate) type Value<'t> = Spanned<DeValue<'t>>;

/// Function that reads a param by its name, the location of the name, and the value.
pub(crate) type Entry<'e, 'r> = dyn FnMut(&mut Reader<'r>, &str, Range<usize>, &Value<'_>) + 'e;

/// Text of a study file whose syntax is correct.
#[derive(Clone, Debug)]
pub struct StudyFile {
    file: Arc<FileDescription>,
    /// Values of params in all cases.
    pub params: Vec<ParamAssignment>,
    directory: PathBuf,
}

/// Content of a study file.
#[derive(Debug, Default)]
pub struct Study {
    /// Load cases.
    pub cases: Option<CaseFile>,
    /// Axes, of which the study has all combinations.
    pub axes: Vec<Axis>,
    pub tolerances: Vec<Tolerance>,
    pub sampling: Sampling,
    pub objectives: Vec<Objective>,
}

impl StudyFile {
    /// Reads a file.
    ///
    /// # Errors
    /// The file cannot be read, is no TOML, or its table `params` has no params.
    pub fn read(path: &Path) -> Result<StudyFile, InvalidParam> {
        let unreadable = |why: &str| {
            let message = format!("cannot read {}: {why}", path.display());
            InvalidParam::new(message, "give the path of a study file in TOML, like `study.toml`")
        };
        let bytes = std::fs::read(path).map_err(|error| unreadable(&error.to_string()))?;
        let text = String::from_utf8(bytes).map_err(|_| unreadable("it is not UTF-8 text"))?;
        let text = text.strip_prefix('\u{feff}').map(str::to_owned).unwrap_or(text);
        let file = Arc::new(FileDescription { name: path.display().to_string(), text });
        let directory = path.parent().map(Path::to_owned).unwrap_or_default();
        let mut study = StudyFile { file, params: Vec::new(), directory };
        study.params = {
            let mut table = DeTable::parse(&study.file.text)
                .map_err(|error| {
                    let at = study.origin(error.span().unwrap_or(0..0));
                    let message = format!("the file is not as it should be: {}", error.message());
                    let help = "write tables like `[axes]` and a key a line, like `torque = [50, 100]`";
                    InvalidParam { origin: at, ..InvalidParam::new(message, help) }
                })?
                .into_inner();
            match table.remove("params") {
                Some(params) => study.assignments(params)?,
                None => Vec::new(),
            }
        };
        Ok(study)
    }

    fn assignments(&self, params: Value<'_>) -> Result<Vec<ParamAssignment>, InvalidParam> {
        let at = params.span();
        match params.into_inner() {
            DeValue::Table(table) => toml_assignments(&self.file, table),
            other => Err(InvalidParam {
                origin: self.origin(at),
                ..InvalidParam::new(
                    format!("`params` is {}, not a table", kind_of(&other)),
                    "write `[params]`, and below it a param a line, like `torque = 500`",
                )
            }),
        }
    }

    pub(crate) fn origin(&self, at: Range<usize>) -> Option<Origin> {
        Some(Origin { file: self.file.clone(), start: at.start, end: at.end })
    }

    /// Reads the content for a model.
    ///
    /// # Errors
    /// All mistakes of the file, in its order.
    pub fn study(&self, description: &ModelDescription) -> Result<Study, Vec<InvalidParam>> {
        self.read_with(description, &KEYS, "a study file", |reader, root, study| {
            if let Some(objectives) = root.get("objectives") {
                study.objectives = reader.objectives(objectives);
            }
        })
    }

    /// Reads the content for a model, with `keys` at the top level of the file, which is called
    /// `owner` in messages. `more` reads what is not common to all studies.
    ///
    /// # Errors
    /// All mistakes of the file, in its order.
    pub(crate) fn read_with(
        &self,
        description: &ModelDescription,
        keys: &[&str],
        owner: &str,
        more: impl FnOnce(&mut Reader<'_>, &Table<'_>, &mut Study),
    ) -> Result<Study, Vec<InvalidParam>> {
        let mut reader = Reader { study: self, description, mistakes: Vec::new() };
        let mut study = Study::default();
        if let Ok(table) = DeTable::parse(&self.file.text) {
            let root = table.get_ref();
            reader.check_keys(root, keys, owner);
            reader.root(root, &mut study);
            more(&mut reader, root, &mut study);
        }
        let mut mistakes = reader.mistakes;
        if mistakes.is_empty() {
            return Ok(study);
        }
        mistakes.sort_by_key(|mistake| mistake.origin.as_ref().map(|origin| origin.start));
        Err(mistakes)
    }
}

/// Returns the kind of a value, as messages state it.
pub(crate) fn kind_of(value: &DeValue<'_>) -> &'static str {
    match value {
        DeValue::String(_) => "a text",
        DeValue::Integer(_) | DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "a Boolean",
        DeValue::Datetime(_) => "a date",
        DeValue::Array(_) => "an array",
        DeValue::Table(_) => "a table",
    }
}

/// Reader that collects the mistakes of a file.
pub(crate) struct Reader<'r> {
    study: &'r StudyFile,
    pub(crate) description: &'r ModelDescription,
    mistakes: Vec<InvalidParam>,
}

impl<'r> Reader<'r> {
    /// Returns a reader of the same file for another description, without mistakes.
    pub(crate) fn with_description<'d>(&self, description: &'d ModelDescription) -> Reader<'d>
    where
        'r: 'd,
    {
        Reader { study: self.study, description, mistakes: Vec::new() }
    }

    pub(crate) fn into_mistakes(self) -> Vec<InvalidParam> {
        self.mistakes
    }

    /// Adds mistakes of another reader.
    pub(crate) fn extend(&mut self, mistakes: Vec<InvalidParam>) {
        self.mistakes.extend(mistakes);
    }

    pub(crate) fn mistake(&mut self, at: Range<usize>, message: impl Into<String>, help: impl Into<String>) {
        let origin = self.study.origin(at);
        self.mistakes.push(InvalidParam { origin, ..InvalidParam::new(message, help) });
    }

    /// Records an error at a location, unless it has one.
    fn record(&mut self, at: Range<usize>, error: Error) {
        match error {
            Error::Given(mut refused) => {
                refused.origin = refused.origin.or_else(|| self.study.origin(at));
                self.mistakes.push(refused);
            }
            Error::Model(error) => self.mistake(at, error.message, error.help),
        }
    }

    pub(crate) fn recorded<T>(&mut self, at: Range<usize>, result: Result<T, Error>) -> Option<T> {
        result.map_err(|error| self.record(at, error)).ok()
    }

    /// Records keys that a table does not have.
    pub(crate) fn check_keys(&mut self, table: &Table<'_>, known: &[&str], owner: &str) {
        for key in table.keys().filter(|key| !known.contains(&key.get_ref().as_ref())) {
            let name = key.get_ref();
            if known == KEYS && OF_AN_OPTIMIZATION.contains(&name.as_ref()) {
                let message = format!("`{name}` belongs to an optimization");
                self.mistake(key.span(), message, "run `calyx optimize` with this file, or remove the key");
                continue;
            }
            let near = known.iter().find(|known| strsim::damerau_levenshtein(known, name) <= 2);
            let mut help = near.map(|near| format!("did you mean `{near}`? ")).unwrap_or_default();
            help += &format!("{owner} has the keys {}", known.join(", "));
            self.mistake(key.span(), format!("unknown key `{name}`"), help);
        }
    }

    pub(crate) fn text<'t>(&mut self, value: &'t Value<'_>, key: &str, help: &str) -> Option<&'t str> {
        match value.get_ref() {
            DeValue::String(text) => Some(text.as_ref()),
            other => {
                self.mistake(value.span(), format!("`{key}` is {}, not a text", kind_of(other)), help);
                None
            }
        }
    }

    pub(crate) fn whole<T: std::str::FromStr>(
        &mut self,
        value: &Value<'_>,
        key: &str,
        help: &str,
    ) -> Option<T> {
        let number = match value.get_ref() {
            DeValue::Integer(number) if number.radix() == 10 => number.as_str().parse().ok(),
            _ => None,
        };
        if number.is_none() {
            let shown = value_text(&self.study.file.text, value);
            self.mistake(value.span(), format!("`{key}` cannot be `{shown}`"), help);
        }
        number
    }

    pub(crate) fn sub_table<'t, 'v>(&mut self, value: &'t Value<'v>, key: &str) -> Option<&'t Table<'v>> {
        match value.get_ref() {
            DeValue::Table(table) => Some(table),
            other => {
                let message = format!("`{key}` is {}, not a table", kind_of(other));
                self.mistake(value.span(), message, format!("write `[{key}]`, and below it a key a line"));
                None
            }
        }
    }

    fn root(&mut self, root: &Table<'_>, study: &mut Study) {
        if let Some(cases) = root.get("cases") {
            study.cases = self.cases(cases);
        }
        let mut axes = Vec::new();
        if let Some(table) = root.get("axes").and_then(|value| self.sub_table(value, "axes")) {
            self.entries(table, "", &mut |reader, name, at, value| reader.axis(name, at, value, &mut axes));
        }
        // Tables are sorted by name; the axes are those of the file.
        axes.sort_by_key(|(at, _)| *at);
        study.axes = axes.into_iter().map(|(_, axis)| axis).collect();
        let tolerances = &mut study.tolerances;
        if let Some(table) = root.get("tolerances").and_then(|value| self.sub_table(value, "tolerances")) {
            self.entries(table, "", &mut |reader, name, at, value| {
                tolerances.extend(reader.tolerance(name, at, value));
            });
        }
        if let Some(table) = root.get("sampling").and_then(|value| self.sub_table(value, "sampling")) {
            study.sampling = self.sampling(table);
        }
        self.check_repeated(root, study);
        self.check_sample(root, study);
    }

    /// Calls `each` with the names of params and their values. A table under a name that no param
    /// has contains the params of an instance of a component.
    pub(crate) fn entries(&mut self, table: &Table<'_>, prefix: &str, each: &mut Entry<'_, 'r>) {
        for (key, value) in table {
            let name = format!("{prefix}{}", key.get_ref());
            let is_instance = |param: &str| {
                param.strip_prefix(name.as_str()).is_some_and(|rest| rest.starts_with(['.', '[']))
            };
            match value.get_ref() {
                DeValue::Table(parts)
                    if self.description.params.iter().any(|param| is_instance(&param.name)) =>
                {
                    self.entries(parts, &format!("{name}."), each);
                }
                _ => each(self, &name, key.span(), value),
            }
        }
    }

    fn cases(&mut self, value: &Value<'_>) -> Option<CaseFile> {
        let help = "give the path of a CSV file, relative to the study file";
        let path = self.text(value, "cases", help)?;
        let file = CaseFile::read(&self.study.directory.join(path), self.description);
        self.recorded(value.span(), file)
    }

    fn axis(&mut self, name: &str, at: Range<usize>, value: &Value<'_>, axes: &mut Vec<(usize, Axis)>) {
        let varied = Varied::named(name, self.description);
        let Some(varied) = self.recorded(at.clone(), varied) else { return };
        let checked = check_not_array(varied, self.description);
        if self.recorded(at.clone(), checked).is_none() {
            return;
        }
        let axis = match value.get_ref() {
            DeValue::Array(_) => self.list(varied, value).map(|values| Axis::of(varied, values, false)),
            DeValue::Table(table) => self.range(varied, value.span(), table),
            DeValue::String(text) => {
                let axis = Axis::of_values(varied, text.trim(), self.description);
                self.recorded(value.span(), axis)
            }
            other => {
                let message = format!("the axis `{name}` is {}", kind_of(other));
                self.mistake(value.span(), message, AXIS_FORMS);
                None
            }
        };
        axes.extend(axis.map(|axis| (at.start, axis)));
    }

    /// Reads the values of an axis from a list.
    fn list(&mut self, varied: Varied, value: &Value<'_>) -> Option<Vec<ParamValue>> {
        let DeValue::Array(elements) = value.get_ref() else { return None };
        if elements.is_empty() {
            self.mistake(value.span(), "the list is empty", "give at least one value");
            return None;
        }
        let texts: Vec<String> =
            elements.iter().map(|element| value_text(&self.study.file.text, element)).collect();
        let checked = check_units(varied, &texts, self.description);
        self.recorded(value.span(), checked)?;
        let values: Vec<Option<ParamValue>> =
            elements.iter().map(|element| self.value(varied, element)).collect();
        values.into_iter().collect()
    }

    /// Reads a value of a quantity.
    fn value(&mut self, varied: Varied, value: &Value<'_>) -> Option<ParamValue> {
        let assigned = self.assigned(value)?;
        let origin = self.study.origin(value.span());
        let value_of = varied.value(&assigned, origin.as_ref(), self.description);
        self.recorded(value.span(), value_of)
    }

    pub(crate) fn assigned(&mut self, value: &Value<'_>) -> Option<AssignedValue> {
        match toml_value(value.get_ref().clone()) {
            Ok(assigned) => Some(assigned),
            Err(kind) => {
                self.mistake(
                    value.span(),
                    format!("{kind} is no value of a param"),
                    "give a number or a text",
                );
                None
            }
        }
    }

    /// Reads a range: both ends, the number of values, and the scale.
    fn range(&mut self, varied: Varied, at: Range<usize>, table: &Table<'_>) -> Option<Axis> {
        self.check_keys(table, &RANGE_KEYS, "a range");
        for key in &RANGE_KEYS[..3] {
            if table.get(*key).is_none() {
                self.mistake(at.clone(), format!("the range has no `{key}`"), AXIS_FORMS);
                return None;
            }
        }
        let log = match table.get("scale") {
            None => false,
            Some(scale) => match self.text(scale, "scale", "write \"linear\" or \"log\"")? {
                "linear" => false,
                "log" => true,
                other => {
                    let message = format!("there is no scale called `{other}`");
                    self.mistake(scale.span(), message, "write \"linear\" or \"log\"");
                    return None;
                }
            },
        };
        let help = format!("give a whole number from 2 to {MOST_CASES}");
        let count_at = table.get("count")?;
        let count: usize = self.whole(count_at, "count", &help)?;
        if !(2..=MOST_CASES).contains(&count) {
            self.mistake(count_at.span(), format!("`{count}` is not a number of values"), help);
            return None;
        }
        let ends = [table.get("from")?, table.get("to")?];
        let texts = ends.map(|end| value_text(&self.study.file.text, end));
        let checked = check_units(varied, &texts, self.description);
        self.recorded(at.clone(), checked)?;
        let mut numbers = [f64::NAN; 2];
        for (k, end) in ends.into_iter().enumerate() {
            let value = self.value(varied, end)?;
            let si = number(&value, varied.name(self.description));
            numbers[k] = self.recorded(end.span(), si)?;
            if log && numbers[k] <= 0.0 {
                self.mistake(end.span(), "the logarithmic range is not positive", "give positive ends");
                return None;
            }
        }
        let integral = varied.param(self.description).is_some_and(|param| param.integral);
        let values = spaced(numbers, count, log, integral).into_iter().map(ParamValue::Number);
        Some(Axis::of(varied, values.collect(), log))
    }

    pub(crate) fn tolerance(&mut self, name: &str, at: Range<usize>, value: &Value<'_>) -> Option<Tolerance> {
        let param = toleranced(name, self.description);
        let param = self.recorded(at, param)?;
        let distribution = match value.get_ref() {
            DeValue::String(text) => {
                let parsed = parse_distribution(text, param, self.description);
                self.recorded(value.span(), parsed)?
            }
            DeValue::Table(table) => self.distribution(param, value.span(), table)?,
            other => {
                let message = format!("the tolerance of `{name}` is {}", kind_of(other));
                self.mistake(value.span(), message, DISTRIBUTION_FORMS);
                return None;
            }
        };
        Some(Tolerance { param, distribution, origin: self.study.origin(value.span()) })
    }

    fn distribution(
        &mut self,
        param: usize,
        at: Range<usize>,
        table: &Table<'_>,
    ) -> Option<super::Distribution> {
        self.check_keys(table, &DISTRIBUTION_KEYS, "a distribution");
        let Some(kind) = table.get("distribution") else {
            self.mistake(at, "the tolerance has no `distribution`", DISTRIBUTION_FORMS);
            return None;
        };
        let kind_text = self.text(kind, "distribution", DISTRIBUTION_FORMS)?.to_owned();
        let mut numbers: Vec<Option<(AssignedValue, Option<Origin>)>> = Vec::new();
        for key in &DISTRIBUTION_KEYS[1..] {
            let number = match table.get(*key) {
                Some(value) => Some((self.assigned(value)?, self.study.origin(value.span()))),
                None => None,
            };
            numbers.push(number);
        }
        let part = |k: usize| -> Option<Quantity<'_>> {
            numbers[k].as_ref().map(|(value, origin)| (value, origin.clone()))
        };
        let parts =
            Parts { mean: part(0), standard_deviation: part(1), low: part(2), high: part(3), mode: part(4) };
        let read = distribution(&kind_text, param, &parts, self.description);
        self.recorded(
            if super::distribution::NAMES.contains(&kind_text.as_str()) { at } else { kind.span() },
            read,
        )
    }

    fn sampling(&mut self, table: &Table<'_>) -> Sampling {
        self.check_keys(table, &SAMPLING_KEYS, "sampling");
        let mut sampling = Sampling::default();
        if let Some(value) = table.get("method") {
            let help = format!("choose from {}", Method::ALL.map(Method::name).join(", "));
            if let Some(name) = self.text(value, "method", &help) {
                sampling.method = Method::named(name);
                if sampling.method.is_none() {
                    self.mistake(value.span(), format!("there is no method called `{name}`"), help);
                }
            }
        }
        if let Some(value) = table.get("samples") {
            let help = format!("give a whole number from 2 to {MOST_CASES}");
            sampling.samples = self.whole(value, "samples", &help);
        }
        if let Some(value) = table.get("seed") {
            sampling.seed = self.whole(value, "seed", "give a whole number, like `seed = 1`");
        }
        sampling
    }

    fn objectives(&mut self, value: &Value<'_>) -> Vec<Objective> {
        let help = "name two, like `objectives = [\"min stress\", \"min error.peak_to_peak\"]`";
        let DeValue::Array(elements) = value.get_ref() else {
            let message = format!("`objectives` is {}, not an array", kind_of(value.get_ref()));
            self.mistake(value.span(), message, help);
            return Vec::new();
        };
        if elements.len() != 2 {
            let message = format!("the study has {} objectives instead of two", elements.len());
            self.mistake(value.span(), message, help);
        }
        let mut all = Vec::new();
        for element in elements {
            let Some(text) = self.text(element, "objectives", help) else { continue };
            let parsed = objective::parse(text, self.description);
            all.extend(self.recorded(element.span(), parsed));
        }
        all
    }

    /// Records params that the file gives twice.
    fn check_repeated(&mut self, root: &Table<'_>, study: &Study) {
        let varied = |axis: &Axis| axis.params.clone();
        let axes: Vec<Varied> = study.axes.iter().flat_map(varied).collect();
        let cases: Vec<Varied> = study.cases.iter().flat_map(|file| varied(&file.axis)).collect();
        let repeated = |varied: &Varied| cases.contains(varied);
        if let Some(twice) = axes.iter().find(|varied| repeated(varied)) {
            let message = format!("`{}` is an axis and a column of the cases", twice.name(self.description));
            let at = root.get("axes").map_or(0..0, Spanned::span);
            self.mistake(at, message, "remove one of them");
        }
        for tolerance in &study.tolerances {
            let own = Varied::Param(tolerance.param);
            if axes.contains(&own) || cases.contains(&own) {
                let name = own.name(self.description).to_owned();
                let at = tolerance.origin.as_ref().map_or(0..0, |origin| origin.start..origin.end);
                self.mistake(at, format!("`{name}` is an axis and has a tolerance"), "remove one of them");
            }
        }
        for given in &self.study.params {
            let Ok(index) = index_of(self.description, &given.name) else { continue };
            let own = Varied::Param(index);
            if axes.contains(&own)
                || cases.contains(&own)
                || study.tolerances.iter().any(|t| t.param == index)
            {
                let refused = refused(
                    format!("`{}` has one value, and is also varied", given.name),
                    "remove it from [params], or do not vary it",
                );
                self.record(0..0, refused.placed(given.name_origin.as_ref()));
            }
        }
    }

    /// Records a sample without toleranced params.
    fn check_sample(&mut self, root: &Table<'_>, study: &Study) {
        let Some(sampling) = root.get("sampling") else { return };
        let toleranced = ["tolerances", "deviations"].iter().any(|key| root.get(*key).is_some());
        if !toleranced && study.sampling.samples.is_some() {
            self.mistake(
                sampling.span(),
                "no param has a distribution to sample",
                "add `[tolerances]`, and below it lines like `slope = \"normal(0 um, 5 um)\"`",
            );
        }
    }
}

/// Returns a value as its file has it, without the quotes of a text.
fn value_text(file: &str, value: &Value<'_>) -> String {
    match value.get_ref() {
        DeValue::String(text) => text.as_ref().to_owned(),
        _ => file.get(value.span()).unwrap_or_default().to_owned(),
    }
}
