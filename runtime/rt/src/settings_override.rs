//! Command-line options that override the analysis settings of a model.

use calyx_runtime::settings_override::Override;
use clap::Args;

/// Heading of these options in the help of commands.
const HEADING: &str = "Overrides of the analysis settings in the model";

/// Options that override analysis settings.
#[derive(Args, Clone, Debug, Default)]
pub struct OverrideArguments {
    /// Fidelity level, in order of cost: rigid, analytic, plane, medium, thinrim, fineroot, finest
    ///
    /// Outputs that a level does not support are reported by name. `calyx tradeoff` measures cost
    /// and accuracy of each level.
    #[arg(long, help_heading = HEADING, value_name = "LEVEL", value_parser = |text: &str| parse_setting("fidelity", text))]
    fidelity: Option<Override>,
    /// Factor for the number of elements in every direction of the mesh
    ///
    /// 0.5 halves the number of elements in each direction; 1 is the default mesh of the fidelity
    /// level.
    #[arg(long, help_heading = HEADING, value_name = "FACTOR", value_parser = |text: &str| parse_setting("refinement", text))]
    refinement: Option<Override>,
    /// Polynomial order of the elements in the transverse section, 1 to 3
    #[arg(long, help_heading = HEADING, alias = "order", value_name = "ORDER", value_parser = |text: &str| parse_setting("element_order", text))]
    element_order: Option<Override>,
    /// Number of elements along the face, in three dimensions
    #[arg(long, help_heading = HEADING, value_name = "COUNT", value_parser = |text: &str| parse_setting("face_elements", text))]
    face_elements: Option<Override>,
    /// Polynomial order of these elements along the face
    #[arg(long, help_heading = HEADING, value_name = "ORDER", value_parser = |text: &str| parse_setting("displacement_order", text))]
    displacement_order: Option<Override>,
    /// Contact grids have 2M+1 cells across the contact
    #[arg(long, help_heading = HEADING, alias = "cells", value_name = "M", value_parser = |text: &str| parse_setting("contact_cells", text))]
    contact_cells: Option<Override>,
    /// Contact grids have 2N+1 slices along the face, in three dimensions
    #[arg(long, help_heading = HEADING, alias = "cells-along", value_name = "N", value_parser = |text: &str| parse_setting("contact_slices", text))]
    contact_slices: Option<Override>,
    /// Analyse only every COUNT-th position and the characteristic points
    #[arg(long, help_heading = HEADING, alias = "every", value_name = "COUNT", value_parser = |text: &str| parse_setting("position_stride", text))]
    position_stride: Option<Override>,
    /// Error estimates of outputs: none, cheap (costs less than the run), or full (includes the
    /// model error of the fidelity level)
    #[arg(long, help_heading = HEADING, value_name = "WHICH", value_parser = |text: &str| parse_setting("error_estimates", text))]
    error_estimates: Option<Override>,
}

/// Returns an override of one setting.
fn parse_setting(name: &str, text: &str) -> Result<Override, String> {
    let mut one = Override::default();
    one.set(name, text).map(|()| one).map_err(|error| error.help)
}

impl OverrideArguments {
    /// Combines the options.
    pub fn to_override(&self) -> Override {
        let of = |one: &Option<Override>| one.unwrap_or_default();
        Override {
            fidelity: of(&self.fidelity).fidelity,
            refinement: of(&self.refinement).refinement,
            order: of(&self.element_order).order,
            face_elements: of(&self.face_elements).face_elements,
            displacement_order: of(&self.displacement_order).displacement_order,
            cells: of(&self.contact_cells).cells,
            cells_along: of(&self.contact_slices).cells_along,
            every: of(&self.position_stride).every,
            error_estimates: of(&self.error_estimates).error_estimates,
        }
    }
}
