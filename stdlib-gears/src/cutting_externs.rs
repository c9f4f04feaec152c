//! Tools, rims and gears for programs: the Rust side of `rack`, `shaper`, `external` and `internal`
//! of `gears.cx`. Those of rims on webs are in [`crate::web`].

use crate::basic_rack::StatedRack;
use crate::blank::{GearBlank, RadialFit, Rim, SplineSupport, Tool};
use crate::data_block::StatedData;
use crate::error::{GeometryError, Refusal, Severity};
use crate::externs::{entry, host, refusal};
use crate::flank_tolerances::{Edition, FlankTolerances};
use crate::helix::{Hand, Helix};
use crate::host::{GearModel, ModelHost, keep};
use crate::material_names;
use crate::modification::Modification;
use crate::plausibility::{StatedModule, metric_pitch, of_gear, tiny_module};
use crate::prototype::GearPrototype;
use crate::rack::{Plane, Rack};
use crate::roughing::RoughingTool;
use crate::shaper::Shaper;
use crate::stated_gear::{
    BlankStatements, ModuleStatement, Proportions, TipStatements, check_sides, sized_rack, sized_shaper,
};
use crate::stated_geometry::{Resolved, StatedGeometry};
use crate::stated_thickness::{Limit, ThicknessStatements};
use calyx_abi::externs::Handle;
use calyx_abi::{Context, RuntimeError, math};
use calyx_runtime::structure::BoreSupport;
use std::sync::Arc;

