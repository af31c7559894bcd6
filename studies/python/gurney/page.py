"""Pages of the program inside a notebook."""

from __future__ import annotations

import html
import os
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Page:
    """An HTML page, which a notebook shows in a frame of ``height`` pixels."""

    html: str = field(repr=False)
    height: int = 600

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the page, if it does not exist."""
        with open(path, "x", encoding="utf-8") as file:
            file.write(self.html)

    def _repr_html_(self) -> str:
        return (f'<iframe srcdoc="{html.escape(self.html)}" width="100%" height="{self.height}" '
                f'style="border:0"></iframe>')
