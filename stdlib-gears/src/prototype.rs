//! Gears as prototypes of the engine's bodies: their data, and the elastic structures built from
//! them as the plan requires.

use crate::accepted_meshes::check_once;
use crate::blank::Rim;
use crate::error::GeometryError;
use crate::fillet::Side;
use crate::flank::Flank;
use crate::gear::{Gear, ToothForm};
use crate::helix::Helix;
use crate::modification::{Modification, along_face, check_faces};
use crate::modified_structure::modified_structure;
use crate::outer_surface::CUTS;
use crate::sector_mesh::{Refinement, sector_mesh};
use crate::solid_prototype::SolidSector;
use crate::stress_recovery::check_recovery;
use calyx_runtime::cache::{Key, KeyWriter};
use calyx_runtime::error::EngineError;
use calyx_runtime::fe::{PlaneMesh, PlaneModel};
use calyx_runtime::inertia::Inertia;
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::material::{Material, Plane};
use calyx_runtime::profile::Profile;
use calyx_runtime::scene::{
    BodyModel, Fidelity, Ignored, Prototype, StructureOptions, ToothFlanks, ToothMeridian,
};
use calyx_runtime::spline_contact::SplineContact;
use calyx_runtime::structure::outer_surface::OuterSurface;
use calyx_runtime::structure::solid::{ElasticSolid, SolidStructure};
use calyx_runtime::structure::{
    BodyModes, BoreSupport, ElasticStructure, MeshedBody, ModifiedSurface, RingSource, SplitOptions,
    Structure, StructureSize, SurfaceSource, VisualizationMesh,
};
use calyx_runtime::surface::Surface;
use std::sync::{Arc, Mutex, OnceLock};

/// Hash of this library's source. It is part of every key, so cached gear structures are only used
/// by the version that meshed them.
pub(crate) const SOURCE: &str = env!("CALYX_SOURCE");
/// Largest distance, in pitches, of teeth with tables for each pair of them. It has no effect on
/// results. Tables are evaluated faster than the coupling of more distant teeth.
pub(crate) const COUPLED_TEETH: u32 = 3;
/// Sampling points of recovered stress per element edge along a fillet.
pub(crate) const STRESS_POINTS_PER_EDGE: usize = 4;
/// Largest depth, in modules, of modifications that the mesh does not follow, so that gears with
/// different modifications share one structure. For the chapter 5 pair at this depth, compared with
/// a mesh that follows the flank, this changes the transmission error by 0.2, the mesh stiffness by
/// 0.7 and the root stress by 0.6 thousandths (`tests/pair/sharing.rs`).
pub const DEEPEST_SHARED: f64 = 0.02;
/// Edge radius, in modules, of a sharp tip edge: contact is confined to the nominal path.
pub(crate) const SHARP_EDGE: f64 = 1e-6;
/// Largest edge radius, in modules, of such an edge in the mesh, which requires one.
const SHARP_EDGE_IN_MESH: f64 = 5e-3;

/// Gear with its rim.
pub struct GearPrototype {
    /// Geometry of the teeth.
    pub gear: Gear,
    /// Helix of the teeth; [`Self::gear`] is their transverse section.
    pub helix: Helix,
    /// Modifications of the flanks.
    pub modifications: Vec<Modification>,
    /// Material of the gear.
    pub material: Material,
    /// Rim that carries the teeth.
    pub rim: Rim,
    /// True for a gear that is solid to its axis, see [`crate::blank::GearBlank::solid`].
    pub solid: bool,
    /// Face width, m.
    pub face_width: f64,
    /// Pitch deviation of each tooth as an angle, rad; teeth beyond the list have none.
    pub pitch_errors: Vec<f64>,
    /// Data of the drawing for the data block; no effect on the analysis.
    pub stated: crate::data_block::StatedData,
    flanks: [Arc<Flank>; 2],
    /// Options that [`Prototype::check`] has accepted, each with a flag for three dimensions.
    accepted: Mutex<Vec<(StructureOptions, bool)>>,
    /// Inertia, once it has been requested: its integration meshes a section.
    inertia: OnceLock<Inertia>,
}

/// Fraction of the usual element number per direction below which a mesh is coarse, as for error
/// estimates. Its matching depths are wide, so a few samples of a flank's compliance suffice.
const COARSE: f64 = 0.5;
const FEW_SAMPLES: usize = 32;

