//! Meshes for three dimensions: sections across the axis that are much coarser than those of a plane model, swept along the face.
//!
//! They are named by what they reach. With four elements of order three along the face, root stresses are off their own limit under
//! refinement by at most 3 % (`medium`), 1 % (`fineroot`) and 0.3 % (`finest`); `thinrim` is as fine as
//! `medium` on the teeth, and finer through a rim that bends. Pressure does not come from the mesh: contact sees the true
//! flanks, and the mesh only gives what bodies add to the deformation of a half-space, which is smooth. So the tip edge is a corner,
//! and elements grow away from it.

use crate::sector_mesh::{Refinement, TipEdge};
use calyx_runtime::fe::ElementOrder;
use calyx_runtime::scene::Template;

/// What a solid mesh has at every tip edge: the corner's element (modules), and growth away from it. Matching depths count nodes and
/// must stay well below the distance from the corner, so neither depends on the template.
const CORNER: TipEdge = TipEdge::Corner(0.05);
const TIP_GROWTH: f64 = 0.4;

/// The section of a gear's mesh across the axis.
pub fn section(template: Template) -> Refinement {
    let medium = Refinement {
        layers: 2,
        across: 1,
        flank: 0.6,
        fillet: 4,
        edge: CORNER,
        tip_growth: TIP_GROWTH,
        rim_growth: 3.0,
        order: ElementOrder::CUBIC,
    };
    match template {
        Template::Medium => medium,
        Template::FineRoot => Refinement { layers: 3, flank: 0.5, fillet: 7, rim_growth: 2.5, ..medium },
        Template::Finest => {
            Refinement { layers: 3, across: 2, flank: 0.5, fillet: 12, rim_growth: 2.5, ..medium }
        }
        Template::ThinRim => Refinement { across: 2, flank: 0.3, fillet: 6, rim_growth: 1.4, ..medium },
    }
}

/// Elements along the face, and the order of displacements in them, where nothing else is asked.
pub fn along_face(_template: Template) -> [usize; 2] {
    [4, 3]
}
