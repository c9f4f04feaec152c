//! Surface of an elastic body: its skin, closed over the named openings, and coarsened.

use super::directions::{Direction, directions};
use super::fields::{Extent, FieldRequest};
use super::plane::extent;
use super::{Placement, SoundRequest, engine_error, mm, refused};
use calyx_acoustics::coarse_surface::{CoarseSurface, PER_WAVELENGTH};
use calyx_acoustics::field::FieldMesh;
use calyx_acoustics::openings::selected_rims;
use calyx_acoustics::projection::Projection;
use calyx_acoustics::shares::panel_shares;
use calyx_acoustics::shells::{ShellProblem, ShellSkin};
use calyx_acoustics::skin::{Skin, Solid, boundary};
use calyx_acoustics::{AcousticError, Face};
use calyx_model::elastic_body::{BodyMesh, CellShape, Panel, SharedElasticBody};
use calyx_model::mechanism::Mechanism;
use calyx_numerics::error::{EngineError, Subject};
use calyx_numerics::vec3::Vector;
use calyx_structure::outer_surface::CellKind;
use std::collections::BTreeSet;

/// Mean area of the triangles of a coarsened surface over the square of the longest edge. Measured:
/// 0.2 for the plates of a housing; 0.43 for equal sides.
const COARSENED: f64 = 0.22;
/// Largest number of rims in a message, and of nodes of each.
const NAMED: usize = 4;

/// Closed surface of a body.
pub(crate) struct Surface {
    /// Coarsened skin.
    pub skin: Skin,
    /// Skin of the mesh of the body.
    pub original: Skin,
    /// Projection of velocities from the skin of the mesh to the coarsened one.
    projection: Projection,
    /// Names of the openings with the numbers of their lids.
    pub closed: Vec<(String, usize)>,
    /// Number of elements that are left out: ribs, inner parts, and shells on solids.
    pub left_out: usize,
    /// Panels and, if there are any, the rest of the surface.
    pub panels: Vec<SurfacePanel>,
    placement: Placement,
}

/// Panel of a surface.
pub(crate) struct SurfacePanel {
    pub name: String,
    /// Share of each triangle that belongs to the panel, from 0 to 1.
    pub shares: Vec<f64>,
    /// The same of the skin of the mesh: 0 or 1.
    pub original: Vec<f64>,
}

impl Surface {
    /// Finds and closes the skin of the body of a request.
    ///
    /// # Errors
    /// E0784: the body has no mesh. E0785: the surface is open.
    pub fn new(scene: &Mechanism, request: &SoundRequest) -> Result<Surface, EngineError> {
        let connection = request.connection(scene)?;
        let name = &connection.name;
        let mesh = connection.body.as_ref().and_then(|SharedElasticBody(body)| body.mesh());
        let Some(mesh) = mesh else {
            return Err(refused(
                format!("\"{name}\" is given by matrices at its attachments, and its surface is unknown"),
                "import its mesh, such as by `gears.nastran`",
            ));
        };
        let placement = Placement::new(scene, connection)?;
        let plane = placement.plane(request)?;
        let named = |error: EngineError| EngineError {
            message: format!("the surface of \"{name}\": {}", error.message),
            ..error
        };
        let (solids, shells) = elements(&mesh);
        let found = if solids.is_empty() {
            closed_shells(&mesh, &shells, plane)
        } else {
            closed_solids(&mesh, &solids, plane).map(|(skin, closed)| (skin, closed, shells.len()))
        };
        let (skin, closed, left_out) = found.map_err(named)?;
        let panels = panels(&mesh, &skin).map_err(named)?;
        let (original, projection) = (skin.clone(), Projection::new(&skin.mesh, &skin.mesh));
        Ok(Surface { skin, original, projection, closed, left_out, panels, placement })
    }

