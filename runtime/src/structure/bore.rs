//! How the bore of a ring is held by its frame: its nodes all of them, or means over it only.
//!
//! A bore that is held in the mean deforms as it may. What the frame holds are the six rigid-body motions nearest to its displacements in
//! the mean square over the bore, three in the plane: "rigid-body terms constrained alone" (report 2.7). Nothing is
//! strained by holding them, so a ring on such a bore is statically determinate, and what holds it are forces distributed like
//! the displacements of a rigid body: sin and cos around under a transverse force, uniform along the circle under a torque. Terms of the
//! series of [`crate::fe::solid::fourier`] may be held beside them, up to so many waves around and some degree along: with more and
//! more of them the bore becomes rigid. Or lugs hold it at some places around ([`super::lugs`]).

use super::StructureError;
use super::dense::mirror_lower;
use super::lugs::{LugForms, Lugs};
use super::ring::{Released, RingFlexibility, Shared};
use super::web::RevolvedWeb;
use crate::fe::solid::fourier::{RevolutionSurface, Series};
use crate::fe::solid::{ElementFace, FaceSet, SolidModel};
use crate::fe::{EdgeChain, PlaneModel, SparseVector, Station};
use crate::interrupt::Interrupt;
use faer::Mat;
use faer::linalg::solvers::Solve;

/// How the bore of a ring is held.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
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
    /// Lugs hold it. What they let go of the motion as a whole, along the axis and what they do not reach with their degree, is held in the
    /// mean.
    Lugs(Lugs),
    /// Lugs hold it that stand in wider spaces, as contact beside the structure ([`super::loose_lugs`]), which knows the bore to be held in
    /// the mean. In the plane only.
    LooseLugs {
        /// Their compliance, and whatever they do outwards, is no part of the structure.
        lugs: Lugs,
        /// See [`LugContact::clearance`](crate::lug_contact::LugContact::clearance); no part of the structure.
        clearance: f64,
    },
}

impl BoreHold {
    /// Unknowns that hold the bore of a ring where sectors up to `coupled` places apart have tables of their own: none of a rigid one.
    pub fn unknowns(self, in_plane: bool, sectors: u32, coupled: u32) -> usize {
        let known = if in_plane { self.known_in_plane(sectors, coupled) } else { coupled };
        let Some(wanted) = Wanted::of_ring(self, sectors, known) else { return 0 };
        let wanted = if in_plane { wanted.in_plane() } else { wanted };
        let ends = if in_plane { [0.0; 2] } else { [-1.0, 1.0] };
        let patterns = Patterns::new(RevolutionSurface::cylinder(1.0, ends), wanted, in_plane);
        patterns.map_or(0, |patterns| patterns.places.len())
    }

    /// Whether loads are felt all around a plane ring that is held so, and told through its cuts.
    pub fn carries_far(self) -> bool {
        matches!(self, BoreHold::Means { .. })
    }

    /// How far apart sectors of a plane ring are known to each other without a series, where those up to `coupled` places apart have tables.
    pub(super) fn known_in_plane(self, sectors: u32, coupled: u32) -> u32 {
        if self.carries_far() { sectors } else { coupled }
    }

    /// An error in condensing a ring that is held so: of a coarse bore it tells what the mesh is too coarse for.
    pub(super) fn blamed(self, error: StructureError) -> StructureError {
        match (self, error) {
            (BoreHold::Lugs(_) | BoreHold::LooseLugs { .. }, StructureError::CoarseBore) => {
                StructureError::CoarseLugs
            }
            (_, error) => error,
        }
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
    /// What holds those that are let go, if anything does.
    pub lugs: Option<LugForms>,
    /// Whether these lugs are loose: then nothing does.
    pub loose: bool,
}

/// Which means of a bore are wanted.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wanted {
    /// As [`BoreHold::Means`] has them.
    pub waves: Option<u16>,
    pub degree: u8,
    /// Waves around up to which there are to be more that are let go, if any.
    pub coupled: Option<u16>,
    /// What they are let go against; then the motion as a whole is let go with them, unless lugs are `loose`.
    pub lugs: Option<Lugs>,
    /// Whether lugs have clearance: then they hold nothing of themselves.
    pub loose: bool,
}

