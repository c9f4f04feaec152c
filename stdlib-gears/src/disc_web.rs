//! Webs with their own mesh: discs of any taper and dish, with a hub, joined to the rim by a
//! Fourier series on the rim's bore.
//!
//! A web that is meshed with the teeth ([`Web`] alone) has a constant thickness. A disc web is a
//! body of revolution given by its section, independent of the number of teeth and the helix of the
//! gear.

use crate::blank::{Rim, Web};
use crate::error::{GeometryError, sentence};
use calyx_runtime::fe::{Section, Station};
use calyx_runtime::material::Material;
use calyx_runtime::structure::{BoreSupport, RevolvedWeb};

/// Default degree of the axial polynomials in the joint of rim and web.
const DEGREE: u8 = 2;
/// Default number of harmonics in the joint per ratio of the rim's inner radius to its thickness.
/// The effect of a tooth on the joint decays exponentially with the harmonic times this thickness
/// over the radius. The bounds are the smallest and the largest number.
const HARMONICS_PER_RATIO: f64 = 2.5;
const MIN_HARMONICS: f64 = 8.0;
const MAX_HARMONICS: f64 = 50.0;

/// Additional dimensions of a [`Web`] with its own mesh, besides its end at the rim. Lengths in m,
/// axial positions from mid-face along +z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiscWeb {
    /// Thickness at its inner end, at the hub or at the bore.
    pub inner_thickness: f64,
    /// Axial position of its midplane there.
    pub inner_offset: f64,
    /// Hub at the inner end.
    pub hub: Option<Hub>,
    /// Material, if it differs from that of the gear.
    pub material: Option<Material>,
    /// Number of harmonics in the joint with the rim. `None` selects two and a half times the ratio
    /// of radius to thickness of the rim, between 8 and 50, or at most the number of teeth.
    pub harmonics: Option<u16>,
    /// Degree of the axial polynomials in the joint.
    pub degree: u8,
}

impl DiscWeb {
    /// Creates a straight disc of constant thickness without a hub.
    pub fn plain(thickness: f64, offset: f64) -> Self {
        Self {
            inner_thickness: thickness,
            inner_offset: offset,
            hub: None,
            material: None,
            harmonics: None,
            degree: DEGREE,
        }
    }

    /// Axial ends at its inner end.
    fn inner_ends(&self) -> [f64; 2] {
        ends(self.inner_thickness, self.inner_offset)
    }
}

/// Hub: the part around the bore, wider than the web. Lengths in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hub {
    /// Outer radius.
    pub radius: f64,
    /// Axial width.
    pub width: f64,
    /// Offset of its middle from mid-face, along +z.
    pub offset: f64,
}

fn ends(thickness: f64, offset: f64) -> [f64; 2] {
    [offset - 0.5 * thickness, offset + 0.5 * thickness]
}

impl Rim {
    /// Returns the rim on a separately meshed web that ends at a bore, m. `thickness` and `offset`
    /// apply at the rim; `disc` describes the web further inside.
    ///
    /// # Errors
    /// As [`Self::on_web`]. E0696: the web or its hub has no width, or they do not meet.
    pub fn on_disc(
        self,
        thickness: f64,
        offset: f64,
        bore_diameter: f64,
        disc: DiscWeb,
    ) -> Result<Rim, GeometryError> {
        let refusal = |argument, message, help| Err(GeometryError::error("E0696", argument, message, help));
        let rim = self.on_web(thickness, offset, bore_diameter)?;
        if !(disc.inner_thickness > 0.0 && disc.inner_thickness.is_finite() && disc.inner_offset.is_finite())
        {
            return refusal(
                "web_thickness_at_hub",
                sentence!["the web's thickness at its inner end must be positive"],
                sentence!["leave it out for a web that is as thick everywhere"],
            );
        }
        if let Some(hub) = disc.hub {
            if !(hub.radius > rim.fixed_radius && hub.radius < rim.ring_radius()) {
                return refusal(
                    "hub_diameter",
                    sentence![
                        "the hub's diameter of ", length 2.0 * hub.radius, " is not between that of the bore, ",
                        length 2.0 * rim.fixed_radius, ", and that of the ring's inside, ", length 2.0 * rim.ring_radius()
                    ],
                    sentence!["the web is between hub and rim"],
                );
            }
            let ([from, to], [start, end]) = (ends(hub.width, hub.offset), disc.inner_ends());
            let room = 1e-9 * hub.width;
            if !(hub.width.is_finite() && from - room <= start && end <= to + room) {
                return refusal(
                    "hub_width",
                    sentence![
                        "the hub reaches from ", length from, " to ", length to, " from mid-face, but the web on it from ",
                        length start, " to ", length end
                    ],
                    sentence!["enlarge `hub_width`, or give the hub the web's offset with `hub_offset`"],
                );
            }
        }
        let web = rim.web.map(|web| Web { disc: Some(disc), ..web });
        Ok(Rim { web, ..rim })
    }

