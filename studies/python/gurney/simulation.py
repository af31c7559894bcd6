"""Single runs from Python, in memory: the bits of ``gurney run`` without its files.

The simulation is that of the compiled module ``gurney._engine``; reading results works without it.
"""

from __future__ import annotations

import multiprocessing.pool
import numbers
import os
import tempfile
from collections.abc import Iterable, Mapping, Sequence
from functools import cached_property
from html import escape
from typing import Any, TypeAlias

import numpy
import numpy.typing
import pandas

from . import engine, jobs, program
from .errors import InputError, at_least_one
from .page import Page
from .records import Record, samples_of
from .results import Results

Array = numpy.typing.NDArray[numpy.float64]
Item: TypeAlias = str | os.PathLike[str] | Mapping[str, Any] | Sequence[Mapping[str, Any]]
Motion: TypeAlias = (numpy.typing.ArrayLike | str | os.PathLike[str] | Mapping[str, Any] | Record |
                     None)


def simulate(item: Item, record: Motion = None, time_step: float | None = None, *,
             predictability: bool = True, **tables: Any) -> Run:
    """Runs an item, or several, on one motion of the floor.

    :param item: a name of the catalogue, a path of an item file (``"my_item.toml"``), a dict with the
        keys of ``[item]`` of a job (:func:`gurney.item` makes one), or a list of such dicts
    :param record: acceleration of the floor [m/s2] as an array, one row for each time, with one
        column (x) or three (x, y, z), up to 100 g, and ``time_step``, unless it is a Series, DataFrame or
        DataArray with its times [s], whose columns may have the names x, y, z or h1, h2, vertical, in any
        order; or a :class:`gurney.records.Record`; or the path of a record file; or a dict with the keys
        of ``[excitation.record]``; or None: the floor rests
    :param time_step: of an array, 0.00001 to 1 [s]
    :param predictability: run the twin as well, as ``gurney run`` does; False takes half the time
    :param tables: other tables of a job as dicts: ``floor``, ``room``, ``settings``, ``excitation``
    :returns: :class:`Run`. A run that diverged is one with ``failed``, not an exception.
    :raises InputError: what is wrong with the item, the record or the tables, with its place

    Relative paths start at the working folder. Releases the GIL: threads run side by side, and every
    run has the same bits as alone.
    """
    job: jobs.Job = {"schema": "gurney-job/1", "item": _item(item), **tables}
    samples, step = None, 0.0
    if isinstance(record, Record) and time_step is None:
        samples, step = record.acceleration, record.time_step
    elif record is not None and not isinstance(record, (str, os.PathLike, Mapping, Record)):
        samples, step, _ = samples_of(record, time_step)
    elif time_step is not None:
        raise InputError("time_step goes with an array; of a file it is "
                         "record={'file': ..., 'time_step_s': ...}")
    elif isinstance(record, (str, os.PathLike, Mapping)):
        stated = dict(record) if isinstance(record, Mapping) else {"file": os.fspath(record)}
        job["excitation"] = {**_table(job, "excitation"), "record": stated}
    return Run(engine.module().simulate("simulate.json", jobs.text(job), samples, step,
                                        _choice("predictability", predictability)))


def simulate_many(cases: Iterable[Mapping[str, Any]], *, threads: int | None = None) -> Runs:
    """Many runs, side by side.

    :param cases: the arguments of :func:`simulate` of each run, by name:
        ``{"item": "icu_bed", "record": pulse, "time_step": 0.005}``; a ``label``, a text or a dict, is
        for :meth:`Runs.to_frame` alone
    :param threads: all of the machine if not stated; the runs have the same bits for any number
    :returns: :class:`Runs`, in the order of the cases
    :raises InputError: of a case that is wrong, with its number from 0
    """
    given = [dict(case) for case in cases]
    wanted = os.cpu_count() if threads is None else at_least_one("threads", threads)

    def run_case(number: int) -> Run:
        case = {key: value for key, value in given[number].items() if key != "label"}
        if "item" not in case:
            raise InputError(f"cases[{number}]: item is missing, got {sorted(map(str, case))}")
        try:
            return simulate(**case)
        except (InputError, TypeError) as error:
            raise InputError(f"cases[{number}]: {error}") from error

    with multiprocessing.pool.ThreadPool(wanted) as pool:
        return Runs(given, pool.map(run_case, range(len(given)), chunksize=1))


def run(job: str | os.PathLike[str] | Mapping[str, Any],
        overrides: Mapping[str, Any] | None = None, *, predictability: bool = True,
        **more: Any) -> Run:
    """Runs a job of a single run with other values, as ``gurney run`` does with the changed file.

    :param job: the path of a job file, or a job as a dict (:func:`gurney.read_job`)
    :param overrides: values by their dotted keys, ``{"item.brakes": True}``; see :func:`gurney.patched`
    :param more: the same with ``__`` for each dot: ``settings__duration_s=12``
    :returns: :class:`Run`
    :raises InputError: all errors of the job and its files, each with its place: of a file
        ``job.toml:3:13: what``, of a changed one ``job.toml:/item/brakes: what``

    Relative paths in a file start at its folder, in a dict at the working folder.
    """
    changes = {**(overrides or {}), **jobs.dotted(more)}
    text: str | None = None
    if isinstance(job, Mapping):
        name, text = "job.json", jobs.text(jobs.patched(job, changes))
    else:
        name = os.fsdecode(job)
        if "\0" in name:
            raise InputError(f"{name!r}: a path has no NUL character")
        if changes:
            text = jobs.text(jobs.patched(jobs.read_job(name), changes))
    return Run(engine.module().simulate(name, text, None, 0.0,
                                        _choice("predictability", predictability)))


