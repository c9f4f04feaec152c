//! Syntax nodes around a position, from the outermost statement inwards.

use calyx_lang::ast::{Argument, Bind, Expr, ExprKind, Module, Stmt, StmtKind, VarDecl};
use calyx_lang::span::Span;
use calyx_lang::walk::Node;
use std::ops::Range;

/// Nodes that contain a range, outermost first.
pub struct EnclosingNodes<'t> {
    pub nodes: Vec<Node<'t>>,
}

/// Value on the right of `=` or `:=`.
#[derive(Clone, Copy)]
pub struct GivenValue<'t> {
    /// End of the name, or of other tokens before the operator.
    pub name: Span,
    pub bind: Bind,
    pub value: &'t Expr,
    pub to: Receiver<'t>,
}

/// Receiver of a value.
#[derive(Clone, Copy)]
pub enum Receiver<'t> {
    /// A declaration with one or more variables.
    Variable(&'t Stmt, &'t VarDecl),
    /// An assignment.
    Assigned,
    Argument(&'t Argument),
    /// A positional argument of a call.
    Positional(&'t Argument),
}

impl<'t> EnclosingNodes<'t> {
    pub fn new(module: &'t Module, range: Range<u32>) -> EnclosingNodes<'t> {
        let mut nodes = Vec::new();
        let after = module.statements.partition_point(|statement| statement.span.start <= range.start);
        // A cursor between two adjacent statements belongs to both; the later one is being written.
        let candidates = module.statements.iter().take(after).rev().take(2);
        for statement in candidates.map(Node::Statement) {
            if contains(statement, &range) {
                descend(statement, &range, &mut nodes);
                break;
            }
        }
        EnclosingNodes { nodes }
    }

    pub fn expressions(&self) -> impl DoubleEndedIterator<Item = &'t Expr> {
        self.nodes.iter().filter_map(|node| match node {
            Node::Expression(e) => Some(*e),
            _ => None,
        })
    }

    pub fn statements(&self) -> impl DoubleEndedIterator<Item = &'t Stmt> {
        self.nodes.iter().filter_map(|node| match node {
            Node::Statement(statement) => Some(*statement),
            _ => None,
        })
    }

    /// Returns the innermost expression.
    pub fn expression(&self) -> Option<&'t Expr> {
        self.expressions().next_back()
    }

    /// Returns the parent of a node.
    pub fn parent(&self, of: &Expr) -> Option<Node<'t>> {
        let at =
            self.nodes.iter().rposition(|node| matches!(node, Node::Expression(e) if e.span == of.span))?;
        self.nodes.get(at.checked_sub(1)?).copied()
    }

    /// Returns the innermost call around the range.
    pub fn call(&self) -> Option<(&'t Expr, &'t Expr, &'t [Argument])> {
        self.expressions().rev().find_map(|e| match &e.kind {
            ExprKind::Call { callee, arguments } => Some((e, &**callee, arguments.as_slice())),
            _ => None,
        })
    }

    /// Returns the innermost value that is given to a receiver.
    pub fn given(&self) -> Option<GivenValue<'t>> {
        let mut outer: Vec<Node<'t>> = self.nodes.clone();
        while let Some(node) = outer.pop() {
            match node {
                Node::Argument(argument) => {
                    return Some(match &argument.name {
                        Some((name, bind)) => GivenValue {
                            name: name.span,
                            bind: *bind,
                            value: &argument.value,
                            to: Receiver::Argument(argument),
                        },
                        None => GivenValue {
                            name: argument.value.span,
                            bind: Bind::Evaluate,
                            value: &argument.value,
                            to: Receiver::Positional(argument),
                        },
                    });
                }
                Node::Variable(decl) => {
                    let (bind, value) = decl.init.as_ref()?;
                    let Some(Node::Statement(statement)) = outer.last() else { return None };
                    let to = Receiver::Variable(statement, decl);
                    return Some(GivenValue { name: decl.name.span, bind: *bind, value, to });
                }
                Node::Statement(Stmt { kind: StmtKind::Assign { place, bind, value }, .. }) => {
                    return Some(GivenValue { name: place.span, bind: *bind, value, to: Receiver::Assigned });
                }
                Node::Statement(_) => return None,
                _ => {}
            }
        }
        None
    }

    /// Returns the innermost statement directly in a block or at the top level.
    pub fn whole_statement(&self) -> Option<&'t Stmt> {
        let listed = |index: usize| match index.checked_sub(1).and_then(|before| self.nodes.get(before)) {
            None => true,
            Some(Node::Statement(outer)) => matches!(outer.kind, StmtKind::Block(_)),
            Some(_) => false,
        };
        let all = self.nodes.iter().enumerate().rev();
        all.filter_map(|(index, node)| match node {
            Node::Statement(statement) if listed(index) => Some(*statement),
            _ => None,
        })
        .next()
    }
}

fn contains(node: Node<'_>, range: &Range<u32>) -> bool {
    let (start, end) = node.range();
    start <= range.start && range.end <= end
}

fn descend<'t>(node: Node<'t>, range: &Range<u32>, nodes: &mut Vec<Node<'t>>) {
    nodes.push(node);
    // At the border of two adjacent nodes, the cursor is in the later one.
    let mut inner = None;
    node.children(&mut |child| {
        if contains(child, range) {
            inner = Some(child);
        }
    });
    if let Some(inner) = inner {
        descend(inner, range, nodes);
    }
}

/// Returns true if an expression has no side effects: it calls builtin functions only.
pub fn only_computes(e: &Expr, is_builtin: &dyn Fn(&Expr) -> bool) -> bool {
    let mut pure = true;
    Node::Expression(e).walk(&mut |node| {
        if let Node::Expression(Expr { kind: ExprKind::Call { callee, .. }, .. }) = node {
            pure &= is_builtin(callee);
        }
    });
    pure
}
