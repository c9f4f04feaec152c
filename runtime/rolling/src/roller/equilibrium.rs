//! Equilibrium of one roller between the raceways.

use super::geometry::RollerRow;
use crate::element::{Local, Response};
use crate::hertz::line::{EXPONENT, ninth_root, pressure};
use crate::linear::{dot, solve};

/// Largest number of steps of a roller's equilibrium.
const STEPS: usize = 80;
/// Residual relative to the sum of the forces on a roller.
const TOLERANCE: f64 = 1e-13;

/// One contact line of a roller.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LineContact {
    /// Contact load, N.
    pub load: f64,
    /// Moment of the load about the middle of the contact line, N m.
    pub moment: f64,
    /// Positions of the laminae from the middle of the contact line, m; away from the apex of
    /// tapered rollers, and towards -z for cylindrical ones.
    pub positions: Vec<f64>,
    /// Loads per length of the laminae, N/m.
    pub loads: Vec<f64>,
    /// Pressures of the laminae, Pa.
    pub pressures: Vec<f64>,
    /// Largest pressure of the laminae, Pa.
    pub pressure: f64,
    /// Position of the largest pressure, m.
    pub pressure_position: f64,
}

/// State of one roller.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RollerState {
    /// Contact with the inner raceway.
    pub inner: LineContact,
    /// Contact with the outer raceway.
    pub outer: LineContact,
    /// Load of the rib, N.
    pub rib: f64,
    /// Displacement of the roller: radial, m; axial, m; rotation from radial to axial, rad.
    pub displacement: [f64; 3],
}

/// Potential energy of a roller with its derivatives with respect to the displacement of the
/// roller.
struct Energy {
    energy: f64,
    gradient: [f64; 3],
    hessian: [[f64; 3]; 3],
    /// Sum of the magnitudes of all forces, N.
    scale: f64,
}

impl RollerRow {
    /// Computes the response of a roller with a centrifugal force, N. `start` has the displacement
    /// of the roller at a near displacement of the ring, if any, and receives the one found.
    pub(crate) fn response(&self, ring: &Local, force: f64, start: &mut Option<[f64; 3]>) -> Response {
        let approaches = self.approaches(ring);
        let (roller, converged) = self.settle(&approaches, force, *start);
        *start = Some(roller);
        let mut response = Response { unconverged: !converged, ..Response::default() };
        let mut coupling = [[0.0; 3]; 3];
        let mut stiffness = [[0.0; 3]; 3];
        self.for_each_contact(&approaches, &roller, |ring, approach, load, slope, _| {
            let is_inner = ring != &[0.0; 3];
            for i in 0..3 {
                response.force[i] += load * ring[i];
                for j in 0..3 {
                    stiffness[i][j] += slope * approach[i] * approach[j];
                    if is_inner {
                        response.stiffness[i][j] += slope * ring[i] * ring[j];
                        coupling[i][j] += slope * approach[i] * ring[j];
                    }
                }
            }
        });
        if coupling == [[0.0; 3]; 3] {
            return response;
        }
        self.constrain(&mut stiffness);
        let mut solution = coupling;
        if self.free_axially {
            solution[1] = [0.0; 3];
        }
        if solve(stiffness, &mut solution) {
            for i in 0..3 {
                for j in 0..3 {
                    for k in 0..3 {
                        response.stiffness[i][j] -= coupling[k][i] * solution[k][j];
                    }
                }
            }
        }
        response
    }

