//! Tests code that is stored as bytes: loading returns the same code, and malformed bytes do not
//! panic. Every test of the evaluators compares its results.

use crate::common::text::check;
use crate::common::*;
use calyx_abi::Purity;
use calyx_codegen::{LoadError, Machine, ModuleCode, TargetCpu, compile_code, load_code};
use calyx_lang::ir::Program;

/// A model with functions that call each other and the engine, constants, and symbolic expressions.
const MODEL: &str = "
    function f(in n) { return if (n < 2) 1 else n * f(n - 1); }
    var xs = [0 mm, 1 mm]; var ys = [\"a\", \"b\"]; push(ys, \"{f(5)} of {xs}\");
    var c = 2; var x := c * sin(Time * (3 rad/s)); var y = x at Time = 3 s;
    function square(in r, in a) := r^2 - a; var root := solve(square, 1, 2 + Time/1 s);
    print(ys, y, root at Time = 1 s); assert(len(ys) == 3);";

fn model() -> Program {
    check(MODEL)
}

fn bytes(code: &ModuleCode) -> Vec<u8> {
    postcard::to_stdvec(code).unwrap()
}

#[test]
fn the_same_program_gives_the_same_code() {
    let program = model();
    let first = bytes(&compile_code(&program, TargetCpu::Native).unwrap());
    assert_eq!(first, bytes(&compile_code(&program, TargetCpu::Native).unwrap()));
    let read: ModuleCode = postcard::from_bytes(&first).unwrap();
    assert_eq!(first, bytes(&read));
}

#[test]
fn the_baseline_asks_for_less() {
    let (baseline, native) =
        (Machine::new(TargetCpu::Baseline).unwrap(), Machine::new(TargetCpu::Native).unwrap());
    assert_eq!(baseline.triple, native.triple);
    assert_eq!(baseline.lacking_on(&native), Vec::<&str>::new());
    let feature = "has_something_new";
    let newer = Machine { features: vec![feature.into()], ..native.clone() };
    assert_eq!(newer.lacking_on(&native), [feature]);
}

#[test]
fn code_calls_only_what_the_engine_has() {
    let program = with_externs(evaluates(vec![], vec![], call_extern(0, vec![number(2.0), number(4.0)], N)));
    let code = compile_code(&program, TargetCpu::Native).unwrap();
    // SAFETY: the same compiler just produced the code.
    let refused = unsafe { load_code(&code, calyx_abi::standard::EXTERNS) };
    let Err(LoadError::Unknown(symbol)) = refused else { panic!("it calls what is not there") };
    assert_eq!(symbol, EXTERNS[0].symbol);
    assert!(matches!(EXTERNS[0].purity, Purity::Pure));
}

/// The SplitMix64 generator.
struct Random(u64);

impl Random {
    fn below(&mut self, limit: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) % limit as u64) as usize
    }
}

/// Number of malformed files with each outcome of loading, and largest number of files until then.
const OF_EACH: usize = 1000;
const MOST_FILES: usize = 60_000;

/// The loaded code is never run.
#[test]
fn no_bytes_make_loading_panic() {
    let whole = bytes(&compile_code(&model(), TargetCpu::Native).unwrap());
    let externs = externs();
    let mut random = Random(1);
    let (mut unreadable, mut refused, mut loaded) = (0, 0, 0);
    for _ in 0..MOST_FILES {
        if unreadable >= OF_EACH && refused >= OF_EACH && loaded >= OF_EACH {
            break;
        }
        let mut bytes = whole.clone();
        for _ in 0..=random.below(3) {
            let at = random.below(bytes.len());
            match random.below(8) {
                0 => bytes.truncate(at + 1),
                1 => drop(bytes.remove(at)),
                2 => bytes.insert(at, 0xff),
                3 => bytes.splice(at..at, [0xff; 9]).for_each(drop),
                _ => bytes[at] = random.below(256) as u8,
            }
            if bytes.is_empty() {
                break;
            }
        }
        let Ok(code) = postcard::from_bytes::<ModuleCode>(&bytes) else {
            unreadable += 1;
            continue;
        };
        // SAFETY: loading is sound for any code; the code is not run.
        match unsafe { load_code(&code, &externs) } {
            Ok(_) => loaded += 1,
            Err(_) => refused += 1,
        }
    }
    let fewest = unreadable.min(refused).min(loaded);
    assert_eq!(fewest, OF_EACH, "{unreadable} unreadable, {refused} refused, {loaded} loaded");
}
