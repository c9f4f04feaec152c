//! Frequencies that excite a scene: those of its meshes, and of the carriers that rotate.

use super::ForcedResponseRequest;
use calyx_model::frames::axes;
use calyx_model::ids::{BodyId, PairId};
use calyx_model::mechanism::Mechanism;
use calyx_model::motion::angular_velocity;
use calyx_model::pairs::{GearMesh, SurfacePair};
use calyx_numerics::error::{EngineError, Subject};
use calyx_numerics::vec3::{dot, length, minus};
use calyx_solve::forced_response::orders::{Line, Modulation, Orders};
use calyx_solve::forced_response::sampling::Sampling;
use std::f64::consts::TAU;

/// Relative difference of frequencies that counts as rounding.
const SAME: f64 = 1e-9;
/// Largest number of cycles of a mesh in a common period of all frequencies.
const CYCLES: i64 = 1_000_000;
/// Smallest number of positions for each mesh frequency.
const POSITIONS: usize = 128;
/// Largest number of positions.
const MOST: usize = 20_000;
/// Change of the direction of an axis that counts as rounding.
const TILTED: f64 = 1e-9;
/// Fractions of a revolution of a carrier after which directions of axes are compared.
const LATER: [f64; 2] = [0.13, 0.38];

/// Frequencies that excite a scene, and the orders of its vibration.
pub(super) struct Excitation {
    /// Speed of the first gear of the request, rad/s.
    pub speed: f64,
    /// Time after which all meshes and carriers repeat, s.
    pub period: f64,
    /// Positions in the period.
    pub sampling: Sampling,
    /// Orders of the vibration, relative to the frequency of the period.
    pub orders: Orders,
    /// Names of the first mesh of each frequency.
    meshes: Vec<String>,
    /// Names of the carriers.
    carriers: Vec<String>,
}

impl Excitation {
    /// Determines the frequencies of a scene at its speeds. The first mesh frequency is that of the
    /// request.
    ///
    /// # Errors
    /// E0774: the axes of a mesh tilt with their carrier, teeth of a gear are not equal, or the
    /// frequencies have no common period or need too many positions.
    pub fn new(scene: &Mechanism, request: &ForcedResponseRequest) -> Result<Excitation, EngineError> {
        let own = &scene.pairs[request.mesh.0];
        let Some(own_mesh) = own.mesh.as_ref() else {
            return Err(refused("the mesh of the forced response has no gears", "give a mesh of two gears"));
        };
        let first = &scene.bodies[own.bodies[0].0];
        let speed = length(angular_velocity(first.motion.as_ref(), own_mesh.start));
        if speed == 0.0 {
            let message =
                format!("the gear \"{}\" does not rotate, and its speed is the abscissa", first.name);
            let help = "give a mesh whose first gear rotates, such as that of a planet with the ring";
            return Err(refused(&message, help));
        }
        let mut meshes: Vec<(f64, PairId)> = vec![(1.0 / own_mesh.period, request.mesh)];
        let mut carriers: Vec<(f64, String)> = Vec::new();
        for (index, pair) in scene.pairs.iter().enumerate().filter(|(_, pair)| pair.front.is_none()) {
            let Some(mesh) = &pair.mesh else { continue };
            check_teeth(scene, pair, mesh)?;
            let frequency = 1.0 / mesh.period;
            if meshes.iter().all(|(other, _)| !is_same(frequency, *other)) {
                meshes.push((frequency, PairId(index)));
            }
            let turns = length(mesh.carrier) / TAU;
            if turns > 0.0 {
                check_axes(scene, pair, turns)?;
                if carriers.iter().all(|(other, _)| !is_same(turns, *other)) {
                    carriers.push((turns, carrier_name(scene, pair, mesh)));
                }
            }
        }
        let frequencies: Vec<f64> =
            meshes.iter().map(|mesh| mesh.0).chain(carriers.iter().map(|carrier| carrier.0)).collect();
        let Some(cycles) = common_cycles(&frequencies) else {
            let message =
                "the mesh frequencies and the rotational frequencies of carriers have no common period";
            let help = "give speeds whose ratio is a fraction, such as 1450 rpm and 1000 rpm";
            return Err(refused(message, help));
        };
        let (of_meshes, of_carriers) = cycles.split_at(meshes.len());
        let orders = Orders::new(of_meshes, of_carriers, request.harmonics);
        let Some(sampling) = orders.sampling(POSITIONS, MOST) else {
            let message = format!(
                "the forced response needs more than {MOST} positions to distinguish the harmonics of {} mesh frequencies",
                meshes.len()
            );
            return Err(refused(&message, "give fewer `harmonics`"));
        };
        Ok(Excitation {
            speed,
            period: own_mesh.period * of_meshes[0] as f64,
            sampling,
            orders,
            meshes: meshes.iter().map(|(_, pair)| mesh_name(scene, *pair)).collect(),
            carriers: carriers.into_iter().map(|(_, name)| name).collect(),
        })
    }

    /// Returns the names of a line's mesh, and of the carrier or the mesh that causes its
    /// sidebands; empty if it does not depend on them.
    pub fn names(&self, line: Line) -> [String; 2] {
        let mesh = if line.harmonic > 0 { self.meshes[line.mesh].clone() } else { String::new() };
        let modulation = line.modulation.map_or(String::new(), |modulation| match modulation {
            Modulation::Carrier(index) => self.carriers[index].clone(),
            Modulation::Mesh(index) => self.meshes[index].clone(),
        });
        [mesh, modulation]
    }
}

