//! The plan of an analysis, for display: which parts are modelled or omitted, the reasons, and the
//! cost.

pub use crate::planned_bearing::PlannedBearing;
use crate::planned_elastic_body::PlannedElasticBody;
use crate::planned_sound;
use crate::shown::{grouped, in_unit, of_thousands, rounded};
use calyx_abi::description::ModelDescription;
use calyx_gears::host::{LengthUnit, ModelHost};
use calyx_gears::sensitivity_externs::params_of_derivatives;
use calyx_lang::dimension::Dimension;
use calyx_lang::units::UnitSystem;
use calyx_report::view::content;
use calyx_report::view::mesh::Meshes;
use calyx_runtime::bearing::Support;
use calyx_runtime::connection::{Attachment, ElasticConnection};
use calyx_runtime::cost::Task;
use calyx_runtime::elastic_body::ElasticBodySize;
use calyx_runtime::error::EngineError;
use calyx_runtime::estimate::Estimates;
use calyx_runtime::load::Wrench;
use calyx_runtime::observables::{self, Fields};
use calyx_runtime::plan::{ConnectionPlan, Plan};
use calyx_runtime::resources::Resources;
use calyx_runtime::results::OutputRequest;
use calyx_runtime::scene::{Body, BodyId, DOF_NAMES, Fidelity, Prototype, Scene, StructureOptions};
use calyx_runtime::settings_override::Grid;
use calyx_runtime::structure::StructureSize;
use std::fmt::{self, Write};
use std::sync::Arc;

/// Load of a free component without load, as text.
const NO_LOAD: &str = "no load";

/// The plan of a scene, with the names of its model. Planning solves nothing.
#[derive(Clone, Debug, PartialEq)]
pub struct Planned {
    /// The name of the fidelity level, as in `analyze`.
    pub fidelity: &'static str,
    /// `true` for an analysis in the time domain.
    pub in_time: bool,
    pub bodies: Vec<PlannedBody>,
    pub meshes: Vec<PlannedMesh>,
    pub bearings: Vec<PlannedBearing>,
    pub shafts: Vec<PlannedShaft>,
    pub elastic_bodies: Vec<PlannedElasticBody>,
    /// Links from the teeth to radiated sound, as lines.
    pub sounds: Vec<String>,
    /// Names of the outputs, which determine what is modelled.
    pub outputs: Vec<String>,
    /// The number of contact problems that each chain of the analysis solves in sequence. Without
    /// contact, the lengths of its lists of positions.
    pub positions: Vec<usize>,
    /// `true` for a three-dimensional model, `false` for a two-dimensional one.
    pub three_dimensional: bool,
    /// Number of distinct elastic structures. Bodies with the same gear share one.
    pub structures: usize,
    /// Outputs that this fidelity level does not support, each with its requirement.
    pub refused: Vec<(String, &'static str)>,
    /// Inputs that this fidelity level ignores, each with the reason.
    pub ignored_inputs: Vec<(String, String)>,
    /// The work on which the predicted cost is based.
    pub work: PlannedWork,
}

/// An analysis whose cost can be predicted. Meshes are generated when the cost is computed.
#[derive(Clone)]
pub struct PlannedWork {
    scene: Arc<Scene>,
    outputs: Vec<OutputRequest>,
    structure: StructureOptions,
    fidelity: Fidelity,
    positions: usize,
    in_time: bool,
    estimates: Estimates,
    highest_frequency: f64,
    tolerance: Option<f64>,
    differentiated: usize,
}

impl PlannedWork {
    fn of(host: &ModelHost, plan: &Plan) -> PlannedWork {
        let scene = Arc::new(host.scene.clone());
        let longest = host.positions.iter().map(Vec::len).max().unwrap_or(0);
        let structure = host.overrides.structure(host.analysis.structure);
        PlannedWork {
            scene,
            outputs: host.outputs.clone(),
            structure: host.asked.map_or(structure, |asked| asked.structure),
            fidelity: plan.fidelity,
            positions: host.asked.map_or(longest, |asked| asked.problems),
            in_time: host.asked.is_some_and(|asked| asked.in_time),
            estimates: host.asked.map_or(Estimates::None, |asked| asked.estimates),
            highest_frequency: host.asked.map_or(0.0, |asked| asked.highest_frequency),
            tolerance: host.asked.and_then(|asked| asked.tolerance),
            differentiated: params_of_derivatives(host),
        }
    }

