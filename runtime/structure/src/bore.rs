//! Support of a ring's bore by its frame: fixed at all nodes, by mean displacements only, or by
//! spline teeth.
//!
//! With mean constraints the bore can deform. The frame constrains the rigid-body motions that are
//! nearest to the bore's displacements in the mean square, six in three dimensions and three in a
//! plane model: "rigid-body terms constrained alone" (report 2.7). These constraints cause no
//! strain, so a ring on such a bore is statically determinate. The constraint forces are
//! distributed like the displacements of a rigid body: sine and cosine around the bore under a
//! transverse force, uniform along the circle under a torque. Terms of the series of
//! [`calyx_fe::solid::fourier`] can be constrained in addition, up to some harmonic around and
//! some degree along the bore; with an increasing number of terms the bore becomes rigid. As an
//! alternative, spline teeth support the bore at some angular positions ([`super::spline_teeth`]).
//!
//! See `docs/theory/substructures.md`.

use super::StructureError;
use super::raceway::{Raceway, RacewayForms};
use super::ring::{ReleasedMeans, RingFlexibility, SharedUnknowns};
use super::spline_teeth::{SplineTeeth, SplineToothForms};
use calyx_fe::solid::fourier::{RevolutionSurface, Series};
use calyx_fe::solid::{ElementFace, FaceSet, SolidModel};
use calyx_fe::{EdgeChain, PlaneModel, SparseVector};
use calyx_numerics::interrupt::Interrupt;
use faer::Mat;

/// Support of the bore of a ring.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum BoreSupport {
    /// All nodes of the bore are fixed.
    #[default]
    Rigid,
    /// The mean motion of the bore is constrained; the bore can deform except in the constrained
    /// terms of a series.
    Means {
        /// Highest constrained harmonic; `None` constrains none, 0 the axisymmetric terms.
        harmonics: Option<u16>,
        /// Highest constrained degree of polynomials along the bore.
        degree: u8,
    },
    /// Spline teeth support the bore. Mean constraints fix the rigid-body motion that the spline
    /// teeth leave free: axial motion, and motions beyond their degree.
    SplineTeeth(SplineTeeth),
    /// Spline teeth with clearance, whose contact is solved outside the structure
    /// ([`super::bore_interface`]). The structure uses mean constraints. Plane models only.
    SplineWithClearance {
        /// The spline teeth. Their compliance and radial constraint are not part of the structure.
        spline_teeth: SplineTeeth,
        /// Clearance, see `SplineContact::clearance`; not
        /// part of the structure.
        clearance: f64,
    },
    /// Raceway of rollers, whose contact is solved outside the structure
    /// ([`super::bore_interface`]). The structure uses mean constraints.
    Raceway {
        /// Highest harmonic of the series around the bore.
        harmonics: u16,
        /// Highest degree of the polynomials along it, at most
        /// [`super::raceway::HIGHEST_DEGREE`].
        degree: u8,
    },
}

impl BoreSupport {
    /// Returns the number of unknowns that constrain the bore of a ring; 0 for a rigid bore.
    pub fn unknowns(self, in_plane: bool) -> usize {
        let Some(wanted) = RequestedMeans::for_ring(self) else { return 0 };
        let wanted = if in_plane { wanted.in_plane() } else { wanted };
        let ends = if in_plane { [0.0; 2] } else { [-1.0, 1.0] };
        let patterns = BoreConstraints::new(RevolutionSurface::cylinder(1.0, ends), wanted, in_plane);
        patterns.map_or(0, |patterns| patterns.places.len())
    }

    /// Adapts an error in condensing a ring with this support: for a coarse bore it names the
    /// series that the mesh cannot resolve.
    pub(super) fn with_bore_context(self, error: StructureError) -> StructureError {
        match (self, error) {
            (
                BoreSupport::SplineTeeth(_) | BoreSupport::SplineWithClearance { .. },
                StructureError::CoarseBore,
            ) => StructureError::CoarseSplineTeeth,
            (_, error) => error,
        }
    }
}

