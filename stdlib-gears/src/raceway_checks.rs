//! Gears whose bore and elastic bodies whose seats are raceways of bearings: whether rolling
//! elements run on them, and whether they fit.

use crate::error::Severity;
use crate::host::{Finding, ModelHost, shown};
use calyx_abi::RuntimeError;
use calyx_runtime::analyses::Analysis;
use calyx_runtime::bearing::{Bearing, PositionOnCylinder, RacewayCylinder, Ring, Support};
use calyx_runtime::connection::Seat;
use calyx_runtime::error::{EngineError, Subject};
use calyx_runtime::ids::BodyId;
use calyx_runtime::rolling::Elements;
use calyx_runtime::structure::BoreSupport;

/// Part of a size by which a cylinder may exceed the raceway of its elements, and these the
/// cylinder, without a warning.
const FIT: f64 = 0.01;
/// Ratio of the diameters of a seat and of the raceway of its elements, the larger divided by the
/// smaller, from which a ring between them is no longer thin.
const THICK_RING: f64 = 1.5;

/// Checks the raceways in the bores of gears and on seats, and adds warnings to the findings.
///
/// # Errors
/// E0687: a bearing is not coaxial with its raceway. E0669: its elements run outside it.
pub(crate) fn check_raceways(host: &mut ModelHost, analysis: &dyn Analysis) -> Result<(), RuntimeError> {
    let mut found = Vec::new();
    for body in 0..host.scene.bodies.len() {
        let gear = host.body_gears.get(body).copied().flatten().and_then(|gear| host.gears.get(gear));
        let Some(gear) = gear.and_then(|gear| gear.cylindrical()) else { continue };
        if matches!(gear.rim.support, BoreSupport::Raceway { .. }) {
            let half = 0.5 * gear.face_width;
            let cylinder = RacewayCylinder::bore(body, gear.rim.fixed_radius);
            found.extend(
                CheckedRaceway { cylinder, ends: [-half, half], of_gear: true }.check(host, analysis)?,
            );
        }
    }
    for connection in &host.scene.connections {
        for Seat { body, raceway, .. } in connection.seats() {
            let cylinder = RacewayCylinder::seat(body, &raceway);
            let ends = raceway.raceway.ends;
            found.extend(CheckedRaceway { cylinder, ends, of_gear: false }.check(host, analysis)?);
        }
    }
    for error in found {
        let finding = Finding { severity: Severity::Warning, error: host.engine_error(error) };
        if !host.findings.contains(&finding) {
            host.findings.push(finding);
        }
    }
    Ok(())
}

/// CheckedRaceway of a gear, or seat of an elastic body.
struct CheckedRaceway {
    cylinder: RacewayCylinder,
    /// Axial coordinates of its ends from the origin of the body, m.
    ends: [f64; 2],
    of_gear: bool,
}

impl CheckedRaceway {
    /// Returns warnings about the bearings on the raceway.
    fn check(&self, host: &ModelHost, analysis: &dyn Analysis) -> Result<Vec<EngineError>, RuntimeError> {
        let body = self.cylinder.body;
        // Elements outside of a gear run on its teeth.
        let rings = if self.of_gear { &[Ring::Outer][..] } else { &[Ring::Outer, Ring::Inner] };
        let on = host.scene.bearings.iter().enumerate().filter_map(|(index, bearing)| {
            Some((index, *rings.iter().find(|ring| bearing.body_of(**ring) == Some(body))?))
        });
        let bearings: Vec<(usize, Ring)> = on.collect();
        let mut found = Vec::new();
        if bearings.is_empty() {
            found.push(self.no_bearing(host));
        } else if analysis.has_inertia() {
            let message = format!("the raceway in {} is rigid in a dynamic analysis", self.name(host));
            let help = "find the loads of its rolling elements by a quasi-static analysis";
            found.push(EngineError::new("E0700", message, help).about(Subject::Body(body)));
        }
        for bearing in bearings {
            found.extend(self.misfit(host, bearing)?);
        }
        Ok(found)
    }

    fn name(&self, host: &ModelHost) -> String {
        let name = &host.scene.bodies[self.cylinder.body].name;
        if self.of_gear { format!("the bore of \"{name}\"") } else { format!("the seat \"{name}\"") }
    }

    /// Returns the warning about a raceway without a bearing.
    fn no_bearing(&self, host: &ModelHost) -> EngineError {
        let (name, body) = (self.name(host), Subject::Body(self.cylinder.body));
        let rest = match self.of_gear {
            true => "run in it: it deforms like a free bore",
            false => "run on it: bearings keep rigid rings there",
        };
        let help = self.mounted(host).unwrap_or_else(|| {
            match self.of_gear {
                true => "mount a bearing such as `needle_bearing` with this gear on its outer ring, or choose a rim whose `bore` is \"free\"; in `gears.planetary`, give `pin_needles`",
                false => "mount a bearing such as `cylindrical_roller_bearing` on it as `to`, or attach it with `how = \"average\"`",
            }
            .into()
        });
        let message = format!("{name} is a raceway, and no rolling elements {rest}");
        EngineError::new("E0700", message, help).about(body)
    }

    /// Returns the change with which a bearing that is mounted on the body would run on its
    /// raceway.
    fn mounted(&self, host: &ModelHost) -> Option<String> {
        let is_on_body = |bearing: &&Bearing| {
            let is = |body: BodyId| body.0 == self.cylinder.body;
            is(bearing.body) || matches!(bearing.to, Support::Body(body) if is(body))
        };
        host.scene.bearings.iter().filter(is_on_body).find_map(|bearing| {
            let name = &bearing.name;
            if bearing.linearization.is_some() {
                Some(format!(
                    "leave `linearized_at` out of bearing \"{name}\" if this is its raceway: a linearized bearing has no elements"
                ))
            } else {
                let ring = if bearing.rolling()?.is_inverted() { "inner" } else { "outer" };
                Some(format!(
                    "let the `ring` of bearing \"{name}\" be \"{ring}\": its inner ring is on this body"
                ))
            }
        })
    }

