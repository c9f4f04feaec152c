//! Tests of gears with tabulated teeth.

use super::*;
use crate::tabulated::test_teeth::{Conical, aerospace, cylindrical, sampled};
use calyx_runtime::structure::Chart;
use calyx_runtime::structure::solid::{SegmentLoad, SurfaceSegment};

fn data(table: ToothTable) -> TabulatedGearData {
    TabulatedGearData {
        table,
        tip_edge_radius: None,
        material: Material::STEEL,
        bore: BoreShape::Rim { thickness: None, angle: None },
        support: BoreSupport::Rigid,
        pitch_errors: Vec::new(),
    }
}

/// Compliances of a few places of a flank with each other, and the largest stress in a fillet
/// under a load on them.
fn response(body: &dyn SolidStructure, places: &[[f64; 2]]) -> (Vec<f64>, f64) {
    let chart = Chart { tooth: 0, surface: 0 };
    let segments: Vec<SurfaceSegment> =
        places.iter().map(|&place| SurfaceSegment { place, length: 1e-3 }).collect();
    let mut block = vec![0.0; places.len() * places.len()];
    body.add_compliance(chart, &segments, chart, &segments, &mut block);
    let loads: Vec<SegmentLoad> =
        segments.iter().map(|&segment| SegmentLoad { chart, segment, force: 1000.0 }).collect();
    let stresses = body.stresses(0, 0, &loads);
    let largest = stresses.iter().map(|stress| stress.principal()[0]).fold(0.0, f64::max);
    (block, largest)
}

#[test]
fn a_sampled_cylindrical_gear_has_its_compliance_and_root_stress() {
    let options =
        StructureOptions { face_elements: Some(2), axial_order: Some(2), ..StructureOptions::default() };
    for helix in [0.0, 20.0] {
        let gear = cylindrical(helix);
        let form = gear.form();
        let thickness = Some(form.root_radius - gear.rim.fixed_radius);
        let sampled = TabulatedGear::new(TabulatedGearData {
            tip_edge_radius: Some(form.tip_edge_radius),
            material: gear.material,
            bore: BoreShape::Rim { thickness, angle: None },
            ..data(sampled(&gear, 7, 24))
        });
        let sampled = sampled.expect("a gear");
        let never = Interrupt::never();
        let [exact, found]: [&dyn Prototype; 2] = [gear.as_ref(), sampled.as_ref()];
        let [exact, found] = [exact, found].map(|gear| gear.build_solid(&options, &never).expect("a body"));
        let end = gear.surfaces(&options).expect("flanks")[0].edge_from().expect("an edge");
        let places: Vec<[f64; 2]> = [(0.3, -0.2), (0.5, 0.0), (0.7, 0.1)]
            .map(|(part, along)| [part * end, along * gear.face_width])
            .to_vec();
        let (exact, found) = (response(exact.as_ref(), &places), response(found.as_ref(), &places));
        for (exact, found) in exact.0.iter().zip(&found.0) {
            assert!((found / exact - 1.0).abs() < 3e-3, "{helix}: {found:e} {exact:e}");
        }
        assert!((found.1 / exact.1 - 1.0).abs() < 0.02, "{helix}: {} {}", found.1, exact.1);
        assert!((sampled.inertia().mass / gear.inertia().mass - 1.0).abs() < 2e-3);
        assert!((sampled.inertia().polar() / gear.inertia().polar() - 1.0).abs() < 2e-3);
    }
}

#[test]
fn bores_that_leave_no_rim_are_refused() {
    let table = Conical::PINION.table(7, 12);
    let gear = TabulatedGear::new(data(table.clone())).expect("a gear");
    let radius = |v: f64| {
        let tooth = gear.tooth();
        tooth.cones.radius(tooth.along(v), gear.bore().at(v))
    };
    let [start, end] = gear.tooth().face.map(radius);
    assert!(start > 0.0 && end > 0.0 && (start - end).abs() > 1e-3);
    let refused = |bore: BoreShape| {
        let refusal = TabulatedGear::new(TabulatedGearData { bore, ..data(table.clone()) }).err();
        match refusal {
            Some(Refusal::Geometry(errors)) => (errors[0].code, errors[0].argument),
            other => panic!("{other:?}"),
        }
    };
    assert_eq!(refused(BoreShape::Cylinder(2.0 * start.max(end))), ("E0973", "bore_diameter"));
    let thick = BoreShape::Rim { thickness: Some(1.0), angle: None };
    assert_eq!(refused(thick), ("E0973", "rim_thickness"));
    let steep = BoreShape::Rim { thickness: None, angle: Some(1.4) };
    assert_eq!(refused(steep), ("E0973", "bore_angle"));
    // A cylinder has one radius in all sections.
    let cylinder = BoreShape::Cylinder(1.4 * start.min(end));
    let gear = TabulatedGear::new(TabulatedGearData { bore: cylinder, ..data(table.clone()) });
    let gear = gear.expect("a gear");
    for v in gear.tooth().face {
        let radius = gear.tooth().cones.radius(gear.tooth().along(v), gear.bore().at(v));
        assert!((radius - 0.7 * start.min(end)).abs() < 1e-15);
    }
}

