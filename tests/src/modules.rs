//! Dependency graph of the modules of a crate, read from its source.
//!
//! The graph contains paths of `use` declarations and of expressions. Re-exports of a parent are
//! resolved to the child that defines the item. Tests are ignored.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// Path of a module from the root of the crate.
type Module = Vec<String>;

/// Path as written: its segments, and the name that a `use` declaration binds.
struct Written {
    segments: Vec<String>,
    alias: String,
    /// True for `pub use`, with any visibility.
    exported: bool,
}

/// Items and paths of a module.
#[derive(Default)]
struct Source {
    paths: Vec<Written>,
    /// Names of items that the module defines itself.
    items: BTreeSet<String>,
}

/// Modules of a crate, and the paths in each.
pub struct Modules(BTreeMap<Module, Source>);

impl Modules {
    /// Reads the modules of the crate with this source directory.
    pub fn of(source: &Path) -> Modules {
        let mut modules = BTreeMap::new();
        read(&source.join("lib.rs"), source, Vec::new(), &mut modules);
        Modules(modules)
    }

    /// Returns items other than constants that the root of the crate defines itself.
    pub fn items_of_root(&self) -> Vec<&str> {
        self.0
            .get(&Module::new())
            .map_or_else(Vec::new, |root| root.items.iter().map(String::as_str).collect())
    }

    /// Returns dependency cycles among modules with the same parent, each as the names of its
    /// modules.
    pub fn circles(&self) -> Vec<String> {
        let parents: BTreeSet<&[String]> =
            self.0.keys().filter_map(|module| module.split_last()).map(|(_, parent)| parent).collect();
        let below = |parent: &[String]| {
            let edges = self.edges(parent);
            let circles = circles(&edges).into_iter();
            circles.map(|names| [parent.join("::"), names.join(", ")].join(": ")).collect::<Vec<_>>()
        };
        parents.into_iter().flat_map(below).collect()
    }

    /// Returns the dependencies among the children of a module.
    fn edges(&self, parent: &[String]) -> BTreeMap<String, BTreeSet<String>> {
        let mut edges: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
        let children =
            self.0.iter().filter(|(module, _)| module.len() > parent.len() && module.starts_with(parent));
        for (module, source) in children {
            let from = &module[parent.len()];
            let to = edges.entry(from.clone()).or_default();
            let targets = source.paths.iter().filter_map(|path| self.resolved(module, &path.segments));
            to.extend(
                targets
                    .filter(|target| target.starts_with(parent))
                    .filter_map(|target| target.get(parent.len()).filter(|name| *name != from).cloned()),
            );
        }
        edges
    }

    /// Returns the module that a path refers to, or that defines its item; `None` for other crates.
    fn resolved(&self, within: &Module, path: &[String]) -> Option<Module> {
        let (mut module, mut rest): (Module, &[String]) = match path.first()?.as_str() {
            "crate" => (Vec::new(), &path[1..]),
            "self" => (within.clone(), &path[1..]),
            "super" => (within.clone(), path),
            first => {
                let child = [within.as_slice(), &[first.to_owned()]].concat();
                self.0.contains_key(&child).then_some((child, &path[1..]))?
            }
        };
        while rest.first().is_some_and(|segment| segment == "super") {
            module.pop();
            rest = &rest[1..];
        }
        // A re-export may refer to another one.
        for _ in 0..8 {
            let Some(name) = rest.first() else { return Some(module) };
            let child = [module.as_slice(), std::slice::from_ref(name)].concat();
            if self.0.contains_key(&child) {
                (module, rest) = (child, &rest[1..]);
                continue;
            }
            let source = self.0.get(&module)?;
            let exported = source.paths.iter().find(|path| path.exported && path.alias == *name);
            let Some(exported) = exported.filter(|_| !source.items.contains(name)) else {
                return Some(module);
            };
            if exported.segments.len() < 2 {
                return Some(module);
            }
            return self.resolved(&module, &exported.segments);
        }
        Some(module)
    }
}

/// Returns strongly connected components of more than one node, by reachability.
fn circles(edges: &BTreeMap<String, BTreeSet<String>>) -> Vec<Vec<String>> {
    let reached = |from: &String| {
        let (mut found, mut next) = (BTreeSet::new(), vec![from]);
        while let Some(node) = next.pop() {
            for other in edges.get(node).into_iter().flatten() {
                if found.insert(other.clone()) {
                    next.push(other);
                }
            }
        }
        found
    };
    let reach: BTreeMap<&String, BTreeSet<String>> = edges.keys().map(|node| (node, reached(node))).collect();
    let mut circles: BTreeSet<Vec<String>> = BTreeSet::new();
    for (node, others) in reach.iter().filter(|(node, others)| others.contains(**node)) {
        let round = others.iter().filter(|other| reach.get(other).is_some_and(|back| back.contains(*node)));
        circles.insert(round.cloned().collect());
    }
    circles.into_iter().collect()
}

