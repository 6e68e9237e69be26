"""What the tests of the Python package share: scenes, and the program beside it."""

import json
import re
import subprocess

from oilwedge_run import SCENES, program

RING = SCENES / "01_plain_ring.toml"
SHELL = SCENES / "02_flexpde_shell.toml"
STUDY = SCENES / "08_flexpde_study_size.toml"
ENGINE = SCENES / "17_engine_main_bearing.toml"
CYCLE = """
bearing = { diameter = "50 mm", length = "25 mm", clearance = "30 um" }
mesh.size = "6 mm"
journal.speed = "3000 rpm"
oil.viscosity = "10 mPa.s"
cavitation.model = "reynolds"
orbit = { tolerance = 1e-2 }

[load]
harmonics = [{ order = 0, cos = { x = "2 kN" } }, { order = 1, sin = { y = "3 kN" } }]
frame = "shell"
period = "360 deg"
"""
"""An orbit that closes soon."""


def run(*arguments, status=0):
    """What the program prints, and its complaints."""
    ended = subprocess.run([program("OILWEDGE_BIN", "oilwedge"), *map(str, arguments)], capture_output=True, text=True)
    assert ended.returncode == status, ended.stderr
    return ended.stdout, ended.stderr


def solved(scene, out, *more):
    """The object of result.json."""
    run("solve", scene, "--out", out, *more)
    return json.loads((out / "result.json").read_text())


def without_times(result):
    return {key: value for key, value in result.items() if key not in ("timing_s", "levels")}


def without_seconds(page, result):
    """The lines of a page but those of the times of its result."""
    times = tuple(f"<tr><td>{name}</td>" for name in result.to_dict()["timing_s"])
    return [re.sub(r"\d[\d.e-]*(?=\s*(?:s|ms|min)\b)", "", line) for line in page.splitlines() if not line.startswith(times)]
