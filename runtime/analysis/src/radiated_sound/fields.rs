//! Field meshes around a radiating body: points at which its sound pressure is of interest, or at
//! which microphones measure its sound power.

use super::{mm, refused};
use calyx_acoustics::field::{FieldMesh, tangents};
use calyx_numerics::error::EngineError;
use calyx_numerics::vec3::{Vector, cross, dot, length, minus, plus, scaled, unit};

/// Largest number of points of a field mesh.
const MOST: usize = 10_000;
/// Distance of the centre of a hemisphere from the rigid plane that counts as rounding, relative to
/// the radius.
const ON_PLANE: f64 = 1e-6;

/// Least radius of a hemisphere of ISO 3744, m.
const LEAST_RADIUS: f64 = 1.0;
/// Least distance of the microphones on a box of ISO 3744, m.
const LEAST_DISTANCE: f64 = 0.25;

/// Request for the sound pressure on a field mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct FieldRequest {
    /// Name in results.
    pub name: String,
    /// Shape.
    pub shape: FieldShape,
}

/// Shape of a field mesh in ground coordinates, m.
#[derive(Clone, Debug, PartialEq)]
pub enum FieldShape {
    /// Sphere around the body.
    Sphere {
        /// Centre; `None` for the middle of the body.
        center: Option<Vector>,
        /// Radius.
        radius: f64,
        /// Number of polar angles.
        rings: usize,
    },
    /// Hemisphere on the rigid plane.
    Hemisphere {
        /// Centre; `None` for the point below the middle of the body.
        center: Option<Vector>,
        /// Radius.
        radius: f64,
        /// Number of heights; `None` for the ten key microphone positions of ISO 3744.
        rings: Option<usize>,
    },
    /// Nine key microphone positions of ISO 3744 on a box on the rigid plane.
    Box {
        /// Distance from the box that contains the body.
        distance: f64,
    },
    /// Parallelogram.
    Plane {
        /// Corner.
        corner: Vector,
        /// Edges from the corner.
        edges: [Vector; 2],
        /// Numbers of points along the edges.
        counts: [usize; 2],
    },
}

impl FieldShape {
    /// Returns the name of the kind in files.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Sphere { .. } => "sphere",
            Self::Hemisphere { rings: None, .. } => "hemisphere of ISO 3744",
            Self::Hemisphere { .. } => "hemisphere",
            Self::Box { .. } => "box of ISO 3744",
            Self::Plane { .. } => "plane",
        }
    }

    /// Returns the numbers of points along the edges of a plane.
    pub fn grid(&self) -> Option<[usize; 2]> {
        match self {
            Self::Plane { counts, .. } => Some(*counts),
            _ => None,
        }
    }

    /// Returns true if the mesh encloses the body, so that its mean level gives the sound power.
    pub fn encloses(&self) -> bool {
        !matches!(self, Self::Plane { .. })
    }
}

/// Surface of a body in ground coordinates.
pub(super) struct Extent {
    pub vertices: Vec<Vector>,
    pub triangles: Vec<[usize; 3]>,
    /// Point and normal of the rigid plane.
    pub plane: Option<[Vector; 2]>,
}

impl Extent {
    /// Returns the middle of the box that contains the surface.
    fn middle(&self) -> Vector {
        super::middle(&self.vertices)
    }

    /// Returns the distance from the rigid plane.
    fn height([point, normal]: [Vector; 2], at: Vector) -> f64 {
        dot(minus(at, point), unit(normal))
    }

    /// Returns a point of the surface inside of a parallelogram, if there is one: where edges of
    /// triangles cross it.
    fn crossing(&self, corner: Vector, edges: [Vector; 2]) -> Option<Vector> {
        let product = cross(edges[0], edges[1]);
        let normal = unit(product);
        // Coordinates of a point along the edges.
        let along = |at: Vector| {
            let from = minus(at, corner);
            let square = dot(product, product);
            [dot(cross(from, edges[1]), product) / square, dot(cross(edges[0], from), product) / square]
        };
        let ends = |[a, b, c]: &[usize; 3]| [[*a, *b], [*b, *c], [*c, *a]];
        self.triangles.iter().flat_map(ends).find_map(|[a, b]| {
            let [p, q] = [a, b].map(|vertex| self.vertices[vertex]);
            let [from, to] = [p, q].map(|at| dot(minus(at, corner), normal));
            if from * to > 0.0 || from == to {
                return None;
            }
            let at = plus(p, scaled(minus(q, p), from / (from - to)));
            along(at).iter().all(|part| (0.0..=1.0).contains(part)).then_some(at)
        })
    }
}

