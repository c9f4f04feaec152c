//! Lubrication of meshes for programs: the Rust side of `lubrication` and of the observables of
//! friction, temperature and film thickness of `gears.cx`.

use crate::error::{GeometryError, sentence};
use crate::externs::{entry, host, refusal};
use crate::host::{ModelHost, keep};
use crate::observable_externs::{coefficient_of_friction, observe, pair, pair_number};
use calyx_abi::externs::Handle;
use calyx_abi::{Context, RuntimeError};
use calyx_runtime::lubrication::{BaseOil, Lubrication, Oil};
use calyx_runtime::material::Material;
use calyx_runtime::observables::{
    Efficiency, EntrainmentVelocity, FrictionLoss, LocalQuantity, LubricatedEfficiency, LubricatedExtreme,
    LubricatedLoss,
};
use calyx_runtime::scene::BodyId;

/// Thermal conductivity (W/(m K)) and specific heat (J/(kg K)) of steel (ISO/TS 6336-20).
const STEEL: [f64; 2] = [50.0, 485.0];
/// Young's modulus below which a material is no metal, Pa.
const METAL: f64 = 40e9;

/// Viscosity grades of ISO 3448 with the kinematic viscosities at 40 and 100 degrees Celsius,
/// mm²/s. Those at 100 degrees are typical of mineral gear oils of viscosity index 95.
const GRADES: [(&str, [f64; 2]); 9] = [
    ("ISO VG 32", [32.0, 5.4]),
    ("ISO VG 46", [46.0, 6.8]),
    ("ISO VG 68", [68.0, 8.7]),
    ("ISO VG 100", [100.0, 11.2]),
    ("ISO VG 150", [150.0, 14.7]),
    ("ISO VG 220", [220.0, 19.0]),
    ("ISO VG 320", [320.0, 24.1]),
    ("ISO VG 460", [460.0, 30.6]),
    ("ISO VG 680", [680.0, 39.2]),
];

/// Lubrication as a program states it, before the materials of the gears are known.
#[derive(Clone, Debug, PartialEq)]
pub struct StatedLubrication {
    lubrication: Lubrication,
    /// Thermal conductivities, W/(m K), and specific heats, J/(kg K), of both gears; `None` for
    /// those of steel.
    thermal: Option<[[f64; 2]; 2]>,
}

impl StatedLubrication {
    /// Returns the lubrication of gears of these materials, and a warning if the thermal data of
    /// steel apply to another material.
    ///
    /// # Errors
    /// E0931: a material has no density.
    fn of(&self, materials: [Material; 2]) -> Result<(Lubrication, Option<GeometryError>), RuntimeError> {
        if materials.iter().any(|material| material.density <= 0.0) {
            let message = "the flash temperature requires the densities of both materials";
            let help = "give `density` in `gears.material`; steel has 7850 kg/m^3";
            return Err(refusal("E0931", "lubrication", message, help));
        }
        let [conductivities, heats] = self.thermal.unwrap_or([[STEEL[0]; 2], [STEEL[1]; 2]]);
        let coefficient = |side: usize| (conductivities[side] * materials[side].density * heats[side]).sqrt();
        let lubrication = Lubrication { thermal_contact: [0, 1].map(coefficient), ..self.lubrication };
        let softest =
            materials.map(|material| material.youngs_modulus).into_iter().fold(f64::INFINITY, f64::min);
        let warning = (self.thermal.is_none() && softest < METAL).then(|| {
            GeometryError::warning(
                "W0844",
                "lubrication",
                sentence![
                    "the thermal data of steel are used for a gear with a Young's modulus of ",
                    number 1e-9 * softest,
                    " GPa"
                ],
                sentence![
                    "give `conductivities` and `specific_heats` of both gears in `gears.lubrication`; plastics have about 0.3 W/(m*K) and 1500 J/(kg*K)"
                ],
            )
        });
        Ok((lubrication, warning))
    }
}

/// Returns the lubrication of a mesh of two bodies with gears, as stated, and notes warnings.
pub(crate) fn of_mesh(
    host: &mut ModelHost,
    lubrication: Option<Handle>,
    bodies: [BodyId; 2],
    place: (u32, u32, u32),
) -> Result<Option<Lubrication>, RuntimeError> {
    let Some(handle) = lubrication else { return Ok(None) };
    let stated = entry(&host.lubrications, handle)?.clone();
    let materials = [
        host.gear_model_on("first", bodies[0])?.material(),
        host.gear_model_on("second", bodies[1])?.material(),
    ];
    let (lubrication, warning) = stated.of(materials)?;
    host.note(warning.as_slice(), place);
    Ok(Some(lubrication))
}

