"""Models: loading, params, outputs and runs."""

from __future__ import annotations

import hashlib
import json
import os
import sys
from collections import OrderedDict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Callable, NamedTuple, Union

from calyx import _calyx
from calyx._results import Results
from calyx._tables import html_table
from calyx._units import assigned
from calyx.errors import ParamError

if TYPE_CHECKING:
    from calyx._calyx import Cancel
    from calyx._sweep import Sweep

Value = Any
"""Value of a param: a number in the unit of its default, a text such as "120 N*m", a tuple such as
(120, "N*m"), a Boolean, a choice, a list of numbers, or a pint quantity."""


class Progress(NamedTuple):
    """Progress of a run."""

    stage: str
    """Current stage, such as "structures", "positions" or "errors"."""
    done: int
    """Number of solved positions."""
    total: int | None
    """Number of positions to solve; None in other stages."""


ProgressOption = Union[bool, Callable[[Progress], object], None]


@dataclass(frozen=True)
class Param:
    """Input of a model."""

    name: str
    doc: str
    kind: str
    """"number", "integer", "bool", "text" or "array"."""
    unit: str
    """Unit of the default; empty for a pure number."""
    default: Any
    """Default in this unit; None if it cannot be computed."""
    low: float | None
    """Smallest value in this unit; None if unlimited."""
    high: float | None
    """Largest value in this unit; None if unlimited."""
    choices: tuple[str, ...]
    """Accepted texts; empty if any text is accepted."""
    independent: bool
    """True if default and range do not depend on other params."""
    _factor: float = field(repr=False)
    _dimension: Any = field(repr=False)

    @property
    def bounds(self) -> tuple[float, float]:
        """Smallest and largest value, as for `scipy.optimize`; infinite if unlimited."""
        low = float("-inf") if self.low is None else self.low
        return low, float("inf") if self.high is None else self.high


@dataclass(frozen=True)
class Output:
    """Output of a model."""

    name: str
    doc: str
    unit: str
    """Unit of its values; empty for a pure number."""
    si_unit: str
    """Coherent SI unit."""
    is_array: bool
    """True for an array, whose elements are outputs of a run: `name[0]`."""
    choices: tuple[str, ...]
    """Choices of an enumeration that the values number from 0; empty for other numbers."""


class _Table(Mapping[str, Any]):
    """Read-only mapping that notebooks show as a table."""

    def __init__(self, items: dict[str, Any], columns: Sequence[str]) -> None:
        self._items = MappingProxyType(items)
        self._columns = columns

    def __getitem__(self, name: str) -> Any:
        return self._items[name]

    def __iter__(self) -> Any:
        return iter(self._items)

    def __len__(self) -> int:
        return len(self._items)

    def __repr__(self) -> str:
        return "\n".join(repr(item) for item in self._items.values())

    def _repr_html_(self) -> str:
        rows = [[getattr(item, column) for column in self._columns] for item in self._items.values()]
        return html_table(self._columns, rows)


