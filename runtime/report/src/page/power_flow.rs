//! Section "Power flow": the rotors of a gear train and the power through its connections, as a
//! diagram and as tables.

use super::number;
use super::read::Run;
use crate::directory::POWER_FLOW;
use maud::{Markup, PreEscaped, html};
use serde_json::Value;
use std::collections::{BTreeMap, VecDeque};
use std::f64::consts::TAU;

/// Size of the box of a rotor, px.
const BOX: [f64; 2] = [150.0, 58.0];
/// Distances of columns and rows, px.
const SPACING: [f64; 2] = [310.0, 104.0];
/// Margin for the arrows of external power, px.
const MARGIN: f64 = 90.0;
/// Length of these arrows, px.
const ARROW: f64 = 70.0;
/// Width of the line of the largest power, and of the smallest, px.
const WIDTHS: [f64; 2] = [14.0, 1.5];
/// Number of letters of a connection's name that fit between two boxes.
const LONGEST_NAME: usize = 26;
/// Number of letters of a rotor's name above which it is written smaller.
const LONG_NAME: usize = 18;
/// Fraction of the largest power below which no power is drawn: rounding.
const NO_POWER: f64 = 1e-9;

/// Rotor of the diagram.
struct Rotor<'a> {
    name: &'a str,
    carrier: &'a str,
    /// Speed, rad/s.
    speed: f64,
    /// External torque, N m.
    torque: f64,
}

impl Rotor<'_> {
    /// External power, W.
    fn power(&self) -> f64 {
        self.speed * self.torque
    }
}

/// Connection of two rotors, by their indices.
struct Connection<'a> {
    name: &'a str,
    kind: &'a str,
    rotors: [usize; 2],
    /// Power from the first to the second rotor in ground coordinates before losses, W; `None` if
    /// it is unknown.
    power: Option<f64>,
    /// Power loss, W.
    loss: f64,
    /// True if the power depends on the stiffness of a closed loop.
    is_assumed: bool,
}

/// Gear train of a run.
struct Train<'a> {
    rotors: Vec<Rotor<'a>>,
    connections: Vec<Connection<'a>>,
}

/// Returns the section; empty without a gear train.
pub fn section(run: &Run) -> Markup {
    let trains: Vec<Train<'_>> = items(&run.head[POWER_FLOW]).map(train).collect();
    if trains.is_empty() {
        return PreEscaped(String::new());
    }
    html! {
        p.note {
            "By the numbers of teeth. Lines are as wide as the power in ground coordinates; "
            "arrows at the left and right are external power. The power of dashed lines depends on the stiffness of teeth and shafts; "
            "it is shown for equal planets and paths."
        }
        @for train in &trains { (diagram(train)) (tables(train)) }
    }
}

fn items(value: &Value) -> impl Iterator<Item = &Value> {
    value.as_array().into_iter().flatten()
}

fn train(value: &Value) -> Train<'_> {
    let rotors: Vec<Rotor<'_>> = items(&value["rotors"])
        .map(|rotor| Rotor {
            name: rotor["name"].as_str().unwrap_or_default(),
            carrier: rotor["carrier"].as_str().unwrap_or_default(),
            speed: rotor["speed"].as_f64().unwrap_or(f64::NAN),
            torque: rotor["torque"].as_f64().unwrap_or(f64::NAN),
        })
        .collect();
    let index = |name: &Value| rotors.iter().position(|rotor| Some(rotor.name) == name.as_str());
    let connections = items(&value["connections"]).filter_map(|connection| {
        Some(Connection {
            name: connection["name"].as_str().unwrap_or_default(),
            kind: connection["kind"].as_str().unwrap_or_default(),
            rotors: [index(&connection["rotors"][0])?, index(&connection["rotors"][1])?],
            power: connection["power"].as_f64(),
            loss: connection["loss"].as_f64().unwrap_or(0.0),
            is_assumed: connection["assumed"].as_bool().unwrap_or(false),
        })
    });
    let connections = connections.collect();
    Train { connections, rotors }
}

