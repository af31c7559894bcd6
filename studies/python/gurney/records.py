"""Ground motions and floor motions: read, processed, scaled, generated, as the program has them.

Every function asks `gurney records`. Where a record is asked for, a path, a folder, a pattern
(``"recs/*.AT2"``) or a :class:`Record` may stand. Accelerations are in m/s2, times in s.
"""

from __future__ import annotations

import csv
import numbers
import os
import pathlib
import tempfile
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from html import escape
from typing import Any, TypeAlias, Union

import numpy
import numpy.typing
import pandas

from . import program
from .errors import Error, InputError
from .units import factor

Array: TypeAlias = numpy.typing.NDArray[numpy.float64]
Source: TypeAlias = Union[str, os.PathLike[str], "Record"]
_DIRECTIONS = {"x": "h1", "y": "h2", "z": "vertical"}


@dataclass(frozen=True)
class Record:
    """A record in memory, which :func:`gurney.simulate` takes: ``acceleration`` [m/s2] has the shape
    (samples, 3), or (samples, 1) with x alone; a component that is missing is 0, ``components`` names
    those that are there. ``notes`` says what it was made from, and how it was processed."""

    name: str
    acceleration: Array = field(repr=False)
    time_step: float  #: [s]
    components: tuple[str, ...] = ("h1", "h2", "vertical")
    notes: tuple[str, ...] = field(default=(), repr=False)

    @property
    def time(self) -> Array:
        """Times of the samples [s], from 0."""
        return numpy.arange(len(self.acceleration)) * self.time_step

    def scaled(self, by: float) -> Record:
        """The record times a factor."""
        return Record(self.name, self.acceleration * by, self.time_step, self.components,
                      (*self.notes, f"scaled by {by:g}"))

    def to_frame(self) -> pandas.DataFrame:
        """Accelerations [m/s2] by component, index ``time`` [s]."""
        frame = pandas.DataFrame(self.acceleration, pandas.Index(self.time, name="time"),
                                 list(_DIRECTIONS.values())[:self.acceleration.shape[1]])
        return frame[list(self.components)]

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes Gurney's CSV, if it does not exist."""
        columns = [f"{axis}_m_per_s2" for axis, name in _DIRECTIONS.items() if name in self.components]
        with open(path, "x", encoding="utf-8") as file:
            file.write(f"# record: {self.name}\n" + ",".join(["time_s", *columns]) + "\n")
            for time, row in zip(self.time, self.to_frame().to_numpy()):
                file.write(",".join(f"{each:.17g}" for each in (time, *row)) + "\n")

    def _repr_html_(self) -> str:
        return (f"<p>{self.name}: {len(self.acceleration)} samples every {self.time_step:g} s, "
                f"{', '.join(self.components)}, PGA {abs(self.acceleration).max():.4g} m/s2</p>")


def from_array(acceleration: Any, time_step: float | None = None, *, unit: str,
               name: str = "record") -> Record:
    """A record of an array, for everything that takes records.

    :param acceleration: shape (samples,) or (samples, 1): x; (samples, 3): x, y, z. A Series or DataFrame
        of pandas may have the times [s] as its index, a DataArray of xarray as its coordinate ``time``.
        Columns with names are x, y, z or h1, h2, vertical, in any order, and may be ``time`` [s]
    :param time_step: 0.00001 to 1 [s]; not needed with such times, which must be evenly spaced
    :param unit: ``"g"``, ``"m/s2"`` or ``"cm/s2"``; it has no default: an array in g is not one in m/s2
    :raises InputError: another shape or unit, values that are no numbers, times that are uneven
    """
    if not isinstance(name, str) or not name.isprintable():
        raise InputError(f"name = {name!r}: must be a text in one line")
    try:
        in_si = factor(unit, "m/s2")
    except Error as error:
        raise InputError(f"{name}: {error}") from error
    samples, step, components = samples_of(acceleration, time_step, name)
    table = samples.reshape(len(samples), -1) if samples.ndim else samples
    if table.ndim != 2 or len(table) < 2 or table.shape[1] not in (1, 3) or not numpy.isfinite(table).all():
        raise InputError(f"{name}: must be 2 or more samples of 1 or 3 components, each a finite number; its "
                         f"shape is {samples.shape}")
    if not 1e-5 <= step <= 1:
        raise InputError(f"{name}: time_step = {step:g}: must be 0.00001 to 1 [s]")
    return Record(name, table * in_si, step,
                  components or tuple(_DIRECTIONS.values())[:table.shape[1]])


