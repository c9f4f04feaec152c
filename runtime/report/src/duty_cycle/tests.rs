//! Equivalent values against closed forms.

use super::*;
use crate::durations::Durations;
use crate::sweep::{Case, Column, Row, Statistics};
use calyx_runtime::component_loads::{ComponentLoads, LoadStatistics};
use std::collections::BTreeMap;

fn case(share: f64, speed: f64, load: f64) -> CaseLoad {
    CaseLoad { share, speed, load }
}

fn assert_close(value: f64, expected: f64) {
    assert!((value / expected - 1.0).abs() < 1e-13, "{value} is not {expected}");
}

#[test]
fn equal_loads_have_themselves_as_equivalent() {
    for exponent in [3.0, 10.0 / 3.0, PITTING_SLOPE] {
        let cases = [case(0.2, 5.0, 700.0), case(0.5, 1.0, 700.0), case(0.3, 20.0, 700.0)];
        assert_close(equivalent_load(&cases, exponent).expect("a load"), 700.0);
    }
}

/// Loads 1 and 2 for equal revolutions: `((1 + 8) / 2)^(1/3)` for balls.
#[test]
fn two_cases_have_the_cubic_mean() {
    let loads = [case(0.5, 10.0, 1.0), case(0.5, 10.0, 2.0)];
    assert_close(equivalent_load(&loads, 3.0).expect("a load"), 4.5f64.cbrt());
    // Three quarters of the revolutions under the smaller load: `(3/4 + 8/4)^(1/3)`.
    let loads = [case(0.5, 30.0, 1.0), case(0.5, 10.0, 2.0)];
    assert_close(equivalent_load(&loads, 3.0).expect("a load"), 2.75f64.cbrt());
    // Loads in any unit, without overflow.
    let loads = [case(0.5, 30.0, 1e200), case(0.5, 10.0, 2e200)];
    assert_close(equivalent_load(&loads, 3.0).expect("a load"), 2.75f64.cbrt() * 1e200);
}

#[test]
fn cases_at_rest_or_without_duration_do_not_count() {
    let loads = [case(0.5, 10.0, 3.0), case(0.5, 0.0, 1e9), case(0.0, 10.0, 1e9)];
    assert_close(equivalent_load(&loads, 3.0).expect("a load"), 3.0);
    assert_eq!(equivalent_load(&[case(1.0, 0.0, 3.0)], 3.0), None);
    assert_eq!(equivalent_load(&[], 3.0), None);
    assert_eq!(equivalent_load(&[case(1.0, 2.0, 0.0)], 3.0), Some(0.0));
}

/// The slope of pitting follows from the life factors of ISO 6336-2.
#[test]
fn the_default_slope_is_that_of_the_life_factor() {
    let slope = 500f64.ln() / (2.0 * 1.6f64.ln());
    assert!((slope - PITTING_SLOPE).abs() < 0.005, "{slope}");
}

/// Half of the time at a life of 100 h and half at 300 h: 1 / (0.5/100 + 0.5/300) = 150 h.
#[test]
fn damages_add_up() {
    assert_close(miner_life([(0.5, 1.0 / 100.0), (0.5, 1.0 / 300.0)]), 150.0);
    assert_eq!(miner_life([(1.0, 0.0)]), f64::INFINITY);
}

const RPM: f64 = TAU / 60.0;

fn constant(value: f64) -> LoadStatistics {
    LoadStatistics { min: value, mean: value, max: value }
}

fn bearing(load: f64, speed: f64, life: f64) -> ComponentLoads {
    let component = Component::Bearing { name: "left".into(), kind: Some(RollingKind::Balls) };
    let quantities = vec![
        (LoadQuantity::EquivalentLoad, constant(load)),
        (LoadQuantity::Damage, constant(life.recip())),
        (LoadQuantity::BearingLoss, constant(0.1 * load)),
        (LoadQuantity::BearingSpeed, constant(speed)),
    ];
    ComponentLoads { component, quantities }
}

fn mesh(torque: f64, speed: f64, loss: f64) -> ComponentLoads {
    let component = Component::Mesh(["pinion".into(), "gear".into()]);
    let quantities = vec![
        (LoadQuantity::Torque, constant(torque)),
        (LoadQuantity::FrictionLoss, constant(loss)),
        (LoadQuantity::MeshSpeed, constant(speed)),
    ];
    ComponentLoads { component, quantities }
}

/// A sweep of two cases with an output of a power.
fn sweep(durations: Durations) -> SweepTable {
    let row = |case: usize, components: Vec<ComponentLoads>, loss: f64| {
        let statistics = Statistics { mean: Some(loss), ..Statistics::default() };
        let outputs = BTreeMap::from([("loss".to_owned(), statistics)]);
        Row { case, outputs, components: Some(components), ..Row::default() }
    };
    let case = |name: &str| Case { name: name.into(), values: Vec::new() };
    let loss = Column { name: "loss".into(), unit: "kW".into(), factor: 1e3, is_power: true };
    SweepTable {
        outputs: vec![loss],
        cases: vec![case("drive"), case("coast")],
        rows: vec![
            row(1, vec![bearing(1e3, 3000.0 * RPM, 9e7), mesh(100.0, 10.0, 5.0)], 400.0),
            row(2, vec![bearing(2e3, 1000.0 * RPM, 1.2e7), mesh(200.0, 10.0, 15.0)], 800.0),
        ],
        load_cases: true,
        durations: Some(durations),
        ..SweepTable::default()
    }
}

