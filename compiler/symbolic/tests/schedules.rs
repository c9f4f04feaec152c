//! Checks that tapes contain each needed operation once, with operands first, and keep few values
//! alive.

use crate::support::{Random, evaluate};
use calyx_abi::Kernel;
use calyx_symbolic::{Binary, Frame, Graph, Instruction, NodeId, Tape, TapeKernel, Unary};
use std::cell::RefCell;

/// Returns the operands of an instruction.
fn operands(instruction: Instruction) -> Vec<u32> {
    let seen = RefCell::new(Vec::new());
    instruction.evaluate(&[0.0; 16], |id| {
        seen.borrow_mut().push(id);
        0.0
    });
    seen.into_inner()
}

/// Returns the largest number of values alive at the same time, without constants and inputs.
fn pressure(tape: &Tape) -> usize {
    let mut last_use = vec![0; tape.instructions.len()];
    for (place, instruction) in tape.instructions.iter().enumerate() {
        for operand in operands(*instruction) {
            last_use[operand as usize] = place;
        }
    }
    for &output in &tape.outputs {
        last_use[output as usize] = tape.instructions.len();
    }
    let computed = |i: &Instruction| !matches!(i, Instruction::Constant(_) | Instruction::Input(_));
    (0..tape.instructions.len())
        .map(|at| (0..at).filter(|&p| computed(&tape.instructions[p]) && last_use[p] > at).count())
        .max()
        .unwrap_or(0)
}

fn planar_chain(g: &mut Graph) -> Vec<NodeId> {
    let time = g.symbol(0);
    let (zero, one) = (g.constant(0.0), g.constant(1.0));
    let mut frame = Frame::ground();
    for joint in 1..=20 {
        let angle = g.scale(f64::from(joint), time);
        let arm = g.symbol(joint % 3 + 1);
        let turn = Frame::rotate(angle, [zero, zero, one]);
        frame = Frame::translate([arm, zero, zero]).after(&turn).after(&frame);
    }
    [frame.origin(g), frame.velocity(g, 0), frame.acceleration(g, 0)].concat()
}

#[test]
fn operands_stand_before_their_use_and_nothing_is_dead_or_double() {
    let mut g = Graph::new();
    let outputs = planar_chain(&mut g);
    let dead = g.symbol(9);
    g.sin(dead);
    let tape = g.schedule(10, &outputs);
    let mut used = vec![false; tape.instructions.len()];
    tape.outputs.iter().for_each(|&output| used[output as usize] = true);
    for (place, instruction) in tape.instructions.iter().enumerate() {
        for operand in operands(*instruction) {
            assert!((operand as usize) < place);
            used[operand as usize] = true;
        }
        assert!(!tape.instructions[..place].contains(instruction), "{instruction:?} twice");
    }
    assert!(used.into_iter().all(|used| used));
}

#[test]
fn cosine_follows_immediately_on_the_sine_of_the_same_angle() {
    let mut g = Graph::new();
    let outputs = planar_chain(&mut g);
    let tape = g.schedule(10, &outputs);
    let mut pairs = 0;
    for window in tape.instructions.windows(2) {
        if let Instruction::Sin(angle) = window[0] {
            assert_eq!(window[1], Instruction::Cos(angle));
            pairs += 1;
        }
    }
    let cosines = tape.instructions.iter().filter(|i| matches!(i, Instruction::Cos(_))).count();
    assert_eq!((pairs, cosines), (20, 20));
}

/// The operand that needs more registers is computed first: a sum whose right operands are ever
/// longer chains needs three live values, not one per level.
#[test]
fn unbalanced_expressions_keep_few_values_alive() {
    let mut g = Graph::new();
    let x = g.symbol(0);
    let mut f = g.sin(x);
    for level in 1..50 {
        let scaled = g.scale(f64::from(level), x);
        let left = g.unary(Unary::Exp, scaled);
        f = g.divide(left, f);
    }
    let tape = g.schedule(1, &[f]);
    assert!(pressure(&tape) <= 3, "{}", pressure(&tape));
}

#[test]
fn outputs_may_repeat_and_be_inputs_or_constants() {
    let mut g = Graph::new();
    let (x, c) = (g.symbol(1), g.constant(4.0));
    let s = g.add(x, c);
    assert_eq!(evaluate(&g, &[x, s, c, s], &[0.0, 2.0]), [2.0, 6.0, 4.0, 6.0]);
}

#[test]
fn the_interpreter_is_a_kernel_and_agrees_with_the_definition_of_each_operation() {
    use calyx_abi::math;
    let mut g = Graph::new();
    let (x, y) = (g.symbol(0), g.symbol(1));
    let condition = g.binary(Binary::LessEqual, x, y);
    let power = g.power(x, y);
    let angle = g.binary(Binary::Atan2, x, y);
    let chosen = g.select(condition, power, angle);
    let kernel = TapeKernel(g.schedule(2, &[chosen]));
    assert_eq!((kernel.inputs(), kernel.outputs()), (2, 1));
    let mut random = Random(5);
    for _ in 0..100 {
        let (x, y) = (random.uniform(0.0, 3.0), random.uniform(0.0, 3.0));
        let mut output = [0.0];
        kernel.eval(&[x, y], &mut output);
        assert_eq!(output[0], if x <= y { math::pow(x, y) } else { math::atan2(x, y) });
    }
}
