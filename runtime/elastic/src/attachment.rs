//! Attachment nodes: node sets by name or geometry, connected rigidly, by weighted average or as a
//! Fourier surface.

use crate::connectivity::nodes_of;
use crate::error::ElementError;
use crate::model::{Components, Constraint, ElasticModel, ElementKind, Node};
use nalgebra::Vector3;
use std::collections::HashSet;
use std::f64::consts::{PI, TAU};

/// Region of nodes.
#[derive(Clone, Debug, PartialEq)]
pub enum Region {
    /// Named set of the model.
    Set(String),
    /// Nodes with these labels.
    Labels(Vec<u64>),
    /// Nodes with these indices.
    Nodes(Vec<usize>),
    /// Cylinder about an axis.
    Cylinder {
        /// Point on the axis, from which heights count.
        origin: [f64; 3],
        /// Direction of the axis.
        axis: [f64; 3],
        /// Radius, m.
        radius: f64,
        /// Lowest and highest position along the axis, m.
        heights: [f64; 2],
        /// Largest distance from the cylinder and from the ends, m.
        tolerance: f64,
    },
    /// Plane.
    Plane {
        /// Point on the plane.
        origin: [f64; 3],
        /// Normal.
        normal: [f64; 3],
        /// Largest distance, m.
        tolerance: f64,
    },
    /// Ball: the nodes within a radius (m) of a point.
    Sphere {
        /// Centre.
        centre: [f64; 3],
        /// Radius, m.
        radius: f64,
    },
    /// Box along the basic axes, with its boundary.
    Box {
        /// Smallest coordinates, m.
        lowest: [f64; 3],
        /// Largest coordinates, m.
        highest: [f64; 3],
    },
    /// The node nearest to a point; of equally near ones the first.
    Nearest([f64; 3]),
}

/// Connection of a region to its attachment node.
#[derive(Clone, Debug, PartialEq)]
pub enum Connection {
    /// The nodes move with the attachment node as a rigid body.
    Rigid,
    /// The attachment node follows the mean motion of the nodes, which can deform.
    Average,
    /// As [`Connection::Average`], and the nodes form a cylinder that is the raceway of a bearing:
    /// its radial displacement is a series, Fourier around the axis and Legendre along it.
    Raceway {
        /// Highest harmonic around the axis; `None` for the highest one that the nodes resolve.
        harmonics: Option<u16>,
        /// Highest degree of the polynomials along it.
        degree: u8,
    },
    /// The nodes move with the attachment node, and their displacements along and around the axis
    /// and radially are Fourier series of the angle about it. Harmonic 0 is radial expansion;
    /// harmonic 1 is the rigid motion.
    Fourier {
        /// Axis of the surface through the attachment node.
        axis: [f64; 3],
        /// Orders: 0, or at least 2.
        harmonics: Vec<u32>,
    },
}

impl Connection {
    /// Returns whether the attachment node follows the mean motion of the nodes, which move freely.
    pub fn is_average(&self) -> bool {
        matches!(self, Connection::Average | Connection::Raceway { .. })
    }
}

/// Attachment of a body.
#[derive(Clone, Debug, PartialEq)]
pub struct Attachment {
    /// Name, for messages and as the name of a node set.
    pub name: String,
    /// Position of the attachment node, m; `None` selects the centre of the region.
    pub position: Option<[f64; 3]>,
    /// Nodes that are connected.
    pub region: Region,
    /// Connection.
    pub connection: Connection,
}

/// Unit vectors along the basic axes.
const BASIC: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

