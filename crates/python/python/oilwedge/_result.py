"""Results: numbers with error bars, and the film."""

from __future__ import annotations

import csv
import difflib
import functools
import html
import io
import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Optional

import numpy as np

from . import _native
from ._catalogue import row
from ._errors import OilwedgeError
from ._film import Film, Floats, frozen
from ._optional import needed
from ._picture import Page, Picture, Reported
from ._scene import Scene
from ._types import FilmParts, StrPath

if TYPE_CHECKING:
    import pandas


@dataclass(frozen=True)
class Quantity:
    """A number with its error bar. The documentation of a quantity, ``quantity.__doc__``, is its definition."""

    name: str
    """Its name, as ``load`` or ``feed_flow.hole``."""
    value: float
    """The value, in ``unit``."""
    error: Optional[float]
    """Half the width of its error bar, in ``unit``; ``None`` where there is none: it was not asked for, or the mesh
    does not resolve it."""
    unit: str
    """Its unit: SI, but degrees and degrees Celsius."""
    symbol: str
    """Its symbol, as ``W``."""
    error_parts: Optional[Mapping[str, float]] = field(default=None, repr=False)
    """What the error bar is made of."""

    def __post_init__(self) -> None:
        object.__setattr__(self, "__doc__", self.definition)

    @property
    def description(self) -> str:
        """What it is, in a few words."""
        return row(self.name).description

    @property
    def definition(self) -> str:
        """Its definition with its formula."""
        return row(self.name).definition

    def to(self, unit: str) -> Quantity:
        """The quantity in another unit: ``load.to("kN")``."""
        if unit == self.unit:
            return self
        own = row(self.name).unit
        if self.unit != own:
            raise ValueError(f"{self.name} is in {self.unit} already; convert the one in {own}")
        convert = functools.partial(_native.converted, self.name, unit)
        value, error = convert(self.value, self.error)
        parts = self.error_parts
        if parts is not None:
            parts = {name: convert(0.0, part)[1] or 0.0 for name, part in parts.items()}
        return Quantity(self.name, value, error, unit, self.symbol, parts)

    def __float__(self) -> float:
        return self.value

    def __str__(self) -> str:
        return _native.shown(self.value, self.error, self.unit)

    def __format__(self, form: str) -> str:
        return format(self.value, form) if form else str(self)


