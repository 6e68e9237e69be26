"""A rotor of ROSS on two of our bearings becomes unstable at the speed that our own critical mass says.

The table that a sweep over the speed writes is read by `ross.BearingElement`. A disc in the middle of an elastic shaft without mass (Jeffcott's rotor) whirls
at the threshold with the frequency of the rigid rotor, `nu_w omega`, for there the film is a spring of the stiffness `k = M_crit (nu_w omega)^2`: each bearing
carries the mass `k k_s/(k + k_s)/(nu_w omega)^2`, k_s the stiffness of half of the shaft.

ROSS draws a smoothing spline through its tables, which misses them by about one unit; the bearing here has a hundred times the viscosity and the load of the
shipped scene, so that this is nothing.
"""

import json
import subprocess

import numpy as np
import pytest
from scipy.linalg import eigvals
from scipy.optimize import brentq

from oilwedge_run import SCENES, program

ross = pytest.importorskip("ross", reason="ROSS is not installed", exc_type=ImportError)

LENGTH, DIAMETER, YOUNG = 0.8, 0.05, 211e9


@pytest.fixture(scope="module")
def swept(tmp_path_factory):
    """Table for ROSS, and the rows of the sweep of the shipped scene."""
    out = tmp_path_factory.mktemp("whirl")
    text = (SCENES / "25_whirl.toml").read_text()
    for shipped, here in [("8 mPa.s", "800 mPa.s"), ("1.46128 kN", "146.128 kN"), ('"149 kg"', '"14.9 t"')]:
        assert shipped in text
        text = text.replace(shipped, here)
    scene = out / "scene.toml"
    scene.write_text(text)
    command = [program("OILWEDGE_BIN", "oilwedge"), "sweep", str(scene), "--out", str(out)]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    table = np.genfromtxt(out / "rotor_bearing.csv", delimiter=",", names=True)
    columns = {name: list(table[name]) for name in table.dtype.names}
    return columns, json.loads((out / "sweep.json").read_text())["rows"]


def rotor(columns, mass):
    """Jeffcott's rotor with a disc of `mass` on two bearings of the table."""
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
    return ross.Rotor(elements, [disc], [ross.BearingElement(n=n, **columns) for n in (0, 2)])


def growth(of, speed, spring):
    """Greatest growth rate of the lateral motions over the speed; the system is solved in units of the speed and of the stiffness `spring`."""
    lateral = [dof for dof in range(of.ndof) if of.number_dof == 4 or dof % of.number_dof in (0, 1, 3, 4)]
    at = np.ix_(lateral, lateral)
    mass, stiffness = speed**2 * of.M(speed)[at] / spring, of.K(speed)[at] / spring
    damping = speed * (of.C(speed) + speed * of.G())[at] / spring
    n = len(lateral)
    zero, one = np.zeros((n, n)), np.eye(n)
    roots = eigvals(np.block([[zero, one], [-stiffness, -damping]]), np.block([[one, zero], [zero, mass]]))
    return roots[np.isfinite(roots) & (abs(roots.imag) > 1e-3) & (abs(roots) < 3)].real.max()


def test_a_rotor_of_ross_whirls_from_our_critical_mass_on(swept):
    columns, rows = swept
    half_shaft = 24 * YOUNG * np.pi * DIAMETER**4 / 64 / LENGTH**3
    assert len(rows) == 10
    for row in rows[1:-1]:
        speed = row["inputs"]["speed"]
        critical, ratio = (row["quantities"][name]["value"] for name in ("M_crit", "nu_w"))
        whirl = ratio * speed
        film = critical * whirl**2
        mass = film * half_shaft / (film + half_shaft) / whirl**2
        of = rotor(columns, 2 * mass)
        at = (of, film)
        unstable = brentq(lambda omega, at=at: growth(at[0], omega, at[1]), 0.97 * speed, 1.03 * speed, xtol=1e-9)
        assert unstable == pytest.approx(speed, rel=1e-6)


def test_the_rigid_rotor_of_the_scene_whirls_where_its_decrement_vanishes(swept):
    columns, rows = swept
    speeds = [row["inputs"]["speed"] for row in rows]
    decrements = [row["quantities"]["delta"]["value"] for row in rows]
    masses = [row["quantities"]["M_crit"]["value"] for row in rows]
    ours = brentq(lambda omega: np.interp(omega, speeds, decrements), 300, 1200)
    by_mass = brentq(lambda omega: np.interp(omega, speeds, masses) - 14900, 300, 1200)
    assert ours == pytest.approx(by_mass, rel=5e-3)
    assert 900 < ours < 930
    assert len(columns["kxx"]) == len(rows)
