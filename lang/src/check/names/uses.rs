//! Resolves uses of names in expressions, types and units, and reports undeclared names.

use super::*;
use crate::check::former_names::{self, DeclaredName};
use crate::check::other_modules;

/// Number of diagnostics after which unknown names get no suggestions.
const MOST_SUGGESTIONS: usize = 200;

impl<'a> Resolver<'a> {
    /// Resolves records and dimensions in a type. Other names may be built-in types.
    pub(super) fn type_expr(&mut self, annotation: &'a TypeExpr) {
        match &annotation.kind {
            TypeKind::Name(name) => {
                let found = self.scopes.iter().rev().find_map(|scope| scope.names.get(&name.name)).copied();
                match found {
                    Some((
                        res @ (Resolution::Record(_) | Resolution::Enum(_) | Resolution::Dimension(_)),
                        _,
                    )) => {
                        self.names.uses.insert(name.span, res);
                        self.report_former(name, res);
                    }
                    // The type of the instances of a component.
                    Some((res @ Resolution::Function(id), _))
                        if self.names.functions[id.0 as usize].is_component() =>
                    {
                        self.names.uses.insert(name.span, res);
                        self.names.functions[self.function.0 as usize].callees.insert(id);
                    }
                    _ => {}
                }
            }
            TypeKind::Member(module, name) => {
                let res = self.lookup(module);
                self.names.uses.insert(module.span, res);
                let handle = match res {
                    Resolution::Module(index) => {
                        let module = &self.modules[index as usize].name;
                        !self.exports[index as usize].contains_key(&name.name)
                            && self.around.has_handle(module, &name.name)
                    }
                    _ => false,
                };
                if !handle {
                    self.member(module, res, name);
                }
            }
            TypeKind::Apply(_, parts) => parts.iter().for_each(|part| self.type_expr(part)),
            TypeKind::Product(a, b) | TypeKind::Quotient(a, b) => {
                self.type_expr(a);
                self.type_expr(b);
            }
            TypeKind::Power(base, ..) => self.type_expr(base),
            TypeKind::Function(parameters, result) => {
                parameters.iter().for_each(|part| self.type_expr(part));
                self.type_expr(result);
            }
            TypeKind::Error => {}
        }
    }

    /// Returns the unit with a name after a number or in a format, if the program declares it.
    pub(super) fn own_unit(&self, name: &str) -> Option<Resolution> {
        let unit = |res: &Resolution| matches!(res, Resolution::OwnUnit(_)).then_some(*res);
        let mut files = self.scopes.iter().take(2).rev();
        let own = files.find_map(|scope| scope.names.get(name).and_then(|(res, _)| unit(res)));
        // Units of imported modules, including indirect imports.
        own.or_else(|| (2..self.exports.len()).find_map(|module| self.exported_unit(module, name)))
    }

    pub(super) fn exported_unit(&self, module: usize, name: &str) -> Option<Resolution> {
        let (res, _) = self.exports[module].get(name)?;
        let public = !self.private[module].contains(name);
        (public && matches!(res, Resolution::OwnUnit(_))).then_some(*res)
    }

    /// Resolves a unit after a number.
    pub(super) fn quantity(&mut self, unit: &'a Ident) {
        let known = Unit::find(&unit.name).map(Resolution::Unit).or_else(|| self.own_unit(&unit.name));
        self.names.uses.extend(known.map(|res| (unit.span, res)));
        let hidden = self.scopes.iter().rev().find_map(|scope| scope.names.get(&unit.name));
        if let Some((hidden @ (Resolution::Var(_) | Resolution::Param(_) | Resolution::Const(_)), declared)) =
            hidden.copied()
            && known.is_some()
        {
            if let Resolution::Var(id) = hidden {
                self.names.hidden_by_units.insert(id);
            }
            let before = Span { end: unit.span.start, ..unit.span };
            let message = format!("`{0}` after a number is the unit, not the declared `{0}`", unit.name);
            self.report(
                Diagnostic::warning("W0205", message, unit.span, "the unit")
                    .label(declared, "this declaration is not used")
                    .help(format!("write `*` to multiply by it: `2*{}`, or choose another name", unit.name))
                    .suggest(format!("multiply by `{}`", unit.name), before, "* "),
            );
        }
    }

