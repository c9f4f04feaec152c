"""Results of a run."""

from __future__ import annotations

import html
import json
import os
import tempfile
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from calyx import _calyx
from calyx._fields import Fields, Floats, as_array, fields
from calyx._tables import arrow_stream, html_table, table
from calyx._units import application_registry, pint_unit
from calyx.errors import CalyxError, RunError, _unknown

if TYPE_CHECKING:
    from calyx._calyx import Units

STATISTICS = ("min", "max", "mean", "peak_to_peak")


@dataclass(frozen=True)
class Location:
    """Location on a body."""

    body: str
    tooth: int
    """Tooth, counter-clockwise from 0."""
    radius: float
    """Radius, m."""
    roll_angle: float | None
    """Roll angle, rad; None without an involute."""
    axial: float | None
    """Axial coordinate, m; None in a plane model."""


@dataclass(frozen=True)
class Harmonic:
    """Harmonic of the tooth mesh frequency: `amplitude cos(2 pi order cycle + phase)`."""

    order: int
    amplitude: float
    """Half of peak-to-peak, in the unit of the output."""
    phase: float
    """Phase, rad."""


@dataclass(frozen=True)
class Errors:
    """Estimated errors of the statistics of an output, in its unit."""

    min: float
    max: float
    mean: float
    peak_to_peak: float


@dataclass(frozen=True)
class Summary:
    """Statistics of an output over all positions, in its unit."""

    min: float
    max: float
    mean: float
    """Mean over time."""
    peak_to_peak: float
    at_max: int
    """Index of the position of the maximum."""
    location: Location | None
    """Location of the maximum on a body."""
    harmonics: tuple[Harmonic, ...]
    """Harmonics of the tooth mesh frequency, if the positions are a mesh cycle."""
    error: Errors | None
    """Estimated errors, if the analysis estimates them."""
    error_parts: Mapping[str, Errors]
    """Parts of the estimated errors by cause."""
    not_estimated: Mapping[str, str]
    """Causes of errors that were not estimated, with the reason."""
    relative_error: float | None
    """Estimated error of the value of largest magnitude relative to it."""


@dataclass(frozen=True)
class Sensitivity:
    """Derivative of a statistic of an output with respect to a param."""

    output: str
    statistic: str
    """"min", "mean", "max" or "peak_to_peak"."""
    param: str
    unit: str
    """Unit of the derivative: that of the output per unit of the param's default."""
    below: float
    """Derivative towards smaller values of the param."""
    above: float
    """Derivative towards larger values; another one than `below` at a kink."""
    error: float
    """Estimated error."""
    new_structures: bool
    """True if the param changes the stiffness of a body, which was computed again at each value."""

    @property
    def value(self) -> float:
        """Derivative, at a kink the mean of both sides."""
        return 0.5 * (self.below + self.above)


@dataclass(frozen=True)
class Finding:
    """Finding of the library about the model."""

    code: str
    message: str
    rendered: str
    """Text with source lines."""


@dataclass(frozen=True)
class Positions:
    """Solved positions."""

    time: Floats
    """Time, s."""
    cycle: Floats
    """Fraction of the mesh cycle, 0 to 1."""
    roll_angle: Floats
    """Roll angle of the first gear's tooth of the entering pair, rad."""
    point: tuple[str, ...]
    """Names of characteristic points; empty for other positions."""

    def __len__(self) -> int:
        return len(self.time)


