//! Everything said of one gear before it stands anywhere: its teeth, what carries them, what is taken off its flanks.
//!
//! The library's `external` of the language is [`GearBlank::cut`] with arguments for fields.

use crate::disc_web::DiscWeb;
use crate::error::{GeometryError, Refusal, sentence};
use crate::external::{ExternalGear, ExternalGearData, check_rim};
use crate::helix::Helix;
use crate::modification::Modification;
use crate::prototype::GearPrototype;
use crate::rack::Rack;
use calyx_runtime::material::Material;
use calyx_runtime::structure::{BoreSupport, SplineTeeth};
use std::f64::consts::TAU;
use std::sync::Arc;

/// A ring under the teeth, or around those of an internal gear, held on its far side or by a web. Radii in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rim {
    /// Where the toothed part ends and the ring begins.
    pub radius: f64,
    /// Of the bore, or of the outside of an internal gear, where the body's frame holds it.
    pub fixed_radius: f64,
    /// What stands between ring and bore, if the ring does not reach so far.
    pub web: Option<Web>,
    /// How the body's frame holds it there.
    pub hold: BoreSupport,
}

/// Waves around of lugs' series that the mesh of any gear resolves for each of its teeth.
const SPLINE_HARMONICS_PER_TOOTH: u32 = 4;

/// How lugs hold a rim: the teeth of a spline, or keys, evenly around, which bear both ways, without play unless they have clearance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SplineSupport {
    /// How many, three at least; they need not be commensurate with the teeth.
    pub spline_teeth: u16,
    /// Length of each along the bore, m; `None` for half of the distance from one to the next.
    pub width: Option<f64>,
    /// Angle of the middle of the first one from the middle of tooth 0, rad, counter-clockwise.
    pub first: f64,
    /// Force around by displacement, for a unit of a lug's length along the axis, N/m²; `None` if rigid.
    pub stiffness: Option<f64>,
    /// What else holds the bore from moving inwards and outwards at the lugs, if anything does: major-diameter fits.
    pub radial: Option<RadialFit>,
    /// Degree of polynomials along the bore up to which lugs hold it: 0 holds their mean, 1 their leaning too.
    pub axial_order: u8,
    /// By how much the spaces that they stand in are wider, along the circle of the bore, m: half of it is at either flank of a lug in the
    /// middle. With any, lugs are contact in the plane, and carry a body whose frame is free. 0 holds them without play.
    pub clearance: f64,
}

/// How lugs hold a bore from moving inwards and outwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RadialFit {
    /// Force by displacement, for a unit of a lug's length along the axis, N/m²; `None` if rigid.
    pub stiffness: Option<f64>,
}

impl SplineSupport {
    /// Rigid lugs that hold a bore by their flanks.
    pub fn new(spline_teeth: u16) -> SplineSupport {
        SplineSupport {
            spline_teeth,
            width: None,
            first: 0.0,
            stiffness: None,
            radial: None,
            axial_order: 1,
            clearance: 0.0,
        }
    }