def samples_of(given: Any, time_step: Any, name: str = "record") -> tuple[Array, float, tuple[str, ...]]:
    """An array of real numbers, its time step [s], and the components that its columns name, if they do;
    numpy would make numbers of booleans, texts, dates and masks too.

    :raises InputError: it is none, or has columns or times of which no motion can be made
    """
    table = _as_pandas(given)
    components: tuple[str, ...] = ()
    times = getattr(table, "index", None)
    if isinstance(table, pandas.DataFrame) and not isinstance(table.columns, pandas.RangeIndex):
        if list(table.columns).count("time") == 1:
            times = pandas.Index(table["time"])
            table = table.drop(columns="time")
        table, components = _by_component(table, name)
    samples = _real(table, name)
    step = _step_of(times) if time_step is None else time_step
    if step is None:
        raise InputError(f"{name}: an array needs time_step [s], or times as its index")
    if isinstance(step, numpy.ndarray) and step.ndim == 0:
        step = step[()]
    if not _is_real(step):
        raise InputError(f"time_step = {step!r}: must be a number [s]")
    return samples, float(step), components


def _as_pandas(given: Any) -> Any:
    """A DataArray of xarray as a Series or a DataFrame, a row for each time."""
    if not hasattr(given, "to_pandas") or getattr(given, "ndim", 0) not in (1, 2):
        return given
    return (given.transpose("time", ...) if "time" in given.dims else given).to_pandas()


def _by_component(table: pandas.DataFrame, name: str) -> tuple[Any, tuple[str, ...]]:
    """The columns x, y, z or h1, h2, vertical in that order, 0 where one is missing; x alone stays so."""
    places = {each: place for names in (_DIRECTIONS, _DIRECTIONS.values())
              for place, each in enumerate(names)}
    wrong = [each for each in table.columns if not isinstance(each, str) or each not in places]
    if wrong:
        raise InputError(f"{name}: column {wrong[0]!r}: must be x, y, z, or h1, h2, vertical, or time [s]")
    found = [places[each] for each in table.columns]
    if len(set(found)) < len(found) or not found:
        raise InputError(f"{name}: columns {', '.join(table.columns) or 'none'}: must be a column for "
                         "each component, x, y, z or h1, h2, vertical")
    there = tuple(list(_DIRECTIONS.values())[place] for place in sorted(found))
    if found == [0]:
        return table, there
    samples = numpy.zeros((len(table), 3))
    samples[:, found] = _real(table, name)
    return samples, there


def _is_real(value: object) -> bool:
    return isinstance(value, numbers.Real) and not isinstance(value, (bool, numpy.bool_))


