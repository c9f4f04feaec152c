//! Checks statements: converts syntax to the typed tree.

use super::builtins::Builtin;
use super::constant;
use super::dependence::Region;
use super::infer::Checker;
use super::optional::continues;
use super::symbols::{Resolution, similar};
use super::tree::*;
use super::types::Type;
use crate::ast::{self, BinaryOp, ExprKind};
use crate::diagnostic::Diagnostic;
use crate::span::Span;

impl<'a> Checker<'a> {
    pub(super) fn statements(&mut self, statements: &'a [ast::Stmt]) -> Vec<Stmt> {
        let mut checked = Vec::with_capacity(statements.len());
        for s in statements {
            checked.push(self.statement(s));
            self.solve_constraints();
        }
        checked
    }

    pub(super) fn statement(&mut self, statement: &'a ast::Stmt) -> Stmt {
        let kind = self.statement_kind(statement);
        let statement = Stmt { kind, span: statement.span };
        if !has_parts(&statement.kind) {
            statement.expressions().into_iter().for_each(|e| self.note_evaluated(e));
        }
        statement
    }

    pub(super) fn boxed(&mut self, statement: &'a ast::Stmt) -> Box<Stmt> {
        Box::new(self.statement(statement))
    }

    fn statement_kind(&mut self, statement: &'a ast::Stmt) -> StmtKind {
        use ast::StmtKind as Ast;
        match &statement.kind {
            Ast::Empty
            | Ast::Error
            | Ast::Import(_)
            | Ast::Param(_)
            // Already declared, before the other statements.
            | Ast::Const { .. }
            | Ast::Record(_)
            | Ast::Enum(_)
            | Ast::Dimension { .. }
            | Ast::Unit(_) => StmtKind::Nothing,
            Ast::Units(name) => {
                self.units(name);
                StmtKind::Nothing
            }
            Ast::Output { name, value, unit } => match self.names.uses.get(&name.span) {
                Some(Resolution::Output(id)) => self.output(*id, name, value, unit.as_ref()),
                _ => StmtKind::Nothing,
            },
            Ast::Var(decls) => self.variables(decls),
            Ast::Assign { place, bind, value } => self.assign(place, *bind, value),
            Ast::Update { place, op, op_span, value } => {
                self.update(place, (*op, *op_span), value, statement.span)
            }
            Ast::Expr(e) => self.expression(e),
            Ast::Function(decl) => {
                if let Some(Resolution::Function(id)) = self.names.uses.get(&decl.name.span) {
                    self.ensure_inferred(*id);
                }
                StmtKind::Nothing
            }
            Ast::Block(statements) => StmtKind::Block(self.statements(statements)),
            Ast::If { condition, then, otherwise } => {
                self.if_statement(condition, then, otherwise.as_deref())
            }
            Ast::While { condition, body } => self.while_loop(condition, body),
            Ast::DoWhile { body, condition } => self.do_while_loop(body, condition),
            Ast::For { init, condition, step, body } => {
                self.for_loop(init, condition.as_ref(), step, body)
            }
            Ast::ForEach { variable, values, body } => {
                self.for_each(variable, values, body)
            }
            Ast::Switch { value, body } => self.switch(value, body),
            Ast::Case { value, statement: inner } => {
                self.forget_rebound();
                let value = self.case(value, statement.span);
                self.note_evaluated(&value);
                self.dependence.decides(&value);
                StmtKind::Case(value, self.boxed(inner))
            }
            Ast::Default(inner) => {
                self.forget_rebound();
                if self.switches.is_empty() {
                    self.outside_switch("default", statement.span);
                }
                StmtKind::Default(self.boxed(inner))
            }
            Ast::Label { label, statement } => {
                self.forget_rebound();
                StmtKind::Label(label.name.to_string(), self.boxed(statement))
            }
            Ast::Goto(label) => {
                self.dependence.jump();
                StmtKind::Goto(label.name.to_string())
            }
            Ast::Break => {
                self.dependence.break_out();
                StmtKind::Break
            }
            Ast::Continue => {
                self.dependence.continue_loop();
                StmtKind::Continue
            }
            Ast::Return(value) => self.return_value(value.as_ref(), statement.span),
            Ast::Throw(value) => self.throw(value.as_ref(), statement.span),
            Ast::Try { body, error, handler } => self.try_catch(body, error.as_ref(), handler),
        }
    }

    fn variables(&mut self, decls: &'a [ast::VarDecl]) -> StmtKind {
        let all = decls.iter().map(|decl| Stmt { kind: self.variable_decl(decl), span: decl.name.span });
        let mut all: Vec<Stmt> = all.collect();
        match (all.len(), all.pop()) {
            (1, Some(only)) => only.kind,
            (_, Some(last)) => {
                all.push(last);
                StmtKind::Block(all)
            }
            (_, None) => StmtKind::Nothing,
        }
    }

