//! Loads of meshes and bearings by load case, as tables of a quantity each.

use crate::sweep::{Row, SweepTable, exact};
use calyx_abi::units::from_si;
use calyx_runtime::component_loads::{Component, ComponentLoads, LoadQuantity, LoadStatistics};
use std::f64::consts::TAU;
use std::io;
use std::path::Path;

/// File name of the tables in the directory of a sweep.
pub const NAME: &str = "component_loads.csv";

/// Unit of a table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TableUnit {
    /// Name.
    pub name: &'static str,
    /// Value in SI.
    pub factor: f64,
}

const fn unit(name: &'static str, factor: f64) -> TableUnit {
    TableUnit { name, factor }
}

/// Units of the tables.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TableUnits {
    pub torque: TableUnit,
    pub force: TableUnit,
    pub stress: TableUnit,
    pub deviation: TableUnit,
    pub angle: TableUnit,
    pub speed: TableUnit,
    pub power: TableUnit,
}

const POUND: f64 = 4.4482216152605;
const INCH: f64 = 0.0254;

impl TableUnits {
    /// Returns the units of a system by its name: `SI`, `mm_N_s`, `inch_lbf_s`.
    pub fn of_system(name: &str) -> TableUnits {
        let angle = unit("urad", 1e-6);
        let [speed, power] = [unit("rpm", TAU / 60.0), unit("W", 1.0)];
        match name {
            "inch_lbf_s" => TableUnits {
                torque: unit("lbf*inch", POUND * INCH),
                force: unit("lbf", POUND),
                stress: unit("psi", POUND / (INCH * INCH)),
                deviation: unit("microinch", 1e-6 * INCH),
                angle,
                speed,
                power,
            },
            _ => TableUnits {
                torque: unit("N*m", 1.0),
                force: unit("N", 1.0),
                stress: unit("MPa", 1e6),
                deviation: unit("um", 1e-6),
                angle,
                speed,
                power,
            },
        }
    }
}

/// Kind of component of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ComponentKind {
    Mesh,
    Bearing,
}

impl ComponentKind {
    /// Returns the name of the kind in files.
    pub fn name(self) -> &'static str {
        match self {
            ComponentKind::Mesh => "mesh",
            ComponentKind::Bearing => "bearing",
        }
    }

    /// Returns the kind of a component.
    pub fn of(component: &Component) -> ComponentKind {
        match component {
            Component::Mesh(_) => ComponentKind::Mesh,
            Component::Bearing { .. } => ComponentKind::Bearing,
        }
    }
}

type Statistic = fn(&LoadStatistics) -> f64;

/// Definition of a table: quantity, key and title, statistic, unit.
struct Definition {
    kind: ComponentKind,
    quantity: LoadQuantity,
    key: &'static str,
    title: &'static str,
    statistic: Statistic,
    unit: fn(&TableUnits) -> TableUnit,
}

/// Returns the mean over the positions of a case.
const MEAN: Statistic = |all| all.mean;
/// Returns the largest value over the positions of a case.
const MAX: Statistic = |all| all.max;

