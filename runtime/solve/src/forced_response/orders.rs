//! Orders of a vibration: the multiples of the frequency of a common period at which a system with
//! several mesh frequencies vibrates.
//!
//! Meshes of other frequencies, and carriers that rotate, repeat together after a common period,
//! which may last thousands of mesh cycles. Of its many harmonics only few matter: those of each
//! mesh frequency, with sidebands at the rotational frequency of the carriers and at the harmonics
//! of other meshes, whose stiffness modulates them. Samples at equal distances over the common
//! period determine the coefficients of the stiffness, although there are far fewer than one in
//! each mesh cycle, if no two of their orders are equal modulo the number of samples. In the phases
//! of the meshes such samples are a lattice (rank-1 lattice rule).

use super::sampling::Sampling;
use std::collections::{BTreeMap, BTreeSet};

/// Largest order of a sideband in the stiffness: the displacements of central members and planets
/// have the sidebands -1 to 1 in ground coordinates.
const SIDEBANDS: i64 = 2;
/// Harmonics of two meshes whose sums and differences the static equilibrium may have.
const INTERACTIONS: i64 = 2;

/// Origin of an order: `harmonic` times the frequency of a mesh plus `sideband` times the frequency
/// of what modulates it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct Line {
    /// Index of the mesh frequency; meaningless for harmonic 0.
    pub mesh: usize,
    /// Harmonic of the mesh frequency; at least 0.
    pub harmonic: usize,
    /// Cause of the modulation; `None` for sideband 0.
    pub modulation: Option<Modulation>,
    /// Order of the sideband.
    pub sideband: i64,
}

/// Cause of sidebands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Modulation {
    /// Index of a carrier, whose rotation turns displacements.
    Carrier(usize),
    /// Index of another mesh frequency, of lower harmonic.
    Mesh(usize),
}

/// Orders of the response of a system, as whole multiples of the frequency of the common period.
#[derive(Clone, Debug, PartialEq)]
pub struct Orders {
    /// Orders of the response, ascending, with zero and both signs.
    response: Vec<i64>,
    /// Differences of orders that the stiffness couples, from 0; those of both signs belong to it.
    coupling: BTreeSet<i64>,
    /// Origins of the orders from 0.
    lines: BTreeMap<i64, Line>,
    /// Indices of orders of the response that belong to the same harmonic of a mesh.
    clusters: Vec<Vec<usize>>,
    /// Cycles of each mesh frequency within the common period.
    meshes: Vec<i64>,
    /// Revolutions of each carrier.
    carriers: Vec<i64>,
    harmonics: usize,
    /// Orders from zero of what rotates with a carrier and does not vary over a mesh cycle.
    turning: BTreeSet<i64>,
    /// Orders that samples distinguish: those of the stiffness, and of the static equilibrium.
    sampled: BTreeSet<i64>,
}

impl Orders {
    /// Determines the orders for a number of harmonics of each mesh frequency. `meshes` are their
    /// numbers of cycles in the common period, `carriers` the numbers of revolutions of the
    /// carriers; all are positive.
    ///
    /// An order that several meshes have is that of the mesh in which its harmonic is lowest.
    pub fn new(meshes: &[i64], carriers: &[i64], harmonics: usize) -> Orders {
        let highest = harmonics as i64;
        // Sidebands by distance from a harmonic.
        let sidebands = |largest: i64| {
            let of_carrier = move |(carrier, &turns): (usize, &i64)| {
                (1..=largest).flat_map(move |by| [-by, by].map(|by| (carrier, by, by * turns)))
            };
            std::iter::once((0, 0, 0)).chain(carriers.iter().enumerate().flat_map(of_carrier))
        };
        let mut lines = BTreeMap::new();
        let mut keep = |order: i64, line: Line| {
            lines.entry(order.abs()).or_insert(line);
        };
        for (carrier, sideband, shift) in sidebands(1) {
            if sideband >= 0 {
                keep(shift, Line { modulation: modulation(carrier, sideband), sideband, ..Line::default() });
            }
            for harmonic in 1..=highest {
                for (mesh, cycles) in meshes.iter().enumerate() {
                    let modulation = modulation(carrier, sideband);
                    let line = Line { mesh, harmonic: harmonic as usize, modulation, sideband };
                    keep(harmonic * cycles + shift, line);
                }
            }
        }
        for (mesh, harmonic, other, sideband) in interactions(meshes.len(), highest) {
            let line = Line {
                mesh,
                harmonic: harmonic as usize,
                modulation: Some(Modulation::Mesh(other)),
                sideband,
            };
            keep(harmonic * meshes[mesh] + sideband * meshes[other], line);
        }
        let mut coupling = BTreeSet::new();
        for (_, _, shift) in sidebands(SIDEBANDS) {
            coupling.insert(shift.abs());
            for cycles in meshes {
                for harmonic in 1..=2 * highest {
                    coupling.insert((harmonic * cycles + shift).abs());
                }
            }
        }
        let mut sampled = coupling.clone();
        for (index, one) in meshes.iter().enumerate() {
            for other in &meshes[index + 1..] {
                for (h, k) in (1..=INTERACTIONS).flat_map(|h| (1..=INTERACTIONS).map(move |k| (h, k))) {
                    sampled.extend([h * one + k * other, (h * one - k * other).abs()]);
                }
            }
        }
        let mut response: Vec<i64> = lines.keys().flat_map(|&order| [-order, order]).collect();
        response.sort_unstable();
        response.dedup();
        let clusters = clusters(&response, &lines);
        Orders {
            response,
            coupling,
            lines,
            clusters,
            meshes: meshes.to_vec(),
            carriers: carriers.to_vec(),
            harmonics,
            turning: sidebands(SIDEBANDS).map(|(_, _, shift)| shift.abs()).collect(),
            sampled,
        }
    }

