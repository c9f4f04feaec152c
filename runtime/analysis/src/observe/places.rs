//! Where maxima are, as numbers that a program can put out.

use super::{Contact, Equilibrium, MaxRootCompression, MaxRootStress, Needs, Observable, Quantity};
use calyx_contact::zone::Zone;
use calyx_model::ids::BodyId;
use calyx_model::observed::{Observed, Place};

/// A maximum over places of a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Maximum {
    /// Of tension in its fillets, see [`MaxRootStress`].
    RootStress,
    /// Of compression in its fillets, see [`MaxRootCompression`].
    RootCompression,
    /// Of pressure on its flanks, away from edges.
    ContactPressure,
    /// Of pressure on its edges and beside them.
    EdgePressure,
    /// Of force by length of a line of contact.
    LineLoad,
}

/// A coordinate of a place on a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coordinate {
    /// Counted counter-clockwise from 0; -1 where there is no maximum.
    Tooth,
    /// rad; 0 where there is no involute.
    RollAngle,
    /// m
    Radius,
    /// Along the axis from the middle of the face, m; 0 in a plane model.
    Axial,
}

/// A coordinate of the place on a body at which a maximum is; 0, and no tooth, where nothing is loaded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaceOf {
    /// Of the place.
    pub body: BodyId,
    /// What is largest there.
    pub maximum: Maximum,
    /// What of the place is told.
    pub coordinate: Coordinate,
}

impl Observable for PlaceOf {
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
            Maximum::ContactPressure | Maximum::EdgePressure | Maximum::LineLoad => Needs::Forces,
        }
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let place = self.maximum.place(at, self.body);
        let of = |place: &Place| match self.coordinate {
            Coordinate::Tooth => f64::from(place.tooth),
            Coordinate::RollAngle => place.roll_angle.unwrap_or(0.0),
            Coordinate::Radius => place.radius,
            Coordinate::Axial => place.axial.unwrap_or(0.0),
        };
        let none = if self.coordinate == Coordinate::Tooth { -1.0 } else { 0.0 };
        Observed { value: place.as_ref().map_or(none, of), least: None, place }
    }

    fn stresses_of(&self) -> Option<BodyId> {
        matches!(self.maximum, Maximum::RootStress | Maximum::RootCompression).then_some(self.body)
    }

    fn frame_of(&self) -> Option<BodyId> {
        Some(self.body)
    }
}

impl Maximum {
    /// Its place on a body; `None` where nothing is loaded.
    fn place(self, at: &Equilibrium<'_>, body: BodyId) -> Option<Place> {
        let pressure =
            |zone| largest(at.contacts_on(body).filter_map(|(contact, side)| contact.peak(side, zone)));
        let lines = |(contact, side): (Contact<'_>, usize)| {
            let slices = contact.slices().into_iter();
            slices.map(move |slice| (slice.line_load(), slice.places[side].clone()))
        };
        match self {
            Maximum::RootStress => MaxRootStress(body).value(at).place,
            Maximum::RootCompression => MaxRootCompression(body).value(at).place,
            Maximum::ContactPressure => pressure(Zone::Flank),
            Maximum::EdgePressure => pressure(Zone::Edge),
            Maximum::LineLoad => largest(at.contacts_on(body).flat_map(lines)),
        }
    }
}

fn largest(all: impl Iterator<Item = (f64, Option<Place>)>) -> Option<Place> {
    all.filter(|(value, _)| *value > 0.0).reduce(|a, b| if b.0 > a.0 { b } else { a })?.1
}