def _real(given: Any, name: str) -> Array:
    masked = int(numpy.sum(given.mask)) if isinstance(given, numpy.ma.MaskedArray) else 0
    if masked:
        raise InputError(f"{name}: {masked} of {given.size} samples are masked; a record has no gaps")
    try:
        array = numpy.asarray(given)
        real = (array.dtype.kind in "fiu" or
                array.dtype.kind == "O" and all(_is_real(each) for each in array.flat))
        if not real:
            raise InputError(f"{name}: not an array of real numbers, but of {array.dtype}")
        return array.astype(float)
    except (TypeError, ValueError, OverflowError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(f"{name}: not an array of numbers: {error}") from error


def _step_of(times: Any) -> float | None:
    """The step [s] of an index of times; None: it has none."""
    if not isinstance(times, pandas.Index) or isinstance(times, pandas.RangeIndex):
        return None
    at = numpy.asarray(times)
    if at.dtype.kind not in "fiu" or len(at) < 2:
        return None
    step = float(at[-1] - at[0]) / (len(at) - 1)
    # Times are often written with few digits: a hundredth of a step is no gap.
    if not step > 0 or not (abs(numpy.diff(at) / step - 1) < 0.01).all():
        raise InputError("record: its times are not evenly spaced: resample it, or state time_step")
    return step


def read(path: Source, *, unit: str | None = None, time_step: float | None = None,
         steps: Sequence[str] = (), scale_to: str | None = None) -> Record:
    """A record of any format that `gurney records` knows, processed and scaled on the way.

    :param unit: of a file that does not state it: ``"g"``, ``"m/s2"``, ``"cm/s2"`` ...
    :param time_step: of a file that does not state it [s]
    :param steps: processing steps in their order, ``"high_pass corner_hz=0.1"``
    :param scale_to: ``"Sa(1.0) component=RotD50 value=0.6 unit=g"``, the keys of ``scale_to`` of a job
    :raises InputError: the file is damaged, its format unknown, a unit missing
    """
    options = [*_stated(unit, time_step, steps), *(["--scale-to", scale_to] if scale_to else [])]
    return _written("convert", path, *options)


def read_all(*paths: Source, unit: str | None = None, time_step: float | None = None,
             steps: Sequence[str] = (), scale_to: str | None = None) -> list[Record]:
    """All records of files, folders, patterns and lists (with their factors), as :func:`read`.

    :raises InputError: no record, or two of one name
    """
    options = [*_stated(unit, time_step, steps), *(["--scale-to", scale_to] if scale_to else [])]
    with tempfile.TemporaryDirectory() as folder:
        return _all_written(folder, *_paths(paths, folder), *options)


def process(record: Source, *steps: str) -> Record:
    """A record after processing steps, ``"band_pass corners_hz=[0.1,25]"`` (docs/formats/processing.md).

    :raises InputError: a step is unknown or wrong
    """
    return read(record, steps=steps)


def ls(*paths: Source) -> pandas.DataFrame:
    """The records of files and folders: a row each, with what `gurney records ls --json` says."""
    return pandas.json_normalize(_ask("ls", paths)["records"])


def measures(record: Source, names: Sequence[str] = (), *, unit: str | None = None,
             time_step: float | None = None, steps: Sequence[str] = ()) -> pandas.DataFrame:
    """Intensity measures, a row for each, a column for each component and combination: h1, h2,
    vertical, RotD50, RotD100, geomean, resultant; NaN: there is none. In SI units, which
    ``attrs["units"]`` has by measure.

    :param names: ``"PGA"``, ``"Sa(0.3)"`` and so on; the common ones if none is named
    """
    options = [each for name in names for each in ("--measure", name)]
    found = _ask("info", [record], *options, *_stated(unit, time_step, steps))["records"]
    if len(found) != 1:
        raise InputError(f"{len(found)} records are there; ask for one")
    given = found[0]["measures"]
    frame = pandas.DataFrame({name: of["values"] for name, of in given.items()}).T.astype(float)
    frame.index.name = "measure"
    frame.attrs["units"] = {name: of["unit"] for name, of in given.items()}
    return frame


def spectrum(record: Source, periods: Iterable[float] | None = None, *, unit: str | None = None,
             time_step: float | None = None, steps: Sequence[str] = ()) -> pandas.DataFrame:
    """Pseudo-acceleration spectrum at 5 % damping [m/s2], index ``period`` [s]; columns h1, h2,
    vertical, RotD50, RotD100, geomean.

    :param periods: > 0 [s]; 31 from 0.05 to 5 s if not stated
    """
    at = numpy.geomspace(0.05, 5, 31) if periods is None else periods
    wanted = [float(period) for period in at]
    wrong = [period for period in wanted if not 0 < period < numpy.inf]
    if wrong or not wanted:
        raise InputError(f"periods: {wrong[0] if wrong else 'none'}: must be > 0 [s]")
    names = [f"Sa({period:.17g})" for period in wanted]
    frame = measures(record, names, unit=unit, time_step=time_step, steps=steps)
    if len(frame) < len(wanted):
        raise InputError("periods: two of them are the same to the digits of their names: "
                         + ", ".join(f"{period:g}" for period in wanted))
    frame.index = pandas.Index(wanted, name="period")
    return frame.dropna(axis="columns", how="all")


def scale(paths: Source | Iterable[Source], target: str, *, periods: tuple[float, float] | None = None,
          component: str | None = None, common: bool = False) -> pandas.DataFrame:
    """Factors that bring a suite to a target spectrum: a row for each record with ``factor`` and
    ``misfit``; ``attrs`` has what is of the suite: ``target``, ``common_factor``, ``warnings`` ...

    :param target: ``"asce7 sds_g=1 sd1_g=0.6"``, ``"eurocode8 ground=B ag_g=0.3"``, ``"nzs1170 ..."``,
        ``"ac156 ..."``, ``"table file=FILE.csv"`` (docs/theory/scaling.md)
    :param periods: range of the fit (low, high) [s]
    :param component: spectrum of a record, ``"RotD50"``; that of the target if not stated
    :param common: one factor for all records
    """
    options = ["--target", target, *(["--common"] if common else [])]
    if periods:
        options += ["--periods", f"{periods[0]:g}:{periods[1]:g}"]
    if component:
        options += ["--component", component]
    found = _ask("scale", _listed(paths), *options)
    frame = pandas.DataFrame(found.pop("records")).set_index("name")
    frame.attrs = found
    return frame


@dataclass(frozen=True)
class Selection:
    """A suite that :func:`select` picked, as `gurney records select` reports it. With P periods (T* of a
    conditional target is one of them) and N records:

    ``records``: a row for each record, index ``name``, with ``event`` and ``station`` (None where they
    are not stated), ``factor`` and ``misfit``, the root mean square over the periods of ln(factor Sa /
    median). ``periods`` [s], shape (P,). ``spectra``: factor Sa of each record [m/s2], shape (N, P).
    ``median`` [m/s2] and ``sigma`` (of ln Sa) of the target, and the errors ``mean_error`` and
    ``sigma_error`` of the suite's mean and standard deviation of ln Sa, each of shape (P,). ``facts``:
    ``candidates``, ``excluded_by_factor``, ``excluded_by_usable_period``, ``total_error``, ``seed``.
    """

    target: str
    records: pandas.DataFrame = field(repr=False)
    periods: Array = field(repr=False)
    spectra: Array = field(repr=False)
    median: Array = field(repr=False)
    sigma: Array = field(repr=False)
    mean_error: Array = field(repr=False)
    sigma_error: Array = field(repr=False)
    facts: dict[str, Any] = field(repr=False)
    _asked: tuple[Any, ...] = field(repr=False, compare=False)

    def save(self, path: str | os.PathLike[str], overwrite: bool = False) -> None:
        """Writes the list of the suite, as ``-o`` does: ``{"excitation": {"suite": [path]}}`` of a study
        reads it, with the factors.

        :raises InputError: the file exists; a record is in memory: a list names files
        """
        sources, options, _ = self._asked
        if any(isinstance(each, Record) for each in sources):
            raise InputError(f"{os.fspath(path)}: a list names files, and a record in memory has none: "
                             "save it first")
        program.order("records", "select", *map(os.fspath, sources), *options, "-o", os.fspath(path),
                      *(["--overwrite"] if overwrite else []))

    def read(self) -> list[Record]:
        """The records themselves, processed, and scaled by the factors of the list (six digits), in the
        order of ``records``.

        :raises InputError: a file of a flatfile is not in its folder
        """
        sources, options, stated = self._asked
        if "--step" in stated:  # a list has no place for them
            with tempfile.TemporaryDirectory() as folder:
                pool = {each.name: each for each in _all_written(folder, *_paths(sources, folder), *stated)}
            return [pool[name].scaled(by) for name, by in self.records["factor"].items()]
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "selected.csv")
            program.order("records", "select", *_paths(sources, folder), *options, "-o", path)
            return _all_written(folder, path)

    def to_frame(self) -> pandas.DataFrame:
        """Target and suite by period: ``median`` [m/s2], ``sigma``, ``mean_error``, ``sigma_error``, then
        the scaled spectrum of each record [m/s2]; index ``period`` [s]."""
        index = pandas.Index(self.periods, name="period")
        target = {name: getattr(self, name) for name in ("median", "sigma", "mean_error", "sigma_error")}
        return pandas.concat([pandas.DataFrame(target, index),
                              pandas.DataFrame(self.spectra.T, index, self.records.index)], axis=1)

    def _repr_html_(self) -> str:
        html: str = self.records.to_html(float_format="{:.3f}".format, na_rep="")
        return (f"<p>{escape(self.target)}: {len(self.records)} of {self.facts['candidates']} records</p>"
                + html)


