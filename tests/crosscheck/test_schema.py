"""The JSON schema of scenes, by a validator that is not ours: taplo, which editors use, accepts all scenes, and refuses wrong keys, units and words."""

import json
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


def test_the_schema_is_one_of_draft_7(schema):
    jsonschema.Draft7Validator.check_schema(json.loads(schema.read_text()))


def test_shipped_scenes_pass(schema):
    scenes = sorted(SCENES.glob("*.toml"))
    assert len(scenes) > 20
    linted = lint("--schema", schema.as_uri(), *scenes)
    assert linted.returncode == 0, linted.stderr


@pytest.mark.parametrize("kind", KINDS)
def test_new_scenes_name_their_schema(tmp_path, kind):
    new = [program("OILWEDGE_BIN", "oilwedge"), "new", "bearing.toml", "--kind", kind]
    subprocess.run(new, cwd=tmp_path, check=True, capture_output=True)
    linted = lint("bearing.toml", cwd=tmp_path)
    assert linted.returncode == 0, linted.stderr
    scene = tmp_path / "bearing.toml"
    scene.write_text(scene.read_text().replace("[journal]", "[jornal]"))
    assert "jornal" in lint("bearing.toml", cwd=tmp_path).stderr


def test_wrong_scenes_are_refused(tmp_path, schema):
    scene = tmp_path / "scene.toml"
    scene.write_text(WRONG["scene"])
    linted = lint("--schema", schema.as_uri(), scene)
    assert linted.returncode == 0, linted.stderr
    assert len(WRONG["edits"]) >= 50
    for before, after in WRONG["edits"]:
        assert before in WRONG["scene"], before
        text = WRONG["scene"].replace(before, after, 1)
        assert tomllib.loads(text)
        scene.write_text(text)
        linted = lint("--schema", schema.as_uri(), scene)
        assert linted.returncode == 1 and "error:" in linted.stderr, after
