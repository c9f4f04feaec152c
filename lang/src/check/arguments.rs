//! Matches the arguments of a call to parameters.

use super::infer::Checker;
use super::symbols::similar;
use super::tree::Expr;
use crate::ast::{self, Bind, ExprKind};
use crate::diagnostic::Diagnostic;
use crate::hashed::HashMap;
use crate::span::Span;
use std::cmp::Reverse;

/// The argument of each parameter, and the fields of spread records by name.
pub(super) type MatchedArguments<'a> = (Vec<Option<&'a ast::Argument>>, HashMap<String, Expr>);

impl<'a> Checker<'a> {
    /// Returns the arguments of a function's parameters and the fields of spread records by name.
    /// Returns `None` if they do not match, which is reported.
    pub(super) fn given(
        &mut self,
        called: &str,
        decl: &ast::FunctionDecl,
        arguments: &'a [ast::Argument],
        span: Span,
    ) -> Option<MatchedArguments<'a>> {
        let names = decl.parameter_names();
        self.note_arguments(&names, arguments);
        let fields = self.spread(called, &names, arguments)?;
        let optional = |p: &ast::Parameter| matches!(p.default, Some((_, Some(_))));
        let parameters: Vec<(&str, bool)> = decl
            .parameters
            .iter()
            .map(|p| (p.name.name.as_str(), optional(p) || fields.contains_key(p.name.name.as_str())))
            .collect();
        let reported = self.diagnostics.len();
        let matched = self.match_arguments(called, &parameters, arguments, span);
        if matched.is_none() {
            self.explain_symbols(reported, decl, arguments);
        }
        Some((matched?, fields))
    }

    /// Names the parameters whose documentation has an unknown argument name as a symbol, such as
    /// `z` for `teeth`, in the diagnostics from `reported` on.
    fn explain_symbols<'d>(
        &mut self,
        reported: usize,
        decl: &'d ast::FunctionDecl,
        arguments: &[ast::Argument],
    ) {
        for (name, _) in arguments.iter().filter_map(|argument| argument.name.as_ref()) {
            let new = self.diagnostics.get_mut(reported..).unwrap_or_default();
            let unknown = |d: &&mut Diagnostic| d.code == "E0205" && d.primary.span == name.span;
            let Some(problem) = new.iter_mut().find(unknown) else { continue };
            // A spelling of a parameter's name, or of the name of another quantity in
            // documentation.
            if decl.parameters.iter().any(|parameter| has_symbol(&parameter.name.name, &name.name)) {
                continue;
            }
            // The documentation of a declaration is reduced to symbols; see `Item`.
            let symbols = |parameter: &'d ast::Parameter| {
                let (own, others) = parameter.doc.as_deref()?.split_once(". ")?;
                Some((parameter.name.name.as_str(), own, others))
            };
            let all: Vec<(&str, &str, &str)> = decl.parameters.iter().filter_map(symbols).collect();
            let own: Vec<&str> = all
                .iter()
                .filter(|(_, own, _)| has_symbol(own, &name.name))
                .map(|(near, ..)| *near)
                .collect();
            let related = all.iter().find(|(_, _, others)| has_symbol(others, &name.name));
            let plain = Diagnostic { fix: None, suggestions: Vec::new(), ..problem.clone() };
            *problem = match (&own[..], related) {
                ([near], _) => plain.help(format!("did you mean `{near}`?")).fix(
                    format!("change to `{near}`"),
                    name.span,
                    *near,
                ),
                ([others @ .., last], _) => {
                    plain.help(format!("did you mean `{}` or `{last}`?", others.join("`, `")))
                }
                ([], Some((related, ..))) => plain.help(format!(
                    "`{related}` determines `{}`; `calyx doc` has its documentation",
                    name.name
                )),
                ([], None) => continue,
            };
        }
    }

    /// Matches arguments to parameters, each with its name and `true` if it is optional. `None`
    /// stands for a default; errors are reported.
    pub(super) fn match_arguments(
        &mut self,
        function: &str,
        parameters: &[(&str, bool)],
        arguments: &'a [ast::Argument],
        span: Span,
    ) -> Option<Vec<Option<&'a ast::Argument>>> {
        let mut given: Vec<Option<&ast::Argument>> = vec![None; parameters.len()];
        let mut named = false;
        let mut sound = true;
        for (index, argument) in arguments.iter().enumerate() {
            let at = match &argument.name {
                // The caller handles spread arguments.
                _ if argument.spread => {
                    named = true;
                    continue;
                }
                Some((name, _)) => {
                    named = true;
                    let current = self.current_name(name);
                    match parameters.iter().position(|(parameter, _)| *parameter == current) {
                        Some(at) => at,
                        None => {
                            let named = self.named_parameters(arguments);
                            let error = unknown_parameter(function, name, parameters, &named);
                            self.report(error);
                            sound = false;
                            continue;
                        }
                    }
                }
                None if self.is_decimal_comma(arguments, index, named || index >= parameters.len()) => {
                    sound = false;
                    continue;
                }
                None if named => {
                    let named = self.named_parameters(arguments);
                    let error = unnamed_after_named(argument, parameters, &given, &named);
                    self.report(error);
                    sound = false;
                    continue;
                }
                None if index >= parameters.len() => {
                    self.report(extra_argument(function, argument, parameters, arguments.len()));
                    sound = false;
                    break;
                }
                None => index,
            };
            if let Some(first) = given[at] {
                let before = index.checked_sub(1).and_then(|before| arguments.get(before));
                self.report(second_occurrence(parameters[at].0, first, before, argument));
                sound = false;
                continue;
            }
            given[at] = Some(argument);
        }
        let missing: Vec<String> = parameters
            .iter()
            .zip(&given)
            .filter(|((_, optional), argument)| argument.is_none() && !optional)
            .map(|((name, _), _)| format!("`{name}`"))
            .collect();
        if !missing.is_empty() && sound {
            self.report(
                Diagnostic::error(
                    "E0206",
                    format!("the call of `{function}` lacks {}", missing.join(" and ")),
                    span,
                    "an argument is missing",
                )
                .help(format!("its parameters are {}", listed(parameters))),
            );
            sound = false;
        }
        if !sound {
            self.check_loosely(arguments);
        }
        sound.then_some(given)
    }

    /// Returns the current names of the parameters that arguments name.
    fn named_parameters<'n>(&'n self, arguments: &'n [ast::Argument]) -> Vec<&'n str> {
        let names = arguments.iter().filter_map(|argument| argument.name.as_ref());
        names.map(|(name, _)| self.current_name(name)).collect()
    }

    /// Reports a decimal comma if an argument without a parameter is the fraction of the previous
    /// number. Returns `true` if reported.
    fn is_decimal_comma(
        &mut self,
        arguments: &[ast::Argument],
        index: usize,
        has_no_parameter: bool,
    ) -> bool {
        let before = index.checked_sub(1).and_then(|before| arguments.get(before));
        let (Some(before), Some(argument)) = (before, arguments.get(index)) else { return false };
        let ExprKind::Number(_) = &before.value.kind else { return false };
        let (first, second) = (before.value.span, argument.value.span);
        let number = match &argument.value.kind {
            ExprKind::Number(_) => second,
            ExprKind::Quantity { unit, .. } => Span { end: unit.span.start, ..second },
            _ => return false,
        };
        let between = Span { start: first.end, end: second.start, ..first };
        if !has_no_parameter || self.text(between) != "," {
            return false;
        }
        let number = self.text(number).trim_end();
        let whole = Span { end: second.start + number.len() as u32, ..first };
        let problem = Diagnostic::decimal_comma(whole, self.text(first), number);
        problem.map(|problem| self.report(problem)).is_some()
    }

    /// Checks the arguments of an invalid call, to report errors in them.
    pub(super) fn check_loosely(&mut self, arguments: &'a [ast::Argument]) {
        for argument in arguments {
            let symbolic = matches!(argument.name, Some((_, Bind::Symbolic)));
            let around = self.symbolic;
            self.symbolic |= symbolic;
            self.whole(&argument.value);
            self.symbolic = around;
        }
    }
}