calyx_abi::externs! {
    Pure fn calyx_gears_rack(
        context, module: Option<f64>, diametral_pitch: Option<f64>, pressure_angle: f64, tip_radius: f64,
        plane: Option<String>, addendum: Option<f64>, dedendum: Option<f64>, protuberance: Option<f64>,
        protuberance_angle: Option<f64>, protuberance_height: Option<f64>, grinding_allowance: Option<f64>,
        tool_addendum: Option<f64>,
    ) -> Handle {
        let module = module_of("rack", module, diametral_pitch)?;
        let (place, host) = (context.place, host(context)?);
        let rack = Rack::new(module, pressure_angle, tip_radius).map_err(|error| host.runtime_error(&error, place))?;
        let plane = plane.map_or(Plane::Unstated, |plane| Plane::named(&plane).unwrap_or_default());
        let tool = RoughingTool {
            protuberance,
            angle: protuberance_angle,
            height: protuberance_height,
            allowance: grinding_allowance,
            addendum: tool_addendum,
        };
        let shaped = tool.shape(rack).and_then(|shaped| Ok((shaped, tool.dedendum(dedendum, &rack)?)));
        let (rack, dedendum) = shaped.map_err(|error| host.runtime_error(&error, place))?;
        let rack = StatedRack::sized(rack.in_plane(plane), addendum, dedendum);
        Ok(keep(&mut host.racks, rack))
    }

    Pure fn calyx_gears_named_rack(context, name: String) -> Handle {
        let rack = StatedRack::named(&name).ok_or_else(|| unknown_name("basic rack", &name, StatedRack::names()))?;
        Ok(keep(&mut host(context)?.racks, rack))
    }

    Pure fn calyx_gears_with_protuberance(
        context, rack: Handle, protuberance: f64, protuberance_angle: Option<f64>,
        protuberance_height: Option<f64>, grinding_allowance: Option<f64>,
    ) -> Handle {
        let (place, host) = (context.place, host(context)?);
        let tool = RoughingTool {
            protuberance: Some(protuberance),
            angle: protuberance_angle,
            height: protuberance_height,
            allowance: grinding_allowance,
            addendum: None,
        };
        let rack = entry(&host.racks, rack)?.roughed_by(tool);
        let rack = rack.map_err(|error| host.runtime_error(&error, place))?;
        Ok(keep(&mut host.racks, rack))
    }

    Pure fn calyx_gears_named_material(context, name: String) -> Handle {
        let (name, material) = material_names::named(&name)
            .ok_or_else(|| unknown_name("material", &name, material_names::names()))?;
        let host = host(context)?;
        let handle = keep(&mut host.materials, material);
        host.material_names.insert(handle.0, name);
        Ok(handle)
    }

    Pure fn calyx_gears_shaper(
        context, teeth: f64, module: Option<f64>, diametral_pitch: Option<f64>, pressure_angle: f64,
        tip_radius: f64, addendum: Option<f64>,
    ) -> Handle {
        let teeth = whole_teeth(teeth)?;
        let module = module_of("shaper", module, diametral_pitch)?;
        let addendum = addendum.unwrap_or(Shaper::USUAL_ADDENDUM * module);
        let (place, host) = (context.place, host(context)?);
        let shaper = Shaper::new(teeth, module, pressure_angle, addendum, tip_radius)
            .map_err(|error| host.runtime_error(&error, place))?;
        Ok(keep(&mut host.shapers, shaper))
    }

    Pure fn calyx_gears_simple_rim(
        context, diameter: f64, inner_diameter: f64, bore: String, bore_harmonics: f64,
        bore_axial_degree: Option<f64>,
    ) -> Handle {
        let degree = bore_axial_degree.unwrap_or(if bore == "raceway" { RACEWAY_DEGREE } else { 1.0 });
        let support = bore_support(&bore, ["bore_harmonics", "bore_axial_degree"], [bore_harmonics, degree])?;
        let (place, host) = (context.place, host(context)?);
        let rim = Rim::new(diameter, inner_diameter).map_err(|error| host.rejected(error.into(), place))?;
        Ok(keep(&mut host.rims, rim.supported_by(support)))
    }

    Pure fn calyx_gears_outer_rim(
        context, diameter: f64, outer_diameter: f64, outer_surface: String, outer_surface_harmonics: f64, outer_surface_axial_degree: f64,
    ) -> Handle {
        let support = bore_support(&outer_surface, ["outer_surface_harmonics", "outer_surface_axial_degree"], [outer_surface_harmonics, outer_surface_axial_degree])?;
        let (place, host) = (context.place, host(context)?);
        let rim = Rim::outer(diameter, outer_diameter).map_err(|error| host.rejected(error.into(), place))?;
        Ok(keep(&mut host.rims, rim.supported_by(support)))
    }

    Pure fn calyx_gears_splined(
        context, rim: Handle, teeth: f64, width: Option<f64>, first_angle: f64, centring: String,
        stiffness: Option<f64>, radial_stiffness: Option<f64>, axial_degree: f64, clearance: f64,
    ) -> Handle {
        for (name, number) in [("teeth", teeth), ("axial_degree", axial_degree)] {
            if number.fract() != 0.0 {
                return Err(refusal("E0655", name, &format!("`{name}` cannot be {number}"), "give a whole number"));
            }
        }
        let radial = match (centring.as_str(), radial_stiffness) {
            ("diameter", stiffness) => Some(RadialFit { stiffness }),
            (_, None) => None,
            (_, Some(_)) => return Err(refusal(
                "E0655",
                "radial_stiffness",
                "`radial_stiffness` requires `centring = \"diameter\"`; these spline teeth centre on their flanks",
                "leave it out, or choose \"diameter\"",
            )),
        };
        let spline = SplineSupport {
            spline_teeth: teeth as u16,
            width,
            first: first_angle,
            stiffness,
            radial,
            axial_order: axial_degree as u8,
            clearance,
        };
        let (place, host) = (context.place, host(context)?);
        let rim = entry(&host.rims, rim)?.clone();
        let rim = rim.splined(&spline).map_err(|error| host.rejected(error.into(), place))?;
        Ok(keep(&mut host.rims, rim))
    }

    Pure fn calyx_gears_external(
        context, teeth: f64, rack: Handle, face_width: f64, outer_diameter: Option<f64>,
        root_diameter: Option<f64>, material: Handle, rim: Option<Handle>, tooth_thickness: Option<f64>,
        profile_shift: Option<f64>, tip_edge_radius: Option<f64>, modifications: Vec<Handle>,
        pitch_errors: Vec<f64>, helix_angle: f64, hand: String, normal_module: Option<f64>,
        normal_diametral_pitch: Option<f64>, transverse_module: Option<f64>,
        transverse_diametral_pitch: Option<f64>, module: Option<f64>, diametral_pitch: Option<f64>, tip_diameter: Option<f64>,
        tip_alteration: Option<f64>, bore: Option<f64>, rim_thickness: Option<f64>,
        normal_thickness: Option<f64>, transverse_thickness: Option<f64>, span: Option<f64>,
        span_teeth: Option<f64>, over_balls: Option<f64>, ball: Option<f64>, upper_allowance: Option<f64>,
        lower_allowance: Option<f64>, stated_at: String, thickness_limit: String, accuracy_grade: Option<f64>,
        accuracy_edition: String,
    ) -> Handle {
        let given = GearArguments {
            teeth,
            tip: TipStatements { diameter: ("outer_diameter", outer_diameter), tip_diameter, alteration: tip_alteration },
            root_diameter, face_width, material, rim,
            far: ("bore", bore),
            rim_thickness,
            modules: ModuleStatement::all(
                [module, normal_module, transverse_module],
                [diametral_pitch, normal_diametral_pitch, transverse_diametral_pitch],
            ),
            thickness: ThicknessStatements {
                profile_shift, tooth_thickness, normal_thickness, transverse_thickness, span, span_teeth,
                over_balls: ("over_balls", over_balls),
                ball,
                allowances: [upper_allowance, lower_allowance],
                stated_at: Limit::named(&stated_at),
                limit: Limit::named(&thickness_limit),
            },
            tip_edge_radius, modifications, pitch_errors, helix_angle, hand,
            accuracy: accuracy_grade.map(|grade| (grade, Edition::named(&accuracy_edition))),
        };
        let stated = *entry(&host(context)?.racks, rack)?;
        cut_gear(context, &stated, given, |_, modules, helix| {
            Ok((Tool::from(sized_rack(&stated, modules, helix)?), false))
        })
    }

    Pure fn calyx_gears_internal(
        context, teeth: f64, shaper: Option<Handle>, face_width: f64, minor_diameter: Option<f64>,
        root_diameter: Option<f64>, material: Handle, rim: Option<Handle>, tooth_thickness: Option<f64>,
        profile_shift: Option<f64>, tip_edge_radius: Option<f64>, modifications: Vec<Handle>,
        pitch_errors: Vec<f64>, helix_angle: f64, hand: String, rack: Handle, normal_module: Option<f64>,
        normal_diametral_pitch: Option<f64>, transverse_module: Option<f64>,
        transverse_diametral_pitch: Option<f64>, module: Option<f64>, diametral_pitch: Option<f64>, tip_diameter: Option<f64>,
        tip_alteration: Option<f64>, outer_diameter: Option<f64>, rim_thickness: Option<f64>,
        normal_thickness: Option<f64>, transverse_thickness: Option<f64>, span: Option<f64>,
        span_teeth: Option<f64>, between_balls: Option<f64>, ball: Option<f64>, upper_allowance: Option<f64>,
        lower_allowance: Option<f64>, stated_at: String, thickness_limit: String, accuracy_grade: Option<f64>,
        accuracy_edition: String,
    ) -> Handle {
        let given = GearArguments {
            teeth,
            tip: TipStatements { diameter: ("minor_diameter", minor_diameter), tip_diameter, alteration: tip_alteration },
            root_diameter, face_width, material, rim,
            far: ("outer_diameter", outer_diameter),
            rim_thickness,
            modules: ModuleStatement::all(
                [module, normal_module, transverse_module],
                [diametral_pitch, normal_diametral_pitch, transverse_diametral_pitch],
            ),
            thickness: ThicknessStatements {
                profile_shift, tooth_thickness, normal_thickness, transverse_thickness, span, span_teeth,
                over_balls: ("between_balls", between_balls),
                ball,
                allowances: [upper_allowance, lower_allowance],
                stated_at: Limit::named(&stated_at),
                limit: Limit::named(&thickness_limit),
            },
            tip_edge_radius, modifications, pitch_errors, helix_angle, hand,
            accuracy: accuracy_grade.map(|grade| (grade, Edition::named(&accuracy_edition))),
        };
        let host = host(context)?;
        let stated = *entry(&host.racks, rack)?;
        let shaper = shaper.map(|shaper| entry(&host.shapers, shaper).copied()).transpose()?;
        cut_gear(context, &stated, given, |teeth, modules, helix| {
            let sized = sized_shaper(shaper, &stated, modules, teeth, helix)?;
            Ok((Tool::from(sized), shaper.is_none()))
        })
    }
}