    /// Computes the loads and pressures of a roller.
    pub(crate) fn state(&self, ring: &Local, force: f64) -> RollerState {
        let approaches = self.approaches(ring);
        let (roller, _) = self.settle(&approaches, force, None);
        let mut state = RollerState { displacement: roller, ..RollerState::default() };
        let per_length = self.geometry.laminae as f64 / self.geometry.length;
        let halves = self.laminae.split_at(self.geometry.laminae);
        let starts = approaches.split_at(self.geometry.laminae);
        for (contact, laminae, approaches) in
            [(&mut state.inner, halves.0, starts.0), (&mut state.outer, halves.1, starts.1)]
        {
            for (lamina, approach) in laminae.iter().zip(approaches) {
                let (load, _) = self.lamina_load(approach + dot(&lamina.roller, &roller));
                let (per_length, position) = (load * per_length, lamina.position);
                contact.load += load;
                contact.moment += load * position;
                contact.positions.push(position);
                contact.loads.push(per_length);
                let pressure = pressure(per_length, lamina.radius, self.modulus);
                contact.pressures.push(pressure);
                if pressure > contact.pressure {
                    (contact.pressure, contact.pressure_position) = (pressure, position);
                }
            }
        }
        if let Some(rib) = &self.rib {
            let approach = approaches[approaches.len() - 1] + dot(&rib.roller, &roller);
            state.rib = rib.stiffness * approach.max(0.0) * approach.max(0.0).sqrt();
        }
        state
    }

    /// Returns the approach of each contact at zero displacement of the roller.
    fn approaches(&self, ring: &Local) -> Vec<f64> {
        let laminae = self.laminae.iter().map(|lamina| dot(&lamina.ring, ring) - lamina.relief);
        laminae.chain(self.rib.iter().map(|rib| dot(&rib.ring, ring))).collect()
    }

    /// Returns load and stiffness of a lamina.
    #[inline]
    fn lamina_load(&self, approach: f64) -> (f64, f64) {
        if approach <= 0.0 {
            return (0.0, 0.0);
        }
        let slope = self.coefficient * ninth_root(approach);
        (slope * approach, EXPONENT * slope)
    }

    /// Calls a function for each loaded contact with its `ring` and `roller`, its load, stiffness
    /// and potential energy.
    #[inline]
    fn for_each_contact(
        &self,
        approaches: &[f64],
        roller: &[f64; 3],
        mut call: impl FnMut(&[f64; 3], &[f64; 3], f64, f64, f64),
    ) {
        for (lamina, start) in self.laminae.iter().zip(approaches) {
            let approach = start + dot(&lamina.roller, roller);
            if approach > 0.0 {
                let (load, slope) = self.lamina_load(approach);
                call(&lamina.ring, &lamina.roller, load, slope, 9.0 / 19.0 * load * approach);
            }
        }
        if let Some(rib) = &self.rib {
            let approach = approaches[approaches.len() - 1] + dot(&rib.roller, roller);
            if approach > 0.0 {
                let slope = 1.5 * rib.stiffness * approach.sqrt();
                let load = slope * approach / 1.5;
                call(&rib.ring, &rib.roller, load, slope, 0.4 * load * approach);
            }
        }
    }

    /// Computes the potential energy of a roller.
    fn energy(&self, approaches: &[f64], roller: &[f64; 3], force: f64) -> Energy {
        let mut result = Energy {
            energy: -force * roller[0],
            gradient: [-force, 0.0, 0.0],
            hessian: [[0.0; 3]; 3],
            scale: force.abs(),
        };
        self.for_each_contact(approaches, roller, |_, approach, load, slope, energy| {
            result.energy += energy;
            result.scale += load;
            for i in 0..3 {
                result.gradient[i] += load * approach[i];
                for j in 0..=i {
                    result.hessian[i][j] += slope * approach[i] * approach[j];
                }
            }
        });
        for i in 0..3 {
            for j in i + 1..3 {
                result.hessian[i][j] = result.hessian[j][i];
            }
        }
        if self.free_axially {
            result.gradient[1] = 0.0;
        }
        result
    }

