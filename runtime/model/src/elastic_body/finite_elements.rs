//! Elastic body as finite elements with attachments.

use super::condensation::{condense_model, shapes_of_model};
use super::raceway::{Fit, SeatRaceway, SeatRegion};
use super::supports::{SupportRow, on_ground, resisted, support_rows};
use super::{
    AttachmentExtent, BodyMesh, CellShape, ElasticBody, ElasticBodySize, MassReduction, MotionShapes,
    Opening, Panel, Recovery,
};
use calyx_elastic::attachment::{Attachment, Connection, Region, attach_unnamed, on_a_line, rotating_nodes};
use calyx_elastic::connectivity::parts_with_elements;
use calyx_elastic::import::{MassProperties, mass_properties};
use calyx_elastic::{Constraint, ElasticModel, Element, ElementError, ElementKind, NodalLoad};
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::vec3::{Vector, length, minus};
use calyx_structure::AttachmentMatrices;
use calyx_structure::cache::{Key, KeyWriter};
use calyx_structure::outer_surface::{OuterSurface, Skin};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Distance of a position from a node, relative to the elements at the node, up to which they are
/// the same.
const SAME_POINT: f64 = 1e-3;

/// Finite-element model with attachments. Copies share the model.
#[derive(Clone)]
pub struct FiniteElementBody {
    model: Arc<ElasticModel>,
    content: Key,
    mass: MassProperties,
    attachments: Vec<BodyAttachment>,
    openings: Vec<Opening>,
    panels: Vec<Panel>,
}

/// Attachment of a body with the nodes of its region.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyAttachment {
    /// Name.
    pub name: String,
    /// Position of the attachment node, m.
    pub position: Vector,
    /// Indices of the nodes of the region, ascending. A single node is the attachment node itself.
    pub nodes: Vec<usize>,
    /// Connection of the region to the attachment node.
    pub connection: Connection,
    /// Extent of the region.
    pub extent: AttachmentExtent,
    /// Raceway that the region is, if any.
    pub raceway: Option<SeatRaceway>,
}

impl BodyAttachment {
    fn seat(&self) -> SeatRegion<'_> {
        SeatRegion { nodes: &self.nodes, position: self.position, cylinder: self.extent.cylinder }
    }
}

impl FiniteElementBody {
    /// Creates a body without attachments from a model. Models with equal `content` keys must be
    /// equal.
    pub fn new(model: Arc<ElasticModel>, content: Key) -> FiniteElementBody {
        let mass = mass_properties(&model);
        FiniteElementBody {
            model,
            content,
            mass,
            attachments: Vec::new(),
            openings: Vec::new(),
            panels: Vec::new(),
        }
    }

    /// Returns the model, without attachments.
    pub fn model(&self) -> &ElasticModel {
        &self.model
    }

    /// Returns mass, centre of mass and inertia about the origin of the model.
    pub fn mass(&self) -> &MassProperties {
        &self.mass
    }

    /// Returns the attachments.
    pub fn attachments(&self) -> &[BodyAttachment] {
        &self.attachments
    }

    /// Adds an attachment. Its region is found once; a region of one node is attached at this node.
    ///
    /// # Errors
    /// E0991: the region contains no nodes, its nodes lie on a line or do not resist rotation, or a
    /// node depends on another constraint already.
    pub fn attach(&mut self, attachment: &Attachment) -> Result<&BodyAttachment, EngineError> {
        let found = self.found(attachment).map_err(|error| {
            let message = format!("attachment \"{}\": {}", attachment.name, error.message);
            EngineError::new("E0991", message, error.help)
        })?;
        self.attachments.push(found);
        Ok(&self.attachments[self.attachments.len() - 1])
    }

