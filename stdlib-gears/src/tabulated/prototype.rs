//! Gears with tabulated teeth as prototypes of the engine's bodies.

pub use super::bore::BoreShape;
use super::bore::bore_of;
use super::boundary::root_end;
use super::solid_mesh::{Bore, LoftError, check_sections, solid_mesh};
use super::surface::TabulatedSurface;
use super::table::{Stations, ToothTable};
use super::tooth::Tooth;
use crate::error::Refusal;
use crate::outer_surface::{CUTS, display_options};
use crate::prototype::{COUPLED_TEETH, GearPrototype, SHARP_EDGE, SOURCE};
use crate::sector_mesh::Refinement;
use crate::solid_prototype::{split_options, stress_points};
use crate::stress_recovery::check_recovery;
use crate::template::section;
use calyx_runtime::cache::Key;
use calyx_runtime::error::EngineError;
use calyx_runtime::fe::solid::{SolidElementPoint, SolidMesh, SolidModel};
use calyx_runtime::inertia::Inertia;
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::material::Material;
use calyx_runtime::scene::{
    BodyModel, Fidelity, Ignored, Prototype, StructureOptions, ToothFlanks, ToothMeridian,
};
use calyx_runtime::structure::outer_surface::OuterSurface;
use calyx_runtime::structure::solid::{ElasticSolid, HalfSpaceBody, SolidStructure, SolidSurfaceSource};
use calyx_runtime::structure::{
    BoreSupport, MeshedBody, RingSource, Structure, StructureSize, VisualizationMesh,
};
use calyx_runtime::surface::Surface;
use std::collections::BTreeSet;
use std::sync::{Arc, Mutex, OnceLock};

const FLANKS: usize = 2;
/// Parts of the root's curve in [`Prototype::tooth_meridian`].
const ROOT_PARTS: usize = 16;

/// Input data of a gear with tabulated teeth.
#[derive(Clone, Debug)]
pub struct TabulatedGearData {
    /// Boundary of tooth 0.
    pub table: ToothTable,
    /// Radius of the rounded tip edge, m; `None` selects 0.02 equivalent modules.
    pub tip_edge_radius: Option<f64>,
    /// Material.
    pub material: Material,
    /// Shape of the bore.
    pub bore: BoreShape,
    /// Support of the bore.
    pub support: BoreSupport,
    /// Cumulative pitch deviation of each tooth at the middle of the tooth, m; teeth beyond the
    /// list have none.
    pub pitch_errors: Vec<f64>,
}

/// Gear with tabulated teeth on its rim.
pub struct TabulatedGear {
    /// Input data.
    pub data: TabulatedGearData,
    stations: Stations,
    tooth: Arc<Tooth>,
    bore: Bore,
    /// Pitch deviations as angles, rad.
    pitch_errors: Vec<f64>,
    enclosing_radius: f64,
    /// Options that [`Prototype::check`] has accepted.
    accepted: Mutex<Vec<StructureOptions>>,
    inertia: OnceLock<Inertia>,
}

impl TabulatedGear {
    /// Checks the data and interpolates the tooth.
    ///
    /// # Errors
    /// E0970 to E0972: the table, see [`ToothTable::stations`]. E0973: the bore. E0974: the tip
    /// edge.
    pub fn new(data: TabulatedGearData) -> Result<Arc<Self>, Refusal> {
        let stations = data.table.stations()?;
        let tooth = Arc::new(Tooth::new(&stations, data.tip_edge_radius)?);
        let bore = bore_of(&tooth, data.bore, data.table.pitch_angle)?;
        let middle_radius = tooth.cones.radius(tooth.along(0.0), middle_height(&tooth));
        let pitch_errors = data.pitch_errors.iter().map(|error| error / middle_radius).collect();
        let points = data.table.flanks.iter().flatten().flatten();
        let enclosing_radius = points.map(|[x, y, _]| x.hypot(*y)).fold(0.0, f64::max);
        let (accepted, inertia) = (Mutex::default(), OnceLock::new());
        Ok(Arc::new(Self { data, stations, tooth, bore, pitch_errors, enclosing_radius, accepted, inertia }))
    }

    /// Number of teeth.
    pub fn teeth(&self) -> u32 {
        self.tooth.teeth
    }

    /// Height of the teeth in the middle of the face, m.
    pub fn tooth_height(&self) -> f64 {
        self.stations.tooth_height
    }

    /// Interpolated tooth.
    pub fn tooth(&self) -> &Arc<Tooth> {
        &self.tooth
    }

    /// Axial position of the middle of the bore, relative to the origin of the gear, m.
    pub fn mid_bore(&self) -> f64 {
        self.tooth.placed(0.0, [self.bore.height, 0.0]).position[2]
    }

