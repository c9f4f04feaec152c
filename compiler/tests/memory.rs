//! Code memory is freed with its module: ten thousand modules come and go and the process stays as large as it was. Alone in
//! its process, so that nothing else grows meanwhile.
#![cfg(target_os = "linux")]

use calyx::{Engine, Module, check_text};
use std::fs;

const MODEL: &str = "param a = 2; function f(in n) { return if (n < 2) 1 else n*f(n - 1); }
    var x := a*Time/(1 s); var xs = [f(3), 1]; push(xs, x at Time = 2 s); assert(len(xs) == 3);";

/// Resident memory and address space of this process, in bytes.
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

/// What `count` more modules take, after some have come and gone.
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
    // SAFETY: this process has just made the bytes.
    let [resident, reserved] = growth(10_000, || unsafe { Module::deserialize(&engine, &bytes) }.unwrap());
    println!("ten thousand modules loaded: {resident} more bytes resident, {reserved} reserved");
    // A page of code kept from each would be 40 MB, a description a gigabyte.
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
