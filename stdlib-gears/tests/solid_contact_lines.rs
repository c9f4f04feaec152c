//! Contact lines of exact flanks with tip edges in three dimensions: from before a tooth pair
//! enters contact to after it has left.

use crate::common::pair::{PLAIN, PairOptions, pair};
use crate::common::{INCH, chapter_5};
use calyx_gears::external::ExternalGear;
use calyx_gears::fillet::Side;
use calyx_gears::flank::Flank;
use calyx_gears::gear_surface::GearSurface;
use calyx_gears::modification::{LeadModification, Modification, ReliefShape};
use calyx_runtime::contact::solid::{
    Grid, GridOptions, GridSize, PlacedSurface, Pose, build_grid, find_contact_line,
};
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::motion::spatial_pose;
use calyx_runtime::scene::GearMesh;
use std::f64::consts::TAU;
use std::sync::Arc;

const FACE: f64 = INCH;

fn surface(gear: &ExternalGear, relief: &[Modification], twist: f64, crown: f64) -> GearSurface {
    let flank = |modifications: &[Modification]| {
        Arc::new(Flank::new(gear, modifications, Side::CounterClockwise).expect("a flank"))
    };
    GearSurface::new(
        flank(&[]),
        flank(relief),
        FACE,
        twist,
        LeadModification { crown, ..LeadModification::default() },
    )
}

/// Flanks of the entering tooth pair of the chapter 5 pair, and their poses at fractions of the
/// mesh cycle.
struct EnteringPair {
    flanks: [GearSurface; 2],
    mesh: GearMesh,
    poses: Box<dyn Fn(f64) -> [Pose; 2]>,
}

/// `twist` of the first gear, rad/m; that of the second gear is opposite.
fn meeting(twist: f64, relief: f64, crown: f64) -> EnteringPair {
    let (scene, mesh) = pair(&PairOptions::chapter_5(&PLAIN));
    let modifications: Vec<Modification> = (relief > 0.0)
        .then(|| Modification::tip_relief(relief, 27.25_f64.to_radians(), ReliefShape::Quadratic))
        .into_iter()
        .collect();
    let flanks = [
        surface(&chapter_5(20), &modifications, twist, crown),
        surface(&chapter_5(40), &[], -0.5 * twist, crown),
    ];
    let (teeth, entering, start, period) = (mesh.teeth, mesh.entering, mesh.start, mesh.period);
    let poses = move |cycle: f64| {
        [0, 1].map(|side: usize| {
            let body = &scene.bodies[side];
            let frame = spatial_pose(body.motion.as_ref(), start + cycle * period).expect("a frame");
            frame.rotated_first(body.phase + TAU * f64::from(entering[side]) / f64::from(teeth[side]))
        })
    };
    EnteringPair { flanks, mesh, poses: Box::new(poses) }
}

impl EnteringPair {
    fn placed(&self, cycle: f64) -> [PlacedSurface<'_>; 2] {
        let poses = (self.poses)(cycle);
        [0, 1].map(|side: usize| PlacedSurface { surface: &self.flanks[side], pose: poses[side] })
    }

    /// Fraction of the cycle at which the pair would leave contact as a spur pair (contact ratio).
    fn leaves(&self) -> f64 {
        (self.mesh.path[1] - self.mesh.path[0]) / (self.mesh.roll[1] - self.mesh.roll[0]).abs()
    }
}

fn options() -> GridOptions {
    GridOptions {
        half_count: 8,
        half_slices: 10,
        size: GridSize::default(),
        force: 30e3,
        contact_modulus: 1.1e11,
        search_edges: true,
        local_normals: false,
        under_load: false,
    }
}

/// Slices that no surface ends reach as far as the width of their grid says, also beyond edges.
fn slices_have_the_width_of_their_grid(grid: &Grid) {
    for slice in &grid.slices {
        let cells = &grid.cells[slice.cells.clone()];
        let ends = [cells[0].ends(0)[0], cells[cells.len() - 1].ends(0)[1]];
        for (end, _) in ends.iter().zip(slice.surface_ends).filter(|(_, ended)| !ended) {
            let width = slice.width_to_reach(*end);
            assert!((width / grid.width - 1.0).abs() < 1e-9, "{width} of {}: {slice:?}", grid.width);
        }
    }
}