class OutputValues:
    """Values of an output over the positions, in one unit."""

    def __init__(self, output: dict[str, Any], values: bytes, summary: dict[str, Any], units: Units) -> None:
        self._output, self._si, self._summary, self._units = output, values, summary, units
        self._factor: float = output["unit"]["factor"]
        self.name: str = output["name"]
        self.doc: str = output["doc"]
        self.unit: str = output["unit"]["name"]
        """Unit of all numbers of this object."""
        self.choices: tuple[str, ...] = tuple(output["choices"])
        """Choices of an enumeration that the values number from 0; empty for other numbers."""

    def to(self, unit: str) -> OutputValues:
        """Returns the values in another unit, such as "urad". Raises ParamError for another kind of
        quantity."""
        factor = self._units.factor(self.name, self._output["unit"]["name"], unit)
        other = OutputValues(self._output, self._si, self._summary, self._units)
        other.unit, other._factor = unit, factor
        return other

    @property
    def values(self) -> Floats:
        """Value at each position; NaN if the fidelity level does not support the output."""
        return as_array(_calyx.Units.from_si(self._si, self._factor))

    @property
    def si(self) -> Floats:
        """Value at each position in the coherent SI unit."""
        return np.frombuffer(self._si, dtype="f8")

    @property
    def summary(self) -> Summary:
        """Statistics over all positions."""
        of = self._summary
        error = of["error"]
        location = of["location"]
        harmonics = [Harmonic(order, self._shown(a), phase) for order, a, phase in of["harmonics"]]
        return Summary(
            **{name: self._shown(of[name]) for name in STATISTICS},
            at_max=of["at_max"],
            location=Location(**location) if location else None,
            harmonics=tuple(harmonics),
            error=self._errors(error["total"]) if error else None,
            error_parts={part: self._errors(of) for part, of in error["parts"]} if error else {},
            not_estimated=dict(error["not_estimated"]) if error else {},
            relative_error=error["relative"] if error else None,
        )

    @property
    def min(self) -> float:
        """Smallest value."""
        return self._shown(self._summary["min"])

    @property
    def max(self) -> float:
        """Largest value."""
        return self._shown(self._summary["max"])

    @property
    def mean(self) -> float:
        """Mean over time."""
        return self._shown(self._summary["mean"])

    @property
    def peak_to_peak(self) -> float:
        """Difference between the largest and the smallest value."""
        return self._shown(self._summary["peak_to_peak"])

    def quantity(self, registry: Any = None) -> Any:
        """Returns the values as a pint quantity of a registry, by default that of the program."""
        registry = application_registry() if registry is None else registry
        unit, is_si = pint_unit(registry, (self.unit, self._factor, self._output["unit"]["dimension"]))
        return registry.Quantity(self.si if is_si else self.values, unit)

    def _shown(self, si: float) -> float:
        return float(self._convert([si])[0])

    def _errors(self, of: list[float]) -> Errors:
        return Errors(*(float(number) for number in self._convert(of)))

    def _convert(self, si: list[float]) -> Floats:
        return as_array(_calyx.Units.from_si(np.asarray(si, dtype="f8").tobytes(), self._factor))

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Any:
        return np.array(self.values, dtype=dtype)

    def __len__(self) -> int:
        return len(self._si) // 8

    def __repr__(self) -> str:
        unit = f" {self.unit}" if self.unit else ""
        return f"<{self.name}: {self.min:.6g} to {self.max:.6g}{unit} over {len(self)} positions>"


class _FieldPositions(Mapping[int, Fields]):
    """Fields by position, converted when they are read."""

    def __init__(self, raw: _calyx.Results | None, converted: dict[int, Fields] | None = None) -> None:
        self._raw, self._converted = raw, converted if converted is not None else {}
        self._positions = raw.field_positions() if raw else sorted(self._converted)

    def __getitem__(self, position: int) -> Fields:
        if position not in self._positions:
            if not self._positions:
                raise KeyError(
                    'the run keeps no fields: run it with fields=True, or fields="bodies" for meshes'
                )
            raise KeyError(f"position {position} has no fields; the positions are {self._positions}")
        if position not in self._converted:
            assert self._raw is not None
            self._converted[position] = fields(self._raw.fields(position))
        return self._converted[position]

    def __iter__(self) -> Iterator[int]:
        return iter(self._positions)

    def __len__(self) -> int:
        return len(self._positions)


