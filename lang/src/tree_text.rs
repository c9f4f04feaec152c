//! Formats syntax trees as nested lists without source locations, for comparison with fixtures and
//! for inspection.

use crate::ast::*;

/// Formats a module with one line per statement; blocks are indented.
pub fn print(module: &Module) -> String {
    let mut out = String::new();
    if let Some(doc) = &module.doc {
        out.push_str(&format!("(file-doc {doc:?})\n"));
    }
    for s in &module.statements {
        statement(s, 0, &mut out);
        out.push('\n');
    }
    out
}

fn open_line(depth: usize, out: &mut String) {
    if !out.is_empty() && !out.ends_with('\n') {
        out.push('\n');
    }
    out.push_str(&"  ".repeat(depth));
}

fn statement(s: &Stmt, depth: usize, out: &mut String) {
    open_line(depth, out);
    if let Some(doc) = &s.doc {
        out.push_str(&format!("(doc {doc:?})"));
        open_line(depth, out);
    }
    if s.private {
        out.push_str("(private)");
        open_line(depth, out);
    }
    let mut children = Vec::new();
    let head = statement_head(&s.kind, &mut children);
    out.push_str(head.trim_end());
    for child in children {
        statement(child, depth + 1, out);
    }
    out.push(')');
}

/// Returns the first line of a statement, and adds the statements within it to `children`.
fn statement_head<'s>(kind: &'s StmtKind, children: &mut Vec<&'s Stmt>) -> String {
    match kind {
        StmtKind::Empty => "(empty".into(),
        StmtKind::Error => "(error".into(),
        StmtKind::Import(import) => {
            let alias = import.alias.as_ref().map(|name| format!(" as {}", name.name)).unwrap_or_default();
            format!("(import {}{alias}", names(import, "."))
        }
        StmtKind::Units(system) => format!("(units {}", system.name),
        StmtKind::Param(p) => format!("(param {} {}{}", p.name.name, expr(&p.default), domain(&p.domain)),
        StmtKind::Output { name, value, unit } => {
            format!("(output {} {}{}", name.name, expr(value), optional(unit))
        }
        StmtKind::Const { name, value } => format!("(const {} {}", name.name, expr(value)),
        StmtKind::Record(decl) => record(decl),
        StmtKind::Enum(decl) => {
            let choices = decl.choices.iter().map(|choice| format!(" {}", choice.name.name));
            format!("(enum {}{}", decl.name.name, choices.collect::<String>())
        }
        StmtKind::Dimension { name, value } => {
            let value = value.as_ref().map(|t| format!(" {}", type_text(t))).unwrap_or_default();
            format!("(dimension {}{value}", name.name)
        }
        StmtKind::Unit(unit) => match &unit.meaning {
            UnitMeaning::Coherent(dimension) => format!("(unit {}: {}", unit.name.name, type_text(dimension)),
            UnitMeaning::Equal(value) => format!("(unit {} {}", unit.name.name, expr(value)),
        },
        StmtKind::Var(declared) => format!("(var{}", declared.iter().map(variable).collect::<String>()),
        StmtKind::Assign { place, bind, value } => {
            format!("({} {} {}", bind_text(*bind), expr(place), expr(value))
        }
        StmtKind::Update { place, op, value, .. } => {
            format!("({}= {} {}", operator(*op), expr(place), expr(value))
        }
        StmtKind::Expr(e) => format!("(do {}", expr(e)),
        StmtKind::Function(f) => {
            if let FunctionBody::Statement(body)
            | FunctionBody::Symbolic(Expr { kind: ExprKind::Block(body), .. }) = &f.body
            {
                children.push(body);
            }
            function(f)
        }
        StmtKind::Block(inner) => {
            children.extend(inner);
            "(block".into()
        }
        StmtKind::If { condition, then, otherwise } => {
            children.push(then);
            children.extend(otherwise.as_deref());
            format!("(if {}", expr(condition))
        }
        StmtKind::While { condition, body } => {
            children.push(body);
            format!("(while {}", expr(condition))
        }
        StmtKind::DoWhile { body, condition } => {
            children.push(body);
            format!("(do-while {}", expr(condition))
        }
        StmtKind::For { init, condition, step, body } => {
            children.extend([&**init, step, body]);
            format!("(for {}", condition.as_ref().map_or("always".into(), expr))
        }
        StmtKind::ForEach { variable, values, body } => {
            children.push(body);
            format!("(for {} in {}", variable.name, loop_values(values))
        }
        StmtKind::Switch { value, body } => {
            children.push(body);
            format!("(switch {}", expr(value))
        }
        StmtKind::Case { value, statement } => {
            children.push(statement);
            format!("(case {}", expr(value))
        }
        StmtKind::Default(statement) => {
            children.push(statement);
            "(default".into()
        }
        StmtKind::Label { label, statement } => {
            children.push(statement);
            format!("(label {}", label.name)
        }
        StmtKind::Goto(label) => format!("(goto {}", label.name),
        StmtKind::Break => "(break".into(),
        StmtKind::Continue => "(continue".into(),
        StmtKind::Return(value) => format!("(return{}", optional(value)),
        StmtKind::Throw(value) => format!("(throw{}", optional(value)),
        StmtKind::Try { body, error, handler } => {
            children.extend([&**body, handler]);
            format!("(try catch={}", error.as_ref().map_or("", |e| &e.name))
        }
    }
}

