"""The Python package in its process: threads, Ctrl-C, what is linked, and types."""

import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import oilwedge as ow
import pytest

from oilwedge_run import REPOSITORY
from python_package import ENGINE, RING, without_times


def test_other_threads_run_meanwhile():
    """A thread counts while another one solves; two threads solve two scenes."""
    scene = ow.Scene.read(ENGINE)
    alone = ow.solve(scene, bars=False, threads=1)
    counted, results = [0], {}

    def solve(name):
        results[name] = ow.solve(scene, bars=False, threads=1)

    threads = [threading.Thread(target=solve, args=(name,)) for name in "ab"]
    for thread in threads:
        thread.start()
    while any(thread.is_alive() for thread in threads):
        counted[0] += 1
        time.sleep(0.001)
    assert counted[0] > 50
    for result in results.values():
        assert without_times(result.to_dict()) == without_times(alone.to_dict())


INTERRUPTED = """
import sys, time
import oilwedge as ow
scene = ow.Scene.read(sys.argv[1])
print("begin", flush=True)
try:
    {call}
except KeyboardInterrupt:
    print("interrupted", time.time(), flush=True)
print(ow.solve(sys.argv[2])["load"].value)
"""


@pytest.mark.parametrize(
    "call",
    (
        'ow.solve(scene | {"mesh.tolerance": "0.00001 %"}, max_unknowns=10**8)',
        'ow.sweep(scene | {"mesh.tolerance": "0.01 %"}, {"journal.speed": [f"{n} rpm" for n in range(1000, 9000)]})',
    ),
)
def test_ctrl_c_ends_a_run_and_not_the_interpreter(call):
    command = [sys.executable, "-c", INTERRUPTED.format(call=call), str(ENGINE), str(RING)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout.readline() == "begin\n"
        time.sleep(0.5)
        sent = time.time()
        process.send_signal(signal.SIGINT)
        words = process.stdout.readline().split()
        assert words[0] == "interrupted"
        print(f"{float(words[1]) - sent:.3f} s from Ctrl-C to KeyboardInterrupt")
        # Far less than what is left of the run; how fast it is docs/performance.md says.
        assert float(words[1]) - sent < 10
        assert float(process.stdout.readline()) == ow.solve(RING)["load"].value
    assert process.returncode == 0


def test_many_runs_leave_nothing_behind():
    before = threads_of_process()
    for _ in range(60):
        ow.solve(RING, bars=False, threads=2)
    assert threads_of_process() <= before + 2


def threads_of_process():
    return len(os.listdir("/proc/self/task"))


def test_the_module_links_no_python():
    module = next(Path(ow.__file__).parent.glob("_native*.so"))
    assert ".abi3." in module.name
    linked = subprocess.run(["ldd", module], capture_output=True, text=True, check=True).stdout
    assert "libpython" not in linked
    assert (Path(ow.__file__).parent / "py.typed").exists()


# Packages that only what is given to them is for: their types take most of the time, and are not ours.
TYPES = """
[mypy]
ignore_missing_imports = True
[mypy-dask.*,distributed.*,meshio.*,pandas.*,pyarrow.*,pyvista.*,xarray.*]
follow_imports = skip
"""


def test_types_hold(tmp_path):
    """Examples are checked strictly, and the stubs against the module."""
    (tmp_path / "mypy.ini").write_text(TYPES)
    (tmp_path / "allowed").write_text("oilwedge\\..*\\.(Client|meshio|pandas|pyarrow|pyvista|xarray)\n")
    examples = ["mypy", "--strict", "--config-file", "mypy.ini", str(REPOSITORY / "crates/python/examples")]
    stubs = ["mypy.stubtest", "oilwedge", "--mypy-config-file", "mypy.ini", "--allowlist", "allowed"]
    for check in (examples, stubs):
        ended = subprocess.run([sys.executable, "-m", *check], capture_output=True, text=True, cwd=tmp_path)
        assert ended.returncode == 0, ended.stdout + ended.stderr
