//! Extreme gears: few teeth and many, thin rims, soft and incompressible materials.

use super::case::{Case, Refusal, off, refusal, worst};
use crate::common::pair::{
    COARSE, MESH, Member, PLAIN, PairOptions, SECOND, TORQUE, member, pair, solve_at, steel, system_of,
};
use crate::common::{chapter_5_data, standard_data};
use calyx_gears::blank::Rim;
use calyx_gears::external::ExternalGear;
use calyx_gears::prototype::GearPrototype;
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::observables::Observe;
use calyx_runtime::observables::{MaxRootCompression, MaxRootStress, Observable, TransmissionError};
use calyx_runtime::scene::Prototype;
use calyx_runtime::scene::StructureOptions;
use calyx_runtime::structure::BoreSupport;
use std::sync::LazyLock;

pub fn cases() -> Vec<Case> {
    vec![
        Case::refused("A gear", "1 tooth", "E0604", "no rack can generate it", || refused_teeth(1)),
        Case::refused("A gear", "2 teeth", "E0604", "the same", || refused_teeth(2)),
        Case::refused("A gear", "3 teeth", "E0604", "the same", || refused_teeth(3)),
        Case::holds(
            "A pair of equal gears: root stress",
            "500, 1000 and 2000 teeth",
            3e-2,
            "the rack, which is the limit, approached with the inverse of the number of teeth",
            towards_a_rack,
        ),
        Case::holds(
            "A gear on a free rim thinner than its teeth: root compression, transmission error",
            "rims of 1 and 0.3 modules, a thousandth of the nominal load",
            6e-2,
            "a finer mesh of a higher order",
            || worst([0, 1].map(on_a_thin_rim)),
        ),
        Case::holds(
            "The same: largest root stress",
            "a rim of 1 module",
            0.0,
            "zero: the force flattens the ring and compresses the roots",
            || under(1e-3, 0, COARSE).1[1],
        ),
        Case::warns(
            "The same",
            "a rim of 0.3 modules, the nominal load",
            "so far that contact moves",
            "the load rotates the gears by a radian",
            || under(1.0, 1, COARSE).0,
        ),
        Case::holds(
            "A gear of a nearly incompressible material: root stress",
            "Poisson's ratio 0.45, quadratic elements",
            3e-2,
            "cubic elements of two thirds of the size",
            || nearly_incompressible(0.45, COARSE),
        ),
        Case::holds("The same", "Poisson's ratio 0.4999, cubic elements", 5e-2, "the same", || {
            nearly_incompressible(0.4999, StructureOptions { order: 3, ..COARSE })
        }),
        Case::refused(
            "The same",
            "Poisson's ratio 0.4999, quadratic elements",
            "E0661",
            "the error of the stress would exceed the stress",
            || refusal(soft(0.4999).build(&COARSE, &Interrupt::never())),
        )
        .saying("keeps its volume"),
        Case::refused("A tooth", "a relief of half a module", "E0641", "it would remove the tooth", || {
            let gear = ExternalGear::new(chapter_5_data(20, 0.02, 0.15708)).expect("a gear");
            let relief = calyx_gears::modification::Modification::tip_relief(
                1.27e-3,
                27.25_f64.to_radians(),
                calyx_gears::modification::ReliefShape::Quadratic,
            );
            let rim = PLAIN[0].prototype.rim.clone();
            let made = GearPrototype::new(gear, vec![relief], steel(), rim, 0.0254, Vec::new());
            refusal(made.map_err(|mut errors| errors.remove(0)))
        }),
    ]
}

const FINER: StructureOptions = StructureOptions { refinement: 0.75, order: 3, ..COARSE };
/// Gears of 40 teeth on free rims of 1 and 0.3 modules.
static RIMMED: LazyLock<[Member; 2]> =
    LazyLock::new(|| [1.0, 0.3].map(|modules| Member::new(rimmed(modules))));

fn refused_teeth(teeth: u32) -> Option<Refusal> {
    refusal(ExternalGear::new(standard_data(teeth, 0.0, 0.2)).map_err(|mut errors| errors.remove(0)))
}

/// Largest root stresses of two equal gears with this number of teeth of module 1 mm under this
/// line load, Pa.
fn equal_gears(teeth: u32) -> f64 {
    let gear = member(standard_data(teeth, 0.0, 0.2), 0.01);
    let radius = 0.5e-3 * f64::from(teeth);
    let options = PairOptions {
        gears: [gear.clone(), gear],
        center_distance: 2.0 * radius,
        moment: 2e3 * radius,
        ..PairOptions::chapter_5(&PLAIN)
    };
    solve_at(&options, &[0.4])[0].root_stress[0]
}

/// Deviation of the stresses for three numbers of teeth from a line in their inverse, relative to
/// the stress.
fn towards_a_rack() -> f64 {
    let [few, more, most] = [500, 1000, 2000].map(equal_gears);
    off(more + 0.5 * (more - few), most)
}

/// Gear of 40 teeth on a free rim of this thickness in modules.
fn rimmed(modules: f64) -> GearPrototype {
    let data = chapter_5_data(40, 0.02, 0.15708);
    let fixed_radius = data.root_radius - modules * data.rack.module;
    let rim = Rim {
        radius: data.root_radius - 0.5 * modules * data.rack.module,
        fixed_radius,
        web: None,
        support: BoreSupport::Means { harmonics: None, degree: 0 },
    };
    let gear = ExternalGear::new(data).expect("a sound gear");
    GearPrototype::new(gear, Vec::new(), steel(), rim, 0.0254, Vec::new()).expect("a gear")
}

/// Warnings; root compression, root tension and transmission error under a fraction of the nominal
/// load.
fn under(part: f64, rim: usize, structure: StructureOptions) -> (Vec<String>, [f64; 3]) {
    let gears = [PLAIN[0].clone(), RIMMED[rim].clone()];
    let options = PairOptions { gears, moment: part * TORQUE, ..PairOptions::chapter_5(&PLAIN) };
    let (scene, mesh) = pair(&options);
    let system = system_of(&scene, structure);
    let step = system.solve(mesh.start + 0.75 * mesh.period).expect("equilibrium");
    let of_gear: [&dyn Observable; 3] =
        [&MaxRootCompression(SECOND), &MaxRootStress(SECOND), &TransmissionError(MESH)];
    let found = of_gear.map(|observable| system.value(&step, observable).value);
    (step.warnings, found)
}

fn on_a_thin_rim(rim: usize) -> f64 {
    let [coarse, fine] = [COARSE, FINER].map(|structure| under(1e-3, rim, structure).1);
    worst([0, 2].map(|k: usize| off(coarse[k], fine[k])))
}

/// Gear of 40 teeth of a material with this Poisson's ratio.
fn soft(ratio: f64) -> GearPrototype {
    let mut prototype = rimmed(3.0);
    prototype.material.poissons_ratio = ratio;
    prototype
}

fn nearly_incompressible(ratio: f64, structure: StructureOptions) -> f64 {
    let gears = [PLAIN[0].clone(), Member::new(soft(ratio))];
    let (scene, mesh) = pair(&PairOptions { gears, ..PairOptions::chapter_5(&PLAIN) });
    let [coarse, fine] = [structure, FINER].map(|structure| {
        let system = system_of(&scene, structure);
        let step = system.solve(mesh.start + 0.75 * mesh.period).expect("equilibrium");
        system.value(&step, &MaxRootStress(SECOND)).value
    });
    off(coarse, fine)
}
