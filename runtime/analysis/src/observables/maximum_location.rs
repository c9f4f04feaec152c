//! Observables of the locations of maxima and minima.

use super::sliding::size;
use super::{
    Contact, Equilibrium, LocalQuantity, MaxRootCompression, MaxRootStress, Needs, Observable, Quantity,
};
use calyx_contact::zone::Zone;
use calyx_model::ids::BodyId;
use calyx_model::observed::{Location, Observed};

/// Maximum over points of a body, or minimum of a film thickness.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Maximum {
    /// Largest tension in its fillets, see [`MaxRootStress`].
    RootStress,
    /// Largest compression in its fillets, see [`MaxRootCompression`].
    RootCompression,
    /// Largest pressure on its flanks, away from edges.
    ContactPressure,
    /// Largest pressure on its edges and next to them.
    EdgePressure,
    /// Largest force per length of contact line.
    LineLoad,
    /// Largest magnitude of the sliding velocity of its loaded flanks.
    SlidingVelocity,
    /// Extreme of a local quantity on its lubricated flanks.
    Lubricated(LocalQuantity),
}

/// Coordinate of a location on a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coordinate {
    /// Number of the tooth, counter-clockwise from 0; -1 without a maximum.
    Tooth,
    /// Roll angle, rad; 0 if the profile has no involute there.
    RollAngle,
    /// Radius, m.
    Radius,
    /// Axial coordinate from mid-face, m; 0 in a plane model.
    Axial,
}

/// Coordinate of the location of a maximum on a body; 0, and no tooth, without load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaximumLocation {
    /// Body of the location.
    pub body: BodyId,
    /// Quantity of the maximum.
    pub maximum: Maximum,
    /// Reported coordinate.
    pub coordinate: Coordinate,
}

impl Observable for MaximumLocation {
    fn quantity(&self) -> Quantity {
        match self.coordinate {
            Coordinate::Tooth => Quantity::passing("tooth_at", "1"),
            Coordinate::RollAngle => Quantity::repeating("roll_angle_at", "rad"),
            Coordinate::Radius => Quantity::repeating("radius_at", "m"),
            Coordinate::Axial => Quantity::repeating("axial_at", "m"),
        }
    }

    fn needs(&self) -> Needs {
        match self.maximum {
            Maximum::RootStress => Needs::RootStress,
            Maximum::RootCompression => Needs::Stresses,
            Maximum::SlidingVelocity => Needs::Motions,
            _ => Needs::Forces,
        }
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let location = self.maximum.location(at, self.body);
        let of = |location: &Location| match self.coordinate {
            Coordinate::Tooth => f64::from(location.tooth),
            Coordinate::RollAngle => location.roll_angle.unwrap_or(0.0),
            Coordinate::Radius => location.radius,
            Coordinate::Axial => location.axial.unwrap_or(0.0),
        };
        let none = if self.coordinate == Coordinate::Tooth { -1.0 } else { 0.0 };
        Observed { value: location.as_ref().map_or(none, of), least: None, location }
    }

    fn stresses_of(&self) -> Option<BodyId> {
        matches!(self.maximum, Maximum::RootStress | Maximum::RootCompression).then_some(self.body)
    }

    fn frame_of(&self) -> Option<BodyId> {
        Some(self.body)
    }
}

impl Maximum {
    /// Returns the location of the maximum on a body; `None` without load.
    fn location(self, at: &Equilibrium<'_>, body: BodyId) -> Option<Location> {
        let pressure =
            |zone| largest(at.contacts_on(body).filter_map(|(contact, side)| contact.peak(side, zone)));
        let lines = |(contact, side): (Contact<'_>, usize)| {
            let slices = contact.slices().into_iter();
            slices.map(move |slice| (slice.line_load(), slice.locations[side].clone()))
        };
        match self {
            Maximum::RootStress => MaxRootStress(body).value(at).location,
            Maximum::RootCompression => MaxRootCompression(body).value(at).location,
            Maximum::ContactPressure => pressure(Zone::Flank),
            Maximum::EdgePressure => pressure(Zone::Edge),
            Maximum::LineLoad => largest(at.contacts_on(body).flat_map(lines)),
            Maximum::SlidingVelocity => largest(at.contacts_on(body).flat_map(|(contact, side)| {
                let points = contact.sliding_points(side).into_iter();
                points.map(move |(point, location)| (size(contact.sliding(point)), location))
            })),
            Maximum::Lubricated(quantity) => {
                let points = at.contacts_on(body).flat_map(|(contact, side)| local(&contact, side, quantity));
                let better =
                    |one: f64, other: f64| if quantity.is_least() { other < one } else { other > one };
                points.reduce(|one, other| if better(one.0, other.0) { other } else { one })?.1
            }
        }
    }
}

/// Returns a quantity of the loaded points of a lubricated contact, with their locations on the
/// body of a side.
fn local(contact: &Contact<'_>, side: usize, quantity: LocalQuantity) -> Vec<(f64, Option<Location>)> {
    let Some(lubrication) = contact.lubrication() else { return Vec::new() };
    let points = contact.rolling_contacts().into_iter();
    points
        .map(|(slice, rolling)| (quantity.at(lubrication, &rolling), slice.locations[side].clone()))
        .collect()
}

fn largest(all: impl Iterator<Item = (f64, Option<Location>)>) -> Option<Location> {
    all.filter(|(value, _)| *value > 0.0).reduce(|a, b| if b.0 > a.0 { b } else { a })?.1
}
