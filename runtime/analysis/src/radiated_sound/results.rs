//! Radiated sound by speed and line, its sums and levels, and what was changed on the surface.

use super::directions::Direction;
use super::frequencies::Field;
use super::motion::{SurfaceMotion, Vibrating};
use super::solver::{SkinField, Solver};
use super::vibration::SurfaceVibration;
use super::{Lines, SoundRequest};
use calyx_acoustics::field::FieldMesh;
use calyx_acoustics::levels::{REFERENCE_PRESSURE, a_weighting, sound_power_level};
use calyx_acoustics::{Fluid, SoundMethod};
use calyx_numerics::error::EngineError;
use calyx_numerics::vec3::Vector;
use faer::c64;
use std::f64::consts::TAU;

/// Elements per wavelength below which a warning states that the mesh is too coarse.
const COARSE: f64 = 5.0;
/// Relative difference of the powers on the surface and in the far field above which a warning
/// states it: 0.4 dB.
const NOTABLE: f64 = 0.1;
/// Error of interpolation above which a warning states it.
const INTERPOLATION: f64 = 0.02;
/// Part of the dissipated power that may be radiated: the motion includes no damping by the fluid.
const ONE_WAY: f64 = 0.5;

/// Mass of the fluid that moves with the surface, over that of the body, above which a warning
/// states that the vibration is that without fluid.
const HEAVY: f64 = 0.1;

/// Largest number of lines whose sound on the surface is stored, and the part of the power of the
/// loudest one above which it is.
pub(crate) const SKIN_LINES: usize = 3;
const LOUD: f64 = 0.1;

/// Weighting of frequencies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weighting {
    /// None.
    None,
    /// A-weighting (IEC 61672-1).
    A,
}

impl Weighting {
    /// Returns the factor of a power at a frequency, Hz.
    pub fn factor(self, frequency: f64) -> f64 {
        match self {
            Weighting::None => 1.0,
            Weighting::A => 10f64.powf(0.1 * a_weighting(frequency)),
        }
    }
}

/// Surface that radiates, and how it differs from that of the mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceSummary {
    /// Number of triangles.
    pub triangles: usize,
    /// Number of triangles before coarsening.
    pub fine_triangles: usize,
    /// Area, m².
    pub area: f64,
    /// Length of the longest edge, m.
    pub longest_edge: f64,
    /// Names of the openings that are closed, with the numbers of their lids.
    pub closed: Vec<(String, usize)>,
    /// Number of elements that are left out: ribs that end in a free edge, parts inside of others,
    /// and shells on solids.
    pub left_out: usize,
}

/// Panel of a surface, or the rest of it.
#[derive(Clone, Debug, PartialEq)]
pub struct PanelSummary {
    /// Name.
    pub name: String,
    /// Area, m².
    pub area: f64,
}

/// Sound pressure on a field mesh at the speed of the model.
#[derive(Clone, Debug, PartialEq)]
pub struct SoundField {
    /// Name.
    pub name: String,
    /// Kind of mesh.
    pub kind: &'static str,
    /// True if the mesh encloses the body.
    pub encloses: bool,
    /// Points in ground coordinates.
    pub mesh: FieldMesh,
    /// Numbers of points along the edges of a plane.
    pub grid: Option<[usize; 2]>,
    /// Pressures by line and point, Pa.
    pub pressures: Vec<Vec<c64>>,
    /// How the mesh differs from what ISO 3744 requires, as a clause.
    pub deviation: Option<String>,
}

/// Sound on the surface at the speed of the model, for its loudest lines.
#[derive(Clone, Debug, PartialEq)]
pub struct Skin {
    /// Vertices in ground coordinates, m.
    pub vertices: Vec<Vector>,
    /// Triangles, counter-clockwise seen from the fluid.
    pub triangles: Vec<[usize; 3]>,
    /// Lines, the loudest one first.
    pub fields: Vec<SkinField>,
}

