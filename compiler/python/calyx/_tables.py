"""Tables of columns: pandas, polars and Arrow, from NumPy arrays; and HTML."""

from __future__ import annotations

import html
from collections.abc import Mapping, Sequence
from importlib import import_module
from typing import Any

import numpy as np

ENGINES = ("pandas", "polars", "arrow")
_MODULES = {"pandas": "pandas", "polars": "polars", "arrow": "pyarrow"}


def table(columns: Mapping[str, Any], units: Mapping[str, str], engine: str | None) -> Any:
    """Creates a table. Columns are arrays or lists of texts; numbers are not copied if the engine
    permits it. `units` are metadata of columns: `DataFrame.attrs["units"]` in pandas, the metadata
    of fields in Arrow. polars has none."""
    engine, module = _module(engine)
    if engine == "pandas":
        frame = module.DataFrame(dict(columns))
        frame.attrs["units"] = dict(units)
        return frame
    if engine == "polars":
        return module.DataFrame(dict(columns))
    arrays = [module.array(column) for column in columns.values()]
    fields = [
        module.field(name, array.type, metadata={"unit": units[name]} if units.get(name) else None)
        for name, array in zip(columns, arrays)
    ]
    return module.Table.from_arrays(arrays, schema=module.schema(fields))


def arrow_stream(columns: Mapping[str, Any], units: Mapping[str, str], requested_schema: object) -> object:
    """Exports a table by the Arrow C stream interface of pyarrow or polars."""
    for engine in ("arrow", "polars"):
        try:
            exported = table(columns, units, engine)
        except ImportError:
            continue
        return exported.__arrow_c_stream__(requested_schema)
    raise ImportError("Arrow needs pyarrow or polars: install one with `pip install pyarrow`")


def _module(engine: str | None) -> tuple[str, Any]:
    if engine is None:
        for candidate in ENGINES:
            try:
                return candidate, import_module(_MODULES[candidate])
            except ImportError:
                continue
        raise ImportError("tables need pandas, polars or pyarrow: install one with `pip install pandas`")
    if engine not in ENGINES:
        raise ValueError(f"engine is {engine!r}: give one of {', '.join(ENGINES)}")
    try:
        return engine, import_module(_MODULES[engine])
    except ImportError:
        name = _MODULES[engine]
        raise ImportError(f"this table needs {name}: install it with `pip install {name}`") from None


def html_table(columns: Sequence[str], rows: Sequence[Sequence[object]]) -> str:
    """Formats a table for notebooks."""
    head = "".join(f"<th>{html.escape(column.replace('_', ' '))}</th>" for column in columns)
    body = "".join(
        "<tr>" + "".join(f"<td>{html.escape(_shown(cell))}</td>" for cell in row) + "</tr>" for row in rows
    )
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def _shown(cell: object) -> str:
    if cell is None:
        return ""
    if isinstance(cell, float):
        return "–" if np.isnan(cell) else f"{cell:.4g}"
    if isinstance(cell, tuple):
        return ", ".join(str(element) for element in cell)
    return str(cell)
