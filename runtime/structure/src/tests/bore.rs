//! Bores with mean constraints: condensed rings against whole ones, and against analytical
//! solutions.

use super::bodies::{COARSE, Divisions, STEEL, ring_source, toothed_ring, toothed_sector};
use crate::bore::{BoreMeans, RequestedMeans};
use crate::condense::{Assembled, Condensed, Support, condense, match_cuts, statically_determinate_support};
use crate::ring::RingFlexibility;
use crate::{BoreSupport, Chart, ElasticStructure, RingSource, SplitOptions, Structure, SurfaceLoad};
use calyx_fe::material::Plane;
use calyx_fe::solid::{ABSENT, SolidMesh, SolidModel};
use calyx_fe::{
    Block, Constraints, Curve, ElementOrder, ElementPoint, MeshBuilder, PlaneMesh, PlaneModel, Side, Solver,
    SparseVector,
};
use calyx_numerics::interrupt::Interrupt;
use faer::Mat;
use faer::linalg::solvers::Solve;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

const SMALL: Divisions = Divisions { rim: 1, tooth_root: 1, flank: 2, thickness: 2, grading: 1.0 };

pub(super) fn turned([x, y, z]: [f64; 3], angle: f64) -> [f64; 3] {
    let (sin, cos) = angle.sin_cos();
    [cos * x - sin * y, sin * x + cos * y, z]
}

/// Returns the load vector of a unit force at the node nearest to a point, both rotated by `angle`.
pub(super) fn force(equations: &Assembled, point: [f64; 3], direction: [f64; 3], angle: f64) -> SparseVector {
    let (point, direction) = (turned(point, angle), turned(direction, angle));
    let distance = |node: usize| -> f64 {
        (0..3).map(|axis| (equations.positions[node][axis] - point[axis]).powi(2)).sum()
    };
    let nearest =
        (0..equations.positions.len()).min_by(|&a, &b| distance(a).total_cmp(&distance(b))).unwrap();
    let count = equations.dofs_per_node;
    (0..count).map(|axis| (count * nearest + axis, direction[axis])).collect()
}

/// Displacements of a whole free body under a load, with means that vanish or respond to their
/// forces with a compliance.
pub(super) struct Direct {
    solver: Solver,
    motions: Vec<Vec<f64>>,
    pub forms: Vec<Vec<f64>>,
    /// Compliance of the forms, m/N; 0 where they vanish.
    compliance: Vec<f64>,
    /// Displacements by each of the forms as a load.
    by_forms: Vec<Vec<f64>>,
}

/// Linear forms of the displacements of a ring's mesh that give the mean motion of its bore, one
/// per row.
pub fn bore_means(model: &PlaneModel) -> Vec<Vec<f64>> {
    let wanted = RequestedMeans::of_means(None, 0);
    let bore = model.mesh.chain("bore").unwrap();
    let means = BoreMeans::plane(model, bore, wanted, &Interrupt::never()).unwrap().unwrap();
    means.forms.iter().map(|form| form.to_full(model.dof_count())).collect()
}

pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

impl Direct {
    pub fn new(equations: &Assembled, motions: &[Vec<f64>], forms: &[SparseVector]) -> Self {
        Self::beside(equations, &[], motions, forms)
    }

    /// Builds the solution without the nodes that have no material.
    fn beside(equations: &Assembled, absent: &[usize], motions: &[Vec<f64>], forms: &[SparseVector]) -> Self {
        let mut constrained = Constraints::new();
        for dof in equations.dofs_of(absent) {
            constrained.prescribe(dof, 0.0);
        }
        let (axes, positions) = (equations.dofs_per_node, &equations.positions);
        let present: Vec<usize> = (0..positions.len()).filter(|node| !absent.contains(node)).collect();
        let dofs = equations.dofs_of(&present);
        let positions: Vec<_> = present.iter().map(|&node| positions[node]).collect();
        let of_present: Vec<Vec<f64>> =
            motions.iter().map(|motion| dofs.iter().map(|&dof| motion[dof]).collect()).collect();
        for dof in statically_determinate_support(&positions, &of_present) {
            constrained.prescribe(axes * present[dof / axes] + dof % axes, 0.0);
        }
        let solver = Solver::new(&equations.stiffness, constrained).unwrap();
        let dofs = equations.stiffness.nrows();
        let forms: Vec<_> = forms.iter().map(|form| form.to_full(dofs)).collect();
        let by_forms = forms.iter().map(|form| solver.solve_one(form).unwrap()).collect();
        let compliance = vec![0.0; forms.len()];
        Self { solver, motions: motions.to_vec(), forms, compliance, by_forms }
    }

