//! Three-dimensional meshes: sections swept along the helix have conforming cuts and lie on the
//! contact surfaces of the flanks.

use crate::common::INCH;
use calyx_gears::blank::{GearBlank, Rim};
use calyx_gears::helix::{Hand, Helix};
use calyx_gears::prototype::GearPrototype;
use calyx_gears::rack::Rack;
use calyx_gears::shaper::Shaper;
use calyx_runtime::fe::solid::{Cell, SolidElementPoint};
use calyx_runtime::scene::{Prototype, StructureOptions, Template};
use calyx_runtime::surface::Surface;
use std::f64::consts::PI;
use std::sync::Arc;

/// The chapter 5 pinion with its section along a helix.
fn pinion(helix: f64, hand: Hand) -> Arc<GearPrototype> {
    let rack = Rack::new(0.1 * INCH, 20.0_f64.to_radians(), 0.02 * INCH).expect("a rack");
    GearBlank {
        helix: Helix::new(helix, hand).expect("a helix"),
        ..GearBlank::standard(20, rack)
            .diameters(2.18 * INCH, 1.76 * INCH)
            .face_width(INCH)
            .rim(Rim::new(1.4 * INCH, 1.2 * INCH).expect("a rim"))
    }
    .cut()
    .expect("a gear")
}

/// Internal gear of 60 teeth with its section along a helix.
fn ring(helix: f64, hand: Hand) -> Arc<GearPrototype> {
    let module = 0.1 * INCH;
    let shaper = Shaper::new(25, module, 20.0_f64.to_radians(), 1.25 * module, 0.2 * module);
    GearBlank {
        helix: Helix::new(helix, hand).expect("a helix"),
        face_width: INCH,
        ..GearBlank::standard(60, shaper.expect("a shaper"))
    }
    .cut()
    .expect("a ring")
}

#[test]
fn swept_sections_conform_at_the_cuts_and_lie_on_the_flanks() {
    for (make, helix, hand) in [
        (pinion as fn(f64, Hand) -> Arc<GearPrototype>, 0.0, Hand::Right),
        (pinion, 0.35, Hand::Right),
        (pinion, 0.35, Hand::Left),
        (ring, 0.0, Hand::Right),
        (ring, 0.35, Hand::Left),
    ] {
        let gear = make(helix, hand);
        let options = StructureOptions::default();
        let mesh = gear.solid_mesh(&options).expect("a mesh");
        let nodes = |name: &str| {
            let set = mesh.face_set(name).unwrap_or_else(|| panic!("faces {name}"));
            mesh.nodes_on(set).into_iter().map(|node| mesh.nodes[node]).collect::<Vec<_>>()
        };
        let (left, right) = (nodes("cut_left"), nodes("cut_right"));
        assert_eq!(left.len(), right.len());
        let (sine, cosine) = gear.form().pitch_angle().sin_cos();
        for [x, y, z] in right {
            let image = [cosine * x - sine * y, sine * x + cosine * y, z];
            let nearest = left
                .iter()
                .map(|node| (0..3).map(|k| (node[k] - image[k]).abs()).fold(0.0, f64::max))
                .fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-13 * gear.form().root_radius, "helix {helix}: {nearest}");
        }

        let surfaces = gear.plain_surfaces(&options).expect("surfaces");
        let module = gear.form().module;
        for (index, surface) in surfaces.iter().enumerate() {
            let set = mesh.face_set(&format!("flank_{index}")).expect("faces");
            let [start, end] = set.chart.as_ref().expect("coordinates").s_range();
            let edge = surface.edge_from().expect("a tip edge");
            assert!(start.abs() < 1e-17 && (end - edge).abs() < 1e-17, "{start} {end} {edge}");
            for (part, z) in [(0.1, -0.5), (0.4, -0.31), (0.7, 0.0), (0.9, 0.24), (1.0, 0.5)] {
                let (u, v) = (part * end, z * INCH);
                let found = mesh.surface_point(set, u, v).expect("a point of the flank");
                let exact = surface.at(u, v);
                let off = (0..3).map(|k| (found.position[k] - exact.position[k]).abs()).fold(0.0, f64::max);
                assert!(off < 2e-4 * module, "helix {helix}, {u} {v}: {off}");
                let cosine: f64 = (0..3).map(|k| found.normal[k] * exact.normal[k]).sum();
                assert!(cosine > 0.9999, "helix {helix}, {u} {v}: {cosine}");
            }
        }
    }
}

