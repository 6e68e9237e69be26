"""oilwedge: the oil film of journal bearings, from one scene.

    import oilwedge as ow

    scene = ow.Scene.read("bearing.toml")
    result = ow.solve(scene)
    print(result)
    load = result["load"]              # load.value, load.error, load.to("kN")
    film = result.film                 # arrays of numpy: film.pressure, film.points
    slower = scene | {"journal.speed": "1500 rpm"}
    table = ow.sweep(scene, {"journal.speed": ["1000 rpm", "2000 rpm", "3000 rpm"]})

Units are SI, angles are in degrees, temperatures in degrees Celsius, pressures are gauge.
"""

from ._catalogue import explain
from ._errors import Complaint, InternalError, MeshError, NoSolution, NotConverged, OilwedgeError, SceneError
from ._film import Film
from ._native import version as _version
from ._picture import Page, Picture
from ._result import Quantity, Result
from ._run import solve
from ._scene import Scene
from ._sweep import sweep
from ._table import Table

__version__ = _version()
__all__ = [
    "Complaint",
    "Film",
    "InternalError",
    "MeshError",
    "NoSolution",
    "NotConverged",
    "OilwedgeError",
    "Page",
    "Picture",
    "Quantity",
    "Result",
    "Scene",
    "SceneError",
    "Table",
    "explain",
    "solve",
    "sweep",
]
