//! Chain of equal sectors, joined in pairs, that keeps what is needed to recover the displacements
//! of the cuts between them.

use super::{CutStiffness, Inner};
use crate::error::StructureError;
use crate::ring::SharedUnknowns;
use calyx_numerics::interrupt::Interrupt;
use faer::{Mat, MatRef};
use std::sync::Arc;

/// Chain condensed onto its ends and the shared unknowns. Equal parts of the chain are one part.
#[derive(Clone)]
pub(super) struct Chain {
    pub stiffness: CutStiffness,
    parts: Option<Arc<Parts>>,
}

/// The two chains of which a chain consists, and the cut between them.
struct Parts {
    before: Chain,
    after: Chain,
    between: Inner,
}

/// Displacements that determine those of a chain: of its first and its last cut, and the shared
/// unknowns in the frame of its first sector.
#[derive(Clone, Copy)]
pub(super) struct ChainEnds<'a> {
    pub first: MatRef<'a, f64>,
    pub last: MatRef<'a, f64>,
    pub shared: MatRef<'a, f64>,
}

impl Chain {
    /// Builds the chain of a single sector.
    pub fn sector(stiffness: &CutStiffness) -> Self {
        Self { stiffness: stiffness.clone(), parts: None }
    }

    /// Returns the chain of `self` followed by `next`. `pitch` is the angle of a sector.
    fn joined(&self, next: &Self, pitch: f64, interrupt: &Interrupt) -> Result<Self, StructureError> {
        let (stiffness, between) = self.stiffness.join(&next.stiffness, pitch, interrupt)?;
        let parts = Parts { before: self.clone(), after: next.clone(), between };
        Ok(Self { stiffness, parts: Some(Arc::new(parts)) })
    }

    /// Returns the chain of `count >= 1` such chains, by doubling.
    pub fn repeated(&self, count: u32, pitch: f64, interrupt: &Interrupt) -> Result<Self, StructureError> {
        let mut power = self.clone();
        let mut chain: Option<Self> = None;
        let mut rest = count;
        loop {
            if rest & 1 == 1 {
                chain = Some(match chain {
                    None => power.clone(),
                    Some(chain) => chain.joined(&power, pitch, interrupt)?,
                });
            }
            rest >>= 1;
            match chain {
                Some(chain) if rest == 0 => return Ok(chain),
                _ => power = power.joined(&power, pitch, interrupt)?,
            }
        }
    }

    /// Appends the displacements of the cuts between the sectors of the chain, in order, each in
    /// the frame of the sector that it is the first cut of.
    pub fn recover(
        &self,
        ends: ChainEnds<'_>,
        pitch: f64,
        cuts: &mut Vec<Mat<f64>>,
        interrupt: &Interrupt,
    ) -> Result<(), StructureError> {
        let Some(parts) = &self.parts else { return Ok(()) };
        let Parts { before, after, between } = parts.as_ref();
        let middle = between.displacements(ends.first, ends.last, ends.shared, interrupt)?;
        before.recover(ChainEnds { last: middle.as_ref(), ..ends }, pitch, cuts, interrupt)?;
        let mut shared = ends.shared.to_owned();
        let shared_unknowns: &SharedUnknowns = &self.stiffness.shared;
        shared_unknowns.turn_rows(shared.as_mut(), f64::from(before.stiffness.sectors) * pitch);
        let of_after = ChainEnds { first: middle.as_ref(), shared: shared.as_ref(), ..ends };
        let place = cuts.len();
        after.recover(of_after, pitch, cuts, interrupt)?;
        cuts.insert(place, middle);
        Ok(())
    }
}
