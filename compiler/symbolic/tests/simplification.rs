//! Checks that every rule of `simplify` shortens its expressions and preserves their values. A case
//! has the name of its rule, or of a variant of the rule.

use crate::support::{Random, assert_close, evaluate};
use calyx_symbolic::{Binary, Graph, Instruction, NodeId, Unary};

struct Rule {
    name: &'static str,
    build: fn(&mut Graph, NodeId, NodeId) -> NodeId,
    value: fn(f64, f64) -> f64,
    /// Number of operations that remain, without constants and inputs.
    operations: usize,
}

macro_rules! rules {
    ($($name:literal: |$g:ident, $x:ident, $y:ident| $build:expr, $value:expr, $operations:literal;)+) => {
        &[$(Rule {
            name: $name,
            build: |$g, $x, $y| { let _ = ($x, $y); $build },
            value: |$x, $y| { let _ = ($x, $y); $value },
            operations: $operations,
        }),+]
    };
}

/// Returns a constant; a shorthand for the table.
fn c(g: &mut Graph, value: f64) -> NodeId {
    g.constant(value)
}

const RULES: &[Rule] = rules! {
    "any operation on constants": |g, x, y| { let (a, b) = (c(g, 0.3), c(g, 0.7)); let s = g.add(a, b); g.sin(s) }, (0.3f64 + 0.7).sin(), 0;
    "x+0": |g, x, y| { let z = c(g, 0.0); g.add(z, x) }, x, 0;
    "x-0": |g, x, y| { let z = c(g, 0.0); g.subtract(x, z) }, x, 0;
    "0-x": |g, x, y| { let z = c(g, 0.0); g.subtract(z, x) }, -x, 1;
    "1*x": |g, x, y| { let o = c(g, 1.0); g.multiply(x, o) }, x, 0;
    "-1*x": |g, x, y| { let o = c(g, -1.0); g.multiply(x, o) }, -x, 1;
    "0*x": |g, x, y| { let z = c(g, 0.0); g.multiply(x, z) }, 0.0, 0;
    "0/x": |g, x, y| { let z = c(g, 0.0); g.divide(z, x) }, 0.0, 0;
    "x/1": |g, x, y| { let o = c(g, 1.0); g.divide(x, o) }, x, 0;
    "x/-1": |g, x, y| { let o = c(g, -1.0); g.divide(x, o) }, -x, 1;
    "x-x": |g, x, y| { let s = g.sin(x); g.subtract(s, s) }, 0.0, 0;
    "x+x": |g, x, y| g.add(x, x), 2.0 * x, 1;
    "c*x + d*x": |g, x, y| { let (a, b) = (g.scale(2.0, x), g.scale(3.0, x)); g.add(a, b) }, 5.0 * x, 1;
    "c*x - d*x": |g, x, y| { let (a, b) = (g.scale(2.0, x), g.scale(3.0, x)); g.subtract(a, b) }, -x, 1;
    "(x+c)+d": |g, x, y| { let (a, b) = (c(g, 0.25), c(g, 0.5)); let s = g.add(a, x); g.add(s, b) }, x + 0.75, 1;
    "x - c": |g, x, y| { let a = c(g, 0.25); let s = g.add(x, a); g.subtract(s, a) }, x, 0;
    "c*(d*x)": |g, x, y| { let a = g.scale(0.5, x); g.scale(6.0, a) }, 3.0 * x, 1;
    "-(-x)": |g, x, y| { let n = g.negate(x); g.negate(n) }, x, 0;
    "-(x-y)": |g, x, y| { let d = g.subtract(x, y); g.negate(d) }, y - x, 1;
    "-(c*x)": |g, x, y| { let d = g.scale(3.0, x); g.negate(d) }, -3.0 * x, 1;
    "x+(-y)": |g, x, y| { let n = g.negate(y); g.add(x, n) }, x - y, 1;
    "(-x)+y": |g, x, y| { let n = g.negate(x); g.add(n, y) }, y - x, 1;
    "x-(-y)": |g, x, y| { let n = g.negate(y); g.subtract(x, n) }, x + y, 1;
    "(-x)-y": |g, x, y| { let n = g.negate(x); g.subtract(n, y) }, -x - y, 2;
    "(-x)*(-y)": |g, x, y| { let (a, b) = (g.negate(x), g.negate(y)); g.multiply(a, b) }, x * y, 1;
    "(-x)*y": |g, x, y| { let a = g.negate(x); g.multiply(a, y) }, -(x * y), 2;
    "(-x)/y": |g, x, y| { let a = g.negate(x); g.divide(a, y) }, -(x / y), 2;
    "x/(-y)": |g, x, y| { let b = g.negate(y); g.divide(x, b) }, -(x / y), 2;
    "(-x)/(-y)": |g, x, y| { let (a, b) = (g.negate(x), g.negate(y)); g.divide(a, b) }, x / y, 1;
    "c*(-x)": |g, x, y| { let a = g.negate(x); g.scale(3.0, a) }, -3.0 * x, 1;
    "sin(x)*sin(x) + cos(x)*cos(x)": |g, x, y| {
        let (s, k) = (g.sin(x), g.cos(x));
        let (s, k) = (g.multiply(s, s), g.multiply(k, k));
        g.add(k, s)
    }, 1.0, 0;
    "sin(-x)": |g, x, y| { let n = g.negate(x); let (a, b) = (g.sin(n), g.sin(x)); g.add(a, b) }, 0.0, 0;
    "tan(-x)": |g, x, y| {
        let n = g.negate(x);
        let (a, b) = (g.unary(Unary::Tan, n), g.unary(Unary::Tan, x));
        g.add(a, b)
    }, 0.0, 0;
    "asin(-x)": |g, x, y| {
        let n = g.negate(x);
        let (a, b) = (g.unary(Unary::Asin, n), g.unary(Unary::Asin, x));
        g.add(a, b)
    }, 0.0, 0;
    "atan(-x)": |g, x, y| {
        let n = g.negate(x);
        let (a, b) = (g.unary(Unary::Atan, n), g.unary(Unary::Atan, x));
        g.add(a, b)
    }, 0.0, 0;
    "cos(-x)": |g, x, y| { let n = g.negate(x); g.cos(n) }, x.cos(), 1;
    "abs(-x)": |g, x, y| { let n = g.negate(x); g.unary(Unary::Abs, n) }, x.abs(), 1;
    "abs(abs(x))": |g, x, y| { let n = g.unary(Unary::Abs, x); g.unary(Unary::Abs, n) }, x.abs(), 1;
    "min(x,x)": |g, x, y| g.binary(Binary::Min, x, x), x, 0;
    "max(x,x)": |g, x, y| g.binary(Binary::Max, x, x), x, 0;
    "x^0": |g, x, y| { let n = c(g, 0.0); g.power(x, n) }, 1.0, 0;
    "x^1": |g, x, y| { let n = c(g, 1.0); g.power(x, n) }, x, 0;
    "x^2": |g, x, y| { let n = c(g, 2.0); g.power(x, n) }, x * x, 1;
    "x^3": |g, x, y| { let n = c(g, 3.0); g.power(x, n) }, x * x * x, 2;
    "x^4": |g, x, y| { let n = c(g, 4.0); g.power(x, n) }, x * x * x * x, 2;
    "x^5": |g, x, y| { let n = c(g, 5.0); g.power(x, n) }, x.powi(5), 3;
    "x^6": |g, x, y| { let n = c(g, 6.0); g.power(x, n) }, x.powi(6), 3;
    "x^7": |g, x, y| { let n = c(g, 7.0); g.power(x, n) }, x.powi(7), 4;
    "x^8": |g, x, y| { let n = c(g, 8.0); g.power(x, n) }, x.powi(8), 3;
    "x^-1": |g, x, y| { let n = c(g, -1.0); g.power(x, n) }, 1.0 / x, 1;
    "x^-2": |g, x, y| { let n = c(g, -2.0); g.power(x, n) }, 1.0 / (x * x), 2;
    "!!(x<y)": |g, x, y| {
        let l = g.binary(Binary::Less, x, y);
        let n = g.unary(Unary::Not, l);
        g.unary(Unary::Not, n)
    }, f64::from(u8::from(x < y)), 1;
    "!!x": |g, x, y| { let n = g.unary(Unary::Not, x); g.unary(Unary::Not, n) }, 1.0, 2;
    "true & (x<y)": |g, x, y| { let (t, l) = (c(g, 1.0), g.binary(Binary::Less, x, y)); g.binary(Binary::And, t, l) },
        f64::from(u8::from(x < y)), 1;
    "true & x": |g, x, y| { let t = c(g, 1.0); g.binary(Binary::And, t, x) }, 1.0, 1;
    "false & x": |g, x, y| { let t = c(g, 0.0); g.binary(Binary::And, x, t) }, 0.0, 0;
    "true | x": |g, x, y| { let t = c(g, 2.0); g.binary(Binary::Or, x, t) }, 1.0, 0;
    "false | (x<y)": |g, x, y| { let (t, l) = (c(g, 0.0), g.binary(Binary::Less, x, y)); g.binary(Binary::Or, l, t) },
        f64::from(u8::from(x < y)), 1;
    "select(true,x,y)": |g, x, y| { let t = c(g, 1.0); g.select(t, x, y) }, x, 0;
    "select(false,x,y)": |g, x, y| { let t = c(g, 0.0); g.select(t, x, y) }, y, 0;
    "select(c,x,x)": |g, x, y| { let l = g.binary(Binary::Less, x, y); g.select(l, x, x) }, x, 0;
    "select(!c,x,y)": |g, x, y| {
        let l = g.binary(Binary::Less, x, y);
        let n = g.unary(Unary::Not, l);
        g.select(n, x, y)
    }, if x < y { y } else { x }, 2;
    "x + y": |g, x, y| { let (a, b) = (g.add(x, y), g.add(y, x)); g.subtract(a, b) }, 0.0, 0;
    "x * y": |g, x, y| { let (a, b) = (g.multiply(x, y), g.multiply(y, x)); g.subtract(a, b) }, 0.0, 0;
    "x == y": |g, x, y| { let (a, b) = (g.binary(Binary::Equal, x, y), g.binary(Binary::Equal, y, x)); g.subtract(a, b) },
        0.0, 0;
    "x & y": |g, x, y| { let (a, b) = (g.binary(Binary::And, x, y), g.binary(Binary::And, y, x)); g.subtract(a, b) },
        0.0, 0;
    "x | y": |g, x, y| { let (a, b) = (g.binary(Binary::Or, x, y), g.binary(Binary::Or, y, x)); g.subtract(a, b) },
        0.0, 0;
};

