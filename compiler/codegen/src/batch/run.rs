//! A batch kernel in memory, and its loop over tiles of points.

use super::{PAIR, Plan};
use crate::jit::Code;
use calyx_abi::call::KernelFn;
use calyx_abi::math::sincos_columns;
use calyx_symbolic::batch::{BatchTape, Source};
use cranelift_module::FuncId;
use std::fmt;
use std::sync::Arc;

/// A function that executes some operations of a stage for all pairs of a tile. Arguments: uniform
/// values (each stored twice), start addresses of the input columns and of the output columns, the
/// tile, and the number of pairs (at least one).
pub type ChunkFn = unsafe extern "C" fn(*const f64, *const *const f64, *const *mut f64, *mut f64, usize);

/// The reason why a batch was not evaluated. In this case no output was written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum BatchError {
    /// The number of uniform values, columns or outputs differs from that of the kernel.
    Count { what: &'static str, given: usize, expected: usize },
    /// The length of a column differs from that of the first column.
    Length { what: &'static str, column: usize, given: usize, expected: usize },
}

impl fmt::Display for BatchError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            BatchError::Count { what, given, expected } => {
                write!(f, "{given} {what} given, the kernel has {expected}")
            }
            BatchError::Length { what, column, given, expected } => {
                write!(f, "column {column} of the {what} has {given} points, the first one has {expected}")
            }
        }
    }
}

impl std::error::Error for BatchError {}

/// A kernel for many points, with columns of inputs and outputs.
///
/// Evaluation does not change its state, so several threads can evaluate parts of the points
/// concurrently.
pub struct BatchKernel {
    /// Keeps the functions alive.
    #[expect(dead_code, reason = "held for its lifetime only")]
    code: Arc<Code>,
    uniform: KernelFn,
    uniform_outputs: usize,
    varying: Vec<bool>,
    /// For each stage its functions and the angles whose sines and cosines are needed: offset,
    /// block size and number per pair.
    stages: Vec<(Vec<ChunkFn>, Option<super::Angles>)>,
    /// For each uniform output, its index among the uniform values.
    outputs: Vec<Option<usize>>,
    pairs: usize,
    tile_bytes: usize,
}

/// A cache line of aligned memory.
#[repr(C, align(64))]
#[derive(Clone, Copy)]
struct Line([f64; 8]);

/// Allocates at least `bytes` bytes.
fn lines(bytes: usize) -> Vec<Line> {
    vec![Line([0.0; 8]); bytes.div_ceil(size_of::<Line>()).max(1)]
}

impl BatchKernel {
    pub(super) fn new(
        batch: &BatchTape,
        plan: &Plan,
        code: Arc<Code>,
        uniform: FuncId,
        functions: &[FuncId],
    ) -> Self {
        // SAFETY: `kernel::lower` defines this function with this signature; `code` keeps it alive.
        let uniform = unsafe { std::mem::transmute::<*const u8, KernelFn>(code.address(uniform)) };
        let mut stages: Vec<_> =
            (0..batch.stages.len()).map(|stage| (Vec::new(), plan.angles.get(stage).copied())).collect();
        for (chunk, &function) in plan.chunks.iter().zip(functions) {
            // SAFETY: `define_chunk` defines the function with this signature.
            let function = unsafe { std::mem::transmute::<*const u8, ChunkFn>(code.address(function)) };
            stages[chunk.stage].0.push(function);
        }
        let place = |&output: &u32| match batch.sources[output as usize] {
            Source::Uniform(slot) => Some(slot as usize),
            _ => None,
        };
        BatchKernel {
            code,
            uniform,
            uniform_outputs: batch.uniform.outputs.len(),
            varying: batch.varying.clone(),
            stages,
            outputs: batch.tape.outputs.iter().map(place).collect(),
            pairs: plan.pairs,
            tile_bytes: plan.size,
        }
    }

    /// Returns the number of uniform inputs.
    pub fn uniforms(&self) -> usize {
        self.varying.len() - self.columns()
    }

    /// Returns the number of varying inputs.
    pub fn columns(&self) -> usize {
        self.varying.iter().filter(|&&varies| varies).count()
    }

    /// Returns the number of outputs.
    pub fn outputs(&self) -> usize {
        self.outputs.len()
    }

    /// Evaluates the kernel at every point. `uniforms` and `columns` contain the uniform and the
    /// varying inputs, each in order. All input and output columns have the same length.
    ///
    /// # Errors
    /// Counts or lengths do not match; no output is written.
    pub fn evaluate(
        &self,
        uniforms: &[f64],
        columns: &[&[f64]],
        outputs: &mut [&mut [f64]],
    ) -> Result<(), BatchError> {
        self.with(uniforms)?.evaluate(columns, outputs)
    }

    /// Computes the uniform values, for any number of evaluations.
    ///
    /// # Errors
    /// The number of uniform inputs does not match.
    pub fn with(&self, uniforms: &[f64]) -> Result<Batch<'_>, BatchError> {
        count("uniform values", uniforms.len(), self.uniforms())?;
        Ok(Batch { kernel: self, table: self.table(uniforms), tile: lines(self.tile_bytes) })
    }

    /// Returns the uniform values, each stored twice, so that they can be loaded as pairs.
    fn table(&self, uniforms: &[f64]) -> Vec<Line> {
        let mut given = uniforms.iter().copied();
        let inputs: Vec<f64> = self
            .varying
            .iter()
            .map(|&varies| if varies { f64::NAN } else { given.next().unwrap_or(f64::NAN) })
            .collect();
        let mut values = vec![0.0; self.uniform_outputs];
        // SAFETY: the function reads one value per input and writes `uniform_outputs` values.
        unsafe { (self.uniform)(inputs.as_ptr(), values.as_mut_ptr()) };
        let mut table = lines(values.len() * PAIR);
        for (place, value) in values.into_iter().enumerate() {
            for lane in [2 * place, 2 * place + 1] {
                table[lane / 8].0[lane % 8] = value;
            }
        }
        table
    }
}