/// Linear forms of the displacements of one sector whose sums over the ring vanish.
pub(super) struct BoreMeans {
    /// Linear forms, one for each mean; also the load vectors of the constraint forces.
    pub forms: Vec<SparseVector>,
    /// Rotation of the means from sector to sector.
    pub shared: SharedUnknowns,
    /// Number of constrained means. The remaining ones are to be released, see
    /// [`super::bore_coupling`].
    pub constrained: usize,
    /// Forces by the released means where a web supports them, see [`super::revolved_web`].
    pub carried: Option<Mat<f64>>,
    /// Spline teeth that support the released means, if any.
    pub spline_teeth: Option<SplineToothForms>,
    /// True if these spline teeth have clearance: then they do not support the ring.
    pub with_clearance: bool,
    /// Raceway in the bore, if any.
    pub raceway: Option<RacewayForms>,
}

/// Selection of mean displacements of a bore.
#[derive(Clone, Copy, Debug)]
pub(super) struct RequestedMeans {
    /// Harmonics, as in [`BoreSupport::Means`].
    pub harmonics: Option<u16>,
    pub degree: u8,
    /// Spline teeth against which means are released. Unless the teeth are `with_clearance`, the
    /// rigid-body motion is released too.
    pub spline_teeth: Option<SplineTeeth>,
    /// True if the spline teeth have clearance: then they do not support the ring.
    pub with_clearance: bool,
    /// Highest harmonic and degree of the series of a raceway, if the bore is one.
    pub raceway: Option<(u16, u8)>,
}

impl RequestedMeans {
    /// Selects the means for a ring; `None` for a rigid bore.
    pub fn for_ring(support: BoreSupport) -> Option<Self> {
        let means = Self::of_means(None, 0);
        match support {
            BoreSupport::Rigid => None,
            BoreSupport::Means { harmonics, degree } => Some(Self::of_means(harmonics, degree)),
            BoreSupport::SplineTeeth(spline_teeth) => {
                Some(Self { spline_teeth: Some(spline_teeth), ..means })
            }
            BoreSupport::SplineWithClearance { spline_teeth, .. } => {
                Some(Self { spline_teeth: Some(spline_teeth), with_clearance: true, ..means })
            }
            BoreSupport::Raceway { harmonics, degree } => {
                Some(Self { raceway: Some((harmonics, degree)), ..means })
            }
        }
    }

    /// Selects the means for a bore with mean constraints.
    pub fn of_means(harmonics: Option<u16>, degree: u8) -> Self {
        Self { harmonics, degree, spline_teeth: None, with_clearance: false, raceway: None }
    }

    /// Returns the selection for a plane model, without variation along the axis.
    fn in_plane(self) -> Self {
        Self {
            degree: 0,
            spline_teeth: self.spline_teeth.map(|spline_teeth| SplineTeeth { degree: 0, ..spline_teeth }),
            raceway: self.raceway.map(|(harmonics, _)| (harmonics, 0)),
            ..self
        }
    }
}

/// Constraints on a surface of revolution.
pub(super) struct BoreConstraints {
    pub series: Series,
    /// Indices of the displacements of the series, [`Series::displacements`].
    pub places: Vec<usize>,
    /// Number of constrained displacements.
    pub constrained: usize,
    spline_teeth: Option<SplineToothForms>,
    with_clearance: bool,
    raceway: Option<RacewayForms>,
}

