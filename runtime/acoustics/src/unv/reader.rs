//! Reader of universal files.

use super::dataset::{
    Abscissae, AnalysisData, Element, Entity, Function, FunctionAxis, FunctionEnd, Header, LocatedValues,
    NodalData, Node, Ordinates, ResultKind, SkippedDataset, TraceLine, Units, UnvDataset, UnvFile,
};
use super::record::{MOST_LINES, Records, Result, UnvError, real};
use faer::c64;

/// Reads a universal file. Characters that are not UTF-8 are replaced; they are valid in names.
///
/// # Errors
/// A dataset is not complete, a field is not a number, or the file is binary. The error has the
/// line.
pub fn read(content: &[u8]) -> Result<UnvFile> {
    if let Some(at) = content.iter().position(|byte| *byte == 0) {
        let line = 1 + content[..at].iter().filter(|byte| **byte == b'\n').count();
        let message = "the file is not text: it contains a zero byte";
        return Err(UnvError::new(line, message, "export the file as text, without binary functions"));
    }
    let text = String::from_utf8_lossy(content);
    let lines: Vec<&str> = text.lines().collect();
    if lines.len() > MOST_LINES {
        let message = format!("the file has more than {MOST_LINES} lines");
        return Err(UnvError::new(MOST_LINES, message, "export less data"));
    }
    let mut file = UnvFile::default();
    let mut at = 0;
    while at < lines.len() {
        if !is_delimiter(lines[at]) {
            if lines[at].trim().is_empty() {
                at += 1;
                continue;
            }
            let message = "text between datasets; `-1` is expected";
            return Err(UnvError::new(at + 1, message, "remove the text, or export the file again"));
        }
        let start = at;
        let Some(name) = lines.get(at + 1) else {
            let message = "the file ends where the number of a dataset is expected";
            return Err(UnvError::new(at + 1, message, "export the file again; it is not complete"));
        };
        let number = number(name.trim(), at + 2)?;
        let length = lines[at + 2..].iter().position(|line| is_delimiter(line)).ok_or_else(|| {
            let message = format!("the file ends within the dataset {number}");
            UnvError::new(
                start + 1,
                message,
                "export the file again, or check that the whole file was copied",
            )
        })?;
        let mut records = Records::new(number, &lines[at + 2..at + 2 + length], at + 2);
        match dataset(&mut records)? {
            Some(dataset) => {
                file.datasets.push(dataset);
                file.lines.push(start + 1);
            }
            None => file.skipped.push(SkippedDataset { number, line: start + 1 }),
        }
        at += length + 3;
    }
    Ok(file)
}

/// Whether a line starts or ends a dataset: -1 in the first six columns. An integer of ten columns
/// may have the value -1.
fn is_delimiter(line: &str) -> bool {
    line.trim() == "-1" && line.trim_end().len() <= 6
}

fn number(name: &str, line: usize) -> Result<u32> {
    if name.starts_with("58b") {
        let message = "the dataset 58 is binary";
        return Err(UnvError::new(line, message, "export functions as text"));
    }
    name.parse().map_err(|_| {
        let short: String = name.chars().take(30).collect();
        UnvError::new(line, format!("`{short}` is not the number of a dataset"), "export the file again")
    })
}

/// Reads a dataset; `None` if its number is not supported.
fn dataset(records: &mut Records<'_>) -> Result<Option<UnvDataset>> {
    let dataset = match records.number {
        151 => {
            let mut lines = Vec::new();
            while !records.is_empty() {
                lines.push(records.text("a line")?.trim_end().to_owned());
            }
            UnvDataset::Header(Header { lines })
        }
        164 => UnvDataset::Units(units(records)?),
        2411 => UnvDataset::Nodes(all(records, node)?),
        2412 => UnvDataset::Elements(all(records, element)?),
        82 => UnvDataset::TraceLine(trace_line(records)?),
        55 => UnvDataset::NodalData(nodal_data(records)?),
        58 => UnvDataset::Function(Box::new(function(records)?)),
        2414 => UnvDataset::AnalysisData(Box::new(analysis_data(records)?)),
        _ => return Ok(None),
    };
    if !records.is_empty() {
        records.text("a record")?;
        let message = format!("dataset {} has more records than its counts state", records.number);
        return Err(records.error(message, "correct the counts, or export the file again"));
    }
    Ok(Some(dataset))
}

fn all<T>(records: &mut Records<'_>, read: impl Fn(&mut Records<'_>) -> Result<T>) -> Result<Vec<T>> {
    let mut items = Vec::new();
    while !records.is_empty() {
        items.push(read(records)?);
    }
    Ok(items)
}

/// Returns columns of a line, which may have other characters than ASCII.
fn columns(line: &str, from: usize, to: usize) -> String {
    line.chars().skip(from).take(to - from).collect::<String>().trim().to_owned()
}

