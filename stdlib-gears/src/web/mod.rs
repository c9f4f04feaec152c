//! Webs: bodies of revolution between the rim and the bore of a gear.
//!
//! A kind of web is a file of this folder. It converts its dimensions to a [`Web`]: the section,
//! the material and the joint with the rim. Meshes, keys of stored structures, masses and predicted
//! sizes depend on the [`Web`] alone, so a new kind changes nothing else. A program that embeds the
//! engine can make kinds of its own with [`Rim::carried_by`] (`tests/extensions.rs`).

pub mod disc;
pub mod straight;

pub use disc::{DiscWeb, Hub};

use crate::blank::Rim;
use crate::error::{GeometryError, sentence};
use calyx_runtime::fe::{Section, Station};
use calyx_runtime::material::Material;
use calyx_runtime::structure::{BoreSupport, RevolvedWeb};

/// Default number of harmonics in the joint per ratio of the rim's inner radius to its thickness.
/// The effect of a tooth on the joint decays exponentially with the harmonic times this thickness
/// over the radius. The bounds are the smallest and the largest number.
const HARMONICS_PER_RATIO: f64 = 2.5;
const MIN_HARMONICS: f64 = 8.0;
const MAX_HARMONICS: f64 = 50.0;

/// Web: a body of revolution, independent of the number of teeth and the helix of the gear.
#[derive(Clone, Debug, PartialEq)]
pub struct Web {
    section: Section,
    material: Option<Material>,
    joint: Option<Joint>,
}

/// Joint of a web, which has its own mesh, with the inside of the rim: a series on the cylinder
/// between them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint {
    /// Number of harmonics. `None` selects two and a half times the ratio of radius to thickness of
    /// the rim, between 8 and 50, or at most the number of teeth.
    pub harmonics: Option<u16>,
    /// Degree of the polynomials along the axis.
    pub degree: u8,
}

impl Web {
    /// Creates a web with its own mesh from its section, from the bore out to the rim, with axial
    /// positions in m from mid-face along +z. `material` is `None` for that of the gear.
    pub fn separate(section: Section, material: Option<Material>, joint: Joint) -> Web {
        Web { section, material, joint: Some(joint) }
    }

    /// Creates a web of constant thickness in the mesh of the teeth, between two radii (m) and two
    /// axial positions (m from mid-face). `None` if the radii or the positions do not ascend.
    pub fn meshed_with_teeth([inner, outer]: [f64; 2], ends: [f64; 2]) -> Option<Web> {
        let station = |radius: f64| Station { radius, ends };
        let section = Section::new(vec![station(inner), station(outer)])?;
        Some(Web { section, material: None, joint: None })
    }

    /// Returns the section from the bore out to the rim.
    pub fn section(&self) -> &Section {
        &self.section
    }

    /// Returns the material, if it differs from that of the gear.
    pub fn material(&self) -> Option<Material> {
        self.material
    }

    /// Returns the joint with the rim; `None` if the mesh of the teeth contains the web.
    pub fn joint(&self) -> Option<Joint> {
        self.joint
    }

    /// Returns the radius of its bore, m.
    pub fn bore_radius(&self) -> f64 {
        self.section.outermost()[0].radius
    }

    /// Returns the radius at which the web meets the rim, m.
    pub fn rim_radius(&self) -> f64 {
        self.section.outermost()[1].radius
    }

    /// Returns the axial ends where it meets the rim, m from mid-face.
    pub fn ends(&self) -> [f64; 2] {
        self.section.outermost()[1].ends
    }

    /// Returns all numbers that distinguish webs.
    fn numbers(&self) -> Vec<f64> {
        let stations = self.section.stations();
        let mut numbers = vec![stations.len() as f64];
        numbers.extend(stations.iter().flat_map(|at| [at.radius, at.ends[0], at.ends[1]]));
        numbers.extend(self.material.map_or([0.0; 3], |own| [1.0, own.youngs_modulus, own.poissons_ratio]));
        numbers.extend(self.joint.map_or([0.0; 3], |joint| {
            [1.0, joint.harmonics.map_or(-1.0, f64::from), f64::from(joint.degree)]
        }));
        numbers
    }
}