class Results(Mapping[str, OutputValues]):
    """Results of a run: outputs by name, in the units in which the model shows them.

    Pickled results keep all numbers, but cannot be saved to a run directory any more.
    """

    def __init__(self, raw: _calyx.Results, printed: list[str]) -> None:
        self._raw: _calyx.Results | None = raw
        time, cycle, roll, point = raw.positions()
        facts = raw.facts()
        self._data: dict[str, Any] = {
            "params": raw.params(),
            "positions": (time, cycle, roll, point),
            "outputs": json.loads(raw.outputs()),
            "values": [data for data, _, _ in raw.values()],
            "summaries": raw.summaries(),
            "units": raw.units(),
            "facts": facts,
            "printed": printed,
            "sensitivities": raw.sensitivities(),
            "failed_sensitivities": raw.failed_sensitivities(),
        }
        self._set_up(_FieldPositions(raw))

    def _set_up(self, positions: _FieldPositions) -> None:
        data, facts = self._data, self._data["facts"]
        self._page: str | None = None
        outputs = zip(data["outputs"], data["values"], data["summaries"])
        self._outputs = {
            output["name"]: OutputValues(output, values, summary, data["units"])
            for output, values, summary in outputs
        }
        time, cycle, roll, point = data["positions"]
        self.positions = Positions(as_array(time), as_array(cycle), as_array(roll), tuple(point))
        """Solved positions."""
        self.fields: Mapping[int, Fields] = positions
        """Fields by position, if the run keeps them (`fields=True`)."""
        self.model: str = facts["model"]
        """Name of the model."""
        self.params: dict[str, Any] = {name: value for name, _, value in data["params"]}
        """Values of all params, in the units of their defaults."""
        self.fidelity: str | None = facts["fidelity"]
        """Fidelity level; None for a model without an analysis."""
        self.settings: dict[str, str] = dict(facts["settings"])
        """Settings that overrode those of the analysis."""
        self.warnings: list[str] = facts["warnings"]
        """Warnings about the results."""
        self.findings: list[Finding] = [Finding(*finding) for finding in facts["findings"]]
        """Findings of the library, without those that `Model.diagnostics` has."""
        self.ignored_inputs: dict[str, str] = dict(facts["ignored"])
        """Inputs that the fidelity level does not represent, with the reason."""
        self.sensitivities: list[Sensitivity] = [
            Sensitivity(output, statistic, param, unit, below, above, error, new)
            for output, statistic, param, unit, (below, above), error, new in data["sensitivities"]
        ]
        """Derivatives with respect to the params of `run(sensitivities=...)`; for each statistic, those
        with the largest effect first."""
        self.printed: list[str] = data["printed"]
        """Lines that the model printed."""
        self.time: float = facts["seconds"]
        """Duration of the run, s."""
        self.stages: dict[str, float] = dict(facts["stages"])
        """Duration of each stage of the analysis, s."""
        certificate = facts["certificate"]
        names = ("complementarity", "penetration", "tension", "equilibrium")
        self.certificate: dict[str, float] = dict(zip(names, certificate)) if certificate else {}
        """Largest residuals of the contact solution over all positions, relative to its scale."""

    def __getitem__(self, output: str) -> OutputValues:
        try:
            return self._outputs[output]
        except KeyError:
            raise _unknown("output", output, self._outputs) from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._outputs)

    def __len__(self) -> int:
        return len(self._outputs)

    def __contains__(self, output: object) -> bool:
        return output in self._outputs

    def value(self, name: str) -> float:
        """Returns a statistic of an output in its unit: "transmission_error.peak_to_peak"; without a
        statistic, the largest value."""
        output, statistic = self._statistic(name)
        return float(getattr(self._outputs[output], statistic))

    def gradient(self, name: str) -> dict[str, float]:
        """Returns the derivatives of a statistic, as in `value`, with respect to all params of
        `run(sensitivities=...)`, per unit of the param's default; at kinks the mean of both sides.

        Raises RunError if a derivative does not exist.
        """
        output, statistic = self._statistic(name)
        for param, message, help in self._data["failed_sensitivities"]:
            text = f"no derivative with respect to `{param}`: {message}"
            raise RunError(text, "E0792", help, f"{text}\n  help: {help}")
        own = (one for one in self.sensitivities if (one.output, one.statistic) == (output, statistic))
        return {one.param: one.value for one in own}

    def _statistic(self, name: str) -> tuple[str, str]:
        output, _, statistic = name.rpartition(".")
        if name in self._outputs or statistic not in STATISTICS:
            output, statistic = name, "max"
        if output not in self._outputs:
            raise _unknown("output", output, self._outputs)
        return output, statistic

    def sensitivity_frame(self, engine: str | None = None) -> Any:
        """Returns a table with a row for each derivative."""
        names = ("output", "statistic", "param", "unit")
        columns: dict[str, Any] = {name: [getattr(one, name) for one in self.sensitivities] for name in names}
        for name in ("value", "below", "above", "error"):
            columns[name] = np.array([getattr(one, name) for one in self.sensitivities])
        columns["new_structures"] = np.array([one.new_structures for one in self.sensitivities], dtype=bool)
        return table(columns, {}, engine)

    def frame(self, engine: str | None = None, *, si: bool = False) -> Any:
        """Returns a table with a row for each position: "pandas", "polars" or "arrow"; by default the
        first of them that is installed.

        Numbers are in the units of the outputs, or in SI. The units are in `frame.attrs["units"]` of
        pandas and in the metadata of the fields of Arrow.
        """
        return table(*self._columns(si), engine)

    def summary_frame(self, engine: str | None = None) -> Any:
        """Returns a table with a row for each output: statistics and estimated errors."""
        outputs = list(self._outputs.values())
        summaries = [output.summary for output in outputs]
        columns: dict[str, Any] = {
            "output": [output.name for output in outputs],
            "unit": [output.unit for output in outputs],
        }
        for name in STATISTICS:
            columns[name] = np.array([getattr(summary, name) for summary in summaries])
        for name in STATISTICS:
            errors = [getattr(summary.error, name) if summary.error else np.nan for summary in summaries]
            columns[f"{name}_error"] = np.array(errors)
        return table(columns, {}, engine)

    def __arrow_c_stream__(self, requested_schema: object = None) -> object:
        """Exports the table of positions to a program that reads Arrow."""
        return arrow_stream(*self._columns(False), requested_schema)

    def _columns(self, si: bool) -> tuple[dict[str, Any], dict[str, str]]:
        positions = self.positions
        columns: dict[str, Any] = {
            "step": np.arange(len(positions)),
            "time": positions.time,
            "cycle": positions.cycle,
            "roll_angle": positions.roll_angle,
            "point": list(positions.point),
        }
        units = {"time": "s", "roll_angle": "rad"}
        for name, output in self._outputs.items():
            columns[name] = output.si if si else output.values
            units[name] = output._output["si"] if si else output.unit
        return columns, units

    def save(self, directory: str | os.PathLike[str], *, force: bool = False) -> None:
        """Writes the files that `calyx run --out DIRECTORY` writes: run.json, steps.csv and report.html.

        If the run keeps fields, these include the contact patterns, the tables of `--fields` and the
        view; with "bodies" also VTU files. An earlier run in the directory is replaced. Raises
        DirectoryError for a directory with other files; with `force` they are kept, except those with
        names of results.
        """
        self._live("save").save(os.fspath(directory), force)

    def report(self) -> str:
        """Returns the report of the run as an HTML page, which needs no other files."""
        raw = self._live("report")
        if self._page is None:
            with tempfile.TemporaryDirectory(prefix="calyx-") as folder:
                self._page = raw.report(os.path.join(folder, "run"))
        return self._page

    def _live(self, what: str) -> _calyx.Results:
        if self._raw is None:
            message = "results from a pickle cannot be written to a run directory"
            help = f"call {what}() in the process that has run the model"
            raise CalyxError(message, "", help, f"{message}\n  help: {help}")
        return self._raw

    def __repr__(self) -> str:
        lines = [f"<calyx.Results of {self.model}: {len(self.positions)} positions>"]
        lines += [f"  {output!r}" for output in self._outputs.values()]
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        """Shows the report in a notebook, or a table of the outputs if there is no report."""
        if self._raw is None:
            rows = [[o.name, o.unit, o.min, o.mean, o.max, o.peak_to_peak] for o in self._outputs.values()]
            return html_table(["output", "unit", "min", "mean", "max", "peak_to_peak"], rows)
        page = html.escape(self.report(), quote=True)
        return f'<iframe srcdoc="{page}" sandbox style="width:100%;height:640px;border:0"></iframe>'

    def __getstate__(self) -> dict[str, Any]:
        return {"data": self._data, "fields": {at: self.fields[at] for at in self.fields}}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self._raw = None
        self._data = state["data"]
        self._set_up(_FieldPositions(None, state["fields"]))
