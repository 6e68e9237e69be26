"""Results that several files of tests look at."""

import oilwedge as ow
import pytest

from python_package import SHELL


@pytest.fixture(scope="session")
def shell():
    return ow.solve(ow.Scene.read(SHELL))