    /// Returns the tolerance, relative to the largest magnitude of every output, if the model
    /// requests one.
    pub fn tolerance(&self) -> Option<f64> {
        self.tolerance
    }

    /// Returns the kinds of errors that are estimated.
    pub fn estimates(&self) -> Estimates {
        self.estimates
    }

    /// Returns the files of the viewer for the scene at time 0, without solving: parts and
    /// position. The name of the model and its system of units are written into them.
    ///
    /// # Errors
    /// The scene cannot be planned, or the computation is interrupted.
    pub fn view_files(
        &self,
        model: (&str, &str),
        resources: &Resources,
    ) -> Result<[Vec<u8>; 2], EngineError> {
        let planned = if self.in_time { Plan::in_time } else { Plan::new };
        let plan = planned(&*self.scene, self.fidelity, self.structure)?;
        let parts = Arc::new(observables::parts(&self.scene, &plan, resources)?);
        let poses = observables::prescribed_poses(&self.scene, &parts, 0.0);
        let fields = Fields { parts, poses, ..Fields::default() };
        Ok([
            content::parts(&fields.parts, model),
            content::position((0, 0.0), &fields, &mut Meshes::default()),
        ])
    }

    pub(crate) fn task(&self) -> Task<'_> {
        Task {
            scene: &self.scene,
            outputs: &self.outputs,
            fidelity: self.fidelity,
            structure: self.structure,
            positions: self.positions,
            in_time: self.in_time,
            estimates: self.estimates,
            highest_frequency: self.highest_frequency,
            differentiated: self.differentiated,
        }
    }

    fn asked(&self) -> (Fidelity, StructureOptions, usize, bool, Estimates, Option<f64>) {
        (self.fidelity, self.structure, self.positions, self.in_time, self.estimates, self.tolerance)
    }
}

impl fmt::Debug for PlannedWork {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("PlannedWork").field(&self.asked()).finish()
    }
}

impl PartialEq for PlannedWork {
    fn eq(&self, other: &Self) -> bool {
        self.asked() == other.asked()
    }
}

/// The treatment of a body.
#[derive(Clone, Debug, PartialEq)]
pub struct PlannedBody {
    pub name: String,
    /// Short description of its gear.
    pub gear: String,
    /// The unconstrained degrees of freedom of its frame, and the load on each.
    pub free: Vec<(&'static str, String)>,
    pub left_out: bool,
    /// `true` for a section of a shaft without teeth, or an attachment of an elastic body.
    pub section: bool,
    /// The reason for its model, or for omitting it.
    pub reason: &'static str,
    /// The finite-element mesh that it would get.
    pub mesh: PlannedStructure,
}

/// The structure of a body. Its mesh is generated and counted when its size is requested.
#[derive(Clone)]
pub struct PlannedStructure {
    prototype: Arc<dyn Prototype>,
    fidelity: Fidelity,
    options: StructureOptions,
    /// Index of the structure in the plan; `None` if the body is omitted.
    number: Option<usize>,
}

impl PlannedStructure {
    /// Returns the size of the equations; `None` without a mesh.
    pub fn size(&self) -> Option<StructureSize> {
        self.prototype.size(self.fidelity, &self.options)
    }
}

impl fmt::Debug for PlannedStructure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("PlannedStructure").field("options", &self.options).finish_non_exhaustive()
    }
}

impl PartialEq for PlannedStructure {
    fn eq(&self, other: &Self) -> bool {
        let same = |of: &Self| (of.fidelity, of.options, of.number);
        Arc::ptr_eq(&self.prototype, &other.prototype) && same(self) == same(other)
    }
}

/// A pair of gears whose teeth may touch.
#[derive(Clone, Debug, PartialEq)]
pub struct PlannedMesh {
    pub bodies: [String; 2],
    /// Contact cells of each tooth pair.
    pub grid: Grid,
    /// `true` if edge contact at the tips is searched.
    pub edges: bool,
    /// `true` for the back flanks of a mesh whose working flanks are also listed.
    pub back_sides: bool,
    pub contact_ratio: Option<f64>,
    /// Overlap ratio ε_β, the part of the contact ratio due to the helix.
    pub overlap_ratio: f64,
}