    /// Returns the orders from zero with their origins, ascending.
    pub fn lines(&self) -> impl Iterator<Item = (i64, Line)> + '_ {
        self.lines.iter().map(|(&order, &line)| (order, line))
    }

    /// Returns a sampling of which every second sample determines all coefficients, with at least
    /// `least` samples for each mesh frequency; `None` if it needs more than `most`.
    pub fn sampling(&self, least: usize, most: usize) -> Option<Sampling> {
        if let ([mesh], [carrier]) = (&self.meshes[..], &self.carriers[..]) {
            let count = least.max(8 * self.harmonics + 4).next_multiple_of(2);
            if let Some(found) = Sampling::of_cycles([*mesh, *carrier], count) {
                return (found.count() <= most).then_some(found);
            }
        }
        self.uniform(least * self.meshes.len(), most).map(|count| Sampling::Uniform { count })
    }

    /// Returns the smallest even number of samples at equal distances, at least `least`, of which
    /// every second one distinguishes all orders; `None` if it would exceed `most`.
    fn uniform(&self, least: usize, most: usize) -> Option<usize> {
        let signed = || self.sampled.iter().flat_map(|&order| [-order, order]);
        let first = least.div_ceil(2).max(2 * self.sampled.len() - 1).max(1);
        let separates = |count: &usize| {
            let mut taken = vec![false; *count];
            let mut free = |order: i64| {
                let place = order.rem_euclid(*count as i64) as usize;
                !std::mem::replace(&mut taken[place], true)
            };
            signed().filter(|&order| order != 0).all(&mut free) && free(0)
        };
        (first..=most / 2).find(separates).map(|count| 2 * count)
    }

    /// Returns the orders of the response of both signs, ascending.
    pub(super) fn response(&self) -> &[i64] {
        &self.response
    }

    /// Returns the orders from zero of the stiffness.
    pub(super) fn coupling(&self) -> &BTreeSet<i64> {
        &self.coupling
    }

    /// Returns true for an order whose coefficients samples determine. The static equilibrium has
    /// no others.
    pub(super) fn is_sampled(&self, order: i64) -> bool {
        self.sampled.contains(&order.abs())
    }

    /// Returns the indices of orders of the response by harmonic of a mesh.
    pub(super) fn clusters(&self) -> &[Vec<usize>] {
        &self.clusters
    }

    /// Joins all orders to one cluster, whose system is that of all orders.
    #[cfg(test)]
    pub(super) fn in_one_cluster(mut self) -> Orders {
        self.clusters = vec![(0..self.response.len()).collect()];
        self
    }

    /// Returns the cycles of each mesh frequency in the common period.
    pub(super) fn meshes(&self) -> &[i64] {
        &self.meshes
    }

    /// Returns the number of harmonics of each mesh frequency.
    pub(super) fn harmonics(&self) -> usize {
        self.harmonics
    }

    /// Returns true if carriers rotate.
    pub(super) fn rotates(&self) -> bool {
        self.turning.len() > 1
    }

    /// Returns the orders from zero of what rotates with a carrier and does not vary over a mesh
    /// cycle.
    pub(super) fn turning(&self) -> &BTreeSet<i64> {
        &self.turning
    }

    /// Returns the highest order of the response.
    pub(super) fn highest(&self) -> i64 {
        self.response.last().copied().unwrap_or_default()
    }
}

fn modulation(carrier: usize, sideband: i64) -> Option<Modulation> {
    (sideband != 0).then_some(Modulation::Carrier(carrier))
}