/// A kernel with computed uniform values.
pub struct Batch<'k> {
    kernel: &'k BatchKernel,
    /// The uniform values, each stored twice.
    table: Vec<Line>,
    /// Memory for the intermediate values of a tile.
    tile: Vec<Line>,
}

impl Batch<'_> {
    /// Evaluates the kernel at every point. All input and output columns have the same length.
    ///
    /// # Errors
    /// Counts or lengths do not match; no output is written.
    pub fn evaluate(&mut self, columns: &[&[f64]], outputs: &mut [&mut [f64]]) -> Result<(), BatchError> {
        let points = self.check(columns, outputs)?;
        if points == 0 {
            return Ok(());
        }
        let kernel = self.kernel;
        for (output, place) in outputs.iter_mut().zip(&kernel.outputs) {
            if let Some(place) = place {
                output.fill(value(&self.table, 2 * place));
            }
        }
        let mut inputs: Vec<*const f64> = columns.iter().map(|column| column.as_ptr()).collect();
        let mut results: Vec<*mut f64> = outputs.iter_mut().map(|column| column.as_mut_ptr()).collect();
        let mut left = points / 2;
        while left > 0 {
            let pairs = left.min(kernel.pairs);
            // SAFETY: every column has at least `2 * pairs` remaining points.
            unsafe {
                self.run(&inputs, &results, pairs);
                inputs.iter_mut().for_each(|column| *column = column.add(2 * pairs));
                results.iter_mut().for_each(|column| *column = column.add(2 * pairs));
            }
            left -= pairs;
        }
        if points % 2 == 1 {
            // An odd last point is duplicated to a pair: the same functions produce the same bits.
            let last: Vec<[f64; 2]> =
                columns.iter().filter_map(|column| column.last()).map(|&value| [value; 2]).collect();
            let mut found = vec![[0.0; 2]; outputs.len()];
            let inputs: Vec<*const f64> = last.iter().map(|pair| pair.as_ptr()).collect();
            let results: Vec<*mut f64> = found.iter_mut().map(|pair| pair.as_mut_ptr()).collect();
            // SAFETY: every column holds one pair.
            unsafe { self.run(&inputs, &results, 1) };
            for ((output, place), found) in outputs.iter_mut().zip(&kernel.outputs).zip(&found) {
                if let (None, Some(last)) = (place, output.last_mut()) {
                    *last = found[0];
                }
            }
        }
        Ok(())
    }

    /// Returns the number of points if all counts and lengths match.
    fn check(&self, columns: &[&[f64]], outputs: &[&mut [f64]]) -> Result<usize, BatchError> {
        count("columns of inputs", columns.len(), self.kernel.columns())?;
        count("columns of outputs", outputs.len(), self.kernel.outputs())?;
        let inputs = columns.iter().map(|column| column.len()).enumerate();
        let results = outputs.iter().map(|column| column.len()).enumerate();
        let mut all = inputs.map(|c| ("inputs", c)).chain(results.map(|c| ("outputs", c)));
        let Some((_, (_, expected))) = all.next() else { return Ok(0) };
        match all.find(|&(_, (_, given))| given != expected) {
            Some((what, (column, given))) => Err(BatchError::Length { what, column, given, expected }),
            None => Ok(expected),
        }
    }

    /// Evaluates the first points of the columns.
    ///
    /// # Safety
    /// `pairs` is between 1 and `kernel.pairs`. The numbers of columns match those of the kernel,
    /// and each column holds `2 * pairs` points.
    unsafe fn run(&mut self, columns: &[*const f64], outputs: &[*mut f64], pairs: usize) {
        let table = self.table.as_ptr().cast::<f64>();
        let base = self.tile.as_mut_ptr().cast::<f64>();
        for (functions, angles) in &self.kernel.stages {
            for function in functions {
                // SAFETY: the code is alive. It accesses only the table, the tile and `2 * pairs`
                // points of the columns, which the caller guarantees.
                unsafe { function(table, columns.as_ptr(), outputs.as_ptr(), base, pairs) };
            }
            if let Some(angles) = angles {
                let block = angles.size / size_of::<f64>();
                let count = 2 * pairs * angles.count;
                let start = angles.offset / size_of::<f64>();
                // SAFETY: the tile contains three consecutive blocks of this size, each with space
                // for `count` numbers.
                let [angles, sines, cosines] = unsafe {
                    [0, 1, 2]
                        .map(|which| std::slice::from_raw_parts_mut(base.add(start + which * block), count))
                };
                sincos_columns(angles, sines, cosines);
            }
        }
    }
}

fn count(what: &'static str, given: usize, expected: usize) -> Result<(), BatchError> {
    if given == expected { Ok(()) } else { Err(BatchError::Count { what, given, expected }) }
}

fn value(table: &[Line], index: usize) -> f64 {
    table.get(index / 8).map_or(f64::NAN, |line| line.0[index % 8])
}
