//! A gear as the engine's prototype of a body: its data, and the elastic structure made of them when the plan says so.

use crate::blank::Rim;
use crate::error::GeometryError;
use crate::external::ExternalGear;
use crate::fillet::Side;
use crate::flank::Flank;
use crate::modification::{Modification, ReliefShape, TipRelief};
use crate::modified::reshaped;
use crate::sector_mesh::{Refinement, sector_mesh};
use calyx_runtime::cache::{Key, KeyWriter};
use calyx_runtime::error::EngineError;
use calyx_runtime::fe::{ElementOrder, PlaneModel};
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::material::{Material, Plane};
use calyx_runtime::profile::Profile;
use calyx_runtime::scene::{Fidelity, Ignored, Prototype, StructureOptions};
use calyx_runtime::structure::{ElasticStructure, RingSource, SplitOptions, Structure, SurfaceSource};
use std::sync::Arc;

/// Loaded teeth this far apart feel each other's load through the rim; more distant ones hardly do.
const COUPLED_TEETH: u32 = 3;
/// Places of recovered stress on each element edge along a fillet.
const STRESS_PLACES_PER_EDGE: usize = 4;
/// Modifications up to this depth in modules do without a mesh of their own, so that structures are shared by all of them. Against a
/// mesh that follows the flank, on the chapter 5 pair at this depth, it moves transmission error by 0.2, mesh stiffness by 0.7 and root
/// stress by 0.6 thousandths (`tests/pair/sharing.rs`). For root stress that is below what a finer mesh moves it by, for the other two a few
/// times above.
pub const DEEPEST_SHARED: f64 = 0.02;
/// Rounding in modules that stands for a sharp tip edge where contact is confined to the nominal path.
const SHARP_EDGE: f64 = 1e-6;
/// Largest rounding in modules of such an edge in the mesh, which cannot do without.
const SHARP_EDGE_IN_MESH: f64 = 5e-3;
/// Largest length of cubic elements per distance from the tip edge.
const COARSEST_TIP_GROWTH: f64 = 0.4;

/// An external gear on its rim.
pub struct GearPrototype {
    /// Its teeth.
    pub gear: ExternalGear,
    /// What is taken off its flanks.
    pub modifications: Vec<Modification>,
    /// What it is made of.
    pub material: Material,
    /// What carries the teeth.
    pub rim: Rim,
    /// m.
    pub face_width: f64,
    /// Angle by which each tooth stands off its place, rad; teeth beyond the list stand right.
    pub pitch_errors: Vec<f64>,
    flanks: [Arc<Flank>; 2],
}

impl GearPrototype {
    /// # Errors
    /// The modifications do not fit the flanks.
    pub fn new(
        gear: ExternalGear,
        modifications: Vec<Modification>,
        material: Material,
        rim: Rim,
        face_width: f64,
        pitch_errors: Vec<f64>,
    ) -> Result<Self, Vec<GeometryError>> {
        let flanks = flanks(&gear, &modifications)?;
        Ok(GearPrototype { gear, modifications, material, rim, face_width, pitch_errors, flanks })
    }

    /// The flanks contact sees: counter-clockwise and clockwise.
    pub fn flanks(&self) -> &[Arc<Flank>; 2] {
        &self.flanks
    }

    /// Roundings of the tip edge in m: of the curves that contact sees, and of the mesh.
    fn roundings(&self, options: &StructureOptions) -> [f64; 2] {
        let (module, own) = (self.gear.rack.module, self.gear.tip_edge_radius);
        if options.sharp_edges {
            [SHARP_EDGE * module, own.min(SHARP_EDGE_IN_MESH * module)]
        } else {
            [own, own]
        }
    }

    /// Flanks with a rounding of the tip edge, m.
    fn flanks_with(
        &self,
        tip_edge_radius: f64,
        modifications: &[Modification],
    ) -> Result<[Arc<Flank>; 2], EngineError> {
        flanks(&ExternalGear { tip_edge_radius, ..self.gear.clone() }, modifications)
            .map_err(|_| EngineError::new("E0677", "the flanks cannot run up to the tip circle", ""))
    }

    /// The modifications that the mesh follows: none if they are shallow enough for the mesh of the plain gear.
    fn meshed_modifications(&self) -> &[Modification] {
        let deepest = self.flanks.iter().map(|flank| flank.deepest()).fold(0.0, f64::max);
        if deepest <= DEEPEST_SHARED * self.gear.rack.module { &[] } else { &self.modifications }
    }

    fn is_modified(&self) -> bool {
        self.flanks.iter().any(|flank| flank.is_modified())
    }
}

fn flanks(
    gear: &ExternalGear,
    modifications: &[Modification],
) -> Result<[Arc<Flank>; 2], Vec<GeometryError>> {
    let flank = |side| Flank::new(gear, modifications, side).map(Arc::new);
    Ok([flank(Side::CounterClockwise)?, flank(Side::Clockwise)?])
}

/// The default mesh, `factor` times as fine in every direction.
fn refinement(factor: f64, order: usize) -> Refinement {
    let times = |count: usize| ((count as f64 * factor).round() as usize).max(1);
    let base = Refinement::MEDIUM;
    Refinement {
        layers: times(base.layers),
        across: times(base.across),
        flank: base.flank / factor,
        fillet: times(base.fillet),
        edge: times(base.edge),
        // Matching depths count nodes, and must stay well below the distance from the tip edge.
        tip_growth: (base.tip_growth / factor).min(COARSEST_TIP_GROWTH) * order as f64 / 3.0,
        rim_growth: base.rim_growth.powf(1.0 / factor),
        order: ElementOrder::full(order as u8),
    }
}