    /// Bore of the rim.
    pub fn bore(&self) -> &Bore {
        &self.bore
    }

    /// Tooth with the tip edge of an analysis.
    pub(super) fn tooth_of(&self, options: &StructureOptions) -> Result<Arc<Tooth>, EngineError> {
        if !options.sharp_edges {
            return Ok(Arc::clone(&self.tooth));
        }
        let sharp = Tooth::new(&self.stations, Some(SHARP_EDGE * self.tooth.module));
        sharp
            .map(Arc::new)
            .map_err(|error| EngineError::new("E0974", error.message.to_string(), error.help.to_string()))
    }

    /// Contact surfaces of the flanks, counter-clockwise and clockwise.
    ///
    /// # Errors
    /// The tip edge of the options does not fit.
    pub fn surfaces(&self, options: &StructureOptions) -> Result<[Arc<TabulatedSurface>; 2], EngineError> {
        let tooth = self.tooth_of(options)?;
        Ok([0, 1].map(|side| Arc::new(TabulatedSurface::new(Arc::clone(&tooth), side))))
    }

    fn refinement(options: &StructureOptions) -> Refinement {
        section(options.template).refined(options.refinement, options.order)
    }

    /// Three-dimensional mesh of tooth 0 with its sector of the rim, see
    /// [`solid_mesh`].
    ///
    /// # Errors
    /// E0977: the tooth cannot be meshed. Also those of the interrupt.
    pub fn solid_mesh(
        &self,
        options: &StructureOptions,
        interrupt: &Interrupt,
    ) -> Result<SolidMesh, EngineError> {
        options.check()?;
        let tooth = self.tooth_of(options)?;
        let along = GearPrototype::along_face(options);
        solid_mesh(&tooth, &self.bore, &Self::refinement(options), along, interrupt)?.map_err(unmeshable)
    }

    pub(super) fn coupled_teeth(&self) -> u32 {
        COUPLED_TEETH.min(self.teeth() / 2)
    }

    fn sector(
        &self,
        options: &StructureOptions,
        interrupt: &Interrupt,
    ) -> Result<(SolidModel, RingSource<'static>), EngineError> {
        check_recovery(&self.data.material, options)?;
        let mesh = self.solid_mesh(options, interrupt)?;
        let ring = RingSource {
            sectors: self.teeth(),
            cuts: CUTS,
            bore: "bore",
            support: self.data.support,
            coupled: self.coupled_teeth(),
        };
        Ok((SolidModel::new(mesh, self.data.material), ring))
    }

    fn condensed(
        &self,
        options: &StructureOptions,
        interrupt: &Interrupt,
    ) -> Result<ElasticSolid, EngineError> {
        let (model, ring) = self.sector(options, interrupt)?;
        let stress_points = stress_points(&model.mesh, options);
        let tip = self.tooth_of(options)?.tip_edge_radius();
        let source = |(index, surface): (usize, Arc<TabulatedSurface>)| SolidSurfaceSource {
            surface,
            faces: format!("flank_{index}"),
            edges: [None, Some(tip)],
            stress_faces: options.stresses.then(|| format!("fillet_{index}")),
            stress_points,
        };
        let surfaces: Vec<_> = self.surfaces(options)?.into_iter().enumerate().map(source).collect();
        Ok(ElasticSolid::ring(&model, &ring, &surfaces, &split_options(options), interrupt)?)
    }

    /// Inertia of all sectors; `None` if the gear cannot be meshed.
    fn whole_inertia(&self) -> Option<Inertia> {
        let mesh = self.solid_mesh(&StructureOptions::default(), &Interrupt::never()).ok()?;
        let (mut mass, mut first, mut polar, mut square) = (0.0, 0.0, 0.0, 0.0);
        for (element, data) in mesh.elements.iter().enumerate() {
            for (local, weight) in data.coordinate_interpolation.cell().quadrature([5, 5]) {
                let place = SolidElementPoint { element, local };
                let ([x, y, z], [a, b, c]) = (mesh.position(place), mesh.jacobian(place));
                let minor = |i: usize, j: usize| b[i] * c[j] - b[j] * c[i];
                let volume = weight * (a[0] * minor(1, 2) - a[1] * minor(0, 2) + a[2] * minor(0, 1));
                mass += volume;
                first += volume * z;
                polar += volume * (x * x + y * y);
                square += volume * z * z;
            }
        }
        // The sectors repeat around the axis, so only axisymmetric moments remain.
        let scale = f64::from(self.teeth()) * self.data.material.density;
        let about = scale * (0.5 * polar + square);
        Some(Inertia {
            mass: scale * mass,
            moment: [0.0, 0.0, scale * first],
            about: [[about, 0.0, 0.0], [0.0, about, 0.0], [0.0, 0.0, scale * polar]],
        })
    }
}

