//! Lowers symbolic expressions: every use of a `:=` as a value becomes a site, in which the
//! definitions that it uses are inlined.

use super::body::Body;
use super::values::{BinaryForm, binary_form, unary_op};
use crate::ast::{BinaryOp, UnaryOp};
use crate::check::expr::constant_index;
use crate::check::function_values::computed_index;
use crate::check::tree::{DefId, Expr, Kind, PassedFunction, Sym, VarId};
use crate::check::types::Type;
use crate::diagnostic::Diagnostic;
use crate::hashed::HashMap;
use crate::ir::{self, Capture, ExprKind, Op, Site, SiteId, SymExpr, SymKind, Symbol};
use crate::span::Span;
use calyx_abi::Repr;
use calyx_abi::units::to_si;

/// Limit of the nodes of an expression; only definitions that double at each step reach it.
const MOST_NODES: usize = 200_000;
/// Limit of the nesting depth; only a chain of definitions as long as a program reaches it.
const MOST_LEVELS: usize = 2000;

/// The captures of a site or symbolic function under construction, by number.
#[derive(Default)]
pub(super) struct Captures {
    by_variable: HashMap<VarId, u32>,
    all: Vec<(VarId, Span)>,
    /// Arguments of the symbolic function, with their representations.
    pub(super) arguments: HashMap<VarId, (u32, Repr)>,
    /// Variables of an ordinary function, as indices of `shared`.
    pub(super) locals: HashMap<VarId, u32>,
    /// `true` for the body of an ordinary function, whose expressions were checked as values.
    pub(super) plain: bool,
    /// `true` if it contains code that is not a symbolic expression.
    pub(super) outside: bool,
    /// Indices of definitions in `shared`.
    by_definition: HashMap<DefId, u32>,
    pub(super) shared: Vec<SymExpr>,
    nodes: usize,
    too_large: bool,
}

impl Body<'_, '_> {
    /// Executes the captures of a `:=`.
    pub(super) fn bind(&mut self, def: DefId) {
        let checker = self.lowering.checker;
        for (hidden, value) in &checker.defs[def.0 as usize].captures {
            let local = self.local(*hidden);
            let place = ir::Place::whole(local, self.local_repr(local));
            let value = self.value(value);
            let span = value.span;
            self.push(ir::Statement::Assign { place, value, span });
        }
    }

    /// Creates a site for a definition, with the values that it captures here and those that its
    /// parts captured before.
    pub(super) fn make_symbolic(&mut self, def: DefId, span: Span) -> ir::Expr {
        let part = self.lowering.checker.defs[def.0 as usize].part;
        self.symbolic_value(def, part, span)
    }

    /// Creates a site; `part` is `true` if other expressions may capture the value.
    pub(super) fn symbolic_value(&mut self, def: DefId, part: bool, span: Span) -> ir::Expr {
        let checker = self.lowering.checker;
        let definition = &checker.defs[def.0 as usize];
        let mut captures = Captures::default();
        let expr = self.symbolic(&definition.expr, &mut captures);
        self.report_size(&definition.name, definition.span, &captures);
        let repr = expr.repr.clone();
        let here: HashMap<VarId, &Expr> =
            definition.captures.iter().map(|(id, value)| (*id, value)).collect();
        // The hidden variables of a statement are already set; an argument's captures are evaluated
        // here.
        let bound_before = definition.stored;
        let kept = !bound_before && definition.captures.iter().any(|(_, value)| self.needs_statements(value));
        let mut values = Vec::new();
        let mut described = Vec::new();
        for (id, span) in captures.all {
            let value = match here.get(&id) {
                Some(value) if !bound_before && kept => {
                    let value = self.value(value);
                    self.kept(value)
                }
                Some(value) if !bound_before => self.value(value),
                _ => {
                    let local = self.local(id);
                    ir::Expr { kind: ExprKind::Local(local), repr: self.local_repr(local), span }
                }
            };
            described.push(Capture {
                name: checker.variable(id).name.to_string(),
                observable: matches!(checker.store.known(&checker.type_of(id)), Type::Observable(_)),
                repr: value.repr.clone(),
            });
            values.push(value);
        }
        let site = SiteId(self.lowering.program.sites.len() as u32);
        self.lowering.program.sites.push(Site {
            name: definition.name.clone(),
            shared: captures.shared,
            expr,
            captures: described,
            repr: repr.clone(),
            order: if part || repr == Repr::Transform { 2 } else { 0 },
            part,
            span: definition.span,
        });
        ir::Expr {
            kind: ExprKind::MakeSymbolic { site, captures: values },
            repr: Repr::Symbolic(Box::new(repr)),
            span,
        }
    }

