//! Coverage of productions of the grammar: a row per kind of node of the syntax tree, and per form
//! of it with its own parser rule.
//!
//! The matches are exhaustive, so that a new kind of node does not compile without a row here, and
//! then requires a case.

use super::rows;
use calyx_lang::ast::*;
use calyx_lang::walk::Node;
use std::collections::BTreeSet;

rows!(statement(StmtKind) {
    StmtKind::Empty => "`;`",
    StmtKind::Error => "a statement that cannot be read",
    StmtKind::Import(import) if import.alias.is_some() => "`import module as name;`",
    StmtKind::Import(path) if path.len() > 1 => "`import folder.name;`",
    StmtKind::Import(_) => "`import name;`",
    StmtKind::Units(_) => "`units name;`",
    StmtKind::Param(_) => "`param name = e;`",
    StmtKind::Output { .. } => "`output name := e;`",
    StmtKind::Var(_) => "`var ...;`",
    StmtKind::Assign { bind: Bind::Evaluate, .. } => "`place = e;`",
    StmtKind::Assign { bind: Bind::Symbolic, .. } => "`place := e;`",
    StmtKind::Update { op: BinaryOp::Subtract, .. } => "`place -= e;`",
    StmtKind::Update { op: BinaryOp::Multiply, .. } => "`place *= e;`",
    StmtKind::Update { op: BinaryOp::Divide, .. } => "`place /= e;`",
    StmtKind::Update { .. } => "`place += e;`",
    StmtKind::Expr(_) => "`e;`",
    StmtKind::Function(_) => "`function`",
    StmtKind::Const { .. } => "`const name = e;`",
    StmtKind::Record(_) => "`record`",
    StmtKind::Enum(_) => "`enum`",
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
    StmtKind::ForEach { values: Values::Elements(_), .. } => "`for (name in e) s`",
    StmtKind::ForEach { values: Values::Range(..), .. } => "`for (name in e .. e) s`",
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
    RecordField { former: Some(_), .. } => "field `name was former`",
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
    FunctionBody::Symbolic(Expr { kind: ExprKind::Block(_), .. }) => "`function f(...) := { ... }`",
    FunctionBody::Symbolic(_) => "`function f(...) := e;`",
    FunctionBody::Extern { purity: None, .. } => "`extern function`",
    FunctionBody::Extern { purity: Some(_), .. } => "`extern pure function`",
});

rows!(mode(Mode) {
    Mode::In => "`in name`",
    Mode::Out => "`out name`",
    Mode::InOut => "`inout name`",
});

rows!(parameter(Parameter) {
    Parameter { former: Some(_), .. } => "`in name was former`",
    Parameter { former_none: Some(_), .. } => "`in name = none was e`",
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
    TypeKind::Function(..) => "type `Function(T) -> T`",
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
    ExprKind::Slice { .. } => "`e[e .. e]`",
    ExprKind::Unary { .. } => "a sign or `!`",
    ExprKind::Binary { .. } => "an operator between two operands",
    ExprKind::List(elements) if elements.is_empty() => "`[]`",
    ExprKind::List(_) => "`[a, b]`",
    ExprKind::Measured { exponent_span: None, .. } => "`[a, b] unit`",
    ExprKind::Measured { exponent_span: Some(_), .. } => "`[a, b] unit^n`",
    ExprKind::Anonymous(_) => "`(name) => e`",
    ExprKind::Comprehension(parts) if parts.condition.is_none() => "`[e for name in e]`",
    ExprKind::Comprehension(_) => "`[e for name in e if e]`",
    ExprKind::If { .. } => "`if (e) e else e`",
    ExprKind::At { .. } => "`e at name = e`",
    ExprKind::IsNone { negated: false, .. } => "`e is none`",
    ExprKind::IsNone { negated: true, .. } => "`e is not none`",
    ExprKind::Paren(_) => "`(e)`",
    ExprKind::Block(_) => "`{ var a = e; return e; }`",
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
const FORMS: [&str; 8] = [
    "`///` at the beginning of a file",
    "`///` before a declaration",
    "`///` before a parameter",
    "`-> T`",
    "`private`",
    "`test function`",
    "`host function`",
    "`component`",
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
    let mut found = BTreeSet::new();
    if module.doc.is_some() {
        found.insert(FORMS[0]);
    }
    for s in &module.statements {
        Node::Statement(s).walk(&mut |node| add(node, &mut found));
    }
    found
}

fn add(node: Node<'_>, found: &mut BTreeSet<&'static str>) {
    let mut form = |form: usize, is_used: bool| {
        if is_used {
            found.insert(FORMS[form]);
        }
    };
    match node {
        Node::Statement(s) => {
            form(1, s.doc.is_some());
            form(4, s.private);
            if let StmtKind::Function(function) = &s.kind {
                form(3, function.result.is_some());
                form(5, function.is_test);
                form(6, function.is_host);
                form(7, function.is_component);
                found.insert(body::row(&function.body));
            }
            found.insert(statement::row(&s.kind));
        }
        Node::Parameter(one) => {
            form(2, one.doc.is_some());
            found.extend([mode::row(&one.mode), parameter::row(one)]);
        }
        Node::Expression(e) => {
            match &e.kind {
                ExprKind::Unary { op, .. } => found.extend([unary::row(op)]),
                ExprKind::Binary { op, .. } => found.extend([binary::row(op)]),
                ExprKind::String(parts) => found.extend(parts.iter().map(string_part::row)),
                _ => {}
            }
            found.insert(expression::row(&e.kind));
        }
        Node::Variable(one) => found.extend([declaration::row(one)]),
        Node::Field(one) => found.extend([field::row(one)]),
        Node::Domain(written) => found.extend([domain::row(written)]),
        Node::Type(ty) => found.extend([annotation::row(&ty.kind)]),
        Node::Argument(one) => found.extend([argument::row(one)]),
        Node::Name(_) => {}
    }
}