    /// The lugs at a radius, m.
    fn at(&self, radius: f64) -> Result<SplineTeeth, GeometryError> {
        let wrong = |argument, message, help| GeometryError::error("E0655", argument, message, help);
        if self.spline_teeth < 3 {
            return Err(wrong(
                "lugs",
                sentence!["a spline needs at least three teeth to centre a rim; it has ", number f64::from(self.spline_teeth)],
                sentence!["give at least 3"],
            ));
        }
        let pitch = TAU * radius / f64::from(self.spline_teeth);
        let width = self.width.unwrap_or(0.5 * pitch);
        if !(width > 0.0 && width <= pitch * (1.0 + 1e-9)) {
            return Err(wrong(
                "width",
                sentence![
                    "spline teeth of width ", length width, " do not fit around the rim, where the spline pitch is ", length pitch
                ],
                sentence!["reduce `width`, or omit it for half the spline pitch"],
            ));
        }
        let fits = self.clearance > 0.0 && width + self.clearance < pitch;
        if self.clearance != 0.0 && !fits {
            return Err(GeometryError::error(
                "E0754",
                "clearance",
                sentence![
                    "a clearance of ", length self.clearance, " on spline teeth of width ", length width, " does not fit within the spline pitch of ",
                    length pitch
                ],
                sentence![
                    "give the difference of the widths of a space and a spline tooth, or 0 for a spline without backlash"
                ],
            ));
        }
        let compliance = |argument: &'static str, stiffness: Option<f64>| match stiffness {
            None => Ok(0.0),
            Some(stiffness) if stiffness > 0.0 && stiffness.is_finite() => Ok(1.0 / stiffness),
            Some(_) => Err(wrong(
                argument,
                sentence!["the stiffness of spline teeth must be positive"],
                sentence!["omit it for rigid spline teeth"],
            )),
        };
        let radial = match self.radial {
            Some(fit) => Some(compliance("radial_stiffness", fit.stiffness)?),
            None => None,
        };
        Ok(SplineTeeth {
            count: self.spline_teeth,
            first: self.first,
            width: width / radius,
            tangential: compliance("stiffness", self.stiffness)?,
            radial,
            degree: self.axial_order,
        })
    }
}

/// A disc thinner than the face that carries a ring. Lengths in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Web {
    /// Where it begins on the ring's side without teeth.
    pub rim_radius: f64,
    /// Along the axis.
    pub thickness: f64,
    /// Of its middle from mid-face, along +z.
    pub offset: f64,
    /// What it is further in, if it has a mesh of its own: then the above is where it meets the ring.
    pub disc: Option<DiscWeb>,
}

impl Web {
    /// Its ends along the axis, m from mid-face.
    pub fn ends(&self) -> [f64; 2] {
        [self.offset - 0.5 * self.thickness, self.offset + 0.5 * self.thickness]
    }
}

