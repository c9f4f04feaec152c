//! Webs with a separate mesh: their stiffness against closed forms, and rings on them against one
//! mesh of the whole.

use super::bodies::STEEL;
use super::bore::plain_sector;
use crate::bore::{BoreConstraints, BoreMeans, RequestedMeans};
use crate::condense::{Assembled, Support, condense, match_cuts};
use crate::ring::RingFlexibility;
use crate::{BoreSupport, RevolvedWeb};
use calyx_fe::material::Plane;
use calyx_fe::solid::{RevolutionSurface, SolidMesh, SolidModel};
use calyx_fe::{Block, Curve, ElementOrder, MeshBuilder, PlaneModel, Section, Side, Station};
use calyx_numerics::interrupt::Interrupt;
use faer::Mat;
use faer::linalg::solvers::Solve;
use std::f64::consts::{PI, TAU};

const FREE: BoreSupport = BoreSupport::Means { harmonics: None, degree: 1 };

pub fn disc([a, b]: [f64; 2], [from, to]: [f64; 2], support: BoreSupport) -> RevolvedWeb {
    let at = |radius| Station { radius, ends: [from, to] };
    let section = Section::new(vec![at(a), at(b)]).unwrap();
    RevolvedWeb { section, material: STEEL, support, harmonics: 3, degree: 2, fineness: 1 }
}

/// Returns the forces by rigid-body motions of the outer surface, in the order of
/// [`SolidModel::rigid_body_modes`].
fn stiffness(web: &RevolvedWeb) -> [f64; 6] {
    let [_, outside] = web.section.outermost();
    let cylinder = RevolutionSurface::cylinder(outside.radius, outside.ends);
    let wanted = RequestedMeans {
        harmonics: Some(web.harmonics),
        degree: web.degree,
        spline_teeth: None,
        with_clearance: false,
        raceway: None,
    };
    let patterns = BoreConstraints::new(cylinder, wanted, false).unwrap();
    let all = web.stiffness(&patterns, &Interrupt::never()).unwrap();
    [0, 1, 2, 3, 4, 5].map(|motion| all[(motion, motion)])
}

/// Pure shear: T/phi = 4 pi G h / (1/a² - 1/b²); the shear at the bore is axisymmetric, so its type
/// of support does not matter.
#[test]
fn torsion_of_a_disc() {
    let shear = 0.5 * STEEL.youngs_modulus / (1.0 + STEEL.poissons_ratio);
    let [a, b] = [0.4, 1.0_f64];
    let expected = |h: f64| 4.0 * PI * shear * h / (a.powi(-2) - b.powi(-2));
    for support in [BoreSupport::Rigid, FREE] {
        for h in [0.05, 0.3] {
            let found = stiffness(&disc([a, b], [0.1, 0.1 + h], support))[5];
            assert!((found / expected(h) - 1.0).abs() < 1e-5, "{support:?}, {h}: {found:e}");
        }
    }
}