    /// Reports an expression that is too large to compile.
    pub(super) fn report_size(&mut self, name: &str, span: Span, captures: &Captures) {
        if captures.too_large {
            self.lowering.report(
                Diagnostic::error(
                    "E0510",
                    format!("`{name}` grows beyond {MOST_NODES} operations or {MOST_LEVELS} levels"),
                    span,
                    "including all definitions that it uses",
                )
                .help("split the model, or compute parts of it with `=`"),
            );
        }
    }

    pub(super) fn symbolic(&mut self, e: &Expr, captures: &mut Captures) -> SymExpr {
        self.lowering.symbolic_functions.level += 1;
        let result = self.symbolic_node(e, captures);
        self.lowering.symbolic_functions.level -= 1;
        result
    }

    fn symbolic_node(&mut self, e: &Expr, captures: &mut Captures) -> SymExpr {
        captures.nodes += 1;
        let span = e.span;
        let make = |kind, repr| SymExpr { kind, repr, span };
        if captures.nodes > MOST_NODES || self.lowering.symbolic_functions.level > MOST_LEVELS {
            captures.too_large = true;
            return make(SymKind::Number(f64::NAN), Repr::Number);
        }
        match &e.kind {
            Kind::Number(value) => make(SymKind::Number(*value), Repr::Number),
            Kind::Bare(value, dim, system) => {
                make(SymKind::Number(to_si(*value, self.bare_factor(dim, *system))), Repr::Number)
            }
            Kind::Bool(value) => make(SymKind::Bool(*value), Repr::Bool),
            Kind::Time => make(SymKind::Time, Repr::Number),
            Kind::Param(id) => make(SymKind::Param(self.lowering.param_number(*id)), self.repr(&e.ty)),
            Kind::Def(def) => self.shared(*def, span, captures),
            Kind::Eval(def, None) if captures.plain => self.plain_evaluation(*def, e, captures),
            Kind::Call(call) if captures.plain && call.copy_back.is_empty() && call.demands.is_empty() => {
                self.symbolic_node(&Expr { kind: Kind::SymbolicCall(call.clone()), ..e.clone() }, captures)
            }
            Kind::SymbolicCall(call) => self.symbolic_call(call, span, captures),
            Kind::Applied(applied) => self.symbolic_applied(applied, span, captures),
            Kind::Function(PassedFunction::Declared(..), captured) => {
                let all: Vec<_> = captured.iter().map(|value| self.symbolic(value, captures)).collect();
                let repr = Repr::Tuple(all.iter().map(|value| value.repr.clone()).collect());
                make(SymKind::Brackets(all), repr)
            }
            Kind::Function(PassedFunction::Parameter(id), environment) => match environment.first() {
                Some(environment) => self.symbolic(environment, captures),
                None => self.symbolic_variable(*id, &e.ty, span, captures),
            },
            Kind::Spline(parts) => self.symbolic_spline(parts, span, captures),
            Kind::Block(bindings, result) => self.symbolic_block(bindings, result, captures),
            // The text of a record, which no expression can use.
            Kind::Text(_) => make(SymKind::Number(f64::NAN), Repr::Number),
            Kind::Var(id) if self.is_captured_text(*id, captures) => {
                make(SymKind::Number(f64::NAN), Repr::Number)
            }
            Kind::Var(id) => self.symbolic_variable(*id, &e.ty, span, captures),
            Kind::Array(all) | Kind::Tuple(all) => {
                let all: Vec<_> = all.iter().map(|a| self.symbolic(a, captures)).collect();
                let repr = Repr::Tuple(all.iter().map(|a| a.repr.clone()).collect());
                make(SymKind::Brackets(all), repr)
            }
            Kind::TupleElement(..) | Kind::Field(..) if self.repr(&e.ty) == Repr::String => {
                make(SymKind::Number(f64::NAN), Repr::Number)
            }
            Kind::Field(base, name) => self.symbolic_field(base, name, span, captures),
            Kind::TupleElement(base, at) => {
                let base = self.symbolic(base, captures);
                self.element(base, *at, span)
            }
            Kind::Index(base, index) => match constant_index(index, &self.lowering.checker.store) {
                Some(at) => {
                    let base = self.symbolic(base, captures);
                    self.element(base, at, span)
                }
                None => self.chosen_element(index.span),
            },
            Kind::Observe(inner) => {
                let inner = self.symbolic(inner, captures);
                SymExpr { repr: Repr::Number, ..inner }
            }
            Kind::Unary(op, a) => self.symbolic_unary(*op, a, span, captures),
            Kind::Binary(op, a, b) => {
                let compares = matches!(op, BinaryOp::Equal | BinaryOp::NotEqual);
                if compares && matches!(self.repr(&a.ty), Repr::String | Repr::Tuple(_) | Repr::Array(_)) {
                    captures.outside = true;
                    return make(SymKind::Bool(false), Repr::Bool);
                }
                let (a, b) = (self.symbolic(a, captures), self.symbolic(b, captures));
                symbolic_binary(*op, a, b, span)
            }
            Kind::Op(op, all) => {
                let all = all.iter().map(|a| self.symbolic(a, captures)).collect();
                let repr = self.repr(&e.ty);
                make(SymKind::Op(*op, all), repr)
            }
            Kind::UnitAxis(axis) => {
                let axis = self.symbolic(axis, captures);
                unit_axis_or_nan(axis, captures)
            }
            Kind::If(condition, a, b) => {
                let condition = self.symbolic(condition, captures);
                let (a, b) = (self.symbolic(a, captures), self.symbolic(b, captures));
                let repr = a.repr.clone();
                make(SymKind::If(Box::new(condition), Box::new(a), Box::new(b)), repr)
            }
            Kind::Derivative(inner, sym) => {
                let inner = self.symbolic(inner, captures);
                let repr = inner.repr.clone();
                make(SymKind::Derivative(Box::new(inner), self.symbol(*sym, captures)), repr)
            }
            Kind::Gradient(inner, by) => self.gradient(inner, by, span, captures),
            Kind::At(inner, sym, at) => {
                let (inner, at) = (self.symbolic(inner, captures), self.symbolic(at, captures));
                let repr = inner.repr.clone();
                make(SymKind::At(Box::new(inner), self.symbol(*sym, captures), Box::new(at)), repr)
            }
            // Already reported, or the body of a function in another unit.
            Kind::Error => make(SymKind::Number(f64::NAN), self.repr(&e.ty)),
            // Other expressions became captures with the definition, except in ordinary functions.
            _ => {
                captures.outside = true;
                make(SymKind::Number(f64::NAN), self.repr(&e.ty))
            }
        }
    }

