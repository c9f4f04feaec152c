//! Queries that run after an edit, by the event log of the database. An edited text parses as if it
//! were new, and the work for a longer model grows in proportion to its length.

use super::*;
use crate::check::Checked;
use crate::span::FileId;
use std::cell::Cell;
use std::path::Path;
use std::sync::Mutex;

#[derive(Default)]
struct Modules {
    asked: Cell<usize>,
}

impl Loader for Modules {
    fn module(&self, path: &[String]) -> Option<(String, String)> {
        self.asked.set(self.asked.get() + 1);
        let content = match path.join(".").as_str() {
            "first" => "import second;\n",
            "second" => "function two() { return 2; }\n",
            _ => return None,
        };
        Some((format!("{}.cx", path.join("/")), content.into()))
    }

    fn prelude(&self) -> (String, String) {
        ("<library>/prelude.cx".into(), "/// Nothing yet.\n".into())
    }
}

/// Returns a database that records the queries it runs.
fn watched() -> (Database, Arc<Mutex<Vec<String>>>) {
    watched_with(&Modules::default())
}

fn watched_with(loader: &dyn Loader) -> (Database, Arc<Mutex<Vec<String>>>) {
    let log = Arc::new(Mutex::new(Vec::new()));
    let events = log.clone();
    let storage = salsa::Storage::new(Some(Box::new(move |event: salsa::Event| {
        if let salsa::EventKind::WillExecute { database_key } = event.kind {
            events.lock().unwrap().push(format!("{database_key:?}"));
        }
    })));
    (Database::with_storage(Storage { storage }, loader), log)
}

fn ran(log: &Mutex<Vec<String>>) -> Vec<String> {
    let name = |entry: String| entry.split('(').next().unwrap_or_default().to_string();
    std::mem::take(&mut *log.lock().unwrap()).into_iter().map(name).collect()
}

/// Returns how often each query ran since the last call, without queries that only look up names.
fn counts(log: &Mutex<Vec<String>>) -> String {
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for name in ran(log) {
        *counts.entry(name).or_default() += 1;
    }
    let shown = ["parts", "items", "check_group", "check_top", "check"];
    let shown = shown.iter().filter_map(|name| Some(format!("{name} {}", counts.get(*name)?)));
    shown.collect::<Vec<_>>().join(", ")
}

const MODEL: &str = "\
units inch_lbf_s;
param size = 2 inch;
function area(in w, in h) { return w*h; }
function square(in a) {
    // A comment.
    return area(a, a);
}
function even(in n) { if (n == 0) return TRUE; return odd(n - 1); }
function odd(in n) { if (n == 0) return FALSE; return even(n - 1); }
function sized() { return square(size); }
var x = sized();
print(x, even(3));
";

fn checked(db: &mut Database, text: &str) -> Arc<Checked> {
    db.set_model("a.cx", text);
    db.check("a.cx").unwrap()
}

/// Returns the result of a new database.
fn afresh(text: &str) -> Arc<Checked> {
    checked(&mut Database::new(&Modules::default()), text)
}

/// Asserts that diagnostics, program and locations equal those of a new check.
fn assert_afresh(found: &Checked, text: &str) {
    let fresh = afresh(text);
    assert_eq!(found.diagnostics, fresh.diagnostics);
    assert_eq!(found.types, fresh.types);
    let functions = |checked: &Checked| {
        let program = checked.program.as_ref();
        let mut all: Vec<String> = program.map_or(Vec::new(), |p| {
            p.functions.iter().map(|f| format!("{:?} {:?}", f.name, f.span)).collect()
        });
        all.sort();
        all
    };
    assert_eq!(functions(found), functions(&fresh));
}

#[test]
fn a_model_is_checked_by_unit() {
    let (mut db, log) = watched();
    let found = checked(&mut db, MODEL);
    assert_eq!(found.diagnostics, []);
    // `sized` uses a param and is checked with the top level; `even` and `odd` are one unit.
    assert_eq!(counts(&log), "parts 2, items 2, check_group 3, check_top 2, check 1");
}

#[test]
fn an_unchanged_text_runs_no_query() {
    let (mut db, log) = watched();
    let first = checked(&mut db, MODEL);
    db.parse("a.cx").unwrap();
    ran(&log);
    assert!(Arc::ptr_eq(&first, &checked(&mut db, MODEL)));
    db.parse("a.cx").unwrap();
    assert_eq!(ran(&log), Vec::<String>::new());
}

