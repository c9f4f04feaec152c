//! Elastic bodies for programs: the Rust side of `nastran`, `abaqus`, `gmsh`, `condensed_body`,
//! `attachment`, `opening`, `panel` and the regions in `gears.cx`.

use crate::body_externs::BodyPlacement;
use crate::elastic_bodies::{AttachedPart, BodySource, ModelElasticBody, RequestedAttachment};
use crate::elastic_plausibility::of_elastic_body;
use crate::externs::{self, entry, host, refusal};
use crate::files;
use crate::host::{ModelHost, keep};
use calyx_abi::externs::{Handle, SymbolicTransform};
use calyx_abi::limits::request_memory;
use calyx_abi::{Context, RuntimeError, SymbolicValue};
use calyx_runtime::cache::{Key, KeyWriter};
use calyx_runtime::elastic::attachment::{Connection, Region};
use calyx_runtime::elastic::import::{
    AbaqusOptions, CondensedOptions, GmshOptions, GmshPart, Import, ImportError, NastranOptions, OpenFile,
    Units, Unreadable, read_abaqus, read_condensed, read_gmsh, read_nastran,
};
use calyx_runtime::elastic::{ElasticModel, Material};
use calyx_runtime::elastic_body::{FiniteElementBody, MatrixBody};
use std::sync::Arc;

/// First handle of elastic bodies, beyond those of bodies: to a program they are bodies.
const ELASTIC_BODIES: u64 = 1 << 61;
/// Memory of a parsed model relative to its file.
const PARSED: u64 = 8;