    /// Resolves a product of units in a format, where all names are units.
    pub(super) fn unit_product(&mut self, e: &'a Expr) {
        match &e.kind {
            ExprKind::Name(name) => {
                let unit = Unit::find(&name.name).map(Resolution::Unit).or_else(|| self.own_unit(&name.name));
                self.names.uses.insert(name.span, unit.unwrap_or(Resolution::Unknown));
            }
            ExprKind::Binary { left, right, .. } => {
                self.unit_product(left);
                self.unit_product(right);
            }
            ExprKind::Paren(inner) | ExprKind::Unary { operand: inner, .. } => self.unit_product(inner),
            _ => {}
        }
    }

    /// Resolves what follows `in` of an output: a product of units, or an enumeration.
    pub(super) fn output_unit(&mut self, e: &'a Expr) {
        let is_enum = |name: &Ident| {
            let found = self.scopes.iter().rev().find_map(|scope| scope.names.get(&name.name));
            matches!(found, Some((Resolution::Enum(_), _)))
        };
        match &e.kind {
            ExprKind::Name(name) if is_enum(name) => self.expr(e),
            ExprKind::Field { .. } => self.expr(e),
            _ => self.unit_product(e),
        }
    }

    pub(super) fn outer(&mut self, id: VarId) {
        if self.names.variables[id.0 as usize].owner != self.function {
            self.names.functions[self.function.0 as usize].outer.insert(id);
        }
    }

    pub(super) fn expr(&mut self, e: &'a Expr) {
        match &e.kind {
            ExprKind::Error | ExprKind::Number(_) | ExprKind::Bool(_) => {}
            ExprKind::Quantity { unit, .. } => self.quantity(unit),
            ExprKind::String(parts) => {
                for part in parts {
                    if let StringPart::Value(value, format) = part {
                        self.expr(value);
                        if let Some(unit) = format.as_ref().and_then(|format| format.unit.as_ref()) {
                            self.unit_product(unit);
                        }
                    }
                }
            }
            ExprKind::Name(name) => self.name(name),
            ExprKind::Field { base, field } => self.field(base, field),
            ExprKind::Call { callee, arguments } => {
                self.expr(callee);
                for argument in arguments {
                    self.expr(&argument.value);
                    self.unquoted_text(callee, argument);
                }
            }
            ExprKind::Index { base, index } => {
                self.expr(base);
                self.expr(index);
            }
            ExprKind::Slice { base, low, high } => {
                self.expr(base);
                low.iter().chain(high).for_each(|limit| self.expr(limit));
            }
            ExprKind::Unary { operand, .. } => self.expr(operand),
            ExprKind::Binary { op: BinaryOp::Multiply | BinaryOp::Divide, left, right, .. } => {
                self.expr(left);
                self.right_factor(left, right);
            }
            ExprKind::Binary { left, right, .. } => {
                self.expr(left);
                self.expr(right);
            }
            ExprKind::List(elements) => elements.iter().for_each(|e| self.expr(e)),
            ExprKind::Measured { elements, unit, .. } => {
                elements.iter().for_each(|e| self.expr(e));
                self.quantity(unit);
            }
            ExprKind::Comprehension(parts) => {
                self.values(&parts.values);
                self.scoped(|r| {
                    r.element(&parts.variable);
                    parts.condition.iter().for_each(|e| r.expr(e));
                    r.expr(&parts.element);
                });
            }
            ExprKind::If { condition, then, otherwise } => {
                self.expr(condition);
                self.expr(then);
                self.expr(otherwise);
            }
            ExprKind::At { value, symbol, at } => {
                self.expr(value);
                self.name(symbol);
                self.expr(at);
            }
            ExprKind::Paren(inner) | ExprKind::IsNone { value: inner, .. } => self.expr(inner),
            ExprKind::Anonymous(decl) => {
                let around = self.scopes.len();
                // The name cannot be written, so no scope contains it.
                let mut names = HashMap::default();
                self.declare_function(decl, &mut names, "");
                self.function(decl);
                self.capture(decl);
                debug_assert_eq!(around, self.scopes.len());
            }
            // The body of a symbolic function, which shares its block with the parameters.
            ExprKind::Block(body) => self.body(body),
        }
    }

