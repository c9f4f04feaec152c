//! Stresses in the fillets of teeth.

use super::{Equilibrium, Needs, Observable, Quantity};
use calyx_model::ids::BodyId;
use calyx_model::observed::{Observed, Place};
use calyx_solve::system::Bodies;
use calyx_structure::{BodyModes, Chart, StressPlace, SurfaceLoad};

/// A stress in a fillet.
pub(super) struct RootStress {
    pub place: Place,
    /// The fillet beside which surface, as [`Chart::surface`] counts them.
    pub surface: u32,
    /// Coordinates on the fillet: along the profile from the end of the flank towards the root, and along the axis, m.
    pub chart: [f64; 2],
    /// In the body's frame, m.
    pub position: [f64; 3],
    /// Along the profile, along the face, and in shear, Pa; of a plane model only the first is known.
    pub components: [f64; 3],
    /// Largest and smallest principal stress in the surface, Pa; one of them is zero in a plane model.
    pub principal: [f64; 2],
}

/// Whose fillets are looked at.
#[derive(Clone, Copy)]
pub(super) enum Teeth {
    /// The loaded teeth, and as many neighbours on either side; all teeth of a body that vibrates while none of them is loaded.
    Near(u32),
    /// One tooth, loaded or not.
    One(u32),
}

/// On which sides of the teeth fillets are looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FilletSide {
    /// Beside the flanks that carry load: both, of a planet that is pressed on from both sides.
    Loaded,
    /// On the other side of the teeth from those.
    Other,
    /// Beside one flank, as [`Chart::surface`] counts them, loaded or not.
    Flank(u32),
    /// Both.
    Both,
}

/// The fillets of a gear that are looked at.
#[derive(Clone, Copy)]
pub(super) struct Fillets {
    pub teeth: Teeth,
    pub side: FilletSide,
}

impl Fillets {
    /// Tooth and surface of those of a gear of so many teeth that is loaded on these charts.
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

/// Surfaces of a body that the meshes it is in are made for.
fn driving_surfaces<'a>(at: &Equilibrium<'a>, body: BodyId) -> impl Iterator<Item = u32> + use<'a> {
    let pairs = at.system.scene.pairs.iter().filter(|pair| pair.front.is_none());
    pairs.flat_map(move |pair| {
        (0..2).filter(move |&side| pair.bodies[side] == body).map(|side| pair.surfaces[side])
    })
}

/// By how much the modal coordinates of a body differ from what they would be if its contact forces rested: what of its stress statics
/// does not know.
struct Vibration<'a> {
    modes: &'a BodyModes,
    beyond: Vec<f64>,
}

impl<'a> Vibration<'a> {
    /// `None` of a body without modes, and in equilibrium.
    fn of(at: &Equilibrium<'a>, body: BodyId, loads: &[SurfaceLoad]) -> Option<Vibration<'a>> {
        let (modes, first) = at.system.modes.of_body(body.0)?;
        let mut beyond = at.step.modal.get(first..first + modes.count())?.to_vec();
        for loads in loads.chunk_by(|one, next| one.chart == next.chart) {
            let places: Vec<f64> = loads.iter().map(|load| load.s).collect();
            let seen = modes.displacements(loads[0].chart, &places);
            for (k, beyond) in beyond.iter_mut().enumerate() {
                let pushed: f64 = loads.iter().zip(seen.col(k).iter()).map(|(load, c)| load.force * c).sum();
                *beyond -= pushed / modes.frequencies[k].powi(2);
            }
        }
        Some(Vibration { modes, beyond })
    }

    fn add_stresses(&self, tooth: u32, surface: u32, recovered: &mut [(StressPlace, f64)]) {
        let by_modes = self.modes.stresses(tooth, surface);
        for (row, (_, stress)) in recovered.iter_mut().enumerate().take(by_modes.nrows()) {
            *stress += by_modes.row(row).iter().zip(&self.beyond).map(|(by, q)| by * q).sum::<f64>();
        }
    }
}

/// The stresses in fillets of a body, those of one fillet together, of a body that vibrates those of its modes too. `None` of a body that is not modelled.
pub(super) fn stresses(at: &Equilibrium<'_>, body: BodyId, of: Fillets) -> Option<Vec<RootStress>> {
    let mut all = Vec::new();
    match &at.system.bodies {
        Bodies::Plane(bodies) => {
            let structure = bodies.structures.get(body.0)?.as_ref()?;
            let (loads, lugs) = (at.surface_loads(body), at.loose_lug_forces(body));
            let vibration = Vibration::of(at, body, &loads);
            let mut charts: Vec<Chart> = loads.iter().map(|load| load.chart).collect();
            // Where nothing is loaded teeth vibrate all the same, and none of them is nearer to a load than another.
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
                let by_lugs = structure.stresses_by_lugs(tooth, surface, &lugs);
                recovered.iter_mut().zip(by_lugs).for_each(|((_, stress), more)| *stress += more);
                if let Some(vibration) = &vibration {
                    vibration.add_stresses(tooth, surface, &mut recovered);
                }
                all.extend(recovered.into_iter().map(|(place, along)| RootStress {
                    place: at.place(body, place.tooth, place.position),
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
            let loads = at.spot_loads(body);
            let charts = loads.iter().map(|load| load.chart);
            for (tooth, surface) in of.near(charts, structure.teeth()) {
                let recovered = structure.stresses(tooth, surface, &loads);
                all.extend(recovered.into_iter().map(|stress| RootStress {
                    place: at.solid_place(body, stress.tooth, stress.position),
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

/// The stresses in the fillets on both sides of the loaded teeth and their neighbours. `None` of a body that is not modelled.
pub(super) fn around_contact(at: &Equilibrium<'_>, body: BodyId) -> Option<Vec<RootStress>> {
    stresses(at, body, Fillets { teeth: Teeth::Near(1), side: FilletSide::Both })
}

/// The largest principal stress in the fillets of a body, on its loaded side: 0 where all of them are pressed together, as those of a thin
/// free rim are beside a loaded tooth ([`MaxRootCompression`]). Pa.
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

fn largest(stresses: Option<Vec<RootStress>>, value: impl Fn(&RootStress) -> f64) -> Observed {
    let Some(stresses) = stresses else { return Observed::number(f64::NAN) };
    let mut largest = Observed::number(0.0);
    for stress in stresses {
        let value = value(&stress);
        // One that is no number stays to be seen, whatever comes after it.
        if value > largest.value || (value.is_nan() && !largest.value.is_nan()) {
            largest = Observed { value, least: None, place: Some(stress.place) };
        }
    }
    largest
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stresses(along: &[f64]) -> Option<Vec<RootStress>> {
        let place = Place { body: String::new(), tooth: 0, roll_angle: None, radius: 0.0, axial: None };
        let stress = |along: &f64| RootStress {
            place: place.clone(),
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