/// Sound that a body radiates.
#[derive(Clone, Debug, PartialEq)]
pub struct RadiatedSound {
    /// Name of the body.
    pub body: String,
    /// Fluid around it.
    pub fluid: Fluid,
    /// Level of the field.
    pub method: SoundMethod,
    /// Point (m) and normal of the rigid plane, in ground coordinates.
    pub plane: Option<[Vector; 2]>,
    /// Mass of the body, kg; `None` if it is unknown.
    pub mass: Option<f64>,
    /// Surface.
    pub surface: SurfaceSummary,
    /// Highest frequency with sound, Hz: that of the component modes. Lines above it have none.
    pub highest_frequency: f64,
    /// Frequency of each line over the rotational frequency of the gear whose speed is the
    /// abscissa.
    pub orders: Vec<f64>,
    /// Frequencies at which the field is solved, Hz; empty for the equivalent radiated power.
    pub solved_frequencies: Vec<f64>,
    /// Largest relative error of the power by interpolation between these frequencies.
    pub interpolation_error: f64,
    /// Largest relative difference of the powers on the surface and in the far field: an estimate
    /// of the error by the size of the elements. NaN without boundary elements.
    pub far_field_difference: f64,
    /// Points at which the pressure is known, in ground coordinates, m.
    pub points: Vec<Vector>,
    /// Panels and the rest of the surface; empty without panels.
    pub panels: Vec<PanelSummary>,
    /// Field meshes with the pressures at the speed of the model.
    pub fields: Vec<SoundField>,
    /// Directions of the far field.
    pub directions: Vec<Direction>,
    /// Amplitudes of the far field at the speed of the model by line and direction, relative to the
    /// middle of the body, Pa·m; empty without boundary elements.
    pub far_field: Vec<Vec<c64>>,
    /// Sound on the surface at the speed of the model; `None` in perturbed solves.
    pub skin: Option<Skin>,
    /// Velocities of the skin of the mesh at the speed of the model; `None` in perturbed solves.
    pub vibration: Option<SurfaceVibration>,
    /// Sound at the speed of the model.
    pub own: SoundPoint,
    /// Sound by speed of the forced response.
    pub speeds: Vec<SoundPoint>,
}

/// Sound at a speed, by line. NaN where the response is unknown.
#[derive(Clone, Debug, PartialEq)]
pub struct SoundPoint {
    /// Speed, rad/s.
    pub speed: f64,
    /// Sound powers, W; zero above the highest frequency and for the mean value.
    pub powers: Vec<f64>,
    /// Estimated errors of the powers by the number of positions of the forced response, W.
    pub errors: Vec<f64>,
    /// Equivalent radiated powers, W.
    pub equivalent_powers: Vec<f64>,
    /// Power that enters the body at its bearings, W; NaN if it is unknown.
    pub input: Vec<f64>,
    /// Power that the damping ratio dissipates in the body, W.
    pub dissipated: Vec<f64>,
    /// Pressures by line and point, Pa.
    pub pressures: Vec<Vec<c64>>,
    /// Contributions to the powers by line and panel, W; they sum to the powers.
    pub panels: Vec<Vec<f64>>,
}