calyx_abi::externs! {
    Pure fn calyx_gears_lubrication(
        context, oil: Option<String>, temperature: f64, roughness: f64, bulk_temperature: Option<f64>,
        friction: Option<f64>, nu_40: Option<f64>, nu_100: Option<f64>, base: String, density: f64,
        conductivities: Vec<f64>, specific_heats: Vec<f64>,
    ) -> Handle {
        let oil = Oil {
            viscosities: viscosities(oil.as_deref(), nu_40, nu_100)?,
            density,
            base: match base.as_str() {
                "PAO" => BaseOil::Polyalphaolefin,
                "PAG" => BaseOil::Polyglycol,
                _ => BaseOil::Mineral,
            },
        };
        let lubrication = Lubrication {
            oil,
            oil_temperature: temperature,
            bulk_temperature: bulk_temperature.unwrap_or(temperature),
            roughness,
            friction: friction.map(coefficient_of_friction).transpose()?,
            thermal_contact: [0.0; 2],
        };
        let pairs: [Option<[f64; 2]>; 2] = [both(&conductivities), both(&specific_heats)];
        let thermal = match (pairs, conductivities.is_empty() && specific_heats.is_empty()) {
            (_, true) => None,
            ([Some(conductivities), Some(heats)], _) => Some([conductivities, heats]),
            _ => return Err(refusal("E0931", "conductivities",
                &format!("thermal data need two conductivities and two specific heats, not {} and {}",
                    conductivities.len(), specific_heats.len()),
                "give both lists for the first and the second gear, such as `conductivities = [50 W/(m*K), 0.3 W/(m*K)]`")),
        };
        Ok(keep(&mut host(context)?.lubrications, StatedLubrication { lubrication, thermal }))
    }

    Scene fn calyx_gears_entrainment_velocity(context, mesh: Handle, pair: f64) -> Handle {
        let pair = pair_number(pair)?;
        observe(context, EntrainmentVelocity(self::pair(mesh), pair))
    }

    Scene fn calyx_gears_friction_loss(context, mesh: Handle, coefficient: Option<f64>) -> Handle {
        match coefficient {
            Some(coefficient) => observe(context, FrictionLoss(pair(mesh), coefficient_of_friction(coefficient)?)),
            None => {
                lubricated(context, mesh, Some("coefficient"))?;
                observe(context, LubricatedLoss(pair(mesh)))
            }
        }
    }

    Scene fn calyx_gears_efficiency(context, mesh: Handle, coefficient: Option<f64>) -> Handle {
        match coefficient {
            Some(coefficient) => observe(context, Efficiency(pair(mesh), coefficient_of_friction(coefficient)?)),
            None => {
                lubricated(context, mesh, Some("coefficient"))?;
                observe(context, LubricatedEfficiency(pair(mesh)))
            }
        }
    }

    Scene fn calyx_gears_max_friction_power_per_length(context, mesh: Handle) -> Handle {
        local(context, mesh, LocalQuantity::FrictionPower)
    }

    Scene fn calyx_gears_max_flash_temperature(context, mesh: Handle) -> Handle {
        local(context, mesh, LocalQuantity::FlashTemperature)
    }

    Scene fn calyx_gears_max_contact_temperature(context, mesh: Handle) -> Handle {
        local(context, mesh, LocalQuantity::ContactTemperature)
    }

    Scene fn calyx_gears_min_film_thickness(context, mesh: Handle) -> Handle {
        local(context, mesh, LocalQuantity::FilmThickness)
    }

    Scene fn calyx_gears_min_specific_film_thickness(context, mesh: Handle) -> Handle {
        local(context, mesh, LocalQuantity::SpecificFilmThickness)
    }
}

/// Adds the extreme of a local quantity of a lubricated mesh.
fn local(context: &mut Context, mesh: Handle, quantity: LocalQuantity) -> Result<Handle, RuntimeError> {
    lubricated(context, mesh, None)?;
    observe(context, LubricatedExtreme { pair: pair(mesh), quantity })
}

/// Checks that a mesh has lubrication. `instead` is the argument that could replace it.
fn lubricated(context: &mut Context, mesh: Handle, instead: Option<&str>) -> Result<(), RuntimeError> {
    if entry(&host(context)?.scene.pairs, mesh)?.lubrication.is_some() {
        return Ok(());
    }
    let lubrication = "`lubrication = gears.lubrication(\"ISO VG 220\", temperature = 80, roughness = 0.6 um)` to `gears.mesh`";
    let help = match instead {
        Some(argument) => format!("give `{argument}`, such as 0.05, or {lubrication}"),
        None => format!("give {lubrication}"),
    };
    Err(refusal("E0932", "mesh", "the mesh has no lubrication", &help))
}

