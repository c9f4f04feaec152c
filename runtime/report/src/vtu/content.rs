//! Contents of the VTU files of a position, as grids.

use super::grid::{
    BIQUADRATIC_QUADRILATERAL, Grid, HEXAHEDRON, LINE, QUADRATIC_HEXAHEDRON, QUADRATIC_QUADRILATERAL,
    QUADRATIC_TETRAHEDRON, QUADRATIC_TRIANGLE, QUADRATIC_WEDGE, QUADRILATERAL, TETRAHEDRON, TRIANGLE, VERTEX,
    Values, WEDGE,
};
use calyx_runtime::elastic::model::{ShellShape, SolidShape};
use calyx_runtime::elastic_body::CellShape;
use calyx_runtime::observables::Fields;
use calyx_runtime::stress::von_mises;

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
    let [mut displacements, mut stresses, mut equivalents, mut errors, mut bodies, mut teeth]: [Vec<f64>; 6] =
        Default::default();
    for body in &fields.bodies {
        for sector in &body.sectors {
            let first = grid.points.len();
            grid.points.extend(&sector.points);
            displacements.extend(sector.displacements.as_flattened());
            errors.extend(&sector.stress_errors);
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
    for body in &fields.elastic_bodies {
        let first = grid.points.len();
        grid.points.extend(&body.points);
        displacements.extend(body.displacements.as_flattened());
        errors.extend(&body.stress_errors);
        for &stress in &body.stresses {
            let [xx, yy, zz, yz, zx, xy] = stress;
            stresses.extend([xx, yy, zz, xy, yz, zx]);
            equivalents.push(von_mises(stress));
        }
        for (shape, nodes) in &body.cells {
            let (kind, order) = cell_of(*shape);
            let node = |at: usize| first + nodes[at];
            let cell = match order {
                [] => (0..nodes.len()).map(node).collect(),
                order => order.iter().map(|&at| node(at)).collect(),
            };
            grid.cells.push((kind, cell));
            bodies.push(body.number as f64);
            teeth.push(NO_TOOTH);
        }
    }
    grid.point_values = vec![
        Values { name: "displacement", components: 3, numbers: displacements },
        Values { name: "stress", components: 6, numbers: stresses },
        Values::scalars("von_mises", equivalents),
        Values::scalars("stress_error", errors),
    ];
    grid.cell_values = vec![Values::scalars("body", bodies), Values::scalars("tooth", teeth)];
    grid
}

/// Number of the tooth of cells that belong to no gear.
const NO_TOOTH: f64 = -1.0;

/// Returns the cell type of VTK, and the order of its nodes among those of the shape if it differs.
/// VTK numbers the midside nodes of the faces before those between the faces.
fn cell_of(shape: CellShape) -> (u8, &'static [usize]) {
    match shape {
        CellShape::Line => (LINE, &[]),
        CellShape::Shell(ShellShape::Triangle3) => (TRIANGLE, &[]),
        CellShape::Shell(ShellShape::Triangle6) => (QUADRATIC_TRIANGLE, &[]),
        CellShape::Shell(ShellShape::Quadrilateral4) => (QUADRILATERAL, &[]),
        CellShape::Shell(ShellShape::Quadrilateral8) => (QUADRATIC_QUADRILATERAL, &[]),
        CellShape::Shell(ShellShape::Quadrilateral9) => (BIQUADRATIC_QUADRILATERAL, &[]),
        CellShape::Solid(SolidShape::Tetrahedron4) => (TETRAHEDRON, &[]),
        CellShape::Solid(SolidShape::Tetrahedron10) => (QUADRATIC_TETRAHEDRON, &[]),
        CellShape::Solid(SolidShape::Hexahedron8 | SolidShape::IncompatibleHexahedron8) => (HEXAHEDRON, &[]),
        CellShape::Solid(SolidShape::Hexahedron20) => {
            (QUADRATIC_HEXAHEDRON, &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 16, 17, 18, 19, 12, 13, 14, 15])
        }
        CellShape::Solid(SolidShape::Wedge6) => (WEDGE, &[]),
        CellShape::Solid(SolidShape::Wedge15) => {
            (QUADRATIC_WEDGE, &[0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 13, 14, 9, 10, 11])
        }
    }
}
