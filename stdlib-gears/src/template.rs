//! Mesh templates for three dimensions: transverse sections, much coarser than those of a plane
//! model, swept along the face.
//!
//! Templates are classified by their accuracy. With four elements of order three along the face,
//! the error of root stresses, relative to their limit under refinement, is at most 3 % (`medium`),
//! 1 % (`fineroot`) and 0.3 % (`finest`). `thinrim` equals `medium` on the teeth and is finer
//! through a rim that bends. The contact pressure does not depend on the mesh: the contact problem
//! uses the exact flanks, and the mesh only contributes the smooth difference between the
//! deformation of the body and that of a half-space. The tip edge is therefore a corner, and
//! elements grow away from it.

use crate::sector_mesh::{Refinement, TipEdge};
use calyx_runtime::fe::ElementOrder;
use calyx_runtime::scene::Template;

/// Tip edge of all solid meshes: length of the element at the corner (modules) and growth away from
/// it. Matching depths are counted in nodes and must stay well below the distance from the corner,
/// so neither depends on the template.
const CORNER: TipEdge = TipEdge::Corner(0.05);
const TIP_GROWTH: f64 = 0.4;

/// Refinement of the transverse section of a gear's mesh.
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

/// Default number of elements along the face, and their order.
pub fn along_face(_template: Template) -> [usize; 2] {
    [4, 3]
}
