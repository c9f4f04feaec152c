//! Coverage of productions of the grammar: a row per kind of node of the syntax tree, and per form
//! of it with its own parser rule.
//!
//! The matches are exhaustive, so that a new kind of node does not compile without a row here, and
//! then requires a case.

use super::rows;
use calyx_lang::ast::*;
use std::collections::BTreeSet;

rows!(statement(StmtKind) {
    StmtKind::Empty => "`;`",
    StmtKind::Error => "a statement that cannot be read",
    StmtKind::Import(path) if path.len() > 1 => "`import folder.name;`",
    StmtKind::Import(_) => "`import name;`",
    StmtKind::Units(_) => "`units name;`",
    StmtKind::Param(_) => "`param name = e;`",
    StmtKind::Output { .. } => "`output name := e;`",
    StmtKind::Var(_) => "`var ...;`",
    StmtKind::Assign { bind: Bind::Evaluate, .. } => "`place = e;`",
    StmtKind::Assign { bind: Bind::Symbolic, .. } => "`place := e;`",
    StmtKind::Expr(_) => "`e;`",
    StmtKind::Function(_) => "`function`",
    StmtKind::Const { .. } => "`const name = e;`",
    StmtKind::Record(_) => "`record`",
    StmtKind::Dimension { value: None, .. } => "`dimension name;`",
    StmtKind::Dimension { value: Some(_), .. } => "`dimension name = T;`",
    StmtKind::Unit(UnitDecl { meaning: UnitMeaning::Coherent(_), .. }) => "`unit name: T;`",
    StmtKind::Unit(UnitDecl { meaning: UnitMeaning::Equal(_), .. }) => "`unit name = e;`",
    StmtKind::Block(_) => "`{ ... }`",
    StmtKind::If { otherwise: None, .. } => "`if (e) s`",
    StmtKind::If { otherwise: Some(_), .. } => "`if (e) s else s`",
    StmtKind::While { .. } => "`while (e) s`",
    StmtKind::DoWhile { .. } => "`do s while (e);`",
    StmtKind::For { condition: None, .. } => "`for (...; ; ...) s`",
    StmtKind::For { condition: Some(_), .. } => "`for (...; e; ...) s`",
    StmtKind::Switch { .. } => "`switch (e) s`",
    StmtKind::Case { .. } => "`case e: s`",
    StmtKind::Default(_) => "`default: s`",
    StmtKind::Label { .. } => "`label: s`",
    StmtKind::Goto(_) => "`goto label;`",
    StmtKind::Break => "`break;`",
    StmtKind::Continue => "`continue;`",
    StmtKind::Return(None) => "`return;`",
    StmtKind::Return(Some(_)) => "`return e;`",
    StmtKind::Throw(None) => "`throw;`",
    StmtKind::Throw(Some(_)) => "`throw e;`",
    StmtKind::Try { error: None, .. } => "`try s catch () s`",
    StmtKind::Try { error: Some(_), .. } => "`try s catch (name) s`",
});

rows!(declaration(VarDecl) {
    VarDecl { init: None, .. } => "`var name`",
    VarDecl { init: Some((Bind::Evaluate, _)), .. } => "`var name = e`",
    VarDecl { init: Some((Bind::Symbolic, _)), .. } => "`var name := e`",
});

rows!(field(RecordField) {
    RecordField { annotation: None, .. } => "field `name = e`",
    RecordField { annotation: Some(_), default: None, .. } => "field `name: T`",
    RecordField { annotation: Some(_), default: Some(_), .. } => "field `name: T = e`",
});

rows!(domain(Domain) {
    Domain::Range { low: None, .. } => "`in .. high`",
    Domain::Range { high: None, .. } => "`in low ..`",
    Domain::Range { .. } => "`in low .. high`",
    Domain::Choices { .. } => "`in [a, b]`",
});

