"""The notebooks in `examples/`, which check their own results."""

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


def test_every_example_is_run():
    assert {path.name for path in FOLDER.glob("*.py")} == NEEDS.keys()


@pytest.mark.slow
@pytest.mark.parametrize("name", NEEDS)
def test_examples(name, tmp_path):
    optional(NEEDS[name])
    command = [sys.executable, "-W", "ignore", str(FOLDER / name)]
    # Dask writes there.
    environment = {**os.environ, "DASK_TEMPORARY_DIRECTORY": str(tmp_path)}
    ended = subprocess.run(command, cwd=FOLDER, env=environment, capture_output=True, text=True, timeout=600)
    assert ended.returncode == 0, ended.stdout + ended.stderr
    assert ended.stdout
