//! Motions of grid points in OP2 files: the tables OUG and OPHIG.
//!
//! Source: NX Nastran DMAP Programmer's Guide, "OUG: Table of displacements, velocities,
//! accelerations". Logical records come in pairs from number 3 on: an identification, and the
//! values of its points (SORT1) or of the frequencies of its point (SORT2).

use super::blocks::{BlockName, Blocks, Words};
use super::vectors::{
    Analysis, Collector, Form, GridVectors, Motion, NastranResults, Result, VectorAxes, error, mode_frequency,
};
use faer::c64;

/// Tables of displacements, velocities and accelerations of grid points along their own axes.
const OWN_AXES: [&str; 9] = ["OUG1", "OUG2", "OUGV1", "OUGV2", "OPHIG", "OVG1", "OVG2", "OAG1", "OAG2"];
/// The same in the basic coordinate system.
const BASIC: [&str; 7] = ["BOUG1", "BOUG2", "BOUGV1", "BOUGV2", "BOPHIG", "BOPHIGS", "OUGV1PAT"];

/// Words of an identification up to the last one that is read.
const IDENTIFICATION: usize = 23;
/// Type of points that are grid points.
const GRID: i64 = 1;

/// Reads the motions of grid points from an OP2 file: both byte orders, words of four and eight
/// bytes, real and complex numbers, sorted by frequency (SORT1) or by point (SORT2).
///
/// # Errors
/// The file is truncated or damaged, or a table has other words than its identification states.
pub fn read_op2(content: &[u8]) -> Result<NastranResults> {
    let mut blocks = Blocks::new(content)?;
    let mut collector = Collector::default();
    while let Some(block) = blocks.next_block()? {
        let axes = axes(&block.name);
        let mut head: Option<Head> = None;
        let mut is_skipped = false;
        while let Some(record) = blocks.next_record()? {
            let Some(axes) = axes else { continue };
            match record.number {
                ..=2 => {}
                // The last record of a table is empty.
                _ if record.words.len() == 0 => {}
                number if number % 2 == 1 => {
                    head = Head::of(&record.words, (&block, axes), &mut collector)?;
                    is_skipped = head.is_none();
                }
                _ if is_skipped => {}
                _ => match &head {
                    Some(head) => head.read(&record.words, &mut collector)?,
                    None => {
                        return error(
                            place(&block),
                            "values come before an identification",
                            "write the file again, with PARAM,POST,-1",
                        );
                    }
                },
            }
        }
        if axes.is_none() {
            collector.skip(reason(&block.name), 1);
        }
        collector.end_section();
    }
    collector.set_complete(blocks.has_end());
    Ok(collector.finish())
}

/// Returns the axes of the vectors in a table; `None` if it has no motions of grid points.
fn axes(name: &str) -> Option<VectorAxes> {
    if OWN_AXES.contains(&name) {
        return Some(VectorAxes::Displacement);
    }
    BASIC.contains(&name).then_some(VectorAxes::Basic)
}

/// Returns why a table is skipped.
fn reason(name: &str) -> String {
    match name {
        "ROUGV1" | "ROUGV2" => format!("table {name} of motion relative to the base"),
        _ if name.starts_with("OUG") || name.starts_with("BOUG") || name.starts_with("BOPHIG") => {
            format!("table {name}")
        }
        _ => "table of other quantities".into(),
    }
}

fn place(block: &BlockName) -> String {
    format!("table {} at byte {}", block.name, block.at)
}

/// Identification of values.
struct Head {
    /// Vectors without values; those that are sorted by point have no frequency.
    vectors: GridVectors,
    /// Point of values that are sorted by point.
    point: Option<i64>,
    form: Form,
    /// Words of each entry.
    width: usize,
}