#[test]
fn every_rule_keeps_the_value_and_leaves_the_fewest_operations() {
    let mut random = Random(1);
    for rule in RULES {
        let mut g = Graph::new();
        let (x, y) = (g.symbol(0), g.symbol(1));
        let node = (rule.build)(&mut g, x, y);
        let tape = g.schedule(2, &[node]);
        let operations = tape
            .instructions
            .iter()
            .filter(|i| !matches!(i, Instruction::Constant(_) | Instruction::Input(_)));
        assert_eq!(operations.count(), rule.operations, "{}: {:?}", rule.name, tape.instructions);
        for _ in 0..20 {
            let (x, y) = (random.uniform(-0.99, 0.99), random.uniform(-0.99, 0.99));
            // Combined constants and sums of three terms may round differently by a few units in
            // the last place.
            assert_close(evaluate(&g, &[node], &[x, y])[0], (rule.value)(x, y), 1e-15, rule.name);
        }
    }
}

/// Powers expanded into products equal `pow` to the last bit.
#[test]
fn whole_powers_have_the_bits_of_pow() {
    let mut random = Random(8);
    for exponent in -3..=9 {
        let exponent = f64::from(exponent);
        let mut g = Graph::new();
        let (x, n) = (g.symbol(0), c(&mut g, exponent));
        let node = g.power(x, n);
        for _ in 0..50 {
            let x = random.uniform(-3.0, 3.0);
            let power = calyx_abi::math::pow(x, exponent);
            assert_eq!(evaluate(&g, &[node], &[x])[0].to_bits(), power.to_bits(), "{x}^{exponent}");
        }
    }
}

