//! Tests editor queries over the examples and the library: names are found, their declarations are
//! correct, and they are visible.

use crate::library::{Library, folder, improper};
use calyx_lang::analysis::{Name, NameKind, SourceRange};
use calyx_lang::db::Database;
use calyx_lang::lexer::Kind;
use std::fs;
use std::path::{Path, PathBuf};

fn models(below: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(below).expect("examples").flatten() {
        let path = entry.path();
        if path.is_dir() {
            models(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "cx") {
            found.push(path);
        }
    }
}

fn examples() -> Vec<(String, Database)> {
    let mut paths = Vec::new();
    models(&folder("../examples"), &mut paths);
    let loader = Library::read();
    let load = |path: &PathBuf| {
        let (name, text) = (path.display().to_string(), fs::read_to_string(path).expect("a model"));
        (name.clone(), database(&name, &text, &loader))
    };
    let all: Vec<(String, Database)> = paths.iter().map(load).collect();
    for (name, database) in &all {
        let found = &database.check(name).expect("checked").diagnostics;
        assert_eq!(improper(found, database.text(name).expect("a text")), None, "{name}");
    }
    all
}

fn database(name: &str, text: &str, loader: &Library) -> Database {
    let mut database = Database::new(loader);
    database.set_model(name, text);
    database.load_imports(name, loader);
    database
}

fn of(text: &str) -> Database {
    database("a.cx", text, &Library::read())
}

fn at(text: &str, mark: &str) -> u32 {
    text.find(mark).unwrap_or_else(|| panic!("{mark}")) as u32
}

#[test]
fn every_identifier_of_the_examples_is_known() {
    for (file, database) in examples() {
        for file in database.files().iter().map(|file| &**file).chain([file.as_str()]) {
            let text = database.text(file).expect("a text");
            let names = database.names(file);
            for token in &database.tokens(file).expect("tokens").tokens {
                let word = &text[token.span.start as usize..token.span.end as usize];
                let known = names.binary_search_by_key(&token.span.start, |name| name.start).is_ok();
                // Built-in types, unit systems, `none`, `not`, `as` and the keywords of `extern`
                // are not names of the program.
                let own = |word: &str| {
                    word.starts_with(char::is_uppercase)
                        || word.contains("_s")
                        || ["pure", "none", "not", "as"].contains(&word)
                };
                // Nor is the frame of a body, a member of an opaque type.
                let of_body = word == "frame" && text[..token.span.start as usize].ends_with('.');
                // Nor is a field of a parameter without a type: the functions of this module take
                // every record that has the fields.
                let of_any_record = file.ends_with("gear_train_equations.cx")
                    && text[..token.span.start as usize].ends_with('.');
                let of_extern = matches!(word, "scene" | "effect" | "SI");
                // A former name is not a name of the program.
                let former = word == "was" || text[..token.span.start as usize].ends_with(" was ");
                // `import module as name` declares the second name only.
                let renamed = text[..token.span.start as usize].ends_with("import ")
                    && text[token.span.end as usize..].starts_with(" as ");
                if token.kind == Kind::Identifier
                    && !own(word)
                    && !of_extern
                    && !former
                    && !renamed
                    && !of_body
                    && !of_any_record
                {
                    assert!(known, "{file}: `{word}` at {}", token.span.start);
                }
            }
            for pair in names.windows(2) {
                assert!(pair[0].end <= pair[1].start, "{file}: {pair:?}");
            }
        }
    }
}

#[test]
fn names_are_declared_where_they_say_and_found_from_there() {
    for (file, database) in examples() {
        for name in database.names(&file) {
            let Some(place) = &name.declared else { continue };
            let target = database.text(&place.file).expect("a text");
            if name.kind == NameKind::Module {
                continue;
            }
            assert_eq!(&target[place.start as usize..place.end as usize], &*name.text, "{name:?}");
            let itself = database.name_at(&place.file, place.start).expect("a name");
            assert!(itself.declares, "{itself:?}");
            // A component declares its members as params, outputs and variables of its body. Its
            // instances are values, so that in `stage.torque` the member is a field.
            let member = name.kind == NameKind::Field && itself.kind != NameKind::Field;
            if member {
                const MEMBERS: [NameKind; 5] = [
                    NameKind::Parameter,
                    NameKind::Param,
                    NameKind::Output,
                    NameKind::Variable,
                    NameKind::Symbolic,
                ];
                assert!(MEMBERS.contains(&itself.kind), "{name:?} {itself:?}");
            } else {
                assert_eq!(itself.kind, name.kind, "{name:?}");
            }
            // Within its component, the value of an output is an expression of a number. A field of
            // an instance has a value that programs can store and pass on: an observable.
            let ty = match (member, itself.kind, &itself.ty) {
                (true, NameKind::Output, Some(ty)) => Some(format!("Observable({ty})").into()),
                (.., ty) => ty.clone(),
            };
            assert_eq!(name.ty, ty, "{name:?}");
            let found = database.references(place);
            assert!(found.iter().any(|(of, found)| **of == *file && *found == name), "{name:?}");
            assert!(found.iter().any(|(_, found)| found.declares), "{name:?}");
            let declaration = database.declaration(place).unwrap_or_else(|| panic!("{name:?}"));
            assert_eq!(declaration.kind, itself.kind);
            assert!(declaration.header.contains(&*name.text), "{declaration:?}");
        }
    }
}

#[test]
fn every_name_is_seen_where_it_is_used() {
    for (file, database) in examples() {
        for name in database.names(&file) {
            let part = matches!(name.kind, NameKind::Field | NameKind::Unit | NameKind::Dimension);
            let elsewhere = name
                .declared
                .as_ref()
                .is_some_and(|place| *place.file != *file && !place.file.ends_with("prelude.cx"));
            // An argument's name belongs to the call.
            let argument = name.kind == NameKind::Parameter
                && database.text(&file).is_some_and(|text| {
                    let rest = text[name.end as usize..].trim_start();
                    rest.starts_with('=') || rest.starts_with(":=")
                });
            // A word of the language without a declaration.
            let none = &*name.text == "none" && name.declared.is_none();
            if part || elsewhere || argument || none || name.declares {
                continue;
            }
            let seen = database.visible(&file, name.start);
            // The cached result for an unchanged text must be the same.
            let noted = database.seen(&file, name.start);
            let other = seen.iter().zip(&noted).find(|(seen, noted)| seen != noted);
            assert_eq!(other, None, "{file}: at {name:?}");
            let found = seen.iter().find(|visible| visible.name == name.text);
            let found = found.unwrap_or_else(|| panic!("{file}: {name:?} is not seen"));
            assert_eq!(
                (found.kind, &found.declared, &found.ty),
                (name.kind, &name.declared, &name.ty),
                "{file}: {name:?}"
            );
        }
    }
}

#[test]
fn calls_of_the_library_are_described() {
    let database =
        of("import gears;\nvar m = gears.material(youngs_modulus = 206 GPa, poissons_ratio = 0.3);\n");
    let members = database.members("gears");
    assert!(members.len() > 10);
    for member in &members {
        let place = member.declared.clone().expect("a place");
        if member.kind == NameKind::Extern {
            let callable = database.callable(&place).expect("callable");
            // Functions that only add to the model have no result.
            assert!(callable.doc.is_some(), "{callable:?}");
            // Observables are documented by their names.
            let several = callable.parameters.len() > 1;
            for parameter in &callable.parameters {
                let plain = ["mesh", "body", "gauge", "bearing", "shaft"].contains(&&*parameter.name)
                    || !parameter.choices.is_empty();
                let is_documented = !several || parameter.doc.is_some() || plain;
                assert!(is_documented && !parameter.ty.is_empty(), "{} {parameter:?}", callable.name);
            }
        }
    }
    let text = database.text("a.cx").expect("a text");
    let name = database.name_at("a.cx", at(text, "youngs")).expect("an argument");
    assert_eq!((name.kind, name.ty.as_deref()), (NameKind::Parameter, Some("Pressure")));
    let typed = database.expression_at("a.cx", at(text, "206")).expect("a number");
    assert_eq!((typed.ty.as_str(), typed.bare), ("Pressure", false));
}

#[test]
fn functions_records_and_fields() {
    let text = "\
units mm_N_s;
/// A plate.
record Plate {
    /// How thick.
    thickness = 3 mm;
    label: String;
}
/// Adds.
function sum(in a, in b = 2 mm) { var total = a + b; return total; }
var p = Plate(label = \"x\");
p.thickness = 5;
print(sum(p.thickness), p.label);
";
    let database = of(text);
    assert_eq!(database.check("a.cx").expect("checked").diagnostics, []);
    let name = |mark: &str| database.name_at("a.cx", at(text, mark)).unwrap_or_else(|| panic!("{mark}"));
    let field = name("thickness = 5");
    assert!(field.writes || name("p.thickness = 5").writes);
    assert_eq!((field.kind, field.ty.as_deref()), (NameKind::Field, Some("Length")));
    assert_eq!(name("label = \"x").declared, name("label: String").declared);
    let sum = name("sum(p").declared.expect("a place");
    let callable = database.callable(&sum).expect("callable");
    assert_eq!(callable.doc.as_deref(), Some("Adds."));
    assert_eq!(callable.result.as_deref(), Some("Length"));
    let parameters: Vec<_> =
        callable.parameters.iter().map(|p| (&*p.name, p.ty.as_str(), p.default.as_deref())).collect();
    assert_eq!(parameters, [("a", "Length", None), ("b", "Length", Some("2 mm"))]);
    let record = database.callable(&name("Plate(").declared.expect("a place")).expect("callable");
    assert_eq!(record.parameters[0].doc.as_deref(), Some("How thick."));
    assert_eq!(record.parameters[1].ty, "String");
    let bare = database.expression_at("a.cx", at(text, "5;")).expect("a number");
    assert!(bare.bare && bare.ty == "Length");
    assert_eq!(database.declaration(&sum).expect("declared").header, "function sum(in a, in b = 2 mm)");
}

/// The variable of a comprehension is visible in its element and its condition, that of a loop in
/// its body, and neither in the values.
#[test]
fn variables_of_elements_have_scopes() {
    let text = "var xs = [1, 2]; var x = 3;
var doubled = [first + 2*x for x in [here for y in xs] if x > 1 + second];
for (z in [third]) { print(fourth); }
print(fifth);";
    let database = of(text);
    let seen = |mark: &str| {
        let visible = database.visible("a.cx", at(text, mark)).into_iter();
        let own = visible.filter(|name| ["x", "y", "z"].contains(&&*name.name));
        own.map(|name| (name.name.to_string(), name.declared.expect("a place").start)).collect::<Vec<_>>()
    };
    let [outer, x, y, z] =
        ["x = 3", "x in", "y in", "z in"].map(|mark| (mark[..1].to_owned(), at(text, mark)));
    assert_eq!(seen("first"), std::slice::from_ref(&x));
    assert_eq!(seen("here"), [y, outer.clone()]);
    assert_eq!(seen("second"), [x]);
    assert_eq!(seen("third"), std::slice::from_ref(&outer));
    assert_eq!(seen("fourth"), [z, outer.clone()]);
    assert_eq!(seen("fifth"), [outer]);
    for mark in ["x in", "z in"] {
        let place = at(text, mark);
        let place = SourceRange { file: "a.cx".into(), start: place, end: place + 1 };
        let declared = database.declaration(&place).expect("declared");
        assert!(declared.header.starts_with(&format!("for {mark} [")), "{declared:?}");
    }
}

#[test]
fn broken_texts_have_scopes() {
    let text = "var size = 2;\nfunction f(in width, out depth) {\n  var half = width/2;\n  for (var i = 0; i < 3; i = i + 1) {\n    var here = ha";
    let names: Vec<String> = of(text)
        .visible("a.cx", text.len() as u32)
        .iter()
        .take(6)
        .map(|v| format!("{} {:?}", v.name, v.level))
        .collect();
    assert_eq!(
        names,
        ["i Some(0)", "half Some(1)", "depth Some(1)", "width Some(1)", "f Some(2)", "size Some(2)"]
    );
}

#[test]
fn references_cross_files() {
    let text = "import gears;\nvar a = gears.rack(module = 2 mm, tip_radius = 0.5 mm);\nvar b = gears.rack(module = 3 mm, tip_radius = 0.5 mm);\nprint(1);\n";
    let database = of(text);
    let rack = database.name_at("a.cx", at(text, "rack")).and_then(|name| name.declared).expect("a place");
    let found: Vec<(String, Name)> =
        database.references(&rack).into_iter().map(|(file, name)| (file.to_string(), name)).collect();
    assert_eq!(found.iter().filter(|(file, _)| file == "a.cx").count(), 2);
    assert!(found.iter().any(|(file, name)| file.ends_with("gears.cx") && name.declares));
    let module = SourceRange { file: rack.file, start: 0, end: 0 };
    assert_eq!(database.references(&module).len(), 3);
}
