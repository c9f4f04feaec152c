//! Maps the name of an argument to the source location where the argument is written.

use crate::traverse::for_each_expression;
use calyx_abi::RuntimeError;
use calyx_abi::attribution::attribute;
use calyx_abi::description::{CallDescription, LIBRARY};
use calyx_abi::error::{Call, Place};
use calyx_lang::ir::{Expr, ExprKind, Function, FunctionId, Mode, Program, Statement, Terminator};
use calyx_lang::span::Span;
use std::collections::{BTreeSet, HashMap, HashSet};

/// Number of chains of calls above which a finding stays at its location in the library.
const MOST_CHAINS: usize = 64;

/// The source locations of the arguments of all calls of engine and library functions.
#[derive(Clone, Debug, Default)]
pub struct CallSites {
    /// Calls by source location.
    calls: HashMap<Place, CallDescription>,
    /// File indices of the library.
    library: HashSet<u32>,
    /// The library function that contains a call, by the locations of the call and its arguments.
    inside: HashMap<Place, Place>,
    /// Library functions by location: the name, and the locations of the calls.
    callers: HashMap<Place, (String, BTreeSet<Place>)>,
    /// Calls that create instances of components, by the path of the instance.
    instances: HashMap<String, Call>,
}

impl CallSites {
    pub fn new(program: &Program) -> Self {
        let files = program.files.iter().enumerate();
        let library = files.filter(|(_, file)| file.name.starts_with(LIBRARY));
        let mut sites =
            CallSites { library: library.map(|(index, _)| index as u32).collect(), ..CallSites::default() };
        for function in &program.functions {
            // Only library functions forward blame to their callers.
            let carried =
                if sites.is_library(function.span) { carried(function) } else { TracedParameters::default() };
            for_each_expression(function, &mut |expr| match &expr.kind {
                ExprKind::CallExtern(id, arguments) => {
                    let Some(declaration) = program.externs.get(id.0 as usize) else { return };
                    let names = declaration.parameters.iter().map(|(name, _)| name.as_str());
                    let (called, within) = (&declaration.name, function.span);
                    sites.add(called, expr.span, names.zip(arguments), &carried, within);
                }
                ExprKind::Call(callee, arguments) => {
                    sites.add_call(program, *callee, arguments, expr.span, &carried, function.span);
                }
                _ => {}
            });
            for block in &function.blocks {
                for statement in &block.statements {
                    if let Statement::Call { function: callee, arguments, span, .. } = statement {
                        sites.add_call(program, *callee, arguments, *span, &carried, function.span);
                    }
                }
                if let Terminator::Throw { error, span, .. } = &block.terminator
                    && sites.is_library(*span)
                    && !sites.calls.contains_key(&place(*span))
                {
                    sites.add("", *span, std::iter::once(("", error)), &carried, function.span);
                }
            }
        }
        sites
    }

    fn is_library(&self, span: Span) -> bool {
        self.library.contains(&span.file.0)
    }

    /// Adds a call of a program function; only calls of library functions are recorded.
    fn add_call(
        &mut self,
        program: &Program,
        callee: FunctionId,
        arguments: &[Expr],
        span: Span,
        carried: &TracedParameters,
        around: Span,
    ) {
        let Some(callee) = program.functions.get(callee.0 as usize) else { return };
        let call = Call { function: callee.name.clone(), place: place(span) };
        if let Some(path) = call.instance() {
            self.instances.insert(path.to_owned(), call);
        }
        if !self.is_library(callee.span) {
            return;
        }
        let callers = self.callers.entry(place(callee.span)).or_default();
        callers.0.clone_from(&callee.name);
        callers.1.insert(place(span));
        let passed = callee.parameters.iter().filter(|(_, mode)| *mode != Mode::Out);
        let names = passed.map(|(local, _)| callee.locals.get(local.0 as usize).map_or("", |l| &l.name));
        self.add(&callee.name, span, names.zip(arguments), carried, around);
    }