impl GearPrototype {
    /// Creates a spur gear on its rim.
    ///
    /// # Errors
    /// The modifications do not fit the flanks.
    pub fn new(
        gear: impl Into<Gear>,
        modifications: Vec<Modification>,
        material: Material,
        rim: Rim,
        face_width: f64,
        pitch_errors: Vec<f64>,
    ) -> Result<Self, Vec<GeometryError>> {
        let gear = gear.into();
        let flanks =
            check_faces(&modifications, face_width).and_then(|()| flanks(gear.form(), &modifications))?;
        Ok(GearPrototype {
            gear,
            helix: Helix::SPUR,
            modifications,
            material,
            rim,
            solid: false,
            face_width,
            pitch_errors,
            stated: Default::default(),
            flanks,
            accepted: Mutex::default(),
            inertia: OnceLock::new(),
        })
    }

    /// Returns the gear with its teeth along a helix.
    #[must_use]
    pub fn along(self, helix: Helix) -> Self {
        GearPrototype { helix, accepted: Mutex::default(), inertia: OnceLock::new(), ..self }
    }

    /// Counter-clockwise rotation of the transverse section per length along z, rad/m.
    pub fn twist_per_length(&self) -> f64 {
        self.helix.twist_per_length(self.form().pitch_radius)
    }

    /// Starts a key that contains all data of the gear and the name of the keyed quantity.
    pub(crate) fn teeth_and_tool(&self, what: &str) -> KeyWriter {
        let key = Key::of(what).text(SOURCE);
        match &self.gear {
            Gear::External(gear) => key
                .flag(false)
                .count(u64::from(gear.teeth))
                .numbers(&[gear.rack.module, gear.rack.pressure_angle, gear.rack.tip_radius])
                .numbers(&[gear.rack.tip_stretch, gear.tooth_thickness, gear.outer_radius])
                .numbers(&[gear.rack.residual_undercut, gear.rack.protuberance_angle])
                .numbers(&[gear.root_radius, gear.tip_edge_radius]),
            Gear::Internal(gear) => key
                .flag(true)
                .count(u64::from(gear.teeth))
                .count(u64::from(gear.shaper.teeth))
                .numbers(&[gear.shaper.module, gear.shaper.pressure_angle])
                .numbers(&[gear.shaper.addendum, gear.shaper.tip_radius])
                .numbers(&[gear.tooth_thickness, gear.minor_radius])
                .numbers(&[gear.root_radius, gear.tip_edge_radius]),
        }
    }

    /// Transverse section of the teeth.
    pub fn form(&self) -> ToothForm {
        self.gear.form()
    }

    /// Flanks in the contact problem: counter-clockwise and clockwise.
    pub fn flanks(&self) -> &[Arc<Flank>; 2] {
        &self.flanks
    }

    /// Radii of the rounded tip edge in m: of the contact curves, and of the mesh.
    pub(crate) fn roundings(&self, options: &StructureOptions) -> [f64; 2] {
        let ToothForm { module, tip_edge_radius: own, .. } = self.form();
        if options.sharp_edges {
            [SHARP_EDGE * module, own.min(SHARP_EDGE_IN_MESH * module)]
        } else {
            [own, own]
        }
    }

    /// Flanks with a given radius of the tip edge, m.
    pub(crate) fn flanks_with(
        &self,
        tip_edge_radius: f64,
        modifications: &[Modification],
    ) -> Result<[Arc<Flank>; 2], EngineError> {
        flanks(ToothForm { tip_edge_radius, ..self.form() }, modifications)
            .map_err(|_| EngineError::new("E0677", "the flanks cannot run up to the tip circle", ""))
    }

    /// Modifications that the mesh follows; none if they are shallow enough for the mesh of the
    /// plain gear.
    fn meshed_modifications(&self) -> &[Modification] {
        let deepest = self.flanks.iter().map(|flank| flank.deepest()).fold(0.0, f64::max);
        if deepest <= DEEPEST_SHARED * self.form().module { &[] } else { &self.modifications }
    }

    /// Largest distance, in pitches, of teeth with tabulated coupling.
    pub(crate) fn coupled_teeth(&self) -> u32 {
        COUPLED_TEETH.min(self.gear.teeth() / 2)
    }

