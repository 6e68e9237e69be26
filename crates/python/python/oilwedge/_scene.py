"""Scenes: descriptions of one bearing each."""

from __future__ import annotations

import html
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Union

from . import _native
from ._types import StrPath


class Scene:
    """One bearing as its scene describes it. It was read and checked, and never changes.

    ``Scene.read("bearing.toml")`` reads a file, ``Scene.new("engine-main")`` begins with one of the program's own
    scenes, and ``Scene({"bearing": {"diameter": "75 mm", ...}, ...})`` is made of a mapping with the keys of a scene.
    ``scene | {"journal.speed": "3000 rpm"}`` is the scene with other values of keys, named as on the axes of a sweep.

    A mesh file is named relative to the folder of the scene: ``folder`` for one that is made of a mapping, the current
    folder where none is given.

    Raises ``SceneError`` with everything that is wrong.
    """

    __slots__ = ("_scene",)
    _scene: _native.Scene

    def __init__(self, description: Mapping[str, Any], *, folder: StrPath = ".") -> None:
        self._scene = _native.Scene.of_mapping(description, Path(folder) / "<scene>")

    @classmethod
    def _of(cls, native: _native.Scene) -> Scene:
        scene = cls.__new__(cls)
        scene._scene = native
        return scene

    @classmethod
    def read(cls, path: StrPath) -> Scene:
        """Reads a scene in TOML."""
        return cls._of(_native.Scene.read(Path(path)))

    @classmethod
    def parse(cls, text: str, *, folder: StrPath = ".") -> Scene:
        """Reads the TOML ``text``."""
        return cls._of(_native.Scene.parse(text, Path(folder) / "<scene>"))

    @classmethod
    def new(cls, kind: str = "plain") -> Scene:
        """A scene to begin with: ``plain``, ``hole``, ``groove``, ``engine-main``, ``heat`` or ``pad``."""
        text = _native.kind(kind)
        if text is None:
            raise ValueError(f'there is no kind "{kind}" of scenes; there are {", ".join(_native.kinds())}')
        return cls.parse(text)

    @property
    def title(self) -> str:
        """Title of the study."""
        return self._scene.title

    @property
    def text(self) -> str:
        """The scene in TOML."""
        return self._scene.text

    @property
    def path(self) -> Path:
        """Where the scene stands; a mesh file counts from the folder of it."""
        return self._scene.path

    @property
    def sha256(self) -> str:
        """SHA-256 of the text, as in ``result.json``."""
        return self._scene.sha256

    def __or__(self, changes: Mapping[str, Any]) -> Scene:
        """The scene with other values of keys, named as on the axes of a sweep: ``{"journal.speed": "3000 rpm",
        "force": "5 kN"}``."""
        if not isinstance(changes, Mapping):
            return NotImplemented
        return self._of(self._scene.changed(changes)) if changes else self

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Scene):
            return NotImplemented
        return (self.text, self.path) == (other.text, other.path)

    def __hash__(self) -> int:
        return hash((self.text, self.path))

    def __repr__(self) -> str:
        return f"<Scene {self.title!r} of {str(self.path)!r}>"

    def _repr_html_(self) -> str:
        return f"<p><b>{html.escape(self.title)}</b></p><pre>{html.escape(self.text)}</pre>"

    def __str__(self) -> str:
        return self.text

    def __reduce__(self) -> tuple[Any, ...]:
        return _again, (self.text, str(self.path))


def _again(text: str, path: str) -> Scene:
    """A scene that was in another process."""
    return Scene._of(_native.Scene.parse(text, Path(path)))


AnyScene = Union[Scene, Mapping[str, Any], str, "os.PathLike[str]"]
"""A scene, the mapping that it is made of, or the path of its file."""


def scene_of(scene: AnyScene) -> Scene:
    """The scene that is meant."""
    if isinstance(scene, Scene):
        return scene
    if isinstance(scene, Mapping):
        return Scene(scene)
    return Scene.read(scene)