fn units(records: &mut Records<'_>) -> Result<Units> {
    let line = records.text("the code of the units")?;
    let integer = |from, to| columns(line, from, to).parse::<i64>();
    let Ok(code) = integer(0, 10) else {
        return Err(records.error("the units have no code in the first ten columns", "correct the record"));
    };
    let description = columns(line, 10, 30);
    let temperature_mode = integer(30, 40).unwrap_or(2);
    let mut values = Vec::new();
    while values.len() < 3 {
        values.extend(records.reals(25, "the factors of the units")?);
    }
    if values.len() == 3 && !records.is_empty() {
        values.extend(records.reals(25, "the offset of the temperature")?);
    }
    if let Some(factor) = values[..3].iter().find(|factor| **factor <= 0.0) {
        let message = format!("a factor of the units is {factor}");
        return Err(records.error(message, "state factors that are positive"));
    }
    let factors = [values[0], values[1], values[2]];
    let offset = values.get(3).copied().unwrap_or(0.0);
    Ok(Units { code, description, temperature_mode, factors, offset })
}

fn node(records: &mut Records<'_>) -> Result<Node> {
    let [label, export, displacement, color] = records.exactly("a node")?;
    let position = records.many_reals(3, 25, "the position of a node")?;
    let position = [position[0], position[1], position[2]];
    Ok(Node { label, attributes: [export, displacement, color], position })
}

fn element(records: &mut Records<'_>) -> Result<Element> {
    let [label, descriptor, physical, material, color, count] = records.exactly("an element")?;
    let beam = match Element::is_beam(descriptor) {
        true => Some(records.exactly("the record of a beam")?),
        false => None,
    };
    let count = records.count(count, "nodes of an element")?;
    let nodes = records.many_integers(count, "the nodes of an element")?;
    Ok(Element { label, descriptor, attributes: [physical, material, color], beam, nodes })
}

fn trace_line(records: &mut Records<'_>) -> Result<TraceLine> {
    let [number, count, color] = records.exactly("a trace line")?;
    let name = records.text("the name of a trace line")?.trim_end().to_owned();
    let count = records.count(count, "nodes of a trace line")?;
    let nodes = records.many_integers(count, "the nodes of a trace line")?;
    Ok(TraceLine { number, color, name, nodes })
}

/// Whether values of a data type are complex.
fn is_complex(records: &Records<'_>, data_type: i64) -> Result<bool> {
    match data_type {
        2 | 4 => Ok(false),
        5 | 6 => Ok(true),
        _ => Err(records.error(
            format!("the data type is {data_type}; 2, 4, 5 and 6 are supported"),
            "export real or complex numbers",
        )),
    }
}

fn nodal_data(records: &mut Records<'_>) -> Result<NodalData> {
    let names = records.texts(5, "a line of identification")?;
    let [model, analysis, characteristic, quantity, data_type, count] =
        records.exactly("the kind of the results")?;
    let kind = ResultKind { model, analysis, characteristic, quantity };
    let is_complex = is_complex(records, data_type)?;
    let mut integers = records.integers("the integers of the analysis")?;
    // The first two state the numbers of integers and reals that follow.
    let declared = |index: usize| integers.get(index).copied().unwrap_or(0);
    let (more, count_reals) = (declared(0), declared(1));
    let more = records.count(more, "integers of the analysis")? + 2;
    let count_reals = records.count(count_reals, "numbers of the analysis")?;
    while integers.len() < more {
        integers.extend(records.integers("the integers of the analysis")?);
    }
    let integers = integers.get(2..more).unwrap_or_default().to_vec();
    let reals = records.many_reals(count_reals, 13, "the numbers of the analysis")?;
    let count = records.count(count, "values of a node")?;
    let values = all(records, |records| {
        let [label] = records.exactly("the label of a node")?;
        located(records, label, count, is_complex)
    })?;
    Ok(NodalData { names, kind, is_complex, integers, reals, values })
}

fn located(records: &mut Records<'_>, label: i64, count: usize, is_complex: bool) -> Result<LocatedValues> {
    let parts = if is_complex { 2 * count } else { count };
    let numbers = records.many_reals(parts, 13, "the values of a node or element")?;
    Ok(LocatedValues { label, values: joined(&numbers, is_complex) })
}

fn joined(numbers: &[f64], is_complex: bool) -> Vec<c64> {
    if is_complex {
        numbers.chunks_exact(2).map(|pair| c64::new(pair[0], pair[1])).collect()
    } else {
        numbers.iter().map(|value| c64::new(*value, 0.0)).collect()
    }
}

fn analysis_data(records: &mut Records<'_>) -> Result<AnalysisData> {
    let [label] = records.exactly("the label of the dataset")?;
    let name = records.text("the name of the dataset")?.trim_end().to_owned();
    let [location] = records.exactly("the location of the results")?;
    let entity = match location {
        1 => Entity::Nodes,
        2 => Entity::Elements,
        _ => {
            return Err(records.error(
                format!("the location of the results is {location}; 1 and 2 are supported"),
                "export results at nodes or elements",
            ));
        }
    };
    let names = records.texts(5, "a line of identification")?;
    let [model, analysis, characteristic, quantity, data_type, count] =
        records.exactly("the kind of the results")?;
    let kind = ResultKind { model, analysis, characteristic, quantity };
    let is_complex = is_complex(records, data_type)?;
    let mut integers = Vec::new();
    for _ in 0..2 {
        integers.extend(records.integers("the integers of the analysis")?);
    }
    let mut reals = Vec::new();
    for _ in 0..2 {
        reals.extend(records.reals(13, "the numbers of the analysis")?);
    }
    let values = all(records, |records| match entity {
        Entity::Nodes => {
            let [label] = records.exactly("the label of a node")?;
            let count = records.count(count, "values of a node")?;
            located(records, label, count, is_complex)
        }
        Entity::Elements => {
            let [label, count] = records.exactly("the label of an element")?;
            let count = records.count(count, "values of an element")?;
            located(records, label, count, is_complex)
        }
    })?;
    Ok(AnalysisData { label, name, entity, names, kind, is_complex, integers, reals, values })
}

