//! Motions of grid points in punch files.
//!
//! Source: NASTRAN Quick Reference Guide, case control command DISPLACEMENT (PUNCH). Lines have 72
//! columns and a number. Lines that begin with `$` state the title, the quantity, the form of
//! complex numbers, the subcase, and the eigenvalue, frequency or point. Points have two lines, or
//! four if they are complex: the translations, and after `-CONT-` the rotations, the second parts
//! of the translations and those of the rotations.

use super::format::punch_form;
use super::vectors::{
    Analysis, Collector, Form, GridVectors, Motion, NastranResults, Result, VectorAxes, error, mode_frequency,
};
use crate::unv::real;
use faer::c64;

/// Columns of the fields of a line, and of all fields.
const WIDTH: usize = 18;
const COLUMNS: usize = 72;

/// Remedies.
const AGAIN: &str = "write the file again, with DISP(PUNCH)=ALL in case control";
const WHOLE: &str = "check that the analysis finished, and copy the whole file";

/// Reads the motions of grid points from a punch file, sorted by frequency (SORT1) or by point
/// (SORT2).
///
/// # Errors
/// A line is damaged, a point has too few lines, or a header lacks its frequency or eigenvalue.
pub fn read_punch(text: &str) -> Result<NastranResults> {
    let mut reader = Reader::default();
    for (index, line) in text.lines().enumerate() {
        reader.line = index + 1;
        let line = match line.char_indices().nth(COLUMNS) {
            Some((end, _)) => &line[..end],
            None => line,
        };
        match line.trim_end() {
            "" => {}
            line if line.starts_with('$') => reader.header(line)?,
            line => reader.data(line)?,
        }
    }
    reader.end_vectors()?;
    Ok(reader.collector.finish())
}

/// Header of values.
#[derive(Clone, Debug, Default)]
struct Header {
    /// Quantity as the file names it; empty before it is read.
    quantity: String,
    form: Option<Form>,
    subcase: i64,
    mode: Option<i64>,
    /// Frequency of a response or of a mode, Hz.
    frequency: Option<f64>,
    /// Point of values that are sorted by point.
    point: Option<i64>,
    /// Reason why the values are skipped.
    skipped: Option<String>,
    /// True after the reason was counted.
    is_counted: bool,
}

impl Header {
    fn motion(&self) -> Option<Motion> {
        match self.quantity.as_str() {
            "DISPLACEMENTS" | "DISPLACEMENT" | "EIGENVECTOR" | "EIGENVECTORS" => Some(Motion::Displacement),
            "VELOCITY" | "VELOCITIES" => Some(Motion::Velocity),
            "ACCELERATION" | "ACCELERATIONS" => Some(Motion::Acceleration),
            _ => None,
        }
    }

    /// Returns analysis and frequency of values, or why they are skipped.
    fn analysis(&self) -> std::result::Result<(Motion, Analysis, f64), String> {
        let Some(motion) = self.motion() else {
            return Err(format!("results of {}", self.quantity.to_ascii_lowercase()));
        };
        match (&self.skipped, self.mode, self.frequency, self.point) {
            (Some(reason), ..) => Err(reason.clone()),
            (None, Some(mode), Some(frequency), None) => Ok((motion, Analysis::Mode(mode), frequency)),
            (None, None, Some(frequency), None) => Ok((motion, Analysis::Response, frequency)),
            (None, None, None, Some(_)) => Ok((motion, Analysis::Response, f64::NAN)),
            _ => Err("static results".into()),
        }
    }
}

/// Point whose lines are read.
#[derive(Debug)]
struct Point {
    /// Label, or the frequency of values that are sorted by point.
    first: f64,
    is_grid: bool,
    lines: usize,
    /// First and second parts of the translations.
    parts: [[f64; 3]; 2],
}

#[derive(Default)]
struct Reader {
    collector: Collector,
    /// Line, from 1.
    line: usize,
    header: Header,
    /// Vectors with this header; `None` before the first value.
    vectors: Option<GridVectors>,
    /// Values of vectors that are sorted by point.
    by_point: Vec<(f64, [c64; 3])>,
    point: Option<Point>,
    scalar_points: usize,
}

impl Reader {
    fn fail<T>(&self, message: impl Into<String>, help: &str) -> Result<T> {
        error(format!("line {}", self.line), message, help)
    }

    /// Reads a line that begins with `$`.
    fn header(&mut self, line: &str) -> Result<()> {
        self.end_vectors()?;
        if let Some(form) = punch_form(line) {
            self.header.form = Some(match form {
                "REAL" => Form::Real,
                "REAL-IMAGINARY" => Form::Cartesian,
                _ => Form::Polar,
            });
            return Ok(());
        }
        let text = line[1..].trim().to_ascii_uppercase();
        let (name, value) = text.split_once('=').unwrap_or((&text, ""));
        let (name, value) = (name.trim_end(), value.trim());
        match name {
            "TITLE" => self.header = Header::default(),
            "SUBTITLE" | "LABEL" => {}
            "SUBCASE ID" => self.header.subcase = self.integer(value)?,
            "EIGENVALUE" | "COMPLEX EIGENVALUE" if value.starts_with('(') => self.skip("complex modes"),
            "EIGENVALUE" => {
                let (eigenvalue, mode) = value.split_once("MODE").unwrap_or((value, ""));
                self.header.mode = Some(self.integer(mode.trim_start_matches([' ', '=']))?);
                self.header.frequency = Some(mode_frequency(self.number(eigenvalue)?));
            }
            "FREQUENCY" => self.header.frequency = Some(self.number(value)?),
            "TIME" | "TIME STEP" => self.skip("transient results"),
            "POINT ID" => {
                let (id, variable) = value.split_once("IDENTIFIED BY").unwrap_or((value, ""));
                self.header.point = Some(self.integer(id)?);
                match variable.trim() {
                    "" | "FREQUENCY" => {}
                    "TIME" => self.skip("transient results"),
                    other => self.skip(&format!("results by {}", shown(&other.to_ascii_lowercase()))),
                }
            }
            name if name.starts_with("RANDOM") => self.skip("random results"),
            _ if self.header.quantity.is_empty() => self.header.quantity = shown(name),
            _ => {}
        }
        Ok(())
    }