#[test]
fn models_without_a_length_along_the_face_are_refused() {
    let gear = TabulatedGear::new(data(Conical::GEAR.table(7, 12))).expect("a gear");
    let options = StructureOptions::default();
    assert_eq!(gear.check(&options, false).err().map(|error| error.code), Some("E0975"));
    assert!(gear.check(&options, true).is_ok());
    for model in [BodyModel::Rigid, BodyModel::Analytic] {
        let options = StructureOptions { model, ..options };
        assert!(gear.check(&options, true).is_ok());
        let body = gear.build_solid(&options, &Interrupt::never()).expect("a body");
        assert_eq!(body.teeth(), 36);
    }
}

#[test]
fn every_input_of_the_structure_is_in_its_key() {
    let table = Conical::PINION.table(5, 8);
    let options = StructureOptions::default();
    let key = |data: TabulatedGearData| {
        TabulatedGear::new(data).expect("a gear").solid_key(&options).expect("a key").bytes().to_vec()
    };
    let own = key(data(table.clone()));
    let mut moved = table.clone();
    moved.flanks[1][2][3][0] *= 1.0 + 1e-9;
    let others = [
        data(moved),
        TabulatedGearData { tip_edge_radius: Some(1e-4), ..data(table.clone()) },
        TabulatedGearData {
            bore: BoreShape::Rim { thickness: Some(6e-3), angle: None },
            ..data(table.clone())
        },
        TabulatedGearData {
            support: BoreSupport::Means { harmonics: None, degree: 0 },
            ..data(table.clone())
        },
    ];
    for other in others {
        assert_ne!(key(other), own);
    }
    let errors = TabulatedGearData { pitch_errors: vec![1e-6], ..data(table) };
    assert_eq!(key(errors), own);
}

/// The gears of chapter 6 of the report on their rims: a cylinder and a cone.
fn chapter_6() -> [Arc<TabulatedGear>; 2] {
    const INCH: f64 = 0.0254;
    let cone = BoreShape::Rim { thickness: Some(0.35 * INCH), angle: Some(61.5_f64.to_radians()) };
    [("pinion", BoreShape::Cylinder(1.138 * INCH)), ("gear", cone)].map(|(name, bore)| {
        TabulatedGear::new(TabulatedGearData { bore, ..data(aerospace(name)) }).expect("a gear")
    })
}

#[test]
fn spiral_bevel_gears_of_machine_settings_are_meshed() {
    use calyx_runtime::scene::Template;
    for gear in chapter_6() {
        for template in [Template::Medium, Template::FineRoot] {
            let options = StructureOptions { template, ..StructureOptions::default() };
            gear.check(&options, true).unwrap_or_else(|error| panic!("{template:?}: {error}"));
            let mesh = gear.solid_mesh(&options, &Interrupt::never());
            let mesh = mesh.unwrap_or_else(|error| panic!("{template:?}: {error}"));
            let worst = crate::tabulated::solid_mesh::tests::volume_and_quality(&mesh)[1];
            assert!(worst > 0.005, "{} teeth, {template:?}: {worst}", gear.teeth());
            crate::tabulated::solid_mesh::tests::assert_congruent(&mesh, gear.teeth());
        }
    }
}

/// The outer surfaces of all sectors together enclose the volume of the gear.
#[test]
fn surfaces_enclose_the_volume_of_bevel_gears() {
    for gear in chapter_6() {
        for model in [BodyModel::Elements, BodyModel::Analytic, BodyModel::Rigid] {
            let options = StructureOptions { model, ..StructureOptions::default() };
            let surface = gear.outer_surface(&options, true, &Interrupt::never());
            let surface = surface.expect("a mesh").expect("a surface");
            let (found, expected) = (surface.volume(), gear.inertia().mass / gear.data.material.density);
            assert!((found / expected - 1.0).abs() < 5e-3, "{model:?}: {found} {expected}");
        }
    }
}

#[test]
fn the_mass_lies_between_those_of_the_root_and_the_tip_cone() {
    let [pinion, gear] = chapter_6();
    for gear in [pinion, gear] {
        let Inertia { mass, moment, .. } = gear.inertia();
        let density = gear.data.material.density;
        let tooth = gear.tooth();
        let [start, end] = tooth.face;
        let ring = |height: &dyn Fn(f64) -> f64| {
            let parts = 200;
            let step = (end - start) / f64::from(parts);
            let slice = |k: i32| {
                let v = start + (f64::from(k) + 0.5) * step;
                let (top, bottom) = (height(v), gear.bore().at(v));
                let radius = tooth.cones.radius(tooth.along(v), 0.5 * (top + bottom));
                std::f64::consts::TAU * radius * (top - bottom) * step
            };
            density * (0..parts).map(slice).sum::<f64>()
        };
        let tip = |v: f64| {
            let point = tooth.flank_at(0, tooth.edge_from(0), v).position;
            tooth.cones.rolled(tooth.along(v), point)[0]
        };
        let (least, most) = (ring(&|v| root_end(tooth, 0, v)[0]), ring(&tip));
        assert!(mass > least && mass < most, "{mass} is not between {least} and {most}");
        assert!(moment[0] == 0.0 && moment[1] == 0.0 && (moment[2] / mass).abs() < 0.1);
    }
}