fn refused(message: &str, help: &str) -> EngineError {
    EngineError::new("E0774", message, help).about(Subject::ForcedResponse)
}

fn is_same(one: f64, other: f64) -> bool {
    (one / other - 1.0).abs() <= SAME
}

/// Returns the names of both gears of a mesh.
fn mesh_name(scene: &Mechanism, pair: PairId) -> String {
    scene.pairs[pair.0].bodies.map(|body| scene.bodies[body.0].name.as_str()).join(", ")
}

/// Returns the name of a body that rotates as the carrier of a mesh and has no teeth.
fn carrier_name(scene: &Mechanism, pair: &SurfacePair, mesh: &GearMesh) -> String {
    let speed = length(mesh.carrier);
    let is_geared = |index: usize| scene.pairs.iter().any(|pair| pair.bodies.contains(&BodyId(index)));
    let rotates = |index: usize| {
        let own = angular_velocity(scene.bodies[index].motion.as_ref(), 0.0);
        length(minus(own, mesh.carrier)) <= SAME * speed
    };
    let found = (0..scene.bodies.len()).find(|&index| rotates(index) && !is_geared(index));
    match found {
        Some(index) => scene.bodies[index].name.clone(),
        None => {
            format!("carrier of {}", pair.bodies.map(|body| scene.bodies[body.0].name.as_str()).join(", "))
        }
    }
}

/// Checks that the teeth of both gears of a mesh are equal.
fn check_teeth(scene: &Mechanism, pair: &SurfacePair, mesh: &GearMesh) -> Result<(), EngineError> {
    for (body, teeth) in pair.bodies.into_iter().zip(mesh.teeth) {
        let own = &scene.bodies[body.0];
        if (0..teeth).any(|tooth| own.prototype.pitch_error(tooth) != 0.0) {
            let message = format!(
                "the gear \"{}\" has pitch deviations, so the forced response does not repeat with its teeth",
                own.name
            );
            return Err(refused(&message, "remove the pitch deviations, or use time integration"));
        }
    }
    Ok(())
}

/// Checks that the axes of a mesh keep their directions as its carrier rotates, at its revolutions
/// per second.
fn check_axes(scene: &Mechanism, pair: &SurfacePair, turns: f64) -> Result<(), EngineError> {
    for body in pair.bodies {
        let [_, _, first] = axes(scene, body.0, 0.0);
        let tilts = |fraction: &f64| {
            let [_, _, later] = axes(scene, body.0, fraction / turns);
            1.0 - dot(first, later) > TILTED
        };
        if LATER.iter().any(tilts) {
            let message = format!(
                "the axis of \"{}\" tilts as its carrier rotates, and a forced response needs axes of constant direction",
                scene.bodies[body.0].name
            );
            let help = "leave out the gears on tilting axes, such as those of a differential, and model their torques";
            return Err(refused(&message, help));
        }
    }
    Ok(())
}

/// Returns the numbers of cycles of frequencies in their shortest common period; `None` if the
/// first has more than [`CYCLES`].
fn common_cycles(frequencies: &[f64]) -> Option<Vec<i64>> {
    let first = *frequencies.first()?;
    let mut common = 1_i64;
    for frequency in frequencies {
        let denominator = denominator(frequency / first)?;
        common = common.checked_mul(denominator / gcd(common, denominator)).filter(|&all| all <= CYCLES)?;
    }
    let cycles = |frequency: &f64| (frequency / first * common as f64).round() as i64;
    let cycles: Vec<i64> = frequencies.iter().map(cycles).collect();
    cycles.iter().all(|&own| (1..=CYCLES).contains(&own)).then_some(cycles)
}

/// Returns the smallest denominator of a fraction that is equal to a ratio up to rounding, from its
/// continued fraction.
fn denominator(ratio: f64) -> Option<i64> {
    let (mut rest, mut denominators) = (ratio, [0_i64, 1]);
    loop {
        let whole = (ratio * denominators[1] as f64).round();
        if (whole / denominators[1] as f64 - ratio).abs() <= SAME * ratio {
            return Some(denominators[1]);
        }
        rest = (rest - rest.floor()).recip();
        let next = (rest.floor() as i64).checked_mul(denominators[1])?.checked_add(denominators[0])?;
        if next > CYCLES {
            return None;
        }
        denominators = [denominators[1], next];
    }
}

fn gcd(mut one: i64, mut other: i64) -> i64 {
    while other != 0 {
        (one, other) = (other, one % other);
    }
    one
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_teeth_give_a_common_period() {
        for (frequencies, cycles) in [
            (vec![500.0], Some(vec![1])),
            (vec![500.0, 500.0 * 31.0 / 47.0], Some(vec![47, 31])),
            (vec![40.0, 15.0, 5.0], Some(vec![8, 3, 1])),
            (vec![99.0 * 3.7, 3.7], Some(vec![99, 1])),
            (vec![1.0, 2.0_f64.sqrt(), 3.0_f64.sqrt()], None),
        ] {
            assert_eq!(common_cycles(&frequencies), cycles, "{frequencies:?}");
        }
    }
}