class Result(Reported, Mapping[str, Quantity]):
    """What a run found: quantities by name, and the film.

    ``print(result)`` prints the table of the program, ``result.show()`` shows the report, ``result["load"]`` is a
    quantity, and so is ``result["h_min"]`` by its symbol.
    """

    scene: Scene
    """The scene that was solved."""

    def __init__(self, scene: Scene, numbers: _native.Numbers, film: Optional[FilmParts], orbit: Optional[bytes]) -> None:
        self.scene = scene
        self._numbers = numbers
        self._parts = film
        self._orbit = orbit

    @functools.cached_property
    def _values(self) -> dict[str, Any]:
        values: dict[str, Any] = json.loads(self._numbers.json)
        return values

    @functools.cached_property
    def _quantities(self) -> dict[str, Quantity]:
        found = self._values["quantities"].items()
        return {
            name: Quantity(name, it["value"], it["error"], it["unit"], it["symbol"], it["error_parts"]) for name, it in found
        }

    def __getitem__(self, name: str) -> Quantity:
        found = self._quantities.get(name) or self._by_symbol.get(name)
        if found is None:
            raise KeyError(f'this result has no quantity "{name}"; {self._hint(name)}')
        return found

    @functools.cached_property
    def _by_symbol(self) -> dict[str, Quantity]:
        """The first quantity of each symbol: over a cycle that of the cycle."""
        return {quantity.symbol: quantity for quantity in reversed(self._quantities.values())}

    def _hint(self, name: str) -> str:
        """What may be meant by a name that is none of a quantity."""
        names = [own for own in self._quantities if name and name in own]
        near = names or difflib.get_close_matches(name, [*self._quantities, *self._by_symbol])
        hints = [f"did you mean {', '.join(near)}?"] if near else []
        if self._parts is not None and name in self.film:
            hints.append(f'the field of the film is result.film["{name}"]')
        return "; ".join(hints) or f"it has {', '.join(self._quantities)}"

    def __iter__(self) -> Iterator[str]:
        return iter(self._quantities)

    def __len__(self) -> int:
        return len(self._quantities)

    @functools.cached_property
    def film(self) -> Film:
        """The film: where its triangles are, and the fields on them. Where there is no film, ``OilwedgeError`` says
        why."""
        if self._parts is None:
            raise OilwedgeError(f"there is no film: {self.reason}")
        return Film(self._numbers.json, self._parts)

    @functools.cached_property
    def orbit(self) -> Optional[Mapping[str, Floats]]:
        """The path of the journal over the last cycle, a column for each number as in ``orbit.csv``; ``None`` where no
        orbit was followed."""
        if self._orbit is None:
            return None
        rows = list(csv.reader(io.StringIO(self._orbit.decode())))
        columns = zip(*rows[1:])
        return {
            heading: np.array([float(text) if text else np.nan for text in column]) for heading, column in zip(rows[0], columns)
        }

    @property
    def title(self) -> str:
        """Title of the scene."""
        return str(self._values["title"])

    @property
    def status(self) -> str:
        """``converged``, ``no_solution`` or ``not_converged``."""
        return str(self._values["status"])

    @property
    def reason(self) -> Optional[str]:
        """Why there is no solution, or why it was not reached."""
        reason: Optional[str] = self._values["reason"]
        return reason

    @property
    def warnings(self) -> tuple[str, ...]:
        """Assumptions that the film does not meet, and other doubts about the result, in sentences."""
        return tuple(self._values["warnings"])

    @property
    def balances(self) -> Mapping[str, float]:
        """What must vanish, and what was left of it [1]."""
        return dict(self._values["balances"])

    @property
    def counts(self) -> Mapping[str, int]:
        """How often expensive operations were done."""
        return dict(self._values["counts"])

    @property
    def timing(self) -> Mapping[str, float]:
        """Wall time of each part [s]."""
        return dict(self._values["timing_s"])

    def sensitivity(self, name: str) -> pandas.DataFrame:
        """How a quantity changes with each number of the scene, a row for each key: the derivative ``value`` in its
        ``unit``, the exponent ``log``, whether it ``is_by_films``, which is less exact, and whether it ``has_kink``.
        Solve with ``sensitivity=True``, or give keys tolerances."""
        own = self[name].name
        found = self._values["quantities"][own].get("sensitivity", {})
        if not found:
            raise OilwedgeError(f"{own} has no sensitivities; solve with sensitivity=True, or give keys tolerances")
        rows = [{"is_by_films": False, "has_kink": False, **it} for it in found.values()]
        frames = needed("pandas", "result.sensitivity()")
        columns = ["value", "unit", "log", "is_by_films", "has_kink"]
        frame: pandas.DataFrame = frames.DataFrame(rows, index=frames.Index(list(found), name="key"), columns=columns)
        return frame

    @property
    def spread(self) -> pandas.DataFrame:
        """What the tolerances of the scene leave open, a row for each quantity: half widths ``worst_case`` and ``rss``
        in its ``unit``, ``nonlinearity`` where its corners were solved, and the share of each key in the square of
        ``rss``."""
        found = {name: it["spread"] for name, it in self._values["quantities"].items() if "spread" in it}
        if not found:
            raise OilwedgeError("no quantity has a spread: no key of the scene has a tolerance")
        rows = [
            {
                "value": self[name].value,
                "unit": self[name].unit,
                **{part: it.get(part) for part in ("worst_case", "rss", "nonlinearity")},
                **it["shares"],
            }
            for name, it in found.items()
        ]
        frames = needed("pandas", "result.spread")
        frame: pandas.DataFrame = frames.DataFrame(rows, index=frames.Index(list(found), name="quantity"))
        return frame

    def to_dict(self) -> dict[str, Any]:
        """Everything that the run found, as in ``result.json``."""
        values: dict[str, Any] = json.loads(self._numbers.json)
        return values

    def to_json(self) -> str:
        """The text of ``result.json``."""
        return self._numbers.json

    def table(self) -> str:
        """The table of the program with all quantities, as ``oilwedge solve --all`` prints it."""
        return self._numbers.whole()

    def plot(self, what: str = "pressure", path: Optional[StrPath] = None, *, width: float = 170.0) -> Picture:
        """A picture: a field of the film, ``mesh``, ``section``, ``profiles``, ``heat`` or
        ``tolerances``; ``width`` is in mm. Written
        to ``path``, if one is given."""
        film, text = self.film._parts, self._numbers.json
        picture = Picture(what, lambda form: _native.figure(text, film, what, width, form))
        if path is not None:
            picture.save(path)
        return picture

    def _page(self) -> Page:
        return Page(_native.page(self._numbers.json, self._parts, self._orbit, self.scene.path))

    def __repr__(self) -> str:
        return self._numbers.headlines()

    def _repr_html_(self) -> str:
        status = self.status.replace("_", " ") + (f": {self.reason}" if self.reason else "")
        rows = "".join(
            f"<tr><td>{html.escape(name)}</td><td>{html.escape(quantity.symbol)}</td><td>{html.escape(str(quantity))}</td></tr>"
            for name, quantity in self.items()
        )
        warnings = "".join(f"<li>{html.escape(warning)}</li>" for warning in self.warnings)
        return f"<p><b>{html.escape(self.title)}</b>: {html.escape(status)}</p><table>{rows}</table><ul>{warnings}</ul>"

    def __reduce__(self) -> tuple[Any, ...]:
        return _again, (self.scene, self._numbers, self._parts, self._orbit)


def _again(scene: Scene, numbers: _native.Numbers, film: Optional[FilmParts], orbit: Optional[bytes]) -> Result:
    """A result that was in another process."""
    return Result(scene, numbers, frozen(film) if film is not None else None, orbit)
