//! Names: what every identifier of the program stands for.
//!
//! Runs before types are inferred, so that a misspelt name is reported whatever its type might have been.
//! Functions are visible in their whole block, variables from their declaration on.

use super::ModuleData;
use super::builtins::{self, Builtin};
use super::symbols::*;
use super::tree::{FuncId, RecordId, VarId};
use super::unit::Surroundings;
use crate::ast::*;
use crate::diagnostic::Diagnostic;
use crate::span::{FileId, Span};
use crate::units::Unit;
use std::collections::{BTreeSet, HashMap, HashSet};

#[derive(Default)]
struct Scope {
    names: HashMap<String, (Res, Span)>,
}

struct Resolver<'a> {
    names: Names<'a>,
    modules: &'a [ModuleData],
    around: &'a dyn Surroundings,
    /// Functions and externs by module and name.
    exports: Vec<HashMap<String, (Res, Span)>>,
    /// Names of each module that importers do not see.
    private: Vec<HashSet<&'a str>>,
    scopes: Vec<Scope>,
    function: FuncId,
    file: FileId,
}

/// Resolves all names. `modules[0]` is the model, `modules[1]` the prelude.
pub fn resolve<'a>(modules: &'a [ModuleData], around: &'a dyn Surroundings) -> Names<'a> {
    let mut resolver = Resolver {
        names: Names::default(),
        modules,
        around,
        exports: Vec::new(),
        private: Vec::new(),
        scopes: Vec::new(),
        function: FuncId(0),
        file: FileId(0),
    };
    resolver.names.functions.push(FunctionInfo {
        decl: None,
        name: "main".into(),
        file: FileId(0),
        parent: None,
        parameters: Vec::new(),
        outer: BTreeSet::new(),
        callees: BTreeSet::new(),
    });
    for (index, module) in modules.iter().enumerate() {
        let mut exports = HashMap::new();
        if index > 0 {
            resolver.file = module.file;
            for statement in &module.tree.statements {
                resolver.declare_item(statement, &mut exports, &module.name);
            }
        }
        resolver.exports.push(exports);
        let hidden = module.tree.statements.iter().filter(|statement| statement.private);
        resolver.private.push(hidden.filter_map(item_name).map(|name| name.name.as_str()).collect());
    }
    // Modules first: a model's diagnostics then never depend on how far its modules were read.
    for index in (0..modules.len()).rev() {
        resolver.module(index);
    }
    let Resolver { mut names, .. } = resolver;
    for variable in &names.variables {
        if variable.reads == 0
            && variable.span.file == FileId(0)
            && matches!(variable.kind, VarKind::Value | VarKind::Symbolic)
            && !variable.name.starts_with('_')
        {
            names.diagnostics.push(
                Diagnostic::warning(
                    "W0201",
                    format!("`{}` is never used", variable.name),
                    variable.span,
                    "declared here",
                )
                .help("remove it, or start its name with `_` to keep it"),
            );
        }
    }
    names
}

/// Diagnostics after which unknown names get no suggestion any more.
const MOST_SUGGESTIONS: usize = 200;

impl<'a> Resolver<'a> {
    fn module(&mut self, index: usize) {
        let module = &self.modules[index];
        self.file = module.file;
        self.function = FuncId(0);
        let prelude = match index {
            1 => Scope::default(),
            _ => {
                let mut names = self.exports.get(1).cloned().unwrap_or_default();
                names.retain(|name, _| !self.private[1].contains(name.as_str()));
                Scope { names }
            }
        };
        let own = Scope { names: self.exports[index].clone() };
        self.scopes = vec![prelude, own];
        if index == 0 {
            self.declare_functions(&module.tree.statements);
        }
        let mut system: Option<&Ident> = None;
        for statement in &module.tree.statements {
            if let StmtKind::Units(second) = &statement.kind
                && let Some(first) = system.replace(system.unwrap_or(second))
            {
                self.report(
                    Diagnostic::error(
                        "E0224",
                        "a file has one system of units",
                        statement.span,
                        format!("`{}` comes too late", second.name),
                    )
                    .label(first.span, format!("all numbers of the file are in `{}`", first.name))
                    .help("remove one of the two; a single number may have any unit, as in `3 inch`"),
                );
            }
            if index > 0 {
                match &statement.kind {
                    StmtKind::Import(_)
                    | StmtKind::Units(_)
                    | StmtKind::Function(_)
                    | StmtKind::Const { .. }
                    | StmtKind::Record(_)
                    | StmtKind::Dimension { .. }
                    | StmtKind::Unit(_)
                    | StmtKind::Empty
                    | StmtKind::Error => {}
                    _ => self.report(
                        Diagnostic::error(
                            "E0210",
                            "a module holds only functions, constants, records, dimensions, units and imports",
                            statement.span,
                            "not allowed in a module",
                        )
                        .help("move it to the model, or into a function"),
                    ),
                }
            }
            self.statement(statement, true);
        }
        self.scopes.clear();
    }

