//! The kinematic workloads as kernels, against the same formulas written by hand, interleaved in one run: read the
//! ratios. And what deriving and compiling them costs. `cargo bench -p calyx-codegen --bench kinematics`.
//!
//! As hand-written code has its own best order, so has it its own way to the sines and cosines: two angles at a time
//! (*two lanes*), or those of a tile at once by the function that compiled kernels use (*wide sines*).

mod by_hand;
mod lanes;
#[path = "../../tests/workloads/mod.rs"]
mod workloads;

use by_hand::{ByHand, Chain, Generated, Machine, Planet, Sensitivity};
use calyx_abi::Repr;
use calyx_abi::math::sincos_columns;
use calyx_codegen::{JitModule, compile_batch, compile_jit_with_tapes};
use calyx_lang::ir::{Block, Function, Program, Terminator};
use calyx_lang::span::Span;
use calyx_symbolic::batch::BatchTape;
use calyx_symbolic::{Graph, Tape};
use lanes::{Lanes, Number};
use std::hint::black_box;
use std::time::Instant;
use workloads::{WORKLOADS, Workload, chain};

/// Points of a tile (not a power of two: equal strides would share one set of the cache) and tiles of a batch.
const TILE: usize = 504;
const TILES: usize = 260;
/// Points evaluated one by one.
const SINGLE: usize = 20 * TILE;
const ROUNDS: usize = 11;

/// Evaluates one tile of points by hand. Not inlined, so that the instructions of this machine may be used in it.
type ByHandTile = Box<dyn Fn(&[&[f64]], &mut [f64])>;

fn main() {
    // `cargo test --benches` only wants to know that it runs.
    let rounds = if std::env::args().any(|argument| argument == "--bench") { ROUNDS } else { 1 };
    println!(
        "ns per point          batch  by hand, two lanes  by hand, wide sines      one point  by hand, one"
    );
    for workload in WORKLOADS {
        let p = workload.parameters;
        let ways = match workload.name {
            "W1" => [lanes_tile(Planet::new(p)), wide_tile(Planet::new(p)), single_tile(Planet::new(p))],
            "W2" => [
                lanes_tile(Generated(Machine::new(p))),
                wide_tile(Generated(Machine::new(p))),
                single_tile(Generated(Machine::new(p))),
            ],
            "W3" => [
                lanes_tile(Sensitivity(Machine::new(p))),
                wide_tile(Sensitivity(Machine::new(p))),
                single_tile(Sensitivity(Machine::new(p))),
            ],
            _ => [lanes_tile(Chain), wide_tile(Chain), single_tile(Chain)],
        };
        compare(&workload, &ways, rounds);
    }
    println!("\nms (least of {rounds})    derive    kernel     batch    operations, per point of a batch");
    for workload in WORKLOADS {
        compile_times(workload.name, workload.build, &workload.varying(), rounds);
    }
    for factors in [12, 25, 50, 100] {
        compile_times(&format!("{factors} factors"), |g| chain(g, factors / 2), &[true], rounds);
    }
}

fn compare(workload: &Workload, [lanes, wide, single]: &[ByHandTile; 3], rounds: usize) {
    let tape = workload.tape();
    let kernel = compile_batch(&tape, &workload.varying()).expect("the workload compiles");
    let one = compile(&tape).kernels().remove(0);
    let columns = workload.columns(TILES * TILE);
    let outputs = tape.outputs.len();
    let mut batch = kernel.with(workload.parameters).expect("the workload's parameters");
    let mut compiled = |columns: &[&[f64]], out: &mut [f64]| {
        let mut views: Vec<&mut [f64]> = out.chunks_mut(TILE).collect();
        batch.evaluate(columns, &mut views).expect("the workload's columns");
    };
    let mut point_by_point = {
        let mut inputs: Vec<f64> = vec![0.0; workload.variables.len()];
        inputs.extend(workload.parameters);
        let mut values = vec![0.0; outputs];
        move |columns: &[&[f64]], out: &mut [f64]| {
            for point in 0..columns[0].len() {
                for (input, column) in inputs.iter_mut().zip(columns) {
                    *input = column[point];
                }
                one.eval(&inputs, &mut values);
                for (position, &value) in values.iter().enumerate() {
                    out[position * TILE + point] = value;
                }
            }
        }
    };
    let mut ways: [(usize, &mut dyn FnMut(&[&[f64]], &mut [f64])); 5] = [
        (TILES * TILE, &mut compiled),
        (TILES * TILE, &mut |c, o| lanes(c, o)),
        (TILES * TILE, &mut |c, o| wide(c, o)),
        (SINGLE, &mut point_by_point),
        (SINGLE, &mut |c, o| single(c, o)),
    ];
    agree(workload, &mut ways, &columns, outputs);

    let mut times = [const { Vec::new() }; 5];
    let mut out = vec![0.0; outputs * TILE];
    for _ in 0..rounds {
        for ((points, way), times) in ways.iter_mut().zip(&mut times) {
            let start = Instant::now();
            for tile in 0..*points / TILE {
                let part: Vec<&[f64]> =
                    columns.iter().map(|column| &column[tile * TILE..(tile + 1) * TILE]).collect();
                way(&part, &mut out);
                black_box(&mut out);
            }
            times.push(start.elapsed().as_nanos() as f64 / *points as f64);
        }
    }
    let best = times.each_ref().map(|times| times.iter().copied().fold(f64::INFINITY, f64::min));
    // The ratio of each round, of which the middle one: what disturbs the machine disturbs neighbours alike.
    let ratio = |a: usize, b: usize| {
        let mut ratios: Vec<f64> = times[a].iter().zip(&times[b]).map(|(a, b)| a / b).collect();
        ratios.sort_by(f64::total_cmp);
        ratios[ratios.len() / 2]
    };
    println!(
        "{:<16} {:>10.2} {:>10.2} (x {:.2}) {:>11.2} (x {:.2}) {:>14.1} {:>7.1} (x {:.2})",
        workload.name,
        best[0],
        best[1],
        ratio(0, 1),
        best[2],
        ratio(0, 2),
        best[3],
        best[4],
        ratio(3, 4),
    );
}

