//! Generates random programs from the grammar in the reference, so that the reference and the
//! parser stay consistent.

use std::collections::BTreeMap;

/// The xorshift64* generator, the same on every machine.
pub struct Random(pub u64);

impl Random {
    pub fn below(&mut self, limit: usize) -> usize {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 33) as usize % limit.max(1)
    }

    pub fn pick<T: Copy>(&mut self, items: &[T]) -> T {
        items[self.below(items.len())]
    }
}

enum Node {
    Rule(String),
    Word(String),
    Sequence(Vec<Node>),
    Choice(Vec<Node>),
    Optional(Box<Node>),
    Repeat(Box<Node>),
}

/// The rules of a grammar in the notation of the reference.
pub struct Grammar {
    rules: BTreeMap<String, Node>,
    /// Depth of the shallowest tree of each rule.
    depths: BTreeMap<String, usize>,
}

/// A token of a program, and whether it must be on the line of the previous token.
#[derive(Clone, Debug)]
pub struct Piece {
    pub text: String,
    pub same_line: bool,
}

/// Restrictions that the grammar states in words: the part must not start with this token.
const NOT_FIRST: &[(&str, &str)] = &[("simple_statement", "if"), ("low", "["), ("body", "(")];

/// Weights of alternatives that begin with these rules, relative to all others. Without them, one
/// program in several hundred has an assignment.
const WEIGHTS: &[(&str, usize)] = &[("statement", 4), ("simple_statement", 4), ("place", 3)];

/// Returns spellings of a lexical token. The names include contextual keywords.
fn lexical(rule: &str) -> Option<&'static [&'static str]> {
    Some(match rule {
        "NAME" => &[
            "a",
            "b",
            "x1",
            "gears",
            "Time",
            "e3",
            "_long_name_of_a_variable",
            "länge",
            "at",
            "param",
            "units",
            "output",
            "import",
            "extern",
            "test",
            "host",
            "private",
            "const",
            "record",
            "component",
            "unit",
            "dimension",
            "inch",
            "pure",
            "was",
        ],
        "UNIT" => &["mm", "inch", "lbf", "furlong", "deg", "µm", "%", "kg"],
        "NUMBER" => &["0", "1", "2.5", ".5", "3.", "1e3", "2E-3", "0.15708", "100000000000000000000"],
        "INTEGER" => &["1", "2", "3", "12"],
        "FILE" => &["\"stage\"", "\"parts/wide-rims\""],
        "TEXT" => &["word", "two words", "{{", "}}", "\\n", "\\\"", "µ", "//", "/*", "'", "$"],
        "FORMAT" => &[":.3", ": 10", ": 10.3e", ":e"],
        _ => return None,
    })
}

impl Grammar {
    /// The grammar of `docs/reference.md`.
    pub fn of_the_reference() -> Grammar {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/reference.md");
        let page = std::fs::read_to_string(path).expect("the reference");
        let text: Vec<&str> =
            page.split("```ebnf\n").skip(1).filter_map(|block| block.split("```").next()).collect();
        let mut rules = BTreeMap::new();
        let mut lines = String::new();
        for line in text.concat().lines().chain(["end ="]) {
            if !line.starts_with(' ') && line.contains(" =") {
                if let Some((name, right)) = lines.split_once(" =") {
                    let tokens = tokens(right);
                    let mut at = 0;
                    let node = choice(&tokens, &mut at);
                    assert_eq!(at, tokens.len(), "the rule {name} ends early");
                    assert!(rules.insert(name.to_string(), node).is_none(), "{name} is defined twice");
                }
                lines.clear();
            }
            lines.push_str(line);
            lines.push(' ');
        }
        assert!(rules.len() > 20, "only {} rules", rules.len());
        let mut grammar = Grammar { rules, depths: BTreeMap::new() };
        grammar.measure();
        grammar
    }

    /// Computes the depth of each rule by iteration: the depth of its shallowest alternative plus
    /// one.
    fn measure(&mut self) {
        loop {
            let known: Vec<(String, usize)> = self
                .rules
                .iter()
                .filter(|(name, _)| !self.depths.contains_key(*name))
                .filter_map(|(name, node)| Some((name.clone(), self.depth(node)? + 1)))
                .collect();
            if known.is_empty() {
                break;
            }
            self.depths.extend(known);
        }
        for name in self.rules.keys() {
            assert!(
                self.depths.contains_key(name),
                "the rule {name} never terminates or refers to an unknown rule"
            );
        }
    }

    fn depth(&self, node: &Node) -> Option<usize> {
        match node {
            Node::Rule(name) if lexical(name).is_some() => Some(0),
            Node::Rule(name) => self.depths.get(name).copied(),
            Node::Word(_) | Node::Optional(_) | Node::Repeat(_) => Some(0),
            Node::Sequence(parts) => parts.iter().map(|p| self.depth(p)).try_fold(0, |d, p| Some(d.max(p?))),
            Node::Choice(ways) => ways.iter().filter_map(|w| self.depth(w)).min(),
        }
    }

    /// Returns a random program of about this depth.
    pub fn program(&self, random: &mut Random, depth: usize) -> Vec<Piece> {
        let mut out = Vec::new();
        self.generate(&Node::Rule("file".into()), depth, random, &mut out, false);
        out
    }

