//! Checks that code memory is freed with its module: the process does not grow over ten thousand
//! modules. The test has its own process, so that no other allocation disturbs the measurement.
#![cfg(target_os = "linux")]

use calyx::{Engine, Module, check_text};
use std::fs;

const MODEL: &str = "param a = 2; function f(in n) { return if (n < 2) 1 else n*f(n - 1); }
    var x := a*Time/(1 s); var xs = [f(3), 1]; push(xs, x at Time = 2 s); assert(len(xs) == 3);";

/// Returns resident memory and address space of this process, bytes.
fn memory() -> [usize; 2] {
    let status = fs::read_to_string("/proc/self/status").unwrap();
    ["VmRSS:", "VmSize:"].map(|name| {
        let line = status.lines().find_map(|line| line.strip_prefix(name)).unwrap();
        line.split_whitespace().next().unwrap().parse::<usize>().unwrap() << 10
    })
}

fn run(module: &Module) {
    module.instantiate().solve().unwrap();
}

/// Returns the memory growth over `count` modules, after some warm-up.
fn growth(count: usize, mut module: impl FnMut() -> Module) -> [usize; 2] {
    let mut come_and_go = |count| (0..count).for_each(|_| run(&module()));
    come_and_go(100);
    let before = memory();
    come_and_go(count);
    let after = memory();
    [0, 1].map(|i| after[i].saturating_sub(before[i]))
}

#[test]
fn modules_come_and_go() {
    let engine = Engine::default();
    let check = || check_text("model.cx", MODEL);
    let bytes = Module::from_checked(&engine, check()).unwrap().serialize().unwrap();
    // SAFETY: this process has just written the bytes.
    let [resident, reserved] = growth(10_000, || unsafe { Module::deserialize(&engine, &bytes) }.unwrap());
    println!("ten thousand modules loaded: {resident} more bytes resident, {reserved} reserved");
    // A leak of one page of code per module would be 40 MB, of a description a gigabyte.
    assert!(
        resident < 8 << 20 && reserved < 512 << 20,
        "loading: {resident} more bytes, {reserved} reserved"
    );
    let [resident, reserved] = growth(500, || Module::from_checked(&engine, check()).unwrap());
    println!("five hundred modules compiled: {resident} more bytes resident, {reserved} reserved");
    assert!(
        resident < 8 << 20 && reserved < 512 << 20,
        "compiling: {resident} more bytes, {reserved} reserved"
    );
}
