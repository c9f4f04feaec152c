//! Checks every derivative rule against the complex-step method, and the conventions where no
//! derivative exists.

use crate::support::complex::complex_step;
use crate::support::{Random, assert_close, evaluate};
use calyx_symbolic::{Binary, Graph, NodeId, Unary};

/// An expression of two symbols and the square of values on which the expression is smooth.
struct Case {
    name: &'static str,
    build: fn(&mut Graph, NodeId, NodeId) -> NodeId,
    domain: (f64, f64),
}

const CASES: &[Case] = &[
    Case { name: "negate", build: |g, x, _| g.negate(x), domain: (-2.0, 2.0) },
    Case { name: "abs", build: |g, x, _| g.unary(Unary::Abs, x), domain: (-2.0, -0.5) },
    Case { name: "sqrt", build: |g, x, _| g.sqrt(x), domain: (0.8, 2.0) },
    Case { name: "sin", build: |g, x, _| g.sin(x), domain: (-3.0, 3.0) },
    Case { name: "cos", build: |g, x, _| g.cos(x), domain: (-3.0, 3.0) },
    Case { name: "tan", build: |g, x, _| g.unary(Unary::Tan, x), domain: (-0.5, 0.5) },
    Case { name: "asin", build: |g, x, _| g.unary(Unary::Asin, x), domain: (-0.4, 0.4) },
    Case { name: "acos", build: |g, x, _| g.unary(Unary::Acos, x), domain: (-0.4, 0.4) },
    Case { name: "atan", build: |g, x, _| g.unary(Unary::Atan, x), domain: (-2.0, 2.0) },
    Case { name: "exp", build: |g, x, _| g.unary(Unary::Exp, x), domain: (-2.0, 2.0) },
    Case { name: "log", build: |g, x, _| g.unary(Unary::Log, x), domain: (0.8, 3.0) },
    Case { name: "floor", build: |g, x, _| g.unary(Unary::Floor, x), domain: (0.1, 0.9) },
    Case { name: "ceil", build: |g, x, _| g.unary(Unary::Ceil, x), domain: (0.1, 0.9) },
    Case { name: "round", build: |g, x, _| g.unary(Unary::Round, x), domain: (0.6, 1.4) },
    Case { name: "not", build: |g, x, _| g.unary(Unary::Not, x), domain: (0.6, 1.4) },
    Case { name: "add", build: |g, x, y| g.add(x, y), domain: (-2.0, 2.0) },
    Case { name: "subtract", build: |g, x, y| g.subtract(x, y), domain: (-2.0, 2.0) },
    Case { name: "multiply", build: |g, x, y| g.multiply(x, y), domain: (-2.0, 2.0) },
    Case { name: "divide", build: |g, x, y| g.divide(x, y), domain: (0.8, 2.0) },
    Case { name: "power", build: |g, x, y| g.power(x, y), domain: (0.8, 2.0) },
    Case {
        name: "power, constant exponent",
        build: |g, x, _| {
            let n = g.constant(2.5);
            g.power(x, n)
        },
        domain: (0.8, 2.0),
    },
    Case {
        name: "power, whole exponent",
        build: |g, x, _| {
            let n = g.constant(5.0);
            g.power(x, n)
        },
        domain: (-1.0, 1.0),
    },
    Case {
        name: "power, constant base",
        build: |g, x, _| {
            let b = g.constant(1.7);
            g.power(b, x)
        },
        domain: (-1.0, 1.0),
    },
    Case { name: "atan2", build: |g, x, y| g.binary(Binary::Atan2, x, y), domain: (0.8, 2.0) },
    Case {
        name: "atan2, left half plane",
        build: |g, x, y| {
            let n = g.negate(y);
            g.binary(Binary::Atan2, x, n)
        },
        domain: (0.8, 2.0),
    },
    Case {
        name: "min",
        build: |g, x, y| {
            let z = g.scale(4.0, y);
            g.binary(Binary::Min, x, z)
        },
        domain: (0.8, 2.0),
    },
    Case {
        name: "max",
        build: |g, x, y| {
            let z = g.scale(4.0, y);
            g.binary(Binary::Max, x, z)
        },
        domain: (0.8, 2.0),
    },
    Case {
        name: "less",
        build: |g, x, y| {
            let z = g.scale(4.0, y);
            g.binary(Binary::Less, x, z)
        },
        domain: (0.8, 2.0),
    },
    Case {
        name: "equal",
        build: |g, x, y| {
            let z = g.scale(4.0, y);
            g.binary(Binary::Equal, x, z)
        },
        domain: (0.8, 2.0),
    },
    Case {
        name: "choice within a choice",
        build: |g, x, y| {
            let z = g.scale(4.0, y);
            let (below, above) = (g.binary(Binary::LessEqual, x, z), g.binary(Binary::Less, x, y));
            let (both, either) = (g.binary(Binary::And, below, above), g.binary(Binary::Or, below, above));
            let (s, e) = (g.sin(x), g.unary(Unary::Exp, y));
            let f = g.select(both, s, e);
            g.select(either, f, x)
        },
        domain: (0.8, 2.0),
    },
    Case {
        name: "select",
        build: |g, x, y| {
            let (z, s) = (g.scale(4.0, y), g.sin(x));
            let condition = g.binary(Binary::Less, x, z);
            g.select(condition, s, y)
        },
        domain: (0.8, 2.0),
    },
    Case {
        name: "an angle used several times",
        build: |g, x, y| {
            let (square, p) = (g.multiply(x, x), g.multiply(x, y));
            let angle = g.add(square, p);
            let (s, c) = (g.sin(angle), g.cos(angle));
            let e = g.unary(Unary::Exp, c);
            let product = g.multiply(s, e);
            g.multiply(product, angle)
        },
        domain: (-1.0, 1.0),
    },
    Case {
        name: "chain",
        build: |g, x, y| {
            let p = g.multiply(x, y);
            let (s, e) = (g.sin(p), g.unary(Unary::Exp, x));
            let q = g.divide(s, e);
            g.unary(Unary::Atan, q)
        },
        domain: (-1.0, 1.0),
    },
    Case {
        name: "less or equal",
        build: |g, x, y| {
            let z = g.scale(4.0, y);
            g.binary(Binary::LessEqual, x, z)
        },
        domain: (0.8, 2.0),
    },
    Case { name: "and", build: |g, x, y| g.binary(Binary::And, x, y), domain: (0.8, 2.0) },
    Case { name: "or", build: |g, x, y| g.binary(Binary::Or, x, y), domain: (0.8, 2.0) },
];

