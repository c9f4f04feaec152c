//! How the bore of a ring is held by its frame: its nodes all of them, or means over it only.
//!
//! A bore that is held in the mean deforms as it may. What the frame holds are the six rigid-body motions nearest to its displacements in
//! the mean square over the bore, three in the plane: "rigid-body terms constrained alone" (report 2.7). Nothing is
//! strained by holding them, so a ring on such a bore is statically determinate, and what holds it are forces distributed like
//! the displacements of a rigid body: sin and cos around under a transverse force, uniform along the circle under a torque. Terms of the
//! series of [`crate::fe::solid::fourier`] may be held beside them, up to so many waves around and some degree along: with more and
//! more of them the bore becomes rigid.

use super::StructureError;
use super::dense::mirror_lower;
use super::ring::Shared;
use super::web::RevolvedWeb;
use crate::fe::solid::fourier::{RevolutionSurface, Series};
use crate::fe::solid::{ElementFace, FaceSet, SolidModel};
use crate::fe::{EdgeChain, PlaneModel, SparseVector, Station};
use crate::interrupt::Interrupt;
use faer::Mat;
use faer::linalg::solvers::Solve;

/// How the bore of a ring is held.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BoreHold {
    /// Its nodes do not move.
    #[default]
    Rigid,
    /// It does not move as a whole, and deforms as it may but for the terms of a series.
    Means {
        /// Waves around up to which terms are held; `None` holds none, 0 those that are the same all around.
        waves: Option<u16>,
        /// Degree of polynomials along the bore up to which they are held.
        degree: u8,
    },
}

impl BoreHold {
    /// Unknowns that hold the bore of a ring where sectors up to `coupled` places apart have tables of their own: none of a rigid one.
    pub fn unknowns(self, in_plane: bool, sectors: u32, coupled: u32) -> usize {
        let BoreHold::Means { waves, degree } = self else { return 0 };
        let wanted = Wanted::of_ring(waves, if in_plane { 0 } else { degree }, sectors, coupled);
        let ends = if in_plane { [0.0; 2] } else { [-1.0, 1.0] };
        let patterns = Patterns::new(RevolutionSurface::cylinder(1.0, ends), wanted, in_plane);
        patterns.map_or(0, |patterns| patterns.places.len())
    }
}

/// Waves around up to which the bore tells distant sectors of each other's loads, and the degree along: left out is less than a hundredth
/// of what neighbours do to each other (`tests/bore.rs`).
const COUPLED_WAVES: u16 = 16;
const COUPLED_DEGREE: u8 = 1;

/// Linear forms of one sector's displacements that, added up over the ring, vanish.
pub(super) struct BoreMeans {
    /// One for each mean: also the loads that hold it.
    pub forms: Vec<SparseVector>,
    /// How they turn from sector to sector.
    pub shared: Shared,
    /// How many are held. Those behind them are to be let go, see [`super::bore_coupling`].
    pub held: usize,
    /// Forces by the means that are let go, where something holds them all the same: a web, see [`super::web`].
    pub carried: Option<Mat<f64>>,
}

/// Which means of a bore are wanted.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wanted {
    /// As [`BoreHold::Means`] has them.
    pub waves: Option<u16>,
    pub degree: u8,
    /// Waves around up to which there are to be more that are let go, if any.
    pub coupled: Option<u16>,
}

impl Wanted {
    /// Of a ring where sectors up to `coupled` places apart have tables: others feel each other through the bore.
    pub fn of_ring(waves: Option<u16>, degree: u8, sectors: u32, coupled: u32) -> Self {
        let most = u16::try_from(sectors).unwrap_or(u16::MAX);
        Self { waves, degree, coupled: (coupled < sectors / 2).then_some(COUPLED_WAVES.min(most)) }
    }
}

/// What is held of a surface of revolution.
pub(super) struct Patterns {
    pub series: Series,
    /// Which displacements of the series, [`Series::displacements`].
    pub places: Vec<usize>,
    /// How many of them are held.
    pub held: usize,
}

