//! Contacts of rollers as elastic half-spaces, at fidelity levels with finite elements.

use super::body::BodyCompliance;
use super::contact_model::ElasticContact;
use super::geometry::{Lamina, RollerGeometry};
use super::shape::Section;
use super::state::{Energy, Memory, RollerState, Tangent};
use super::strips::{Face, Line, Strip, StripLoads, Strips, graded_strips};
use crate::error::RollingError;
use crate::linear::{dot, product, solve_upper};
use crate::material::Material;

/// Violation of the contact conditions at which former loads of the strips are of no use.
const FAR: f64 = 0.5;

/// Returns the mean deflection of a contact line by the images of an even load in the side faces of
/// a raceway, per force, m/N: a part of the deflection of the ring as a whole.
fn mean_of_sides(width: f64, length: f64, ring: &Material) -> f64 {
    // The reciprocal distance from an image, width - x - x', is the second derivative of this.
    let term = |t: f64| if t > 0.0 { t * libm::log(t / length) - t } else { 0.0 };
    let integral = term(width + length) - 2.0 * term(width) + term(width - length);
    2.0 * integral / (std::f64::consts::PI * ring.plane_strain_modulus() * length * length)
}

/// Strips of a roller and their geometry.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Elastic {
    pub settings: ElasticContact,
    /// Strips of the inner contact, then those of the outer contact.
    pub sections: Vec<Lamina>,
    strips: Strips,
}

impl Elastic {
    /// Derives the strips of a row of rollers; `modulus` is the composite modulus, Pa.
    pub fn new(
        geometry: &RollerGeometry,
        modulus: f64,
        settings: ElasticContact,
    ) -> Result<Self, RollingError> {
        if !(8..=200).contains(&settings.strips) {
            return Err(RollingError::input(
                format!("a contact line of {} strips", settings.strips),
                "give a number of strips from 8 to 200; 32 are usual",
            )
            .of("strips"));
        }
        let length = geometry.length;
        let places = graded_strips(length, settings.strips, |_| 0.0);
        let sections: Vec<Section> =
            places.iter().map(|strip| Section { position: strip.position, length: strip.length }).collect();
        let sections = geometry.shape(&sections)?.laminae;
        let share = |body: &Material| modulus / body.plane_strain_modulus();
        let ends = if settings.free_ends { share(&geometry.rollers) } else { 0.0 };
        let line = |laminae: &[Lamina], width: Option<f64>| {
            let radii = laminae.iter().zip(&places);
            let strips = radii.map(|(lamina, strip)| Strip { radius: lamina.radius, ..*strip }).collect();
            let mut line = Line::with_free_ends(strips, ends);
            for side in width.into_iter().flat_map(|width| [-0.5 * width, 0.5 * width]) {
                line.faces.push(Face { position: side, share: share(&geometry.rings) });
            }
            line
        };
        let (inner, outer) = sections.split_at(settings.strips);
        let body = (settings.body && settings.free_ends).then(|| {
            BodyCompliance::new(length, geometry.roller_diameter, geometry.rollers.plane_strain_modulus())
        });
        let widths = geometry.raceway_widths;
        let whole =
            widths.map(|width| width.map_or(0.0, |width| mean_of_sides(width, length, &geometry.rings)));
        let deflection = |i: usize, j: usize| {
            let lines = [i, j].map(|strip| usize::from(strip >= settings.strips));
            let opposite = lines[0] != lines[1];
            let of_body = body
                .as_ref()
                .map_or(0.0, |body| body.deflection(opposite, sections[i].position, sections[j].position));
            if opposite { of_body } else { of_body - whole[lines[0]] }
        };
        let lines = [line(inner, widths[0]), line(outer, widths[1])];
        let strips = Strips::new(&lines, modulus, deflection);
        Ok(Self { settings, sections, strips })
    }

    /// Adds the potential energy of the strips with its derivatives with respect to the
    /// displacement of the roller.
    pub fn add_energy(
        &self,
        approaches: &[f64],
        roller: &[f64; 3],
        memory: &mut Memory,
        result: &mut Energy,
    ) {
        if !self.approach(approaches, roller, memory) {
            memory.strips = StripLoads::default();
            return;
        }
        self.strips.solve(&memory.approaches, &mut memory.strips, &mut memory.work);
        result.energy += self.strips.potential(&memory.work);
        for (section, load) in self.loads(&memory.strips) {
            result.scale += load;
            for i in 0..3 {
                result.gradient[i] += load * section.roller[i];
            }
        }
        let stiffness =
            self.strips.stiffness(&memory.strips, &mut memory.work, |strip| self.sections[strip].roller);
        for i in 0..3 {
            for j in 0..=i {
                result.hessian[i][j] += stiffness[i][j];
            }
        }
    }

    /// Computes the approaches at a displacement of the roller. Returns whether any is positive.
    fn approach(&self, approaches: &[f64], roller: &[f64; 3], memory: &mut Memory) -> bool {
        memory.approaches.clear();
        let total = self.sections.iter().zip(approaches);
        memory.approaches.extend(total.map(|(section, start)| start + dot(&section.roller, roller)));
        memory.approaches.iter().any(|approach| *approach > 0.0)
    }

