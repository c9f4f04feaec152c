//! Diagnostics of a gear or a pair: the code, the argument to blame and the message, one row per
//! mistake.

use crate::common::{INCH, chapter_5, chapter_5_data, standard_data};
use calyx_gears::blank::Rim;
use calyx_gears::error::{GeometryError, Severity};
use calyx_gears::external::{ExternalGear, ExternalGearData, check_rim};
use calyx_gears::fillet::Side;
use calyx_gears::flank::Flank;
use calyx_gears::mesh_geometry::{HelicalTeeth, MeshGeometry};
use calyx_gears::modification::{Modification, ReliefShape};
use calyx_gears::prototype::GearPrototype;
use calyx_gears::rack::Rack;
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::material::Material;
use calyx_runtime::scene::{Prototype, StructureOptions};
use calyx_runtime::structure::BoreSupport;

fn expect(row: &str, errors: &[GeometryError], code: &str, argument: &str, says: &str) {
    let found = errors.iter().find(|error| error.code == code);
    let error = found.unwrap_or_else(|| panic!("{row}: no {code} in {errors:?}"));
    assert_eq!(error.argument, argument, "{row}");
    assert_eq!(error.severity, Severity::Error, "{row}");
    let message = error.message.in_unit("inch", INCH).to_string();
    assert!(message.contains(says), "{row}: {message}");
    assert!(!error.help.0.is_empty(), "{row}: a remedy");
}

#[test]
fn impossible_gears_are_refused() {
    let sound = chapter_5_data(20, 0.02, 0.15708);
    let change = |change: &dyn Fn(&mut ExternalGearData)| {
        let mut data = sound;
        change(&mut data);
        data
    };
    let rows: [(&str, ExternalGearData, &str, &str, &str); 11] = [
        ("few teeth", change(&|data| data.teeth = 3), "E0604", "teeth", "3 teeth"),
        (
            "no space",
            change(&|data| data.tooth_thickness = 0.4 * INCH),
            "E0605",
            "tooth_thickness",
            "0.4 inch thick",
        ),
        ("no root", change(&|data| data.root_radius = -INCH), "E0606", "root_diameter", "-2 inch"),
        (
            "outer below root",
            change(&|data| data.outer_radius = 0.85 * INCH),
            "E0607",
            "outer_diameter",
            "1.7 inch is not larger than the root diameter of 1.76 inch",
        ),
        (
            "another gear's diameters",
            change(&|data| (data.root_radius, data.outer_radius) = (1.89 * INCH, 2.09 * INCH)),
            "E0608",
            "root_diameter",
            "3.78 inch is not below the pitch diameter of 2 inch",
        ),
        (
            "large rack tip",
            chapter_5_data(20, 0.06, 0.15708),
            "E0612",
            "tip_radius",
            "0.06 inch does not fit on its tooth: at most 0.049789 inch does",
        ),
        (
            "deep rack",
            change(&|data| data.root_radius = 0.75 * INCH),
            "E0613",
            "root_diameter",
            "comes to a point before it reaches the root circle of diameter 1.5 inch",
        ),
        (
            "outer circle inside the form circle",
            change(&|data| data.outer_radius = 0.94 * INCH),
            "E0615",
            "outer_diameter",
            "no involute between the form circle of diameter 1.8803 inch",
        ),
        (
            "pointed by thickness",
            chapter_5_data(20, 0.02, 0.08),
            "E0616",
            "outer_diameter",
            "comes to a point at diameter 2.17",
        ),
        (
            "pointed by height",
            change(&|data| data.outer_radius = 1.2 * INCH),
            "E0616",
            "outer_diameter",
            "before the outer diameter of 2.4 inch",
        ),
        (
            "round tip",
            change(&|data| data.tip_edge_radius = Some(0.08 * INCH)),
            "E0617",
            "tip_edge_radius",
            "0.08 inch does not fit on a tip 0.080766 inch thick",
        ),
    ];
    for (row, data, code, argument, says) in rows {
        match ExternalGear::new(data) {
            Ok(_) => panic!("{row}: accepted"),
            Err(errors) => expect(row, &errors, code, argument, says),
        }
    }
    // Independent mistakes are reported together.
    let errors = ExternalGear::new(ExternalGearData { teeth: 2, root_radius: 0.0, ..sound })
        .expect_err("two mistakes");
    let codes: Vec<_> = errors.iter().map(|error| error.code).collect();
    assert_eq!(codes, ["E0604", "E0606"]);
}