    /// Resolves the values that a loop goes through.
    pub(super) fn values(&mut self, values: &'a Values) {
        values.expressions().into_iter().for_each(|e| self.expr(e));
    }

    /// Declares the variable of a loop over values. It may be unused, as in a loop that only
    /// counts.
    pub(super) fn element(&mut self, name: &Ident) {
        let id = self.variable(name, VarKind::Value);
        self.names.variables[id.0 as usize].reads = 1;
    }

    pub(super) fn name(&mut self, name: &'a Ident) {
        let res = self.lookup(name);
        self.names.uses.insert(name.span, res);
        self.report_former(name, res);
        self.refuse_state(name, res);
        match res {
            Resolution::Var(id) => {
                self.names.variables[id.0 as usize].reads += 1;
                self.outer(id);
                self.refuse_in_test(name, id);
            }
            Resolution::Function(id) => {
                self.names.functions[self.function.0 as usize].callees.insert(id);
            }
            _ => {}
        }
    }

    /// Reports former names that equal another name of the same function or record.
    pub(super) fn check_former_names(&mut self, declared: &[DeclaredName<'_>]) {
        let mut seen: HashSet<&str> = declared.iter().map(|declared| declared.name.name.as_str()).collect();
        for former in declared.iter().filter_map(|declared| declared.former) {
            if !seen.insert(&former.name) {
                self.twice(former);
            }
        }
    }

    /// Reports the use of a function or record by its former name.
    fn report_former(&mut self, used: &Ident, res: Resolution) {
        let current = match res {
            Resolution::Function(id) => self.names.functions[id.0 as usize].decl.map(|decl| &decl.name),
            Resolution::Extern(id) => Some(&self.names.externs[id as usize].decl.name),
            Resolution::Record(id) => Some(&self.names.records[id.0 as usize].decl.name),
            _ => None,
        };
        if let Some(current) = current.filter(|current| current.name != used.name) {
            self.report(former_names::warning(used, &current.name));
        }
    }

    pub(super) fn field(&mut self, base: &'a Expr, field: &'a Ident) {
        let around = std::mem::replace(&mut self.is_base, matches!(base.kind, ExprKind::Name(_)));
        self.expr(base);
        self.is_base = around;
        let ExprKind::Name(name) = &base.kind else { return };
        if let Some(res) = self.names.uses.get(&name.span).copied() {
            self.member(name, res, field);
        }
    }

    /// Resolves a field of a place; if the base is a module, a member of the module.
    pub(super) fn field_of(&mut self, base: &'a Expr, place: &'a Expr) {
        if let (ExprKind::Name(name), ExprKind::Field { field, .. }) = (&base.kind, &place.kind)
            && let Some(res) = self.names.uses.get(&name.span).copied()
        {
            self.member(name, res, field);
        }
    }

    /// Resolves a member of a module.
    pub(super) fn member(&mut self, name: &Ident, module: Resolution, field: &'a Ident) {
        let module = match module {
            Resolution::Module(module) => module as usize,
            Resolution::Unknown => {
                self.names.uses.insert(field.span, Resolution::Unknown);
                return;
            }
            _ => return,
        };
        let (exports, private) = (&self.exports[module], &self.private[module]);
        let res = match exports.get(&field.name) {
            Some((res, _)) if !private.contains(field.name.as_str()) => *res,
            Some((_, declared)) => {
                let message = format!("`{}` is private to the module `{}`", field.name, name.name);
                let diagnostic = Diagnostic::error("E0204", message, field.span, "not visible here")
                    .label(*declared, "declared `private` here")
                    .help("use an exported name, or remove `private`");
                self.report(diagnostic);
                Resolution::Unknown
            }
            None => {
                let mut diagnostic = Diagnostic::error(
                    "E0204",
                    format!("the module `{}` has no `{}`", name.name, field.name),
                    field.span,
                    "not declared in the module",
                );
                let all = self.around.declared(&self.modules[module].name);
                let doc = self.around.doc(&self.modules[module].name);
                let near = similar(&field.name, all.iter().map(String::as_str));
                diagnostic = match near.filter(|_| !other_modules::lists(&doc, &field.name)) {
                    Some(near) => diagnostic.help(format!("did you mean `{near}`?")).fix(
                        format!("change to `{near}`"),
                        field.span,
                        near,
                    ),
                    None => diagnostic.help(other_modules::help(&name.name, &doc, &field.name, &all)),
                };
                self.report(diagnostic);
                Resolution::Unknown
            }
        };
        self.names.uses.insert(field.span, res);
        self.report_former(field, res);
        if let Resolution::Function(id) = res {
            self.names.functions[self.function.0 as usize].callees.insert(id);
        }
    }

    pub(super) fn lookup(&mut self, name: &Ident) -> Resolution {
        if let Some(constant) = builtins::constant(&name.name) {
            return Resolution::Constant(constant);
        }
        for scope in self.scopes.iter().rev() {
            if let Some((res, _)) = scope.names.get(&name.name) {
                return *res;
            }
        }
        if let Some(builtin) = Builtin::find(&name.name) {
            return Resolution::Builtin(builtin);
        }
        if let Some(unit) = Unit::find(&name.name) {
            return Resolution::Unit(unit);
        }
        if name.name == "none" {
            return Resolution::None;
        }
        self.unknown(name);
        Resolution::Unknown
    }

    pub(super) fn unknown(&mut self, name: &Ident) {
        let diagnostic =
            Diagnostic::error("E0201", format!("`{}` is not declared", name.name), name.span, "unknown name");
        let reserved = match name.name.as_str() {
            "true" | "True" => Some("TRUE"),
            "false" | "False" => Some("FALSE"),
            "t" | "T" | "time" => Some("Time"),
            "Pi" | "PI" => Some("pi"),
            "Inf" | "infinity" => Some("inf"),
            "NaN" => Some("nan"),
            _ => None,
        };
        let mut candidates: Vec<&str> = Vec::new();
        // The search compares every unknown name with all declared names, so it is limited in texts
        // with many errors.
        let mut declared: Vec<String>;
        let suggests = self.around.suggests() && self.names.diagnostics.len() < MOST_SUGGESTIONS;
        if suggests {
            declared =
                self.modules.get(self.file.0 as usize).map_or(Vec::new(), |m| self.around.declared(&m.name));
            declared.extend(self.around.declared("prelude"));
            let visible = self.scopes.iter().flat_map(|scope| &scope.names);
            if self.is_base {
                // Functions have no members.
                let value =
                    |res: &Resolution| !matches!(res, Resolution::Function(_) | Resolution::Extern(_));
                candidates.extend(visible.filter(|(_, (res, _))| value(res)).map(|(name, _)| name.as_str()));
            } else {
                candidates = builtins::names().collect();
                candidates.extend(visible.map(|(name, _)| name.as_str()));
                candidates.extend(declared.iter().map(String::as_str));
            }
        }
        let near = match reserved {
            Some(near) => Some(near.to_string()),
            None if !suggests => None,
            None => similar(&name.name, candidates.into_iter())
                .or_else(|| Unit::similar(&name.name).filter(|near| near.len() > 2).map(str::to_string)),
        };
        let qualified = if suggests && reserved.is_none() { self.qualified(&name.name) } else { None };
        let diagnostic = match qualified.or(near) {
            Some(near) => diagnostic.help(format!("did you mean `{near}`?")).fix(
                format!("change to `{near}`"),
                name.span,
                near,
            ),
            None if self.around.is_module(&name.name) => {
                diagnostic.help(format!("add `import {};` to use the module", name.name))
            }
            None => diagnostic.help("declare it with `var` before this use"),
        };
        self.report(diagnostic);
    }

    /// Offers quotes for an undeclared name as a named argument that can be a text, such as
    /// `material = steel`. The text may continue after the name: `rack = ISO 53 A`.
    fn unquoted_text(&mut self, callee: &Expr, argument: &Argument) {
        let (Some((parameter, Bind::Evaluate)), ExprKind::Name(name)) =
            (&argument.name, &argument.value.kind)
        else {
            return;
        };
        if !self.accepts_text(callee, &parameter.name) {
            return;
        }
        let is_own = |problem: &&mut Diagnostic| {
            problem.code == "E0201" && problem.primary.span == name.span && problem.fix.is_none()
        };
        let text = self.modules.get(self.file.0 as usize).map_or("", |module| module.text.as_str());
        let rest = text.get(name.span.start as usize..).unwrap_or_default();
        let written = rest.split([',', ')', '"', ';', '\n']).next().unwrap_or_default().trim_end();
        let Some(problem) = self.names.diagnostics.last_mut().filter(is_own) else { return };
        let quoted = format!("\"{written}\"");
        let help = format!(
            "text is in quotes: write `{} = {quoted}`; a variable is declared with `var` before its use",
            parameter.name
        );
        let place = Span { end: name.span.start + written.len() as u32, ..name.span };
        *problem = problem.clone().help(help).suggest(format!("write `{quoted}`"), place, quoted);
    }

    /// Returns `true` if a parameter is a text or has one as its default, as the materials and
    /// racks of the gear library have.
    fn accepts_text(&self, callee: &Expr, parameter: &str) -> bool {
        let (ExprKind::Name(name) | ExprKind::Field { field: name, .. }) = &callee.kind else { return false };
        let declared = match self.names.uses.get(&name.span) {
            Some(Resolution::Function(id)) => self.names.functions[id.0 as usize].decl,
            Some(Resolution::Extern(index)) => Some(self.names.externs[*index as usize].decl),
            _ => None,
        };
        let found = declared.and_then(|decl| decl.parameters.iter().find(|own| own.name.name == parameter));
        let ty = found.and_then(|own| own.annotation.as_ref());
        let text = |default: &Option<(Bind, Option<Expr>)>| {
            matches!(default, Some((_, Some(Expr { kind: ExprKind::String(_), .. }))))
        };
        ty.is_some_and(|ty| matches!(&ty.kind, TypeKind::Name(name) if name.name == "String"))
            || found.is_some_and(|own| text(&own.default))
    }

    /// Returns the path of a name that an imported module declares, or of a choice of a visible
    /// enumeration; `None` if there is none or more than one.
    fn qualified(&self, name: &str) -> Option<String> {
        let of = |visible: &str, res: &Resolution| match *res {
            Resolution::Module(module) => {
                let module = self.modules.get(module as usize)?;
                let declared = self.around.declared(&module.name);
                declared.iter().any(|declared| declared == name).then(|| format!("{visible}.{name}"))
            }
            Resolution::Enum(id) => {
                let choices = &self.names.enums.get(id as usize)?.decl.choices;
                choices.iter().any(|choice| choice.name.name == name).then(|| format!("{visible}.{name}"))
            }
            _ => None,
        };
        let visible = self.scopes.iter().flat_map(|scope| &scope.names);
        let mut found = visible.filter_map(|(visible, (res, _))| of(visible, res));
        let only = found.next()?;
        found.next().is_none().then_some(only)
    }
}

/// Returns the declared name of a module-level declaration, and its former name.
pub(super) fn item_names(statement: &Stmt) -> impl Iterator<Item = &Ident> {
    let (name, former) = match &statement.kind {
        StmtKind::Function(decl) => (Some(&decl.name), decl.former.as_ref()),
        StmtKind::Record(decl) => (Some(&decl.name), decl.former.as_ref()),
        StmtKind::Enum(decl) => (Some(&decl.name), None),
        StmtKind::Unit(decl) => (Some(&decl.name), None),
        StmtKind::Const { name, .. } | StmtKind::Dimension { name, .. } => (Some(name), None),
        _ => (None, None),
    };
    name.into_iter().chain(former)
}