/// A shaft, or another elastic connection of bodies.
#[derive(Clone, Debug, PartialEq)]
pub struct PlannedShaft {
    pub name: String,
    /// The bodies or sections that it connects, each with its position on the shaft.
    pub sections: Vec<String>,
    /// Number of degrees of freedom of its sections.
    pub dofs: usize,
    /// Size of the mesh of a solid of revolution.
    pub solid: Option<ElasticBodySize>,
    pub rigid: bool,
    pub left_out: bool,
    /// The reason for its model, or for omitting it.
    pub reason: &'static str,
}

impl PlannedShaft {
    fn all(scene: &Scene, plan: &Plan, unit: LengthUnit) -> Vec<PlannedShaft> {
        let of = |(connection, planned): (&ElasticConnection, &ConnectionPlan)| {
            let shaft = connection.shaft.as_ref();
            let section = |(index, attachment): (usize, &Attachment)| {
                let name = match attachment.to {
                    Support::Ground => "ground".to_owned(),
                    Support::Body(body) => {
                        scene.bodies.get(body.0).map_or_else(String::new, |b| format!("\"{}\"", b.name))
                    }
                };
                let at = shaft.and_then(|shaft| shaft.stations.get(index));
                at.map_or(name.clone(), |at| format!("{name} at {} {}", rounded(at / unit.metres), unit.name))
            };
            let free = |body: BodyId| scene.bodies.get(body.0).map_or(&[][..], |body| &body.free);
            PlannedShaft {
                name: connection.name.clone(),
                sections: connection.attachments.iter().enumerate().map(section).collect(),
                dofs: connection.bodies().map(|body| free(body).iter().filter(|free| **free).count()).sum(),
                solid: connection
                    .solid_shaft(plan.fidelity)
                    .filter(|_| !planned.left_out)
                    .and_then(|shaft| shaft.shaft.solid_size(&shaft.stations, planned.shaft_mesh)),
                rigid: shaft.is_some_and(|shaft| shaft.rigid),
                left_out: planned.left_out,
                reason: planned.reason,
            }
        };
        let shafts = scene.connections.iter().zip(&plan.connections);
        shafts.filter(|(connection, _)| connection.body.is_none()).map(of).collect()
    }

    fn line(&self) -> String {
        let kind = match &self.solid {
            _ if self.rigid => "rigid".to_owned(),
            None => "elastic".to_owned(),
            Some(size) => format!(
                "a solid of revolution of {} elements and {} degrees of freedom, condensed to its sections",
                grouped(size.elements),
                grouped(size.dofs)
            ),
        };
        format!("\"{}\", {kind}, {} degrees of freedom: {}", self.name, self.dofs, self.sections.join(", "))
    }
}

