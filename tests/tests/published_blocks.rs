//! Compares the data blocks of gears that are stated by the arguments of `gears.external` and
//! `gears.internal` with published digits. The table is `tests/gear_data/published.txt`, which
//! describes its format.

use crate::models::engine;
use calyx::Module;
use calyx::rt::{RunOptions, run};
use calyx_tests::root;
use serde_json::Value;
use std::fmt::Write;

/// Published number: where it belongs, its key in `run.json` and its digits.
struct Published<'t> {
    of: &'t str,
    key: &'t str,
    digits: &'t str,
}

/// Block of the table.
#[derive(Default)]
struct Block<'t> {
    name: &'t str,
    has_source: bool,
    units: Option<&'t str>,
    gears: [Option<&'t str>; 2],
    distance: Option<&'t str>,
    numbers: Vec<Published<'t>>,
    /// Expressions of the library with their digits.
    values: Vec<(&'t str, &'t str)>,
    /// Published numbers that the library does not reproduce.
    differing: Vec<Published<'t>>,
}

fn blocks(table: &str) -> Vec<Block<'_>> {
    let mut blocks: Vec<Block> = Vec::new();
    for line in table.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#')) {
        let (word, rest) = line.split_once(' ').unwrap_or_else(|| panic!("one word: {line}"));
        if word == "block" {
            blocks.push(Block { name: rest, ..Block::default() });
            continue;
        }
        let block = blocks.last_mut().unwrap_or_else(|| panic!("before the first block: {line}"));
        match word {
            "source" => block.has_source = true,
            "units" => block.units = Some(rest),
            "distance" => block.distance = Some(rest),
            "value" => {
                block.values.push(rest.rsplit_once(" = ").unwrap_or_else(|| panic!("no digits: {line}")));
            }
            "differs" => {
                let [of, key, digits, reason] = rest.splitn(4, ' ').collect::<Vec<_>>()[..] else {
                    panic!("{line}")
                };
                assert!(reason.len() > 20, "a reason: {line}");
                block.differing.push(Published { of, key, digits });
            }
            "first" | "second" if rest.starts_with("gears.") => {
                block.gears[usize::from(word == "second")] = Some(rest);
            }
            "first" | "second" | "pair" | "pair.first" | "pair.second" => {
                for number in rest.split("; ") {
                    let (key, digits) =
                        number.rsplit_once(' ').unwrap_or_else(|| panic!("no digits: {line}"));
                    block.numbers.push(Published { of: word, key, digits });
                }
            }
            _ => panic!("not an entry: {line}"),
        }
    }
    blocks
}

impl Block<'_> {
    /// Model of the gears, with an output per expression.
    fn model(&self) -> String {
        let mut text = format!("import gears;\nunits {};\n", self.units.unwrap_or("mm_N_s"));
        for (name, call) in ["first", "second"].into_iter().zip(self.gears) {
            if let Some(call) = call {
                writeln!(text, "var {name} = {call};").expect("text");
            }
        }
        if let Some(distance) = self.distance {
            writeln!(text, "gears.pair(first, second, center_distance = {distance}, torque = 1 N*m);")
                .expect("text");
        }
        for (index, (expression, _)) in self.values.iter().enumerate() {
            writeln!(text, "output value_{index} := {expression};").expect("text");
        }
        text + "output one := 1;\n"
    }

    /// Data of gears and mesh that a published number belongs to.
    fn data<'d>(&self, gear_data: &'d Value, of: &str) -> &'d Value {
        let mesh = &gear_data["meshes"][0];
        match of {
            "first" => &gear_data["gears"][0]["data"],
            "second" => &gear_data["gears"][1]["data"],
            "pair" => &mesh["data"],
            "pair.first" => &mesh["members"][0],
            "pair.second" => &mesh["members"][1],
            _ => panic!("{}: no data of {of}", self.name),
        }
    }
}

/// Value of an entry in millimetres, inches or degrees.
fn shown(entry: &Value, what: &str) -> f64 {
    let value = entry["value"].as_f64().unwrap_or_else(|| panic!("{what}: no number in {entry}"));
    let unit = entry["display"]["unit"].as_str().unwrap_or_default();
    match unit {
        "" => value,
        "mm" => value / 1e-3,
        "inch" => value / 0.0254,
        "deg" => value.to_degrees(),
        other => panic!("{what}: unit {other}"),
    }
}

/// Returns true if a value has these digits: it differs by at most half a unit of the last one,
/// with a margin for the rounding of the printing program.
fn has_digits(value: f64, digits: &str, what: &str) -> bool {
    let published: f64 = digits.parse().unwrap_or_else(|_| panic!("{what}: {digits} is not a number"));
    let decimals = digits.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    (value - published).abs() <= 0.5001 * 10_f64.powi(-i32::try_from(decimals).expect("few digits"))
}

#[test]
fn gears_stated_by_arguments_have_their_published_digits() {
    let table = std::fs::read_to_string(root().join("tests/gear_data/published.txt")).expect("the table");
    let blocks = blocks(&table);
    let mut wrong = String::new();
    let (mut gears, mut compared) = (0, 0);
    for block in &blocks {
        let name = block.name;
        assert!(block.has_source, "{name}: no source");
        let text = block.model();
        let module = Module::from_text(&engine(), "block.cx", &text)
            .unwrap_or_else(|error| panic!("{name}: {error}\n{text}"));
        let directory = tempfile::tempdir().expect("a directory");
        let options =
            RunOptions { directory: directory.path().join("run"), quiet: true, ..RunOptions::default() };
        run(module.as_program().clone(), &options).unwrap_or_else(|error| panic!("{name}: {error:?}"));
        let run = std::fs::read_to_string(directory.path().join("run/run.json")).expect("run.json");
        let run: Value = serde_json::from_str(&run).expect("JSON");
        gears += run["gear_data"]["gears"].as_array().map_or(0, Vec::len);
        for number in &block.numbers {
            let what = format!("{name}: {} {}", number.of, number.key);
            let value = shown(&block.data(&run["gear_data"], number.of)[number.key], &what);
            compared += 1;
            if !has_digits(value, number.digits, &what) {
                writeln!(wrong, "{what}: {value} is not {}", number.digits).expect("text");
            }
        }
        for number in &block.differing {
            let what = format!("{name}: {} {}", number.of, number.key);
            let value = shown(&block.data(&run["gear_data"], number.of)[number.key], &what);
            if has_digits(value, number.digits, &what) {
                writeln!(wrong, "{what}: {value} does not differ").expect("text");
            }
        }
        for (index, (expression, digits)) in block.values.iter().enumerate() {
            let output = &run["outputs"][&format!("value_{index}")];
            let value = output["max"].as_f64().unwrap_or_else(|| panic!("{name}: {output}"));
            compared += 1;
            if !has_digits(value, digits, name) {
                writeln!(wrong, "{name}: {expression} is {value}, not {digits}").expect("text");
            }
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
    assert!(blocks.len() >= 10 && gears >= 20, "{} blocks, {gears} gears", blocks.len());
    assert!(compared >= 150, "{compared} numbers");
    println!("{} blocks, {gears} gears, {compared} numbers", blocks.len());
}
