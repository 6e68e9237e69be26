"""CPU seconds from mesh file to load, oilwedge against scikit-fem and DOLFINx, on the same mesh in one run.

    python compare_speed.py [N_UNKNOWNS ...]        (default 10000 100000)

One thread each, the median of three runs; the mesh is a ring with a feed hole, made by meshes/benchmark.py.
scikit-fem solves with CHOLMOD where scikit-sparse is installed, else with SuperLU; the head of the table says which.
DOLFINx runs by the interpreter of the system (`dolfinx_film.py`), where it has it.
Compare the ratio, not the seconds: machines differ and are shared. The time of oilwedge is that of its
stages up to the load, power and flows measured, without error bars; that of its whole process, output
files included, stands beside. Ratios are of the former. Imports of Python are not counted.
Prints a table in Markdown; `performance` puts it into docs/performance.md.
"""

import os

for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[variable] = "1"

import json
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from scipy.sparse.linalg import spsolve

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
SYSTEM_PYTHON = "/usr/bin/python3"
# Stages from the mesh file to the load, as `timing_s` of a result names them.
STAGES = ("read", "order", "assemble", "factorise", "solve", "measure")


def direct_solver():
    """(name, solve(matrix, right)) of the quickest direct solver that is installed."""
    try:
        from sksparse.cholmod import cholesky
    except ImportError:
        return "SuperLU", spsolve
    return "CHOLMOD", lambda matrix, right: cholesky(matrix)(right)


def children_seconds():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def oilwedge(scene, out):
    """(seconds from the mesh file to the load on one thread, (CPU seconds of the whole process, its result))."""
    before = children_seconds()
    command = [program("OILWEDGE_BIN", "oilwedge"), "solve", str(scene), "--out", str(out)]
    command += ["--threads", "1", "--bars", "none"]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    whole = children_seconds() - before
    result = json.loads((out / "result.json").read_text())
    return sum(result["timing_s"].get(stage, 0.0) for stage in STAGES), (whole, result)


def scikit_fem(scene, solver):
    """(CPU seconds from the mesh file to the load, with the quadrature degree of oilwedge, the load)."""
    before = time.process_time()
    load = solve_film(read_scene(scene), rule_of_degree(6), solver=solver).load
    return time.process_time() - before, load


def dolfinx(ring):
    """CPU seconds of DOLFINx with hypre; none where it is not installed."""
    script = Path(__file__).with_name("dolfinx_film.py")
    run = subprocess.run([SYSTEM_PYTHON, script, ring], capture_output=True, text=True, check=False)
    if run.returncode != 0:
        print(f"no DOLFINx: {run.stderr.strip().splitlines()[-1:]}", file=sys.stderr)
        return None
    return float(run.stdout.split()[0])


def median(run):
    """(the median of the seconds, the last answer) of some runs."""
    runs = [run() for _ in range(RUNS)]
    return statistics.median(seconds for seconds, _ in runs), runs[-1][1]


def compare(size, folder, solver):
    """One row of the table."""
    maker = [sys.executable, REPOSITORY / "meshes" / "benchmark.py", str(size), f"{folder}/ring.msh"]
    subprocess.run(maker, check=True, stdout=subprocess.DEVNULL)
    scene = folder / "scene.toml"
    scene.write_text(SCENE)
    own, (whole, result) = median(lambda: oilwedge(scene, folder / "out"))
    peer, load = median(lambda: scikit_fem(scene, solver))
    off = result["quantities"]["load"]["value"] / load - 1
    nodes = result["mesh"]["nodes"]
    other = dolfinx(folder / "ring.msh")
    others = "not here | |" if other is None else f"{other:.3f} | {other / own:.1f} |"
    return f"| {nodes} | {own:.3f} | {whole:.3f} | {peer:.3f} | {peer / own:.1f} | {off:.0e} | {others}"


def main(sizes):
    name, solver = direct_solver()
    peers = f"scikit-fem with {name} [s] | ratio | loads differ by | DOLFINx with hypre [s] | ratio |"
    print(f"| unknowns | oilwedge [s] | whole process [s] | {peers}")
    print("|---|---|---|---|---|---|---|---|")
    for size in sizes:
        with tempfile.TemporaryDirectory() as folder:
            print(compare(size, Path(folder), solver), flush=True)


if __name__ == "__main__":
    main([int(size) for size in sys.argv[1:]] or [10_000, 100_000])
