//! Points of interpolation along a line, of any order: equally spaced or Gauss-Lobatto points.

/// Returns `order + 1` equally spaced points of -1 ..= 1.
pub fn equispaced(order: u8) -> Vec<f64> {
    let order = i32::from(order);
    (0..=order).map(|node| f64::from(2 * node - order) / f64::from(order)).collect()
}

/// Returns the `order + 1` points of Gauss-Lobatto quadrature on -1 ..= 1, ascending: the ends, and
/// the zeros of the derivative of the Legendre polynomial. Interpolation on them does not oscillate
/// at any order.
pub fn lobatto(order: u8) -> Vec<f64> {
    let n = f64::from(order);
    let mut points = (0..=order)
        .map(|node| -(std::f64::consts::PI * f64::from(node) / n).cos())
        .map(|start| {
            let mut x: f64 = start;
            for _ in 0..50 {
                if x.abs() >= 1.0 {
                    break;
                }
                let (mut previous, mut value) = (1.0, x);
                for degree in 2..=order {
                    let k = f64::from(degree);
                    (previous, value) = (value, ((2.0 * k - 1.0) * x * value - (k - 1.0) * previous) / k);
                }
                // q = (1 - x²) P' = n (P_(n-1) - x P_n), and q' = -n (n + 1) P_n.
                let step = (previous - x * value) / ((n + 1.0) * value);
                x += step;
                if step.abs() < 1e-16 {
                    break;
                }
            }
            x
        })
        .collect::<Vec<_>>();
    // Make the points symmetric to the bit.
    let last = points.len() - 1;
    for index in 0..points.len() / 2 {
        let x = 0.5 * (points[last - index] - points[index]);
        (points[index], points[last - index]) = (-x, x);
    }
    if order.is_multiple_of(2) {
        points[usize::from(order) / 2] = 0.0;
    }
    points
}
