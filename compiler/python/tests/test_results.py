"""Results: outputs, statistics, tables, fields, pages and directories."""

import numpy as np
import pytest

import calyx
from support import QUICK, optional


def test_statistics_are_those_of_the_values(spur_results):
    for output in spur_results.values():
        assert (output.values.min(), output.values.max()) == (output.min, output.max), output
        assert output.peak_to_peak == pytest.approx(output.max - output.min, rel=1e-12, abs=1e-300)
        assert output.min <= output.mean <= output.max
        summary = output.summary
        assert (summary.min, summary.max) == (output.min, output.max)
        assert output.values[summary.at_max] == output.max
    pressure = spur_results["max_contact_pressure"]
    assert np.asarray(pressure).tolist() == pressure.values.tolist() and len(pressure) == len(
        spur_results.positions
    )
    assert not pressure.values.flags.writeable


def test_summaries_have_locations_harmonics_and_errors(spur_results):
    summary = spur_results["max_root_stress_pinion"].summary
    assert summary.location.body == "pinion" and 0.02 < summary.location.radius < 0.03
    assert summary.error.max > 0 and summary.relative_error > 0
    assert "discretization" in summary.error_parts and "level" in summary.not_estimated
    assert spur_results["transmission_error"].summary.harmonics[0].order == 1


def test_units(spur_results):
    pressure = spur_results["max_contact_pressure"]
    assert pressure.unit == "psi"
    mpa = pressure.to("MPa")
    assert mpa.unit == "MPa" and mpa.values == pytest.approx(pressure.values * 6894.757293e-6, rel=1e-9)
    assert mpa.summary.error.max == pytest.approx(pressure.summary.error.max * 6894.757293e-6, rel=1e-9)
    assert pressure.to("Pa").values.tobytes() == pressure.si.tobytes()
    for unit in ("mm", "parsec"):
        with pytest.raises(calyx.ParamError, match="cannot be shown in"):
            pressure.to(unit)


def test_names_that_do_not_exist(spur_results):
    with pytest.raises(calyx.ParamError, match="did you mean `load_share`"):
        spur_results["load_shares"]
    assert "load_shares" not in spur_results and "load_share" in spur_results


def test_positions(spur_results):
    positions = spur_results.positions
    assert len(positions) == len(positions.point) == len(positions.roll_angle)
    assert np.all(np.diff(positions.time) > 0) and "HPSTC" in "".join(positions.point)


def test_facts(spur_results):
    assert spur_results.params["torque"] == pytest.approx(1062.09, rel=1e-4)
    assert spur_results.time > 0 and "structures" in spur_results.stages
    assert max(spur_results.certificate.values()) < 1e-9
    assert spur_results.warnings == [] and spur_results.findings == []


def test_findings_of_the_params_have_source_lines(spur):
    [finding] = spur.run(torque=0, **QUICK).findings
    assert (
        finding.code == "W0801"
        and "no load acts" in finding.message
        and "spur_pair.cx:66" in finding.rendered
    )


@pytest.mark.parametrize("engine", ["pandas", "polars", "pyarrow"])
def test_tables(spur_results, engine):
    module = optional(engine)
    name = "arrow" if engine == "pyarrow" else engine
    frame = spur_results.frame(name)
    columns = {c: np.asarray(frame[c]) for c in spur_results}
    for output in spur_results.values():
        assert columns[output.name].tolist() == output.values.tolist()
    assert len(spur_results.frame(name, si=True)) == len(spur_results.positions)
    assert len(spur_results.summary_frame(name)) == len(spur_results)
    if name == "pandas":
        assert isinstance(frame, module.DataFrame) and frame.attrs["units"]["max_contact_pressure"] == "psi"
    if name == "arrow":
        assert frame.schema.field("max_contact_pressure").metadata == {b"unit": b"psi"}


def test_other_programs_read_the_table_through_arrow(spur_results):
    pyarrow = optional("pyarrow")
    table = pyarrow.table(spur_results)
    assert table["load_share"].to_pylist() == spur_results["load_share"].values.tolist()


def test_unknown_tables(spur_results):
    with pytest.raises(ValueError, match="pandas, polars, arrow"):
        spur_results.frame("excel")