    /// Keeps the axial position of a roller that slides freely, and adds a stiffness that leaves no
    /// displacement without resistance and that rounding exceeds otherwise.
    fn constrain(&self, stiffness: &mut [[f64; 3]; 3]) {
        let arm = 0.5 * self.geometry.length;
        let trace = stiffness[0][0] + stiffness[1][1] + stiffness[2][2] / (arm * arm);
        let least =
            1e-13 * trace + 1e-12 * self.coefficient * ninth_root(1e-3 * self.geometry.roller_diameter);
        for (k, scale) in [1.0, 1.0, arm * arm].into_iter().enumerate() {
            stiffness[k][k] += scale * least;
        }
        if self.free_axially {
            for k in 0..3 {
                stiffness[1][k] = 0.0;
                stiffness[k][1] = 0.0;
            }
            stiffness[1][1] = 1.0;
        }
    }

    /// Returns the displacement of the roller that shares the approaches evenly among all contacts.
    fn start(&self, approaches: &[f64]) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for (lamina, approach) in self.laminae.iter().zip(approaches) {
            for k in 0..3 {
                sum[k] -= lamina.roller[k] * approach;
            }
        }
        if let Some(rib) = &self.rib {
            let weighted = self.rib_weight() * approaches[approaches.len() - 1];
            for k in 0..3 {
                sum[k] -= rib.roller[k] * weighted;
            }
        }
        if self.free_axially {
            sum[1] = 0.0;
        }
        [0, 1, 2].map(|k| dot(&self.start[k], &sum))
    }

    /// Minimizes the potential energy of a roller, which is convex, by Newton's method with a line
    /// search. Returns the displacement of the roller and whether its residual is small.
    fn settle(&self, approaches: &[f64], force: f64, start: Option<[f64; 3]>) -> ([f64; 3], bool) {
        let arm = 0.5 * self.geometry.length;
        let size = |gradient: &[f64; 3]| {
            let moment = gradient[2] / arm;
            (gradient[0] * gradient[0] + gradient[1] * gradient[1] + moment * moment).sqrt()
        };
        // A force without importance: an unloaded roller leaves its last contact geometrically.
        let approach = 1e-9 * self.geometry.roller_diameter;
        let negligible = self.geometry.laminae as f64 * self.lamina_load(approach).0;
        let mut roller = self.start(approaches);
        let mut current = self.energy(approaches, &roller, force);
        if let Some(start) = start {
            let at_start = self.energy(approaches, &start, force);
            if at_start.energy < current.energy {
                (roller, current) = (start, at_start);
            }
        }
        for _ in 0..STEPS {
            let residual = size(&current.gradient);
            if residual <= TOLERANCE * (current.scale + negligible) {
                return (roller, true);
            }
            let mut hessian = current.hessian;
            self.constrain(&mut hessian);
            let mut step = current.gradient.map(|x| [-x]);
            if !solve(hessian, &mut step) {
                break;
            }
            let step = step.map(|[x]| x);
            // A roller without contact has almost no stiffness: limit the step.
            let length = step[0].abs().max(step[1].abs()).max(arm * step[2].abs());
            let limit = (0.1 * self.geometry.roller_diameter / length).min(1.0);
            let step = step.map(|x| limit * x);
            let slope = dot(&current.gradient, &step);
            let mut fraction = 1.0;
            let next = loop {
                let next = [0, 1, 2].map(|k| roller[k] + fraction * step[k]);
                let trial = self.energy(approaches, &next, force);
                if trial.energy <= current.energy + 1e-4 * fraction * slope
                    || size(&trial.gradient) < 0.9 * residual
                {
                    break Some((next, trial));
                }
                fraction *= 0.5;
                if fraction < 1e-10 {
                    break None;
                }
            };
            // Rounding hides the rest of the residual.
            let Some((next, trial)) = next else { break };
            let stalled =
                residual <= 1e-11 * (current.scale + negligible) && size(&trial.gradient) >= 0.5 * residual;
            (roller, current) = (next, trial);
            if stalled {
                break;
            }
        }
        let residual = size(&current.gradient);
        (roller, residual <= 1e-9 * (current.scale + negligible))
    }
}
