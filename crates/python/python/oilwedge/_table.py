"""Tables of sweeps."""

from __future__ import annotations

import csv
import functools
import io
import json
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np
from numpy.typing import NDArray

from . import _native
from ._catalogue import row
from ._optional import needed
from ._picture import Page, Picture, Reported
from ._types import StrPath

if TYPE_CHECKING:
    import pandas
    import pyarrow
    import xarray

Column = Union[NDArray[np.float64], NDArray[np.int64], NDArray[np.object_]]

_TEXTS = ("status", "warnings", "verdict", "limits", "reason")
"""Columns of words."""


class Table(Reported):
    """The table of a sweep: one row a case, the last axis running fastest.

    ``table["load [N]"]`` is a column, ``table.columns`` has all headings; cases without an answer have NaN, and
    ``table["reason"]`` says why. ``print(table)`` prints the table of the program.
    """

    def __init__(self, text: bytes, json: str, table: str) -> None:
        self._csv = text
        self._json = json
        self._table = table

    @functools.cached_property
    def _columns(self) -> dict[str, Column]:
        return typed_columns(self._csv)

    @functools.cached_property
    def _values(self) -> dict[str, Any]:
        values: dict[str, Any] = json.loads(self._json)
        return values

    @staticmethod
    def _heading(axis: Mapping[str, Any]) -> str:
        return f"{axis['name']} [{axis['unit']}]" if axis["unit"] else str(axis["name"])

    @property
    def columns(self) -> tuple[str, ...]:
        """Headings of all columns."""
        return tuple(self._columns)

    @property
    def axes(self) -> Mapping[str, tuple[Any, ...]]:
        """Values of each axis, by its name and unit."""
        return {self._heading(axis): tuple(axis["values"]) for axis in self._values["axes"]}

    def __getitem__(self, heading: str) -> Column:
        try:
            return self._columns[heading]
        except KeyError:
            raise KeyError(f'there is no column "{heading}"; there are {", ".join(self.columns)}') from None

    def __len__(self) -> int:
        return len(self._columns["case"])

    def to_dict(self) -> dict[str, Any]:
        """Everything that the sweep found, as in ``sweep.json``."""
        values: dict[str, Any] = json.loads(self._json)
        return values

    def to_csv(self, path: Optional[StrPath] = None) -> str:
        """The table as in ``sweep.csv``. Written to ``path``, if one is given."""
        if path is not None:
            Path(path).write_bytes(self._csv)
        return self._csv.decode()

    def to_pandas(self) -> pandas.DataFrame:
        """The table as a frame of pandas, with its headings."""
        frames = needed("pandas", "table.to_pandas()")
        frame: pandas.DataFrame = frames.DataFrame(dict(self._columns))
        return frame

    def to_arrow(self) -> pyarrow.Table:
        """The table as one of pyarrow, with its headings."""
        arrow = needed("pyarrow", "table.to_arrow()")
        return arrow.table({heading: arrow.array(column, from_pandas=True) for heading, column in self._columns.items()})

    def to_parquet(self, path: StrPath) -> None:
        """Writes the table to a file of Parquet."""
        parquet = needed("pyarrow.parquet", "table.to_parquet()")
        parquet.write_table(self.to_arrow(), path, compression="zstd")

    def to_xarray(self) -> xarray.Dataset:
        """The table as a data set of xarray: a dimension for each axis, a variable for each quantity by its name or, in
        chosen columns, its symbol, its error bar as ``NAME_error``.

        Variables have ``units`` and ``long_name``.
        """
        sets = needed("xarray", "table.to_xarray()")
        axes = self._values["axes"]
        dimensions = [axis["name"] for axis in axes]
        shape = [len(axis["values"]) for axis in axes]
        coordinates = {axis["name"]: (axis["name"], axis["values"], {"units": axis["unit"]}) for axis in axes}
        inputs = {self._heading(axis) for axis in axes}
        variables = {}
        for heading, column in self._columns.items():
            if heading not in inputs:
                name, about = _about(heading)
                if name in variables:
                    raise ValueError(f'the table has "{name}" in two columns, and a data set one variable of that name; choose other columns')
                variables[name] = (dimensions, np.asarray(column).reshape(shape), about)
        data: xarray.Dataset = sets.Dataset(variables, coordinates, {"title": self._values["title"]})
        return data

    def plot(self, quantity: str, path: Optional[StrPath] = None, *, width: float = 170.0) -> Picture:
        """A picture of a quantity over the axes; ``width`` is in mm. Written to ``path``, if one is given."""
        text = self._json
        picture = Picture(quantity, lambda form: _native.figure(text, None, quantity, width, form))
        if path is not None:
            picture.save(path)
        return picture

    def _page(self) -> Page:
        return Page(_native.sweep_page(self._json))

    def __repr__(self) -> str:
        return self._table

    def __reduce__(self) -> tuple[Any, ...]:
        return Table, (self._csv, self._json, self._table)


def typed_columns(text: bytes) -> dict[str, Column]:
    """The columns of a table in CSV, each with the type of what is in it."""
    rows = csv.reader(io.StringIO(text.decode()))
    headings = next(rows)
    return {heading: _column(heading, texts) for heading, texts in zip(headings, zip(*rows))}


def _column(heading: str, texts: tuple[str, ...]) -> Column:
    if heading == "case":
        return np.array([int(text) for text in texts], dtype=np.int64)
    try:
        if heading not in _TEXTS:
            return np.array([float(text) if text else np.nan for text in texts])
    except ValueError:
        # An axis of words.
        pass
    return np.array(texts, dtype=object)


def _about(heading: str) -> tuple[str, dict[str, str]]:
    """Name and attributes of the variable of a column."""
    name, _, unit = heading.partition(" [")
    about = {"units": unit.removesuffix("]")} if unit else {}
    quantity = name.removesuffix(" error")
    try:
        words = row(quantity).description
    except KeyError:
        return name.replace(" ", "_"), about
    is_error = name != quantity
    about["long_name"] = f"half width of the error bar: {words}" if is_error else words
    return f"{quantity}_error" if is_error else quantity, about
