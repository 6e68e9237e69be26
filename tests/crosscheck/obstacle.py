"""Quadratic programs with lower bounds by an interior point method.

    minimise  x.A x / 2 - b.x   subject to   x_i >= lower_i on `bounded`,   x_k = value_k on `fixed`

A is symmetric and positive definite on the free unknowns, so the answer is unique, whatever method finds it.
Optimality, with slack s = x - lower and multiplier m of the bounds:

    A x - b = m,   s >= 0,   m >= 0,   s m = 0

Mehrotra's predictor and corrector (SIAM J. Optim. 2 (1992) 575): nothing is guessed about the contact set.
"""

import numpy as np
from scipy.sparse import diags_array
from scipy.sparse.linalg import splu

STEPS = 80
TO_THE_WALL = 0.995  # part of the way to the nearest bound that a step may go


def solve_bounded(matrix, right, lower, bounded, fixed):
    """x and the multiplier m (zero off the bounds); `fixed` is a dictionary number -> value."""
    x = np.zeros(len(right))
    known = np.fromiter(fixed.keys(), int)
    x[known] = np.fromiter(fixed.values(), float)
    free = np.setdiff1d(np.arange(len(right)), known)
    bounded = np.intersect1d(bounded, free)
    matrix = matrix.tocsr()
    right = (right - matrix @ x)[free]
    matrix = matrix[free][:, free].tocsc()
    place = np.searchsorted(free, bounded)
    x[free], multiplier = _interior_point(matrix, right, lower, place)
    full = np.zeros(len(x))
    full[bounded] = multiplier
    return x, full


def _interior_point(matrix, right, lower, bounded):
    """All unknowns free, those in `bounded` at least `lower`."""
    x = factorised(matrix)(right)
    size = np.abs(x - lower).max()
    force = np.abs(matrix.diagonal()[bounded]).mean() * size
    slack = np.maximum(x[bounded] - lower, 1e-2 * size)
    multiplier = np.full(len(bounded), 1e-2 * force)
    for _ in range(STEPS):
        gap = slack @ multiplier / len(bounded)
        dual = matrix @ x - right
        dual[bounded] -= multiplier
        primal = x[bounded] - lower - slack
        worst = max(np.abs(dual).max() / force, np.abs(primal).max() / size)
        if gap < 1e-17 * size * force and worst < 1e-11:
            return x, multiplier
        barrier = np.zeros(len(x))
        barrier[bounded] = multiplier / slack
        solve = factorised(matrix + diags_array(barrier))

        def step(target):
            """Newton's step towards slack * multiplier = target."""
            wanted = (target - multiplier * (slack + primal)) / slack
            load = -dual
            load[bounded] += wanted
            change = solve(load)
            slack_change = change[bounded] + primal
            return change, slack_change, (target - slack * multiplier - multiplier * slack_change) / slack

        _, s, m = step(0.0)
        reach = min(_reach(slack, s), _reach(multiplier, m))
        after = (slack + reach * s) @ (multiplier + reach * m) / len(bounded)
        change, s, m_new = step(gap * (after / gap) ** 3 - s * m)
        reach = TO_THE_WALL * min(_reach(slack, s), _reach(multiplier, m_new))
        reach = min(1.0, reach)
        x, slack, multiplier = x + reach * change, slack + reach * s, multiplier + reach * m_new
    raise RuntimeError("the interior point method did not converge")


def _reach(value, change):
    """Largest step along `change` that keeps `value` from falling below zero."""
    falling = change < 0
    return np.min(-value[falling] / change[falling], initial=1.0 / TO_THE_WALL)


def factorised(matrix):
    """Solves with a symmetric positive definite matrix, whose order keeps the factors thin."""
    options = {"SymmetricMode": True}
    return splu(matrix.tocsc(), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options=options).solve