impl Rim {
    /// Returns the rim on a web that ends at a bore, where the body's frame supports it. Whether
    /// the web lies within the face is checked with the gear.
    ///
    /// # Errors
    /// E0665: the web does not meet the rim at its inner diameter.
    pub fn carried_by(self, web: Web) -> Result<Rim, GeometryError> {
        let rim_radius = self.fixed_radius;
        if web.rim_radius() != rim_radius || rim_radius >= self.radius {
            return Err(GeometryError::error(
                "E0665",
                "inner_diameter",
                sentence![
                    "the web ends at a diameter of ", length 2.0 * web.rim_radius(), ", and the rim on it at ", length 2.0 * rim_radius
                ],
                sentence!["let the web end at the inner diameter of the rim, inside the teeth"],
            ));
        }
        Ok(Rim { fixed_radius: web.bore_radius(), web: Some(web), ..self })
    }

    /// Checks the bore of a web on this rim, a diameter in m.
    fn check_bore(&self, bore_diameter: f64) -> Result<(), GeometryError> {
        let (rim_radius, bore_radius) = (self.fixed_radius, 0.5 * bore_diameter);
        if bore_radius > 0.0 && bore_radius < rim_radius && rim_radius < self.radius {
            return Ok(());
        }
        Err(GeometryError::error(
            "E0665",
            "bore_diameter",
            sentence!["the web's bore must be positive and smaller than the inner diameter of the rim"],
            sentence![
                "the body is supported at the bore; a rim without a web is supported at its inner diameter"
            ],
        ))
    }

    /// Converts a separately meshed web to the engine's form, for a rim with this number of teeth
    /// and this material.
    pub(crate) fn revolved_web(&self, teeth: u32, of_teeth: Material) -> Option<RevolvedWeb> {
        let web = self.web.as_ref()?;
        let Joint { harmonics, degree } = web.joint?;
        let default = || self.default_harmonics(web).min(u16::try_from(teeth).unwrap_or(u16::MAX));
        Some(RevolvedWeb {
            section: web.section.clone(),
            material: web.material.unwrap_or(of_teeth),
            support: self.support,
            harmonics: harmonics.unwrap_or_else(default),
            degree,
            fineness: 1,
        })
    }

    fn default_harmonics(&self, web: &Web) -> u16 {
        let harmonics = HARMONICS_PER_RATIO * web.rim_radius() / (self.radius - web.rim_radius());
        harmonics.ceil().clamp(MIN_HARMONICS, MAX_HARMONICS) as u16
    }

    /// Numbers that distinguish webs, for the key of a stored structure.
    pub(crate) fn web_numbers(&self) -> Vec<f64> {
        self.web.as_ref().map_or(vec![0.0], Web::numbers)
    }

    /// Radius at which the rim ends on its side without teeth, m.
    pub fn ring_radius(&self) -> f64 {
        self.web.as_ref().map_or(self.fixed_radius, Web::rim_radius)
    }

    /// Support of the rim; `None` if a web with its own mesh supports it.
    pub(crate) fn ring_support(&self) -> Option<BoreSupport> {
        match &self.web {
            Some(web) if web.joint.is_some() => None,
            _ => Some(self.support),
        }
    }

    /// Checks that the web lies within the face.
    pub(crate) fn check_web(&self, face_width: f64) -> Result<(), GeometryError> {
        let Some(web) = &self.web else { return Ok(()) };
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

    /// Checks that the gear has enough teeth for the harmonics of the joint of rim and web.
    pub(crate) fn check_joint(&self, teeth: u32) -> Result<(), GeometryError> {
        let joint = self.web.as_ref().and_then(Web::joint);
        let Some(harmonics) = joint.and_then(|joint| joint.harmonics) else { return Ok(()) };
        if u32::from(harmonics) <= teeth {
            return Ok(());
        }
        Err(GeometryError::error(
            "E0649",
            "rim",
            sentence![
                "the joint of rim and web has ", number f64::from(harmonics), " harmonics, which requires as many teeth; there are ",
                number f64::from(teeth)
            ],
            sentence!["reduce `interface_harmonics`, or leave it out"],
        ))
    }
}
