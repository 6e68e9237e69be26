"""Pictures and pages, for files and for notebooks."""

from __future__ import annotations

import html
import sys
import tempfile
import webbrowser
from pathlib import Path
from typing import Callable, Optional

from ._optional import needed
from ._types import StrPath

_FRAME = '<iframe sandbox="allow-scripts" style="width: 100%; height: {height}px; border: 0" srcdoc="{page}"></iframe>'


class Picture:
    """A picture. A notebook shows it; ``picture.save("p.svg")`` or ``"p.png"`` writes it."""

    def __init__(self, name: str, drawn: Callable[[str], bytes]) -> None:
        self.name = name
        self._drawn = drawn
        self._svg = drawn("svg")

    @property
    def svg(self) -> str:
        """The picture as SVG."""
        return self._svg.decode()

    def save(self, path: StrPath) -> None:
        """Writes the picture, as SVG or, at 300 dots per inch, as PNG: the ending of the name decides."""
        file = Path(path)
        endings = {".svg": lambda: self._svg, ".png": lambda: self._drawn("png")}
        content = endings.get(file.suffix.lower())
        if content is None:
            raise ValueError(f"{file}: a picture is SVG or PNG; give a name that ends in .svg or .png")
        file.write_bytes(content())

    def _repr_svg_(self) -> str:
        return self.svg

    def __repr__(self) -> str:
        return f"<Picture {self.name}>"


class Page:
    """A page of HTML with everything in it. A notebook shows it in a frame; ``page.show()`` opens it in the browser
    elsewhere."""

    def __init__(self, text: str) -> None:
        self.text = text

    def save(self, path: StrPath) -> None:
        """Writes the page."""
        Path(path).write_text(self.text, encoding="utf-8")

    def _repr_html_(self, height: int = 900) -> str:
        return _FRAME.format(height=height, page=html.escape(self.text))

    def show(self) -> None:
        """Shows the page: in a frame of the notebook, or in the browser."""
        if _in_notebook():
            needed("IPython.display", "page.show()").display(self)
            return
        with tempfile.NamedTemporaryFile("w", suffix=".html", encoding="utf-8", delete=False) as file:
            file.write(self.text)
        webbrowser.open(Path(file.name).as_uri())

    def __repr__(self) -> str:
        return f"<Page of {len(self.text) // 1024} kB>"


class Reported:
    """What has a report."""

    def _page(self) -> Page:
        raise NotImplementedError

    def report(self, path: Optional[StrPath] = None) -> Page:
        """The report: one page of HTML with everything, which needs no network. Written to ``path``, if one is
        given."""
        page = self._page()
        if path is not None:
            page.save(path)
        return page

    def show(self) -> None:
        """Shows the report: in a frame of the notebook, or in the browser."""
        self.report().show()


def _in_notebook() -> bool:
    """Whether a kernel of Jupyter runs this."""
    ipython = sys.modules.get("IPython")
    shell: Optional[object] = ipython.get_ipython() if ipython is not None else None
    return shell is not None and hasattr(shell, "kernel")
