"""The temperature of a film around and across it, by finite volumes on a grid along the flow.

An independent second answer to `heat.field = true`: cells around, along (half of the length, z = 0 is the line of
symmetry) and across the film, and cells in the bush around it. The film conserves oil (Jakobsson, Floberg, Olsson) with
Dowson's integrals of the viscosity across; the heat that the layers carry is taken from upstream along the film by the
limiter of van Leer, and from both sides across it. The journal has one temperature and takes no heat in sum; each feed
has one temperature, that of the oil supplied and of what flows into it.
"""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import root
from scipy.sparse import coo_matrix, diags_array
from scipy.sparse.linalg import LinearOperator, gmres, splu

ROUNDS = 40
SETTLED = 5e-4  # K, root of the mean square of a round's change
HISTORY = 4  # changes that Anderson's mixing remembers


@dataclass
class Feed:
    """A groove from one angle to another [rad] over the middle `width` [m], at a pressure [Pa]."""

    start: float
    end: float
    width: float
    pressure: float


@dataclass
class Bush:
    """A ring with insulated ends: outer radius [m], conductivity [W/(m K)], transfer [W/(m2 K)] to `ambient` [C]."""

    outer_radius: float
    conductivity: float
    transfer: float
    ambient: float


@dataclass
class Bearing:
    """SI units, temperatures in C; `force` [N] points downwards (270 degrees), `expansion` is (shaft, bush, at)."""

    radius: float
    length: float
    clearance: float
    speed: float  # rad/s
    force: float
    feeds: list[Feed]
    viscosity: callable  # [Pa s] of a temperature
    conductivity: float
    heat_capacity: float  # [J/(m3 K)]
    inlet: float
    bush: Bush
    barus: float = 0.0
    expansion: tuple[float, float, float] | None = None


@dataclass
class State:
    """Temperatures of the film (nx, nz, layers), of the bush (nr, nx, nz), of the journal and of the feeds."""

    film: np.ndarray
    bush: np.ndarray
    journal: float
    feeds: np.ndarray

    def flat(self):
        return np.concatenate([self.film.ravel(), self.bush.ravel(), [self.journal], self.feeds])

    def like(self, flat):
        parts = np.split(flat, np.cumsum([self.film.size, self.bush.size, 1]))
        return State(parts[0].reshape(self.film.shape), parts[1].reshape(self.bush.shape), parts[2][0], parts[3])


