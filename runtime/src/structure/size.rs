//! How large the equations of a ring of sectors are, told from the numbers of its mesh before anything is assembled.

/// Numbers of a structure that is condensed from one repeated sector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StructureSize {
    /// Equal sectors that make the body.
    pub sectors: u32,
    /// Elements of a sector.
    pub elements: usize,
    /// Degrees of freedom of a sector with both its cuts, less those that are held.
    pub freedoms: usize,
    /// Of them, those of one cut.
    pub cut: usize,
    /// Forces that hold the bore in the mean: unknowns that all sectors share.
    pub means: usize,
    /// Loads on a sector of which the answers are known.
    pub loads: usize,
    /// Places of a sector where stress is recovered.
    pub stresses: usize,
    /// Components of stress at each of them.
    pub components: usize,
    /// Sectors up to this far apart have tables of what they do to each other.
    pub window: u32,
    /// Whether it is condensed by halves that are images of each other.
    pub mirrored: bool,
    /// Distances beyond that which are known through cuts: those of a plane ring that carries loads all around.
    pub far: u32,
}

impl StructureSize {
    /// Degrees of freedom of the whole body.
    pub fn body_freedoms(&self) -> usize {
        self.sectors as usize * self.freedoms.saturating_sub(self.cut)
    }

    /// Unknowns that a sector is condensed to: its two cuts, and what holds the bore.
    pub fn condensed(&self) -> usize {
        2 * self.cut + self.means
    }

    /// Multiplications, to leading order: of the elimination within a sector, where loads and stresses are carried along; of joining
    /// sectors, twice for every doubling and once for each of the window; of the answers to the loads. In space what lies inside a sector is
    /// more than its cuts tell: the elimination alone of the chapter 5 pinion takes about 6 times the square of its degrees of freedom
    /// (`cargo bench -p calyx-gears --bench factorisation`), by halves half of that.
    pub fn operations(&self) -> f64 {
        let number = |count: usize| count as f64;
        let (cut, rows) = (number(self.cut), number(self.stresses * self.components));
        let (unknowns, loads) = (number(self.condensed()), number(self.loads));
        let kept = unknowns + loads;
        // Of the last part to be eliminated, as large as a cut; those below it take about as much again.
        let eliminated = 2.0 * cut * (cut * cut / 6.0 + 0.5 * cut * kept + 0.5 * kept * kept + rows * kept);
        let joins = 2.0 * f64::from(self.sectors.max(2)).log2() + f64::from(self.window + self.far);
        let joined = cut * (cut * cut / 6.0 + 0.5 * cut * unknowns + 0.5 * unknowns * unknowns);
        let (ahead, behind) = (f64::from(self.window + 1), f64::from(self.window));
        let answers = unknowns * loads * (ahead * (unknowns + loads + rows) + behind * (unknowns + rows));
        eliminated + joins * joined + answers
    }

    /// Memory that the structure keeps, in bytes: tables between loads, and from loads to stresses both ways round, which of a sector itself
    /// are the same.
    pub fn bytes(&self) -> usize {
        let (rows, window) = (self.stresses * self.components, self.window as usize);
        let tables = self.loads * ((window + 1) * self.loads + (2 * window + 1) * rows);
        let through_cuts = match self.far {
            0 => 0,
            far => self.condensed() * (far as usize * self.condensed() + self.loads + rows),
        };
        size_of::<f64>() * (tables + through_cuts + self.means * (self.loads + rows + self.means))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: StructureSize = StructureSize {
        sectors: 20,
        elements: 96,
        freedoms: 9_000,
        cut: 300,
        means: 6,
        loads: 300,
        stresses: 400,
        components: 3,
        window: 3,
        mirrored: true,
        far: 0,
    };

    #[test]
    fn sectors_share_their_cuts() {
        assert_eq!(SIZE.body_freedoms(), 20 * 8_700);
        assert_eq!(SIZE.condensed(), 606);
        assert_eq!(SIZE.bytes(), 8 * (300 * (4 * 300 + 7 * 1_200) + 6 * (300 + 1_200 + 6)));
    }

    /// 32 times as many teeth take five more doublings.
    #[test]
    fn the_cost_of_a_ring_grows_by_the_logarithm_of_its_teeth() {
        let large = StructureSize { sectors: 640, ..SIZE };
        let ratio = large.operations() / SIZE.operations();
        assert!((1.0..2.5).contains(&ratio), "{ratio}");
        assert_eq!(large.bytes(), SIZE.bytes());
    }
}