/// Returns the interactions of meshes: a mesh and its harmonic, then another mesh and its signed
/// harmonic, which is not higher. Of the products of both series, those are kept whose harmonics
/// `h` and `k` have `(1 + h) (1 + k)` up to twice the number of harmonics plus two (hyperbolic
/// cross): all harmonics with the first one of the other mesh, and fewer of the higher ones.
fn interactions(meshes: usize, highest: i64) -> impl Iterator<Item = (usize, i64, usize, i64)> {
    let pairs = (0..meshes).flat_map(move |mesh| (0..meshes).map(move |other| (mesh, other)));
    let pairs = pairs.filter(|(mesh, other)| mesh != other);
    pairs.flat_map(move |(mesh, other)| {
        let harmonics = (1..=highest).flat_map(|h| (1..=h).map(move |k| (h, k)));
        let kept =
            harmonics.filter(move |(h, k)| (1 + h) * (1 + k) <= 2 * (highest + 1) && (k < h || mesh < other));
        kept.flat_map(move |(h, k)| [(mesh, h, other, -k), (mesh, h, other, k)])
    })
}

/// Returns the indices of the orders of the response by mesh and signed harmonic: the sidebands of
/// a harmonic are strongly coupled by bodies that rotate with a carrier. Interactions of meshes are
/// on their own.
fn clusters(response: &[i64], lines: &BTreeMap<i64, Line>) -> Vec<Vec<usize>> {
    let mut found: BTreeMap<(usize, i64, i64), Vec<usize>> = BTreeMap::new();
    for (index, order) in response.iter().enumerate() {
        let line = lines[&order.abs()];
        let harmonic = line.harmonic as i64 * order.signum();
        let key = match line.modulation {
            Some(Modulation::Mesh(_)) => (0, 0, *order),
            _ if harmonic == 0 => (0, 0, 0),
            _ => (line.mesh, harmonic, 0),
        };
        found.entry(key).or_default().push(index);
    }
    found.into_values().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_mesh_has_its_harmonics() {
        let orders = Orders::new(&[1], &[], 3);
        assert_eq!(orders.response(), [-3, -2, -1, 0, 1, 2, 3]);
        assert_eq!(orders.coupling().iter().copied().collect::<Vec<_>>(), [0, 1, 2, 3, 4, 5, 6]);
        assert_eq!(orders.uniform(0, 1000), Some(26));
        assert_eq!(orders.uniform(128, 1000), Some(128));
        assert_eq!(orders.clusters().len(), 7);
    }

    /// The third harmonic of a mesh with eight cycles is the eighth of one with three.
    #[test]
    fn a_common_order_belongs_to_the_lower_harmonic() {
        let orders = Orders::new(&[8, 3], &[], 8);
        let line = orders.lines().find(|(order, _)| *order == 24).expect("the order").1;
        assert_eq!((line.mesh, line.harmonic), (0, 3));
        assert_eq!(orders.lines().filter(|(_, line)| line.modulation.is_none()).count(), 1 + 8 + 8 - 1);
    }

    #[test]
    fn sidebands_of_a_harmonic_form_a_cluster() {
        let orders = Orders::new(&[99], &[1], 2);
        assert_eq!(
            orders.lines().map(|(order, _)| order).collect::<Vec<_>>(),
            [0, 1, 98, 99, 100, 197, 198, 199]
        );
        assert_eq!(orders.clusters().len(), 5);
        assert!(orders.clusters().iter().all(|cluster| cluster.len() == 3));
        let sideband = orders.lines().find(|(order, _)| *order == 98).expect("the order").1;
        assert_eq!((sideband.harmonic, sideband.sideband), (1, -1));
        assert_eq!(sideband.modulation, Some(Modulation::Carrier(0)));
    }

    #[test]
    fn meshes_modulate_each_other() {
        let orders = Orders::new(&[1000, 1], &[], 3);
        let line = |order: i64| orders.lines().find(|(own, _)| *own == order).map(|(_, line)| line);
        let [below, above] = [1999, 2001].map(|order| line(order).expect("the order"));
        for (line, sideband) in [(below, -1), (above, 1)] {
            assert_eq!((line.mesh, line.harmonic, line.sideband), (0, 2, sideband));
            assert_eq!(line.modulation, Some(Modulation::Mesh(1)));
        }
        assert_eq!(line(997).map(|line| (line.mesh, line.harmonic, line.sideband)), Some((1, 3, -1)));
        assert_eq!(line(2002), None);
    }

    /// Few samples of a long period determine all orders: each has a place of its own.
    #[test]
    fn samples_distinguish_all_orders() {
        for (meshes, carriers) in
            [(vec![1472, 851], vec![]), (vec![2673], vec![27]), (vec![37, 23], vec![4, 7])]
        {
            let orders = Orders::new(&meshes, &carriers, 4);
            let count = orders.uniform(64, 10_000).expect("a number of samples");
            assert!(count < 1500, "{count}");
            let places: BTreeSet<i64> = orders
                .coupling()
                .iter()
                .flat_map(|&order| [-order, order])
                .map(|order| order.rem_euclid(count as i64 / 2))
                .collect();
            assert_eq!(places.len(), 2 * orders.coupling().len() - 1, "{meshes:?} {carriers:?}");
        }
        assert_eq!(Orders::new(&[37, 23], &[], 16).uniform(64, 100), None);
    }
}
