//! Checks implicit functions: solutions and derivatives of several orders against values computed
//! with 50 digits, substitution, sharing, and failures.

use crate::support::{assert_close, evaluate};
use calyx_symbolic::{Graph, Node, NodeId, Unary};

/// Symbols of the unknowns; those of the two arguments are 0 and 1.
const UNKNOWNS: [u32; 4] = [100, 101, 102, 103];
const TOLERANCE: f64 = 1e-12;

/// Returns the reference values of a function: orders of derivatives and value.
fn references(function: &str) -> Vec<(u32, u32, f64)> {
    let data = include_str!("data/implicit.txt");
    let rows = data.lines().filter(|line| !line.starts_with('#')).map(|line| {
        let mut parts = line.split_whitespace();
        let name = parts.next().unwrap();
        let orders = [0; 2].map(|_| parts.next().unwrap().parse().unwrap());
        (name, orders, parts.next().unwrap().parse().unwrap())
    });
    let rows: Vec<_> =
        rows.filter(|(name, ..)| *name == function).map(|(_, [a, b], value)| (a, b, value)).collect();
    assert!(!rows.is_empty(), "no values of {function}");
    rows
}

#[track_caller]
fn assert_derivatives(graph: &mut Graph, root: NodeId, function: &str, at: [f64; 2]) {
    for (first, second, expected) in references(function) {
        let mut node = root;
        for (symbol, order) in [(0, first), (1, second)] {
            for _ in 0..order {
                node = graph.derivative(node, symbol);
            }
        }
        let actual = evaluate(graph, &[node], &at)[0];
        assert_close(actual, expected, TOLERANCE, &format!("{function} {first} {second}"));
        // The order of differentiation makes no difference.
        let mut node = root;
        for (symbol, order) in [(1, second), (0, first)] {
            for _ in 0..order {
                node = graph.derivative(node, symbol);
            }
        }
        let actual = evaluate(graph, &[node], &at)[0];
        assert_close(actual, expected, TOLERANCE, &format!("{function} {second} {first}"));
    }
}

/// Returns the eccentric anomaly for a mean anomaly and an eccentricity.
fn kepler(graph: &mut Graph, mean: NodeId, eccentricity: NodeId) -> NodeId {
    let x = graph.symbol(UNKNOWNS[0]);
    let sine = graph.sin(x);
    let product = graph.multiply(eccentricity, sine);
    let difference = graph.subtract(x, product);
    let residual = graph.subtract(difference, mean);
    graph.solve(&UNKNOWNS[..1], &[residual], &[mean]).unwrap()[0]
}

#[test]
fn one_unknown_has_derivatives_of_any_order() {
    let mut g = Graph::new();
    let (mean, eccentricity) = (g.symbol(0), g.symbol(1));
    let root = kepler(&mut g, mean, eccentricity);
    assert_derivatives(&mut g, root, "kepler", [1.0, 0.6]);
}

#[test]
fn two_unknowns_are_solved_together() {
    let mut g = Graph::new();
    let (p, q) = (g.symbol(0), g.symbol(1));
    let [x, y] = [0, 1].map(|i| g.symbol(UNKNOWNS[i]));
    let (two, three, fifth) = (g.constant(2.0), g.constant(3.0), g.constant(0.2));
    let (square, cube) = (g.power(x, two), g.power(y, three));
    let sum = g.add(square, cube);
    let first = g.subtract(sum, p);
    let (sine, product) = (g.sin(x), g.multiply(q, y));
    let difference = g.subtract(sine, product);
    let second = g.subtract(difference, fifth);
    let one = g.constant(1.0);
    let roots = g.solve(&UNKNOWNS[..2], &[first, second], &[one, one]).unwrap();
    assert_derivatives(&mut g, roots[0], "pair.0", [1.7, 0.4]);
    assert_derivatives(&mut g, roots[1], "pair.1", [1.7, 0.4]);
    // Both unknowns are one solve of the tape.
    assert_eq!(g.schedule(2, &roots).solves.len(), 1);
}

#[test]
fn residuals_may_contain_implicit_functions() {
    let mut g = Graph::new();
    let (s, t) = (g.symbol(0), g.symbol(1));
    let (x, y) = (g.symbol(UNKNOWNS[0]), g.symbol(UNKNOWNS[1]));
    let three = g.constant(3.0);
    let cube = g.power(y, three);
    let product = g.multiply(s, cube);
    let sum = g.add(y, product);
    let residual = g.subtract(sum, x);
    let inner = g.solve(&UNKNOWNS[1..2], &[residual], &[x]).unwrap()[0];
    let exponential = g.unary(Unary::Exp, inner);
    let product = g.multiply(x, exponential);
    let residual = g.subtract(product, t);
    let half = g.constant(0.5);
    let root = g.solve(&UNKNOWNS[..1], &[residual], &[half]).unwrap()[0];
    assert_derivatives(&mut g, root, "nested", [0.3, 1.1]);
}

