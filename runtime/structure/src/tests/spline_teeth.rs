//! Tests of bores supported by spline teeth. Condensed rings are compared with finite element
//! meshes of the whole ring, with equilibrium, and with hand calculations.

use super::bodies::{COARSE, Divisions, STEEL, ring_source, toothed_ring, toothed_sector};
use super::bore::{Direct, dot, force, plain_sector, turned};
use crate::bore::{BoreMeans, RequestedMeans};
use crate::bore_coupling::{BoreCoupling, Coupling};
use crate::condense::{Assembled, Condensed, Support, condense, match_cuts};
use crate::dense::product;
use crate::ring::{ReleasedMeans, RingFlexibility};
use crate::spline_teeth::SplineTeeth;
use crate::{
    BoreSupport, Chart, ElasticStructure, RingSource, SplineToothForce, SplitOptions, Structure,
    StructureError, SurfaceLoad,
};
use calyx_fe::material::Plane;
use calyx_fe::solid::{SolidMesh, SolidModel};
use calyx_fe::{PlaneMesh, PlaneModel, SparseVector};
use calyx_numerics::interrupt::Interrupt;
use faer::Mat;
use std::f64::consts::TAU;

pub(super) const SMALL: Divisions = Divisions { rim: 2, tooth_root: 1, flank: 2, thickness: 4, grading: 1.0 };
/// Four rigid spline teeth that are as wide as the spaces between them.
pub(super) const FOUR: SplineTeeth =
    SplineTeeth { count: 4, first: 0.3, width: TAU / 8.0, tangential: 0.0, radial: None, degree: 0 };

/// Condensed ring of equal sectors with point loads on the sector at the x axis.
pub(super) struct Ring {
    condensed: Condensed,
    flexibility: RingFlexibility,
    pub coupling: BoreCoupling,
    /// Constraint forces of the bore, one column per load.
    constraint_forces: Mat<f64>,
}

/// Point and direction of each load.
pub(super) type Points<'a> = &'a [([f64; 3], [f64; 3])];

impl Ring {
    fn new(
        equations: &Assembled,
        cuts: [Vec<usize>; 2],
        means: &BoreMeans,
        sectors: u32,
        points: Points<'_>,
    ) -> Result<Self, StructureError> {
        let pitch = TAU / f64::from(sectors);
        let cuts = match_cuts(&equations.positions, &cuts[0], &cuts[1], &[], pitch).unwrap();
        let loads: Vec<_> = points.iter().map(|&(at, along)| force(equations, at, along, 0.0)).collect();
        let support = Support::Means { constrained: &[], means };
        let condensed =
            condense(equations, &support, Some(&cuts), &loads, &loads, &Interrupt::never()).unwrap();
        let stiffness = condensed.stiffness.as_ref().unwrap();
        let mut flexibility = RingFlexibility::new(stiffness, sectors, sectors / 2, &Interrupt::never())?;
        let released: ReleasedMeans = means.release(&mut flexibility, &Interrupt::never())?.unwrap();
        let constraint_forces = product(released.constraint_forces.as_ref(), condensed.on_cuts.as_ref());
        let stress = product(condensed.rows_cuts.as_ref(), released.constraint_forces.transpose());
        let mut coupling = BoreCoupling::new(released, sectors, pitch);
        coupling.stress.push(stress);
        Ok(Self { condensed, flexibility, coupling, constraint_forces })
    }

    pub fn plane(
        model: &PlaneModel,
        support: BoreSupport,
        sectors: u32,
        points: Points<'_>,
    ) -> Result<Self, StructureError> {
        let nodes = |name: &str| model.mesh.chain_nodes(model.mesh.chain(name).unwrap());
        let means = plane_means(model, support);
        Self::new(&Assembled::plane(model), ["cut_first", "cut_last"].map(nodes), &means, sectors, points)
    }

    pub fn constraint_forces(&self, load: usize) -> Mat<f64> {
        self.constraint_forces.as_ref().subcols(load, 1).to_owned()
    }

