"""Compares the ghosts of a page of gurney play with the results files of their runs.
usage: read_ghosts.py DOCUMENT.html PAGE.html RUN.h5..."""
import html
import json
import math
import re
import sys

import h5py
import numpy

document, page = (open(path, encoding="utf-8").read() for path in sys.argv[1:3])
found = json.loads(html.unescape(re.search(r'<output id="found">(.*?)</output>', document, re.S).group(1)))
data = json.loads(re.search(r'id="data">(.*?)</script>', page, re.S).group(1))
ghosts = data["ghosts"]
runs, counted = found[:-1], found[-1]
assert len(runs) == len(sys.argv) - 3, len(runs)

falls = []
for index, (run, path) in enumerate(zip(runs, sys.argv[3:])):
    file = h5py.File(path)
    histories = file["histories"]
    time = histories["time"][:]
    if index > 0:
        assert run["name"] == "run " + re.search(r"\d+", path).group(), run["name"]
        assert run["samples"] == len(time[:: ghosts["stride"]]) + ((len(time) - 1) % ghosts["stride"] != 0)
    # The page states how far ghosts are off; of the run itself 16 bits of a range below 10 m. Times have
    # single precision: 1e-6 s at speeds below 10 m/s and 10 rad/s.
    position_error = (ghosts["position_error"] if index else math.sqrt(3) * 10 / 65535 / 2) + 1e-5
    angle_error = (ghosts["angle_error"] if index else 2 * math.sqrt(4) * 2 / 65535 / 2) + 1e-5
    for at, poses in zip(run["time"][::7], run["poses"]):
        sample = int(numpy.argmin(abs(time - at)))
        for item, pose in enumerate(poses):
            place = histories["displacement"][sample, item] + histories["start"][item]
            off = numpy.linalg.norm(place - numpy.array(pose["p"]))
            assert off <= position_error, (path, at, item, off)
            same = abs(float(numpy.dot(histories["orientation"][sample, item], pose["q"])))
            turned = 2 * math.acos(min(1, same))
            # The arc cosine near 1 loses half of the digits: sqrt(2 x 1e-16) = 1.5e-8.
            assert turned <= angle_error + 1e-7, (path, at, item, turned)
    fallen = [t for t in file["items/time_of_overturning"][:] if t >= 0]
    falls.append(min(fallen) if fallen else math.inf)

assert any(math.isfinite(t) for t in falls), "nothing overturns in this test"
for at, text in zip([0, 1.5, 2.5, max(run["time"][-1] for run in runs)], counted):
    now, end = sum(t <= at for t in falls), sum(map(math.isfinite, falls))
    assert text == f"Overturned: {now} of {len(falls)} runs by now, {end} in the end", text
