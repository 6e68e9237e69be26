"""Sweeps on a cluster of Dask: a task is one chain of neighbouring cases or a few short ones, and becomes a file of
Parquet when it ends.

Chains are those of ``oilwedge sweep``, so the table is the same, to the last digit, however many workers there are.
Every part is gathered when it ends, written by rename, and released: no part is computed twice because a worker dies,
and a sweep that was ended, also by the death of the client, goes on where it was.
"""

from __future__ import annotations

import csv
import ctypes
import functools
import hashlib
import io
import json
import os
import tempfile
import threading
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Optional

import numpy as np

from . import _native
from ._errors import OilwedgeError
from ._optional import needed
from ._run import asked
from ._scene import AnyScene, Scene
from ._sweep import swept
from ._table import Table, typed_columns
from ._types import Asked, StrPath

if TYPE_CHECKING:
    import pyarrow
    from distributed import Client

_IDENTITY = b"oilwedge"
"""Key of what a part was computed from, in the metadata of its file."""
_CASES = 16
"""Cases that a task has at least, where chains are shorter."""


@dataclass(frozen=True)
class _Packed:
    """A sweep as it travels: its scene, the files that this names by their names alone, and how cases are run."""

    text: str
    files: dict[str, bytes]
    asked: Asked
    parts: int

    @functools.cached_property
    def key(self) -> str:
        """What tells it from all others."""
        content = repr((self.text, sorted((name, hashlib.sha256(data).hexdigest()) for name, data in self.files.items()), self.asked))
        return hashlib.sha256(content.encode()).hexdigest()[:16]