#[test]
fn an_edit_in_a_body_checks_that_body_only() {
    let (mut db, log) = watched();
    checked(&mut db, MODEL);
    ran(&log);
    for (old, new) in [
        // The scheme does not change.
        ("return w*h;", "var a = w*h; return a;"),
        ("// A comment.", "// Another comment, of another length,\n// on two lines."),
        ("return odd(n - 1)", "var m = n - 1; return odd(m)"),
    ] {
        let text = MODEL.replace(old, new);
        let found = checked(&mut db, &text);
        assert_eq!(counts(&log), "parts 1, items 1, check_group 1, check 1", "{new}");
        assert_afresh(&found, &text);
        checked(&mut db, MODEL);
        ran(&log);
    }
    let text = MODEL.replace("return square(size);", "return area(size, size);");
    let found = checked(&mut db, &text);
    assert_eq!(counts(&log), "parts 1, items 1, check_top 1, check 1");
    assert_afresh(&found, &text);
}

#[test]
fn an_edit_outside_of_items_checks_nothing() {
    let (mut db, log) = watched();
    checked(&mut db, MODEL);
    ran(&log);
    for text in [
        format!("// A comment above everything.\n\n{MODEL}"),
        MODEL.replace("function square", "/* between */\n\n   function square"),
        MODEL.replace("function square", "/// Documents it.\nfunction square"),
        MODEL.replace("print(x", "\n\n// before\nprint(x"),
    ] {
        let found = checked(&mut db, &text);
        assert_eq!(counts(&log), "parts 1, items 1, check 1");
        assert_afresh(&found, &text);
    }
}

#[test]
fn another_scheme_checks_its_callers() {
    let (mut db, log) = watched();
    checked(&mut db, MODEL);
    ran(&log);
    // `square` calls `area`; the scheme of `square`, which the top level uses, also changes.
    let text = MODEL.replace("return w*h;", "return w + h;");
    let found = checked(&mut db, &text);
    assert_eq!(counts(&log), "parts 1, items 1, check_group 2, check_top 1, check 1");
    assert_afresh(&found, &text);
}

#[test]
fn findings_move_with_their_place() {
    let (mut db, log) = watched();
    let text = MODEL.replace("return area(a, a);", "return area(a, b);");
    let found = checked(&mut db, &text);
    assert_eq!(found.diagnostics.len(), 1);
    ran(&log);
    let text = format!("// Above.\n{text}");
    let moved = checked(&mut db, &text);
    assert_eq!(counts(&log), "parts 1, items 1, check 1");
    let (before, after) = (found.diagnostics[0].primary.span, moved.diagnostics[0].primary.span);
    assert_eq!((after.start - before.start, after.end - before.end), (10, 10));
    assert_afresh(&moved, &text);
}

#[test]
fn a_literal_whose_dimension_a_caller_decides_is_checked_with_its_callers() {
    let (mut db, log) = watched();
    let text = "units inch_lbf_s;\nfunction gap() { return 3; }\nfunction twice() { return 2*gap(); }\n\
                var x = 1 inch + twice();\nprint(x);\n";
    let found = checked(&mut db, text);
    assert_eq!(found.diagnostics, []);
    assert_eq!(found.types["x"], "Length");
    ran(&log);
    checked(&mut db, &text.replace("2*gap()", "4*gap()"));
    assert_eq!(counts(&log), "parts 1, items 1, check_top 1, check 1");
}

#[test]
fn a_new_function_checks_itself_and_the_order_of_the_top_level() {
    let (mut db, log) = watched();
    checked(&mut db, MODEL);
    ran(&log);
    let text = MODEL.replace("function square", "function one() { return 1; }\nfunction square");
    let found = checked(&mut db, &text);
    assert_eq!(counts(&log), "parts 1, items 1, check_group 1, check_top 1, check 1");
    assert_afresh(&found, &text);
}

#[test]
fn a_missing_name_is_found_when_it_is_declared() {
    let (mut db, _) = watched();
    let text = "function f(in x) { return half(x); }\nprint(f(2));\n";
    assert_eq!(checked(&mut db, text).diagnostics[0].code, "E0201");
    let text = format!("{text}function half(in x) {{ return x/2; }}\n");
    assert_eq!(checked(&mut db, &text).diagnostics, []);
    assert_afresh(&checked(&mut db, &text), &text);
}

