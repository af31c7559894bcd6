"""Groups of an HDF5 file as data frames, and the hash at its end."""

from __future__ import annotations

import hashlib
import io
from typing import Any, BinaryIO

import h5py
import numpy
import pandas

from .errors import DamagedFile

_MARK = b"\ngurney sha256 "
_LINE = len(_MARK) + 64 + 1  # the hash in hexadecimal digits, and the end of the line


def _opened(source: str | bytes) -> BinaryIO:
    return io.BytesIO(source) if isinstance(source, bytes) else open(source, "rb")


def stated_hash(source: str | bytes) -> tuple[str | None, int]:
    """SHA-256 in the last line of the file, and the number of bytes it is of; None: no line."""
    with _opened(source) as file:
        size = file.seek(0, 2)
        file.seek(max(0, size - _LINE))
        line = file.read()
    if len(line) != _LINE or not line.startswith(_MARK):
        return None, size
    return line[len(_MARK):-1].decode("ascii", "replace"), size - _LINE


def verify(source: str | bytes) -> bool:
    """Compares the SHA-256 at the end of a file, or of bytes, with the bytes before it.

    :returns: True; False if the file has no hash, because another program wrote into it
    :raises DamagedFile: a byte differs
    """
    stated, size = stated_hash(source)
    if stated is None:
        return False
    found = hashlib.sha256()
    with _opened(source) as file:
        while size > 0:
            block = file.read(min(size, 1 << 20))
            if not block:
                break
            found.update(block)
            size -= len(block)
    if found.hexdigest() != stated:
        name = source if isinstance(source, str) else "run in memory"
        raise DamagedFile(f"{name}: damaged: its SHA-256 is {found.hexdigest()}, "
                          f"its last line states {stated}")
    return True


def attribute(value: Any) -> Any:
    """An attribute as text, number or list."""
    if isinstance(value, bytes):
        return value.decode()
    if isinstance(value, numpy.ndarray):
        return [attribute(each) for each in value.tolist()]
    return value.item() if isinstance(value, numpy.generic) else value


def values(dataset: h5py.Dataset, rows: Any = slice(None), raw: bool = False) -> Any:
    """The values of a dataset; text is decoded, and a missing value is NaN unless ``raw``."""
    data = dataset[rows] if dataset.shape else dataset[()]
    if h5py.check_string_dtype(dataset.dtype) is not None:
        flat = numpy.asarray(data, dtype=object).ravel()
        codes, names = pandas.factorize(flat)  # each text is decoded once
        texts = numpy.array([name.decode() for name in names] or [""], dtype=object)
        return texts[codes].reshape(numpy.shape(data))
    fill = dataset.attrs.get("_FillValue")
    if raw or fill is None or numpy.isnan(fill).any():
        return data
    data = numpy.array(data, dtype=float)
    data[data == numpy.ravel(fill)[0]] = numpy.nan
    return data


def frame(group: h5py.Group, raw: bool = False) -> pandas.DataFrame:
    """A table of the file. ``attrs["units"]`` and ``attrs["long_name"]`` describe its columns.

    A column with a second dimension becomes one column for each of its entries, ``record_pga.x``.
    """
    columns, units, long_names = {}, {}, {}
    for name, dataset in group.items():
        data = values(dataset, raw=raw)
        if data.ndim > 1:
            entries = values(dataset.dims[1][0])
            parts = {f"{name}.{entry}": data[:, i] for i, entry in enumerate(entries)}
        elif len(data) != _rows(group):
            continue  # the scale of a second dimension
        else:
            parts = {name: data}
        for part, column in parts.items():
            columns[part] = column
            units[part] = attribute(dataset.attrs["units"])
            long_names[part] = attribute(dataset.attrs["long_name"])
    result = pandas.DataFrame(columns)
    result.attrs = {"units": units, "long_name": long_names}
    return result


def _rows(group: h5py.Group) -> int:
    for name in ("row", "run", "key", "variable", "shape"):
        if name in group:
            return len(group[name])
    return len(next(iter(group.values())))