    /// Two-dimensional mesh of tooth 0 with its sector of the rim.
    pub(crate) fn plane_mesh(&self, options: &StructureOptions) -> Result<PlaneMesh, EngineError> {
        let refinement = Refinement::MEDIUM.refined(options.refinement, options.order);
        let [_, tip] = self.roundings(options);
        let flanks = self.flanks_with(tip, self.meshed_modifications())?;
        sector_mesh(&self.gear, flanks, self.rim.ring_radius(), &refinement).map_err(unmeshable)
    }

    /// Rejects helical teeth, which a plane model cannot represent.
    ///
    /// # Errors
    /// E0623: the teeth are helical.
    pub(crate) fn refuse_helix(&self) -> Result<(), EngineError> {
        if self.helix.is_spur() {
            return Ok(());
        }
        Err(EngineError::new(
            "E0623",
            "a two-dimensional model cannot represent a helical gear, whose contact lines cross the face",
            "make both gears spur gears, with `helix_angle = 0 deg`",
        )
        .blame("helix_angle"))
    }

    /// Checks that the elements of the mesh can recover the stress of the material.
    ///
    /// # Errors
    /// E0661: stress recovery is requested and these elements do not provide it.
    pub(crate) fn check_recovery(&self, options: &StructureOptions) -> Result<(), EngineError> {
        check_recovery(&self.material, options)
    }

    fn plane_sector(
        &self,
        options: &StructureOptions,
        interrupt: &Interrupt,
    ) -> Result<PlaneSector, EngineError> {
        options.check()?;
        interrupt.check()?;
        self.refuse_helix()?;
        self.check_recovery(options)?;
        let [tip, meshed_tip] = self.roundings(options);
        let contact = self.flanks_with(tip, self.meshed_modifications())?;
        let mesh = self.plane_mesh(options)?;
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
                stress_points_per_edge: STRESS_POINTS_PER_EDGE,
            })
            .collect();
        let ring = RingSource {
            sectors: self.gear.teeth(),
            cuts: CUTS,
            bore: "bore",
            support: self.rim.support_in_plane(),
            coupled: self.coupled_teeth(),
        };
        let split = self.split_options(options);
        Ok(PlaneSector { model, surfaces, ring, split })
    }

    /// Key of all inputs that [`Prototype::build`] reads. It excludes the face width, because
    /// forces are per unit of it, and pitch deviations, which move teeth without deforming them.
    fn plane_content(&self, what: &str, options: &StructureOptions) -> KeyWriter {
        let key = self
            .teeth_and_tool(what)
            .numbers(&[self.material.youngs_modulus, self.material.poissons_ratio, self.rim.ring_radius()])
            .numbers(&Rim::support_numbers(self.rim.support_in_plane()))
            .numbers(&[options.refinement, options.matching_depth])
            .count(options.order as u64)
            .flag(options.stresses)
            .flag(options.sharp_edges)
            .flag(self.is_modified());
        let profiles = self.meshed_modifications().iter().filter(|one| one.parts().profile.is_some());
        profiles.fold(key, |key: KeyWriter, one| key.numbers(&one.profile_numbers(&self.form())))
    }

    /// Flank curves of the contact problem for [`Prototype::build`].
    fn meshed_profiles(&self, options: &StructureOptions) -> Option<[Arc<dyn Profile>; 2]> {
        let [tip, _] = self.roundings(options);
        let flanks = self.flanks_with(tip, self.meshed_modifications()).ok()?;
        Some(flanks.map(|flank| flank as Arc<dyn Profile>))
    }

    /// Modified flanks, if [`Prototype::build`] leaves the modifications out of the mesh.
    fn own_surfaces(&self, options: &StructureOptions) -> Result<Option<Vec<ModifiedSurface>>, EngineError> {
        if !self.is_modified() || !self.meshed_modifications().is_empty() {
            return Ok(None);
        }
        let [tip, _] = self.roundings(options);
        let (modified, plain) = (self.flanks_with(tip, &self.modifications)?, self.flanks_with(tip, &[])?);
        Ok(Some(
            modified
                .iter()
                .zip(&plain)
                .map(|(modified, plain)| modified_structure(modified, plain))
                .collect(),
        ))
    }

    pub(crate) fn split_options(&self, options: &StructureOptions) -> SplitOptions {
        SplitOptions {
            matching_depth: options.matching_depth,
            allows_modified_surfaces: self.is_modified() && self.meshed_modifications().is_empty(),
            samples: if options.refinement < COARSE { FEW_SAMPLES } else { SplitOptions::default().samples },
        }
    }

    /// Lists inputs that the analysis ignores.
    fn idle(&self, inputs: &[&str], reason: &str) -> Vec<Ignored> {
        inputs.iter().map(|&input| Ignored { input: input.into(), reason: reason.into() }).collect()
    }

    fn is_modified(&self) -> bool {
        self.flanks.iter().any(|flank| flank.is_modified())
    }
}