    /// Sets the compliance of the forms.
    pub fn yielding(self, compliance: Vec<f64>) -> Self {
        Self { compliance, ..self }
    }

    fn displacements(&self, load: &[f64]) -> Vec<f64> {
        self.solve(load).0
    }

    /// Returns the displacements, and the forces on the forms.
    pub fn solve(&self, load: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let own = self.solver.solve_one(load).unwrap();
        let (k, r) = (self.forms.len(), self.motions.len());
        // Forces on the forms and rigid-body motions: the forms of the total vanish, and so does
        // the work of the forces in the motions.
        let mut system = Mat::<f64>::zeros(k + r, k + r);
        let mut right = Mat::<f64>::zeros(k + r, 1);
        for (i, form) in self.forms.iter().enumerate() {
            for (j, response) in self.by_forms.iter().enumerate() {
                system[(i, j)] = -dot(form, response);
            }
            for (j, motion) in self.motions.iter().enumerate() {
                system[(i, k + j)] = dot(form, motion);
                system[(k + j, i)] = dot(form, motion);
            }
            system[(i, i)] -= self.compliance[i];
            right[(i, 0)] = -dot(form, &own);
        }
        for (j, motion) in self.motions.iter().enumerate() {
            right[(k + j, 0)] = dot(load, motion);
        }
        let answer = system.full_piv_lu().solve(&right);
        let mut sum = own;
        for (i, response) in self.by_forms.iter().enumerate() {
            sum.iter_mut().zip(response).for_each(|(sum, part)| *sum -= answer[(i, 0)] * part);
        }
        for (j, motion) in self.motions.iter().enumerate() {
            sum.iter_mut().zip(motion).for_each(|(sum, part)| *sum += answer[(k + j, 0)] * part);
        }
        (sum, (0..k).map(|form| -answer[(form, 0)]).collect())
    }
}

/// Compares compliances of a condensed ring, offset by offset, with those of the whole mesh.
fn agree(
    [sector, whole]: [&Assembled; 2],
    (condensed, ring): (&Condensed, &RingFlexibility),
    direct: &Direct,
    points: &[([f64; 3], [f64; 3])],
    pitch: f64,
) {
    assert_eq!(sector.dofs_per_node, whole.dofs_per_node);
    for (column, &(at, along)) in points.iter().enumerate() {
        let load = force(whole, at, along, 0.0).to_full(whole.stiffness.nrows());
        let displacement = direct.displacements(&load);
        let scale = force(whole, at, along, 0.0).dot(&displacement);
        for offset in 0..=ring.window() {
            for (row, &(observed, direction)) in points.iter().enumerate() {
                let expected =
                    force(whole, observed, direction, pitch * f64::from(offset)).dot(&displacement);
                let cuts = ring.at(offset) * condensed.on_cuts.col(column);
                let first = if offset == 0 { 1.0 } else { 0.0 };
                let through =
                    condensed.on_cuts.col(row).transpose() * &cuts + first * condensed.own[(row, column)];
                let error = (through - expected).abs() / scale;
                assert!(error < 1e-9, "offset {offset}: {error:.1e}");
                let by_rows =
                    condensed.rows_cuts.row(row) * &cuts + first * condensed.rows_own[(row, column)];
                let error = (by_rows - expected).abs() / scale;
                assert!(error < 1e-9, "rows, offset {offset}: {error:.1e}");
            }
        }
    }
}

