//! CSV layout of condensed bodies. Each row begins with its kind:
//!
//! ```text
//! # comment
//! node, NAME, X, Y, Z
//! stiffness, NODE, COMPONENT, NODE, COMPONENT, VALUE
//! mass, NODE, COMPONENT, NODE, COMPONENT, VALUE
//! ```
//!
//! Components are 1 to 3 for translations and 4 to 6 for rotations. An entry also states its
//! transpose. Rows `node` are needed only for positions.

use super::super::origin::Problem;
use super::super::source::{Place, lines};
use super::{CondensedNode, Dof, Entries, Parts, Result, assemble, entry_name};
use std::collections::HashMap;

#[derive(Default)]
struct Nodes {
    nodes: Vec<CondensedNode>,
    index: HashMap<String, usize>,
}

impl Nodes {
    fn index(&mut self, label: &str) -> usize {
        if let Some(known) = self.index.get(label) {
            return *known;
        }
        self.index.insert(label.to_owned(), self.nodes.len());
        self.nodes.push(CondensedNode { label: label.to_owned(), position: None });
        self.nodes.len() - 1
    }
}

/// Reads a condensed body from CSV text.
pub(super) fn read(text: &str) -> Result<Parts> {
    let mut nodes = Nodes::default();
    let mut stiffness = Entries { is_triangle: true, ..Entries::default() };
    let mut mass = Entries { is_triangle: true, ..Entries::default() };
    for (line, content) in lines(text) {
        let place = Place { file: 0, line };
        let content = content.trim_start_matches('\u{feff}').trim();
        if content.is_empty() || content.starts_with('#') {
            continue;
        }
        let values: Vec<&str> = content.split(',').map(|value| value.trim().trim_matches('"')).collect();
        let number = |at: usize| -> Result<f64> {
            let text = values.get(at).copied().unwrap_or_default();
            text.parse().ok().filter(|value: &f64| value.is_finite()).ok_or_else(|| {
                let message = format!("value {} of the row is `{text}`, but must be a number", at + 1);
                Problem::new(place, message, "correct the row")
            })
        };
        let count = match values[0] {
            "node" => 5,
            _ => 6,
        };
        if values.len() != count {
            let message = format!("the row has {} values, but needs {count}", values.len());
            return Err(Problem::new(place, message, "correct the row"));
        }
        let mut dof = |at: usize| -> Result<Dof> {
            match values[at + 1].parse() {
                Ok(component @ 1..=6) => Ok((nodes.index(values[at]), component - 1)),
                _ => {
                    let message = format!("`{}` is no component from 1 to 6", values[at + 1]);
                    Err(Problem::new(place, message, "correct the row"))
                }
            }
        };
        match values[0] {
            "node" => {
                let position = [number(2)?, number(3)?, number(4)?];
                let at = nodes.index(values[1]);
                if nodes.nodes[at].position.replace(position).is_some_and(|known| known != position) {
                    let message = format!("node {} has two positions", values[1]);
                    return Err(Problem::new(place, message, "state one position"));
                }
            }
            matrix @ ("stiffness" | "mass") => {
                let (row, column, value) = (dof(1)?, dof(3)?, number(5)?);
                let entries = if matrix == "mass" { &mut mass } else { &mut stiffness };
                let named =
                    || entry_name(&format!("the {matrix}"), (values[1], row.1), (values[3], column.1));
                entries.add(named, (row, column), value, place)?;
            }
            other => {
                let message = format!("`{other}` is no kind of row");
                return Err(Problem::new(place, message, "begin the row with node, stiffness or mass"));
            }
        }
    }
    let mass = (!mass.values.is_empty()).then_some(&mass);
    assemble(nodes.nodes, &stiffness, mass)
}
