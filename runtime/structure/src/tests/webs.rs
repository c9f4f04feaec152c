//! Discs and webs between a rigid rim and a rigid hub, as rings of sectors: their stiffnesses
//! against closed forms.
//!
//! The outer surface of the ring takes the role of a bore: a rigid-body motion of it is prescribed,
//! all other terms of a series are fixed at zero, and the constraint forces are its stiffness.

use super::bodies::STEEL;
use super::bore::plain_sector;
use crate::bore::{BoreMeans, RequestedMeans};
use crate::condense::{Assembled, Support, condense, match_cuts};
use crate::ring::RingFlexibility;
use calyx_fe::solid::{SolidMesh, SolidModel};
use calyx_numerics::interrupt::Interrupt;
use faer::Mat;
use faer::linalg::solvers::Solve;
use std::f64::consts::{PI, TAU};

/// Annular disc about mid-thickness, with a fixed inner surface.
#[derive(Clone, Copy)]
struct Disc {
    radii: [f64; 2],
    thickness: f64,
    /// Number of elements of the section, circumferential and radial.
    elements: [usize; 2],
}

impl Disc {
    /// Returns the forces by a unit motion of the outer surface, N/m and N m/rad, in the order of
    /// [`SolidModel::rigid_body_modes`].
    fn stiffness(&self) -> [f64; 6] {
        let sectors = 12;
        let section = plain_sector(self.radii, sectors, self.elements);
        let place = |[x, y]: [f64; 2], z: f64| [x, y, z];
        let half = 0.5 * self.thickness;
        let model =
            SolidModel::new(SolidMesh::swept(&section.mesh, &[-half, half], 3, &place).unwrap(), STEEL);
        let nodes = |name: &str| model.mesh.nodes_on(model.mesh.face_set(name).unwrap());
        let equations =
            Assembled::solid(&model.mesh, &Interrupt::never(), || Ok(model.stiffness())).expect("room");
        let bore = nodes("bore");
        let pitch = TAU / f64::from(sectors);
        let cuts =
            match_cuts(&equations.positions, &nodes("cut_first"), &nodes("cut_last"), &bore, pitch).unwrap();
        let rim = model.mesh.face_set("rim").unwrap();
        let wanted = RequestedMeans {
            harmonics: Some(3),
            degree: 3,
            spline_teeth: None,
            with_clearance: false,
            raceway: None,
        };
        let means = BoreMeans::solid(&model, rim, wanted, &Interrupt::never()).unwrap().unwrap();
        let constrained = equations.dofs_of(&bore);
        let support = Support::Means { constrained: &constrained, means: &means };
        let condensed = condense(&equations, &support, Some(&cuts), &[], &[], &Interrupt::never()).unwrap();
        let ring =
            RingFlexibility::new(condensed.stiffness.as_ref().unwrap(), sectors, 0, &Interrupt::never())
                .unwrap();
        let at = ring.at(0);
        let first = at.nrows() - means.shared.count;
        // Means of a unit motion over the surface, which is uncoupled from the terms.
        let [_, b] = self.radii;
        let area = TAU * b * self.thickness;
        let tilt = area * (0.5 * b * b + self.thickness.powi(2) / 12.0);
        let means = [area, area, area, tilt, tilt, area * b * b];
        [0, 1, 2, 3, 4, 5].map(|motion| -at[(first + motion, first + motion)] * means[motion].powi(2))
    }
}

/// Pure shear: T/phi = 4 pi G h / (1/a² - 1/b²), for any thickness.
#[test]
fn torsion_of_a_disc() {
    let shear = 0.5 * STEEL.youngs_modulus / (1.0 + STEEL.poissons_ratio);
    for thickness in [0.05, 0.3] {
        let disc = Disc { radii: [0.4, 1.0], thickness, elements: [2, 3] };
        let [a, b] = disc.radii;
        let expected = 4.0 * PI * shear * thickness / (a.powi(-2) - b.powi(-2));
        let error = disc.stiffness()[5] / expected - 1.0;
        assert!(error.abs() < 1e-4, "{thickness}: {error:.1e}");
    }
}

