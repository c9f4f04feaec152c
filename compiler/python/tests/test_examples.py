"""The notebooks in `examples/`, which check their own results.

The programs are their source: text and cells follow from `# %%` lines. CALYX_BLESS=1 writes the
notebooks, without outputs.
"""

import json
import os
import subprocess
import sys

import pytest

from support import ROOT, optional

FOLDER = ROOT / "compiler/python/examples"
NEEDS = {
    "cluster.py": "distributed",
    "optimize.py": "scipy",
    "optuna_study.py": "optuna",
    "sensitivity.py": "SALib",
}
# Processes of a cluster import the program, so that it is no notebook.
NOTEBOOKS = [name for name in NEEDS if name != "cluster.py"]


def cells(program):
    """Returns the cells of a program with `# %%` lines."""
    for part in program.split("# %%")[1:]:
        head, _, body = part.partition("\n")
        body = body.strip("\n")
        if head.strip() == "[markdown]":
            lines = [line[2:] if line.startswith("# ") else line[1:] for line in body.split("\n")]
            yield {"cell_type": "markdown", "metadata": {}, "source": lines}
        else:
            code = {"cell_type": "code", "execution_count": None, "metadata": {}, "outputs": []}
            yield {**code, "source": body.split("\n")}


def notebook(program):
    """Returns the text of the notebook of a program, without outputs."""
    every = []
    for number, cell in enumerate(cells(program), 1):
        lines = cell["source"]
        cell["source"] = [line + "\n" for line in lines[:-1]] + lines[-1:]
        every.append({"id": f"cell-{number}", **cell})
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    metadata = {"kernelspec": kernel, "language_info": {"name": "python"}}
    whole = {"cells": every, "metadata": metadata, "nbformat": 4, "nbformat_minor": 5}
    return json.dumps(whole, indent=1, sort_keys=True, ensure_ascii=False) + "\n"


def test_every_example_is_run():
    assert {path.name for path in FOLDER.glob("*.py")} == NEEDS.keys()
    names = {name.replace(".py", ".ipynb") for name in NOTEBOOKS}
    if os.environ.get("CALYX_BLESS") != "1":
        assert {path.name for path in FOLDER.glob("*.ipynb")} == names


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_notebooks_are_those_of_the_programs(name):
    program = (FOLDER / name).read_text(encoding="utf-8")
    path = (FOLDER / name).with_suffix(".ipynb")
    if os.environ.get("CALYX_BLESS") == "1":
        path.write_text(notebook(program), encoding="utf-8")
    assert path.read_text(encoding="utf-8") == notebook(program), "write it with CALYX_BLESS=1"


@pytest.mark.slow
@pytest.mark.parametrize("name", NOTEBOOKS)
def test_notebooks_run(name, tmp_path, monkeypatch):
    optional(NEEDS[name])
    optional("ipykernel")
    client = optional("nbclient")
    import nbformat

    # Jupyter writes there.
    for variable in ["IPYTHONDIR", "JUPYTER_CONFIG_DIR", "JUPYTER_DATA_DIR", "JUPYTER_RUNTIME_DIR"]:
        monkeypatch.setenv(variable, str(tmp_path / variable))
    path = (FOLDER / name).with_suffix(".ipynb")
    read = nbformat.read(path, as_version=4)
    nbformat.validate(read)
    resources = {"metadata": {"path": str(FOLDER)}}
    run = client.NotebookClient(read, timeout=600, kernel_name="python3", resources=resources).execute()
    outputs = [output for cell in run.cells for output in cell.get("outputs", [])]
    assert any(output.output_type == "stream" for output in outputs)
    # Models, results and sweeps show themselves.
    assert any(output.output_type == "execute_result" for output in outputs)


@pytest.mark.slow
@pytest.mark.parametrize("name", [name for name in NEEDS if name not in NOTEBOOKS])
def test_programs_run(name, tmp_path):
    optional(NEEDS[name])
    command = [sys.executable, "-W", "ignore", str(FOLDER / name)]
    # Dask writes there.
    environment = {**os.environ, "DASK_TEMPORARY_DIRECTORY": str(tmp_path)}
    ended = subprocess.run(command, cwd=FOLDER, env=environment, capture_output=True, text=True, timeout=600)
    assert ended.returncode == 0, ended.stdout + ended.stderr
    assert ended.stdout