/// Two-dimensional tooth with its sector of the rim, and the coupling of the sectors.
struct PlaneSector {
    model: PlaneModel,
    surfaces: Vec<SurfaceSource>,
    ring: RingSource<'static>,
    split: SplitOptions,
}

fn misshapen() -> EngineError {
    EngineError::new("E0677", "the modified flanks do not fit the structure of the gear", "")
}

fn flanks(form: ToothForm, modifications: &[Modification]) -> Result<[Arc<Flank>; 2], Vec<GeometryError>> {
    let flank = |side| Flank::new(form, modifications, side).map(Arc::new);
    Ok([flank(Side::CounterClockwise)?, flank(Side::Clockwise)?])
}

/// Error for a mesh that folds over itself.
pub(crate) fn unmeshable(error: impl std::error::Error) -> EngineError {
    EngineError::new(
        "E0676",
        format!("the gear cannot be meshed: {error}"),
        "a rim thicker than a third of the module and a usual tooth form can; please report one that cannot",
    )
    .blame("rim")
}

impl Prototype for GearPrototype {
    fn check(&self, options: &StructureOptions, three_dimensional: bool) -> Result<(), EngineError> {
        let request = (*options, three_dimensional);
        if self.accepted.lock().is_ok_and(|accepted| accepted.contains(&request)) {
            return Ok(());
        }
        options.check()?;
        if !three_dimensional {
            self.refuse_helix()?;
        }
        let [tip, _] = self.roundings(options);
        self.flanks_with(tip, &self.modifications)?;
        if options.model == BodyModel::Elements {
            self.check_recovery(options)?;
            // In three dimensions the section is swept along the face.
            match three_dimensional {
                true => check_once(self.solid_key(options), || self.check_section_mesh(options))?,
                false => check_once(self.key(options), || self.plane_mesh(options).map(|_| ()))?,
            }
        }
        if let Ok(mut accepted) = self.accepted.lock() {
            accepted.push(request);
        }
        Ok(())
    }

    fn build(
        &self,
        options: &StructureOptions,
        interrupt: &Interrupt,
    ) -> Result<Arc<dyn Structure>, EngineError> {
        match options.model {
            BodyModel::Rigid => return Ok(Arc::new(self.rigid(options)?)),
            BodyModel::Analytic => return Ok(Arc::new(self.analytic(options)?)),
            BodyModel::Elements => {}
        }
        let PlaneSector { model, surfaces, ring, split } = self.plane_sector(options, interrupt)?;
        Ok(Arc::new(ElasticStructure::ring(&model, &ring, &surfaces, &split, interrupt)?))
    }

    fn modes(
        &self,
        options: &StructureOptions,
        highest: f64,
        interrupt: &Interrupt,
    ) -> Result<Option<Arc<BodyModes>>, EngineError> {
        let PlaneSector { model, surfaces, ring, split } = self.plane_sector(options, interrupt)?;
        Ok(Some(Arc::new(BodyModes::ring(&model, &ring, &surfaces, &split, highest, interrupt)?)))
    }