impl BoreConstraints {
    /// Returns `None` if the surface has no extent. In a plane model, where the generator is a
    /// point, only in-plane motions count.
    pub fn new(
        surface: RevolutionSurface,
        wanted: RequestedMeans,
        in_plane: bool,
    ) -> Option<BoreConstraints> {
        let spline_teeth = wanted.spline_teeth;
        let raceway = wanted.raceway.map(|(harmonics, degree)| Raceway {
            radius: 0.0,
            ends: [0.0; 2],
            harmonics,
            degree,
        });
        let most_harmonics = [
            wanted.harmonics,
            spline_teeth.map(|spline_teeth| spline_teeth.harmonics()),
            raceway.map(|raceway| raceway.harmonics),
        ];
        let most_harmonics = most_harmonics.into_iter().flatten().max().unwrap_or(0);
        let degree =
            spline_teeth.map_or(wanted.degree, |spline_teeth| spline_teeth.degree.max(wanted.degree));
        let degree = raceway.map_or(degree, |raceway| raceway.degree.max(degree));
        let series = Series::new(surface, most_harmonics, degree)?;
        let (mut constrained, mut free) = match (spline_teeth.filter(|_| !wanted.with_clearance), in_plane) {
            (None, true) => (vec![0, 1, 5], vec![]),
            (None, false) => ((0..6).collect::<Vec<_>>(), vec![]),
            (Some(_), true) => (vec![], vec![0, 1, 5]),
            // On average a tilt displaces no spline tooth.
            (Some(SplineTeeth { degree: 0, .. }), false) => (vec![2, 3, 4], vec![0, 1, 5]),
            (Some(_), false) => (vec![2], vec![0, 1, 3, 4, 5]),
        };
        for (index, term) in series.terms().iter().enumerate() {
            if in_plane && term.is_axial() {
                continue;
            }
            let of_hold = wanted.harmonics.is_some_and(|harmonics| term.harmonic <= harmonics)
                && term.degree <= wanted.degree;
            if of_hold {
                constrained.push(6 + index);
            } else if spline_teeth.is_some_and(|spline_teeth| spline_teeth.needs(term))
                || raceway.is_some_and(|raceway| raceway.needs(term))
            {
                free.push(6 + index);
            }
        }
        let count = constrained.len();
        constrained.append(&mut free);
        let spline_teeth = match spline_teeth {
            Some(spline_teeth) => Some(spline_teeth.on(&series, &constrained)?),
            None => None,
        };
        let raceway = match raceway {
            Some(raceway) => Some(raceway.on(&series, &constrained)?),
            None => None,
        };
        Some(BoreConstraints {
            series,
            places: constrained,
            constrained: count,
            spline_teeth,
            with_clearance: wanted.with_clearance,
            raceway,
        })
    }

    pub(super) fn at(&self, position: [f64; 3]) -> Vec<[f64; 3]> {
        let all = self.series.displacements(position);
        self.places.iter().map(|&place| all[place]).collect()
    }

    /// Returns the transformation of the means under rotation. Translations across the axis and
    /// rotations about transverse axes transform like vectors; cosines and sines rotate by their
    /// harmonic times the angle.
    pub fn shared(&self) -> SharedUnknowns {
        let harmonics = |place: usize| match place {
            0 | 3 => Some(1),
            1 | 2 | 4 | 5 => None,
            term => self.series.terms().get(term - 6).filter(|term| !term.sine).map(|term| term.harmonic),
        };
        let pairs = self.places.iter().enumerate().filter_map(|(index, &place)| {
            let harmonics = harmonics(place).filter(|&harmonics| harmonics > 0)?;
            Some(([index, index + 1], f64::from(harmonics)))
        });
        SharedUnknowns { count: self.places.len(), pairs: pairs.collect() }
    }
}

impl BoreMeans {
    /// Builds the means over a chain of edges on a circle about the origin.
    pub fn plane(
        model: &PlaneModel,
        bore: &EdgeChain,
        wanted: RequestedMeans,
        interrupt: &Interrupt,
    ) -> Result<Option<BoreMeans>, StructureError> {
        let mut radius = 0.0_f64;
        model.edge_load(bore, |_, point| {
            radius = radius.max(point.position[0].hypot(point.position[1]));
            [0.0; 2]
        });
        let circle = RevolutionSurface::cylinder(radius, [0.0; 2]);
        let Some(patterns) = BoreConstraints::new(circle, wanted.in_plane(), true) else {
            return Ok(None);
        };
        interrupt.check().map_err(StructureError::Interrupted)?;
        let forms = model.edge_loads(bore, |_, point| {
            let [x, y] = point.position;
            let in_plane = |[x, y, _]: [f64; 3]| [x, y];
            patterns.at([x, y, 0.0]).into_iter().map(in_plane).collect::<Vec<_>>()
        });
        Ok(Some(Self::of(&patterns, forms)))
    }

    /// Builds the means over a set of faces on a cylinder or cone about the z axis.
    pub fn solid(
        model: &SolidModel,
        bore: &FaceSet,
        wanted: RequestedMeans,
        interrupt: &Interrupt,
    ) -> Result<Option<BoreMeans>, StructureError> {
        // Next to a web there is no face.
        let present = |face: &&ElementFace| !model.mesh.absent.contains(&face.element);
        let bore = FaceSet { faces: bore.faces.iter().filter(present).copied().collect(), chart: None };
        let Some(surface) = bore_surface(model, &bore) else { return Ok(None) };
        let Some(patterns) = BoreConstraints::new(surface, wanted, false) else { return Ok(None) };
        interrupt.check().map_err(StructureError::Interrupted)?;
        let forms = model.face_loads(&bore, |point| patterns.at(point.position));
        Ok(Some(Self::of(&patterns, forms)))
    }