    /// Returns the displacement along the load `observed` on tooth `at` caused by the load `loaded`
    /// on tooth `by`. The first value follows from the compliance, the second one from rows that
    /// are recovered as a stress would be.
    fn between(&self, (observed, at): (usize, u32), (loaded, by): (usize, u32)) -> [f64; 2] {
        let sectors = self.coupling.sectors;
        let (ahead, behind) = ((at + sectors - by) % sectors, (by + sectors - at) % sectors);
        let (on_cuts, rows) = (&self.condensed.on_cuts, &self.condensed.rows_cuts);
        let flexibility = self.flexibility.at(ahead.min(behind));
        let flexibility = if ahead <= behind { flexibility } else { flexibility.transpose() };
        let cuts = flexibility * on_cuts.col(loaded);
        let own = if at == by { [self.condensed.own[(observed, loaded)]; 2] } else { [0.0; 2] };
        let (first, second) = (self.constraint_forces(observed), self.constraint_forces(loaded));
        let bore =
            self.coupling.compliance((at, &first), (by, &second), &Interrupt::never()).unwrap()[(0, 0)];
        let rows_bore = self.coupling.stresses(0, at, (by, &second)).unwrap()[(observed, 0)];
        [
            on_cuts.col(observed).transpose() * &cuts + own[0] + bore,
            rows.row(observed) * &cuts + own[1] + rows_bore,
        ]
    }

    pub fn spline_tooth_forces(&self, (load, tooth): (usize, u32)) -> Vec<SplineToothForce> {
        self.coupling.spline_tooth_forces(&self.coupling.in_body(tooth, &self.constraint_forces(load)))
    }
}

pub(super) fn plane_means(model: &PlaneModel, support: BoreSupport) -> BoreMeans {
    let wanted = RequestedMeans::for_ring(support).unwrap();
    let bore = model.mesh.chain("bore").unwrap();
    BoreMeans::plane(model, bore, wanted, &Interrupt::never()).unwrap().unwrap()
}

/// Returns the coefficients of the displacement of a spline tooth in terms of nodal displacements.
/// They are also the load vector of a unit force of the spline tooth.
pub(super) fn spline_tooth_form(means: &BoreMeans, row: usize, size: usize) -> Vec<f64> {
    let spline_teeth = means.spline_teeth.as_ref().unwrap();
    let mut form = vec![0.0; size];
    for (column, mean) in means.forms.iter().enumerate() {
        for (value, part) in form.iter_mut().zip(mean.to_full(size)) {
            *value += spline_teeth.displacements[(row, column)] * part;
        }
    }
    form
}

/// Builds the whole mesh with the same constraints: the means of the bore, then the spline teeth.
fn direct(equations: &Assembled, motions: &[Vec<f64>], means: &BoreMeans) -> Direct {
    let spline_teeth = means.spline_teeth.as_ref().unwrap();
    let size = equations.stiffness.nrows();
    let spline_tooth = |row: usize| -> SparseVector {
        spline_tooth_form(means, row, size).into_iter().enumerate().collect()
    };
    let rows = 0..spline_teeth.displacements.nrows();
    let forms: Vec<_> =
        means.forms[..means.constrained].iter().cloned().chain(rows.map(spline_tooth)).collect();
    let compliance =
        vec![0.0; means.constrained].into_iter().chain(spline_teeth.compliance.iter().copied()).collect();
    Direct::new(equations, motions, &forms).yielding(compliance)
}

