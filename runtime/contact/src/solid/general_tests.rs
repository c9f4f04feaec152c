//! Tests of surfaces with coordinates of any kind, and of curved side faces.

use super::height_field::HeightField;
use super::test_surfaces::{HELICAL, Helicoid, Pair};
use super::transverse_approach::{closest_across, closest_between, closest_near};
use super::*;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use calyx_structure::Chart;
use calyx_structure::solid::{
    HalfSpaceBody, Mirror, SegmentLoad, SolidStructure, SurfaceSegment, SurfaceStress,
};
use calyx_structure::surface::{Surface, SurfacePoint};
use std::sync::Arc;

/// Helicoid in other coordinates: `v` is no length and runs backwards, and its lines are oblique.
struct Oblique(Helicoid);

impl Oblique {
    /// Returns the coordinates on the helicoid and their derivatives by both coordinates.
    fn place(&self, u: f64, v: f64) -> ([f64; 2], [[f64; 2]; 2]) {
        let z = -0.5 * self.0.v[1] * v * (1.0 + 0.2 * v);
        let slope = -0.5 * self.0.v[1] * (1.0 + 0.4 * v);
        ([u * (1.0 + 0.03 * v), z], [[1.0 + 0.03 * v, 0.0], [0.03 * u, slope]])
    }
}

impl Surface for Oblique {
    fn range(&self) -> [[f64; 2]; 2] {
        [self.0.u, [-1.5, 1.5]]
    }

    fn at(&self, u: f64, v: f64) -> SurfacePoint {
        let ([x, y], derivatives) = self.place(u, v);
        let point = self.0.at(x, y);
        let [a, b] = point.tangents;
        let along = |[p, q]: [f64; 2]| [0, 1, 2].map(|k| p * a[k] + q * b[k]);
        SurfacePoint { tangents: derivatives.map(along), ..point }
    }
}

/// The helicoid, declared as an extruded profile.
struct Extruded(Helicoid);

impl Surface for Extruded {
    fn range(&self) -> [[f64; 2]; 2] {
        self.0.range()
    }

    fn at(&self, u: f64, v: f64) -> SurfacePoint {
        self.0.at(u, v)
    }

    fn is_extruded(&self) -> bool {
        true
    }
}

#[test]
fn cells_have_the_length_of_the_surface_coordinate() {
    let (flanks, turns) = HELICAL.turned();
    let poses = [0.0, HELICAL.center()]
        .map(|x| Pose { origin: [x, 0.0, 0.0], ..Pose::IDENTITY })
        .into_iter()
        .zip(turns)
        .map(|(pose, turn)| pose.rotated_first(turn))
        .collect::<Vec<_>>();
    let (first, second) = (Oblique(flanks[0]), Extruded(flanks[1]));
    let placed = [
        PlacedSurface { surface: &first, pose: poses[0] },
        PlacedSurface { surface: &second, pose: poses[1] },
    ];
    let contact_line = find_contact_line(placed[0], placed[1], true).expect("they touch");
    let options = GridOptions {
        half_count: 2,
        half_slices: 8,
        size: GridSize { width: Some(4e-4), along: Some([-0.006, 0.006]) },
        force: 1000.0,
        contact_modulus: 1.1e11,
        search_edges: true,
        local_normals: false,
        under_load: false,
    };
    let grid = build_grid(placed[0], placed[1], &contact_line, &options, &Interrupt::never()).unwrap();
    assert_eq!(grid.cells.len(), 5 * 17);
    for cell in &grid.cells {
        assert_eq!(cell.spans[1], cell.axial[1]);
        let [u, v] = cell.places[0];
        let ends = [-0.5, 0.5].map(|part| first.place(u, v + part * cell.spans[0]).0[1]);
        let length = (ends[1] - ends[0]).abs();
        assert!((length / cell.axial[0] - 1.0).abs() < 2e-3, "{length} {}", cell.axial[0]);
        assert_eq!(cell.segment(0).length, cell.spans[0]);
    }
    // Cells of neighbouring slices join, also in the surface coordinate.
    for pair in grid.slices.windows(2) {
        let [one, next] = [&pair[0], &pair[1]].map(|slice| &grid.cells[slice.cells.start + 2]);
        let gap = (one.places[0][1] - next.places[0][1]).abs() - 0.5 * (one.spans[0] + next.spans[0]);
        assert!(gap.abs() < 1e-3 * one.spans[0], "{gap}");
    }
}

