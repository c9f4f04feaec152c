//! Observables of lubricated contact: rolling velocities, friction, flash temperature and film
//! thickness along the contact lines.
//!
//! See `docs/theory/tribology.md`.

use super::loads::pairs_teeth;
use super::sliding::{size, transmitted_power};
use super::{Contact, Equilibrium, Needs, Observable, Quantity, Slice};
use calyx_contact::{grid, solid};
use calyx_model::ids::PairId;
use calyx_model::lubrication::{Lubrication, RollingContact};
use calyx_model::observed::Observed;
use calyx_solve::step::ContactGrid;
use calyx_solve::system::Bodies;
use calyx_structure::surface::Surface;
use std::f64::consts::PI;
use std::sync::Arc;

/// Entrainment velocity of a tooth pair, numbered as by [`super::PairLoad`], m/s: half the sum of
/// the velocities with which both flanks move through the contact; 0 without load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EntrainmentVelocity(pub PairId, pub i32);

impl Observable for EntrainmentVelocity {
    fn quantity(&self) -> Quantity {
        Quantity::passing("entrainment_velocity", "m/s")
    }

    fn needs(&self) -> Needs {
        Needs::Motions
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let velocity = |(contact, (point, location)): (Contact<'_>, ([f64; 3], _))| {
            let [first, second] = contact.rolling(point);
            Observed { value: 0.5 * (first + second).abs(), least: None, location }
        };
        let points = pairs_teeth(at, self.0, self.1)
            .flat_map(|contact| contact.sliding_points(0).into_iter().map(move |point| (contact, point)));
        points.map(velocity).reduce(largest).unwrap_or(Observed::number(0.0))
    }

    fn bounds(&self) -> [f64; 2] {
        [0.0, f64::INFINITY]
    }

    fn pair_of(&self) -> Option<PairId> {
        Some(self.0)
    }
}

/// Quantity of a point of a lubricated contact line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LocalQuantity {
    /// Frictional power per length of the contact line, W/m.
    FrictionPower,
    /// Flash temperature (Blok), K.
    FlashTemperature,
    /// Contact temperature, degrees Celsius.
    ContactTemperature,
    /// Film thickness (Dowson and Higginson, ISO/TS 6336-22), m.
    FilmThickness,
    /// Film thickness over mean roughness.
    SpecificFilmThickness,
}

impl LocalQuantity {
    /// Returns the quantity at a point of contact, SI (temperatures in degrees Celsius).
    pub fn at(self, lubrication: &Lubrication, contact: &RollingContact) -> f64 {
        match self {
            LocalQuantity::FrictionPower => lubrication.friction_power(contact),
            LocalQuantity::FlashTemperature => lubrication.flash_temperature(contact),
            LocalQuantity::ContactTemperature => lubrication.contact_temperature(contact),
            LocalQuantity::FilmThickness => lubrication.film_thickness(contact),
            LocalQuantity::SpecificFilmThickness => lubrication.specific_film_thickness(contact),
        }
    }

    pub(super) fn is_least(self) -> bool {
        matches!(self, LocalQuantity::FilmThickness | LocalQuantity::SpecificFilmThickness)
    }
}

/// Extreme of a local quantity over the loaded points of a lubricated pair: the largest power and
/// temperature, the least film thickness. Without load 0, or the bulk temperature. NaN if the pair
/// has no lubrication.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LubricatedExtreme {
    /// The pair.
    pub pair: PairId,
    /// Local quantity.
    pub quantity: LocalQuantity,
}