/// Returns column and row of each rotor: rotors that supply power are in the first column, and each
/// other one is next to the nearest of them along the connections and carriers.
fn places(train: &Train<'_>) -> Vec<[usize; 2]> {
    let count = train.rotors.len();
    let largest = train.rotors.iter().map(|rotor| rotor.power().abs()).fold(0.0, f64::max);
    let mut neighbours = vec![Vec::new(); count];
    for Connection { rotors: [first, second], .. } in &train.connections {
        neighbours[*first].push(*second);
        neighbours[*second].push(*first);
    }
    for (index, rotor) in train.rotors.iter().enumerate() {
        if let Some(carrier) = train.rotors.iter().position(|other| other.name == rotor.carrier) {
            neighbours[index].push(carrier);
            neighbours[carrier].push(index);
        }
    }
    let mut columns: Vec<Option<usize>> =
        train.rotors.iter().map(|rotor| (rotor.power() > NO_POWER * largest).then_some(0)).collect();
    let mut front: VecDeque<usize> = (0..count).filter(|&index| columns[index].is_some()).collect();
    loop {
        while let Some(index) = front.pop_front() {
            for &next in &neighbours[index] {
                if columns[next].is_none() {
                    columns[next] = columns[index].map(|column| column + 1);
                    front.push_back(next);
                }
            }
        }
        // A part without any supply begins at its first rotor.
        let Some(rest) = columns.iter().position(Option::is_none) else { break };
        columns[rest] = Some(0);
        front.push_back(rest);
    }
    let mut rows: BTreeMap<usize, usize> = BTreeMap::new();
    let mut place = |column: usize| {
        let row = rows.entry(column).or_default();
        *row += 1;
        [column, *row - 1]
    };
    columns.into_iter().map(|column| place(column.unwrap_or(0))).collect()
}

fn diagram(train: &Train<'_>) -> Markup {
    let places = places(train);
    let columns = places.iter().map(|place| place[0] + 1).max().unwrap_or(1);
    let rows = places.iter().map(|place| place[1] + 1).max().unwrap_or(1);
    let in_column = |column: usize| places.iter().filter(|place| place[0] == column).count();
    // Columns are centred.
    let at = |index: usize| {
        let [column, row] = places[index];
        let above = 0.5 * (rows - in_column(column)) as f64;
        [
            MARGIN + 0.5 * BOX[0] + SPACING[0] * column as f64,
            0.5 * SPACING[1] + SPACING[1] * (row as f64 + above),
        ]
    };
    let size = [2.0 * MARGIN + BOX[0] + SPACING[0] * (columns - 1) as f64, SPACING[1] * rows as f64];
    let external = train.rotors.iter().map(Rotor::power);
    let internal = train.connections.iter().filter_map(|connection| connection.power);
    let largest = external.chain(internal).map(f64::abs).fold(0.0, f64::max);
    let width = |power: f64| WIDTHS[1] + (WIDTHS[0] - WIDTHS[1]) * (power.abs() / largest).min(1.0);
    let svg = html! {
        svg viewBox={ "0 0 " (size[0]) " " (size[1]) } role="img" aria-label="Power flow between the rotors" style={ "max-width:" (size[0]) "px" } {
            @for (index, connection) in train.connections.iter().enumerate() {
                (line(connection, connection.rotors.map(at), index, largest, width))
            }
            @for (index, rotor) in train.rotors.iter().enumerate() {
                (external_power(rotor, at(index), largest, width))
                (rotor_box(rotor, at(index)))
            }
        }
    };
    html! { figure { (svg) figcaption { "Power flow between the rotors" } } }
}