calyx_abi::externs! {
    Scene fn calyx_gears_nastran(
        context, name: String, path: String, units: String, subcase: Option<f64>, frame: SymbolicTransform,
    ) -> Handle {
        let subcase = subcase.map(|number| whole(("E0990", "subcase"), number, 1)).transpose()?;
        let (named, units) = (units.clone(), named_units(&units)?);
        let options = NastranOptions { units, subcase: subcase.map(u64::from) };
        let key = Key::of("nastran").text(&path).numbers(&of_units(&units)).count(subcase.map_or(0, u64::from));
        let read = |open: &mut OpenFile<'_>| read_nastran(&path, &options, open);
        imported(context, (name, frame), (key, Some((named, units))), read)
    }

    Scene fn calyx_gears_abaqus(
        context, name: String, path: String, units: String, frame: SymbolicTransform,
    ) -> Handle {
        let (named, units) = (units.clone(), named_units(&units)?);
        let key = Key::of("abaqus").text(&path).numbers(&of_units(&units));
        let read = |open: &mut OpenFile<'_>| read_abaqus(&path, &AbaqusOptions { units }, open);
        imported(context, (name, frame), (key, Some((named, units))), read)
    }

    Pure fn calyx_gears_mesh_part(context, group: String, material: Handle, thickness: Option<f64>) -> Handle {
        let host = host(context)?;
        let part = mesh_part(host, Some(group), material, thickness)?;
        Ok(keep(&mut host.mesh_parts, part))
    }

    Scene fn calyx_gears_gmsh(
        context, name: String, path: String, material: Handle, thickness: Option<f64>, parts: Vec<Handle>,
        unit: f64, frame: SymbolicTransform,
    ) -> Handle {
        let host = host(context)?;
        let mut all = parts
            .into_iter()
            .map(|part| entry(&host.mesh_parts, part).cloned())
            .collect::<Result<Vec<GmshPart>, _>>()?;
        all.push(mesh_part(host, None, material, thickness)?);
        let mut key = Key::of("gmsh").text(&path).number(unit).count(all.len() as u64);
        for GmshPart { physical, material, thickness } in &all {
            key = key.text(physical.as_deref().unwrap_or("")).numbers(&[
                material.youngs_modulus,
                material.poissons_ratio,
                material.density,
                thickness.unwrap_or(0.0),
            ]);
        }
        let options = GmshOptions { length: unit, parts: all };
        let read = |open: &mut OpenFile<'_>| read_gmsh(&path, &options, open);
        imported(context, (name, frame), (key, None), read)
    }

    Scene fn calyx_gears_condensed_body(
        context, name: String, path: String, units: String, stiffness_matrix: Option<String>,
        mass_matrix: Option<String>, frame: SymbolicTransform,
    ) -> Handle {
        let units = named_units(&units)?;
        let written = |key: KeyWriter, name: &Option<String>| key.text(name.as_deref().unwrap_or(""));
        let key = Key::of("condensed body").text(&path).numbers(&of_units(&units));
        let key = written(written(key, &stiffness_matrix), &mass_matrix);
        let options = CondensedOptions { units, stiffness: stiffness_matrix, mass: mass_matrix };
        let read = |open: &mut OpenFile<'_>| read_condensed(&path, &options, open);
        before_analysis(context, &name)?;
        let (matrices, key) = read_with(context, key, read)?;
        added(context, (name, frame), BodySource::Matrices(MatrixBody::new(Arc::new(matrices), key)), None)
    }

    Pure fn calyx_gears_node_set(context, name: String) -> Handle {
        region(context, AttachedPart::Region(Region::Set(name)))
    }

    Pure fn calyx_gears_node(context, label: String) -> Handle {
        region(context, AttachedPart::Node(label))
    }

    Pure fn calyx_gears_nearest_node(context, point: [f64; 3]) -> Handle {
        region(context, AttachedPart::Region(Region::Nearest(point)))
    }

    Pure fn calyx_gears_cylinder_region(
        context, center: [f64; 3], axis: [f64; 3], radius: f64, from: f64, to: f64, tolerance: Option<f64>,
    ) -> Handle {
        direction("axis", axis)?;
        if from > to {
            return Err(refusal("E0991", "from", "the cylinder ends before it begins",
                "give `from` and `to` in ascending order along the axis"));
        }
        let tolerance = tolerance.unwrap_or(0.01 * radius);
        let region = Region::Cylinder { origin: center, axis, radius, heights: [from, to], tolerance };
        self::region(context, AttachedPart::Region(region))
    }

    Scene fn calyx_gears_bore_region(
        context, body: Handle, center: [f64; 3], axis: [f64; 3], diameter: f64, length: f64,
    ) -> Handle {
        direction("axis", axis)?;
        let (radius, half) = (0.5 * diameter, 0.5 * length);
        let region = Region::Cylinder { origin: center, axis, radius, heights: [-half, half], tolerance: 0.01 * radius };
        let index = elastic_body(context, body)?;
        if let BodySource::Elements(elements) = &host(context)?.elastic_bodies[index].source {
            let checked = region.check_surrounds_axis(elements.model());
            checked.map_err(|error| refusal("E0991", "diameter", &error.message, &error.help))?;
        }
        self::region(context, AttachedPart::Region(region))
    }

    Pure fn calyx_gears_plane_region(context, point: [f64; 3], normal: [f64; 3], tolerance: f64) -> Handle {
        direction("normal", normal)?;
        region(context, AttachedPart::Region(Region::Plane { origin: point, normal, tolerance }))
    }

    Pure fn calyx_gears_box_region(context, lowest: [f64; 3], highest: [f64; 3]) -> Handle {
        if (0..3).any(|k| lowest[k] > highest[k]) {
            return Err(refusal("E0991", "lowest", "the box ends before it begins",
                "give the smaller coordinate of every axis in `lowest`"));
        }
        region(context, AttachedPart::Region(Region::Box { lowest, highest }))
    }

    Pure fn calyx_gears_sphere_region(context, center: [f64; 3], radius: f64) -> Handle {
        region(context, AttachedPart::Region(Region::Sphere { centre: center, radius }))
    }

    /// Position of an attachment in the coordinates of its body. Adds nothing to the scene.
    Scene fn calyx_gears_attachment_position(
        context, name: String, body: Handle, region: Handle, how: String, harmonics: Vec<f64>, axis: [f64; 3],
        raceway_harmonics: Option<f64>, raceway_degree: f64, position: Option<[f64; 3]>,
    ) -> [f64; 3] {
        let raceway = (raceway_harmonics, raceway_degree);
        let requested = requested(context, name, region, (how, harmonics, axis, raceway), position)?;
        let index = elastic_body(context, body)?;
        let mut source = host(context)?.elastic_bodies[index].source.clone();
        source.attach(&requested).map_err(|error| blamed(externs::engine(error)))
    }

    Scene fn calyx_gears_opening(context, name: String, body: Handle, region: Handle) -> () {
        externs::before_analysis(context, format_args!("the opening \"{name}\""))?;
        let name = context.name_in_instance(name);
        let part = entry(&host(context)?.regions, region)?.clone();
        let index = elastic_body(context, body)?;
        let ModelHost { scene, elastic_bodies, .. } = host(context)?;
        elastic_bodies[index].close(scene, name, &part).map_err(|error| blamed(externs::engine(error)))
    }

    Scene fn calyx_gears_panel(context, name: String, body: Handle, region: Handle) -> () {
        externs::before_analysis(context, format_args!("the panel \"{name}\""))?;
        let name = context.name_in_instance(name);
        let part = entry(&host(context)?.regions, region)?.clone();
        let index = elastic_body(context, body)?;
        let ModelHost { scene, elastic_bodies, .. } = host(context)?;
        elastic_bodies[index].add_panel(scene, name, &part).map_err(|error| blamed(externs::engine(error)))
    }

    Scene fn calyx_gears_attached_body(
        context, name: String, body: Handle, region: Handle, how: String, harmonics: Vec<f64>, axis: [f64; 3],
        raceway_harmonics: Option<f64>, raceway_degree: f64, position: Option<[f64; 3]>, fixed: bool,
        frame: SymbolicTransform,
    ) -> Handle {
        let raceway = (raceway_harmonics, raceway_degree);
        let requested = requested(context, name, region, (how, harmonics, axis, raceway), position)?;
        let index = elastic_body(context, body)?;
        let expression = frame.0.clone();
        let motion = BodyPlacement::motion(frame, context.params.clone());
        let (place, host) = (context.place, host(context)?);
        let ModelHost { scene, elastic_bodies, .. } = host;
        let attached = elastic_bodies[index].attach(scene, &requested, (motion, fixed));
        let id = attached.map_err(|refused| blamed(host.rejected(refused, place)))?;
        warn_about_arm(host, index, &requested.name);
        host.body_gears.push(None);
        host.body_frames.push(expression);
        // The call of the elastic body is in the model; that of this function is in the library.
        host.body_places.push(host.elastic_bodies[index].place);
        Ok(Handle(id.0 as u64))
    }
}