/// Asserts that a condensed ring and the whole mesh have the same displacements on all teeth and
/// the same forces of the spline teeth, and that these forces balance the load.
fn assert_agreement(
    ring: &Ring,
    whole: &Assembled,
    motions: &[Vec<f64>],
    means: &BoreMeans,
    points: Points<'_>,
) {
    let direct = direct(whole, motions, means);
    let (sectors, pitch) = (ring.coupling.sectors, ring.coupling.pitch);
    let angle = |tooth: u32| pitch * f64::from(tooth);
    let spline_teeth = means.spline_teeth.as_ref().unwrap();
    let degrees = usize::from(spline_teeth.spline_teeth.degree) + 1;
    for (column, &(at, along)) in points.iter().enumerate() {
        for by in [0, 1, sectors - 1] {
            let load = force(whole, at, along, angle(by)).to_full(whole.stiffness.nrows());
            let (displacement, forces) = direct.solve(&load);
            let scale = dot(&load, &displacement).abs();
            for tooth in 0..sectors {
                for (row, &(observed, direction)) in points.iter().enumerate() {
                    let expected = force(whole, observed, direction, angle(tooth)).dot(&displacement);
                    for found in ring.between((row, tooth), (column, by)) {
                        let error = (found - expected).abs() / scale;
                        assert!(error < 1e-9, "{tooth} by {by}: {error:.1e}");
                    }
                }
            }
            let found = ring.spline_tooth_forces((column, by));
            let size = forces.iter().fold(0.0_f64, |most, force| most.max(force.abs()));
            let step = (forces.len() - means.constrained) / found.len();
            if means.constrained == 0 {
                let directions = 1 + usize::from(spline_teeth.spline_teeth.radial.is_some());
                let forces = found.iter().flat_map(|force| [force.tangential, force.radial]);
                let kept = forces.enumerate().filter(|(place, _)| place % 2 < directions);
                let forces: Vec<f64> = kept.map(|(_, force)| force).collect();
                for motion in motions {
                    let by_spline_teeth: f64 =
                        direct.forms.iter().zip(&forces).map(|(form, force)| force * dot(form, motion)).sum();
                    let left = (dot(&load, motion) + by_spline_teeth).abs() / size;
                    assert!(left < 1e-10, "out of equilibrium by {left:.1e}");
                }
            }
            for (found, expected) in found.iter().zip(forces[means.constrained..].chunks(step)) {
                assert!((found.tangential - expected[0]).abs() < 1e-8 * size, "{found:?} {expected:?}");
                if spline_teeth.spline_teeth.radial.is_some() {
                    assert!((found.radial - expected[degrees]).abs() < 1e-8 * size);
                }
            }
        }
    }
}

pub(super) const PLANE_POINTS: [([f64; 3], [f64; 3]); 3] = [
    ([1.1, 0.2, 0.0], [0.3, -1.0, 0.0]),
    ([1.3, -0.1, 0.0], [-0.5, 0.7, 0.0]),
    ([0.75, 0.3, 0.0], [1.0, 0.2, 0.0]),
];

#[test]
fn condensed_sectors_on_spline_teeth_agree_with_the_whole_mesh() {
    let teeth = 7;
    let (sector, _) = toothed_sector(teeth, 1.0, SMALL);
    let whole = PlaneModel::new(toothed_ring(teeth, SMALL), STEEL, Plane::Strain);
    let yielding = 0.5 / STEEL.youngs_modulus;
    for spline_teeth in [
        FOUR,
        SplineTeeth { radial: Some(0.0), ..FOUR },
        SplineTeeth { tangential: yielding, ..FOUR },
        SplineTeeth { count: 5, tangential: 0.0, radial: Some(yielding), ..FOUR },
        SplineTeeth { count: 3, tangential: 1e2 * yielding, radial: Some(yielding), ..FOUR },
    ] {
        let ring =
            Ring::plane(&sector, BoreSupport::SplineTeeth(spline_teeth), teeth, &PLANE_POINTS).unwrap();
        let means = plane_means(&whole, BoreSupport::SplineTeeth(spline_teeth));
        assert_agreement(&ring, &Assembled::plane(&whole), &whole.rigid_body_modes(), &means, &PLANE_POINTS);
    }
}

