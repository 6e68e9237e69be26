"""The JSON schema of scenes, by a validator that is not ours: taplo, which editors use, accepts all scenes, and refuses
wrong keys, units and words."""

import json
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import jsonschema
import pytest

from oilwedge_run import REPOSITORY, SCENES, program

WRONG = json.loads((REPOSITORY / "tests/data/wrong_scenes.json").read_text())
KINDS = ["plain", "hole", "groove", "engine-main", "heat", "pad"]


@pytest.fixture(scope="module")
def schema(tmp_path_factory):
    path = tmp_path_factory.mktemp("schema") / "oilwedge.schema.json"
    path.write_bytes(subprocess.check_output([program("OILWEDGE_BIN", "oilwedge"), "schema"]))
    return path


def lint(*arguments, cwd=None):
    taplo = Path(sys.executable).parent / "taplo"
    return subprocess.run([taplo, "lint", *arguments], cwd=cwd, capture_output=True, text=True)


def refused(linted, word=""):
    """The files that have an error, which says the word."""
    return set(re.findall(rf"^error: .*{word}.*\n.* (\S+\.toml):\d+:\d+$", linted.stderr, flags=re.MULTILINE))


def test_the_schema_is_one_of_draft_7(schema):
    jsonschema.Draft7Validator.check_schema(json.loads(schema.read_text()))


def test_shipped_scenes_pass(schema):
    scenes = sorted(SCENES.glob("*.toml"))
    assert len(scenes) > 20
    linted = lint("--schema", schema.as_uri(), *scenes)
    assert linted.returncode == 0, linted.stderr


def test_new_scenes_name_their_schema(tmp_path):
    scenes = [tmp_path / f"{kind}.toml" for kind in KINDS]
    for kind, scene in zip(KINDS, scenes):
        new = [program("OILWEDGE_BIN", "oilwedge"), "new", scene.name, "--kind", kind]
        subprocess.run(new, cwd=tmp_path, check=True, capture_output=True)
    linted = lint(*scenes, cwd=tmp_path)
    assert linted.returncode == 0, linted.stderr
    for scene in scenes:
        scene.write_text(scene.read_text().replace("[journal]", "[jornal]"))
    assert refused(lint(*scenes, cwd=tmp_path), "jornal") == set(map(str, scenes))


@pytest.mark.parametrize(
    ("key", "text"),
    [
        ("Damping", "5e5 N s/m"),
        ("Damping", "5 s kN/mm"),
        ("Stiffness", "20 kN/mm"),
        ("Stiffness", "3 lbf/in"),
        ("Pressure", "2 kgf/cm2"),
        ("Viscosity", "1e-6 lbf s/in²"),
        ("Force", "12 daN"),
        ("Speed", "50 rev/s"),
        ("VolumeFlow", "6 m3/h"),
        ("Torque", "3 kNm"),
    ],
)
def test_composed_units_are_accepted(schema, key, text):
    assert re.search(json.loads(schema.read_text())["definitions"][key]["pattern"], text)


@pytest.mark.parametrize(("key", "text"), [("Damping", "5 N/m"), ("Pressure", "3 mPa"), ("Speed", "50 1/s"), ("Length", "3 kg")])
def test_other_units_are_refused(schema, key, text):
    assert not re.search(json.loads(schema.read_text())["definitions"][key]["pattern"], text)


def test_wrong_scenes_are_refused(tmp_path, schema):
    scene = tmp_path / "scene.toml"
    scene.write_text(WRONG["scene"])
    linted = lint("--schema", schema.as_uri(), scene)
    assert linted.returncode == 0, linted.stderr
    assert len(WRONG["edits"]) >= 50
    wrong = []
    for number, (before, after) in enumerate(WRONG["edits"]):
        assert before in WRONG["scene"], before
        text = WRONG["scene"].replace(before, after, 1)
        assert tomllib.loads(text)
        wrong.append(tmp_path / f"wrong_{number}.toml")
        wrong[-1].write_text(text)
    linted = lint("--schema", schema.as_uri(), *wrong)
    assert linted.returncode == 1 and refused(linted) == set(map(str, wrong))