fn unknown_name(what: &str, name: &str, names: impl Iterator<Item = &'static str>) -> RuntimeError {
    let known: Vec<String> = names.map(|name| format!("\"{name}\"")).collect();
    let help = format!("choose one of {}", known.join(", "));
    refusal("E0314", "name", &format!("there is no {what} called \"{name}\""), &help)
}

/// Source location of a call.
type Place = (u32, u32, u32);

/// Module of a tool, given as the module or as the diametral pitch.
fn module_of(tool: &str, module: Option<f64>, diametral_pitch: Option<f64>) -> Result<f64, RuntimeError> {
    match (module, diametral_pitch) {
        (Some(module), None) => Ok(module),
        (None, Some(pitch)) => Ok(1.0 / pitch),
        (Some(_), Some(_)) => Err(refusal(
            "E0663",
            "diametral_pitch",
            &format!("the {tool} has both a module and a diametral pitch"),
            "give one of them: the diametral pitch is 1 divided by the module",
        )),
        (None, None) => Err(refusal(
            "E0664",
            "module",
            &format!("the {tool} has neither a module nor a diametral pitch"),
            "give its size, like `module = 2.5 mm` or `diametral_pitch = 10 / inch`",
        )),
    }
}

fn whole_teeth(teeth: f64) -> Result<u32, RuntimeError> {
    if teeth.fract() == 0.0 && (4.0..=1e6).contains(&teeth) {
        return Ok(teeth as u32);
    }
    Err(refusal(
        "E0667",
        "teeth",
        &format!("a gear cannot have {teeth} teeth"),
        "give a whole number of at least 4",
    ))
}