    /// Lowers an expression that an ordinary function evaluates, such as a solution of an equation:
    /// what it captures are expressions here.
    fn plain_evaluation(&mut self, def: DefId, e: &Expr, captures: &mut Captures) -> SymExpr {
        let definition = &self.lowering.checker.defs[def.0 as usize];
        if !definition.closed && (definition.captures.is_empty() || !definition.checks.is_empty()) {
            captures.outside = true;
            let kind = SymKind::Number(f64::NAN);
            return SymExpr { kind, repr: self.repr(&e.ty), span: e.span };
        }
        for (hidden, value) in &definition.captures {
            let value = self.symbolic(value, captures);
            captures.shared.push(value);
            captures.locals.insert(*hidden, captures.shared.len() as u32 - 1);
        }
        self.shared(def, e.span, captures)
    }

    /// Returns `true` for a captured text of a record, which no expression can use.
    fn is_captured_text(&mut self, id: VarId, captures: &Captures) -> bool {
        let is_known = captures.arguments.contains_key(&id) || captures.locals.contains_key(&id);
        if captures.plain || is_known {
            return false;
        }
        let local = self.local(id);
        self.local_repr(local) == Repr::String
    }

    /// Returns an argument of the symbolic function, a local of its block, or a captured variable.
    fn symbolic_variable(&mut self, id: VarId, ty: &Type, span: Span, captures: &mut Captures) -> SymExpr {
        let make = |kind, repr| SymExpr { kind, repr, span };
        if let Some((index, repr)) = captures.arguments.get(&id) {
            return make(SymKind::Argument(*index), repr.clone());
        }
        if let Some(&index) = captures.locals.get(&id) {
            return make(SymKind::Shared(index), captures.shared[index as usize].repr.clone());
        }
        if captures.plain {
            captures.outside = true;
            return make(SymKind::Number(f64::NAN), self.repr(ty));
        }
        self.captured(id, span, captures)
    }