#[test]
fn an_edit_of_the_library_checks_what_it_concerns() {
    let (mut db, log) = watched();
    let loader = Modules::default();
    db.set_model("a.cx", "import second;\nfunction four(in x) { return x*second.two(); }\nprint(four(1));\n");
    db.load_imports("a.cx", &loader);
    assert_eq!(db.check("a.cx").unwrap().diagnostics, []);
    ran(&log);
    // Another model reuses the results of the library.
    db.set_model("b.cx", "import second;\nprint(second.two());\n");
    db.check("b.cx").unwrap();
    assert_eq!(counts(&log), "parts 1, items 1, check_top 1, check 1");
    db.set_module("second", "second.cx", "function two() { return 1 + 1; }\n");
    db.check("a.cx").unwrap();
    assert_eq!(counts(&log), "parts 1, items 1, check_group 1, check 1");
    db.set_module("second", "second.cx", "function two() { return 2 inch; }\n");
    db.check("a.cx").unwrap();
    assert_eq!(counts(&log), "parts 1, items 1, check_group 2, check_top 1, check 1");
}

#[test]
fn a_module_that_is_not_imported_does_not_concern_a_model() {
    let (mut db, log) = watched();
    checked(&mut db, MODEL);
    ran(&log);
    db.set_module("second", "second.cx", "function two() { return 2; }\n");
    db.check("a.cx").unwrap();
    // It is parsed for the dimensions it may declare, but not checked.
    assert_eq!(counts(&log), "parts 1, items 1");
}

#[test]
fn imports_are_loaded_once_and_through_others() {
    let (mut db, log) = watched();
    let loader = Modules::default();
    db.set_model("a.cx", "import first;\n");
    db.load_imports("a.cx", &loader);
    db.load_imports("a.cx", &loader);
    assert_eq!(loader.asked.get(), 2);
    let checked = db.check("a.cx").unwrap();
    let names: Vec<_> = checked.files.iter().map(|f| f.name.as_str()).collect();
    assert!(names.contains(&"first.cx") && names.contains(&"second.cx"), "{names:?}");
    ran(&log);
    assert!(db.check("unknown.cx").is_none());
}

#[path = "../../tests/support/generator.rs"]
mod generator;

/// The gear library.
#[derive(Default)]
struct Gears {
    is_sound: bool,
}

/// Returns the text of a module of the library.
fn of_library(module: &str) -> Option<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../stdlib-gears/calyx");
    std::fs::read_to_string(folder.join(module).with_extension("cx")).ok()
}

impl Loader for Gears {
    fn module(&self, path: &[String]) -> Option<(String, String)> {
        let [module] = path else { return None };
        Some((format!("<library>/{module}.cx"), of_library(module)?))
    }

    fn prelude(&self) -> (String, String) {
        ("<library>/prelude.cx".into(), of_library("prelude").expect("the prelude"))
    }

    fn is_sound(&self, _: &[String]) -> bool {
        self.is_sound
    }
}

fn check_generated(db: &mut Database, text: &str) -> Arc<Checked> {
    db.set_model("long.cx", text);
    db.load_imports("long.cx", &Gears::default());
    let found = db.check("long.cx").unwrap();
    assert_eq!(found.diagnostics, []);
    found
}

#[test]
fn a_longer_model_runs_queries_in_proportion_and_an_edit_the_same_few() {
    let mut groups = Vec::new();
    for sections in [1, 2, 3] {
        let (mut db, log) = watched_with(&Gears::default());
        let text = generator::model(20 + 48 * sections);
        check_generated(&mut db, &text);
        groups.push(ran(&log).iter().filter(|name| *name == "check_group").count());
        check_generated(&mut db, &generator::with_edited_body(&text));
        assert_eq!(counts(&log), "parts 1, items 1, check_group 1, check 1");
    }
    // Six functions per section, each checked on its own.
    assert_eq!([groups[1] - groups[0], groups[2] - groups[1]], [6, 6]);
}

/// A reproducible pseudo-random generator.
struct Random(u64);

impl Random {
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 33) as usize % end.max(1)
    }
}

