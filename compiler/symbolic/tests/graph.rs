//! Tests of the graph of expressions: sizes, lists of operations, sharing, dependence.

use calyx_symbolic::{Binary, Graph, Node, Unary};

#[test]
fn nodes_stay_small() {
    assert!(size_of::<Node>() <= 16);
}

#[test]
fn the_lists_of_operations_leave_none_out() {
    for (place, operation) in Unary::ALL.iter().enumerate() {
        assert_eq!(*operation as usize, place);
    }
    for (place, operation) in Binary::ALL.iter().enumerate() {
        assert_eq!(*operation as usize, place);
    }
    // `Not` and `Or` are declared last, so this check fails when an operation is added after
    // them.
    assert_eq!((Unary::Not as usize, Binary::Or as usize), (Unary::ALL.len() - 1, Binary::ALL.len() - 1));
}

#[test]
fn equal_expressions_are_one_node() {
    let mut g = Graph::new();
    let (x, y) = (g.symbol(0), g.symbol(1));
    let a = g.multiply(x, y);
    let b = g.multiply(y, x);
    assert_eq!(a, b);
    let before = g.len();
    let (s, t) = (g.sin(a), g.sin(b));
    assert_eq!(s, t);
    assert_eq!(g.len(), before + 1);
}

#[test]
fn dependence_is_structural() {
    let mut g = Graph::new();
    let (x, y) = (g.symbol(0), g.symbol(1));
    let sum = g.add(x, y);
    let difference = g.subtract(sum, sum);
    assert!(g.depends_on(&[sum], |s| s == 1));
    assert!(!g.depends_on(&[x], |s| s == 1));
    assert!(!g.depends_on(&[difference], |_| true));
}
