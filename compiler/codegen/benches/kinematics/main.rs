//! Benchmarks the kinematic workloads as kernels against hand-written code, interleaved in one run,
//! and measures differentiation and compile time. The ratios are meaningful, the absolute times are
//! not. Run it with `cargo bench -p calyx-codegen --bench kinematics`. The workloads are the
//! functions of `examples/kinematics`; chains of other lengths are built as graphs.
//!
//! The hand-written code has its own optimal order and its own evaluation of sines and cosines: two
//! angles per call (*two lanes*), or all angles of a tile with the function that compiled kernels
//! use (*wide sines*).

mod by_hand;
#[path = "../../tests/common/mod.rs"]
#[allow(dead_code, reason = "shared by several tests")]
mod common;
mod lanes;
#[path = "../../tests/workloads/mod.rs"]
#[allow(dead_code, reason = "shared by several tests")]
mod workloads;

use by_hand::{ByHand, Chain, Generated, Machine, Planet, Sensitivity};
use calyx_abi::math::sincos_columns;
use calyx_codegen::{compile_batch, compile_kernel};
use calyx_lang::ir::{Program, SymbolicFunctionId};
use calyx_lower::kernels::lower_kernel;
use calyx_symbolic::batch::BatchTape;
use calyx_symbolic::{Graph, Tape};
use common::text::{check, defaults, read};
use lanes::{Lanes, Number};
use std::hint::black_box;
use std::time::Instant;
use workloads::{WORKLOADS, Workload, chain};

/// File and function of each workload.
const WRITTEN: [(&str, &str); 4] =
    [("planet", "motion"), ("face_milling", "surface"), ("face_milling", "sensitivity"), ("chain", "motion")];

/// A workload written in Calyx.
struct Written {
    workload: Workload,
    program: Program,
    function: SymbolicFunctionId,
    /// The uniform inputs: time, which no output uses, and the params.
    uniforms: Vec<f64>,
}

impl Written {
    fn new(workload: Workload, file: &str, function: &str) -> Self {
        let program = check(&read(&format!("examples/kinematics/{file}.cx")));
        let place = program.symbolic_functions.iter().position(|f| f.exported && f.name == function);
        let function = SymbolicFunctionId(place.expect("the function is there") as u32);
        let uniforms = [vec![0.0], defaults(&program)].concat();
        Written { workload, program, function, uniforms }
    }

    fn tape(&self) -> Tape {
        lower_kernel(&self.program, self.function).expect("the workload is an expression")
    }

    fn varying(&self) -> Vec<bool> {
        let mut varying = vec![false; self.uniforms.len()];
        varying.resize(self.uniforms.len() + self.workload.variables.len(), true);
        varying
    }
}

/// Points of a tile (not a power of two: equal strides would map to the same cache set) and tiles
/// of a batch.
const TILE: usize = 504;
const TILES: usize = 260;
/// Number of tiles before the next variant runs, so that disturbances of the machine affect all
/// variants equally. It is smaller where points are evaluated one by one.
const SLICE: usize = 10;
const SLICE_OF_ONE: usize = 2;
const ROUNDS: usize = 5;

/// Evaluates one tile of points with hand-written code. It is not inlined, so that it can use all
/// instructions of this machine.
type ByHandTile = Box<dyn Fn(&[&[f64]], &mut [f64])>;

