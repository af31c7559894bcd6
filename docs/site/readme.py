"""Puts what README.md says behind its introduction on the start page, with links as they are from here."""

import pathlib
import re

README = pathlib.Path(__file__).resolve().parents[2] / "README.md"


def on_page_markdown(markdown, page, **_):
    if page.file.src_path != "index.md":
        return markdown
    text = README.read_text(encoding="utf-8")
    told = text[text.index("## Install and first run") : text.index("## Licence")]
    told = re.sub(r"\]\(docs/", "](", told)
    told = re.sub(r"\[([^]]*)\]\(index\.md\)", r"\1", told)  # this page
    return f"{markdown}\n{told}"