def select(sources: Source | Iterable[Source], target: str, *, records: int = 20,
           periods: tuple[float, float] | None = None, component: str | None = None,
           factors: tuple[float, float] | None = None, scaled: bool = True, per_event: int = 0,
           per_station: int = 0, seed: int = 1, unit: str | None = None,
           time_step: float | None = None, steps: Sequence[str] = ()) -> Selection:
    """Records whose scaled spectra have the mean and the variance of a target, such as a conditional
    spectrum, by the method of Jayaram, Lin & Baker (2011); docs/theory/selection.md.

    :param sources: records, folders, patterns, lists, or a flatfile of NGA-West2 by itself
    :param target: ``"conditional magnitude=7 distance_km=10 vs30_m_per_s=400 period_s=1 epsilon=1"``,
        ``"bssa14 ..."``, ``"table file=FILE.csv"``, ``"openquake file=FILE.csv poe=0.02"``,
        ``"disaggregation file=FILE vs30_m_per_s=400"``, or those of :func:`scale`
    :param records: how many, 2 or more
    :param periods: range of the comparison (low, high) [s]; 0.05 to 5 s if not stated
    :param component: spectrum of a record; RotD50 if not stated
    :param factors: allowed range (low, high); 0.25 to 4 if not stated
    :param scaled: False: records as they are
    :param per_event: most records of one earthquake; 0: any number
    :param per_station: most records of one station; 0: any number
    :param unit: of files that do not state it: ``"g"``, ``"m/s2"`` ...
    :param time_step: of files that do not state it [s]
    :param steps: processing steps, ``"high_pass corner_hz=0.1"``
    :returns: :class:`Selection`; what was excluded or is not stated is warned of
    :raises InputError: the target is wrong, or too few records remain
    """
    given = _listed(sources)
    options = ["--target", target, "--records", str(records), "--seed", str(seed), "--per-event",
               str(per_event), "--per-station", str(per_station)]
    for name, span in (("--periods", periods), ("--factors", factors)):
        options += [name, f"{span[0]:.17g}:{span[1]:.17g}"] if span else []
    options += ["--component", component] if component else []
    options += [] if scaled else ["--unscaled"]
    stated = _stated(unit, time_step, steps)
    options += stated
    found = _ask("select", given, *options)
    rows = pandas.DataFrame(found.pop("records")).set_index("name")
    at = pandas.DataFrame(found.pop("periods"))
    spectra = numpy.array(rows.pop("sa_m_per_s2").tolist())
    by_period = {name: at[name].to_numpy() for name in ("sigma", "mean_error", "sigma_error")}
    return Selection(target=found.pop("target"), records=rows, periods=at["period_s"].to_numpy(),
                     spectra=spectra, median=at["median_m_per_s2"].to_numpy(), facts=found,
                     _asked=(given, options, stated), **by_period)