#[test]
fn a_text_that_was_edited_parses_as_if_it_were_new() {
    const WRITTEN: [&str; 24] = [
        "{",
        "}",
        "(",
        ")",
        ";",
        "var x = 1;",
        "/// Says it.\n",
        "// note\n",
        "\n",
        "\n\n",
        "else ",
        "try ",
        "do ",
        "while ",
        "for (",
        "function f(in a) ",
        "\"",
        "{x}",
        "output ",
        "units SI;",
        "@",
        "/*",
        "return ",
        "µ",
    ];
    let mut random = Random(1);
    let mut db = Database::new(&Modules::default());
    let mut text = MODEL.to_string();
    for round in 0..1500 {
        if round % 100 == 0 {
            text = MODEL.to_string();
        }
        let boundary = |random: &mut Random| {
            let at = random.below(text.len() + 1);
            (at..=text.len()).find(|at| text.is_char_boundary(*at)).unwrap_or(0)
        };
        let start = boundary(&mut random);
        let end = if random.below(3) == 0 { boundary(&mut random).clamp(start, start + 20) } else { start };
        let end = (end..=text.len()).find(|at| text.is_char_boundary(*at)).unwrap_or(start);
        text.replace_range(start..end, WRITTEN[random.below(WRITTEN.len())]);
        db.set_model("a.cx", &text);
        let found = db.parse("a.cx").unwrap();
        let mut fresh = Database::new(&Modules::default());
        fresh.set_model("a.cx", &text);
        assert_eq!(found, fresh.parse("a.cx").unwrap(), "{text}");
        let (module, diagnostics) = crate::parser::parse(FileId(0), &text);
        assert_eq!((&found.module, &found.diagnostics), (&module, &diagnostics), "{text}");
    }
}

#[test]
fn another_database_can_be_asked_in_the_middle_of_an_attempt() {
    let (mut database, _) = watched();
    database.set_model("model.cx", "var a = 1;\nprint(a);\n");
    let errors = |database: &Database| database.check("model.cx").map(|checked| checked.diagnostics.len());
    let found = database.attempt(|database| {
        let before = errors(database);
        let mut trial = Database::new(&Modules::default());
        trial.set_model("model.cx", "import first;\nvar a = 1;\nprint(b);\n");
        trial.load_imports("model.cx", &Modules::default());
        (before, trial.aside(errors) > Some(0), errors(database) == before)
    });
    assert_eq!(found.ok(), Some((Some(0), true, true)));
}

/// A generated text may have thousands of equal statements. Each is a separate item with few links.
#[test]
fn statements_alike_need_few_others() {
    for line in
        ["var x = 1;\n", "x = 1;\n", "print(1);\n", "function x() { return x(); }\n", "record x { a = 1; }\n"]
    {
        let links_of = |lines: usize| {
            let mut db = Database::new(&Modules::default());
            db.set_model("m.cx", &line.repeat(lines));
            let text = db.models["m.cx"];
            let all = items::items(&db.salsa, text);
            let apart: BTreeSet<_> =
                all.iter().map(|item| (item.name(&db.salsa).clone(), item.number(&db.salsa))).collect();
            assert_eq!((all.len(), apart.len()), (lines, lines), "{line}");
            all.iter().map(|item| groups::links(&db.salsa, *item, db.library).len()).sum::<usize>()
        };
        assert!(links_of(200) <= 2 * links_of(100) + 2, "{line}");
    }
}

#[test]
fn a_model_checks_only_the_functions_of_sound_modules_that_it_uses() {
    let check = |text: &str, is_sound: bool| {
        let gears = Gears { is_sound };
        let (mut db, log) = watched_with(&gears);
        db.set_model("short.cx", text);
        db.load_imports("short.cx", &gears);
        let found = db.check("short.cx").unwrap();
        assert_eq!(found.diagnostics, []);
        let number = ran(&log).iter().filter(|name| ["check_group", "check_top"].contains(&&***name)).count();
        (found.program.as_ref().map(|program| format!("{program:?}")), number)
    };
    let texts = [
        ("import gears;\nvar _steel = gears.material(206 GPa, 0.3);\n", 10),
        ("import iso21771;\nprint(iso21771.involute(0.3));\n", 15),
        // A function whose literals are checked with their uses.
        ("import agma2101;\nprint(agma2101.reliability_factor(0.99));\n", 400),
    ];
    for (text, most) in texts {
        let ((all, of_library), (some, of_model)) = (check(text, false), check(text, true));
        assert!(all.is_some() && all == some, "{text}");
        assert!(of_library > 50 && of_model < most, "{of_library}, {of_model}: {text}");
    }
}

/// The library is loaded as sound, so a model does not report its errors and warnings.
#[test]
fn the_library_has_no_errors_and_warnings() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../stdlib-gears/calyx");
    let files = std::fs::read_dir(folder).expect("the library").flatten();
    let modules: Vec<String> =
        files.filter_map(|file| Some(file.file_name().to_str()?.strip_suffix(".cx")?.to_owned())).collect();
    assert!(modules.len() > 10);
    let imports = modules.iter().filter(|module| *module != "prelude");
    let imports: Vec<String> = imports.map(|module| format!("import {module};\n")).collect();
    let mut db = Database::new(&Gears::default());
    db.set_model("all.cx", &imports.concat());
    db.load_imports("all.cx", &Gears::default());
    assert_eq!(db.check("all.cx").unwrap().diagnostics, []);
}
