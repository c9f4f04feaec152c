//! Gear blanks: everything that describes one gear before mounting, namely its teeth, the body that
//! carries them and its flank modifications.
//!
//! The library functions `external` and `internal` of the language are [`GearBlank::cut`] with
//! arguments for fields.

mod spline;

pub use spline::{RadialFit, SplineSupport};

use crate::error::{GeometryError, Refusal, sentence};
use crate::external::{ExternalGear, ExternalGearData, check_rim};
use crate::gear::Gear;
use crate::helix::Helix;
use crate::internal::{InternalGear, InternalGearData, check_outer_rim};
use crate::modification::Modification;
use crate::prototype::GearPrototype;
use crate::rack::Rack;
use crate::shaper::Shaper;
use crate::web::Web;
use calyx_runtime::fidelity::StructureOptions;
use calyx_runtime::material::Material;
use calyx_runtime::structure::raceway::HIGHEST_DEGREE;
use calyx_runtime::structure::{BoreSupport, SplineTeeth};
use std::sync::Arc;

/// Rim under the teeth, or around those of an internal gear, supported at its far side or by a web.
/// Radii in m.
#[derive(Clone, Debug, PartialEq)]
pub struct Rim {
    /// Radius of the interface between the toothed ring and the rim.
    pub radius: f64,
    /// Radius of the supported surface: the bore, or the outside of an internal gear. The body's
    /// frame supports it.
    pub fixed_radius: f64,
    /// Web between rim and bore, if the rim does not reach the bore.
    pub web: Option<Web>,
    /// Support of this surface by the body's frame.
    pub support: BoreSupport,
}

/// Harmonics of the Fourier series of spline teeth or a raceway that the mesh of any gear resolves
/// per gear tooth.
const SPLINE_HARMONICS_PER_TOOTH: u32 = 4;

impl Rim {
    /// Creates a rim from its two diameters, m. Whether it lies below the teeth is checked with the
    /// gear.
    ///
    /// # Errors
    /// E0665: the inner diameter is not positive, or not smaller than the diameter.
    pub fn new(diameter: f64, inner_diameter: f64) -> Result<Rim, GeometryError> {
        if !(inner_diameter > 0.0 && inner_diameter < diameter) {
            return Err(GeometryError::error(
                "E0665",
                "inner_diameter",
                sentence!["the rim's inner diameter must be positive and smaller than its diameter"],
                sentence![
                    "give an `inner_diameter` between 0 and `diameter`, where the frame of the body supports the rim"
                ],
            ));
        }
        Ok(Rim {
            radius: 0.5 * diameter,
            fixed_radius: 0.5 * inner_diameter,
            web: None,
            support: BoreSupport::Rigid,
        })
    }

    /// Returns the rim with another support at its bore, or at its outside.
    #[must_use]
    pub fn supported_by(self, support: BoreSupport) -> Rim {
        Rim { support, ..self }
    }

    /// Former name of [`Rim::supported_by`].
    #[deprecated(since = "0.1.0", note = "use `supported_by`")]
    #[must_use]
    pub fn held(self, support: BoreSupport) -> Rim {
        self.supported_by(support)
    }

    /// Former name of the field [`Rim::support`].
    #[deprecated(since = "0.1.0", note = "use the field `support`")]
    pub fn hold(&self) -> BoreSupport {
        self.support
    }