impl Rim {
    /// A ring by its two diameters, m. Whether it lies below the teeth is checked with the gear.
    ///
    /// # Errors
    /// E0665: the inner diameter is not positive or not the smaller.
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
            hold: BoreSupport::Rigid,
        })
    }

    /// The ring on a web that ends at a bore, where the body's frame holds it; m. Whether the web lies within the face is checked with
    /// the gear.
    ///
    /// # Errors
    /// E0665: the ring's inner diameter does not lie between that of the bore and that of the teeth, or the web is not positively thick.
    pub fn on_web(self, thickness: f64, offset: f64, bore_diameter: f64) -> Result<Rim, GeometryError> {
        let rim_radius = self.fixed_radius;
        let fixed_radius = 0.5 * bore_diameter;
        if !(fixed_radius > 0.0 && fixed_radius < rim_radius && rim_radius < self.radius) {
            return Err(GeometryError::error(
                "E0665",
                "bore_diameter",
                sentence!["the web's bore must be positive and smaller than the inner diameter of the rim"],
                sentence![
                    "the body is supported at the bore; a rim without a web is supported at its inner diameter"
                ],
            ));
        }
        if !(thickness > 0.0 && thickness.is_finite() && offset.is_finite()) {
            return Err(GeometryError::error(
                "E0665",
                "web_thickness",
                sentence!["the web's thickness must be positive"],
                sentence!["it is measured along the axis, and at most as large as the face width"],
            ));
        }
        Ok(Rim { fixed_radius, web: Some(Web { rim_radius, thickness, offset, disc: None }), ..self })
    }

    /// The ring held in another way at its bore, or its outside.
    #[must_use]
    pub fn held(self, hold: BoreSupport) -> Rim {
        Rim { hold, ..self }
    }

    /// The ring held by the lugs of a spline at its bore, or its outside.
    ///
    /// # Errors
    /// E0655: it is held in the mean there, or the lugs are none that can hold it. E0754: they cannot have such a clearance.
    pub fn splined(self, spline: &SplineSupport) -> Result<Rim, GeometryError> {
        if self.hold != BoreSupport::Rigid {
            return Err(GeometryError::error(
                "E0655",
                "rim",
                sentence!["the rim has a free bore or seat, so spline teeth cannot support it"],
                sentence![
                    "leave the rim's `bore` or `seat` \"rigid\"; the spline teeth replace this constraint"
                ],
            ));
        }
        if self.web.is_some_and(|web| web.disc.is_some()) {
            return Err(GeometryError::error(
                "E0655",
                "rim",
                sentence!["spline teeth cannot support a disc web, which has a mesh of its own"],
                sentence!["take a `webbed_rim`, whose web is in the mesh of the teeth"],
            ));
        }
        let (spline_teeth, clearance) = (spline.at(self.fixed_radius)?, spline.clearance);
        if clearance == 0.0 {
            return Ok(self.held(BoreSupport::SplineTeeth(spline_teeth)));
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
                    "with it they are contact of flanks in the plane, which has no room for a web; leave it out"
                ],
            ));
        }
        Ok(self.held(BoreSupport::SplineWithClearance { spline_teeth, clearance }))
    }

    /// How a plane model is held: with a web, which it has no room for, rigidly where that begins.
    pub(crate) fn support_in_plane(&self) -> BoreSupport {
        match (self.web, self.hold) {
            (Some(_), _) => BoreSupport::Rigid,
            // There is one place along the axis.
            (None, BoreSupport::Means { harmonics: waves, .. }) => {
                BoreSupport::Means { harmonics: waves, degree: 0 }
            }
            (None, BoreSupport::SplineTeeth(spline_teeth)) => {
                BoreSupport::SplineTeeth(SplineTeeth { degree: 0, ..spline_teeth })
            }
            // Contact knows how they yield, and by how much they stand off.
            (None, BoreSupport::SplineWithClearance { spline_teeth, .. }) => {
                BoreSupport::SplineWithClearance {
                    spline_teeth: SplineTeeth { degree: 0, tangential: 0.0, ..spline_teeth },
                    clearance: 0.0,
                }
            }
            (None, BoreSupport::Rigid) => BoreSupport::Rigid,
        }
    }

    /// Numbers that tell ways of being held apart.
    pub(crate) fn support_numbers(hold: BoreSupport) -> Vec<f64> {
        match hold {
            BoreSupport::Rigid => vec![0.0; 3],
            BoreSupport::Means { harmonics: None, .. } => vec![1.0, 0.0, 0.0],
            BoreSupport::Means { harmonics: Some(waves), degree } => {
                vec![2.0, f64::from(waves), f64::from(degree)]
            }
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

    /// Whether there are teeth enough for the waves around by which it is held: each brings three nodes at least; eight where lugs hold it.
    pub(crate) fn check_support(&self, teeth: u32) -> Result<(), GeometryError> {
        self.check_joint(teeth)?;
        match self.ring_support().unwrap_or(BoreSupport::Rigid) {
            BoreSupport::Means { harmonics: Some(waves), .. } if u32::from(waves) > teeth => {
                Err(GeometryError::error(
                    "E0649",
                    "rim",
                    sentence![
                        "the rim is constrained up to harmonic ", number f64::from(waves), ", which requires as many teeth; there are ",
                        number f64::from(teeth)
                    ],
                    sentence!["reduce the circumferential order, or use a rigid constraint"],
                ))
            }
            BoreSupport::SplineTeeth(spline_teeth)
            | BoreSupport::SplineWithClearance { spline_teeth, .. }
                if u32::from(spline_teeth.waves()) > SPLINE_HARMONICS_PER_TOOTH * teeth =>
            {
                Err(GeometryError::error(
                    "E0656",
                    "rim",
                    sentence![
                        "the spline teeth of the rim need ", number f64::from(spline_teeth.waves()), " harmonics, and a mesh with ",
                        number f64::from(teeth), " teeth has at most ", number f64::from(SPLINE_HARMONICS_PER_TOOTH * teeth)
                    ],
                    sentence!["reduce the number of spline teeth or increase their width"],
                ))
            }
            _ => Ok(()),
        }
    }

    /// Where the ring ends on its side without teeth, m.
    pub fn ring_radius(&self) -> f64 {
        self.web.map_or(self.fixed_radius, |web| web.rim_radius)
    }

    /// Whether a web lies within the face.
    pub(crate) fn check_web(&self, face_width: f64) -> Result<(), GeometryError> {
        let Some(web) = self.web else { return Ok(()) };
        let room = 0.5 * face_width * (1.0 + 1e-9);
        let [start, end] = web.ends();
        if start >= -room && end <= room {
            return Ok(());
        }
        Err(GeometryError::error(
            "E0644",
            "rim",
            sentence![
                "the web reaches from ", length start, " to ", length end, " from mid-face, but the face only from ",
                length - 0.5 * face_width, " to ", length 0.5 * face_width
            ],
            sentence!["reduce `web_thickness` or `web_offset`, or enlarge `face_width`"],
        ))
    }

    /// A ring around the teeth of an internal gear by its two diameters, m. Whether it lies around the teeth is checked with the gear.
    ///
    /// # Errors
    /// E0665: the diameter is not positive or not the smaller.
    pub fn outer(diameter: f64, outer_diameter: f64) -> Result<Rim, GeometryError> {
        if !(diameter > 0.0 && outer_diameter > diameter && outer_diameter.is_finite()) {
            return Err(GeometryError::error(
                "E0665",
                "outer_diameter",
                sentence!["the rim's outer diameter must be larger than its diameter, and that positive"],
                sentence!["an internal gear is supported at its outer diameter"],
            ));
        }
        Ok(Rim {
            radius: 0.5 * diameter,
            fixed_radius: 0.5 * outer_diameter,
            web: None,
            hold: BoreSupport::Rigid,
        })
    }
}

/// How thick teeth are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Thickness {
    /// Along the pitch circle, m: transverse, or in the normal section if the rack is given there.
    Circular(f64),
    /// By the profile shift coefficient, see [`Rack::thickness_of_shift`].
    ProfileShift(f64),
}

