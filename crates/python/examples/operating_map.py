"""A map over speed and load: the least film of an engine's main bearing."""

import numpy as np
import oilwedge as ow

scene = ow.Scene.new("plain") | {"mesh.size": "4 mm"}
speeds = [f"{speed} rpm" for speed in np.arange(1000, 6001, 1000)]
table = ow.sweep(scene, {"journal.speed": speeds, "eccentricity": np.linspace(0.3, 0.9, 7)}, bars=False)
print(table)

thinnest = table["film_thickness_min [m]"]
print(f"{len(table)} cases, {1e6 * thinnest.min():.1f} to {1e6 * thinnest.max():.1f} um")
table.to_csv("map.csv")
table.plot("load", "load.svg")