    /// Returns the rim with spline teeth as the support of its bore, or of its outside.
    ///
    /// # Errors
    /// E0655: the rim already has a mean constraint there, or the spline teeth are not valid.
    /// E0754: the spline teeth do not permit this clearance.
    pub fn splined(self, spline: &SplineSupport) -> Result<Rim, GeometryError> {
        if self.support != BoreSupport::Rigid {
            return Err(GeometryError::error(
                "E0655",
                "rim",
                sentence!["the rim has a free bore or outer surface, so spline teeth cannot support it"],
                sentence![
                    "leave the rim's `bore` or `outer_surface` \"rigid\"; the spline teeth replace this constraint"
                ],
            ));
        }
        if self.ring_support().is_none() {
            return Err(GeometryError::error(
                "E0655",
                "rim",
                sentence!["spline teeth cannot support a disc web, which has a mesh of its own"],
                sentence!["take a `webbed_rim`, whose web is in the mesh of the teeth"],
            ));
        }
        let (spline_teeth, clearance) = (spline.at(self.fixed_radius)?, spline.clearance);
        if clearance == 0.0 {
            return Ok(self.supported_by(BoreSupport::SplineTeeth(spline_teeth)));
        }
        if spline_teeth.radial.is_some() || self.web.is_some() {
            let what = if spline_teeth.radial.is_some() {
                "centre on a diameter"
            } else {
                "are in the bore of a web"
            };
            return Err(GeometryError::error(
                "E0754",
                "clearance",
                sentence!["spline teeth that ", text what, " cannot have clearance"],
                sentence![
                    "omit `clearance`: a spline with clearance is modelled as two-dimensional contact of its flanks, on a rim without a web"
                ],
            ));
        }
        Ok(self.supported_by(BoreSupport::SplineWithClearance { spline_teeth, clearance }))
    }

    /// Support of a plane model. A plane model cannot represent a web, so it is rigidly supported
    /// at the radius where the web begins.
    pub(crate) fn support_in_plane(&self) -> BoreSupport {
        match (&self.web, self.support) {
            (Some(_), _) => BoreSupport::Rigid,
            // A plane model has a single position along the axis.
            (None, BoreSupport::Means { harmonics, .. }) => BoreSupport::Means { harmonics, degree: 0 },
            (None, BoreSupport::SplineTeeth(spline_teeth)) => {
                BoreSupport::SplineTeeth(SplineTeeth { degree: 0, ..spline_teeth })
            }
            // The contact problem contains the compliance and the clearance of these spline teeth.
            (None, BoreSupport::SplineWithClearance { spline_teeth, .. }) => {
                BoreSupport::SplineWithClearance {
                    spline_teeth: SplineTeeth { degree: 0, tangential: 0.0, ..spline_teeth },
                    clearance: 0.0,
                }
            }
            (None, BoreSupport::Raceway { harmonics, .. }) => BoreSupport::Raceway { harmonics, degree: 0 },
            (None, BoreSupport::Rigid) => BoreSupport::Rigid,
        }
    }

    /// Support of a three-dimensional model.
    pub(crate) fn support_in_space(&self, options: &StructureOptions) -> BoreSupport {
        match self.support {
            BoreSupport::Raceway { harmonics, degree } => BoreSupport::Raceway {
                harmonics,
                degree: (degree + options.raceway_degrees).min(HIGHEST_DEGREE),
            },
            support => support,
        }
    }

    /// Returns numbers that identify a support, for the key of a cached structure.
    pub(crate) fn support_numbers(support: BoreSupport) -> Vec<f64> {
        match support {
            BoreSupport::Rigid => vec![0.0; 3],
            BoreSupport::Means { harmonics: None, .. } => vec![1.0, 0.0, 0.0],
            BoreSupport::Means { harmonics: Some(harmonics), degree } => {
                vec![2.0, f64::from(harmonics), f64::from(degree)]
            }
            BoreSupport::Raceway { harmonics, degree } => vec![5.0, f64::from(harmonics), f64::from(degree)],
            BoreSupport::SplineTeeth(spline_teeth) => Self::spline_numbers(3.0, spline_teeth),
            BoreSupport::SplineWithClearance { spline_teeth, clearance } => {
                [Self::spline_numbers(4.0, spline_teeth), vec![clearance]].concat()
            }
        }
    }

    fn spline_numbers(kind: f64, spline_teeth: SplineTeeth) -> Vec<f64> {
        let SplineTeeth { count, first, width, tangential, radial, degree } = spline_teeth;
        let outwards = radial.map_or([0.0; 2], |radial| [1.0, radial]);
        let around = [kind, f64::from(count), first, width, tangential];
        [&around[..], &outwards, &[f64::from(degree)]].concat()
    }

