#!/usr/bin/env python3
"""Runs a Gurney job for quoFEM, Dakota or any program that exchanges params.in and results.out.

usage: quofem_driver.py JOB DEMAND... [--item ITEM] [--folder FOLDER] [--missing VALUE]
                        [--gurney PROGRAM]

params.in: the number of variables, then one line each, name and value; a text stands in quotes. A
name is a key of the job with `__` for each dot, `settings__duration_s`; an index of an array is a
part of it, `item__position_m__0`. results.out: the demands of the run in the order given, in SI
units, in one line. `overturned` is 1 or 0. A run that failed, or has no value of a demand, writes
no results.out and ends with an exit code other than 0, so that the caller does not take it for a
response.
"""

import argparse
import json
import os
import shlex
import subprocess
import sys
import tempfile
import tomllib


def text_of(path):
    try:
        with open(path, encoding="utf-8") as file:
            return file.read()
    except (OSError, UnicodeDecodeError) as error:
        sys.exit(f"{path}: {error}")


def read_params(path):
    """Names and values of params.in; a value is a number or a text."""
    count, *lines = text_of(path).rstrip().splitlines() or [""]
    if count.strip() != str(len(lines)):
        sys.exit(f"{path}:1: {count!r}: must be the number of variables, with a line for each; there are "
                 f"{len(lines)} lines")
    values = {}
    for number, line in enumerate(lines, start=2):
        try:
            name, text = shlex.split(line)
        except ValueError:
            sys.exit(f"{path}:{number}: {line!r}: must be a name and a value")
        if name in values:
            sys.exit(f"{path}:{number}: {name} is there twice")
        try:
            values[name] = float(text)
        except ValueError:
            values[name] = text
    return values


def like(old, value):
    """The value as the key has it: TOML tells whole numbers and booleans from others."""
    if isinstance(value, str):
        return value
    if isinstance(old, bool) and value in (0, 1):
        return bool(value)
    return int(value) if isinstance(old, int) and value.is_integer() else value


def set_key(job, name, value):
    """Sets a key of the job that it already has; a quantity keeps its other entries."""
    *path, last = name.split("__")
    table = job
    try:
        for part in path:
            table = table[int(part) if isinstance(table, list) else part]
        last = int(last) if isinstance(table, list) else last
        old = table[last]
    except (KeyError, IndexError, TypeError, ValueError):
        sys.exit(f"params.in: the job has no key {name.replace('__', '.')}")
    if isinstance(old, dict):
        table[last] = {"value": value, **{key: old[key] for key in old.keys() - {"value"}}}
    else:
        table[last] = like(old, value)


def demands_of(run, item):
    """Demands of the item of a run, with `overturned`."""
    items = {each["name"]: each for each in run["items"]}
    name = item or (next(iter(items)) if len(items) == 1 else None)
    if name not in items:
        sys.exit(f"--item must be one of {', '.join(items)}")
    demands = items[name]["demands"]
    return {**demands, "overturned": int(demands["time_of_overturning"] is not None)}


def value_of(demands, name, missing):
    """A number; the stated one where the run has none."""
    if demands[name] is not None:
        return float(demands[name])
    if missing is None:
        sys.exit(f"{name}: this run has no value of it"
                 + (", the item stands; the demand 'overturned' is 0 or 1"
                    if demands["overturned"] == 0 and "overturning" in name else "")
                 + "; --missing VALUE states one")
    return missing


def run_job(job, folder, gurney):
    """The report of the changed job, which stands in `folder` while it runs."""
    try:
        with tempfile.NamedTemporaryFile("w", suffix=".json", dir=folder,
                                         encoding="utf-8") as changed:
            json.dump(job, changed)
            changed.flush()
            done = subprocess.run([gurney, "run", changed.name, "-o", "gurney.h5", "--overwrite",
                                   "--no-figure", "--json"], stdout=subprocess.PIPE, text=True)
    except OSError as error:
        sys.exit(f"{folder}, {gurney}: {error}")
    if done.returncode != 0:
        print(done.stdout, file=sys.stderr)  # errors as JSON, or the report of a failed run
        if "no such file" in done.stdout:
            print(f"relative paths of the job start at {folder}; --folder states another folder",
                  file=sys.stderr)
        sys.exit(done.returncode)
    return json.loads(done.stdout)


def main():
    usage = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    usage.add_argument("job")
    usage.add_argument("demands", nargs="+", metavar="DEMAND")
    usage.add_argument("--item", help="name of the item; may be left out if there is one")
    usage.add_argument("--folder", help="where relative paths of the job start (default: the "
                                        "folder of the job)")
    usage.add_argument("--missing", type=float, help="value of a demand that the run has not")
    usage.add_argument("--gurney", default="gurney", help="the program")
    given = usage.parse_args()
    try:
        job = tomllib.loads(text_of(given.job))
    except tomllib.TOMLDecodeError as error:
        sys.exit(f"{given.job}: {error}")
    for name, value in read_params("params.in").items():
        set_key(job, name, value)
    folder = os.path.abspath(given.folder or os.path.dirname(os.path.abspath(given.job)))
    demands = demands_of(run_job(job, folder, given.gurney), given.item)
    unknown = [each for each in given.demands if each not in demands]
    if unknown:
        sys.exit(f"no demand {', '.join(unknown)}; the run has {', '.join(demands)}")
    values = [value_of(demands, each, given.missing) for each in given.demands]
    with open("results.out", "w", encoding="utf-8") as file:
        print(*map(repr, values), file=file)


if __name__ == "__main__":
    main()
