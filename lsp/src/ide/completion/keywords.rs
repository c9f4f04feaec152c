//! Completion of keywords, with snippets of the usual continuation.

use super::context::{CompletionSite, Value};
use super::item::{Insert, Item, ItemKind, Rank, Subject};
use super::request::Request;
use crate::ide::cursor::BlockKind;
use calyx_lang::lexer::Kind;
use calyx_lang::units::UnitSystem;

/// Position of a statement.
#[derive(Clone, Copy, PartialEq, Eq)]
enum StatementPosition {
    /// Top level of a model.
    Model,
    /// Top level of a module, which has no executable statements.
    Module,
    /// A function, or a block at the top level.
    Block,
}

struct Keyword {
    label: &'static str,
    detail: &'static str,
    /// `LENGTH` is replaced by the system's unit of length.
    snippet: &'static str,
    stands: &'static [StatementPosition],
}

use StatementPosition::{Block, Model, Module};

/// Sorted by frequency of use at the start of a statement.
const STATEMENTS: &[Keyword] = &[
    Keyword { label: "var", detail: "a variable", snippet: "var ${1:name} = $0;", stands: &[Model, Block] },
    Keyword {
        label: "param",
        detail: "an input of the model, with its range",
        snippet: "param ${1:name} = ${2:1 LENGTH} in ${3:0 LENGTH} .. ${4:2 LENGTH};",
        stands: &[Model],
    },
    Keyword {
        label: "output",
        detail: "what the results hold",
        snippet: "output ${1:name} := $0;",
        stands: &[Model],
    },
    Keyword {
        label: "var :=",
        detail: "an expression that is kept",
        snippet: "var ${1:name} := $0;",
        stands: &[Model, Block],
    },
    Keyword {
        label: "function",
        detail: "a function",
        snippet: "function ${1:name}(in ${2:x}) {\n    return $0;\n}",
        stands: &[Model, Module, Block],
    },
    Keyword { label: "import", detail: "a module", snippet: "import ${1:gears};", stands: &[Model, Module] },
    Keyword {
        label: "units",
        detail: "the unit system of the file",
        snippet: "units ${1|mm_N_s,inch_lbf_s,SI|};",
        stands: &[Model, Module],
    },
    Keyword {
        label: "param in [...]",
        detail: "an input of the model, with its choices",
        snippet: "param ${1:name} = \"${2:a}\" in [\"${2:a}\", \"${3:b}\"];",
        stands: &[Model],
    },
    Keyword {
        label: "if",
        detail: "a branch",
        snippet: "if (${1:condition}) {\n    $0\n}",
        stands: &[Model, Block],
    },
    Keyword {
        label: "for",
        detail: "a loop that counts",
        snippet: "for (var ${1:i} = 0; ${1:i} < ${2:n}; ${1:i} = ${1:i} + 1) {\n    $0\n}",
        stands: &[Model, Block],
    },
    Keyword {
        label: "while",
        detail: "a loop",
        snippet: "while (${1:condition}) {\n    $0\n}",
        stands: &[Model, Block],
    },
    Keyword { label: "return", detail: "leaves the function", snippet: "return $0;", stands: &[Block] },
    Keyword {
        label: "const",
        detail: "a value known before the program runs",
        snippet: "const ${1:name} = $0;",
        stands: &[Model, Module, Block],
    },
    Keyword {
        label: "switch",
        detail: "a choice among cases",
        snippet: "switch (${1:value}) {\n    case ${2:1}:\n        $0\n        break;\n    default:\n}",
        stands: &[Model, Block],
    },
    Keyword {
        label: "try",
        detail: "catches errors",
        snippet: "try {\n    $0\n} catch (${1:error}) {\n}",
        stands: &[Model, Block],
    },
    Keyword {
        label: "throw",
        detail: "ends what is under way with an error",
        snippet: "throw \"$0\";",
        stands: &[Model, Block],
    },
    Keyword {
        label: "record",
        detail: "named fields",
        snippet: "record ${1:Name} {\n    ${2:width} = ${3:1 LENGTH};$0\n}",
        stands: &[Model, Module, Block],
    },
    Keyword {
        label: "enum",
        detail: "a type with a few values",
        snippet: "enum ${1:Name} { ${2:first}, ${3:second}$0 }",
        stands: &[Model, Module],
    },
    Keyword {
        label: "for in",
        detail: "a loop over values",
        snippet: "for (${1:x} in ${2:values}) {\n    $0\n}",
        stands: &[Model, Block],
    },
    Keyword {
        label: "component",
        detail: "a part of a model with its own params",
        snippet: "component ${1:Name}(${2:ratio}: ${3:Number}) {\n    param ${4:torque} = ${5:1 N*m};\n    $0\n}",
        stands: &[Model, Module],
    },
    Keyword {
        label: "function :=",
        detail: "a symbolic function",
        snippet: "function ${1:name}(in ${2:x}) := $0;",
        stands: &[Model, Module, Block],
    },
    Keyword {
        label: "test function",
        detail: "a test, run by `calyx test`",
        snippet: "test function ${1:name}() {\n    assert($0);\n}",
        stands: &[Model, Module],
    },
    Keyword {
        label: "host function",
        detail: "a function that an embedding program may provide",
        snippet: "host function ${1:name}(in ${2:x}: ${3:Number}) -> ${4:Number} {\n    return $0;\n}",
        stands: &[Model, Module],
    },
    Keyword {
        label: "do",
        detail: "a loop that runs at least once",
        snippet: "do {\n    $0\n} while (${1:condition});",
        stands: &[Model, Block],
    },
    Keyword {
        label: "dimension",
        detail: "a name for a dimension",
        snippet: "dimension ${1:Name} = $0;",
        stands: &[Model, Module],
    },
    Keyword { label: "unit", detail: "a unit", snippet: "unit ${1:name} = $0;", stands: &[Model, Module] },
    Keyword { label: "private", detail: "not seen by importers", snippet: "private $0", stands: &[Module] },
    Keyword { label: "goto", detail: "goes to a label", snippet: "goto $0;", stands: &[Model, Block] },
];