fn function(records: &mut Records<'_>) -> Result<Function> {
    let names = records.texts(5, "a line of identification")?;
    let line = records.text("the degrees of freedom of a function")?;
    let field = |from: usize, to: usize| {
        let text = columns(line, from, to);
        if text.is_empty() { Some(0) } else { text.parse::<i64>().ok() }
    };
    let end = |from: usize| -> Option<FunctionEnd> {
        let entity = columns(line, from + 1, from + 11);
        Some(FunctionEnd {
            entity,
            node: field(from + 11, from + 21)?,
            direction: field(from + 21, from + 25)?,
        })
    };
    let parsed = || -> Option<(i64, [i64; 3], [FunctionEnd; 2])> {
        let numbers = [field(5, 15)?, field(15, 20)?, field(20, 30)?];
        Some((field(0, 5)?, numbers, [end(30)?, end(55)?]))
    };
    let Some((kind, numbers, [response, reference])) = parsed() else {
        let message = "the degrees of freedom of a function are not in their columns";
        return Err(records.error(message, "export the file again"));
    };
    let line = records.text("the form of the data")?;
    let integers: Option<Vec<i64>> =
        (0..3).map(|k| columns(line, 10 * k, 10 * k + 10).parse().ok()).collect();
    let reals: Option<Vec<f64>> = (0..3).map(|k| real(&columns(line, 30 + 13 * k, 43 + 13 * k))).collect();
    let (Some(integers), Some(reals)) = (integers, reals) else {
        return Err(records.error("the form of the data is not in its columns", "export the file again"));
    };
    let complex = is_complex(records, integers[0])?;
    let is_double = matches!(integers[0], 4 | 6);
    let count = records.count(integers[1], "values of a function")?;
    let mut axes: [FunctionAxis; 4] = Default::default();
    for axis in &mut axes {
        let line = records.text("an axis of a function")?;
        let field = |from: usize, to: usize| columns(line, from, to).parse::<i64>().unwrap_or(0);
        let exponents = [field(10, 15), field(15, 20), field(20, 25)];
        let (label, units) = (columns(line, 26, 46), columns(line, 47, 67));
        *axis = FunctionAxis { quantity: field(0, 10), exponents, label, units };
    }
    let is_even = integers[2] != 0;
    let (abscissae, numbers_read) = values(records, count, [complex, is_double, is_even])?;
    let ordinates = if complex {
        Ordinates::Complex(joined(&numbers_read, true), is_double)
    } else {
        Ordinates::Real(numbers_read, is_double)
    };
    let abscissae = match is_even {
        true => Abscissae::Even { first: reals[0], increment: reals[1] },
        false => Abscissae::All(abscissae),
    };
    Ok(Function { names, kind, numbers, response, reference, abscissae, z: reals[2], axes, ordinates })
}

/// Reads the abscissae, if they are not even, and the parts of the ordinates of a function.
fn values(
    records: &mut Records<'_>,
    count: usize,
    [complex, is_double, is_even]: [bool; 3],
) -> Result<(Vec<f64>, Vec<f64>)> {
    let parts = if complex { 2 } else { 1 };
    let content = "the values of a function";
    if is_even {
        let width = if is_double { 20 } else { 13 };
        return Ok((Vec::new(), records.many_reals(parts * count, width, content)?));
    }
    let (mut abscissae, mut ordinates) = (Vec::new(), Vec::new());
    if !is_double {
        let all = records.many_reals((parts + 1) * count, 13, content)?;
        for group in all.chunks_exact(parts + 1) {
            abscissae.push(group[0]);
            ordinates.extend_from_slice(&group[1..]);
        }
        return Ok((abscissae, ordinates));
    }
    // Abscissae of 13 columns alternate with ordinates of 20.
    while abscissae.len() < count {
        let line = records.text(content)?.trim_end();
        let group = 13 + 20 * parts;
        let mut from = 0;
        while from < line.chars().count() && abscissae.len() < count {
            let field = |from: usize, to: usize| {
                let text = columns(line, from, to);
                real(&text).ok_or_else(|| {
                    let message = format!("{content} have `{text}` where a number is expected");
                    records.error(message, "correct the field")
                })
            };
            abscissae.push(field(from, from + 13)?);
            for part in 0..parts {
                let start = from + 13 + 20 * part;
                ordinates.push(field(start, start + 20)?);
            }
            from += group;
        }
    }
    Ok((abscissae, ordinates))
}
