//! Equivalent stress of the pictures and VTU files.

/// Computes the von Mises stress from xx, yy, zz, yz, zx, xy.
pub fn von_mises([xx, yy, zz, yz, zx, xy]: [f64; 6]) -> f64 {
    let direct = (xx - yy).powi(2) + (yy - zz).powi(2) + (zz - xx).powi(2);
    (0.5 * direct + 3.0 * (yz * yz + zx * zx + xy * xy)).sqrt()
}