#[test]
fn elements_along_the_face_and_their_order_are_as_asked() {
    let gear = pinion(0.0, Hand::Right);
    let unknowns = |face_elements, axial_order, template| {
        let options =
            StructureOptions { face_elements, axial_order, template, ..StructureOptions::default() };
        gear.solid_mesh(&options).expect("a mesh").dof_count()
    };
    let medium = unknowns(None, None, Template::Medium);
    assert_eq!(medium, unknowns(Some(4), Some(3), Template::Medium));
    assert_eq!(medium, unknowns(Some(3), Some(4), Template::Medium));
    assert_eq!(medium / 13 * 9, unknowns(Some(2), Some(4), Template::Medium));
    assert!(medium < unknowns(None, None, Template::FineRoot));
    assert!(gear.solid_key(&StructureOptions::default()).is_some());
}

#[test]
fn kept_structures_are_told_apart_by_all_that_they_depend_on_and_by_nothing_else() {
    let options = StructureOptions::default();
    let key = |helix: f64, hand: Hand, options: &StructureOptions| pinion(helix, hand).solid_key(options);
    let plain = key(0.0, Hand::Right, &options);
    // Spur teeth have no hand.
    assert_eq!(plain, key(0.0, Hand::Left, &options));
    let fewer = StructureOptions { face_elements: Some(3), ..options };
    let finer = StructureOptions { template: Template::Finest, ..options };
    for other in [key(0.2, Hand::Right, &options), key(0.2, Hand::Left, &options)]
        .into_iter()
        .chain([fewer, finer].map(|options| key(0.0, Hand::Right, &options)))
    {
        assert_ne!(plain, other);
    }
    let same = StructureOptions { face_elements: Some(4), axial_order: Some(3), ..options };
    assert_eq!(plain, key(0.0, Hand::Right, &same));
}

#[test]
fn a_web_stands_where_it_is_said_and_nothing_stands_beside_it() {
    let module = 0.1 * INCH;
    let rack = Rack::new(module, 20.0_f64.to_radians(), 0.02 * INCH).expect("a rack");
    for (thickness, offset, layers) in [(0.3, 0.0, 5), (0.25, -0.375, 4), (1.0, 0.0, 4)] {
        let rim = Rim::new(3.4 * INCH, 3.0 * INCH).expect("a rim");
        let rim = rim.on_web(thickness * INCH, offset * INCH, 1.0 * INCH).expect("a web");
        let gear = GearBlank::standard(40, rack)
            .diameters(4.18 * INCH, 3.78 * INCH)
            .face_width(INCH)
            .rim(rim)
            .cut()
            .expect("a gear");
        let mesh = gear.solid_mesh(&StructureOptions::default()).expect("a mesh");
        let stations = &mesh.swept.as_ref().expect("a swept mesh").stations;
        assert_eq!(stations.len() - 1, layers, "{stations:?}");
        let section = mesh.swept.as_ref().map_or(0, |swept| swept.section.elements.len());
        let rule = Cell::Hexahedron.quadrature([4, 2]);
        let mut volume = 0.0;
        for element in (0..section * layers).filter(|element| !mesh.absent.contains(element)) {
            let [x, y, _] = mesh.position(SolidElementPoint { element, local: [0.0; 3] });
            if x.hypot(y) < 1.5 * INCH {
                for &(local, weight) in &rule {
                    let [a, b, c] = mesh.jacobian(SolidElementPoint { element, local });
                    let minor = |i: usize, j: usize| b[i] * c[j] - b[j] * c[i];
                    volume += weight * (a[0] * minor(1, 2) - a[1] * minor(0, 2) + a[2] * minor(0, 1));
                }
            }
        }
        let expected = 0.25 * PI * (3.0_f64.powi(2) - 1.0) * thickness * INCH.powi(3) / 40.0;
        assert!((volume / expected - 1.0).abs() < 1e-6, "{thickness}, {offset}: {volume} {expected}");
    }
}