/// Reads a module's file and those of its children.
fn read(file: &Path, folder: &Path, module: Module, into: &mut BTreeMap<Module, Source>) {
    let text = std::fs::read_to_string(file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    let tokens = tokens(&text);
    let mut source = Source::default();
    let mut children = Vec::new();
    items(&tokens, &mut source, &mut children);
    into.insert(module.clone(), source);
    for child in children {
        let (beside, below) = (folder.join(format!("{child}.rs")), folder.join(&child));
        let file = if beside.exists() { beside } else { below.join("mod.rs") };
        read(&file, &below, [module.as_slice(), &[child]].concat(), into);
    }
}

/// Splits Rust into words, `::` and single characters, without comments, literals and lifetimes.
fn tokens(text: &str) -> Vec<String> {
    let bytes = text.as_bytes();
    let (mut tokens, mut at) = (Vec::new(), 0);
    let is_word = |byte: u8| byte == b'_' || byte.is_ascii_alphanumeric() || byte >= 0x80;
    while at < bytes.len() {
        let rest = &text[at..];
        at += if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            rest.find("*/").map_or(rest.len(), |end| end + 2)
        } else if rest.starts_with("r\"") || rest.starts_with("r#") {
            let hashes = rest[1..].bytes().take_while(|byte| *byte == b'#').count();
            let close = format!("\"{}", "#".repeat(hashes));
            rest[hashes + 2..].find(&close).map_or(rest.len(), |end| hashes + 2 + end + close.len())
        } else if bytes[at] == b'"' {
            let mut end = 1;
            while at + end < bytes.len() && bytes[at + end] != b'"' {
                end += if bytes[at + end] == b'\\' { 2 } else { 1 };
            }
            end + 1
        } else if bytes[at] == b'\'' {
            let character = if rest[1..].starts_with('\\') {
                3
            } else {
                1 + rest[1..].chars().next().map_or(0, char::len_utf8)
            };
            match rest.get(character..).and_then(|tail| tail.find('\'')) {
                Some(end) if end == 0 || rest[1..].starts_with('\\') => character + end + 1,
                _ => 1,
            }
        } else if is_word(bytes[at]) {
            let end = rest.bytes().take_while(|byte| is_word(*byte)).count();
            tokens.push(rest[..end].to_owned());
            end
        } else if rest.starts_with("::") {
            tokens.push("::".to_owned());
            2
        } else {
            let length = rest.chars().next().map_or(1, char::len_utf8);
            if !bytes[at].is_ascii_whitespace() {
                tokens.push(rest[..length].to_owned());
            }
            length
        };
    }
    tokens
}

/// Keywords before the name of an item.
const DEFINES: [&str; 7] = ["struct", "enum", "trait", "fn", "type", "union", "static"];

/// Collects paths, the names of items, and child modules in separate files.
fn items(tokens: &[String], source: &mut Source, children: &mut Vec<String>) {
    let word = |at: usize| tokens.get(at).map_or("", String::as_str);
    let (mut at, mut depth, mut exported) = (0, 0_usize, false);
    while at < tokens.len() {
        match word(at) {
            "#" => {
                let start = at + if word(at + 1) == "!" { 2 } else { 1 };
                let end = closed(tokens, start);
                let attribute = &tokens[start..end];
                let of_tests = attribute.iter().any(|token| token == "cfg")
                    && attribute.iter().any(|token| token == "test");
                at = if of_tests { behind_item(tokens, end) } else { end };
                continue;
            }
            "pub" if depth == 0 => exported = true,
            "use" => {
                let end =
                    at + tokens[at..].iter().position(|token| token == ";").unwrap_or(tokens.len() - at);
                tree(&tokens[at + 1..end], &[], exported && depth == 0, &mut source.paths);
                at = end;
                exported = false;
            }
            "mod" if word(at + 2) == ";" => {
                children.push(word(at + 1).to_owned());
                exported = false;
            }
            "crate" | "super" | "self" if word(at + 1) == "::" && word(at.wrapping_sub(1)) != "::" => {
                let mut segments = vec![word(at).to_owned()];
                while word(at + 1) == "::" && is_name(word(at + 2)) {
                    segments.push(word(at + 2).to_owned());
                    at += 2;
                }
                source.paths.push(Written { segments, alias: String::new(), exported: false });
            }
            "{" => depth += 1,
            "}" => {
                depth = depth.saturating_sub(1);
                exported = false;
            }
            ";" => exported = false,
            keyword if depth == 0 && DEFINES.contains(&keyword) && is_name(word(at + 1)) => {
                source.items.insert(word(at + 1).to_owned());
            }
            _ => {}
        }
        at += 1;
    }
}