    /// Adds an opening that a lid closes where the surface of the body radiates sound: the nodes of
    /// its rim, or of a bore between two rims.
    ///
    /// # Errors
    /// E0991: the body has an opening of this name, or the region contains fewer than three nodes.
    pub fn close(&mut self, name: String, region: &Region) -> Result<(), EngineError> {
        let refused = |message: String, help: String| {
            EngineError::new("E0991", format!("opening \"{name}\": {message}"), help)
        };
        if self.openings.iter().any(|opening| opening.name == name) {
            let message = "the body has another opening of this name".into();
            return Err(refused(message, "rename one of them".into()).blame("name"));
        }
        let nodes = region.nodes(&self.model).map_err(|error| refused(error.message, error.help))?;
        if nodes.len() < 3 {
            return Err(refused(
                format!("its region has {} nodes, and a rim has at least three", nodes.len()),
                "select all nodes of the rim".into(),
            ));
        }
        self.openings.push(Opening { name, nodes });
        Ok(())
    }

    /// Adds a panel: the part of the surface whose elements have all nodes in a region.
    ///
    /// # Errors
    /// E0991: the body has a panel of this name, or the region contains fewer than three nodes.
    pub fn add_panel(&mut self, name: String, region: &Region) -> Result<(), EngineError> {
        let refused = |message: String, help: String| {
            EngineError::new("E0991", format!("panel \"{name}\": {message}"), help)
        };
        if self.panels.iter().any(|panel| panel.name == name) {
            return Err(refused(
                "the body has another panel of this name".into(),
                "rename one of them".into(),
            )
            .blame("name"));
        }
        if name == Panel::REST {
            let message = "the surface that belongs to no panel has this name in results".into();
            return Err(refused(message, "rename the panel".into()).blame("name"));
        }
        let nodes = region.nodes(&self.model).map_err(|error| refused(error.message, error.help))?;
        if nodes.len() < 3 {
            return Err(refused(
                format!("its region has {} nodes, and an element has at least three", nodes.len()),
                "select all nodes of the elements of the panel".into(),
            ));
        }
        self.panels.push(Panel { name, nodes });
        Ok(())
    }

    /// Returns the names of the panels.
    pub fn panels(&self) -> impl Iterator<Item = &str> {
        self.panels.iter().map(|panel| panel.name.as_str())
    }

    fn found(&self, attachment: &Attachment) -> Result<BodyAttachment, ElementError> {
        let nodes = attachment.region.nodes(&self.model)?;
        let at = |node: usize| self.model.nodes[node].position;
        let (connection, name) = (attachment.connection.clone(), attachment.name.clone());
        let extent = AttachmentExtent::of_nodes(&self.model, &attachment.region, &nodes);
        if let [node] = nodes[..] {
            self.check_single(node)?;
            check_near(attachment, (self.model.nodes[node].label, at(node)), extent.size)?;
            let found = BodyAttachment { name, position: at(node), nodes, connection, extent, raceway: None };
            Fit::new(&self.model, &found.seat(), &found.connection)?;
            return Ok(found);
        }
        let count = nodes.len() as f64;
        let mean: Vector =
            std::array::from_fn(|k| nodes.iter().map(|&node| at(node)[k]).sum::<f64>() / count);
        let positions: Vec<Vector> = nodes.iter().map(|&node| at(node)).collect();
        let resists = connection == Connection::Rigid || connection.is_average();
        if on_a_line(&positions) && !(resists && self.rotates(&nodes)) {
            return Err(ElementError::new(
                format!("its {} nodes lie on a line, about which they do not resist rotation", nodes.len()),
                "select nodes that span an area, or the reference node of a rigid element of the file",
            ));
        }
        self.check_averages(&nodes, &connection)?;
        if !connection.is_average() {
            self.check_independent(&nodes)?;
        }
        // Checks the connection itself, such as the harmonics of a surface.
        let position = attachment.position.unwrap_or_else(|| middle(&attachment.region).unwrap_or(mean));
        let mut found = BodyAttachment { name, position, nodes, connection, extent, raceway: None };
        if let Connection::Fourier { .. } = found.connection {
            self.attached(std::slice::from_ref(&found))?;
        }
        found.raceway = Fit::new(&self.model, &found.seat(), &found.connection)?.map(|fit| fit.seat);
        Ok(found)
    }

