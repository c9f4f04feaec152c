//! Orders declarations by their dependences.
//!
//! Constants, records, dimensions and units are computed on first use. In source order, a long
//! chain of declarations, each using a later one, would cause deep recursion.

use super::infer::Checker;
use super::symbols::Resolution;
use crate::components::components;
use crate::span::Span;

/// Limit of the nesting depth of declarations being computed. In dependence order, only circular
/// declarations reach it.
pub const MOST_OPEN: usize = 100;

impl Checker<'_> {
    /// Returns the indices of declarations in dependence order: each follows the declarations that
    /// it uses, and cycles are in source order. `texts` are the source ranges of their values; `of`
    /// selects the uses of declarations of this kind.
    pub(super) fn by_dependence(&self, texts: &[Span], of: impl Fn(Resolution) -> Option<u32>) -> Vec<u32> {
        let mut uses: Vec<(Span, u32)> =
            self.names.uses.iter().filter_map(|(span, res)| Some((*span, of(*res)?))).collect();
        uses.sort_by_key(|(span, _)| (span.file, span.start));
        let named = |at: u32| {
            let text = &texts[at as usize];
            let from = uses.partition_point(|(span, _)| (span.file, span.start) < (text.file, text.start));
            let to = uses.partition_point(|(span, _)| (span.file, span.start) < (text.file, text.end));
            uses[from..to.max(from)].iter().map(|(_, named)| *named).collect::<Vec<_>>()
        };
        let in_circles = components(0..texts.len() as u32, named);
        let in_order = in_circles.into_iter().flat_map(|mut circle| {
            circle.sort();
            circle
        });
        in_order.collect()
    }
}
