//! Webs with their own mesh: discs of any taper and dish, with a hub, joined to the rim by a
//! Fourier series on the rim's bore. `disc_web` of `gears.cx`.

use super::straight::no_thickness;
use super::{Joint, Web};
use crate::blank::Rim;
use crate::cutting_externs::{bore_support, whole_orders};
use crate::error::{GeometryError, sentence};
use crate::externs::{engine, host};
use crate::host::keep;
use calyx_abi::RuntimeError;
use calyx_abi::externs::Handle;
use calyx_runtime::fe::{Section, Station};
use calyx_runtime::material::Material;

/// Default degree of the axial polynomials in the joint of rim and web.
const DEGREE: u8 = 2;

calyx_abi::externs! {
    Pure fn calyx_gears_disc_web(
        context, diameter: f64, inner_diameter: f64, bore_diameter: f64, web_thickness: f64,
        web_thickness_at_hub: Option<f64>, web_offset: f64, dish: f64, hub_diameter: Option<f64>,
        hub_width: Option<f64>, hub_offset: f64, web_youngs_modulus: Option<f64>, web_poissons_ratio: f64,
        bore: String, bore_harmonics: f64, bore_axial_degree: f64, interface_harmonics: Option<f64>,
        interface_axial_degree: f64,
    ) -> Handle {
        let support = bore_support(&bore, ["bore_harmonics", "bore_axial_degree"], [bore_harmonics, bore_axial_degree])?;
        let orders = [interface_harmonics.unwrap_or_default(), interface_axial_degree];
        whole_orders(["interface_harmonics", "interface_axial_degree"], orders)?;
        let material = web_youngs_modulus.map(|modulus| web_material(modulus, web_poissons_ratio)).transpose()?;
        let disc = DiscWeb {
            inner_thickness: web_thickness_at_hub.unwrap_or(web_thickness),
            inner_offset: web_offset + dish,
            hub: hub_diameter.or(hub_width).map(|_| Hub {
                radius: 0.5 * hub_diameter.unwrap_or_default(),
                width: hub_width.unwrap_or_default(),
                offset: hub_offset,
            }),
            material,
            harmonics: interface_harmonics.map(|harmonics| harmonics as u16),
            degree: interface_axial_degree as u8,
        };
        let (place, host) = (context.place, host(context)?);
        let rim = Rim::new(diameter, inner_diameter)
            .and_then(|rim| rim.on_disc(web_thickness, web_offset, bore_diameter, disc))
            .map_err(|error| host.rejected(error.into(), place))?;
        Ok(keep(&mut host.rims, rim.supported_by(support)))
    }
}

/// Dimensions of a web with its own mesh, besides its end at the rim. Lengths in m, axial positions
/// from mid-face along +z.
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
    /// Number of harmonics in the joint with the rim, as in [`Joint`].
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

    /// Checks the dimensions of a web between two radii, m.
    fn check(&self, [bore_radius, rim_radius]: [f64; 2]) -> Result<(), GeometryError> {
        let refusal = |argument, message, help| Err(GeometryError::error("E0696", argument, message, help));
        if !(self.inner_thickness > 0.0 && self.inner_thickness.is_finite() && self.inner_offset.is_finite())
        {
            return refusal(
                "web_thickness_at_hub",
                sentence!["the web's thickness at its inner end must be positive"],
                sentence!["leave it out for a web that is as thick everywhere"],
            );
        }
        if let Some(hub) = self.hub {
            if !(hub.radius > bore_radius && hub.radius < rim_radius) {
                return refusal(
                    "hub_diameter",
                    sentence![
                        "the hub's diameter of ", length 2.0 * hub.radius, " is not between that of the bore, ",
                        length 2.0 * bore_radius, ", and that of the ring's inside, ", length 2.0 * rim_radius
                    ],
                    sentence!["the web is between hub and rim"],
                );
            }
            let ([from, to], [start, end]) = (ends(hub.width, hub.offset), self.inner_ends());
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
        Ok(())
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
        self.check_bore(bore_diameter)?;
        if !(thickness > 0.0 && thickness.is_finite() && offset.is_finite()) {
            return Err(no_thickness());
        }
        let [bore_radius, rim_radius] = [0.5 * bore_diameter, self.fixed_radius];
        disc.check([bore_radius, rim_radius])?;
        let station = |radius, ends: [f64; 2]| Station { radius, ends };
        let mut stations = match disc.hub {
            Some(hub) => {
                let width = ends(hub.width, hub.offset);
                let step = [station(hub.radius, width), station(hub.radius, disc.inner_ends())];
                vec![station(bore_radius, width), step[0], step[1]]
            }
            None => vec![station(bore_radius, disc.inner_ends())],
        };
        stations.push(station(rim_radius, ends(thickness, offset)));
        let section = Section::new(stations).ok_or_else(no_thickness)?;
        let joint = Joint { harmonics: disc.harmonics, degree: disc.degree };
        self.carried_by(Web::separate(section, disc.material, joint))
    }
}

/// Material of a web, from arguments with names of their own.
fn web_material(youngs_modulus: f64, poissons_ratio: f64) -> Result<Material, RuntimeError> {
    Material::new(youngs_modulus, poissons_ratio, 0.0).map_err(|error| {
        let argument = if error.code == "E0660" { "web_youngs_modulus" } else { "web_poissons_ratio" };
        engine(error.blame(argument))
    })
}
