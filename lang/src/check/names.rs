//! Name resolution: determines the meaning of every identifier.
//!
//! It precedes type inference, so that a misspelt name is reported regardless of its type.
//! Functions are visible in their whole block, variables after their declaration.

mod ambiguous;
mod captured;
mod model_names;
mod statements;
mod test_functions;
mod unused;
mod uses;

use super::ModuleData;
use super::builtins::{self, Builtin};
use super::symbols::*;
use super::tree::{FuncId, RecordId, VarId};
use super::unit::Surroundings;
use crate::ast::*;
use crate::diagnostic::Diagnostic;
use crate::hashed::{HashMap, HashSet};
use crate::span::{FileId, Span};
use crate::units::Unit;
use smol_str::SmolStr;
use std::collections::BTreeSet;

pub(super) use captured::points_span;

#[derive(Default)]
struct Scope {
    names: HashMap<SmolStr, (Resolution, Span)>,
}

struct Resolver<'a> {
    names: Names<'a>,
    modules: &'a [ModuleData],
    around: &'a dyn Surroundings,
    /// Functions and externs by module and name.
    exports: Vec<HashMap<SmolStr, (Resolution, Span)>>,
    /// Names of each module that are private.
    private: Vec<HashSet<&'a str>>,
    scopes: Vec<Scope>,
    function: FuncId,
    file: FileId,
    /// True while the base of a member is resolved: the name before a dot.
    is_base: bool,
    /// Variables that name objects of libraries.
    created: Vec<VarId>,
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
        is_base: false,
        created: Vec::new(),
    };
    // On average, a text has a name for every 16 bytes.
    resolver.names.uses.reserve(modules.iter().map(|module| module.text.len()).sum::<usize>() / 16);
    resolver.names.functions.push(FunctionInfo {
        decl: None,
        name: "main".into(),
        file: FileId(0),
        parent: None,
        parameters: Vec::new(),
        outer: BTreeSet::new(),
        captured: Vec::new(),
        computed: None,
        callees: BTreeSet::new(),
    });
    for (index, module) in modules.iter().enumerate() {
        let mut exports = HashMap::default();
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
    let Resolver { mut names, created, .. } = resolver;
    unused::report(&mut names, &created);
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
        names: &mut HashMap<SmolStr, (Resolution, Span)>,
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
        names: &mut HashMap<SmolStr, (Resolution, Span)>,
        module: &str,
    ) {
        let name = &decl.name;
        let res = if matches!(decl.body, FunctionBody::Extern { .. }) {
            // Programs use the functions of the prelude without a module name.
            let (shown, prefix) = match module {
                "" | "prelude" => (name.name.to_string(), "std".to_string()),
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
                captured: Vec::new(),
                computed: None,
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
        names: &mut HashMap<SmolStr, (Resolution, Span)>,
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
}
