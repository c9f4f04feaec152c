//! Tests that the size of the typed program, and the memory that a check allocates on the way, grow
//! linearly with the length of generated models. `cargo bench -p calyx` measures the time.

#[path = "support/generator.rs"]
mod generator;
#[allow(dead_code)]
#[path = "support/library.rs"]
mod library;

use calyx_lang::check_program;
use calyx_lang::ir::Program;
use library::Library;
use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// The system's allocator, which counts the allocations of all threads and their bytes.
struct Counting;

static ALLOCATIONS: AtomicU64 = AtomicU64::new(0);
static ALLOCATED: AtomicU64 = AtomicU64::new(0);

// SAFETY: every call is passed on to the system's allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.fetch_add(1, Relaxed);
        ALLOCATED.fetch_add(layout.size() as u64, Relaxed);
        // SAFETY: the caller's obligations are those of the system's allocator.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        // SAFETY: as above.
        unsafe { System.dealloc(block, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Prevents other tests of this file from allocating memory while one of them counts.
fn alone() -> MutexGuard<'static, ()> {
    static ONE: Mutex<()> = Mutex::new(());
    ONE.lock().unwrap_or_else(PoisonError::into_inner)
}

fn program(text: &str) -> Program {
    let checked = check_program("model.cx", text, &Library::read());
    let found: Vec<_> = checked.diagnostics.iter().map(|d| format!("{} {}", d.code, d.message)).collect();
    assert_eq!(found, Vec::<String>::new());
    checked.program.expect("a program")
}

/// Returns the numbers of functions, sites, blocks and statements.
fn sizes(program: &Program) -> [usize; 4] {
    let blocks = || program.functions.iter().flat_map(|function| &function.blocks);
    let statements = blocks().map(|block| block.statements.len()).sum();
    [program.functions.len(), program.sites.len(), blocks().count(), statements]
}

#[test]
fn a_longer_model_gives_a_program_in_proportion() {
    let _alone = alone();
    let [one, two, three] = [1, 2, 3].map(|sections| sizes(&program(&generator::model(20 + 48 * sections))));
    for at in 0..one.len() {
        assert!(two[at] > one[at], "each section adds something");
        assert_eq!(three[at] - two[at], two[at] - one[at], "each section adds the same");
    }
    // Per section: five called functions; one of them is instantiated for numbers only, because
    // types share representations.
    assert_eq!(two[0] - one[0], 5);
}

#[test]
fn chains_are_in_proportion_to_their_factors() {
    let _alone = alone();
    let [one, two, three] = [10, 20, 30].map(|factors| {
        let program = program(&generator::chain(factors));
        program.sites.iter().map(|site| site.shared.len()).sum::<usize>()
    });
    assert_eq!(three - two, two - one);
}

/// A quarter of the time of a check is spent on allocations. Their number is the same on all
/// machines.
#[test]
fn a_line_of_a_component_takes_few_allocations() {
    let _alone = alone();
    let library = Library::read();
    let [twenty, forty] = [20, 40].map(|count| {
        let text = generator::components(count);
        let before = ALLOCATIONS.load(Relaxed);
        assert!(check_program("model.cx", &text, &library).program.is_some());
        (text.lines().count() as u64, ALLOCATIONS.load(Relaxed) - before)
    });
    let per_line = (forty.1 - twenty.1) / (forty.0 - twenty.0);
    println!("{per_line} allocations per line");
    assert!(per_line < 75, "{per_line} allocations per line");
}

/// A quadratic algorithm that copies or collects anything allocates a quadratic amount of memory.
#[test]
fn the_memory_of_a_check_is_in_proportion_to_the_number_of_names() {
    type Line = fn(usize) -> String;
    let models: [(&str, Line); 6] = [
        ("variables", |n| format!("var x{n} = 1;")),
        ("equal variables", |_| "{ var x = 1; print(x); }".into()),
        ("chain of variables", |n| match n {
            0 => "var x0 = 1;".into(),
            n => format!("var x{n} = x{} + 1;", n - 1),
        }),
        ("functions", |n| format!("function f{n}(in a) {{ return a + {n}; }}")),
        ("chain of functions", |n| match n {
            0 => "function f0(in a) { return a + 1; }".into(),
            n => format!("function f{n}(in a) {{ return f{}(a) + {n}; }}", n - 1),
        }),
        ("unknown names", |n| format!("var x{n} = y{n};")),
    ];
    let _alone = alone();
    let library = Library::read();
    for (name, line) in models {
        let allocated = [1000, 2000, 4000].map(|lines| {
            let text: String = (0..lines).map(|n| line(n) + "\n").collect();
            let before = ALLOCATED.load(Relaxed);
            let checked = check_program("model.cx", &text, &library);
            assert_eq!(checked.program.is_some(), name != "unknown names", "{name}");
            ALLOCATED.load(Relaxed) - before
        });
        let [first, second] = [1, 2].map(|end| allocated[end] - allocated[end - 1]);
        println!("{name}: {} and {} bytes per line", first / 1000, second / 2000);
        assert!(second < 5 * first / 2, "{name}: {allocated:?} bytes for 1000, 2000 and 4000 lines");
    }
}