/// Rules that are not marked *finite* must preserve NaN and infinity.
#[test]
fn no_rule_but_the_marked_ones_hides_a_nan() {
    const MARKED: [&str; 13] = [
        "0*x",
        "0/x",
        "x-x",
        "c*x - d*x",
        "sin(x)*sin(x) + cos(x)*cos(x)",
        "sin(-x)",
        "tan(-x)",
        "asin(-x)",
        "atan(-x)",
        "x + y",
        "x * y",
        "any operation on constants",
        "c*x + d*x",
    ];
    for rule in RULES.iter().filter(|rule| !MARKED.contains(&rule.name)) {
        let mut g = Graph::new();
        let (x, y) = (g.symbol(0), g.symbol(1));
        let node = (rule.build)(&mut g, x, y);
        for (x, y) in [(f64::NAN, 0.5), (f64::INFINITY, 0.5), (f64::NEG_INFINITY, 2.0), (0.5, f64::NAN)] {
            let (actual, expected) = (evaluate(&g, &[node], &[x, y])[0], (rule.value)(x, y));
            assert!(
                actual == expected || actual.is_nan() && expected.is_nan(),
                "{} at {x}, {y}: {actual} instead of {expected}",
                rule.name
            );
        }
    }
}

/// Random expressions of all operations equal the same operations evaluated without simplification.
#[test]
fn random_expressions_keep_their_value() {
    const UNARY: [Unary; 9] = [
        Unary::Negate,
        Unary::Abs,
        Unary::Sin,
        Unary::Cos,
        Unary::Atan,
        Unary::Not,
        Unary::Floor,
        Unary::Ceil,
        Unary::Round,
    ];
    const BINARY: [Binary; 10] = [
        Binary::Add,
        Binary::Subtract,
        Binary::Multiply,
        Binary::Add,
        Binary::Subtract,
        Binary::Multiply,
        Binary::Min,
        Binary::Max,
        Binary::Less,
        Binary::And,
    ];
    let mut random = Random(7);
    for _ in 0..200 {
        let mut g = Graph::new();
        let inputs: Vec<f64> = (0..3).map(|_| random.uniform(-2.0, 2.0)).collect();
        let mut made: Vec<(NodeId, f64)> = inputs.iter().zip(0..).map(|(&v, i)| (g.symbol(i), v)).collect();
        made.extend([-1.0, 0.0, 1.0, 2.0].map(|v| (g.constant(v), v)));
        for _ in 0..12 {
            let mut pick = |len: usize| random.uniform(0.0, len as f64) as usize;
            let (a, b) = (made[pick(made.len())], made[pick(made.len())]);
            let (unary, binary) = (UNARY[pick(UNARY.len())], BINARY[pick(BINARY.len())]);
            let next = if pick(3) == 0 {
                (g.unary(unary, a.0), plain_unary(unary, a.1))
            } else {
                (g.binary(binary, a.0, b.0), plain_binary(binary, a.1, b.1))
            };
            // Comparisons and steps amplify a rounding difference to a whole number, so near ties
            // are excluded.
            let rounded = matches!(unary, Unary::Floor | Unary::Ceil | Unary::Round | Unary::Not);
            let close = (a.1 - b.1).abs() < 1e-9 && a.1 != b.1;
            let near_step = (a.1 * 2.0 - (a.1 * 2.0).round()).abs() < 1e-9 && a.1.fract() != 0.0;
            if !(close || rounded && near_step) {
                made.push(next);
            }
        }
        let nodes: Vec<NodeId> = made.iter().map(|(node, _)| *node).collect();
        for (actual, (_, expected)) in evaluate(&g, &nodes, &inputs).into_iter().zip(&made) {
            // Twelve operations on numbers of order one; products can grow to 2^12.
            assert_close(actual, *expected, 1e-11, "random expression");
        }
    }
}

fn plain_unary(operation: Unary, x: f64) -> f64 {
    use calyx_abi::math;
    match operation {
        Unary::Negate => -x,
        Unary::Abs => x.abs(),
        Unary::Sin => math::sin(x),
        Unary::Cos => math::cos(x),
        Unary::Atan => math::atan(x),
        Unary::Not => math::not(x),
        Unary::Floor => x.floor(),
        Unary::Ceil => x.ceil(),
        Unary::Round => x.round(),
        _ => f64::NAN,
    }
}

fn plain_binary(operation: Binary, x: f64, y: f64) -> f64 {
    use calyx_abi::math;
    match operation {
        Binary::Add => x + y,
        Binary::Subtract => x - y,
        Binary::Multiply => x * y,
        Binary::Min => math::min(x, y),
        Binary::Max => math::max(x, y),
        Binary::Less => math::less(x, y),
        Binary::And => math::and(x, y),
        _ => f64::NAN,
    }
}