impl Observable for LubricatedExtreme {
    fn quantity(&self) -> Quantity {
        match self.quantity {
            LocalQuantity::FrictionPower => Quantity::repeating("max_friction_power_per_length", "W/m"),
            LocalQuantity::FlashTemperature => Quantity::repeating("max_flash_temperature", "K"),
            LocalQuantity::ContactTemperature => Quantity::repeating("max_contact_temperature", "1"),
            LocalQuantity::FilmThickness => Quantity::repeating("min_film_thickness", "m"),
            LocalQuantity::SpecificFilmThickness => Quantity::repeating("min_specific_film_thickness", "1"),
        }
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let Some(lubrication) = lubrication(at, self.pair) else { return Observed::number(f64::NAN) };
        let local = |(slice, contact): (Slice, RollingContact)| {
            let [location, _] = slice.locations;
            Observed { value: self.quantity.at(lubrication, &contact), least: None, location }
        };
        let points = at.contacts(self.pair).flat_map(|contact| contact.rolling_contacts()).map(local);
        let none = match self.quantity {
            LocalQuantity::ContactTemperature => lubrication.bulk_temperature,
            _ => 0.0,
        };
        let extreme = match self.quantity.is_least() {
            true => points.reduce(|one, other| if other.value < one.value { other } else { one }),
            false => points.reduce(largest),
        };
        extreme.unwrap_or(Observed::number(none))
    }

    fn pair_of(&self) -> Option<PairId> {
        Some(self.pair)
    }
}

/// Frictional power loss of a lubricated mesh with its local coefficient of friction, W, as
/// [`super::FrictionLoss`]. NaN without lubrication.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LubricatedLoss(pub PairId);

impl Observable for LubricatedLoss {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("friction_loss", "W")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let Some(lubrication) = lubrication(at, self.0) else { return Observed::number(f64::NAN) };
        let loss = |(slice, contact): (Slice, RollingContact)| {
            lubrication.friction(&contact) * slice.force * contact.sliding
        };
        let points = at.mesh_contacts(self.0).flat_map(|contact| contact.rolling_contacts());
        Observed::number(points.map(loss).fold(0.0, |sum, loss| sum + loss))
    }

    fn pair_of(&self) -> Option<PairId> {
        Some(self.0)
    }
}

/// Efficiency of a lubricated mesh with its local coefficient of friction; 1 without motion, NaN
/// without lubrication.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LubricatedEfficiency(pub PairId);

impl Observable for LubricatedEfficiency {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("efficiency", "1")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let power = transmitted_power(at, self.0);
        let loss = LubricatedLoss(self.0).value(at).value;
        Observed::number(if power > 0.0 || loss.is_nan() { 1.0 - loss / power } else { 1.0 })
    }

    fn pair_of(&self) -> Option<PairId> {
        Some(self.0)
    }
}

fn largest(one: Observed, other: Observed) -> Observed {
    if other.value > one.value { other } else { one }
}

fn lubrication<'a>(at: &Equilibrium<'a>, pair: PairId) -> Option<&'a Lubrication> {
    at.scene().pairs.get(pair.0)?.lubrication.as_ref()
}

