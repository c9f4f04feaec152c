//! Surfaces of revolution with displacements in a Fourier series around and polynomials along them
//! (report 2.7): they join non-matching meshes at webs, bores and seats.
//!
//! The report uses six terms for the rigid-body motions of the surface and constrains these alone.
//! Only two of them are rigid-body motions by themselves. A translation along x is
//! `u_r = cos t, u_t = -sin t`, and the report's `u_r = cos t` is half of that and half the strain
//! `u_r = cos t, u_t = sin t`; a rotation about x is
//! `u_r = -z sin t, u_t = -z cos t, u_z = R sin t`. Here the rigid-body motions are separate
//! unknowns, exact for any positions of the nodes. The rigid part of every other term, its mean
//! translation and rotation over the surface, is removed. Both span the same displacements;
//! constraining the six rigid-body unknowns fixes the surface as a whole and nothing else.

use calyx_numerics::quadrature::gauss_legendre;
use calyx_numerics::vec3::dot;
use nalgebra::{Matrix6, Vector6};
use std::f64::consts::TAU;

/// Surface of revolution with a straight generator: a cylinder, a cone, or a plane ring.
#[derive(Clone, Debug, PartialEq)]
pub struct RevolutionSurface {
    /// Middle of the axis, the centre of rotations, m.
    pub center: [f64; 3],
    /// Orthonormal, right-handed axes: the direction from which angles count, the one at a right
    /// angle, and the axis of revolution.
    pub axes: [[f64; 3]; 3],
    /// Radius and axial coordinate relative to the centre, of both ends of the generator, m.
    pub generator: [[f64; 2]; 2],
}

impl RevolutionSurface {
    /// Returns a cylinder about the z axis between two axial coordinates, m.
    pub fn cylinder(radius: f64, [from, to]: [f64; 2]) -> Self {
        let middle = 0.5 * (from + to);
        Self {
            center: [0.0, 0.0, middle],
            axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            generator: [[radius, from - middle], [radius, to - middle]],
        }
    }

    /// Returns radius and axial coordinate at a coordinate along the generator, -1 to 1.
    fn on_generator(&self, zeta: f64) -> [f64; 2] {
        let [from, to] = self.generator;
        [0, 1].map(|k| 0.5 * ((1.0 - zeta) * from[k] + (1.0 + zeta) * to[k]))
    }

    /// Returns half of the generator, as a vector.
    fn half(&self) -> [f64; 2] {
        [0, 1].map(|k| 0.5 * (self.generator[1][k] - self.generator[0][k]))
    }
}

/// Direction at a point of a surface of revolution.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Component {
    /// Radial, away from the axis.
    Radial,
    /// Tangential, counter-clockwise.
    Tangential,
    /// Axial.
    Axial,
}

/// Term of the series: a component of the displacement, Legendre polynomial of a degree along the
/// generator, cosine or sine around.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Term {
    /// Direction of the displacement.
    pub component: Component,
    /// Degree of the polynomial along the generator; the powers of z of the report span the same
    /// space.
    pub degree: u8,
    /// Harmonic around the axis.
    pub harmonic: u16,
    /// Sine instead of cosine.
    pub sine: bool,
}

/// Displacement series of a surface, up to some harmonic around and some degree along.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    surface: RevolutionSurface,
    terms: Vec<Term>,
    /// Rigid part of each term: translations along and rotations about the axes.
    rigid_parts: Vec<[f64; 6]>,
}

impl Series {
    /// Builds the series on a surface. `None` if the surface has no extent: a radius is negative,
    /// both are zero, or the generator is a point and the degree is above zero.
    pub fn new(surface: RevolutionSurface, harmonics: u16, degree: u8) -> Option<Self> {
        let [[r0, z0], [r1, z1]] = surface.generator;
        let point = r0 == r1 && z0 == z1;
        let sound = r0 >= 0.0 && r1 >= 0.0 && r0 + r1 > 0.0 && !(point && degree > 0);
        if !sound {
            return None;
        }
        // True if the rigid-body motions are in the span of the terms; then one term is omitted for
        // each.
        let tilted = harmonics > 0 && (degree > 0 || point);
        let turned = degree > 0 || r0 == r1;
        let kept = |term: &Term| match (term.component, term.degree, term.harmonic) {
            (Component::Tangential, 0, 1) => false,
            (Component::Axial, 0, 0) => false,
            (Component::Tangential, 0, 0) => !turned,
            (Component::Axial, 0, 1) => !tilted,
            _ => true,
        };
        let mut terms = Vec::new();
        for component in [Component::Radial, Component::Tangential, Component::Axial] {
            for degree in 0..=degree {
                for harmonic in 0..=harmonics {
                    let both = if harmonic == 0 { &[false][..] } else { &[false, true] };
                    terms.extend(both.iter().map(|&sine| Term { component, degree, harmonic, sine }));
                }
            }
        }
        terms.retain(kept);
        let mut series = Self { surface, terms, rigid_parts: Vec::new() };
        series.rigid_parts = series.project(usize::from(harmonics), usize::from(degree))?;
        Some(series)
    }

