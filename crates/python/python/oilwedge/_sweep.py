"""Sweeps: one scene for many values of its keys."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Optional

from . import _native
from ._run import asked
from ._scene import AnyScene, Scene, scene_of
from ._table import Table
from ._types import StrPath


def swept(scene: AnyScene, axes: Optional[Mapping[str, Any]], columns: Optional[Sequence[str]]) -> Scene:
    """The scene with these axes, or with its own."""
    own = scene_of(scene)
    if axes is None:
        if columns is not None:
            raise ValueError("columns are given without axes; give both, or neither where the scene has a [sweep]")
        return own
    table = dict(axes)
    if columns is not None:
        table["columns"] = list(columns)
    return Scene._of(own._scene.with_axes(table))


def sweep(
    scene: AnyScene,
    axes: Optional[Mapping[str, Any]] = None,
    *,
    columns: Optional[Sequence[str]] = None,
    bars: bool = True,
    max_seconds: Optional[float] = None,
    max_unknowns: int = 1_000_000,
    threads: Optional[int] = None,
    out: Optional[StrPath] = None,
    fresh: bool = False,
) -> Table:
    """Solves a scene for all combinations of the values of its axes, as ``oilwedge sweep`` does.

    Other threads of Python run meanwhile, and Ctrl-C ends it.

    axes
        Keys as below ``[sweep]`` and their values: a list, an array, or a range ``{"from": "1 kN", "to": "9 kN",
        "steps": 9}``; the last axis runs fastest. Without them the scene's own.
    columns
        The quantities of the table, each with its unit, as ``"h_min um"``; by default all.
    bars, max_seconds, max_unknowns
        As of ``solve``, for each case.
    threads
        Number of threads; by default one for each core. Results do not depend on it.
    out
        Folder to which rows are written as cases end, with ``sweep.csv`` and ``sweep.json``. Rows that stand there from
        the same sweep are kept.
    fresh
        Replace what stands in that folder.

    Raises ``SceneError`` where a case cannot be used. Cases without an answer are rows with their reason.
    """
    own = swept(scene, axes, columns)
    how = asked(own, bars=bars, max_seconds=max_seconds, max_unknowns=max_unknowns, threads=threads)
    return Table(*_native.sweep(own._scene, how, None if out is None else Path(out), fresh))
