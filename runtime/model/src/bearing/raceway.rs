//! Raceways of rolling bearings that are the bore of a gear or a seat of an elastic body.
//!
//! The elements of a bearing press on a raceway at their own angles. At each of them the raceways
//! have a displacement `v` of the outer relative to the inner one ([`RacewayDisplacement`]). With
//! the loads `f` of the elements and the forces `p` of teeth, `v = H p + C f`. The radial
//! displacement of a raceway is a series ([`calyx_structure::Raceway`]), and `C` the compliance of
//! the bodies in these series. The contact of an element is that of half-spaces, whose displacement
//! in the same series would count twice, so it is subtracted from `C`: body and half-space have the
//! same displacements at short wavelengths, and their difference converges quickly with the number
//! of terms.
//!
//! With linearized elements, `f = c + B q - K v` at the deflection `q` of the bearing, `v` is
//! eliminated from the contact problem: `v = M (H p + C (c + B q))` with `M = (I + C K)^-1`.
//!
//! In a seat of an elastic body ([`SeatRaceway`]), the displacement of the series is that of the
//! body, whose seats depend on each other and on the motions of all attachments. It is added to
//! `H p`, and `C` contains the subtracted half-space alone.
//!
//! See `docs/theory/rolling-bearings.md`.

use super::nonlinear_state::NonlinearState;
use super::tangent::{RacewayTangent, Tangent};
use super::{Bearing, BearingState, RollingElements, Support};
use crate::body::Body;
use crate::elastic_body::SeatRaceway;
use crate::motion::spatial_pose;
use calyx_contact::problem::ContactProblem;
use calyx_numerics::error::{EngineError, Subject};
use calyx_numerics::quadrature::gauss_legendre;
use calyx_numerics::vec3::{Vector, dot, minus};
use calyx_rolling::bearing::{Elements, Row};
use calyx_rolling::{RacewayDisplacement, Ring};
use calyx_structure::Raceway;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::PI;
use std::sync::Arc;

/// Distance of the axis of a bearing from that of a bore, relative to its radius, at which they
/// coincide.
const COAXIAL: f64 = 1e-6;
/// The same of the seat of an imported body, whose positions are rounded: angles of rollers in it
/// are off by as much.
const ROUNDED: f64 = 1e-3;
/// Angle between both axes up to which they coincide, rad: angles and positions of rollers differ
/// by its square.
const PARALLEL: f64 = 1e-3;

/// Components of a [`RacewayDisplacement`].
const COMPONENTS: usize = 3;

/// Raceway of a bearing in an elastic body.
#[derive(Clone, Debug)]
pub struct BodyRaceway {
    /// Cylinder on which the elements run.
    pub cylinder: RacewayCylinder,
    /// Ring whose raceway it is.
    pub ring: Ring,
    /// Series of its radial displacement.
    pub series: Raceway,
    /// Half-space displacements in the terms of the series, by row of the bearing.
    pub shares: Vec<HalfSpaceShare>,
    /// Body that determines the coefficients of the series.
    pub owner: RacewayOwner,
}

/// Body with an elastic raceway.
#[derive(Clone, Debug)]
pub enum RacewayOwner {
    /// Gear, with the compliance of the terms in its bore.
    Gear(Arc<DMatrix<f64>>),
    /// Seat of an elastic body.
    Seat(SeatTerms),
}

/// Terms of a seat among those of all seats of an elastic body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeatTerms {
    /// Index of the elastic connection in the scene.
    pub connection: usize,
    /// First term of the seat.
    pub first: usize,
}

/// Raceway of a bearing in an elastic body at a time.
#[derive(Clone, Debug)]
pub struct PlacedRaceway {
    /// Index of the body.
    pub body: usize,
    /// Terms of a seat; `None` for the bore of a gear.
    pub seat: Option<SeatTerms>,
    /// [`RacewayDisplacement`] by the terms of the series: three rows for each element.
    pub by_terms: DMatrix<f64>,
}

/// Elastic raceways of a bearing at a time.
#[derive(Clone, Debug)]
pub struct ElasticRaceways {
    /// Elastic raceways of one or both rings.
    pub raceways: Vec<PlacedRaceway>,
    /// [`RacewayDisplacement`] by loads of the elements: of bores of gears, less those of
    /// half-spaces.
    compliance: DMatrix<f64>,
    /// Width to which forces of a plane model refer, m; 1 in three dimensions.
    width: f64,
}