    /// Returns the skin of the mesh, coarsened for a wavelength in the fluid, m, and for these
    /// normal velocities.
    ///
    /// # Errors
    /// Those of [`CoarseSurface::new`].
    pub fn coarsened(self, wavelength: f64, velocities: &[&[f64]]) -> Result<Surface, EngineError> {
        let original = &self.original;
        let CoarseSurface { skin, projection } =
            CoarseSurface::new(original, wavelength, velocities).map_err(engine_error)?;
        if self.panels.is_empty() {
            return Ok(Surface { skin, projection, ..self });
        }
        let owner = |triangle: usize| {
            self.panels.iter().position(|panel| panel.name != Panel::REST && panel.original[triangle] == 1.0)
        };
        let owners: Vec<Option<usize>> = (0..original.mesh.triangles().len()).map(owner).collect();
        let named = self.panels.len() - 1;
        let mut shares = panel_shares(&original.mesh, &owners, &skin.mesh, named);
        let rest = |triangle: usize| 1.0 - shares.iter().map(|own| own[triangle]).sum::<f64>();
        let rest: Vec<f64> = (0..skin.mesh.triangles().len()).map(rest).collect();
        shares.push(rest);
        let panels = self.panels.into_iter().zip(shares);
        let panels = panels.map(|(panel, shares)| SurfacePanel { shares, ..panel }).collect();
        Ok(Surface { skin, projection, panels, ..self })
    }

    /// Returns the normal velocities of the coarsened skin from those of the skin of the mesh.
    pub fn projected(&self, velocities: &[f64]) -> Vec<f64> {
        self.projection.normal_velocities(velocities)
    }

    /// Returns points of ground in the coordinates of the body, m.
    pub fn points(&self, ground: &[Vector]) -> Vec<Vector> {
        ground.iter().map(|&point| self.placement.point(point)).collect()
    }

    /// Returns a direction of ground in the coordinates of the body.
    pub fn vector(&self, ground: Vector) -> Vector {
        self.placement.direction(ground)
    }

    /// Returns the vertices of the skin of the mesh in ground coordinates, m.
    pub fn original_vertices(&self) -> Vec<Vector> {
        self.original.mesh.vertices().iter().map(|&vertex| self.placement.ground(vertex)).collect()
    }

    /// Returns the axes of the body in ground coordinates.
    pub fn axes(&self) -> [Vector; 3] {
        self.placement.state.axes
    }

    /// Returns the vertices in ground coordinates, m.
    pub fn vertices(&self) -> Vec<Vector> {
        self.skin.mesh.vertices().iter().map(|&vertex| self.placement.ground(vertex)).collect()
    }

    /// Returns the directions of the far field into the fluid.
    pub fn directions(&self, request: &SoundRequest) -> Vec<Direction> {
        directions(request.plane.map(|[_, normal]| normal))
    }

    /// Returns the field meshes of a request in ground coordinates.
    ///
    /// # Errors
    /// E0784: a field mesh does not fit the body or the rigid plane.
    pub fn fields(&self, request: &SoundRequest) -> Result<Vec<FieldMesh>, EngineError> {
        self.named_fields(request).map_err(|(error, _)| error)
    }

    /// Does the work of [`Self::fields`], with the index of the field mesh in errors.
    fn named_fields(&self, request: &SoundRequest) -> Result<Vec<FieldMesh>, (EngineError, usize)> {
        if request.fields.is_empty() {
            return Ok(Vec::new());
        }
        let mut names = BTreeSet::new();
        if let Some(twice) = request.fields.iter().position(|field| !names.insert(&field.name)) {
            let name = &request.fields[twice].name;
            let message = format!("two field meshes of the sound are called \"{name}\"");
            return Err((refused(message, "rename one of them"), twice));
        }
        let extent = self.extent(request);
        let mesh =
            |(index, field): (usize, &FieldRequest)| field.mesh(&extent).map_err(|error| (error, index));
        request.fields.iter().enumerate().map(mesh).collect()
    }

    /// Returns the surface in ground coordinates, with the plane of a request.
    pub(super) fn extent(&self, request: &SoundRequest) -> Extent {
        Extent {
            vertices: self.vertices(),
            triangles: self.skin.mesh.triangles().to_vec(),
            plane: request.plane,
        }
    }