/// Checks that the orders of a series are integers.
pub(crate) fn whole_orders(names: [&'static str; 2], orders: [f64; 2]) -> Result<(), RuntimeError> {
    match names.into_iter().zip(orders).find(|(_, order)| order.fract() != 0.0) {
        None => Ok(()),
        Some((name, order)) => {
            Err(refusal("E0649", name, &format!("`{name}` cannot be {order}"), "give a whole number"))
        }
    }
}

/// Highest harmonic of the series of a raceway unless another one is given: twice the number of
/// rollers of common bearings.
const RACEWAY_HARMONICS: u16 = 40;
/// Degree of the polynomials along a raceway unless another one is given.
const RACEWAY_DEGREE: f64 = 2.0;
/// Highest degree in a model. Error estimates have higher ones.
const MOST_RACEWAY_DEGREE: f64 = 3.0;

/// Support of a rim. The circumferential and axial orders are those of the constraint in addition
/// to the rigid-body motion.
pub(crate) fn bore_support(
    kind: &str,
    names: [&'static str; 2],
    orders: [f64; 2],
) -> Result<BoreSupport, RuntimeError> {
    whole_orders(names, orders)?;
    let [harmonics, degree] = orders;
    match (kind, harmonics) {
        ("free", 0.0) => Ok(BoreSupport::Means { harmonics: None, degree: degree as u8 }),
        ("free", harmonics) => {
            Ok(BoreSupport::Means { harmonics: Some(harmonics as u16), degree: degree as u8 })
        }
        ("raceway", harmonics) => {
            if degree > MOST_RACEWAY_DEGREE {
                let message = format!("`{}` of a raceway is at most {MOST_RACEWAY_DEGREE}", names[1]);
                return Err(refusal(
                    "E0649",
                    names[1],
                    &message,
                    "2 resolves the bending of a raceway along its axis",
                ));
            }
            let harmonics = if harmonics == 0.0 { RACEWAY_HARMONICS } else { harmonics as u16 };
            Ok(BoreSupport::Raceway { harmonics, degree: degree as u8 })
        }
        (_, 0.0) => Ok(BoreSupport::Rigid),
        _ => Err(refusal(
            "E0649",
            names[0],
            &format!("`{}` is of a free bore or a raceway, and this one is rigid", names[0]),
            "leave it out, or choose \"free\" or \"raceway\"",
        )),
    }
}

fn helix(host: &mut ModelHost, angle: f64, hand: &str, place: Place) -> Result<Helix, RuntimeError> {
    let hand = Hand::named(hand).unwrap_or(Hand::Right);
    Helix::new(angle, hand).map_err(|error| host.runtime_error(&error, place))
}

fn modifications_of(host: &ModelHost, handles: Vec<Handle>) -> Result<Vec<Modification>, RuntimeError> {
    handles.into_iter().map(|handle| entry(&host.modifications, handle).cloned()).collect()
}

/// Arguments that `external` and `internal` have in common.
struct GearArguments {
    teeth: f64,
    tip: TipStatements,
    root_diameter: Option<f64>,
    face_width: f64,
    material: Handle,
    rim: Option<Handle>,
    /// Diameter of the bore, or outer diameter of an internal gear, with its argument.
    far: (&'static str, Option<f64>),
    rim_thickness: Option<f64>,
    modules: Vec<ModuleStatement>,
    thickness: ThicknessStatements,
    tip_edge_radius: Option<f64>,
    modifications: Vec<Handle>,
    pitch_errors: Vec<f64>,
    helix_angle: f64,
    hand: String,
    /// Accuracy grade with the edition of ISO 1328-1.
    accuracy: Option<(f64, Edition)>,
}

/// Generates a gear. `tool` returns its tool, and `true` if profile shift coefficients count normal
/// modules although the tool is given in the transverse plane.
fn cut_gear(
    context: &mut Context,
    rack: &StatedRack,
    mut given: GearArguments,
    tool: impl FnOnce(u32, &[ModuleStatement], &Helix) -> Result<(Tool, bool), GeometryError>,
) -> Result<Handle, RuntimeError> {
    let teeth = whole_teeth(given.teeth)?;
    let (place, host) = (context.place, host(context)?);
    let helix = helix(host, given.helix_angle, &given.hand, place)?;
    let report = |host: &mut ModelHost, error: GeometryError| host.runtime_error(&error, place);
    let (tool, normal) = tool(teeth, &given.modules, &helix).map_err(|error| report(host, error))?;
    let proportions = Proportions::of(&tool, rack, teeth, &helix, normal);
    // Ratio of the module of the tool to the module that shift coefficients count.
    let per_module = if normal && !helix.is_spur() { math::cos(helix.angle()) } else { 1.0 };
    let stated_shift = given.thickness.profile_shift;
    given.thickness.profile_shift = stated_shift.map(|shift| shift * per_module);
    let derived_root = given.root_diameter.is_none().then_some(proportions.dedendum);
    let found = given.thickness.resolve(&tool, teeth, &helix, derived_root);
    let found = found.map_err(|error| report(host, error))?;
    let [shift, generated] = [found.shift, found.generated_shift].map(|shift| shift / per_module);
    let tip_diameter = given.tip.resolve(&proportions, shift).map_err(|error| report(host, error))?;
    let derived = [proportions.tip_diameter(shift, 0.0), proportions.root_diameter(generated)];
    let (wrong_side, exchanged) = match check_sides(&given.tip, given.root_diameter, &proportions, derived) {
        Ok(warning) => (warning, None),
        Err(error) => (None, Some(error)),
    };
    let slip = exchanged.clone().or(module_slip(&given.modules, given.face_width, tool.module()));
    let nominal = tool.thickness_of_shift(found.shift);
    given
        .thickness
        .check_ball(&tool, (teeth, nominal), &helix, tip_diameter)
        .map_err(|error| report(host, error))?;
    let root_diameter = given.root_diameter.unwrap_or_else(|| proportions.root_diameter(generated));
    let rim = given.rim.map(|rim| entry(&host.rims, rim).cloned()).transpose()?;
    let blank = BlankStatements { rim, far: given.far, rim_thickness: given.rim_thickness };
    let far = blank.stated();
    let (rim, solid) =
        blank.resolve(&proportions, root_diameter).map_err(|error| report(host, slip.unwrap_or(error)))?;
    host.note(&found.warnings, place);
    let material_name = host.material_names.get(&given.material.0).copied();
    let blank = GearBlank {
        teeth,
        tool,
        tip_diameter,
        root_diameter,
        face_width: given.face_width,
        helix,
        material: *entry(&host.materials, given.material)?,
        rim,
        solid,
        thickness: found.thickness,
        tip_edge_radius: given.tip_edge_radius,
        modifications: modifications_of(host, given.modifications)?,
        pitch_errors: given.pitch_errors,
    };
    let stated = [
        (given.tip.diameter.0, given.tip.stated().or(given.thickness.stated())),
        ("root_diameter", given.root_diameter.map(|_| "root_diameter").or(given.thickness.stated())),
        ("tip_edge_radius", given.tip_edge_radius.map(|_| "tip_edge_radius").or(given.thickness.stated())),
        ("tooth_thickness", given.thickness.stated()),
        ("rim", far),
    ];
    let cut = match exchanged {
        Some(error) => Err(Refusal::Geometry(vec![error])),
        None => blank.cut().map_err(|refusal| blamed(refusal, &stated)),
    };
    let stated_shift = stated_shift.filter(|_| given.thickness.stated() == Some("profile_shift"));
    let geometry = StatedGeometry::of(&Resolved {
        tool: &tool,
        rack,
        helix: &helix,
        proportions: &proportions,
        modules: &given.modules,
        normal,
        shift: stated_shift.unwrap_or(shift),
        tip: (tip_diameter, given.tip.states_diameter()),
        tip_alteration: given.tip.alteration,
        root: (root_diameter, given.root_diameter.is_some()),
    });
    let sizes = [proportions.reference_diameter, geometry.normal_module, given.face_width];
    let tolerances = tolerances_of(given.accuracy, sizes).map_err(|error| report(host, error))?;
    // A stated shaper cutter replaces the rack.
    let by_rack = normal || matches!(tool, Tool::Rack(_));
    let drawing = StatedData {
        rack: if by_rack { rack.name } else { Some("shaper cutter") },
        heights: by_rack.then_some([rack.addendum, rack.dedendum]),
        material: material_name,
        allowance: found.allowance,
        tolerances,
        geometry,
        ..given.thickness.drawing()
    };
    if cut.is_ok() {
        host.note(wrong_side.as_slice(), place);
    }
    let cut = cut.map(|gear| described(gear, drawing));
    keep_gear(host, cut, (tool.module(), stated_module(&given.modules), far), place)
}

/// Returns a new gear with the data of its drawing.
fn described(mut gear: Arc<GearPrototype>, drawing: StatedData) -> Arc<GearPrototype> {
    // Nothing else refers to the gear yet.
    if let Some(gear) = Arc::get_mut(&mut gear) {
        gear.stated = drawing;
    }
    gear
}

/// Assigns errors of the tooth form to the arguments that state the data in question.
fn blamed(refusal: Refusal, stated: &[(&'static str, Option<&'static str>)]) -> Refusal {
    let blame = |error: GeometryError| {
        let other = stated.iter().find(|(argument, _)| *argument == error.argument);
        GeometryError { argument: other.and_then(|(_, stated)| *stated).unwrap_or(error.argument), ..error }
    };
    match refusal {
        Refusal::Geometry(errors) => Refusal::Geometry(errors.into_iter().map(blame).collect()),
        other => other,
    }
}

/// Tolerances of an accuracy grade for the reference diameter, normal module and face width, m.
fn tolerances_of(
    accuracy: Option<(f64, Edition)>,
    sizes: [f64; 3],
) -> Result<Option<FlankTolerances>, GeometryError> {
    accuracy.map(|(grade, edition)| FlankTolerances::new(edition, grade, sizes)).transpose()
}

/// Returns the diametral pitch that states the size of the teeth, 1/m, with its argument.
fn pitch_of(statements: &[ModuleStatement]) -> Option<(&'static str, f64)> {
    let pitch = statements.iter().find(|statement| statement.argument.ends_with("diametral_pitch"))?;
    Some((pitch.argument, 1.0 / pitch.module))
}

/// Returns the statement of the size of the teeth: a diametral pitch, else a module.
fn stated_module(statements: &[ModuleStatement]) -> Option<StatedModule> {
    let pitch = pitch_of(statements).map(|(argument, pitch)| StatedModule::Pitch(argument, pitch));
    pitch.or_else(|| statements.first().map(|stated| StatedModule::Module(stated.argument, stated.module)))
}

/// Returns the error for a module in a wrong unit, which makes all diameters of the gear wrong.
fn module_slip(statements: &[ModuleStatement], face_width: f64, module: f64) -> Option<GeometryError> {
    let pitch = pitch_of(statements).and_then(|pitch| metric_pitch(face_width, module, pitch));
    let stated = statements.iter().find(|statement| !statement.argument.ends_with("diametral_pitch"));
    let slip =
        pitch.or_else(|| tiny_module(face_width, stated.map(|stated| (stated.argument, stated.module))?))?;
    Some(GeometryError { severity: Severity::Error, ..slip })
}

fn keep_gear(
    host: &mut ModelHost,
    cut: Result<Arc<GearPrototype>, Refusal>,
    (module, stated, far): (f64, Option<StatedModule>, Option<&'static str>),
    place: Place,
) -> Result<Handle, RuntimeError> {
    let gear = cut.map_err(|refusal| host.rejected(refusal, place))?;
    host.note(gear.gear.warnings(), place);
    let (wrong, unusual): (Vec<_>, Vec<_>) =
        of_gear(&gear, module, stated, far).into_iter().partition(|found| found.severity == Severity::Error);
    host.note(&unusual, place);
    if !wrong.is_empty() {
        return Err(host.rejected(wrong.into(), place));
    }
    host.gear_places.push(place);
    Ok(keep(&mut host.gears, GearModel::Cylindrical(gear)))
}
