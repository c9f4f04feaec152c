//! The analysis as options change it, whatever the model says.

use calyx_runtime::overriding::Override;
use clap::Args;

/// Options that take the place of what a model says of its analysis.
#[derive(Args, Clone, Debug, Default)]
#[command(next_help_heading = "Changing the analysis, whatever the model says")]
pub struct OverrideArguments {
    /// Model bodies at this level: from cheap to exact rigid, analytic, plane, medium, thinrim, fineroot, finest
    ///
    /// What an output needs and a level does not have is refused by name. `calyx tradeoff` measures what each level costs and how
    /// far it is off.
    #[arg(long, value_name = "LEVEL", value_parser = |text: &str| knob("fidelity", text))]
    fidelity: Option<Turned>,
    /// Multiply the number of elements along every direction of the mesh
    ///
    /// 0.5 is half as many each way; 1 is the mesh of the fidelity.
    #[arg(long, value_name = "FACTOR", value_parser = |text: &str| knob("refinement", text))]
    refinement: Option<Turned>,
    /// Order of displacements in the section, 1 to 3
    #[arg(long, value_name = "ORDER", value_parser = |text: &str| knob("order", text))]
    order: Option<Turned>,
    /// Elements along the face, in three dimensions
    #[arg(long, value_name = "COUNT", value_parser = |text: &str| knob("face_elements", text))]
    face_elements: Option<Turned>,
    /// Order of displacements along the face in each of them
    #[arg(long, value_name = "ORDER", value_parser = |text: &str| knob("displacement_order", text))]
    displacement_order: Option<Turned>,
    /// M: contact grids have 2M+1 cells across
    #[arg(long, value_name = "M", value_parser = |text: &str| knob("cells", text))]
    cells: Option<Turned>,
    /// N: contact grids have 2N+1 slices along the face, in three dimensions
    #[arg(long, value_name = "N", value_parser = |text: &str| knob("cells_along", text))]
    cells_along: Option<Turned>,
    /// Analyse every COUNT-th of the positions only, and those that have a name
    #[arg(long, value_name = "COUNT", value_parser = |text: &str| knob("every", text))]
    every: Option<Turned>,
    /// Estimate errors of outputs: none, cheap (what costs less than the run), or full (what the level leaves out, too)
    #[arg(long, value_name = "WHICH", value_parser = |text: &str| knob("error_estimates", text))]
    error_estimates: Option<Turned>,
}

/// A knob as one option turns it.
type Turned = Override;

fn knob(name: &str, text: &str) -> Result<Turned, String> {
    let mut turned = Override::default();
    turned.set(name, text).map(|()| turned).map_err(|error| error.help)
}

impl OverrideArguments {
    /// What the options say.
    pub fn knobs(&self) -> Override {
        let knob = |turned: &Option<Turned>| turned.unwrap_or_default();
        Override {
            fidelity: knob(&self.fidelity).fidelity,
            refinement: knob(&self.refinement).refinement,
            order: knob(&self.order).order,
            face_elements: knob(&self.face_elements).face_elements,
            displacement_order: knob(&self.displacement_order).displacement_order,
            cells: knob(&self.cells).cells,
            cells_along: knob(&self.cells_along).cells_along,
            every: knob(&self.every).every,
            error_estimates: knob(&self.error_estimates).error_estimates,
        }
    }
}
