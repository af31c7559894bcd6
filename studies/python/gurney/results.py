"""A results file: its tables, histories and provenance."""

from __future__ import annotations

import io
import os
import warnings
from functools import cached_property
from html import escape
from types import TracebackType
from typing import Any

import h5py
import pandas

from . import histories, jobs, program, run_table, tables
from .errors import DamagedFile, Error, NotInFile, not_in_file, shortened
from .fragility import Fragility, Statistics
from .page import Page

#: filetype: versions of the layout that this package reads. Version 1 of a study has no /data_files;
#: that of a run, of programs before 0.1.0, had one item in /runs.
_VERSIONS = {"gurney-results": (2,), "gurney-study": (1, 2)}


class Results:
    """A results file, open for reading. Frames are read when they are first asked for.

    ``kind`` is ``"study"`` or ``"run"``. Close it, or use it in ``with``.
    """

    def __init__(self, path: str | os.PathLike[str] | bytes, verify: bool = True) -> None:
        self._bytes = path if isinstance(path, bytes) else None
        self.path: str = "run in memory" if isinstance(path, bytes) else os.fspath(path)
        if not self._bytes:
            self._check_file()
        self.verified = self.verify() if verify else None
        if self.verified is False:
            warnings.warn(f"{self.path}: no checksum at its end: cut off, or changed by another program",
                          stacklevel=3)
        try:
            self._file = h5py.File(io.BytesIO(self._bytes) if self._bytes else self.path, "r")
        except OSError as error:
            raise DamagedFile(f"{self.path}: cannot be read: {error}") from error
        try:
            self._check_layout()
        except Error:
            self.close()
            raise

    def _check_file(self) -> None:
        if not os.path.isfile(self.path):
            raise Error(f"{self.path}: no such file")
        if not h5py.is_hdf5(self.path):
            raise Error(f"{self.path}: not an HDF5 file; `gurney run` writes those")

    def _check_layout(self) -> None:
        kind = tables.attribute(self._file.attrs.get("filetype", "none"))
        if kind not in _VERSIONS:
            raise Error(f"{self.path}: its filetype is {kind}; must be one of "
                        f"{', '.join(_VERSIONS)}")
        version = int(self._file.attrs["format_version"])
        if version not in _VERSIONS[kind]:
            known = " and ".join(str(each) for each in _VERSIONS[kind])
            raise Error(f"{self.path}: version {version} of the layout; this package reads "
                        f"version {known}: run the job again, or use the package of that program")
        self.kind = "study" if kind == "gurney-study" else "run"

    def close(self) -> None:
        """Closes the file; frames that were read stay valid."""
        self._file.close()
        self.__dict__.pop("statistics", None)

    def __enter__(self) -> Results:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None,
                 trace: TracebackType | None) -> None:
        self.close()

    def __repr__(self) -> str:
        return (f"<gurney results of a {self.kind}: {self.provenance['title']!r}, "
                f"{len(self._file['runs/run'])} runs; tables {', '.join(self.tables)}>")

    def verify(self) -> bool:
        """Compares the SHA-256 at the end of the file with its bytes.

        :returns: True; False if the file has no hash, because another program wrote into it
        :raises DamagedFile: a byte differs
        """
        return tables.verify(self._bytes or self.path)

    @cached_property
    def provenance(self) -> dict[str, Any]:
        """What made the file: a dict of its attributes, such as ``program_version``,
        ``git_commit``, ``job_sha256``, ``seed`` and ``record_sha256``."""
        return {name: tables.attribute(value) for name, value in self._file.attrs.items()}

    @cached_property
    def job(self) -> dict[str, Any]:
        """The job as nested dicts, from the text that the file holds."""
        return jobs.parsed(self.provenance["job_text"])

    @property
    def tables(self) -> list[str]:
        """Names of the groups of the file."""
        return list(self._file)

    def table(self, name: str, raw: bool = False) -> pandas.DataFrame:
        """A group of the file as it is: a DataFrame, one column for each dataset.

        :param raw: keep -1 and other values that stand for a missing one
        """
        if name not in self._file:
            raise not_in_file(self.path, "table", name,
                              [each for each in self._file if each != "histories"])
        return tables.frame(self._file[name], raw)

    @cached_property
    def runs(self) -> pandas.DataFrame:
        """One row for each run, index ``run``: what was given and how the run ended.

        Of a study, an index of the file is replaced by what it stands for: ``configuration`` and
        ``record`` are names, each factor is a column with its level, each intensity measure a
        column of the scaled ground motion, each drawn parameter a column with the value of this
        run. A name that two of them have gets the table before it, ``motions.scale``.
        ``record_index`` and ``configuration_index`` are the indices. ``failed`` is True for runs
        without demands, and ``cause`` says why.
        """
        return run_table.of_study(self) if self.kind == "study" else run_table.of_run(self)

    @cached_property
    def demands(self) -> pandas.DataFrame:
        """One row for each item of each run that did not fail, index ``(run, item)``.

        ``demands.join(runs)`` adds the columns of the runs; NaN: there is no such value, for
        example no ``time_of_overturning`` where the item stands.
        """
        return self._rows("items", "item")

    @cached_property
    def points(self) -> pandas.DataFrame:
        """One row for each marked point of each item of each run, index ``(run, item, point)``."""
        return self._rows("points", "item", "point")

    @cached_property
    def wheels(self) -> pandas.DataFrame:
        """One row for each wheel, index ``(run, item, wheel)``."""
        return self._rows("wheels", "item", "wheel")

    @cached_property
    def zones(self) -> pandas.DataFrame:
        """One row for each zone of the room in each run, index ``(run, zone)``."""
        return self._rows("zones", "zone")

    @cached_property
    def tethers(self) -> pandas.DataFrame:
        """One row for each cord, hose or line in each run, index ``(run, tether)``."""
        return self._rows("tethers", "tether")

    @cached_property
    def energy(self) -> pandas.DataFrame:
        """Energy balance of each item at the end of each run, index ``(run, item)`` [J]."""
        return self._rows("energy", "item")

    @cached_property
    def impacts(self) -> pandas.DataFrame:
        """One row for each impact in order of time, index ``run``."""
        return self._rows("events")

    @cached_property
    def records(self) -> pandas.DataFrame:
        """One row for each record: name, files with their hashes, processing, warnings."""
        if self.kind == "study":
            return self._rows("records")
        return run_table.records_of_run(self)

    @cached_property
    def configurations(self) -> pandas.DataFrame:
        """One row for each configuration of a study, index as in the file, with its levels."""
        return self._rows("configurations")

    @cached_property
    def motions(self) -> pandas.DataFrame:
        """One row for each scaled record of a study, with its intensity measures."""
        return self._rows("motions")

    @cached_property
    def parameters(self) -> pandas.DataFrame:
        """The drawn parameters. Of a study one row for each draw, index
        ``(configuration, draw)``, NaN where a configuration does not draw a parameter; of a run
        one row for each parameter with ``value`` and ``unit``. Empty if nothing was drawn."""
        return run_table.parameters(self)

    @cached_property
    def assumptions(self) -> pandas.DataFrame:
        """One row for each parameter without a source: value, range and reason."""
        return self._rows("assumptions")

    @cached_property
    def statistics(self) -> Statistics:
        """The program's statistics of this study: what the next three ask."""
        return Statistics(self)

    @property
    def limit_states(self) -> dict[str, str]:
        """The limit states of the study's job, or the usual four if it has none: definitions by name."""
        return self.statistics.limit_states()

    def exceeded(self, limit_state: str) -> pandas.Series:
        """Which runs exceed a limit state: a Series of bool, index ``run``, without failed runs.

        :param limit_state: a name of ``limit_states``, or a line such as
            ``"peak_displacement > 0.2 m"``
        :raises InputError: a demand, place or unit that the file does not have
        """
        return self.statistics.exceeded(limit_state)

    def fragility(self, limit_state: str | pandas.Series, measure: str | None = None,
                  configuration: str | None = None, *, method: str | None = None,
                  confidence: float = 0.95) -> Fragility:
        """The lognormal fragility function of one configuration, as `gurney fragility` has it.

        :param limit_state: a name of ``limit_states``, a line such as
            ``"peak_displacement > 0.2 m"``, or a Series of bool with the index ``run`` (NaN: no
            outcome)
        :param measure: such as ``"PGV geomean"`` or ``"pfa"``; the measure that the study scaled its
            records to if not stated
        :param configuration: its name; needed where there are several
        :param method: None, or ``"cloud"``: by regression of the demands
        :param confidence: of intervals and band, between 0 and 1
        :returns: :class:`gurney.Fragility`, in SI units
        :raises InputError: a limit state, measure or run that the file does not have
        """
        return self.statistics.fit(limit_state, measure, configuration, method, confidence)

    def compare_records(self, demand: str = "peak_displacement", configuration: str | None = None, *,
                        level: int | None = None) -> pandas.DataFrame:
        """The records at one level by what they do to an item, as `gurney compare --records` ranks them:
        index ``record``, first those that overturn it, then the largest demand; columns ``demand`` and
        ``predicted`` (by the best measure, from the other records) in SI units, ``overturned`` and
        ``runs``, each intensity measure, and ``reason``.

        ``attrs``: ``verdict``, ``level``, ``item``, ``units`` of the columns, and ``explained``: the share
        of the scatter that each measure predicts.

        :param demand: ``"peak_velocity"``; of several items ``"icu_bed: peak_velocity"``
        :param configuration: its name; needed where there are several
        :param level: the N-th, from 1; the highest if not stated
        :raises InputError: an IDA, a single record, or a name that the file does not have
        """
        options = ["--configuration", configuration] if configuration is not None else []
        options += ["--level", str(level)] if level is not None else []
        found = program.ask("compare", self._on_disk(), "--records", "--demand", demand, *options)
        if len(found) != 1:
            raise Error(f"{self.path}: which of "
                        + ", ".join(f"'{each['item']}: {demand}' of '{each['configuration']}'"
                                    for each in found) + "?")
        ranking = found[0]
        frame = pandas.DataFrame(ranking["records"]).rename(columns={"name": "record"}).set_index("record")
        reasons = frame.pop("reason")
        units = {"demand": ranking["units"], "predicted": ranking["units"]}
        for each in ranking["measures"]:
            frame[each["name"]] = each["values"]
            units[each["name"]] = each["units"]
        frame["reason"] = reasons
        frame["predicted"] = frame["predicted"].astype(float)
        frame.attrs = {"verdict": ranking["verdict"], "level": ranking["level"], "item": ranking["item"],
                       "units": units,
                       "explained": {each["name"]: each["explained"] for each in ranking["measures"]}}
        return frame

    def to_frame(self) -> pandas.DataFrame:
        """A row for each item of each run: its demands, and what the run was given, index
        ``(run, item)``; ``attrs["units"]`` has the unit of each column."""
        frame = self.demands.join(self.runs, rsuffix=" of run")
        frame.attrs["units"] = {**self.runs.attrs["units"], **self.demands.attrs["units"]}
        return frame

    def play(self, run: int | None = None, height: int = 600) -> Page:
        """The page of `gurney play`, in a notebook or saved.

        :param run: of a study, which runs it again; its job must be where it was
        """
        chosen = [] if run is None else ["--run", str(run)]
        return Page(program.page("play", self._on_disk(), *chosen), height)

    def report(self, height: int = 800) -> Page:
        """The page of `gurney report`, in a notebook or saved."""
        return Page(program.page("report", self._on_disk()), height)

    def _on_disk(self) -> str:
        if self._bytes:
            raise Error("this run is in memory: ask the Run, or save it first")
        return self.path

    def _repr_html_(self) -> str:
        html: str = self.runs.to_html(max_rows=10, max_cols=10, float_format="{:.4g}".format)
        return f"<p>{escape(self.provenance['title'])}: {len(self.runs)} runs</p>" + html

    def histories(self, run: int | None = None, item: str | None = None) -> Any:
        """Histories of a run: an xarray Dataset with the dimensions ``time`` [s], ``item``,
        ``axis``, ``wheel``, ``point``, and ``units`` of every variable.

        Without xarray a dict of arrays with the same names.

        :param run: needed where the file has histories of several runs
        :param item: only this item
        """
        return histories.of_run(self, run, item)

    def _rows(self, name: str, *index: str) -> pandas.DataFrame:
        """A table with the index (run, ...), without the column that counts its rows."""
        if name not in self._file:
            raise NotInFile(f"{self.path}: it has no /{name}; its tables are "
                            f"{shortened(self._file, 30)}" +
                            ("; [study.keep] of the job asks for more"
                             if self.kind == "study" else ""))
        frame = self.table(name)
        attributes = frame.attrs
        by = [each for each in ("run", *index) if each in frame]
        frame = frame.drop(columns="row", errors="ignore")
        frame = frame.set_index(by) if by else frame
        frame.attrs = attributes
        return frame