impl RadiatedSound {
    pub(super) fn new(
        (model, request): (&Vibrating, &SoundRequest),
        field: &Field,
        lines: &Lines<'_>,
        (speeds, motions): (&[f64], &[&SurfaceMotion]),
    ) -> RadiatedSound {
        let mesh = &model.surface.skin.mesh;
        let panel = |panel: &super::surface::SurfacePanel| PanelSummary {
            name: panel.name.clone(),
            area: panel.shares.iter().zip(mesh.areas()).map(|(share, area)| share * area).sum(),
        };
        let panels = model.surface.panels.iter().map(panel).collect();
        let own = speeds.last().zip(motions.last());
        let (fields, far_field) = match own {
            Some((&speed, motion)) => around((model, request), field, lines, (speed, motion)),
            None => (Vec::new(), Vec::new()),
        };
        let all = speeds
            .iter()
            .zip(motions)
            .map(|(&speed, motion)| point((field, request.points.len()), lines, speed, motion));
        let mut speeds: Vec<SoundPoint> = all.collect();
        let none = SoundPoint {
            speed: 0.0,
            powers: Vec::new(),
            errors: Vec::new(),
            equivalent_powers: Vec::new(),
            input: Vec::new(),
            dissipated: Vec::new(),
            pressures: Vec::new(),
            panels: Vec::new(),
        };
        let own = speeds.pop().unwrap_or(none);
        RadiatedSound {
            body: model.name.clone(),
            fluid: model.fluid,
            method: field.method,
            plane: request.plane,
            mass: model.mass,
            surface: SurfaceSummary {
                triangles: mesh.triangles().len(),
                fine_triangles: model.surface.original.mesh.triangles().len(),
                area: mesh.area(),
                longest_edge: mesh.longest_edge(),
                closed: model.surface.closed.clone(),
                left_out: model.surface.left_out,
            },
            highest_frequency: lines.highest,
            orders: lines.orders.to_vec(),
            solved_frequencies: field.frequencies(),
            interpolation_error: field.interpolation_error,
            far_field_difference: field.far_field_difference,
            points: request.points.clone(),
            panels,
            fields,
            directions: model.surface.directions(request),
            far_field,
            skin: None,
            vibration: None,
            own,
            speeds,
        }
    }

    /// Computes the sound on the surface at the loudest lines of the speed of the model, whose
    /// motion is given.
    ///
    /// # Errors
    /// Those of the acoustic solution and of the interrupt.
    pub(super) fn add_skin(
        &mut self,
        model: &Vibrating,
        solver: &Solver<'_>,
        motion: &SurfaceMotion,
    ) -> Result<(), EngineError> {
        let powers = &self.own.powers;
        let mut lines: Vec<usize> = (0..powers.len()).filter(|&line| powers[line] > 0.0).collect();
        lines.sort_by(|one, other| powers[*other].total_cmp(&powers[*one]).then(one.cmp(other)));
        let largest = lines.first().map_or(0.0, |&line| powers[line]);
        lines.retain(|&line| powers[line] >= LOUD * largest);
        lines.truncate(SKIN_LINES);
        let field = |&line: &usize| {
            solver.skin(line, self.frequency(line, self.own.speed), &motion.velocities[0][line])
        };
        self.skin = Some(Skin {
            fields: lines.iter().map(field).collect::<Result<_, _>>()?,
            vertices: model.surface.vertices(),
            triangles: model.surface.skin.mesh.triangles().to_vec(),
        });
        Ok(())
    }

    /// Returns the frequency of a line at a speed (rad/s), Hz.
    pub fn frequency(&self, line: usize, speed: f64) -> f64 {
        self.orders[line] * speed / TAU
    }

    /// Returns the lines with sound at the speed of the model.
    pub(super) fn lines_with_sound(&self) -> Vec<usize> {
        let frequency = |line: usize| self.frequency(line, self.own.speed);
        let has_sound = |line: &usize| frequency(*line) > 0.0 && frequency(*line) <= self.highest_frequency;
        (0..self.own.powers.len()).filter(has_sound).collect()
    }

    /// Returns the highest frequency of a line with sound, Hz.
    fn highest_line(&self) -> f64 {
        let all = self.speeds.iter().chain([&self.own]);
        let of_speed = all.flat_map(|point| self.orders.iter().map(|order| order * point.speed / TAU));
        of_speed.filter(|frequency| *frequency <= self.highest_frequency).fold(0.0, f64::max)
    }

    /// Returns the number of elements per wavelength at the highest frequency of a line.
    pub fn elements_per_wavelength(&self) -> f64 {
        self.fluid.speed_of_sound / (self.highest_line() * self.surface.longest_edge)
    }

    /// Returns the sound power of all lines at a speed, weighted, W.
    pub fn power(&self, at: &SoundPoint, weighting: Weighting) -> f64 {
        self.weighted(&at.powers, at.speed, weighting)
    }