#[test]
fn impossible_racks_rims_and_reliefs_are_refused() {
    let angle = 20.0_f64.to_radians();
    let rows = [
        (Rack::new(-1e-3, angle, 0.0), "E0601", "module", "-0.03937 inch"),
        (Rack::new(1e-3, 20.0, 0.0), "E0602", "pressure_angle", "1145.9 deg"),
        (Rack::new(1e-3, angle, f64::NAN), "E0603", "tip_radius", "NaN"),
    ];
    for (rack, code, argument, says) in rows {
        expect(code, &[rack.expect_err("an impossible rack")], code, argument, says);
    }

    let rims = [
        (0.9, 0.6, "E0620", "diameter", "1.8 inch, which is not below the root diameter of 1.76 inch"),
        (0.7, 0.75, "E0621", "inner_diameter", "1.5 inch is not between zero"),
        (0.7, 0.0, "E0621", "inner_diameter", "0 inch"),
    ];
    for (rim, inner, code, argument, says) in rims {
        let error = check_rim(0.88 * INCH, rim * INCH, inner * INCH).expect_err("an impossible rim");
        expect(code, &[error], code, argument, says);
    }
    assert_eq!(check_rim(0.88 * INCH, 0.7 * INCH, 0.6 * INCH), Ok(()));

    let reliefs = [
        (
            34.0,
            0.0005,
            "E0640",
            "start_roll_angle",
            "34 deg, but the involute runs from 1.8072 deg to 33.678 deg",
        ),
        (1.0, 0.0005, "E0640", "start_roll_angle", "1 deg"),
        (27.25, 0.05, "E0641", "depth", "0.05 inch deep"),
        (27.25, -0.001, "E0641", "depth", "-0.001 inch"),
    ];
    for (start, depth, code, argument, says) in reliefs {
        let start_roll = f64::to_radians(start);
        let relief = Modification::tip_relief(depth * INCH, start_roll, ReliefShape::Quadratic);
        let errors =
            Flank::new(&chapter_5(20), &[relief], Side::CounterClockwise).expect_err("an impossible relief");
        expect(code, &errors, code, argument, says);
    }
}