    /// Checks that the gear has enough teeth to resolve the harmonics of the support: each tooth
    /// contributes at least three nodes, or eight with spline teeth.
    pub(crate) fn check_support(&self, teeth: u32) -> Result<(), GeometryError> {
        self.check_joint(teeth)?;
        match self.ring_support().unwrap_or(BoreSupport::Rigid) {
            BoreSupport::Means { harmonics: Some(harmonics), .. } if u32::from(harmonics) > teeth => {
                Err(GeometryError::error(
                    "E0649",
                    "rim",
                    sentence![
                        "the rim is constrained up to harmonic ", number f64::from(harmonics), ", which requires as many teeth; there are ",
                        number f64::from(teeth)
                    ],
                    sentence!["reduce the circumferential order, or use a rigid constraint"],
                ))
            }
            BoreSupport::SplineTeeth(spline_teeth)
            | BoreSupport::SplineWithClearance { spline_teeth, .. }
                if u32::from(spline_teeth.harmonics()) > SPLINE_HARMONICS_PER_TOOTH * teeth =>
            {
                Err(GeometryError::error(
                    "E0656",
                    "rim",
                    sentence![
                        "the spline teeth of the rim need ", number f64::from(spline_teeth.harmonics()), " harmonics, and a mesh with ",
                        number f64::from(teeth), " teeth has at most ", number f64::from(SPLINE_HARMONICS_PER_TOOTH * teeth)
                    ],
                    sentence!["reduce the number of spline teeth or increase their width"],
                ))
            }
            BoreSupport::Raceway { harmonics, .. }
                if u32::from(harmonics) > SPLINE_HARMONICS_PER_TOOTH * teeth =>
            {
                Err(GeometryError::error(
                    "E0649",
                    "rim",
                    sentence![
                        "the raceway of the rim has ", number f64::from(harmonics), " harmonics, and a mesh with ",
                        number f64::from(teeth), " teeth has at most ", number f64::from(SPLINE_HARMONICS_PER_TOOTH * teeth)
                    ],
                    sentence!["give the rim `bore_harmonics` up to that number"],
                ))
            }
            _ => Ok(()),
        }
    }

    /// Creates a rim around the teeth of an internal gear from its two diameters, m. Whether it
    /// surrounds the teeth is checked with the gear.
    ///
    /// # Errors
    /// E0665: the diameter is not positive, or not smaller than the outer diameter.
    pub fn outer(diameter: f64, outer_diameter: f64) -> Result<Rim, GeometryError> {
        if !(diameter > 0.0 && outer_diameter > diameter && outer_diameter.is_finite()) {
            return Err(GeometryError::error(
                "E0665",
                "outer_diameter",
                sentence!["the rim's diameter must be positive, and its outer diameter must be larger"],
                sentence!["an internal gear is supported at its outer diameter"],
            ));
        }
        Ok(Rim {
            radius: 0.5 * diameter,
            fixed_radius: 0.5 * outer_diameter,
            web: None,
            support: BoreSupport::Rigid,
        })
    }
}

/// Tooth thickness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Thickness {
    /// Arc of the pitch circle, m: transverse, or in the normal plane if the rack is given there.
    Circular(f64),
    /// Profile shift coefficient, see [`Rack::thickness_of_shift`].
    ProfileShift(f64),
}

/// Tool that generates the teeth: a rack those of external gears, a shaper cutter those of internal
/// gears.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tool {
    /// Rack, for an external gear.
    Rack(Rack),
    /// Shaper cutter, for an internal gear.
    Shaper(Shaper),
}

impl Tool {
    /// Returns the transverse module, m.
    pub fn module(&self) -> f64 {
        match self {
            Tool::Rack(rack) => rack.module,
            Tool::Shaper(shaper) => shaper.module,
        }
    }

    /// Returns the tooth thickness for a profile shift coefficient, m; see
    /// [`Rack::thickness_of_shift`] and [`Shaper::thickness_of_shift`].
    pub fn thickness_of_shift(&self, profile_shift: f64) -> f64 {
        match self {
            Tool::Rack(rack) => rack.thickness_of_shift(profile_shift),
            Tool::Shaper(shaper) => shaper.thickness_of_shift(profile_shift),
        }
    }
}

