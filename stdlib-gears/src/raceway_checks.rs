//! Gears whose bore is the raceway of a bearing: whether rollers run in it, and whether they fit.

use crate::error::Severity;
use crate::host::{Finding, ModelHost, shown};
use calyx_abi::RuntimeError;
use calyx_runtime::analyses::Analysis;
use calyx_runtime::bearing::{Bearing, InBore};
use calyx_runtime::error::{EngineError, Subject};
use calyx_runtime::rolling::{Elements, Row};
use calyx_runtime::structure::BoreSupport;

/// Part of a size by which a bore may exceed the raceway of its rollers, and these the bore,
/// without a warning.
const FIT: f64 = 0.01;

/// Checks the raceways in the bores of gears, and adds warnings to the findings.
///
/// # Errors
/// E0687: a bearing is not coaxial with the bore.
pub(crate) fn check_raceways(host: &mut ModelHost, analysis: &dyn Analysis) -> Result<(), RuntimeError> {
    let mut found = Vec::new();
    for body in 0..host.scene.bodies.len() {
        let gear = host.body_gears.get(body).copied().flatten().and_then(|gear| host.gears.get(gear));
        let Some(gear) = gear.and_then(|gear| gear.cylindrical()) else { continue };
        if !matches!(gear.rim.support, BoreSupport::Raceway { .. }) {
            continue;
        }
        let bore = Bore { body, radius: gear.rim.fixed_radius, width: gear.face_width };
        let inside: Vec<usize> = (0..host.scene.bearings.len())
            .filter(|&bearing| host.scene.bearings[bearing].outer_body() == Some(body))
            .collect();
        if inside.is_empty() {
            found.push(no_rollers(host, body));
        } else if analysis.has_inertia() {
            let name = &host.scene.bodies[body].name;
            let message = format!("the raceway in the bore of \"{name}\" is rigid in a dynamic analysis");
            let help = "find the loads of its rollers by a quasi-static analysis";
            found.push(EngineError::new("E0700", message, help).about(Subject::Body(body)));
        }
        for bearing in inside {
            found.extend(bore.misfit(host, bearing)?);
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

/// Returns the warning about a raceway without rollers.
fn no_rollers(host: &ModelHost, body: usize) -> EngineError {
    let name = &host.scene.bodies[body].name;
    let message = format!(
        "the bore of \"{name}\" is a raceway, and no cylindrical rollers run in it: it deforms like a free bore, and bearings have rigid rings"
    );
    let help = "mount a `needle_bearing` or `cylindrical_roller_bearing` with this gear on its outer ring and without `linearized_at`, or choose a rim whose `bore` is \"free\"; in `gears.planetary`, give `pin_needles`";
    EngineError::new("E0700", message, help).about(Subject::Body(body))
}

/// Bore of a gear.
struct Bore {
    body: usize,
    /// Radius and width, m.
    radius: f64,
    width: f64,
}

impl Bore {
    /// Returns warnings about a bearing that does not fit.
    fn misfit(&self, host: &ModelHost, bearing: usize) -> Result<Vec<EngineError>, RuntimeError> {
        let own: &Bearing = &host.scene.bearings[bearing];
        let bodies = &host.scene.bodies;
        let placed = InBore::at(bodies, own, (self.body, self.radius), 0.0);
        let placed = placed.map_err(|error| host.engine_error(error))?;
        let mm = |metres: f64| shown(metres, host.length_unit);
        let (name, gear) = (&own.name, &bodies[self.body].name);
        let rows = own.rolling().map_or(&[][..], |elements| elements.bearing.rows());
        let mut found = Vec::new();
        for row in rows {
            let Elements::Rollers(rollers) = &row.elements else { continue };
            let diameter = Row::pitch_diameter(row) + rollers.geometry().roller_diameter;
            let middle = placed.z + placed.sense * row.position;
            let beyond = middle.abs() + 0.5 * rollers.geometry().length - 0.5 * self.width;
            // That rollers need a larger bore is reported with the sizes of all bearings.
            if 2.0 * self.radius > (1.0 + FIT) * diameter {
                found.push((
                    format!(
                        "the bore of \"{gear}\" has a diameter of {}, and the rollers of bearing \"{name}\" need a raceway of {}: a ring between them is not modelled",
                        mm(2.0 * self.radius),
                        mm(diameter)
                    ),
                    "let the rollers run in the bore: correct `pitch_diameter`, `roller_diameter` or the `inner_diameter` of the rim",
                ));
            }
            if beyond > FIT * self.width {
                found.push((
                    format!(
                        "the rollers of bearing \"{name}\" reach {} beyond the bore of \"{gear}\", which is their raceway",
                        mm(beyond)
                    ),
                    "correct the position `at`, the length of the rollers or the face width of the gear",
                ));
            }
        }
        let warning = |(message, help): (String, &'static str)| {
            EngineError::new("E0669", message, help).about(Subject::Bearing(bearing))
        };
        Ok(found.into_iter().map(warning).collect())
    }
}