impl Region {
    /// Returns the indices of the nodes of a region, ascending.
    ///
    /// # Errors
    /// The region contains no node, or a set or label does not exist.
    pub fn nodes(&self, model: &ElasticModel) -> Result<Vec<usize>, ElementError> {
        // Nodes that nothing refers to, such as construction points of a mesher, are no part of a
        // region.
        let is_geometric = !matches!(self, Self::Set(_) | Self::Labels(_) | Self::Nodes(_));
        let elements = model.elements.iter().flat_map(|element| &element.nodes).copied();
        let constraints = model.constraints.iter().flat_map(nodes_of);
        let used: HashSet<usize> = elements.chain(constraints).filter(|_| is_geometric).collect();
        let is_used = |index: usize| used.contains(&index) || model.elements.is_empty();
        let spatial = || {
            let nodes = model.nodes.iter().enumerate();
            nodes.filter(|&(index, node)| is_spatial(node) && is_used(index))
        };
        let nodes = match self {
            Self::Set(name) => model.sets.get(name).cloned().ok_or_else(|| {
                let names: Vec<&str> = model.sets.keys().map(String::as_str).collect();
                ElementError::new(
                    format!("the body has no node set `{name}`"),
                    format!("name one of its sets: {}", names.join(", ")),
                )
            })?,
            Self::Labels(labels) => {
                let find = |label: &u64| {
                    model.nodes.iter().position(|node| node.label == *label).ok_or_else(|| {
                        ElementError::new(format!("the body has no node {label}"), "name nodes of the body")
                    })
                };
                labels.iter().map(find).collect::<Result<Vec<_>, _>>()?
            }
            Self::Nodes(indices) => match indices.iter().find(|&&index| index >= model.nodes.len()) {
                Some(index) => {
                    return Err(ElementError::new(
                        format!("the body has no node of index {index}"),
                        "give indices of its nodes",
                    ));
                }
                None => indices.clone(),
            },
            Self::Nearest(_) => {
                let mut nearest: Option<(usize, f64)> = None;
                for (index, node) in spatial() {
                    let distance = self.distance(node.position)?;
                    if nearest.is_none_or(|(_, least)| distance < least) {
                        nearest = Some((index, distance));
                    }
                }
                nearest.map(|(index, _)| index).into_iter().collect()
            }
            Self::Cylinder { .. } | Self::Plane { .. } | Self::Sphere { .. } | Self::Box { .. } => {
                let mut nodes = Vec::new();
                let mut nearest: Option<(f64, &Node)> = None;
                for (index, node) in spatial() {
                    let distance = self.distance(node.position)?;
                    if distance <= 0.0 {
                        nodes.push(index);
                    }
                    if nearest.is_none_or(|(least, _)| distance < least) {
                        nearest = Some((distance, node));
                    }
                }
                if nodes.is_empty()
                    && let Some((distance, node)) = nearest
                {
                    return Err(missed(distance, node));
                }
                nodes
            }
        };
        let mut nodes = nodes;
        nodes.sort_unstable();
        nodes.dedup();
        if nodes.is_empty() {
            return Err(ElementError::new("the region contains no node", "name a set with nodes"));
        }
        Ok(nodes)
    }

    /// Checks that the nodes of a cylinder surround its axis, as those of a whole bore do. Other
    /// regions have no axis.
    ///
    /// # Errors
    /// The region contains no node, or its nodes leave a gap of more than [`WIDEST_GAP`]. The
    /// message states radius and position of the node nearest to the cylinder.
    pub fn check_surrounds_axis(&self, model: &ElasticModel) -> Result<(), ElementError> {
        let Self::Cylinder { origin, axis, radius, heights, .. } = self else { return Ok(()) };
        let axis = unit(*axis)?;
        let [across, other] = perpendicular(&axis);
        let arm = |node: &Node| Vector3::from(node.position) - Vector3::from(*origin);
        let found = self.nodes(model).unwrap_or_default();
        let mut angles: Vec<f64> = found
            .iter()
            .map(|&node| arm(&model.nodes[node]))
            .map(|arm| other.dot(&arm).atan2(across.dot(&arm)))
            .collect();
        angles.sort_by(f64::total_cmp);
        let around = angles.iter().copied().chain(angles.first().map(|first| first + TAU));
        let gap = around.clone().skip(1).zip(around).map(|(next, angle)| next - angle).fold(0.0, f64::max);
        if !found.is_empty() && gap <= WIDEST_GAP {
            return Ok(());
        }
        let mm = |metres: f64| (metres * 1e6).round() / 1e3 + 0.0;
        let what = match found.len() {
            0 => "no node is on it".to_owned(),
            count => format!(
                "{count} nodes are on it and leave a gap of {} degrees",
                (gap.to_degrees() * 10.0).round() / 10.0
            ),
        };
        let spatial = model.nodes.iter().filter(|node| is_spatial(node));
        let off = |node: &&Node| self.distance(node.position).unwrap_or(f64::INFINITY).max(0.0);
        let outside = spatial.filter(|node| off(node) > 0.0);
        let nearest = outside.min_by(|one, other| off(one).total_cmp(&off(other))).map(|node| {
            let height = axis.dot(&arm(node));
            format!(
                "; the nearest other node, {}, is {} mm from the axis and {} mm from the middle along it",
                node.label,
                mm((arm(node) - axis * height).norm()),
                mm(height - 0.5 * (heights[0] + heights[1]))
            )
        });
        Err(ElementError::new(
            format!(
                "no bore of {} mm in diameter surrounds the axis there: {what}{}",
                mm(2.0 * radius),
                nearest.unwrap_or_default()
            ),
            "correct the diameter, the position or the length of the bore, or the frame of the body",
        ))
    }