    /// Returns the value that a variable has when the `:=` is bound.
    fn captured(&mut self, variable: VarId, span: Span, captures: &mut Captures) -> SymExpr {
        let make = |kind, repr| SymExpr { kind, repr, span };
        let local = self.local(variable);
        // A passed function that captures nothing.
        if self.local_repr(local) == Repr::Tuple(Vec::new()) {
            return make(SymKind::Brackets(Vec::new()), Repr::Tuple(Vec::new()));
        }
        let index = *captures.by_variable.entry(variable).or_insert_with(|| {
            captures.all.push((variable, span));
            captures.all.len() as u32 - 1
        });
        make(SymKind::Capture(index), of_expressions(self.local_repr(local)))
    }

    fn symbolic_unary(
        &mut self,
        op: UnaryOp,
        operand: &Expr,
        span: Span,
        captures: &mut Captures,
    ) -> SymExpr {
        let make = |kind, repr| SymExpr { kind, repr, span };
        let a = self.symbolic(operand, captures);
        match unary_op(op, &a.repr) {
            None => a,
            Some(op) => {
                let repr = a.repr.clone();
                make(SymKind::Op(op, vec![a]), repr)
            }
        }
    }

    fn gradient(&mut self, inner: &Expr, by: &[Sym], span: Span, captures: &mut Captures) -> SymExpr {
        let make = |kind, repr| SymExpr { kind, repr, span };
        let inner = self.symbolic(inner, captures);
        let repr = inner.repr.clone();
        captures.shared.push(inner);
        let index = captures.shared.len() as u32 - 1;
        let parts = by.iter().map(|sym| {
            let inner = Box::new(make(SymKind::Shared(index), repr.clone()));
            make(SymKind::Derivative(inner, self.symbol(*sym, captures)), repr.clone())
        });
        let parts = parts.collect();
        make(SymKind::Brackets(parts), Repr::Tuple(vec![repr; by.len()]))
    }

    fn symbol(&self, sym: Sym, captures: &Captures) -> Symbol {
        match sym {
            Sym::Time => Symbol::Time,
            Sym::Param(id) => Symbol::Param(self.lowering.param_number(id)),
            Sym::Argument(id) => {
                Symbol::Argument(captures.arguments.get(&id).map_or(u32::MAX, |(index, _)| *index))
            }
        }
    }

    /// Returns a shared definition, which is added on first use.
    fn shared(&mut self, def: DefId, span: Span, captures: &mut Captures) -> SymExpr {
        let checker = self.lowering.checker;
        let index = match captures.by_definition.get(&def) {
            Some(index) => *index,
            None => {
                let expr = self.symbolic(&checker.defs[def.0 as usize].expr, captures);
                captures.shared.push(expr);
                let index = captures.shared.len() as u32 - 1;
                captures.by_definition.insert(def, index);
                index
            }
        };
        let repr = captures.shared[index as usize].repr.clone();
        SymExpr { kind: SymKind::Shared(index), repr, span }
    }