impl Patterns {
    /// `None` if the surface has no extent. In the plane, where the generator is a point, only motions in it count.
    pub fn new(surface: RevolutionSurface, wanted: Wanted, in_plane: bool) -> Option<Patterns> {
        let most_waves = wanted.waves.unwrap_or(0).max(wanted.coupled.unwrap_or(0));
        let highest = match wanted.coupled {
            Some(_) if !in_plane => wanted.degree.max(COUPLED_DEGREE),
            _ => wanted.degree,
        };
        let series = Series::new(surface, most_waves, highest)?;
        let rigid = if in_plane { vec![0, 1, 5] } else { (0..6).collect::<Vec<_>>() };
        let (mut held, mut free) = (rigid, Vec::new());
        for (index, term) in series.terms().iter().enumerate() {
            if in_plane && term.is_axial() {
                continue;
            }
            let of_hold =
                wanted.waves.is_some_and(|waves| term.harmonic <= waves) && term.degree <= wanted.degree;
            let of_coupling =
                wanted.coupled.is_some_and(|waves| term.harmonic <= waves) && term.degree <= COUPLED_DEGREE;
            if of_hold {
                held.push(6 + index);
            } else if of_coupling {
                free.push(6 + index);
            }
        }
        let count = held.len();
        held.append(&mut free);
        Some(Patterns { series, places: held, held: count })
    }

    fn at(&self, position: [f64; 3]) -> Vec<[f64; 3]> {
        let all = self.series.displacements(position);
        self.places.iter().map(|&place| all[place]).collect()
    }

    /// Translations across the axis and rotations about axes across it turn like vectors, cosines and sines by as many angles as they
    /// have waves.
    pub fn shared(&self) -> Shared {
        let waves = |place: usize| match place {
            0 | 3 => Some(1),
            1 | 2 | 4 | 5 => None,
            term => self.series.terms().get(term - 6).filter(|term| !term.sine).map(|term| term.harmonic),
        };
        let pairs = self.places.iter().enumerate().filter_map(|(index, &place)| {
            let waves = waves(place).filter(|&waves| waves > 0)?;
            Some(([index, index + 1], f64::from(waves)))
        });
        Shared { count: self.places.len(), pairs: pairs.collect() }
    }
}

impl BoreMeans {
    /// Over a chain of edges on a circle about the origin.
    pub fn plane(
        model: &PlaneModel,
        bore: &EdgeChain,
        wanted: Wanted,
        interrupt: &Interrupt,
    ) -> Result<Option<BoreMeans>, StructureError> {
        let mut radius = 0.0_f64;
        model.edge_load(bore, |_, point| {
            radius = radius.max(point.position[0].hypot(point.position[1]));
            [0.0; 2]
        });
        let circle = RevolutionSurface::cylinder(radius, [0.0; 2]);
        let Some(patterns) = Patterns::new(circle, Wanted { degree: 0, ..wanted }, true) else {
            return Ok(None);
        };
        Self::over(&patterns, interrupt, |traction| {
            model.edge_load(bore, |_, point| {
                let [x, y] = point.position;
                let [along_x, along_y, _] = traction([x, y, 0.0]);
                [along_x, along_y]
            })
        })
        .map(Some)
    }

    /// Over a set of faces on a cylinder about the z axis.
    pub fn solid(
        model: &SolidModel,
        bore: &FaceSet,
        wanted: Wanted,
        interrupt: &Interrupt,
    ) -> Result<Option<BoreMeans>, StructureError> {
        // Beside a web there is none.
        let present = |face: &&ElementFace| !model.mesh.absent.contains(&face.element);
        let bore = FaceSet { faces: bore.faces.iter().filter(present).copied().collect(), chart: None };
        let Some(cylinder) = cylinder_of(model, &bore) else { return Ok(None) };
        let Some(patterns) = Patterns::new(cylinder, wanted, false) else { return Ok(None) };
        Self::over(&patterns, interrupt, |traction| model.face_load(&bore, |point| traction(point.position)))
            .map(Some)
    }

