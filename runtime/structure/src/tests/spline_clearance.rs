//! Rings on spline teeth with clearance: condensed rings against whole ones, and against spline
//! teeth that carry load in both directions.

use super::bodies::{STEEL, toothed_ring, toothed_sector};
use super::bore::{Direct, dot, force};
use super::spline_teeth::{FOUR, PLANE_POINTS, Ring, SMALL, plane_means, spline_tooth_form};
use crate::BoreSupport;
use crate::condense::Assembled;
use crate::spline_teeth::SplineTeeth;
use calyx_fe::material::Plane;
use calyx_fe::{PlaneModel, SparseVector};
use faer::{Mat, MatRef};

pub const TEETH: u32 = 7;
/// Spline teeth as wide as the spaces between them, and as compliant as the ring.
pub const FIVE: SplineTeeth = SplineTeeth { count: 5, tangential: 0.5 / STEEL.youngs_modulus, ..FOUR };

fn with_clearance(spline_teeth: SplineTeeth) -> BoreSupport {
    BoreSupport::SplineWithClearance { spline_teeth, clearance: 0.0 }
}

/// The couplings of spline teeth with each other, with gear teeth and with stresses are those of
/// the whole mesh under the same tractions, with constrained rigid-body means only.
#[test]
fn spline_teeth_move_as_on_the_whole_mesh() {
    let (sector, _) = toothed_sector(TEETH, 1.0, SMALL);
    let whole = PlaneModel::new(toothed_ring(TEETH, SMALL), STEEL, Plane::Strain);
    let ring = Ring::plane(&sector, with_clearance(FIVE), TEETH, &PLANE_POINTS).unwrap();
    let means = plane_means(&whole, with_clearance(FIVE));
    assert_eq!(means.constrained, 3);
    let equations = Assembled::plane(&whole);
    let constrained: Vec<SparseVector> = means.forms[..means.constrained].to_vec();
    let direct = Direct::new(&equations, &whole.rigid_body_modes(), &constrained);
    let form = |spline_tooth: usize| spline_tooth_form(&means, spline_tooth, equations.stiffness.nrows());
    let spline_teeth = ring.coupling.interface.as_ref().unwrap();
    let scale = spline_teeth.compliance[(0, 0)];
    let mut farthest = 0.0_f64;
    for loaded in 0..5 {
        let (displacement, _) = direct.solve(&form(loaded));
        for observed in 0..5 {
            let expected = dot(&form(observed), &displacement);
            let found = spline_teeth.compliance[(observed, loaded)];
            assert!(
                (found - expected).abs() < 1e-9 * scale,
                "spline teeth {observed} {loaded}: {found} {expected}"
            );
            assert_eq!(found.to_bits(), spline_teeth.compliance[(loaded, observed)].to_bits());
            farthest = if observed == loaded { farthest } else { farthest.max(found.abs()) };
        }
        let unit: Vec<f64> = (0..5).map(|spline_tooth| f64::from(u8::from(spline_tooth == loaded))).collect();
        for tooth in 0..TEETH {
            let angle = ring.coupling.pitch * f64::from(tooth);
            let unit = MatRef::from_column_major_slice(&unit, 5, 1);
            let by_rows = ring.coupling.stresses_by_interface(0, tooth, unit).unwrap();
            for (point, &(at, along)) in PLANE_POINTS.iter().enumerate() {
                let expected = force(&equations, at, along, angle).dot(&displacement);
                let moved =
                    ring.coupling.interface_displacements(tooth, &ring.constraint_forces(point))[(loaded, 0)];
                for found in [moved, by_rows[(point, 0)]] {
                    assert!((found - expected).abs() < 1e-9 * scale, "tooth {tooth}: {found} {expected}");
                }
            }
        }
    }
    assert!(farthest > 0.02 * scale, "spline teeth are coupled");
}

/// Whole ring: its equations, its rigid-body motions, and the displacements of spline teeth by
/// those of nodes.
struct Whole {
    equations: Assembled,
    motions: Vec<Vec<f64>>,
    spline_teeth: Vec<Vec<f64>>,
}

impl Whole {
    fn new(spline_teeth: SplineTeeth) -> Self {
        let model = PlaneModel::new(toothed_ring(TEETH, SMALL), STEEL, Plane::Strain);
        let means = plane_means(&model, with_clearance(spline_teeth));
        let equations = Assembled::plane(&model);
        let size = equations.stiffness.nrows();
        let spline_teeth = (0..usize::from(spline_teeth.count))
            .map(|spline_tooth| spline_tooth_form(&means, spline_tooth, size))
            .collect();
        Self { equations, motions: model.rigid_body_modes().to_vec(), spline_teeth }
    }
}

/// Ring on spline teeth with clearance under unit loads on its gear teeth, for the equations of the
/// spline teeth.
pub struct LoosenedRing {
    /// Displacements of the spline teeth by forces on them, all counter-clockwise, m/(N/m).
    pub compliance: Mat<f64>,
    /// Displacement of each spline tooth by the loads, m.
    pub moved: Vec<f64>,
    /// Work of the loads in the motions of the ring as a rigid body, of which there are three.
    pub load: Vec<f64>,
    /// Displacement of each spline tooth by each of these motions; the lever arms are those of the
    /// mesh's bore.
    pub by_motion: Vec<Vec<f64>>,
    /// Forces on spline teeth without clearance, counter-clockwise, under the same loads, N/m.
    pub bound: Vec<f64>,
    /// Radius of the bore, m.
    pub radius: f64,
}

impl LoosenedRing {
    /// A ring of [`TEETH`] under unit loads, each at one of the ring's points on one of its teeth.
    pub fn new(spline_teeth: SplineTeeth, loads: &[(usize, u32)]) -> Self {
        let (sector, _) = toothed_sector(TEETH, 1.0, SMALL);
        let whole = Whole::new(spline_teeth);
        let ring = Ring::plane(&sector, with_clearance(spline_teeth), TEETH, &PLANE_POINTS).unwrap();
        let bound =
            Ring::plane(&sector, BoreSupport::SplineTeeth(spline_teeth), TEETH, &PLANE_POINTS).unwrap();
        let mut moved = Mat::<f64>::zeros(whole.spline_teeth.len(), 1);
        let (mut load, mut forces) = (vec![0.0; 3], vec![0.0; whole.spline_teeth.len()]);
        for &(point, tooth) in loads {
            moved += ring.coupling.interface_displacements(tooth, &ring.constraint_forces(point));
            let (at, along) = PLANE_POINTS[point];
            let on_nodes = force(&whole.equations, at, along, ring.coupling.pitch * f64::from(tooth));
            load.iter_mut().zip(&whole.motions).for_each(|(sum, motion)| *sum += on_nodes.dot(motion));
            let constrained = bound.spline_tooth_forces((point, tooth));
            forces.iter_mut().zip(constrained).for_each(|(sum, force)| *sum += force.tangential);
        }
        let by_motion = |motion: &Vec<f64>| {
            whole.spline_teeth.iter().map(|spline_tooth| dot(spline_tooth, motion)).collect()
        };
        let bore = sector.mesh.chain("bore").unwrap();
        let [x, y] = sector.mesh.nodes[sector.mesh.chain_nodes(bore)[0]];
        LoosenedRing {
            compliance: ring.coupling.interface.unwrap().compliance,
            moved: moved.col_as_slice(0).to_vec(),
            load,
            by_motion: whole.motions.iter().map(by_motion).collect(),
            bound: forces,
            radius: x.hypot(y),
        }
    }
}