    fn report(&mut self, diagnostic: Diagnostic) {
        self.names.diagnostics.push(diagnostic);
    }

    /// Declares the functions, constants and so on of a block before anything else in it.
    fn declare_functions(&mut self, statements: &'a [Stmt]) {
        for statement in statements {
            let mut names = self.scopes.pop().unwrap_or_default().names;
            self.declare_item(statement, &mut names, "");
            self.scopes.push(Scope { names });
        }
    }

    fn declare_item(&mut self, statement: &'a Stmt, names: &mut HashMap<String, (Res, Span)>, module: &str) {
        let file = self.file;
        let (name, res) = match &statement.kind {
            StmtKind::Function(decl) => return self.declare_function(decl, names, module),
            StmtKind::Const { name, value } => {
                self.names.consts.push(Declared { decl: ConstDecl { name, value }, file });
                (name, Res::Const(self.names.consts.len() as u32 - 1))
            }
            StmtKind::Record(decl) => {
                self.names.records.push(Declared { decl, file });
                (&decl.name, Res::Record(RecordId(self.names.records.len() as u32 - 1)))
            }
            StmtKind::Dimension { name, value } => {
                let decl = DimensionDecl { name, value: value.as_ref() };
                self.names.dimensions.push(Declared { decl, file });
                (name, Res::Dimension(self.names.dimensions.len() as u32 - 1))
            }
            StmtKind::Unit(decl) => {
                self.names.units.push(Declared { decl, file });
                (&decl.name, Res::OwnUnit(self.names.units.len() as u32 - 1))
            }
            _ => return,
        };
        self.names.uses.insert(name.span, res);
        self.insert(names, name, res);
    }

    fn declare_function(
        &mut self,
        decl: &'a FunctionDecl,
        names: &mut HashMap<String, (Res, Span)>,
        module: &str,
    ) {
        let name = &decl.name;
        let res = if matches!(decl.body, FunctionBody::Extern { .. }) {
            // The prelude's functions are the standard ones, without a module name in the program.
            let (shown, prefix) = match module {
                "" | "prelude" => (name.name.clone(), "std".to_string()),
                _ => (format!("{module}.{}", name.name), module.replace('.', "_")),
            };
            self.names.externs.push(ExternInfo {
                decl,
                name: shown,
                symbol: format!("calyx_{prefix}_{}", name.name),
                file: self.file,
            });
            Res::Extern(self.names.externs.len() as u32 - 1)
        } else {
            self.names.functions.push(FunctionInfo {
                decl: Some(decl),
                name: name.name.clone(),
                file: self.file,
                parent: Some(self.function),
                parameters: Vec::new(),
                outer: BTreeSet::new(),
                callees: BTreeSet::new(),
            });
            Res::Function(FuncId(self.names.functions.len() as u32 - 1))
        };
        self.names.uses.insert(name.span, res);
        self.insert(names, name, res);
    }

    /// Enters a name into a block, reporting a reserved or taken one.
    /// False if it could not.
    fn insert(&mut self, names: &mut HashMap<String, (Res, Span)>, name: &Ident, res: Res) -> bool {
        if builtins::constant(&name.name).is_some() {
            self.report(
                Diagnostic::error(
                    "E0203",
                    format!("`{}` is reserved", name.name),
                    name.span,
                    "cannot be declared",
                )
                .help("choose another name"),
            );
            return false;
        }
        if let Some((_, first)) = names.get(&name.name) {
            let diagnostic = Diagnostic::error(
                "E0202",
                format!("`{}` is declared twice in the same block", name.name),
                name.span,
                "declared again here",
            )
            .label(*first, "first declared here")
            .help("choose another name, or assign without `var`");
            self.report(diagnostic);
            return false;
        }
        names.insert(name.name.clone(), (res, name.span));
        true
    }

