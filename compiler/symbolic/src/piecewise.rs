//! Interpolation tables: piecewise cubic polynomials of one expression.
//!
//! The derivative of a table is a table, with the coefficients of the derivative; it is created
//! when it is first needed. See [`calyx_abi::piecewise`] for the form of a table.

use crate::graph::{Graph, Node, NodeId};
use calyx_abi::piecewise::{derivative, piecewise};
use std::collections::HashMap;
use std::sync::Arc;

/// The tables of a graph. Equal tables are stored once.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tables {
    tables: Vec<Arc<[f64]>>,
    ids: HashMap<Vec<u64>, u32>,
}

impl Tables {
    fn id(&mut self, table: &[f64]) -> u32 {
        let bits = table.iter().map(|number| number.to_bits()).collect();
        let next = self.tables.len() as u32;
        let id = *self.ids.entry(bits).or_insert(next);
        if id == next {
            self.tables.push(table.into());
        }
        id
    }

    /// Returns a table by index.
    pub(crate) fn get(&self, id: u32) -> &Arc<[f64]> {
        &self.tables[id as usize]
    }
}

impl Graph {
    /// Returns the value of a table ([`calyx_abi::piecewise::is_table`]) at an expression.
    pub fn piecewise(&mut self, table: &[f64], x: NodeId) -> NodeId {
        let id = self.tables.id(table);
        self.piecewise_of(id, x)
    }

    pub(crate) fn piecewise_of(&mut self, table: u32, x: NodeId) -> NodeId {
        match self.constant_value(x) {
            Some(x) => {
                let value = piecewise(self.tables.get(table), x);
                self.constant(value)
            }
            None => self.intern(Node::Piecewise(table, x)),
        }
    }

    /// Returns the value of a registered table ([`calyx_abi::piecewise::registered`]), given by its
    /// number, or its derivative of an order below 4.
    pub fn lookup(&mut self, order: u8, table: NodeId, x: NodeId) -> NodeId {
        self.intern(Node::Lookup(order, table, x))
    }

    /// Returns the derivative of [`Graph::lookup`], given that of its argument. The number of the
    /// table is constant.
    pub(crate) fn lookup_derivative(&mut self, order: u8, table: NodeId, x: NodeId, dx: NodeId) -> NodeId {
        // The fourth derivative of a cubic vanishes.
        if self.is_zero(dx) || order >= 3 {
            return self.constant(0.0);
        }
        let slope = self.lookup(order + 1, table, x);
        self.multiply(slope, dx)
    }

    /// Returns the derivative of a table's value, given that of its argument.
    pub(crate) fn piecewise_derivative(&mut self, table: u32, x: NodeId, dx: NodeId) -> NodeId {
        if self.is_zero(dx) {
            return dx;
        }
        let slope = derivative(self.tables.get(table));
        // The coefficients follow the number of points and the points.
        let coefficients = slope.get(1 + slope.first().map_or(0, |count| *count as usize)..);
        if coefficients.is_none_or(|coefficients| coefficients.iter().all(|c| *c == 0.0)) {
            return self.constant(0.0);
        }
        let slope = self.piecewise(&slope, x);
        self.multiply(slope, dx)
    }
}
