//! Bearings in the display of a plan.

use crate::shown::rounded;
use calyx_gears::host::ModelHost;
use calyx_runtime::bearing::{Bearing, Linearization, RANGE_TOLERANCE, Ring, Support};
use calyx_runtime::connection::ElasticConnection;
use calyx_runtime::plan::Plan;
use calyx_runtime::rolling::rating::bearing_capacity;
use calyx_runtime::rolling::{BallKind, Elements, RollerKind, RollingBearing};
use calyx_runtime::scene::{BodyId, Fidelity};
use calyx_runtime::structure::BoreSupport;

/// A connection of bodies other than contact.
#[derive(Clone, Debug, PartialEq)]
pub struct PlannedBearing {
    pub name: String,
    /// The supported body, and the body or ground that supports it.
    pub between: [String; 2],
    /// Number of gap equations of its clearances.
    pub walls: usize,
    pub left_out: bool,
    /// The reason for its model, or for omitting it.
    pub reason: &'static str,
    /// Kind, elements and load ratings of a rolling bearing, or the operating point of a linearized
    /// one, as text.
    pub rolling: Option<String>,
}

impl PlannedBearing {
    pub(crate) fn all(host: &ModelHost, plan: &Plan) -> Vec<PlannedBearing> {
        let scene = &host.scene;
        let name = |body: BodyId| {
            scene.bodies.get(body.0).map_or_else(String::new, |body| format!("\"{}\"", body.name))
        };
        let of = |(index, bearing): (usize, &Bearing)| {
            let planned = plan.bearings.get(index)?;
            let to = match bearing.to {
                Support::Ground => "ground".into(),
                Support::Body(body) => name(body),
            };
            let stated = host.bearing_ratings.get(&index).copied();
            Some(PlannedBearing {
                name: bearing.name.clone(),
                between: [name(bearing.body), to],
                walls: bearing.walls(),
                left_out: planned.left_out,
                reason: planned.reason,
                rolling: match (bearing.rolling(), bearing.linearization) {
                    (Some(elements), _) => {
                        let mut text = described(&elements.bearing, stated);
                        if elements.bearing.has_rollers() && plan.fidelity != Fidelity::Rigid {
                            text += match plan.fidelity.has_elastic_rollers() {
                                true => "; elastic contacts of rollers",
                                false => "; laminae of ISO/TS 16281",
                            };
                        }
                        if let Some(gear) = in_bore(host, plan, bearing) {
                            text += &format!("; elastic outer raceway in the bore of {}", name(BodyId(gear)));
                        }
                        for (ring, seat) in on_seats(host, plan, bearing) {
                            text += &format!("; elastic {ring} raceway on the seat {}", name(BodyId(seat)));
                        }
                        Some(text)
                    }
                    (None, linearization) => linearization.map(linearized),
                },
            })
        };
        scene.bearings.iter().enumerate().filter_map(of).collect()
    }

    pub(crate) fn line(&self) -> String {
        let [body, to] = &self.between;
        let walls = match self.walls {
            0 => String::new(),
            1 => ", 1 clearance gap".into(),
            count => format!(", {count} clearance gaps"),
        };
        let what = self.rolling.as_deref().unwrap_or(self.reason);
        format!("\"{}\": {body} on {to}, {what}{walls}", self.name)
    }
}

/// Returns the index of the finite-element body whose bore is the raceway of a bearing.
fn in_bore(host: &ModelHost, plan: &Plan, bearing: &Bearing) -> Option<usize> {
    let body = bearing.body_of(Ring::Outer)?;
    let gear = host.gears.get(host.body_gears.get(body).copied().flatten()?)?.cylindrical()?;
    let is_raceway = matches!(gear.rim.support, BoreSupport::Raceway { .. });
    let has_mesh = matches!(plan.fidelity, Fidelity::Plane | Fidelity::Solid(_));
    (is_raceway && has_mesh && !plan.bodies.get(body)?.left_out).then_some(body)
}

/// Returns the attachments whose regions are raceways of a bearing, by their indices among the
/// bodies, with the rings.
fn on_seats(host: &ModelHost, plan: &Plan, bearing: &Bearing) -> Vec<(&'static str, usize)> {
    let has_seat = |body: usize| {
        let is_raceway =
            |connection: &ElasticConnection| connection.seats().iter().any(|seat| seat.body == body);
        let planned = host.scene.connections.iter().zip(&plan.connections);
        let mut modelled = planned.filter(|(_, planned)| !planned.left_out);
        modelled.any(|(connection, _)| is_raceway(connection))
    };
    let rings = [("outer", Ring::Outer), ("inner", Ring::Inner)];
    let on = rings.into_iter().filter_map(|(name, ring)| Some((name, bearing.body_of(ring)?)));
    on.filter(|(_, body)| plan.fidelity.has_elastic_rollers() && has_seat(*body)).collect()
}

/// Describes a linearized bearing.
fn linearized(Linearization { force: [x, y, z], range: [least, most], .. }: Linearization) -> String {
    let digits = |force: f64| format!("{force:.2e}").parse::<f64>().unwrap_or(force);
    format!(
        "a rolling bearing linearized at {} N: its stiffness is within {:.0} % from {} N to {} N",
        digits(x.hypot(y).hypot(z)),
        100.0 * RANGE_TOLERANCE,
        digits(least),
        digits(most)
    )
}

/// Describes a rolling bearing. `stated` has its load ratings C and C0 from a catalogue, N; others
/// are those of ISO 281 and ISO 76 for the internal geometry.
fn described(bearing: &RollingBearing, stated: Option<[f64; 2]>) -> String {
    let rows = bearing.rows();
    let Some(first) = rows.first() else { return String::new() };
    let mm = |metres: f64| rounded(1e3 * metres);
    let (kind, elements) = match &first.elements {
        Elements::Balls(balls) => {
            let g = balls.geometry();
            let kind = match g.kind {
                BallKind::DeepGroove { .. } => "deep groove ball bearing",
                BallKind::AngularContact { .. } => "angular contact ball bearing",
                BallKind::FourPoint { .. } => "four-point contact ball bearing",
            };
            (kind, format!("{} balls of {} mm", g.count, mm(g.ball_diameter)))
        }
        Elements::Rollers(rollers) => {
            let g = rollers.geometry();
            let kind = match g.kind {
                RollerKind::Cylindrical { .. } => "cylindrical roller bearing",
                RollerKind::Tapered { .. } => "tapered roller bearing",
                RollerKind::Spherical { .. } => "spherical roller bearing",
            };
            (kind, format!("{} rollers of {} mm x {} mm", g.count, mm(g.roller_diameter), mm(g.length)))
        }
    };
    let elements = if rows.len() > 1 { format!("{} rows of {elements}", rows.len()) } else { elements };
    let [dynamic, fixed] = stated.unwrap_or_else(|| {
        let computed = bearing_capacity(bearing);
        [computed.dynamic, computed.static_load]
    });
    // Computed ratings have no more than three digits of meaning.
    let kilo = |newtons: f64| format!("{:.2e}", 1e-3 * newtons).parse::<f64>().unwrap_or(1e-3 * newtons);
    format!("{kind}, {elements}, C = {} kN, C0 = {} kN", kilo(dynamic), kilo(fixed))
}
