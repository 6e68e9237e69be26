"""The notebook draws the study again: its numbers are checked in it, its pictures are there."""

import nbformat
import pytest
from nbclient import NotebookClient

from oilwedge_run import REPOSITORY

EXAMPLES = REPOSITORY / "crates/python/examples"


@pytest.mark.full
def test_the_notebook_of_the_study_runs():
    notebook = nbformat.read(EXAMPLES / "flexpde_study.ipynb", as_version=4)
    assert all(not cell.get("outputs") for cell in notebook.cells), "outputs are not kept in the repository"
    NotebookClient(notebook, timeout=300, resources={"metadata": {"path": str(EXAMPLES)}}).execute()
    shown = [output for cell in notebook.cells for output in cell.get("outputs", [])]
    kinds = [kind for output in shown for kind in output.get("data", {})]
    assert kinds.count("image/svg+xml") == 4 and kinds.count("image/png") == 2
    words = [output.get("data", {}).get("text/plain", "") for output in shown]
    assert any("verdict   converged" in text for text in words), "the table of the shell"
