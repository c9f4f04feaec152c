//! Rolling bearings as sets of rows. Rings are rigid unless their raceways are
//! displaced.

use crate::ball::{BallKind, BallRow, BallState, Motion};
use crate::element::{Local, Response};
use crate::error::{RollingError, finite};
use crate::raceway::{RacewayContact, RacewayDisplacement, RacewayLoad, Ring, displace};
use crate::roller::{ContactModel, RollerKind, RollerRow, RollerStart, RollerState};
use libm::{cos, sin};
use std::f64::consts::TAU;

/// Displacement of the inner ring relative to the outer ring at the reference point of the bearing:
/// translations along x, y and z, m, and rotations about x and y, rad.
///
/// Kinematics are linear: a point at radius R and axial position z moves radially by
/// `ux cos ψ + uy sin ψ + z τ` and axially by `uz - R τ`, with `τ = θy cos ψ - θx sin ψ`.
pub type Displacement = [f64; 5];

/// Forces along x, y and z, N, and moments about x and y, N m, conjugate to [`Displacement`].
pub type Load = [f64; 5];

/// Rolling elements of a row.
#[derive(Clone, Debug, PartialEq)]
pub enum Elements {
    /// Balls.
    Balls(BallRow),
    /// Rollers.
    Rollers(Box<RollerRow>),
}

impl From<BallRow> for Elements {
    fn from(row: BallRow) -> Self {
        Self::Balls(row)
    }
}

impl From<RollerRow> for Elements {
    fn from(row: RollerRow) -> Self {
        Self::Rollers(Box::new(row))
    }
}

/// A row of rolling elements at its position in a bearing.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Rolling elements.
    pub elements: Elements,
    /// Axial position of the element centres from the reference point, m.
    pub position: f64,
    /// The row is mirrored: a displacement of the inner ring to -z loads its contact angle.
    pub mirrored: bool,
    /// Axial displacement of the inner ring in the loading direction of the row, m, at zero
    /// displacement of the bearing: preload if positive, axial clearance if negative.
    pub offset: f64,
    /// Azimuth of the first element relative to that of the bearing, rad.
    pub azimuth: f64,
}

/// Arrangement of two equal rows with contact angles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arrangement {
    /// O or back-to-back: the contact lines meet the axis outside of the rows.
    BackToBack,
    /// X or face-to-face: the contact lines meet the axis between the rows.
    FaceToFace,
    /// Both rows carry axial load to +z.
    Tandem,
}

/// A rolling bearing.
#[derive(Clone, Debug, PartialEq)]
pub struct RollingBearing {
    rows: Vec<Row>,
    elements: usize,
    stiffness: f64,
    radius: f64,
}

/// Load on the inner ring that balances the elements, and its derivatives.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Evaluation {
    /// Load on the inner ring.
    pub load: Load,
    /// Derivatives of the load with respect to the displacement, at elements in equilibrium.
    pub stiffness: [[f64; 5]; 5],
    /// Sum of the magnitudes of the loads of all elements on the inner ring, N.
    pub scale: f64,
    /// Number of elements without converged equilibrium.
    pub unconverged: usize,
}

/// Positions of the elements at a displacement, from which the next evaluation starts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Start {
    rollers: Vec<RollerStart>,
}

/// State of a rolling element.
#[derive(Clone, Debug, PartialEq)]
pub struct ElementState {
    /// Index of the row.
    pub row: usize,
    /// Azimuth from +x to +y, rad.
    pub azimuth: f64,
    /// Contacts.
    pub contacts: Contacts,
}

/// Contacts of a rolling element.
#[derive(Clone, Debug, PartialEq)]
pub enum Contacts {
    /// Contacts of a ball.
    Ball(BallState),
    /// Contacts of a roller.
    Roller(Box<RollerState>),
}

impl Row {
    /// A row at the reference point of its bearing.
    pub fn new(elements: impl Into<Elements>) -> Self {
        Self { elements: elements.into(), position: 0.0, mirrored: false, offset: 0.0, azimuth: 0.0 }
    }

    /// Returns the number of elements.
    pub fn count(&self) -> usize {
        match &self.elements {
            Elements::Balls(row) => row.geometry.count,
            Elements::Rollers(row) => row.geometry.count,
        }
    }

