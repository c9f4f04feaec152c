//! Coverage of constructs and operations of the typed program.
//!
//! Only cases that both the interpreter and machine code run with the same output count, so a
//! covered row is a construct on which both evaluators agree. As in [`super::syntax`] the matches
//! are exhaustive.

use super::rows;
use calyx_abi::display::Display;
use calyx_abi::newton::Search;
use calyx_lang::ir::*;
use std::collections::BTreeSet;

rows!(statement(Statement) {
    Statement::Assign { .. } => "assign",
    Statement::Eval(_) => "evaluate for what it does",
    Statement::Call { result: None, .. } => "call that hands values back",
    Statement::Call { result: Some(_), .. } => "call that hands values back and gives one",
    Statement::Host { .. } => "host function",
    Statement::Push { .. } => "push",
});

rows!(step(Step) {
    Step::Index(_) => "place in an array",
    Step::Element(_) => "place in a tuple",
});

rows!(terminator(Terminator) {
    Terminator::Jump(_) => "jump",
    Terminator::Branch { .. } => "branch",
    Terminator::Return(None) => "return",
    Terminator::Return(Some(_)) => "return a value",
    Terminator::Throw { .. } => "throw",
    Terminator::Rethrow(_) => "throw again",
});

rows!(expression(ExprKind) {
    ExprKind::Number(_) => "number",
    ExprKind::Bool(_) => "truth value",
    ExprKind::String(_) => "string",
    ExprKind::Local(_) => "variable",
    ExprKind::Param(_) => "param",
    ExprKind::Op(..) => "operation",
    ExprKind::And(..) => "and",
    ExprKind::Or(..) => "or",
    ExprKind::If(..) => "choice",
    ExprKind::Call(..) => "call",
    ExprKind::CallExtern(..) => "call of the engine",
    ExprKind::Array(_) => "array",
    ExprKind::Index(..) => "element of an array",
    ExprKind::Tuple(_) => "tuple",
    ExprKind::TupleElement(..) => "element of a tuple",
    ExprKind::Copy(_) => "copy of an array",
    ExprKind::Len(_) => "number of elements",
    ExprKind::Format(_) => "text with values",
    ExprKind::MakeSymbolic { .. } => "symbolic expression with its captures",
    ExprKind::EvalSymbolic { .. } => "value of a symbolic expression",
    ExprKind::Catch => "caught error",
    ExprKind::CaughtFields(_) => "fields of a caught error",
});

rows!(format_part(FormatPart) {
    FormatPart::Text(_) => "text",
    FormatPart::Value(_, Display::Number(style)) if !style.unit.is_empty() => "quantity in text",
    FormatPart::Value(..) => "value in text",
});

rows!(symbolic(SymKind) {
    SymKind::Number(_) => "symbolic number",
    SymKind::Bool(_) => "symbolic truth value",
    SymKind::Time => "`Time`",
    SymKind::Param(_) => "symbolic param",
    SymKind::Capture(_) => "captured value",
    SymKind::Argument(_) => "argument of a symbolic function",
    SymKind::Shared(_) => "shared part",
    SymKind::Call(..) => "symbolic function in an expression",
    SymKind::Solve(Search::Root, ..) => "unknown of an equation",
    SymKind::Solve(Search::Minimum, ..) => "unknown of a minimum",
    SymKind::Table(..) => "spline",
    SymKind::Brackets(_) => "symbolic brackets",
    SymKind::Element(..) => "element of symbolic brackets",
    SymKind::Op(..) => "symbolic operation",
    SymKind::If(..) => "symbolic choice",
    SymKind::Derivative(_, Symbol::Time) => "derivative by `Time`",
    SymKind::Derivative(_, Symbol::Param(_)) => "derivative by a param",
    SymKind::Derivative(_, Symbol::Argument(_)) => "derivative by an argument",
    SymKind::At(_, Symbol::Time, _) => "`at Time`",
    SymKind::At(_, Symbol::Param(_), _) => "`at` a param",
    SymKind::At(_, Symbol::Argument(_), _) => "`at` an argument",
});

