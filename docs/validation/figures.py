"""Draws the figures of docs/validation.md from the results files of its studies.

usage: python3 docs/validation/figures.py FOLDER_OF_RESULTS FOLDER_OF_FIGURES
needs python3-h5py and python3-pandas; `rsvg-convert -o A.png A.svg` makes a PNG.
"""

import math
import sys

from results import clopper_pearson, fragilities, runs_of

COLORS = ["#1f77b4", "#d62728", "#2ca02c", "#9467bd", "#ff7f0e", "#555555"]


class Figure:
    """Panels side by side; axes are linear or logarithmic."""

    def __init__(self, panels, width=430, height=360):
        self.body, self.panels, self.width, self.height = [], panels, width, height

    def text(self, x, y, text, size=12, anchor="middle", color="#222", turn=False):
        turned = f' transform="rotate(-90 {x:.1f} {y:.1f})"' if turn else ""
        self.body.append(f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" text-anchor="{anchor}" '
                         f'fill="{color}" font-family="sans-serif"{turned}>{text}</text>')

    def line(self, points, color, width=1.6, dash=""):
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        self.body.append(f'<polyline points="{path}" fill="none" stroke="{color}" stroke-width="{width}" '
                         f'stroke-dasharray="{dash}"/>')

    def dot(self, x, y, color, radius=3.5, hollow=False):
        self.body.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius}" stroke="{color}" '
                         f'fill="{"white" if hollow else color}"/>')

    def axes(self, panel, title, x, y):
        """x, y: (label, low, high, ticks, logarithmic). Returns the map from values to the page."""
        left, top = panel * self.width + 62, 34
        right, bottom = (panel + 1) * self.width - 12, self.height - 48

        def along(axis, value, start, end):
            _, low, high, _, logarithmic = axis
            scale = math.log if logarithmic else float
            return start + (end - start) * (scale(value) - scale(low)) / (scale(high) - scale(low))

        def place(px, py):
            return along(x, px, left, right), along(y, py, bottom, top)

        self.line([(left, top), (left, bottom), (right, bottom), (right, top), (left, top)], "#999", 1)
        for tick in x[3]:
            at = along(x, tick, left, right)
            self.line([(at, top), (at, bottom)], "#eee", 1)
            self.text(at, bottom + 16, f"{tick:g}")
        for tick in y[3]:
            at = along(y, tick, bottom, top)
            self.line([(left, at), (right, at)], "#eee", 1)
            self.text(left - 6, at + 4, f"{tick:g}", anchor="end")
        self.text((left + right) / 2, 20, title, 13)
        self.text((left + right) / 2, self.height - 12, x[0])
        self.text(left - 44, (top + bottom) / 2, y[0], turn=True)
        return place

    def legend(self, x, y, entries):
        for i, (label, color) in enumerate(entries):
            self.dot(x, y + 17 * i - 4, color)
            self.text(x + 10, y + 17 * i, label, anchor="start")

    def save(self, path):
        width = self.panels * self.width
        with open(path, "w") as file:
            file.write(f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{self.height}">'
                       f'<rect width="{width}" height="{self.height}" fill="white"/>')
            file.write("\n".join(self.body) + "</svg>\n")


def b_over_h(results, figures):
    table = runs_of(f"{results}/validation_b_over_h.h5")
    figure = Figure(2)
    for panel, floor in enumerate(table["level floor"].unique()):
        place = figure.axes(panel, f"floor motion: {floor}, peak velocity 0.8 m/s",
                            ("half width over height b / h", 0.05, 0.65, [0.1, 0.2, 0.3, 0.4, 0.5, 0.6], False),
                            ("share that overturned, 95 %", -0.03, 1.03, [0, 0.2, 0.4, 0.6, 0.8, 1], False))
        for x, name in ((0.4, "0.4, b half"), (0.2, "0.4, b whole")):
            figure.line([place(x, -0.03), place(x, 1.03)], "#888", 1, "4 3")
            figure.text(place(x, 0.5)[0] - 4, place(x, 0.56)[1], name, 11, turn=True, color="#666")
        for color, (locks, shift) in zip(COLORS, (("none", -0.006), ("half", 0), ("all", 0.006))):
            points = []
            chosen = table[(table["level floor"] == floor) & (table["level locks"] == locks)]
            for ratio, group in chosen.groupby("level b over h"):
                x, k, n = float(ratio) + shift, int(group.overturned.sum()), len(group)
                low, high = clopper_pearson(k, n)
                figure.line([place(x, low), place(x, high)], color, 1)
                figure.dot(*place(x, k / n), color)
                points.append(place(x, k / n))
            figure.line(points, color)
        if panel == 1:
            figure.legend(place(0.45, 0.9)[0], place(0.45, 0.9)[1],
                          [("no caster locked", COLORS[0]), ("half locked", COLORS[1]), ("all locked", COLORS[2])])
    figure.save(f"{figures}/validation_b_over_h.svg")


def half_locked(results, figures):
    table = runs_of(f"{results}/validation_half_locked.h5")
    figure = Figure(2)
    for panel, period in enumerate((2, 5)):
        highest = {2: 8, 5: 45}[period]
        place = figure.axes(panel, f"floor to and fro with a period of {period} s",
                            ("cycles at full amplitude", 0, 21, [0, 5, 10, 15, 20], False),
                            ("drift towards the free casters [m]", -highest / 10, highest,
                             [0, 2, 4, 6, 8] if period == 2 else [0, 10, 20, 30, 40], False))
        for color, level in zip(COLORS, (0.1, 0.2, 0.25, 0.3)):
            for locks, hollow in (("front", False), ("none", True)):
                chosen = table[(table["level locks"] == locks) & (abs(table.intensity / 9.80665 - level) < 1e-6)]
                points = []
                for cycles in (5, 10, 20):
                    row = chosen[chosen["level shaking"] == f"{period} s, {cycles} cycles"].iloc[0]
                    points.append(place(cycles, -row.residual_displacement_x))
                    figure.dot(*points[-1], color, hollow=hollow)
                figure.line(points, color, 1.6 if locks == "front" else 0.8, "" if locks == "front" else "3 3")
        if panel == 0:
            figure.legend(*place(1.5, highest * 0.93), [(f"{level:g} g", color) for color, level in
                                                       zip(COLORS, (0.1, 0.2, 0.25, 0.3))])
            figure.text(*place(7.5, highest * 0.93), "filled: front locked; hollow: free", 11, anchor="start")
    figure.save(f"{figures}/validation_half_locked.svg")


