//! Rings on spline teeth with clearance: condensed rings against whole ones, and against spline
//! teeth that carry load in both directions.

use super::bodies::{STEEL, toothed_ring, toothed_sector};
use super::bore::{Direct, dot, force};
use super::lugs::{FOUR, PLANE_POINTS, Ring, SMALL, lug_form, plane_means};
use crate::bearing::Springs;
use crate::contact::active_set::solve;
use crate::contact::clarabel_check;
use crate::contact::problem::ContactProblem;
use crate::fe::{PlaneModel, SparseVector};
use crate::lug_contact::LugContact;
use crate::material::Plane;
use crate::structure::BoreHold;
use crate::structure::condense::Assembled;
use crate::structure::lugs::Lugs;
use faer::{Mat, MatRef};

const TEETH: u32 = 7;
/// Spline teeth as wide as the spaces between them, and as compliant as the ring.
const FIVE: Lugs = Lugs { count: 5, tangential: 0.5 / STEEL.youngs_modulus, ..FOUR };

fn loose(lugs: Lugs) -> BoreHold {
    BoreHold::LooseLugs { lugs, clearance: 0.0 }
}

/// The couplings of spline teeth with each other, with gear teeth and with stresses are those of
/// the whole mesh under the same tractions, with constrained rigid-body means only.
#[test]
fn lugs_move_as_on_the_whole_mesh() {
    let (sector, _) = toothed_sector(TEETH, 1.0, SMALL);
    let whole = PlaneModel::new(toothed_ring(TEETH, SMALL), STEEL, Plane::Strain);
    let ring = Ring::plane(&sector, loose(FIVE), TEETH, &PLANE_POINTS).unwrap();
    let means = plane_means(&whole, loose(FIVE), TEETH, TEETH);
    assert_eq!(means.held, 3);
    let equations = Assembled::plane(&whole);
    let held: Vec<SparseVector> = means.forms[..means.held].to_vec();
    let direct = Direct::new(&equations, &whole.rigid_body_modes(), &held);
    let form = |lug: usize| lug_form(&means, lug, equations.stiffness.nrows());
    let lugs = ring.coupling.loose.as_ref().unwrap();
    let scale = lugs.compliance[(0, 0)];
    let mut farthest = 0.0_f64;
    for loaded in 0..5 {
        let (displacement, _) = direct.solve(&form(loaded));
        for observed in 0..5 {
            let expected = dot(&form(observed), &displacement);
            let found = lugs.compliance[(observed, loaded)];
            assert!((found - expected).abs() < 1e-9 * scale, "lugs {observed} {loaded}: {found} {expected}");
            assert_eq!(found.to_bits(), lugs.compliance[(loaded, observed)].to_bits());
            farthest = if observed == loaded { farthest } else { farthest.max(found.abs()) };
        }
        let unit: Vec<f64> = (0..5).map(|lug| f64::from(u8::from(lug == loaded))).collect();
        for tooth in 0..TEETH {
            let angle = ring.coupling.pitch * f64::from(tooth);
            let unit = MatRef::from_column_major_slice(&unit, 5, 1);
            let by_rows = ring.coupling.stresses_by_lugs(0, tooth, unit).unwrap();
            for (point, &(at, along)) in PLANE_POINTS.iter().enumerate() {
                let expected = force(&equations, at, along, angle).dot(&displacement);
                let moved = ring.coupling.lug_displacements(tooth, &ring.felt(point))[(loaded, 0)];
                for found in [moved, by_rows[(point, 0)]] {
                    assert!((found - expected).abs() < 1e-9 * scale, "tooth {tooth}: {found} {expected}");
                }
            }
        }
    }
    assert!(farthest > 0.02 * scale, "lugs feel each other");
}

/// Whole ring: its equations, its rigid-body motions, and the displacements of spline teeth by
/// those of nodes.
struct Whole {
    equations: Assembled,
    motions: Vec<Vec<f64>>,
    lugs: Vec<Vec<f64>>,
}

impl Whole {
    fn new(lugs: Lugs) -> Self {
        let model = PlaneModel::new(toothed_ring(TEETH, SMALL), STEEL, Plane::Strain);
        let means = plane_means(&model, loose(lugs), TEETH, TEETH);
        let equations = Assembled::plane(&model);
        let size = equations.stiffness.nrows();
        let lugs = (0..usize::from(lugs.count)).map(|lug| lug_form(&means, lug, size)).collect();
        Self { equations, motions: model.rigid_body_modes().to_vec(), lugs }
    }
}