    /// Returns the pitch diameter, m.
    pub fn pitch_diameter(&self) -> f64 {
        match &self.elements {
            Elements::Balls(row) => row.geometry.pitch_diameter,
            Elements::Rollers(row) => row.geometry.pitch_diameter,
        }
    }

    /// Returns the orbital speed of the elements, rad/s: that of rolling without slip at the
    /// contact angle of the drawing, which is 0 for deep grooves.
    pub fn cage_speed(&self, motion: &Motion) -> f64 {
        motion.orbital_speed(match &self.elements {
            Elements::Balls(row) => row.orbit_ratio(),
            Elements::Rollers(row) => row.cage_ratio,
        })
    }

    /// Returns the derivative of the displacement in the plane of an element with respect to that
    /// of the bearing.
    fn projection(&self, [cosine, sine]: [f64; 2]) -> [[f64; 5]; 3] {
        let (side, z) = (self.side(), self.position);
        [
            [cosine, sine, 0.0, -z * sine, z * cosine],
            [0.0, 0.0, side, 0.0, 0.0],
            [0.0, 0.0, 0.0, -side * sine, side * cosine],
        ]
    }

    /// Returns the contacts of the elements with the raceway of a ring.
    pub fn contact(&self, ring: Ring) -> RacewayContact {
        let ([radius, position], angle, width) = match &self.elements {
            Elements::Balls(balls) => {
                let (middle, angle) = balls.raceway_contact(ring);
                (middle, angle, 0.0)
            }
            Elements::Rollers(rollers) => {
                let index = usize::from(ring == Ring::Outer);
                let angle = rollers.angles[index];
                (rollers.raceway_contacts[index], angle, rollers.geometry.length * cos(angle))
            }
        };
        RacewayContact { radius, position: self.side() * position, angle, width }
    }

    /// Returns the [`RacewayDisplacement`] at an element by the radial displacement of the raceway
    /// of a ring in the middle of the contact ([`Row::contact`]), outwards, and by the derivative
    /// of this displacement along the axis of the bearing (columns).
    pub fn relative_displacements(&self, ring: Ring) -> [[f64; 2]; 3] {
        let sign = match ring {
            Ring::Inner => -1.0,
            Ring::Outer => 1.0,
        };
        self.contact(ring).rigid_motions(self.side()).map(|row| row.map(|entry| sign * entry))
    }

    /// Returns the sense of the bearing's z axis in the plane of an element.
    fn side(&self) -> f64 {
        if self.mirrored { -1.0 } else { 1.0 }
    }

    /// Returns the azimuths of the elements.
    pub fn azimuths(&self, motion: &Motion) -> impl Iterator<Item = f64> + use<> {
        let (count, first) = (self.count(), self.azimuth + motion.azimuth);
        (0..count).map(move |k| first + TAU * k as f64 / count as f64)
    }

    /// Returns the stiffness of all elements in their contact direction at an approach of 1e-4 of
    /// their diameter.
    fn typical_stiffness(&self) -> f64 {
        self.count() as f64
            * match &self.elements {
                Elements::Balls(row) => {
                    let contact = row.contact(&row.grooves[0], 1.0);
                    contact.stiffness * (1e-4 * row.geometry.ball_diameter).sqrt()
                }
                Elements::Rollers(row) => {
                    let approach = 1e-4 * row.geometry.roller_diameter;
                    row.coefficient * row.geometry.laminae as f64 * crate::hertz::line::ninth_root(approach)
                }
            }
    }
}

impl RollingBearing {
    /// Creates a bearing from its rows.
    ///
    /// # Errors
    /// [`RollingError::Input`] without rows, or if a position or offset is not finite.
    pub fn new(rows: Vec<Row>) -> Result<Self, RollingError> {
        if rows.is_empty() {
            return Err(RollingError::input("the rolling bearing has no row", "give at least one row"));
        }
        for row in &rows {
            finite("axial position of a row", row.position)?;
            finite("axial offset of a row", row.offset)?;
            finite("azimuth of a row", row.azimuth)?;
        }
        let elements = rows.iter().map(Row::count).sum();
        let stiffness = rows.iter().map(Row::typical_stiffness).sum();
        let extent = |row: &Row| 0.5 * row.pitch_diameter() + row.position.abs();
        let radius = rows.iter().map(extent).fold(0.0, f64::max);
        Ok(Self { rows, elements, stiffness, radius })
    }