    /// Returns the terms; their unknowns follow the six rigid-body ones.
    pub fn terms(&self) -> &[Term] {
        &self.terms
    }

    /// Returns the surface.
    pub fn surface(&self) -> &RevolutionSurface {
        &self.surface
    }

    /// Returns the displacement at a position on the surface by a unit of each unknown:
    /// translations along the axes (m), rotations about them through the centre (rad), terms (m).
    pub fn displacements(&self, position: [f64; 3]) -> Vec<[f64; 3]> {
        let RevolutionSurface { center, axes, .. } = &self.surface;
        let from_center = [0, 1, 2].map(|axis| position[axis] - center[axis]);
        let local = axes.map(|axis| dot(axis, from_center));
        let [half_r, half_z] = self.surface.half();
        let [r, z] = self.surface.on_generator(0.0);
        let (radius, angle) = (local[0].hypot(local[1]), local[1].atan2(local[0]));
        let length = half_r * half_r + half_z * half_z;
        let zeta =
            if length > 0.0 { ((radius - r) * half_r + (local[2] - z) * half_z) / length } else { 0.0 };
        let rigid = rigid_motions(local);
        let mut all = rigid.to_vec();
        all.extend(self.terms.iter().zip(&self.rigid_parts).map(|(term, parts)| {
            let value = term.displacement(angle, zeta);
            [0, 1, 2].map(|k| value[k] - (0..6).map(|mode| parts[mode] * rigid[mode][k]).sum::<f64>())
        }));
        let outward = |local: [f64; 3]| {
            [0, 1, 2].map(|k| local[0] * axes[0][k] + local[1] * axes[1][k] + local[2] * axes[2][k])
        };
        all.into_iter().map(outward).collect()
    }

    /// Returns the harmonic of each unknown, and its family: `false` where the radial and axial
    /// displacements are cosines and the tangential one is a sine, `true` where the field is
    /// rotated by a quarter of a wavelength. Unknowns of harmonic zero have `false`.
    pub fn harmonics(&self) -> Vec<(u16, bool)> {
        let rigid = [(1, false), (1, true), (0, false), (1, true), (1, false), (0, false)];
        let of_term = |term: &Term| {
            let turned = term.harmonic > 0 && term.sine != (term.component == Component::Tangential);
            (term.harmonic, turned)
        };
        rigid.into_iter().chain(self.terms.iter().map(of_term)).collect()
    }

    /// Returns the radial, tangential and axial amplitude of each unknown at a point of a section
    /// about the z axis, given by radius and axial coordinate.
    pub fn amplitudes(&self, [radius, z]: [f64; 2]) -> Vec<[f64; 3]> {
        let at = |angle: f64| {
            let (sin, cos) = angle.sin_cos();
            let polar = move |[x, y, z]: [f64; 3]| [cos * x + sin * y, cos * y - sin * x, z];
            self.displacements([radius * cos, radius * sin, z]).into_iter().map(polar).collect::<Vec<_>>()
        };
        let harmonics = self.harmonics();
        let most = harmonics.iter().map(|(harmonic, _)| *harmonic).max().unwrap_or(0);
        let mut amplitudes = vec![[0.0; 3]; harmonics.len()];
        for harmonic in 0..=most {
            // Sample a harmonic at its maximum and at its zero.
            let quarter = if harmonic == 0 { 0.0 } else { 0.25 * TAU / f64::from(harmonic) };
            let quarters = [0.0, quarter, 2.0 * quarter].map(at);
            for (unknown, &(own, turned)) in harmonics.iter().enumerate() {
                if own == harmonic {
                    let [crest, zero] = [usize::from(turned), usize::from(turned) + 1];
                    let [radial, _, axial] = quarters[crest][unknown];
                    amplitudes[unknown] = [radial, quarters[zero][unknown][1], axial];
                }
            }
        }
        amplitudes
    }

