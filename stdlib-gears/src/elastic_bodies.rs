//! Elastic bodies of a model: imported finite elements or matrices with their attachments, and the
//! elastic connection in the scene.
//!
//! Each attachment is a body of the scene, and the elastic body a connection between them. The
//! connection is replaced whenever an attachment is added, so the scene is complete at any time.
//! Nothing is condensed here.

use crate::assembly::add_body;
use crate::error::Refusal;
use calyx_abi::SymbolicValue;
use calyx_runtime::connection::ElasticConnection;
use calyx_runtime::elastic::attachment::{Attachment, Connection, Region};
use calyx_runtime::elastic::import::ImportReport;
use calyx_runtime::elastic_body::{ElasticBody, FiniteElementBody, MatrixBody, SharedElasticBody};
use calyx_runtime::error::EngineError;
use calyx_runtime::motion::{Motion, SteadyRotation, spatial_pose};
use calyx_runtime::rigid::RigidBody;
use calyx_runtime::scene::{Body, BodyId, ConnectionId, Scene};
use std::sync::Arc;

/// Elastic body in a model.
#[derive(Clone)]
pub struct ModelElasticBody {
    /// Name in results and messages.
    pub name: String,
    /// Its model, with the attachments so far.
    pub source: BodySource,
    /// Account of the import; `None` for a body that was not imported as finite elements.
    pub report: Option<ImportReport>,
    /// Prescribed motion of its coordinates.
    pub motion: Arc<dyn Motion>,
    /// Expression of the frame of its coordinates.
    pub frame: Arc<SymbolicValue>,
    /// Source location of the call that created it.
    pub place: (u32, u32, u32),
    /// Bodies of the scene, in the order of the attachments.
    pub attached: Vec<BodyId>,
    /// Elastic connection in the scene; `None` without attachments.
    pub connection: Option<ConnectionId>,
}

/// Model of an elastic body. A new kind of body is a new variant, or a generator of
/// [`FiniteElementBody`].
#[derive(Clone)]
pub enum BodySource {
    /// Finite elements.
    Elements(FiniteElementBody),
    /// Condensed matrices.
    Matrices(MatrixBody),
}

/// Part of a body that is attached.
#[derive(Clone, Debug, PartialEq)]
pub enum AttachedPart {
    /// Region of nodes.
    Region(Region),
    /// Node by its label: a number in a mesh, or a name.
    Node(String),
}

/// Request for an attachment.
#[derive(Clone, Debug, PartialEq)]
pub struct RequestedAttachment {
    /// Name in results and messages.
    pub name: String,
    /// The attached part.
    pub part: AttachedPart,
    /// Connection of the part to the attachment node.
    pub connection: Connection,
    /// Position of the attachment, m; `None` for the centre of the region.
    pub position: Option<[f64; 3]>,
}

impl BodySource {
    fn shared(&self) -> Arc<dyn ElasticBody> {
        match self {
            BodySource::Elements(body) => Arc::new(body.clone()),
            BodySource::Matrices(body) => Arc::new(body.clone()),
        }
    }

    /// Returns the body behind the interface of the engine.
    pub fn body(&self) -> &dyn ElasticBody {
        match self {
            BodySource::Elements(body) => body,
            BodySource::Matrices(body) => body,
        }
    }

    /// Adds an attachment and returns its position in the coordinates of the body, m.
    ///
    /// # Errors
    /// E0991: the attachment is impossible.
    pub fn attach(&mut self, requested: &RequestedAttachment) -> Result<[f64; 3], EngineError> {
        let RequestedAttachment { name, part, connection, position } = requested;
        match self {
            BodySource::Elements(body) => {
                let region = match part {
                    AttachedPart::Region(region) => region.clone(),
                    AttachedPart::Node(label) => Region::Labels(vec![label.parse().map_err(|_| {
                        let message = format!("attachment \"{name}\": a mesh has no node \"{label}\"");
                        EngineError::new("E0991", message, "nodes of a mesh are called by their numbers")
                    })?]),
                };
                let attachment = Attachment {
                    name: name.clone(),
                    position: *position,
                    region,
                    connection: connection.clone(),
                };
                body.attach(&attachment).map(|attached| attached.position)
            }
            BodySource::Matrices(body) => match part {
                AttachedPart::Node(label) | AttachedPart::Region(Region::Set(label)) => {
                    body.attach(name, label, *position)
                }
                AttachedPart::Region(_) => Err(EngineError::new(
                    "E0991",
                    format!("attachment \"{name}\": a condensed body has nodes, and no surfaces"),
                    "name the node, such as `region = gears.node(\"left\")`",
                )),
            },
        }
    }
}

