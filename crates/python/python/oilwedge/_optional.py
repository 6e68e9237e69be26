"""Packages that are imported when they are used."""

from __future__ import annotations

import importlib
from typing import Any


def needed(module: str, what: str) -> Any:
    """The module; where it is missing, an error that says what needs it and how it is installed."""
    try:
        return importlib.import_module(module)
    except ModuleNotFoundError as error:
        package = module.split(".")[0]
        if error.name is None or error.name.split(".")[0] != package:
            raise
        raise ModuleNotFoundError(f"{what} needs {package}; install it: pip install {package}", name=package) from None
