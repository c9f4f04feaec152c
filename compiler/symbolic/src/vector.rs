//! Vectors and matrices of expressions.

use crate::graph::{Graph, NodeId};

/// Components along e1, e2, e3.
pub type Vector3 = [NodeId; 3];

/// Rows of a matrix.
pub type Matrix3 = [Vector3; 3];

impl Graph {
    pub fn zero_vector(&mut self) -> Vector3 {
        [self.constant(0.0); 3]
    }

    pub fn identity_matrix(&mut self) -> Matrix3 {
        let (zero, one) = (self.constant(0.0), self.constant(1.0));
        [[one, zero, zero], [zero, one, zero], [zero, zero, one]]
    }

    pub fn add_vectors(&mut self, a: Vector3, b: Vector3) -> Vector3 {
        [0, 1, 2].map(|i| self.add(a[i], b[i]))
    }

    pub fn subtract_vectors(&mut self, a: Vector3, b: Vector3) -> Vector3 {
        [0, 1, 2].map(|i| self.subtract(a[i], b[i]))
    }

    pub fn negate_vector(&mut self, a: Vector3) -> Vector3 {
        a.map(|component| self.negate(component))
    }

    pub fn scale_vector(&mut self, factor: NodeId, a: Vector3) -> Vector3 {
        a.map(|component| self.multiply(factor, component))
    }

    /// Returns `(a1 b1 + a2 b2) + a3 b3`, evaluated in this order.
    pub fn dot(&mut self, a: Vector3, b: Vector3) -> NodeId {
        let products = [0, 1, 2].map(|i| self.multiply(a[i], b[i]));
        let sum = self.add(products[0], products[1]);
        self.add(sum, products[2])
    }

    pub fn cross(&mut self, a: Vector3, b: Vector3) -> Vector3 {
        [(1, 2), (2, 0), (0, 1)].map(|(i, j)| {
            let (first, second) = (self.multiply(a[i], b[j]), self.multiply(a[j], b[i]));
            self.subtract(first, second)
        })
    }

    pub fn norm(&mut self, a: Vector3) -> NodeId {
        let square = self.dot(a, a);
        self.sqrt(square)
    }

    /// Returns the matrix times a column vector.
    pub fn transform(&mut self, matrix: Matrix3, a: Vector3) -> Vector3 {
        matrix.map(|row| self.dot(row, a))
    }

    pub fn multiply_matrices(&mut self, a: Matrix3, b: Matrix3) -> Matrix3 {
        let columns = transposed(b).map(|column| self.transform(a, column));
        transposed(columns)
    }

    /// Returns the derivative of each component with respect to a symbol.
    pub fn vector_derivative(&mut self, a: Vector3, symbol: u32) -> Vector3 {
        a.map(|component| self.derivative(component, symbol))
    }

    pub fn matrix_derivative(&mut self, a: Matrix3, symbol: u32) -> Matrix3 {
        a.map(|row| self.vector_derivative(row, symbol))
    }
}

pub(crate) fn transposed(a: Matrix3) -> Matrix3 {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| a[j][i]))
}
