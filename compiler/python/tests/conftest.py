"""Models and results that tests share."""

import os

import pytest

import calyx
from support import EXAMPLES

# No test reads or writes the structure cache of the user.
os.environ["CALYX_CACHE"] = "off"


@pytest.fixture(scope="session")
def spur():
    """Example with one pair of spur gears."""
    return calyx.load(EXAMPLES / "spur_pair.cx")


@pytest.fixture(scope="session")
def spur_results(spur):
    """Results of a run with fields and meshes."""
    return spur.run({"torque": (120.0, "N*m")}, steps=4, fidelity="plane", fields="bodies")