def floor(record: Source, building: str | os.PathLike[str], storey: int | str = "roof") -> Record:
    """The motion of a floor of a building under a ground motion.

    :param building: a name of ``gurney.catalogue("buildings")``, or the path of a building file
    :param storey: 0 (the base) to the number of storeys, ``"roof"``, or the name of a floor
    """
    return _written("floor", record, "--building", os.fspath(building), "--storey", str(storey))


def make(kind: str, **parameters: object) -> Record:
    """A synthetic motion.

    :param kind: of :func:`kinds`, such as ``"ac156"`` or ``"ricker"``
    :param parameters: of that kind, ``period_s=0.5``; each has its unit in its name
    """
    return _written("make", None, kind, *(f"{key}={value}" for key, value in parameters.items()))


def kinds() -> dict[str, Any]:
    """The kinds of synthetic motions, with their parameters, ranges and defaults."""
    return {each.pop("kind"): each for each in program.ask("records", "make", "--list")["kinds"]}


def model(magnitude: float, distance: float, *, vs30: float = 760,
          faulting: str = "unspecified", periods: Sequence[float] = ()) -> pandas.DataFrame:
    """Spectrum of a ground-motion model (BSSA14, RotD50): index ``period`` [s], ``median`` [m/s2],
    standard deviations ``tau``, ``phi``, ``sigma`` of ln; ``attrs`` has ``source`` and ``pgv_m_per_s``.

    :param magnitude: moment magnitude, 3 to 8.5
    :param distance: Joyner-Boore distance, 0 to 400 [km]
    :param vs30: 150 to 1500 [m/s]
    :param faulting: ``"unspecified"``, ``"strike-slip"``, ``"normal"`` or ``"reverse"``
    """
    options = [each for period in periods for each in ("--period", f"{period:g}")]
    found = program.ask("records", "model", "--magnitude", magnitude, "--distance", distance, "--vs30",
                        vs30, "--faulting", faulting, *options)
    frame = pandas.DataFrame(found.pop("sa_m_per_s2")).set_index("period_s")
    frame.index.name = "period"
    frame.attrs = found
    return frame