    /// Checks that the points of a request, of a given index, are in the fluid.
    ///
    /// # Errors
    /// E0784: a point is not in the fluid, or a field mesh does not fit.
    pub fn check_points(&self, index: usize, request: &SoundRequest) -> Result<(), EngineError> {
        for (number, &at) in request.points.iter().enumerate() {
            self.check_point(at, "at which sound pressure is requested")
                .map_err(|error| error.blame("at").about(Subject::SoundPoint(index as u32, number as u32)))?;
        }
        let about = |error: EngineError, number| {
            error.blame("field").about(Subject::SoundField(index as u32, number as u32))
        };
        let meshes = self.named_fields(request).map_err(|(error, number)| about(error, number))?;
        for (number, (field, mesh)) in request.fields.iter().zip(meshes).enumerate() {
            // Others enclose the body.
            if !field.shape.encloses() {
                let whose = format!("a point of the plane \"{}\"", field.name);
                let check = |&at: &Vector| self.check_point(at, &whose);
                mesh.points.iter().try_for_each(check).map_err(|error| about(error, number))?;
            }
        }
        Ok(())
    }

    fn check_point(&self, ground: Vector, whose: &str) -> Result<(), EngineError> {
        let point = self.placement.point(ground);
        let behind = self.skin.mesh.plane().is_some_and(|plane| plane.distance(point) < 0.0);
        if !behind && self.skin.mesh.enclosure(point) <= 0.5 {
            return Ok(());
        }
        let [x, y, z] = ground.map(mm);
        let place = if behind { "behind the rigid plane" } else { "inside of the body" };
        Err(refused(
            format!("the point ({x}, {y}, {z}) mm, {whose}, is {place}"),
            "give a point in the fluid, in ground coordinates",
        ))
    }
}

/// Size of the sound of a body, for the display of a plan.
pub struct SurfaceSize {
    /// Estimated number of triangles: the mean edge is shorter than a sixth of the wavelength,
    /// unless the mesh is coarser.
    pub triangles: usize,
    /// Area, m².
    pub area: f64,
    /// Width of a sphere of the same area, with the mirror image in a rigid plane, m.
    pub width: f64,
    /// Number of points at which the pressure is requested.
    pub points: usize,
}

impl SurfaceSize {
    /// Returns the size of the surface of a request at a highest frequency, Hz.
    ///
    /// # Errors
    /// Those of the surface.
    pub fn new(scene: &Mechanism, request: &SoundRequest, highest: f64) -> Result<SurfaceSize, EngineError> {
        let surface = Surface::new(scene, request)?;
        let (mesh, area) = (&surface.skin.mesh, surface.skin.mesh.area());
        let edge = request.fluid.speed_of_sound / (PER_WAVELENGTH * highest);
        let wanted = (area / (COARSENED * edge * edge)).ceil() as usize;
        let fine = mesh.triangles().len();
        let on_fields = surface.fields(request)?.iter().map(|field| field.points.len()).sum::<usize>();
        Ok(SurfaceSize {
            triangles: wanted.clamp(4.min(fine), fine),
            area,
            width: (area / std::f64::consts::PI).sqrt() * extent(mesh) / mesh.size(),
            points: request.points.len() + on_fields,
        })
    }
}