/// Reports that the last attachment of a body is farther from its nodes than the size of their
/// region: its position is in other coordinates, or a rigid arm is intended.
fn warn_about_arm(host: &mut ModelHost, index: usize, name: &str) {
    let place = host.elastic_bodies[index].place;
    let body = host.elastic_bodies[index].source.body();
    let (Some(position), Some(extent)) = (body.positions().pop(), body.extents().pop()) else { return };
    let distance = extent.distance(position);
    if distance <= extent.size {
        return;
    }
    let mm = |metres: f64| (metres * 1e6).round() / 1e3;
    let message = format!(
        "the position of the attachment \"{name}\" is {} mm away from its nodes, whose region is {} mm wide",
        mm(distance),
        mm(extent.size)
    );
    let help =
        "give `position` in the coordinates of the file, unless a rigid arm of this length is intended";
    host.warn("E0993", message, help, place);
}

/// Blames the region for an impossible attachment, opening or panel, unless another argument is at
/// fault.
fn blamed(error: RuntimeError) -> RuntimeError {
    if error.code == "E0991" && error.argument.is_none() { error.of_argument("region") } else { error }
}

fn named_units(name: &str) -> Result<Units, RuntimeError> {
    Units::named(name).ok_or_else(|| {
        let help = format!("choose from {}", Units::NAMES.join(", "));
        refusal("E0990", "units", &format!("there is no system of units \"{name}\""), &help)
    })
}

fn of_units(units: &Units) -> [f64; 3] {
    [units.length, units.force, units.time]
}

/// Converts a whole number, at least `least`; otherwise the error has this code and argument.
fn whole((code, argument): (&str, &str), number: f64, least: u32) -> Result<u32, RuntimeError> {
    if number.fract() == 0.0 && (f64::from(least)..=f64::from(u32::MAX)).contains(&number) {
        return Ok(number as u32);
    }
    Err(refusal(
        code,
        argument,
        &format!("`{argument}` cannot be {number}"),
        &format!("give a whole number of at least {least}"),
    ))
}

