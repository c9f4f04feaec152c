//! Writer of universal files.

use super::dataset::{
    Abscissae, AnalysisData, Element, Entity, Function, FunctionAxis, FunctionEnd, LocatedValues, NodalData,
    Ordinates, ResultKind, UnvDataset,
};
use super::record::{Result, UnvError, append_real};
use faer::c64;
use std::fmt::Write;

/// Largest integer of a field of ten columns with a space before it.
const LARGEST: i64 = 999_999_999;

/// Returns the text of a universal file.
///
/// # Errors
/// A value is not finite, an integer or a text is longer than its field, or an evenly spaced
/// function or a dataset has a wrong number of values. The line of the error is the position of
/// the dataset, from 1.
pub fn write(datasets: &[UnvDataset]) -> Result<String> {
    let mut text = String::new();
    for (index, dataset) in datasets.iter().enumerate() {
        let mut writer = Writer { text: &mut text, dataset: index + 1, error: None };
        writer.dataset(dataset);
        if let Some(error) = writer.error {
            return Err(error);
        }
    }
    Ok(text)
}

struct Writer<'t> {
    text: &'t mut String,
    dataset: usize,
    /// First error.
    error: Option<UnvError>,
}

impl Writer<'_> {
    fn fail(&mut self, message: String, help: &str) {
        let dataset = self.dataset;
        self.error.get_or_insert_with(|| UnvError::new(dataset, message, help));
    }

    fn dataset(&mut self, dataset: &UnvDataset) {
        let number = dataset.number();
        let _ = writeln!(self.text, "    -1\n{number:>6}");
        match dataset {
            UnvDataset::Header(header) => header.lines.iter().for_each(|line| self.line(line, 80)),
            UnvDataset::Units(units) => {
                self.integer(units.code, 10);
                self.padded(&units.description, 20);
                self.integer(units.temperature_mode, 10);
                self.text.push('\n');
                self.reals(&units.factors, [25, 17, 3], 'D');
                self.reals(&[units.offset], [25, 17, 3], 'D');
            }
            UnvDataset::Nodes(nodes) => {
                for node in nodes {
                    let [a, b, c] = node.attributes;
                    self.integers(&[node.label, a, b, c]);
                    self.reals(&node.position, [25, 16, 3], 'D');
                }
            }
            UnvDataset::Elements(elements) => {
                for element in elements {
                    let [a, b, c] = element.attributes;
                    let count = element.nodes.len() as i64;
                    self.integers(&[element.label, element.descriptor, a, b, c, count]);
                    if Element::is_beam(element.descriptor) {
                        self.integers(&element.beam.unwrap_or_default());
                    }
                    self.integers(&element.nodes);
                }
            }
            UnvDataset::TraceLine(line) => {
                self.integers(&[line.number, line.nodes.len() as i64, line.color]);
                self.line(&line.name, 80);
                self.integers(&line.nodes);
            }
            UnvDataset::NodalData(data) => self.nodal_data(data),
            UnvDataset::Function(function) => self.function(function),
            UnvDataset::AnalysisData(data) => self.analysis_data(data),
        }
        self.text.push_str("    -1\n");
    }

    /// Appends a text of at most `width` characters. A delimiter of datasets would end the dataset.
    fn line(&mut self, line: &str, width: usize) {
        if line.chars().count() > width || line.contains(['\n', '\r', '\0']) || line.trim() == "-1" {
            self.fail(
                format!("the text `{}` does not fit into {width} columns of one line", line.escape_debug()),
                "shorten the text",
            );
        }
        let _ = writeln!(self.text, "{}", line.trim_end());
    }

    fn padded(&mut self, text: &str, width: usize) {
        if text.chars().count() > width || text.chars().any(char::is_control) {
            self.fail(
                format!("the text `{}` does not fit into {width} columns", text.escape_debug()),
                "shorten the text",
            );
        }
        let _ = write!(self.text, "{text:<width$}");
    }

    fn integer(&mut self, value: i64, width: usize) {
        let largest = LARGEST / 10_i64.pow(10_u32.saturating_sub(width as u32));
        if value > largest || value < -largest / 10 {
            self.fail(format!("{value} does not fit into {width} columns"), "use smaller numbers");
        }
        let _ = write!(self.text, "{value:>width$}");
    }

    /// Appends records of eight integers.
    fn integers(&mut self, values: &[i64]) {
        for chunk in values.chunks(8) {
            chunk.iter().for_each(|value| self.integer(*value, 10));
            self.text.push('\n');
        }
    }

    fn real(&mut self, value: f64, [width, digits]: [usize; 2], letter: char) {
        if !value.is_finite() {
            self.fail(format!("the value {value} is not finite"), "write finite values");
        }
        append_real(self.text, value, width, digits, letter);
    }

    /// Appends records of numbers with a width, a number of digits, and a number per record.
    fn reals(&mut self, values: &[f64], [width, digits, count]: [usize; 3], letter: char) {
        for chunk in values.chunks(count) {
            chunk.iter().for_each(|value| self.real(*value, [width, digits], letter));
            self.text.push('\n');
        }
    }

    fn names(&mut self, names: &[String]) {
        if names.len() > 5 {
            self.fail(
                "there are more than five lines of identification".into(),
                "shorten the identification",
            );
        }
        for index in 0..5 {
            self.line(names.get(index).map_or("NONE", String::as_str), 80);
        }
    }

    fn kind(&mut self, kind: &ResultKind, is_complex: bool, count: usize) {
        let ResultKind { model, analysis, characteristic, quantity } = *kind;
        let data_type = if is_complex { 5 } else { 2 };
        self.integers(&[model, analysis, characteristic, quantity, data_type, count as i64]);
    }

    fn located(&mut self, values: &LocatedValues, is_complex: bool, count: Option<usize>) {
        if count.is_some_and(|count| values.values.len() != count) {
            let message = format!(
                "{} values at the label {}, and another number at the first label",
                values.values.len(),
                values.label
            );
            self.fail(message, "pass the same number of values for each label");
        }
        self.reals(&parts(&values.values, is_complex), [13, 5, 6], 'E');
    }

    fn nodal_data(&mut self, data: &NodalData) {
        self.names(&data.names);
        let count = data.values.first().map_or(0, |first| first.values.len());
        self.kind(&data.kind, data.is_complex, count);
        let mut integers = vec![data.integers.len() as i64, data.reals.len() as i64];
        integers.extend(&data.integers);
        self.integers(&integers);
        self.reals(&data.reals, [13, 5, 6], 'E');
        for values in &data.values {
            self.integers(&[values.label]);
            self.located(values, data.is_complex, Some(count));
        }
    }

    fn analysis_data(&mut self, data: &AnalysisData) {
        self.integers(&[data.label]);
        self.line(&data.name, 80);
        self.integers(&[if data.entity == Entity::Nodes { 1 } else { 2 }]);
        self.names(&data.names);
        let count = data.values.first().map_or(0, |first| first.values.len());
        self.kind(&data.kind, data.is_complex, count);
        if data.integers.len() > 16 || data.reals.len() > 12 {
            let message = "the analysis has more than 16 integers or 12 numbers";
            self.fail(message.into(), "omit the last ones");
        }
        let integers: Vec<i64> = (0..16).map(|k| data.integers.get(k).copied().unwrap_or(0)).collect();
        self.integers(&integers);
        let reals: Vec<f64> = (0..12).map(|k| data.reals.get(k).copied().unwrap_or(0.0)).collect();
        self.reals(&reals, [13, 5, 6], 'E');
        for values in &data.values {
            match data.entity {
                Entity::Nodes => {
                    self.integers(&[values.label]);
                    self.located(values, data.is_complex, Some(count));
                }
                Entity::Elements => {
                    self.integers(&[values.label, values.values.len() as i64]);
                    self.located(values, data.is_complex, None);
                }
            }
        }
    }

    fn end(&mut self, end: &FunctionEnd) {
        self.text.push(' ');
        self.padded(if end.entity.is_empty() { "NONE" } else { &end.entity }, 10);
        self.integer(end.node, 10);
        self.integer(end.direction, 4);
    }

    fn axis(&mut self, axis: &FunctionAxis) {
        self.integer(axis.quantity, 10);
        axis.exponents.iter().for_each(|exponent| self.integer(*exponent, 5));
        for text in [&axis.label, &axis.units] {
            self.text.push(' ');
            self.padded(if text.is_empty() { "NONE" } else { text }, 20);
        }
        self.text.push('\n');
    }

    fn function(&mut self, function: &Function) {
        self.names(&function.names);
        self.integer(function.kind, 5);
        let [number, version, case] = function.numbers;
        self.integer(number, 10);
        self.integer(version, 5);
        self.integer(case, 10);
        self.end(&function.response);
        self.end(&function.reference);
        self.text.push('\n');
        let (data_type, numbers, step, is_double) = match &function.ordinates {
            Ordinates::Real(values, double) => (if *double { 4 } else { 2 }, values.clone(), 1, *double),
            Ordinates::Complex(values, double) => {
                (if *double { 6 } else { 5 }, parts(values, true), 2, *double)
            }
        };
        let count = numbers.len() / step;
        let (first, increment, all) = match &function.abscissae {
            Abscissae::Even { first, increment } => (*first, *increment, None),
            Abscissae::All(values) => (values.first().copied().unwrap_or(0.0), 0.0, Some(values)),
        };
        self.integers_inline(&[data_type, count as i64, i64::from(all.is_none())]);
        self.reals(&[first, increment, function.z], [13, 5, 3], 'E');
        function.axes.iter().for_each(|axis| self.axis(axis));
        let Some(abscissae) = all else {
            let form = if is_double { [20, 12, 4] } else { [13, 5, 6] };
            return self.reals(&numbers, form, 'E');
        };
        if abscissae.len() != count {
            let message = format!("{} abscissae for {count} ordinates", abscissae.len());
            self.fail(message, "pass one abscissa for each ordinate");
        }
        let groups = match (is_double, step) {
            (false, 1) => 3,
            (true, 1) | (false, _) => 2,
            (true, _) => 1,
        };
        let form = if is_double { [20, 12] } else { [13, 5] };
        let pairs: Vec<(&f64, &[f64])> = abscissae.iter().zip(numbers.chunks(step)).collect();
        for record in pairs.chunks(groups) {
            for (abscissa, values) in record {
                self.real(**abscissa, [13, 5], 'E');
                values.iter().for_each(|value| self.real(*value, form, 'E'));
            }
            self.text.push('\n');
        }
    }

    fn integers_inline(&mut self, values: &[i64]) {
        values.iter().for_each(|value| self.integer(*value, 10));
    }
}

/// Returns real parts, or real and imaginary parts alternately.
fn parts(values: &[c64], is_complex: bool) -> Vec<f64> {
    let part = |value: &c64| if is_complex { vec![value.re, value.im] } else { vec![value.re] };
    values.iter().flat_map(part).collect()
}