    fn if_statement(
        &mut self,
        condition: &'a ast::Expr,
        then: &'a ast::Stmt,
        otherwise: Option<&'a ast::Stmt>,
    ) -> StmtKind {
        let (yes, no) = self.facts(condition);
        let condition = self.condition(condition);
        self.note_evaluated(&condition);
        self.dependence.open(Region::Choice);
        self.dependence.decides(&condition);
        let ((then, after_then), (otherwise, after_otherwise)) = self.either(
            |c| {
                c.present.extend(yes);
                let then = c.boxed(then);
                let goes_on = continues(&then);
                (then, goes_on.then(|| c.present.clone()))
            },
            |c| {
                c.present.extend(no);
                let otherwise = otherwise.map(|otherwise| c.boxed(otherwise));
                let goes_on = otherwise.as_ref().is_none_or(|otherwise| continues(otherwise));
                (otherwise, goes_on.then(|| c.present.clone()))
            },
        );
        // A branch that leaves does not reach the next statement.
        if let (Some(only), None) | (None, Some(only)) = (after_then, after_otherwise) {
            self.present = only;
        }
        self.dependence.close();
        StmtKind::If(condition, then, otherwise)
    }

    fn while_loop(&mut self, condition: &'a ast::Expr, body: &'a ast::Stmt) -> StmtKind {
        self.repeated(&[body], |c| {
            c.dependence.open(Region::Loop);
            let (yes, _) = c.facts(condition);
            let condition = c.loop_condition(condition);
            c.present.extend(yes);
            let body = c.boxed(body);
            c.dependence.close();
            StmtKind::While(condition, body)
        })
    }

    fn do_while_loop(&mut self, body: &'a ast::Stmt, condition: &'a ast::Expr) -> StmtKind {
        self.repeated(&[body], |c| {
            c.dependence.open(Region::Loop);
            let body = c.boxed(body);
            let condition = c.loop_condition(condition);
            c.dependence.close();
            StmtKind::DoWhile(body, condition)
        })
    }

    fn for_loop(
        &mut self,
        init: &'a ast::Stmt,
        condition: Option<&'a ast::Expr>,
        step: &'a ast::Stmt,
        body: &'a ast::Stmt,
    ) -> StmtKind {
        let init = self.boxed(init);
        self.repeated(&[step, body], |c| {
            c.dependence.open(Region::Loop);
            let condition = condition.map(|condition| c.loop_condition(condition));
            let body = c.boxed(body);
            let step = c.boxed(step);
            c.dependence.close();
            StmtKind::For { init, condition, step, body }
        })
    }

    fn switch(&mut self, value: &'a ast::Expr, body: &'a ast::Stmt) -> StmtKind {
        let value = self.expr(value);
        let comparable = ConstraintKind::Comparable(value.ty.clone());
        self.constrain(Constraint { kind: comparable, span: value.span });
        self.note_evaluated(&value);
        self.dependence.open(Region::Switch);
        self.dependence.decides(&value);
        self.switches.push((value.clone(), Vec::new()));
        let checked = self.repeated(&[body], |c| c.boxed(body));
        if let Some((_, cases)) = self.switches.pop() {
            self.check_all_choices(&value, &cases, body);
        }
        self.dependence.close();
        StmtKind::Switch(value, checked)
    }

    fn units(&mut self, name: &ast::Ident) {
        if crate::units::UnitSystem::from_name(&name.name).is_none() {
            let all = crate::units::UnitSystem::ALL.map(|system| system.name());
            let listed = all.map(|name| format!("`{name}`")).join(", ");
            let mut problem = Diagnostic::error(
                "E0404",
                format!("there is no unit system `{}`", name.name),
                name.span,
                "unknown system",
            )
            .help(format!("choose one of {listed}"));
            if let Some(near) = similar(&name.name, all.into_iter()) {
                problem = problem.help(format!("did you mean `{near}`? The systems are {listed}")).fix(
                    format!("change to `{near}`"),
                    name.span,
                    near,
                );
            }
            self.report(problem);
        }
    }

    fn condition(&mut self, e: &'a ast::Expr) -> Expr {
        let condition = self.expr(e);
        self.expect(&Type::Bool, &condition, "a condition", None);
        condition
    }

    /// Checks the condition of the loop that is the innermost region.
    fn loop_condition(&mut self, e: &'a ast::Expr) -> Expr {
        let condition = self.condition(e);
        self.dependence.decides(&condition);
        self.note_evaluated(&condition);
        condition
    }

    /// Records the dependences of the evaluation of an expression.
    pub(super) fn note_evaluated(&mut self, e: &Expr) {
        let variables = &self.names.variables;
        self.dependence.evaluated(e, &|id| variables[id.0 as usize].owner);
    }