#[test]
fn condensed_sectors_on_a_bore_constrained_in_the_mean_agree_with_the_whole_mesh() {
    let teeth = 7;
    let pitch = TAU / f64::from(teeth);
    let (sector, _) = toothed_sector(teeth, 1.0, SMALL);
    let whole = PlaneModel::new(toothed_ring(teeth, SMALL), STEEL, Plane::Strain);
    let nodes = |name: &str| sector.mesh.chain_nodes(sector.mesh.chain(name).unwrap());
    let equations = [Assembled::plane(&sector), Assembled::plane(&whole)];
    let cuts =
        match_cuts(&equations[0].positions, &nodes("cut_first"), &nodes("cut_last"), &[], pitch).unwrap();
    let points = [
        ([1.1, 0.2, 0.0], [0.3, -1.0, 0.0]),
        ([1.3, -0.1, 0.0], [-0.5, 0.7, 0.0]),
        ([0.75, 0.3, 0.0], [1.0, 0.2, 0.0]),
    ];
    let loads: Vec<_> = points.iter().map(|&(at, along)| force(&equations[0], at, along, 0.0)).collect();
    // Terms that are constrained and then released give the same result as terms that are never
    // constrained.
    for (harmonics, raceway) in [
        (None, None),
        (Some(0), None),
        (Some(1), None),
        (Some(4), None),
        (None, Some((4, 0))),
        (Some(2), Some((3, 0))),
    ] {
        let means = |model: &PlaneModel, raceway| {
            let bore = model.mesh.chain("bore").unwrap();
            let wanted =
                RequestedMeans { harmonics, degree: 0, spline_teeth: None, with_clearance: false, raceway };
            BoreMeans::plane(model, bore, wanted, &Interrupt::never()).unwrap().unwrap()
        };
        let of_sector = means(&sector, raceway);
        let support = Support::Means { constrained: &[], means: &of_sector };
        let condensed =
            condense(&equations[0], &support, Some(&cuts), &loads, &loads, &Interrupt::never()).unwrap();
        let mut ring =
            RingFlexibility::new(condensed.stiffness.as_ref().unwrap(), teeth, 3, &Interrupt::never())
                .unwrap();
        assert_eq!(
            ring.release(of_sector.constrained, None, &Interrupt::never()).unwrap().is_some(),
            raceway.is_some()
        );
        let direct = Direct::new(&equations[1], &whole.rigid_body_modes(), &means(&whole, None).forms);
        agree([&equations[0], &equations[1]], (&condensed, &ring), &direct, &points, pitch);
    }
}

#[test]
fn condensed_helical_sectors_on_a_bore_constrained_in_the_mean_agree_with_the_whole_mesh() {
    let teeth = 5;
    let helical = |section: &PlaneMesh| {
        let place = |[x, y]: [f64; 2], z: f64| turned([x, y, z], 0.6 * z);
        SolidModel::new(SolidMesh::swept(section, &[0.0, 0.5], 2, &place).unwrap(), STEEL)
    };
    let sector = helical(&toothed_sector(teeth, 1.0, SMALL).0.mesh);
    let whole = helical(&toothed_ring(teeth, SMALL));
    solid_rings_agree(teeth, &sector, &whole);
}

/// The bore exists only where the web is.
#[test]
fn condensed_sectors_on_a_web_constrained_in_the_mean_at_its_bore_agree_with_the_whole_mesh() {
    let teeth = 5;
    let webbed = |section: &PlaneMesh| {
        let place = |[x, y]: [f64; 2], z: f64| [x, y, z];
        let mesh = SolidMesh::swept(section, &[0.0, 0.2, 0.5], 2, &place).unwrap();
        let count = section.elements.len();
        let of_rim: Vec<bool> = (0..count)
            .map(|element| {
                let [x, y] = section.position(ElementPoint { element, xi: 0.0, eta: 0.0 });
                x.hypot(y) < 0.9
            })
            .collect();
        SolidModel::new(mesh.without(|element| element >= count && of_rim[element % count]), STEEL)
    };
    let sector = webbed(&toothed_sector(teeth, 1.0, SMALL).0.mesh);
    let whole = webbed(&toothed_ring(teeth, SMALL));
    assert!(!whole.mesh.absent.is_empty());
    solid_rings_agree(teeth, &sector, &whole);
}