/// Height of the middle of the tooth in the middle section, m.
fn middle_height(tooth: &Tooth) -> f64 {
    let top = tooth.flank_at(0, tooth.edge_from(0), 0.0).position;
    let [top, _] = tooth.cones.rolled(tooth.along(0.0), top);
    0.5 * (top + root_end(tooth, 0, 0.0)[0])
}

fn unmeshable(error: LoftError) -> EngineError {
    EngineError::new(
        "E0977",
        format!("the gear cannot be meshed: {error}"),
        "check the points for teeth that overlap or fillets that turn back; a thicker rim may help; please report a usual tooth form that fails",
    )
    .blame("flanks")
}

fn without_plane_model() -> EngineError {
    EngineError::new(
        "E0975",
        "a two-dimensional model cannot represent a gear with tabulated teeth, whose section varies along the face",
        "choose the fidelity \"rigid\", \"analytic\", \"medium\", \"thinrim\", \"fineroot\" or \"finest\"",
    )
    .blame("flanks")
}

impl Prototype for TabulatedGear {
    fn check(&self, options: &StructureOptions, three_dimensional: bool) -> Result<(), EngineError> {
        if !three_dimensional {
            return Err(without_plane_model());
        }
        if self.accepted.lock().is_ok_and(|accepted| accepted.contains(options)) {
            return Ok(());
        }
        options.check()?;
        match options.model {
            BodyModel::Rigid | BodyModel::Analytic => self.surfaces(options).map(|_| ())?,
            BodyModel::Elements => {
                check_recovery(&self.data.material, options)?;
                let tooth = self.tooth_of(options)?;
                check_sections(&tooth, &self.bore, &Self::refinement(options)).map_err(unmeshable)?;
            }
        }
        if let Ok(mut accepted) = self.accepted.lock() {
            accepted.push(*options);
        }
        Ok(())
    }

    fn build(&self, _: &StructureOptions, _: &Interrupt) -> Result<Arc<dyn Structure>, EngineError> {
        Err(without_plane_model())
    }

    fn build_solid(
        &self,
        options: &StructureOptions,
        interrupt: &Interrupt,
    ) -> Result<Arc<dyn SolidStructure>, EngineError> {
        options.check()?;
        Ok(match options.model {
            BodyModel::Rigid => {
                let surfaces = self.surfaces(options)?.map(|surface| surface as Arc<dyn Surface>);
                Arc::new(HalfSpaceBody::rigid(surfaces.to_vec(), self.teeth()))
            }
            BodyModel::Analytic => Arc::new(self.analytic(options)?),
            BodyModel::Elements => Arc::new(self.condensed(options, interrupt)?),
        })
    }

    fn solid_key(&self, options: &StructureOptions) -> Option<Key> {
        if options.model != BodyModel::Elements {
            return None;
        }
        let table = &self.data.table;
        let [elements, order] = GearPrototype::along_face(options);
        let mut key = Key::of("tabulated gear").text(SOURCE).count(u64::from(table.teeth)).numbers(&[
            table.pitch_angle,
            self.tooth.tip_edge_radius(),
            self.bore.height,
            self.bore.slope,
        ]);
        for grid in table.flanks.iter().chain(&table.fillets) {
            key = key.count(grid.len() as u64);
            for profile in grid {
                key = key.numbers(profile.as_flattened());
            }
        }
        let material = &self.data.material;
        Some(
            key.numbers(&[material.youngs_modulus, material.poissons_ratio])
                .numbers(&crate::blank::Rim::support_numbers(self.data.support))
                .text(options.template.name())
                .numbers(&[options.refinement, options.matching_depth])
                .count(options.order as u64)
                .count(elements as u64)
                .count(order as u64)
                .flag(options.stresses)
                .flag(options.sharp_edges)
                .finish(),
        )
    }

    fn restore_solid(&self, options: &StructureOptions, stored: &[u8]) -> Option<Arc<dyn SolidStructure>> {
        let surfaces = self.surfaces(options).ok()?.map(|surface| surface as Arc<dyn Surface>);
        Some(Arc::new(ElasticSolid::restored(stored, surfaces.to_vec())?))
    }

    fn outer_surface(
        &self,
        options: &StructureOptions,
        _three_dimensional: bool,
        interrupt: &Interrupt,
    ) -> Result<Option<OuterSurface>, EngineError> {
        let mesh = self.solid_mesh(&display_options(options), interrupt)?;
        Ok(Some(OuterSurface::of_sector(&mesh, CUTS, self.teeth())))
    }