/// What is given of an external gear. Lengths in m.
///
/// Every field may be set on its own; the methods that take `self` set the optional ones.
#[derive(Clone, Debug)]
pub struct GearBlank {
    /// Number of teeth, 4 at least.
    pub teeth: u32,
    /// What generates the teeth.
    pub rack: Rack,
    /// Of the circle through the tips; usually two modules more than the pitch diameter.
    pub outer_diameter: f64,
    /// Of the circle on which the spaces end; usually 2.5 modules less than the pitch diameter.
    pub root_diameter: f64,
    /// Length of the teeth along the axis.
    pub face_width: f64,
    /// How the teeth wind; straight ones by default.
    pub helix: Helix,
    /// What it is made of.
    pub material: Material,
    /// What carries the teeth.
    pub rim: Rim,
    /// How thick the teeth are.
    pub thickness: Thickness,
    /// Rounding of the tip edge; `None` for [`crate::external::DEFAULT_TIP_EDGE`] modules.
    pub tip_edge_radius: Option<f64>,
    /// What is taken off both flanks of every tooth.
    pub modifications: Vec<Modification>,
    /// Error of position of each tooth along the pitch circle, from tooth 0 on, counter-clockwise; teeth beyond the list have
    /// none.
    pub pitch_errors: Vec<f64>,
}