fn record(decl: &RecordDecl) -> String {
    let mut head = format!("(record {}", declared(&decl.name, &decl.former));
    for field in &decl.fields {
        head.push_str(&format!(" ({}", declared(&field.name, &field.former)));
        if let Some(annotation) = &field.annotation {
            head.push_str(&format!(": {}", type_text(annotation)));
        }
        head.push_str(&optional(&field.default));
        if let Some(doc) = &field.doc {
            head.push_str(&format!(" {doc:?}"));
        }
        head.push(')');
    }
    head
}

fn variable(decl: &VarDecl) -> String {
    match &decl.init {
        None => format!(" {}", decl.name.name),
        Some((bind, e)) => format!(" ({} {} {})", bind_text(*bind), decl.name.name, expr(e)),
    }
}

/// Formats a function without a body of statements.
fn function(f: &FunctionDecl) -> String {
    let mut head = format!("({} {}", function_word(f), declared(&f.name, &f.former));
    for p in &f.parameters {
        head.push_str(&parameter(p));
    }
    if let Some(result) = &f.result {
        head.push_str(&format!(" -> {}", type_text(result)));
    }
    match &f.body {
        FunctionBody::Statement(_) => {}
        FunctionBody::Symbolic(Expr { kind: ExprKind::Block(_), .. }) => head.push_str(" :="),
        FunctionBody::Symbolic(e) => head.push_str(&format!(" := {}", expr(e))),
        FunctionBody::Extern { purity, unit } => {
            let purity = purity.as_ref().map_or("", |p| &p.name);
            head.push_str(&format!(" extern {purity}{}", optional(unit)));
        }
    }
    head
}

fn names(path: &[Ident], separator: &str) -> String {
    path.iter().map(|i| i.name.as_str()).collect::<Vec<_>>().join(separator)
}

fn bind_text(bind: Bind) -> &'static str {
    match bind {
        Bind::Evaluate => "=",
        Bind::Symbolic => ":=",
    }
}

fn optional(e: &Option<Expr>) -> String {
    e.as_ref().map(|e| format!(" {}", expr(e))).unwrap_or_default()
}

fn domain(domain: &Option<Domain>) -> String {
    match domain {
        None => String::new(),
        Some(Domain::Range { low, high, .. }) => {
            let end = |e: &Option<Expr>| e.as_ref().map_or("_".into(), expr);
            format!(" (in {} .. {})", end(low), end(high))
        }
        Some(Domain::Choices { values, .. }) => format!(" (in [{}])", list(values)),
    }
}

/// Formats a declared name and its former name: `teeth was lugs`.
fn declared(name: &Ident, former: &Option<Ident>) -> String {
    let former = former.as_ref().map(|former| format!(" was {}", former.name)).unwrap_or_default();
    format!("{}{former}", name.name)
}

fn function_word(function: &FunctionDecl) -> &'static str {
    match (function.is_test, function.is_host, function.is_component) {
        (true, _, _) => "test",
        (_, true, _) => "host",
        (_, _, true) => "component",
        _ => "function",
    }
}

fn parameter(p: &Parameter) -> String {
    let mut text = format!(" ({:?} {}", p.mode, declared(&p.name, &p.former)).to_lowercase();
    if let Some(annotation) = &p.annotation {
        text.push_str(&format!(": {}", type_text(annotation)));
    }
    if let Some((bind, default)) = &p.default {
        text.push_str(&format!(" {}{}", bind_text(*bind), optional(default)));
    }
    if let Some(former) = &p.former_none {
        text.push_str(&format!(" was {}", expr(former)));
    }
    text.push_str(&domain(&p.domain));
    if let Some(doc) = &p.doc {
        text.push_str(&format!(" {doc:?}"));
    }
    text + ")"
}

fn type_text(t: &TypeExpr) -> String {
    match &t.kind {
        TypeKind::Name(name) => name.name.to_string(),
        TypeKind::Member(module, name) => format!("(. {} {})", module.name, name.name),
        TypeKind::Apply(name, arguments) => {
            format!("{}({})", name.name, arguments.iter().map(type_text).collect::<Vec<_>>().join(", "))
        }
        TypeKind::Product(a, b) => format!("(* {} {})", type_text(a), type_text(b)),
        TypeKind::Quotient(a, b) => format!("(/ {} {})", type_text(a), type_text(b)),
        TypeKind::Power(base, n, d) => format!("(^ {} {n}/{d})", type_text(base)),
        TypeKind::Function(parameters, result) => {
            let parameters: Vec<String> = parameters.iter().map(type_text).collect();
            format!("(-> [{}] {})", parameters.join(" "), type_text(result))
        }
        TypeKind::Error => "error".into(),
    }
}

