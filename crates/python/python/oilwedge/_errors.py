"""Exceptions: what is wrong with a scene or a mesh, and results that are no answers."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, NamedTuple, Optional

if TYPE_CHECKING:
    from ._result import Result


class Complaint(NamedTuple):
    """One thing that is wrong with a scene."""

    key: str
    """The key with its tables, as ``journal.speed``; empty for a fault of the TOML itself."""
    value: str
    """The value as it is written; empty where there is none."""
    message: str
    """What is wrong, as the end of a sentence that begins with the key."""
    help: str
    """The way out."""
    span: Optional[tuple[int, int]]
    """Letters of the scene's text that are meant, from and to."""


class OilwedgeError(Exception):
    """Every exception of this package, but for those of Python itself."""


class SceneError(OilwedgeError, ValueError):
    """The scene cannot be used. ``complaints`` has everything that is wrong with it, each with the way out."""

    complaints: tuple[Complaint, ...]

    def __init__(self, message: str, complaints: Iterable[tuple[str, str, str, str, Optional[tuple[int, int]]]] = ()) -> None:
        self.complaints = tuple(Complaint(*complaint) for complaint in complaints)
        super().__init__(message, self.complaints)

    def __str__(self) -> str:
        return str(self.args[0])


class MeshError(OilwedgeError, ValueError):
    """The mesh cannot be used, does not fit the scene, or cannot be made."""


class _WithResult(OilwedgeError):
    """A result that is no answer."""

    result: Result

    def __init__(self, message: str, result: Result) -> None:
        self.result = result
        super().__init__(message, result)

    def __str__(self) -> str:
        return str(self.args[0])


class NoSolution(_WithResult):
    """The problem has no solution; the message says why. ``result`` has no quantities and no film."""


class NotConverged(_WithResult):
    """A solution was not reached, or not to its tolerance. ``result`` has what was reached, with its error bars."""


class InternalError(OilwedgeError):
    """The program has failed. Please report the scene."""


for _class in (Complaint, OilwedgeError, SceneError, MeshError, NoSolution, NotConverged, InternalError):
    _class.__module__ = "oilwedge"