    /// Returns whether a node of these has stiffness against rotation.
    fn rotates(&self, nodes: &[usize]) -> bool {
        let rotating = rotating_nodes(&self.model);
        nodes.iter().any(|&node| rotating[node])
    }

    /// Checks that a single node can be an attachment.
    fn check_single(&self, node: usize) -> Result<(), ElementError> {
        let label = self.model.nodes[node].label;
        if let Some(other) = self.attachments.iter().find(|other| other.nodes == [node]) {
            return Err(ElementError::new(
                format!("node {label} is the attachment \"{}\" already", other.name),
                "use that attachment",
            ));
        }
        let rigid = self.attachments.iter().filter(|other| !other.connection.is_average());
        if let Some(other) = rigid.into_iter().find(|other| other.nodes.binary_search(&node).is_ok()) {
            return Err(ElementError::new(
                format!("node {label} belongs to the attachment \"{}\", which moves it rigidly", other.name),
                "use that attachment, or leave the node out of its region",
            ));
        }
        if self.fixed_nodes().any(|fixed| fixed == node) {
            return Err(ElementError::new(
                format!("node {label} is fixed in the file"),
                "remove the support from the file: what it is attached to supports it",
            ));
        }
        let constrained = self.model.constraints.iter().any(|constraint| match constraint {
            Constraint::Rigid { reference, dependents, .. } => {
                *reference == node || dependents.iter().any(|(dependent, _)| *dependent == node)
            }
            Constraint::WeightedAverage { reference, .. } => *reference == node,
            Constraint::Equation { .. } => false,
        });
        if constrained || self.rotates(&[node]) {
            return Ok(());
        }
        Err(ElementError::new(
            format!("it is the single node {label}, which does not resist rotation"),
            "select several nodes that span an area, or the reference node of a rigid element of the file",
        ))
    }

    /// Checks that no average is determined by a rigid attachment, or equal to another average.
    fn check_averages(&self, nodes: &[usize], connection: &Connection) -> Result<(), ElementError> {
        let within =
            |all: &[usize], nodes: &[usize]| nodes.iter().all(|node| all.binary_search(node).is_ok());
        let average = Connection::is_average;
        let determined = self.attachments.iter().find(|other| {
            average(connection) && within(&other.nodes, nodes) && !average(&other.connection)
                || average(&other.connection) && within(nodes, &other.nodes) && !average(connection)
                || average(connection) && average(&other.connection) && other.nodes == nodes
        });
        match determined {
            None => Ok(()),
            Some(other) => Err(ElementError::new(
                format!("all of its nodes belong to the attachment \"{}\", or the reverse", other.name),
                "attach each region once, and mount everything on this attachment",
            )),
        }
    }

    /// Checks that no constraint or support determines the nodes of a rigid or Fourier attachment.
    fn check_independent(&self, nodes: &[usize]) -> Result<(), ElementError> {
        let label = |node: usize| self.model.nodes[node].label;
        let within = |node: &usize| nodes.binary_search(node).is_ok();
        // A single node is the attachment node itself, whatever its connection.
        let rigid = |other: &&BodyAttachment| !other.connection.is_average() || other.nodes.len() == 1;
        for other in self.attachments.iter().filter(rigid) {
            if let Some(&node) = other.nodes.iter().find(|node| within(node)) {
                let shared = other.nodes.iter().filter(|node| within(node)).count();
                return Err(ElementError::new(
                    format!(
                        "{shared} of its nodes, such as node {}, belong to the attachment \"{}\", which moves them rigidly",
                        label(node),
                        other.name
                    ),
                    "let the regions have no common nodes, or connect one of them with `how = \"average\"`",
                ));
            }
        }
        let dependent = self.model.constraints.iter().flat_map(|constraint| match constraint {
            Constraint::Rigid { dependents, .. } => dependents.iter().map(|(node, _)| *node).collect(),
            Constraint::WeightedAverage { reference, .. } => vec![*reference],
            Constraint::Equation { terms, .. } => terms.first().map(|term| term.0).into_iter().collect(),
        });
        if let Some(node) = dependent.into_iter().find(within) {
            return Err(ElementError::new(
                format!("a constraint of the file determines its node {}", label(node)),
                "leave the node out of the region, or connect the region with `how = \"average\"`",
            ));
        }
        match self.fixed_nodes().find(within) {
            Some(node) => Err(ElementError::new(
                format!("its node {} is fixed in the file", label(node)),
                "leave the node out of the region, or remove the support from the file",
            )),
            None => Ok(()),
        }
    }