/// Half-space displacements of the elements of a row by their own loads in the series of a raceway:
/// radial displacement and its derivative along the axis (rows) by force and moment.
pub type HalfSpaceShare = [[f64; 2]; 2];

impl Bearing {
    /// Returns the index of the body that carries a ring of a rolling bearing; `None` for ground.
    pub fn body_of(&self, ring: Ring) -> Option<usize> {
        let is_inverted = self.rolling()?.is_inverted();
        match self.to {
            _ if (ring == Ring::Inner) != is_inverted => Some(self.body.0),
            Support::Ground => None,
            Support::Body(body) => Some(body.0),
        }
    }
}

/// Cylinder in a body whose surface is a raceway.
#[derive(Clone, Copy, Debug)]
pub struct RacewayCylinder {
    /// Index of the body, whose origin is on the axis.
    pub body: usize,
    /// Radius, m.
    pub radius: f64,
    /// Directions along the axes of the body: from the axis to the angle 0, to a quarter turn, and
    /// along the axis.
    pub axes: [Vector; 3],
    /// Distance of the axis of a bearing from that of the cylinder, relative to its radius, up to
    /// which it is coaxial.
    pub eccentricity: f64,
    /// Noun for the cylinder in messages.
    pub what: &'static str,
    /// Remedy for a bearing that is not coaxial.
    pub remedy: &'static str,
}

impl RacewayCylinder {
    /// Creates the bore of a gear.
    pub fn bore(body: usize, radius: f64) -> Self {
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let remedy = "let the gear turn about its own axis, or choose a rim whose `bore` is \"free\"";
        Self { body, radius, axes, eccentricity: COAXIAL, what: "bore", remedy }
    }

    /// Creates the seat of an elastic body.
    pub fn seat(body: usize, seat: &SeatRaceway) -> Self {
        let remedy = "let the axis of the bearing be that of `cylinder_region`: correct its `center` or `axis`, the frames or `at`; or attach the seat with `how = \"average\"`";
        let eccentricity = ROUNDED;
        Self { body, radius: seat.raceway.radius, axes: seat.axes, eccentricity, what: "cylinder", remedy }
    }
}

/// Position of a bearing on the cylinder of a body.
#[derive(Clone, Copy, Debug)]
pub struct PositionOnCylinder {
    /// Axial coordinate of its origin from that of the body, m.
    pub z: f64,
    /// Angle of its x axis from the direction of the angle 0, or the first tooth of a gear, rad.
    angle: f64,
    /// 1 if its z axis is that of the cylinder, -1 if it is opposite.
    pub sense: f64,
}

impl PositionOnCylinder {
    /// Places a bearing on a cylinder at a time (s).
    ///
    /// # Errors
    /// E0687: the bearing is not coaxial with the cylinder. Those of [`BearingState::at`].
    pub fn at(
        bodies: &[Body],
        bearing: &Bearing,
        cylinder: &RacewayCylinder,
        time: f64,
    ) -> Result<Self, EngineError> {
        let RacewayCylinder { body, radius, axes, eccentricity, what, remedy } = *cylinder;
        let placed = BearingState::at(bodies, bearing, time)?;
        let own = &bodies[body];
        let pose =
            spatial_pose(own.motion.as_ref(), time).map_err(|error| error.about(Subject::Body(body)))?;
        // Along the axes of the cylinder.
        let back = |v: Vector| -> Vector {
            let of_body: Vector =
                std::array::from_fn(|axis| (0..3).map(|row| pose.rotation[row][axis] * v[row]).sum());
            axes.map(|axis| dot(axis, of_body))
        };
        let [x, y, z] = back(minus(placed.origin, pose.origin));
        let [tilt_x, tilt_y, along] = back(placed.axes[2]);
        if x.hypot(y) > eccentricity * radius || tilt_x.hypot(tilt_y) > PARALLEL {
            let message = format!(
                "bearing \"{}\" is not coaxial with the {what} of \"{}\", which is its raceway",
                bearing.name, own.name
            );
            return Err(EngineError::new("E0687", message, remedy).about(Subject::Body(body)));
        }
        let [along_x, along_y, _] = back(placed.axes[0]);
        Ok(Self { z, angle: along_y.atan2(along_x) - own.phase, sense: along.signum() })
    }
}