    fn generate(&self, node: &Node, depth: usize, random: &mut Random, out: &mut Vec<Piece>, in_line: bool) {
        match node {
            Node::Word(word) => push(word, out, in_line),
            Node::Rule(name) => {
                if let Some(spellings) = lexical(name) {
                    return push(random.pick(spellings), out, in_line);
                }
                let start = out.len();
                let forbidden = NOT_FIRST.iter().find(|(rule, _)| rule == name).map(|(_, word)| *word);
                for attempt in 0.. {
                    assert!(attempt < 1000, "{name} always begins with {forbidden:?}");
                    out.truncate(start);
                    self.rule(name, depth.saturating_sub(1), random, out, in_line);
                    if forbidden.is_none() || out.get(start).map(|p| p.text.as_str()) != forbidden {
                        break;
                    }
                }
            }
            Node::Sequence(parts) => parts.iter().for_each(|p| self.generate(p, depth, random, out, in_line)),
            Node::Choice(ways) => {
                let possible: Vec<&Node> =
                    ways.iter().filter(|w| self.depth(w).is_some_and(|d| d <= depth)).collect();
                let way = match possible.as_slice() {
                    [] => ways.iter().min_by_key(|w| self.depth(w)).expect("a choice has ways"),
                    some => weighted(some, random),
                };
                self.generate(way, depth, random, out, in_line);
            }
            Node::Optional(part) => {
                if random.below(2) == 0 && self.depth(part).is_some_and(|d| d <= depth) {
                    self.generate(part, depth, random, out, in_line);
                }
            }
            Node::Repeat(part) => {
                while random.below(3) == 0 && self.depth(part).is_some_and(|d| d <= depth) {
                    self.generate(part, depth, random, out, in_line);
                }
            }
        }
    }

    fn rule(&self, name: &str, depth: usize, random: &mut Random, out: &mut Vec<Piece>, in_line: bool) {
        let start = out.len();
        // A string ends on its line, and a unit is on the line of its number.
        let one_line = in_line || matches!(name, "string" | "quantity" | "measure");
        self.generate(&self.rules[name], depth, random, out, one_line);
        if one_line && !in_line && start < out.len() {
            out[start].same_line = follows_jump(&out[..start]);
        }
    }
}

/// Returns one of the alternatives, at random by their weights.
fn weighted<'n>(ways: &[&'n Node], random: &mut Random) -> &'n Node {
    let total = ways.iter().map(|way| weight(way)).sum();
    let mut rest = random.below(total);
    for way in ways {
        match rest.checked_sub(weight(way)) {
            Some(left) => rest = left,
            None => return way,
        }
    }
    unreachable!("the rest is below the total")
}

fn weight(way: &Node) -> usize {
    let first = match way {
        Node::Sequence(parts) => parts.first(),
        other => Some(other),
    };
    let Some(Node::Rule(name)) = first else { return 1 };
    WEIGHTS.iter().find(|(rule, _)| rule == name).map_or(1, |(_, weight)| *weight)
}

fn push(text: &str, out: &mut Vec<Piece>, in_line: bool) {
    let same_line = in_line || follows_jump(out);
    out.push(Piece { text: text.into(), same_line });
}

/// Returns `true` if the next token would start another statement on a new line.
fn follows_jump(pieces: &[Piece]) -> bool {
    pieces.last().is_some_and(|p| matches!(p.text.as_str(), "return" | "throw"))
}

/// Returns the text of a program, with random blanks, line ends and comments between tokens.
pub fn written(pieces: &[Piece], random: &mut Random) -> String {
    let mut text = String::new();
    for piece in pieces {
        text.push_str(match random.below(20) {
            _ if piece.same_line => " ",
            0 => "\n",
            1 => "\n\n\n",
            2 => " /* between */ ",
            3 => " // behind\n",
            4 => "\n// before\n",
            5 => "\n/// documents\n",
            6 => "\t/* over\nlines */\n",
            _ => " ",
        });
        text.push_str(&piece.text);
    }
    text
}

fn tokens(rule: &str) -> Vec<String> {
    let mut tokens = Vec::new();
    let mut rest = rule.trim_start();
    while let Some(first) = rest.chars().next() {
        let length = match first {
            '"' | '\'' => rest[1..].find(first).expect("a word ends") + 2,
            c if c.is_alphanumeric() => {
                rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len())
            }
            _ => first.len_utf8(),
        };
        tokens.push(rest[..length].to_string());
        rest = rest[length..].trim_start();
    }
    tokens
}

fn choice(tokens: &[String], at: &mut usize) -> Node {
    let mut ways = vec![sequence(tokens, at)];
    while tokens.get(*at).is_some_and(|t| t == "|") {
        *at += 1;
        ways.push(sequence(tokens, at));
    }
    if ways.len() == 1 { ways.remove(0) } else { Node::Choice(ways) }
}

fn sequence(tokens: &[String], at: &mut usize) -> Node {
    let mut parts = Vec::new();
    while let Some(token) = tokens.get(*at).filter(|t| !matches!(t.as_str(), "|" | "]" | "}" | ")")) {
        *at += 1;
        parts.push(match token.as_str() {
            "[" | "{" | "(" => {
                let inner = choice(tokens, at);
                *at += 1;
                match token.as_str() {
                    "[" => Node::Optional(Box::new(inner)),
                    "{" => Node::Repeat(Box::new(inner)),
                    _ => inner,
                }
            }
            word if word.starts_with(['"', '\'']) => Node::Word(word[1..word.len() - 1].into()),
            rule => Node::Rule(rule.into()),
        });
    }
    if parts.len() == 1 { parts.remove(0) } else { Node::Sequence(parts) }
}