    fn fixed_nodes(&self) -> impl Iterator<Item = usize> {
        self.model.fixed.iter().filter(|fixed| fixed.components.contains(&true)).map(|fixed| fixed.node)
    }

    /// Returns the load cases of unit coefficients of all raceways; `nodes` are those of the
    /// attachments in the model with these.
    fn raceway_cases(
        &self,
        model: &ElasticModel,
        nodes: &[usize],
    ) -> Result<Vec<Vec<NodalLoad>>, EngineError> {
        let mut cases = Vec::new();
        for (attachment, &reference) in self.attachments.iter().zip(nodes) {
            let fit = Fit::new(&self.model, &attachment.seat(), &attachment.connection)
                .map_err(|error| EngineError::new("E0991", error.message, error.help))?;
            cases.extend(fit.iter().flat_map(|fit| fit.cases(model, &attachment.nodes, reference)));
        }
        Ok(cases)
    }

    /// Returns the model with these attachments, and their nodes.
    fn attached(&self, attachments: &[BodyAttachment]) -> Result<(ElasticModel, Vec<usize>), ElementError> {
        let mut model = ElasticModel::clone(&self.model);
        // Supports do not move, as `ignored` states.
        model.fixed.iter_mut().for_each(|fixed| fixed.value = 0.0);
        let mut nodes = Vec::new();
        for attachment in attachments {
            if let [node] = attachment.nodes[..] {
                nodes.push(node);
                continue;
            }
            let added = attach_unnamed(
                &mut model,
                &Attachment {
                    name: attachment.name.clone(),
                    position: Some(attachment.position),
                    region: Region::Nodes(attachment.nodes.clone()),
                    connection: attachment.connection.clone(),
                },
            )?;
            nodes.extend(added.first());
        }
        Ok((model, nodes))
    }
}

impl ElasticBody for FiniteElementBody {
    fn positions(&self) -> Vec<Vector> {
        self.attachments.iter().map(|attachment| attachment.position).collect()
    }

    fn extents(&self) -> Vec<AttachmentExtent> {
        self.attachments.iter().map(|attachment| attachment.extent).collect()
    }

    fn raceways(&self) -> Vec<Option<SeatRaceway>> {
        self.attachments.iter().map(|attachment| attachment.raceway).collect()
    }

    fn is_grounded(&self) -> bool {
        self.fixed_nodes().next().is_some()
            || self.model.elements.iter().any(|element| on_ground(element).is_some())
    }

    fn resisted_motions(&self) -> Option<Vec<SupportRow>> {
        resisted(&support_rows(&self.model), self.typical_size())
    }

    fn key(&self) -> Option<Key> {
        let key = Key::of("elastic body").text(calyx_elastic::SOURCE).text(crate::SOURCE).key(&self.content);
        Some(self.attachments.iter().fold(key, written).finish())
    }

