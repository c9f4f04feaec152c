//! Checks that the keyword lists of the three syntax highlighters match the language exactly.

use super::read;
use calyx_lang::check::builtin_names;
use calyx_lang::dimension::Dimension;
use calyx_lang::lexer::keywords;
use calyx_lang::units::Unit;
use calyx_lsp::ide::semantic_tokens::{KINDS, MODIFIERS};
use serde_json::Value;
use std::collections::BTreeSet;

type Words = BTreeSet<String>;

fn set<'a>(words: impl IntoIterator<Item = &'a str>) -> Words {
    words.into_iter().map(str::to_owned).collect()
}

/// Returns all unit names that are words; editors treat `%` as an operator.
fn units() -> Words {
    let spellings = Unit::all().iter().flat_map(|unit| unit.aliases.iter().chain([&unit.name]).copied());
    set(spellings.filter(|spelling| *spelling != "%"))
}

/// Returns the predefined names that are not functions.
fn constants() -> Words {
    set(["Time", "e1", "e2", "e3", "pi", "inf", "nan", "TRUE", "FALSE"])
}

fn functions() -> Words {
    set(builtin_names()).difference(&constants()).cloned().collect()
}

/// Words that are allowed between `extern` and `function`.
const EFFECTS: [&str; 3] = ["pure", "scene", "effect"];

/// The word between two names in a declaration.
const FORMER: &str = "was";

fn without(words: &Words, others: impl IntoIterator<Item = &'static str>) -> Words {
    words.difference(&set(others)).cloned().collect()
}

/// Returns the words in a regular expression, without escapes such as `\b`, `\p{L}`.
fn spelt_out(regex: &str) -> Words {
    let mut words = Words::new();
    let mut word = String::new();
    let mut characters = regex.chars().peekable();
    while let Some(character) = characters.next() {
        if character.is_alphanumeric() || character == '_' {
            word.push(character);
            continue;
        }
        words.insert(std::mem::take(&mut word));
        if character == '\\' && characters.next().is_some_and(|escape| escape == 'p') {
            let _ = characters.by_ref().take_while(|c| *c != '}').count();
        }
    }
    words.insert(word);
    words.retain(|word| word.chars().any(char::is_alphabetic));
    words
}

/// Returns the words in all regular expressions below a node of the grammar.
fn below(value: &Value) -> Words {
    match value {
        Value::Array(items) => items.iter().flat_map(below).collect(),
        Value::Object(fields) => fields
            .iter()
            .flat_map(|(name, value)| match (name.as_str(), value) {
                ("match" | "begin" | "end", Value::String(regex)) => spelt_out(regex),
                _ => below(value),
            })
            .collect(),
        _ => Words::new(),
    }
}

struct Grammar(Value);

impl Grammar {
    fn read() -> Grammar {
        let text = read("vscode/syntaxes/calyx.tmLanguage.json");
        Grammar(serde_json::from_str(&text).expect("the grammar is JSON"))
    }

    fn section(&self, name: &str) -> &Value {
        let section = &self.0["repository"][name];
        assert!(section.is_object(), "the grammar has no section `{name}`");
        section
    }

    fn sections(&self, names: &[&str]) -> Words {
        names.iter().flat_map(|name| below(self.section(name))).collect()
    }

    fn pattern(&self, section: &str, scope: &str) -> Words {
        let patterns = self.section(section)["patterns"].as_array().expect("patterns");
        let pattern = patterns.iter().find(|pattern| pattern["name"] == scope);
        below(pattern.unwrap_or_else(|| panic!("`{section}` has no `{scope}`")))
    }
}

#[test]
fn the_textmate_grammar_has_the_languages_words() {
    let grammar = Grammar::read();
    let found =
        grammar.sections(&["declarations", "functions", "parameters", "statements", "keywords", "at"]);
    let mut expected = without(&set(keywords()), ["TRUE", "FALSE"]);
    expected.extend(set(EFFECTS));
    expected.insert(FORMER.to_owned());
    assert_eq!(found, expected);
    // Each unconditional keyword has a rule that is independent of its context.
    let always = grammar.sections(&["keywords"]);
    let contextual = [
        "import",
        "units",
        "param",
        "output",
        "extern",
        "at",
        "private",
        "test",
        "host",
        "const",
        "record",
        "component",
        "enum",
        "is",
        "dimension",
        "unit",
        "TRUE",
        "FALSE",
    ];
    assert_eq!(always, without(&set(keywords()), contextual));
    assert_eq!(grammar.sections(&["constants"]), constants());
    assert_eq!(grammar.pattern("unit-product", "keyword.other.unit.calyx"), units());
    assert_eq!(grammar.pattern("types", "support.type.dimension.calyx"), set(Dimension::names()));
    assert_eq!(grammar.pattern("calls", "support.function.calyx"), functions());
}

