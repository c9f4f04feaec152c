//! Size of the equations of a ring of sectors, predicted from the numbers of its mesh before
//! assembly.

/// Estimated number of loads, and of modes, that couple distant sectors of a plane and of a solid
/// ring.
const SELECTED: [usize; 2] = [16, 80];

/// Size of a structure that is condensed from one repeated sector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StructureSize {
    /// Number of equal sectors of the body.
    pub sectors: u32,
    /// Number of elements of a sector.
    pub elements: usize,
    /// Unconstrained degrees of freedom of a sector with both cuts.
    pub dofs: usize,
    /// Degrees of freedom of one cut.
    pub cut: usize,
    /// Number of mean constraint forces on the bore: unknowns that all sectors share.
    pub means: usize,
    /// Number of loads on a sector whose responses are computed.
    pub loads: usize,
    /// Number of stress recovery points of a sector.
    pub stresses: usize,
    /// Number of stress components at each of them.
    pub components: usize,
    /// Largest distance of sectors with coupling tables.
    pub window: u32,
    /// True if the sector is condensed by halves that are mirror images of each other.
    pub mirrored: bool,
}

impl StructureSize {
    /// Returns the degrees of freedom of the whole body.
    pub fn body_dofs(&self) -> usize {
        self.sectors as usize * self.dofs.saturating_sub(self.cut)
    }

    /// Returns the number of unknowns of a condensed sector: those of its two cuts and the
    /// constraint forces of the bore.
    pub fn condensed(&self) -> usize {
        2 * self.cut + self.means
    }

    /// Returns the number of multiplications, to leading order. The parts are the elimination
    /// within a sector with loads and stresses, the joining of sectors (twice for every doubling
    /// and once for each sector of the window), and the responses to the loads. In three dimensions
    /// the interior of a sector costs more than its cuts suggest: the elimination of the chapter 5
    /// pinion alone takes about 6 times the square of its degrees of freedom
    /// (`cargo bench -p calyx-gears --bench factorisation`), by halves half of that.
    pub fn operations(&self) -> f64 {
        let number = |count: usize| count as f64;
        let (cut, rows) = (number(self.cut), number(self.stresses * self.components));
        let (unknowns, loads) = (number(self.condensed()), number(self.loads));
        let kept = unknowns + loads;
        // The last part to be eliminated is as large as a cut; the preceding parts take about as
        // much again.
        let eliminated = 2.0 * cut * (cut * cut / 6.0 + 0.5 * cut * kept + 0.5 * kept * kept + rows * kept);
        let joins = 2.0 * f64::from(self.sectors.max(2)).log2() + f64::from(self.window);
        let joined = cut * (cut * cut / 6.0 + 0.5 * cut * unknowns + 0.5 * unknowns * unknowns);
        let (ahead, behind) = (f64::from(self.window + 1), f64::from(self.window));
        let responses = unknowns * loads * (ahead * (unknowns + loads + rows) + behind * (unknowns + rows));
        eliminated + joins * joined + responses
    }

    /// Returns the memory of the structure, in bytes: tables between loads, and from loads to
    /// stresses in both directions, which are identical for a sector with itself.
    pub fn bytes(&self) -> usize {
        let (rows, window) = (self.stresses * self.components, self.window as usize);
        let tables = self.loads * ((window + 1) * self.loads + (2 * window + 1) * rows);
        let far = (self.sectors as usize / 2).saturating_sub(window);
        let selected = SELECTED[usize::from(self.components > 1)].min(self.cut);
        let beyond = if far > 0 { selected * (3 * far * selected + self.loads + rows) } else { 0 };
        size_of::<f64>() * (tables + beyond + self.means * (self.loads + rows + self.means))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: StructureSize = StructureSize {
        sectors: 20,
        elements: 96,
        dofs: 9_000,
        cut: 300,
        means: 6,
        loads: 300,
        stresses: 400,
        components: 3,
        window: 3,
        mirrored: true,
    };

    #[test]
    fn sectors_share_their_cuts() {
        assert_eq!(SIZE.body_dofs(), 20 * 8_700);
        assert_eq!(SIZE.condensed(), 606);
        let beyond = 80 * (3 * 7 * 80 + 300 + 1_200);
        assert_eq!(SIZE.bytes(), 8 * (300 * (4 * 300 + 7 * 1_200) + beyond + 6 * (300 + 1_200 + 6)));
    }

    /// A ring with 32 times as many teeth takes five more doublings.
    #[test]
    fn the_cost_of_a_ring_grows_by_the_logarithm_of_its_teeth() {
        let large = StructureSize { sectors: 640, ..SIZE };
        let ratio = large.operations() / SIZE.operations();
        assert!((1.0..2.5).contains(&ratio), "{ratio}");
        let ratio = large.bytes() as f64 / SIZE.bytes() as f64;
        assert!((1.0..3.5).contains(&ratio), "{ratio}");
    }
}
