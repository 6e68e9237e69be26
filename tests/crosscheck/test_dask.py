"""Sweeps on a cluster of Dask: the table is that of one process, whatever happens to workers and clients."""

import csv
import io
import os
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import cloudpickle
import numpy as np
import oilwedge as ow
import oilwedge.dask
import pyarrow.parquet
import pytest
from distributed import Client, LocalCluster
from oilwedge._run import asked
from oilwedge._sweep import swept

from oilwedge_run import SCENES

SCENE = ow.Scene.read(SCENES / "02_flexpde_shell.toml") | {"oil.barus.alpha": "6e-8 1/Pa"}
AXES = {"journal.speed": [f"{n} rpm" for n in range(500, 4500, 250)], "eccentricity": np.linspace(0.1, 0.9, 20).round(6)}
"""320 cases in 16 chains; fast journals have no film at the greatest eccentricities."""
KILLER = 3


def rows(text):
    """The rows of a table but for their seconds, the last column."""
    return [row[:-1] for row in csv.reader(io.StringIO(text))]


@pytest.fixture(scope="module")
def wanted():
    return rows(ow.sweep(SCENE, AXES, bars=False).to_csv())


@pytest.fixture
def client():
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        yield client


def parts(folder):
    return sorted(folder.glob("part-*.parquet"))


def wait_for_parts(folder, count, process=None):
    """Until so many parts are there; fails after two minutes, or when the process that writes them has ended."""
    last = time.monotonic() + 120
    while len(parts(folder)) < count:
        assert time.monotonic() < last and (process is None or process.poll() is None), f"{len(parts(folder))} parts of {count}"
        time.sleep(0.01)


def test_a_worker_is_killed(client, wanted, tmp_path):
    """The table is that of one process, and what was gathered before is not computed again."""
    seen = {}

    def kill():
        wait_for_parts(tmp_path, 10)
        worker = next(iter(client.run(os.getpid).values()))
        os.kill(worker, signal.SIGKILL)
        seen.update({path: path.stat().st_ino for path in parts(tmp_path)})

    killer = threading.Thread(target=kill, daemon=True)
    killer.start()
    table = oilwedge.dask.sweep(SCENE, AXES, client, out=tmp_path, bars=False)
    killer.join()
    assert rows(table.to_csv()) == wanted
    assert {path: path.stat().st_ino for path in seen} == seen and len(seen) >= 10
    written = pyarrow.parquet.read_table(tmp_path / "table.parquet").to_pydict()
    assert written["case"] == list(range(1, 321))
    assert written["status"] == [row[3] for row in wanted[1:]] and {"converged", "no_solution"} <= set(written["status"])
    assert str(table).startswith(f"{SCENE.title}: 320 cases, ")
    assert (tmp_path / "table.parquet").stat().st_size <= 2 / 3 * len(table.to_csv())
    # The folder is that of one sweep.
    with pytest.raises(ValueError, match="part of another sweep"):
        oilwedge.dask.sweep(SCENE, AXES, client, out=tmp_path, bars=True)
    with pytest.raises(ow.SceneError, match="not known"):
        oilwedge.dask.sweep(SCENE, {"sped": ["1 rpm"]}, client, out=tmp_path)


CLIENT = """
import sys
import oilwedge.dask
from distributed import Client, LocalCluster
sys.path.insert(0, {folder!r})
from test_dask import AXES, SCENE
if __name__ == "__main__":
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        oilwedge.dask.sweep(SCENE, AXES, client, out={out!r}, bars=False)
"""


def test_the_client_is_killed(client, wanted, tmp_path, monkeypatch):
    """What it has written is kept, and the rest is computed by the next one."""
    script = tmp_path / "client.py"
    out = tmp_path / "map"
    script.write_text(CLIENT.format(folder=os.path.dirname(__file__), out=str(out)))
    out.mkdir()
    with subprocess.Popen([sys.executable, script], start_new_session=True) as process:
        try:
            wait_for_parts(out, 8, process)
        finally:
            os.killpg(process.pid, signal.SIGKILL)
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


def deadly(packed, number):
    """A part that ends its worker."""
    if number == KILLER:
        os.kill(os.getpid(), signal.SIGKILL)
    return compute(packed, number)


compute = oilwedge.dask._part


def test_a_part_ends_every_worker(client, wanted, tmp_path, monkeypatch):
    cloudpickle.register_pickle_by_value(sys.modules[__name__])
    monkeypatch.setattr(oilwedge.dask, "_part", deadly)
    try:
        table = oilwedge.dask.sweep(SCENE, AXES, client, out=tmp_path, bars=False)
    finally:
        cloudpickle.unregister_pickle_by_value(sys.modules[__name__])
    found = rows(table.to_csv())
    failed = [row for row in found if row[3] == "failed"]
    assert len(failed) == 20 and all("worker" in row[-1] and row[4] == "" for row in failed)
    cases = {row[0] for row in failed}
    assert [row for row in found if row[0] not in cases] == [row for row in wanted if row[0] not in cases]
    assert "20 that no worker could compute" in str(table)


def test_threads_of_a_worker_and_two_sweeps_share_it(tmp_path):
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
