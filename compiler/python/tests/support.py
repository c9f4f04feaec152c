"""Paths, options and helpers that tests share."""

import importlib
import os
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]
EXAMPLES = ROOT / "examples"

QUICK = {"steps": 2, "fidelity": "plane"}
"""Options of runs that take a moment."""


def solve(model, torque):
    """Runs a model; a task of other processes, which import it from here."""
    return model.run(torque=torque, **QUICK)


def bits(results):
    """Returns the values of all outputs, bit by bit."""
    return b"".join(output.si.tobytes() for output in results.values())


def optional(name):
    """Imports an optional package; skips the test without it, unless CALYX_PYTHON_ALL is set."""
    if os.environ.get("CALYX_PYTHON_ALL"):
        return importlib.import_module(name)
    return pytest.importorskip(name)