def long_period(results, figures):
    table = runs_of(f"{results}/validation_long_period.h5")
    figure = Figure(3, width=330)
    for panel, item in enumerate(("bed", "dialysis", "ultrasound")):
        place = figure.axes(panel, item, ("brakes, and period of the floor [s]", 0, 9, [], False),
                            ("largest displacement [m]", 0.001, 40, [0.001, 0.01, 0.1, 1, 3, 10], True))
        figure.line([place(0, 3), place(9, 3)], "#888", 1, "4 3")
        for i, brakes in enumerate(("off", "half", "on")):
            for j, period in enumerate(("2 s", "3 s", "4 s")):
                rows = table[(table["level item"] == item) & (table["level brakes"] == brakes)
                             & (table["level period"] == period)]
                x = 3 * i + 0.6 + 0.9 * j
                for _, row in rows.iterrows():
                    figure.dot(*place(x, row.peak_displacement), COLORS[i], 3, hollow=bool(row.overturned))
                figure.text(place(x, 1)[0], figure.height - 34, period[0], 11)
            figure.text(place(3 * i + 1.5, 1)[0], place(1, 28)[1], brakes, 12, color=COLORS[i])
    figure.save(f"{figures}/validation_long_period.svg")


def ultrasound(results, figures):
    table = runs_of(f"{results}/validation_ultrasound.h5")
    figure = Figure(3, width=330)
    keys = ["level building", "level floor", "record", "angle", "intensity"]
    for panel, building in enumerate(("fixed", "lead rubber", "friction pendulum")):
        place = figure.axes(panel, building, ("free: largest displacement [m]", 0.005, 5, [0.01, 0.1, 1], True),
                            ("locked [m]", 0.0001, 5, [0.001, 0.01, 0.1, 1], True))
        figure.line([place(0.005, 0.005), place(5, 5)], "#888", 1, "4 3")
        free = table[table["level locks"] == "free"].set_index(keys).peak_displacement
        for color, locks in zip(COLORS, ("casters", "wheel brakes", "all wheels")):
            rows = table[(table["level locks"] == locks) & (table["level building"] == building)]
            for _, row in rows.iterrows():
                figure.dot(*place(free[tuple(row[keys])], max(row.peak_displacement, 1e-4)), color, 2.2,
                           hollow=bool(row.overturned))
        if panel == 0:
            figure.legend(*place(0.007, 3), list(zip(("casters locked", "wheels braked, forks free", "all locked"),
                                                     COLORS)))
    figure.save(f"{figures}/validation_ultrasound.svg")


P58 = {  # FEMA P-58: depth and height [in], median [m/s]
    "bookcase, 2 shelves": (12.625, 29, 0.724), "bookcase, 3 shelves": (12.625, 41, 0.493),
    "bookcase, 4 shelves": (12.625, 56, 0.361), "bookcase, 5 shelves": (12.625, 71, 0.290),
    "bookcase, 6 shelves": (12.625, 81.25, 0.251), "vertical file, 2 drawers": (15, 24, 1.229),
    "vertical file, 4 drawers": (15, 52, 0.498), "lateral file, 18.6 x 52.5 in": (18.6, 52.5, 0.688),
    "lateral file, 18.6 x 67.75 in": (18.6, 67.75, 0.526)}


def p58(results, figures):
    curves = fragilities(f"{results}/validation_p58.h5", "overturned")
    figure = Figure(2)
    for panel, floor in enumerate(("ground", "building of 1 s")):
        place = figure.axes(panel, f"floor motion: {floor}",
                            ("depth over height", 0.13, 0.75, [0.15, 0.2, 0.3, 0.4, 0.6], True),
                            ("median peak floor velocity [m/s]", 0.2, 4, [0.25, 0.5, 1, 2], True))
        for color, friction, shift in ((COLORS[0], "does not slide", 0.99), (COLORS[1], "0.2 to 0.6", 1.01)):
            for name, (depth, height, _) in P58.items():
                curve = curves[f"{floor}, {friction}, {name}"]
                x = depth / height * shift
                if curve["status"] != "fitted":
                    continue
                low, high = (min(max(math.inf if v is None else v, 0.2), 4) for v in curve["theta_interval"])
                figure.line([place(x, low), place(x, high)], color, 1)
                theta = curve["curve"]["theta"]
                if theta < 4:
                    figure.dot(*place(x, theta), color)
        for depth, height, median in P58.values():
            figure.dot(*place(depth / height, median), "#222", 4, hollow=True)
        if panel == 0:
            figure.legend(*place(0.14, 3.4), [("computed, does not slide", COLORS[0]),
                                              ("computed, friction 0.2 to 0.6", COLORS[1]), ("FEMA P-58 (hollow)", "#222")])
    figure.save(f"{figures}/validation_p58.svg")


if __name__ == "__main__":
    wanted = sys.argv[3:] or ["b_over_h", "half_locked", "long_period", "ultrasound", "p58"]
    for name in wanted:
        globals()[name](sys.argv[1], sys.argv[2])
