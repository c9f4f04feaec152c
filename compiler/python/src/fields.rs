//! Fields of solved positions as dictionaries of arrays, in SI and ground coordinates.

use crate::arrays::{array, rows, shaped};
use calyx_runtime::observables::{
    BodyField, ContactField, ElasticBodyField, Fields, FilletField, FilletStress, PressedCell, SectorField,
};
use calyx_runtime::results::Location;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Converts the fields of a position.
pub fn dict<'py>(py: Python<'py>, fields: &Fields) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    let contacts: PyResult<Vec<_>> = fields.contacts.iter().map(|field| contact(py, field)).collect();
    dict.set_item("contacts", contacts?)?;
    let fillets: PyResult<Vec<_>> = fields.fillets.iter().map(|field| fillet(py, field)).collect();
    dict.set_item("fillets", fillets?)?;
    let sectors = fields.bodies.iter().flat_map(|body| body.sectors.iter().map(move |of| (body, of)));
    let meshes = sectors.map(|(body, field)| sector(py, body, field));
    let elastic = fields.elastic_bodies.iter().map(|field| elastic_body(py, field));
    dict.set_item("meshes", meshes.chain(elastic).collect::<PyResult<Vec<_>>>()?)?;
    Ok(dict)
}

fn contact<'py>(py: Python<'py>, field: &ContactField) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    dict.set_item("bodies", field.bodies.clone())?;
    dict.set_item("teeth", field.teeth)?;
    dict.set_item("back", field.back)?;
    let cells = &field.cells;
    let corners: Vec<f64> = cells.iter().flat_map(|cell| cell.corners.as_flattened()).copied().collect();
    dict.set_item("corners", shaped(py, &corners, vec![cells.len(), 4, 3])?)?;
    dict.set_item("pressure", array(py, &column(cells, |cell| cell.pressure))?)?;
    dict.set_item("edge", array(py, &column(cells, |cell| u8::from(cell.edge)))?)?;
    let located = |value: fn(&Location) -> f64| {
        rows(py, &column(cells, |cell: &PressedCell| [value(&cell.locations[0]), value(&cell.locations[1])]))
    };
    dict.set_item("radius", located(|at| at.radius)?)?;
    dict.set_item("roll_angle", located(|at| at.roll_angle.unwrap_or(f64::NAN))?)?;
    dict.set_item("axial", located(|at| at.axial.unwrap_or(f64::NAN))?)?;
    let slices = &field.slices;
    dict.set_item("line_point", rows(py, &column(slices, |slice| slice.point))?)?;
    dict.set_item("line_length", array(py, &column(slices, |slice| slice.length))?)?;
    dict.set_item("line_force", array(py, &column(slices, |slice| slice.force))?)?;
    Ok(dict)
}

fn fillet<'py>(py: Python<'py>, field: &FilletField) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    dict.set_item("body", &field.body)?;
    dict.set_item("tooth", field.tooth)?;
    dict.set_item("flank", field.flank)?;
    let points: Vec<&FilletStress> = field.sections.iter().flatten().collect();
    let numbered = field.sections.iter().zip(0_i64..);
    let sections: Vec<i64> =
        numbered.flat_map(|(section, number)| section.iter().map(move |_| number)).collect();
    dict.set_item("section", array(py, &sections)?)?;
    dict.set_item("points", rows(py, &column(&points, |at| at.point))?)?;
    dict.set_item("depth", array(py, &column(&points, |at| at.depth))?)?;
    dict.set_item("stresses", rows(py, &column(&points, |at| at.components))?)?;
    dict.set_item("principal", rows(py, &column(&points, |at| at.principal))?)?;
    Ok(dict)
}

fn sector<'py>(py: Python<'py>, body: &BodyField, field: &SectorField) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    dict.set_item("body", &body.body)?;
    dict.set_item("tooth", field.tooth)?;
    let shape = |cell: &Vec<usize>| if cell.len() == 4 { "quadrilateral" } else { "hexahedron" };
    dict.set_item("shapes", field.cells.iter().map(shape).collect::<Vec<_>>())?;
    cells(py, &dict, field.cells.iter())?;
    nodes(py, &dict, (&field.points, &field.displacements), (&field.stresses, &field.stress_errors))?;
    Ok(dict)
}

fn elastic_body<'py>(py: Python<'py>, field: &ElasticBodyField) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    dict.set_item("body", &field.body)?;
    dict.set_item("tooth", None::<u32>)?;
    let shapes = field.cells.iter().map(|(shape, _)| format!("{shape:?}").to_lowercase());
    dict.set_item("shapes", shapes.collect::<Vec<_>>())?;
    cells(py, &dict, field.cells.iter().map(|(_, cell)| cell))?;
    nodes(py, &dict, (&field.points, &field.displacements), (&field.stresses, &field.stress_errors))?;
    Ok(dict)
}

/// Adds the corners of all cells one after another, and the end of each cell in them.
fn cells<'c>(
    py: Python<'_>,
    dict: &Bound<'_, PyDict>,
    cells: impl Iterator<Item = &'c Vec<usize>>,
) -> PyResult<()> {
    let (mut corners, mut ends) = (Vec::new(), Vec::new());
    for cell in cells {
        corners.extend(cell.iter().map(|corner| i64::try_from(*corner).unwrap_or(i64::MAX)));
        ends.push(i64::try_from(corners.len()).unwrap_or(i64::MAX));
    }
    dict.set_item("corners", array(py, &corners)?)?;
    dict.set_item("ends", array(py, &ends)?)
}

/// Adds points and displacements, stresses and their estimated errors.
fn nodes(
    py: Python<'_>,
    dict: &Bound<'_, PyDict>,
    (points, displacements): (&[[f64; 3]], &[[f64; 3]]),
    (stresses, errors): (&[[f64; 6]], &[f64]),
) -> PyResult<()> {
    dict.set_item("points", rows(py, points)?)?;
    dict.set_item("displacements", rows(py, displacements)?)?;
    dict.set_item("stresses", rows(py, stresses)?)?;
    dict.set_item("stress_errors", array(py, errors)?)
}

fn column<S, T>(structures: &[S], value: impl Fn(&S) -> T) -> Vec<T> {
    structures.iter().map(value).collect()
}
