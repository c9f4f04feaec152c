"""Many cases of a model, several at a time."""

from __future__ import annotations

import itertools
import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Union

import numpy as np

from calyx._calyx import Cancel
from calyx._results import STATISTICS, Results
from calyx._tables import html_table, table
from calyx.errors import CalyxError

if TYPE_CHECKING:
    from calyx._model import Model, ProgressOption, Value


@dataclass(frozen=True)
class Failure:
    """Case that could not be solved."""

    error: CalyxError


Outcome = Union[Results, Failure]


class Sweep(Sequence[Outcome]):
    """Results of many cases, in the order of the cases."""

    def __init__(self, cases: list[dict[str, Value]], outcomes: list[Outcome]) -> None:
        self.cases = cases
        """Params of each case, as they were given."""
        self._outcomes = outcomes

    def __getitem__(self, index: Any) -> Any:
        return self._outcomes[index]

    def __len__(self) -> int:
        return len(self._outcomes)

    def __iter__(self) -> Iterator[Outcome]:
        return iter(self._outcomes)

    @property
    def failures(self) -> dict[int, CalyxError]:
        """Errors of the cases that could not be solved, by index."""
        found = enumerate(self._outcomes)
        return {index: outcome.error for index, outcome in found if isinstance(outcome, Failure)}

    def frame(self, engine: str | None = None, *, statistics: Sequence[str] = STATISTICS) -> Any:
        """Returns a table with a row for each case: its params, and columns such as
        `transmission_error.max`. A case without results has NaN, and its error in the column
        `error`."""
        columns, units = self._columns(statistics)
        return table(columns, units, engine)

    def _columns(self, statistics: Sequence[str]) -> tuple[dict[str, Any], dict[str, str]]:
        names = list(dict.fromkeys(name for case in self.cases for name in case))
        solved = [outcome for outcome in self._outcomes if isinstance(outcome, Results)]
        columns: dict[str, Any] = {}
        for name in names:
            # A value that was set is the one of the run, in the unit of its param.
            values = [
                outcome.params[name] if isinstance(outcome, Results) else case.get(name)
                for outcome, case in zip(self._outcomes, self.cases)
            ]
            columns[name] = _column(values)
        units: dict[str, str] = {}
        if solved:
            units.update({name: unit for name, unit, _ in solved[0]._data["params"] if name in columns})
        for output in dict.fromkeys(name for results in solved for name in results):
            for statistic in statistics:
                values = [_statistic(outcome, output, statistic) for outcome in self._outcomes]
                columns[f"{output}.{statistic}"] = np.array(values)
                units[f"{output}.{statistic}"] = next(r[output].unit for r in solved if output in r)
        if self.failures:
            errors = self.failures
            columns["error"] = [errors[i].message if i in errors else "" for i in range(len(self))]
        return columns, units

    def __repr__(self) -> str:
        return f"<calyx.Sweep: {len(self)} cases, {len(self.failures)} failed>"

    def _repr_html_(self) -> str:
        columns, _ = self._columns(("min", "max"))
        rows = list(zip(*(list(column) for column in columns.values())))
        return html_table(list(columns), [list(row) for row in rows[:60]])


def _column(values: list[Any]) -> list[Any]:
    """Returns the values of a param over the cases as values of one type. In a column of numbers, the
    text of a case without results is NaN."""
    if len({type(value) for value in values}) <= 1:
        return values
    if any(isinstance(value, float) for value in values):
        return [
            float(value) if isinstance(value, (int, float, np.number)) else float("nan") for value in values
        ]
    return [str(value) for value in values]


def _statistic(outcome: Outcome, output: str, statistic: str) -> float:
    if isinstance(outcome, Failure) or output not in outcome:
        return float("nan")
    return float(getattr(outcome[output], statistic))


def combinations(axes: Mapping[str, Iterable[Value]]) -> Iterator[dict[str, Value]]:
    """Returns all combinations of values; the last name varies fastest. A text is one value."""
    for name, axis in axes.items():
        if isinstance(axis, str) or not isinstance(axis, Iterable):
            raise TypeError(f"`{name}` is varied over {axis!r}: give a list of values, like [{axis!r}]")
    values = [list(axis) for axis in axes.values()]
    return (dict(zip(axes, combination)) for combination in itertools.product(*values))


def rows(cases: Any) -> list[dict[str, Value]]:
    """Returns cases as dictionaries: mappings, or the rows of a table of pandas, polars or Arrow."""
    for method, arguments in (("to_dicts", ()), ("to_pylist", ()), ("to_dict", ("records",))):
        if hasattr(cases, method) and not isinstance(cases, Mapping):
            cases = getattr(cases, method)(*arguments)
            break
    cases = list(cases)
    if wrong := next((case for case in cases if not isinstance(case, Mapping)), None):
        raise TypeError(
            f"{wrong!r} is no case: give mappings of params, like [{{'torque': 100}}], or a table"
        )
    return [{str(name): value for name, value in case.items()} for case in cases]


def run_many(
    model: Model,
    cases: Any,
    parallel: int | None,
    on_error: str,
    progress: ProgressOption,
    options: dict[str, Any],
) -> Sweep:
    """Solves cases on several threads. Errors and Ctrl-C cancel those in progress."""
    from calyx._model import _Display

    if on_error not in ("raise", "return"):
        raise ValueError(f'on_error is {on_error!r}: give "raise" or "return"')
    all_cases = rows(cases)
    outcomes: list[Outcome | None] = [None] * len(all_cases)
    above = options.pop("cancel", None)
    cancel = Cancel() if above is None else above.child()
    display = _Display(progress)

    def solve(case: dict[str, Value]) -> Outcome:
        try:
            return model.run(case, cancel=cancel, **options)
        except CalyxError as error:
            if on_error == "raise" or cancel.cancelled:
                raise
            return Failure(error)

    with ThreadPoolExecutor(parallel or os.cpu_count() or 1) as pool:
        waiting: dict[Future[Outcome], int] = {
            pool.submit(solve, case): index for index, case in enumerate(all_cases)
        }
        try:
            while waiting:
                done, _ = wait(waiting, return_when=FIRST_COMPLETED)
                for future in done:
                    outcomes[waiting.pop(future)] = future.result()
                if display.callback is not None:
                    display.callback("cases", len(all_cases) - len(waiting), len(all_cases))
        except BaseException:
            for future in waiting:
                future.cancel()
            cancel.cancel()
            raise
        finally:
            display.close()
    return Sweep(all_cases, [outcome for outcome in outcomes if outcome is not None])
