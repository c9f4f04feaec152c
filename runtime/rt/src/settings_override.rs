//! Command-line options that override the analysis settings of a model.

use calyx_runtime::settings_override::Override;
use clap::Args;

/// Options that override analysis settings.
#[derive(Args, Clone, Debug, Default)]
#[command(next_help_heading = "Overrides of the analysis settings in the model")]
pub struct OverrideArguments {
    /// Fidelity level, in order of cost: rigid, analytic, plane, medium, thinrim, fineroot, finest
    ///
    /// Outputs that a level does not support are reported by name. `calyx tradeoff` measures cost
    /// and accuracy of each level.
    #[arg(long, value_name = "LEVEL", value_parser = |text: &str| parse_setting("fidelity", text))]
    fidelity: Option<Turned>,
    /// Factor for the number of elements in every direction of the mesh
    ///
    /// 0.5 halves the number of elements in each direction; 1 is the default mesh of the fidelity
    /// level.
    #[arg(long, value_name = "FACTOR", value_parser = |text: &str| parse_setting("refinement", text))]
    refinement: Option<Turned>,
    /// Polynomial order of the elements in the transverse section, 1 to 3
    #[arg(long, value_name = "ORDER", value_parser = |text: &str| parse_setting("order", text))]
    order: Option<Turned>,
    /// Number of elements along the face, in three dimensions
    #[arg(long, value_name = "COUNT", value_parser = |text: &str| parse_setting("face_elements", text))]
    face_elements: Option<Turned>,
    /// Polynomial order of these elements along the face
    #[arg(long, value_name = "ORDER", value_parser = |text: &str| parse_setting("displacement_order", text))]
    displacement_order: Option<Turned>,
    /// Contact grids have 2M+1 cells across the contact
    #[arg(long, value_name = "M", value_parser = |text: &str| parse_setting("cells", text))]
    cells: Option<Turned>,
    /// Contact grids have 2N+1 slices along the face, in three dimensions
    #[arg(long, value_name = "N", value_parser = |text: &str| parse_setting("cells_along", text))]
    cells_along: Option<Turned>,
    /// Analyse only every COUNT-th position and the characteristic points
    #[arg(long, value_name = "COUNT", value_parser = |text: &str| parse_setting("every", text))]
    every: Option<Turned>,
    /// Error estimates of outputs: none, cheap (costs less than the run), or full (includes the
    /// model error of the fidelity level)
    #[arg(long, value_name = "WHICH", value_parser = |text: &str| parse_setting("error_estimates", text))]
    error_estimates: Option<Turned>,
}

/// Setting changed by one option.
type Turned = Override;

fn parse_setting(name: &str, text: &str) -> Result<Turned, String> {
    let mut turned = Override::default();
    turned.set(name, text).map(|()| turned).map_err(|error| error.help)
}

impl OverrideArguments {
    /// Combines the options.
    pub fn to_override(&self) -> Override {
        let parse_setting = |turned: &Option<Turned>| turned.unwrap_or_default();
        Override {
            fidelity: parse_setting(&self.fidelity).fidelity,
            refinement: parse_setting(&self.refinement).refinement,
            order: parse_setting(&self.order).order,
            face_elements: parse_setting(&self.face_elements).face_elements,
            displacement_order: parse_setting(&self.displacement_order).displacement_order,
            cells: parse_setting(&self.cells).cells,
            cells_along: parse_setting(&self.cells_along).cells_along,
            every: parse_setting(&self.every).every,
            error_estimates: parse_setting(&self.error_estimates).error_estimates,
        }
    }
}
