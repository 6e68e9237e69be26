"""A bearing, its numbers, its film, and what happens where there is none."""

import oilwedge as ow

scene = ow.Scene.new("hole")
result = ow.solve(scene)
print(result)

load = result["load"]
print(load.description, load, load.to("kN").value, load.error)

film = result.film
print(film.pressure.max(), film.sample("pressure", angle=[150, 170, 190], z=0.0))
result.plot("pressure", "pressure.svg")
result.report("bearing.html")

slower = scene | {"journal.speed": "500 rpm"}
print(ow.solve(slower, bars=False)["load"])

try:
    scene | {"journal.speed": "500 mm"}
except ow.SceneError as error:
    for complaint in error.complaints:
        print(complaint.key, complaint.message, complaint.help)

try:
    ow.solve(scene | {"oil.barus.alpha": "1e-5 1/Pa"})
except ow.NoSolution as error:
    print(error.result.status, error)