    fn meshed(
        &self,
        options: &StructureOptions,
        _three_dimensional: bool,
        interrupt: &Interrupt,
    ) -> Result<VisualizationMesh, EngineError> {
        match options.model {
            BodyModel::Rigid => return Ok(VisualizationMesh::Unavailable("is rigid")),
            BodyModel::Analytic => {
                return Ok(VisualizationMesh::Unavailable("has teeth of closed forms, without a mesh"));
            }
            BodyModel::Elements => {}
        }
        let (model, ring) = self.sector(options, interrupt)?;
        let surfaces = [0, 1].map(|side| format!("flank_{side}"));
        let mesh = MeshedBody::solid_ring(model, &ring, None, &surfaces, interrupt)?;
        Ok(VisualizationMesh::Mesh(Arc::new(mesh)))
    }

    fn inertia(&self) -> Inertia {
        *self.inertia.get_or_init(|| self.whole_inertia().unwrap_or_default())
    }

    fn size(&self, fidelity: Fidelity, options: &StructureOptions) -> Option<StructureSize> {
        let Fidelity::Solid(_) = fidelity else { return None };
        let mesh = self.solid_mesh(options, &Interrupt::never()).ok()?;
        let nodes = |faces: &str| Some(mesh.nodes_on(mesh.face_set(faces)?));
        let constrained: BTreeSet<usize> = match self.data.support {
            BoreSupport::Rigid => nodes("bore")?.into_iter().collect(),
            _ => BTreeSet::new(),
        };
        let swept = mesh.swept.as_ref()?;
        let layers = swept.stations.len() - 1;
        let order = swept.orders.iter().copied().min().map_or(1, usize::from);
        let split = split_options(options);
        let [per_edge, per_layer] = stress_points(&mesh, options);
        let fillet = mesh.face_set("fillet_0")?.chart.as_ref()?.edges.len();
        let cut = nodes("cut_right")?.iter().filter(|node| !constrained.contains(node)).count();
        let (teeth, window) = (self.teeth(), self.coupled_teeth());
        let stresses = FLANKS * fillet * per_edge * (layers * per_layer + 1);
        Some(StructureSize {
            sectors: teeth,
            elements: mesh.elements.len(),
            dofs: 3 * (mesh.nodes.len() - constrained.len()),
            cut: 3 * cut,
            means: self.data.support.unknowns(false),
            loads: FLANKS * split.samples * split.polynomials(layers, order),
            stresses: if options.stresses { stresses } else { 0 },
            components: 3,
            window,
            mirrored: false,
        })
    }

    fn enclosing_radius(&self) -> f64 {
        self.enclosing_radius
    }

    fn face_width(&self) -> f64 {
        self.tooth.face[1] - self.tooth.face[0]
    }

    fn pitch_error(&self, tooth: u32) -> f64 {
        self.pitch_errors.get(tooth as usize).copied().unwrap_or(0.0)
    }

    fn tooth_flanks(&self) -> Option<ToothFlanks> {
        let surfaces = self.surfaces(&StructureOptions::default()).ok()?;
        let surfaces = surfaces.map(|surface| surface as Arc<dyn Surface>);
        Some(ToothFlanks { teeth: self.teeth(), surfaces })
    }

    fn tooth_meridian(&self) -> Option<ToothMeridian> {
        let tooth = &self.tooth;
        let [from, to] = tooth.face;
        let root = (0..=ROOT_PARTS).map(|k| {
            let v = from + (to - from) * k as f64 / ROOT_PARTS as f64;
            let [x, y, z] = tooth.placed(v, tooth.fillet_at(0, tooth.fillet_length(0), v).position).position;
            [z, x.hypot(y)]
        });
        Some(ToothMeridian { along: tooth.cones.along(), root: root.collect() })
    }

    fn needs_solid_model(&self) -> bool {
        true
    }

    fn ignored(&self, fidelity: Fidelity) -> Vec<Ignored> {
        let (inputs, reason): (&[&str], &str) = match (fidelity, self.data.support) {
            (Fidelity::Rigid, _) => (&["material", "rim"], "rigid bodies do not deform"),
            (Fidelity::Analytic, support) if support != BoreSupport::Rigid => {
                (&["rim"], "closed forms assume a rim that is rigidly supported")
            }
            _ => return Vec::new(),
        };
        inputs.iter().map(|&input| Ignored { input: input.into(), reason: reason.into() }).collect()
    }
}

#[cfg(test)]
mod several_teeth;
#[cfg(test)]
mod tests;
