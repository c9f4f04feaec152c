//! Lumped-parameter model of a planetary set of a scene: the model of Lin and Parker with the
//! masses and bearings of the scene, and with the mesh stiffnesses at a solved position.

use crate::lumped_planetary::{LumpedMember, LumpedMesh, LumpedPlanetary};
use calyx_runtime::bearing::Support;
use calyx_runtime::observables::{Equilibrium, MeshStiffness, Observable, Quantity};
use calyx_runtime::results::Observed;
use calyx_runtime::scene::{BodyId, Component, PairId, Scene};

/// Members of a planetary set. All planets are equal, and so are their meshes, whose mean stiffness
/// is used.
#[derive(Clone, Debug, PartialEq)]
pub struct LumpedSet {
    /// Sun gear.
    pub sun: BodyId,
    /// Ring gear.
    pub ring: BodyId,
    /// Carrier of the planets.
    pub carrier: BodyId,
    /// Planets in the order of their meshes.
    pub planets: Vec<BodyId>,
    /// Meshes of the sun with each planet, the sun first.
    pub sun_meshes: Vec<PairId>,
    /// Meshes of each planet with the ring, the planet first.
    pub ring_meshes: Vec<PairId>,
}

impl LumpedSet {
    /// Number of modes of the model: the free degrees of freedom of plane motion of all members.
    /// Planets are equal, so the first one stands for all.
    pub fn mode_count(&self, scene: &Scene) -> usize {
        let free = |body: BodyId| {
            let of = scene.bodies.get(body.0);
            PLANE_DOFS.iter().filter(|&&free| of.is_some_and(|of| of.free[free as usize])).count()
        };
        let planets = self.planets.first().map_or(0, |&planet| self.planets.len() * free(planet));
        free(self.sun) + free(self.ring) + free(self.carrier) + planets
    }

    /// Returns the model at a solved position; `None` if a pair is not a gear mesh, or there is no
    /// planet.
    pub fn at(&self, at: &Equilibrium<'_>) -> Option<LumpedPlanetary> {
        let scene = at.scene();
        let stiffness = |pairs: &[PairId]| {
            let all: f64 = pairs.iter().map(|&pair| MeshStiffness(pair).value(at).value).sum();
            all / pairs.len() as f64
        };
        let [sun_radius, planet_radius] = at.mesh(*self.sun_meshes.first()?)?.0.base_radii;
        let [_, ring_radius] = at.mesh(*self.ring_meshes.first()?)?.0.base_radii;
        let planet = *self.planets.first()?;
        let centre = at.origin(self.carrier);
        let from_centre = |body: BodyId| [0, 1].map(|axis: usize| at.origin(body)[axis] - centre[axis]);
        let [x, y] = from_centre(planet);
        let distance = x.hypot(y);
        let member = |body: BodyId, radius: f64| {
            let of = scene.bodies.get(body.0)?;
            let fixed = PLANE_DOFS.map(|free| !of.free[free as usize]);
            let (inertia, [support_stiffness, torsional_stiffness]) = (of.inertia(), springs(at, body, None));
            let (mass, inertia) = (inertia.mass, inertia.polar());
            Some(LumpedMember { mass, inertia, radius, support_stiffness, torsional_stiffness, fixed })
        };
        let member_without_mass = |body: BodyId, radius: f64| {
            // Fully constrained members may have zero mass.
            let member = member(body, radius)?;
            let some = |value: f64| if member.fixed == [true; 3] && value == 0.0 { 1.0 } else { value };
            Some(LumpedMember { mass: some(member.mass), inertia: some(member.inertia), ..member })
        };
        let angle = |&body: &BodyId| {
            let [x, y] = from_centre(body);
            y.atan2(x)
        };
        Some(LumpedPlanetary {
            carrier: member_without_mass(self.carrier, distance)?,
            ring: member_without_mass(self.ring, ring_radius)?,
            sun: member_without_mass(self.sun, sun_radius)?,
            planet: member(planet, planet_radius)?,
            planet_bearing_stiffness: springs(at, planet, Some(self.carrier))[0],
            planet_angles: self.planets.iter().map(angle).collect(),
            sun_mesh: LumpedMesh {
                stiffness: stiffness(&self.sun_meshes),
                pressure_angle: ((sun_radius + planet_radius) / distance).acos(),
            },
            ring_mesh: LumpedMesh {
                stiffness: stiffness(&self.ring_meshes),
                pressure_angle: ((ring_radius - planet_radius) / distance).acos(),
            },
        })
    }
}

/// Degrees of freedom of a member.
const PLANE_DOFS: [Component; 3] = [Component::Ux, Component::Uy, Component::ThetaZ];

/// Radial (N/m) and torsional (N m/rad) stiffness of the bearings of a body, to ground or to
/// another body.
fn springs(at: &Equilibrium<'_>, body: BodyId, on: Option<BodyId>) -> [f64; 2] {
    let on = on.map_or(Support::Ground, Support::Body);
    let own = at.scene().bearings.iter().filter(|bearing| bearing.body == body && bearing.to == on);
    own.fold([0.0; 2], |[radial, torsional], bearing| {
        let k = &bearing.stiffness;
        [radial + 0.5 * (k[0][0] + k[1][1]), torsional + k[5][5]]
    })
}

/// Natural frequency of the lumped-parameter model of a planetary set, Hz.
#[derive(Clone, Debug, PartialEq)]
pub struct LumpedFrequency {
    /// Index of the mode in order of ascending frequency, from 0.
    pub mode: usize,
    /// The planetary set.
    pub set: LumpedSet,
}

impl Observable for LumpedFrequency {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("lumped_natural_frequency", "Hz")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let modes = self.set.at(at).and_then(|set| set.modes().ok());
        let found = modes.and_then(|modes| Some(modes.get(self.mode)?.frequency));
        Observed::number(found.unwrap_or(f64::NAN))
    }
}