#[test]
fn condensed_helical_sectors_on_spline_teeth_agree_with_the_whole_mesh() {
    let teeth = 5;
    let helical = |section: &PlaneMesh| {
        let place = |[x, y]: [f64; 2], z: f64| turned([x, y, z], 0.6 * z);
        SolidModel::new(SolidMesh::swept(section, &[0.0, 0.5], 2, &place).unwrap(), STEEL)
    };
    let divisions = Divisions { thickness: 2, ..SMALL };
    let sector = helical(&toothed_sector(teeth, 1.0, divisions).0.mesh);
    let whole = helical(&toothed_ring(teeth, divisions));
    let points = [([1.3, 0.2, 0.0], [0.3, -1.0, 0.2]), ([1.4, -0.1, 0.5], [-0.5, 0.7, 0.1])];
    let three = SplineTeeth { count: 3, width: TAU / 6.0, ..FOUR };
    for spline_teeth in [three, SplineTeeth { degree: 1, radial: Some(0.3 / STEEL.youngs_modulus), ..three }]
    {
        let means = |model: &SolidModel| {
            let wanted = RequestedMeans::for_ring(BoreSupport::SplineTeeth(spline_teeth)).unwrap();
            let bore = model.mesh.face_set("bore").unwrap();
            BoreMeans::solid(model, bore, wanted, &Interrupt::never()).unwrap().unwrap()
        };
        let equations = [&sector, &whole].map(|model| {
            Assembled::solid(&model.mesh, &Interrupt::never(), || Ok(model.stiffness())).expect("room")
        });
        let nodes = |name: &str| sector.mesh.nodes_on(sector.mesh.face_set(name).unwrap());
        let cuts = ["cut_first", "cut_last"].map(nodes);
        let ring = Ring::new(&equations[0], cuts, &means(&sector), teeth, &points).unwrap();
        assert_agreement(&ring, &equations[1], &whole.rigid_body_modes(), &means(&whole), &points);
    }
}

/// Three spline teeth are statically determinate in the plane: equilibrium alone determines their
/// forces.
#[test]
fn forces_of_three_spline_teeth_follow_from_equilibrium() {
    let (sectors, radii) = (10, [0.7, 1.0]);
    let model = plain_sector(radii, sectors, [3, 2]);
    let three = SplineTeeth { count: 3, first: 0.4, width: 0.7, ..FOUR };
    let (at, along) = ([0.95, 0.3, 0.0], [0.6, 0.8, 0.0]);
    let point = {
        let equations = Assembled::plane(&model);
        let load = force(&equations, at, along, 0.0).to_full(equations.stiffness.nrows());
        let node = load.iter().position(|&part| part != 0.0).unwrap() / 2;
        equations.positions[node]
    };
    for compliance in [0.0, 1e-3 / STEEL.youngs_modulus, 1e2 / STEEL.youngs_modulus] {
        let spline_teeth = SplineTeeth { tangential: compliance, ..three };
        let ring =
            Ring::plane(&model, BoreSupport::SplineTeeth(spline_teeth), sectors, &[(at, along)]).unwrap();
        for tooth in [0, 3] {
            let turn = TAU * f64::from(tooth) / f64::from(sectors);
            let ([x, y, _], [px, py, _]) = (turned(point, turn), turned(along, turn));
            let forces = ring.spline_tooth_forces((0, tooth));
            // The resultant of a uniform tangential pressure over the width of a spline tooth is
            // its sum times the ratio of chord to arc.
            let chord = (0.5 * spline_teeth.width).sin() / (0.5 * spline_teeth.width);
            let sum = |part: &dyn Fn(&SplineToothForce) -> f64| forces.iter().map(part).sum::<f64>();
            let residuals = [
                px - chord * sum(&|force| force.tangential * force.angle.sin()),
                py + chord * sum(&|force| force.tangential * force.angle.cos()),
                x * py - y * px + radii[0] * sum(&|force| force.tangential),
            ];
            println!("{compliance:.1e}, tooth {tooth}: {residuals:?}");
            assert!(residuals.iter().all(|residual| residual.abs() < 1e-6), "{residuals:?}");
            // Hand calculation: all three carry equal parts of the torque, and of the force a part
            // proportional to the cosine of the angle to it.
            let torque = -(x * py - y * px) / (3.0 * radii[0]);
            for force in &forces {
                let [tx, ty] = [-force.angle.sin(), force.angle.cos()];
                let expected = torque - (px * tx + py * ty) / (1.5 * chord);
                assert!((force.tangential - expected).abs() < 1e-6, "{force:?}, {expected}");
            }
        }
    }
}