    fn skip(&mut self, reason: &str) {
        self.header.skipped.get_or_insert_with(|| reason.to_owned());
    }

    fn integer(&self, text: &str) -> Result<i64> {
        let word = text.split_whitespace().next().unwrap_or_default();
        match word.parse() {
            Ok(value) => Ok(value),
            Err(_) => self.fail(format!("`{}` is where an integer is expected", shown(word)), AGAIN),
        }
    }

    fn number(&self, text: &str) -> Result<f64> {
        let word = text.split_whitespace().next().unwrap_or_default();
        match real(word) {
            Some(value) => Ok(value),
            None => self.fail(format!("`{}` is where a number is expected", shown(word)), AGAIN),
        }
    }

    /// Ends the vectors of the last header.
    fn end_vectors(&mut self) -> Result<()> {
        if self.point.take().is_some_and(|point| point.is_grid) {
            return self.fail("a point lacks its last lines", WHOLE);
        }
        self.collector.skip("values of scalar points", std::mem::take(&mut self.scalar_points));
        let by_point = std::mem::take(&mut self.by_point);
        match (self.vectors.take(), self.header.point) {
            (Some(vectors), Some(point)) => self.collector.add_by_point(&vectors, point, &by_point),
            (Some(vectors), None) => self.collector.add(vectors),
            (None, _) => {}
        }
        Ok(())
    }

    /// Begins vectors with their first value. Returns their form; `None` if they are skipped.
    fn begin_vectors(&mut self) -> Result<Option<Form>> {
        let form = self.header.form;
        if self.vectors.is_some() {
            return Ok(form);
        }
        let (motion, analysis, frequency) = match self.header.analysis() {
            Ok(found) => found,
            Err(reason) => {
                if !std::mem::replace(&mut self.header.is_counted, true) {
                    self.collector.skip(reason, 1);
                }
                return Ok(None);
            }
        };
        if form.is_none() {
            return self.fail("values come before a line such as `$REAL OUTPUT`", AGAIN);
        }
        self.vectors = Some(GridVectors {
            place: format!("line {}", self.line),
            subcase: self.header.subcase,
            analysis,
            motion,
            frequency,
            axes: VectorAxes::Displacement,
            values: Vec::new(),
        });
        Ok(form)
    }

    /// Reads a line of values.
    fn data(&mut self, line: &str) -> Result<()> {
        let Some(form) = self.begin_vectors()? else { return Ok(()) };
        match line.strip_prefix("-CONT-") {
            None => {
                if self.point.take().is_some_and(|point| point.is_grid) {
                    return self.fail("the point before this line lacks its last lines", AGAIN);
                }
                self.point = Some(self.first_line(line)?);
            }
            Some(_) => {
                let Some(mut point) = self.point.take() else {
                    return self.fail("`-CONT-` follows no point", AGAIN);
                };
                point.lines += 1;
                if point.lines == 3 && point.is_grid {
                    point.parts[1] = self.fields(line, 1)?;
                }
                self.point = Some(point);
            }
        }
        let lines = if form == Form::Real { 2 } else { 4 };
        if let Some(point) = self.point.take_if(|point| point.lines == lines) {
            self.end_point(&point, form);
        }
        Ok(())
    }

    fn end_point(&mut self, point: &Point, form: Form) {
        if !point.is_grid {
            self.scalar_points += 1;
            return;
        }
        let [first, second] = point.parts;
        let vector = [0, 1, 2].map(|k: usize| form.value(first[k], second[k]));
        match (self.header.point, &mut self.vectors) {
            (Some(_), _) => self.by_point.push((point.first, vector)),
            (None, Some(vectors)) => vectors.values.push((point.first as i64, vector)),
            (None, None) => {}
        }
    }

    /// Reads the first line of a point: its label, or the frequency, its type, and translations.
    fn first_line(&self, line: &str) -> Result<Point> {
        let mut words = line.split_whitespace();
        let (first, kind) = (words.next().unwrap_or_default(), words.next().unwrap_or_default());
        let is_grid = kind.eq_ignore_ascii_case("G");
        let first = match self.header.point {
            Some(_) => self.number(first)?,
            None => self.integer(first)? as f64,
        };
        let values = if is_grid { self.fields(line, 2)? } else { [0.0; 3] };
        Ok(Point { first, is_grid, lines: 1, parts: [values, [0.0; 3]] })
    }

    /// Returns the three numbers of a line: in fields of 18 columns, or separated by blanks after
    /// some words.
    fn fields(&self, line: &str, words: usize) -> Result<[f64; 3]> {
        let column = |k: usize| -> Option<f64> {
            let from = (k + 1) * WIDTH;
            real(line.get(from..line.len().min(from + WIDTH))?.trim())
        };
        if let (Some(x), Some(y), Some(z)) = (column(0), column(1), column(2)) {
            return Ok([x, y, z]);
        }
        let rest: Vec<&str> = line.split_whitespace().skip(words).collect();
        match rest[..] {
            [x, y, z, ..] => Ok([self.number(x)?, self.number(y)?, self.number(z)?]),
            _ => self.fail(format!("the line has {} of three values", rest.len()), AGAIN),
        }
    }
}

/// Returns the beginning of a text, for messages.
fn shown(text: &str) -> String {
    text.chars().take(30).collect()
}