impl Planned {
    pub(crate) fn of(host: &ModelHost, plan: &Plan, description: &ModelDescription) -> Planned {
        let scene = &host.scene;
        let gear = |index: usize| host.gears.get((*host.body_gears.get(index)?)?);
        let numbers = plan.structures(scene);
        let bodies = scene.bodies.iter().zip(&plan.bodies).enumerate().map(|(index, (body, planned))| {
            let LengthUnit { name, metres } = host.length_unit;
            PlannedBody {
                name: body.name.clone(),
                gear: gear(index).map_or_else(String::new, |blank| {
                    let width = rounded(blank.prototype().face_width() / metres);
                    format!("{} teeth, face width {width} {name}", blank.teeth())
                }),
                free: free(body, &description.units),
                left_out: planned.left_out,
                section: gear(index).is_none()
                    && scene
                        .connections_of(BodyId(index))
                        .any(|connection| connection.shaft.is_some() || connection.body.is_some()),
                reason: planned.reason,
                mesh: PlannedStructure {
                    prototype: body.prototype.clone(),
                    fidelity: plan.fidelity,
                    options: planned.options,
                    number: numbers.get(index).copied().flatten(),
                },
            }
        });
        let meshes = scene.pairs.iter().map(|pair| {
            let numbers = pair.bodies.map(|body| body.0);
            let meeting = host.mesh_records.iter().find(|meeting| meeting.bodies == numbers);
            PlannedMesh {
                bodies: numbers
                    .map(|body| scene.bodies.get(body).map_or_else(String::new, |b| b.name.clone())),
                grid: match plan.three_dimensional {
                    _ if plan.fidelity == Fidelity::Rigid => Grid { half_cells: 0, half_slices: None },
                    false => Grid { half_cells: pair.grid.plane_half_cells(), half_slices: None },
                    true => Grid {
                        half_cells: pair.grid.solid_half_cells(),
                        half_slices: Some(pair.grid.half_slices),
                    },
                },
                edges: pair.grid.edges,
                back_sides: pair.front.is_some(),
                contact_ratio: meeting.map(|meeting| meeting.geometry.contact_ratio),
                overlap_ratio: meeting.map_or(0.0, |meeting| meeting.geometry.overlap_ratio),
            }
        });
        let structures = numbers.iter().flatten().max().map_or(0, |last| last + 1);
        Planned {
            fidelity: plan.fidelity.name(),
            in_time: host.asked.is_some_and(|asked| asked.in_time),
            bodies: bodies.collect(),
            meshes: meshes.collect(),
            bearings: PlannedBearing::all(host, plan),
            shafts: PlannedShaft::all(scene, plan, host.length_unit),
            elastic_bodies: PlannedElasticBody::all(host, plan),
            sounds: planned_sound::lines(host, plan),
            outputs: host.outputs.iter().map(|output| output.name.clone()).collect(),
            positions: match host.asked {
                Some(asked) => vec![asked.problems],
                None => host.positions.iter().map(Vec::len).collect(),
            },
            structures,
            three_dimensional: plan.three_dimensional,
            refused: plan
                .refused
                .iter()
                .map(|refused| (refused.name.clone(), refused.needs.name()))
                .collect(),
            work: PlannedWork::of(host, plan),
            ignored_inputs: plan.ignored.iter().map(|i| (i.input.clone(), i.reason.clone())).collect(),
        }
    }

    /// Returns the degrees of freedom of the modelled bodies: the unknowns other than the
    /// pressures.
    pub fn dofs(&self) -> usize {
        self.bodies.iter().filter(|body| !body.left_out).map(|body| body.free.len()).sum()
    }

    /// Returns the number of contact pressures at a position. Without edge contact, the number of
    /// tooth pairs in contact is at most the contact ratio rounded up, and with backlash they touch
    /// on one side.
    pub(crate) fn cells_in_contact(&self) -> usize {
        let pairs = |mesh: &PlannedMesh| match mesh.contact_ratio {
            Some(ratio) => (ratio + mesh.overlap_ratio).ceil() as usize,
            None => 1,
        };
        let fronts = self.meshes.iter().filter(|mesh| !mesh.back_sides);
        fronts.map(|mesh| mesh.grid.cells() * pairs(mesh)).sum()
    }

    /// Returns the plan as text, in sections.
    pub fn text(&self) -> String {
        let mut text = String::new();
        let mut section = |title: &str, lines: Vec<String>| {
            if !lines.is_empty() {
                let gap = if text.is_empty() { "" } else { "\n" };
                let _ = write!(text, "{gap}{title}\n  {}\n", lines.join("\n  "));
            }
        };
        section("Method", vec![self.fidelity_text()]);
        let modelled = self.bodies.iter().filter(|body| !body.left_out && !body.section);
        section("Bodies", modelled.flat_map(body_lines).collect());
        let sizes = self.sizes();
        section("Structures", self.structure_lines(&sizes));
        section("Contact", self.meshes.iter().map(mesh_line).collect());
        let modelled = self.bearings.iter().filter(|bearing| !bearing.left_out);
        section("Bearings", modelled.map(PlannedBearing::line).collect());
        let modelled = self.shafts.iter().filter(|shaft| !shaft.left_out);
        section("Shafts", modelled.map(PlannedShaft::line).collect());
        let modelled = self.elastic_bodies.iter().filter(|body| !body.left_out);
        section("Elastic bodies", modelled.flat_map(PlannedElasticBody::lines).collect());
        section("Radiated sound", self.sounds.clone());
        section("Degrees of freedom", self.freedom_lines());
        section("Outputs", lines_of(&self.outputs));
        let left_out = self.bodies.iter().filter(|body| body.left_out);
        let left_out =
            left_out.map(|body| format!("body \"{}\": {}", body.name, without_verdict(body.reason)));
        let idle = self.bearings.iter().filter(|bearing| bearing.left_out);
        let idle =
            idle.map(|bearing| format!("bearing \"{}\": {}", bearing.name, without_verdict(bearing.reason)));
        let unused = self.elastic_bodies.iter().filter(|body| body.left_out);
        let unused =
            unused.map(|body| format!("elastic body \"{}\": {}", body.name, without_verdict(body.reason)));
        let idle = idle.chain(unused);
        let not_seen = self.ignored_inputs.iter().map(|(input, reason)| format!("`{input}`: {reason}"));
        let refused = self.refused.iter().map(|(output, needs)| {
            format!(
                "output `{output}`: it needs {needs}, which the fidelity \"{}\" does not support",
                self.fidelity
            )
        });
        section("Omitted", left_out.chain(idle).chain(refused).chain(not_seen).collect());
        section("Cost", self.cost_lines(&sizes));
        text
    }