/// Each gear tooth has a different position relative to the spline teeth. A rotation of the load by
/// a common multiple of both pitches does not change the displacement. Neither does a different
/// choice of the first spline tooth, nor a rotation of load and spline teeth together.
#[test]
fn displacements_have_the_common_symmetry_of_gear_teeth_and_spline_teeth() {
    let sectors = 12;
    let model = plain_sector([0.8, 1.0], sectors, [2, 1]);
    let points = [([1.0, 0.1, 0.0], [1.0, 0.4, 0.0]), ([0.9, -0.1, 0.0], [0.0, 1.0, 0.0])];
    let ring =
        |spline_teeth| Ring::plane(&model, BoreSupport::SplineTeeth(spline_teeth), sectors, &points).unwrap();
    let pitch = TAU / f64::from(sectors);
    let own = ring(FOUR);
    let renumbered = ring(SplineTeeth { first: FOUR.first + 2.0 * TAU / 4.0, ..FOUR });
    let rotated = ring(SplineTeeth { first: FOUR.first + 5.0 * pitch, ..FOUR });
    let scale = own.between((0, 0), (0, 0))[0];
    let mut differs = 0.0_f64;
    for (a, b) in [(0, 0), (0, 1), (2, 0), (1, 7), (3, 10)] {
        for (first, second) in [(0, 0), (0, 1), (1, 0)] {
            let at = |ring: &Ring, by: u32| {
                ring.between((first, (a + by) % sectors), (second, (b + by) % sectors))[0]
            };
            let expected = at(&own, 0);
            for found in [at(&own, 3), at(&own, 6), at(&renumbered, 0), at(&rotated, 5)] {
                assert!((found - expected).abs() < 1e-10 * scale, "{a} {b}: {found:e} {expected:e}");
            }
            differs = differs.max((at(&own, 1) - expected).abs() / scale);
            let exchanged = own.between((second, b), (first, a))[0];
            assert!((exchanged - expected).abs() < 1e-10 * scale, "{exchanged:e} {expected:e}");
        }
    }
    assert!(differs > 0.02, "the position relative to the spline teeth must matter: {differs}");
}

/// With more and more rigid spline teeth without spaces, which also constrain the bore radially,
/// the compliance decreases monotonically to that of a rigid bore. With stiffer and stiffer spline
/// teeth it decreases to that of rigid ones.
#[test]
fn many_spline_teeth_are_equivalent_to_a_rigid_bore() {
    let (sectors, radii) = (24, [0.85, 1.0]);
    let model = plain_sector(radii, sectors, [3, 2]);
    let point = [([1.0, 0.0, 0.0], [1.0, 0.0, 0.0])];
    let compliance = |spline_teeth| {
        Ring::plane(&model, BoreSupport::SplineTeeth(spline_teeth), sectors, &point)
            .unwrap()
            .between((0, 0), (0, 0))[0]
    };
    let constrained = |count: u16, tangential| SplineTeeth {
        count,
        first: 0.0,
        width: TAU / f64::from(count),
        tangential,
        radial: Some(tangential),
        degree: 0,
    };
    let nodes = |name: &str| model.mesh.chain_nodes(model.mesh.chain(name).unwrap());
    let equations = Assembled::plane(&model);
    let bore = nodes("bore");
    let cuts = match_cuts(
        &equations.positions,
        &nodes("cut_first"),
        &nodes("cut_last"),
        &bore,
        TAU / f64::from(sectors),
    )
    .unwrap();
    let load = [force(&equations, point[0].0, point[0].1, 0.0)];
    let dofs = equations.dofs_of(&bore);
    let condensed =
        condense(&equations, &Support::Constrained(&dofs), Some(&cuts), &load, &[], &Interrupt::never())
            .unwrap();
    let stiffness = condensed.stiffness.as_ref().unwrap();
    let flexibility = RingFlexibility::new(stiffness, sectors, 0, &Interrupt::never()).unwrap();
    let cut_loads = condensed.on_cuts.col(0);
    let rigid = cut_loads.transpose() * (flexibility.at(0) * cut_loads) + condensed.own[(0, 0)];
    let mut before = f64::INFINITY;
    for count in [4, 8, 16, 32] {
        let more = compliance(constrained(count, 0.0)) / rigid - 1.0;
        println!("{count} rigid spline teeth: {more:.1e}");
        assert!(more > 0.0 && more < before, "{count}: {more:e} of {before:e}");
        before = more;
    }
    assert!(before < 0.03, "{before:e}");
    let mut before = f64::INFINITY;
    for yielding in [10.0, 1.0, 0.1, 0.01] {
        let more = compliance(constrained(16, yielding / STEEL.youngs_modulus));
        assert!(more < before);
        before = more;
    }
    assert!((before / compliance(constrained(16, 0.0)) - 1.0).abs() < 0.02);
}