fn solid_rings_agree(teeth: u32, sector: &SolidModel, whole: &SolidModel) {
    let pitch = TAU / f64::from(teeth);
    let absent = |model: &SolidModel| -> Vec<usize> {
        model.mesh.node_sets.get(ABSENT).into_iter().flatten().copied().collect()
    };
    let nodes = |name: &str| sector.mesh.nodes_on(sector.mesh.face_set(name).unwrap());
    let equations = [sector, whole].map(|model| {
        Assembled::solid(&model.mesh, &Interrupt::never(), || Ok(model.stiffness())).expect("room")
    });
    let cuts =
        match_cuts(&equations[0].positions, &nodes("cut_first"), &nodes("cut_last"), &absent(sector), pitch)
            .unwrap();
    let points = [
        ([1.3, 0.2, 0.0], [0.3, -1.0, 0.2]),
        ([1.4, -0.1, 0.5], [-0.5, 0.7, 0.1]),
        ([0.75, 0.3, 0.1], [1.0, 0.2, -0.8]),
    ];
    let loads: Vec<_> = points.iter().map(|&(at, along)| force(&equations[0], at, along, 0.0)).collect();
    let constrained = equations[0].dofs_of(&absent(sector));
    for (harmonics, raceway) in [(None, None), (Some(2), None), (Some(1), Some((2, 1)))] {
        let means = |model: &SolidModel, raceway| {
            let bore = model.mesh.face_set("bore").unwrap();
            let wanted =
                RequestedMeans { harmonics, degree: 1, spline_teeth: None, with_clearance: false, raceway };
            BoreMeans::solid(model, bore, wanted, &Interrupt::never()).unwrap().unwrap()
        };
        let of_sector = means(sector, raceway);
        let support = Support::Means { constrained: &constrained, means: &of_sector };
        let condensed =
            condense(&equations[0], &support, Some(&cuts), &loads, &loads, &Interrupt::never()).unwrap();
        let mut ring =
            RingFlexibility::new(condensed.stiffness.as_ref().unwrap(), teeth, 2, &Interrupt::never())
                .unwrap();
        assert_eq!(
            ring.release(of_sector.constrained, None, &Interrupt::never()).unwrap().is_some(),
            raceway.is_some()
        );
        let direct = Direct::beside(
            &equations[1],
            &absent(whole),
            &whole.rigid_body_modes(),
            &means(whole, None).forms,
        );
        agree([&equations[0], &equations[1]], (&condensed, &ring), &direct, &points, pitch);
    }
}

/// Returns a sector of a plain ring, with its middle on the x axis.
pub(super) fn plain_sector(radii: [f64; 2], sectors: u32, [around, through]: [usize; 2]) -> PlaneModel {
    let half = PI / f64::from(sectors);
    let polar = |radius: f64, at: f64| [radius * at.cos(), radius * at.sin()];
    let [inner, outer] = radii;
    let uniform = calyx_fe::block::uniform;
    let block = Block::new(
        Curve::arc([0.0; 2], inner, half, -half),
        Curve::line(polar(inner, -half), polar(outer, -half)),
        Curve::arc([0.0; 2], outer, half, -half),
        Curve::line(polar(inner, half), polar(outer, half)),
    )
    .divided(uniform(around), uniform(through))
    .named(Side::Bottom, "bore")
    .named(Side::Top, "rim")
    .named(Side::Left, "cut_last")
    .named(Side::Right, "cut_first");
    let mut builder = MeshBuilder::new();
    builder.block(block);
    PlaneModel::new(builder.finish(ElementOrder::CUBIC).unwrap(), STEEL, Plane::Strain)
}

