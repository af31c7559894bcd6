"""Compares what a page of gurney play shows with the results file it was made of.
usage: read_playback.py FILE.h5 DOCUMENT.html TIME"""
import html.parser
import math
import sys

import h5py
import numpy


class Document(html.parser.HTMLParser):
    def __init__(self):
        super().__init__()
        self.title, self.rows, self.events, self.wild = "", {}, [], []
        self.inside, self.value = None, None

    def handle_starttag(self, tag, attributes):
        a = dict(attributes)
        if tag in ("b", "i", "img"):
            self.wild.append(tag)
        if tag == "h1":
            self.inside = "title"
        if tag == "tr" and "data-item" in a:
            self.row = self.rows.setdefault(a["data-item"], {})
        if tag == "td":
            self.inside, self.value = "value", a["data-value"]
        if tag == "button" and "data-kind" in a:
            self.events.append((a["data-kind"], float(a["data-time"])))

    def handle_endtag(self, tag):
        self.inside = None

    def handle_data(self, data):
        if self.inside == "title":
            self.title += data
        if self.inside == "value":
            self.row[self.value] = float(data)


def near(what, shown, expected):
    # A page shows tenths of a millimetre or a degree; channels are finer than 0.01 of them.
    assert abs(shown - expected) <= 0.05 + 0.01, f"{what}: the page shows {shown}, the file holds {expected}"


file = h5py.File(sys.argv[1])
page = Document()
page.feed(open(sys.argv[2], encoding="utf-8").read())
histories = file["histories"]
time = histories["time"][:]
at = min(int(numpy.searchsorted(time, float(sys.argv[3]) - 1e-9)), len(time) - 1)

assert page.title == file.attrs["title"], page.title
assert not page.wild, page.wild
names = [name.decode() for name in histories["item"][:]]
assert list(page.rows) == names, page.rows
for i, name in enumerate(names):
    x, y, _ = histories["displacement"][at, i]
    near(name + " x", page.rows[name]["x"], 1000 * x)
    near(name + " y", page.rows[name]["y"], 1000 * y)
    tilt = math.degrees(histories["tilt"][at, i])
    near(name + " tilt", page.rows[name]["tilt"], tilt)
    if tilt < 45:  # of an item that lies, yaw is no angle about the vertical
        turn = math.degrees(histories["yaw"][at, i]) - page.rows[name]["yaw"]
        near(name + " yaw", (turn + 180) % 360 - 180, 0)


def of(kind):
    return sorted(t for k, t in page.events if k == kind)


def told(values):
    return sorted(float(v) for v in values[:] if v >= 0)


assert of("impact") == told(file["events/time"]), of("impact")
assert of("overturned") == told(file["items/time_of_overturning"]), of("overturned")
assert of("taut") == told(file["tethers/time_taut"]), of("taut")
assert of("unplugged") == told(file["tethers/time_broken"]), of("unplugged")
lifted = histories["mode"][:] == 4
assert bool(of("lift-off")) == bool(lifted.any())
for t in of("lift-off"):
    i = int(numpy.argmin(abs(time - t)))
    assert lifted[i].any(), t
