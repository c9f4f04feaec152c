//! Tests the kernels of sites that are given as typed expressions.

use calyx_abi::{Kernel, Repr, math};
use calyx_lang::ir::{
    Capture, DisplayUnit, FunctionId, Op, Param, Program, Site, SiteId, SymExpr, SymKind, Symbol,
};
use calyx_lang::span::Span;
use calyx_lower::kernels::lower_site;
use calyx_lower::operations::{Scalars, expand};
use calyx_symbolic::TapeKernel;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_3};

fn expr(kind: SymKind, repr: Repr) -> SymExpr {
    SymExpr { kind, repr, span: Span::default() }
}

fn number(value: f64) -> SymExpr {
    expr(SymKind::Number(value), Repr::Number)
}

fn time() -> SymExpr {
    expr(SymKind::Time, Repr::Number)
}

fn param(index: u32) -> SymExpr {
    expr(SymKind::Param(index), Repr::Number)
}

fn capture(index: u32, repr: Repr) -> SymExpr {
    expr(SymKind::Capture(index), repr)
}

/// Returns an operation; the operation determines the representation of the result.
fn op(op: Op, operands: Vec<SymExpr>) -> SymExpr {
    let repr = match op {
        Op::Not | Op::Less | Op::LessEqual | Op::Greater | Op::GreaterEqual | Op::Equal | Op::NotEqual => {
            Repr::Bool
        }
        Op::Translate | Op::Rotate | Op::Compose | Op::Inverse => Repr::Transform,
        Op::Vector | Op::AddVector | Op::SubtractVector | Op::Cross | Op::NegateVector | Op::Scale => {
            Repr::Vector
        }
        Op::Apply | Op::Origin | Op::Direction => Repr::Vector,
        Op::Velocity | Op::Acceleration | Op::AngularVelocity | Op::AngularAcceleration => Repr::Vector,
        _ => Repr::Number,
    };
    expr(SymKind::Op(op, operands), repr)
}

fn vector(components: [f64; 3]) -> SymExpr {
    op(Op::Vector, components.map(number).to_vec())
}

fn conditional(condition: SymExpr, then: SymExpr, otherwise: SymExpr) -> SymExpr {
    let repr = then.repr.clone();
    expr(SymKind::If(Box::new(condition), Box::new(then), Box::new(otherwise)), repr)
}

fn derivative(inner: SymExpr, symbol: Symbol) -> SymExpr {
    let repr = inner.repr.clone();
    expr(SymKind::Derivative(Box::new(inner), symbol), repr)
}

fn at(inner: SymExpr, symbol: Symbol, value: SymExpr) -> SymExpr {
    let repr = inner.repr.clone();
    expr(SymKind::At(Box::new(inner), symbol, Box::new(value)), repr)
}

/// Returns a program with one site and two params.
fn program(expr: SymExpr, captures: Vec<(Repr, bool)>, order: u8) -> Program {
    let unit = DisplayUnit { name: String::new(), factor: 1.0, dimension: [(0, 1); 8] };
    let param = Param {
        name: "p".into(),
        doc: String::new(),
        repr: Repr::Number,
        default: FunctionId(0),
        low: None,
        high: None,
        choices: Vec::new(),
        unit,
        integral: false,
        span: Span::default(),
        given: None,
    };
    let captures = captures
        .into_iter()
        .map(|(repr, observable)| Capture { name: "captured".into(), repr, observable })
        .collect();
    let repr = expr.repr.clone();
    let site = Site {
        name: "site".into(),
        shared: Vec::new(),
        expr,
        captures,
        repr,
        order,
        part: false,
        span: Span::default(),
    };
    Program { params: vec![param.clone(), param], sites: vec![site], ..Program::default() }
}

/// Returns the outputs of the site's kernel for `[Time, p0, p1, captured...]`.
fn run(program: &Program, inputs: &[f64]) -> Vec<f64> {
    let kernel = TapeKernel(lower_site(program, SiteId(0)).unwrap());
    assert_eq!(kernel.inputs(), inputs.len());
    let mut outputs = vec![f64::NAN; kernel.outputs()];
    kernel.eval(inputs, &mut outputs);
    outputs
}

#[track_caller]
fn assert_close(actual: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(actual.len(), expected.len());
    for (i, (a, e)) in actual.iter().zip(expected).enumerate() {
        assert!((a - e).abs() <= tolerance * e.abs().max(1.0), "component {i}: {a} instead of {e}");
    }
}