/// Loads on a plain ring, and their compliances at offsets of sectors.
struct PlainRing {
    condensed: Condensed,
    ring: RingFlexibility,
    sectors: u32,
}

impl PlainRing {
    fn new(radii: [f64; 2], sectors: u32, support: BoreSupport, points: &[([f64; 3], [f64; 3])]) -> Self {
        let model = plain_sector(radii, sectors, [2, 2]);
        let equations = Assembled::plane(&model);
        let nodes = |name: &str| model.mesh.chain_nodes(model.mesh.chain(name).unwrap());
        let pitch = TAU / f64::from(sectors);
        let (bore, means) = match RequestedMeans::for_ring(support) {
            None => (nodes("bore"), None),
            Some(wanted) => {
                let bore = model.mesh.chain("bore").unwrap();
                (vec![], BoreMeans::plane(&model, bore, wanted, &Interrupt::never()).unwrap())
            }
        };
        let cuts =
            match_cuts(&equations.positions, &nodes("cut_first"), &nodes("cut_last"), &bore, pitch).unwrap();
        let constrained = equations.dofs_of(&bore);
        let support = Support::for_ring(&constrained, means.as_ref());
        let loads: Vec<_> = points.iter().map(|&(at, along)| force(&equations, at, along, 0.0)).collect();
        let condensed =
            condense(&equations, &support, Some(&cuts), &loads, &[], &Interrupt::never()).unwrap();
        let ring = RingFlexibility::new(
            condensed.stiffness.as_ref().unwrap(),
            sectors,
            sectors / 2,
            &Interrupt::never(),
        )
        .unwrap();
        Self { condensed, ring, sectors }
    }

    /// Returns the displacement along a load a number of sectors ahead by another one.
    fn between(&self, observed: usize, loaded: usize, ahead: u32) -> f64 {
        let cuts = self.ring.at(ahead) * self.condensed.on_cuts.col(loaded);
        let own = if ahead == 0 { self.condensed.own[(observed, loaded)] } else { 0.0 };
        self.condensed.on_cuts.col(observed).transpose() * &cuts + own
    }
}

const FREE: BoreSupport = BoreSupport::Means { harmonics: None, degree: 1 };

/// Two opposite forces lengthen a thin ring across them by (2/pi - 1/2) P R³/(E I) and shorten it
/// along them by (pi/4 - 2/pi) of that (Timoshenko, Strength of Materials, part I); the frame
/// carries none of them. Tension and shear add terms of (h/R)².
#[test]
fn a_thin_ring_with_a_free_bore_ovalises_as_theory_has_it() {
    let (thickness, sectors) = (0.02, 24);
    let radii = [1.0 - 0.5 * thickness, 1.0 + 0.5 * thickness];
    // At mid-thickness, so that the local indentation of the load is not included.
    let ring = PlainRing::new(radii, sectors, FREE, &[([1.0, 0.0, 0.0], [1.0, 0.0, 0.0])]);
    let half = ring.sectors / 2;
    let bending = STEEL.surface_modulus(Plane::Strain) * thickness.powi(3) / 12.0;
    let along = 2.0 * (ring.between(0, 0, 0) + ring.between(0, 0, half)) * bending;
    let across = -4.0 * ring.between(0, 0, half / 2) * bending;
    let (along_theory, across_theory) = (PI / 4.0 - 2.0 / PI, 2.0 / PI - 0.5);
    assert!((along / along_theory - 1.0).abs() < 2e-3, "{along} against {along_theory}");
    assert!((across / across_theory - 1.0).abs() < 2e-3, "{across} against {across_theory}");
}