/// Returns the contact problem of a ring under loads on its teeth, supported only by its spline
/// teeth, whose lever arms are those of the mesh's bore.
fn problem(ring: &Ring, whole: &Whole, contact: &LugContact, loads: &[(usize, u32)]) -> ContactProblem {
    let lugs = ring.coupling.loose.as_ref().unwrap();
    let mut moved = Mat::<f64>::zeros(whole.lugs.len(), 1);
    let mut load = vec![0.0; 3];
    for &(point, tooth) in loads {
        moved += ring.coupling.lug_displacements(tooth, &ring.felt(point));
        let (at, along) = PLANE_POINTS[point];
        let on_nodes = force(&whole.equations, at, along, ring.coupling.pitch * f64::from(tooth));
        load.iter_mut().zip(&whole.motions).for_each(|(sum, motion)| *sum += on_nodes.dot(motion));
    }
    let mut springs = Springs::none(3);
    let half = 0.5 * contact.clearance;
    let gaps: Vec<f64> = contact.by_flanks(|lug| moved[(lug, 0)]).map(|growth| half + growth).collect();
    let by_motion: Vec<Vec<f64>> = whole
        .motions
        .iter()
        .map(|motion| contact.by_flanks(|lug| dot(&whole.lugs[lug], motion)).collect())
        .collect();
    let arms = (0..contact.flanks()).flat_map(|flank| by_motion.iter().map(move |arms| arms[flank]));
    springs.add_walls(&gaps, arms, &contact.compliance(Some(lugs.compliance.as_ref())));
    let empty = Vec::new;
    let nothing =
        ContactProblem { compliance: empty(), arms: empty(), gaps: empty(), stiffness: vec![0.0; 9], load };
    springs.behind(nothing, Mat::zeros(0, contact.flanks()).as_ref())
}

/// Under a load that presses every spline tooth in the same direction, the clearance rotates the
/// ring, and the rest is the same as on spline teeth that carry load in both directions. Under a
/// transverse load the forces agree with those of an interior-point solver.
#[test]
fn lugs_that_are_all_pressed_bear_as_lugs_without_play() {
    let (sector, _) = toothed_sector(TEETH, 1.0, SMALL);
    let all: Vec<(usize, u32)> = (0..TEETH).map(|tooth| (0, tooth)).collect();
    for lugs in [FIVE, Lugs { tangential: 0.0, ..FIVE }] {
        let whole = Whole::new(lugs);
        let ring = Ring::plane(&sector, loose(lugs), TEETH, &PLANE_POINTS).unwrap();
        let bound = Ring::plane(&sector, BoreHold::Lugs(lugs), TEETH, &PLANE_POINTS).unwrap();
        let agree = |found: &[f64], expected: &[f64], tolerance: f64| {
            let largest = expected.iter().fold(0.0_f64, |most, force| most.max(force.abs()));
            for (found, expected) in found.iter().zip(expected) {
                assert!((found - expected).abs() < tolerance * largest, "{found} {expected}");
            }
        };
        let mut expected = vec![0.0; whole.lugs.len()];
        for &load in &all {
            let forces = bound.lug_forces(load);
            expected.iter_mut().zip(forces).for_each(|(sum, force)| *sum += force.tangential);
        }
        let sense = expected[0].signum();
        assert!(expected.iter().all(|force| force * sense > 0.0), "{expected:?}");
        for clearance in [1e-13, 1e-11] {
            let contact = LugContact { lugs, clearance, radius: bore_radius(&sector) };
            let problem = problem(&ring, &whole, &contact, &all);
            let solution = solve(&problem, None).unwrap();
            assert!(solution.certificate.largest() < 1e-10, "{:?}", solution.certificate);
            agree(&contact.around(&solution.forces), &expected, 1e-9);
            // The mesh's bore is nearly a circle.
            let arms = contact.arms(0.0, [0.0; 2]).into_iter().flatten().collect();
            let round = solve(&ContactProblem { arms, ..problem }, None).unwrap();
            agree(&contact.around(&round.forces), &expected, 1e-5);
        }
        let contact =
            LugContact { lugs, clearance: 20.0 / STEEL.youngs_modulus, radius: bore_radius(&sector) };
        let problem = problem(&ring, &whole, &contact, &[(0, 0), (1, 2)]);
        let solution = solve(&problem, None).unwrap();
        assert!(solution.certificate.largest() < 1e-10, "{:?}", solution.certificate);
        let (forces, _) = clarabel_check::solve(&problem).unwrap();
        agree(&solution.forces, &forces, 1e-6);
    }
}

fn bore_radius(sector: &PlaneModel) -> f64 {
    let bore = sector.mesh.chain("bore").unwrap();
    let [x, y] = sector.mesh.nodes[sector.mesh.chain_nodes(bore)[0]];
    x.hypot(y)
}
