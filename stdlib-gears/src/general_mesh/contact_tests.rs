//! Tests of the contact of rigid flanks, on a pair of spiral bevel gears with flanks from tables.

use super::flank_contact::{Driver, FlankContact, Mate, flank_range, nearest, seen_from};
use crate::tabulated::surface::TabulatedSurface;
use crate::tabulated::test_teeth::Conical;
use crate::tabulated::tooth::Tooth;
use calyx_runtime::contact::solid::Pose;
use calyx_runtime::surface::{Surface, SurfacePoint};
use std::f64::consts::TAU;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

const TEETH: u32 = 15;
const MITER: Conical = Conical {
    teeth: TEETH,
    virtual_teeth: 21,
    tip_radius: 0.3,
    spiral: 15.0,
    lean: 0.02,
    upwards: false,
    face: 0.3,
};

/// Surface that counts its evaluations.
#[derive(Debug)]
struct Counted(TabulatedSurface, Arc<AtomicUsize>);

impl Surface for Counted {
    fn range(&self) -> [[f64; 2]; 2] {
        self.0.range()
    }
    fn at(&self, u: f64, v: f64) -> SurfacePoint {
        self.1.fetch_add(1, Ordering::Relaxed);
        self.0.at(u, v)
    }
    fn breaks(&self) -> &[f64] {
        self.0.breaks()
    }
    fn edge_from(&self) -> Option<f64> {
        self.0.edge_from()
    }
}

/// Flanks that touch, the first one at a rotation of its gear.
struct Pair {
    surfaces: [Counted; 2],
    evaluations: Arc<AtomicUsize>,
}

impl Pair {
    fn new() -> Pair {
        let evaluations = Arc::new(AtomicUsize::new(0));
        let surfaces = [MITER, Conical { spiral: -MITER.spiral, ..MITER }].map(|conical| {
            let stations = conical.table(9, 17).stations().expect("a table");
            let tooth = Arc::new(Tooth::new(&stations, None).expect("a tooth"));
            Counted(TabulatedSurface::new(tooth, 0), evaluations.clone())
        });
        Pair { surfaces, evaluations }
    }

    fn driver(&self, angle: f64) -> Driver<'_> {
        let (sine, cosine) = (2.0 * MITER.pitch_angle()).sin_cos();
        let level = Pose { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], origin: [0.0; 3] };
        let tilted = Pose { rotation: [[1.0, 0.0, 0.0], [0.0, cosine, sine], [0.0, -sine, cosine]], ..level };
        Driver { surface: &self.surfaces[0], pose: seen_from(&level.rotated_first(angle), &tilted) }
    }

    /// Contacts at rotations through mesh and far beyond its ends.
    fn contacts(&self) -> Vec<(f64, FlankContact)> {
        let mate = Mate::new(&self.surfaces[1]);
        let angles = (0..480).map(|k| f64::from(k) * TAU / 480.0);
        angles.filter_map(|angle| Some((angle, mate.contact(&self.driver(angle))?))).collect()
    }
}

/// At an edge, the contact is the extreme along the edge, also along that of the second flank.
#[test]
fn no_point_of_a_flank_is_ahead_of_its_contact() {
    let pair = Pair::new();
    let mate = Mate::new(&pair.surfaces[1]);
    let found = pair.contacts();
    let inside = found.iter().filter(|(_, contact)| contact.inside).count();
    assert!(inside > 5 && found.len() > inside + 20, "{inside} of {}", found.len());
    let range = flank_range(&pair.surfaces[0]);
    for (angle, contact) in found {
        let driver = pair.driver(angle);
        for i in 0..=60 {
            for j in 0..=60 {
                let part = [f64::from(i) / 60.0, f64::from(j) / 60.0];
                let place = [0, 1].map(|k: usize| range[k][0] + part[k] * (range[k][1] - range[k][0]));
                let Some(ray) = mate.ray_at(&driver, place, None) else { continue };
                let ahead = mate.pushed * (nearest(ray.rotation, contact.rotation, TAU) - contact.rotation);
                assert!(ahead < 1e-9, "angle {angle}: {ahead:e} at {part:?}, contact at {:?}", contact.place);
            }
        }
    }
}

/// The search over a flank and the iteration evaluate few points.
#[test]
fn a_contact_needs_few_points() {
    let pair = Pair::new();
    let samples = pair.evaluations.load(Ordering::Relaxed);
    let found = pair.contacts().len();
    let each = (pair.evaluations.load(Ordering::Relaxed) - samples) as f64 / found as f64;
    assert!(each < 900.0, "{each}");
}