    /// Returns the amounts of the unknowns whose sum is a term including its rigid part. For an
    /// omitted term this is the corresponding rigid-body motion less the rest of that motion.
    /// `None` if the unknowns do not span it.
    pub fn amounts(&self, wanted: Term) -> Option<Vec<(usize, f64)>> {
        if let Some(index) = self.terms.iter().position(|&term| term == wanted) {
            let rigid = self.rigid_parts.get(index)?.iter().copied().enumerate();
            return Some(rigid.chain([(6 + index, 1.0)]).collect());
        }
        let with = |motion: usize, amount: f64, rest: Option<(Term, f64)>| {
            let mut all = vec![(motion, amount)];
            if let Some((term, share)) = rest {
                all.extend(self.amounts(term)?.into_iter().map(|(place, part)| (place, share * part)));
            }
            Some(all)
        };
        let Term { component, degree, harmonic, sine } = wanted;
        match (component, degree, harmonic) {
            // A translation has equal tangential and radial amplitudes.
            (Component::Tangential, 0, 1) => {
                let outwards = Term { component: Component::Radial, sine: !sine, ..wanted };
                let (motion, sign) = if sine { (0, -1.0) } else { (1, 1.0) };
                with(motion, sign, Some((outwards, -sign)))
            }
            (Component::Tangential, 0, 0) => {
                let ([half, _], [radius, _]) = (self.surface.half(), self.surface.on_generator(0.0));
                let sloped = Term { degree: 1, ..wanted };
                with(5, radius.recip(), (half != 0.0).then_some((sloped, -half / radius)))
            }
            (Component::Axial, 0, 0) => with(2, 1.0, None),
            _ => None,
        }
    }

    /// Returns the amounts of the six rigid-body motions nearest to each term, in the mean square
    /// over the surface.
    fn project(&self, harmonics: usize, degree: usize) -> Option<Vec<[f64; 6]>> {
        let around = 2 * harmonics + 6;
        let mut gram = Matrix6::zeros();
        let mut products = vec![Vector6::zeros(); self.terms.len()];
        for (zeta, weight) in gauss_legendre(degree + 3) {
            let [radius, z] = self.surface.on_generator(zeta);
            for step in 0..around {
                let angle = TAU * step as f64 / around as f64;
                let rigid = rigid_motions([radius * angle.cos(), radius * angle.sin(), z]);
                gram += Matrix6::from_fn(|a, b| weight * radius * dot(rigid[a], rigid[b]));
                for (sum, term) in products.iter_mut().zip(&self.terms) {
                    let value = term.displacement(angle, zeta);
                    *sum += Vector6::from_fn(|mode, _| weight * radius * dot(rigid[mode], value));
                }
            }
        }
        let factor = gram.cholesky()?;
        Some(products.into_iter().map(|product| factor.solve(&product).into()).collect())
    }
}

impl Term {
    /// Returns true for an axial displacement.
    pub fn is_axial(&self) -> bool {
        self.component == Component::Axial
    }

    /// Returns the displacement along the axes at an angle and a coordinate along the generator, -1
    /// to 1.
    fn displacement(&self, angle: f64, zeta: f64) -> [f64; 3] {
        let (mut previous, mut value) = (0.0, 1.0);
        for degree in 0..self.degree {
            let k = f64::from(degree);
            (previous, value) = (value, ((2.0 * k + 1.0) * zeta * value - k * previous) / (k + 1.0));
        }
        let phase = f64::from(self.harmonic) * angle;
        let value = value * if self.sine { phase.sin() } else { phase.cos() };
        let (sin, cos) = angle.sin_cos();
        match self.component {
            Component::Radial => [value * cos, value * sin, 0.0],
            Component::Tangential => [-value * sin, value * cos, 0.0],
            Component::Axial => [0.0, 0.0, value],
        }
    }
}

/// Returns the displacements of unit translations along the axes and unit rotations about them, at
/// a point relative to the centre.
pub(super) fn rigid_motions([x, y, z]: [f64; 3]) -> [[f64; 3]; 6] {
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]]
}