    fn declare(&mut self, name: &Ident, res: Res) -> bool {
        self.names.uses.insert(name.span, res);
        let mut names = self.scopes.pop().unwrap_or_default().names;
        let sound = self.insert(&mut names, name, res);
        self.scopes.push(Scope { names });
        sound
    }

    fn variable(&mut self, name: &Ident, kind: VarKind) -> VarId {
        let id = VarId(self.names.variables.len() as u32);
        self.names.variables.push(Variable {
            name: name.name.clone(),
            span: name.span,
            kind,
            owner: self.function,
            reads: 0,
        });
        if !self.declare(name, Res::Var(id)) {
            // Nothing can name it, and that has been reported.
            self.names.variables[id.0 as usize].reads = 1;
        }
        id
    }

    fn scoped(&mut self, work: impl FnOnce(&mut Self)) {
        self.scopes.push(Scope::default());
        work(self);
        self.scopes.pop();
    }

    fn statement(&mut self, statement: &'a Stmt, top: bool) {
        match &statement.kind {
            StmtKind::Empty
            | StmtKind::Error
            | StmtKind::Units(_)
            | StmtKind::Goto(_)
            | StmtKind::Break
            | StmtKind::Continue => {}
            StmtKind::Import(path) => self.import(path, top),
            StmtKind::Const { value, .. } => self.expr(value),
            StmtKind::Record(decl) => {
                let mut seen = HashSet::new();
                for field in &decl.fields {
                    if !seen.insert(&field.name.name) {
                        self.twice(&field.name);
                    }
                    field.annotation.iter().for_each(|annotation| self.type_expr(annotation));
                    field.default.iter().for_each(|default| self.expr(default));
                }
            }
            StmtKind::Dimension { value, .. } => value.iter().for_each(|value| self.type_expr(value)),
            StmtKind::Unit(decl) => match &decl.meaning {
                UnitMeaning::Coherent(dimension) => self.type_expr(dimension),
                UnitMeaning::Equal(value) => self.expr(value),
            },
            StmtKind::Param(decl) => {
                self.expr(&decl.default);
                match &decl.domain {
                    Some(Domain::Range { low, high, .. }) => {
                        low.iter().chain(high).for_each(|e| self.expr(e));
                    }
                    Some(Domain::Choices { values, .. }) => values.iter().for_each(|e| self.expr(e)),
                    None => {}
                }
                // Inside a block it is out of place, which the parser has reported.
                if !top {
                    return;
                }
                let id = self.names.params.len() as u32;
                self.names.params.push((decl, statement.doc.as_deref()));
                self.declare(&decl.name, Res::Param(id));
            }
            StmtKind::Output { name, value } => {
                self.expr(value);
                // Inside a block it is out of place, which the parser has reported.
                if !top {
                    return;
                }
                let id = self.names.outputs.len() as u32;
                self.names.outputs.push((name, value, statement.doc.as_deref()));
                self.declare(name, Res::Output(id));
            }
            StmtKind::Var(decls) => {
                for decl in decls {
                    if let Some((_, value)) = &decl.init {
                        self.expr(value);
                    }
                    let symbolic = matches!(decl.init, Some((Bind::Symbolic, _)));
                    self.variable(&decl.name, if symbolic { VarKind::Symbolic } else { VarKind::Value });
                }
            }
            StmtKind::Assign { place, value, .. } => {
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
            StmtKind::Try { body, error, handler } => {
                self.nested(body);
                self.scoped(|r| {
                    if let Some(error) = error {
                        let id = r.variable(error, VarKind::Value);
                        r.names.variables[id.0 as usize].reads = 1;
                    }
                    r.nested(handler);
                });
            }
        }
    }

    /// A statement that is a block of its own even without braces.
    fn nested(&mut self, statement: &'a Stmt) {
        self.scoped(|r| {
            r.declare_functions(std::slice::from_ref(statement));
            r.statement(statement, false);
        });
    }

    fn import(&mut self, path: &'a [Ident], top: bool) {
        let (Some(last), true) = (path.last(), top) else { return };
        let name = path.iter().map(|ident| ident.name.as_str()).collect::<Vec<_>>().join(".");
        match self.modules.iter().position(|module| module.name == name) {
            Some(index) => {
                self.declare(last, Res::Module(index as u32));
            }
            // The loader has reported it.
            None => {
                self.declare(last, Res::Unknown);
                self.meant_module(&name, last);
            }
        };
    }

    /// Where a module's name is misspelt in its import only, its right name is used everywhere else: one error is enough.
    fn meant_module(&mut self, name: &str, declared: &Ident) {
        let known = self.around.modules();
        let Some(near) = similar(name, known.iter().map(String::as_str)) else { return };
        if self.modules.iter().all(|module| module.name != near)
            && let (Some(scope), Some(last)) = (self.scopes.last_mut(), near.rsplit('.').next())
        {
            scope.names.entry(last.into()).or_insert((Res::Unknown, declared.span));
        }
    }

    /// Nothing hands anything to a test, or takes what it gives.
    fn test(&mut self, decl: &FunctionDecl) {
        let place = match (decl.parameters.first(), &decl.result) {
            (Some(parameter), _) => parameter.name.span,
            (None, Some(result)) => result.span,
            (None, None) if matches!(decl.body, FunctionBody::Statement(_)) => return,
            (None, None) => decl.name.span,
        };
        self.report(
            Diagnostic::error(
                "E0222",
                format!("the test `{}` takes or gives something", decl.name.name),
                place,
                "not for a test",
            )
            .help("write `test function name() { assert(...); }`; a test calls functions with arguments of its own"),
        );
    }

    /// What the model runs is not run before a test, so its variables have no values there.
    fn refuse_in_test(&mut self, name: &Ident, id: VarId) {
        let variable = &self.names.variables[id.0 as usize];
        let (owner, declared) = (variable.owner, variable.span);
        let mut at = Some(self.function);
        while let Some(function) = at.filter(|function| *function != owner) {
            let info = &self.names.functions[function.0 as usize];
            if info.decl.is_some_and(|decl| decl.is_test) {
                let diagnostic = Diagnostic::error(
                    "E0223",
                    format!("a test does not see the variable `{}`", name.name),
                    name.span,
                    "a variable of the model",
                )
                .label(declared, "declared here")
                .help("compute what the test needs inside it, or make this a `const` or a function");
                return self.report(diagnostic);
            }
            at = info.parent;
        }
    }

    fn function(&mut self, decl: &'a FunctionDecl) {
        if decl.is_test {
            self.test(decl);
        }
        decl.result.iter().for_each(|result| self.type_expr(result));
        for parameter in &decl.parameters {
            parameter.annotation.iter().for_each(|annotation| self.type_expr(annotation));
            if let Some((_, Some(default))) = &parameter.default {
                self.expr(default);
            }
            match &parameter.domain {
                Some(Domain::Range { low, high, .. }) => low.iter().chain(high).for_each(|e| self.expr(e)),
                Some(Domain::Choices { values, .. }) => values.iter().for_each(|e| self.expr(e)),
                None => {}
            }
        }
        let id = match self.names.uses.get(&decl.name.span) {
            Some(Res::Function(id)) => *id,
            // An extern function has no body. Its parameters' names must still differ.
            _ => {
                let mut seen = HashSet::new();
                for parameter in &decl.parameters {
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
                let variable = r.variable(&parameter.name, kind);
                // A parameter need not be used.
                r.names.variables[variable.0 as usize].reads = 1;
                r.names.functions[id.0 as usize].parameters.push(variable);
            }
            match &decl.body {
                FunctionBody::Statement(body) => match &body.kind {
                    // Parameters and body share one block: a parameter cannot be declared again.
                    StmtKind::Block(statements) => {
                        r.declare_functions(statements);
                        statements.iter().for_each(|s| r.statement(s, false));
                    }
                    _ => r.statement(body, false),
                },
                FunctionBody::Symbolic(e) => r.expr(e),
                FunctionBody::Extern { .. } => {}
            }
        });
        self.function = around;
    }

    fn twice(&mut self, name: &Ident) {
        let message = format!("`{}` is declared twice in the same block", name.name);
        self.report(
            Diagnostic::error("E0202", message, name.span, "declared again here").help("choose another name"),
        );
    }

    /// The target of an assignment: naming it is no use of it.
    fn place(&mut self, place: &'a Expr) {
        match &place.kind {
            ExprKind::Name(name) => {
                let res = self.lookup(name);
                self.names.uses.insert(name.span, res);
                self.names.written.insert(name.span);
                if let Res::Var(id) = res {
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

    /// Records and dimensions named in a type. What is not found may still be a name of the language.
    fn type_expr(&mut self, annotation: &'a TypeExpr) {
        match &annotation.kind {
            TypeKind::Name(name) => {
                let found = self.scopes.iter().rev().find_map(|scope| scope.names.get(&name.name));
                if let Some((res @ (Res::Record(_) | Res::Dimension(_)), _)) = found {
                    self.names.uses.insert(name.span, *res);
                }
            }
            TypeKind::Member(module, name) => {
                let res = self.lookup(module);
                self.names.uses.insert(module.span, res);
                self.member(module, res, name);
            }
            TypeKind::Apply(_, parts) => parts.iter().for_each(|part| self.type_expr(part)),
            TypeKind::Product(a, b) | TypeKind::Quotient(a, b) => {
                self.type_expr(a);
                self.type_expr(b);
            }
            TypeKind::Power(base, ..) => self.type_expr(base),
            TypeKind::Error => {}
        }
    }

    /// The unit that a name after a number or in a format stands for, if the program declares it.
    fn own_unit(&self, name: &str) -> Option<Res> {
        let unit = |res: &Res| matches!(res, Res::OwnUnit(_)).then_some(*res);
        let mut files = self.scopes.iter().take(2).rev();
        let own = files.find_map(|scope| scope.names.get(name).and_then(|(res, _)| unit(res)));
        // Those of the modules it imports, directly or through others.
        own.or_else(|| (2..self.exports.len()).find_map(|module| self.exported_unit(module, name)))
    }

    fn exported_unit(&self, module: usize, name: &str) -> Option<Res> {
        let (res, _) = self.exports[module].get(name)?;
        let public = !self.private[module].contains(name);
        (public && matches!(res, Res::OwnUnit(_))).then_some(*res)
    }

    /// A unit right after a number.
    fn quantity(&mut self, unit: &'a Ident) {
        let known = Unit::find(&unit.name).map(Res::Unit).or_else(|| self.own_unit(&unit.name));
        self.names.uses.extend(known.map(|res| (unit.span, res)));
        let hidden = self.scopes.iter().rev().find_map(|scope| scope.names.get(&unit.name));
        if let Some((Res::Var(_) | Res::Param(_) | Res::Const(_), declared)) = hidden
            && known.is_some()
        {
            let before = Span { end: unit.span.start, ..unit.span };
            let message =
                format!("`{0}` after a number is the unit, not what is called `{0}` here", unit.name);
            self.report(
                Diagnostic::warning("W0205", message, unit.span, "the unit")
                    .label(*declared, "this is not meant")
                    .help(format!("write `*` to multiply by it: `2*{}`, or choose another name", unit.name))
                    .suggest(format!("multiply by `{}`", unit.name), before, "* "),
            );
        }
    }

    /// A product of units in a format: its names are units whatever else they may be.
    fn unit_product(&mut self, e: &'a Expr) {
        match &e.kind {
            ExprKind::Name(name) => {
                let unit = Unit::find(&name.name).map(Res::Unit).or_else(|| self.own_unit(&name.name));
                self.names.uses.insert(name.span, unit.unwrap_or(Res::Unknown));
            }
            ExprKind::Binary { left, right, .. } => {
                self.unit_product(left);
                self.unit_product(right);
            }
            ExprKind::Paren(inner) | ExprKind::Unary { operand: inner, .. } => self.unit_product(inner),
            _ => {}
        }
    }

    fn outer(&mut self, id: VarId) {
        if self.names.variables[id.0 as usize].owner != self.function {
            self.names.functions[self.function.0 as usize].outer.insert(id);
        }
    }

    fn expr(&mut self, e: &'a Expr) {
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
                arguments.iter().for_each(|argument| self.expr(&argument.value));
            }
            ExprKind::Index { base, index } => {
                self.expr(base);
                self.expr(index);
            }
            ExprKind::Unary { operand, .. } => self.expr(operand),
            ExprKind::Binary { left, right, .. } => {
                self.expr(left);
                self.expr(right);
            }
            ExprKind::List(elements) => elements.iter().for_each(|e| self.expr(e)),
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
            ExprKind::Paren(inner) => self.expr(inner),
        }
    }

    fn name(&mut self, name: &'a Ident) {
        let res = self.lookup(name);
        self.names.uses.insert(name.span, res);
        match res {
            Res::Var(id) => {
                self.names.variables[id.0 as usize].reads += 1;
                self.outer(id);
                self.refuse_in_test(name, id);
            }
            Res::Function(id) => {
                self.names.functions[self.function.0 as usize].callees.insert(id);
            }
            _ => {}
        }
    }

    fn field(&mut self, base: &'a Expr, field: &'a Ident) {
        self.expr(base);
        let ExprKind::Name(name) = &base.kind else { return };
        if let Some(res) = self.names.uses.get(&name.span).copied() {
            self.member(name, res, field);
        }
    }

    /// The field of a place, which is one of a module where its base is one.
    fn field_of(&mut self, base: &'a Expr, place: &'a Expr) {
        if let (ExprKind::Name(name), ExprKind::Field { field, .. }) = (&base.kind, &place.kind)
            && let Some(res) = self.names.uses.get(&name.span).copied()
        {
            self.member(name, res, field);
        }
    }

    /// What a module's member stands for.
    fn member(&mut self, name: &Ident, module: Res, field: &'a Ident) {
        let module = match module {
            Res::Module(module) => module as usize,
            Res::Unknown => {
                self.names.uses.insert(field.span, Res::Unknown);
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
                    .help("use what the module offers, or remove `private`");
                self.report(diagnostic);
                Res::Unknown
            }
            None => {
                let mut diagnostic = Diagnostic::error(
                    "E0204",
                    format!("module `{}` has nothing called `{}`", name.name, field.name),
                    field.span,
                    "not found in the module",
                );
                let all = self.around.declared(&self.modules[module].name);
                diagnostic = match similar(&field.name, all.iter().map(String::as_str)) {
                    Some(near) => diagnostic.help(format!("did you mean `{near}`?")).fix(
                        format!("change to `{near}`"),
                        field.span,
                        near,
                    ),
                    None => {
                        let all: Vec<_> = all.iter().map(|name| format!("`{name}`")).collect();
                        match all.is_empty() {
                            true => diagnostic.help("it has nothing that others see"),
                            false => diagnostic.help(format!("it has {}", all.join(", "))),
                        }
                    }
                };
                self.report(diagnostic);
                Res::Unknown
            }
        };
        self.names.uses.insert(field.span, res);
        if let Res::Function(id) = res {
            self.names.functions[self.function.0 as usize].callees.insert(id);
        }
    }

    fn lookup(&mut self, name: &Ident) -> Res {
        if let Some(constant) = builtins::constant(&name.name) {
            return Res::Constant(constant);
        }
        for scope in self.scopes.iter().rev() {
            if let Some((res, _)) = scope.names.get(&name.name) {
                return *res;
            }
        }
        if let Some(builtin) = Builtin::find(&name.name) {
            return Res::Builtin(builtin);
        }
        if let Some(unit) = Unit::find(&name.name) {
            return Res::Unit(unit);
        }
        self.unknown(name);
        Res::Unknown
    }

    fn unknown(&mut self, name: &Ident) {
        let diagnostic = Diagnostic::error(
            "E0201",
            format!("`{}` is not known here", name.name),
            name.span,
            "unknown name",
        );
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
        // Every name is compared with every other: in a text of many thousand errors nobody waits for that.
        let mut declared: Vec<String>;
        let suggests = self.around.suggests() && self.names.diagnostics.len() < MOST_SUGGESTIONS;
        if suggests {
            declared =
                self.modules.get(self.file.0 as usize).map_or(Vec::new(), |m| self.around.declared(&m.name));
            declared.extend(self.around.declared("prelude"));
            candidates = builtins::names().collect();
            candidates.extend(self.scopes.iter().flat_map(|scope| scope.names.keys().map(String::as_str)));
            candidates.extend(declared.iter().map(String::as_str));
        }
        let near = match reserved {
            Some(near) => Some(near.to_string()),
            None if !suggests => None,
            None => similar(&name.name, candidates.into_iter())
                .or_else(|| Unit::similar(&name.name).filter(|near| near.len() > 2).map(str::to_string)),
        };
        let diagnostic = match near {
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
}

/// The name of a declaration that a module can hold.
fn item_name(statement: &Stmt) -> Option<&Ident> {
    match &statement.kind {
        StmtKind::Function(decl) => Some(&decl.name),
        StmtKind::Record(decl) => Some(&decl.name),
        StmtKind::Unit(decl) => Some(&decl.name),
        StmtKind::Const { name, .. } | StmtKind::Dimension { name, .. } => Some(name),
        _ => None,
    }
}
