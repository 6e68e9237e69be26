"""A rotor of ROSS on two of our bearings becomes unstable at the speed that our own critical mass says.

The table that a sweep over the speed writes is read by `ross.BearingElement`. A disc in the middle of an elastic shaft
without mass (Jeffcott's rotor) whirls at the threshold with the frequency of the rigid rotor, `nu_w omega`, for there
the film is a spring of the stiffness `k = M_crit (nu_w omega)^2`: each bearing carries the mass
`k k_s/(k + k_s)/(nu_w omega)^2`, k_s the stiffness of half of the shaft.

ROSS 2 draws a smoothing spline through its tables, which misses them by about one unit; the bearing here has a hundred
times the viscosity and the load of the shipped scene, so that this is nothing.
"""

import json
import subprocess
import types

import numpy as np
import pandas
import pytest
import scipy
from scipy.linalg import eigvals
from scipy.optimize import brentq

from oilwedge_run import REPOSITORY, SCENES, program

try:
    import ross
except (ImportError, ValueError):  # version 2.3 draws by what plotly 7 has no longer
    ross = None

VERSION = None if ross is None else int(ross.__version__.split(".")[0])
LENGTH, DIAMETER, YOUNG = 0.8, 0.05, 211e9


def documented(version):
    """The blocks of the documentation that make a bearing of this version of ROSS."""
    page = (REPOSITORY / "docs/theory/dynamics.md").read_text()
    blocks = [block.split("\n", 1)[1] for block in page.split("```")[1::2] if block.startswith("python")]
    return [block for block in blocks if ("rotor_bearing_3.csv" in block) == (version == 3)]


def bearing(block, folder, package, monkeypatch):
    """The bearing that a block of the documentation makes of the tables in a folder."""
    monkeypatch.chdir(folder)
    names = {"ross": package, "pandas": pandas, "numpy": np, "scipy": scipy}
    exec(block, names)
    return names["bearing"]


def sweep(out, text):
    """Sweeps a scene into a folder."""
    scene = out / "scene.toml"
    scene.write_text(text)
    command = [program("OILWEDGE_BIN", "oilwedge"), "sweep", str(scene), "--out", str(out)]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)


@pytest.fixture(scope="module")
def swept(tmp_path_factory):
    """Folder with the tables for ROSS, and the rows of the sweep of the shipped scene."""
    out = tmp_path_factory.mktemp("whirl")
    text = (SCENES / "25_whirl.toml").read_text()
    for shipped, here in [("8 mPa.s", "800 mPa.s"), ("1.46128 kN", "146.128 kN"), ('"149 kg"', '"14.9 t"')]:
        assert shipped in text
        text = text.replace(shipped, here)
    sweep(out, text)
    return out, json.loads((out / "sweep.json").read_text())["rows"]


def rotor(own, mass):
    """Jeffcott's rotor with a disc of `mass` on two bearings like `own`."""
    shaft = ross.Material(name="light", rho=1e-3, E=YOUNG, G_s=81e9)
    elements = [
        ross.ShaftElement(
            L=LENGTH / 2,
            idl=0,
            odl=DIAMETER,
            material=shaft,
            n=n,
            shear_effects=False,
            rotary_inertia=False,
            gyroscopic=False,
        )
        for n in (0, 1)
    ]
    disc = ross.DiskElement(n=1, m=mass, Id=1e-3, Ip=1e-3)
    names = "kxx kxy kyx kyy cxx cxy cyx cyy".split()
    columns = {name: getattr(own, name) for name in names}
    return ross.Rotor(elements, [disc], [ross.BearingElement(n=n, frequency=own.frequency, **columns) for n in (0, 2)])


