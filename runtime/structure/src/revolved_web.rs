//! Web with a separate mesh, joined to a rim through a series on the cylinder between them (report
//! 2.7).
//!
//! A web is a body of revolution, the toothed rim is not, and the two meshes need not match. Both
//! share the amplitudes of a series on the part of the rim's bore to which the web is joined:
//! Fourier terms around and polynomials along it. On the web this series is the complete
//! displacement of its outer surface. The rim carries the conjugate forces and can deform in other
//! shapes too. Truncating the series therefore makes the joint softer on the rim's side and stiffer
//! on the web's side, and both errors decrease with every term. Rigid-body motions are separate
//! terms, exact on both sides, so the joint is in equilibrium however short the series is.
//!
//! The web responds in each harmonic separately ([`RevolutionModel`]); its bore is supported like
//! that of a rim, fixed or by mean constraints. The result is a stiffness against amplitudes that
//! does not depend on the rotation of the web. A ring whose bore is released against it
//! ([`super::ring::RingFlexibility::release`]) has tables of the same size as one with a free bore:
//! the web adds no cost for each tooth.
//!
//! See `docs/theory/substructures.md`.

use super::bore::{BoreConstraints, BoreMeans, RequestedMeans, bore_surface};
use super::dense::{add_product, cholesky, mirror_lower, product, solve};
use super::{BoreSupport, StructureError};
use calyx_fe::material::Material;
use calyx_fe::solid::{ElementFace, FaceSet, RevolutionSurface, SolidModel};
use calyx_fe::{Constraints, ElementOrder, MeshError, RevolutionModel, Section, Solver, Station};
use calyx_numerics::interrupt::Interrupt;
use faer::Mat;
use faer::linalg::solvers::Solve;
use faer::sparse::SparseColMat;
use rayon::prelude::*;

/// Web and its support, as a body of revolution.
#[derive(Clone, Debug, PartialEq)]
pub struct RevolvedWeb {
    /// Section from the bore of the web out to the rim, axial coordinates in the gear's frame.
    pub section: Section,
    /// Material of the web.
    pub material: Material,
    /// Support of the bore of the web.
    pub support: BoreSupport,
    /// Highest harmonic of the joint to the rim.
    pub harmonics: u16,
    /// Highest degree of polynomials along the axis in the joint to the rim.
    pub degree: u8,
    /// Factor on the number of elements in each direction; 1 is sufficient.
    pub fineness: usize,
}

/// Equations of a web for one harmonic, with the outer surface fixed.
struct WebHarmonic<'a> {
    stiffness: SparseColMat<usize, f64>,
    solver: Solver,
    /// Mean constraints on the bore, by family.
    bore: [Vec<Vec<f64>>; 2],
    model: &'a RevolutionModel,
}

impl RevolvedWeb {
    /// Returns the number of unknowns of the joint.
    pub fn unknowns(&self) -> usize {
        let [_, outside] = self.section.outermost();
        let cylinder = RevolutionSurface::cylinder(outside.radius, outside.ends);
        let patterns = BoreConstraints::new(cylinder, self.wanted(), false);
        patterns.map_or(0, |patterns| patterns.places.len())
    }

    /// Builds the model of the section. Each harmonic has three unknowns for each of its
    /// displacement nodes.
    ///
    /// # Errors
    /// The section cannot be meshed.
    pub fn model(&self) -> Result<RevolutionModel, MeshError> {
        let mesh = self.section.mesh(ElementOrder::CUBIC, self.fineness.max(1))?;
        Ok(RevolutionModel { mesh, material: self.material })
    }

    pub(super) fn wanted(&self) -> RequestedMeans {
        RequestedMeans::of_means(Some(self.harmonics), self.degree)
    }

    /// Returns the forces on the outer surface by amplitudes of the series there, N/m, N and N m:
    /// zero for amplitudes that are not part of the joint.
    ///
    /// # Errors
    /// The section cannot be meshed, its bore is too coarse for its support, or the computation is
    /// interrupted.
    pub(super) fn stiffness(
        &self,
        joint: &BoreConstraints,
        interrupt: &Interrupt,
    ) -> Result<Mat<f64>, StructureError> {
        let model = self.model().map_err(|error| StructureError::Web { error: error.to_string() })?;
        let bore = match self.support {
            BoreSupport::SplineTeeth(_) | BoreSupport::SplineWithClearance { .. } => {
                return Err(StructureError::Web {
                    error: "spline teeth cannot support a web with a mesh of its own".into(),
                });
            }
            BoreSupport::Raceway { .. } => {
                return Err(StructureError::Web {
                    error: "the bore of a web with a mesh of its own cannot be a raceway".into(),
                });
            }
            BoreSupport::Rigid => None,
            BoreSupport::Means { harmonics, degree } => {
                let [inside, _] = self.section.outermost();
                let cylinder = RevolutionSurface::cylinder(inside.radius, inside.ends);
                let wanted = RequestedMeans::of_means(harmonics, degree);
                Some(BoreConstraints::new(cylinder, wanted, false).ok_or(StructureError::NoArea)?)
            }
        };
        let (all, joined) =
            (joint.series.harmonics(), &joint.places[..joint.constrained.min(joint.places.len())]);
        let outside = outside_of(&model);
        let moved: Vec<(usize, Vec<[f64; 3]>)> =
            outside.iter().map(|&node| (node, joint.series.amplitudes(model.mesh.nodes[node]))).collect();
        let most = joined.iter().map(|&place| all[place].0).max().unwrap_or(0);
        let by_harmonic = (0..=most)
            .into_par_iter()
            .map(|harmonic| {
                interrupt.check().map_err(StructureError::Interrupted)?;
                let wave = WebHarmonic::new(&model, harmonic, bore.as_ref(), &outside)?;
                [false, true]
                    .map(|turned| {
                        let own: Vec<usize> =
                            (0..joined.len()).filter(|&k| all[joined[k]] == (harmonic, turned)).collect();
                        let mut outer = Mat::zeros(model.dof_count(), own.len());
                        for (column, &k) in own.iter().enumerate() {
                            for (node, amplitudes) in &moved {
                                for (component, value) in amplitudes[joined[k]].into_iter().enumerate() {
                                    outer[(3 * node + component, column)] = value;
                                }
                            }
                        }
                        wave.stiffness(&outer, turned).map(|stiffness| (own, stiffness))
                    })
                    .into_iter()
                    .collect::<Result<Vec<_>, StructureError>>()
            })
            .collect::<Result<Vec<_>, StructureError>>()?;
        let mut stiffness = Mat::zeros(joint.places.len(), joint.places.len());
        for (own, block) in by_harmonic.into_iter().flatten() {
            for (row, &at_row) in own.iter().enumerate() {
                for (column, &at_column) in own.iter().enumerate() {
                    stiffness[(at_row, at_column)] = block[(row, column)];
                }
            }
        }
        Ok(stiffness)
    }
}

