//! Resolves the names in statements and declarations.

use super::unused::Effect;
use super::*;

impl<'a> Resolver<'a> {
    pub(super) fn statement(&mut self, statement: &'a Stmt, top: bool) {
        match &statement.kind {
            StmtKind::Empty
            | StmtKind::Error
            | StmtKind::Units(_)
            | StmtKind::Goto(_)
            | StmtKind::Break
            | StmtKind::Continue => {}
            StmtKind::Import(path) => self.import(path, top),
            StmtKind::Const { value, .. } => self.expr(value),
            StmtKind::Record(decl) => self.record(decl),
            StmtKind::Enum(decl) => self.enumeration(decl),
            StmtKind::Dimension { value, .. } => value.iter().for_each(|value| self.type_expr(value)),
            StmtKind::Unit(decl) => match &decl.meaning {
                UnitMeaning::Coherent(dimension) => self.type_expr(dimension),
                UnitMeaning::Equal(value) => self.expr(value),
            },
            StmtKind::Param(decl) => self.param(decl, statement.doc.as_deref(), top),
            StmtKind::Output { name, value, unit } => {
                self.output(name, value, statement.doc.as_deref(), top);
                unit.iter().for_each(|unit| self.output_unit(unit));
            }
            StmtKind::Var(decls) => self.variables(decls),
            StmtKind::Assign { place, bind, value } => {
                self.place(place);
                if let ExprKind::Name(name) = &place.kind {
                    self.undeclared(name, *bind);
                }
                self.expr(value);
            }
            StmtKind::Update { place, value, .. } => {
                self.place(place);
                self.expr(value);
            }
            StmtKind::Expr(e) => self.expr(e),
            StmtKind::Function(decl) => self.function(decl),
            StmtKind::Block(statements) => self.scoped(|r| {
                r.declare_functions(statements);
                statements.iter().for_each(|s| r.statement(s, false));
            }),
            StmtKind::If { condition, then, otherwise } => {
                self.expr(condition);
                self.nested(then);
                if let Some(otherwise) = otherwise {
                    self.nested(otherwise);
                }
            }
            StmtKind::While { condition, body } => {
                self.expr(condition);
                self.nested(body);
            }
            StmtKind::DoWhile { body, condition } => {
                self.nested(body);
                self.expr(condition);
            }
            StmtKind::For { init, condition, step, body } => self.scoped(|r| {
                r.statement(init, false);
                condition.iter().for_each(|e| r.expr(e));
                r.statement(step, false);
                r.nested(body);
            }),
            StmtKind::ForEach { variable, values, body } => {
                self.values(values);
                self.scoped(|r| {
                    r.element(variable);
                    r.nested(body);
                });
            }
            StmtKind::Switch { value, body } => {
                self.expr(value);
                self.nested(body);
            }
            StmtKind::Case { value, statement } => {
                self.expr(value);
                self.statement(statement, false);
            }
            StmtKind::Default(inner) => self.statement(inner, false),
            StmtKind::Label { statement, .. } => self.statement(statement, false),
            StmtKind::Return(value) | StmtKind::Throw(value) => value.iter().for_each(|e| self.expr(e)),
            StmtKind::Try { body, error, handler } => self.try_catch(body, error.as_ref(), handler),
        }
    }

    /// Offers the declaration of a name that is assigned without one, and declares it, so that its
    /// uses cause no further errors.
    fn undeclared(&mut self, name: &Ident, bind: Bind) {
        if self.names.uses.get(&name.span) != Some(&Resolution::Unknown) {
            return;
        }
        // A name that is similar to another one is more likely misspelt.
        let is_own = |problem: &&mut Diagnostic| problem.primary.span == name.span && problem.fix.is_none();
        let Some(problem) = self.names.diagnostics.last_mut().filter(is_own) else { return };
        let sign = if bind == Bind::Symbolic { ":=" } else { "=" };
        problem.help = Some(format!("declare it: `var {} {sign} ...;`", name.name));
        let before = Span { end: name.span.start, ..name.span };
        *problem = problem.clone().suggest(format!("declare `{}`", name.name), before, "var ");
        if let Some(scope) = self.scopes.last_mut() {
            scope.names.entry(name.name.clone()).or_insert((Resolution::Unknown, name.span));
        }
    }

