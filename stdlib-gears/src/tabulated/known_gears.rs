//! Gears of earlier elaborations. An editor elaborates a model after each edit, and most edits
//! change no tooth; its interpolation and its accepted meshes are then those of before.

use super::prototype::{BoreShape, TabulatedGear, TabulatedGearData};
use crate::blank::Rim;
use crate::error::Refusal;
use calyx_runtime::cache::Key;
use std::sync::{Arc, Mutex, PoisonError};

/// Number of stored gears: those of a few models, or of a model at some values of a param. One
/// takes about a megabyte.
const MOST: usize = 16;

/// Stored gears, the last used one at the end.
static KNOWN: Mutex<Vec<(Key, Arc<TabulatedGear>)>> = Mutex::new(Vec::new());

/// Returns the gear of these data, from an earlier call if that had equal data.
///
/// # Errors
/// As for [`TabulatedGear::new`].
pub fn gear_of(data: TabulatedGearData) -> Result<Arc<TabulatedGear>, Refusal> {
    let key = key(&data);
    let known = || KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    {
        let mut known = known();
        if let Some(at) = known.iter().position(|(other, _)| *other == key) {
            let found = known.remove(at);
            let gear = Arc::clone(&found.1);
            known.push(found);
            return Ok(gear);
        }
    }
    let gear = TabulatedGear::new(data)?;
    let mut known = known();
    known.retain(|(other, _)| *other != key);
    known.push((key, Arc::clone(&gear)));
    if known.len() > MOST {
        known.remove(0);
    }
    Ok(gear)
}

/// Key of all data; numbers that differ in any bit give different keys.
fn key(data: &TabulatedGearData) -> Key {
    let optional = |number: Option<f64>| number.map_or(Vec::new(), |number| vec![number]);
    let TabulatedGearData { table, tip_edge_radius, material, bore, support, pitch_errors } = data;
    let mut key = Key::of("data of a tabulated gear").count(u64::from(table.teeth)).number(table.pitch_angle);
    for grid in table.flanks.iter().chain(&table.fillets) {
        key = key.count(grid.len() as u64);
        for profile in grid {
            key = key.numbers(profile.as_flattened());
        }
    }
    key = match *bore {
        BoreShape::Rim { thickness, angle } => {
            key.text("rim").numbers(&optional(thickness)).numbers(&optional(angle))
        }
        BoreShape::Cylinder(diameter) => key.text("cylinder").number(diameter),
    };
    key.numbers(&optional(*tip_edge_radius))
        .numbers(&[material.youngs_modulus, material.poissons_ratio, material.density])
        .numbers(&Rim::support_numbers(*support))
        .numbers(pitch_errors)
        .finish()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tabulated::test_teeth::Conical;
    use calyx_runtime::material::Material;
    use calyx_runtime::structure::BoreSupport;

    fn data() -> TabulatedGearData {
        TabulatedGearData {
            table: Conical::PINION.table(7, 13),
            tip_edge_radius: None,
            material: Material { youngs_modulus: 2e11, poissons_ratio: 0.3, density: 7800.0 },
            bore: BoreShape::Rim { thickness: None, angle: None },
            support: BoreSupport::Rigid,
            pitch_errors: Vec::new(),
        }
    }

    /// Every field of the data is part of the key.
    #[test]
    fn equal_data_share_a_gear_and_no_others_do() {
        let first = gear_of(data()).expect("a gear");
        assert!(Arc::ptr_eq(&first, &gear_of(data()).expect("a gear")));
        let changes: [fn(&mut TabulatedGearData); 9] = [
            |data| data.table.pitch_angle += 1e-15,
            |data| data.table.flanks[1][2][3][1] += 1e-12,
            |data| data.table.fillets[0][0][1][0] += 1e-12,
            |data| data.tip_edge_radius = Some(1e-4),
            |data| data.material.density += 1.0,
            |data| data.bore = BoreShape::Rim { thickness: Some(0.004), angle: None },
            |data| data.bore = BoreShape::Rim { thickness: None, angle: Some(0.004) },
            |data| data.support = BoreSupport::Means { harmonics: None, degree: 0 },
            |data| data.pitch_errors = vec![1e-6],
        ];
        for (index, change) in changes.into_iter().enumerate() {
            let mut changed = data();
            change(&mut changed);
            assert_ne!(key(&changed), key(&data()), "change {index}");
        }
    }
}