    /// Builds the means from the integrals of the displacements over the bore, one for each
    /// pattern.
    pub(super) fn of(patterns: &BoreConstraints, forms: Vec<SparseVector>) -> BoreMeans {
        let (shared, spline_teeth, with_clearance) =
            (patterns.shared(), patterns.spline_teeth.clone(), patterns.with_clearance);
        BoreMeans {
            forms,
            shared,
            constrained: patterns.constrained,
            carried: None,
            spline_teeth,
            with_clearance,
            raceway: patterns.raceway.clone(),
        }
    }

    /// Releases the means that are not constrained. They are released freely (with or without
    /// spline teeth with clearance) or against what supports them: a web, which becomes part of the
    /// ring's response, or spline teeth, which do not. `None` if there are no such means.
    ///
    /// # Errors
    /// The released ring has a rigid-body motion, the spline teeth cannot be distinguished, or the
    /// computation is interrupted.
    pub fn release(
        &self,
        ring: &mut RingFlexibility,
        interrupt: &Interrupt,
    ) -> Result<Option<ReleasedMeans>, StructureError> {
        match &self.spline_teeth {
            Some(spline_teeth) if !self.with_clearance => {
                let Some(bound) = ring.bound(self.constrained) else { return Ok(None) };
                let (release, spline_teeth) =
                    spline_teeth.constrain(bound.stiffness.as_ref(), self.constrained, interrupt)?;
                let (shared, constraint_forces) = (bound.shared, bound.constraint_forces);
                Ok(Some(ReleasedMeans {
                    shared,
                    release,
                    constraint_forces,
                    spline_teeth: Some(spline_teeth),
                    interface: None,
                }))
            }
            spline_teeth => {
                let Some(released) = ring.release(self.constrained, self.carried.as_ref(), interrupt)? else {
                    return Ok(None);
                };
                let (first, release) = (self.constrained, released.release.as_ref());
                let interface = match (spline_teeth, &self.raceway) {
                    (Some(spline_teeth), _) => Some(spline_teeth.with_clearance(first, release, interrupt)?),
                    (None, Some(raceway)) => Some(raceway.released(first, release, interrupt)?),
                    (None, None) => None,
                };
                Ok(Some(ReleasedMeans { interface, ..released }))
            }
        }
    }
}

/// Largest difference of radii on a cylinder, relative to the largest radius.
const SAME_RADIUS: f64 = 1e-6;

/// Returns the cylinder or cone about the z axis on which faces lie; `None` if they have no length
/// along its generator.
pub(super) fn bore_surface(model: &SolidModel, faces: &FaceSet) -> Option<RevolutionSurface> {
    let places: Vec<[f64; 2]> = model
        .mesh
        .nodes_on(faces)
        .into_iter()
        .map(|node| model.mesh.nodes[node])
        .map(|[x, y, z]| [x.hypot(y), z])
        .collect();
    let largest = places.iter().map(|place| place[0]).fold(0.0, f64::max);
    let is_cylinder = places.iter().all(|place| largest - place[0] <= SAME_RADIUS * largest);
    // The ends of the generator are the extreme nodes along z, on a cone those along its generator.
    let first = *places.first()?;
    let apart = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
    let farthest = |from: [f64; 2]| {
        places.iter().copied().max_by(|a, b| apart(*a, from).total_cmp(&apart(*b, from))).unwrap_or(from)
    };
    if is_cylinder {
        let z = || places.iter().map(|place| place[1]);
        let ends = [z().fold(f64::INFINITY, f64::min), z().fold(f64::NEG_INFINITY, f64::max)];
        return (ends[0] < ends[1]).then(|| RevolutionSurface::cylinder(largest, ends));
    }
    let one = farthest(first);
    let other = farthest(one);
    let [from, to] = if one[1] < other[1] { [one, other] } else { [other, one] };
    let middle = 0.5 * (from[1] + to[1]);
    let generator = [[from[0], from[1] - middle], [to[0], to[1] - middle]];
    let cylinder = RevolutionSurface::cylinder(largest, [from[1], to[1]]);
    (apart(from, to) > 0.0).then_some(RevolutionSurface { generator, ..cylinder })
}