/// Returns the two values of a list, by gear.
fn both(values: &[f64]) -> Option<[f64; 2]> {
    <[f64; 2]>::try_from(values).ok()
}

/// Returns the kinematic viscosities at 40 and 100 degrees Celsius, m²/s.
fn viscosities(oil: Option<&str>, nu_40: Option<f64>, nu_100: Option<f64>) -> Result<[f64; 2], RuntimeError> {
    let refuse = |argument: &str, message: &str, help: &str| Err(refusal("E0931", argument, message, help));
    let found = match (oil, nu_40, nu_100) {
        (None, Some(at_40), Some(at_100)) => [at_40, at_100],
        (Some(name), None, at_100) => {
            let grade = GRADES.into_iter().find(|(known, _)| *known == name);
            let Some((_, [at_40, usual])) = grade else {
                return refuse(
                    "oil",
                    &format!("there is no viscosity grade \"{name}\""),
                    "give `nu_40` and `nu_100`",
                );
            };
            [1e-6 * at_40, at_100.unwrap_or(1e-6 * usual)]
        }
        (Some(_), Some(_), _) => {
            let message = "the oil has both a viscosity grade and a viscosity at 40 degrees";
            return refuse(
                "nu_40",
                message,
                "give one of them: an ISO VG grade is the viscosity at 40 degrees in mm^2/s",
            );
        }
        (None, ..) => {
            let message = "the oil has no viscosity";
            return refuse(
                "oil",
                message,
                "give a grade, such as \"ISO VG 220\", or both `nu_40` and `nu_100`",
            );
        }
    };
    match found[0] > found[1] {
        true => Ok(found),
        false => {
            let [at_40, at_100] = found.map(|viscosity| 1e6 * viscosity);
            let message =
                format!("an oil of {at_40} mm^2/s at 40 degrees cannot have {at_100} mm^2/s at 100 degrees");
            refuse(
                "nu_100",
                &message,
                "give a smaller viscosity at 100 degrees; ISO VG 220 has about 19 mm^2/s",
            )
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::Severity;

    const STATED: StatedLubrication = StatedLubrication {
        lubrication: Lubrication {
            oil: Oil { viscosities: [220e-6, 19e-6], density: 890.0, base: BaseOil::Mineral },
            oil_temperature: 70.0,
            bulk_temperature: 90.0,
            roughness: 1e-6,
            friction: None,
            thermal_contact: [0.0; 2],
        },
        thermal: None,
    };

    #[test]
    fn steel_has_the_thermal_contact_coefficient_of_the_standard() {
        let (lubrication, warning) = STATED.of([Material::STEEL; 2]).unwrap();
        // ISO/TS 6336-20 gives 13.8 N/(mm s^0.5 K).
        assert!(lubrication.thermal_contact.iter().all(|found| (found / 13.8e3 - 1.0).abs() < 2e-3));
        assert_eq!(warning, None);
    }

    #[test]
    fn plastics_need_thermal_data() {
        let plastic = Material { youngs_modulus: 2.9e9, ..Material::STEEL };
        let (_, warning) = STATED.of([Material::STEEL, plastic]).unwrap();
        assert!(warning.is_some_and(|warning| warning.severity == Severity::Warning));
        let known = StatedLubrication { thermal: Some([[50.0, 0.3], [485.0, 1500.0]]), ..STATED };
        assert_eq!(known.of([Material::STEEL, plastic]).unwrap().1, None);
        let massless = Material { density: 0.0, ..Material::STEEL };
        assert_eq!(STATED.of([massless, Material::STEEL]).unwrap_err().code, "E0931");
    }

    #[test]
    fn viscosities_are_stated_once() {
        let at_40 = Some(100e-6);
        assert_eq!(viscosities(Some("ISO VG 220"), None, None).unwrap(), [1e-6 * 220.0, 1e-6 * 19.0]);
        assert_eq!(viscosities(None, at_40, Some(12e-6)).unwrap(), [100e-6, 12e-6]);
        for wrong in [
            viscosities(None, at_40, None),
            viscosities(None, None, None),
            viscosities(Some("ISO VG 100"), at_40, None),
            viscosities(None, at_40, Some(120e-6)),
            viscosities(Some("ISO VG 99"), None, None),
        ] {
            assert_eq!(wrong.unwrap_err().code, "E0931");
        }
        // Grades are sorted and named by their viscosity.
        for (name, [at_40, at_100]) in GRADES {
            assert!(name == format!("ISO VG {at_40}") && at_100 < at_40);
        }
    }
}