/// Kirchhoff plates between a clamped hub and a rigid rim. Tilted:
/// `w = (A r + B r³ + C/r + D r ln r) cos t`, with a moment of 4 pi D times the bending stiffness.
/// Translated along the axis: `w = A + B r² + C ln r + D r² ln r`, with a force of 8 pi D times it
/// (Timoshenko, Theory of Plates and Shells, sections 15 and 62). Shear makes a plate more
/// compliant in proportion to the square of its thickness.
#[test]
fn tilting_and_dishing_of_a_thin_web() {
    let [a, b] = [0.5, 1.0_f64];
    let last = |rows: &dyn Fn(f64) -> [[f64; 4]; 2], right: [f64; 2]| {
        let ([w_a, slope_a], [w_b, slope_b]) = (rows(a), rows(b));
        let system = [w_a, slope_a, w_b, slope_b];
        let system = Mat::from_fn(4, 4, |row, column| system[row][column]);
        let right = Mat::from_fn(4, 1, |row, _| [0.0, 0.0, right[0], right[1]][row]);
        system.full_piv_lu().solve(&right)[(3, 0)].abs()
    };
    let tilted =
        |r: f64| [[r, r.powi(3), 1.0 / r, r * r.ln()], [1.0, 3.0 * r * r, -1.0 / (r * r), r.ln() + 1.0]];
    let dished =
        |r: f64| [[1.0, r * r, r.ln(), r * r * r.ln()], [0.0, 2.0 * r, 1.0 / r, 2.0 * r * r.ln() + r]];
    let of_plate = [8.0 * PI * last(&dished, [1.0, 0.0]), 4.0 * PI * last(&tilted, [b, 1.0])];
    let errors = |thickness: f64| {
        let bending =
            STEEL.youngs_modulus * thickness.powi(3) / (12.0 * (1.0 - STEEL.poissons_ratio.powi(2)));
        let half = 0.5 * thickness;
        let [x, y, along, about_x, about_y, _] = stiffness(&disc([a, b], [-half, half], BoreSupport::Rigid));
        assert!((x / y - 1.0).abs() < 1e-12 && (about_x / about_y - 1.0).abs() < 1e-12, "alike all around");
        [along / (of_plate[0] * bending) - 1.0, about_x / (of_plate[1] * bending) - 1.0]
    };
    let (thin, thick) = (errors(0.01), errors(0.04));
    println!("plates: {thin:.5?} of one in fifty, {thick:.5?} of one in twelve");
    for (thin, thick) in thin.into_iter().zip(thick) {
        assert!(thin.abs() < 5e-3, "{thin:.1e}");
        assert!(thick < thin && thick > -0.06, "{thick:.1e}");
    }
}

/// Returns a sector of a ring between two radii about mid-face, or the whole ring.
fn rim(radii: [f64; 2], sectors: u32, whole: bool) -> SolidModel {
    let section = if whole { whole_section(radii, sectors) } else { plain_sector(radii, sectors, [1, 1]) };
    let place = |[x, y]: [f64; 2], z: f64| [x, y, z];
    SolidModel::new(SolidMesh::swept(&section.mesh, &[-0.2, -0.05, 0.1, 0.2], 2, &place).unwrap(), STEEL)
}

fn whole_section([inner, outer]: [f64; 2], sectors: u32) -> PlaneModel {
    let mut builder = MeshBuilder::new();
    let half = PI / f64::from(sectors);
    for sector in 0..sectors {
        let middle = f64::from(sector) * TAU / f64::from(sectors);
        let (from, to) = (middle + half, middle - half);
        let polar = |radius: f64, at: f64| [radius * at.cos(), radius * at.sin()];
        let block = Block::new(
            Curve::arc([0.0; 2], inner, from, to),
            Curve::line(polar(inner, to), polar(outer, to)),
            Curve::arc([0.0; 2], outer, from, to),
            Curve::line(polar(inner, from), polar(outer, from)),
        );
        builder.block(block.named(Side::Bottom, "bore"));
    }
    PlaneModel::new(builder.finish(ElementOrder::CUBIC).unwrap(), STEEL, Plane::Strain)
}