/// The search from a near minimum finds that of the search between the ends of both surfaces.
#[test]
fn minima_do_not_depend_on_where_their_search_starts() {
    let (flanks, turns) = Pair { crown: 3.0, ..HELICAL }.turned();
    let poses = [0, 1].map(|side: usize| {
        let origin = [[0.0, HELICAL.center()][side], 0.0, 0.0];
        Pose { origin, ..Pose::IDENTITY }.rotated_first(turns[side])
    });
    let placed = [0, 1].map(|side: usize| PlacedSurface { surface: &flanks[side], pose: poses[side] });
    let line = find_contact_line(placed[0], placed[1], true).expect("they face each other");
    let fields =
        [0, 1].map(|side: usize| HeightField::new(placed[side], line.frame, line.places[side], true));
    let first = closest_across(&fields, 0.0, line.places).expect("a minimum");
    let [low, high] = line.extent();
    for step in 0..=40 {
        let y = low + (high - low) * f64::from(step) / 40.0;
        let near = closest_near(&fields, y, &first);
        let far = closest_across(&fields, y, line.places);
        assert_eq!(near.is_some(), far.is_some(), "{y}");
        let (Some(near), Some(far)) = (near, far) else { continue };
        assert_eq!(near.end, far.end, "{y}");
        assert!((near.gap() - far.gap()).abs() < 1e-16, "{y}: {:e} {:e}", near.gap(), far.gap());
        assert!((near.at()[0] - far.at()[0]).abs() < 1e-13, "{y}: {:?} {:?}", near.at(), far.at());
    }
}

/// Searches from either side of the position where the minimum of the gap passes the end of a
/// surface agree with the search between the ends of both surfaces.
#[test]
fn ends_of_surfaces_do_not_depend_on_where_their_search_starts() {
    let (mut flanks, turns) = HELICAL.turned();
    // The first surface ends where the contact line crosses it.
    let middle = 0.5 * (flanks[0].u[0] + flanks[0].u[1]);
    for end in [0, 1] {
        flanks[0].u = HELICAL.turned().0[0].u;
        flanks[0].u[end] = middle;
        let poses = [0, 1].map(|side: usize| {
            let origin = [[0.0, HELICAL.center()][side], 0.0, 0.0];
            Pose { origin, ..Pose::IDENTITY }.rotated_first(turns[side])
        });
        let placed = [0, 1].map(|side: usize| PlacedSurface { surface: &flanks[side], pose: poses[side] });
        let line = find_contact_line(placed[0], placed[1], true).expect("they face each other");
        let fields =
            [0, 1].map(|side: usize| HeightField::new(placed[side], line.frame, line.places[side], true));
        let [low, high] = line.extent();
        let at = |part: f64| low + (high - low) * part;
        let across =
            |part: f64| closest_across(&fields, at(part), line.places).expect("they face each other");
        let all: Vec<_> = (1..40).map(|step| across(f64::from(step) / 40.0)).collect();
        let crossing = all.windows(2).position(|pair| pair[0].end.is_some() != pair[1].end.is_some());
        let crossing = crossing.expect("the contact line passes the end");
        let [one, other] = [&all[crossing], &all[crossing + 1]];
        let (inside, outside) = if one.end.is_none() { (one, other) } else { (other, one) };
        for step in 0..=40 {
            let y = at((crossing as f64 + 1.0 + f64::from(step) / 40.0) / 40.0);
            let expected = closest_across(&fields, y, inside.places()).expect("they face each other");
            let found = [
                closest_between(&fields, y, [inside, outside]),
                closest_near(&fields, y, inside),
                closest_near(&fields, y, outside),
            ];
            for found in found {
                let found = found.expect("they face each other");
                assert_eq!(found.end, expected.end, "{y}");
                assert!(
                    (found.gap() - expected.gap()).abs() < 1e-16,
                    "{y}: {:e} {:e}",
                    found.gap(),
                    expected.gap()
                );
                assert!((found.at()[0] - expected.at()[0]).abs() < 1e-13, "{y}");
            }
        }
    }
}