    /// Returns the distance of a point from a region of geometry, beyond its tolerance, m: not
    /// positive within the region.
    fn distance(&self, position: [f64; 3]) -> Result<f64, ElementError> {
        let from = |point: &[f64; 3]| Vector3::from(position) - Vector3::from(*point);
        Ok(match self {
            Self::Cylinder { origin, axis, radius, heights, tolerance } => {
                let axis = unit(*axis)?;
                let height = axis.dot(&from(origin));
                let off = ((from(origin) - axis * height).norm() - radius).abs();
                off.max(heights[0] - height).max(height - heights[1]) - tolerance
            }
            Self::Plane { origin, normal, tolerance } => unit(*normal)?.dot(&from(origin)).abs() - tolerance,
            Self::Sphere { centre, radius } => from(centre).norm() - radius,
            Self::Box { lowest, highest } => (0..3)
                .map(|k| (lowest[k] - position[k]).max(position[k] - highest[k]))
                .fold(f64::NEG_INFINITY, f64::max),
            Self::Nearest(point) => from(point).norm(),
            Self::Set(_) | Self::Labels(_) | Self::Nodes(_) => f64::INFINITY,
        })
    }
}

/// Largest angle between neighbouring nodes of a whole bore, rad: a square bore has 90 degrees.
const WIDEST_GAP: f64 = TAU / 3.0;

/// Returns two unit vectors normal to an axis and to each other.
fn perpendicular(axis: &Vector3<f64>) -> [Vector3<f64>; 2] {
    let helper = if axis.x.abs() < 0.5 { Vector3::x() } else { Vector3::y() };
    let across = axis.cross(&helper).normalize();
    [across, axis.cross(&across)]
}

/// Returns the error for a region without nodes, with the nearest node and its distance (m).
fn missed(distance: f64, node: &Node) -> ElementError {
    let mm = |metres: f64| (metres * 1e6).round() / 1e3 + 0.0;
    let [x, y, z] = node.position.map(mm);
    ElementError::new(
        format!(
            "the region contains no node; the nearest one is node {} at ({x}, {y}, {z}) mm, {} mm away",
            node.label,
            mm(distance)
        ),
        "correct the region or enlarge its tolerance; positions are those of the file",
    )
}

/// Returns true for a node whose components are motions, not amplitudes.
fn is_spatial(node: &Node) -> bool {
    node.axes != [[0.0; 3]; 3]
}

fn unit(vector: [f64; 3]) -> Result<Vector3<f64>, ElementError> {
    let vector = Vector3::from(vector);
    let norm = vector.norm();
    if norm > 0.0 && norm.is_finite() {
        Ok(vector / norm)
    } else {
        Err(ElementError::new("a direction is zero or not finite", "state a vector with a length"))
    }
}

/// Distance of a node from the axis of a surface, relative to the largest one, up to which it is on
/// the axis.
const NEAR_AXIS: f64 = 1e-6;
/// Difference of the angles of two nodes around an axis up to which they are equal, rad.
const SAME_ANGLE: f64 = 1e-6;

/// Adds an attachment to a model and returns its nodes: the attachment node, and one node per
/// harmonic of a Fourier surface, whose six components are the amplitudes (cosine, sine) of the
/// radial, the circumferential and the axial displacement.
///
/// # Errors
/// The region is empty, a harmonic is 1 or repeated, or the nodes do not resolve it.
pub fn attach(model: &mut ElasticModel, attachment: &Attachment) -> Result<Vec<usize>, ElementError> {
    let nodes = attach_unnamed(model, attachment)
        .map_err(|error| error.within(format_args!("attachment \"{}\"", attachment.name)))?;
    model.sets.insert(attachment.name.clone(), nodes.clone());
    Ok(nodes)
}