impl Head {
    /// Reads an identification; `None` if its values are skipped, with a reason.
    fn of(
        words: &Words<'_>,
        (block, axes): (&BlockName, VectorAxes),
        collector: &mut Collector,
    ) -> Result<Option<Head>> {
        let place = place(block);
        if words.len() < IDENTIFICATION {
            let message = format!("an identification has {} words instead of 146", words.len());
            return error(place, message, "write the file again, with PARAM,POST,-1");
        }
        // Words are numbered from 1 in the guide.
        let word = |number: usize| words.integer(number - 1);
        let (approach, table) = (word(1) / 10, word(2));
        let (sort, code) = (table / 1000, table % 1000);
        let motion = match code {
            1 | 7 => Motion::Displacement,
            10 => Motion::Velocity,
            11 => Motion::Acceleration,
            _ => {
                collector.skip(format!("result of the table code {table}"), 1);
                return Ok(None);
            }
        };
        if !(0..=3).contains(&sort) || word(23) != 0 {
            collector.skip(if word(23) != 0 { "temperatures" } else { "random results" }, 1);
            return Ok(None);
        }
        let is_by_point = sort >= 2;
        let (analysis, frequency) = match approach {
            2 if !is_by_point => (Analysis::Mode(word(5)), mode_frequency(words.real(5))),
            5 if is_by_point => (Analysis::Response, f64::NAN),
            5 => (Analysis::Response, words.real(4)),
            _ => {
                collector.skip(unsupported(approach, is_by_point), 1);
                return Ok(None);
            }
        };
        let width = word(10);
        let form = match (width, word(9)) {
            (8, _) => Form::Real,
            (14, 3) => Form::Polar,
            (14, _) => Form::Cartesian,
            _ => {
                let message = format!("entries have {width} words, which is neither 8 nor 14");
                return error(place, message, "export real or complex vectors of six components");
            }
        };
        if matches!(analysis, Analysis::Mode(_)) && !words.real(5).is_finite() {
            return error(place, "the eigenvalue is not finite", "write the file again, with PARAM,POST,-1");
        }
        Ok(Some(Head {
            vectors: GridVectors {
                place,
                subcase: word(4),
                analysis,
                motion,
                frequency,
                axes,
                values: Vec::new(),
            },
            point: is_by_point.then(|| word(5) / 10),
            form,
            width: width as usize,
        }))
    }

    /// Reads the values of this identification.
    fn read(&self, words: &Words<'_>, collector: &mut Collector) -> Result<()> {
        let count = words.len() / self.width;
        if count * self.width != words.len() {
            return error(
                self.vectors.place.clone(),
                format!("the values have {} words, and entries have {} words", words.len(), self.width),
                "write the file again, with PARAM,POST,-1",
            );
        }
        let starts = (0..count).map(|entry| entry * self.width);
        let is_grid = |start: &usize| words.integer(start + 1) == GRID;
        collector.skip("values of scalar points", starts.clone().filter(|start| !is_grid(start)).count());
        let vector = |start: usize| -> [c64; 3] {
            let second = |k: usize| if self.form == Form::Real { 0.0 } else { words.real(start + 8 + k) };
            [0, 1, 2].map(|k| self.form.value(words.real(start + 2 + k), second(k)))
        };
        let all = starts.filter(is_grid);
        match self.point {
            None => {
                let values = all.map(|start| (words.integer(start) / 10, vector(start))).collect();
                collector.add(GridVectors { values, ..self.vectors.clone() });
            }
            Some(point) => {
                let values: Vec<(f64, [c64; 3])> =
                    all.map(|start| (words.real(start), vector(start))).collect();
                collector.add_by_point(&self.vectors, point, &values);
            }
        }
        Ok(())
    }
}

/// Returns why results of an approach code are skipped.
fn unsupported(approach: i64, is_by_point: bool) -> String {
    match approach {
        1 => "static results".into(),
        2 if is_by_point => "normal modes sorted by point (SORT2)".into(),
        6 => "transient results".into(),
        8 => "buckling modes".into(),
        9 => "complex modes".into(),
        other => format!("results of the approach code {other}"),
    }
}