    fn fidelity_text(&self) -> String {
        let place = match self.three_dimensional {
            false => "two-dimensional transverse section (plane strain)",
            true => "three-dimensional, surface contact on grids along and across the face",
        };
        match self.fidelity {
            "rigid" => format!("fidelity \"rigid\": rigid bodies in the limit of zero load, {place}"),
            "analytic" => format!(
                "fidelity \"analytic\": teeth as cantilevers on rings with Hertzian contact, in closed form, {place}"
            ),
            "plane" => format!("fidelity \"plane\": {place}"),
            other => format!(
                "fidelity \"{other}\": three-dimensional finite elements, surface contact on grids along and across the face"
            ),
        }
    }

    fn freedom_lines(&self) -> Vec<String> {
        let bodies = self.bodies.iter().filter(|body| !body.left_out);
        let free: Vec<String> = bodies
            .flat_map(|body| {
                // The sections of shafts are listed with their shaft.
                let listed = body.free.iter().filter(|(_, load)| !body.section || load != NO_LOAD);
                listed.map(move |(dof, load)| format!("{dof} of \"{}\", {load}", body.name))
            })
            .collect();
        let of_sections = self.bodies.iter().any(|body| !body.left_out && !body.free.is_empty());
        match (free.is_empty(), of_sections) {
            (false, _) => free,
            (true, true) => vec!["only those of the shafts".into()],
            (true, false) => vec!["none: the motion of every frame is prescribed".into()],
        }
    }

    /// Returns each structure with the bodies that share it and with its size.
    pub(crate) fn sizes(&self) -> Vec<(Vec<&str>, StructureSize)> {
        let of = |number: usize| {
            let bodies = || self.bodies.iter().filter(move |body| body.mesh.number == Some(number));
            // If one of the bodies that share a structure requests stresses, its size applies.
            let largest = bodies().filter_map(|body| body.mesh.size()).max_by_key(|size| size.stresses)?;
            Some((bodies().map(|body| body.name.as_str()).collect(), largest))
        };
        (0..self.structures).filter_map(of).collect()
    }

    fn structure_lines(&self, sizes: &[(Vec<&str>, StructureSize)]) -> Vec<String> {
        let lines = |(bodies, size): &(Vec<&str>, StructureSize)| {
            let names: Vec<String> = bodies.iter().map(|name| format!("\"{name}\"")).collect();
            let stress = match size.stresses {
                0 => "no stress points".to_owned(),
                count => format!("{} stress points", grouped(count)),
            };
            let means = match size.means {
                0 => String::new(),
                count => format!(" and {} of the bore constraint", grouped(count)),
            };
            [
                format!(
                    "{}: {} sectors of {} elements and {} degrees of freedom, {} in all",
                    names.join(", "),
                    grouped(size.sectors as usize),
                    grouped(size.elements),
                    grouped(size.dofs),
                    grouped(size.body_dofs())
                ),
                format!("  condensed to {} interface unknowns{means}", grouped(2 * size.cut)),
                format!("  per tooth: {} unit loads on the flanks, {stress}", grouped(size.loads)),
                format!(
                    "  about {} multiplications, {} stored",
                    of_thousands(size.operations(), [" thousand", " million", " billion", " trillion"]),
                    of_thousands(size.bytes() as f64, [" kB", " MB", " GB", " TB"])
                ),
            ]
        };
        sizes.iter().flat_map(lines).collect()
    }

