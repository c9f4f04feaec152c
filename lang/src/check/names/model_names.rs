//! Names of the model's top level, which components cannot use.

use super::*;

impl<'a> Resolver<'a> {
    /// Counts the members of a component as used: other code may read them.
    pub(super) fn use_members(&mut self, statements: &'a [Stmt]) {
        let declared = statements.iter().filter_map(|statement| match &statement.kind {
            StmtKind::Var(decls) => Some(decls),
            _ => None,
        });
        for decl in declared.flatten() {
            if let Some(Resolution::Var(id)) = self.names.uses.get(&decl.name.span)
                && matches!(self.names.variables[id.0 as usize].kind, VarKind::Value | VarKind::Symbolic)
            {
                self.names.variables[id.0 as usize].reads += 1;
            }
        }
    }

    /// Rejects a name of the model's top level where it is not available.
    pub(super) fn refuse_state(&mut self, name: &Ident, res: Resolution) {
        let found = match res {
            Resolution::Var(id) => {
                let variable = &self.names.variables[id.0 as usize];
                Some((variable.owner, variable.span))
            }
            Resolution::Param(id) => {
                self.names.params.get(id as usize).map(|param| (param.owner, param.decl.name.span))
            }
            Resolution::Output(id) => {
                self.names.outputs.get(id as usize).map(|output| (output.owner, output.name.span))
            }
            _ => None,
        };
        if let Some((owner, declared)) = found {
            self.refuse_in_component(name, owner, declared);
        }
    }

    /// Rejects names of the model's top level in components, which exist once per instance and may
    /// be imported by other models.
    fn refuse_in_component(&mut self, name: &Ident, owner: FuncId, declared: Span) {
        let mut at = Some(self.function);
        while let Some(function) = at.filter(|_| owner == FuncId(0)) {
            let info = &self.names.functions[function.0 as usize];
            if info.is_component() {
                let component = info.name.clone();
                let message = format!("the component `{component}` cannot use `{}` of the model", name.name);
                self.report(
                    Diagnostic::error("E0871", message, name.span, "declared outside of the component")
                        .label(declared, "declared here")
                        .help(format!(
                            "add a parameter: `component {component}({})`, and pass the value",
                            name.name
                        )),
                );
                return;
            }
            at = info.parent;
        }
    }
}
