//! Ambiguous names, which denote both a unit and a variable, in a product or quotient after a
//! number with a unit. In `3 N/m` after `var m`, both meanings are possible.

use super::*;

impl<'a> Resolver<'a> {
    /// Resolves the right operand of a product or quotient, and reports ambiguous names in it.
    pub(super) fn right_factor(&mut self, left: &'a Expr, right: &'a Expr) {
        match self.after_unit(left).filter(|_| self.is_unit_factor(right)) {
            Some(quantity) => self.unit_factor(right, Span { end: left.span.end, ..quantity }),
            None => self.expr(right),
        }
    }

    /// If an expression ends with a number and its units, returns the location of the number.
    fn after_unit(&self, e: &Expr) -> Option<Span> {
        let mut e = e;
        loop {
            e = match &e.kind {
                ExprKind::Quantity { .. } | ExprKind::Measured { .. } => return Some(e.span),
                ExprKind::Unary { op: UnaryOp::Plus | UnaryOp::Minus, operand } => operand,
                ExprKind::Binary { op: BinaryOp::Multiply | BinaryOp::Divide, left, right, .. } => {
                    match &right.kind {
                        ExprKind::Quantity { .. } | ExprKind::Measured { .. } => return Some(right.span),
                        _ if self.is_unit_factor(right) => left,
                        _ => return None,
                    }
                }
                _ => return None,
            }
        }
    }

    /// Returns `true` if an expression contains only units: `m`, `m^2`, `(mm*K)`.
    fn is_unit_factor(&self, e: &Expr) -> bool {
        match &e.kind {
            ExprKind::Name(name) => Unit::find(&name.name).is_some() || self.own_unit(&name.name).is_some(),
            ExprKind::Binary { op: BinaryOp::Power, left, .. } => self.is_unit_factor(left),
            ExprKind::Binary { op: BinaryOp::Multiply | BinaryOp::Divide, left, right, .. } => {
                self.is_unit_factor(left) && self.is_unit_factor(right)
            }
            ExprKind::Paren(inner) => self.is_unit_factor(inner),
            _ => false,
        }
    }

    /// Resolves a factor that contains only units. `quantity` is the preceding number with its
    /// units.
    fn unit_factor(&mut self, e: &'a Expr, quantity: Span) {
        match &e.kind {
            ExprKind::Name(name) => {
                self.name(name);
                self.refuse_ambiguous(name, quantity);
            }
            ExprKind::Binary { op: BinaryOp::Power, left, right, .. } => {
                self.unit_factor(left, quantity);
                self.expr(right);
            }
            ExprKind::Binary { left, right, .. } => {
                self.unit_factor(left, quantity);
                self.unit_factor(right, quantity);
            }
            ExprKind::Paren(inner) => self.unit_factor(inner, quantity),
            _ => self.expr(e),
        }
    }

    fn refuse_ambiguous(&mut self, name: &'a Ident, quantity: Span) {
        let found = self.scopes.iter().rev().find_map(|scope| scope.names.get(&name.name));
        let Some((res, declared)) = found.copied() else { return };
        let what = match res {
            Resolution::Var(id) => match self.names.variables[id.0 as usize].kind {
                VarKind::Parameter(_) => "parameter",
                _ => "variable",
            },
            Resolution::Param(_) => "param",
            Resolution::Const(_) => "constant",
            Resolution::Output(_) => "output",
            _ => return,
        };
        // A type for the name would only lead to further errors.
        self.names.uses.insert(name.span, Resolution::Unknown);
        let unit = self.other_spelling(&name.name);
        let text = |span: Span| {
            let module = self.modules.get(span.file.0 as usize)?;
            module.text.get(span.start as usize..span.end as usize)
        };
        let grouped = format!("({})", text(quantity).unwrap_or_default());
        let shown = match grouped.len() <= 40 {
            true => grouped.clone(),
            false => "(...)".to_string(),
        };
        let message = format!("`{}` is both a unit and the name of a {what} here", name.name);
        self.report(
            Diagnostic::error("E0518", message, name.span, format!("the unit, or the {what}?"))
                .label(declared, format!("the {what} `{}` is declared here", name.name))
                .help(format!(
                    "rename the {what}; or write `{unit}` for the unit, or parentheses as in `{shown}` before the \
                     operator for the {what}"
                ))
                .suggest(format!("mean the unit: `{unit}`"), name.span, unit)
                .suggest(format!("mean the {what}: `{shown}`"), quantity, grouped),
        );
    }

    /// Returns another spelling for a unit whose name is a variable: an alias, or `(1 name)`.
    fn other_spelling(&self, name: &str) -> String {
        let taken = |name: &str| self.scopes.iter().any(|scope| scope.names.contains_key(name));
        let spellings = Unit::find(name).into_iter().flat_map(|unit| unit.aliases.iter().chain([&unit.name]));
        match spellings.copied().find(|other| *other != name && !taken(other)) {
            Some(other) => other.to_string(),
            None => format!("(1 {name})"),
        }
    }
}