    /// Creates a bearing of one row at its reference point.
    pub fn single(elements: impl Into<Elements>) -> Self {
        let row = Row::new(elements);
        let (elements, stiffness) = (row.count(), row.typical_stiffness());
        let radius = 0.5 * row.pitch_diameter();
        Self { rows: vec![row], elements, stiffness, radius }
    }

    /// Creates a bearing of two equal rows at a distance, m. Both have the same axial offset:
    /// preload if positive. The reference point is midway.
    ///
    /// # Errors
    /// [`RollingError::Input`] if the distance is not positive or an input is not finite.
    pub fn pair(
        elements: impl Into<Elements>,
        arrangement: Arrangement,
        distance: f64,
        offset: f64,
    ) -> Result<Self, RollingError> {
        crate::error::positive("distance of the rows", distance)?;
        let elements = elements.into();
        let rows = [-1.0, 1.0].map(|side| Row {
            position: 0.5 * side * distance,
            mirrored: match arrangement {
                Arrangement::BackToBack => side > 0.0,
                Arrangement::FaceToFace => side < 0.0,
                Arrangement::Tandem => false,
            },
            offset,
            ..Row::new(elements.clone())
        });
        Self::new(rows.to_vec())
    }

    /// Returns the bearing with another model of the contacts of its rollers. Balls have Hertz's
    /// solution of half-spaces at each.
    ///
    /// # Errors
    /// [`RollingError::Input`] if the model has an invalid number of strips.
    pub fn with_contact(&self, model: ContactModel) -> Result<Self, RollingError> {
        let mut bearing = self.clone();
        for row in &mut bearing.rows {
            if let Elements::Rollers(rollers) = &mut row.elements {
                **rollers = rollers.as_ref().clone().with_contact(model)?;
            }
        }
        Ok(bearing)
    }

    /// Returns the bearing with laminae in place of elastic contacts, or `None` without them.
    pub(crate) fn laminae(&self) -> Option<Self> {
        let is_elastic = |row: &Row| match &row.elements {
            Elements::Balls(_) => false,
            Elements::Rollers(rollers) => rollers.elastic.is_some(),
        };
        self.rows.iter().any(is_elastic).then(|| self.with_contact(ContactModel::Laminae).ok())?
    }

    /// Returns whether any row has rollers.
    pub fn has_rollers(&self) -> bool {
        self.rows.iter().any(|row| matches!(row.elements, Elements::Rollers(_)))
    }

    /// Returns the rows.
    pub fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// Returns a displacement beyond all clearances at which the elements carry load, m.
    pub fn reach(&self) -> f64 {
        let of = |row: &Row| {
            let (clearance, diameter) = match &row.elements {
                Elements::Balls(row) => (row.clearance(), row.geometry.ball_diameter),
                Elements::Rollers(row) => (row.clearance(), row.geometry.roller_diameter),
            };
            clearance.max(0.0) + 4.0 * (-row.offset).max(0.0) + 1e-3 * diameter
        };
        self.rows.iter().map(of).fold(0.0, f64::max)
    }

    /// Returns whether the elements resist displacements of the inner ring to +z and to -z. Balls
    /// resist both, also on the flanks that an angular contact bearing is not made for.
    pub fn axial_supports(&self) -> [bool; 2] {
        let of = |row: &Row| match &row.elements {
            Elements::Balls(_) => [true, true],
            Elements::Rollers(rollers) if rollers.free_axially => [false, false],
            Elements::Rollers(_) => [!row.mirrored, row.mirrored],
        };
        self.rows.iter().map(of).fold([false, false], |all, row| [all[0] || row[0], all[1] || row[1]])
    }

    /// Returns whether radial forces cause axial ones: rows have a contact angle.
    pub fn has_contact_angle(&self) -> bool {
        self.rows.iter().any(|row| match &row.elements {
            Elements::Balls(balls) => matches!(balls.geometry.kind, BallKind::AngularContact { .. }),
            Elements::Rollers(rollers) => matches!(rollers.geometry.kind, RollerKind::Tapered { .. }),
        })
    }