def _stated(unit: str | None, time_step: float | None, steps: Sequence[str]) -> list[str]:
    options = [] if unit is None else ["--unit", unit]
    options += [] if time_step is None else ["--time-step", f"{time_step:.17g}"]
    return options + [each for step in steps for each in ("--step", step)]


def _listed(sources: Source | Iterable[Source]) -> list[Source]:
    return [sources] if isinstance(sources, (str, os.PathLike, Record)) else list(sources)


def _paths(sources: Iterable[Source], folder: str) -> list[str]:
    """Records in memory become files."""
    paths = []
    for number, source in enumerate(sources):
        if isinstance(source, Record):
            inner = pathlib.Path(folder) / str(number)
            inner.mkdir()
            source.save(inner / f"{source.name.replace('/', '_')}.csv")
            paths.append(str(inner / f"{source.name.replace('/', '_')}.csv"))
        else:
            paths.append(os.fspath(source))
    if not paths:
        raise InputError("no record, file or folder is given")
    return paths


def _ask(command: str, sources: Iterable[Source], *options: str) -> Any:
    with tempfile.TemporaryDirectory() as folder:
        return program.ask("records", command, *_paths(sources, folder), *options)


def _written(command: str, source: Source | None, *options: str) -> Record:
    """The record that a command writes."""
    with tempfile.TemporaryDirectory() as folder:
        given = [] if source is None else _paths([source], folder)
        path = os.path.join(folder, "written.csv")
        program.order("records", command, *given, *options, "-o", path)
        return _read_csv(path)


def _all_written(folder: str, *arguments: str) -> list[Record]:
    """The records that `gurney records convert` writes, in its order."""
    written = program.order("records", "convert", *arguments, "-o", os.path.join(folder, "written"))
    return [_read_csv(path) for path in written.splitlines()]


def _read_csv(path: str) -> Record:
    with open(path, encoding="utf-8") as file:
        lines = file.read().splitlines()
    notes = [line[2:] for line in lines if line.startswith("#")]
    header, *rows = csv.reader(line for line in lines if not line.startswith("#"))
    table = numpy.array(rows, dtype=float)
    axes = [name[0] for name in header[1:]]
    samples = numpy.zeros((len(table), 1 if axes == ["x"] else 3))
    for column, axis in enumerate(axes, start=1):
        samples[:, "xyz".index(axis)] = table[:, column]
    stated: Mapping[str, str] = dict(note.split(": ", 1) for note in notes if ": " in note)
    return Record(stated.get("record", pathlib.Path(path).stem), samples,
                  float(table[-1, 0] - table[0, 0]) / (len(table) - 1),
                  tuple(_DIRECTIONS[axis] for axis in axes), tuple(notes))