/// Returns the words of `syn keyword GROUP ...`, including continuation lines, which begin with
/// `\`.
fn vim_keywords(syntax: &str, group: &str) -> Words {
    let mut words = Words::new();
    let mut inside = false;
    for line in syntax.lines() {
        let rest = match line.strip_prefix("syn keyword ").and_then(|rest| rest.split_once(' ')) {
            Some((of, rest)) => {
                inside = of == group;
                rest
            }
            None => match line.trim_start().strip_prefix("\\ ") {
                Some(rest) => rest,
                None => {
                    inside = false;
                    continue;
                }
            },
        };
        if inside {
            words.extend(
                rest.split(' ').filter(|word| *word != "contained" && !word.contains('=')).map(str::to_owned),
            );
        }
    }
    words
}

#[test]
fn the_vim_syntax_has_the_languages_words() {
    let syntax = read("neovim/syntax/calyx.vim");
    let groups =
        |groups: &[&str]| groups.iter().flat_map(|group| vim_keywords(&syntax, group)).collect::<Words>();
    let always = groups(&[
        "calyxConditional",
        "calyxRepeat",
        "calyxLabel",
        "calyxStatement",
        "calyxException",
        "calyxStorage",
        "calyxMode",
        "calyxBoolean",
    ]);
    let all = set(keywords());
    let contextual: Words = all.difference(&always).cloned().collect();
    assert!(always.is_subset(&all), "{:?}", always.difference(&all));
    for word in contextual.iter().map(String::as_str).chain(EFFECTS).chain([FORMER]) {
        let in_match = syntax
            .lines()
            .filter(|line| line.starts_with("syn match"))
            .any(|line| line.split(|c: char| !c.is_alphanumeric()).any(|part| part == word));
        assert!(in_match, "no rule knows `{word}`");
    }
    assert_eq!(groups(&["calyxConstant"]), without(&constants(), ["TRUE", "FALSE"]));
    // `min` is a function only in a call.
    assert_eq!(groups(&["calyxBuiltin"]), without(&functions(), ["min"]));
    assert_eq!(groups(&["calyxUnitFactor"]), units());
    let dimensions = groups(&["calyxDimension"]);
    // `Time` is highlighted as the time.
    let missing: Words = set(Dimension::names()).difference(&dimensions).cloned().collect();
    assert_eq!(missing, set(["Time"]));
}

/// Returns the strings of `(defconst NAME '(...))`.
fn lisp_list(text: &str, name: &str) -> Words {
    let (_, rest) = text.split_once(&format!("(defconst {name}")).unwrap_or_else(|| panic!("no {name}"));
    let (_, rest) = rest.split_once("'(").expect("a list");
    let (list, _) = rest.split_once(')').expect("the list ends");
    set(list.split('"').skip(1).step_by(2))
}

#[test]
fn the_emacs_mode_has_the_languages_words() {
    let mode = read("emacs/calyx-mode.el");
    let words = |names: &[&str]| names.iter().flat_map(|name| lisp_list(&mode, name)).collect::<Words>();
    assert_eq!(words(&["calyx--keywords", "calyx--contextual", "calyx--booleans"]), set(keywords()));
    assert_eq!(words(&["calyx--constants", "calyx--booleans"]), constants());
    assert_eq!(words(&["calyx--builtins"]), functions());
    assert_eq!(words(&["calyx--units"]), units());
    assert!(set(Dimension::names()).is_subset(&words(&["calyx--types"])));
}

/// Token types and modifiers of the protocol, for which themes define colours.
const OF_THE_PROTOCOL: [&str; 19] = [
    "comment",
    "keyword",
    "number",
    "string",
    "operator",
    "namespace",
    "type",
    "struct",
    "parameter",
    "variable",
    "property",
    "function",
    "label",
    "declaration",
    "definition",
    "readonly",
    "modification",
    "documentation",
    "defaultLibrary",
];

#[test]
fn the_extension_gives_colours_to_what_the_server_tells_apart() {
    let manifest: Value = serde_json::from_str(&read("vscode/package.json")).expect("JSON");
    let declared = |kind: &str| -> Words {
        let all = manifest["contributes"][kind].as_array().expect("a list");
        all.iter().map(|one| one["id"].as_str().expect("a name").to_owned()).collect()
    };
    let own = |names: &[&str]| set(names.iter().copied().filter(|name| !OF_THE_PROTOCOL.contains(name)));
    assert_eq!(declared("semanticTokenTypes"), own(&KINDS));
    assert_eq!(declared("semanticTokenModifiers"), own(&MODIFIERS));
    let scopes = &manifest["contributes"]["semanticTokenScopes"][0]["scopes"];
    let selectors = scopes.as_object().expect("scopes").keys();
    let known: Words = KINDS.iter().chain(&MODIFIERS).map(|name| (*name).to_owned()).collect();
    for part in selectors.flat_map(|selector| selector.split('.')).filter(|part| *part != "*") {
        assert!(known.contains(part), "the server has no `{part}`");
    }
}