fn value(cycle: &DutyCycle, key: &str) -> f64 {
    value_of(cycle, "", key)
}

/// Returns the value of the component with this part of the name.
fn value_of(cycle: &DutyCycle, name: &str, key: &str) -> f64 {
    let mut values = cycle.values.iter().filter(|value| value.name.contains(name));
    values.find(|value| value.key == key).unwrap_or_else(|| panic!("no {key}")).value
}

#[test]
fn a_duty_cycle_has_equivalent_values_of_all_components() {
    let durations = Durations { values: vec![1.0, 1.0], are_times: false };
    let cycle = DutyCycle::of(&sweep(durations), &[1.0]).expect("a cycle").expect("values");
    assert!(cycle.missing.is_empty(), "{:?}", cycle.missing);
    assert_close(value(&cycle, "equivalent_load"), 1e3 * 2.75f64.cbrt());
    assert_close(value(&cycle, "mean_speed"), 2000.0);
    // 9e7 revolutions at 3000 rpm are 500 h, 1.2e7 at 1000 rpm are 200 h.
    assert_close(value(&cycle, "life"), 1.0 / (0.5 / 500.0 + 0.5 / 200.0));
    assert_close(value(&cycle, "equivalent_torque"), 150.0);
    assert_close(value_of(&cycle, "left", "mean_friction_loss"), 150.0);
    assert_close(value_of(&cycle, "pinion", "mean_friction_loss"), 10.0);
    assert_close(value(&cycle, "efficiency"), 1.0 - 10.0 / 1500.0);
    assert_close(value(&cycle, "mean_power"), 0.6);
}

#[test]
fn only_the_proportions_of_durations_count() {
    let of = |values: [f64; 2], are_times| {
        let durations = Durations { values: values.to_vec(), are_times };
        let found = DutyCycle::of(&sweep(durations), &[PITTING_SLOPE]);
        found.expect("a cycle").expect("values")
    };
    let (shares, hours) = (of([0.25, 0.75], false), of([3600.0, 3.0 * 3600.0], true));
    assert_eq!(shares.values, hours.values);
    assert_eq!((shares.total, hours.total), (None, Some(4.0 * 3600.0)));
}

#[test]
fn what_is_not_available_is_said() {
    let durations = || Durations { values: vec![1.0, 1.0], are_times: false };
    let mut failed = sweep(durations());
    failed.rows[1].failure = Some("E0714".into());
    assert_eq!(DutyCycle::of(&failed, &[]), Some(Err("coast failed".into())));
    let mut left = sweep(durations());
    left.rows.pop();
    assert_eq!(DutyCycle::of(&left, &[]), Some(Err("1 of 2 cases are solved".into())));
    assert_eq!(DutyCycle::of(&SweepTable::default(), &[]), None);

    // A spring, a mesh at rest, and one that is absent from a case.
    let mut table = sweep(durations());
    let spring = Component::Bearing { name: "spring".into(), kind: None };
    let spring =
        ComponentLoads { component: spring, quantities: vec![(LoadQuantity::RadialForce, constant(1.0))] };
    table.rows[0].components = Some(vec![spring, mesh(100.0, 0.0, 0.0)]);
    table.rows[1].components = Some(Vec::new());
    let cycle = DutyCycle::of(&table, &[PITTING_SLOPE]).expect("a cycle").expect("values");
    let missing = cycle.missing.join("\n");
    for sentence in [
        "spring has springs instead of rolling elements: no equivalent load and no life.",
        "pinion / gear does not rotate: no equivalent torque.",
        "pinion / gear has no loads in coast, which adds no load cycles to it.",
    ] {
        assert!(missing.contains(sentence), "{missing}");
    }
}

#[test]
fn tables_have_a_row_per_component_and_a_column_per_case() {
    let folder = tempfile::tempdir().expect("a folder");
    let table = sweep(Durations { values: vec![1.0, 1.0], are_times: false });
    let path = folder.path().join(crate::component_table::NAME);
    crate::component_table::write(&path, &table).expect("written");
    let text = std::fs::read_to_string(&path).expect("a file");
    // The conversion to SI and back rounds.
    let text = text.replace("3000.0000000000005", "3000");
    assert_eq!(
        text,
        "kind,component,quantity,unit,drive,coast\n\
         mesh,pinion / gear,torque,N*m,100,200\n\
         mesh,pinion / gear,friction_loss,W,5,15\n\
         mesh,pinion / gear,speed,rpm,95.49296585513721,95.49296585513721\n\
         bearing,left,equivalent_load,N,1000,2000\n\
         bearing,left,life,revolutions,90000000,12000000\n\
         bearing,left,friction_loss,W,100,200\n\
         bearing,left,speed,rpm,3000,1000\n"
    );
}