/// A torque on the outside of a ring with a constrained mean rotation twists it like one on a rigid
/// bore if the shear at the bore is axisymmetric: u/r = T/(4 pi G) (1/a² - 1/b²). Equal tangential
/// forces on all sectors provide the torque.
#[test]
fn torque_goes_through_the_mean_rotation_as_through_a_rigid_bore() {
    // A sufficient number of sectors, so that the harmonics of their loads have decayed at the
    // observed point.
    let ([a, b], sectors) = ([0.6, 1.0], 40);
    let point = [([b, 0.0, 0.0], [0.0, 1.0, 0.0])];
    let shear = 0.5 * STEEL.youngs_modulus / (1.0 + STEEL.poissons_ratio);
    let inside = [([0.8, 0.0, 0.0], [0.0, 1.0, 0.0]), point[0]];
    let mean = |support| {
        let ring = PlainRing::new([a, b], sectors, support, &inside);
        // Sum over all sectors; those behind are mirror images of those ahead, about the load.
        (0..sectors).map(|offset| ring.between(0, 1, offset.min(sectors - offset))).sum::<f64>()
    };
    let torque = f64::from(sectors) * b;
    let expected = 0.8 * torque / (4.0 * PI * shear) * (1.0 / (a * a) - 1.0 / 0.64);
    // Forces at nodes, on elements that do not resolve their local indentation.
    let [rigid, free] = [BoreSupport::Rigid, FREE].map(mean);
    assert!((rigid / expected - 1.0).abs() < 1e-2, "{rigid:e} against {expected:e}");
    assert!((free / rigid - 1.0).abs() < 1e-3, "{free:e} against {rigid:e}");
}

/// With an increasing number of terms a bore becomes rigid, monotonically from the more compliant
/// side. If the bore is far away, the number of terms hardly matters.
#[test]
fn more_terms_of_the_series_make_a_bore_rigid() {
    let compliance = |radii, support| {
        PlainRing::new(radii, 16, support, &[([1.0, 0.0, 0.0], [1.0, 0.0, 0.0])]).between(0, 0, 0)
    };
    let rim = [0.85, 1.0];
    let rigid = compliance(rim, BoreSupport::Rigid);
    let mut before = compliance(rim, FREE) - rigid;
    assert!(before > 10.0 * rigid, "a rim of this thickness bends: {before:e}, {rigid:e}");
    for harmonics in [0, 2, 4, 8, 16] {
        let more = compliance(rim, BoreSupport::Means { harmonics: Some(harmonics), degree: 0 }) - rigid;
        assert!(more >= 0.0 && more < before, "{harmonics}: {more:e} of {before:e}");
        before = more;
    }
    assert!(before < 0.03 * rigid, "{before:e} of {rigid:e}");
    let thick = [0.3, 1.0];
    let share = compliance(thick, FREE) / compliance(thick, BoreSupport::Rigid) - 1.0;
    assert!((0.0..0.2).contains(&share), "{share}");
}

#[test]
fn exchanging_load_and_observer_keeps_every_bit_on_a_free_bore() {
    let teeth = 6;
    let (model, surfaces) = toothed_sector(teeth, 1.0, COARSE);
    let source = RingSource { support: FREE, ..ring_source(teeth) };
    let structure =
        ElasticStructure::ring(&model, &source, &surfaces, &SplitOptions::default(), &Interrupt::never())
            .unwrap();
    let points = [0.9, 0.1, 0.33].map(|share| share * structure.reference_length());
    for (a, b) in [(0, 0), (0, 1), (1, 3), (0, 3)] {
        let [a, b] = [Chart { tooth: a, surface: 0 }, Chart { tooth: b, surface: 1 }];
        let (mut block, mut exchanged) = (vec![0.0; 9], vec![0.0; 9]);
        structure.add_compliance(a, &points, b, &points, &mut block);
        structure.add_compliance(b, &points, a, &points, &mut exchanged);
        for i in 0..3 {
            for j in 0..3 {
                assert_eq!(block[3 * i + j].to_bits(), exchanged[3 * j + i].to_bits());
            }
        }
    }
}