/// Kirchhoff plate between hub and rim, `w = f(r) cos t` with `f = A r + B r³ + C/r + D r ln r`,
/// clamped inside and rotated with the rim outside: its moment is 4 pi times its bending stiffness
/// times D (Timoshenko, Theory of Plates and Shells, section 62). Shear makes a plate of finite
/// thickness more compliant, in proportion to the square of the thickness.
#[test]
fn tilting_of_a_thin_web() {
    let [a, b] = [0.5, 1.0_f64];
    let rows =
        |r: f64| [[r, r.powi(3), 1.0 / r, r * r.ln()], [1.0, 3.0 * r * r, -1.0 / (r * r), r.ln() + 1.0]];
    let ([w_a, slope_a], [w_b, slope_b]) = (rows(a), rows(b));
    let system = [w_a, slope_a, w_b, slope_b];
    let system = Mat::from_fn(4, 4, |row, column| system[row][column]);
    let right = Mat::from_fn(4, 1, |row, _| [0.0, 0.0, b, 1.0][row]);
    let d = system.full_piv_lu().solve(&right)[(3, 0)].abs();
    let error = |thickness: f64, elements: usize| {
        let bending =
            STEEL.youngs_modulus * thickness.powi(3) / (12.0 * (1.0 - STEEL.poissons_ratio.powi(2)));
        let disc = Disc { radii: [a, b], thickness, elements: [2, elements] };
        let [_, _, _, x, y, _] = disc.stiffness();
        assert!((x / y - 1.0).abs() < 1e-6, "alike about both axes");
        x / (4.0 * PI * bending * d) - 1.0
    };
    // A fixed edge prevents the lateral contraction of its elements under tension over a much
    // larger zone than in an exact disc.
    let (coarse, fine) = (error(0.01, 4), error(0.01, 8));
    assert!(fine > 0.0 && fine < 0.7 * coarse && fine < 1e-2, "{coarse:.1e}, {fine:.1e}");
    let thick = error(0.04, 8);
    assert!(thick < fine && thick > -0.05, "{thick:.1e} against {fine:.1e}");
}

/// Lamé: a ring in plane strain, fixed inside and expanded outside, u = A r + B/r, has the pressure
/// 2 (lambda + mu) A - 2 mu B/r² on its outer surface.
#[test]
fn widening_of_a_thick_ring() {
    let (sectors, [a, b]) = (10, [0.5, 1.0_f64]);
    let model = plain_sector([a, b], sectors, [2, 4]);
    let nodes = |name: &str| model.mesh.chain_nodes(model.mesh.chain(name).unwrap());
    let equations = Assembled::plane(&model);
    let bore = nodes("bore");
    let pitch = TAU / f64::from(sectors);
    let cuts =
        match_cuts(&equations.positions, &nodes("cut_first"), &nodes("cut_last"), &bore, pitch).unwrap();
    let wanted = RequestedMeans {
        harmonics: Some(0),
        degree: 0,
        spline_teeth: None,
        with_clearance: false,
        raceway: None,
    };
    let rim = model.mesh.chain("rim").unwrap();
    let means = BoreMeans::plane(&model, rim, wanted, &Interrupt::never()).unwrap().unwrap();
    assert_eq!(means.shared.count, 4, "three motions of the whole, and widening");
    let constrained = equations.dofs_of(&bore);
    let support = Support::Means { constrained: &constrained, means: &means };
    let condensed = condense(&equations, &support, Some(&cuts), &[], &[], &Interrupt::never()).unwrap();
    let ring =
        RingFlexibility::new(condensed.stiffness.as_ref().unwrap(), sectors, 0, &Interrupt::never()).unwrap();
    let last = ring.at(0).nrows() - 1;
    // Pressure by displacement is force on the mean by the mean, times the circumference.
    let found = -ring.at(0)[(last, last)] * TAU * b;
    let mu = 0.5 * STEEL.youngs_modulus / (1.0 + STEEL.poissons_ratio);
    let lambda = 2.0 * mu * STEEL.poissons_ratio / (1.0 - 2.0 * STEEL.poissons_ratio);
    let factor = 1.0 / (b - a * a / b);
    let expected = factor * (2.0 * (lambda + mu) + 2.0 * mu * a * a / (b * b));
    assert!((found / expected - 1.0).abs() < 1e-5, "{found:e} against {expected:e}");
}

/// Hub and rim displaced against each other in their plane: a web has the same stiffness in both
/// directions. It lies between the bounds of plates without and with constrained thickness in the
/// limit of a thin annulus, where each element is a block under shear and tension.
#[test]
fn radial_stiffness_of_a_narrow_web() {
    let shear = 0.5 * STEEL.youngs_modulus / (1.0 + STEEL.poissons_ratio);
    let ratio = STEEL.poissons_ratio;
    let [a, b] = [0.98, 1.0];
    let thickness = 0.004;
    let [x, y, ..] = Disc { radii: [a, b], thickness, elements: [3, 1] }.stiffness();
    assert!((x / y - 1.0).abs() < 1e-6);
    // Half of the circle is in tension and half in shear: pi r h/(b - a) (E'' + G), with E''
    // between plane stress and constrained thickness.
    let block = |pulled: f64| PI * 0.5 * (a + b) * thickness / (b - a) * (pulled + shear);
    let soft = block(STEEL.youngs_modulus / (1.0 - ratio * ratio));
    let stiff = block(2.0 * shear * (1.0 - ratio) / (1.0 - 2.0 * ratio));
    assert!(x > 0.99 * soft && x < 1.01 * stiff, "{x:e} between {soft:e} and {stiff:e}");
}
