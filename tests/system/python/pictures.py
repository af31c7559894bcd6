"""Every picture of the documentation stands on a page and has its commands in docs/images/draw.py; two are drawn.
Exit code 77: rsvg-convert is not installed."""

import pathlib
import shutil
import struct
import sys
import tempfile

import support

source = pathlib.Path(support.SOURCE)
images = source / "docs" / "images"
sys.path.insert(0, str(images))
import draw  # noqa: E402

files = {path.name for path in images.iterdir() if path.suffix in (".png", ".svg")}
known = set(draw.PICTURES) | set(draw.OTHERS)
assert files == known, files ^ known
pages = "".join(path.read_text() for path in [source / "README.md", *(source / "docs").rglob("*.md")])
unused = [name for name in sorted(files) if f"images/{name}" not in pages]
assert not unused, unused

if shutil.which("rsvg-convert") is None:
    support.skip("no rsvg-convert (Debian: librsvg2-bin)")
draw.use(support.GURNEY)
with tempfile.TemporaryDirectory() as folder:
    for name, width in (("equipment.png", 1250), ("scaled_suite.png", 1000)):
        draw.draw(name, pathlib.Path(folder), pathlib.Path(folder))
        head = (pathlib.Path(folder) / name).read_bytes()[:24]
        assert head[:8] == b"\x89PNG\r\n\x1a\n" and struct.unpack(">I", head[16:20])[0] == width, head