impl BodyRaceway {
    /// Places the raceway at a time (s), with these elements of the bearing.
    fn at(
        &self,
        bodies: &[Body],
        (bearing, elements): (&Bearing, &RollingElements),
        time: f64,
    ) -> Result<(PlacedRaceway, DMatrix<f64>), EngineError> {
        let PositionOnCylinder { z, angle: first, sense } =
            PositionOnCylinder::at(bodies, bearing, &self.cylinder, time)?;
        let rows = elements.bearing.rows();
        let size = COMPONENTS * rows.iter().map(Row::count).sum::<usize>();
        let mut by_terms = DMatrix::zeros(size, self.series.terms());
        let mut half_spaces = DMatrix::zeros(size, size);
        let mut element = 0;
        for (row, share) in rows.iter().zip(&self.shares) {
            let contact = row.contact(self.ring);
            // The derivative of the radial displacement is along the axis of the cylinder.
            let motions = row.relative_displacements(self.ring).map(|[by, by_slope]| [by, sense * by_slope]);
            let at = z + sense * (row.position + contact.position);
            for azimuth in row.azimuths(&elements.motion) {
                let parts = self.series.terms_along(first + sense * azimuth, at, contact.width);
                // A series of degree 0 has no derivative along the axis.
                let is_in_series = [0, 1].map(|k| parts[k].iter().any(|&term| term != 0.0));
                for (i, motion) in motions.iter().enumerate() {
                    let own = COMPONENTS * element + i;
                    for (k, part) in parts.iter().enumerate() {
                        by_terms
                            .row_mut(own)
                            .iter_mut()
                            .zip(part)
                            .for_each(|(sum, term)| *sum += motion[k] * term);
                    }
                    for (j, other) in motions.iter().enumerate() {
                        for (k, l) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                            if is_in_series[k] && is_in_series[l] {
                                half_spaces[(own, COMPONENTS * element + j)] +=
                                    motion[k] * share[k][l] * other[l];
                            }
                        }
                    }
                }
                element += 1;
            }
        }
        let seat = match self.owner {
            RacewayOwner::Gear(_) => None,
            RacewayOwner::Seat(terms) => Some(terms),
        };
        Ok((PlacedRaceway { body: self.cylinder.body, seat, by_terms }, half_spaces))
    }
}

impl PlacedRaceway {
    /// Returns the generalized forces on the terms of the series from loads of the elements, three
    /// for each as in [`calyx_rolling::RacewayLoad::force`].
    pub fn on_terms(&self, loads: &[f64]) -> DVector<f64> {
        self.by_terms.transpose() * DVector::from_row_slice(loads)
    }
}

impl ElasticRaceways {
    /// Places the raceways of a bearing at a time (s). `width` (m) is that of a plane model or 1.
    ///
    /// # Errors
    /// E0687: the bearing is not coaxial with a raceway. Those of [`BearingState::at`].
    pub fn at(
        bodies: &[Body],
        (bearing, elements): (&Bearing, &RollingElements),
        raceways: &[BodyRaceway],
        width: f64,
        time: f64,
    ) -> Result<Self, EngineError> {
        let size = COMPONENTS * elements.bearing.rows().iter().map(Row::count).sum::<usize>();
        let mut compliance = DMatrix::zeros(size, size);
        let mut placed = Vec::with_capacity(raceways.len());
        for raceway in raceways {
            let (own, half_spaces) = raceway.at(bodies, (bearing, elements), time)?;
            if let RacewayOwner::Gear(of_terms) = &raceway.owner {
                // Forces of a plane model refer to its width.
                compliance += &own.by_terms * of_terms.as_ref() * own.by_terms.transpose() / width;
            }
            compliance -= half_spaces;
            placed.push(own);
        }
        Ok(Self::new(placed, compliance, width))
    }

    /// Creates raceways with a compliance of their displacements by loads of the elements, of which
    /// the symmetric part counts, and the width of a plane model (m) or 1.
    pub fn new(raceways: Vec<PlacedRaceway>, compliance: DMatrix<f64>, width: f64) -> Self {
        Self { raceways, compliance: 0.5 * (&compliance + compliance.transpose()), width }
    }

    /// Returns the number of elements.
    pub fn elements(&self) -> usize {
        self.compliance.nrows() / COMPONENTS
    }

    /// Returns the raceway in the bore of a gear, if there is one.
    pub fn bore(&self) -> Option<&PlacedRaceway> {
        self.raceways.iter().find(|raceway| raceway.seat.is_none())
    }