#[test]
fn spur_flanks_touch_along_their_face_from_entering_to_leaving() {
    let meeting = meeting(0.0, 0.0, 0.0);
    let last = meeting.leaves();
    for step in -6..=36 {
        let cycle = last * f64::from(step) / 30.0;
        let [first, second] = meeting.placed(cycle);
        let contact_line =
            find_contact_line(first, second, true).unwrap_or_else(|| panic!("no ridge at {cycle}"));
        // Near its ends the path extends onto a rounded tip edge.
        let margin = 0.02;
        if (margin..=last - margin).contains(&cycle) {
            assert!(contact_line.gap.abs() < 1e-12, "{cycle}: {:e}", contact_line.gap);
        } else if cycle < -margin || cycle > last + margin {
            assert!(contact_line.gap > 1e-7, "{cycle}: {:e}", contact_line.gap);
        }
        let [low, high] = contact_line.extent();
        assert!(((high - low) / FACE - 1.0).abs() < 1e-9, "{cycle}: {}", high - low);
        // The gap is uniform along the face.
        let gaps = || contact_line.points.iter().map(|point| point.gap);
        let spread = gaps().fold(0.0f64, f64::max) - gaps().fold(f64::INFINITY, f64::min);
        assert!(spread < 1e-12, "{cycle}: {spread:e}");
        let grid = build_grid(first, second, &contact_line, &options(), &Interrupt::never()).unwrap();
        assert_eq!(grid.slices.len(), 21, "{cycle}");
        slices_have_the_width_of_their_grid(&grid);
        let area: f64 = grid.cells.iter().map(|cell| cell.area()).sum();
        assert!(area > 0.0 && grid.cells.iter().all(|cell| cell.gap > contact_line.gap - 1e-12), "{cycle}");
    }
}

#[test]
fn helical_flanks_enter_at_one_face_and_leave_at_the_other() {
    for (twist, relief, crown) in [(7.0, 0.0, 0.0), (-14.0, 0.0, 0.0), (7.0, 1e-5, 8e-6)] {
        let meeting = meeting(twist, relief, crown);
        let exact = relief == 0.0 && crown == 0.0;
        // With a twist, a tooth enters earlier and leaves later by the angle of twist times face
        // width.
        let overlap = twist.abs() * FACE * 20.0 / TAU;
        let (from, to) = (-0.5 * overlap, meeting.leaves() + 0.5 * overlap);
        let mut touched = Vec::new();
        for step in 0..=40 {
            let cycle = from - 0.1 + (to - from + 0.2) * f64::from(step) / 40.0;
            let [first, second] = meeting.placed(cycle);
            let contact_line =
                find_contact_line(first, second, true).unwrap_or_else(|| panic!("no ridge at {cycle}"));
            let inside = cycle > from + 0.02 && cycle < to - 0.02;
            if exact {
                let outside = cycle < from - 0.02 || cycle > to + 0.02;
                assert!(!inside || contact_line.gap.abs() < 1e-9, "{twist} {cycle}: {:e}", contact_line.gap);
                assert!(!outside || contact_line.gap > 1e-8, "{twist} {cycle}: {:e}", contact_line.gap);
            }
            if inside {
                touched.push(contact_line.frame.point[2]);
                let grid = build_grid(first, second, &contact_line, &options(), &Interrupt::never()).unwrap();
                assert!(!grid.cells.is_empty(), "{twist} {cycle}");
                slices_have_the_width_of_their_grid(&grid);
                let least = grid.cells.iter().map(|cell| cell.gap).fold(f64::INFINITY, f64::min);
                assert!(
                    least > contact_line.gap - 1e-10,
                    "{twist} {cycle}: {least:e} {:e}",
                    contact_line.gap
                );
                assert!(least < contact_line.gap + 2e-6, "{twist} {cycle}: {least:e} {:e}", contact_line.gap);
            }
        }
        // The middle of the contact line moves from one side face to the other.
        let (first, last) = (touched[0], touched[touched.len() - 1]);
        assert!(first * last < 0.0 && (first - last).abs() > 0.5 * FACE, "{twist}: {first} {last}");
    }
}
