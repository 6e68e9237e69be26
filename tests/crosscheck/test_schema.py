"""The JSON schema of scenes, by a validator that is not ours: shipped scenes pass, wrong keys, units and words do not."""

import json
import subprocess
import tomllib

import jsonschema
import pytest

from oilwedge_run import REPOSITORY, SCENES, program

WRONG = json.loads((REPOSITORY / "tests/data/wrong_scenes.json").read_text())


@pytest.fixture(scope="module")
def validator():
    schema = json.loads(subprocess.check_output([program("OILWEDGE_BIN", "oilwedge"), "schema"]))
    jsonschema.Draft7Validator.check_schema(schema)
    return jsonschema.Draft7Validator(schema)


@pytest.mark.parametrize("path", sorted(SCENES.glob("*.toml")), ids=lambda path: path.stem)
def test_shipped_scenes_pass(validator, path):
    validator.validate(tomllib.loads(path.read_text()))


def test_wrong_scenes_are_refused(validator):
    validator.validate(tomllib.loads(WRONG["scene"]))
    for before, after in WRONG["edits"]:
        scene = tomllib.loads(WRONG["scene"].replace(before, after, 1))
        assert not validator.is_valid(scene), after
