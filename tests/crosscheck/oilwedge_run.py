"""Solve scenes by the Python package, and run the Rust programs.

OILWEDGE_BIN and OILWEDGE_CROSSCHECK_DATA name the two programs; without them they are looked for
in target/release of the repository.
"""

import json
import os
import subprocess
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import oilwedge as ow
import pyvista

REPOSITORY = Path(__file__).resolve().parents[2]
SCENES = REPOSITORY / "scenes"


@dataclass
class Probes:
    """Points inside cells (n, 2) [m] of the developed plane and the fields there."""

    points: np.ndarray
    pressure: np.ndarray
    film_thickness: np.ndarray


def program(variable, name):
    path = Path(os.environ.get(variable, REPOSITORY / "target" / "release" / name))
    if not path.exists():
        raise FileNotFoundError(f"{path} is missing: cargo build --release, or set {variable}")
    return str(path)


def solve(scene, unrolled, bars=True):
    """Result (the JSON object) and film (pyvista grid) of a scene.

    With error bars the numbers are those of the film in cubic elements, without those of the quadratic one."""
    result = ow.solve(scene, unrolled=unrolled, bars=bars)
    return result.to_dict(), result.film.to_pyvista()


def written(scene, out, unrolled):
    """Result (the JSON object) and film (pyvista grid) that the program writes to the folder `out`."""
    command = [program("OILWEDGE_BIN", "oilwedge"), "solve", str(scene), "--out", str(out), "--json"]
    subprocess.run(command + ["--unrolled"] * unrolled, check=True, stdout=subprocess.DEVNULL)
    result = json.loads((Path(out) / "result.json").read_text())
    return result, pyvista.read(Path(out) / "film.vtu")


def quantity(result, name):
    """Value of a quantity of the result, in its own unit."""
    return result["quantities"][name]["value"]


def crosscheck_data(scene, out):
    """((points (2, k), weights (k,)), Probes) of a scene."""
    name = program("OILWEDGE_CROSSCHECK_DATA", "crosscheck_data")
    subprocess.run([name, str(scene), str(out)], check=True, stdout=subprocess.DEVNULL)
    rule = json.loads((Path(out) / "quadrature.json").read_text())
    probes = json.loads((Path(out) / "probes.json").read_text())
    return (
        (np.array(rule["points"]).T, np.array(rule["weights"])),
        Probes(*(np.array(probes[key]) for key in ("points", "pressure", "film_thickness"))),
    )
