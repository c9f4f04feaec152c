//! Convergence of the outputs of the chapter 5 pair, from which the factors of the error estimates
//! are derived. It compares statistics over a mesh cycle on coarser and finer meshes and contact
//! grids with the finest of each list, relative to the largest magnitude.
//!
//! `cargo bench -p calyx-gears --bench convergence -- plane` runs one model; `medium` the
//! three-dimensional one.

#[path = "../tests/common/mod.rs"]
mod common;
#[path = "../tests/chapter_5_solid/pair.rs"]
#[allow(dead_code, reason = "tests use more of it")]
mod pair;

use calyx_runtime::analysis::{AnalysisOptions, mesh_cycle, quasi_static};
use calyx_runtime::cache::OperatorCache;
use calyx_runtime::resources::Resources;
use calyx_runtime::scene::{Fidelity, StructureOptions};
use pair::{CHAPTER_5, PLAIN, Pair};
use std::sync::Arc;
use std::time::Instant;

/// Setting: the mesh, and factors of the numbers of cells across and along.
#[derive(Clone, Copy)]
struct Setting {
    name: &'static str,
    structure: StructureOptions,
    grid: [usize; 2],
}

const OUTPUTS: [&str; 6] = ["te", "stiffness", "pressure", "pinion", "wheel", "edge"];

fn main() {
    let asked: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with('-')).collect();
    let wanted = |name: &str| asked.is_empty() || asked.iter().any(|one| one == name);
    let cache = Arc::new(OperatorCache::new(1 << 31));
    let mesh = |name, refinement: f64, order: usize, axial: Option<usize>| Setting {
        name,
        structure: StructureOptions { refinement, order, axial_order: axial, ..StructureOptions::default() },
        grid: [0, 8],
    };
    for (model, pair) in [("plain", PLAIN), ("relieved", Pair { tip_corner_contact: true, ..CHAPTER_5 })] {
        if wanted("plane") {
            let meshes = [
                mesh("0.35", 0.35, 3, None),
                mesh("0.5", 0.5, 3, None),
                mesh("0.7", 0.7, 3, None),
                mesh("1 o2", 1.0, 2, None),
                mesh("1", 1.0, 3, None),
                mesh("1.4", 1.4, 3, None),
                mesh("2", 2.0, 3, None),
                mesh("2.8", 2.8, 3, None),
            ];
            compare(model, &pair, "plane", &meshes, &cache);
            let grid =
                |name, half: usize| Setting { name, structure: StructureOptions::default(), grid: [half, 8] };
            let grids = [
                grid("6", 6),
                grid("12", 12),
                grid("17", 17),
                grid("24", 24),
                grid("48", 48),
                grid("100", 100),
            ];
            compare(model, &pair, "plane", &grids, &cache);
        }
        if wanted("medium") {
            let meshes = [
                mesh("0.5", 0.5, 3, None),
                mesh("0.7", 0.7, 3, None),
                mesh("0.75", 0.75, 3, None),
                mesh("1 o1", 1.0, 1, None),
                mesh("0.75 o2", 0.75, 2, None),
                mesh("1 o2", 1.0, 2, Some(2)),
                mesh("1 o2 a3", 1.0, 2, None),
                mesh("1", 1.0, 3, None),
                mesh("1.5", 1.5, 3, None),
            ];
            compare(model, &pair, "medium", &meshes, &cache);
            let grid = |name, half, slices| Setting {
                name,
                structure: StructureOptions::default(),
                grid: [half, slices],
            };
            let grids = [
                grid("5x4", 5, 4),
                grid("7x6", 7, 6),
                grid("10x8", 10, 8),
                grid("10x16", 10, 16),
                grid("20x8", 20, 8),
                grid("20x16", 20, 16),
            ];
            compare(model, &pair, "medium", &grids, &cache);
        }
    }
}

fn compare(model: &str, pair: &Pair, fidelity: &str, settings: &[Setting], cache: &Arc<OperatorCache>) {
    println!("{model}, {fidelity}");
    let runs: Vec<(Setting, f64, f64, Vec<Vec<f64>>)> = settings
        .iter()
        .map(|setting| {
            let (mut scene, cycle, outputs) = pair.scene();
            for pair in &mut scene.pairs {
                pair.grid.half_cells = Some(setting.grid[0]).filter(|&half| half > 0);
                pair.grid.half_slices = setting.grid[1];
            }
            let resources = Resources { cache: Some(cache.clone()), ..Resources::default() };
            let options = AnalysisOptions {
                fidelity: Fidelity::named(fidelity).expect("a fidelity"),
                structure: setting.structure,
                resources,
                ..AnalysisOptions::default()
            };
            let started = Instant::now();
            let result =
                quasi_static(&scene, &mesh_cycle(&cycle, 16), &outputs, &options, &mut ()).expect("it runs");
            let total = started.elapsed().as_secs_f64();
            let solving = result
                .timing
                .stages
                .iter()
                .find(|(name, _)| *name == "positions")
                .map_or(0.0, |(_, time)| time.as_secs_f64());
            let values = (0..outputs.len())
                .map(|output| result.rows.iter().map(|row| row.outputs[output].value).collect())
                .collect();
            (*setting, total, solving, values)
        })
        .collect();
    let Some((_, _, _, reference)) = runs.last() else { return };
    for (setting, total, solving, values) in &runs {
        print!("{:>6} {:>7.2} s, positions {:>6.2} s", setting.name, total, solving);
        for (output, name) in OUTPUTS.iter().enumerate() {
            let (own, exact) = (&values[output], &reference[output]);
            let max = |values: &[f64]| values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            let min = |values: &[f64]| values.iter().copied().fold(f64::INFINITY, f64::min);
            let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
            let scale = max(exact).max(-min(exact)).max(1e-300);
            let apart = own.iter().zip(exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            print!(
                " | {name} {:+.1e} {:+.1e} {:+.1e} {:.1e}",
                (max(own) - max(exact)) / scale,
                (min(own) - min(exact)) / scale,
                (mean(own) - mean(exact)) / scale,
                apart / scale
            );
        }
        println!();
    }
}