fn line(
    connection: &Connection<'_>,
    [from, to]: [[f64; 2]; 2],
    index: usize,
    largest: f64,
    width: impl Fn(f64) -> f64,
) -> Markup {
    let power = connection.power.filter(|power| power.abs() > NO_POWER * largest);
    let (from, to) = if power.is_some_and(|power| power < 0.0) { (to, from) } else { (from, to) };
    // An arc to the right of a column joins two of its rotors; a line joins those of two columns.
    let same = (to[0] - from[0]).abs() < 1.0;
    let side = if same { 1.0 } else { (to[0] - from[0]).signum() };
    let ends = [
        [from[0] + 0.5 * side * BOX[0], from[1]],
        [to[0] + if same { 0.5 } else { -0.5 * side } * BOX[0], to[1]],
    ];
    let bend = if same { 70.0 } else { 0.5 * (ends[1][0] - ends[0][0]) };
    let controls =
        [[ends[0][0] + bend, ends[0][1]], [ends[1][0] + if same { bend } else { -bend }, ends[1][1]]];
    // Labels of parallel lines are at different places.
    let part = 0.5 + 0.1 * ((index as f64 * 0.382 * TAU).sin());
    let label = bezier([ends[0], controls[0], controls[1], ends[1]], part);
    let [[x0, y0], [x3, y3]] = ends;
    let [[x1, y1], [x2, y2]] = controls;
    let path = format!("M{x0:.1} {y0:.1}C{x1:.1} {y1:.1} {x2:.1} {y2:.1} {x3:.1} {y3:.1}");
    html! {
        path d=(path) fill="none" stroke="#1F5FA8" stroke-opacity="0.45"
            stroke-width=(power.map_or(WIDTHS[1], &width))
            stroke-dasharray=[(connection.is_assumed || power.is_none()).then_some("6 4")] {
            title { (connection.name) }
        }
        @if power.is_some() { (arrow_head([x3, y3], if same { -1.0 } else { side })) }
        @if let Some(power) = power {
            text x=(label[0]) y=(label[1] - 4.0) text-anchor="middle" font-size="12" fill="#000000" {
                @if connection.is_assumed { "≈ " }
                (number(power.abs() * 1e-3)) " kW"
            }
            text x=(label[0]) y=(label[1] + 12.0) text-anchor="middle" font-size="11" fill="#000000" fill-opacity="0.65" {
                (clipped(connection.name))
            }
        }
    }
}

/// Name that fits between two boxes.
fn clipped(name: &str) -> String {
    match name.chars().count() > LONGEST_NAME {
        true => name.chars().take(LONGEST_NAME - 1).chain(['…']).collect(),
        false => name.to_owned(),
    }
}

fn bezier(points: [[f64; 2]; 4], t: f64) -> [f64; 2] {
    let weights = [(1.0 - t).powi(3), 3.0 * t * (1.0 - t).powi(2), 3.0 * t * t * (1.0 - t), t.powi(3)];
    [0, 1].map(|k: usize| points.iter().zip(weights).map(|(point, weight)| weight * point[k]).sum())
}

/// Arrow head that ends at a point, pointing to the right (1) or to the left (-1).
fn arrow_head([x, y]: [f64; 2], side: f64) -> Markup {
    let back = x - 12.0 * side;
    html! {
        polygon points=(format!("{x:.1},{y:.1} {back:.1},{:.1} {back:.1},{:.1}", y - 7.0, y + 7.0)) fill="#1F5FA8" {}
    }
}

/// External power of a rotor: supplied from the left, delivered to the right.
fn external_power(rotor: &Rotor<'_>, [x, y]: [f64; 2], largest: f64, width: impl Fn(f64) -> f64) -> Markup {
    let power = rotor.power();
    if power.is_nan() || power.abs() <= NO_POWER * largest {
        return PreEscaped(String::new());
    }
    // Along the upper edge of the box, apart from the lines of the connections.
    let y = y - 0.3 * BOX[1];
    let (from, to) = match power > 0.0 {
        true => (x - 0.5 * BOX[0] - ARROW, x - 0.5 * BOX[0]),
        false => (x + 0.5 * BOX[0], x + 0.5 * BOX[0] + ARROW),
    };
    html! {
        line x1=(from) y1=(y) x2=(to - 6.0) y2=(y) stroke="#268756" stroke-opacity="0.6" stroke-width=(width(power)) {}
        polygon points=(format!("{to:.1},{y:.1} {:.1},{:.1} {:.1},{:.1}", to - 12.0, y - 7.0, to - 12.0, y + 7.0)) fill="#268756" {}
        text x=(0.5 * (from + to)) y=(y - 10.0) text-anchor="middle" font-size="12" fill="#000000" {
            (number(power.abs() * 1e-3)) " kW"
        }
    }
}