    /// Returns the error about rolling elements whose middles are outside the bore by `distance`:
    /// the series of the raceway has no meaning there.
    fn runs_outside(
        &self,
        host: &ModelHost,
        bearing: usize,
        (elements, distance): (&str, String),
    ) -> RuntimeError {
        let (name, raceway) = (&host.scene.bearings[bearing].name, self.name(host));
        let message = format!(
            "the middle of the {elements} of bearing \"{name}\" is {distance} outside {raceway}, which is their raceway"
        );
        let help = match self.of_gear {
            true => "correct the position `at`, or choose a rim whose `bore` is \"free\"",
            false => "correct the position `at` or the region, or attach it with `how = \"average\"`",
        };
        host.engine_error(EngineError::new("E0669", message, help).about(Subject::Bearing(bearing)))
    }

    /// Returns warnings about a bearing that does not fit.
    ///
    /// # Errors
    /// E0687: it is not coaxial with its raceway. E0669: its elements run outside it.
    fn misfit(
        &self,
        host: &ModelHost,
        (bearing, ring): (usize, Ring),
    ) -> Result<Vec<EngineError>, RuntimeError> {
        let own: &Bearing = &host.scene.bearings[bearing];
        let placed = PositionOnCylinder::at(&host.scene.bodies, own, &self.cylinder, 0.0);
        let placed = placed.map_err(|error| match self.of_gear {
            true => host.engine_error(error),
            false => host.engine_error(error.about(Subject::Bearing(bearing))),
        })?;
        let mm = |metres: f64| shown(metres, host.length_unit);
        let (name, raceway) = (&own.name, self.name(host));
        let width = self.ends[1] - self.ends[0];
        let rows = own.rolling().map_or(&[][..], |elements| elements.bearing.rows());
        let mut found = Vec::new();
        for row in rows {
            let (elements, size_of_element) = match &row.elements {
                Elements::Balls(_) => ("balls", "ball_diameter"),
                Elements::Rollers(_) => ("rollers", "roller_diameter"),
            };
            let contact = row.contact(ring);
            let diameter = 2.0 * contact.radius;
            let middle = placed.z + placed.sense * (row.position + contact.position);
            let half = 0.5 * contact.width;
            let beyond = (middle + half - self.ends[1]).max(self.ends[0] - middle + half);
            // A seat in a wall of shells has no width.
            let outside = (middle - self.ends[1]).max(self.ends[0] - middle);
            if width > 0.0 && outside > FIT * width {
                return Err(self.runs_outside(host, bearing, (elements, mm(outside))));
            }
            found.extend(self.wrong_size(host, (bearing, ring), (elements, size_of_element), diameter));
            if width > 0.0 && beyond > FIT * width {
                let help = match self.of_gear {
                    true => {
                        "correct the position `at`, the length of the rollers or the face width of the gear"
                    }
                    false => "correct the position `at`, the length of the rollers or that of the region",
                };
                let message = format!(
                    "the {elements} of bearing \"{name}\" reach {} beyond {raceway}, which is their raceway",
                    mm(beyond)
                );
                found.push((message, help.into()));
            }
        }
        let warning = |(message, help): (String, String)| {
            EngineError::new("E0669", message, help).about(Subject::Bearing(bearing))
        };
        Ok(found.into_iter().map(warning).collect())
    }

    /// Returns the warning about a cylinder whose size is not that of the raceway of the elements,
    /// with this diameter (m), and its remedy.
    fn wrong_size(
        &self,
        host: &ModelHost,
        (bearing, ring): (usize, Ring),
        (elements, size_of_element): (&str, &str),
        diameter: f64,
    ) -> Option<(String, String)> {
        let size = 2.0 * self.cylinder.radius;
        let mm = |metres: f64| shown(metres, host.length_unit);
        let (name, cylinder) = (&host.scene.bearings[bearing].name, self.name(host));
        // A ring is between both where the outer one is in the elastic body or the inner one on it.
        let ratio = if ring == Ring::Outer { size / diameter } else { diameter / size };
        let is = format!(
            "{cylinder} has a diameter of {}, and the {elements} of bearing \"{name}\" need a raceway of {}",
            mm(size),
            mm(diameter)
        );
        // That they need a larger bore of a gear is reported with the sizes of all bearings.
        let most = if self.of_gear { 1.0 + FIT } else { THICK_RING };
        if ratio > most {
            let help = match (self.of_gear, ring) {
                (true, _) => format!(
                    "let the {elements} run in the bore: correct `pitch_diameter`, `{size_of_element}` or the `inner_diameter` of the rim"
                ),
                (false, Ring::Outer) => "mesh the ring with the housing and attach its raceway, or attach the seat with `how = \"average\"`".into(),
                (false, Ring::Inner) => "mesh the ring with the shaft and attach its raceway, or attach the seat with `how = \"average\"`".into(),
            };
            Some((format!("{is}: a ring between them is not modelled"), help))
        } else if !self.of_gear && ratio < 1.0 - FIT {
            let help = format!("correct the diameter of the region, `pitch_diameter` or `{size_of_element}`");
            Some((is, help))
        } else {
            None
        }
    }
}