impl FieldRequest {
    /// Returns the points in ground coordinates.
    ///
    /// # Errors
    /// E0784: the mesh does not enclose the body, passes through it, needs a rigid plane that the
    /// sound does not have, or has too many points.
    pub(super) fn mesh(&self, body: &Extent) -> Result<FieldMesh, EngineError> {
        let name = &self.name;
        let mesh = match self.shape {
            FieldShape::Sphere { center, radius, rings } => {
                let center = center.unwrap_or_else(|| body.middle());
                self.check_reach(body, center, radius)?;
                if body.plane.is_some_and(|plane| Extent::height(plane, center) < radius) {
                    return Err(refused(
                        format!("the sphere \"{name}\" passes through the rigid plane"),
                        "give a hemisphere on the plane by `gears.hemisphere_field`",
                    ));
                }
                FieldMesh::sphere(center, radius, rings)
            }
            FieldShape::Hemisphere { center, radius, rings } => {
                let plane @ [_, normal] = self.plane(body)?;
                let center = match center {
                    Some(center) if Extent::height(plane, center).abs() > ON_PLANE * radius => {
                        return Err(refused(
                            format!(
                                "the centre of the hemisphere \"{name}\" is {} mm from the rigid plane",
                                mm(Extent::height(plane, center).abs())
                            ),
                            "give a point of the plane as `center`, or leave it out",
                        ));
                    }
                    Some(center) => center,
                    None => on_plane(plane, body.middle()),
                };
                self.check_reach(body, center, radius)?;
                match rings {
                    None => FieldMesh::iso_3744(center, normal, radius),
                    Some(rings) => FieldMesh::hemisphere(center, normal, radius, rings),
                }
            }
            FieldShape::Box { distance } => {
                let plane @ [_, normal] = self.plane(body)?;
                let axis = unit(normal);
                let axes = tangents(axis);
                let range = |axis: Vector| {
                    let along = body.vertices.iter().map(|vertex| dot(*vertex, axis));
                    along.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
                };
                let [[a, b], [c, d]] = axes.map(range);
                let middle = plus(scaled(axes[0], 0.5 * (a + b)), scaled(axes[1], 0.5 * (c + d)));
                let height = body.vertices.iter().map(|&at| Extent::height(plane, at)).fold(0.0, f64::max);
                FieldMesh::iso_3744_box(on_plane(plane, middle), normal, [b - a, d - c, height], distance)
            }
            FieldShape::Plane { corner, edges, counts } => {
                if length(cross(edges[0], edges[1])) > 0.0
                    && let Some(at) = body.crossing(corner, edges)
                {
                    let [x, y, z] = at.map(mm);
                    return Err(refused(
                        format!(
                            "the plane \"{name}\" passes through the body, such as at ({x}, {y}, {z}) mm"
                        ),
                        "move it into the fluid",
                    ));
                }
                FieldMesh::plane(corner, edges, counts)
            }
        };
        let mesh = mesh.map_err(|error| {
            let help = error.help().to_owned();
            refused(format!("the field mesh \"{name}\": {error}"), help)
        })?;
        if mesh.points.len() > MOST {
            return Err(refused(
                format!("the field mesh \"{name}\" has {} points", mesh.points.len()),
                format!("give at most {MOST} points"),
            ));
        }
        Ok(mesh)
    }

    /// Returns how a mesh of microphone positions differs from what ISO 3744:2010 requires, as a
    /// clause.
    pub(super) fn deviation(&self, body: &Extent) -> Option<String> {
        match self.shape {
            FieldShape::Hemisphere { center, radius, rings: None } => {
                let center = center.unwrap_or(on_plane(body.plane?, body.middle()));
                let reach = body.vertices.iter().map(|&at| length(minus(at, center))).fold(0.0, f64::max);
                let least = (2.0 * reach).max(LEAST_RADIUS);
                (radius < least).then(|| {
                    format!(
                        "ISO 3744 requires a radius of at least {} mm for this body, and it is {} mm",
                        mm(least).ceil(),
                        mm(radius)
                    )
                })
            }
            FieldShape::Box { distance } if distance < LEAST_DISTANCE => Some(format!(
                "ISO 3744 requires a distance of at least {} mm, and it is {} mm",
                mm(LEAST_DISTANCE),
                mm(distance)
            )),
            _ => None,
        }
    }

    fn plane(&self, body: &Extent) -> Result<[Vector; 2], EngineError> {
        body.plane.ok_or_else(|| {
            refused(
                format!(
                    "the {} \"{}\" stands on a rigid plane, and the sound has none",
                    self.shape.kind(),
                    self.name
                ),
                "give a point of the ground as `plane`, or use `gears.sphere_field` in free space",
            )
        })
    }

    /// Checks that a sphere encloses the body.
    fn check_reach(&self, body: &Extent, center: Vector, radius: f64) -> Result<(), EngineError> {
        let reach = body.vertices.iter().map(|&at| length(minus(at, center))).fold(0.0, f64::max);
        if radius > reach {
            return Ok(());
        }
        Err(refused(
            format!(
                "the {} \"{}\" with a radius of {} mm does not enclose the body, which reaches {} mm from its centre",
                self.shape.kind(),
                self.name,
                mm(radius),
                mm(reach)
            ),
            format!(
                "give a radius of at least {} mm; ISO 3744 uses twice the distance or more",
                (1.1e3 * reach).ceil()
            ),
        ))
    }
}

/// Returns the projection of a point on a plane.
fn on_plane(plane: [Vector; 2], at: Vector) -> Vector {
    let height = Extent::height(plane, at);
    plus(at, scaled(unit(plane[1]), -height))
}
