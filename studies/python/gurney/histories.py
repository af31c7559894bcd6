"""Histories of a run, as an xarray Dataset where xarray is installed."""

from __future__ import annotations

import numbers
from typing import TYPE_CHECKING, Any

import h5py
import numpy

from . import tables
from .errors import Error, InputError, NotInFile, not_in_file, shortened

if TYPE_CHECKING:
    from .results import Results

Variables = dict[str, tuple[tuple[str, ...], Any, dict[str, Any]]]
_AXES = ("x", "y", "z")


def of_run(results: Results, run: int | None = None, item: str | None = None) -> Any:
    """The histories of a run with units; see :meth:`gurney.Results.histories`."""
    if "histories" not in results.tables:
        raise NotInFile(f"{results.path}: no histories are stored; ask for them in the job with "
                        "study.keep.histories = \"all\", or repeat one case: gurney replay")
    group = results._file["histories"]
    read = _of_study if results.kind == "study" else _of_single_run
    variables, coordinates = read(results, group, run)
    if item is not None:
        _select(results, item, variables, coordinates)
    return _dataset(variables, coordinates)


def _chosen(results: Results, run: int | None, known: Any) -> int:
    there = [int(each) for each in known]
    if run is None:
        if len(there) == 1:
            return there[0]
        raise Error(f"{results.path}: which run? Histories are stored of {shortened(there)}")
    if isinstance(run, bool) or not isinstance(run, numbers.Integral):
        raise InputError(f"run = {run!r}: must be a whole number")
    if run not in there:
        raise not_in_file(results.path, "histories of run", run, there)
    return int(run)


def _attributes(dataset: h5py.Dataset) -> dict[str, Any]:
    names = ("units", "long_name", "flag_values", "flag_meanings")
    return {name: tables.attribute(dataset.attrs[name]) for name in names if name in dataset.attrs}


def _of_single_run(results: Results, group: h5py.Group,
                   run: int | None) -> tuple[Variables, Variables]:
    """The samples `offset[i]` to `offset[i] + count[i] - 1`, with the dimensions of the file."""
    row = list(group["run"][:]).index(_chosen(results, run, group["run"][:]))
    samples = slice(int(group["offset"][row]), int(group["offset"][row] + group["count"][row]))
    variables: Variables = {}
    coordinates: Variables = {}
    for name, dataset in group.items():
        dims = tuple(scale[0].name.split("/")[-1] if len(scale) else name
                     for scale in dataset.dims)
        if "run" in dims or name == "run":
            continue
        data = tables.values(dataset, samples if dims[0] == "time" else slice(None), raw=True)
        target = coordinates if dims == (name,) else variables
        target[name] = (dims, data, _attributes(dataset))
    return variables, coordinates


def _of_study(results: Results, group: h5py.Group,
              run: int | None) -> tuple[Variables, Variables]:
    """Rows of one run: items one after the other, `displacement_x` and so on with an axis."""
    runs = group["run"][:]
    run = _chosen(results, run, numpy.unique(runs))
    own = numpy.flatnonzero(runs == run)
    rows = slice(int(own[0]), int(own[-1]) + 1)
    of_item = tables.values(group["item"], rows)
    items = list(dict.fromkeys(of_item))
    places = numpy.array([numpy.flatnonzero(of_item == item) for item in items])
    columns = {name: tables.values(dataset, rows, raw=True)[places].T
               for name, dataset in group.items() if name not in ("row", "run", "item")}
    time = columns.pop("time")
    if not (time == time[:, :1]).all():
        raise Error(f"{results.path}: the items of run {run} have different times")
    coordinates: Variables = {"time": (("time",), time[:, 0], _attributes(group["time"])),
                   "item": (("item",), numpy.array(items, dtype=object), {}),
                   "axis": (("axis",), numpy.array(_AXES, dtype=object), {})}
    variables: Variables = {}
    for name, data in columns.items():
        stem, end = name[:-2], name[-2:]
        if end == "_x" and all(f"{stem}_{axis}" in columns for axis in _AXES):
            data = numpy.stack([columns[f"{stem}_{axis}"] for axis in _AXES], axis=-1)
            about = _attributes(group[name])
            about["long_name"] = about["long_name"].removeprefix("x of the ")
            variables[stem] = (("time", "item", "axis"), data, about)
        elif end[0] != "_" or end[1] not in _AXES:
            variables[name] = (("time", "item"), data, _attributes(group[name]))
    return variables, coordinates


def _select(results: Results, item: str, variables: Variables, coordinates: Variables) -> None:
    """Keeps one item, and drops the dimension."""
    items = list(coordinates["item"][1])
    if item not in items:
        raise not_in_file(results.path, "item", item, items)
    at = items.index(item)
    for group in (variables, coordinates):
        for name, (dims, data, about) in list(group.items()):
            if "item" in dims:
                kept = tuple(dim for dim in dims if dim != "item")
                group[name] = (kept, numpy.take(data, at, dims.index("item")), about)


def _dataset(variables: Variables, coordinates: Variables) -> Any:
    try:
        import xarray
    except ImportError:
        return {name: data for name, (_, data, _) in {**coordinates, **variables}.items()}
    return xarray.Dataset(variables, coordinates)