def test_contacts_and_fillets_are_arrays(spur_results):
    assert list(spur_results.fields) == list(range(len(spur_results.positions)))
    for position, fields in spur_results.fields.items():
        largest = max(contact.pressure[~contact.edge].max() for contact in fields.contacts)
        # The output interpolates between cells.
        assert largest == pytest.approx(spur_results["max_contact_pressure"].si[position], rel=1e-2)
        stress = max(f.principal[:, 0].max() for f in fields.fillets if f.body == "pinion")
        assert stress >= spur_results["max_root_stress_pinion"].si[position] * (1 - 1e-9)
    contact = fields.contacts[0]
    assert contact.corners.shape == (len(contact.pressure), 4, 3) and contact.bodies == ("pinion", "gear")
    assert contact.radius.shape == (len(contact.pressure), 2)
    # The forces of the contact lines carry the torque of 120 N*m at the base radius.
    base_radius = 0.0254 * np.cos(np.radians(20))
    forces = sum(contact.line_force.sum() for contact in fields.contacts)
    assert forces * base_radius == pytest.approx(120, rel=1e-6)
    assert contact.line_load.shape == contact.line_force.shape


def test_meshes_are_arrays(spur_results):
    meshes = spur_results.fields[0].meshes
    assert {mesh.body for mesh in meshes} == {"pinion", "gear"}
    mesh = next(mesh for mesh in meshes if mesh.tooth == 0)
    assert mesh.points.shape == mesh.displacements.shape == (len(mesh.von_mises), 3)
    assert mesh.stresses.shape == (len(mesh.points), 6) and len(mesh.cells) == len(mesh.shapes)
    assert all(cell.max() < len(mesh.points) for cell in mesh.cells)
    assert set(mesh.shapes) == {"quadrilateral"} and {len(cell) for cell in mesh.cells} == {4}


def test_runs_without_fields_say_how_to_keep_them(spur):
    results = spur.run(**QUICK)
    assert len(results.fields) == 0
    with pytest.raises(KeyError, match="fields=True"):
        results.fields[0]
    with pytest.raises(ValueError, match="fields is 'all'"):
        spur.run(fields="all")


def test_notebooks_show_the_report(spur_results):
    shown = spur_results._repr_html_()
    assert shown.startswith("<iframe srcdoc=") and "&lt;svg" in shown and "Transmission error" in shown
    page = spur_results.report()
    assert page.startswith("<!DOCTYPE html>") and page.count("<svg") >= 7


def test_directories_of_the_user_are_kept(spur, tmp_path):
    results = spur.run(**QUICK)
    (tmp_path / "run.json").write_text("mine")
    with pytest.raises(calyx.DirectoryError, match="force=True") as caught:
        results.save(tmp_path)
    assert isinstance(caught.value, OSError) and (tmp_path / "run.json").read_text() == "mine"
    results.save(tmp_path / "new")
    results.save(tmp_path / "new")
    assert (tmp_path / "new/report.html").exists()
    with pytest.raises(calyx.DirectoryError):
        results.save("/proc/no/such/directory")


def test_quantities(spur, spur_results):
    pint = optional("pint")
    registry = pint.UnitRegistry()
    pressure = spur_results["max_contact_pressure"].quantity(registry)
    assert pressure.units == registry.psi
    assert pressure.to("MPa").magnitude == pytest.approx(
        spur_results["max_contact_pressure"].to("MPa").values
    )
    length = spur_results["transmission_error_length"].quantity(registry)
    assert length.to("inch").magnitude == pytest.approx(
        spur_results["transmission_error_length"].to("inch").values
    )
    torque = registry.Quantity(120.0, "N*m")
    assert spur.values(torque=torque)["torque"] == pytest.approx(
        spur.values(torque="120 N*m")["torque"], rel=1e-14
    )
    assert spur.values(pinion_relief_start=registry.Quantity(0.4, "rad"))[
        "pinion_relief_start"
    ] == pytest.approx(np.degrees(0.4))
    assert spur.values(steps=registry.Quantity(4, "dimensionless"))["steps"] == 4
    with pytest.raises(calyx.ParamError, match="another kind of quantity"):
        spur.values(torque=registry.Quantity(3, "mm"))
    assert spur_results["load_share"].quantity().check("[]")
