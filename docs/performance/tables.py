"""Writes the tables of docs/performance.md from the files of `./dev bench --peers` beside this one.

usage: python3 docs/performance/tables.py [--check]
A table follows the line <!-- tables.py NAME --> of the page; its rows are replaced, its head stays.
--check writes nothing and ends with 1 where the page has other rows.
"""

import csv
import pathlib
import re
import sys

FOLDER = pathlib.Path(__file__).parent
PAGE = FOLDER.parent / "performance.md"
JOBS = ("free trolley", "half-locked cart", "trolley between walls")
PEAKS = ("error_displacement", "error_tilt", "error_acceleration")
CRITERIA = {
    "peak displacement within 1 % of the engine's own finest": (0.01, lambda row: float(row["error_displacement"])),
    "all three peaks within 5 % of the engine's own finest": (0.05, lambda row: max(float(row[key]) for key in PEAKS)),
    "peak displacement within 5 % of the common truth": (0.05, lambda row: float(row["from_common_truth"])),
}


def rows_of(name):
    with (FOLDER / name).open(newline="") as file:
        return list(csv.DictReader(file))


def cpu(row):
    return float(row["cpu_s_per_simulated_s"])


def step(row):
    return row["tolerance"] if row["tolerance"] else f"{row['time_step_ms']} ms"


def cheapest(rows, bound, error):
    """Of each job and set-up the point within the bound that takes the least CPU time."""
    found = {}
    for row in rows:
        key = row["job"], row["engine"], row["setup"]
        if error(row) <= bound and (key not in found or cpu(row) < cpu(found[key])):
            found[key] = row
    return found


def cell(row, ours):
    if row is None:
        return "-"
    ratio = f"{cpu(row) / ours:.1f} " if ours else ""
    return f"{ratio}({step(row)}, {1 / cpu(row):.0f} x)"


def ratios():
    rows = rows_of("peers.csv")
    setups = list(dict.fromkeys((row["engine"], row["setup"]) for row in rows))
    for name, (bound, error) in CRITERIA.items():
        yield [f"**{name}**", "", "", "", ""]
        found = cheapest(rows, bound, error)
        ours = {job: min((cpu(row) for (of, engine, _), row in found.items() if of == job and engine == "Gurney"),
                         default=None) for job in JOBS}
        for setup in setups:
            points = [found.get((job, *setup)) for job in JOBS]
            if any(points):
                yield [*setup, *(cell(point, ours[job]) for job, point in zip(JOBS, points))]


def rocking():
    for row in rows_of("peers_rocking.csv"):
        if row["time_step_ms"] == "1":
            continue
        finest = row["time_step_ms"] == "0.5"
        until_gurney = float(row["own_finest_agrees_with_gurney_until_s"])
        is_reference = row["engine"] == "Gurney" and row["setup"].startswith("rigid")
        yield [row["engine"], row["setup"], f"tolerance {row['tolerance']}" if row["tolerance"] else step(row),
               f"{1 / cpu(row):.0f}", row["overturned"], f"{float(row['median_peak_displacement_mm']):.0f}",
               f"{float(row['median_peak_tilt_deg']):.1f}",
               "" if finest else f"{float(row['agrees_with_own_finest_until_s']):.1f}",
               "" if is_reference else f"{until_gurney:.1f}"]


def with_table(page, name, rows):
    text = "".join("| " + " | ".join(row) + " |\n" for row in rows)
    pattern = rf"(<!-- tables.py {name} -->\n\n\|[^\n]*\n\|[-| ]*\n)(?:\|[^\n]*\n)*"
    page, count = re.subn(pattern, lambda match: match[1] + text, page)
    if count != 1:
        sys.exit(f"{PAGE}: has no table after <!-- tables.py {name} -->")
    return page


def main(arguments):
    if arguments not in ([], ["--check"]):
        sys.exit(__doc__)
    before = PAGE.read_text()
    after = with_table(with_table(before, "ratios", ratios()), "rocking", rocking())
    if arguments and after != before:
        sys.exit(f"{PAGE}: its tables are not those of {FOLDER}: run docs/performance/tables.py")
    if not arguments:
        PAGE.write_text(after)


if __name__ == "__main__":
    main(sys.argv[1:])
