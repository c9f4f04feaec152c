//! Flexible planet carriers for programs: the Rust side of `carrier` in `gears.cx`.

use crate::carriers::ModelCarrier;
use crate::externs::{self, entry, host, refusal};
use calyx_abi::externs::Handle;
use calyx_runtime::cache::Key;
use calyx_runtime::connection::ElasticConnection;
use calyx_runtime::elastic;
use calyx_runtime::elastic::attachment::{Attachment, Connection, Region};
use calyx_runtime::elastic::carrier::{CarrierModel, CarrierShape, HUB, Webs};
use calyx_runtime::elastic_body::FiniteElementBody;
use calyx_runtime::error::EngineError;
use calyx_runtime::material::Material;
use calyx_runtime::scene::BodyId;
use std::sync::Arc;

/// Default number of elements along the outside diameter of a carrier.
const ACROSS: f64 = 14.0;

calyx_abi::externs! {
    /// Joins the bodies of hub and pins by the elastic carrier; without pins it checks the
    /// dimensions only.
    Scene fn calyx_gears_carrier_body(
        context, name: String, hub: Handle, pins: Vec<Handle>, planets: f64, material: Handle,
        pin_circle_diameter: f64, pin_diameter: f64, pin_bore: f64, outside_diameter: f64,
        bore_diameter: f64, thickness: f64, second_thickness: Option<f64>, gap: f64,
        web_inside_diameter: Option<f64>, web_outside_diameter: Option<f64>, web_angle: Option<f64>,
        hub_side: String, element_size: Option<f64>,
    ) -> () {
        externs::before_analysis(context, format_args!("the carrier \"{name}\""))?;
        if planets.fract() != 0.0 {
            let message = format!("a carrier cannot have {planets} planets");
            return Err(refusal("E0995", "planets", &message, "give a whole number of at least two"));
        }
        let shape = CarrierShape {
            planets: planets as usize,
            pin_circle_diameter,
            pin_diameter,
            pin_bore,
            outside_diameter,
            bore_diameter,
            thickness: std::iter::once(thickness).chain(second_thickness).collect(),
            gap,
            hub_at_negative_z: hub_side == "-z",
            webs: match (web_angle, second_thickness) {
                (Some(angle), _) => Some(Webs {
                    inside_diameter: web_inside_diameter.unwrap_or(pin_circle_diameter - pin_diameter),
                    outside_diameter: web_outside_diameter.unwrap_or(outside_diameter),
                    angle,
                }),
                (None, _) => None,
            },
            element_size: element_size.unwrap_or(outside_diameter / ACROSS),
        };
        shape.check().map_err(|(argument, error)| refusal("E0995", argument, &error.message, &error.help))?;
        let material = *entry(&host(context)?.materials, material)?;
        let hub = externs::body(context, "hub", hub)?;
        let pins = pins.into_iter().map(|pin| externs::body(context, "pins", pin)).collect::<Result<Vec<_>, _>>()?;
        let name = context.name_in_instance(name);
        let carrier = ModelCarrier { name: name.clone(), shape: shape.clone(), hub, pins: pins.clone() };
        host(context)?.carriers.push(carrier);
        if pins.is_empty() {
            return Ok(());
        }
        let body = flexible(&shape, &material).map_err(externs::engine)?;
        let attached: Vec<BodyId> = std::iter::once(hub).chain(pins).collect();
        let connection = ElasticConnection::of_body(name, Arc::new(body), &attached, [0.0; 3]);
        host(context)?.scene.add_connection(connection).map_err(externs::engine)?;
        Ok(())
    }
}

/// Returns the finite-element body of a carrier with its hub and its pins as attachments.
fn flexible(shape: &CarrierShape, material: &Material) -> Result<FiniteElementBody, EngineError> {
    let Material { youngs_modulus, poissons_ratio, density } = *material;
    let steel = elastic::Material {
        youngs_modulus,
        poissons_ratio,
        shear_modulus: 0.5 * youngs_modulus / (1.0 + poissons_ratio),
        density,
        structural_damping: 0.0,
    };
    let CarrierModel { model, pins } = shape.model(&steel);
    let labels: Vec<u64> = pins.iter().map(|&pin| model.nodes[pin].label).collect();
    let mut body = FiniteElementBody::new(Arc::new(model), content(shape, material));
    body.attach(&Attachment {
        name: HUB.into(),
        position: Some([0.0; 3]),
        region: Region::Set(HUB.into()),
        connection: Connection::Rigid,
    })?;
    for (planet, label) in labels.into_iter().enumerate() {
        body.attach(&Attachment {
            name: format!("pin {}", planet + 1),
            position: None,
            region: Region::Labels(vec![label]),
            connection: Connection::Rigid,
        })?;
    }
    Ok(body)
}

/// Returns the key of a generated model: its dimensions and material.
fn content(shape: &CarrierShape, material: &Material) -> Key {
    let webs = shape
        .webs
        .map_or_else(Vec::new, |webs| vec![webs.inside_diameter, webs.outside_diameter, webs.angle]);
    Key::of("planet carrier")
        .count(shape.planets as u64)
        .numbers(&[shape.pin_circle_diameter, shape.pin_diameter, shape.pin_bore])
        .numbers(&[shape.outside_diameter, shape.bore_diameter, shape.gap, shape.element_size])
        .count(shape.thickness.len() as u64)
        .numbers(&shape.thickness)
        .flag(shape.hub_at_negative_z)
        .count(webs.len() as u64)
        .numbers(&webs)
        .numbers(&[material.youngs_modulus, material.poissons_ratio, material.density])
        .finish()
}
