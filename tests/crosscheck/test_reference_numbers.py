"""`film.py` itself against converged numbers: no Rust program is needed here.

C_w and the attitude angle [deg] were computed on a mesh with cells of 0.025 R (0.01 R at the hole),
where the last halving of the cells changed C_w by less than 1e-4 and the angle by less than 1e-4 deg.
"""

import numpy as np
import pytest

from film import rule_of_degree, solve_film
from oilwedge_run import SCENES
from scene_file import read_scene, write_variant

PRINTED = {"alpha": "2.5e-8 1/Pa", "form": "as-printed"}
CONVERGED = [  # scene, Barus law, C_w, attitude angle, relative tolerance of C_w
    ("02_flexpde_shell", None, 20.0417, 66.7440, 5e-5),
    ("02_flexpde_shell", "keep", 20.8795, 65.5856, 5e-5),
    ("06_flexpde_as_printed", "keep", 22.2346, 62.1423, 5e-5),
    ("03_hydrostatic_shell", None, 0.285794, 42.5398, 5e-5),
    ("03_hydrostatic_shell", "keep", 0.285634, 42.5404, 5e-5),
    ("04_flexpde_ring", None, 64.1187, 111.0018, 5e-5),
    ("04_flexpde_ring", "keep", 60.8901, 108.8541, 5e-5),
    ("04_flexpde_ring", PRINTED, 58.0212, 104.9150, 5e-5),
    ("08_flexpde_study_size", "keep", 20.8795, 65.5856, 1e-3),
]


@pytest.mark.parametrize(("scene", "barus", "c_w", "attitude", "tolerance"), CONVERGED)
def test_converged_load_coefficient(scene, barus, c_w, attitude, tolerance, tmp_path):
    path = write_variant(SCENES / f"{scene}.toml", tmp_path / "scene.toml", barus=barus)
    film = solve_film(read_scene(path), rule_of_degree(8))
    assert film.load_coefficient == pytest.approx(c_w, rel=tolerance)
    assert np.degrees(film.attitude_angle) == pytest.approx(attitude, abs=100 * tolerance)


def test_full_sommerfeld_ring_has_a_right_angle_of_attitude():
    film = solve_film(read_scene(SCENES / "01_plain_ring.toml"), rule_of_degree(8))
    assert np.degrees(film.attitude_angle) == pytest.approx(90.0, abs=1e-4)