#[test]
fn every_operation_on_numbers_has_its_value() {
    let (a, b) = (0.37, -0.81);
    let cases = [
        (Op::Add, a + b),
        (Op::Subtract, a - b),
        (Op::Multiply, a * b),
        (Op::Divide, a / b),
        (Op::Power, math::pow(a, b)),
        (Op::Atan2, math::atan2(a, b)),
        (Op::Min, b),
        (Op::Max, a),
        (Op::Less, 0.0),
        (Op::LessEqual, 0.0),
        (Op::Greater, 1.0),
        (Op::GreaterEqual, 1.0),
        (Op::Equal, 0.0),
        (Op::NotEqual, 1.0),
    ];
    for (operation, expected) in cases {
        let program = program(op(operation, vec![param(0), param(1)]), vec![], 0);
        assert_eq!(run(&program, &[9.0, a, b]), [expected], "{operation:?}");
    }
    let cases = [
        (Op::Negate, -a),
        (Op::Not, 0.0),
        (Op::Sqrt, a.sqrt()),
        (Op::Abs, a),
        (Op::Sin, math::sin(a)),
        (Op::Cos, math::cos(a)),
        (Op::Tan, math::tan(a)),
        (Op::Asin, math::asin(a)),
        (Op::Acos, math::acos(a)),
        (Op::Atan, math::atan(a)),
        (Op::Exp, math::exp(a)),
        (Op::Log, math::log(a)),
        (Op::Floor, 0.0),
        (Op::Ceil, 1.0),
        (Op::Round, 0.0),
    ];
    for (operation, expected) in cases {
        let program = program(op(operation, vec![param(0)]), vec![], 0);
        assert_eq!(run(&program, &[9.0, a, b]), [expected], "{operation:?}");
    }
}

#[test]
fn every_operation_on_vectors_and_transforms_has_its_value() {
    let (u, v) = ([1.0, 2.0, 3.0], [-1.0, 0.5, 2.0]);
    let both = || vec![vector(u), vector(v)];
    let quarter = || op(Op::Rotate, vec![number(FRAC_PI_2), vector([0.0, 0.0, 1.0])]);
    let moved = || op(Op::Translate, vec![vector(u)]);
    let cases = [
        (op(Op::X, vec![vector(u)]), vec![1.0]),
        (op(Op::Y, vec![vector(u)]), vec![2.0]),
        (op(Op::Z, vec![vector(u)]), vec![3.0]),
        (op(Op::Norm, vec![vector(u)]), vec![14f64.sqrt()]),
        (op(Op::Dot, both()), vec![6.0]),
        (op(Op::AddVector, both()), vec![0.0, 2.5, 5.0]),
        (op(Op::SubtractVector, both()), vec![2.0, 1.5, 1.0]),
        (op(Op::Cross, both()), vec![2.5, -5.0, 2.5]),
        (op(Op::NegateVector, vec![vector(u)]), vec![-1.0, -2.0, -3.0]),
        (op(Op::Scale, vec![number(2.0), vector(u)]), vec![2.0, 4.0, 6.0]),
        (op(Op::Equal, both()), vec![0.0]),
        (op(Op::NotEqual, vec![vector(u), vector(u)]), vec![0.0]),
        (op(Op::Apply, vec![moved(), vector(v)]), vec![-2.0, -1.5, -1.0]),
        (op(Op::Apply, vec![quarter(), vector(v)]), vec![0.5, 1.0, 2.0]),
        (op(Op::Apply, vec![op(Op::Compose, vec![quarter(), moved()]), vector(v)]), vec![-1.5, 2.0, -1.0]),
        (op(Op::Origin, vec![op(Op::Compose, vec![moved(), quarter()])]), vec![-2.0, 1.0, 3.0]),
        (op(Op::Direction, vec![quarter(), vector([1.0, 0.0, 0.0])]), vec![0.0, 1.0, 0.0]),
        (op(Op::Inverse, vec![moved()]), vec![1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 3.0]),
    ];
    for (expr, expected) in cases {
        assert_close(&run(&program(expr, vec![], 0), &[0.0; 3]), &expected, 1e-15);
    }
}

