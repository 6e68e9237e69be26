"""What the tests of the Python package share: scenes, and the program beside it."""

import json
import re
import subprocess

from oilwedge_run import SCENES, program

RING = SCENES / "01_plain_ring.toml"
SHELL = SCENES / "02_flexpde_shell.toml"
ENGINE = SCENES / "17_engine_main_bearing.toml"


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
