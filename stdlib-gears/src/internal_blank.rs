//! Blanks of internal gears: everything that describes one internal gear before mounting.
//!
//! The library function `internal` of the language is [`InternalBlank::cut`] with arguments for
//! fields.

use crate::blank::{Rim, Thickness, check_face_width, of_modifications};
use crate::error::Refusal;
use crate::helix::Helix;
use crate::internal::{InternalGear, InternalGearData, check_outer_rim};
use crate::modification::Modification;
use crate::prototype::GearPrototype;
use crate::shaper::Shaper;
use calyx_runtime::material::Material;
use calyx_runtime::structure::BoreSupport;
use std::sync::Arc;

/// Input data of an internal gear. Lengths in m.
#[derive(Clone, Debug)]
pub struct InternalBlank {
    /// Number of teeth, more than the shaper cutter has.
    pub teeth: u32,
    /// Tool that generates the teeth.
    pub shaper: Shaper,
    /// Tip (minor) diameter; usually the pitch diameter minus 1.5 to 2 modules.
    pub minor_diameter: f64,
    /// Root diameter; usually the pitch diameter plus 2.5 modules.
    pub root_diameter: f64,
    /// Face width: axial length of the teeth.
    pub face_width: f64,
    /// Helix of the teeth; spur by default.
    pub helix: Helix,
    /// Material of the gear.
    pub material: Material,
    /// Rim that surrounds the teeth, see [`Rim::outer`].
    pub rim: Rim,
    /// Tooth thickness.
    pub thickness: Thickness,
    /// Radius of the rounded tip edge; `None` selects [`crate::external::DEFAULT_TIP_EDGE`]
    /// modules.
    pub tip_edge_radius: Option<f64>,
    /// Modifications of both flanks of every tooth.
    pub modifications: Vec<Modification>,
    /// Pitch deviation of each tooth along the pitch circle, from tooth 0, counter-clockwise. Teeth
    /// beyond the list have none.
    pub pitch_errors: Vec<f64>,
}

impl InternalBlank {
    /// Creates an internal gear with standard proportions: addendum 0.8 modules, dedendum 1.25, no
    /// profile shift, steel, face width ten modules, rim thickness two modules around the tooth
    /// spaces. Every field can be changed.
    pub fn standard(teeth: u32, shaper: Shaper) -> InternalBlank {
        let module = shaper.module;
        let pitch_diameter = f64::from(teeth) * module;
        let root_diameter = pitch_diameter + 2.5 * module;
        InternalBlank {
            teeth,
            shaper,
            minor_diameter: pitch_diameter - 1.6 * module,
            root_diameter,
            face_width: 10.0 * module,
            helix: Helix::SPUR,
            material: Material::STEEL,
            rim: Rim {
                radius: 0.5 * root_diameter + 0.5 * module,
                fixed_radius: 0.5 * root_diameter + 2.0 * module,
                web: None,
                hold: BoreSupport::Rigid,
            },
            thickness: Thickness::ProfileShift(0.0),
            tip_edge_radius: None,
            modifications: Vec::new(),
            pitch_errors: Vec::new(),
        }
    }

    /// Checks the blank and generates the gear. Its warnings are in [`InternalGear::warnings`].
    ///
    /// # Errors
    /// All errors of the gear that can be detected together: those of [`InternalGear::new`], E0620,
    /// E0621, E0640 to E0642 (blaming `modifications`), E0668.
    pub fn cut(self) -> Result<Arc<GearPrototype>, Refusal> {
        check_face_width(self.face_width)?;
        let tooth_thickness = match self.thickness {
            Thickness::Circular(thickness) => thickness,
            Thickness::ProfileShift(shift) => self.shaper.thickness_of_shift(shift),
        };
        let gear = InternalGear::new(InternalGearData {
            teeth: self.teeth,
            shaper: self.shaper,
            tooth_thickness,
            minor_radius: 0.5 * self.minor_diameter,
            root_radius: 0.5 * self.root_diameter,
            tip_edge_radius: self.tip_edge_radius,
        })?;
        check_outer_rim(gear.root_radius, self.rim.radius, self.rim.fixed_radius)?;
        self.rim.check_support(gear.teeth)?;
        let pitch_errors = self.pitch_errors.iter().map(|error| error / gear.pitch_radius).collect();
        let (material, rim, face_width) = (self.material, self.rim, self.face_width);
        let cut = GearPrototype::new(gear, self.modifications, material, rim, face_width, pitch_errors);
        Ok(Arc::new(cut.map_err(of_modifications)?.along(self.helix)))
    }
}