    /// Returns the sound power of the lines that a function selects, weighted, W.
    pub fn power_of(
        &self,
        at: &SoundPoint,
        weighting: Weighting,
        is_selected: impl Fn(usize) -> bool,
    ) -> f64 {
        let selected: Vec<f64> =
            at.powers.iter().enumerate().map(|(k, p)| if is_selected(k) { *p } else { 0.0 }).collect();
        self.weighted(&selected, at.speed, weighting)
    }

    /// Returns the contribution of a panel to [`RadiatedSound::power_of`], W.
    pub fn panel_power_of(
        &self,
        at: &SoundPoint,
        panel: usize,
        weighting: Weighting,
        is_selected: impl Fn(usize) -> bool,
    ) -> f64 {
        let own = |(line, panels): (usize, &Vec<f64>)| match is_selected(line) {
            true => panels.get(panel).copied().unwrap_or(f64::NAN),
            false => 0.0,
        };
        let selected: Vec<f64> = at.panels.iter().enumerate().map(own).collect();
        self.weighted(&selected, at.speed, weighting)
    }

    /// Returns the mean sound pressure level of all lines on a field mesh at the speed of the
    /// model, weighted, dB re 20 µPa: the level of the mean square over the area.
    pub fn field_level(&self, field: usize, weighting: Weighting) -> f64 {
        let Some(field) = self.fields.get(field) else { return f64::NAN };
        let square = |(line, pressures): (usize, &Vec<c64>)| {
            let mean = field.mesh.mean(pressures.iter().map(|pressure| 0.5 * pressure.norm_sqr()));
            match mean {
                0.0 => 0.0,
                mean => mean * weighting.factor(self.frequency(line, self.own.speed)),
            }
        };
        let sum: f64 = field.pressures.iter().enumerate().map(square).sum();
        10.0 * (sum / (REFERENCE_PRESSURE * REFERENCE_PRESSURE)).log10()
    }

    /// Returns the sound power level of the enveloping surface method (ISO 3744) from the mean
    /// sound pressure level on a field mesh: L_W = L_p + 10 lg(S / 1 m²), dB re 1 pW. NaN if the
    /// mesh does not enclose the body.
    pub fn measured_power_level(&self, field: usize, weighting: Weighting) -> f64 {
        match self.fields.get(field).filter(|field| field.encloses) {
            Some(own) => self.field_level(field, weighting) + 10.0 * own.mesh.area().log10(),
            None => f64::NAN,
        }
    }

    fn weighted(&self, powers: &[f64], speed: f64, weighting: Weighting) -> f64 {
        let of_line = |(line, power): (usize, &f64)| match *power {
            0.0 => 0.0,
            power => power * weighting.factor(self.frequency(line, speed)),
        };
        powers.iter().enumerate().map(of_line).sum()
    }

    /// Returns the sound power level of all lines at a speed, weighted, dB re 1 pW.
    pub fn level(&self, at: &SoundPoint, weighting: Weighting) -> f64 {
        sound_power_level(self.power(at, weighting))
    }

    /// Returns the estimated error of [`RadiatedSound::level`] by the number of positions of the
    /// forced response, dB: the increase of the level by the errors of all lines.
    pub fn level_error(&self, at: &SoundPoint, weighting: Weighting) -> f64 {
        let error = self.weighted(&at.errors, at.speed, weighting);
        10.0 * (error / self.power(at, weighting)).ln_1p() / std::f64::consts::LN_10
    }

    /// Returns the estimated mass of the fluid that moves with the surface at the lowest line with
    /// sound at the speed of the model, over that of the body: the reactance ρa/(1 + (ka)²) of a
    /// pulsating sphere with the radius a that has the area of the surface. `None` if the mass of
    /// the body is unknown, or no line has sound.
    pub fn fluid_mass_ratio(&self) -> Option<f64> {
        let lines = (0..self.orders.len()).map(|line| self.frequency(line, self.own.speed));
        let lowest = lines.filter(|line| *line > 0.0 && *line <= self.highest_frequency);
        let lowest = lowest.reduce(f64::min)?;
        let radius = (self.surface.area / (2.0 * TAU)).sqrt();
        let across = TAU * lowest * radius / self.fluid.speed_of_sound;
        let per_area = self.fluid.density * radius / (1.0 + across * across);
        Some(per_area * self.surface.area / self.mass.filter(|mass| *mass > 0.0)?)
    }