/// A ring on compliant spline teeth moves as a rigid body: rotation by the torque over `n k R²`,
/// translation by the force over `n k / 2`.
#[test]
fn a_ring_on_soft_spline_teeth_moves_as_a_rigid_body() {
    let (sectors, [inner, outer]) = (20, [0.6, 1.0]);
    let model = plain_sector([inner, outer], sectors, [3, 2]);
    let point = [([outer, 0.0, 0.0], [0.0, 1.0, 0.0])];
    let spline_teeth = SplineTeeth { count: 6, width: 0.3, tangential: 1e4 / STEEL.youngs_modulus, ..FOUR };
    let ring = Ring::plane(&model, BoreSupport::SplineTeeth(spline_teeth), sectors, &point).unwrap();
    let chord = (0.5 * spline_teeth.width).sin() / (0.5 * spline_teeth.width);
    let by_rotation = (outer / inner).powi(2);
    let by_translation = 2.0 / (chord * chord);
    let expected = spline_teeth.tangential / f64::from(spline_teeth.count) * (by_rotation + by_translation);
    let found = ring.between((0, 0), (0, 0))[0];
    assert!((found / expected - 1.0).abs() < 2e-3, "{found:e} {expected:e}");
}

#[test]
fn two_spline_teeth_leave_a_ring_unrestrained() {
    let model = plain_sector([0.8, 1.0], 8, [2, 1]);
    let two = SplineTeeth { count: 2, ..FOUR };
    let error = Ring::plane(&model, BoreSupport::SplineTeeth(two), 8, &[]).err().unwrap();
    assert!(matches!(error, StructureError::Ring(_)), "{error}");
}