impl Wanted {
    /// Of a ring where sectors up to `coupled` places apart have tables: others feel each other through the bore. `None` of a rigid bore.
    pub fn of_ring(hold: BoreHold, sectors: u32, coupled: u32) -> Option<Self> {
        let means = |waves, degree| Self::of_means(waves, degree, sectors, coupled);
        match hold {
            BoreHold::Rigid => None,
            BoreHold::Means { waves, degree } => Some(means(waves, degree)),
            BoreHold::Lugs(lugs) => Some(Self { lugs: Some(lugs), ..means(None, 0) }),
            BoreHold::LooseLugs { lugs, .. } => {
                Some(Self { lugs: Some(lugs), loose: true, ..means(None, 0) })
            }
        }
    }

    /// The same of a bore that is held in the mean.
    pub fn of_means(waves: Option<u16>, degree: u8, sectors: u32, coupled: u32) -> Self {
        let most = u16::try_from(sectors).unwrap_or(u16::MAX);
        let coupled = (coupled < sectors / 2).then_some(COUPLED_WAVES.min(most));
        Self { waves, degree, coupled, lugs: None, loose: false }
    }

    /// The same where there is one place along the axis.
    fn in_plane(self) -> Self {
        Self { degree: 0, lugs: self.lugs.map(|lugs| Lugs { degree: 0, ..lugs }), ..self }
    }
}

/// What is held of a surface of revolution.
pub(super) struct Patterns {
    pub series: Series,
    /// Which displacements of the series, [`Series::displacements`].
    pub places: Vec<usize>,
    /// How many of them are held.
    pub held: usize,
    lugs: Option<LugForms>,
    loose: bool,
}

impl Patterns {
    /// `None` if the surface has no extent. In the plane, where the generator is a point, only motions in it count.
    pub fn new(surface: RevolutionSurface, wanted: Wanted, in_plane: bool) -> Option<Patterns> {
        let lugs = wanted.lugs;
        let most_waves = [wanted.waves, wanted.coupled, lugs.map(|lugs| lugs.waves())];
        let most_waves = most_waves.into_iter().flatten().max().unwrap_or(0);
        let degree = lugs.map_or(wanted.degree, |lugs| lugs.degree.max(wanted.degree));
        let highest = match wanted.coupled {
            Some(_) if !in_plane => degree.max(COUPLED_DEGREE),
            _ => degree,
        };
        let series = Series::new(surface, most_waves, highest)?;
        let (mut held, mut free) = match (lugs.filter(|_| !wanted.loose), in_plane) {
            (None, true) => (vec![0, 1, 5], vec![]),
            (None, false) => ((0..6).collect::<Vec<_>>(), vec![]),
            (Some(_), true) => (vec![], vec![0, 1, 5]),
            // A tilt is in the mean no displacement of a lug.
            (Some(Lugs { degree: 0, .. }), false) => (vec![2, 3, 4], vec![0, 1, 5]),
            (Some(_), false) => (vec![2], vec![0, 1, 3, 4, 5]),
        };
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
            } else if of_coupling || lugs.is_some_and(|lugs| lugs.needs(term)) {
                free.push(6 + index);
            }
        }
        let count = held.len();
        held.append(&mut free);
        let lugs = match lugs {
            Some(lugs) => Some(lugs.on(&series, &held)?),
            None => None,
        };
        Some(Patterns { series, places: held, held: count, lugs, loose: wanted.loose })
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
        let Some(patterns) = Patterns::new(circle, wanted.in_plane(), true) else {
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
        let (shared, lugs, loose) = (patterns.shared(), patterns.lugs.clone(), patterns.loose);
        Ok(BoreMeans { forms, shared, held: patterns.held, carried: None, lugs, loose })
    }

    /// Lets the means go that are not to be held: freely, with loose lugs or without, or against what carries them, which becomes part of what
    /// the ring answers, or against lugs, which does not. `None` if there are none.
    ///
    /// # Errors
    /// The ring is free to move then, or the lugs cannot be told apart.
    pub fn let_go(&self, ring: &mut RingFlexibility) -> Result<Option<Released>, StructureError> {
        match &self.lugs {
            Some(lugs) if !self.loose => {
                let Some(bound) = ring.bound(self.held) else { return Ok(None) };
                let (release, lugs) = lugs.hold(bound.stiffness.as_ref(), self.held)?;
                let (shared, holding) = (bound.shared, bound.holding);
                Ok(Some(Released { shared, release, holding, lugs: Some(lugs), loose: None }))
            }
            lugs => {
                let Some(released) = ring.release(self.held, self.carried.as_ref())? else { return Ok(None) };
                let loose = lugs.as_ref().map(|lugs| lugs.loose(self.held, released.release.as_ref()));
                Ok(Some(Released { loose: loose.transpose()?, ..released }))
            }
        }
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