#[test]
fn first_second_and_mixed_derivatives_agree_with_the_complex_step() {
    let mut random = Random(11);
    for case in CASES {
        let mut g = Graph::new();
        let (x, y) = (g.symbol(0), g.symbol(1));
        let f = (case.build)(&mut g, x, y);
        let (fx, fy) = (g.derivative(f, 0), g.derivative(f, 1));
        let (fxx, fxy, fyx, fyy) =
            (g.derivative(fx, 0), g.derivative(fx, 1), g.derivative(fy, 0), g.derivative(fy, 1));
        for _ in 0..20 {
            let at = [0; 2].map(|_| random.uniform(case.domain.0, case.domain.1));
            for (of, by, derivative) in
                [(f, 0, fx), (f, 1, fy), (fx, 0, fxx), (fx, 1, fxy), (fy, 0, fyx), (fy, 1, fyy)]
            {
                let actual = evaluate(&g, &[derivative], &at)[0];
                assert_close(actual, complex_step(&g, of, &at, by), 2e-13, case.name);
            }
        }
    }
}

/// Fails if an operation has no row in the table above, so that no derivative stays unchecked.
#[test]
fn every_operation_has_a_row() {
    let mut met = String::new();
    for case in CASES {
        let mut g = Graph::new();
        let (x, y) = (g.symbol(0), g.symbol(1));
        let f = (case.build)(&mut g, x, y);
        for instruction in g.schedule(2, &[f]).instructions {
            met += &format!(" {instruction:?}");
        }
    }
    let operations = Unary::ALL.iter().map(|operation| format!("{operation:?}"));
    let operations = operations.chain(Binary::ALL.iter().map(|operation| format!("{operation:?}")));
    for operation in operations.chain(["Select".into()]) {
        assert!(met.contains(&format!(" {operation}(")), "no derivative of {operation} is checked");
    }
}

/// Coefficients of one angle share the derivative of the angle: each adds one product to the cost
/// of the angle itself.
#[test]
fn coefficients_of_an_angle_share_the_derivative_by_it() {
    let operations = |coefficients: u32| {
        let mut g = Graph::new();
        let x = g.symbol(0);
        let mut angle = g.constant(0.0);
        for index in 1..=coefficients {
            let (product, coefficient) = (g.multiply(angle, x), g.symbol(index));
            angle = g.add(product, coefficient);
        }
        let (sine, cosine) = (g.sin(angle), g.cos(angle));
        let (a, b) = (g.unary(Unary::Exp, sine), g.multiply(cosine, sine));
        let f = g.add(a, b);
        let derivatives: Vec<NodeId> = (1..=coefficients).map(|index| g.derivative(f, index)).collect();
        g.schedule(1 + coefficients as usize, &derivatives).operations()
    };
    // Each further coefficient adds a power of x in the derivative of the angle, a term of the
    // angle, and the product.
    assert!(operations(12) - operations(6) <= 6 * 4, "{} {}", operations(6), operations(12));
}

