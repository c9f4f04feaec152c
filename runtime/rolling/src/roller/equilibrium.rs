//! Equilibrium of one roller between the raceways.

use super::geometry::Lamina;
use super::row::RollerRow;
use super::state::{Energy, LineContact, Memory, RollerStart, RollerState, Tangent};
use super::strips::StripLoads;
use crate::element::{Local, Response};
use crate::hertz::line::{EXPONENT, ninth_root, pressure};
use crate::linear::{dot, solve};

/// Largest number of steps of a roller's equilibrium.
const STEPS: usize = 80;
/// Largest number of steps of a roller and its strips together.
const JOINT_STEPS: usize = 14;
/// Residual relative to the sum of the forces on a roller.
const TOLERANCE: f64 = 1e-13;
/// Residual of an equilibrium that counts as found, where rounding hides the rest.
const CONVERGED: f64 = 1e-9;
/// A roller whose gap to the inner ring between laminae is so many times its approach to the outer
/// one is clear of the inner ring with elastic contacts too.
const CLEAR: f64 = 100.0;

impl RollerRow {
    /// Computes the response of a roller with a centrifugal force, N. `start` has the state of the
    /// roller at a near displacement of the ring, if any, and receives the one found.
    pub(crate) fn response(&self, ring: &Local, force: f64, start: &mut RollerStart) -> Response {
        let (ring_displacement, centrifugal) = (ring, force);
        let approaches = self.approaches(ring);
        let mut memory = Memory { strips: std::mem::take(&mut start.strips), ..Memory::default() };
        let mut first = start.displacement;
        let mut laminae = None;
        if self.elastic.is_some() {
            // Elastic contacts change as laminae do.
            let (between, loaded) = self.between_laminae(ring, force);
            if self.is_clear_of_inner_ring(ring, &between) {
                *start = RollerStart::default();
                return Response::default();
            }
            laminae = loaded.then_some(between);
            first = Some(match (first, laminae, start.laminae) {
                (Some(roller), Some(now), Some(before)) => [0, 1, 2].map(|k| roller[k] + now[k] - before[k]),
                _ => between,
            });
        }
        let (roller, converged) = self.settle(&approaches, force, first, &mut memory);
        let Tangent { force, ring, roller: mut stiffness, coupling } =
            self.tangent(&approaches, &roller, &mut memory);
        let finite = roller.iter().chain(&force).chain(stiffness.iter().flatten()).all(|x| x.is_finite());
        if let (Some(plain), false) = (&self.plain, finite) {
            // Half-widths beyond all dimensions: laminae have loads at any approach.
            *start = RollerStart::default();
            let between = plain.response(ring_displacement, centrifugal, &mut RollerStart::default());
            return Response { unconverged: true, ..between };
        }
        *start = RollerStart { displacement: Some(roller), strips: memory.strips, laminae };
        let mut response = Response { force, stiffness: ring, unconverged: !converged };
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

    /// Computes forces and derivatives of all contacts at an equilibrium.
    fn tangent(&self, approaches: &[f64], roller: &[f64; 3], memory: &mut Memory) -> Tangent {
        let mut tangent = Tangent::default();
        let add = |ring: &[f64; 3], approach: &[f64; 3], load, slope, _| {
            let is_inner = ring != &[0.0; 3];
            for i in 0..3 {
                tangent.force[i] += load * ring[i];
                for j in 0..3 {
                    tangent.roller[i][j] += slope * approach[i] * approach[j];
                    if is_inner {
                        tangent.ring[i][j] += slope * ring[i] * ring[j];
                        tangent.coupling[i][j] += slope * approach[i] * ring[j];
                    }
                }
            }
        };
        match &self.elastic {
            None => self.for_each_contact(approaches, roller, add),
            Some(elastic) => {
                self.rib_load(approaches, roller, add);
                elastic.add_tangent(memory, &mut tangent);
            }
        }
        tangent
    }

    /// Computes the loads and pressures of a roller. `start` has its state at a nearby
    /// displacement of the ring, if any.
    pub(crate) fn state(&self, ring: &Local, force: f64, start: Option<&RollerStart>) -> RollerState {
        let approaches = self.approaches(ring);
        let mut memory = Memory::default();
        let first = match start.and_then(|start| Some((start.displacement?, start))) {
            Some((displacement, start)) => {
                memory.strips = start.strips.clone();
                Some(displacement)
            }
            None => self.elastic.is_some().then(|| self.between_laminae(ring, force).0),
        };
        let (roller, _) = self.settle(&approaches, force, first, &mut memory);
        let mut state = RollerState { displacement: roller, ..RollerState::default() };
        match &self.elastic {
            None => self.lamina_contacts(&approaches, &mut state),
            Some(elastic) => {
                elastic.contacts(&memory.strips, &mut state);
                for (index, contact) in [&mut state.inner, &mut state.outer].into_iter().enumerate() {
                    contact.laminae = self.laminae_under(index, contact.load, contact.moment);
                }
            }
        }
        let residual = CONVERGED * (force.abs() + self.negligible());
        let is_residual = |contact: &LineContact| contact.load > 0.0 && contact.load <= residual;
        if start.is_some() && (is_residual(&state.inner) || is_residual(&state.outer)) {
            // A roller that has lost its load nearly touches the raceways where it left them, and
            // not where it is between them by itself.
            return self.state(ring, force, None);
        }
        self.rib_load(&approaches, &roller, |_, _, load, _, _| state.rib = load);
        state
    }

    /// Finds the loads and pressures of the laminae.
    fn lamina_contacts(&self, approaches: &[f64], state: &mut RollerState) {
        let per_length = self.geometry.laminae as f64 / self.geometry.length;
        let halves = self.laminae.split_at(self.geometry.laminae);
        let starts = approaches.split_at(self.geometry.laminae);
        let roller = state.displacement;
        for (contact, laminae, approaches) in
            [(&mut state.inner, halves.0, starts.0), (&mut state.outer, halves.1, starts.1)]
        {
            for (lamina, approach) in laminae.iter().zip(approaches) {
                let (load, _) = self.lamina_load(approach + dot(&lamina.roller, &roller));
                let per_length = load * per_length;
                contact.add(
                    lamina.position,
                    load,
                    per_length,
                    pressure(per_length, lamina.radius, self.modulus),
                );
            }
            contact.laminae.clone_from(&contact.loads);
        }
    }

    /// Returns the loads per length of the laminae of ISO/TS 16281, N/m, that have this load and
    /// moment together: those of an approach and a tilt at which their potential energy less the
    /// work of load and moment is least.
    fn laminae_under(&self, contact: usize, load: f64, moment: f64) -> Vec<f64> {
        let count = self.geometry.laminae;
        let laminae = &self.laminae[contact * count..(contact + 1) * count];
        let arm = 0.5 * self.geometry.length;
        let per_length = count as f64 / self.geometry.length;
        let least = laminae.iter().map(|lamina| lamina.relief).fold(f64::INFINITY, f64::min);
        let approach =
            |at: &[f64; 2], lamina: &Lamina| at[0] + at[1] * lamina.position / arm - (lamina.relief - least);
        let energy = |at: &[f64; 2]| {
            let mut value = -load * at[0] - moment / arm * at[1];
            let mut gradient = [-load, -moment / arm];
            let mut hessian = [[0.0; 2]; 2];
            for lamina in laminae {
                let approach = approach(at, lamina);
                let (load, slope) = self.lamina_load(approach);
                let arms = [1.0, lamina.position / arm];
                value += load * approach / (1.0 + EXPONENT);
                for i in 0..2 {
                    gradient[i] += load * arms[i];
                    for j in 0..2 {
                        hessian[i][j] += slope * arms[i] * arms[j];
                    }
                }
            }
            (value, gradient, hessian)
        };
        let mut at = [libm::pow(load / (self.coefficient * count as f64), 1.0 / EXPONENT), 0.0];
        let mut current = energy(&at);
        for _ in 0..STEPS {
            let (value, gradient, hessian) = current;
            if dot(&gradient, &gradient).sqrt() <= TOLERANCE * load {
                break;
            }
            let mut step = gradient.map(|x| [-x]);
            if !solve(hessian, &mut step) {
                break;
            }
            let slope = gradient[0] * step[0][0] + gradient[1] * step[1][0];
            let mut fraction = 1.0;
            loop {
                let next = [0, 1].map(|k| at[k] + fraction * step[k][0]);
                let trial = energy(&next);
                let decreases = dot(&trial.1, &trial.1) < 0.5 * dot(&gradient, &gradient);
                if decreases || trial.0 <= value + 1e-4 * fraction * slope || fraction < 1e-10 {
                    (at, current) = (next, trial);
                    break;
                }
                fraction *= 0.5;
            }
        }
        laminae.iter().map(|lamina| per_length * self.lamina_load(approach(&at, lamina)).0).collect()
    }

    /// Returns the laminae or strips of the inner contact, then those of the outer contact.
    pub(super) fn sections(&self) -> &[Lamina] {
        self.elastic.as_ref().map_or(&self.laminae, |elastic| &elastic.sections)
    }

    /// Returns the approach of each contact at zero displacement of the roller.
    fn approaches(&self, ring: &Local) -> Vec<f64> {
        let laminae = self.sections().iter().map(|lamina| dot(&lamina.ring, ring) - lamina.relief);
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
        self.rib_load(approaches, roller, call);
    }

    /// Calls a function for the rib as [`RollerRow::for_each_contact`] does.
    fn rib_load(
        &self,
        approaches: &[f64],
        roller: &[f64; 3],
        mut call: impl FnMut(&[f64; 3], &[f64; 3], f64, f64, f64),
    ) {
        let Some(rib) = &self.rib else { return };
        let approach = approaches[approaches.len() - 1] + dot(&rib.roller, roller);
        if approach > 0.0 {
            let slope = 1.5 * rib.stiffness * approach.sqrt();
            let load = slope * approach / 1.5;
            call(&rib.ring, &rib.roller, load, slope, 0.4 * load * approach);
        }
    }

    /// Returns the potential energy of the rib and of the centrifugal force, with a lower triangle
    /// of the Hessian.
    fn other_contacts(&self, approaches: &[f64], roller: &[f64; 3], force: f64) -> Energy {
        let mut result = Energy::of_force(force, roller);
        self.rib_load(approaches, roller, |_, approach, load, slope, energy| {
            result.add(approach, load, slope, energy);
        });
        for i in 0..3 {
            for j in i + 1..3 {
                result.hessian[i][j] = result.hessian[j][i];
            }
        }
        result
    }

    /// Computes the potential energy of a roller.
    fn energy(&self, approaches: &[f64], roller: &[f64; 3], force: f64, memory: &mut Memory) -> Energy {
        let mut result = Energy::of_force(force, roller);
        match &self.elastic {
            None => self.for_each_contact(approaches, roller, |_, approach, load, slope, energy| {
                result.add(approach, load, slope, energy);
            }),
            Some(elastic) => {
                result = self.other_contacts(approaches, roller, force);
                elastic.add_energy(approaches, roller, memory, &mut result);
            }
        }
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
        for (lamina, approach) in self.sections().iter().zip(approaches) {
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

    /// Returns the magnitude of a force with a moment on a roller, N.
    fn size(&self, gradient: &[f64; 3]) -> f64 {
        let moment = gradient[2] / (0.5 * self.geometry.length);
        (gradient[0] * gradient[0] + gradient[1] * gradient[1] + moment * moment).sqrt()
    }

    /// Returns a force without importance, N: an unloaded roller leaves its last contact
    /// geometrically.
    fn negligible(&self) -> f64 {
        let approach = 1e-9 * self.geometry.roller_diameter;
        self.geometry.laminae as f64 * self.lamina_load(approach).0
    }

    /// Returns the displacement of the roller between laminae, and whether they carry load.
    fn between_laminae(&self, ring: &Local, force: f64) -> ([f64; 3], bool) {
        let plain = self.plain.as_deref().unwrap_or(self);
        let approaches = plain.approaches(ring);
        let roller = plain.settle(&approaches, force, None, &mut Memory::default()).0;
        let mut loaded = false;
        plain.for_each_contact(&approaches, &roller, |_, _, load, _, _| loaded |= load > 0.0);
        (roller, loaded)
    }

    /// Returns true if a roller in equilibrium between laminae is so far from the inner ring that
    /// it exerts no force on it: only its centrifugal force loads it, or nothing.
    fn is_clear_of_inner_ring(&self, ring: &Local, between: &[f64; 3]) -> bool {
        let plain = self.plain.as_deref().unwrap_or(self);
        let approaches = plain.approaches(ring);
        let contacts = plain.laminae.iter().map(|lamina| (&lamina.ring, &lamina.roller));
        let contacts = contacts.chain(plain.rib.iter().map(|rib| (&rib.ring, &rib.roller)));
        let [mut inner, mut outer] = [f64::NEG_INFINITY; 2];
        for ((on_ring, roller), start) in contacts.zip(&approaches) {
            let approach = start + dot(roller, between);
            let highest = if on_ring == &[0.0; 3] { &mut outer } else { &mut inner };
            *highest = highest.max(approach);
        }
        inner < -CLEAR * outer.max(0.0)
    }

    /// Newton's method for the displacement of a roller with elastic contact and the loads of its
    /// strips together. It has no line search; where it does not converge in a few steps, the
    /// result is `None`.
    fn newton(
        &self,
        approaches: &[f64],
        force: f64,
        start: Option<[f64; 3]>,
        memory: &mut Memory,
    ) -> Option<[f64; 3]> {
        let elastic = self.elastic.as_ref()?;
        let negligible = self.negligible();
        let mut roller = start?;
        let mut least = f64::INFINITY;
        for step in 0..JOINT_STEPS {
            let mut result = self.other_contacts(approaches, &roller, force);
            let violation = elastic.residual(approaches, &roller, memory, &mut result);
            if self.free_axially {
                result.gradient[1] = 0.0;
            }
            let residual = self.size(&result.gradient) / (result.scale + negligible);
            let Some(violation) = violation else {
                return (residual <= TOLERANCE).then_some(roller);
            };
            let error = violation.max(residual);
            if error <= TOLERANCE || (least <= 1e-11 && error >= 0.5 * least && error <= 1e-11) {
                return Some(roller);
            }
            if step > 3 && error > 4.0 * least {
                return None;
            }
            least = least.min(error);
            let change = elastic.step(memory, &mut result, |result| {
                self.constrain(&mut result.hessian);
                if self.free_axially {
                    result.gradient[1] = 0.0;
                }
                let mut step = result.gradient.map(|x| [-x]);
                solve(result.hessian, &mut step).then(|| step.map(|[x]| x))
            })?;
            let length =
                change[0].abs().max(change[1].abs()).max(0.5 * self.geometry.length * change[2].abs());
            if length > 0.01 * self.geometry.roller_diameter {
                return None;
            }
            roller = [0, 1, 2].map(|k| roller[k] + change[k]);
        }
        None
    }

    /// Minimizes the potential energy of a roller, which is convex, by Newton's method with a line
    /// search. Returns the displacement of the roller and whether its residual is small.
    fn settle(
        &self,
        approaches: &[f64],
        force: f64,
        start: Option<[f64; 3]>,
        memory: &mut Memory,
    ) -> ([f64; 3], bool) {
        let arm = 0.5 * self.geometry.length;
        let size = |gradient: &[f64; 3]| self.size(gradient);
        let negligible = self.negligible();
        if let Some(roller) = self.newton(approaches, force, start, memory) {
            return (roller, true);
        }
        memory.strips = StripLoads::default();
        // The energy is convex, so that every start leads to its minimum.
        let mut roller = start.unwrap_or_else(|| self.start(approaches));
        let mut current = self.energy(approaches, &roller, force, memory);
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
                let trial = self.energy(approaches, &next, force, memory);
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
        let converged = size(&current.gradient) <= CONVERGED * (current.scale + negligible);
        if start.is_some() && !converged {
            // A start far away may need more steps than there are.
            return self.settle(approaches, force, None, memory);
        }
        (roller, converged)
    }
}
