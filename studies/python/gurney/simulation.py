"""Single runs from Python, in memory: the bits of ``gurney run`` without its files.

The simulation is that of the compiled module ``gurney._engine``; the rest of the package works
without it.
"""

import json
import os
import pathlib
from functools import cached_property

import numpy

from .errors import InputError
from .results import Results


def simulate(item, record=None, time_step=None, *, predictability=True, **tables):
    """Runs an item, or several, on one motion of the floor.

    :param item: a name of the catalogue, a path of an item file (``"my_item.toml"``), a dict with the
        keys of ``[item]`` of a job, or a list of such dicts
    :param record: acceleration of the floor [m/s2] as an array, one row for each time, with one
        column (x) or three (x, y, z), and ``time_step`` [s]; or the path of a record file; or a dict
        with the keys of ``[excitation.record]``; or None: the floor rests
    :param predictability: run the twin as well, as ``gurney run`` does; False takes half the time
    :param tables: other tables of a job as dicts: ``floor``, ``room``, ``settings``, ``excitation``
    :returns: :class:`Run`. A run that diverged is one with ``failed``, not an exception.
    :raises InputError: what is wrong with the item, the record or the tables, with its place

    Relative paths start at the working folder. Releases the GIL: threads run side by side, and every
    run has the same bits as alone.
    """
    job = {"schema": "gurney-job/1", "item": _item(item), **tables}
    samples = None
    if record is not None and not isinstance(record, (str, os.PathLike, dict)):
        samples = _samples(record, time_step)
    elif record is not None:
        if time_step is not None:
            raise InputError("time_step goes with an array; of a file it is "
                             "record={'file': ..., 'time_step_s': ...}")
        stated = record if isinstance(record, dict) else {"file": os.fspath(record)}
        job["excitation"] = {**job.get("excitation", {}), "record": stated}
    text = json.dumps(job, default=_plain, indent=1)
    return Run(_engine().simulate("simulate.json", text, samples, float(time_step or 0),
                                  bool(predictability)))


def simulate_job(path, *, predictability=True):
    """Runs a job file of a single run, as ``gurney run`` does.

    :returns: :class:`Run`
    :raises InputError: all errors of the job and its files, each as ``file:line:column: what``
    """
    return Run(_engine().simulate(os.fspath(path), None, None, 0.0, bool(predictability)))


class Run:
    """A run that has ended.

    ``outcome`` (``"rested"``, ``"overturned"``, ...), ``failed`` with its ``cause``, ``end_time`` [s],
    ``warnings`` and ``items`` (names). Numbers are in SI units, angles in radians; NaN: there is none.
    """

    def __init__(self, run):
        self._run = run
        self.outcome, self.failed, self.cause = run.outcome, run.failed, run.cause
        self.end_time, self.warnings, self.items = run.end_time, run.warnings, run.items

    @cached_property
    def demands(self):
        """``demands[item][name]``; empty if the run failed."""
        return self._run.demands()

    @cached_property
    def wheels(self):
        """Demands of the wheels, ``wheels[item][wheel][name]``."""
        return self._run.wheels()

    @cached_property
    def points(self):
        """Demands of the marked points, ``points[item][point][name]``."""
        return self._run.points()

    @cached_property
    def histories(self):
        """Arrays of numpy by name, with the dimensions of the results file: ``time``; then
        ``displacement`` (time, item, axis), ``yaw`` (time, item), ``normal_force`` (time, wheel),
        ``point_velocity`` (time, point, axis) and so on."""
        return self._run.histories()

    @cached_property
    def results(self):
        """The same as :class:`gurney.Results`, with units, in memory."""
        return Results(self._run.results())

    def save(self, path):
        """Writes the results file, byte for byte that of ``gurney run``, if it does not exist."""
        with open(path, "xb") as file:
            file.write(self._run.results())

    def __repr__(self):
        return f"<gurney run of {', '.join(self.items)}: {self.outcome} at {self.end_time:g} s>"


def _item(item):
    if isinstance(item, (str, os.PathLike)):
        return {"equipment": os.fspath(item)}
    return item


def _samples(record, time_step):
    if time_step is None:
        raise InputError("record: an array needs time_step [s]")
    try:
        return numpy.asarray(record, dtype=float)
    except (TypeError, ValueError) as error:
        raise InputError(f"record: not an array of numbers: {error}") from error


def _plain(value):
    """What JSON does not know: numbers and arrays of numpy, and paths."""
    if isinstance(value, (numpy.ndarray, numpy.generic)):
        return value.tolist()
    if isinstance(value, pathlib.PurePath):
        return str(value)
    raise InputError(f"{value!r}: a job has numbers, texts, lists and dicts")


def _engine():
    try:
        from . import _engine as engine
    except ImportError as error:
        raise ImportError(
            "gurney.simulate needs the compiled module gurney._engine for this Python: install the "
            "Debian packages python3-dev and pybind11-dev, build and install Gurney (./dev install), "
            f"or the package python3-gurney. Reading results works without it. ({error})") from error
    return engine