#[test]
fn impossible_pairs_are_refused() {
    let gear = |data: ExternalGearData| ExternalGear::new(data).expect("a sound gear");
    let (first, second) = (chapter_5(20), chapter_5(40));
    let thin = [20, 40].map(|teeth| gear(chapter_5_data(teeth, 0.02, 0.13)));
    let round = [20, 40].map(|teeth| gear(chapter_5_data(teeth, 0.045, 0.13)));
    let other = gear(standard_data(30, 0.0, 0.3));
    let high = gear(ExternalGearData { outer_radius: 2.13 * INCH, ..chapter_5_data(40, 0.02, 0.15708) });
    /// Description, pair, centre distance in inches, code, argument, words of the message.
    type Row<'a> = (&'a str, [&'a ExternalGear; 2], f64, &'a str, &'a str, &'a str);
    let rows: [Row<'_>; 7] = [
        ("other module", [&first, &other], 3.0, "E0630", "second", "different base pitches, 0.29521 inch"),
        (
            "close axes",
            [&first, &second],
            2.8,
            "E0631",
            "second",
            "2.8 inch apart, less than the base circles",
        ),
        ("far axes", [&first, &second], 3.19, "E0632", "second", "reach only 3.18 inch"),
        ("little contact", [&first, &second], 3.1, "E0633", "second", "below 1"),
        (
            "fillet interference",
            [&round[0], &round[1]],
            2.98,
            "E0634",
            "first",
            "the tips would run into the fillets",
        ),
        (
            "high mate",
            [&first, &high],
            3.0,
            "E0634",
            "first",
            "0.93999 inch on this gear, but its involute begins only at 0.94016",
        ),
        ("tip in root", [&thin[0], &thin[1]], 2.97, "E0636", "second", "0.01 inch into the root circle"),
    ];
    for (row, [first, second], distance, code, argument, says) in rows {
        let errors = MeshGeometry::check_external(first, second, distance * INCH, &HelicalTeeth::default())
            .expect_err(row);
        expect(row, &errors, code, argument, says);
    }
    // The thin pair runs without backlash errors at a slightly reduced distance, with a warning
    // about its tip clearance.
    let (mesh, warnings) =
        MeshGeometry::check_external(&thin[0], &thin[1], 2.983 * INCH, &HelicalTeeth::default())
            .expect("a pair");
    assert!(mesh.backlash > 0.0);
    // Tips in the pinion's root by 0.013 inches (a warning starts at 0.005), in the gear's by
    // 0.003.
    let found: Vec<_> = warnings.iter().map(|warning| (warning.code, warning.argument)).collect();
    // Teeth that are thinner by 0.027 inches have a backlash of half a module.
    assert_eq!(found, [("E0694", "second"), ("E0637", "second")]);
    // A pair without backlash runs on its drive flanks, with a warning.
    let (_, warnings) = MeshGeometry::check_external(&first, &second, 2.995 * INCH, &HelicalTeeth::default())
        .expect("a pair");
    let tight = warnings.iter().find(|warning| warning.code == "E0635").expect("a warning");
    assert!(tight.to_string().contains("backlash is negative"), "{tight}");
    // An undercut pinion is in contact from its form circle on; its mate's tips pass the part that
    // the rack has removed.
    let [small, large] = [12, 30].map(|teeth| gear(standard_data(teeth, 0.0, 0.3)));
    let (mesh, _) =
        MeshGeometry::check_external(&small, &large, 21e-3, &HelicalTeeth::default()).expect("a pair");
    let nominal = (mesh.tangent_distance - large.base_radius * large.tip_roll) / small.base_radius;
    assert!(small.undercut && nominal < small.form_roll, "{nominal} {}", small.form_roll);
    assert!((mesh.first_roll.start_of_active_profile - small.form_roll).abs() < 1e-12);
    assert!((1.0..1.6).contains(&mesh.contact_ratio), "{}", mesh.contact_ratio);
    // The pair of the report has tip clearances of 0.03 and 0.02 inches: no findings.
    assert!(
        MeshGeometry::check_external(&first, &second, 3.0 * INCH, &HelicalTeeth::default())
            .is_ok_and(|(_, warnings)| warnings.is_empty())
    );
}

/// Options that only the engine's API can set.
#[test]
fn a_mesh_of_unknown_order_is_refused() {
    let rim = Rim { radius: 0.70 * INCH, fixed_radius: 0.60 * INCH, web: None, support: BoreSupport::Rigid };
    let steel = Material { youngs_modulus: 206e9, poissons_ratio: 0.3, density: 7850.0 };
    let gear = ExternalGear::new(chapter_5_data(20, 0.02, 0.15708)).expect("a sound gear");
    let gear = GearPrototype::new(gear, Vec::new(), steel, rim, INCH, Vec::new()).expect("a gear");
    for (order, refinement) in [(0, 1.0), (4, 1.0), (3, 0.0), (3, f64::NAN)] {
        let options = StructureOptions { order, refinement, ..StructureOptions::default() };
        let error = gear.build(&options, &Interrupt::never()).err().expect("refused");
        assert_eq!(error.code, "E0675", "order {order}, refinement {refinement}");
        assert!(!error.help.is_empty(), "a remedy");
    }
}
