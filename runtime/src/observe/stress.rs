//! Stresses in the fillets of teeth.

use super::{Equilibrium, Observable, Quantity};
use crate::results::{Observed, Place};
use crate::scene::BodyId;
use crate::structure::Chart;
use crate::system::Bodies;

/// A stress in a fillet.
pub(super) struct RootStress {
    pub place: Place,
    /// The fillet beside which surface, as [`Chart::surface`] counts them.
    pub surface: u32,
    /// In the body's frame, m.
    pub position: [f64; 3],
    /// Along the profile, along the face, and in shear, Pa; of a plane model only the first is known.
    pub components: [f64; 3],
    /// Largest and smallest principal stress in the surface, Pa; one of them is zero in a plane model.
    pub principal: [f64; 2],
}

/// The fillets of a gear that are looked at: of the loaded teeth and of as many neighbours on either side.
#[derive(Clone, Copy)]
struct Fillets {
    neighbours: u32,
    loaded_side: bool,
    other_side: bool,
}

impl Fillets {
    /// Tooth and surface of those of a gear of so many teeth that is loaded on these charts.
    fn near(self, loaded: impl Iterator<Item = Chart>, teeth: u32) -> Vec<(u32, u32)> {
        let mut near = Vec::new();
        for Chart { tooth, surface } in loaded {
            for step in 0..=2 * self.neighbours {
                let tooth = (tooth + teeth - self.neighbours % teeth + step) % teeth;
                near.extend(self.loaded_side.then_some((tooth, surface)));
                near.extend((self.other_side && surface < 2).then(|| (tooth, 1 - surface)));
            }
        }
        near.sort_unstable();
        near.dedup();
        near
    }
}

/// The stresses in fillets of a body, those of one fillet together. `None` of a body that is not modelled.
fn stresses(at: &Equilibrium<'_>, body: BodyId, of: Fillets) -> Option<Vec<RootStress>> {
    let mut all = Vec::new();
    match &at.system.bodies {
        Bodies::Plane(bodies) => {
            let structure = bodies.structures.get(body.0)?.as_ref()?;
            let loads = at.surface_loads(body);
            let charts = loads.iter().map(|load| load.chart);
            for (tooth, surface) in of.near(charts, structure.teeth()) {
                let recovered = structure.stresses(tooth, surface, &loads);
                all.extend(recovered.into_iter().map(|(place, along)| RootStress {
                    place: at.place(body, place.tooth, place.position),
                    surface,
                    position: [place.position[0], place.position[1], 0.0],
                    components: [along, 0.0, 0.0],
                    principal: [along.max(0.0), along.min(0.0)],
                }));
            }
        }
        Bodies::Solid(bodies) => {
            let structure = bodies.structures.get(body.0)?.as_ref()?;
            let loads = at.spot_loads(body);
            let charts = loads.iter().map(|load| load.chart);
            for (tooth, surface) in of.near(charts, structure.teeth()) {
                let recovered = structure.stresses(tooth, surface, &loads);
                all.extend(recovered.into_iter().map(|stress| RootStress {
                    place: at.solid_place(body, stress.tooth, stress.position),
                    surface,
                    position: stress.position,
                    components: stress.components,
                    principal: stress.principal(),
                }));
            }
        }
    }
    Some(all)
}

/// The stresses in the fillets on both sides of the loaded teeth and their neighbours. `None` of a body that is not modelled.
pub(super) fn around_contact(at: &Equilibrium<'_>, body: BodyId) -> Option<Vec<RootStress>> {
    stresses(at, body, Fillets { neighbours: 1, loaded_side: true, other_side: true })
}

/// The largest principal stress in the fillets of a body, on its loaded side. Pa.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaxRootStress(pub BodyId);

impl Observable for MaxRootStress {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("max_root_stress", "Pa")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        largest(
            stresses(at, self.0, Fillets { neighbours: 1, loaded_side: true, other_side: false }),
            |stress| stress.principal[0],
        )
    }

    fn stresses_of(&self) -> Option<BodyId> {
        Some(self.0)
    }
}

/// The largest compression in the fillets of a body, on either side of the loaded teeth: the smallest principal stress without its
/// sign. Pa.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaxRootCompression(pub BodyId);

impl Observable for MaxRootCompression {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("max_root_compression", "Pa")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        largest(around_contact(at, self.0), |stress| -stress.principal[1])
    }

    fn stresses_of(&self) -> Option<BodyId> {
        Some(self.0)
    }
}