rows!(body(FunctionBody) {
    FunctionBody::Statement(_) => "`function f(...) s`",
    FunctionBody::Symbolic(_) => "`function f(...) := e;`",
    FunctionBody::Extern { purity: None } => "`extern function`",
    FunctionBody::Extern { purity: Some(_) } => "`extern pure function`",
});

rows!(mode(Mode) {
    Mode::In => "`in name`",
    Mode::Out => "`out name`",
    Mode::InOut => "`inout name`",
});

rows!(parameter(Parameter) {
    Parameter { default: None, .. } => "a parameter without default",
    Parameter { default: Some((Bind::Evaluate, _)), .. } => "`in name = e`",
    Parameter { default: Some((Bind::Symbolic, None)), .. } => "`in name :=`",
    Parameter { default: Some((Bind::Symbolic, Some(_))), .. } => "`in name := e`",
});

rows!(annotation(TypeKind) {
    TypeKind::Name(_) => "type `Name`",
    TypeKind::Member(..) => "type `module.Name`",
    TypeKind::Apply(..) => "type `Name(T)`",
    TypeKind::Product(..) => "type `T*T`",
    TypeKind::Quotient(..) => "type `T/T`",
    TypeKind::Power(_, _, 1) => "type `T^n`",
    TypeKind::Power(..) => "type `T^(n/m)`",
    TypeKind::Error => "a type that cannot be read",
});

rows!(expression(ExprKind) {
    ExprKind::Error => "an expression that cannot be read",
    ExprKind::Number(_) => "`1.5`",
    ExprKind::Quantity { exponent_span: None, .. } => "`1.5 unit`",
    ExprKind::Quantity { exponent_span: Some(_), .. } => "`1.5 unit^n`",
    ExprKind::Bool(true) => "`TRUE`",
    ExprKind::Bool(false) => "`FALSE`",
    ExprKind::String(_) => "`\"...\"`",
    ExprKind::Name(_) => "`name`",
    ExprKind::Field { .. } => "`e.name`",
    ExprKind::Call { .. } => "`f(...)`",
    ExprKind::Index { .. } => "`e[e]`",
    ExprKind::Unary { .. } => "a sign or `!`",
    ExprKind::Binary { .. } => "an operator between two operands",
    ExprKind::List(elements) if elements.is_empty() => "`[]`",
    ExprKind::List(_) => "`[a, b]`",
    ExprKind::If { .. } => "`if (e) e else e`",
    ExprKind::At { .. } => "`e at name = e`",
    ExprKind::Paren(_) => "`(e)`",
});

rows!(string_part(StringPart) {
    StringPart::Text(_) => "text in a string",
    StringPart::Value(_, None) => "`{e}` in a string",
    StringPart::Value(_, Some(Format { width: Some(_), .. })) => "`{e : 10}` in a string",
    StringPart::Value(_, Some(Format { scientific: true, .. })) => "`{e : e}` in a string",
    StringPart::Value(_, Some(Format { digits: Some(_), .. })) => "`{e : .3}` in a string",
    StringPart::Value(_, Some(_)) => "`{e : unit}` in a string",
});

rows!(argument(Argument) {
    Argument { spread: true, .. } => "argument `..e`",
    Argument { name: None, .. } => "argument `e`",
    Argument { name: Some((_, Bind::Evaluate)), .. } => "argument `name = e`",
    Argument { name: Some((_, Bind::Symbolic)), .. } => "argument `name := e`",
});

rows!(unary(UnaryOp) {
    UnaryOp::Plus => "`+e`",
    UnaryOp::Minus => "`-e`",
    UnaryOp::Not => "`!e`",
});