    /// Evaluates the strips at their loads and at a displacement of the roller. Returns the largest
    /// violation of the contact conditions; `None` without contact. Adds the forces on the roller.
    pub fn residual(
        &self,
        approaches: &[f64],
        roller: &[f64; 3],
        memory: &mut Memory,
        result: &mut Energy,
    ) -> Option<f64> {
        if !self.approach(approaches, roller, memory) {
            memory.strips = StripLoads::default();
            return None;
        }
        let Memory { strips, work, approaches } = memory;
        if strips.loads.len() != self.sections.len() || strips.loads.iter().all(|load| *load == 0.0) {
            *strips = self.strips.first_loads(approaches);
        }
        self.strips.evaluate(approaches, strips, work);
        let mut violation = self.strips.violation(approaches, strips, work);
        if violation > FAR {
            *strips = self.strips.first_loads(approaches);
            self.strips.evaluate(approaches, strips, work);
            violation = self.strips.violation(approaches, strips, work);
        }
        for (section, load) in self.loads(strips) {
            result.scale += load;
            for i in 0..3 {
                result.gradient[i] += load * section.roller[i];
            }
        }
        Some(violation)
    }

    /// Computes Newton's step of the roller and of its strips together, and applies that of the
    /// strips. `result` has the forces and the stiffness of all other contacts, and `finish`
    /// completes the stiffness and solves for the step of the roller.
    pub fn step(
        &self,
        memory: &mut Memory,
        result: &mut Energy,
        finish: impl FnOnce(&mut Energy) -> Option<[f64; 3]>,
    ) -> Option<[f64; 3]> {
        let Memory { strips, work, .. } = memory;
        self.strips.factor(strips, work);
        let mut step = self.strips.step_of_loads(work);
        let columns = self.strips.columns(work, |strip| self.sections[strip].roller);
        let size = work.free.len();
        let modulus = self.strips.modulus();
        for (k, &i) in work.free.iter().enumerate() {
            let length = self.strips.strips()[i].length;
            for a in 0..3 {
                result.gradient[a] += length * step[k] * self.sections[i].roller[a];
            }
        }
        for a in 0..3 {
            for b in 0..3 {
                let rows = [a, b].map(|k| &columns[k * size..(k + 1) * size]);
                result.hessian[a][b] += modulus * product(rows[0], rows[1]);
            }
        }
        let roller = finish(result)?;
        let mut change = vec![0.0; size];
        for (a, column) in columns.chunks_exact(size.max(1)).enumerate() {
            for (sum, entry) in change.iter_mut().zip(column) {
                *sum += modulus * roller[a] * entry;
            }
        }
        solve_upper(&work.factor, &mut change);
        for (step, change) in step.iter_mut().zip(&change) {
            *step += change;
        }
        let step = self.strips.complete(strips, work, &step);
        let mut next = StripLoads::default();
        self.strips.advance(strips, &step, 1.0, work, &mut next);
        *strips = next;
        Some(roller)
    }

    /// Adds the forces of the strips and their derivatives at the solution that `memory` has.
    pub fn add_tangent(&self, memory: &mut Memory, tangent: &mut Tangent) {
        if memory.strips.loads.is_empty() {
            return;
        }
        for (section, load) in self.loads(&memory.strips) {
            for i in 0..3 {
                tangent.force[i] += load * section.ring[i];
            }
        }
        let columns = |strip: usize| {
            let Lamina { ring: [a, b, c], roller: [d, e, f], .. } = self.sections[strip];
            [a, b, c, d, e, f]
        };
        let stiffness = self.strips.stiffness(&memory.strips, &mut memory.work, columns);
        for i in 0..3 {
            for j in 0..3 {
                tangent.ring[i][j] += stiffness[i][j];
                tangent.roller[i][j] += stiffness[i + 3][j + 3];
                tangent.coupling[i][j] += stiffness[i + 3][j];
            }
        }
    }

    /// Adds the loads and pressures of the strips to both contacts.
    pub fn contacts(&self, found: &StripLoads, state: &mut RollerState) {
        let count = self.settings.strips;
        for (index, (section, load)) in self.loads(found).enumerate() {
            let contact = if index < count { &mut state.inner } else { &mut state.outer };
            let pressure = if load > 0.0 { found.pressure(index) } else { 0.0 };
            contact.add(section.position, load, load / self.strips.strips()[index].length, pressure);
        }
    }

    /// Returns the sections and their loads, N.
    fn loads<'a>(&'a self, found: &'a StripLoads) -> impl Iterator<Item = (&'a Lamina, f64)> {
        let load = |index| found.loads.get(index).copied().unwrap_or(0.0);
        let strips = self.strips.strips().iter().enumerate();
        self.sections.iter().zip(strips.map(move |(index, strip)| strip.length * load(index)))
    }
}
