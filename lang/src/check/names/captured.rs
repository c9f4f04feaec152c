//! Finds the values that an anonymous function captures: the largest parts of its expression that
//! use variables around it and none of its own parameters.
//!
//! Every such part becomes a further parameter of the function, whose argument is evaluated where
//! the function is passed. Inference, derivatives and lowering treat it like any other parameter.

use super::*;
use crate::check::expr::is_bare;
use crate::walk::Node;

/// The kinds of variables that an expression uses.
#[derive(Clone, Copy, Default)]
struct Used {
    /// Parameters of the anonymous function or of one inside it.
    own: bool,
    /// Variables around the anonymous function.
    outer: bool,
}

impl<'a> Resolver<'a> {
    /// Finds the values that an anonymous function captures. Its names are resolved.
    pub(super) fn capture(&mut self, decl: &'a FunctionDecl) {
        let Some(Resolution::Function(id)) = self.names.uses.get(&decl.name.span).copied() else { return };
        let FunctionBody::Symbolic(body) = &decl.body else { return };
        let around = std::mem::take(&mut self.names.functions[id.0 as usize].outer);
        around.into_iter().for_each(|variable| self.outer(variable));
        self.names.functions[id.0 as usize].computed = self.indexes_by_own(Node::Expression(body), id);
        let mut found = Vec::new();
        self.captured(body, id, &mut found);
        let mut variables: HashMap<VarId, VarId> = HashMap::default();
        for value in found {
            if let Some(points) = self.captured_points(value, id) {
                let hidden = self.captured_parameter(value, id);
                self.names.functions[id.0 as usize].captured.push((value, hidden));
                self.names.captured.insert((id, points), hidden);
                self.names.spline_points.insert(hidden);
                continue;
            }
            let outer = match &value.kind {
                ExprKind::Name(name) => match self.names.uses.get(&name.span) {
                    Some(Resolution::Var(outer)) => Some(*outer),
                    _ => None,
                },
                _ => None,
            };
            let hidden = match outer.and_then(|outer| variables.get(&outer)) {
                Some(hidden) => *hidden,
                None => {
                    let hidden = self.captured_parameter(value, id);
                    self.names.functions[id.0 as usize].captured.push((value, hidden));
                    variables.extend(outer.map(|outer| (outer, hidden)));
                    hidden
                }
            };
            self.names.captured.insert((id, value.span), hidden);
        }
    }

    /// Creates the parameter of an anonymous function for a captured value.
    fn captured_parameter(&mut self, value: &Expr, owner: FuncId) -> VarId {
        let module = self.modules.get(value.span.file.0 as usize);
        let text = module.and_then(|m| m.text.get(value.span.start as usize..value.span.end as usize));
        let is_short = |text: &&str| text.len() <= 40 && !text.contains('\n');
        let name = text.filter(is_short).unwrap_or("captured value").into();
        let (span, kind) = (value.span, VarKind::Parameter(Mode::In));
        self.names.variables.push(Variable { name, span, kind, owner, reads: 1 });
        VarId(self.names.variables.len() as u32 - 1)
    }

    /// Adds the captured parts of an expression in the anonymous function `function`.
    fn captured(&mut self, e: &'a Expr, function: FuncId, found: &mut Vec<&'a Expr>) {
        let used = self.used(Node::Expression(e), function);
        if !used.outer {
            return;
        }
        if !used.own && is_capturable(e) {
            found.push(e);
            return;
        }
        let before = found.len();
        let mut parts = Vec::new();
        match self.captured_points(e, function).and_then(|_| spline_arguments(e)) {
            Some([_, _, x]) => {
                found.push(e);
                parts.push(Node::Expression(x));
            }
            None => Node::Expression(e).children(&mut |child| parts.push(child)),
        }
        while let Some(part) = parts.pop() {
            match part {
                Node::Expression(part) => self.captured(part, function, found),
                Node::Argument(argument) => self.captured(&argument.value, function, found),
                Node::Parameter(_) | Node::Name(_) | Node::Type(_) | Node::Domain(_) | Node::Field(_) => {}
                Node::Statement(_) | Node::Variable(_) => part.children(&mut |child| parts.push(child)),
            }
        }
        let by_own = |symbol: &&Ident| match self.names.uses.get(&symbol.span) {
            Some(Resolution::Var(id)) => self.is_within(self.names.variables[id.0 as usize].owner, function),
            _ => false,
        };
        if let Some(missed) = found.get(before)
            && let Some(symbol) = self.differentiated_by(e).into_iter().find(|symbol| !by_own(symbol))
        {
            let diagnostic = Diagnostic::error(
                "E0920",
                format!(
                    "this would miss that a captured value may depend on `{}`: an anonymous function captures \
                     values",
                    symbol.name
                ),
                e.span,
                format!("needs the dependence on `{}`", symbol.name),
            )
            .label(missed.span, "captured as a value")
            .help(
                "declare a symbolic function of the values, `function f(in x, in a) := ...;`, with the \
                 derivative in its body or around its call",
            );
            self.report(diagnostic);
        }
    }