rows!(operation(Op) {
    Op::Add => "Add",
    Op::Subtract => "Subtract",
    Op::Multiply => "Multiply",
    Op::Divide => "Divide",
    Op::Power => "Power",
    Op::Negate => "Negate",
    Op::Not => "Not",
    Op::Less => "Less",
    Op::LessEqual => "LessEqual",
    Op::Greater => "Greater",
    Op::GreaterEqual => "GreaterEqual",
    Op::Equal => "Equal",
    Op::NotEqual => "NotEqual",
    Op::Sqrt => "Sqrt",
    Op::Abs => "Abs",
    Op::Sin => "Sin",
    Op::Cos => "Cos",
    Op::Tan => "Tan",
    Op::Asin => "Asin",
    Op::Acos => "Acos",
    Op::Atan => "Atan",
    Op::Exp => "Exp",
    Op::Log => "Log",
    Op::Floor => "Floor",
    Op::Ceil => "Ceil",
    Op::Round => "Round",
    Op::Atan2 => "Atan2",
    Op::Spline => "Spline",
    Op::Min => "Min",
    Op::Max => "Max",
    Op::Vector => "Vector",
    Op::X => "X",
    Op::Y => "Y",
    Op::Z => "Z",
    Op::Norm => "Norm",
    Op::AddVector => "AddVector",
    Op::SubtractVector => "SubtractVector",
    Op::Cross => "Cross",
    Op::NegateVector => "NegateVector",
    Op::Scale => "Scale",
    Op::Dot => "Dot",
    Op::Translate => "Translate",
    Op::Rotate => "Rotate",
    Op::Compose => "Compose",
    Op::Apply => "Apply",
    Op::Inverse => "Inverse",
    Op::Origin => "Origin",
    Op::Direction => "Direction",
    Op::Velocity => "Velocity",
    Op::Acceleration => "Acceleration",
    Op::AngularVelocity => "AngularVelocity",
    Op::AngularAcceleration => "AngularAcceleration",
});

/// Operations that exist only in symbolic expressions.
const SYMBOLIC_ONLY: [&str; 4] = ["Velocity", "Acceleration", "AngularVelocity", "AngularAcceleration"];

/// Constructs and operations of a program.
#[derive(Debug, Default)]
pub struct Used {
    /// Kinds of statements, expressions and symbolic expressions.
    pub constructs: BTreeSet<&'static str>,
    pub evaluated: BTreeSet<&'static str>,
    pub symbolic: BTreeSet<&'static str>,
    /// Operations of symbolic expressions that are differentiated with respect to `Time` or a
    /// param.
    pub differentiated: BTreeSet<&'static str>,
}

pub fn constructs() -> Vec<&'static str> {
    [statement::ALL, step::ALL, terminator::ALL, expression::ALL, format_part::ALL, symbolic::ALL].concat()
}

/// Returns the operations of evaluated expressions. A spline is always a kernel, also of numbers.
pub fn evaluated() -> Vec<&'static str> {
    let is_evaluated = |name: &&str| !SYMBOLIC_ONLY.contains(name) && *name != "Spline";
    operation::ALL.iter().copied().filter(is_evaluated).collect()
}

pub fn symbolic_operations() -> Vec<&'static str> {
    operation::ALL.to_vec()
}

/// Returns the operations with a derivative. Excludes truth values, which have none, and the vector
/// of three numbers, which every program contains in `e1`, `e2` and `e3`.
pub fn differentiable() -> Vec<&'static str> {
    const RIGID: [&str; 8] =
        ["Not", "Less", "LessEqual", "Greater", "GreaterEqual", "Equal", "NotEqual", "Vector"];
    operation::ALL.iter().copied().filter(|name| !RIGID.contains(name)).collect()
}

pub fn used(program: &Program) -> Used {
    let mut walk = Walk::default();
    program.functions.iter().for_each(|function| walk.function(function));
    for site in &program.sites {
        walk.kernel(&site.expr, &site.shared, site.order > 0);
    }
    // Callers first: they determine which functions are differentiated.
    for (index, function) in program.symbolic_functions.iter().enumerate().rev() {
        let differentiated = walk.differentiated_functions.contains(&index);
        walk.kernel(&function.body, &function.shared, differentiated);
    }
    walk.used
}

#[derive(Default)]
struct Walk {
    used: Used,
    /// Symbolic functions whose derivative is used.
    differentiated_functions: BTreeSet<usize>,
    /// Shared parts of the current expression whose derivative is used.
    differentiated_parts: BTreeSet<usize>,
}

impl Walk {
    fn function(&mut self, function: &Function) {
        for block in &function.blocks {
            block.statements.iter().for_each(|s| self.statement(s));
            self.used.constructs.insert(terminator::row(&block.terminator));
            match &block.terminator {
                Terminator::Jump(_) => {}
                Terminator::Branch { condition, .. } => self.expression(condition),
                Terminator::Return(value) => self.expressions(value),
                Terminator::Throw { error: value, .. } | Terminator::Rethrow(value) => self.expression(value),
            }
        }
    }

    fn statement(&mut self, s: &Statement) {
        self.used.constructs.insert(statement::row(s));
        match s {
            Statement::Assign { place, value, .. } | Statement::Push { place, value, .. } => {
                self.place(place);
                self.expression(value);
            }
            Statement::Eval(value) => self.expression(value),
            Statement::Call { result, arguments, copy_back, .. } => {
                result.iter().chain(copy_back).for_each(|place| self.place(place));
                self.expressions(arguments);
            }
            Statement::Host { arguments, .. } => self.expressions(arguments),
        }
    }