    fn cost_lines(&self, sizes: &[(Vec<&str>, StructureSize)]) -> Vec<String> {
        let mut lines = vec![match self.structures {
            _ if matches!(self.fidelity, "rigid" | "analytic") => "no finite-element meshes".to_owned(),
            1 => "static condensation of 1 elastic structure".to_owned(),
            count => format!("static condensation of {count} elastic structures"),
        }];
        if sizes.len() > 1 {
            let operations = sizes.iter().map(|(_, size)| size.operations()).sum();
            let bytes: usize = sizes.iter().map(|(_, size)| size.bytes()).sum();
            lines.push(format!(
                "together about {} multiplications, {} stored",
                of_thousands(operations, [" thousand", " million", " billion", " trillion"]),
                of_thousands(bytes as f64, [" kB", " MB", " GB", " TB"])
            ));
        }
        let cells = self.cells_in_contact();
        let dofs = match self.dofs() {
            1 => "1 degree of freedom".to_owned(),
            count => format!("{count} degrees of freedom"),
        };
        let unknowns = match cells {
            0 => dofs,
            _ => format!("about {cells} contact pressures and {dofs}"),
        };
        lines.push(match self.positions[..] {
            [] => format!("no positions are given; each position is a contact problem with {unknowns}"),
            [count] => format!("{count} positions, each a contact problem with {unknowns}"),
            _ => {
                let counts: Vec<String> = self.positions.iter().map(usize::to_string).collect();
                let counts = counts.join(" or ");
                format!(
                    "{counts} positions, depending on the analysis, each a contact problem with {unknowns}"
                )
            }
        });
        lines
    }
}

/// Line width for lists of names.
const WIDTH: usize = 96;

/// Formats names as lines with commas between them.
fn lines_of(names: &[String]) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for (index, name) in names.iter().enumerate() {
        let comma = if index + 1 < names.len() { "," } else { "" };
        match lines.last_mut().filter(|line| line.len() + name.len() + 2 <= WIDTH) {
            Some(line) => *line += &format!(" {name}{comma}"),
            None => lines.push(format!("{name}{comma}")),
        }
    }
    lines
}

/// Returns the free components of a body's frame, with the load on each. A load that varies with
/// time is evaluated at the start.
fn free(body: &Body, system: &str) -> Vec<(&'static str, String)> {
    let system = UnitSystem::from_name(system).unwrap_or(UnitSystem::Si);
    let of = |name: &str| system.unit_of(Dimension::from_name(name).unwrap_or(Dimension::NONE));
    let Wrench { force, moment } = body.load.at(0.0);
    let loads = force.iter().chain(&moment);
    let at_start = if body.load.is_constant() { "" } else { " at Time = 0" };
    let each = DOF_NAMES.iter().zip(body.free).zip(loads).enumerate().filter(|(_, ((_, free), _))| *free);
    each.map(|(index, ((name, _), load))| {
        let (kind, unit) = if index < 3 { ("force", of("Force")) } else { ("moment", of("Moment")) };
        let load = if *load == 0.0 { NO_LOAD.into() } else { format!("{kind} {}", in_unit(*load, &unit)) };
        (*name, load + at_start)
    })
    .collect()
}

fn body_lines(body: &PlannedBody) -> [String; 2] {
    let gear = if body.gear.is_empty() { String::new() } else { format!(": {}", body.gear) };
    [format!("\"{}\"{gear}", body.name), format!("  {}", body.reason)]
}

/// Removes the verdict from a reason, because the title already states it.
fn without_verdict(reason: &str) -> &str {
    reason.strip_prefix("left out: ").unwrap_or(reason)
}

fn mesh_line(mesh: &PlannedMesh) -> String {
    let [first, second] = &mesh.bodies;
    let ratio = mesh.contact_ratio.map(|ratio| format!(", contact ratio {ratio:.3}")).unwrap_or_default();
    let edges = match (mesh.back_sides, mesh.edges) {
        (true, _) => "back flanks",
        (false, true) => "flanks and tip edges",
        (false, false) => "flanks on the nominal path of contact",
    };
    let cells = match mesh.grid.cells() {
        // Rigid bodies touch without a contact grid.
        0 => String::new(),
        cells => format!(", {cells} cells per tooth pair"),
    };
    format!("\"{first}\" with \"{second}\": {edges}{cells}{ratio}")
}
