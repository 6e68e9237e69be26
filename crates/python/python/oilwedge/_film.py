"""The film: where its triangles are, and the fields on them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._optional import needed
from ._types import FilmParts

if TYPE_CHECKING:
    import meshio
    import pyvista

Floats = NDArray[np.float64]

_QUADRATIC_TRIANGLE = 22
"""The type of quadratic triangles in VTK."""


def _short(name: str) -> str:
    """The name of a field without its unit."""
    return name.split(" [")[0]


class Film:
    """The fields of a solved film on its quadratic triangles, in SI.

    The arrays are those of the program itself, not copies of them, and cannot be written to. Fields on nodes and on
    triangles are found by their names: ``film["pressure"]``; ``film.fields`` has all names.
    """

    __slots__ = ("_json", "_parts", "_names")
    _json: str
    _parts: FilmParts
    _names: dict[str, str]

    def __init__(self, json: str, parts: FilmParts) -> None:
        self._json = json
        self._parts = parts
        self._names = {_short(name): name for name in [*parts["point_data"], *parts["cell_data"]]}

    @property
    def points(self) -> Floats:
        """Nodes [m], on the cylinder ``(R cos phi, R sin phi, z)`` or unrolled ``(R phi, z, 0)``."""
        return self._parts["points"]

    @property
    def cells(self) -> NDArray[np.uint32]:
        """Triangles by their nodes: three vertices, then the middles of the edges 01, 12, 20."""
        return self._parts["cells"]

    @property
    def fields(self) -> tuple[str, ...]:
        """Names of all fields."""
        return tuple(self._names)

    @property
    def lines(self) -> Mapping[str, Floats]:
        """Lines by name, as rims of feeds and the edge of the cavity: pieces between two points [m]."""
        return self._parts["lines"]

    def __contains__(self, name: object) -> bool:
        return name in self._names

    def __getitem__(self, name: str) -> Floats:
        whole = self._names.get(name, name)
        for group in (self._parts["point_data"], self._parts["cell_data"]):
            if whole in group:
                return group[whole]
        raise KeyError(f'there is no field "{name}"; there are {", ".join(self.fields)}')

    @property
    def pressure(self) -> Floats:
        """Gauge pressure at the nodes [Pa]."""
        return self["pressure"]

    @property
    def film_thickness(self) -> Floats:
        """Gap between journal and liner at the nodes [m]."""
        return self["film_thickness"]

    @property
    def viscosity(self) -> Floats:
        """Dynamic viscosity at the nodes [Pa.s]."""
        return self["viscosity"]

    @property
    def film_fraction(self) -> Optional[Floats]:
        """Share of the gap that oil fills at the nodes [1]; ``None`` where the model of cavitation conserves no oil."""
        return self["film_fraction"] if "film_fraction" in self else None

    @property
    def error_indicator(self) -> Optional[Floats]:
        """Contribution of each triangle to the error of the load [N]; ``None`` without error bars."""
        return self["error_indicator"] if "error_indicator" in self else None

    @property
    def angle(self) -> Floats:
        """Angle of the nodes on the liner [deg], from x towards y."""
        return self["phi"]

    @property
    def z(self) -> Floats:
        """Place of the nodes along the axis [m], zero midway between the ends."""
        return self["z"]

    def sample(self, field: str, angle: ArrayLike, z: ArrayLike) -> Floats:
        """Values of a field at angles [deg] and places along the axis [m], by the quadratic of the triangle at each;
        NaN where there is no film.

        ``angle`` and ``z`` are broadcast against each other.
        """
        if field not in self:
            self[field]
        angles, places = np.broadcast_arrays(np.asarray(angle, dtype=np.float64), np.asarray(z, dtype=np.float64))
        flat = (np.ascontiguousarray(angles).ravel(), np.ascontiguousarray(places).ravel())
        return _native.sampled(self._json, self._parts, field, flat).reshape(angles.shape)

    def to_pyvista(self) -> pyvista.UnstructuredGrid:
        """The film as a grid of pyvista."""
        grid = needed("pyvista", "film.to_pyvista()")
        count = len(self.cells)
        cells = np.column_stack([np.full(count, 6), self.cells]).ravel()
        film: pyvista.UnstructuredGrid = grid.UnstructuredGrid(cells, np.full(count, _QUADRATIC_TRIANGLE, dtype=np.uint8), np.array(self.points))
        for name, values in self._parts["point_data"].items():
            film.point_data[name] = values
        for name, values in self._parts["cell_data"].items():
            film.cell_data[name] = values
        film.set_active_scalars("pressure")
        return film

    def to_meshio(self) -> meshio.Mesh:
        """The film as a mesh of meshio."""
        mesh = needed("meshio", "film.to_meshio()")
        point_data = dict(self._parts["point_data"])
        cell_data = {name: [values] for name, values in self._parts["cell_data"].items()}
        return mesh.Mesh(self.points, [("triangle6", self.cells.astype(np.int64))], point_data=point_data, cell_data=cell_data)

    def __repr__(self) -> str:
        return f"<Film of {len(self.cells)} triangles and {len(self.points)} nodes: {', '.join(self.fields)}>"

    def __reduce__(self) -> tuple[Any, ...]:
        return _again, (self._json, self._parts)


def _again(json: str, parts: FilmParts) -> Film:
    """A film that was in another process."""
    return Film(json, frozen(parts))


def frozen(parts: FilmParts) -> FilmParts:
    """The parts of a film that were in another process: their arrays cannot be written to."""
    arrays: list[Union[Floats, NDArray[np.uint32]]] = [parts["points"], parts["cells"]]
    for group in (parts["point_data"], parts["cell_data"], parts["lines"]):
        arrays.extend(group.values())
    for array in arrays:
        array.flags.writeable = False
    return parts