fn outside_of(model: &RevolutionModel) -> Vec<usize> {
    model.mesh.chain("rim").map_or_else(Vec::new, |chain| model.mesh.chain_nodes(chain))
}

impl<'a> WebHarmonic<'a> {
    fn new(
        model: &'a RevolutionModel,
        harmonic: u16,
        bore: Option<&BoreConstraints>,
        outside: &[usize],
    ) -> Result<Self, StructureError> {
        let stiffness = model.stiffness(harmonic);
        let chain = model.mesh.chain("bore").ok_or(StructureError::NoArea)?;
        let mut constrained = Constraints::new();
        let inside = if bore.is_none() { model.mesh.chain_nodes(chain) } else { Vec::new() };
        for dof in outside.iter().chain(&inside).flat_map(|node| 3 * node..3 * node + 3) {
            constrained.prescribe(dof, 0.0);
        }
        let solver = Solver::new(&stiffness, constrained)?;
        let forms = |turned: bool| {
            let Some(BoreConstraints { series, places, .. }) = bore else { return Vec::new() };
            let all = series.harmonics();
            let own = places.iter().filter(|&&place| all[place] == (harmonic, turned));
            own.map(|&place| model.edge_load(chain, harmonic, |at| series.amplitudes(at)[place])).collect()
        };
        let bore = [forms(false), forms(true)];
        Ok(Self { stiffness, solver, bore, model })
    }

    /// Returns the forces by amplitudes; `outer` are the displacements of the outer surface.
    fn stiffness(&self, outer: &Mat<f64>, turned: bool) -> Result<Mat<f64>, StructureError> {
        if outer.ncols() == 0 {
            return Ok(Mat::zeros(0, 0));
        }
        let loads = -self.times(outer);
        let mut moved = self.solver.solve(loads.as_ref())?;
        moved += outer;
        let forces = self.times(&moved);
        let mut stiffness = product(outer.transpose(), forces.as_ref());
        let forms = &self.bore[usize::from(turned)];
        if !forms.is_empty() {
            let forms = Mat::from_fn(self.model.dof_count(), forms.len(), |row, form| forms[form][row]);
            let yielded = self.solver.solve(forms.as_ref())?;
            let means = product(forms.transpose(), moved.as_ref());
            let factor = cholesky(product(forms.transpose(), yielded.as_ref()));
            let reactions = solve(factor.ok_or(StructureError::CoarseBore)?.as_ref(), means.clone());
            add_product(stiffness.as_mut(), 1.0, means.transpose(), reactions.as_ref());
        }
        mirror_lower(&mut stiffness);
        Ok(stiffness)
    }

    fn times(&self, columns: &Mat<f64>) -> Mat<f64> {
        let mut product = Mat::zeros(columns.nrows(), columns.ncols());
        for entry in self.stiffness.triplet_iter() {
            for column in 0..columns.ncols() {
                product[(entry.row, column)] += entry.val * columns[(entry.col, column)];
            }
        }
        product
    }
}

impl BoreMeans {
    /// Builds the means over the part of a bore to which a web is joined, of `sectors` sectors; the
    /// rest of the bore is free. Only the web supports the ring.
    pub fn on_web(
        model: &SolidModel,
        bore: &FaceSet,
        web: &RevolvedWeb,
        sectors: u32,
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
        let Some(cylinder) = bore_surface(model, &bore) else { return Ok(None) };
        let wanted = web.wanted();
        let Some(patterns) = BoreConstraints::new(cylinder, wanted, false) else { return Ok(None) };
        interrupt.check().map_err(StructureError::Interrupted)?;
        let forms = model.face_loads(&bore, |point| patterns.at(point.position));
        let mut means = Self::of(&patterns, forms);
        // Means by amplitudes of the series: exact for rigid-body motions on any mesh.
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
        means.constrained = 0;
        Ok(Some(means))
    }
}

/// Returns the forces on means, from a stiffness against amplitudes and the means by amplitudes:
/// `M^-T K M^-1`.
fn of_means(stiffness: &Mat<f64>, by_amplitude: &Mat<f64>) -> Mat<f64> {
    let factor = by_amplitude.transpose().to_owned().partial_piv_lu();
    let once = factor.solve(stiffness);
    let mut twice = factor.solve(once.transpose().to_owned());
    mirror_lower(&mut twice);
    twice
}
