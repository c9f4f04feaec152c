//! Compliance of a tooth and stress in its fillet converge under mesh refinement.

use crate::common::{INCH, chapter_5};
use calyx_gears::fillet::Side;
use calyx_gears::flank::Flank;
use calyx_gears::mesh_geometry::MeshGeometry;
use calyx_gears::sector_mesh::{Refinement, sector_mesh};
use calyx_runtime::fe::PlaneModel;
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::material::{Material, Plane};
use calyx_runtime::profile::Profile;
use calyx_runtime::structure::{
    BoreSupport, Chart, ElasticStructure, RingSource, SplitOptions, Structure, SurfaceLoad, SurfaceSource,
};
use std::sync::Arc;

const PSI: f64 = 6894.757293168361;

/// Member of the report's chapter 5 pair with a rigid bore.
struct Member {
    flank: Arc<Flank>,
    structure: ElasticStructure,
}

impl Member {
    fn new(teeth: u32, bore_radius: f64, refinement: &Refinement) -> Self {
        let gear = chapter_5(teeth);
        let flanks = [Side::CounterClockwise, Side::Clockwise]
            .map(|side| Arc::new(Flank::new(&gear, &[], side).expect("a flank")));
        let mesh = sector_mesh(&gear.clone().into(), flanks.clone(), bore_radius * INCH, refinement)
            .expect("a mesh");
        let steel = Material { youngs_modulus: 3e7 * PSI, poissons_ratio: 0.3, density: 7850.0 };
        let model = PlaneModel::new(mesh, steel, Plane::Strain);
        let surfaces = [0, 1].map(|surface| SurfaceSource {
            profile: flanks[surface].clone() as Arc<dyn Profile>,
            chain: format!("flank_{surface}"),
            edges: [None, Some(gear.tip_edge_radius)],
            stress_chain: Some(format!("fillet_{surface}")),
            stress_points_per_edge: 4,
        });
        let ring = RingSource {
            sectors: teeth,
            cuts: ["cut_right", "cut_left"],
            bore: "bore",
            support: BoreSupport::Rigid,
            coupled: 2,
        };
        let structure =
            ElasticStructure::ring(&model, &ring, &surfaces, &SplitOptions::default(), &Interrupt::never());
        let [flank, _] = flanks;
        Self { flank, structure: structure.expect("a structure") }
    }

    /// Compliance between two points of a flank: low-low, low-high, high-high, without the
    /// half-plane's part.
    fn compliance(&self, rolls: [f64; 2]) -> [f64; 3] {
        let chart = Chart { tooth: 0, surface: 0 };
        let s = rolls.map(|degrees| self.flank.s_at_roll(degrees.to_radians()));
        let mut block = [0.0; 4];
        self.structure.add_compliance(chart, &s, chart, &s, &mut block);
        [block[0], block[1], block[3]]
    }

    /// Largest fillet stress under the whole load at a roll angle, psi.
    fn fillet_stress(&self, roll: f64) -> f64 {
        // The torque over the pinion's base radius, on a face of one inch.
        let force = 1064.178 * 4.4482216152605 / INCH;
        let chart = Chart { tooth: 0, surface: 0 };
        let load = SurfaceLoad { chart, s: self.flank.s_at_roll(roll), force };
        let stresses = self.structure.stresses(0, 0, &[load]);
        stresses.iter().map(|(_, stress)| *stress).fold(f64::NEG_INFINITY, f64::max) / PSI
    }
}

#[test]
fn compliance_and_fillet_stress_converge() {
    let coarse = Member::new(20, 0.6, &Refinement::COARSE);
    let medium = Member::new(20, 0.6, &Refinement::MEDIUM);
    // The medium mesh is within 2e-4 (compliance) and 3e-3 (stress) of the fine one.
    let compliance = [&coarse, &medium].map(|member| member.compliance([12.0, 28.0]));
    for k in 0..3 {
        let error = (compliance[0][k] - compliance[1][k]).abs() / compliance[1][k].abs();
        assert!(error < 5e-3, "{compliance:?}");
    }
    let roll = 24.3_f64.to_radians();
    let [rough, stress] = [&coarse, &medium].map(|member| member.fillet_stress(roll));
    assert!((rough - stress).abs() < 1.5e-2 * stress, "{rough}, {stress}");
}

#[test]
fn fillet_stress_agrees_with_a_general_finite_element_program() {
    // Reference values of the chapter 5 pair without modifications, plane strain, one tooth pair
    // carrying the whole load: roll angle of the pinion in degrees, stress in psi in the pinion's
    // and in the gear's fillet.
    let rows = [(20.854, 30762.0, 27588.0), (24.3, 32968.0, 25789.0)];
    let pinion = Member::new(20, 0.6, &Refinement::MEDIUM);
    let gear = Member::new(40, 1.2, &Refinement::MEDIUM);
    let mesh = MeshGeometry::external(&chapter_5(20), &chapter_5(40), 3.0 * INCH).expect("a mesh");
    for (degrees, on_pinion, on_gear) in rows {
        let roll = f64::to_radians(degrees);
        for (name, stress, expected) in [
            ("pinion", pinion.fillet_stress(roll), on_pinion),
            ("gear", gear.fillet_stress(mesh.second_roll(roll)), on_gear),
        ] {
            assert!((stress - expected).abs() < 0.01 * expected, "{name} at {degrees}: {stress}, {expected}");
        }
    }
}
