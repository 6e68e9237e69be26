"""Sweeps on a cluster of Dask: the table is that of one process, whatever happens to workers and clients."""

import csv
import functools
import io
import json
import os
import signal
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import cloudpickle
import dask
import numpy as np
import oilwedge as ow
import oilwedge.dask
import pyarrow.parquet
import pytest
from distributed import Client, LocalCluster
from oilwedge._run import asked
from oilwedge._sweep import swept

from oilwedge_run import SCENES
from python_package import STUDY

SHIPPED, CHANGES = str(STUDY), {"oil.barus.alpha": "6e-8 1/Pa"}
SCENE = ow.Scene.read(SHIPPED) | CHANGES
AXES = {"journal.speed": [f"{n} rpm" for n in range(500, 4700, 350)], "eccentricity": np.linspace(0.1, 0.9, 16).round(6).tolist()}
"""192 cases in 12 chains; fast journals have no film at the greatest eccentricities."""
KILLER, LATE = 3, 9
"""A part that ends its worker each time, and one that ends it once, when others are gathered."""


def rows(text):
    """The rows of a table but for their seconds, the last column."""
    return [row[:-1] for row in csv.reader(io.StringIO(text))]


@pytest.fixture(scope="module")
def wanted():
    return rows(ow.sweep(SCENE, AXES, bars=False).to_csv())


@pytest.fixture(scope="module")
def client():
    # A cluster gives up workers that are not there again in time; a busy machine takes longer than its 15 s.
    patient = dask.config.set({"distributed.deploy.lost-worker-timeout": "5 minutes"})
    with patient, LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        # A part may end one worker less than it may by itself, for each is started anew.
        cluster.scheduler.allowed_failures = 1
        yield client


def parts(folder):
    return sorted(Path(folder).glob("part-*.parquet"))


def inodes(folder):
    return {str(path): path.stat().st_ino for path in parts(folder)}


def wait_for_parts(folder, count, process=None):
    """Until so many parts are there; fails after two minutes, or when the process that writes them has ended."""
    last = time.monotonic() + 120
    while len(parts(folder)) < count:
        assert time.monotonic() < last and (process is None or process.poll() is None), f"{len(parts(folder))} parts of {count}"
        time.sleep(0.01)


compute = oilwedge.dask._part


def deadly(folder, seen, packed, number):
    """A part that may end its worker; the late one writes down first what has been gathered."""
    if number == KILLER:
        os.kill(os.getpid(), signal.SIGKILL)
    if number == LATE and not os.path.exists(seen):
        wait_for_parts(folder, 5)
        Path(seen).write_text(json.dumps(inodes(folder)))
        os.kill(os.getpid(), signal.SIGKILL)
    return compute(packed, number)


@pytest.mark.full
def test_workers_are_killed(client, wanted, tmp_path, monkeypatch):
    """The table is that of one process but for the part that ends every worker, and what was gathered before is not
    computed again."""
    out, seen = tmp_path / "map", tmp_path / "seen.json"
    cloudpickle.register_pickle_by_value(sys.modules[__name__])
    monkeypatch.setattr(oilwedge.dask, "_part", functools.partial(deadly, str(out), str(seen)))
    try:
        table = oilwedge.dask.sweep(SCENE, AXES, client, out=out, bars=False)
    finally:
        cloudpickle.unregister_pickle_by_value(sys.modules[__name__])
    found = rows(table.to_csv())
    failed = [row for row in found if row[3] == "failed"]
    assert len(failed) == 16 and all("worker" in row[-1] and row[4] == "" for row in failed)
    cases = {row[0] for row in failed}
    assert [row for row in found if row[0] not in cases] == [row for row in wanted if row[0] not in cases]
    assert "16 that no worker could compute" in str(table)
    gathered = json.loads(seen.read_text())
    assert len(gathered) >= 5 and inodes(out).items() >= gathered.items()


CLIENT = """
import oilwedge as ow
import oilwedge.dask
from distributed import Client
scene = ow.Scene.read({shipped!r}) | {changes!r}
with Client({address!r}) as client:
    oilwedge.dask.sweep(scene, {axes!r}, client, out={out!r}, bars=False)
"""