/// All ways give the same numbers, up to rounding.
fn agree(
    workload: &Workload,
    ways: &mut [(usize, &mut dyn FnMut(&[&[f64]], &mut [f64]))],
    columns: &[Vec<f64>],
    outputs: usize,
) {
    let part: Vec<&[f64]> = columns.iter().map(|column| &column[..TILE]).collect();
    let found: Vec<Vec<f64>> = ways
        .iter_mut()
        .map(|(_, way)| {
            let mut out = vec![f64::NAN; outputs * TILE];
            way(&part, &mut out);
            out
        })
        .collect();
    for (way, other) in found.iter().enumerate().skip(1) {
        for (column, (a, b)) in found[0].chunks(TILE).zip(other.chunks(TILE)).enumerate() {
            let scale = a.iter().map(|x| x.abs()).fold(1e-300, f64::max);
            let error = a.iter().zip(b).map(|(a, b)| (a - b).abs() / scale).fold(0.0, f64::max);
            assert!(error < 1e-12, "{} output {column}, way {way}: {error:e}", workload.name);
        }
    }
}

/// Loops over a tile with `N::WIDTH` points at a time.
#[inline(always)]
fn walk<N: Number, W: ByHand<N>>(workload: &W, columns: &[&[f64]], out: &mut [f64]) {
    let points = columns[0].len();
    assert!(points.is_multiple_of(N::WIDTH) && out.len().is_multiple_of(TILE) && points <= TILE);
    let to = out.as_mut_ptr();
    let mut variables = [N::of(0.0); 3];
    let (mut angles, mut sines, mut cosines) = ([N::of(0.0); 25], [N::of(0.0); 25], [N::of(0.0); 25]);
    for point in (0..points).step_by(N::WIDTH) {
        for (variable, column) in variables[..W::VARIABLES].iter_mut().zip(columns) {
            // SAFETY: `point` and the next ones are in the column.
            *variable = unsafe { N::read(column.as_ptr().add(point)) };
        }
        workload.angles(&variables, &mut angles);
        for k in 0..W::ANGLES {
            (sines[k], cosines[k]) = angles[k].sine_and_cosine();
        }
        workload.rest(&variables, &sines, &cosines, |k, value| {
            // SAFETY: `out` has a column of `TILE` numbers for each output.
            unsafe { value.write(to.add(k * TILE + point)) }
        });
    }
}

