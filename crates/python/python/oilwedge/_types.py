"""What goes to the native part and comes from it."""

from __future__ import annotations

import os
from typing import Optional, TypedDict, Union

import numpy as np
from numpy.typing import NDArray

StrPath = Union[str, "os.PathLike[str]"]
"""The path of a file or folder."""


class FilmParts(TypedDict):
    """A film: where its triangles are, and the fields on them."""

    points: NDArray[np.float64]
    cells: NDArray[np.uint32]
    point_data: dict[str, NDArray[np.float64]]
    cell_data: dict[str, NDArray[np.float64]]
    lines: dict[str, NDArray[np.float64]]


class Asked(TypedDict):
    """How a scene is run."""

    bars: bool
    max_seconds: Optional[float]
    max_unknowns: int
    unrolled: bool
    sensitivity: bool
    threads: Optional[int]