/// Truncation of the Fourier series of spline teeth with sharp ends causes at most the error that
/// [`SplineTeeth::harmonics`] states. The mesh of the reference solution has element boundaries at
/// the ends.
#[test]
fn truncation_of_the_series_of_spline_teeth_has_a_small_error() {
    let teeth = 12;
    let divisions = Divisions { rim: 2, tooth_root: 1, flank: 2, thickness: 6, grading: 1.0 };
    let (sector, _) = toothed_sector(teeth, 1.0, divisions);
    let whole = PlaneModel::new(toothed_ring(teeth, divisions), STEEL, Plane::Strain);
    let equations = Assembled::plane(&whole);
    let bore = whole.mesh.chain("bore").unwrap();
    let pitch = TAU / f64::from(teeth);
    // The root of a gear tooth has this width.
    for (count, width) in [(12, 0.55 * pitch), (6, 0.55 * pitch), (3, 0.55 * pitch), (4, 1.45 * pitch)] {
        for radial in [None, Some(0.0)] {
            let spline_teeth = SplineTeeth { count, first: 0.0, width, tangential: 0.0, radial, degree: 0 };
            let ring =
                Ring::plane(&sector, BoreSupport::SplineTeeth(spline_teeth), teeth, &PLANE_POINTS).unwrap();
            let mut forms = Vec::new();
            for spline_tooth in 0..count {
                let angle = spline_teeth.angle(spline_tooth);
                let mut size = 0.0;
                let within = |x: f64, y: f64| {
                    let off = (y.atan2(x) - angle).rem_euclid(TAU);
                    off.min(TAU - off) < 0.5 * width
                };
                let patch = |direction: &dyn Fn(f64, f64) -> [f64; 2]| {
                    whole.edge_load(bore, |_, point| {
                        let [x, y] = point.position;
                        if within(x, y) { direction(x, y) } else { [0.0; 2] }
                    })
                };
                let motions = whole.rigid_body_modes();
                // Length of the spline tooth, from the work of a uniform pressure in a rotation.
                let radius = 0.75;
                let around = patch(&|x, y| [-y / radius, x / radius]);
                size += around.dot(&motions[2]) / radius;
                let scaled = |form: SparseVector| -> SparseVector {
                    let form = form.to_full(equations.stiffness.nrows());
                    form.into_iter().map(|part| part / size).enumerate().collect()
                };
                assert!((size / (radius * width) - 1.0).abs() < 1e-3, "{size}");
                forms.push(scaled(around));
                if radial.is_some() {
                    forms.push(scaled(patch(&|x, y| [x / radius, y / radius])));
                }
            }
            let direct = Direct::new(&equations, &whole.rigid_body_modes(), &forms);
            let mut worst = 0.0_f64;
            let mut force_error = 0.0_f64;
            for (column, &(at, along)) in PLANE_POINTS.iter().take(2).enumerate() {
                let load = force(&equations, at, along, 0.0).to_full(equations.stiffness.nrows());
                let (displacement, forces) = direct.solve(&load);
                let scale = dot(&load, &displacement);
                for tooth in 0..teeth {
                    for (row, &(observed, direction)) in PLANE_POINTS.iter().take(2).enumerate() {
                        let turn = pitch * f64::from(tooth);
                        let expected = force(&equations, observed, direction, turn).dot(&displacement);
                        let [found, _] = ring.between((row, tooth), (column, 0));
                        worst = worst.max((found - expected).abs() / scale);
                    }
                }
                let step = 1 + usize::from(radial.is_some());
                let size = forces.iter().fold(0.0_f64, |most, force| most.max(force.abs()));
                for (found, expected) in ring.spline_tooth_forces((column, 0)).iter().zip(forces.chunks(step))
                {
                    force_error = force_error.max((found.tangential - expected[0]).abs() / size);
                }
            }
            println!(
                "{count} spline teeth of {width:.2} rad, radial {}, {} harmonics: {worst:.1e}, forces {force_error:.1e}",
                radial.is_some(),
                spline_teeth.harmonics()
            );
            assert!(worst < 1e-3 && force_error < 3e-3, "{worst:e}, {force_error:e}");
        }
    }
}

/// Returns a ring on spline teeth, as it was built and after storing and loading it.
fn ring_and_its_copy(
    teeth: u32,
    coupled: u32,
    spline_teeth: SplineTeeth,
) -> (ElasticStructure, ElasticStructure) {
    let (model, surfaces) = toothed_sector(teeth, 1.0, COARSE);
    let source =
        RingSource { support: BoreSupport::SplineTeeth(spline_teeth), coupled, ..ring_source(teeth) };
    let structure =
        ElasticStructure::ring(&model, &source, &surfaces, &SplitOptions::default(), &Interrupt::never())
            .unwrap();
    let profiles: Vec<_> = surfaces.iter().map(|surface| surface.profile.clone()).collect();
    let restored = ElasticStructure::restored(&structure.stored().unwrap(), &profiles).unwrap();
    (structure, restored)
}