fn direction(argument: &str, vector: [f64; 3]) -> Result<(), RuntimeError> {
    if vector.iter().any(|part| *part != 0.0) {
        return Ok(());
    }
    Err(refusal("E0991", argument, &format!("`{argument}` has no direction"), "give a vector such as `e3`"))
}

fn region(context: &mut Context, part: AttachedPart) -> Result<Handle, RuntimeError> {
    Ok(keep(&mut host(context)?.regions, part))
}

fn mesh_part(
    host: &ModelHost,
    physical: Option<String>,
    material: Handle,
    thickness: Option<f64>,
) -> Result<GmshPart, RuntimeError> {
    let known = entry(&host.materials, material)?;
    let material = Material {
        youngs_modulus: known.youngs_modulus,
        poissons_ratio: known.poissons_ratio,
        shear_modulus: 0.5 * known.youngs_modulus / (1.0 + known.poissons_ratio),
        density: known.density,
        structural_damping: 0.0,
    };
    Ok(GmshPart { physical, material, thickness })
}

/// Reads a body with a function of the importer. Returns it with the key of everything that was
/// read, which `key` begins.
///
/// # Errors
/// E0730: a file cannot be read. E0990: a file is invalid. E0707: the memory limit is reached.
fn read_with<T>(
    context: &mut Context,
    key: KeyWriter,
    read: impl FnOnce(&mut OpenFile<'_>) -> Result<T, ImportError>,
) -> Result<(T, Key), RuntimeError> {
    let (mut key, mut stopped, mut unreadable, mut main_is_read) = (Some(key), None, false, false);
    let result = {
        let mut open = |path: &str| {
            let taken = files::read_bytes(context, path).and_then(|found| match found {
                Ok(bytes) => {
                    request_memory(context, PARSED * bytes.len() as u64)?;
                    Ok(Ok(bytes))
                }
                Err(refused) => Ok(Err(refused)),
            });
            match taken {
                Ok(Ok(bytes)) => {
                    main_is_read = true;
                    key = key.take().map(|key| key.text(path).content(&bytes));
                    Ok(bytes)
                }
                Ok(Err((message, help))) => {
                    unreadable = true;
                    Err(Unreadable::new(message, help))
                }
                Err(error) => {
                    let refused = Unreadable::new(error.message.clone(), "");
                    stopped = Some(error);
                    Err(refused)
                }
            }
        };
        read(&mut open)
    };
    if let Some(error) = stopped {
        return Err(error);
    }
    let read = result.map_err(|ImportError { file, line, message, help }| match unreadable {
        true if main_is_read => refusal("E0730", "path", &format!("{file}, line {line}: {message}"), &help),
        true => refusal("E0730", "path", &message, &help),
        false => refusal("E0990", "path", &format!("{file}, line {line}: {message}"), &help),
    })?;
    let key = key.map(KeyWriter::finish).ok_or_else(|| externs::defect("a file has no key"))?;
    Ok((read, key))
}

fn imported(
    context: &mut Context,
    placed: (String, SymbolicTransform),
    (key, units): (KeyWriter, Option<(String, Units)>),
    read: impl FnOnce(&mut OpenFile<'_>) -> Result<Import, ImportError>,
) -> Result<Handle, RuntimeError> {
    before_analysis(context, &placed.0)?;
    let (Import { model, report }, key) = read_with(context, key, read)?;
    check_elements(&model, &report.files)?;
    let (place, name) = (context.place, context.name_in_instance(placed.0.clone()));
    let found = of_elastic_body(&name, &model, units.as_ref(), place);
    host(context)?.findings.extend(found);
    let source = BodySource::Elements(FiniteElementBody::new(Arc::new(model), key));
    added(context, placed, source, Some(report))
}

fn before_analysis(context: &mut Context, name: &str) -> Result<(), RuntimeError> {
    externs::before_analysis(context, format_args!("the elastic body \"{name}\""))
}

fn check_elements(model: &ElasticModel, files: &[String]) -> Result<(), RuntimeError> {
    if !model.elements.is_empty() {
        return Ok(());
    }
    let file = files.first().map_or("", String::as_str);
    Err(refusal(
        "E0990",
        "path",
        &format!("{file}: the file has no elements"),
        "export the mesh with its elements",
    ))
}

fn added(
    context: &mut Context,
    (name, frame): (String, SymbolicTransform),
    source: BodySource,
    report: Option<calyx_runtime::elastic::import::ImportReport>,
) -> Result<Handle, RuntimeError> {
    let name = context.name_in_instance(name);
    let expression = frame.0.clone();
    let motion = BodyPlacement::motion(frame, context.params.clone());
    let (place, host) = (context.place, host(context)?);
    if host.elastic_bodies.iter().any(|other| other.name == name) {
        let message = format!("there are two elastic bodies called \"{name}\"");
        return Err(refusal("E0671", "name", &message, "give each body a name of its own"));
    }
    let body = ModelElasticBody {
        name,
        source,
        report,
        motion,
        frame: expression,
        place,
        attached: Vec::new(),
        connection: None,
    };
    let Handle(index) = keep(&mut host.elastic_bodies, body);
    Ok(Handle(ELASTIC_BODIES + index))
}

/// Returns the index of an elastic body by its handle; `None` for the handle of another body.
pub(crate) fn as_elastic_body(host: &ModelHost, handle: Handle) -> Option<usize> {
    let index = usize::try_from(handle.0.checked_sub(ELASTIC_BODIES)?).ok()?;
    (index < host.elastic_bodies.len()).then_some(index)
}

/// Returns the expression of the frame of an elastic body, if the handle is that of one.
pub(crate) fn elastic_frame(host: &ModelHost, handle: Handle) -> Option<Arc<SymbolicValue>> {
    as_elastic_body(host, handle).map(|index| host.elastic_bodies[index].frame.clone())
}

/// Returns the error for an elastic body where a body of the scene is required, if the handle is
/// that of one.
pub(crate) fn has_no_motion(host: &ModelHost, argument: &str, handle: Handle) -> Option<RuntimeError> {
    let body = &host.elastic_bodies[as_elastic_body(host, handle)?];
    let message = format!("\"{}\" is an elastic body, whose points have different motions", body.name);
    Some(refusal(
        "E0991",
        argument,
        &message,
        "give one of its attachments, which `gears.attachment` returns",
    ))
}

/// Returns the index of the elastic body that is given as an argument.
///
/// # Errors
/// E0991: the body is no elastic body.
fn elastic_body(context: &mut Context, handle: Handle) -> Result<usize, RuntimeError> {
    if let Some(index) = as_elastic_body(host(context)?, handle) {
        return Ok(index);
    }
    Err(refusal(
        "E0991",
        "body",
        "this body has no finite elements to be attached",
        "give what `gears.nastran`, `gears.abaqus`, `gears.gmsh` or `gears.condensed_body` returned",
    ))
}

fn requested(
    context: &mut Context,
    name: String,
    region: Handle,
    (how, harmonics, axis, raceway): (String, Vec<f64>, [f64; 3], (Option<f64>, f64)),
    position: Option<[f64; 3]>,
) -> Result<RequestedAttachment, RuntimeError> {
    let connection = match how.as_str() {
        "average" => Connection::Average,
        "fourier" => {
            direction("axis", axis)?;
            let harmonics = harmonics.into_iter().map(|order| whole(("E0991", "harmonics"), order, 0));
            Connection::Fourier { axis, harmonics: harmonics.collect::<Result<_, _>>()? }
        }
        "raceway" => Connection::Raceway {
            harmonics: raceway
                .0
                .map(|number| Ok::<_, RuntimeError>(whole(("E0991", "raceway_harmonics"), number, 2)? as u16))
                .transpose()?,
            degree: whole(("E0991", "raceway_degree"), raceway.1, 0)? as u8,
        },
        _ => Connection::Rigid,
    };
    externs::before_analysis(context, format_args!("the attachment \"{name}\""))?;
    let name = context.name_in_instance(name);
    let part = entry(&host(context)?.regions, region)?.clone();
    Ok(RequestedAttachment { name, part, connection, position })
}
