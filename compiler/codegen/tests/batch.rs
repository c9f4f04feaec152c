//! Batch kernels give the bits of kernels for one point, whatever varies and however many points
//! there are, and take no more operations than the same formulas written by hand.

use crate::workloads::{Random, WORKLOADS};
use calyx_codegen::{BatchError, BatchKernel, compile_batch};
use calyx_symbolic::batch::BatchTape;
use calyx_symbolic::{Instruction, Tape};

fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan()
}

/// Evaluates at all points and compares with the interpreted tape.
fn assert_same_bits(
    tape: &Tape,
    varying: &[bool],
    kernel: &BatchKernel,
    uniforms: &[f64],
    columns: &[Vec<f64>],
    points: usize,
) {
    let columns: Vec<&[f64]> = columns.iter().map(|column| &column[..points]).collect();
    // One number more than there are points, which must not be overwritten.
    let mut outputs = vec![vec![7.5; points + 1]; tape.outputs.len()];
    let mut views: Vec<&mut [f64]> = outputs.iter_mut().map(|column| &mut column[..points]).collect();
    kernel.evaluate(uniforms, &columns, &mut views).unwrap();
    assert!(outputs.iter().all(|column| column[points] == 7.5));
    let (mut scratch, mut expected) = (Vec::new(), vec![0.0; tape.outputs.len()]);
    for point in 0..points {
        let (mut column, mut uniform) = (0, 0);
        let inputs: Vec<f64> = varying
            .iter()
            .map(|&varies| {
                let (from, count) = if varies {
                    (columns[column][point], &mut column)
                } else {
                    (uniforms[uniform], &mut uniform)
                };
                *count += 1;
                from
            })
            .collect();
        tape.eval(&inputs, &mut scratch, &mut expected);
        for (position, &expected) in expected.iter().enumerate() {
            let found = outputs[position][point];
            assert!(same(found, expected), "output {position} at point {point}: {found:e}, not {expected:e}");
        }
    }
}

const INPUTS: usize = 6;

fn random_tape(length: usize, random: &mut Random) -> Tape {
    use Instruction as I;
    let mut instructions: Vec<Instruction> = (0..INPUTS as u32).map(I::Input).collect();
    while instructions.len() < length {
        let before = instructions.len();
        let mut operand = || {
            let near = if random.uniform(0.0, 1.0) < 0.2 { before } else { before.min(24) };
            (before - 1 - random.uniform(0.0, near as f64) as usize) as u32
        };
        let (a, b, c) = (operand(), operand(), operand());
        instructions.push(match random.uniform(0.0, 31.0) as usize {
            0 => I::Constant(random.uniform(-3.0, 3.0)),
            1 => I::Negate(a),
            2 => I::Abs(a),
            3 => I::Sqrt(a),
            4 | 5 => I::Sin(a),
            6 | 7 => I::Cos(a),
            8 => I::Tan(a),
            9 => I::Asin(a),
            10 => I::Acos(a),
            11 => I::Atan(a),
            12 => I::Exp(a),
            13 => I::Log(a),
            14 => I::Floor(a),
            15 => I::Ceil(a),
            16 => I::Round(a),
            17 => I::Not(a),
            18 => I::Add(a, b),
            19 => I::Subtract(a, b),
            20 => I::Multiply(a, b),
            21 => I::Divide(a, b),
            22 => I::Power(a, b),
            23 => I::Atan2(a, b),
            24 => I::Min(a, b),
            25 => I::Max(a, b),
            26 => I::Less(a, b),
            27 => I::LessEqual(a, b),
            28 => I::Equal(a, b),
            29 => I::And(a, b),
            30 => I::Or(a, b),
            _ => I::Select(a, b, c),
        });
        let last = instructions.len() as u32 - 1;
        if random.uniform(0.0, 1.0) < 0.1 {
            instructions.push(I::Select(last, b, c));
        }
    }
    let outputs = (0..length as u32).filter(|_| random.uniform(0.0, 1.0) < 0.2).chain([0, 0, 5]).collect();
    Tape { inputs: INPUTS, instructions, outputs, ..Tape::default() }
}

fn number(random: &mut Random) -> f64 {
    const SPECIAL: [f64; 8] = [0.0, -0.0, 1.0, 5e-324, -1e308, f64::INFINITY, f64::NAN, 1e7];
    match random.uniform(0.0, 64.0) as usize {
        special @ 0..8 => SPECIAL[special],
        _ => random.uniform(-8.0, 8.0),
    }
}

#[test]
fn random_tapes_have_the_same_bits_at_every_point() {
    let mut random = Random(11);
    for length in [6, 7, 40, 300, 1100, 2600] {
        for round in 0..3 {
            let tape = random_tape(length, &mut random);
            let varying: Vec<bool> =
                (0..INPUTS).map(|input| input == round || random.uniform(0.0, 1.0) < 0.4).collect();
            let kernel = compile_batch(&tape, &varying).unwrap();
            let uniforms: Vec<f64> = (0..kernel.uniforms()).map(|_| number(&mut random)).collect();
            let columns: Vec<Vec<f64>> =
                (0..kernel.columns()).map(|_| (0..301).map(|_| number(&mut random)).collect()).collect();
            for points in [0, 1, 2, 3, 64, 301] {
                assert_same_bits(&tape, &varying, &kernel, &uniforms, &columns, points);
            }
        }
    }
}