/// Returns the panels of a mesh on its skin, and the rest; none without panels.
///
/// # Errors
/// E0784: a panel has no element of the skin, or two panels have a common one.
fn panels(mesh: &BodyMesh, skin: &Skin) -> Result<Vec<SurfacePanel>, EngineError> {
    let triangles = skin.mesh.triangles();
    let mut owners: Vec<Option<usize>> = vec![None; triangles.len()];
    for (index, panel) in mesh.panels.iter().enumerate() {
        let has = |node: &usize| panel.nodes.binary_search(node).is_ok();
        let of_panel: Vec<bool> = skin.nodes.iter().map(|nodes| nodes.iter().all(has)).collect();
        let mut count = 0;
        for (owner, corners) in owners.iter_mut().zip(triangles) {
            if !corners.iter().all(|&vertex| of_panel[vertex]) {
                continue;
            }
            if let Some(other) = owner.replace(index) {
                return Err(refused(
                    format!(
                        "the panels \"{}\" and \"{}\" have common elements",
                        mesh.panels[other].name, panel.name
                    ),
                    "select regions that have common nodes on their rims only",
                ));
            }
            count += 1;
        }
        if count == 0 {
            return Err(refused(
                format!("the panel \"{}\" has no whole element of the outer surface", panel.name),
                "select all nodes of its elements, such as by `gears.plane_region` or `gears.box_region`",
            ));
        }
    }
    let names = mesh.panels.iter().map(|panel| panel.name.clone()).enumerate();
    let share = |is_own: bool| if is_own { 1.0 } else { 0.0 };
    let panel = |name: String, shares: Vec<f64>| SurfacePanel { name, original: shares.clone(), shares };
    let mut all: Vec<SurfacePanel> = names
        .map(|(index, name)| {
            let shares = owners.iter().map(|owner| share(*owner == Some(index))).collect();
            panel(name, shares)
        })
        .collect();
    if !all.is_empty() {
        let shares = owners.iter().map(|owner| share(owner.is_none())).collect();
        all.push(panel(Panel::REST.into(), shares));
    }
    Ok(all)
}

/// Returns the solids and the shells of a mesh.
fn elements(mesh: &BodyMesh) -> (Vec<Solid>, Vec<Face>) {
    let (mut solids, mut shells) = (Vec::new(), Vec::new());
    for (shape, nodes) in &mesh.cells {
        let cell = shape.cell(nodes, 0);
        match (shape, cell.kind, cell.corners) {
            (CellShape::Shell(_), _, &[a, b, c]) => shells.push(Face::Triangle([a, b, c])),
            (CellShape::Shell(_), _, &[a, b, c, d]) => shells.push(Face::Quadrilateral([a, b, c, d])),
            (_, CellKind::Tetrahedron, &[a, b, c, d]) => solids.push(Solid::Tetrahedron([a, b, c, d])),
            (_, CellKind::Wedge, &[a, b, c, d, e, f]) => solids.push(Solid::Wedge([a, b, c, d, e, f])),
            (_, CellKind::Hexahedron, &[a, b, c, d, e, f, g, h]) => {
                solids.push(Solid::Hexahedron([a, b, c, d, e, f, g, h]));
            }
            _ => {}
        }
    }
    (solids, shells)
}

fn open(message: impl Into<String>, help: impl Into<String>) -> EngineError {
    EngineError::new("E0785", message, help)
}

/// Returns the error of a surface that does not enclose the body.
fn degenerate(error: AcousticError) -> EngineError {
    match error {
        AcousticError::Mesh { message, .. } => open(
            message,
            "correct the mesh: its skin must be closed, without elements that touch in a node or an edge only",
        ),
        other => engine_error(other),
    }
}

type Closed = Vec<(String, usize)>;
type Plane = Option<calyx_acoustics::RigidPlane>;

fn closed_solids(mesh: &BodyMesh, solids: &[Solid], plane: Plane) -> Result<(Skin, Closed), EngineError> {
    let faces = boundary(&mesh.points, solids).map_err(engine_error)?;
    let (mut lids, mut owners) = (Vec::new(), Vec::new());
    for (index, opening) in mesh.openings.iter().enumerate() {
        let nodes: BTreeSet<usize> = opening.nodes.iter().copied().collect();
        let rims = selected_rims(&faces, &nodes).ok_or_else(|| closes_nothing(&opening.name, false))?;
        owners.resize(owners.len() + rims.len(), index);
        lids.extend(rims);
    }
    let skin = Skin::new(&mesh.points, solids, &lids, plane).map_err(degenerate)?;
    // Lids at the inner ends of bores close nothing.
    let of_skin: BTreeSet<usize> = skin.nodes.iter().flatten().copied().collect();
    let used = |index: usize| {
        let own = lids
            .iter()
            .zip(&owners)
            .filter(|(lid, owner)| **owner == index && lid.iter().all(|node| of_skin.contains(node)));
        own.count()
    };
    let openings = mesh.openings.iter().enumerate();
    let closed: Closed = openings.map(|(index, opening)| (opening.name.clone(), used(index))).collect();
    match closed.iter().find(|(_, lids)| *lids == 0) {
        Some((name, _)) => Err(closes_nothing(name, false)),
        None => Ok((skin, closed)),
    }
}

