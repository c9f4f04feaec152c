//! Refinement of a sector mesh: numbers and lengths of its elements.

use calyx_runtime::fe::ElementOrder;

/// Largest ratio of the length of cubic elements to the distance from the tip edge.
const COARSEST_TIP_GROWTH: f64 = 0.4;

/// Smallest number of elements through the strip along the boundary. Recovered stress is fitted to
/// an element and its neighbours. Those of a single layer are the large elements of the core of the
/// tooth, over which the stress of a fillet is not a polynomial: it is underestimated by 13 % to
/// 27 %.
const FEWEST_LAYERS: usize = 2;

/// Refinement of a sector mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Refinement {
    /// Number of elements through the strip along the boundary.
    pub layers: usize,
    /// Number of elements from the strip to the tooth's centreline.
    pub across: usize,
    /// Largest length of an element along the flank, in modules.
    pub flank: f64,
    /// Number of elements along the fillet.
    pub fillet: usize,
    /// Mesh of the tip edge.
    pub edge: TipEdge,
    /// Ratio of the length of elements along the flank to the distance from the tip edge.
    pub tip_growth: f64,
    /// Ratio of successive element depths into the rim.
    pub rim_growth: f64,
    /// Order of displacements and coordinates.
    pub order: ElementOrder,
}

/// Mesh of the tip edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TipEdge {
    /// The mesh follows the rounding, with this number of elements over either half of the arc.
    Rounded(usize),
    /// The mesh ends in a corner where the rounding begins, and omits the material between the
    /// corner and the rounding. Elements along the flank have this length next to the corner, in
    /// modules.
    Corner(f64),
}

impl TipEdge {
    /// Number of elements over either half of the arc.
    pub(super) fn elements(self) -> usize {
        match self {
            TipEdge::Rounded(elements) => elements,
            TipEdge::Corner(_) => 0,
        }
    }
}

impl Refinement {
    /// For first estimates.
    pub const COARSE: Self = Self {
        layers: 3,
        across: 3,
        flank: 0.3,
        fillet: 4,
        edge: TipEdge::Rounded(1),
        tip_growth: 0.4,
        rim_growth: 1.8,
        order: ElementOrder::CUBIC,
    };
    /// Fillet stresses and compliances accurate to about one part in a thousand.
    pub const MEDIUM: Self = Self {
        layers: 5,
        across: 5,
        flank: 0.15,
        fillet: 10,
        edge: TipEdge::Rounded(1),
        tip_growth: 0.27,
        rim_growth: 1.5,
        order: ElementOrder::CUBIC,
    };
    /// For convergence studies.
    pub const FINE: Self = Self {
        layers: 6,
        across: 6,
        flank: 0.09,
        fillet: 12,
        edge: TipEdge::Rounded(2),
        tip_growth: 0.2,
        rim_growth: 1.3,
        order: ElementOrder::CUBIC,
    };

    /// Returns the refinement called `"coarse"`, `"medium"` or `"fine"`.
    pub fn named(name: &str) -> Option<Self> {
        match name {
            "coarse" => Some(Self::COARSE),
            "medium" => Some(Self::MEDIUM),
            "fine" => Some(Self::FINE),
            _ => None,
        }
    }
    /// Returns a mesh that is `factor` times as fine in every direction, with elements of another
    /// order.
    pub(crate) fn refined(self, factor: f64, order: usize) -> Self {
        let times = |count: usize| ((count as f64 * factor).round() as usize).max(1);
        Self {
            layers: times(self.layers).max(FEWEST_LAYERS),
            across: times(self.across),
            flank: self.flank / factor,
            fillet: times(self.fillet),
            edge: match self.edge {
                TipEdge::Rounded(elements) => TipEdge::Rounded(times(elements)),
                TipEdge::Corner(last) => TipEdge::Corner(last / factor),
            },
            // Matching depths are counted in nodes and must stay well below the distance from the
            // tip edge.
            tip_growth: (self.tip_growth / factor).min(COARSEST_TIP_GROWTH) * order as f64 / 3.0,
            rim_growth: self.rim_growth.powf(1.0 / factor),
            order: ElementOrder::full(order as u8),
        }
    }
}
