//! Coordinate systems and grid points: CORD1R/C/S, CORD2R/C/S, GRID, GRDSET.
//!
//! Source: NASTRAN Quick Reference Guide, entries of these names. Angles are in degrees.

use super::super::geometry::{Vector, add, cross, dot, norm, scale, sub, unit};
use super::super::origin::Problem;
use super::super::source::Place;
use super::card::Result;
use super::deck::Card;
use crate::model::{Components, Node};
use std::collections::{BTreeMap, HashMap};

/// Deepest chain of systems that refer to each other.
const DEEPEST: usize = 200;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind {
    Rectangular,
    Cylindrical,
    Spherical,
}

/// Coordinate system in basic coordinates.
#[derive(Clone, Copy, Debug)]
pub(super) struct System {
    kind: Kind,
    origin: Vector,
    /// Unit vectors.
    axes: [Vector; 3],
}

/// Basic system.
const BASIC: System = System {
    kind: Kind::Rectangular,
    origin: [0.0; 3],
    axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
};

impl System {
    /// Position in basic coordinates of a point with these coordinates.
    pub fn position(&self, x: Vector) -> Vector {
        let local = match self.kind {
            Kind::Rectangular => x,
            Kind::Cylindrical => {
                let (sin, cos) = x[1].to_radians().sin_cos();
                [x[0] * cos, x[0] * sin, x[2]]
            }
            Kind::Spherical => {
                let (sin, cos) = x[1].to_radians().sin_cos();
                let (sin_around, cos_around) = x[2].to_radians().sin_cos();
                [x[0] * sin * cos_around, x[0] * sin * sin_around, x[0] * cos]
            }
        };
        add(self.origin, self.turned(local))
    }

    /// Vector in basic coordinates of one along the axes.
    fn turned(&self, local: Vector) -> Vector {
        (0..3).fold([0.0; 3], |sum, i| add(sum, scale(self.axes[i], local[i])))
    }

    /// Unit vectors of the system at a position in basic coordinates. On the axis of a cylindrical
    /// or spherical system, the angle about the axis is zero.
    pub fn axes_at(&self, position: Vector) -> [Vector; 3] {
        if self.kind == Kind::Rectangular {
            return self.axes;
        }
        let offset = sub(position, self.origin);
        let local = self.axes.map(|axis| dot(axis, offset));
        let radius = local[0].hypot(local[1]);
        let on_axis = radius <= 1e-9 * norm(offset).max(f64::MIN_POSITIVE);
        let (cos, sin) = if on_axis { (1.0, 0.0) } else { (local[0] / radius, local[1] / radius) };
        let around = self.turned([-sin, cos, 0.0]);
        match self.kind {
            Kind::Spherical => {
                let distance = norm(local);
                let (up, out) =
                    if distance > 0.0 { (local[2] / distance, radius / distance) } else { (1.0, 0.0) };
                [self.turned([out * cos, out * sin, up]), self.turned([up * cos, up * sin, -out]), around]
            }
            _ => [self.turned([cos, sin, 0.0]), around, self.axes[2]],
        }
    }

    /// Vector in basic coordinates of one with these components at a position.
    pub fn vector(&self, components: Vector, position: Vector) -> Vector {
        let axes = self.axes_at(position);
        (0..3).fold([0.0; 3], |sum, i| add(sum, scale(axes[i], components[i])))
    }
}

/// Definition of a coordinate system by three points: origin, point on the z axis, point in the x-z
/// plane.
enum Points {
    /// Coordinates in another system.
    Coordinates(u64, [Vector; 3]),
    /// Grid points.
    Grids([u64; 3]),
}

struct Definition {
    kind: Kind,
    points: Points,
    name: String,
    place: Place,
    fields: Vec<String>,
}

struct Grid {
    system: u64,
    coordinates: Vector,
    displacement_system: u64,
    place: Place,
    fields: Vec<String>,
}

/// Coordinate systems and grid points of a deck.
#[derive(Default)]
pub(super) struct Geometry {
    definitions: HashMap<u64, Definition>,
    grids: BTreeMap<u64, Grid>,
    resolved: HashMap<u64, System>,
    positions: HashMap<u64, Vector>,
    /// Permanent single-point constraints of grid points.
    pub fixed: Vec<(u64, Components, Place)>,
    /// Accepts grid points of fluids and of superelements, which a structure does not have.
    accepts_all_points: bool,
}