/// A ring condensed by sectors and released against its web is equal to the ring solved whole with
/// the web's stiffness on the same series. The web alone carries the resultant force, to rounding:
/// rigid-body motions are exact on both sides.
#[test]
fn a_ring_on_a_web_is_the_whole() {
    let (radii, sectors) = ([0.8, 1.0], 6);
    let web = disc([0.3, 0.8], [-0.05, 0.1], BoreSupport::Rigid);
    let load_at = |[x, y, z]: [f64; 3]| (x - 1.0).abs() < 1e-9 && y.abs() < 1e-9 && (z - 0.2).abs() < 1e-9;
    let direction = [-0.6, 0.64, 0.48];

    let model = rim(radii, sectors, false);
    let nodes = |name: &str| model.mesh.nodes_on(model.mesh.face_set(name).unwrap());
    let equations =
        Assembled::solid(&model.mesh, &Interrupt::never(), || Ok(model.stiffness())).expect("room");
    let pitch = TAU / f64::from(sectors);
    let cuts = match_cuts(&equations.positions, &nodes("cut_first"), &nodes("cut_last"), &[], pitch).unwrap();
    let bore = model.mesh.face_set("bore").unwrap();
    let means = BoreMeans::on_web(&model, bore, &web, sectors, &Interrupt::never()).unwrap().unwrap();
    assert_eq!(means.constrained, 0);
    // Node of the load, or the nearest one.
    let node = model.mesh.nodes.iter().position(|&at| {
        let [x, y, z] = at;
        (x.hypot(y) - 1.0).abs() < 1e-9 && (y.atan2(x) - PI / 6.0).abs() < 1e-9 && (z - 0.2).abs() < 1e-9
    });
    let node = node.unwrap();
    let (sin, cos) = (PI / 6.0).sin_cos();
    let turned =
        [cos * direction[0] - sin * direction[1], sin * direction[0] + cos * direction[1], direction[2]];
    let load = (0..3).map(|axis| (3 * node + axis, turned[axis])).collect();
    let support = Support::Means { constrained: &[], means: &means };
    let condensed = condense(&equations, &support, Some(&cuts), &[load], &[], &Interrupt::never()).unwrap();
    let mut ring = RingFlexibility::new(
        condensed.stiffness.as_ref().unwrap(),
        sectors,
        sectors / 2,
        &Interrupt::never(),
    )
    .unwrap();
    ring.release(0, means.carried.as_ref(), &Interrupt::never()).unwrap().unwrap();
    let found = [0, 1, 2, 3].map(|ahead: u32| {
        let own = if ahead == 0 { condensed.own[(0, 0)] } else { 0.0 };
        condensed.on_cuts.col(0).transpose() * (ring.at(ahead) * condensed.on_cuts.col(0)) + own
    });

    let whole = rim(radii, sectors, true);
    let bore = whole.mesh.face_set("bore").unwrap();
    let means = BoreMeans::on_web(&whole, bore, &web, 1, &Interrupt::never()).unwrap().unwrap();
    let count = whole.dof_count();
    let forms = Mat::from_fn(means.forms.len(), count, |_, _| 0.0);
    let forms = means.forms.iter().enumerate().fold(forms, |mut forms, (row, form)| {
        form.entries.iter().for_each(|&(dof, value)| forms[(row, dof)] = value);
        forms
    });
    let carried = means.carried.as_ref().unwrap();
    let dense = whole.stiffness().to_dense() + forms.transpose() * carried * &forms;
    let load_nodes: Vec<usize> = [0, 1, 2, 3]
        .iter()
        .map(|&ahead| {
            // Cuts of the sectors, where the condensed ring has its loads.
            let angle = PI / 6.0 + f64::from(ahead) * pitch;
            let back = |[x, y, z]: [f64; 3]| {
                [angle.cos() * x + angle.sin() * y, angle.cos() * y - angle.sin() * x, z]
            };
            whole.mesh.nodes.iter().position(|&at| load_at(back(at))).unwrap()
        })
        .collect();
    let force = |ahead: usize| {
        let (sin, cos) = (PI / 6.0 + ahead as f64 * pitch).sin_cos();
        let at = 3 * load_nodes[ahead];
        let parts =
            [cos * direction[0] - sin * direction[1], sin * direction[0] + cos * direction[1], direction[2]];
        Mat::from_fn(count, 1, |row, _| if (at..at + 3).contains(&row) { parts[row - at] } else { 0.0 })
    };
    let moved = dense.partial_piv_lu().solve(force(0));
    for (ahead, found) in found.into_iter().enumerate() {
        let exact = (force(ahead).transpose() * &moved)[(0, 0)];
        let scale = (force(0).transpose() * &moved)[(0, 0)];
        assert!((found - exact).abs() < 1e-9 * scale, "{ahead}: {found:e}, {exact:e}");
    }
    let forces = carried * (&forms * &moved);
    for motion in whole.rigid_body_modes() {
        let motion = Mat::from_fn(count, 1, |row, _| motion[row]);
        let borne = (forces.transpose() * (&forms * &motion))[(0, 0)];
        let applied = (force(0).transpose() * &motion)[(0, 0)];
        assert!((borne - applied).abs() < 1e-9, "{borne}, {applied}");
    }
}
