"""Design of gear systems with Calyx: compile a model, set its params, solve it, read its results.

>>> import calyx
>>> pair = calyx.load("pair.cx")
>>> results = pair.run(torque="120 N*m")
>>> results["transmission_error"].peak_to_peak
>>> results.frame()

Numbers are in the unit in which the model shows them; every value, param and output has its unit.
The results have the same bits as those of `calyx run`.
"""

from __future__ import annotations

from calyx._calyx import Cancel, __version__
from calyx._fields import Contact, Fields, Fillet, Mesh
from calyx._model import Model, Output, Param, Progress, load, loads
from calyx._results import (
    Errors,
    Finding,
    Harmonic,
    Location,
    OutputValues,
    Positions,
    Results,
    Sensitivity,
    Summary,
)
from calyx._settings import configure
from calyx._sweep import Failure, Sweep
from calyx.errors import (
    CalyxError,
    CancelledError,
    DirectoryError,
    InternalError,
    LimitError,
    ModelError,
    ParamError,
    RunError,
)

__all__ = [
    "CalyxError",
    "Cancel",
    "CancelledError",
    "Contact",
    "DirectoryError",
    "Errors",
    "Failure",
    "Fields",
    "Fillet",
    "Finding",
    "Harmonic",
    "InternalError",
    "LimitError",
    "Location",
    "Mesh",
    "Model",
    "ModelError",
    "Output",
    "OutputValues",
    "Param",
    "ParamError",
    "Positions",
    "Progress",
    "Results",
    "RunError",
    "Sensitivity",
    "Summary",
    "Sweep",
    "__version__",
    "configure",
    "load",
    "loads",
]