    /// Returns the radiation efficiency: the sound power over the equivalent radiated power. NaN if
    /// the surface is at rest.
    pub fn efficiency(&self, at: &SoundPoint) -> f64 {
        at.powers.iter().sum::<f64>() / at.equivalent_powers.iter().sum::<f64>()
    }

    /// Returns the sound pressure level of all lines at a point, weighted, dB re 20 µPa.
    pub fn pressure_level(&self, at: &SoundPoint, point: usize, weighting: Weighting) -> f64 {
        let square = |line: usize| {
            let pressure = at.pressures[line].get(point).map_or(f64::NAN, |pressure| pressure.norm_sqr());
            match pressure {
                0.0 => 0.0,
                square => 0.5 * square * weighting.factor(self.frequency(line, at.speed)),
            }
        };
        let sum: f64 = (0..at.pressures.len()).map(square).sum();
        10.0 * (sum / (REFERENCE_PRESSURE * REFERENCE_PRESSURE)).log10()
    }

    /// Returns warnings about the sound, in sentences.
    pub fn warnings(&self) -> Vec<String> {
        let mut all = Vec::new();
        let name = &self.body;
        let highest = self.orders.iter().copied().fold(0.0, f64::max)
            * self.speeds.iter().map(|point| point.speed).fold(self.own.speed, f64::max)
            / TAU;
        if highest > self.highest_frequency {
            all.push(format!(
                "the sound of \"{name}\" contains the lines up to {:.0} Hz, the `highest_frequency` of its component modes, and the forced response has lines up to {highest:.0} Hz",
                self.highest_frequency
            ));
        }
        let elements = self.elements_per_wavelength();
        if elements < COARSE && self.method != SoundMethod::EquivalentPower {
            all.push(format!(
                "the surface of \"{name}\" has {elements:.1} elements in a wavelength at {:.0} Hz, and six are needed for errors of some percent: refine its mesh, or lower `highest_frequency`",
                self.highest_line()
            ));
        }
        if self.far_field_difference > NOTABLE {
            all.push(format!(
                "the sound power of \"{name}\" on its surface and in the far field differ by up to {:.0} %, because its elements are coarse: refine its mesh",
                1e2 * self.far_field_difference
            ));
        }
        if self.interpolation_error > INTERPOLATION {
            all.push(format!(
                "the sound power of \"{name}\" is interpolated over the frequency with errors of up to {:.0} %: its sound varies fast, such as with a rigid plane far away",
                1e2 * self.interpolation_error
            ));
        }
        if let Some(ratio) = self.fluid_mass_ratio().filter(|ratio| *ratio > HEAVY) {
            all.push(format!(
                "the fluid that moves with \"{name}\" has about {:.0} % of its mass, and its vibration is computed without fluid: natural frequencies and levels are those of light fluids, such as air, and are wrong here",
                1e2 * ratio
            ));
        }
        for field in &self.fields {
            all.extend(field.deviation.as_ref().map(|deviation| {
                format!("the field mesh \"{}\" is not that of the standard: {deviation}", field.name)
            }));
        }
        for (index, panel) in self.panels.iter().enumerate() {
            let power = self.panel_power_of(&self.own, index, Weighting::None, |_| true);
            if power < 0.0 {
                all.push(format!(
                    "the panel \"{}\" of \"{name}\" absorbs sound of others at the speed of the model ({power:.2e} W), so its contribution has no level",
                    panel.name
                ));
            }
        }
        let [mut radiated, mut dissipated] = [0.0_f64; 2];
        for point in self.speeds.iter().chain([&self.own]) {
            let (power, loss) = (point.powers.iter().sum::<f64>(), point.dissipated.iter().sum::<f64>());
            if power > ONE_WAY * loss && power * dissipated >= radiated * loss {
                (radiated, dissipated) = (power, loss);
            }
        }
        if radiated > 0.0 {
            all.push(format!(
                "\"{name}\" radiates up to {:.0} % of the power that its damping dissipates, so the sound itself would damp it: the computed power is too high at resonances; include the damping by the fluid in `damping_ratio`",
                1e2 * radiated / dissipated
            ));
        }
        all
    }
}

