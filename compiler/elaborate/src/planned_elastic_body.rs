//! Elastic bodies in the display of a plan: their size, mass, attachments, and the account of their
//! import.

use crate::shown::{grouped, of_thousands, rounded};
use calyx_gears::elastic_bodies::{BodySource, ModelElasticBody};
use calyx_gears::host::{LengthUnit, ModelHost};
use calyx_runtime::elastic::attachment::Connection;
use calyx_runtime::elastic::import::ImportReport;
use calyx_runtime::elastic_body::{
    BodyAttachment, ElasticBody, ElasticBodySize, SeatRaceway, SharedElasticBody,
};
use calyx_runtime::plan::Plan;
use calyx_runtime::scene::{BodyId, ConnectionId};

/// An elastic body of any shape.
#[derive(Clone, Debug, PartialEq)]
pub struct PlannedElasticBody {
    pub name: String,
    /// Title of its file, and what its import skipped or interpreted.
    pub import: Option<ImportReport>,
    pub size: ElasticBodySize,
    /// Centre of mass in the coordinates of the file, as text.
    pub centre: String,
    /// The attachments, each with its nodes and its connection.
    pub attachments: Vec<String>,
    /// `true` if it is condensed, `false` if it is rigid at this fidelity.
    pub condensed: bool,
    pub left_out: bool,
    /// The reason for its model, or for omitting it.
    pub reason: &'static str,
}

impl PlannedElasticBody {
    pub(crate) fn all(host: &ModelHost, plan: &Plan) -> Vec<PlannedElasticBody> {
        let of = |body: &ModelElasticBody| {
            let planned = body.connection.and_then(|connection| plan.connections.get(connection.0));
            let size = body.source.body().size().unwrap_or_default();
            PlannedElasticBody {
                name: body.name.clone(),
                import: body.report.clone(),
                size,
                centre: position(size.centre, host.length_unit),
                attachments: attachments(host, body),
                condensed: plan.fidelity.name() != "rigid",
                left_out: planned.is_none_or(|planned| planned.left_out),
                reason: planned.map_or("left out: it has no attachments", |planned| planned.reason),
            }
        };
        let of_carrier = |(connection, body): (ConnectionId, &dyn ElasticBody)| {
            let planned = plan.connections.get(connection.0);
            let size = body.size().unwrap_or_default();
            PlannedElasticBody {
                name: host.scene.connections[connection.0].name.clone(),
                import: None,
                size,
                centre: position(size.centre, host.length_unit),
                attachments: attachments_of_carrier(host, connection, body),
                condensed: plan.fidelity.name() != "rigid",
                left_out: planned.is_none_or(|planned| planned.left_out),
                reason: planned.map_or("", |planned| planned.reason),
            }
        };
        let imported = host.elastic_bodies.iter().map(of);
        imported.chain(carriers(host).map(of_carrier)).collect()
    }

    pub(crate) fn lines(&self) -> Vec<String> {
        let ElasticBodySize { elements, nodes, dofs, retained, mass, .. } = self.size;
        let of_elements = match elements {
            0 => String::new(),
            count => format!("{} elements, ", grouped(count)),
        };
        let mut lines = vec![format!(
            "\"{}\": {of_elements}{} nodes, {} degrees of freedom",
            self.name,
            grouped(nodes),
            grouped(dofs)
        )];
        lines.push(format!("  {}", self.reason));
        if let Some(mass) = mass {
            lines.push(format!("  mass {} kg, centre of mass at {}", rounded(mass), self.centre));
        }
        lines.extend(self.attachments.iter().map(|attachment| format!("  {attachment}")));
        if self.condensed && elements > 0 {
            let operations =
                of_thousands(self.size.operations(), [" thousand", " million", " billion", " trillion"]);
            let bytes = of_thousands(self.size.bytes(), [" kB", " MB", " GB", " TB"]);
            lines.push(format!(
                "  condensed to {retained} attachment components: about {operations} multiplications, {bytes}"
            ));
        }
        if let Some(report) = &self.import {
            let skipped = report.skipped.iter().map(|skipped| {
                format!(
                    "  not read: {} ({} times, first in {}, line {})",
                    skipped.name, skipped.count, skipped.file, skipped.line
                )
            });
            lines.extend(skipped);
            lines.extend(report.notes.iter().map(|note| format!("  note: {note}")));
        }
        lines
    }
}

