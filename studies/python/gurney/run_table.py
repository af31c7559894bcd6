"""The table of runs: what a run was given, joined to its row."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy
import pandas

from .units import unit_of_key

if TYPE_CHECKING:
    from .results import Results

_FAILURES = ("diverged", "untrusted")


def of_run(results: Results) -> pandas.DataFrame:
    """Of a single run: /runs as it is, with `failed`."""
    runs = results.table("runs")
    attributes = runs.attrs
    runs = runs.set_index("run")
    runs.insert(runs.columns.get_loc("outcome") + 1, "failed", runs["outcome"].isin(_FAILURES))
    runs.attrs = _described(attributes, failed=("1", "the run has no demands"))
    return runs


def of_study(results: Results) -> pandas.DataFrame:
    """Of a study: /runs with the names, measures and drawn values that its indices stand for."""
    file = results.table("runs").drop(columns="row")
    file = file.rename(columns={"unit": "analysis_case"}).set_index("run")
    table = _Joined(results.table("runs").attrs)
    table.add("outcome", file["outcome"])
    table.add("failed", file["outcome"].isin(_FAILURES), "1", "the run has no demands")
    table.add("cause", _causes(results, file.index), "1", "why the run failed; empty: it did not")
    _add_configuration(table, results, file)
    motions = results.table("motions")
    of_run = motions.iloc[file["motion"].to_numpy()].set_index(file.index)
    table.add("record", _record_names(results, of_run), "1", "name of the record")
    for name in file.columns.drop(["outcome", "configuration", "record", "motion"]):
        table.add(name, file[name])
    table.add("configuration_index", file["configuration"], "1", "row of /configurations")
    table.add("record_index", file["record"], "1", "index of the record in its set")
    for name in motions.columns.drop(["row", "set", "record", "scale"]):
        table.add(name, of_run[name], motions.attrs["units"][name],
                  motions.attrs["long_name"][name], "motions")
    _add_parameters(table, results, file)
    frame = table.frame()
    frame.attrs["units"]["intensity"] = results.provenance["intensity_units"] or "1"
    frame.attrs["intensity_measure"] = results.provenance["intensity_measure"]
    return frame


class _Joined:
    """Columns under names that differ, with their units."""

    def __init__(self, attributes: dict[str, Any]) -> None:
        self._file = attributes
        self._columns: dict[str, Any] = {}
        self._units: dict[str, str] = {}
        self._long_names: dict[str, str] = {}

    def add(self, name: str, values: Any, unit: str | None = None, long_name: str | None = None,
            table: str | None = None) -> None:
        if name in self._columns or (table and name in self._file["units"]):
            name = f"{table}.{name}"
        self._columns[name] = values
        self._units[name] = unit or self._file["units"].get(name, "1")
        self._long_names[name] = long_name or self._file["long_name"].get(name, "")

    def frame(self) -> pandas.DataFrame:
        result = pandas.DataFrame(self._columns)
        result.index.name = "run"
        result.attrs = {"units": self._units, "long_name": self._long_names}
        return result


def _described(attributes: dict[str, Any], **columns: tuple[str, str]) -> dict[str, Any]:
    units = dict(attributes["units"], **{name: unit for name, (unit, _) in columns.items()})
    names = dict(attributes["long_name"], **{name: text for name, (_, text) in columns.items()})
    return {"units": units, "long_name": names}


def _causes(results: Results, runs: pandas.Index) -> pandas.Series:
    failures = results.table("failures").drop_duplicates("run").set_index("run")["cause"]
    return failures.reindex(runs).fillna("")


def _add_configuration(table: _Joined, results: Results, file: pandas.DataFrame) -> None:
    configurations = results.table("configurations").drop(columns="row")
    levels = configurations.iloc[file["configuration"].to_numpy()].set_index(file.index)
    table.add("configuration", levels["name"], "1", "levels of all factors")
    for factor in configurations.columns.drop("name"):
        table.add(factor, levels[factor], "1", "level of this factor", "configurations")


def _record_names(results: Results, motions: pandas.DataFrame) -> pandas.Series:
    records = results.table("records")
    records["record"] = records.groupby("set").cumcount()
    names = records.set_index([records["set"].astype(int), "record"])["name"]
    keys = pandas.MultiIndex.from_arrays([motions["set"], motions["record"]])
    return pandas.Series(names.reindex(keys).to_numpy(), index=motions.index)


def _add_parameters(table: _Joined, results: Results, file: pandas.DataFrame) -> None:
    drawn = results.parameters
    if drawn.empty:
        return
    keys = pandas.MultiIndex.from_arrays([file["configuration"], file["draw"]])
    of_run = drawn.reindex(keys).set_index(file.index)
    for name in drawn.columns:
        table.add(name, of_run[name], drawn.attrs["units"][name], "drawn parameter", "drawn")


def parameters(results: Results) -> pandas.DataFrame:
    """The drawn parameters: of a study wide, a row for each draw; of a run a row for each."""
    if "drawn" not in results.tables:
        empty = pandas.DataFrame()
        empty.attrs = {"units": {}, "long_name": {}}
        return empty
    drawn = results.table("drawn")
    if results.kind == "run":
        return drawn.set_index("variable")
    order = pandas.unique(drawn["variable"])
    wide = drawn.pivot(index=["configuration", "draw"], columns="variable", values="value")[order]
    wide.columns.name = None
    wide.attrs = {"units": {name: unit_of_key(name) for name in order},
                  "long_name": {name: "drawn parameter" for name in order}}
    return wide


def records_of_run(results: Results) -> pandas.DataFrame:
    """The record of a single run, from the attributes of the file: one row for each of its files."""
    given = results.provenance
    files, hashes = (numpy.atleast_1d(given[name]).tolist()
                     for name in ("record_files", "record_sha256"))
    return pandas.DataFrame({"file": files, "sha256": hashes}).assign(
        name=results.runs["record"].iloc[0])