    fn record(&mut self, decl: &'a RecordDecl) {
        let mut seen = HashSet::default();
        for field in &decl.fields {
            if !seen.insert(&field.name.name) {
                self.twice(&field.name);
            }
            field.annotation.iter().for_each(|annotation| self.type_expr(annotation));
            field.default.iter().for_each(|default| self.expr(default));
        }
        self.check_former_names(&decl.field_names());
    }

    fn enumeration(&mut self, decl: &'a EnumDecl) {
        let mut seen = HashSet::default();
        for choice in &decl.choices {
            if !seen.insert(&choice.name.name) {
                self.twice(&choice.name);
            }
        }
    }

    fn param(&mut self, decl: &'a ParamDecl, doc: Option<&'a str>, top: bool) {
        self.expr(&decl.default);
        self.domain(decl.domain.as_ref());
        // Not allowed inside a block; already reported by the parser.
        if !top {
            return;
        }
        let id = self.names.params.len() as u32;
        let owner = self.function;
        self.names.params.push(ParamInfo { decl, doc, owner });
        self.declare(&decl.name, Resolution::Param(id));
    }

    fn output(&mut self, name: &'a Ident, value: &'a Expr, doc: Option<&'a str>, top: bool) {
        self.expr(value);
        // Not allowed inside a block; already reported by the parser.
        if !top {
            return;
        }
        let id = self.names.outputs.len() as u32;
        let owner = self.function;
        self.names.outputs.push(OutputInfo { name, doc, owner });
        self.declare(name, Resolution::Output(id));
    }

    fn variables(&mut self, decls: &'a [VarDecl]) {
        for decl in decls {
            if let Some((_, value)) = &decl.init {
                self.expr(value);
            }
            let symbolic = matches!(decl.init, Some((Bind::Symbolic, _)));
            let id = self.variable(&decl.name, if symbolic { VarKind::Symbolic } else { VarKind::Value });
            match decl.init.as_ref().map_or(Effect::None, |(_, value)| self.effect(value)) {
                // A part of the model, also if no expression uses it.
                Effect::Adds => self.names.variables[id.0 as usize].reads = 1,
                Effect::Creates => self.created.push(id),
                Effect::None => {}
            }
        }
    }

    pub(super) fn domain(&mut self, domain: Option<&'a Domain>) {
        match domain {
            Some(Domain::Range { low, high, .. }) => low.iter().chain(high).for_each(|e| self.expr(e)),
            Some(Domain::Choices { values, .. }) => values.iter().for_each(|e| self.expr(e)),
            None => {}
        }
    }

    fn try_catch(&mut self, body: &'a Stmt, error: Option<&'a Ident>, handler: &'a Stmt) {
        self.nested(body);
        self.scoped(|r| {
            if let Some(error) = error {
                let id = r.variable(error, VarKind::Value);
                r.names.variables[id.0 as usize].reads = 1;
            }
            r.nested(handler);
        });
    }

    /// Resolves a statement that is a block even without braces.
    pub(super) fn nested(&mut self, statement: &'a Stmt) {
        self.scoped(|r| {
            r.declare_functions(std::slice::from_ref(statement));
            r.statement(statement, false);
        });
    }

    pub(super) fn import(&mut self, path: &'a Import, top: bool) {
        let (Some(last), true) = (path.name(), top) else { return };
        let name = path.iter().map(|ident| ident.name.as_str()).collect::<Vec<_>>().join(".");
        match self.modules.iter().position(|module| module.name == name) {
            Some(index) => {
                self.declare(last, Resolution::Module(index as u32));
            }
            // Already reported by the loader.
            None => {
                self.declare(last, Resolution::Unknown);
                self.meant_module(&name, last);
            }
        };
    }

