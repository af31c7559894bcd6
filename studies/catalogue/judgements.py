"""Counts what is published and what is judged in the files that the studies of an item rest on, for constants.md."""

import os
import tomllib

from catalogue import ROOT

COVERING = "polyflor_mystique"
KINDS = ("published", "published in part", "judged")


def quantities(table):
    """The tables of a file that state where their value comes from; not those of variants, which are not run."""
    if isinstance(table, list):
        for each in table:
            yield from quantities(each)
    elif isinstance(table, dict):
        if "value" in table and {"source", "assumption"} & table.keys():
            yield table
        for key, each in table.items():
            if key not in ("variant", "distribution"):
                yield from quantities(each)


def kind(quantity):
    """A value that is taken from elsewhere by analogy has a source and an assumption, and so has a distribution."""
    if "assumption" not in quantity:
        return KINDS[0]
    return KINDS[1] if {"source"} & (quantity.keys() | quantity.get("distribution", {}).keys()) else KINDS[2]


def load(*path):
    """A file of equipment, by the words of its path."""
    with open(os.path.join(ROOT, "equipment", *path) + ".toml", "rb") as file:
        return tomllib.load(file)


def caster_types(item):
    """Names of the files of an item's casters, each once."""
    types = (caster["type"] for caster in item.get("caster", []) if "type" in caster)
    return sorted({each["value"] if isinstance(each, dict) else each for each in types})


def counts(item):
    """How many quantities there are of each kind, how many of the last two are drawn in a study, and what is drawn."""
    file = load("items", item)
    found = [each for name in caster_types(file) for each in quantities(load("casters", name))]
    found += [*quantities(file), *quantities(load("floors", COVERING)), *quantities(load("levelness"))]
    by_kind = {name: [each for each in found if kind(each) == name] for name in KINDS}
    drawn = sum("distribution" in each for name in KINDS[1:] for each in by_kind[name])
    return {name: len(of) for name, of in by_kind.items()} | {"drawn": drawn}
