//! Requests for the sound of elastic bodies.

use super::fields::FieldRequest;
use super::refused;
use calyx_acoustics::{Fluid, SoundMethod};
use calyx_model::connection::ElasticConnection;
use calyx_model::fidelity::Fidelity;
use calyx_model::ids::ConnectionId;
use calyx_model::mechanism::Mechanism;
use calyx_numerics::error::{EngineError, Subject};
use calyx_numerics::vec3::Vector;

/// Request for the sound of an elastic body.
#[derive(Clone, Debug, PartialEq)]
pub struct SoundRequest {
    /// Connection of the elastic body.
    pub body: ConnectionId,
    /// Fluid around it.
    pub fluid: Fluid,
    /// Method from velocities to sound; `None` for that of the fidelity.
    pub method: Option<SoundMethod>,
    /// Point (m) and normal of a rigid plane in front of which the body is, in ground coordinates.
    pub plane: Option<[Vector; 2]>,
    /// Points at which the pressure is requested, in ground coordinates, m.
    pub points: Vec<Vector>,
    /// Field meshes on which the pressure is requested.
    pub fields: Vec<FieldRequest>,
}

impl SoundRequest {
    /// Returns the method at a fidelity of the bodies: without a choice, boundary elements belong
    /// to finite elements, to pressures and to rigid planes, and the Rayleigh integral to closed
    /// forms.
    pub fn method_at(&self, fidelity: Fidelity) -> SoundMethod {
        let needs_field = self.needs_pressures() || self.plane.is_some();
        self.method.unwrap_or(match fidelity {
            _ if needs_field => SoundMethod::BoundaryElements,
            Fidelity::Rigid | Fidelity::Analytic | Fidelity::Plane => SoundMethod::Rayleigh,
            Fidelity::Solid(_) => SoundMethod::BoundaryElements,
        })
    }

    /// Returns true if pressures in the fluid are requested.
    pub(super) fn needs_pressures(&self) -> bool {
        !self.points.is_empty() || !self.fields.is_empty()
    }

    pub(super) fn connection<'s>(&self, scene: &'s Mechanism) -> Result<&'s ElasticConnection, EngineError> {
        scene.connections.get(self.body.0).ok_or_else(|| {
            refused("the scene has no such elastic body", "give a body of this model that is imported")
        })
    }
}

/// Requests of a scene at a fidelity, of which those with the same body, fluid, method and
/// plane are
/// one.
pub struct JoinedRequests {
    /// Distinct requests, with the points and field meshes of all that they replace. Each has a
    /// method.
    pub distinct: Vec<SoundRequest>,
    /// For each request of the scene, what replaces it.
    places: Vec<JoinedRequest>,
}

/// Indices of what replaces a request, its points and its field meshes.
#[derive(Clone, Debug, PartialEq)]
struct JoinedRequest {
    request: usize,
    points: Vec<usize>,
    fields: Vec<usize>,
}

impl JoinedRequests {
    /// Joins the requests of a scene.
    pub fn new(requests: &[SoundRequest], fidelity: Fidelity) -> JoinedRequests {
        let (mut distinct, mut places) = (Vec::<SoundRequest>::new(), Vec::new());
        for request in requests {
            let method = Some(request.method_at(fidelity));
            let is_same = |other: &SoundRequest| {
                let SoundRequest { body, fluid, plane, .. } = request;
                (other.body, other.fluid, other.method, other.plane) == (*body, *fluid, method, *plane)
            };
            let at = distinct.iter().position(is_same).unwrap_or_else(|| {
                let alone =
                    SoundRequest { method, points: Vec::new(), fields: Vec::new(), ..request.clone() };
                distinct.push(alone);
                distinct.len() - 1
            });
            let SoundRequest { points, fields, .. } = &mut distinct[at];
            places.push(JoinedRequest {
                request: at,
                points: request.points.iter().map(|point| position_of(points, point)).collect(),
                fields: request.fields.iter().map(|field| position_of(fields, field)).collect(),
            });
        }
        JoinedRequests { distinct, places }
    }

    /// Returns the index of the distinct request that replaces a request of the scene.
    pub fn request(&self, index: usize) -> Option<usize> {
        self.places.get(index).map(|place| place.request)
    }

    /// Returns the index, in the distinct request, of a point of a request of the scene.
    pub fn point(&self, request: usize, point: usize) -> Option<usize> {
        self.places.get(request)?.points.get(point).copied()
    }

    /// Returns the index, in the distinct request, of a field mesh of a request of the scene.
    pub fn field(&self, request: usize, field: usize) -> Option<usize> {
        self.places.get(request)?.fields.get(field).copied()
    }

    /// Replaces the subject of an error about a distinct request by the first one of the scene that
    /// it replaces.
    pub fn of_scene(&self, error: EngineError) -> EngineError {
        // Request of the scene, and the index of an item in it.
        let origin = |at: u32, item: u32, items: fn(&JoinedRequest) -> &Vec<usize>| {
            self.places.iter().enumerate().filter(|(_, place)| place.request == at as usize).find_map(
                |(index, place)| {
                    let position = items(place).iter().position(|other| *other == item as usize)?;
                    Some((index as u32, position as u32))
                },
            )
        };
        let subject = match error.subject {
            Some(Subject::Sound(at)) => {
                self.places.iter().position(|place| place.request == at).map(Subject::Sound)
            }
            Some(Subject::SoundPoint(at, point)) => {
                origin(at, point, |place| &place.points).map(|(at, point)| Subject::SoundPoint(at, point))
            }
            Some(Subject::SoundField(at, field)) => {
                origin(at, field, |place| &place.fields).map(|(at, field)| Subject::SoundField(at, field))
            }
            other => other,
        };
        EngineError { subject, ..error }
    }
}

/// Returns the index of an item, which is added if it is new.
pub(crate) fn position_of<T: Clone + PartialEq>(known: &mut Vec<T>, item: &T) -> usize {
    known.iter().position(|other| other == item).unwrap_or_else(|| {
        known.push(item.clone());
        known.len() - 1
    })
}