    /// If a module's name is misspelt only in its import, the correct name is used elsewhere.
    /// Declares it so that only one error is reported.
    fn meant_module(&mut self, name: &str, declared: &Ident) {
        let known = self.around.modules();
        let Some(near) = similar(name, known.iter().map(String::as_str)) else { return };
        if self.modules.iter().all(|module| module.name != near)
            && let (Some(scope), Some(last)) = (self.scopes.last_mut(), near.rsplit('.').next())
        {
            scope.names.entry(last.into()).or_insert((Resolution::Unknown, declared.span));
        }
    }

    pub(super) fn function(&mut self, decl: &'a FunctionDecl) {
        if decl.is_test {
            self.test(decl);
        }
        decl.result.iter().for_each(|result| self.type_expr(result));
        if let FunctionBody::Extern { unit: Some(unit), .. } = &decl.body {
            self.output_unit(unit);
        }
        for parameter in &decl.parameters {
            parameter.annotation.iter().for_each(|annotation| self.type_expr(annotation));
            parameter.former_none.iter().for_each(|former| self.expr(former));
            self.domain(parameter.domain.as_ref());
        }
        self.check_former_names(&decl.parameter_names());
        let default = |parameter: &'a Parameter| match &parameter.default {
            Some((_, Some(default))) => Some(default),
            _ => None,
        };
        let id = match self.names.uses.get(&decl.name.span) {
            Some(Resolution::Function(id)) => *id,
            // An extern function has no body, but the names of its parameters must differ.
            _ => {
                let mut seen = HashSet::default();
                for parameter in &decl.parameters {
                    default(parameter).into_iter().for_each(|e| self.expr(e));
                    if !seen.insert(&parameter.name.name) {
                        self.twice(&parameter.name);
                    }
                }
                return;
            }
        };
        let around = std::mem::replace(&mut self.function, id);
        self.scoped(|r| {
            for parameter in &decl.parameters {
                let symbolic = matches!(parameter.default, Some((Bind::Symbolic, _)))
                    && matches!(decl.body, FunctionBody::Statement(_));
                let kind = if symbolic { VarKind::Symbolic } else { VarKind::Parameter(parameter.mode) };
                // A default may use earlier parameters.
                default(parameter).into_iter().for_each(|e| r.expr(e));
                let variable = r.variable(&parameter.name, kind);
                // Unused parameters are allowed.
                r.names.variables[variable.0 as usize].reads = 1;
                r.names.functions[id.0 as usize].parameters.push(variable);
            }
            match &decl.body {
                FunctionBody::Statement(body) => match &body.kind {
                    StmtKind::Block(statements) if decl.is_component => {
                        r.declare_functions(statements);
                        statements.iter().for_each(|s| r.statement(s, true));
                        r.use_members(statements);
                    }
                    _ => r.body(body),
                },
                FunctionBody::Symbolic(e) => r.expr(e),
                FunctionBody::Extern { .. } => {}
            }
        });
        self.function = around;
    }

    /// Resolves the body of a function.
    pub(super) fn body(&mut self, body: &'a Stmt) {
        match &body.kind {
            // Parameters and body share one block, so the body cannot declare a parameter again.
            StmtKind::Block(statements) => {
                self.declare_functions(statements);
                statements.iter().for_each(|s| self.statement(s, false));
            }
            _ => self.statement(body, false),
        }
    }

    pub(super) fn twice(&mut self, name: &Ident) {
        let message = format!("`{}` is declared twice in the same block", name.name);
        self.report(
            Diagnostic::error("E0202", message, name.span, "declared again here").help("choose another name"),
        );
    }

    /// Resolves the target of an assignment, which does not count as a use of the variable.
    fn place(&mut self, place: &'a Expr) {
        match &place.kind {
            ExprKind::Name(name) => {
                let res = self.lookup(name);
                self.names.uses.insert(name.span, res);
                self.names.written.insert(name.span);
                self.refuse_state(name, res);
                if let Resolution::Var(id) = res {
                    self.names.assigned.insert(id);
                    self.outer(id);
                    self.refuse_in_test(name, id);
                }
            }
            ExprKind::Index { base, index } => {
                self.place(base);
                self.expr(index);
            }
            ExprKind::Field { base, .. } => {
                self.place(base);
                self.field_of(base, place);
            }
            ExprKind::Paren(inner) => self.place(inner),
            _ => self.expr(place),
        }
    }
}
