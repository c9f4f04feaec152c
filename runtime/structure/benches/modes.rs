//! Component modes of a ring by one of its sectors against those of the whole ring in one mesh, and
//! the cost of a mode. Times are printed relative to the condensation of the same sector, which
//! statics needs anyway, because ratios are comparable between machines.

use calyx_fe::material::{Material, Plane};
use calyx_fe::{Block, Curve, ElementOrder, MeshBuilder, PlaneModel, Side, uniform};
use calyx_numerics::interrupt::Interrupt;
use calyx_structure::{BodyModes, BoreSupport, ElasticStructure, MeshSupport, RingSource, SplitOptions};
use std::f64::consts::{PI, TAU};
use std::hint::black_box;
use std::time::Instant;

/// Across the ring and along a sector: with cubic elements as many unknowns as a gear's sector has.
const ELEMENTS: [usize; 2] = [10, 10];

fn main() {
    println!(
        "{:>8} {:>9} {:>6} {:>11} {:>13} {:>14} {:>22}",
        "sectors",
        "unknowns",
        "modes",
        "cyclic, ms",
        "whole/cyclic",
        "cyclic/condense",
        "mode/condense (cyclic)"
    );
    for (sectors, highest) in [(12, 20e3), (24, 20e3), (48, 20e3), (48, 40e3)] {
        let (sector, whole) = (ring(sectors, false), ring(sectors, true));
        let source = RingSource {
            sectors,
            cuts: ["first", "last"],
            bore: "bore",
            support: BoreSupport::Rigid,
            coupled: 3,
        };
        let (options, never) = (SplitOptions::default(), Interrupt::never());
        let cyclic =
            || BodyModes::ring(&sector, &source, &[], &options, highest, &never).map(|modes| modes.count());
        let single = || {
            BodyModes::single(&whole, MeshSupport::Chain("bore"), &[], &options, highest, &never)
                .map(|modes| modes.count())
        };
        let modes = cyclic().expect("modes");
        assert_eq!(modes, single().expect("modes"), "both find all");
        let condense = fastest(3, || ElasticStructure::ring(&sector, &source, &[], &options, &never).is_ok());
        let by_sector = fastest(3, || cyclic().is_ok());
        let in_one = fastest(1, || single().is_ok());
        println!(
            "{sectors:>8} {:>9} {modes:>6} {:>11.1} {:>13.1} {:>14.1} {:>22.3}",
            sector.dof_count(),
            1e3 * by_sector,
            in_one / by_sector,
            by_sector / condense,
            by_sector / modes as f64 / condense
        );
    }
}

/// Seconds of the fastest of some runs: the one least disturbed.
fn fastest(runs: usize, run: impl Fn() -> bool) -> f64 {
    (0..runs)
        .map(|_| {
            let start = Instant::now();
            assert!(black_box(run()), "it has modes");
            start.elapsed().as_secs_f64()
        })
        .fold(f64::INFINITY, f64::min)
}

/// A steel ring of 0.5 to 1 m, clamped inside: one of its sectors, or all of it.
fn ring(sectors: u32, whole: bool) -> PlaneModel {
    let mut builder = MeshBuilder::new();
    for sector in 0..if whole { sectors } else { 1 } {
        let middle = TAU * f64::from(sector) / f64::from(sectors);
        let half = PI / f64::from(sectors);
        let (from, to) = (middle + half, middle - half);
        let ray =
            |angle: f64| Curve::line([0.5 * angle.cos(), 0.5 * angle.sin()], [angle.cos(), angle.sin()]);
        let sides = Block::new(
            Curve::arc([0.0; 2], 0.5, from, to),
            ray(to),
            Curve::arc([0.0; 2], 1.0, from, to),
            ray(from),
        );
        let mut block = sides.divided(uniform(ELEMENTS[1]), uniform(ELEMENTS[0])).named(Side::Bottom, "bore");
        if !whole {
            block = block.named(Side::Left, "last").named(Side::Right, "first");
        }
        builder.block(block);
    }
    let mesh = builder.finish(ElementOrder::full(3)).expect("a mesh");
    PlaneModel::new(mesh, Material::STEEL, Plane::Strain)
}