    fn place(&mut self, place: &Place) {
        for one in &place.steps {
            self.used.constructs.insert(step::row(one));
        }
        self.expressions(place.indices());
    }

    fn expressions<'e>(&mut self, all: impl IntoIterator<Item = &'e Expr>) {
        all.into_iter().for_each(|e| self.expression(e));
    }

    fn expression(&mut self, e: &Expr) {
        self.used.constructs.insert(expression::row(&e.kind));
        match &e.kind {
            ExprKind::Number(_)
            | ExprKind::Bool(_)
            | ExprKind::String(_)
            | ExprKind::Local(_)
            | ExprKind::Param(_)
            | ExprKind::Catch => {}
            ExprKind::Op(op, operands) => {
                self.used.evaluated.insert(operation::row(op));
                self.expressions(operands);
            }
            ExprKind::And(a, b) | ExprKind::Or(a, b) | ExprKind::Index(a, b) => {
                self.expressions([&**a, &**b]);
            }
            ExprKind::If(a, b, c) => self.expressions([&**a, &**b, &**c]),
            ExprKind::Call(_, all)
            | ExprKind::CallExtern(_, all)
            | ExprKind::Array(all)
            | ExprKind::Tuple(all)
            | ExprKind::MakeSymbolic { captures: all, .. } => self.expressions(all),
            ExprKind::TupleElement(inner, _)
            | ExprKind::Copy(inner)
            | ExprKind::Len(inner)
            | ExprKind::CaughtFields(inner) => {
                self.expression(inner);
            }
            ExprKind::Format(parts) => {
                for part in parts {
                    self.used.constructs.insert(format_part::row(part));
                    if let FormatPart::Value(value, _) = part {
                        self.expression(value);
                    }
                }
            }
            ExprKind::EvalSymbolic { value, time } => self.expressions([&**value, &**time]),
        }
    }

    /// Visits an expression and its shared parts, each of which may refer to those before it.
    fn kernel(&mut self, e: &SymExpr, shared: &[SymExpr], differentiated: bool) {
        self.differentiated_parts.clear();
        self.symbolic(e, differentiated);
        for (index, part) in shared.iter().enumerate().rev() {
            let differentiated = self.differentiated_parts.contains(&index);
            self.symbolic(part, differentiated);
        }
    }

    /// Visits an expression; `differentiated` is true if its derivative is used.
    fn symbolic(&mut self, e: &SymExpr, differentiated: bool) {
        self.used.constructs.insert(symbolic::row(&e.kind));
        match &e.kind {
            SymKind::Number(_)
            | SymKind::Bool(_)
            | SymKind::Time
            | SymKind::Param(_)
            | SymKind::Argument(_)
            | SymKind::Capture(_) => {}
            SymKind::Shared(index) => {
                if differentiated {
                    self.differentiated_parts.insert(*index as usize);
                }
            }
            SymKind::Call(function, parts) | SymKind::Solve(_, function, parts) => {
                if differentiated {
                    self.differentiated_functions.insert(function.0 as usize);
                }
                parts.iter().for_each(|e| self.symbolic(e, differentiated));
            }
            SymKind::Brackets(parts) => {
                parts.iter().for_each(|e| self.symbolic(e, differentiated));
            }
            SymKind::Element(inner, _) | SymKind::Table(_, inner) => self.symbolic(inner, differentiated),
            SymKind::Op(op, operands) => {
                let name = operation::row(op);
                self.used.symbolic.insert(name);
                if differentiated && operands.iter().any(varies) {
                    self.used.differentiated.insert(name);
                }
                let differentiated = differentiated || SYMBOLIC_ONLY.contains(&name);
                operands.iter().for_each(|e| self.symbolic(e, differentiated));
            }
            SymKind::If(a, b, c) => [a, b, c].into_iter().for_each(|e| self.symbolic(e, differentiated)),
            SymKind::Derivative(inner, _) => self.symbolic(inner, true),
            SymKind::At(inner, _, value) => {
                self.symbolic(inner, differentiated);
                self.symbolic(value, differentiated);
            }
        }
    }
}

/// Returns true if an expression contains a symbol.
fn varies(e: &SymExpr) -> bool {
    match &e.kind {
        SymKind::Time | SymKind::Param(_) | SymKind::Argument(_) | SymKind::Shared(_) => true,
        SymKind::Number(_) | SymKind::Bool(_) | SymKind::Capture(_) => false,
        SymKind::Element(inner, _) | SymKind::Table(_, inner) => varies(inner),
        SymKind::Op(_, operands)
        | SymKind::Call(_, operands)
        | SymKind::Solve(_, _, operands)
        | SymKind::Brackets(operands) => operands.iter().any(varies),
        SymKind::If(a, b, c) => [a, b, c].into_iter().any(|e| varies(e)),
        SymKind::Derivative(inner, _) => varies(inner),
        SymKind::At(inner, _, value) => varies(inner) || varies(value),
    }
}