/// Adds an attachment as [`attach`], without a node set. Its errors do not name the attachment.
///
/// # Errors
/// Those of [`attach`].
pub fn attach_unnamed(model: &mut ElasticModel, attachment: &Attachment) -> Result<Vec<usize>, ElementError> {
    let region = attachment.region.nodes(model)?;
    let position = attachment.position.unwrap_or_else(|| {
        let sum = region
            .iter()
            .fold(Vector3::zeros(), |sum, &node| sum + Vector3::from(model.nodes[node].position));
        (sum / region.len() as f64).into()
    });
    let reference = add_node(model, position, BASIC);
    let label = model.constraints.iter().map(crate::constraint::label).max().unwrap_or(0) + 1;
    let components = connected_components(model, &region);
    match &attachment.connection {
        Connection::Rigid => {
            let dependents = region.into_iter().zip(components).collect();
            model.constraints.push(Constraint::Rigid { label, reference, dependents });
            Ok(vec![reference])
        }
        Connection::Average | Connection::Raceway { .. } => {
            let terms =
                region.into_iter().zip(components).map(|(node, of_node)| (1.0, node, of_node)).collect();
            let components = [true; 6];
            model.constraints.push(Constraint::WeightedAverage { label, reference, components, terms });
            Ok(vec![reference])
        }
        Connection::Fourier { axis, harmonics } => {
            let mut sorted = harmonics.clone();
            sorted.sort_unstable();
            sorted.dedup();
            if sorted.len() != harmonics.len() || sorted.contains(&1) {
                return Err(ElementError::new(
                    "a harmonic is repeated, or is 1, which is the rigid motion of the attachment node",
                    "state each order once: 0, or at least 2",
                ));
            }
            let axis = unit(*axis)?;
            check_resolution(model, &region, position, axis, harmonics)?;
            let mut nodes = vec![reference];
            for _ in harmonics {
                nodes.push(add_node(model, position, [[0.0; 3]; 3]));
            }
            for (index, node) in region.into_iter().enumerate() {
                let first = label + 3 * index as u64;
                fourier(model, node, &nodes, axis, harmonics, first)?;
            }
            Ok(nodes)
        }
    }
}

/// Width of a region relative to its length below which its nodes lie on a line.
const LINE: f64 = 1e-6;

/// Returns whether positions lie on a line.
pub fn on_a_line(positions: &[[f64; 3]]) -> bool {
    let count = positions.len().max(1) as f64;
    let sum = positions.iter().fold(Vector3::zeros(), |sum, at| sum + Vector3::from(*at));
    let from: Vec<Vector3<f64>> = positions.iter().map(|at| Vector3::from(*at) - sum / count).collect();
    let far = from.iter().copied().reduce(|a, b| if b.norm() > a.norm() { b } else { a });
    let Some(far) = far.filter(|far| far.norm() > 0.0) else { return true };
    from.iter().all(|at| far.cross(at).norm() <= LINE * far.norm_squared())
}

/// Returns which nodes have stiffness against rotation: those of shells and beams.
pub fn rotating_nodes(model: &ElasticModel) -> Vec<bool> {
    let mut rotating = vec![false; model.nodes.len()];
    for element in &model.elements {
        if matches!(element.kind, ElementKind::Shell { .. } | ElementKind::Beam(_)) {
            element.nodes.iter().for_each(|&node| rotating[node] = true);
        }
    }
    rotating
}

/// Returns the components of each node of a region that a rigid or averaged attachment connects:
/// translations, because nodes of solids have no stiffness against rotation. On a line, such as the
/// straight edge of a shell, translations do not determine the rotation about it, so rotations of
/// shells and beams are connected too.
fn connected_components(model: &ElasticModel, region: &[usize]) -> Vec<Components> {
    let translations = [true, true, true, false, false, false];
    let positions: Vec<[f64; 3]> = region.iter().map(|&node| model.nodes[node].position).collect();
    if !on_a_line(&positions) {
        return vec![translations; region.len()];
    }
    let rotating = rotating_nodes(model);
    region.iter().map(|&node| if rotating[node] { [true; 6] } else { translations }).collect()
}