class Solver:
    """A bearing on a grid of `columns` around, `rows` along half of it, `layers` across and `shells` in the bush.

    Edges of feeds lie on grid lines."""

    def __init__(self, bearing, columns, rows, layers, shells=8):
        self.bearing, self.shape = bearing, (columns, rows)
        self.dx = 2 * np.pi * bearing.radius / columns
        self.dz = bearing.length / 2 / rows
        self.phi = 2 * np.pi * (np.arange(columns) + 0.5) / columns
        z = self.dz * (np.arange(rows) + 0.5)
        self.edges = (1 - np.cos(np.pi * np.linspace(0, 1, layers + 1))) / 2
        radii = np.linspace(0, 1, shells + 1) ** 1.5
        self.radii = bearing.radius + (bearing.bush.outer_radius - bearing.radius) * radii
        self.feed = np.full(self.shape, -1)
        for number, feed in enumerate(bearing.feeds):
            middle, half = (feed.start + feed.end) / 2, (feed.end - feed.start) / 2
            off = np.abs((self.phi - middle + np.pi) % (2 * np.pi) - np.pi)
            self.feed[np.ix_(off < half, z < feed.width / 2)] = number
        self.land = self.feed < 0
        self.supplied = np.array([feed.pressure for feed in bearing.feeds] + [0.0])[self.feed]
        self.number = np.arange(columns * rows).reshape(self.shape)
        self.faces = [self._around(), self._along()]
        self.factor = None

    # Faces of the grid: cells on both sides, as numbers.

    def _around(self):
        return self.number, np.roll(self.number, -1, axis=0)

    def _along(self):
        return self.number[:, :-1], self.number[:, 1:]

    # The film

    def clearance(self, state):
        """The clearance that the temperatures of journal and bush leave."""
        if self.bearing.expansion is None:
            return self.bearing.clearance
        shaft, bush, at = self.bearing.expansion
        grown = bush * (self.bore(state).mean() - at) - shaft * (state.journal - at)
        return self.bearing.clearance + self.bearing.radius * grown

    def bore(self, state):
        """Temperature of the bore (nx, nz): the first shell and half of it inwards at the flux of its neighbour."""
        r = (self.radii[1:] + self.radii[:-1]) / 2
        slope = (state.bush[1] - state.bush[0]) / np.log(r[1] / r[0])
        return state.bush[0] + slope * np.log(self.radii[0] / r[0])

    def integrals(self, state):
        """F0, the share 1 - F1/F0 of the speed with which oil is dragged, and F2 of each cell (nx, nz)."""
        fluidity = 1 / self.bearing.viscosity(state.film)
        first = np.diff(self.edges)
        f0 = fluidity @ first
        f1 = fluidity @ (np.diff(self.edges**2) / 2)
        f2 = fluidity @ (np.diff(self.edges**3) / 3) - f1**2 / f0
        return f0, 1 - f1 / f0, f2

    def thickness(self, phi, position, clearance):
        return clearance - position[0] * np.cos(phi) - position[1] * np.sin(phi)

    def film(self, state, position, cavity):
        """(q, theta, cavity) of the journal at `position` [m]: q is the pressure of one viscosity, which Barus' law
        turns into p."""
        u, clearance = self.bearing.speed * self.bearing.radius, self.clearance(state)
        _, share, f2 = self.integrals(state)
        face = self.thickness(self.phi + np.pi / self.shape[0], position, clearance)
        middle = self.thickness(self.phi, position, clearance)
        self.gap = middle[:, None] * np.ones(self.shape)
        land = self.land
        self.pressure_conductance, self.dragged = [], []
        for axis, (a, b) in enumerate(self.faces):
            first, second = land.ravel()[a], land.ravel()[b]
            open_face = first | second

            def mean(values):
                one, other = values.ravel()[a], values.ravel()[b]
                return np.where(first & second, (one + other) / 2, np.where(first, one, other))

            gap = face[:, None] if axis == 0 else middle[:, None]
            step, width = (self.dx, self.dz) if axis == 0 else (self.dz, self.dx)
            distance = np.where(first & second, step, step / 2)
            self.pressure_conductance.append(np.where(open_face, gap**3 * mean(f2) * width / distance, 0.0))
            self.dragged.append(np.where(open_face, u * gap * width * mean(share), 0.0) if axis == 0 else None)
        end = middle**3 * f2[:, -1] * self.dx / (self.dz / 2)
        self.end_conductance = np.where(land[:, -1], end, 0.0)
        held = np.where(land, 0.0, self.reduced(self.supplied)).ravel()
        free = land.ravel()
        size = self.number.size
        rows, columns, values = [], [], []
        for (a, b), weight in zip(self.faces, self.pressure_conductance):
            rows += [a, b, a, b]
            columns += [a, b, b, a]
            values += [weight, weight, -weight, -weight]
        rows.append(self.number[:, -1]), columns.append(self.number[:, -1]), values.append(self.end_conductance)
        conductance = sparse(rows, columns, values, size)
        a, b = self.faces[0]
        drag = sparse([a, b], [a, a], [self.dragged[0], -self.dragged[0]], size)
        scale = abs(drag.data).max() / abs(conductance.data).max()
        for _ in range(200):
            full = (~cavity).astype(float)
            matrix = scale * conductance @ diags_array(full) + drag @ diags_array(1 - full)
            right = -drag @ full - conductance @ held
            unknown = np.zeros(size)
            unknown[free] = splu(matrix.tocsr()[free][:, free].tocsc(), permc_spec="MMD_AT_PLUS_A").solve(right[free])
            q = np.where(cavity, 0.0, scale * unknown) + held
            theta = np.where(cavity, unknown, 1.0)
            change = free & np.where(cavity, theta > 1 + 1e-12, q < 0)
            if not change.any():
                return q.reshape(self.shape), theta.reshape(self.shape), cavity
            cavity = cavity ^ change
        raise RuntimeError("the active set did not settle")

    def reduced(self, pressure):
        """(1 - exp(-alpha p))/alpha, in which Barus' film is linear."""
        alpha = self.bearing.barus
        return pressure if alpha == 0 else -np.expm1(-alpha * pressure) / alpha

    def pressure(self, q):
        alpha = self.bearing.barus
        return q if alpha == 0 else -np.log1p(-alpha * q) / alpha

    def force(self, q):
        p = self.pressure(q).sum(axis=1) * 2 * self.dx * self.dz
        return np.array([-p @ np.cos(self.phi), -p @ np.sin(self.phi)])

    def balanced(self, state, position, cavity):
        """The film whose force carries the load, and where its journal is."""
        kept, clearance = [cavity], self.clearance(state)

        def place(free):
            """Every pair of numbers is a place within the clearance."""
            return clearance * free / np.hypot(1.0, np.hypot(*free))

        def rest(free):
            q, _, kept[0] = self.film(state, place(free), kept[0])
            return (self.force(q) - [0.0, self.bearing.force]) / self.bearing.force

        free = root(rest, position / np.sqrt(clearance**2 - position @ position), tol=1e-10).x
        return (place(free), *self.film(state, place(free), kept[0]))

    # Heat

    def velocities(self, state, axis, q, theta):
        """Oil (faces, layers) that each layer carries over the faces, and where it comes from."""
        a, b = self.faces[axis]
        temperatures = state.film.reshape(self.number.size, -1)
        first, second = self.land.ravel()[a], self.land.ravel()[b]
        warm = np.where((first & second)[..., None], (temperatures[a] + temperatures[b]) / 2,
                        np.where(first[..., None], temperatures[a], temperatures[b]))
        fluidity = 1 / self.bearing.viscosity(warm)
        _, from_drag, from_pressure = profiles(fluidity, self.edges)
        flow = self.pressure_conductance[axis] * (q.ravel()[a] - q.ravel()[b])
        # Shares of the layers in what pressure drives and in what is dragged; both sum to one.
        oil = flow[..., None] * from_pressure / from_pressure.sum(axis=-1, keepdims=True)
        if axis == 0:
            dragged = self.dragged[0] * theta.ravel()[a]
            oil = oil + dragged[..., None] * from_drag / from_drag.sum(axis=-1, keepdims=True)
        return oil

    def heated(self, state, q, theta):
        """The temperatures that the flows and the friction of a film make."""
        b, land = self.bearing, self.land.ravel()
        nx, nz = self.shape
        layers, shells, cells = len(self.edges) - 1, len(self.radii) - 1, self.number.size
        capacity, depth = b.heat_capacity, np.diff(self.edges)
        film = np.arange(cells * layers).reshape(cells, layers)
        ring = cells * layers + np.arange(shells * cells).reshape(shells, nx, nz)
        journal = cells * layers + shells * cells
        feeds = journal + 1 + np.arange(len(b.feeds))
        size = feeds[-1] + 1
        rows, columns, values, right = [], [], [], np.zeros(size)

        def add(row, column, value):
            row, column, value = np.broadcast_arrays(row, column, value)
            rows.append(row.ravel()), columns.append(column.ravel()), values.append(value.ravel())

        owner = np.where(land[:, None], film, feeds[self.feed.ravel()][:, None])
        outflow = np.zeros((cells, layers))
        previous = np.where(land[:, None], state.film.reshape(cells, layers), 0.0)
        previous[~land] = state.feeds[self.feed.ravel()[~land]][:, None]
        inflow = np.zeros(size)
        for axis, (one, other) in enumerate(self.faces):
            oil = self.velocities(state, axis, q, theta) * capacity
            both = (land[one] | land[other])[..., None]
            oil = np.where(both, oil, 0.0)
            np.add.at(outflow, one, oil), np.add.at(outflow, other, -oil)
            source = np.where(oil > 0, owner[one], owner[other])
            add(owner[one], source, oil), add(owner[other], source, -oil)
            # Van Leer's limited rest, by the temperatures of the round before.
            rest = oil * self._limited(previous, axis, oil)
            np.subtract.at(right, owner[one], rest), np.add.at(right, owner[other], rest)
            np.add.at(inflow, owner[one], -oil), np.add.at(inflow, owner[other], oil)
        last = self.number[:, -1]
        end = self.end_conductance * q[:, -1] * capacity
        warm = state.film[:, -1]
        _, _, shares = profiles(1 / b.viscosity(warm), self.edges)
        oil = end[:, None] * shares / shares.sum(axis=1, keepdims=True)
        outflow[last] += oil
        add(owner[last], owner[last], oil)

        # Across: what leaves a layer sideways enters it through its faces, and heat is conducted.
        gap, part = self.gap.ravel(), theta.ravel()
        through = -np.cumsum(outflow, axis=1)[:, :-1]
        conducted = part * b.conductivity * self.dx * self.dz / gap
        cell = land.nonzero()[0]
        for layer in range(layers - 1):
            lower, upper = film[cell, layer], film[cell, layer + 1]
            flow, rate = through[cell, layer], conducted[cell] / ((depth[layer] + depth[layer + 1]) / 2)
            for side in (lower, upper):
                sign = 1.0 if side is lower else -1.0
                add(side, lower, sign * (flow / 2 + rate)), add(side, upper, sign * (flow / 2 - rate))
        # Walls: half a layer of oil to the journal; half a layer and half a shell to the bush.
        rate = 2 * conducted[cell] / depth[-1]
        top, under = film[cell, -1], film[cell, 0]
        add(top, top, rate), add(top, journal, -rate), add(journal, journal, rate), add(journal, top, -rate)
        r = (self.radii[1:] + self.radii[:-1]) / 2
        turn = 2 * np.pi / nx
        inner = turn * self.dz * b.bush.conductivity / np.log(r[0] / self.radii[0])
        rate = 1 / (depth[0] / (2 * conducted[cell]) + 1 / inner)
        bore = ring[0].ravel()[cell]
        add(under, under, rate), add(under, bore, -rate), add(bore, bore, rate), add(bore, under, -rate)

        # The bush
        def joined(one, other, rate):
            add(one, one, rate), add(one, other, -rate), add(other, other, rate), add(other, one, -rate)

        k = b.bush.conductivity
        thickness = np.diff(self.radii)
        for shell in range(shells):
            if shell + 1 < shells:
                joined(ring[shell], ring[shell + 1], turn * self.dz * k / np.log(r[shell + 1] / r[shell]))
            joined(ring[shell], np.roll(ring[shell], -1, axis=0), k * thickness[shell] * self.dz / (r[shell] * turn))
            joined(ring[shell][:, :-1], ring[shell][:, 1:], k * thickness[shell] * r[shell] * turn / self.dz)
        outer = 1 / (np.log(self.radii[-1] / r[-1]) / (turn * self.dz * k)
                     + 1 / (b.bush.transfer * self.radii[-1] * turn * self.dz))
        add(ring[-1], ring[-1], outer)
        right[ring[-1]] += outer * b.bush.ambient

        # Feeds: what the supply brings, or takes away.
        supplied = -inflow[feeds]
        for number, row in enumerate(feeds):
            if supplied[number] > 0:
                right[row] += supplied[number] * b.inlet
            else:
                add(row, row, -supplied[number])
        # Within a feed there is no film.
        hole = film[~land].ravel()
        add(hole, hole, 1.0), add(hole, np.repeat(feeds[self.feed.ravel()[~land]], layers), -1.0)

        right[film[cell]] += self.friction(state, q, theta)[cell]
        matrix = coo_matrix((np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))), (size, size))
        # The journal touches every cell: it is bordered.
        inside = np.arange(size) != journal
        matrix = matrix.tocsr()
        inner = matrix[inside][:, inside]
        column, row = matrix[inside][:, [journal]].toarray().ravel(), matrix[[journal]][:, inside].toarray().ravel()
        free, answer = self.solved(inner, right[inside]), self.solved(inner, column)
        value = (right[journal] - row @ free) / (matrix[journal, journal] - row @ answer)
        flat = np.insert(free - value * answer, journal, value)
        return state.like(flat)

    def solved(self, matrix, right):
        """The factor of an earlier round is a good preconditioner for this one's matrix."""
        if self.factor is not None:
            earlier = LinearOperator(matrix.shape, self.factor.solve)
            found, failed = gmres(matrix, right, rtol=1e-11, restart=20, maxiter=1, M=earlier)
            if not failed:
                return found
        self.factor = splu(matrix.tocsc(), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.1, options={"SymmetricMode": True})
        return self.factor.solve(right)

    def _limited(self, temperatures, axis, oil):
        """Half of the step from the cell upstream towards the face, limited by the one before it (van Leer)."""
        field = temperatures.reshape(*self.shape, -1)
        if axis == 0:
            before, after, next_one = np.roll(field, 1, 0), np.roll(field, -1, 0), np.roll(field, -2, 0)
            behind, step, ahead = field - before, after - field, next_one - after
        else:
            step = np.diff(field, axis=1)
            edge = np.zeros_like(step[:, :1])
            behind = np.concatenate([edge, step[:, :-1]], 1)
            ahead = np.concatenate([step[:, 1:], edge], 1)
        upstream = np.where(oil > 0, behind, -ahead)
        own = np.where(oil > 0, step, -step)
        product = upstream * own
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.where(product > 0, product / (upstream + own), 0.0)

    def friction(self, state, q, theta):
        """Heat of friction [W] of each layer (cells, layers), of half of the length."""
        u = self.bearing.speed * self.bearing.radius
        h = self.gap[..., None]
        fluidity = 1 / self.bearing.viscosity(state.film)
        f0, share, _ = (values[..., None] for values in self.integrals(state))
        slope_x, slope_z = self._slopes(q)
        middle, depth = (self.edges[1:] + self.edges[:-1]) / 2, np.diff(self.edges)
        thicker = np.exp(self.bearing.barus * self.pressure(q))[..., None]
        # Exact for a viscosity that is constant in a layer: mean square of a linear function.
        spread = depth**2 / 12
        offset = middle - (1 - share)
        along = (h**2 * slope_x[..., None] * offset + u / f0) ** 2 + (h**2 * slope_x[..., None]) ** 2 * spread
        across = (h**2 * slope_z[..., None]) ** 2 * (offset**2 + spread)
        heat = theta[..., None] * thicker * fluidity / h * (along + across) * depth * self.dx * self.dz
        return heat.reshape(self.number.size, -1)

    def _slopes(self, q):
        """Gradient of q in each cell: the mean of both faces."""
        faces = []
        for axis, (a, b) in enumerate(self.faces):
            first, second = self.land.ravel()[a], self.land.ravel()[b]
            step = self.dx if axis == 0 else self.dz
            distance = np.where(first & second, step, step / 2)
            faces.append((q.ravel()[b] - q.ravel()[a]) / distance)
        x = (faces[0] + np.roll(faces[0], 1, axis=0)) / 2
        end = -q[:, -1:] / (self.dz / 2)
        z = np.concatenate([np.zeros_like(end), faces[1], end], axis=1)
        return x, (z[:, 1:] + z[:, :-1]) / 2

    # The loop

    def solve(self):
        """Temperatures and film in balance with each other: Anderson's mixing of all temperatures."""
        nx, nz = self.shape
        layers, shells = len(self.edges) - 1, len(self.radii) - 1
        b = self.bearing
        warm = b.inlet + 5.0
        state = State(np.full((nx, nz, layers), warm), np.full((shells, nx, nz), warm), warm, np.full(len(b.feeds), b.inlet))
        place, cavity = np.array([0.3, -0.5]) * b.clearance, np.zeros(self.number.size, dtype=bool)
        inputs, changes = [], []
        for round_ in range(1, ROUNDS):
            place, q, theta, cavity = self.balanced(state, place, cavity)
            given, change = state.flat(), self.heated(state, q, theta).flat() - state.flat()
            size = np.sqrt(np.mean(change**2))
            if size < SETTLED:
                return self.result(state, place, q, theta, round_)
            inputs.append(given), changes.append(change)
            inputs, changes = inputs[-HISTORY - 1:], changes[-HISTORY - 1:]
            mixed = given + change
            if len(changes) > 1:
                steps = np.array([change - old for old in changes[:-1]]).T
                weights = np.linalg.lstsq(steps, change, rcond=None)[0]
                moved = np.array([given + change - old - past for old, past in zip(inputs[:-1], changes[:-1])]).T
                mixed = mixed - moved @ weights
            state = state.like(mixed)
        raise RuntimeError("temperatures did not settle")

    def result(self, state, place, q, theta, rounds):
        clearance, bore = self.clearance(state), self.bore(state)
        friction = 2 * self.friction(state, q, theta)[self.land.ravel()].sum()
        return {
            "film_thickness_min": clearance - np.hypot(*place),
            "attitude_angle": (np.degrees(np.arctan2(place[1], place[0])) + 90) % 360,
            "pressure_max": self.pressure(q).max(),
            "heat_power": friction,
            "temperature_max": max(state.film[self.land].max(), bore.max()),
            "temperature_bush_max": bore.max(),
            "temperature_journal": state.journal,
            "rounds": rounds,
        }


def profiles(fluidity, edges):
    """Dowson's F0 and how the layers share what the journal drags and what pressure drives, (.., layers) each.

    With a = Int_0^eta 1/mu and b = Int_0^eta s/mu the dragged oil goes as a, the driven as (F1/F0) a - b."""
    depth = np.diff(edges)
    ends_a = np.cumsum(fluidity * depth, axis=-1)
    begin_a = ends_a - fluidity * depth
    half = np.diff(edges**2) / 2
    ends_b = np.cumsum(fluidity * half, axis=-1)
    begin_b = ends_b - fluidity * half
    a = (begin_a + ends_a) / 2 * depth
    b = begin_b * depth + fluidity * (edges[:-1] * depth**2 / 2 + depth**3 / 6)
    f0, f1 = ends_a[..., -1:], ends_b[..., -1:]
    return f0[..., 0], a, f1 / f0 * a - b


def sparse(rows, columns, values, size):
    flat = [np.concatenate([np.ravel(part) for part in parts]) for parts in (values, rows, columns)]
    return coo_matrix((flat[0], (flat[1], flat[2])), (size, size)).tocsr()
