//! Problem size of a gear's structure, counted from its mesh before condensation.

use crate::prototype::{GearPrototype, STRESS_POINTS_PER_EDGE};
use crate::solid_prototype::{split_options, stress_points};
use calyx_runtime::fe::solid::ABSENT;
use calyx_runtime::scene::StructureOptions;
use calyx_runtime::structure::{BoreSupport, StructureSize};
use std::collections::BTreeSet;

/// Number of flanks of a tooth, each with a fillet.
const FLANKS: usize = 2;

impl GearPrototype {
    /// Size of the two-dimensional model.
    pub(crate) fn plane_size(&self, options: &StructureOptions) -> Option<StructureSize> {
        let mesh = self.plane_mesh(options).ok()?;
        let nodes = |chain: &str| Some(mesh.chain_nodes(mesh.chain(chain)?));
        let support = self.rim.support_in_plane();
        let constrained: BTreeSet<usize> = match support {
            BoreSupport::Rigid => nodes("bore")?.into_iter().collect(),
            BoreSupport::Means { .. }
            | BoreSupport::Raceway { .. }
            | BoreSupport::SplineTeeth(_)
            | BoreSupport::SplineWithClearance { .. } => BTreeSet::new(),
        };
        let split = self.split_options(options);
        let directions = if split.allows_modified_surfaces { 2 } else { 1 };
        let fillet = mesh.chain("fillet_0")?.edges.len();
        let cut = nodes("cut_right")?.iter().filter(|node| !constrained.contains(node)).count();
        let (teeth, window) = (self.gear.teeth(), self.coupled_teeth());
        Some(StructureSize {
            sectors: teeth,
            elements: mesh.elements.len(),
            dofs: 2 * (mesh.nodes.len() - constrained.len()),
            cut: 2 * cut,
            means: support.unknowns(true),
            loads: FLANKS * directions * split.samples,
            stresses: if options.stresses { FLANKS * fillet * STRESS_POINTS_PER_EDGE } else { 0 },
            components: 1,
            window,
            mirrored: false,
        })
    }

    /// Size of the three-dimensional model.
    pub(crate) fn solid_size(&self, options: &StructureOptions) -> Option<StructureSize> {
        let mesh = self.solid_mesh(options).ok()?;
        let nodes = |faces: &str| Some(mesh.nodes_on(mesh.face_set(faces)?));
        let mut constrained: BTreeSet<usize> =
            mesh.node_sets.get(ABSENT).into_iter().flatten().copied().collect();
        if self.rim.ring_support() == Some(BoreSupport::Rigid) {
            constrained.extend(nodes("bore")?);
        }
        let swept = mesh.swept.as_ref()?;
        let layers = swept.stations.len() - 1;
        let order = swept.orders.iter().copied().min().map_or(1, usize::from);
        let split = split_options(options);
        let [per_edge, per_layer] = stress_points(&mesh, options);
        let fillet = mesh.face_set("fillet_0")?.chart.as_ref()?.edges.len();
        let cut = nodes("cut_right")?.iter().filter(|node| !constrained.contains(node)).count();
        let (teeth, window) = (self.gear.teeth(), self.coupled_teeth());
        let stresses = FLANKS * fillet * per_edge * (layers * per_layer + 1);
        let means = match self.rim.revolved_web(teeth, self.material) {
            Some(web) => web.unknowns(),
            None => self.rim.support.unknowns(false),
        };
        Some(StructureSize {
            sectors: teeth,
            elements: mesh.elements.len() - mesh.absent.len(),
            dofs: 3 * (mesh.nodes.len() - constrained.len()),
            cut: 3 * cut,
            means,
            loads: FLANKS * split.samples * split.polynomials(layers, order),
            stresses: if options.stresses { stresses } else { 0 },
            components: 3,
            window,
            mirrored: self.helix.is_spur() && means == 0,
        })
    }
}
