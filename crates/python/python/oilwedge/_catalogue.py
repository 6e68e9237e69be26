"""The catalogue of quantities: what each is."""

from __future__ import annotations

import json
from typing import NamedTuple

from . import _native

_REGION = "GROUP"


class Row(NamedTuple):
    """A row of the catalogue."""

    name: str
    symbol: str
    unit: str
    description: str
    definition: str


_rows: dict[str, Row] = {}
"""The catalogue, once it was asked for."""


def quantities() -> dict[str, Row]:
    """All quantities by name; families by region, as ``feed_flow.``, by the part of their names before the region."""
    if not _rows:
        for entry in json.loads(_native.catalogue()):
            if entry["kind"] == "quantity":
                name = entry["name"].removesuffix(_REGION)
                columns = entry["columns"]
                unit, symbol = columns.get("unit", ""), columns.get("symbol", "")
                _rows[name] = Row(name, symbol, unit, entry["what"], columns.get("definition", ""))
    return _rows


def row(name: str) -> Row:
    """The row that a quantity of this name, or with this symbol, belongs to.

    Raises ``KeyError`` where there is none."""
    rows = quantities()
    found = rows.get(name)
    if found is None:
        found = next((row for family, row in rows.items() if family.endswith(".") and name.startswith(family)), None)
    if found is None:
        found = next((row for row in rows.values() if row.symbol == name), None)
    if found is None:
        raise KeyError(f'there is no quantity "{name}"')
    return found


def explain(name: str) -> str:
    """What the name of a quantity, an effect, a key of a scene, a field or a warning means."""
    return _native.explain(name)
