"""CPU seconds from mesh file to load, oilwedge against scikit-fem with SuperLU, on the same mesh in one run.

    python compare_speed.py [N_UNKNOWNS ...]        (default 10000 100000)

One thread each, the median of three runs; the mesh is a ring with a feed hole, made by meshes/benchmark.py.
Compare the ratio, not the seconds: machines differ and are shared. The time of oilwedge is that of
the whole process, its output files included; imports of Python are not counted.
"""

import os

for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[variable] = "1"

import resource
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from film import rule_of_degree, solve_film
from oilwedge_run import REPOSITORY, program
from scene_file import read_scene

SCENE = """
[bearing]
diameter = "75 mm"
length = "75 mm"
clearance = "37.5 um"
[mesh]
file = "ring.msh"
[ends]
pressure = "0 bar"
[[feed]]
group = "feed_hole"
pressure = "1 bar"
[journal]
speed = "10 rad/s"
eccentricity = 0.8
min_film_angle = "180 deg"
[oil]
viscosity = "0.4 Pa.s"
"""
RUNS = 3


def children_seconds():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def oilwedge_seconds(scene, out):
    """CPU seconds of the whole process on one thread."""
    before = children_seconds()
    command = [program("OILWEDGE_BIN", "oilwedge"), "solve", str(scene), "--out", str(out), "--threads", "1"]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return children_seconds() - before


def scikit_fem_seconds(scene):
    """CPU seconds from the mesh file to the load, with the quadrature degree of oilwedge."""
    before = time.process_time()
    solve_film(read_scene(scene), rule_of_degree(6))
    return time.process_time() - before


def main(sizes):
    print(f"{'unknowns':>10} {'oilwedge [s]':>14} {'scikit-fem [s]':>15} {'ratio':>7}")
    for size in sizes:
        with tempfile.TemporaryDirectory() as folder:
            maker = [sys.executable, REPOSITORY / "meshes" / "benchmark.py", str(size), f"{folder}/ring.msh"]
            subprocess.run(maker, check=True, stdout=subprocess.DEVNULL)
            scene = Path(folder) / "scene.toml"
            scene.write_text(SCENE)
            own = statistics.median(oilwedge_seconds(scene, Path(folder) / "out") for _ in range(RUNS))
            peer = statistics.median(scikit_fem_seconds(scene) for _ in range(RUNS))
            print(f"{size:>10} {own:>14.3f} {peer:>15.3f} {peer / own:>7.1f}")


if __name__ == "__main__":
    main([int(size) for size in sys.argv[1:]] or [10_000, 100_000])