/// First derivative with respect to `x` at a point where a convention decides.
#[test]
fn conventions_hold_and_no_nan_leaks_from_an_arm_not_taken() {
    type Build = fn(&mut Graph, NodeId) -> NodeId;
    let cases: &[(&str, Build, f64, f64)] = &[
        ("abs at 0", |g, x| g.unary(Unary::Abs, x), 0.0, 1.0),
        (
            "min at a tie",
            |g, x| {
                let t = g.scale(3.0, x);
                g.binary(Binary::Min, x, t)
            },
            0.0,
            1.0,
        ),
        (
            "max at a tie",
            |g, x| {
                let t = g.scale(3.0, x);
                g.binary(Binary::Max, x, t)
            },
            0.0,
            1.0,
        ),
        ("sqrt at 0", |g, x| g.sqrt(x), 0.0, f64::INFINITY),
        ("floor at a step", |g, x| g.unary(Unary::Floor, x), 1.0, 0.0),
        ("acos at 1", |g, x| g.unary(Unary::Acos, x), 1.0, f64::NEG_INFINITY),
        ("asin at -1", |g, x| g.unary(Unary::Asin, x), -1.0, f64::INFINITY),
        (
            "x^x where x is 0, of 1 + ...",
            |g, x| {
                let one = g.constant(1.0);
                let exponent = g.add(x, one);
                g.power(x, exponent)
            },
            0.0,
            1.0,
        ),
        (
            "guarded sqrt, other side",
            |g, x| {
                let zero = g.constant(0.0);
                let (root, outside) = (g.sqrt(x), g.binary(Binary::LessEqual, x, zero));
                g.select(outside, zero, root)
            },
            -1.0,
            0.0,
        ),
        (
            "guarded sqrt, at the edge",
            |g, x| {
                let zero = g.constant(0.0);
                let (root, outside) = (g.sqrt(x), g.binary(Binary::LessEqual, x, zero));
                g.select(outside, x, root)
            },
            0.0,
            1.0,
        ),
        (
            "a root used twice behind a guard",
            |g, x| {
                let zero = g.constant(0.0);
                let (root, outside) = (g.sqrt(x), g.binary(Binary::LessEqual, x, zero));
                let sine = g.sin(root);
                let product = g.multiply(root, sine);
                let chosen = g.select(outside, zero, product);
                g.unary(Unary::Exp, chosen)
            },
            -1.0,
            0.0,
        ),
        (
            "a function of a guarded quotient",
            |g, x| {
                let (zero, one) = (g.constant(0.0), g.constant(1.0));
                let sine = g.sin(x);
                let (quotient, at_zero) = (g.divide(sine, x), g.binary(Binary::Equal, x, zero));
                let guarded = g.select(at_zero, one, quotient);
                let scaled = g.multiply(guarded, x);
                g.unary(Unary::Exp, scaled)
            },
            0.0,
            1.0,
        ),
        (
            "guarded logarithm",
            |g, x| {
                let zero = g.constant(0.0);
                let (logarithm, inside) = (g.unary(Unary::Log, x), g.binary(Binary::Less, zero, x));
                g.select(inside, logarithm, x)
            },
            -2.0,
            1.0,
        ),
    ];
    for (name, build, at, expected) in cases {
        let mut g = Graph::new();
        let x = g.symbol(0);
        let f = build(&mut g, x);
        let derivative = g.derivative(f, 0);
        assert_eq!(evaluate(&g, &[derivative], &[*at])[0], *expected, "{name}");
    }
}

#[test]
fn atan2_and_resting_sqrt_are_nan_at_their_singularity() {
    let mut g = Graph::new();
    let (x, y) = (g.symbol(0), g.symbol(1));
    let angle = g.binary(Binary::Atan2, y, x);
    let norm = g.norm([x, y, y]);
    let derivatives = [g.derivative(angle, 0), g.derivative(norm, 0)];
    assert!(evaluate(&g, &derivatives, &[0.0, 0.0]).iter().all(|d| d.is_nan()));
}

#[test]
fn other_symbols_are_constants() {
    let mut g = Graph::new();
    let (x, y) = (g.symbol(0), g.symbol(1));
    let f = g.unary(Unary::Exp, y);
    let derivative = g.derivative(f, 0);
    assert!(g.is_zero(derivative));
    let product = g.multiply(f, x);
    assert_eq!(g.derivative(product, 0), f);
}

#[test]
fn substitution_replaces_everywhere_and_simplifies() {
    let mut g = Graph::new();
    let (x, y) = (g.symbol(0), g.symbol(1));
    let (s, p) = (g.sin(x), g.multiply(x, y));
    let f = g.add(s, p);
    let zero = g.constant(0.0);
    let at_zero = g.substitute(f, 0, zero);
    assert!(g.is_zero(at_zero));
    let swapped = g.substitute(f, 0, y);
    assert_close(evaluate(&g, &[swapped], &[9.0, 0.4])[0], 0.4f64.sin() + 0.16, 1e-15, "x := y");
}

/// Derivative, substitution, scheduling and dropping of a chain of 200,000 operations use no
/// recursion.
#[test]
fn deep_expressions_do_not_overflow_the_stack() {
    let mut g = Graph::new();
    let x = g.symbol(0);
    let mut f = x;
    for _ in 0..100_000 {
        f = g.sin(f);
        f = g.add(f, x);
    }
    let derivative = g.derivative(f, 0);
    let replacement = g.scale(0.5, x);
    let substituted = g.substitute(f, 0, replacement);
    let tape = g.schedule(1, &[f, derivative, substituted]);
    assert!(tape.instructions.len() > 600_000);
}
