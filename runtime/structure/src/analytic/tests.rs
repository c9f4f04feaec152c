//! Analytic tooth compliance against closed forms: Timoshenko's beam and Weber's depth under
//! Hertz's pressure. The ring (a half-plane, a layer, published displacements) and the slices of a
//! face have tests in their own modules.

use super::*;
use crate::half_plane::HalfPlane;
use crate::profile::ProfilePoint;
use nalgebra::DMatrix;

/// A side of a tooth of even depth.
pub(super) struct Slab {
    pub from: f64,
    pub length: f64,
    pub half: f64,
    pub side: f64,
}

impl Profile for Slab {
    fn length(&self) -> f64 {
        self.length
    }

    fn at(&self, s: f64) -> ProfilePoint {
        ProfilePoint {
            position: [self.from + s, self.side * self.half],
            tangent: [1.0, 0.0],
            normal: [0.0, self.side],
            curvature: 0.0,
        }
    }
}

/// 20 teeth of height 1 and thickness 0.6 on a ring of radius 10 that is fixed at another radius.
/// Lengths are in units of `unit` m.
fn slabs(constrained: f64, unit: f64, material: Material) -> AnalyticStructure {
    let shape = RingShape {
        radius: 10.0 * unit,
        fixed_radius: constrained * unit,
        half_arc: 0.05,
        lean: 1.0,
        sectors: 20,
    };
    let (from, half) = (shape.root(), 0.3 * unit);
    let flank = |side| Arc::new(Slab { from, length: unit, half, side }) as Arc<dyn Profile>;
    let depths = (0..=10).map(|k| [0.1 * unit * f64::from(k), half]).collect();
    let shape = ToothShape { sense: 1.0, depths, ring: shape, section: None };
    AnalyticStructure::new(vec![flank(1.0), flank(-1.0)], &shape, material, Plane::Strain)
}

const FLANK: Chart = Chart { tooth: 4, surface: 0 };

fn compliance(of: &AnalyticStructure, one: (Chart, f64), other: (Chart, f64)) -> f64 {
    let mut block = [0.0];
    of.add_compliance(one.0, &[one.1], other.0, &[other.1], &mut block);
    block[0]
}

#[test]
fn on_a_rigid_ring_it_is_timoshenkos_beam_and_the_depth_beneath_the_load() {
    let body = slabs(10.0 * (1.0 - 1e-9), 1e-3, Material::STEEL);
    let [low, high] = [0.4e-3, 0.9e-3];
    let (e, g, depth) = (206e9 / 0.91, 206e9 / 2.6, 0.6e-3f64);
    let inertia = depth.powi(3) / 12.0;
    let bent = low * low * (3.0 * high - low) / (6.0 * e * inertia) + 1.2 * low / (g * depth);
    let reach = 0.3e-3 * (-0.5f64 / 0.7).exp();
    let near = ((0.25e-6 + reach * reach) / (reach * reach)).ln() / (PI * e);
    let given = compliance(&body, (FLANK, low), (FLANK, high));
    assert!((given / (bent + near) - 1.0).abs() < 1e-6, "{given} {bent} {near}");
    // The other side of the tooth is pushed the other way, and has no half-plane with this one.
    let back = Chart { surface: 1, ..FLANK };
    let through = compliance(&body, (back, low), (FLANK, high));
    assert!((through / -bent - 1.0).abs() < 1e-6, "{through}");
}

/// Inclined plate under a uniform load along its edge. Its depth and the force are those in the
/// normal section, and the load acts along the longer edge. The deflection along the direction of
/// the load exceeds that in the normal section.
#[test]
fn a_leaning_tooth_is_a_plate_of_its_own_depth() {
    let (lean, half, at) = (0.8, 0.3e-3, 0.9e-3);
    let ring = RingShape { radius: 10e-3, fixed_radius: 8e-3, half_arc: 0.05, lean, sectors: 20 };
    let slab = Slab { from: ring.root(), length: 1e-3, half, side: 1.0 };
    let depths = (0..=10).map(|k| [0.1e-3 * f64::from(k), lean * half]).collect();
    let section = CriticalSection {
        at: 0.1e-3,
        chord: 2.0 * lean * half,
        notch_radius: 0.2e-3,
        s: 0.0,
        position: [0.0; 2],
    };
    let shape = ToothShape { sense: 1.0, depths, ring, section: Some(section) };
    let tooth = Tooth::new(&shape, Material::STEEL, Plane::Strain);
    let local = tooth.local(&slab, at);
    let (e, g, depth) = (206e9 / 0.91, 206e9 / 2.6, 2.0 * lean * half);
    // A force of 1 N per length along the face is 1 / lean in the normal section, on 1 / lean of
    // the length.
    let [force, length] = [1.0 / lean; 2];
    let given = 4.0 * at.powi(3) / (e * depth.powi(3)) + 1.2 * at / (g * depth);
    let expected = force / length * given / lean;
    let found = tooth.between(&local, &local);
    assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
    let (arm, chord, notch) = (0.8e-3, depth, 0.2e-3);
    let (slender, sharp): (f64, f64) = (chord / arm, chord / (2.0 * notch));
    let correction = (1.2 + 0.13 * slender) * sharp.powf(1.0 / (1.21 + 2.3 / slender));
    let expected = correction * 6.0 * (force / length) * arm / (chord * chord);
    let found = tooth.stress(&section, &local, 1.0);
    assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
}