    fn add<'e>(
        &mut self,
        function: &str,
        span: Span,
        arguments: impl Iterator<Item = (&'e str, &'e Expr)>,
        carried: &TracedParameters,
        around: Span,
    ) {
        let call = place(span);
        let mut described = CallDescription {
            place: call,
            arguments: Vec::new(),
            carried: Vec::new(),
            function: function.into(),
        };
        for (name, argument) in arguments {
            let at = place(argument.span);
            // A default argument has no location in the call: its text is in the declaration. A
            // variable of an enclosing function has the location of the call.
            if at.0 == call.0 && at.1 >= call.1 && at.2 <= call.2 && at != call {
                described.arguments.push((name.into(), at));
            }
            let names = carried.by(argument);
            if !names.is_empty() {
                described.carried.push((name.into(), names));
            }
        }
        if self.is_library(span) {
            // An error may already have been moved to the argument.
            for (_, at) in &described.arguments {
                self.inside.entry(*at).or_insert_with(|| place(around));
            }
            self.inside.insert(call, place(around));
        }
        self.calls.insert(call, described);
    }

    /// Returns all calls in order of location, for programs that embed the engine without a
    /// compiler.
    pub fn describe(&self) -> Vec<CallDescription> {
        let is_needed = |call: &&CallDescription| !call.arguments.is_empty() || !call.carried.is_empty();
        let mut described: Vec<_> = self.calls.values().filter(is_needed).cloned().collect();
        described.sort_by_key(|call| call.place);
        described
    }

    /// Moves an error to the responsible argument; see [`calyx_abi::attribution::attribute`].
    ///
    /// If several chains of calls may have led to the location and different arguments of the
    /// program are at fault in them, the error moves to the call.
    pub fn blame(&self, error: &mut RuntimeError) {
        let mut chains = match (error.place, error.details.calls.is_empty()) {
            (Some(at), true) if self.library.contains(&at.0) => self.chains(at, error.details.library_call),
            _ => Vec::new(),
        };
        if chains.is_empty() {
            chains.push(Vec::new());
        }
        let blamed = |calls: Vec<Call>| {
            let (mut error, at) = (error.clone(), calls.last().map(|call| call.place));
            error.details.calls.extend(calls);
            // A finding has no call stack of its own.
            if !error.details.calls.iter().any(|call| call.instance().is_some()) {
                error.details.calls.extend(self.instance_calls(&error.details.instance));
            }
            attribute(&mut error, self.calls.values(), |file| self.library.contains(&file));
            (error, at)
        };
        let all: Vec<_> = chains.into_iter().map(blamed).collect();
        let Some((mut first, call)) = all.first().cloned() else { return };
        let differs =
            |(other, _): &(RuntimeError, _)| (other.place, &other.argument) != (first.place, &first.argument);
        if let (true, Some(call)) = (all.iter().any(differs), call) {
            let described = self.calls.get(&call);
            first.details.function = described.map_or_else(String::new, |call| call.function.clone());
            (first.place, first.argument) = (Some(call), None);
        }
        *error = first;
    }

    /// Returns the calls that create an instance and the instances around it, innermost first.
    fn instance_calls(&self, path: &str) -> Vec<Call> {
        let around =
            std::iter::successors(Some(path), |path| path.rsplit_once('.').map(|(around, _)| around));
        around.filter_map(|path| self.instances.get(path).cloned()).collect()
    }

    /// Returns the chains of calls that lead to a location in the library, innermost call first, if
    /// all of them begin at the same location of the program, or those that begin at `start`.
    /// Findings that are not errors carry no call chain.
    fn chains(&self, at: Place, start: Option<Place>) -> Vec<Vec<Call>> {
        let Some(first) = self.inside.get(&at) else { return Vec::new() };
        let mut waiting: Vec<(Place, Vec<Call>)> = vec![(*first, Vec::new())];
        let mut found: Vec<Vec<Call>> = Vec::new();
        while let Some((function, chain)) = waiting.pop() {
            let Some((name, callers)) = self.callers.get(&function) else { continue };
            for caller in callers {
                // A recursive call adds no cause.
                if chain.iter().any(|call| call.place == *caller) {
                    continue;
                }
                let mut chain = chain.clone();
                chain.push(Call { function: name.clone(), place: *caller });
                match self.inside.get(caller) {
                    Some(around) if self.library.contains(&caller.0) => waiting.push((*around, chain)),
                    _ => found.push(chain),
                }
            }
            if found.len() + waiting.len() > MOST_CHAINS {
                return Vec::new();
            }
        }
        let outermost = |chain: &Vec<Call>| chain.last().map(|call| call.place);
        if start.is_some() && found.iter().any(|chain| outermost(chain) == start) {
            found.retain(|chain| outermost(chain) == start);
        }
        if found.windows(2).any(|pair| outermost(&pair[0]) != outermost(&pair[1])) {
            return Vec::new();
        }
        found
    }
}

/// The function parameters from which each local is computed, on any path.
#[derive(Default)]
struct TracedParameters {
    /// Names of parameters, for each local.
    names: Vec<Vec<String>>,
}

impl TracedParameters {
    /// Returns the parameters from which a value is computed, in order of occurrence.
    fn by(&self, value: &Expr) -> Vec<String> {
        let mut names = Vec::new();
        if self.names.is_empty() {
            return names;
        }
        crate::traverse::for_each_part(value, &mut |part| {
            let ExprKind::Local(local) = &part.kind else { return };
            for name in self.names.get(local.0 as usize).into_iter().flatten() {
                if !names.contains(name) {
                    names.push(name.clone());
                }
            }
        });
        names
    }
}

fn carried(function: &Function) -> TracedParameters {
    let mut carried = TracedParameters { names: vec![Vec::new(); function.locals.len()] };
    for (local, _) in &function.parameters {
        if let Some(known) = function.locals.get(local.0 as usize) {
            carried.names[local.0 as usize] = vec![known.name.clone()];
        }
    }
    // The sets of names only grow, so the loop terminates.
    loop {
        let mut grown = false;
        for statement in function.blocks.iter().flat_map(|block| &block.statements) {
            let (target, values): (_, Vec<&Expr>) = match statement {
                Statement::Assign { place, value, .. } | Statement::Push { place, value, .. } => {
                    (place, vec![value])
                }
                Statement::Call { result: Some(place), arguments, .. } => (place, arguments.iter().collect()),
                Statement::Host { result: place, arguments, .. } => (place, arguments.iter().collect()),
                Statement::Call { result: None, .. } | Statement::Eval(_) => continue,
            };
            let names: Vec<String> = values.into_iter().flat_map(|value| carried.by(value)).collect();
            let Some(known) = carried.names.get_mut(target.local.0 as usize) else { continue };
            for name in names {
                if !known.contains(&name) {
                    known.push(name);
                    grown = true;
                }
            }
        }
        if !grown {
            return carried;
        }
    }
}

fn place(span: Span) -> Place {
    (span.file.0, span.start, span.end)
}
