//! Webs of constant thickness in the mesh of the teeth: `webbed_rim` of `gears.cx`.

use super::Web;
use crate::blank::Rim;
use crate::cutting_externs::bore_support;
use crate::error::{GeometryError, sentence};
use crate::externs::host;
use crate::host::keep;
use calyx_abi::externs::Handle;

calyx_abi::externs! {
    Pure fn calyx_gears_webbed_rim(
        context, diameter: f64, inner_diameter: f64, bore_diameter: f64, web_thickness: f64, web_offset: f64,
        bore: String, bore_harmonics: f64, bore_axial_degree: f64,
    ) -> Handle {
        let support = bore_support(&bore, ["bore_harmonics", "bore_axial_degree"], [bore_harmonics, bore_axial_degree])?;
        let (place, host) = (context.place, host(context)?);
        let rim = Rim::new(diameter, inner_diameter)
            .and_then(|rim| rim.on_web(web_thickness, web_offset, bore_diameter))
            .map_err(|error| host.rejected(error.into(), place))?;
        Ok(keep(&mut host.rims, rim.supported_by(support)))
    }
}

impl Rim {
    /// Adds a web that extends to a bore, where the body's frame supports it; m. Whether the web
    /// lies within the face is checked with the gear.
    ///
    /// # Errors
    /// E0665: the rim's inner diameter does not lie between the bore and the teeth, or the
    /// thickness of the web is not positive.
    pub fn on_web(self, thickness: f64, offset: f64, bore_diameter: f64) -> Result<Rim, GeometryError> {
        self.check_bore(bore_diameter)?;
        let ends = [offset - 0.5 * thickness, offset + 0.5 * thickness];
        match Web::meshed_with_teeth([0.5 * bore_diameter, self.fixed_radius], ends) {
            Some(web) => self.carried_by(web),
            None => Err(no_thickness()),
        }
    }
}

/// E0665: the thickness of a web is not positive.
pub(super) fn no_thickness() -> GeometryError {
    GeometryError::error(
        "E0665",
        "web_thickness",
        sentence!["the web's thickness must be positive"],
        sentence!["it is measured along the axis, and at most as large as the face width"],
    )
}