    fn check(&self) -> Result<(), EngineError> {
        let mut held = vec![false; self.model.nodes.len()];
        let springs = self.model.elements.iter().filter_map(on_ground);
        let attached = self.attachments.iter().flat_map(|attachment| attachment.nodes.iter().copied());
        let nodes = attached.chain(self.fixed_nodes()).chain(springs.map(|(node, _)| node));
        nodes.for_each(|node| held[node] = true);
        let parts = parts_with_elements(&self.model).into_iter();
        let loose = parts.into_iter().find(|nodes| !nodes.iter().any(|&node| held[node]));
        let Some(nodes) = loose else { return Ok(()) };
        Err(EngineError::new(
            "E0992",
            format!(
                "a part of {} nodes, with node {}, is connected neither to an attachment nor to ground",
                nodes.len(),
                self.model.nodes[nodes[0]].label
            ),
            "merge the nodes of both parts, connect them in the file, or attach the part or leave it out",
        ))
    }

    fn condense(
        &self,
        mass: MassReduction,
        interrupt: &Interrupt,
    ) -> Result<AttachmentMatrices, EngineError> {
        let (model, nodes) = self
            .attached(&self.attachments)
            .map_err(|error| EngineError::new("E0991", error.message, error.help))?;
        let cases = self.raceway_cases(&model, &nodes)?;
        condense_model(&model, &nodes, &cases, (self.is_grounded(), mass), interrupt)
    }

    fn recovery(&self, interrupt: &Interrupt) -> Result<Option<Recovery>, EngineError> {
        let (model, nodes) = self
            .attached(&self.attachments)
            .map_err(|error| EngineError::new("E0991", error.message, error.help))?;
        let cases = self.raceway_cases(&model, &nodes)?;
        Recovery::new(model, nodes, &cases, self.model.nodes.len(), interrupt).map(Some)
    }

    fn mesh(&self) -> Option<BodyMesh> {
        let cell = |element: &Element| Some((CellShape::of(element)?, element.nodes.clone()));
        Some(BodyMesh {
            points: self.model.nodes.iter().map(|node| node.position).collect(),
            labels: self.model.nodes.iter().map(|node| node.label).collect(),
            cells: self.model.elements.iter().filter_map(cell).collect(),
            openings: self.openings.clone(),
            panels: self.panels.clone(),
        })
    }

    fn motion_shapes(
        &self,
        mass: MassReduction,
        nodes: &[usize],
        interrupt: &Interrupt,
    ) -> Result<Option<MotionShapes>, EngineError> {
        let (model, attached) = self
            .attached(&self.attachments)
            .map_err(|error| EngineError::new("E0991", error.message, error.help))?;
        shapes_of_model(&model, &attached, mass, nodes, interrupt).map(Some)
    }

    fn outer_surface(&self) -> Option<OuterSurface> {
        let elements = self.model.elements.iter().enumerate();
        let cells =
            elements.filter_map(|(index, element)| Some(CellShape::of(element)?.cell(&element.nodes, index)));
        let points: Vec<Vector> = self.model.nodes.iter().map(|node| node.position).collect();
        Some(Skin::new(cells, |_| false).at(&points))
    }

    fn has_mass(&self) -> bool {
        self.mass.mass > 0.0
    }

    fn typical_stiffness(&self) -> f64 {
        let moduli = self.model.materials.iter().map(|material| material.youngs_modulus);
        // A body of springs alone has no material.
        let modulus = Some(moduli.fold(0.0, f64::max)).filter(|modulus| *modulus > 0.0).unwrap_or(2e11);
        modulus * self.typical_size()
    }

    fn typical_size(&self) -> f64 {
        extent(self.model.nodes.iter().map(|node| node.position))
    }

    fn size(&self) -> Option<ElasticBodySize> {
        let mut stiff: BTreeMap<usize, usize> = BTreeMap::new();
        for element in &self.model.elements {
            let components = if let ElementKind::Solid(_) = element.kind { 3 } else { 6 };
            for &node in &element.nodes {
                let known = stiff.entry(node).or_default();
                *known = components.max(*known);
            }
        }
        Some(ElasticBodySize {
            elements: self.model.elements.len(),
            nodes: stiff.len(),
            dofs: stiff.values().sum(),
            retained: 6 * self.attachments.len()
                + self.raceways().iter().flatten().map(|seat| seat.raceway.terms()).sum::<usize>(),
            revolved: false,
            mass: Some(self.mass.mass),
            centre: self.mass.centre,
        })
    }