/// The same, two points at a time, sines and cosines of a tile at once.
#[inline(always)]
fn walk_wide<W: ByHand<Lanes>>(
    workload: &W,
    columns: &[&[f64]],
    out: &mut [f64],
    memory: &mut [Vec<f64>; 3],
) {
    let points = columns[0].len();
    assert!(points.is_multiple_of(2) && out.len().is_multiple_of(TILE) && points <= TILE);
    let to = out.as_mut_ptr();
    let mut variables = [Lanes::splat(0.0); 3];
    let mut local = [Lanes::splat(0.0); 25];
    const PART: usize = 36;
    for start in (0..points).step_by(PART) {
        let part = PART.min(points - start);
        for point in (0..part).step_by(2) {
            for (variable, column) in variables[..W::VARIABLES].iter_mut().zip(columns) {
                // SAFETY: `start + point` and the next one are in the column.
                *variable = unsafe { Lanes::load(column.as_ptr().add(start + point)) };
            }
            workload.angles(&variables, &mut local);
            for k in 0..W::ANGLES {
                // SAFETY: the memory holds `ANGLES` numbers for each point of a part.
                unsafe { local[k].store(memory[0].as_mut_ptr().add(point * W::ANGLES + 2 * k)) };
            }
        }
        let [angles, sines, cosines] = &mut *memory;
        sincos_columns(&angles[..part * W::ANGLES], sines, cosines);
        for point in (0..part).step_by(2) {
            for (variable, column) in variables[..W::VARIABLES].iter_mut().zip(columns) {
                // SAFETY: as above.
                *variable = unsafe { Lanes::load(column.as_ptr().add(start + point)) };
            }
            // SAFETY: lanes lie as pairs of numbers, of which the memory holds `ANGLES` for each two points.
            let [sines, cosines] = unsafe {
                [&memory[1], &memory[2]].map(|memory| {
                    let from = memory.as_ptr().add(point * W::ANGLES).cast::<Lanes>();
                    std::array::from_fn::<Lanes, 25, _>(|k| {
                        if k < W::ANGLES { from.add(k).read_unaligned() } else { Lanes::splat(0.0) }
                    })
                })
            };
            workload.rest(&variables, &sines, &cosines, |k, value| {
                // SAFETY: `out` has a column of `TILE` numbers for each output.
                unsafe { value.store(to.add(k * TILE + start + point)) }
            });
        }
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn walk_avx<N: Number, W: ByHand<N>>(workload: &W, columns: &[&[f64]], out: &mut [f64]) {
    walk(workload, columns, out);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn walk_wide_avx<W: ByHand<Lanes>>(
    workload: &W,
    columns: &[&[f64]],
    out: &mut [f64],
    memory: &mut [Vec<f64>; 3],
) {
    walk_wide(workload, columns, out, memory);
}

fn tile_of<N: Number, W: ByHand<N> + 'static>(workload: W) -> ByHandTile {
    Box::new(move |columns, out| {
        #[cfg(target_arch = "x86_64")]
        if is_x86_feature_detected!("avx2") {
            // SAFETY: the machine has just said so.
            return unsafe { walk_avx(&workload, columns, out) };
        }
        walk(&workload, columns, out);
    })
}

fn lanes_tile<W: ByHand<Lanes> + 'static>(workload: W) -> ByHandTile {
    tile_of::<Lanes, W>(workload)
}

fn single_tile<W: ByHand<f64> + 'static>(workload: W) -> ByHandTile {
    tile_of::<f64, W>(workload)
}

fn wide_tile<W: ByHand<Lanes> + 'static>(workload: W) -> ByHandTile {
    let memory =
        std::cell::RefCell::new([const { Vec::new() }; 3].map(|_: Vec<f64>| vec![0.0; W::ANGLES * 36]));
    Box::new(move |columns, out| {
        let memory = &mut *memory.borrow_mut();
        #[cfg(target_arch = "x86_64")]
        if is_x86_feature_detected!("avx2") {
            // SAFETY: the machine has just said so.
            return unsafe { walk_wide_avx(&workload, columns, out, memory) };
        }
        walk_wide(&workload, columns, out, memory);
    })
}

fn compile(tape: &Tape) -> JitModule {
    let main = Function {
        name: "main".into(),
        parameters: vec![],
        result: Repr::Unit,
        locals: vec![],
        blocks: vec![Block { statements: vec![], terminator: Terminator::Return(None) }],
        span: Span::default(),
    };
    let program = Program { functions: vec![main], ..Program::default() };
    compile_jit_with_tapes(&program, std::slice::from_ref(tape), &[]).expect("the bench compiles")
}

/// Least times of deriving a tape, of compiling its kernel for one point, and that for many.
fn compile_times(
    name: &str,
    build: impl Fn(&mut Graph) -> Vec<calyx_symbolic::NodeId>,
    varying: &[bool],
    rounds: usize,
) {
    let mut least = [f64::INFINITY; 3];
    let mut counts = (0, 0);
    for _ in 0..rounds {
        let start = Instant::now();
        let mut graph = Graph::new();
        let outputs = build(&mut graph);
        let tape = graph.schedule(varying.len(), &outputs);
        let derived = start.elapsed();
        black_box(compile(&tape));
        let one = start.elapsed() - derived;
        black_box(compile_batch(&tape, varying).expect("the bench compiles"));
        let many = start.elapsed() - derived - one;
        for (least, time) in least.iter_mut().zip([derived, one, many]) {
            *least = least.min(time.as_secs_f64() * 1e3);
        }
        counts = (tape.operations(), BatchTape::new(tape, varying).varying_operations());
    }
    let [derive, one, many] = least;
    println!("{name:<16} {derive:>10.2} {one:>9.2} {many:>9.2} {:>12} {:>8}", counts.0, counts.1);
}