def sweep(
    scene: AnyScene,
    axes: Optional[Mapping[str, Any]],
    client: Client,
    *,
    out: StrPath,
    columns: Optional[Sequence[str]] = None,
    bars: bool = True,
    max_seconds: Optional[float] = None,
    max_unknowns: int = 1_000_000,
    threads: Optional[int] = 1,
) -> Table:
    """Solves a scene for all combinations of the values of its axes on the workers of ``client``.

    The folder ``out`` gets ``part-000123.parquet`` for each part as it ends, and in the end ``table.parquet``, ordered
    by case. Parts that stand there are not computed again. Mesh files travel with the scene. A part that ends more
    workers than the scheduler allows (three), also when it is computed alone, gives rows of status ``failed``; all
    others are computed.

    axes, columns, bars, max_seconds, max_unknowns
        As of ``oilwedge.sweep``.
    threads
        Threads of each task.

    Raises ``OilwedgeError`` where workers have another version of oilwedge, ``ValueError`` where the folder holds parts
    of another sweep.
    """
    distributed = needed("distributed", "oilwedge.dask.sweep()")
    needed("pyarrow", "oilwedge.dask.sweep()")
    own = _packed_scene(swept(scene, axes, columns))
    how = asked(own[0], bars=bars, max_seconds=max_seconds, max_unknowns=max_unknowns, threads=threads)
    folder = Path(out)
    with tempfile.TemporaryDirectory() as local:
        cases = _cases(own[0].text, own[1], Path(local))
        packed = _Packed(own[0].text, own[1], how, max(1, min(cases.chains, cases.count // _CASES)))
        parts = _Parts(folder, packed, cases)
        missing = parts.missing()
        if missing:
            _check_versions(client.run(_native.version))
            suspicious = _run(distributed, client, packed, missing, parts)
            for number in suspicious:
                if _run(distributed, client, packed, [number], parts, "-alone"):
                    parts.fail(number)
        whole = parts.table()
        table = Table(*cases.joined(how, _csv(whole)))
    _write(whole.replace_schema_metadata(None), folder / "table.parquet")
    return table


def _run(distributed: Any, client: Any, packed: _Packed, numbers: list[int], parts: _Parts, mark: str = "") -> list[int]:
    """Computes parts and writes each when it ends; the numbers of those that have ended too many workers are
    returned."""
    # A task, and not data that was sent: should its worker die it is made anew.
    shared = client.submit(_same, packed, key=f"oilwedge_scene-{packed.key}{mark}")
    # The parts are one group of tasks and the scene is another one: the scheduler spreads them over all workers then,
    # and not only over those that have the scene.
    group = f"oilwedge_part-{packed.key}{mark}"
    ended = distributed.as_completed([client.submit(_part, shared, number, key=(group, number)) for number in numbers])
    killers = []
    try:
        for future in ended:
            number = future.key[1]
            if future.status == "error":
                error = future.exception()
                if not isinstance(error, distributed.scheduler.KilledWorker):
                    raise error
                killers.append(number)
            else:
                version, rows = future.result()
                _check_versions({"a worker": version})
                parts.write(number, rows)
            future.release()
    finally:
        ended.clear()
        shared.release()
    return killers


def _check_versions(versions: Mapping[str, str]) -> None:
    """All workers must have the version of the client."""
    own = _native.version()
    others = [f"{version} on {worker}" for worker, version in versions.items() if version != own]
    if others:
        raise OilwedgeError(f"the client has oilwedge {own}, but there is {', '.join(others)}; install one version on all")


def _same(packed: _Packed) -> _Packed:
    return packed


def _part(packed: _Packed, number: int) -> tuple[str, bytes]:
    """The rows of a part, on a worker; and its version."""
    unpacked = _unpacked(packed)
    return _native.version(), unpacked.cases.part(packed.asked, number, packed.parts)


@dataclass(frozen=True)
class _Unpacked:
    """A sweep on a worker: its cases, and the folder of its files, which lasts as long as a part of them is
    computed."""

    cases: _native.Cases
    folder: tempfile.TemporaryDirectory[str]


_worker: dict[str, _Unpacked] = {}
"""The sweep that this worker computes: it is read once."""
_unpacking = threading.Lock()


def _unpacked(packed: _Packed) -> _Unpacked:
    """A worker may compute several parts at once, on threads of its own."""
    with _unpacking:
        found = _worker.get(packed.key)
        if found is None:
            _worker.clear()
            _keep_memory()
            folder = tempfile.TemporaryDirectory(prefix="oilwedge-")
            found = _worker[packed.key] = _Unpacked(_cases(packed.text, packed.files, Path(folder.name)), folder)
        return found


def _keep_memory() -> None:
    """Lets this process keep the memory of a film for the next one.

    Dask has workers return all memory at once (``MALLOC_TRIM_THRESHOLD_``): each film would fetch its arrays from the
    system again, a quarter of the whole time. The thresholds are those to which glibc moves by itself elsewhere."""
    try:
        mallopt = ctypes.CDLL(None).mallopt
    except (AttributeError, OSError, TypeError):
        # Another library of C.
        return
    for option, size in ((_MMAP_THRESHOLD, 32 << 20), (_TRIM_THRESHOLD, 64 << 20)):
        mallopt(option, size)


_TRIM_THRESHOLD, _MMAP_THRESHOLD = -1, -3
"""Numbers of options of glibc's ``mallopt``."""


def _cases(text: str, files: Mapping[str, bytes], folder: Path) -> _native.Cases:
    """The cases of a scene whose files are put into the folder."""
    for name, data in files.items():
        (folder / name).write_bytes(data)
    return _native.Cases(_native.Scene.parse(text, folder / "<scene>"))


def _packed_scene(scene: Scene) -> tuple[Scene, dict[str, bytes]]:
    """A scene that names its files by their names alone, and these files."""
    files: dict[str, bytes] = {}
    changes: dict[str, str] = {}
    for key, path in scene._scene.files:
        name = f"{len(files)}-{path.name}"
        files[name] = path.read_bytes()
        changes[key] = name
    if not changes:
        return scene, files
    if set(changes) & set(scene._scene.axes):
        raise ValueError(f'{", ".join(set(changes) & set(scene._scene.axes))}: files as an axis do not travel to workers; make a sweep for each file')
    return scene | changes, files


class _Parts:
    """The folder of the parts."""

    def __init__(self, folder: Path, packed: _Packed, cases: _native.Cases) -> None:
        self._folder = folder
        self._cases = cases
        self._packed = packed
        self._identity = json.dumps({"sweep": packed.key, "version": _native.version(), "parts": packed.parts}).encode()
        folder.mkdir(parents=True, exist_ok=True)

    def _path(self, number: int) -> Path:
        return self._folder / f"part-{number:06}.parquet"

    def missing(self) -> list[int]:
        """Numbers of the parts that are not there.

        Raises ``ValueError`` where the folder holds parts of another sweep."""
        parquet = needed("pyarrow.parquet", "oilwedge.dask.sweep()")
        for path in sorted(self._folder.glob("part-*.parquet")):
            metadata = parquet.read_schema(path).metadata or {}
            if metadata.get(_IDENTITY) != self._identity:
                raise ValueError(
                    f"{path} is a part of another sweep, or of this one before its scene, its options or the version of oilwedge was changed; give another folder as out, or move it away"
                )
        return [number for number in range(1, self._packed.parts + 1) if not self._path(number).exists()]

    def write(self, number: int, rows: bytes) -> None:
        """Writes a part, whole."""
        arrow = needed("pyarrow", "oilwedge.dask.sweep()")
        columns = typed_columns(rows)
        table = arrow.table({heading: arrow.array(column, from_pandas=True) for heading, column in columns.items()})
        _write(table.replace_schema_metadata({_IDENTITY: self._identity}), self._path(number))

    def fail(self, number: int) -> None:
        """Writes the rows of a part that cannot be computed."""
        reason = "the worker that computed it was ended each time: by the system, or for want of memory"
        self.write(number, self._cases.failed(self._packed.asked, (number, self._packed.parts), reason))

    def table(self) -> pyarrow.Table:
        """All parts, in the order of the cases."""
        arrow, parquet = needed("pyarrow", "oilwedge.dask.sweep()"), needed("pyarrow.parquet", "oilwedge.dask.sweep()")
        numbers = range(1, self._packed.parts + 1)
        whole: pyarrow.Table = arrow.concat_tables([parquet.read_table(self._path(number)) for number in numbers])
        return whole


def _csv(table: pyarrow.Table) -> bytes:
    """A table as lines of CSV with headings, to the letter as the program writes it."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(table.column_names)
    writer.writerows(zip(*(_texts(name, table.column(name)) for name in table.column_names)))
    return text.getvalue().encode()


def _texts(heading: str, column: pyarrow.ChunkedArray) -> list[str]:
    """A column as CSV has it."""
    values: list[Any] = column.to_pylist()
    if heading in ("case", "unknowns"):
        return ["" if value is None else str(int(value)) for value in values]
    if heading == "seconds":
        return ["" if value is None else f"{value:.6f}" for value in values]
    if any(isinstance(value, str) for value in values):
        return values
    return _native.texts(column.to_numpy().astype(np.float64))


def _write(table: pyarrow.Table, path: Path) -> None:
    """Writes a table whole or not at all."""
    parquet = needed("pyarrow.parquet", "oilwedge.dask.sweep()")
    beside = path.with_name(f".{path.name}.{os.getpid()}")
    parquet.write_table(table, beside, compression="zstd")
    os.replace(beside, path)
