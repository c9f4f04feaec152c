//! Accuracy of the three-dimensional mesh templates: root stress of the chapter 5 pair at the
//! highest point of single-tooth contact, on each template and its uniform refinements, compared
//! with the limit of the refinements. The documentation of the templates states these errors.
//!
//! `cargo bench -p calyx-gears --bench templates -- medium fineroot` runs some of them.

#[path = "../tests/common/mod.rs"]
mod common;
#[path = "../tests/chapter_5_solid/pair.rs"]
#[allow(dead_code, reason = "tests use more of it")]
mod pair;

use calyx_runtime::scene::StructureOptions;
use pair::{AT_HIGHEST, CHAPTER_5, PLAIN};
use std::time::Instant;

fn main() {
    let asked: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with('-')).collect();
    println!(
        "{:>10} {:>22} {:>12} {:>12} {:>12} {:>8}",
        "template", "pair", "refinement", "pinion, psi", "gear, psi", "s"
    );
    for (template, refinements) in
        [("medium", [1.0, 1.5, 2.0]), ("fineroot", [1.0, 1.25, 1.5]), ("finest", [1.0, 1.25, 1.5])]
    {
        if !(asked.is_empty() || asked.iter().any(|name| name == template)) {
            continue;
        }
        for (name, pair) in [("no modification", PLAIN), ("relief and crown", CHAPTER_5)] {
            let stresses = refinements.map(|refinement| {
                let options = StructureOptions { refinement, ..StructureOptions::default() };
                let started = Instant::now();
                let [pinion, gear] = pair.solve(template, options, &[AT_HIGHEST])[0].root_stress;
                let seconds = started.elapsed().as_secs_f64();
                println!(
                    "{template:>10} {name:>22} {refinement:>12} {pinion:>12.0} {gear:>12.0} {seconds:>8.1}"
                );
                [pinion, gear]
            });
            let limits = [0, 1].map(|member| limit(refinements, stresses.map(|both| both[member])));
            let errors = [0, 1].map(|member| 100.0 * (stresses[0][member] / limits[member] - 1.0));
            println!("{template:>10} {name:>22} {:>12} {:>12.0} {:>12.0}", "limit", limits[0], limits[1]);
            println!(
                "{template:>10} {name:>22} {:>12} {:>+11.2}% {:>+11.2}%",
                "off by", errors[0], errors[1]
            );
        }
    }
}

/// Limit of values under mesh refinement, from their observed order of convergence; the last value
/// if they do not converge. Richardson extrapolation through three meshes, with orders from 1 to 8.
fn limit(refinements: [f64; 3], values: [f64; 3]) -> f64 {
    let [a, b, c] = values;
    let size = refinements.map(|refinement| 1.0 / refinement);
    let part = |order: f64| {
        let [first, second, third] = size.map(|size| size.powf(order));
        (first - second) / (second - third)
    };
    let seen = (a - b) / (b - c);
    // The ratio of the differences grows with the order.
    let [mut low, mut high] = [1.0, 8.0];
    if seen.is_nan() || seen < part(low) {
        return c;
    }
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        if part(middle) < seen { low = middle } else { high = middle }
    }
    let [_, second, third] = size.map(|size| size.powf(low));
    c + (c - b) * third / (second - third)
}
