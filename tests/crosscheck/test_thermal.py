"""`thermal_structured.py` against the temperature field of the program, for an engine bearing and a turbine bearing.

The oils of both scenes are replaced by one with an exponential law, which the second code has.
"""

import tomllib

import numpy as np
import oilwedge as ow
import pytest

from oilwedge_run import SCENES
from thermal_structured import Bearing, Bush, Feed, Solver

HEAT_CAPACITY = 1.8e6


def exponential(viscosity, beta, at):
    """The law of viscosity as a function, and as a table of a scene."""
    return (
        lambda temperature: viscosity * np.exp(-beta * (temperature - at)),
        {"viscosity": f"{viscosity} Pa.s", "at": f"{at} C", "beta": f"{beta} 1/K"},
    )


THIN, THICK = exponential(0.010, 0.027, 90), exponential(0.0277, 0.034, 40)
RPM = np.pi / 30
ENGINE = Bearing(
    radius=0.025,
    length=0.02,
    clearance=25e-6,
    speed=4000 * RPM,
    force=5e3,
    feeds=[Feed(np.radians(20), np.radians(160), 3e-3, 4e5)],
    viscosity=THIN[0],
    conductivity=0.13,
    heat_capacity=HEAT_CAPACITY,
    inlet=90,
    bush=Bush(0.035, 45, 2000, 95),
    barus=1.5e-8,
    expansion=(1.2e-5, 1.1e-5, 20),
)
TURBINE = Bearing(
    radius=0.125,
    length=0.2,
    clearance=150e-6,
    speed=3000 * RPM,
    force=75e3,
    feeds=[Feed(np.radians(-10), np.radians(10), 0.15, 1.5e5), Feed(np.radians(170), np.radians(190), 0.15, 1.5e5)],
    viscosity=THICK[0],
    conductivity=0.13,
    heat_capacity=HEAT_CAPACITY,
    inlet=45,
    bush=Bush(0.19, 45, 50, 40),
)


def solved(name, size, law):
    """Numbers of a shipped scene, with edges of `size` and an oil of an exponential law."""
    scene = tomllib.loads(next(SCENES.glob(f"{name}_*.toml")).read_text())
    scene["oil"] = {key: scene["oil"][key] for key in scene["oil"].keys() & {"barus"}}
    scene["oil"] |= {"exponential": law, "conductivity": "0.13 W/(m.K)"}
    scene["heat"]["heat_capacity"] = f"{HEAT_CAPACITY} J/(m3.K)"
    scene["mesh"]["size"] = size
    return ow.solve(scene)


@pytest.mark.full
@pytest.mark.parametrize(
    "name, size, law, bearing, grid",
    [("36", "1 mm", THIN[1], ENGINE, (108, 20, 8)), ("38", "8 mm", THICK[1], TURBINE, (108, 16, 16))],
)
def test_a_field_of_temperature_is_that_of_a_second_code(name, size, law, bearing, grid):
    result, second = solved(name, size, law), Solver(bearing, *grid).solve()

    def near(quantity, value, part=0.0, least=0.0):
        own = result[quantity]
        assert abs(own.value - value) < own.error + part * abs(value) + least, (quantity, own, value)

    near("film_thickness_min", second["film_thickness_min"], part=5e-3)
    for quantity in ("temperature_max", "temperature_bush_max", "temperature_journal"):
        near(quantity, second[quantity], least=0.3)
    near("heat_power", second["heat_power"], part=5e-3)
    near("pressure_max", second["pressure_max"], part=1e-2)
    near("attitude_angle", second["attitude_angle"], least=0.5)