rows!(binary(BinaryOp) {
    BinaryOp::Or => "`e | e`",
    BinaryOp::And => "`e & e`",
    BinaryOp::Less => "`e < e`",
    BinaryOp::LessEqual => "`e <= e`",
    BinaryOp::Greater => "`e > e`",
    BinaryOp::GreaterEqual => "`e >= e`",
    BinaryOp::Equal => "`e == e`",
    BinaryOp::NotEqual => "`e != e`",
    BinaryOp::Add => "`e + e`",
    BinaryOp::Subtract => "`e - e`",
    BinaryOp::Multiply => "`e * e`",
    BinaryOp::Divide => "`e / e`",
    BinaryOp::Power => "`e ^ e`",
});

/// Forms without a variant of their own.
const FORMS: [&str; 7] = [
    "`///` at the beginning of a file",
    "`///` before a declaration",
    "`///` before a parameter",
    "`-> T`",
    "`private`",
    "`test function`",
    "`host function`",
];

/// Returns all productions, in the order of the tree's definition.
pub fn all() -> Vec<&'static str> {
    let groups = [
        statement::ALL,
        declaration::ALL,
        field::ALL,
        domain::ALL,
        body::ALL,
        mode::ALL,
        parameter::ALL,
        annotation::ALL,
        expression::ALL,
        string_part::ALL,
        argument::ALL,
        unary::ALL,
        binary::ALL,
        &FORMS,
    ];
    groups.concat()
}

/// Returns the productions of a file.
pub fn used(module: &Module) -> BTreeSet<&'static str> {
    let mut walk = Walk(BTreeSet::new());
    if module.doc.is_some() {
        walk.0.insert(FORMS[0]);
    }
    walk.statements(&module.statements);
    walk.0
}