/// The compliance between any two teeth is symmetric to the last bit. A stored structure has the
/// same bits. The number of neighbours with separate tables does not change the results.
#[test]
fn a_stored_ring_on_spline_teeth_is_symmetric_and_has_the_same_bits() {
    let teeth = 16;
    let five = SplineTeeth { count: 5, width: 0.5, tangential: 0.2 / STEEL.youngs_modulus, ..FOUR };
    let ((near, restored), (all, _)) = (ring_and_its_copy(teeth, 2, five), ring_and_its_copy(teeth, 8, five));
    let points = [0.2, 0.6, 0.9].map(|share| share * all.reference_length());
    let block = |structure: &ElasticStructure, a: Chart, b: Chart| {
        let mut block = vec![0.0; 9];
        structure.add_compliance(a, &points, b, &points, &mut block);
        block
    };
    let at = |tooth, surface| Chart { tooth, surface };
    let scale = block(&all, at(4, 0), at(3, 0)).iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    let mut worst = 0.0_f64;
    for (a, b) in [(0, 0), (7, 7), (1, 0), (3, 0), (0, 4), (8, 0), (1, 9), (2, 12)] {
        for (side, other) in [(0, 0), (0, 1), (1, 0)] {
            let (a, b) = (at(a, side), at(b, other));
            let (exact, found) = (block(&all, a, b), block(&near, a, b));
            let exchanged = block(&near, b, a);
            for (row, column) in (0..9).map(|k| (k / 3, k % 3)) {
                assert_eq!(found[3 * row + column].to_bits(), exchanged[3 * column + row].to_bits());
                worst = worst.max((exact[3 * row + column] - found[3 * row + column]).abs() / scale);
            }
            assert_eq!(found, block(&restored, a, b));
            let load = [SurfaceLoad { chart: b, s: points[1], force: 1.0 }];
            let [exact, found] = [&all, &near].map(|structure| structure.stresses(a.tooth, 0, &load));
            assert_eq!(found, restored.stresses(a.tooth, 0, &load));
            let most =
                all.stresses(b.tooth, 0, &load).iter().fold(0.0_f64, |most, (_, at)| most.max(at.abs()));
            for ((_, exact), (_, found)) in exact.iter().zip(&found) {
                assert!((exact - found).abs() < 1e-6 * most, "{a:?} {b:?}: {exact:e} {found:e} of {most:e}");
            }
            let forces = near.spline_tooth_forces(&load);
            assert_eq!(forces, restored.spline_tooth_forces(&load));
            // Their torque is that of the load.
            let turn = near.tooth_angle(b.tooth);
            let point = near.profile(b.surface).at(points[1]);
            let [px, py, _] = turned([point.position[0], point.position[1], 0.0], turn);
            let [nx, ny, _] = turned([-point.normal[0], -point.normal[1], 0.0], turn);
            let (torque, reaction) =
                (px * ny - py * nx, 0.75 * forces.iter().map(|force| force.tangential).sum::<f64>());
            assert!((torque + reaction).abs() < 2e-3, "{torque} {reaction}");
        }
    }
    println!("error relative to the compliance between neighbouring teeth: {worst:.1e}");
    assert!(worst < 1e-8, "{worst:e}");
}

/// A mesh cannot resolve more harmonics than the bore has nodes.
#[test]
fn spline_teeth_finer_than_the_mesh_are_rejected() {
    let teeth = 6;
    let divisions = Divisions { flank: 10, ..SMALL };
    let (model, surfaces) = toothed_sector(teeth, 1.0, divisions);
    let many = SplineTeeth { count: 60, width: 0.05, ..FOUR };
    let source = RingSource { support: BoreSupport::SplineTeeth(many), ..ring_source(teeth) };
    let error =
        ElasticStructure::ring(&model, &source, &surfaces, &SplitOptions::default(), &Interrupt::never());
    assert_eq!(error.err(), Some(StructureError::CoarseSplineTeeth));
}
