//! Observables of stresses in tooth fillets.

use super::{Equilibrium, Needs, Observable, Quantity};
use calyx_model::ids::BodyId;
use calyx_model::observed::{Location, Observed};
use calyx_solve::system::Bodies;
use calyx_structure::{BodyModes, Chart, StressPoint, SurfaceLoad};

/// Stress at a point of a fillet.
pub(super) struct RootStress {
    pub location: Location,
    /// Surface next to the fillet, as in [`Chart::surface`].
    pub surface: u32,
    /// Coordinates on the fillet: along the profile from the end of the flank towards the root, and
    /// along the axis, m.
    pub chart: [f64; 2],
    /// Position in the body's frame, m.
    pub position: [f64; 3],
    /// Stress along the profile, along the face, and shear stress, Pa; a plane model provides only
    /// the first.
    pub components: [f64; 3],
    /// Largest and smallest principal stress in the surface, Pa; one of them is zero in a plane
    /// model.
    pub principal: [f64; 2],
}

/// Teeth whose fillets are evaluated.
#[derive(Clone, Copy)]
pub(super) enum Teeth {
    /// Loaded teeth, and this number of neighbours on either side; all teeth of a vibrating body if
    /// none is loaded.
    Near(u32),
    /// One tooth, loaded or not.
    One(u32),
}

/// Sides of the teeth whose fillets are evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FilletSide {
    /// Side of the loaded flanks; both sides of a planet that is loaded on both.
    Loaded,
    /// Side opposite to the loaded flanks.
    Other,
    /// Side of one flank, as in [`Chart::surface`], loaded or not.
    Flank(u32),
    /// Both sides.
    Both,
}

/// Fillets of a gear that are evaluated.
#[derive(Clone, Copy)]
pub(super) struct Fillets {
    pub teeth: Teeth,
    pub side: FilletSide,
}

impl Fillets {
    /// Returns tooth and surface of the fillets of a gear with this number of teeth and loads on
    /// these surfaces.
    fn near(self, loaded: impl Iterator<Item = Chart>, teeth: u32) -> Vec<(u32, u32)> {
        let mut near = Vec::new();
        for Chart { tooth, surface } in loaded {
            let (first, count) = match self.teeth {
                Teeth::Near(neighbours) => (tooth + teeth - neighbours % teeth, 2 * neighbours + 1),
                Teeth::One(tooth) => (tooth, 1),
            };
            for step in 0..count {
                let tooth = (first + step) % teeth;
                let other = (surface < 2).then(|| (tooth, 1 - surface));
                match self.side {
                    FilletSide::Loaded => near.push((tooth, surface)),
                    FilletSide::Other => near.extend(other),
                    FilletSide::Flank(flank) => near.push((tooth, flank)),
                    FilletSide::Both => near.extend([(tooth, surface)].into_iter().chain(other)),
                }
            }
        }
        near.sort_unstable();
        near.dedup();
        near
    }
}

/// Returns the drive flanks of the body's meshes.
fn driving_surfaces<'a>(at: &Equilibrium<'a>, body: BodyId) -> impl Iterator<Item = u32> + use<'a> {
    let pairs = at.system.scene.pairs.iter().filter(|pair| pair.front.is_none());
    pairs.flat_map(move |pair| {
        (0..2).filter(move |&side| pair.bodies[side] == body).map(|side| pair.surfaces[side])
    })
}

/// Difference of a body's modal coordinates from their static values under the same contact forces:
/// the dynamic part of its stress.
struct Vibration<'a> {
    modes: &'a BodyModes,
    beyond: Vec<f64>,
}

