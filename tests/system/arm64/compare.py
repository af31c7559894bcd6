"""Compares the demands of two results files of a study, made by programs for different processors.

usage: compare.py FILE OTHER

The same draws and motions to 1e-12, and demands to 1e-9 of their size (or of a millimetre, milliradian, ... where they are
smaller): libraries differ in the last bit of sin and exp, and 20,000 steps of a calm run amplify it by less than 1e3.
"""

import sys

import h5py
import numpy

SAME, CLOSE, SMALL = 1e-12, 1e-9, 1e-3


def numbers(file, group):
    """Columns of numbers by name."""
    return {name: data[:].astype(float) for name, data in file[group].items() if data.dtype.kind in "iuf"}


def worst(one, other, least):
    """Largest relative difference and its column."""
    assert one.keys() == other.keys(), one.keys() ^ other.keys()
    found = (0.0, "")
    for name, values in one.items():
        assert (numpy.isnan(values) == numpy.isnan(other[name])).all(), f"{name}: not known in both"
        size = numpy.maximum(abs(values), least)
        if numpy.isfinite(values).any():
            found = max(found, (float(numpy.nanmax(abs(values - other[name]) / size)), name))
    return found


def main():
    with h5py.File(sys.argv[1]) as here, h5py.File(sys.argv[2]) as there:
        assert here.attrs["cpu_class"] != there.attrs["cpu_class"], "both are of one class of CPU"
        assert (here["runs/outcome"][:] == there["runs/outcome"][:]).all(), "outcomes differ"
        differ = []
        for group, least, limit in (("motions", 0, SAME), ("drawn", 0, SAME), ("items", SMALL, CLOSE)):
            difference, name = worst(numbers(here, group), numbers(there, group), least or sys.float_info.min)
            print(f"{group}: differ by at most {difference:.2g} ({name})")
            if not difference <= limit:
                differ.append(group)
        sys.exit(f"too much: {', '.join(differ)}" if differ else 0)


if __name__ == "__main__":
    main()
