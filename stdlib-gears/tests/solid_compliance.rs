//! With Poisson's ratio 0 a load that is uniform along the face of a spur gear causes no transverse
//! stress: tooth compliance and root stress in three dimensions equal those of the plane model,
//! including the ends of the face.

use crate::common::INCH;
use calyx_gears::blank::{GearBlank, Rim};
use calyx_gears::prototype::GearPrototype;
use calyx_gears::rack::Rack;
use calyx_runtime::fe::quadrature::gauss_legendre;
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::material::Material;
use calyx_runtime::scene::{Prototype, StructureOptions};
use calyx_runtime::structure::solid::{SegmentLoad, SolidStructure, SurfaceSegment};
use calyx_runtime::structure::{Chart, Structure, SurfaceLoad};
use std::f64::consts::PI;
use std::sync::Arc;

const WIDTH: f64 = INCH;

/// The chapter 5 pinion with Poisson's ratio 0.
fn pinion() -> Arc<GearPrototype> {
    let rack = Rack::new(0.1 * INCH, 20.0_f64.to_radians(), 0.02 * INCH).expect("a rack");
    GearBlank::standard(20, rack)
        .diameters(2.18 * INCH, 1.76 * INCH)
        .face_width(WIDTH)
        .rim(Rim::new(1.4 * INCH, 1.2 * INCH).expect("a rim"))
        .material(Material { poissons_ratio: 0.0, ..Material::STEEL })
        .cut()
        .expect("a gear")
}

/// Displacement at a line along the face by a unit line load along another one, m/(N/m).
fn in_the_plane(structure: &dyn Structure, observe: (Chart, f64), load: (Chart, f64)) -> f64 {
    let mut value = [0.0];
    structure.add_compliance(observe.0, &[observe.1], load.0, &[load.1], &mut value);
    if observe.0 == load.0 {
        let apart = (observe.1 - load.1).abs() / structure.reference_length();
        value[0] -= 2.0 / (PI * structure.surface_modulus()) * apart.ln();
    }
    value[0]
}

/// Its mean over the face in three dimensions, with the half-space's part and its image loads at
/// both side faces in closed form.
fn three_dimensional(structure: &dyn SolidStructure, observe: (Chart, f64), load: (Chart, f64)) -> f64 {
    let rule = gauss_legendre(16);
    let along =
        |u: f64| rule.iter().map(|(x, _)| SurfaceSegment::from([u, 0.5 * WIDTH * x])).collect::<Vec<_>>();
    let (rows, columns) = (along(observe.1), along(load.1));
    let mut block = vec![0.0; rows.len() * columns.len()];
    structure.add_compliance(observe.0, &rows, load.0, &columns, &mut block);
    let mut mean = 0.0;
    for (row, values) in block.chunks_exact(columns.len()).enumerate() {
        for (column, value) in values.iter().enumerate() {
            mean += 0.25 * WIDTH * rule[row].1 * rule[column].1 * value;
        }
    }
    if observe.0 == load.0 {
        let surface = structure.surface(load.0.surface);
        let [p, q] = [observe.1, load.1].map(|u| surface.at(u, 0.0).position);
        let s = (p[0] - q[0]).hypot(p[1] - q[1]);
        let (root, asinh) = (|t: f64| s.hypot(t), |t: f64| (t / s).asinh());
        let own = 2.0 * (WIDTH * asinh(WIDTH) - root(WIDTH) + s);
        let image = root(WIDTH) - s + 2.0 * WIDTH * (asinh(2.0 * WIDTH) - asinh(WIDTH))
            - (root(2.0 * WIDTH) - root(WIDTH));
        mean += (own + 2.0 * image) / (PI * structure.surface_modulus() * WIDTH);
    }
    mean
}

#[test]
fn line_loads_meet_the_plane() {
    let gear = pinion();
    let options = StructureOptions::default();
    let flat = gear.build(&options, &Interrupt::never()).expect("a structure in the plane");
    let solid = gear.build_solid(&options, &Interrupt::never()).expect("a solid structure");
    let length = flat.profile(0).edge_from().expect("a gear has a tip edge");
    let chart = |surface| Chart { tooth: 3, surface };
    // The last position is beyond the range that the elements at the tip permit for a sample.
    let places = [0.15, 0.3, 0.32, 0.5, 0.7, 0.72, 0.85, 0.93];
    for observed in places {
        for loaded in places {
            let tolerance = if f64::max(observed, loaded) > 0.9 { 1e-2 } else { 1e-3 };
            let [observe, load] = [observed, loaded].map(|share| (chart(0), share * length));
            for load in [load, (chart(1), load.1)] {
                // The displacement of a line load at itself is unbounded.
                if observe == load {
                    continue;
                }
                let plane = in_the_plane(&*flat, observe, load);
                let error = three_dimensional(&*solid, observe, load) / plane - 1.0;
                assert!(
                    error.abs() < tolerance,
                    "{observed} by {loaded} of surface {}: {error:.1e}",
                    load.0.surface
                );
            }
        }
    }

    // Root stress is uniform along the face and equals that of the plane model, except for mesh
    // errors.
    for share in [0.4, 0.7, 0.9] {
        let s = share * length;
        let load = SurfaceLoad { chart: chart(0), s, force: 1.0 / WIDTH };
        let flat = flat.stresses(3, 0, &[load]).iter().map(|(_, stress)| *stress).fold(0.0, f64::max);
        let rule = gauss_legendre(16);
        let point = |&(x, weight): &(f64, f64)| SegmentLoad {
            chart: chart(0),
            segment: [s, 0.5 * WIDTH * x].into(),
            force: 0.5 * weight,
        };
        let stresses = solid.stresses(3, 0, &rule.iter().map(point).collect::<Vec<_>>());
        let largest = [-0.5, 0.0, 0.5].map(|end| {
            let there = stresses.iter().filter(|stress| (stress.position[2] - end * WIDTH).abs() < 1e-9);
            there.map(|stress| stress.principal()[0]).fold(0.0, f64::max)
        });
        for there in largest {
            assert!((there / largest[1] - 1.0).abs() < 1e-4, "{share}: {largest:?}");
            assert!((there / flat - 1.0).abs() < 3e-2, "{share}: {largest:?} against {flat}");
        }
    }
}