    /// Eliminates the raceways from linearized elements in a state: adapts their tangent between
    /// rigid raceways.
    pub(super) fn eliminate(&self, tangent: &mut Tangent, state: &NonlinearState, sense: f64) {
        let count = state.raceway.len();
        let size = COMPONENTS * count;
        let mut stiffness = DMatrix::zeros(size, size);
        let mut coupling = DMatrix::zeros(size, 5);
        let mut load = DVector::zeros(size);
        for (element, own) in state.raceway_loads.iter().enumerate() {
            for i in 0..COMPONENTS {
                let row = COMPONENTS * element + i;
                load[row] = own.force[i];
                for j in 0..COMPONENTS {
                    stiffness[(row, COMPONENTS * element + j)] =
                        0.5 * (own.stiffness[i][j] + own.stiffness[j][i]);
                }
                for j in 0..5 {
                    coupling[(row, j)] = sense * own.coupling[i][j];
                }
            }
        }
        let at = DVector::from_iterator(size, state.raceway.iter().flatten().copied());
        let deflection = DVector::from_row_slice(&state.deflection);
        load += &stiffness * &at - &coupling * deflection;
        let system = DMatrix::identity(size, size) + &self.compliance * &stiffness;
        let Some(release) = system.try_inverse() else { return };
        // The elements yield by the raceways: B' M C c and B' M C B.
        let yielding = coupling.transpose() * &release * &self.compliance;
        let (less, lower) = (&yielding * &coupling, &yielding * &load - coupling.transpose() * at);
        for i in 0..5 {
            for j in 0..5 {
                tangent.stiffness[i][j] -= 0.5 * (less[(i, j)] + less[(j, i)]);
            }
            tangent.load[i] += lower[i];
        }
        let own = &stiffness * &release;
        let stiffness = 0.5 * (&own + own.transpose());
        tangent.raceway = Some(RacewayTangent { release, load, coupling, stiffness });
    }

    /// Adds linearized elements to the cells of a contact problem, whose gaps grow by unit loads on
    /// the raceway as the rows of `growth` state, per width of a plane model. `arms` are the
    /// deflections of the bearing by DOF, and `start` the motions to which the problem refers.
    pub fn put(
        &self,
        problem: &mut ContactProblem,
        (tangent, growth): (&RacewayTangent, &DMatrix<f64>),
        arms: &[[f64; 6]],
        start: &[f64],
    ) {
        let (cells, dofs) = (growth.nrows().min(problem.cells()), problem.dofs());
        let pressed = growth * &tangent.stiffness / self.width;
        let released = growth * tangent.release.transpose() / self.width;
        let (gaps, coupling) = (&released * &tangent.load, &released * &tangent.coupling);
        let by_dof = |row: usize, arm: &[f64; 6]| (0..5).map(|k| coupling[(row, k)] * arm[k]).sum::<f64>();
        let all = problem.cells();
        for row in 0..cells {
            problem.gaps[row] += gaps[row];
            for (dof, arm) in arms.iter().enumerate() {
                let arm = by_dof(row, arm);
                problem.arms[row * dofs + dof] += arm;
                problem.gaps[row] += arm * start.get(dof).copied().unwrap_or(0.0);
            }
        }
        let between = pressed * growth.transpose();
        for row in 0..cells {
            for column in 0..=row {
                let entry = problem.compliance[row * all + column] - between[(row, column)];
                problem.compliance[row * all + column] = entry;
                problem.compliance[column * all + row] = entry;
            }
        }
    }

    /// Returns the displacements of the raceways by unit forces on cells, from those of the terms
    /// of the series of the bore of a gear: cells by displacements. `None` without such a raceway.
    pub fn growth(&self, by_cells: &DMatrix<f64>) -> Option<DMatrix<f64>> {
        Some(by_cells * self.bore()?.by_terms.transpose())
    }

    /// Returns the displacements of the raceways with linearized elements at a deflection; `moved`
    /// is that by forces of teeth and of seats.
    pub fn displaced(&self, tangent: &RacewayTangent, deflection: &[f64; 5], moved: &[f64]) -> Vec<f64> {
        let load = &tangent.load + &tangent.coupling * DVector::from_row_slice(deflection);
        let moved = DVector::from_row_slice(moved) + &self.compliance * load;
        (&tangent.release * moved).as_slice().to_vec()
    }
}

/// Returns the shares of the rows of a bearing that is placed on the raceway of a ring; `None` in
/// its middle. `modulus` is that of [`half_space_share`].
pub fn half_space_shares(
    elements: &RollingElements,
    (ring, raceway, modulus): (Ring, &Raceway, f64),
    placed: Option<PositionOnCylinder>,
) -> Vec<HalfSpaceShare> {
    let middle = 0.5 * (raceway.ends[0] + raceway.ends[1]);
    let position =
        |row: &Row| placed.map_or(middle, |at| at.z + at.sense * (row.position + row.contact(ring).position));
    elements
        .bearing
        .rows()
        .iter()
        .map(|row| half_space_share((row, ring), (raceway, modulus), position(row)))
        .collect()
}