fn is_name(token: &str) -> bool {
    token.starts_with(|first: char| first == '_' || first.is_alphabetic())
}

/// Returns the index after the bracket that closes an opening one.
fn closed(tokens: &[String], open: usize) -> usize {
    let mut depth = 0_usize;
    for (at, token) in tokens.iter().enumerate().skip(open) {
        match token.as_str() {
            "[" | "{" | "(" => depth += 1,
            "]" | "}" | ")" => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth == 0 {
            return at + 1;
        }
    }
    tokens.len()
}

/// Returns the index after the `;` or the braces of the item at a token.
fn behind_item(tokens: &[String], from: usize) -> usize {
    let mut at = from;
    while at < tokens.len() {
        match tokens[at].as_str() {
            ";" => return at + 1,
            "{" => return closed(tokens, at),
            "(" | "[" => at = closed(tokens, at),
            _ => at += 1,
        }
    }
    at
}

/// Collects the paths of a tree of a `use` declaration.
fn tree(tokens: &[String], before: &[String], exported: bool, into: &mut Vec<Written>) {
    let mut segments = before.to_vec();
    let mut at = 0;
    while at < tokens.len() {
        match tokens[at].as_str() {
            "::" => {}
            "{" => {
                let inner = &tokens[at + 1..closed(tokens, at) - 1];
                let mut start = 0;
                while start < inner.len() {
                    let mut end = start;
                    while end < inner.len() && inner[end] != "," {
                        end = if inner[end] == "{" { closed(inner, end) } else { end + 1 };
                    }
                    tree(&inner[start..end], &segments, exported, into);
                    start = end + 1;
                }
                return;
            }
            "as" => {
                let alias = tokens.get(at + 1).cloned().unwrap_or_default();
                return into.push(Written { segments, alias, exported });
            }
            "self" if at + 1 == tokens.len() && !segments.is_empty() => {}
            name => segments.push(name.to_owned()),
        }
        at += 1;
    }
    segments.retain(|segment| segment != "*");
    let alias = segments.last().cloned().unwrap_or_default();
    into.push(Written { segments, alias, exported });
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Reads a crate with these files.
    fn modules(files: &[(&str, &str)]) -> Modules {
        let folder = tempfile::tempdir().expect("a folder");
        for (name, text) in files {
            let path = folder.path().join(name);
            std::fs::create_dir_all(path.parent().expect("a folder")).expect("it is made");
            std::fs::write(path, text).expect("it is written");
        }
        Modules::of(folder.path())
    }

    #[test]
    fn a_circle_through_a_re_export_and_an_expression_is_found() {
        let found = modules(&[
            ("lib.rs", "mod a;\nmod b;\nmod c;\npub use b::{Second as Other, Third};\n"),
            ("a.rs", "use crate::{Other, c::Last};\npub struct First(Other, Last);\n"),
            ("b.rs", "pub struct Second;\npub struct Third;\nfn f() { super::c::g() }\n"),
            ("c.rs", "pub struct Last;\npub fn g() { let _ = crate::a::First; }\n"),
        ]);
        assert_eq!(found.circles(), [": a, b, c"]);
        assert!(found.items_of_root().is_empty());
    }

    #[test]
    fn circles_of_children_are_found_by_their_parent() {
        let found = modules(&[
            ("lib.rs", "mod a;\npub struct Own;\n"),
            ("a.rs", "mod one;\nmod two;\nuse one::One;\nuse two::Two;\nstruct Both(One, Two);\n"),
            ("a/one.rs", "use super::two::Two;\npub struct One(Two);\n"),
            ("a/two.rs", "pub struct Two(Option<Box<super::one::One>>);\n"),
        ]);
        assert_eq!(found.circles(), ["a: one, two"]);
        assert_eq!(found.items_of_root(), ["Own"]);
    }

    #[test]
    fn comments_texts_and_tests_do_not_count() {
        let found = modules(&[
            ("lib.rs", "mod a;\nmod b;\n"),
            (
                "a.rs",
                "// use crate::b::B;\npub const A: &str = \"use crate::b::B;\";\npub const Q: char = '\"';\n\
                 fn f<'a>(x: &'a str) -> &'a str { x }\n\
                 #[cfg(test)]\nmod tests {\n    use crate::b::B;\n}\n#[cfg(test)]\nmod other;\n",
            ),
            ("b.rs", "pub struct B(crate::a::Missing);\n"),
        ]);
        assert_eq!(found.circles(), Vec::<String>::new());
    }
}