impl ModelElasticBody {
    /// Closes an opening of the body where its surface radiates sound.
    ///
    /// # Errors
    /// E0991: the body has no such nodes, or no mesh.
    pub fn close(&mut self, scene: &mut Scene, name: String, part: &AttachedPart) -> Result<(), EngineError> {
        match (&mut self.source, part) {
            (BodySource::Elements(body), AttachedPart::Region(region)) => body.close(name, region)?,
            (BodySource::Elements(_), AttachedPart::Node(_)) => {
                let message = format!("opening \"{name}\": a single node is no rim");
                return Err(EngineError::new("E0991", message, "select all nodes of the rim"));
            }
            (BodySource::Matrices(_), _) => {
                let message = format!("opening \"{name}\": a condensed body has nodes, and no surfaces");
                return Err(EngineError::new("E0991", message, "leave the opening out"));
            }
        }
        if let Some(ConnectionId(index)) = self.connection {
            scene.connections[index].body = Some(SharedElasticBody(self.source.shared()));
        }
        Ok(())
    }

    /// Adds a panel of the surface of the body, whose contribution to its sound is of interest.
    ///
    /// # Errors
    /// E0991: the body has no such nodes, no mesh, or another panel of this name.
    pub fn add_panel(
        &mut self,
        scene: &mut Scene,
        name: String,
        part: &AttachedPart,
    ) -> Result<(), EngineError> {
        match (&mut self.source, part) {
            (BodySource::Elements(body), AttachedPart::Region(region)) => body.add_panel(name, region)?,
            (BodySource::Elements(_), AttachedPart::Node(_)) => {
                let message = format!("panel \"{name}\": a single node is no part of the surface");
                return Err(EngineError::new(
                    "E0991",
                    message,
                    "select all nodes of the elements of the panel",
                ));
            }
            (BodySource::Matrices(_), _) => {
                let message = format!("panel \"{name}\": a condensed body has nodes, and no surfaces");
                return Err(EngineError::new("E0991", message, "leave the panel out"));
            }
        }
        if let Some(ConnectionId(index)) = self.connection {
            scene.connections[index].body = Some(SharedElasticBody(self.source.shared()));
        }
        Ok(())
    }

    /// Returns the names of the panels of the body.
    pub fn panels(&self) -> Vec<String> {
        match &self.source {
            BodySource::Elements(body) => body.panels().map(str::to_owned).collect(),
            BodySource::Matrices(_) => Vec::new(),
        }
    }

    /// Adds an attachment to the body, as a body of the scene at this motion. If `fixed`, the
    /// attachment follows its motion exactly.
    ///
    /// # Errors
    /// Those of [`BodySource::attach`], [`add_body`] and [`ElasticConnection::check`]; E0671 if the
    /// scene has another connection of the name.
    pub fn attach(
        &mut self,
        scene: &mut Scene,
        requested: &RequestedAttachment,
        (motion, fixed): (Arc<dyn Motion>, bool),
    ) -> Result<BodyId, Refusal> {
        let mut source = self.source.clone();
        source.attach(requested)?;
        let body = Body::new(requested.name.clone(), Arc::new(RigidBody), SteadyRotation::at_rest([0.0; 2]));
        let body = add_body(scene, Body { motion, free: [!fixed; 6], ..body })?;
        let attached: Vec<BodyId> = self.attached.iter().copied().chain([body]).collect();
        let origin = spatial_pose(self.motion.as_ref(), 0.0)?.origin;
        let connection = ElasticConnection::of_body(self.name.clone(), source.shared(), &attached, origin);
        match self.connection {
            None => self.connection = Some(scene.add_connection(connection)?),
            Some(ConnectionId(index)) => {
                connection.check(&scene.bodies)?;
                scene.connections[index] = connection;
            }
        }
        (self.source, self.attached) = (source, attached);
        Ok(body)
    }
}