@pytest.mark.full
def test_the_client_is_killed(client, wanted, tmp_path, monkeypatch):
    """What it has written is kept, and the rest is computed by the next one."""
    script = tmp_path / "client.py"
    out = tmp_path / "map"
    how = {"shipped": SHIPPED, "changes": CHANGES, "axes": AXES, "address": client.scheduler.address, "out": str(out)}
    script.write_text(CLIENT.format(**how))
    with subprocess.Popen([sys.executable, script]) as process:
        try:
            wait_for_parts(out, 3, process)
        finally:
            process.kill()
    kept = {path: path.stat().st_mtime_ns for path in parts(out)}
    computed = []
    write = oilwedge.dask._Parts.write
    monkeypatch.setattr(oilwedge.dask._Parts, "write", lambda self, number, rows: (computed.append(number), write(self, number, rows)))
    table = oilwedge.dask.sweep(SCENE, AXES, client, out=out, bars=False)
    assert rows(table.to_csv()) == wanted
    assert {path: path.stat().st_mtime_ns for path in kept} == kept
    assert len(computed) == len(set(computed)) == len(parts(out)) - len(kept) > 0
    again = oilwedge.dask.sweep(SCENE, AXES, client, out=out, bars=False)
    assert again.to_csv() == table.to_csv() and len(computed) == len(parts(out)) - len(kept), "nothing was left to compute"
    written = pyarrow.parquet.read_table(out / "table.parquet").to_pydict()
    assert written["case"] == list(range(1, 193))
    assert written["status"] == [row[3] for row in wanted[1:]] and {"converged", "no_solution"} <= set(written["status"])
    assert str(table).startswith(f"{SCENE.title}: 192 cases, ")
    assert (out / "table.parquet").stat().st_size <= 2 / 3 * len(table.to_csv())
    # The folder is that of one sweep.
    with pytest.raises(ValueError, match="part of another sweep"):
        oilwedge.dask.sweep(SCENE, AXES, client, out=out, bars=True)
    with pytest.raises(ow.SceneError, match="not known"):
        oilwedge.dask.sweep(SCENE, {"sped": ["1 rpm"]}, client, out=out)


def test_threads_of_a_worker_and_two_sweeps_share_it():
    """The files of a sweep stay as long as a part of it is computed, whoever reads another sweep meanwhile."""
    sweeps = [_packed(scene) for scene in (SCENE, SCENE | {"journal.speed": "20 rad/s"})]
    rows_of = [oilwedge.dask._part(packed, 1)[1] for packed in sweeps]
    for _ in range(5):
        oilwedge.dask._worker.clear()
        with ThreadPoolExecutor(8) as threads:
            found = list(threads.map(lambda number: oilwedge.dask._part(sweeps[number % 2], 1)[1], range(16)))
        for number, text in enumerate(found):
            assert rows(text.decode()) == rows(rows_of[number % 2].decode())


def _packed(scene):
    """A sweep of two cases as it travels."""
    own, files = oilwedge.dask._packed_scene(swept(scene, {"eccentricity": [0.3, 0.5]}, None))
    how = asked(own, bars=False, max_seconds=None, max_unknowns=1_000_000, threads=1)
    return oilwedge.dask._Packed(own.text, files, how, 1)


def test_all_workers_have_one_version():
    oilwedge.dask._check_versions({"tcp://a": ow.__version__})
    with pytest.raises(ow.OilwedgeError, match="0.0.1 on tcp://b"):
        oilwedge.dask._check_versions({"tcp://a": ow.__version__, "tcp://b": "0.0.1"})


def test_files_are_no_axis(client, tmp_path):
    mesh = str(SCENES.parent / "meshes/flexpde_shell.msh")
    with pytest.raises(ValueError, match="files as an axis"):
        oilwedge.dask.sweep(SCENE, {"mesh.file": [mesh]}, client, out=tmp_path, bars=False)