/// Offers keywords at the start of a statement.
pub fn statements(request: &Request<'_>, items: &mut Vec<Item>) {
    let context = &request.context;
    let around = &context.around;
    let place = if !context.blocks.is_empty() {
        Block
    } else if request.database.models().any(|model| model == request.file) {
        Model
    } else {
        Module
    };
    let has_units = (0..).map_while(|at| around.kind(at)).any(|kind| kind == Kind::Units);
    let component =
        context.blocks.first().is_some_and(|block| around.kind(block.head) == Some(Kind::Component));
    let member = |label: &str| component && matches!(label, "param" | "output");
    for (order, keyword) in STATEMENTS.iter().enumerate() {
        if (keyword.stands.contains(&place) || member(keyword.label))
            && (keyword.label != "units" || !has_units)
        {
            items.push(keyword_item(request, keyword.label, keyword.detail, keyword.snippet, 1, order));
        }
    }
    // Keywords related to the enclosing block come first.
    let innermost = context.blocks.first().map(|block| block.kind);
    let within = |kind: BlockKind| {
        context
            .blocks
            .iter()
            .take_while(|block| block.kind != BlockKind::Function)
            .any(|block| block.kind == kind)
    };
    let mut near: Vec<(&str, &str, &str)> = Vec::new();
    if innermost == Some(BlockKind::Switch) {
        near.push(("case", "one value", "case ${1:value}:\n    $0\n    break;"));
        near.push(("default", "all other values", "default:\n    $0"));
    }
    if within(BlockKind::Loop) || within(BlockKind::Switch) {
        near.push(("break", "leaves the loop or switch", "break;"));
    }
    if within(BlockKind::Loop) {
        near.push(("continue", "continues with the next iteration", "continue;"));
    }
    if within(BlockKind::Catch) {
        near.push(("throw", "passes the same error on", "throw;"));
    }
    let before = around.before;
    if follows_if(request, before) {
        near.push(("else", "the other branch", "else {\n    $0\n}"));
    }
    for (order, (label, detail, snippet)) in near.into_iter().enumerate() {
        items.push(keyword_item(request, label, detail, snippet, 0, order));
    }
}

/// Returns true if the statement before the cursor is the first branch of an `if`.
fn follows_if(request: &Request<'_>, end: usize) -> bool {
    let around = &request.context.around;
    let Some(last) = end.checked_sub(1) else { return false };
    let head = match around.kind(last) {
        Some(Kind::CloseBrace) => around.opening(last).and_then(|open| open.checked_sub(1)),
        Some(Kind::Semicolon) => {
            let start = around.statement(last).start;
            start.checked_sub(1)
        }
        _ => None,
    };
    head.filter(|&close| around.kind(close) == Some(Kind::CloseParen))
        .and_then(|close| around.opening(close))
        .is_some_and(|open| around.previous(open) == Some(Kind::If))
}

fn keyword_item(
    request: &Request<'_>,
    label: &str,
    detail: &str,
    snippet: &str,
    fit: u8,
    order: usize,
) -> Item {
    let length = match request.system {
        UnitSystem::InchLbfS => "inch",
        UnitSystem::Si | UnitSystem::MmNS => "mm",
    };
    let word = label.split(' ').next().unwrap_or(label);
    let rank = Rank { fit, origin: 0, order: order as u32 };
    let mut item = Item::new(label, ItemKind::Keyword, rank).detail(detail);
    let plain = if snippet == format!("{label};") { snippet.to_string() } else { format!("{word} ") };
    item.insert = Insert::snippet(plain, snippet.replace("LENGTH", length));
    item.filter = (word != label).then(|| word.to_string());
    item.subject = Some(Subject::Keyword(word.to_string()));
    item
}