/// Returns the planet of the report, section 3.1.2, with a separate frame for the carrier.
fn planet(runout: [f64; 3], pin_error: [f64; 3]) -> SymExpr {
    let e3 = || vector([0.0, 0.0, 1.0]);
    let (planet, carrier) = (param(0), param(1));
    let relative = op(Op::Subtract, vec![planet, carrier.clone()]);
    let turn = op(Op::Add, vec![op(Op::Multiply, vec![relative, time()]), number(PHASE)]);
    let center_distance = op(Op::Scale, vec![number(CENTER_DISTANCE), vector([0.0, 1.0, 0.0])]);
    let pin = op(Op::AddVector, vec![center_distance, vector(pin_error)]);
    let carrier = op(Op::Rotate, vec![op(Op::Multiply, vec![carrier, time()]), e3()]);
    [
        op(Op::Translate, vec![vector(runout)]),
        op(Op::Rotate, vec![turn, e3()]),
        op(Op::Translate, vec![pin]),
        carrier,
    ]
    .into_iter()
    .reduce(|a, b| op(Op::Compose, vec![a, b]))
    .unwrap()
}

const CENTER_DISTANCE: f64 = 10.0;
const PHASE: f64 = 0.3;
/// Speeds of the planet and the carrier. The times cover less than a rotation, so that rounding of
/// the angle is 1e-15.
const SPEEDS: [f64; 2] = [3.3, 1.1];

#[test]
fn the_planet_keeps_its_center_distance_and_turns_with_the_carrier() {
    let [own, carrier] = SPEEDS;
    let kernel = |operation| program(op(operation, vec![planet([0.0; 3], [0.0; 3])]), vec![], 0);
    for t in [0.0, 0.4, 1.7, 3.9] {
        let inputs = [t, own, carrier];
        let (sine, cosine) = (carrier * t).sin_cos();
        // On the carrier's e2 axis, which rotates with the carrier.
        let origin = [-CENTER_DISTANCE * sine, CENTER_DISTANCE * cosine, 0.0];
        assert_close(&run(&kernel(Op::Origin), &inputs), &origin, 1e-14);
        let velocity = [-carrier * origin[1], carrier * origin[0], 0.0];
        assert_close(&run(&kernel(Op::Velocity), &inputs), &velocity, 1e-14);
        let acceleration = origin.map(|x| -carrier * carrier * x);
        assert_close(&run(&kernel(Op::Acceleration), &inputs), &acceleration, 1e-14);
        // The planet's speed is relative to ground.
        assert_close(&run(&kernel(Op::AngularVelocity), &inputs), &[0.0, 0.0, own], 1e-15);
        assert_close(&run(&kernel(Op::AngularAcceleration), &inputs), &[0.0; 3], 1e-15);
        let axis = op(Op::Direction, vec![planet([0.0; 3], [0.0; 3]), vector([1.0, 0.0, 0.0])]);
        let (sine, cosine) = (own * t + PHASE).sin_cos();
        assert_close(&run(&program(axis, vec![], 0), &inputs), &[cosine, sine, 0.0], 1e-14);
    }
}

#[test]
fn the_planets_errors_are_measured_in_their_own_frames() {
    // At time zero: the pin error along the carrier's axes; the runout along the planet's axes,
    // rotated by the phase.
    let (sine, cosine) = PHASE.sin_cos();
    let frame = program(op(Op::Origin, vec![planet([0.02, 0.01, 0.0], [0.03, 0.04, 0.0])]), vec![], 0);
    let expected = [0.03 + 0.02 * cosine - 0.01 * sine, 10.04 + 0.02 * sine + 0.01 * cosine, 0.0];
    assert_close(&run(&frame, &[0.0, 3.3, 1.1]), &expected, 1e-15);
}

#[test]
fn a_transform_site_has_its_pose_and_two_derivatives() {
    let rotate = op(Op::Rotate, vec![op(Op::Multiply, vec![param(0), time()]), vector([0.0, 0.0, 1.0])]);
    let program = program(rotate, vec![], 2);
    let (sine, cosine) = FRAC_PI_3.sin_cos();
    let w = FRAC_PI_3 / 2.0;
    let mut expected = vec![cosine, sine, 0.0, -sine, cosine, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];
    let turned = [-sine, cosine, 0.0, -cosine, -sine, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0].map(|r| r * w);
    expected.extend(turned);
    expected
        .extend([-cosine, -sine, 0.0, sine, -cosine, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0].map(|r| r * w * w));
    assert_close(&run(&program, &[2.0, w, f64::NAN]), &expected, 1e-15);
}

