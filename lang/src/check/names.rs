//! Name resolution: determines the meaning of every identifier.
//!
//! It precedes type inference, so that a misspelt name is reported regardless of its type.
//! Functions are visible in their whole block, variables after their declaration.

mod ambiguous;
mod model_names;
mod test_functions;
mod uses;

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
    names: HashMap<String, (Resolution, Span)>,
}

struct Resolver<'a> {
    names: Names<'a>,
    modules: &'a [ModuleData],
    around: &'a dyn Surroundings,
    /// Functions and externs by module and name.
    exports: Vec<HashMap<String, (Resolution, Span)>>,
    /// Names of each module that are private.
    private: Vec<HashSet<&'a str>>,
    scopes: Vec<Scope>,
    function: FuncId,
    file: FileId,
}

/// Resolves all names. `modules[0]` is the model, `modules[1]` the prelude.
pub fn resolve<'a>(modules: &'a [ModuleData], around: &'a dyn Surroundings) -> Names<'a> {
    let mut resolver = Resolver {
        names: Names { around: Some(around), ..Names::default() },
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
        resolver.private.push(hidden.flat_map(uses::item_names).map(|name| name.name.as_str()).collect());
    }
    // Modules first, so that a model's diagnostics do not depend on the order in which modules are
    // resolved.
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
                        "a file has only one unit system",
                        statement.span,
                        format!("second unit system `{}`", second.name),
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
                    | StmtKind::Enum(_)
                    | StmtKind::Dimension { .. }
                    | StmtKind::Unit(_)
                    | StmtKind::Empty
                    | StmtKind::Error => {}
                    kind => {
                        let help = match kind {
                            StmtKind::Param(_) | StmtKind::Output { .. } => {
                                "move it to the model, or into a `component`, whose instances have it"
                            }
                            _ => "move it to the model, or into a function",
                        };
                        let message = "a module may contain only functions, components, constants, records, enumerations, dimensions, units and imports";
                        self.report(
                            Diagnostic::error("E0210", message, statement.span, "not allowed in a module")
                                .help(help),
                        );
                    }
                }
            }
            self.statement(statement, true);
        }
        self.scopes.clear();
    }

    fn report(&mut self, diagnostic: Diagnostic) {
        self.names.diagnostics.push(diagnostic);
    }

    /// Declares the functions, constants and other hoisted names of a block before its statements.
    fn declare_functions(&mut self, statements: &'a [Stmt]) {
        for statement in statements {
            let mut names = self.scopes.pop().unwrap_or_default().names;
            self.declare_item(statement, &mut names, "");
            self.scopes.push(Scope { names });
        }
    }

    fn declare_item(
        &mut self,
        statement: &'a Stmt,
        names: &mut HashMap<String, (Resolution, Span)>,
        module: &str,
    ) {
        let file = self.file;
        let mut former = None;
        let (name, res) = match &statement.kind {
            StmtKind::Function(decl) => return self.declare_function(decl, names, module),
            StmtKind::Const { name, value } => {
                self.names.consts.push(Declared { decl: ConstDecl { name, value }, file });
                (name, Resolution::Const(self.names.consts.len() as u32 - 1))
            }
            StmtKind::Record(decl) => {
                self.names.records.push(Declared { decl, file });
                former = decl.former.as_ref();
                (&decl.name, Resolution::Record(RecordId(self.names.records.len() as u32 - 1)))
            }
            StmtKind::Enum(decl) => {
                self.names.enums.push(Declared { decl, file });
                (&decl.name, Resolution::Enum(self.names.enums.len() as u32 - 1))
            }
            StmtKind::Dimension { name, value } => {
                let decl = DimensionDecl { name, value: value.as_ref() };
                self.names.dimensions.push(Declared { decl, file });
                (name, Resolution::Dimension(self.names.dimensions.len() as u32 - 1))
            }
            StmtKind::Unit(decl) => {
                self.names.units.push(Declared { decl, file });
                (&decl.name, Resolution::OwnUnit(self.names.units.len() as u32 - 1))
            }
            _ => return,
        };
        self.names.uses.insert(name.span, res);
        self.insert(names, name, res);
        if let Some(former) = former {
            self.insert(names, former, res);
        }
    }

    fn declare_function(
        &mut self,
        decl: &'a FunctionDecl,
        names: &mut HashMap<String, (Resolution, Span)>,
        module: &str,
    ) {
        let name = &decl.name;
        let res = if matches!(decl.body, FunctionBody::Extern { .. }) {
            // Programs use the functions of the prelude without a module name.
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
            Resolution::Extern(self.names.externs.len() as u32 - 1)
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
            Resolution::Function(FuncId(self.names.functions.len() as u32 - 1))
        };
        self.names.uses.insert(name.span, res);
        self.insert(names, name, res);
        if let Some(former) = &decl.former {
            self.insert(names, former, res);
        }
    }

    /// Declares a name in a block. Returns `false` and reports an error if the name is reserved or
    /// already declared.
    fn insert(
        &mut self,
        names: &mut HashMap<String, (Resolution, Span)>,
        name: &Ident,
        res: Resolution,
    ) -> bool {
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

    fn declare(&mut self, name: &Ident, res: Resolution) -> bool {
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
        if !self.declare(name, Resolution::Var(id)) {
            // The variable cannot be used, which has already been reported.
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
            StmtKind::Record(decl) => self.record(decl),
            StmtKind::Enum(decl) => self.enumeration(decl),
            StmtKind::Dimension { value, .. } => value.iter().for_each(|value| self.type_expr(value)),
            StmtKind::Unit(decl) => match &decl.meaning {
                UnitMeaning::Coherent(dimension) => self.type_expr(dimension),
                UnitMeaning::Equal(value) => self.expr(value),
            },
            StmtKind::Param(decl) => self.param(decl, statement.doc.as_deref(), top),
            StmtKind::Output { name, value } => self.output(name, value, statement.doc.as_deref(), top),
            StmtKind::Var(decls) => self.variables(decls),
            StmtKind::Assign { place, value, .. } => {
                self.place(place);
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

    fn record(&mut self, decl: &'a RecordDecl) {
        let mut seen = HashSet::new();
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
        let mut seen = HashSet::new();
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
            self.variable(&decl.name, if symbolic { VarKind::Symbolic } else { VarKind::Value });
        }
    }

    fn domain(&mut self, domain: Option<&'a Domain>) {
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
    fn nested(&mut self, statement: &'a Stmt) {
        self.scoped(|r| {
            r.declare_functions(std::slice::from_ref(statement));
            r.statement(statement, false);
        });
    }

    fn import(&mut self, path: &'a Import, top: bool) {
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

    fn function(&mut self, decl: &'a FunctionDecl) {
        if decl.is_test {
            self.test(decl);
        }
        decl.result.iter().for_each(|result| self.type_expr(result));
        for parameter in &decl.parameters {
            parameter.annotation.iter().for_each(|annotation| self.type_expr(annotation));
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
                let mut seen = HashSet::new();
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
    fn body(&mut self, body: &'a Stmt) {
        match &body.kind {
            // Parameters and body share one block, so the body cannot declare a parameter again.
            StmtKind::Block(statements) => {
                self.declare_functions(statements);
                statements.iter().for_each(|s| self.statement(s, false));
            }
            _ => self.statement(body, false),
        }
    }

    fn twice(&mut self, name: &Ident) {
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
