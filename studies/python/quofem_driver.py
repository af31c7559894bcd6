#!/usr/bin/env python3
"""Runs a Gurney job for quoFEM, Dakota or any program that exchanges params.in and results.out.

usage: quofem_driver.py JOB DEMAND... [--item ITEM] [--gurney PROGRAM]

params.in: the number of variables, then one line each, name and value. A name is a key of the job
with `__` for each dot, `settings__duration_s`; an index of an array is a part of it,
`item__position_m__0`. results.out: the demands of the run in the order given, in SI units, in one
line. A run that failed writes no results.out and ends with an exit code other than 0, so that the
caller does not take it for a response.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
import tomllib


def read_params(path):
    """Names and values of params.in."""
    with open(path, encoding="utf-8") as file:
        count, *lines = file.read().splitlines()
    values = dict(line.split() for line in lines[:int(count)])
    return {name: float(value) for name, value in values.items()}


def set_key(job, name, value):
    """Sets a key of the job that it already has; a quantity keeps its other entries."""
    *path, last = name.split("__")
    table = job
    for part in path:
        table = table[int(part) if isinstance(table, list) else part]
    last = int(last) if isinstance(table, list) else last
    try:
        old = table[last]
    except (KeyError, IndexError):
        raise SystemExit(f"params.in: the job has no key {name.replace('__', '.')}")
    if isinstance(old, dict):
        table[last] = {"value": value, **{key: old[key] for key in old.keys() - {"value"}}}
    else:
        table[last] = int(value) if isinstance(old, int) and value.is_integer() else value


def main():
    usage = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    usage.add_argument("job")
    usage.add_argument("demands", nargs="+", metavar="DEMAND")
    usage.add_argument("--item", help="name of the item; may be left out if there is one")
    usage.add_argument("--gurney", default="gurney", help="the program")
    given = usage.parse_args()
    with open(given.job, "rb") as file:
        job = tomllib.load(file)
    for name, value in read_params("params.in").items():
        set_key(job, name, value)
    # Paths in a job start at its folder: the changed job stands beside it while it runs.
    folder = os.path.dirname(os.path.abspath(given.job))
    with tempfile.NamedTemporaryFile("w", suffix=".json", dir=folder, encoding="utf-8") as changed:
        json.dump(job, changed)
        changed.flush()
        done = subprocess.run([given.gurney, "run", changed.name, "-o", "gurney.h5", "--overwrite",
                               "--no-figure", "--json"], stdout=subprocess.PIPE, text=True)
    if done.returncode != 0:
        print(done.stdout, file=sys.stderr)  # errors as JSON, or the report of a failed run
        sys.exit(done.returncode)
    items = {item["name"]: item for item in json.loads(done.stdout)["items"]}
    name = given.item or (next(iter(items)) if len(items) == 1 else None)
    if name not in items:
        sys.exit(f"--item must be one of {', '.join(items)}")
    demands = items[name]["demands"]
    unknown = [each for each in given.demands if each not in demands]
    if unknown:
        sys.exit(f"no demand {', '.join(unknown)}; the run has {', '.join(demands)}")
    with open("results.out", "w", encoding="utf-8") as file:
        print(*(repr(float(demands[each])) for each in given.demands), file=file)


if __name__ == "__main__":
    main()
