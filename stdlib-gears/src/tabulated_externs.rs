//! Gears with tabulated teeth for programs: the Rust side of `tabulated_gear` in `gears.cx`.

use crate::cutting_externs::bore_support;
use crate::error::{GeometryError, sentence};
use crate::externs::{entry, host, refusal};
use crate::host::{GearModel, keep};
use crate::tabulated::known_gears::gear_of;
use crate::tabulated::prototype::{BoreShape, TabulatedGearData};
use crate::tabulated::table::{PointGrid, ToothTable};
use calyx_abi::RuntimeError;
use calyx_abi::externs::Handle;

calyx_abi::externs! {
    Pure fn calyx_gears_tabulated_gear(
        context, teeth: f64, pitch_angle: f64, flanks: Vec<PointGrid>, fillets: Vec<PointGrid>, material: Handle,
        rim_thickness: Option<f64>, bore_angle: Option<f64>, bore_diameter: Option<f64>, bore: String,
        bore_harmonics: f64, bore_axial_degree: f64, tip_edge_radius: Option<f64>, pitch_errors: Vec<f64>,
    ) -> Handle {
        if teeth.fract() != 0.0 {
            return Err(refusal("E0970", "teeth", &format!("a gear cannot have {teeth} teeth"), "give a whole number"));
        }
        let [flanks, fillets] = [pair("flanks", flanks)?, pair("fillets", fillets)?];
        let support = bore_support(&bore, ["bore_harmonics", "bore_axial_degree"], [bore_harmonics, bore_axial_degree])?;
        let (place, host) = (context.place, host(context)?);
        let bore = bore_shape(rim_thickness, bore_angle, bore_diameter)
            .map_err(|error| host.rejected(error.into(), place))?;
        let data = TabulatedGearData {
            table: ToothTable { teeth: teeth as u32, pitch_angle, flanks, fillets },
            tip_edge_radius,
            material: *entry(&host.materials, material)?,
            bore,
            support,
            pitch_errors,
        };
        let gear = gear_of(data).map_err(|refusal| host.rejected(refusal, place))?;
        host.gear_places.push(place);
        Ok(keep(&mut host.gears, GearModel::Tabulated(gear)))
    }
}

/// Two tables of an argument: counter-clockwise and clockwise.
fn pair(argument: &str, tables: Vec<PointGrid>) -> Result<[PointGrid; 2], RuntimeError> {
    <[PointGrid; 2]>::try_from(tables).map_err(|tables| {
        refusal(
            "E0970",
            argument,
            &format!("`{argument}` has {} tables, and a tooth has two sides", tables.len()),
            "give the table of the counter-clockwise side, then that of the clockwise side",
        )
    })
}

fn bore_shape(
    thickness: Option<f64>,
    angle: Option<f64>,
    diameter: Option<f64>,
) -> Result<BoreShape, GeometryError> {
    let Some(diameter) = diameter else { return Ok(BoreShape::Rim { thickness, angle }) };
    let other = thickness.map(|_| "rim_thickness").or(angle.map(|_| "bore_angle"));
    match other {
        None => Ok(BoreShape::Cylinder(diameter)),
        Some(other) => Err(GeometryError::error(
            "E0973",
            other,
            sentence!["`bore_diameter` makes the bore a cylinder, which has no `", text other, "`"],
            sentence!["omit one of them"],
        )),
    }
}