const fn definition(
    kind: ComponentKind,
    quantity: LoadQuantity,
    [key, title]: [&'static str; 2],
    statistic: Statistic,
    unit: fn(&TableUnits) -> TableUnit,
) -> Definition {
    Definition { kind, quantity, key, title, statistic, unit }
}

/// Tables in order.
const DEFINITIONS: &[Definition] = {
    use ComponentKind::{Bearing, Mesh};
    use LoadQuantity as Of;
    &[
        definition(Mesh, Of::Torque, ["torque", "Torque on the first gear, mean"], MEAN, |u| u.torque),
        definition(Mesh, Of::MeshForce, ["mesh_force", "Mesh force, mean"], MEAN, |u| u.force),
        definition(
            Mesh,
            Of::TransmissionError,
            ["transmission_error", "Transmission error, peak to peak"],
            |all| all.max - all.min,
            |u| u.angle,
        ),
        definition(
            Mesh,
            Of::ContactPressure,
            ["contact_pressure", "Contact pressure away from edges, largest"],
            MAX,
            |u| u.stress,
        ),
        definition(
            Mesh,
            Of::EdgePressure,
            ["edge_pressure", "Contact pressure near edges, largest"],
            MAX,
            |u| u.stress,
        ),
        definition(
            Mesh,
            Of::FirstRootStress,
            ["root_stress_first", "Root stress of the first gear, largest"],
            MAX,
            |u| u.stress,
        ),
        definition(
            Mesh,
            Of::SecondRootStress,
            ["root_stress_second", "Root stress of the second gear, largest"],
            MAX,
            |u| u.stress,
        ),
        definition(
            Mesh,
            Of::MisalignmentSlope,
            ["misalignment_slope", "Misalignment in the plane of action: slope of the axes, mean"],
            MEAN,
            |u| u.angle,
        ),
        definition(
            Mesh,
            Of::MisalignmentOffset,
            ["misalignment_offset", "Misalignment in the plane of action: offset of the axes, mean"],
            MEAN,
            |u| u.deviation,
        ),
        definition(Mesh, Of::OffsetError, ["offset_error", "Error of the offset (E), mean"], MEAN, |u| {
            u.deviation
        }),
        definition(
            Mesh,
            Of::ShaftAngleError,
            ["shaft_angle_error", "Error of the shaft angle (Sigma), mean"],
            MEAN,
            |u| u.angle,
        ),
        definition(Mesh, Of::FrictionLoss, ["friction_loss", "Friction loss, mean"], MEAN, |u| u.power),
        definition(Mesh, Of::MeshSpeed, ["speed", "Speed of the first gear"], MEAN, |u| u.speed),
        definition(Bearing, Of::RadialForce, ["radial_force", "Radial force, mean"], MEAN, |u| u.force),
        definition(Bearing, Of::RadialForce, ["radial_force_max", "Radial force, largest"], MAX, |u| u.force),
        definition(Bearing, Of::AxialForce, ["axial_force", "Axial force, mean"], MEAN, |u| u.force),
        definition(Bearing, Of::TiltingMoment, ["tilting_moment", "Tilting moment, mean"], MEAN, |u| {
            u.torque
        }),
        definition(
            Bearing,
            Of::ElementPressure,
            ["element_pressure", "Contact pressure of the rolling elements, largest"],
            MAX,
            |u| u.stress,
        ),
        definition(
            Bearing,
            Of::EquivalentLoad,
            ["equivalent_load", "Dynamic equivalent reference load (ISO/TS 16281), mean"],
            MEAN,
            |u| u.force,
        ),
        definition(
            Bearing,
            Of::Damage,
            ["life", "Basic reference rating life"],
            |all| all.mean.recip(),
            |_| unit("revolutions", 1.0),
        ),
        definition(
            Bearing,
            Of::ModifiedDamage,
            ["modified_life", "Modified reference rating life"],
            |all| all.mean.recip(),
            |_| unit("revolutions", 1.0),
        ),
        definition(Bearing, Of::BearingLoss, ["friction_loss", "Friction loss, mean"], MEAN, |u| u.power),
        definition(Bearing, Of::BearingSpeed, ["speed", "Speed of the first race"], MEAN, |u| u.speed),
    ]
};

/// Table of a quantity: a row per component, a value per case.
#[derive(Clone, Debug, PartialEq)]
pub struct QuantityTable {
    /// Kind of the components.
    pub kind: ComponentKind,
    /// Key of the quantity in files.
    pub key: &'static str,
    /// Quantity and statistic.
    pub title: &'static str,
    /// Unit of the values.
    pub unit: &'static str,
    /// Names of the components, and values by case; `None` where a case has no value.
    pub rows: Vec<(String, Vec<Option<f64>>)>,
}

impl QuantityTable {
    /// Returns whether the values are lives, of which small ones are severe.
    pub fn is_life(&self) -> bool {
        self.key.ends_with("life")
    }
}

/// Returns the loads of a component in a case.
pub(crate) fn loads_of<'r>(row: &'r Row, component: &Component) -> Option<&'r ComponentLoads> {
    row.components.iter().flatten().find(|loads| loads.component == *component)
}

/// Returns the components of all cases, in order of appearance.
pub(crate) fn components(table: &SweepTable) -> Vec<&Component> {
    let mut all: Vec<&Component> = Vec::new();
    for loads in table.rows.iter().flat_map(|row| row.components.iter().flatten()) {
        if !all.contains(&&loads.component) {
            all.push(&loads.component);
        }
    }
    all
}

/// Returns the tables of all quantities that some case has. Edge pressures and misalignments that
/// are zero in all cases are left out.
pub fn tables(table: &SweepTable) -> Vec<QuantityTable> {
    let (units, components) = (TableUnits::of_system(&table.units), components(table));
    let of = |definition: &Definition| {
        let unit = (definition.unit)(&units);
        let value = |row: &Row, component: &Component| {
            let statistics = loads_of(row, component)?.of(definition.quantity)?;
            Some(from_si((definition.statistic)(&statistics), unit.factor))
        };
        let own = components.iter().filter(|component| ComponentKind::of(component) == definition.kind);
        let rows = own.map(|component| {
            let values = table.rows.iter().map(|row| value(row, component));
            (component.name(), values.collect::<Vec<_>>())
        });
        let rows: Vec<_> = rows.filter(|(_, values)| values.iter().any(Option::is_some)).collect();
        let is_zero = |value: &Option<f64>| value.is_none_or(|value| value == 0.0);
        let is_optional = matches!(
            definition.quantity,
            LoadQuantity::EdgePressure
                | LoadQuantity::MisalignmentSlope
                | LoadQuantity::MisalignmentOffset
                | LoadQuantity::OffsetError
                | LoadQuantity::ShaftAngleError
        );
        let is_zero = is_optional && rows.iter().all(|(_, values)| values.iter().all(is_zero));
        (!rows.is_empty() && !is_zero).then_some(QuantityTable {
            kind: definition.kind,
            key: definition.key,
            title: definition.title,
            unit: unit.name,
            rows,
        })
    };
    DEFINITIONS.iter().filter_map(of).collect()
}

/// Writes the tables as CSV: a line per component and quantity, with a column per case.
///
/// # Errors
/// The file cannot be written.
pub fn write(path: &Path, table: &SweepTable) -> io::Result<()> {
    let mut file = csv::Writer::from_path(path)?;
    let mut head: Vec<String> = ["kind", "component", "quantity", "unit"].map(String::from).to_vec();
    head.extend((0..table.rows.len()).map(|index| table.label(index)));
    file.write_record(&head)?;
    for quantity in tables(table) {
        for (component, values) in &quantity.rows {
            let mut cells: Vec<String> =
                [quantity.kind.name(), component, quantity.key, quantity.unit].map(String::from).to_vec();
            cells.extend(values.iter().map(|value| value.map(exact).unwrap_or_default()));
            file.write_record(&cells)?;
        }
    }
    file.flush()
}
