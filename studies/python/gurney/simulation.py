"""Single runs from Python, in memory: the bits of ``gurney run`` without its files.

The simulation is that of the compiled module ``gurney._engine``; the rest of the package works
without it.
"""

import json
import numbers
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
    samples, step = None, 0.0
    if record is not None and not isinstance(record, (str, os.PathLike, dict)):
        samples, step = _samples(record), _step(time_step)
    elif time_step is not None:
        raise InputError("time_step goes with an array; of a file it is "
                         "record={'file': ..., 'time_step_s': ...}")
    elif record is not None:
        stated = record if isinstance(record, dict) else {"file": os.fspath(record)}
        job["excitation"] = {**_table(job, "excitation"), "record": stated}
    return Run(_engine().simulate("simulate.json", _text(job), samples, step,
                                  _choice("predictability", predictability)))


def simulate_job(path, *, predictability=True):
    """Runs a job file of a single run, as ``gurney run`` does.

    :returns: :class:`Run`
    :raises InputError: all errors of the job and its files, each as ``file:line:column: what``
    """
    name = os.fsdecode(path)
    if "\0" in name:
        raise InputError(f"{name!r}: a path has no NUL character")
    return Run(_engine().simulate(name, None, None, 0.0,
                                  _choice("predictability", predictability)))


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


def _is_real(value):
    return isinstance(value, numbers.Real) and not isinstance(value, (bool, numpy.bool_))


def _samples(record):
    """An array of real numbers; numpy would make some of booleans, texts, dates and masks too."""
    masked = int(numpy.ma.count_masked(record)) if numpy.ma.isMaskedArray(record) else 0
    if masked:
        raise InputError(f"record: {masked} of {numpy.ma.size(record)} samples are masked; a "
                         "record has no gaps")
    try:
        array = numpy.asarray(record)
        real = (array.dtype.kind in "fiu" or
                array.dtype.kind == "O" and all(_is_real(each) for each in array.flat))
        if not real:
            raise InputError(f"record: not an array of real numbers, but of {array.dtype}")
        return array.astype(float)
    except (TypeError, ValueError, OverflowError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(f"record: not an array of numbers: {error}") from error


def _step(time_step):
    if time_step is None:
        raise InputError("record: an array needs time_step [s]")
    if isinstance(time_step, numpy.ndarray) and time_step.ndim == 0:
        time_step = time_step[()]
    if not _is_real(time_step):
        raise InputError(f"time_step = {time_step!r}: must be a number [s]")
    return float(time_step)


def _choice(name, value):
    if not isinstance(value, (bool, numpy.bool_)):
        raise InputError(f"{name} = {value!r}: must be True or False")
    return bool(value)


def _table(job, name):
    table = job.get(name, {})
    if not isinstance(table, dict):
        raise InputError(f"{name} = {table!r}: must be a dict")
    return table


def _text(job):
    try:
        return json.dumps(job, default=_plain, indent=1)
    except RecursionError as error:
        raise InputError("the tables of the job are nested too deep") from error
    except (TypeError, ValueError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(f"the tables of the job cannot be written as JSON: {error}") from error


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