impl From<Rack> for Tool {
    fn from(rack: Rack) -> Tool {
        Tool::Rack(rack)
    }
}

impl From<Shaper> for Tool {
    fn from(shaper: Shaper) -> Tool {
        Tool::Shaper(shaper)
    }
}

/// Input data of an external or internal gear. Lengths in m.
///
/// Every field may be set on its own; the methods that take `self` set the optional ones.
#[derive(Clone, Debug)]
pub struct GearBlank {
    /// Number of teeth: at least 4, or more than the shaper cutter has.
    pub teeth: u32,
    /// Tool that generates the teeth; it determines whether the gear is external or internal.
    pub tool: Tool,
    /// Tip diameter: usually the pitch diameter plus two modules. The tip (minor) diameter of an
    /// internal gear is usually the pitch diameter minus 1.5 to 2 modules.
    pub tip_diameter: f64,
    /// Root diameter: usually the pitch diameter minus 2.5 modules, or plus 2.5 modules for an
    /// internal gear.
    pub root_diameter: f64,
    /// Face width: axial length of the teeth.
    pub face_width: f64,
    /// Helix of the teeth; spur by default.
    pub helix: Helix,
    /// Material of the gear.
    pub material: Material,
    /// Rim that carries the teeth; for an internal gear, see [`Rim::outer`].
    pub rim: Rim,
    /// True for a gear that is solid to its axis: the material inside the supported surface of the
    /// rim is rigid, and has mass.
    pub solid: bool,
    /// Tooth thickness.
    pub thickness: Thickness,
    /// Radius of the rounded tip edge; `None` selects [`crate::external::DEFAULT_TIP_EDGE`]
    /// modules.
    pub tip_edge_radius: Option<f64>,
    /// Modifications of both flanks of every tooth.
    pub modifications: Vec<Modification>,
    /// Cumulative pitch deviation (index deviation, ISO 1328-1) of each tooth along the reference
    /// circle, m, counter-clockwise from tooth 0. Teeth beyond the list have none.
    pub pitch_errors: Vec<f64>,
}

impl GearBlank {
    /// Creates a spur gear with standard proportions: no profile shift, steel, face width ten
    /// modules. An external gear has an addendum of one module, a dedendum of 1.25 and a rim
    /// thickness of one and a half modules under the tooth spaces; an internal gear has 0.8, 1.25
    /// and two modules around them. Every field can be changed.
    pub fn standard(teeth: u32, tool: impl Into<Tool>) -> GearBlank {
        let tool = tool.into();
        let module = tool.module();
        let pitch_diameter = f64::from(teeth) * module;
        let (tip_diameter, root_diameter, radius, fixed_radius) = match tool {
            Tool::Rack(_) => {
                let root = pitch_diameter - 2.5 * module;
                let radii = [0.5 * root - 0.5 * module, 0.5 * root - 1.5 * module];
                (pitch_diameter + 2.0 * module, root, radii[0], radii[1])
            }
            Tool::Shaper(_) => {
                let root = pitch_diameter + 2.5 * module;
                let radii = [0.5 * root + 0.5 * module, 0.5 * root + 2.0 * module];
                (pitch_diameter - 1.6 * module, root, radii[0], radii[1])
            }
        };
        GearBlank {
            teeth,
            tool,
            tip_diameter,
            root_diameter,
            face_width: 10.0 * module,
            helix: Helix::SPUR,
            material: Material::STEEL,
            rim: Rim { radius, fixed_radius, web: None, support: BoreSupport::Rigid },
            solid: false,
            thickness: Thickness::ProfileShift(0.0),
            tip_edge_radius: None,
            modifications: Vec::new(),
            pitch_errors: Vec::new(),
        }
    }

    /// Sets the tip and the root diameter, m.
    #[must_use]
    pub fn diameters(mut self, tip: f64, root: f64) -> GearBlank {
        (self.tip_diameter, self.root_diameter) = (tip, root);
        self
    }