impl Geometry {
    pub fn read(cards: &[Card]) -> Result<Self> {
        Self::default().with(cards)
    }

    /// Reads the geometry of a deck that may have grid points of fluids and of superelements.
    pub fn of_mesh(cards: &[Card]) -> Result<Self> {
        Self { accepts_all_points: true, ..Self::default() }.with(cards)
    }

    fn with(mut self, cards: &[Card]) -> Result<Self> {
        let geometry = &mut self;
        let defaults = cards.iter().filter(|card| card.name == "GRDSET").collect::<Vec<_>>();
        if let [_, second, ..] = defaults[..] {
            return Err(second.problem("the deck has a second GRDSET", "keep one GRDSET"));
        }
        for card in cards {
            match card.name.as_str() {
                "GRID" => geometry.grid(card, defaults.first().copied())?,
                "CORD1R" | "CORD1C" | "CORD1S" | "CORD2R" | "CORD2C" | "CORD2S" => geometry.define(card)?,
                _ => {}
            }
        }
        let ids: Vec<u64> = geometry.definitions.keys().copied().collect();
        let mut ids: Vec<(Place, u64)> =
            ids.into_iter().map(|id| (geometry.definitions[&id].place, id)).collect();
        ids.sort_by_key(|(place, _)| (place.file, place.line));
        for (place, id) in ids {
            geometry.resolve(id, "", place, &mut Vec::new())?;
        }
        Ok(self)
    }

    fn grid(&mut self, card: &Card, defaults: Option<&Card>) -> Result<()> {
        let id = card.id(1, "ID")?;
        if let Some(known) = self.grids.get(&id) {
            if known.fields == card.fields {
                return Ok(());
            }
            return Err(duplicate(card, known.place));
        }
        // The fields of GRDSET are those of GRID: CP is 2, CD 6, PS 7.
        let source = |field: usize| match defaults {
            Some(defaults) if card.is_blank(field) => defaults,
            _ => card,
        };
        let system = source(2).system(2, "CP")?;
        // Grid points of fluids have the displacement system -1.
        let is_fluid = self.accepts_all_points && source(6).text(6) == "-1";
        let displacement_system = if is_fluid { 0 } else { source(6).system(6, "CD")? };
        let fixed = source(7).optional_components(7, "PS")?;
        if !self.accepts_all_points {
            card.unsupported([8], "SEID")?;
        }
        if fixed.contains(&true) {
            self.fixed.push((id, fixed, card.place));
        }
        let coordinates = card.vector(3, "X1, X2, X3")?;
        let grid =
            Grid { system, coordinates, displacement_system, place: card.place, fields: card.fields.clone() };
        self.grids.insert(id, grid);
        Ok(())
    }

    fn define(&mut self, card: &Card) -> Result<()> {
        let kind = match card.name.as_bytes().last() {
            Some(b'C') => Kind::Cylindrical,
            Some(b'S') => Kind::Spherical,
            _ => Kind::Rectangular,
        };
        let mut add = |id: u64, points: Points, fields: Vec<String>| match self.definitions.get(&id) {
            Some(known) if known.fields == fields && known.kind == kind => Ok(()),
            Some(known) => Err(duplicate(card, known.place)),
            None => {
                let name = format!("{} {id}", card.name);
                self.definitions.insert(id, Definition { kind, points, name, place: card.place, fields });
                Ok(())
            }
        };
        if card.name.starts_with("CORD2") {
            let points =
                [card.vector(3, "A1, A2, A3")?, card.vector(6, "B1, B2, B3")?, card.vector(9, "C1, C2, C3")?];
            let points = Points::Coordinates(card.system(2, "RID")?, points);
            return add(card.id(1, "CID")?, points, card.fields.clone());
        }
        for first in [1, 5] {
            if first == 1 || !card.is_blank(first) {
                let grids = [card.id(first + 1, "G1")?, card.id(first + 2, "G2")?, card.id(first + 3, "G3")?];
                let fields = (first..first + 4).map(|field| card.text(field).to_owned()).collect();
                add(card.id(first, "CID")?, Points::Grids(grids), fields)?;
            }
        }
        Ok(())
    }

    /// Returns a coordinate system. `owner` is the subject of the error message.
    pub fn system(&mut self, id: u64, owner: &str, place: Place) -> Result<System> {
        self.resolve(id, owner, place, &mut Vec::new())
    }

