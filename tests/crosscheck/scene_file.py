"""Read a scene (TOML) into SI numbers, and write a changed copy of one."""

import tomllib
from dataclasses import dataclass
from pathlib import Path

import numpy as np

UNITS = {
    "m": 1.0, "mm": 1e-3, "um": 1e-6,
    "Pa": 1.0, "kPa": 1e3, "bar": 1e5, "MPa": 1e6,
    "deg": np.pi / 180, "rad": 1.0, "mrad": 1e-3, "rad/s": 1.0, "rpm": np.pi / 30, "m/s": 1.0, "mm/s": 1e-3, "um/s": 1e-6,
    "Pa.s": 1.0, "mPa.s": 1e-3, "1/Pa": 1.0, "kN": 1e3,
}  # fmt: skip


def si(quantity):
    """Value in SI units of a text such as "75 mm", the nominal one of "75 mm +- 1 mm"; angles in radians."""
    if ".." in quantity:
        low, high = (si(end.strip()) for end in quantity.split(".."))
        return 0.5 * (low + high)
    nominal, _, width = quantity.partition("+-")
    # The unit may stand behind the half width alone.
    number, unit = nominal.split() if len(nominal.split()) == 2 else (nominal, width.split()[-1])
    return float(number) * UNITS[unit]


@dataclass
class Hole:
    """A round feed region in the developed plane: centre (x, z) and radius [m]."""

    x: float
    z: float
    radius: float


@dataclass
class Feed:
    """A region held at a pressure [Pa]."""

    group: str
    pressure: float
    hole: Hole | None


@dataclass
class Scene:
    """What the film problem needs, in SI units."""

    mesh: Path
    radius: float
    length: float
    clearance: float
    eccentricity: float
    min_film_angle: float
    speed: float
    squeeze: tuple
    tilt: tuple
    tilt_rate: tuple
    film_start: float | None
    end_pressure: float
    feeds: list
    viscosity: float
    barus: float
    as_printed: bool
    cavitation: str
    cavitation_pressure: float

    def film_thickness(self, x, z):
        """h = c (1 - eps cos(phi - phi_min)) - z g . n [m] at x = R phi, n = (cos phi, sin phi)."""
        phi = x / self.radius
        straight = self.clearance * (1 - self.eccentricity * np.cos(phi - self.min_film_angle))
        return straight - z * (self.tilt[0] * np.cos(phi) + self.tilt[1] * np.sin(phi))

    def thickness_rate(self, x, z):
        """dh/dt = -v_r cos(phi - phi_min) - v_t sin(phi - phi_min) - z g' . n [m/s] at x = R phi."""
        phi = x / self.radius
        turned = phi - self.min_film_angle
        straight = -self.squeeze[0] * np.cos(turned) - self.squeeze[1] * np.sin(turned)
        return straight - z * (self.tilt_rate[0] * np.cos(phi) + self.tilt_rate[1] * np.sin(phi))

    def holes(self):
        """(group, x, z, radius) of the feeds with a given circle."""
        return [(f.group, f.hole.x, f.hole.z, f.hole.radius) for f in self.feeds if f.hole]


def read_scene(path):
    with open(path, "rb") as file:
        table = tomllib.load(file)
    bearing, journal, oil = table["bearing"], table["journal"], table["oil"]
    barus = oil.get("barus", {})
    squeeze, cavitation = journal.get("squeeze", {}), table.get("cavitation", {})
    film_start = bearing.get("film_start")
    radius = si(bearing["diameter"]) / 2
    return Scene(
        mesh=(Path(path).parent / table["mesh"]["file"]).resolve(),
        radius=radius,
        length=si(bearing["length"]),
        clearance=si(bearing["clearance"]),
        eccentricity=journal["eccentricity"],
        min_film_angle=si(journal["min_film_angle"]),
        speed=si(journal["speed"]),
        squeeze=tuple(si(squeeze.get(key, "0 m/s")) for key in ("radial", "tangential")),
        tilt=_towards_x_and_y(journal.get("tilt", {}), "0 rad"),
        tilt_rate=_towards_x_and_y(journal.get("tilt_rate", {}), "0 rad/s"),
        film_start=film_start and si(film_start),
        end_pressure=si(table.get("ends", {}).get("pressure", "0 Pa")),
        feeds=[_feed(feed, radius) for feed in table.get("feed", [])],
        viscosity=si(oil["viscosity"]),
        barus=si(barus.get("alpha", "0 1/Pa")),
        as_printed=barus.get("form") == "as-printed",
        cavitation=cavitation.get("model", "none"),
        cavitation_pressure=si(cavitation.get("pressure", "0 Pa")),
    )


def _towards_x_and_y(table, nothing):
    return tuple(si(table.get(axis, nothing)) for axis in ("x", "y"))


def _feed(table, radius):
    hole = table.get("hole")
    circle = hole and Hole(radius * si(hole["angle"]), si(hole["z"]), si(hole["diameter"]) / 2)
    return Feed(table["group"], si(table["pressure"]), circle)


def write_variant(source, target, mesh=None, barus="keep", hole_keys=True, cavitation="keep", position=None):
    """Write a copy of a scene with another mesh, Barus law (None: constant viscosity), cavitation model,
    without the `hole` keys, or with a given position (keys of [journal]) instead of a load; relative
    mesh paths are made to hold from the new place."""
    with open(source, "rb") as file:
        table = tomllib.load(file)
    file = Path(source).parent / table.get("mesh", {}).get("file", "")
    table["mesh"] = {"file": str((file.parent / mesh if mesh else file).resolve())}
    if cavitation != "keep":
        table["cavitation"] = cavitation
    if position:
        table.pop("load", None)
        table["journal"] |= position
    if barus is None:
        table["oil"].pop("barus", None)
    elif barus != "keep":
        table["oil"]["barus"] = barus
    if not hole_keys:
        for feed in table.get("feed", []):
            feed.pop("hole", None)
    Path(target).write_text(_toml(table))
    return Path(target)


def _toml(table):
    """TOML text of a scene: scalars, then tables, then arrays of tables."""
    lines = []
    for key, value in sorted(table.items(), key=lambda item: isinstance(item[1], (dict, list))):
        if isinstance(value, dict):
            lines += [f"[{key}]", *_entries(value)]
        elif isinstance(value, list):
            for item in value:
                lines += [f"[[{key}]]", *_entries(item)]
        else:
            lines.append(f"{key} = {_value(value)}")
    return "\n".join(lines) + "\n"


def _entries(table):
    return [f"{key} = {_value(value)}" for key, value in table.items()]


def _value(value):
    if isinstance(value, dict):
        return "{ " + ", ".join(_entries(value)) + " }"
    return f'"{value}"' if isinstance(value, str) else repr(value)