fn main() {
    // `cargo test --benches` only checks that the benchmark runs.
    let rounds = if std::env::args().any(|argument| argument == "--bench") { ROUNDS } else { 1 };
    println!(
        "ns per point          batch  by hand, two lanes  by hand, wide sines      one point  by hand, one"
    );
    let written: Vec<Written> = WORKLOADS
        .into_iter()
        .zip(WRITTEN)
        .map(|(workload, (file, function))| Written::new(workload, file, function))
        .collect();
    for written in &written {
        let p = &written.uniforms[1..];
        let ways = match written.workload.name {
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
        compare(written, &ways, rounds);
    }
    println!("\nms of processor time    derive    kernel     batch    operations, per point of a batch");
    for written in &written {
        compile_times(written.workload.name, || written.tape(), &written.varying(), rounds);
    }
    for factors in [12, 25, 50, 100] {
        let build = || {
            let mut graph = Graph::new();
            let outputs = chain(&mut graph, factors / 2);
            graph.schedule(1, &outputs)
        };
        compile_times(&format!("{factors} factors"), build, &[true], rounds);
    }
}

/// Evaluates one tile of points: columns of inputs, and columns of outputs with `TILE` numbers
/// each.
type Way<'w> = dyn FnMut(&[&[f64]], &mut [f64]) + 'w;

fn compare(written: &Written, [lanes, wide, single]: &[ByHandTile; 3], rounds: usize) {
    let (workload, tape) = (&written.workload, written.tape());
    let kernel = compile_batch(&tape, &written.varying()).expect("the workload compiles");
    let one = compile_kernel(&tape).expect("the workload compiles");
    let columns = workload.columns(TILES * TILE);
    let outputs = tape.outputs.len();
    let mut batch = kernel.with(&written.uniforms).expect("the workload's parameters");
    let mut compiled = |columns: &[&[f64]], out: &mut [f64]| {
        let mut views: Vec<&mut [f64]> = out.chunks_mut(TILE).collect();
        batch.evaluate(columns, &mut views).expect("the workload's columns");
    };
    let mut point_by_point = {
        let first = written.uniforms.len();
        let mut inputs = written.uniforms.clone();
        inputs.resize(first + workload.variables.len(), 0.0);
        let mut values = vec![0.0; outputs];
        move |columns: &[&[f64]], out: &mut [f64]| {
            for point in 0..columns[0].len() {
                for (input, column) in inputs[first..].iter_mut().zip(columns) {
                    *input = column[point];
                }
                one.eval(&inputs, &mut values);
                for (position, &value) in values.iter().enumerate() {
                    out[position * TILE + point] = value;
                }
            }
        }
    };
    let mut ways: [(usize, &mut Way); 5] = [
        (SLICE, &mut compiled),
        (SLICE, &mut |c, o| lanes(c, o)),
        (SLICE, &mut |c, o| wide(c, o)),
        (SLICE_OF_ONE, &mut point_by_point),
        (SLICE_OF_ONE, &mut |c, o| single(c, o)),
    ];
    agree(workload, &mut ways, &columns, outputs);

    let mut times = [const { Vec::new() }; 5];
    let mut out = vec![0.0; outputs * TILE];
    for first in (0..rounds).flat_map(|_| (0..TILES).step_by(SLICE)) {
        for ((tiles, way), times) in ways.iter_mut().zip(&mut times) {
            let start = Instant::now();
            for tile in first..first + *tiles {
                let part: Vec<&[f64]> =
                    columns.iter().map(|column| &column[tile * TILE..(tile + 1) * TILE]).collect();
                way(&part, &mut out);
                black_box(&mut out);
            }
            times.push(start.elapsed().as_nanos() as f64 / (*tiles * TILE) as f64);
        }
    }
    let typical = times.each_ref().map(|times| median(times.clone()));
    let ratio = |a: usize, b: usize| median(times[a].iter().zip(&times[b]).map(|(a, b)| a / b).collect());
    println!(
        "{:<16} {:>10.2} {:>10.2} (x {:.2}) {:>11.2} (x {:.2}) {:>14.1} {:>7.1} (x {:.2})",
        workload.name,
        typical[0],
        typical[1],
        ratio(0, 1),
        typical[2],
        ratio(0, 2),
        typical[3],
        typical[4],
        ratio(3, 4),
    );
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// Asserts that all variants return the same numbers, up to rounding.
fn agree(workload: &Workload, ways: &mut [(usize, &mut Way)], columns: &[Vec<f64>], outputs: usize) {
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

/// Evaluates a tile with `N::WIDTH` points at a time.
#[inline(always)]
fn walk<N: Number, W: ByHand<N>>(workload: &W, columns: &[&[f64]], out: &mut [f64]) {
    let points = columns[0].len();
    assert!(points.is_multiple_of(N::WIDTH) && out.len().is_multiple_of(TILE) && points <= TILE);
    let to = out.as_mut_ptr();
    let mut variables = [N::of(0.0); 3];
    let (mut angles, mut sines, mut cosines) = ([N::of(0.0); 25], [N::of(0.0); 25], [N::of(0.0); 25]);
    for point in (0..points).step_by(N::WIDTH) {
        for (variable, column) in variables[..W::VARIABLES].iter_mut().zip(columns) {
            // SAFETY: `point` and the next `N::WIDTH - 1` points are in the column.
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

/// Evaluates a tile with two points at a time, and all sines and cosines of a tile together.
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
                // SAFETY: `start + point` and the next point are in the column.
                *variable = unsafe { Lanes::load(column.as_ptr().add(start + point)) };
            }
            workload.angles(&variables, &mut local);
            for k in 0..W::ANGLES {
                // SAFETY: the buffer holds `ANGLES` numbers for each point.
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
            // SAFETY: lanes have the layout of pairs of numbers, and the buffer holds `ANGLES`
            // pairs for each two points.
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
            // SAFETY: the processor supports AVX, as just detected.
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
            // SAFETY: the processor supports AVX, as just detected.
            return unsafe { walk_wide_avx(&workload, columns, out, memory) };
        }
        walk_wide(&workload, columns, out, memory);
    })
}

/// Returns the CPU time of this thread, s; on systems other than Linux, the elapsed time.
fn processor_time() -> f64 {
    static START: std::sync::OnceLock<Instant> = std::sync::OnceLock::new();
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let run = text.and_then(|text| text.split(' ').next()?.parse::<f64>().ok()).filter(|&run| run > 0.0);
    run.map_or_else(
        || START.get_or_init(Instant::now).elapsed().as_secs_f64(),
        |nanoseconds| nanoseconds * 1e-9,
    )
}

/// Prints the mean times to derive a tape, to compile its kernel for one point, and to compile it
/// for many points.
fn compile_times(name: &str, derive: impl Fn() -> Tape, varying: &[bool], rounds: usize) {
    let (mut sums, mut runs) = ([0.0; 3], 0.0);
    let mut counts = (0, 0);
    let (started, passed) = (processor_time(), Instant::now());
    while runs == 0.0
        || processor_time() - started < 0.1 * rounds as f64 && passed.elapsed().as_secs() < rounds as u64
    {
        let mut times = [processor_time(); 4];
        let tape = derive();
        times[1] = processor_time();
        black_box(compile_kernel(&tape).expect("the bench compiles"));
        times[2] = processor_time();
        black_box(compile_batch(&tape, varying).expect("the bench compiles"));
        times[3] = processor_time();
        for (sum, times) in sums.iter_mut().zip(times.windows(2)) {
            *sum += (times[1] - times[0]) * 1e3;
        }
        runs += 1.0;
        counts = (tape.operations(), BatchTape::new(tape, varying).varying_operations());
    }
    let [derive, one, many] = sums.map(|sum| sum / runs);
    println!("{name:<16} {derive:>10.2} {one:>9.2} {many:>9.2} {:>12} {:>8}", counts.0, counts.1);
}