    fn resolve(&mut self, id: u64, owner: &str, place: Place, path: &mut Vec<u64>) -> Result<System> {
        if id == 0 {
            return Ok(BASIC);
        }
        if let Some(known) = self.resolved.get(&id) {
            return Ok(*known);
        }
        let Some(definition) = self.definitions.get(&id) else {
            return Err(Problem::new(
                place,
                format!("{owner} refers to coordinate system {id}, which is not defined"),
                format!("add the CORD card of coordinate system {id}, or correct the reference"),
            ));
        };
        let (name, at, kind) = (definition.name.clone(), definition.place, definition.kind);
        if path.contains(&id) {
            let message = format!("{name} is defined in terms of itself");
            return Err(Problem::new(at, message, "define one system of the cycle in basic coordinates"));
        }
        if path.len() >= DEEPEST {
            let message = format!("{name}: systems are nested more than {DEEPEST} deep");
            return Err(Problem::new(at, message, "define the systems in basic coordinates"));
        }
        path.push(id);
        let points = match definition.points {
            Points::Coordinates(reference, points) => {
                let reference = self.resolve(reference, &name, at, path)?;
                points.map(|point| reference.position(point))
            }
            Points::Grids(grids) => {
                let mut points = [[0.0; 3]; 3];
                for (point, grid) in points.iter_mut().zip(grids) {
                    *point = self.resolve_grid(grid, &name, at, path)?;
                }
                points
            }
        };
        path.pop();
        let [origin, on_z, in_plane] = points;
        let z = unit(sub(on_z, origin));
        let y = z.and_then(|z| {
            let across = cross(z, sub(in_plane, origin));
            let flat = norm(across) <= 1e-9 * norm(sub(in_plane, origin));
            if flat { None } else { unit(across) }
        });
        let (Some(z), Some(y)) = (z, y) else {
            let message = format!("{name}: its three points coincide or lie on a line");
            return Err(Problem::new(at, message, "place the third point off the z axis"));
        };
        let system = System { kind, origin, axes: [cross(y, z), y, z] };
        self.resolved.insert(id, system);
        Ok(system)
    }

    fn resolve_grid(&mut self, id: u64, owner: &str, place: Place, path: &mut Vec<u64>) -> Result<Vector> {
        if let Some(known) = self.positions.get(&id) {
            return Ok(*known);
        }
        let Some(grid) = self.grids.get(&id) else {
            return Err(Problem::new(
                place,
                format!("{owner} refers to GRID {id}, which is not defined"),
                format!("define GRID {id}, or correct the reference"),
            ));
        };
        let (system, coordinates, at) = (grid.system, grid.coordinates, grid.place);
        let system = self.resolve(system, &format!("GRID {id}"), at, path)?;
        let position = system.position(coordinates);
        self.positions.insert(id, position);
        Ok(position)
    }

    /// Returns the nodes of the model.
    pub fn nodes(&mut self) -> Result<Vec<Node>> {
        let mut nodes = Vec::with_capacity(self.grids.len());
        let grids: Vec<(u64, u64, Place)> =
            self.grids.iter().map(|(id, grid)| (*id, grid.displacement_system, grid.place)).collect();
        for (id, system, place) in grids {
            let owner = format!("GRID {id}");
            let position = self.resolve_grid(id, &owner, place, &mut Vec::new())?;
            let axes = self.system(system, &owner, place)?.axes_at(position);
            nodes.push(Node { label: id, position, axes });
        }
        Ok(nodes)
    }
}

/// Error for a card that defines an identification number again.
pub(super) fn duplicate(card: &Card, first: Place) -> Problem {
    card.problem(
        format!(
            "{} is defined again with different content; the first is in line {}",
            card.subject(),
            first.line
        ),
        "remove one of the two, or renumber it",
    )
}

/// Rejects cards with the same name and first field but different content.
pub(super) fn repeated<'c>(cards: impl Iterator<Item = &'c Card>) -> Result<Vec<&'c Card>> {
    let mut seen: HashMap<(&str, &str), &Card> = HashMap::new();
    let mut kept = Vec::new();
    for card in cards {
        match seen.get(&(card.name.as_str(), card.text(1))) {
            Some(known) if known.fields == card.fields => {}
            Some(known) => return Err(duplicate(card, known.place)),
            None => {
                seen.insert((&card.name, card.text(1)), card);
                kept.push(card);
            }
        }
    }
    Ok(kept)
}
