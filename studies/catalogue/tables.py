"""Writes the tables of the fragility catalogue from the results of catalogue.py.

usage: tables.py GURNEY RESULTS TABLES

TABLES gets fragility.csv (every curve with its interval, or why there is none), measures.csv (which intensity
measure predicts the displacement best), best_measure.csv (curves on it where it is much better), more_states.csv
(curves of further limit states), pelicun/ and nrml/ (libraries.py).
"""

import csv
import glob
import json
import os
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

import libraries
from catalogue import BRAKES, filled

FURTHER_FLOOR = "flexible building"
MUCH_BETTER = 0.3  # the scatter about the peak floor velocity is larger by this than about the best measure
PARTS = ("displaced", "beyond", "residual", "shaken")  # of limit states that an item which falls has reached too
FURTHER_STATES = "further_states.toml.in"  # what they bound: docs/catalogue/methods.md
FURTHER = ("0.5 m from its outlet", "left 0.5 m away", "1 g at its sensitive point")
HERE = os.path.dirname(os.path.abspath(__file__))
MEASURES = {"pfv": ["--measure", "pfv"], "PGV larger": []}
COLUMNS = ["item", "floor", "place", "brakes", "limit_state", "measure", "unit", "runs", "exceed", "failed", "theta",
           "theta_low", "theta_high", "beta", "beta_low", "beta_high", "reason", "cautions"]


def output_of(gurney, *arguments):
    return subprocess.run([gurney, *arguments], check=True, capture_output=True, text=True).stdout


def setting_of(configuration):
    """Floor, place and brakes of a configuration's name, none of what it has not."""
    return (configuration.split(", ") + 2 * ["none"])[:3]


def number(value):
    return "" if value is None else f"{value:.4g}"


def bounds(interval):
    """Texts of an interval whose limits may be unbounded, or of none."""
    if interval is None:
        return "", ""
    low, high = interval
    return number(low or 0), "inf" if high is None else number(high)


def fitted(gurney, file, *options):
    return json.loads(output_of(gurney, "fragility", file, *options, "--json"))["fragilities"]


def curve_row(item, measure, each):
    """Row of a fitted curve, or of why there is none."""
    curve = each["curve"] or {}
    theta, beta = bounds(each.get("theta_interval")), bounds(each.get("beta_interval"))
    floor, place, brakes = setting_of(each["configuration"])
    return {"item": item, "floor": floor, "place": place, "brakes": brakes,
            "limit_state": each["limit_state"], "measure": measure, "unit": each["units"],
            "runs": each["runs"], "exceed": each["exceeded"], "failed": each["failed"],
            "theta": number(curve.get("theta")), "beta": number(curve.get("beta")),
            "theta_low": theta[0], "theta_high": theta[1],
            "beta_low": beta[0], "beta_high": beta[1],
            "reason": "" if curve else each["reason"], "cautions": "; ".join(each["cautions"])}


def is_part(state):
    """Is a limit state but a part of another?"""
    return state.split()[0] in PARTS


def curve_rows(gurney, item, file, measure, *options):
    for each in fitted(gurney, file, *options):
        if not is_part(each["limit_state"]):
            yield curve_row(item, measure, each)


def fragility_rows(gurney, item, file):
    for measure, options in MEASURES.items():
        yield from curve_rows(gurney, item, file, measure, *options)


def much_better(row):
    """Is the best measure of a row of measures.csv much better than the peak floor velocity?"""
    return row["pfv_scatter"] and float(row["pfv_scatter"]) > (1 + MUCH_BETTER) * float(row["best_scatter"])


def best_measure_rows(gurney, item, file, measures):
    chosen = {}
    for row in measures:
        if row["item"] == item and much_better(row):
            chosen.setdefault(row["best"], []).append(f"{row['floor']}, {row['place']}, {row['brakes']}")
    for measure, names in chosen.items():
        yield from curve_rows(gurney, item, file, measure, "--measure", measure, "--configuration", *names)


def sensitive_point(item):
    with open(os.path.join(HERE, "items.csv"), newline="") as file:
        return next(row["sensitive_point"] for row in csv.DictReader(file) if row["item"] == item)


def further_rows(gurney, item, file):
    wanted = [", ".join([FURTHER_FLOOR, place, brakes]) for place in ("open", "bay") for brakes in BRAKES]
    names = present(gurney, file, wanted)
    if not names:
        return
    with tempfile.NamedTemporaryFile("w", suffix=".toml") as states:
        states.write(filled(FURTHER_STATES, {"ITEM": item, "POINT": sensitive_point(item)}))
        states.flush()
        for row in curve_rows(gurney, item, file, "pfv", "--measure", "pfv", "--limit-states", states.name,
                              "--configuration", *names):
            if row["limit_state"] in FURTHER:
                yield row


def present(gurney, file, names):
    """Those configurations that were run."""
    done = json.loads(output_of(gurney, "show", file, "--json"))["configurations"]
    return [name for name in names if name in done]


def measure_rows(gurney, item, file):
    """The two best measures of each configuration for the displacement."""
    text = output_of(gurney, "measures", file, "--limit", "displaced 0.3 m", "--json")
    for each in json.loads(text):
        fitted = [m for m in each["measures"] if m["status"] == "fitted"]
        best = sorted(fitted, key=lambda m: -m["log_likelihood"])[:2]
        floor, place, brakes = setting_of(each["configuration"])
        row = {"item": item, "floor": floor, "place": place, "brakes": brakes}
        for rank, m in zip(("best", "second"), best):
            row |= {rank: m["name"], rank + "_scatter": number(m["efficiency"])}
        pfv = next((m for m in fitted if m["name"] == "pfv"), None)
        yield row | {"pfv_scatter": number(pfv and pfv["efficiency"])}


def write_csv(path, columns, rows):
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, columns, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def of_all(files, rows_of):
    """The rows of all items in their order, as many items at once as there are cores."""
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        return [row for rows in pool.map(lambda each: list(rows_of(*each)), files) for row in rows]


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    gurney, results, tables = sys.argv[1:]
    files = [(os.path.basename(path)[:-3], path) for path in sorted(glob.glob(os.path.join(results, "*.h5")))]
    os.makedirs(tables, exist_ok=True)
    write_csv(os.path.join(tables, "fragility.csv"), COLUMNS,
              of_all(files, lambda item, file: fragility_rows(gurney, item, file)))
    measures = of_all(files, lambda item, file: measure_rows(gurney, item, file))
    write_csv(os.path.join(tables, "measures.csv"),
              ["item", "floor", "place", "brakes", "best", "best_scatter", "second", "second_scatter", "pfv_scatter"],
              measures)
    write_csv(os.path.join(tables, "best_measure.csv"), COLUMNS,
              of_all(files, lambda item, file: best_measure_rows(gurney, item, file, measures)))
    write_csv(os.path.join(tables, "more_states.csv"), COLUMNS,
              of_all(files, lambda item, file: further_rows(gurney, item, file)))
    libraries.write(tables)


if __name__ == "__main__":
    main()