struct Walk(BTreeSet<&'static str>);

impl Walk {
    fn statements(&mut self, statements: &[Stmt]) {
        statements.iter().for_each(|s| self.statement(s));
    }

    fn statement(&mut self, s: &Stmt) {
        self.0.insert(statement::row(&s.kind));
        if s.doc.is_some() {
            self.0.insert(FORMS[1]);
        }
        if s.private {
            self.0.insert(FORMS[4]);
        }
        match &s.kind {
            StmtKind::Empty
            | StmtKind::Error
            | StmtKind::Import(_)
            | StmtKind::Units(_)
            | StmtKind::Goto(_)
            | StmtKind::Break
            | StmtKind::Continue => {}
            StmtKind::Param(param) => {
                self.expression(&param.default);
                self.domain(param.domain.as_ref());
            }
            StmtKind::Output { value, .. } | StmtKind::Expr(value) => self.expression(value),
            StmtKind::Var(declarations) => {
                for one in declarations {
                    self.0.insert(declaration::row(one));
                    if let Some((_, value)) = &one.init {
                        self.expression(value);
                    }
                }
            }
            StmtKind::Assign { place, value, .. } => self.expressions([place, value]),
            StmtKind::Function(function) => self.function(function),
            StmtKind::Const { value, .. } => self.expression(value),
            StmtKind::Record(record) => {
                for one in &record.fields {
                    self.0.insert(field::row(one));
                    one.annotation.iter().for_each(|ty| self.annotation(ty));
                    self.expressions(&one.default);
                }
            }
            StmtKind::Dimension { value, .. } => value.iter().for_each(|ty| self.annotation(ty)),
            StmtKind::Unit(unit) => match &unit.meaning {
                UnitMeaning::Coherent(ty) => self.annotation(ty),
                UnitMeaning::Equal(value) => self.expression(value),
            },
            StmtKind::Block(inner) => self.statements(inner),
            StmtKind::If { condition, then, otherwise } => {
                self.expression(condition);
                self.statement(then);
                otherwise.iter().for_each(|s| self.statement(s));
            }
            StmtKind::While { condition, body } | StmtKind::DoWhile { body, condition } => {
                self.expression(condition);
                self.statement(body);
            }
            StmtKind::For { init, condition, step, body } => {
                self.expressions(condition);
                [init, step, body].into_iter().for_each(|s| self.statement(s));
            }
            StmtKind::Switch { value, body } | StmtKind::Case { value, statement: body } => {
                self.expression(value);
                self.statement(body);
            }
            StmtKind::Default(inner) | StmtKind::Label { statement: inner, .. } => self.statement(inner),
            StmtKind::Return(value) | StmtKind::Throw(value) => self.expressions(value),
            StmtKind::Try { body, handler, .. } => {
                self.statement(body);
                self.statement(handler);
            }
        }
    }

    fn domain(&mut self, written: Option<&Domain>) {
        let Some(written) = written else { return };
        self.0.insert(domain::row(written));
        match written {
            Domain::Range { low, high, .. } => self.expressions(low.iter().chain(high)),
            Domain::Choices { values, .. } => self.expressions(values),
        }
    }

    fn function(&mut self, function: &FunctionDecl) {
        self.0.insert(body::row(&function.body));
        for one in &function.parameters {
            self.0.insert(mode::row(&one.mode));
            self.0.insert(parameter::row(one));
            if one.doc.is_some() {
                self.0.insert(FORMS[2]);
            }
            one.annotation.iter().for_each(|ty| self.annotation(ty));
            if let Some((_, Some(default))) = &one.default {
                self.expression(default);
            }
            self.domain(one.domain.as_ref());
        }
        if let Some(result) = &function.result {
            self.0.insert(FORMS[3]);
            self.annotation(result);
        }
        if function.is_test {
            self.0.insert(FORMS[5]);
        }
        if function.is_host {
            self.0.insert(FORMS[6]);
        }
        match &function.body {
            FunctionBody::Statement(statement) => self.statement(statement),
            FunctionBody::Symbolic(value) => self.expression(value),
            FunctionBody::Extern { .. } => {}
        }
    }

    fn annotation(&mut self, ty: &TypeExpr) {
        self.0.insert(annotation::row(&ty.kind));
        match &ty.kind {
            TypeKind::Name(_) | TypeKind::Member(..) | TypeKind::Error => {}
            TypeKind::Apply(_, inner) => inner.iter().for_each(|ty| self.annotation(ty)),
            TypeKind::Product(a, b) | TypeKind::Quotient(a, b) => {
                self.annotation(a);
                self.annotation(b);
            }
            TypeKind::Power(base, ..) => self.annotation(base),
        }
    }

    fn expressions<'e>(&mut self, all: impl IntoIterator<Item = &'e Expr>) {
        all.into_iter().for_each(|e| self.expression(e));
    }

    fn expression(&mut self, e: &Expr) {
        self.0.insert(expression::row(&e.kind));
        match &e.kind {
            ExprKind::Error
            | ExprKind::Number(_)
            | ExprKind::Quantity { .. }
            | ExprKind::Bool(_)
            | ExprKind::Name(_) => {}
            ExprKind::String(parts) => {
                for part in parts {
                    self.0.insert(string_part::row(part));
                    if let StringPart::Value(value, format) = part {
                        self.expression(value);
                        self.expressions(format.iter().filter_map(|format| format.unit.as_ref()));
                    }
                }
            }
            ExprKind::Field { base, .. } => self.expression(base),
            ExprKind::Call { callee, arguments } => {
                self.expression(callee);
                for one in arguments {
                    self.0.insert(argument::row(one));
                    self.expression(&one.value);
                }
            }
            ExprKind::Index { base, index } => self.expressions([&**base, &**index]),
            ExprKind::Unary { op, operand } => {
                self.0.insert(unary::row(op));
                self.expression(operand);
            }
            ExprKind::Binary { op, left, right, .. } => {
                self.0.insert(binary::row(op));
                self.expressions([&**left, &**right]);
            }
            ExprKind::List(elements) => self.expressions(elements),
            ExprKind::If { condition, then, otherwise } => {
                self.expressions([&**condition, &**then, &**otherwise]);
            }
            ExprKind::At { value, at, .. } => self.expressions([&**value, &**at]),
            ExprKind::Paren(inner) => self.expression(inner),
        }
    }
}