    /// Sets the face width, m.
    #[must_use]
    pub fn face_width(mut self, face_width: f64) -> GearBlank {
        self.face_width = face_width;
        self
    }

    /// Sets the material.
    #[must_use]
    pub fn material(mut self, material: Material) -> GearBlank {
        self.material = material;
        self
    }

    /// Sets the rim.
    #[must_use]
    pub fn rim(mut self, rim: Rim) -> GearBlank {
        self.rim = rim;
        self
    }

    /// Sets the tooth thickness.
    #[must_use]
    pub fn thickness(mut self, thickness: Thickness) -> GearBlank {
        self.thickness = thickness;
        self
    }

    /// Adds a modification of the flanks.
    #[must_use]
    pub fn modified(mut self, modification: Modification) -> GearBlank {
        self.modifications.push(modification);
        self
    }

    /// Checks the blank and generates the gear. Its warnings are in [`Gear::warnings`].
    ///
    /// # Errors
    /// All errors of the gear that can be detected together: E0604 to E0621 or those of
    /// [`InternalGear::new`], E0640 to E0642 (blaming `modifications`), E0644, E0668, E0693.
    pub fn cut(self) -> Result<Arc<GearPrototype>, Refusal> {
        check_face_width(self.face_width)?;
        let thickness = match self.thickness {
            Thickness::Circular(thickness) => thickness,
            Thickness::ProfileShift(shift) => self.tool.thickness_of_shift(shift),
        };
        let gear = match self.tool {
            Tool::Rack(rack) => Gear::from(self.external(rack, thickness)?),
            Tool::Shaper(shaper) => Gear::from(self.internal(shaper, thickness)?),
        };
        self.rim.check_support(self.teeth)?;
        let pitch_radius = gear.form().pitch_radius;
        let pitch_errors = self.pitch_errors.iter().map(|error| error / pitch_radius).collect();
        let (material, rim, face_width) = (self.material, self.rim, self.face_width);
        let cut = GearPrototype::new(gear, self.modifications, material, rim, face_width, pitch_errors);
        let mut cut = cut.map_err(of_modifications)?.along(self.helix);
        cut.solid = self.solid;
        Ok(Arc::new(cut))
    }

    fn external(&self, rack: Rack, thickness: f64) -> Result<ExternalGear, Refusal> {
        rack.check_plane(&self.helix)?;
        let gear = ExternalGear::new(ExternalGearData {
            teeth: self.teeth,
            rack: rack.transverse(&self.helix),
            tooth_thickness: rack.transverse_thickness(thickness, &self.helix),
            outer_radius: 0.5 * self.tip_diameter,
            root_radius: 0.5 * self.root_diameter,
            tip_edge_radius: self.tip_edge_radius,
        })?;
        check_rim(gear.root_radius, self.rim.radius, self.rim.fixed_radius)?;
        self.rim.check_web(self.face_width)?;
        Ok(gear)
    }

    fn internal(&self, shaper: Shaper, thickness: f64) -> Result<InternalGear, Refusal> {
        let gear = InternalGear::new(InternalGearData {
            teeth: self.teeth,
            shaper,
            tooth_thickness: thickness,
            minor_radius: 0.5 * self.tip_diameter,
            root_radius: 0.5 * self.root_diameter,
            tip_edge_radius: self.tip_edge_radius,
        })?;
        check_outer_rim(gear.root_radius, self.rim.radius, self.rim.fixed_radius)?;
        Ok(gear)
    }
}

/// Checks that the face width is positive.
fn check_face_width(face_width: f64) -> Result<(), GeometryError> {
    if face_width > 0.0 && face_width.is_finite() {
        return Ok(());
    }
    Err(GeometryError::error(
        "E0668",
        "face_width",
        sentence!["the face width must be positive"],
        sentence!["give the width of the toothed part along the axis"],
    ))
}

/// Attributes errors of a relief to the argument `modifications`, because they are only found
/// together with the gear.
fn of_modifications(errors: Vec<GeometryError>) -> Vec<GeometryError> {
    errors.into_iter().map(|error| GeometryError { argument: "modifications", ..error }).collect()
}