impl GearBlank {
    /// A spur gear of a standard tooth form: addendum one module, dedendum 1.25, no profile shift, of steel, ten modules wide, on a rim
    /// of one and a half modules under the spaces. Everything is a field to be changed.
    pub fn standard(teeth: u32, rack: Rack) -> GearBlank {
        let module = rack.module;
        let pitch_diameter = f64::from(teeth) * module;
        let root_diameter = pitch_diameter - 2.5 * module;
        GearBlank {
            teeth,
            rack,
            outer_diameter: pitch_diameter + 2.0 * module,
            root_diameter,
            face_width: 10.0 * module,
            helix: Helix::SPUR,
            material: Material::STEEL,
            rim: Rim {
                radius: 0.5 * root_diameter - 0.5 * module,
                fixed_radius: 0.5 * root_diameter - 1.5 * module,
                web: None,
                hold: BoreSupport::Rigid,
            },
            thickness: Thickness::ProfileShift(0.0),
            tip_edge_radius: None,
            modifications: Vec::new(),
            pitch_errors: Vec::new(),
        }
    }

    /// With another outer and root diameter, m.
    #[must_use]
    pub fn diameters(mut self, outer: f64, root: f64) -> GearBlank {
        (self.outer_diameter, self.root_diameter) = (outer, root);
        self
    }

    /// With another face width, m.
    #[must_use]
    pub fn face_width(mut self, face_width: f64) -> GearBlank {
        self.face_width = face_width;
        self
    }

    /// Of another material.
    #[must_use]
    pub fn material(mut self, material: Material) -> GearBlank {
        self.material = material;
        self
    }

    /// On another rim.
    #[must_use]
    pub fn rim(mut self, rim: Rim) -> GearBlank {
        self.rim = rim;
        self
    }

    /// With another thickness of the teeth.
    #[must_use]
    pub fn thickness(mut self, thickness: Thickness) -> GearBlank {
        self.thickness = thickness;
        self
    }

    /// With one modification of the flanks more.
    #[must_use]
    pub fn modified(mut self, modification: Modification) -> GearBlank {
        self.modifications.push(modification);
        self
    }

    /// The gear, checked. Warnings about it stand in its [`ExternalGear::warnings`].
    ///
    /// # Errors
    /// Everything that is wrong with the gear, as far as it can be told at once: E0604 to E0621, E0640 to E0642 (blaming
    /// `modifications`), E0644, E0668.
    pub fn cut(self) -> Result<Arc<GearPrototype>, Refusal> {
        check_face_width(self.face_width)?;
        let tooth_thickness = match self.thickness {
            Thickness::Circular(thickness) => thickness,
            Thickness::ProfileShift(shift) => self.rack.thickness_of_shift(shift),
        };
        let tooth_thickness = self.rack.transverse_thickness(tooth_thickness, &self.helix);
        let gear = ExternalGear::new(ExternalGearData {
            teeth: self.teeth,
            rack: self.rack.transverse(&self.helix),
            tooth_thickness,
            outer_radius: 0.5 * self.outer_diameter,
            root_radius: 0.5 * self.root_diameter,
            tip_edge_radius: self.tip_edge_radius,
        })?;
        check_rim(gear.root_radius, self.rim.radius, self.rim.fixed_radius)?;
        self.rim.check_web(self.face_width)?;
        self.rim.check_support(gear.teeth)?;
        let pitch_errors = self.pitch_errors.iter().map(|error| error / gear.pitch_radius).collect();
        let (material, rim, face_width) = (self.material, self.rim, self.face_width);
        let cut = GearPrototype::new(gear, self.modifications, material, rim, face_width, pitch_errors);
        Ok(Arc::new(cut.map_err(of_modifications)?.along(self.helix)))
    }
}

/// A face must have a width.
pub(crate) fn check_face_width(face_width: f64) -> Result<(), GeometryError> {
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

/// Findings about a relief are known only where it meets its gear, whose argument for it is `modifications`.
pub(crate) fn of_modifications(errors: Vec<GeometryError>) -> Vec<GeometryError> {
    errors.into_iter().map(|error| GeometryError { argument: "modifications", ..error }).collect()
}