impl Contact<'_> {
    /// Returns the lubrication of the pair.
    pub fn lubrication(&self) -> Option<&Lubrication> {
        self.at.scene().pairs[self.patch.pair].lubrication.as_ref()
    }

    /// Returns the velocities with which both surfaces move through the contact at a point of the
    /// patch (ground coordinates, m), across the contact line, m/s. They are relative to the line
    /// of centres, along which the contact of involutes moves in the direction of the normal.
    pub fn rolling(&self, point: [f64; 3]) -> [f64; 2] {
        self.velocities(point, self.across())
    }

    /// Returns the components of the velocities of both surfaces in a direction, m/s, as
    /// [`Contact::rolling`].
    fn velocities(&self, point: [f64; 3], direction: [f64; 3]) -> [f64; 2] {
        let line = self.at.system.carrier_velocity(self.patch.pair, self.at.time(), point);
        self.bodies().map(|body| {
            let velocity = self.at.velocity(body, point);
            (0..3).map(|k| (velocity[k] - line[k]) * direction[k]).sum()
        })
    }

    /// Returns the loaded slices with their rolling contacts; none of rigid surfaces, and none
    /// where surfaces are not convex relative to each other.
    pub fn rolling_contacts(&self) -> Vec<(Slice, RollingContact)> {
        self.rolling_states().into_iter().filter_map(|(slice, contact)| Some((slice, contact?))).collect()
    }

    /// Returns all slices, with the rolling contacts of the loaded ones.
    pub(super) fn rolling_states(&self) -> Vec<(Slice, Option<RollingContact>)> {
        let modulus = self.contact_modulus();
        let placed = self.placed();
        let slices = self.slices();
        let length = slices.iter().filter(|slice| slice.force > 0.0).map(|slice| slice.length).sum();
        let state = |(index, slice): (usize, Slice)| {
            let loaded = slice.force > 0.0 && modulus.is_finite();
            let curvature =
                loaded.then(|| self.relative_curvature(modulus, placed.as_ref(), index, slice.point));
            let convex = curvature.flatten().filter(|curvature| *curvature > 0.0 && curvature.is_finite());
            let contact = convex.map(|curvature| RollingContact {
                line_load: slice.line_load(),
                curvature,
                modulus,
                rolling: self.rolling(slice.point),
                along: self.velocities(slice.point, self.along()),
                sliding: size(self.sliding(slice.point)),
                length,
            });
            (slice, contact)
        };
        slices.into_iter().enumerate().map(state).collect()
    }

    /// Returns the direction in the tangent plane across the contact line.
    fn across(&self) -> [f64; 3] {
        match &self.patch.grid {
            ContactGrid::Plane { frame, .. } => [frame.tangent[0], frame.tangent[1], 0.0],
            ContactGrid::Solid(grid) => grid.frame.across,
        }
    }

    /// Returns the direction along the contact line.
    fn along(&self) -> [f64; 3] {
        match &self.patch.grid {
            ContactGrid::Plane { .. } => [0.0, 0.0, 1.0],
            ContactGrid::Solid(grid) => grid.frame.along,
        }
    }

    /// Returns the contact modulus, Pa; infinite for rigid bodies.
    fn contact_modulus(&self) -> f64 {
        let [first, second] = self.bodies().map(|body| body.0);
        match &self.at.system.bodies {
            Bodies::Plane(bodies) => match (&bodies.structures[first], &bodies.structures[second]) {
                (Some(first), Some(second)) => grid::contact_modulus(first.as_ref(), second.as_ref()),
                _ => f64::INFINITY,
            },
            Bodies::Solid(bodies) => match (&bodies.structures[first], &bodies.structures[second]) {
                (Some(first), Some(second)) => solid::contact_modulus(first.as_ref(), second.as_ref()),
                _ => f64::INFINITY,
            },
        }
    }

    /// Returns the relative curvature of the flanks across the contact line at a point of a slice,
    /// 1/m.
    fn relative_curvature(
        &self,
        modulus: f64,
        placed: Option<&[(Arc<dyn Surface>, solid::Pose); 2]>,
        slice: usize,
        point: [f64; 3],
    ) -> Option<f64> {
        let grid = match &self.patch.grid {
            // The grid has the half-width of a line load of 1 N/m (Johnson, eq. 4.43).
            ContactGrid::Plane { unit_half_width, .. } => {
                return Some(4.0 / (PI * modulus * unit_half_width.powi(2)));
            }
            ContactGrid::Solid(grid) => grid,
        };
        let placed = placed?
            .each_ref()
            .map(|(surface, pose)| solid::PlacedSurface { surface: surface.as_ref(), pose: *pose });
        let places = grid.slices.get(slice)?.places;
        Some(solid::relative_curvature_along(&placed, places, point, grid.frame.across))
    }

    /// Returns the surfaces of a three-dimensional patch with the poses of their teeth.
    fn placed(&self) -> Option<[(Arc<dyn Surface>, solid::Pose); 2]> {
        let (system, step) = (self.at.system, self.at.step);
        let Bodies::Solid(bodies) = &system.bodies else { return None };
        let placed = |side: usize| {
            let (body, tooth) = (self.bodies()[side].0, self.patch.teeth[side]);
            let structure = bodies.structures[body].as_ref()?;
            let angle = system.scene.bodies[body].phase
                + structure.tooth_angle(tooth)
                + system.pitch_error(body, tooth);
            let pose = system.displaced_pose(body, step.time, &step.start).ok()?.rotated_first(angle);
            Some((structure.surface(self.patch.surfaces[side]), pose))
        };
        Some([placed(0)?, placed(1)?])
    }
}