class Model:
    """Compiled model. Create it with `calyx.load`. It is immutable, and any thread may use it.

    A pickled model contains its machine code: unpickle only what you trust, and use the same version
    of Calyx on the same kind of machine.
    """

    def __init__(self, raw: _calyx.Model) -> None:
        self._raw = raw
        description = json.loads(raw.describe())
        self.name: str = description["name"]
        self.doc: str = description["doc"]
        params = {param["name"]: _param(param) for param in description["params"]}
        outputs = {output["name"]: _output(output) for output in description["outputs"]}
        self._params: Mapping[str, Param] = _Table(
            params, ["name", "default", "unit", "low", "high", "choices", "doc"]
        )
        self._outputs: Mapping[str, Output] = _Table(outputs, ["name", "unit", "doc"])
        self._pickled: bytes | None = None

    @property
    def params(self) -> Mapping[str, Param]:
        """Params by name, with units, ranges, defaults and docs."""
        return self._params

    @property
    def outputs(self) -> Mapping[str, Output]:
        """Outputs by name, as the model declares them."""
        return self._outputs

    @property
    def source(self) -> str:
        """Text of the model's own file."""
        return self._raw.source()

    @property
    def diagnostics(self) -> str:
        """Warnings of the check, and errors of the gears at the default params; empty if there are
        none."""
        return self._raw.diagnostics()

    def values(self, params: Mapping[str, Value] | None = None, /, **named: Value) -> dict[str, Any]:
        """Returns the values that all params have in a run with these, in the units of their defaults.

        Raises ParamError for an unknown name, a wrong unit or a value out of range.
        """
        return dict(self._raw.values(self._assignments(params, named)))

    def run(
        self,
        params: Mapping[str, Value] | None = None,
        /,
        *,
        fidelity: str | None = None,
        error_estimates: str | None = None,
        settings: Mapping[str, Any] | None = None,
        fields: bool | str = False,
        threads: int = 0,
        time_limit: float | None = None,
        memory_limit: int | None = None,
        progress: ProgressOption = None,
        print: Callable[[str], object] | None = None,
        cancel: Cancel | None = None,
        host: Mapping[str, Callable[..., Any]] | None = None,
        sensitivities: Iterable[str] = (),
        sensitivities_of: Iterable[str] = (),
        **named: Value,
    ) -> Results:
        """Solves the model and returns its results.

        Params are given as keywords, or in a mapping if a name is not an identifier or is that of an
        option. A value is a number in the unit of the param's default, a text such as "120 N*m", a
        tuple (120, "N*m"), a Boolean, a choice, a list, or a pint quantity.

        Args:
            fidelity: Level that overrides that of the model: "rigid", "analytic", "plane", "medium",
                "thinrim", "fineroot" or "finest".
            error_estimates: "none", "cheap" or "full".
            settings: Other settings that override those of the analysis, by the names of the options
                of `calyx run`: {"contact_cells": 12}.
            fields: True keeps contact pressure, line loads and fillet stresses of every position;
                "bodies" also the meshes of elastic bodies with displacements and stresses.
            threads: Number of threads; 0 is that of `calyx.configure`. The results do not depend on it.
            time_limit: Seconds.
            memory_limit: Bytes, of the whole process during the analysis.
            progress: True shows the progress; a function is called with each `Progress`.
            print: Function that receives each line that the model prints; they are also in
                `Results.printed`.
            cancel: Handle that cancels the run from another thread.
            host: Functions that replace host functions of the model, by name. Numbers are in SI units;
                vectors and arrays are lists. Threads of the run call them one at a time.
            sensitivities: Names of params with respect to which outputs are differentiated, see
                `Results.sensitivities`. Without names, those that the model requests.
            sensitivities_of: Names of the outputs that `sensitivities` differentiates; fewer take
                less time. Without names, all.

        Raises:
            ParamError: a param, unit or setting is wrong, or a value is out of range.
            RunError: the model cannot be built or solved with these params, a limit was reached
                (LimitError), or the run was cancelled (CancelledError).
            KeyboardInterrupt: Ctrl-C ends the run.
        """
        if fields not in (False, True, "bodies"):
            raise ValueError(f'fields is {fields!r}: give True, False or "bodies"')
        overrides = dict(settings or {})
        for name, value in (("fidelity", fidelity), ("error_estimates", error_estimates)):
            if value is not None:
                overrides[name] = value
        printed: list[str] = []

        def keep(line: str) -> None:
            printed.append(line)
            if print is not None:
                print(line)

        display = _Display(progress)
        options = {
            "overrides": [(name, _text(value)) for name, value in overrides.items()],
            "threads": threads,
            "time_limit": time_limit,
            "memory_limit": memory_limit,
            "fields": 2 if fields == "bodies" else int(fields),
            "progress": display.callback,
            "print": keep,
            "cancel": cancel,
            "host": list((host or {}).items()),
            "sensitivities": [str(name) for name in sensitivities],
            "sensitivities_of": [str(name) for name in sensitivities_of],
        }
        try:
            raw = self._raw.run(self._assignments(params, named), options)
        finally:
            display.close()
        return Results(raw, printed)

    def value_and_gradient(
        self,
        objective: str,
        params: Mapping[str, Value],
        /,
        *,
        by: Iterable[str] | None = None,
        **options: Any,
    ) -> tuple[float, dict[str, float]]:
        """Returns a statistic of an output, and its derivatives with respect to params.

        Args:
            objective: Output with a statistic, such as "transmission_error.peak_to_peak"; without a
                statistic, the largest value.
            params: Values of params, as for `run`.
            by: Names of the params of the gradient; by default those in `params`.
            options: Those of `run`.

        The value is in the unit of the output, and a derivative is per unit of the param's default. At
        a kink it is the mean of both sides; `Results.sensitivities` has both, and estimated errors.

        Raises:
            ParamError: a param takes no decimal numbers, or there is no such output.
            RunError: no derivative with respect to a param exists.
        """
        names = [str(name) for name in (params if by is None else by)]
        # An objective is an output, or an output with a statistic. Elements of arrays are known after
        # the run.
        of = [name for name in (objective, objective.rpartition(".")[0]) if name in self._outputs]
        results = self.run(params, sensitivities=names, sensitivities_of=of, **options)
        return results.value(objective), results.gradient(objective)

    def run_many(
        self,
        cases: Iterable[Mapping[str, Value]],
        *,
        parallel: int | None = None,
        on_error: str = "raise",
        progress: ProgressOption = None,
        **options: Any,
    ) -> Sweep:
        """Solves the model for many cases, several at a time, and returns the results in their order.

        `cases` are mappings of params, or the rows of a table. `parallel` is the number of cases
        that are solved at the same time, by default the number of cores; cases of equal geometry
        share their structures. With `on_error="return"`, a `Failure` takes the place of results that
        could not be computed. Other options are those of `run`; a keyword that names a param sets it
        in all cases.
        """
        from calyx._sweep import run_many

        return run_many(self, cases, parallel, on_error, progress, options)

    def sweep(
        self,
        axes: Mapping[str, Iterable[Value]] | None = None,
        /,
        *,
        parallel: int | None = None,
        on_error: str = "raise",
        progress: ProgressOption = None,
        **options: Any,
    ) -> Sweep:
        """Solves the model for all combinations of values: `sweep({"torque": [100, 200, 300]})`.

        Options are those of `run_many`.
        """
        from calyx._sweep import combinations, run_many

        return run_many(self, combinations(axes or {}), parallel, on_error, progress, options)

    def _assignments(
        self, params: Mapping[str, Value] | None, named: Mapping[str, Value]
    ) -> list[tuple[str, object]]:
        both = set(params or ()) & set(named)
        if both:
            raise TypeError(f"given twice: {', '.join(sorted(both))}")
        everything = {**(params or {}), **named}
        return [
            (str(name), assigned(self._params.get(str(name)), value)) for name, value in everything.items()
        ]

    def __repr__(self) -> str:
        return f"<calyx.Model {self.name}: {len(self._params)} params, {len(self._outputs)} outputs>"

    def _repr_html_(self) -> str:
        params, outputs = self._params, self._outputs
        assert isinstance(params, _Table) and isinstance(outputs, _Table)
        return html_table(["model"], [[self.name], [self.doc]]) + params._repr_html_() + outputs._repr_html_()

    def __reduce__(self) -> tuple[Callable[[bytes], Model], tuple[bytes]]:
        if self._pickled is None:
            self._pickled = self._raw.serialize()
        return _unpickled, (self._pickled,)