fn closes_nothing(name: &str, shells: bool) -> EngineError {
    let message = match shells {
        true => format!("the opening \"{name}\" closes nothing: its region has no whole line of free edges"),
        false => {
            format!("the opening \"{name}\" closes nothing: its nodes form no closed line on the outer skin")
        }
    };
    open(message, "select all nodes of the rim, and no others on it, such as by `gears.cylinder_region`")
}

fn closed_shells(
    mesh: &BodyMesh,
    shells: &[Face],
    plane: Plane,
) -> Result<(Skin, Closed, usize), EngineError> {
    if shells.is_empty() {
        return Err(open("it has neither solids nor shells", "import the mesh of the walls"));
    }
    let openings: Vec<BTreeSet<usize>> =
        mesh.openings.iter().map(|opening| opening.nodes.iter().copied().collect()).collect();
    let label = |node: usize| mesh.labels.get(node).copied().unwrap_or_default();
    match ShellSkin::new(&mesh.points, shells, &openings, plane) {
        Ok((ShellSkin { skin, left_out }, lids)) => {
            let closed: Closed = mesh.openings.iter().map(|opening| opening.name.clone()).zip(lids).collect();
            match closed.iter().find(|(_, lids)| *lids == 0) {
                Some((name, _)) => Err(closes_nothing(name, true)),
                None => Ok((skin, closed, left_out)),
            }
        }
        Err(ShellProblem::Open { rims, edges }) => Err(is_open(mesh, &rims, edges)),
        Err(ShellProblem::Junction { edge: [a, b], shells }) => Err(open(
            format!("{shells} shells meet at the edge of the nodes {} and {}", label(a), label(b)),
            "leave inner walls out of the mesh: only ribs that end in a free edge are recognized",
        )),
        Err(ShellProblem::OneSided { edge: [a, b] }) => Err(open(
            format!("it has no outside, as seen at the edge of the nodes {} and {}", label(a), label(b)),
            "correct the mesh: its shells must enclose a volume",
        )),
        Err(ShellProblem::Intersection { node }) => Err(open(
            format!("two closed parts intersect, as seen at the node {}", label(node)),
            "join the parts in the mesh, or leave one of them out",
        )),
        Err(ShellProblem::Mesh(error)) => Err(degenerate(error)),
    }
}

/// Returns the error of shells with free edges, with the places of the openings.
fn is_open(mesh: &BodyMesh, rims: &[Vec<usize>], edges: usize) -> EngineError {
    let place = |rim: &Vec<usize>| {
        let middle = |k: usize| rim.iter().map(|&node| mesh.points[node][k]).sum::<f64>() / rim.len() as f64;
        let [x, y, z] = [0, 1, 2].map(|k| mm(middle(k)));
        format!("one of {} nodes around ({x}, {y}, {z}) mm with node {}", rim.len(), mesh.labels[rim[0]])
    };
    let more = match rims.len().saturating_sub(NAMED) {
        0 => String::new(),
        more => format!(", and {more} more"),
    };
    let message = match rims.len() {
        0 => format!("it is open along {edges} edges"),
        1 => format!("it has an opening without a lid: {}", place(&rims[0])),
        count => {
            let places: Vec<String> = rims.iter().take(NAMED).map(place).collect();
            format!("it has {count} openings without lids: {}{more}", places.join("; "))
        }
    };
    open(message, "close each by `gears.opening(\"bore\", housing, region)`, with the region of its rim")
}