impl Prototype for GearPrototype {
    fn build(
        &self,
        options: &StructureOptions,
        interrupt: &Interrupt,
    ) -> Result<Arc<dyn Structure>, EngineError> {
        options.check()?;
        interrupt.check()?;
        let refinement = refinement(options.refinement, options.order);
        let [tip, meshed_tip] = self.roundings(options);
        let modifications = self.meshed_modifications();
        let contact = self.flanks_with(tip, modifications)?;
        let meshed = self.flanks_with(meshed_tip, modifications)?;
        let mesh = sector_mesh(&self.gear, meshed, self.rim.inner_radius, &refinement).map_err(|error| {
            EngineError::new(
                "E0676",
                format!("the gear cannot be meshed: {error}"),
                "a rim thicker than a third of the module and a usual tooth form can; please report one that cannot",
            )
            .blame("rim")
        })?;
        interrupt.check()?;
        let model = PlaneModel::new(mesh, self.material, Plane::Strain);
        let surfaces: Vec<SurfaceSource> = contact
            .iter()
            .enumerate()
            .map(|(surface, flank)| SurfaceSource {
                profile: flank.clone() as Arc<dyn Profile>,
                chain: format!("flank_{surface}"),
                edges: [None, Some(meshed_tip)],
                stress_chain: options.stresses.then(|| format!("fillet_{surface}")),
                stress_places_per_edge: STRESS_PLACES_PER_EDGE,
            })
            .collect();
        let ring = RingSource {
            sectors: self.gear.teeth,
            cuts: ["cut_right", "cut_left"],
            bore: "bore",
            coupled: COUPLED_TEETH.min(self.gear.teeth / 2),
        };
        let split = SplitOptions {
            matching_depth: options.matching_depth,
            reshapable: self.is_modified() && modifications.is_empty(),
            ..SplitOptions::default()
        };
        Ok(Arc::new(ElasticStructure::ring(&model, &ring, &surfaces, &split, interrupt)?))
    }

    /// The modified flanks on the body without modifications, where [`Self::build`] has left them out.
    fn shape(
        &self,
        shared: Arc<dyn Structure>,
        options: &StructureOptions,
    ) -> Result<Arc<dyn Structure>, EngineError> {
        if !self.is_modified() || !self.meshed_modifications().is_empty() {
            return Ok(shared);
        }
        let [tip, _] = self.roundings(options);
        let (modified, plain) = (self.flanks_with(tip, &self.modifications)?, self.flanks_with(tip, &[])?);
        let surfaces =
            modified.iter().zip(&plain).map(|(modified, plain)| reshaped(modified, plain)).collect();
        shared.reshaped(surfaces).ok_or_else(|| {
            EngineError::new("E0677", "the modified flanks do not fit the structure of the gear", "")
        })
    }

    /// All that [`Self::build`] reads. Neither the width of the face, which forces are per unit of, nor pitch errors, which
    /// move teeth without deforming them.
    fn key(&self, options: &StructureOptions) -> Option<Key> {
        let ExternalGear { teeth, rack, tooth_thickness, outer_radius, root_radius, tip_edge_radius, .. } =
            &self.gear;
        let key = Key::of("gear on a rim")
            .count(u64::from(*teeth))
            .numbers(&[rack.module, rack.pressure_angle, rack.tip_radius])
            .numbers(&[*tooth_thickness, *outer_radius, *root_radius, *tip_edge_radius])
            .numbers(&[self.material.youngs_modulus, self.material.poissons_ratio, self.rim.inner_radius])
            .numbers(&[options.refinement, options.matching_depth])
            .count(options.order as u64)
            .flag(options.stresses)
            .flag(options.sharp_edges)
            .flag(self.is_modified());
        let with_modification = |key: KeyWriter, modification: &Modification| match modification {
            Modification::TipRelief(TipRelief { depth, start_roll, shape }) => {
                key.numbers(&[*depth, *start_roll]).flag(*shape == ReliefShape::Linear)
            }
            Modification::Deviation(deviation) => key.numbers(&deviation.samples(&self.gear)),
            // Along the face, which a plane structure does not have.
            Modification::LeadCrown { .. } => key,
        };
        Some(self.meshed_modifications().iter().fold(key, with_modification).finish())
    }

    fn enclosing_radius(&self) -> f64 {
        self.gear.outer_radius
    }

    fn roll_angle(&self, radius: f64) -> Option<f64> {
        (radius >= self.gear.form_radius).then(|| self.gear.roll_at_radius(radius))
    }

    fn face_width(&self) -> f64 {
        self.face_width
    }

    fn pitch_error(&self, tooth: u32) -> f64 {
        self.pitch_errors.get(tooth as usize).copied().unwrap_or(0.0)
    }

    fn ignored(&self, fidelity: Fidelity) -> Vec<Ignored> {
        match fidelity {
            Fidelity::Plane => {
                let crowned = self
                    .modifications
                    .iter()
                    .any(|m| matches!(m, Modification::LeadCrown { depth } if *depth > 0.0));
                let ignored = Ignored {
                    input: "lead_crown".into(),
                    reason: "a plane model has no direction along the face".into(),
                };
                if crowned { vec![ignored] } else { Vec::new() }
            }
        }
    }
}