#[test]
fn four_unknowns_are_solved_together() {
    let mut g = Graph::new();
    let (s, t) = (g.symbol(0), g.symbol(1));
    let x = UNKNOWNS.map(|symbol| g.symbol(symbol));
    let mut residuals = Vec::new();
    let mut guess = Vec::new();
    for i in 0..4 {
        let sine = g.sin(x[(i + 1) % 4]);
        let product = g.multiply(s, sine);
        let sum = g.add(x[i], product);
        let right = g.scale((i + 1) as f64, t);
        residuals.push(g.subtract(sum, right));
        guess.push(g.scale(0.7 * (i + 1) as f64, t));
    }
    let roots = g.solve(&UNKNOWNS, &residuals, &guess).unwrap();
    for (i, root) in roots.into_iter().enumerate() {
        assert_derivatives(&mut g, root, &format!("ring.{i}"), [0.4, 0.3]);
    }
}

#[test]
fn minima_have_derivatives_of_any_order() {
    let mut g = Graph::new();
    let (s, t) = (g.symbol(0), g.symbol(1));
    let (x, y) = (g.symbol(UNKNOWNS[0]), g.symbol(UNKNOWNS[1]));
    let half = g.constant(0.5);
    // exp(x) - s x + t x^4
    let (two, four) = (g.constant(2.0), g.constant(4.0));
    let (exponential, fourth) = (g.unary(Unary::Exp, x), g.power(x, four));
    let (linear, quartic) = (g.multiply(s, x), g.multiply(t, fourth));
    let difference = g.subtract(exponential, linear);
    let valley = g.add(difference, quartic);
    let minimum = g.minimize(&UNKNOWNS[..1], valley, &[half]).unwrap()[0];
    assert_derivatives(&mut g, minimum, "valley", [2.1, 0.3]);
    // (x - s)^2 + t (y - x^2)^2 + cos(x y)/5
    let distance = g.subtract(x, s);
    let square = g.power(x, two);
    let bend = g.subtract(y, square);
    let (distance, bend) = (g.power(distance, two), g.power(bend, two));
    let product = g.multiply(x, y);
    let cosine = g.cos(product);
    let (bend, wave) = (g.multiply(t, bend), g.scale(0.2, cosine));
    let sum = g.add(distance, bend);
    let basin = g.add(sum, wave);
    let guess = [g.constant(1.2), g.constant(1.6)];
    let minima = g.minimize(&UNKNOWNS[..2], basin, &guess).unwrap();
    assert_derivatives(&mut g, minima[0], "basin.0", [0.8, 1.4]);
    assert_derivatives(&mut g, minima[1], "basin.1", [0.8, 1.4]);
    assert_eq!(g.schedule(2, &minima).solves.len(), 1);
}

#[test]
fn a_maximum_is_not_taken_for_a_minimum() {
    let mut g = Graph::new();
    let (s, x) = (g.symbol(0), g.symbol(UNKNOWNS[0]));
    let sine = g.sin(x);
    // Stationary points of the sine are maxima at pi/2 and minima at -pi/2.
    let minimum = g.minimize(&UNKNOWNS[..1], sine, &[s]).unwrap()[0];
    assert_close(evaluate(&g, &[minimum], &[-1.5])[0], -std::f64::consts::FRAC_PI_2, 1e-15, "minimum");
    assert!(evaluate(&g, &[minimum], &[1.5])[0].is_nan());
    let found = g.first_nan(&[minimum], &[1.5]).unwrap();
    assert_eq!(found.search.unwrap().search, calyx_abi::newton::Search::Minimum);
    // The root of the same derivative is another system.
    let cosine = g.cos(x);
    let root = g.solve(&UNKNOWNS[..1], &[cosine], &[s]).unwrap()[0];
    assert_ne!(root, minimum);
    assert_close(evaluate(&g, &[root], &[1.5])[0], std::f64::consts::FRAC_PI_2, 1e-15, "root");
}

