//! Files with random errors: a reader returns a body or an error, and ends soon.

use super::files::{Files, open_in, read};
use super::formats::{gmsh_binary, gmsh_options};
use calyx_elastic::import::{
    AbaqusOptions, CondensedOptions, NastranOptions, Units, read_abaqus, read_condensed, read_gmsh,
    read_nastran,
};

/// Linear congruential generator of Knuth (MMIX).
struct Random(u64);

impl Random {
    fn below(&mut self, limit: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % limit.max(1)
    }
}

/// Pieces that decks are sensitive to.
const PIECES: [&[u8]; 20] = [
    b"*",
    b"+",
    b",",
    b"\n",
    b"$",
    b"\t",
    b" ",
    b"THRU",
    b"INCLUDE 'main'\n",
    b"-",
    b"1.-5",
    b"9999999999999999999",
    b"0",
    b"BEGIN BULK\n",
    b"ENDDATA\n",
    b"\0",
    b"\xff",
    b"1E308",
    b"GRID",
    b"*INCLUDE, INPUT=main\n",
];

fn edited(content: &[u8], random: &mut Random) -> Vec<u8> {
    let mut content = content.to_vec();
    for _ in 0..=random.below(4) {
        let at = random.below(content.len() + 1);
        match random.below(5) {
            0 => content.truncate(at),
            1 => drop(content.drain(at..(at + random.below(40)).min(content.len()))),
            2 => {
                let piece = PIECES[random.below(PIECES.len())];
                content.splice(at..at, piece.iter().copied());
            }
            3 => {
                let from = random.below(content.len() + 1);
                let copied = content[from..(from + random.below(80)).min(content.len())].to_vec();
                content.splice(at..at, copied);
            }
            _ => {
                if let Some(byte) = content.get_mut(at) {
                    *byte = random.below(256) as u8;
                }
            }
        }
    }
    content
}

fn read_as(kind: &str, files: &Files) -> Result<(), String> {
    let mut open = open_in(files);
    let text = |error: calyx_elastic::import::ImportError| {
        assert!(error.line > 0 && !error.message.is_empty() && !error.help.is_empty(), "{error:?}");
        error.to_string()
    };
    let units = Units::N_MM_S;
    match kind {
        "bdf" => read_nastran("main", &NastranOptions { units, subcase: None }, &mut open).map(drop),
        "inp" => read_abaqus("main", &AbaqusOptions { units }, &mut open).map(drop),
        "msh" => read_gmsh("main", &gmsh_options(), &mut open).map(drop),
        _ => {
            let options = CondensedOptions { units, stiffness: None, mass: None };
            read_condensed(&format!("main.{kind}"), &options, &mut open).map(drop)
        }
    }
    .map_err(text)
}

fn check(kind: &str, content: &[u8], count: usize) {
    let name = if matches!(kind, "pch" | "csv" | "npz") { format!("main.{kind}") } else { "main".into() };
    let valid = Files::from([(name.clone(), content.to_vec())]);
    assert_eq!(read_as(kind, &valid), Ok(()));
    let mut random = Random(1);
    let mut rejected = 0;
    for _ in 0..count {
        let files = Files::from([(name.clone(), edited(content, &mut random))]);
        rejected += usize::from(read_as(kind, &files).is_err());
    }
    assert!(rejected > count / 4 && rejected < count, "{rejected} of {count} are rejected");
}

#[test]
fn edited_files_never_panic() {
    check("bdf", &read("import/bracket.bdf"), 4000);
    check("inp", &read("import/bracket.inp"), 4000);
    check("msh", &gmsh_binary(false), 2000);
    check("msh", &read("import/plate.msh"), 2000);
    check("pch", &read("import/condensed.pch"), 2000);
    check("csv", &read("import/condensed.csv"), 2000);
    check("npz", &read("import/condensed.npz"), 2000);
}

#[test]
fn random_bytes_are_rejected() {
    let mut random = Random(7);
    for _ in 0..500 {
        let length = random.below(400);
        let content: Vec<u8> = (0..length).map(|_| random.below(256) as u8).collect();
        for kind in ["bdf", "inp", "msh", "pch", "csv", "npz"] {
            let names = ["main".to_owned(), format!("main.{kind}")];
            let files = Files::from(names.map(|name| (name, content.clone())));
            assert!(read_as(kind, &files).is_err(), "{kind}: {content:?}");
        }
    }
}

#[test]
fn short_files_cannot_state_unlimited_work() {
    let grids: String = (1..=500).map(|label| format!("GRID,{label},,{label}.\n")).collect();
    let supports = "SPC1,1,1,1,THRU,99999999\n".repeat(3000);
    let nodes: String = (1..=500).map(|label| format!("{label}, {label}.\n")).collect();
    let sets = "ALL, ALL, ALL, ALL\n".repeat(1000);
    let element =
        "*ELEMENT, TYPE=B31, ELSET=E\n1, 1, 2\n*BEAM SECTION, ELSET=E, SECTION=CIRC, MATERIAL=M\n1.\n";
    let material = "*MATERIAL, NAME=M\n*ELASTIC\n1., 0.\n";
    for (kind, text, words) in [
        ("bdf", format!("{grids}{supports}CONM2,1,1,,1.\n"), "stated too often"),
        ("inp", format!("*NODE, NSET=ALL\n{nodes}*NSET, NSET=X\n{sets}{element}{material}"), "too often"),
        ("bdf", format!("INCLUDE 'main'\n{grids}"), "includes itself"),
    ] {
        let files = Files::from([("main".to_owned(), text.into_bytes())]);
        let error = read_as(kind, &files).expect_err("the work is limited");
        assert!(error.contains(words), "{error}");
    }
}

#[test]
fn units_must_be_positive() {
    let files = Files::from([("main".to_owned(), read("import/bracket.bdf"))]);
    for units in [Units { length: 0.0, ..Units::N_M_S }, Units { time: f64::NAN, ..Units::N_M_S }] {
        let options = NastranOptions { units, subcase: None };
        let error = read_nastran("main", &options, &mut open_in(&files)).expect_err("not valid");
        assert!(error.message.contains("units"), "{error}");
    }
    for name in Units::NAMES {
        assert!(Units::named(name).is_some_and(|units| units.is_valid()), "{name}");
    }
    assert_eq!(Units::named("N-mm-s").map(|units| units.mass()), Some(1000.0));
    assert_eq!(Units::named("kg"), None);
}
