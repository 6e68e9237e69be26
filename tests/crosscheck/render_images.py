"""Pictures of a film, off screen: p, h and mu on the cylinder and unrolled, and p along two lines.

    python render_images.py FOLDER [SCENE]

SCENE is scenes/02_flexpde_shell.toml unless given; of a mass-conserving film, film fraction and pressure in one
picture (docs/images/grooved_ring.png: scene 13; engine_main_bearing.png: scene 17), and nothing else. No display is needed: without one VTK warns
once ("bad X server connection") and draws off screen all the same.
"""

import sys
import tempfile
import tomllib
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import pyvista
from matplotlib.tri import Triangulation

from oilwedge_run import SCENES, solve
from scene_file import read_scene, si

SIZE = (1400, 950)
FIELDS = {  # field: (title with unit, scale, colour map)
    "pressure": ("Pressure p, MPa", 1e-6, "viridis"),
    "film_thickness": ("Film thickness h, um", 1e6, "cividis"),
    "viscosity": ("Viscosity mu, Pa s", 1.0, "plasma"),
}
BAR = {
    "vertical": False, "title_font_size": 32, "label_font_size": 26, "n_labels": 5,
    "fmt": "%.3g", "width": 0.6, "height": 0.12, "position_x": 0.2, "position_y": 0.02,
}  # fmt: skip


def surface_with_units(grid):
    """Finely divided surface (quadratic cells are curved) with the fields in the pictures' units."""
    surface = grid.extract_surface(nonlinear_subdivision=3, algorithm="dataset_surface")
    for name, (title, scale, _) in FIELDS.items():
        surface.point_data[title] = scale * surface.point_data[name]
    return surface


def plotter(surface, name):
    """An off-screen window that shows one field on a surface."""
    title, _, colours = FIELDS[name]
    window = pyvista.Plotter(off_screen=True, window_size=SIZE)
    window.set_background("white")
    window.add_mesh(
        surface, scalars=title, cmap=colours, smooth_shading=False, lighting=False,
        scalar_bar_args=BAR | {"title": title + "\n", "color": "black"},  # room above the numbers
    )  # fmt: skip
    return window


def save(window, path):
    window.screenshot(str(path))
    window.close()


def cylinder_picture(grid, name, path):
    window = plotter(surface_with_units(grid), name)
    x, y = np.asarray(grid.points).mean(axis=0)[:2]
    angle = np.arctan2(y, x) if np.hypot(x, y) > 1e-3 else 0.7  # look at the outside of the shell
    window.view_vector((np.cos(angle + 0.5), np.sin(angle + 0.5), 0.6), viewup=(0, 0, 1))
    window.camera.zoom(0.85)
    save(window, path)


def add_axes(window, mesh, ranges):
    """Axes with the angle in degrees and z in mm, whatever the picture's own coordinates are."""
    window.show_bounds(
        mesh=mesh, axes_ranges=ranges, xtitle="Angle phi, deg", ytitle="z, mm", ztitle=" ",
        color="black", font_size=22, location="outer", fmt="%.4g", use_2d=False,
        n_xlabels=5, n_ylabels=3, show_zaxis=False, show_zlabels=False,
    )  # fmt: skip


def developed_ranges(grid, radius):
    """[phi_from, phi_to, z_from, z_to] in degrees and mm, and no third range."""
    x_low, x_high, z_low, z_high = grid.bounds[:4]
    return [*np.degrees([x_low / radius, x_high / radius]), 1e3 * z_low, 1e3 * z_high, 0, 0]


def unrolled_picture(grid, radius, name, path):
    surface = surface_with_units(grid)
    window = plotter(surface, name)
    add_axes(window, surface, developed_ranges(grid, radius))
    window.view_xy()
    window.camera.zoom(1.0)
    save(window, path)


def surface_picture(grid, radius, path):
    """The pressure as a height over the unrolled film."""
    surface = surface_with_units(grid)
    title = FIELDS["pressure"][0]
    height = surface.point_data[title]
    surface.points[:, 2] = 0.6 * np.ptp(surface.points[:, 1]) * height / np.ptp(height)
    window = plotter(surface, "pressure")
    add_axes(window, surface, developed_ranges(grid, radius))
    window.view_vector((-0.6, -1.0, 0.7), viewup=(0, 0, 1))
    window.camera.zoom(0.85)
    save(window, path)


