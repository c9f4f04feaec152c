"""Results in Python and files of `save` equal those of the command `calyx`, given by CALYX."""

import csv
import json
import os
import shutil
import subprocess

import pytest

from support import EXAMPLES, ROOT

COMMAND = os.environ.get("CALYX") or shutil.which("calyx") or str(ROOT / "target/debug/calyx")
SET = {"torque": "120 N*m", "steps": 2}

pytestmark = pytest.mark.skipif(
    not os.path.exists(COMMAND) and not os.environ.get("CALYX"), reason="there is no command `calyx`"
)


def run(directory, *options):
    settings = [text for name, value in SET.items() for text in ("--set", f"{name}={value}")]
    command = [COMMAND, "run", str(EXAMPLES / "spur_pair.cx"), "--quiet", "--out", str(directory)]
    subprocess.run([*command, *settings, *options], check=True)


def files(directory):
    return {str(path.relative_to(directory)): path for path in directory.rglob("*") if path.is_file()}


@pytest.mark.parametrize(
    ("fields", "fidelity", "options"),
    [
        (False, "analytic", []),
        (True, "plane", ["--fields"]),
        pytest.param("bodies", "plane", ["--fields", "--vtu"], marks=pytest.mark.slow),
    ],
)
def test_saved_files_are_those_of_the_command(spur, tmp_path, fields, fidelity, options):
    run(tmp_path / "command", "--fidelity", fidelity, *options)
    results = spur.run(SET, fidelity=fidelity, fields=fields)
    results.save(tmp_path / "python")
    expected, found = files(tmp_path / "command"), files(tmp_path / "python")
    if fields:
        assert found.keys() == expected.keys()
    else:
        assert found.keys() == {".calyx-run", "run.json", "steps.csv", "report.html", "timing.json"}
    # Two files have durations.
    for name in found.keys() - {"timing.json", "report.html", ".calyx-run"}:
        assert found[name].read_bytes() == expected[name].read_bytes(), name


def test_values_are_those_of_the_command(spur, tmp_path):
    run(tmp_path / "command", "--fidelity", "plane")
    results = spur.run(SET, fidelity="plane")
    with open(tmp_path / "command/steps.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    document = json.loads((tmp_path / "command/run.json").read_text())
    for output in results.values():
        assert [float(row[output.name]) for row in rows] == output.si.tolist()
        shown, summary = document["outputs"][output.name], output.summary
        display = shown["display"]
        assert display["unit"] == output.unit
        assert [display[name] for name in ("min", "max", "mean")] == [summary.min, summary.max, summary.mean]
    assert [float(row["time"]) for row in rows] == results.positions.time.tolist()