/// Returns `true` if one of some symbols is `name`, with or without underscores.
fn has_symbol(symbols: &str, name: &str) -> bool {
    let plain = |text: &str| text.replace('_', "");
    symbols.split_whitespace().any(|symbol| plain(symbol) == plain(name))
}

fn listed(parameters: &[(&str, bool)]) -> String {
    parameters.iter().map(|(name, _)| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

fn unknown_parameter(
    function: &str,
    name: &ast::Ident,
    parameters: &[(&str, bool)],
    named: &[&str],
) -> Diagnostic {
    let diagnostic = Diagnostic::error(
        "E0205",
        format!("`{function}` has no parameter `{}`", name.name),
        name.span,
        "unknown parameter",
    );
    // A misspelt name cannot refer to a parameter that already has an argument.
    let free = parameters.iter().map(|(name, _)| *name).filter(|name| !named.contains(name));
    match similar(&name.name, free) {
        Some(near) => diagnostic.help(format!("did you mean `{near}`?")).fix(
            format!("change to `{near}`"),
            name.span,
            near,
        ),
        None => diagnostic.help(parameters_near(&name.name, parameters, named)),
    }
}

/// Number of parameters up to which all of them are listed.
const MOST_LISTED: usize = 8;
/// Number of parameters that are suggested for a name.
const MOST_NEAR: usize = 3;

/// Names the parameters that have a word in common with an unknown name. If there are none, lists
/// all parameters; if there are many, those without an argument, and first those that the call
/// lacks.
fn parameters_near(name: &str, parameters: &[(&str, bool)], named: &[&str]) -> String {
    let words = |name: &str| name.split('_').map(str::to_lowercase).collect::<Vec<_>>();
    let own = words(name);
    let in_common = |parameter: &str| {
        words(parameter).iter().filter(|word| own.iter().any(|own| same_word(own, word))).count()
    };
    let free: Vec<(&str, bool)> =
        parameters.iter().filter(|(parameter, _)| !named.contains(parameter)).copied().collect();
    let mut near: Vec<(usize, &str)> =
        free.iter().map(|(parameter, _)| (in_common(parameter), *parameter)).collect();
    near.retain(|(count, _)| *count > 0);
    near.sort_by_key(|(count, parameter)| (Reverse(*count), parameter.split('_').count()));
    let near: Vec<String> =
        near.iter().take(MOST_NEAR).map(|(_, parameter)| format!("`{parameter}`")).collect();
    let needed: Vec<(&str, bool)> = free.iter().filter(|(_, optional)| !optional).copied().collect();
    match &near[..] {
        [only] => format!("did you mean {only}?"),
        [others @ .., last] => format!("did you mean {} or {last}?", others.join(", ")),
        [] if parameters.len() <= MOST_LISTED => format!("its parameters are {}", listed(parameters)),
        [] if needed.is_empty() => format!("its other parameters are {}", listed(&free)),
        [] => {
            let others: Vec<(&str, bool)> = free.iter().filter(|(_, optional)| *optional).copied().collect();
            format!("the call lacks {}; the other parameters are {}", listed(&needed), listed(&others))
        }
    }
}

/// Returns `true` for two forms of a word, such as `ball` and `balls` or `tooth` and `teeth`.
fn same_word(one: &str, other: &str) -> bool {
    let [short, long] = if one.len() <= other.len() { [one, other] } else { [other, one] };
    let slips = if short.len() < 5 { 1 } else { 2 };
    let near = one.chars().next() == other.chars().next() && strsim::damerau_levenshtein(one, other) <= slips;
    short.len() > 2 && (long == short || near)
}

fn unnamed_after_named(
    argument: &ast::Argument,
    parameters: &[(&str, bool)],
    given: &[Option<&ast::Argument>],
    named: &[&str],
) -> Diagnostic {
    let place = Span { end: argument.value.span.start, ..argument.value.span };
    let free = parameters
        .iter()
        .zip(given)
        .filter(|((name, optional), given)| given.is_none() && !optional && !named.contains(name));
    let diagnostic = Diagnostic::error(
        "E0206",
        "an argument without a name follows a named argument",
        argument.value.span,
        "which parameter is this?",
    )
    .help("name it, or move it to the front");
    let offer = |diagnostic: Diagnostic, name: &str| {
        diagnostic.suggest(format!("name it `{name}`"), place, format!("{name} = "))
    };
    free.take(3).fold(diagnostic, |d, ((name, _), _)| offer(d, name))
}

/// Returns the error for an argument beyond the last parameter; `arguments` is the number of
/// arguments.
fn extra_argument(
    function: &str,
    argument: &ast::Argument,
    parameters: &[(&str, bool)],
    arguments: usize,
) -> Diagnostic {
    let help = match parameters.len() {
        0 => "it has no parameters".to_string(),
        _ => format!("its parameters are {}", listed(parameters)),
    };
    Diagnostic::error(
        "E0206",
        match parameters.len() {
            1 => format!("`{function}` takes 1 argument, not {arguments}"),
            count => format!("`{function}` takes {count} arguments, not {arguments}"),
        },
        argument.value.span,
        "extra argument",
    )
    .help(help)
}

/// Returns the error for two arguments of one parameter. Its fix removes the second one from the
/// end of the argument before it.
fn second_occurrence(
    parameter: &str,
    first: &ast::Argument,
    before: Option<&ast::Argument>,
    argument: &ast::Argument,
) -> Diagnostic {
    let removed = Span {
        start: before.map_or(argument.value.span.start, |before| before.value.span.end),
        ..argument.value.span
    };
    let written = |argument: &ast::Argument| Some(argument.name.as_ref()?.0.name.clone());
    let message = match (written(first), written(argument)) {
        (Some(one), Some(other)) if one != other => {
            format!("`{one}` and `{other}` are names of the same argument")
        }
        _ => format!("the argument `{parameter}` occurs twice"),
    };
    Diagnostic::error("E0206", message, argument.value.span, "second occurrence")
        .label(first.value.span, "first occurrence")
        .help("remove one of the two")
        .suggest(format!("remove this `{parameter}`"), removed, "")
}
