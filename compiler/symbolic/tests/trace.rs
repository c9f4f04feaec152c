//! Tests of the search for the operation that returned the first NaN.

use calyx_symbolic::{Binary, Graph, Node, Unary};

#[test]
fn a_nan_is_followed_to_the_operation_that_made_it() {
    let mut g = Graph::new();
    let x = g.symbol(0);
    let two = g.constant(2.0);
    g.set_origin(1);
    let difference = g.subtract(x, two);
    g.set_origin(2);
    let root = g.sqrt(difference);
    g.set_origin(3);
    let sum = g.add(root, x);
    let slope = g.derivative(sum, 0);
    assert_eq!(g.first_nan(&[sum, slope], &[3.0]), None);
    let found = g.first_nan(&[x, sum], &[1.0]).unwrap();
    assert_eq!((found.origin, found.operands), (2, vec![-1.0]));
    assert!(matches!(found.node, Node::Unary(Unary::Sqrt, _)));
    // A derivative inherits the origin of the differentiated expression.
    assert_eq!(g.first_nan(&[slope], &[1.0]).unwrap().origin, 2);
    // A NaN input is reported as that input.
    assert!(matches!(g.first_nan(&[sum], &[f64::NAN]).unwrap().node, Node::Symbol(0)));
}

#[test]
fn the_arm_not_taken_is_not_to_blame() {
    let mut g = Graph::new();
    let (x, zero) = (g.symbol(0), g.constant(0.0));
    let positive = g.binary(Binary::Less, zero, x);
    let root = g.sqrt(x);
    let guarded = g.select(positive, root, zero);
    assert_eq!(g.first_nan(&[guarded], &[-1.0]), None);
    assert_eq!(g.first_nan(&[root], &[-1.0]).unwrap().operands, [-1.0]);
}