/// Offers keywords that start a value.
pub fn values(request: &Request<'_>, items: &mut Vec<Item>) {
    let snippet = "if (${1:condition}) ${2:a} else ${0:b}";
    let mut item = keyword_item(request, "if", "a choice", snippet, 3, 0);
    item.rank.origin = 6;
    items.push(item);
}

/// Offers these words, best first.
pub fn words(request: &Request<'_>, words: &[&'static str], items: &mut Vec<Item>) {
    for (order, word) in words.iter().enumerate() {
        let (snippet, detail) = match *word {
            "at" => ("at Time = $0", "the value at a time or param"),
            "in" if matches!(request.context.spot, CompletionSite::After(_) | CompletionSite::Unit(..)) => {
                ("in $0", "a range or choices")
            }
            "in" => ("in ", "passes a value"),
            "out" => ("out ", "hands a value back"),
            "inout" => ("inout ", "passes a value and hands it back"),
            "else" => ("else $0", "the other value"),
            "pure" => ("pure function ", "depends on its arguments alone"),
            "scene" => ("scene function ", "adds to the model"),
            "effect" => ("effect function ", "does what checking does not do"),
            _ => ("", ""),
        };
        let snippet = if snippet.is_empty() { format!("{word} ") } else { snippet.to_string() };
        let mut item = keyword_item(request, word, detail, &snippet, 3, order);
        if !snippet.contains('$') {
            item.insert = Insert::plain(snippet);
        }
        items.push(item);
    }
}

/// Returns true if a condition or argument expects `TRUE` or `FALSE`. Elsewhere these are offered
/// as constants of the language.
pub fn is_truth(value: &Value, request: &Request<'_>) -> bool {
    value.is_first() && request.expected.shape.is("Bool") && !request.expected.weak
}

/// Returns a sentence that documents a keyword.
pub fn documentation(word: &str) -> Option<&'static str> {
    Some(match word {
        "var" => {
            "`var name = value;` declares a variable. `var name := expression;` keeps the expression, in which `Time`, params and other such names stay symbols."
        }
        "param" => {
            "`param name = default in low .. high;` is an input that is set from outside, as by `calyx run model.cx --set name=value`, without changing the model. After `in` stands a range or a list of choices."
        }
        "output" => {
            "`output name := expression;` declares a result: an observable of the library, or an expression of observables, params and `Time`."
        }
        "const" => "`const name = value;` names a value that is known before the program runs.",
        "function" => {
            "`function name(in x, out y) { ... }` declares a function; `function name(in x) := expression;` one that is an expression with free arguments."
        }
        "record" => {
            "`record Name { width = 1 mm; teeth: Number; }` declares a record with named fields, which is made like a call."
        }
        "enum" => {
            "`enum Name { first, second }` declares a type with a few values, written `Name.first`. The text of a choice stands for it."
        }
        "for in" => {
            "`for (x in array) ...` runs for each element of an array, `for (i in 0 .. n) ...` for each number of a range without its end."
        }
        "component" => {
            "`component Name(ratio: Number) { ... }` declares a part of a model with its own params and outputs; `var low = Name(3);` is an instance."
        }
        "dimension" => {
            "`dimension Name = Force/Length;` names a product of dimensions; `dimension Name;` adds a base dimension."
        }
        "unit" => {
            "`unit name = 12 inch;` declares a unit; `unit name: Dimension;` the first one of a new base dimension."
        }
        "import" => {
            "`import module;` makes what a module declares visible as `module.name`: a module of the library, or a file in the same folder."
        }
        "units" => {
            "`units mm_N_s;` sets the system of the file: in which units its text shows numbers, and what numbers without a unit mean."
        }
        "host" => {
            "`host function name(in x: Number) -> Number { ... }` may be provided by the program that embeds the model; its body is used where nobody provides it."
        }
        "test" => "`test function name() { ... }` is run by `calyx test`.",
        "private" => "A declaration that importers of the module do not see.",
        "if" => "`if (condition) ... else ...`, as a statement or as a value.",
        "for" => "`for (first; condition; step) ...`; each of the three may be left out.",
        "switch" => {
            "The cases are tried in order. Execution falls through into the next case unless `break` leaves the switch."
        }
        "try" => {
            "If an error ends what `try` runs, what stands after `catch` runs and receives it as an `Error`."
        }
        "throw" => {
            "`throw \"message\";` or `throw Error(...)` ends what is under way with an error; `throw;` in a `catch` passes the same one on."
        }
        "goto" => "`goto label;` leads to a label of the same block or of one around it.",
        "at" => {
            "`expression at Time = t` is its value at a time, `expression at p = v` that with a value put in for a param."
        }
        _ => return None,
    })
}