#[test]
fn number_and_vector_sites_append_their_derivatives_order_by_order() {
    let cube = op(Op::Power, vec![time(), number(3.0)]);
    let square = op(Op::Power, vec![time(), number(2.0)]);
    let vector = op(Op::Vector, vec![cube.clone(), square, time()]);
    assert_eq!(run(&program(cube, vec![], 2), &[2.0, 0.0, 0.0]), [8.0, 12.0, 12.0]);
    assert_eq!(run(&program(vector, vec![], 1), &[2.0, 0.0, 0.0]), [8.0, 4.0, 2.0, 12.0, 4.0, 1.0]);
}

#[test]
fn captured_values_are_inputs_in_order_and_constant() {
    let captures =
        vec![(Repr::Number, false), (Repr::Vector, false), (Repr::Transform, false), (Repr::Bool, false)];
    let point = op(
        Op::Scale,
        vec![op(Op::Multiply, vec![capture(0, Repr::Number), time()]), capture(1, Repr::Vector)],
    );
    let applied = op(Op::Apply, vec![capture(2, Repr::Transform), point]);
    let chosen = conditional(capture(3, Repr::Bool), applied, vector([0.0; 3]));
    // A quarter turn about e3 and a translation: x' = R x + t.
    let pose = [0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 5.0, 6.0, 7.0];
    let inputs = |flag: f64| [&[2.0, 0.0, 0.0, 3.0, 1.0, 2.0, 4.0][..], &pose, &[flag]].concat();
    let program = program(chosen, captures, 1);
    assert_eq!(run(&program, &inputs(1.0)), [17.0, 0.0, 31.0, 6.0, -3.0, 12.0]);
    assert_eq!(run(&program, &inputs(0.0)), [0.0; 6]);
}

#[test]
fn derivatives_and_at_nest_in_the_order_written() {
    let product = || op(Op::Multiply, vec![param(0), op(Op::Power, vec![time(), number(2.0)])]);
    let cases = [
        (derivative(product(), Symbol::Time), 12.0),
        (derivative(derivative(product(), Symbol::Time), Symbol::Param(0)), 4.0),
        (at(derivative(product(), Symbol::Time), Symbol::Time, number(5.0)), 30.0),
        (derivative(at(product(), Symbol::Time, number(5.0)), Symbol::Time), 0.0),
        (derivative(at(product(), Symbol::Time, op(Op::Sqrt, vec![time()])), Symbol::Time), 3.0),
        (at(product(), Symbol::Param(0), param(1)), 28.0),
    ];
    for (expr, expected) in cases {
        assert_close(&run(&program(expr, vec![], 0), &[2.0, 3.0, 7.0]), &[expected], 1e-15);
    }
    let frame = op(Op::Rotate, vec![time(), vector([0.0, 0.0, 1.0])]);
    let stopped = op(Op::Apply, vec![at(frame, Symbol::Time, number(FRAC_PI_2)), vector([0.0, 1.0, 0.0])]);
    assert_close(&run(&program(stopped, vec![], 0), &[0.0; 3]), &[1.0, 0.0, 0.0], 1e-15);
}

#[test]
fn a_conditional_frame_keeps_the_other_branch_out_of_its_derivatives() {
    let axis = || vector([0.0, 0.0, 1.0]);
    let late = op(Op::Greater, vec![time(), number(0.0)]);
    let ramp = op(Op::Rotate, vec![op(Op::Sqrt, vec![time()]), axis()]);
    let rest = op(Op::Rotate, vec![time(), axis()]);
    let frame = conditional(late, ramp, rest);
    let spin = |expr: &SymExpr| program(op(Op::AngularVelocity, vec![expr.clone()]), vec![], 0);
    assert_close(&run(&spin(&frame), &[-1.0, 0.0, 0.0]), &[0.0, 0.0, 1.0], 1e-15);
    assert_close(&run(&spin(&frame), &[4.0, 0.0, 0.0]), &[0.0, 0.0, 0.25], 1e-15);
    assert!(run(&program(frame, vec![], 2), &[-1.0, 0.0, 0.0]).iter().all(|x| x.is_finite()));
}

