"""Ground motions and floor motions: read, processed, scaled, generated, as the program has them.

Every function asks `gurney records`. Where a record is asked for, a path, a folder, a pattern
(``"recs/*.AT2"``) or a :class:`Record` may stand. Accelerations are in m/s2, times in s.
"""

from __future__ import annotations

import csv
import os
import pathlib
import tempfile
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, TypeAlias, Union

import numpy
import numpy.typing
import pandas

from . import program
from .errors import InputError

Source: TypeAlias = Union[str, os.PathLike[str], "Record"]
_DIRECTIONS = {"x": "h1", "y": "h2", "z": "vertical"}


@dataclass(frozen=True)
class Record:
    """A record in memory, which :func:`gurney.simulate` takes: ``acceleration`` [m/s2] has the shape
    (samples, 3), or (samples, 1) with x alone; a component that is missing is 0, ``components`` names
    those that are there. ``notes`` says what it was made from, and how it was processed."""

    name: str
    acceleration: numpy.typing.NDArray[numpy.float64] = field(repr=False)
    time_step: float  #: [s]
    components: tuple[str, ...] = ("h1", "h2", "vertical")
    notes: tuple[str, ...] = field(default=(), repr=False)

    @property
    def time(self) -> numpy.typing.NDArray[numpy.float64]:
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
    names = [f"Sa({period:.6g})" for period in at]
    frame = measures(record, names, unit=unit, time_step=time_step, steps=steps)
    frame.index = pandas.Index([float(name[3:-1]) for name in frame.index], name="period")
    return frame.dropna(axis="columns", how="all")


def scale(paths: Iterable[Source], target: str, *, periods: tuple[float, float] | None = None,
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
    found = _ask("scale", list(paths), *options)
    frame = pandas.DataFrame(found.pop("records")).set_index("name")
    frame.attrs = found
    return frame


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