    /// Returns whether balls of angular contact rows carry load on the flanks that a groove with
    /// shoulder does not have: those with a contact angle opposite to the nominal one. Loads below
    /// a hundredth of the largest do not count.
    pub fn is_loaded_on_opposite_flanks(&self, states: &[ElementState]) -> bool {
        let largest = states.iter().map(ElementState::load).fold(0.0, f64::max);
        states.iter().any(|state| {
            let angular = self.rows.get(state.row).is_some_and(|row| match &row.elements {
                Elements::Balls(balls) => matches!(balls.geometry.kind, BallKind::AngularContact { .. }),
                Elements::Rollers(_) => false,
            });
            let opposite = |ball: &BallState| {
                ball.inner.iter().any(|contact| contact.angle < 0.0 && contact.load > 0.01 * largest)
            };
            angular && state.ball().is_some_and(opposite)
        })
    }

    /// Returns a stiffness typical of the bearing under load, N/m.
    pub(crate) fn typical_stiffness(&self) -> f64 {
        self.stiffness
    }

    /// Returns the distance of the elements from the reference point, m.
    pub(crate) fn radius(&self) -> f64 {
        self.radius
    }

    /// Computes load and stiffness at a displacement of the inner ring. `start` has the positions
    /// of the elements at a near displacement, or none, and receives those found.
    ///
    /// # Errors
    /// [`RollingError::Input`] if the displacement is not finite.
    pub fn evaluate(
        &self,
        displacement: &Displacement,
        motion: &Motion,
        start: &mut Start,
    ) -> Result<Evaluation, RollingError> {
        Ok(self.evaluate_with(displacement, &[], motion, start)?.0)
    }

    /// Computes load and stiffness like [`RollingBearing::evaluate`] between raceways that are
    /// displaced at each element, row by row. Also returns the loads of the elements on the
    /// raceways.
    ///
    /// # Errors
    /// [`RollingError::Input`] if a displacement is not finite.
    pub fn evaluate_with(
        &self,
        displacement: &Displacement,
        raceway: &[RacewayDisplacement],
        motion: &Motion,
        start: &mut Start,
    ) -> Result<(Evaluation, Vec<RacewayLoad>), RollingError> {
        check(displacement, motion)?;
        for &value in raceway.as_flattened() {
            finite("displacement of a raceway", value)?;
        }
        start.rollers.resize_with(self.elements, RollerStart::default);
        let mut evaluation = Evaluation::default();
        let mut loads = Vec::with_capacity(raceway.len());
        let mut element = 0;
        for row in &self.rows {
            let force = match &row.elements {
                Elements::Balls(_) => 0.0,
                Elements::Rollers(rollers) => rollers.centrifugal_force(motion),
            };
            for azimuth in row.azimuths(motion) {
                let projection = row.projection([cos(azimuth), sin(azimuth)]);
                let mut ring = local(&projection, displacement, row.offset);
                let moved = raceway.get(element);
                moved.iter().for_each(|moved| displace(&mut ring, moved));
                let response = match &row.elements {
                    Elements::Balls(balls) => balls.response(&ring, motion),
                    Elements::Rollers(rollers) => rollers.response(&ring, force, &mut start.rollers[element]),
                };
                evaluation.add(&projection, &response);
                loads.extend(moved.map(|_| RacewayLoad::of(&projection, &response)));
                element += 1;
            }
        }
        Ok((evaluation, loads))
    }

    /// Computes the state of each element at a displacement of the inner ring, row by row.
    ///
    /// # Errors
    /// [`RollingError::Input`] if the displacement is not finite.
    pub fn elements(
        &self,
        displacement: &Displacement,
        motion: &Motion,
    ) -> Result<Vec<ElementState>, RollingError> {
        self.elements_with(displacement, &[], motion, &Start::default())
    }

