//! Contents of the VTU files of a position, as grids.

use super::grid::{Grid, HEXAHEDRON, LINE, QUADRILATERAL, VERTEX, Values};
use calyx_runtime::observables::Fields;

/// Returns every cell of every contact patch, with its pressure and teeth.
pub fn contact(fields: &Fields) -> Grid {
    let mut grid = Grid::default();
    let (mut pressures, mut first_teeth, mut second_teeth) = (Vec::new(), Vec::new(), Vec::new());
    for contact in &fields.contacts {
        for cell in &contact.cells {
            let first = grid.points.len();
            grid.points.extend(cell.corners);
            grid.cells.push((QUADRILATERAL, (first..first + 4).collect()));
            pressures.push(cell.pressure);
            let [first_tooth, second_tooth] = contact.teeth.map(f64::from);
            first_teeth.push(first_tooth);
            second_teeth.push(second_tooth);
        }
    }
    let named = [("pressure", pressures), ("first_tooth", first_teeth), ("second_tooth", second_teeth)];
    grid.cell_values = named.map(|(name, values)| Values::scalars(name, values)).into();
    grid
}

/// Returns the stress recovery points of fillets: joined to quadrilaterals if all sections along
/// the face have equally many points, to lines if there is one section.
pub fn root_stress(fields: &Fields) -> Grid {
    let mut grid = Grid::default();
    let mut values: [Vec<f64>; 4] = Default::default();
    for fillet in &fields.fillets {
        let first = grid.points.len();
        for stress in fillet.sections.iter().flatten() {
            grid.points.push(stress.point);
            let [largest, smallest] = stress.principal;
            let numbers = [largest, smallest, stress.components[0], f64::from(fillet.tooth)];
            values.iter_mut().zip(numbers).for_each(|(values, number)| values.push(number));
        }
        let across = fillet.sections.first().map_or(0, Vec::len);
        let even = fillet.sections.iter().all(|section| section.len() == across);
        let at = |section: usize, point: usize| first + section * across + point;
        match fillet.sections.len() {
            1 => grid.cells.extend((1..across).map(|point| (LINE, vec![at(0, point - 1), at(0, point)]))),
            sections if even => {
                for section in 1..sections {
                    let cell = |point: usize| {
                        let corners = [
                            (section - 1, point - 1),
                            (section - 1, point),
                            (section, point),
                            (section, point - 1),
                        ];
                        (QUADRILATERAL, corners.map(|(section, point)| at(section, point)).to_vec())
                    };
                    grid.cells.extend((1..across).map(cell));
                }
            }
            _ => grid.cells.extend((first..grid.points.len()).map(|point| (VERTEX, vec![point]))),
        }
    }
    let names = ["largest_principal", "smallest_principal", "along_profile", "tooth"];
    grid.point_values =
        names.into_iter().zip(values).map(|(name, values)| Values::scalars(name, values)).collect();
    grid
}

/// Returns the undeformed meshes of bodies, with displacements and stresses.
pub fn bodies(fields: &Fields) -> Grid {
    let mut grid = Grid { short: true, ..Grid::default() };
    let [mut displacements, mut stresses, mut equivalents, mut bodies, mut teeth]: [Vec<f64>; 5] =
        Default::default();
    for body in &fields.bodies {
        for sector in &body.sectors {
            let first = grid.points.len();
            grid.points.extend(&sector.points);
            displacements.extend(sector.displacements.as_flattened());
            for &stress in &sector.stresses {
                let [xx, yy, zz, yz, zx, xy] = stress;
                // Component order of a symmetric tensor in VTK.
                stresses.extend([xx, yy, zz, xy, yz, zx]);
                equivalents.push(von_mises(stress));
            }
            for cell in &sector.cells {
                let kind = if cell.len() == 8 { HEXAHEDRON } else { QUADRILATERAL };
                grid.cells.push((kind, cell.iter().map(|corner| first + corner).collect()));
                bodies.push(body.number as f64);
                teeth.push(f64::from(sector.tooth));
            }
        }
    }
    grid.point_values = vec![
        Values { name: "displacement", components: 3, numbers: displacements },
        Values { name: "stress", components: 6, numbers: stresses },
        Values::scalars("von_mises", equivalents),
    ];
    grid.cell_values = vec![Values::scalars("body", bodies), Values::scalars("tooth", teeth)];
    grid
}

/// Computes the von Mises stress from xx, yy, zz, yz, zx, xy.
fn von_mises([xx, yy, zz, yz, zx, xy]: [f64; 6]) -> f64 {
    let direct = (xx - yy).powi(2) + (yy - zz).powi(2) + (zz - xx).powi(2);
    (0.5 * direct + 3.0 * (yz * yz + zx * zx + xy * xy)).sqrt()
}
