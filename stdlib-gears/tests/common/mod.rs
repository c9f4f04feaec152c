//! Gears shared by several tests.
#![allow(dead_code, reason = "each test uses some of them")]

pub mod pair;
pub mod rolling;

use calyx_gears::external::{ExternalGear, ExternalGearData};
use calyx_gears::rack::Rack;
use calyx_runtime::cache::OperatorCache;
use calyx_runtime::plan::Plan;
use calyx_runtime::resources::Resources;
use calyx_runtime::scene::{Fidelity, Scene, StructureOptions};
use calyx_runtime::system::System;
use std::sync::{Arc, LazyLock};

/// Structures of all tests. Several tests share some of them, and cached ones have the bits of new
/// ones.
static STRUCTURES: LazyLock<Arc<OperatorCache>> = LazyLock::new(|| Arc::new(OperatorCache::new(1 << 30)));

pub fn resources() -> Resources {
    Resources { cache: Some(STRUCTURES.clone()), ..Resources::default() }
}

/// Plans and builds a scene.
pub fn built(scene: &Scene, fidelity: Fidelity, structure: StructureOptions) -> System<'_> {
    let plan = Plan::new(scene, fidelity, structure).expect("it can be planned");
    System::with(scene, &plan, &resources()).expect("it can be built")
}

pub const INCH: f64 = 0.0254;

/// Data of the 20 or 40 tooth member of the report's chapter 5, by tip radius of the rack and tooth
/// thickness in inches.
pub fn chapter_5_data(teeth: u32, tip_radius: f64, thickness: f64) -> ExternalGearData {
    let (outer, root) = if teeth == 20 { (1.09, 0.88) } else { (2.09, 1.89) };
    let rack = Rack::new(0.1 * INCH, 20.0_f64.to_radians(), tip_radius * INCH).expect("a sound rack");
    ExternalGearData {
        teeth,
        rack,
        tooth_thickness: thickness * INCH,
        outer_radius: outer * INCH,
        root_radius: root * INCH,
        tip_edge_radius: None,
    }
}

pub fn chapter_5(teeth: u32) -> ExternalGear {
    ExternalGear::new(chapter_5_data(teeth, 0.02, 0.15708)).expect("a sound gear")
}

/// Data of a gear of module 1 mm, by profile shift coefficient and tip radius (in modules), with a
/// tip clearance of a quarter.
pub fn standard_data(teeth: u32, shift: f64, tip_radius: f64) -> ExternalGearData {
    let module = 1e-3;
    let rack = Rack::new(module, 20.0_f64.to_radians(), tip_radius * module).expect("a sound rack");
    let pitch_radius = 0.5 * f64::from(teeth) * module;
    ExternalGearData {
        teeth,
        rack,
        tooth_thickness: rack.thickness_of_shift(shift),
        outer_radius: pitch_radius + (1.0 + shift) * module,
        root_radius: pitch_radius - (1.25 - shift) * module,
        tip_edge_radius: None,
    }
}
