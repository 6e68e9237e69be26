"""CITATION.cff and the workflow of releases are YAML, and say what the repository says."""

import tomllib

import yaml
from oilwedge_run import REPOSITORY


def test_the_citation_is_of_this_version():
    citation = yaml.safe_load((REPOSITORY / "CITATION.cff").read_text())
    package = tomllib.loads((REPOSITORY / "Cargo.toml").read_text())["workspace"]["package"]
    assert citation["cff-version"] == "1.2.0" and citation["message"] and citation["title"]
    assert str(citation["version"]) == package["version"]
    assert " OR ".join(citation["license"]) == package["license"]
    assert [author["name"] for author in citation["authors"]] == package["authors"]


def test_the_workflow_tests_before_it_builds_a_release():
    workflow = yaml.safe_load((REPOSITORY / ".github/workflows/release.yml").read_text())
    job = workflow["jobs"]["build"]
    commands = [step["run"] for step in job["steps"] if "run" in step]
    assert commands[-2:] == [".ci/run", "tools/release.sh"]
    assert all((REPOSITORY / command).is_file() for command in commands[-2:])
    assert [it["system"].split("-")[0] for it in job["strategy"]["matrix"]["include"]] == ["ubuntu", "macos", "windows"]