    fn without_modes(&self) -> Option<&'static str> {
        matches!(
            self.rim.support_in_plane(),
            BoreSupport::SplineTeeth(_) | BoreSupport::SplineWithClearance { .. }
        )
        .then_some("spline teeth support it, which breaks the cyclic symmetry")
    }

    fn inertia(&self) -> Inertia {
        *self.inertia.get_or_init(|| self.whole_inertia().unwrap_or_default())
    }

    fn modes_key(&self, options: &StructureOptions, highest: f64) -> Option<Key> {
        Some(
            self.plane_content("modes of a gear on a rim", options)
                .numbers(&[self.material.density, highest])
                .finish(),
        )
    }

    fn restore_modes(&self, options: &StructureOptions, stored: &[u8]) -> Option<Arc<BodyModes>> {
        Some(Arc::new(BodyModes::restored(stored, &self.meshed_profiles(options)?)?))
    }

    fn shape_modes(
        &self,
        shared: Arc<BodyModes>,
        options: &StructureOptions,
    ) -> Result<Arc<BodyModes>, EngineError> {
        let Some(surfaces) = self.own_surfaces(options)? else { return Ok(shared) };
        shared.with_modified_surfaces(surfaces).map(Arc::new).ok_or_else(misshapen)
    }

    /// Modified flanks on the body without modifications, where [`Self::build`] leaves them out.
    fn shape(
        &self,
        shared: Arc<dyn Structure>,
        options: &StructureOptions,
    ) -> Result<Arc<dyn Structure>, EngineError> {
        // Bodies without a mesh already have the modified flanks.
        if options.model != BodyModel::Elements {
            return Ok(shared);
        }
        let Some(surfaces) = self.own_surfaces(options)? else { return Ok(shared) };
        shared.with_modified_surfaces(surfaces).ok_or_else(misshapen)
    }

    fn outer_surface(
        &self,
        options: &StructureOptions,
        three_dimensional: bool,
        interrupt: &Interrupt,
    ) -> Result<Option<OuterSurface>, EngineError> {
        interrupt.check()?;
        self.displayed(options, three_dimensional).map(Some)
    }

    fn meshed(
        &self,
        options: &StructureOptions,
        three_dimensional: bool,
        interrupt: &Interrupt,
    ) -> Result<VisualizationMesh, EngineError> {
        match options.model {
            BodyModel::Rigid => return Ok(VisualizationMesh::Unavailable("is rigid")),
            BodyModel::Analytic => {
                return Ok(VisualizationMesh::Unavailable("has teeth of closed forms, without a mesh"));
            }
            BodyModel::Elements => {}
        }
        let surfaces = [0, 1].map(|side| format!("flank_{side}"));
        let mesh = if three_dimensional {
            let SolidSector { model, ring, web } = self.solid_sector(options, interrupt)?;
            MeshedBody::solid_ring(model, &ring, web.as_ref(), &surfaces, interrupt)?
        } else {
            let PlaneSector { model, ring, .. } = self.plane_sector(options, interrupt)?;
            MeshedBody::ring(model, &ring, &surfaces, interrupt)?
        };
        Ok(VisualizationMesh::Mesh(Arc::new(mesh)))
    }

    /// In three dimensions modified and plain surfaces have the same coordinates.
    fn shape_meshed(
        &self,
        shared: Arc<MeshedBody>,
        options: &StructureOptions,
        three_dimensional: bool,
    ) -> Result<Arc<MeshedBody>, EngineError> {
        let surfaces = if three_dimensional { None } else { self.own_surfaces(options)? };
        Ok(surfaces.map_or(shared.clone(), |surfaces| Arc::new(shared.with_modified_surfaces(surfaces))))
    }

    /// Bodies without a mesh have no key, because building them is faster than a cache lookup.
    fn key(&self, options: &StructureOptions) -> Option<Key> {
        (options.model == BodyModel::Elements).then(|| self.plane_content("gear on a rim", options).finish())
    }

    fn restore(&self, options: &StructureOptions, stored: &[u8]) -> Option<Arc<dyn Structure>> {
        Some(Arc::new(ElasticStructure::restored(stored, &self.meshed_profiles(options)?)?))
    }

    fn build_solid(
        &self,
        options: &StructureOptions,
        interrupt: &Interrupt,
    ) -> Result<Arc<dyn SolidStructure>, EngineError> {
        options.check()?;
        Ok(match options.model {
            BodyModel::Rigid => Arc::new(self.rigid_solid(options)?),
            BodyModel::Analytic => Arc::new(self.analytic_solid(options)?),
            BodyModel::Elements => Arc::new(self.condensed_solid(options, interrupt)?),
        })
    }

    fn restore_solid(&self, options: &StructureOptions, stored: &[u8]) -> Option<Arc<dyn SolidStructure>> {
        let surfaces = self.plain_surfaces(options).ok()?.map(|surface| surface as Arc<dyn Surface>);
        Some(Arc::new(ElasticSolid::restored(stored, surfaces.to_vec())?))
    }

    fn shape_solid(
        &self,
        shared: Arc<dyn SolidStructure>,
        options: &StructureOptions,
    ) -> Result<Arc<dyn SolidStructure>, EngineError> {
        match options.model {
            BodyModel::Rigid | BodyModel::Analytic => Ok(shared),
            BodyModel::Elements => self.modified_solid(shared, options),
        }
    }

    fn solid_key(&self, options: &StructureOptions) -> Option<Key> {
        (options.model == BodyModel::Elements).then(|| self.solid_content(options))
    }

    fn size(&self, fidelity: Fidelity, options: &StructureOptions) -> Option<StructureSize> {
        match fidelity {
            Fidelity::Rigid | Fidelity::Analytic => None,
            Fidelity::Plane => self.plane_size(options),
            Fidelity::Solid(_) => self.solid_size(options),
        }
    }

    fn enclosing_radius(&self) -> f64 {
        // The support of an internal gear's rim encloses the gear.
        self.form().tip_radius.max(self.rim.fixed_radius)
    }

    fn roll_angle(&self, radius: f64) -> Option<f64> {
        let form = self.form();
        let on_involute = form.sense() * (radius - form.form_radius) >= 0.0 && radius >= form.base_radius;
        on_involute.then(|| form.roll_at_radius(radius).abs())
    }

    fn face_width(&self) -> f64 {
        self.face_width
    }

    fn tooth_flanks(&self) -> Option<ToothFlanks> {
        let surfaces = self.surfaces(&StructureOptions::default()).ok()?;
        let surfaces = surfaces.map(|surface| surface as Arc<dyn Surface>);
        Some(ToothFlanks { teeth: self.gear.teeth(), surfaces })
    }

    fn tooth_meridian(&self) -> Option<ToothMeridian> {
        let [half, root] = [0.5 * self.face_width, self.form().root_radius];
        Some(ToothMeridian { along: [1.0, 0.0], root: vec![[-half, root], [half, root]] })
    }

    fn pitch_error(&self, tooth: u32) -> f64 {
        self.pitch_errors.get(tooth as usize).copied().unwrap_or(0.0)
    }

    fn spline_contact(&self) -> Option<SplineContact> {
        match self.rim.support {
            BoreSupport::SplineWithClearance { spline_teeth, clearance } => {
                Some(SplineContact { spline_teeth, clearance, radius: self.rim.fixed_radius })
            }
            _ => None,
        }
    }

    fn needs_solid_model(&self) -> bool {
        !self.helix.is_spur() || along_face(&self.modifications).next().is_some()
    }

    fn ignored(&self, fidelity: Fidelity) -> Vec<Ignored> {
        match fidelity {
            Fidelity::Rigid => self.idle(&["material", "rim"], "rigid bodies do not deform"),
            Fidelity::Analytic => match self.rim.support {
                BoreSupport::Rigid if self.rim.web.is_none() => Vec::new(),
                _ => self.idle(
                    &["rim"],
                    "closed forms assume a rim that is rigidly supported, where its web begins if it has one",
                ),
            },
            Fidelity::Plane => {
                let unseen = along_face(&self.modifications);
                let along_face = |input: &str| Ignored {
                    input: input.into(),
                    reason: "a plane model has no direction along the face".into(),
                };
                let web = self.rim.web.as_ref().map(|_| Ignored {
                    input: "web".into(),
                    reason: "a two-dimensional model has no face-width direction: the rim is supported where the web begins"
                        .into(),
                });
                let on_web =
                    self.rim.web.is_some() && matches!(self.rim.support, BoreSupport::SplineTeeth(_));
                let spline_teeth = on_web.then(|| Ignored {
                    input: "spline_teeth".into(),
                    reason: "they support the bore of a web, which a two-dimensional model does not have"
                        .into(),
                });
                unseen.map(along_face).chain(web).chain(spline_teeth).collect()
            }
            Fidelity::Solid(_) => Vec::new(),
        }
    }
}