    /// Returns the location of the points of a spline if they use variables around the anonymous
    /// function `function` and none of its own, unlike the argument of the spline.
    fn captured_points(&self, e: &Expr, function: FuncId) -> Option<Span> {
        let ExprKind::Call { callee, .. } = &e.kind else { return None };
        let ExprKind::Name(name) = &callee.kind else { return None };
        let builtin = self.names.uses.get(&name.span);
        let [xs, ys, x] = spline_arguments(e)
            .filter(|_| matches!(builtin, Some(Resolution::Builtin(Builtin::Spline))))?
            .map(|argument| (argument, self.used(Node::Expression(argument), function)));
        let captured = (xs.1.outer || ys.1.outer) && !xs.1.own && !ys.1.own && x.1.own;
        captured.then(|| points_span(xs.0, ys.0))
    }

    /// Returns the symbols of a derivative, of a gradient, or of `e at symbol = value`.
    fn differentiated_by(&self, e: &'a Expr) -> Vec<&'a Ident> {
        let arguments = match &e.kind {
            ExprKind::At { symbol, .. } => return vec![symbol],
            ExprKind::Call { callee, arguments } => match &callee.kind {
                ExprKind::Name(name)
                    if matches!(
                        self.names.uses.get(&name.span),
                        Some(Resolution::Builtin(Builtin::Derivative | Builtin::Gradient))
                    ) =>
                {
                    arguments
                }
                _ => return Vec::new(),
            },
            _ => return Vec::new(),
        };
        let mut symbols = Vec::new();
        let mut left: Vec<&Expr> = arguments.get(1).iter().map(|argument| &argument.value).collect();
        while let Some(e) = left.pop() {
            match &e.kind {
                ExprKind::Name(name) => symbols.push(name),
                ExprKind::Paren(inner) => left.push(inner),
                ExprKind::List(all) => left.extend(all),
                _ => {}
            }
        }
        symbols
    }

    /// Returns an index or the limit of a slice that depends on arguments of the anonymous function
    /// `function`.
    fn indexes_by_own(&self, node: Node<'_>, function: FuncId) -> Option<Span> {
        let indices: Vec<&Expr> = match node {
            Node::Expression(Expr { kind: ExprKind::Index { index, .. }, .. }) => vec![index],
            Node::Expression(Expr { kind: ExprKind::Slice { low, high, .. }, .. }) => {
                low.iter().chain(high).map(|limit| &**limit).collect()
            }
            _ => Vec::new(),
        };
        let own = indices.into_iter().find(|index| self.used(Node::Expression(index), function).own);
        let mut found = own.map(|index| index.span);
        node.children(&mut |child| found = found.or_else(|| self.indexes_by_own(child, function)));
        found
    }

    fn used(&self, node: Node<'_>, function: FuncId) -> Used {
        let mut used = Used::default();
        if let Node::Expression(Expr { kind: ExprKind::Name(name), .. }) = node
            && let Some(Resolution::Var(id)) = self.names.uses.get(&name.span)
        {
            match self.is_within(self.names.variables[id.0 as usize].owner, function) {
                true => used.own = true,
                false => used.outer = true,
            }
        }
        node.children(&mut |child| {
            let of_part = self.used(child, function);
            used = Used { own: used.own || of_part.own, outer: used.outer || of_part.outer };
        });
        used
    }

    /// Returns `true` if a function is `around`, or inside of it.
    fn is_within(&self, function: FuncId, around: FuncId) -> bool {
        let mut at = Some(function);
        while let Some(id) = at.filter(|id| *id != around) {
            at = self.names.functions[id.0 as usize].parent;
        }
        at.is_some()
    }
}

/// Returns the arguments of a call of `spline`, in the order of its parameters.
fn spline_arguments(e: &Expr) -> Option<[&Expr; 3]> {
    let ExprKind::Call { arguments, .. } = &e.kind else { return None };
    let mut found = [None; 3];
    for (at, argument) in arguments.iter().enumerate() {
        let at = match &argument.name {
            Some((name, _)) => ["xs", "ys", "x"].iter().position(|parameter| *parameter == name.name)?,
            None => at,
        };
        *found.get_mut(at).filter(|_| !argument.spread)? = Some(&argument.value);
    }
    let [xs, ys, x] = found;
    Some([xs?, ys?, x?])
}

/// Returns the location of the points of a spline. It contains a comma, so no expression has it.
pub(in crate::check) fn points_span(xs: &Expr, ys: &Expr) -> Span {
    Span { start: xs.span.start.min(ys.span.start), end: xs.span.end.max(ys.span.end), ..xs.span }
}

/// Returns `true` if an expression may be evaluated where the anonymous function is passed. The
/// dimension of a literal in brackets or in a branch depends on its place.
fn is_capturable(e: &Expr) -> bool {
    match &e.kind {
        ExprKind::If { then, otherwise, .. } => ![then, otherwise].into_iter().any(|e| is_bare(e)),
        ExprKind::Paren(inner) => is_capturable(inner),
        ExprKind::Name(_)
        | ExprKind::Field { .. }
        | ExprKind::Call { .. }
        | ExprKind::Index { .. }
        | ExprKind::Slice { .. }
        | ExprKind::Unary { .. }
        | ExprKind::Binary { .. }
        | ExprKind::String(_)
        | ExprKind::At { .. }
        | ExprKind::IsNone { .. } => true,
        _ => false,
    }
}