/// Returns the pressures on the field meshes, and the amplitudes of the far field by line and
/// direction, at a speed.
fn around(
    (model, request): (&Vibrating, &SoundRequest),
    field: &Field,
    lines: &Lines<'_>,
    (speed, motion): (f64, &SurfaceMotion),
) -> (Vec<SoundField>, Vec<Vec<c64>>) {
    let frequencies: Vec<f64> = lines.orders.iter().map(|order| order * speed / TAU).collect();
    let has_sound = |line: usize| frequencies[line] > 0.0 && frequencies[line] <= lines.highest;
    let pressures = |line: usize| match has_sound(line) {
        true => field.pressures(frequencies[line], &motion.velocities[0][line]),
        false => vec![c64::new(0.0, 0.0); field.point_count()],
    };
    let pressures: Vec<Vec<c64>> = match request.fields.is_empty() {
        true => Vec::new(),
        false => (0..frequencies.len()).map(pressures).collect(),
    };
    let mut first = request.points.len();
    let extent = model.surface.extent(request);
    let own = |(wanted, mesh): (&super::FieldRequest, &FieldMesh)| {
        let points = first..first + mesh.points.len();
        first = points.end;
        SoundField {
            name: wanted.name.clone(),
            kind: wanted.shape.kind(),
            encloses: wanted.shape.encloses(),
            mesh: mesh.clone(),
            grid: wanted.shape.grid(),
            pressures: pressures.iter().map(|all| all[points.clone()].to_vec()).collect(),
            deviation: wanted.deviation(&extent),
        }
    };
    let fields = request.fields.iter().zip(&model.fields).map(own).collect();
    let far_field = |line: usize| match has_sound(line) {
        true => field.far_field(frequencies[line], &motion.velocities[0][line]),
        false => Vec::new(),
    };
    (fields, (0..frequencies.len()).map(far_field).collect())
}

fn point(
    (field, points): (&Field, usize),
    lines: &Lines<'_>,
    speed: f64,
    motion: &SurfaceMotion,
) -> SoundPoint {
    let frequencies: Vec<f64> = lines.orders.iter().map(|order| order * speed / TAU).collect();
    let has_sound = |line: usize| frequencies[line] > 0.0 && frequencies[line] <= lines.highest;
    let power = |of: usize, line: usize| match has_sound(line) {
        true => field.power(frequencies[line], &motion.velocities[of][line]),
        false => 0.0,
    };
    let all = || 0..frequencies.len();
    let powers: Vec<f64> = all().map(|line| power(0, line)).collect();
    let equivalent = |line: usize| match has_sound(line) {
        true => field.equivalent_power(&motion.velocities[0][line]),
        false => 0.0,
    };
    let pressures = |line: usize| match has_sound(line) {
        true => field.pressures_at(0..points, frequencies[line], &motion.velocities[0][line]),
        false => vec![c64::new(0.0, 0.0); points],
    };
    let panels = |line: usize| match has_sound(line) {
        true => field.panel_powers(frequencies[line], &motion.velocities[0][line]),
        false => vec![0.0; field.panel_count()],
    };
    SoundPoint {
        speed,
        errors: all().map(|line| lines.caution * (powers[line] - power(1, line)).abs()).collect(),
        powers,
        equivalent_powers: all().map(equivalent).collect(),
        input: motion.input.clone(),
        dissipated: motion.dissipated.clone(),
        pressures: all().map(pressures).collect(),
        panels: all().map(panels).collect(),
    }
}
