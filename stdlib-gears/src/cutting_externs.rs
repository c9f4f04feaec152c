//! Tools, rims and gears for programs: the Rust side of `rack`, `shaper`, `external` and `internal`
//! of `gears.cx`. Those of rims on webs are in [`crate::web`].

use crate::blank::{GearBlank, RadialFit, Rim, SplineSupport, Tool};
use crate::error::{Refusal, Severity};
use crate::externs::{entry, host, refusal};
use crate::helix::{Hand, Helix};
use crate::host::{ModelHost, keep};
use crate::modification::Modification;
use crate::plausibility::{of_gear, thickness};
use crate::prototype::GearPrototype;
use crate::rack::{Plane, Rack};
use crate::shaper::Shaper;
use calyx_abi::externs::Handle;
use calyx_abi::{Context, RuntimeError};
use calyx_runtime::structure::BoreSupport;
use std::sync::Arc;

calyx_abi::externs! {
    Pure fn calyx_gears_rack(
        context, module: Option<f64>, diametral_pitch: Option<f64>, pressure_angle: f64, tip_radius: f64,
        plane: Option<String>,
    ) -> Handle {
        let module = module_of("rack", module, diametral_pitch)?;
        let (place, host) = (context.place, host(context)?);
        let rack = Rack::new(module, pressure_angle, tip_radius).map_err(|error| host.runtime_error(&error, place))?;
        let plane = plane.map_or(Plane::Unstated, |plane| Plane::named(&plane).unwrap_or_default());
        Ok(keep(&mut host.racks, rack.in_plane(plane)))
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
        context, diameter: f64, inner_diameter: f64, bore: String, bore_harmonics: f64, bore_axial_degree: f64,
    ) -> Handle {
        let support = bore_support(&bore, ["bore_harmonics", "bore_axial_degree"], [bore_harmonics, bore_axial_degree])?;
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
        context, teeth: f64, rack: Handle, face_width: f64, outer_diameter: f64, root_diameter: f64,
        material: Handle, rim: Handle, tooth_thickness: Option<f64>, profile_shift: f64,
        tip_edge_radius: Option<f64>, modifications: Vec<Handle>, pitch_errors: Vec<f64>, helix_angle: f64,
        hand: String,
    ) -> Handle {
        let given = GearArguments {
            teeth, diameters: [outer_diameter, root_diameter], face_width, material, rim, tooth_thickness,
            profile_shift, tip_edge_radius, modifications, pitch_errors, helix_angle, hand,
        };
        cut_gear(context, |host| Ok(Tool::from(*entry(&host.racks, rack)?)), given)
    }

    Pure fn calyx_gears_internal(
        context, teeth: f64, shaper: Handle, face_width: f64, minor_diameter: f64, root_diameter: f64,
        material: Handle, rim: Handle, tooth_thickness: Option<f64>, profile_shift: f64,
        tip_edge_radius: Option<f64>, modifications: Vec<Handle>, pitch_errors: Vec<f64>, helix_angle: f64,
        hand: String,
    ) -> Handle {
        let given = GearArguments {
            teeth, diameters: [minor_diameter, root_diameter], face_width, material, rim, tooth_thickness,
            profile_shift, tip_edge_radius, modifications, pitch_errors, helix_angle, hand,
        };
        cut_gear(context, |host| Ok(Tool::from(*entry(&host.shapers, shaper)?)), given)
    }
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
        (_, 0.0) => Ok(BoreSupport::Rigid),
        _ => Err(refusal(
            "E0649",
            names[0],
            &format!("`{}` is of a free bore, and this one is rigid", names[0]),
            "leave it out, or choose \"free\"",
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
    /// Tip and root diameter.
    diameters: [f64; 2],
    face_width: f64,
    material: Handle,
    rim: Handle,
    tooth_thickness: Option<f64>,
    profile_shift: f64,
    tip_edge_radius: Option<f64>,
    modifications: Vec<Handle>,
    pitch_errors: Vec<f64>,
    helix_angle: f64,
    hand: String,
}

fn cut_gear(
    context: &mut Context,
    tool: impl FnOnce(&ModelHost) -> Result<Tool, RuntimeError>,
    given: GearArguments,
) -> Result<Handle, RuntimeError> {
    let teeth = whole_teeth(given.teeth)?;
    let (place, host) = (context.place, host(context)?);
    let tool = tool(host)?;
    let of_shift = |shift: f64| tool.thickness_of_shift(shift);
    let thickness = thickness(given.tooth_thickness, given.profile_shift, tool.module(), of_shift)
        .map_err(|error| host.runtime_error(&error, place))?;
    let [tip_diameter, root_diameter] = given.diameters;
    let blank = GearBlank {
        teeth,
        tool,
        tip_diameter,
        root_diameter,
        face_width: given.face_width,
        helix: helix(host, given.helix_angle, &given.hand, place)?,
        material: *entry(&host.materials, given.material)?,
        rim: entry(&host.rims, given.rim)?.clone(),
        thickness,
        tip_edge_radius: given.tip_edge_radius,
        modifications: modifications_of(host, given.modifications)?,
        pitch_errors: given.pitch_errors,
    };
    keep_gear(host, blank.cut(), tool.module(), place)
}

fn keep_gear(
    host: &mut ModelHost,
    cut: Result<Arc<GearPrototype>, Refusal>,
    module: f64,
    place: Place,
) -> Result<Handle, RuntimeError> {
    let gear = cut.map_err(|refusal| host.rejected(refusal, place))?;
    host.note(gear.gear.warnings(), place);
    let (wrong, unusual): (Vec<_>, Vec<_>) =
        of_gear(&gear, module).into_iter().partition(|found| found.severity == Severity::Error);
    host.note(&unusual, place);
    if !wrong.is_empty() {
        return Err(host.rejected(wrong.into(), place));
    }
    host.gear_places.push(place);
    Ok(keep(&mut host.gears, gear))
}
