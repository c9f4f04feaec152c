//! Outer surface of a shaft, for display.

use super::Shaft;
use calyx_structure::outer_surface::OuterSurface;

impl Shaft {
    /// Returns the outer surface with its bore, in the coordinates of the shaft.
    pub fn outer_surface(&self) -> OuterSurface {
        let section = |of: fn(&super::ShaftSegment) -> [f64; 2]| {
            let ends = self.ends.windows(2).zip(&self.segments);
            ends.flat_map(move |(ends, segment)| {
                let [start, end] = of(segment);
                [[ends[0], 0.5 * start], [ends[1], 0.5 * end]]
            })
        };
        let outside = section(|segment| segment.diameter);
        let bore: Vec<[f64; 2]> = section(|segment| segment.bore).collect();
        let mut polygon: Vec<[f64; 2]> = outside.chain(bore.into_iter().rev()).collect();
        polygon.dedup();
        OuterSurface::revolved(&polygon)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shaft::ShaftSegment;
    use calyx_fe::material::Material;

    /// A stepped shaft with a bore through its second segment only.
    #[test]
    fn the_surface_follows_steps_and_bores() {
        let segment = |diameter: f64, bore: f64| ShaftSegment {
            length: 0.1,
            diameter: [diameter; 2],
            bore: [bore; 2],
            stiffness_diameter: None,
        };
        let shaft = Shaft::new(vec![segment(0.04, 0.0), segment(0.06, 0.02)], Material::STEEL).unwrap();
        let surface = shaft.outer_surface();
        let radii_at = |z: f64| {
            let at = surface.points.iter().filter(|point| (point[2] - z).abs() < 1e-12);
            let mut radii: Vec<i64> = at.map(|[x, y, _]| (x.hypot(*y) * 1e6).round() as i64).collect();
            radii.sort_unstable();
            radii.dedup();
            radii
        };
        assert_eq!(radii_at(0.0), [0, 20_000]);
        assert_eq!(radii_at(0.1), [0, 10_000, 20_000, 30_000]);
        assert_eq!(radii_at(0.2), [10_000, 30_000]);
        assert_eq!(surface.copies, 1);
    }
}