#[test]
fn the_workloads_have_the_same_bits_at_every_point() {
    for workload in WORKLOADS {
        let (tape, varying) = (workload.tape(), workload.varying());
        let kernel = compile_batch(&tape, &varying).unwrap();
        assert_eq!(
            (kernel.uniforms(), kernel.columns()),
            (workload.parameters.len(), workload.variables.len())
        );
        let columns = workload.columns(259);
        for points in [1, 8, 259] {
            assert_same_bits(&tape, &varying, &kernel, workload.parameters, &columns, points);
        }
        // Parameters also as columns.
        let everything = vec![true; workload.inputs()];
        let kernel = compile_batch(&tape, &everything).unwrap();
        let mut all = columns.clone();
        all.extend(workload.parameters.iter().map(|&value| vec![value; 259]));
        assert_same_bits(&tape, &everything, &kernel, &[], &all, 259);
    }
}

/// Compares operations per point, without sines and cosines, with those of the hand-written
/// formulas (in the bench `kinematics`, including negations).
#[test]
fn the_workloads_cost_what_formulas_written_by_hand_cost() {
    for (workload, (angles, by_hand)) in WORKLOADS.iter().zip([(2, 36), (3, 364), (3, 229), (25, 3619)]) {
        let batch = BatchTape::new(workload.tape(), &workload.varying());
        let operations = batch.varying_operations();
        assert!(operations * 100 <= by_hand * 108, "{}: {operations} operations", workload.name);
        assert_eq!(batch.angles.iter().map(Vec::len).sum::<usize>(), angles, "{}", workload.name);
    }
}

#[test]
fn outputs_may_be_inputs_constants_sines_or_nothing() {
    use Instruction::{Add, Constant, Cos, Input, Sin};
    let instructions = vec![Input(0), Input(1), Constant(-0.0), Sin(0), Sin(3), Cos(1), Add(1, 2)];
    let mut random = Random(3);
    let columns = vec![(0..70).map(|_| number(&mut random)).collect::<Vec<f64>>()];
    for outputs in [vec![0, 1, 2, 3, 4, 5, 6, 0], vec![5, 2], vec![0], vec![4], vec![]] {
        let tape = Tape { inputs: 2, instructions: instructions.clone(), outputs, ..Tape::default() };
        for varying in [[true, false], [false, true]] {
            let kernel = compile_batch(&tape, &varying).unwrap();
            for points in [0, 1, 5, 70] {
                assert_same_bits(&tape, &varying, &kernel, &[0.7], &columns, points);
            }
        }
    }
    // No input varies: the same number everywhere.
    let tape = Tape { inputs: 2, instructions, outputs: vec![3, 2], ..Tape::default() };
    let kernel = compile_batch(&tape, &[]).unwrap();
    assert_same_bits(&tape, &[false, false], &kernel, &[0.3, 0.4], &[], 0);
    let (mut sines, mut zeros) = ([0.0; 3], [1.0; 3]);
    kernel.evaluate(&[0.3, 0.4], &[], &mut [&mut sines, &mut zeros]).unwrap();
    assert_eq!((sines, zeros), ([calyx_abi::math::sin(0.3); 3], [0.0; 3]));
}

#[test]
fn what_does_not_fit_is_refused_and_nothing_written() {
    let instructions = vec![Instruction::Input(0), Instruction::Input(1), Instruction::Add(0, 1)];
    let tape = Tape { inputs: 2, instructions, outputs: vec![2], ..Tape::default() };
    let kernel = compile_batch(&tape, &[true, false]).unwrap();
    let (column, mut output) = ([1.0, 2.0], [7.0; 2]);
    let cases: [(&[f64], &[&[f64]]); 3] = [(&[], &[&column]), (&[1.0], &[]), (&[1.0], &[&column, &column])];
    for (uniforms, columns) in cases {
        let refused = kernel.evaluate(uniforms, columns, &mut [&mut output]);
        assert!(matches!(refused, Err(BatchError::Count { .. })), "{refused:?}");
    }
    let refused = kernel.evaluate(&[1.0], &[&column[..1]], &mut [&mut output]);
    assert_eq!(refused, Err(BatchError::Length { what: "outputs", column: 0, given: 2, expected: 1 }));
    assert_eq!(refused.unwrap_err().to_string(), "column 0 of the outputs has 2 points, the first one has 1");
    assert_eq!(output, [7.0; 2]);
    kernel.evaluate(&[1.0], &[&column], &mut [&mut output]).unwrap();
    assert_eq!(output, [2.0, 3.0]);
    assert!(compile_batch(&Tape { outputs: vec![9], ..tape }, &[true]).is_err());
}

#[test]
fn several_threads_may_share_the_points() {
    let workload = &WORKLOADS[0];
    let kernel = compile_batch(&workload.tape(), &workload.varying()).unwrap();
    let column = workload.columns(1000).remove(0);
    let run = |part: &[f64]| {
        let mut outputs = vec![vec![0.0; part.len()]; kernel.outputs()];
        let mut views: Vec<&mut [f64]> = outputs.iter_mut().map(|column| &mut column[..]).collect();
        kernel.evaluate(workload.parameters, &[part], &mut views).unwrap();
        outputs
    };
    let whole = run(&column);
    let parts: Vec<Vec<Vec<f64>>> = std::thread::scope(|scope| {
        let threads: Vec<_> = column.chunks(333).map(|part| scope.spawn(move || run(part))).collect();
        threads.into_iter().map(|thread| thread.join().unwrap()).collect()
    });
    for (position, whole) in whole.iter().enumerate() {
        let joined: Vec<f64> = parts.iter().flat_map(|part| part[position].clone()).collect();
        assert_eq!(&joined, whole);
    }
}
