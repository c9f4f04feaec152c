"""Exceptions. Each has a message, a code that `calyx explain` describes, a remedy, and a text with
the source lines concerned, which is what Python prints."""

from __future__ import annotations

import difflib
from collections.abc import Iterable


class CalyxError(Exception):
    """Error of a model, a param or a run."""

    message: str
    """The problem in one sentence."""
    code: str
    """Code such as `E0603`, which `calyx explain` describes; empty if there is none."""
    help: str
    """Remedy; empty if there is none."""
    rendered: str
    """The problem with the source lines concerned."""

    def __init__(self, message: str, code: str = "", help: str = "", rendered: str = "") -> None:
        # All arguments are in `args`, so that pickles of exceptions are complete.
        super().__init__(message, code, help, rendered)
        self.message = message
        self.code = code
        self.help = help
        self.rendered = rendered or message

    def __str__(self) -> str:
        # The type of the exception is on the first line of a traceback.
        return "\n" + self.rendered.rstrip() if "\n" in self.rendered.rstrip() else self.rendered.rstrip()


class ModelError(CalyxError):
    """The model cannot be compiled, or a pickled model belongs to another version of Calyx."""


class ParamError(CalyxError, ValueError):
    """There is no such param, output, setting or unit, or the value is out of range."""


class RunError(CalyxError):
    """The model cannot be built or solved with these params."""


class CancelledError(RunError):
    """The run was cancelled by a `Cancel`."""


class LimitError(RunError):
    """The run exceeded its time or memory limit."""


class InternalError(CalyxError):
    """A defect of Calyx, or a resource that the machine refused."""


class DirectoryError(CalyxError, OSError):
    """Results cannot be written to the directory."""

    # OSError formats its own arguments.
    __str__ = CalyxError.__str__


def _unknown(what: str, name: str, known: Iterable[str]) -> ParamError:
    """Returns the error for a name that does not exist."""
    names = list(known)
    near = difflib.get_close_matches(name, names, n=1)
    help = f"did you mean `{near[0]}`?" if near else f"the {what}s are {', '.join(names)}"
    message = f"there is no {what} `{name}`"
    return ParamError(message, "", help, f"{message}\n  help: {help}")