fn rotor_box(rotor: &Rotor<'_>, [x, y]: [f64; 2]) -> Markup {
    let [left, top] = [x - 0.5 * BOX[0], y - 0.5 * BOX[1]];
    html! {
        rect x=(left) y=(top) width=(BOX[0]) height=(BOX[1]) rx="6" style="fill:var(--card)" stroke="#000000" stroke-opacity="0.35" {}
        text x=(x) y=(y - 8.0) text-anchor="middle" font-size=(if rotor.name.chars().count() > LONG_NAME { "10" } else { "13" })
            font-weight="600" fill="#000000" { (rotor.name) }
        text x=(x) y=(y + 8.0) text-anchor="middle" font-size="12" fill="#000000" { (rpm(rotor.speed)) " rpm" }
        @if rotor.torque != 0.0 && rotor.torque.is_finite() {
            text x=(x) y=(y + 23.0) text-anchor="middle" font-size="12" fill="#000000" { (number(rotor.torque)) " N·m" }
        }
    }
}

fn rpm(speed: f64) -> String {
    number(speed * 60.0 / TAU)
}

fn tables(train: &Train<'_>) -> Markup {
    html! {
        table.numbers.data {
            thead { tr { th { "rotor" } th.word { "on" } th.value { "speed, rpm" } th.value { "external torque, N·m" } th.value { "external power, kW" } } }
            tbody { @for rotor in &train.rotors { tr {
                th scope="row" { (rotor.name) }
                td.word { @if rotor.carrier.is_empty() { "ground" } @else { (rotor.carrier) } }
                td.value { (rpm(rotor.speed)) }
                td.value { (number(rotor.torque)) }
                td.value { (number(rotor.power() * 1e-3 + 0.0)) }
            } } }
        }
        table.numbers.data {
            thead { tr { th { "connection" } th.word { "kind" } th.word { "from" } th.word { "to" } th.value { "power, kW" } th.value { "loss, kW" } } }
            tbody { @for connection in &train.connections {
                @let [first, second] = connection.rotors.map(|rotor| train.rotors[rotor].name);
                @let (from, to) = if connection.power.is_some_and(|power| power < 0.0) { (second, first) } else { (first, second) };
                tr {
                    th scope="row" { (connection.name) }
                    td.word { (connection.kind) }
                    td.word { (from) }
                    td.word { (to) }
                    td.value { @match connection.power { Some(power) => { @if connection.is_assumed { "≈ " } (number(power.abs() * 1e-3)) } None => { "unknown" } } }
                    td.value { (number(connection.loss * 1e-3)) }
                }
            } }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn countershaft() -> Value {
        json!({
            "rotors": [
                { "name": "output", "carrier": "", "speed": 50.0, "torque": -200.0 },
                { "name": "layshaft", "carrier": "", "speed": -60.0, "torque": 0.0 },
                { "name": "input", "carrier": "", "speed": 100.0, "torque": 100.0 },
            ],
            "connections": [
                { "name": "first", "kind": "external mesh", "rotors": ["layshaft", "input"], "power": -1e4, "loss": 0.0 },
                { "name": "second", "kind": "external mesh", "rotors": ["layshaft", "output"], "power": 4e3, "loss": 0.0, "assumed": true },
            ],
        })
    }

    #[test]
    fn rotors_follow_the_power_from_left_to_right() {
        let value = countershaft();
        assert_eq!(places(&train(&value)), [[2, 0], [1, 0], [0, 0]]);
    }

    #[test]
    fn parts_without_supply_are_placed_too() {
        let mut value = countershaft();
        value["connections"] = json!([]);
        assert_eq!(places(&train(&value)), [[0, 0], [0, 1], [0, 2]]);
    }

    #[test]
    fn powers_and_assumed_powers_are_shown() {
        let value = countershaft();
        let drawn = diagram(&train(&value)).into_string();
        assert!(
            drawn.contains("10 kW") && drawn.contains("≈ 4 kW") && drawn.contains("stroke-dasharray"),
            "{drawn}"
        );
        let listed = tables(&train(&value)).into_string();
        assert!(listed.contains("≈ 4") && listed.contains("954.9"), "{listed}");
    }
}