    /// Reports an index in a function that is a part of a symbolic expression.
    fn chosen_element(&mut self, index: Span) -> SymExpr {
        if !self.lowering.alone() {
            self.lowering.report(computed_index(index, "depends on an argument"));
        }
        SymExpr { kind: SymKind::Number(f64::NAN), repr: Repr::Number, span: index }
    }

    /// Returns an element of brackets, by constant index.
    pub(super) fn element(&mut self, base: SymExpr, at: usize, span: Span) -> SymExpr {
        let parts = match &base.repr {
            Repr::Tuple(parts) => parts.as_slice(),
            _ => &[],
        };
        let Some(repr) = parts.get(at).cloned() else {
            if self.lowering.alone() {
                // The base may be the result of a function in another unit.
                return SymExpr { kind: SymKind::Number(f64::NAN), repr: Repr::Number, span };
            }
            self.lowering.report(
                Diagnostic::error(
                    "E0305",
                    format!("the index is beyond the {} elements of the brackets", parts.len()),
                    span,
                    "index out of range",
                )
                .help("indices start at 0"),
            );
            return SymExpr { kind: SymKind::Number(f64::NAN), repr: Repr::Number, span };
        };
        SymExpr { kind: SymKind::Element(Box::new(base), at as u32), repr, span }
    }
}

/// Returns the representation of a captured value in an expression, where stored expressions are
/// the expressions themselves.
fn of_expressions(repr: Repr) -> Repr {
    match repr {
        Repr::Symbolic(inner) => *inner,
        Repr::Tuple(parts) => Repr::Tuple(parts.into_iter().map(of_expressions).collect()),
        repr => repr,
    }
}

pub(super) fn symbolic_binary(op: BinaryOp, a: SymExpr, b: SymExpr, span: Span) -> SymExpr {
    let make = |kind, repr| SymExpr { kind, repr, span };
    let truth = |value| Box::new(make(SymKind::Bool(value), Repr::Bool));
    match op {
        BinaryOp::And => return make(SymKind::If(Box::new(a), Box::new(b), truth(false)), Repr::Bool),
        BinaryOp::Or => return make(SymKind::If(Box::new(a), truth(true), Box::new(b)), Repr::Bool),
        _ => {}
    }
    match binary_form(op, &a.repr, &b.repr) {
        BinaryForm::Plain(op, repr) => make(SymKind::Op(op, vec![a, b]), repr),
        BinaryForm::Swapped(op, repr) => make(SymKind::Op(op, vec![b, a]), repr),
        BinaryForm::DivideVector => {
            let reciprocal = make(
                SymKind::Op(Op::Divide, vec![make(SymKind::Number(1.0), Repr::Number), b]),
                Repr::Number,
            );
            make(SymKind::Op(Op::Scale, vec![reciprocal, a]), Repr::Vector)
        }
    }
}

/// Returns the axis if it is a unit vector, otherwise NaN. The length of an axis with symbols is
/// unknown when it is bound, so no error can be reported then.
fn unit_axis_or_nan(axis: SymExpr, captures: &mut Captures) -> SymExpr {
    let span = axis.span;
    let make = |kind, repr| SymExpr { kind, repr, span };
    captures.shared.push(axis);
    let index = captures.shared.len() as u32 - 1;
    let axis = || make(SymKind::Shared(index), Repr::Vector);
    let number = |value| make(SymKind::Number(value), Repr::Number);
    let square = make(SymKind::Op(Op::Dot, vec![axis(), axis()]), Repr::Number);
    let excess = make(SymKind::Op(Op::Subtract, vec![square, number(1.0)]), Repr::Number);
    let excess = make(SymKind::Op(Op::Abs, vec![excess]), Repr::Number);
    // The relative error of the square is twice that of the length.
    let limit = number(2.0 * calyx_abi::math::UNIT_TOLERANCE);
    let sound = make(SymKind::Op(Op::LessEqual, vec![excess, limit]), Repr::Bool);
    let nan = make(
        SymKind::Op(Op::Vector, vec![number(f64::NAN), number(f64::NAN), number(f64::NAN)]),
        Repr::Vector,
    );
    make(SymKind::If(Box::new(sound), Box::new(axis()), Box::new(nan)), Repr::Vector)
}
