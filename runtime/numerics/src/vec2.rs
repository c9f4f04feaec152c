//! Two-dimensional vectors as arrays of their components.

/// Components along x and y.
pub type Vector = [f64; 2];

/// Returns the scalar product.
pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// Returns the difference.
pub fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1]]
}

/// Returns the distance of two points.
pub fn distance(a: Vector, b: Vector) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}