/// Number of points of Gauss's quadrature on a panel.
const POINTS: usize = 16;
/// The same along a raceway, exact for products of two polynomials of the highest degree.
const POINTS_ALONG: usize = 6;

/// Returns the displacements of the elements of a row on a half-space by their own loads, as far as
/// they are in the series of the raceway of a ring, on which the middle of a contact has an axial
/// coordinate `z` (m). The force of a roller is uniform along its length, its moment that of a
/// linear pressure, and displacements are means with the same weights; the force of a ball acts at
/// a point. In a plane model, and on the edge of a shell, the series has no axial part: the roller
/// has its whole length there, and a ball its diameter. The half-space has the plane-strain modulus
/// (Pa) of the body whose series it is: that of the ring enters the contact deflection.
pub fn half_space_share(
    (row, ring): (&Row, Ring),
    (raceway, modulus): (&Raceway, f64),
    z: f64,
) -> HalfSpaceShare {
    let without_width = match &row.elements {
        Elements::Balls(balls) => balls.geometry().ball_diameter,
        Elements::Rollers(_) => row.contact(ring).width,
    };
    let width = raceway.ends[1] - raceway.ends[0];
    if width > 0.0 {
        let distributions = raceway.distributions(z, row.contact(ring).width);
        return series_share(modulus, raceway, (width, distributions));
    }
    let length = without_width;
    let uniform = |from_start: f64| [1.0 / length, 12.0 * (from_start - 0.5 * length) / length.powi(3)];
    series_share(modulus, raceway, (length, uniform))
}

/// Returns the displacements on a half-space of this plane-strain modulus (Pa) by loads with these
/// distributions over a width (m), as far as they are in the harmonics of a raceway.
fn series_share(
    modulus: f64,
    raceway: &Raceway,
    (width, distributions): (f64, impl Fn(f64) -> [f64; 2]),
) -> HalfSpaceShare {
    let (points, along) = (gauss_legendre(POINTS), gauss_legendre(POINTS_ALONG));
    // Sum over both senses of the products of loads and observers at an axial distance.
    let products = |apart: f64| {
        let overlap = width - apart;
        let mut sum = [[0.0; 2]; 2];
        for (node, weight) in &along {
            let at = 0.5 * overlap * (1.0 + node);
            let (one, other) = (distributions(at), distributions(at + apart));
            for i in 0..2 {
                for j in 0..2 {
                    sum[i][j] += 0.5 * weight * overlap * (one[i] * other[j] + other[i] * one[j]);
                }
            }
        }
        sum
    };
    // Displacement at a distance around the raceway, without 1 / (pi E').
    let at = |x: f64| {
        let end = (width / x).asinh();
        let mut sum = [[0.0; 2]; 2];
        for (node, weight) in &points {
            // Axial distance t with dt / sqrt(x^2 + t^2) = ds.
            let apart = (x * (0.5 * end * (1.0 + node)).sinh()).min(width);
            add_scaled(&mut sum, 0.5 * weight * end, &products(apart));
        }
        sum
    };
    let (radius, harmonics) = (raceway.radius, usize::from(raceway.harmonics));
    let panels = harmonics.max(1);
    let panel = PI / panels as f64;
    let mut share = [[0.0; 2]; 2];
    for index in 0..panels {
        for (node, weight) in &points {
            let s = 0.5 * (1.0 + node);
            // The displacement is logarithmic at the roller.
            let (part, slope) = if index == 0 { (s.powi(4), 4.0 * s.powi(3)) } else { (s, 1.0) };
            let angle = panel * (index as f64 + part);
            let dirichlet = 1.0 + 2.0 * (1..=harmonics).map(|k| (k as f64 * angle).cos()).sum::<f64>();
            let factor = 0.5 * weight * panel * slope * dirichlet / (PI * PI * modulus);
            add_scaled(&mut share, factor, &at(radius * angle));
        }
    }
    share
}

fn add_scaled(sum: &mut HalfSpaceShare, factor: f64, part: &HalfSpaceShare) {
    sum.as_flattened_mut().iter_mut().zip(part.as_flattened()).for_each(|(sum, part)| *sum += factor * part);
}

/// Returns displacements of raceways by element from a list.
pub fn by_element(displacements: &[f64]) -> Vec<RacewayDisplacement> {
    displacements.as_chunks().0.to_vec()
}