def growth(of, speed, spring):
    """Greatest growth rate of the lateral motions over the speed; the system is solved in units of the speed and of the
    stiffness `spring`."""
    lateral = [dof for dof in range(of.ndof) if of.number_dof == 4 or dof % of.number_dof in (0, 1, 3, 4)]
    at = np.ix_(lateral, lateral)
    mass, stiffness = speed**2 * of.M(speed)[at] / spring, of.K(speed)[at] / spring
    damping = speed * (of.C(speed) + speed * of.G())[at] / spring
    n = len(lateral)
    zero, one = np.zeros((n, n)), np.eye(n)
    roots = eigvals(np.block([[zero, one], [-stiffness, -damping]]), np.block([[one, zero], [zero, mass]]))
    return roots[np.isfinite(roots) & (abs(roots.imag) > 1e-3) & (abs(roots) < 3)].real.max()


@pytest.mark.skipif(VERSION != 2, reason="version 2 of ROSS is not installed")
def test_a_rotor_of_ross_whirls_from_our_critical_mass_on(swept, monkeypatch):
    out, rows = swept
    (block,) = documented(2)
    own = bearing(block, out, ross, monkeypatch)
    half_shaft = 24 * YOUNG * np.pi * DIAMETER**4 / 64 / LENGTH**3
    assert len(rows) == 10
    for row in rows[1:-1]:
        speed = row["inputs"]["speed"]
        critical, ratio = (row["quantities"][name]["value"] for name in ("M_crit", "nu_w"))
        whirl = ratio * speed
        film = critical * whirl**2
        mass = film * half_shaft / (film + half_shaft) / whirl**2
        of = rotor(own, 2 * mass)
        at = (of, film)
        unstable = brentq(lambda omega, at=at: growth(at[0], omega, at[1]), 0.97 * speed, 1.03 * speed, xtol=1e-9)
        assert unstable == pytest.approx(speed, rel=1e-6)


def test_the_rigid_rotor_of_the_scene_whirls_where_its_decrement_vanishes(swept):
    _, rows = swept
    speeds = [row["inputs"]["speed"] for row in rows]
    decrements = [row["quantities"]["delta"]["value"] for row in rows]
    masses = [row["quantities"]["M_crit"]["value"] for row in rows]
    ours = brentq(lambda omega: np.interp(omega, speeds, decrements), 300, 1200)
    by_mass = brentq(lambda omega: np.interp(omega, speeds, masses) - 14900, 300, 1200)
    assert ours == pytest.approx(by_mass, rel=5e-3)
    assert 900 < ours < 930


@pytest.mark.parametrize("with_whirl", [False, True])
def test_version_3_gets_speed_and_whirl(with_whirl, swept, tmp_path, monkeypatch):
    """Without version 3 a stand-in takes what it documents: 1-D tables over `speed`, or arrays of a row a speed over
    `speed` and `frequency`."""
    out, block = swept[0], documented(3)[int(with_whirl)]
    if with_whirl:
        text = (SCENES / "25_whirl.toml").read_text()
        head, columns = text[: text.index("[sweep]")], text[text.index("columns =") :]
        axes = '[sweep]\nspeed = ["400 rad/s", "800 rad/s"]\n"dynamics.whirl" = [0, 0.5, 1]\n'
        sweep(tmp_path, head.replace('"reynolds"', '"jfo"') + '[ends]\npressure = "1 bar"\n[mesh]\nsize = "8 mm"\n' + axes + columns)
        out = tmp_path
        assert not (out / "rotor_bearing.csv").exists()
    stand_in = types.SimpleNamespace(BearingElement=lambda **given: types.SimpleNamespace(**given))
    own = bearing(block, out, ross if VERSION == 3 else stand_in, monkeypatch)
    speeds = len(own.speed)
    shape = (speeds, len(own.frequency)) if with_whirl else (speeds,)
    assert all(np.shape(getattr(own, name)) == shape for name in ("kxx", "kyx", "cxy", "cyy"))
    table = pandas.read_csv(out / "rotor_bearing_3.csv")
    first = np.asarray(own.kxx).reshape(speeds, -1)[0, 0]
    assert first == pytest.approx(table.kxx[0], rel=1e-12)
