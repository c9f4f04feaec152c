//! Cases of `tests/data/import/*.md`.
//!
//! A case is a section with fenced blocks. The info string of the first one names the format and
//! its options: `nastran UNITS SUBCASE`, `abaqus UNITS`, `gmsh LENGTH PARTS`, `csv UNITS`, `pch
//! UNITS STIFFNESS MASS`. A block `file NAME` is an included file. The last block is `model`, the
//! text of the body, or `error`. With CALYX_BLESS=1, the test writes the last block of each case.

use super::files::{Files, data, open_in};
use super::summary::{condensed, summary};
use calyx_elastic::import::{
    AbaqusOptions, CondensedOptions, GmshOptions, GmshPart, ImportError, NastranOptions, Units, read_abaqus,
    read_condensed, read_gmsh, read_nastran,
};
use calyx_elastic::model::Material;

/// Fenced block of a case: info string, text, range of lines of the text in the page.
struct Block {
    info: String,
    text: String,
    lines: std::ops::Range<usize>,
}

fn blocks(page: &str) -> Vec<Block> {
    let mut blocks = Vec::new();
    let mut open: Option<(String, usize)> = None;
    let lines: Vec<&str> = page.lines().collect();
    for (at, line) in lines.iter().enumerate() {
        match (&open, line.strip_prefix("```")) {
            (None, Some(info)) => open = Some((info.trim().to_owned(), at + 1)),
            (Some((info, start)), Some(_)) => {
                let text = lines[*start..at].iter().map(|line| format!("{line}\n")).collect();
                blocks.push(Block { info: info.clone(), text, lines: *start..at });
                open = None;
            }
            _ => {}
        }
    }
    blocks
}

fn units(name: &str) -> Units {
    Units::named(name).unwrap_or(Units::N_M_S)
}

/// Reads a body in the format that an info string states.
pub fn import(info: &str, files: &Files) -> Result<String, ImportError> {
    let mut words = info.split_whitespace();
    let format = words.next().unwrap_or_default();
    let option = words.next().unwrap_or_default();
    let mut open = open_in(files);
    match format {
        "nastran" => {
            let subcase = words.next().and_then(|word| word.parse().ok());
            let options = NastranOptions { units: units(option), subcase };
            read_nastran("main", &options, &mut open).map(|import| summary(&import))
        }
        "abaqus" => {
            let options = AbaqusOptions { units: units(option) };
            read_abaqus("main", &options, &mut open).map(|import| summary(&import))
        }
        "gmsh" => {
            let parts = words.map(part).collect();
            let options = GmshOptions { length: option.parse().expect("a length"), parts };
            read_gmsh("main", &options, &mut open).map(|import| summary(&import))
        }
        "csv" | "pch" => {
            let names: Vec<&str> = words.collect();
            let name = |at: usize| names.get(at).map(|name| (*name).to_owned());
            let options = CondensedOptions { units: units(option), stiffness: name(0), mass: name(1) };
            let path = format!("main.{format}");
            let content = files["main"].clone();
            read_condensed(&path, &options, &mut |_| Ok(content.clone())).map(|body| condensed(&body))
        }
        _ => panic!("`{format}` is not a format"),
    }
}

/// Part of a mesh from `NAME` or `NAME:THICKNESS`; `*` is all elements.
fn part(text: &str) -> GmshPart {
    let (name, thickness) = text.split_once(':').unwrap_or((text, ""));
    let material = Material {
        youngs_modulus: 2e11,
        poissons_ratio: 0.25,
        shear_modulus: 8e10,
        density: 8000.0,
        structural_damping: 0.0,
    };
    GmshPart { physical: (name != "*").then(|| name.to_owned()), material, thickness: thickness.parse().ok() }
}

fn outcome(info: &str, files: &Files) -> (&'static str, String) {
    match import(info, files) {
        Ok(text) => ("model", text),
        Err(error) => ("error", format!("{error}\nhelp: {}\n", error.help)),
    }
}

fn check(name: &str) {
    let path = data(name);
    let page = std::fs::read_to_string(&path).expect("the page exists");
    let mut blessed: Vec<String> = page.lines().map(str::to_owned).collect();
    let all = blocks(&page);
    let (mut failures, mut count) = (Vec::new(), 0);
    let mut end = all.len();
    // Backwards, so that line numbers of earlier blocks stay valid.
    while end > 0 {
        let expected = &all[end - 1];
        let first = all[..end - 1].iter().rposition(|block| !block.info.starts_with("file "));
        let first = first.expect("a case begins with a model");
        let mut files = Files::from([("main".to_owned(), all[first].text.clone().into_bytes())]);
        for block in &all[first + 1..end - 1] {
            files.insert(block.info["file ".len()..].trim().to_owned(), block.text.clone().into_bytes());
        }
        let (kind, text) = outcome(&all[first].info, &files);
        count += 1;
        if (kind, text.as_str()) != (expected.info.as_str(), expected.text.as_str()) {
            failures.push(format!("{name}:{}:\n{kind}\n{text}", expected.lines.start));
            let replacement = text.lines().map(str::to_owned);
            blessed.splice(expected.lines.clone(), replacement);
            blessed[expected.lines.start - 1] = format!("```{kind}");
        }
        end = first;
    }
    assert!(count > 0, "{name} has no cases");
    if std::env::var_os("CALYX_BLESS").is_some() {
        std::fs::write(&path, blessed.join("\n") + "\n").expect("the page can be written");
    } else {
        failures.reverse();
        assert!(failures.is_empty(), "{}", failures.join("\n"));
    }
}

#[test]
fn nastran_cards() {
    check("import/nastran.md");
}

#[test]
fn nastran_errors() {
    check("import/nastran_errors.md");
}

#[test]
fn abaqus_keywords() {
    check("import/abaqus.md");
}

#[test]
fn gmsh_meshes() {
    check("import/gmsh.md");
}

#[test]
fn condensed_bodies() {
    check("import/condensed.md");
}