#[test]
fn what_has_no_derivative_is_refused_not_zero() {
    let observable = || capture(0, Repr::Symbolic(Box::new(Repr::Number)));
    let captures = || vec![(Repr::Symbolic(Box::new(Repr::Number)), true)];
    let twice = op(Op::Multiply, vec![number(2.0), observable()]);
    assert_eq!(run(&program(twice.clone(), captures(), 0), &[0.0, 0.0, 0.0, 4.0]), [8.0]);
    let frame = op(Op::Rotate, vec![observable(), vector([0.0, 0.0, 1.0])]);
    let refused = [
        (program(derivative(twice.clone(), Symbol::Time), captures(), 0), "only at solved steps"),
        (program(twice, captures(), 1), "only at solved steps"),
        (program(op(Op::AngularVelocity, vec![frame.clone()]), captures(), 0), "only at solved steps"),
        (program(derivative(frame, Symbol::Param(0)), vec![(Repr::Number, false)], 0), "not a frame"),
        (program(op(Op::Add, vec![number(1.0), vector([0.0; 3])]), vec![], 0), "do not fit"),
        (program(param(2), vec![], 0), "no such param"),
    ];
    for (program, reason) in refused {
        let error = lower_site(&program, SiteId(0)).unwrap_err();
        assert!(error.message.contains(reason), "{}", error.message);
    }
    assert!(lower_site(&Program::default(), SiteId(0)).is_err());
}

/// Evaluates operations on numbers with kernels.
struct OnNumbers;

impl Scalars for OnNumbers {
    type Value = f64;

    fn number(&mut self, value: f64) -> f64 {
        value
    }

    fn apply(&mut self, operation: Op, operands: &[f64]) -> Option<f64> {
        let captures = vec![(Repr::Number, false); operands.len()];
        let symbols = (0..).take(operands.len()).map(|i| capture(i, Repr::Number)).collect();
        let found = run(&program(op(operation, symbols), captures, 0), &[&[0.0; 3], operands].concat());
        found.first().copied()
    }

    fn both(&mut self, a: f64, b: f64) -> f64 {
        if a != 0.0 && b != 0.0 { 1.0 } else { 0.0 }
    }
}

/// Evaluated expressions use [`expand`] and symbolic ones the graph; on numbers both must agree.
#[test]
fn symbolic_operations_agree_with_evaluated_ones() {
    let (one, three, frame) = (vec![0.7], vec![0.36, -0.48, 0.8], {
        let turned = op(Op::Rotate, vec![param(0), vector([0.6, 0.0, -0.8])]);
        let moved = op(Op::Translate, vec![vector([1.0, 2.0, 3.0])]);
        run(&program(op(Op::Compose, vec![turned, moved]), vec![], 0), &[0.0, 1.1, 0.0])
    });
    let (n, v, t) = (
        || (Repr::Number, one.clone()),
        || (Repr::Vector, three.clone()),
        || (Repr::Transform, frame.clone()),
    );
    let cases = [
        (Op::Vector, vec![n(), n(), n()]),
        (Op::X, vec![v()]),
        (Op::Y, vec![v()]),
        (Op::Z, vec![v()]),
        (Op::Norm, vec![v()]),
        (Op::AddVector, vec![v(), v()]),
        (Op::SubtractVector, vec![v(), v()]),
        (Op::NegateVector, vec![v()]),
        (Op::Scale, vec![n(), v()]),
        (Op::Dot, vec![v(), v()]),
        (Op::Cross, vec![v(), v()]),
        (Op::Equal, vec![v(), v()]),
        (Op::NotEqual, vec![v(), v()]),
        (Op::Translate, vec![v()]),
        (Op::Rotate, vec![n(), v()]),
        (Op::Compose, vec![t(), t()]),
        (Op::Apply, vec![t(), v()]),
        (Op::Inverse, vec![t()]),
        (Op::Origin, vec![t()]),
        (Op::Direction, vec![t(), v()]),
    ];
    for (operation, operands) in cases {
        let captures: Vec<_> = operands.iter().map(|(repr, _)| (repr.clone(), false)).collect();
        let symbols = operands.iter().zip(0..).map(|((repr, _), i)| capture(i, repr.clone())).collect();
        let values: Vec<f64> = operands.into_iter().flat_map(|(_, values)| values).collect();
        let actual = run(&program(op(operation, symbols), captures, 0), &[&[0.0; 3], &values[..]].concat());
        let expected = expand(&mut OnNumbers, operation, &values).unwrap();
        // The order of additions may differ: a few units in the last place of numbers below ten.
        assert_close(&actual, &expected, 1e-14);
    }
}