    /// Computes the states like [`RollingBearing::elements`] between raceways that are displaced at
    /// each element, row by row, from the positions of an evaluation, which is fast at the same
    /// displacement.
    ///
    /// # Errors
    /// [`RollingError::Input`] if a displacement is not finite.
    pub fn elements_with(
        &self,
        displacement: &Displacement,
        raceway: &[RacewayDisplacement],
        motion: &Motion,
        start: &Start,
    ) -> Result<Vec<ElementState>, RollingError> {
        check(displacement, motion)?;
        for &value in raceway.as_flattened() {
            finite("displacement of a raceway", value)?;
        }
        let mut states = Vec::with_capacity(self.elements);
        for (index, row) in self.rows.iter().enumerate() {
            for azimuth in row.azimuths(motion) {
                let projection = row.projection([cos(azimuth), sin(azimuth)]);
                let mut ring = local(&projection, displacement, row.offset);
                let moved = raceway.get(states.len());
                moved.iter().for_each(|moved| displace(&mut ring, moved));
                let contacts = match &row.elements {
                    Elements::Balls(balls) => Contacts::Ball(balls.state(&ring, motion)),
                    Elements::Rollers(rollers) => {
                        let force = rollers.centrifugal_force(motion);
                        Contacts::Roller(Box::new(rollers.state(
                            &ring,
                            force,
                            start.rollers.get(states.len()),
                        )))
                    }
                };
                states.push(ElementState { row: index, azimuth, contacts });
            }
        }
        Ok(states)
    }
}

impl Evaluation {
    fn add(&mut self, projection: &[[f64; 5]; 3], response: &Response) {
        self.unconverged += usize::from(response.unconverged);
        self.scale += libm::hypot(response.force[0], response.force[1]);
        for i in 0..5 {
            for k in 0..3 {
                self.load[i] += projection[k][i] * response.force[k];
            }
            for j in 0..5 {
                for k in 0..3 {
                    for l in 0..3 {
                        self.stiffness[i][j] +=
                            projection[k][i] * response.stiffness[k][l] * projection[l][j];
                    }
                }
            }
        }
    }
}

impl ElementState {
    /// Returns the larger of the loads on the inner and on the outer raceway, N.
    pub fn load(&self) -> f64 {
        match &self.contacts {
            Contacts::Ball(ball) => {
                ball.inner.iter().chain(&ball.outer).fold(0.0, |load, contact| contact.load.max(load))
            }
            Contacts::Roller(roller) => roller.inner.load.max(roller.outer.load),
        }
    }

    /// Returns whether the element carries load between both rings.
    pub fn is_loaded(&self) -> bool {
        match &self.contacts {
            Contacts::Ball(ball) => ball.inner.iter().any(|contact| contact.load > 0.0),
            Contacts::Roller(roller) => roller.inner.load > 0.0,
        }
    }

    /// Returns the state of a ball.
    pub fn ball(&self) -> Option<&BallState> {
        match &self.contacts {
            Contacts::Ball(ball) => Some(ball),
            Contacts::Roller(_) => None,
        }
    }

    /// Returns the state of a roller.
    pub fn roller(&self) -> Option<&RollerState> {
        match &self.contacts {
            Contacts::Roller(roller) => Some(roller),
            Contacts::Ball(_) => None,
        }
    }

    /// Returns the largest contact pressure, Pa.
    pub fn pressure(&self) -> f64 {
        match &self.contacts {
            Contacts::Ball(ball) => ball
                .inner
                .iter()
                .chain(&ball.outer)
                .fold(0.0, |largest, contact| contact.pressure.max(largest)),
            Contacts::Roller(roller) => roller.inner.pressure.max(roller.outer.pressure),
        }
    }
}

/// Returns the displacement in the plane of an element.
fn local(projection: &[[f64; 5]; 3], displacement: &Displacement, offset: f64) -> Local {
    let [radial, axial, tilt] = [0, 1, 2].map(|k| crate::linear::dot(&projection[k], displacement));
    [radial, axial + offset, tilt]
}

/// Checks that displacement and speeds are finite.
fn check(displacement: &Displacement, motion: &Motion) -> Result<(), RollingError> {
    for &value in displacement {
        finite("displacement", value)?;
    }
    finite("speed", motion.inner_speed)?;
    finite("speed", motion.outer_speed)?;
    finite("azimuth", motion.azimuth)?;
    finite("centrifugal force", motion.roller_force.unwrap_or(0.0))
}