# Models of this process by the hash of their pickle: the tasks of a cluster send the same model many
# times.
_UNPICKLED: OrderedDict[bytes, Model] = OrderedDict()
_MOST_UNPICKLED = 16


def _unpickled(data: bytes) -> Model:
    key = hashlib.sha256(data).digest()
    model = _UNPICKLED.get(key)
    if model is None:
        model = Model(_calyx.Model.deserialize(data))
        model._pickled = data
        _UNPICKLED[key] = model
        while len(_UNPICKLED) > _MOST_UNPICKLED:
            _UNPICKLED.popitem(last=False)
    return model


def load(model: str | os.PathLike[str], /, *, allow: Iterable[str | os.PathLike[str]] = ()) -> Model:
    """Compiles the model in a file, or one given as text.

    A string with a line break or a semicolon is a text. A model may read files in its folder, and the
    files and directories `allow`.

    Raises:
        ModelError: the model has errors; the exception has the diagnostics with source lines.
        FileNotFoundError, OSError: the file cannot be read.
    """
    if isinstance(model, str) and any(mark in model for mark in "\n;"):
        return loads(model)
    return Model(_calyx.Model.of_file(os.fspath(model), [os.fspath(path) for path in allow]))


def loads(text: str, /, name: str = "model.cx") -> Model:
    """Compiles a model given as text, which can import the library only. `name` is its file name in
    messages.

    Raises:
        ModelError: the model has errors.
    """
    return Model(_calyx.Model.of_text(name, text))


def _param(described: dict[str, Any]) -> Param:
    unit = described["unit"]
    return Param(
        name=described["name"],
        doc=described["doc"],
        kind=described["kind"],
        unit=unit["name"],
        default=described["default"],
        low=described["low"],
        high=described["high"],
        choices=tuple(described["choices"]),
        independent=described["independent"],
        _factor=unit["factor"],
        _dimension=unit["dimension"],
    )


def _output(described: dict[str, Any]) -> Output:
    return Output(
        name=described["name"],
        doc=described["doc"],
        unit=described["unit"]["name"],
        si_unit=described["si"],
        is_array=described["is_array"],
        choices=tuple(described["choices"]),
    )


def _text(value: object) -> str:
    """Formats the value of a setting as after an option of the command."""
    if isinstance(value, bool):
        raise ParamError(f"a setting cannot be {value}", help="give a number or a text")
    return str(value)


class _Display:
    """Display of the progress of a run: tqdm if it is installed, or lines on standard error."""

    def __init__(self, progress: ProgressOption) -> None:
        self._bar: Any = None
        self._shown: str = ""
        self.callback: Callable[[str, int, int | None], object] | None = None
        if callable(progress):
            function = progress
            self.callback = lambda stage, done, total: function(Progress(stage, done, total))
        elif progress:
            self.callback = self._show

    def _show(self, stage: str, done: int, total: int | None) -> None:
        try:
            from tqdm.auto import tqdm
        except ImportError:
            text = stage if total is None else f"{stage} {done}/{total}"
            if text != self._shown:
                self._shown = text
                sys.stderr.write(f"\r{text}\x1b[K")
            return
        if self._bar is None:
            self._bar = tqdm()
        self._bar.set_description(stage, refresh=False)
        self._bar.total = total
        self._bar.n = done
        self._bar.refresh()

    def close(self) -> None:
        if self._bar is not None:
            self._bar.close()
        if self._shown:
            sys.stderr.write("\r\x1b[K")
