"""Values of params for the extension module, and pint."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

import numpy as np

from calyx.errors import ParamError

if TYPE_CHECKING:
    from calyx._model import Param

Unit = tuple[str, float, Any]
"""Name, SI value, and exponents of length, mass, time, angle and temperature, each as numerator and
denominator."""

_BASES = ("meter", "kilogram", "second", "radian", "kelvin")


def assigned(param: Param | None, value: object) -> object:
    """Converts a value of a param to one that the extension module accepts."""
    if isinstance(value, (bool, int, float, str)):
        return value
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, tuple) and len(value) == 2 and isinstance(value[1], str):
        return (float(value[0]), value[1])
    if hasattr(value, "magnitude") and hasattr(value, "units"):
        return _of_quantity(param, value)
    if isinstance(value, np.ndarray):
        return [float(element) for element in value] if value.ndim else value.item()
    if isinstance(value, (list, tuple)):
        return [assigned(param, element) for element in value]
    if hasattr(value, "__float__"):
        return float(value)
    return value


def _of_quantity(param: Param | None, quantity: Any) -> object:
    """Converts a pint quantity to a number in the unit of the param's default."""
    if param is None:
        return (float(quantity.magnitude), f"{quantity.units:~}")
    if not param.unit:
        return _numbers(quantity.to("dimensionless").magnitude)
    registry = quantity._REGISTRY
    try:
        name, is_si = pint_unit(registry, (param.unit, param._factor, param._dimension))
        magnitude = quantity.to(name).magnitude
    except Exception as error:
        if type(error).__name__ != "DimensionalityError":
            raise
        raise ParamError(
            f"`{param.name}` cannot be {quantity}: that is another kind of quantity",
            help=f"`{param.name}` is in {param.unit}",
        ) from None
    numbers = _numbers(magnitude)
    if not is_si:
        return numbers
    return [{"si": number} for number in numbers] if isinstance(numbers, list) else {"si": numbers}


def _numbers(magnitude: Any) -> float | list[float]:
    array = np.asarray(magnitude, dtype=float)
    return [float(number) for number in array] if array.ndim else float(array)


def pint_unit(registry: Any, unit: Unit) -> tuple[Any, bool]:
    """Returns the unit of a pint registry, and whether it is the coherent SI unit because the registry
    has no unit of this name."""
    name, factor, dimension = unit
    if not name:
        return registry.dimensionless, False
    si = _si_unit(registry, dimension)
    try:
        own = registry.parse_units(name.replace("^", "**"))
        # A registry may define another unit with this name.
        if abs(registry.Quantity(1.0, own).to(si).magnitude / factor - 1.0) < 1e-9:
            return own, False
    except Exception:  # The exceptions for unknown names and dimensions depend on pint's version.
        pass
    return si, True


def _si_unit(registry: Any, dimension: Any) -> Any:
    unit = registry.dimensionless
    for base, (numerator, denominator) in zip(_BASES, dimension):
        if numerator:
            unit = unit * getattr(registry, base) ** (numerator / denominator)
    return unit


def application_registry() -> Any:
    """Returns the unit registry of the program."""
    try:
        pint: Any = import_module("pint")
    except ImportError:
        raise ImportError("quantities need pint: install it with `pip install pint`") from None
    return pint.get_application_registry()