def conserving_picture(grid, radius, path):
    """Film fraction and pressure, unrolled. Each quadratic triangle is drawn as the four linear ones of the scheme:
    its own interpolation would overshoot where the film breaks."""
    x, z = np.asarray(grid.points).T[:2]
    corners = grid.cells.reshape(-1, 7)[:, 1:]
    parts = np.concatenate([corners[:, part] for part in ([0, 3, 5], [3, 1, 4], [5, 4, 2], [3, 4, 5])])
    drawn = Triangulation(np.degrees(x / radius), 1e3 * z, parts)
    figure, axes = plt.subplots(2, 1, figsize=(11, 6.4), dpi=100, sharex=True, layout="constrained")
    fields = (
        ("Film fraction", grid.point_data["film_fraction"], "cividis", (0, 1)),
        ("Pressure, kPa", 1e-3 * grid.point_data["pressure"], "viridis", (None, None)),
    )
    for axis, (title, values, colours, (low, high)) in zip(axes, fields):
        shown = axis.tripcolor(drawn, values, shading="gouraud", cmap=colours, vmin=low, vmax=high)
        figure.colorbar(shown, ax=axis, label=title, pad=0.01)
        axis.set(ylabel="z, mm", xlim=(drawn.x.min(), drawn.x.max()))
    ticks = np.arange(-360, 721, 45)
    axes[1].set(xlabel="Angle phi, deg", xticks=ticks[(ticks >= drawn.x.min() - 1) & (ticks <= drawn.x.max() + 1)])
    figure.savefig(path)
    plt.close(figure)


def line_picture(grid, scene, path):
    """Pressure along the length and around the film, both through its highest node."""
    x_top, z_top = np.asarray(grid.points)[np.argmax(grid.point_data["pressure"])][:2]
    x_low, x_high, z_low, z_high = grid.bounds[:4]
    figure, axes = plt.subplots(1, 2, figsize=(12, 5), dpi=100, sharey=True, layout="constrained")
    along = np.column_stack([np.full(400, x_top), np.linspace(z_low, z_high, 400)])
    around = np.column_stack([np.linspace(x_low, x_high, 800), np.full(800, z_top)])
    phi_top = np.degrees(x_top / scene.radius)
    lines = (
        (axes[0], along, 1e3 * along[:, 1], "z, mm", f"along the length, phi = {phi_top:.1f} deg"),
        (axes[1], around, np.degrees(around[:, 0] / scene.radius), "Angle phi, deg",
         f"around the film, z = {1e3 * z_top:.1f} mm"),
    )  # fmt: skip
    for axis, points, place, label, title in lines:
        cloud = pyvista.PolyData(np.column_stack([points, np.zeros(len(points))]))
        sampled = cloud.sample(grid, tolerance=1e-7)
        inside = sampled["vtkValidPointMask"].astype(bool)
        axis.plot(place, np.where(inside, 1e-6 * sampled["pressure"], np.nan), lw=2)
        axis.set(xlabel=label, title=title)
        axis.grid(alpha=0.3)
    axes[0].set_ylabel("Pressure p, MPa")
    figure.savefig(path)
    plt.close(figure)


def main(folder, scene_path):
    folder.mkdir(parents=True, exist_ok=True)
    table = tomllib.loads(scene_path.read_text())
    if table.get("cavitation", {}).get("model") == "jfo":
        with tempfile.TemporaryDirectory() as out:
            _, plane = solve(scene_path, Path(out), unrolled=True)
        name = scene_path.stem.partition("_")[2]
        conserving_picture(plane, si(table["bearing"]["diameter"]) / 2, folder / f"{name}.png")
        return
    scene = read_scene(scene_path)
    with tempfile.TemporaryDirectory() as out:
        _, plane = solve(scene_path, Path(out) / "plane", unrolled=True)
        _, cylinder = solve(scene_path, Path(out) / "cylinder", unrolled=False)
    for name in FIELDS:
        cylinder_picture(cylinder, name, folder / f"{name}_cylinder.png")
        unrolled_picture(plane, scene.radius, name, folder / f"{name}_unrolled.png")
    surface_picture(plane, scene.radius, folder / "pressure_surface.png")
    line_picture(plane, scene, folder / "pressure_lines.png")


if __name__ == "__main__":
    default = SCENES / "02_flexpde_shell.toml"
    main(Path(sys.argv[1]), Path(sys.argv[2]) if len(sys.argv) > 2 else default)
