"""Solving a scene."""

from __future__ import annotations

import math
import operator
import warnings
from collections.abc import Sequence
from typing import Optional, SupportsIndex

from . import _native
from ._errors import NoSolution, NotConverged
from ._result import Result
from ._scene import AnyScene, Scene, scene_of
from ._types import Asked

ADD_ONS = ("cost", "standard", "theories", "mobility")


def asked(
    scene: Scene,
    *,
    bars: bool,
    max_seconds: Optional[float],
    max_unknowns: int,
    threads: Optional[int],
    unrolled: bool = False,
    sensitivity: bool = False,
) -> Asked:
    """How a scene is run, where that can be."""
    if not bars and scene._scene.gives_tolerance:
        raise ValueError(
            "bars=False conflicts with the mesh.tolerance of the scene: a tolerance is met by error bars; leave out bars=False, or remove tolerance from [mesh]"
        )
    if max_seconds is not None and not (isinstance(max_seconds, (int, float)) and 0 < max_seconds < math.inf):
        raise ValueError(f"max_seconds={max_seconds!r}: a number of seconds above zero is wanted")
    max_unknowns = _whole("max_unknowns", max_unknowns, 1 << 62)
    threads = None if threads is None else _whole("threads", threads, 1024)
    return {
        "bars": bars,
        "max_seconds": max_seconds,
        "max_unknowns": max_unknowns,
        "unrolled": unrolled,
        "sensitivity": sensitivity,
        "threads": threads,
    }


def _whole(name: str, value: SupportsIndex, most: int) -> int:
    """A whole number from 1 to ``most``."""
    try:
        number = operator.index(value)
    except TypeError:
        number = 0
    if not 1 <= number <= most:
        raise ValueError(f"{name}={value!r}: a whole number from 1 to {most} is wanted")
    return number


def solve(
    scene: AnyScene,
    *,
    bars: bool = True,
    max_seconds: Optional[float] = None,
    max_unknowns: int = 1_000_000,
    unrolled: bool = False,
    sensitivity: bool = False,
    add_ons: Sequence[str] = (),
    threads: Optional[int] = None,
) -> Result:
    """Solves a scene, as ``oilwedge solve`` does, and writes nothing.

    Other threads of Python run meanwhile, and Ctrl-C ends it.

    bars
        Estimate error bars.
    max_seconds
        Time limit of the refinement towards a tolerance and of the search for a position; 60 s with a tolerance, else
        none.
    max_unknowns
        Most unknowns of meshes that are refined towards a tolerance.
    unrolled
        Points of the film are on the unrolled liner, x = R phi and y = z, instead of on the cylinder.
    sensitivity
        Find how all quantities change with each number of the scene: ``result.sensitivity("h_min")``. Numbers with
        tolerances have it without being asked, and ``result.spread`` too.
    add_ons
        What stands beside the film in ``to_dict()`` and in the tables: ``cost``, ``standard``, ``theories``,
        ``mobility``.
    threads
        Number of threads; by default one for each core. Results do not depend on it.

    Raises ``SceneError`` or ``MeshError`` where the scene cannot be used; ``NoSolution`` or ``NotConverged``, with the
    result, where there is no answer.
    """
    own = scene_of(scene)
    unknown = [name for name in add_ons if name not in ADD_ONS]
    if unknown:
        raise ValueError(f'add_ons: "{unknown[0]}" is not known; there are {", ".join(ADD_ONS)}')
    how = asked(
        own,
        bars=bars,
        max_seconds=max_seconds,
        max_unknowns=max_unknowns,
        threads=threads,
        unrolled=unrolled,
        sensitivity=sensitivity,
    )
    found, reasons = _native.solve(own._scene, how, list(add_ons))
    for reason in reasons:
        warnings.warn(reason, stacklevel=2)
    result = Result(own, *found)
    if result.status == "no_solution":
        raise NoSolution(result.reason or "there is no solution", result)
    if result.status == "not_converged":
        raise NotConverged(result.reason or "not converged", result)
    return result