/// Half-space whose side faces depend on where they are met.
struct Cone(HalfSpaceBody);

fn faces(u: [f64; 2]) -> Vec<Mirror> {
    [(0, -1.0), (1, 1.0)]
        .map(|(side, sign)| {
            let lean = 0.3 + u[side];
            Mirror { point: [0.0, sign * 1.5e-3, 0.0], normal: [0.0, sign * lean.cos(), lean.sin()] }
        })
        .to_vec()
}

impl SolidStructure for Cone {
    fn surface(&self, surface: u32) -> Arc<dyn Surface> {
        self.0.surface(surface)
    }

    fn teeth(&self) -> u32 {
        1
    }

    fn surface_modulus(&self) -> f64 {
        self.0.surface_modulus()
    }

    fn mirrors(&self) -> &[Mirror] {
        &[]
    }

    fn side_faces(&self, _: u32, u: [f64; 2]) -> Vec<Mirror> {
        faces(u)
    }

    fn add_compliance_until(
        &self,
        _: Chart,
        _: &[SurfaceSegment],
        _: Chart,
        _: &[SurfaceSegment],
        _: &mut [f64],
        _: &Interrupt,
    ) -> Result<(), EngineError> {
        Ok(())
    }

    fn stresses(&self, _: u32, _: u32, _: &[SegmentLoad]) -> Vec<SurfaceStress> {
        Vec::new()
    }

    fn bytes(&self) -> usize {
        0
    }
}

#[test]
fn images_lie_in_the_side_face_where_the_patch_meets_it() {
    let frame = PatchFrame {
        point: [0.0; 3],
        normal: [0.0, 0.0, 1.0],
        across: [1.0, 0.0, 0.0],
        along: [0.0, 1.0, 0.0],
    };
    let cell = |k: f64| Cell {
        center: [1e-5 * k, 1e-3 * k],
        size: [1e-4, 1e-3],
        places: [[0.1 * k, k]; 2],
        loaded_at: [[0.1 * k, k]; 2],
        axial: [0.0; 2],
        spans: [1.0; 2],
        gap: 0.0,
        point: [0.0; 3],
        slope: [0.0; 2],
        edge: false,
    };
    let cells = [cell(0.0), cell(1.0), cell(-1.0)];
    let rigid = HalfSpaceBody::rigid(Vec::new(), 1);
    fn side(body: usize, structure: &dyn SolidStructure) -> Side<'_> {
        Side { body, structure, chart: Chart { tooth: 0, surface: 0 }, pose: Pose::IDENTITY }
    }
    let matrix = |structure: &dyn SolidStructure| {
        let sides = [side(0, &rigid as &dyn SolidStructure), side(1, structure)];
        compliance(
            &[PatchCells { sides, frame: &frame, cells: &cells, beside_faces: beside_faces(&cells) }],
            Entries::All,
            &Interrupt::never(),
        )
        .expect("a matrix")
    };
    let body = || HalfSpaceBody::half_space(Vec::new(), 1, 2e11);
    let found = matrix(&Cone(body()));
    assert_eq!(found, matrix(&body().between(faces([-0.1, 0.1]))));
    assert_ne!(found, matrix(&body().between(faces([0.0, 0.0]))));
    // Some of the cells have the same images.
    let cone = Cone(body());
    let sides = [side(0, &rigid as &dyn SolidStructure), side(1, &cone)];
    let part = PatchCells { sides, frame: &frame, cells: &cells[..2], beside_faces: beside_faces(&cells) };
    let part = compliance(&[part], Entries::All, &Interrupt::never()).expect("a matrix");
    assert_eq!(part, [found[0], found[1], found[3], found[4]]);
}