    /// Converts a separately meshed web to the engine's form, for a rim with this number of teeth
    /// and this material.
    pub(crate) fn revolved_web(&self, teeth: u32, of_teeth: Material) -> Option<RevolvedWeb> {
        let web = self.web?;
        let disc = web.disc?;
        let at = |radius, [from, to]: [f64; 2]| Station { radius, ends: [from, to] };
        let inside = self.fixed_radius;
        let mut stations = match disc.hub {
            Some(hub) => {
                let width = ends(hub.width, hub.offset);
                vec![at(inside, width), at(hub.radius, width), at(hub.radius, disc.inner_ends())]
            }
            None => vec![at(inside, disc.inner_ends())],
        };
        stations.push(at(web.rim_radius, web.ends()));
        Some(RevolvedWeb {
            section: Section::new(stations)?,
            material: disc.material.unwrap_or(of_teeth),
            support: self.support,
            harmonics: disc
                .harmonics
                .unwrap_or(self.default_harmonics(web).min(u16::try_from(teeth).unwrap_or(u16::MAX))),
            degree: disc.degree,
            fineness: 1,
        })
    }

    fn default_harmonics(&self, web: Web) -> u16 {
        let harmonics = HARMONICS_PER_RATIO * web.rim_radius / (self.radius - web.rim_radius);
        harmonics.ceil().clamp(MIN_HARMONICS, MAX_HARMONICS) as u16
    }

    /// Numbers that distinguish webs.
    pub(crate) fn web_numbers(&self) -> Vec<f64> {
        let Some(web) = self.web else { return vec![0.0; 3] };
        let mut numbers = vec![web.rim_radius, web.thickness, web.offset];
        if let Some(disc) = web.disc {
            let (hub, material) = (disc.hub, disc.material);
            numbers.extend([disc.inner_thickness, disc.inner_offset, f64::from(disc.degree)]);
            numbers.push(disc.harmonics.map_or(-1.0, f64::from));
            numbers.extend(hub.map_or([0.0; 3], |hub| [hub.radius, hub.width, hub.offset]));
            numbers.extend(
                material.map_or([0.0; 2], |material| [material.youngs_modulus, material.poissons_ratio]),
            );
        }
        numbers
    }

    /// Checks that the gear has enough teeth for the harmonics of the joint of rim and web.
    pub(crate) fn check_joint(&self, teeth: u32) -> Result<(), GeometryError> {
        let Some(harmonics) = self.web.and_then(|web| web.disc).and_then(|disc| disc.harmonics) else {
            return Ok(());
        };
        if u32::from(harmonics) <= teeth {
            return Ok(());
        }
        Err(GeometryError::error(
            "E0649",
            "rim",
            sentence![
                "the rim is joined to its web up to order ", number f64::from(harmonics), " around, which takes as many teeth; there are ",
                number f64::from(teeth)
            ],
            sentence!["reduce the interface order, or leave it out"],
        ))
    }

    /// Support of the rim by its web, if the web has its own mesh.
    pub(crate) fn ring_support(&self) -> Option<BoreSupport> {
        match self.web {
            Some(Web { disc: Some(_), .. }) => None,
            _ => Some(self.support),
        }
    }
}