    fn ignored(&self) -> Vec<String> {
        let mut ignored = Vec::new();
        if !self.model.loads.is_empty() {
            let count = match self.model.loads.len() {
                1 => "the load".to_owned(),
                count => format!("the {count} loads"),
            };
            ignored.push(format!("{count} of the file: loads act on bodies and attachments of the model"));
        }
        if self.model.fixed.iter().any(|fixed| fixed.value != 0.0) {
            ignored.push("the values of prescribed displacements of the file: its supports are fixed".into());
        }
        ignored
    }
}

/// Checks that a single node is where the attachment asks for it: `size` is that of the elements at
/// the node, m.
fn check_near(attachment: &Attachment, (label, at): (u64, Vector), size: f64) -> Result<(), ElementError> {
    let mm = |metres: f64| (metres * 1e6).round() / 1e3 + 0.0;
    let [x, y, z] = at.map(mm);
    let node = format!("node {label} at ({x}, {y}, {z}) mm");
    if let Region::Nearest(point) = attachment.region {
        let distance = length(minus(at, point));
        if distance > size {
            return Err(ElementError::new(
                format!(
                    "the nearest node is {node}, {} mm away from the point, and the elements there have {} mm",
                    mm(distance),
                    mm(size)
                ),
                "give a point of the body in the coordinates of the file, or name the node by `gears.node`",
            ));
        }
    }
    match attachment.position.map(|position| length(minus(at, position))) {
        Some(distance) if distance > SAME_POINT * size => Err(ElementError::new(
            format!("its position is {} mm away from its single {node}", mm(distance)),
            "leave `position` out: a single node is attached where it is",
        )),
        _ => Ok(()),
    }
}

/// Returns whether an element is a spring on ground.
fn written(key: KeyWriter, attachment: &BodyAttachment) -> KeyWriter {
    let key = key.numbers(&attachment.position).count(attachment.nodes.len() as u64);
    let key = attachment.nodes.iter().fold(key, |key, &node| key.count(node as u64));
    match &attachment.connection {
        Connection::Rigid => key.text("rigid"),
        Connection::Average => key.text("average"),
        Connection::Raceway { .. } => match &attachment.raceway {
            Some(SeatRaceway { raceway, axes, .. }) => axes
                .iter()
                .fold(key.text("raceway"), |key, axis| key.numbers(axis))
                .numbers(&raceway.ends)
                .number(raceway.radius)
                .count(u64::from(raceway.harmonics))
                .count(u64::from(raceway.degree)),
            None => key.text("average"),
        },
        Connection::Fourier { axis, harmonics } => {
            let key = key.text("fourier").numbers(axis).count(harmonics.len() as u64);
            harmonics.iter().fold(key, |key, &harmonic| key.count(u64::from(harmonic)))
        }
    }
}

/// Returns the middle of a cylinder on its axis, which does not depend on the spacing of the nodes;
/// `None` for other regions.
fn middle(region: &Region) -> Option<Vector> {
    let Region::Cylinder { origin, axis, heights: [from, to], .. } = region else { return None };
    let size = length(*axis);
    Some(std::array::from_fn(|k| origin[k] + 0.5 * (from + to) * axis[k] / size))
}

/// Returns the diagonal of the box that contains these positions, m.
pub(super) fn extent(positions: impl Iterator<Item = Vector>) -> f64 {
    let mut ends = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
    for position in positions {
        for k in 0..3 {
            ends[0][k] = ends[0][k].min(position[k]);
            ends[1][k] = ends[1][k].max(position[k]);
        }
    }
    let diagonal = length(minus(ends[1], ends[0]));
    if diagonal.is_finite() && diagonal > 0.0 { diagonal } else { 0.1 }
}