/// Weber: under a Hertzian pressure of width 2 b, the surface approaches a point at depth h by `2 q
/// / (pi E') (ln(2 h / b) - nu / (2 (1 - nu)))`.
#[test]
fn under_hertzs_pressure_it_gives_as_weber_found() {
    let body = slabs(5.0, 1e-3, Material::STEEL);
    let half_plane =
        HalfPlane { surface_modulus: body.surface_modulus(), reference_length: body.reference_length() };
    let (middle, b, cells) = (0.5e-3, 0.01e-3, 401);
    let end = |k: usize| middle + b * (2.0 * k as f64 / cells as f64 - 1.0);
    let at_middle = [end(cells / 2), end(cells / 2 + 1)];
    let local = |s: f64| body.tooth.local(body.surfaces[0].as_ref(), s);
    let mut given = 0.0;
    for k in 0..cells {
        let cell = [end(k), end(k + 1)];
        let part = |s: f64| {
            let x: f64 = ((s - middle) / b).clamp(-1.0, 1.0);
            (x.asin() + x * (1.0 - x * x).sqrt()) / PI
        };
        let place = 0.5 * (cell[0] + cell[1]);
        let near = body.tooth.near(&local(middle), &local(place), body.reference_length());
        given += (part(cell[1]) - part(cell[0])) * (half_plane.cell_compliance(at_middle, cell) + near);
    }
    let weber = 2.0 / (PI * body.surface_modulus()) * ((2.0f64 * 0.3e-3 / b).ln() - 0.3 / 1.4);
    assert!((given / weber - 1.0).abs() < 2e-4, "{given} {weber}");
}

/// The compliance is symmetric to the bit for every pair of points on flanks of near teeth, and
/// positive semidefinite.
#[test]
fn it_is_reciprocal_to_the_bit_and_positive() {
    let body = slabs(8.0, 1e-3, Material::STEEL);
    let places: Vec<(Chart, f64)> = (0..4)
        .flat_map(|tooth| (0..2).map(move |surface| Chart { tooth: (19 + tooth) % 20, surface }))
        .flat_map(|chart| [0.3e-3, 0.6e-3, 0.95e-3].map(|s| (chart, s)))
        .collect();
    for &one in &places {
        for &other in &places {
            let [there, back] = [compliance(&body, one, other), compliance(&body, other, one)];
            assert_eq!(there.to_bits(), back.to_bits(), "{one:?} {other:?}");
        }
    }
    // With half-planes of cells a hundredth of a millimetre wide.
    let half_plane =
        HalfPlane { surface_modulus: body.surface_modulus(), reference_length: body.reference_length() };
    let cell = |s: f64| [s - 5e-6, s + 5e-6];
    let matrix = DMatrix::from_fn(places.len(), places.len(), |i, j| {
        let near = if places[i].0 == places[j].0 {
            half_plane.cell_compliance(cell(places[i].1), cell(places[j].1))
        } else {
            0.0
        };
        compliance(&body, places[i], places[j]) + near
    });
    assert!(matrix.cholesky().is_some());
}

/// The compliance of a plane model has the unit of an inverse modulus: it does not depend on
/// lengths and is inverse to the modulus.
#[test]
fn units_do_not_matter() {
    let steel = slabs(8.0, 1e-3, Material::STEEL);
    let softer = Material { youngs_modulus: 206e9 / 3.0, ..Material::STEEL };
    let large = slabs(8.0, 0.254, softer);
    let neighbour = Chart { tooth: 5, surface: 1 };
    for (one, other) in [(FLANK, FLANK), (FLANK, neighbour)] {
        let small = compliance(&steel, (one, 0.4e-3), (other, 0.8e-3));
        let large = compliance(&large, (one, 0.4 * 0.254), (other, 0.8 * 0.254));
        assert!((large / (3.0 * small) - 1.0).abs() < 1e-11, "{large} {small}");
    }
}