    /// Over the part of a bore on which a web stands, of `sectors` sectors; the rest of it is free. None is held but by the web.
    pub fn on_web(
        model: &SolidModel,
        bore: &FaceSet,
        web: &RevolvedWeb,
        [sectors, coupled]: [u32; 2],
        interrupt: &Interrupt,
    ) -> Result<Option<BoreMeans>, StructureError> {
        let [_, Station { ends: [from, to], .. }] = web.section.outermost();
        let within = |face: &&ElementFace| {
            let one = FaceSet { faces: vec![**face], chart: None };
            let nodes = model.mesh.nodes_on(&one);
            let middle =
                nodes.iter().map(|&node| model.mesh.nodes[node][2]).sum::<f64>() / nodes.len() as f64;
            from < middle && middle < to
        };
        let bore = FaceSet { faces: bore.faces.iter().filter(within).copied().collect(), chart: None };
        let Some(cylinder) = cylinder_of(model, &bore) else { return Ok(None) };
        let wanted = web.wanted(sectors, coupled);
        let Some(patterns) = Patterns::new(cylinder, wanted, false) else { return Ok(None) };
        let load = |traction: &mut dyn FnMut([f64; 3]) -> [f64; 3]| {
            model.face_load(&bore, |point| traction(point.position))
        };
        let mut means = Self::over(&patterns, interrupt, load)?;
        // The means that amplitudes of the series make: exact for motions of the whole on any mesh.
        let nodes = model.mesh.nodes_on(&bore);
        let mut moved = vec![vec![0.0; model.dof_count()]; patterns.places.len()];
        for &node in &nodes {
            for (moved, at) in moved.iter_mut().zip(patterns.at(model.mesh.nodes[node])) {
                moved[3 * node..3 * node + 3].copy_from_slice(&at);
            }
        }
        let count = patterns.places.len();
        let of_sector = Mat::from_fn(count, count, |row, column| means.forms[row].dot(&moved[column]));
        let by_amplitude = means.shared.around(of_sector.as_ref(), sectors);
        let stiffness = web.stiffness(&patterns, interrupt)?;
        means.carried = Some(of_means(&stiffness, &by_amplitude));
        means.held = 0;
        Ok(Some(means))
    }

    /// `load` integrates a traction over the bore, always at the same points in the same order.
    fn over(
        patterns: &Patterns,
        interrupt: &Interrupt,
        load: impl Fn(&mut dyn FnMut([f64; 3]) -> [f64; 3]) -> SparseVector,
    ) -> Result<BoreMeans, StructureError> {
        let mut known: Vec<Vec<[f64; 3]>> = Vec::new();
        load(&mut |position| {
            known.push(patterns.at(position));
            [0.0; 3]
        });
        let mut forms = Vec::with_capacity(patterns.places.len());
        for pattern in 0..patterns.places.len() {
            interrupt.check().map_err(StructureError::Interrupted)?;
            let mut points = known.iter();
            forms.push(load(&mut |_| points.next().map_or([0.0; 3], |values| values[pattern])));
        }
        Ok(BoreMeans { forms, shared: patterns.shared(), held: patterns.held, carried: None })
    }
}

/// The cylinder about the z axis on which faces lie; `None` if they have no length along it.
fn cylinder_of(model: &SolidModel, faces: &FaceSet) -> Option<RevolutionSurface> {
    let (mut radius, mut ends) = (0.0_f64, [f64::INFINITY, f64::NEG_INFINITY]);
    for node in model.mesh.nodes_on(faces) {
        let [x, y, z] = model.mesh.nodes[node];
        radius = radius.max(x.hypot(y));
        ends = [ends[0].min(z), ends[1].max(z)];
    }
    (ends[0] < ends[1]).then(|| RevolutionSurface::cylinder(radius, ends))
}

/// Forces on means from a stiffness against amplitudes, with the means that amplitudes make: `M^-T K M^-1`.
fn of_means(stiffness: &Mat<f64>, by_amplitude: &Mat<f64>) -> Mat<f64> {
    let factor = by_amplitude.transpose().to_owned().partial_piv_lu();
    let once = factor.solve(stiffness);
    let mut twice = factor.solve(once.transpose().to_owned());
    mirror_lower(&mut twice);
    twice
}