/// The stress that a strain gauge at a place of the fillets measures: the largest of the loaded teeth and two neighbours on either
/// side, with the least beside it. Over a mesh cycle these are the ends of what each tooth goes through as it passes the mesh. Pa.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RootStressAt {
    /// Whose fillets.
    pub body: BodyId,
    /// Where on the fillet, m; beyond its ends, the nearest end.
    pub radius: f64,
    /// Along the axis from the middle of the face, m; a plane model has no such place.
    pub axial: f64,
    /// Beside the loaded flank, or beside the other one.
    pub loaded_side: bool,
    /// Of the gauge, counted from the profile towards the axis, rad; a plane model measures along the profile.
    pub direction: f64,
}

impl Observable for RootStressAt {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("root_stress_at", "Pa")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let of = Fillets { neighbours: 2, loaded_side: self.loaded_side, other_side: !self.loaded_side };
        let Some(mut stresses) = stresses(at, self.body, of) else { return Observed::number(f64::NAN) };
        stresses.sort_by(|a, b| {
            a.place.tooth.cmp(&b.place.tooth).then(order_along(a).total_cmp(&order_along(b)))
        });
        let teeth = stresses.chunk_by(|a, b| a.place.tooth == b.place.tooth);
        let mut measured: Vec<(f64, &Place)> =
            teeth.filter_map(|fillet| Some((self.gauge(fillet)?, &fillet.first()?.place))).collect();
        measured.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (Some((least, _)), Some((value, fillet))) = (measured.first(), measured.last()) else {
            return Observed { least: Some(0.0), ..Observed::number(0.0) };
        };
        let axial = fillet.axial.map(|_| self.axial);
        let place = Place { axial, ..at.place(self.body, fillet.tooth, [self.radius, 0.0]) };
        Observed { value: *value, least: Some(*least), place: Some(place) }
    }

    fn stresses_of(&self) -> Option<BodyId> {
        Some(self.body)
    }
}

/// Where along the face a stress is; all of a plane model are at one place.
fn order_along(stress: &RootStress) -> f64 {
    stress.place.axial.unwrap_or(0.0)
}

impl RootStressAt {
    /// What the gauge measures on one fillet, whose stresses are in order along the face.
    fn gauge(&self, fillet: &[RootStress]) -> Option<f64> {
        let (sine, cosine) = self.direction.sin_cos();
        let measured = |stress: &RootStress| match stress.place.axial {
            None => stress.components[0],
            Some(_) => {
                let [along, across, shear] = stress.components;
                along * cosine * cosine + across * sine * sine + 2.0 * shear * sine * cosine
            }
        };
        let section = |section: &[RootStress]| {
            let points: Vec<[f64; 2]> =
                section.iter().map(|stress| [stress.place.radius, measured(stress)]).collect();
            Some([order_along(section.first()?), interpolate(points, self.radius)?])
        };
        let sections = fillet.chunk_by(same_section);
        interpolate(sections.filter_map(section).collect(), self.axial)
    }
}

/// Whether two stresses are at one place along the face, to a nanometre.
pub(super) fn same_section(a: &RootStress, b: &RootStress) -> bool {
    (order_along(a) - order_along(b)).abs() < 1e-9
}

/// The value at `x` between points `[x, y]`, on straight lines between neighbours; beyond them, of the nearest one.
fn interpolate(mut points: Vec<[f64; 2]>, x: f64) -> Option<f64> {
    points.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let after = points.iter().position(|point| point[0] >= x);
    match after {
        Some(0) => points.first().map(|point| point[1]),
        None => points.last().map(|point| point[1]),
        Some(after) => {
            let ([x0, y0], [x1, y1]) = (points[after - 1], points[after]);
            Some(y0 + (y1 - y0) * (x - x0) / (x1 - x0))
        }
    }
}

fn largest(stresses: Option<Vec<RootStress>>, value: impl Fn(&RootStress) -> f64) -> Observed {
    let Some(stresses) = stresses else { return Observed::number(f64::NAN) };
    let mut largest = Observed::number(0.0);
    for stress in stresses {
        if value(&stress) > largest.value {
            largest = Observed { value: value(&stress), least: None, place: Some(stress.place) };
        }
    }
    largest
}