    fn expression(&mut self, e: &'a ast::Expr) -> StmtKind {
        if let ExprKind::Call { callee, arguments } = &e.kind
            && let ExprKind::Name(name) = &callee.kind
            && self.builtin(name) == Some(Builtin::Push)
        {
            return self.push(arguments, e.span);
        }
        let value = self.expr(e);
        // Arguments that defaults use are stored before the call.
        let mut result = &value;
        while let Kind::Sequence(_, last) = &result.kind {
            result = last;
        }
        let call = matches!(
            result.kind,
            Kind::Call(_) | Kind::CallExtern(..) | Kind::Print(..) | Kind::Assert(..) | Kind::Error
        );
        if !call {
            let problem = Diagnostic::warning(
                "W0203",
                "the value of this expression is not used",
                e.span,
                "the value is dropped",
            )
            .help("assign it to a variable, or remove it");
            // `a == b;` was probably intended as an assignment.
            let problem = match &e.kind {
                ExprKind::Binary { op: BinaryOp::Equal, op_span, left, .. } if may_be_place(left) => {
                    problem.suggest("assign with `=`", *op_span, "=")
                }
                _ => problem,
            };
            self.report(problem);
        }
        StmtKind::Eval(value)
    }

    fn case(&mut self, value: &'a ast::Expr, span: Span) -> Expr {
        let value = self.expr(value);
        let Some((switched, earlier)) = self.switches.pop() else {
            self.outside_switch("case", span);
            return value;
        };
        self.same(&switched, &value, value.span, "compare");
        let duplicate = earlier.iter().find(|e| constant::equal(e, &value, &self.store)).map(|e| e.span);
        if let Some(first) = duplicate {
            self.report(
                Diagnostic::error("E0315", "this case occurs twice", value.span, "never reached")
                    .label(first, "first here")
                    .help("remove one of them"),
            );
        }
        let mut cases = earlier;
        cases.push(value.clone());
        self.switches.push((switched, cases));
        value
    }

    fn outside_switch(&mut self, word: &str, span: Span) {
        self.report(
            Diagnostic::error("E0214", format!("`{word}` is outside a `switch`"), span, "not in a switch")
                .help("move it into the body of a `switch`"),
        );
    }

    fn return_value(&mut self, value: Option<&'a ast::Expr>, span: Span) -> StmtKind {
        let top = self.function == FuncId(0);
        if self.names.functions[self.function.0 as usize].is_component() {
            self.report(
                Diagnostic::error(
                    "E0876",
                    "a component does not return",
                    span,
                    "the members of an instance must all have values",
                )
                .help("use `if`, or move the statements into a function"),
            );
            value.map(|value| self.stored(value));
            return StmtKind::Nothing;
        }
        let result = self.current_result();
        self.dependence.leave_function();
        match value {
            None => {
                if !top && self.store.unify(&result, &Type::Unit).is_err() {
                    self.report(
                        Diagnostic::error(
                            "E0316",
                            "this function returns a value",
                            span,
                            "no value returned here",
                        )
                        .help(format!("return a {}", self.store.show(&result))),
                    );
                }
                StmtKind::Return(None)
            }
            Some(value) => {
                let value = self.stored(value);
                if top {
                    self.report(
                        Diagnostic::error(
                            "E0316",
                            "the top level returns no value",
                            span,
                            "a value is returned here",
                        )
                        .help("write `return;`"),
                    );
                    return StmtKind::Return(None);
                }
                let name = self.names.functions[self.function.0 as usize].name.clone();
                let decl = self.names.functions[self.function.0 as usize].decl;
                let declared_result = decl.and_then(|decl| decl.result.as_ref());
                let declared = self.names.functions[self.function.0 as usize].decl.map(|d| {
                    (d.result.as_ref().map_or(d.name.span, |r| r.span), format!("result of `{name}`"))
                });
                let value = self.fitted(&result, value);
                let own = self.names.functions[self.function.0 as usize].decl.map(|decl| decl.name.span);
                if let Some(own) = own.filter(|_| declared_result.is_none())
                    && self.observable_requested(own, &result, &value)
                {
                    return StmtKind::Nothing;
                }
                self.expect(&result, &value, format_args!("the result of `{name}`"), declared);
                let function = self.function;
                self.dependence.returned(function, &value);
                StmtKind::Return(Some(value))
            }
        }
    }
}

/// Returns `true` if a statement contains other statements. Its own expressions are recorded where
/// they are checked.
fn has_parts(kind: &StmtKind) -> bool {
    use StmtKind::*;
    matches!(
        kind,
        Block(_)
            | If(..)
            | While(..)
            | DoWhile(..)
            | For { .. }
            | Switch(..)
            | Case(..)
            | Default(_)
            | Label(..)
            | Try { .. }
    )
}

fn may_be_place(e: &ast::Expr) -> bool {
    matches!(e.kind, ExprKind::Name(_) | ExprKind::Index { .. } | ExprKind::Field { .. })
}