def simulate_job(path: str | os.PathLike[str], *, predictability: bool = True) -> Run:
    """Runs a job file of a single run as it is: :func:`run` without changes."""
    return run(path, predictability=predictability)


class Run:
    """A run that has ended.

    ``outcome`` (``"rested"``, ``"overturned"``, ...), ``failed`` with its ``cause``, ``end_time`` [s],
    ``warnings`` and ``items`` (names). Numbers are in SI units, angles in radians; NaN: there is none.
    """

    def __init__(self, run: Any) -> None:
        self._run = run
        self.outcome: str = run.outcome
        self.failed: bool = run.failed
        self.cause: str = run.cause
        self.end_time: float = run.end_time
        self.warnings: list[str] = run.warnings
        self.items: list[str] = run.items

    @cached_property
    def demands(self) -> dict[str, dict[str, float]]:
        """``demands[item][name]``; empty if the run failed."""
        found: dict[str, dict[str, float]] = self._run.demands()
        return found

    @cached_property
    def wheels(self) -> dict[str, dict[str, dict[str, float]]]:
        """Demands of the wheels, ``wheels[item][wheel][name]``."""
        found: dict[str, dict[str, dict[str, float]]] = self._run.wheels()
        return found

    @cached_property
    def points(self) -> dict[str, dict[str, dict[str, float]]]:
        """Demands of the marked points, ``points[item][point][name]``."""
        found: dict[str, dict[str, dict[str, float]]] = self._run.points()
        return found

    @cached_property
    def histories(self) -> dict[str, Array]:
        """Arrays of numpy by name, with the dimensions of the results file: ``time``; then
        ``displacement`` (time, item, axis), ``yaw`` (time, item), ``normal_force`` (time, wheel),
        ``point_velocity`` (time, point, axis) and so on."""
        found: dict[str, Array] = self._run.histories()
        return found

    @cached_property
    def results(self) -> Results:
        """The same as :class:`gurney.Results`, with units, in memory."""
        return Results(self._run.results())

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the results file, byte for byte that of ``gurney run``, if it does not exist."""
        with open(path, "xb") as file:
            file.write(self._run.results())

    def to_frame(self) -> pandas.DataFrame:
        """A row for each item with its demands, index ``item``; ``attrs["units"]`` has the units.
        Empty if the run failed."""
        if self.failed:
            return pandas.DataFrame(index=pandas.Index([], name="item"))
        frame = self.results.demands
        flat = frame.droplevel("run")
        flat.attrs = frame.attrs
        return flat

    def play(self, height: int = 600) -> Page:
        """The page of `gurney play`: the run in three dimensions, in a notebook or saved."""
        return Page(self._page("play"), height)

    def report(self, height: int = 800) -> Page:
        """The page of `gurney report`."""
        return Page(self._page("report"), height)

    def _page(self, command: str) -> str:
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "run.h5")
            self.save(path)
            return program.page(command, path)

    def _repr_html_(self) -> str:
        title = f"<p>{escape(', '.join(self.items))}: {self.outcome} at {self.end_time:g} s</p>"
        if self.failed:
            return title + f"<p>{escape(self.cause)}</p>"
        units = self.results.demands.attrs["units"]
        shown = self.to_frame().rename(columns=lambda name: f"{name} [{units[name]}]")
        html: str = shown.T.to_html(float_format="{:.4g}".format)
        return title + html

    def __repr__(self) -> str:
        return f"<gurney run of {', '.join(self.items)}: {self.outcome} at {self.end_time:g} s>"


class Runs(list[Run]):
    """Runs in the order of their ``cases``."""

    def __init__(self, cases: Iterable[Mapping[str, Any]], runs: Iterable[Run]) -> None:
        super().__init__(runs)
        self.cases = list(cases)

    def to_frame(self) -> pandas.DataFrame:
        """A row for each item of each run, index ``(run, item)``: the numbers, texts and booleans of
        its case, by dotted names (``item.brakes``), ``outcome``, and the demands in SI units, which
        ``attrs["units"]`` has."""
        rows = []
        for number, (case, run) in enumerate(zip(self.cases, self)):
            given = {**dict(_scalars(case, "")), "outcome": run.outcome}
            for item in run.items:
                rows.append({"run": number, "item": item, **{f"case.{name}" if name == "item" else name:
                             value for name, value in given.items()}, **run.demands.get(item, {})})
        frame = pandas.DataFrame(rows).set_index(["run", "item"]) if rows else pandas.DataFrame()
        known = next((run for run in self if not run.failed), None)
        frame.attrs["units"] = dict(known.results.demands.attrs["units"]) if known else {}
        return frame

    def _repr_html_(self) -> str:
        html: str = self.to_frame().to_html(float_format="{:.4g}".format, max_rows=20, max_cols=12)
        return html


def _scalars(value: Any, name: str) -> Iterable[tuple[str, Any]]:
    """Numbers, texts and booleans with their dotted names."""
    if isinstance(value, Mapping):
        for key, inner in value.items():
            yield from _scalars(inner, f"{name}.{key}" if name else str(key))
    elif isinstance(value, (str, numbers.Real, numpy.bool_)):
        yield name, value


def _item(item: Any) -> Any:
    if isinstance(item, (str, os.PathLike)):
        return {"equipment": os.fspath(item)}
    return item


def _choice(name: str, value: object) -> bool:
    if not isinstance(value, (bool, numpy.bool_)):
        raise InputError(f"{name} = {value!r}: must be True or False")
    return bool(value)


def _table(job: jobs.Job, name: str) -> dict[str, Any]:
    table = job.get(name, {})
    if not isinstance(table, dict):
        raise InputError(f"{name} = {table!r}: must be a dict")
    return table