fn attachments(host: &ModelHost, body: &ModelElasticBody) -> Vec<String> {
    let how = |attachment: &BodyAttachment| match &attachment.connection {
        Connection::Rigid => "rigid".to_owned(),
        Connection::Average => "average".to_owned(),
        Connection::Raceway { .. } => {
            attachment.raceway.map_or_else(String::new, |SeatRaceway { raceway, .. }| {
                let length = match raceway.ends[1] - raceway.ends[0] {
                    0.0 => " it".to_owned(),
                    length => {
                        let LengthUnit { name, metres } = host.length_unit;
                        format!(" its {} {name}", rounded(length / metres))
                    }
                };
                let (harmonics, degree) = (raceway.harmonics, raceway.degree);
                format!("raceway of {harmonics} harmonics and the degree {degree} along{length}")
            })
        }
        Connection::Fourier { harmonics, .. } => {
            let orders: Vec<String> = harmonics.iter().map(u32::to_string).collect();
            format!("Fourier surface of the orders {}", orders.join(", "))
        }
    };
    let parts: Vec<String> = match &body.source {
        BodySource::Elements(elements) => {
            let of = elements.attachments().iter().map(|attachment| match attachment.nodes.len() {
                1 => "1 node".to_owned(),
                count => format!("{} nodes, {}", grouped(count), how(attachment)),
            });
            of.collect()
        }
        BodySource::Matrices(matrices) => vec!["a node".into(); matrices.positions().len()],
    };
    let bodies = &host.scene.bodies;
    let of = |((id, part), at): ((&BodyId, String), [f64; 3])| {
        let Some(attached) = bodies.get(id.0) else { return String::new() };
        let fixed = if attached.free.contains(&true) { "" } else { ", fixed" };
        format!("\"{}\": {part}{fixed}, at {}", attached.name, position(at, host.length_unit))
    };
    body.attached.iter().zip(parts).zip(body.source.body().positions()).map(of).collect()
}

/// Returns the bodies that the program generates, with their connections.
fn carriers(host: &ModelHost) -> impl Iterator<Item = (ConnectionId, &dyn ElasticBody)> {
    let is_imported = |id: ConnectionId| host.elastic_bodies.iter().any(|body| body.connection == Some(id));
    host.scene.connections.iter().enumerate().filter_map(move |(index, connection)| {
        let SharedElasticBody(body) = connection.body.as_ref()?;
        let id = ConnectionId(index);
        (!is_imported(id)).then_some((id, body.as_ref()))
    })
}

fn attachments_of_carrier(host: &ModelHost, id: ConnectionId, body: &dyn ElasticBody) -> Vec<String> {
    let bodies = host.scene.connections[id.0].bodies();
    let of = |(id, at): (BodyId, [f64; 3])| {
        let attached = host.scene.bodies.get(id.0)?;
        let fixed = if attached.free.contains(&true) { "" } else { ", fixed" };
        Some(format!("\"{}\": rigid{fixed}, at {}", attached.name, position(at, host.length_unit)))
    };
    bodies.zip(body.positions()).filter_map(of).collect()
}

/// Formats a position in the unit of the model.
fn position(at: [f64; 3], LengthUnit { name, metres }: LengthUnit) -> String {
    let [x, y, z] = at.map(|part| rounded((part / metres * 1e4).round() / 1e4 + 0.0));
    format!("({x}, {y}, {z}) {name}")
}
