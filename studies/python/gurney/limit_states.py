"""Limit states: of the study's job, or of a line such as ``peak_displacement > 0.2 m``."""

import re
from dataclasses import dataclass

import pandas

from .errors import Error, not_in_file
from .units import factor


@dataclass(frozen=True)
class LimitState:
    """What must not happen. It is exceeded when a value of ``column``, or ``at_least`` of them,
    is beyond ``limit`` [SI unit of the column], or when its ``parts`` are (any, or all)."""

    name: str
    words: str
    table: str = "items"
    column: str = ""
    above: bool = True
    limit: float = 0.0
    place: tuple = ()      #: pairs (column, name) that a row must have
    parts: tuple = ()      #: other limit states
    every: bool = False    #: all of the parts, not any
    at_least: int = 1


#: event: (table, column, limit); a time is -1 for never, so -0.5 lies between
_EVENTS = {
    "overturned": ("items", "time_of_overturning", -0.5),
    "impact": ("items", "impacts", 0.0),
    "lifted": ("items", "most_wheels_lifted", 0.0),
    "entered": ("zones", "time_of_entry", -0.5),
    "occupied at end": ("zones", "occupied_at_end", 0.0),
    "taut": ("tethers", "time_taut", -0.5),
    "broken": ("tethers", "time_broken", -0.5),
}

_DEFAULTS = (
    {"name": "moved", "demand": "residual_displacement", "above": 0.02, "unit": "m"},
    {"name": "rolled", "demand": "peak_displacement", "above": 0.3, "unit": "m"},
    {"name": "hit", "demand": "largest_approach_speed", "above": 0.4, "unit": "m/s"},
    {"name": "overturned", "event": "overturned"},
)

_LINE = re.compile(r"\s*(?:(?P<name>[^=<>:]+?)\s*=\s*)?(?:at least (?P<count>\d+) items:\s*)?"
                   r"(?:(?P<place>[^<>]+?):\s+)?(?P<what>[^<>:]+?)\s*"
                   r"(?:(?P<sign>[<>])\s*(?P<limit>[-+0-9.eE]+)\s*(?P<unit>.*?))?\s*$")


def limit_states_of(results):
    """The limit states of the study's job by name."""
    states = {}
    for given in results.job.get("study", {}).get("limit_state", _DEFAULTS):
        states[given["name"]] = _state(results, given, states)
    return states


def find(results, text):
    """A limit state of the job by its name, else what a line says."""
    states = results.limit_states
    if text in states:
        return states[text]
    line = _LINE.match(text)
    if not line or (line["sign"] is None and line["what"] not in _EVENTS):
        raise not_in_file(results.path, "limit state", text, states)
    given = {"name": line["name"] or text.strip()}
    if line["count"]:
        given["at_least"] = int(line["count"])
    if line["place"]:
        given.update(_named_place(results, line["place"]))
    if line["sign"] is None:
        given["event"] = line["what"]
    else:
        given["demand"] = line["what"]
        given["above" if line["sign"] == ">" else "below"] = float(line["limit"])
        if line["unit"]:
            given["unit"] = line["unit"]
    return _state(results, given, states)


def _named_place(results, place):
    """The keys of an item, a marked point (or item/point), a zone or a tether."""
    known = {}
    for table, column in (("items", "item"), ("zones", "zone"), ("tethers", "tether")):
        if table in results.tables:
            for name in results.table(table)[column].unique():
                known[name] = {column: name}
    if "points" in results.tables:
        points = results.table("points")[["item", "point"]].drop_duplicates()
        for item, point in points.itertuples(index=False):
            known[f"{item}/{point}"] = {"item": item, "point": point}
            known.setdefault(point, {"point": point})
    if place not in known:
        raise not_in_file(results.path, "item, marked point, zone or tether", place, known)
    return known[place]


def _state(results, given, before):
    name = given["name"]
    for key, every in (("any_of", False), ("all_of", True)):
        if key in given:
            parts = tuple(before[part] for part in given[key])
            words = (" and " if every else " or ").join(given[key])
            return LimitState(name, words, parts=parts, every=every,
                              at_least=given.get("at_least", 1))
    table = next((table for key, table in (("point", "points"), ("zone", "zones"),
                                           ("tether", "tethers")) if key in given), "items")
    place = tuple((key, given[key]) for key in ("item", "point", "zone", "tether") if key in given)
    at_least = given.get("at_least", 1)
    before_words = f"{'/'.join(value for _, value in place)}: " if place else ""
    if at_least > 1:
        before_words = f"at least {at_least} items: {before_words}"
    if "event" in given:
        of, column, limit = _EVENTS[given["event"]]
        if of != table:
            raise Error(f"limit state '{name}': '{given['event']}' is an event of /{of}")
        return LimitState(name, before_words + given["event"], table, column, True, limit, place,
                          at_least=at_least)
    return _demand(results, given, table, place, before_words, at_least)


def _demand(results, given, table, place, before_words, at_least):
    column = given["demand"]
    units = results.table(table).attrs["units"]
    if column not in units or column in ("row", "run", "item", "point", "zone", "tether"):
        raise not_in_file(results.path, f"demand in /{table}", column,
                          [each for each in units if each not in ("row", "run", "item")])
    above = "above" in given
    value = given["above" if above else "below"]
    unit = given.get("unit", "1" if units[column] == "1" else "missing")
    words = f"{before_words}{column} {'>' if above else '<'} {value:g} {unit}".removesuffix(" 1")
    return LimitState(given["name"], words, table, column, above,
                      value * factor(unit, units[column]), place, at_least=at_least)


def runs_that_exceed(results, state):
    """For each run that did not fail: does it exceed the limit state?"""
    runs = results.runs.index[~results.runs["failed"]]
    if state.parts:
        parts = pandas.DataFrame({i: runs_that_exceed(results, part)
                                  for i, part in enumerate(state.parts)})
        needed = len(state.parts) if state.every else state.at_least
        return (parts.sum(axis=1) >= needed).rename(state.name)
    rows = results.table(state.table, raw=True)
    if state.column not in rows:
        raise not_in_file(results.path, f"demand in /{state.table}", state.column,
                          [each for each in rows if each not in ("row", "run", "item")])
    for column, name in state.place:
        if name not in set(rows[column]):
            raise not_in_file(results.path, column, name, rows[column].unique())
        rows = rows[rows[column] == name]
    beyond = rows[state.column] > state.limit if state.above else rows[state.column] < state.limit
    count = beyond.groupby(rows["run"]).sum().reindex(runs).fillna(0)
    return (count >= state.at_least).rename(state.name)