impl<'a> Vibration<'a> {
    /// Computes the difference; `None` for a body without modes, and in equilibrium.
    fn of(at: &Equilibrium<'a>, body: BodyId, loads: &[SurfaceLoad]) -> Option<Vibration<'a>> {
        let (modes, first) = at.system.modes.of_body(body.0)?;
        let mut beyond = at.step.modal.get(first..first + modes.count())?.to_vec();
        for loads in loads.chunk_by(|one, next| one.chart == next.chart) {
            let places: Vec<f64> = loads.iter().map(|load| load.s).collect();
            let seen = modes.displacements(loads[0].chart, &places);
            for (k, beyond) in beyond.iter_mut().enumerate() {
                let modal_force: f64 =
                    loads.iter().zip(seen.col(k).iter()).map(|(load, c)| load.force * c).sum();
                *beyond -= modal_force / modes.frequencies[k].powi(2);
            }
        }
        Some(Vibration { modes, beyond })
    }

    fn add_stresses(&self, tooth: u32, surface: u32, recovered: &mut [(StressPoint, f64)]) {
        let by_modes = self.modes.stresses(tooth, surface);
        for (row, (_, stress)) in recovered.iter_mut().enumerate().take(by_modes.nrows()) {
            *stress += by_modes.row(row).iter().zip(&self.beyond).map(|(by, q)| by * q).sum::<f64>();
        }
    }
}

/// Returns the stresses in fillets of a body, grouped by fillet, including those of its modes if it
/// vibrates. `None` for a body that is not modelled.
pub(super) fn stresses(at: &Equilibrium<'_>, body: BodyId, of: Fillets) -> Option<Vec<RootStress>> {
    let mut all = Vec::new();
    match &at.system.bodies {
        Bodies::Plane(bodies) => {
            let structure = bodies.structures.get(body.0)?.as_ref()?;
            let (loads, on_bore) = (at.surface_loads(body), at.interface_forces(body));
            let vibration = Vibration::of(at, body, &loads);
            let mut charts: Vec<Chart> = loads.iter().map(|load| load.chart).collect();
            // Without load, teeth vibrate nevertheless, and all are equivalent.
            if charts.is_empty() && vibration.is_some() {
                let teeth = match of.teeth {
                    Teeth::Near(_) => structure.teeth(),
                    Teeth::One(_) => 1,
                };
                let all = |surface| (0..teeth).map(move |tooth| Chart { tooth, surface });
                charts.extend(driving_surfaces(at, body).flat_map(all));
            }
            for (tooth, surface) in of.near(charts.into_iter(), structure.teeth()) {
                let mut recovered = structure.stresses(tooth, surface, &loads);
                let by_bore = structure.stresses_by_interface(tooth, surface, &on_bore);
                recovered.iter_mut().zip(by_bore).for_each(|((_, stress), more)| *stress += more);
                if let Some(vibration) = &vibration {
                    vibration.add_stresses(tooth, surface, &mut recovered);
                }
                all.extend(recovered.into_iter().map(|(place, along)| RootStress {
                    location: at.location(body, place.tooth, place.position),
                    surface,
                    chart: [place.s, 0.0],
                    position: [place.position[0], place.position[1], 0.0],
                    components: [along, 0.0, 0.0],
                    principal: [along.max(0.0), along.min(0.0)],
                }));
            }
        }
        Bodies::Solid(bodies) => {
            let structure = bodies.structures.get(body.0)?.as_ref()?;
            let (loads, on_bore) = (at.segment_loads(body), at.interface_forces(body));
            let charts = loads.iter().map(|load| load.chart);
            for (tooth, surface) in of.near(charts, structure.teeth()) {
                let mut recovered = structure.stresses(tooth, surface, &loads);
                let by_bore = structure.stresses_by_interface(tooth, surface, &on_bore);
                for (stress, more) in recovered.iter_mut().zip(by_bore) {
                    stress.components.iter_mut().zip(more).for_each(|(own, more)| *own += more);
                }
                all.extend(recovered.into_iter().map(|stress| RootStress {
                    location: at.solid_location(body, stress.tooth, stress.position),
                    surface,
                    chart: stress.place,
                    position: stress.position,
                    components: stress.components,
                    principal: stress.principal(),
                }));
            }
        }
    }
    Some(all)
}

/// Returns the stresses in the fillets on both sides of the loaded teeth and their neighbours.
/// `None` for a body that is not modelled.
pub(super) fn around_contact(at: &Equilibrium<'_>, body: BodyId) -> Option<Vec<RootStress>> {
    stresses(at, body, Fillets { teeth: Teeth::Near(1), side: FilletSide::Both })
}

/// Largest principal stress in the fillets of a body on the loaded side, Pa. Zero if all are in
/// compression, as in a thin free rim next to a loaded tooth ([`MaxRootCompression`]).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaxRootStress(pub BodyId);

impl Observable for MaxRootStress {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("max_root_stress", "Pa")
    }

    fn needs(&self) -> Needs {
        Needs::RootStress
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        largest(stresses(at, self.0, Fillets { teeth: Teeth::Near(1), side: FilletSide::Loaded }), |stress| {
            stress.principal[0]
        })
    }

    fn stresses_of(&self) -> Option<BodyId> {
        Some(self.0)
    }
}

/// Largest compression in the fillets of a body, on either side of the loaded teeth: the magnitude
/// of the smallest principal stress, Pa.
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

fn largest(stresses: Option<Vec<RootStress>>, value: impl Fn(&RootStress) -> f64) -> Observed {
    let Some(stresses) = stresses else { return Observed::number(f64::NAN) };
    let mut largest = Observed::number(0.0);
    for stress in stresses {
        let value = value(&stress);
        // NaN must persist.
        if value > largest.value || (value.is_nan() && !largest.value.is_nan()) {
            largest = Observed { value, least: None, location: Some(stress.location) };
        }
    }
    largest
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stresses(along: &[f64]) -> Option<Vec<RootStress>> {
        let location = Location { body: String::new(), tooth: 0, roll_angle: None, radius: 0.0, axial: None };
        let stress = |along: &f64| RootStress {
            location: location.clone(),
            surface: 0,
            chart: [0.0; 2],
            position: [0.0; 3],
            components: [*along, 0.0, 0.0],
            principal: [*along; 2],
        };
        Some(along.iter().map(stress).collect())
    }

    #[test]
    fn the_largest_of_stresses_is_no_number_if_one_of_them_is_none() {
        let largest = |along: &[f64]| largest(stresses(along), |stress| stress.principal[0]).value;
        assert_eq!(largest(&[1.0, 3.0, 2.0]), 3.0);
        assert_eq!(largest(&[-1.0, -2.0]), 0.0);
        for along in [[f64::NAN, 3.0, 2.0], [3.0, f64::NAN, 5.0], [-1.0, -2.0, f64::NAN]] {
            assert!(largest(&along).is_nan(), "{along:?}");
        }
    }
}