/// Teeth too far apart for tables of their own are coupled through their cuts with the same result
/// as by tables.
#[test]
fn distant_teeth_feel_each_other_through_the_bore() {
    let teeth = 16;
    let (model, surfaces) = toothed_sector(teeth, 1.0, COARSE);
    let ring = |coupled| {
        let source = RingSource { support: FREE, coupled, ..ring_source(teeth) };
        ElasticStructure::ring(&model, &source, &surfaces, &SplitOptions::default(), &Interrupt::never())
            .unwrap()
    };
    let (all, near) = (ring(8), ring(2));
    let restored = {
        let profiles: Vec<_> = surfaces.iter().map(|surface| surface.profile.clone()).collect();
        ElasticStructure::restored(&near.stored().unwrap(), &profiles).unwrap()
    };
    let points = [0.2, 0.6, 0.9].map(|share| share * all.reference_length());
    let block = |structure: &ElasticStructure, a: Chart, b: Chart| {
        let mut block = vec![0.0; 9];
        structure.add_compliance(a, &points, b, &points, &mut block);
        block
    };
    let at = |tooth, surface| Chart { tooth, surface };
    let scale = block(&all, at(4, 0), at(3, 0)).iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    let (mut largest, mut worst) = (0.0_f64, 0.0_f64);
    for (a, b) in [(3, 0), (0, 4), (5, 0), (8, 0), (1, 9), (2, 12)] {
        for (side, other) in [(0, 0), (0, 1), (1, 0)] {
            let (a, b) = (at(a, side), at(b, other));
            let (exact, found) = (block(&all, a, b), block(&near, a, b));
            for (exact, found) in exact.iter().zip(&found) {
                largest = largest.max(exact.abs());
                worst = worst.max((exact - found).abs() / scale);
                assert!(
                    (exact - found).abs() < 1e-9 * scale,
                    "{a:?} {b:?}: {exact:e} {found:e} of {scale:e}"
                );
            }
            let exchanged = block(&near, b, a);
            for (row, column) in (0..9).map(|k| (k / 3, k % 3)) {
                assert_eq!(found[3 * row + column].to_bits(), exchanged[3 * column + row].to_bits());
            }
            assert_eq!(found, block(&restored, a, b));
            let load = [SurfaceLoad { chart: b, s: points[1], force: 1.0 }];
            let [exact, found] = [&all, &near].map(|structure| structure.stresses(a.tooth, 0, &load));
            let most =
                all.stresses(b.tooth, 0, &load).iter().fold(0.0_f64, |most, (_, at)| most.max(at.abs()));
            for ((_, exact), (_, found)) in exact.iter().zip(&found) {
                assert!((exact - found).abs() < 1e-9 * most, "{a:?} {b:?}: {exact:e} {found:e} of {most:e}");
            }
        }
    }
    println!("off by {worst:.1e} of what neighbours do to each other");
    assert!(largest > 0.05 * scale, "they do feel each other: {largest:e} of {scale:e}");
}

/// A mesh cannot resolve more harmonics than it has nodes.
#[test]
fn a_series_beyond_the_mesh_is_refused() {
    let model = plain_sector([0.8, 1.0], 4, [1, 1]);
    let equations = Assembled::plane(&model);
    let nodes = |name: &str| model.mesh.chain_nodes(model.mesh.chain(name).unwrap());
    let cuts =
        match_cuts(&equations.positions, &nodes("cut_first"), &nodes("cut_last"), &[], FRAC_PI_2).unwrap();
    let bore = model.mesh.chain("bore").unwrap();
    let wanted = RequestedMeans::of_means(Some(9), 0);
    let means = BoreMeans::plane(&model, bore, wanted, &Interrupt::never()).unwrap().unwrap();
    let support = Support::Means { constrained: &[], means: &means };
    let condensed = condense(&equations, &support, Some(&cuts), &[], &[], &Interrupt::never()).unwrap();
    let ring = RingFlexibility::new(condensed.stiffness.as_ref().unwrap(), 4, 1, &Interrupt::never());
    assert_eq!(ring.err(), Some(crate::StructureError::CoarseBore));
}