fn add_node(model: &mut ElasticModel, position: [f64; 3], axes: [[f64; 3]; 3]) -> usize {
    let label = model.nodes.iter().map(|node| node.label).max().unwrap_or(0) + 1;
    model.nodes.push(Node { label, position, axes });
    model.nodes.len() - 1
}

/// Checks that the nodes of a region are away from the axis and at enough angles around it.
///
/// # Errors
/// A node is on the axis, or the nodes do not resolve a harmonic: order n needs 2 n + 1 angles.
fn check_resolution(
    model: &ElasticModel,
    region: &[usize],
    position: [f64; 3],
    axis: Vector3<f64>,
    harmonics: &[u32],
) -> Result<(), ElementError> {
    let across = |&node: &usize| {
        let from = Vector3::from(model.nodes[node].position) - Vector3::from(position);
        from - axis * axis.dot(&from)
    };
    let largest = region.iter().map(|node| across(node).norm()).fold(0.0, f64::max);
    if let Some(&node) = region.iter().find(|node| across(node).norm() <= NEAR_AXIS * largest) {
        return Err(ElementError::new(
            format!("node {} of the surface is on its axis", model.nodes[node].label),
            "select the nodes of a surface around the axis",
        ));
    }
    let [start, side] = transverse(axis);
    let angle = |node: &usize| across(node).dot(&side).atan2(across(node).dot(&start));
    let mut angles: Vec<f64> = region.iter().map(angle).collect();
    angles.sort_by(f64::total_cmp);
    let mut count = angles.windows(2).filter(|pair| pair[1] - pair[0] > SAME_ANGLE).count() + 1;
    // The first and the last one may be at -180 and 180 degrees.
    if count > 1 && angles[angles.len() - 1] - angles[0] > 2.0 * PI - SAME_ANGLE {
        count -= 1;
    }
    let highest = harmonics.iter().copied().max().unwrap_or(0) as usize;
    if 2 * highest + 1 > count {
        return Err(ElementError::new(
            format!("harmonic {highest} is not resolved by nodes at {count} angles around the axis"),
            format!("use harmonics up to {}, or a finer mesh", count.saturating_sub(1) / 2),
        ));
    }
    Ok(())
}

/// Makes the translations of a node depend on the attachment node and the amplitudes.
fn fourier(
    model: &mut ElasticModel,
    node: usize,
    nodes: &[usize],
    axis: Vector3<f64>,
    harmonics: &[u32],
    label: u64,
) -> Result<(), ElementError> {
    let reference = nodes[0];
    let from = Vector3::from(model.nodes[node].position) - Vector3::from(model.nodes[reference].position);
    let across = from - axis * axis.dot(&from);
    let radial = across.normalize();
    let around = axis.cross(&radial);
    let [start, side] = transverse(axis);
    let angle = radial.dot(&side).atan2(radial.dot(&start));
    for component in 0..3 {
        let direction = Vector3::from(model.nodes[node].axes[component]);
        let mut terms = vec![(node, component, 1.0)];
        let rigid =
            crate::constraint::rigid_row(&model.nodes[node], component, model.nodes[reference].position);
        terms.extend((0..6).map(|k| (reference, k, -rigid[k])));
        for (&order, &amplitudes) in harmonics.iter().zip(&nodes[1..]) {
            let phase = f64::from(order) * angle;
            let series = [phase.cos(), (phase).sin()];
            for (kind, along) in [radial, around, axis].into_iter().enumerate() {
                for (part, value) in series.into_iter().enumerate() {
                    // Of order 0, only the radial expansion is not a rigid motion.
                    if order > 0 || (kind == 0 && part == 0) {
                        terms.push((amplitudes, 2 * kind + part, -value * along.dot(&direction)));
                    }
                }
            }
        }
        terms.retain(|&(_, _, factor)| factor != 0.0);
        model.constraints.push(Constraint::Equation { label: label + component as u64, terms });
    }
    Ok(())
}

/// Returns two directions across an axis from which angles count: the first is as near as possible
/// to the basic x axis, or to the y axis if the axis is along x.
pub fn transverse(axis: Vector3<f64>) -> [Vector3<f64>; 2] {
    let reference = if axis.x.abs() < (PI / 18.0).cos() { Vector3::x() } else { Vector3::y() };
    let start = (reference - axis * axis.dot(&reference)).normalize();
    [start, axis.cross(&start)]
}