fn list(items: &[Expr]) -> String {
    items.iter().map(expr).collect::<Vec<_>>().join(" ")
}

pub fn expr(e: &Expr) -> String {
    match &e.kind {
        ExprKind::Error => "error".into(),
        ExprKind::Number(value) => format!("{value}"),
        ExprKind::Quantity { value, unit, exponent: 1, exponent_span: None } => {
            format!("{value}'{}", unit.name)
        }
        ExprKind::Quantity { value, unit, exponent, .. } => format!("{value}'{}^{exponent}", unit.name),
        ExprKind::Bool(true) => "TRUE".into(),
        ExprKind::Bool(false) => "FALSE".into(),
        ExprKind::String(parts) => {
            let part = |p: &StringPart| match p {
                StringPart::Text(text) => format!(" {text:?}"),
                StringPart::Value(value, None) => format!(" {}", expr(value)),
                StringPart::Value(value, Some(format)) => {
                    format!(" ({} : {})", expr(value), format_text(format))
                }
            };
            format!("(string{})", parts.iter().map(part).collect::<String>())
        }
        ExprKind::Name(name) => name.name.to_string(),
        ExprKind::Field { base, field } => format!("(. {} {})", expr(base), field.name),
        ExprKind::Call { callee, arguments } => {
            let one = |a: &Argument| match &a.name {
                None if a.spread => format!(" ..{}", expr(&a.value)),
                None => format!(" {}", expr(&a.value)),
                Some((name, bind)) => format!(" {} {} {}", name.name, bind_text(*bind), expr(&a.value)),
            };
            format!("({}{})", expr(callee), arguments.iter().map(one).collect::<String>())
        }
        ExprKind::Index { base, index } => format!("([] {} {})", expr(base), expr(index)),
        ExprKind::Slice { base, low, high } => {
            let end = |e: &Option<Box<Expr>>| e.as_ref().map_or("_".into(), |e| expr(e));
            format!("([] {} {} .. {})", expr(base), end(low), end(high))
        }
        ExprKind::Unary { op, operand } => {
            let sign = match op {
                UnaryOp::Plus => "+",
                UnaryOp::Minus => "-",
                UnaryOp::Not => "!",
            };
            format!("({sign} {})", expr(operand))
        }
        ExprKind::Binary { op, left, right, .. } => {
            format!("({} {} {})", operator(*op), expr(left), expr(right))
        }
        ExprKind::List(items) => format!("[{}]", list(items)),
        ExprKind::Measured { elements, unit, exponent: 1, exponent_span: None } => {
            format!("[{}]'{}", list(elements), unit.name)
        }
        ExprKind::Measured { elements, unit, exponent, .. } => {
            format!("[{}]'{}^{exponent}", list(elements), unit.name)
        }
        ExprKind::Comprehension(parts) => {
            let condition = parts.condition.as_ref().map(|e| format!(" if {}", expr(e))).unwrap_or_default();
            let (element, variable) = (expr(&parts.element), &parts.variable.name);
            format!("[{element} for {variable} in {}{condition}]", loop_values(&parts.values))
        }
        ExprKind::If { condition, then, otherwise } => {
            format!("(if {} {} {})", expr(condition), expr(then), expr(otherwise))
        }
        ExprKind::At { value, symbol, at } => format!("(at {} {} {})", expr(value), symbol.name, expr(at)),
        ExprKind::IsNone { value, negated: false } => format!("(is-none {})", expr(value)),
        ExprKind::IsNone { value, negated: true } => format!("(is-not-none {})", expr(value)),
        ExprKind::Paren(inner) => format!("(paren {})", expr(inner)),
        ExprKind::Anonymous(decl) => match &decl.body {
            FunctionBody::Symbolic(e) => format!("({} {})", decl.name.name.trim_end_matches(" ..."), expr(e)),
            _ => "error".into(),
        },
        // The function writes its statements.
        ExprKind::Block(_) => "(block)".into(),
    }
}

fn operator(op: BinaryOp) -> &'static str {
    match op {
        BinaryOp::Or => "|",
        BinaryOp::And => "&",
        BinaryOp::Less => "<",
        BinaryOp::LessEqual => "<=",
        BinaryOp::Greater => ">",
        BinaryOp::GreaterEqual => ">=",
        BinaryOp::Equal => "==",
        BinaryOp::NotEqual => "!=",
        BinaryOp::Add => "+",
        BinaryOp::Subtract => "-",
        BinaryOp::Multiply => "*",
        BinaryOp::Divide => "/",
        BinaryOp::Power => "^",
    }
}

fn loop_values(values: &Values) -> String {
    match values {
        Values::Elements(array) => expr(array),
        Values::Range(low, high) => format!("{} .. {}", expr(low), expr(high)),
    }
}

fn format_text(format: &Format) -> String {
    let width = format.width.map(|width| width.to_string()).unwrap_or_default();
    let digits = format.digits.map(|digits| format!(".{digits}")).unwrap_or_default();
    let scientific = if format.scientific { "e" } else { "" };
    format!("{width}{digits}{scientific}{}", optional(&format.unit))
}