#[test]
fn a_solution_follows_the_chain_rule_and_substitution() {
    let mut g = Graph::new();
    let (s, t) = (g.symbol(0), g.symbol(1));
    let (mean, eccentricity) = (g.symbol(2), g.symbol(3));
    let free = kepler(&mut g, mean, eccentricity);
    let sine = g.sin(s);
    let product = g.scale(0.3, t);
    // The argument of a function may be the function itself.
    let inner = g.substitute_all(&[free], &[(2, sine), (3, product)])[0];
    let outer = g.substitute_all(&[free], &[(2, inner), (3, product)])[0];
    let again = g.substitute_all(&[free], &[(2, inner), (3, product)])[0];
    assert_eq!(outer, again);
    let at = [0.7, 1.3];
    let derivative = g.derivative(outer, 0);
    let value = |s: f64, t: f64| evaluate(&g, &[outer], &[s, t])[0];
    let e = 0.3 * at[1];
    let solution = value(at[0], at[1]);
    let middle = solution - e * solution.sin();
    assert_close(middle - e * middle.sin(), at[0].sin(), 1e-15, "equations");
    let expected = at[0].cos() / ((1.0 - e * middle.cos()) * (1.0 - e * solution.cos()));
    assert_close(evaluate(&g, &[derivative], &at)[0], expected, 1e-14, "derivative");
}

#[test]
fn parts_without_unknowns_are_evaluated_once() {
    let mut g = Graph::new();
    let (s, t) = (g.symbol(0), g.symbol(1));
    let exponential = g.unary(Unary::Exp, s);
    let root = kepler(&mut g, t, exponential);
    let tape = g.schedule(2, &[root]);
    let residual = &tape.solves[0].system.residual;
    assert!(residual.instructions.iter().all(|i| !matches!(i, calyx_symbolic::Instruction::Exp(_))));
    // Guess, then the exponential and the mean anomaly.
    assert_eq!(tape.solves[0].operands.len(), 3);
    assert!(tape.is_well_formed() && residual.is_well_formed());
    // The same equations share one residual.
    let other = kepler(&mut g, s, t);
    let tape = g.schedule(2, &[root, other]);
    assert!(std::sync::Arc::ptr_eq(&tape.solves[0].system, &tape.solves[1].system));
}

#[test]
fn a_failure_is_nan_and_traced_to_the_solution() {
    let mut g = Graph::new();
    let s = g.symbol(0);
    let x = g.symbol(UNKNOWNS[0]);
    let square = g.multiply(x, x);
    let residual = g.add(square, s);
    let one = g.constant(1.0);
    g.set_origin(7);
    let root = g.solve(&UNKNOWNS[..1], &[residual], &[one]).unwrap()[0];
    let derivative = g.derivative(root, 0);
    assert_close(evaluate(&g, &[root], &[-4.0])[0], 2.0, 1e-15, "solution");
    assert_close(evaluate(&g, &[derivative], &[-4.0])[0], -0.25, 1e-15, "derivative");
    assert!(evaluate(&g, &[root], &[4.0])[0].is_nan());
    let found = g.first_nan(&[derivative], &[4.0]).unwrap();
    assert!(matches!(found.node, Node::Solution(..)));
    assert_eq!((found.origin, found.operands), (7, vec![1.0, 4.0]));
}

#[test]
fn equations_and_unknowns_must_match() {
    let mut g = Graph::new();
    let x = g.symbol(UNKNOWNS[0]);
    assert_eq!(g.solve(&UNKNOWNS[..1], &[x, x], &[x]), None);
    assert_eq!(g.solve(&[], &[], &[]), None);
    assert_eq!(g.solve(&[1, 2, 3, 4, 5], &[x; 5], &[x; 5]), None);
}

#[test]
fn splines_have_derivatives_and_stay_within_residuals() {
    let xs = [0.0, 0.5, 1.25, 2.0, 3.0];
    let ys = [0.0, 0.375, 0.875, 1.0, 0.25];
    let table = calyx_abi::piecewise::natural_spline(&xs, &ys).unwrap();
    let mut g = Graph::new();
    let s = g.symbol(0);
    let value = g.piecewise(&table, s);
    let slope = g.derivative(value, 0);
    let curvature = g.derivative(slope, 0);
    assert_derivatives(&mut g, value, "spline", [1.6875, 0.0]);
    // The fourth derivative of a cubic vanishes.
    let fourth = [0, 1].into_iter().fold(curvature, |node, _| g.derivative(node, 0));
    assert!(g.is_zero(fourth));
    // The abscissa at which a spline has a value.
    let x = g.symbol(UNKNOWNS[0]);
    let at = g.piecewise(&table, x);
    let residual = g.subtract(at, s);
    let guess = g.constant(0.6);
    let inverse = g.solve(&UNKNOWNS[..1], &[residual], &[guess]).unwrap()[0];
    assert_derivatives(&mut g, inverse, "inverse", [0.4375, 0.0]);
    let round_trip = g.piecewise(&table, inverse);
    let slope = g.derivative(round_trip, 0);
    assert_close(evaluate(&g, &[round_trip], &[0.4])[0], 0.4, 1e-15, "inverse");
    assert_close(evaluate(&g, &[slope], &[0.4])[0], 1.0, 1e-14, "slope of the identity");
}
