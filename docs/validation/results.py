"""Reads the results files of the shipped studies; needs python3-h5py and python3-pandas."""

import json
import math
import os
import subprocess

import h5py
import pandas


def tables_of(path, more=()):
    """The tables of a results file, with decoded text; configurations give columns `level FACTOR`."""
    tables = {}
    with h5py.File(path) as file:
        for name in ("runs", "items", "configurations", "tethers", "zones", "warnings", *more):
            columns = {}
            for key, data in file[name].items():
                values = data[:]
                columns[key] = [v.decode().rstrip("\0") for v in values] if values.dtype.kind == "S" else values
            tables[name] = pandas.DataFrame(columns)
    levels = tables["configurations"].drop(columns="name").add_prefix("level ")
    tables["runs"] = tables["runs"].merge(levels, left_on="configuration", right_on="level row")
    return tables


def joined(tables, name):
    """Rows of a table, each with its run."""
    return tables[name].merge(tables["runs"], on="run")


def items_of(tables):
    table = joined(tables, "items")
    table["overturned"] = table.time_of_overturning >= 0
    return table


def runs_of(path):
    """One row for each item of each run: demands, run and levels of the factors."""
    return items_of(tables_of(path))


def gurney(*arguments):
    """What a command of the program prints with --json."""
    program = os.environ.get("GURNEY", "gurney")
    done = subprocess.run([program, *arguments, "--json"], capture_output=True, check=True)
    return json.loads(done.stdout)


def fragilities(path, limit_state):
    """Fragility of one limit state by configuration."""
    return {curve["configuration"]: curve
            for curve in gurney("fragility", path, "--limit", limit_state)["fragilities"]}


def binomial_cdf(k, n, p):
    return sum(math.comb(n, i) * p**i * (1 - p) ** (n - i) for i in range(k + 1))


def clopper_pearson(k, n, level=0.95):
    """Interval of a probability from k of n (Clopper & Pearson 1934)."""

    def root(f):
        low, high = 0.0, 1.0
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (middle, high) if f(middle) > 0 else (low, middle)
        return low

    tail = (1 - level) / 2
    low = 0.0 if k == 0 else root(lambda p: tail - (1 - binomial_cdf(k - 1, n, p)))
    high = 1.0 if k == n else root(lambda p: binomial_cdf(k, n, p) - tail)
    return low, high
